"""`cadgen tolerance` of a cam by its motion: errors of the lift, yield, and what is refused."""

import json

import numpy as np
import pytest

from cadgen import Design
from cadgen.errors import DesignError

DESIGN = """
[motion]
turns = "counterclockwise"
segments = [
    { to_mm = 14.0, in_deg = 80.0, law = "polynomial_3_4_5" },
    { dwell_deg = 50.0 },
    { to_mm = 0.0, in_deg = 110.0, law = "modified_sine" },
    { dwell_deg = 120.0 },
]

[follower]
kind = "roller"
radius_mm = 9.0

[cam]
base_circle_radius_mm = 40.0
thickness_mm = 10.0

[lift_tolerances]
phase_deg = 0.1
limit_um = 20.0
law = "uniform"
"""


def test_a_phase_alone_has_the_yield_that_its_law_says(cadgen, tmp_path):
    """The greatest error is the greatest velocity times the phase, 15/8 of 14 mm in 80 degrees."""
    file = tmp_path / "feeder.toml"
    file.write_text(DESIGN)
    facts = json.loads(cadgen("tolerance", str(file), "--json", code=0).stdout)
    (cost,) = facts["costs"]
    greatest = 15 / 8 * 14 / 80 * 0.1 * 1e3
    assert cost["lift_um"] == pytest.approx(greatest, rel=1e-4)
    assert cost["lift_um_per_unit"] == pytest.approx(10 * greatest, rel=1e-4)
    assert cost["cam_angle_deg"] == pytest.approx(40, abs=0.2)
    assert facts["yield"] == pytest.approx(20 / greatest, abs=0.02)
    assert facts["lift_error_um"]["50 %"] == pytest.approx(greatest / 2, rel=0.03)
    said = cadgen("tolerance", str(file), "--seed", "2", code=0).stdout
    assert "phase of the disc" in said
    assert "of the cams pass" in said


def test_the_same_from_python_with_every_dimension():
    """Costs are sorted, and all at their limits are no more than their sum."""
    arm = """
[motion]
turns = "clockwise"
segments = [
    { to_deg = 12.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
    { to_deg = 0.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
]

[follower]
kind = "swinging_roller"
radius_mm = 9.0
arm_mm = 70.0
centre_distance_mm = 90.0
lifts = "against"

[cam]
base_circle_radius_mm = 35.0
thickness_mm = 8.0

[lift_tolerances]
base_circle_um = 10.0
roller_radius_um = 5.0
arm_um = 20.0
centre_distance_um = 20.0
eccentricity_um = 10.0
"""
    run = Design.from_toml(arm, "arm").lift_tolerance(2000)
    assert run.passed is None
    assert {cost.code for cost in run.costs} == {
        "base_circle",
        "roller_radius",
        "arm",
        "centre_distance",
        "eccentricity",
    }
    sizes = [cost.greatest for cost in run.costs]
    assert sizes == sorted(sizes, reverse=True)
    assert run.errors.max() <= run.worst <= sum(sizes)
    assert np.array_equal(run.errors, Design.from_toml(arm, "arm").lift_tolerance(2000).errors)


def test_what_does_not_fit_is_refused(cadgen, tmp_path):
    """A dimension that the follower lacks, nothing that varies, a car, and options of a car."""
    with pytest.raises(DesignError, match=r"lift_tolerances\.arm_um is for swinging_roller, and follower.kind is"):
        Design.from_toml(DESIGN + "arm_um = 5\n")
    bare = Design.from_toml(DESIGN.partition("[lift_tolerances]")[0])
    with pytest.raises(DesignError, match=r"give \[lift_tolerances\] half widths above 0"):
        bare.lift_tolerance()
    with pytest.raises(DesignError, match="this one is of a car"):
        Design.load("carbon_free_car").lift_tolerance()
    with pytest.raises(DesignError, match=r"\[lift_tolerances\] is for a design with \[motion\]"):
        Design.load("carbon_free_car", {"lift_tolerances.phase_deg": 1.0})
    file = tmp_path / "feeder.toml"
    file.write_text(DESIGN)
    assert "--budget is for a car" in cadgen("tolerance", str(file), "--budget", code=2).stderr
