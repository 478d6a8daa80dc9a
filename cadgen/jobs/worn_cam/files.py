"""Files of a measured cam: report, JSON and the new design, published together."""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from cadgen.figures import Facts
from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan
from cadgen.jobs.worn_cam.compared_report import compared_report
from cadgen.jobs.worn_cam.found_cam import FoundCamPlan
from cadgen.jobs.worn_cam.found_report import found_report
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report.terminal import Block, plain
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
    return _written(f"{cam.design.name}_motion", folder, cam.entry(), found_report(cam), progress, {cam.name: cam.toml})


def write_compared(cam: ComparedCamPlan, folder: Path, progress: Progress = silent) -> Written:
    """Write report and JSON.

    Args:
        cam: measured cam.
        folder: where to.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    return _written(f"{cam.design.name}_compared", folder, cam.entry(), compared_report(cam), progress, {})


def _written(
    stem: str, folder: Path, facts: Facts, report: Sequence[Block], progress: Progress, designs: Mapping[str, str]
) -> Written:
    """Files of a stem: JSON, report, and designs by their names."""
    progress("writing")

    def files(staging: Path) -> Iterator[Artifact]:
        content = json.dumps(facts.json(), indent=2, allow_nan=False, ensure_ascii=False)
        yield text_file(staging / f"{stem}.json", f"{content}\n")
        yield text_file(staging / f"{stem}.txt", plain(report, REPORT_WIDTH))
        for name, text in designs.items():
            yield text_file(staging / f"{name}.toml", text)

    return publish(stem, folder, files, facts)
