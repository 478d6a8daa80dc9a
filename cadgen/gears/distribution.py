"""Sum of contributions, each free inside its tolerance zone: bounds, moments, quantiles and samples.

The contributions are independent, and each follows one law scaled to its zone [low, high]:

- `normal`: a process centred in the zone whose ±3 σ fill it, clipped at the limits;
- `uniform`: every value in the zone equally likely, the choice when nothing is known of the process.

Both are symmetric about the middle of the zone, so the mean of the sum is the middle of its range.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import erf, ndtr, ndtri, wofz

from cadgen.arrays import Array
from cadgen.gears.choices import Law

# Half a zone in standard deviations of the unclipped normal law.
SIGMAS = 3.0
# Terms of the distribution's Fourier series: two equal uniform zones, a slow case, leave out less than 1e-8.
FOURIER_TERMS = 4096
# Halvings of the range in the search for a quantile: to 1e-12 of it, finer than the series.
BISECTIONS = 40


@dataclass(frozen=True, slots=True, eq=False)
class ZoneSum:
    """Sum of independent contributions `names`, number k inside [low[k], high[k]]; shapes (n,), one unit."""

    names: tuple[str, ...]
    low: Array
    high: Array
    law: Law = Law.NORMAL

    @property
    def minimum(self) -> float:
        """Least sum."""
        return float(self.low.sum())

    @property
    def maximum(self) -> float:
        """Greatest sum."""
        return float(self.high.sum())

    @property
    def mean(self) -> float:
        """Mean, and median, of the sum."""
        return (self.minimum + self.maximum) / 2

    @property
    def std(self) -> float:
        """Standard deviation of the sum."""
        variance = 1 / 12 if self.law == Law.UNIFORM else _CLIPPED_VARIANCE / (2 * SIGMAS) ** 2
        return float(np.sqrt(variance * ((self.high - self.low) ** 2).sum()))

    def scaled(self, factor: float) -> Self:
        """The distribution of the sum times `factor` ≥ 0.

        Args:
            factor: factor, 0 or more.
        """
        return replace(self, low=self.low * factor, high=self.high * factor)

    def cdf(self, value: ArrayLike) -> Array:
        """Probability that the sum is at most `value`, in the unit of the summands.

        The sum lives on a range of length W, so the Fourier series of its density with period W is exact:
        F(mean + y) = 1/2 + y/W + Σ_k φ(2πk/W) sin(2πk y/W) / (πk), with the product φ of the contributions'
        characteristic functions, which are real by symmetry.

        Args:
            value: values of the sum, in the unit of the summands (mm or rad).
        """
        offset = np.asarray(value, dtype=np.float64) - self.mean
        width = self.maximum - self.minimum
        if width == 0:
            return np.where(offset < 0, 0.0, 1.0)
        return _series(np.clip(offset / width, -0.5, 0.5), self._coefficients())

    def quantile(self, probability: ArrayLike) -> Array:
        """Value that the sum stays below with the given probability in [0, 1].

        Right to about 1e-8 in probability; the least and the greatest sum at 0 and 1.

        Args:
            probability: probabilities, 0 to 1.
        """
        wanted = np.asarray(probability, dtype=np.float64)
        width = self.maximum - self.minimum
        if width == 0:
            return np.full(wanted.shape, self.mean)
        coefficients = self._coefficients()
        low, high = np.full(wanted.shape, -0.5), np.full(wanted.shape, 0.5)
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            below = _series(middle, coefficients) < wanted
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        inside = np.where(wanted <= 0, self.minimum, self.mean + width * (low + high) / 2)
        return np.where(wanted >= 1, self.maximum, inside)

    def _coefficients(self) -> Array:
        """φ(2πk/W)/(πk) for k = 1, 2, …, shape (FOURIER_TERMS,)."""
        k = np.arange(1, FOURIER_TERMS + 1)
        widths = self.high - self.low
        phi = _characteristic(2 * np.pi * k * (widths / widths.sum())[:, None], self.law)
        return np.asarray(np.prod(phi, axis=0) / (np.pi * k))

    def sample_contributions(self, generator: np.random.Generator, size: int) -> Array:
        """Random contributions, shape (size, n)."""
        share = generator.random((size, self.low.size))
        if self.law == Law.NORMAL:
            tail = ndtr(-SIGMAS)
            share = 0.5 + ndtri(tail + (1 - 2 * tail) * share) / (2 * SIGMAS)
        return np.asarray(self.low + (self.high - self.low) * np.clip(share, 0.0, 1.0))

    def sample(self, generator: np.random.Generator, size: int) -> Array:
        """Random sums, shape (size,)."""
        return np.asarray(self.sample_contributions(generator, size).sum(axis=1))


# Variance of the standard normal law clipped at ±SIGMAS.
_CLIPPED_VARIANCE = 1 - 2 * SIGMAS * np.exp(-(SIGMAS**2) / 2) / np.sqrt(2 * np.pi) / erf(SIGMAS / np.sqrt(2))


def _series(share: Array, coefficients: Array) -> Array:
    """Distribution function at mean + `share`·W, −1/2 ≤ share ≤ 1/2."""
    k = np.arange(1, coefficients.size + 1)
    return np.asarray(0.5 + share + np.sin(2 * np.pi * share[..., None] * k) @ coefficients)


def _characteristic(argument: Array, law: Law) -> Array:
    """E cos(s·u) of one contribution u spread over [−1/2, 1/2]."""
    if law == Law.UNIFORM:
        return np.sinc(argument / (2 * np.pi))
    # exp(−x²/2)·Re erf((c + ix)/√2) / erf(c/√2) with x = s σ, through the scaled w(z), which cannot overflow.
    c, x = SIGMAS, argument / (2 * SIGMAS)
    cut = np.exp(-(c**2) / 2) * (np.exp(-1j * c * x) * wofz((1j * c - x) / np.sqrt(2))).real
    return np.asarray((np.exp(-(x**2) / 2) - cut) / erf(c / np.sqrt(2)))


# Of parts made with every contribution free in its zone: this share has less.
QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)


def quantiles(spread: ZoneSum, scale: float) -> dict[str, dict[str, float]]:
    """Quantiles of a sum, each times a scale factor, by their probability as text.

    Args:
        spread: distribution of the sum.
        scale: factor from its unit to the one wanted.
    """
    values = scale * spread.quantile(QUANTILES)
    return {"quantiles": dict(zip(map(str, QUANTILES), values.tolist(), strict=True))}
