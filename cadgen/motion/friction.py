"""Sliding friction of pairs of materials: bands, for tables of friction never agree better than that.

A figure in a table is that of one rig (Blau, The significance and use of the friction coefficient, Tribology
International 34 (2001) 585-591). The bands span what the usual tables give for sliding at low speed and load: those of
technical handbooks that The Engineering ToolBox collects (steel on steel 0.42 to 0.57 dry, 0.03 to 0.16 greased; on
aluminium 0.47 dry; on brass 0.44 dry, 0.19 static greased; on acrylic 0.4 to 0.5 dry or wet), Wypych, Handbook of
Surface Improvement and Modification, table 11.1 (steel on steel 0.23, on aluminium 0.25, on ABS 0.35), makers' tables
of POM on steel (0.15 to 0.35), and tests of printed PLA on steel (Hanon et al., Int. J. Adv. Manuf. Technol. 108 (2020)
553-570: 0.25 to 0.55 with the direction of printing). A ball bearing turns instead of sliding; with its seals it holds
the cam as friction below 0.02 would.
"""

from typing import Literal

FollowerMaterial = Literal["steel", "ball_bearing"]
DiscMaterial = Literal["aluminium", "steel", "brass", "acrylic", "PLA", "POM"]

# Least and greatest sliding friction of a steel rod on a disc: dry, and greased.
STEEL_ON: dict[DiscMaterial, tuple[tuple[float, float], tuple[float, float]]] = {
    "aluminium": ((0.25, 0.50), (0.05, 0.20)),
    "steel": ((0.20, 0.60), (0.03, 0.16)),
    "brass": ((0.25, 0.45), (0.08, 0.20)),
    "acrylic": ((0.35, 0.55), (0.15, 0.50)),
    "PLA": ((0.25, 0.60), (0.08, 0.30)),
    "POM": ((0.15, 0.35), (0.05, 0.15)),
}
BEARING = (0.0, 0.02)
# What a rod that slides may have whatever it is made of and greased or not, and what is told where nothing is given.
USUAL = (0.05, 0.30)
USUAL_DRY = (0.15, 0.60)


def friction_band(follower: FollowerMaterial, disc: DiscMaterial | None, *, greased: bool) -> tuple[float, float]:
    """Least and greatest sliding friction of a pair; `USUAL`, or dry `USUAL_DRY`, for a rod on an unknown disc."""
    if follower == "ball_bearing":
        return BEARING
    if disc is None:
        return USUAL if greased else USUAL_DRY
    return STEEL_ON[disc][int(greased)]
