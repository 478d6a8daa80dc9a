"""The nominal car of a design, ready to be varied: its cam rolled once, and held against its course."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.course.approach import nearest_point
from cadgen.car.course.body import RunPoses, place_of
from cadgen.car.course.judge import Passage, turned_by
from cadgen.car.course.layout import Gate
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import STEPS, turns_of
from cadgen.car.running.mechanics import Mechanics
from cadgen.curves.closed import ClosedCurve
from cadgen.deviations.first_order import Expansion
from cadgen.inference.monte_carlo.cars import Cars, Poses, nominal_cars
from cadgen.inference.monte_carlo.course_margins import ClearanceItem, Complex, FinishItem, GateItem
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.course import CourseRun, OnCourse

_OUTLINE_STEP = 0.06  # mm; rolling errs by 0.01 um of lift
_WINDOW = 600.0  # mm of the planned track to either side of a gate, in which a car may be early or late
_STEP = 10.0  # mm between its points
_EDGE = "course.field"  # key of the field's edge


class VariedCar(Protocol):
    """Car of a design with its comparison under play, of which many cars differ."""

    @property
    def steering(self) -> PathMotion:
        """Motion that its profile is cut for."""

    @property
    def comparison(self) -> PlayComparison | None:
        """Comparison of the profile with the plain one under play."""

    @property
    def course(self) -> OnCourse | None:
        """Course with the car that is to keep it."""

    @property
    def wheel_radius(self) -> float:
        """Radius of the drive wheel, mm; infinite where it is not known."""

    @property
    def expansion(self) -> Expansion:
        """How disc, frame and rod grow with heat."""

    @property
    def shaft_orders(self) -> Sequence[float]:
        """Turns of each shaft of the train for one of the camshaft, from the camshaft on."""

    @property
    def gate_width(self) -> float | None:
        """Width of the gates at the waypoints, mm; None where the design states none."""

    @property
    def waypoints(self) -> Array:
        """Cam angles at which the car passes the waypoints after the first, rad, shape (n,)."""


def cars_of(
    use: VariedCar,
    cut: ClosedCurve,
    stations: Sequence[int],
    mechanics: Mechanics | None,
    play: float,
    grid: int = STEPS,
) -> Cars:
    """The nominal car of a design, ready to be varied.

    Args:
        use: car that all are copies of, with its comparison under play.
        cut: curve that its cam is cut to, mm.
        stations: steps of the run, `STEPS` to a turn that is begun, at which poses are wanted, in order; the last is
            the end of the run.
        mechanics: friction and drag of the nominal car; None if the rod slides freely.
        play: return error of the nominal car, rad.
        grid: cam angles of a turn on which the cars are integrated.
    """
    assert use.comparison is not None
    task = use.comparison.task
    return nominal_cars(
        task.as_built.roll_new(cut, task.follower, np.linspace(0.0, TURN, grid, endpoint=False), _OUTLINE_STEP),
        task.follower,
        task.car,
        task.length,
        use.steering,
        task.planned(),
        wheel_radius=use.wheel_radius,
        play=play,
        stations=stations,
        mechanics=mechanics,
        expansion=use.expansion,
        orders=use.shaft_orders,
    )


def watched_cars(use: VariedCar, cut: ClosedCurve) -> Cars:
    """The nominal car of a design, with what it must keep of its course, and the gates at waypoints that it states.

    Args:
        use: car with its comparison under play.
        cut: curve that its cam is cut to, mm.
    """
    assert use.comparison is not None
    task = use.comparison.task
    mechanics = None if task.mechanics is None else task.mechanics.nominal
    cars = cars_of(use, cut, gate_steps(use), mechanics, use.comparison.chosen.play)
    return cars if use.course is None else watching(cars, use.course.planned)


def gate_steps(use: VariedCar) -> list[int]:
    """Steps of the run at which the car passes a gate at a waypoint, for which the design states a width; and its end.

    On a closed path the car passes its waypoints, and its start, on every lap.

    Args:
        use: car that the cam steers.
    """
    stop = use.steering.blend_start
    last = STEPS * turns_of(stop)
    if use.gate_width is None:
        return [last]
    motor = use.waypoints
    steps = np.unique(np.rint(motor[motor < stop] / stop * last).astype(int))
    return [*steps[(steps > 0) & (steps < last)].tolist(), last]


def watching(cars: Cars, planned: CourseRun) -> Cars:
    """Nominal car with stations at the gates, the nearest obstacles, the edge and the finish, besides its own.

    A finish of which only the place is given, or a line, on which no car that differs ends, is none of them.

    Args:
        cars: nominal car; its last station is the end of the run.
        planned: planned run of its design, held against the course.
    """
    wheel = planned.run.drive_wheel[:, 0] + 1j * planned.run.drive_wheel[:, 1]
    turned = np.exp(-1j * planned.run.heading[0])
    driven, course = planned.driven, planned.on.course
    watched: list[tuple[int, GateItem | ClearanceItem | FinishItem]] = []

    def local(points: Complex) -> Complex:
        """Points on the floor in the frame of the start."""
        return np.asarray((points - wheel[0]) * turned)

    for passage in driven.passages:
        watched.append((round(passage.place), _gate(planned, passage, local)))
    near = [(obstacle.key, obstacle.shape, there) for obstacle, there in driven.approaches]
    if course.edge is not None and driven.edge is not None:
        near.append((_EDGE, course.edge, driven.edge))
    for key, shape, there in near:
        point, away = nearest_point(planned.poses, planned.on.body, shape, there, edge=key == _EDGE)
        room = there.clearance - course.margin
        watch = ClearanceItem(0, local(np.array([point])), complex(away * turned), room, key)
        watched.append((round(there.place), watch))
    if counts_finish(planned):
        watched.append((len(planned.poses) - 1, _finish(planned, local)))

    motor = planned.run.motor[[number for number, _ in watched]]
    stations = np.union1d(cars.stations, motor)
    heading, position = np.empty((1, len(stations))), np.empty((1, len(stations)), dtype=complex)
    for (number, _), at in zip(watched, np.searchsorted(stations, motor), strict=True):
        heading[0, at] = planned.run.heading[number] - planned.run.heading[0]
        position[0, at] = (wheel[number] - wheel[0]) * turned
    own = np.searchsorted(stations, cars.stations)
    heading[0, own], position[0, own] = cars.planned.heading[0], cars.planned.position[0]
    return replace(
        cars,
        stations=stations,
        planned=Poses(heading, position),
        end=int(own[-1]),
        items=tuple(
            replace(watch, station=int(at))
            for (_, watch), at in zip(watched, np.searchsorted(stations, motor), strict=True)
        ),
    )


def _gate(planned: CourseRun, passage: Passage, local: Callable[[Complex], Complex]) -> GateItem:
    gate, poses, number = passage.gate, planned.poses, round(passage.place)
    middle = poses.travel[number]
    around = np.searchsorted(poses.travel, np.arange(middle - _WINDOW, middle + _WINDOW, _STEP))
    around = np.unique(np.clip(around, 0, len(poses) - 1))
    return GateItem(
        0,
        local(np.array([complex(*point) for point in gate.place.points])),
        gate.place.reach,
        local(poses.track(place_of(gate.point, planned.on.car))[around]),
        _heading(gate, poses, number),
        not passage.fault,
        gate.key,
    )


def counts_finish(planned: CourseRun) -> bool:
    """Whether cars are held against the finish: a disc of a given radius in which the run is to end.

    Args:
        planned: planned run of the design, held against the course.
    """
    finish = planned.driven.finish
    return finish is not None and len(finish.wanted.place.points) == 1 and finish.wanted.asked


def _finish(planned: CourseRun, local: Callable[[Complex], Complex]) -> FinishItem:
    gate, poses = planned.on.course.finish, planned.poses
    assert gate is not None
    end = poses.track(place_of(gate.point, planned.on.car))[-1]
    middle, stop = local(np.array([complex(*gate.place.points[0]), end]))
    return FinishItem(0, np.array([middle]), gate.place.reach, complex(stop), _heading(gate, poses, -1), gate.key)


def _heading(gate: Gate, poses: RunPoses, number: int) -> tuple[float, float] | None:
    """Angle from the heading wanted to that of a pose, and the greatest allowed, rad; None if any will do."""
    if gate.heading is None:
        return None
    return float(turned_by(poses.heading[number], gate.heading)), gate.heading_tolerance
