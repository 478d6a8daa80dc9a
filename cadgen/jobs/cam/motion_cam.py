"""A cam by its motion: its use, its plan and its checks."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from math import degrees

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.checks import check_cam, signed_pressure
from cadgen.cam.follower import Follower
from cadgen.cam.forces import CamForces
from cadgen.cam.opposite import OppositeMotion
from cadgen.car.against_play.profile_kinds import ACTUAL, ProfileKind, profile_of
from cadgen.check import Check, CheckCode, failing
from cadgen.design import cam_model
from cadgen.design.load import with_overrides
from cadgen.design.motion import DiscSense, motion_of
from cadgen.design.schema import MotionDesign
from cadgen.errors import DesignError
from cadgen.figures import Facts, Sheet
from cadgen.jobs.cam.cam_plan import Application, CamPlan, Making
from cadgen.jobs.cam.force_figures import force_checks, force_facts, force_figures, forces_of
from cadgen.jobs.cam.motion_figures import checks_of, facts_of, notes_of, reservations_of, seams_sheets
from cadgen.laws.motion import Motion
from cadgen.laws.unit import MM
from cadgen.messages import Message, clauses
from cadgen.output.files.manifest import Origin
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict, Reservation

SECOND = "second"  # in the names of the files of the second disc
SecondDisc = StrEnum("SecondDisc", {code.name: f"second-{code}" for code in CheckCode})  # type: ignore[misc]
# Checks that a size of the follower may cure.
_SIZED = (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN, CheckCode.CONVEX_RADIUS_PROFILE)
_DENSE = 7201  # stations at which the travel is sought


@dataclass(frozen=True)
class SegmentUse(Application):
    """Application of a cam by its motion, of which a design says the sense and the speed.

    Attributes:
        design: design with [motion].
    """

    design: MotionDesign

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
        sized = _SIZED if cam.follower_as_built.sizes(cam.motion, cam.limits) else ()
        return (*cam.lost, *(check for check in failing(cam.checks) if check.code in sized))

    def changes(self, cam: CamPlan) -> Iterator[Sequence[tuple[str, str]]]:
        """Sizes of the follower that keep the limits."""
        found = self.design.cam.base_circle_radius_mm is None
        for size in cam.follower_as_built.sizes(cam.motion, cam.limits):
            if not (found and size.key == cam.follower_as_built.base_key):
                yield [(f"{size.key}={size.value:.10g}", f"{size.now:g}")]

    def forces(self, cam: CamPlan) -> CamForces | None:
        """Forces on the follower and its camshaft; None without [dynamics].

        Args:
            cam: cam that was computed.
        """
        return forces_of(self.design, cam.motion, cam.follower_as_built)

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
            said = Message("a {follower} that swings {swing:.4g}°", follower=follower, swing=degrees(np.ptp(q)))
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
        return PartVerdict(checks, reservations_of(cam.motion, self.design))

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
        return sense, *second, *notes_of(cam.motion, self.rpm)

    def drawing_notes(self, cam: CamPlan) -> tuple[str, ...]:
        """Sense in which the disc turns, and the base circle."""
        return (
            Message("Turns clockwise, seen on this face."),
            Message("Second disc of a conjugate pair: key and angle 0 stand as on the first.")
            if cam.part
            else Message("Base circle: radius {radius:g} mm.", radius=self.design.seat.base_radius),
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
    kind = ACTUAL if profile is None else profile_of(profile)
    if kind.for_play:
        raise DesignError(
            'the profile "{profile}" is against the play of a car\'s gears, and the design has [motion]: take '
            "--profile actual",
            profile=kind.code,
        )
    registered, keys = design.follower.registered, design.follower.keys
    motion = motion_of(design.motion, registered)
    follower, counter = registered.build(keys, design.seat), registered.second(keys, design.seat)
    first = _disc(design, kind, motion, follower, progress)
    if counter is None:
        return first
    second = replace(_disc(design, kind, OppositeMotion.of(motion), counter, progress), part=SECOND)
    return replace(first, second=second, checks=(*first.checks, *map(_of_second, second.checks)))


def _disc(design: MotionDesign, kind: ProfileKind, motion: Motion, follower: Follower, progress: Progress) -> CamPlan:
    """Profile of one disc, checked."""
    blank, limits = cam_model.blank(design), cam_model.check_limits(design)
    progress(Message("computing the {profile} profile", profile=Message(str(kind))))
    wanted = kind.curve(motion, follower)
    progress("checking the profile")
    rolling = kind.rolling(follower)
    checks = check_cam(motion, rolling, wanted.curve, wanted.trims, blank, limits, application=signed_pressure)
    use = SegmentUse(design)
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


def _of_second(check: Check) -> Check:
    """Check of the second disc of a conjugate pair, with a code and a name of its own."""
    code = SecondDisc(f"second-{check.code}")
    return replace(check, code=code, name=Message("second disc: {name}", name=Message(check.name)))
