"""From a design to a checked profile. No CAD kernel is needed for this."""

from dataclasses import dataclass, replace
from functools import cached_property

from cadgen.arrays import TURN
from cadgen.cam.checks import LOST_LIFT, check_cam
from cadgen.cam.follower import Follower, Trim
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.against_play.evaluate import evaluate
from cadgen.car.against_play.laps import Laps
from cadgen.car.against_play.play_task import TrainTask
from cadgen.car.against_play.profile_kinds import ACTUAL, OPTIMIZED, ProfileKind, codes, profile_of
from cadgen.car.course.layout import Side
from cadgen.car.path.track import Track
from cadgen.car.path_motion import PathMotion, blend_checks
from cadgen.car.running.drive import drive, start_pose
from cadgen.check import Check, failing
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.derived import turned
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.deviations.as_built import edges_check
from cadgen.errors import DesignError
from cadgen.jobs.cam.as_built import outlook_checks
from cadgen.jobs.cam.checking import ProfileChecks
from cadgen.jobs.cam.comparison import MeasuredCam, PlayComparison, known_trains, task_of
from cadgen.jobs.cam.course import OnCourse, on_course
from cadgen.jobs.cam.course_checks import course_checks
from cadgen.jobs.cam.mechanics import mechanics_checks
from cadgen.jobs.cam.play import against_play
from cadgen.jobs.cam.wheel import DriveWheel, drive_wheel
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent


@dataclass(frozen=True)
class CamPlan:
    """A cam that has been computed and checked, but not yet made.

    Attributes:
        design: design that the cam was planned from.
        profile: profile of the cam; as text, its code.
        track: track of the drive wheel.
        lift: lift that the profile is cut for: the planned lift, or a lift that gives the planned one with play.
        rod: follower of the design, as built.
        curve: curve that is cut: the profile, or on a car as built the curve that becomes the profile on its shaft, mm.
        trims: places where the envelope was trimmed.
        blank: features of the disc besides its profile.
        checks: every figure with its verdict.
        comparison: of the profile with the plain profile under play; None for a profile that is not for play.
        course: course of the design with the car that is to keep it; None without [course].
        laps: laps of a closed path; None of an open one.
    """

    design: Design
    profile: ProfileKind
    track: Track
    lift: PathMotion
    rod: Follower
    curve: ClosedCurve
    trims: tuple[Trim, ...]
    blank: Blank
    checks: tuple[Check, ...]
    comparison: PlayComparison | None = None
    course: OnCourse | None = None
    laps: Laps | None = None

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return not self.failed

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return failing(self.checks)

    @property
    def lost(self) -> tuple[Check, ...]:
        """Failed checks on lost lift."""
        return tuple(check for check in self.failed if check.code in LOST_LIFT)

    @cached_property
    def edges(self) -> Check | None:
        """Cost at the finish of edges broken more than designed, mm: a figure without a limit, computed when shown.

        None for a follower other than the leaning rod, which alone rides on an edge.
        """
        if not isinstance(self.follower, LeaningRod):
            return None
        as_built, travel = cam_model.as_built(self.design), cam_model.travel(self.design, self.track)
        return edges_check(self.lift, self.follower, self.curve, as_built, cam_model.car(self.design), travel)

    @cached_property
    def wheel(self) -> DriveWheel:
        """Drive wheel that the cam is for."""
        wanted = self.lift if self.comparison is None else self.comparison.task.lift
        return drive_wheel(self.design, self.track, wanted)

    @property
    def path_end(self) -> float:
        """Arc length of the track up to which the path steers, mm: there the closing blend begins, or the lap ends."""
        return cam_model.path_end(self.design, self.track)

    @property
    def figures(self) -> tuple[Check, ...]:
        """The checks, and what is shown beside them."""
        return self.checks if self.edges is None else (*self.checks, self.edges)

    @property
    def made_blank(self) -> Blank:
        """Features of the disc as files show it: from the car's left, which is the inner face of a cam on the right."""
        blank = self.blank
        if self.design.cam.side != Side.RIGHT or blank.hub is None:
            return blank
        return replace(blank, hub=replace(blank.hub, side=Face.INNER if blank.hub.side == Face.OUTER else Face.OUTER))

    @property
    def follower(self) -> Follower:
        """Follower that rolls on this profile: that of the design, or its reference point."""
        return _rolling(self.profile, self.rod)

    @cached_property
    def on_shaft(self) -> ClosedCurve:
        """Curve that is cut, mm, on a shaft whose key is right: turned with the key of a car as built."""
        phase = cam_model.as_built(self.design).phase
        return turned(self.curve, phase) if phase else self.curve

    @cached_property
    def area(self) -> float:
        """Area of the profile, mm^2."""
        return self.curve.area()


def default_profile(design: Design) -> ProfileKind:
    """The optimized profile for a design with [train] or [play], else the actual profile."""
    return OPTIMIZED if variation.play_bands(design) else ACTUAL


def plan_cam(
    design: Design,
    profile: str | None = None,
    progress: Progress = silent,
    *,
    all_trains: bool = False,
    with_play: bool = False,
    judged: bool = True,
) -> CamPlan:
    """Compute the profile of a design and check it.

    Args:
        design: loaded design.
        profile: code of a profile; that of `default_profile` if left out.
        progress: function that is called with a few words on each step.
        all_trains: whether profiles against play are compared on the trains that the design does not use, too.
        with_play: whether the actual profile is compared under play, too.
        judged: whether it is checked; one that is not for play may be looked at without.

    Raises:
        DesignError: the path cannot be driven, the rod leaves no disc, there is no such profile, or nothing is
            known of the play that the profile is for.
        CheckError: no profile keeps the limits of [optimize].
    """
    kind = default_profile(design) if profile is None else profile_of(profile)
    if kind.for_play or (with_play and kind is ACTUAL):
        return _plan_against_play(design, kind, progress, all_trains=all_trains, measured=_measured_cam(design))
    return _plan(design, kind, progress, judged=judged)


def _plan(design: Design, profile: ProfileKind, progress: Progress, *, judged: bool = True) -> CamPlan:
    """Plan of a profile that is not for play."""
    progress("planning the path")
    track = cam_model.track(design)
    lift, rod, blank = cam_model.lift(design, track), cam_model.follower(design), cam_model.blank(design)
    progress(f"computing the {profile} profile")
    wanted = profile.curve(lift, rod)
    cut = cam_model.as_built(design).precompensated(wanted.curve)
    if not judged:
        return CamPlan(design, profile, track, lift, rod, cut, wanted.trims, blank, ())
    progress("checking the profile")
    limits = cam_model.check_limits(design)
    course, laps = on_course(design, track, lift), _laps(design, track, lift)
    checks = (
        *check_cam(
            lift, _rolling(profile, rod), wanted.curve, wanted.trims, blank, limits, cut=cut, application=blend_checks
        ),
        *mechanics_checks(design, rod, lift, variation.mechanics(design, rod, lift)),
        *course_checks(course),
        *(laps.checks(None) if laps else ()),
        *outlook_checks(design),
    )
    return CamPlan(design, profile, track, lift, rod, cut, wanted.trims, blank, checks, course=course, laps=laps)


def _plan_against_play(
    design: Design,
    profile: ProfileKind,
    progress: Progress,
    *,
    all_trains: bool = False,
    measured: MeasuredCam | None = None,
) -> CamPlan:
    """Plan of a profile, with its comparison under play."""
    progress("planning the path")
    track = cam_model.track(design)
    lift, rod, blank = cam_model.lift(design, track), cam_model.follower(design), cam_model.blank(design)
    progress(f"computing the {profile} profile")
    checks = ProfileChecks(design, task_of(design, track, lift, rod))
    comparison = against_play(profile, checks, all_trains=all_trains, measured=measured, progress=progress)
    chosen = comparison.chosen
    progress("checking the profile")
    course, laps = on_course(design, track, lift), _laps(design, track, lift)
    return CamPlan(
        design,
        profile,
        track,
        chosen.lift,
        rod,
        chosen.cut,
        chosen.wanted.trims,
        blank,
        (
            *checks.of(chosen),
            *course_checks(course, comparison),
            *(laps.checks(chosen) if laps else ()),
            *outlook_checks(design),
        ),
        comparison,
        course,
        laps,
    )


def _measured_cam(design: Design) -> MeasuredCam | None:
    """Cam that was on the car when the car was measured, as made then; None if the design has no [as_built]."""
    if design.as_built is None:
        return None
    profile, then = profile_of(design.as_built.profile), design.as_cut().model_copy(update={"course": None})
    planned = _plan_against_play if profile.for_play else _plan
    plan = planned(then, profile, silent)
    return MeasuredCam(profile=profile, lift=plan.lift, curve=plan.on_shaft)


def replanned_checks(plan: CamPlan, design: Design) -> tuple[Check, ...]:
    """Checks of the plan's profile for a changed design; against play the method already chosen is kept.

    Raises:
        DesignError: as `plan_cam`.
    """
    if plan.comparison is None:
        return _plan(design, plan.profile, silent).checks
    chosen, track = plan.comparison.chosen, cam_model.track(design)
    task = task_of(design, track, cam_model.lift(design, track), cam_model.follower(design))
    work = TrainTask(task, chosen.train, known_trains(design)[chosen.train])
    return ProfileChecks(design, task).of(evaluate(work, chosen.profile))


def comparison_of(plan: CamPlan) -> PlayComparison:
    """Comparison of a plan's profile with the plain profile under play.

    Raises:
        DesignError: the profile is not for play.
    """
    if plan.comparison is None:
        choices = listed(codes(for_play=True), "or")
        raise DesignError(f'the profile "{plan.profile}" does nothing about play: choose {choices}')
    return plan.comparison


def _laps(design: Design, track: Track, lift: PathMotion) -> Laps | None:
    """The laps of a closed path; None of an open one."""
    if not track.closed:
        return None
    start, stop = track.heading(track.arc)[[0, -1]].tolist()
    return Laps(
        in_turn=track.turn_laps,
        in_run=design.path.run_laps,
        length=track.length,
        turned=TURN * round((stop - start) / TURN),
        planned=drive(lift, cam_model.car(design), cam_model.travel(design, track), start=start_pose(track)),
    )


def _rolling(profile: ProfileKind, rod: Follower) -> Follower:
    return rod.point() if profile.by_axis else rod
