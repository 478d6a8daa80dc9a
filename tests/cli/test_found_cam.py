"""Cams whose motion is found: the file, the design that is written, the new cam, and what is refused."""

import json

import numpy as np
import pytest

from cadgen import Design
from cadgen.errors import DesignError, FileError
from tests.studies import worn_cams_truth as truth

TURN = 2 * np.pi
DESIGN = """
[motion]
turns = "counterclockwise"
measured = true

[follower]
kind = "roller"
radius_mm = 9.0
offset_mm = 8.0

[cam]
thickness_mm = 10.0

[blank]
bore_diameter_mm = 12.0
"""
ROLLER = truth.Follower("roller", {"radius_mm": 9.0, "offset_mm": 8.0}, 32.0)
CAM = truth.Worn(
    (
        truth.Flank(0, 80, 0, 14, "polynomial_3_4_5", lambda u: 0.03 * np.sin(np.pi * np.clip(u, 0, 1)) ** 2),
        truth.Flank(130, 240, 14, 0, "modified_sine"),
    )
)
ARM = """
[motion]
turns = "clockwise"
measured = true

[follower]
kind = "swinging_roller"
radius_mm = 9.0
arm_mm = 70.0
centre_distance_mm = 90.0
lifts = "against"

[cam]
base_circle_radius_mm = 35.0
thickness_mm = 8.0
"""


def measured(start: float = 0.7) -> np.ndarray:
    """Points of the worn cam, off the origin and turned."""
    return truth.outline(CAM, ROLLER, 720, 3e-3, np.random.default_rng(3), centre=120 + 85j, start=start)


def test_a_worn_cam_of_unknown_motion_becomes_a_design_and_a_new_cam(cadgen, tmp_path):
    """Inches, semicolons and the measuring machine's own frame; the new outline is the old one before it was worn."""
    design, file, out = tmp_path / "feeder.toml", tmp_path / "points.csv", tmp_path / "out"
    design.write_text(DESIGN)
    rows = "\n".join(f"{x:.6f};{y:.6f}" for x, y in measured() / 25.4)
    file.write_text(f"X [in];Y [in]\n{rows}\n")
    facts = json.loads(cadgen("calibrate", str(design), str(file), "--json", "--out", str(out), code=0).stdout)
    assert facts["centre_mm"] == pytest.approx([120, 85], abs=5e-3)
    assert facts["base_circle_radius_mm"] == pytest.approx(32, abs=5e-3)
    assert facts["zero_deg"] == pytest.approx(90 + np.degrees(0.7), abs=0.02)  # the slide lies along +y
    assert [(s["law"], s["named"]) for s in facts["segments"]] == [("polynomial_3_4_5", True), ("modified_sine", True)]
    assert [s["wear_um"] for s in facts["segments"]] == pytest.approx([30, 0], abs=8)
    assert "as seen on the outer face. If it was" in " ".join((out / "feeder_motion.txt").read_text("utf-8").split())
    made = Design.load(out / "feeder_found.toml")
    assert [(s.to_mm, s.in_deg, s.law, s.dwell_deg) for s in made.values.motion.segments] == [
        (14.0, 80.0, "polynomial_3_4_5", None),
        (None, None, None, 50.0),
        (0.0, 110.0, "modified_sine", None),
        (None, None, None, 120.0),
    ]
    cam = made.cam()
    assert cam.computed.sound
    # Points of the new outline against the independent envelope, by polar angle; files show the inner face.
    theta = np.linspace(0, TURN, 20_001)
    point = (ROLLER.contact(CAM.lift, theta)[0] / 1j).conj()
    order = np.argsort(np.angle(point))
    new = cam.profile.points(2000)
    radius = np.interp(np.arctan2(new[:, 1], new[:, 0]), np.angle(point)[order], np.abs(point)[order], period=TURN)
    assert np.abs(radius - np.hypot(*new.T)).max() < 1e-4


def test_lifts_of_an_arm_show_its_swing() -> None:
    """Columns in memory, the arm's angle in degrees, a dial with a zero of its own."""
    arm = truth.Follower(
        "swinging_roller",
        {"radius_mm": 9.0, "arm_mm": 70.0, "centre_distance_mm": 90.0, "lifts": "against"},
        35.0,
    )
    cam = truth.Worn(
        (
            truth.Flank(0, 90, 0, np.radians(12), "cycloidal"),
            truth.Flank(120, 220, np.radians(12), 0, "simple_harmonic"),
        )
    )
    each = truth.lifts(cam, arm, 720, 4e-5, np.random.default_rng(4))
    design = Design.from_toml(ARM, "arm")
    found = design.find_motion({"cam_angle_deg": np.degrees(each[:, 0]), "lift_deg": np.degrees(each[:, 1]) + 3.0})
    assert found.named
    assert [(s.width, s.after, s.law) for s in found.stated.segments] == [
        (90.0, 12.0, "cycloidal"),
        (30.0, 12.0, ""),
        (100.0, 0.0, "simple_harmonic"),
        (140.0, 0.0, ""),
    ]
    assert found.base_circle is None
    assert "to_deg = 12.0" in found.toml
    assert found.cam.sound


def test_a_motion_without_a_law_is_given_by_points_and_exits_with_1(cadgen, tmp_path):
    """A law that no table has is said, and the new design follows the measured lift."""
    cam = truth.Worn(
        (truth.Flank(0, 80, 0, 14, "logistic in powers"), truth.Flank(130, 240, 14, 0, "cycloidal")), truth.STRANGE
    )
    each = truth.lifts(cam, ROLLER, 720, 3e-3, np.random.default_rng(5))
    file, design = tmp_path / "lift.csv", tmp_path / "strange.toml"
    design.write_text(DESIGN.replace("thickness", "base_circle_radius_mm = 32.0\nthickness"))
    np.savetxt(file, np.degrees(each) * [1, np.radians(1)], delimiter=",", header="angle,lift_mm", comments="")
    done = cadgen("calibrate", str(design), str(file), "--out", str(tmp_path / "out"), code=1)
    assert "no law of the table" in " ".join(done.stdout.split())
    made = Design.load(tmp_path / "out" / "strange_found.toml")
    theta = np.linspace(0, TURN, 361)
    lift = made.cam().computed.motion.q(theta)
    assert np.abs(lift - cam.lift(theta)).max() < 0.02


def test_laws_that_cannot_be_told_apart_are_named_with_their_difference(cadgen, tmp_path):
    """Ready with reservations, exit code 0."""
    cam = truth.Worn((truth.Flank(0, 80, 0, 6, "gutman_1_3"), truth.Flank(130, 240, 6, 0, "simple_harmonic")))
    each = truth.lifts(cam, ROLLER, 360, 8e-3, np.random.default_rng(6))
    file, design = tmp_path / "lift.csv", tmp_path / "noisy.toml"
    design.write_text(DESIGN.replace("thickness", "base_circle_radius_mm = 32.0\nthickness"))
    np.savetxt(file, np.degrees(each) * [1, np.radians(1)], delimiter=",", header="angle,lift_mm", comments="")
    said = " ".join(cadgen("calibrate", str(design), str(file), code=0).stdout.split())
    assert "undecided between" in said
    assert "gutman_1_3" in said
    assert "READY WITH RESERVATIONS" in said


def test_what_needs_the_motion_names_the_command_that_finds_it() -> None:
    """As `check` does, and every other command but `calibrate`."""
    design = Design.from_toml(DESIGN, "feeder")
    with pytest.raises(DesignError, match=r"motion\.measured is true: .* run cadgen calibrate"):
        design.cam()


def test_designs_and_files_that_do_not_fit_are_refused() -> None:
    """A stated motion, a rod, two records, two runs, and a follower that is too large for the disc."""
    points = measured()
    columns = {"x_mm": points[:, 0], "y_mm": points[:, 1]}
    stated = Design.from_toml(
        DESIGN.replace("measured = true", "points = [[0, 0], [60, 1], [120, 2], [180, 3], [240, 2], [300, 1]]").replace(
            "thickness", "base_circle_radius_mm = 32.0\nthickness"
        ),
        "feeder",
    )
    with pytest.raises(DesignError, match=r"motion\.measured = true"):
        stated.find_motion(columns)
    design = Design.from_toml(DESIGN, "feeder")
    with pytest.raises(FileError, match="2 files were given"):
        design.find_motion([columns, {**columns, "x_mm": points[:, 0] + 1}])
    with pytest.raises(FileError, match="has 2 runs"):
        design.find_motion({"run": [1] * 360 + [2] * 360, **columns})
    with pytest.raises(DesignError, match=r"motion has .*measured"):
        Design.from_toml(DESIGN.replace("measured = true", "measured = true\nsegments = [{dwell_deg = 360}]"))
