"""Closed curves whose geometry is known in closed form."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from cadgen.curves.closed import ClosedCurve, Jet
from cadgen.curves.contour import Contour

TURN = 2 * np.pi


@dataclass(frozen=True)
class Parametric:
    """A piece by its complex point and two derivatives."""

    start: float
    stop: float
    point: Callable[[np.ndarray], np.ndarray]
    first: Callable[[np.ndarray], np.ndarray]
    second: Callable[[np.ndarray], np.ndarray]

    def jet(self, t):
        z, z1, z2 = self.point(t), self.first(t), self.second(t)
        pairs = (np.stack([w.real, w.imag], axis=1) for w in (z, z1))
        return Jet(*pairs, (z1.conjugate() * z2).imag / np.abs(z1) ** 3)


def ellipse(a: float, b: float, starts=(0.0,)) -> ClosedCurve:
    """Semi-axes a along x and b along y, cut into pieces at the given parameters."""
    stops = (*starts[1:], starts[0] + TURN)
    return ClosedCurve(
        tuple(
            Parametric(
                start,
                stop,
                lambda t: a * np.cos(t) + 1j * b * np.sin(t),
                lambda t: -a * np.sin(t) + 1j * b * np.cos(t),
                lambda t: -a * np.cos(t) - 1j * b * np.sin(t),
            )
            for start, stop in zip(starts, stops, strict=True)
        )
    )


def off_ellipse(points: np.ndarray, a: float, b: float) -> np.ndarray:
    """Signed distance of points near the ellipse, right to second order in it."""
    x, y = points.T
    value = x**2 / a**2 + y**2 / b**2 - 1
    return value / np.hypot(2 * x / a**2, 2 * y / b**2)


def limacon(b: float, a: float) -> ClosedCurve:
    """r = b + a cos(t), b > a; hollow at t = pi if 2 a > b, with curvature (b - 2 a) / (b - a)^2 there."""
    return ClosedCurve(
        (
            Parametric(
                0.0,
                TURN,
                lambda t: (b + a * np.cos(t)) * np.exp(1j * t),
                lambda t: (-a * np.sin(t) + 1j * (b + a * np.cos(t))) * np.exp(1j * t),
                lambda t: (-2 * a * np.cos(t) - b - 2j * a * np.sin(t)) * np.exp(1j * t),
            ),
        )
    )


def lens(radius: float, half_angle: float) -> Contour:
    """Two arcs that meet in two convex corners, on the y axis; each turns by 2 half_angle."""
    tip = radius * np.sin(half_angle)
    return Contour(np.array([[0.0, -tip], [0.0, tip]]), np.full(2, np.tan(half_angle / 2)))
