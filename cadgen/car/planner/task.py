"""A task of the planner: a car, its limits, and a course. Lengths in mm, angles in rad."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import inf

from cadgen.arrays import Array
from cadgen.car.course.body import CarBody
from cadgen.car.course.layout import Course, Draw
from cadgen.car.steering import Car


@dataclass(frozen=True, kw_only=True)
class Vehicle:
    """The car as far as a plan depends on it.

    Attributes:
        car: dimensions in plan view.
        body: outline and wheels.
        path_offset: how far the planned path runs to the right of the drive wheel, mm.
        base_radius: distance of the camshaft from the fork axis, mm.
        faces: distances of the carrying planes of the disc from the fork axis, the nearer one first, mm.
        spread: by how much the return error of a car may differ from the one its cam is cut for, rad.
        travel: travel of the drive wheel for one turn of the cam, mm; None where it follows from the path's length.
        most_length: greatest length of the drive wheel's track, mm.
        path_turn: share of a turn of the cam that the whole path takes, where the travel follows from its length.
        end: share of the path at which the run ends.
        closed: whether the path is a lap that ends as it starts; then its course has the start as its finish, too.
    """

    car: Car
    body: CarBody
    path_offset: float
    base_radius: float
    faces: tuple[float, float]
    spread: float
    travel: float | None = None
    most_length: float = inf
    path_turn: float = 1.0
    end: float = 1.0
    closed: bool = False


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Limits of the steering and the cam.

    Attributes:
        left: greatest curvature of the drive wheel's track to the left, 1/mm.
        right: the same to the right, 1/mm.
        rise: greatest pressure angle while the lift rises, rad.
        fall: greatest pressure angle while it falls, rad.
        convex_radius: least convex radius of the rod axis's path about the camshaft, mm.
        step: greatest difference of the rod axis's distance from the camshaft between the end of the run and its start,
            mm: the closing blend must come over it.
        slope: greatest slope of the curvature by arc length, 1/mm^2.
        bend: greatest second derivative of the curvature by arc length, 1/mm^3.
        valley: greatest second derivative of the lift by cam angle where it curves upwards, mm: in a valley the lift
            that no profile gives back with play grows with it.
    """

    left: float
    right: float
    rise: float
    fall: float
    convex_radius: float
    step: float = inf
    slope: float = inf
    bend: float = inf
    valley: float = inf


@dataclass(frozen=True, kw_only=True)
class Task:
    """A path to be planned.

    Attributes:
        vehicle: the car.
        limits: what its steering and its cam hold.
        course: what it must pass and must not touch. Its start is where the path starts.
        near: track of the drive wheel to stay near to, points shape (k, 2), mm, close together; None for a plan from
            scratch.
        within: how far the drive wheel's track may be from `near`, mm.
        gate_margin: distance to keep from the edges of the gates, mm.
        spare: distance to keep besides from gates' edges and from obstacles where it costs little, by their keys, mm.
        draw: spacings at which obstacles are kept clear of, too; None where the course has one spacing.
    """

    vehicle: Vehicle
    limits: Limits
    course: Course
    near: Array | None = None
    within: float = inf
    gate_margin: float = 0.0
    spare: Mapping[str, float] = field(default_factory=dict)
    draw: Draw | None = None
