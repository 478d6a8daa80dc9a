"""Page of a gear train alone: its gears in mesh, checks, play, inspection sheet and parts."""

from dataclasses import dataclass
from math import degrees

from cadgen.check import Check
from cadgen.design.schema import TrainDesign
from cadgen.figures import Cell, Emphasis, Facts, number
from cadgen.gears.choices import Order
from cadgen.jobs.cam.cures import Cures
from cadgen.jobs.gears.gear_train import GearTrain, plan_gears
from cadgen.messages import Message
from cadgen.output.files.manifest import Origin
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness, Reservation
from cadgen.viewer.page.document import Chart, LiftMark, Scene, Section
from cadgen.viewer.page.page_plan import Refusal, Scope
from cadgen.viewer.page.scene import train_scene
from cadgen.viewer.page.sections import train_sections


@dataclass(frozen=True)
class TrainPage:
    """Results that the page of a train alone shows; what only a cam has is empty.

    Attributes:
        gears: gear train.
    """

    gears: GearTrain
    cures = Cures((), (), 0)
    refusals: tuple[Refusal, ...] = ()
    scope = Scope.REPORT

    @property
    def origin(self) -> Origin:
        """Design of the train."""
        return self.gears.origin

    @property
    def subtitle(self) -> str:
        """Order of its stages."""
        return self.gears.order

    @property
    def reservations(self) -> tuple[Reservation, ...]:
        """Reservations, of which a train has none: it is judged by its checks."""
        return ()

    @property
    def checks(self) -> tuple[Check, ...]:
        """Checks of the gears."""
        return tuple(self.gears.checks)

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return self.gears.passed

    @property
    def readiness(self) -> Readiness:
        """Verdict on the train."""
        return Readiness.READY if self.passed else Readiness.NOT_READY

    def drawn(self) -> tuple[Scene, tuple[str, ...]]:
        """Scene of the page, without remarks."""
        return train_scene(self.gears), ()

    def charts(self) -> tuple[Chart, ...]:
        """Charts, of which a train has none: it has no lift."""
        return ()

    def marks(self) -> tuple[LiftMark, ...]:
        """Marks on the lift, of which a train has none."""
        return ()

    def sections(self) -> tuple[Section, ...]:
        """Tables of the page."""
        return train_sections(self.gears)

    def summary(self) -> tuple[tuple[str, Cell], ...]:
        """Figures at the top, by name."""
        passing, whole = sum(check.passed for check in self.checks), self.gears.return_error
        state = Emphasis.GOOD if self.passed else Emphasis.BAD
        return (
            (Message("checks that pass"), Cell(f"{passing} / {len(self.checks)}", state=state)),
            (Message("ratio of the train"), Cell(str(self.gears.ratio))),
            (Message("return error, least"), number(degrees(whole.least), "°")),
            (Message("return error, greatest"), number(degrees(whole.greatest), "°")),
        )

    def figures(self) -> Facts:
        """Every figure of the page, as `cadgen gears` gives them."""
        return self.origin.entry() | Facts(passed=self.passed, refused=[], gears=self.gears.entry())


def plan_train_page(design: TrainDesign, progress: Progress = silent) -> TrainPage:
    """Compute what a report of a train alone shows: its stages as the design has them.

    Args:
        design: loaded design with [train].
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the train cannot be made.
    """
    return TrainPage(plan_gears(design, Order.AS_GIVEN, progress))
