"""Which cutter reaches every part of a profile."""

from dataclasses import dataclass
from enum import StrEnum
from math import inf

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, Jet, Piece, left_normal
from cadgen.curves.derived import SLIGHT_TURN, parallel
from cadgen.curves.spacing import turning

_CLEARANCE = 1e-3  # mm; a cutter smaller than this is none
_POINTS = 1200  # round the curve; pairs of them are tried, then the tightest is closed in on
_ZOOM = 33  # points along each side of the square of pairs that is closed in on
_ZOOMS = 4  # each narrows the square sixteenfold: to 1e-5 of the points' distance, squared in the radius
_BLOCK = 64
_NEXT_TO = 0.01  # mm; nearer points say nothing that the curvature does not say better
# mm; a point that lies less than this beyond the tangent, as the far side of a hollow of slight turn does, is
# overlapped by no cutter by more: set against both sides, it leaves a quarter of that standing, 0.05 um.
_BEYOND = 2e-4
_FLAT = 1e7  # mm; a hollow flatter than this is a straight line with rounding


class Bottleneck(StrEnum):
    """Place that bounds a cutter.

    None, where the profile is nowhere hollow; a hollow corner; the hollow's own radius; or two parts of the profile
    that are too close, as in a narrow valley.
    """

    NONE = "none"
    CORNER = "corner"
    LOCAL = "local"
    GLOBAL = "global"


@dataclass(frozen=True)
class CutterLimit:
    """The largest round cutter that reaches the whole profile from outside.

    Attributes:
        radius: mm; infinite if the profile is nowhere hollow, zero at a hollow corner.
        point: where it fits most tightly, shape (2,), mm; None if the profile is nowhere hollow.
        kind: what bounds it.
    """

    radius: float
    point: Array | None
    kind: Bottleneck


def largest_cutter(curve: ClosedCurve) -> CutterLimit:
    """Return the largest disc that can be set against every point of the curve from outside.

    A disc outside, tangent at p with outward normal n, does not cut another point q if its radius is at most
    |q - p|^2 / (2 (q - p).n), where that is positive; next to p this tends to the hollow's own radius. The
    smallest value over all pairs is the answer, but for overlaps too small to show. It is found on the curve moved
    out by a micrometre, which rounds convex corners, so that the cutter rolling about them is tried as well.

    Raises:
        CheckError: a hollow has a radius of less than a micrometre.
    """
    hollow = [corner for corner in curve.corners() if corner.turn < -SLIGHT_TURN]
    if hollow:
        return CutterLimit(0.0, min(hollow, key=lambda corner: corner.turn).point, Bottleneck.CORNER)
    rounded = parallel(curve, _CLEARANCE)
    local_radius, local_point = _tightest_hollow(rounded)
    radius, point = _tightest_pair(rounded)
    # Pairs close together see the local radius too, a little late; only a clear difference is another place.
    if radius < local_radius * (1 - 1e-4):
        return CutterLimit(radius + _CLEARANCE, point, Bottleneck.GLOBAL)
    if local_radius > _FLAT:
        return CutterLimit(inf, None, Bottleneck.NONE)
    return CutterLimit(local_radius + _CLEARANCE, local_point, Bottleneck.LOCAL)


def _tightest_hollow(curve: ClosedCurve) -> tuple[float, Array]:
    """Least radius of curvature of the hollows that turn enough to matter, and where; infinite if there are none."""
    best = (inf, np.full(2, np.nan))
    for piece, t in zip(curve.pieces, curve.parameters(_step(curve)), strict=True):
        if turning(piece) <= SLIGHT_TURN:
            continue
        for _ in range(_ZOOMS):
            jet = piece.jet(t)
            least = int(np.argmin(jet.curvature))
            if jet.curvature[least] < 0 and -1 / jet.curvature[least] < best[0]:
                best = (float(-1 / jet.curvature[least]), jet.point[least])
            t = _around(piece, t, least)
    return best


def _tightest_pair(curve: ClosedCurve) -> tuple[float, Array]:
    """Least radius of a disc tangent at one point and through another, and the first point."""
    parameters = curve.parameters(_step(curve))
    owner = np.repeat(np.arange(len(parameters)), [len(t) for t in parameters])
    within = np.concatenate([np.arange(len(t)) for t in parameters])
    jets = [piece.jet(t) for piece, t in zip(curve.pieces, parameters, strict=True)]
    jet = Jet(*(np.concatenate(columns) for columns in zip(*jets, strict=True)))
    least, pair = inf, (0, 0)
    for first in range(0, len(owner), _BLOCK):
        radii = _radii(Jet(*(column[first : first + _BLOCK] for column in jet)), jet.point)
        p, q = np.unravel_index(np.argmin(radii), radii.shape)
        if radii[p, q] < least:
            least, pair = float(radii[p, q]), (first + int(p), int(q))
    pieces = [curve.pieces[owner[i]] for i in pair]
    spans = [_around(curve.pieces[owner[i]], parameters[owner[i]], within[i]) for i in pair]
    point = jet.point[pair[0]]
    for _ in range(_ZOOMS):
        at, others = pieces[0].jet(spans[0]), pieces[1].jet(spans[1])
        radii = _radii(at, others.point)
        p, q = np.unravel_index(np.argmin(radii), radii.shape)
        least, point = min(least, float(radii[p, q])), at.point[p]
        spans = [_around(piece, t, int(i)) for piece, t, i in zip(pieces, spans, (p, q), strict=True)]
    return least, point


def _radii(at: Jet, others: Array) -> Array:
    """Radius of the disc tangent outside at each of n points, through each of m others, shape (n, m)."""
    dx = others[:, 0] - at.point[:, 0, None]
    dy = others[:, 1] - at.point[:, 1, None]
    out = -left_normal(at.velocity)
    ahead = dx * out[:, 0, None] + dy * out[:, 1, None]
    apart = dx * dx + dy * dy
    # Closer pairs are a hollow's own radius, and rounding.
    meets = (ahead > _BEYOND) & (apart > _NEXT_TO**2)
    return np.where(meets, apart / np.where(meets, 2 * ahead, 1.0), inf)


def _around(piece: Piece, t: Array, index: int) -> Array:
    """Finer parameters between the neighbours of one of them."""
    step = t[1] - t[0]
    return np.linspace(max(piece.start, t[index] - step), min(piece.stop, t[index] + step), _ZOOM)


def _step(curve: ClosedCurve) -> float:
    """Distance between points, mm."""
    points = curve.outline(np.inf).points
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()) / _POINTS
