"""Clouds of points (xyz) for a CAD system's curve through points."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import CubicSpline

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, Outline, Piece, cross
from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.output.files.publisher import Artifact

if TYPE_CHECKING:
    from cadgen.output.files.exports import CamExport

# Greatest error of the lift due to a file, µm.
LIFT_LIMIT_UM = 0.5
# A smooth spline through even points bulges beside a corner by up to a twelfth of the corner's angle times their
# distance, and beside a jump of curvature by a share of its size times their distance squared. Closer points on
# either side, at these shares of the distance, bring that down, and stay far enough apart (2 um at 3600 points) for
# every CAD system.
_BESIDE_JOINTS = np.array([1 / 64, 1 / 16, 1 / 4])
_SAME_CURVATURE = 1e-6  # mm^-1; a smaller jump moves no spline
# mm; closer points than this are one in a cloud: six decimals, half a nanometre of rounding, would tilt a spline
# between them by more than a milliradian, and it would bulge by 0.02 um over the next distance.
_LEAST_DISTANCE = 5e-4
_SPLINE_ERROR = 2e-5  # mm; half-way between two points a spline may err by it, less than half of what a file may
_HALVINGS = 6  # of the distance of points
_TABLE = 2049  # samples of a piece from which its length is summed


def cam_xyz(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """Cloud of points on the outline of a cam; with more of them at its bends where even ones do not keep the lift."""
    name, count = f"{cam.stem}.xyz", cam.export.point_count

    def judged(*, bends: bool) -> Artifact:
        write_xyz(folder / name, cam.curve, count, bends=bends)
        return cam.judged(name, read_xyz(folder / name, cam.step), LIFT_LIMIT_UM, Facts(points=count))

    try:
        made = judged(bends=cam.motion is not None)
    except FileError:
        made = judged(bends=True)
    yield made


def write_xyz(path: Path, curve: ClosedCurve, count: int, *, bends: bool = False) -> None:
    """Write a closed cloud: "x y z" in mm on each line, z = 0, no header, the first point again last.

    The points are evenly spaced along each smooth piece. Where direction or curvature jumps between two pieces,
    the joint is one of them, and three more stand close by on either side of it. Points closer together than half a
    micrometre are one, that of a joint if one is among them.

    Args:
        path: file to write.
        curve: profile, mm.
        count: approximate number of points.
        bends: whether there are more where the curvature changes within their distance, as on a cam by its motion.
    """
    # Parameters of each piece, and the arc length up to each, mm.
    tables = []
    for piece in curve.pieces:
        t = np.linspace(piece.start, piece.stop, _TABLE)
        chords = np.linalg.norm(np.diff(piece.jet(t).point, axis=0), axis=1)
        tables.append((t, np.concatenate([[0.0], np.cumsum(chords)])))
    even = sum(float(arc[-1]) for _, arc in tables) / count
    # Whether direction or curvature jumps at the start of each piece.
    corners = {corner.after for corner in curve.corners()}
    ends = [piece.jet(np.array([piece.start, piece.stop])).curvature for piece in curve.pieces]
    jumps = [
        number in corners or abs(first - ends[number - 1][1]) > _SAME_CURVATURE
        for number, (first, _) in enumerate(ends)
    ]
    points = []
    for number, (piece, (t, arc)) in enumerate(zip(curve.pieces, tables, strict=True)):
        places, step = np.linspace(0.0, arc[-1], max(2, round(arc[-1] / even)) + 1, retstep=True)
        if bends:
            places = _closer_where_bent(piece, t, arc, places)
        if jumps[number]:
            places = np.append(places, step * _BESIDE_JOINTS)
        if jumps[(number + 1) % len(curve.pieces)]:
            places = np.append(places, arc[-1] - step * _BESIDE_JOINTS)
        points.append(piece.jet(np.interp(np.sort(places)[:-1], arc, t)).point)
    apart = _without_close_points(points)
    closed = np.concatenate([apart, apart[:1]])
    lines = (f"{x:.6f} {y:.6f} 0.000000" for x, y in (closed + 0.0).tolist())
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")


def _closer_where_bent(piece: Piece, t: Array, arc: Array, places: Array) -> Array:
    """Arc lengths of points with more of them where the curvature changes within their distance.

    A cubic spline through them then errs by `_SPLINE_ERROR` at most half-way between two.

    Args:
        piece: smooth piece of the profile.
        t: parameters of the piece, shape (m,).
        arc: arc lengths up to them, mm, shape (m,).
        places: arc lengths of the points, mm, shape (n,).
    """
    for _ in range(_HALVINGS):
        jet = piece.jet(np.interp(places, arc, t))
        ends = jet.velocity[[0, -1]] / np.linalg.norm(jet.velocity[[0, -1]], axis=1)[:, None]
        spline = CubicSpline(places, jet.point, bc_type=((1, ends[0]), (1, ends[1])))
        middle = (places[:-1] + places[1:]) / 2
        true = piece.jet(np.interp(middle, arc, t))
        off = np.abs(cross(spline(middle) - true.point, true.velocity)) / np.linalg.norm(true.velocity, axis=1)
        if not (off > _SPLINE_ERROR).any():
            break
        places = np.sort(np.concatenate([places, middle[off > _SPLINE_ERROR]]))
    return places


def read_xyz(path: Path, step: float = 0.05) -> Outline:
    """Read a cloud as a CAD system does: a closed cubic spline through the points, by their chord lengths.

    Args:
        path: file to read.
        step: greatest distance between the points of the result, mm.

    Raises:
        FileError: the file is not a closed cloud of points in the plane z = 0.
    """
    try:
        cloud = np.loadtxt(path, ndmin=2)
    except ValueError as error:
        raise FileError("{file} is not a table of numbers: write it again", file=path.name) from error
    if cloud.shape[0] < 4 or cloud.shape[1] != 3 or np.any(cloud[:, 2] != 0) or np.any(cloud[0] != cloud[-1]):
        raise FileError("{file} is not a closed cloud of points in the plane z = 0: write it again", file=path.name)
    points = cloud[:, :2]
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if not chords.all():
        raise FileError("{file} has two equal neighbours: write it again with fewer points", file=path.name)
    s = np.concatenate([[0.0], np.cumsum(chords)])
    spline = CubicSpline(s, points, bc_type="periodic")
    # From point to point, so that a corner among them is not passed over.
    within = max(5, ceil(chords.max() / step) + 1)
    dense = spline(s[:-1, None] + chords[:, None] * np.linspace(0.0, 1.0, within))
    return Outline(dense.reshape(-1, 2), np.repeat(np.arange(len(chords)), within))


def _without_close_points(pieces: list[Array]) -> Array:
    """The points of all pieces, closed, without those that stand too close to others; a piece begins with its joint."""
    points, joint = np.concatenate(pieces), np.zeros(sum(len(piece) for piece in pieces), dtype=bool)
    joint[np.cumsum([0] + [len(piece) for piece in pieces[:-1]])] = True
    kept: list[int] = []
    for number, point in enumerate(points):
        near = bool(kept) and float(np.hypot(*(point - points[kept[-1]]))) < _LEAST_DISTANCE
        if near and joint[number] and not joint[kept[-1]]:
            kept[-1] = number
        elif not near:
            kept.append(number)
    while len(kept) > 1 and float(np.hypot(*(points[kept[-1]] - points[kept[0]]))) < _LEAST_DISTANCE:
        kept.pop()
    return np.asarray(points[kept])
