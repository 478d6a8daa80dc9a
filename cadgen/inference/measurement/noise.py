"""The instrument's noise, from what does not repeat between runs."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from cadgen.arrays import Array
from cadgen.inference.measurement.models.base import Model, per_run, repeating

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
        free = np.hstack([model.offsets, *own])
        centred = _less_mean(np.column_stack([free, residual]), rows.cell, count)
        freedom = len(residual) - int(np.count_nonzero(count))
    else:
        # What all runs share is no noise, the mean least of all: a disc too large all round errs in size.
        free = np.hstack([model.offsets, np.ones((len(residual), 1)), repeating(model), *own])
        centred = np.column_stack([free, residual])
        freedom = len(residual)
    basis, target = centred[:, :-1], centred[:, -1]
    fit, _, rank, _ = np.linalg.lstsq(basis, target, rcond=1e-9)
    deviation = np.asarray(target - basis @ fit, dtype=float)
    coefficients: Array = np.asarray(fit, dtype=np.float64)
    freedom = max(freedom - int(rank), 1)
    variance = float(np.sum(deviation**2)) / freedom
    if variance == 0:  # an instrument whose steps are coarser than its noise
        return Noise(np.zeros(len(residual)), 0.0, 0.0, rows.runs, freedom)
    sigma: Array = np.full(len(residual), variance**0.5)
    if model.slip.size:
        sigma = _scattered_abscissa(deviation, model.slip, variance)
    slip = _run_slip(coefficients[-rows.runs :], model.slip, sigma, rows.run) if slipping else 0.0
    standard = deviation / sigma
    follows = rows.run[1:] == rows.run[:-1]
    lag = float(np.sum((standard[1:] * standard[:-1])[follows]) / np.sum(standard**2))
    correlation = lag if abs(lag) > CORRELATION_SIGMAS / np.sqrt(len(residual)) else 0.0
    return Noise(sigma, correlation, slip, rows.runs, freedom)


def _less_mean(columns: Array, cell: Index, count: Index) -> Array:
    means = np.stack([np.bincount(cell, weights=column) for column in columns.T], axis=1)
    return np.asarray(columns - (means / np.maximum(count, 1)[:, None])[cell])


def _scattered_abscissa(deviation: Array, slope: Array, variance: float) -> Array:
    """Each setting of the divider errs: variance a + b slope^2, by weighted non-negative least squares."""
    design = np.stack([np.ones_like(slope), slope**2], axis=1)
    expected = np.full(len(slope), variance)
    for _ in range(3):
        share, _ = nnls(design / expected[:, None], deviation**2 / expected)
        expected = np.maximum(design @ share, 0.05 * variance)
    return np.asarray(np.sqrt(expected * variance / np.mean(expected)))


def _run_slip(own: Array, slope: Array, sigma: Array, run: Index) -> float:
    """Spread of the runs' own abscissa errors beyond what noise makes of nothing."""
    weight = np.bincount(run, weights=(slope / sigma) ** 2)
    error = 1.0 / np.sqrt(np.maximum(weight, 1e-300))
    spread = float(np.var(own, ddof=1))
    chance = float(np.mean(error**2))
    return float(np.sqrt(spread - chance)) if spread > SLIP_RATIO * chance else 0.0
