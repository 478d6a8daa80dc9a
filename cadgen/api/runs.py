"""Runs of the car with play: one by one, compared by profile, and by the thousand."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import Any, Protocol

from cadgen.api.cam import Cam
from cadgen.arrays import Array
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.running.drive import Run
from cadgen.car.running.errors import Event, RunError
from cadgen.errors import DesignError, brief
from cadgen.inference.monte_carlo.random_cars import CarEnds, Map, Sensitivity
from cadgen.jobs.cam.built_car import as_built_sentences, assumed_play
from cadgen.jobs.cam.car_facts import remedy_facts
from cadgen.jobs.cam.mechanics import joint_sentences
from cadgen.jobs.cam.remedies import Remedy as Remedy
from cadgen.jobs.cam.wheel import field_notice
from cadgen.jobs.runs import files
from cadgen.jobs.runs import simulation as simulations
from cadgen.jobs.runs import tolerance as tolerances
from cadgen.jobs.runs.budget import BudgetSheet as BudgetSheet
from cadgen.jobs.runs.budget import shown_half_width as shown_half_width
from cadgen.jobs.runs.budget import shown_value as shown_value
from cadgen.jobs.runs.manifest import simulation_facts, tolerance_facts
from cadgen.jobs.runs.tolerance import Spread as Spread
from cadgen.output.files.publisher import Written, folder_of
from cadgen.progress import Progress, silent
from cadgen.studies.engines import mapping


class Pool(Protocol):
    """Anything with a `map`: `concurrent.futures`, `multiprocessing`, mpi4py, dask."""

    def map(self, function: Callable[[int], Array], numbers: Iterable[int], /) -> Iterable[Array]:
        """The function's results in order, computed anywhere.

        Args:
            function: function of a number, which can be pickled.
            numbers: numbers to compute it for.
        """


@dataclass(frozen=True, eq=False, repr=False)
class Simulation:
    """Runs of the car with play in its gears: what `Design.simulate` gives.

    Attributes:
        computed: numeric result, with all other figures; mm and rad.
    """

    computed: simulations.Simulation

    def __repr__(self) -> str:
        return f"<Simulation of {self.cam.design.name}, {self.cam.profile} profile>"

    @cached_property
    def cam(self) -> Cam:
        """The cam of the run after."""
        return Cam.of(self.computed.plan)

    @property
    def play(self) -> float:
        """Return error of the runs at the camshaft, rad."""
        return self.computed.play

    @property
    def planned(self) -> Run:
        """Planned run, without play."""
        return self.computed.planned

    @property
    def before(self) -> Run:
        """Run on the actual profile; of a car as built, on the cam that it was measured with."""
        return self.computed.before

    @property
    def after(self) -> Run:
        """Run on the cam's profile."""
        return self.computed.after

    @property
    def before_error(self) -> RunError:
        """Errors of the run before against the planned run, mm and rad."""
        return self.computed.before_error

    @property
    def after_error(self) -> RunError:
        """Errors of the run after against the planned run, mm and rad."""
        return self.computed.after_error

    @property
    def events(self) -> tuple[Event, ...]:
        """Jumps and reverses of the run before, with the heading that each adds, rad."""
        return self.computed.events

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on what was assumed of the car, and what was measured."""
        return _notes(self.computed.plan.car.design, float(self.planned.motor[-1]))

    def facts(self) -> dict[str, Any]:
        """The runs as plain values, as in the manifest and with `--json`."""
        return simulation_facts(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write tracks as CSV and pictures as PNG and SVG, all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        return files.write_simulation(self.computed, folder_of(folder), progress)


@dataclass(frozen=True, eq=False, repr=False)
class Comparison:
    """The methods against play, alone and combined: what `Design.optimize` gives.

    Attributes:
        cam: the best profile that keeps every limit.
        remedies: further remedies, with what to build for them; empty if the design has no [mechanics].
    """

    cam: Cam
    remedies: tuple[Remedy, ...]

    def __repr__(self) -> str:
        return f"<Comparison for {self.cam.design.name}, {len(self.compared)} compared, best {self.cam.profile}>"

    @property
    def compared(self) -> tuple[Evaluation, ...]:
        """Every method on every train, with its errors, mm and rad."""
        return () if self.cam.comparison is None else self.cam.comparison.evaluations

    def facts(self) -> dict[str, Any]:
        """The comparison as plain values, as with `--json`: the facts on the cam, and the further remedies."""
        facts = self.cam.facts()
        return {**facts, "remedies": [remedy_facts(remedy) for remedy in self.remedies]} if self.remedies else facts

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write pictures of events and tracks, all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written.
        """
        cures = self.cam.find_cures(progress)
        return files.write_comparison(self.cam.computed, folder_of(folder), progress, cures=cures)


@dataclass(frozen=True, eq=False, repr=False)
class ToleranceRun:
    """Many cars within the tolerances of a design: what `Design.tolerance` gives.

    Attributes:
        computed: numeric result, with all other figures; mm and rad.
    """

    computed: tolerances.ToleranceRun

    def __repr__(self) -> str:
        return f"<ToleranceRun of {self.cam.design.name}, {len(self.ends.heading)} cars, {self.passed:.1%} pass>"

    @cached_property
    def cam(self) -> Cam:
        """The cam that all cars have."""
        return Cam.of(self.computed.plan)

    @property
    def passed(self) -> float:
        """Share of the cars that pass every gate, 0 to 1."""
        return self.computed.passed

    @property
    def ends(self) -> CarEnds:
        """Errors of every car at the end of its run, shape (samples,), mm and rad."""
        return self.computed.ends

    @property
    def sensitivities(self) -> tuple[Sensitivity, ...]:
        """Effect of each tolerance on the end of the run, greatest share first; mm and rad."""
        return self.computed.sensitivities

    @property
    def budget(self) -> BudgetSheet | None:
        """All deviations, ranked by their cost at the finish, mm; None if the budget was not asked for."""
        return self.computed.budget

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on what was assumed of the car, and what was measured."""
        return _notes(self.computed.plan.car.design, self.computed.plan.steering.blend_start)

    def facts(self) -> dict[str, Any]:
        """The run as plain values, as in the manifest and with `--json`."""
        return tolerance_facts(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write pictures of the distribution and the sensitivities, all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written.
        """
        return files.write_tolerance(self.computed, folder_of(folder), progress)


def map_of(pool: Pool | Map | None) -> Callable[..., Iterable[Any]] | None:
    """Map function of an executor or pool, or the function itself.

    Args:
        pool: object with a method `map` or `submit`, function like the built-in `map`, or None.

    Raises:
        DesignError: the pool is none of these.
    """
    if pool is None:
        return None
    if (function := mapping(pool)) is None:
        raise DesignError(f"map is {brief(repr(pool), 60)}; it must be a function such as map, or have a method map")
    return function


def _notes(design: Any, stop: float) -> tuple[str, ...]:
    return (
        *field_notice(design),
        *assumed_play(design),
        *joint_sentences(design),
        *as_built_sentences(design, stop),
    )
