"""One profile for a band of plays: the best play to cut it for, and the bound for its peaks and valleys."""

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.car.against_play.band import best_for_band, fixed_profile_bound, over_band
from cadgen.car.against_play.compensation import closed_lift, compensated_lift, nodes_between
from cadgen.car.against_play.smoothing import smoothed_lift
from cadgen.car.running.drive import drive
from cadgen.car.running.run_errors import run_error
from cadgen.errors import DesignError

BAND = (np.radians(0.6), np.radians(0.962))
CARS = ["carbon_free_car", "appendix_car"]


@pytest.mark.parametrize("name", CARS)
def test_no_play_of_a_grid_serves_the_band_better(name, request):
    built = request.getfixturevalue(name)
    lift, follower, car, length = built.lift, built.follower, built.car, built.track.length
    best = best_for_band(lift, follower, car, length, BAND)
    worst = []
    for made_for in np.linspace(*BAND, 13):
        cam = compensated_lift(lift, follower, made_for)
        worst.append(over_band(cam, lift, car, length, np.array(BAND)).worst_distance)
    assert best.worst_distance <= min(worst) + 0.05
    assert BAND[0] < best.made_for < BAND[1]
    # At the best play neither end of the band is worse than the other.
    assert best.distance[0] == pytest.approx(best.distance[-1], rel=1e-3)
    bare = over_band(lift, lift, car, length, np.array(BAND))
    bound = fixed_profile_bound(lift, car, length, BAND)
    print(
        f"{name}, band 0.6 to 0.962 degrees, cut for {np.degrees(best.made_for):.4f}: worst "
        f"{np.degrees(best.worst_heading):.3f} degrees, {best.worst_distance:.1f} mm, "
        f"{100 * (1 - best.worst_distance / bare.worst_distance):.2f} % off; bound with these peaks "
        f"{np.degrees(bound.heading):.3f} degrees, {bound.distance:.1f} mm, "
        f"{100 * (1 - bound.distance / bare.worst_distance):.2f} %; the paper's best is 45.31 %"
    )


@pytest.mark.parametrize("name", CARS)
def test_the_bound_holds_and_is_nearly_reached(name, request):
    """Profiles of all sorts stay above it; the compensated one comes within 1 % in heading."""
    built = request.getfixturevalue(name)
    lift, follower, car, length = built.lift, built.follower, built.car, built.track.length
    bound = fixed_profile_bound(lift, car, length, BAND)
    plays = np.array(BAND)
    cams = [lift] + [compensated_lift(lift, follower, made_for) for made_for in np.linspace(*BAND, 7)]
    for cam in cams:
        result = over_band(cam, lift, car, length, plays)
        assert result.worst_heading > bound.heading
        assert result.worst_distance > bound.distance
    best = best_for_band(lift, follower, car, length, BAND)
    assert best.worst_heading < 1.01 * bound.heading
    assert best.worst_distance < 1.3 * bound.distance


@pytest.mark.parametrize("depth", [0.02, 0.4])
def test_a_lift_off_the_path_is_cut_for_the_play_that_is_best_for_it(carbon_free_car, depth):
    """Not for the one that is best for the wanted lift; far off the path, the best lies at an end of the band."""
    built = carbon_free_car
    lift, follower, car, length = built.lift, built.follower, built.car, built.track.length
    flat = smoothed_lift(lift, depth)
    best = best_for_band(flat, follower, car, length, BAND, wanted=lift)
    plays = np.linspace(*BAND, 9)
    worst = [
        over_band(compensated_lift(flat, follower, play), lift, car, length, np.array(BAND)).worst_distance
        for play in plays
    ]
    assert best.worst_distance <= min(worst) + 0.05
    assert best.made_for == pytest.approx(plays[np.argmin(worst)], abs=plays[1] - plays[0])
    assert best.made_for > best_for_band(lift, follower, car, length, BAND).made_for + 1e-4


def test_the_bound_does_not_hold_for_profiles_with_lower_peaks(carbon_free_car):
    """Smoothed, bent on the flanks so that the end is met again, and compensated: better at the end, off on the way.

    The heights of the six bumps were found by least squares on the end of the run at 0.738 degrees.
    """
    built = carbon_free_car
    lift, follower, car, length = built.lift, built.follower, built.car, built.track.length
    x, jets = nodes_between(smoothed_lift(lift, 0.6), 1e-6, 1e-6 + TURN, widest=np.pi / 720)
    for centre, width, height in (
        (55, 25, 0.7),
        (112, 9, 1.1),
        (152, 12, 2.2),
        (205, 18, 3.9),
        (255, 7, 0.9),
    ):
        u = (x - np.radians(centre)) / np.radians(width)
        bump = np.poly1d([-1.0, 0.0, 1.0]) ** 4
        inside = np.abs(u) < 1
        for order in range(3):
            slope = np.polyder(bump, order)(u) / np.radians(width) ** order
            jets[:, order] += 0.01 * height * np.where(inside, slope, 0.0)
    band, made_for = np.radians([0.512, 0.962]), np.radians(0.738)
    cam = compensated_lift(closed_lift(x, jets, lift.blend_start), follower, made_for)
    worst = over_band(cam, lift, car, length, np.linspace(*band, 5)).worst_distance
    bare = over_band(lift, lift, car, length, band).worst_distance
    bound = fixed_profile_bound(lift, car, length, tuple(band))
    way = run_error(
        drive(cam, car, length, play=made_for, stop=lift.blend_start), drive(lift, car, length)
    ).distance.max()
    print(
        f"worst end {worst:.0f} mm, {100 * (1 - worst / bare):.0f} % off, bound {bound.distance:.0f} mm; {way:.0f} mm"
    )
    assert worst < 0.9 * bound.distance
    assert way > 200


def test_the_bound_is_for_profiles_that_reach_the_peaks(carbon_free_car):
    """A flatter profile depends less on play; that it leaves the path is what it pays with."""
    built = carbon_free_car
    flat = smoothed_lift(built.lift, 0.6)
    plays = np.array(BAND)
    bound = fixed_profile_bound(built.lift, built.car, built.track.length, BAND)
    heading = over_band(flat, built.lift, built.car, built.track.length, plays).heading
    assert abs(heading[1] - heading[0]) / 2 < bound.heading


def test_the_bound_grows_with_the_band_and_vanishes_with_it(carbon_free_car):
    built = carbon_free_car
    bounds = [fixed_profile_bound(built.lift, built.car, built.track.length, (0.01, 0.01 + d)) for d in (0, 1e-3, 2e-3)]
    assert bounds[0].heading == bounds[0].distance == 0.0
    assert bounds[2].heading == pytest.approx(2 * bounds[1].heading)
    assert bounds[2].distance == pytest.approx(2 * bounds[1].distance)


def test_a_single_play_is_compensated_exactly(carbon_free_car):
    built = carbon_free_car
    best = best_for_band(built.lift, built.follower, built.car, built.track.length, (0.015, 0.015))
    assert best.made_for == pytest.approx(0.015)
    assert best.worst_distance < 3.0


@pytest.mark.parametrize("band", [(0.02, 0.01), (-0.01, 0.01), (float("nan"), 0.01)])
def test_refuses_a_band_that_is_none(carbon_free_car, band):
    built = carbon_free_car
    with pytest.raises(DesignError, match="is not one"):
        best_for_band(built.lift, built.follower, built.car, built.track.length, band)
