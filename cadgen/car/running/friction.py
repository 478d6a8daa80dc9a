"""Sliding friction of pairs of materials: bands, for tables of friction never agree better than that.

A figure in a table is that of one rig (Blau, The significance and use of the friction coefficient, Tribology
International 34 (2001) 585-591). Tables of sliding friction give, for steel on steel, 0.23 (Wypych, Handbook of Surface
Improvement and Modification, table 11.1) to 0.57 dry and 0.04 to 0.25 greased (drive makers' tables); on aluminium
0.25 to 0.47 dry; on brass 0.44 dry, and 0.19 with grease at rest; on ABS 0.35, on plastics 0.18 to 0.35 dry. The bands
span these and what a workshop adds. Those of acrylic, PLA and POM, and most of the greased ones, are estimates of ours
from the figures for plastics and for greased metals: measure the pair if it matters. A ball bearing turns instead of
sliding; with its seals it holds the cam as friction below 0.02 would, an estimate too.
"""

import re
from enum import StrEnum

from cadgen.cam.followers.kind import RunningSurface


class DiscMaterial(StrEnum):
    """Material of a disc."""

    ALUMINIUM = "aluminium"
    STEEL = "steel"
    BRASS = "brass"
    ACRYLIC = "acrylic"
    PLA = "PLA"
    POM = "POM"


def named_material(stated: str | None) -> DiscMaterial | None:
    """Material that a design's words name, such as steel in `steel C45`; None where they name none that is known.

    Args:
        stated: material as a design states it; None where it does not.
    """
    words = re.findall(r"[^\W\d_]+", (stated or "").lower())
    return next((each for each in DiscMaterial if each.lower() in words), None)


# Least and greatest sliding friction of a steel rod on a disc: dry, and greased.
STEEL_ON: dict[DiscMaterial, tuple[tuple[float, float], tuple[float, float]]] = {
    DiscMaterial.ALUMINIUM: ((0.25, 0.50), (0.05, 0.20)),
    DiscMaterial.STEEL: ((0.20, 0.60), (0.03, 0.16)),
    DiscMaterial.BRASS: ((0.25, 0.45), (0.08, 0.20)),
    DiscMaterial.ACRYLIC: ((0.35, 0.55), (0.15, 0.50)),
    DiscMaterial.PLA: ((0.25, 0.60), (0.08, 0.30)),
    DiscMaterial.POM: ((0.15, 0.35), (0.05, 0.15)),
}
BEARING = (0.0, 0.02)
# Friction of a steel rod on a disc of unknown material, greased and dry. The first is also used for the sentence on
# designs that give no friction at all.
USUAL = (0.05, 0.30)
USUAL_DRY = (0.15, 0.60)


def friction_band(follower: RunningSurface, disc: DiscMaterial | None, *, greased: bool) -> tuple[float, float]:
    """Least and greatest coefficient of sliding friction; `USUAL`, or dry `USUAL_DRY`, for a rod on an unknown disc."""
    if follower == RunningSurface.BALL_BEARING:
        return BEARING
    if disc is None:
        return USUAL if greased else USUAL_DRY
    return STEEL_ON[disc][int(greased)]
