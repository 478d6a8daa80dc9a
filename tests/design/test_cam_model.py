"""From a design to the numeric rooms: units, and what only they can refuse."""

from collections.abc import Callable
from dataclasses import fields, is_dataclass
from itertools import combinations
from math import pi, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cadgen.cam.envelope import actual_profile
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.parts.features import DFlat, Keyway

Tables = dict[str, Any]
Write = Callable[[str | bytes | Tables], Path]


def test_car_follower_and_faces_of_the_papers_table_1() -> None:
    design = load_design("carbon_free_car")
    car, follower = cam_model.car(design), cam_model.follower(design)
    assert (car.wheelbase, car.drive_wheel_offset, car.idle_wheel_offset) == (167, 37, 201)
    assert car.max_steering_angle == pytest.approx(35 * pi / 180, rel=1e-15)
    assert (follower.base_radius, follower.radius) == (70, 2.5)
    assert (follower.inner, follower.outer) == (25 - 3 / 2, 25 + 3 / 2)
    appendix = cam_model.follower(load_design("appendix_car"))
    assert (appendix.inner, appendix.outer, appendix.radius) == (25.1, pytest.approx(27.8), 2.5 / 2)


def test_the_blend_covers_its_degrees() -> None:
    lift = cam_model.lift(load_design(None, ["cam.blend_deg=18"]))
    assert lift.blend_start == pytest.approx(2 * pi * (1 - 18 / 360))


def test_a_track_at_hand_is_used() -> None:
    design = load_design()
    track = cam_model.track(load_design(None, ["path.offset_mm=100"]))
    at = np.linspace(0, 6, 50)
    assert not np.allclose(cam_model.lift(design, track).q(at), cam_model.lift(design).q(at))
    assert np.array_equal(cam_model.lift(design, cam_model.track(design)).q(at), cam_model.lift(design).q(at))


def test_limits_in_mm_and_rad() -> None:
    design = load_design(
        None,
        [
            "checks.pressure_angle_limit=chinese_texts_strict",
            "checks.lost_lift_limit_um=2",
            "follower.length_mm=",
        ],
    )
    limits = cam_model.check_limits(design)
    assert (limits.pressure_angle.rise, limits.pressure_angle.fall) == (radians(40), radians(70))
    assert limits.lost_lift == pytest.approx(0.002)
    assert limits.cutter_radius == 2
    assert limits.wall == 2
    assert limits.min_convex_radius == 0.5
    assert cam_model.leaning(design, "this").length == 2 * 26.5
    assert cam_model.leaning(load_design(), "this").length == 40


def test_the_blank_in_mm_and_rad() -> None:
    hub = ["blank.hub.diameter_mm=16", "blank.hub.length_mm=8", "blank.hub.side=inner"]
    screw = [f"blank.hub.set_screw.{key}" for key in ("hole_diameter_mm=2.5", "height_mm=4", "angle_deg=90")]
    blank = cam_model.blank(
        load_design(None, [*hub, *screw, "blank.keyway.angle_deg=45", "blank.lightening.angle_deg=30"])
    )
    assert blank.bore_diameter == 8
    assert blank.key == Keyway(width=3, depth=1.4, angle=pi / 4)
    assert blank.hub is not None
    assert (blank.hub.diameter, blank.hub.length, blank.hub.side) == (16, 8, "inner")
    assert blank.hub.set_screw is not None
    assert (blank.hub.set_screw.diameter, blank.hub.set_screw.height) == (2.5, 4)
    assert blank.hub.set_screw.angle == pytest.approx(pi / 2)
    assert blank.lightening is not None
    assert (blank.lightening.count, blank.lightening.start_angle) == (6, pytest.approx(pi / 6))
    assert (blank.lightening.hole_diameter, blank.lightening.circle_diameter) == (18, 78)


def test_a_d_bore_measures_across_what_the_design_says() -> None:
    blank = cam_model.blank(load_design(None, ["blank.keyway=", "blank.d_flat.across_mm=7.3"]))
    assert isinstance(blank.key, DFlat)
    # A caliper along the flat's normal: from the flat to the far side of the circle.
    along = blank.bore().outline(0.01).points[:, 0]
    assert np.ptp(along) == pytest.approx(7.3, abs=1e-5)


def test_a_bare_blank_has_a_round_bore_only() -> None:
    blank = cam_model.blank(load_design(None, ["blank="]))
    assert (blank.bore_diameter, blank.key, blank.hub, blank.lightening) == (8, None, None, None)


def test_everything_handed_on_is_a_frozen_dataclass() -> None:
    design = load_design()
    for stage in (
        cam_model.car,
        cam_model.follower,
        cam_model.track,
        cam_model.lift,
        cam_model.blank,
        cam_model.check_limits,
    ):
        made = stage(design)
        assert is_dataclass(made)
        with pytest.raises(AttributeError):
            setattr(made, fields(made)[0].name, None)


def refusal(*overrides: str) -> str:
    with pytest.raises(DesignError) as caught:
        cam_model.lift(load_design(None, overrides))
    message = str(caught.value)
    assert "\n" not in message
    return message


def test_two_equal_waypoints() -> None:
    message = refusal("path.waypoints_mm.4=[4230, 250]")
    assert "waypoints 3 and 4 are both (4230, 250)" in message
    assert "remove one" in message


def test_a_track_with_a_cusp_says_where() -> None:
    message = refusal("path.offset_mm=900")
    assert "cusp" in message
    assert "between waypoints" in message


def test_a_turn_tighter_than_the_steering_says_where() -> None:
    message = refusal("car.max_steering_angle_deg=5")
    assert "steering of 5 degrees" in message
    assert "between waypoints" in message
    assert "car.max_steering_angle_deg" in message


def test_a_rod_thicker_than_the_cams_smallest_radius() -> None:
    """The design alone allows it (12 < 15): only the lift tells that the rod comes nearer to the shaft."""
    design = load_design(None, ["cam.base_radius_mm=15", "follower.radius_mm=12"])
    with pytest.raises(DesignError, match=r"rod's radius is 12 mm.*follower\.radius_mm.*cam\.base_radius_mm"):
        actual_profile(cam_model.lift(design), cam_model.follower(design))


def test_a_path_that_crosses_itself_is_allowed(minimal: Tables, written: Write) -> None:
    minimal["path"]["waypoints_mm"] = [
        [0, 0],
        [2000, 0],
        [3200, 1000],
        [2200, 2200],
        [1000, 1200],
        [1200, -800],
        [2200, -2000],
    ]
    design = load_design(written(minimal))
    track = cam_model.track(design)
    walked = track.planned(np.linspace(0, track.length, 200))
    crossings = sum(
        _cross(walked[i], walked[i + 1], walked[j], walked[j + 1])
        for i, j in combinations(range(len(walked) - 1), 2)
        if j > i + 1
    )
    assert crossings == 1
    profile = actual_profile(cam_model.lift(design), cam_model.follower(design))
    assert profile.curve.area() > 0


def _cross(a: Any, b: Any, c: Any, d: Any) -> bool:
    def side(p: Any, q: Any, r: Any) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0
