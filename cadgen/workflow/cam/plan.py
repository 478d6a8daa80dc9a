"""From a design to a checked profile. No CAD kernel is needed for this."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import ceil, degrees, floor, isfinite, log10
from typing import Any

from cadgen.build import cam_model, variation
from cadgen.cam.checks import LOST_LIFT, check_cam
from cadgen.cam.cure import undercut_cures
from cadgen.cam.envelope import Trim, actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.cam.theoretical import published_profile, theoretical_profile
from cadgen.check import Check
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.turned import turned
from cadgen.design.load import with_overrides
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.errors import CadgenError, DesignError
from cadgen.optimize.judge import Judged, Task, judge
from cadgen.parts.blank import Blank
from cadgen.path.track import Track
from cadgen.workflow.cam.as_built import as_built_facts
from cadgen.workflow.cam.edges import edges_check
from cadgen.workflow.cam.mechanics import mechanics_checks
from cadgen.workflow.cam.play import (
    PLAY_PROFILES,
    Against,
    MeasuredCam,
    against_play,
    known_trains,
    lift_check,
    task_of,
)

Step = Callable[[str], None]


# Each cure is proved by planning the cam again, some thirty times in all. With more kinks than this, which each take a
# hundredth of a second a plan, no cures are sought.
MOST_KINKS_CURED = 300
# Lengthening the closing blend is tried by these factors, and limits are rounded up to a tenth of a micrometre.
_BLEND_FACTORS = (1.5, 2.0, 3.0, 5.0, 8.0)


@dataclass(frozen=True)
class Cure:
    """One change of the design after which no more lift is lost than allowed.

    Attributes:
        override: as for `--set`.
        now: what the key says now.
        failing: names of the checks that fail with the change.
    """

    override: str
    now: str
    failing: tuple[str, ...]


@dataclass(frozen=True)
class CamPlan:
    """A cam that has been computed and checked, but not yet made.

    Attributes:
        design: what it was planned from.
        profile: `actual`, `theoretical`, `published` or one of `PLAY_PROFILES`.
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
    profile: str
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
        return _failed(self.checks)

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
        """What rolls on this profile: the rod, or its axis on the theoretical profile."""
        return replace(self.rod, radius=0.0) if self.profile == "theoretical" else self.rod

    @cached_property
    def on_shaft(self) -> ClosedCurve:
        """What is cut, as it stands on a shaft whose key is right: turned with the key of a car as built."""
        phase = cam_model.as_built(self.design).phase
        return turned(self.curve, phase) if phase else self.curve

    @cached_property
    def area(self) -> float:
        """Of the profile, mm^2."""
        return self.curve.area()

    @cached_property
    def lost(self) -> tuple[Check, ...]:
        """The checks by which too much lift is lost."""
        return _lost(self.failed)

    @cached_property
    def cures(self) -> tuple["Cure", ...]:
        """Changes of one key that bring lost lift within its limit, each proved by planning the cam again."""
        return tuple(_cures(self)) if self.lost and self.cures_sought else ()

    @property
    def cures_sought(self) -> bool:
        """Whether the lift has so few kinks that cures of lost lift are sought."""
        return len(self.lift.kinks) <= MOST_KINKS_CURED

    def find_cures(self, step: Step) -> None:
        """Look for `cures` now, which takes many plans, and tell of it."""
        if self.lost and self.cures_sought:
            step("looking for a change that cures lost lift")
            len(self.cures)

    def cure_sentences(self) -> list[str]:
        """What would cure lost lift, in words."""
        lines = []
        for cure in self.cures:
            change = f"--set {cure.override} (now {cure.now}) "
            lines.append(
                change + ("cures it." if not cure.failing else f"ends that, but fails {listed(cure.failing, 'and')}.")
            )
        if self.lost and not self.cures_sought:
            lines.append(
                f"What would cure it was not sought, for the lift has {len(self.lift.kinks)} kinks and it is for up to "
                f'{MOST_KINKS_CURED}: set path.spline = "quintic", which has none, or keep fewer waypoints.'
            )
        elif self.lost and not lines:
            lines.append("No change of one key cures it: the path itself must become milder.")
        return lines

    def facts(self) -> dict[str, Any]:
        """The plan as plain values for the manifest and for machines."""
        peaks, valleys = self.lift.extrema()
        start = self.lift.blend_start
        return {
            "design": self.design.name,
            "source": self.design.source,
            "overrides": list(self.design.overrides),
            "design_sha256": self.design.content_hash,
            "profile": self.profile,
            "passed": self.passed,
            "checks": [
                {
                    "code": check.code,
                    "name": check.name,
                    "value": _plain(check.value),
                    "unit": check.unit,
                    "bound": check.bound,
                    "limit": _plain(check.limit),
                    "place": check.place,
                    "passed": check.passed,
                    "advice": "" if check.passed else check.advice,
                }
                for check in (*self.checks, self.edges)
            ],
            "cures": [{"override": c.override, "now": c.now, "then_fails": list(c.failing)} for c in self.cures],
            "edge_break_mm": self.blank.edge_break,
            "carrying_planes_mm": [self.rod.inner, self.rod.outer],
            "lift_extrema": [
                {
                    "kind": kind,
                    "cam_angle_deg": degrees(angle),
                    "lift_mm": float(self.rod.lift(self.lift.tan_beta(angle))),
                }
                for kind, angles in (("peak", peaks), ("valley", valleys))
                for angle in angles
            ],
            "track_length_mm": self.track.length,
            "blend": {
                "from_cam_angle_deg": degrees(start),
                "from_track_mm": self.path_end,
                "where": self.track.where(self.path_end),
            },
            "profile_area_mm2": self.area,
            "play": None if self.against is None else self.against.facts(),
            "as_built": as_built_facts(self.design, start),
        }


def default_profile(design: Design) -> str:
    """`optimized` for a design that says something of its play, else `actual`."""
    return "optimized" if variation.play_bands(design) else "actual"


def plan_cam(
    design: Design,
    profile: str | None = None,
    step: Step = lambda text: None,
    *,
    all_trains: bool = False,
    with_play: bool = False,
    with_measured: bool = True,
) -> CamPlan:
    """Compute the profile of a design and check it.

    Args:
        design: a loaded design.
        profile: `actual` (the exact envelope), `theoretical` (the rod's axis), `published` (the appendix's
            formula), or one of `PLAY_PROFILES`; `default_profile` if left out.
        step: told what is being done.
        all_trains: against play, compare the methods on the trains that the design does not use, too.
        with_play: look at what play does to the actual profile, too.
        with_measured: compare with the cam that was measured, if the design has [as_built].

    Raises:
        DesignError: the path cannot be driven, the rod leaves no disc, there is no such profile, or nothing is
            known of the play that it is for.
        CheckError: no profile keeps the limits of [optimize].
    """
    profile = profile or default_profile(design)
    step("planning the path")
    track = cam_model.track(design)
    lift = cam_model.lift(design, track)
    rod = cam_model.follower(design)
    as_built = cam_model.as_built(design)
    blank = cam_model.blank(design)
    limits = cam_model.check_limits(design)
    step(f"computing the {profile} profile")
    trims: tuple[Trim, ...] = ()
    if profile in PLAY_PROFILES or (with_play and profile == "actual"):
        known: dict[str, tuple[Check, ...]] = {}

        def check(one: Judged) -> tuple[Check, ...]:
            if one.name not in known:
                known[one.name] = _judged_checks(task, design, one)
            return known[one.name]

        measured = measured_cam(design) if with_measured else None
        task = task_of(design, track, lift, rod)
        against = against_play(design, profile, task, check, all_trains=all_trains, measured=measured)
        best = against.chosen
        step("checking the profile")
        return CamPlan(design, profile, track, best.lift, rod, best.made, best.cut.trims, blank, check(best), against)
    follower = rod
    match profile:
        case "actual":
            envelope = actual_profile(lift, rod)
            curve, trims = envelope.curve, envelope.trims
        case "theoretical":
            curve, follower = theoretical_profile(lift, rod), replace(rod, radius=0.0)
        case "published":
            curve = published_profile(lift, rod)
        case _:
            names = ", ".join(("actual", "theoretical", "published", *PLAY_PROFILES))
            raise DesignError(f'there is no profile "{profile}": choose one of {names}')
    step("checking the profile")
    made = as_built.precompensated(curve)
    checks = check_cam(lift, follower, curve, trims, blank, limits, cut=made)
    checks = (*checks, *mechanics_checks(design, rod, lift, variation.mechanics(design, rod, lift)))
    return CamPlan(design, profile, track, lift, rod, made, trims, blank, checks)


def measured_cam(design: Design) -> MeasuredCam | None:
    """The cam that was on the car when it was measured, as it was made then.

    None if the design has no [as_built].

    Raises:
        DesignError, CheckError: as `plan_cam`.
    """
    if design.as_built is None:
        return None
    plan = plan_cam(design.as_cut(), design.as_built.profile)
    return MeasuredCam(profile=plan.profile, lift=plan.lift, curve=plan.on_shaft)


def _cures(plan: CamPlan) -> Iterator[Cure]:
    """Try one key at a time: the spline, the blend, the rod, the base circle, and at last the limit itself."""
    design = plan.design
    if design.path.spline == "cubic":
        yield from _proved(plan, 'path.spline="quintic"', "cubic")
    now = design.cam.blend_deg
    in_blend = any(trim.after >= plan.lift.blend_start for trim in plan.trims)
    for factor in _BLEND_FACTORS if in_blend else ():
        if proved := _proved(plan, f"cam.blend_deg={now * factor:g}", f"{now:g}"):
            yield from proved
            break
    for change in undercut_cures(plan.lift, plan.rod, design.checks.lost_lift_limit_um * 1e-3):
        # Three digits, rounded to the safe side.
        unit = 10.0 ** (floor(log10(change.value)) - 2)
        safe = (ceil if change.value > change.now else floor)(change.value / unit) * unit
        yield from _proved(plan, f"{change.parameter}={safe:.4g}", f"{change.now:g}")
    allowed = ceil(max(check.value for check in plan.lost) * 10) / 10
    yield from _proved(plan, f"checks.lost_lift_limit_um={allowed:g}", f"{design.checks.lost_lift_limit_um:g}")


def _proved(plan: CamPlan, override: str, now: str) -> list[Cure]:
    """The change, if it is a design and no more lift than allowed is lost with it."""
    try:
        design = with_overrides(plan.design, [override])
        if plan.against:
            # The method that was chosen, without those that it was compared with.
            chosen = plan.against.chosen
            track = cam_model.track(design)
            task = task_of(design, track, cam_model.lift(design, track), cam_model.follower(design))
            (again,) = judge(task, chosen.train, known_trains(design)[chosen.train], (chosen.profile,))
            failed = _failed(_judged_checks(task, design, again))
        else:
            failed = plan_cam(design, plan.profile).failed
    except CadgenError:
        return []
    return [] if _lost(failed) else [Cure(override, now, tuple(check.name for check in failed))]


def _judged_checks(task: Task, design: Design, one: Judged) -> tuple[Check, ...]:
    """The checks of a profile that has been judged against play."""
    rod, blank, limits = cam_model.follower(design), cam_model.blank(design), cam_model.check_limits(design)
    found = check_cam(one.lift, rod, one.cut.curve, one.cut.trims, blank, limits, cut=one.made)
    return *found, lift_check(design, one), *mechanics_checks(design, rod, one.lift, task.mechanics)


def _failed(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    return tuple(check for check in checks if not check.passed)


def _lost(failed: tuple[Check, ...]) -> tuple[Check, ...]:
    return tuple(check for check in failed if check.code in LOST_LIFT)


def against_of(plan: CamPlan) -> Against:
    """What a plan's profile does about play.

    Raises:
        DesignError: it is not for that.
    """
    if plan.against is None:
        raise DesignError(f'the profile "{plan.profile}" does nothing about play: choose {listed(PLAY_PROFILES, "or")}')
    return plan.against


def _plain(value: float) -> float | None:
    return value if isfinite(value) else None
