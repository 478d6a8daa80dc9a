"""From a design to a checked profile. No CAD kernel is needed for this."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

from cadgen.build import cam_model, variation
from cadgen.cam.checks import LOST_LIFT, check_cam
from cadgen.cam.envelope import Trim
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.check import Check, failing
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.turned import turned
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.errors import DesignError
from cadgen.optimize.evaluate import evaluate
from cadgen.optimize.profiles.actual import ACTUAL
from cadgen.optimize.profiles.optimized import OPTIMIZED
from cadgen.optimize.profiles.profile import Profile
from cadgen.optimize.profiles.table import codes, profile_of
from cadgen.optimize.task import TrainTask
from cadgen.parts.blank import Blank
from cadgen.path.track import Track
from cadgen.workflow.cam.against import Against, MeasuredCam, known_trains, task_of
from cadgen.workflow.cam.as_built import outlook_checks
from cadgen.workflow.cam.checking import ProfileChecks
from cadgen.workflow.cam.edges import edges_check
from cadgen.workflow.cam.mechanics import mechanics_checks
from cadgen.workflow.cam.play import against_play

Step = Callable[[str], None]


@dataclass(frozen=True)
class CamPlan:
    """A cam that has been computed and checked, but not yet made.

    Attributes:
        design: what it was planned from.
        profile: which one; its text is its code.
        track: of the drive wheel.
        lift: the steering that the profile is cut for: the planned one, or what becomes that one with play.
        rod: the follower of the design, as built.
        curve: what is cut: the profile, or on a car as built what becomes the profile in its making and on its shaft.
        trims: where the envelope was trimmed.
        blank: what the disc has besides its profile.
        checks: every figure with its verdict.
        against: what the profile does about play, if that is what it is for.
    """

    design: Design
    profile: Profile
    track: Track
    lift: LiftCurve
    rod: Follower
    curve: ClosedCurve
    trims: tuple[Trim, ...]
    blank: Blank
    checks: tuple[Check, ...]
    against: Against | None = None

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return not self.failed

    @property
    def failed(self) -> tuple[Check, ...]:
        """The checks that do not keep their limit."""
        return failing(self.checks)

    @property
    def lost(self) -> tuple[Check, ...]:
        """The checks by which too much lift is lost."""
        return tuple(check for check in self.failed if check.code in LOST_LIFT)

    @cached_property
    def edges(self) -> Check:
        """What edges broken more than designed cost at the finish: a figure without a limit, taken if it is shown."""
        as_built, travel = cam_model.as_built(self.design), cam_model.travel(self.design, self.track)
        return edges_check(self.lift, self.follower, self.curve, as_built, cam_model.car(self.design), travel)

    @property
    def path_end(self) -> float:
        """Arc length of the track up to which the path steers, mm: there the closing blend begins."""
        return cam_model.path_end(self.design, self.track)

    @property
    def follower(self) -> Follower:
        """What rolls on this profile: the rod, or its axis."""
        return _rolling(self.profile, self.rod)

    @cached_property
    def on_shaft(self) -> ClosedCurve:
        """What is cut, as it stands on a shaft whose key is right: turned with the key of a car as built."""
        phase = cam_model.as_built(self.design).phase
        return turned(self.curve, phase) if phase else self.curve

    @cached_property
    def area(self) -> float:
        """Of the profile, mm^2."""
        return self.curve.area()


def default_profile(design: Design) -> Profile:
    """The best against play for a design that says something of its play, else the actual profile."""
    return OPTIMIZED if variation.play_bands(design) else ACTUAL


def plan_cam(
    design: Design,
    profile: str | None = None,
    step: Step = lambda text: None,
    *,
    all_trains: bool = False,
    with_play: bool = False,
) -> CamPlan:
    """Compute the profile of a design and check it.

    Args:
        design: a loaded design.
        profile: code of a profile; that of `default_profile` if left out.
        step: told what is being done.
        all_trains: against play, compare the profiles on the trains that the design does not use, too.
        with_play: look at what play does to the actual profile, too.

    Raises:
        DesignError: the path cannot be driven, the rod leaves no disc, there is no such profile, or nothing is
            known of the play that it is for.
        CheckError: no profile keeps the limits of [optimize].
    """
    kind = default_profile(design) if profile is None else profile_of(profile)
    if kind.for_play or (with_play and kind is ACTUAL):
        return _plan_against_play(design, kind, step, all_trains=all_trains, measured=_measured_cam(design))
    return _plan(design, kind, step)


def _plan(design: Design, profile: Profile, step: Step) -> CamPlan:
    """The plan of a profile that does nothing about play."""
    step("planning the path")
    track = cam_model.track(design)
    lift, rod, blank = cam_model.lift(design, track), cam_model.follower(design), cam_model.blank(design)
    step(f"computing the {profile} profile")
    wanted = profile.curve(lift, rod)
    step("checking the profile")
    cut = cam_model.as_built(design).precompensated(wanted.curve)
    limits = cam_model.check_limits(design)
    checks = (
        *check_cam(lift, _rolling(profile, rod), wanted.curve, wanted.trims, blank, limits, cut=cut),
        *mechanics_checks(design, rod, lift, variation.mechanics(design, rod, lift)),
        *outlook_checks(design),
    )
    return CamPlan(design, profile, track, lift, rod, cut, wanted.trims, blank, checks)


def _plan_against_play(
    design: Design, profile: Profile, step: Step, *, all_trains: bool = False, measured: MeasuredCam | None = None
) -> CamPlan:
    """The plan of a profile, with what it does about play."""
    step("planning the path")
    track = cam_model.track(design)
    lift, rod, blank = cam_model.lift(design, track), cam_model.follower(design), cam_model.blank(design)
    step(f"computing the {profile} profile")
    checks = ProfileChecks(design, task_of(design, track, lift, rod))
    against = against_play(profile, checks, all_trains=all_trains, measured=measured)
    chosen = against.chosen
    step("checking the profile")
    return CamPlan(
        design,
        profile,
        track,
        chosen.lift,
        rod,
        chosen.cut,
        chosen.wanted.trims,
        blank,
        (*checks.of(chosen), *outlook_checks(design)),
        against,
    )


def _measured_cam(design: Design) -> MeasuredCam | None:
    """The cam that was on the car when it was measured, as it was made then; None if the design has no [as_built]."""
    if design.as_built is None:
        return None
    profile, then = profile_of(design.as_built.profile), design.as_cut()
    planned = _plan_against_play if profile.for_play else _plan
    plan = planned(then, profile, lambda text: None)
    return MeasuredCam(profile=profile, lift=plan.lift, curve=plan.on_shaft)


def replanned_checks(plan: CamPlan, design: Design) -> tuple[Check, ...]:
    """Checks of the plan's profile for a changed design; against play the method already chosen is kept.

    Raises:
        DesignError: as `plan_cam`.
    """
    if plan.against is None:
        return _plan(design, plan.profile, lambda text: None).checks
    chosen, track = plan.against.chosen, cam_model.track(design)
    task = task_of(design, track, cam_model.lift(design, track), cam_model.follower(design))
    work = TrainTask(task, chosen.train, known_trains(design)[chosen.train])
    return ProfileChecks(design, task).of(evaluate(work, chosen.profile))


def against_of(plan: CamPlan) -> Against:
    """What a plan's profile does about play.

    Raises:
        DesignError: it is not for that.
    """
    if plan.against is None:
        choices = listed(codes(for_play=True), "or")
        raise DesignError(f'the profile "{plan.profile}" does nothing about play: choose {choices}')
    return plan.against


def _rolling(profile: Profile, rod: Follower) -> Follower:
    return replace(rod, radius=0.0) if profile.by_axis else rod
