"""Conjugate pairs: two discs on one shaft that hold both rollers of a slide or of a lever without play."""

import json
import re

import numpy as np
import pytest
from build123d import GeomType, import_step

from cadgen import Design
from cadgen.arrays import TURN
from cadgen.errors import DesignError
from tests.cam.test_kinds import DATA

SLIDE = """
name = "yoke"
[motion]
turns = "clockwise"
segments = [
    { rise_mm = 20.0, in_deg = 120.0, law = "polynomial_3_4_5" },
    { dwell_deg = 40.0 },
    { rise_mm = -20.0, in_deg = 140.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
]
[follower]
kind = "roller"
radius_mm = 9.0
closure = "conjugate"
[follower.second]
radius_mm = 9.0
span_mm = 110.0
[cam]
base_circle_radius_mm = 38.0
thickness_mm = 10.0
"""
ARM = "arm_mm = 72.0\ncentre_distance_mm = 95.0"
LEVER = (
    SLIDE.replace("rise_mm = 20.0", "rise_deg = 15.0")
    .replace("rise_mm = -20.0", "rise_deg = -15.0")
    .replace(
        '"roller"\nradius_mm = 9.0', '"swinging_roller"\nradius_mm = 9.0\narm_mm = 72.0\ncentre_distance_mm = 95.0'
    )
    .replace("closure", 'lifts = "against"\nclosure')
    .replace("span_mm = 110.0", "arm_mm = 70.0\nangle_deg = 80.0")
    .replace("= 38.0", "= 45.0")
)


def test_a_pair_on_a_slide_has_its_printed_figures():
    expected = json.loads((DATA / "h26_conjugate_yoke.json").read_text())["expected"]
    cam = Design.from_toml(SLIDE).cam()
    assert cam.passed
    figures = {check.code: check.value for check in cam.checks}
    for disc, prefix, printed in (
        (cam.computed, "", expected),
        (cam.computed.second, "second-", expected["second_disc"]),
    ):
        angle = printed["pressure_angle_deg"]
        assert figures[f"{prefix}pressure-angle-greatest"] == pytest.approx(angle["max"], abs=1e-3)
        assert figures[f"{prefix}pressure-angle-least"] == pytest.approx(angle["min"], abs=1e-3)
        theory, profile = printed["pitch_least_convex_radius_mm"], printed["profile_least_convex_radius_mm"]
        assert figures[f"{prefix}convex-radius-theory"] == pytest.approx(theory, abs=1e-4)
        assert figures[f"{prefix}convex-radius-profile"] == pytest.approx(profile, abs=1e-4)
        assert disc.area == pytest.approx(printed["area_mm2"], abs=1e-4)
        radii = np.linalg.norm(disc.curve.outline(0.02).points, axis=1)
        sizes = printed["disc_radius_mm"]
        assert [radii.min(), radii.max()] == pytest.approx([sizes["least"], sizes["greatest"]], abs=1e-4)


def slide_lift(points, theta, radius, offset):
    """Distance from the camshaft, along its line, of a roller that is let down on a disc turned back by theta, mm."""
    p = points * np.exp(-1j * theta)
    under = np.abs(p.imag - offset) < radius
    return (p.real[under] + np.sqrt(radius**2 - (p.imag[under] - offset) ** 2)).max()


def arm_angle(points, theta, c, arm, radius, sense):
    """Angle at the pivot from the camshaft to an arm whose roller is let down on a disc turned back by theta, rad."""
    d = c - points * np.exp(-1j * theta)
    d = d if sense > 0 else d.conj()
    near = np.abs(np.abs(d) - arm) < radius
    R = np.abs(d[near])
    return (np.angle(d[near]) + np.arccos((arm**2 + R**2 - radius**2) / (2 * arm * R))).max()


@pytest.mark.parametrize(("first", "second"), [(0.0, 0.0), (6.0, 0.0), (6.0, -4.0)])
def test_both_rollers_of_a_slide_touch(first, second):
    """Their centres keep the span at every cam angle, whatever the offsets."""
    design = Design.from_toml(SLIDE).with_({"follower.offset_mm": first, "follower.second.offset_mm": second})
    cam = design.cam().computed
    discs = [disc.curve.outline(0.004).points @ [1, 1j] for disc in cam.discs]
    spans = [
        slide_lift(discs[0], theta, 9.0, first) + slide_lift(discs[1], theta + np.pi, 9.0, -second)
        for theta in np.linspace(0.0, TURN, 24) + 0.01
    ]
    print(f"span off by {1e3 * np.abs(np.array(spans) - 110.0).max():.6f} um")
    assert np.abs(np.array(spans) - 110.0).max() < 1e-6


@pytest.mark.parametrize(("lifts", "sense"), [("against", 1), ("with", -1)])
def test_both_rollers_of_a_lever_touch(lifts, sense):
    """Their arms keep the angle at every cam angle."""
    cam = Design.from_toml(LEVER).with_({"follower.lifts": lifts}).cam()
    assert cam.passed
    discs = [disc.curve.outline(0.004).points @ [1, 1j] for disc in cam.computed.discs]
    angles = [
        arm_angle(discs[0], theta, 95.0, 72.0, 9.0, sense) + arm_angle(discs[1], theta, 95.0, 70.0, 9.0, -sense)
        for theta in np.linspace(0.0, TURN, 24) + 0.01
    ]
    off = 72.0 * np.abs(np.array(angles) - np.radians(80.0)).max()
    print(f"arms off by {1e3 * off:.6f} um")
    assert off < 1e-6


def outline_of_step(path):
    """Points of the outline of a disc from its STEP file, read by the CAD kernel."""
    face = max(import_step(path).faces(), key=lambda each: each.center().Z)
    edges = face.outer_wire().edges()
    assert all(edge.geom_type != GeomType.LINE for edge in edges)
    count = 40_000 // len(edges)
    return np.array(
        [complex(edge.position_at(u).X, edge.position_at(u).Y) for edge in edges for u in np.linspace(0.0, 1.0, count)]
    )


@pytest.mark.slow
@pytest.mark.long
def test_both_rollers_touch_on_the_discs_of_the_files(tmp_path):
    """From the two STEP files, within 0.1 um over the turn."""
    design = Design.from_toml(SLIDE).with_({"follower.offset_mm": 6.0, "blank.keyway": {"width_mm": 2, "depth_mm": 1}})
    written = design.cam().write(tmp_path)
    assert len(written.files) == 16
    discs = [outline_of_step(tmp_path / f"yoke{part}_actual.step") for part in ("", "_second")]
    spans = [
        slide_lift(discs[0], theta, 9.0, 6.0) + slide_lift(discs[1], theta + np.pi, 9.0, 0.0)
        for theta in np.linspace(0.0, TURN, 48) + 0.01
    ]
    off = np.abs(np.array(spans) - 110.0).max()
    print(f"span off by {1e3 * off:.4f} um")
    assert off < 1e-4


BAD = [
    (SLIDE, {"follower.second.span_mm": 70.0}, "raise follower.second.span_mm", {"follower.second.span_mm": 90.0}),
    (SLIDE, {"follower.second.span_mm": 50.0}, "set it to 103 or more", {"follower.second.span_mm": 103.0}),
    (LEVER, {"follower.second.angle_deg": 30.0}, "with an angle of more than 34", {"follower.second.angle_deg": 80.0}),
    (LEVER, {"follower.second.radius_mm": 70.0}, "would cover it", {"follower.second.radius_mm": 9.0}),
]  # fmt: skip


@pytest.mark.parametrize(("text", "change", "words", "cure"), BAD)
def test_a_second_disc_with_nothing_left_is_refused(text, change, words, cure):
    design = Design.from_toml(text)
    with pytest.raises(DesignError, match=re.escape(words)):
        design.with_(change).cam()
    design.with_(change | cure).cam()


def test_closure_and_its_keys_go_together():
    without = SLIDE.replace('closure = "conjugate"\n', "")
    with pytest.raises(DesignError, match=r'set follower.closure = "conjugate", or remove it'):
        Design.from_toml(without)
    alone = SLIDE.replace("[follower.second]\nradius_mm = 9.0\nspan_mm = 110.0\n", "")
    with pytest.raises(DesignError, match=r"needs a second roller: add \[follower.second\] with its keys"):
        Design.from_toml(alone)
    assert Design.from_toml(alone.replace("conjugate", "spring")).cam().computed.second is None


def test_the_second_disc_names_the_roller_that_stands_on_its_ray():
    """On a slide it is the first one: the second roller stands opposite to the ray, half a turn away."""
    second = Design.from_toml(SLIDE).cam().second
    assert second.follower.on_ray == "first roller"
    assert second.curve.radius(np.array([np.pi]))[0] > second.curve.radius(np.array([0.0]))[0]
