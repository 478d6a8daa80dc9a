"""The path that the search begins with: order of the gates, rough route between them, and a smooth path along it.

**Order** of gates that may be passed at any time: that of a short way with gentle turns. Few gates are tried in every
order. Of many, each free one is put where it costs least, the dearest first; then free gates are moved, and sequences
of them turned round, as long as that makes the way shorter.

**Route** of the planned point: straight legs where nothing is in the way; else the shortest way on a grid on which
obstacles are as much wider as the car is from its middle to its side, and dearer near them.
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from cadgen.arrays import Array
from cadgen.car.course.layout import Course, Gate, Side
from cadgen.car.planner.barriers import Barrier, barriers_of, parts_of, polygon_holds
from cadgen.car.planner.gates import planned_place
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_task import Vehicle
from cadgen.errors import DesignError

_TURN_COST = 400.0  # mm of way that a radian of turning is worth
_ORDER_ROUNDS = 20
_MOST_TRIED = 1000  # orders
_LESS = 1e-6  # mm


def in_order(course: Course) -> Course:
    """Course with its gates in the order in which to pass them; gates that have an order keep it."""
    free = [gate for gate in course.gates if gate.free]
    if not free:
        return course
    order = [gate for gate in course.gates if not gate.free]
    orders = prod(range(len(order) + 1, len(course.gates) + 1))
    best = (
        _best_of_all(course, order, free)
        if orders <= _MOST_TRIED
        else _improved(course, _inserted(course, order, free))
    )
    return replace(course, gates=tuple(best))


def _best_of_all(course: Course, order: list[Gate], free: list[Gate]) -> list[Gate]:
    """The best of all orders."""
    if not free:
        return order
    first, *rest = free
    tried = (_best_of_all(course, [*order[:place], first, *order[place:]], rest) for place in range(len(order) + 1))
    return min(tried, key=lambda row: _tour(course, row))


def _inserted(course: Course, order: list[Gate], free: list[Gate]) -> list[Gate]:
    """An order with the free gates put in, the one whose best place is dearest first: it shapes the way."""
    free = list(free)
    while free:
        choices = [(_best_place(course, order, gate), gate) for gate in free]
        (_, place), gate = max(choices, key=lambda choice: choice[0][0])
        order = [*order[:place], gate, *order[place:]]
        free.remove(gate)
    return order


def _improved(course: Course, order: list[Gate]) -> list[Gate]:
    """An order made better by moves of free gates and by turning rows of them round."""
    for _ in range(_ORDER_ROUNDS):
        before = _tour(course, order)
        for gate in [gate for gate in order if gate.free]:
            rest = [other for other in order if other is not gate]
            cost, place = _best_place(course, rest, gate)
            if cost < _tour(course, order) - _LESS:
                order = [*rest[:place], gate, *rest[place:]]
        for first, last in combinations(range(len(order) + 1), 2):
            row = order[first:last]
            turned = [*order[:first], *reversed(row), *order[last:]]
            if sum(not gate.free for gate in row) < 2 and _tour(course, turned) < _tour(course, order) - _LESS:
                order = turned
        if _tour(course, order) > before - _LESS:
            break
    return order


def _best_place(course: Course, order: Sequence[Gate], gate: Gate) -> tuple[float, int]:
    """Length of the way with a gate at its best place, and that place."""
    ways = [(_tour(course, [*order[:place], gate, *order[place:]]), place) for place in range(len(order) + 1)]
    return min(ways)


def _tour(course: Course, order: Sequence[Gate]) -> float:
    """Length of the way from gate to gate, mm, with its turns, those at a known heading among them."""
    stops = [gate for gate in (course.start, *order, course.finish) if gate is not None]
    places: Array = np.array([np.mean(gate.place.points, axis=0) for gate in stops])
    legs = np.diff(places, axis=0)
    length = float(np.hypot(legs[:, 0], legs[:, 1]).sum())
    heading = np.arctan2(legs[:, 1], legs[:, 0])
    turns = np.abs(_wrapped(np.diff(heading))).sum()
    for number, gate in enumerate(stops):
        if gate.heading is not None:
            near = heading[[k for k in (number - 1, number) if 0 <= k < len(heading)]]
            turns += np.abs(_wrapped(near - gate.heading)).sum()
    return length + _TURN_COST * float(turns)


def _wrapped(angle: Array) -> Array:
    return np.asarray((angle + np.pi) % (2 * np.pi) - np.pi)


_CELL = 40.0  # mm
_MOST_CELLS = 60_000
_BESIDE = 300.0  # mm beyond gates and obstacles that the grid reaches
_DEAR = 2.0  # times the length that a way close to an obstacle costs
_COMFORT = 400.0  # mm from an obstacle from which on a way is not dearer
_LEG = 350.0  # mm between the points of a way round something
BLOCKED = 1e3  # times the length that a way costs where the car does not fit
_NOISE = 2.0  # by which another search makes places dearer


@dataclass(frozen=True, eq=False)
class End:
    """Start or finish of a path.

    Attributes:
        place: where it is, mm; None if that is free.
        heading: direction of travel, rad; None if that is free.
    """

    place: Array | None = None
    heading: float | None = None


def planned_end(gate: Gate | None, vehicle: Vehicle) -> End:
    """Start or finish as the place of the planned point; free where the gate is not met exactly.

    A place of another point of the car fixes that of the planned point only together with a heading.
    """
    if gate is None:
        return End()
    x, y = planned_place(gate, vehicle)
    if not gate.is_exact or (gate.heading is None and np.hypot(x, y) > 0):
        return End(heading=gate.heading)
    place = np.array(gate.place.points[0])
    if gate.heading is None:
        return End(place)
    return End(place - _turned(x, y, gate.heading), gate.heading)


def _turned(x: float, y: float, heading: float) -> Array:
    c, s = np.cos(heading), np.sin(heading)
    return np.array([x * c - y * s, x * s + y * c])


@dataclass(frozen=True, eq=False)
class CostMap:
    """A grid with what a way costs at each of its cells, infinite where the car does not fit."""

    corner: Array
    cell: float
    cost: Array
    half_width: float

    def number(self, place: Array) -> int:
        """Number of the cell at a place.

        Args:
            place: x and y, shape (2,), mm.
        """
        i, j = np.clip(((place - self.corner) / self.cell).astype(int), 0, np.array(self.cost.shape) - 1)
        return int(i * self.cost.shape[1] + j)

    def at(self, places: Array) -> Array:
        """Costs at places; beyond the edge they are those at the edge.

        Args:
            places: places, shape (…, 2), mm.
        """
        i, j = np.moveaxis(
            np.clip(((places - self.corner) / self.cell).astype(int), 0, np.array(self.cost.shape) - 1), -1, 0
        )
        return np.asarray(self.cost[i, j])

    def place(self, numbers: Array) -> Array:
        """Middles of cells, shape (k, 2), mm.

        Args:
            numbers: numbers of the cells, shape (k,).
        """
        i, j = np.divmod(numbers, self.cost.shape[1])
        return self.corner + (np.stack([i, j], axis=1) + 0.5) * self.cell

    def closed_at(self, places: Sequence[Array]) -> "CostMap":
        """Map on which the car does not fit within half its width of some places, each x and y, mm."""
        middles = self.place(np.arange(self.cost.size, dtype=float))
        off = np.min([np.linalg.norm(middles - place, axis=1) for place in places], axis=0)
        return replace(self, cost=np.where(off.reshape(self.cost.shape) < self.half_width, BLOCKED, self.cost))


@dataclass(frozen=True, eq=False)
class Route:
    """Places of the planned point along a course.

    Attributes:
        places: the places, shape (k, 2), mm.
        is_stop: which of them the course asks for; the others lead round what is in the way, shape (k,).
    """

    places: Array
    is_stop: NDArray[np.bool_]

    @property
    def stops(self) -> int:
        """Number of places that the course asks for."""
        return int(self.is_stop.sum())

    @property
    def length(self) -> float:
        """Length from place to place, mm."""
        return float(np.linalg.norm(np.diff(self.places, axis=0), axis=1).sum())


def route_of(course: Course, vehicle: Vehicle, seed: int = 0) -> Route:
    """Rough route along a course.

    Args:
        course: course whose gates are passed in their order.
        vehicle: the car.
        seed: 0 for the way that is usually best; another number for another way.

    Raises:
        DesignError: the course has nothing to drive to.
    """
    stops, ahead = planned_stops(course, vehicle)
    barriers = barriers_of(course, vehicle.body)
    if not barriers:
        return Route(stops, np.ones(len(stops), dtype=bool))
    stops, ahead = _beside_posts(stops, ahead, barriers, car_widths(vehicle)[0])
    chart = course_map(stops, barriers, vehicle, seed)
    route, is_stop = [stops[:1]], [True]
    for (a, leaving), (b, arriving) in itertools.pairwise(zip(stops, ahead, strict=True)):
        way = _way(chart, a, b, _LEG * leaving, _LEG * arriving)
        route += [way, b[None]]
        is_stop += [*[False] * len(way), True]
    return Route(np.vstack(route), np.array(is_stop))


def planned_stops(course: Course, vehicle: Vehicle) -> tuple[Array, Array]:
    """Places of the planned point at the gates, and unit vectors along their directions, 0 for any, shapes (k, 2)."""
    gates = [gate for gate in (course.start, *course.gates, course.finish) if gate is not None]
    middles = np.array([np.mean(gate.place.points, axis=0) for gate in gates]).reshape(-1, 2)
    if len(middles) < 2:
        raise DesignError("the course has nothing to drive to: add [[course.gates]] or [course.finish]")
    along = np.gradient(middles, axis=0)
    for number, gate in enumerate(gates):
        heading = gate.heading if gate.heading is not None else float(np.arctan2(along[number, 1], along[number, 0]))
        middles[number] -= _turned(*planned_place(gate, vehicle), heading)
    ahead = [
        (0.0, 0.0)
        if gate.heading is None or gate.heading_tolerance > np.pi / 2
        else (float(np.cos(gate.heading)), float(np.sin(gate.heading)))
        for gate in gates
    ]
    return middles, np.array(ahead)


def car_widths(vehicle: Vehicle) -> tuple[tuple[float, float], tuple[float, float]]:
    """How far the car reaches to the left and right of the planned point; and its x from rear to front, mm."""
    every = np.vstack([corners for corners, _ in parts_of(vehicle)])
    low, high = every.min(axis=0).tolist(), every.max(axis=0).tolist()
    return (high[1], -low[1]), (low[0], high[0])


def _beside_posts(
    stops: Array, ahead: Array, barriers: tuple[Barrier, ...], widths: tuple[float, float]
) -> tuple[Array, Array]:
    """The stops with places beside the posts whose side is given, each on the leg that is nearest to it."""
    left, right = widths
    more: list[tuple[int, float, Array]] = []
    for barrier in barriers:
        if barrier.side is None:
            continue
        post = barrier.points.mean(axis=0)
        legs = np.diff(stops, axis=0)
        share = np.clip(np.sum((post - stops[:-1]) * legs, axis=1) / np.maximum(np.sum(legs**2, axis=1), 1e-9), 0, 1)
        off = np.linalg.norm(post - stops[:-1] - share[:, None] * legs, axis=1)
        leg = int(off.argmin())
        normal = np.array([-legs[leg, 1], legs[leg, 0]]) / max(float(np.linalg.norm(legs[leg])), 1e-9)
        # To the left of the post the car has it on its right.
        aside = (right if barrier.side == Side.LEFT else -left) + (1 if barrier.side == Side.LEFT else -1) * (
            barrier.reach + barrier.margin
        )
        # No nearer than that to the post; where the leg is clear of it already it stays.
        lateral = float((stops[leg] + share[leg] * legs[leg] - post) @ normal)
        if (lateral - aside) * np.sign(aside) < 0:
            more.append((leg, float(share[leg]), post + aside * normal))
    for leg, _, place in sorted(more, key=lambda each: each[:2], reverse=True):
        stops, ahead = np.insert(stops, leg + 1, place, axis=0), np.insert(ahead, leg + 1, 0.0, axis=0)
    return stops, ahead


def course_map(stops: Array, barriers: tuple[Barrier, ...], vehicle: Vehicle, seed: int) -> CostMap:
    """Map of what ways of the planned point cost.

    Args:
        stops: places that the map must reach beyond, shape (k, 2), mm.
        barriers: what is in the way.
        vehicle: the car.
        seed: 0 for the map that is usually best; another number makes some places dearer.
    """
    points = np.vstack([stops, *(barrier.points for barrier in barriers if not barrier.inside)])
    edge = [barrier.corners for barrier in barriers if barrier.inside]
    low, high = points.min(axis=0) - _BESIDE - 500, points.max(axis=0) + _BESIDE + 500
    if edge:
        low, high = np.maximum(low, edge[0].min(axis=0)), np.minimum(high, edge[0].max(axis=0))
    size = np.maximum(high - low, _CELL)
    cell = max(_CELL, float(np.sqrt(size.prod() / _MOST_CELLS)))
    shape = np.maximum(np.ceil(size / cell).astype(int), 1)
    i, j = np.indices(shape)
    centres = low + (np.stack([i, j], axis=-1).reshape(-1, 2) + 0.5) * cell
    away = np.full(len(centres), np.inf)
    half = sum(car_widths(vehicle)[0]) / 2
    for barrier in barriers:
        blocked = np.zeros(tuple(shape), dtype=bool)
        if barrier.inside:
            blocked |= ~polygon_holds(centres, barrier.corners).reshape(blocked.shape)
            blocked = np.pad(blocked, 1, constant_values=True)
            apart = distance_transform_edt(~blocked)[1:-1, 1:-1].ravel() * cell
        else:
            cells = np.clip(((barrier.points - low) / cell).astype(int), 0, shape - 1)
            blocked[cells[:, 0], cells[:, 1]] = True
            if len(barrier.corners):
                blocked |= polygon_holds(centres, barrier.corners).reshape(blocked.shape)
            apart = distance_transform_edt(~blocked).ravel() * cell
        away = np.minimum(away, apart - barrier.reach - barrier.margin)
    free = away > half - cell  # the grid is rough, and the search puts right what is short
    dear = 1 + _DEAR * np.clip(1 - (away - half) / _COMFORT, 0, 1)
    if seed:
        random = np.random.default_rng(seed)
        coarse = random.uniform(0, _NOISE, size=(8, 8))
        dear += coarse[(i.ravel() * 8) // shape[0], (j.ravel() * 8) // shape[1]]
    # Where the car does not fit a way is very dear, but there is one: what is in the way is said by the limits.
    return CostMap(low, cell, np.where(free, dear, BLOCKED).reshape(tuple(shape)), half)


def _way(chart: CostMap, a: Array, b: Array, leaving: Array, arriving: Array) -> Array:
    """Points of the way between two places, without these, shape (k, 2); none where the straight way is clear.

    Args:
        chart: what ways cost.
        a, b: the places, mm.
        leaving: step ahead from the first, where its direction is known, by which a way round something begins, mm.
        arriving: step ahead to the second, likewise.
    """
    count = max(int(np.linalg.norm(b - a) / chart.cell * 2), 2)
    straight = a + np.linspace(0, 1, count)[:, None] * (b - a)
    numbers = np.array([chart.number(place) for place in straight])
    # Beside a stop the car may well be nearer to something than it could be anywhere along its way.
    ends = np.minimum(np.linalg.norm(straight - a, axis=1), np.linalg.norm(straight - b, axis=1))
    if not (chart.cost.ravel()[numbers[ends > chart.half_width]] >= BLOCKED).any():
        return np.zeros((0, 2))
    graph: Any = _graph(chart.cost)  # the stubs of scipy know no single start
    # A car that leaves a gate in its direction does not turn back round what it stands before.
    first, last = (
        place + step if chart.cost.ravel()[chart.number(place + step)] < BLOCKED else place
        for place, step in ((a, leaving), (b, -arriving))
    )
    start: Any = chart.number(first)
    _, before = dijkstra(graph, indices=start, return_predecessors=True)
    way = [chart.number(last)]
    while before[way[-1]] >= 0:
        way.append(int(before[way[-1]]))
    places = chart.place(np.array(way[::-1]))
    arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1)))
    number = int(arc[-1] / _LEG)
    at = np.linspace(0, arc[-1], number + 2)[0 if leaving.any() else 1 : None if arriving.any() else -1]
    return np.stack([np.interp(at, arc, places[:, axis]) for axis in range(2)], axis=1)


def _graph(cost: Array) -> csr_array:
    """Ways between neighbouring cells in eight directions."""
    number: NDArray[Any] = np.arange(cost.size).reshape(cost.shape)
    rows, columns, lengths = [], [], []
    for di, dj in ((0, 1), (1, 0), (1, 1), (1, -1)):
        here = number[: number.shape[0] - di, max(-dj, 0) : number.shape[1] - max(dj, 0)]
        there = number[di:, max(dj, 0) : number.shape[1] + min(dj, 0)]
        mean = (cost.ravel()[here.ravel()] + cost.ravel()[there.ravel()]) / 2 * np.hypot(di, dj)
        rows += [here.ravel(), there.ravel()]
        columns += [there.ravel(), here.ravel()]
        lengths += [mean, mean]
    return csr_array((np.concatenate(lengths), (np.concatenate(rows), np.concatenate(columns))), shape=(cost.size,) * 2)


# What counts alike: so many mm off a stop, off another place of the route, and so great a third derivative (mm for each
# span to the third).
_STOP, _PLACE, _BEND = 3.0, 60.0, 100.0
# Stops that are close to each other make the path swing far out if it is to pass them so near; then it need not.
_STOPS, _MOST_SWING = (_STOP, 20.0, _PLACE), 1.5  # mm; times the length of the route
_SURE = 1e4  # weight of what must be kept
_ROUNDS = 4  # in which the parameters of the points follow the length of the path
_EACH = 8


def smooth_path(
    basis: Basis, route: Array, is_stop: NDArray[np.bool_], start: End, finish: End, calmness: float = 1.0
) -> Array:
    """Control points of a smooth path that passes near the points of a route, shape (n, 2), mm.

    Args:
        basis: B-splines of the path.
        route: points to pass, those of start and finish among them, shape (k, 2), mm.
        is_stop: which of them are stops, that the path passes more closely, shape (k,).
        start: start, whose place and heading the path keeps.
        finish: finish, likewise.
        calmness: so many times as much a bend counts; with more than 1 stops count like other places.
    """
    points = np.zeros((basis.count, 2))
    for stop in _STOPS if calmness == 1 else _STOPS[-1:]:
        weight = np.where(is_stop, 1 / stop, 1 / _PLACE) / calmness
        points, swing = _settled(basis, route, weight, (start, finish))
        if swing <= _MOST_SWING:
            break
    return points


def _settled(basis: Basis, route: Array, weight: Array, ends: tuple[End, End]) -> tuple[Array, float]:
    """Control points of a path whose parameter follows its length, and the ratio of its length to the route's."""
    legs = np.linalg.norm(np.diff(route, axis=0), axis=1)
    u = np.append(0.0, np.cumsum(legs)) / legs.sum() * basis.stop
    length = float(legs.sum())
    points = np.zeros((basis.count, 2))
    fine = basis.even(_EACH)
    for _ in range(_ROUNDS):
        points = _fitted(basis, route, weight, u, ends, length)
        motion = Kinematics(fine, points, 0.0)
        arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(motion.jets[0], axis=0), axis=1)))
        length = float(arc[-1])
        # Each point of the route at the same share of the length as before, and the parameter in step with the length.
        u = np.interp(u, fine.u, arc) / length * basis.stop
    return points, length / float(legs.sum())


def _fitted(basis: Basis, route: Array, weights: Array, u: Array, ends: tuple[End, End], length: float) -> Array:
    n, step = basis.count, length / basis.stop
    even, at = basis.even(2), basis.at(u)
    calm, near = _dense(basis, even.columns, even.values[3]), _dense(basis, at.columns, at.values[0])
    weight = weights[:, None]
    rows = [weight * near, calm / _BEND]
    right = [weight * route, np.zeros((len(calm), 2))]
    if basis.closed:
        rows, right = [*rows, *_held(basis, ends[0], step)[0]], [*right, *_held(basis, ends[0], step)[1]]
    for number, end in () if basis.closed else ((0, ends[0]), (n - 1, ends[1])):
        inner = 1 if number == 0 else n - 2
        if end.place is not None:
            row = np.zeros((1, n))
            row[0, number] = _SURE
            rows.append(row)
            right.append(_SURE * end.place[None])
        if end.heading is not None:
            # The first leg of a clamped B-spline of degree 5 is a fifth of the slope.
            row = np.zeros((1, n))
            row[0, [number, inner]] = -_SURE, _SURE
            leg = step / 5 * np.array([np.cos(end.heading), np.sin(end.heading)]) * (1 if number == 0 else -1)
            rows.append(row)
            right.append(_SURE * leg[None])
    solution, *_ = np.linalg.lstsq(np.vstack(rows), np.vstack(right), rcond=None)
    return np.asarray(solution)


def _held(basis: Basis, start: End, step: float) -> tuple[list[Array], list[Array]]:
    """Equations that hold the start of a closed path, and their right sides."""
    rows, right = [], []
    if start.place is not None:
        rows.append(_SURE * _dense(basis, basis.first.columns, basis.first.values[0]))
        right.append(_SURE * start.place[None])
    if start.heading is not None:
        rows.append(_SURE * _dense(basis, basis.first.columns, basis.first.values[1]))
        right.append(_SURE * step * np.array([[np.cos(start.heading), np.sin(start.heading)]]))
    return rows, right


def fitted_to(basis: Basis, curve: Array) -> Array:
    """Control points of the path nearest to a curve, shape (n, 2), mm.

    Args:
        basis: B-splines of the path.
        curve: points of the curve at even arc lengths, many more than `basis.count`, shape (m, 2), mm.
    """
    at = basis.at(np.linspace(0.0, basis.stop, len(curve)))
    matrix = _dense(basis, at.columns, at.values[0])
    ends = _SURE * matrix[[0, -1]]
    solution, *_ = np.linalg.lstsq(np.vstack([matrix, ends]), np.vstack([curve, _SURE * curve[[0, -1]]]), rcond=None)
    return np.asarray(solution)


def _dense(basis: Basis, columns: NDArray[np.intp], values: Array) -> Array:
    matrix = np.zeros((len(values), basis.count))
    np.put_along_axis(matrix, columns, values, axis=1)
    return matrix
