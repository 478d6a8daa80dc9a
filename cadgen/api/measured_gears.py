"""Results of measuring gears: what `Design.judge_train` and `Design.judge_gear` give."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees

from cadgen.api.found_cam import MeasuredResult
from cadgen.jobs.measured_gears.measured_gear import MeasuredGearPlan, gear_report
from cadgen.jobs.measured_gears.measured_train import MeasuredTrainPlan, line_sizes, train_report
from cadgen.output.report.notebook import bars_picture
from cadgen.output.report.style import Drawing
from cadgen.output.report.terminal import Block


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class MeasuredTrain(MeasuredTrainPlan, MeasuredResult):
    """Measured train beside its design: play, wind-up, run-out of its wheels, and what to change."""

    _ending = "transmission"

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        return train_report(self)

    @property
    def designs(self) -> Mapping[str, str]:
        """Text of the corrected design by its name; empty where nothing is to be changed."""
        return {} if self.corrected is None else {f"{self.design.name}_corrected": self.corrected}

    @property
    def picture(self) -> Drawing:
        """Amplitudes of the transmission error by order, with the noise of a reading."""
        bars = {**line_sizes(self), "noise of a reading": degrees(self.errors.noise)}
        return bars_picture(f"{self.names}: transmission error", "° at the output", bars)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class MeasuredGear(MeasuredGearPlan, MeasuredResult):
    """Measured gear beside its design: deviations of its flanks, their class, its errors, and the play with it."""

    _ending = "gear"

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        return gear_report(self)

    @property
    def designs(self) -> Mapping[str, str]:
        """Text of the design with the gear as it was measured, by its name."""
        return {} if self.as_built is None else {f"{self.design.name}_as_built": self.as_built}

    @property
    def picture(self) -> Drawing:
        """Deviations of the flanks by their symbols."""
        bars = {each.symbol: 1e3 * each.worst for each in self.measured}
        return bars_picture(f"{self.names}: flanks", "µm", bars)
