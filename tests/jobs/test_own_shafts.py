"""Shafts between with features of their own, [[train.shafts]]: parts, joints, sheets, search and refusals."""

from dataclasses import replace

import pytest

from cadgen import Design
from cadgen.errors import DesignError
from cadgen.gears.layout import Blanks
from cadgen.gears.synthesis import SearchLimits, fit_of, pairs_within
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub
from tests.gears.test_layout import train

TRAIN = (
    """name = "own"
[train]
module_mm = 0.5
width_mm = 4.0
bearing_span_mm = 60.0
drive = { bore_diameter_mm = 2.0 }
intermediate = { bore_diameter_mm = 2.0, material = "POM" }
output = { bore_diameter_mm = 4.0 }
"""
    + 3 * "[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 60 }\n"
)
OWN = """[[train.shafts]]
shaft = 3
bore_diameter_mm = 3.0
material = "brass"
joint = "keyed"
joint_clearance_greatest_um = 20
keyway = { width_mm = 1.0, depth_mm = 0.5 }
hub = { diameter_mm = 6.0, length_mm = 2.0 }
"""


def of(text: str) -> Design:
    return Design.from_toml(text, "own", train_only=True)


def test_the_shaft_of_a_number_has_its_own_features_and_the_others_those_between():
    plan = of(TRAIN + OWN).gears()
    bores = [part.blank.bore_diameter for part in plan.layout.on_shafts]
    assert bores == [2.0, 2.0, 3.0, 4.0]
    assert plan.layout.parts[2].blank.hub == Hub(diameter=6.0, length=2.0)
    assert [joint.name for joint in plan.loose] == ["key of wheel and pinion of shaft 3"]
    # 20 µm at the edge of the bore, 1.5 mm from its axis, through the last stage of 3.
    assert plan.loose[0].greatest == pytest.approx(0.02 / 1.5 / 3)
    assert [plan.making.shaft(number, 4).material for number in (1, 2, 3, 4)] == [None, "POM", "brass", None]
    assert "train.shafts.1.bore_fit" in plan.making.open_keys(4).values()
    assert "train.intermediate.bore_fit" in plan.making.open_keys(4).values()


def test_a_train_without_them_has_the_hash_of_before():
    """Regression: hash of this text by the program before the key was there."""
    assert of(TRAIN).sha256 == "fd05bf254597a08f66301bb88552a619d49342f2e8f42ead2488ec9a157f1559"


def test_a_cure_names_the_key_of_the_shaft():
    """Wheel 1 of 62 mm radius reaches the thick shaft 3, 61 mm off, unless that ends at its gears."""
    stages = "".join(
        f"[[train.stages]]\ndriver = {{ teeth = {one} }}\ndriven = {{ teeth = {other} }}\n"
        for one, other in ((20, 120), (40, 80), (30, 90))
    )
    text = TRAIN.partition("[[train.stages]]")[0] + stages + OWN.partition("material")[0].replace("3.0", "8.0")
    with pytest.raises(DesignError, match=r"train\.shafts\.1\.shaft_ends = true"):
        of(text).gears()
    assert of(text + "shaft_ends = true\n").gears().passed


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("shaft = 3", "shaft = 4", r"train\.shafts\.1\.shaft is 4, .* it must be 2 to 3"),
        ("shaft = 3", "shaft = 1", r"train\.shafts\.1\.shaft is 1; it must be at least 2 and at most 7"),
        ("[[train.shafts]]\nshaft = 3", "[[train.shafts]]\nshaft = 3\n[[train.shafts]]\nshaft = 3", "are both 3"),
        ("shaft = 3", 'shaft = 3\nbore_fit = "H99/h6"', r"train\.shafts\.1\.bore_fit"),
    ],
)
def test_refusals(old: str, new: str, said: str):
    with pytest.raises(DesignError, match=said):
        of((TRAIN + OWN).replace(old, new))


def test_the_search_asks_each_place_for_its_own_blank():
    """Places of pairs with one shaft of its own, against those of each shaft by itself."""
    limits = replace(SearchLimits.like(train((20, 60), (20, 60), (20, 60))), teeth=(18, 62), stages=3, modules=(0.5,))
    pairs = pairs_within(limits)
    thin, thick = Blank(bore_diameter=2.0), Blank(bore_diameter=9.0)
    usual = Blanks(drive=thin, intermediate=thin, output=thin)
    some, none = (
        fit_of(pairs, limits, each, 0.3).allowed for each in (replace(usual, own=((3, thick, False),)), usual)
    )
    every = fit_of(pairs, limits, replace(usual, intermediate=thick), 0.3).allowed
    # Wheels fit the thick shaft 3, small pinions of stage 3 do not; shaft 2 stays thin.
    assert (some[:2] == none[:2]).all()
    assert (some[2] == every[2]).all()
    assert every[1].sum() == every[2].sum() == some[2].sum() < none[2].sum()
