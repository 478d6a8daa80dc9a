"""Calibrated cars of a workshop -> what they differ by, from all that their records show, claimed or not."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from cadgen.design.schema import Design
from cadgen.inference.expectation.linear import WIDE, Linear
from cadgen.inference.expectation.next_measurement import proposals
from cadgen.inference.measurement.findings import EvidenceDiagnosis
from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.record import join
from cadgen.inference.workshop import Habit, Shown, learn
from cadgen.jobs.calibration.advice import prior_of
from cadgen.jobs.calibration.calibration import CalibrationPlan
from cadgen.jobs.calibration.cam_on_car import nominal_of
from cadgen.jobs.calibration.workshop import Workshop, is_known

LEAST_CARS = 3  # of two, a spread is hardly more than a guess
_SEEN = 2.0  # cars' worth below which a number is left to the tolerances of the design


def workshop_of(design: Design, calibrations: Sequence[CalibrationPlan]) -> Workshop | None:
    """Workshop of the cars that were calibrated, one by each calibration; None with fewer than three cars.

    Args:
        design: loaded design by which they were made.
        calibrations: one of each car.
    """
    told = [each for each in calibrations if each.nominal is not None and _evidence(each)]
    if len(told) < LEAST_CARS:
        return None
    nominal = nominal_of(design, told[0].profile)
    prior = prior_of(design, nominal, None)
    scales = dict(prior.spread)
    if prior.play > 0:
        scales["return_error_deg"] = prior.play
    parts = [_shown(each, scales) for each in told]
    names = list(dict.fromkeys(name for part in parts for name in part.names))
    if not names:
        return None
    scale = {name: part.scale[n] for part in parts for n, name in enumerate(part.names)}
    cars = []
    for part in parts:
        at = [names.index(name) for name in part.names]
        information, pull = np.zeros((len(names), len(names))), np.zeros(len(names))
        information[np.ix_(at, at)], pull[at] = part.shown.information, part.shown.pull
        cars.append(Shown(information, pull))
    effects = list(dict.fromkeys(effect for effect, _ in names))
    try:
        learned = learn(cars, [effects.index(effect) for effect, _ in names])
    except np.linalg.LinAlgError:  # records that tell too little leave the tolerances of the design
        return None
    habits = []
    for n, (effect, name) in enumerate(names):
        if learned.cars[n] < _SEEN:
            continue
        mean, spread, least, most = (
            scale[effect, name] * float(each[n]) for each in (learned.mean, learned.spread, learned.least, learned.most)
        )
        habits.append(Habit(effect, name, mean, spread, least, most, float(learned.cars[n])))
    return Workshop(design=design.name, cars=len(told), habits=tuple(habits))


def _evidence(calibration: CalibrationPlan) -> list[EvidenceDiagnosis]:
    return [d for d in calibration.diagnoses if isinstance(d, EvidenceDiagnosis) and not d.contradicted]


@dataclass(frozen=True, eq=False)
class _CarNumbers:
    """Information of one car's records, with the names of its numbers, by effect, and their scales, internal units."""

    names: list[tuple[str, str]]
    scale: list[float]
    shown: Shown


def _shown(calibration: CalibrationPlan, spread: Mapping[str, float]) -> _CarNumbers:
    """Information of a car's records on the numbers that cars differ by, with all others integrated out."""
    nominal, diagnoses = calibration.nominal, _evidence(calibration)
    assert nominal is not None
    records = [join([source.record for source in calibration.files(d.kind)]) for d in diagnoses]
    measured = [record.kind for record in records]
    others = {p.kind: p.record for p in proposals(nominal, [], measured) if p.kind is TRACK and p.record}
    linear = Linear.of(nominal, records, diagnoses, {} if TRACK in measured else others, spread)
    about = linear.best
    rows = linear.measured_rows(about)
    whole = np.asarray(sum(one.information() for one in rows))
    at = np.zeros(linear.size)
    active = {effect.key: values for effect, values in about}
    kept: list[int] = []
    nuisance: list[int] = list(range(len(linear.scale), linear.size))
    wide = dict.fromkeys(nuisance, 1.0)
    names = []
    for effect, span in zip(linear.effects, linear.spans, strict=True):
        mine = range(span.start, span.stop)
        if effect.key in active:
            at[span] = active[effect.key] / linear.scale[span]
        smooth = not any(number.stepwise for number in effect.parameters)
        varied = smooth and not (effect.member or effect.shape or effect.beside or effect.instrument)
        known = all(is_known(effect.name, number.name) for number in effect.parameters)
        if varied and known and all(whole[n, n] > 0 for n in mine):
            kept += mine
            names += [(effect.name, number.name) for number in effect.parameters]
        elif effect.key in active or not effect.beside:
            nuisance += mine
            wide |= dict.fromkeys(mine, WIDE**-2 if effect.key in active else 1.0)
    pull = whole @ at + linear.pull(rows, about)
    inner = whole[np.ix_(nuisance, nuisance)] + np.diag([wide[n] for n in nuisance])
    side = np.linalg.solve(inner, whole[np.ix_(nuisance, kept)]).T
    information = whole[np.ix_(kept, kept)] - side @ whole[np.ix_(nuisance, kept)]
    shown = Shown((information + information.T) / 2, pull[kept] - side @ pull[nuisance])
    return _CarNumbers(names, [float(linear.scale[n]) for n in kept], shown)
