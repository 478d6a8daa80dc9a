"""Read measured data: CSV files whose header names quantity and unit, comment lines that tell design and instrument."""

import csv
import hashlib
import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from cadgen.errors import FileError, brief, escaped
from cadgen.measurement.record import Kind, Record
from cadgen.reading import read_given

# Columns of each kind beside `run`, and the range that each value can have.
COLUMNS: dict[Kind, tuple[str, ...]] = {
    "lift": ("direction", "cam_angle_deg", "lift_mm"),
    "profile": ("x_mm", "y_mm"),
    "transmission": ("motor_angle_deg", "cam_angle_deg"),
    "track": ("cam_angle_deg", "x_mm", "y_mm"),
    "steered track": ("t_s", "distance_mm", "steering_deg", "x_mm", "y_mm", "heading_deg"),
    "zones": ("cam_angle_deg", "std_deg", "n"),
}
LIMITS = {
    "lift": {"cam_angle_deg": (-1.0, 361.0), "lift_mm": (-100.0, 100.0)},
    "profile": {"x_mm": (-1e3, 1e3), "y_mm": (-1e3, 1e3)},
    "transmission": {"motor_angle_deg": (-1e6, 1e6), "cam_angle_deg": (-800.0, 800.0)},
    "track": {"cam_angle_deg": (-1.0, 361.0), "x_mm": (-1e6, 1e6), "y_mm": (-1e6, 1e6)},
    "steered track": {
        "t_s": (0.0, 1e6),
        "distance_mm": (-1e7, 1e7),
        "steering_deg": (-180.0, 180.0),
        "x_mm": (-1e6, 1e6),
        "y_mm": (-1e6, 1e6),
        "heading_deg": (-1e5, 1e5),
    },
    "zones": {"cam_angle_deg": (0.0, 720.0), "std_deg": (1e-6, 90.0), "n": (2.0, 1e9)},
}
# A mistaken unit (rad for deg, um for mm, m for mm) makes every value of a column smaller than this.
LEAST_SPAN = {"cam_angle_deg": 10.0, "motor_angle_deg": 90.0, "distance_mm": 50.0}
LEAST_ROWS = 24  # of each run: fewer cannot tell a harmonic from a bump
# Of one kind: the catalogue has some 2000 columns of them, and must fit into memory. Logs of steering are thinned.
MOST_ROWS, MOST_LOGGED = 20_000, 200_000
MOST_RUNS = 100  # each brings columns of its own, such as its start pose; real cars are driven ten times
MOST_TURN_DEG = 400.0  # of a camshaft that is to turn once and come back
MOST_BYTES = 32_000_000  # of a file: the longest log with all digits
# Of a file's comment lines, and of the characters of any line: they are searched for what they say of the instrument.
MOST_REMARKS, LONGEST_LINE = 200, 1000


@dataclass(frozen=True)
class Instrument:
    """What a file says of the instrument, in the file's unit: noise, or nan if it is silent."""

    noise: float
    unit: str


def load(path: Path) -> Record:
    """Read one file; its kind follows from its columns.

    Raises:
        FileError: no such file, no or a mixed header, columns that are missing, a value that is not a number or
            cannot be in its unit, angles that go round twice, or too few rows.
    """
    name = escaped(path.name)
    lines = _text(path).splitlines()
    _refuse_long(lines, name)
    remarks = tuple(line.lstrip("# ").strip() for line in lines if line.startswith("#"))
    body = ((n, line) for n, line in enumerate(lines, 1) if line.strip() and not line.startswith("#"))
    top = next(body, None)
    if top is None:
        raise FileError(f"{name}: no table in it; the first line must name the columns, such as run,cam_angle_deg")
    header = _cells(top[1], top[0], name)
    kind = _kind(header, name)
    # Counted before any is kept: of the shortest lines a file has millions.
    _refuse_many(kind, sum(1 for line in lines if line.strip() and not line.startswith("#")) - 1, name)
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
    columns: dict[str, np.ndarray[tuple[int], np.dtype[np.generic]]] = {}
    for column in COLUMNS[kind]:
        cells = table[column]
        if column == "direction":
            bad = [k for k, cell in enumerate(cells) if cell not in ("forward", "reverse")]
            if bad:
                wrong = brief(repr(cells[bad[0]]))
                raise FileError(f"{name}, line {numbers[bad[0]]}: direction is {wrong}; write forward or reverse")
            columns[column] = np.array(cells)
        else:
            columns[column] = _numbers(cells, column, numbers, name, LIMITS[kind].get(column, (-np.inf, np.inf)))
    if kind == "zones":
        columns["zone"] = np.array(table["zone"])
        return Record(kind=kind, columns=columns, run=np.zeros(len(rows), dtype=np.intp), remarks=remarks, source=name)
    run = np.unique(np.array(table["run"]), return_inverse=True)
    _refuse_many_runs(len(run[0]), name)
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
    _check(record)
    return record


def instrument(record: Record) -> Instrument:
    """Noise that the comment lines state."""
    for remark in record.remarks:
        found = re.search(r"noise\s+([0-9.]+)\s*(um|mm|deg)\b", remark)
        if found:
            return Instrument(float(found[1]), found[2])
    return Instrument(float("nan"), "")


def printed(record: Record) -> bool:
    """True if a comment line says that the part was printed, not machined."""
    return any(re.search(r"\bprinted\b", remark) for remark in record.remarks)


def said(record: Record, pattern: str) -> tuple[str, ...]:
    """What the comment lines say in so many words: the groups of a pattern's first match, or nothing."""
    for remark in record.remarks:
        if found := re.search(pattern, remark):
            return found.groups()
    return ()


def digest(path: Path) -> str:
    """SHA-256 of the file, to be kept with what was learnt from it."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def most_rows(kind: Kind) -> int:
    """How many rows of a kind can be judged together."""
    return MOST_LOGGED if kind == "steered track" else MOST_ROWS


def join(records: Sequence[Record]) -> Record:
    """Several records of one kind as one, their runs numbered on.

    Raises:
        FileError: nothing to join, or records of different kinds.
    """
    if not records:
        raise FileError("no measured file was given; name at least one")
    kinds = {record.kind for record in records}
    if len(kinds) > 1:
        raise FileError(f"{', '.join(r.source for r in records)}: kinds {sorted(kinds)} cannot be joined as one")
    rows = sum(len(record.run) for record in records)
    name = " + ".join(r.source for r in records)
    _refuse_many(records[0].kind, rows, name)
    if len(records) == 1:
        return records[0]
    if records[0].kind != "zones":
        _refuse_many_runs(sum(record.runs for record in records), name)
    before = np.cumsum([0, *(record.runs for record in records)])
    return Record(
        kind=records[0].kind,
        columns={c: np.concatenate([r.columns[c] for r in records]) for c in records[0].columns},
        run=np.concatenate([r.run + n for r, n in zip(records, before, strict=False)]),
        remarks=tuple(remark for record in records for remark in record.remarks),
        source=" + ".join(record.source for record in records),
    )


def _refuse_many(kind: Kind, rows: int, name: str) -> None:
    most = most_rows(kind)
    if rows > most:
        raise FileError(
            f"{name}: {rows} rows, more than the {most} that can be judged together; "
            f"keep one row in {-(-rows // most)}, or give fewer files"
        )


def _refuse_many_runs(runs: int, name: str) -> None:
    if runs > MOST_RUNS:
        raise FileError(
            f"{name}: {runs} runs, more than the {MOST_RUNS} that can be judged together; keep one run in "
            f"{-(-runs // MOST_RUNS)}, or give fewer files"
        )


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
        content = read_given(path, MOST_BYTES)
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


def _kind(header: list[str], name: str) -> Kind:
    """The most demanding kind whose columns are all there; columns of two kinds are a mixture."""
    if len(set(header)) < len(header):
        twice = next(c for c in header if header.count(c) > 1)
        raise FileError(f"{name}: column {brief(twice)} stands twice; keep one")
    if len(header) == 1 and (mark := next((m for m in ";\t" if m in header[0]), None)):
        told = "semicolons" if mark == ";" else "tabs"
        raise FileError(f"{name}: its columns are set apart by {told}; save it with commas, and with decimal points")
    lead = {"zones": "zone"}
    exact: list[Kind] = [k for k, c in COLUMNS.items() if set(header) == {lead.get(k, "run"), *c}]
    if exact:
        return exact[0]
    near = max(COLUMNS, key=lambda k: (len(set(COLUMNS[k]) & set(header)), -len(COLUMNS[k])))
    wanted = [lead.get(near, "run"), *COLUMNS[near]]
    parts = {
        "lacks": [c for c in wanted if c not in header],
        "does not have": [c for c in header if c not in wanted],
    }
    told = " and ".join(f"{verb} {brief(', '.join(columns))}" for verb, columns in parts.items() if columns)
    raise FileError(
        f"{name}: the columns {brief(', '.join(header))} are no kind of measured data; nearest is {near}, which {told}"
    )


def _numbers(
    cells: list[str], column: str, lines: list[int], name: str, limits: tuple[float, float]
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    values = np.empty(len(cells))
    for k, cell in enumerate(cells):
        try:
            values[k] = float(cell)
        except ValueError:
            values[k] = np.nan
        if not np.isfinite(values[k]):
            raise FileError(
                f"{name}, line {lines[k]}: {column} is {brief(repr(cell))}; every value must be a finite number"
            )
    low, high = limits
    bad = np.flatnonzero((values < low) | (values > high))
    if bad.size:
        raise FileError(
            f"{name}, line {lines[bad[0]]}: {column} is {values[bad[0]]:g}, outside {low:g} to {high:g}; "
            "check the unit in the header, and number each turn as its own run"
        )
    return values


def _check(record: Record) -> None:
    # One column after the other, rows in the order of runs: a run is a slice, and its digits are its name.
    readings = np.stack([record[c] for c in _numeric(record)])
    bounds = [0, *(np.flatnonzero(np.diff(record.run)) + 1).tolist(), len(record.run)]
    runs = [slice(start, stop) for start, stop in pairwise(bounds)]
    seen: dict[bytes, int] = {}
    for later, mine in enumerate(runs):
        part = readings[:, mine]
        earlier = seen.setdefault(part.tobytes(), later)
        if earlier != later:
            raise FileError(
                f"{record.source}: runs {earlier + 1} and {later + 1} are the same to the last digit; a copy is no "
                "repetition: give runs that were measured anew"
            )
    spans = {column: (record[column], least) for column, least in LEAST_SPAN.items() if column in record.columns}
    for run, mine in enumerate(runs):
        if mine.stop - mine.start < LEAST_ROWS:
            raise FileError(
                f"{record.source}: run {run + 1} has {mine.stop - mine.start} rows; give at least {LEAST_ROWS} in each "
                "run"
            )
        for column, (values, least) in spans.items():
            if np.ptp(values[mine]) < least:
                raise FileError(
                    f"{record.source}: {column} of run {run + 1} spans only {np.ptp(values[mine]):g}; "
                    f"check its unit, or measure at least {least:g}"
                )
    if record.kind == "lift":
        key = np.stack([record.run, record.columns["direction"] == "forward", record["cam_angle_deg"] % 360.0])
        whole = record["cam_angle_deg"] % 360.0 == 0  # 0 and 360 may both be there
        _refuse_twice(record, key[:, ~whole], "cam_angle_deg")
    if record.kind == "track":
        _refuse_twice(record, np.stack([record.run, record["cam_angle_deg"]]), "cam_angle_deg")
    if record.kind == "transmission":
        turned = record["cam_angle_deg"]
        for run, mine in enumerate(runs):
            turn = float(np.ptp(turned[mine]))
            if turn > MOST_TURN_DEG:
                raise FileError(
                    f"{record.source}: the cam of run {run + 1} turns by {turn:.0f} degrees, so the angle goes round "
                    "more than once; number each turn, forward and back, as its own run"
                )
    if record.kind == "profile":
        turned = np.arctan2(record["y_mm"], record["x_mm"])
        for run, mine in enumerate(runs):
            steps = np.diff(turned[mine])
            swept = float(np.sum((steps + np.pi) % (2 * np.pi) - np.pi))
            if abs(swept) > 2 * np.pi + 0.5:
                raise FileError(
                    f"{record.source}: run {run + 1} goes round {abs(swept) / (2 * np.pi):.1f} times; "
                    "number each turn as its own run"
                )


def _numeric(record: Record) -> list[str]:
    return [name for name, values in record.columns.items() if values.dtype.kind == "f"]


def _refuse_twice(record: Record, key: np.ndarray[tuple[int, int], np.dtype[np.generic]], column: str) -> None:
    unique, count = np.unique(key, axis=1, return_counts=True)
    if (count > 1).any():
        where = unique[-1, int(np.argmax(count))]
        raise FileError(
            f"{record.source}: {column} {float(where):g} stands twice in one run, so the angle goes round more than "
            "once; number each turn as its own run"
        )
