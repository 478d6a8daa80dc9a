"""Backlash and thickness as the design asks for them: in the play as cut, its zone, and the inspection."""

import pytest

from cadgen import Design
from cadgen.errors import DesignError

PAIR = """
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 40.0

[[train.stages]]
driver = { teeth = 20 }
driven = { teeth = 60 }
"""


def stage_of(old="", new=""):
    assert old in PAIR
    (stage,) = (
        Design.from_toml(PAIR.replace(old, new) if old else PAIR, "pair", train_only=True).gears().layout.train.stages
    )
    return stage


@pytest.mark.parametrize("teeth", ["driven = { teeth = 60 }", "driven = { teeth = 60, internal = true }"])
@pytest.mark.parametrize("helix", ["", "helix_angle_deg = 20.0\n"])
def test_a_backlash_is_that_of_the_teeth_as_cut(teeth, helix):
    keys = f"{helix}backlash_um = 200.0\nbacklash_share = 0.3\n{teeth}"
    stage = stage_of("driven = { teeth = 60 }", keys)
    assert stage.backlash().pitch == pytest.approx(0.2, abs=1e-12)
    driver, driven = (wheel.tooth_thickness_deviation for wheel in stage.wheels)
    assert driver / (driver + driven) == pytest.approx(0.3)


def test_an_angle_and_a_gear_that_has_a_thickness_of_its_own():
    stage = stage_of("driver = { teeth = 20 }", "backlash_deg = 0.4\ndriver = { teeth = 20, E_sn_um = -30.0 }")
    assert stage.backlash().driven_angle == pytest.approx(0.4 * 3.141592653589793 / 180)
    assert stage.wheels[0].tooth_thickness_deviation == pytest.approx(-0.03)


def test_a_zone_of_the_designs_own_moves_play_and_limits():
    zone = "driver = { teeth = 20, E_sns_um = -80.0, T_sn_um = 20.0 }"
    stage, usual = stage_of("driver = { teeth = 20 }", zone), stage_of()
    play = stage.play()
    assert [play.driver.E_sns, play.driver.E_sni] == pytest.approx([-0.08, -0.1])
    assert stage.wheels[0].tooth_thickness_deviation == pytest.approx(-0.09)
    assert play.B_max - play.B_min < usual.play().B_max - usual.play().B_min
    figures = stage.wheel_figures()[0]
    assert figures.value("E_sns") == pytest.approx(-80.0)


@pytest.mark.parametrize(
    ("new", "said"),
    [
        (
            "backlash_um = 100.0\nbacklash_deg = 0.2\ndriver =",
            "backlash_um and backlash_deg are both given: remove one",
        ),
        ("backlash_share = 0.2\ndriver =", "give backlash_um"),
    ],
)
def test_keys_of_a_backlash_that_contradict_each_other(new, said):
    with pytest.raises(DesignError, match=said):
        stage_of("driver =", new)


def test_thicknesses_that_contradict_each_other():
    with pytest.raises(DesignError, match=r"driver\.E_sn_um and E_sns_um are both given"):
        stage_of("teeth = 20", "teeth = 20, E_sn_um = -30.0, E_sns_um = -20.0, T_sn_um = 10.0")
    with pytest.raises(DesignError, match="give T_sn_um"):
        stage_of("teeth = 20", "teeth = 20, E_sns_um = -20.0")
    both = PAIR.replace("teeth = 20", "teeth = 20, E_sn_um = -50.0").replace(
        "teeth = 60", "teeth = 60, E_sn_um = -50.0"
    )
    with pytest.raises(DesignError, match=r"remove driven\.E_sn_um"):
        Design.from_toml(both.replace("driver =", "backlash_um = 100.0\ndriver ="), "pair", train_only=True)


def test_small_gears_without_a_standard_have_the_zones_that_they_are_given():
    small = PAIR.replace("module_mm = 1.0", "module_mm = 0.2").replace("width_mm = 8.0", "width_mm = 2.0")
    with pytest.raises(DesignError, match="outside ISO 1328-1"):
        Design.from_toml(small, "small", train_only=True).gears()
    free = small.replace("bearing_span_mm", 'standard = "free"\nbearing_span_mm')
    zone = free.replace("driver = {", "backlash_um = 40.0\ndriver = { T_sn_um = 10.0,")
    train = Design.from_toml(zone, "small", train_only=True).gears()
    assert train.passed
    (stage,) = train.layout.train.stages
    play = stage.play()
    assert (play.B_max - play.B_min) * stage.driven_pitch_radius == pytest.approx(0.01)
    assert (play.B_max + play.B_min) / 2 * stage.driven_pitch_radius == pytest.approx(0.04, abs=1e-4)
