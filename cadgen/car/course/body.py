"""The car in plan view, in its own frame: origin at the fork axis, x ahead, y to the left, mm."""

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from math import hypot

from cadgen.car.course.course import Point
from cadgen.car.course.names import CarPoint
from cadgen.car.steering import Car


class PartName(StrEnum):
    """Part of the car that can be nearest to a thing."""

    OUTLINE = "outline"
    FRONT_WHEEL = "front wheel"
    DRIVE_WHEEL = "drive wheel"
    IDLE_WHEEL = "idle wheel"


@dataclass(frozen=True, kw_only=True)
class Wheel:
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
class Body:
    """Outline and wheels of a car.

    Attributes:
        corners: corners of the outline in order, shape of a simple polygon, mm; empty if the design gives no outline.
        clearance: height under the body, mm; what is lower can pass under it, but not under a wheel.
        wheels: the three wheels.
    """

    corners: tuple[Point, ...]
    clearance: float
    wheels: tuple[Wheel, ...]

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
