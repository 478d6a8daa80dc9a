"""A task planned: the best path of several searches, and the reasons where a course cannot be driven.

For a reason, each limit that the best path violates is made loose in turn: violations of it become cheap, those of the
others stay dear. If all others can be kept then, the violation that is left says how far this limit must give way.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from cadgen.arrays import Array
from cadgen.car.path.spline import DEGREE
from cadgen.car.planner import SEEDS
from cadgen.car.planner.arcs import arcs_along
from cadgen.car.planner.barriers import Barrier, Clearances, barriers_of
from cadgen.car.planner.constraints import Constraint, Corridor, LimitKind, PathLimit
from cadgen.car.planner.gates import Passing
from cadgen.car.planner.kinematics import Basis
from cadgen.car.planner.path_task import PathTask, Vehicle
from cadgen.car.planner.route import End, fitted_to, planned_end, route_of, smooth_path
from cadgen.car.planner.search import UNEVEN, PathSearch, SearchedPath, fixed_ends, fixed_start, left

_SPAN = 320.0  # mm of the path to a span of the B-spline
_SPANS_A_STOP = 4
_ARC_SPAN = 150.0  # the same of a path begun from arcs, whose curvature changes more often
_LEAST_SPANS, _MOST_SPANS = 16, 110
# Of the path that a search begins with. Through sharp corners of the route the usual one has turns that no step widens;
# a calmer one misses the gates, and is drawn to them.
_CALMNESS = (1.0, 10.0, 40.0)
# Of a path that is begun from arcs: their radius as a factor on the least one, in the order in which they are tried.
ROOMS = (1.2, 1.05)
_WAYS = 2  # draws of the poses between the stops that arcs go over, after the first
_SIDES = 3  # ways that keep from where those before came too near, or beside posts that they passed on the wrong side
_SIZES = (0.3, 0.65, 1.0)  # of a car that grows, in turn
# Limits whose violation is not by such a turn.
_STANDING = (LimitKind.CLEARANCE, LimitKind.FIELD)

# Of the search for reasons.
_QUIET = 1e-3  # of the spread of the play: here only limits count
# Amounts of which each is about as much to ask as the other: shares of the limits of steering and cam, mm, rad.
_SHARE, _LENGTH, _GATE, _CLEARANCE, _HEADING = 0.15, 500.0, 60.0, 30.0, 0.2
_UNITS = {
    LimitKind.LENGTH: _LENGTH,
    LimitKind.CORRIDOR: _GATE,
    LimitKind.GATE: _GATE,
    LimitKind.HEADING: _HEADING,
    LimitKind.CLEARANCE: _CLEARANCE,
    LimitKind.FIELD: _CLEARANCE,
}
_TIGHT = 0.05  # of the greatest curvature, beyond it
_MOST = 4  # limits that are tried
_ROUNDS = 30  # of each penalty
_NEARLY = 0.02  # as `left`, of the other limits: how far one must give way is wanted to a percent or so


@dataclass(frozen=True, eq=False)
class PathPlan:
    """Planned path with its task and the path it was begun from.

    Attributes:
        path: path with its cost and its limits.
        task: what was planned.
        begin: control points that the search began with, shape (n, 2), mm.
    """

    path: SearchedPath
    task: PathTask
    begin: Array

    @property
    def missed(self) -> dict[PathLimit, float]:
        """Limits that are not kept, with the greatest excess of each."""
        return self.path.missed


def best_plan(
    task: PathTask,
    *,
    seeds: int = 1,
    begin: Array | None = None,
    report: Callable[[str], None] | None = None,
    map_with: Callable[..., Iterable[PathPlan]] | None = None,
) -> PathPlan:
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
    if seeds == 1 or begin is not None or task.corridor is not None:
        return _searched(task, begin, report, 0)
    if map_with is None:
        return min(map(partial(_searched, task, None, report), range(seeds)), key=_merit)
    return min(map_with(partial(_searched, task, None, None), range(seeds)), key=_merit)


def _merit(candidate: PathPlan) -> tuple[float, float]:
    return sum(candidate.missed.values()), candidate.path.cost.cost


def _searched(task: PathTask, begin: Array | None, report: Callable[[str], None] | None, seed: int) -> PathPlan:
    vehicle, course = task.vehicle, task.course
    start, finish = planned_end(course.start, vehicle), planned_end(course.finish, vehicle)
    if begin is not None:
        basis, begins = Basis(len(begin), vehicle.closed), [begin]
    elif task.corridor is None:
        route = route_of(course, vehicle, seed)
        basis = _basis(max(route.length / _SPAN, _SPANS_A_STOP * (route.stops - 1)), vehicle)
        first = seed % len(_CALMNESS)
        begins = [
            smooth_path(basis, route.places, route.is_stop, start, finish, calmness)
            for calmness in (*_CALMNESS[first:], *_CALMNESS[:first])
        ]
    else:
        along = np.gradient(task.corridor, axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        planned = task.corridor + vehicle.path_offset * np.stack([along[:, 1], -along[:, 0]], axis=1)
        basis = _basis(float(np.linalg.norm(np.diff(planned, axis=0), axis=1).sum()) / _SPAN, vehicle)
        begins = [fitted_to(basis, planned)]
    if task.corridor is not None:  # the ends stay as they are
        place, ahead = basis.at(np.array([0.0, basis.stop])).jets(begins[0])[:2]
        start, finish = (End(place[k], float(np.arctan2(ahead[k, 1], ahead[k, 0]))) for k in (0, 1))
    search, plans = _search(task, basis, start, finish), []
    words = None if report is None else (lambda cost: report(f"end of the run {cost:.0f} mm"))
    for points in begins:
        plans.append(PathPlan(search.best(points, words), task, points))
        if all(limit.kind in _STANDING for limit in plans[-1].missed):
            break
    if begin is None and task.corridor is None and plans[-1].missed:
        for found in _further(task, seed, (start, finish), plans):
            if not found.missed:  # where it fails, the path along the route says better what is in the way
                plans.append(found)
                break
    return min(plans, key=_merit)


def _further(task: PathTask, seed: int, ends: tuple[End, End], failed: Sequence[PathPlan]) -> Iterator[PathPlan]:
    """Paths where none was found along the route: from arcs, on another side of what is in the way, of a growing car.

    Args:
        task: what is planned.
        seed: number of the search.
        ends: start and finish.
        failed: paths along the route.
    """
    yield (first := _from_arcs(task, seed, ROOMS[0], ends))
    # Where the car would best have driven, but for what stands there.
    obstructed = [each for each in (first, *failed) if any(_obstructs(limit) for limit in each.missed)]
    last = min(
        obstructed or [first],
        key=lambda each: sum(most for limit, most in each.missed.items() if not _obstructs(limit)),
    )
    barriers = {each.key: each for each in barriers_of(task.course, task.vehicle.body, task.draw)}
    closed: list[Array] = []
    beside: dict[str, Barrier] = {}
    for _ in range(_SIDES):
        wrong = list(filter(_obstructs, last.missed))
        beside |= {limit.key: barriers[limit.key] for limit in wrong if barriers[limit.key].side is not None}
        closed += [np.array(_place(last.path, limit)) for limit in wrong if limit.key not in beside]
        if not wrong:
            break
        yield (last := _from_arcs(task, seed, ROOMS[0], ends, closed, tuple(beside.values())))
    for room in ROOMS[1:]:
        yield _from_arcs(task, seed, room, ends)
    yield _grown(task, seed, ends)
    for way in range(1, _WAYS + 1):
        yield _from_arcs(task, seed + SEEDS[1] * way, ROOMS[0], ends)


def _obstructs(limit: PathLimit) -> bool:
    """Whether a limit that is missed is an obstacle in the way."""
    return limit.kind == LimitKind.CLEARANCE


def _from_arcs(
    task: PathTask,
    seed: int,
    room: float,
    ends: tuple[End, End],
    closed: Sequence[Array] = (),
    beside: Sequence[Barrier] = (),
) -> PathPlan:
    """Path begun from arcs and straights; arguments as of `arcs_along`."""
    basis, points = _of_arcs(task, seed, room, ends, closed, beside)
    return PathPlan(_search(task, basis, *ends).best(points), task, points)


def _of_arcs(
    task: PathTask,
    seed: int,
    room: float,
    ends: tuple[End, End],
    closed: Sequence[Array] = (),
    beside: Sequence[Barrier] = (),
) -> tuple[Basis, Array]:
    """B-splines and control points of a smooth path along a way of arcs and straights."""
    places = arcs_along(task, seed, room, closed, beside)
    length = float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())
    basis = _basis(length / _ARC_SPAN, task.vehicle)
    return basis, smooth_path(basis, places, np.ones(len(places), dtype=bool), *ends)


def _grown(task: PathTask, seed: int, ends: tuple[End, End]) -> PathPlan:
    """Path of a car that grows to its size, with the room that it keeps, from arcs of the smallest one.

    Among posts a small car finds its side of each, and as it grows they push it there.
    """
    basis, begin = _of_arcs(smaller(task, _SIZES[0]), seed, ROOMS[0], ends)
    points = begin
    for size in _SIZES:
        path = _search(smaller(task, size), basis, *ends).best(points)
        if path.missed:
            break
        points = path.points
    return PathPlan(path, task, begin)


def smaller(task: PathTask, size: float) -> PathTask:
    """Task with a car `size` times as large about its middle, and with so much of the room that it keeps.

    Args:
        task: what is planned.
        size: size of the outline and the wheels as a factor; the steering stays.
    """
    body = task.vehicle.body
    middle = np.mean(body.corners or [wheel.centre for wheel in body.wheels], axis=0)

    def shrunk(point: tuple[float, float]) -> tuple[float, float]:
        x, y = (middle + size * (np.array(point) - middle)).tolist()
        return x, y

    body = replace(
        body,
        corners=tuple(map(shrunk, body.corners)),
        wheels=tuple(
            replace(each, centre=shrunk(each.centre), radius=size * each.radius, width=size * each.width)
            for each in body.wheels
        ),
    )
    return replace(
        task,
        vehicle=replace(task.vehicle, body=body),
        course=replace(task.course, margin=size * task.course.margin),
    )


def _search(task: PathTask, basis: Basis, start: End, finish: End) -> PathSearch:
    ends = [(end.place is not None, end.heading) for end in (start, finish)]
    fixed = fixed_start(basis, ends[0]) if basis.closed else fixed_ends(basis.count, *ends)
    return PathSearch(task, basis, fixed, _course_constraints(task, basis, start, finish))


def _basis(spans: float, vehicle: Vehicle) -> Basis:
    count = int(np.clip(spans, _LEAST_SPANS, _MOST_SPANS))
    return Basis(count if vehicle.closed else count + DEGREE, vehicle.closed)


def _course_constraints(task: PathTask, basis: Basis, start: End, finish: End) -> Callable[[Array], list[Constraint]]:
    course, vehicle = task.course, task.vehicle
    first = course.start if start.place is None else None
    last = course.finish if finish.place is None and not basis.closed else None
    passing = Passing(basis, course.gates, first, last, vehicle, task.gate_margin, task.spare)
    clearances = Clearances(basis, vehicle, barriers_of(course, vehicle.body, task.draw), task.spare)
    sources: list[Passing | Clearances | Corridor] = [passing, clearances]
    if task.corridor is not None:
        sources.append(Corridor(basis, vehicle.path_offset, task.corridor, task.within))
    return lambda points: [each for source in sources for each in source.constraints(points)]


@dataclass(frozen=True)
class Reason:
    """Limit that must give way for a course to be drivable.

    Attributes:
        limit: limit that must give way.
        amount: by how much, as a share of the limits of steering and cam, else in mm or rad.
        place: where, as [x, y] of the planned point, mm.
        enough: whether all other limits can be kept then.
    """

    limit: PathLimit
    amount: float
    place: tuple[float, float]
    enough: bool

    @property
    def effort(self) -> float:
        """Amount in units that make limits of different kinds comparable."""
        return self.amount / _unit(self.limit)


def _unit(limit: PathLimit) -> float:
    return _UNITS.get(limit.kind, _SHARE)


def reasons(plan: PathPlan) -> tuple[Reason, ...]:
    """Limits of which each must give way for a course to be drivable, the one with the least to ask first.

    Where no single one is enough, a turn or else the most violated of them stands first.

    Args:
        plan: best path, which violates some limits.
    """
    missed = sorted(plan.missed, key=lambda limit: -plan.missed[limit] / _unit(limit))
    tried = list(dict.fromkeys([*missed[: _MOST - 1], PathLimit(LimitKind.TURN)]))
    candidates = [reason for limit in tried if (reason := _loosened(plan, limit)) is not None]
    enough = [reason for reason in candidates if reason.enough]
    if not enough:  # then the limit that is beyond reach by most; a turn that is too tight brings others with it
        tight = {each for each in candidates if each.limit.kind == LimitKind.TURN and each.amount > _TIGHT}
        return tuple(sorted(candidates, key=lambda reason: (reason not in tight, -reason.effort)))
    return tuple(sorted(enough, key=lambda reason: reason.effort))


def _loosened(plan: PathPlan, limit: PathLimit) -> Reason | None:
    """Reason by a limit, with the amount by which it must give way when all others are kept; None if it need not."""
    vehicle = replace(plan.task.vehicle, spread=plan.task.vehicle.spread * _QUIET)
    task, basis = replace(plan.task, vehicle=vehicle), Basis(len(plan.path.points), vehicle.closed)
    ends = (planned_end(end, vehicle) for end in (task.course.start, task.course.finish))
    search = replace(_search(task, basis, *ends), loose=limit)
    path = search.best(plan.begin, rounds=_ROUNDS)  # the best path may be crumpled
    violated = path.violated
    others = [
        most for other, most in violated.items() if other != limit and other.kind not in UNEVEN and most > _NEARLY
    ]
    amount = violated.get(limit, 0.0)
    if amount <= left(limit):
        return None if not others else Reason(limit, plan.missed.get(limit, amount), _place(plan.path, limit), False)
    return Reason(limit, amount, _place(path, limit), not others)


def _place(path: SearchedPath, limit: PathLimit) -> tuple[float, float]:
    found = [each for each in path.constraints if each.limit == limit and len(each.values)]
    if not found:
        return (0.0, 0.0)
    worst = max(found, key=lambda each: each.worst)
    motion = path.cost.line.motion
    u = float(worst.u[int(worst.values.argmax())])
    x, y = motion.jets[0][int(np.abs(motion.places.u - u).argmin())].tolist()
    return x, y
