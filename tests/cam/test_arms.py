"""Followers on an arm: least base circles against a search, grooves, and what a refusal proposes, put in."""

import re
from dataclasses import replace
from math import atan2, cos, degrees, inf, radians, sin

import numpy as np
import pytest

from cadgen import Design
from cadgen.arrays import TURN
from cadgen.cam.contact import roll_curve
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.roller import Knife
from cadgen.cam.followers.swinging_flat import SwingingFace
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, CheckLimits, PressureAngleLimit
from cadgen.errors import DesignError
from cadgen.laws.unit import MM, RAD
from tests.cam.test_kinds import DESIGNS, motion

MOTION = motion(RAD, ((90, 16.0, "modified_sine"), (50, 16.0, None), (120, 0.0, "cycloidal"), (100, 0.0, None)))
JUMPING = motion(
    RAD, ((90, 16.0, "constant_acceleration"), (50, 16.0, None), (120, 0.0, "simple_harmonic"), (100, 0, None))
)
RISE, FALL = radians(30), radians(40)


def angles_and_radii(follower, moved):
    """Pressure angle, rad, and radius of the profile, mm, from the places of circle or line by differences."""
    seams = np.radians([0, 45, 90, 140, 260])
    theta = np.concatenate([np.linspace(0, TURN, 3601), seams + 1e-6, seams - 1e-6])
    jets = moved.jets(theta)
    q, v, a = jets[:, 0], jets[:, 1], jets[:, 2]
    c, side = follower.centre_distance, follower.lifts.side
    if isinstance(follower, SwingingRoller):
        z = c - follower.arm * np.exp(1j * side * (follower.rest + q))
        way = -1j * side * follower.arm * np.exp(1j * side * (follower.rest + q))
        path = way * v + 1j * z
        along = path.conj() * way
        return v, np.arctan2(np.abs(along.real), np.abs(along.imag)), np.full(len(q), inf)
    step, found = 1e-4, []
    for t in (-step, 0.0, step):
        delta = follower.rest + q + v * t + a * t**2 / 2
        found.append((side * delta + t, c * np.sin(delta) - follower.face_offset))
    (p0, h0), (p1, h1), (p2, h2) = found
    bend = ((h2 - h1) / (p2 - p1) - (h1 - h0) / (p1 - p0)) / ((p2 - p0) / 2)
    lever = c * np.cos(follower.rest + q) / (1 + side * v)
    covered = np.hypot(h1, c * np.cos(follower.rest + q) - lever) >= c  # the disc would reach the pivot
    return v, np.abs(np.arctan2(follower.face_offset, lever)), np.where(covered, -inf, h1 + bend)


def keeps(follower, moved, convex):
    velocity, angle, radius = angles_and_radii(follower, moved)
    return bool((angle <= np.where(velocity >= 0, RISE, FALL) + 1e-7).all() and radius.min() >= convex - 2e-3)


@pytest.mark.parametrize("lifts", list(Lifts))
@pytest.mark.parametrize(
    "arm",
    [
        SwingingRoller(base=30, radius=8, arm=72, centre_distance=88, lifts=Lifts.WITH),
        SwingingRoller(base=30, radius=6, arm=95, centre_distance=100, lifts=Lifts.WITH),
        SwingingFace(base=55, face_offset=10, centre_distance=120, lifts=Lifts.WITH),
        SwingingFace(base=60, face_offset=-8, centre_distance=120, lifts=Lifts.WITH),
    ],
    ids=["roller", "long roller", "flat", "flat behind"],
)
@pytest.mark.parametrize("moved", [MOTION, JUMPING], ids=["smooth", "jumping"])
def test_no_smaller_base_circle_keeps_the_limits(arm, lifts, moved):
    """All base circles are tried from 1 mm on: the least that keeps the limits by definition is the one found."""
    follower = replace(arm, lifts=lifts)
    faced = isinstance(follower, SwingingFace)
    found = follower.least_base(moved, RISE, FALL, 0.5) if faced else follower.least_base(moved, RISE, FALL)
    tried = [
        base
        for base in np.arange(1.0, 115.0, 1.0)
        if (not faced or base + follower.face_offset < follower.centre_distance * cos(radians(16)))
        and (faced or abs(follower.centre_distance - follower.arm) < base + follower.radius)
        and keeps(replace(follower, base=base), moved, 0.5)
    ]
    if found == inf:
        assert not tried
        return
    assert tried
    assert tried[0] - 1.0 <= found + 1e-6 <= tried[0] + 1e-5
    assert keeps(replace(follower, base=found + 1e-3), moved, 0.5)
    assert not keeps(replace(follower, base=found - 0.1), moved, 0.5)


def test_a_pressure_angle_finds_the_base_circle_of_an_arm():
    for name in ("swinging_roller", "swinging_flat"):
        design = Design.from_toml(DESIGNS[name]).with_(
            ["cam.base_circle_radius_mm=", "cam.pressure_angle_deg=35", "motion.segments.1.to_deg=8"]
        )
        cam = design.cam()
        angles = [check for check in cam.checks if check.code.startswith("pressure-angle-r")]
        assert all(check.passed for check in angles)
        if name == "swinging_roller":
            assert max(check.value for check in angles) == pytest.approx(35, abs=2e-3)
    with pytest.raises(DesignError, match="no base circle keeps it with this arm and motion"):
        design.with_({"cam.pressure_angle_deg": 1.0}).cam()


def test_a_swing_of_a_groove_is_refused_by_what_the_arm_does_and_not_by_its_opposite():
    """The outer flank has the opposite motion: from 24 degrees at rest a swing of 20 was taken for 3 degrees."""
    text = DESIGNS["swinging_roller"]
    changes = {
        "follower.centre_distance_mm": 31.2,
        "follower.arm_mm": 23.0,
        "follower.radius_mm": 2.28,
        "cam.base_circle_radius_mm": 11.4,
        "blank.bore_diameter_mm": 4.0,
        "machining.cutter_diameter_mm": 3.0,
        "follower.closure": "groove",
        "follower.clearance_mm": 0.05,
        "follower.depth_mm": 3.0,
        "motion.segments.1": {"to_deg": 20.45, "in_deg": 100.0, "law": "cycloidal"},
    }
    cam = Design.from_toml(text).with_(changes).cam()
    assert cam.groove is not None


@pytest.mark.parametrize("radius", [0.8, 2.0, 8.0])
def test_the_rolled_pressure_angle_of_a_small_roller(radius):
    """Along arcs of the path, tan(alpha) = (l (1 + g q') - c cos(delta)) / (c sin(delta)), to 0.001 degrees."""
    follower = SwingingRoller(base=30, radius=radius, arm=72, centre_distance=88, lifts=Lifts.AGAINST)
    theta = np.linspace(0, TURN, 360, endpoint=False)
    contact, _ = roll_curve(actual_profile(JUMPING, follower).curve, follower, theta)
    delta = follower.rest + JUMPING.q(theta)
    lever = 72 * (1 + JUMPING.q(theta, nu=1)) - 88 * np.cos(delta)
    off = np.degrees(contact.pressure_angle - np.arctan(lever / (88 * np.sin(delta))))
    assert np.abs(off).max() < 1e-3


def test_a_noisy_table_that_no_groove_can_follow_names_the_smoothing():
    noise = np.random.default_rng(1).normal(0, 0.01, 360)
    lift = 6 * (1 - np.cos(np.radians(np.arange(360)))) + noise
    rows = [[float(angle), float(value)] for angle, value in enumerate(lift)]
    text = "\n".join(
        (
            'name = "lobe"\n[motion]\nturns = "clockwise"',
            f"rows = {rows}",
            '[follower]\nkind = "roller"\nradius_mm = 3.0\nclosure = "groove"\nclearance_mm = 0.05\ndepth_mm = 3.0',
            "[cam]\nbase_circle_radius_mm = 20.0\nthickness_mm = 8.0\n[machining]\ncutter_diameter_mm = 4.0",
        )
    )
    with pytest.raises(DesignError, match=r"noise by their fourth differences: set motion.smooth to true") as refused:
        Design.from_toml(text).cam()
    assert 8 < float(re.search(r"have (\S+) µm of noise", str(refused.value))[1]) < 12
    assert Design.from_toml(text).with_({"motion.smooth": True}).cam().passed


def test_limits_of_sizes_are_those_of_the_checks():
    limits = CheckLimits(
        pressure_angle=PressureAngleLimit(rise=RISE, fall=FALL, source=""),
        lost_lift=1e-3,
        min_convex_radius=0.5,
        cutter_radius=2.0,
        wall=2.0,
        motion_key="",
    )
    follower = SwingingFace(base=30, face_offset=10, centre_distance=120, lifts=Lifts.WITH)
    (size,) = follower.sizes(MOTION, limits)
    least = follower.least_base(MOTION, RISE, FALL, 0.5)
    assert size.key == "cam.base_circle_radius_mm"
    assert 0 <= size.value - least < 0.02
    assert size.value + 10 < 120 * sin(radians(90 - 16))
    assert PRESSURE_ANGLE_LIMITS


def test_the_pressure_angle_of_a_knife_where_the_acceleration_jumps():
    """At its peak, where two pieces of the profile meet: tan(alpha) = s' / (R_b + s) by the parabola's middle."""
    moved = motion(MM, ((50, 3.0, "constant_acceleration"), (130, 0.0, "simple_harmonic"), (180, 0.0, None)))
    knife = Knife(base=12.0)
    contact, _ = roll_curve(actual_profile(moved, knife).curve, knife, np.radians([25.0]))
    assert np.degrees(contact.pressure_angle[0]) == pytest.approx(degrees(atan2(2 * 3.0 / radians(50), 13.5)), abs=2e-4)
