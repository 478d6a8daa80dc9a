"""Both splines of the paper: end conditions, and the order at which they converge to a known curve."""

import numpy as np
import pytest

from cadgen.car.path.spline import plan_path
from cadgen.errors import DesignError

WAYPOINTS = np.array([[0.0, 0.0], [400.0, 100.0], [900.0, -50.0], [1300.0, 300.0], [1250.0, 800.0], [700.0, 900.0]])


@pytest.mark.parametrize("kind", ["quintic", "cubic"])
def test_passes_through_the_waypoints(kind):
    path = plan_path(WAYPOINTS, kind)
    np.testing.assert_allclose(path.spline(path.knots), WAYPOINTS, atol=1e-9)


def test_quintic_is_natural_and_centripetal():
    path = plan_path(WAYPOINTS, "quintic")
    ends = path.derivatives(path.knots[[0, -1]])
    scale = np.abs(path.derivatives(np.linspace(*path.knots[[0, -1]], 500))).max(axis=(1, 2))
    assert np.abs(ends[3]).max() < 1e-9 * scale[3]
    assert np.abs(ends[4]).max() < 1e-8 * scale[4]
    chords = np.linalg.norm(np.diff(WAYPOINTS, axis=0), axis=1)
    np.testing.assert_allclose(np.diff(path.knots) ** 2, chords)


def test_cubic_has_the_appendix_end_conditions():
    """csape(x, p, [1, 2]): slope of the cubic through the first four points, zero second derivative at the end."""
    path = plan_path(WAYPOINTS, "cubic")
    start, end = path.derivatives(np.array([0.0, len(WAYPOINTS) - 1.0])).transpose(1, 0, 2)
    first_four = np.array([np.polyfit(np.arange(4), WAYPOINTS[:4, axis], 3) for axis in range(2)])
    np.testing.assert_allclose(start[1], first_four[:, 2], rtol=1e-9)
    assert np.abs(end[2]).max() < 1e-9


@pytest.mark.parametrize(("kind", "position_order", "curvature_order"), [("quintic", 6, 4), ("cubic", 4, 2)])
def test_order_of_convergence(kind, position_order, curvature_order):
    """A degree-k spline errs as h^(k+1) in position and h^(k-1) in curvature, away from its end conditions."""
    a, b = 1000.0, 700.0
    position_error, curvature_error = [], []
    counts = np.array([60, 120])
    for n in counts:
        angle = np.linspace(0, 2 * np.pi, n)
        # Even chords keep the centripetal parameter smooth, so the order is the spline's own.
        fine = np.linspace(0, 2 * np.pi, 200_001)
        speed = np.hypot(a * np.sin(fine), b * np.cos(fine))
        arc = np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))])
        angle = np.interp(np.linspace(0, arc[-1], n), arc, fine)
        path = plan_path(np.stack([a * np.cos(angle), b * np.sin(angle)], axis=1), kind)
        u = np.linspace(path.knots[n // 3], path.knots[2 * n // 3], 2001)
        r, r1, r2, *_ = path.derivatives(u)
        curvature = (r1[:, 0] * r2[:, 1] - r1[:, 1] * r2[:, 0]) / np.linalg.norm(r1, axis=1) ** 3
        t = np.arctan2(r[:, 1] / b, r[:, 0] / a)
        exact = a * b / (a**2 * np.sin(t) ** 2 + b**2 * np.cos(t) ** 2) ** 1.5
        position_error.append(np.abs(np.hypot(r[:, 0] / a, r[:, 1] / b) - 1).max())
        curvature_error.append(np.abs(curvature / exact - 1).max())
    orders = [np.log2(e[0] / e[1]) for e in (position_error, curvature_error)]
    print(f"{kind}: order in position {orders[0]:.2f}, in curvature {orders[1]:.2f}")
    assert orders[0] > position_order - 0.4
    assert orders[1] > curvature_order - 0.3


@pytest.mark.parametrize(
    ("waypoints", "words"),
    [
        (WAYPOINTS[:3], "3 waypoints"),
        (WAYPOINTS[[0, 1, 1, 2, 3]], "waypoints 2 and 3"),
        (np.array([[0, 0], [1, 1], [np.nan, 2], [3, 3]]), "waypoint 3"),
    ],
)
def test_refuses(waypoints, words):
    with pytest.raises(DesignError, match=words):
        plan_path(waypoints, "quintic")


def test_a_path_may_cross_itself():
    loop = np.array([[0, 0], [500, 500], [1000, 0], [500, -500], [0, 500], [-800, 600.0]])
    assert plan_path(loop, "quintic").spline(0.0).shape == (2,)
