"""CSV tables: contacts of a follower on a cam, parts of a gear train, tracks of a car's wheels."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.follower import Contact, Follower
from cadgen.curves.closed import ClosedCurve, Outline, cross, left_normal
from cadgen.curves.polygon import polyline
from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.laws.motion import Motion
from cadgen.laws.unit import MM, RAD, TAN, Unit
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, require

if TYPE_CHECKING:
    from cadgen.cam.forces import CamForces
    from cadgen.car.running.drive import Run
    from cadgen.output.files.exports import CamExport, TrainExport

# Greatest error of the lift due to a table of contacts, µm.
LIFT_LIMIT_UM = 0.5
# Error of the lift, µm, that straight lines between rows may make for a follower that does not lean on an edge.
_AIM_UM = 0.03
_STRAIGHT = 1e-6  # mm^-1; a curvature below this (a radius of a kilometre) is written as a straight line
_ALONG = np.linspace(0.0, 1.0, 5)  # shares of the polar angle between two rows at which their chord is tried
_CONTACT = tuple(field.name for field in fields(Contact))
_JUMP = 1e-9  # rad; where the contact moves within less cam angle than this it jumps along the follower's section
_ROUNDS = 40  # halvings of a row's step of 6 degrees (60 rows) until it is a jump
_WHEELS = ("drive", "front", "idle")
_DECIMALS = 4  # of tracks: 0.1 µm of place and 1e-4 degrees
# Half of the last decimal, and the rounding of a sum.
_READ_TOLERANCE = 0.51 * 10.0**-_DECIMALS

COLUMNS = (
    "cam_angle_deg",
    "x_mm",
    "y_mm",
    "polar_angle_deg",
    "polar_radius_mm",
    "lift_mm",
    "normal_x",
    "normal_y",
    "pressure_angle_deg",
    "radius_of_curvature_mm",
    "face",
)
# Column of the motion, where it is not the lift itself, and its place.
_MOTION = {TAN: "steering_deg", RAD: "swing_deg"}
_MOTION_AT = COLUMNS.index("lift_mm") + 1


# Derivatives of the motion by the cam angle, from what it is made of.
_DERIVATIVES = ("velocity_{unit}_per_rad", "acceleration_{unit}_per_rad2", "jerk_{unit}_per_rad3")


_FORCES = ("normal_force_N", "camshaft_torque_Nmm")


def columns(unit: Unit, *, derived: bool = False, forces: bool = False) -> tuple[str, ...]:
    """Columns of the table of a follower whose motion has a unit.

    Args:
        unit: unit of the motion.
        derived: whether the derivatives of the motion are among them.
        forces: whether the forces are.
    """
    named = (_MOTION[unit],) if unit in _MOTION else ()
    more = tuple(name.format(unit=unit.symbol) for name in _DERIVATIVES) if derived else ()
    more += _FORCES if forces else ()
    return (*COLUMNS[:_MOTION_AT], *named, *more, *COLUMNS[_MOTION_AT:])


def cam_table(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """Table of a cam by its cam angle; straight lines from contact to contact must keep the outline, and the lift."""
    name = f"{cam.stem}.csv"
    stray = LIFT_LIMIT_UM if cam.follower.leans else _AIM_UM
    contact = contact_rows(cam.curve, cam.follower, cam.export.point_count, cam.rim_share * stray * 1e-3)
    write_csv(folder / name, cam.curve, cam.follower, contact, cam.motion, cam.forces)
    table = read_csv(folder / name)
    column = float(np.abs(table["lift_mm"] - contact.lift).max() * 1e3)
    outline = contact_outline(table, cam.step)
    yield cam.judged(name, outline, LIFT_LIMIT_UM, Facts(rows=len(contact.lift)), off=column)


def train_table(train: TrainExport, folder: Path) -> Iterator[Artifact]:
    """Table of the parts of a train, one row per gear."""
    name = f"{train.stem}_parts.csv"
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, list(dict.fromkeys(key for row in train.table for key in row)), lineterminator="\n")
    # As text, for what is read back is text.
    rows = [
        {
            key: "" if value is None else f"{value:.4f}" if isinstance(value, float) else str(value)
            for key, value in row.items()
        }
        for row in train.table
    ]
    writer.writeheader()
    writer.writerows(rows)
    (folder / name).write_text(text.getvalue(), encoding="ascii", newline="\n")
    again = list(csv.DictReader((folder / name).read_text(encoding="ascii").splitlines()))
    same = len(again) == len(rows) and all(row.items() <= read.items() for read, row in zip(again, rows, strict=True))
    require(same, name, Message("has other values"))
    yield Artifact(name, Facts(rows=len(rows)), (Message("{count} rows", count=len(rows)),))


def contact_rows(curve: ClosedCurve, follower: Follower, count: int, tolerance: float) -> Contact:
    """Contacts of the follower at even cam angles, and more where straight lines between would leave the profile.

    Where the follower's own section rounds a hollow corner, the contact runs along it at one cam angle.

    Args:
        curve: profile, mm.
        follower: follower on the profile.
        count: number of even cam angles.
        tolerance: greatest distance of a straight line from contact to contact from the profile, mm.

    Returns:
        Contacts by increasing polar angle.
    """
    rows, step = roll_curve(curve, follower, np.linspace(0.0, TURN, count, endpoint=False), by_place=True)
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
        columns = (np.where(jump, getattr(along, name), getattr(between, name)) for name in _CONTACT)
        rows = Contact(
            *(np.insert(getattr(rows, name), wide + 1, more) for name, more in zip(_CONTACT, columns, strict=True))
        )
        place = _places(rows, follower)
        stray = np.insert(stray, wide + 1, 0.0)
        new = np.concatenate([wide + np.arange(len(wide)), wide + np.arange(len(wide)) + 1])
        stray[new] = _stray(curve, place[new], place[new + 1])
    return _needed(rows, place, curve, count, tolerance)


def _places(rows: Contact, follower: Follower) -> Array:
    """Polar angles of the contacts, the first one again a turn later, rad, shape (n + 1,)."""
    place = np.maximum.accumulate(follower.place(rows))
    return np.append(place, place[0] + TURN)


def _stray(curve: ClosedCurve, start: Array, stop: Array) -> Array:
    """Greatest distance of the curve from straight lines between pairs of its polar angles, shape (n,), mm."""
    inside = (start[:, None] + (stop - start)[:, None] * _ALONG).ravel()
    points = curve.at_angle(inside)[0].point.reshape(len(start), -1, 2)
    chords = points[:, -1] - points[:, 0]
    length = np.maximum(np.linalg.norm(chords, axis=1), 1e-12)
    return np.asarray(np.abs(cross(chords[:, None], points - points[:, :1])).max(axis=1) / length)


def _on_section(curve: ClosedCurve, follower: Follower, before: Contact, place: Array) -> Contact:
    """Contacts at polar angles that the follower touches together with those of `before`, its section on the curve."""
    points = curve.at_angle(place)[0].point
    line = before.cam_angle + follower.azimuth
    across = points[:, 1] * np.cos(line) - points[:, 0] * np.sin(line)
    angle = follower.pressure_angle(before.q, across) if follower.radius else before.pressure_angle
    return replace(before, across=across, pressure_angle=angle)


def _chosen(rows: Contact, which: NDArray[np.intp]) -> Contact:
    return Contact(*(getattr(rows, name)[which] for name in _CONTACT))


def _needed(rows: Contact, place: Array, curve: ClosedCurve, count: int, tolerance: float) -> Contact:
    """The even rows, and those others without which a line between two rows would leave the profile."""
    even = np.isclose((rows.cam_angle * count / TURN + 0.5) % 1, 0.5, rtol=0, atol=1e-7)
    even[0] = True
    begins = np.flatnonzero(even)
    lengths, last, kept = np.diff(np.append(begins, len(even))), begins.copy(), even.copy()
    # One after the other between two even rows, and so for all pairs of even rows at once.
    for ahead in range(1, int(lengths.max())):
        there = np.flatnonzero(lengths > ahead)
        number = begins[there] + ahead
        wide = _stray(curve, place[last[there]], place[number + 1]) > tolerance
        kept[number[wide]] = True
        last[there[wide]] = number[wide]
    return _chosen(rows, np.flatnonzero(kept))


def write_csv(
    path: Path,
    curve: ClosedCurve,
    follower: Follower,
    contact: Contact,
    motion: Motion | None = None,
    forces: CamForces | None = None,
) -> None:
    """Write one row per contact of the follower with the profile.

    The normal points out of the disc; the radius of curvature is positive where the profile is convex and
    empty where it is straight. Where the follower rests on a corner, both are those of one of its sides.

    Args:
        path: file to write.
        curve: profile, mm.
        follower: follower on the profile.
        contact: contacts of the follower rolled on the profile.
        motion: motion of the follower, whose derivatives are written, too; None for tables without them.
        forces: forces that are written, too; None for tables without them.
    """
    jet, _ = curve.at_angle(follower.place(contact))
    normal = -left_normal(jet.velocity)
    polar = np.degrees(np.arctan2(jet.point[:, 1], jet.point[:, 0])) % 360
    with np.errstate(divide="ignore"):
        radius = np.where(np.abs(jet.curvature) < _STRAIGHT, np.nan, 1 / jet.curvature)
    loads: list[Array] = []
    if forces is not None:
        jets = forces.motion.jets(contact.cam_angle)
        loads = [forces.normal(jets, contact.cam_angle), forces.torque(jets, contact.cam_angle)]
    numbers = np.column_stack(
        [
            np.degrees(contact.cam_angle),
            jet.point,
            polar,
            np.linalg.norm(jet.point, axis=1),
            contact.lift,
            *(
                [np.degrees(np.arctan(contact.q) if follower.unit == TAN else contact.q)]
                if follower.unit in _MOTION
                else []
            ),
            *([] if motion is None else [motion.jets(contact.cam_angle)[:, 1:]]),
            *loads,
            normal,
            np.degrees(contact.pressure_angle),
            radius,
        ]
    )
    first, *others = follower.planes
    faces = np.where(contact.face == first, "inner", "outer").tolist() if others else ["whole"] * len(contact.lift)
    rows = (
        ",".join([f"{x:.6f}" if x == x else "" for x in row]) + f",{face}"
        for row, face in zip((numbers.round(6) + 0.0).tolist(), faces, strict=True)
    )
    head = ",".join(columns(follower.unit, derived=motion is not None, forces=forces is not None))
    path.write_text("\n".join([head, *rows]) + "\n", encoding="ascii", newline="\n")


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
        kinds = [(unit, some, more) for unit in (MM, RAD, TAN) for some in (False, True) for more in (False, True)]
        if tuple(header) not in [columns(unit, derived=some, forces=more) for unit, some, more in kinds]:
            raise FileError("{file} has columns {columns}: write it again", file=path.name, columns=", ".join(header))
        values = {"": "nan", "inner": "0", "outer": "1", "whole": "2"}
        table = np.array([[float(values.get(text, text)) for text in row] for row in rows])
        return dict(zip(header, table.T, strict=True))
    except (ValueError, UnicodeDecodeError, csv.Error) as error:
        raise FileError("{file} is not a complete table of contacts: write it again", file=path.name) from error


def contact_outline(table: dict[str, Array], step: float) -> Outline:
    """Outline of straight lines from contact to contact, as a reader of the table joins them.

    Args:
        table: columns of numbers, from `read_csv`.
        step: greatest distance between the points of the result, mm.
    """
    points = np.stack([table["x_mm"], table["y_mm"]], axis=1)
    # On a corner the contact rests while the cam turns.
    return polyline(points[np.any(points != np.roll(points, 1, axis=0), axis=1)], step)


def track_table(runs: Mapping[str, Run]) -> dict[str, Array]:
    """Columns by name, in degrees and mm: `motor_deg`, then for each run cam angle, steering, heading and wheels.

    Args:
        runs: runs by name, all at the same motor positions.
    """
    table = {"motor_deg": np.degrees(next(iter(runs.values())).motor)}
    for name, run in runs.items():
        table[f"{name}_cam_angle_deg"] = np.degrees(run.cam_angle)
        table[f"{name}_steering_deg"] = np.degrees(np.arctan(run.tan_beta))
        table[f"{name}_heading_deg"] = np.degrees(run.heading)
        for wheel in _WHEELS:
            for axis, values in zip("xy", getattr(run, f"{wheel}_wheel").T, strict=True):
                table[f"{name}_{wheel}_{axis}_mm"] = values
    return table


def write_tracks(file: Path, runs: Mapping[str, Run]) -> None:
    """Write the table as CSV, and read it back.

    Raises:
        FileError: the file, read back, holds other values.
    """
    table = track_table(runs)
    rows = np.column_stack(list(table.values()))
    np.savetxt(file, rows, fmt=f"%.{_DECIMALS}f", delimiter=",", header=",".join(table), comments="", encoding="utf-8")
    again = read_tracks(file)
    if list(again) != list(table) or not all(
        np.allclose(again[name], values, rtol=0, atol=_READ_TOLERANCE) for name, values in table.items()
    ):
        raise FileError("{file}, read back, is not the tracks that were meant: report this design", file=file.name)


def read_tracks(file: Path) -> dict[str, Array]:
    """Columns of a table of tracks by name, degrees and mm."""
    with file.open(encoding="utf-8") as text:
        names = text.readline().strip().split(",")
        return dict(zip(names, np.loadtxt(text, delimiter=",", ndmin=2).T, strict=True))
