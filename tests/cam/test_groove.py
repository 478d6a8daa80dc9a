"""Grooves: both flanks against brute force, play, printed figures, and the files of the part."""

import json
import re
from math import sqrt

import numpy as np
import pytest
from build123d import GeomType, import_step

from cadgen import Design
from cadgen.arrays import TURN
from cadgen.cam.derived_motions import OppositeMotion
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.groove import GrooveRollers
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.roller import Roller
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.cam.lost_lift import lost_lift
from cadgen.curves.biarc import arcs
from cadgen.curves.derived import parallel
from cadgen.errors import CheckError, DesignError
from cadgen.laws.unit import MM
from cadgen.output.files.groove_nc import rounds_of
from tests.cam.test_kinds import DATA, motion

TEXT = """
name = "track"
[motion]
turns = "clockwise"
segments = [
    { rise_mm = 25.0, in_deg = 110.0, law = "modified_sine" },
    { dwell_deg = 50.0 },
    { rise_mm = -25.0, in_deg = 110.0, law = "modified_sine" },
    { dwell_deg = 90.0 },
]
[follower]
kind = "roller"
radius_mm = 10.0
closure = "groove"
clearance_mm = 0.05
depth_mm = 6.0
[cam]
base_circle_radius_mm = 45.0
thickness_mm = 12.0
"""
HUB = {"machining.cutter_diameter_mm": 20.05, "blank.hub": {"diameter_mm": 30, "length_mm": 8}}
SPANS = ((110, 15.0, "modified_sine"), (50, 15.0, None), (110, 0.0, "modified_sine"), (90, 0.0, None))


def test_a_groove_has_its_printed_figures():
    expected = json.loads((DATA / "h23_groove.json").read_text())["expected"]
    cam = Design.from_toml(TEXT).cam()
    assert cam.passed
    figures = {check.code: check.value for check in cam.checks}
    assert figures["pressure-angle-greatest"] == pytest.approx(expected["pressure_angle_deg"]["max"], abs=1e-3)
    assert figures["pressure-angle-least"] == pytest.approx(expected["pressure_angle_deg"]["min"], abs=1e-3)
    assert figures["convex-radius-theory"] == pytest.approx(expected["pitch_least_convex_radius_mm"], abs=1e-4)
    assert figures["convex-radius-profile"] == pytest.approx(expected["inner_least_convex_radius_mm"], abs=1e-4)
    assert figures["groove-hollow-radius"] == pytest.approx(expected["outer_least_concave_radius_mm"], abs=1e-4)
    assert figures["groove-play-greatest"] == pytest.approx(expected["play_greatest_mm"], abs=1e-5)
    assert figures["groove-play-least"] == pytest.approx(expected["play_least_mm"], abs=1e-5)
    assert 2 * cam.computed.follower.radius == pytest.approx(expected["groove_width_mm"])


ROLLERS = {
    "in line": Roller(base=45.0, radius=10.0),
    "offset": Roller(base=45.0, radius=10.0, offset=9.0),
    "arm against": SwingingRoller(base=45.0, radius=10.0, arm=72.0, centre_distance=100.0, lifts=Lifts.AGAINST),
    "arm with": SwingingRoller(base=45.0, radius=10.0, arm=72.0, centre_distance=100.0, lifts=Lifts.WITH),
}


def centre_of(roller, q, theta):
    """Centre of the roller in the frame of the cam, by its definition."""
    if isinstance(roller, Roller):
        y0 = np.sqrt((roller.base + roller.radius) ** 2 - roller.offset**2)
        return (y0 + q + 1j * roller.offset) * np.exp(1j * theta)
    c, arm = roller.centre_distance, roller.arm
    start = np.arccos((c**2 + arm**2 - (roller.base + roller.radius) ** 2) / (2 * c * arm))
    side = 1 if roller.lifts == Lifts.AGAINST else -1
    return (c - arm * np.exp(1j * side * (start + q))) * np.exp(1j * theta)


@pytest.mark.parametrize("name", ROLLERS)
def test_both_flanks_keep_half_the_width_from_the_centre(name):
    """Least distance of each flank from the centre where the motion is given, without a derivative: within 1e-5 mm."""
    roller = ROLLERS[name]
    wanted = motion(roller.unit, SPANS)
    groove = GrooveRollers.of(roller, 0.05, 6.0)
    flanks = (
        actual_profile(wanted, groove.inner).curve.outline(0.002).points @ [1, 1j],
        actual_profile(OppositeMotion.of(wanted), groove.outer).curve.outline(0.002).points @ [1, 1j],
    )
    theta = np.linspace(0.0, TURN, 36) + 0.01
    for centre in centre_of(roller, wanted.q(theta), theta):
        distances = [float(np.abs(flank - centre).min()) for flank in flanks]
        assert distances == pytest.approx([10.025, 10.025], abs=1e-6)
        # Width along the normal: the nearest points of both flanks lie on one line with the centre.
        near = [flank[np.abs(flank - centre).argmin()] for flank in flanks]
        assert abs(near[1] - near[0]) == pytest.approx(20.05, abs=1e-5)


def test_the_outer_flank_is_undercut_where_the_path_is_hollower_than_half_the_width():
    """Lift lost there is what brute cutting of the flank loses; and the trimmed flank is the farthest that was cut."""
    steep = motion(MM, ((35, 30.0, "cycloidal"), (25, 30.0, None), (35, 0.0, "cycloidal"), (265, 0.0, None)))
    groove = GrooveRollers.of(Roller(base=30.0, radius=18.0), 0.0, 6.0)
    opposite = OppositeMotion.of(steep)
    profile = actual_profile(opposite, groove.outer)
    assert profile.trims
    theta = np.linspace(0.0, TURN, 60_000, endpoint=False)
    phi = np.linspace(0.0, TURN, 121, endpoint=False)
    w = centre_of(Roller(base=30.0, radius=18.0), steep.q(theta), theta) * np.exp(-1j * phi[:, None])
    inside = np.abs(w.imag) < 18.0
    far = np.where(inside, w.real + np.sqrt(np.where(inside, 324.0 - w.imag**2, 0.0)), -np.inf).max(axis=1)
    assert np.abs(far - profile.curve.radius(phi)).max() < 1e-4
    losses = lost_lift(opposite, groove.outer, profile.trims, profile.curve.outline(0.005))
    assert max(loss.lift for loss in losses) > 1e-3


@pytest.mark.parametrize(("diameter", "count"), [(20.05, 1), (12.0, 2), (4.0, 7)])
def test_the_cutter_leaves_no_ridge_between_its_rounds(diameter, count):
    """A cutter of the groove's width goes once along the path of the centre; smaller ones overlap."""
    cam = Design.from_toml(TEXT).cam().computed
    rounds = rounds_of(cam.curve, 20.05, diameter / 2, 2e-4)
    assert len(rounds) == count
    radii = sorted(float(np.linalg.norm(one.vertices[0])) for one in rounds)
    assert max(np.diff(radii), default=0.0) <= 0.8 * diameter + 1e-9
    if count == 1:
        middle = arcs(parallel(cam.curve, 10.025), 2e-4)
        np.testing.assert_allclose(rounds[0].vertices, middle.vertices, atol=1e-9)
    with pytest.raises(CheckError, match=r"the groove is 20\.05 mm wide: choose a cutter of at most that"):
        rounds_of(cam.curve, 20.05, 10.5, 2e-4)


BAD = [
    ({"follower.depth_mm": 12.0}, "the groove has no floor: lower it below 12", {"follower.depth_mm": 11.0}),
    ({"follower.depth_mm": 12.0}, "or raise cam.thickness_mm", {"cam.thickness_mm": 15.0}),
    ({"follower.clearance_mm": 10.0}, "it must be less than follower.radius_mm, 10", {"follower.clearance_mm": 0.1}),
    ({"cam.outside_diameter_mm": 150.0}, "raise it to", {"cam.outside_diameter_mm": 185.0}),
    ({"blank.edge_break_mm": 0.5}, "here a groove does: remove it", {"blank.edge_break_mm": 0.0}),
    ({"follower.closure": "spring"}, 'set follower.closure = "groove", or remove it', {"follower.closure": "groove"}),
]


@pytest.mark.parametrize(("change", "words", "cure"), BAD)
def test_bad_grooves_are_refused_with_cures_that_work(change, words, cure):
    design = Design.from_toml(TEXT)
    with pytest.raises(DesignError, match=re.escape(words)):
        design.with_(change).cam()
    design.with_(change | cure).cam()


def test_a_groove_into_the_bore_fails_with_the_wall_that_is_left():
    cam = Design.from_toml(TEXT).with_({"cam.base_circle_radius_mm": 6.0, "follower.radius_mm": 5.0}).cam()
    walls = [check for check in cam.failed if check.code == "thinnest-wall"]
    assert walls[0].value == pytest.approx(6.0 - 0.025 - 4.0, abs=1e-3)
    with pytest.raises(DesignError, match=r"which needs follower\.depth_mm"):
        Design.from_toml(TEXT.replace("depth_mm = 6.0\n", ""))


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("changes", [{}, HUB])
def test_the_files_of_a_groove_keep_the_motion_on_both_flanks(changes, tmp_path):
    written = Design.from_toml(TEXT).with_(changes).cam().write(tmp_path)
    errors = {each.name: each.lift_error_um for each in written.files}
    print(errors)
    for file, error in errors.items():
        assert error <= (1.0 if file.endswith((".dxf", ".nc")) else 5.0 if file.endswith((".stl", ".3mf")) else 0.05)
    solid = import_step(tmp_path / "track_actual.step")
    # The floor is a face of its own at the depth of the groove; its area is that between the flanks.
    (floor,) = [f for f in solid.faces() if f.geom_type == GeomType.PLANE and abs(f.center().Z - 6.0) < 1e-6]
    path = motion(MM, ((110, 25.0, "modified_sine"), (50, 25.0, None), (110, 0.0, "modified_sine"), (90, 0.0, None)))
    theta = np.linspace(0.0, TURN, 200_001)
    length = np.abs(np.diff(centre_of(Roller(base=45.0, radius=10.0), path.q(theta), theta))).sum()
    assert floor.area == pytest.approx(20.05 * length, rel=5e-6)  # width times length of the path of the centre


def test_no_inspection_shows_one_flank_as_the_outline(tmp_path):
    """Its page showed the inner flank as the rim of the disc."""
    from cadgen import Report

    design = Design.from_toml(TEXT)
    page = Report.of(design).write(tmp_path)
    html = next(file.path for file in page if file.name.endswith(".html")).read_text("utf-8")
    assert "greatest radius of the disc" not in html


def test_a_groove_in_the_inner_face_is_said_and_the_way_to_one_that_turns_counterclockwise():
    """Mirrored, the path of a roller's centre is that of the motion in the reverse order with the other offset."""
    keys = {"motion.segments.1.in_deg": 100.0, "motion.segments.2.in_deg": 260.0, "follower.offset_mm": 6.0}
    asked = Design.load("groove", keys).cam()
    (said,) = asked.application.setting(asked)
    assert "in the inner face, seen on which the disc turns clockwise" in said
    reverse = {"motion.turns": "clockwise", "motion.segments.1.in_deg": 260.0, "motion.segments.2.in_deg": 100.0}
    other = Design.load("groove", keys | reverse | {"follower.offset_mm": -6.0}).cam()
    assert other.application.setting(other) == ()
    at = np.linspace(0.0, TURN, 7, endpoint=False)
    centre = [sqrt(50.8**2 - 6.0**2) + np.array(cam.lift(turn)) for cam, turn in ((asked, at), (other, -at))]
    paths = [
        (out + 1j * shift) * np.exp(1j * turn) for out, shift, turn in zip(centre, (6, -6), (at, -at), strict=True)
    ]
    np.testing.assert_allclose(paths[1], paths[0].conj(), atol=1e-9)
