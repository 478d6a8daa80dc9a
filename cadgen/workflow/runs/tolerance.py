"""Many cars within the design's tolerances: how they end, how many pass the gates, and what matters most."""

from dataclasses import dataclass
from math import degrees
from pathlib import Path
from typing import Any

import numpy as np

from cadgen import __version__
from cadgen.arrays import TURN
from cadgen.build import cam_model, variation
from cadgen.design.schema import Design
from cadgen.errors import DesignError, FileError
from cadgen.export.folder import publishing
from cadgen.export.manifest import Written, file_facts, versions, write_manifest
from cadgen.monte_carlo.fleet import Fleet, make_fleet
from cadgen.monte_carlo.robust import FleetEnds, Sensitivity, sensitivities, tolerance_run
from cadgen.motion.drive import STEPS
from cadgen.report.errors import FleetPicture, draw_fleet
from cadgen.workflow.cam.as_built import as_built_facts
from cadgen.workflow.cam.plan import CamPlan, Step, against_of, plan_cam
from cadgen.workflow.runs.budget import BudgetSheet, budget_sheet, unit_of

_OUTLINE_STEP = 0.06  # mm; rolling errs by 0.01 um of lift
QUANTILES = (0.5, 0.9, 0.95, 0.99)


@dataclass(frozen=True)
class ToleranceRun:
    """A design's random cars.

    Attributes:
        plan: of the profile that all cars have.
        seed: of the random numbers.
        ends: of the cars' runs.
        gates: that they pass on the run, its end included.
        sensitivities: to each tolerance, greatest share first.
        budget: of everything that may be off, and of the disc's making by processes; None if it was not asked for.
    """

    plan: CamPlan
    seed: int
    ends: FleetEnds
    gates: int
    sensitivities: tuple[Sensitivity, ...]
    budget: BudgetSheet | None = None

    @property
    def passed(self) -> float:
        """Share of the cars that pass every gate."""
        return self.ends.yield_within(self.plan.design.tolerances.gate_width_mm)

    def facts(self) -> dict[str, Any]:
        """Figures for the manifest and for machines; the processes that ran make no difference."""
        design, distance = self.plan.design, self.ends.distance
        heading = np.degrees(np.abs(self.ends.heading))
        return {
            "design": design.name,
            "source": design.source,
            "overrides": list(design.overrides),
            "design_sha256": design.content_hash,
            "cadgen": __version__,
            "profile": self.plan.profile,
            "friction_note": against_of(self.plan).rubbing,
            "passed": self.plan.passed,
            "failed_checks": [check.name for check in self.plan.failed],
            "as_built": as_built_facts(design, self.plan.lift.blend_start),
            "samples": len(distance),
            "seed": self.seed,
            "law": design.tolerances.law,
            "gate_width_mm": design.tolerances.gate_width_mm,
            "gates": self.gates,
            "yield": self.passed,
            "end_position_mm": {
                "mean": float(distance.mean()),
                **{f"{100 * q:g} %": float(np.quantile(distance, q)) for q in QUANTILES},
                "greatest": float(distance.max()),
            },
            "end_heading_deg": {
                "mean of size": float(heading.mean()),
                **{f"{100 * q:g} %": float(np.quantile(heading, q)) for q in QUANTILES},
            },
            "sensitivities": [
                {
                    "tolerance": one.name,
                    "half_width": _user(one.name, self._half_width(one.name)),
                    "unit": _unit(one.name),
                    "step": _user(one.name, one.step),
                    "position_mm_per_step": one.distance,
                    "heading_deg_per_step": degrees(one.heading),
                    "share_of_variance": one.share,
                }
                for one in self.sensitivities
            ],
            **({} if self.budget is None else {"budget": self.budget.facts()}),
        }

    def _half_width(self, name: str) -> float:
        if name != "play":
            return variation.half_widths(self.plan.design, against_of(self.plan).task.mechanics)[name]
        low, high = against_of(self.plan).band.ends
        return (high - low) / 2


def run_tolerance(
    design: Design,
    profile: str,
    samples: int,
    seed: int,
    processes: int,
    step: Step = lambda text: None,
    *,
    with_budget: bool = False,
) -> ToleranceRun:
    """Run random cars of a design.

    Args:
        design: a loaded design.
        profile: that all cars have: `actual` or one of `PLAY_PROFILES`.
        samples: number of cars.
        seed: of the random numbers.
        processes: how many run at once; the numbers do not depend on it.
        step: told what is being done.
        with_budget: rank everything that may be off, too.

    Raises:
        DesignError: as `plan_cam`, or nothing varies.
        CheckError: no profile keeps the limits of [optimize].
        FileError: there is not the memory for so many cars.
    """
    plan = plan_cam(design, profile, step, with_play=True)
    tolerances = variation.tolerances(design, against_of(plan).task.mechanics)
    fleet = _fleet(plan)
    step("finding sensitivities")
    found = sensitivities(fleet, tolerances)
    if not found:
        raise DesignError("no dimension of the design varies: give [tolerances] half widths above 0, or a band of play")

    def done(cars: int) -> None:
        step(f"run {min(cars, samples)} of {samples} cars")

    try:
        ends = tolerance_run(fleet, tolerances, samples, seed=seed, processes=processes, done=done)
    except MemoryError as error:
        raise FileError(
            f"out of memory for {samples} cars in {processes} processes: lower --samples or --processes, or close "
            f"other programs"
        ) from error
    sheet = None
    if with_budget:
        step("ranking what may be off")
        sheet = budget_sheet(design, fleet, tolerances)
    return ToleranceRun(plan, seed, ends, len(fleet.stations), found, sheet)


def write_tolerance(run: ToleranceRun, out: Path, step: Step = lambda text: None) -> Written:
    """Draw the distribution and the sensitivities, and publish the pictures together.

    Raises:
        FileError: a file cannot be written.
    """
    design = run.plan.design
    stem = f"{design.name}_{run.plan.profile}_tolerance"
    step("drawing")
    with publishing(out) as staging:
        picture = FleetPicture(
            title=f"{design.name}, {run.plan.profile} profile, {len(run.ends.heading)} cars",
            along=run.ends.along,
            across=run.ends.across,
            gate_width=design.tolerances.gate_width_mm,
            passed=run.passed,
            shares={one.name: one.share for one in run.sensitivities},
        )
        names = draw_fleet(picture, staging, stem)
        if run.budget is not None:
            names += run.budget.draw(f"{design.name}, {run.plan.profile} profile", staging, f"{stem}_budget")
        entry = {**run.facts(), "versions": versions(), "files": {name: file_facts(staging / name) for name in names}}
        write_manifest(staging, stem, entry)
    return Written(stem, entry)


def _fleet(plan: CamPlan) -> Fleet:
    against = against_of(plan)
    task, grid = against.task, np.linspace(0.0, TURN, STEPS, endpoint=False)
    return make_fleet(
        task.as_built.roll_new(plan.curve, task.follower, grid, _OUTLINE_STEP),
        task.follower,
        task.car,
        task.length,
        plan.lift,
        task.planned(),
        wheel_radius=variation.wheel_radius(plan.design, task.length),
        play=against.chosen.play,
        stations=_gates(plan),
        mechanics=None if task.mechanics is None else task.mechanics.nominal,
        expansion=variation.expansion(plan.design),
    )


def _gates(plan: CamPlan) -> list[int]:
    """Steps of the run at which the car passes the waypoints after the first, and its end."""
    stop = plan.lift.blend_start
    motor = cam_model.cam_angle(plan.design, plan.track, plan.track.waypoint_arc[1:])
    steps = np.unique(np.rint(motor[motor < stop] / stop * STEPS).astype(int))
    return [*steps[(steps > 0) & (steps < STEPS)].tolist(), STEPS]


def _unit(name: str) -> str:
    return unit_of(name)[0]


def _user(name: str, value: float) -> float:
    return value * unit_of(name)[1]
