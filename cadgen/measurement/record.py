"""Measured data as it was read: one table of one kind, with its runs."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.names import Kind as Kind


@dataclass(frozen=True, kw_only=True)
class Record:
    """One file.

    Attributes:
        kind: by its columns.
        columns: name with unit, as in the file -> values, shape (n,); text columns as strings.
        run: number of the run of each row, shape (n,), from 0 in order of appearance.
        remarks: the comment lines, without their mark.
        source: file name, for messages.
    """

    kind: Kind
    columns: dict[str, NDArray[np.generic]]
    run: NDArray[np.intp]
    remarks: tuple[str, ...]
    source: str

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return int(self.run.max()) + 1

    def __getitem__(self, column: str) -> Array:
        return self.columns[column].astype(float)

    def only(self, runs: NDArray[np.intp]) -> "Record":
        """The rows of some runs, numbered anew."""
        part = self.where(np.isin(self.run, runs))
        return replace(part, run=np.unique(part.run, return_inverse=True)[1].astype(np.intp))

    def where(self, keep: NDArray[np.bool_]) -> "Record":
        """Some of the rows, runs numbered as before."""
        columns = {name: values[keep] for name, values in self.columns.items()}
        return replace(self, columns=columns, run=self.run[keep])
