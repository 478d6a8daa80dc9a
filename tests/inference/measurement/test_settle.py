"""Least squares within bounds: against SciPy's solvers, and where no residual can be had."""

import numpy as np
import pytest
from scipy.optimize import lsq_linear

from cadgen.errors import DesignError
from cadgen.inference.measurement.hypothesis import least_squares


def _squares(residual, slopes):
    """Half the sum of squares, and information and gradient, of rows and their derivatives."""

    def half(v):
        r = residual(v)
        return float(r @ r) / 2

    return half, lambda v: (slopes(v).T @ slopes(v), slopes(v).T @ residual(v))


FREE = np.array([[-1e3] * 4, [1e3] * 4])


@pytest.mark.parametrize("seed", range(6))
def test_a_linear_problem_within_bounds_is_solved_in_one_step(seed):
    rng = np.random.default_rng(seed)
    A, b = rng.normal(size=(30, 4)) * [1.0, 1e-3, 1e3, 5.0], rng.normal(size=30)
    free = np.linalg.lstsq(A, b, rcond=None)[0]
    # Two of the values lie beyond a bound.
    half = np.abs(free) * [2.0, 0.5, 0.7, 3.0]
    bounds = np.stack([-half, half])
    looked = []
    half, normal = _squares(lambda v: A @ v - b, lambda v: A)
    x, H, done = least_squares(lambda v: looked.append(1) or half(v), normal, np.zeros(4), bounds)
    expected = lsq_linear(A, b, bounds, tol=1e-14)
    assert done
    assert (x >= bounds[0]).all()
    assert (x <= bounds[1]).all()
    assert np.sum((A @ x - b) ** 2) / 2 <= expected.cost + 2e-3
    assert len(looked) <= 5
    assert pytest.approx(A.T @ A) == H


def test_a_crooked_valley_is_followed_to_its_end():
    """Rosenbrock's."""
    x, _, done = least_squares(
        *_squares(
            lambda v: np.array([10 * (v[1] - v[0] ** 2), 1 - v[0]]),
            lambda v: np.array([[-20 * v[0], 10.0], [-1.0, 0.0]]),
        ),
        np.array([0.2, 0.5]),
        np.array([[-2.0, -2.0], [2.0, 2.0]]),
    )
    assert done
    assert x == pytest.approx([1.0, 1.0], abs=0.05)


def test_a_value_without_effect_stays_and_a_step_too_far_is_taken_back():
    def residual(v):
        if v[0] > 2:
            raise DesignError("no rod can follow")
        return np.array([30 * (np.sqrt(v[0] + 0.1) - 1.2)])

    x, _, done = least_squares(
        *_squares(residual, lambda v: np.array([[15 / np.sqrt(v[0] + 0.1), 0.0]])),
        np.array([0.0, 0.3]),
        np.array([[0.0, -1.0], [9.0, 1.0]]),
    )
    assert done
    assert x == pytest.approx([1.34, 0.3], abs=1e-2)


def test_it_says_when_it_did_not_settle():
    """A residual whose slopes are wrong by a factor of thirty creeps."""
    residual = lambda v: np.concatenate([1e3 * (v - 5), [1.0]])  # noqa: E731
    _, _, done = least_squares(*_squares(residual, lambda v: np.array([[3e4], [0.0]])), np.zeros(1), FREE[:, :1])
    assert not done


def test_a_fit_that_stays_behind_a_level_is_given_up():
    """Rosenbrock's crooked valley, 1000 higher: no gain that is expected brings it down to the level."""
    asked = []

    def residual(x):
        return np.array([10 * (x[1] - x[0] ** 2), 1 - x[0], np.sqrt(2000.0)])

    def half(x):
        asked.append(x)
        return float(residual(x) @ residual(x)) / 2

    def normal(x):
        J = np.array([[-20 * x[0], 10.0], [-1.0, 0.0], [0.0, 0.0]])
        return J.T @ J, J.T @ residual(x)

    start, bounds = np.array([-1.2, 1.0]), np.array([[-5.0, -5.0], [5.0, 5.0]])
    free = least_squares(half, normal, start, bounds)
    whole = len(asked)
    given_up = least_squares(half, normal, start, bounds, level=100.0)
    assert len(asked) - whole < whole
    assert not given_up[2]
    reached = least_squares(half, normal, start, bounds, level=1005.0)
    assert np.array_equal(reached[0], free[0])
