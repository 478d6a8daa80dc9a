"""Evidence of records on all effects at once, to first order: information matrices about the likeliest car.

Every number of every effect is a direction, measured in standard deviations of what cars differ by. A record's rows are
X p + D d + F b + e, as in `evidence`; its information on p is X'C^-1 X, with the datum d, what repeats without a name
and the noise in C. What repeats in a track is the floor's and the disc's: runs that are measured later meet it again,
so there its amplitudes are directions too.

`Knowledge` is what may be true of the car so far: normal distributions in these directions. A likely subset has its
own effects with the values fitted, and beside them a little of everything that cars differ by, narrowed by the records;
play and friction where they may be there; and a floor that is level or not.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Deviation, Place
from cadgen.deviations.effect import Active, Effect, Quantity
from cadgen.inference.measurement.diagnosis import SOUND
from cadgen.inference.measurement.evidence import Evidence, Noise, Spectrum, estimate_noise, grid_of
from cadgen.inference.measurement.findings import EvidenceDiagnosis
from cadgen.inference.measurement.joint import Merged
from cadgen.inference.measurement.kinds import TRACK, TRANSMISSION
from cadgen.inference.measurement.kinds.track import TrackModel
from cadgen.inference.measurement.model import Model, moved, repeating, slopes
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Kind, Record
from cadgen.inference.measurement.reservations import resolved
from cadgen.inference.measurement.verdict import Verdict

_FLAT = 1e-6  # precision that stands for no knowledge of a datum, relative to what the rows say of it


@dataclass(frozen=True)
class Linear:
    """Effects of all kinds of data, and the directions that they span.

    Attributes:
        nominal: the design.
        kinds: of data, those measured first.
        measured: how many of them are.
        models: one of each kind, the measured ones with their records.
        noises: of the measured ones.
        merged: their catalogues.
        spread: of numbers by their keys, in internal units, where the design states it.
        likely: what may be true, the subset reported first: weight, and the effects with their values; nothing before
            any measurement.
        traced: whether all that the records show has names.
    """

    nominal: Nominal
    kinds: tuple[Kind, ...]
    measured: int
    models: tuple[Model, ...]
    noises: tuple[Noise, ...]
    merged: Merged
    spread: Mapping[Quantity, float]
    likely: tuple[tuple[float, Active], ...]
    traced: bool

    @classmethod
    def of(
        cls,
        nominal: Nominal,
        records: Sequence[Record],
        diagnoses: Sequence[EvidenceDiagnosis],
        others: Mapping[Kind, Record],
        spread: Mapping[Quantity, float],
    ) -> "Linear":
        """Put together what was measured and what may be.

        Args:
            nominal: the design.
            records: measured, one of each kind.
            diagnoses: what they show by one verdict, in the same order.
            others: a record of each kind that was not measured.
            spread: see `Linear.spread`.
        """
        kinds = (*(record.kind for record in records), *others)
        models = tuple(nominal.model(record) for record in (*records, *others.values()))
        noises = tuple(
            resolved(record, estimate_noise(model, model.residual(d.active)))
            for record, model, d in zip(records, models, diagnoses, strict=False)
        )
        merged = Merged.of(list(zip(kinds, models, strict=True)))
        known = {
            (kind.code, names[e.key].name, e.variant): e
            for kind, names in zip(kinds, merged.names, strict=True)
            for e in (*merged.catalogue, *merged.shapes, *merged.cameras)
            if e.key in names
        }
        likely = [
            (one.weight, [(known[*name, e.variant], v) for name, e, v in one.effects])
            for d in diagnoses[:1]
            for one in d.likely
        ]
        named = all(
            d.verdict in (*SOUND, Verdict.AMBIGUOUS) and not any(e.shape for e, _ in d.active) for d in diagnoses
        )
        return cls(nominal, kinds, len(records), models, noises, merged, spread, tuple(likely or [(1.0, [])]), named)

    @cached_property
    def effects(self) -> tuple[Effect, ...]:
        """Effects that are weighed: all that combine freely, and what is likely beside them."""
        wanted = {e.key for _, active in self.likely for e, _ in active}
        every = (*self.merged.catalogue, *self.merged.shapes, *self.merged.cameras)
        return tuple(e for e in every if e.key in wanted or not (e.member or e.shape or e in self.merged.cameras))

    @property
    def best(self) -> Active:
        """The effects reported, with their values."""
        return self.likely[0][1]

    def own(self, kind: Kind, active: Active) -> Active:
        """Effects as those of a kind of data, without what does nothing there."""
        names = self.merged.names[self.kinds.index(kind)]
        return [(names[e.key], v) for e, v in active if e.key in names]

    @cached_property
    def spans(self) -> tuple[slice, ...]:
        """Directions of each effect."""
        ends = np.cumsum([0, *(len(e.parameters) for e in self.effects)]).tolist()
        return tuple(slice(a, b) for a, b in pairwise(ends))

    @cached_property
    def scale(self) -> Array:
        """Standard deviation of each direction, internal units, shape (p,)."""
        numbers = [each for e in self.effects for each in zip(e.quantities, e.parameters, strict=True)]
        return np.array([self.spread.get(key, 0.0) or number.spread for key, number in numbers])

    @property
    def size(self) -> int:
        """How many directions there are, those of what repeats in a track among them."""
        return len(self.scale) + len(self.repeats)

    @cached_property
    def track(self) -> TrackModel:
        """The model of the track."""
        model = self.models[self.kinds.index(TRACK)]
        assert isinstance(model, TrackModel)
        return model

    def at_home(self, effect: Effect, kinds: Sequence[Kind]) -> tuple[tuple[int, Place], ...]:
        """Nearness of the kinds in whose catalogue an effect stands, and what becomes of it by each."""
        table = zip(self.kinds, self.models, self.merged.names, strict=True)
        return tuple(
            (kind.nearness, names[effect.key].places[0])
            for kind, model, names in table
            if kind in kinds and effect.key in names and names[effect.key] in model.catalogue
        )

    def place(self, effect: Effect, kinds: Sequence[Kind]) -> Place:
        """Default place of an effect, once these kinds of data were measured."""
        homes = self.at_home(effect, kinds)
        return min(homes)[1] if homes else Place.NOTED

    def ways(self, active: Active) -> NDArray[np.complex128]:
        """How the end of the run answers one standard deviation in each direction, shape (size,), mm."""
        own = self.own(TRACK, active)
        names = self.merged.names[self.kinds.index(TRACK)]
        out = []
        for effect in self.effects:
            here = names.get(effect.key)
            at = own if here is None or any(e is here for e, _ in own) else [*own, (here, here.start)]
            out.append(_end_by_number(self.track, here, at, len(effect.parameters)))
        mine = np.flatnonzero(self.track.rows.run == 0)
        last = repeating(self.track)[mine[[len(mine) // 2 - 1, -1]]]
        # The floor stays; the old disc goes, and its form error with it.
        last[:, : self.track.form.shape[1]] = 0.0
        return np.concatenate([np.concatenate(out) * self.scale, (last[0] + 1j * last[1]) / np.sqrt(self.repeats)])

    @cached_property
    def grid(self) -> tuple[Spectrum, ...]:
        """Spectra of what repeats that keep the stated floor."""
        return tuple(s for s in grid_of([self.track]) if s.within)

    @cached_property
    def chances(self) -> tuple[Array, Array]:
        """Chance of each spectrum by the records so far: of what repeats on the disc, and in the train."""
        misfit = np.zeros((2, len(self.grid)))
        for kind, model, noise in zip(self.kinds, self.models, self.noises, strict=False):
            evidence = Evidence(model, noise, self.grid)
            left = evidence.whiten(model.residual(self.own(kind, self.best)))
            misfit[int(kind is TRANSMISSION)] += evidence.misfit(left)
        disc, train = np.exp((misfit.min(axis=1)[:, None] - misfit) / 2)
        return disc / disc.sum(), train / train.sum()

    def spectrum(self, kind: Kind) -> Spectrum:
        """The likeliest spectrum of what repeats in a kind of data."""
        disc, train = self.chances
        return self.grid[int(np.argmax(train if kind is TRANSMISSION else disc))]

    @cached_property
    def repeats(self) -> Array:
        """Precision of each amplitude of what repeats in a track, by its mean variance over the spectra."""
        disc, _ = self.chances
        return np.asarray(1 / (disc @ self._variances))

    @cached_property
    def floors(self) -> tuple[tuple[float, Array], ...]:
        """Chance of each size of what repeats beside the disc, and the precision of each amplitude then.

        The precisions are relative to those of `repeats`, shape (repeats,).
        """
        disc, _ = self.chances
        sizes = np.array([s.beside for s in self.grid])
        out = []
        for size in np.unique(sizes):
            chance = np.where(sizes == size, disc, 0.0)
            if chance.sum() > 0:
                out.append((float(chance.sum()), np.asarray(chance.sum() / (chance @ self._variances) / self.repeats)))
        return tuple(out)

    @cached_property
    def _variances(self) -> Array:
        """Variance of each amplitude of what repeats in a track, by each spectrum, shape (spectra, repeats)."""
        track = self.track
        form = np.array([s.variance(track.order, track.floor) for s in self.grid])
        beside = np.array([track.discrepancy.variance(s.beside) for s in self.grid])
        return np.hstack([form, beside])

    def _columns(self, kind: Kind, model: Model, active: Active, idle: frozenset[Deviation]) -> Array:
        """How a record answers one standard deviation in each direction, shape (n, size)."""
        names, own = self.merged.names[self.kinds.index(kind)], self.own(kind, active)
        out = np.zeros((len(model.rows.run), self.size))
        for effect, span in zip(self.effects, self.spans, strict=True):
            if effect.key in names and effect.deviation not in idle:
                out[:, span] = -slopes(model, (names[effect.key],), own) * self.scale[span]
        if kind is TRACK:
            out[:, len(self.scale) :] = repeating(model) / np.sqrt(self.repeats)
        return out

    def rows(
        self,
        kind: Kind,
        model: Model,
        noise: Noise,
        active: Active,
        idle: frozenset[Deviation] = frozenset(),
    ) -> "WhitenedRows":
        """A record's rows, whitened.

        Args:
            kind, model, noise: of the record.
            active: effects about which it answers in proportion.
            idle: quantities that do not act in it.
        """
        evidence = Evidence(model, noise, (self.spectrum(kind),))
        # What repeats in a track is among the directions.
        first = repeating(model).shape[1] if kind is TRACK else 0
        turned = slopes(model, model.datum, [*self.own(kind, active), *((e, e.start) for e in model.datum)])
        return WhitenedRows(
            evidence.whiten,
            evidence.whiten(self._columns(kind, model, active, idle)),
            np.hstack([evidence.basis[:, first:], evidence.whiten(turned)]),
            np.append(evidence.prior[0][first:], np.zeros(turned.shape[1])),
            model.rows.place,
        )

    def measured_rows(self, active: Active) -> list["WhitenedRows"]:
        """The rows of every record so far, about some effects with their values."""
        table = zip(self.kinds, self.models, self.noises, strict=False)
        return [self.rows(kind, model, noise, active) for kind, model, noise in table]

    def pull(self, rows: Sequence["WhitenedRows"], active: Active) -> Array:
        """Information times directions of what the records leave beside some effects, shape (size,).

        Args:
            rows: of the records so far.
            active: the effects with their values.
        """
        out = np.zeros(self.size)
        for kind, model, one in zip(self.kinds, self.models, rows, strict=False):
            out += one.pull(model.residual(self.own(kind, active)))
        return out

    def noise_of(self, kind: Kind, model: Model) -> Noise:
        """Noise of a record to be made, by the records so far or by the usual instrument."""
        rows = len(model.rows.run)
        if kind in self.kinds[: self.measured]:
            known = self.noises[self.kinds.index(kind)]
            return Noise(np.full(rows, known.rms), 0.0, 0.0, known.runs)
        return Noise(np.full(rows, kind.noise), 0.0, 0.0, model.rows.runs)


@dataclass(frozen=True)
class WhitenedRows:
    """A record's rows, whitened.

    Attributes:
        whiten: of what is measured in each row, shape (n,).
        columns: responses to all directions, shape (n, size).
        nuisance: columns that are no directions: datum, and what repeats in this record alone, shape (n, k).
        precision: of their amplitudes, shape (k,).
        place: cam angle of each, shape (n,), rad.
    """

    whiten: Callable[[Array], Array]
    columns: Array
    nuisance: Array
    precision: Array
    place: Array

    def within(self, begin: float, width: float) -> NDArray[np.bool_]:
        """Which lie in a part of the turn.

        Args:
            begin: cam angle at which the part begins, rad.
            width: width of the part, rad.
        """
        return np.asarray((self.place - begin) % TURN < width)

    def information(self, rows: NDArray[np.bool_] | slice = slice(None)) -> Array:
        """On all directions, by some of the rows, shape (size, size)."""
        return self._less(self.columns[rows], self.columns[rows], self.nuisance[rows])

    def pull(self, left: Array) -> Array:
        """Information times directions of what the rows leave, shape (size,).

        Args:
            left: by each row, in the record's unit, shape (n,).
        """
        return self._less(self.columns, self.whiten(left)[:, None], self.nuisance)[:, 0]

    def _less(self, one: Array, two: Array, nuisance: Array) -> Array:
        """Products of columns, once the nuisance is taken out."""
        inner = nuisance.T @ nuisance
        inner[np.diag_indices(len(inner))] += np.maximum(self.precision, _FLAT * np.diag(inner) + 1e-300)
        return np.asarray(one.T @ two - (nuisance.T @ one).T @ np.linalg.solve(inner, nuisance.T @ two))


# Play or friction that makes the records so far less likely by this factor is not there.
ABSENT = 0.2
# The prior spread of what is fitted in a subset: so many times what cars differ by.
WIDE = 100.0
LEAST_WEIGHT = 0.01
# What is left without a name is larger than usual: by so much.
UNTRACED = 5.0


@dataclass(frozen=True)
class PriorKnowledge:
    """Knowledge without a measurement.

    Attributes:
        spread: standard deviations of numbers by their keys, internal units, where the design states them.
        play, friction: means where there are such effects; play is 0 for a car without.
        assumed: play that a new cam is made for while nothing is known of it, rad.
    """

    spread: Mapping[Quantity, float]
    play: float
    friction: float
    assumed: float


@dataclass(frozen=True)
class Subset:
    """A likely subset: a normal distribution in some of the directions, the others being nothing.

    Attributes:
        weight: chance of it.
        key: of its effects.
        at: its directions, shape (k,).
        mean, precision: shapes (k,) and (k, k).
        drawn: precision times mean, shape (k,), while what repeats has its mean size.
        cause: what may have made something without a name; None where all has names.
    """

    weight: float
    key: frozenset[str]
    at: NDArray[np.intp]
    mean: Array
    precision: Array
    drawn: Array
    cause: Effect | None = None


class Knowledge:
    """Knowledge of a car so far.

    Attributes:
        about: effects with the values about which everything is taken in proportion.
        subsets: what may be true, each on either kind of floor.
    """

    def __init__(self, linear: Linear, prior: PriorKnowledge) -> None:
        """Put together what records and tolerances say.

        Args:
            linear: the records, and the directions.
            prior: knowledge without a measurement; play in rad.
        """
        self._linear, size = linear, linear.size
        self._effects = list(zip(linear.effects, linear.spans, strict=True))
        best = [(e, v) for e, v in linear.best if not e.shape]
        self._rows = linear.measured_rows(best)
        self._known = sum((rows.information() for rows in self._rows), np.zeros((size, size)))
        means: Mapping[Deviation | None, float]
        means = {deviation.RETURN_ERROR: prior.play, deviation.SLIDING_FRICTION: prior.friction}
        unseen = self._unseen(best, means)
        hidden = [(e, np.array([means[e.deviation]])) for e in unseen if e.deviation in means]
        if linear.traced:
            subsets = [self._subset(weight, active, unseen, hidden) for weight, active in linear.likely]
        else:
            subsets = self._causes(best, unseen, hidden)
        self.about: Active = [*best, *hidden]
        self.subsets = [s for one in subsets if one.weight >= LEAST_WEIGHT for s in self._on_floors(one)]

    def _unseen(self, best: Active, means: Mapping[Deviation | None, float]) -> list[Effect]:
        """Effects beside the best subset that a car may have all the same.

        Every car has a little of all that lies about 0. Play and friction are there or not. Take a number x of them,
        in standard deviations of what cars differ by, about m, of which the rows leave p x - i x^2 / 2. Where no likely
        subset has it, its presence changes the evidence by exp(((p + m)^2 / (1 + i) - m^2) / 2) / sqrt(1 + i).

        Args:
            best: effects of the best subset.
            means: about which a quantity lies beforehand where it is there, rad or 1.
        """
        linear, inside = self._linear, {e.key for e, _ in best}
        known, pull = self._known, linear.pull(self._rows, best)
        likely = {e.key for weight, active in linear.likely if weight >= LEAST_WEIGHT for e, _ in active}
        first = len(linear.scale)
        held = [np.arange(first, linear.size)]
        held += [np.arange(s.start, s.stop) for e, s in self._effects if e.key in inside]
        at = np.concatenate(held)
        inner = np.linalg.inv(known[np.ix_(at, at)] + np.diag(np.where(at < first, WIDE**-2, 1.0)))
        out: list[Effect] = []
        for effect, span in self._effects:
            if effect.key in inside or effect.member or effect.shape:
                continue
            if effect.beside and effect.beside.key not in inside | {e.key for e in out}:
                continue
            mean = means.get(effect.deviation, 0.0) / linear.scale[span]
            if mean.any():
                side = known[span, :][:, at] @ inner
                information = np.diag(known[span, span] - side @ known[at, span])
                gained = (pull[span] - side @ pull[at] + mean) ** 2 / (1 + information) - mean**2
                if effect.key in likely or np.all(gained - np.log1p(information) < 2 * np.log(ABSENT)):
                    continue
            out.append(effect)
        return out

    def _causes(self, best: Active, unseen: Sequence[Effect], hidden: Active) -> list[Subset]:
        """The best subset with each effect that may have made what has no name, by how well it explains that."""
        linear, found, score = self._linear, [], []
        pull = self._linear.pull(self._rows, best)
        without = self._subset(1.0, best, unseen, hidden)
        measured = linear.kinds[: linear.measured]
        for effect, _ in self._effects:
            acts = any(effect.key in names for names in linear.merged.names[: linear.measured])
            if effect.shape or effect.beside or not acts or linear.at_home(effect, measured):
                continue
            subset = self._subset(1.0, best, unseen, hidden, effect)
            gained = [pull[one.at] @ np.linalg.solve(one.precision, pull[one.at]) for one in (subset, without)]
            narrowed = [np.linalg.slogdet(one.precision)[1] for one in (subset, without)]
            widened = len(effect.parameters) * np.log(UNTRACED)
            score.append((gained[0] - gained[1] - narrowed[0] + narrowed[1]) / 2 - widened)
            found.append(subset)
        if not found:
            return [without]
        weight = np.exp(np.array(score) - max(score))
        return [replace(s, weight=float(w)) for s, w in zip(found, weight / weight.sum(), strict=True)]

    def _subset(
        self, weight: float, active: Active, unseen: Sequence[Effect], hidden: Active, cause: Effect | None = None
    ) -> Subset:
        """A subset with effects that were not seen, some of them with a value beforehand, and what made the rest."""
        linear, first = self._linear, len(self._linear.scale)
        values = {e.key: v for e, v in active}
        physical = {e.deviation for e, _ in active if e.deviation}
        means = {e.key: v for e, v in hidden if e.deviation not in physical} | values
        here = [(e, s) for e, s in self._effects if e.key in values or e in unseen or e == cause]
        at = np.concatenate([*(np.arange(s.start, s.stop) for _, s in here), np.arange(first, linear.size)])
        at = at.astype(np.intp)
        wide = [np.full(s.stop - s.start, WIDE if e.key in values else UNTRACED if e == cause else 1) for e, s in here]
        prior = np.concatenate([*wide, np.ones(linear.size - first)]).astype(float) ** -2.0
        fitted, before = np.zeros(linear.size), np.zeros(linear.size)
        for effect, span in here:
            fitted[span] = values.get(effect.key, 0.0) / linear.scale[span]
            before[span] = means.get(effect.key, 0.0) / linear.scale[span]
        precision = self._known[np.ix_(at, at)] + np.diag(prior)
        # What was fitted without the unseen, drawn towards what these are beforehand and by what the records leave.
        drawn = precision @ fitted[at] + linear.pull(self._rows, active)[at] + prior * (before - fitted)[at]
        key = frozenset(values) | ({cause.key} if cause else set())
        return Subset(weight, key, at, np.linalg.solve(precision, drawn), precision, drawn, cause)

    def _on_floors(self, subset: Subset) -> list[Subset]:
        """A subset on a level floor and on one as uneven as may be, by their chances."""
        first, out = len(self._linear.scale), []
        for chance, relative in self._linear.floors:
            more = np.zeros(len(subset.at))
            more[subset.at >= first] = relative - 1.0
            precision = subset.precision + np.diag(more)
            mean = np.asarray(np.linalg.solve(precision, subset.drawn))
            out.append(replace(subset, weight=subset.weight * chance, precision=precision, mean=mean))
        return out


def _end_by_number(model: TrackModel, effect: Effect | None, active: Active, width: int) -> Array:
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
