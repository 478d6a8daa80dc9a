"""A follower that is made up outside the package, in the documentation: a roller on a slide.

Its envelope is held against the closed form by the pressure angle, tan(alpha) = s' / (a + s): the contact lies
a + s - r cos(alpha) ahead of the camshaft and r sin(alpha) across (Rothbart, Cams, ch. 4; Norton, Cam Design and
Manufacturing Handbook, ch. 7), and its rolling against a worked example.
"""

import re
from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest
from scipy.interpolate import PPoly

from cadgen import Cam, Design, Flat, Motion, rise
from cadgen.cam.checks import cam_place, check_cam
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers import table
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, CheckLimits
from cadgen.cam.lost_lift import lost_lift, undercut_cures, worst_loss
from cadgen.cam.round_follower import CircleArc
from cadgen.car.path_motion import PathMotion
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.calibration.cam_on_car import nominal_of
from cadgen.jobs.cam.cam_files import write_cam
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.parts.blank import Blank
from tests.cam.sliding_roller import SLIDING_ROLLER, SlidingRoller

TURN = 2 * np.pi
KEYS = ["follower={kind = 'sliding_roller', radius_mm = 8.0, arm_mm = 25.0}"]


@pytest.fixture
def registered():
    table.register(SLIDING_ROLLER)
    yield SLIDING_ROLLER
    table.remove(SLIDING_ROLLER)


def motion(*spans):
    """A lift by polynomials in the share of each span: angle, deg, and its coefficients, mm, lowest first."""
    width = np.radians([angle for angle, _ in spans])
    x = np.concatenate([[0.0], np.cumsum(width)])
    x[-1] = TURN
    terms = np.array([[*coefficients, *[0.0] * (6 - len(coefficients))] for _, coefficients in spans])
    c = terms / width[:, None] ** np.arange(6)
    return PPoly(c.T[::-1], x, extrapolate="periodic")


def limits():
    return CheckLimits(
        pressure_angle=PRESSURE_ANGLE_LIMITS["norton_translating"],
        lost_lift=1e-3,
        min_convex_radius=0.5,
        cutter_radius=2.0,
        wall=2.0,
    )


def test_a_worked_example_of_3_4_5():
    """Rise 10 mm in 90 deg, dwell 45, fall in 180; prime circle 76.2, roller 12.5."""
    rise, fall = [0, 0, 0, 100, -150, 60], [10, 0, 0, -100, 150, -60]
    s = motion((90, rise), (45, [10.0]), (180, fall), (45, [0.0]))
    lift = PathMotion(s, np.array([]), TURN)
    roller = SlidingRoller(base_radius=76.2, radius=12.5, arm=1.0)
    profile = actual_profile(lift, roller)
    assert not profile.trims
    checks = check_cam(lift, roller, profile.curve, profile.trims, Blank(bore_diameter=8.0), limits())
    by_name = {check.name: check for check in checks}
    assert all(check.passed for check in checks), [check.name for check in checks if not check.passed]
    assert by_name["pressure angle, rise"].value == pytest.approx(8.3765, abs=1e-3)
    assert by_name["pressure angle, rise"].place == cam_place(radians(43.70))
    assert by_name["pressure angle, return"].value == pytest.approx(4.2108, abs=1e-3)
    assert by_name["convex radius, theory"].value == pytest.approx(67.065, abs=1e-3)
    assert "roller pushed out" in by_name
    assert "rod" not in " ".join(by_name)


def test_the_profile_is_that_of_the_textbooks(carbon_free_car):
    lift, roller = carbon_free_car.lift, SlidingRoller(base_radius=70.0, radius=8.0, arm=25.0)
    profile = actual_profile(lift, roller)
    assert profile.trims == ()
    theta = np.linspace(0.0, TURN, 2000, endpoint=False)
    R, slope = 70.0 + 25.0 * lift.q(theta), 25.0 * lift.q(theta, nu=1)
    alpha = np.arctan2(slope, R)
    point = ((R - 8.0 * np.cos(alpha)) + 8.0j * np.sin(alpha)) * np.exp(1j * theta)
    jet, _ = profile.curve.at_angle(np.angle(point))
    assert np.abs(jet.point @ [1, 1j] - point).max() < 1e-9
    contact, _ = roll_curve(profile.curve, roller, theta)
    print(f"rolled {np.abs(contact.lift - (R - 70.0)).max() * 1e3:.4f} um off")
    assert np.abs(contact.lift - (R - 70.0)).max() < 2e-5
    assert np.abs(contact.pressure_angle - alpha).max() < 2e-4
    # The follower's point, on the path of its centre.
    axis = roll(roller.pitch_curve(lift).outline(0.01), roller.point(), theta)
    assert np.abs(axis.lift - (R - 70.0)).max() < 1e-4


def test_corners_of_the_lift_lose_what_geometry_says(appendix_car):
    """At a convex corner of angle delta the centre stays r (1 / cos(delta / 2) - 1) away, along the normal."""
    lift, roller = appendix_car.lift, SlidingRoller(base_radius=70.0, radius=0.2, arm=26.0)
    profile = actual_profile(lift, roller)
    losses = lost_lift(lift, roller, profile.trims, profile.curve.outline(0.002))
    corners = [corner for corner in roller.pitch_curve(lift).corners(0.05) if corner.turn > 0]
    assert len(corners) == 2
    for corner in corners:
        theta = np.arctan2(corner.point[1], corner.point[0]) % TURN
        (loss,) = [loss for loss in losses if abs(loss.cam_angle - theta) < 1e-3]
        slope = 26.0 * lift.q(np.array([theta - 1e-6, theta + 1e-6]), nu=1)
        tilt = np.arctan(slope / np.linalg.norm(corner.point)).mean()
        expected = 0.2 * (1 / np.cos(corner.turn / 2) - 1) / np.cos(tilt)
        print(f"{loss.lift * 1e3:.3f} um lost, {expected * 1e3:.3f} expected")
        assert loss.lift == pytest.approx(expected, rel=0.01)


def test_hollow_corners_cost_nothing(appendix_car):
    """There the roller's own arc is the profile, and the roller reaches what is wanted."""
    lift, roller = appendix_car.lift, SlidingRoller(base_radius=70.0, radius=2.0, arm=26.0)
    slope = lift.q(lift.kinks + 1e-6, nu=1) - lift.q(lift.kinks - 1e-6, nu=1)
    hollow = lift.kinks[slope > 1e-3]
    assert hollow.size > 2
    profile = actual_profile(lift, roller)
    arcs = [piece for piece in profile.curve.pieces if isinstance(piece, CircleArc)]
    assert len(arcs) == hollow.size
    rolled, _ = roll_curve(profile.curve, roller, hollow)
    assert np.abs(rolled.lift - roller.lift(lift.q(hollow))).max() < 2e-5


def test_a_roller_too_large_is_refused(carbon_free_car):
    with pytest.raises(DesignError, match=r"nothing is left of the disc: raise cam\.base_radius_mm, or widen the turn"):
        actual_profile(carbon_free_car.lift, SlidingRoller(base_radius=70.0, radius=69.0, arm=25.0))


@pytest.mark.slow
def test_a_design_names_it_and_gets_its_files(registered, tmp_path):
    design = load_design("carbon_free_car", KEYS)
    plan = plan_cam(design, "actual")
    assert isinstance(plan.follower, SlidingRoller)
    assert plan.passed
    assert plan.shown == ()
    written = write_cam(plan, tmp_path, find_cures(plan), formats=["dxf", "csv"])
    assert {path.suffix for path in tmp_path.iterdir()} >= {".dxf", ".csv"}
    facts = written.entry
    assert list(facts["carrying_planes_mm"]) == [25.0]
    assert {check["name"] for check in facts["checks"]} >= {"roller pushed out", "roller falls short"}
    assert all(file["lift_error_um"] <= file["lift_limit_um"] for file in facts["files"].values())
    rows = (tmp_path / "carbon_free_car_actual.csv").read_text().splitlines()
    assert {row.rpartition(",")[2] for row in rows[1:]} == {"whole"}
    # The theoretical profile is the path of its centre.
    assert plan_cam(design, "theoretical").passed


@pytest.mark.slow
def test_its_cures_are_its_own(appendix_car):
    lift, roller = appendix_car.lift, SlidingRoller(base_radius=70.0, radius=2.0, arm=26.0)
    now = worst_loss(lift, roller)
    changes = {change.parameter: change for change in undercut_cures(lift, roller, now / 2)}
    assert set(changes) == {"follower.radius_mm", "cam.base_radius_mm"}
    # The loss of a corner goes with the radius.
    assert changes["follower.radius_mm"].value == pytest.approx(1.0, rel=0.06)
    for key, name in (("follower.radius_mm", "radius"), ("cam.base_radius_mm", "base_radius")):
        assert worst_loss(lift, replace(roller, **{name: changes[key].value})) <= now / 2
    profile = actual_profile(lift, roller)
    checks = check_cam(lift, roller, profile.curve, profile.trims, Blank(bore_diameter=8.0), limits())
    assert "no profile gives this lift to this roller" in " ".join(c.advice for c in checks if not c.passed)


@pytest.mark.parametrize(
    ("profile", "more", "words"),
    [
        ("optimized", [], "what the play of the gears does to a cam is worked out .*, or take --profile actual"),
        ("published", [], "the formula of the paper is worked out .*, or take --profile actual"),
        ("actual", ["mechanics.rod_force_N=1"], "friction is worked out .* remove .mechanics."),
        ("actual", ["blank.material=steel"], "friction is worked out .* remove .mechanics. and blank.material"),
    ],
)
def test_what_is_for_the_rod_alone_says_so(registered, profile, more, words):
    with pytest.raises(DesignError, match=f"^follower.kind names a roller, and {words}"):
        plan_cam(load_design("carbon_free_car", [*KEYS, *more]), profile)


def test_what_runs_the_car_says_so_too(registered):
    design = Design.load("carbon_free_car").with_(KEYS)
    for job in (design.simulate, lambda: design.tolerance(samples=10), lambda: design.cam()):
        with pytest.raises(DesignError, match=r"^follower.kind names a roller, and what the play of the gears does"):
            job()
    with pytest.raises(DesignError, match=r"a calibration is worked out for the leaning rod alone"):
        nominal_of(load_design("carbon_free_car", KEYS), "actual")


@pytest.mark.parametrize(
    ("override", "words"),
    [
        (
            "follower.arm_mm=",
            "follower.arm_mm is missing: add it, a number in mm (fork axis to the pin that moves the slide)",
        ),
        ("follower.arm_mm=-1", "follower.arm_mm is -1; it must be greater than 0 and at most 500 (mm)"),
        ("follower.arm=3", "follower.arm is not a key: write follower.arm_mm, in mm"),
        ("follower.length_mm=40", "[follower] takes kind, radius_mm and arm_mm"),
        ("follower.radius_mm=70", "it must be less than cam.base_radius_mm, 70: lower it"),
        ('follower.kind="wheel"', 'follower.kind is "wheel"; it must be "rod" or "sliding_roller"'),
    ],
)
def test_its_keys_are_checked_by_its_own_limits(registered, override, words):
    with pytest.raises(DesignError, match=re.escape(words)):
        load_design("carbon_free_car", [*KEYS, override])


def test_a_design_that_names_the_rod_is_the_design_that_names_none():
    named, plain = load_design("carbon_free_car", ["follower.kind=rod"]), load_design("carbon_free_car")
    assert named.content_hash == plain.content_hash
    assert named.follower.registered.code == "rod"


def test_a_kind_that_is_not_registered_is_refused():
    with pytest.raises(DesignError, match=r'follower.kind is "sliding_roller"; it must be "rod"'):
        load_design("carbon_free_car", KEYS)


@pytest.mark.parametrize("code", ["rod", "Two words", ""])
def test_a_code_is_unique_and_plain(code):
    with pytest.raises(DesignError, match="follower"):
        table.register(replace(SLIDING_ROLLER, code=code))


@pytest.mark.parametrize(("lift", "base"), [(50.0, 25.0), (50.8, 38.1)])
def test_a_flat_face_in_simple_harmonic_motion_rides_on_an_eccentric(lift, base):
    """Published exercises: circles of 50 mm and of 2.5 in, faces of 50 mm and of 2 in, as wide as the lift is high."""
    motion = Motion([rise(lift, pi, "simple_harmonic"), rise(-lift, pi, "simple_harmonic")])
    cam = Cam(motion, Flat(), base_circle_radius=base, thickness=8)
    points = cam.computed.curve.outline(0.05).points
    assert np.abs(np.hypot(points[:, 0] + lift / 2, points[:, 1]) - (base + lift / 2)).max() < 1e-9
    assert {check.code: check for check in cam.figures}["face-width"].value == pytest.approx(lift, abs=1e-3)
