"""Chord polygons against the sagitta of a circle and an implicit equation."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen.curves.contour import circle
from cadgen.curves.polygon import polygon
from tests.curves.shapes import TURN, ellipse, lens, off_ellipse


def chord_errors(points, a, b):
    """Largest distance of each chord from the ellipse."""
    following = np.roll(points, -1, axis=0)
    share = np.linspace(0, 1, 33)[:, None, None]
    along = points + share * (following - points)
    return np.abs(off_ellipse(along.reshape(-1, 2), a, b).reshape(33, -1)).max(axis=0)


@settings(max_examples=15, deadline=None)
@given(b=st.floats(10.0, 80.0), exponent=st.floats(-4.0, -1.0))
def test_no_chord_strays_further_than_allowed_and_most_come_close(b, exponent):
    tolerance = 10**exponent
    errors = chord_errors(polygon(ellipse(40.0, b), tolerance), 40.0, b)
    assert errors.max() <= tolerance
    assert np.median(errors) > 0.6 * tolerance


@pytest.mark.parametrize("tolerance", [1e-3, 5e-3, 0.1])
def test_a_circle_gets_the_fewest_chords(tolerance):
    count = len(polygon(circle((5.0, 0.0), 60.0).curve(), tolerance))
    fewest = np.pi / np.arccos(1 - tolerance / 60.0)
    assert fewest <= count <= 1.06 * fewest + 2


def test_the_error_is_of_second_order():
    counts = [len(polygon(ellipse(70.0, 50.0), tolerance)) for tolerance in (1e-2, 1e-6)]
    assert np.log(1e4) / np.log(counts[1] / counts[0]) == pytest.approx(2, rel=0.02)


def test_corners_and_hollows_are_kept(carbon_free_car):
    curve = carbon_free_car.actual.curve
    points = polygon(curve, 5e-3)
    for corner in curve.corners():
        assert np.any(np.all(points == corner.point, axis=1))
    # Chords of a hollow lie outside, chords of a bulge inside; both keep the tolerance along the radius too.
    following = np.roll(points, -1, axis=0)
    middles = (points + following) / 2
    gap = curve.radius(np.arctan2(middles[:, 1], middles[:, 0])) - np.linalg.norm(middles, axis=1)
    assert gap.min() < -3e-3
    assert gap.max() > 3e-3
    assert np.abs(gap).max() < 5e-3 / np.cos(np.radians(30))
    turned = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    assert np.all(np.diff(turned) > 0)
    assert turned[-1] - turned[0] < TURN


def test_two_corners_of_a_lens_stand_once():
    points = polygon(lens(50.0, 0.6).curve(), 1e-2)
    assert len(np.unique(points.round(9), axis=0)) == len(points)
