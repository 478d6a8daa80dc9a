"""The packaged cams by their motion: verdict, the figures that their sources print, and all files.

Every expected figure is the source's or a closed form, as `designs/NAME.toml` says; none is an output of ours.
"""

import json
from math import asin, degrees, pi, radians, sqrt

import numpy as np
import pytest

from cadgen import Design
from cadgen.design.load import packaged_designs
from cadgen.design.schema import MotionDesign
from cadgen.verdict import Readiness

CAMS = {
    "conjugate_pair": (Readiness.READY, set()),
    "eccentric": (Readiness.READY, set()),
    "flat": (Readiness.RESERVATIONS, {"acceleration-jumps"}),
    "groove": (Readiness.READY, set()),
    "roller": (Readiness.READY, set()),
    "swinging_roller": (Readiness.READY, set()),
    "valve_lobe": (Readiness.READY, set()),
}
INCH = 25.4


@pytest.fixture(scope="module")
def cams():
    return {name: Design.load(name).cam() for name in CAMS}


def figures(cam):
    return {check.code.value: check for check in (*cam.verdict.checks, *cam.shown)}


def place(check):
    """Angle of a figure's place, degrees."""
    return float(str(check.place).removesuffix("°").split()[-1])


def test_every_packaged_design_is_a_car_or_one_of_these():
    assert set(CAMS) == {name for name in packaged_designs() if isinstance(Design.load(name).values, MotionDesign)}


@pytest.mark.parametrize("name", CAMS)
def test_the_verdict_of_each(cams, name):
    verdict = cams[name].verdict
    assert (verdict.readiness, {each.code for each in verdict.reservations}) == CAMS[name]


def test_the_roller_has_the_figures_of_the_exercise(cams):
    """Example 2: velocity, accelerations, pressure angles and radius of the pitch curve, then with the weak spring."""
    shown = figures(cams["roller"])
    assert shown["motion-velocity"].value == pytest.approx(0.119366, abs=5e-7)
    assert shown["motion-acceleration"].value == pytest.approx(2.339913, abs=5e-7)
    assert shown["pressure-angle-greatest"].value == pytest.approx(8.3765, abs=5e-5)
    assert place(shown["pressure-angle-greatest"]) == pytest.approx(43.70, abs=0.01)
    assert shown["pressure-angle-least"].value == pytest.approx(-4.2108, abs=5e-5)
    assert shown["convex-radius-theory"].value == pytest.approx(67.0651, abs=1e-4)
    assert place(shown["convex-radius-theory"]) == pytest.approx(69.32, abs=0.06)
    weak = Design.load("roller", {"dynamics.spring_rate_N_per_mm": 0.1}).cam()
    shown, facts = figures(weak), weak.facts()["forces"]
    assert facts["force_along_greatest_N"] == pytest.approx(27.7644, abs=1e-4)
    assert facts["force_along_greatest_at_deg"] == pytest.approx(19.29, abs=0.01)
    assert facts["force_along_least_N"] == pytest.approx(-6.4710, abs=1e-4)
    assert facts["force_along_least_at_deg"] == pytest.approx(71.01, abs=0.01)
    assert shown["lift-off-speed"].value * pi / 30 == pytest.approx(7.9345, abs=5e-5)
    assert facts["leaves_deg"] == [[pytest.approx(56.66, abs=5e-3), pytest.approx(83.02, abs=5e-3)]]
    assert shown["camshaft-torque-greatest"].value == pytest.approx(226.96, abs=5e-3)
    assert shown["camshaft-torque-least"].value == pytest.approx(-68.00, abs=5e-3)
    assert facts["work_Nmm"] == pytest.approx(3.738, abs=5e-4)
    assert facts["peak_power_W"] == pytest.approx(2.27, abs=5e-3)
    assert not weak.passed


@pytest.mark.parametrize("name", ["swinging_roller", "conjugate_pair"])
def test_the_rollers_on_arms_have_the_figures_of_the_machine(cams, name):
    """Example 3, by the pressure angle that its own program misses, for it takes the greatest with its sign."""
    cam, design = cams[name], Design.load(name).values
    spans = [each.to_deg for each in design.motion.segments if each.to_deg is not None]
    assert spans == pytest.approx([degrees(asin(3.2 / 52)), degrees(asin(0.95 / 52)), 0.0], abs=1e-12)
    prime = sqrt(65**2 + 105.8**2 - 2 * 65 * 105.8 * np.cos(radians(35)))
    assert design.cam.base_circle_radius_mm + 9.5 == pytest.approx(prime, abs=1e-9)
    shown = figures(cam)
    assert shown["motion-velocity"].value * 65 == pytest.approx(187.8097, abs=5e-5)
    assert shown["motion-acceleration"].value * 65e-3 == pytest.approx(15.7339, abs=5e-5)
    assert shown["pressure-angle-greatest"].value == pytest.approx(-9.410, abs=5e-4)
    assert shown["pressure-angle-least"].value == pytest.approx(-20.289, abs=1e-3)
    assert shown["convex-radius-profile"].value == pytest.approx(35.2695, abs=1e-4)


def test_the_swinging_roller_has_the_moments_of_the_machine(cams):
    facts = cams["swinging_roller"].facts()["forces"]
    assert facts["force_along_greatest_Nmm"] == pytest.approx(2056.0, abs=0.05)
    assert facts["camshaft_torque_greatest_Nmm"] == pytest.approx(220.3, abs=0.05)


def test_the_flat_face_has_the_figures_of_the_exercise(cams):
    """Example 9: the face, the least base circle, and the places at which the acceleration jumps."""
    shown, motion = figures(cams["flat"]), cams["flat"].facts()["motion"]
    assert shown["face-width"].value == pytest.approx(152.789, abs=1e-3)
    radius = shown["convex-radius-profile"].value
    assert Design.load("flat").values.cam.base_circle_radius_mm - radius == pytest.approx(192.908, abs=1e-3)
    jumps = [seam["cam_angle_deg"] for seam in motion["seams"] if seam["derivative"] == 2]
    assert sorted(jumps) == pytest.approx([0.0, 90.0, 150.0, 300.0, 330.0])


def test_the_eccentric_is_a_circle_and_leaves_at_the_speed_of_the_formula(cams):
    """Example 5, at 500 rev/min as in the source; sqrt((P + 2 k e)/(m e)) = 49.0653 rad/s."""
    cam = cams["eccentric"]
    outline = cam.curve.outline(0.1).points @ [1, 1j]
    assert np.abs(np.abs(outline + 15.0) - 40.0).max() < 1e-9
    assert figures(cam)["lift-off-speed"].value == pytest.approx(468.539, abs=5e-4)
    fast = Design.load("eccentric", {"motion.speed_rpm": 500.0}).cam()
    facts = fast.facts()["forces"]
    assert facts["leaves_deg"] == [[pytest.approx(142.66, abs=5e-3), pytest.approx(217.34, abs=5e-3)]]
    assert facts["camshaft_torque_greatest_Nmm"] == pytest.approx(371.007, abs=5e-4)


def test_the_groove_has_the_pressure_angle_and_the_radius_of_the_book(cams):
    """Example 6: arcsin(1/3) at 70.53 degrees, 2 sqrt(2) inches; the play along the motion is clearance/cos."""
    shown = figures(cams["groove"])
    assert shown["pressure-angle-greatest"].value == pytest.approx(19.4712, abs=1e-4)
    assert place(shown["pressure-angle-greatest"]) == pytest.approx(70.53, abs=0.05)
    assert shown["convex-radius-theory"].value == pytest.approx(2 * sqrt(2) * INCH, abs=1e-4)
    assert shown["groove-play-greatest"].value == pytest.approx(0.05 / np.cos(asin(1 / 3)), abs=1e-5)


def test_the_conjugate_pair_touches_with_both_rollers(cams):
    """Distance of each roller's centre from its own outline over the turn, in the frame of the books."""
    cam = cams["conjugate_pair"]
    theta = np.radians(np.arange(0.25, 360.0, 5.0))
    swing = radians(35) + cam.motion.q(theta)
    for outline, delta, side in (
        (cam.curve.outline(0.02).points, swing, 1.0),
        (cam.second.curve.outline(0.02).points, radians(70) - swing, -1.0),
    ):
        centre = (105.8 - 65 * np.cos(delta) - 1j * side * 65 * np.sin(delta)) * np.exp(1j * theta)
        gap = [np.abs(outline @ [1, 1j] - one).min() - 9.5 for one in centre]
        assert np.abs(gap).max() < 1e-4


def test_the_valve_lobe_is_the_polynomial_from_nose_to_base_circle(cams):
    """The five coefficients from five equations, and the spring of the source: 7.13 N/mm, compressed by 1.77 mm."""
    powers = np.array([2, 10, 18, 26, 34])
    orders = np.array(
        [np.prod([np.ones(5), *(powers - below for below in range(order))], axis=0) for order in range(5)]
    )
    values = np.linalg.solve(orders, [-1.0, 0, 0, 0, 0])
    theta = np.radians([5.0, 20.0, 35.0, 50.0, 65.0, 70.0])
    x = 1 - theta / radians(70)
    wanted = 7.4435 * (1 + (values[:, None] * x ** powers[:, None]).sum(axis=0))
    np.testing.assert_allclose(cams["valve_lobe"].motion.q(theta), wanted, atol=1e-6)
    assert Design.load("valve_lobe").values.dynamics.preload_N == pytest.approx(7.13 * 1.77, abs=1e-4)


@pytest.mark.long
@pytest.mark.slow
@pytest.mark.parametrize("name", CAMS)
def test_all_files_of_each_are_read_back_and_hold(cams, name, tmp_path):
    written = cams[name].write(tmp_path)
    manifest = json.loads((written.folder / "manifest.json").read_text(encoding="utf-8"))
    (part,) = manifest["parts"].values()
    assert len(part["files"]) == {"conjugate_pair": 16, "groove": 10}.get(name, 8)
    for file, entry in part["files"].items():
        assert entry["lift_error_um"] <= entry["lift_limit_um"], file
        if file.endswith((".step", ".xyz", ".csv")):
            assert entry["lift_error_um"] <= 0.05
