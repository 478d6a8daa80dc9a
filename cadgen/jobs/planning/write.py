"""The files of a plan, published: the design with its path."""

from collections.abc import Iterator
from pathlib import Path

from cadgen.design.load import design_of
from cadgen.errors import FileError
from cadgen.jobs.planning.path_report import facts
from cadgen.jobs.planning.plan import PathPlanning
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.progress import Progress, silent


def write_plan(planned: PathPlanning, out: Path, progress: Progress = silent) -> Written:
    """Publish the design with the planned path.

    Args:
        planned: a plan that has passed its checks.
        out: folder, which is made if need be.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: the file cannot be written, or read back is not what was written.
    """
    stem = f"{planned.design.name}_planned"
    progress("writing")

    def files(folder: Path) -> Iterator[Artifact]:
        file = folder / f"{stem}.toml"
        yield text_file(file, planned.text)
        again = design_of(file.read_text(encoding="utf-8"), file)
        if planned.cam is None or again.content_hash != planned.cam.origin.content_hash:
            raise FileError(
                "{file}: read back it is not what was written; try again or choose another disk", file=file.name
            )

    return publish(stem, out, files, facts(planned))
