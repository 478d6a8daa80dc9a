"""Errors of a track by the floor: a car creeps down a slope, and every unevenness turns it a little.

On a slope g a car that goes in direction t creeps by a share of its travel: along t by (g . t), and across, along n,
by (g . n), each with a ratio of its own, since wheels roll along and slide across. The heading is disturbed as a random
walk by arc length; its Karhunen-Loeve expansion (Loeve 1978, sec. 37.5) has the waves sin((k - 1/2) pi s / l).
"""

from math import pi, radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.inference.measurement.models.base import Discrepancy

# Of a workshop's floor and its covering: 2 mm per metre of travel, and 0.005 degrees after the first metre.
CREEP = 2e-3
WALK = radians(0.005) / 1000**0.5  # rad per root of mm
WAVES = 12
NUMBERS = (
    ("creep_along_x_percent", "%"),
    ("creep_along_y_percent", "%"),
    ("creep_across_x_percent", "%"),
    ("creep_across_y_percent", "%"),
)


def floor(place: NDArray[np.complex128], at: NDArray[np.intp], axis: NDArray[np.intp]) -> Discrepancy:
    """Columns of creep and of a disturbed heading.

    Args:
        place: along the track, x + iy, shape (m,), mm.
        at: which place each row shows, shape (n,).
        axis: of each row, 0 for x and 1 for y, shape (n,).
    """
    ahead = np.diff(place)
    step = np.abs(ahead)
    along = ahead / np.where(step > 0, step, 1.0)
    across = 1j * along
    moves = [part * way * step for way in (along, across) for part in (way.real, way.imag)]
    travel, length = np.cumsum(step) - step / 2, float(step.sum())
    order = (np.arange(1, WAVES + 1) - 0.5) * pi
    waves = np.sqrt(2 * length) / order * np.sin(order * travel[:, None] / max(length, 1e-9))
    moves += list((waves * (1j * ahead)[:, None]).T)
    drift = np.vstack([np.zeros(len(moves)), np.cumsum(np.array(moves).T, axis=0)])[at]
    columns: Array = np.where((axis == 0)[:, None], drift.real, drift.imag)
    sigma = np.concatenate([np.full(len(NUMBERS), CREEP), np.full(WAVES, WALK)])
    return Discrepancy("the creep of the car on the floor", columns, sigma, NUMBERS)
