"""The section of the car as built: what it may say, what is refused, and what of it reaches the numeric rooms."""

from typing import Any

import pytest
from pydantic import ValidationError

from cadgen.design import cam_model
from cadgen.design.as_built import AsBuiltSection, SourceSection
from cadgen.design.load import load_design, with_overrides
from cadgen.errors import DesignError


def effect(kind: str, name: str, place: str, **values: float) -> dict[str, Any]:
    return {
        "effect": name,
        "kind": kind,
        "place": place,
        "values": [{"name": key, "value": value} for key, value in values.items()],
    }


ZERO = effect("track", "steering zero", "car", steering_zero_deg=0.55)


def refusal(*effects: dict[str, Any]) -> str:
    with pytest.raises(ValidationError) as caught:
        AsBuiltSection.model_validate({"effects": list(effects)})
    return str(caught.value)


def test_a_file_with_the_section_loads_and_says_the_same_again(written: Any, minimal: Any) -> None:
    source = {"file": "a.csv", "kind": "track", "sha256": "0" * 64, "verdict": "traced"}
    minimal["as_built"] = {"profile": "actual", "sources": [source], "effects": [ZERO]}
    design = load_design(written(minimal))
    assert design.as_built is not None
    assert design.values()["as_built"]["effects"][0]["values"] == ZERO["values"]  # type: ignore[index]
    assert design.content_hash != design.as_designed().content_hash
    smaller = with_overrides(design, ["as_built.effects.1.values.1.value=0.3"])
    assert cam_model.car(smaller).steering_zero == pytest.approx(0.3 * 3.141592653589793 / 180)
    assert cam_model.car(with_overrides(design, ["as_built="])).steering_zero == 0
    assert cam_model.car(with_overrides(design, ["as_built.effects.1.place=noted"])).steering_zero == 0


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (effect("track", "steering zeroe", "car", steering_zero_deg=0.1), "write steering zero"),
        (effect("track", "steering zero", "part", steering_zero_deg=0.1), 'place is "part"; it must be car or noted'),
        (effect("lift", "lever gain", "car", gain_percent=1.0), 'place is "car"; it must be noted'),
        (effect("track", "steering zero", "car", steering_zero_deg=7.0), "lies between -5 and 5"),
        (effect("track", "steering zero", "car", zero_deg=1.0), "it must have steering_zero_deg, once each"),
        (
            effect("profile", "worn nose", "part", worn_depth_um=9.0, worn_width_deg=4.0),
            "worn_width_deg and nose_number",
        ),
        (
            effect("profile", "worn nose", "part", worn_depth_um=9.0, worn_width_deg=4.0, nose_number=1.5),
            "nose_number is 1.5; it must be a whole number from 1",
        ),
        (
            effect(
                "transmission", "runout of shaft 2", "car", runout_cos_deg=0.1, runout_sin_deg=0.0, turns_per_turn=2.5
            ),
            "turns_per_turn is 2.5; it must be a whole number from 1",
        ),
        (
            effect("transmission", "runout of shaft 2", "part", runout_cos_deg=0.1),
            'place is "part"; it must be noted or car',
        ),
        (
            effect("transmission", "tooth mesh of stage 3", "car", mesh_cos_deg=0.1),
            'place is "car"; it must be noted',
        ),
    ],
)
def test_what_cannot_be_is_refused_with_a_sentence(wrong: dict[str, Any], words: str) -> None:
    assert words in refusal(wrong)


def test_one_thing_of_the_car_is_set_once() -> None:
    track = effect("track", "backlash", "car", return_error_deg=0.8)
    zones = effect("zones", "return error", "car", return_error_deg=0.9)
    assert 'from backlash of kind track and from return error of kind zones: set place = "noted"' in refusal(
        track, zones
    )
    AsBuiltSection.model_validate({"effects": [track, {**zones, "place": "noted"}]})
    # Gears on several shafts run out.
    numbers = {"runout_cos_deg": 0.1, "runout_sin_deg": -0.1}
    gears = [
        effect("transmission", name, "car", **numbers, turns_per_turn=turns)
        for name, turns in (("runout of shaft 2", 3.0), ("runout of the camshaft", 1.0))
    ]
    AsBuiltSection.model_validate({"effects": gears})
    assert "has runout_cos_deg of the car twice" in refusal(gears[0], gears[0])
    # A disc may have one thing twice: the bore of the part, and the run-out of the shaft.
    part = effect("profile", "eccentric bore", "part", eccentric_x_um=30.0, eccentric_y_um=0.0)
    shaft = effect("lift", "eccentric bore", "car", eccentric_x_um=30.0, eccentric_y_um=0.0)
    AsBuiltSection.model_validate({"effects": [part, shaft]})


def test_noted_effects_need_no_numbers_of_the_catalogue() -> None:
    AsBuiltSection.model_validate({"effects": [effect("transmission", "runout of shaft 2", "noted", order=9.0)]})


def test_a_hash_that_is_none_is_refused() -> None:
    with pytest.raises(ValidationError, match="64 hexadecimal digits"):
        SourceSection(file="a.csv", kind="track", sha256="abc")


def test_a_worn_nose_keeps_its_number(written: Any, minimal: Any) -> None:
    worn = effect("profile", "worn nose", "part", nose_number=2, worn_depth_um=9.0, worn_width_deg=4.0)
    minimal["as_built"] = {"effects": [worn]}
    (placed,) = cam_model.as_built(load_design(written(minimal))).effects
    assert placed.effect.indices == (("nose_number", 2),)
    assert placed.values == pytest.approx((0.009, 0.0698131700797732))


def test_a_rod_that_vanishes_names_the_keys(written: Any, minimal: Any) -> None:
    minimal["follower"] = {"radius_mm": 1.0}
    minimal["as_built"] = {"effects": [effect("lift", "rod radius", "car", rod_radius_um=-1200.0)]}
    with pytest.raises(DesignError, match="correct rod_radius_um or axial_offset_um"):
        cam_model.follower(load_design(written(minimal)))
