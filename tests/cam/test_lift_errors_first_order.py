"""Errors of the lift to first order against the changed follower, rolled on the disc as it is."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.followers.flat import FlatFace
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.roller import Knife, Roller
from cadgen.cam.followers.swinging_flat import SwingingFace
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.cam.lift_errors import LiftErrors, wrong_side_up
from cadgen.curves.closed import Outline
from cadgen.laws.series import HarmonicMotion
from cadgen.laws.unit import MM, RAD

STEP = 1e-4  # mm or rad
SLIDE = HarmonicMotion.of([(0, 5.0, 0.0), (1, -4.0, 1.0), (2, -1.0, 0.6)], MM)
SWING = HarmonicMotion.of([(0, 0.08, 0.0), (1, -0.06, 0.015), (2, -0.02, 0.01)], RAD)
KEYS = {"base_circle": "base", "roller_radius": "radius", "arm": "arm", "tilt": "tilt"}
ROLLER = Roller(base=40.0, radius=9.0, offset=6.0)
ARM = SwingingRoller(base=35.0, radius=9.0, arm=70.0, centre_distance=90.0, lifts=Lifts.AGAINST)
FACE = SwingingFace(base=40.0, face_offset=5.0, centre_distance=90.0, lifts=Lifts.AGAINST)
FLAT = FlatFace(base=60.0, tilt=np.radians(8.0), offset=4.0)
FOLLOWERS = [
    ROLLER,
    Knife(base=40.0, offset=-5.0),
    ARM,
    replace(ARM, lifts=Lifts.WITH),
    FACE,
    replace(FACE, lifts=Lifts.WITH),
    FLAT,
]


def place(follower: Follower, q: Array) -> Array:
    """Place of a follower on its way, whatever its base circle: mm along a slide, or rad from the camshaft."""
    if isinstance(follower, FlatFace):  # where the slide's axis meets the face
        support = follower.base + q * np.cos(follower.tilt)
        return np.asarray((support + follower.offset * np.sin(follower.tilt)) / np.cos(follower.tilt))
    return np.asarray(q + (getattr(follower, "rest", None) or follower.base_radius))


def grown(outline: Outline, by: float) -> Outline:
    """Outline that is larger all round, by its normals."""
    ahead, behind = np.roll(outline.points, -1, axis=0), np.roll(outline.points, 1, axis=0)
    along = ahead - behind
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    return Outline(outline.points + by * normal, outline.piece)


@pytest.mark.parametrize("follower", FOLLOWERS, ids=lambda each: f"{type(each).__name__}{getattr(each, 'lifts', '')}")
def test_every_dimension_moves_the_lift_as_rolling_says(follower: Follower) -> None:
    motion = SLIDE if follower.unit == MM else SWING
    outline = actual_profile(motion, follower).curve.outline(0.02)
    theta = np.linspace(0.0, TURN, 24, endpoint=False)
    errors = LiftErrors.of(motion, follower, None)
    rows = np.arange(0, len(errors.cam_angle), len(errors.cam_angle) // 24)
    assert errors.cam_angle[rows] == pytest.approx(theta)
    lever = float(follower.lift(np.array([1.0]))[0])
    plain = place(follower, roll(outline, follower, theta).q)
    codes = set()
    for each in errors.errors:
        codes.add(each.code)
        for column in range(each.of_unit.shape[1]):
            turned = theta
            changed, disc = follower, outline
            if each.code == "phase":
                turned = theta + STEP
            elif each.code == "eccentricity":
                disc = Outline(outline.points + STEP * np.eye(2)[column], outline.piece)
            elif each.code == "base_circle":
                disc = grown(outline, STEP)
            else:
                name = KEYS.get(each.code, each.code)
                changed = replace(follower, **{name: getattr(follower, name) + STEP})  # type: ignore[type-var]
            moved = place(changed, roll(disc, changed, turned).q) - plain
            said = each.of_unit[rows, column] / lever * STEP
            # Half a step squared over the radius of the roller is left.
            assert moved == pytest.approx(said, abs=4e-3 * STEP * max(np.abs(said).max() / STEP, 0.02)), each.code
    assert {"base_circle", "phase", "eccentricity"} < codes


def test_what_setting_takes_out_is_taken_off() -> None:
    """A larger disc under a square face lifts it by as much everywhere, which setting takes out."""
    square = FlatFace(base=60.0)
    free, fixed = (LiftErrors.of(SLIDE, square, at) for at in (None, 0.3))
    one, other = (next(each for each in errors.errors if each.code == "base_circle") for errors in (free, fixed))
    assert one.of_unit == pytest.approx(1.0)
    assert other.of_unit == pytest.approx(0.0, abs=1e-12)


def test_a_symmetric_cam_runs_wrong_side_up_and_another_does_not() -> None:
    """Without an offset and with equal flanks the mirrored disc is the same one, turned."""
    even = HarmonicMotion.of([(0, 5.0, 0.0), (1, -4.0, 0.0), (2, -1.0, 0.0)], MM)
    square = Roller(base=40.0, radius=9.0)
    assert wrong_side_up(actual_profile(even, square).curve, even, square) < 1e-4
    shifted = Roller(base=40.0, radius=9.0, offset=6.0)
    assert wrong_side_up(actual_profile(even, shifted).curve, even, shifted) > 0.05
