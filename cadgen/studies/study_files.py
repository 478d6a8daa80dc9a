"""Results of a study as files, published together: table, front, pictures and best designs.

The table is CSV and Parquet, written row by row. The best designs are design files that keep the comments of the base,
so that every other command takes them.
"""

import csv
import json
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cadgen.design.load import complete_of
from cadgen.design.planned import overridden_text
from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.output.files.publisher import Artifact, Written, publish
from cadgen.output.report.study_pictures import ExplorationPicture, exploration_pictures
from cadgen.output.report.style import Drawing, save
from cadgen.progress import Progress, silent
from cadgen.studies.design_row import DesignJob, DesignState, Row, Task
from cadgen.studies.front import effects, front, ranked
from cadgen.studies.planned_paths import path_key
from cadgen.studies.results import Results, cells, head, sampled
from cadgen.studies.study import Study
from cadgen.version import __version__

_GROUP = 10_000  # rows of Parquet that are held at once


def write_csv(file: Path, study: Study, rows: Iterable[Row]) -> None:
    """Write the table as CSV: UTF-8, a head, every float with all its digits, lists as JSON.

    Args:
        file: path of the file.
        study: the study.
        rows: its rows, in order.
    """
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(head(study))
        writer.writerows([_plain(value) for value in cells(row)] for row in rows)


def write_parquet(file: Path, study: Study, rows: Iterable[Row]) -> bool:
    """Write the table as Parquet; False without pyarrow, and then there is no file.

    Args:
        file: path of the file.
        study: the study.
        rows: its rows, in order.
    """
    try:
        import pyarrow as pa
        from pyarrow import parquet
    except ImportError:
        return False
    varied = [_column_type(pa, variation.some) for variation in study.variations]
    kinds = [pa.int64(), *varied, pa.string(), *([pa.float64()] * len(study.figures)), pa.string(), pa.string()]
    schema = pa.schema(list(zip(head(study), kinds, strict=True)))
    with parquet.ParquetWriter(file, schema) as writer:
        group: list[Sequence[object]] = []

        def flush() -> None:
            columns = [
                pa.array([value if isinstance(value, str) else str(_plain(value)) for value in column])
                if kind == pa.string()
                else pa.array(column, kind)
                for column, kind in zip(zip(*group, strict=True), kinds, strict=True)
            ]
            writer.write_table(pa.table(columns, schema=schema))
            group.clear()

        for row in rows:
            group.append(cells(row))
            if len(group) == _GROUP:
                flush()
        if group:
            flush()
    return True


def _plain(value: object) -> object:
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value, ensure_ascii=False) if isinstance(value, list) else value


def _column_type(pa: Any, values: Sequence[object]) -> Any:
    """Type of a column that holds these values; of numbers of both kinds, and of a range, floats."""
    types = {type(value) for value in values}
    if types == {bool}:
        return pa.bool_()
    if types == {int}:
        return pa.int64()
    return pa.float64() if types <= {int, float} else pa.string()


def write_best(results: Results, rows: Sequence[Row], folder: Path) -> list[str]:
    """Write designs, and read each back; return the files' names.

    Args:
        results: results of the study.
        rows: rows of the designs, the best first.
        folder: folder for the files.

    Raises:
        FileError: a file that was read back is not the design that was computed.
    """
    study, job, names = results.study, DesignJob.of(results.study), []
    digits = len(str(len(rows)))
    for place, row in enumerate(rows, 1):
        key = path_key(study, row.values)
        planned = None if key is None else results.path(key).text
        task = Task(row.number, row.values, planned)
        name = f"{study.name}_best_{place:0{digits}d}"
        text = overridden_text(study.text if planned is None else planned, job.overrides_of(task), name)
        file = folder / f"{name}.toml"
        file.write_text(text, encoding="utf-8", newline="")
        computed = job.design(task).model_copy(update={"name": name})
        if complete_of(file.read_text(encoding="utf-8"), file).content_hash != computed.content_hash:
            raise FileError("{name}: read back it is not the design that was computed; try again", name=file.name)
        names.append(file.name)
    return names


_MOST_SHOWN, _MOST_OF_FRONT = 3000, 500  # designs in pictures
_MOST_JUDGED = 20_000  # designs for the effects of keys
_NO_PYARROW = "pyarrow is not installed: pip install '.[explore]' in cadgen's folder"


@dataclass(frozen=True, repr=False)
class Summary:
    """Summary of a study's results.

    Attributes:
        results: the results.
        states: number of designs in each state.
        front: rows of the front, the best first.
        effects: share of each figure's variance that each key explains alone.
    """

    results: Results
    states: dict[DesignState, int]
    front: tuple[Row, ...]
    effects: dict[str, dict[str, float]]

    def __repr__(self) -> str:
        return (
            f"<Summary of {self.results.study.file.name}, {self.results.count} designs, {len(self.front)} on the front>"
        )

    @classmethod
    def of(cls, results: Results) -> "Summary":
        """Summary of complete results."""
        study = results.study
        states = Counter(row.state for row in results.rows())
        some = [results.row(number) for number in sampled(results.count, _MOST_JUDGED)]
        best = ranked(front(results.rows(), study.objectives), study.objectives)
        return cls(results, dict(sorted(states.items())), tuple(best), effects(study, some))

    def entry(self) -> Facts:
        """The summary, as in the manifest."""
        study = self.results.study
        return Facts(
            study=study.name,
            study_sha256=study.fingerprint,
            base=study.source,
            cadgen=__version__,
            designs=self.results.count,
            states=self.states,
            objectives=[figure.code for figure in study.objectives],
            front=[self.row_facts(row) for row in self.front],
            variance_explained=self.effects,
        )

    def row_facts(self, row: Row) -> Facts:
        """Facts on a design: the values of the study's keys, and its figures by their codes."""
        study = self.results.study
        return Facts(
            number=row.number,
            **dict(zip(study.keys, row.values, strict=True)),
            state=row.state,
            **dict(zip((figure.code for figure in study.figures), row.figures, strict=True)),
            failed=row.failed,
            sentence=row.sentence,
        )


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
        for name, picture in pictures(summary).items():
            yield from map(Artifact, save(picture, folder, f"{stem}_{name}"))
        progress("writing the best designs")
        yield from map(Artifact, write_best(results, summary.front[: study.file.best], folder))

    return publish(stem, out, files, summary.entry(), lambda _: Facts(omitted=omitted))


def pictures(summary: Summary) -> dict[str, Drawing]:
    """Pictures of a study by their names, as of `exploration_pictures`.

    Args:
        summary: summary of its results.
    """
    results = summary.results
    study = results.study
    rows = [results.row(number) for number in sampled(results.count, _MOST_SHOWN)]
    shown = [row for row in rows if row.state in (DesignState.KEPT, DesignState.OUTSIDE)]
    return exploration_pictures(
        ExplorationPicture(
            title=f"{study.name}: {results.count} designs, {summary.states.get(DesignState.KEPT, 0)} within all limits",
            keys=study.keys,
            figures=tuple(figure.code for figure in study.objectives),
            more=tuple(figure.more for figure in study.objectives),
            resolutions=tuple(figure.resolution for figure in study.objectives),
            values=tuple((*row.values, *row.figures[: len(study.objectives)]) for row in shown),
            kept=tuple(row.state == DesignState.KEPT for row in shown),
            front=tuple(
                (*summary.front[at].values, *summary.front[at].figures[: len(study.objectives)])
                for at in sampled(len(summary.front), _MOST_OF_FRONT)
            ),
            effects=summary.effects,
        )
    )
