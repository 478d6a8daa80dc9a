"""Bodies of a car as solid cylinders, and the gaps between them."""

from dataclasses import dataclass
from math import hypot
from typing import Protocol

import numpy as np

from cadgen.arrays import Array

_STEPS = 400  # of the projections at most
_STILL = 1e-7  # mm; a step shorter than this ends them
_PARALLEL = 1e-9


class Convex(Protocol):
    """Convex body, by the point of it that is nearest to another."""

    @property
    def centre(self) -> tuple[float, float, float]:
        """A point in it, mm."""

    def nearest(self, point: Array) -> Array:
        """Point of the body that is nearest to a point, mm, shape (3,).

        Args:
            point: point, mm, shape (3,).
        """


@dataclass(frozen=True, slots=True, kw_only=True)
class SolidCylinder:
    """A solid cylinder at its place in the car.

    Attributes:
        name: what it is, for people.
        centre: middle of its axis (x, y, z), mm.
        axis: direction of its axis, a unit vector.
        radius: radius, mm.
        half: half of its length, mm.
    """

    name: str
    centre: tuple[float, float, float]
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    radius: float
    half: float

    def nearest(self, point: Array) -> Array:
        """Point of the body that is nearest to a point, mm, shape (3,).

        Args:
            point: point, mm, shape (3,).
        """
        axis, off = np.asarray(self.axis), point - np.asarray(self.centre)
        along = float(off @ axis)
        across = off - along * axis
        far = float(np.sqrt(across @ across))
        if far > self.radius:
            across *= self.radius / far
        found: Array = np.asarray(self.centre) + min(max(along, -self.half), self.half) * axis + across
        return found


def gap(one: SolidCylinder, other: SolidCylinder) -> float:
    """Distance between two bodies, mm: exact for parallel axes, and there negative by the depth of an overlap.

    Bodies of other directions that overlap have a gap of 0.

    Args:
        one: body.
        other: body.
    """
    if abs(abs(float(np.dot(one.axis, other.axis))) - 1) < _PARALLEL:
        return _parallel_gap(one, other)
    return convex_gap(one, other)


def convex_gap(one: Convex, other: Convex) -> float:
    """Distance between two convex bodies, mm; 0 for bodies that overlap.

    It is the least of ½ |x - P(x)|² over the points x of the first body, with P the nearest point of the second: a
    convex problem, solved by projected gradient steps with momentum (Nesterov).

    Args:
        one: body.
        other: body.
    """
    point = one.nearest(np.asarray(other.centre, dtype=float))
    ahead, weight = point, 1.0
    for _ in range(_STEPS):
        found = one.nearest(other.nearest(ahead))
        moved = found - point
        grown = (1 + np.sqrt(1 + 4 * weight**2)) / 2
        # Momentum that points back uphill is dropped.
        if float((ahead - found) @ moved) > 0:
            grown = 1.0
        ahead = found + (weight - 1) / grown * moved if grown > 1 else found
        point, weight = found, grown
        if float(np.sqrt(moved @ moved)) < _STILL:
            break
    off = point - other.nearest(point)
    return float(np.sqrt(off @ off))


def _parallel_gap(one: SolidCylinder, other: SolidCylinder) -> float:
    axis, off = np.asarray(one.axis), np.asarray(one.centre) - np.asarray(other.centre)
    along = float(off @ axis)
    across = off - along * axis
    radial = float(np.sqrt(across @ across)) - one.radius - other.radius
    lengthwise = abs(along) - one.half - other.half
    if radial > 0 and lengthwise > 0:
        return hypot(radial, lengthwise)
    return max(radial, lengthwise)
