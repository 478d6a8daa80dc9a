"""A cam by its motion: its use, its plan and its checks."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.checks import check_cam, signed_pressure
from cadgen.car.against_play.profile_kinds import ACTUAL, profile_of
from cadgen.check import Check, CheckCode, failing
from cadgen.design import cam_model
from cadgen.design.load import with_overrides
from cadgen.design.motion import DiscSense, motion_of
from cadgen.design.schema import MotionDesign
from cadgen.errors import DesignError
from cadgen.figures import Facts
from cadgen.jobs.cam.cam_plan import Application, CamPlan, Making
from cadgen.laws.motion import Motion
from cadgen.laws.segments import Seam, SegmentMotion
from cadgen.laws.unit import MM
from cadgen.messages import Message, clauses
from cadgen.output.files.manifest import Origin
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict, Reservation

# Checks that a size of the follower may cure.
_SIZED = (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN, CheckCode.CONVEX_RADIUS_PROFILE)
_DENSE = 7201  # stations at which the greatest velocity and acceleration are sought


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

    def entry(self, cam: CamPlan) -> Facts:
        """Sense, speed, and greatest velocity and acceleration of the follower."""
        unit = cam.motion.unit.symbol
        peaks = {} if self.rpm is None else _peaks(cam, self.rpm)
        return Facts(
            motion=Facts(
                unit=unit,
                turns=self.turns.value,
                speed_rpm=self.rpm,
                **{f"greatest_{name}_{unit}_per_{time}": value for name, (value, time) in peaks.items()},
                jumps=[
                    Facts(cam_angle_deg=degrees(seam.cam_angle), derivative=seam.order) for seam in _seams(cam.motion)
                ],
            )
        )

    def purpose(self, cam: CamPlan) -> str:
        """Travel of the follower in a turn, and the speed."""
        q, follower = cam.motion.q(np.linspace(0.0, TURN, _DENSE)), Message(cam.follower.noun)
        if cam.motion.unit == MM:
            said = Message("a {follower} that moves {travel:.4g} mm", follower=follower, travel=float(np.ptp(q)))
        else:
            said = Message("a {follower} that swings {swing:.4g}°", follower=follower, swing=degrees(np.ptp(q)))
        return said if self.rpm is None else clauses(said, Message("at {speed:g} rev/min", speed=self.rpm))

    def verdict(self, cam: CamPlan) -> PartVerdict:
        """Verdict on the cam, with a reservation where its acceleration jumps."""
        if float(np.ptp(cam.motion.q(np.linspace(0.0, TURN, _DENSE)))) <= cam.motion.unit.level:
            still = Reservation(
                "no-motion",
                Message("the follower stands still through the whole turn"),
                Message("give {key} a rise and a return", key=self.design.motion.shaping_key),
            )
            return PartVerdict(cam.checks, (still,))
        return PartVerdict(
            cam.checks,
            tuple(
                Reservation(
                    "acceleration-jumps",
                    Message(
                        "at {angle:.4g}° of cam angle the acceleration jumps from {before:.4g} to {after:.4g} "
                        "{unit}/rad²",
                        angle=degrees(seam.cam_angle),
                        before=seam.before,
                        after=seam.after,
                        unit=cam.motion.unit.symbol,
                    ),
                    Message("take a law that fits its neighbour, or go slowly"),
                )
                for seam in _seams(cam.motion)
            ),
        )

    def notes(self, cam: CamPlan) -> tuple[str, ...]:
        """Sense of the disc, and greatest velocity and acceleration."""
        said = [
            Message(
                "The disc turns {turns}, seen on its outer face; files show its {seen} face, on which it turns "
                "clockwise.",
                turns=Message(self.turns.value),
                seen=Message(self.seen.value),
            )
        ]
        if self.rpm is not None:
            (velocity, _), (acceleration, _) = _peaks(cam, self.rpm).values()
            unit, share = ("m", 1e-3) if cam.motion.unit == MM else (cam.motion.unit.symbol, 1.0)
            said.append(
                Message(
                    "At {speed:g} rev/min the follower moves at up to {velocity:.4g} {unit}/s and {acceleration:.4g} "
                    "{unit}/s².",
                    speed=self.rpm,
                    velocity=velocity * share,
                    acceleration=acceleration * share,
                    unit=unit,
                )
            )
        return tuple(said)

    def drawing_notes(self, cam: CamPlan) -> tuple[str, ...]:
        """Sense in which the disc turns, and the base circle."""
        return (
            Message("Turns clockwise, seen on this face."),
            Message("Base circle: radius {radius:g} mm.", radius=self.design.seat.base_radius),
        )


def _peaks(cam: CamPlan, rpm: float) -> dict[str, tuple[float, str]]:
    """Greatest velocity and acceleration, by the second, with the unit of time."""
    theta, speed = np.linspace(0.0, TURN, _DENSE), rpm * TURN / 60
    return {
        name: (float(np.abs(cam.motion.q(theta, nu=order)).max()) * speed**order, time)
        for order, name, time in ((1, "velocity", "s"), (2, "acceleration", "s2"))
    }


def _seams(motion: Motion) -> tuple[Seam, ...]:
    return motion.seams if isinstance(motion, SegmentMotion) else ()


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
    registered = design.follower.registered
    motion = motion_of(design.motion, registered)
    follower = registered.build(design.follower.keys, design.seat)
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
