"""The sum of tolerance zones against closed forms, scipy's own laws and samples."""

from math import comb, factorial, floor

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

from cadgen.gears.distribution import SIGMAS, ZoneSum

# The Fourier series is cut off after its 4096 terms, which leaves out less than this of the probability.
SERIES = 1e-8
zones = st.lists(st.tuples(st.floats(-2, 2), st.floats(0.01, 3)), min_size=1, max_size=8)
laws = st.sampled_from(["normal", "uniform"])


def zone_sum(parts, law):
    low = np.array([low for low, _ in parts])
    return ZoneSum(
        names=tuple(map(str, range(len(parts)))), low=low, high=low + np.array([w for _, w in parts]), law=law
    )


def irwin_hall(x: float, n: int) -> float:
    """Distribution function of the sum of n uniform numbers of [0, 1]."""
    return sum((-1) ** k * comb(n, k) * (x - k) ** n for k in range(floor(x) + 1)) / factorial(n)


@pytest.mark.parametrize("count", [1, 2, 3, 5, 8])
def test_equal_uniform_zones_follow_irwin_and_hall(count):
    total = zone_sum([(1.0, 2.0)] * count, "uniform")
    x = np.linspace(0, count, 41)
    expected = [irwin_hall(value, count) for value in x]
    assert total.cdf(count + 2 * x) == pytest.approx(expected, abs=SERIES)


def test_one_clipped_normal_zone_is_scipys_truncated_normal():
    total = zone_sum([(2.0, 6.0)], "normal")
    law = stats.truncnorm(-SIGMAS, SIGMAS, loc=5.0, scale=1.0)
    x = np.linspace(1, 9, 81)
    assert total.cdf(x) == pytest.approx(law.cdf(x), abs=SERIES)
    assert total.std == pytest.approx(law.std(), rel=1e-12)
    assert total.quantile([0.01, 0.4, 0.99]) == pytest.approx(law.ppf([0.01, 0.4, 0.99]), abs=1e-6)


def test_two_clipped_normal_zones_are_the_convolution_by_quadrature():
    total = zone_sum([(0.0, 6.0), (0.0, 3.0)], "normal")
    wide = stats.truncnorm(-SIGMAS, SIGMAS, loc=3.0, scale=1.0)
    narrow = stats.truncnorm(-SIGMAS, SIGMAS, loc=1.5, scale=0.5)
    node, weight = np.polynomial.legendre.leggauss(200)
    inner = 1.5 * (node + 1)
    for x in (1.0, 3.0, 5.0, 7.5):
        assert float(total.cdf(x)) == pytest.approx(
            1.5 * np.sum(weight * narrow.pdf(inner) * wide.cdf(x - inner)), abs=1e-6
        )


@pytest.mark.slow
@settings(deadline=None, max_examples=25)
@given(zones, laws, st.integers(0, 2**32 - 1))
def test_samples_stay_in_their_zones_and_have_the_stated_moments(parts, law, seed):
    total, count = zone_sum(parts, law), 4000
    drawn = total.sample_contributions(np.random.default_rng(seed), count)
    assert drawn.shape == (count, len(parts))
    assert (drawn >= total.low).all()
    assert (drawn <= total.high + 1e-15 * np.abs(total.high)).all()
    sums = total.sample(np.random.default_rng(seed), count)
    assert sums == pytest.approx(drawn.sum(axis=1))
    # Six standard errors: one false alarm in 10^9.
    assert abs(sums.mean() - total.mean) < 6 * total.std / np.sqrt(count)
    assert abs(sums.std() / total.std - 1) < 6 / np.sqrt(2 * count)


@pytest.mark.slow
@settings(deadline=None, max_examples=25)
@given(zones, laws)
def test_bounds_mean_and_quantiles_are_in_order(parts, law):
    total = zone_sum(parts, law)
    assert total.minimum <= total.mean <= total.maximum
    assert total.quantile([0.0, 1.0]) == pytest.approx([total.minimum, total.maximum])
    quantiles = total.quantile([0.0, 0.001, 0.1, 0.5, 0.9, 0.999, 1.0])
    assert (np.diff(quantiles) > 0).all()
    assert quantiles[3] == pytest.approx(total.mean, abs=1e-6)
    assert total.cdf(quantiles[1:-1]) == pytest.approx([0.001, 0.1, 0.5, 0.9, 0.999], abs=SERIES)


@settings(deadline=None, max_examples=25)
@given(zones, laws, st.floats(0.1, 10))
def test_scaling_scales_everything(parts, law, factor):
    total = zone_sum(parts, law)
    scaled = total.scaled(factor)
    assert scaled.std == pytest.approx(factor * total.std)
    assert scaled.quantile(0.9) == pytest.approx(factor * total.quantile(0.9))


def test_zones_without_width_are_certain():
    sure = ZoneSum(names=("a", "b"), low=np.array([1.0, 2.0]), high=np.array([1.0, 2.0]))
    assert sure.std == 0
    assert sure.cdf([2.9, 3.0]).tolist() == [0.0, 1.0]
    assert sure.quantile(0.3) == pytest.approx(3.0)
