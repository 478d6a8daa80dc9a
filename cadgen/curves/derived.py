"""Closed curves derived from another one piece by piece: turned, displaced, or parallel at a distance outside.

The parallel curve outside is the path of a cutter's centre; that inside belongs to `chamfer`.
"""

from dataclasses import dataclass
from functools import cached_property
from math import degrees

import numpy as np
from scipy.interpolate import CubicSpline

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, Corner, DerivedPiece, Jet, Piece, cross, left_normal, polar_angle
from cadgen.curves.spacing import turning
from cadgen.errors import CheckError
from cadgen.messages import Message


@dataclass(frozen=True)
class TurnedPiece(DerivedPiece):
    """A smooth piece turned counterclockwise by `angle`, rad."""

    angle: float

    def jet(self, t: Array) -> Jet:
        """Point, velocity by the piece's own parameter, and curvature.

        Args:
            t: parameters of the points, shape (n,).
        """
        c, s = np.cos(self.angle), np.sin(self.angle)
        rotation = np.array([[c, s], [-s, c]])  # for rows
        was = self.piece.jet(t)
        return Jet(was.point @ rotation, was.velocity @ rotation, was.curvature)


def turned(curve: ClosedCurve, angle: float) -> ClosedCurve:
    """Turn a curve counterclockwise by `angle`, rad.

    Args:
        curve: closed curve, mm.
        angle: angle, rad.
    """
    return ClosedCurve(tuple(TurnedPiece(piece, angle) for piece in curve.pieces))


# From this far on either side of a joint the two pieces slide along themselves until they meet, mm.
_SLIDE = 1.0
_PARALLEL = 1e-9  # sine of the turn at a joint below which the pieces meet halfway


@dataclass(frozen=True)
class MovedPiece(DerivedPiece):
    """A smooth piece with a shift of its points, known at some of its parameters.

    Attributes:
        piece: original piece.
        at: parameters of the piece, increasing from its start to its stop, shape (n,).
        by: shift at these parameters, shape (n, 2), mm.
    """

    at: Array
    by: Array

    @cached_property
    def _shift(self) -> CubicSpline:
        return CubicSpline(self.at, self.by)

    @cached_property
    def _speed(self) -> CubicSpline:
        return CubicSpline(self.at, np.linalg.norm(self.piece.jet(self.at).velocity, axis=1))

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity and curvature at parameters t; the curvature is continuous where the piece's own is.

        Args:
            t: parameters of the points, shape (n,).
        """
        before = self.piece.jet(t)
        speed = np.linalg.norm(before.velocity, axis=1)[:, None]
        inward = left_normal(before.velocity)
        # A jet has no acceleration: across the piece it follows from curvature, along it from the change of speed.
        along = self._speed(t, nu=1)[:, None] * before.velocity / speed
        acceleration = along + before.curvature[:, None] * speed**2 * inward + self._shift(t, nu=2)
        velocity = before.velocity + self._shift(t, nu=1)
        curvature = cross(velocity, acceleration) / np.linalg.norm(velocity, axis=1) ** 3
        return Jet(before.point + self._shift(t), velocity, curvature)


def moved(curve: ClosedCurve, at: tuple[Array, ...], by: tuple[Array, ...]) -> ClosedCurve:
    """Move the points of every piece and join the pieces again.

    Where the shifts of two neighbours differ at a corner, the ends slide along themselves to where their tangents
    cross. So do the sides of a corner that is cut with another offset.

    Args:
        curve: any closed curve.
        at: parameters of each piece, from its start to its stop, shape (n,).
        by: shift of each piece at these parameters, shape (n, 2), mm.
    """
    pieces, slid = curve.pieces, [part.copy() for part in by]
    for number, piece in enumerate(pieces):
        before = pieces[number - 1]
        arriving, leaving = before.jet(np.array([before.stop])), piece.jet(np.array([piece.start]))
        ends = arriving.point[0] + by[number - 1][-1], leaving.point[0] + by[number][0]
        tangents = [jet.velocity[0] / np.linalg.norm(jet.velocity[0]) for jet in (arriving, leaving)]
        gap = ends[1] - ends[0]
        turn = float(cross(*tangents))
        if abs(turn) < _PARALLEL:
            forward = backward = gap / 2
        else:
            forward = tangents[0] * cross(gap, tangents[1]) / turn
            backward = gap - forward
        slid[number - 1] += _slide(before, at[number - 1], forward, from_end=True)
        slid[number] -= _slide(piece, at[number], backward, from_end=False)
    return ClosedCurve(tuple(MovedPiece(*part) for part in zip(pieces, at, slid, strict=True)))


def _slide(piece: Piece, at: Array, end: Array, *, from_end: bool) -> Array:
    """A shift that is `end` at one end of a piece and fades along the piece, shape (n, 2)."""
    jet = piece.jet(at)
    length = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(jet.point, axis=0), axis=1)))
    away = length[-1] - length if from_end else length
    fade = np.clip(1 - away / min(_SLIDE, float(length[-1])), 0.0, None) ** 3
    ahead = jet.velocity / np.linalg.norm(jet.velocity, axis=1)[:, None]
    here = ahead[-1 if from_end else 0]
    along = float(end @ here)
    return np.asarray(fade[:, None] * (along * ahead + (end - along * here)))


# rad; a hollow that turns by no more than this holds no cutter up: one of radius R leaves at most R turn^2 / 8 in it,
# and takes as little beside it: 0.03 um at 10 mm.
SLIGHT_TURN = 5e-3
_CUSP = 1e-15  # in place of a velocity of 0 at a cusp, at which a curve would have no direction
_SAMPLES_PER_RADIAN = 600  # of a piece, in search of its sharpest bend


@dataclass(frozen=True)
class OffsetPiece(DerivedPiece):
    """A smooth piece moved by `distance` mm to the right of its travel.

    With unit normal n to the right and curvature k, p -> p + d n, p' -> (1 + d k) p', k -> k / (1 + d k).
    """

    distance: float

    def jet(self, t: Array) -> Jet:
        """Point, velocity by the piece's own parameter, and curvature.

        Args:
            t: parameters of the points, shape (n,).
        """
        jet = self.piece.jet(t)
        widened = 1 + self.distance * jet.curvature
        widened = np.where(widened == 0, _CUSP, widened)
        return Jet(
            jet.point - self.distance * left_normal(jet.velocity),
            widened[:, None] * jet.velocity,
            jet.curvature / widened,
        )


@dataclass(frozen=True)
class CornerArc:
    """A circular arc about a corner, run counterclockwise or, by a negative rate, clockwise.

    Attributes:
        center: the corner, mm.
        radius: radius, mm.
        start: first parameter.
        stop: last parameter.
        first: polar angle about the corner at the parameter 0, rad.
        rate: growth of that angle by the parameter, rad.
    """

    center: Array
    radius: float
    start: float
    stop: float
    first: float = 0.0
    rate: float = 1.0

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the parameter, and curvature.

        Args:
            t: parameters of the points, shape (n,).
        """
        angle = self.first + t * self.rate
        out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        around = np.stack([-out[:, 1], out[:, 0]], axis=1)
        bend = np.full(len(t), np.sign(self.rate) / self.radius)
        return Jet(self.center + self.radius * out, self.radius * self.rate * around, bend)


def parallel(curve: ClosedCurve, distance: float) -> ClosedCurve:
    """Return the curve that runs `distance` mm outside a counterclockwise curve, that is to its right.

    Every piece is moved exactly, and an arc about each convex corner joins the pieces. Parts far apart that
    come closer than 2 `distance` (a narrow valley) are not looked for here: `cadgen.cam.cutter` finds them. Hollows
    that turn too little to matter (`SLIGHT_TURN`) are passed over.

    Args:
        curve: closed curve, mm.
        distance: distance of the two curves, mm.

    Raises:
        CheckError: a hollow corner, or a hollow whose radius of curvature is not greater than `distance`.
    """
    corners = {corner.after: corner for corner in curve.corners() if corner.turn < -SLIGHT_TURN or corner.turn > 0}
    pieces: list[Piece] = []
    for number, piece in enumerate(curve.pieces):
        if number in corners:
            pieces.append(_round(corners[number], piece, distance))
        hollow, point = sharpest(piece, -1)
        if 1 - distance * hollow <= 0:
            if turning(piece) <= SLIGHT_TURN:
                continue
            raise CheckError(
                "the curve is hollow with a radius of {radius:.3f} mm at {point}, where a cutter of radius "
                "{distance:g} mm cuts into it: use one of less than {radius:.3f} mm",
                radius=1 / hollow,
                point=_place(point),
                distance=distance,
            )
        pieces.append(OffsetPiece(piece, distance))
    return ClosedCurve(tuple(pieces))


def _round(corner: Corner, after: Piece, distance: float) -> CornerArc:
    if corner.turn < 0:
        raise CheckError(
            "the curve has a hollow corner of {turn:.2f} degrees at {point}; no round cutter reaches it: round "
            "the corner or choose another process",
            turn=-degrees(corner.turn),
            point=_place(corner.point),
        )
    normal = -left_normal(after.jet(np.array([after.start])).velocity)
    stop = float(polar_angle(normal)[0])
    return CornerArc(corner.point, distance, stop - corner.turn, stop)


def sharpest(piece: Piece, sense: int) -> tuple[float, Array]:
    """Greatest curvature of a piece, mm^-1, and its point, shape (2,), mm.

    Args:
        piece: smooth piece, mm.
        sense: direction of the bend, 1 for convex and -1 for hollow places.
    """
    count = max(65, int(_SAMPLES_PER_RADIAN * (piece.stop - piece.start)))
    jet = piece.jet(np.linspace(piece.start, piece.stop, count))
    worst = int(np.argmax(sense * jet.curvature))
    return float(sense * jet.curvature[worst]), jet.point[worst]


def _place(point: Array) -> Message:
    angle = degrees(float(polar_angle(point))) % 360
    return Message("polar angle {angle:.2f} degrees, ({x:.3f}, {y:.3f}) mm", angle=angle, x=point[0], y=point[1])
