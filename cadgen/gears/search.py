"""Which order of stages, and which tooth numbers, leave the output the least return error.

In eq. 25 a stage's return error reaches the output divided by the ratios behind it, so the last stage counts
most, and is best with a large wheel and a high ratio. `all_orders` ranks every order of given stages, `search_trains`
every choice of teeth, module and face width within limits; both by the greatest return error, least first.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import numpy as np

from cadgen.errors import DesignError
from cadgen.gears.candidates import Pairs, fit_of, form_of, pairs_within
from cadgen.gears.chains import Fit, best_chains
from cadgen.gears.kinds.spur import GearPair, spur_pairs
from cadgen.gears.layout import Blanks
from cadgen.gears.limits import SearchLimits
from cadgen.gears.names import Order
from cadgen.gears.stage import Stage
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.train import Train, TrainPlay, train_play


def arrange(train: Train, order: Order, limits: SearchLimits | None = None) -> tuple[TrainPlay, ...]:
    """The trains that an order calls for, least return error first.

    `as-given` gives the train alone, `reordered` every order of its stages, `search` the trains within
    `limits`, by default those `SearchLimits.like` the train.
    """
    if order == Order.SEARCH:
        return search_trains(limits or SearchLimits.like(train))
    return all_orders(train) if order == Order.REORDERED else (train_play(train),)


def all_orders(train: Train) -> tuple[TrainPlay, ...]:
    """Every distinct order of the stages, least greatest return error first."""
    designed = train_play(train)
    plays: dict[Train, TrainPlay] = {}
    for order in permutations(range(len(train.stages))):
        reordered = train.reordered(order)
        plays.setdefault(reordered, TrainPlay(train=reordered, stages=tuple(designed.stages[j] for j in order)))
    return tuple(sorted(plays.values(), key=lambda play: play.return_error_max))


def search_trains(limits: SearchLimits, blanks: Blanks | None = None, clearance: float = 0.0) -> tuple[TrainPlay, ...]:
    """The `limits.keep` trains within the limits with the least greatest return error, best first.

    With `blanks` only trains whose gears fit them, each at its place, and whose wheels pass the shafts beside them
    with `clearance` (mm). Raises `DesignError` if no train is within the limits, and for limits so wide that the
    search would not end.

    Args:
        limits: limits of the search.
        blanks: blanks that the gears must fit; None for any.
        clearance: least gap between a wheel and the shafts beside it, mm.
    """
    return TrainSearch(limits, blanks, clearance).best(limits.keep)


class TrainSearch:
    """The pairs within limits, and the best trains of those that have not been excluded."""

    def __init__(self, limits: SearchLimits, blanks: Blanks | None = None, clearance: float = 0.0) -> None:
        self._limits, self._blanks = limits, blanks
        self._pairs = pairs_within(limits)
        self._fit = (
            Fit.anywhere(limits.stages, self._pairs.driver.size)
            if blanks is None
            else fit_of(self._pairs, limits, blanks, clearance)
        )
        self._excluded: set[int] = set()

    def best(self, keep: int) -> tuple[TrainPlay, ...]:
        """The `keep` trains of the least greatest return error, best first.

        Raises `DesignError` if there is none, or none left, and if the search would not end.
        """
        limits, pairs = self._limits, self._pairs
        chains = best_chains(
            pairs.driver,
            pairs.driven,
            pairs.return_error,
            ratio=limits.ratio,
            tolerance=limits.ratio_tolerance,
            length=limits.stages,
            keep=keep,
            fit=self._fit,
        )
        if not chains:
            kept = ", gears that fit their blanks and wheels that pass the shafts beside them" if self._blanks else ""
            left = f", {len(self._excluded)} pairs left out whose teeth fail" if self._excluded else ""
            raise DesignError(
                f"no train of {limits}{kept}{left} has the ratio {limits.ratio} within {limits.ratio_tolerance:g};"
                " widen the limits or raise the ratio tolerance"
            )
        return tuple(train_play(Train(tuple(_stage(pairs, row, limits) for row in rows))) for rows in chains)

    def exclude(self, stage: Stage) -> None:
        """Leave out a pair, at every place: its teeth cannot be made, or fail their checks."""
        (pair,) = spur_pairs(Train((stage,)), "the search is")
        driver, driven = pair.driver.form, pair.driven.form
        same = (self._pairs.driver == driver.teeth) & (self._pairs.driven == driven.teeth)
        same &= (self._pairs.module == driver.normal_module) & (self._pairs.width == driver.width)
        self._fit.allowed[:, same] = False
        self._excluded.update(np.flatnonzero(same).tolist())


def _stage(pairs: Pairs, row: int, limits: SearchLimits) -> GearPair:
    teeth, module = (int(pairs.driver[row]), int(pairs.driven[row])), float(pairs.module[row])
    driver, driven = (
        replace(
            limits.pattern,
            form=form_of(limits, z, module, float(pairs.width[row])),
            overrides=ToleranceOverrides(),
        )
        for z in teeth
    )
    return GearPair(
        driver=driver,
        driven=driven,
        centre_distance=module * sum(teeth) / 2,
        bearing_span=limits.bearing_span,
    )
