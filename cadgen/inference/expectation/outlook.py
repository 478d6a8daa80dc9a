"""Ends of the runs of a car as built, on its present cam and on the cam that would be cut next.

Both cams are driven, with what the car has. What it has is drawn from the likely subsets, claimed or not, by their
weights, and within each from its normal distribution about the values found:

    old error = P(cam on the car, p) - F,    new error = P(cam as it will be cut, q) - F,

where F is the planned end of the run, P the end by the model of a track, p one draw, and q the same without what goes
with the old disc. Play and friction act with their whole effect; what effects on disc and rod do to the lift is rolled
for the values found, and to first order about them. To each error comes what the records show beside all effects: on
the old cam as it was measured, on the new one as the path there answers it, for a car that creeps across its heading
heads elsewhere. What a car drawn has more of an effect it has less of this, so that it ends on the old cam where it was
measured. To the new error comes what the form error of the new disc makes of it, which is another one than the old
disc's: with the spectrum that the old one shows for one half of the draws, as of one shop, and with any that is stated
for the other. Where the names are not sure, an effect without a name may stand behind some of them, which acts on the
new cam in another way: its error goes by how far that cam moves the end.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect
from cadgen.deviations.track import RETURN_ERROR, SLIDING_FRICTION
from cadgen.inference.measurement.evidence import GRID, Spectrum
from cadgen.inference.measurement.findings import EvidenceDiagnosis, Likely
from cadgen.inference.measurement.kinds.track import KIND, TrackModel, run_of
from cadgen.inference.measurement.model import repeating
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.verdict import Verdict

DRAWS = 200
LEAST_CHANCE = 0.01  # smaller ones cannot be told by so few draws
RANGE = (5.0, 95.0)  # percent
# A rest of this many times the noise is not explained, and what the new cam will do is not known.
EXPLAINED = 1.3
# A new cam that is worse than the old one with more than this chance is not cut without being told to.
WORSE = 0.05
# Chance that form errors of both discs have one spectrum, as cut on one machine in one way. No record of one disc
# tells: machine and program repeat, clamping, cutter and blank do not, and the next shop may be another.
SAME_SHOP = 1 / 2
# What is not sure by name may do to another cam what it does not do to this one: the chance of that, and the error of
# each coordinate of the end then, as a share of the change. Two of seven such cars of the study of circles, of its
# seed 28, ended 8 and 12 % of it off; the others, 2 % in the mean.
NOT_SURE = (2 / 7, 0.07)
# A gain smaller than this is none: two cams that end as near as a car can be set again, mm.
SAME = 1.0

Name = tuple[str, str]  # code of the kind of data that an effect is claimed in, and its name there
Band = tuple[float, float]


@dataclass(frozen=True)
class Outlook:
    """Expected errors at the end of the run on the old cam and on a new one.

    Attributes:
        old, new: distance from the planned end of the run, median of the draws, mm.
        least, most: between which the new one lies with a chance of 90 %, mm.
        worse: chance that the new one is farther off than the old one.
        explained: whether the effects found explain the measured runs; None where no track was measured.
        contradicted: whether the records contradict each other, and were judged apart.
    """

    old: float
    new: float
    least: float
    most: float
    worse: float
    explained: bool | None
    contradicted: bool = False

    @property
    def sound(self) -> bool:
        """Whether nothing speaks against cutting it."""
        return self.explained is not False and self.worse <= WORSE


@dataclass(frozen=True, kw_only=True)
class NextCam:
    """A cam planned for what was claimed, as it will be cut.

    Attributes:
        nominal: the car as designed with that cam on it, set so that the phase found is gone.
        gone: what goes with the old disc.
    """

    nominal: Nominal
    gone: frozenset[Name]


@dataclass(frozen=True, kw_only=True)
class Unmeasured:
    """Play and friction that a car may have where no track shows how it runs, rad and 1: from least to greatest.

    Attributes:
        play: return error.
        friction: between rod and disc.
    """

    play: Band = (0.0, 0.0)
    friction: Band = (0.0, 0.0)


def outlook(
    diagnoses: Sequence[EvidenceDiagnosis], nominal: Nominal, new: NextCam, planned: complex, unmeasured: Unmeasured
) -> Outlook:
    """Drive the car on the cam that it has, and on the next one.

    Args:
        diagnoses: what the records of the car show, by one verdict.
        nominal: the car as designed with the cam that is on it.
        new: the next cam.
        planned: end of the planned run, x + iy, mm.
        unmeasured: play and friction, of a car without a track.
    """
    track = next((d for d in diagnoses if d.kind is KIND), None)
    # All records have one judgement, but where they are judged apart: then the track knows best how the car runs.
    likeliest = (track or min(diagnoses, key=lambda d: d.apart)).likely
    rng = np.random.default_rng(0)
    counts = rng.multinomial(DRAWS, [likely.weight for likely in likeliest])
    models = run_of(nominal), run_of(new.nominal)
    ends: tuple[list[NDArray[np.complex128]], ...] = ([], [])
    rests = np.full((2, DRAWS), -planned)
    spectra, beside = any_spectra(DRAWS, rng), _at_finish(models[1])
    for likely, first, count in zip(likeliest, np.cumsum(counts) - counts, counts.tolist(), strict=True):
        if count:
            off = _about(likely, count, rng)
            if likely.unnamed:
                drawn = rng.choice(len(likely.unnamed), count, p=[one.weight for one in likely.unnamed])
                for car, one in enumerate(likely.unnamed[n] for n in drawn):
                    # A form error beyond what is stated may be no disc's.
                    kept = np.arange(len(one.end)) >= (one.orders if one.spectrum.within else 0)
                    both = np.stack([one.end, kept * beside])
                    both = np.vstack([both.real, both.imag])
                    # What the effects make more of, the rest makes less of: the car ends where it was measured.
                    rest = both @ (one.values + one.answer @ off[car]), both @ one.covariance @ both.T
                    moved = rng.multivariate_normal(*rest, check_valid="ignore", method="eigh")
                    rests[:, first + car] += moved[:2] + 1j * moved[2:]
                    # Half of the discs are the same shop's: the new one has the spectrum that this one shows.
                    if one.spectrum.within and rng.random() < SAME_SHOP:
                        spectra[first + car] = one.spectrum
            cars = _drawn(models[0], likely, off, rng, None if track else unmeasured)
            ends[0].append(_ends(models[0], cars, count))
            left = [car for car in cars if car.name not in new.gone and not car.of_disc]
            ends[1].append(_ends(models[1], left, count))
    before, after = (np.concatenate(each) + rest for each, rest in zip(ends, rests, strict=True))
    if track is not None and track.verdict in (Verdict.AMBIGUOUS, Verdict.PARTIAL):
        either = rng.standard_normal(DRAWS) + 1j * rng.standard_normal(DRAWS)
        after = after + (rng.random(DRAWS) < NOT_SURE[0]) * NOT_SURE[1] * np.abs(after - before) * either
    old, on_new = np.abs(before), np.abs(after + new_form(models[1], DRAWS, rng, spectra))
    least, most = np.percentile(on_new, RANGE)
    explained = False if any(d.apart for d in diagnoses) else None
    if track is not None:
        # The effects, with what repeats beside them, leave no more than noise on the runs left out.
        r = track.residual
        remains = r.after if r.left_out is None else r.left_out.repeating
        quiet = bool(remains <= EXPLAINED * r.noise)
        explained = track.verdict not in (Verdict.UNEXPLAINED, Verdict.RUNS_DISAGREE) and quiet
    return Outlook(
        old=float(np.median(old)),
        new=float(np.median(on_new)),
        least=float(least),
        most=float(most),
        worse=float(np.mean(on_new > old + SAME)),
        explained=explained,
        contradicted=all(d.apart for d in diagnoses),
    )


def any_spectra(count: int, rng: np.random.Generator) -> list[Spectrum]:
    """Spectra of form errors within what is stated, any as likely as any other.

    How a form error is spread over the orders is not known: a wave of the whole turn moves the end most.
    """
    stated = [spectrum for spectrum in GRID if spectrum.within]
    return [stated[n] for n in rng.integers(len(stated), size=count)]


def _at_finish(model: TrackModel) -> NDArray[np.complex128]:
    """Finish of a planned track by each coefficient of what repeats without a name, x + iy, shape (q + k,), mm."""
    x, y = repeating(model)[[len(model.form) // 2 - 1, -1]]  # rows are first all x, then all y
    return np.asarray(x + 1j * y)


def new_form(
    model: TrackModel, count: int, rng: np.random.Generator, spectra: Sequence[Spectrum] = ()
) -> NDArray[np.complex128]:
    """By how much the form errors of discs to be cut, as stated, move the end, x + iy, shape (count,), mm.

    Args:
        model: of a track on such a disc.
        count: how many discs.
        rng: source of random numbers.
        spectra: spectrum of each disc; any if left out.
    """
    by_each = _at_finish(model)[: model.form.shape[1]]
    of_each = spectra or any_spectra(count, rng)
    known = {spectrum: spectrum.variance(model.order, model.floor) for spectrum in set(of_each)}
    sizes = np.sqrt([known[spectrum] for spectrum in of_each])
    return np.asarray(sizes * rng.standard_normal(sizes.shape) @ by_each)


@dataclass(frozen=True)
class _DrawnEffect:
    """An effect of many cars: its values as found, shape (k,), and those of each car, shape (cars, k)."""

    name: Name
    effect: Effect
    found: Array
    values: Array

    @property
    def of_disc(self) -> bool:
        """Whether it is a form without a name that a record of the disc shows: it goes with the disc."""
        return self.effect.shape and self.effect.form_of is not None


def _about(likely: Likely, count: int, rng: np.random.Generator) -> Array:
    """By how much the values of cars drawn are off those found, shape (count, p), each within its bounds."""
    if not likely.effects:
        return np.empty((count, 0))
    found = np.concatenate([numbers for _, _, numbers in likely.effects])
    bounds = np.hstack([effect.bounds for _, effect, _ in likely.effects])
    return np.asarray(np.clip(rng.multivariate_normal(found, likely.covariance, count), *bounds) - found)


def _drawn(
    model: TrackModel, likely: Likely, off: Array, rng: np.random.Generator, unmeasured: Unmeasured | None
) -> list[_DrawnEffect]:
    """Cars drawn from one subset, by their effects in a track; their values are `off` those found, shape (count, p).

    Where a track was measured, what does not act in it is not of the car's run: the play of a dial's stand is another
    play than the train's. Where none was, play and friction are drawn from what they may be.
    """
    cars, last = [], 0
    for (name, effect, numbers), kinds in zip(likely.effects, likely.shown, strict=True):
        first, last = last, last + len(numbers)
        acting = _in_track(model, effect, name[0]) if unmeasured or KIND.code in kinds else None
        if acting is not None:
            cars.append(_DrawnEffect(name, acting, numbers, np.clip(numbers + off[:, first:last], *acting.bounds)))
    if unmeasured is not None:
        for effect, band in ((RETURN_ERROR, unmeasured.play), (SLIDING_FRICTION, unmeasured.friction)):
            if band[1] > 0 and all(car.effect.deviation != effect.deviation for car in cars):
                name = KIND.code, effect.name
                cars.append(_DrawnEffect(name, effect, np.array([sum(band) / 2]), rng.uniform(*band, (len(off), 1))))
    return cars


def _ends(model: TrackModel, cars: Sequence[_DrawnEffect], count: int) -> NDArray[np.complex128]:
    """Ends of the runs of many cars on one cam, x + iy, shape (count,), mm."""
    rolled = [car for car in cars if car.effect.stage in model.rolled.stages]
    others = [car for car in cars if car.effect.stage not in model.rolled.stages]
    disc: Active = [(car.effect, car.found) for car in rolled]
    steps = [
        (model.rolled.first_order(car.effect, number, disc, model.rows), car.values[:, number] - car.found[number])
        for car in rolled
        for number in range(len(car.found))
    ]
    return np.array(
        [
            model.finish(
                [
                    *disc,
                    *((effect, by[car : car + 1]) for effect, by in steps),
                    *((other.effect, other.values[car]) for other in others),
                ]
            )
            for car in range(count)
        ]
    )


def _in_track(model: TrackModel, effect: Effect, kind: str) -> Effect | None:
    """Effect in the track that corresponds to one of any kind of data; None where it does not move the car."""
    if kind == KIND.code:
        return effect
    if effect.deviation is not None:
        same = next((e for e in KIND.catalogue.effects if e.deviation == effect.deviation), None)
        if same is not None:
            return same
    if effect.shape:
        return None if effect.form_of is None else model.rolled.shown(effect)
    return effect if effect.stage in model.behind and not effect.instrument else None
