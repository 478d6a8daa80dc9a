"""The best setting for a spacing: first as if everything could be set to any value, then to the divisions.

The greatest error is nearly the same function of the settings to first order near its least value, so a few
linearisations find it. Then the settings are put to their divisions one after the other, first those whose division
moves the car most, and the others are set anew each time: a tree of choices, of which those branches are followed that
promise less error than what was found.
"""

from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np

from cadgen.arrays import Array
from cadgen.car.draws.error import Target
from cadgen.car.draws.knobs import COUNT, DISC, TRAVEL, Knobs, Setting, setting_of
from cadgen.car.draws.minimax import Minimax

_MOST_LINEARISED = 8
_SETTLED = 1e-3  # of the error
_MOST_BRANCHES = 1000  # of the tree of choices; mostly there are a few dozen
_NEARLY, _MOST_FOUND = 1.02, 5  # times the least error; settings
_NEAR = 1e-9  # of a setting


@dataclass(frozen=True)
class Found:
    """A good setting for a spacing.

    Attributes:
        setting: the setting.
        error: greatest distance of the car from the scaled path, mm.
    """

    setting: Setting
    error: float


def first_guess(knobs: Knobs, middle: float, travel: float, factor: float) -> Array:
    """Settings by the law of similar paths, as far as they can be set, shape (6,).

    Args:
        knobs: what can be set.
        middle: distance of the disc's middle from the fork axis, mm.
        travel: travel in a turn of the cam at the stated spacing, mm.
        factor: ratio of the spacing to the stated one.
    """
    values = np.zeros(COUNT)
    values[DISC], values[TRAVEL] = middle * (factor - 1), travel * factor
    low, high = knobs.bounds.T
    return np.asarray(np.clip(values, low, high))


def best_settings(target: Target, knobs: Knobs, begin: Array, weights: Array | None = None) -> list[Found]:
    """Settings with the least greatest distance of the car from the scaled path, the best first, and nearly as good.

    Args:
        target: path and car.
        knobs: what can be set.
        begin: settings to begin with, shape (6,), mm and rad.
        weights: what the distance counts at each node, shape (n,); 1 if left out.
    """
    weights = np.ones(len(target.nodes)) if weights is None else weights
    values, reached = begin, _worst(target, begin, weights)
    problem = _linearised(target, values, knobs, weights)
    for _ in range(_MOST_LINEARISED):
        step = problem.best({})
        moved = _worst(target, step, weights)
        while moved > reached and np.abs(step - values).max() > _NEAR:
            step = (step + values) / 2
            moved = _worst(target, step, weights)
        if moved >= reached:
            break
        done = moved > reached * (1 - _SETTLED)
        values, reached = step, moved
        problem = _linearised(target, values, knobs, weights)
        if done:
            break
    ranked = sorted(
        (_worst(target, each, weights), number, each)
        for number, each in enumerate(_to_divisions(problem, knobs, values))
    )
    return [
        Found(setting_of(each, knobs.wheels), float(np.abs(target.errors(each)).max()))
        for worst, _, each in ranked
        if worst <= ranked[0][0] * _NEARLY
    ]


def _linearised(target: Target, values: Array, knobs: Knobs, weights: Array) -> Minimax:
    errors = target.errors(values)
    return Minimax(errors, target.derivatives(values, errors, knobs), values, knobs.bounds, weights)


def _worst(target: Target, values: Array, weights: Array) -> float:
    return float((weights * np.abs(target.errors(values))).max())


def _to_divisions(problem: Minimax, knobs: Knobs, values: Array) -> list[Array]:
    """Settings that can be set with nearly the least error to first order, and first those rounded one by one.

    Branch and bound: what is not set to its division yet is free, so its least error is a bound from below.
    """
    divided = [
        (division * float(np.abs(problem.by[:, number]).max()), number)
        for number in range(COUNT)
        if (division := knobs.division(number, float(values[number]))) > 0
    ]
    numbers = [number for _, number in sorted(divided, reverse=True)]
    first, fixed = values, dict[int, float]()
    for number in numbers:
        choices = [problem.best({**fixed, number: value}) for value in knobs.near(number, float(first[number]))]
        first = min(choices, key=problem.worst)
        fixed[number] = float(first[number])
    found, least = [first], problem.worst(first)
    rows: list[tuple[float, int, dict[int, float], Array]] = [(0.0, 0, {}, values)]
    for count in range(_MOST_BRANCHES):
        if not rows or rows[0][0] >= least * _NEARLY or len(found) > _MOST_FOUND:
            break
        bound, _, fixed, best = heappop(rows)
        if len(fixed) == len(numbers):
            found.append(best)
            least = min(bound, least)
            continue
        number = numbers[len(fixed)]
        for value in knobs.about(number, float(best[number])):
            moved = problem.best(chosen := {**fixed, number: value})
            if (error := problem.worst(moved)) < least * _NEARLY:
                heappush(rows, (error, -len(fixed) * _MOST_BRANCHES - count, chosen, moved))
    return found
