"""Read measured data: CSV files with quantity and unit in the header; comment lines on design and instrument."""

import csv
import hashlib
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import FileError, brief, escaped
from cadgen.inference.measurement.kinds import kinds
from cadgen.inference.measurement.record import (
    Column,
    Kind,
    Method,
    Record,
    refuse_impossible,
    refuse_many,
    refuse_many_runs,
)
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
        raise FileError(f"{name}: no table in it; the first line must name the columns, such as run,cam_angle_deg")
    header = _cells(top[1], top[0], name)
    kind = _kind(header, name, kinds() if known is None else known)
    # Counted before any is kept: of the shortest lines a file has millions.
    refuse_many(kind, sum(1 for line in lines if line.strip() and not line.startswith("#")) - 1, name)
    numbers, rows = [], []
    for n, line in body:
        row = _cells(line, n, name)
        if len(row) != len(header):
            raise FileError(
                f"{name}, line {n}: {len(row)} cells under {len(header)} columns; correct the line, with commas "
                "between cells and decimal points in numbers"
            )
        numbers.append(n)
        rows.append(row)
    if not rows:
        raise FileError(f"{name}: no row stands under its header; add what was measured")
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
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _refuse_long(lines: list[str], name: str) -> None:
    if long := next((n for n, line in enumerate(lines, 1) if len(line) > LONGEST_LINE), None):
        raise FileError(
            f"{name}, line {long}: {len(lines[long - 1])} characters, more than the {LONGEST_LINE} of the longest line "
            "that there can be; correct the line"
        )
    if (remarks := sum(line.startswith("#") for line in lines)) > MOST_REMARKS:
        raise FileError(
            f"{name}: {remarks} comment lines, more than {MOST_REMARKS}; keep those that tell design and instrument"
        )


def _text(path: Path) -> str:
    name = brief(str(path))
    try:
        content = read_regular(path, MOST_BYTES)
    except FileNotFoundError:
        raise FileError(f"there is no file {name}: correct its name") from None
    except IsADirectoryError:
        raise FileError(f"{name} is a folder: give the files in it") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise FileError(f"{name} cannot be read ({reason}): give a CSV file that can") from None
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise FileError(f"{name} is not text in UTF-8: give a CSV file")
    return text


def _cells(line: str, number: int, name: str) -> list[str]:
    try:
        return [cell.strip() for cell in next(csv.reader([line], strict=True))]
    except csv.Error as error:
        raise FileError(f"{name}, line {number}: {error}; correct the line") from None


def _kind(header: list[str], name: str, known: Sequence[Kind]) -> Kind:
    """The kind of data whose columns are those of the header."""
    if len(set(header)) < len(header):
        twice = next(c for c in header if header.count(c) > 1)
        raise FileError(f"{name}: column {brief(twice)} stands twice; keep one")
    if len(header) == 1 and (mark := next((m for m in ";\t" if m in header[0]), None)):
        marks = "semicolons" if mark == ";" else "tabs"
        raise FileError(f"{name}: its columns are set apart by {marks}; save it with commas, and with decimal points")
    if exact := [kind for kind in known if set(header) == set(kind.header)]:
        return exact[0]
    near = max(known, key=lambda kind: (len(_names(kind) & set(header)), -len(kind.columns)))
    parts = {
        "lacks": [c for c in near.header if c not in header],
        "does not have": [c for c in header if c not in near.header],
    }
    differs = " and ".join(f"{verb} {brief(', '.join(columns))}" for verb, columns in parts.items() if columns)
    raise FileError(
        f"{name}: the columns {brief(', '.join(header))} are no kind of measured data; nearest is {near.code}, which "
        f"{differs}"
    )


def _names(kind: Kind) -> set[str]:
    return {column.name for column in kind.columns}


def _words(cells: Sequence[str], column: Column, lines: Sequence[int], name: str) -> NDArray[np.str_]:
    for line, cell in zip(lines, cells, strict=True):
        if cell not in column.words:
            allowed = " or ".join(column.words)
            raise FileError(f"{name}, line {line}: {column.name} is {brief(repr(cell))}; write {allowed}")
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
                f"{name}, line {lines[k]}: {column.name} is {brief(repr(cell))}; every value must be a finite number"
            )
    low, high = column.lower, column.upper
    bad = np.flatnonzero((values < low) | (values > high))
    if bad.size:
        raise FileError(
            f"{name}, line {lines[bad[0]]}: {column.name} is {values[bad[0]]:g}, outside {low:g} to {high:g}; "
            "check the unit in the header, and number each turn as its own run"
        )
    return values
