"""The files of a plan, published: the design with its path."""

from pathlib import Path

from cadgen.design.load import design_of
from cadgen.errors import FileError
from cadgen.jobs.planning.plan import PlannedPath
from cadgen.jobs.planning.words import facts
from cadgen.output.files.folder import publishing
from cadgen.output.files.manifest import Written, file_facts, versions, write_manifest
from cadgen.progress import Progress, silent


def write_plan(planned: PlannedPath, out: Path, progress: Progress = silent) -> Written:
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
    with publishing(out) as staging:
        file = staging / f"{stem}.toml"
        file.write_text(planned.text, encoding="utf-8", newline="")
        again = design_of(file.read_text(encoding="utf-8"), file)
        if planned.cam is None or again.content_hash != planned.cam.design.content_hash:
            raise FileError(f"{file.name}: read back it is not what was written; try again or choose another disk")
        entry = {**facts(planned), "versions": versions(), "files": {file.name: file_facts(file)}}
        write_manifest(staging, stem, entry)
    return Written(stem, entry)
