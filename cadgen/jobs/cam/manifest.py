"""A planned cam as plain values, for the manifest and for machines: each value in the unit that its key names."""

from math import degrees, isfinite
from typing import Any

from cadgen.arrays import TURN
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.remedies import holding
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.check import Check
from cadgen.design import cam_model, gear_model, variation
from cadgen.design.schema import Design
from cadgen.deviations.deviation import Place
from cadgen.jobs.cam.as_built import stop_as_designed
from cadgen.jobs.cam.comparison import PAPER_PERCENT, PlayComparison
from cadgen.jobs.cam.cures import Cures
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.cam.remedies import Remedy


def design_facts(design: Design) -> dict[str, Any]:
    """Name, source, overrides and hash of a design."""
    return {
        "design": design.name,
        "source": design.source,
        "overrides": list(design.overrides),
        "design_sha256": design.content_hash,
    }


def cam_facts(plan: CamPlan, cures: Cures) -> dict[str, Any]:
    """Facts on a cam before its files."""
    start = plan.lift.blend_start
    return {
        **design_facts(plan.design),
        "drive_wheel": plan.wheel.facts(),
        "profile": plan.profile.code,
        "passed": plan.passed,
        "checks": [_check_facts(check) for check in plan.figures],
        "cures": [
            {"override": cure.override, "now": cure.now, "then_fails": [check.name for check in cure.failing]}
            for cure in cures.proved
        ],
        "edge_break_mm": plan.blank.edge_break,
        "carrying_planes_mm": list(plan.rod.planes),
        "lift_extrema": _extrema_facts(plan),
        "track_length_mm": plan.track.length,
        **_turn_facts(plan),
        "profile_area_mm2": plan.area,
        "play": None if plan.comparison is None else comparison_facts(plan.comparison),
        "as_built": as_built_facts(plan.design, start),
    }


def _turn_facts(plan: CamPlan) -> dict[str, Any]:
    """Content of a turn of the cam: a path and a closing blend, or laps."""
    if plan.laps is not None:
        comparison = plan.comparison
        if comparison is None:
            return {"laps": plan.laps.facts(None)}
        return {"laps": plan.laps.facts(comparison.run, before=comparison.before, after=comparison.chosen)}
    return {
        "blend": {
            "from_cam_angle_deg": degrees(plan.lift.blend_start),
            "from_track_mm": plan.path_end,
            "where": plan.track.where(plan.path_end),
        }
    }


def _check_facts(check: Check) -> dict[str, Any]:
    return {
        "code": check.code.value,
        "name": check.name,
        "value": _finite(check.value),
        "unit": check.unit,
        "bound": check.bound,
        "limit": _finite(check.limit),
        "place": check.place,
        "passed": check.passed,
        "advice": "" if check.passed else check.advice,
    }


def _finite(value: float) -> float | None:
    return value if isfinite(value) else None


def _extrema_facts(plan: CamPlan) -> list[dict[str, Any]]:
    peaks, valleys = plan.lift.extrema()
    return [
        {
            "kind": kind,
            "cam_angle_deg": degrees(angle),
            "lift_mm": float(plan.rod.lift(plan.lift.q(angle))),
        }
        for kind, angles in (("peak", peaks), ("valley", valleys))
        for angle in angles
    ]


def comparison_facts(comparison: PlayComparison) -> dict[str, Any]:
    """Facts on the profiles compared against play."""
    low, high = comparison.band.ends
    bound, measured = comparison.bound, comparison.band.measured
    gain = comparison.worst_gain(bound.distance)
    return {
        "return_error_deg": {
            "least": degrees(low),
            "greatest": degrees(high),
            "measured": None if measured is None else degrees(measured),
            "cut_for": degrees(comparison.chosen.made_for),
        },
        "mechanics": mechanics_facts(comparison.task.mechanics, comparison.chosen.lift),
        "friction_note": comparison.rubbing,
        "before": _evaluation_facts(comparison, comparison.before),
        "after": _evaluation_facts(comparison, comparison.chosen),
        "compared": [_evaluation_facts(comparison, evaluation) for evaluation in comparison.evaluations],
        "reasons": list(comparison.reasons),
        # For a rod that slides without friction.
        "bound_with_same_peaks_and_valleys": None
        if comparison.task.mechanics
        else {
            "worst_end_heading_deg": degrees(bound.heading),
            "worst_end_position_mm": bound.distance,
            "worst_position_percent_off": None if gain is None else 100 * gain,
        },
        "paper_percent_off": PAPER_PERCENT,
    }


def _evaluation_facts(comparison: PlayComparison, evaluation: Evaluation) -> dict[str, Any]:
    return {
        "profile": evaluation.profile.code,
        "as_measured": evaluation.measured,
        "train": evaluation.train,
        **comparison.figures(evaluation).facts(),
    }


def mechanics_facts(band: MechanicsBand | None, lift: PathMotion) -> dict[str, Any] | None:
    """Facts on friction, drag and torques; None if the design has no [mechanics]."""
    if band is None:
        return None
    need = holding(lift, band)
    return {
        "rod_force_N": band.rod_force,
        "rod_rate_N_per_mm": band.rod_rate,
        "friction": list(band.friction),
        "drag_Nmm": list(band.drag),
        "play_behind_drag_deg": degrees(band.behind),
        "torque_ahead_Nmm": need.torque,
        "torque_ahead_at_deg": degrees(need.cam_angle),
        "torque_ahead_at_least_friction_Nmm": need.with_friction,
        "drag_to_build_Nmm": need.drag,
        "energy_of_that_drag_J": need.energy,
    }


def as_built_facts(design: Design, stop: float) -> dict[str, Any] | None:
    """Facts on a car as built: effects that count and effects only noted; None for a car as designed.

    Args:
        design: loaded design.
        stop: cam angle at which the path ends, rad.
    """
    record = design.as_built
    if record is None:
        return None
    known = cam_model.as_built(design)
    effects, noted = (
        [
            effect.model_dump(mode="json", exclude_none=True)
            for effect in record.effects
            if (effect.place == Place.NOTED) is aside
        ]
        for aside in (False, True)
    )
    return {
        "measured_with": record.profile,
        "sources": [source.model_dump(mode="json") for source in record.sources],
        "effects": effects,
        "noted": noted,
        "stop": {
            "cam_angle_deg": degrees(stop),
            "as_designed_deg": degrees(stop_as_designed(design)),
            "wheel_turns": None if design.train is None else stop / TURN * float(gear_model.train(design).ratio),
        },
        "play_measured": variation.measured_play(design) is not None,
        "friction_measured": None if known.friction is None else known.friction[0],
        "play_found_without_friction": known.runs_free,
        "phase_deg": degrees(known.phase),
        "key_turned_deg": -degrees(known.phase) if cam_model.has_key(design) else None,
    }


def remedy_facts(remedy: Remedy) -> dict[str, Any]:
    """Facts on a remedy against play."""
    return {"remedy": remedy.name, **remedy.figures.facts(), "build": remedy.build}
