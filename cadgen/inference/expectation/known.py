"""Knowledge of a car so far: what may be true, as normal distributions in the directions of `linear`.

A likely subset has its own effects with the values fitted, and beside them a little of everything that cars differ by,
narrowed by the records; play and friction where they may be there; and a floor that is level or not.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.effect import Active, Effect
from cadgen.inference.expectation.linear import Linear

# Play or friction that makes the records so far less likely by this factor is not there.
ABSENT = 0.2
# The prior spread of what is fitted in a subset: so many times what cars differ by.
WIDE = 100.0
LEAST_WEIGHT = 0.01
# What is left without a name is larger than usual: by so much.
UNTRACED = 5.0


@dataclass(frozen=True)
class Prior:
    """Knowledge without a measurement.

    Attributes:
        spread: standard deviations of numbers by their names, internal units, where the design states them.
        play, friction: means where there are such effects; play is 0 for a car without.
        assumed: play that a new cam is made for while nothing is known of it, rad.
    """

    spread: Mapping[str, float]
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


class Known:
    """Knowledge of a car so far.

    Attributes:
        about: effects with the values about which everything is taken in proportion.
        subsets: what may be true, each on either kind of floor.
    """

    def __init__(self, linear: Linear, prior: Prior) -> None:
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

        Every car has a little of all that lies about 0. Play and friction are there or not: where they are not in a
        likely subset, and the rows leave p x - i x^2 / 2 of their number x in standard deviations of what cars differ
        by, about m, being there changes the evidence by exp(((p + m)^2 / (1 + i) - m^2) / 2) / sqrt(1 + i).

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
            if effect.key in inside or effect.numerous or effect.shape:
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
