"""A kind of stage that is made up outside the package, in the documentation: friction discs, which have no teeth.

Their truth is by hand: the ratio is that of the diameters, the play that of the design, and a disc is a cylinder.
"""

import csv
import os
import re
from dataclasses import replace
from math import degrees, pi, radians

import pytest

from cadgen.design import gear_model, variation
from cadgen.design.load import load_design, load_train, train_of
from cadgen.errors import DesignError
from cadgen.gears import stage_kinds
from cadgen.gears.spur import SpurPair
from cadgen.gears.stage import PLAY_LIMIT_UM
from cadgen.geometry.solids.step_text import read_gear
from cadgen.jobs.calibration import cam_on_car
from cadgen.jobs.gears.gear_train import plan_gears
from tests.docs.blocks import DOCS, blocks
from tests.forks import MAIN

(SHOWN,) = [block.text for block in blocks(DOCS / "how-to/gear-kinds.md") if block.language == "python"]
KIND = SHOWN.partition("# The line that registers it")[0]
SCRIPT = f"{KIND}\nstage_kinds.register(FRICTION)\n{MAIN}"
MADE_UP: dict = {}
exec(KIND, MADE_UP)
FRICTION, FrictionDiscs = MADE_UP["FRICTION"], MADE_UP["FrictionDiscs"]
# Two stages, 20 to 60 and 25 to 75 mm: 9 turns of the drive for one of the output.
DISCS = """
[train]
bearing_span_mm = 80.0

[[train.stages]]
kind = "friction_discs"
driver_diameter_mm = 20.0
driven_diameter_mm = 60.0
width_mm = 6.0
press_N = 20.0
torque_Nmm = 150.0
creep_deg = 0.3

[[train.stages]]
kind = "friction_discs"
driver_diameter_mm = 25.0
driven_diameter_mm = 75.0
width_mm = 5.0
press_N = 40.0
torque_Nmm = 450.0
creep_deg = 0.2

[train.drive]
bore_diameter_mm = 5.0

[train.output]
bore_diameter_mm = 8.0
"""
# The first stage of the packaged train, in its place.
ONE = (
    "train.stages.1={kind = 'friction_discs', driver_diameter_mm = 12.0, driven_diameter_mm = 60.0, width_mm = 6.0, "
    "press_N = 30.0, torque_Nmm = 100.0, creep_deg = 0.1}"
)

MIXED = """
[train]
module_mm = 1.0
width_mm = 6.0
bearing_span_mm = 60.0

[[train.stages]]
centre_distance_mm = 40.0
driver = { teeth = 20 }
driven = { teeth = 60 }

[[train.stages]]
kind = "friction_discs"
driver_diameter_mm = 30.0
driven_diameter_mm = 60.0
width_mm = 5.0
press_N = 40.0
torque_Nmm = 100.0
creep_deg = 0.1
"""


def train_of_teeth(design):
    """Numbers of the train for a calibration."""
    return cam_on_car.ratios_and_teeth(design)


@pytest.fixture(scope="module", autouse=True)
def registered():
    stage_kinds.register(FRICTION)
    yield FRICTION
    stage_kinds.remove(FRICTION)


@pytest.fixture
def discs(tmp_path):
    file = tmp_path / "discs.toml"
    file.write_text(DISCS)
    return file


@pytest.fixture(scope="module")
def mixed():
    return load_design("carbon_free_car", [ONE])


@pytest.fixture
def gears(forks, discs, tmp_path):
    """Call `cadgen gears` on the discs in a process that has registered the kind."""

    def run(*arguments):
        env = {**os.environ, "COLUMNS": "100"}
        return forks.run(SCRIPT, "gears", str(discs), "--out", "out", *arguments, cwd=tmp_path, env=env)

    return run


@pytest.mark.slow
def test_the_command_takes_it_from_the_design_to_its_files(gears, tmp_path):
    result = gears()
    assert result.returncode == 0, result.stdout + result.stderr
    said = " ".join(result.stdout.split())
    assert "discs 20/60" in said
    assert "torque before the discs slip" in said
    assert "rim off 0.00000 µm" in said
    names = {path.name for path in (tmp_path / "out").iterdir()}
    parts = ("1_pinion", "2_cluster", "3_wheel")
    assert names >= {f"discs_as-given_{part}.{ending}" for part in parts for ending in ("step", "stl")}
    assert {"discs_as-given_train.step", "discs_as-given_parts.csv"} < names
    rows = list(csv.DictReader((tmp_path / "out" / "discs_as-given_parts.csv").read_text().splitlines()))
    assert [row["diameter_mm"] for row in rows] == ["20.0000", "60.0000", "25.0000", "75.0000"]
    wheel = (75.0**2 - 8.0**2) * pi / 4 * 5.0
    assert float(rows[-1]["part_volume_mm3"]) == pytest.approx(wheel, abs=1e-4)


def test_play_order_and_layout_go_by_diameters_and_creep(discs):
    plan = plan_gears(load_train(discs))
    assert plan.passed
    assert plan.play.train.ratio == 9
    facts = plan.facts()
    # The first stage's creep counts by the second one's ratio.
    assert facts["return_error_deg"]["greatest"] == pytest.approx(0.3 / 3 + 0.2)
    assert facts["return_error_deg"]["mean"] == pytest.approx(0.15)
    first, second, third = (part.axis for part in plan.layout.parts)
    assert (abs(second - first), abs(third - second)) == (pytest.approx(40.0), pytest.approx(50.0))
    torque = {check.code: check for check in plan.checks}["friction-torque"]
    # 0.4 * 20 * 30 = 240 of 150 N mm, and 0.4 * 40 * 37.5 = 600 of 450: the second has less in reserve.
    assert (torque.value, torque.place) == (pytest.approx(600.0), "stage 2")
    reordered = plan_gears(load_train(discs), "reordered")
    # 0.2 / 3 + 0.3 is worse: the order given is the better one.
    assert reordered.play.train == plan.play.train
    assert degrees(reordered.ranked[1].return_error_max) == pytest.approx(0.2 / 3 + 0.3)


def test_the_stage_that_slips_first_is_named_and_nothing_is_written(gears, tmp_path):
    """240 of 150 N mm hold; 600 of 700 do not, though they are more."""
    result = gears("--set", "train.stages.2.torque_Nmm=700")
    assert result.returncode == 1
    said = " ".join(result.stdout.split())
    assert "stage 2" in said[said.index("torque before the discs slip") :][:120]
    assert "press the discs on harder" in said
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_a_stage_of_discs_and_stages_of_teeth_make_one_train(mixed, tmp_path):
    plan = plan_gears(mixed)
    assert plan.passed, [check.name for check in plan.checks if not check.passed]
    first, *others = plan.layout.train.stages
    assert isinstance(first, FrictionDiscs)
    assert all(isinstance(stage, SpurPair) for stage in others)
    gears = plan_gears(load_design("carbon_free_car"))
    assert plan.play.stages[1:] == gears.play.stages[1:]
    later = float(others[0].ratio * others[1].ratio)
    difference = radians(0.1) - gears.play.stages[0].B_max
    assert plan.play.return_error_max - gears.play.return_error_max == pytest.approx(difference / later)


@pytest.mark.slow
def test_the_play_of_the_teeth_beside_discs_is_still_measured_in_the_file(tmp_path):
    design = train_of(MIXED, tmp_path / "mixed.toml")
    plan = plan_gears(design)
    assert plan.passed, [check.name for check in plan.checks if not check.passed]
    written = plan.write(tmp_path / "out", formats=["step", "csv"])
    files = written.entry["files"]
    whole = files["mixed_as-given_train.step"]
    spur, none = whole["play_error_um"]
    print(f"play of the teeth off by {spur:.4f} um")
    assert abs(spur) <= PLAY_LIMIT_UM
    assert (none, whole["return_error_error_um"]) == (None, None)
    # One part has teeth and a rim.
    cluster = files["mixed_as-given_2_cluster.step"]
    assert (cluster["rim_error_um"], cluster["flank_error_um"] < 0.001) == (0.0, True)
    rows = list(csv.DictReader((tmp_path / "out" / "mixed_as-given_parts.csv").read_text().splitlines()))
    assert [(row["teeth"], row["diameter_mm"]) for row in rows] == [
        ("20", ""),
        ("60", ""),
        ("", "30.0000"),
        ("", "60.0000"),
    ]


def test_a_rim_that_is_not_in_the_file_is_found(tmp_path, discs):
    """A disc whose size or height differs from that of the part."""
    plan = plan_gears(load_train(discs))
    plan.write(tmp_path, formats=["step"])
    file = tmp_path / "discs_as-given_3_wheel.step"
    (disc,) = plan.layout.parts[-1].gears
    assert read_gear(file, [disc], [0.0]).rim_error == 0.0
    assert read_gear(file, [replace(disc, diameter=75.002)], [0.0]).rim_error == pytest.approx(1e-3)
    assert read_gear(file, [disc], [0.5]).rim_error == pytest.approx(0.5)


def test_the_car_takes_its_play_as_that_of_any_train(mixed):
    plays = variation.train_plays(mixed)
    assert plays["as-given"].return_error_max > plays["reordered"].return_error_max > 0
    assert gear_model.train(mixed).ratio == 45


@pytest.mark.parametrize(
    ("job", "words"),
    [
        (
            lambda design: plan_gears(design, "search"),
            "the search is worked out for spur gears alone: take --order as-given or reordered",
        ),
        (train_of_teeth, "a calibration is worked out for spur gears alone: leave the kind out and give the stage"),
    ],
)
def test_what_is_for_spur_gears_alone_says_so(mixed, job, words):
    with pytest.raises(DesignError, match=f"^train.stages.1.kind names friction discs, and {words}"):
        job(mixed)


@pytest.mark.parametrize(
    ("override", "words"),
    [
        (
            "train.stages.2.press_N=",
            "train.stages.2.press_N is missing: add it, a number in N (by which the rims are pressed on each other)",
        ),
        ("train.stages.1.friction=3", "train.stages.1.friction is 3; it must be greater than 0 and at most 2"),
        (
            "train.stages.1.press=3",
            "train.stages.1.press is not a key: did you mean train.stages.press_N? [train.stages] takes kind,",
        ),
        ("train.stages.1.f_a_um=3", "[train.stages] takes kind, bearing_span_mm, direction_deg, driver_diameter_mm,"),
        (
            'train.stages.1.kind="belt"',
            'train.stages.1.kind is "belt"; it must be "spur", "planetary", "rack" or "friction_discs"',
        ),
        ("train.stages.1.kind=", "train.stages.1.press_N is not a key: [train.stages] takes kind, bearing_span_mm"),
        (
            "train.stages.1={centre_distance_mm = 40, driver.teeth = 20, driven.teeth = 60}",
            "train.module_mm is missing: add it, a number in mm (m_n, normal module)",
        ),
        (
            "train.grade=5",
            "train.grade is of spur gears, and no stage of this train has any: remove it",
        ),
        ("train.width=3", "train.width is not a key: write train.width_mm, in mm"),
        ("train.output.bore_diameter_mm=90", "on shaft 3 (output), the disc of 75 mm has a bore that reaches to 90 mm"),
    ],
)
def test_its_keys_are_checked_by_its_own_limits(discs, override, words):
    with pytest.raises(DesignError, match=re.escape(words)):
        plan_gears(load_train(discs, [override]))


def test_a_design_that_names_spur_gears_is_the_design_that_names_none():
    named, plain = load_design("carbon_free_car", ["train.stages.2.kind=spur"]), load_design("carbon_free_car")
    assert named.content_hash == plain.content_hash


def test_its_values_make_the_same_design_again(discs):
    design = load_train(discs)
    stage = design.values()["train"]["stages"][1]
    assert (stage["kind"], stage["driven_diameter_mm"]) == ("friction_discs", 75.0)
    assert load_train(discs, ["train.stages.2.friction=0.4"]).content_hash == design.content_hash
    assert load_train(discs, ["train.stages.2.friction=0.3"]).content_hash != design.content_hash


def test_a_kind_that_is_not_registered_is_refused(discs, registered):
    stage_kinds.remove(registered)
    try:
        with pytest.raises(DesignError, match=r'train.stages.1.kind is "friction_discs"; it must be "spur"'):
            load_train(discs)
    finally:
        stage_kinds.register(registered)


@pytest.mark.parametrize("code", ["spur", "friction_discs", "Two words", ""])
def test_a_code_is_unique_and_plain(code):
    with pytest.raises(DesignError, match="kind of stage"):
        stage_kinds.register(replace(FRICTION, code=code))
