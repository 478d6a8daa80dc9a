"""The best chains of gear pairs for a total ratio: branch and bound on plain arrays.

A chain's cost is eq. 25: each pair's own cost divided by the ratios of the pairs behind it, towards the
output. Pairs are chosen from the output backwards. A branch is left once its cost, with the least that the
missing pairs can add, reaches that of the worst of the `keep` best chains found so far. Pairs of one ratio
differ only in their cost, so the `keep` cheapest of them suffice. The two pairs next to the drive are found
together, for all pairs at once, by looking up the ratio that is still missing.

Chains of up to four pairs are a matter of a fraction of a second. Longer ones with pairs that step up (a
ratio below 1) are not: little is to be gained from their first pairs, and so little can be left out.
"""

from __future__ import annotations

from bisect import insort
from fractions import Fraction
from math import inf

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

# More pairs than this overflow the 64-bit products of tooth numbers that decide an exact ratio.
LONGEST_CHAIN = 6
# Relative width of the window in which floating-point ratios are looked up before they are compared exactly.
RATIO_SLACK = 1e-12


def best_chains(
    driver: IntArray,
    driven: IntArray,
    cost: FloatArray,
    *,
    ratio: Fraction,
    tolerance: float,
    length: int,
    keep: int,
) -> list[tuple[int, ...]]:
    """Rows, from drive to output, of the `keep` cheapest chains of `length` pairs, cheapest first.

    `driver`, `driven` (teeth) and `cost` > 0 have the shape (n,), one row per pair. The ratio is met exactly
    if `tolerance` is 0, else within it, relatively.
    """
    rows = _cheapest_of_each_ratio(driven / driver, cost, keep)
    search = _Search(driver[rows], driven[rows], cost[rows], tolerance, keep)
    if rows.size:
        search.choose(length, ratio, 1.0, 0.0, ())
    return [tuple(int(rows[row]) for row in chain) for _, chain in search.best]


def _cheapest_of_each_ratio(ratio: FloatArray, cost: FloatArray, keep: int) -> NDArray[np.intp]:
    """Rows by rising ratio and cost, at most `keep` of one ratio (equal fractions divide to equal floats)."""
    rows = np.lexsort((cost, ratio))
    position = np.arange(rows.size)
    starts = np.diff(ratio[rows], prepend=-inf) > 0
    return rows[position - np.maximum.accumulate(np.where(starts, position, 0)) < keep]


class _Search:
    """The search's state: the pairs, by rising ratio, and the best chains so far as (cost, rows)."""

    def __init__(self, driver: IntArray, driven: IntArray, cost: FloatArray, tolerance: float, keep: int) -> None:
        self.driver, self.driven, self.cost = driver, driven, cost
        self.ratio = driven / driver
        self.tolerance, self.keep = tolerance, keep
        self.best: list[tuple[float, tuple[int, ...]]] = []

    def choose(self, missing: int, wanted: Fraction, weight: float, spent: float, chain: tuple[int, ...]) -> None:
        """Put every pair in front of `chain`, which costs `spent`; `missing` pairs are to give `wanted`."""
        slack = self.tolerance + RATIO_SLACK
        window = float(wanted) * (1 - slack), float(wanted) * (1 + slack)
        if missing == 1:
            rows = np.arange(*np.searchsorted(self.ratio, window))
            exact = self._exact(self.driver[rows], self.driven[rows], wanted)
            self._enter(spent + weight * self.cost[rows[exact]], rows[None, exact], chain)
            return
        left = float(wanted) / self.ratio
        bound = spent + weight * (self.cost + self._least(missing - 1, left * (1 + slack)) / self.ratio)
        least, most = self.ratio[0] ** (missing - 1), self.ratio[-1] ** (missing - 1)
        reachable = (left * (1 + slack) >= least) & (left * (1 - slack) <= most)
        rows = np.flatnonzero(reachable & (bound < self.worst))
        if missing == 2:
            self._choose_two(rows, window, wanted, weight, spent, chain)
            return
        for row in rows[np.argsort(bound[rows])].tolist():
            if bound[row] >= self.worst:
                break
            here = Fraction(int(self.driven[row]), int(self.driver[row]))
            cost = spent + weight * self.cost[row]
            self.choose(missing - 1, wanted / here, weight / float(here), cost, (row, *chain))

    @property
    def worst(self) -> float:
        """Cost that a chain must stay below to be among the best."""
        return self.best[-1][0] if len(self.best) == self.keep else inf

    def _least(self, count: int, ratio: FloatArray) -> FloatArray:
        """Lower bound of the cost of `count` pairs that give each `ratio` or less, shape (n,).

        All at the least cost; k pairs have at most the k-th power of the greatest ratio, and at most what the
        other pairs, at the least ratio, leave them.
        """
        low, high = self.ratio[0], self.ratio[-1]
        terms = [np.maximum(high**-k, low ** (count - k) / ratio) for k in range(1, count)]
        return np.asarray(self.cost.min() * (1 + sum(terms)))

    def _choose_two(
        self,
        rows: NDArray[np.intp],
        window: tuple[float, float],
        wanted: Fraction,
        weight: float,
        spent: float,
        chain: tuple[int, ...],
    ) -> None:
        """Complete the chain with each of `rows` and every pair that has the ratio then missing."""
        first = np.searchsorted(self.ratio, window[0] / self.ratio[rows], side="left")
        count = np.searchsorted(self.ratio, window[1] / self.ratio[rows], side="right") - first
        later = np.repeat(rows, count)
        earlier = np.arange(later.size) + np.repeat(first - np.cumsum(count) + count, count)
        driver = self.driver[later] * self.driver[earlier]
        exact = self._exact(driver, self.driven[later] * self.driven[earlier], wanted)
        earlier, later = earlier[exact], later[exact]
        cost = spent + weight * (self.cost[later] + self.cost[earlier] / self.ratio[later])
        self._enter(cost, np.stack([earlier, later]), chain)

    def _exact(self, driver: IntArray, driven: IntArray, wanted: Fraction) -> NDArray[np.bool_]:
        if self.tolerance > 0:
            return np.ones(driver.shape, dtype=np.bool_)
        return np.asarray(driven * wanted.denominator == driver * wanted.numerator)

    def _enter(self, cost: FloatArray, rows: NDArray[np.intp], chain: tuple[int, ...]) -> None:
        """Put `chain` behind each of the columns of `rows`, and keep those whose cost is among the best."""
        for column in np.argsort(cost, kind="stable")[: self.keep].tolist():
            if cost[column] >= self.worst:
                break
            insort(self.best, (float(cost[column]), (*rows[:, column].tolist(), *chain)))
            del self.best[self.keep :]
