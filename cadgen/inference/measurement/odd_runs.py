"""Runs that are not of the others' car, state or unit, or that are copies of another: they are left out, and named.

One run of another car among several makes the noise between runs large, so that nothing is found, or the wrong thing.
It is told by what is left of the noise without it. The majority is taken as right. A copy repeats the noise, too, and
so makes it seem to be none, beside which every other run is odd.
"""

from collections.abc import Callable
from itertools import combinations

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import UNITS, Active
from cadgen.inference.measurement.evidence import estimate_noise
from cadgen.inference.measurement.model import Model, repeating, rms_by_run, slopes
from cadgen.inference.measurement.record import SLIPS, Record
from cadgen.messages import Message

# Fewer runs have no majority.
LEAST_RUNS = 3
# A run is another's if without it the noise falls to this share or less. Of n equal runs of scatter s and one that is
# off by d, that needs d > s sqrt(8 n).
OTHERS = 1 / 3
# A run is looked at if it is so many times as far from the mean of all as the middle one. Of three runs of which one is
# off by d that is 2/3 d against d/3.
APART = 1.5
# More than this share of the runs are not left out: then it is not known which are the odd ones.
MOST_OUT = 1 / 3
# Spans of a mistaken unit agree with its factor within this ratio: all else of two cars is alike.
NEAR = 1.15
# A run that repeats another in each of so many rows or more is its copy, if others differ in this share of the rows:
# an instrument of coarse steps repeats itself in all runs.
LEAST_ROWS, DIFFER = 20, 0.1
OTHERS_CAR = Message("it is of another car, or of this one in another state, or something slipped in it")
_STEPS = 4  # of Gauss and Newton, by which the datum of a turned start converges


def odd_runs(record: Record, build: Callable[[Record], Model]) -> dict[int, Message]:
    """Runs that are not of the others' car, by number from 0, with what is off about each.

    Args:
        record: of any kind that is judged by the evidence.
        build: makes the forward model of some of the runs.
    """
    found = copies(record)
    kept = np.setdiff1d(np.arange(record.runs), list(found))
    most = len(found) + max(1, int(MOST_OUT * len(kept)))
    while len(kept) >= LEAST_RUNS and len(found) < most:
        here = record.only(kept)
        model = build(here)
        left = _registered(model)
        sizes = rms_by_run(_beside_others(model, left), model.rows.run)
        worst = int(np.argmax(sizes))
        if sizes[worst] < APART * float(np.median(np.delete(sizes, worst))):
            break
        others = build(here.only(np.delete(np.arange(here.runs), worst)))
        rest = estimate_noise(others, _registered(others)).rms
        if not rest < OTHERS * estimate_noise(model, left).rms:
            break
        found[int(kept[worst])] = Message(
            "it is off the others by {size:.3g} {unit}, which differ by {rest:.3g} {unit} among each other: {why}",
            size=sizes[worst] / UNITS[model.unit],
            rest=rest / UNITS[model.unit],
            unit=model.unit,
            why=_why(here, worst),
        )
        kept = np.delete(kept, worst)
    return found


def copies(record: Record) -> dict[int, Message]:
    """Runs that repeat an earlier one to the last digit, by number from 0, where others do not repeat each other.

    Args:
        record: of any kind with runs.
    """
    runs = [np.stack([record[c][mine] for c in record.kind.readings]) for mine in record.parts]
    pairs = [(a, b) for a, b in combinations(range(len(runs)), 2) if runs[a].shape == runs[b].shape]
    differ = {(a, b): float(np.mean((runs[a] != runs[b]).any(axis=0))) for a, b in pairs}
    if max(differ.values(), default=0.0) < DIFFER:
        return {}
    return {
        later: Message("it repeats an earlier run to the last digit, noise and all: it is a copy")
        for (_, later), share in differ.items()
        if share == 0.0 and runs[later].shape[1] >= LEAST_ROWS
    }


def _registered(model: Model) -> Array:
    """Residual without effects, less the datum of each run, whose turned starts are no columns."""
    active: Active = [(e, np.asarray(e.start, dtype=float)) for e in model.datum]
    for _ in range(_STEPS if active else 0):
        answer = slopes(model, model.datum, active)
        columns = np.hstack([model.offsets, answer])
        fit = np.linalg.lstsq(columns, model.residual(active), rcond=1e-9)[0][model.offsets.shape[1] :]
        moved, first = [], 0
        for effect, values in active:
            moved.append((effect, np.clip(values + fit[first : first + len(values)], *effect.bounds)))
            first += len(values)
        active = moved
    residual = model.residual(active)
    return np.asarray(residual - model.offsets @ np.linalg.lstsq(model.offsets, residual, rcond=1e-9)[0])


def _beside_others(model: Model, residual: Array) -> Array:
    """Residual of each run less what all runs together repeat: the mean under equal conditions, or a smooth fit."""
    cell = model.rows.cell
    if cell.min() >= 0 and cell.max() + 1 < len(cell):
        count = np.bincount(cell)
        return np.asarray(residual - (np.bincount(cell, weights=residual) / np.maximum(count, 1))[cell])
    columns = np.hstack([np.ones((len(residual), 1)), repeating(model)])
    return np.asarray(residual - columns @ np.linalg.lstsq(columns, residual, rcond=1e-9)[0])


def _why(record: Record, odd: int) -> Message:
    """Reason that may be: another unit, if the run spans as much less or more than the others."""
    unit = record.kind.reading_unit
    spans = [np.array([np.ptp(record[c][mine]) for mine in record.parts]) for c in record.kind.readings]
    ratio = float(np.mean([each[odd] / max(float(np.median(np.delete(each, odd))), 1e-300) for each in spans]))
    for other, factor in SLIPS.get(unit, {}).items():
        if factor / NEAR < ratio < factor * NEAR:
            return Message("it seems to be in {other} and not in {unit}", other=other, unit=unit)
    return OTHERS_CAR
