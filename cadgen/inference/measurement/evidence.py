"""How well a set of columns explains a residual, with the form error and the noise taken into account.

The measured residual is y = X p + D d + F b + e: effects, datum freedoms, what repeats without a name, and noise.
What repeats is the form error, and a discrepancy that each kind of record has of its own (`model.Discrepancy`), such as
the floor under a track, whose amplitudes have a stated spread. The form error has a variance spectrum by order:

    S_k = s^2 c / (1 + (k / k0)^2)^q,   sum of S_k = s^2

Its size s is held to the stated floor. Its knee k0 and steepness q are unknown: every hypothesis may choose among the
spectra of a grid. With F and D integrated out (D with the spread that is known of it, or a flat prior):

    -2 log L = r' C^-1 r + log det C,   C = noise + F S F'

All follows from the products of columns by Woodbury's identity. So a whole catalogue costs one Cholesky factor of the
size of F for each spectrum (Rasmussen and Williams, Gaussian Processes for Machine Learning, sec. 2.7 and A.3).

The noise is what does not repeat between runs.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.optimize import nnls

from cadgen.arrays import Array
from cadgen.inference.measurement.model import Model, per_run, repeating

Index = NDArray[np.intp]

# A lag-one correlation below this many standard errors is none.
CORRELATION_SIGMAS = 3.0
# Most cells per row with which means over cells say enough of the noise; else conditions hardly ever repeat.
MOST_CELLS = 0.75
# A run's own error of the abscissa is believed in if its chi-square is this many times what noise gives.
SLIP_RATIO = 6.0


@dataclass(frozen=True)
class Noise:
    """Noise that remains between runs.

    Attributes:
        sigma: standard deviation of each row, shape (n,), internal units.
        correlation: between neighbours in a run.
        slip: standard deviation of the abscissa's error that a run shares, internal units of the abscissa.
        runs: how many there were; with one, sigma also holds what repeats.
        freedom: degrees of freedom from which it was estimated; 0 if that is not known.
    """

    sigma: Array
    correlation: float
    slip: float
    runs: int
    freedom: int = 0

    @property
    def rms(self) -> float:
        """Root mean square over all rows."""
        return float(np.sqrt(np.mean(self.sigma**2)))


def estimate_noise(model: Model, residual: Array) -> Noise:
    """Split a residual into what repeats and what does not, and describe the latter.

    Rows taken under equal conditions in several runs are compared with their mean; where no conditions repeat,
    a constant and a Fourier series of all orders of the form error stand for the mean.

    Args:
        model: model of the record.
        residual: residual, shape (n,), mm or rad.
    """
    rows = model.rows
    slipping = model.slip.size > 0 and rows.runs > 1
    own = [per_run(rows.run) * model.slip[:, None]] if slipping else []
    count = np.bincount(rows.cell) if rows.cell.min() >= 0 else np.ones(len(residual), dtype=np.intp)
    if rows.runs > 1 and np.count_nonzero(count) <= MOST_CELLS * len(residual):
        columns = np.column_stack([model.offsets, *own, residual])
        means = np.stack([np.bincount(rows.cell, weights=column) for column in columns.T], axis=1)
        centred = np.asarray(columns - (means / np.maximum(count, 1)[:, None])[rows.cell])
        freedom = len(residual) - int(np.count_nonzero(count))
    else:
        # What all runs share is no noise, the mean least of all: a disc too large all round errs in size.
        centred = np.column_stack([model.offsets, np.ones(len(residual)), repeating(model), *own, residual])
        freedom = len(residual)
    basis, target = centred[:, :-1], centred[:, -1]
    fit, _, rank, _ = np.linalg.lstsq(basis, target, rcond=1e-9)
    deviation = np.asarray(target - basis @ fit, dtype=float)
    freedom = max(freedom - int(rank), 1)
    variance = float(np.sum(deviation**2)) / freedom
    if variance == 0:  # an instrument whose steps are coarser than its noise
        return Noise(np.zeros(len(residual)), 0.0, 0.0, rows.runs, freedom)
    sigma: Array = np.full(len(residual), variance**0.5)
    if model.slip.size:
        # Each setting of the divider errs: variance a + b slope^2, by weighted non-negative least squares.
        design = np.stack([np.ones_like(model.slip), model.slip**2], axis=1)
        expected = np.full(len(model.slip), variance)
        for _ in range(3):
            share, _ = nnls(design / expected[:, None], deviation**2 / expected)
            expected = np.maximum(design @ share, 0.05 * variance)
        sigma = np.asarray(np.sqrt(expected * variance / np.mean(expected)))
    slip = 0.0
    if slipping:
        # Spread of the runs' own abscissa errors beyond what noise makes of nothing.
        weight = np.bincount(rows.run, weights=(model.slip / sigma) ** 2)
        chance = float(np.mean((1.0 / np.sqrt(np.maximum(weight, 1e-300))) ** 2))
        spread = float(np.var(np.asarray(fit[-rows.runs :], dtype=float), ddof=1))
        slip = float(np.sqrt(spread - chance)) if spread > SLIP_RATIO * chance else 0.0
    standard = deviation / sigma
    follows = rows.run[1:] == rows.run[:-1]
    lag = float(np.sum((standard[1:] * standard[:-1])[follows]) / np.sum(standard**2))
    correlation = lag if abs(lag) > CORRELATION_SIGMAS / np.sqrt(len(residual)) else 0.0
    return Noise(sigma, correlation, slip, rows.runs, freedom)


KNEES = (3.0, 6.0, 12.0, 25.0)
STEEPNESS = (1.0, 3.0)
# A disc made to the stated floor may be a little worse, and one draw of few orders strays from its mean.
WITHIN_FLOOR = (0.8, 1.2)
BEYOND_FLOOR = (2.5, 6.0, 15.0, 40.0)


@dataclass(frozen=True)
class Spectrum:
    """Spectrum of the form error: size as a multiple of the floor, knee and steepness.

    `beside` is the discrepancy's size as a multiple of what it may be, where the record's kind has one; `whole_frame`
    says whether its part that may be the instrument's frame is as large as it may be, whatever the rest.
    """

    size: float
    knee: float
    steepness: float
    beside: float = 1.0
    whole_frame: bool = False

    @property
    def within(self) -> bool:
        """True if the form error keeps the stated floor."""
        return self.size <= max(WITHIN_FLOOR)

    def variance(self, order: Array, floor: float) -> Array:
        """S_k at each column's order.

        Args:
            order: orders of the columns, shape (q,).
            floor: stated form error, rms, mm or rad.
        """
        shape = 1.0 / (1.0 + (order / self.knee) ** 2) ** self.steepness
        once = shape.sum() / 2  # every order has a cosine and a sine
        return np.asarray((self.size * floor) ** 2 * shape / once)


GRID = tuple(
    Spectrum(size, knee, steepness) for size, knee, steepness in product(WITHIN_FLOOR + BEYOND_FLOOR, KNEES, STEEPNESS)
)
# A floor may be as good as level, and then the car is known more closely: of 50 made cars on one, all named rightly at
# any of these sizes, the numbers err by 0.28 % in the median with 0.03, 0.36 % with 0.1, and 0.78 % without.
SLIGHT = 0.03


def grid_of(models: Sequence[Model]) -> tuple[Spectrum, ...]:
    """The grid that models share: where any of them has a discrepancy, it is slight or as large as it may be."""
    if not any(model.discrepancy.columns.shape[1] for model in models):
        return GRID
    return tuple(replace(spectrum, beside=beside) for beside in (SLIGHT, 1.0) for spectrum in GRID)


class Evidence:
    """The noise and form error of one model, factored once."""

    def __init__(
        self, model: Model, noise: Noise, grid: tuple[Spectrum, ...] = GRID, spread: Array | None = None
    ) -> None:
        """Factor a model's columns.

        Args:
            model: model of the record.
            noise: its noise.
            grid: spectra of form error and discrepancy.
            spread: standard deviations of the datum freedoms, shape (d,); those of the model if left out.
        """
        self.grid, self._noise, self._run = grid, noise, model.rows.run
        self.within = np.array([s.within for s in grid])
        parts, flat = [repeating(model)], model.form.shape[1] + model.discrepancy.columns.shape[1]
        known = np.empty(0)
        if noise.slip > 0:
            # Each run's own setting of the divider, and through it the mean of all: known no better than this.
            own = per_run(self._run) * model.slip[:, None]
            parts.append(own)
            known = np.append(known, np.full(own.shape[1], noise.slip**2))
        parts.append(model.offsets)
        free = 1 / (model.spread if spread is None else spread) ** 2
        self.basis = self.whiten(np.hstack(parts))
        gram = self.basis.T @ self.basis
        self.prior, inverse, constants = [], [], []
        for spectrum in grid:
            variance = np.maximum(spectrum.variance(model.order, model.floor), 1e-300)
            beside = model.discrepancy.variance(spectrum.beside, whole_frame=spectrum.whole_frame)
            precision = np.concatenate([1 / variance, 1 / beside, 1 / known, free])
            factor = np.linalg.cholesky(gram + np.diag(precision))
            constants.append(2 * np.sum(np.log(np.diag(factor))) + np.sum(np.log(variance)) + np.sum(np.log(beside)))
            # Every residual is weighed by every spectrum: the factors are inverted once.
            inverse.append(solve_triangular(factor, np.eye(len(factor)), lower=True, check_finite=False))
            self.prior.append(precision)
        self._inverse, self.constant = np.array(inverse), np.array(constants)
        self._flat, self._free = flat, len(free)

    def whiten(self, columns: Array) -> Array:
        """Divide by the noise and take out its correlation between neighbours of a run (first-order).

        Args:
            columns: columns, shape (n, m), internal units (mm, rad).
        """
        z = columns / (self._noise.sigma if columns.ndim == 1 else self._noise.sigma[:, None])
        rho = self._noise.correlation
        if rho == 0:
            return z
        out = z.copy()
        follows = np.flatnonzero(self._run[1:] == self._run[:-1]) + 1
        out[follows] = (z[follows] - rho * z[follows - 1]) / np.sqrt(1 - rho**2)
        return out

    def halves(self, columns: Array) -> Array:
        """H with W'W - H'H the products of whitened columns once form error and datum are taken out.

        One for each spectrum that keeps the floor, shape (g, q, m).

        Args:
            columns: whitened columns, shape (n, m).
        """
        return np.asarray(self._inverse[self.within] @ (self.basis.T @ columns))

    def misfit(self, residual: Array) -> Array:
        """-2 log L of a whitened residual for every spectrum.

        Args:
            residual: whitened residual, shape (n,).
        """
        half = self._inverse @ (self.basis.T @ residual)
        return np.asarray(residual @ residual - np.einsum("gq,gq->g", half, half) + self.constant)

    def products(self, one: Array, two: Array, among: Sequence[int] | NDArray[np.intp]) -> Array:
        """W'C^-1 V of whitened columns for some spectra: what least squares needs.

        Args:
            one, two: columns, shape (n, k) and (n, m).
            among: numbers of the spectra, shape (g,).

        Returns:
            Products, shape (g, k, m).
        """
        inverse = self._inverse[among]
        left = inverse @ (self.basis.T @ one)
        right = left if two is one else inverse @ (self.basis.T @ two)
        return np.asarray(one.T @ two - np.swapaxes(left, 1, 2) @ right)

    def unsure(self, spectrum: int) -> Array:
        """Covariance of what `repeating` gives, shape (q + k, q + k)."""
        inverse = self._inverse[spectrum][:, : self._flat]
        return np.asarray(inverse.T @ inverse)

    def repeating(self, residual: Array, spectrum: int) -> Array:
        """Most likely coefficients of form error and discrepancy given a whitened residual, shape (q + k,).

        Args:
            residual: whitened residual, shape (n,).
            spectrum: number of the spectrum.
        """
        return self._likely(residual, spectrum)[: self._flat]

    def datum(self, residual: Array, spectrum: int) -> Array:
        """Most likely datum freedoms given a whitened residual, shape (d,); arguments as of `repeating`."""
        return self._likely(residual, spectrum)[-self._free :]

    def _likely(self, residual: Array, spectrum: int) -> Array:
        inverse = self._inverse[spectrum]
        return np.asarray(inverse.T @ (inverse @ (self.basis.T @ residual)))


def registered(model: Model, noise: Noise, residual: Array, more: Array | None = None) -> Array:
    """The residual less the linear datum freedoms, and less further columns, shape (n, m).

    Args:
        model: model of the record.
        noise: noise of the record.
        residual: residual, shape (n,), mm or rad.
        more: further columns, shape (n, k), mm or rad; None without.
    """
    weight = 1 / noise.sigma
    free = model.offsets if more is None else np.hstack([model.offsets, more])
    if not free.shape[1]:
        return residual
    fit = np.linalg.lstsq(free * weight[:, None], residual * weight, rcond=None)[0]
    return np.asarray(residual - free @ fit)
