"""The choice among profiles: by the limits of [optimize] and by the checks of the cam."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import degrees

import numpy as np

from cadgen.car.against_play.band import PlayBand, over_band
from cadgen.car.against_play.evaluate import Evaluation, FigureLimit, ProfileCandidate, choose
from cadgen.car.against_play.remedies import trims
from cadgen.check import failing
from cadgen.design.play import Hardware
from cadgen.design.schema import Design
from cadgen.errors import CheckError
from cadgen.jobs.cam.checking import ProfileChecks

LIFT_ERROR = "lift error with play"


@dataclass(frozen=True)
class Best:
    """Profile chosen on a train, and a sentence on each profile compared."""

    evaluation: Evaluation
    reasons: tuple[str, ...]


def best_of(
    evaluations: Sequence[Evaluation], band: PlayBand, checks: ProfileChecks, old: Evaluation | None = None
) -> Best:
    """Best profile that keeps the limits and passes its checks; profiles are checked in order of merit.

    Args:
        evaluations: profiles evaluated on one train, at least one.
        band: return error of that train, rad.
        checks: checks of the design's profiles.
        old: cam that the car has, on the same train: where that misses the lift by more than is allowed, no new one is
            refused for missing it by less. None without.

    Returns:
        If no profile passes its checks, the best without them, so that its own checks show what fails.

    Raises:
        CheckError: no profile keeps the limits of [optimize].
    """
    allowed, deciding = _limits(checks.design, band), _deciding(band)
    missed: tuple[str, ...] = ()
    if old is not None:
        allowed, missed = _lifted(allowed, old, evaluations)
        for limit in allowed if missed else ():
            if limit.figure == LIFT_ERROR:
                checks.allow_lift_error(limit.most)
    remaining = {str(evaluation.profile): evaluation for evaluation in evaluations}
    candidates = {
        name: ProfileCandidate(name=name, figures=_figures(checks, evaluation, band))
        for name, evaluation in remaining.items()
    }
    first = remaining[choose(list(candidates.values()), allowed, objective=deciding, unit="mm").best.name]
    refused: list[str] = []
    while remaining:
        try:
            choice = choose([candidates[name] for name in remaining], allowed, objective=deciding, unit="mm")
        except CheckError as error:  # those left were never allowed
            refused.append(f"of the others, {error}")
            break
        best = remaining.pop(choice.best.name)
        failed = [check.name for check in failing(checks.of(best))]
        if not failed:
            return Best(best, (*refused, *choice.reasons, *missed))
        refused.append(f"{best.profile} refused: it fails {', '.join(failed)}")
    return Best(first, (*refused, *missed))


def _deciding(band: PlayBand) -> str:
    """Name of the figure that decides the choice: with a measured play other cars do not matter."""
    return "worst end position error" if band.measured is None else "position error at the end with the measured play"


def _heading(band: PlayBand) -> str:
    return _deciding(band).replace("position", "heading")


def _limits(design: Design, band: PlayBand) -> tuple[FigureLimit, ...]:
    """Limits of [optimize]."""
    keys = design.optimize
    limits = (
        (_deciding(band), keys.max_end_position_mm, "mm"),
        (_heading(band), keys.max_end_heading_deg, "degrees"),
        ("position error on the run", keys.max_run_position_mm, "mm"),
        (LIFT_ERROR, keys.max_lift_error_um, "µm"),
    )
    return tuple(FigureLimit(figure=name, most=most, unit=unit) for name, most, unit in limits if most is not None)


def _lifted(
    limits: tuple[FigureLimit, ...], old: Evaluation, evaluations: Sequence[Evaluation]
) -> tuple[tuple[FigureLimit, ...], tuple[str, ...]]:
    """Limits with that of the lift error raised to the old cam's, if no profile keeps it; and that in words."""
    least, had = (1e3 * error for error in (min(e.worst_lift_error for e in evaluations), old.worst_lift_error))
    raised = [limit for limit in limits if limit.figure == LIFT_ERROR and limit.most < least < had]
    if not raised:
        return limits, ()
    words = (
        f"no profile keeps the lift error with play within the {raised[0].most:g} µm of optimize.max_lift_error_um: "
        f"{least:.0f} µm at least, but the cam that was measured has {had:.0f} µm on this car"
    )
    return tuple(replace(limit, most=had) if limit in raised else limit for limit in limits), (words,)


def _figures(checks: ProfileChecks, evaluation: Evaluation, band: PlayBand) -> dict[str, float]:
    """Errors of a profile by the names of their limits in [optimize]; after the trim, if the design allows a trim."""
    task, hardware = checks.task, checks.design.optimize.hardware or ()
    heading, distance = evaluation.band.worst_heading, evaluation.band.worst_distance
    if band.measured is not None and task.mechanics is None:
        heading, distance = abs(evaluation.error.end_heading), evaluation.error.end_distance
    elif band.measured is not None and task.mechanics is not None:
        at_play = over_band(
            evaluation.rolled,
            task.lift,
            task.car,
            task.length,
            np.array([band.measured]),
            least_swing=evaluation.least_swing,
            mechanics=task.mechanics.cases,
            cut=evaluation.lift,
        )
        heading, distance = at_play.worst_heading, at_play.worst_distance
    if task.mechanics and Hardware.TRIM in hardware:
        plays = band.ends if band.measured is None else (band.measured,)
        trimmed = [trim.error for trim in trims(task, evaluation.rolled, evaluation.lift, plays, task.mechanics.cases)]
        heading = max(abs(error.end_heading) for error in trimmed)
        distance = max(error.end_distance for error in trimmed)
    return {
        _deciding(band): distance,
        _heading(band): degrees(heading),
        "position error on the run": float(evaluation.error.distance.max()),
        LIFT_ERROR: evaluation.worst_lift_error * 1e3,
    }
