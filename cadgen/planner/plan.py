"""A task planned: the best path of several searches."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.course.course import Course, Gate
from cadgen.errors import DesignError
from cadgen.path.spline import DEGREE
from cadgen.planner.barriers import Clearances, barriers_of
from cadgen.planner.basis import Basis
from cadgen.planner.gates import Passing, is_exact, planned_place
from cadgen.planner.near import Near
from cadgen.planner.rows import Rows
from cadgen.planner.search import Path, Search, fixed_ends
from cadgen.planner.start import End, fitted_to, smooth_path
from cadgen.planner.task import Task, Vehicle

_SPAN = 320.0  # mm of the path to a span of the B-spline
_SPANS_A_GATE = 4
_LEAST_SPANS, _MOST_SPANS = 16, 110
_KEPT = 2e-3  # of a limit, or mm of a gate or a clearance: what a search may leave
_SHIFT = 0.15  # of the distance between the points of a route, by which another search begins elsewhere


@dataclass(frozen=True, eq=False)
class Plan:
    """A planned path.

    Attributes:
        path: path with its cost and its limits.
        task: what was planned.
    """

    path: Path
    task: Task

    @property
    def missed(self) -> dict[str, float]:
        """Limits that are not kept, with most of what each is beyond."""
        return {
            name: most for name, most in self.path.violated.items() if most > _KEPT and name not in ("fast", "slow")
        }


def planned_end(gate: Gate | None, vehicle: Vehicle) -> End:
    """Start or finish as the place of the planned point; free where the gate is not met exactly.

    A place of another point of the car fixes that of the planned point only together with a heading.
    """
    if gate is None:
        return End()
    x, y = planned_place(gate, vehicle)
    if not is_exact(gate) or (gate.heading is None and np.hypot(x, y) > 0):
        return End(heading=gate.heading)
    place = np.array(gate.place.points[0])
    if gate.heading is None:
        return End(place)
    ahead = np.array([np.cos(gate.heading), np.sin(gate.heading)])
    return End(place - x * ahead - y * np.array([-ahead[1], ahead[0]]), gate.heading)


def route_of(course: Course, vehicle: Vehicle) -> Array:
    """Places of the planned point, from gate to gate, shape (k, 2), mm.

    Raises:
        DesignError: the course has neither gates nor a finish.
    """
    gates = [gate for gate in (course.start, *course.gates, course.finish) if gate is not None]
    middles = np.array([np.mean(gate.place.points, axis=0) for gate in gates])
    if len(middles) < 2:
        raise DesignError("the course has nothing to drive to: add [[course.gates]] or [course.finish]")
    ends = planned_end(course.start, vehicle), planned_end(course.finish, vehicle)
    along = np.gradient(middles, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    for number, gate in enumerate(gates):
        ahead = along[number]
        if gate.heading is not None:
            ahead = np.array([np.cos(gate.heading), np.sin(gate.heading)])
        x, y = planned_place(gate, vehicle)
        middles[number] -= x * ahead + y * np.array([-ahead[1], ahead[0]])
    for number, end in ((0, ends[0]), (-1, ends[1])):
        if end.place is not None:
            middles[number] = end.place
    return np.asarray(middles)


def plan(task: Task, *, seeds: int = 1, report: Callable[[str], None] | None = None) -> Plan:
    """Plan a task from scratch, or near to the track that it names.

    Args:
        task: what is planned; its gates are passed in their order.
        seeds: number of searches, each from another path; the best one counts.
        report: function that is called with a few words as the plan gets better.

    Raises:
        DesignError: the course has nothing to drive to.
    """
    best: Plan | None = None
    for seed in range(seeds):
        found = _one(task, seed, report)
        if best is None or _merit(found) < _merit(best):
            best = found
    assert best is not None
    return best


def _merit(found: Plan) -> tuple[float, float]:
    return sum(found.missed.values()), found.path.cost.cost


def _one(task: Task, seed: int, report: Callable[[str], None] | None) -> Plan:
    vehicle, course = task.vehicle, task.course
    start, finish = planned_end(course.start, vehicle), planned_end(course.finish, vehicle)
    if task.near is None:
        route = route_of(course, vehicle)
        length = float(np.linalg.norm(np.diff(route, axis=0), axis=1).sum())
        spans = max(length / _SPAN, _SPANS_A_GATE * (len(route) - 1))
        basis = Basis(int(np.clip(spans, _LEAST_SPANS, _MOST_SPANS)) + DEGREE)
        if seed:
            random = np.random.default_rng(seed)
            shift = random.normal(size=route.shape) * _SHIFT * length / len(route)
            shift[[0, -1]] = 0.0
            route = route + shift
        points = smooth_path(basis, route, start, finish)
    else:
        points, basis, start, finish = _from_track(task.near, vehicle)
    search = Search(task, basis, _fixed(basis, start, finish), _course_rows(task, basis, finish))
    words = None if report is None else (lambda cost: report(f"end of the run {cost:.0f} mm"))
    return Plan(search.best(points, words), task)


def _from_track(track: Array, vehicle: Vehicle) -> tuple[Array, Basis, End, End]:
    """Control points of the path of a track, and its ends."""
    along = np.gradient(track, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    planned = track + vehicle.path_offset * np.stack([along[:, 1], -along[:, 0]], axis=1)
    length = float(np.linalg.norm(np.diff(planned, axis=0), axis=1).sum())
    basis = Basis(int(np.clip(length / _SPAN, _LEAST_SPANS, _MOST_SPANS)) + DEGREE)
    points = fitted_to(basis, planned)
    heading = [float(np.arctan2(leg[1], leg[0])) for leg in (points[1] - points[0], points[-1] - points[-2])]
    return points, basis, End(points[0], heading[0]), End(points[-1], heading[1])


def _fixed(basis: Basis, start: End, finish: End):  # type: ignore[no-untyped-def]
    return fixed_ends(basis.count, (start.place is not None, start.heading), (finish.place is not None, finish.heading))


def _course_rows(task: Task, basis: Basis, finish: End) -> Callable[[Array], list[Rows]]:
    course, vehicle = task.course, task.vehicle
    last = course.finish if course.finish is not None and finish.place is None else None
    passing = Passing(basis, course.gates, last, vehicle)
    clearances = Clearances(basis, vehicle, barriers_of(course, vehicle.body))
    near = None if task.near is None else Near(basis, vehicle.path_offset, task.near, task.within)

    def rows(points: Array) -> list[Rows]:
        return [*passing.rows(points), *clearances.rows(points), *(near.rows(points) if near else [])]

    return rows


def with_margin(task: Task, more: float) -> Task:
    """The task with a greater margin, mm."""
    return replace(task, course=replace(task.course, margin=task.course.margin + more))
