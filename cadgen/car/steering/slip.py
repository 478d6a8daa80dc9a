"""Slip where the car turns: the rim of the drive wheel turns farther than the wheel goes.

With r the travel of the rim and s that of the wheel, ds/dr = p = 1 - slip |tan(beta_w)|
(`cadgen.car.steering.car.pace`).
The cam turns in proportion to r, so steering known by s must be converted to steering by r.
"""

import numpy as np

from cadgen.arrays import Array, gauss_nodes
from cadgen.car.steering.car import Car, pace, wheel_tangent
from cadgen.curves.hermite import quintic_hermite
from cadgen.errors import DesignError

GAUSS_POINTS = 8  # between two nodes of the track, some 12 mm: exact to rounding but where the steering changes sign


def rim_travel(arc: Array, jets: Array, car: Car) -> Array:
    """Travel of the rim at the nodes of a track, shape (n,), mm.

    Args:
        arc: arc length of the track at the nodes, not decreasing, shape (n,), mm.
        jets: tan(beta) of the rod with two derivatives by arc, shape (n, 3).
        car: dimensions, lever and slip of the car.

    Raises:
        DesignError: somewhere the wheel slips so much that it does not get ahead.
    """
    if car.slip == 0:
        return arc
    nodes, weights = gauss_nodes(GAUSS_POINTS)
    half = np.diff(arc)[:, None] / 2
    left = pace(quintic_hermite(arc, jets)(arc[:-1, None] + half * (nodes + 1)), car)
    if not left.min() > 0:
        raise DesignError(
            f"with a slip of {100 * car.slip:g} % for each unit of tan(beta) the drive wheel would not get ahead in "
            f"the tightest turn: lower slip_percent in [as_built], or widen the turn"
        )
    return np.append(0.0, np.cumsum((1 / left @ weights)[:, None] * half))


def by_rim(jets: Array, car: Car) -> Array:
    """Jets of the rod's tan(beta) by the travel of the rim, from those by the travel of the wheel, shape (n, 3).

    Args:
        jets: tan(beta) with its first two derivatives by the travel of the wheel, in mm, shape (n, 3).
        car: dimensions of the car.
    """
    T, T1, T2 = jets.T
    p = pace(T, car)
    wheel, zero = wheel_tangent(T, car), np.tan(car.steering_zero)
    # d tan(beta_w) / dT of the addition theorem.
    turned = car.steering_gain * (1 + zero**2) / (1 - car.steering_gain * T * zero) ** 2
    p1 = -car.slip * np.sign(wheel) * turned * T1
    return np.stack([T, T1 * p, T2 * p**2 + T1 * p * p1], axis=1)
