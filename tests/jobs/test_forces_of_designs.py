"""The section [dynamics] in a design: checks with cures that were tried, figures, columns of the CSV, and bad input."""

import csv
import re

import numpy as np
import pytest

from cadgen import Design
from cadgen.errors import DesignError
from cadgen.viewer.page.charts import charts_of
from tests.jobs.test_motion_figures import FEEDER

NORTON = """
name = "norton"
[motion]
turns = "counterclockwise"
speed_rpm = 95.49296585513721
segments = [
    { to_mm = 10.0, in_deg = 90.0, law = "polynomial_3_4_5" }, { dwell_deg = 45.0 },
    { to_mm = 0.0, in_deg = 180.0, law = "polynomial_3_4_5" }, { dwell_deg = 45.0 } ]
[follower]
kind = "roller"
radius_mm = 12.5
[cam]
base_circle_radius_mm = 63.7
thickness_mm = 10.0
[dynamics]
mass_kg = 7.5
damping_N_s_per_m = 2.74
spring_rate_N_per_mm = 0.1
preload_N = 10.0
"""
SWING = """
[dynamics]
inertia_kgmm2 = 900.0
spring_rate_Nmm_per_rad = 18000.0
preload_Nmm = 2600.0
"""


def codes(cam):
    return {check.code.value: check for check in (*cam.verdict.checks, *cam.shown)}


def test_a_follower_that_leaves_is_not_ready_and_both_cures_work():
    design = Design.from_toml(NORTON)
    cam = design.cam()
    (failed,) = cam.failed
    assert failed.code.value == "normal-force-least"
    assert "the follower leaves the disc from 56.66° to 83.02°: set dynamics." in failed.advice
    cures = re.findall(r"(dynamics\.\w+) to ([\d.]+)", failed.advice)
    assert cures == [("dynamics.spring_rate_N_per_mm", "0.7965"), ("dynamics.preload_N", "16.48")]
    for key, value in cures:
        held = design.with_({key: float(value)}).cam()
        assert held.passed
        assert codes(held)["normal-force-least"].value == pytest.approx(0.0, abs=0.02)
    slow = design.with_({"motion.speed_rpm": codes(cam)["lift-off-speed"].value * 0.999})
    assert slow.cam().passed


def test_figures_and_facts_of_the_forces():
    cam = Design.from_toml(NORTON).cam()
    shown = codes(cam)
    assert shown["lift-off-speed"].value == pytest.approx(75.7687, abs=5e-4)
    assert shown["camshaft-torque-greatest"].value == pytest.approx(226.96, abs=5e-3)
    assert shown["camshaft-power-mean"].value == pytest.approx(5.95e-3, abs=5e-6)
    assert shown["contact-pressure"].value > 90
    facts = cam.facts()["forces"]
    assert facts["leaves_deg"] == [[pytest.approx(56.66, abs=5e-3), pytest.approx(83.02, abs=5e-3)]]
    assert facts["work_Nmm"] == pytest.approx(3.738, abs=5e-4)
    assert facts["peak_power_W"] == pytest.approx(2.27, abs=5e-3)


def test_the_table_of_contacts_has_force_and_torque(tmp_path):
    cam = Design.from_toml(NORTON).with_({"dynamics.preload_N": 20.0}).cam()
    cam.write(tmp_path, formats=["csv"])
    with (tmp_path / "norton_actual.csv").open(encoding="ascii") as text:
        rows = list(csv.DictReader(text))
    torque = np.array([float(row["camshaft_torque_Nmm"]) for row in rows])
    assert torque.max() == pytest.approx(codes(cam)["camshaft-torque-greatest"].value, rel=1e-5)
    force = np.array([float(row["normal_force_N"]) for row in rows])
    alpha = np.radians([float(row["pressure_angle_deg"]) for row in rows])
    speed = np.array([float(row["velocity_mm_per_rad"]) for row in rows])
    np.testing.assert_allclose(torque, force * np.cos(alpha) * speed, atol=2e-3 * np.abs(torque).max())


def test_the_page_has_curves_of_motion_and_forces():
    cam = Design.from_toml(NORTON).with_({"dynamics.preload_N": 20.0}).cam()
    charts = {chart.code: chart for chart in charts_of(cam)}
    assert list(charts) == ["lift", "velocity", "acceleration", "jerk", "force", "torque", "pressure", "curvature"]
    assert charts["acceleration"].unit == "mm/rad²"
    (curve,) = charts["torque"].curves
    assert max(curve.values) == pytest.approx(codes(cam)["camshaft-torque-greatest"].value, rel=1e-3)


def test_an_arm_takes_moments(tmp_path):
    text = FEEDER.replace("to_mm", "to_deg").replace('kind = "roller"', 'kind = "swinging_roller"')
    text = text.replace("offset_mm = 8.0", "arm_mm = 70.0\ncentre_distance_mm = 85.0\nlifts = 'against'")
    cam = Design.from_toml(text + SWING).cam()
    assert codes(cam)["normal-force-least"].passed
    assert codes(cam)["normal-force-greatest"].value > 2600 / 70
    with pytest.raises(DesignError, match=r"dynamics.mass_kg is not of a follower .* give inertia_kgmm2 instead"):
        Design.from_toml(text + SWING).with_({"dynamics.mass_kg": 1.0})
    with pytest.raises(
        DesignError, match=r"the weight of an arm needs .* dynamics.arm_mass_kg and dynamics.arm_centre_mm"
    ):
        Design.from_toml(text + SWING).with_({"dynamics.gravity_deg": 180.0})
    weight = {"dynamics.gravity_deg": 180.0, "dynamics.arm_mass_kg": 2.0, "dynamics.arm_centre_mm": 40.0}
    heavier = codes(Design.from_toml(text + SWING).with_(weight).cam())["normal-force-greatest"].value
    assert heavier - codes(cam)["normal-force-greatest"].value == pytest.approx(2 * 9.80665 * 40 / 70, rel=0.1)
    with pytest.raises(DesignError, match=r'dynamics.arm_mass_kg is of an arm, and a follower of kind "roller" slides'):
        Design.from_toml(NORTON).with_(weight)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"dynamics.inertia_kgmm2": 1.0}, 'of kind "roller", which slides: give mass_kg instead'),
        (
            {"dynamics.guide_friction": 0.1},
            "needs guide_friction and guide_length_mm together, and has",
        ),
        (
            {"dynamics.contact_width_mm": 11.0},
            "is longer than the disc is thick, or its groove deep: set it to 10 or less",
        ),
        ({"dynamics.load_N": 5.0, "dynamics.load_rows": [[0, 1], [90, 2]]}, "two for one value: remove load_N"),
        ({"dynamics.load_rows": [[0, 1], [90, 2], [80, 2]]}, "row 3 of the load is at 80 degrees, after one at 90"),
        ({"dynamics.load_rows": [[0, 1], [361, 2]]}, "the rows of the load reach over 361 degrees"),
        ({"dynamics.load": "none.csv"}, "dynamics.load is none.csv, and there is no such file"),
        ({"dynamics.mass_kg": -1.0}, "dynamics.mass_kg is -1.0; it must be at least 0 and at most 10000 (kg)"),
    ],
)
def test_bad_dynamics_are_refused(changes, words):
    with pytest.raises(DesignError, match=re.escape(words)):
        Design.from_toml(NORTON).with_(changes)


def test_a_guide_that_jams_fails_with_its_angle():
    guide = {"dynamics.guide_friction": 1.4, "dynamics.guide_length_mm": 20.0, "dynamics.overhang_mm": 60.0}
    cam = Design.from_toml(NORTON).with_({**guide, "dynamics.preload_N": 20.0}).cam()
    (failed,) = cam.failed
    assert failed.code.value == "guide-jams"
    assert "where the tangent of the pressure angle is 0.102" in failed.advice
    free = Design.from_toml(NORTON).with_({**guide, "dynamics.preload_N": 20.0, "dynamics.guide_friction": 0.2})
    assert free.cam().passed


def test_a_conjugate_pair_has_no_spring_and_does_not_leave():
    pair = {"follower.closure": "conjugate", "follower.second": {"radius_mm": 12.5, "span_mm": 160.0}}
    design = Design.from_toml(NORTON)
    with pytest.raises(DesignError, match=r"dynamics.spring_rate_N_per_mm is of a spring, and the follower is held by"):
        design.with_(pair)
    cam = design.with_({**pair, "dynamics.spring_rate_N_per_mm": None, "dynamics.preload_N": None}).cam()
    assert "normal-force-least" not in codes(cam)
    assert "lift-off-speed" not in codes(cam)
    facts = cam.facts()["forces"]
    assert "leaves_deg" not in facts
    assert facts["second_flank_deg"][0][0] == pytest.approx(45.0, abs=1.0)


def test_a_load_of_a_file_counts(tmp_path):
    (tmp_path / "load.csv").write_text("angle,load\n0,10\n180,30\n", encoding="utf-8")
    file = tmp_path / "norton.toml"
    file.write_text(NORTON + 'load = "load.csv"\n', encoding="utf-8")
    cam = Design.load(file).cam()
    assert cam.passed
    assert cam.facts()["forces"]["force_along_least_N"] > 0


def test_a_car_hears_where_its_force_stands():
    with pytest.raises(DesignError, match=r"\[dynamics\] is for a design with \[motion\], and the force on the"):
        Design.load("carbon_free_car").with_({"dynamics": {"mass_kg": 1.0}})
