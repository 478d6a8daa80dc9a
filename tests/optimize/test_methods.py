"""The methods by name, alone and combined, and the choice among them."""

import numpy as np
import pytest

from cadgen.errors import CheckError, DesignError
from cadgen.optimize.choice import Candidate, Limit, choose
from cadgen.optimize.methods import PROFILES, compare, gain, profile_lift

TRAINS = {"as designed": np.radians(0.962), "reordered": np.radians(0.724)}


@pytest.fixture(scope="module")
def outcomes(carbon_free_car):
    built = carbon_free_car
    found = compare(built.lift, built.follower, built.car, built.track.length, TRAINS)
    return {(one.profile, one.train): one for one in found}


def test_every_profile_meets_every_train(outcomes):
    assert set(outcomes) == {(profile, train) for profile in PROFILES for train in TRAINS}


def test_combining_the_papers_two_methods(outcomes):
    """Reordering takes 24.74 % off and smoothing 27.15 % of the rest: 45.2 % in all (the paper has 45.31)."""
    plain, both = outcomes["actual", "as designed"], outcomes["smoothed", "reordered"]
    assert gain(outcomes["actual", "reordered"], plain).deflection == pytest.approx(0.2474, abs=1e-3)
    assert gain(outcomes["smoothed", "as designed"], plain).deflection == pytest.approx(0.2715, abs=1e-5)
    assert gain(both, plain).deflection == pytest.approx(1 - (1 - 0.2474) * (1 - 0.2715), abs=1e-3)


def test_what_the_methods_do_to_the_run(outcomes):
    plain = outcomes["actual", "as designed"]
    assert plain.deviation.distance.max() == 0.0
    for profile, train in outcomes:
        one = outcomes[profile, train]
        print(
            f"{profile:22s} {train:12s} sum {np.degrees(one.deflection_sum):7.3f} deg  end "
            f"{np.degrees(one.error.end_heading):8.4f} deg {one.error.end_distance:8.2f} mm  off "
            f"{100 * gain(one, plain).distance:7.2f} %  without play {one.deviation.end_distance:8.2f} mm"
        )
    assert gain(outcomes["compensated", "as designed"], plain).distance > 0.99
    assert gain(outcomes["compensated", "reordered"], plain).distance > 0.99
    # Compensation keeps the smoothed path, which is not the planned one.
    smoothed, both = outcomes["smoothed", "as designed"], outcomes["smoothed+compensated", "as designed"]
    assert both.error.end_distance == pytest.approx(smoothed.deviation.end_distance, rel=0.01)
    assert gain(smoothed, plain).distance < 0


def test_refuses_an_unknown_profile(carbon_free_car):
    built = carbon_free_car
    with pytest.raises(DesignError, match="no profile named smooth; use one of actual, smoothed"):
        profile_lift("smooth", built.lift, built.follower, built.car, built.track.length, 0.01)


LIMITS = (Limit(figure="position error", most=50.0, unit="mm"), Limit(figure="path deviation", most=20.0, unit="mm"))


def candidate(name, position, deviation):
    return Candidate(name=name, figures={"position error": position, "path deviation": deviation})


def test_the_least_of_those_that_keep_the_limits_is_chosen():
    choice = choose(
        [candidate("actual", 40.0, 0.0), candidate("smoothed", 5.0, 30.0), candidate("compensated", 8.0, 1.0)],
        LIMITS,
        least="position error",
    )
    assert choice.best.name == "compensated"
    assert choice.reasons == (
        "actual not chosen: its position error is 40",
        "smoothed refused: it has a path deviation of 30 mm, 10 mm more than the 20 allowed",
        "compensated chosen: the least position error, 8, of 2 that keep every limit",
    )


def test_names_the_limit_that_binds_and_by_how_much():
    with pytest.raises(
        CheckError, match="the nearest, compensated, has a position error of 60 mm, 10 mm more than the 50"
    ):
        choose(
            [candidate("smoothed", 10.0, 200.0), candidate("compensated", 60.0, 1.0), candidate("bad", np.nan, 0.0)],
            LIMITS,
            least="position error",
        )


def test_a_figure_that_is_no_number_keeps_no_limit():
    with pytest.raises(CheckError, match="the nearest, bad"):
        choose([candidate("bad", float("nan"), 0.0)], LIMITS, least="position error")
