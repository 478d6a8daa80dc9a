"""A cam by its motion: its use, its plan and its checks."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum, StrEnum
from functools import reduce
from math import ceil, degrees, floor, radians
from typing import Any

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.checks import LOST_LIFT, cam_angles, check_cam, polar_place, signed_pressure
from cadgen.cam.derived_motions import OppositeMotion
from cadgen.cam.follower import Follower
from cadgen.cam.followers.groove import GrooveRollers, groove_checks
from cadgen.cam.forces import CamForces
from cadgen.cam.formulas import FORMULAS
from cadgen.cam.round_follower import RoundFollower
from cadgen.car.against_play.profile_kinds import ACTUAL, ProfileKind, profile_of
from cadgen.check import Check, CheckCode, failing
from cadgen.design import cam_model
from cadgen.design.load import with_overrides
from cadgen.design.schema import MotionDesign
from cadgen.design.sources.source import DiscSense
from cadgen.errors import CadgenError, DesignError
from cadgen.figures import Facts, Sheet
from cadgen.jobs.cam.cam_plan import Application, CamPlan, Groove, Making
from cadgen.jobs.cam.force_figures import force_checks, force_facts, force_figures, forces_of
from cadgen.jobs.cam.motion_figures import checks_of, facts_of, notes_of, reservations_of, seams_sheets, small_height
from cadgen.laws.lift_table import TableMotion
from cadgen.laws.motion import Motion
from cadgen.laws.segments import (
    SegmentMotion,
    polynomial_changes,
    polynomial_overrides,
    polynomials,
)
from cadgen.laws.unit import MM, TAN
from cadgen.messages import Message, clauses, joined
from cadgen.output.files.manifest import Origin
from cadgen.parts.blank import PROFILE_STEP
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict, Reservation

SECOND = "second"  # in the names of the files of the second disc
SecondDisc = StrEnum("SecondDisc", {code.name: f"second-{code}" for code in CheckCode})  # type: ignore[misc]
OUTER = "outer"  # in the names of the files of a groove's outer flank
OuterFlank = StrEnum("OuterFlank", {code.name: f"outer-{code}" for code in CheckCode})  # type: ignore[misc]
_OF_OUTER_FLANK = (*LOST_LIFT, CheckCode.PUSHED_OUT, CheckCode.FALLS_SHORT, *FORMULAS)
_BEYOND_GROOVE = 5.0  # mm that are left beyond a groove besides the least wall, where the design does not say
# Checks that a size of the follower may cure.
_SIZED = (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN, CheckCode.CONVEX_RADIUS_PROFILE)
_EDGE = radians(0.1)  # of the outline's direction; a smaller turn is no edge that is felt
_WALLS = (CheckCode.THINNEST_WALL, SecondDisc(f"second-{CheckCode.THINNEST_WALL}"))
SMOOTHED = "motion.smooth=true"
# In degrees or percent, by which a size is raised in turn.
_STEPS = (3, 6, 10, 15, 20, 27, 35, 45, 60, 80, 110, 200, 350, 600, 1000, 1800)
_DENSE = 7201  # stations at which the travel is sought


@dataclass(frozen=True)
class MotionUse(Application):
    """Application of a cam by its motion, of which a design says the sense and the speed.

    Attributes:
        design: design with [motion].
    """

    design: MotionDesign

    @property
    def profile_tolerance(self) -> float | None:
        """Tolerance of the outline along its normal, mm."""
        stated = self.design.lift_tolerances
        return stated.base_circle_um / 1000 if stated and stated.base_circle_um else None

    def open_keys(self) -> dict[str, tuple[str, object]]:
        """Tolerance of the outline."""
        found: dict[str, tuple[str, object]] = {
            "tolerance of the outline": ("lift_tolerances.base_circle_um", self.profile_tolerance)
        }
        if self._second is not None:
            found[Message("distance of the discs")] = ("follower.second.gap_mm", self.disc_gap)
        return found

    @property
    def _second(self) -> Any:
        """Keys of the second roller; None without one."""
        return getattr(self.design.follower.keys, "second", None)

    @property
    def disc_gap(self) -> float | None:
        """Distance of the facing sides of both discs of a conjugate pair, mm."""
        return None if self._second is None else self._second.gap_mm

    @property
    def base_radius(self) -> float:
        """Radius of the base circle, mm."""
        return self.design.seat.base_radius

    @property
    def turns(self) -> DiscSense:
        """Sense in which the disc turns, seen on its outer face."""
        return self.design.motion.turns

    @property
    def seen(self) -> Face:
        """Face on which the disc turns clockwise."""
        return Face.OUTER if self.turns == DiscSense.CLOCKWISE else Face.INNER

    @property
    def rpm(self) -> float | None:
        """Speed of the camshaft, rev/min; None where the design does not say."""
        return self.design.motion.speed_rpm

    def replanned(self, cam: CamPlan, override: str) -> tuple[Check, ...]:
        """Checks of the same cam with a change of its design."""
        return plan_motion_cam(with_overrides(self.design, [override]), cam.kind.code).checks

    def curable(self, cam: CamPlan) -> tuple[Check, ...]:
        """Failed checks on lost lift, and on what the follower has a size against."""
        rough = isinstance(cam.motion, TableMotion) and cam.motion.rough
        sized = _SIZED if rough or cam.follower_as_built.sizes(cam.motion, cam.limits) else ()
        return (*cam.lost, *(check for check in failing(cam.checks) if check.code in sized))

    def changes(self, cam: CamPlan) -> Iterator[Sequence[tuple[str, str]]]:
        """Smoothing of a noisy table, and sizes of the follower that keep the limits."""
        if isinstance(cam.motion, TableMotion) and cam.motion.rough:
            yield [(SMOOTHED, "false")]
        found = self.design.cam.base_circle_radius_mm is None
        for size in cam.follower_as_built.sizes(cam.motion, cam.limits):
            if not (found and size.key == cam.follower_as_built.base_key):
                yield [(f"{size.key}={size.value:.10g}", f"{size.now:g}")]

    def forces(self, cam: CamPlan) -> CamForces | None:
        """Forces on the follower and its camshaft; None without [dynamics], and of a second disc or an outer flank.

        Args:
            cam: cam that was computed.
        """
        return None if cam.part else forces_of(self.design, cam.motion, cam.follower_as_built)

    def figures(self, cam: CamPlan) -> tuple[Check, ...]:
        """Greatest velocity, acceleration and jerk of the follower, and its forces."""
        forces = self.forces(cam)
        return (*checks_of(cam.motion, self.rpm), *(force_figures(forces) if forces else ()))

    def sheets(self, cam: CamPlan) -> tuple[Sheet, ...]:
        """Seams of the motion."""
        return seams_sheets(cam.motion)

    def entry(self, cam: CamPlan) -> Facts:
        """Sense, speed, source and peaks of the motion, and its seams."""
        motion = Facts(
            unit=cam.motion.unit.symbol,
            turns=self.turns.value,
            speed_rpm=self.rpm,
            source=self.design.motion.shaping_key,
        )
        forces, made = self.forces(cam), Facts(motion=motion | facts_of(cam.motion, self.rpm))
        return made if forces is None else made | Facts(forces=force_facts(forces))

    def purpose(self, cam: CamPlan) -> str:
        """Travel of the follower in a turn, and the speed."""
        q, follower = cam.motion.q(np.linspace(0.0, TURN, _DENSE)), Message(cam.follower.noun)
        if cam.motion.unit == MM:
            said = Message("a {follower} that moves {travel:.4g} mm", follower=follower, travel=float(np.ptp(q)))
        else:
            angle = np.arctan(q) if cam.motion.unit == TAN else q
            said = Message("a {follower} that swings {swing:.4g}°", follower=follower, swing=degrees(np.ptp(angle)))
        return said if self.rpm is None else clauses(said, Message("at {speed:g} rev/min", speed=self.rpm))

    def verdict(self, cam: CamPlan) -> PartVerdict:
        """Verdict on the cam and the forces on it, with reservations on its motion."""
        forces = self.forces(cam)
        checks = (*cam.checks, *(force_checks(forces) if forces else ()))
        if float(np.ptp(cam.motion.q(np.linspace(0.0, TURN, _DENSE)))) <= cam.motion.unit.level:
            still = Reservation(
                "no-motion",
                Message("the follower stands still through the whole turn"),
                Message("give {key} a rise and a return", key=self.design.motion.shaping_key),
            )
            return PartVerdict(checks, (still,))
        held = [
            *reservations_of(
                cam.motion,
                self.design,
                lambda overrides: _leaves_a_cam(self.design, overrides, cam.kind.code),
            ),
            *_edges(cam),
        ]
        if forces is not None and self.rpm is None and (forces.dynamics.inertia or forces.dynamics.damping):
            held.append(
                Reservation(
                    "speed-unknown",
                    Message("the forces are those of a standing cam, for the design has [dynamics] and no speed"),
                    Message("give motion.speed_rpm"),
                )
            )
        return PartVerdict(checks, tuple(held))

    def setting(self, cam: CamPlan) -> tuple[str, ...]:
        """Sense of a groove in the inner face, and the keys of one that turns the other way, seen on it.

        The path of the centre, (R + q(t) + ie) exp(it), is mirrored by the motion q(-t) and the offset -e.
        """
        if self.turns == DiscSense.CLOCKWISE or cam.groove is None:
            return ()
        return (
            Message(
                "The groove is in the inner face, seen on which the disc turns clockwise. If the face with the groove "
                'is to turn counterclockwise, state turns = "clockwise" and the motion in the reverse order, with '
                "offset_mm of the other sign, or lifts the other way."
            ),
        )

    def notes(self, cam: CamPlan) -> tuple[str, ...]:
        """Sense of the disc, peaks of the motion, and what was done to its table."""
        sense = Message(
            "The disc turns {turns}, seen on its outer face; files show its {seen} face, on which it turns clockwise.",
            turns=Message(self.turns.value),
            seen=Message(self.seen.value),
        )
        second = (
            ()
            if cam.second is None
            else (
                Message(
                    "The second disc ({stem}) stands beside the first on the same shaft: key and angle 0 are the same "
                    "in the files of both.",
                    stem=cam.second.stem,
                ),
            )
        )
        groove = () if cam.groove is None else (_groove_words(cam, cam.groove),)
        asked = self.design.cam.pressure_angle_deg
        least = (
            ()
            if asked is None
            else (
                Message(
                    "Base circle: radius {radius:.4g} mm, the least with a pressure angle of {angle:g}°.",
                    radius=self.design.seat.base_radius,
                    angle=asked,
                ),
            )
        )
        return sense, *least, *second, *groove, *notes_of(cam.motion, self.rpm)

    def timing(self, cam: CamPlan) -> Motion:
        """Motion of the follower, which is the opposite of that of a second disc.

        Args:
            cam: cam that was computed.
        """
        motion = cam.motion
        return motion.first if isinstance(motion, OppositeMotion) and motion.first is not None else motion

    def drawing_notes(self, cam: CamPlan) -> tuple[str, ...]:
        """How a groove is milled, how a second disc stands, and whose angles the sheet has."""
        turns = self.design.motion.machine_turns
        machine = (
            ()
            if turns is None
            else (Message("Angles are the cam's; the machine turns {turns:g} times as far.", turns=turns),)
        )
        if cam.part:
            return Message("Second disc of a conjugate pair: key and angle 0 stand as on the first."), *machine
        if cam.groove is None:
            return machine
        cutter = Message(
            "A cutter of {width:g} mm mills it in one round, a smaller one along either flank; the program is for "
            "{cutter:g} mm.",
            width=2 * cam.follower_as_built.radius,
            cutter=cam.making.machining.cutter_diameter_mm,
        )
        return cutter, *machine


def _edges(cam: CamPlan) -> tuple[Reservation, ...]:
    """Reservation on the edges of a disc, where its outline has an outer corner; none without."""
    edges = [corner for corner in cam.curve.corners(_EDGE) if corner.turn > 0]
    if not edges:
        return ()
    sharpest = max(edges, key=lambda corner: corner.turn)
    return (
        Reservation(
            "sharp-edge",
            Message(
                "the disc has an edge of {turn:.3g}° at {place} ({count} in all), which wears",
                turn=degrees(sharpest.turn),
                place=polar_place(sharpest.point),
                count=len(edges),
            ),
            Message("end the undercut, or the jump of the velocity, that makes it"),
        ),
    )


def plan_motion_cam(design: MotionDesign, profile: str | None = None, progress: Progress = silent) -> CamPlan:
    """Compute the profile of a cam by its motion and check it.

    Args:
        design: loaded design with [motion].
        profile: code of a profile that needs no car; the actual one if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the follower leaves no disc, or there is no such profile for a cam without a car.
    """
    try:
        made = _planned(design, profile, progress)
    except DesignError as error:
        motion = cam_model.source_of(design).motion(design)
        if not (isinstance(motion, TableMotion) and motion.rough):
            key = error.message.arguments.get("base_key")
            tried = _size_that_fits(design, profile, key) if isinstance(key, str) else None
            if tried is None:
                raise
            raise DesignError(
                "{refusal} ({key} = {size:g} was tried, and every check passes)"
                if tried[1]
                else "{refusal} ({key} = {size:g} was tried, and leaves a disc)",
                refusal=error.message,
                key=key,
                size=tried[0],
            ) from None
        try:
            _planned(with_overrides(design, [SMOOTHED]), profile, progress)
        except CadgenError:
            raise error from None
    else:
        broken = _broken_wall(made)
        if broken is None:
            return made
        raise _cut_away(design, broken)
    noise, unit = small_height(motion.noise, motion.unit)
    raise DesignError(
        "no disc leads a {follower} through the rows of {key} as they are, for they have {noise:.2g} {unit} of noise "
        "by their fourth differences: set motion.smooth to true, with which it was tried",
        follower=Message(design.follower.registered.follower(design.follower.keys, design.seat).noun),
        key=design.motion.shaping_key,
        noise=noise,
        unit=unit,
    )


def _leaves_a_cam(design: MotionDesign, overrides: Sequence[str], profile: str) -> bool:
    """Whether a design with changed keys is not refused, its follower and its disc included.

    Args:
        design: design that is changed.
        overrides: changed keys, as `key=value`.
        profile: code of the profile.
    """
    try:
        return _broken_wall(_planned(with_overrides(design, overrides), profile, silent)) is None
    except CadgenError:
        return False


def _size_that_fits(design: MotionDesign, profile: str | None, key: str) -> tuple[float, bool] | None:
    """Larger value of a key with which a disc is left, to a tenth, and whether every check passes; None if none was.

    Args:
        design: design that is refused.
        profile: code of the profile.
        key: key of a length in mm, or of an angle in degrees.
    """
    section, *names = key.split(".")
    now = reduce(getattr, names, design.follower.keys if section == "follower" else getattr(design, section))
    if now is None:
        return None
    larger = [now + step for step in _STEPS] if key.endswith("_deg") else [now * (1 + step / 100) for step in _STEPS]
    sizes = [ceil(10 * value) / 10 for value in larger]
    fits = [(_fit(design, f"{key}={value:.10g}"), value) for value in sizes]
    for wanted in (_Fit.WITHIN_LIMITS, _Fit.DISC):
        for value in [value for fit, value in fits if fit >= wanted][:2]:
            try:
                made = _planned(with_overrides(design, [f"{key}={value:.10g}"]), profile, silent)
            except CadgenError:
                continue
            if not failing(made.checks) or (wanted == _Fit.DISC and _broken_wall(made) is None):
                return value, not failing(made.checks)
    return None


class _Fit(IntEnum):
    """Grade of a changed design by its followers alone."""

    NONE = 0
    DISC = 1
    WITHIN_LIMITS = 2  # of the pressure angle and of the least radius, of a round follower


def _fit(design: MotionDesign, override: str) -> _Fit:
    """Followers of a changed design against the motion, without a profile."""
    try:
        changed = with_overrides(design, [override])
        registered, keys = changed.follower.registered, changed.follower.keys
        motion, limits = cam_model.source_of(changed).motion(changed), cam_model.check_limits(changed)
        rolled = [(registered.follower(keys, changed.seat), motion)]
        if (second := registered.second(keys, changed.seat)) is not None:
            rolled.append((second, OppositeMotion.of(motion)))
        for follower, moved in rolled:
            follower.refuse(moved)
    except CadgenError:
        return _Fit.NONE
    theta = np.linspace(0.0, TURN, _DENSE)
    for follower, moved in rolled:
        if isinstance(follower, RoundFollower):
            q, v, a = (moved.q(theta % TURN, nu=order) for order in range(3))
            way = np.abs(follower.centre(q, np.ones_like(q), np.zeros_like(q))[1])
            least, radius = follower.push(q, v) / way, follower.profile_radius(q, v, a)
            allowed = np.cos(np.where(v < 0, limits.pressure_angle.fall, limits.pressure_angle.rise))
            if (least < allowed).any() or ((radius > -follower.radius) & (radius < limits.min_convex_radius)).any():
                return _Fit.DISC
    return _Fit.WITHIN_LIMITS


def _planned(design: MotionDesign, profile: str | None, progress: Progress) -> CamPlan:
    kind = ACTUAL if profile is None else profile_of(profile)
    if kind.for_play:
        raise DesignError(
            'the profile "{profile}" is against the play of a car\'s gears, and the design has [motion]: take '
            "--profile actual",
            profile=kind.code,
        )
    registered, keys = design.follower.registered, design.follower.keys
    motion = cam_model.source_of(design).motion(design)
    groove, counter = registered.groove(keys, design.seat), registered.second(keys, design.seat)
    if groove is not None and not kind.by_axis:
        return _grooved(design, kind, motion, groove, progress)
    first = _disc(design, kind, motion, registered.follower(keys, design.seat), progress)
    if counter is None:
        return first
    gap, hub = keys.second.gap_mm, first.made_blank.hub
    if gap is not None and hub is not None and hub.length > gap:
        raise DesignError(
            "follower.second.gap_mm is {gap:g}; a hub of {hub:g} mm stands between the discs: give {hub:g} or more",
            gap=gap,
            hub=hub.length,
        )
    second = replace(_disc(design, kind, OppositeMotion.of(motion), counter, progress), part=SECOND)
    checks = (
        replace(
            check,
            code=SecondDisc(f"second-{check.code}"),
            name=Message("second disc: {name}", name=Message(check.name)),
        )
        for check in second.checks
    )
    return replace(first, second=second, checks=(*first.checks, *checks))


def _grooved(
    design: MotionDesign, kind: ProfileKind, motion: Motion, rollers: GrooveRollers, progress: Progress
) -> CamPlan:
    """Disc with a groove: both flanks, what they leave of the disc, and the play of the roller."""
    if motion.kinks.size:
        assert isinstance(motion, SegmentMotion)  # no other has kinks
        numbers = polynomials(motion.segments[: motion.count], 1)
        accepted = bool(numbers) and _leaves_a_cam(design, polynomial_overrides(numbers), kind.code)
        raise DesignError(
            'follower.closure is "groove", and the velocity jumps at {angle:.4g} degrees of cam angle, where the outer '
            "flank would have a corner: {cure}",
            angle=degrees(float(motion.kinks[0])),
            cure=Message("set {changes}, which meets its neighbours", changes=polynomial_changes(numbers))
            if accepted
            else Message("take laws that meet each other there"),
        )
    if design.blank.edge_break_mm:
        raise DesignError(
            "blank.edge_break_mm breaks the edges of a rim that carries the follower, and here a groove does: remove it"
        )
    inner = _disc(design, kind, motion, rollers.inner, progress)
    outer = replace(_disc(design, kind, OppositeMotion.of(motion), rollers.outer, progress), part=OUTER)
    widest = float(np.linalg.norm(outer.curve.outline(PROFILE_STEP).points, axis=1).max())
    given, wall = design.cam.outside_diameter_mm, inner.limits.wall
    outside = ceil(2 * (widest + wall + _BEYOND_GROOVE)) / 2 if given is None else given / 2
    if outside <= widest:
        raise DesignError(
            "cam.outside_diameter_mm is {given:g}; the groove reaches out to a diameter of {least:.4g} mm: raise it to "
            "{cure:g} or more, or leave it out",
            given=2 * outside,
            least=2 * widest,
            cure=ceil(2 * (widest + wall)),
        )
    checks = (
        *(
            # No cutter is wider than the groove.
            replace(check, value=min(check.value, rollers.half_width), place=Message("width of the groove"))
            if check.code == CheckCode.CUTTER_RADIUS and check.value > rollers.half_width
            else check
            for check in inner.checks
        ),
        *(
            replace(
                check,
                code=OuterFlank(f"outer-{check.code}"),
                name=Message("outer flank: {name}", name=Message(check.name)),
            )
            for check in outer.checks
            if check.code in _OF_OUTER_FLANK
        ),
        *groove_checks(rollers, inner.curve, outer.curve, cam_angles(motion), outside, wall),
    )
    made = Groove(outer=outer, depth=rollers.depth, outside_radius=outside)
    return replace(inner, groove=made, checks=checks)


def _groove_words(cam: CamPlan, groove: Groove) -> Message:
    """Sizes of a groove in a sentence."""
    return Message(
        "Groove: {width:g} mm wide and {depth:g} mm deep in the face that files show, half of its clearance on either "
        "side of the path of the roller's centre; the disc has a diameter of {diameter:g} mm.",
        width=2 * cam.follower_as_built.radius,
        depth=groove.depth,
        diameter=2 * groove.outside_radius,
    )


def _broken_wall(made: CamPlan) -> Check | None:
    """Check of a wall of which nothing is left, on either disc; None if there is none."""
    return next((check for check in made.checks if check.code in _WALLS and check.value <= 0), None)


def _cut_away(design: MotionDesign, wall: Check) -> DesignError:
    """Refusal of a disc that a hole or a hub breaks out of, with sizes that were tried.

    Args:
        design: design of the disc.
        wall: check of the thinnest wall, of which nothing is left.
    """
    short = ceil(10 * (wall.limit - wall.value)) / 10
    blank, base = design.blank, design.cam.base_circle_radius_mm
    ways = {"blank.bore_diameter_mm": floor(10 * (blank.bore_diameter_mm - 2 * short)) / 10}
    if blank.hub is not None:
        ways["blank.hub.diameter_mm"] = floor(10 * (blank.hub.diameter_mm - 2 * short)) / 10
    if base is not None:
        ways["cam.base_circle_radius_mm"] = base + short
    cures: list[str] = []
    for key, value in ways.items():
        try:
            made = _planned(with_overrides(design, [f"{key}={value:.10g}"]), None, silent)
        except CadgenError:
            continue
        if not any(each.code == wall.code and not each.passed for each in made.checks):
            cures.append(Message("{key} to {value:g}", key=key, value=value))
    return DesignError(
        "the {name} is {value:.4g} mm ({place}), so the disc breaks there: {cure}",
        name=Message(wall.name),
        value=wall.value,
        place=wall.place,
        cure=Message("set {changes}", changes=joined(cures, Message(", or "))) if cures else wall.advice,
    )


def _disc(design: MotionDesign, kind: ProfileKind, motion: Motion, follower: Follower, progress: Progress) -> CamPlan:
    """Profile of one disc, checked."""
    blank, limits = cam_model.blank(design), cam_model.check_limits(design)
    progress(Message("computing the {profile} profile", profile=Message(str(kind))))
    wanted = kind.curve(motion, follower)
    progress("checking the profile")
    rolling = kind.rolling(follower)
    checks = check_cam(motion, rolling, wanted.curve, wanted.trims, blank, limits, application=signed_pressure)
    use = MotionUse(design)
    return CamPlan(
        origin=Origin.of(design),
        kind=kind,
        motion=motion,
        follower_as_built=follower,
        curve=wanted.curve,
        trims=wanted.trims,
        blank=blank,
        faces=design.cam.faces_mm,
        seen=use.seen,
        limits=limits,
        making=Making.of(design),
        checks=checks,
        application=use,
    )
