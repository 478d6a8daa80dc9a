"""All rows of a study in the order of their numbers, from one journal or those of its shards, one at a time."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import FileError
from cadgen.studies.evaluate import Row
from cadgen.studies.journal import Journal
from cadgen.studies.paths import PlannedText
from cadgen.studies.study import Study


@dataclass(frozen=True)
class Results:
    """Rows of a study.

    Attributes:
        study: the study.
        journals: journals that hold its rows.
        count: number of its designs.
    """

    study: Study
    journals: tuple[Journal, ...]
    count: int

    @property
    def missing(self) -> Iterator[int]:
        """Numbers of designs without a row."""
        return iter(np.flatnonzero(self._holders < 0).tolist())

    def row(self, number: int) -> Row:
        """Row of a design.

        Raises:
            FileError: there is none.
        """
        journal = self._journal(number)
        if journal is None:
            raise FileError(f"design {number} has no result yet: run the study on")
        return journal.row(number)

    def rows(self) -> Iterator[Row]:
        """All rows, in order."""
        return (self.row(number) for number in range(self.count))

    def path(self, key: str) -> PlannedText:
        """A planned path."""
        return next(journal for journal in self.journals if key in journal.paths).path(key)

    def _journal(self, number: int) -> Journal | None:
        place = int(self._holders[number])
        return None if place < 0 else self.journals[place]

    @cached_property
    def _holders(self) -> NDArray[np.int32]:
        """Place of the journal that has the row of each design; -1 for none."""
        holders = np.full(self.count, -1, dtype=np.int32)
        for place in reversed(range(len(self.journals))):
            numbers = self.journals[place].numbers
            holders[numbers[numbers < self.count]] = place
        return holders


def sampled(count: int, most: int) -> range:
    """Every k-th number, so that at most so many are taken."""
    return range(0, count, max(-(-count // most), 1))


def head(study: Study) -> list[str]:
    """Names of a table's columns."""
    return ["number", *study.keys, "state", *(figure.code for figure in study.figures), "failed", "sentence"]


def cells(row: Row) -> Sequence[object]:
    """A row as a table has it."""
    return [row.number, *row.values, row.state, *row.figures, " ".join(row.failed), row.sentence]
