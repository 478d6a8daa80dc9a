"""Planetary stages and reverted trains from the design file to files; oracles are kinematics by hand and solids."""

import re
from fractions import Fraction

import numpy as np
import pytest

from cadgen import Design
from cadgen.car.assembly.turning_train import turning_train
from cadgen.errors import DesignError
from cadgen.geometry.meshes.car_meshes import stood
from cadgen.geometry.meshes.mesh import body_mesh

HEAD = """
[train]
module_mm = 1.0
width_mm = 6.0
bearing_span_mm = 80.0
"""
PAIR = """
[[train.stages]]
driver = { teeth = 20 }
driven = { teeth = 40 }
"""
SET = """
[[train.stages]]
kind = "planetary"
sun = { teeth = 18 }
planet = { teeth = 27, count = 3, bore_diameter_mm = 4 }
"""
SHAFTS = """
[train.drive]
bore_diameter_mm = 4.0
[train.output]
bore_diameter_mm = 6.0
"""


def design(*parts):
    return Design.from_toml("".join((HEAD, *parts)), "set", train_only=True)


def held(member):
    return SET.replace(
        "sun = {",
        f'held = "{member}"\nsun = {{ bore_diameter_mm = 5, ' if member == "sun" else f'held = "{member}"\nsun = {{',
    )


@pytest.fixture(scope="module")
def whole():
    return design(SET, SHAFTS).gears()


@pytest.mark.slow
@pytest.mark.long
def test_its_files_hold_its_play(whole, tmp_path):
    text = str(whole.write(tmp_path, formats=["step", "csv"]).entry)
    assert abs(float(re.search(r"'play_error_um': \(([-.\d]+),\)", text)[1])) < 0.1
    assert {path.name for path in tmp_path.glob("*ring*")} == {"set_stage1_ring.step"}


def test_a_set_is_made_with_carrier_and_planets_as_bodies(whole):
    train = whole
    assert train.passed, train.failed
    assert train.ratio == 5
    assert [part.name for part in train.layout.parts] == [
        *("1_pinion", "2_carrier", "stage1_planet_1", "stage1_planet_2", "stage1_planet_3", "stage1_ring")
    ]
    facts = train.facts()["stages"][0]
    assert facts["planet_angles_deg"] == pytest.approx([0, 120, 240])
    # Planets that differ leave the carrier less room than equal ones, and no less than the worst of all.
    differ = facts["play_of_planets_that_differ_deg"]
    middle = (facts["return_error_least_deg"] + facts["return_error_greatest_deg"]) / 2
    assert facts["return_error_least_deg"] <= differ["least"] < differ["mean"] < middle


@pytest.mark.parametrize(
    ("member", "ratio", "sense"), [("ring", Fraction(5), 1), ("carrier", Fraction(4), -1), ("sun", Fraction(5, 4), 1)]
)
def test_ratios_with_their_sign_and_bodies_that_turn_without_meeting(member, ratio, sense):
    """Sun, planets, ring and carrier turned by the law of the page: their solids never have a volume in common."""
    train = design(held(member)).gears()
    assert train.passed, train.failed
    assert (train.ratio, train.layout.train.sense) == (ratio, sense)
    turning = turning_train(train.layout, 0.0, 0.0, 1)
    parts = [*turning.parts, *turning.beside]
    meshes = [stood(each.stand, 2e-3).solid() for each in parts]
    for motor in (0.0, 0.35, 1.3):
        placed = []
        for each, mesh in zip(parts, meshes, strict=True):
            axis = each.axis
            if each.carrier is not None:
                carrier = turning.parts[each.carrier]
                axis = carrier.axis + (axis - carrier.axis) * np.exp(1j * (carrier.rate * motor + carrier.lead / 2))
            c, s = np.cos(each.angle_at(motor, 0.5)), np.sin(each.angle_at(motor, 0.5))
            placed.append(mesh.transform(np.array([[c, -s, 0, axis.real], [s, c, 0, axis.imag], [0, 0, 1, 0]])))
        common = [(a ^ b).volume() for i, a in enumerate(placed) for b in placed[:i]]
        assert max(common) < 1e-6


def test_a_train_of_kinds_multiplies_ratios_and_adds_plays():
    ends = SHAFTS.replace("mm = 4.0", "mm = 4.0\nshaft_ends = true").replace("mm = 6.0", "mm = 6.0\nshaft_ends = true")
    train = design(PAIR, SET, PAIR.replace("40", "30"), ends).gears()
    assert train.passed, train.failed
    assert train.ratio == 15
    first, middle, last = train.layout.train.stages
    sum_by_hand = first.free_angle() / 7.5 + middle.free_angle() / 1.5 + last.free_angle()
    assert train.return_error.as_cut == pytest.approx(sum_by_hand)


def test_helical_sets_with_unequal_angles_behind_a_pair():
    text = held("carrier").replace("18", "17, profile_shift = 0.2").replace("27", "25")
    text += 'ring = { teeth = 68 }\nspacing = "nearest"\nhelix_angle_deg = 20.0\nhand = "left"\n'
    train = design(PAIR, text).gears()
    assert train.passed, train.failed
    said = "".join(train.notes)
    assert "118.5882°" in said
    assert "profile shift 0.3" in said


@pytest.mark.parametrize(
    ("old", "new", "words", "cure"),
    [
        ("count = 3", "count = 4", "(planet.count) = 2 or 3, or spacing", ("count = 4", "count = 3")),
        ("count = 3", "count = 5", "(planet.count) = 1 or 2 or 3", ("count = 5", "count = 2")),
        ("teeth = 18 }", "teeth = 18 }\nring = { teeth = 90 }", "give the ring about 72 teeth", ("90", "72")),
        ("teeth = 18", "teeth = 18, E_sn_um = -30", "E_sn_um all three, or none", (", E_sn_um = -30", "")),
        (
            "teeth = 18 }",
            "teeth = 18 }\npin_place_um = 200\nbacklash_um = 100",
            "raise backlash_um, or lower pin_place_um",
            ("pin_place_um = 200\nbacklash_um = 100", "pin_place_um = 200"),
        ),
    ],
)
def test_refusals_name_what_works(old, new, words, cure):
    assert old in SET
    text = SET.replace(old, new)
    try:
        said = str([check.advice for check in design(text).gears().failed])
    except DesignError as error:
        said = str(error)
    assert words in said
    assert design(text.replace(*cure)).gears().passed


def test_features_that_cut_into_the_pins_of_a_carrier_are_refused():
    output = "[train.output]\nbore_diameter_mm = 4\nhub = {{ diameter_mm = {hub}, length_mm = 5 }}\n"
    with pytest.raises(DesignError, match=r"the carrier of 3 planets has a hub of 44 mm .*; give 4\.8 to"):
        design(SET, output.format(hub=44)).gears()
    with pytest.raises(DesignError, match="has a web, and its plate holds the pins of the planets; remove web"):
        design(SET, output.format(hub=12) + "web = { thickness_mm = 1, rim_mm = 3 }\n").gears()
    assert design(SET, output.format(hub=12)).gears().passed


def test_shafts_that_are_in_the_way_are_told_to_end():
    with pytest.raises(DesignError, match=r"shaft 1 itself and .* give train\.drive\.shaft_ends = true"):
        design(PAIR, SET, SHAFTS).gears()
    assert design(PAIR, SET, SHAFTS.replace("mm = 4.0", "mm = 4.0\nshaft_ends = true")).gears().passed


REVERTED = PAIR.replace("driver", "direction_deg = {first}\ncentre_distance_mm = 40\ndriver", 1).replace("40 }", "60 }")


def test_a_reverted_train_has_its_output_on_the_axis_of_the_drive():
    text = REVERTED.replace("{first}", "0")
    back = REVERTED.replace("{first}", "180").replace("20 }", "16 }").replace("60 }", "64 }")
    train = design(text, back, SHAFTS).gears()
    assert train.passed, train.failed
    first, _, last = train.layout.parts
    assert abs(first.axis - last.axis) < 1e-9
    # The shafts end at their parts, which stand clear of each other.
    top = first.height
    assert last.height - top > 0.3
    # Directions that are found put no two shafts on one axis.
    free = design(text.replace("direction_deg = 0", ""), back.replace("direction_deg = 180", ""), SHAFTS).gears()
    axes = [part.axis for part in free.layout.parts]
    assert min(abs(a - b) for i, a in enumerate(axes) for b in axes[:i]) > 1.0


def test_volumes_are_those_of_the_meshes(whole):
    for part in whole.layout.parts:
        assert body_mesh(part.body, 1e-3).solid().volume() == pytest.approx(part.volume, rel=3e-4)
