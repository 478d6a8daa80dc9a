"""Keys of the course: each rule on both sides of its bound, and the sentence with key and cure."""

import copy
import re

import pytest
import tomli_w

from cadgen.car.path_motion import PathMotion
from cadgen.design import cam_model
from cadgen.design.course import body_of, layout_of
from cadgen.design.load import load_design, with_overrides
from cadgen.errors import DesignError
from cadgen.jobs.cam.course import on_course

OUTLINE = {"length_mm": 260, "width_mm": 260, "front_overhang_mm": 60}
PLAIN = {
    "path": {"waypoints_mm": [[0, 0], [1500, 200], [2600, 1200], [4000, 1500], [5500, 1000]]},
    "car": {"wheelbase_mm": 167.0, "drive_wheel_offset_mm": 37.0, "idle_wheel_offset_mm": 201.0, "outline": OUTLINE},
    "cam": {"base_radius_mm": 70.0, "mid_plane_mm": 25.0, "thickness_mm": 3.0},
    "follower": {"radius_mm": 2.5},
}


def load(tmp_path, course, **sections):
    values = {**copy.deepcopy(PLAIN), "course": course, **sections}
    (tmp_path / "c.toml").write_text(tomli_w.dumps(values))
    return load_design(tmp_path / "c.toml")


BAD = {
    "self-crossing field": ({"field": {"outline_mm": [[0, 0], [1, 1], [1, 0], [0, 1]]}}, r"field\.outline_mm crosses"),
    "self-crossing zone": (
        {"zones": [{"outline_mm": [[0, 0], [9, 0], [0, 0], [0, 9]]}]},
        r"zones\.1\.outline_mm cross",
    ),
    "missing radius": ({"posts": [{"at_mm": [1, 2]}]}, r"course\.posts\.1\.radius_mm is missing: add it"),
    "two starts": ({"start": [{"at_mm": [0, 0]}, {"at_mm": [1, 1]}]}, r"write \[course.start\]"),
    "disc and segment": ({"gates": [{"at_mm": [0, 0], "to_mm": [1, 1]}]}, r"course\.gates\.1 takes at_mm alone"),
    "radius of a segment": (
        {"gates": [{"from_mm": [0, 0], "to_mm": [9, 1], "radius_mm": 3}]},
        r"gates\.1\.radius_mm is given for a segment",
    ),
    "no field": ({"field": {}}, r"course\.field takes size_mm"),
    "no form of a zone": ({"zones": [{"at_mm": [0, 0]}]}, r"course\.zones\.1 takes at_mm and radius_mm"),
    "wall without length": ({"walls": [{"line_mm": [[1, 1], [1, 1]]}]}, r"course\.walls\.1\.line_mm is one point"),
    "slip": ({"margin": 3}, r"course\.margin is not a key: write course\.margin_mm"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_courses_are_refused_by_key_with_a_cure(name, tmp_path):
    course, message = BAD[name]
    with pytest.raises(DesignError, match=message) as refusal:
        load(tmp_path, course)
    assert "\n" not in str(refusal.value)


def test_an_outline_is_a_rectangle_or_a_polygon(tmp_path):
    car = {**PLAIN["car"], "outline": {"length_mm": 260, "width_mm": 260}}
    with pytest.raises(DesignError, match=r"car\.outline needs front_overhang_mm"):
        load(tmp_path, {}, car=car)
    car["outline"] = {**OUTLINE, "corners_mm": [[0, 0], [-9, 9], [-9, -9]]}
    with pytest.raises(DesignError, match=r"car\.outline has corners_mm and length_mm"):
        load(tmp_path, {}, car=car)
    car["outline"] = {"corners_mm": [[0, 0], [-200, 99], [-100, 99], [-200, -99]]}
    with pytest.raises(DesignError, match=r"car\.outline\.corners_mm crosses itself"):
        load(tmp_path, {}, car=car)
    design = load(tmp_path, {})
    body = body_of(design.car.outline, cam_model.car(design))
    # As wide to either side of the middle between the rear wheels, 82 to the right of the fork.
    assert body.corners == ((60.0, 48.0), (-200.0, 48.0), (-200.0, -212.0), (60.0, -212.0))


@pytest.mark.parametrize(
    ("course", "message"),
    [
        ({"posts": [{"at_mm": [120, -120], "radius_mm": 10}]}, r"course\.posts\.1 stands on the car at its start"),
        (
            {"zones": [{"corner_mm": [2000, 300], "size_mm": [900, 900]}], "gates": [{"at_mm": [2500, 700]}]},
            r"course\.gates\.1 lies in course\.zones\.1, where no car can pass",
        ),
        (
            {
                "walls": [{"line_mm": [[2000, 300], [4000, 300]], "thickness_mm": 200}],
                "gates": [{"at_mm": [2500, 300]}],
            },
            r"course\.gates\.1 lies in course\.walls\.1",
        ),
        ({"field": {"size_mm": [100, 100]}}, r"course\.field does not hold the car at its start"),
        (
            {"field": {"corner_mm": [-500, -500], "size_mm": [9000, 9000]}, "gates": [{"at_mm": [9999, 0]}]},
            r"course\.gates\.1 lies outside course\.field",
        ),
    ],
)
def test_courses_that_no_car_can_keep_are_refused(course, message, tmp_path):
    design = load(tmp_path, course)
    track = cam_model.track(design)
    on = on_course(design, track, cam_model.lift(design, track))
    with pytest.raises(DesignError, match=message):
        on.planned  # noqa: B018


def test_posts_need_an_outline(tmp_path):
    car = {key: value for key, value in PLAIN["car"].items() if key != "outline"}
    design = load(tmp_path, {"posts": [{"at_mm": [9, 9], "radius_mm": 1}]}, car=car)
    track = cam_model.track(design)
    lift: PathMotion = cam_model.lift(design, track)
    with pytest.raises(DesignError, match=r"car\.outline is missing, and posts of \[course\]"):
        on_course(design, track, lift).planned  # noqa: B018


def test_gates_are_given_once():
    with pytest.raises(DesignError, match=r"tolerances.gate_width_mm is 200, but the gates are those of"):
        load_design(None, ["tolerances.gate_width_mm=200"])
    design = load_design(None, ["tolerances.gate_width_mm=200", "course.gates="])
    assert design.tolerances.gate_width_mm == 200
    with pytest.raises(DesignError, match="field and course both say"):
        load_design(None, ["field.size_mm=[8000, 8000]"])


@pytest.mark.parametrize("name", ["appendix_car", "carbon_free_car", "workshop_car"])
def test_the_papers_points_are_gates_of_the_packaged_designs(name):
    design = load_design(name)
    course = layout_of(design.course)
    assert [gate.place.points[0] for gate in course.gates] == list(design.path.waypoints_mm)
    assert {(gate.place.reach, gate.point, gate.free) for gate in course.gates} == {(50.0, "middle", False)}
    assert with_overrides(design, ["course.margin_mm=3"]).course.gates == design.course.gates


def test_a_wheel_must_get_to_the_end_before_the_blend():
    """The smallest wheel that the message names is taken, and one a hundredth of a mm smaller is not."""
    with pytest.raises(DesignError, match=r"car\.drive_wheel_radius_mm is 60") as refusal:
        cam_model.track(load_design(None, ["car.drive_wheel_radius_mm=60"]))
    least = float(re.search(r"take a wheel of ([\d.]+) mm or more", str(refusal.value))[1])
    cam_model.track(load_design(None, [f"car.drive_wheel_radius_mm={least}"]))
    with pytest.raises(DesignError):
        cam_model.track(load_design(None, [f"car.drive_wheel_radius_mm={least - 0.01}"]))
    with pytest.raises(DesignError, match=r"needs the ratio of \[train\] too"):
        cam_model.track(load_design(None, ["car.drive_wheel_radius_mm=70", "train="]))
