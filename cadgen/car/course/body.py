"""The car in plan view, in its own frame (origin at the fork axis, x ahead, y to the left, mm), and its poses."""

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from math import hypot

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.course.layout import CarPoint, Point
from cadgen.car.steering import Car


class PartName(StrEnum):
    """Part of the car that can be nearest to an obstacle."""

    OUTLINE = "outline"
    FRONT_WHEEL = "front wheel"
    DRIVE_WHEEL = "drive wheel"
    IDLE_WHEEL = "idle wheel"


@dataclass(frozen=True, kw_only=True)
class CarWheel:
    """A wheel as seen from above: a rectangle, as long as its diameter.

    Attributes:
        name: which wheel.
        centre: where it touches the floor, mm.
        radius: of the wheel, mm.
        width: of the wheel, mm.
        steered: whether it turns with the fork.
    """

    name: PartName
    centre: Point
    radius: float
    width: float
    steered: bool = False


@dataclass(frozen=True, kw_only=True)
class CarBody:
    """Outline and wheels of a car.

    Attributes:
        corners: corners of the outline in order, shape of a simple polygon, mm; empty if the design gives no outline.
        clearance: height under the body, mm; what is lower can pass under it, but not under a wheel.
        wheels: the three wheels.
    """

    corners: tuple[Point, ...]
    clearance: float
    wheels: tuple[CarWheel, ...]

    @cached_property
    def radius(self) -> float:
        """Greatest distance of a point of the car from its fork axis, mm."""
        wheels = (hypot(*wheel.centre) + hypot(wheel.radius, wheel.width / 2) for wheel in self.wheels)
        return max([*(hypot(*corner) for corner in self.corners), *wheels])

    @cached_property
    def steered_radius(self) -> float:
        """Greatest distance of a point of the front wheel from there, mm."""
        return max((hypot(wheel.radius, wheel.width / 2) for wheel in self.wheels if wheel.steered), default=0.0)


def place_of(point: CarPoint, car: Car) -> Point:
    """Place of a named point in the car's frame, mm."""
    rear = -car.wheelbase
    places: dict[CarPoint, Point] = {
        CarPoint.FORK: (0.0, 0.0),
        CarPoint.MIDDLE: (rear, (car.drive_wheel_offset - car.idle_wheel_offset) / 2),
        CarPoint.DRIVE_WHEEL: (rear, car.drive_wheel_offset),
        CarPoint.IDLE_WHEEL: (rear, -car.idle_wheel_offset),
    }
    return places[point]


Complex = NDArray[np.complex128]


@dataclass(frozen=True, kw_only=True)
class RunPoses:
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

    def part(self, start: int, stop: int) -> "RunPoses":
        """Poses from a number up to another, which is left out."""
        some = slice(start, stop)
        return RunPoses(
            fork=self.fork[some], heading=self.heading[some], steering=self.steering[some], travel=self.travel[some]
        )

    def track(self, point: Point) -> Complex:
        """Positions x + iy of a point of the car, shape (n,), mm.

        Args:
            point: place in the car's frame, mm.
        """
        return np.asarray(self.fork + complex(*point) * self.ahead)

    def at(self, place: Array) -> "RunPoses":
        """Poses at places along the run.

        Args:
            place: number of the pose, whole or between two, shape (m,).
        """
        left = np.clip(np.floor(place).astype(int), 0, len(self) - 2)
        share = place - left

        def between(values: Array) -> Array:
            return np.asarray(values[left] + share * (values[left + 1] - values[left]))

        fork = between(self.fork.real) + 1j * between(self.fork.imag)
        return RunPoses(
            fork=fork, heading=between(self.heading), steering=between(self.steering), travel=between(self.travel)
        )

    def reach(self, radius: float, steered: float) -> Array:
        """Upper bound of the way of any point of the car since the start, shape (n,), mm; never decreases.

        Args:
            radius: greatest distance of a point of the car from its fork axis, mm.
            steered: greatest distance of a point of the front wheel from there, mm.
        """
        moved = np.abs(np.diff(self.fork)) + radius * np.abs(np.diff(self.heading))
        moved += steered * np.abs(np.diff(self.steering))
        return np.concatenate([[0.0], np.cumsum(moved)])
