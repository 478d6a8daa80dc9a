"""Everything that a report page shows, computed once: cam, gears, runs, tolerance, calibration."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.check import Check
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design, MotionDesign, TrainDesign
from cadgen.errors import CheckError, DesignError, FileError
from cadgen.gears.choices import Order
from cadgen.jobs.cam.cam_plan import CamPlan, CarUse, default_profile, plan_cam, plan_motion_cam
from cadgen.jobs.cam.cures import Cures, find_cures
from cadgen.jobs.cam.remedies import Remedy, remedies
from cadgen.jobs.gears.gear_train import GearTrain, plan_gears
from cadgen.jobs.simulation import Simulation, simulated
from cadgen.jobs.tolerance import CarSample, ToleranceRun, tolerance_of
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.jobs.calibration.calibration import CalibrationPlan
    from cadgen.jobs.calibration.sources import Source


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


@dataclass(frozen=True)
class PagePlan:
    """Results that a report shows.

    Attributes:
        cam: cam, compared under play on all trains if the design has play.
        cures: cures of lost lift.
        gears: gear train; None without one.
        simulation: runs with play; None for a design without play.
        remedies: further remedies against play; empty without [mechanics].
        tolerance: many cars; None where nothing varies.
        calibration: verdict on measured files; None without any.
        refusals: reasons for what is missing.
        scope: what is shown.
    """

    cam: CamPlan
    cures: Cures
    gears: GearTrain | None
    simulation: Simulation[CamPlan] | None
    remedies: tuple[Remedy, ...]
    tolerance: ToleranceRun[CamPlan] | None
    calibration: "CalibrationPlan | None"
    refusals: tuple[Refusal, ...]
    scope: Scope = Scope.REPORT

    @property
    def design(self) -> Design:
        """Design of the car of the report."""
        return self.cam.car.design

    @property
    def of_car(self) -> bool:
        """Whether the cam steers a car."""
        return isinstance(self.cam.application, CarUse)

    @property
    def checks(self) -> tuple[Check, ...]:
        """Checks of cam and gears."""
        return (*self.cam.checks, *(self.gears.checks if self.gears else ()))

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit, and nothing was refused that fails the design."""
        return all(check.passed for check in self.checks) and not any(refusal.fails for refusal in self.refusals)


def plan_page(
    design: Design,
    profile: str | None = None,
    samples: int = 10_000,
    processes: int = 1,
    sources: "tuple[Source, ...]" = (),
    progress: Progress = silent,
    *,
    unread: str = "",
) -> PagePlan:
    """Compute what a report shows; each plan is made once and serves every part.

    Args:
        design: loaded design.
        profile: code of a profile; the default of `plan_cam` if left out. If no profile keeps the limits of [optimize],
            the report is of the actual one, and says so first.
        samples: number of random cars.
        processes: number of processes that run at once; no number depends on it.
        sources: measured data.
        progress: function that is called with a few words on each step.
        unread: why the measured data cannot be read; empty if they can, or if there are none.

    Raises:
        DesignError: no cam can be computed.
    """
    refusals: list[Refusal] = []
    with_play = bool(variation.play_bands(design)) and cam_model.follower(design).leans

    def wanted() -> CamPlan:
        return plan_cam(design, profile, progress, all_trains=True, with_play=with_play)

    cam = _cam(design, wanted, refusals, progress)
    gears = _gears(design, plan_gears, refusals, progress)
    simulation, run = None, None
    further: tuple[Remedy, ...] = ()
    if cam.comparison is not None:
        progress("running the car")
        simulation = simulated(cam)
        if cam.comparison.task.mechanics is not None:
            further = tuple(remedies(design, cam.comparison, progress))
        try:
            run = tolerance_of(cam, CarSample(samples=samples, processes=processes), progress)
        except DesignError as error:
            refusals.append(Refusal(Topic.TOLERANCE, str(error)))
    calibration = None
    if sources:
        from cadgen.jobs.calibration.calibration import calibrate

        known = default_profile(design).code if profile is None else profile
        try:
            calibration = calibrate(design, _measured_profile(design, known), sources, None, progress)
        except (DesignError, FileError) as error:
            unread = str(error)
    if unread:
        refusals.append(Refusal(Topic.CALIBRATION, unread, fails=True))
    return PagePlan(cam, find_cures(cam, progress), gears, simulation, further, run, calibration, tuple(refusals))


def plan_motion_page(design: MotionDesign, profile: str | None = None, progress: Progress = silent) -> PagePlan:
    """Compute what a report of a cam by its motion shows.

    Args:
        design: loaded design with [motion].
        profile: code of a profile; the actual one if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: no cam can be computed.
    """
    refusals: list[Refusal] = []
    cam = plan_motion_cam(design, profile, progress)
    gears = _gears(design, plan_gears, refusals, progress)
    return PagePlan(cam, find_cures(cam, progress), gears, None, (), None, None, tuple(refusals))


def plan_edited(design: Design, make_gears: MakeGears, progress: Progress = silent) -> PagePlan:
    """Compute what is shown of a design while it is edited: what `cadgen check` computes, the gears and two runs.

    Args:
        design: loaded design.
        make_gears: function that plans its train, `plan_gears` or one that keeps results.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: no cam can be computed.
    """
    refusals: list[Refusal] = []
    cam = _cam(design, lambda: plan_cam(design, None, progress), refusals, progress)
    gears = _gears(design, make_gears, refusals, progress)
    progress("running the car")
    simulation = None if cam.comparison is None else simulated(cam)
    return PagePlan(cam, find_cures(cam, progress), gears, simulation, (), None, None, tuple(refusals), Scope.EDITED)


def plan_preview(design: Design, progress: Progress = silent) -> PagePlan:
    """Compute the actual cam of a design alone, unchecked, for a first look.

    Raises:
        DesignError: no cam can be computed.
    """
    cam = plan_cam(design, ACTUAL.code, progress, judged=False)
    return PagePlan(cam, Cures((), (), 0), None, None, (), None, None, (), Scope.PREVIEW)


def _cam(design: Design, make: Callable[[], CamPlan], refusals: list[Refusal], progress: Progress) -> CamPlan:
    """The cam, or the actual one with a refusal if no profile keeps the limits of [optimize]."""
    try:
        return make()
    except CheckError as error:
        refusals.append(Refusal(Topic.PROFILE, str(error), fails=True))
        return plan_cam(design, ACTUAL.code, progress)


def _gears(design: TrainDesign, make: MakeGears, refusals: list[Refusal], progress: Progress) -> GearTrain | None:
    """The train, or a refusal if it cannot be made; None without one."""
    if design.train is None:
        return None
    try:
        return make(design, Order.AS_GIVEN, progress)
    except DesignError as error:
        refusals.append(Refusal(Topic.GEARS, str(error), fails=True))
        return None


def _measured_profile(design: Design, known: str) -> str:
    """Profile of the cam that was measured: that of the design as built, else that of the report."""
    return known if design.as_built is None else design.as_built.profile
