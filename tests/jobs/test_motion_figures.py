"""Figures of a cam by its motion: peaks with places, seams, reservations, table; CSV; and the outline itself."""

import csv
import json
from math import pi, radians

import numpy as np
import pytest

from cadgen import Design
from cadgen.arrays import TURN
from cadgen.cam.contact import roll_curve
from cadgen.jobs.cam.motion_figures import seams_sheets
from cadgen.laws.table import law_of
from cadgen.messages import Message
from tests.laws.test_lift_table import lobe

FEEDER = """
name = "feeder"

[motion]
turns = "clockwise"
speed_rpm = 420
segments = [
    { to_mm = 14.0, in_deg = 80.0, law = "polynomial_3_4_5" },
    { dwell_deg = 50.0 },
    { to_mm = 0.0, in_deg = 110.0, law = "modified_sine" },
    { dwell_deg = 120.0 },
]

[follower]
kind = "roller"
radius_mm = 9.0
offset_mm = 8.0

[cam]
base_circle_radius_mm = 32.0
thickness_mm = 10.0
"""


def feeder(**changes):
    return Design.from_toml(FEEDER).with_({key.replace("__", "."): value for key, value in changes.items()})


def test_peaks_stand_with_their_places_in_the_unit_of_the_speed():
    """Figures of another program: v 18.8002 at 40°, a 41.4603 at 16.906°, j 308.587 at the ends of the rise."""
    cam = feeder().cam()
    shown = {check.code.value: check for check in cam.figures if check.code.value.startswith("motion-")}
    speed = 420 * TURN / 60
    assert shown["motion-velocity"].value == pytest.approx(18.8002e-3 * speed, rel=1e-5)
    assert shown["motion-velocity"].place == "cam angle 40.00°"
    assert shown["motion-acceleration"].value == pytest.approx(41.4603e-3 * speed**2, rel=1e-5)
    assert shown["motion-acceleration"].place == "cam angle 16.91°"
    assert shown["motion-jerk"].value == pytest.approx(308.587e-3 * speed**3, rel=1e-5)
    assert [shown[code].unit for code in shown] == ["m/s", "m/s²", "m/s³"]
    assert "At 420 rev/min the follower moves at up to 0.8269 m/s (cam angle 40.00°), 80.2 m/s²" in " ".join(cam.notes)
    facts = cam.facts()["motion"]
    assert facts["greatest_velocity_mm_per_rad"] == pytest.approx(18.8002, rel=1e-5)
    assert facts["greatest_acceleration_at_deg"] == pytest.approx(16.906, abs=1e-3)
    assert facts["vdi_2143"] == ["RR"] * 4
    still = feeder(motion__speed_rpm=None).cam()
    assert {check.unit for check in still.figures if check.code.value.startswith("motion-")} == {
        "mm/rad",
        "mm/rad²",
        "mm/rad³",
    }


def test_the_continuity_report_has_every_seam():
    cam = feeder(**{"motion.segments.3.law": "simple_harmonic"}).cam()
    seams = cam.facts()["motion"]["seams"]
    assert [(round(seam["cam_angle_deg"], 9), seam["derivative"], seam["states"]) for seam in seams] == [
        (0.0, 3, "RR"),
        (80.0, 3, "RR"),
        (130.0, 2, "RU"),
        (240.0, 2, "UR"),
    ]
    assert seams[2]["after"] == pytest.approx(-14 * pi**2 / 2 / radians(110) ** 2)
    (sheet,) = seams_sheets(cam.motion)
    assert sheet.heads[:3] == ("seam", "state (VDI 2143)", "what jumps")
    assert [str(row[0].text) for row in sheet.cells] == [
        "segment 4 to 1",
        "segment 1 to 2",
        "segment 2 to 3",
        "segment 3 to 4",
    ]
    assert [row[2].text for row in sheet.cells] == ["jerk", "jerk", "acceleration", "acceleration"]
    (held,) = cam.verdict.reservations
    assert held.code == "acceleration-jumps"
    assert held.cure == 'set motion.segments.3.law to "polynomial", which ends it, or go slowly'
    milder = feeder(**{"motion.segments.3.law": "polynomial"}).cam()
    assert milder.verdict.reservations == ()
    assert milder.passed


def test_seams_inside_a_law_are_listed_where_the_acceleration_jumps():
    """The modified sine has seams of its jerk at 1/8 and 7/8, the parabola one of its acceleration at 1/2."""
    (sheet,) = seams_sheets(feeder().cam().motion)
    assert len(sheet.cells) == 4
    (sheet,) = seams_sheets(feeder(**{"motion.segments.1.law": "constant_acceleration"}).cam().motion)
    inside = [row for row in sheet.cells if str(row[0].text).startswith("within")]
    assert [(str(row[0].text), row[2].text) for row in inside] == [("within segment 1", "acceleration")]


def test_an_acceleration_that_jumps_at_cam_angle_0_is_no_fault_of_the_program():
    cam = feeder(**{"motion.segments.1.law": "constant_acceleration"}).cam()
    assert cam.passed
    (held,) = cam.verdict.reservations
    assert "at 0 degrees from 0 to 28.72, at 40 degrees from 28.72 to -28.72, at 80 degrees" in held.text


def test_a_corner_that_is_allowed_is_a_reservation_with_its_place():
    changes = {"motion.segments.1.law": "constant_velocity", "motion.segments.1.in_deg": 120.0}
    changes |= {"motion.segments.4.dwell_deg": 80.0, "motion.allow_velocity_jump": True}
    cam = feeder(**changes).cam()
    held = {reservation.code: reservation for reservation in cam.verdict.reservations}
    assert "at 0 degrees from 0 to 6.685, at 120 degrees from 6.685 to 0 mm/rad" in held["velocity-jumps"].text
    assert held["velocity-jumps"].cure.startswith('set motion.segments.1.law to "polynomial", which ends it')
    np.testing.assert_allclose(np.degrees(cam.motion.kinks), [0, 120])
    # The roller rounds the convex corner on an arc about it, and cannot reach the hollow one.
    failed = {check.code.value for check in cam.failed}
    assert failed <= {"lost-lift-undercut", "lost-lift-crossing", "convex-radius-theory"}


def noisy(tmp_path, **changes):
    theta = np.radians(np.arange(360.0))
    rows = lobe(theta)[:, 0] + np.random.default_rng(1).normal(0.0, 2e-3, 360)
    np.savetxt(tmp_path / "lobe.csv", np.c_[np.arange(360), rows], fmt="%.6f", delimiter=",", header="angle,lift")
    head, tail = FEEDER.split("segments = [")
    (tmp_path / "lobe.toml").write_text(head + 'table = "lobe.csv"\n' + tail.split("]\n", 1)[1], encoding="utf-8")
    changes |= {"follower": {"kind": "flat"}, "cam.base_circle_radius_mm": 40.0}
    return Design.load(tmp_path / "lobe.toml", changes)


def test_noise_of_a_table_is_said_and_the_cure_works(tmp_path):
    cam = noisy(tmp_path).cam()
    (held,) = (each for each in cam.verdict.reservations if each.code == "table-noise")
    assert "have 1.9 µm of noise, by their fourth differences, and through them as they are the acc" in held.text
    assert held.cure == "set motion.smooth to true"
    assert not cam.passed
    assert cam.cures.proved[0].override == "motion.smooth=true"
    smooth = noisy(tmp_path, **{"motion.smooth": True}).cam()
    assert smooth.passed
    assert smooth.verdict.reservations == ()
    assert "The rows of the table were smoothed by 1.9 µm rms" in " ".join(smooth.notes)
    facts = smooth.facts()["motion"]
    assert facts["source"] == "motion.table"
    assert facts["noise_mm"] == pytest.approx(2e-3, rel=0.1)
    assert facts["acceleration_before_smoothing_mm_per_rad2"][0] < -80
    true = lobe(np.linspace(0.0, TURN, 7201))[:, 2]
    np.testing.assert_allclose(facts["acceleration_in_table_mm_per_rad2"], [true.min(), true.max()], rtol=0.02)
    json.dumps(smooth.facts())


@pytest.mark.parametrize(("above", "held"), [(32.0, True), (1.5, True), (0.1, False)])
def test_rows_that_never_come_down_to_the_base_circle_are_a_reservation(tmp_path, above, held):
    """Radii, and a dial that was not set to zero: the disc is larger than its base circle says."""
    theta = np.arange(0.0, 360.0, 2.0)
    rows = lobe(np.radians(theta))[:, 0]
    np.savetxt(tmp_path / "lobe.csv", np.c_[theta, rows - rows.min() + above], delimiter=",")
    head, tail = FEEDER.split("segments = [")
    (tmp_path / "lobe.toml").write_text(head + 'table = "lobe.csv"\n' + tail.split("]\n", 1)[1], encoding="utf-8")
    found = [
        each for each in Design.load(tmp_path / "lobe.toml").cam().verdict.reservations if each.code == "never-at-zero"
    ]
    assert [each.cure for each in found] == [f"subtract {above:g} mm from each row"] * held


@pytest.mark.parametrize(
    ("head", "scale", "state", "held"),
    [
        ("", 1 / 25.4, "", True),
        ("", 1.0, "", False),
        ("angle [deg],lift [mm]\n", 1 / 25.4, "", False),
        ("", 1 / 25.4, 'table_unit = "mm"\n', False),
        ("", 1 / 25.4, 'table_unit = "inch"\n', False),
    ],
)
def test_a_table_without_a_unit_that_may_be_in_inches_is_a_reservation(tmp_path, head, scale, state, held):
    theta = np.arange(0.0, 360.0, 2.0)
    rows = lobe(np.radians(theta))[:, 0] * scale
    text = head + "".join(f"{angle:g},{lift:.7f}\n" for angle, lift in zip(theta, rows, strict=True))
    (tmp_path / "lobe.csv").write_text(text, encoding="utf-8")
    begin, tail = FEEDER.split("segments = [")
    table = f'table = "lobe.csv"\n{state}'
    (tmp_path / "lobe.toml").write_text(begin + table + tail.split("]\n", 1)[1], encoding="utf-8")
    found = [each.code for each in Design.load(tmp_path / "lobe.toml").cam().verdict.reservations]
    assert ("unit-assumed" in found) == held


def test_the_table_of_contacts_has_velocity_acceleration_and_jerk(tmp_path):
    cam = feeder().cam()
    cam.write(tmp_path, formats=["csv"])
    with (tmp_path / "feeder_actual.csv").open(encoding="ascii") as text:
        rows = list(csv.DictReader(text))
    theta = np.radians([float(row["cam_angle_deg"]) for row in rows])
    rise = theta < radians(80)
    jets = law_of("polynomial_3_4_5").derivatives(theta[rise] / radians(80)) * 14 / radians(80) ** np.arange(4)
    names = ("lift_mm", "velocity_mm_per_rad", "acceleration_mm_per_rad2", "jerk_mm_per_rad3")
    for order, name in enumerate(names):
        column = np.array([float(row[name]) for row in rows])
        np.testing.assert_allclose(column[rise], jets[:, order], atol=3e-4 if order else 1e-5)
        dwell = (theta > radians(80.05)) & (theta < radians(129.95))
        np.testing.assert_allclose(column[dwell], 14.0 if order == 0 else 0.0, atol=1e-5)


def test_a_swing_has_its_derivatives_in_rad(tmp_path):
    text = FEEDER.replace("to_mm", "to_deg").replace('kind = "roller"', 'kind = "swinging_roller"')
    text = text.replace("offset_mm = 8.0", "arm_mm = 70.0\ncentre_distance_mm = 85.0\nlifts = 'against'")
    cam = Design.from_toml(text).cam()
    cam.write(tmp_path, formats=["csv"])
    head = (tmp_path / "feeder_actual.csv").read_text(encoding="ascii").splitlines()[0]
    assert "swing_deg,velocity_rad_per_rad,acceleration_rad_per_rad2,jerk_rad_per_rad3" in head
    assert {check.unit for check in cam.figures if check.code.value.startswith("motion-")} == {
        "rad/s",
        "rad/s²",
        "rad/s³",
    }


@pytest.mark.parametrize("law", ["polynomial_3_4_5", "modified_sine", "cycloidal", "modified_trapezoid", "gutman_1_3"])
def test_the_made_outline_has_the_velocity_and_acceleration_of_the_law(law):
    """Rolled at 0.1° and differentiated by quintics through windows of 0.6° without a seam: 1e-4 of v, 1e-3 of a."""
    cam = feeder(**{"motion.segments.1.law": law, "motion.segments.3.law": law}).cam()
    theta = np.radians(np.arange(0.0, 360.0, 0.1))
    rolled, _ = roll_curve(cam.curve, cam.follower, theta)
    half, step = 3, radians(0.1)
    fit = np.linalg.pinv(np.vander(np.arange(-half, half + 1) * step, 6, increasing=True))
    windows = np.lib.stride_tricks.sliding_window_view(rolled.lift, 2 * half + 1)
    middle = theta[half:-half]
    velocity, acceleration = windows @ fit[1], 2 * windows @ fit[2]
    away = np.abs(middle[:, None] - cam.motion.breaks).min(axis=1) > (half + 0.5) * step
    exact = cam.motion.jets(middle)
    off = [
        np.abs(found - exact[:, order])[away].max() / np.abs(exact[:, order]).max()
        for order, found in ((1, velocity), (2, acceleration))
    ]
    print(f"v {off[0]:.1e}, a {off[1]:.1e} of their peaks")
    assert off[0] < 1e-4
    assert off[1] < 1e-3


def test_sentences_of_a_motion_have_chinese():
    cam = feeder(**{"motion.segments.3.law": "simple_harmonic"}).cam()
    (held,) = cam.verdict.reservations
    said = Message(held.text).translated("zh")
    assert "加速度" in said
    assert "突变" in said
    assert all(note.translated("zh") != note for note in cam.notes)
