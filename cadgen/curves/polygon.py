"""A closed curve as a polygon within a stated chord tolerance."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.chamfer import Apex, Strip
from cadgen.curves.closed import ClosedCurve, Outline, Piece, left_normal
from cadgen.curves.spacing import even_nodes, inside_spans, turning

_SAMPLES = 8  # of a chord; the middle one meets the peak of an even bend


def polygon(curve: ClosedCurve, chord_tolerance: float) -> Array:
    """Return points on the curve whose chords stay within `chord_tolerance` mm of it on either side.

    A chord of length h strays by curvature h^2 / 8, so the number of points grows as tolerance^(-1/2).
    Corners of the curve are among the points.

    Args:
        curve: closed curve, mm.
        chord_tolerance: greatest distance of a chord from the curve, mm.

    Returns:
        Points in order, counterclockwise, shape (n, 2), mm; the first is not repeated.
    """
    points = []
    for piece in curve.pieces:
        sagittas = partial(_sagittas, piece)
        nodes = even_nodes(sagittas, (piece.start, piece.stop), chord_tolerance, 2, turn=turning(piece))
        points.append(piece.jet(nodes[:-1]).point)
    return np.concatenate(points)


def strip_polygons(strips: Sequence[Strip], chord_tolerance: float) -> tuple[Array, Array]:
    """Return points on both sides of a chamfer, pair by pair at equal shares of its strips.

    The chords of both stay within `chord_tolerance` mm of their curves.

    Args:
        strips: strips of the chamfer.
        chord_tolerance: greatest distance of a chord from the curve, mm.

    Returns:
        Outer and inner points in order, counterclockwise, shape (n, 2) each, mm; the first is not repeated. Where one
        side is a point, it is repeated.
    """
    outer: list[Array] = []
    inner: list[Array] = []
    for strip in strips:
        nodes = _even((strip.outer, strip.inner), chord_tolerance)
        for side, points in ((strip.outer, outer), (strip.inner, inner)):
            points.append(side.jet(side.start + nodes[:-1] * (side.stop - side.start)).point)
    return np.concatenate(outer), np.concatenate(inner)


def polyline(corners: Array, step: float) -> Outline:
    """The closed chain of straight lines through points, each a piece of at least five points.

    Args:
        corners: points in counterclockwise order, the first not repeated, shape (n, 2), mm.
        step: greatest distance between the points of the result, mm.
    """
    chords = np.roll(corners, -1, axis=0) - corners
    counts = np.maximum(5, np.ceil(np.linalg.norm(chords, axis=1) / step).astype(int) + 1)
    piece = np.repeat(np.arange(len(corners)), counts)
    share = (np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts)) / (counts[piece] - 1)
    return Outline(corners[piece] + share[:, None] * chords[piece], piece)


def _even(sides: Sequence[Piece], tolerance: float) -> Array:
    """Shares of pieces at which their points are to stand together."""
    real = [side for side in sides if not isinstance(side, Apex)]

    def sagittas(shares: Array) -> Array:
        each = [_sagittas(side, side.start + shares * (side.stop - side.start)) for side in real]
        return np.asarray(np.max(each, axis=0))

    return even_nodes(sagittas, (0.0, 1.0), tolerance, 2, turn=max(map(turning, real)))


def _sagittas(piece: Piece, nodes: Array) -> Array:
    """Greatest distance of the chord of each span from the piece, shape (n,), mm."""
    points = piece.jet(inside_spans(nodes, _SAMPLES)).point
    chords = np.diff(points[::_SAMPLES], axis=0)
    inside = points[:-1].reshape(-1, _SAMPLES, 2)
    off = np.einsum("cpj,cj->cp", inside - inside[:, :1], left_normal(chords))
    return np.asarray(np.abs(off).max(axis=1))
