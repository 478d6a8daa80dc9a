"""The least greatest error to first order, by exchange.

    minimise z  subject to  weight_j |error_j + derivatives_j (p - p0)| <= z,  low <= p <= high

The length of an error is no less than its part along any direction, so each place and direction gives a linear bound on
z. With k settings that are free, k + 1 bounds, of errors and of ranges, determine a solution. It begins in a corner of
the ranges; then the bound at the place of the greatest error takes the place of one of them, as in the simplex method
on the dual problem, until the greatest error is that of the bounds (Remez' exchange; Watson, Approximation Theory and
Numerical Methods, 1980, ch. 1 and 5). An error that can be made 0 alone, such as that of the start,
gives bounds of 0 among which exchanges turn in a circle; a little cost of the settings themselves, as in the simplex
method with perturbed costs, keeps them from it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array

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
            values: settings of the knobs, shape (6,), mm and rad.
        """
        return float(np.abs(self._base + self._slopes @ ((values - self.at) / self._scale)).max())

    def best(self, fixed: dict[int, float]) -> Array:
        """Settings with the least greatest error, shape (k,).

        Args:
            fixed: settings that are fixed, by their number.
        """
        low, high = ((self.bounds[:, side] - self.at) / self._scale for side in (0, 1))
        for number, value in fixed.items():
            low[number] = high[number] = (value - self.at[number]) / self._scale[number]
        free = np.flatnonzero(high > low)
        base, slopes = self._base + self._slopes @ np.where(high > low, 0.0, low), self._slopes[:, free]
        chosen = low.copy()
        chosen[free] = _exchanged(base, slopes, low[free], high[free])
        return np.asarray(self.at + chosen * self._scale)


def _exchanged(base: Complex, slopes: Complex, low: Array, high: Array) -> Array:
    """Settings within their ranges with the least greatest |base + slopes @ settings|, shape (k,)."""
    best = np.clip(0.0, low, high)
    errors = base + slopes @ best
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
            errors = base + slopes @ values
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
