"""A lift curve through samples."""

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.car.running.play import falls
from cadgen.car.running.run_errors import run_error
from cadgen.car.running.sampled import sampled_lift
from cadgen.errors import DesignError


@pytest.mark.parametrize("first", [0.0, 0.0007, 3.0])
def test_converges_to_the_lift(carbon_free_car, first):
    """Third order or better between samples, wherever the first one lies."""
    lift = carbon_free_car.lift
    dense = np.linspace(0.0, TURN, 20011)
    errors = []
    for count in (720, 1440):
        theta = first + np.linspace(0.0, TURN, count, endpoint=False)
        mine = sampled_lift(theta, lift.q(theta), blend_start=lift.blend_start)
        errors.append(np.mean(np.abs(mine.q(dense) - lift.q(dense))))
    assert errors[0] / errors[1] > 2**2.5


def test_has_the_events_of_the_samples_and_no_others(appendix_car):
    lift = appendix_car.lift
    theta = np.linspace(0.0, TURN, 3600, endpoint=False)
    found = falls(sampled_lift(theta, lift.q(theta), blend_start=lift.blend_start))
    np.testing.assert_allclose(found, falls(lift), atol=TURN / 3600)


def test_a_rolled_profile_drives_the_planned_path(carbon_free_car):
    """From the outline back to the road: rolling and sampling lose two hundredths of a millimetre in 17 m."""
    built = carbon_free_car
    theta = np.linspace(0.0, TURN, 3600, endpoint=False)
    contact = roll(built.actual.curve.outline(0.06), built.follower, theta)
    rolled = sampled_lift(theta, contact.q, blend_start=built.lift.blend_start)
    planned = drive(built.lift, built.car, built.track.length)
    error = run_error(drive(rolled, built.car, built.track.length), planned)
    assert error.distance.max() < 0.02


@pytest.mark.parametrize(
    ("theta", "values", "words"),
    [
        (np.linspace(0, 6, 8), np.zeros(8), "8 cam angles"),
        (np.linspace(0, 6, 20), np.zeros(19), "19 steering values"),
        (np.linspace(0, 6, 20), np.full(20, np.nan), "not a number"),
        (np.linspace(6, 0, 20), np.zeros(20), "must increase"),
        (np.linspace(0, TURN, 20), np.zeros(20), "within one turn"),
    ],
)
def test_refuses_samples_that_make_no_lift(theta, values, words):
    with pytest.raises(DesignError, match=words):
        sampled_lift(theta, values, blend_start=6.0)
