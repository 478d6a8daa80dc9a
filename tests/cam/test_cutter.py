"""The largest cutter against closed forms, and against discs set on the profile one by one."""

import numpy as np
import pytest

from cadgen.cam.cutter import largest_cutter
from cadgen.curves.closed import left_normal
from cadgen.curves.contour import Contour, circle, keyway_bore
from tests.curves.shapes import ellipse, limacon


def bulge(sweep):
    return np.tan(sweep / 4)


def keyhole(rim, slot, pocket, end):
    """A disc with a slot of half-width `slot` along x that opens into a round pocket at `end`."""
    rim_x, pocket_x = np.sqrt(rim**2 - slot**2), np.sqrt(pocket**2 - slot**2)
    mouth, inner = np.arctan2(slot, rim_x), np.arctan2(slot, pocket_x)
    vertices = np.array([[rim_x, slot], [rim_x, -slot], [end + pocket_x, -slot], [end + pocket_x, slot]])
    return Contour(vertices, np.array([bulge(2 * np.pi - 2 * mouth), 0.0, -bulge(2 * np.pi - 2 * inner), 0.0]))


@pytest.mark.parametrize("curve", [circle((9.0, 0.0), 30.0).curve(), ellipse(40.0, 25.0)], ids=["circle", "ellipse"])
def test_a_convex_curve_takes_every_cutter(curve):
    limit = largest_cutter(curve)
    assert (limit.kind, limit.radius, limit.point) == ("none", np.inf, None)


@pytest.mark.parametrize(("b", "a"), [(20.0, 13.0), (20.0, 10.5), (20.0, 17.0)])
def test_a_dent_takes_its_own_radius_of_curvature(b, a):
    limit = largest_cutter(limacon(b, a))
    assert limit.kind == "local"
    assert limit.radius == pytest.approx((b - a) ** 2 / (2 * a - b), rel=1e-7)
    assert limit.point == pytest.approx([a - b, 0.0], abs=1e-2)


def test_a_slot_takes_half_its_width_though_its_end_is_wider():
    limit = largest_cutter(keyhole(rim=20.0, slot=1.2, pocket=3.0, end=8.0).curve())
    assert limit.kind == "global"
    assert limit.radius == pytest.approx(1.2, abs=1e-6)
    assert abs(limit.point[1]) == pytest.approx(1.2, abs=2e-3)


def test_a_mouth_between_two_corners_takes_half_its_width():
    # Two arcs that meet in two convex corners: no tangents of the pieces face each other across the mouth.
    half = 1.5
    rim, pocket = 20.0, 4.0
    x = np.sqrt(rim**2 - half**2)
    vertices = np.array([[x, half], [x, -half]])
    outer = 2 * np.pi - 2 * np.arctan2(half, x)
    inner = 2 * np.pi - 2 * np.arcsin(half / pocket)
    limit = largest_cutter(Contour(vertices, np.array([bulge(outer), -bulge(inner)])).curve())
    assert limit.kind == "global"
    assert limit.radius == pytest.approx(half, abs=1e-6)
    assert np.abs(limit.point) == pytest.approx([x, half], abs=2e-3)


def test_a_hollow_corner_takes_none():
    limit = largest_cutter(keyway_bore(20.0, 6.0, 3.0, 0.0).curve())
    assert (limit.kind, limit.radius) == ("corner", 0.0)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
def test_discs_of_that_size_overlap_nothing_and_larger_ones_do(name, request):
    curve = request.getfixturevalue(name).actual.curve
    limit = largest_cutter(curve)
    print(f"{name}: cutter radius up to {limit.radius:.4f} mm ({limit.kind})")
    points = curve.outline(0.02).points

    def clearance(radius, step):
        """Least gap between the outline and discs set against it every `step` mm."""
        jets = [piece.jet(t) for piece, t in zip(curve.pieces, curve.parameters(step), strict=True)]
        centres = np.concatenate([jet.point - radius * left_normal(jet.velocity) for jet in jets])
        near = np.linalg.norm(centres - limit.point, axis=1) < radius + 1.0
        return min(np.linalg.norm(points - c, axis=1).min() - radius for c in centres[near | (step > 0.5)])

    assert clearance(limit.radius * 0.999, 1.0) > -1e-9
    assert clearance(limit.radius * 0.999, 0.1) > -1e-9
    assert clearance(limit.radius * 1.001, 0.1) < -1e-9
