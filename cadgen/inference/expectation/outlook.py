"""The loop closed on paper: where the car as built ends, on the old cam and on a new one made for what is claimed.

A new cam takes out what is claimed and left to it, at the values found; everything else stays, and so does the error
of the values. To first order that error moves the end on the new cam as it does on the old one. With P the end of the
run on the cam that was measured, p what the car has, and c what the new cam is made for:

    old error = P(p) - P(0),    new error = P(p without what goes with the old disc) - P(c).

To each comes what the records show beside all effects, and to the new one what the form error of the new disc makes of
it, another one than the old disc's. p is drawn from the likely subsets, claimed or not, by their weights, and within
each from its normal distribution about the values found.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect
from cadgen.inference.measurement.findings import EvidenceDiagnosis, Likely
from cadgen.inference.measurement.kinds import kind_of
from cadgen.inference.measurement.kinds.track import KIND, TrackModel, run_of
from cadgen.inference.measurement.model import moved
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.reservations import TYPICAL
from cadgen.inference.measurement.verdict import Verdict

DRAWS = 4000
RANGE = (5.0, 95.0)  # percent
# A rest of this many times the noise is not explained, and what the new cam will do is not known.
EXPLAINED = 1.3
# A new cam that is worse than the old one with more than this chance is not cut without being told to.
WORSE = 0.05
# A gain smaller than this is none: two cams that end as near as a car can be set again, mm.
SAME = 1.0

Name = tuple[str, str]  # code of the kind of data that an effect is claimed in, and its name there


@dataclass(frozen=True)
class Outlook:
    """Expected errors at the end of the run on the old cam and on a new one.

    Attributes:
        old, new: distance from the planned end of the run, median of the draws, mm.
        least, most: between which the new one lies with a chance of 90 %, mm.
        worse: chance that the new one is farther off than the old one.
        explained: whether the effects found explain the measured runs; None where no track was measured.
        contradicted: whether another record contradicts the track, which was judged alone then.
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


def outlook(
    diagnoses: tuple[EvidenceDiagnosis, ...], nominal: Nominal, taken: Mapping[Name, Array], gone: frozenset[Name]
) -> Outlook:
    """Predict the end of the run on the old cam and on a new one.

    Args:
        diagnoses: what the records of the car show, by one verdict.
        nominal: the design that they were measured against.
        taken: what the new cam is made for, with the values, internal units.
        gone: what goes with the old disc.
    """
    model = run_of(nominal)
    track = next((d for d in diagnoses if d.kind is KIND), None)
    beside, spread = (0j, 0.0) if track is None else track.beside
    # All records have one judgement, but where they contradict each other: then the track knows best how the car runs.
    likeliest = (track or diagnoses[0]).likely
    rng = np.random.default_rng(0)
    counts = rng.multinomial(DRAWS, [likely.weight for likely in likeliest])
    draws = [
        _drawn(model, likely, count, taken, gone, rng, measured=track is not None)
        for likely, count in zip(likeliest, counts.tolist(), strict=True)
        if count
    ]
    old, new = (np.concatenate([pair[k] for pair in draws]) for k in (0, 1))
    rest = beside + spread * (rng.standard_normal(DRAWS) + 1j * rng.standard_normal(DRAWS))
    old, new = np.abs(old + rest), np.abs(new + rest + new_form(model, DRAWS, rng))
    least, most = np.percentile(new, RANGE)
    return Outlook(
        old=float(np.median(old)),
        new=float(np.median(new)),
        least=float(least),
        most=float(most),
        worse=float(np.mean(new > old + SAME)),
        explained=(False if diagnoses[0].contradicted else None) if track is None else _explained(track),
        contradicted=diagnoses[0].contradicted,
    )


def new_form(model: TrackModel, count: int, rng: np.random.Generator) -> NDArray[np.complex128]:
    """By how much the form errors of discs to be cut, as stated, move the end, x + iy, shape (count,), mm.

    Args:
        model: of a track on such a disc.
        count: how many discs.
        rng: source of random numbers.
    """
    x, y = model.form[[len(model.form) // 2 - 1, -1]]  # the last point of the run: its rows are first all x, then all y
    sizes = np.sqrt(TYPICAL.variance(model.order, model.floor)) * rng.standard_normal((count, len(model.order)))
    return np.asarray(sizes @ (x + 1j * y))


def _explained(track: EvidenceDiagnosis) -> bool:
    """Do the effects with what repeats beside them leave no more than noise on the runs left out?"""
    r = track.residual
    left = r.after if r.left_out is None else r.left_out.repeating
    return track.verdict not in (Verdict.UNEXPLAINED, Verdict.RUNS_DISAGREE) and left <= EXPLAINED * r.noise


def _drawn(
    model: TrackModel,
    likely: Likely,
    count: int,
    taken: Mapping[Name, Array],
    gone: frozenset[Name],
    rng: np.random.Generator,
    *,
    measured: bool,
) -> tuple[Array, Array]:
    """Errors of the end, x + iy, on the old cam and on the new one, drawn from one subset, shape (count,) each, mm.

    Where a track was measured, what does not act in it is not of the car's run: the play of a dial's stand is another
    play than the train's.
    """
    acts = [KIND.code in kinds or not measured for kinds in likely.shown]
    here = [
        (name, _in_track(model, effect, name[0]) if runs else None, values)
        for (name, effect, values), runs in zip(likely.effects, acts, strict=True)
    ]
    acting: Active = [(effect, values) for _, effect, values in here if effect]
    stays: Active = [(effect, values) for name, effect, values in here if effect and name not in gone]
    kept = np.array([e is not None and n not in gone for n, e, v in here for _ in v], dtype=bool)
    answers = np.concatenate([ways(model, effect, acting, len(values)) for _, effect, values in here] or [np.empty(0)])
    cut_for = [(effect, taken[name]) for name, effect, _ in here if effect and name in taken]
    # What only data that were judged apart show, such as the play of zones.
    for name, values in taken.items():
        if all(name != other for other, _, _ in here):
            effect = kind_of(name[0]).catalogue.named(name[1])
            if effect and (effect := _in_track(model, effect, name[0])):
                cut_for.append((effect, values))
    drawn = np.zeros((count, len(answers)))
    if len(answers):
        drawn = rng.multivariate_normal(np.zeros(len(answers)), likely.covariance, count)
    old = model.finish(acting) - model.finish([]) + drawn @ answers
    new = model.finish(stays) - model.finish(cut_for) + drawn @ (answers * kept)
    return old, new


def ways(model: TrackModel, effect: Effect | None, active: Active, width: int) -> Array:
    """How the end answers each number of an effect, shape (numbers,), complex."""
    if effect is None:
        return np.zeros(width, dtype=complex)
    values = next(np.asarray(v, dtype=float) for e, v in active if e is effect)
    others = [(e, v) for e, v in active if e is not effect]
    out = np.zeros(width, dtype=complex)
    for k, step in enumerate(effect.steps):
        low, high = moved(effect, values, k, -step), moved(effect, values, k, step)
        before, after = (model.finish([*others, (effect, there)]) for there in (low, high))
        out[k] = (after - before) / (high[k] - low[k])
    return out


def _in_track(model: TrackModel, effect: Effect, kind: str) -> Effect | None:
    """Effect in the track that corresponds to one of any kind of data; None where it does not move the car."""
    if kind == KIND.code:
        return effect
    if effect.deviation is not None:
        same = next((e for e in KIND.catalogue.effects if e.deviation == effect.deviation), None)
        if same is not None:
            return same
    return effect if effect.stage in model.behind and not (effect.instrument or effect.shape) else None
