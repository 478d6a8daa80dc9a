"""From a design to a checked cam, of a car or by its motion. No CAD kernel is needed for this."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees
from typing import Any

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.checks import LOST_LIFT, cam_angles, check_cam
from cadgen.cam.contact import roll
from cadgen.cam.follower import Contact, Follower, Trim
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.limits import CheckLimits
from cadgen.car.against_play.evaluate import evaluate
from cadgen.car.against_play.laps import Laps
from cadgen.car.against_play.play_task import TrainTask
from cadgen.car.against_play.profile_kinds import ACTUAL, OPTIMIZED, ProfileKind, codes, profile_of
from cadgen.car.course.layout import Side
from cadgen.car.path.path_kinds import CUBIC
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion, blend_checks
from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.friction import DiscMaterial
from cadgen.car.running.sampled import rolled_lift
from cadgen.check import Check, failing
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.curves.derived import turned
from cadgen.design import cam_model, variation
from cadgen.design.load import with_overrides
from cadgen.design.machining import DrawingText, Machining
from cadgen.design.motion import DiscSense, motion_of
from cadgen.design.schema import Design, Export, MotionDesign
from cadgen.design.section import listed
from cadgen.deviations.as_built import edges_check
from cadgen.errors import DesignError
from cadgen.jobs.cam.built_car import as_built_sentences, assumed_play, outlook_checks
from cadgen.jobs.cam.car_facts import as_built_facts, comparison_facts
from cadgen.jobs.cam.comparison import MeasuredCam, PlayComparison, ProfileChecks, against_play, known_trains, task_of
from cadgen.jobs.cam.course import OnCourse, course_checks, on_course
from cadgen.jobs.cam.mechanics import mechanics_checks
from cadgen.jobs.cam.wheel import DriveWheel, drive_wheel, field_notice, sense_notice
from cadgen.laws.motion import Motion
from cadgen.laws.segments import Seam, SegmentMotion
from cadgen.messages import Message
from cadgen.output.files.manifest import Origin
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent

# Lengthening the closing blend is tried by these factors.
_BLEND_FACTORS = (1.5, 2.0, 3.0, 5.0, 8.0)
_DENSE = 7201  # stations at which the greatest velocity and acceleration are sought


@dataclass(frozen=True)
class Making:
    """How a cam is made and how finely its files follow it.

    Attributes:
        material: material of the disc; None where the design does not say.
        bore_fit: fit of the bore, such as H7/g6; None where the design does not say.
        title: texts of the title block of its sheet; None where the design does not say.
        machining: cutter, speeds, tabs and drilling.
        export: how finely files follow the outline.
    """

    material: DiscMaterial | None
    bore_fit: str | None
    title: DrawingText | None
    machining: Machining
    export: Export

    @classmethod
    def of(cls, design: Design | MotionDesign) -> "Making":
        """Making of a design's cam."""
        return cls(
            material=design.blank.material,
            bore_fit=design.blank.bore_fit,
            title=design.drawing,
            machining=design.machining,
            export=design.export,
        )


class Application:
    """Use of a cam. This base class is a cam of which nothing else is known; a car is `CarUse`.

    Attributes:
        noun: name of the cam in titles and descriptions.
        measured_again: whether measured data of it are judged by `cadgen calibrate`, for which its sheet has a form.
    """

    noun = "cam"
    measured_again = False

    @property
    def profile_tolerance(self) -> float | None:
        """Tolerance of the outline along its normal, mm; None where nothing is said of it."""
        return None

    def open_keys(self) -> dict[str, tuple[str, object]]:
        """Facts of the application that a sheet needs, each with its key and its value."""
        return {}

    def figures(self, cam: "CamPlan") -> tuple[Check, ...]:
        """Figures without a verdict that are shown beside the checks."""
        return ()

    def facts(self, cam: "CamPlan") -> dict[str, Any]:
        """Figures of the application as plain values, each in the unit that its key names."""
        return {}

    def notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sentences on what was assumed, and on what to do beside the cam."""
        return ()

    def drawing_notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sentences for the cam's sheet."""
        return ()

    def changes(self, cam: "CamPlan") -> Iterable[Sequence[tuple[str, str]]]:
        """Changes that may cure lost lift: groups of overrides as for `--set`, each with the present value as text.

        Of each group the first is taken that cures.
        """
        return ()

    def replanned(self, cam: "CamPlan", override: str) -> tuple[Check, ...]:
        """Checks of the same cam with a change of its design.

        Args:
            cam: cam that was computed.
            override: change, as for `--set`.

        Raises:
            DesignError: the result is no design, or no cam.
        """
        raise NotImplementedError

    def of_file(self, cam: "CamPlan", outline: Outline, contact: Contact, limit: float) -> dict[str, Any]:
        """Behaviour of a file's cam in its application, as plain values.

        Args:
            cam: cam that the file is of.
            outline: outline read back from the file, mm.
            contact: contact of the follower with it.
            limit: greatest error of the lift allowed to the file, um.
        """
        return {}

    def of_loss(self, name: str, facts: Mapping[str, Any], finer: str) -> tuple[str, ...]:
        """Warnings where a file keeps its own tolerance, but gives away what the profile is for.

        Args:
            name: name of the file.
            facts: what `of_file` gave.
            finer: advice that makes the file finer.
        """
        return ()


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
    def speed(self) -> float | None:
        """Speed of the camshaft, rad/s; None where the design does not say."""
        rpm = self.design.motion.speed_rpm
        return None if rpm is None else rpm * TURN / 60

    def replanned(self, cam: "CamPlan", override: str) -> tuple[Check, ...]:
        """Checks of the same cam with a change of its design."""
        return plan_motion_cam(with_overrides(self.design, [override]), cam.kind.code).checks

    def facts(self, cam: "CamPlan") -> dict[str, Any]:
        """Sense, speed, and greatest velocity and acceleration of the follower."""
        unit = cam.motion.unit.symbol
        peaks = {} if self.speed is None else self._peaks(cam)
        return {
            "motion": {
                "unit": unit,
                "turns": self.turns.value,
                "speed_rpm": None if self.speed is None else self.speed / TURN * 60,
                **{f"greatest_{name}_{unit}_per_{time}": value for name, (value, time) in peaks.items()},
                "jumps": [
                    {"cam_angle_deg": degrees(seam.cam_angle), "derivative": seam.order} for seam in _seams(cam.motion)
                ],
            }
        }

    def notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sense of the disc, greatest velocity and acceleration, and where the acceleration jumps."""
        seen = "outer" if self.turns == DiscSense.CLOCKWISE else "inner"
        said = [
            Message(
                "The disc turns {turns}, seen on its outer face; files show its {seen} face, on which it turns "
                "clockwise.",
                turns=Message(self.turns.value),
                seen=Message(seen),
            )
        ]
        if self.speed is not None:
            (velocity, _), (acceleration, _) = self._peaks(cam).values()
            said.append(
                Message(
                    "At {speed:g} rev/min the follower moves at up to {velocity:.4g} {unit}/s and {acceleration:.4g} "
                    "{unit}/s².",
                    speed=self.speed / TURN * 60,
                    velocity=velocity,
                    acceleration=acceleration,
                    unit=cam.motion.unit.symbol,
                )
            )
        said += [
            Message(
                "At {angle:.4g}° of cam angle the acceleration jumps from {before:.4g} to {after:.4g} {unit}/rad²: "
                "take a law that fits its neighbour, or go slowly.",
                angle=degrees(seam.cam_angle),
                before=seam.before,
                after=seam.after,
                unit=cam.motion.unit.symbol,
            )
            for seam in _seams(cam.motion)
        ]
        return tuple(said)

    def drawing_notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sense in which the disc turns."""
        return (Message("Turns clockwise, seen on this face."),)

    def _peaks(self, cam: "CamPlan") -> dict[str, tuple[float, str]]:
        """Greatest velocity and acceleration, by the second, with the unit of time."""
        theta, speed = np.linspace(0.0, TURN, _DENSE), self.speed or 0.0
        return {
            name: (float(np.abs(cam.motion.q(theta, nu=order)).max()) * speed**order, time)
            for order, name, time in ((1, "velocity", "s"), (2, "acceleration", "s2"))
        }


def _seams(motion: Motion) -> tuple[Seam, ...]:
    return motion.seams if isinstance(motion, SegmentMotion) else ()


@dataclass(frozen=True)
class CarUse(Application):
    """A car that the cam steers.

    Attributes:
        design: design of the car.
        track: track of the drive wheel.
        comparison: of the profile with the plain profile under play; None for a profile that is not for play.
        course: course of the design with the car that is to keep it; None without [course].
        laps: laps of a closed path; None of an open one.
    """

    design: Design
    track: Track
    comparison: PlayComparison | None = None
    course: OnCourse | None = None
    laps: Laps | None = None

    noun = "steering cam"
    measured_again = True

    @property
    def profile_tolerance(self) -> float | None:
        """Tolerance of the outline along its normal, mm."""
        return self.design.tolerances.profile_offset_mm

    def open_keys(self) -> dict[str, tuple[str, object]]:
        """Tolerance of the outline."""
        return {"tolerance of the outline": ("tolerances.profile_offset_mm", self.profile_tolerance)}

    def wanted(self, cam: "CamPlan") -> PathMotion:
        """Motion that the path asks for; the cam's own may be another, against play."""
        motion = cam.motion if self.comparison is None else self.comparison.task.lift
        assert isinstance(motion, PathMotion)
        return motion

    def wheel(self, cam: "CamPlan") -> DriveWheel:
        """Drive wheel that the cam is for."""
        return drive_wheel(self.design, self.track, self.wanted(cam))

    @property
    def path_end(self) -> float:
        """Arc length of the track up to which the path steers, mm: there the closing blend begins, or the lap ends."""
        return cam_model.path_end(self.design, self.track)

    def figures(self, cam: "CamPlan") -> tuple[Check, ...]:
        """Cost at the finish of edges broken more than designed; of the leaning rod, which alone rides on an edge."""
        if not isinstance(cam.follower, LeaningRod):
            return ()
        as_built, travel = cam_model.as_built(self.design), cam_model.travel(self.design, self.track)
        car = cam_model.car(self.design)
        assert isinstance(cam.motion, PathMotion)
        return (edges_check(cam.motion, cam.follower, cam.curve, as_built, car, travel),)

    def changes(self, cam: "CamPlan") -> Iterable[Sequence[tuple[str, str]]]:
        """A spline without kinks, and a longer closing blend where lift is lost in it."""
        if self.design.path.spline == CUBIC.code:
            yield [('path.spline="quintic"', "cubic")]
        now = self.design.cam.blend_deg
        if any(trim.after >= cam.steering.blend_start for trim in cam.trims):
            yield [(f"cam.blend_deg={now * factor:g}", f"{now:g}") for factor in _BLEND_FACTORS]

    def replanned(self, cam: "CamPlan", override: str) -> tuple[Check, ...]:
        """Checks of the cam's profile for a changed design; against play the method already chosen is kept."""
        design = with_overrides(self.design, [override])
        if self.comparison is None:
            return _plan(design, cam.kind, silent).checks
        chosen, track = self.comparison.chosen, cam_model.track(design)
        task = task_of(design, track, cam_model.lift(design, track), cam_model.follower(design))
        work = TrainTask(task, chosen.train, known_trains(design)[chosen.train])
        return ProfileChecks(design, task).of(evaluate(work, chosen.profile))

    def facts(self, cam: "CamPlan") -> dict[str, Any]:
        """Wheel, track, blend or laps, comparison under play, and the car as built."""
        comparison, laps, start = self.comparison, self.laps, cam.steering.blend_start
        turn: dict[str, Any] = {
            "blend": {
                "from_cam_angle_deg": degrees(start),
                "from_track_mm": self.path_end,
                "where": self.track.where(self.path_end),
            }
        }
        if laps is not None:
            runs = {} if comparison is None else {"before": comparison.before, "after": comparison.chosen}
            turn = {"laps": laps.facts(None if comparison is None else comparison.run, **runs)}
        return {
            "drive_wheel": cam.drive_wheel.facts(),
            "track_length_mm": self.track.length,
            **turn,
            "play": None if comparison is None else comparison_facts(comparison),
            "as_built": as_built_facts(self.design, start),
        }

    def notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sentences on what was assumed of the car, and what was measured."""
        design, comparison, laps = self.design, self.comparison, self.laps
        stop = self.wanted(cam).blend_start
        return (
            *field_notice(design),
            *sense_notice(design),
            *(assumed_play(design) if comparison else ()),
            *as_built_sentences(design, stop),
            *(laps.sentences(comparison.run, comparison.before, comparison.chosen) if laps and comparison else ()),
        )

    def drawing_notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Tolerances of the faces' distances from the fork axis."""
        inner, outer = self.design.tolerances.inner_face_mm, self.design.tolerances.outer_face_mm
        if not (inner or outer):
            return ()
        return (
            Message(
                "Faces: inner ± {inner:g}, outer ± {outer:g} mm from the fork axis, as the cars are reckoned.",
                inner=inner,
                outer=outer,
            ),
        )

    def of_file(self, cam: "CamPlan", outline: Outline, contact: Contact, limit: float) -> dict[str, Any]:
        """End of the run with play on the cam of a file.

        Args:
            cam: cam that the file is of.
            outline: outline read back from the file, mm.
            contact: contact of the follower with it.
            limit: greatest error of the lift allowed to the file, mm.
        """
        comparison = self.comparison
        if comparison is None:
            return {}
        as_built = comparison.task.as_built
        angles = cam_angles(cam.motion)
        if as_built.shapes_discs:
            rolled = roll(as_built.finished(outline), cam.follower, angles)
        else:
            rolled = contact.at(np.searchsorted(contact.cam_angle, angles))
        # Rises and falls within the error allowed to the file are no events of the path.
        least_swing = max(comparison.chosen.least_swing, limit * 1e-3 / comparison.task.follower.inner)
        assert isinstance(cam.motion, PathMotion)
        lift = rolled_lift(rolled, cam.motion, blend_start=cam.motion.blend_start)
        heading, distance = comparison.end_of(lift, least_swing)
        return {"end_heading_deg": degrees(heading), "end_position_mm": distance}

    def of_loss(self, name: str, facts: Mapping[str, Any], finer: str) -> tuple[str, ...]:
        """Warning if a file keeps its own tolerance, but loses the gain of the profile against play."""
        comparison, end = self.comparison, facts.get("end_position_mm")
        if comparison is None or end is None or not comparison.loses(end):
            return ()
        return (
            Message(
                "{name} gives away what the profile does against play, for with it the run ends {end:.1f} mm off, and "
                "{exact:.1f} mm with the exact profile: {finer}",
                name=name,
                end=end,
                exact=comparison.chosen.error.end_distance,
                finer=finer,
            ),
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class CamPlan:
    """A cam that has been computed and checked, but not yet made.

    Attributes:
        origin: design that the cam was planned from.
        kind: kind of the profile; as text, its code.
        motion: motion that the profile is cut for: the planned one, or one that gives the planned one with play.
        rod: follower of the design, as built.
        curve: curve that is cut: the profile, or on a car as built the curve that becomes the profile on its shaft, mm.
        trims: places where the envelope was trimmed.
        blank: features of the disc besides its profile.
        faces: distances of the disc's faces from the fork axis, or heights, mm.
        seen: face of the disc that files show.
        limits: limits of the checks, mm and rad.
        making: how the disc is made, and how finely files follow it.
        checks: every figure with its verdict.
        application: what the cam is for.
        phase: angle by which the curve stands turned on the shaft of a car as built, rad.
    """

    origin: Origin
    kind: ProfileKind
    motion: Motion
    rod: Follower
    curve: ClosedCurve
    trims: tuple[Trim, ...]
    blank: Blank
    faces: tuple[float, float]
    seen: Face
    limits: CheckLimits
    making: Making
    checks: tuple[Check, ...]
    application: Application
    phase: float = 0.0

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

    @property
    def stem(self) -> str:
        """Stem of the names of the cam's files."""
        return f"{self.origin.name}_{self.kind}"

    @property
    def thickness(self) -> float:
        """Distance of the disc's faces, mm."""
        return self.faces[1] - self.faces[0]

    @cached_property
    def shown(self) -> tuple[Check, ...]:
        """Figures without a verdict, computed when they are shown."""
        return self.application.figures(self)

    @property
    def edges(self) -> Check | None:
        """Cost at the finish of edges broken more than designed, mm: a figure without a limit; None for no rod."""
        return next(iter(self.shown), None)

    @property
    def figures(self) -> tuple[Check, ...]:
        """The checks, and what is shown beside them."""
        return (*self.checks, *self.shown)

    @property
    def made_blank(self) -> Blank:
        """Features of the disc as files show it, seen on the face of `seen`."""
        blank = self.blank
        if self.seen == Face.OUTER or blank.hub is None:
            return blank
        return replace(blank, hub=replace(blank.hub, side=Face.INNER if blank.hub.side == Face.OUTER else Face.OUTER))

    @property
    def follower(self) -> Follower:
        """Follower that rolls on this profile: that of the design, or its reference point."""
        return _rolling(self.kind, self.rod)

    @cached_property
    def on_shaft(self) -> ClosedCurve:
        """Curve that is cut, mm, on a shaft whose key is right: turned with the key of a car as built."""
        return turned(self.curve, self.phase) if self.phase else self.curve

    @cached_property
    def area(self) -> float:
        """Area of the profile, mm^2."""
        return self.curve.area()

    # The car of a steering cam; a cam by its motion has none.

    @property
    def car(self) -> CarUse:
        """Car that the cam steers.

        Raises:
            DesignError: the cam is of a design with [motion].
        """
        if isinstance(self.application, CarUse):
            return self.application
        raise DesignError("{name} is a cam by its [motion]: there is no car that it steers", name=self.origin.name)

    @property
    def steering(self) -> PathMotion:
        """Steering that the profile of a car's cam is cut for."""
        assert isinstance(self.motion, PathMotion)
        return self.motion

    @property
    def track(self) -> Track:
        """Track of the car's drive wheel."""
        return self.car.track

    @property
    def comparison(self) -> PlayComparison | None:
        """Comparison under play; None for a profile that is not for play, and without a car."""
        return self.application.comparison if isinstance(self.application, CarUse) else None

    @property
    def course(self) -> OnCourse | None:
        """Course of the car; None without one."""
        return self.application.course if isinstance(self.application, CarUse) else None

    @property
    def laps(self) -> Laps | None:
        """Laps of a closed path; None of an open one, and without a car."""
        return self.application.laps if isinstance(self.application, CarUse) else None

    @cached_property
    def drive_wheel(self) -> DriveWheel:
        """Drive wheel that the car's cam is for."""
        return self.car.wheel(self)

    @property
    def path_end(self) -> float:
        """Arc length of the track up to which the path steers, mm."""
        return self.car.path_end


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
    progress(Message("computing the {profile} profile", profile=kind))
    wanted = kind.curve(motion, follower)
    progress("checking the profile")
    checks = check_cam(motion, _rolling(kind, follower), wanted.curve, wanted.trims, blank, limits)
    return CamPlan(
        origin=Origin.of(design),
        kind=kind,
        motion=motion,
        rod=follower,
        curve=wanted.curve,
        trims=wanted.trims,
        blank=blank,
        faces=design.cam.faces_mm,
        seen=Face.OUTER if design.motion.turns == DiscSense.CLOCKWISE else Face.INNER,
        limits=limits,
        making=Making.of(design),
        checks=checks,
        application=SegmentUse(design),
    )


def _of_car(
    use: CarUse,
    profile: ProfileKind,
    motion: PathMotion,
    rod: Follower,
    curve: ClosedCurve,
    trims: tuple[Trim, ...],
    checks: tuple[Check, ...],
) -> CamPlan:
    """Plan of a car's cam."""
    design = use.design
    return CamPlan(
        origin=Origin.of(design),
        kind=profile,
        motion=motion,
        rod=rod,
        curve=curve,
        trims=trims,
        blank=cam_model.blank(design),
        faces=design.cam.faces_mm,
        seen=Face.INNER if design.cam.side == Side.RIGHT else Face.OUTER,
        limits=cam_model.check_limits(design),
        making=Making.of(design),
        checks=checks,
        application=use,
        phase=cam_model.as_built(design).phase,
    )


def _plan(design: Design, profile: ProfileKind, progress: Progress, *, judged: bool = True) -> CamPlan:
    """Plan of a profile that is not for play."""
    progress("planning the path")
    track = cam_model.track(design)
    lift, rod, blank = cam_model.lift(design, track), cam_model.follower(design), cam_model.blank(design)
    progress(Message("computing the {profile} profile", profile=profile))
    wanted = profile.curve(lift, rod)
    cut = cam_model.as_built(design).precompensated(wanted.curve)
    if not judged:
        return _of_car(CarUse(design, track), profile, lift, rod, cut, wanted.trims, ())
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
    return _of_car(CarUse(design, track, None, course, laps), profile, lift, rod, cut, wanted.trims, checks)


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
    lift, rod = cam_model.lift(design, track), cam_model.follower(design)
    progress(Message("computing the {profile} profile", profile=profile))
    checks = ProfileChecks(design, task_of(design, track, lift, rod))
    comparison = against_play(profile, checks, all_trains=all_trains, measured=measured, progress=progress)
    chosen = comparison.chosen
    progress("checking the profile")
    course, laps = on_course(design, track, lift), _laps(design, track, lift)
    checked = (
        *checks.of(chosen),
        *course_checks(course, comparison),
        *(laps.checks(chosen) if laps else ()),
        *outlook_checks(design),
    )
    use = CarUse(design, track, comparison, course, laps)
    return _of_car(use, profile, chosen.lift, rod, chosen.cut, chosen.wanted.trims, checked)


def _measured_cam(design: Design) -> MeasuredCam | None:
    """Cam that was on the car when the car was measured, as made then; None if the design has no [as_built]."""
    if design.as_built is None:
        return None
    profile, then = profile_of(design.as_built.profile), design.as_cut().model_copy(update={"course": None})
    planned = _plan_against_play if profile.for_play else _plan
    plan = planned(then, profile, silent)
    return MeasuredCam(profile=profile, lift=plan.steering, curve=plan.on_shaft)


def comparison_of(plan: CamPlan) -> PlayComparison:
    """Comparison of a plan's profile with the plain profile under play.

    Raises:
        DesignError: the profile is not for play.
    """
    if plan.comparison is None:
        choices = listed(codes(for_play=True), "or")
        raise DesignError(
            'the profile "{kind}" does nothing about play: choose {choices}', kind=plan.kind, choices=choices
        )
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
