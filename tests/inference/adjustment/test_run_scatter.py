"""Scatter of repeated runs: what a side slip that is drawn anew in each run leaves to be found."""

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.deviations.deviation import SIDE_SLIP
from cadgen.inference.adjustment import RunScatter, Settings, Trial, TrialNoise
from cadgen.inference.monte_carlo.cars import nominal_cars

SLIP = np.radians(0.014)  # half width: three standard deviations


@pytest.fixture(scope="module")
def fleet(carbon_free_car):
    built = carbon_free_car
    contact = roll(built.actual.curve.outline(0.1), built.follower, np.linspace(0.0, TURN, 900, endpoint=False))
    planned = drive(built.lift, built.car, built.track.length, steps=360)
    given = (contact, built.follower, built.car, built.track.length, built.lift, planned)
    return nominal_cars(*given, wheel_radius=63.7, play=0.0)


def trials(built, count, noise):
    """Runs that are driven with the front wheel turned by the slip of each, and measured."""
    from dataclasses import replace

    rng, found = np.random.default_rng(3), []
    for slip in SLIP / 3 * rng.standard_normal(count):
        run = drive(built.lift, replace(built.car, steering_zero=slip), built.track.length, steps=90)
        points = run.drive_wheel[::30] @ np.array([1.0, 1j])
        found.append(Trial(points=points + noise * (rng.standard_normal(4) + 1j * rng.standard_normal(4))))
    return found


def test_repeated_runs_show_the_side_slip_that_was_drawn(fleet, carbon_free_car):
    noise = TrialNoise(point=5.0)
    scatter = RunScatter.of(fleet, trials(carbon_free_car, 200, 5.0), noise)
    print(f"{scatter.count} runs scatter by {scatter.end:.0f} mm: {np.degrees(scatter.side_slip):.4f} degrees")
    assert scatter.side_slip == pytest.approx(SLIP, rel=0.15)
    assert scatter.end == pytest.approx(8617 * np.degrees(SLIP) / 3, rel=0.15)


def test_runs_with_other_settings_are_no_repetition(fleet, carbon_free_car):
    repeated = trials(carbon_free_car, 3, 0.0)
    assert RunScatter.of(fleet, repeated, TrialNoise(point=0.1)).count == 3
    moved = [*repeated, Trial(points=repeated[0].points, settings=Settings(start_x=5.0))]
    assert RunScatter.of(fleet, moved, TrialNoise()) is None
    still = [Trial(points=repeated[0].points)] * 3
    assert RunScatter.of(fleet, still, TrialNoise()).side_slip == 0


def test_a_side_slip_is_a_freedom_of_each_run_where_it_is_reckoned_with():
    assert SIDE_SLIP not in TrialNoise().runs
    assert next(iter(TrialNoise(side_slip=0.001).runs)) == SIDE_SLIP
