"""Diameter of the smallest circle about the camshaft that holds the disc: what it needs of room and of stock."""

import numpy as np

from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure

_STEP = 0.1  # mm between points: the radius then errs by 1e-5 mm


def _diameter(evaluated: Evaluated) -> float:
    return 2 * float(np.linalg.norm(evaluated.plan.curve.outline(_STEP).points, axis=1).max())


DISC_DIAMETER = Figure(
    code="disc_diameter_mm",
    meaning="diameter of the circle about the camshaft that holds the disc",
    of=_diameter,
    resolution=0.01,
)
