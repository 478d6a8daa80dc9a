"""Bézier curves through the exact tooth curves: what a CAD kernel and a STEP file can hold."""

from __future__ import annotations

from functools import lru_cache
from math import comb

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import DesignError
from cadgen.parts.loop import Curve, Points

# Degree 5 carries a whole flank and degree 8 a whole root of usual size; beyond 20 the pole matrix loses digits.
LOWEST_DEGREE = 3
HIGHEST_DEGREE = 20
# The deviation is read at this many parameters: several between neighbouring zeros of the error.
DEVIATION_SAMPLES = 101


def bernstein(degree: int, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein polynomials at `t`, shape (n,), as a matrix of shape (n, degree + 1)."""
    i, column = np.arange(degree + 1), t[:, None]
    binomials = np.array([comb(degree, k) for k in range(degree + 1)], dtype=np.float64)
    return np.asarray(binomials * column**i * (1 - column) ** (degree - i))


@lru_cache(maxsize=HIGHEST_DEGREE)
def _basis(degree: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    nodes = (1 - np.cos(np.pi * np.arange(degree + 1) / degree)) / 2
    samples = np.linspace(0.0, 1.0, DEVIATION_SAMPLES)
    return nodes, np.asarray(np.linalg.inv(bernstein(degree, nodes))), bernstein(degree, samples)


def bezier_poles(curve: Curve, tolerance: float) -> Points:
    """Poles, shape (degree + 1,), of the Bézier curve of least degree within `tolerance` (mm) of `curve`.

    The Bézier curve meets `curve` at the Chebyshev-Lobatto points of its parameter, so both ends are exact;
    the deviation is measured across the curve. Raises `DesignError` if `HIGHEST_DEGREE` is not enough.

    Args:
        curve: curve to approximate, mm.
        tolerance: greatest distance from the curve, mm.
    """
    samples = np.linspace(0.0, 1.0, DEVIATION_SAMPLES)
    exact, tangent = curve.point(samples), curve.tangent(samples)
    for degree in range(LOWEST_DEGREE, HIGHEST_DEGREE + 1):
        nodes, to_poles, at_samples = _basis(degree)
        poles = to_poles @ curve.point(nodes)
        deviation = float(np.max(np.abs(((at_samples @ poles - exact) * np.conj(tangent)).imag)))
        if deviation <= tolerance:
            return np.asarray(poles)
    raise DesignError(
        f"a tooth curve cannot be drawn within {tolerance * 1e3:g} µm (degree {HIGHEST_DEGREE} leaves"
        f" {deviation * 1e3:g} µm); choose a smaller module"
    )
