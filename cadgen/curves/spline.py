"""A closed curve as B-splines within a stated tolerance."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline, CubicSpline, PPoly, make_interp_spline

from cadgen.curves.closed import ClosedCurve, Jet, Piece, left_normal
from cadgen.curves.spacing import even_nodes, inside_spans, turning

Array = NDArray[np.float64]
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
        degree: of the polynomials.
        knots: shape (n + degree + 1,), mm, the first and the last degree + 1 of them equal.
        control_points: shape (n, 2), mm; the first and the last lie on the curve.
    """

    degree: int
    knots: Array
    control_points: Array

    def point(self, s: Array) -> Array:
        """Points at parameters within the knots, shape (m, 2), mm."""
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

    def first_point(self) -> Array:
        return np.asarray(self.piece.jet(np.array([self.start])).point[0])


def splines(curve: ClosedCurve, tolerance: float, degree: Degree) -> tuple[SplineArc, ...]:
    """Return B-splines, end to end, that are nowhere further than `tolerance` mm from the curve.

    Each smooth piece, cut where it turns too far for one edge, is interpolated at even errors, with the exact
    direction and, for degree 5, the exact curvature at its ends. The parameter is the arc length: the curve
    is smoother by it than by the cam angle. Corners stay corners, and neighbours share their ends bit for
    bit.
    """
    parts = [part for piece in curve.pieces for part in _parts(piece)]
    joints = [part.first_point() for part in parts]
    return tuple(
        _fit(part, first, last, tolerance, degree)
        for part, first, last in zip(parts, joints, joints[1:] + joints[:1], strict=True)
    )


def _parts(piece: Piece) -> list[_Part]:
    count = max(1, int(np.ceil(turning(piece) / _LONGEST_TURN)))
    edges = np.linspace(piece.start, piece.stop, count + 1)
    return [_Part.of(piece, float(a), float(b)) for a, b in pairwise(edges)]


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
