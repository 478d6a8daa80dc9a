"""A flank of a measured motion by each law: its ends, and its wear as a smooth random process of one sign.

On a flank from a to b, between the levels lo and hi, the reading along the normal is

    y = push (lo + (hi - lo) s((theta - a) / (b - a))) - w(theta) + noise.

The wear w has a Gaussian process prior with a length and a size, and none beyond the flank. Laws are compared by their
marginal likelihood, which pays for what the process can explain, over a few lengths and sizes and over no wear at all.
Wear only takes material away: where the process, given the data, would have to add some, that is added to the
misfit as the cost of the nearest w >= 0.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf, log, pi

import numpy as np
from scipy.linalg import solve_triangular
from scipy.optimize import nnls

from cadgen.arrays import Array
from cadgen.laws.law import MotionLaw

_BEYOND = np.radians(3.0)  # beyond the flank as it is seen, over which wear fades
# Wear with soft edges, and with hard ones: standard deviations, um, and lengths in flanks.
_SOFT = tuple((size, length) for size in (30.0, 8.0) for length in (0.4, 0.2, 0.1))
_HARD = ((20.0, 0.5), (6.0, 0.3))
# Wear of a part of the flank: shares of it at its middle, and its half width.
_LOCAL, _LOCAL_REACH = (0.3, 0.5, 0.7), 0.32
_FEW = (0, 2, 6)  # processes of a first look
_LIKELY = 80.0  # of the score, by which a law may be worse at the first look to be looked at again
# Departures of a law that is not in the table from the nearest one: shares of the rise, and lengths in flanks.
_UNKNOWN_SIZES, _UNKNOWN_LENGTHS = (0.02, 0.005, 0.0015), (0.4, 0.2)
_ROUNDS = 12
_SETTLED = 1e-2  # of the misfit, by which a further step must lessen it
_NODES = 28  # of the wear, at which its sign is judged
_STEP = 1e-4


@dataclass(frozen=True)
class FlankData:
    """Readings of a flank with the rests beside it.

    Attributes:
        theta: cam angles, rad, growing, shape (n,).
        q: motion, in its unit.
        push: displacement along the normal by the motion, mm by unit.
        noise: standard deviation along the normal, mm.
        start: cam angle at which the slope shows, rad.
        stop: cam angle at which it ceases to, rad.
        low: level before, in the motion's unit.
        high: level after.
    """

    theta: Array
    q: Array
    push: Array
    noise: float
    start: float
    stop: float
    low: float
    high: float

    def taper(self, theta: Array) -> Array:
        """Share of the wear's size at cam angles: 1 on the flank, 0 well beyond it.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        off = np.maximum(np.maximum(self.start - theta, theta - self.stop), 0.0)
        return np.asarray(np.where(off < _BEYOND, np.cos(np.minimum(off / _BEYOND, 1.0) * pi / 2) ** 2, 0.0))

    @cached_property
    def processes(self) -> "tuple[WearProcess, ...]":
        """No wear, and wear of each length and size."""
        width = self.stop - self.start
        worn = [
            WearProcess.of(self, length * width, size / 1e3, hard=hard)
            for hard, sizes in ((False, _SOFT), (True, _HARD))
            for size, length in sizes
        ]
        local = [
            WearProcess.of(self, _SOFT[0][1] * width, _SOFT[0][0] / 1e3, place=place, reach=_LOCAL_REACH)
            for place in _LOCAL
        ]
        return (WearProcess.of(self, 1.0, 0.0), *worn, *local)


@dataclass(frozen=True, eq=False)
class WearProcess:
    """Wear of a length and a size as a part of the readings' covariance.

    Attributes:
        length: correlation length, rad.
        size: standard deviation, mm; 0 for no wear.
        hard: whether it may begin and end at once.
        place: share of the flank about which it lies.
        reach: share of the flank to each side over which it lies; infinite for all of it.
        whitener: matrix that makes readings independent, 1/mm, shape (n, n); empty without wear.
        log_determinant: logarithm of the determinant of the covariance.
    """

    data: FlankData
    length: float
    size: float
    hard: bool
    place: float
    reach: float
    whitener: Array
    log_determinant: float

    @classmethod
    def of(
        cls,
        data: FlankData,
        length: float,
        size: float,
        *,
        hard: bool = False,
        place: float = 0.5,
        reach: float = inf,
    ) -> "WearProcess":
        """Process on a flank's readings.

        Args:
            data: readings.
            length: correlation length, rad.
            size: standard deviation, mm; 0 for no wear.
            hard: whether it may begin and end at once.
            place: share of the flank about which it lies, dimensionless.
            reach: share of the flank to each side over which it lies, dimensionless; infinite for all of it.
        """
        n = len(data.theta)
        made = cls(data, length, size, hard, place, reach, np.empty((0, 0)), 2 * n * log(data.noise))
        if not size:
            return made
        covariance = made.between(data.theta, data.theta)
        covariance[np.diag_indices(n)] += data.noise**2
        factor = np.linalg.cholesky(covariance)
        whitener = solve_triangular(factor, np.eye(n), lower=True, check_finite=False)
        return replace(made, whitener=whitener, log_determinant=2 * float(np.sum(np.log(np.diag(factor)))))

    def between(self, one: Array, two: Array) -> Array:
        """Covariance of the wear at two sets of cam angles, mm², shape (n, m).

        Args:
            one: cam angles, rad, shape (n,).
            two: other cam angles, rad, shape (m,).
        """
        if not self.size:
            return np.zeros((len(one), len(two)))
        apart = np.abs(one[:, None] - two) / self.length
        decay = np.exp(-apart if self.hard else -(apart**2) / 2)
        return np.asarray(self.size**2 * decay * self._spread(one)[:, None] * self._spread(two))

    def _spread(self, theta: Array) -> Array:
        """Share of the size at cam angles."""
        if self.reach == inf:
            return self.data.taper(theta)
        u = (theta - self.data.start) / (self.data.stop - self.data.start)
        return np.asarray(np.cos(np.clip((u - self.place) / self.reach, -1.0, 1.0) * pi / 2) ** 2)

    def whitened(self, values: Array) -> Array:
        """Values in standard deviations, without correlation.

        Args:
            values: values along the normal, mm, or by a parameter, of n readings, shape (n,) or (n, k).
        """
        if not self.size:
            return np.asarray(values / self.data.noise)
        return np.asarray(self.whitener @ values)

    def expected(self, residual: Array, theta: Array) -> Array:
        """Wear that is to be expected at cam angles, mm, shape (m,).

        Args:
            residual: readings less what explains them beside the wear, along the normal, mm, shape (n,).
            theta: cam angles, rad, shape (m,).
        """
        if not self.size:
            return np.zeros(len(theta))
        half = self.whitened(self.between(self.data.theta, theta))
        return np.asarray(half.T @ self.whitened(-residual))


@dataclass(frozen=True, kw_only=True)
class LawCandidate:
    """Law that a flank may have.

    Attributes:
        code: code of the law.
        law: law, of a shape that can be bent, for a shape's number 0.
        shape: function of that number that makes the law; None where it has one shape.
        reversed: whether it is run backwards.
        room: range of the number, for the prior.
    """

    code: str
    law: MotionLaw
    shape: Callable[[float], MotionLaw] | None = None
    reversed: bool = False
    room: tuple[float, float] = (0.0, 0.0)

    def jet(self, u: Array, shape: float = 0.0) -> Array:
        """Law and slope at shares, shape (n, 2), level beyond its ends.

        Args:
            u: shares, dimensionless, shape (n,).
            shape: number that bends the law, dimensionless.
        """
        law = self.law if self.shape is None else self.shape(shape)
        inside = np.clip(u, 0.0, 1.0)
        jet = law.jet(inside)[:, :2].copy()
        jet[(u < 0) | (u > 1), 1] = 0.0
        return np.asarray(jet)


@dataclass(frozen=True, kw_only=True, eq=False)
class FlankFit:
    """Flank by a law.

    Attributes:
        candidate: law.
        values: ends a and b, rad; levels before and after, in the motion's unit; the law's shape if it has one.
        covariance: covariance of the values.
        process: wear that the data show best.
        score: -2 log of the marginal likelihood, and the cost of wear that would add material.
        added: that cost.
        chi2: misfit, in squared standard deviations.
    """

    candidate: LawCandidate
    values: Array
    covariance: Array
    process: WearProcess
    score: float
    added: float
    chi2: float

    @property
    def data(self) -> FlankData:
        """Readings."""
        return self.process.data

    @cached_property
    def residual(self) -> Array:
        """Readings less the law, along the normal, mm; wear is negative."""
        return residual_of(self.candidate, self.data, self.values)[0]

    def pinned(self, values: Array) -> "FlankFit":
        """Fit whose values are given, by the wear that explains the rest best.

        Args:
            values: as in `values`.
        """
        residual = residual_of(self.candidate, self.data, values)[0]
        fits = []
        for process in self.data.processes:
            white = process.whitened(residual)
            chi2 = float(white @ white)
            fits.append(
                replace(
                    self,
                    values=values,
                    covariance=np.zeros_like(self.covariance),
                    process=process,
                    score=chi2 + process.log_determinant,
                    chi2=chi2,
                )
            )
        best = min(fits, key=lambda fit: fit.score)
        added = _added(best)
        return replace(best, score=best.score + added, added=added)

    def modelled(self, theta: Array) -> Array:
        """Motion by the law at cam angles, without wear, in its unit.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        a, b, low, high, *shape = self.values
        return np.asarray(low + (high - low) * self.candidate.jet((theta - a) / (b - a), *shape)[:, 0])

    def wear(self, theta: Array) -> Array:
        """Wear at cam angles, mm, shape (n,); 0 where none was found.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        return self.process.expected(self.residual, theta)


def residual_of(candidate: LawCandidate, data: FlankData, values: Array) -> tuple[Array, Array]:
    """Readings less a law along the normal, mm, shape (n,), and the derivatives of the law by its values, (n, k).

    Args:
        candidate: law.
        data: readings.
        values: as in `FlankFit.values`.
    """
    a, b, low, high, *shape = values
    u, rise = (data.theta - a) / (b - a), high - low
    share, slope = candidate.jet(u, *shape).T
    columns = [-rise * slope * (1 - u) / (b - a), -rise * slope * u / (b - a), 1 - share, share]
    if shape:
        other = candidate.jet(u, shape[0] + _STEP)[:, 0]
        columns.append(rise * (other - share) / _STEP)
    return data.push * (data.q - low - rise * share), data.push[:, None] * np.stack(columns, axis=1)


def _first(candidate: LawCandidate, data: FlankData) -> Array:
    """Values to begin with: the ends by the places where a fifth and four fifths of the rise are passed."""
    share = (data.q - data.low) / (data.high - data.low)
    grid = np.linspace(0.0, 1.0, 2001)
    law = candidate.jet(grid)[:, 0]
    u = [float(np.interp(part, np.maximum.accumulate(law), grid)) for part in (0.2, 0.8)]
    at = [_passed(data.theta, share, part) for part in (0.2, 0.8)]
    width = (at[1] - at[0]) / (u[1] - u[0])
    a = at[0] - u[0] * width
    return np.array([a, a + width, data.low, data.high, *([0.0] if candidate.shape else [])])


def _passed(theta: Array, share: Array, part: float) -> float:
    """Cam angle at which a share of the rise is passed."""
    above = share >= part
    first, last = int(np.argmax(above)), len(above) - 1 - int(np.argmax(~above[::-1]))
    low, high = max(min(first, last) - 1, 0), min(max(first, last) + 1, len(theta) - 1)
    rows = slice(low, high + 1)
    order = np.argsort(share[rows])
    return float(np.interp(part, share[rows][order], theta[rows][order]))


def _looked(
    candidate: LawCandidate, processes: Sequence[WearProcess], values: Array, *, signed: bool
) -> FlankFit | None:
    """Best fit of a law by some processes, with the cost of wear that adds material if `signed`; None without one."""
    best: FlankFit | None = None
    for process in processes:
        one = _with(candidate, process, values)
        if one is None:
            continue
        values = one.values
        if signed and one.process.size and (best is None or one.score < best.score):
            added = _added(one)
            one = replace(one, score=one.score + added, added=added)
        if best is None or one.score < best.score:
            best = one
    return best


def _with(candidate: LawCandidate, process: WearProcess, values: Array) -> FlankFit | None:
    """Generalised least squares by Gauss and Newton, with steps halved where the misfit grows."""
    data = process.data

    def measure(at: Array) -> tuple[float, Array, Array]:
        residual, slopes = residual_of(candidate, data, at)
        white = process.whitened(np.column_stack([residual, slopes]))
        return float(white[:, 0] @ white[:, 0]), white[:, 0], white[:, 1:]

    low, high = candidate.room
    chi2, white, slopes = measure(values)
    for _ in range(_ROUNDS):
        step, *_ = np.linalg.lstsq(slopes, white, rcond=None)
        share = 1.0
        while share > 1e-3:
            tried = values + share * step
            if len(tried) > 4:
                tried[4] = np.clip(tried[4], low, high)
            if tried[1] - tried[0] > 0.2 * (data.stop - data.start):
                again = measure(tried)
                if again[0] <= chi2 + 1e-9:
                    break
            share /= 2
        else:
            break
        gained, values = chi2 - again[0], tried
        chi2, white, slopes = again
        if gained < _SETTLED:
            break
    information = slopes.T @ slopes
    sign, size = np.linalg.slogdet(information)
    if sign <= 0:
        return None
    prior = 2 * log(high - low) - log(2 * pi) if candidate.shape else 0.0
    return FlankFit(
        candidate=candidate,
        values=values,
        covariance=np.asarray(np.linalg.inv(information), dtype=float),
        process=process,
        score=chi2 + process.log_determinant + float(size) + prior,
        added=0.0,
        chi2=chi2,
    )


def _added(fit: FlankFit) -> float:
    """Misfit that is added where wear must not be negative."""
    slopes = residual_of(fit.candidate, fit.data, fit.values)[1]
    return sign_cost(fit.process, fit.residual, slopes, fit.covariance)


def sign_cost(process: WearProcess, residual: Array, slopes: Array, covariance: Array) -> float:
    """Misfit of wear that would add material: the least squares cost of the nearest w >= 0.

    Args:
        process: wear.
        residual: readings less what explains them beside the wear, along the normal, mm, shape (n,).
        slopes: derivatives of that by its values, mm by unit, shape (n, k).
        covariance: covariance of the values, mm² or rad², shape (k, k).
    """
    if not process.size:
        return 0.0
    data, reach = process.data, _BEYOND / 2
    nodes = np.linspace(data.start - reach, data.stop + reach, _NODES)
    white = process.whitened(np.column_stack([-residual, slopes, process.between(data.theta, nodes)]))
    k = slopes.shape[1]
    seen, columns, cross = white[:, 0], white[:, 1 : 1 + k], white[:, 1 + k :]
    # Wear given the data, with the values free.
    mean = cross.T @ seen
    spread = process.between(nodes, nodes) - cross.T @ cross
    gain = cross.T @ columns
    spread += gain @ covariance @ gain.T
    size, turned = np.linalg.eigh(spread)
    root = turned.T / np.sqrt(np.maximum(size, (0.02 * process.size) ** 2))[:, None]
    _, left = nnls(root, root @ mean)
    return float(left**2)


def ranked(candidates: Sequence[LawCandidate], data: FlankData) -> tuple[FlankFit, ...]:
    """Fits of all laws, the likeliest first.

    All processes are tried for the laws that a first look by a few of them leaves.

    Args:
        candidates: laws that the flank may have.
        data: readings.
    """
    few = [data.processes[number] for number in _FEW]
    first = [fit for each in candidates if (fit := _looked(each, few, _first(each, data), signed=False)) is not None]
    least = min(fit.score for fit in first)
    fits = []
    for fit in first:
        near = fit.score < least + _LIKELY
        fits.append((_looked(fit.candidate, data.processes, fit.values, signed=True) if near else None) or fit)
    return tuple(sorted(fits, key=lambda fit: fit.score))


def unknown_law(near: FlankFit) -> FlankFit:
    """Fit of a law that is not in the table: the nearest one with a departure of either sign, far larger than wear.

    Args:
        near: fit of the likeliest law of the table.
    """
    data = near.data
    width = data.stop - data.start
    size = abs(data.high - data.low) * float(np.median(data.push))
    tried = [
        _with(near.candidate, WearProcess.of(data, length * width, share * size), near.values)
        for share in _UNKNOWN_SIZES
        for length in _UNKNOWN_LENGTHS
    ]
    return min((fit for fit in tried if fit is not None), key=lambda fit: fit.score, default=near)
