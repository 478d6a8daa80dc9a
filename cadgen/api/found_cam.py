"""Results of measuring a cam: what `Design.find_motion` and `Design.compare_cam` give."""

from dataclasses import dataclass, fields
from os import PathLike
from typing import Self

from cadgen.figures import JobResult
from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan
from cadgen.jobs.worn_cam.compared_report import compared_report
from cadgen.jobs.worn_cam.files import REPORT_WIDTH, write_compared, write_found
from cadgen.jobs.worn_cam.found_cam import FoundCamPlan
from cadgen.jobs.worn_cam.found_report import found_report
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report.terminal import Block, plain
from cadgen.progress import Progress, silent


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FoundCam(FoundCamPlan, JobResult):
    """Motion found in a measured cam: laws and ends of segments, wear, the new design and the new cam."""

    @classmethod
    def of(cls, plan: FoundCamPlan) -> Self:
        """Result of what was computed.

        Args:
            plan: what was computed.
        """
        return cls(**{item.name: getattr(plan, item.name) for item in fields(plan)})

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        return found_report(self)

    def __str__(self) -> str:
        return plain(self.report, REPORT_WIDTH)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write report, JSON and the new design together.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or read back is not what was written.
        """
        return write_found(self, folder_of(folder), progress)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ComparedCam(ComparedCamPlan, JobResult):
    """Measured cam beside its design: deviations with their sizes, and what is left."""

    @classmethod
    def of(cls, plan: ComparedCamPlan) -> Self:
        """Result of what was computed.

        Args:
            plan: what was computed.
        """
        return cls(**{item.name: getattr(plan, item.name) for item in fields(plan)})

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        return compared_report(self)

    def __str__(self) -> str:
        return plain(self.report, REPORT_WIDTH)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write report and JSON together.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or read back is not what was written.
        """
        return write_compared(self, folder_of(folder), progress)
