"""The next measurement, and runs predicted: results of `next_measurement` and `Calibration.predict`."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cadgen.inference.expectation.next_measurement import Expected, Next
    from cadgen.inference.expectation.predict import Prediction
    from cadgen.output.report.terminal import Block

_REPORT_WIDTH = 110


@dataclass(frozen=True, eq=False, repr=False)
class Advice:
    """Measurements that could be made, ranked by where the run is then expected to end on a new cam.

    Attributes:
        computed: the whole result.
        measured: whether something was measured already.
    """

    computed: "Next"
    measured: bool

    def __repr__(self) -> str:
        return f"<Advice: {self.ranked[0].words}>"

    @property
    def ranked(self) -> "tuple[Expected, ...]":
        """The measurements, best first: `words`, `runs`, `end` (its `mean`, `least` and `most`, mm), `names_sure`."""
        return self.computed.ranked

    @property
    def report(self) -> "list[Block]":
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        from cadgen.jobs.calibration.advice import words

        return words(self.computed, measured=self.measured)

    def __str__(self) -> str:
        from cadgen.output.report.terminal import plain

        return plain(self.report, _REPORT_WIDTH)

    def facts(self) -> dict[str, Any]:
        """Everything as plain values."""
        from cadgen.jobs.calibration.advice import facts

        return facts(self.computed)


@dataclass(frozen=True, eq=False, repr=False)
class Predictions:
    """Measured data that a calibration did not use, predicted with what it found.

    Attributes:
        each: one for each of the data: root mean squares of each run `before` and `after`, in `unit`, and the same with
            the start `as_logged`.
    """

    each: "tuple[Prediction, ...]"

    def __repr__(self) -> str:
        return f"<Predictions of {', '.join(p.source for p in self.each)}>"

    @property
    def report(self) -> "list[Block]":
        """Everything in a table and sentences; `str` of the result gives them as text."""
        from cadgen.jobs.calibration.prediction import words

        return words(self.each)

    def __str__(self) -> str:
        from cadgen.output.report.terminal import plain

        return plain(self.report, _REPORT_WIDTH)

    def facts(self) -> list[dict[str, Any]]:
        """Everything as plain values."""
        from cadgen.jobs.calibration.prediction import facts

        return facts(self.each)
