"""Closed curves: looking up by polar angle, and beginning elsewhere."""

import numpy as np
import pytest

from cadgen.curves.contour import circle
from tests.curves.shapes import TURN, ellipse, lens


def test_radius_and_curvature_by_polar_angle():
    a, b = 40.0, 25.0
    curve = ellipse(a, b, starts=(0.5, 2.0, 5.0))
    angle = np.linspace(-1.0, 8.0, 500)
    jet, owner = curve.at_angle(angle)
    radius = a * b / np.hypot(b * np.cos(angle), a * np.sin(angle))
    assert curve.radius(angle) == pytest.approx(radius, rel=1e-12)
    assert (np.arctan2(jet.point[:, 1], jet.point[:, 0]) - angle + np.pi) % TURN == pytest.approx(np.pi, abs=1e-12)
    # Curvature by the support of the point: (a b)^-2 (x^2 / a^4 + y^2 / b^4)^(-3/2).
    x, y = jet.point.T
    assert jet.curvature == pytest.approx((x**2 / a**4 + y**2 / b**4) ** -1.5 / (a * b) ** 2, rel=1e-10)
    eccentric = np.arctan2(a * np.sin(angle), b * np.cos(angle)) % TURN
    assert np.array_equal(owner, np.searchsorted([0.5, 2.0, 5.0], eccentric) - 1 + 3 * (eccentric < 0.5))


def test_a_curve_begun_elsewhere_is_the_same_curve():
    curve = lens(50.0, 0.6).curve()
    moved = curve.begun_at(1, 0.25)
    assert len(moved.pieces) == 3
    assert moved.area() == pytest.approx(curve.area(), rel=1e-14)
    assert len(moved.corners()) == 2
    first = moved.pieces[0].jet(np.array([moved.pieces[0].start])).point
    assert first == pytest.approx(curve.pieces[1].jet(np.array([0.25])).point)
    assert len(curve.begun_at(1, 0.0).pieces) == 2


def test_outline_points_are_no_further_apart_than_asked():
    outline = circle((1.0, 0.0), 9.0).curve().outline(0.1)
    gaps = np.linalg.norm(np.diff(outline.points, axis=0), axis=1)
    assert gaps.max() <= 0.1
    assert outline.angle[-1] - outline.angle[0] == pytest.approx(TURN, abs=1e-12)
