"""Fits by name, ISO 286-1 and -2: light, for every design file is held against them.

In a fit such as H7/g6 the hole or groove comes first, the shaft or key second. The letter says how far the zone keeps
from the nominal size, the number how wide it is (IT grade, `tolerances.standard_tolerance`). Table 2 of ISO 286-1 gives
the distances of d to h, and those of the holes D to H are the same on the other side; JS and js lie evenly about the
size; N9 and P9 are the grooves of tight keys (DIN 6885). Sizes go up to 50 mm.
"""

import re

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
# Upper deviation of a tight groove, um.
GROOVES: dict[str, tuple[int, ...]] = {"N9": (-4, 0, 0, 0, 0, 0), "P9": (-6, -12, -15, -18, -22, -26)}
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
            f'the fit "{brief(fit)}" is for a size of {size:g} mm, and the table ends at {STEPS[-1]:g} mm'
        )
    match = _FIT.fullmatch(fit.strip())
    if match is not None:
        hole, hole_grade, shaft, shaft_grade = match.group(1), int(match.group(2)), match.group(3), int(match.group(4))
        known = hole.lower() in AWAY or hole == "JS" or f"{hole}{hole_grade}" in GROOVES
        if known and (shaft in AWAY or shaft == "js") and {hole_grade, shaft_grade} <= set(GRADES):
            return hole, hole_grade, shaft, shaft_grade
    raise DesignError(
        f'the fit "{brief(fit)}" is not in the table: give a hole of {", ".join(letter.upper() for letter in AWAY)} or '
        f"JS (N9 or P9 for a groove) and a shaft of {', '.join(AWAY)} or js, with grades {GRADES[0]} to {GRADES[-1]}, "
        f"such as H7/g6"
    )
