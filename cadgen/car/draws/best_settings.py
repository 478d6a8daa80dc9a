"""The best setting for a spacing: first as if everything could be set to any value, then to the divisions.

The greatest error is nearly the same function of the settings to first order near its least value, so a few
linearisations find it. Then the settings are put to their divisions one after the other, first those whose division
moves the car most, and the others are set anew each time: a tree of choices, of which those branches are followed that
promise less error than what was found.
"""

import itertools
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.draws.setting_ranges import COUNT, DISC, TRAVEL, CarSetting, SettingRanges, setting_of
from cadgen.car.draws.target import Target

Complex = NDArray[np.complex128]
_MOST_EXCHANGED = 200
_SMALL = 1e-9  # mm of error
_APART = 1e-6  # mm of error for each mm that a setting moves the car
_GAP = 1e-3  # of the error, between the bound from below and what was reached
_PAST = 1e-9  # mm of error, past the end of a range
_PIVOT = 1e-12  # of the greatest: less is 0


@dataclass(eq=False)
class Minimax:
    """Errors as linear functions of the settings.

    Attributes:
        errors: errors at p0, shape (n,), mm.
        by: derivatives, shape (n, k).
        at: p0, shape (k,).
        bounds: least and greatest value of each setting, shape (k, 2).
        weights: what an error counts at each place, shape (n,).
    """

    errors: Complex
    by: Complex
    at: Array
    bounds: Array
    weights: Array

    def __post_init__(self) -> None:
        most = np.abs(self.by).max(axis=0)
        self._scale = np.where(most > 0, 1 / np.maximum(most, 1e-300), 1.0)
        self._base = self.weights * self.errors
        self._slopes = self.weights[:, None] * self.by * self._scale

    def worst(self, values: Array) -> float:
        """Greatest weighted error with settings of shape (6,), mm.

        Args:
            values: settings, shape (6,), mm and rad.
        """
        return float(np.abs(self._base + _sums(self._slopes, (values - self.at) / self._scale)).max())

    def best(self, fixed: dict[int, float]) -> Array:
        """Settings with the least greatest error, shape (k,).

        Args:
            fixed: settings that are fixed, by their number.
        """
        low, high = ((self.bounds[:, side] - self.at) / self._scale for side in (0, 1))
        for number, value in fixed.items():
            low[number] = high[number] = (value - self.at[number]) / self._scale[number]
        free = np.flatnonzero(high > low)
        base, slopes = self._base + _sums(self._slopes, np.where(high > low, 0.0, low)), self._slopes[:, free]
        chosen = low.copy()
        chosen[free] = _exchanged(base, slopes, low[free], high[free])
        return np.asarray(self.at + chosen * self._scale)


def _sums(slopes: Complex, values: Array) -> Complex:
    """Product of slopes and settings, shape (n,).

    By one thread: on a busy machine several wait for each other over so few numbers, and take thirty times as long.
    """
    return np.asarray(np.einsum("nk,k->n", slopes, values))


def _exchanged(base: Complex, slopes: Complex, low: Array, high: Array) -> Array:
    """Settings within their ranges with the least greatest |base + slopes @ settings|, shape (k,)."""
    best = np.clip(0.0, low, high)
    errors = base + _sums(slopes, best)
    size = np.abs(errors)
    worst = int(np.argmax(size))
    reached = size[worst]
    if len(best) == 0 or reached == 0:
        return np.asarray(best)
    # Rows (slopes of the settings, -1 for z) of the bounds row @ (settings, z) <= right; the last is that of an error.
    towards = errors[worst].conjugate() / reached
    slope = (towards * slopes[worst]).real
    falls = slope > 0  # where the error falls with the setting, that is at its least value
    rows = np.zeros((len(best) + 1, len(best) + 1))
    rows[:-1, :-1] = np.diag(np.where(falls, -1.0, 1.0))
    rows[-1] = np.append(slope, -1.0)
    right = np.append(np.where(falls, -low, high), -(towards * base[worst]).real)
    ends = np.vstack([np.eye(len(best)), -np.eye(len(best))])
    limits = np.concatenate([high, -low])
    costs = np.append(_APART * np.where(falls, 1.0, -1.0) * np.arange(1, len(best) + 1), 1.0)
    for _ in range(_MOST_EXCHANGED):
        inverse = np.linalg.inv(rows)
        corner = inverse @ right
        values, bound = corner[:-1], corner[-1]
        past = ends @ values - limits
        worst = int(np.argmax(past))
        if past[worst] > _PAST:
            row, limit = np.append(ends[worst], 0.0), limits[worst]
        else:
            errors = base + _sums(slopes, values)
            size = np.abs(errors)
            worst = int(np.argmax(size))
            if size[worst] < reached:
                best, reached = np.clip(values, low, high), size[worst]
            if reached <= bound * (1 + _GAP) + _SMALL:
                return np.asarray(best)
            towards = errors[worst].conjugate() / size[worst]
            row, limit = np.append((towards * slopes[worst]).real, -1.0), -(towards * base[worst]).real
        # Shares of the bounds in the objective, and in the new bound; the first that would become negative leaves.
        shares, parts = -costs @ inverse, row @ inverse
        leaves = parts > _PIVOT * np.abs(parts).max()
        if not leaves.any():
            break
        out = int(np.argmin(np.where(leaves, shares / np.where(leaves, parts, 1.0), np.inf)))
        rows[out], right[out] = row, limit
    return np.asarray(best)


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

    setting: CarSetting
    error: float


def first_guess(ranges: SettingRanges, middle: float, travel: float, factor: float) -> Array:
    """Settings by the law of similar paths, as far as they can be set, shape (6,).

    Args:
        ranges: what can be set.
        middle: distance of the disc's middle from the fork axis, mm.
        travel: travel in a turn of the cam at the stated spacing, mm.
        factor: ratio of the spacing to the stated one.
    """
    values = np.zeros(COUNT)
    values[DISC], values[TRAVEL] = middle * (factor - 1), travel * factor
    low, high = ranges.bounds.T
    return np.asarray(np.clip(values, low, high))


def best_settings(target: Target, ranges: SettingRanges, begin: Array, weights: Array | None = None) -> list[Found]:
    """Settings with the least greatest distance of the car from the scaled path, the best first, and nearly as good.

    Args:
        target: path and car.
        ranges: what can be set.
        begin: settings to begin with, shape (6,), mm and rad.
        weights: what the distance counts at each node, shape (n,); 1 if left out.
    """
    weights = np.ones(len(target.nodes)) if weights is None else weights
    values, reached = begin, _worst(target, begin, weights)
    problem = _linearised(target, values, ranges, weights)
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
        problem = _linearised(target, values, ranges, weights)
        if done:
            break
    ranked = sorted(
        (_worst(target, each, weights), number, each)
        for number, each in enumerate(_to_divisions(problem, ranges, values))
    )
    return [
        Found(setting_of(each, ranges.wheels), float(np.abs(target.errors(each)).max()))
        for worst, _, each in ranked
        if worst <= ranked[0][0] * _NEARLY
    ]


def _linearised(target: Target, values: Array, ranges: SettingRanges, weights: Array) -> Minimax:
    errors = target.errors(values)
    return Minimax(errors, target.derivatives(values, errors, ranges), values, ranges.bounds, weights)


def _worst(target: Target, values: Array, weights: Array) -> float:
    return float((weights * np.abs(target.errors(values))).max())


def _to_divisions(problem: Minimax, ranges: SettingRanges, values: Array) -> list[Array]:
    """Settings that can be set with nearly the least error to first order, and first those rounded one by one.

    Branch and bound: what is not set to its division yet is free, so its least error is a bound from below.
    """
    divided = [
        (division * float(np.abs(problem.by[:, number]).max()), number)
        for number in range(COUNT)
        if (division := ranges.division(number, float(values[number]))) > 0
    ]
    numbers = [number for _, number in sorted(divided, reverse=True)]
    first, fixed = values, dict[int, float]()
    for number in numbers:
        choices = [problem.best({**fixed, number: value}) for value in ranges.adjacent(number, float(first[number]))]
        first = min(choices, key=problem.worst)
        fixed[number] = float(first[number])
    found, least = [first], problem.worst(first)
    serial = itertools.count()  # parts equal branches, of which neither dictionaries nor arrays have an order
    rows: list[tuple[float, int, int, dict[int, float], Array]] = [(0.0, 0, next(serial), {}, values)]
    for count in range(_MOST_BRANCHES):
        if not rows or rows[0][0] >= least * _NEARLY or len(found) > _MOST_FOUND:
            break
        bound, _, _, fixed, best = heappop(rows)
        if len(fixed) == len(numbers):
            found.append(best)
            least = min(bound, least)
            continue
        number = numbers[len(fixed)]
        for value in ranges.about(number, float(best[number])):
            moved = problem.best(chosen := {**fixed, number: value})
            if (error := problem.worst(moved)) < least * _NEARLY:
                heappush(rows, (error, -len(fixed) * _MOST_BRANCHES - count, next(serial), chosen, moved))
    return found
