"""Names and units of columns as people write them, in English, German and Chinese.

A column of a kind of data is called by its quantity and its unit, such as `x_mm`. A header may call it otherwise:
`X [m]`, `pos_x (cm)`, `凸轮转角/度`. Here is which quantity a name means, and what its numbers are to be multiplied by.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

# Unit of the columns -> units that can stand in its place, with their factors.
_UNITS: dict[str, dict[str, float]] = {
    "mm": {
        **dict.fromkeys(("mm", "millimeter", "millimetre", "millimeters", "millimetres", "毫米"), 1.0),
        **dict.fromkeys(("cm", "centimeter", "centimetre", "centimeters", "centimetres", "厘米"), 10.0),
        **dict.fromkeys(("m", "meter", "metre", "meters", "metres", "米"), 1000.0),
        **dict.fromkeys(("um", "µm", "μm", "micron", "microns", "微米"), 1e-3),
        **dict.fromkeys(("in", "inch", "inches", "英寸", "zoll", '"', "″", "pouce", "pouces"), 25.4),
        **dict.fromkeys(("thou", "mil", "mils"), 0.0254),
        "dm": 100.0,
        "ft": 304.8,
    },
    "deg": {
        **dict.fromkeys(("deg", "°", "degree", "degrees", "度", "Grad", "degré", "degrés"), 1.0),
        **dict.fromkeys(("rad", "radian", "radians", "弧度"), 57.29577951308232),
        **dict.fromkeys(("rev", "turn", "turns", "revolutions", "圈", "umdrehungen", "U", "Umdr"), 360.0),
        **dict.fromkeys(("gon", "gons", "gradian", "gradians", "grads"), 0.9),
    },
    "N": {"N": 1.0, "kN": 1000.0, **dict.fromkeys(("lbf", "lb"), 4.4482216152605)},
    "Nm": {**dict.fromkeys(("Nm", "N·m", "N m"), 1.0), **dict.fromkeys(("Nmm", "N·mm", "mNm"), 1e-3)},
    "s": {**dict.fromkeys(("s", "sec", "second", "seconds", "秒"), 1.0), "ms": 1e-3, "min": 60.0},
}
_ALL = {unit: (base, factor) for base, units in _UNITS.items() for unit, factor in units.items()}
# Other names of quantities, as `plain` writes them.
_QUANTITIES: dict[str, tuple[str, ...]] = {
    "camangle": (
        *("camshaftangle", "angleofcam", "cam", "theta", "θ", "angle", "rotation", "nockenwinkel", "winkel"),
        *(
            "drehwinkel",
            "nocke",
            "nocken",
            "nockenwelle",
            "nockenwellenwinkel",
            "winkelnocken",
            "winkelnockenwelle",
            "phi",
            "φ",
            "ϕ",
        ),
        *("凸轮转角", "凸轮角度", "凸轮角", "转角", "角度"),
    ),
    "motorangle": (
        *("motor", "motorrotation", "motorposition", "motorpos", "driveangle", "angleofmotor", "motorwinkel"),
        *("motorposition", "winkelmotor", "motorwelle", "电机转角", "电机角度", "电机角", "电机位置"),
    ),
    "inputangle": ("input", "eingang", "eingangswinkel", "输入", "输入角", "输入转角", "输入角度"),
    "outputangle": ("output", "ausgang", "ausgangswinkel", "输出", "输出角", "输出转角", "输出角度"),
    "outputtorque": ("torque", "load", "moment", "drehmoment", "last", "转矩", "扭矩", "力矩", "负载"),
    "t": ("time", "timestamp", "zeit", "时间"),
    "x": ("xpos", "posx", "xposition", "positionx", "xcoord", "xcoordinate", "xwert", "x坐标", "坐标x"),
    "y": ("ypos", "posy", "yposition", "positiony", "ycoord", "ycoordinate", "ywert", "y坐标", "坐标y"),
    "lift": (
        *("stroke", "dial", "dialindicator", "indicator", "hub", "messuhr"),
        *("升程", "行程", "百分表", "千分表"),
    ),
    "tooth": ("toothno", "toothnumber", "zahn", "zahnnr", "齿", "齿号"),
    "flank": ("side", "flanke", "齿面"),
    "pitch": ("singlepitch", "pitchdeviation", "einzelteilung", "einzelteilungsabweichung", "单齿距", "单个齿距偏差"),
    "index": ("cumulativepitch", "accumulatedpitch", "summenteilung", "累积齿距"),
    "rolllength": ("lengthofroll", "wälzlänge", "wälzweg", "展开长度"),
    "profile": ("profiledeviation", "profilabweichung", "齿廓偏差"),
    "helix": ("helixdeviation", "leaddeviation", "flankenlinienabweichung", "螺旋线偏差"),
    "direction": ("dir", "richtung", "方向"),
    "run": (
        *("runno", "runnumber", "runid", "trial", "lauf", "versuch", "fahrt", "messung", "essai"),
        *("次数", "试验", "运行", "试验序号", "试验号"),
    ),
}
_WIDE = str.maketrans("（）［］【】／", "()[][]/")
_ALSO_WORDS = ("in", "m", "ft")  # of languages, or letters, which in a sentence are no units
# A word that may be a unit, not behind a number, or a sign of inches behind a name.
_WORD = re.compile(
    r"(?P<word>(?<![^\W\u4e00-\u9fff])(?<!\.)(?<!\d )(?<!\d-)[^\W\d_\u4e00-\u9fff]+(?![^\W\u4e00-\u9fff]|-)"
    r"|毫米|英寸|厘米|微米)"
    r'|(?<=[^\W\d_])\s*(?P<sign>["″])\s*(?:[,;\t|)]|$)'
)
_DENIED = re.compile(
    r"(\b(not|no|never|non|nicht|keine?n?|from|was|were|without|ohne|statt|pas|aus|instead of)\s+((in|en|the|den)\s+)?"
    r"|(不是|并非|而非|非|不用|由|从)\s*)$",
    re.I,
)
_OF_LIFT = re.compile(r"(\b(lifts?|strokes?|hub)\s*(in|[:\[(])?|(升程|行程)(的?单位)?[为是:：(（]?)\s*$", re.I)
_MEANT = {other: quantity for quantity, others in _QUANTITIES.items() for other in others}
TIMES = ("t", "seconds")
# Cells of a point that was lost, in small letters.
MISSING = frozenset(
    (
        *("", "nan", "na", "n/a", "null", "none", "missing", "lost", "?", "*", "-", "--", "---", "----", "–", "—"),
        *("#n/a", "#na", "#nv", "#div/0!", "#value!", "#wert!", "#num!", "#zahl!", "#ref!", "#bezug!"),
    )
)
# Columns beside positions that say nothing of the cam.
IDLE = ("z", "no", "nr", "number", "point", "points", "id", "index", "i", "n", "name", "comment", "序号", "点号", "")
BARE = ("run", "direction", "tooth", "flank", "zone", *IDLE)  # quantities that may have no unit
# Words that a column of directions may have, beside its own.
_FORWARD = ("forward", "forwards", "fwd", "f", "+", "+1", "1", "vor", "vorwärts", "hin", "正", "正转", "正向")
_REVERSE = ("reverse", "rev", "r", "backward", "back", "-", "-1", "zurück", "rück", "rückwärts", "反", "反转", "反向")
DIRECTIONS = {**dict.fromkeys(_FORWARD, "forward"), **dict.fromkeys(_REVERSE, "reverse")}


# Words for the flank of a tooth.
_LEFT = ("left", "l", "lf", "links", "linke", "左", "左齿面")
_RIGHT = ("right", "r", "rf", "rechts", "rechte", "右", "右齿面")
FLANKS = {**dict.fromkeys(_LEFT, "left"), **dict.fromkeys(_RIGHT, "right")}
WORDS = (DIRECTIONS, FLANKS)


@dataclass(frozen=True)
class ColumnName:
    """A name of a column, taken apart.

    Attributes:
        quantity: as `plain` writes it, other names of the same quantity brought to one.
        unit: as the file has it; empty if none.
    """

    quantity: str
    unit: str

    def factor(self, base: str) -> float | None:
        """Factor to a unit of the columns; 1 where the file has none, None where it is of another quantity."""
        if not self.unit:
            return 1.0
        found, asked = unit_of(self.unit), unit_of(base)
        return found[1] / asked[1] if found and asked and found[0] == asked[0] else None


def unit_of(text: str) -> tuple[str, float] | None:
    """Unit of the columns that a unit can stand for, and its factor; None if the text is no unit."""
    return _ALL.get(text.strip().lower()) or _ALL.get(text.strip())


def heading(name: str) -> ColumnName:
    """Take a name such as `Pos X (cm)` apart into its quantity and its unit."""
    text = name.strip().translate(_WIDE)
    if bracket := re.fullmatch(r"(.+?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]", text):
        return ColumnName(_quantity(bracket[1]), bracket[2])
    if (humps := re.fullmatch(r"([a-z]\w*?)([A-Z][a-z]+)", text)) and unit_of(humps[2]):
        return ColumnName(_quantity(humps[1]), humps[2])
    match = re.fullmatch(r"(.+?)\s*[/,]\s*(\S+)", text)
    match = match or re.fullmatch(r"(.+?)\s+in\s+(\S+)", text) or re.fullmatch(r"(.+)[_\s](\S+)", text)
    if match and unit_of(match[2]):
        return ColumnName(_quantity(match[1]), match[2])
    return ColumnName(_quantity(text), "")


def other_length(sentences: Sequence[str]) -> tuple[int, str] | None:
    """First sentence that says another unit of length than mm, counted from 1, and its word; None if none does.

    What stands behind a number is a size, such as that of a roller, and no unit of what a table holds. A unit that is
    denied, as in `not inches`, is none; where several are left, that of the lift counts, and else all of them.

    Args:
        sentences: titles and remarks of a table.
    """
    said = [
        (number, word, factor, bool(_OF_LIFT.search(before)), denied(before))
        for number, text in enumerate(sentences, 1)
        for before, word, factor in _lengths(text)
    ]
    meant = [each for each in said if not each[-1]]
    meant = [each for each in meant if each[-2]] or meant
    if not meant:  # mm, and that it is not, leaves what it is
        meant = [(number, f"not {word}", 0.0, lift, no) for number, word, factor, lift, no in said if factor == 1.0]
    return next(((number, word) for number, word, factor, _, _ in meant if factor != 1.0), None)


def denied(before: str) -> bool:
    """Whether the words before a unit deny it, as in `not inches` or `converted from inches`.

    Args:
        before: text that ends where the unit begins.
    """
    return _DENIED.search(before) is not None


def _lengths(text: str) -> Iterator[tuple[str, str, float]]:
    """Units of length in a sentence: text before each, its word, its factor to mm."""
    plain = re.sub(r'"([^"]*)"', r"\1", text)
    for match in _WORD.finditer(plain):
        word = match["word"] or match["sign"]
        found = unit_of(word)
        if found and found[0] == "mm" and word.lower() not in _ALSO_WORDS:
            yield plain[: match.start()], word, found[1]


def _quantity(text: str) -> str:
    plain = re.sub(r"[\s_.\-]+", "", text).lower()
    return _MEANT.get(plain, plain)
