"""What to measure next: what `Design.next_measurement` and `Calibration.next_measurement` give."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cadgen.measurement.next_measurement import Expected, Next
    from cadgen.report.text import Block

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
        """The measurements, the best first: `words`, `runs`, `end` (its `mean`, `least` and `most`, mm), `parted`."""
        return self.computed.ranked

    @property
    def report(self) -> "list[Block]":
        """Everything in paragraphs and a table; `str` of the result gives them as text."""
        from cadgen.workflow.calibration.advice import words

        return words(self.computed, measured=self.measured)

    def __str__(self) -> str:
        from cadgen.report.text import plain

        return plain(self.report, _REPORT_WIDTH)

    def facts(self) -> dict[str, Any]:
        """Everything as plain values."""
        from cadgen.workflow.calibration.advice import facts

        return facts(self.computed)
