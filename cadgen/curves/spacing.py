"""Nodes along a smooth piece, spaced so that every span of an approximation has the same error."""

from collections.abc import Callable

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.closed import Piece, cross
from cadgen.errors import DesignError

_FIRST_SPANS = 32
_QUARTER = np.pi / 2  # a span turns by no more, so that its arcs exist and never double back
_ROUNDS = 3  # each brings the shares nearer to even; the count settles within a few per cent
_REPAIRS = 40  # rounds after that, for the last spans that miss the tolerance by a little
_SEEN = 0.97  # share of a span's largest error that eight samples of each hump see at least
_AIM = 0.95  # of what is allowed, so that not every second span misses it
_MORE = 1.05  # times as many spans in each repair that moves all nodes
_WIDEN = 0.25  # a span is widened to four times at most in a round: its error may be zero by chance


def even_nodes(
    errors: Callable[[Array], Array],
    ends: tuple[float, float],
    tolerance: float,
    order: int,
    *,
    turn: float = 0.0,
    local: bool = True,
) -> Array:
    """Return about the fewest nodes between which no span's error exceeds the tolerance.

    A span of error e is due to be cut into (e / tolerance)^(1 / order) spans; laying these shares end to end and
    cutting the sum evenly gives the next nodes (equidistribution: de Boor, A Practical Guide to Splines,
    chapter XII).

    Args:
        errors: function of nodes, shape (n + 1,), that returns the largest error in each span, shape (n,), on eight
            samples of each hump or more.
        ends: first and last node.
        tolerance: allowed error, in the unit of `errors`.
        order: power of the span's width with which the error falls.
        turn: angle by which the whole turns, rad: there are as many spans as right angles in it, at least, so that
            even a curve smaller than the tolerance keeps its shape.
        local: whether the error of a span depends on that span alone. If not, as in a spline, the widths of
            neighbours must change gently, or the order is lost.

    Raises:
        DesignError: the tolerance is not reached, because it is finer than rounding.
    """
    at_least = max(1, int(np.ceil(turn / _QUARTER)))
    nodes = np.linspace(*ends, max(_FIRST_SPANS, at_least) + 1)
    allowed, more = _SEEN * tolerance, 1.0
    for number in range(_ROUNDS + _REPAIRS):
        error = errors(nodes)
        shares = more * np.maximum((error / (_AIM * allowed)) ** (1 / order), _WIDEN)
        if not local:
            # The density by the parameter is the average of three neighbours, weighted 1, 2, 1.
            widths = np.diff(nodes)
            density = np.pad(shares / widths, 1, mode="edge")
            shares = (density[:-2] + 2 * density[1:-1] + density[2:]) / 4 * widths
        laid = np.concatenate([[0.0], np.cumsum(shares)])
        count = max(at_least, int(np.ceil(laid[-1])))
        kept, settled = error.max() <= allowed, number >= _ROUNDS
        if kept and (settled or count >= len(shares)):
            return nodes
        if settled and local:
            wide = np.flatnonzero(error > allowed)
            nodes = np.insert(nodes, wide + 1, (nodes[wide] + nodes[wide + 1]) / 2)
        else:
            more *= _MORE if settled else 1.0
            nodes = np.interp(np.linspace(0, laid[-1], count + 1), laid, nodes)
    raise DesignError(
        "the curve cannot be followed within {tolerance:g} µm: raise the tolerances in the design's [export]",
        tolerance=tolerance * 1e3,
    )


def inside_spans(nodes: Array, count: int) -> Array:
    """Each span cut in `count`: parameters, shape (n * count + 1,), every `count`-th of them a node.

    Args:
        nodes: parameters of the spans' ends, rising, shape (n + 1,).
        count: number of parts of each span.
    """
    shares = np.arange(count) / count
    inner = nodes[:-1, None] + np.diff(nodes)[:, None] * shares
    return np.append(inner.ravel(), nodes[-1])


def turning(piece: Piece, samples: int = 65) -> float:
    """Sum of the angles by which the piece's tangent turns to either side, rad."""
    velocity = piece.jet(np.linspace(piece.start, piece.stop, samples)).velocity
    before, after = velocity[:-1], velocity[1:]
    return float(np.abs(np.arctan2(cross(before, after), np.sum(before * after, axis=1))).sum())
