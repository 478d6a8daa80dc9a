"""Many cars within the design's tolerances: ends of their runs, yield at the gates, and sensitivities."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.running.drive import STEPS, turns_of
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.deviations.deviation import RETURN_ERROR, Deviation
from cadgen.errors import DesignError, FileError
from cadgen.inference.monte_carlo.cars import Cars
from cadgen.inference.monte_carlo.random_cars import CarEnds, Map, Sensitivity, sensitivities, tolerance_run
from cadgen.jobs.cam.cam_plan import CamPlan, comparison_of, plan_cam
from cadgen.jobs.runs.budget import BudgetSheet, budget_sheet
from cadgen.jobs.runs.fleet import fleet_of
from cadgen.jobs.runs.watched import watching
from cadgen.processes import in_processes
from cadgen.progress import Progress, silent

QUANTILES = (0.5, 0.9, 0.95, 0.99)


@dataclass(frozen=True)
class Spread:
    """Spread of a figure over many cars, in the unit of the figure.

    Attributes:
        mean: mean of all cars.
        quantiles: value that a share of the cars does not exceed, by the share, 0 to 1.
        greatest: greatest value of all cars.
    """

    mean: float
    quantiles: Mapping[float, float]
    greatest: float


def spread(values: Array) -> Spread:
    """Mean, quantiles and greatest of values, shape (n,), in their own unit.

    Args:
        values: numbers, shape (n,).
    """
    quantiles = {part: float(np.quantile(values, part)) for part in QUANTILES}
    return Spread(float(values.mean()), quantiles, float(values.max()))


@dataclass(frozen=True)
class ToleranceRun:
    """A design's random cars.

    Attributes:
        plan: plan of the profile that all cars have.
        seed: seed of the random numbers.
        ends: errors at the ends of the cars' runs, mm and rad.
        gates: number of gates: those of the course, or the waypoints passed and the end of the run.
        sensitivities: effect of each tolerance, greatest share first.
        budget: error budget of the design, and of the disc by process; None if it was not asked for.
    """

    plan: CamPlan
    seed: int
    ends: CarEnds
    gates: int
    sensitivities: tuple[Sensitivity, ...]
    budget: BudgetSheet | None = None

    @property
    def passed(self) -> float:
        """Share of the cars that pass every gate and, if the design has one, keep its course."""
        kept = self.ends.margin >= 0
        if self.gate_width is not None:
            kept &= self.ends.widest <= self.gate_width / 2
        return float(np.mean(kept))

    @property
    def gate_width(self) -> float | None:
        """Width of the gates at the waypoints, mm; None where the course has its own."""
        course = self.plan.course
        return None if course is not None and course.course.gates else self.plan.car.design.tolerances.gate_width

    @property
    def watched(self) -> str:
        """Parts of the course that the cars must keep, in words; empty without a course."""
        course = self.plan.course
        if course is None:
            return ""
        kinds = [obstacle.kind for obstacle in course.course.obstacles]
        counted: dict[str, int] = {"gate": len(course.planned.driven.passages)}
        counted.update({kind: kinds.count(kind) for kind in dict.fromkeys(kinds)})
        words = [f"{count} {kind}{'s' if count > 1 else ''}" for kind, count in counted.items() if count]
        return listed([*words, *(["the edge"] if course.course.edge is not None else [])], "and")

    @property
    def margins(self) -> dict[float, float]:
        """Margin to all of the course that a share of the cars keeps at least, mm, by the share, 0 to 1."""
        return {part: float(np.quantile(self.ends.margin, 1 - part)) for part in QUANTILES}

    @property
    def samples(self) -> int:
        """Number of cars."""
        return len(self.ends.heading)

    @cached_property
    def end_position(self) -> Spread:
        """Spread of the position errors at the end, mm."""
        return spread(self.ends.distance)

    @cached_property
    def end_heading_deg(self) -> Spread:
        """Spread of the sizes of the heading errors at the end, degrees."""
        return spread(np.degrees(np.abs(self.ends.heading)))

    def half_width(self, name: Deviation) -> float:
        """Half of the zone of a tolerance, or of the band of play, mm or rad."""
        if name != RETURN_ERROR:
            return variation.half_widths(self.plan.car.design, comparison_of(self.plan).task.mechanics)[name]
        low, high = comparison_of(self.plan).band.ends
        return (high - low) / 2


@dataclass(frozen=True, kw_only=True)
class CarSample:
    """Random cars that are asked for.

    Attributes:
        samples: number of cars.
        seed: seed of the random numbers.
        processes: number of processes that run at once; the results do not depend on it.
        with_budget: whether all deviations are ranked, too.
        map_with: function that runs the cars instead of `processes`, such as the `map` of a pool.
    """

    samples: int
    seed: int = 1
    processes: int = 1
    with_budget: bool = False
    map_with: Map | None = None


def run_tolerance(design: Design, profile: str, sample: CarSample, progress: Progress = silent) -> ToleranceRun:
    """Run random cars of a design.

    Args:
        design: loaded design.
        profile: profile that all cars have: `actual`, or the code of a profile for play.
        sample: random cars that are asked for.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: as `plan_cam`, or nothing varies.
        CheckError: no profile keeps the limits of [optimize].
        FileError: the memory does not suffice for so many cars.
    """
    plan = plan_cam(design, profile, progress, with_play=True)
    return tolerance_of(plan, sample, progress)


def tolerance_of(plan: CamPlan, sample: CarSample, progress: Progress = silent) -> ToleranceRun:
    """Run random cars with the cam of a plan.

    Args:
        plan: plan of a profile that was compared under play.
        sample: random cars that are asked for.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the profile was not compared under play, or nothing varies.
        FileError: the memory does not suffice for so many cars.
    """
    design = plan.car.design
    tolerances = variation.tolerances(design, comparison_of(plan).task.mechanics)
    fleet = watched_fleet(plan)
    progress("finding sensitivities")
    ranked = sensitivities(fleet, tolerances)
    if not ranked:
        raise DesignError("no dimension of the design varies: give [tolerances] half widths above 0, or a band of play")

    def done(cars: int) -> None:
        progress(f"run {min(cars, sample.samples)} of {sample.samples} cars")

    try:
        ends = tolerance_run(
            fleet,
            tolerances,
            sample.samples,
            seed=sample.seed,
            map_with=sample.map_with or _map(sample.processes),
            done=done,
        )
    except MemoryError as error:
        raise FileError(
            f"out of memory for {sample.samples} cars in {sample.processes} processes: lower --samples or --processes, "
            "or close other programs"
        ) from error
    sheet = None
    if sample.with_budget:
        progress("ranking what may be off")
        sheet = budget_sheet(design, fleet, tolerances)
    return ToleranceRun(plan, sample.seed, ends, _count(plan), ranked, sheet)


def _map(processes: int) -> Map | None:
    return partial(in_processes, processes) if processes > 1 else None


def watched_fleet(plan: CamPlan) -> Cars:
    """The nominal car of a plan that was compared under play, with what it must keep of its course."""
    comparison = comparison_of(plan)
    mechanics = None if comparison.task.mechanics is None else comparison.task.mechanics.nominal
    fleet = fleet_of(plan, _gates(plan), mechanics, comparison.chosen.play)
    return fleet if plan.course is None else watching(fleet, plan.course.planned)


def _count(plan: CamPlan) -> int:
    passed = () if plan.course is None else plan.course.planned.driven.passages
    return len(passed) or len(_gates(plan))


def _gates(plan: CamPlan) -> list[int]:
    """Steps of the run at which the car passes the waypoints after the first, and its end; with a course its end.

    On a closed path the car passes its waypoints, and its start, on every lap.
    """
    stop = plan.steering.blend_start
    last = STEPS * turns_of(stop)
    if plan.course is not None and plan.course.course.gates:
        return [last]
    motor = cam_model.cam_angle(plan.car.design, plan.track, plan.track.waypoint_arc[1:])
    if plan.track.closed:
        laps = np.arange(plan.car.design.path.run_laps) * TURN / plan.track.turn_laps
        motor = (laps[:, None] + motor).ravel()
    steps = np.unique(np.rint(motor[motor < stop] / stop * last).astype(int))
    return [*steps[(steps > 0) & (steps < last)].tolist(), last]
