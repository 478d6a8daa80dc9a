"""Polynomials by conditions: values and derivatives at any number of places of a segment, with the least degree.

The n conditions are linear in the n coefficients of a polynomial of degree n - 1. They are solved in the share u of the
segment, which keeps the matrix well conditioned, and in Chebyshev polynomials for the same reason.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.polynomial import Chebyshev

from cadgen.arrays import Array
from cadgen.laws.form import ORDERS
from cadgen.laws.law import MotionLaw

_SINGULAR = 1e13  # condition of the matrix; beyond it the conditions contradict each other or leave something open
_QUINTIC = 5  # degree that one piece has exactly
_PIECES_A_DEGREE = 8


@dataclass(frozen=True)
class Condition:
    """Value, or value of a derivative, that a motion has at a place.

    Attributes:
        share: share of the segment.
        order: 0 for the motion itself, 1 for its velocity, and so on.
        value: in the motion's unit, by the share to the order.
    """

    share: float
    order: int
    value: float


def polynomial_law(conditions: Sequence[Condition]) -> MotionLaw | None:
    """Polynomial of the least degree that meets conditions, as a law whose values are heights; None if there is none.

    Args:
        conditions: conditions, no two of which are for the same derivative at the same place.
    """
    count = len(conditions)
    basis = [Chebyshev.basis(number, domain=[0, 1]) for number in range(count)]
    matrix = np.array(
        [[each.deriv(c.order)(c.share) if c.order else each(c.share) for each in basis] for c in conditions]
    )
    scale = np.abs(matrix).max(axis=1, keepdims=True)
    if not scale.all() or np.linalg.cond(matrix / scale) > _SINGULAR:
        return None
    right = np.array([[c.value] for c in conditions])
    solved = np.linalg.solve(matrix / scale, right / scale)
    # One round of refinement brings the residual to rounding.
    solved += np.linalg.solve(matrix / scale, (right - matrix @ solved) / scale)
    curve = Chebyshev(solved[:, 0], domain=[0, 1])
    return MotionLaw(
        code="polynomial",
        meaning="The polynomial of the least degree that meets its conditions.",
        jet=partial(_jet, curve),
        pieces=1 if count <= _QUINTIC + 1 else _PIECES_A_DEGREE * count,
    )


def _jet(curve: Chebyshev, u: Array) -> Array:
    return np.stack([(curve.deriv(order) if order else curve)(u) for order in range(ORDERS)], axis=1)
