"""Paths of arcs and straights from gate to gate, round what stands in the way, to begin a search with.

From pose to pose there are six shortest ways of a car that turns no tighter than a radius: two arcs with a straight or
a third arc between (L. E. Dubins, Amer. J. Math. 79 (1957) 497). Each stop has several headings, and each leg may go
over one of some poses that are drawn at random. So other draws give ways on other sides of what stands there. The best
sequence of poses is found by dynamic programming; where a way crosses an obstacle, or passes a post on the wrong
side, it is very dear.
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.course.layout import Course, Side
from cadgen.car.planner.barriers import Barrier, barriers_of
from cadgen.car.planner.path_task import PathTask, Vehicle
from cadgen.car.planner.route import BLOCKED, CostMap, car_widths, course_map, planned_stops

_HEADINGS = 24
_BETWEEN = 60  # poses drawn at random for each leg
_SAMPLES = 40  # of a way
_BESIDE = 400.0  # mm from a post within which its side counts; on another part of the way it may be passed otherwise
_ROOM = 20.0  # mm between the car and a post that a way is led beside
_AGREE = 1e-6  # of a radius: a way that does not end where it should is none
# Directions of the three parts of a way: left, straight, right.
_WORDS = ((1, 0, 1), (-1, 0, -1), (1, 0, -1), (-1, 0, 1), (-1, 1, -1), (1, -1, 1))
_SPACING = 60.0  # mm between the places of the result


def arcs_along(
    task: PathTask, seed: int, room: float, closed: Sequence[Array] = (), beside: Sequence[Barrier] = ()
) -> Array:
    """Places of the planned point on a way of arcs and straights along a course, shape (k, 2), mm.

    Args:
        task: what is planned; its gates are passed in their order.
        seed: seed of the poses between the stops.
        room: radius of the arcs, as a factor on the least one; above 1, for the curvature of a path does not jump.
        closed: places that the way keeps away from by half the width of the car, mm.
        beside: posts that the way comes beside, on the side that is asked for.

    Raises:
        DesignError: the course has nothing to drive to.
    """
    vehicle, limits = task.vehicle, task.limits
    radius = room * max(1 / limits.left + vehicle.path_offset, 1 / limits.right - vehicle.path_offset)
    stops, _ = planned_stops(task.course, vehicle)
    random = np.random.default_rng(seed)
    ways = _Ways.of(task, stops, radius, seed)
    if ways.chart is not None and len(closed):
        ways = replace(ways, chart=ways.chart.closed_at(closed))
    layers = _layers(task.course, stops)
    for post in beside:
        poses = _poses_beside(post, vehicle)
        more = [
            float(
                (ways.best(a, poses)[0].min(axis=0) + ways.best(poses, b)[0].min(axis=1)).min()
                - ways.best(a, b)[0].min()
            )
            for a, b in itertools.pairwise(layers)
        ]
        layers.insert(int(np.argmin(more)) + 1, poses)
    low, high = stops.min(axis=0) - 2 * radius, stops.max(axis=0) + 2 * radius
    cost: Array | None = None
    steps = []
    for before, after in itertools.pairwise(layers):
        between = np.column_stack([random.uniform(low, high, (_BETWEEN, 2)), random.uniform(0, TURN, _BETWEEN)])
        direct, word = ways.best(before, after)
        first, first_word = ways.best(before, between)
        second, second_word = ways.best(between, after)
        over = first[:, :, None] + second[None]
        via = over.argmin(axis=1)
        over = over.min(axis=1)
        # Row by row the number of the pose between, -1 for none.
        via = np.where(over < direct, via, -1)
        steps.append((before, between, after, via, word, first_word, second_word))
        leg = np.minimum(over, direct)
        if cost is None:
            cost, chosen = leg, []
            continue
        total = cost[:, :, None] + leg[None]
        chosen.append(total.argmin(axis=1))
        cost = total.min(axis=1)
    assert cost is not None
    start, last = (int(np.diag(cost).argmin()),) * 2 if vehicle.closed else np.unravel_index(cost.argmin(), cost.shape)
    states = [int(last)]
    for table in reversed(chosen):
        states.append(int(table[start, states[-1]]))
    states.append(int(start))
    states.reverse()
    places = []
    for step, (a, b) in zip(steps, itertools.pairwise(states), strict=True):
        before, between, after, via, word, first_word, second_word = step
        over_pose = int(via[a, b])
        if over_pose < 0:
            places.append(ways.places(before[a], after[b], int(word[a, b])))
        else:
            places.append(ways.places(before[a], between[over_pose], int(first_word[a, over_pose])))
            places.append(ways.places(between[over_pose], after[b], int(second_word[over_pose, b])))
    every = np.vstack(places)
    arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(every, axis=0), axis=1)))
    at = np.linspace(0.0, arc[-1], max(int(arc[-1] / _SPACING), 2))
    return np.stack([np.interp(at, arc, every[:, axis]) for axis in range(2)], axis=1)


def _layers(course: Course, stops: Array) -> list[Array]:
    """Poses of each stop that a way may have, x, y (mm) and heading (rad), shapes (k, 3)."""
    gates = [gate for gate in (course.start, *course.gates, course.finish) if gate is not None]
    layers = []
    for gate, stop in zip(gates, stops, strict=True):
        headings = np.arange(_HEADINGS) * TURN / _HEADINGS
        if gate.heading is not None and gate.heading_tolerance < np.pi:
            headings = gate.heading + np.linspace(-0.9, 0.9, 7 if gate.heading_tolerance else 1) * (
                gate.heading_tolerance
            )
        shifts = np.zeros((1, 2))
        if len(gate.place.points) == 2:
            along = np.array(gate.place.points[1]) - np.array(gate.place.points[0])
            shifts = np.array([-0.3, 0.0, 0.3])[:, None] * along
        layers.append(
            np.vstack([np.column_stack([np.tile(stop + each, (len(headings), 1)), headings]) for each in shifts])
        )
    if course.start is not None and course.start is course.finish:
        layers[-1] = layers[0]
    return layers


def _poses_beside(post: Barrier, vehicle: Vehicle) -> Array:
    """Poses from which a post stands just beside the car, on the side that is asked for, shape (k, 3)."""
    headings = np.arange(_HEADINGS) * TURN / _HEADINGS
    left, right = car_widths(vehicle)[0]
    # To the left of the post the car has it on its right.
    aside = (right if post.side == Side.LEFT else -left) + (1 if post.side == Side.LEFT else -1) * (
        post.reach + post.margin + _ROOM
    )
    normal = np.stack([-np.sin(headings), np.cos(headings)], axis=1)
    return np.column_stack([post.points.mean(axis=0) + aside * normal, headings])


@dataclass(frozen=True, eq=False)
class _Ways:
    """Ways of arcs and straights, and what they cost.

    Attributes:
        radius: radius of the arcs, mm.
        chart: what a way costs at each place; None where nothing is in the way.
        posts: places of posts whose side is given, shape (k, 2), mm.
        sides: 1 for those that must be passed on their left, else -1, shape (k,).
        reach: x of the car's rear and front in the frame of the planned point, mm.
    """

    radius: float
    chart: CostMap | None
    posts: Array
    sides: Array
    reach: tuple[float, float]

    @classmethod
    def of(cls, task: PathTask, stops: Array, radius: float, seed: int) -> "_Ways":
        vehicle = task.vehicle
        barriers = barriers_of(task.course, vehicle.body, task.draw)
        sided = [each for each in barriers if each.side is not None]
        posts = np.array([each.points.mean(axis=0) for each in sided]).reshape(-1, 2)
        sides = np.array([1.0 if each.side == Side.LEFT else -1.0 for each in sided])
        chart = course_map(stops, barriers, vehicle, seed) if barriers else None
        return cls(radius, chart, posts, sides, car_widths(vehicle)[1])

    def best(self, before: Array, after: Array) -> tuple[Array, Array]:
        """Least cost from each pose to each other one, mm, and the number of the way, shapes (m, n)."""
        poses = np.broadcast_arrays(before[:, None], after[None])
        costs = np.stack([self._cost(poses[0], poses[1], word) for word in _WORDS])
        return costs.min(axis=0), costs.argmin(axis=0)

    def places(self, a: Array, b: Array, word: int) -> Array:
        """Places along a way, shape (k, 2), mm."""
        parts = _parts(a, b, self.radius, _WORDS[word])[0]
        x, y, _ = _along(a, parts, _WORDS[word], self.radius, 10 * _SAMPLES)
        return np.stack([x, y], axis=1)

    def _cost(self, a: Array, b: Array, word: tuple[int, int, int]) -> Array:
        parts, valid = _parts(a, b, self.radius, word)
        x, y, heading = _along(a, parts, word, self.radius, _SAMPLES)
        length = np.sum(parts, axis=0) * self.radius
        dear = np.ones(x.shape)
        if self.chart is not None:
            dear = self.chart.at(np.stack([x, y], axis=-1))
        for post, side in zip(self.posts, self.sides, strict=True):
            dx, dy = post[0] - x, post[1] - y
            ahead, left = dx * np.cos(heading) + dy * np.sin(heading), dy * np.cos(heading) - dx * np.sin(heading)
            wrong = (ahead > self.reach[0]) & (ahead < self.reach[1]) & (side * left > 0) & (np.hypot(dx, dy) < _BESIDE)
            dear = np.where(wrong, BLOCKED, dear)
        return np.where(valid, length * dear.mean(axis=0), np.inf)


def _parts(a: Array, b: Array, radius: float, word: tuple[int, int, int]) -> tuple[Array, Array]:
    """Lengths of the three parts of a way in radii, shape (3, …), and whether there is such a way."""
    dx, dy = (b[..., 0] - a[..., 0]) / radius, (b[..., 1] - a[..., 1]) / radius
    first, second, third = word
    # Centres of the outer arcs, in the frame of the first pose's place.
    x0, y0 = -first * np.sin(a[..., 2]), first * np.cos(a[..., 2])
    x1, y1 = dx - third * np.sin(b[..., 2]), dy + third * np.cos(b[..., 2])
    apart, towards = np.hypot(x1 - x0, y1 - y0), np.arctan2(y1 - y0, x1 - x0)
    if second:
        # The middle arc touches both from outside: an isosceles triangle of sides 2, 2 and `apart`.
        valid = apart <= 4
        corner = np.arccos(np.clip(apart / 4, 0.0, 1.0))
        # From the centres, the directions to that of the middle arc; the longer middle arc is the shorter way.
        out = towards + first * corner
        back = towards + np.pi - first * corner
        along = out + first * np.pi / 2
        last = back + third * np.pi / 2
    elif first == third:
        valid = np.ones(apart.shape, dtype=bool)
        along = last = towards
    else:
        valid = apart >= 2
        lean = np.arcsin(np.clip(2 / np.maximum(apart, 1e-12), 0.0, 1.0))
        along = last = towards + first * lean
    middle = (
        np.mod(second * (last - along), TURN)
        if second
        else np.sqrt(np.maximum(apart**2 - (0.0 if first == third else 4.0), 0.0))
    )
    parts = np.stack([np.mod(first * (along - a[..., 2]), TURN), middle, np.mod(third * (b[..., 2] - last), TURN)])
    x, y, _ = _along(a, parts, word, radius, 2)
    return parts, valid & (np.hypot(x[-1] - b[..., 0], y[-1] - b[..., 1]) < _AGREE * radius)


def _along(a: Array, parts: Array, word: tuple[int, int, int], radius: float, count: int) -> tuple[Array, Array, Array]:
    """Places and headings along a way, each of shape (count, …)."""
    arc = np.linspace(0.0, 1.0, count).reshape(-1, *[1] * (parts.ndim - 1)) * parts.sum(axis=0)
    x, y, heading = (np.broadcast_to(a[..., k], arc.shape) for k in range(3))
    for number, turn in enumerate(word):
        part = np.clip(arc - parts[:number].sum(axis=0), 0.0, parts[number])
        if turn:
            turned = heading + turn * part
            x = x + radius * turn * (np.sin(turned) - np.sin(heading))
            y = y - radius * turn * (np.cos(turned) - np.cos(heading))
            heading = turned
        else:
            x, y = x + radius * part * np.cos(heading), y + radius * part * np.sin(heading)
    return x, y, heading
