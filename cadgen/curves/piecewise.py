"""Piecewise polynomials: quintic ones from values and two derivatives at nodes, and the zeros of one of many pieces.

A polynomial of thousands of pieces has zeros in few of them. A piece is solved by the eigenvalues of its companion
matrix, in some 10 us. On one of length h, with u = (x - x_i) / h,

    p(u) = sum over k of a_k h^k u^k = sum over j of b_j B_j(u),  b_j = sum over k <= j of C(j, k) / C(n, k) a_k h^k,

and p lies between the least and the greatest of the Bernstein coefficients b_j: of one sign, there is no zero.
"""

from functools import cache
from math import comb

import numpy as np
from scipy.interpolate import PPoly

from cadgen.arrays import Array

# The six quintic Hermite basis polynomials on [0, 1], highest power first; rows are the coefficients that
# multiply f0, h f0', h^2 f0'', f1, h f1', h^2 f1'' (Farin, Curves and Surfaces for CAGD, sec. 7.6).
_BASIS = np.array(
    [
        [-6.0, 15.0, -10.0, 0.0, 0.0, 1.0],
        [-3.0, 8.0, -6.0, 0.0, 1.0, 0.0],
        [-0.5, 1.5, -1.5, 0.5, 0.0, 0.0],
        [6.0, -15.0, 10.0, 0.0, 0.0, 0.0],
        [-3.0, 7.0, -4.0, 0.0, 0.0, 0.0],
        [0.5, -1.0, 0.5, 0.0, 0.0, 0.0],
    ]
)


def quintic_hermite(x: Array, jets: Array, *, periodic: bool = False) -> PPoly:
    """Return the piecewise quintic with the values, slopes and second derivatives of the jets at the nodes.

    Args:
        x: parameters of the nodes, not decreasing, shape (n,). A node that stands twice marks a kink: the piece before
            it ends on the first jet, the piece after it starts on the second.
        jets: value, first and second derivative by the parameter at each node, shape (n, 3) or (n, 3, m).
        periodic: whether the result is evaluated modulo its length.

    Returns:
        A `scipy.interpolate.PPoly`. The interpolation error is h^6 max|f^(6)| / 46080.
    """
    h = np.diff(x)
    keep = h > 0
    h = h[keep].reshape((-1,) + (1,) * (jets.ndim - 2))
    left, right = jets[:-1][keep], jets[1:][keep]
    data = np.stack([left[:, 0], h * left[:, 1], h**2 * left[:, 2], right[:, 0], h * right[:, 1], h**2 * right[:, 2]])
    coefficients = np.einsum("bp,b...->p...", _BASIS, data)
    powers = np.arange(5, -1, -1).reshape((6,) + (1,) * (jets.ndim - 1))
    breaks = np.concatenate([x[:-1][keep], x[-1:]])
    return PPoly(coefficients / h**powers, breaks, extrapolate="periodic" if periodic else False)


_ROUNDING = 1e-12  # of the sizes that add up to a coefficient: nearer to zero than that, its sign says nothing


def zeros(curve: PPoly, *, jumps: bool) -> Array:
    """Places at which a curve is zero, the same to the last bit as `curve.roots(jumps, extrapolate=False)`.

    Args:
        curve: piecewise polynomial of one value.
        jumps: whether a change of sign across a jump counts as a zero at the jump.

    Returns:
        Places in order, shape (n,), in the unit of the curve's argument; where the curve is zero all along a piece, its
        beginning and then NaN.
    """
    power = curve.c[::-1] * np.diff(curve.x) ** np.arange(len(curve.c))[:, None]
    bernstein = _bernstein(len(curve.c)) @ power
    least = _ROUNDING * np.abs(power).sum(axis=0)
    # 1 where a piece is positive all along, -1 where it is negative, 0 where neither is sure.
    sign = np.where((bernstein > least).all(axis=0), 1.0, np.where((bernstein < -least).all(axis=0), -1.0, 0.0))
    solved = sign == 0
    if jumps:
        # A breakpoint between two pieces of opposite signs is a jump.
        apart = sign[1:] * sign[:-1] < 0
        solved[1:] |= apart
        solved[:-1] |= apart
    if not solved.any():
        return np.empty(0)
    # A row of pieces without zeros, all of one sign, is one piece: the constant 1 or -1, which costs nothing.
    first = solved | np.append(True, solved[:-1])
    constant = np.eye(len(curve.c))[:, -1:] * sign
    coefficients = np.where(solved, curve.c, constant)[:, first]
    places = np.append(curve.x[:-1][first], curve.x[-1])
    found: Array = PPoly.construct_fast(np.ascontiguousarray(coefficients), places).roots(jumps, extrapolate=False)
    return found


@cache
def _bernstein(count: int) -> Array:
    """Matrix from the coefficients of the powers, lowest first, to those of the Bernstein polynomials."""
    degree = count - 1
    return np.array([[comb(j, k) / comb(degree, k) if k <= j else 0.0 for k in range(count)] for j in range(count)])
