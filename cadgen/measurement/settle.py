"""Least squares within bounds, content when a further step is small beside the errors of the values.

Gauss-Newton with Levenberg's damping (Marquardt 1963): a step p changes half the sum of squares by g'p + p'J'J p / 2,
with g = J'r. Where that gain is below `_CONTENT` every value is within a twentieth of its standard deviation of where
it would end, in any combination of values, whatever their units: a criterion that general solvers do not offer, and
past which they go on for most of their steps.
"""

from collections.abc import Callable

import numpy as np

from cadgen.arrays import Array
from cadgen.errors import DesignError

# From good values two or three steps do; more means that the subset does not fit.
_MOST_STEPS = 12
# Gain, in half the sum of squares, after which no further step is taken; relative where values fit badly.
_CONTENT, _RELATIVE = 1e-3, 1e-6
_SINGULAR = 1e-12  # relative; keeps columns that are alike, or nothing, from a division by nothing
_DAMPED, _MORE, _LESS = 0.03, 30.0, 0.1  # damping after a first step too far, and its changes


def settled(
    residual: Callable[[Array], Array], slopes: Callable[[Array], Array], start: Array, bounds: Array
) -> tuple[Array, Array, bool]:
    """Values of least squares, and their derivatives there.

    Args:
        residual: of values, shape (k,) -> (n,), of unit variance.
        slopes: its derivatives by the values, shape (k,) -> (n, k).
        start: values to begin from, within the bounds, shape (k,).
        bounds: least and greatest values, shape (2, k).

    Returns:
        Values, shape (k,); the derivatives of the last step, shape (n, k); whether it settled.

    Raises:
        DesignError: of `residual` at the start.
    """
    x, r = start, residual(start)
    cost, J, damping = float(r @ r) / 2, slopes(start), 0.0
    for _ in range(_MOST_STEPS):
        step, expected = _step(J, r, x, bounds, damping)
        content = expected < max(_CONTENT, _RELATIVE * cost)
        try:
            trial = residual(np.clip(x + step, *bounds))
            after = float(trial @ trial) / 2
        except DesignError:
            # A disc that no rod can follow: a step too far.
            after = np.inf
        if after < cost:
            damping = damping * _LESS if cost - after > expected / 4 else max(damping, _DAMPED)
            x, r, cost = np.clip(x + step, *bounds), trial, after
        elif not content:
            damping = max(damping * _MORE, _DAMPED)
            continue
        if content:
            return x, J, True
        J = slopes(x)
    return x, J, False


def _step(J: Array, r: Array, x: Array, bounds: Array, damping: float) -> tuple[Array, float]:
    """A step within the bounds, and by how much it lessens half the sum of squares to first order of the residual."""
    size = np.maximum(np.linalg.norm(J, axis=0), 1e-300)
    H, g = (J / size).T @ (J / size), (J / size).T @ r
    low, high = (bounds - x) * size
    step, free = np.zeros(len(x)), np.ones(len(x), dtype=bool)
    # What would leave the bounds is held at them, and the rest finds its step beside it.
    while free.any():
        inner = H[np.ix_(free, free)] + (damping + _SINGULAR) * np.eye(int(free.sum()))
        step[free] = np.linalg.solve(inner, -(g + H[:, ~free] @ step[~free])[free])
        beyond = free & ((step < low) | (step > high))
        step = np.clip(step, low, high)
        if not beyond.any():
            break
        free &= ~beyond
    return step / size, float(-(g @ step) - step @ H @ step / 2)
