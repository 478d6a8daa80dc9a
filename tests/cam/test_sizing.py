"""Sizes that a program proposes, against brute force: tried one after the other, and put into the design."""

from math import radians

import numpy as np
import pytest

from cadgen import Design
from cadgen.arrays import TURN
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.flat import FlatFace
from cadgen.cam.followers.roller import Roller
from cadgen.cam.lost_lift import lost_lift
from cadgen.cam.sizing import SlideSizes, least_base_of_face
from cadgen.errors import DesignError
from tests.cam.test_kinds import DESIGNS
from tests.cam.test_roller import motion

BASE = "cam.base_circle_radius_mm"
BOTH = motion((90, 20.0, "modified_sine"), (60, 20.0, None), (120, 0.0, "cycloidal"), (90, 0.0, None))
HARMONIC = motion((180, 20.0, "simple_harmonic"), (180, 0.0, "simple_harmonic"))


def test_the_least_prime_radius_of_a_known_example():
    """Modified sine 20 mm in 90 degrees, back by a cycloid in 120, limits of 30 and 45 degrees."""
    sizes = SlideSizes(BOTH, radians(30), radians(45))
    assert sizes.least_prime_radius(0.0) == pytest.approx(30.00, abs=5e-3)
    assert sizes.best_offset() == pytest.approx(6.90, abs=5e-3)
    assert sizes.least_prime_radius(sizes.best_offset()) == pytest.approx(19.32, abs=5e-3)


@pytest.mark.parametrize("offset", [0.0, 5.0, -3.0, 6.9])
def test_no_smaller_base_circle_keeps_the_pressure_angle(offset):
    """The least radius, and one that is 0.01 % less, rolled: within the limits, and beyond one of them."""
    limits = radians(30), radians(45)
    prime = SlideSizes(BOTH, *limits).least_prime_radius(offset)
    theta = np.linspace(0.0, TURN, 7200, endpoint=False)
    allowed = np.where(BOTH.q(theta, nu=1) >= 0, *limits)
    for share, keeps in ((1.0001, True), (0.9999, False)):
        y0 = np.sqrt((share * prime) ** 2 - offset**2)
        angle = np.arctan2(BOTH.q(theta, nu=1) - offset, y0 + BOTH.q(theta))
        assert np.all(np.abs(angle) <= allowed) == keeps


def test_no_offset_makes_the_cam_smaller_than_the_best():
    sizes = SlideSizes(BOTH, radians(30), radians(45))
    best = sizes.least_prime_radius(sizes.best_offset())
    assert min(sizes.least_prime_radius(offset) for offset in np.linspace(-20, 20, 161)) >= best - 1e-6


@pytest.mark.parametrize("tilt", [0.0, 0.2])
def test_the_least_base_circle_of_a_face_is_where_undercut_begins(tilt):
    """A little larger and the envelope is whole; a little smaller and it is trimmed, and lift is lost."""
    least = least_base_of_face(BOTH, tilt)
    assert actual_profile(BOTH, FlatFace(base=least + 0.02, tilt=tilt)).trims == ()
    assert actual_profile(BOTH, FlatFace(base=least - 0.5, tilt=tilt)).trims


def test_a_harmonic_face_of_an_eccentric_needs_no_base_circle():
    """Its cam is a circle whatever the base circle (Uicker 6.2: 2 in in 180 + 180 degrees), so s + s'' = const."""
    assert least_base_of_face(HARMONIC, 0.0) == pytest.approx(-10.0, abs=1e-6)


def cut_by_rays(follower, motion_, phi, count=60_000):
    """Radius of the disc at polar angles, cut by the follower at many cam angles, without a derivative."""
    theta = np.linspace(0.0, TURN, count, endpoint=False)
    q = motion_.q(theta)
    if isinstance(follower, FlatFace):
        along = np.cos(phi[:, None] - theta + follower.tilt)
        h = follower.base + q * np.cos(follower.tilt)
        return np.where(along > 1e-6, h / np.where(along > 1e-6, along, 1.0), np.inf).min(axis=1)
    y0 = np.sqrt((follower.base + follower.radius) ** 2 - follower.offset**2)
    w = (y0 + q + 1j * follower.offset) * np.exp(1j * (theta - phi[:, None]))
    inside = (np.abs(w.imag) < follower.radius) & (w.real > 0)
    half = np.sqrt(np.where(inside, follower.radius**2 - w.imag**2, 0.0))
    return np.where(inside, w.real - half, np.inf).min(axis=1)


@pytest.mark.parametrize(
    "follower", [Roller(base=8.0, radius=24.0, offset=4.0), FlatFace(base=14.0)], ids=["roller", "flat"]
)
def test_lost_lift_is_what_the_disc_that_is_cut_loses(follower):
    """The trimmed profile is that of brute cutting, and what it loses that of the textbook's contact on it."""
    steep = motion((60, 14.0, "cycloidal"), (40, 14.0, None), (90, 0.0, "cycloidal"), (170, 0.0, None))
    profile = actual_profile(steep, follower)
    assert profile.trims
    phi = np.linspace(0.0, TURN, 181, endpoint=False)
    assert np.abs(cut_by_rays(follower, steep, phi) - profile.curve.radius(phi)).max() < 1e-5
    losses = lost_lift(steep, follower, profile.trims, profile.curve.outline(0.005))
    worst = max(losses, key=lambda loss: loss.lift)
    theta = np.linspace(worst.trim.before, worst.trim.after, 2001)
    # Contact on the corner, which is all that is left between the two branches.
    corner = (worst.trim.point @ [1, 1j]) * np.exp(-1j * theta)
    if isinstance(follower, FlatFace):
        lift = corner.real - follower.base
    else:
        y0 = np.sqrt((follower.base + follower.radius) ** 2 - follower.offset**2)
        lift = corner.real + np.sqrt(follower.radius**2 - (corner.imag - follower.offset) ** 2) - y0
    expected = float((steep.q(theta) - lift).max())
    print(f"lost {1e3 * worst.lift:.3f} um, by hand {1e3 * expected:.3f}")
    assert worst.lift == pytest.approx(expected, rel=1e-3)  # 65 stations a trim
    rolled = roll(profile.curve.outline(0.005), follower, theta)
    np.testing.assert_allclose(rolled.lift, lift, atol=1e-6)


def test_a_pressure_angle_instead_of_a_radius_gives_the_least_base_circle():
    design = Design.from_toml(DESIGNS["roller"])
    asked = design.with_(["cam.base_circle_radius_mm=", "cam.pressure_angle_deg=25"])
    cam = asked.cam()
    assert cam.passed
    angles = [check.value for check in cam.checks if check.code in ("pressure-angle-rise", "pressure-angle-return")]
    assert max(angles) == pytest.approx(25.0, abs=1e-3)
    assert max(angles) <= 25.0
    base = asked.values.seat.base_radius
    contact, _ = roll_curve(cam.computed.curve, cam.computed.follower, np.array([0.0]))
    assert contact.lift[0] == pytest.approx(0.0, abs=1e-6)
    same = design.with_({"cam.base_circle_radius_mm": base}).cam()
    assert [c.value for c in same.checks] == pytest.approx([c.value for c in cam.checks], abs=1e-9)
    with pytest.raises(DesignError, match="is for a roller, a knife edge or a follower on an arm"):
        Design.from_toml(DESIGNS["flat"]).with_(["cam.base_circle_radius_mm=", "cam.pressure_angle_deg=25"])
    with pytest.raises(DesignError, match="both fix the base circle: remove one"):
        design.with_(["cam.pressure_angle_deg=25"])
    with pytest.raises(DesignError, match=r"base_circle_radius_mm is missing: add it, or cam.pressure_angle_deg"):
        design.with_(["cam.base_circle_radius_mm="])


@pytest.mark.parametrize(
    ("name", "changes", "keys"),
    [
        ("roller", {BASE: 20.0, "follower.offset_mm": -8.0}, [BASE, "follower.offset_mm"]),
        ("flat", {BASE: 12.0}, [BASE]),
        ("tilted", {BASE: 12.0}, [BASE]),
    ],
)
def test_each_proposal_is_accepted_when_it_is_put_in(name, changes, keys):
    design = Design.from_toml(DESIGNS[name]).with_(changes)
    cam = design.cam()
    assert not cam.passed
    proved = [cure.override for cure in cam.cures.proved if not cure.failing]
    print(proved)
    for key in keys:
        (first, *_) = [text for text in proved if text.startswith(f"{key}=")]
        assert design.with_([first]).cam().passed
