"""Figures of a car's cam as facts: play, friction, the car as built; keys name the units."""

from math import degrees

from cadgen.arrays import TURN
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.remedies import holding
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.design import cam_model, gear_model, variation
from cadgen.design.schema import Design
from cadgen.deviations.deviation import Place
from cadgen.figures import Facts
from cadgen.jobs.cam.built_car import stop_as_designed
from cadgen.jobs.cam.comparison import PAPER_PERCENT, PlayComparison
from cadgen.jobs.cam.remedies import Remedy


def comparison_facts(comparison: PlayComparison) -> Facts:
    """Facts on the profiles compared against play."""
    low, high = comparison.band.ends
    bound, measured = comparison.bound, comparison.band.measured
    gain, chosen = comparison.worst_gain(bound.distance), comparison.chosen
    windows = [degrees(window) for window in chosen.windows]
    return Facts(
        return_error_deg=Facts(
            least=degrees(low),
            greatest=degrees(high),
            measured=None if measured is None else degrees(measured),
            cut_for=degrees(chosen.made_for),
            **({"cut_for_each_lead": windows} if chosen.by_lead else {}),
        ),
        mechanics=mechanics_facts(comparison.task.mechanics, comparison.chosen.lift),
        friction_note=comparison.rubbing,
        before=_evaluation_facts(comparison, comparison.before),
        after=_evaluation_facts(comparison, comparison.chosen),
        compared=[_evaluation_facts(comparison, evaluation) for evaluation in comparison.evaluations],
        reasons=comparison.reasons,
        # For a rod that slides without friction.
        bound_with_same_peaks_and_valleys=None
        if comparison.task.mechanics
        else Facts(
            worst_end_heading_deg=degrees(bound.heading),
            worst_end_position_mm=bound.distance,
            worst_position_percent_off=None if gain is None else 100 * gain,
        ),
        paper_percent_off=PAPER_PERCENT,
    )


def _evaluation_facts(comparison: PlayComparison, evaluation: Evaluation) -> Facts:
    return Facts(
        profile=evaluation.profile.code, as_measured=evaluation.measured, train=evaluation.train
    ) | comparison.figures(evaluation)


def mechanics_facts(band: MechanicsBand | None, lift: PathMotion) -> Facts | None:
    """Facts on friction, drag and torques; None if the design has no [mechanics]."""
    if band is None:
        return None
    need = holding(lift, band)
    return Facts(
        rod_force_N=band.rod_force,
        rod_rate_N_per_mm=band.rod_rate,
        friction=band.friction,
        drag_Nmm=band.drag,
        play_behind_drag_deg=degrees(band.behind),
        torque_ahead_Nmm=need.torque,
        torque_ahead_at_deg=degrees(need.cam_angle),
        torque_ahead_at_least_friction_Nmm=need.with_friction,
        drag_to_build_Nmm=need.drag,
        energy_of_that_drag_J=need.energy,
    )


def as_built_facts(design: Design, stop: float) -> Facts | None:
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
    return Facts(
        measured_with=record.profile,
        sources=[source.model_dump(mode="json") for source in record.sources],
        effects=effects,
        noted=noted,
        stop=Facts(
            cam_angle_deg=degrees(stop),
            as_designed_deg=degrees(stop_as_designed(design)),
            wheel_turns=None if design.train is None else stop / TURN * float(gear_model.train(design).ratio),
        ),
        play_measured=variation.measured_play(design) is not None,
        friction_measured=None if known.friction is None else known.friction[0],
        play_found_without_friction=known.runs_free,
        phase_deg=degrees(known.phase),
        key_turned_deg=-degrees(known.phase) if cam_model.has_key(design) else None,
    )


def remedy_facts(remedy: Remedy) -> Facts:
    """Facts on a remedy against play."""
    return Facts(remedy=remedy.name) | remedy.figures | Facts(build=remedy.build)
