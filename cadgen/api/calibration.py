"""Results of judging measured data: what `Design.calibrate` and `Design.calibrate_each` give."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from os import PathLike
from typing import Generic, TypeVar

from cadgen.api.loaded import LoadedDesign
from cadgen.api.measured import Data, reading_of, sources_of
from cadgen.figures import Facts
from cadgen.jobs.calibration.advice import Advice as Advice
from cadgen.jobs.calibration.advice import Predictions as Predictions
from cadgen.jobs.calibration.as_built_file import as_built_text
from cadgen.jobs.calibration.calibration import CalibrationPlan
from cadgen.jobs.calibration.calibration_report import report, summary
from cadgen.jobs.calibration.files import calibration_facts, summary_facts, write_calibration, write_each
from cadgen.jobs.calibration.learned_workshop import LEAST_CARS, workshop_of
from cadgen.jobs.calibration.new_cam import Built
from cadgen.jobs.calibration.workshop import Workshop
from cadgen.messages import Message
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report.notebook import Pictured, bars_picture
from cadgen.output.report.record_pictures import record_picture
from cadgen.output.report.style import Drawing
from cadgen.output.report.terminal import Block, plain
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness

_REPORT_WIDTH = 110


D = TypeVar("D", bound=LoadedDesign)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Calibration(CalibrationPlan, Pictured, Generic[D]):
    """Result of `Design.calibrate`: the effects found in measured data of one car, and the design built from them.

    Attributes:
        design: that was measured against.
    """

    design: D

    @classmethod
    def of(cls, plan: CalibrationPlan, design: D) -> "Calibration[D]":
        """Calibration with its design.

        Args:
            plan: what was computed.
            design: design that was measured against.
        """
        return cls(design=design, **{item.name: getattr(plan, item.name) for item in fields(plan)})

    def __repr__(self) -> str:
        said = ", ".join(f"{kind} {verdict}" for kind, verdict in self.verdicts.items())
        return f"<Calibration of {self.against.name}: {said}>"

    @property
    def computed(self) -> CalibrationPlan:
        """The whole result, for figures that are not named here: this object itself."""
        return self

    @property
    def effects(self) -> tuple[Built, ...]:
        """Everything that goes into the design as built, with its place there.

        `claim.sure` is false where the name is not sure, but what it does to the run together with the others is.
        `claim.finding.effect` is its name, `claim.finding.values` its numbers with standard deviations, in the unit
        that each name ends in.
        """
        return self.built

    @cached_property
    def as_built(self) -> D:
        """The design with what was measured in its [as_built]; the design as it was, if nothing was found."""
        if not self.built:
            return self.design
        return type(self.design).from_toml(as_built_text(self, self.design.text), f"{self.against.name}_as_built")

    def next_measurement(self, *, progress: Progress = silent) -> Advice:
        """Rank what could be measured next by where the run is then expected to end on a new cam.

        Args:
            progress: function that is called with a few words on each step.

        Raises:
            FileError: the data are judged apart.
        """
        return Advice.after(self, self.design.complete(), progress)

    def predict(
        self,
        data: Data | Iterable[Data],
        *,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> Predictions:
        """Predict measured data that were not used, with what was found.

        Args:
            data: as of `Design.calibrate`.
            columns: as of `Design.calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: data cannot be read, were used, or cannot be predicted by what was.
        """
        reading = reading_of(self.design.complete(), columns)
        return Predictions.of(self, sources_of(data, reading, each=True, progress=progress), progress)

    @property
    def report(self) -> list[Block]:
        """Everything in paragraphs and tables; `str` of the result gives them as text."""
        return report(self)

    def __str__(self) -> str:
        return plain(self.report, _REPORT_WIDTH)

    @property
    def picture(self) -> Drawing:
        """Residuals of the first file before and after, and the candidates."""
        return record_picture(self.diagnoses[0], self.track_length)

    def entry(self) -> Facts:
        """Everything, as in the JSON file; docs/measurement.md explains the keys."""
        return calibration_facts(self)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the report, pictures, JSON and the design as built, all together or none.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or the design as built, read back, is not what was meant.
        """
        return write_calibration(self, self.design.text, folder_of(folder), progress)


@dataclass(frozen=True)
class Calibrations(Pictured, Generic[D]):
    """Result of `Design.calibrate_each`: a verdict on each measured file, judged alone.

    Attributes:
        each: one for each of the data, in their order.
    """

    each: tuple[Calibration[D], ...]

    @cached_property
    def workshop(self) -> Workshop | None:
        """Workshop of the cars, for `tolerance` and `calibrate`; None where fewer than three tell of themselves."""
        return workshop_of(self.each[0].design.complete(), self.each)

    @property
    def unclear(self) -> dict[str, str]:
        """The verdicts that leave something unexplained or undecided, by the measured file."""
        return {
            source.path.name: verdict
            for calibration in self.each
            for source in calibration.sources
            for verdict in calibration.unclear.values()
        }

    @property
    def cams_unknown(self) -> tuple[str, ...]:
        """Names of the measured files that do not tell which cam was on the car."""
        return tuple(c.sources[0].path.name for c in self.each if c.cam_unknown)

    @property
    def readiness(self) -> Readiness:
        """Readiness of the file of which least is explained."""
        return max((calibration.readiness for calibration in self.each), key=list(Readiness).index)

    @property
    def left(self) -> float:
        """RMS of what remains without a name, over the noise, in the file that leaves most."""
        return max(calibration.left for calibration in self.each)

    @property
    def picture(self) -> Drawing:
        """Remainder without a name in each file, over its noise."""
        bars = {", ".join(source.path.name for source in c.sources): c.left for c in self.each}
        return bars_picture("Files judged alone", "what remains without a name, over the noise (rms)", bars)

    @property
    def report(self) -> list[Block]:
        """Table with a row for each, and what the cars differ by."""
        blocks = summary(self.each)
        if self.workshop is not None:
            blocks += self.workshop.report
        elif len(self.each) >= LEAST_CARS and self.cams_unknown:
            blocks.append(
                Message(
                    "What the cars differ by is not learned: there are fewer than {least} of which the cam is sure.",
                    least=LEAST_CARS,
                )
            )
        return blocks

    def entry(self) -> Facts:
        """Everything, as in the JSON file."""
        return summary_facts(self.each)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the table and JSON; errors as in `Calibration.write`.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.
        """
        place = folder_of(folder)
        progress("writing")
        return write_each(self.each, place, self.workshop)
