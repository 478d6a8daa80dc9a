"""Variation among the cars of a design."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from cadgen.car.running.mechanics import MechanicsBand
from cadgen.design import cam_model, variation
from cadgen.design.as_built import AsBuiltSection
from cadgen.design.load import load_design, with_overrides
from cadgen.deviations.first_order import Expansion


def halves(*overrides: str, forces: MechanicsBand | None = None) -> dict[str, float]:
    found = variation.half_widths(load_design("carbon_free_car", overrides), forces)
    return {deviation.key: half for deviation, half in found.items()}


def test_what_is_left_out_does_not_vary():
    assert set(halves()) == {
        *("base_radius", "inner_face", "outer_face", "rod_radius", "profile_offset", "steering_zero", "wheelbase"),
        *("drive_wheel_offset", "wheel_radius", "cam_phase", "start_x", "start_y", "start_heading"),
    }


def test_the_fit_of_the_bore_adds_half_its_clearance_to_the_eccentricity():
    assert halves("blank.bore_fit=H7/g6")["eccentricity"] == pytest.approx(0.0145)
    both = halves("blank.bore_fit=H7/g6", "tolerances.eccentricity_mm=0.01")
    assert both["eccentricity"] == pytest.approx(0.0245)


def test_friction_and_drag_vary_within_their_bands(carbon_free_car):
    forces = MechanicsBand(follower=carbon_free_car.follower, friction=(0.05, 0.3), drag=(2.0, 2.0))
    acrylic = "blank.material=acrylic", "drawing.material="
    found = halves("tolerances.wobble_deg=0.1", "tolerances.temperature_K=5", *acrylic, forces=forces)
    assert found["friction"] == pytest.approx(0.125)
    assert "drag" not in found
    assert found["wobble"] == pytest.approx(radians(0.1))
    assert found["temperature"] == 5


def test_a_profile_for_a_measured_friction_is_made_for_its_mean_and_spread(carbon_free_car):
    sigma, given = 0.03, MechanicsBand(follower=carbon_free_car.follower, friction=(0.14, 0.26))
    of = [[car.friction for car in band.usual] for band in (given, replace(given, measured=True))]
    assert of[0] == [0.14, 0.26]
    assert (np.mean(of[1]), np.std(of[1])) == pytest.approx((0.2, sigma))
    well_known = replace(given, friction=(0.19, 0.21), measured=True)
    assert well_known.usual == well_known.corners


def test_a_measured_friction_says_so():
    friction = [{"name": "friction", "value": 0.2, "sigma": 0.03}]
    effect = {"effect": "sliding friction", "kind": "track", "place": "car", "values": friction}
    source = {"file": "track.csv", "kind": "track", "sha256": "0" * 64, "verdict": "traced"}
    as_built = AsBuiltSection.model_validate({"sources": [source], "effects": [effect]})
    built = load_design("carbon_free_car").model_copy(update={"as_built": as_built})
    known = variation.mechanics(built, cam_model.follower(built), cam_model.lift(built))
    assert known is not None
    assert known.measured
    assert known.friction == pytest.approx((0.14, 0.26))


def test_heat_goes_by_the_materials():
    plain, acrylic, whole = (
        variation.expansion(load_design("carbon_free_car", changes))
        for changes in (
            (),
            ("drawing.material=", "blank.material=acrylic"),
            ("drawing.material=", "blank.material=steel", "tolerances.frame_material=steel"),
        )
    )
    assert plain == Expansion()
    assert acrylic.disc > 2 * acrylic.frame > 2 * acrylic.rod > 0
    assert whole.disc == whole.frame


def test_the_parts_of_the_play_have_zones_of_their_own():
    keyed = "blank.joint=keyed", "blank.joint_clearance_least_um=5", "blank.joint_clearance_greatest_um=25"
    zones = variation.play_zones(load_design("carbon_free_car", keyed))
    assert zones["key of the cam"] == pytest.approx(0.02 / 4 / 2)
    assert set(zones) == {"play of the teeth", "key of the cam"}
    banded = load_design("carbon_free_car", ("play.least_deg=0.5", "play.greatest_deg=0.7"))
    assert variation.play_zones(banded) == {"play": pytest.approx(radians(0.1))}
    assert variation.play_zones(load_design("carbon_free_car", ("play.measured_deg=0.5",))) == {}


def test_a_trim_is_one_of_each_car_and_of_laps_what_moves_the_rod_as_the_base_radius_does():
    for name, taken in (("s_course", set()), ("figure_eight", {"profile_offset", "rod_radius"})):
        braked = load_design(name, ["optimize.hardware="])
        trimmed = with_overrides(braked, ['optimize.hardware=["trim"]'])
        before, after = (variation.tolerances(design) for design in (braked, trimmed))
        assert {each.key for each in before.half_widths.keys() - after.half_widths.keys()} == taken
        assert after.half_widths.items() <= before.half_widths.items()
        assert (before.trimmed, after.trimmed) == (False, name == "s_course")
        assert variation.half_widths(trimmed, None) == variation.half_widths(braked, None)
