"""Calibrated cars of a workshop -> what they differ by, from all that their records show, claimed or not."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.design.schema import Design
from cadgen.deviations.effect import Effect, Quantity
from cadgen.inference.expectation.linear import WIDE, Linear
from cadgen.inference.expectation.next_measurement import proposals
from cadgen.inference.measurement.findings import EvidenceDiagnosis
from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.record import join
from cadgen.inference.workshop import Habit, Shown, learn
from cadgen.jobs.calibration.advice import PLAY, prior_of
from cadgen.jobs.calibration.calibration import CalibrationPlan
from cadgen.jobs.calibration.cam_on_car import nominal_of
from cadgen.jobs.calibration.workshop import Workshop, can_be, is_known

LEAST_CARS = 3  # of two, a spread is hardly more than a guess
_SEEN = 2.0  # cars' worth below which a number is left to the tolerances of the design


def workshop_of(design: Design, calibrations: Sequence[CalibrationPlan]) -> Workshop | None:
    """Workshop of the cars that were calibrated, one by each calibration; None with fewer than three whose cam is sure.

    Args:
        design: loaded design by which they were made.
        calibrations: one of each car.
    """
    # What is found of a car by a cam that it does not have is not its own.
    told = [c for c in calibrations if c.nominal is not None and _evidence(c) and not c.cam_unknown]
    if len(told) < LEAST_CARS:
        return None
    nominal = nominal_of(design, told[0].profile)
    prior = prior_of(design, nominal, None)
    scales = dict(prior.spread)
    if prior.play > 0:
        scales[PLAY] = prior.play
    parts = [_shown(each, scales) for each in told]
    # By what it is: a record of one kind calls backlash what one of another calls return error.
    keys = list(dict.fromkeys(key for part in parts for key in part.keys))
    if not keys:
        return None
    called = {key: part.called[n] for part in parts for n, key in enumerate(part.keys)}
    scale = {key: part.scale[n] for part in parts for n, key in enumerate(part.keys)}
    cars = []
    for part in parts:
        at = [keys.index(key) for key in part.keys]
        information, pull = np.zeros((len(keys), len(keys))), np.zeros(len(keys))
        information[np.ix_(at, at)], pull[at] = part.shown.information, part.shown.pull
        cars.append(Shown(information, pull))
    things = list(dict.fromkeys(thing for thing, _ in keys))
    try:
        learned = learn(cars, [things.index(thing) for thing, _ in keys])
    except np.linalg.LinAlgError:  # records that tell too little leave the tolerances of the design
        return None
    habits: dict[str, list[Habit]] = {}
    for n, key in enumerate(keys):
        mean, spread, least, most = (
            scale[key] * float(each[n]) for each in (learned.mean, learned.spread, learned.least, learned.most)
        )
        habit = Habit(*called[key], key[1], mean, spread, least, most, float(learned.cars[n]))
        habits.setdefault(key[0], []).append(habit)
    # A size with a direction is known as a whole, or not at all.
    enough = [few for few in habits.values() if all(each.cars >= _SEEN and can_be(each) for each in few)]
    return Workshop(design=design.name, cars=len(told), habits=tuple(habit for few in enough for habit in few))


def _evidence(calibration: CalibrationPlan) -> list[EvidenceDiagnosis]:
    return [d for d in calibration.diagnoses if isinstance(d, EvidenceDiagnosis) and not d.apart]


@dataclass(frozen=True, eq=False)
class _CarNumbers:
    """Information of one car's records on its numbers.

    Attributes:
        keys: of the numbers.
        called: code of the kind of data that shows each, and name of its effect there.
        scale: of each, internal units.
        shown: information, in these scales.
    """

    keys: list[Quantity]
    called: list[tuple[str, str]]
    scale: list[float]
    shown: Shown


def _shown(calibration: CalibrationPlan, spread: Mapping[Quantity, float]) -> _CarNumbers:
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
    keys: list[Quantity] = []
    called: list[tuple[str, str]] = []
    chosen = _chosen(linear, whole, frozenset(active))
    for effect, span in zip(linear.effects, linear.spans, strict=True):
        mine = range(span.start, span.stop)
        if effect.key in active:
            at[span] = active[effect.key] / linear.scale[span]
        if effect.key in chosen:
            kept += mine
            keys += effect.quantities
            called += [chosen[effect.key]] * len(mine)
        elif effect.key in active or not effect.beside:
            nuisance += mine
            wide |= dict.fromkeys(mine, WIDE**-2 if effect.key in active else 1.0)
    pull = whole @ at + linear.pull(rows, about)
    inner = whole[np.ix_(nuisance, nuisance)] + np.diag([wide[n] for n in nuisance])
    side = np.linalg.solve(inner, whole[np.ix_(nuisance, kept)]).T
    information = whole[np.ix_(kept, kept)] - side @ whole[np.ix_(nuisance, kept)]
    shown = Shown((information + information.T) / 2, pull[kept] - side @ pull[nuisance])
    return _CarNumbers(keys, called, [float(linear.scale[n]) for n in kept], shown)


def _chosen(linear: Linear, information: Array, active: frozenset[str]) -> dict[str, tuple[str, str]]:
    """Effects that a car is known by: by their keys, the kind of data that shows each, and its name there.

    Of several that are one thing, such as backlash that a spring holds or does not, one that was found leads, and else
    the one on which the records say most.

    Args:
        linear: effects of the records and the directions that they span.
        information: of the records on each direction, shape (size, size).
        active: keys of the effects that were found.
    """
    best: dict[tuple[Quantity, ...], tuple[bool, float, Effect, tuple[str, str]]] = {}
    for effect, span in zip(linear.effects, linear.spans, strict=True):
        kind = linear.merged.kinds[effect.key]
        own = linear.merged.names[linear.kinds.index(kind)][effect.key]
        smooth = not any(number.stepwise for number in effect.parameters)
        varied = smooth and not (effect.member or effect.shape or effect.beside or effect.instrument)
        told = float(np.diag(information)[span].min())
        if varied and told > 0 and is_known(kind, own):
            one = (effect.key in active, told, effect, (kind.code, own.name))
            best[effect.quantities] = max(best.get(effect.quantities, one), one, key=lambda each: each[:2])
    return {effect.key: called for _, _, effect, called in best.values()}
