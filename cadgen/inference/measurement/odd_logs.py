"""Logged runs that are not of the others' vehicle, state or unit: they are left out, and named.

Errors of logged runs add up along the path and differ from run to run, so that no noise tells an odd one. It is told by
what the vehicle can do. All effects of the catalogue are fitted to all runs so that a few odd ones do not pull them.
A run is odd that stays far off there, and that the runs without it do not predict either. A run on another path than
the others is not odd: the joint fit knows its effects.
"""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from cadgen.arrays import Array
from cadgen.deviations.effect import activated
from cadgen.inference.measurement.model import Model
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.odd_runs import MOST_OUT, NEAR, OTHERS_CAR
from cadgen.inference.measurement.record import SLIPS, Record
from cadgen.inference.measurement.runs_left_out import LoggedRun, leave_runs_out, single_fit
from cadgen.messages import Message

# Fewer runs have no majority that can be fitted.
LEAST_RUNS = 4
# An odd run is so many times as far off as the farthest of the others, fitted together and predicted. Good runs of
# measured vehicles are up to twice as far off as the farthest of the others.
APART = 3.0
# Fits by weights until these settle, and the least error that weighs a run, as a share of the middle one.
_FITS, _LEAST_ERROR = 8, 0.3


def odd_logs(record: Record, logged: LoggedCar) -> dict[int, Message]:
    """Runs that are not of the others' vehicle, by number from 0, with what is off about each.

    Args:
        record: logged runs of a kind that is judged on runs left out.
        logged: the vehicle.
    """
    model = record.kind.model
    assert model is not None

    def build(part: Record) -> Model:
        made: Model = model(part, logged)
        return made

    found: dict[int, Message] = {}
    kept = np.arange(record.runs)
    models = [build(record.only(np.array([k]))) for k in kept]
    most = max(1, int(MOST_OUT * record.runs))
    while len(kept) >= LEAST_RUNS and len(found) < most:
        errors = _together([models[k] for k in kept])
        worst = int(np.argmax(errors))
        if errors[worst] < APART * float(np.delete(errors, worst).max()):
            break
        others = np.delete(kept, worst).astype(np.intp)
        chosen = leave_runs_out(record.only(others), build).chosen
        odd, rest = int(kept[worst]), float(chosen.held_out.max())
        size = LoggedRun.of(models[odd]).error(activated(chosen.effects, chosen.values))
        if size < APART * rest:
            break
        found[odd] = Message(
            "it is {size:.0f} mm off the path that the others predict, which predict each other to {rest:.0f} mm: "
            "{why}",
            size=size,
            rest=rest,
            why=_why(record, odd, others, logged),
        )
        kept = others
    return found


def _together(models: list[Model]) -> Array:
    """Path error of each run, all effects fitted to all runs by the least sum of path errors, shape (runs,), mm.

    The sum of e_k over runs, not of their squares, is least where each run weighs 1 / e_k: an odd run among several
    does not pull it.
    """
    runs, effects = [LoggedRun.of(model) for model in models], models[0].catalogue
    bounds = np.concatenate([e.bounds for e in effects], axis=1)
    steps, start = np.concatenate([e.steps for e in effects]), np.concatenate([e.start for e in effects])

    def errors(values: Array) -> Array:
        return np.array([run.error(activated(effects, values)) for run in runs])

    def fit(values: Array) -> Array:
        for _ in range(_FITS):
            each = errors(values)
            weights = np.maximum(each, max(_LEAST_ERROR * float(np.median(each)), 1e-9)) ** -0.5

            def off(v: Array, weights: Array = weights) -> Array:
                active = activated(effects, v)
                return np.concatenate([w * r.residual(active) for w, r in zip(weights, runs, strict=True)])

            def slopes(v: Array, weights: Array = weights) -> Array:
                active = activated(effects, v)
                return np.concatenate([w * r.tangents(effects, active) for w, r in zip(weights, runs, strict=True)])

            values = least_squares(
                off, values, jac=slopes, bounds=(bounds[0], bounds[1]), x_scale=steps, ftol=1e-4, max_nfev=10
            ).x
        return np.asarray(values)

    # A log in another scale is off by several times, from where no fit comes down from nothing.
    firsts = [start]
    ends = np.cumsum([len(e.start) for e in effects])
    for effect, (first, last) in zip(effects, pairwise([0, *ends.tolist()]), strict=True):
        alone = start.copy()
        alone[first:last] = single_fit(runs, effect)
        firsts.append(alone)
    best = min(firsts, key=lambda values: float(errors(values).sum()))
    return min((errors(fit(values)) for values in (start, best)), key=lambda e: float(e.sum()))


def _why(record: Record, odd: int, others: NDArray[np.intp], logged: LoggedCar) -> Message:
    """Reason that may be: another unit, if what is measured spans as much less or more than in the other runs."""

    def spans(run: int) -> list[tuple[str, float]]:
        each = record.kind.spans(record.only(np.array([run])), logged)
        return [(span.unit, span.measured / max(span.expected, 1e-300)) for span in each]

    usual = np.median([[ratio for _, ratio in spans(int(run))] for run in others], axis=0)
    for (unit, ratio), of_others in zip(spans(odd), usual, strict=True):
        for other, factor in SLIPS.get(unit, {}).items():
            if factor / NEAR < ratio / of_others < factor * NEAR:
                return Message("it seems to be in {other} and not in {unit}", other=other, unit=unit)
    return OTHERS_CAR
