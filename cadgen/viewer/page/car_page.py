"""The page of a car's cam: runs, random cars and calibration besides the cam and its gears, each computed once."""

from dataclasses import dataclass, replace
from math import degrees
from typing import TYPE_CHECKING

from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.check import CheckCode
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design
from cadgen.errors import DesignError, FileError
from cadgen.figures import Cell, Emphasis, Facts, number
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.car_facts import remedy_facts
from cadgen.jobs.cam.cures import Cures, find_cures
from cadgen.jobs.cam.lever import remedies_of
from cadgen.jobs.cam.remedies import Remedy
from cadgen.jobs.cam.steering_cam import CarUse, default_profile, plan_cam
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.jobs.simulation import Simulation, simulated
from cadgen.jobs.tolerance import CarSample, ToleranceRun, tolerance_of
from cadgen.messages import Message
from cadgen.progress import Progress, silent
from cadgen.viewer.page.charts import drift_chart, torque_chart
from cadgen.viewer.page.document import Chart, LiftMark, MarkKind, Scene, Section
from cadgen.viewer.page.page_plan import MakeGears, PagePlan, Refusal, Scope, Topic, gears_of
from cadgen.viewer.page.rim import rim_of
from cadgen.viewer.page.scene import scene_of
from cadgen.viewer.page.sections import (
    calibration_section,
    checks_section,
    parts_sections,
    play_section,
    tolerance_section,
)

if TYPE_CHECKING:
    from cadgen.jobs.calibration.calibration import CalibrationPlan
    from cadgen.jobs.calibration.sources import Source


@dataclass(frozen=True, kw_only=True)
class CarPage(PagePlan):
    """Results that the page of a car shows.

    Attributes:
        simulation: runs with play; None for a design without play.
        remedies: further remedies against play; empty without [mechanics].
        tolerance: many cars; None where nothing varies.
        calibration: verdict on measured files; None without any.
    """

    simulation: Simulation[CamPlan] | None = None
    remedies: tuple[Remedy, ...] = ()
    tolerance: ToleranceRun[CamPlan] | None = None
    calibration: "CalibrationPlan | None" = None

    @property
    def use(self) -> CarUse:
        """Car that the cam steers."""
        return CarUse.of(self.cam)

    def drawn(self) -> tuple[Scene, tuple[str, ...]]:
        """Scene of the page, and remarks on what is drawn otherwise than it will be built."""
        scene, notes = scene_of(self.cam, self.gears)
        if self.scope == Scope.REPORT:
            scene = replace(scene, rim=rim_of(self.cam, self.use.comparison, self.calibration))
        alone = Message("The design has no gear train: the cam is shown alone.")
        missing = () if self.use.has_train else (alone,)
        return scene, (*missing, self.use.drive_wheel.sentence(), *notes)

    def charts(self) -> tuple[Chart, ...]:
        """Curves of the cam, the way off the planned place, and the torque."""
        charts = list(super().charts())
        if self.simulation is not None:
            charts.append(drift_chart(self.simulation))
        comparison = self.use.comparison
        if comparison is not None and comparison.task.mechanics is not None:
            charts.append(torque_chart(comparison.task.mechanics, comparison.chosen.lift))
        return tuple(charts)

    def marks(self) -> tuple[LiftMark, ...]:
        """Marked places of the turn, the beginning of the closing blend among them."""
        steering = self.use.steering
        blend = [LiftMark(MarkKind.BLEND, steering.blend_start)] if steering.blended else []
        return tuple(sorted((*super().marks(), *blend), key=lambda mark: mark.angle))

    def sections(self) -> tuple[Section, ...]:
        """Tables of the page, those of play, random cars and measurements among them."""
        reasons, course = {refusal.part: refusal.reason for refusal in self.refusals}, self.use.layout
        without = Message("Without play there are no runs to vary: add [train] or [play] to the design.")
        if self.scope == Scope.EDITED:
            without = Message(
                "Random cars are left out while the design is edited: `cadgen tolerance` and `cadgen report` run them."
            )
        return (
            checks_section(self.cam, self.gears, Message("Cam") if course is None else Message("Cam and course")),
            play_section(self.use.comparison, self.simulation, self.remedies),
            tolerance_section(self.tolerance, reasons.get(Topic.TOLERANCE, without)),
            calibration_section(self.calibration, self.use.record, reasons.get(Topic.CALIBRATION, "")),
            *parts_sections(self.cam, self.gears),
        )

    def summary(self) -> tuple[tuple[str, Cell], ...]:
        """Figures at the top, those of the drive wheel last."""
        wheel = self.use.drive_wheel
        rows = [(Message("travel in a turn of the cam"), number(wheel.turn, "mm", digits=0))]
        if wheel.radius is not None:
            rows.append((Message("drive wheel radius"), number(wheel.radius, "mm")))
        return (*super().summary(), *rows)

    def results(self) -> tuple[tuple[str, Cell], ...]:
        """End of the run and return error with play, and the cars of the verdict that keep the course."""
        rows: list[tuple[str, Cell]] = []
        if self.simulation is not None:
            end = self.simulation.after_error.end_distance
            rows.append((Message("end of the run, with play"), number(end, "mm", digits=1)))
            rows.append((Message("return error"), number(degrees(self.simulation.play), "°")))
        # The cars of the verdict, which are the same in every command, and not those of the tolerance run.
        rows += [
            (check.name, number(check.value, check.unit, Emphasis.PLAIN if check.passed else Emphasis.BAD))
            for check in self.cam.verdict.checks
            if check.code == CheckCode.CARS_KEEP_COURSE
        ]
        if self.tolerance is not None and self.tolerance.sensitivities:
            dearest = self.tolerance.sensitivities[0]
            costs = Cell(dearest.name.replace("_", " "), unit=f"{100 * dearest.share:.0f} %")
            rows.append((Message("costs most of the scatter"), costs))
        return tuple(rows)

    def entry(self) -> Facts:
        """Runs, remedies, random cars and calibration."""
        calibration = None
        if self.calibration is not None:
            from cadgen.jobs.calibration.files import calibration_facts

            calibration = calibration_facts(self.calibration)
        return Facts(
            simulation=self.simulation and self.simulation.entry(),
            remedies=[remedy_facts(remedy) for remedy in self.remedies],
            tolerance=self.tolerance and self.tolerance.entry(),
            calibration=calibration,
        )


def plan_page(
    design: Design,
    profile: str | None = None,
    samples: int = 10_000,
    processes: int = 1,
    sources: "tuple[Source, ...]" = (),
    progress: Progress = silent,
    *,
    unread: str = "",
) -> CarPage:
    """Compute what a report shows; each plan is made once and serves every part.

    Args:
        design: loaded design.
        profile: code of a profile; the default of `plan_cam` if left out.
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

    cam = plan_cam(design, profile, progress, all_trains=True, with_play=with_play)
    gears = gears_of(design, plan_gears, refusals, progress)
    simulation, run = None, None
    further: tuple[Remedy, ...] = ()
    comparison = CarUse.of(cam).comparison
    if comparison is not None:
        progress("running the car")
        simulation = simulated(cam)
        if comparison.task.mechanics is not None:
            further = remedies_of(cam, progress)
        try:
            run = tolerance_of(cam, CarSample(samples=samples, processes=processes), progress)
        except DesignError as error:
            refusals.append(Refusal(Topic.TOLERANCE, error.message))
    calibration = None
    if sources:
        from cadgen.jobs.calibration.calibration import calibrate

        known = default_profile(design).code if profile is None else profile
        try:
            measured = known if design.as_built is None else design.as_built.profile
            calibration = calibrate(design, measured, sources, None, progress)
        except (DesignError, FileError) as error:
            unread = error.message
    if unread:
        refusals.append(Refusal(Topic.CALIBRATION, unread, fails=True))
    return CarPage(
        cam=cam,
        cures=find_cures(cam, progress),
        gears=gears,
        refusals=tuple(refusals),
        simulation=simulation,
        remedies=further,
        tolerance=run,
        calibration=calibration,
    )


def plan_edited(design: Design, make_gears: MakeGears, progress: Progress = silent) -> CarPage:
    """Compute what is shown of a design while it is edited: what `cadgen check` computes, the gears and two runs.

    Args:
        design: loaded design.
        make_gears: function that plans its train, `plan_gears` or one that keeps results.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: no cam can be computed.
    """
    refusals: list[Refusal] = []
    cam = plan_cam(design, None, progress)
    gears = gears_of(design, make_gears, refusals, progress)
    progress("running the car")
    simulation = None if CarUse.of(cam).comparison is None else simulated(cam)
    return CarPage(
        cam=cam,
        cures=find_cures(cam, progress),
        gears=gears,
        refusals=tuple(refusals),
        scope=Scope.EDITED,
        simulation=simulation,
    )


def plan_preview(design: Design, progress: Progress = silent) -> CarPage:
    """Compute the actual cam of a design alone, unchecked, for a first look.

    Raises:
        DesignError: no cam can be computed.
    """
    cam = plan_cam(design, ACTUAL.code, progress, judged=False)
    return CarPage(cam=cam, cures=Cures((), (), 0), gears=None, scope=Scope.PREVIEW)
