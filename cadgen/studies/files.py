"""Results of a study as files: table, front, pictures and best designs, published together."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cadgen.output.files.publisher import Artifact, Written, publish
from cadgen.output.report.exploration import ExplorationPicture, draw_exploration
from cadgen.progress import Progress, silent
from cadgen.studies.best import write_best
from cadgen.studies.effects import effects
from cadgen.studies.evaluate import Row, State
from cadgen.studies.front import front, ranked
from cadgen.studies.results import Results, sampled
from cadgen.studies.table import write_csv, write_parquet
from cadgen.version import __version__

_MOST_SHOWN, _MOST_OF_FRONT = 3000, 500  # designs in pictures
_MOST_JUDGED = 20_000  # designs for the effects of keys
_NO_PYARROW = "pyarrow is not installed: pip install '.[explore]' in cadgen's folder"


@dataclass(frozen=True)
class Summary:
    """Summary of a study's results.

    Attributes:
        results: the results.
        states: number of designs in each state.
        front: rows of the front, the best first.
        effects: share of each figure's variance that each key explains alone.
    """

    results: Results
    states: dict[State, int]
    front: tuple[Row, ...]
    effects: dict[str, dict[str, float]]

    @classmethod
    def of(cls, results: Results) -> "Summary":
        """Summary of complete results."""
        study = results.study
        states = Counter(row.state for row in results.rows())
        some = [results.row(number) for number in sampled(results.count, _MOST_JUDGED)]
        best = ranked(front(results.rows(), study.objectives), study.objectives)
        return cls(results, dict(sorted(states.items())), tuple(best), effects(study, some))

    def facts(self) -> dict[str, Any]:
        """The summary as plain values."""
        study = self.results.study
        return {
            "study": study.name,
            "study_sha256": study.fingerprint,
            "base": study.source,
            "cadgen": __version__,
            "designs": self.results.count,
            "states": self.states,
            "objectives": [figure.code for figure in study.objectives],
            "front": [self.row_facts(row) for row in self.front],
            "variance_explained": self.effects,
        }

    def row_facts(self, row: Row) -> dict[str, Any]:
        """One design as plain values."""
        study = self.results.study
        return {
            "number": row.number,
            **dict(zip(study.keys, row.values, strict=True)),
            "state": row.state,
            **dict(zip((figure.code for figure in study.figures), row.figures, strict=True)),
            "failed": list(row.failed),
            "sentence": row.sentence,
        }


def write_summary(summary: Summary, out: Path, progress: Progress = silent) -> Written:
    """Write all files of a study, and publish them together.

    Args:
        summary: summary of its results.
        out: folder for the files.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written.
    """
    results = summary.results
    study, stem = results.study, results.study.name
    omitted: dict[str, str] = {}

    def files(folder: Path) -> Iterator[Artifact]:
        table, parquet, front = (f"{stem}{end}" for end in (".csv", ".parquet", "_front.csv"))
        progress("writing the table")
        write_csv(folder / table, study, results.rows())
        yield Artifact(table)
        if write_parquet(folder / parquet, study, results.rows()):
            yield Artifact(parquet)
        else:
            omitted[parquet] = _NO_PYARROW
        write_csv(folder / front, study, summary.front)
        yield Artifact(front)
        progress("drawing")
        yield from map(Artifact, draw_exploration(_picture(summary), folder, stem))
        progress("writing the best designs")
        yield from map(Artifact, write_best(results, summary.front[: study.file.best], folder))

    return publish(stem, out, files, summary.facts(), lambda _: {"omitted": omitted})


def _picture(summary: Summary) -> ExplorationPicture:
    results = summary.results
    study = results.study
    rows = [results.row(number) for number in sampled(results.count, _MOST_SHOWN)]
    shown = [row for row in rows if row.state in (State.KEPT, State.OUTSIDE)]
    return ExplorationPicture(
        title=f"{study.name}: {results.count} designs, {summary.states.get(State.KEPT, 0)} within all limits",
        keys=study.keys,
        figures=tuple(figure.code for figure in study.objectives),
        more=tuple(figure.more for figure in study.objectives),
        values=tuple((*row.values, *row.figures[: len(study.objectives)]) for row in shown),
        kept=tuple(row.state == State.KEPT for row in shown),
        front=tuple(
            (*summary.front[at].values, *summary.front[at].figures[: len(study.objectives)])
            for at in sampled(len(summary.front), _MOST_OF_FRONT)
        ),
        effects=summary.effects,
    )
