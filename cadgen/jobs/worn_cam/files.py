"""Files of a measured cam: report, JSON and the new design, published together."""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from cadgen.figures import Facts
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report.terminal import Block, plain
from cadgen.progress import Progress

REPORT_WIDTH = 110


def write_measured(
    stem: str, folder: Path, facts: Facts, report: Sequence[Block], progress: Progress, designs: Mapping[str, str]
) -> Written:
    """Write report and JSON of a measured cam, with the new design where there is one.

    Args:
        stem: begin of the files' names.
        folder: where to.
        facts: result as facts.
        report: result in words.
        progress: function that is called with a few words on each step.
        designs: texts of new designs by their names.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    progress("writing")

    def files(staging: Path) -> Iterator[Artifact]:
        content = json.dumps(facts.json(), indent=2, allow_nan=False, ensure_ascii=False)
        yield text_file(staging / f"{stem}.json", f"{content}\n")
        yield text_file(staging / f"{stem}.txt", plain(report, REPORT_WIDTH))
        for name, text in designs.items():
            yield text_file(staging / f"{name}.toml", text)

    return publish(stem, folder, files, facts)
