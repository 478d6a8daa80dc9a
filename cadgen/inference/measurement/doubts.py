"""Doubts about a claimed name: is it of one size all the turn, and does nothing without a name do better in its place?

Both are asked of the likeliest subset alone. A subset can leave no more than noise and still name what is not there,
where something that is not in the catalogue looks like what is.
"""

import numpy as np
from scipy.stats import chi2

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect
from cadgen.deviations.track import SMOOTH_FORMS
from cadgen.inference.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.inference.measurement.joint import Joint, Part
from cadgen.inference.measurement.verdict import BESIDE_UNKNOWN, Judgement, names_of, unclaimed
from cadgen.messages import Message

# Parts of a turn in which an effect's size is compared, by equal numbers of rows.
_PARTS = 3
# Sizes differ if chance makes them differ so much less often than this, and by more than this share of the size, rms:
# no model is right to the last percent.
_CHANCE, _LEAST_SHARE = 1e-6, 0.05
_FORMS = frozenset(form.key for form in SMOOTH_FORMS)
_BETTER = 0.1  # -2 log L beyond what a fit leaves open
_ALIKE = 1e-9  # share of a column's square that keeps what is left of one like others from being rounding


def with_doubts(judgement: Judgement, joint: Joint, best: Hypothesis) -> Judgement:
    """The judgement without names that are of another size in each part of the turn, or that a form does better than.

    Args:
        judgement: on the subset.
        joint: the records.
        best: the subset, fitted.
    """
    claimed = [e for e in best.effects if e.name in judgement.claimed]
    for effect in claimed:
        if better := _better_form(effect, joint, best):
            form = Message(better.effects[-1].name)
            why = Message("{form} in its place explains the records better", form=form)
            judgement = unclaimed(judgement, [effect.name], why)
            why = Message("hardly needed beside {form}", form=form)
            spare = [e.name for e in claimed if e in better.effects and _spare(e, joint, better)]
            judgement = unclaimed(judgement, spare, why)
    claimed = [e for e in claimed if e.name in judgement.claimed]
    for part in joint.parts:
        here = [e for e in claimed if e.key in part.names]
        if uneven := [e for e in here if _differs(e, here, part, joint, best)]:
            # Then it is something else, and what is named beside it makes up for that.
            why = Message("of another size in each part of the turn: {names}", names=names_of(uneven))
            judgement = unclaimed(judgement, [e.name for e in here], why)
    return judgement


def _better_form(effect: Effect, joint: Joint, best: Hypothesis) -> Hypothesis | None:
    """The best subset with a smooth form in an effect's place, where that fits the records better; None without one.

    The form has one number as the effect, and is the last of the effects. A name of the catalogue that is that form
    does as well, and stands.
    """
    others = _without(effect, best)
    if any(e.shape for e in others) or len(effect.parameters) > 1:
        return None
    least = _misfit(joint, best, best) - _BETTER
    for form in (e for e in joint.members if e.key in _FORMS):
        found = fit(joint, (*others, form), _start(effect, best), Search(joint.rows), level=least)
        if _misfit(joint, best, found) < least:
            return found
    return None


def _spare(effect: Effect, joint: Joint, better: Hypothesis) -> bool:
    """Are the records nearly as likely without an effect, beside a form? Then what it does may be a part of that."""
    most = _misfit(joint, better, better) + BESIDE_UNKNOWN
    found = fit(joint, _without(effect, better), _start(effect, better), Search(joint.rows), level=most)
    return _misfit(joint, better, found) < most


def _without(effect: Effect, subset: Hypothesis) -> tuple[Effect, ...]:
    return tuple(e for e in subset.effects if e != effect and e.beside != effect)


def _start(effect: Effect, subset: Hypothesis) -> Active:
    return [(e, v) for e, v in subset.active if e != effect]


def _misfit(joint: Joint, best: Hypothesis, subset: Hypothesis) -> float:
    """Least -2 log L of a subset by a form error within what is stated, or beyond it, as that of the best one."""
    return float(subset.misfit[joint.within if best.spectrum.within else ~joint.within].min())


def _differs(effect: Effect, claimed: list[Effect], part: Part, joint: Joint, best: Hypothesis) -> bool:
    """Does an effect's size differ from part to part of a record's turn?

    To first order, by the score test: columns are added that let the effect differ, beside those that let the other
    claimed ones, and a datum of its own in each part of the turn. They lessen r'C^-1 r by a chi-square with as many
    degrees of freedom as they are.
    """
    own, residual = part.own(best.active), part.residual(best.active)

    def slopes(effects: tuple[Effect, ...]) -> Array:
        return part.slopes(tuple(part.names[e.key] for e in effects if e.key in part.names), own, residual)

    mine = slopes((effect,))
    alive = np.linalg.norm(mine, axis=0) > 0
    if not alive.any():
        return False
    values = next(v for e, v in best.active if e == effect)[alive]
    mine = mine[:, alive]
    others = slopes(tuple(e for e in claimed if e != effect))
    place = part.model.rows.place
    rank = np.argsort(np.argsort(place, kind="stable"), kind="stable")
    here = [(rank * _PARTS // len(place) == number)[:, None] for number in range(1, _PARTS)]

    def differing(columns: Array) -> Array:
        # They change nothing if the size is one: of a part, less what the whole has of it.
        return np.hstack([columns * (rows - 1 / _PARTS) for rows in here])

    own_datum = (part.model.offsets * rows for rows in here)
    beside = np.hstack([slopes((*joint.datum, *best.effects)), *own_datum, differing(others)])
    white = part.evidence.whiten(np.hstack([beside, differing(mine), residual[:, None]]))
    products = part.evidence.products(white, white, [joint.grid.index(best.spectrum)])[0]
    size = np.sqrt(np.maximum(np.diag(products), np.finfo(float).tiny))
    products, first = products / size / size[:, None], beside.shape[1]
    # What is left of the columns, and of their products with the residual, once all beside them is fitted.
    shared = products[first:-1, :first] @ np.linalg.pinv(products[:first, :first], rcond=_ALIKE, hermitian=True)
    left, right = (products[first:-1, k] - shared @ products[:first, k] for k in (slice(first, -1), -1))
    scaled = np.linalg.pinv(left, rcond=_ALIKE, hermitian=True) @ right
    gain = float(right @ scaled) * size[-1] ** 2
    found = (scaled * size[-1] / size[first:-1]).reshape(_PARTS - 1, -1)
    sizes = np.vstack([np.zeros(len(values)), found]) - found.sum(axis=0) / _PARTS
    units = np.array([p.unit for p in effect.parameters])[alive]
    shares = [np.mean(np.sum(sizes[:, units == u] ** 2, axis=1)) / np.sum(values[units == u] ** 2) for u in set(units)]
    return bool(chi2.sf(gain, len(right)) < _CHANCE and max(shares) > _LEAST_SHARE**2)
