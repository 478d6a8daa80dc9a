"""Files of a cam whose motion was found: report, JSON and the new design, published together."""

import json
from collections.abc import Iterator
from pathlib import Path

from cadgen.jobs.worn_cam.found_cam import FoundCamPlan
from cadgen.jobs.worn_cam.found_report import found_report
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report.terminal import plain
from cadgen.progress import Progress, silent

REPORT_WIDTH = 110


def write_found(cam: FoundCamPlan, folder: Path, progress: Progress = silent) -> Written:
    """Write report, JSON and the new design.

    Args:
        cam: measured cam.
        folder: where to.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    stem, facts = f"{cam.design.name}_motion", cam.entry()
    progress("writing")

    def files(staging: Path) -> Iterator[Artifact]:
        content = json.dumps(facts.json(), indent=2, allow_nan=False, ensure_ascii=False)
        yield text_file(staging / f"{stem}.json", f"{content}\n")
        yield text_file(staging / f"{stem}.txt", plain(found_report(cam), REPORT_WIDTH))
        yield text_file(staging / f"{cam.name}.toml", cam.toml)

    return publish(stem, folder, files, facts)
