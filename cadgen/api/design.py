"""A design and its jobs: cam, gears, runs, calibration."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING

from cadgen.api.loaded import LoadedDesign
from cadgen.api.measured import Data, reading_of, sources_of
from cadgen.api.values import instance, map_of, optional, whole, word
from cadgen.design import load
from cadgen.design.schema import MotionDesign
from cadgen.errors import DesignError, FileError
from cadgen.gears.choices import Order
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.api.adjustment import Adjustment
    from cadgen.api.assembly import AssembledCar, FramedCar
    from cadgen.api.calibration import Advice, Calibration, Calibrations
    from cadgen.api.cam import Cam
    from cadgen.api.comparison import Comparison
    from cadgen.api.found_cam import ComparedCam, FoundCam
    from cadgen.api.measured_gears import MeasuredGear, MeasuredTrain
    from cadgen.api.planning import Plan
    from cadgen.api.values import Pool
    from cadgen.inference.monte_carlo.random_cars import Map
    from cadgen.jobs.calibration.workshop import Workshop
    from cadgen.jobs.card import Card
    from cadgen.jobs.gears.gear_train import GearTrain
    from cadgen.jobs.lift_tolerance import LiftToleranceRun
    from cadgen.jobs.simulation import Simulation
    from cadgen.jobs.tolerance import ToleranceRun

MOST_CARS, MOST_PROCESSES = 10_000_000, 256
FORM_ERROR_UM = (0.01, 1000.0)
_WITHIN_MM = 25.0


@dataclass(frozen=True, repr=False)
class Design(LoadedDesign):
    """A design: path, car, cam, follower, gear train. `load` and `from_toml` read one; `with_` gives a changed copy.

    Attributes:
        values: values of all keys, checked, with defaults; as in docs/design-file.md.
        text: text of the design file, before overrides.
        file: path of the design file; for a design from text, its name with the ending .toml.

    Example:
        >>> from cadgen import Design
        >>> design = Design.load("carbon_free_car").with_({"cam.thickness_mm": 3.2})
        >>> design.values.cam.thickness_mm
        3.2
    """

    def cam(self, profile: str | None = None, *, progress: Progress = silent) -> "Cam":
        """Compute the cam and check it; nothing is written.

        Args:
            profile: `actual`, `optimized`, `compensated`, `smoothed`, `smoothed+compensated`, `theoretical` or
                `published`. If left out, `optimized` for a design with [train] or [play], else `actual`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the path cannot be driven, there is no such profile, or nothing is known of the play that it
                is for.
        """
        from cadgen.api.cam import Cam

        # Each where it is used: a cam by its motion needs nothing of a car, nor a car's cam the rooms of the other.
        if isinstance(self.values, MotionDesign):
            from cadgen.jobs.cam.motion_cam import plan_motion_cam

            return Cam.of(plan_motion_cam(self.values, profile, progress))
        from cadgen.jobs.cam.steering_cam import plan_cam

        return Cam.of(plan_cam(self.complete(), profile, progress))

    def gears(self, order: str = "as-given", *, progress: Progress = silent) -> "GearTrain":
        """Compute the gear train, lay it out, and measure its teeth in mesh; nothing is written.

        Args:
            order: `as-given`; `reordered`, the order of the stages with the least return error; or `search`, the best
                teeth within [train.search].
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the order is unknown, or the train is missing or cannot be made or laid out.
        """
        from cadgen.jobs.gears.gear_train import plan_gears

        return plan_gears(self.values, Order(word("order", order, [each.value for each in Order])), progress)

    def assembly(self, profile: str | None = None, *, progress: Progress = silent) -> "AssembledCar":
        """Put the car together: disc, train, shafts, wheels, fork and rod at their places; nothing is written.

        Args:
            profile: profile of the cam, as of `cam`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam` and `gears`, or the design has no [layout], or no room for its parts.
        """
        from cadgen.api.assembly import AssembledCar
        from cadgen.jobs.cam.steering_cam import plan_cam
        from cadgen.jobs.car_assembly import put_together

        design = self.complete()
        train = self.gears(progress=progress)
        return AssembledCar(put_together(plan_cam(design, profile, progress), train))

    def frame(self) -> "FramedCar":
        """Compute the frame that holds the parts where [layout] puts them; nothing is written.

        Raises:
            DesignError: the design has no [frame], or its train finds no place in the car.
        """
        from cadgen.api.assembly import FramedCar
        from cadgen.jobs.car_frame import car_frame

        return FramedCar(car_frame(self.values))

    def simulate(
        self, profile: str = "optimized", play_deg: float | None = None, *, progress: Progress = silent
    ) -> "Simulation[Cam]":
        """Run the car with play in its gears, on the actual profile and on one against play.

        Args:
            profile: `optimized`, `compensated`, `smoothed` or `smoothed+compensated`.
            play_deg: return error of the runs at the camshaft, degrees, 0 to 180; if left out, the play for which
                the profile is cut.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam`, or the play is out of its range.
        """
        from cadgen.api.cam import Cam
        from cadgen.jobs.cam.steering_cam import plan_cam
        from cadgen.jobs.simulation import simulated

        play = optional("play_deg", play_deg, 0, 180, "degrees")
        return simulated(Cam.of(plan_cam(self.complete(), profile, progress)), play, progress)

    def optimize(self, *, progress: Progress = silent) -> "Comparison":
        """Compare the methods against play, alone and combined, on every train, and choose the best.

        Args:
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: nothing is known of the play.
        """
        from cadgen.api.cam import Cam
        from cadgen.api.comparison import Comparison
        from cadgen.jobs.cam.lever import remedies_of
        from cadgen.jobs.cam.steering_cam import comparison_of, plan_cam

        design = self.complete()
        plan = plan_cam(design, "optimized", progress, all_trains=True)
        known = comparison_of(plan)
        return Comparison(Cam.of(plan), remedies_of(plan, progress) if known.task.mechanics else ())

    def tolerance(
        self,
        samples: int = 10_000,
        *,
        map: "Pool | Map | None" = None,  # the word that pools use
        seed: int = 1,
        profile: str = "optimized",
        budget: bool = False,
        processes: int = 1,
        workshop: str | PathLike[str] | None = None,
        progress: Progress = silent,
    ) -> "ToleranceRun[Cam]":
        """Run random cars within the tolerances of [tolerances] and [train].

        Args:
            samples: number of cars, 1 to 10 000 000.
            map: a pool, which is anything with a method `map`, or a function like the built-in `map`; it runs the
                cars. The numbers do not depend on it.
            seed: seed of the random numbers, 0 or more.
            profile: profile that all cars have.
            budget: whether all deviations are ranked, too.
            processes: number of processes that run at once if no `map` is given, 1 to 256.
            workshop: file of what the cars of the workshop differ by, as `calibrate_each` writes it.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam`, or nothing varies.
            FileError: the memory does not suffice for so many cars.
        """
        from cadgen.api.cam import Cam
        from cadgen.jobs.cam.steering_cam import plan_cam
        from cadgen.jobs.tolerance import CarSample, tolerance_of

        sample = CarSample(
            samples=whole("samples", samples, 1, MOST_CARS),
            seed=whole("seed", seed, 0),
            processes=whole("processes", processes, 1, MOST_PROCESSES),
            with_budget=budget,
            map_with=map_of(map),
        )
        design = self.complete()
        known = _workshop(workshop, design.name)
        return tolerance_of(Cam.of(plan_cam(design, profile, progress, with_play=True)), sample, progress, known)

    def lift_tolerance(
        self, samples: int = 10_000, *, seed: int = 1, progress: Progress = silent
    ) -> "LiftToleranceRun":
        """Errors of the lift of random cams within [lift_tolerances], for a cam by its motion.

        Args:
            samples: number of cams, 1 to 1 000 000.
            seed: seed of the random numbers, 0 or more.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design is of a car, nothing varies, or the follower's kind does not say what it does.
        """
        from cadgen.jobs.lift_tolerance import MOST_CAMS, run_lift_tolerance

        design = self.values
        if not isinstance(design, MotionDesign):
            raise DesignError(
                "errors of the lift are worked out for a design with [motion], and this one is of a car: tolerance "
                "runs its cars"
            )
        return run_lift_tolerance(design, whole("samples", samples, 1, MOST_CAMS), whole("seed", seed, 0), progress)

    def calibrate(
        self,
        data: Data | Iterable[Data],
        *,
        profile: str | None = None,
        form_error_um: float | None = None,
        columns: Mapping[str, str] | None = None,
        workshop: str | PathLike[str] | None = None,
        progress: Progress = silent,
    ) -> "Calibration[Design]":
        """Trace measured data of one car to the effects that the design lacks.

        Args:
            data: measured data, judged together: paths of CSV files, mappings of columns to arrays, `Measured`.
            profile: profile of the cam that was measured, or was on the car; left out, the one that the data's remarks
                say, or actual, and no cam is made if the data fit another one.
            form_error_um: form error to expect on the disc, µm rms, 0.01 to 1000; if left out, 2, or 30 for a disc that
                is printed by a remark of the data.
            columns: columns of a kind of data -> names that they have in the files, as `{"x_mm": "East [m]"}`, where
                those are not understood.
            workshop: file of what the cars of the workshop differ by, as `calibrate_each` writes it.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam`, or the form error is out of its range.
            FileError: data cannot be read, or cannot be judged together.
        """
        from cadgen.api.calibration import Calibration
        from cadgen.jobs.calibration.calibration import calibrate

        error, design = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm"), self.complete()
        sources = sources_of(data, reading_of(design, columns), progress=progress)
        computed = calibrate(design, profile, sources, error, progress, workshop=_workshop(workshop, design.name))
        return Calibration.of(computed, Design(design, self.text, self.file))

    def find_motion(
        self,
        data: Data | Iterable[Data],
        *,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> "FoundCam":
        """Find the motion of a measured cam that is not known: dwells, laws and ends of segments, and wear.

        Args:
            data: record of the whole cam: points of its outline (`x_mm`, `y_mm`), radii (`polar_angle_deg`,
                `radius_mm`), or lifts (`cam_angle_deg`, and `lift_mm` or `lift_deg`); a path, or columns.
            columns: as of `calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design states its motion, or its follower is one whose motion is not found.
            FileError: data cannot be read, or show no motion.
        """
        from cadgen.api.found_cam import FoundCam
        from cadgen.inference.motions.record_kinds import kinds_for
        from cadgen.jobs.worn_cam.found_cam import find_cam

        design = self.values
        if not isinstance(design, MotionDesign) or not design.motion.measured:
            raise DesignError(
                "a motion is found for a design that has motion.measured = true, instead of one that it states: set "
                "that, and leave the motion out"
            )
        known = kinds_for(design.follower.registered.unit)
        sources = sources_of(data, reading_of(design, columns), known=known, progress=progress)
        return FoundCam.of(find_cam(design, self.text, sources, progress))

    def compare_cam(
        self,
        data: Data | Iterable[Data],
        *,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> "ComparedCam":
        """Find what differs in a measured cam whose motion is known: disc, follower, phase, bore, wrong side up.

        Args:
            data: record of the whole cam, as of `find_motion`: points of its outline about the bore, or lifts.
            columns: as of `calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design is of a car or does not state its motion, or no cam can be made of it.
            FileError: data cannot be read.
        """
        from cadgen.api.found_cam import ComparedCam
        from cadgen.inference.motions.record_kinds import kinds_for
        from cadgen.jobs.worn_cam.compared_cam import compare_cam

        design = self.values
        if not isinstance(design, MotionDesign):
            raise DesignError(
                "a measured cam is compared with a design that has [motion], and this one is of a car: calibrate "
                "judges its data"
            )
        known = kinds_for(design.follower.registered.unit)
        sources = sources_of(data, reading_of(design, columns), known=known, progress=progress)
        return ComparedCam.of(compare_cam(design, sources, progress))

    def judge_train(
        self,
        data: Data | Iterable[Data],
        *,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> "MeasuredTrain":
        """Find what a measured train has: play, wind-up, run-out by wheel, tooth mesh, and what to change.

        Args:
            data: records of angles at both ends, judged together: `input_angle_deg`, `output_angle_deg`, and
                `output_torque_Nm` under load; paths, or columns.
            columns: as of `calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design has no train.
            FileError: data cannot be read, or cannot be judged.
        """
        from cadgen.api.measured_gears import MeasuredTrain
        from cadgen.inference.gearing.record_kinds import KINDS
        from cadgen.jobs.measured_gears.measured_train import judge_train

        sources = sources_of(data, reading_of(self.values, columns), known=KINDS, progress=progress)
        return MeasuredTrain.of(judge_train(self.values, self.text, sources, progress))

    def judge_gear(
        self,
        data: Data | Iterable[Data],
        *,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> "MeasuredGear":
        """Find what one measured gear of the train has: deviations by ISO 1328-1:2013, its errors, its thickness.

        Args:
            data: records of one gear, judged together: `tooth`, `flank`, and `pitch_um` or `index_um`, `roll_length_mm`
                with `profile_um`, `face_mm` with `helix_um`; or spans, or sizes over balls; paths, or columns.
            columns: as of `calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design has no train of pairs.
            FileError: data cannot be read, or do not say which gear they are of.
        """
        from cadgen.api.measured_gears import MeasuredGear
        from cadgen.inference.gearing.flank_kinds import GEAR_KINDS
        from cadgen.jobs.measured_gears.measured_gear import judge_gear

        sources = sources_of(data, reading_of(self.values, columns), known=GEAR_KINDS, progress=progress)
        return MeasuredGear.of(judge_gear(self.values, self.text, sources, progress))

    def judge_gears(
        self,
        data: Data | Iterable[Data],
        *,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> "MeasuredGear | MeasuredTrain":
        """Judge one gear or the whole train, as the columns of the data say; arguments and errors as of both."""
        from cadgen.api.measured_gears import MeasuredGear, MeasuredTrain
        from cadgen.inference.gearing.flank_kinds import GEAR_KINDS
        from cadgen.inference.gearing.record_kinds import KINDS
        from cadgen.jobs.measured_gears.measured_gear import judge_gear
        from cadgen.jobs.measured_gears.measured_train import judge_train

        both = (*KINDS, *GEAR_KINDS)
        sources = sources_of(data, reading_of(self.values, columns), known=both, progress=progress)
        of_gear = [source.kind in GEAR_KINDS for source in sources]
        if any(of_gear) and not all(of_gear):
            raise FileError(
                "{file} is of one gear, and others are of the whole train: judge them one after the other",
                file=sources[of_gear.index(True)].path.name,
            )
        if all(of_gear):
            return MeasuredGear.of(judge_gear(self.values, self.text, sources, progress))
        return MeasuredTrain.of(judge_train(self.values, self.text, sources, progress))

    def next_measurement(
        self,
        *,
        profile: str | None = None,
        form_error_um: float | None = None,
        workshop: str | PathLike[str] | None = None,
        progress: Progress = silent,
    ) -> "Advice":
        """Rank what to measure first on a car of this design; `Calibration.next_measurement` does it after data.

        Arguments and errors as in `calibrate`.
        """
        from cadgen.car.against_play.profile_kinds import ACTUAL
        from cadgen.jobs.calibration.advice import Advice

        error, design = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm"), self.complete()
        known = _workshop(workshop, design.name)
        return Advice.first(design, profile or ACTUAL.code, error, progress, known)

    def calibrate_each(
        self,
        data: Iterable[Data],
        *,
        profile: str | None = None,
        form_error_um: float | None = None,
        columns: Mapping[str, str] | None = None,
        workshop: str | PathLike[str] | None = None,
        progress: Progress = silent,
    ) -> "Calibrations[Design]":
        """Judge measured data one by one, as if each came from another car; arguments and errors as in `calibrate`.

        Of three cars and more the result has what they differ by, and its `write` a file of that, `workshop.toml`.
        """
        from cadgen.api.calibration import Calibration, Calibrations
        from cadgen.jobs.calibration.calibration import calibrate_each

        error, design = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm"), self.complete()
        sources = sources_of(data, reading_of(design, columns), each=True, progress=progress)
        computed = calibrate_each(design, profile, sources, error, progress, _workshop(workshop, design.name))
        return Calibrations(tuple(Calibration.of(result, Design(design, self.text, self.file)) for result in computed))

    def adjust(
        self,
        trials: str | PathLike[str] | Iterable[str | PathLike[str]],
        *,
        profile: str = "optimized",
        point: str = "drive-wheel",
        settings: Iterable[str] = ("head", "start"),
        noise_mm: float = 10.0,
        division_um: float = 10.0,
        columns: Mapping[str, str] | None = None,
        progress: Progress = silent,
    ) -> "Adjustment":
        """Settings of micrometer head, key and start that bring the next run to its end, from trial runs.

        Args:
            trials: CSV files of measured points, in the order of driving (docs/how-to/adjust.md).
            profile: of the cam on the car.
            point: of the car that was measured: `drive-wheel`, `fork`, `idle-wheel`, or `path`, the point that is to
                follow the waypoints.
            settings: what may be set: `head`, `key`, `start`.
            noise_mm: standard deviation of a measured coordinate, mm, 0.1 to 1000.
            division_um: of the micrometer head, µm, 0.1 to 1000.
            columns: as of `calibrate`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `tolerance`, or no such point, setting, noise or division.
            FileError: files that cannot be read or are no trial runs.
        """
        from cadgen.api.adjustment import adjusted

        design = self.complete()
        reading = reading_of(design, columns)
        return adjusted(design, trials, profile, point, settings, noise_mm, division_um, reading, progress)

    def plan(
        self,
        improve: "Design | None" = None,
        within_mm: float | None = None,
        *,
        calm_as: "Design | None" = None,
        reserve: float | None = None,
        seeds: int = 1,
        map: "Pool | Map | None" = None,
        progress: Progress = silent,
    ) -> "Plan[Design]":
        """Plan the path on which most cars keep the course and play moves them least.

        The design needs [course]; load one without [path] with `train_only=True`.

        Args:
            improve: design whose path is improved and not planned from scratch; its start and finish stay.
            within_mm: how far the drive wheel's track may leave that path, mm, 0.1 to 1000; 25 if left out.
            calm_as: design whose path's slopes of the curvature are not exceeded; `improve` if left out, or none.
            reserve: room at gates and obstacles as a factor on the scatter of cars, 0 to 10; by yield if left out.
            seeds: number of searches, each from another path, 1 to 100; the best one counts.
            map: as for `tolerance`; it runs several searches.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design has no course or no start, or a number is out of its range.
        """
        from cadgen.api.planning import Plan
        from cadgen.car.planner import RESERVE, SEEDS, WITHIN_MM
        from cadgen.design import cam_model
        from cadgen.jobs.planning.plan import PlanRequest, plan_design

        room = optional("reserve", reserve, *RESERVE, "times the scatter of the cars")
        within = optional("within_mm", within_mm, *WITHIN_MM, "mm")
        if within is not None and improve is None:
            raise DesignError("within_mm says how far a given path may be left: give improve too, or leave it out")
        given = None if improve is None else instance("improve", improve, Design).complete()
        calmer = given if calm_as is None else instance("calm_as", calm_as, Design).complete()
        known, drawn = load.course_of(self.text, self.file, self.values.overrides)
        before = known if drawn else None
        request = PlanRequest(
            near=None if given is None else cam_model.track(given),
            within=_WITHIN_MM if within is None else within,
            calm=None if calmer is None else cam_model.track(calmer),
            seeds=whole("seeds", seeds, *SEEDS),
            map_with=map_of(map),
            replaced=before if given is None else known.model_copy(update={"path": given.path}),
            reserve=room,
        )
        own = cam_model.track(known) if drawn else None
        return Plan.of(plan_design(known, self.text, own, request, progress), self)

    def card(self, profile: str | None = None, *, progress: Progress = silent) -> "Card[Cam]":
        """Find what to set, by [settings], for each spacing of [course.spacing]; arguments and errors as in `cam`."""
        from cadgen.api.cam import Cam
        from cadgen.jobs.cam.steering_cam import plan_cam
        from cadgen.jobs.card import card_of, draw_of

        design = self.complete()
        draw = draw_of(design)
        return card_of(design, Cam.of(plan_cam(design, profile, progress)), draw, progress)


def _workshop(file: str | PathLike[str] | None, design: str) -> "Workshop | None":
    """Workshop's file of a design by its name, if one is given."""
    if file is None:
        return None
    from pathlib import Path

    from cadgen.jobs.calibration.workshop import read_workshop

    return read_workshop(Path(file), design)
