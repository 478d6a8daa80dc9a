"""Refusals of cams by their motion that name a size: put in, it is not refused, and passes where it says so."""

import re

import pytest

from cadgen import Design
from cadgen.errors import DesignError

PAIR = """
name = "pair"

[motion]
turns = "counterclockwise"
segments = [
    { to_mm = 20.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
    { to_mm = 0.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
]

[follower]
kind = "roller"
radius_mm = 9.0
closure = "conjugate"

[follower.second]
radius_mm = 9.0
span_mm = 70.0

[cam]
base_circle_radius_mm = 38.0
thickness_mm = 8.0

[blank]
bore_diameter_mm = 10.0
"""
LEVER = """
name = "lever"

[motion]
turns = "counterclockwise"
segments = [
    { to_deg = 14.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
    { to_deg = 0.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
]

[follower]
kind = "swinging_roller"
radius_mm = 8.0
arm_mm = 80.0
centre_distance_mm = 100.0
lifts = "against"
closure = "conjugate"

[follower.second]
radius_mm = 8.0
arm_mm = 80.0
angle_deg = 42.0

[cam]
base_circle_radius_mm = 40.0
thickness_mm = 8.0
"""
DISC = """
name = "disc"

[motion]
turns = "counterclockwise"
segments = [
    { to_mm = 4.0, in_deg = 120.0, law = "cycloidal" },
    { dwell_deg = 60.0 },
    { to_mm = 0.0, in_deg = 180.0, law = "cycloidal" },
]

[follower]
kind = "roller"
radius_mm = 5.0

[cam]
base_circle_radius_mm = 12.0
thickness_mm = 8.0

[blank]
bore_diameter_mm = 26.0
"""


def refusal(design):
    with pytest.raises(DesignError) as refused:
        design.cam()
    return str(refused.value)


@pytest.mark.parametrize(
    ("text", "changes", "words"),
    [
        (PAIR, {}, "the second roller of 9 mm comes within 3 mm of the camshaft"),
        (LEVER, {}, "the arm of the second roller stands at -0.24 degrees"),
        (LEVER, {"follower.second.radius_mm": 30.0, "follower.second.angle_deg": 50.0}, "the second roller of 30 mm"),
    ],
)
def test_a_second_roller_is_told_the_size_that_was_tried(text, changes, words):
    design = Design.from_toml(text).with_(changes)
    said = refusal(design)
    assert words in said
    key, size = re.search(r"\((follower\.second\.\w+) = ([\d.]+) was tried, and every check passes\)", said).groups()
    assert design.with_({key: float(size)}).cam().passed


@pytest.mark.parametrize("angle", [20.0, 230.0])
def test_a_second_arm_on_the_wrong_side_is_told_an_angle(angle):
    with pytest.raises(DesignError, match=r"more than 28\.24 and less than 208\.2: set it to 73\.3"):
        Design.from_toml(LEVER).with_({"follower.second.angle_deg": angle})
    assert Design.from_toml(LEVER).with_({"follower.second.angle_deg": 73.3}).cam().passed


@pytest.mark.parametrize("closure", [{}, {"closure": "groove", "clearance_mm": 0.05, "depth_mm": 4.0}])
def test_a_bore_through_the_disc_is_refused_with_sizes_that_were_tried(closure):
    design = Design.from_toml(DISC).with_({f"follower.{key}": value for key, value in closure.items()})
    said = refusal(design)
    assert re.match(
        r"the thinnest wall is -1(\.025)? mm \(bore and profile, polar angle [\d.]+°\), so the disc breaks there", said
    )
    sizes = re.findall(r"(blank\.bore_diameter_mm|cam\.base_circle_radius_mm) to ([\d.]+)", said)
    assert len(sizes) == 2
    for key, size in sizes:
        assert "thinnest-wall" not in {str(check.code) for check in design.with_({key: float(size)}).cam().failed}


def test_a_bore_through_the_second_disc_is_refused_once():
    """A larger base circle leaves less of the second disc, so that trials of refused trials would never end."""
    changes = {"follower.second.arm_mm": 100.0, "follower.second.angle_deg": 48.0, "blank.bore_diameter_mm": 10.0}
    said = refusal(Design.from_toml(LEVER).with_(changes))
    assert said.startswith("the second disc: thinnest wall is -2.946 mm")


def test_a_hub_wider_than_the_disc_is_refused():
    hub = {"blank.hub": {"diameter_mm": 40.0, "length_mm": 6.0, "side": "outer"}, "blank.bore_diameter_mm": 8.0}
    said = refusal(Design.from_toml(DISC).with_(hub))
    size = re.search(r"set blank\.hub\.diameter_mm to ([\d.]+)", said).group(1)
    hub["blank.hub"]["diameter_mm"] = float(size)
    assert "thinnest-wall" not in {str(each.code) for each in Design.from_toml(DISC).with_(hub).cam().failed}


def test_a_pivot_within_the_disc_is_refused_with_a_place_that_was_tried():
    far = {"follower.arm_mm": 61.0, "follower.centre_distance_mm": 42.0, "motion.segments.1.to_deg": 6.0}
    alone = LEVER.replace('closure = "conjugate"\n', "").replace(
        "[follower.second]\nradius_mm = 8.0\narm_mm = 80.0\nangle_deg = 42.0\n", ""
    )
    design = Design.from_toml(alone).with_(far)
    said = refusal(design)
    assert "and would cover the pivot of the roller" in said
    changes = dict(re.findall(r"(follower\.\w+) to ([\d.]+)", said))
    assert set(changes) == {"follower.centre_distance_mm", "follower.arm_mm"}
    assert design.with_({key: float(value) for key, value in changes.items()}).cam().checks
