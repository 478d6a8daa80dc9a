"""A study computed: what its journal has already is kept, all else goes through the engine."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from time import monotonic

import numpy as np

from cadgen.errors import FileError
from cadgen.messages import Message
from cadgen.progress import Progress, silent
from cadgen.studies import sampling
from cadgen.studies.design_row import DesignJob, DesignState, Row, Task
from cadgen.studies.engines import Engine, Mapped, work
from cadgen.studies.front import objectives_of
from cadgen.studies.journal import Header, Journal, journal_name
from cadgen.studies.planned_paths import PlannedText, Planner, path_key
from cadgen.studies.results import Results
from cadgen.studies.sampling import FrontSearch, Values
from cadgen.studies.study import Study
from cadgen.version import __version__

# How far a design without figures is from its limits; one that is only outside them is nearer.
_NO_DESIGN, _SCREENED = 1e6, 10.0
_GIVEN_UP = "the process that computed it died each time, alone too: by a fault, or for lack of memory or time"


def open_journal(study: Study, text: str, folder: Path, shard: tuple[int, int] = (1, 1)) -> Journal:
    """Open the journal of a study, or of one of its shards, in a folder; errors as of `Journal.begun`.

    Args:
        study: the study.
        text: text of its file.
        folder: where its results go.
        shard: number of the part, and number of parts.
    """
    header = Header(__version__, study.fingerprint, study.name, text, study.text, study.source, shard)
    journal = Journal.begun(folder / journal_name(study.name, shard), header)
    try:
        journal.require_of(study)
    except FileError:
        journal.close()
        raise
    return journal


@dataclass
class StudyRun:
    """A study under way.

    Attributes:
        study: the study.
        journal: its journal, open.
        engine: where designs are computed.
        progress: function that is called with the state of the study.
    """

    study: Study
    journal: Journal
    engine: Engine | Mapped
    progress: Progress = silent
    _begun: float = field(default_factory=monotonic)
    _done: int = 0
    _without: int = 0
    _total: int = 0

    def run(self) -> Results:
        """Compute all designs of the journal's shard that it does not have yet.

        Raises:
            DesignError: the study searches, and pymoo is not installed.
            FileError: the journal cannot be written, or the engine takes no more work.
        """
        study, (part, parts) = self.study, self.journal.header.shard
        if study.searches:
            return Results(study, (self.journal,), self._search())
        numbers = range(part - 1, study.count, parts)
        self._total = len(numbers)
        self._compute(numbers, sampling.plan(study.file.plan.kind, study.variations, study.count, study.file.seed))
        return Results(study, (self.journal,), study.count)

    def _search(self) -> int:
        """Generation by generation; values that came before are not computed again."""
        study, plan, journal = self.study, self.study.file.plan, self.journal
        search = FrontSearch(
            len(study.keys), len(study.objectives), plan.population, study.generations, study.file.seed
        )
        known: dict[str, int] = {}
        count, self._total = 0, study.count
        for _ in range(study.generations):
            values = [sampling.values_at(study.variations, place) for place in search.ask().tolist()]
            numbers = range(count, count + len(values))
            first = [known.setdefault(repr(each), number) for number, each in zip(numbers, values, strict=True)]
            new = dict(zip(numbers, values, strict=True))
            self._compute([number for number in numbers if number in first], new.__getitem__)
            copies = [(number, source) for number, source in zip(numbers, first, strict=True) if number != source]
            journal.add_rows([(replace(journal.row(source), number=number), 0.0) for number, source in copies])
            rows = [journal.row(number) for number in numbers]
            objectives = np.array([objectives_of(row, study.objectives) for row in rows])
            search.answer(objectives, np.array([self._violation(row) for row in rows]))
            count += len(values)
        return count

    def _violation(self, row: Row) -> float:
        """How far a design is from keeping its limits: the sum of all excesses, and 1 for each check that fails."""
        if row.state in (DesignState.REFUSED, DesignState.CRASHED):
            return _NO_DESIGN
        known = dict(zip((figure.code for figure in self.study.figures), row.figures, strict=True))
        excesses = {code: 0.0 for code in row.failed if code in known}
        for limit in self.study.file.limits:
            value = known[limit.figure]
            if limit.figure in excesses and value is not None:
                excesses[limit.figure] += limit.excess(value)
        checks = len(row.failed) - len(excesses)
        return sum(excesses.values()) + checks + (_SCREENED if row.state == DesignState.SCREENED else 0.0)

    def _compute(self, numbers: Sequence[int], values: Callable[[int], Values]) -> None:
        left = [number for number in numbers if number not in self.journal]
        planner = Planner.of(self.study)
        if planner is not None:
            every = (path_key(self.study, values(number)) for number in left)
            keys = [key for key in dict.fromkeys(every) if key is not None and key not in self.journal.paths]
            self.progress(Message("planning {count} paths", count=len(keys)))

            def take_paths(results: Sequence[tuple[PlannedText, float]]) -> None:
                for planned, _ in results:
                    self.journal.add_path(planned)
                self.progress(Message("{count} paths planned", count=len(self.journal.paths)))

            work(self.engine, planner, keys, len(keys), take_paths, planner.given_up)

        def tasks() -> Iterator[Task]:
            for number in left:
                varied = values(number)
                key = path_key(self.study, varied)
                planned = None if key is None else self.journal.path(key)
                yield Task(number, varied) if planned is None else Task(number, varied, planned.text, planned.fault)

        nothing = (None,) * len(self.study.figures)

        def given_up(task: Task) -> Row:
            return Row(task.number, task.values, DesignState.CRASHED, nothing, sentence=_GIVEN_UP)

        self._say()
        work(self.engine, DesignJob.of(self.study), tasks(), len(left), self._take_rows, given_up)

    def _take_rows(self, results: Sequence[tuple[Row, float]]) -> None:
        self.journal.add_rows(results)
        self._done += len(results)
        self._without += sum(row.state in (DesignState.REFUSED, DesignState.CRASHED) for row, _ in results)
        self._say()

    def _say(self) -> None:
        words = Message("{count} of {total} designs", count=self.journal.count, total=self._total)
        if self._done:
            rate = self._done / max(monotonic() - self._begun, 1e-9)
            left = (self._total - self.journal.count) / rate
            time = Message("{left:.0f} s left", left=left)
            if left > 90:
                time = Message("{left:.0f} min left", left=left / 60)
            words = Message("{words}, {rate:.3g} a second, {time}", words=words, rate=rate, time=time)
        self.progress(Message("{words}, {without} refused or crashed", words=words, without=self._without))
