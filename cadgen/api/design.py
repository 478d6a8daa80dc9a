"""A design and its jobs: cam, gears, runs, calibration."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.api.measured import Data, sources_of
from cadgen.api.overrides import overrides_of
from cadgen.api.values import name_or_path, optional, plain_text, whole, word
from cadgen.design import load
from cadgen.design.schema import Design as DesignValues
from cadgen.design.schema import TrainDesign
from cadgen.errors import brief
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.api.adjustment import Adjustment
    from cadgen.api.advice import Advice
    from cadgen.api.calibration import Calibration, Calibrations
    from cadgen.api.cam import Cam
    from cadgen.api.card import Card
    from cadgen.api.gears import GearTrain
    from cadgen.api.planning import Plan
    from cadgen.api.runs import Comparison, Pool, Simulation, ToleranceRun
    from cadgen.monte_carlo.robust import Map

ORDERS = ("as-given", "reordered", "search")
MOST_CARS, MOST_PROCESSES = 10_000_000, 256
FORM_ERROR_UM = (0.01, 1000.0)


@dataclass(frozen=True, repr=False)
class Design:
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

    values: TrainDesign
    text: str
    file: Path

    @classmethod
    def load(
        cls,
        source: str | PathLike[str] | None = None,
        changes: Mapping[str, Any] | Iterable[str] = (),
        *,
        train_only: bool = False,
    ) -> "Design":
        """Read a design and check it.

        Args:
            source: name of a packaged design, or path of a TOML file; the paper's car if left out.
            changes: changes as for `with_`, applied before the checks.
            train_only: whether only the gear train is used: sections of the cam may then be missing.

        Raises:
            DesignError: no such design, a file that is not TOML, or values that are not allowed. The message has a
                sentence for each of up to five errors, with the key and what is allowed.
        """
        text, file = load.read_design(name_or_path("source", source))
        return cls._checked(text, file, overrides_of(changes), train_only)

    @classmethod
    def from_toml(cls, text: str, name: str = "design", *, train_only: bool = False) -> "Design":
        """Make a design from the text of a design file; errors as in `load`.

        Args:
            text: text of the design in TOML.
            name: name of the design, if the text has none.
            train_only: same as for `load`.
        """
        return cls._checked(plain_text("text", text), Path(f"{name}.toml"), (), train_only)

    @classmethod
    def new(
        cls,
        name: str,
        folder: str | PathLike[str] = ".",
        *,
        points: str | PathLike[str] | None = None,
        layer: str | None = None,
        gate_radius_mm: float = 50.0,
        field_mm: tuple[float, float] | None = None,
        closed: bool = False,
        changes: Mapping[str, Any] | Iterable[str] = (),
    ) -> "Design":
        """Begin a design: write a commented file with the paper's mechanism and a path, and load it.

        Args:
            name, folder: name of the design and, with .toml, of its file; folder for that.
            points, layer: file of the path's points, CSV, TXT or DXF; layer of the polyline in a DXF with several.
            gate_radius_mm, field_mm: radius of the gates at the points; width and height of the field.
            closed: whether the path is a lap.
            changes: changes as for `with_`, written into the file.

        Raises:
            DesignError, FileError: values that are not allowed; points that cannot be read, a file that is there.
        """
        from cadgen.design.begin import begin, points_of, write_new

        path, changed = points_of(points, layer, closed=closed), overrides_of(changes)
        text, file = begin(name, path, changed, gate_radius_mm, field_mm, closed), Path(folder) / f"{name}.toml"
        write_new(text, file)
        return cls._checked(text, file, (), False)

    @classmethod
    def _checked(cls, text: str, file: Path, overrides: tuple[str, ...], train_only: bool) -> "Design":
        return cls((load.train_of if train_only else load.design_of)(text, file, overrides), text, file)

    def with_(self, changes: Mapping[str, Any] | Iterable[str]) -> "Design":
        """The design with some keys changed, by the same rules as `--set` on the command line.

        Args:
            changes: new value by key, such as `{"cam.thickness_mm": 3.2, "path.waypoints_mm.3": [1, 2]}`. List items
                count from 1; None removes a key or a section. Texts `key=value` are taken, too.

        Raises:
            DesignError: a key is unknown, or the result is no design; in the words of the command line.
        """
        overrides = (*self.values.overrides, *overrides_of(changes))
        return self._checked(self.text, self.file, overrides, not isinstance(self.values, DesignValues))

    def __repr__(self) -> str:
        changed = f", changed by {brief(' '.join(self.values.overrides), 80)}" if self.values.overrides else ""
        return f"<Design {self.name} of {self.file.name}{changed}>"

    @property
    def name(self) -> str:
        """Name of the design; the names of exported files begin with it."""
        return self.values.name

    @property
    def sha256(self) -> str:
        """SHA-256 of the values of the design, hexadecimal, as in manifests."""
        return self.values.content_hash

    def cam(self, profile: str | None = None, *, progress: Progress = silent) -> "Cam":
        """Compute the cam and check it; nothing is written.

        Args:
            profile: `actual`, `optimized`, `compensated`, `smoothed`, `smoothed+compensated`, `theoretical` or
                `published`. If left out, `optimized` for a design with [train] or [play], else `actual`.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the path cannot be driven, there is no such profile, or nothing is known of the play that it
                is for.
            CheckError: no profile keeps the limits of [optimize].
        """
        from cadgen.api.cam import Cam
        from cadgen.workflow.cam.plan import plan_cam

        return Cam(plan_cam(self.complete(), profile, progress))

    def gears(self, order: str = "as-given", *, progress: Progress = silent) -> "GearTrain":
        """Compute the gear train, lay it out, and measure its teeth in mesh; nothing is written.

        Args:
            order: `as-given`; `reordered`, the order of the stages with the least return error; or `search`, the best
                teeth within [train.search].
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the order is unknown, or the train is missing or cannot be made or laid out.
        """
        from cadgen.api.gears import GearTrain
        from cadgen.workflow.gears.plan import plan_gears

        wanted: Any = word("order", order, ORDERS)
        return GearTrain(plan_gears(self.values, wanted, progress))

    def simulate(
        self, profile: str = "optimized", play_deg: float | None = None, *, progress: Progress = silent
    ) -> "Simulation":
        """Run the car with play in its gears, on the actual profile and on one against play.

        Args:
            profile: `optimized`, `compensated`, `smoothed` or `smoothed+compensated`.
            play_deg: return error of the runs at the camshaft, degrees, 0 to 180; if left out, the play for which
                the profile is cut.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam`, or the play is out of its range.
            CheckError: no profile keeps the limits of [optimize].
        """
        from cadgen.api import runs
        from cadgen.workflow.runs import simulation

        play = optional("play_deg", play_deg, 0, 180, "degrees")
        return runs.Simulation(simulation.simulate(self.complete(), profile, play, progress))

    def optimize(self, *, progress: Progress = silent) -> "Comparison":
        """Compare the methods against play, alone and combined, on every train, and choose the best.

        Args:
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: nothing is known of the play.
            CheckError: no profile keeps the limits of [optimize].
        """
        from cadgen.api import cam, runs
        from cadgen.workflow.cam.plan import comparison_of, plan_cam
        from cadgen.workflow.cam.remedies import remedies

        design = self.complete()
        plan = plan_cam(design, "optimized", progress, all_trains=True)
        known = comparison_of(plan)
        return runs.Comparison(cam.Cam(plan), remedies(design, known, progress) if known.task.mechanics else ())

    def tolerance(
        self,
        samples: int = 10_000,
        *,
        map: "Pool | Map | None" = None,  # the word that pools use
        seed: int = 1,
        profile: str = "actual",
        budget: bool = False,
        processes: int = 1,
        progress: Progress = silent,
    ) -> "ToleranceRun":
        """Run random cars within the tolerances of [tolerances] and [train].

        Args:
            samples: number of cars, 1 to 10 000 000.
            map: a pool, which is anything with a method `map`, or a function like the built-in `map`; it runs the
                cars. The numbers do not depend on it.
            seed: seed of the random numbers, 0 or more.
            profile: profile that all cars have.
            budget: whether all deviations are ranked, too.
            processes: number of processes that run at once if no `map` is given, 1 to 256.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam`, or nothing varies.
            CheckError: no profile keeps the limits of [optimize].
            FileError: the memory does not suffice for so many cars.
        """
        from cadgen.api import runs
        from cadgen.workflow.runs.tolerance import run_tolerance

        return runs.ToleranceRun(
            run_tolerance(
                self.complete(),
                profile,
                whole("samples", samples, 1, MOST_CARS),
                whole("seed", seed, 0),
                whole("processes", processes, 1, MOST_PROCESSES),
                progress,
                with_budget=budget,
                map_with=runs.map_of(map),
            )
        )

    def calibrate(
        self,
        data: Data | Iterable[Data],
        *,
        profile: str = "actual",
        form_error_um: float | None = None,
        progress: Progress = silent,
    ) -> "Calibration[Design]":
        """Trace measured data of one car to the effects that the design lacks.

        Args:
            data: measured data, judged together: paths of CSV files, mappings of columns to arrays, `Measured`.
            profile: profile of the cam that was measured, or was on the car.
            form_error_um: form error to expect on the disc, µm rms, 0.01 to 1000; if left out, 2, or 30 for a disc that
                is printed by a remark of the data.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `cam`, or the form error is out of its range.
            FileError: data cannot be read, or cannot be judged together.
        """
        from cadgen.api.calibration import Calibration
        from cadgen.workflow.calibration.plan import calibrate

        error, design = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm"), self.complete()
        computed = calibrate(design, profile, sources_of(data, progress=progress), error, progress)
        return Calibration(computed, Design(design, self.text, self.file))

    def next_measurement(
        self, *, profile: str = "actual", form_error_um: float | None = None, progress: Progress = silent
    ) -> "Advice":
        """Rank what to measure first on a car of this design; `Calibration.next_measurement` does it after data.

        Arguments and errors as in `calibrate`.
        """
        from cadgen.api.advice import Advice
        from cadgen.workflow.calibration.advice import before

        error = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm")
        return Advice(before(self.complete(), profile, error, progress), measured=False)

    def calibrate_each(
        self,
        data: Iterable[Data],
        *,
        profile: str = "actual",
        form_error_um: float | None = None,
        progress: Progress = silent,
    ) -> "Calibrations[Design]":
        """Judge measured data one by one, as if each came from another car; arguments and errors as in `calibrate`."""
        from cadgen.api.calibration import Calibration, Calibrations
        from cadgen.workflow.calibration.plan import calibrate_each

        error, design = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm"), self.complete()
        computed = calibrate_each(design, profile, sources_of(data, each=True, progress=progress), error, progress)
        return Calibrations(tuple(Calibration(result, Design(design, self.text, self.file)) for result in computed))

    def adjust(
        self,
        trials: str | PathLike[str] | Iterable[str | PathLike[str]],
        *,
        profile: str = "optimized",
        point: str = "drive-wheel",
        knobs: Iterable[str] = ("head", "start"),
        noise_mm: float = 10.0,
        division_um: float = 10.0,
        progress: Progress = silent,
    ) -> "Adjustment":
        """Settings of micrometer head, key and start that bring the next run to its end, from trial runs.

        Args:
            trials: CSV files of measured points, in the order of driving (docs/how-to/adjust.md).
            profile: of the cam on the car.
            point: of the car that was measured: `drive-wheel`, `fork`, `idle-wheel`, or `path`, the point that is to
                follow the waypoints.
            knobs: what may be set: `head`, `key`, `start`.
            noise_mm: standard deviation of a measured coordinate, mm, 0.1 to 1000.
            division_um: of the micrometer head, µm, 0.1 to 1000.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: as `tolerance`, or no such point, knob, noise or division.
            FileError: files that cannot be read or are no trial runs.
        """
        from cadgen.api.adjustment import adjusted

        return adjusted(self.complete(), trials, profile, point, knobs, noise_mm, division_um, progress)

    def plan(
        self,
        improve: "Design | None" = None,
        within_mm: float | None = None,
        *,
        calm_as: "Design | None" = None,
        seeds: int = 1,
        map: "Pool | Map | None" = None,
        progress: Progress = silent,
    ) -> "Plan[Design]":
        """Plan the path that keeps the course and is least sensitive to the play of the gears.

        The design needs [course]; where it has no [path], load it with `train_only=True`.

        Args:
            improve: design whose path is improved and not planned from scratch; its start and finish stay.
            within_mm: how far the drive wheel's track may leave that path, mm, 0.1 to 1000; 25 if left out.
            calm_as: design whose path has the greatest slopes of the curvature that are allowed; that of `improve` if
                left out, else only the cam's own limits count.
            seeds: number of searches, each from another path, 1 to 100; the best one counts.
            map: as for `tolerance`; it runs several searches.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: the design has no course or no start, or a number is out of its range.
        """
        from cadgen.api.planning import planned

        others = None if improve is None else improve.complete(), None if calm_as is None else calm_as.complete()
        course = load.course_of(self.text, self.file, self.values.overrides)
        return planned(self, self.text, course, others, within_mm, seeds, map, progress)

    def card(self, profile: str | None = None, *, progress: Progress = silent) -> "Card":
        """Find what to set, by [settings], for each spacing of [course.spacing]; arguments and errors as in `cam`."""
        from cadgen.api.card import Card
        from cadgen.workflow.card.plan import plan_card

        return Card(plan_card(self.complete(), profile, progress))

    def complete(self) -> DesignValues:
        """The design, if it has all that a cam needs."""
        known = self.values
        return known if isinstance(known, DesignValues) else load.design_of(self.text, self.file, known.overrides)
