"""The least greatest error to first order, by cutting planes.

    minimise z  subject to  weight_j |error_j + derivatives_j (p - p0)| <= z,  low <= p <= high

The length of an error is no less than its part along any direction, so each place and direction gives a linear bound;
the worst places of the last solution give the next ones (Kelley, J. SIAM 8 (1960) 703). Bounds that were found serve
all problems of one linearisation, whatever is fixed in them.
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from cadgen.arrays import Array

Complex = NDArray[np.complex128]
_FIRST_PLACES, _FIRST_DIRECTIONS = 24, 8
_ADDED = 6  # places that give new bounds in a round
_MOST_ROUNDS = 40
_GAP = 1e-3  # of the error, between the bound from below and what was reached


@dataclass(eq=False)
class Minimax:
    """Errors as linear functions of the settings.

    Attributes:
        errors: errors at p0, shape (n,), mm.
        by: derivatives, shape (n, k).
        at: p0, shape (k,).
        bounds: least and greatest value of each setting, shape (k, 2).
        weights: what an error counts at each place, shape (n,).
        cuts: linear bounds found so far, as right side and slopes by scaled settings, shape (m, 1 + k).
    """

    errors: Complex
    by: Complex
    at: Array
    bounds: Array
    weights: Array
    cuts: Array = field(init=False)

    def __post_init__(self) -> None:
        most = np.abs(self.by).max(axis=0)
        self._scale = np.where(most > 0, 1 / np.maximum(most, 1e-300), 1.0)
        places = np.unique(np.linspace(0, len(self.errors) - 1, _FIRST_PLACES).astype(int))
        directions = np.exp(2j * np.pi * np.arange(_FIRST_DIRECTIONS) / _FIRST_DIRECTIONS)
        self.cuts = np.vstack([self._bounds_of(places, np.full(len(places), d)) for d in directions])

    def predicted(self, values: Array) -> Complex:
        """Weighted errors with settings of shape (6,), mm, shape (n,)."""
        return np.asarray(self.weights * (self.errors + self.by @ (values - self.at)))

    def worst(self, values: Array) -> float:
        """Greatest weighted error with settings of shape (6,), mm."""
        return float(np.abs(self.predicted(values)).max())

    def best(self, fixed: dict[int, float]) -> Array:
        """Settings with the least greatest error, shape (k,).

        Args:
            fixed: settings that are fixed, by their number.
        """
        low, high = ((self.bounds[:, side] - self.at) / self._scale for side in (0, 1))
        for number, value in fixed.items():
            low[number] = high[number] = (value - self.at[number]) / self._scale[number]
        box: Any = np.vstack([np.stack([low, high], axis=1), [0.0, np.inf]])
        objective = np.append(np.zeros(len(self.at)), 1.0)
        best = self.at + np.clip(0.0, low, high) * self._scale
        for _ in range(_MOST_ROUNDS):
            above = np.column_stack([self.cuts[:, 1:], -np.ones(len(self.cuts))])
            result = linprog(objective, A_ub=above, b_ub=-self.cuts[:, 0], bounds=box, method="highs-ds")
            if result.x is None:
                break
            values = np.asarray(self.at + result.x[:-1] * self._scale)
            if self.worst(values) < self.worst(best):
                best = values
            if self.worst(best) <= float(result.x[-1]) * (1 + _GAP) + 1e-9:
                break
            self._cut(values)
        return np.asarray(best)

    def _cut(self, values: Array) -> None:
        """Add bounds at the worst places, far from each other."""
        errors = self.predicted(values)
        size = np.abs(errors)
        inner = np.r_[True, size[1:] >= size[:-1]] & np.r_[size[:-1] >= size[1:], True]
        peaks = np.flatnonzero(inner)
        places = peaks[np.argsort(size[peaks])[-_ADDED:]]
        directions = errors[places] / np.maximum(size[places], 1e-12)
        self.cuts = np.vstack([self.cuts, self._bounds_of(places, directions)])

    def _bounds_of(self, places: NDArray[np.intp], directions: Complex) -> Array:
        towards = (self.weights[places] * directions.conj())[:, None]
        parts = towards * np.column_stack([self.errors[places], self.by[places] * self._scale])
        return np.asarray(parts.real)
