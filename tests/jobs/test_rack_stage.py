"""Racks at the end of a train: play on sections, travel and reach by hand, files, refusals whose cure works."""

import re
from math import degrees, pi

import pytest

from cadgen import Design
from cadgen.errors import DesignError

TRAIN = """
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 60.0

[[train.stages]]
driver = { teeth = 20 }
driven = { teeth = 40 }

[[train.stages]]
kind = "rack"
driver = { teeth = 19, profile_shift = 0.3 }
rack = { teeth = 30 }

[train.drive]
bore_diameter_mm = 5.0

[train.intermediate]
bore_diameter_mm = 5.0
"""


def made(old="", new=""):
    assert old in TRAIN
    return Design.from_toml(TRAIN.replace(old, new) if old else TRAIN, "bar", train_only=True).gears()


@pytest.fixture(scope="module")
def train():
    return made()


def test_travel_and_play_through_the_train(train):
    assert train.passed, train.failed
    assert train.ratio == 2
    facts = train.facts()["stages"][1]
    assert facts["travel_per_turn_mm"] == pytest.approx(pi * 19)
    pair, rack = train.layout.train.stages
    assert degrees(rack.free_angle()) * pi / 180 * 9.5 == pytest.approx(facts["play_as_cut_um"] * 1e-3)
    assert train.return_error.as_cut == pytest.approx(pair.free_angle() + rack.free_angle())
    assert 0 < facts["play_least_um"] < facts["play_as_cut_um"] < facts["play_greatest_um"]
    assert "travels 59.6903 mm for one turn" in "".join(train.notes)


def test_the_bar_stands_before_its_pinion(train):
    """No volume in common is a check of the train; a space of the bar faces the pinion's tooth at mid width."""
    pinion, rack = train.layout.parts[1:]
    turn = rack.transform[:2, :2]
    assert turn[:, 1] @ [(pinion.axis - rack.axis).real, (pinion.axis - rack.axis).imag] == pytest.approx(9.8)
    along = turn[:, 0] @ [(pinion.axis - rack.axis).real, (pinion.axis - rack.axis).imag]
    assert abs(along - 15 * pi) < 2 * pi


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("helix", ["", 'helix_angle_deg = 20\nhand = "left"\n'])
def test_files_hold_its_play(helix, tmp_path):
    text = str(made("rack = {", f"{helix}rack = {{").write(tmp_path, formats=["step"]).entry)
    offs = re.search(r"'play_error_um': \(([^)]*)\)", text)[1].split(",")
    assert max(abs(float(off)) for off in offs) < 0.1
    assert re.search(r"'root_error_um'", text)


@pytest.mark.parametrize(
    ("old", "new", "words", "cure"),
    [
        ("teeth = 30 }", "teeth = 30 }\ntravel_mm = 100", r"give rack\.teeth = 35", ("teeth = 30 }", "teeth = 35 }")),
        ("teeth = 30 }", "teeth = 30 }\ndistance_mm = 12", r"do not meet at .*; give less than 11\.8000", ("12", "10")),
        (
            "teeth = 30 }",
            "teeth = 30 }\ndistance_mm = 9.7\nbacklash_um = 0",
            "raise backlash_um or distance_mm",
            ("backlash_um = 0", ""),
        ),
        (
            "bearing_span_mm = 60.0\n",
            "bearing_span_mm = 60.0\n[train.output]\nbore_diameter_mm = 3\n",
            "remove bore_diameter_mm",
            ("bore_diameter_mm = 3\n", ""),
        ),
    ],
)
def test_refusals_name_what_works(old, new, words, cure):
    text = TRAIN.replace(old, new)
    try:
        said = str([check.advice for check in Design.from_toml(text, "bar", train_only=True).gears().failed])
    except DesignError as error:
        said = str(error)
    assert re.search(words, said), said
    assert Design.from_toml(text.replace(*cure), "bar", train_only=True).gears().passed


def test_a_rack_is_held_as_a_gear_of_as_many_teeth():
    """ISO 1328-1:1995, tables 1 to 3, for grade 7, d over 20 up to 50 mm, m over 0.5 up to 2, b over 4 up to 10 mm."""
    stage = made().layout.train.stages[-1]
    assert stage.grades[1] == 7
    printed = {"f_pt": 10.0, "F_p": 29.0, "F_alpha": 10.0, "F_beta": 13.0}
    assert {symbol: round(value * 1e3, 1) for symbol, value in stage.rack_tolerances.items()} == printed
    bar = stage.wheel_figures()[1]
    assert {symbol: bar.value(symbol) for symbol in printed} == pytest.approx(printed)
    finer = made("rack = { teeth = 30", "rack = { grade = 5, teeth = 30").layout.train.stages[-1]
    assert finer.rack_tolerances["f_pt"] == pytest.approx(0.005)
    free = made("bearing_span_mm = 60.0\n", 'bearing_span_mm = 60.0\nstandard = "free"\n').layout.train.stages[-1]
    assert free.rack_tolerances == {}


def test_a_rack_ends_the_train_and_turns_no_cam():
    last = TRAIN.partition("[[train.stages]]\nkind")[2].partition("[train.drive]")[0]
    swapped = TRAIN.replace(f"[[train.stages]]\nkind{last}", "").replace(
        "[[train.stages]]\ndriver", f"[[train.stages]]\nkind{last}[[train.stages]]\ndriver"
    )
    with pytest.raises(DesignError, match=r"stage 1 has the rack of 30 teeth, .*make it the last one"):
        Design.from_toml(swapped, "bar", train_only=True).gears()
    stage = "train.stages.3={kind = 'rack', driver = {teeth = 19}, rack = {teeth = 30}}"
    with pytest.raises(DesignError, match="is a rack, which turns no camshaft"):
        Design.load("carbon_free_car", [stage]).gears()
