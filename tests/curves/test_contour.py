"""Chains of lines and arcs against elementary geometry."""

import numpy as np
import pytest

from cadgen.curves.contour import Contour, circle, d_bore, keyway_bore
from cadgen.errors import DesignError


def test_circle_is_the_circle():
    ring = circle((3.0, -2.0), 5.0)
    assert ring.is_circle
    assert np.allclose(ring.centers, [3.0, -2.0])
    assert np.allclose(ring.radii, 5.0)
    assert ring.area() == pytest.approx(25 * np.pi, rel=1e-14)
    assert ring.lengths.sum() == pytest.approx(10 * np.pi, rel=1e-14)
    points = ring.outline(0.1).points
    assert np.abs(np.hypot(*(points - [3.0, -2.0]).T) - 5.0).max() < 1e-13
    assert np.all(np.diff(np.unwrap(np.arctan2(*(points - [3.0, -2.0]).T[::-1]))) > -1e-12)


@pytest.mark.parametrize("sweep", [-5.5, -1.0, -1e-7, 1e-9, 0.3, np.pi, 6.0])
def test_a_side_turns_about_its_centre_at_its_radius(sweep):
    radius, start, center = 2.5, 0.7, np.array([1.0, 4.0])
    # Positive sweep: counterclockwise about the centre.
    angle = start + np.linspace(0, sweep, 9)
    arc = center + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    chain = Contour(arc[[0, -1]], np.array([np.tan(sweep / 4), 0.0]))
    size = abs(sweep) * radius
    assert chain.sweeps[0] == pytest.approx(sweep, rel=1e-12)
    assert np.abs(chain.middles[0] - arc[4]).max() < 1e-14
    assert np.abs(chain.outline(radius * abs(sweep) / 8 * 1.0001).points[:9] - arc).max() < 1e-14
    assert chain.lengths[0] == pytest.approx(size, rel=1e-6)
    if abs(sweep) > 0.1:
        assert np.abs(chain.centers[0] - center).max() < 1e-12
        assert chain.radii[0] == pytest.approx(radius, rel=1e-12)


def test_keyway_bore_has_its_floor_walls_and_area():
    diameter, width, depth, angle = 8.0, 3.0, 1.4, np.radians(30)
    bore = keyway_bore(diameter, width, depth, angle)
    back = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    points = bore.outline(0.01).points @ back
    assert points[:, 0].max() == pytest.approx(4.0 + depth, abs=1e-12)
    floor = points[points[:, 0] > 4.1]
    assert [floor[:, 1].min(), floor[:, 1].max()] == pytest.approx([-1.5, 1.5], abs=1e-12)
    # Circle and slot, less the segment of the circle that the slot swallows.
    half = np.arcsin(1.5 / 4)
    overlap = 16 * half + 1.5 * 4 * np.cos(half)
    assert bore.area() == pytest.approx(16 * np.pi + 3 * (4 + depth) - overlap, rel=1e-12)


@pytest.mark.parametrize("flat_depth", [0.5, 4.0, 6.0])
def test_d_bore_is_the_circle_less_its_segment(flat_depth):
    bore = d_bore(8.0, flat_depth, np.radians(90))
    assert bore.outline(0.01).points[:, 1].max() == pytest.approx(4.0 - flat_depth, abs=1e-12)
    half = np.arccos((4 - flat_depth) / 4)
    assert bore.area() == pytest.approx(16 * np.pi - 16 * (half - np.sin(half) * np.cos(half)), rel=1e-12)
    assert np.abs(np.linalg.norm(bore.vertices, axis=1) - 4).max() < 1e-12


@pytest.mark.parametrize("tolerance", [0.1, 0.005, 3.0])
def test_polygon_keeps_its_tolerance(tolerance):
    bore = keyway_bore(8.0, 3.0, 1.4, 0.2)
    polygon = bore.polygon(tolerance)
    edges = np.roll(polygon, -1, axis=0) - polygon
    dense = bore.outline(0.002).points
    normal = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.linalg.norm(edges, axis=1)[:, None]
    along = np.einsum("pej,ej->pe", dense[:, None] - polygon, edges) / np.sum(edges**2, axis=1)
    across = np.abs(np.einsum("pej,ej->pe", dense[:, None] - polygon, normal))
    off = np.where((along > -1e-9) & (along < 1 + 1e-9), across, np.inf).min(axis=1)
    assert off.max() < tolerance * (1 + 1e-9)
    if tolerance < 1:
        assert off.max() > 0.7 * tolerance


@pytest.mark.parametrize(
    ("make", "key"),
    [
        (lambda: keyway_bore(8.0, 8.0, 1.0, 0.0), "width_mm is 8"),
        (lambda: keyway_bore(8.0, 3.0, 0.0, 0.0), "depth_mm is 0"),
        (lambda: d_bore(8.0, 8.0, 0.0), "8 mm inside the bore"),
    ],
)
def test_impossible_bores_are_refused(make, key):
    with pytest.raises(DesignError, match=key):
        make()
