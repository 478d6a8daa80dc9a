"""Results of measuring a cam: what `Design.find_motion` and `Design.compare_cam` give."""

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from os import PathLike
from typing import Any, ClassVar, Self

import numpy as np

from cadgen.api.cam import Cam
from cadgen.jobs.lift_tolerance import NAMES
from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan, compared_report
from cadgen.jobs.worn_cam.found_cam import FoundCamPlan
from cadgen.jobs.worn_cam.found_report import REPORT_WIDTH, found_report, write_measured
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report.notebook import Pictured, bars_picture, lines_picture
from cadgen.output.report.style import Drawing
from cadgen.output.report.terminal import Block, plain
from cadgen.progress import Progress, silent

_UM = 1e3


class MeasuredResult(Pictured):
    """Base of the results of measuring a cam."""

    design: Any
    _ending: ClassVar[str]

    @classmethod
    def of(cls, plan: Any) -> Self:
        """Result of what was computed.

        Args:
            plan: what was computed.
        """
        return cls(**{item.name: getattr(plan, item.name) for item in fields(plan)})

    @property
    def designs(self) -> Mapping[str, str]:
        """Texts of new designs by their names."""
        return {}

    @property
    @abstractmethod
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""

    def __str__(self) -> str:
        return plain(self.report, REPORT_WIDTH)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write report and JSON together, with the new design where there is one.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or read back is not what was written.
        """
        stem = f"{self.design.name}_{self._ending}"
        return write_measured(stem, folder_of(folder), self.entry(), self.report, progress, self.designs)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FoundCam(FoundCamPlan, MeasuredResult):
    """Motion found in a measured cam: laws and ends of segments, wear, the new design and the new cam."""

    _ending = "motion"

    @cached_property
    def cam(self) -> Cam:
        """New cam, made for the motion that was found, and checked by rolling.

        Raises:
            DesignError: no cam can be made for it.
        """
        return Cam.of(super().cam)

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        return found_report(self)

    @property
    def picture(self) -> Drawing:
        """Motion measured and motion found over the turn of the cam that was measured."""
        samples, unit = self.motion.samples, "mm" if self.scale == 1.0 else "°"
        lines = {
            "measured": self.scale * (samples.q - self.motion.base),
            "found": self.scale * self.motion.lift(samples.cam_angle),
        }
        title = f"{self.source.path.name}: motion"
        return lines_picture(
            title, "cam angle (°)", f"lift ({unit})", np.degrees(samples.cam_angle), lines, signed=True
        )

    @property
    def designs(self) -> Mapping[str, str]:
        """Text of the new design by its name."""
        return {self.name: self.toml}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ComparedCam(ComparedCamPlan, MeasuredResult):
    """Measured cam beside its design: deviations with their sizes, and what is left."""

    cam: Cam
    _ending = "compared"

    @classmethod
    def of(cls, plan: ComparedCamPlan) -> Self:
        """Result of what was computed.

        Args:
            plan: what was computed.
        """
        return replace(super().of(plan), cam=Cam.of(plan.cam))

    @property
    def picture(self) -> Drawing:
        """Error along the normal before and after, and what each deviation does to the lift."""
        before_after = {
            "rms against the design": self.comparison.before,
            "rms that is left": self.comparison.after,
            "noise of a reading": self.comparison.noise,
        }
        found = {f"lift by {NAMES[each.code]}": self.at_lift(each) for each in self.found}
        bars = {name: _UM * value for name, value in {**before_after, **found}.items()}
        return bars_picture(f"{self.source.path.name}: what differs", "µm", bars)

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        return compared_report(self)
