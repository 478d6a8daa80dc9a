"""The parallel curve inside a closed curve, and the 45 degree chamfer between the two.

A chamfer of leg c on the edge of a prism runs from the outline, at depth c, to the parallel curve c inside it, on the
face. Every smooth piece is moved exactly; at a convex corner the moved pieces are cut off where they cross, and at a
hollow one an arc about the corner joins them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees, tan

import numpy as np

from cadgen.arrays import Array, gauss_nodes
from cadgen.curves.closed import ClosedCurve, Jet, Piece, PieceSpan, left_normal, polar_angle
from cadgen.curves.derived import CornerArc, OffsetPiece, sharpest
from cadgen.errors import CheckError

_SNAP = 1e-5  # mm; moved pieces whose ends are no further apart than this are joined as they are
_NEWTON_STEPS = 30
_CONVERGED = 1e-11  # mm between two moved pieces where they cross
_GAUSS_POINTS, _GAUSS_STEPS = 6, 360  # per radian


@dataclass(frozen=True)
class Apex:
    """A piece that has shrunk to a point."""

    point: Array
    start: float = 0.0
    stop: float = 1.0

    def jet(self, t: Array) -> Jet:
        """The point, without a direction.

        Args:
            t: parameters of the points, shape (n,).
        """
        return Jet(np.tile(self.point, (len(t), 1)), np.zeros((len(t), 2)), np.zeros(len(t)))


@dataclass(frozen=True)
class Strip:
    """Smooth part of a chamfer: straight lines join points at equal shares of both pieces' parameters.

    Attributes:
        outer: piece of the outline; an `Apex` at a hollow corner.
        inner: piece of the curve inside it; an `Apex` where nothing of a short outer piece is left there.
    """

    outer: Piece
    inner: Piece

    def within(self, t: Array) -> Array:
        """Parameters of `inner` for parameters t of `outer`.

        Args:
            t: parameters of `outer`, shape (n,).
        """
        share = (t - self.outer.start) / (self.outer.stop - self.outer.start)
        return np.asarray(self.inner.start + share * (self.inner.stop - self.inner.start))

    def jets(self, t: Array) -> tuple[Jet, Jet]:
        """Jets of both pieces at parameters of `outer`, each with its velocity by its own parameter.

        Args:
            t: parameters of `outer`, shape (n,).
        """
        return self.outer.jet(t), self.inner.jet(self.within(t))


def chamfer_strips(curve: ClosedCurve, leg: float) -> tuple[Strip, ...]:
    """The chamfer of a leg of `leg` mm along a counterclockwise curve, strip after strip.

    The strips' inner pieces, end to end, are the parallel curve inside. Beside a convex corner of angle d the lines
    stand askew by leg tan(d / 2) along the curve at most. They leave the true chamfer by the square of that times the
    curve's curvature over 8: 20 nm at a corner of 17 degrees with a leg of 0.5 mm.

    Args:
        curve: closed curve, mm.
        leg: leg of the chamfer, mm.

    Raises:
        CheckError: the curve is convex somewhere with a radius of no more than the leg, or so narrow that nothing is
            left inside it.
    """
    strips = _moved_inwards(curve, leg)
    alive = list(range(len(strips)))
    spans = [[strip.inner.start, strip.inner.stop] for strip in strips]
    number = 0
    while number < len(alive):
        before, after = alive[number - 1], alive[number]
        dead = _trim(strips, spans, before, after)
        if dead is None:
            number += 1
            continue
        # The neighbours meet each other now: begin again at their joint.
        for neighbour in (before, after):
            if neighbour != dead:
                spans[neighbour] = [strips[neighbour].inner.start, strips[neighbour].inner.stop]
        alive.remove(dead)
        number = 0
    chamfer = []
    for index, strip in enumerate(strips):
        if index in alive:
            chamfer.append(Strip(strip.outer, PieceSpan(strip.inner, *spans[index])))
        elif alive and not isinstance(strip.outer, Apex):
            following = next((k for k in alive if k > index), alive[0])
            meeting = strips[following].inner.jet(np.array([spans[following][0]])).point[0]
            chamfer.append(Strip(strip.outer, Apex(meeting)))
    # The curve inside must run once round the origin: it does not where two flanks are closer than two legs.
    angle = inner_curve(chamfer).outline(0.1).angle if alive else np.zeros(2)
    if not alive or np.diff(angle).min() < -1e-6 or abs(angle[-1] - angle[0] - 2 * np.pi) > 1e-3:
        raise CheckError(
            "blank.edge_break_mm is {leg:g}, but the disc is so narrow somewhere that its chamfers meet: break less",
            leg=leg,
        )
    return tuple(chamfer)


def inner_curve(strips: Sequence[Strip]) -> ClosedCurve:
    """Edge of the face that a chamfer leaves, as a closed curve."""
    return ClosedCurve(tuple(strip.inner for strip in strips if not isinstance(strip.inner, Apex)))


def chamfered_off(curve: ClosedCurve, leg: float) -> float:
    """Volume that a chamfer of leg `leg` mm takes off one edge of a prism, mm^3, by Steiner's formula.

    Of the area A, the parallel curve at depth d leaves A - L d + k d^2, integrated over d from 0 to the leg. L is the
    length, and k = (2 pi - sum of the corners' turns) / 2 + sum of c. At a convex corner c = tan(turn / 2), at a hollow
    one turn / 2. Exact where the curve is straight beside its corners, and elsewhere within
    leg^4 times the curvature times tan(turn / 2)^2.

    Args:
        curve: closed curve, mm.
        leg: leg of the chamfer, mm.
    """
    turns = [corner.turn for corner in curve.corners()]
    square = np.pi - sum(turns) / 2 + sum(tan(turn / 2) if turn > 0 else turn / 2 for turn in turns)
    length = 0.0
    nodes, weights = gauss_nodes(_GAUSS_POINTS)
    for piece in curve.pieces:
        edges = np.linspace(piece.start, piece.stop, max(9, int((piece.stop - piece.start) * _GAUSS_STEPS) + 1))
        half = np.diff(edges) / 2
        t = (edges[:-1] + half)[:, None] + half[:, None] * nodes
        speed = np.linalg.norm(piece.jet(t.ravel()).velocity, axis=1).reshape(t.shape)
        length += float(np.sum((speed @ weights) * half))
    return float(length * leg**2 / 2 - square * leg**3 / 3)


def _moved_inwards(curve: ClosedCurve, leg: float) -> list[Strip]:
    """Every piece with its parallel piece, and the arcs about hollow corners, before anything is cut off."""
    corners = {corner.after: corner for corner in curve.corners()}
    strips = []
    for number, piece in enumerate(curve.pieces):
        ridge, point = sharpest(piece, 1)
        if leg * ridge >= 1:
            angle = degrees(float(polar_angle(point))) % 360
            raise CheckError(
                "blank.edge_break_mm is {leg:g}, but the outline is convex with a radius of {radius:.3f} mm at polar "
                "angle {angle:.2f} degrees: break the edges by less",
                leg=leg,
                radius=1 / ridge,
                angle=angle,
            )
        corner = corners.get(number)
        if corner is not None and -leg * corner.turn > _SNAP:
            normal = left_normal(piece.jet(np.array([piece.start])).velocity)
            first = float(polar_angle(normal)[0]) - corner.turn
            strips.append(Strip(Apex(corner.point), CornerArc(corner.point, leg, 0.0, 1.0, first, corner.turn)))
        strips.append(Strip(piece, OffsetPiece(piece, -leg)))
    return strips


def _trim(strips: list[Strip], spans: list[list[float]], before: int, after: int) -> int | None:
    """Cut two neighbours off where they cross; return the number of the neighbour of which nothing is left, if any."""
    first, second = strips[before].inner, strips[after].inner
    s, t = first.stop, second.start
    gap = _extended(first, s)[0] - _extended(second, t)[0]
    if np.hypot(*gap) > _SNAP:
        for _ in range(_NEWTON_STEPS):
            (p, u), (q, v) = _extended(first, s), _extended(second, t)
            if np.hypot(*(p - q)) < _CONVERGED:
                break
            det = u[1] * v[0] - u[0] * v[1]
            if det == 0:
                break
            off = q - p
            s += (off[1] * v[0] - off[0] * v[1]) / det
            t += (u[0] * off[1] - u[1] * off[0]) / det
        else:
            raise CheckError("the chamfer of the broken edges does not close at a corner: report this design")
    spans[before][1], spans[after][0] = s, t
    for index in (before, after):
        if spans[index][1] <= spans[index][0]:
            return index
    return None


def _extended(piece: Piece, t: float) -> tuple[Array, Array]:
    """Point and velocity, beyond the piece's ends along the tangent there."""
    inside = min(max(t, piece.start), piece.stop)
    jet = piece.jet(np.array([inside]))
    return jet.point[0] + (t - inside) * jet.velocity[0], jet.velocity[0]
