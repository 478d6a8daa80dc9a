"""Compare every small subset of the catalogue by its linearised misfit, and hand the best to the exact fit.

Subsets of up to three freely combining causes are all tried, each with and without what acts beside it. Members of
families (orders of waviness, places of bumps and steps) are tried beside the best of these, one at a time; one that
wins joins the free ones in the next round.
After each round the catalogue is linearised anew about the best exact fit, until that no longer changes; then about the
best one without an anonymous shape, if that has one. At last the subsets within the best one are fitted.
"""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect, Quantity, activated, causes
from cadgen.errors import DesignError
from cadgen.inference.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.inference.measurement.joint import Joint
from cadgen.messages import Message


@dataclass(frozen=True)
class Columns:
    """Linearised responses of candidate effects: `spans[i]` are the columns of `effects[i]`."""

    effects: tuple[Effect, ...]
    spans: tuple[slice, ...]
    values: Array


def tangents(joint: Joint, effects: tuple[Effect, ...], best: Hypothesis) -> Columns:
    """Responses of effects about the best subset, in their order, without effects that do nothing there."""
    values = joint.slopes(effects, best.active)
    ends = np.cumsum([0, *(len(e.parameters) for e in effects)])
    # A second parameter that does nothing yet (a width at no depth) has no column of its own.
    alive = np.linalg.norm(values, axis=0) > 0
    kept = np.concatenate([[0], np.cumsum(alive)])
    spans = tuple(slice(int(kept[a]), int(kept[b])) for a, b in pairwise(ends))
    useful = [i for i, s in enumerate(spans) if s.stop > s.start]
    return Columns(tuple(effects[i] for i in useful), tuple(spans[i] for i in useful), values[:, alive])


def of_shapes(joint: Joint) -> Columns:
    """Shapes act on the reading alone and in proportion to their size, so their columns are read off."""
    columns: list[Array] = []
    spans = []
    for shape in joint.shapes:
        first = len(columns)
        for k, step in enumerate(shape.steps):
            values = shape.start.copy()
            values[k] += step
            column = joint.shape_column(shape, values) / step
            if np.any(column):
                columns.append(column)
        spans.append(slice(first, len(columns)))
    return Columns(joint.shapes, tuple(spans), np.stack(columns, axis=1) if columns else np.empty((joint.rows, 0)))


def side_by_side(one: Columns, two: Columns) -> Columns:
    """The columns of both, side by side."""
    shift = one.values.shape[1]
    moved = tuple(slice(s.start + shift, s.stop + shift) for s in two.spans)
    return Columns(one.effects + two.effects, one.spans + moved, np.hstack([one.values, two.values]))


Index = NDArray[np.intp]
# Share of a column's square that is left of it, less than which is rounding.
_HIDDEN = 1e-12


@dataclass(frozen=True)
class Alike:
    """Members of families, k of them, that have the same number of columns.

    Attributes:
        effects: numbers of the effects, shape (k,).
        columns: columns of each, shape (k, width).
        products: products of these columns for every spectrum, shape (g, k, width, width).
        size: sizes of the columns, shape (g, k, width); infinite where nothing is left of one.
    """

    effects: Index
    columns: Index
    products: Array
    size: Array


class Families:
    """Members of all families, which enter one at a time: whitened once, with products of their own columns."""

    def __init__(self, joint: Joint, columns: Columns) -> None:
        self.effects, self.spans = columns.effects, columns.spans
        self.white = joint.whiten(columns.values)
        self.halves = joint.halves(self.white)
        sorts = [(s.stop - s.start, bool(e.parts)) for e, s in zip(self.effects, self.spans, strict=True)]
        self.groups = [
            self._alike(sort[0], np.array([i for i, s in enumerate(sorts) if s == sort], dtype=np.intp))
            for sort in sorted(set(sorts))
            if sort[0]  # over a short part of a turn a family has no member that shows
        ]

    def _alike(self, width: int, which: Index) -> Alike:
        """Effects by their numbers, each of which has so many columns."""
        columns = np.array([self.spans[i].start for i in which], dtype=np.intp)[:, None] + np.arange(width)
        own, taken = (_own_products(each[..., columns]) for each in (self.white, self.halves))
        whole = np.einsum("kii->ki", own)
        left = np.maximum(whole - np.einsum("gkii->gki", taken), 0.0)
        # What the discrepancy hides but for rounding is of no size that anything could be measured against.
        size = np.where(left > _HIDDEN * whole, np.sqrt(left), np.inf)
        return Alike(which, columns, own - taken, size)


def _own_products(columns: Array) -> Array:
    """Products of each member's columns with each other, from shape (..., q, k, width) to (..., k, width, width)."""
    width = columns.shape[-1]
    pairs = [
        [np.einsum("...qk,...qk->...k", columns[..., i], columns[..., j]) for j in range(width)] for i in range(width)
    ]
    return np.stack([np.stack(row, axis=-1) for row in pairs], axis=-2)


Start = tuple[tuple[Effect, ...], Active]  # a subset, and values to begin from

# Causes of which all subsets are tried, and that a subset may have which grows from the best one while that leaves more
# than noise and form error.
LARGEST_SUBSET, MOST_CAUSES = 3, 6
# Subsets that get an exact fit in each round, and that members of families are tried beside.
REFINED = 5
NAMED = 2
BASES = 20
ROUNDS = 5
# A subset that is not fitted yet is so if its linearised score is within this much of the best one's.
NEAR = 10.0
# What is left is more than chance if its chi-square is so many standard deviations above its mean.
CHANCE = 3.0
# An effect of the instrument and one of the part are told apart by data in which they differ by this share: more than a
# part differs that is clamped anew by eye (one degree), less than one that is turned on purpose.
APART = 0.05
# Values that are better than those fitted by this much, in -2 log L, lie in another valley.
BETTER = 1.0
# A subset that stays behind the best one by so much of the criterion is not fitted to the end.
HOPELESS = 100.0
# Two columns whose cosine exceeds this cannot be told apart by this data: their subset is not tried.
COLLINEAR = 0.99999


@dataclass(frozen=True, eq=False)
class Rated:
    """A subset with its linearised score and estimate, internal units; columns of the free ones first."""

    score: float
    effects: tuple[Effect, ...]
    estimate: Array
    columns: Index


@dataclass(frozen=True)
class Round:
    """Products of the free columns, the datum and the residual for every spectrum that keeps the floor.

    Attributes:
        free: the freely combining effects.
        products: shape (g, f, f); after the effects' columns come the datum's, and last the residual.
        cross: products of these with the members' columns, shape (g, f, m).
        constant: log det C, shape (g,).
        always: columns of the datum, in every subset.
    """

    free: Columns
    products: Array
    cross: Array
    constant: Array
    always: Index


def find(
    joint: Joint,
    usual: Mapping[Quantity, tuple[float, float]] | None = None,
    starts: Sequence[Start] = (),
    without: str | None = None,
    known: Sequence[Hypothesis] = (),
    against: float = np.inf,
) -> list[Hypothesis]:
    """Fit the most likely subsets exactly; best first by score, the empty one always among them.

    Args:
        joint: the records.
        usual: mean and standard deviation of numbers by their keys over a workshop's cars, internal units.
        starts: subsets to be fitted first, with values to begin from.
        without: name that no subset is to hold.
        known: subsets of these records that are fitted already, the best fit of each; those that hold that name count
            for nothing.
        against: dimensionless score to come near. The search ends where nothing promises to.
    """
    core, named = distinguishable(joint), joint.members
    search = _size(joint, core, usual or {})
    if without is not None:
        core, named = not_holding(core, without), not_holding(named, without)
        known = [h for h in known if not_holding(h.effects, without) == h.effects]
    none = next((h for h in known if not h.effects), None) or fit(joint, (), [], search)
    fitted = {none.key: none} | {h.key: h for h in known}
    _fit_new(joint, list(starts), fitted, search)
    best = about = min(fitted.values(), key=lambda h: h.score)
    # Members of families are small and many: their tangents at the bare design serve for all rounds.
    families = Families(joint, side_by_side(tangents(joint, named, none), of_shapes(joint)))
    for number in range(ROUNDS):
        promised, promising = _promising(joint, about, core, families, search, fitted)
        # What is promised about the first subset says little, since that may be far from all that is there.
        if number and promised > against + HOPELESS:
            break
        _fit_new(joint, promising, fitted, search)
        leader = min(fitted.values(), key=lambda h: h.score)
        if leader is not best:
            best = about = leader
            # What acts beside another linearises badly, and may look needed where it is not.
            fewer = [tuple(e for e in best.effects if e is not beside) for beside in best.effects if beside.beside]
            _fit_new(joint, [(effects, best.active) for effects in fewer], fitted, search)
        elif about is best and any(e.shape for e in best.effects):
            # An anonymous shape may stand for names, and these are found from what there is without it.
            about = min((h for h in fitted.values() if not any(e.shape for e in h.effects)), key=lambda h: h.score)
            if about.score > best.score + HOPELESS:
                break
        else:
            break
    _fit_new(joint, list(_within(joint, min(fitted.values(), key=lambda h: h.score))), fitted, search)
    return sorted(fitted.values(), key=lambda h: h.score)


def not_holding(effects: Iterable[Effect], name: str) -> tuple[Effect, ...]:
    """Effects that hold no effect of a name: neither it nor what becomes it, or acts beside it."""
    return tuple(e for e in effects if name not in {o.name for o in (e, e.includes, e.beside) if o is not None})


def best_of(joint: Joint, usual: Mapping[Quantity, tuple[float, float]] | None, starts: Sequence[Start]) -> Hypothesis:
    """The best by score of the empty subset and of some others, fitted from given values; arguments as of `find`."""
    search = _size(joint, distinguishable(joint), usual or {})
    none = fit(joint, (), [], search)
    fitted = {none.key: none}
    _fit_new(joint, list(starts), fitted, search)
    return min(fitted.values(), key=lambda h: h.score)


def _size(joint: Joint, core: tuple[Effect, ...], usual: Mapping[Quantity, tuple[float, float]]) -> Search:
    """Size of the search among freely combining effects, members of families and shapes."""
    entries = Counter(e.sort for e in (*core, *joint.members) if not (e.shape or e.parts or e.beside))
    anonymous = len(joint.shapes) + sum(e.shape for e in joint.members)
    # Of a camera it is known how well one is set up: its errors are as large as usual, or cost so much more.
    cameras = [e for e in core if e.stage.of_instrument]
    known = {key: (0.0, p.spread) for e in cameras for key, p in zip(e.quantities, e.parameters, strict=True)}
    return Search(joint.rows, entries, max(anonymous, 1), known | dict(usual))


def _within(joint: Joint, best: Hypothesis) -> Iterator[Start]:
    """Subsets within the best one that lose little: where an effect of it is too small to be named, one of these is.

    And those with what one of its effects becomes for some values in its place.
    """
    for whole in best.effects:
        if whole.includes:
            yield tuple(whole.includes if e is whole else e for e in best.effects), best.active
    for size in range(1, len(best.effects)):
        for effects in combinations(best.effects, size):
            kept = {e.key for e in effects}
            start = [(e, v) for e, v in best.active if e in joint.datum or e.key in kept]
            if not all(e.beside is None or e.beside in effects for e in effects):
                continue
            with suppress(DesignError):  # a part of what makes a disc may be a disc that no rod can follow
                if _misfit(joint, start) < best.misfit[best.within] + HOPELESS:
                    yield effects, start


def _fit_new(joint: Joint, subsets: list[Start], fitted: dict[frozenset[str], Hypothesis], search: Search) -> None:
    """Fit subsets exactly, and add them; one that is fitted already again if the values to begin from are better."""
    for effects, start in subsets:
        key = frozenset(e.key for e in effects)
        try:
            if key not in fitted or _misfit(joint, start) < fitted[key].misfit[fitted[key].within] - BETTER:
                level = min(h.score for h in fitted.values()) + HOPELESS
                anew = fit(joint, effects, start, search, level=level)
                fitted[key] = min(fitted.get(key, anew), anew, key=lambda h: h.score)
        except DesignError:
            # On its way the fit met a disc that no rod can follow: no such part was measured.
            continue


def _misfit(joint: Joint, active: Active) -> float:
    """-2 log L of values, by the best spectrum that keeps the floor."""
    return float(joint.misfit(active)[joint.within].min())


def distinguishable(joint: Joint) -> tuple[Effect, ...]:
    """The freely combining effects, less those of the instrument that are another's twins in these data.

    Two are told apart if their responses, less the datum, enclose an angle that `APART` is the sine of.
    """
    kept = {e.key: e for e in joint.core}
    datum = [(e, e.start) for e in joint.datum]
    free = np.linalg.qr(joint.whiten(np.hstack([joint.offsets, joint.slopes(joint.datum, datum)])))[0]

    def response(effect: Effect) -> Array:
        white = joint.whiten(joint.slopes((effect,), datum))
        return np.linalg.qr(white - free @ (free.T @ white))[0]

    for effect in joint.core:
        other = effect.looks_like and kept.get(effect.looks_like.key)
        if not other:
            continue
        mine, others = response(effect), response(other)
        if np.linalg.norm(mine - others @ (others.T @ mine), 2) >= APART:
            # What no record of its kind alone tells apart, one beside it does.
            kept[other.key] = replace(other, twins=tuple(twin for twin in other.twins if twin != effect.name))
            continue
        del kept[effect.key]
        if effect.name not in other.twins:
            by = Message(
                "{first}; {name}: {second}",
                first=Message(other.separated_by),
                name=Message(effect.name),
                second=Message(effect.separated_by),
            )
            kept[other.key] = replace(other, twins=tuple(dict.fromkeys((*other.twins, effect.name))), separated_by=by)
    return tuple(kept.values())


def _promising(
    joint: Joint,
    best: Hypothesis,
    core: tuple[Effect, ...],
    families: Families,
    search: Search,
    fitted: Collection[frozenset[str]],
) -> tuple[float, list[Start]]:
    """The subsets of least linearised score about the best one so far, with estimates to begin from; and that score."""
    # Members of families that have entered combine freely from now on.
    core = core + tuple(e for e in best.effects if e.member)
    free = tangents(joint, core, best)
    datum = joint.slopes(joint.datum, best.active)
    # What the residual would be without the active effects follows from their own tangents.
    known = [
        next((v for e, v in best.active if e is effect), np.zeros(len(effect.parameters)))[: s.stop - s.start]
        for effect, s in zip(free.effects, free.spans, strict=True)
    ]
    bare = joint.residual(best.active) + (free.values @ np.concatenate(known) if known else 0.0)
    white = joint.whiten(np.column_stack([free.values, datum, bare]))
    halves = joint.halves(white)
    width = free.values.shape[1]
    this = Round(
        free,
        white.T @ white - np.swapaxes(halves, 1, 2) @ halves,
        white.T @ families.white - np.swapaxes(halves, 1, 2) @ families.halves,
        joint.constant[joint.within],
        np.arange(width, width + datum.shape[1]),
    )
    # More than noise and form error is left, by chi-square, at the least discrepancy: one as large as it may be would
    # hide what an effect does better.
    spectrum = int(np.argmin(np.where(joint.within & (joint.beside == joint.beside.min()), best.misfit, np.inf)))
    leaves_more = joint.square(best.active, spectrum) > joint.rows + CHANCE * float(np.sqrt(2 * joint.rows))
    subsets = {*_subsets(free.effects), *_grown(free.effects, best)}
    rated = sorted(_rate_free(this, subsets, search), key=lambda r: r.score)
    most = MOST_CAUSES if leaves_more else LARGEST_SUBSET
    bases = [r for r in rated if causes(r.effects) < most][:BASES]
    # In the best subset a member of a family may stand in another's place.
    bases += [r for r in rated if r not in bases and _keyed(r) < best.key and len(best.key) - len(r.effects) == 1]
    rated += [r for base in bases for r in _rate_beside(this, base, families, search)]
    rated.sort(key=lambda r: r.score)
    # Anonymous shapes come in so many places and widths that they linearise well: names keep places of their own.
    datum_start = [(e, v) for e, v in best.active if e in joint.datum]
    chosen: list[Rated] = []
    level = min(best.score, rated[0].score) + NEAR
    for some in (rated, [r for r in rated if r.score < level and _keyed(r) not in fitted]):
        chosen += [r for r in some if r not in chosen][:REFINED]
        chosen += [r for r in some if r not in chosen and not any(e.shape for e in r.effects)][:NAMED]
    # What acts beside another is far from proportion, and linearises too badly to be seen until it is fitted; and a
    # shape without a name, or the disc, may stand for it.
    beside = [r for r in rated if any(e.beside for e in r.effects) and not any(e.shape for e in r.effects)]
    more = leaves_more or any(e.shape for e in best.effects)
    companions = [e for e in core if e.beside and (more or e.beside in best.effects) and e not in best.effects]
    if companions:
        chosen += [r for r in beside[:NAMED] if r not in chosen]
    starts = [_accompanied(effect, core, beside, best) for effect in companions]
    starts += [(r.effects, [*datum_start, *activated(r.effects, r.estimate)]) for r in chosen]
    return rated[0].score, starts


def _keyed(rated: Rated) -> frozenset[str]:
    return frozenset(e.key for e in rated.effects)


def _accompanied(companion: Effect, core: tuple[Effect, ...], beside: list[Rated], best: Hypothesis) -> Start:
    """The best subset less its anonymous shapes, with what acts beside another, and that other."""
    wanted = {e.key for e in (*best.effects, companion, companion.beside) if e and not e.shape}
    near = next((r for r in beside if companion in r.effects), None)
    values = activated(near.effects, near.estimate) if near else []
    datum = [(e, v) for e, v in best.active if e not in best.effects]
    known = {e.key: (e, v) for e, v in (*values, *best.active) if e.key in wanted}
    return tuple(e for e in core if e.key in wanted), [*datum, *known.values()]


def _rate_free(this: Round, subsets: Iterable[tuple[int, ...]], search: Search) -> Iterator[Rated]:
    """Subsets of the freely combining effects, and none of them, by their places."""
    free = this.free
    bundles: dict[int, list[tuple[int, ...]]] = {0: [()]}
    for subset in sorted(subsets):
        width = sum(free.spans[i].stop - free.spans[i].start for i in subset)
        bundles.setdefault(width, []).append(subset)
    for width, subsets in bundles.items():
        every = np.arange(free.values.shape[1], dtype=np.intp)
        columns = np.array([np.concatenate([every[:0], *(every[free.spans[i]] for i in subset)]) for subset in subsets])
        index = np.hstack([columns, np.broadcast_to(this.always, (len(subsets), len(this.always)))])
        gram = this.products[:, index[:, :, None], index[:, None, :]]
        score, estimate, sound = _solve(gram, this.products[:, index, -1], this.constant + this.products[:, -1, -1])
        for row, subset in enumerate(subsets):
            effects = tuple(free.effects[i] for i in subset)
            values = _completed(effects, estimate[row], [free.spans[i] for i in subset])
            if sound[row] and _possible(effects, values):
                yield Rated(float(score[row]) + search.penalty(effects, width), effects, values, columns[row])


def _subsets(effects: tuple[Effect, ...]) -> Iterator[tuple[int, ...]]:
    """Places of effects that may be at work together, but for none at all."""
    alone = [i for i, e in enumerate(effects) if not e.beside]
    for size in range(1, LARGEST_SUBSET + 1):
        for subset in combinations(alone, size):
            chosen = [effects[i] for i in subset]
            if not _compatible(chosen):
                continue
            companions = [i for i, e in enumerate(effects) if e.beside in chosen]
            for more in range(len(companions) + 1):
                yield from (tuple(sorted(subset + some)) for some in combinations(companions, more))


def _grown(effects: tuple[Effect, ...], best: Hypothesis) -> Iterator[tuple[int, ...]]:
    """Subsets beyond three about the best one: all within it, with two others more, and with one for up to two of it.

    Growth takes in what stands for several effects; once these are there, it is not needed, and what it had hidden is.
    """
    inside = tuple(i for i, e in enumerate(effects) if e.key in best.key)
    outside = [i for i in range(len(effects)) if i not in inside]
    for count in range(3):
        left_out = (range(len(inside) + 1), range(3), range(1))[count]
        for more in combinations(outside, count):
            for less in chain.from_iterable(combinations(inside, size) for size in left_out):
                subset = tuple(sorted({*inside, *more}.difference(less)))
                chosen = [effects[i] for i in subset]
                paired = all(e.beside is None or e.beside in chosen for e in chosen)
                more_than_tried = sum(not e.beside for e in chosen) > LARGEST_SUBSET
                if paired and _compatible(chosen) and more_than_tried and causes(chosen) <= MOST_CAUSES:
                    yield subset


def _rate_beside(this: Round, base: Rated, families: Families, search: Search) -> Iterator[Rated]:
    """A subset with each member of a family in turn, by the Schur complement; the best few of each group."""
    held = np.concatenate([base.columns, this.always])
    inner = this.products[:, held[:, None], held]
    right = np.concatenate([this.cross[:, held], this.products[:, held, -1:]], axis=2)
    solved = np.linalg.solve(inner, right) if len(held) else right
    # Products of the members' columns with the residual, and its square, once the base is taken out.
    left = np.swapaxes(right, 1, 2)
    target = this.cross[:, -1] - np.einsum("gkm,gk->gm", this.cross[:, held], solved[:, :, -1])
    square = this.products[:, -1, -1] - np.einsum("gk,gk->g", right[:, :, -1], solved[:, :, -1])
    held_keys = _keyed(base)  # about the best subset a member answers otherwise than at the bare design
    for alike in families.groups:
        columns, width = alike.columns, alike.columns.shape[1]
        a, b = columns[:, :, None], columns[:, None, :]
        taken = alike.products - np.sum(left[:, a] * np.moveaxis(solved, 1, 2)[:, b], axis=-1)
        score, estimate, sound = _solve(taken, target[:, columns], this.constant + square, alike.size)
        for row in np.argsort(np.where(sound, score, np.inf))[:3]:
            member = families.effects[alike.effects[row]]
            if member.key in held_keys:
                continue
            effects = (*base.effects, member)
            tail = effects[-1].start.copy()
            tail[:width] = estimate[row]
            values = np.concatenate([base.estimate, tail])
            if sound[row] and _compatible(list(effects)) and _possible(effects, values):
                effects = tuple(part for e in effects for part in (e.parts or (e,)))
                penalty = search.penalty(effects, sum(len(e.parameters) for e in effects))
                yield Rated(float(score[row]) + penalty, effects, values, base.columns)


def _solve(gram: Array, right: Array, base: Array, size: Array | None = None) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Least misfit over spectra, estimate there, and whether the columns differ enough; one row a subset.

    Columns are measured against `size`, which they had before others were taken out; left out, against their own.
    """
    if not gram.shape[-1]:
        return np.full(gram.shape[1], base.min()), np.empty((gram.shape[1], 0)), np.ones(gram.shape[1], dtype=bool)
    if size is None:
        size = np.sqrt(np.maximum(np.einsum("gsii->gsi", gram), 1e-300))
    cosine = gram / size[..., :, None] / size[..., None, :]
    scaled = (right / size)[..., None]
    estimate = np.linalg.solve(cosine + 1e-10 * np.eye(gram.shape[-1]), scaled)
    misfit = base[:, None] - np.sum(estimate * scaled, axis=(2, 3))
    least = np.argmin(misfit, axis=0)
    rows = np.arange(gram.shape[1])
    smallest = np.linalg.eigvalsh(cosine[least, rows])[:, 0]
    return misfit[least, rows], (estimate[..., 0] / size)[least, rows], smallest > 1 - COLLINEAR


def _compatible(effects: list[Effect]) -> bool:
    """At most one of each group."""
    groups = [e.group for e in effects if e.group is not None]
    return len(set(groups)) == len(groups)


def _completed(effects: tuple[Effect, ...], estimate: Array, spans: list[slice]) -> Array:
    """Estimates of the columns, with starts for the parameters that have none."""
    parts, at = [], 0
    for effect, span in zip(effects, spans, strict=True):
        values, width = effect.start.copy(), span.stop - span.start
        values[:width] = estimate[at : at + width]
        parts.append(values)
        at += width
    return np.concatenate(parts) if parts else np.empty(0)


def _possible(effects: tuple[Effect, ...], values: Array) -> bool:
    """A linear estimate may overshoot a bound by a difference step; more is physically impossible."""
    for effect, part in activated(effects, values):
        lower, upper = effect.bounds
        if np.any(part < lower - effect.steps) or np.any(part > upper + effect.steps):
            return False
    return True
