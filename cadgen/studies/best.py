"""The best designs of a study as design files, comments of the base kept, that every other command takes."""

from collections.abc import Sequence
from pathlib import Path

from cadgen.design.load import design_of
from cadgen.design.planned import overridden_text
from cadgen.errors import FileError
from cadgen.studies.evaluate import Job, Row, Task
from cadgen.studies.paths import path_key
from cadgen.studies.results import Results


def write_best(results: Results, rows: Sequence[Row], folder: Path) -> list[str]:
    """Write designs, and read each back; return the files' names.

    Args:
        results: results of the study.
        rows: rows of the designs, the best first.
        folder: folder for the files.

    Raises:
        FileError: a file that was read back is not the design that was computed.
    """
    study, job, names = results.study, Job.of(results.study), []
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
        if design_of(file.read_text(encoding="utf-8"), file).content_hash != computed.content_hash:
            raise FileError(f"{file.name}: read back it is not the design that was computed; try again")
        names.append(file.name)
    return names
