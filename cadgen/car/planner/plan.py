"""A task planned: the best path of several searches."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from cadgen.arrays import Array
from cadgen.car.path.spline import DEGREE
from cadgen.car.planner.barriers import Clearances, barriers_of
from cadgen.car.planner.basis import Basis
from cadgen.car.planner.gates import Passing
from cadgen.car.planner.near import Near
from cadgen.car.planner.programme import Fixed
from cadgen.car.planner.route import planned_end, route_of
from cadgen.car.planner.rows import Limit, LimitKind, Rows
from cadgen.car.planner.search import Path, Search, fixed_ends, fixed_start
from cadgen.car.planner.start import End, fitted_to, smooth_path
from cadgen.car.planner.task import Task, Vehicle

_SPAN = 320.0  # mm of the path to a span of the B-spline
_SPANS_A_STOP = 4
_LEAST_SPANS, _MOST_SPANS = 16, 110
# Of the path that a search begins with. Through sharp corners of the route the usual one has turns that no step widens;
# a calmer one misses the gates, and is drawn to them.
_CALMNESS = (1.0, 10.0, 40.0)
# Limits whose violation is not by such a turn.
_STANDING = (LimitKind.CLEARANCE, LimitKind.FIELD)
UNEVEN = (LimitKind.FAST, LimitKind.SLOW)  # limits that serve the search alone
_LEFT, _LEFT_MM = 2e-3, 0.01  # of a limit or rad, and mm of a gate or a clearance: what a search may leave
_IN_MM = (LimitKind.GATE, LimitKind.CLEARANCE, LimitKind.FIELD)


def left(limit: Limit) -> float:
    """Most of a violation that a search may leave, in the unit of the limit: a share, rad or mm.

    Of a gate and a clearance that is less than is kept from their edges for what happens between the places.
    """
    return _LEFT_MM if limit.kind in _IN_MM else _LEFT


@dataclass(frozen=True, eq=False)
class Plan:
    """A planned path.

    Attributes:
        path: path with its cost and its limits.
        task: what was planned.
        begin: control points that the search began with, shape (n, 2), mm.
    """

    path: Path
    task: Task
    begin: Array

    @property
    def missed(self) -> dict[Limit, float]:
        """Limits that are not kept, with most of what each is beyond."""
        violated = self.path.violated.items()
        return {
            limit: most
            for limit, most in violated
            if most > left(limit) and limit.kind not in UNEVEN and not limit.spare
        }


def plan(
    task: Task,
    *,
    seeds: int = 1,
    begin: Array | None = None,
    report: Callable[[str], None] | None = None,
    map_with: Callable[..., Iterable[Plan]] | None = None,
) -> Plan:
    """Plan a task from scratch, near to the track that it names, or on from a path.

    Args:
        task: what is planned; its gates are passed in their order.
        seeds: number of searches, each from another path; the best one counts.
        begin: control points to go on from, shape (n, 2), mm; then there is one search.
        report: function that is called with a few words as the plan gets better; not where searches run elsewhere.
        map_with: function like the built-in `map` that runs several searches, such as that of a pool; the plan does
            not depend on it.

    Raises:
        DesignError: the course has nothing to drive to.
    """
    if seeds == 1 or begin is not None or task.near is not None:
        return _searched(task, begin, report, 0)
    if map_with is None:
        return min(map(partial(_searched, task, None, report), range(seeds)), key=_merit)
    return min(map_with(partial(_searched, task, None, None), range(seeds)), key=_merit)


def _merit(candidate: Plan) -> tuple[float, float]:
    return sum(candidate.missed.values()), candidate.path.cost.cost


def _searched(task: Task, begin: Array | None, report: Callable[[str], None] | None, seed: int) -> Plan:
    vehicle, course = task.vehicle, task.course
    start, finish = planned_end(course.start, vehicle), planned_end(course.finish, vehicle)
    if begin is not None:
        basis, begins = Basis(len(begin), vehicle.closed), [begin]
    elif task.near is None:
        route = route_of(course, vehicle, seed)
        basis = _basis(max(route.length / _SPAN, _SPANS_A_STOP * (route.stops - 1)), vehicle)
        first = seed % len(_CALMNESS)
        begins = [
            smooth_path(basis, route.places, route.is_stop, start, finish, calmness)
            for calmness in (*_CALMNESS[first:], *_CALMNESS[:first])
        ]
    else:
        points, basis = _from_track(task.near, vehicle)
        begins = [points]
    if task.near is not None:
        start, finish = _ends_of(basis, begins[0])
    search, plans = _search(task, basis, start, finish), []
    words = None if report is None else (lambda cost: report(f"end of the run {cost:.0f} mm"))
    for points in begins:
        plans.append(Plan(search.best(points, words), task, points))
        if all(limit.kind in _STANDING for limit in plans[-1].missed):
            break
    return min(plans, key=_merit)


def search_of(task: Task, count: int, loose: Limit | None = None) -> Search:
    """The search of a task from scratch with some number of control points.

    Args:
        task: what is planned.
        count: number of control points.
        loose: limit that may be violated at little cost; None if there is none.
    """
    vehicle, course = task.vehicle, task.course
    ends = planned_end(course.start, vehicle), planned_end(course.finish, vehicle)
    return replace(_search(task, Basis(count, vehicle.closed), *ends), loose=loose)


def _search(task: Task, basis: Basis, start: End, finish: End) -> Search:
    return Search(task, basis, _fixed(basis, start, finish), _course_rows(task, basis, start, finish))


def _basis(spans: float, vehicle: Vehicle) -> Basis:
    count = int(np.clip(spans, _LEAST_SPANS, _MOST_SPANS))
    return Basis(count if vehicle.closed else count + DEGREE, vehicle.closed)


def _from_track(track: Array, vehicle: Vehicle) -> tuple[Array, Basis]:
    """Control points of the path of a track."""
    along = np.gradient(track, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    planned = track + vehicle.path_offset * np.stack([along[:, 1], -along[:, 0]], axis=1)
    length = float(np.linalg.norm(np.diff(planned, axis=0), axis=1).sum())
    basis = _basis(length / _SPAN, vehicle)
    return fitted_to(basis, planned), basis


def _ends_of(basis: Basis, points: Array) -> tuple[End, End]:
    """Start and finish of a path as they are."""
    place, ahead = basis.at(np.array([0.0, basis.stop])).jets(points)[:2]
    start, finish = (End(place[k], float(np.arctan2(ahead[k, 1], ahead[k, 0]))) for k in (0, 1))
    return start, finish


def _fixed(basis: Basis, start: End, finish: End) -> Fixed:
    ends = [(end.place is not None, end.heading) for end in (start, finish)]
    return fixed_start(basis, ends[0]) if basis.closed else fixed_ends(basis.count, *ends)


def _course_rows(task: Task, basis: Basis, start: End, finish: End) -> Callable[[Array], list[Rows]]:
    course, vehicle = task.course, task.vehicle
    first = course.start if start.place is None else None
    last = course.finish if finish.place is None and not basis.closed else None
    passing = Passing(basis, course.gates, first, last, vehicle, task.gate_margin, task.spare)
    clearances = Clearances(basis, vehicle, barriers_of(course, vehicle.body, task.draw), task.spare)
    near = None if task.near is None else Near(basis, vehicle.path_offset, task.near, task.within)

    def rows(points: Array) -> list[Rows]:
        return [*passing.rows(points), *clearances.rows(points), *(near.rows(points) if near else [])]

    return rows
