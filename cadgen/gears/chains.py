"""The best chains of gear pairs for a total ratio: branch and bound on plain arrays.

A chain's cost is eq. 25: each pair's own cost divided by the ratios of the pairs behind it, towards the
output. Pairs are chosen from the output backwards. A branch is left once its cost, with the least that the
missing pairs can add, reaches that of the worst of the `keep` best chains found so far. What a number of pairs
adds at least is tabled over the logarithm of their ratio: as if the ratios of the table's classes, and not only
those of whole teeth, could be combined. Pairs that have one ratio and may stand at the same places are one
class, and classes are chosen first, at the cost of their cheapest pair. The two classes next to the drive are
found together, for all at once, by looking up the ratio that is still missing.
"""

from __future__ import annotations

from bisect import insort
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, inf, log

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import DesignError

IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
Rows = NDArray[np.intp] | slice | int

# More pairs than this overflow the 64-bit products of tooth numbers that decide an exact ratio.
LONGEST_CHAIN = 6
# Of heights that add up to the greatest but for rounding.
HEIGHT_SLACK = 1e-9
# Relative width of the window in which floating-point ratios are looked up before they are compared exactly.
RATIO_SLACK = 1e-12
# Classes of the table over the range of one pair's ratios; bounds are short by a class, some 0.2 %, for each pair more.
CLASSES = 2000
# Of the logarithms of the ratios, so that equal ratios have a table too.
LEAST_RANGE = 1e-6
# A logarithm that meets a class's edge but for rounding belongs to either class (in classes).
EDGE_SLACK = 1e-6
# Pairs, and pairs of pairs, looked at before a search is given up: some ten seconds.
MOST_TRIED = 300_000_000


class EndlessSearchError(DesignError):
    """Error for limits so wide that a search is given up."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Fit:
    """Where pairs may stand and what they leave to each other; `n` pairs, `length` places from drive to output.

    Attributes:
        allowed: which pairs may stand at each place, shape (length, n).
        wheel, pinion: size of the driven gear and of the driver, shape (n,).
        after: at each junction of two places, what the wheel before a pair may have at most, shape (length − 1, n).
        before: what the pinion behind a pair may have at most, shape (length − 1, n).
        height: of a pair along the axes, shape (n,).
        most_height: of all pairs together.
        loss: loss of a pair, shape (n,); None where it does not matter.
        most_loss: of all pairs together.
    """

    allowed: BoolArray
    wheel: Array
    pinion: Array
    after: Array
    before: Array
    height: Array
    most_height: float
    loss: Array | None = None
    most_loss: float = inf

    @classmethod
    def anywhere(cls, length: int, pairs: int, allowed: BoolArray | None = None) -> Fit:
        """Pairs that suit every neighbour, and every place if `allowed` is left out."""
        open_ended, none = np.full((max(length - 1, 0), pairs), inf), np.zeros(pairs)
        places = np.ones((length, pairs), dtype=np.bool_) if allowed is None else np.array(allowed)
        return cls(
            allowed=places, wheel=none, pinion=none, after=open_ended, before=open_ended, height=none, most_height=inf
        )

    def join(self, junction: int, earlier: Rows, later: Rows) -> BoolArray:
        """Whether pairs clear each other as neighbours at a junction."""
        clear = self.wheel[earlier] <= self.after[junction, later]
        return np.asarray(clear & (self.pinion[later] <= self.before[junction, earlier]))


def best_chains(
    driver: IntArray,
    driven: IntArray,
    cost: Array,
    *,
    ratio: Fraction,
    tolerance: float,
    length: int,
    keep: int,
    fit: Fit | None = None,
) -> list[tuple[int, ...]]:
    """Rows, from drive to output, of the `keep` cheapest chains of `length` pairs, cheapest first.

    `driver`, `driven` (teeth) and `cost` > 0 have the shape (n,), one row per pair. The ratio is met exactly
    if `tolerance` is 0, else within it, relatively. Without `fit` every pair may stand everywhere. Raises
    `DesignError` if the search has no end (`MOST_TRIED`).

    Args:
        driver: teeth of the driver of each pair, shape (n,).
        driven: teeth of the driven gear, shape (n,).
        cost: cost of each pair, a number above 0, shape (n,).
        ratio: ratio wanted.
        tolerance: greatest relative error of the ratio; 0 for none.
        length: number of pairs in a chain.
        keep: number of chains that are kept.
        fit: pairs that may stand at each place; None if all may.
    """
    fit = Fit.anywhere(length, driver.size) if fit is None else fit
    classes = _classes(driven / driver, cost, fit.allowed)
    if not classes:
        return []
    search = _Search(driver, driven, cost, fit, classes, tolerance, keep)
    search.choose(length, ratio, 1.0, 0.0, ())
    return [chain for _, chain in search.best]


def _classes(ratio: Array, cost: Array, allowed: BoolArray) -> list[NDArray[np.intp]]:
    """Pairs of one ratio and the same places, cheapest first, by rising ratio (equal fractions divide to equal floats).

    Pairs that may stand nowhere are left out.
    """
    places = (1 << np.arange(len(allowed))) @ allowed
    rows = np.lexsort((cost, places, ratio))
    rows = rows[places[rows] > 0]
    if not rows.size:
        return []
    starts = (np.diff(ratio[rows]) > 0) | (np.diff(places[rows]) != 0)
    return np.split(rows, np.flatnonzero(starts) + 1)


class _Search:
    """The search's state: the classes of pairs, by rising ratio, and the best chains so far as (cost, rows).

    A class stands for its pairs with the teeth, the ratio and the cost of the cheapest. Whether pairs clear each other
    and how high they are together is seen when the classes of a chain are known, and their pairs are chosen.
    """

    def __init__(
        self,
        driver: IntArray,
        driven: IntArray,
        cost: Array,
        fit: Fit,
        classes: list[NDArray[np.intp]],
        tolerance: float,
        keep: int,
    ) -> None:
        first = np.array([rows[0] for rows in classes])
        self.driver, self.driven, self.cost, self.may = driver[first], driven[first], cost[first], fit.allowed[:, first]
        self.classes, self.pair_cost, self.fit = classes, cost, fit
        self.lowest = float(fit.height.min())
        self.least_loss = 0.0 if fit.loss is None else float(fit.loss.min())
        self.ratio = self.driven / self.driver
        self.tolerance, self.keep = tolerance, keep
        self.best: list[tuple[float, tuple[int, ...]]] = []
        self.tried = 0
        self.table = _LeastCosts(self.ratio, self.cost, tolerance)

    def choose(self, missing: int, wanted: Fraction, weight: float, spent: float, chain: tuple[int, ...]) -> None:
        """Put every class in front of `chain`, which costs `spent`; `missing` classes are to give `wanted`."""
        slack = self.tolerance + RATIO_SLACK
        window = float(wanted) * (1 - slack), float(wanted) * (1 + slack)
        if missing == 1:
            rows = np.arange(*np.searchsorted(self.ratio, window))
            rows = rows[self.may[0, rows]]
            exact = self._exact(self.driver[rows], self.driven[rows], wanted)
            self._enter(spent + weight * self.cost[rows[exact]], rows[None, exact], chain)
            return
        self._count(self.ratio.size)
        left = float(wanted) / self.ratio
        bound = spent + weight * (self.cost + self.table.of(missing - 1, left) / self.ratio)
        rows = np.flatnonzero(self.may[missing - 1] & (bound < self.worst))
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

    def _count(self, tried: int) -> None:
        self.tried += tried
        if self.tried > MOST_TRIED:
            raise EndlessSearchError(
                "the search has not ended after {count} million pairs of stages; narrow the teeth, the stage "
                "ratios or the ratio tolerance, or ask for fewer stages or trains",
                count=MOST_TRIED // 1_000_000,
            )

    def _choose_two(
        self,
        rows: NDArray[np.intp],
        window: tuple[float, float],
        wanted: Fraction,
        weight: float,
        spent: float,
        chain: tuple[int, ...],
    ) -> None:
        """Complete the chain with each of `rows` and every class that has the ratio then missing."""
        first = np.searchsorted(self.ratio, window[0] / self.ratio[rows], side="left")
        count = np.searchsorted(self.ratio, window[1] / self.ratio[rows], side="right") - first
        self._count(int(count.sum()))
        later = np.repeat(rows, count)
        earlier = np.arange(later.size) + np.repeat(first - np.cumsum(count) + count, count)
        driver = self.driver[later] * self.driver[earlier]
        exact = self._exact(driver, self.driven[later] * self.driven[earlier], wanted) & self.may[0, earlier]
        earlier, later = earlier[exact], later[exact]
        cost = spent + weight * (self.cost[later] + self.cost[earlier] / self.ratio[later])
        self._enter(cost, np.stack([earlier, later]), chain)

    def _exact(self, driver: IntArray, driven: IntArray, wanted: Fraction) -> NDArray[np.bool_]:
        if self.tolerance > 0:
            return np.ones(driver.shape, dtype=np.bool_)
        return np.asarray(driven * wanted.denominator == driver * wanted.numerator)

    def _enter(self, cost: Array, rows: NDArray[np.intp], chain: tuple[int, ...]) -> None:
        """Put `chain` behind each of the columns of `rows`, and keep the chains of pairs that are among the best."""
        near = np.flatnonzero(cost < self.worst)
        for column in near[np.argsort(cost[near], kind="stable")].tolist():
            if cost[column] >= self.worst:
                break
            whole = (*rows[:, column].tolist(), *chain)
            least, weight = [], 1.0
            for row in reversed(whole):  # the least that this and the places before it cost, from the output on
                least.append((weight, weight * self.cost[row]))
                weight /= self.ratio[row]
            weights = [entry[0] for entry in reversed(least)]
            before = np.cumsum([0.0, *(entry[1] for entry in reversed(least))]).tolist()
            self._pick(whole, weights, before, 0.0, ())

    def _pick(
        self,
        classes: tuple[int, ...],
        weights: list[float],
        before: list[float],
        spent: float,
        chain: tuple[int, ...],
    ) -> None:
        """Put pairs of the last of the `classes` that have none yet in front of `chain`, which costs `spent`.

        `weights` are those of the places, `before` the least cost of all places in front of each.
        """
        place = len(classes) - 1 - len(chain)
        rows = self.classes[classes[place]]
        cost = spent + weights[place] * self.pair_cost[rows]
        room = self.fit.most_height - self.fit.height[list(chain)].sum() - place * self.lowest + HEIGHT_SLACK
        fits = (cost + before[place] < self.worst) & (self.fit.height[rows] <= room)
        if self.fit.loss is not None:
            spared = place * self.least_loss + self.fit.loss[list(chain)].sum()
            fits &= self.fit.loss[rows] <= self.fit.most_loss - spared + HEIGHT_SLACK
        if chain:
            fits &= self.fit.join(place, rows, chain[0])
        self._count(rows.size)
        for index in np.flatnonzero(fits).tolist():
            if cost[index] + before[place] >= self.worst:
                break
            whole = (int(rows[index]), *chain)
            if place:
                self._pick(classes, weights, before, float(cost[index]), whole)
            else:
                insort(self.best, (float(cost[index]), whole))
                del self.best[self.keep :]


class _LeastCosts:
    """Lower bounds of the cost of some pairs that together give a ratio, by classes of its logarithm.

    Row k − 1 of the table is for k pairs and runs from k times the logarithm of the least ratio on: C_1 is the
    least cost in each class, C_k(X) the least of cost + C_{k−1}(X − log i) / i over all classes of pairs.
    """

    def __init__(self, ratio: Array, cost: Array, tolerance: float) -> None:
        places = np.log(ratio)
        self.low = float(places[0])
        slack = log((1 + tolerance) / (1 - tolerance))
        self.width = max(float(places[-1]) - self.low, slack, LEAST_RANGE) / CLASSES
        # How many classes on from the first hold every ratio within the tolerance of one.
        self.slack = slack / self.width + EDGE_SLACK
        self.span = ceil(2 * self.slack) + 1
        classes = ((places - self.low) / self.width).astype(np.int64)
        self.cost, self.ratio = np.full(CLASSES + 1, inf), np.zeros(CLASSES + 1)
        np.minimum.at(self.cost, classes, cost)
        np.maximum.at(self.ratio, classes, ratio)
        self.rows = [self.cost]
        self.windows = [self._window(self.cost)]

    def of(self, pairs: int, ratio: Array) -> Array:
        """Lower bound of the cost of `pairs` pairs that give each `ratio` within the tolerance; inf if none can."""
        while len(self.rows) < pairs:
            self.rows.append(self._longer(self.rows[-1]))
            self.windows.append(self._window(self.rows[-1]))
        window = self.windows[pairs - 1]
        place = (np.log(ratio) - pairs * self.low) / self.width
        start = np.floor(place - self.slack).astype(np.int64) + self.span
        return np.asarray(window[np.clip(start, 0, window.size - 1)])

    def _window(self, row: Array) -> Array:
        """Least of `span` neighbouring classes, from each one on, beginning `span` before the first."""
        padded = np.concatenate([np.full(self.span, inf), row, np.full(self.span, inf)])
        return np.asarray(np.lib.stride_tricks.sliding_window_view(padded, self.span).min(axis=1))

    def _longer(self, row: Array) -> Array:
        """The table's row for one pair more."""
        longer = np.full(row.size + self.cost.size, inf)
        # Less the pair's place, which is anywhere in its class, the sum lies in one of two neighbouring classes.
        either = np.minimum(np.append(row, inf), np.append(inf, row))
        for start in np.flatnonzero(self.cost < inf).tolist():
            part = longer[start : start + either.size]
            np.minimum(part, self.cost[start] + either / self.ratio[start], out=part)
        return longer
