"""The curve inside an outline and the chamfer between, against closed forms and brute distances."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from cadgen.curves.chamfer import Apex, chamfer_strips, chamfered_off, inner_curve
from cadgen.curves.contour import Contour, circle
from cadgen.curves.polygon import strip_polygons
from cadgen.curves.spline import ruled_splines
from cadgen.errors import CheckError

SQUARE = [[-10, -10], [10, -10], [10, 10], [-10, 10]]
HOOK = [[-10, -10], [10, -10], [10, 2], [2, 2], [2, 10], [-10, 10]]
# The corner cut off is shorter than what the chamfers of its neighbours take.
CUT_CORNER = [[-10, -10], [10, -10], [10, 9.8], [9.8, 10], [-10, 10]]


def polygon(corners):
    return Contour(np.array(corners, dtype=float), np.zeros(len(corners))).curve()


def distance(points, curve, step=0.005):
    """Distance of points from the chords of a curve, shape (n,)."""
    corners = curve.outline(step).points
    nearest = cKDTree(corners).query(points)[1]
    found = np.full(len(points), np.inf)
    for first in (nearest + k for k in (-2, -1, 0, 1)):  # a joint stands twice
        start, chord = (
            corners[first % len(corners)],
            corners[(first + 1) % len(corners)] - corners[first % len(corners)],
        )
        share = np.sum((points - start) * chord, axis=1) / np.maximum(np.sum(chord**2, axis=1), 1e-30)
        found = np.minimum(found, np.linalg.norm(points - start - np.clip(share, 0, 1)[:, None] * chord, axis=1))
    return found


def hook_left(d):
    """Area of the hook moved in by d: two rectangles, and at the hollow corner a square less its quarter circle."""
    return (20 - 2 * d) * (12 - 2 * d) + (12 - 2 * d) * 8 + (1 - np.pi / 4) * d**2


@pytest.mark.parametrize(
    ("curve", "left"),
    [
        (polygon(SQUARE), lambda d: (20 - 2 * d) ** 2),
        (circle((1.0, 2.0), 30.0).curve(), lambda d: np.pi * (30 - d) ** 2),
        (polygon(HOOK), hook_left),
        # Without the corner that is left once the cut is gone: a square's.
        (polygon(CUT_CORNER), lambda d: (20 - 2 * d) ** 2 if d > 0.4 else np.nan),
    ],
    ids=["square", "circle", "hook", "cut corner"],
)
def test_areas_in_closed_form(curve, left):
    strips = chamfer_strips(curve, 0.5)
    assert inner_curve(strips).area() == pytest.approx(left(0.5), rel=1e-12)
    if np.isfinite(left(0.1)):
        depth = np.linspace(0.0, 0.5, 10_001)
        by_slices = left(0.0) * 0.5 - np.trapezoid([left(d) for d in depth], depth)
        assert chamfered_off(curve, 0.5) == pytest.approx(by_slices, rel=1e-7)


def test_a_piece_that_is_swallowed_comes_to_a_point():
    strips = chamfer_strips(polygon(CUT_CORNER), 0.5)
    (swallowed,) = [strip for strip in strips if isinstance(strip.inner, Apex)]
    np.testing.assert_allclose(swallowed.inner.point, [9.5, 9.5], atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
@pytest.mark.parametrize("leg", [0.1, 1.0])
def test_the_curve_inside_keeps_its_distance(name, leg, request):
    curve = request.getfixturevalue(name).actual.curve
    strips = chamfer_strips(curve, leg)
    inside = inner_curve(strips)
    points = inside.outline(0.7).points
    off = np.abs(distance(points, curve) - leg).max()
    print(f"{name}, leg {leg}: {off * 1e3:.4f} um off")
    assert off < 5e-6
    # The volume by Steiner's formula, against Simpson's rule on the areas of three exact curves.
    areas = [curve.area(), inner_curve(chamfer_strips(curve, leg / 2)).area(), inside.area()]
    slices = leg * areas[0] - leg / 6 * (areas[0] + 4 * areas[1] + areas[2])
    assert chamfered_off(curve, leg) == pytest.approx(slices, rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("leg", [0.1, 0.5])
def test_both_sides_as_splines_and_chords(appendix_car, leg):
    """17 degrees of corner, and lines between equal parameters that stay a chamfer."""
    curve = appendix_car.actual.curve
    strips = chamfer_strips(curve, leg)
    pairs = ruled_splines(strips, 1e-5, 5)
    for side, of in ((0, curve), (1, inner_curve(strips))):
        ends = np.array([pair[side].control_points[[0, -1]] for pair in pairs])
        assert np.array_equal(ends[:, 1], np.roll(ends[:, 0], -1, axis=0))
        points = np.concatenate([pair[side].point(np.linspace(*pair[side].knots[[0, -1]], 50)) for pair in pairs])
        assert distance(points, of).max() < 1.3e-5
    middle = np.concatenate(
        [(a.point(u) + b.point(u)) / 2 for a, b in pairs for u in [np.linspace(*a.knots[[0, -1]], 50)]]
    )
    half = np.abs(distance(middle, curve) - leg / 2).max()
    print(f"leg {leg}: {half * 1e3:.3f} um off the true chamfer, halfway")
    assert half < 0.05e-3
    outer, inner = strip_polygons(strips, 1e-3)
    assert outer.shape == inner.shape
    legs = np.linalg.norm(outer - inner, axis=1)
    assert legs.min() > leg * (1 - 1e-6)
    assert legs.max() < leg / np.cos(np.radians(18) / 2)


def test_a_ridge_sharper_than_the_leg_is_refused():
    with pytest.raises(CheckError, match=r"edge_break_mm is 0\.6, but the outline is convex with a radius of 0\.5"):
        chamfer_strips(circle((0.0, 0.0), 0.5).curve(), 0.6)


def test_chamfers_that_meet_are_refused():
    with pytest.raises(CheckError, match="so narrow somewhere that its chamfers meet"):
        chamfer_strips(polygon([[-10, -0.4], [10, -0.4], [10, 0.4], [-10, 0.4]]), 0.5)
