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
from collections.abc import Collection
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


# Words, grades (EN, ISO, GB, AISI) and trade names of each material in small letters; Chinese ones may stand in a word.
NAMES: dict[DiscMaterial, str] = {
    DiscMaterial.ALUMINIUM: "aluminium aluminum dural duralumin almg3 almgsi1 almg4.5mn alcu4mg1 alznmgcu1.5 "
    "2014 2017 2024 5052 5083 5754 6005 6060 6061 6063 6082 7020 7050 7075 2a12 6a02 7a04 铝 鋁",
    DiscMaterial.STEEL: "steel stainless inox c15 c35 c45 c45e c60 s45c s235 s235jr s275 s355 s355j2 st37 st52 q195 "
    "q235 q235a q235b q345 q355 20cr 40cr gcr15 100cr6 16mncr5 20mncr5 20crmnti 42crmo4 34crnimo6 90mnv8 cr12mov "
    "sus303 sus304 sus316 1020 1045 4140 4340 303 304 316 316l 1.0503 1.1191 1.4301 1.4305 1.4404 1.7131 1.7225 钢 鋼",
    DiscMaterial.BRASS: "brass ms58 cuzn37 cuzn39pb3 cuzn40pb2 cw508l cw614n cw617n c360 h59 h62 h68 hpb59-1 黄铜 黃銅",
    DiscMaterial.ACRYLIC: "acrylic pmma plexiglas plexiglass perspex 亚克力 有机玻璃",
    DiscMaterial.PLA: "pla 聚乳酸",
    DiscMaterial.POM: "pom pom-c pom-h acetal delrin 聚甲醛 赛钢",
}
_OTHERS = ("bronze", "青铜", "铝铜", "钢化")  # whose names have one of these metals in them
_WORD = re.compile(r"[^\W_]+(?:[-.][^\W_]+)*")
# What may stand beside a grade that is a mere number, which else is a length: the standard, the temper and the stock.
_BESIDE = re.compile(r"en|aw|aisi|sae|gb|din|t\d+|h\d+|plate|sheet|bar|rod")


def named_material(stated: str | None) -> DiscMaterial | None:
    """Material that a design's words name, such as steel in `steel C45`; None where they name none, or several.

    Args:
        stated: material as a design states it; None where it does not.
    """
    text = (stated or "").lower()
    if any(other in text for other in _OTHERS):
        return None
    found, left = set[DiscMaterial](), text
    names = [(name, material) for material, known in NAMES.items() for name in known.split()]
    for name, material in sorted(names, key=lambda each: -len(each[0])):
        if not name.isascii() and name in left:  # 赛钢 is no 钢
            found.add(material)
            left = left.replace(name, " ")
    all_names = {name for name, _ in names}
    words = [part for word in _WORD.findall(left) for part in dict.fromkeys([word, *_parts(word, all_names)])]
    found |= {material for name, material in names if name in words and not name.isdigit()}
    if not found and all(word.isdigit() or "-" in word or _BESIDE.fullmatch(word) for word in words):
        found = {material for name, material in names if name in words}
    return found.pop() if len(found) == 1 else None


def _parts(word: str, names: Collection[str]) -> list[str]:
    """Parts of a word with hyphens that is a grade, as of en-aw-6082; none of a date, or of steel-free."""
    parts = word.split("-")
    numbers = sum(part.isdigit() for part in parts)
    grade = all(part.isdigit() or part in names or _BESIDE.fullmatch(part) for part in parts)
    return parts if grade and numbers <= 1 else []


def material_by_name(stated: object) -> object:
    """Material in place of words that name it; anything else as it is, for the list of what is known.

    Args:
        stated: value of a key.
    """
    return named_material(stated) or stated if isinstance(stated, str) else stated


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
