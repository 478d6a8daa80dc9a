"""Piecewise quintic polynomials from values and two derivatives at nodes."""

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
