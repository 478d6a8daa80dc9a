"""Plane curves that bound a gear's transverse section, and closed outlines made of them.

Points are complex numbers x + iy in mm, so that turning by an angle is a product with exp(i·angle).
Every curve runs over a parameter t in [0, 1] and gives its points, its unit tangent and its share of the
enclosed area exactly; `chord_parameters` spaces points on any of them for a chord tolerance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

Points = NDArray[np.complex128]

# Gauss-Legendre nodes of one trochoid: its integrand is analytic and 40 nodes reach rounding (1e-15).
AREA_NODES = 40
# Samples from which a curve's turning is read: the chord count from them is right to about 1 %, and the
# sag itself is checked afterwards.
TURNING_SAMPLES = 129


@dataclass(frozen=True, slots=True)
class Line:
    """Straight line from `start` to `end`."""

    start: complex
    end: complex

    def point(self, t: ArrayLike) -> Points:
        """Points at t."""
        return self.start + (self.end - self.start) * np.asarray(t, dtype=np.float64)

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t."""
        step = self.end - self.start
        return np.full(np.shape(t), step / abs(step))

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm²."""
        return float((self.start.conjugate() * self.end).imag) / 2

    def rotated(self, angle: float) -> Self:
        """The curve turned about the origin by `angle` in rad."""
        turn = complex(np.exp(1j * angle))
        return replace(self, start=self.start * turn, end=self.end * turn)


@dataclass(frozen=True, slots=True)
class Arc:
    """Circular arc about `centre`, from polar angle `start` through the signed angle `sweep`."""

    radius: float
    start: float
    sweep: float
    centre: complex = 0j

    def point(self, t: ArrayLike) -> Points:
        """Points at t."""
        return self.centre + self.radius * np.exp(
            1j * (self.start + self.sweep * np.asarray(t, dtype=np.float64))
        )

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t."""
        return (
            np.sign(self.sweep)
            * 1j
            * np.exp(1j * (self.start + self.sweep * np.asarray(t, dtype=np.float64)))
        )

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm²."""
        chord = np.exp(1j * (self.start + self.sweep)) - np.exp(1j * self.start)
        return float(self.radius**2 * self.sweep + self.radius * (np.conj(self.centre) * chord / 1j).real) / 2

    def rotated(self, angle: float) -> Self:
        """The curve turned about the origin by `angle` in rad."""
        return replace(self, start=self.start + angle, centre=complex(self.centre * np.exp(1j * angle)))


@dataclass(frozen=True, slots=True)
class Involute:
    """Involute r_b·exp(i(origin + hand·ξ))·(1 − i·hand·ξ) of the base circle, roll angle ξ from `roll_start` on.

    `hand` is +1 where the polar angle grows with the radius and −1 where it falls.
    """

    base_radius: float
    origin: float
    hand: int
    roll_start: float
    roll_end: float

    def _roll(self, t: ArrayLike) -> NDArray[np.float64]:
        return self.roll_start + (self.roll_end - self.roll_start) * np.asarray(t, dtype=np.float64)

    def point(self, t: ArrayLike) -> Points:
        """Points at t."""
        roll = self._roll(t)
        return self.base_radius * np.exp(1j * (self.origin + self.hand * roll)) * (1 - 1j * self.hand * roll)

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t; d(point)/dξ is r_b·ξ times the direction of the unwound base tangent's normal."""
        return np.sign(self.roll_end - self.roll_start) * np.exp(
            1j * (self.origin + self.hand * self._roll(t))
        )

    def swept_area(self) -> float:
        """½∫(x dy − y dx) = hand·r_b²·(ξ₂³ − ξ₁³)/6 in mm²."""
        return self.hand * self.base_radius**2 * (self.roll_end**3 - self.roll_start**3) / 6

    def rotated(self, angle: float) -> Self:
        """The curve turned about the origin by `angle` in rad."""
        return replace(self, origin=self.origin + angle)

    def mirrored(self) -> Self:
        """The curve mirrored in the x axis."""
        return replace(self, origin=-self.origin, hand=-self.hand)

    def reversed(self) -> Self:
        """The curve run from its end to its start."""
        return replace(self, roll_start=self.roll_end, roll_end=self.roll_start)


@dataclass(frozen=True, slots=True)
class Trochoid:
    """Root curve cut by the rounded tip of a rack: the envelope of a circle carried by the rolling rack.

    The circle of radius ρ has its centre at the depth d_c below the rack's pitch line. When the centre is at
    u = d_c·sinh q along that line from the pitch point, the common normal through the pitch point meets the
    circle at Q = (u + ρ·tanh q, r − d_c − ρ·sech q), and the gear has turned by u/r (law of gearing). The
    parameter q is the one in which polynomials follow the curve best; it covers d_c of either sign and zero.
    """

    reference_radius: float
    centre_depth: float
    tip_radius: float
    origin: float
    hand: int
    q_start: float
    q_end: float

    def _turned(self, t: ArrayLike) -> tuple[NDArray[np.float64], Points]:
        q = self.q_start + (self.q_end - self.q_start) * np.asarray(t, dtype=np.float64)
        return q, np.exp(
            1j * (self.origin + self.hand * self.centre_depth * np.sinh(q) / self.reference_radius)
        )

    def point(self, t: ArrayLike) -> Points:
        """Points at t."""
        q, turn = self._turned(t)
        along = self.centre_depth * np.sinh(q) + self.tip_radius * np.tanh(q)
        outward = self.reference_radius - self.centre_depth - self.tip_radius / np.cosh(q)
        return (outward - 1j * self.hand * along) * turn

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t: across the common normal."""
        q, turn = self._turned(t)
        return np.sign(self.q_end - self.q_start) * (np.tanh(q) - 1j * self.hand / np.cosh(q)) * turn

    def _speed(self, t: ArrayLike) -> NDArray[np.float64]:
        # The gear turns about the pitch point, at the distance d_c·cosh q + ρ from the contact, while the contact
        # walks along the circle of radius ρ.
        q = self.q_start + (self.q_end - self.q_start) * np.asarray(t, dtype=np.float64)
        reach = self.centre_depth * np.cosh(q)
        rate = self.tip_radius / np.cosh(q) + reach / self.reference_radius * (reach + self.tip_radius)
        return abs(self.q_end - self.q_start) * rate

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm² by Gauss-Legendre quadrature (`AREA_NODES`), exact to rounding."""
        node, weight = np.polynomial.legendre.leggauss(AREA_NODES)
        t = (node + 1) / 2
        integrand = (np.conj(self.point(t)) * self.tangent(t)).imag * self._speed(t)
        return float(weight @ integrand) / 4

    def rotated(self, angle: float) -> Self:
        """The curve turned about the origin by `angle` in rad."""
        return replace(self, origin=self.origin + angle)

    def mirrored(self) -> Self:
        """The curve mirrored in the x axis."""
        return replace(self, origin=-self.origin, hand=-self.hand)

    def reversed(self) -> Self:
        """The curve run from its end to its start."""
        return replace(self, q_start=self.q_end, q_end=self.q_start)


Curve = Line | Arc | Involute | Trochoid


def chord_parameters(curve: Curve, chord_tolerance: float) -> NDArray[np.float64]:
    """Parameters 0 = t_0 < … < t_n = 1 whose chords stay within `chord_tolerance` (mm) of the curve.

    The sag of a chord is κ·s²/8, so equal shares of ∫√κ ds give equal sags and the fewest chords.
    """
    if isinstance(curve, Line):
        return np.array([0.0, 1.0])
    t = np.linspace(0.0, 1.0, TURNING_SAMPLES)
    turning = np.abs(np.angle(curve.tangent(t[1:]) / curve.tangent(t[:-1])))
    share = np.concatenate(([0.0], np.cumsum(np.sqrt(turning * np.abs(np.diff(curve.point(t)))))))
    count = max(1, int(np.ceil(share[-1] / np.sqrt(8 * chord_tolerance))))
    while True:
        nodes = np.interp(np.linspace(0.0, share[-1], count + 1), share, t)
        if _sag(curve, nodes) <= chord_tolerance:
            return nodes
        count += 1


def _sag(curve: Curve, nodes: NDArray[np.float64]) -> float:
    """Largest distance between the chords at `nodes` and the curve, read at seven points of each chord."""
    inside = np.linspace(0.0, 1.0, 9)[1:-1, None]
    ends = curve.point(nodes)
    chord = np.diff(ends)
    points = curve.point(nodes[:-1] + inside * np.diff(nodes))
    return float(np.max(np.abs(((points - ends[:-1]) * np.conj(chord)).imag) / np.abs(chord)))


@dataclass(frozen=True, slots=True)
class Outline:
    """Closed counter-clockwise curve about the origin: `curves`, then their `repeats` − 1 copies turned on by 2π/repeats."""

    curves: tuple[Curve, ...]
    repeats: int = 1

    @property
    def radii(self) -> tuple[float, float]:
        """Least and greatest distance from the origin, in mm (read at `TURNING_SAMPLES` points of each curve)."""
        t = np.linspace(0.0, 1.0, TURNING_SAMPLES)
        distance = np.abs([curve.point(t) for curve in self.curves])
        return float(distance.min()), float(distance.max())

    @property
    def area(self) -> float:
        """Enclosed area in mm² by Green's theorem."""
        return self.repeats * sum(curve.swept_area() for curve in self.curves)

    def polygon(self, chord_tolerance: float) -> Points:
        """Corners, shape (n,), on the outline, whose chords stay within `chord_tolerance` (mm) of it."""
        pitch = np.concatenate(
            [curve.point(chord_parameters(curve, chord_tolerance)[:-1]) for curve in self.curves]
        )
        turns = np.exp(2j * np.pi / self.repeats * np.arange(self.repeats))
        return (turns[:, None] * pitch).ravel()
