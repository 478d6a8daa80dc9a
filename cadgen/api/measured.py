"""Measured data as a caller gives them: files, or arrays in memory."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.errors import DesignError, brief
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from cadgen.workflow.calibration.plan import Source


@dataclass(frozen=True, eq=False, repr=False)
class Measured:
    """Measured data in memory: what a CSV file of them would hold.

    Attributes:
        columns: name with unit, as in a file's header (docs/measurement.md) -> values, each of shape (n,). Without a
            column `run` (or `zone`) they are one run.
        remarks: what the comment lines would say, such as `noise 2 um`.
        name: of the data, for reports.
    """

    columns: "Mapping[str, ArrayLike]"
    remarks: Sequence[str] = ()
    name: str = "data"

    def __repr__(self) -> str:
        return f"<Measured {self.name}: {', '.join(map(str, self.columns))}>"


Data = str | PathLike[str] | Mapping[str, Any] | Measured


def sources_of(data: Data | Iterable[Data], *, each: bool = False, progress: Progress = silent) -> "tuple[Source, ...]":
    """Read measured data.

    Args:
        data: one or several: paths of CSV files, mappings of columns to arrays, `Measured`.
        each: every one will be judged alone.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: it is none of these.
        FileError: data that cannot be read, the same twice, or more than can be judged.
    """
    from cadgen.workflow.calibration.plan import gathered

    sources = (_source(one, number, progress) for number, one in enumerate(_several(data), 1))
    return gathered(sources, each=each)


def _several(data: Data | Iterable[Data]) -> list[Data]:
    if isinstance(data, (str, PathLike, Mapping, Measured)):
        return [data]
    try:
        several: list[Data] = list(data)
    except TypeError:
        several = []
    if not several:
        raise DesignError(f"data is {brief(repr(data), 60)}; give at least one CSV file, or columns of measured values")
    return several


def _measured(data: Measured) -> "Source":
    from cadgen.workflow.calibration.tables import source_of

    if not isinstance(data.columns, Mapping):
        raise DesignError(f"columns is {brief(repr(data.columns), 60)}; it must map names with units to values")
    remarks = (data.remarks,) if isinstance(data.remarks, str) else data.remarks
    return source_of(data.columns, remarks, str(data.name))


def _source(data: Data, number: int, progress: Progress) -> "Source":
    from cadgen.workflow.calibration.plan import read

    if isinstance(data, (str, PathLike)):
        return read([Path(data)], progress, each=True)[0]
    if isinstance(data, Mapping):
        data = Measured(data, name=f"data {number}")
    if not isinstance(data, Measured):
        raise DesignError(f"data has {brief(repr(data), 60)}; each must be a path, columns of values, or Measured")
    return _measured(data)
