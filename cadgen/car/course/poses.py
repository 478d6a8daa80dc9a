"""A run of the car as poses, close enough together that straight lines between them err by microns."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.course.course import Point

Complex = NDArray[np.complex128]


@dataclass(frozen=True, kw_only=True)
class Poses:
    """Poses of the car along a run; n of them. Between two of them everything changes evenly.

    Attributes:
        fork: position x + iy of the fork axis, shape (n,), mm.
        heading: direction of travel, shape (n,), rad, not wrapped.
        steering: angle of the front wheel to the left of straight ahead, shape (n,), rad.
        travel: travel of the drive wheel from the start, shape (n,), mm.
    """

    fork: Complex
    heading: Array
    steering: Array
    travel: Array

    def __len__(self) -> int:
        return len(self.heading)

    @cached_property
    def ahead(self) -> Complex:
        """Directions of travel as x + iy of length 1, shape (n,)."""
        return np.asarray(np.exp(1j * self.heading))

    def part(self, start: int, stop: int) -> "Poses":
        """Poses from a number up to another, which is left out."""
        some = slice(start, stop)
        return Poses(
            fork=self.fork[some], heading=self.heading[some], steering=self.steering[some], travel=self.travel[some]
        )

    def track(self, point: Point) -> Complex:
        """Positions x + iy of a point of the car, shape (n,), mm.

        Args:
            point: place in the car's frame, mm.
        """
        return np.asarray(self.fork + complex(*point) * self.ahead)

    def at(self, place: Array) -> "Poses":
        """Poses at places along the run.

        Args:
            place: number of the pose, whole or between two, shape (m,).
        """
        left = np.clip(np.floor(place).astype(int), 0, len(self) - 2)
        share = place - left

        def between(values: Array) -> Array:
            return np.asarray(values[left] + share * (values[left + 1] - values[left]))

        fork = between(self.fork.real) + 1j * between(self.fork.imag)
        return Poses(
            fork=fork, heading=between(self.heading), steering=between(self.steering), travel=between(self.travel)
        )

    def reach(self, radius: float, steered: float) -> Array:
        """How far any point of the car has moved at most since the start, shape (n,), mm; never decreases.

        Args:
            radius: greatest distance of a point of the car from its fork axis, mm.
            steered: greatest distance of a point of the front wheel from there, mm.
        """
        moved = np.abs(np.diff(self.fork)) + radius * np.abs(np.diff(self.heading))
        moved += steered * np.abs(np.diff(self.steering))
        return np.concatenate([[0.0], np.cumsum(moved)])
