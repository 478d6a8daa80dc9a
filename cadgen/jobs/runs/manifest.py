"""Runs and budgets as plain values, for the manifest and for machines: each value in the unit that its key names."""

from math import degrees
from typing import Any

from cadgen.car.running.errors import deflection_sum
from cadgen.deviations.deviation import Deviation
from cadgen.inference.monte_carlo.budget import Budget
from cadgen.jobs.cam.cam_plan import comparison_of
from cadgen.jobs.cam.car_facts import as_built_facts, mechanics_facts
from cadgen.jobs.runs.budget import BudgetSheet, unit_of
from cadgen.jobs.runs.simulation import Simulation
from cadgen.jobs.runs.tolerance import Spread, ToleranceRun
from cadgen.version import __version__


def simulation_facts(simulation: Simulation) -> dict[str, Any]:
    """Facts on the runs with play."""
    plan, comparison, laps = simulation.plan, simulation.comparison, simulation.plan.laps
    runs = {"before": simulation.before, "after": simulation.after}
    return {
        **plan.origin.facts(),
        "drive_wheel": plan.drive_wheel.facts(),
        "profile": plan.kind.code,
        "passed": plan.passed,
        "failed_checks": [check.name for check in plan.failed],
        "method": comparison.chosen.profile.code,
        "return_error_deg": degrees(simulation.play),
        "cut_for_deg": degrees(comparison.chosen.made_for),
        "mechanics": mechanics_facts(comparison.task.mechanics, comparison.chosen.lift),
        "friction_note": comparison.rubbing,
        "as_built": as_built_facts(plan.car.design, float(simulation.planned.motor[-1])),
        "events": [{"kind": event.kind, **event.figures.facts()} for event in simulation.events],
        "deflection_sum_deg": degrees(deflection_sum(simulation.events)),
        "before": simulation.before_error.figures.facts(),
        "after": simulation.after_error.figures.facts(),
        "after_without_play": comparison.chosen.deviation.figures.facts(),
        **({} if laps is None else {"laps": laps.track_facts(planned=simulation.planned, **runs)}),
        "course": simulation.on_course
        and {
            name: {key: {"room_mm": room, "where": where} for key, (where, room) in run.figures().items()}
            for name, run in zip(("planned", "after"), simulation.on_course, strict=True)
        },
    }


def tolerance_facts(run: ToleranceRun) -> dict[str, Any]:
    """Facts on random cars; they do not depend on the number of processes."""
    plan, design = run.plan, run.plan.car.design
    position, heading = run.end_position, run.end_heading_deg
    return {
        **plan.origin.facts(),
        "drive_wheel": plan.drive_wheel.facts(),
        "cadgen": __version__,
        "profile": plan.kind.code,
        "friction_note": comparison_of(plan).rubbing,
        "passed": plan.passed,
        "failed_checks": [check.name for check in plan.failed],
        "as_built": as_built_facts(design, plan.steering.blend_start),
        "samples": run.samples,
        "seed": run.seed,
        "law": design.tolerances.law,
        "gate_width_mm": run.gate_width,
        "gates": run.gates,
        "course": _course_facts(run),
        "yield": run.passed,
        "end_position_mm": {"mean": position.mean, **_quantiles(position), "greatest": position.greatest},
        "end_heading_deg": {"mean of size": heading.mean, **_quantiles(heading)},
        "sensitivities": [
            {
                "tolerance": sensitivity.name,
                "half_width": _shown(sensitivity.deviation, run.half_width(sensitivity.deviation)),
                "unit": unit_of(sensitivity.deviation)[0],
                "step": _shown(sensitivity.deviation, sensitivity.step),
                "position_mm_per_step": sensitivity.distance,
                "heading_deg_per_step": degrees(sensitivity.heading),
                "share_of_variance": sensitivity.share,
            }
            for sensitivity in run.sensitivities
        ],
        **({} if run.budget is None else {"budget": budget_facts(run.budget)}),
    }


def _course_facts(run: ToleranceRun) -> dict[str, Any] | None:
    """Parts of the course that the cars must keep, and the least margin that they keep to it."""
    if not run.watched:
        return None
    kept = {f"{100 * part:g} %": margin for part, margin in run.margins.items()}
    return {"watched": run.watched, "least_margin_mm": {**kept, "least": float(run.ends.margin.min())}}


def _quantiles(spread: Spread) -> dict[str, float]:
    return {f"{100 * part:g} %": value for part, value in spread.quantiles.items()}


def _shown(name: Deviation, value: float) -> float:
    return value * unit_of(name)[1]


def budget_facts(sheet: BudgetSheet) -> dict[str, Any]:
    """Facts on the cost of every deviation."""
    return {
        **_costs(sheet.budget),
        "processes": {process: _costs(budget) for process, budget in sheet.processes.items()},
        "advice": sheet.sentences(),
    }


def _costs(budget: Budget) -> dict[str, Any]:
    return {
        "costs": [
            {
                "name": cost.name,
                "half_width": _shown(cost.deviation, cost.half_width),
                "unit": unit_of(cost.deviation)[0],
                "end_position_mm": cost.before,
                "end_position_after_trim_mm": cost.after,
                "repeats": cost.repeats,
                "beyond_first_order": cost.rough,
            }
            for cost in budget.costs
        ],
        "root_of_squares_mm": {"before": budget.before, "after_trim": budget.after},
    }
