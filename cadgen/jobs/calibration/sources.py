"""Measured data that are judged: files, and arrays in memory that are read as files are."""

import csv
import hashlib
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from cadgen.errors import FileError, brief, escaped
from cadgen.inference.measurement.nominal import MACHINED_UM, PRINTED_UM
from cadgen.inference.measurement.record import Kind, Record, printed
from cadgen.inference.records.columns import AS_NAMED, Reading
from cadgen.inference.records.load import digest, load, load_text
from cadgen.messages import Message
from cadgen.progress import Progress, silent

# Rows that are read for one command which judges every file alone: their records have some 200 MB.
MOST_READ = 2_000_000


@dataclass(frozen=True)
class Source:
    """A measured file: its record and the hash of its bytes."""

    path: Path
    record: Record
    sha256: str

    @property
    def kind(self) -> Kind:
        """Kind of measured data."""
        return self.record.kind


def read(
    paths: Sequence[Path],
    progress: Progress = silent,
    *,
    each: bool = False,
    reading: Reading = AS_NAMED,
    known: Sequence[Kind] | None = None,
) -> tuple[Source, ...]:
    """Read measured files.

    Args:
        paths: of the files.
        progress: function that is called with a few words on each step.
        each: every file will be judged alone; if not, those of one kind must not have more rows than can be judged
            together.
        reading: how their columns are to be understood.
        known: kinds that they may be of; all that are registered if left out.

    Raises:
        FileError: one is no measured data, the same data are given twice, or there are more than can be judged.
    """

    def loaded(path: Path) -> Source:
        progress(Message("reading {name}", name=brief(path.name)))
        return Source(path, load(path, known, reading), digest(path))

    return gathered(map(loaded, paths), each=each)


def gathered(sources: Iterable[Source], *, each: bool = False) -> tuple[Source, ...]:
    """Measured data as they come; arguments and errors as of `read`."""
    known: dict[str, Source] = {}
    rows: dict[Kind | None, int] = {}
    for source in sources:
        record = source.record
        if twin := known.get(source.sha256):
            raise FileError(
                "{file} holds the same data as {twin}: give each file once", file=source.path, twin=twin.path
            )
        known[source.sha256] = source
        kind = None if each else record.kind
        rows[kind] = rows.get(kind, 0) + len(record.run)
        # Before the next is read: a hundred long files take minutes.
        if rows[kind] > (most := MOST_READ if kind is None else kind.most_rows):
            data = Message(" of {kind} data", kind=kind.code) if kind else ""
            at_once = Message("together") if kind else Message("in one command")
            raise FileError(
                "the {count} files up to {file} have {rows} rows{data}, more than the {most} that can be judged "
                "{at_once}: give fewer files, or keep fewer rows of each",
                count=len(known),
                file=record.source,
                rows=rows[kind],
                data=data,
                most=most,
                at_once=at_once,
            )
    return tuple(known.values())


def source_of(
    columns: Mapping[str, ArrayLike],
    remarks: Sequence[str],
    name: str,
    reading: Reading = AS_NAMED,
    known: Sequence[Kind] | None = None,
) -> Source:
    """Measured data from arrays.

    Args:
        columns: name with unit, as in a file's header -> values, all of one shape (n,). Without a column `run` (or
            `zone`) they are one run.
        remarks: comment lines of a file, such as `noise 2 um`.
        name: name of the data, for messages and reports.
        reading: how the columns are to be understood.
        known: kinds that they may be of; all that are registered if left out.

    Raises:
        FileError: the columns are not of one length, or as `cadgen.inference.records.load.load`.
    """
    name = escaped(brief(name, 80))
    arrays = {str(column): np.asarray(values) for column, values in columns.items()}
    sizes = {column: values.shape for column, values in arrays.items()}
    if not arrays or any(len(size) != 1 for size in sizes.values()) or len(set(sizes.values())) != 1:
        told = brief(", ".join(f"{column} {size}" for column, size in sizes.items()) or "no column")
        raise FileError(
            "{name}: its columns have the shapes {told}; every column must be one row of as many values",
            name=name,
            told=told,
        )
    if not {"run", "zone"} & set(arrays):
        arrays = {"run": np.ones(next(iter(sizes.values())), dtype=int), **arrays}
    text = io.StringIO(newline="")
    for remark in remarks:
        text.write(f"# {escaped(str(remark))}\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(arrays)
    writer.writerows(zip(*(values.tolist() for values in arrays.values()), strict=True))
    content = text.getvalue()
    return Source(Path(name), load_text(content, name, known, reading), hashlib.sha256(content.encode()).hexdigest())


def stated_form_error(sources: Sequence[Source], given: float | None) -> tuple[float, str]:
    """Form error to expect on the disc, um rms, and its source.

    Args:
        sources: measured files.
        given: form error that the caller gives, um rms; None if none.
    """
    if given is not None:
        return given, Message("given")
    if by := next((s for s in sources if printed(s.record)), None):
        return PRINTED_UM, Message("{source} says printed", source=by.record.source)
    return MACHINED_UM, Message("machined: no file says printed")
