"""The order in which gates are passed that may be passed at any time: that of a short way with gentle turns.

Few gates are tried in every order. Of many, each free one is put where it costs least, the dearest first; then free
gates are moved, and rows of them turned round, as long as that makes the way shorter.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from math import prod

import numpy as np

from cadgen.arrays import Array
from cadgen.car.course.layout import Course, Gate

_TURN = 400.0  # mm of way that a radian of turning is worth
_ROUNDS = 20
_MOST_TRIED = 1000  # orders
_LESS = 1e-6  # mm


def in_order(course: Course) -> Course:
    """The course with its gates in the order in which they are to be passed; those that have an order keep it."""
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
    return min(tried, key=lambda row: _way(course, row))


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
    for _ in range(_ROUNDS):
        before = _way(course, order)
        for gate in [gate for gate in order if gate.free]:
            rest = [other for other in order if other is not gate]
            cost, place = _best_place(course, rest, gate)
            if cost < _way(course, order) - _LESS:
                order = [*rest[:place], gate, *rest[place:]]
        for first, last in combinations(range(len(order) + 1), 2):
            row = order[first:last]
            turned = [*order[:first], *reversed(row), *order[last:]]
            if sum(not gate.free for gate in row) < 2 and _way(course, turned) < _way(course, order) - _LESS:
                order = turned
        if _way(course, order) > before - _LESS:
            break
    return order


def _best_place(course: Course, order: Sequence[Gate], gate: Gate) -> tuple[float, int]:
    """Length of the way with a gate at its best place, and that place."""
    ways = [(_way(course, [*order[:place], gate, *order[place:]]), place) for place in range(len(order) + 1)]
    return min(ways)


def _way(course: Course, order: Sequence[Gate]) -> float:
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
    return length + _TURN * float(turns)


def _wrapped(angle: Array) -> Array:
    return np.asarray((angle + np.pi) % (2 * np.pi) - np.pi)
