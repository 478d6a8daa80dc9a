"""Chains of pairs with the least cost against every chain there is."""

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen.gears.chains import Fit, best_chains


@pytest.mark.slow
@settings(deadline=None, max_examples=60)
@given(
    st.lists(st.tuples(st.integers(1, 12), st.integers(1, 12), st.floats(0.1, 10)), min_size=1, max_size=8),
    st.fractions(Fraction(1, 8), 8, max_denominator=12),
    st.sampled_from([0.0, 1 / 64, 0.25]),
    st.integers(1, 4),
    st.integers(1, 6),
)
def test_chains_of_any_costs_are_those_of_brute_force(pairs, ratio, tolerance, length, keep):
    driver, driven, cost = (np.array(column) for column in zip(*pairs, strict=True))
    expected = []
    for rows in product(range(len(pairs)), repeat=length):
        total, behind = 0.0, Fraction(1)
        for row in reversed(rows):
            total += pairs[row][2] / float(behind)
            behind *= Fraction(pairs[row][1], pairs[row][0])
        if abs(behind / ratio - 1) <= Fraction(tolerance):
            expected.append(total)
    found = best_chains(driver, driven, cost, ratio=ratio, tolerance=tolerance, length=length, keep=keep)
    assert len(found) == min(keep, len(expected))
    lags = []
    for rows in found:
        lag = 0.0
        for row in rows:
            lag = lag * driver[row] / driven[row] + cost[row]
        lags.append(lag)
    assert lags == pytest.approx(sorted(expected)[: len(found)])


@settings(deadline=None, max_examples=30)
@given(
    st.lists(
        st.tuples(st.integers(1, 9), st.integers(1, 9), st.floats(0.1, 10), st.lists(st.booleans(), min_size=4)),
        min_size=1,
        max_size=6,
    ),
    st.fractions(Fraction(1, 4), 4, max_denominator=6),
    st.integers(1, 4),
)
def test_pairs_stand_only_where_they_may(pairs, ratio, length):
    driver, driven, cost = (np.array([pair[column] for pair in pairs]) for column in range(3))
    allowed = [np.array([pair[3][place] for pair in pairs]) for place in range(length)]
    expected = []
    for rows in product(range(len(pairs)), repeat=length):
        total, behind = 0.0, Fraction(1)
        for row in reversed(rows):
            total += pairs[row][2] / float(behind)
            behind *= Fraction(pairs[row][1], pairs[row][0])
        if behind == ratio and all(allowed[place][row] for place, row in enumerate(rows)):
            expected.append(total)
    fit = Fit.anywhere(length, driver.size, np.array(allowed))
    found = best_chains(driver, driven, cost, ratio=ratio, tolerance=0.0, length=length, keep=5, fit=fit)
    assert len(found) == min(5, len(expected))
    lags = []
    for rows in found:
        lag = 0.0
        for place, row in enumerate(rows):
            assert allowed[place][row]
            lag = lag * driver[row] / driven[row] + cost[row]
        lags.append(lag)
    assert lags == pytest.approx(sorted(expected)[: len(found)])


@pytest.mark.slow
@settings(deadline=None, max_examples=60)
@given(
    st.lists(
        st.tuples(
            st.integers(1, 9),
            st.integers(1, 9),
            st.floats(0.1, 10),
            st.integers(1, 4),
            st.integers(1, 4),
            st.integers(1, 3),
        ),
        min_size=1,
        max_size=7,
    ),
    st.data(),
    st.fractions(Fraction(1, 4), 4, max_denominator=6),
    st.integers(1, 4),
    st.integers(3, 9),
)
def test_neighbours_clear_each_other_and_all_fit_between_the_bearings(pairs, data, ratio, length, most):
    driver, driven, cost, wheel, pinion, height = (np.array([pair[column] for pair in pairs]) for column in range(6))
    rooms = st.lists(st.integers(1, 4), min_size=len(pairs), max_size=len(pairs))
    after, before = (
        np.array([data.draw(rooms) for _ in range(length - 1)], float).reshape(-1, len(pairs)) for _ in "ab"
    )
    expected = []
    for rows in product(range(len(pairs)), repeat=length):
        total, behind = 0.0, Fraction(1)
        for row in reversed(rows):
            total += pairs[row][2] / float(behind)
            behind *= Fraction(pairs[row][1], pairs[row][0])
        clear = all(wheel[a] <= after[j][b] and pinion[b] <= before[j][a] for j, (a, b) in enumerate(pairwise(rows)))
        if behind == ratio and clear and sum(height[row] for row in rows) <= most:
            expected.append(total)
    everywhere = Fit.anywhere(length, len(pairs))
    fit = replace(
        everywhere, wheel=wheel, pinion=pinion, after=after, before=before, height=height, most_height=float(most)
    )
    found = best_chains(driver, driven, cost, ratio=ratio, tolerance=0.0, length=length, keep=5, fit=fit)
    lags = []
    for rows in found:
        lag = 0.0
        for row in rows:
            lag = lag * driver[row] / driven[row] + cost[row]
        lags.append(lag)
    assert lags == pytest.approx(sorted(expected)[:5])
