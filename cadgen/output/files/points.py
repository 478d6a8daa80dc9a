"""Point clouds: xyz for a CAD system's curve through points, and a table of the contact as CSV."""

import csv
from collections.abc import Iterable
from dataclasses import fields, replace
from math import ceil
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.follower import Contact, Follower
from cadgen.curves.closed import ClosedCurve, Outline, cross, left_normal
from cadgen.curves.polygon import polyline
from cadgen.errors import FileError

# A smooth spline through even points bulges beside a corner by up to a twelfth of the corner's angle times their
# distance, and beside a jump of curvature by a share of its size times their distance squared. Closer points on
# either side, at these shares of the distance, bring that down, and stay far enough apart (2 um at 3600 points) for
# every CAD system.
_BESIDE_JOINTS = np.array([1 / 64, 1 / 16, 1 / 4])
_SAME_CURVATURE = 1e-6  # mm^-1; a smaller jump moves no spline
# mm; closer points than this are one in a cloud: six decimals, half a nanometre of rounding, would tilt a spline
# between them by more than a milliradian, and it would bulge by 0.02 um over the next distance.
_LEAST_DISTANCE = 5e-4
_TABLE = 2049  # samples of a piece from which its length is summed
_STRAIGHT = 1e-6  # mm^-1; a curvature below this (a radius of a kilometre) is written as a straight line
_ALONG = np.linspace(0.0, 1.0, 5)  # shares of the polar angle between two rows at which their chord is tried
_COLUMNS = tuple(field.name for field in fields(Contact))
_JUMP = 1e-9  # rad; where the contact moves within less cam angle than this it jumps along the rod's section
_ROUNDS = 40  # halvings of a row's step of 6 degrees (60 rows) until it is a jump

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
    the joint is one of them, and three more stand close by on either side of it. Points closer together than half a
    micrometre are one, that of a joint if one is among them.

    Args:
        path: file to write.
        curve: profile, mm.
        count: approximate number of points.
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
    apart = _apart(points)
    closed = np.concatenate([apart, apart[:1]])
    _write(path, (f"{x:.6f} {y:.6f} 0.000000" for x, y in (closed + 0.0).tolist()))


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


def contact_rows(curve: ClosedCurve, follower: Follower, count: int, tolerance: float) -> Contact:
    """Contacts of the follower at even cam angles, and more where straight lines between would leave the profile.

    Where the rod's own section rounds a hollow corner, the contact runs along it at one cam angle.

    Args:
        curve: profile, mm.
        follower: follower on the profile.
        count: number of even cam angles.
        tolerance: greatest distance of a straight line from contact to contact from the profile, mm.

    Returns:
        Contacts by increasing polar angle.
    """
    rows, step = roll_curve(curve, follower, np.linspace(0.0, TURN, count, endpoint=False))
    outline = curve.outline(step)
    place = _places(rows, follower)
    stray = _stray(curve, place[:-1], place[1:])
    for _ in range(_ROUNDS):
        wide = np.flatnonzero(stray > tolerance)
        if not wide.size:
            break
        theta = np.append(rows.cam_angle, rows.cam_angle[0] + TURN)
        before = _chosen(rows, wide)
        between = roll(outline, follower, (theta[wide] + theta[wide + 1]) / 2)
        along = _on_section(curve, follower, before, (place[wide] + place[wide + 1]) / 2)
        jump = theta[wide + 1] - theta[wide] < _JUMP
        columns = (np.where(jump, getattr(along, name), getattr(between, name)) for name in _COLUMNS)
        rows = _inserted(rows, Contact(*columns), wide)
        place = _places(rows, follower)
        stray = np.insert(stray, wide + 1, 0.0)
        new = np.concatenate([wide + np.arange(len(wide)), wide + np.arange(len(wide)) + 1])
        stray[new] = _stray(curve, place[new], place[new + 1])
    return _needed(rows, place, curve, count, tolerance)


def _places(rows: Contact, follower: Follower) -> Array:
    """Polar angles of the contacts, the first one again a turn later, rad, shape (n + 1,)."""
    place = np.maximum.accumulate(rows.cam_angle + np.arctan2(rows.across, _ahead(rows, follower)))
    return np.append(place, place[0] + TURN)


def _ahead(rows: Contact, follower: Follower) -> Array:
    """Distance of the contacts ahead of the camshaft, mm."""
    return follower.ahead(rows.q, rows.face, rows.across)


def _stray(curve: ClosedCurve, start: Array, stop: Array) -> Array:
    """Greatest distance of the curve from straight lines between pairs of its polar angles, shape (n,), mm."""
    inside = (start[:, None] + (stop - start)[:, None] * _ALONG).ravel()
    points = curve.at_angle(inside)[0].point.reshape(len(start), -1, 2)
    chords = points[:, -1] - points[:, 0]
    length = np.maximum(np.linalg.norm(chords, axis=1), 1e-12)
    return np.asarray(np.abs(cross(chords[:, None], points - points[:, :1])).max(axis=1) / length)


def _on_section(curve: ClosedCurve, follower: Follower, before: Contact, place: Array) -> Contact:
    """Contacts at polar angles that the rod touches together with those of `before`, its section on the curve."""
    points = curve.at_angle(place)[0].point
    across = points[:, 1] * np.cos(before.cam_angle) - points[:, 0] * np.sin(before.cam_angle)
    angle = follower.pressure_angle(before.q, across) if follower.radius else before.pressure_angle
    return replace(before, across=across, pressure_angle=angle)


def _chosen(rows: Contact, which: NDArray[np.intp]) -> Contact:
    return Contact(*(getattr(rows, name)[which] for name in _COLUMNS))


def _inserted(rows: Contact, more: Contact, after: NDArray[np.intp]) -> Contact:
    return Contact(*(np.insert(getattr(rows, name), after + 1, getattr(more, name)) for name in _COLUMNS))


def _needed(rows: Contact, place: Array, curve: ClosedCurve, count: int, tolerance: float) -> Contact:
    """The even rows, and those others without which a line between two rows would leave the profile."""
    even = np.isclose((rows.cam_angle * count / TURN + 0.5) % 1, 0.5, rtol=0, atol=1e-7)
    kept = [0]
    for number in range(1, len(even)):
        ends = place[kept[-1:]], place[[number + 1]]
        if even[number] or _stray(curve, *ends)[0] > tolerance:
            kept.append(number)
    return _chosen(rows, np.array(kept))


def write_csv(path: Path, curve: ClosedCurve, follower: Follower, contact: Contact) -> None:
    """Write one row per contact of the follower with the profile.

    The normal points out of the disc; the radius of curvature is positive where the profile is convex and
    empty where it is straight. Where the rod rests on a corner, both are those of one of its sides.

    Args:
        path: file to write.
        curve: profile, mm.
        follower: follower on the profile.
        contact: contacts of the follower rolled on the profile.
    """
    T, y = contact.q, contact.across
    jet, _ = curve.at_angle(contact.cam_angle + np.arctan2(y, _ahead(contact, follower)))
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
    first, *others = follower.planes
    faces = np.where(contact.face == first, "inner", "outer").tolist() if others else ["whole"] * len(T)
    rows = (
        ",".join([f"{x:.6f}" if x == x else "" for x in row]) + f",{face}"
        for row, face in zip((numbers.round(6) + 0.0).tolist(), faces, strict=True)
    )
    _write(path, (",".join(COLUMNS), *rows))


def read_csv(path: Path) -> dict[str, Array]:
    """Read the table's numbers by column; an empty field is not a number.

    `face` is 0 for inner, 1 for outer, and 2 for the whole rim, on which a follower rests that does not lean.

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
        values = {"": "nan", "inner": "0", "outer": "1", "whole": "2"}
        table = np.array([[float(values.get(text, text)) for text in row] for row in rows])
        return dict(zip(COLUMNS, table.T, strict=True))
    except (ValueError, UnicodeDecodeError, csv.Error) as error:
        raise FileError(f"{path.name} is not a complete table of contacts: write it again") from error


def contact_outline(table: dict[str, Array], step: float) -> Outline:
    """Outline of straight lines from contact to contact, as a reader of the table joins them.

    Args:
        table: columns of numbers, from `read_csv`.
        step: greatest distance between the points of the result, mm.
    """
    points = np.stack([table["x_mm"], table["y_mm"]], axis=1)
    # On a corner the contact rests while the cam turns.
    return polyline(points[np.any(points != np.roll(points, 1, axis=0), axis=1)], step)


def _jumps(curve: ClosedCurve) -> list[bool]:
    """Whether direction or curvature jumps at the start of each piece."""
    corners = {corner.after for corner in curve.corners()}
    ends = [piece.jet(np.array([piece.start, piece.stop])).curvature for piece in curve.pieces]
    return [
        number in corners or abs(first - ends[number - 1][1]) > _SAME_CURVATURE
        for number, (first, _) in enumerate(ends)
    ]


def _arc_length(curve: ClosedCurve, number: int) -> tuple[Array, Array]:
    """Parameters of a piece, and the arc length up to each, mm."""
    piece = curve.pieces[number]
    t = np.linspace(piece.start, piece.stop, _TABLE)
    chords = np.linalg.norm(np.diff(piece.jet(t).point, axis=0), axis=1)
    return t, np.concatenate([[0.0], np.cumsum(chords)])


def _apart(pieces: list[Array]) -> Array:
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


def _write(path: Path, lines: Iterable[str]) -> None:
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
