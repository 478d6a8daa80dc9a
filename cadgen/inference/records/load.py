"""Measured data and trial runs from CSV files: quantity and unit in the header, comments on design and instrument.

The kind of data follows from the columns, and impossible values are refused.

A file of trial runs has the columns `run,x_mm,y_mm`, points in the order of driving in the frame of the path, the last
of each run where the car stopped; or `run,cam_angle_deg,x_mm,y_mm`, where the motor was stopped for each point. A
comment line `# settings: head 0.012 mm, key 0 deg, start 3 -2 mm 0.15 deg` says what was set before its runs. Without
it they ran as designed.
"""

import csv
import hashlib
import re
from collections.abc import Sequence
from dataclasses import replace
from math import degrees, radians
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.running.drive import Pose
from cadgen.errors import FileError, brief, escaped
from cadgen.inference.adjustment import Settings, Trial
from cadgen.inference.measurement.kinds import kind_with, kinds
from cadgen.inference.measurement.kinds.track import KIND as TRACK
from cadgen.inference.measurement.record import (
    Column,
    Kind,
    Method,
    Record,
    refuse_impossible,
    refuse_many,
    refuse_many_runs,
)
from cadgen.messages import Message, joined
from cadgen.reading import read_regular

MOST_BYTES = 32_000_000  # of a file: the longest log with all digits
# Of a file's comment lines, and of the characters of any line: they are searched for words on the instrument.
MOST_REMARKS, LONGEST_LINE = 200, 1000


def load(path: Path, known: Sequence[Kind] | None = None) -> Record:
    """Read one file; the kind of data follows from its columns.

    Args:
        path: of the file.
        known: kinds that it may be of; all that are registered if left out.

    Raises:
        FileError: no such file, no or a mixed header, columns that are missing, a value that is not a number or
            cannot be in its unit, angles that go round twice, or too few rows.
    """
    return load_text(_text(path), escaped(path.name), known)


def load_text(text: str, name: str, known: Sequence[Kind] | None = None) -> Record:
    """Read a file's text; arguments as its content, its name and the kinds that it may be of, errors as `load`."""
    lines = text.splitlines()
    _refuse_long(lines, name)
    remarks = tuple(line.lstrip("# ").strip() for line in lines if line.startswith("#"))
    body = ((n, line) for n, line in enumerate(lines, 1) if line.strip() and not line.startswith("#"))
    top = next(body, None)
    if top is None:
        raise FileError(
            "{name}: no table in it; the first line must name the columns, such as run,cam_angle_deg", name=name
        )
    header = _cells(top[1], top[0], name)
    kind = _kind(header, name, known)
    # Counted before any is kept: of the shortest lines a file has millions.
    refuse_many(kind, sum(1 for line in lines if line.strip() and not line.startswith("#")) - 1, name)
    numbers, rows = [], []
    for n, line in body:
        row = _cells(line, n, name)
        if len(row) != len(header):
            raise FileError(
                "{name}, line {line}: {count} cells under {columns} columns; correct the line, with commas between "
                "cells and decimal points in numbers",
                name=name,
                line=n,
                count=len(row),
                columns=len(header),
            )
        numbers.append(n)
        rows.append(row)
    if not rows:
        raise FileError("{name}: no row stands under its header; add what was measured", name=name)
    table = {column: [row[k] for row in rows] for k, column in enumerate(header)}
    columns: dict[str, NDArray[np.generic]] = {
        column.name: (_words if column.words else _numbers)(table[column.name], column, numbers, name)
        for column in kind.columns
    }
    if kind.method is Method.ZONE_MEANS:
        columns[kind.key] = np.array(table[kind.key])
        return Record(kind=kind, columns=columns, run=np.zeros(len(rows), dtype=np.intp), remarks=remarks, source=name)
    run = np.unique(np.array(table[kind.key]), return_inverse=True)
    refuse_many_runs(kind, len(rows), len(run[0]), name)
    first = np.unique(run[1], return_index=True)[1]
    order = np.argsort(np.argsort(first))
    number = order[run[1]].astype(np.intp)
    # Rows of runs that were written in turns are brought together.
    at = np.argsort(number, kind="stable")
    record = Record(
        kind=kind,
        columns={column: values[at] for column, values in columns.items()},
        run=number[at],
        remarks=remarks,
        source=name,
    )
    refuse_impossible(record)
    return record


def digest(path: Path) -> str:
    """SHA-256 of the file's bytes, hexadecimal, to be kept with the results."""
    return hashlib.sha256(read_regular(path, MOST_BYTES)).hexdigest()


def _refuse_long(lines: list[str], name: str) -> None:
    if long := next((n for n, line in enumerate(lines, 1) if len(line) > LONGEST_LINE), None):
        raise FileError(
            "{name}, line {long}: {count} characters, more than the {most} of the longest line that there can "
            "be; correct the line",
            name=name,
            long=long,
            count=len(lines[long - 1]),
            most=LONGEST_LINE,
        )
    if (remarks := sum(line.startswith("#") for line in lines)) > MOST_REMARKS:
        raise FileError(
            "{name}: {remarks} comment lines, more than {most}; keep those that tell design and instrument",
            name=name,
            remarks=remarks,
            most=MOST_REMARKS,
        )


def _text(path: Path) -> str:
    name = brief(str(path))
    try:
        content = read_regular(path, MOST_BYTES)
    except FileNotFoundError:
        raise FileError("there is no file {name}: correct its name", name=name) from None
    except IsADirectoryError:
        raise FileError("{name} is a folder: give the files in it", name=name) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise FileError(
            "{name} cannot be read ({reason}): give a CSV file that can", name=name, reason=reason
        ) from None
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise FileError("{name} is not text in UTF-8: give a CSV file", name=name)
    return text


def _cells(line: str, number: int, name: str) -> list[str]:
    try:
        return [cell.strip() for cell in next(csv.reader([line], strict=True))]
    except csv.Error as error:
        raise FileError("{name}, line {line}: {error}; correct the line", name=name, line=number, error=error) from None


def _kind(header: list[str], name: str, known: Sequence[Kind] | None) -> Kind:
    """The kind of data whose columns are those of the header."""
    if len(set(header)) < len(header):
        twice = next(c for c in header if header.count(c) > 1)
        raise FileError("{name}: column {twice} stands twice; keep one", name=name, twice=brief(twice))
    if len(header) == 1 and (mark := next((m for m in ";\t" if m in header[0]), None)):
        marks = Message("semicolons") if mark == ";" else Message("tabs")
        raise FileError(
            "{name}: its columns are set apart by {marks}; save it with commas, and with decimal points",
            name=name,
            marks=marks,
        )
    exact = kind_with(header) if known is None else next((k for k in known if set(header) == set(k.header)), None)
    if exact is not None:
        return exact
    known = kinds() if known is None else known
    near = max(known, key=lambda kind: (sum(c.name in header for c in kind.columns), -len(kind.columns)))
    lacking = [c for c in near.header if c not in header]
    more = [c for c in header if c not in near.header]
    differs = [
        *([Message("lacks {columns}", columns=brief(", ".join(lacking)))] if lacking else []),
        *([Message("does not have {columns}", columns=brief(", ".join(more)))] if more else []),
    ]
    raise FileError(
        "{name}: the columns {names} are no kind of measured data; nearest is {kind}, which {differs}",
        name=name,
        names=brief(", ".join(header)),
        kind=near.code,
        differs=joined(differs, " and "),
    )


def _words(cells: Sequence[str], column: Column, lines: Sequence[int], name: str) -> NDArray[np.str_]:
    for line, cell in zip(lines, cells, strict=True):
        if cell not in column.words:
            allowed = " or ".join(column.words)
            raise FileError(
                "{name}, line {line}: {column} is {cell}; write {allowed}",
                name=name,
                line=line,
                column=column.name,
                cell=brief(repr(cell)),
                allowed=allowed,
            )
    return np.array(cells)


def _numbers(cells: Sequence[str], column: Column, lines: Sequence[int], name: str) -> Array:
    values = np.empty(len(cells))
    for k, cell in enumerate(cells):
        try:
            values[k] = float(cell)
        except ValueError:
            values[k] = np.nan
        if not np.isfinite(values[k]):
            raise FileError(
                "{name}, line {line}: {column} is {cell}; every value must be a finite number",
                name=name,
                line=lines[k],
                column=column.name,
                cell=brief(repr(cell)),
            )
    low, high = column.lower, column.upper
    bad = np.flatnonzero((values < low) | (values > high))
    if bad.size:
        raise FileError(
            "{name}, line {line}: {column} is {value:g}, outside {low:g} to {high:g}; check the unit in the header, "
            "and number each turn as its own run",
            name=name,
            line=lines[bad[0]],
            column=column.name,
            value=values[bad[0]],
            low=low,
            high=high,
        )
    return values


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
                '{file}: the comment line "{remark}" is not understood; write it as "# {example}"',
                file=record.source,
                remark=brief(remark, 60),
                example=settings_line(Settings()),
            )
        head, key, x, y, heading = map(float, match.groups())
        stated.append(Settings(head=head, key=radians(key), start_x=x, start_y=y, start_heading=radians(heading)))
    if len(set(stated)) > 1:
        raise FileError(
            "{file}: its comment lines give different settings; put each into a file of its own", file=record.source
        )
    return stated[0] if stated else Settings()


def read_trials(paths: Sequence[Path]) -> tuple[Record, ...]:
    """Files of trial runs, in their order.

    Raises:
        FileError: a file that cannot be read or holds no trial run, or the same twice.
    """
    seen: dict[Path, Path] = {}
    for path in paths:
        if (same := seen.setdefault(path.resolve(), path)) is not path:
            raise FileError("{same} was given twice; give each file once", same=same)
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
        raise FileError(
            "{count} trial runs, more than the {most} that are used together: keep the last",
            count=len(trials),
            most=MOST_TRIALS,
        )
    return tuple(trials)


def _trials(record: Record, start: Pose, end: float) -> list[Trial]:
    settings = settings_in(record)
    trials = []
    for number, rows in enumerate(record.parts, 1):
        x, y = record["x_mm"][rows], record["y_mm"][rows]
        if len(x) > MOST_POINTS:
            raise FileError(
                "{file}, run {run}: {count} points, more than the {most} of the longest trial run: keep one in {share}",
                file=record.source,
                run=number,
                count=len(x),
                most=MOST_POINTS,
                share=-(-len(x) // MOST_POINTS),
            )
        points = (x - start.x + 1j * (y - start.y)) * np.exp(-1j * start.heading)
        motor = None
        if record.kind is STOPPED:
            motor = np.radians(record["cam_angle_deg"][rows])
            if not (np.diff(motor) > 0).all():
                raise FileError(
                    "{file}, run {run}: cam_angle_deg must grow from row to row: sort the rows",
                    file=record.source,
                    run=number,
                )
            keep = motor <= end + 1e-9
            if keep.sum() < 2:
                raise FileError(
                    "{file}, run {run}: fewer than two points lie before {end:.1f} degrees of the cam, where the run "
                    "ends; measure some along the track",
                    file=record.source,
                    run=number,
                    end=degrees(end),
                )
            points, motor = points[keep], motor[keep]
        trials.append(Trial(points=points, motor=motor, settings=settings))
    return trials
