"""Measured data and trial runs from files: quantity and unit in the header, comments on design and instrument.

The kind of data follows from the columns, and impossible values are refused.

A file of trial runs has the columns `run,x_mm,y_mm`, points in the order of driving in the frame of the path, the last
of each run where the car stopped; or `run,cam_angle_deg,x_mm,y_mm`, where the motor was stopped for each point. A
comment line `# settings: head 0.012 mm, key 0 deg, start 3 -2 mm 0.15 deg` says what was set before its runs. Without
it they ran as designed.
"""

import hashlib
import re
from collections.abc import Sequence
from contextlib import suppress
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
from cadgen.inference.records.cell_numbers import plain_numbers
from cadgen.inference.records.columns import AS_NAMED, Match, Reading, match_columns
from cadgen.inference.records.side_by_side import brought_under
from cadgen.inference.records.table_rows import TableRows, each_once, rows_of, thinned, with_numbers
from cadgen.inference.records.text_table import HEAD_LINES, head_of, is_remark, text_of
from cadgen.inference.records.units import TIMES, WORDS, heading, other_length
from cadgen.messages import Message
from cadgen.reading import read_regular

MOST_BYTES = 32_000_000  # of a file: the longest log with all digits


def load(path: Path, known: Sequence[Kind] | None = None, reading: Reading = AS_NAMED) -> Record:
    """Read one file; the kind of data follows from its columns.

    Args:
        path: of the file.
        known: kinds that it may be of; all that are registered if left out.
        reading: how its columns are to be understood.

    Raises:
        FileError: no such file, no or a mixed header, columns that are missing, a value that is not a number or
            cannot be in its unit, angles that go round twice, or too few rows.
    """
    content, name = _content(path), escaped(path.name)

    def named(text: str) -> int:
        # Number of the names of columns that are known, in one of the first lines.
        lines = [line for line in text.splitlines()[:HEAD_LINES] if not is_remark(line)]
        return max((_known_names(re.split(r"[;\t,|]", line), known, reading) for line in lines), default=0)

    text, notes = text_of(content, name, named)
    record = load_text(text, name, known, reading)
    return replace(record, notes=(*notes, *record.notes)) if notes else record


def load_text(text: str, name: str, known: Sequence[Kind] | None = None, reading: Reading = AS_NAMED) -> Record:
    """Read a file's text; `name` of the file for messages, other arguments and errors as `load`."""
    head = head_of(text, name, lambda cells: _known_names(cells, known, reading))
    exact = None if known is not None or reading.columns else kind_with(head.names)
    among = (exact,) if exact else known or kinds()
    # Counted before any is kept: of the shortest lines a file has millions.
    refuse_many(max(kind.most_read for kind in among), len(head.body), name)
    try:
        rows = rows_of(head, name)
    except FileError:
        # Names that are none explain rows that do not fit them.
        match_columns(head.names, name, among, reading)
        raise
    table, match = _matched(plain_numbers(rows, name), name, among, reading)
    _refuse_unit_of_remark((*head.remarks, *table.passed), table.names, match, reading, name)
    kind = match.kind
    table = with_numbers(table, [match.places[column.name].index for column in kind.columns if not column.words])
    if not kind.counts:
        table = each_once(table, [match.places[c].index for c in kind.header if c in match.places])
    if kind.most_logged:
        table = thinned(table, kind.most_rows)
    refuse_many(kind.most_rows, len(table.lines), name)
    columns: dict[str, NDArray[np.generic]] = {}
    for column in kind.columns:
        place = match.places[column.name]
        cells = table.columns[place.index]
        if column.words:
            meant = next((each for each in WORDS if set(column.words) <= set(each.values())), {})
            words = [meant.get(cell.lower(), cell) for cell in cells]
            columns[column.name] = _words(words, column, table.lines, name)
        else:
            columns[column.name] = _numbers(cells, column, table.lines, name, place.factor)
    for column in kind.beside:
        # Times of day and the like are passed over.
        with suppress(KeyError, FileError):
            place = match.places[column.name]
            columns[column.name] = _numbers(table.columns[place.index], column, table.lines, name, place.factor)
    key = match.places.get(kind.key)
    # Titles stand for the cells of runs that are empty.
    if key is not None and not any(table.columns[key.index]):
        key = None
    if key is not None:
        _refuse_runs_in_blocks(table, table.columns[key.index], name)
    keys = np.array([str(block) for block in table.blocks] if key is None else table.columns[key.index])
    if key is None:
        one = Message("without a column {key} it is one run", key=kind.key)
        blocks = Message("without a column {key} each block of rows is a run", key=kind.key)
        table = table.noted(blocks if max(table.blocks) else one)
    notes = (*head.notes, *match.notes, *table.notes)
    if kind.method is Method.ZONE_MEANS:
        columns[kind.key] = keys
        none = np.zeros(len(keys), dtype=np.intp)
        return Record(kind=kind, columns=columns, run=none, remarks=head.remarks, source=name, notes=notes)
    run = np.unique(keys, return_inverse=True)
    refuse_many_runs(kind, len(keys), len(run[0]), name)
    first = np.unique(run[1], return_index=True)[1]
    order = np.argsort(np.argsort(first))
    number = order[run[1]].astype(np.intp)
    # Rows of runs that were written in turns are brought together.
    at = np.argsort(number, kind="stable")
    record = Record(
        kind=kind,
        columns={column: values[at] for column, values in columns.items()},
        run=number[at],
        remarks=head.remarks,
        source=name,
        notes=notes,
    )
    refuse_impossible(record)
    return record


def _matched(table: TableRows, name: str, among: Sequence[Kind], reading: Reading) -> tuple[TableRows, Match]:
    """Table and its match to a kind of data, runs that stood side by side brought under each other."""
    quantities = {heading(column).quantity for kind in among for column in kind.header}
    if not reading.columns and (beside := brought_under(table, quantities | set(TIMES))):
        under, several = beside
        try:
            match = match_columns(under.names, name, among, reading)
        except FileError:
            match = None
        if match and {heading(reading_name).quantity for reading_name in match.kind.readings} <= several:
            return under, match
    return table, match_columns(table.names, name, among, reading)


def _refuse_runs_in_blocks(table: TableRows, runs: Sequence[str], name: str) -> None:
    """Refuse a run that stands in two blocks of rows: it may be two runs."""
    first: dict[str, int] = {}
    for run, block, line in zip(runs, table.blocks, table.lines, strict=True):
        if first.setdefault(run, block) != block:
            raise FileError(
                "{name}, line {line}: run {run} stands under another head already: number the runs apart, or take the "
                "lines between its rows out",
                name=name,
                line=line,
                run=brief(run),
            )


def _refuse_unit_of_remark(
    remarks: Sequence[str], names: Sequence[str], match: Match, reading: Reading, name: str
) -> None:
    """Refuse another unit than mm that a title or remark alone says, where a column of lengths has none."""
    bare = (
        names[place.index]
        for column, place in match.places.items()
        if column not in reading.columns
        and heading(column).factor("mm") is not None
        and heading(column).unit
        and not heading(names[place.index]).unit
    )
    column = next(bare, None)
    if column is not None and (said := other_length(remarks)):
        raise FileError(
            "{name}: a line beside its table says {unit}, and the column {column} has no unit: write it there, as in "
            '"{column} [{unit}]"',
            name=name,
            unit=said[1],
            column=brief(column),
        )


def _known_names(cells: Sequence[str], known: Sequence[Kind] | None, reading: Reading) -> int:
    """Number of cells that are known as names of columns."""
    if known is None and kind_with(cells) is not None:
        return len(cells)
    names = [column for kind in known or kinds() for column in kind.header] + list(reading.columns.values())
    quantities = {heading(column).quantity for column in names} | set(TIMES)
    return len({heading(cell).quantity for cell in cells} & quantities)


def digest(path: Path) -> str:
    """SHA-256 of the file's bytes, hexadecimal, to be kept with the results."""
    return hashlib.sha256(read_regular(path, MOST_BYTES)).hexdigest()


def _content(path: Path) -> bytes:
    name = brief(str(path))
    try:
        return read_regular(path, MOST_BYTES)
    except FileNotFoundError:
        raise FileError("there is no file {name}: correct its name", name=name) from None
    except IsADirectoryError:
        raise FileError("{name} is a folder: give the files in it", name=name) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise FileError(
            "{name} cannot be read ({reason}): give a CSV file that can", name=name, reason=reason
        ) from None


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


def _numbers(cells: Sequence[str], column: Column, lines: Sequence[int], name: str, factor: float = 1.0) -> Array:
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
    values *= factor
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


def read_trials(paths: Sequence[Path], reading: Reading = AS_NAMED) -> tuple[Record, ...]:
    """Files of trial runs, in their order; `reading` says how their columns are to be understood.

    Raises:
        FileError: a file that cannot be read or holds no trial run, or the same twice.
    """
    seen: dict[Path, Path] = {}
    for path in paths:
        if (same := seen.setdefault(path.resolve(), path)) is not path:
            raise FileError("{same} was given twice; give each file once", same=same)
    in_order = replace(reading, by_order=True)
    return tuple(load(path, (TRIAL, STOPPED), in_order) for path in paths)


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
