"""Speed at which a three-wheeled car tips over on its path.

Let v be the speed of the drive wheel, κ the curvature of its track, and κ' its slope. Let c = (a, l) be the way from
the drive wheel to the centre of gravity, ahead and to the left. Then the acceleration of that centre is v² A:
    A = (-κ² a - κ' l, κ + κ' a - κ² l).
Gravity and inertia together meet the floor at c - (h v² / g) A, h being the height of the centre of gravity. The car
stands as long as that place lies within the triangle of its wheels: for the edge with the unit normal n inwards and the
distance d of c from it, as long as v² h (n A) <= g d. Springs, slopes, gyroscopic moments and gusts are left aside.
"""

from dataclasses import dataclass
from math import inf

import numpy as np

from cadgen.arrays import Array

GRAVITY = 9810.0  # mm/s²


@dataclass(frozen=True, slots=True, kw_only=True)
class Tipping:
    """Limit of the speed of a car by tipping.

    Attributes:
        speed: greatest speed of the drive wheel without tipping, mm/s; infinite on a straight path.
        arc: place on the track of the drive wheel, mm.
        edge: number of the edge of the triangle over which the car tips there, from 0.
        room: distance of the centre of gravity from the nearest edge at rest, mm; negative for a car that does not
            stand.
    """

    speed: float
    arc: float
    edge: int
    room: float


def tipping(arc: Array, curvature: Array, slope: Array, wheels: Array, centre: tuple[float, float, float]) -> Tipping:
    """Speed at which a car tips over.

    Args:
        arc: arc lengths of the track of the drive wheel, mm, shape (n,).
        curvature: curvature there, 1/mm, positive to the left, shape (n,).
        slope: derivative of the curvature by arc length, 1/mm², shape (n,).
        wheels: where the wheels touch the floor, ahead and to the left of the drive wheel, mm, shape (3, 2); an edge
            leads from each to the next.
        centre: centre of gravity ahead and to the left of the drive wheel, and its height, mm.
    """
    ahead, left, height = centre
    acceleration = np.column_stack(
        [-(curvature**2) * ahead - slope * left, curvature + slope * ahead - curvature**2 * left]
    )
    sides = np.roll(wheels, -1, axis=0) - wheels
    normals = np.column_stack([-sides[:, 1], sides[:, 0]]) / np.hypot(*sides.T)[:, None]
    if sides[0, 0] * sides[1, 1] < sides[0, 1] * sides[1, 0]:  # the wheels run clockwise
        normals = -normals
    room = ((np.array([ahead, left]) - wheels) * normals).sum(axis=1)
    outwards = acceleration @ normals.T * height
    with np.errstate(divide="ignore"):
        squares = np.where(outwards > 0, GRAVITY * np.maximum(room, 0.0) / np.maximum(outwards, 1e-300), inf)
    if room.min() <= 0:
        return Tipping(speed=0.0, arc=float(arc[0]), edge=int(room.argmin()), room=float(room.min()))
    place, edge = np.unravel_index(int(squares.argmin()), squares.shape)
    return Tipping(
        speed=float(np.sqrt(squares[place, edge])), arc=float(arc[place]), edge=int(edge), room=float(room.min())
    )
