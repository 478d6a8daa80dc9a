"""How keys must fit each other: each rule on both sides of its bound."""

from itertools import combinations
from math import cos, hypot, radians, sin
from typing import Any, get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from cadgen.cam.followers.rod_kind import ROD
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS
from cadgen.car.path.path_kinds import B_SPLINE, codes
from cadgen.car.path.spline import DEGREE, MIN_WAYPOINTS, SplineKind
from cadgen.design.blank import BlankSection, LighteningSection
from cadgen.design.follower import section_of
from cadgen.design.keys import keys
from cadgen.design.kinds import Kinds
from cadgen.design.schema import CamSection, Checks, DesignFile


def accepted(section: type, **values: Any) -> bool:
    try:
        section.model_validate(values)
    except ValidationError:
        return False
    return True


FACES = {"inner_face_mm": 23.5, "outer_face_mm": 26.5, "mid_plane_mm": 25.0, "thickness_mm": 3.0}


@pytest.mark.parametrize("pair", list(combinations(FACES, 2)), ids="+".join)
def test_any_two_keys_give_the_same_faces(pair: tuple[str, str]) -> None:
    cam = CamSection(base_radius_mm=70.0, **{name: FACES[name] for name in pair})
    assert cam.faces_mm == (23.5, 26.5)


@pytest.mark.parametrize("count", [0, 1, 3, 4])
def test_any_other_number_of_keys_is_refused(count: int) -> None:
    for names in combinations(FACES, count):
        assert not accepted(CamSection, base_radius_mm=70.0, **{name: FACES[name] for name in names})


def test_values_cannot_be_changed() -> None:
    cam = CamSection(base_radius_mm=70.0, mid_plane_mm=25.0, thickness_mm=3.0)
    with pytest.raises(ValidationError):
        cam.base_radius_mm = 71.0  # type: ignore[misc]


def test_rod_must_be_thinner_than_the_way_to_the_disc_and_reach_across_it(minimal: dict[str, Any]) -> None:
    for rod, fits in [
        ({"radius_mm": 23.4}, True),
        ({"radius_mm": 23.5}, False),
        ({"radius_mm": 2.5, "length_mm": 26.6}, True),
        ({"radius_mm": 2.5, "length_mm": 26.5}, False),
    ]:
        assert accepted(DesignFile, **{**minimal, "name": "x", "follower": rod}) is fits


KEYWAY = {"width_mm": 3.0, "depth_mm": 1.4}
REACH_OF_KEYWAY = hypot(4.0 + 1.4, 1.5)  # its far corner
SCREW = {"hole_diameter_mm": 2.5, "height_mm": 3.0}


@pytest.mark.parametrize(
    ("blank", "fits"),
    [
        ({}, True),
        ({"keyway": KEYWAY}, True),
        ({"keyway": {**KEYWAY, "width_mm": 7.99}}, True),
        ({"keyway": {**KEYWAY, "width_mm": 8.0}}, False),
        ({"d_flat": {"across_mm": 7.0}}, True),
        ({"d_flat": {"across_mm": 8.0}}, False),
        ({"d_flat": {"across_mm": 4.0}}, False),
        ({"d_flat": {"across_mm": 7.0}, "keyway": KEYWAY}, False),
        ({"hub": {"diameter_mm": 8.1, "length_mm": 6}}, True),
        ({"hub": {"diameter_mm": 8.0, "length_mm": 6}}, False),
        ({"hub": {"diameter_mm": 2 * REACH_OF_KEYWAY + 0.01, "length_mm": 6}, "keyway": KEYWAY}, True),
        ({"hub": {"diameter_mm": 2 * REACH_OF_KEYWAY - 0.01, "length_mm": 6}, "keyway": KEYWAY}, False),
        ({"hub": {"diameter_mm": 16, "length_mm": 6, "set_screw": SCREW}}, True),
        ({"hub": {"diameter_mm": 16, "length_mm": 4.25, "set_screw": SCREW}}, False),
        ({"hub": {"diameter_mm": 16, "length_mm": 6, "set_screw": {**SCREW, "height_mm": 1.25}}}, False),
        (
            {
                "hub": {
                    "diameter_mm": 16,
                    "length_mm": 60,
                    "set_screw": {"hole_diameter_mm": 8, "height_mm": 30},
                }
            },
            False,
        ),
        ({"hub": {"diameter_mm": 16, "length_mm": 6, "side": "left"}}, False),
        ({"lightening": {"holes": 6, "hole_diameter_mm": 18, "circle_diameter_mm": 78}}, True),
        ({"lightening": {"holes": 1, "hole_diameter_mm": 18, "circle_diameter_mm": 26.1}}, True),
        ({"lightening": {"holes": 1, "hole_diameter_mm": 18, "circle_diameter_mm": 26.0}}, False),
        (
            {
                "lightening": {"holes": 2, "hole_diameter_mm": 18, "circle_diameter_mm": 42.0},
                "hub": {"diameter_mm": 24, "length_mm": 6},
            },
            False,
        ),
    ],
)
def test_parts_of_the_blank_fit_each_other(blank: dict[str, Any], fits: bool) -> None:
    assert accepted(BlankSection, **blank) is fits


@given(
    holes=st.integers(2, 40),
    circle=st.floats(1, 200),
    angle=st.floats(-360, 360),
    filled=st.sampled_from([0.5, 0.999, 1.001, 1.5]),
)
def test_holes_are_refused_just_when_two_of_them_meet(holes: int, circle: float, angle: float, filled: float) -> None:
    turns = [radians(angle + 360 * n / holes) for n in range(holes)]
    centres = [(circle / 2 * cos(t), circle / 2 * sin(t)) for t in turns]
    apart = min(hypot(x1 - x2, y1 - y2) for (x1, y1), (x2, y2) in combinations(centres, 2))
    ring = {"holes": holes, "hole_diameter_mm": filled * apart, "circle_diameter_mm": circle, "angle_deg": angle}
    assert accepted(LighteningSection, **ring) is (filled < 1)


def test_the_schema_agrees_with_the_numeric_rooms() -> None:
    assert keys()["path.waypoints_mm"].allowed == f"{MIN_WAYPOINTS} or more"
    assert set(get_args(SplineKind)) < set(codes())
    assert keys(Kinds(path=B_SPLINE))["path.control_points_mm"].allowed == f"{DEGREE + 1} or more"
    for name in PRESSURE_ANGLE_LIMITS:
        assert Checks(pressure_angle_limit=name).pressure_angle_limit == name
    assert keys()["checks.pressure_angle_limit"].allowed.count('"') == 2 * len(PRESSURE_ANGLE_LIMITS)


def test_every_key_says_what_it_means_and_every_number_has_its_range() -> None:
    for key in keys().values():
        assert key.meaning, key.name
        if key.kinds[-1] not in ("text", "true or false"):
            assert "at most" in key.allowed + key.allowed_inside or "less than" in key.allowed, key.name


def test_a_rod_left_without_a_length_is_valid() -> None:
    assert section_of(ROD)(radius_mm=2.5).keys.length_mm is None
