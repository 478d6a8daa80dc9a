"""Shared by every numeric room: the type of an array of floats, a full turn in rad, and nodes of quadrature."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
TURN = 2 * np.pi


@lru_cache(maxsize=16)
def gauss_nodes(count: int) -> tuple[Array, Array]:
    """Nodes and weights (dimensionless) of Gauss-Legendre quadrature on -1 to 1, computed once for each count.

    Args:
        count: number of nodes; polynomials of degree 2 count - 1 are integrated exactly.
    """
    nodes, weights = np.polynomial.legendre.leggauss(count)
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights
