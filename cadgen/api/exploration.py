"""Studies of many designs: what `explore` and `merge` give."""

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any

from cadgen.api.values import name_or_path, whole
from cadgen.errors import DesignError, FileError, brief
from cadgen.figures import Facts
from cadgen.output.files.publisher import Frozen, Written, folder_of, frozen
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing
from cadgen.progress import Progress, silent
from cadgen.studies.engines import Cluster, Processes, engine_of
from cadgen.studies.results import Results, merged
from cadgen.studies.study_figures import StudyFigure as Figure
from cadgen.studies.study_figures import register as register_figure
from cadgen.studies.study_figures import remove as remove_figure
from cadgen.studies.study_file import read_study
from cadgen.studies.study_files import Summary, pictures, write_summary
from cadgen.studies.study_run import StudyRun, open_journal

__all__ = ["Exploration", "Figure", "explore", "merge", "register_figure", "remove_figure"]

MOST_PROCESSES, MOST_SHARDS = 1024, 10_000
_SHARD = re.compile(r"([0-9]{1,5})/([0-9]{1,5})")


@dataclass(frozen=True, eq=False, repr=False)
class Exploration(Pictured):
    """A study that has been computed, or a shard of one.

    Attributes:
        computed: all results, row by row from the journal.
        shard: number of the part and number of parts; 1 and 1 for the whole.
        folder: where its journal is.
    """

    computed: Results
    shard: tuple[int, int]
    folder: Path

    def __repr__(self) -> str:
        part = "" if self.complete else f", shard {self.shard[0]} of {self.shard[1]}"
        return f"<Exploration of {self.name}, {self.computed.count} designs{part}>"

    @property
    def name(self) -> str:
        """Name of the study."""
        return self.computed.study.name

    @property
    def complete(self) -> bool:
        """Whether it has the results of all designs, and not those of a shard alone."""
        return self.shard[1] == 1

    @cached_property
    def summary(self) -> Summary:
        """Counts, front and effects.

        Raises:
            FileError: it is a shard.
        """
        if not self.complete:
            raise FileError(
                "this is shard {shard} of {parts}: merge all shards first", shard=self.shard[0], parts=self.shard[1]
            )
        return Summary.of(self.computed)

    @property
    def front(self) -> tuple[Mapping[str, Any], ...]:
        """Designs of the Pareto front as plain values, the best in each objective first."""
        return tuple(frozen(self.summary.row_facts(row).json()) for row in self.summary.front)

    def rows(self) -> Iterator[Mapping[str, Any]]:
        """All designs as plain values, in order, read one at a time."""
        return (Frozen(self.summary.row_facts(row).json()) for row in self.computed.rows())

    @property
    def picture(self) -> Drawing:
        """The front, or where there is none every design over its keys and figures."""
        drawn = pictures(self.summary)
        return next(drawn[name] for name in ("front", "parallel", "effects") if name in drawn)

    def entry(self) -> Facts:
        """The summary, as in the manifest; of a shard its number and size."""
        if self.complete:
            return self.summary.entry()
        return Facts(study=self.name, shard=self.shard, designs=self.computed.journals[0].count)

    def write(self, folder: str | PathLike[str] | None = None, *, progress: Progress = silent) -> Written:
        """Write table, front, pictures and the best designs, all together or none.

        Args:
            folder: folder for the files; that of the journal if left out.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or it is a shard.
        """
        place = self.folder if folder is None else folder_of(folder)
        return write_summary(self.summary, place, progress)


def explore(
    study: str | PathLike[str],
    folder: str | PathLike[str],
    *,
    executor: Any = None,
    processes: int = 1,
    scheduler: str | None = None,
    shard: str | tuple[int, int] | None = None,
    progress: Progress = silent,
) -> Exploration:
    """Compute the designs of a study; what the journal in the folder has already is not computed again.

    The results are the same whatever computes them, in whatever order, and however often it was stopped.

    Args:
        study: path of the study's file, or name of a packaged study.
        folder: folder of the journal.
        executor: anything with a method `submit` or `map`, or a function like the built-in `map`.
        processes: number of processes of this machine, without an executor.
        scheduler: address, or scheduler file, of a dask scheduler.
        shard: `k/n` or (k, n): compute the k-th of n parts only; for fixed plans.
        progress: function that is called with the state of the study.

    Raises:
        DesignError: the study, an argument, or a package that is missing.
        FileError: the journal cannot be written, is of another study or version, or the executor has gone.
    """
    source = name_or_path("study", study)
    if source is None or not os.fspath(source):
        raise DesignError("no study is named: give the path of its file")
    read, text, place, part = *read_study(Path(source)), folder_of(folder), shard_of(shard)
    if part[1] > 1 and read.searches:
        raise DesignError(
            "a search needs the results of all designs before it goes on, so it has no shards: use processes or a "
            "scheduler, or take a fixed plan such as sobol"
        )
    if executor is not None and scheduler is not None:
        raise DesignError("both an executor and a scheduler are given: leave one out")
    journal = open_journal(read, text, place, part)
    try:
        count, engine = whole("processes", processes, 1, MOST_PROCESSES), None
        if executor is not None:
            engine = engine_of(executor)
        else:
            engine = Processes(count, journal.stream.fileno()) if scheduler is None else Cluster(scheduler)
        try:
            results = StudyRun(read, journal, engine, progress).run()
        finally:
            engine.close()
        journal.free()
    except BaseException:
        journal.close()
        raise
    return Exploration(results, part, place)


def merge(folders: Iterable[str | PathLike[str]]) -> Exploration:
    """Put the journals of all shards of a study together.

    Args:
        folders: folders of the shards.

    Raises:
        FileError: no journal, journals of several studies or versions, or designs without a result.
    """
    if isinstance(folders, str) or not isinstance(folders, Iterable):
        raise DesignError("folders is {given}; it must be several, such as [{given}]", given=brief(repr(folders), 60))
    places = [folder_of(folder) for folder in folders]
    if not places:
        raise DesignError("no folder was given: name those of the shards")
    return Exploration(merged(places), (1, 1), places[0])


def shard_of(shard: str | tuple[int, int] | None) -> tuple[int, int]:
    """Number of a part and number of parts.

    Args:
        shard: part `k/n`, or both numbers; 1 of 1 if left out.

    Raises:
        DesignError: it is not k/n with k from 1 to n.
    """
    if shard is None:
        return 1, 1
    match = _SHARD.fullmatch(shard) if isinstance(shard, str) else None
    part, parts = (int(match[1]), int(match[2])) if match else shard if isinstance(shard, tuple) else (0, 0)
    if not 1 <= part <= parts <= MOST_SHARDS:
        raise DesignError(
            "the shard is {shard}; it must be k/n, such as 2/3, with k from 1 to n and n at most {most}",
            shard=brief(repr(shard), 40),
            most=MOST_SHARDS,
        )
    return part, parts
