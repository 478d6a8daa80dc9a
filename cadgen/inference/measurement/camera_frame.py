"""Frame of a measured track: axes that are turned by quarters of a turn, shifted, or in a mirror.

A camera has its own axes. The way from the start tells how they lie: on its first part the car's own errors do little.
Let e be the place by design and m what was measured, as x + iy about their means over those rows. Then the angle of
Σ m ē says by how much the path is turned in the camera's axes. A path of the other hand fits m̄ instead.
"""

from dataclasses import replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN
from cadgen.car.path.wheel_track import Track
from cadgen.errors import FileError
from cadgen.inference.measurement.record import Record
from cadgen.messages import Message

FAR_MM = 100.0  # beyond which no hand sets a car beside its line
FIRST = 0.2  # part of each run by which the axes are told
LEAST_MM, LEAST_ROWS = 200.0, 6  # that this part must have
_STRAY = pi / 12  # by which the start may seem turned from the nearest quarter
_OTHER_HAND = 0.25  # a path of the other hand leaves less than this part
_LIKE_SIZED = 2.0


def in_design_frame(record: Record, track: Track) -> Record:
    """Record with the places in the frame of the design, and a note where they were not.

    Args:
        record: of a track, with `cam_angle_deg`, `x_mm` and `y_mm`.
        track: of the design.

    Raises:
        FileError: the path is that of the design in a mirror.
    """
    angle = np.radians(record["cam_angle_deg"])
    arc = track.turn * angle / TURN
    planned = track.position(np.clip(arc, 0.0, track.length)) @ np.array([1.0, 1j])
    measured = record["x_mm"] + 1j * record["y_mm"]
    inside = (arc >= 0) & (arc <= track.length)
    whole = [np.flatnonzero((record.run == run) & inside) for run in range(record.runs)]
    first = [rows[angle[rows] <= angle[rows].min() + FIRST * np.ptp(angle[rows])] for rows in whole if rows.size]
    first = [rows for rows in first if rows.size >= LEAST_ROWS and np.abs(np.diff(planned[rows])).sum() >= LEAST_MM]
    if not first:
        return record
    if not 1 / _LIKE_SIZED < _size(measured, whole) / _size(planned, whole) < _LIKE_SIZED:
        return record  # of another unit, or of another car
    as_is, mirrored = (_left(planned, seen, whole) for seen in (measured, measured.conj()))
    if mirrored < _OTHER_HAND * as_is and as_is > FAR_MM**2 * inside.sum():
        raise FileError(
            "{file}: its path is that of the design in a mirror: where its y axis points to the right of its x axis, "
            "give y_mm the other sign, and else look whether the front wheel turns to the other side than the design's",
            file=record.source,
        )
    turned = float(np.angle(sum(_about(measured[rows]) @ _about(planned[rows]).conj() for rows in first)))
    quarters = round(turned / (pi / 2))
    if abs(turned - quarters * pi / 2) > _STRAY:
        return record
    found = measured * (-1j) ** (quarters % 4)
    # The mean over runs, since each was set by hand: what they share is the camera's, and no longer says of the car.
    shift = complex(np.mean([np.mean(found[rows[:LEAST_ROWS]] - planned[rows[:LEAST_ROWS]]) for rows in first]))
    if not quarters and abs(shift) < FAR_MM:
        return record
    found, shift = found - shift, shift * 1j ** (quarters % 4)
    note = Message(
        "in its axes the path is turned by {angle}° against the design's, and shifted by ({x:.0f}, {y:.0f}) mm",
        angle=90 * (quarters % 4),
        x=shift.real,
        y=shift.imag,
    )
    columns = {**record.columns, "x_mm": found.real, "y_mm": found.imag}
    return replace(record, columns=columns, notes=(*record.notes, note))


def _about(places: NDArray[np.complex128]) -> NDArray[np.complex128]:
    return np.asarray(places - places.mean())


def _size(places: NDArray[np.complex128], runs: list[NDArray[np.intp]]) -> float:
    return float(np.sqrt(sum(np.vdot(_about(places[rows]), _about(places[rows])).real for rows in runs if rows.size)))


def _left(planned: NDArray[np.complex128], measured: NDArray[np.complex128], runs: list[NDArray[np.intp]]) -> float:
    """Sum of squares that is left once each run is turned and moved onto the plan, mm²."""
    left = 0.0
    for rows in runs:
        if rows.size:
            one, two = _about(planned[rows]), _about(measured[rows])
            left += float(np.vdot(one, one).real + np.vdot(two, two).real - 2 * abs(np.vdot(one, two)))
    return left
