"""Results of judging measured data: what `Design.calibrate` and `Design.calibrate_each` give."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import TYPE_CHECKING, Any, Generic, Protocol, Self, TypeVar

from cadgen.api.files import Written, folder_of, written
from cadgen.api.measured import Data, sources_of
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.api.advice import Advice, Predictions
    from cadgen.jobs.calibration import places
    from cadgen.jobs.calibration import plan as calibrations
    from cadgen.output.report.terminal import Block

_REPORT_WIDTH = 110


class _Written(Protocol):
    """A design as a result needs it: its text, and a way to make another one of a text."""

    @property
    def text(self) -> str:
        """Of the design file."""

    @classmethod
    def from_toml(cls, text: str, name: str) -> Self:
        """The design of a text and a name."""


D = TypeVar("D", bound=_Written)


@dataclass(frozen=True, eq=False, repr=False)
class Calibration(Generic[D]):
    """Result of `Design.calibrate`: the effects found in measured data of one car, and the design built from them.

    Attributes:
        computed: the whole result, for figures that are not named here.
        design: that was measured against.
    """

    computed: "calibrations.Calibration"
    design: D

    def __repr__(self) -> str:
        return f"<Calibration of {self.computed.design.name}: {self.verdicts}>"

    @property
    def verdicts(self) -> dict[str, str]:
        """Kind of data -> class of the verdict on it, such as `traced` or `ambiguous`."""
        return {source.kind.code: self.computed.verdict(source.kind) for source in self.computed.sources}

    @property
    def unclear(self) -> dict[str, str]:
        """The verdicts that leave something unexplained or undecided, by the kind of data."""
        from cadgen.inference.measurement.diagnosis import SOUND

        return {kind: verdict for kind, verdict in self.verdicts.items() if verdict not in SOUND}

    @property
    def effects(self) -> "tuple[places.Built, ...]":
        """Everything that goes into the design as built, with its place there.

        `claim.sure` is false where the name is not sure, but what it does to the run together with the others is.
        `claim.finding.effect` is its name, `claim.finding.values` its numbers with standard deviations, in the unit
        that each name ends in.
        """
        return self.computed.built

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences on data that do not fit, but were accepted."""
        return self.computed.warnings

    @cached_property
    def as_built(self) -> D:
        """The design with what was measured in its [as_built]; the design as it was, if nothing was found."""
        from cadgen.jobs.calibration.as_built_file import as_built_text

        if not self.computed.built:
            return self.design
        text = as_built_text(self.computed, self.design.text)
        return type(self.design).from_toml(text, f"{self.computed.design.name}_as_built")

    def next_measurement(self, *, progress: Progress = silent) -> "Advice":
        """Rank what could be measured next by where the run is then expected to end on a new cam.

        Args:
            progress: function that is called with a few words on each step.

        Raises:
            FileError: the data contradict each other.
        """
        from cadgen.api.advice import Advice
        from cadgen.jobs.calibration.advice import after

        return Advice(after(self.computed, progress), measured=True)

    def predict(self, data: Data | Iterable[Data], *, progress: Progress = silent) -> "Predictions":
        """Predict measured data that were not used, with what was found.

        Args:
            data: as of `Design.calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: data cannot be read, were used, or cannot be predicted by what was.
        """
        from cadgen.api.advice import Predictions
        from cadgen.jobs.calibration.prediction import predicted

        unseen = sources_of(data, each=True, progress=progress)
        return Predictions(predicted(self.computed, unseen, progress))

    @property
    def report(self) -> "list[Block]":
        """Everything in paragraphs and tables; `str` of the result gives them as text."""
        from cadgen.jobs.calibration.words import report

        return report(self.computed)

    def __str__(self) -> str:
        from cadgen.output.report.terminal import plain

        return plain(self.report, _REPORT_WIDTH)

    def facts(self) -> dict[str, Any]:
        """Everything as plain values, as in the JSON file."""
        from cadgen.jobs.calibration.files import document

        return document(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the report, pictures, JSON and the design as built, all together or none.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or the design as built, read back, is not what was meant.
        """
        from cadgen.jobs.calibration.files import write_calibration

        return written(folder, lambda place: write_calibration(self.computed, self.design.text, place, progress))


@dataclass(frozen=True)
class Calibrations(Generic[D]):
    """Result of `Design.calibrate_each`: a verdict on each measured file, judged alone.

    Attributes:
        each: one for each of the data, in their order.
    """

    each: tuple[Calibration[D], ...]

    @property
    def unclear(self) -> dict[str, str]:
        """The verdicts that leave something unexplained or undecided, by the measured file."""
        return {
            source.path.name: verdict
            for calibration in self.each
            for source in calibration.computed.sources
            for verdict in calibration.unclear.values()
        }

    @property
    def report(self) -> "list[Block]":
        """One table with a row for each."""
        from cadgen.jobs.calibration.words import summary

        return summary([calibration.computed for calibration in self.each])

    def facts(self) -> dict[str, Any]:
        """Everything as plain values, as in the JSON file."""
        from cadgen.jobs.calibration.files import documents

        return documents([calibration.computed for calibration in self.each])

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the table and JSON; errors as in `Calibration.write`.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.
        """
        from cadgen.jobs.calibration.files import write_each

        place = folder_of(folder)
        progress("writing")
        written = write_each([calibration.computed for calibration in self.each], place)
        return Written.of(place, written.part, written.entry)
