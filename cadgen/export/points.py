"""Point clouds: xyz for a CAD system's curve through points, and a table of the contact as CSV."""

import csv
from collections.abc import Iterable
from math import ceil
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from cadgen.cam.contact import Contact
from cadgen.cam.follower import Follower
from cadgen.curves.closed import ClosedCurve, Outline, left_normal
from cadgen.errors import FileError

Array = NDArray[np.float64]

# A smooth spline through even points bulges beside a corner by up to a twelfth of the corner's angle times their
# distance, and beside a jump of curvature by a share of its size times their distance squared. Closer points on
# either side, at these shares of the distance, bring that down, and stay far enough apart (2 um at 3600 points) for
# every CAD system.
_BESIDE_JOINTS = np.array([1 / 64, 1 / 16, 1 / 4])
_SAME_CURVATURE = 1e-6  # mm^-1; a smaller jump moves no spline
_TABLE = 2049  # samples of a piece from which its length is summed
_STRAIGHT = 1e-6  # mm^-1; a curvature below this (a radius of a kilometre) is written as a straight line
_SAME_ANGLE = 1e-7  # rad; at a corner the contact rests, and rounding moves it by 1e-8

COLUMNS = (
    "cam_angle_deg",
    "x_mm",
    "y_mm",
    "polar_angle_deg",
    "polar_radius_mm",
    "lift_mm",
    "steering_deg",
    "normal_x",
    "normal_y",
    "pressure_angle_deg",
    "radius_of_curvature_mm",
    "face",
)


def write_xyz(path: Path, curve: ClosedCurve, count: int) -> None:
    """Write a closed cloud: "x y z" in mm on each line, z = 0, no header, the first point again last.

    The points are evenly spaced along each smooth piece. Where direction or curvature jumps between two pieces,
    the joint is one of them, and three more stand close by on either side of it.

    Args:
        path: the file to write.
        curve: the profile.
        count: about how many points.
    """
    tables = [_arc_length(curve, number) for number in range(len(curve.pieces))]
    even = sum(float(arc[-1]) for _, arc in tables) / count
    jumps = _jumps(curve)
    points = []
    for number, (piece, (t, arc)) in enumerate(zip(curve.pieces, tables, strict=True)):
        places, step = np.linspace(0.0, arc[-1], max(2, round(arc[-1] / even)) + 1, retstep=True)
        if jumps[number]:
            places = np.append(places, step * _BESIDE_JOINTS)
        if jumps[(number + 1) % len(curve.pieces)]:
            places = np.append(places, arc[-1] - step * _BESIDE_JOINTS)
        points.append(piece.jet(np.interp(np.sort(places)[:-1], arc, t)).point)
    closed = np.concatenate([*points, points[0][:1]])
    _write(path, (f"{x:.6f} {y:.6f} 0.000000" for x, y in (closed + 0.0).tolist()))


def read_xyz(path: Path, step: float = 0.05) -> Outline:
    """Read a cloud as a CAD system does: a closed cubic spline through the points, by their chord lengths.

    Args:
        path: the file.
        step: greatest distance between the points of the result, mm.

    Raises:
        FileError: the file is not a closed cloud of points in the plane z = 0.
    """
    try:
        cloud = np.loadtxt(path, ndmin=2)
    except ValueError as error:
        raise FileError(f"{path.name} is not a table of numbers: write it again") from error
    if cloud.shape[0] < 4 or cloud.shape[1] != 3 or np.any(cloud[:, 2] != 0) or np.any(cloud[0] != cloud[-1]):
        raise FileError(f"{path.name} is not a closed cloud of points in the plane z = 0: write it again")
    points = cloud[:, :2]
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if not chords.all():
        raise FileError(f"{path.name} has two equal neighbours: write it again with fewer points")
    s = np.concatenate([[0.0], np.cumsum(chords)])
    spline = CubicSpline(s, points, bc_type="periodic")
    # From point to point, so that a corner among them is not passed over.
    within = max(5, ceil(chords.max() / step) + 1)
    dense = spline(s[:-1, None] + chords[:, None] * np.linspace(0.0, 1.0, within))
    return Outline(dense.reshape(-1, 2), np.repeat(np.arange(len(chords)), within))


def write_csv(path: Path, curve: ClosedCurve, follower: Follower, contact: Contact) -> None:
    """Write one row per cam angle: where the rod touches the profile, and how.

    The normal points out of the disc; the radius of curvature is positive where the profile is convex and
    empty where it is straight. Where the rod rests on a corner, both are those of one of its sides.

    Args:
        path: the file to write.
        curve: the profile.
        follower: the rod.
        contact: the rod rolled on the profile.
    """
    T, y = contact.tan_beta, contact.across
    half = np.sqrt((follower.radius**2 - y**2) * (1 + T**2))
    ahead = follower.base_radius + contact.face * T - half
    jet, _ = curve.at_angle(contact.cam_angle + np.arctan2(y, ahead))
    normal = -left_normal(jet.velocity)
    polar = np.degrees(np.arctan2(jet.point[:, 1], jet.point[:, 0])) % 360
    with np.errstate(divide="ignore"):
        radius = np.where(np.abs(jet.curvature) < _STRAIGHT, np.nan, 1 / jet.curvature)
    numbers = np.column_stack(
        [
            np.degrees(contact.cam_angle),
            jet.point,
            polar,
            np.linalg.norm(jet.point, axis=1),
            contact.lift,
            np.degrees(np.arctan(T)),
            normal,
            np.degrees(contact.pressure_angle),
            radius,
        ]
    )
    faces = np.where(contact.face == follower.inner, "inner", "outer").tolist()
    rows = (
        ",".join([f"{x:.6f}" if x == x else "" for x in row]) + f",{face}"
        for row, face in zip((numbers.round(6) + 0.0).tolist(), faces, strict=True)
    )
    _write(path, (",".join(COLUMNS), *rows))


def read_csv(path: Path) -> dict[str, Array]:
    """Read the table's numbers by column; an empty field is not a number. `face` is 0 for inner, 1 for outer.

    Raises:
        FileError: a column is missing or a field cannot be read.
    """
    try:
        text = path.read_text(encoding="ascii")
        header, *rows = csv.reader(text.splitlines())
        if not text.endswith("\n"):
            raise ValueError("cut short")
        if tuple(header) != COLUMNS:
            raise FileError(f"{path.name} has columns {', '.join(header)}: write it again")
        values = {"": "nan", "inner": "0", "outer": "1"}
        table = np.array([[float(values.get(text, text)) for text in row] for row in rows])
        return dict(zip(COLUMNS, table.T, strict=True))
    except (ValueError, UnicodeDecodeError, csv.Error) as error:
        raise FileError(f"{path.name} is not a complete table of contacts: write it again") from error


def contact_outline(table: dict[str, Array]) -> Outline:
    """The points at which the rod touches: an outline that gives the table's lift at the table's cam angles.

    Each point is a piece of its own, so that nothing is assumed between them.
    """
    points = np.stack([table["x_mm"], table["y_mm"]], axis=1)
    points = np.concatenate([points, points[:1]])
    angle = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    fresh = np.append(np.diff(np.maximum.accumulate(angle)) > _SAME_ANGLE, True)
    points = points[fresh]
    return Outline(points, np.arange(len(points)))


def _jumps(curve: ClosedCurve) -> list[bool]:
    """Whether direction or curvature jumps where each piece begins."""
    corners = {corner.after for corner in curve.corners()}
    ends = [piece.jet(np.array([piece.start, piece.stop])).curvature for piece in curve.pieces]
    return [
        number in corners or abs(first - ends[number - 1][1]) > _SAME_CURVATURE
        for number, (first, _) in enumerate(ends)
    ]


def _arc_length(curve: ClosedCurve, number: int) -> tuple[Array, Array]:
    """Parameters of a piece, and the length up to each."""
    piece = curve.pieces[number]
    t = np.linspace(piece.start, piece.stop, _TABLE)
    chords = np.linalg.norm(np.diff(piece.jet(t).point, axis=0), axis=1)
    return t, np.concatenate([[0.0], np.cumsum(chords)])


def _write(path: Path, lines: Iterable[str]) -> None:
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
