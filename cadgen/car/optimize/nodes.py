"""A lift taken apart into nodes with jets, changed there, and put together again.

A quintic is fixed by value, slope and second derivative at both ends, so the lift's own nodes give it back exactly.
"""

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.path_motion import PathMotion
from cadgen.curves.piecewise import quintic_hermite

KINK = 1e-6  # a jump of d tan(beta)/d theta below this turns the outline by less than 1e-6 rad: no kink
SIDE = 1e-12  # rad; how far beside a node its one-sided jets are taken


def nodes_between(
    lift: PathMotion, start: float, stop: float, *, ahead: float = 0.0, widest: float = TURN
) -> tuple[Array, Array]:
    """Nodes of the lift over a span, turned ahead.

    Args:
        lift: any closed lift.
        start: first cam angle of the span, rad; any turn.
        stop: last cam angle, rad.
        ahead: angle added to the angles of the result, rad.
        widest: greatest distance of neighbouring nodes, rad; nodes are added where the lift's are further apart.

    Returns:
        Cam angles, shape (n,), each inner one twice, and jets of tan(beta) from either side, shape (n, 3).
    """
    turns = TURN * np.arange(np.floor(start / TURN), np.ceil(stop / TURN))
    breaks = np.unique((lift.q.x[:-1] + turns[:, None]).ravel())
    inner = breaks[(breaks > start + 2 * SIDE) & (breaks < stop - 2 * SIDE)]
    ends = np.concatenate([[start], inner, [stop]])
    parts = np.ceil(np.diff(ends) / widest).astype(int)
    span = np.repeat(np.arange(len(parts)), parts)
    part = np.arange(len(span)) - np.repeat(np.cumsum(parts) - parts, parts) + 1
    within = part * (np.diff(ends) / parts)[span] + ends[span]
    inner = np.where(part == parts[span], ends[span + 1], within)[:-1]
    x = np.concatenate([[start], np.repeat(inner, 2), [stop]])
    side = np.concatenate([[SIDE], np.tile([-SIDE, SIDE], len(inner)), [-SIDE]])
    jets = np.stack([lift.q(x + side, nu=order) for order in range(3)], axis=1)
    return x + ahead, jets


def closed_lift(x: Array, jets: Array, blend_start: float) -> PathMotion:
    """A closed lift through nodes that run once round from anywhere in the first turn, cut again at 0.

    Args:
        x: cam angles, shape (n,), not decreasing, over one turn; a node that stands twice has a jet on either side.
        jets: tan(beta) with two derivatives, shape (n, 3).
        blend_start: cam angle at which the closing blend of the result starts, rad.
    """
    unrolled = quintic_hermite(x, jets, periodic=True)
    seam = np.stack([unrolled(TURN, nu=order) for order in range(3)])
    late = x > TURN
    nodes = np.concatenate([[0.0], x[late] - TURN, x[~late], [TURN]])
    jets = np.concatenate([[seam], jets[late], jets[~late], [seam]])
    kinks = nodes[:-1][(np.diff(nodes) == 0) & (np.abs(np.diff(jets[:, 1])) > KINK)]
    return PathMotion(q=quintic_hermite(nodes, jets, periodic=True), kinks=kinks, blend_start=blend_start)
