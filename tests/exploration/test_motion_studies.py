"""Studies of cams by their motion: figures against closed forms, what is refused, and a lift table that goes along."""

from math import asin, degrees, pi, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

from cadgen import Design, explore
from cadgen.design.load import complete_of, read_design
from cadgen.errors import DesignError
from cadgen.studies.study_figures import Evaluated, kind_of
from tests.docs.blocks import DOCS

STUDY = """
base = "roller"
objectives = ["disc_diameter_mm", "contact_pressure_MPa"]
record = ["pressure_angle_deg", "least_radius_mm", "camshaft_torque_Nmm"]
[plan]
kind = "full_factorial"
[[vary]]
key = "cam.base_circle_radius_mm"
values = [20.0, 63.7]
[[vary]]
key = "motion.segments.1.law"
values = ["polynomial_3_4_5", "modified_sine"]
"""


def evaluated(name, overrides=()):
    return Evaluated({}, lambda: complete_of(*read_design(name), overrides), None, 10, 1)


def figure(code, of):
    return kind_of(code).of(of)


def study(folder, text):
    (folder / "study.toml").write_text(text, encoding="utf-8")
    return explore(folder / "study.toml", folder / "results")


def test_figures_of_a_circle_off_its_shaft():
    """Radius 40 mm, 15 mm off; under a flat face m w² e cos + P + k s is the force, and nothing tilts."""
    cam = evaluated("eccentric", ["blank.material=steel"])
    assert figure("disc_diameter_mm", cam) == pytest.approx(110.0, abs=1e-4)
    assert figure("disc_mass_g", cam) == pytest.approx((pi * 40**2 - pi * 6**2) * 10 * 7.85e-3, rel=1e-6)
    assert figure("pressure_angle_deg", cam) == 0.0
    assert figure("least_radius_mm", cam) == pytest.approx(40.0, abs=1e-6)
    speed = 400 * 2 * pi / 60
    assert figure("least_force_N", cam) == pytest.approx(2.5 + 30.0 - 0.9 * 0.015 * speed**2, abs=1e-6)
    # Torque F s' with F = 2.5 + 15 (1 - cos) + m w² e cos; by hand on a fine grid.
    theta = np.radians(np.arange(0.0, 360.0, 0.01))
    force = 2.5 + 15 * (1 - np.cos(theta)) + 0.9 * 0.015 * speed**2 * np.cos(theta)
    assert figure("camshaft_torque_Nmm", cam) == pytest.approx(np.abs(force * 15 * np.sin(theta)).max(), rel=1e-6)
    # Two bodies of steel, one of them flat: p = sqrt(F E* / (pi b r)).
    modulus = 1 / (2 * (1 - 0.3**2) / 206_000)
    most = 2.5 + 0.9 * 0.015 * speed**2
    assert figure("contact_pressure_MPa", cam) == pytest.approx(sqrt(most * modulus / (pi * 10 * 40)), rel=1e-6)


def test_figures_of_a_groove_and_of_both_discs_of_a_pair():
    groove = evaluated("groove", ["blank.material=steel"])
    assert figure("pressure_angle_deg", groove) == pytest.approx(degrees(asin(1 / 3)), abs=1e-4)
    assert figure("disc_diameter_mm", groove) == 237.0
    # Round disc less bore and keyway, less the groove: its width times the length of the path of the roller's centre.
    theta = np.linspace(0, 2 * pi, 100_001)
    path = 25.4 * (3 - np.cos(theta)) * np.exp(1j * theta)
    key = 6 * (10 + 2.8) - (3 * sqrt(100 - 9) + 100 * asin(0.3))
    area = pi * (118.5**2 - 10**2) - key
    volume = 14 * area - 8 * 19.1 * np.abs(np.diff(path)).sum()
    assert figure("disc_mass_g", groove) == pytest.approx(volume * 7.85e-3, rel=2e-5)
    with pytest.raises(DesignError, match="this one has a groove"):
        figure("cutting_time_min", groove)
    pair = evaluated("conjugate_pair")
    assert figure("pressure_angle_deg", pair) > 20.29  # the second disc has the steeper place
    first, second = (disc.volume for disc in pair.plan.discs)
    assert figure("disc_mass_g", pair) == pytest.approx((first + second) * 7.85e-3, rel=1e-12)
    with pytest.raises(DesignError, match="it needs \\[dynamics\\]"):
        figure("camshaft_torque_Nmm", pair)


@pytest.mark.slow
@pytest.mark.long
def test_a_study_of_base_circle_and_law(tmp_path):
    """Rows are what check says of each design, and the best designs are files that are these designs."""
    made = study(tmp_path, STUDY)
    rows = list(made.rows())
    assert [row["state"] for row in rows] == ["kept"] * 4
    for row in rows:
        changes = {key: row[key] for key in ("cam.base_circle_radius_mm", "motion.segments.1.law")}
        cam = Design.load("roller", changes).cam()
        shown = {check.code.value: check.value for check in (*cam.verdict.checks, *cam.shown)}
        assert row["pressure_angle_deg"] == max(shown["pressure-angle-rise"], shown["pressure-angle-return"])
        assert row["least_radius_mm"] == shown["convex-radius-profile"]
        assert row["contact_pressure_MPa"] == shown["contact-pressure"]
        assert row["camshaft_torque_Nmm"] == max(shown["camshaft-torque-greatest"], -shown["camshaft-torque-least"])
    assert {row["number"] for row in made.front} == {1, 3}  # the modified sine presses less at either size
    written = made.write()
    best = next(file.path for file in written if file.name == "study_best_1.toml")
    assert Design.load(best).values.cam.base_circle_radius_mm in (20.0, 63.7)
    assert "# A roller on a slide" in Path(best).read_text(encoding="utf-8")


def test_a_lift_table_is_read_once_into_the_study(tmp_path):
    """Workers and best designs need the file no more: all angles and lifts stand in the base's own text."""
    (tmp_path / "lobe.csv").write_text((DOCS / "tutorial/lobe.csv").read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "lobe.toml").write_text(
        '# From a dial.\nname = "lobe"\n[motion]\nturns = "clockwise"\ntable = "lobe.csv"\nsmooth = true\n'
        '[follower]\nkind = "roller"\nradius_mm = 8.0\n[cam]\nbase_circle_radius_mm = 40.0\nthickness_mm = 8.0\n',
        encoding="utf-8",
    )
    text = STUDY.replace('"roller"', '"lobe.toml"').replace(', "contact_pressure_MPa"', "")
    text = text[: text.rindex("[[vary]]")].replace(', "camshaft_torque_Nmm"', "").replace("20.0, ", "30.0, ")
    made = study(tmp_path, text)
    (tmp_path / "lobe.csv").unlink()
    assert [row["state"] for row in made.rows()] == ["kept"] * 2
    best = next(file.path for file in made.write() if file.name == "study_best_1.toml")
    assert "# From a dial." in Path(best).read_text(encoding="utf-8")
    assert Design.load(best).cam().passed


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            '"pressure_angle_deg"',
            '"worst_end_mm"',
            r"record names worst_end_mm, which is of a design with ",
        ),
        ('"contact_pressure_MPa"', '"passed_percent"', r"objectives names passed_percent, .* has none: take disc_diam"),
        ("[plan]", '[[limits]]\nfigure = "drift_mm"\nmost = 3\n[plan]', r"limits names drift_mm, which is of a design"),
        (
            "[plan]",
            "[replan]\nwithin_mm = 3\n[plan]",
            r"\[replan\] plans the path of a car, and the base design roller",
        ),
        (
            '"roller"',
            '"carbon_free_car"',
            r"objectives names contact_pressure_MPa, which is of a design with \[motion\]",
        ),
        ('"modified_sine"', '"sine"', r'motion\.segments\.1\.law is "sine"; it must be'),
        ("[20.0, 63.7]", "[-1.0]", r"cam\.base_circle_radius_mm is -1\.0; it must be greater than 0"),
        ("cam.base_circle_radius_mm", "path.offset_mm", r"path"),
    ],
)
def test_what_a_study_of_a_motion_cannot_have_is_one_sentence(tmp_path, old, new, sentence):
    with pytest.raises(DesignError, match=sentence) as refused:
        study(tmp_path, STUDY.replace(old, new))
    assert "\n" not in str(refused.value)
    assert not (tmp_path / "results").exists()


def test_the_pressure_angle_of_a_car_is_that_of_its_checks():
    cam = evaluated("s_course")
    angles = [check.value for check in cam.plan.checks if check.code.value.startswith("pressure-angle")]
    assert figure("pressure_angle_deg", cam) == max(angles) > degrees(asin(sin(radians(1.0))))
