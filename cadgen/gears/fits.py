"""Fits by name (ISO 286-1 and -2), their clearances, and the free angle that a key or a D-flat leaves.

In a fit such as H7/g6 the hole or groove comes first, the shaft or key second. The letter says how far the zone keeps
from the nominal size, the number how wide it is (IT grade, `tolerances.standard_tolerance`). Table 2 of ISO 286-1 gives
the distances of d to h, and those of the holes D to H are the same on the other side; JS and js lie evenly about the
size; N9 and P9 are the grooves of tight keys (DIN 6885). m6 is that of dowel pins (ISO 8734). Sizes go up to 50 mm.

**Key.** It goes from one wall of its groove to the other, by the clearance c, and passes the force on where shaft and
hub meet, at half the shaft's diameter d: the wheel turns freely by c / (d / 2). A key of 25 um of clearance on a shaft
of 8 mm has 0.36 degrees.

**D-flat.** The shaft's radius is R, its flat lies f from its axis, and across flat and far side the bore is wider by c.
Turned by phi, the flat's end, at the polar angle arccos(f / R) from the flat's normal, comes to R cos(arccos(f / R) -
phi); the shaft gives way by as much as the bore leaves, so it may come to f + c. To either side therefore
    phi = arccos(f / R) - arccos((f + c) / R),
nearly c / sqrt(R^2 - f^2): the lever is half the flat's width, much shorter than a key's.

The module is light to import: every design file is held against the table.
"""

import re
from math import acos

from cadgen.errors import DesignError, brief

STEPS = (3.0, 6.0, 10.0, 18.0, 30.0, 50.0)  # upper limits of the steps of sizes, mm
# How far the zone of a clearance fit keeps from the nominal size, um.
AWAY: dict[str, tuple[int, ...]] = {
    "d": (20, 30, 40, 50, 65, 80),
    "e": (14, 20, 25, 32, 40, 50),
    "f": (6, 10, 13, 16, 20, 25),
    "g": (2, 4, 5, 6, 7, 9),
    "h": (0, 0, 0, 0, 0, 0),
}
# Upper deviation of a tight groove or bore, um.
TIGHT: dict[str, tuple[int, ...]] = {
    "N9": (-4, 0, 0, 0, 0, 0),
    "P9": (-6, -12, -15, -18, -22, -26),
    "P7": (-6, -8, -9, -11, -14, -17),
}
# Lower deviation of a shaft that is thicker than its nominal size, um.
THICK: dict[str, tuple[int, ...]] = {"m6": (2, 4, 6, 7, 8, 9)}
GRADES = range(3, 13)
_FIT = re.compile(r"([A-Z]{1,2})(\d{1,2})\s*/\s*([a-z]{1,2})(\d{1,2})")


def zones_of(fit: str, size: float | None = None) -> tuple[str, int, str, int]:
    """Hole and shaft of a fit, each as its letter and its grade.

    Args:
        fit: such as `H7/g6`.
        size: nominal, mm, if it is known.

    Raises:
        DesignError: not a fit of this table, or a size beyond it.
    """
    if size is not None and size > STEPS[-1]:
        raise DesignError(
            'the fit "{fit}" is for a size of {size:g} mm, and the table ends at {most:g} mm',
            fit=brief(fit),
            size=size,
            most=STEPS[-1],
        )
    match = _FIT.fullmatch(fit.strip())
    if match is not None:
        hole, hole_grade, shaft, shaft_grade = match.group(1), int(match.group(2)), match.group(3), int(match.group(4))
        known = hole.lower() in AWAY or hole == "JS" or f"{hole}{hole_grade}" in TIGHT
        known = known and (shaft in AWAY or shaft == "js" or f"{shaft}{shaft_grade}" in THICK)
        if known and {hole_grade, shaft_grade} <= set(GRADES):
            return hole, hole_grade, shaft, shaft_grade
    raise DesignError(
        'the fit "{fit}" is not in the table: give a hole of {holes} or JS (N9 or P9 for a groove, P7 to be pressed '
        "on) and a shaft of {shafts} or js (m6 for a dowel pin), with grades {finest} to {coarsest}, such as H7/g6",
        fit=brief(fit),
        holes=", ".join(letter.upper() for letter in AWAY),
        shafts=", ".join(AWAY),
        finest=GRADES[0],
        coarsest=GRADES[-1],
    )


def key_play(clearance: float, diameter: float) -> float:
    """Free angle of a keyed wheel, rad; clearance of the key in its groove and the shaft's diameter in mm.

    Args:
        clearance: clearance of the key in its groove, mm.
        diameter: diameter of the shaft, mm.
    """
    return clearance / (diameter / 2)


def flat_play(clearance: float, diameter: float, across: float) -> float:
    """Free angle of a wheel on a D-shaft, from one side to the other, rad.

    Args:
        clearance: of the shaft across flat and far side, mm.
        diameter: of the shaft, mm.
        across: from its flat to its far side, mm.

    Raises:
        DesignError: so much that the shaft turns round.
    """
    radius, flat = diameter / 2, across - diameter / 2
    if flat + clearance >= radius:
        raise DesignError(
            "a D-shaft of {diameter:g} mm, {across:g} mm across its flat, turns round in a bore that leaves it "
            "{clearance:g} µm: give less clearance or a deeper flat",
            diameter=diameter,
            across=across,
            clearance=clearance * 1e3,
        )
    return 2 * (acos(flat / radius) - acos((flat + clearance) / radius))


def deviations(fit: str, size: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Lower and upper deviation of the hole of a fit, then of its shaft, mm.

    Args:
        fit: such as `H7/g6`.
        size: nominal, mm.

    Raises:
        DesignError: not a fit of this table, or a size beyond it.
    """
    from cadgen.gears.tolerances import standard_tolerance  # loads numpy, which the table alone does without

    hole, hole_grade, shaft, shaft_grade = zones_of(fit, size)
    step = next(number for number, most in enumerate(STEPS) if size <= most)
    width, own = (float(standard_tolerance(size, grade)) * 1e3 for grade in (hole_grade, shaft_grade))
    if f"{hole}{hole_grade}" in TIGHT:
        upper = float(TIGHT[f"{hole}{hole_grade}"][step])
        low, high = upper - width, upper
    elif hole == "JS":
        low, high = -width / 2, width / 2
    else:
        low = float(AWAY[hole.lower()][step])
        high = low + width
    if shaft == "js":
        bottom, top = -own / 2, own / 2
    elif f"{shaft}{shaft_grade}" in THICK:
        bottom = float(THICK[f"{shaft}{shaft_grade}"][step])
        top = bottom + own
    else:
        top = -float(AWAY[shaft][step])
        bottom = top - own
    return (low / 1e3, high / 1e3), (bottom / 1e3, top / 1e3)


def clearance(fit: str, size: float) -> tuple[float, float]:
    """Least and greatest clearance of a fit, mm; what would be tight is 0.

    Args:
        fit: such as `H7/g6`.
        size: nominal, mm.

    Raises:
        DesignError: not a fit of this table, or a size beyond it.
    """
    (low, high), (bottom, top) = deviations(fit, size)
    return max(low - top, 0.0), max(high - bottom, 0.0)


def runs(fit: str, size: float) -> bool:
    """Whether hole and shaft of a fit turn on each other at every size within their limits.

    Args:
        fit: such as `F8/h6`.
        size: nominal, mm.

    Raises:
        DesignError: not a fit of this table, or a size beyond it.
    """
    (low, _), (_, top) = deviations(fit, size)
    return low >= top - 1e-9
