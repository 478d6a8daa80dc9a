"""A closed curve as B-splines within a stated tolerance."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from scipy.interpolate import BSpline, CubicSpline, PPoly, make_interp_spline

from cadgen.arrays import Array
from cadgen.curves.chamfer import Apex, Strip
from cadgen.curves.closed import ClosedCurve, Jet, Piece, PieceSpan, left_normal
from cadgen.curves.spacing import even_nodes, inside_spans, turning

Degree = Literal[3, 5]

_SAMPLES = 8  # of a span between two knots
_TABLE = 1025  # samples of a part from which its arc length is integrated
# CAD kernels integrate a face with one closed edge badly, so no edge turns by more than this, and an outline
# has three edges at least.
_LONGEST_TURN = np.radians(125)


@dataclass(frozen=True)
class SplineArc:
    """A B-spline clamped at both ends, by a parameter close to its arc length.

    Attributes:
        degree: degree of the polynomials.
        knots: knots of the spline, shape (n + degree + 1,), mm, the first and the last degree + 1 of them equal.
        control_points: control points, shape (n, 2), mm; the first and the last lie on the curve.
    """

    degree: int
    knots: Array
    control_points: Array

    def point(self, s: Array) -> Array:
        """Points at parameters within the knots, shape (m, 2), mm.

        Args:
            s: parameters within the knots, shape (m,).
        """
        return np.asarray(BSpline(self.knots, self.control_points, self.degree)(s))


@dataclass(frozen=True)
class _Part:
    """A smooth piece, or a share of one, with its arc length by the piece's parameter."""

    piece: Piece
    start: float
    stop: float
    arc: PPoly

    @classmethod
    def of(cls, piece: Piece, start: float, stop: float) -> "_Part":
        t = np.linspace(start, stop, _TABLE)
        speed = np.linalg.norm(piece.jet(t).velocity, axis=1)
        return cls(piece, start, stop, CubicSpline(t, speed).antiderivative())


def splines(curve: ClosedCurve, tolerance: float, degree: Degree) -> tuple[SplineArc, ...]:
    """Return B-splines, end to end, that are nowhere further than `tolerance` mm from the curve.

    Each smooth piece, cut where it turns too far for one edge, is interpolated at even errors, with the exact
    direction and, for degree 5, the exact curvature at its ends. The parameter is the arc length: the curve
    is smoother by it than by the cam angle. Corners stay corners, and neighbours share their ends bit for
    bit.

    Args:
        curve: closed curve, mm.
        tolerance: greatest distance from the curve, mm.
        degree: degree of the splines, 3 or 5.
    """
    parts = []
    for piece in curve.pieces:
        edges = np.linspace(piece.start, piece.stop, max(1, int(np.ceil(turning(piece) / _LONGEST_TURN))) + 1)
        parts += [_Part.of(piece, float(a), float(b)) for a, b in pairwise(edges)]
    joints = [np.asarray(part.piece.jet(np.array([part.start])).point[0]) for part in parts]
    return tuple(
        _fit(part, first, last, tolerance, degree)
        for part, first, last in zip(parts, joints, joints[1:] + joints[:1], strict=True)
    )


def ruled_splines(strips: Sequence[Strip], tolerance: float, degree: Degree) -> tuple[tuple[SplineArc, SplineArc], ...]:
    """Return both sides of a chamfer's strips as B-splines on the same knots, so that lines join equal parameters.

    Neither side is further than `tolerance` mm from its curve. Otherwise as `splines`; a side that is a point has
    that point for all its control points.

    Args:
        strips: strips of the chamfer.
        tolerance: greatest distance from the curve, mm.
        degree: degree of the splines, 3 or 5.
    """
    parts = [part for strip in strips for part in _cut(strip)]
    firsts = [[side.jet(np.array([side.start])).point[0] for side in (part.outer, part.inner)] for part in parts]
    return tuple(
        _fit_both(part, first, last, tolerance, degree)
        for part, first, last in zip(parts, firsts, firsts[1:] + firsts[:1], strict=True)
    )


def _cut(strip: Strip) -> list[Strip]:
    """A strip in as many shares as the edges that its longer side needs."""
    most = max(turning(side) for side in (strip.outer, strip.inner) if not isinstance(side, Apex))
    shares = np.linspace(0.0, 1.0, max(1, int(np.ceil(most / _LONGEST_TURN))) + 1)

    def cut(side: Piece) -> list[Piece]:
        edges = side.start + shares * (side.stop - side.start)
        return [side if isinstance(side, Apex) else PieceSpan(side, float(a), float(b)) for a, b in pairwise(edges)]

    return [Strip(outer, inner) for outer, inner in zip(cut(strip.outer), cut(strip.inner), strict=True)]


def _fit_both(
    strip: Strip, first: Sequence[Array], last: Sequence[Array], tolerance: float, degree: Degree
) -> tuple[SplineArc, SplineArc]:
    """Splines of both sides by the arc length of the outer one, or of the inner one where the outer one is a point."""
    sides = (strip.inner, strip.outer) if isinstance(strip.outer, Apex) else (strip.outer, strip.inner)
    lead, other = sides
    part = _Part.of(lead, lead.start, lead.stop)
    scale = (other.stop - other.start) / (lead.stop - lead.start)

    def beside(t: Array) -> tuple[Array, Array]:
        """Points of the other side, and their velocity by the leading one's arc length."""
        jet = other.jet(other.start + (t - lead.start) * scale)
        speed = np.linalg.norm(lead.jet(t).velocity, axis=1)
        return jet.point, jet.velocity * (scale / speed)[:, None]

    table = np.linspace(lead.start, lead.stop, _TABLE)
    velocity = CubicSpline(part.arc(table), beside(table)[1])
    ends = tuple(
        [(order + 1, velocity(s, order)) for order in range(degree // 2)] for s in part.arc([lead.start, lead.stop])
    )

    def both(nodes: Array) -> tuple[BSpline, BSpline]:
        arc = part.arc(nodes)
        # The stubs know no boundary conditions by order and value.
        follows = make_interp_spline(arc, beside(nodes)[0], k=degree, bc_type=ends)  # type: ignore[arg-type]
        return _interpolate(arc, lead.jet(nodes), degree), follows

    def errors(nodes: Array) -> Array:
        t = inside_spans(nodes, _SAMPLES)
        jet, s = lead.jet(t), part.arc(t)
        leads, follows = both(nodes)
        off = np.abs(np.sum((leads(s) - jet.point) * left_normal(jet.velocity), axis=1))
        if not isinstance(other, Apex):
            # Along the curve the two sides may slip by a trifle: only what is square to it counts.
            point, along = beside(t)
            off = np.maximum(off, np.abs(np.sum((follows(s) - point) * left_normal(along), axis=1)))
        return np.asarray(off[:-1].reshape(-1, _SAMPLES).max(axis=1))

    nodes = even_nodes(errors, (lead.start, lead.stop), tolerance, degree + 1, local=False)
    arcs = {}
    for side, spline in zip(sides, both(nodes), strict=True):
        at = 0 if side is strip.outer else 1
        control_points = spline.c.copy()
        control_points[0], control_points[-1] = first[at], last[at]
        if isinstance(side, Apex):
            control_points[:] = side.point
        arcs[at] = SplineArc(degree, spline.t, control_points)
    return arcs[0], arcs[1]


def _fit(part: _Part, first: Array, last: Array, tolerance: float, degree: Degree) -> SplineArc:
    def errors(nodes: Array) -> Array:
        t = inside_spans(nodes, _SAMPLES)
        jet = part.piece.jet(t)
        spline = _interpolate(part.arc(nodes), Jet(*(column[::_SAMPLES] for column in jet)), degree)
        # To second order in the tiny distance along the curve, this is the distance to the curve.
        off = np.sum((spline(part.arc(t)) - jet.point) * left_normal(jet.velocity), axis=1)
        return np.asarray(np.abs(off[:-1]).reshape(-1, _SAMPLES).max(axis=1))

    nodes = even_nodes(errors, (part.start, part.stop), tolerance, degree + 1, local=False)
    spline = _interpolate(part.arc(nodes), part.piece.jet(nodes), degree)
    control_points = spline.c.copy()
    control_points[[0, -1]] = first, last
    return SplineArc(degree, spline.t, control_points)


def _interpolate(arc: Array, jet: Jet, degree: Degree) -> BSpline:
    """The spline through points by arc length, with the end's direction and (degree 5) curvature."""
    normal = left_normal(jet.velocity)
    tangent = np.stack([normal[:, 1], -normal[:, 0]], axis=1)
    bend = jet.curvature[:, None] * normal
    first, last = ([(1, tangent[end]), (2, bend[end])][: degree // 2] for end in (0, -1))
    # The stubs know no boundary conditions by order and value.
    return make_interp_spline(arc, jet.point, k=degree, bc_type=(first, last))  # type: ignore[arg-type]
