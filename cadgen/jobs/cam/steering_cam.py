"""A car's cam: the car as its use, its plan, and its checks. No CAD kernel is needed for this."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, degrees, isfinite, radians, tan

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.checks import cam_angles, check_cam
from cadgen.cam.contact import roll
from cadgen.cam.follower import Contact, EdgeFollower, Follower, Trim, edge_follower
from cadgen.car.against_play.evaluate import evaluate, rolled_on
from cadgen.car.against_play.laps import Laps
from cadgen.car.against_play.play_task import TrainTask
from cadgen.car.against_play.profile_kinds import ACTUAL, OPTIMIZED, ProfileKind, codes, profile_of
from cadgen.car.course.body import CarBody
from cadgen.car.course.layout import Course, Side
from cadgen.car.path.path_kinds import CUBIC
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion, blend_checks
from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.car.running.sampled import rolled_lift
from cadgen.car.steering import Car
from cadgen.check import Check, CheckCode, failing
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.design import cam_model, variation
from cadgen.design.as_built import AsBuiltSection
from cadgen.design.course import body_of, layout_of
from cadgen.design.load import with_overrides
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.deviations.as_built import edges_check
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.first_order import Expansion
from cadgen.errors import DesignError
from cadgen.figures import Facts, Figures
from cadgen.gears.train import OnceATurn
from cadgen.inference.monte_carlo.random_cars import Tolerances
from cadgen.jobs.cam.built_car import (
    as_built_sentences,
    assumed_play,
    outlook_checks,
    outlook_sentence,
    setting_sentences,
)
from cadgen.jobs.cam.cam_plan import CamPlan, Making, steepest
from cadgen.jobs.cam.car_facts import as_built_facts, comparison_facts
from cadgen.jobs.cam.comparison import MeasuredCam, PlayComparison, ProfileChecks, against_play, known_trains, task_of
from cadgen.jobs.cam.course import OnCourse, course_checks, floor_with, on_course
from cadgen.jobs.cam.mechanics import energy_verdict, joint_sentences, mechanics_checks, start_sentence
from cadgen.jobs.cam.path_check import cut_checks, lost_lift_check, lost_lift_reservation, path_checks
from cadgen.jobs.cam.readiness import (
    CourseYield,
    course_yield,
    not_counted,
    reservations,
    wheel_checks,
    yield_check,
)
from cadgen.jobs.cam.steered_car import SteeredCar
from cadgen.jobs.cam.wheel import DriveWheel, drive_wheel, field_notice, sense_of_train
from cadgen.jobs.car_layout import CarLayout, laid_out, layout_reservation
from cadgen.laws.motion import Motion
from cadgen.messages import Message, clauses, sentence
from cadgen.output.files.manifest import Origin
from cadgen.output.report.tracks import Field
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict, Reservation

# Factors by which a longer closing blend is tried, and those on the base radius that the pressure angle asks for.
_BLEND_FACTORS = (1.5, 2.0, 3.0, 5.0, 8.0)
_BASE_FACTORS = (1.0, 1.05, 1.15)
_MOST_BASE = 3.0  # times the base radius; another path is needed then
_STEEP = (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN)


@dataclass(frozen=True)
class CarUse(SteeredCar):
    """A car that the cam steers.

    Attributes:
        design: design of the car.
        track: track of the drive wheel.
        steering: motion that the profile is cut for.
        comparison: of the profile with the plain profile under play; None for a profile that is not for play.
        course: course of the design with the car that is to keep it; None without [course].
        laps: laps of a closed path; None of an open one.
    """

    design: Design
    track: Track
    steering: PathMotion
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

    @property
    def thickness_tolerance(self) -> float:
        """Half of what the faces may be off together, mm: the other half is left to the place of the disc."""
        return ((self.design.tolerances.inner_face_mm or 0.0) + (self.design.tolerances.outer_face_mm or 0.0)) / 2

    @property
    def edge_tolerance(self) -> float:
        """Half width of the tolerance of broken edges, mm."""
        return self.design.tolerances.edge_break_mm or 0.0

    @property
    def taper_tolerance(self) -> float:
        """Greatest difference of the outlines of both faces, mm."""
        return self.design.tolerances.taper_mm or 0.0

    # The car.

    @cached_property
    def car(self) -> Car:
        """The car in plan view, as built."""
        return cam_model.car(self.design)

    @cached_property
    def body(self) -> CarBody:
        """Outline and wheels of the car."""
        return body_of(self.design.car.outline, self.car)

    @property
    def points(self) -> dict[str, complex]:
        """Points of the car as designed at which a run is measured, ahead + i left of the drive wheel, mm, by code."""
        car = self.design.car
        return {
            "drive-wheel": 0j,
            "fork": car.wheelbase_mm - 1j * car.drive_wheel_offset_mm,
            "idle-wheel": -1j * (car.drive_wheel_offset_mm + car.idle_wheel_offset_mm),
            "path": -1j * self.design.path.offset_mm,
        }

    @property
    def side(self) -> Side:
        """Side of the fork axis on which the disc is."""
        return self.design.cam.side or Side.LEFT

    @cached_property
    def drive_wheel(self) -> DriveWheel:
        """Drive wheel that the cam is for."""
        return drive_wheel(self.design, self.track, self.wanted)

    @property
    def wheel(self) -> str:
        """Radius of the drive wheel that the cam is for, and what the closing blend does to the path, in words."""
        return self.drive_wheel.sentence()

    @property
    def travel(self) -> float:
        """Travel of the drive wheel's rim for one turn of the cam, mm."""
        return cam_model.travel(self.design, self.track)

    @cached_property
    def floor(self) -> Field:
        """Course or field with the car, as pictures show them."""
        return floor_with(self.design, self.body)

    @property
    def layout(self) -> Course | None:
        """Course of the design; None without one."""
        return layout_of(self.design.course)

    @property
    def has_train(self) -> bool:
        """Whether the design has a gear train."""
        return self.design.train is not None

    @property
    def record(self) -> AsBuiltSection | None:
        """Section [as_built]: what was measured on the car; None of a car as designed."""
        return self.design.as_built

    # Its motion.

    @property
    def wanted(self) -> PathMotion:
        """Motion that the path asks for; what the profile is cut for may be another, against play."""
        return self.steering if self.comparison is None else self.comparison.task.lift

    @property
    def path_end(self) -> float:
        """Arc length of the track up to which the path steers, mm: there the closing blend begins, or the lap ends."""
        return cam_model.path_end(self.design, self.track)

    @property
    def waypoints(self) -> Array:
        """Cam angles at which the car passes the waypoints after the first, on every lap of a run, rad, shape (n,)."""
        motor = cam_model.cam_angle(self.design, self.track, self.track.waypoint_arc[1:])
        if self.laps is None:
            return motor
        starts = np.arange(self.laps.in_run) * TURN / self.laps.in_turn
        return np.asarray((starts[:, None] + motor).ravel())

    def rolled(self, cam: CamPlan) -> PathMotion:
        """Motion that the follower gets on the cam that is made."""
        return self.steering if self.comparison is None else self.comparison.chosen.rolled

    def planned(self, cam: CamPlan) -> Motion | None:
        """Motion that the path asks for; None where the cam was not compared under play."""
        return None if self.comparison is None else self.comparison.task.lift

    def envelope(self, cam: CamPlan) -> ClosedCurve:
        """Curve on which the follower of the car as designed gets its motion, mm."""
        return cam.curve if self.comparison is None else self.comparison.chosen.wanted.curve

    # How cars of the design vary.

    def tolerances(self) -> Tolerances:
        """How cars of the design may differ.

        Raises:
            DesignError: a tolerance of a quantity that the design lacks.
        """
        return variation.tolerances(self.design, self._forces)

    def half_widths(self) -> dict[Deviation, float]:
        """Half of each tolerance zone; errors as of `tolerances`."""
        return variation.half_widths(self.design, self._forces)

    def of_the_parts(self) -> dict[Deviation, float]:
        """Half of the zones that follow from gears and rod, mm and rad."""
        return variation.of_the_parts(self.design, self._forces)

    @cached_property
    def shafts(self) -> tuple[OnceATurn, ...]:
        """Error of the gears of each shaft, once in its turn, from the camshaft on; empty without a train."""
        return variation.once_a_turn_of(self.design)

    @property
    def shaft_orders(self) -> tuple[float, ...]:
        """Turns of each shaft of the train for one of the camshaft, from the camshaft on."""
        return tuple(shaft.order for shaft in self.shafts)

    @property
    def gate_width(self) -> float | None:
        """Width of the gates at the waypoints and at the end, mm; None where the design gives none."""
        return self.design.tolerances.gate_width_mm

    def play_zones(self) -> dict[str, float]:
        """Half of the zone of each part of the play, rad; empty if the play was measured."""
        return variation.play_zones(self.design)

    @property
    def wheel_radius(self) -> float:
        """Radius of the drive wheel, mm; infinite where it is not known.

        Raises:
            DesignError: the radius has a tolerance but no value.
        """
        return variation.wheel_radius(self.design, self.travel)

    @property
    def expansion(self) -> Expansion:
        """How disc, frame and rod grow with heat."""
        return variation.expansion(self.design)

    @property
    def _forces(self) -> MechanicsBand | None:
        return None if self.comparison is None else self.comparison.task.mechanics

    # What is shown.

    def figures(self, cam: CamPlan) -> tuple[Check, ...]:
        """Cost at the finish of edges broken more than designed; of the leaning rod, which alone rides on an edge."""
        if not cam.follower.leans:
            return ()
        rod = edge_follower(cam.follower, "what a broken edge costs")
        as_built = cam_model.as_built(self.design)
        return (edges_check(self.steering, rod, cam.curve, as_built, self.car, self.travel),)

    def verdict(self, cam: CamPlan) -> PartVerdict:
        """Verdict on the cam in the car, with the cars that keep the course; an empty one of a cam not yet checked."""
        if not cam.checks:
            return PartVerdict(())
        found: CourseYield | None = None
        counted: tuple[Check, ...] = ()
        played, rides = self, isinstance(cam.follower_as_built, EdgeFollower)
        if self.comparison is None and cam.kind == ACTUAL and self.course is not None and rides and self.play_known:
            # The plain profile is planned without the comparison under play.
            compared = _plan_against_play(self.design, ACTUAL, silent, measured=_measured_cam(self.design)).application
            assert isinstance(compared, CarUse)
            played = compared
        try:
            found = course_yield(played, cam.curve)
        except DesignError as error:
            counted = (not_counted(error, self.least_yield),)
        if found is not None:
            counted = (yield_check(played, found),)
        held_back = (*reservations(played, found), *lost_lift_reservation(cam.checks))
        whole, placed = _whole(self, cam), _placed(self.in_car)
        checks = (*cam.checks, *wheel_checks(self), *whole.checks, *placed, *counted)
        return PartVerdict(checks, (*held_back, *whole.reservations))

    def purpose(self, cam: CamPlan) -> str:
        """Drive wheel, length of the path and ratio of the train."""
        wheel = self.drive_wheel
        if wheel.radius is None:
            return Message("a path of {path:.0f} mm", path=self.track.length)
        said = Message(
            "a drive wheel of {diameter:.1f} mm, a path of {path:.0f} mm",
            diameter=2 * wheel.radius,
            path=self.track.length,
        )
        turns = self.travel / (TURN * wheel.radius)
        return clauses(said, Message("{turns:.4g} turns of the wheel to one of the cam", turns=turns))

    def deciding(self, cam: CamPlan) -> tuple[str, ...]:
        """Cars that keep the course, worst end over the play, and the pressure angle, in words."""
        counted = [check for check in cam.verdict.checks if check.code == CheckCode.CARS_KEEP_COURSE]
        ends = () if self.comparison is None else (self.comparison.chosen.band.worst_distance,)
        return (
            *(
                Message("{percent:.1f} % of the cars keep the course", percent=check.value)
                for check in counted
                if isfinite(check.value)
            ),
            *(Message("the play moves the finish by {end:.1f} mm at most", end=end) for end in ends),
            *steepest(cam.checks),
        )

    @property
    def play_known(self) -> bool:
        """Whether the design says how much play the gears have."""
        return bool(variation.play_bands(self.design))

    @property
    def outlined_wheel(self) -> float | None:
        """Diameter of the drive wheel in the car's outline, mm; None if it is not said."""
        outline = self.design.car.outline
        return None if outline is None else outline.wheel_diameter_mm

    @property
    def least_yield(self) -> float:
        """Least share of random cars that must keep the course, %."""
        return self.design.checks.min_yield_percent

    @cached_property
    def in_car(self) -> CarLayout | None:
        """Train in the car; None without [layout]."""
        return laid_out(self.design)

    @property
    def sense(self) -> Reservation | None:
        """Reservation on a train that turns the cam the other way round; None if it does not, or with [layout]."""
        return None if self.in_car is not None else sense_of_train(self.design)

    @property
    def unplaced(self) -> Reservation | None:
        """Reservation on a train that does not fit the car, which is not laid out; None if nothing is known of that."""
        return layout_reservation(self.design)

    def curable(self, cam: CamPlan) -> tuple[Check, ...]:
        """Failed checks on lost lift and on the pressure angle."""
        return (*cam.lost, *(check for check in failing(cam.checks) if check.code in _STEEP))

    def changes(self, cam: CamPlan) -> Iterable[Sequence[tuple[str, str]]]:
        """A spline without kinks, a larger base circle, and a longer closing blend where lift is lost in it.

        Only blends behind the path are tried: another would steer more of the path, and no check counts that.
        """
        if self.design.path.spline == CUBIC.code:
            yield [('path.spline="quintic"', "cubic")]
        # The slope of a flank stays, so the tangent of its pressure angle falls as the radius grows.
        steep = (
            tan(radians(check.value)) / tan(radians(check.limit)) for check in self.curable(cam) if check.code in _STEEP
        )
        if 1 < (needed := max(steep, default=1.0)) < _MOST_BASE:
            base = self.design.cam.base_radius_mm
            yield [(f"cam.base_radius_mm={ceil(base * needed * factor):g}", f"{base:g}") for factor in _BASE_FACTORS]
        now, room = self.design.cam.blend_deg, degrees(TURN - self.drive_wheel.finish)
        if self.drive_wheel.blend is None and any(trim.after >= self.steering.blend_start for trim in cam.trims):
            longer = (now * factor for factor in _BLEND_FACTORS)
            yield [(f"cam.blend_deg={blend:g}", f"{now:g}") for blend in longer if blend <= room]

    def replanned(self, cam: CamPlan, override: str) -> tuple[Check, ...]:
        """Checks of the cam's profile and of the layout for a changed design; a method against play is kept."""
        design = with_overrides(self.design, [override])
        layout = laid_out(design)
        placed = _placed(layout)
        if self.comparison is None:
            return (*_plan(design, cam.kind, silent).checks, *placed)
        chosen, track = self.comparison.chosen, cam_model.track(design)
        task = task_of(design, track, cam_model.lift(design, track), cam_model.follower(design))
        work = TrainTask(task, chosen.train, known_trains(design)[chosen.train])
        return (*ProfileChecks(design, task).of(evaluate(work, chosen.profile)), *placed)

    def entry(self, cam: CamPlan) -> Facts:
        """Wheel, track, blend or laps, comparison under play, and the car as built."""
        comparison, laps, start = self.comparison, self.laps, self.steering.blend_start
        turn = Facts(
            blend=Facts(
                from_cam_angle_deg=degrees(start),
                from_track_mm=self.path_end,
                where=self.track.where(self.path_end),
            )
        )
        if laps is not None:
            runs = {} if comparison is None else {"before": comparison.before, "after": comparison.chosen}
            turn = Facts(laps=laps.entry(None if comparison is None else comparison.run, **runs))
        return (
            Facts(drive_wheel=self.drive_wheel.entry(), track_length_mm=self.track.length)
            | turn
            | Facts(play=comparison and comparison_facts(comparison), as_built=self.as_built_facts(start))
        )

    def notes(self, cam: CamPlan) -> tuple[str, ...]:
        """Sentences on what was assumed of the car, and what was measured."""
        design, comparison, laps = self.design, self.comparison, self.laps
        stop = self.wanted.blend_start
        return (
            *field_notice(design),
            *(() if self.sense is None else (sentence(self.sense.sentence),)),
            *(assumed_play(design) if comparison else ()),
            *as_built_sentences(design, stop),
            *(laps.sentences(comparison.run, comparison.before, comparison.chosen) if laps and comparison else ()),
        )

    def run_notes(self, stop: float) -> tuple[str, ...]:
        """Sentences on what was assumed of a car that runs, and what was measured.

        Args:
            stop: cam angle at which the run ends, rad.
        """
        starts = self.before_each_run
        if starts and self.comparison is not None:
            # With what it costs, where the play is known.
            task, play = self.comparison.task, max(self.comparison.band.ends)
            starts = (start_sentence(task.planned(), task.car, task.length, play),)
        return (
            *field_notice(self.design),
            *assumed_play(self.design),
            *joint_sentences(self.design),
            *as_built_sentences(self.design, stop),
            *starts,
        )

    @property
    def before_each_run(self) -> tuple[Message, ...]:
        """Advice for each start of a car whose cam a brake holds, in words."""
        if not (self.play_known and variation.braked(self.design)):
            return ()
        return (
            Message(
                "Before each run turn the drive forward until the cam moves, then set the car down: the brake leaves "
                "the cam where it stood."
            ),
        )

    def as_built_facts(self, stop: float) -> Facts | None:
        """Facts on the car as built; None for a car as designed.

        Args:
            stop: cam angle at which the path ends, rad.
        """
        return as_built_facts(self.design, stop)

    @property
    def expected(self) -> str:
        """Expected run of the car on a cam of an as-built design, in a sentence; empty if nothing was measured."""
        return outlook_sentence(self.design)

    def setting(self, cam: CamPlan) -> tuple[str, ...]:
        """Instructions where to stop the run of a car as built, and how to set the cam on its shaft."""
        return tuple(setting_sentences(self.design, self.wanted.blend_start))

    def warnings(self) -> tuple[str, ...]:
        """Effect of friction on a cam that was computed without it."""
        return (self.comparison.rubbing,) if self.comparison and self.comparison.rubbing else ()

    def frame(self, cam: CamPlan) -> str:
        """Axes of the files, in words."""
        return (
            "mm; z = 0 is the disc's inner face (the one nearer to the fork axis), +z points to the outer face; at cam "
            "angle theta the rod stands at polar angle theta, counterclockwise from +X seen from the outer face"
        )

    def drawing_notes(self, cam: CamPlan) -> tuple[str, ...]:
        """Instructions for a car as built, and how the disc sits; what its driver does stands on the card."""
        notes: tuple[str, ...] = tuple(self.setting(cam))
        if self.in_car is None or not self.in_car.turned_over:
            return notes
        over = (
            Message("In the car the disc sits turned over: the face shown points to the fork.")
            if cam.seen == Face.OUTER
            else Message("In the car the disc sits turned over: the face shown points away from the fork.")
        )
        return *notes, over

    def of_file(self, cam: CamPlan, outline: Outline, contact: Contact, limit: float) -> Figures:
        """End of the run with play on the cam of a file.

        Args:
            cam: cam that the file is of.
            outline: outline read back from the file, mm.
            contact: contact of the follower with it.
            limit: greatest error of the lift allowed to the file, mm.
        """
        comparison = self.comparison
        if comparison is None:
            return Figures()
        as_built = comparison.task.as_built
        angles = cam_angles(cam.motion)
        if as_built.shapes_discs:
            rolled = roll(as_built.finished(outline), cam.follower, angles)
        else:
            rolled = contact.at(np.searchsorted(contact.cam_angle, angles))
        # Rises and falls within the error allowed to the file are no events of the path.
        least_swing = max(comparison.chosen.least_swing, limit * 1e-3 / comparison.task.follower.inner)
        lift = rolled_lift(rolled, self.steering, blend_start=self.steering.blend_start)
        error = comparison.error_of(lift, least_swing)
        return Figures(error.figures["end_heading"], *error.end_figures.values())

    def of_loss(self, name: str, in_use: Figures, finer: str) -> tuple[str, ...]:
        """Warning if a file keeps its own tolerance, but loses the gain of the profile against play."""
        comparison = self.comparison
        if comparison is None:
            return ()
        end = in_use.value(f"{comparison.chosen.error.judged_at}_position")
        if end is None or not comparison.loses(end):
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
    """
    kind = default_profile(design) if profile is None else profile_of(profile)
    if kind.for_play or (with_play and kind is ACTUAL):
        return _plan_against_play(design, kind, progress, all_trains=all_trains, measured=_measured_cam(design))
    return _plan(design, kind, progress, judged=judged)


def _car_plan(
    use: CarUse,
    profile: ProfileKind,
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
        motion=use.steering,
        follower_as_built=rod,
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
    progress(Message("computing the {profile} profile", profile=Message(str(profile))))
    wanted = profile.curve(lift, rod)
    cut = cam_model.as_built(design).precompensated(wanted.curve)
    if not judged:
        return _car_plan(CarUse(design, track, lift), profile, rod, cut, wanted.trims, ())
    progress("checking the profile")
    limits = cam_model.check_limits(design)
    course, laps = on_course(design, track, lift), _laps(design, track, lift)
    of_cam = check_cam(
        lift, profile.rolling(rod), wanted.curve, wanted.trims, blank, limits, cut=cut, application=blend_checks
    )
    on_cut: tuple[Check, ...] = ()
    if profile.gives_lift and not profile.by_axis:
        # What lost lift costs the car on the cam that is cut for the lift wanted, and its path.
        rolled = rolled_on(cam_model.as_built(design).roll_new, cut, rod, lift, lift.blend_start)
        car, travel, start = cam_model.car(design), cam_model.travel(design, track), start_pose(track)
        given, got = (drive(each, car, travel, start=start, stop=lift.blend_start) for each in (lift, rolled))
        on_cut = (lost_lift_check(design, given, got), *cut_checks(design, track, lift, rolled, of_cam))
    checks = (
        *of_cam,
        *path_checks(design, track, lift),
        *on_cut,
        *mechanics_checks(design, rod, lift, variation.mechanics(design, rod, lift)),
        *course_checks(course),
        *(laps.checks(None) if laps else ()),
        *outlook_checks(design),
    )
    return _car_plan(CarUse(design, track, lift, None, course, laps), profile, rod, cut, wanted.trims, checks)


def _plan_against_play(
    design: Design,
    profile: ProfileKind,
    progress: Progress,
    *,
    all_trains: bool = False,
    measured: MeasuredCam | None = None,
) -> CamPlan:
    """Plan of a profile, with its comparison under play.

    A profile that keeps every check of the cam and loses the car is no better than one that brings the car in and fails
    a check: neither is ready. Of the two the second is planned, whose cure is a matter of the disc, and both are named.
    """
    progress("planning the path")
    track = cam_model.track(design)
    lift, rod = cam_model.lift(design, track), cam_model.follower(design)
    progress(Message("computing the {profile} profile", profile=Message(str(profile))))
    checks = ProfileChecks(design, task_of(design, track, lift, rod))
    comparison = against_play(profile, checks, all_trains=all_trains, measured=measured, progress=progress)
    progress("checking the profile")
    plan = _played(profile, checks, comparison, track)
    if comparison.nearer is None or not plan.failed:
        return plan
    other = _played(profile, checks, comparison.with_nearer(plan.failed), track)
    of_cam = {check.code for check in failing(other.checks)}
    lost = {check.code for check in other.failed} - of_cam
    return other if lost < {check.code for check in plan.failed} else plan


def _played(profile: ProfileKind, checks: ProfileChecks, comparison: PlayComparison, track: Track) -> CamPlan:
    """Plan of the profile that was chosen under play.

    Args:
        profile: kind of profile that was asked for.
        checks: checks of the design's profiles.
        comparison: comparison with its choice.
        track: track of the drive wheel.
    """
    design, chosen, lift = checks.design, comparison.chosen, checks.task.lift
    course, laps = on_course(design, track, lift), _laps(design, track, lift)
    of_cam = comparison.checked(checks.of(chosen))
    checked = (
        *of_cam,
        *path_checks(design, track, lift),
        *(() if chosen.profile.for_play else cut_checks(design, track, lift, chosen.rolled, of_cam)),
        *course_checks(course, comparison),
        *(laps.checks(chosen) if laps else ()),
        *outlook_checks(design),
    )
    use = CarUse(design, track, chosen.lift, comparison, course, laps)
    return _car_plan(use, profile, cam_model.follower(design), chosen.cut, chosen.wanted.trims, checked)


def _measured_cam(design: Design) -> MeasuredCam | None:
    """Cam that was on the car when the car was measured, as made then; None if the design has no [as_built]."""
    if design.as_built is None:
        return None
    profile, then = profile_of(design.as_built.profile), design.as_cut().model_copy(update={"course": None})
    planned = _plan_against_play if profile.for_play else _plan
    plan = planned(then, profile, silent)
    return MeasuredCam(profile=profile, lift=CarUse.of(plan).steering, curve=plan.on_shaft)


def comparison_of(plan: CamPlan) -> PlayComparison:
    """Comparison of a plan's profile with the plain profile under play.

    Raises:
        DesignError: the profile is not for play.
    """
    comparison = CarUse.of(plan).comparison
    if comparison is None:
        choices = listed(codes(for_play=True), "or")
        raise DesignError(
            'the profile "{kind}" does nothing about play: choose {choices}', kind=plan.kind, choices=choices
        )
    return comparison


def _whole(use: CarUse, cam: CamPlan) -> PartVerdict:
    """Verdict on the car as a whole; without a layout on a stated mass alone, and nothing of its parts is loaded."""
    if use.in_car is None:
        rod = cam.follower_as_built
        return energy_verdict(use.design, use.track, use.wanted, rod, use.car, use.drive_wheel)
    from cadgen.jobs.assembly_checks import verdict_on_car

    return verdict_on_car(cam)


def _placed(layout: CarLayout | None) -> tuple[Check, ...]:
    """Checks of the parts in a car; none without a layout, where nothing of the frame is loaded."""
    if layout is None:
        return ()
    from cadgen.jobs.car_frame import checks_in_car

    return checks_in_car(layout)


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
