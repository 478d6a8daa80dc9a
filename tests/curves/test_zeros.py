"""Zeros of piecewise polynomials, against scipy's own search through every piece."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, PPoly

from cadgen.curves.piecewise import zeros
from cadgen.design import cam_model
from cadgen.design.load import load_design


@pytest.mark.parametrize("jumps", [False, True])
@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car", "s_course", "figure_eight"])
def test_zeros_of_lifts_and_their_slopes(name, jumps):
    design = load_design(name)
    steering = cam_model.lift(design, cam_model.track(design)).q
    for curve in (steering, steering.derivative(), steering.derivative(2)):
        expected = curve.roots(jumps, extrapolate=False)
        assert len(expected)
        np.testing.assert_array_equal(zeros(curve, jumps=jumps), expected)


@given(
    values=st.lists(st.sampled_from([-1.0, -0.5, 0.0, 1e-15, 0.5, 1.0]), min_size=2, max_size=60),
    degree=st.integers(0, 5),
    seed=st.integers(0, 2**32 - 1),
    jumps=st.booleans(),
)
def test_zeros_with_jumps_and_level_pieces(values, degree, seed, jumps):
    random = np.random.default_rng(seed)
    coefficients = random.choice([0.0, 1.0, 0.1], (degree + 1, len(values))) * random.normal(size=(degree + 1, 1))
    coefficients[-1] = values
    curve = PPoly(coefficients, np.cumsum(np.append(0.0, random.uniform(1e-6, 1.0, len(values)))))
    np.testing.assert_array_equal(zeros(curve, jumps=jumps), curve.roots(jumps, extrapolate=False))


def test_a_curve_without_zeros_has_none():
    curve = PPoly(CubicSpline([0, 1, 2, 3], [1, 2, 1, 3]).c, np.arange(4.0))
    assert zeros(curve, jumps=True).size == 0
