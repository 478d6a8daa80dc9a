"""How well a set of columns explains a residual, with the form error and the noise taken into account.

The measured residual is y = X p + D d + F b + e: effects, datum freedoms, what repeats without a name, and noise.
What repeats is the form error, and a discrepancy that each kind of record has of its own (`models.base.Discrepancy`),
such as the floor under a track, whose amplitudes have a stated spread. The form error has a variance spectrum by order,
    S_k = s^2 c / (1 + (k / k0)^2)^q,   sum of S_k = s^2,
whose size s is held to the stated floor, and whose knee k0 and steepness q are unknown: every hypothesis may choose
among the spectra of a grid. With F and D integrated out (D with the spread that is known of it, or a flat prior),
    -2 log L = r' C^-1 r + log det C,   C = noise + F S F',
all from the products of columns by Woodbury's identity, so a whole catalogue costs one Cholesky factor of the size
of F for each spectrum (Rasmussen and Williams, Gaussian Processes for Machine Learning, sec. 2.7 and A.3).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular

from cadgen.arrays import Array
from cadgen.inference.measurement.models.base import Model, per_run, repeating
from cadgen.inference.measurement.noise import Noise

KNEES = (3.0, 6.0, 12.0, 25.0)
STEEPNESS = (1.0, 3.0)
# A disc made to the stated floor may be a little worse, and one draw of few orders strays from its mean.
WITHIN_FLOOR = (0.8, 1.2)
BEYOND_FLOOR = (2.5, 6.0, 15.0, 40.0)


@dataclass(frozen=True)
class Spectrum:
    """One member of the grid: size as a multiple of the floor, knee and steepness; and the discrepancy's size as a
    multiple of what it may be, where the record's kind has one."""

    size: float
    knee: float
    steepness: float
    beside: float = 1.0

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

    def __init__(self, model: Model, noise: Noise, grid: tuple[Spectrum, ...] = GRID) -> None:
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
        free = 1 / model.spread**2
        self.basis = self.whiten(np.hstack(parts))
        gram = self.basis.T @ self.basis
        self.prior, inverse, constants = [], [], []
        for spectrum in grid:
            variance = np.maximum(spectrum.variance(model.order, model.floor), 1e-300)
            beside = (spectrum.beside * model.discrepancy.sigma) ** 2
            precision = np.concatenate([1 / variance, 1 / beside, 1 / known, free])
            factor = np.linalg.cholesky(gram + np.diag(precision))
            constants.append(2 * np.sum(np.log(np.diag(factor))) + np.sum(np.log(variance)) + np.sum(np.log(beside)))
            # Every residual is weighed by every spectrum: the factors are inverted once.
            inverse.append(solve_triangular(factor, np.eye(len(factor)), lower=True, check_finite=False))
            self.prior.append(precision)
        self._inverse = np.array(inverse)
        self.constant = np.array(constants)
        self._flat = flat

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
        inverse = self._inverse[spectrum]
        return np.asarray(inverse[:, : self._flat].T @ (inverse @ (self.basis.T @ residual)))
