"""Everything that a report page shows, computed once, and what stands on the page: of a cam by its motion."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from math import degrees
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import TURN
from cadgen.check import Check, CheckCode
from cadgen.design.schema import MotionDesign, TrainDesign
from cadgen.errors import DesignError, FileError
from cadgen.figures import Cell, Emphasis, Facts, number
from cadgen.gears.choices import Order
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.cures import Cures, find_cures
from cadgen.jobs.cam.motion_cam import plan_motion_cam
from cadgen.jobs.gears.gear_train import GearTrain, plan_gears
from cadgen.laws.unit import MM, TAN
from cadgen.messages import Message
from cadgen.output.files.manifest import Origin
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness, Reservation
from cadgen.viewer.page.charts import STATIONS, charts_of, marks_of
from cadgen.viewer.page.document import Chart, LiftMark, Scene, Section
from cadgen.viewer.page.rim import compared_rim
from cadgen.viewer.page.scene import plain_scene
from cadgen.viewer.page.sections import checks_section, compared_section, parts_sections, refused_section

if TYPE_CHECKING:
    from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan


class Scope(StrEnum):
    """Content of a page: all; without what takes long, while the design is edited; or model and curves alone."""

    REPORT = "report"
    EDITED = "edited"
    PREVIEW = "preview"


class Topic(StrEnum):
    """Part of a report."""

    PROFILE = "profile"
    GEARS = "gears"
    TOLERANCE = "tolerance"
    CALIBRATION = "calibration"


MakeGears = Callable[[TrainDesign, Order, Progress], GearTrain]


@dataclass(frozen=True)
class Refusal:
    """A part of the report that could not be computed.

    Attributes:
        part: part of the report.
        reason: sentence of the refusal.
        fails: whether the design thereby fails.
    """

    part: Topic
    reason: str
    fails: bool = False


@dataclass(frozen=True, kw_only=True)
class PagePlan:
    """Results that a page shows, and what stands on it. A subclass has what an application brings besides.

    Attributes:
        cam: cam, compared under play on all trains if the design has play.
        cures: cures of lost lift.
        gears: gear train; None without one.
        refusals: reasons for what is missing.
        scope: what is shown.
    """

    cam: CamPlan
    cures: Cures
    gears: GearTrain | None
    refusals: tuple[Refusal, ...] = ()
    scope: Scope = Scope.REPORT

    @property
    def origin(self) -> Origin:
        """Design of the cam."""
        return self.cam.origin

    @property
    def subtitle(self) -> str:
        """Kind of profile."""
        return self.cam.kind.code

    @property
    def reservations(self) -> tuple[Reservation, ...]:
        """Reservations of the cam's verdict."""
        return self.cam.verdict.reservations

    @property
    def checks(self) -> tuple[Check, ...]:
        """Checks of cam and gears."""
        return (*self.cam.verdict.checks, *(self.gears.checks if self.gears else ()))

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit, and nothing was refused that fails the design."""
        return all(check.passed for check in self.checks) and not any(refusal.fails for refusal in self.refusals)

    @property
    def readiness(self) -> Readiness:
        """Verdict on cam and gears together."""
        return self.cam.verdict.readiness if self.passed else Readiness.NOT_READY

    def drawn(self) -> tuple[Scene, tuple[str, ...]]:
        """Scene of the page, and remarks."""
        scene, notes = plain_scene(self.cam, self.gears)
        return scene, (*self.cam.application.notes(self.cam), *notes)

    def charts(self) -> tuple[Chart, ...]:
        """Curves over the cam angle."""
        return charts_of(self.cam)

    def marks(self) -> tuple[LiftMark, ...]:
        """Marked places of the turn."""
        return marks_of(self.cam)

    def sections(self) -> tuple[Section, ...]:
        """Tables of the page."""
        return checks_section(self.cam, self.gears), *parts_sections(self.cam, self.gears)

    def summary(self) -> tuple[tuple[str, Cell], ...]:
        """Figures at the top, by name."""
        checks = self.checks
        passing = sum(check.passed for check in checks)
        state = Emphasis.BAD if passing < len(checks) else Emphasis.GOOD
        rows: list[tuple[str, Cell]] = [
            (Message("checks that pass"), Cell(f"{passing} / {len(checks)}", state=state)),
            *self.results(),
        ]
        if self.gears is not None:
            rows.append((Message("ratio of the train"), Cell(str(self.gears.play.train.ratio))))
        return tuple(rows)

    def results(self) -> tuple[tuple[str, Cell], ...]:
        """Figures at the top of what the cam is for, by name: travel and steepest place."""
        q = self.cam.motion.q(np.linspace(0.0, TURN, STATIONS + 1))
        travel = float(np.ptp(np.arctan(q) if self.cam.motion.unit == TAN else q))
        angles = [
            check
            for check in self.cam.checks
            if check.code in (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN)
        ]
        return (
            (Message("swing of the follower"), number(degrees(travel), "°"))
            if self.cam.motion.unit != MM
            else (Message("travel of the follower"), number(travel, "mm")),
            *(
                (check.name, number(check.value, check.unit, Emphasis.PLAIN if check.passed else Emphasis.BAD, 1))
                for check in angles
            ),
        )

    def figures(self) -> Facts:
        """Every figure of the page, as the other commands give them."""
        facts = Facts(
            profile=self.subtitle,
            passed=self.passed,
            refused=[Facts(part=refusal.part, reason=refusal.reason) for refusal in self.refusals],
            cam=cam_facts(self.cam, self.cures),
            gears=self.gears and self.gears.entry(),
        )
        return self.origin.entry() | facts | self.entry()

    def entry(self) -> Facts:
        """Figures of what the application brings."""
        return Facts(simulation=None, remedies=[], tolerance=None, calibration=None)


@dataclass(frozen=True, kw_only=True)
class MeasuredPage(PagePlan):
    """Results that the page of a measured cam by its motion shows.

    Attributes:
        compared: what differs from the design; None where the record cannot be judged.
    """

    compared: "ComparedCamPlan | None"

    def drawn(self) -> tuple[Scene, tuple[str, ...]]:
        """Scene of the page with the deviations on the rim, and remarks."""
        scene, notes = super().drawn()
        return (scene if self.compared is None else replace(scene, rim=compared_rim(self.compared))), notes

    def sections(self) -> tuple[Section, ...]:
        """Tables of the page, those of the measurement after the checks."""
        checks, *parts = super().sections()
        reason = next((refusal.reason for refusal in self.refusals if refusal.part == Topic.CALIBRATION), "")
        measured = refused_section(reason) if self.compared is None else compared_section(self.compared)
        return checks, measured, *parts

    def entry(self) -> Facts:
        """Figures of the measurement."""
        return super().entry() | Facts(calibration=self.compared and self.compared.entry())


Compare = Callable[[Progress], "ComparedCamPlan"]


def plan_motion_page(
    design: MotionDesign,
    profile: str | None = None,
    progress: Progress = silent,
    *,
    compare: Compare | None = None,
) -> PagePlan:
    """Compute what a report of a cam by its motion shows.

    Args:
        design: loaded design with [motion].
        profile: code of a profile; the actual one if left out.
        progress: function that is called with a few words on each step.
        compare: function that reads what was measured and compares it with the design; None without a measurement.

    Raises:
        DesignError: no cam can be computed.
    """
    refusals: list[Refusal] = []
    cam = plan_motion_cam(design, profile, progress)
    gears = gears_of(design, plan_gears, refusals, progress)
    if compare is None:
        return PagePlan(cam=cam, cures=find_cures(cam, progress), gears=gears, refusals=tuple(refusals))
    compared = None
    try:
        compared = compare(progress)
    except (DesignError, FileError) as error:
        refusals.append(Refusal(Topic.CALIBRATION, error.message, fails=True))
    return MeasuredPage(
        cam=cam, cures=find_cures(cam, progress), gears=gears, refusals=tuple(refusals), compared=compared
    )


def plan_edited_motion(
    design: MotionDesign, make_gears: MakeGears, progress: Progress = silent, *, preview: bool = False
) -> PagePlan:
    """Compute what the editor shows of a cam by its motion.

    Args:
        design: loaded design with [motion].
        make_gears: function that plans its train.
        progress: function that is called with a few words on each step.
        preview: whether the cam alone is wanted, for a first look.

    Raises:
        DesignError: no cam can be computed.
    """
    cam, refusals = plan_motion_cam(design, None, progress), list[Refusal]()
    if preview:
        return PagePlan(cam=cam, cures=Cures((), (), 0), gears=None, scope=Scope.PREVIEW)
    gears = gears_of(design, make_gears, refusals, progress)
    return PagePlan(cam=cam, cures=find_cures(cam, progress), gears=gears, refusals=tuple(refusals), scope=Scope.EDITED)


def gears_of(design: TrainDesign, make: MakeGears, refusals: list[Refusal], progress: Progress) -> GearTrain | None:
    """The train, or a refusal if it cannot be made; None without one.

    Args:
        design: loaded design.
        make: function that plans its train.
        refusals: list that a refusal is added to.
        progress: function that is called with a few words on each step.
    """
    if design.train is None:
        return None
    try:
        return make(design, Order.AS_GIVEN, progress)
    except DesignError as error:
        refusals.append(Refusal(Topic.GEARS, error.message, fails=True))
        return None
