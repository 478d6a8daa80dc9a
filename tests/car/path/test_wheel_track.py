"""The drive wheel's track against closed forms, and its jets against each other."""

import numpy as np
import pytest
from scipy.interpolate import BSpline

from cadgen.car.path.spline import PlannedPath, plan_path
from cadgen.car.path.wheel_track import offset_track
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError

FOCUS = 400.0


def parabola(width: float = 1000.0) -> PlannedPath:
    """y = x^2 / (4 f) over [0, width] as one exact Bezier span."""
    knots = np.concatenate([np.zeros(3), np.ones(3)])
    control = np.array([[0, 0], [width / 2, 0], [width, width**2 / (4 * FOCUS)]])
    return PlannedPath(np.array([0.0, 1.0]), BSpline(knots, control, 2), smooth=True)


def parabola_arc(x: np.ndarray) -> np.ndarray:
    """Arc length of y = x^2 / (4 f) from its vertex."""
    p = 2 * FOCUS
    return (x * np.sqrt(p**2 + x**2) / p + p * np.arcsinh(x / p)) / 2


@pytest.mark.parametrize("offset", [0.0, 117.5, -60.0])
def test_offset_of_a_parabola(offset):
    """An offset curve is shorter by offset times the angle turned; its curvature is k / (1 - m k)."""
    track = offset_track(parabola(), offset)
    x = track.planned(track.arc)[:, 0]
    turned = np.arctan(x / (2 * FOCUS))
    np.testing.assert_allclose(track.arc, parabola_arc(x) - offset * turned, atol=1e-9)
    k = 1 / (2 * FOCUS) / (1 + (x / (2 * FOCUS)) ** 2) ** 1.5
    np.testing.assert_allclose(track.curvature_jets[:, 0], k / (1 - offset * k), rtol=1e-10)
    np.testing.assert_allclose(track.heading(track.arc), turned, atol=1e-10)


def test_jets_are_derivatives_of_one_another(carbon_free_car):
    track = carbon_free_car.track
    curve = quintic_hermite(track.arc, track.curvature_jets)
    inside = np.setdiff1d(np.arange(1, len(track.arc) - 1), np.flatnonzero(np.diff(track.arc) < 1e-9))
    s = track.arc[inside]
    step = 1e-2
    for order in (1, 2):
        numeric = (curve(s + step, nu=order - 1) - curve(s - step, nu=order - 1)) / (2 * step)
        scale = np.abs(track.curvature_jets[:, order]).max()
        np.testing.assert_allclose(numeric, track.curvature_jets[inside, order], atol=1e-4 * scale)


def test_curvature_is_the_rate_of_heading(carbon_free_car):
    track = carbon_free_car.track
    s = np.linspace(0, track.length, 20_001)
    middle = (s[1:] + s[:-1]) / 2
    rate = np.diff(track.heading(s)) / np.diff(s)
    exact = quintic_hermite(track.arc, track.curvature_jets)(middle)
    np.testing.assert_allclose(rate, exact, atol=2e-8)


def test_arc_length_of_the_reference_car(appendix_car):
    """18 033.41 mm by the reference's own note on exact arc length."""
    print(f"length {appendix_car.track.length:.3f} mm")
    assert abs(appendix_car.track.length - 18033.41) < 0.01


def test_cusp_is_refused_with_its_place():
    tight = np.array([[0, 0], [500, 0], [600, 60], [500, 120], [0, 120.0]])
    with pytest.raises(DesignError, match=r"cusp.*through a wider turn \(path\.waypoints_mm\)") as caught:
        offset_track(plan_path(tight, "quintic"), 117.5)
    assert "between waypoints" in str(caught.value)


def test_a_cusp_on_the_other_side_is_told_with_lengths_above_zero():
    tight = np.array([[0, 0], [500, 0], [600, -60], [500, -120], [0, -120.0]])
    with pytest.raises(DesignError, match=r"turns right with a radius of \d.* runs 117.5 mm inside it"):
        offset_track(plan_path(tight, "quintic"), -117.5)
