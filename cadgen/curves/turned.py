"""A closed curve turned about the origin."""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, DerivedPiece, Jet


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
