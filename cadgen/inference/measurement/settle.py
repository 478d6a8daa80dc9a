"""Least squares within bounds, content when a further step is small beside the errors of the values.

Gauss-Newton with Levenberg's damping (Marquardt 1963): a step p changes half the sum of squares by g'p + p'H p / 2,
with g = J'r and H = J'J. Where that gain is below `_CONTENT` every value is within a twentieth of its standard
deviation of where it would end, in any combination of values, whatever their units: a criterion that general solvers
do not offer, and past which they go on for most of their steps.
"""

from collections.abc import Callable
from math import inf

import numpy as np

from cadgen.arrays import Array
from cadgen.errors import DesignError

# From good values two or three steps do; more means that the subset does not fit.
_MOST_STEPS = 12
# Gain, in half the sum of squares, after which no further step is taken; relative where values fit badly.
_CONTENT, _RELATIVE = 1e-3, 1e-6
# After so many steps a fit is given up whose cost would not come down to a level by so many times the gain expected.
_EARLY, _GENEROUS = 4, 20.0
_SINGULAR = 1e-12  # relative; keeps columns that are alike, or nothing, from a division by nothing
_DAMPED, _MORE, _LESS = 0.03, 30.0, 0.1  # damping after a first step too far, and its changes


def settled(
    half: Callable[[Array], float],
    normal: Callable[[Array], tuple[Array, Array]],
    start: Array,
    bounds: Array,
    level: float = inf,
) -> tuple[Array, Array, bool]:
    """Values of least squares, and the curvature of the sum of squares there.

    Args:
        half: of values, shape (k,): half the sum of squares of the residual, of unit variance.
        normal: of values: H, shape (k, k), and g, shape (k,).
        start: parameters to begin from, within the bounds, shape (k,).
        bounds: least and greatest parameters, shape (2, k).
        level: half the sum of squares above which the parameters are of no use, so that they need not settle.

    Returns:
        Values, shape (k,); H of the last step, shape (k, k); whether it settled.

    Raises:
        DesignError: of `half` at the start.
    """
    x, cost, damping = start, half(start), 0.0
    H, g = normal(start)
    for number in range(_MOST_STEPS):
        step, expected = _step(H, g, x, bounds, damping)
        content = expected < max(_CONTENT, _RELATIVE * cost)
        if number >= _EARLY and not content and cost - _GENEROUS * expected > level:
            break
        trial = np.clip(x + step, *bounds)
        try:
            after = half(trial)
        except DesignError:
            # A disc that no rod can follow: a step too far.
            after = np.inf
        if after < cost:
            damping = damping * _LESS if cost - after > expected / 4 else max(damping, _DAMPED)
            x, cost = trial, after
        elif not content:
            damping = max(damping * _MORE, _DAMPED)
            continue
        if content:
            return x, H, True
        H, g = normal(x)
    return x, H, False


def _step(H: Array, g: Array, x: Array, bounds: Array, damping: float) -> tuple[Array, float]:
    """A step within the bounds, and by how much it lessens half the sum of squares to first order of the residual."""
    size = np.sqrt(np.maximum(np.diag(H), 1e-300))
    H, g = H / size / size[:, None], g / size
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
