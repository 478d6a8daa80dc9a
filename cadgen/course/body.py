"""The car in plan view, in its own frame: origin at the fork axis, x ahead, y to the left, mm."""

from dataclasses import dataclass
from typing import Literal

from cadgen.course.course import Point
from cadgen.course.names import CarPoint
from cadgen.steering.car import Car

PartName = Literal["outline", "front wheel", "drive wheel", "idle wheel"]


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


def place_of(point: CarPoint, car: Car) -> Point:
    """Place of a named point in the car's frame, mm."""
    rear = -car.wheelbase
    places: dict[CarPoint, Point] = {
        "fork": (0.0, 0.0),
        "middle": (rear, (car.drive_wheel_offset - car.idle_wheel_offset) / 2),
        "drive_wheel": (rear, car.drive_wheel_offset),
        "idle_wheel": (rear, -car.idle_wheel_offset),
    }
    return places[point]
