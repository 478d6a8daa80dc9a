"""A closed curve as lines and circular arcs within a stated tolerance."""

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, Piece, cross
from cadgen.curves.contour import Contour
from cadgen.curves.spacing import even_nodes, inside_spans, turning

_SAMPLES = 16  # of a span: eight to an arc, whose error is a single hump
_SAME = 1e-9  # mm; arcs of one span that lie on one circle, or on a line, within this are joined


def arcs(curve: ClosedCurve, tolerance: float) -> Contour:
    """Return a chain of lines and arcs that is nowhere further than `tolerance` mm from the curve.

    Each smooth piece becomes biarcs: two arcs that meet each other with a common tangent, halfway between
    their control points, and meet the curve at both ends of the span with its exact point and tangent. Their
    error is |d curvature / d arc| h^3 / 324 over a span of length h (Meek and Walton, Approximating smooth
    planar curves by arc splines, J. Comput. Appl. Math. 59, 1995), so the number of arcs grows as
    tolerance^(-1/3). Corners of the curve stay corners.

    Args:
        curve: closed curve, mm.
        tolerance: greatest distance from the curve, mm.
    """

    def chain(piece: Piece) -> tuple[Array, Array]:
        ends = piece.start, piece.stop
        nodes = even_nodes(lambda t: _Biarcs(piece, t).errors(), ends, tolerance, 3, turn=turning(piece))
        return _Biarcs(piece, nodes).chain()

    return Contour(*(np.concatenate(parts) for parts in zip(*map(chain, curve.pieces), strict=True)))


class _Biarcs:
    """The biarcs over all spans between nodes, and the curve's points inside the spans."""

    def __init__(self, piece: Piece, nodes: Array) -> None:
        jet = piece.jet(inside_spans(nodes, _SAMPLES))
        self.inside = jet.point[:-1].reshape(-1, _SAMPLES, 2)[:, 1:]
        ends, tangents = jet.point[::_SAMPLES], jet.velocity[::_SAMPLES]
        tangents = tangents / np.linalg.norm(tangents, axis=1, keepdims=True)
        self.start, self.stop, self.leaving, self.arriving = ends[:-1], ends[1:], tangents[:-1], tangents[1:]
        # Control points d ahead of the start and d behind the end, 2 d apart (Bolton, Biarc curves, 1975).
        v, both = self.stop - self.start, self.leaving + self.arriving
        vt, vv = np.sum(v * both, axis=1), np.sum(v * v, axis=1)
        d = vv / (vt + np.sqrt(vt**2 + np.sum((self.leaving - self.arriving) ** 2, axis=1) * vv))
        first, second = self.start + d[:, None] * self.leaving, self.stop - d[:, None] * self.arriving
        self.joint, self.through = (first + second) / 2, second - first

    def errors(self) -> Array:
        """Largest distance of the curve from its biarc in each span, mm."""
        begins = np.sum((self.inside - self.joint[:, None]) * self.through[:, None], axis=2) < 0
        # Both arcs are measured from their outer ends, the second one run backwards.
        ahead = _off_circle(self.inside, self.start, self.leaving, self.joint)
        behind = _off_circle(self.inside, self.stop, -self.arriving, self.joint)
        return np.asarray(np.abs(np.where(begins, ahead, behind)).max(axis=1))

    def chain(self) -> tuple[Array, Array]:
        """Vertices and bulges; two arcs of the same circle become a single arc."""
        first, second = self.joint - self.start, self.stop - self.joint
        sweeps = np.stack([2 * _angle(self.leaving, first), 2 * _angle(second, self.arriving)], axis=1)
        off_joint = _off_circle(self.joint[:, None], self.start, self.leaving, self.stop)[:, 0]
        joined = np.abs(off_joint) < _SAME
        sweeps[joined, 0] += sweeps[joined, 1]
        vertices = np.stack([self.start, self.joint], axis=1)
        bulges = np.tan(sweeps / 4)
        keep = np.ones(bulges.shape, dtype=bool)
        keep[joined, 1] = False
        vertices, bulges = vertices[keep], bulges[keep]
        chords = np.linalg.norm(np.diff(np.vstack([vertices, self.stop[-1:]]), axis=0), axis=1)
        return vertices, np.where(np.abs(bulges) * chords / 2 < _SAME, 0.0, bulges)


def _off_circle(points: Array, start: Array, tangent: Array, stop: Array) -> Array:
    """Signed distance of points from the circle that leaves `start` along `tangent` to `stop`, shape (n, m).

    With curvature k and left normal n it is p / (1 + sqrt(1 + k p)), p = k q.q - 2 q.n for q from the start:
    no distant centre enters, and a line is the case k = 0.
    """
    chord = stop - start
    k = (2 * cross(tangent, chord) / np.sum(chord**2, axis=1))[:, None]
    q = points - start[:, None]
    power = k * np.sum(q**2, axis=2) - 2 * cross(tangent[:, None], q)
    return np.asarray(power / (1 + np.sqrt(np.maximum(k * power + 1, 0.0))))


def _angle(before: Array, after: Array) -> Array:
    return np.asarray(np.arctan2(cross(before, after), np.sum(before * after, axis=1)))
