"""Trial runs from files: points of a track, and comment lines that say with which settings the car ran.

A file has the columns `run,x_mm,y_mm`, points in the order of driving in the frame of the path, the last of each run
where the car stopped; or `run,cam_angle_deg,x_mm,y_mm`, where the motor was stopped for each point. A comment line
`# settings: head 0.012 mm, key 0 deg, start 3 -2 mm 0.15 deg` says what was set before its runs; without it they ran as
designed.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from math import degrees, radians
from pathlib import Path

import numpy as np

from cadgen.car.motion.drive import Pose
from cadgen.errors import FileError, brief
from cadgen.inference.adjustment import Settings, Trial
from cadgen.inference.measurement.kinds.track import KIND as TRACK
from cadgen.inference.measurement.record import Record
from cadgen.inference.records.load import load

MOST_POINTS, MOST_TRIALS = 500, 10
# Points of a track by their order alone: a track without the column of cam angles.
STOPPED = replace(TRACK, code="trial run with cam angles", title="Trial run with cam angles", least_rows=2)
TRIAL = replace(
    STOPPED,
    code="trial run",
    title="Trial run",
    columns=tuple(column for column in TRACK.columns if column.name != "cam_angle_deg"),
    check=lambda record: None,
)
_NUMBER = r"([+-]?\d+(?:\.\d*)?|[+-]?\.\d+)"
_LINE = re.compile(
    rf"settings:\s*head\s+{_NUMBER}\s*mm,\s*key\s+{_NUMBER}\s*deg,\s*start\s+{_NUMBER}\s+{_NUMBER}\s*mm\s+{_NUMBER}\s*deg\s*"
)


def settings_line(settings: Settings) -> str:
    """Settings as a comment line of a file of trial runs, without its mark."""
    return (
        f"settings: head {settings.head:.4f} mm, key {degrees(settings.key):.4f} deg, "
        f"start {settings.start_x:.2f} {settings.start_y:.2f} mm {degrees(settings.start_heading):.4f} deg"
    )


def settings_in(record: Record) -> Settings:
    """Settings that the comment lines of a file say; none where they say nothing of them.

    Raises:
        FileError: a line about settings that is not as `settings_line` writes it, or two that differ.
    """
    stated = []
    for remark in record.remarks:
        if not remark.lower().startswith("settings"):
            continue
        if not (match := _LINE.fullmatch(remark)):
            raise FileError(
                f'{record.source}: the comment line "{brief(remark, 60)}" is not understood; write it as '
                f'"# {settings_line(Settings())}"'
            )
        head, key, x, y, heading = map(float, match.groups())
        stated.append(Settings(head=head, key=radians(key), start_x=x, start_y=y, start_heading=radians(heading)))
    if len(set(stated)) > 1:
        raise FileError(f"{record.source}: its comment lines give different settings; put each into a file of its own")
    return stated[0] if stated else Settings()


def read_trials(paths: Sequence[Path]) -> tuple[Record, ...]:
    """Files of trial runs, in their order.

    Raises:
        FileError: a file that cannot be read or holds no trial run, or the same twice.
    """
    seen: dict[Path, Path] = {}
    for path in paths:
        if (same := seen.setdefault(path.resolve(), path)) is not path:
            raise FileError(f"{same} was given twice; give each file once")
    return tuple(load(path, (TRIAL, STOPPED)) for path in paths)


def trials_of(records: Sequence[Record], start: Pose, end: float) -> tuple[Trial, ...]:
    """The trial runs of files, in their order.

    Args:
        records: of the files.
        start: planned start of the run, in the frame of the path.
        end: motor position at the end of the run, rad.

    Raises:
        FileError: none, more runs or points than can be used, or points that are not in order.
    """
    trials = [trial for record in records for trial in _trials(record, start, end)]
    if not trials:
        raise FileError("no trial run was given: name at least one CSV file of measured points")
    if len(trials) > MOST_TRIALS:
        raise FileError(f"{len(trials)} trial runs, more than the {MOST_TRIALS} that are used together: keep the last")
    return tuple(trials)


def _trials(record: Record, start: Pose, end: float) -> list[Trial]:
    settings = settings_in(record)
    trials = []
    for number, rows in enumerate(record.parts, 1):
        x, y = record["x_mm"][rows], record["y_mm"][rows]
        if len(x) > MOST_POINTS:
            raise FileError(
                f"{record.source}, run {number}: {len(x)} points, more than the {MOST_POINTS} of the longest trial "
                f"run: keep one in {-(-len(x) // MOST_POINTS)}"
            )
        points = (x - start.x + 1j * (y - start.y)) * np.exp(-1j * start.heading)
        motor = None
        if record.kind is STOPPED:
            motor = np.radians(record["cam_angle_deg"][rows])
            if not (np.diff(motor) > 0).all():
                raise FileError(
                    f"{record.source}, run {number}: cam_angle_deg must grow from row to row: sort the rows"
                )
            keep = motor <= end + 1e-9
            if keep.sum() < 2:
                raise FileError(
                    f"{record.source}, run {number}: fewer than two points lie before {degrees(end):.1f} degrees of "
                    "the cam, where the run ends; measure some along the track"
                )
            points, motor = points[keep], motor[keep]
        trials.append(Trial(points=points, motor=motor, settings=settings))
    return trials
