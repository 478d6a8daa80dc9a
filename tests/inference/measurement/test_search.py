"""Searches that stood still before the right subset: made records whose effects an independent generator drew."""

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.deviations.effect import READING
from cadgen.inference.measurement.diagnosis import weigh
from cadgen.inference.measurement.search import LARGEST_SUBSET, MOST_CAUSES, _grown, find
from cadgen.inference.measurement.verdict import BESIDE_UNKNOWN, SURE, Verdict, _beside_shapes, sure_of
from tests.inference.measurement import study


def weighed(car, seed, kind, sort, number):
    """A case of `tests.studies.rates`, and what is said of it."""
    rng = np.random.default_rng([seed, number, len(sort), len(kind)])
    case = study.draw(car, kind, sort, rng)
    return case, weigh([case.record], study.nominal(car).model)


def is_of(subset, case):
    """Does a fitted subset have the effects of a case, and no others?"""
    names = [effect.name for effect in subset.effects]
    return len(names) == len(case.truth) and all(any(study.same(t, name) for name in names) for t in case.truth)


@pytest.mark.parametrize(
    ("seed", "kind", "sort", "number"),
    [
        pytest.param(
            *(7001, "lift", "four", 1), marks=[pytest.mark.slow, pytest.mark.long]
        ),  # two effects more than there are stood for them; it had to lose both at once
        (7001, "lift", "four", 8),  # a local bump and a gain stood for a wobble and an axial offset
        (7001, "profile", "four", 8),  # axes out of square stood for a lobing of order 2, one of many orders
        (7001, "profile", "four", 9),  # a scale stood for a worn nose, one of many places
        (7001, "lift", "pair", 40),  # "unexplained"
    ],
)
def test_the_right_subset_is_the_best_one(synthetic_car, seed, kind, sort, number):
    case, found = weighed(synthetic_car, seed, kind, sort, number)
    assert is_of(found.found[0], case)
    assert all(any(study.same(t, name) for t in case.truth) for name in found.judgement.claimed)


def test_an_effect_is_named_although_smaller_ones_beside_it_are_too_small_to_be(synthetic_car):
    case, found = weighed(synthetic_car, 8101, "lift", "single", 5)
    assert found.judgement.claimed == case.truth == ("lost motion by friction",)
    assert found.judgement.verdict == Verdict.TRACED


def test_beside_an_unknown_shape_a_name_is_not_claimed_that_another_does_as_well_as(synthetic_car):
    _, found = weighed(synthetic_car, 8101, "profile", "four", 19)
    judged = found.judgement
    assert judged.verdict == Verdict.PARTIAL
    assert set(judged.claimed) == {"machine-axis reversal", "waviness, order 71"}
    assert {"uniform scale", "cutter compensation"} <= set(judged.reported)
    assert judged.rivals


def test_up_to_two_names_need_the_same_chance_and_more_need_more():
    assert [sure_of(n) for n in (0, 1, 2)] == [SURE] * 3
    assert sure_of(4) == pytest.approx(0.95)
    assert np.all(np.diff([sure_of(n) for n in range(2, 8)]) > 0)


def test_subsets_about_the_best_one():
    """Of nine alike effects, four in the best subset: counted by hand from all subsets of the sizes that are grown."""
    effects = tuple(SimpleNamespace(key=str(i), beside=None, group=None, member=False, stage=READING) for i in range(9))
    inside = set(range(4))
    best = SimpleNamespace(key=frozenset(map(str, inside)))

    def near(subset):
        more, less = len(set(subset) - inside), len(inside - set(subset))
        return (more == 0) or (more == 1 and less <= 2) or (more == 2 and less == 0)

    sizes = range(LARGEST_SUBSET + 1, MOST_CAUSES + 1)
    wanted = {subset for size in sizes for subset in combinations(range(9), size) if near(subset)}
    grown = list(_grown(effects, best))
    assert set(grown) == wanted
    assert len(grown) == len(set(grown))


@pytest.mark.slow
def test_a_search_ends_where_nothing_promises_to_come_near_a_score(synthetic_car):
    _, found = weighed(synthetic_car, 7001, "transmission", "pair", 1)
    whole = find(found.joint)
    near, hopeless = (find(found.joint, against=whole[0].score - off) for off in (0.0, 1e6))
    assert near[0].key == whole[0].key
    assert whole[0].score <= hopeless[0].score
    assert len(hopeless) < len(whole)


def test_a_name_beside_a_shape_is_claimed_if_all_without_it_are_much_less_likely():
    whole = SimpleNamespace(loose_score=0.0, holds=frozenset({"eccentric bore", "lever gain"}))
    without = [
        SimpleNamespace(loose_score=BESIDE_UNKNOWN + 1, holds=frozenset({"lever gain"})),
        SimpleNamespace(loose_score=BESIDE_UNKNOWN - 1, holds=frozenset({"eccentric bore"})),
    ]
    assert _beside_shapes(whole.holds, [whole, *without]) == {"eccentric bore"}
