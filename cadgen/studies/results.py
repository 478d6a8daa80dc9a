"""All rows of a study in the order of their numbers, from one journal or those of its shards, one at a time."""

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import FileError, brief
from cadgen.studies.design_row import Row
from cadgen.studies.journal import ENDING, Journal
from cadgen.studies.planned_paths import PlannedText
from cadgen.studies.study import Study
from cadgen.studies.study_file import study_of
from cadgen.version import __version__


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
        place = int(self._holders[number])
        if place < 0:
            raise FileError("design {number} has no result yet: run the study on", number=number)
        return self.journals[place].row(number)

    def rows(self) -> Iterator[Row]:
        """All rows, in order."""
        return (self.row(number) for number in range(self.count))

    def path(self, key: str) -> PlannedText:
        """A planned path."""
        return next(journal for journal in self.journals if key in journal.paths).path(key)

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


_OTHER_FILES = 64  # that a process holds open besides the journals


def merged(folders: Sequence[Path]) -> Results:
    """Results of the shards' journals in some folders.

    Args:
        folders: folders with journals, or journals.

    Raises:
        FileError: no journal, journals of several studies or versions, or designs without a result.
    """
    found = (sorted(folder.glob(f"*{ENDING}")) if folder.is_dir() else [folder] for folder in folders)
    files = list(dict.fromkeys(file for every in found for file in every))
    if not files:
        raise FileError("there is no journal of cadgen explore in these folders: name those of the shards")
    _allow_open(len(files))
    journals = tuple(Journal.read(file) for file in files)
    first = journals[0].header
    for journal in journals:
        if journal.header.version != __version__:
            raise FileError(
                "{file} was written by cadgen {version}, and this is {this}: merge with that version",
                file=brief(str(journal.file)),
                version=journal.header.version,
                this=__version__,
            )
        if journal.header.fingerprint != first.fingerprint:
            raise FileError(
                "{file} is of another study than {other}: name the folders, or the journals, of one study",
                file=brief(str(journal.file)),
                other=brief(str(journals[0].file)),
            )
    study = study_of(first.study, first.text, first.source, first.name)
    for journal in journals:
        journal.require_of(study)
    count = sum(journal.count for journal in journals) if study.searches else study.count
    results = Results(study, journals, count)
    missing = list(results.missing)
    if missing:
        parts = first.shard[1]
        raise FileError(
            "{missing} of {count} designs have no result yet, the first is number {first}: run the shards "
            "on that are not done ({shards})",
            missing=len(missing),
            count=count,
            first=missing[0],
            shards=f"--shard {missing[0] % parts + 1}/{parts}" if parts > 1 else "cadgen explore",
        )
    return results


def _allow_open(count: int) -> None:
    """Have this process allowed to hold so many journals open at once: many systems begin with 1024 files.

    Raises:
        FileError: this computer does not allow so many.
    """
    if sys.platform == "win32":
        return
    import resource

    usual, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    needed = count + _OTHER_FILES
    if usual == resource.RLIM_INFINITY or needed <= usual:
        return
    if most != resource.RLIM_INFINITY and needed > most:
        raise FileError(
            "these are {count} journals, and this computer lets a program open {most} files at once: raise "
            "that limit (ulimit -n), or take fewer shards",
            count=count,
            most=most,
        )
    resource.setrlimit(resource.RLIMIT_NOFILE, (needed, most))
