"""The best setting for a spacing: first as if everything could be set to any value, then to the divisions.

The greatest error is nearly the same function of the settings to first order near its least value, so a few
linearisations find it. Then the settings are put to their divisions one after the other, first those whose division
moves the car most, and the others are set anew each time; the few best rows of choices are kept.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.draws.error import Target
from cadgen.draws.knobs import COUNT, DISC, TRAVEL, Knobs, Setting, setting_of
from cadgen.draws.minimax import Minimax

_MOST_LINEARISED = 8
_SETTLED = 1e-3  # of the error
_KEPT = 2  # rows of choices
_NEAR = 1e-9  # of a setting


@dataclass(frozen=True)
class Found:
    """The best setting for a spacing.

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


def best_setting(target: Target, knobs: Knobs, begin: Array, weights: Array | None = None) -> Found:
    """The setting with the least greatest distance of the car from the scaled path.

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
    rounded = min(_to_divisions(problem, knobs, values), key=lambda each: _worst(target, each, weights))
    return Found(setting_of(rounded, knobs.wheels), float(np.abs(target.errors(rounded)).max()))


def _linearised(target: Target, values: Array, knobs: Knobs, weights: Array) -> Minimax:
    errors = target.errors(values)
    return Minimax(errors, target.derivatives(values, errors, knobs), values, knobs.bounds, weights)


def _worst(target: Target, values: Array, weights: Array) -> float:
    return float((weights * np.abs(target.errors(values))).max())


def _to_divisions(problem: Minimax, knobs: Knobs, values: Array) -> list[Array]:
    """Settings that can be set near the best ones, the best rows of choices."""
    divided = [
        (division * float(np.abs(problem.by[:, number]).max()), number)
        for number in range(COUNT)
        if (division := knobs.division(number, float(values[number]))) > 0
    ]
    rows: list[tuple[dict[int, float], Array]] = [({}, values)]
    for _, number in sorted(divided, reverse=True):
        choices = []
        for fixed, best in rows:
            for value in knobs.near(number, float(best[number])):
                chosen = {**fixed, number: value}
                choices.append((chosen, problem.best(chosen)))
        choices.sort(key=lambda choice: problem.worst(choice[1]))
        rows = choices[:_KEPT]
    return [best for _, best in rows]
