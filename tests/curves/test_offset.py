"""The parallel curve against Steiner's formula, circles and closed-form hollows."""

import re

import numpy as np
import pytest

from cadgen.curves.contour import circle, keyway_bore
from cadgen.curves.derived import OffsetPiece, parallel
from cadgen.errors import CheckError
from tests.curves.shapes import ellipse, lens, limacon, off_ellipse


def length(curve):
    points = curve.outline(0.002).points
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


@pytest.mark.parametrize("curve", [ellipse(40.0, 25.0), lens(50.0, 0.6).curve()], ids=["ellipse", "lens"])
def test_area_and_length_grow_by_steiners_formula(curve):
    distance = 3.0
    outside = parallel(curve, distance)
    assert outside.area() == pytest.approx(curve.area() + length(curve) * distance + np.pi * distance**2, rel=1e-8)
    assert length(outside) == pytest.approx(length(curve) + 2 * np.pi * distance, rel=1e-8)
    assert not outside.corners()


def test_a_circle_stays_a_circle():
    outside = parallel(circle((2.0, 1.0), 10.0).curve(), 1.5)
    assert np.hypot(*(outside.outline(0.1).points - [2.0, 1.0]).T) == pytest.approx(11.5, abs=1e-12)


def test_every_point_keeps_its_distance():
    points = parallel(ellipse(40.0, 25.0), 1e-3).outline(0.05).points
    assert off_ellipse(points, 40.0, 25.0) == pytest.approx(1e-3, rel=1e-4)


@pytest.mark.parametrize("number", [0, 1])
def test_jets_agree_with_differences(number):
    piece = parallel(lens(50.0, 0.6).curve(), 2.0).pieces[number]
    t = np.linspace(piece.start, piece.stop, 9)[1:-1]
    h = 1e-5 * (piece.stop - piece.start)
    before, at, after = piece.jet(t - h), piece.jet(t), piece.jet(t + h)
    velocity = (after.point - before.point) / (2 * h)
    assert at.velocity == pytest.approx(velocity, rel=1e-6, abs=1e-6)
    heading = [np.arctan2(jet.velocity[:, 1], jet.velocity[:, 0]) for jet in (before, after)]
    turn = (heading[1] - heading[0] + np.pi) % (2 * np.pi) - np.pi
    assert at.curvature == pytest.approx(turn / (2 * h) / np.linalg.norm(velocity, axis=1), rel=1e-5)


def test_a_hollow_takes_no_larger_cutter_than_its_own_radius():
    b, a = 20.0, 13.0
    radius = (b - a) ** 2 / (2 * a - b)
    parallel(limacon(b, a), radius * 0.999)
    with pytest.raises(CheckError, match=re.escape(f"less than {radius:.3f} mm")) as refused:
        parallel(limacon(b, a), radius * 1.001)
    assert "polar angle 180.00 degrees" in str(refused.value)


def test_a_hollow_corner_is_refused_with_its_place():
    with pytest.raises(CheckError, match=r"hollow corner of \d+\.\d\d degrees at polar angle"):
        parallel(keyway_bore(20.0, 6.0, 3.0, 0.0).curve(), 0.5)


def test_a_parallel_through_the_centre_of_curvature_keeps_its_direction():
    """The parallel of a circle at its own radius is a point, at which each direction is that of the circle."""
    point = OffsetPiece(circle((0.0, 0.0), 4.0).curve().pieces[0], -4.0)
    t = np.linspace(point.start, point.stop, 9)
    assert np.abs(point.jet(t).point).max() < 1e-12
    out = OffsetPiece(point, 1.0).jet(t)
    assert np.abs(np.linalg.norm(out.point, axis=1) - 1).max() < 1e-12
    assert np.isfinite(out.curvature).all()
