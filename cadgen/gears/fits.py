"""Joints of a wheel and a shaft: the free angle that a key or a D-flat leaves, and clearances of fits by name.

**Key.** It goes from one wall of its groove to the other, by the clearance c, and passes the force on where shaft and
hub meet, at half the shaft's diameter d: the wheel turns freely by c / (d / 2). A key of 25 um of clearance on a shaft
of 8 mm has 0.36 degrees.

**D-flat.** The shaft's radius is R, its flat lies f from its axis, and across flat and far side the bore is wider by c.
Turned by phi, the flat's end, at the polar angle arccos(f / R) from the flat's normal, comes to R cos(arccos(f / R) -
phi); the shaft gives way by as much as the bore leaves, so it may come to f + c. To either side therefore
    phi = arccos(f / R) - arccos((f + c) / R),
nearly c / sqrt(R^2 - f^2): the lever is half the flat's width, much shorter than a key's.

**Fits** stand in `fit_table`.
"""

from math import acos

from cadgen.errors import DesignError
from cadgen.gears.fit_table import AWAY, GROOVES, STEPS, zones_of
from cadgen.gears.tolerances import standard_tolerance


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
            f"a D-shaft of {diameter:g} mm, {across:g} mm across its flat, turns round in a bore that leaves it "
            f"{clearance * 1e3:g} µm: give less clearance or a deeper flat"
        )
    return 2 * (acos(flat / radius) - acos((flat + clearance) / radius))


def clearance(fit: str, size: float) -> tuple[float, float]:
    """Least and greatest clearance of a fit, mm; what would be tight is 0.

    Args:
        fit: such as `H7/g6`.
        size: nominal, mm.

    Raises:
        DesignError: not a fit of this table, or a size beyond it.
    """
    hole, hole_grade, shaft, shaft_grade = zones_of(fit, size)
    step = next(number for number, most in enumerate(STEPS) if size <= most)
    width, own = (float(standard_tolerance(size, grade)) * 1e3 for grade in (hole_grade, shaft_grade))
    if f"{hole}{hole_grade}" in GROOVES:
        upper = float(GROOVES[f"{hole}{hole_grade}"][step])
        low, high = upper - width, upper
    elif hole == "JS":
        low, high = -width / 2, width / 2
    else:
        low = float(AWAY[hole.lower()][step])
        high = low + width
    if shaft == "js":
        bottom, top = -own / 2, own / 2
    else:
        top = -float(AWAY[shaft][step])
        bottom = top - own
    return max(low - top, 0.0) / 1e3, max(high - bottom, 0.0) / 1e3
