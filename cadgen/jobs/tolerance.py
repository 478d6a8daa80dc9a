"""Many cars within the design's tolerances: ends of their runs, yield at the gates, and sensitivities."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from math import degrees
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Generic, Self

import numpy as np

from cadgen.arrays import Array
from cadgen.design.section import listed
from cadgen.deviations.deviation import RETURN_ERROR, Deviation
from cadgen.errors import DesignError, FileError
from cadgen.figures import Facts
from cadgen.gears.choices import Law
from cadgen.inference.monte_carlo.random_cars import CarEnds, Map, Sensitivity, sensitivities, tolerance_run
from cadgen.jobs.cam.steering_cam import CarUse, comparison_of
from cadgen.jobs.error_budget import BudgetSheet, budget_sheet, unit_of
from cadgen.jobs.nominal_car import counts_finish, gate_steps, watched_cars
from cadgen.jobs.simulation import C
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, Written, folder_of, publish
from cadgen.output.report.cars import FleetPicture, budget_picture, fleet_picture
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing, save
from cadgen.processes import in_processes
from cadgen.progress import Progress, silent
from cadgen.version import __version__

if TYPE_CHECKING:  # it reads the kinds of measured data, which no other command needs
    from cadgen.jobs.calibration.workshop import Workshop

QUANTILES = (0.5, 0.9, 0.95, 0.99)
# Things on a course: one, and several of them.
_COUNTED = {
    "gate": (Message("gate"), Message("gates")),
    "post": (Message("post"), Message("posts")),
    "wall": (Message("wall"), Message("walls")),
    "zone": (Message("zone"), Message("zones")),
}


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


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ToleranceRun(Pictured, Generic[C]):
    """Many cars within the tolerances of a design: what `Design.tolerance` gives. Lengths are mm and angles rad.

    Attributes:
        cam: cam that all cars have.
        seed: seed of the random numbers.
        ends: errors of every car at the end of its run, shape (samples,), mm and rad.
        gates: number of gates: those of the course, or those at the waypoints and at the end for which the design has a
            width.
        gate_width: width of the gates at the waypoints, mm; None where the design states none.
        law: law of the deviations within their zones.
        half_widths: half of the zone of each tolerance, or of the band of play, mm or rad.
        sensitivities: effect of each tolerance on the end of the run, greatest share first.
        budget: all deviations, ranked by their cost at the finish, mm; None if the budget was not asked for.
    """

    cam: C
    seed: int
    ends: CarEnds
    gates: int
    gate_width: float | None
    law: Law
    half_widths: Mapping[Deviation, float]
    sensitivities: tuple[Sensitivity, ...]
    budget: BudgetSheet | None = None

    def __repr__(self) -> str:
        kept = "" if self.passed is None else f", {self.passed:.1%} pass"
        return f"<ToleranceRun of {self.cam.origin.name}, {self.samples} cars{kept}>"

    @property
    def computed(self) -> Self:
        """The whole result, for figures that are not named here: this object itself."""
        return self

    @property
    def _title(self) -> str:
        return f"{self.cam.origin.name}, {self.cam.kind} profile"

    @property
    def picture(self) -> Drawing:
        """Distribution of the ends, and what it comes from."""
        return fleet_picture(
            FleetPicture(
                title=f"{self._title}, {self.samples} cars",
                along=self.ends.along,
                across=self.ends.across,
                gate_width=self.gate_width,
                passed=self.passed,
                shares={sensitivity.name: sensitivity.share for sensitivity in self.sensitivities},
            )
        )

    @property
    def passed(self) -> float | None:
        """Share of the cars that keep the course, and the gates that the design states; None if it has neither."""
        if not self.gates and not self.watched:
            return None
        kept = self.ends.margin >= 0
        if self.gate_width is not None:
            kept &= self.ends.widest <= self.gate_width / 2
        return float(np.mean(kept))

    @property
    def trimmed(self) -> bool:
        """Whether each car is trimmed by the end of a trial run of its own."""
        return CarUse.of(self.cam).tolerances().trimmed

    @property
    def watched(self) -> str:
        """Parts of the course that the cars must keep, in words; empty without a course."""
        course = CarUse.of(self.cam).course
        if course is None:
            return ""
        kinds = [obstacle.kind for obstacle in course.course.obstacles]
        counted: dict[str, int] = {"gate": len(course.planned.driven.passages)}
        counted.update({kind: kinds.count(kind) for kind in dict.fromkeys(kinds)})
        words = [
            Message("{count} {kind}", count=count, kind=_COUNTED[kind][count > 1])
            for kind, count in counted.items()
            if count
        ]
        words += [Message("the edge")] * (course.course.edge is not None)
        return listed([*words, *[Message("the finish")] * counts_finish(course.planned)], "and")

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

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on what was assumed of the car, and what was measured."""
        use = CarUse.of(self.cam)
        return use.run_notes(use.steering.blend_start)

    def entry(self) -> Facts:
        """The run, as in the manifest; the number of processes does not show."""
        plan, use = self.cam, CarUse.of(self.cam)
        position, heading = self.end_position, self.end_heading_deg
        course: Facts | None = None
        if self.watched:
            kept = {f"{100 * part:g} %": margin for part, margin in self.margins.items()}
            course = Facts(watched=self.watched, least_margin_mm={**kept, "least": self.ends.margin.min()})
        facts = Facts(
            drive_wheel=use.drive_wheel.entry(),
            cadgen=__version__,
            profile=plan.kind.code,
            friction_note=comparison_of(plan).rubbing,
            passed=plan.passed,
            failed_checks=[check.name for check in plan.failed],
            verdict=plan.verdict.entry(),
            as_built=use.as_built_facts(use.steering.blend_start),
            samples=self.samples,
            seed=self.seed,
            law=self.law,
            gate_width_mm=self.gate_width,
            gates=self.gates,
            course=course,
            **{"yield": self.passed},
            end_position_mm={"mean": position.mean, **_quantiles(position), "greatest": position.greatest},
            end_heading_deg={"mean of size": heading.mean, **_quantiles(heading)},
            sensitivities=[
                Facts(
                    tolerance=sensitivity.name,
                    half_width=self.half_widths[sensitivity.deviation] * unit_of(sensitivity.deviation)[1],
                    unit=unit_of(sensitivity.deviation)[0],
                    step=sensitivity.step * unit_of(sensitivity.deviation)[1],
                    position_mm_per_step=sensitivity.distance,
                    heading_deg_per_step=degrees(sensitivity.heading),
                    share_of_variance=sensitivity.share,
                )
                for sensitivity in self.sensitivities
            ],
        )
        budget = Facts() if self.budget is None else Facts(budget=self.budget.entry())
        return plan.origin.entry() | facts | budget

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write pictures of the distribution and the sensitivities, all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written.
        """
        stem = f"{self.cam.origin.name}_{self.cam.kind}_tolerance"
        progress("drawing")

        def files(staging: Path) -> Iterator[Artifact]:
            yield from map(Artifact, save(self.picture, staging, stem))
            if self.budget is not None:
                bars = {cost.name.replace("_", " "): (cost.before, cost.after) for cost in self.budget.budget.costs}
                yield from map(Artifact, save(budget_picture(self._title, bars), staging, f"{stem}_budget"))

        return publish(stem, folder_of(folder), files, self.entry())


def _quantiles(spread: Spread) -> dict[str, float]:
    return {f"{100 * part:g} %": value for part, value in spread.quantiles.items()}


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


def tolerance_of(
    plan: C, sample: CarSample, progress: Progress = silent, workshop: "Workshop | None" = None
) -> ToleranceRun[C]:
    """Run random cars with the cam of a plan.

    Args:
        plan: plan of a profile that was compared under play.
        sample: random cars that are asked for.
        progress: function that is called with a few words on each step.
        workshop: what the cars of the workshop differ by, in the place of what the design allows.

    Raises:
        DesignError: the profile was not compared under play, or nothing varies.
        FileError: the memory does not suffice for so many cars.
    """
    use, (low, high) = CarUse.of(plan), comparison_of(plan).band.ends
    tolerances = use.tolerances()
    nominal = watched_cars(use, plan.curve)
    if workshop is not None:
        tolerances = workshop.tolerances(tolerances, nominal.car, nominal.wheel_radius)
    progress("finding sensitivities")
    ranked = sensitivities(nominal, tolerances)
    if not ranked:
        raise DesignError("no dimension of the design varies: give [tolerances] half widths above 0, or a band of play")

    def done(cars: int) -> None:
        progress(Message("run {cars} of {samples} cars", cars=min(cars, sample.samples), samples=sample.samples))

    try:
        ends = tolerance_run(
            nominal,
            tolerances,
            sample.samples,
            seed=sample.seed,
            map_with=sample.map_with or (partial(in_processes, sample.processes) if sample.processes > 1 else None),
            done=done,
        )
    except MemoryError as error:
        raise FileError(
            "out of memory for {samples} cars in {processes} processes: lower --samples or --processes, "
            "or close other programs",
            samples=sample.samples,
            processes=sample.processes,
        ) from error
    sheet = None
    if sample.with_budget:
        progress("ranking what may be off")
        sheet = budget_sheet(use.play_zones(), nominal, use.half_widths(), use.of_the_parts(), use.shafts)
    passages = () if use.course is None else use.course.planned.driven.passages
    return ToleranceRun(
        cam=plan,
        seed=sample.seed,
        ends=ends,
        gates=len(passages) if use.gate_width is None else len(gate_steps(use)),
        gate_width=use.gate_width,
        law=tolerances.law,
        half_widths={**tolerances.half_widths, RETURN_ERROR: (high - low) / 2},
        sensitivities=ranked,
        budget=sheet,
    )
