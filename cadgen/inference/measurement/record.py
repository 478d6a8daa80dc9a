"""Kinds of measured data, records of a kind as read, what their comment lines say, and what no record may be.

A record is refused if no instrument reads it: copied runs, too few rows, angles that go round twice, or numbers of
another unit than the header says, by what the design lets expect.
"""

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from enum import Enum, StrEnum
from itertools import pairwise
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.catalogue import Catalogue
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.effect import Active, Effect
from cadgen.errors import DesignError, FileError
from cadgen.inference.measurement.model import Model
from cadgen.messages import Message, joined

# Of one kind: the catalogue has some 2000 columns of them, and must fit into memory.
MOST_ROWS = 20_000
LEAST_ROWS = 24  # of each run: fewer cannot tell a harmonic from a bump
MOST_RUNS = 100  # each brings columns of its own, such as its start pose; real cars are driven ten times
MOST_TOGETHER = 10_000  # rows of several kinds, whose effects all act in each: 1.8 GB
MOST_ENTRIES = 500_000  # rows times runs, in columns of runs and their products: 0.9 GB


class Method(Enum):
    """How the effects of a kind of data are chosen."""

    EVIDENCE = "likelihood of the residuals, with noise and form error; each run left out tests the result"
    RUNS_LEFT_OUT = "path error on runs left out, where small errors add up along the run"
    ZONE_MEANS = "least squares of mean turns; there are no runs"


class Abscissa(Enum):
    """Label of the axis over which a picture shows the residual."""

    CAM_ANGLE = "cam angle (°)"
    TRAVEL = "travel of the drive wheel (m)"
    SHARE = "part of the run (%)"


class Direction(StrEnum):
    """Direction in which the cam turned to a reading, as files have it."""

    FORWARD = "forward"
    REVERSE = "reverse"


@dataclass(frozen=True, kw_only=True)
class Column:
    """A column of a file.

    Attributes:
        name: with the unit at its end.
        lower, upper: what a number can be, in that unit.
        words: that a column of text may hold; empty for numbers.
        least_span: of the numbers of each run. A mistaken unit (rad for deg, um for mm, m for mm) makes it smaller.
    """

    name: str
    lower: float = -np.inf
    upper: float = np.inf
    words: tuple[str, ...] = ()
    least_span: float = 0.0


@dataclass(frozen=True)
class Span:
    """How far readings span, and how far the design or another column lets expect, both in one unit."""

    columns: str
    measured: float
    expected: float
    unit: str


# (model, residual, its sigma, active effects, values of the datum's effects) -> values of each run and their standard
# deviations, shape (runs, numbers) each, internal units.
DatumFit = Callable[[Any, Array, Array, Active, list[tuple[Effect, Array, Array]]], tuple[Array, Array]]


@dataclass(frozen=True, kw_only=True)
class Datum:
    """Freedoms that are fitted to each run and never claimed.

    Attributes:
        words: as in "fitted and never claimed: the start pose of each run".
        name: of one run's.
        numbers: name and unit of each; they are the model's `offsets`, run by run.
        fit: of the numbers, where they are not the offsets alone.
        notes: (model, values, standard deviations) -> what was known of them beforehand, in words, and what speaks
            against that; shape (runs, numbers) each, internal units.
    """

    words: str
    name: str = ""
    numbers: tuple[tuple[str, str], ...] = ()
    fit: DatumFit | None = None
    notes: Callable[[Any, Array, Array], tuple[str, tuple[str, ...]]] | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Kind:
    """A kind of measured data: everything that reading, judging and showing it need to know.

    Attributes:
        code: unique, as files write it.
        title: of its page of effects.
        columns: beside `key`. A file is of the kind if it has exactly these and `key`, in any order.
        key: column that tells the rows apart: runs, numbered in order of appearance, or names of zones.
        readings: columns that the instrument reads; the steps of their numbers are noise.
        catalogue: the effects that can show.
        method: how they are chosen.
        datum: what is fitted to each run and never claimed.
        model: (record, `Nominal` or `LoggedCar`) -> the forward model of the record; None where there is none.
        check: refuses a record that cannot be, beside what is checked of all kinds.
        settled: (record, names of the effects that it shows by itself) -> the record. A remark says the state of the
            car in which it was taken, where its file does not.
        spans: (record, the same) -> what betrays numbers of another unit.
        most_rows: of all files of the kind together.
        least_rows: of each run.
        counts: most steps over the span of the readings with which an instrument that counts, such as an encoder, may
            read the same in every run; 0 where no two runs are ever alike.
        wanders: whether its instrument may wander slowly during a run, as encoders do that are read at kHz, so that
            the noise of neighbouring rows is alike.
        around: whether it is to show the whole turn of the cam, as few and far points cannot.
        absences: quantities of which a sound verdict that does not name them says that there is little.
        noise: standard deviation of a reading by a usual instrument, internal units, where no record shows better.
        nearness: among kinds that show one quantity, the least is nearest to what the car drives with.
        rod_on: whether the rod is on the disc and the car runs, so that friction acts beside the play.
        of_design: whether the car is the design's, so that a remark that names another is a warning.
        abscissa: of its picture.
        plan_view: whether its picture shows the path in plan view instead of a spectrum.
        beside: columns that are read, too, where a file has them.
        most_logged: rows that a file may have, of which as many are kept, evenly, as can be judged; 0 for no more than
            these.
    """

    code: str
    title: str
    columns: tuple[Column, ...]
    key: str = "run"
    readings: tuple[str, ...]
    catalogue: Catalogue
    method: Method = Method.EVIDENCE
    datum: Datum
    model: Callable[["Record", Any], Model] | None = None
    check: Callable[["Record"], None] = lambda record: None
    settled: Callable[["Record", Callable[[], Collection[str]]], "Record"] = lambda record, shown: record
    spans: Callable[["Record", Any], Iterable[Span]] = lambda record, against: ()
    most_rows: int = MOST_ROWS
    least_rows: int = LEAST_ROWS
    counts: int = 0
    wanders: bool = False
    around: bool = False
    absences: tuple[Deviation, ...] = ()
    noise: float = 0.0
    nearness: int
    rod_on: bool = False
    of_design: bool = True
    abscissa: Abscissa = Abscissa.CAM_ANGLE
    plan_view: bool = False
    beside: tuple[Column, ...] = ()
    most_logged: int = 0

    def __str__(self) -> str:
        return self.code

    @property
    def header(self) -> tuple[str, ...]:
        """Every column of a file."""
        return (self.key, *(column.name for column in self.columns))

    @property
    def most_read(self) -> int:
        """Rows that a file may have."""
        return max(self.most_rows, self.most_logged)

    @property
    def stem(self) -> str:
        """The code as a part of file names."""
        return self.code.replace(" ", "_")

    @property
    def reading_unit(self) -> str:
        """Unit of the readings."""
        return self.readings[0].rpartition("_")[2]

    def deviation(self, effect: str) -> Deviation:
        """Deviation that an effect of the catalogue is; an effect of this kind alone is one of its own."""
        known = self.catalogue.named(effect)
        return (known and known.deviation) or Deviation(f"{effect} ({self.code})")

    def named(self, name: str, indices: Mapping[str, float] | None = None) -> Effect:
        """The effect that is written under a name, with the numbers that belong to the name (`Catalogue.named`).

        Raises:
            DesignError: there is no such effect; names the nearest.
        """
        if effect := self.catalogue.named(name, indices):
            return effect
        names = [entry.name for entry in self.catalogue.entries]
        near = get_close_matches(name, names, 3, 0.5) or names
        raise DesignError(
            'there is no effect "{name}" in data of kind {kind}: write {names}',
            name=name,
            kind=self.code,
            names=joined(near, " or "),
        )


@dataclass(frozen=True, kw_only=True)
class Record:
    """Measured data of one kind, from one file or several.

    Attributes:
        kind: by its columns.
        columns: name with unit, as in the file -> values, shape (n,); text columns as strings.
        run: number of the run of each row, shape (n,), from 0 in order of appearance.
        remarks: the comment lines, without their mark.
        source: file name, for messages.
        resolved: highest order that the spacing of the points resolves, where a part of a record must have the
            orders of the whole; None to go by the points themselves.
        of_runs: the comment lines of each run's own file where several files were joined; empty for one file.
        notes: what was understood of a file that is not as the kind's files are.
    """

    kind: Kind
    columns: dict[str, NDArray[np.generic]]
    run: NDArray[np.intp]
    remarks: tuple[str, ...]
    source: str
    resolved: int | None = None
    of_runs: tuple[tuple[str, ...], ...] = ()
    notes: tuple[Message, ...] = ()

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return int(self.run.max()) + 1

    @property
    def parts(self) -> list[slice]:
        """The rows of each run, which stand together."""
        bounds = [0, *(np.flatnonzero(np.diff(self.run)) + 1).tolist(), len(self.run)]
        return [slice(start, stop) for start, stop in pairwise(bounds)]

    def __getitem__(self, column: str) -> Array:
        return self.columns[column].astype(float)

    def only(self, runs: NDArray[np.intp]) -> "Record":
        """The rows of some runs, numbered anew."""
        part = self.where(np.isin(self.run, runs))
        kept, run = np.unique(part.run, return_inverse=True)
        of_runs = tuple(self.of_runs[k] for k in kept) if self.of_runs else ()
        return replace(part, run=run.astype(np.intp), of_runs=of_runs)

    def where(self, keep: NDArray[np.bool_]) -> "Record":
        """Some of the rows, runs numbered as before."""
        columns = {name: values[keep] for name, values in self.columns.items()}
        return replace(self, columns=columns, run=self.run[keep])


def understood_of(record: Record) -> Message:
    """Sentence on a file that is not as those of its kind."""
    return Message("{file} is understood so: {notes}.", file=record.source, notes=joined(record.notes, "; "))


def join(records: Sequence[Record]) -> Record:
    """Several records of one kind as one, their runs numbered on.

    Raises:
        FileError: nothing to join, records of different kinds, or too many rows or runs.
    """
    if not records:
        raise FileError("no measured file was given; name at least one")
    kinds = {record.kind for record in records}
    if len(kinds) > 1:
        codes = sorted(kind.code for kind in kinds)
        raise FileError(
            "{names}: kinds {codes} cannot be joined as one",
            names=joined((r.source for r in records), ", "),
            codes=codes,
        )
    rows = sum(len(record.run) for record in records)
    name = " + ".join(record.source for record in records)
    refuse_many(records[0].kind.most_rows, rows, name)
    if len(records) == 1:
        return records[0]
    if records[0].kind.method is not Method.ZONE_MEANS:
        refuse_many_runs(records[0].kind, rows, sum(record.runs for record in records), name)
    before = np.cumsum([0, *(record.runs for record in records)])
    return Record(
        kind=records[0].kind,
        columns={c: np.concatenate([r.columns[c] for r in records]) for c in records[0].columns},
        run=np.concatenate([r.run + n for r, n in zip(records, before, strict=False)]),
        remarks=tuple(remark for record in records for remark in record.remarks),
        source=name,
        of_runs=tuple(own for record in records for own in record.of_runs or (record.remarks,) * record.runs),
    )


def refuse_many(most: int, rows: int, name: str) -> None:
    """Refuse more rows than can be judged together.

    Args:
        most: rows that can be.
        rows: rows that a file has.
        name: of the file.

    Raises:
        FileError: there are more; says how many to keep.
    """
    if rows > most:
        raise FileError(
            "{name}: {rows} rows, more than the {most} that can be judged together; keep one row in {share}, or give "
            "fewer files",
            name=name,
            rows=rows,
            most=most,
            share=-(-rows // most),
        )


def refuse_many_together(records: Sequence[Record]) -> None:
    """Refuse more rows of several kinds than can be judged by one model.

    Raises:
        FileError: there are more; says how many to keep.
    """
    rows = sum(len(record.run) for record in records)
    if len(records) > 1 and rows > MOST_TOGETHER:
        raise FileError(
            "{names}: {rows} rows of {count} kinds, more than the {most} that can be judged by one model; "
            "keep one row in {share}, or give fewer files",
            names=joined((record.source for record in records), ", "),
            rows=rows,
            count=len(records),
            most=MOST_TOGETHER,
            share=-(-rows // MOST_TOGETHER),
        )


def refuse_many_runs(kind: Kind, rows: int, runs: int, name: str) -> None:
    """Refuse more runs than can be judged together, in all or with so many rows; logs are thinned before.

    Raises:
        FileError: there are more; says how many to keep.
    """
    if runs > MOST_RUNS:
        raise FileError(
            "{name}: {runs} runs, more than the {most} that can be judged together; keep one run in {share}, or "
            "give fewer files",
            name=name,
            runs=runs,
            most=MOST_RUNS,
            share=-(-runs // MOST_RUNS),
        )
    most = MOST_ENTRIES // max(rows, 1)
    if kind.most_rows <= MOST_ROWS and runs > most:
        raise FileError(
            "{name}: {runs} runs of {rows} rows in all, more than the {most} runs that can be judged together with so "
            "many rows; keep one row in {share}, or give fewer runs",
            name=name,
            runs=runs,
            rows=rows,
            most=most,
            share=-(-rows * runs // MOST_ENTRIES),
        )


@dataclass(frozen=True)
class Instrument:
    """Noise that a file states of the instrument, in the file's unit."""

    noise: float
    unit: str


def instrument(record: Record) -> Instrument | None:
    """Noise that the comment lines state; None if they do not."""
    if stated := said(record, r"noise\s+([0-9.]+)\s*(um|mm|deg)\b"):
        return Instrument(float(stated[0]), stated[1])
    return None


def printed(record: Record) -> bool:
    """True if a comment line says that the part was printed, not machined."""
    return any(re.search(r"\bprinted\b", remark) for remark in record.remarks)


def said(record: Record, pattern: str) -> tuple[str, ...]:
    """Groups of a pattern's first match in the comment lines; empty without a match."""
    return _first(record.remarks, pattern)


def said_of_runs(record: Record, pattern: str) -> list[tuple[str, ...]]:
    """Groups of a pattern's first match in the comment lines of each run's own file."""
    return [_first(remarks, pattern) for remarks in record.of_runs or (record.remarks,) * record.runs]


def _first(remarks: Iterable[str], pattern: str) -> tuple[str, ...]:
    for remark in remarks:
        if match := re.search(pattern, remark):
            return match.groups()
    return ()


_ROUNDING = 1e-9  # smaller steps are those of decimal numbers


def refuse_impossible(record: Record) -> None:
    """Check a record of whatever kind, and by its kind's own rule.

    Raises:
        FileError: runs that are copies, too few rows or too short a span in a run, or what the kind refuses.
    """
    if record.kind.method is Method.ZONE_MEANS:
        return
    # One column after the other, rows in the order of runs: a run is a slice, and its digits are its name.
    readings = np.stack([values.astype(float) for values in record.columns.values() if values.dtype.kind == "f"])
    runs, seen, counted = record.parts, dict[bytes, int](), _counted(record)
    for later, mine in enumerate(runs):
        earlier = seen.setdefault(readings[:, mine].tobytes(), later)
        if earlier != later and not counted:
            raise FileError(
                "{file}: runs {earlier} and {later} are the same to the last digit; a copy is no repetition: give "
                "runs that were measured anew",
                file=record.source,
                earlier=earlier + 1,
                later=later + 1,
            )
    wide = [(column, record[column.name]) for column in record.kind.columns if column.least_span]
    for run, mine in enumerate(runs):
        if (rows := mine.stop - mine.start) < (least := record.kind.least_rows):
            raise FileError(
                "{file}: run {run} has {rows} rows; give at least {least} in each run",
                file=record.source,
                run=run + 1,
                rows=rows,
                least=least,
            )
        for column, values in wide:
            if (span := float(np.ptp(values[mine]))) < column.least_span:
                raise FileError(
                    "{file}: {column} of run {run} spans only {span:g}; check its unit, or measure at least {least:g}",
                    file=record.source,
                    column=column.name,
                    run=run + 1,
                    span=span,
                    least=column.least_span,
                )
    record.kind.check(record)


def _counted(record: Record) -> bool:
    """Whether an instrument whose steps are coarse may read the same twice, as an encoder of few counts does."""
    for column in record.kind.readings:
        values = np.unique(record[column])
        steps = np.diff(values)
        least = float(np.min(steps[steps > _ROUNDING], initial=np.inf))
        if np.ptp(values) > record.kind.counts * least:
            return False
    return True


def refuse_twice(record: Record, key: NDArray[np.generic], column: str) -> None:
    """Refuse rows of one run that were taken under one condition.

    Args:
        record: for the message.
        key: condition of each row, shape (k, n), the angle last.
        column: of the angle.

    Raises:
        FileError: a condition stands twice.
    """
    unique, count = np.unique(key, axis=1, return_counts=True)
    if (count > 1).any():
        where = unique[-1, int(np.argmax(count))]
        raise FileError(
            "{file}: {column} {where:g} stands twice in one run, so the angle goes round more than once; number each "
            "turn as its own run",
            file=record.source,
            column=column,
            where=float(where),
        )


# Size of a number in a mistaken unit, over its size in the one that the header names.
SLIPS = {
    "mm": {"m": 1e-3, "cm": 0.1, "inches": 1 / 25.4, "um": 1e3},
    "deg": {"rad": pi / 180, "turns": 1 / 360},
}
# A part that was made to the design does not differ from it by so much; a slip of unit is that near to its factor.
NEAR = 1.6


def refuse_wrong_units(record: Record, against: Any) -> None:
    """Compare how far the readings span with what the design, or another column of them, lets expect.

    Args:
        record: of any kind.
        against: what data of its kind are measured against (see `Kind.model`).

    Raises:
        FileError: they are those of another unit.
    """
    slips = ((span, *slip) for span in record.kind.spans(record, against) for slip in SLIPS.get(span.unit, {}).items())
    for span, other, factor in slips:
        if span.expected > 0 and factor / NEAR < span.measured / span.expected < factor * NEAR:
            raise FileError(
                "{file}: {column} is {how} than the design lets expect by a factor of {factor:g}, so it seems to be "
                "in {other}: give {unit}",
                file=record.source,
                column=span.columns,
                how=Message("greater") if factor > 1 else Message("smaller"),
                factor=round(max(factor, 1 / factor), 1),
                other=other,
                unit=span.unit,
            )
