"""Measured data from a caller: files, or arrays in memory."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.design.schema import TrainDesign
from cadgen.errors import DesignError, brief
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from cadgen.inference.measurement.record import Kind
    from cadgen.inference.records.columns import Reading
    from cadgen.jobs.calibration.sources import Source


@dataclass(frozen=True, eq=False, repr=False)
class Measured:
    """Measured data in memory, with the content of a CSV file.

    Attributes:
        columns: values, shape (n,) each, by name with unit as in a file's header (docs/measurement.md). Without a
            column `run` (or `zone`) all rows are one run.
        remarks: comment lines, such as `noise 2 um`.
        name: name of the data, for reports.
    """

    columns: "Mapping[str, ArrayLike]"
    remarks: Sequence[str] = ()
    name: str = "data"

    def __post_init__(self) -> None:
        if not isinstance(self.columns, Mapping):
            raise DesignError(
                "columns is {given}; it must map names with units to values", given=brief(repr(self.columns), 60)
            )

    def __repr__(self) -> str:
        return f"<Measured {self.name}: {', '.join(map(str, self.columns))}>"


Data = str | PathLike[str] | Mapping[str, Any] | Measured


def reading_of(design: TrainDesign, columns: Mapping[str, str] | None) -> "Reading":
    """How columns of measured data are to be understood, with a design's ratio for angles of the motor.

    Args:
        design: checked design.
        columns: columns of a kind of data -> names that they have in the files, where those are not understood.

    Raises:
        DesignError: the columns are no such mapping.
    """
    from cadgen.design.gear_model import train
    from cadgen.inference.records.columns import Reading

    given = {} if columns is None else columns
    if not isinstance(given, Mapping) or not all(isinstance(word, str) for pair in given.items() for word in pair):
        raise DesignError(
            "columns is {given}; it must map columns such as x_mm to names in the files", given=brief(repr(columns), 60)
        )
    return Reading(columns=dict(given), ratio=float(train(design).ratio) if design.train else None)


def sources_of(
    data: Data | Iterable[Data],
    reading: "Reading",
    *,
    each: bool = False,
    known: "Sequence[Kind] | None" = None,
    progress: Progress = silent,
) -> "tuple[Source, ...]":
    """Read measured data.

    Args:
        data: paths of CSV files, mappings of columns to arrays, `Measured`, or several of these.
        reading: how their columns are to be understood.
        each: whether the data will be judged one by one.
        known: kinds that they may be of; all that are registered if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the data are none of these.
        FileError: data cannot be read, stand twice, or are more than can be judged.
    """
    from cadgen.jobs.calibration.sources import gathered

    sources = (_source(item, number, reading, known, progress) for number, item in enumerate(_each_of(data), 1))
    return gathered(sources, each=each)


def _each_of(data: Data | Iterable[Data]) -> list[Data]:
    if isinstance(data, (str, PathLike, Mapping, Measured)):
        return [data]
    try:
        several: list[Data] = list(data)
    except TypeError:
        several = []
    if not several:
        raise DesignError(
            "data is {given}; give at least one CSV file, or columns of measured values", given=brief(repr(data), 60)
        )
    return several


def _source(
    data: Data, number: int, reading: "Reading", known: "Sequence[Kind] | None", progress: Progress
) -> "Source":
    from cadgen.jobs.calibration.sources import read, source_of

    if isinstance(data, (str, PathLike)):
        return read([Path(data)], progress, each=True, reading=reading, known=known)[0]
    if isinstance(data, Mapping):
        data = Measured(data, name=f"data {number}")
    if not isinstance(data, Measured):
        raise DesignError(
            "data has {given}; each must be a path, columns of values, or Measured", given=brief(repr(data), 60)
        )
    remarks = (data.remarks,) if isinstance(data.remarks, str) else data.remarks
    return source_of(data.columns, remarks, str(data.name), reading, known)
