"""A design, and what can be done with it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.api.files import Progress, Written, folder_of, silent
from cadgen.api.measured import Data, sources_of
from cadgen.api.overrides import overrides_of
from cadgen.api.values import name_or_path, optional, plain_text, whole, word
from cadgen.design import load
from cadgen.design.schema import Design as DesignValues
from cadgen.design.schema import TrainDesign
from cadgen.errors import brief

if TYPE_CHECKING:
    from cadgen.api.cam import Cam
    from cadgen.api.gears import GearTrain
    from cadgen.api.runs import Comparison, Pool, Simulation, ToleranceRun
    from cadgen.monte_carlo.robust import Map
    from cadgen.report.text import Block
    from cadgen.workflow.calibration import plan as calibrations

ORDERS = ("as-given", "reordered", "search")
MOST_CARS, MOST_PROCESSES = 10_000_000, 256
FORM_ERROR_UM = (0.01, 1000.0)
_REPORT_WIDTH = 110


@dataclass(frozen=True, repr=False)
class Design:
    """A design: path, car, cam, follower, gear train. It is never changed; `with_` gives another one.

    Make one with `load` or `from_toml`.

    Attributes:
        values: everything that the design says, checked, with defaults; as in docs/design-file.md.
        text: of the design file, before overrides.
        file: that the text stands in, or is named after.

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
            changes: as for `with_`, applied before anything is checked.
            train_only: True if only the gear train is wanted: sections of the cam may then be missing.

        Raises:
            DesignError: no such design, a file that is not TOML, or values that cannot be: a sentence for each of up
                to five errors, with the key and what is allowed.
        """
        text, file = load.read_design(name_or_path("source", source))
        return cls._checked(text, file, overrides_of(changes), train_only)

    @classmethod
    def from_toml(cls, text: str, name: str = "design", *, train_only: bool = False) -> "Design":
        """A design from the text of a design file; errors as in `load`.

        Args:
            text: TOML.
            name: of the design, if the text does not say it.
            train_only: as for `load`.
        """
        return cls._checked(plain_text("text", text), Path(f"{name}.toml"), (), train_only)

    @classmethod
    def _checked(cls, text: str, file: Path, overrides: tuple[str, ...], train_only: bool) -> "Design":
        return cls((load.train_of if train_only else load.design_of)(text, file, overrides), text, file)

    def with_(self, changes: Mapping[str, Any] | Iterable[str]) -> "Design":
        """The design with some keys changed, by the same rules as `--set` on the command line.

        Args:
            changes: key -> value, such as `{"cam.thickness_mm": 3.2, "path.waypoints_mm.3": [1, 2]}`: items of lists
                count from 1, and None removes a key or a section. Texts `key=value` are taken, too.

        Raises:
            DesignError: no such key, or the result is no design; in the words of the command line.
        """
        overrides = (*self.values.overrides, *overrides_of(changes))
        return self._checked(self.text, self.file, overrides, not isinstance(self.values, DesignValues))

    def __repr__(self) -> str:
        changed = f", changed by {brief(' '.join(self.values.overrides), 80)}" if self.values.overrides else ""
        return f"<Design {self.name} of {self.file.name}{changed}>"

    @property
    def name(self) -> str:
        """What exported files are named after."""
        return self.values.name

    @property
    def sha256(self) -> str:
        """SHA-256 of what the design says, hexadecimal; manifests have it."""
        return self.values.content_hash

    def cam(self, profile: str | None = None, *, progress: Progress = silent) -> "Cam":
        """Compute the cam and check it; nothing is written.

        Args:
            profile: `actual`, `optimized`, `compensated`, `smoothed`, `smoothed+compensated`, `theoretical` or
                `published`. Left out, `optimized` for a design that says something of its play, else `actual`.
            progress: told what is being done.

        Raises:
            DesignError: the path cannot be driven, there is no such profile, or nothing is known of the play that it
                is for.
            CheckError: no profile keeps the limits of [optimize].
        """
        from cadgen.api.cam import Cam
        from cadgen.workflow.cam.plan import plan_cam

        return Cam(plan_cam(self._whole(), profile, progress))

    def gears(self, order: str = "as-given", *, progress: Progress = silent) -> "GearTrain":
        """Compute the gear train, lay it out, and measure its teeth in mesh; nothing is written.

        Args:
            order: `as-given`; `reordered`, the order of the stages with the least return error; or `search`, the best
                teeth within [train.search].
            progress: told what is being done.

        Raises:
            DesignError: there is no such order or no train, or it cannot be made or laid out.
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
            play_deg: return error of the runs at the camshaft, degrees, 0 to 180; left out, that which the profile is
                cut for.
            progress: told what is being done.

        Raises:
            DesignError: as `cam`, or no such play.
            CheckError: no profile keeps the limits of [optimize].
        """
        from cadgen.api import runs
        from cadgen.workflow.runs import simulation

        play = optional("play_deg", play_deg, 0, 180, "degrees")
        return runs.Simulation(simulation.simulate(self._whole(), profile, play, progress))

    def optimize(self, *, progress: Progress = silent) -> "Comparison":
        """Compare the methods against play, alone and combined, on every train, and choose the best.

        Args:
            progress: told what is being done.

        Raises:
            DesignError: nothing is known of the play.
            CheckError: no profile keeps the limits of [optimize].
        """
        from cadgen.api import cam, runs
        from cadgen.workflow.cam.plan import against_of, plan_cam
        from cadgen.workflow.cam.remedies import remedies

        design = self._whole()
        plan = plan_cam(design, "optimized", progress, all_trains=True)
        against = against_of(plan)
        return runs.Comparison(cam.Cam(plan), remedies(design, against, progress) if against.task.mechanics else ())

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
            seed: of the random numbers, 0 or more.
            profile: that all cars have.
            budget: rank everything that may be off, too.
            processes: how many run at once if no `map` is given, 1 to 256.
            progress: told what is being done.

        Raises:
            DesignError: as `cam`, or nothing varies.
            CheckError: no profile keeps the limits of [optimize].
            FileError: there is not the memory for so many cars.
        """
        from cadgen.api import runs
        from cadgen.workflow.runs.tolerance import run_tolerance

        return runs.ToleranceRun(
            run_tolerance(
                self._whole(),
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
    ) -> "Calibration":
        """Trace measured data of one car to the effects that the design lacks.

        Args:
            data: one or several, judged together: paths of CSV files, mappings of columns to arrays, `Measured`.
            profile: of the cam that was measured, or was on the car.
            form_error_um: form error of the disc to be expected, µm rms, 0.01 to 1000; left out, 2, or 30 if the data
                say that it is printed.
            progress: told what is being done.

        Raises:
            DesignError: as `cam`, or no such form error.
            FileError: data that cannot be read, or cannot be judged together.
        """
        from cadgen.workflow.calibration.plan import calibrate

        error = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm")
        told = calibrate(self._whole(), profile, sources_of(data, progress=progress), error, progress)
        return Calibration(told, self.text)

    def calibrate_each(
        self,
        data: Iterable[Data],
        *,
        profile: str = "actual",
        form_error_um: float | None = None,
        progress: Progress = silent,
    ) -> "Calibrations":
        """Judge measured data one by one, each as of a car of its own; arguments and errors as in `calibrate`."""
        from cadgen.workflow.calibration.plan import calibrate_each

        error = optional("form_error_um", form_error_um, *FORM_ERROR_UM, "µm")
        told = calibrate_each(self._whole(), profile, sources_of(data, each=True, progress=progress), error, progress)
        return Calibrations(tuple(Calibration(one, self.text) for one in told))

    def _whole(self) -> DesignValues:
        """The design, if it has all that a cam needs."""
        known = self.values
        return known if isinstance(known, DesignValues) else load.design_of(self.text, self.file, known.overrides)


@dataclass(frozen=True, eq=False, repr=False)
class Calibration:
    """Result of `Design.calibrate`: the effects found in measured data of one car, and the design built from them.

    Attributes:
        computed: the whole result, for figures that are not named here.
        text: of the design file.
    """

    computed: "calibrations.Calibration"
    text: str

    def __repr__(self) -> str:
        return f"<Calibration of {self.computed.design.name}: {self.verdicts}>"

    @property
    def verdicts(self) -> dict[str, str]:
        """Kind of data -> class of the verdict on it, such as `traced` or `ambiguous`."""
        return {source.kind.code: self.computed.verdict(source.kind) for source in self.computed.sources}

    @property
    def effects(self) -> "tuple[calibrations.Built, ...]":
        """Everything claimed, with its place in the design as built.

        `claim.finding.effect` is its name, `claim.finding.values` its numbers with standard deviations, in the unit
        that each name ends in.
        """
        return self.computed.built

    @property
    def warnings(self) -> tuple[str, ...]:
        """What does not fit, but was let pass, a sentence each."""
        return self.computed.warnings

    @cached_property
    def as_built(self) -> Design:
        """The design with what was measured in its [as_built]; the design as it was, if nothing was found."""
        from cadgen.workflow.calibration.as_built_file import as_built_text

        known = self.computed.design
        if not self.computed.built:
            return Design(known, self.text, Path(known.source))
        return Design.from_toml(as_built_text(self.computed, self.text), f"{known.name}_as_built")

    @property
    def report(self) -> "list[Block]":
        """Everything in paragraphs and tables; `str` of the result gives them as text."""
        from cadgen.workflow.calibration.words import report

        return report(self.computed)

    def __str__(self) -> str:
        from cadgen.report.text import plain

        return plain(self.report, _REPORT_WIDTH)

    def facts(self) -> dict[str, Any]:
        """Everything as plain values, as in the JSON file."""
        from cadgen.workflow.calibration.files import document

        return document(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the report, pictures, JSON and the design as built, all together or none.

        Args:
            folder: where to; it is made if need be.
            progress: told what is being done.

        Raises:
            FileError: a file cannot be written, or the design as built, read back, is not what was meant.
        """
        from cadgen.workflow.calibration.files import write_calibration

        place = folder_of(folder)
        written = write_calibration(self.computed, self.text, place, progress)
        return Written.of(place, written.part, written.entry)


@dataclass(frozen=True)
class Calibrations:
    """Result of `Design.calibrate_each`: a verdict on each measured file, judged alone.

    Attributes:
        each: one for each of the data, in their order.
    """

    each: tuple[Calibration, ...]

    @property
    def report(self) -> "list[Block]":
        """One table with a row for each."""
        from cadgen.workflow.calibration.words import summary

        return summary([one.computed for one in self.each])

    def facts(self) -> dict[str, Any]:
        """Everything as plain values, as in the JSON file."""
        from cadgen.workflow.calibration.files import documents

        return documents([one.computed for one in self.each])

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the table and JSON; errors as in `Calibration.write`.

        Args:
            folder: where to; it is made if need be.
            progress: told what is being done.
        """
        from cadgen.workflow.calibration.files import write_each

        place = folder_of(folder)
        progress("writing")
        written = write_each([one.computed for one in self.each], place)
        return Written.of(place, written.part, written.entry)
