"""Figures and files that a pair of gears and a train have alike. Lengths are mm and angles rad."""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from os import PathLike
from typing import TYPE_CHECKING, Any

from cadgen.api.files import Written, folder_of, refusal
from cadgen.check import Check
from cadgen.errors import CheckError
from cadgen.jobs.gears.facts import plan_facts
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.gear_solids import Compound
    from cadgen.jobs.gears.numbers import TrainPlan


@dataclass(frozen=True)
class ReturnError:
    """Free angle of the output while the drive stands still.

    Attributes:
        least: least return error within the tolerances, rad; below 0 the teeth may jam.
        as_cut: return error with every size in the middle, as drawn and as built in CAD, rad.
        greatest: greatest return error within the tolerances, rad.
    """

    least: float
    as_cut: float
    greatest: float


class Assembly(ABC):
    """A planned pair or train, from a design or from numbers."""

    @property
    @abstractmethod
    def computed(self) -> "GearsPlan | TrainPlan":
        """Numeric plan."""

    @property
    def checks(self) -> tuple[Check, ...]:
        """The teeth in mesh, measured on their sections, and the parts: every figure with its verdict."""
        return self.computed.checks

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return self.computed.passed

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return tuple(check for check in self.checks if not check.passed)

    @property
    def ratio(self) -> Fraction:
        """Turns of the drive per turn of the output."""
        return self.computed.play.train.ratio

    @cached_property
    def return_error(self) -> ReturnError:
        """Free angle of the output while the drive stands still, rad: of the teeth alone."""
        play, cut = self.computed.play, self.computed.layout.train
        free = [stage.free_angle() / float(ratio) for stage, ratio in zip(cut.stages, cut.output_ratios, strict=True)]
        return ReturnError(float(play.return_error_min), sum(free), float(play.return_error_max))

    def facts(self) -> dict[str, Any]:
        """All facts as plain values, as in the manifest: every tolerance, play, part and inspection size."""
        plan = self.computed
        return plan_facts(plan) if isinstance(plan, GearsPlan) else plan.facts()

    def build123d(self) -> "Compound":
        """The parts in mesh as one build123d compound, a labelled and coloured solid for each, mm.

        Raises:
            FileError: the CAD kernel cannot drill a set screw.
        """
        from cadgen.geometry.solids.gear_solids import train_compound, train_parts

        plan = self.computed
        return train_compound(train_parts(plan.layout, plan.stem, plan.description), plan.layout, f"{plan.stem}_train")

    def write(
        self,
        folder: str | PathLike[str],
        formats: str | Iterable[str] | None = None,
        *,
        force: bool = False,
        progress: Progress = silent,
    ) -> Written:
        """Write files, measure the play on the teeth read back, and publish all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            formats: some of step (the assembly and each part), stl and csv (the table of parts); all if left out.
            force: whether files are written even if a check fails; the manifest then says so.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: a check fails.
            DesignError: a format is unknown.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.jobs.gears.files import write_train

        place = folder_of(folder)
        if not (self.passed or force):
            raise CheckError(refusal(self.failed))
        return write_train(self.computed, self.facts(), place, progress, formats)
