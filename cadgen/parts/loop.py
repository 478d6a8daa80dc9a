"""Plane curves that bound a section of a part, and closed loops made of them.

Points are complex numbers x + iy in mm, so that turning by an angle is a product with exp(i·angle).
Every curve runs over a parameter t in [0, 1] and gives its points, its unit tangent and its share of the
enclosed area exactly. `chord_parameters` spaces points on any of them for a chord tolerance; `bezier_poles` gives
the Bézier curve within a tolerance, which is what a CAD kernel and a STEP file can hold.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from math import comb
from typing import Protocol, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from cadgen.arrays import gauss_nodes
from cadgen.curves.contour import Contour
from cadgen.curves.spacing import even_nodes, inside_spans
from cadgen.errors import DesignError
from cadgen.messages import Message
from cadgen.parts.run import STRAIGHT, HelixRun

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]

# Gauss-Legendre nodes of one trochoid: its integrand is analytic and 40 nodes reach rounding (1e-15).
AREA_NODES = 40
# Points of a chord at which its sag is read; the middle one meets the peak of an even bend.
CHORD_SAMPLES = 8
# Parameters at which radius and turning of a curve are read; ends and middle are among them.
SHARES = np.linspace(0.0, 1.0, 65)
# Decimals of a mm to which the arcs of a contour are rounded, far below any kernel's least distance: radius and centre
# come from chord and bulge, which leave some 1e-15 mm of noise on them.
ARC_DECIMALS = 12


def _share(start: float, end: float, t: ArrayLike) -> Reals:
    return start + (end - start) * np.asarray(t, dtype=np.float64)


def _unit(angle: ArrayLike) -> Points:
    """exp(i·angle)."""
    return np.asarray(np.exp(1j * np.asarray(angle)), dtype=np.complex128)


class PlaneCurve(Protocol):
    """A smooth curve over the parameter t from 0 to 1."""

    __slots__ = ()

    def point(self, t: ArrayLike) -> Points:
        """Points, mm.

        Args:
            t: parameters, 0 to 1.
        """

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangents.

        Args:
            t: parameters, 0 to 1.
        """

    def swept_area(self) -> float:
        """Area between the curve and the origin, ½∫(x dy − y dx), mm²."""

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin.

        Args:
            angle: angle, rad, counterclockwise.
        """


@dataclass(frozen=True, slots=True)
class Segment(PlaneCurve):
    """Straight line from `start` to `end`."""

    start: complex
    end: complex

    def point(self, t: ArrayLike) -> Points:
        """Points (mm) at parameters t, see `PlaneCurve`."""
        return np.asarray(self.start + (self.end - self.start) * np.asarray(t), dtype=np.complex128)

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t, see `PlaneCurve`."""
        step = self.end - self.start
        return np.full(np.shape(t), step / abs(step), dtype=np.complex128)

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm²."""
        return float((self.start.conjugate() * self.end).imag) / 2

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin, see `PlaneCurve`."""
        turn = complex(_unit(angle))
        return replace(self, start=self.start * turn, end=self.end * turn)


@dataclass(frozen=True, slots=True)
class Arc(PlaneCurve):
    """Circular arc about `centre`, from polar angle `start` through the signed angle `sweep`."""

    radius: float
    start: float
    sweep: float
    centre: complex = 0j

    def _angle(self, t: ArrayLike) -> Reals:
        return _share(self.start, self.start + self.sweep, t)

    def point(self, t: ArrayLike) -> Points:
        """Points (mm) at parameters t, see `PlaneCurve`."""
        return self.centre + self.radius * _unit(self._angle(t))

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t, see `PlaneCurve`."""
        return _unit(self._angle(t) + np.copysign(np.pi / 2, self.sweep))

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm²."""
        start, end = complex(self.point(0.0)), complex(self.point(1.0))
        moment = (self.centre.conjugate() * (end - start)).imag
        return float(self.radius**2 * self.sweep + moment) / 2

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin, see `PlaneCurve`."""
        return replace(self, start=self.start + angle, centre=self.centre * complex(_unit(angle)))


@dataclass(frozen=True, slots=True)
class EllipseArc(PlaneCurve):
    """Arc of an ellipse: half axes along the direction `turn` and across it, from the angle `start` by `sweep`."""

    half_axes: tuple[float, float]
    start: float
    sweep: float
    centre: complex = 0j
    turn: float = 0.0

    def point(self, t: ArrayLike) -> Points:
        """Points (mm) at parameters t, see `PlaneCurve`."""
        angle, (along, across) = _share(self.start, self.start + self.sweep, t), self.half_axes
        around = np.asarray(_unit(self.turn) * (along * np.cos(angle) + 1j * across * np.sin(angle)))
        return self.centre + around

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t, see `PlaneCurve`."""
        angle, (along, across) = _share(self.start, self.start + self.sweep, t), self.half_axes
        way = np.copysign(1.0, self.sweep) * _unit(self.turn) * (-along * np.sin(angle) + 1j * across * np.cos(angle))
        return np.asarray(way / np.abs(way))

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm²."""
        start, end = complex(self.point(0.0)), complex(self.point(1.0))
        moment = (self.centre.conjugate() * (end - start)).imag
        return float(self.half_axes[0] * self.half_axes[1] * self.sweep + moment) / 2

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin, see `PlaneCurve`."""
        return replace(self, turn=self.turn + angle, centre=self.centre * complex(_unit(angle)))


@dataclass(frozen=True, slots=True)
class Involute(PlaneCurve):
    """Involute r_b·exp(i(origin + hand·ξ))·(1 − i·hand·ξ) of the base circle over the roll angle ξ.

    `hand` is +1 where the polar angle grows with the radius and −1 where it falls.
    """

    base_radius: float
    origin: float
    hand: int
    roll_start: float
    roll_end: float

    def point(self, t: ArrayLike) -> Points:
        """Points (mm) at parameters t, see `PlaneCurve`."""
        roll = self.hand * _share(self.roll_start, self.roll_end, t)
        return self.base_radius * _unit(self.origin + roll) * (1 - 1j * roll)

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t, along d(point)/dξ = r_b·ξ·exp(i(origin + hand·ξ)); see `PlaneCurve`."""
        roll = self.hand * _share(self.roll_start, self.roll_end, t)
        return _unit(self.origin + roll) * float(np.sign(self.roll_end - self.roll_start))

    def swept_area(self) -> float:
        """½∫(x dy − y dx) = hand·r_b²·(ξ₂³ − ξ₁³)/6 in mm²."""
        return self.hand * self.base_radius**2 * (self.roll_end**3 - self.roll_start**3) / 6

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin, see `PlaneCurve`."""
        return replace(self, origin=self.origin + angle)

    def mirrored(self) -> Self:
        """The curve mirrored in the x axis."""
        return replace(self, origin=-self.origin, hand=-self.hand)

    def reversed(self) -> Self:
        """The curve run from its end to its start."""
        return replace(self, roll_start=self.roll_end, roll_end=self.roll_start)


@dataclass(frozen=True, slots=True)
class Trochoid(PlaneCurve):
    """Root curve cut by the rounded tip of a rack: the envelope of an ellipse carried by the rolling rack.

    The ellipse has the half axes ρ across the rack's pitch line and ρ/cos β along it, and its centre lies at the depth
    d_c below that line. It is the round tip of the normal section, seen in the transverse one; a spur gear's is a
    circle. Let τ be the direction of the normal in the normal section, and sinh q = cot τ. The common normal through
    the pitch point then meets the ellipse at Q = (cos β (d_c·sinh q + ρ·tanh q), r − d_c − ρ·sech q). The rack's centre
    is at u = cos β·d_c·sinh q − ρ·tanh q·(1/cos β − cos β) along the pitch line, and the gear has turned by u/r (law of
    gearing). In q polynomials of low degree follow the curve closely, and it serves d_c of either sign and zero.
    """

    reference_radius: float
    centre_depth: float
    tip_radius: float
    origin: float
    hand: int
    q_start: float
    q_end: float
    cos_helix: float = 1.0

    def _turn(self, q: Reals) -> Points:
        c = self.cos_helix
        centre = c * self.centre_depth * np.sinh(q) + self.tip_radius * (c - 1 / c) * np.tanh(q)
        rolled = centre / self.reference_radius
        return _unit(self.origin + self.hand * rolled)

    def _place(self, q: Reals) -> tuple[Reals, Reals]:
        """Contact along the pitch line and outwards, mm."""
        along = self.cos_helix * (self.centre_depth * np.sinh(q) + self.tip_radius * np.tanh(q))
        return along, self.reference_radius - self.centre_depth - self.tip_radius / np.cosh(q)

    def point(self, t: ArrayLike) -> Points:
        """Points (mm) at parameters t, see `PlaneCurve`."""
        q = _share(self.q_start, self.q_end, t)
        along, outward = self._place(q)
        return (outward - 1j * self.hand * along) * self._turn(q)

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t, across the common normal; see `PlaneCurve`."""
        q, sense = _share(self.q_start, self.q_end, t), float(np.sign(self.q_end - self.q_start))
        across = self.cos_helix * np.tanh(q) - 1j * self.hand / np.cosh(q)
        return self._turn(q) * (across if self.cos_helix == 1 else across / np.abs(across)) * sense

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm² by Gauss-Legendre quadrature (`AREA_NODES`), exact to rounding."""
        node, weight = gauss_nodes(AREA_NODES)
        t = (node + 1) / 2
        q = _share(self.q_start, self.q_end, t)
        if self.cos_helix == 1:
            # The gear turns about the pitch point, d_c·cosh q + ρ away from the contact, while the contact
            # walks along the circle of radius ρ.
            reach = self.centre_depth * np.cosh(q)
            rate = self.tip_radius / np.cosh(q) + reach / self.reference_radius * (reach + self.tip_radius)
            speed = abs(self.q_end - self.q_start) * rate
            integrand = (np.conj(self.point(t)) * self.tangent(t)).imag * speed
            return float(weight @ integrand) / 4
        c, sech = self.cos_helix, 1 / np.cosh(q)
        along, outward = self._place(q)
        place = outward - 1j * self.hand * along
        walk = self.tip_radius * sech * np.tanh(q)
        walk = walk - 1j * self.hand * c * (self.centre_depth * np.cosh(q) + self.tip_radius * sech**2)
        turning = c * self.centre_depth * np.cosh(q) + self.tip_radius * (c - 1 / c) * sech**2
        change = walk + 1j * self.hand * turning / self.reference_radius * place
        return float(weight @ (np.conj(place) * change).imag) * (self.q_end - self.q_start) / 4

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin, see `PlaneCurve`."""
        return replace(self, origin=self.origin + angle)

    def mirrored(self) -> Self:
        """The curve mirrored in the x axis."""
        return replace(self, origin=-self.origin, hand=-self.hand)

    def reversed(self) -> Self:
        """The curve run from its end to its start."""
        return replace(self, q_start=self.q_end, q_end=self.q_start)


@dataclass(frozen=True, slots=True)
class CutterTrochoid(PlaneCurve):
    """Root curve of an internal gear, cut by the rounded tip of a pinion cutter.

    The cutter's axis is `axes_apart` (a_0) from the gear's. Its tip is round with the radius ρ_0 about a point on the
    radius R_C of the cutter, at the polar angle ψ_C from the middle of a cutter's tooth. At the direction ν of the
    normal the tip's point is p = R_C·exp(iψ_C) + ρ_0·exp(iν). It cuts where that normal passes the pitch point (law of
    gearing), with the cutter at the angle θ = −arcsin(Im(exp(−iν)·p) / r_w0) − ν. The gear has then turned by z_0/z
    times as much, and the point is (a_0 + p·exp(iθ))·exp(−iθ z_0/z) in a space about the x axis. The parameter is q,
    with sinh q = tan(ν − ψ_C), in which polynomials of low degree follow the curve closely.
    """

    axes_apart: float
    pitch_radius: float
    teeth_ratio: float
    centre_radius: float
    centre_angle: float
    tip_radius: float
    origin: float
    hand: int
    start: float
    end: float

    def _at(self, t: ArrayLike) -> tuple[Points, Points]:
        """Points and their change with q in the space about the x axis, on the side of growing angles."""
        q = _share(*self._ends, t)
        nu = self.centre_angle + np.arctan(np.sinh(q))
        centre = self.centre_radius * np.exp(1j * self.centre_angle)
        seen = np.exp(-1j * nu) * centre
        share = seen.imag / self.pitch_radius
        angle = -np.arcsin(share) - nu
        turning = seen.real / self.pitch_radius / np.sqrt(1 - share**2) - 1
        arm = self.tip_radius * np.exp(1j * nu)
        spun, back = np.exp(1j * angle), np.exp(-1j * angle * self.teeth_ratio)
        whole = self.axes_apart + (centre + arm) * spun
        change = 1j * (turning * (centre + arm) + arm) * spun - 1j * turning * self.teeth_ratio * whole
        return whole * back, change * back / np.cosh(q)

    @property
    def _ends(self) -> tuple[float, float]:
        """Parameters q at both ends."""
        start, end = np.arcsinh(np.tan(np.array([self.start, self.end]) - self.centre_angle)).tolist()
        return start, end

    def point(self, t: ArrayLike) -> Points:
        """Points (mm) at parameters t, see `PlaneCurve`."""
        points, _ = self._at(t)
        return np.asarray((points if self.hand > 0 else np.conj(points)) * _unit(self.origin))

    def tangent(self, t: ArrayLike) -> Points:
        """Unit tangent at t, see `PlaneCurve`."""
        _, change = self._at(t)
        along = change / np.abs(change) * np.sign(self.end - self.start)
        return np.asarray((along if self.hand > 0 else np.conj(along)) * _unit(self.origin))

    def swept_area(self) -> float:
        """½∫(x dy − y dx) in mm² by Gauss-Legendre quadrature (`AREA_NODES`), exact to rounding."""
        node, weight = gauss_nodes(AREA_NODES)
        points, change = self._at((node + 1) / 2)
        start, end = self._ends
        return self.hand * float(weight @ (np.conj(points) * change).imag) * (end - start) / 4

    def rotated(self, angle: float) -> Self:
        """Curve turned about the origin, see `PlaneCurve`."""
        return replace(self, origin=self.origin + angle)

    def mirrored(self) -> Self:
        """The curve mirrored in the x axis."""
        return replace(self, origin=-self.origin, hand=-self.hand)

    def reversed(self) -> Self:
        """The curve run from its end to its start."""
        return replace(self, start=self.end, end=self.start)


Curve = Segment | Arc | EllipseArc | Involute | Trochoid | CutterTrochoid


def chord_parameters(curve: Curve, chord_tolerance: float) -> Reals:
    """Parameters 0 = t_0 < … < t_n = 1 whose chords stay within `chord_tolerance` (mm) of the curve.

    The sag of a chord grows with the square of its length, and the spacing makes all sags equal.

    Args:
        curve: curve, mm.
        chord_tolerance: greatest distance of a chord from the curve, mm.
    """
    if isinstance(curve, Segment):
        return np.array([0.0, 1.0])

    def sags(nodes: Reals) -> Reals:
        points = curve.point(inside_spans(nodes, CHORD_SAMPLES))
        inside, ends = points[:-1].reshape(-1, CHORD_SAMPLES), points[::CHORD_SAMPLES]
        chord = np.diff(ends)[:, None]
        across = ((inside - inside[:, :1]) * np.conj(chord / np.abs(chord))).imag
        return np.asarray(np.abs(across).max(axis=1))

    turning = np.abs(np.angle(curve.tangent(SHARES[1:]) / curve.tangent(SHARES[:-1]))).sum()
    return even_nodes(sags, (0.0, 1.0), chord_tolerance, 2, turn=float(turning))


@dataclass(frozen=True, slots=True)
class Loop:
    """Closed counter-clockwise curve: `curves` end to end, and their copies turned by 2π/`repeats`.

    `run` is how a wall of this section turns as it goes up.
    """

    curves: tuple[Curve, ...]
    repeats: int = 1
    run: HelixRun = STRAIGHT

    @property
    def radii(self) -> tuple[float, float]:
        """Least and greatest distance from the origin in mm, among the points at `SHARES` of each curve."""
        distance = np.abs([curve.point(SHARES) for curve in self.curves])
        return float(distance.min()), float(distance.max())

    @property
    def area(self) -> float:
        """Enclosed area in mm² by Green's theorem."""
        return self.repeats * sum(curve.swept_area() for curve in self.curves)

    def polygon(self, chord_tolerance: float) -> Points:
        """Corners, shape (n,), on the outline, whose chords stay within `chord_tolerance` (mm) of it.

        Args:
            chord_tolerance: greatest distance of a chord from the curve, mm.
        """
        pitch = np.concatenate([curve.point(chord_parameters(curve, chord_tolerance)[:-1]) for curve in self.curves])
        return np.asarray(np.outer(self.turns, pitch).ravel())

    @property
    def turns(self) -> Points:
        """exp(i·angle) of the copies, shape (repeats,)."""
        return _unit(2 * np.pi / self.repeats * np.arange(self.repeats))

    def rotated(self, angle: float) -> Loop:
        """The outline turned about the origin by `angle` in rad.

        Args:
            angle: angle, rad.
        """
        return replace(self, curves=tuple(curve.rotated(angle) for curve in self.curves))

    def from_below(self, width: float) -> Loop:
        """Section at the lower end of a wall whose section midway is this one; itself where the wall is a prism.

        Args:
            width: length of the wall, mm.
        """
        return self if self.run.straight else self.rotated(-self.run.angle(width / 2))


def circle(diameter: float, centre: complex = 0j) -> Loop:
    """Circle of `diameter` (mm) as a loop.

    Args:
        diameter: diameter, mm.
        centre: centre, x + iy, mm.
    """
    return Loop((Arc(diameter / 2, 0.0, 2 * np.pi, centre),))


def loop_of(contour: Contour) -> Loop:
    """A counterclockwise contour of lines and arcs as a loop, begun with its second side.

    A bore's first side is its arc, so that the loop begins with the keyway or the flat.

    Args:
        contour: contour, counterclockwise.
    """
    count, sides = len(contour.bulges), list[Segment | Arc]()
    for number in (*range(1, count), 0):
        start, end = (complex(*contour.vertices[k % len(contour.vertices)]) for k in (number, number + 1))
        if contour.bulges[number] == 0:
            sides.append(Segment(start, end))
            continue
        centre = complex(*np.round(contour.centers[number], ARC_DECIMALS))
        radius = round(float(contour.radii[number]), ARC_DECIMALS)
        sides.append(Arc(radius, float(np.angle(start - centre)), float(contour.sweeps[number]), centre))
    return Loop(tuple(sides))


# Degree 5 carries a whole flank and degree 8 a whole root of usual size; beyond 20 the pole matrix loses digits.
LOWEST_DEGREE = 3
HIGHEST_DEGREE = 20
# The deviation is read at this many parameters: several between neighbouring zeros of the error.
DEVIATION_SAMPLES = 101


def bernstein(degree: int, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein polynomials as a matrix of shape (n, degree + 1).

    Args:
        degree: degree of the polynomials.
        t: parameters, 0 to 1, shape (n,).
    """
    i, column = np.arange(degree + 1), t[:, None]
    binomials = np.array([comb(degree, k) for k in range(degree + 1)], dtype=np.float64)
    return np.asarray(binomials * column**i * (1 - column) ** (degree - i))


@lru_cache(maxsize=HIGHEST_DEGREE)
def _bezier_basis(degree: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
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
        nodes, to_poles, at_samples = _bezier_basis(degree)
        poles = to_poles @ curve.point(nodes)
        if isinstance(curve, CutterTrochoid):  # whose ends are those of its neighbours, to the last digit
            poles[[0, -1]] = curve.point([0.0, 1.0])
        deviation = float(np.max(np.abs(((at_samples @ poles - exact) * np.conj(tangent)).imag)))
        if deviation <= tolerance:
            return np.asarray(poles)
    raise DesignError(
        "a tooth curve cannot be drawn within {tolerance:g} µm (degree {highest_degree} leaves {deviation:g} "
        "µm); {cure}",
        cure=Message("give the ring cutter_teeth = 0, for a root that is an arc")
        if isinstance(curve, CutterTrochoid)
        else Message("choose a smaller module"),
        tolerance=tolerance * 1e3,
        highest_degree=HIGHEST_DEGREE,
        deviation=deviation * 1e3,
    )
