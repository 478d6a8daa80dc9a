"""The report of a calibration on the terminal."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from cadgen.cli.show import Output

if TYPE_CHECKING:
    from cadgen.workflow.calibration.plan import Calibration


def report(calibration: "Calibration") -> None:
    """Print everything that a calibration says."""
    from cadgen.report.text import write
    from cadgen.workflow.calibration import words

    write(words.report(calibration), Output())


def summary(each: "Sequence[Calibration]") -> None:
    """Print one row for each file judged alone."""
    from cadgen.report.text import write
    from cadgen.workflow.calibration import words

    write(words.summary(each), Output())
