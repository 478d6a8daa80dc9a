"""The motion of measured cams, by samples of a generator that shares no code with it."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from cadgen.cam.follower import Follower
from cadgen.cam.followers.flat import FlatFace
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.roller import Roller
from cadgen.cam.followers.swinging_flat import SwingingFace
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.errors import DesignError, FileError
from cadgen.inference.motions.found_motion import found_motion, outline_motion
from cadgen.inference.motions.lift_samples import centre_of, normals_of, ordered, samples_of_lifts
from cadgen.inference.motions.stated_motion import stated_motion
from cadgen.inference.motions.whole_degrees import on_grid
from tests.studies import worn_cams_truth as truth

TURN = 2 * np.pi
NOISE = 3e-3


def soft(u: np.ndarray) -> np.ndarray:
    """Wear of 30 um at the middle of a flank."""
    return 0.03 * np.sin(np.pi * np.clip(u, 0, 1)) ** 2


def local(u: np.ndarray) -> np.ndarray:
    """Wear of 30 um over a part of a flank."""
    return 0.03 * np.exp(-(((u - 0.4) / 0.12) ** 2) / 2)


SLIDING = truth.Follower("roller", {"radius_mm": 9.0, "offset_mm": 6.0}, 45.0)
EVERY: tuple[tuple[truth.Follower, Follower, float], ...] = (
    (SLIDING, Roller(base=20.0, radius=9.0, offset=6.0), 14.0),
    (truth.Follower("flat", {"tilt_deg": 8.0}, 60.0), FlatFace(base=20.0, tilt=np.radians(8)), 14.0),
    *(
        (
            truth.Follower(
                "swinging_roller",
                {"radius_mm": 9.0, "arm_mm": 70.0, "centre_distance_mm": 90.0, "lifts": lifts.value},
                35.0,
            ),
            SwingingRoller(base=20.0, radius=9.0, arm=70.0, centre_distance=90.0, lifts=lifts),
            0.2,
        )
        for lifts in Lifts
    ),
    *(
        (
            truth.Follower(
                "swinging_flat", {"face_offset_mm": 5.0, "centre_distance_mm": 90.0, "lifts": lifts.value}, 40.0
            ),
            SwingingFace(base=20.0, face_offset=5.0, centre_distance=90.0, lifts=lifts),
            0.2,
        )
        for lifts in Lifts
    ),
)


def cam_of(height: float, *, laws: tuple[str, str] = ("modified_sine", "cycloidal"), wear: object = None) -> truth.Worn:
    """Rise and return of a height, the first one worn."""
    return truth.Worn(
        (
            truth.Flank(0, 80, 0, height, laws[0], wear),  # type: ignore[arg-type]
            truth.Flank(150, 260, height, 0, laws[1]),
        )
    )


@pytest.mark.parametrize(("real", "follower", "height"), EVERY)
def test_a_point_with_its_normal_tells_where_the_follower_touches_it(
    real: truth.Follower, follower: Follower, height: float
) -> None:
    """Points of an independent envelope give back the cam angle and the motion that they come from."""
    cam, theta = cam_of(height), np.linspace(0, TURN, 60, endpoint=False)
    point, normal = real.contact(cam.lift, theta)
    # The books' cam turns the other way, and their slides lie along +y.
    turn = 1j if real.kind in ("roller", "flat") else 1.0
    seen, outward = ((each / turn).conj() for each in (point, normal))
    angle, q = follower.touching(*(np.stack([each.real, each.imag], axis=1) for each in (seen, outward)))
    off = np.mod(angle - theta + np.pi, TURN) - np.pi
    assert np.ptp(off) < 1e-9
    assert np.ptp(q - cam.lift(theta)) < 1e-9
    # What it stands on at rest is the base circle, whatever one it was built with.
    assert follower.dwelling(float(q.min())) == pytest.approx(real.base, abs=1e-6)


@pytest.mark.parametrize("law", ["modified_trapezoid", "gutman_1_3"])
def test_the_two_closest_laws_are_told_apart_on_a_worn_flank(law: str) -> None:
    """Their lifts differ by 4e-4 of the rise, 5 um here; the wear is 30 um, and the noise 3 um."""
    rng = np.random.default_rng(2)
    cam = cam_of(14.0, laws=(law, "polynomial_3_4_5"), wear=local)
    each = truth.lifts(cam, SLIDING, 720, NOISE, rng, start=0.3)
    found = found_motion(samples_of_lifts(each[:, 0], each[:, 1]))
    assert [flank.rivals[0].candidate.code for flank in found.flanks] == [law, "polynomial_3_4_5"]
    assert found.named
    worn, sound = found.flanks
    assert np.degrees([sound.start - 0.3, sound.stop - 0.3]) == pytest.approx([150, 260], abs=0.05)
    assert np.degrees([worn.start - 0.3, worn.stop - 0.3]) == pytest.approx([0, 80], abs=0.6)
    assert worn.after - worn.before == pytest.approx(14, abs=5e-3)
    assert 0.01 < worn.wear[0] < 0.04  # the rest looks like a turn of the flank
    assert sound.wear[0] < 5e-3


def test_ends_that_wear_has_turned_are_put_back_on_whole_degrees() -> None:
    """Wear as the velocity of its flank looks like a turn of the flank, and the sound one shows the grid."""
    rng = np.random.default_rng(4)
    cam = cam_of(14.0, laws=("cycloidal", "modified_sine"), wear=soft)
    each = truth.lifts(cam, SLIDING, 720, NOISE, rng)
    found = found_motion(samples_of_lifts(each[:, 0], each[:, 1]))
    turned = np.degrees(min(flank.start for flank in found.flanks))
    assert turned > 0.05  # as measured alone
    grid = on_grid(found)
    assert grid is not None
    assert grid.step == 1.0
    theta = np.linspace(0, TURN, 721)
    assert np.abs(grid.motion.lift(theta) - cam.lift(theta)).max() < 5e-3
    stated = stated_motion(found, 1.0, (0.5, 0.1))
    assert [(s.width, s.after, s.law) for s in stated.segments] == [
        (80.0, 14.0, "cycloidal"),
        (70.0, 14.0, ""),
        (110.0, 0.0, "modified_sine"),
        (100.0, 0.0, ""),
    ]


def test_a_grid_that_the_drawing_is_known_to_have_settles_wear_on_every_flank() -> None:
    """Both flanks are worn as their velocities; widths are then right, and the whole is turned as its first flank."""
    rng = np.random.default_rng(4)
    one = cam_of(14.0, laws=("cycloidal", "modified_sine"), wear=soft)
    cam = truth.Worn(tuple(replace(flank, wear=one.flanks[0].wear) for flank in one.flanks))
    each = truth.lifts(cam, SLIDING, 720, NOISE, rng)
    found = found_motion(samples_of_lifts(each[:, 0], each[:, 1]))
    grid = on_grid(found, 1.0)
    assert grid is not None
    assert grid.sure
    assert [(s.width, s.after, s.law) for s in stated_motion(found, 1.0, (0.5,), 1.0).segments] == [
        (80.0, 14.0, "cycloidal"),
        (70.0, 14.0, ""),
        (110.0, 0.0, "modified_sine"),
        (100.0, 0.0, ""),
    ]
    # Where the whole stands is known no better than that: the flank from which the degrees are counted is worn.
    turned = float(np.abs(grid.shifts).max())
    theta = np.linspace(0, TURN, 721)
    off = [np.abs(grid.motion.lift(theta + radians(by)) - cam.lift(theta)).max() for by in np.arange(0, turned, 0.005)]
    assert min(off) < 5e-3


def test_ends_that_are_no_whole_degrees_stay_where_they_are() -> None:
    """Ends at thirds of degrees are on no grid."""
    rng = np.random.default_rng(5)
    cam = truth.Worn((truth.Flank(0, 80.37, 0, 14, "cycloidal"), truth.Flank(150.71, 260.19, 14, 0, "simple_harmonic")))
    each = truth.lifts(cam, SLIDING, 720, NOISE, rng)
    found = found_motion(samples_of_lifts(each[:, 0], each[:, 1]))
    assert on_grid(found) is None
    ends = np.degrees([[flank.start, flank.stop] for flank in found.flanks])
    assert np.mod(ends + 1, 360) - 1 == pytest.approx(np.array([[0, 80.37], [150.71, 260.19]]), abs=0.05)


@pytest.mark.parametrize(("real", "follower", "height"), EVERY[2:5:2])
def test_an_outline_in_any_frame_shows_the_same_motion(real: truth.Follower, follower: Follower, height: float) -> None:
    """Off centre, turned, and run round backwards."""
    rng = np.random.default_rng(6)
    cam = cam_of(height, laws=("polynomial_4_5_6_7", "modified_sine_33"), wear=local)
    points = truth.outline(cam, real, 720, NOISE, rng, centre=-40 + 130j, start=2.0, backwards=True) * [1, -1]
    made = outline_motion(points, follower)
    assert made.centred
    assert made.centre == pytest.approx([-40, -130], abs=5e-3)
    assert made.base == pytest.approx(real.base, abs=5e-3)
    codes = {flank.best.candidate.code for flank in made.found.flanks}
    assert made.found.named
    assert codes == {"polynomial_4_5_6_7", "modified_sine_33"}


@pytest.mark.parametrize("law", ["logistic in powers", "polynomial 3-5-7"])
def test_a_law_that_is_not_in_the_table_is_said_not_to_be(law: str) -> None:
    """And the lift is then that of the measured flank."""
    rng = np.random.default_rng(7)
    cam = truth.Worn(cam_of(14.0, laws=(law, "cycloidal")).flanks, truth.STRANGE)
    each = truth.lifts(cam, SLIDING, 720, NOISE, rng)
    found = found_motion(samples_of_lifts(each[:, 0], each[:, 1]))
    strange, known = sorted(found.flanks, key=lambda flank: np.mod(flank.start + 1, TURN))
    assert not strange.in_table
    assert strange.rivals == ()
    assert known.named
    theta = np.linspace(0, TURN, 721)
    assert np.abs(found.lift(theta) - cam.lift(theta)).max() < 15e-3
    assert len(stated_motion(found, 1.0, (0.5,)).points) == 240


def test_laws_that_the_noise_hides_stay_undecided_with_the_truth_among_them() -> None:
    """At 25 um of noise the closest laws cannot be told apart."""
    rng = np.random.default_rng(8)
    cam = cam_of(10.0, laws=("gutman_1_3", "simple_harmonic"))
    each = truth.lifts(cam, SLIDING, 720, 25e-3, rng)
    found = found_motion(samples_of_lifts(each[:, 0], each[:, 1]))
    first = min(found.flanks, key=lambda flank: np.mod(flank.start + 1, TURN))
    assert not first.named
    assert "gutman_1_3" in [fit.candidate.code for fit in first.rivals]
    assert first.apart < 0.05


def test_rises_without_a_dwell_between_them_have_one_seam() -> None:
    """A rise whose top is an instant."""
    rng = np.random.default_rng(9)
    cam = truth.Worn(
        (truth.Flank(10, 100, 0, 14, "polynomial_3_4_5"), truth.Flank(100, 190, 14, 0, "polynomial_3_4_5"))
    )
    each = truth.lifts(cam, SLIDING, 720, NOISE, rng)
    stated = stated_motion(found_motion(samples_of_lifts(each[:, 0], each[:, 1])), 1.0, (0.5,))
    assert [(s.width, s.after, s.law) for s in stated.segments] == [
        (90.0, 14.0, "polynomial_3_4_5"),
        (90.0, 0.0, "polynomial_3_4_5"),
        (180.0, 0.0, ""),
    ]


def test_the_centre_of_a_dwell_is_found_from_points_in_any_order() -> None:
    """Points that were shuffled are brought into order."""
    rng = np.random.default_rng(10)
    points = truth.outline(cam_of(14.0), SLIDING, 720, NOISE, rng, centre=5 - 3j)
    rng.shuffle(points)
    centre = centre_of(ordered(points))
    assert centre is not None
    assert centre == pytest.approx([5, -3], abs=0.02)
    normals = normals_of(ordered(points))
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1)


def test_records_that_show_no_motion_are_refused() -> None:
    """Too few points, a part of the turn that is missing, and a lift that only rests."""
    theta = np.linspace(0, TURN, 720, endpoint=False)
    with pytest.raises(FileError, match="50 measured points are too few"):
        found_motion(samples_of_lifts(theta[:50], theta[:50]))
    with pytest.raises(FileError, match=r"nothing was measured from cam angle 299\.5 to 360\.0"):
        found_motion(samples_of_lifts(theta[:600], np.sin(theta[:600])))
    with pytest.raises(FileError, match="shows 0 rises and returns"):
        found_motion(samples_of_lifts(theta, np.zeros(720)))
    with pytest.raises(DesignError, match="do not tell where"):
        Follower.touching(EVERY[0][1], np.zeros((1, 2)), np.zeros((1, 2)))


def test_laws_that_do_not_fit_together_are_none() -> None:
    """A lift of straight lines lies within the middle parts of laws that would overlap."""
    theta = np.linspace(0, TURN, 720, endpoint=False)
    found = found_motion(samples_of_lifts(theta, np.interp(theta, [0, TURN / 2, TURN], [0, 10, 0])))
    assert not any(flank.in_table for flank in found.flanks)


@pytest.mark.slow
@pytest.mark.long
def test_a_square_has_no_motion_of_the_table() -> None:
    """Its corners and sides are no wear of a law."""
    theta = np.linspace(0, TURN, 720, endpoint=False)
    points = 40 * np.stack([np.cos(theta), np.sin(theta)]) / np.maximum(np.abs(np.cos(theta)), np.abs(np.sin(theta)))
    made = outline_motion(points.T, Roller(base=20.0, radius=9.0))
    assert not any(flank.in_table for flank in made.found.flanks)


def test_an_outline_in_metres_is_refused() -> None:
    theta = np.linspace(0, TURN, 720, endpoint=False)
    points = 0.03 * np.stack([np.cos(theta), np.sin(theta)], axis=1)
    with pytest.raises(FileError, match=r"within 0\.06 mm: give them in mm"):
        outline_motion(points, Roller(base=20.0, radius=9.0))
