"""The parallel curve outside a closed curve: the path of a cutter's centre."""

from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, Corner, DerivedPiece, Jet, Piece, left_normal, polar_angle
from cadgen.curves.spacing import turning
from cadgen.errors import CheckError

# rad; a hollow that turns by no more than this holds no cutter up: one of radius R leaves at most R turn^2 / 8 in it,
# and takes as little beside it: 0.03 um at 10 mm.
SLIGHT_TURN = 5e-3
_SAMPLES_PER_RADIAN = 600  # of a piece, in search of its tightest hollow


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
        return Jet(
            jet.point - self.distance * left_normal(jet.velocity),
            widened[:, None] * jet.velocity,
            jet.curvature / widened,
        )


@dataclass(frozen=True)
class CornerArc:
    """A circular arc about a convex corner, run counterclockwise, by the polar angle about it."""

    center: Array
    radius: float
    start: float
    stop: float

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the angle t (rad), and curvature.

        Args:
            t: angles, rad, shape (n,).
        """
        out = np.stack([np.cos(t), np.sin(t)], axis=1)
        around = np.stack([-out[:, 1], out[:, 0]], axis=1)
        return Jet(self.center + self.radius * out, self.radius * around, np.full(len(t), 1 / self.radius))


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
        if (tight := _tightest(piece, distance)) is not None:
            if turning(piece) <= SLIGHT_TURN:
                continue
            _refuse_tight(*tight, distance)
        pieces.append(OffsetPiece(piece, distance))
    return ClosedCurve(tuple(pieces))


def _round(corner: Corner, after: Piece, distance: float) -> CornerArc:
    if corner.turn < 0:
        raise CheckError(
            f"the curve has a hollow corner of {-degrees(corner.turn):.2f} degrees at "
            f"{_place(corner.point)}; no round cutter reaches it: round the corner or "
            f"choose another process"
        )
    normal = -left_normal(after.jet(np.array([after.start])).velocity)
    stop = float(polar_angle(normal)[0])
    return CornerArc(corner.point, distance, stop - corner.turn, stop)


def _tightest(piece: Piece, distance: float) -> tuple[float, Array] | None:
    """Radius and place of a piece's tightest hollow, if an offset by `distance` mm closes it."""
    count = max(65, int(_SAMPLES_PER_RADIAN * (piece.stop - piece.start)))
    jet = piece.jet(np.linspace(piece.start, piece.stop, count))
    tightest = int(np.argmin(jet.curvature))
    if 1 + distance * jet.curvature[tightest] > 0:
        return None
    return float(-1 / jet.curvature[tightest]), jet.point[tightest]


def _refuse_tight(radius: float, point: Array, distance: float) -> None:
    raise CheckError(
        f"the curve is hollow with a radius of {radius:.3f} mm at {_place(point)}, where a "
        f"cutter of radius {distance:g} mm cuts into it: use one of less than {radius:.3f} mm"
    )


def _place(point: Array) -> str:
    angle = degrees(float(polar_angle(point))) % 360
    return f"polar angle {angle:.2f} degrees, ({point[0]:.3f}, {point[1]:.3f}) mm"
