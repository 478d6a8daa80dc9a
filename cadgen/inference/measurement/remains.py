"""Residuals that a subset leaves: beyond form error and noise, and where runs differ from each other."""

import numpy as np
from scipy.stats import f as f_distribution

from cadgen.arrays import Array
from cadgen.inference.measurement.hypothesis import Hypothesis
from cadgen.inference.measurement.joint import Joint, Part
from cadgen.inference.measurement.models.base import Model, fourier, per_run, repeating
from cadgen.inference.measurement.noise import Noise

# Runs disagree if the chi-square of their smooth differences has this chance or less.
DISAGREE = 1e-6
SMOOTH_ORDERS = 6


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


def _repeating(part: Part, joint: Joint, best: Hypothesis) -> tuple[Array, Array]:
    """Residual of a part, and the most likely coefficients of what repeats in it."""
    residual = part.residual(best.active)
    return residual, part.evidence.repeating(part.evidence.whiten(residual), joint.grid.index(best.spectrum))


def left_over(part: Part, joint: Joint, best: Hypothesis) -> float:
    """RMS of the whitened residual less its most likely form error and discrepancy: 1 if only noise is left."""
    residual, repeats = _repeating(part, joint, best)
    left = registered(part.model, part.noise, residual - repeating(part.model) @ repeats)
    return float(np.sqrt(np.mean((left / part.noise.sigma) ** 2)))


def largest(part: Part, joint: Joint, best: Hypothesis) -> tuple[float, float, float, Part]:
    """The greatest value of the form error over the noise; its place, its size and the part."""
    values = part.model.form @ _repeating(part, joint, best)[1][: part.model.form.shape[1]]
    values = values - values.mean()
    worst = int(np.argmax(np.abs(values)))
    size = float(values[worst])
    return abs(size) / part.noise.rms, float(part.model.rows.place[worst]), size, part


def runs_disagree(part: Part, best: Hypothesis) -> bool:
    """Do the runs differ smoothly, by more than the noise between neighbours allows?"""
    model, noise, rows = part.model, part.noise, part.model.rows
    if rows.runs < 2:
        return False
    residual = part.residual(best.active)
    smooth, _ = fourier(rows.place, SMOOTH_ORDERS)
    contrasts = [smooth * (rows.run == run)[:, None] for run in range(1, rows.runs)]
    # A divider set differently for each run is index error, and counted as noise.
    own = [per_run(rows.run) * model.slip[:, None]] if model.slip.size else []
    base = np.hstack([model.offsets, repeating(model), *own])
    both = np.hstack([base, *contrasts])
    squares, ranks = [], []
    for columns in (base, both):
        fit, _, rank, _ = np.linalg.lstsq(columns / noise.sigma[:, None], residual / noise.sigma, rcond=1e-9)
        squares.append(float(np.sum(((residual - columns @ fit) / noise.sigma) ** 2)))
        ranks.append(int(rank))
    extra, left = ranks[1] - ranks[0], len(residual) - ranks[1]
    if extra < 1 or left < 1 or squares[1] == 0:
        return False  # so few rows do not tell
    ratio = (squares[0] - squares[1]) / extra / (squares[1] / left)
    inflation = (1 + noise.correlation) / (1 - noise.correlation)
    return bool(f_distribution.sf(ratio / inflation, extra, left) < DISAGREE)
