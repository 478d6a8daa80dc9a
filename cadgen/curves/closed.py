"""A closed plane curve made of smooth pieces, star-shaped about the origin and run counterclockwise."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array, gauss_nodes

_GAUSS_POINTS = 6
_AREA_STEPS = 360  # per radian, to begin with
# Within a piece third derivatives jump, so steps are halved where much happens in little angle: until one agrees with
# its halves to this share of what a step sweeps on average.
_AREA_TOLERANCE = 1e-8
_AREA_HALVINGS = 20
_TABLE = 257  # samples of a piece from which Newton's method starts
_NEWTON_STEPS = 5  # from a start 1e-2 rad off, quadratic convergence reaches rounding in four


class Jet(NamedTuple):
    """A curve at some parameters: point and velocity, shape (n, 2), and signed curvature, shape (n,)."""

    point: Array
    velocity: Array
    curvature: Array


class Piece(Protocol):
    """A smooth arc over the parameters [start, stop], start < stop."""

    @property
    def start(self) -> float:
        """First parameter."""

    @property
    def stop(self) -> float:
        """Last parameter."""

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by t, and curvature (mm^-1, positive where convex) at parameters t.

        Args:
            t: parameters of the points, shape (n,).
        """


_MOST_OUTLINES = 8  # of a curve that are kept; a job takes four


@dataclass(frozen=True)
class PieceSpan:
    """Part of a smooth piece, between two of its parameters."""

    piece: Piece
    start: float
    stop: float

    def jet(self, t: Array) -> Jet:
        """Point, velocity and curvature of the piece at parameters t.

        Args:
            t: parameters of the points, shape (n,).
        """
        return self.piece.jet(t)


@dataclass(frozen=True)
class DerivedPiece:
    """A piece made from another piece, with the same parameters.

    Attributes:
        piece: original piece.
    """

    piece: Piece

    @property
    def start(self) -> float:
        """First parameter."""
        return self.piece.start

    @property
    def stop(self) -> float:
        """Last parameter."""
        return self.piece.stop


@dataclass(frozen=True, eq=False)
class Outline:
    """A closed curve as points, dense enough that three neighbours in one piece lie on a parabola.

    Attributes:
        points: points in counterclockwise order, shape (n, 2), mm; a joint between two pieces stands twice.
        piece: number of the smooth piece that each point belongs to, shape (n,).
    """

    points: Array
    piece: NDArray[np.intp]

    @property
    def angle(self) -> Array:
        """Polar angle of the points, rad, unwrapped and so increasing on a star-shaped outline."""
        return np.unwrap(np.arctan2(self.points[:, 1], self.points[:, 0]))


@dataclass(frozen=True)
class Corner:
    """A joint at which the direction jumps.

    Attributes:
        point: place of the corner, shape (2,), mm.
        turn: jump of the tangent's direction, rad; positive where the curve is convex.
        after: index of the piece that begins at the corner.
    """

    point: Array
    turn: float
    after: int


@dataclass(frozen=True)
class ClosedCurve:
    """Smooth pieces joined end to end, the last to the first."""

    pieces: tuple[Piece, ...]
    _outlines: dict[float, Outline] = field(default_factory=dict, init=False, repr=False, compare=False)

    def outline(self, step: float) -> Outline:
        """Sample every piece evenly in its parameter, no two points further apart than `step` mm or so.

        Each piece has at least five points, so that a parabola fits inside even the shortest. Taken again it is the
        same object, as long as few others were taken since.

        Args:
            step: greatest distance of two points, mm.
        """
        known = self._outlines
        if step not in known:
            points = [piece.jet(t).point for piece, t in zip(self.pieces, self.parameters(step), strict=True)]
            owner = np.repeat(np.arange(len(points)), [len(part) for part in points])
            known[step] = Outline(np.concatenate(points), owner)
            if len(known) > _MOST_OUTLINES:
                del known[next(iter(known))]
        return known[step]

    def parameters(self, step: float) -> tuple[Array, ...]:
        """For each piece, the parameters of the points that `outline` takes.

        Args:
            step: greatest distance of two points, mm.
        """
        return tuple(
            np.linspace(piece.start, piece.stop, max(5, int(np.ceil(length / step)) + 1))
            for piece, length in zip(self.pieces, self._lengths, strict=True)
        )

    def length(self) -> float:
        """Length round the curve, mm, as `outline` reckons it: by 64 chords on each piece."""
        return float(sum(self._lengths))

    @cached_property
    def _lengths(self) -> list[float]:
        along = [piece.jet(np.linspace(piece.start, piece.stop, 65)).point for piece in self.pieces]
        return [float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()) for points in along]

    def begun_at(self, number: int, t: float) -> "ClosedCurve":
        """Curve begun inside piece `number` at its parameter t.

        Args:
            number: number of the piece, counted from 0.
            t: parameter on the piece.
        """
        piece = self.pieces[number]
        ends = (PieceSpan(piece, t, piece.stop), PieceSpan(piece, piece.start, t))
        rest = (*self.pieces[number + 1 :], *self.pieces[:number])
        return ClosedCurve(tuple(p for p in (ends[0], *rest, ends[1]) if p.stop > p.start))

    def area(self) -> float:
        """Enclosed area by Green's theorem, mm^2: Gauss quadrature, halving the steps in which it does not agree."""
        return sum(_swept(piece) for piece in self.pieces)

    def radius(self, angle: Array) -> Array:
        """Polar radius at polar angles (rad), shape (n,), mm.

        Args:
            angle: polar angles, rad, shape (n,).
        """
        return np.asarray(np.linalg.norm(self.at_angle(angle)[0].point, axis=1))

    def at_angle(self, angle: Array) -> tuple[Jet, NDArray[np.intp]]:
        """Jets of the curve at polar angles (rad), by Newton's method, and the number of the piece at each angle.

        The velocity is by the piece's own parameter.

        Args:
            angle: polar angles, rad, shape (n,).
        """
        angle = np.asarray(angle, dtype=float)
        starts = np.array([polar_angle(piece.jet(np.array([piece.start])).point)[0] for piece in self.pieces])
        # An angle just before a start comes out near a full turn; it belongs to the piece before.
        owner = np.argmin((angle[:, None] - starts) % TURN, axis=1)
        jet = Jet(np.empty((len(angle), 2)), np.empty((len(angle), 2)), np.empty(len(angle)))
        for number in np.unique(owner):
            piece, mine = self.pieces[number], owner == number
            for column, values in zip(jet, piece.jet(ByAngle(piece).parameters(angle[mine])), strict=True):
                column[mine] = values
        return jet, owner

    def corners(self, least_turn: float = 1e-6) -> tuple[Corner, ...]:
        """Joints at which the direction turns by more than `least_turn` rad.

        Args:
            least_turn: least turn of the direction that counts, rad.
        """
        corners = []
        for number, piece in enumerate(self.pieces):
            before = self.pieces[number - 1]
            arriving = before.jet(np.array([before.stop])).velocity
            leaving = piece.jet(np.array([piece.start]))
            turn = np.arctan2(cross(arriving, leaving.velocity)[0], float(np.sum(arriving * leaving.velocity)))
            if abs(turn) > least_turn:
                corners.append(Corner(leaving.point[0], float(turn), number))
        return tuple(corners)


class ByAngle:
    """Parameters of a counterclockwise piece by polar angle, found by Newton's method from a table."""

    def __init__(self, piece: Piece) -> None:
        self._piece = piece
        self._t = np.linspace(piece.start, piece.stop, _TABLE)
        self._turned = np.unwrap(polar_angle(piece.jet(self._t).point))

    def parameters(self, angle: Array) -> Array:
        """Parameters at polar angles, rad.

        Args:
            angle: polar angles, rad, shape (n,).
        """
        piece, turned = self._piece, self._turned
        # The angle sought is the one nearest the piece's middle: right for any piece up to a whole turn.
        middle = (turned[0] + turned[-1]) / 2
        target = middle + (angle - middle + np.pi) % TURN - np.pi
        guess = np.interp(target, turned, self._t)
        for _ in range(_NEWTON_STEPS):
            jet = piece.jet(guess)
            rate = cross(jet.point, jet.velocity) / np.sum(jet.point**2, axis=1)
            miss = (polar_angle(jet.point) - target + np.pi) % TURN - np.pi
            # At a cusp the piece stands still, and so does the search.
            step = np.divide(miss, rate, out=np.zeros_like(miss), where=rate != 0)
            before, guess = guess, np.clip(guess - step, piece.start, piece.stop)
            if np.array_equal(guess, before):
                break
        return np.asarray(guess)


def cross(a: Array, b: Array) -> Array:
    """Plane cross product of rows, shape (n,).

    Args:
        a: first factors as rows, shape (n, 2), mm or a unit vector.
        b: second factors, likewise.
    """
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def polar_angle(points: Array) -> Array:
    """Polar angle of rows in (-pi, pi], rad.

    Args:
        points: points, shape (n, 2), mm.
    """
    return np.arctan2(points[..., 1], points[..., 0])


def left_normal(velocity: Array) -> Array:
    """Unit normal to the left of the direction of travel: into a counterclockwise curve.

    Args:
        velocity: directions of travel, shape (n, 2), mm per unit of the parameter.
    """
    turned = np.stack([-velocity[:, 1], velocity[:, 0]], axis=1)
    return np.asarray(turned / np.linalg.norm(turned, axis=1, keepdims=True))


def _swept(piece: Piece) -> float:
    """Area between a piece and the origin, mm^2."""
    nodes, weights = gauss_nodes(_GAUSS_POINTS)

    def integral(edge: Array, width: Array) -> Array:
        t = edge[:, None] + width[:, None] * (nodes + 1) / 2
        jet = piece.jet(t.ravel())
        return np.asarray(cross(jet.point, jet.velocity).reshape(t.shape) @ weights * width / 4)

    count = max(8, int(np.ceil((piece.stop - piece.start) * _AREA_STEPS)))
    edge = np.linspace(piece.start, piece.stop, count + 1)[:-1]
    width = np.full(count, (piece.stop - piece.start) / count)
    swept, total = integral(edge, width), 0.0
    allowed = _AREA_TOLERANCE * abs(float(swept.mean()))
    for _ in range(_AREA_HALVINGS):
        halves = np.stack([edge, edge + width / 2], axis=1).ravel(), np.repeat(width / 2, 2)
        finer = integral(*halves)
        agreed = np.abs(finer.reshape(-1, 2).sum(axis=1) - swept) <= allowed
        total += float(finer.reshape(-1, 2)[agreed].sum())
        again = np.repeat(~agreed, 2)
        edge, width, swept = halves[0][again], halves[1][again], finer[again]
        if not edge.size:
            break
    return total + float(swept.sum())
