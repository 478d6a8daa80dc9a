"""The verdict: what the rivals and what remains allow to be claimed, in one sentence."""

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import chain, combinations
from math import log

import numpy as np
from scipy.stats import f as f_distribution
from scipy.stats import norm
from scipy.stats import t as student

from cadgen.arrays import Array
from cadgen.deviations.effect import UNITS, Effect
from cadgen.inference.measurement.evidence import registered
from cadgen.inference.measurement.hypothesis import Hypothesis
from cadgen.inference.measurement.joint import Joint, Part
from cadgen.inference.measurement.model import fourier, per_run, repeating
from cadgen.inference.measurement.search import CHANCE
from cadgen.messages import Message, joined

# Runs disagree if the chi-square of their smooth differences has this chance or less.
DISAGREE = 1e-6
SMOOTH_ORDERS = 6


def names_of(effects: Iterable[Effect]) -> Message:
    """Names of effects, as in "A and B"; empty without any."""
    return joined((Message(e.name) for e in effects), " and ")


def separations(effects: Iterable[Effect]) -> tuple[Message, ...]:
    """For each effect the measurement that tells it apart, as "A: how", each once."""
    how = {e.name: e.separated_by for e in effects if e.separated_by}
    return tuple(Message("{name}: {how}", name=Message(name), how=Message(text)) for name, text in how.items())


def _repeating(part: Part, joint: Joint, best: Hypothesis) -> tuple[Array, Array]:
    """Residual of a part, and the most likely coefficients of what repeats in it."""
    residual = part.residual(best.active)
    return residual, part.evidence.repeating(part.evidence.whiten(residual), joint.grid.index(best.spectrum))


def left_over(part: Part, joint: Joint, best: Hypothesis) -> float:
    """RMS of the whitened residual less its most likely form error and discrepancy: 1 if only noise is left."""
    residual, repeats = _repeating(part, joint, best)
    left = registered(part.model, part.noise, residual - repeating(part.model) @ repeats)
    return float(np.sqrt(np.mean((left / part.noise.sigma) ** 2)))


def largest(part: Part, joint: Joint, best: Hypothesis) -> tuple[float, float, float, Part]:
    """The greatest value of the form error over the noise; its place, its size and the part."""
    values = part.model.form @ _repeating(part, joint, best)[1][: part.model.form.shape[1]]
    values = values - values.mean()
    worst = int(np.argmax(np.abs(values)))
    size = float(values[worst])
    return abs(size) / part.noise.rms, float(part.model.rows.place[worst]), size, part


def runs_disagree(part: Part, best: Hypothesis) -> bool:
    """Do the runs differ smoothly, by more than the noise between neighbours allows?"""
    model, noise, rows = part.model, part.noise, part.model.rows
    if rows.runs < 2:
        return False
    residual = part.residual(best.active)
    smooth, _ = fourier(rows.place, SMOOTH_ORDERS)
    contrasts = [smooth * (rows.run == run)[:, None] for run in range(1, rows.runs)]
    # A divider set differently for each run is index error, and counted as noise.
    own = [per_run(rows.run) * model.slip[:, None]] if model.slip.size else []
    base = np.hstack([model.offsets, repeating(model), *own])
    both = np.hstack([base, *contrasts])
    squares, ranks, fits = [], [], []
    for columns in (base, both):
        fit, _, rank, _ = np.linalg.lstsq(columns / noise.sigma[:, None], residual / noise.sigma, rcond=1e-9)
        squares.append(float(np.sum(((residual - columns @ fit) / noise.sigma) ** 2)))
        ranks.append(int(rank))
        fits.append(columns @ fit)
    extra, left = ranks[1] - ranks[0], len(residual) - ranks[1]
    if extra < 1 or left < 1 or squares[1] == 0:
        return False  # so few rows do not tell
    if np.sqrt(np.mean((fits[1] - fits[0]) ** 2)) < LEAST_OF_FLOOR * model.floor:
        return False  # by less than the stated form error shows
    ratio = (squares[0] - squares[1]) / extra / (squares[1] / left)
    inflation = (1 + noise.correlation) / (1 - noise.correlation)
    return bool(f_distribution.sf(ratio / inflation, extra, left) < DISAGREE)


class Verdict(StrEnum):
    """Class of a verdict."""

    NONE = "none"
    TRACED = "traced"
    COMBINATION = "combination"
    AMBIGUOUS = "ambiguous"
    PARTIAL = "partial"
    UNTRACED_SHAPE = "untraced shape"
    UNEXPLAINED = "unexplained"
    RUNS_DISAGREE = "runs disagree"


# A name is claimed if the subsets that hold it have this probability together, of three names and more each more: see
# `sure_of`. That is of the least sure claim; of all claims far more are right (docs/measurement.md).
SURE = 0.85
# The same as a difference of the criterion between two subsets: 2 ln(odds).
MARGIN = 2 * log(SURE / (1 - SURE))
# Subsets within this much of the best one (odds of 12 to 1) are its rivals, and reported beside it.
RIVAL = 5.0
# A form error beyond the floor has two numbers more (size and knee) that nothing in the catalogue explains.
LOOSE = 16.0
# An effect beside an unknown shape must be this much more likely than the shape alone, and a name beside fitted shapes
# than all subsets without that name.
BESIDE_UNKNOWN = 40.0
# Effects that change the residual by less than this share of the stated form error are part of it.
LEAST_OF_FLOOR = 0.4
# Effects that change it, summed, by so many times that are not looked at together.
_SUMMED = 5.0
# Where an effect changes the readings by so many times what all do together, it is there to cancel others.
CANCELS = 4.0
# Where something has no name, a name of which the readings show less than so many times as much may be a part of it.
OVER_NAMELESS = 1.3
# RMS over the noise that thousands of rows of noise do not reach.
LEFT_OVER = 1.3
# Beside an unknown shape, effects are named only if they account for this share of the square of the residual.
MOST = 0.8


# Of a number whose standard deviation exceeds its size over this nothing is known, not even its sign.
SIGMAS = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Judgement:
    """The verdict and its reasons.

    Attributes:
        verdict: its class.
        sentence: in words.
        claimed: names that are as good as sure: see `SURE`.
        reported: these and the names in any likely subset.
        rivals: likely subsets other than the best, best first.
        separate: for each claimed or rival effect, the measurement that would decide.
        limits: what cannot be judged with this data.
        left: RMS of what remains without a name, over the noise; 1 where only noise remains.
    """

    verdict: Verdict
    sentence: str
    claimed: tuple[str, ...]
    reported: tuple[str, ...]
    rivals: tuple[tuple[str, ...], ...]
    separate: tuple[str, ...]
    limits: tuple[str, ...] = ()
    left: float = 1.0


def sigmas_of(freedom: float, choices: int = 1) -> float:
    """Standard deviations beyond which a number is as seldom chance as beyond `SIGMAS` of one that is known exactly.

    By Student's t where the standard deviation was estimated from few runs, and by Bonferroni's bound where the number
    is one of several that the same runs were searched for.

    Args:
        freedom: degrees of freedom from which the standard deviation was estimated; with none no number is sure.
        choices: how many numbers were looked at.
    """
    return float(student.isf(norm.sf(SIGMAS) / choices, freedom)) if freedom > 0 else float("inf")


def within_words(sigmas: float = SIGMAS) -> Message:
    """Reason why a number is not claimed.

    Args:
        sigmas: number of standard deviations.
    """
    return Message("within {sigmas:.3g} standard deviations of nothing", sigmas=sigmas)


def within_error(
    units: Sequence[str], values: Sequence[float] | Array, sigma: Sequence[float] | Array, sigmas: float = SIGMAS
) -> bool:
    """Is a number of an effect within `sigmas` standard deviations of nothing? Then the effect is not claimed.

    Numbers of one unit are components of one thing, as an eccentricity's x and y: one of them may be nothing, if its
    error is small beside the largest.

    Args:
        units, values, sigma: of the effect's numbers, standard deviations in the same units.
        sigmas: see `sigmas_of`.
    """
    for unit, error in zip(units, sigma, strict=True):
        size = max(abs(value) for other, value in zip(units, values, strict=True) if other == unit)
        if not sigmas * error < size:
            return True
    return False


def unclaimed(judgement: Judgement, names: Sequence[str], why: str) -> Judgement:
    """A judgement that does not claim these names; a verdict that rested on them is no more than ambiguous."""
    dropped = [name for name in dict.fromkeys(names) if name in judgement.claimed]
    if not dropped:
        return judgement
    names_dropped = [Message(name) for name in dropped]
    limit = Message("{why}, and so not claimed: {names}", why=why, names=joined(names_dropped, "; "))
    judgement = replace(
        judgement,
        claimed=tuple(name for name in judgement.claimed if name not in dropped),
        limits=(*judgement.limits, limit),
    )
    if judgement.verdict not in (Verdict.TRACED, Verdict.COMBINATION):
        return judgement
    sentence = Message(
        "Consistent with {reported}, but not sure of {names}: {why}.",
        reported=joined(map(Message, judgement.reported), " and "),
        names=joined(names_dropped, " and "),
        why=why,
    )
    return replace(judgement, verdict=Verdict.AMBIGUOUS, sentence=sentence)


def judge(joint: Joint, found: list[Hypothesis]) -> tuple[Judgement, Hypothesis]:
    """Weigh the fitted subsets against each other and against what they leave; and the subset that is reported."""
    found = [h for h in found if not _below_floor(joint, h)]
    tight = found[0]
    loose = min(found, key=lambda h: h.loose_score)
    if tight.score <= loose.loose_score + LOOSE:
        judgement, best = _within_floor(joint, found)
    else:
        judgement, best = _beyond_floor(joint, loose, found)
    left, where = max((left_over(part, joint, best), part.record.source) for part in joint.parts)
    if judgement.verdict in (Verdict.UNTRACED_SHAPE, Verdict.PARTIAL, Verdict.NONE) and left > LEFT_OVER:
        sentence = Message(
            "What remains is {left:.1f} times the noise and neither an effect of the catalogue nor a shape that "
            "repeats: check that the design belongs to this file, and the file's units.",
            left=left,
        )
        return replace(judgement, verdict=Verdict.UNEXPLAINED, sentence=sentence, claimed=()), best
    if _cancel(joint, best):
        why = Message("effects that cancel each other over {times:g} times explain too little", times=CANCELS)
        judgement = unclaimed(judgement, judgement.claimed, why)
    if shapes_of(best):
        why = Message("less than {times:g} times what has no name", times=OVER_NAMELESS)
        judgement = unclaimed(judgement, _under_nameless(joint, best), why)
    if left > LEFT_OVER:
        limit = Message(
            "what remains in {where} is {left:.1f} times its noise and has no name: something else is at work too",
            where=where,
            left=left,
        )
        judgement = replace(judgement, limits=(*judgement.limits, limit), left=left)
    if judgement.verdict != Verdict.NONE and any(runs_disagree(part, best) for part in joint.parts):
        sentence = Message("The runs differ from each other by more than the noise within them: nothing is claimed.")
        return replace(judgement, verdict=Verdict.RUNS_DISAGREE, sentence=sentence, claimed=()), best
    if all(part.noise.runs == 1 for part in joint.parts):
        limit = Message(
            "one run only: noise cannot be told from what repeats, so no name is certain; repeat the measurement"
        )
        words = Message(
            "One run only: consistent with {names}, but noise cannot be told from what repeats.", names=_names(best)
        )
        if judgement.verdict != Verdict.NONE:
            judgement = replace(judgement, verdict=Verdict.AMBIGUOUS, sentence=words)
        return replace(judgement, claimed=(), limits=(limit, *judgement.limits)), best
    several = [part for part in joint.parts if part.noise.runs > 1]
    alone = [e.name for e in best.effects if not any(e.key in part.names for part in several)]
    why = Message("of one run only, whose noise cannot be told from what repeats")
    return unclaimed(judgement, alone, why), best


def _within_floor(joint: Joint, found: list[Hypothesis]) -> tuple[Judgement, Hypothesis]:
    distinct = _distinct(found)
    best = found[0]
    likely = [h for h in distinct if h.score < best.score + RIVAL]
    # A name of the catalogue comes before an anonymous shape that does no better ...
    named = [h for h in likely if h.effects and not any(e.shape for e in h.effects)]
    best = named[0] if named and best.effects else best
    sure = _sure(best, distinct, [h.score for h in distinct])
    # ... and the smallest subset nested in the best and as likely before the best: what more that holds is not needed.
    nested = [h for h in found if h.key <= best.reach and sure <= h.holds and h.score < best.score + MARGIN]
    best = min(nested, key=lambda h: (len(h.key), h.parameters, h.score))
    rivals = [h for h in likely if not best.key <= h.reach]
    common = best.claims & sure
    reported = best.claims.union(*(h.claims for h in likely)) if best.effects else frozenset[str]()
    anonymous = any(e.shape for e in best.effects)
    if shapes_of(best) or shapes_of(found[0]):
        common = _beside_shapes(common, found) if _explained(joint, found, best) >= MOST else frozenset()
    verdict: Verdict
    if not best.effects:
        disagree = any(runs_disagree(part, best) for part in joint.parts)
        verdict, rivals = (Verdict.RUNS_DISAGREE if disagree else Verdict.NONE), []
    elif anonymous and not best.claims:
        verdict = Verdict.UNTRACED_SHAPE
    elif anonymous:
        verdict = Verdict.PARTIAL
    elif best.claims != common:
        verdict = Verdict.AMBIGUOUS
    else:
        verdict = Verdict.TRACED if len(best.effects) == 1 else Verdict.COMBINATION
    judgement = Judgement(
        verdict=verdict,
        sentence=_sentence(verdict, best, rivals, sorted(reported - best.claims)),
        claimed=tuple(sorted(common)),
        reported=tuple(sorted(reported)),
        rivals=tuple(tuple(e.name for e in h.effects) for h in rivals),
        separate=separations(e for h in (best, *rivals) for e in h.effects),
    )
    return judgement, best.at(joint, loose=False)


def _of_several_orders(best: Hypothesis) -> frozenset[str]:
    """Names of which a subset has several of one sort: orders of lobing or waviness that together make a shape."""
    sorts = Counter(e.sort for e in best.effects if e.member and not e.shape)
    return frozenset(e.name for e in best.effects if sorts[e.sort] > 1)


def shapes_of(best: Hypothesis) -> int:
    """How many shapes a subset has that no name explains: forms without a name, and orders that together make one."""
    return sum(e.shape or e.name in _of_several_orders(best) for e in best.effects)


def _beside_shapes(names: frozenset[str], found: list[Hypothesis]) -> frozenset[str]:
    """Names that neither other shapes nor a form error of any size stand for.

    Where something has no name, what a name does may be a part of it. So subsets without that name must be less likely
    by `BESIDE_UNKNOWN`.

    Args:
        names: to choose from.
        found: the fitted subsets.
    """

    def needed(name: str) -> bool:
        has = min(h.loose_score for h in found if name in h.holds)
        return min(h.loose_score for h in found if name not in h.holds) >= has + BESIDE_UNKNOWN

    return frozenset(filter(needed, names))


def _distinct(found: list[Hypothesis]) -> list[Hypothesis]:
    """The best of each set of names: places and widths from which a search began are no rivals of each other."""
    first: dict[tuple[frozenset[str], int], Hypothesis] = {}
    for h in found:
        first.setdefault((h.claims, sum(e.shape for e in h.effects)), h)
    return list(first.values())


def _below_floor(joint: Joint, h: Hypothesis) -> bool:
    """Do effects of the subset, one or some together, change no registered residual by a share of its floor?

    Together, because two near twins of opposite sign can make any small shape that neither makes. A camera knows no
    form error.
    """
    own = [e for e in h.effects if not e.stage.of_instrument]
    least = LEAST_OF_FLOOR * np.array([part.model.floor for part in joint.parts])

    def changes(some: Collection[Effect]) -> list[Array]:
        return [_change(part, h, some) for part in joint.parts]

    def below(changed: Iterable[Array], times: float = 1.0) -> bool:
        return all(np.sqrt(np.mean(c**2)) < times * small for c, small in zip(changed, least, strict=True))

    alone = {e.key: changes((e,)) for e in own}
    if any(map(below, alone.values())):
        return True
    # What several change is near the sum of what each does: only where that is small are they taken out together.
    several = chain.from_iterable(combinations(own, size) for size in range(2, len(own) + 1))
    summed = ((some, zip(*(alone[e.key] for e in some), strict=True)) for some in several)
    return any(
        below((np.sum(part, axis=0) for part in parts), _SUMMED) and below(changes(some)) for some, parts in summed
    )


def _change(part: Part, h: Hypothesis, some: Collection[Effect]) -> Array:
    """Change of a part's registered residual by some effects of a subset together, shape (n,), internal units."""
    rest = [(e, v) for e, v in h.active if e not in some]
    return registered(part.model, part.noise, part.residual(h.active) - part.residual(rest))


def _changed(part: Part, best: Hypothesis, some: Collection[Effect]) -> float:
    """Sum of squares, over the noise, of what some effects of a subset change together in a part."""
    return float(np.sum((_change(part, best, some) / part.noise.rms) ** 2))


def _cancel(joint: Joint, best: Hypothesis) -> bool:
    """Does an effect of the subset change each record that it acts in by `CANCELS` times what all do together there?

    An effect of an instrument stands beside one of the part that it cancels, as a divider that is set by the disc.
    """
    wholes = [_changed(part, best, best.effects) for part in joint.parts]

    def cancels(one: Effect) -> bool:
        changes = [_changed(part, best, (one,)) for part in joint.parts]
        acting = [(c, whole) for c, whole in zip(changes, wholes, strict=True) if c > 0]
        return bool(acting) and all(change > CANCELS**2 * whole for change, whole in acting)

    return not any(e.instrument for e in best.effects) and any(map(cancels, best.effects))


def _under_nameless(joint: Joint, best: Hypothesis) -> list[str]:
    """Names that in no record show `OVER_NAMELESS` times as much as the subset's shapes and chance do there."""
    several = _of_several_orders(best)
    shapes = [e for e in best.effects if e.shape or e.name in several]

    by_chance = [CHANCE * float(np.sqrt(2 * len(part.model.rows.run))) for part in joint.parts]
    sizes = [_changed(part, best, shapes) + more for part, more in zip(joint.parts, by_chance, strict=True)]

    def shows(effect: Effect) -> bool:
        changes = [_changed(part, best, (effect,)) for part in joint.parts]
        return any(change >= OVER_NAMELESS**2 * size for change, size in zip(changes, sizes, strict=True))

    return [e.name for e in best.effects if e not in shapes and not shows(e)]


def _explained(joint: Joint, found: list[Hypothesis], best: Hypothesis) -> float:
    """Share of the registered residuals' square, each over its noise, that the named effects take away."""
    none = next(h for h in found if not h.effects)
    named = [(e, v) for e, v in best.active if not e.shape]
    before, after = (
        sum(float(np.sum((registered(p.model, p.noise, p.residual(a)) / p.noise.rms) ** 2)) for p in joint.parts)
        for a in (none.active, named)
    )
    return 1.0 - after / before


def _beyond_floor(joint: Joint, loose: Hypothesis, found: list[Hypothesis]) -> tuple[Judgement, Hypothesis]:
    """No subset leaves a residual within the floor: an unknown shape is there, alone or beside effects."""
    alone = min((h for h in found if not h.claims), key=lambda h: h.loose_score)
    best = loose if loose.claims and loose.loose_score < alone.loose_score - BESIDE_UNKNOWN else alone
    if best.claims and _explained(joint, found, best) < MOST:
        best = alone
    verdict: Verdict = Verdict.PARTIAL if best.claims else Verdict.UNTRACED_SHAPE
    # Beside an unknown shape, too, a name is claimed only if no other does as well.
    distinct = _distinct(sorted(found, key=lambda h: h.loose_score)) if best.claims else []
    claimed = _beside_shapes(best.claims & _sure(best, distinct, [h.loose_score for h in distinct]), found)
    likely = [h for h in distinct if h.loose_score < best.loose_score + RIVAL]
    rivals = [h for h in likely if not best.key <= h.reach]
    reported = best.claims.union(*(h.claims for h in likely))
    beyond = best.at(joint, loose=True)
    _, place, size, part = max((largest(part, joint, beyond) for part in joint.parts), key=lambda found: found[0])
    unit = part.model.unit
    stated = {"size": size / UNITS[unit], "unit": unit, "place": np.degrees(place)}
    where = Message(" in {source}", source=part.record.source) if len(joint.parts) > 1 else ""
    if best.claims:
        sentence = Message(
            "Partly consistent with {names}; what remains is no effect of the catalogue: a smooth shape beyond the "
            "stated form error, largest ({size:+.3g} {unit}) at {place:.0f} deg{where}.",
            names=_names(best),
            where=where,
            **stated,
        )
    else:
        sentence = Message(
            "What remains is no effect of the catalogue: a smooth shape beyond the stated form error, largest "
            "({size:+.3g} {unit}) at {place:.0f} deg{where}.",
            where=where,
            **stated,
        )
    judgement = Judgement(
        verdict=verdict,
        sentence=sentence,
        claimed=tuple(sorted(claimed)),
        reported=tuple(sorted(reported)),
        rivals=tuple(tuple(e.name for e in h.effects) for h in rivals),
        separate=separations(e for h in (best, *rivals) for e in h.effects),
    )
    return judgement, beyond


def sure_of(names: int) -> float:
    """The chance that each of several names must have: `SURE`, and of three or more the more, the more there are.

    Bonferroni's bound over the others: each is one more that can be wrong.

    Args:
        names: how many the subset has.
    """
    return 1 - (1 - SURE) / max(names - 1, 1)


def _sure(best: Hypothesis, distinct: list[Hypothesis], scores: list[float]) -> frozenset[str]:
    """Names of a subset that those which hold them are sure of together, by the scores of all."""
    weight = np.exp((min(scores, default=0.0) - np.array(scores)) / 2)
    chance = {n: sum(w for h, w in zip(distinct, weight, strict=True) if n in h.holds) for n in best.holds}
    sure = frozenset(n for n, together in chance.items() if together >= sure_of(len(best.claims)) * weight.sum())
    return sure - _of_several_orders(best)


def _sentence(verdict: Verdict, best: Hypothesis, rivals: list[Hypothesis], possible: list[str]) -> Message:
    if verdict == Verdict.NONE:
        return Message("No effect beyond noise and the stated form error.")
    if verdict == Verdict.RUNS_DISAGREE:
        return Message("The runs differ from each other by more than the noise within them: nothing is claimed.")
    names = _names(best)
    if verdict in (Verdict.TRACED, Verdict.COMBINATION):
        traced = (
            Message("Traced to {names} together", names=names)
            if verdict == Verdict.COMBINATION
            else Message("Traced to {names}", names=names)
        )
        twins = [
            Message("{name} from {twins}", name=Message(e.name), twins=joined(map(Message, e.twins), " or "))
            for e in best.effects
            if e.twins
        ]
        if twins:
            traced = Message("{traced}; this data cannot tell {twins}", traced=traced, twins=joined(twins, " nor "))
        if possible:
            others = joined(map(Message, possible))
            return Message("{traced}; less likely but not ruled out: {others}.", traced=traced, others=others)
        return Message("{traced}.", traced=traced)
    if verdict == Verdict.UNTRACED_SHAPE:
        numbers = ", ".join(
            f"{p.name} {v / p.scale:.4g}"
            for effect, values, _ in best.values()
            for p, v in zip(effect.parameters, values, strict=True)
        )
        return Message(
            "A shape that no effect of the catalogue makes: {names} ({numbers}).", names=names, numbers=numbers
        )
    if verdict == Verdict.PARTIAL:
        return Message(
            "Partly traced to {named}; beside it, {rest}.",
            named=names_of(e for e in best.effects if not e.shape),
            rest=names_of(e for e in best.effects if e.shape),
        )
    if not rivals:
        return Message(
            "Consistent with {names}, but not sure of each: of so many names none may be likely to be wrong.",
            names=names,
        )
    others = joined(map(_names, rivals), "; or ")
    return Message("Consistent with {names}; or {others}: this data cannot tell.", names=names, others=others)


def _names(h: Hypothesis) -> Message:
    return names_of(h.effects) or Message("no effect")
