"""A closed curve whose points are moved a little: by splines of the shift along each smooth piece."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicSpline

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, DerivedPiece, Jet, Piece, cross, left_normal

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
    cross, as the sides of a corner do that is cut with another offset.

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
