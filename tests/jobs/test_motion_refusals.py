"""Refusals of cams by their motion that name a size: put in, it is not refused, and passes where it says so."""

import re
from math import pi

import pytest

from cadgen import Design
from cadgen.errors import DesignError
from cadgen.laws.segments import MotionSpan, SegmentMotion, VelocityJumpError
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM
from cadgen.messages import Message

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


# Polynomials that meet their neighbours at its seams ask for more of the disc, which would cover the pivot of the face.
FACE = """
name = "face"

[motion]
turns = "counterclockwise"
segments = [
    { rise_deg = 11.86, in_deg = 42.6, law = "polynomial_2_3" },
    { dwell_deg = 1.1 },
    { to_deg = 18.85, in_deg = 116.6, law = "simple_harmonic" },
    { dwell_deg = 30.7 },
    { to_deg = 0.0, in_deg = 133.8, law = "modified_trapezoid" },
    { dwell_deg = 35.2 },
]

[follower]
kind = "swinging_flat"
lifts = "with"
centre_distance_mm = 27.7
face_offset_mm = -2.2

[cam]
base_circle_radius_mm = 12.1
thickness_mm = 10.6

[blank]
bore_diameter_mm = 3.6
"""


def test_a_law_is_proposed_only_where_the_follower_takes_it():
    design = Design.from_toml(FACE)
    cure = {held.code: str(held.cure) for held in design.cam().verdict.reservations}["acceleration-jumps"]
    assert cure == "go slowly, or take laws that meet their neighbours"
    laws = {f"motion.segments.{number}.law": "polynomial" for number in (1, 3)}
    assert "would cover the pivot" in refusal(design.with_(laws))
    lower = design.with_({"motion.segments.1.rise_deg": 4.0})
    held = {held.code: str(held.cure) for held in lower.cam().verdict.reservations}["acceleration-jumps"]
    assert held.startswith('set motion.segments.1.law to "polynomial" and motion.segments.3.law to "polynomial"')
    assert "acceleration-jumps" not in {held.code for held in lower.with_(laws).cam().verdict.reservations}


def test_cures_of_a_velocity_that_jumps_are_tried_with_the_follower():
    corner = {"motion.segments.1.law": "constant_velocity"}
    said = refusal_of_keys(corner)
    assert said.endswith("which no follower can do: set motion.allow_velocity_jump to true for a corner there")
    said = refusal_of_keys({**corner, "motion.segments.1.rise_deg": 4.0})
    assert 'set motion.segments.1.law to "polynomial", which meets its neighbours, or set motion.allow' in said


def test_a_cure_that_leads_to_another_refusal_says_so_where_none_is_better():
    corner = MotionSpan(0.0, pi, 0.0, 4.0, law_of("constant_velocity"))
    with pytest.raises(VelocityJumpError) as raised:
        SegmentMotion.of([corner, MotionSpan(pi, 2 * pi, 4.0, 0.0, law_of("cycloidal"))], MM)
    said = str(raised.value.tried(lambda changes: Message("the arm is too short")))
    assert said.endswith(", which meets its neighbours, and then: the arm is too short")
    assert str(raised.value.tried(lambda changes: None)) == str(raised.value)


def refusal_of_keys(changes):
    with pytest.raises(DesignError) as refused:
        Design.from_toml(FACE).with_(changes)
    return str(refused.value)
