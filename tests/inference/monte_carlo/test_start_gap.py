"""The gap between the teeth at the start of a braked car, against a car stepped by midpoints of its own."""

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.car.running.mechanics import Mechanics
from cadgen.design import variation
from cadgen.design.load import load_design
from cadgen.deviations.deviation import COLUMNS, START_GAP
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.budget import error_budget
from cadgen.inference.monte_carlo.cars import nominal_cars, run_cars
from cadgen.inference.monte_carlo.random_cars import Tolerances, sensitivities
from cadgen.jobs.cam.mechanics import start_sentence

PLAY = np.radians(0.738)
GRID = np.linspace(0.0, TURN, 3600, endpoint=False)


@pytest.fixture(scope="module")
def planned(carbon_free_car):
    return drive(carbon_free_car.lift, carbon_free_car.car, carbon_free_car.track.length, steps=3600)


@pytest.fixture(scope="module")
def braked(carbon_free_car, planned):
    built = carbon_free_car
    return nominal_cars(
        roll(built.actual.curve.outline(0.06), built.follower, GRID),
        built.follower,
        built.car,
        built.track.length,
        built.lift,
        planned,
        wheel_radius=63.7,
        play=PLAY,
        mechanics=Mechanics(follower=built.follower, drag=60.0),
    )


def stepped(built, gap: float) -> complex:
    """End of a car whose cam stands until the gears have turned through the gap, in 200 000 steps."""
    step = built.lift.blend_start / 200_000
    motor = (np.arange(200_000) + 0.5) * step
    wheel = built.lift.q(np.maximum(motor - gap, 0.0))
    bend = -wheel / (built.car.wheelbase + built.car.drive_wheel_offset * wheel) * built.track.length / TURN * step
    middle = np.cumsum(bend) - bend / 2
    return complex(np.exp(1j * middle).sum() * built.track.length / TURN * step)


def end(fleet, gap: float) -> complex:
    deviations = np.zeros((1, len(COLUMNS)))
    deviations[0, START_GAP.column] = gap
    return complex(run_cars(fleet, deviations).position[0, -1])


@pytest.mark.parametrize("gap_deg", [0.1, 0.4, 0.738])
def test_the_end_moves_as_that_of_a_car_whose_cam_stands(gap_deg, braked, carbon_free_car):
    gap = np.radians(gap_deg)
    exact = stepped(carbon_free_car, gap) - stepped(carbon_free_car, 0.0)
    mine = end(braked, gap) - end(braked, 0.0)
    print(f"{gap_deg}°: {abs(exact):.2f} mm stepped, {abs(mine):.2f} mm of the fleet")
    assert abs(mine - exact) < 0.01 * abs(exact)
    assert abs(exact) == pytest.approx(92 * gap_deg, rel=0.03)


def test_a_gap_is_at_most_the_play_and_comes_anew_in_every_run(braked):
    assert end(braked, 2 * PLAY) == end(braked, PLAY)
    assert end(braked, -PLAY) == end(braked, 0.0)
    (cost,) = error_budget(braked, {START_GAP: PLAY}, {}).costs
    assert not cost.repeats
    assert cost.after == cost.before == pytest.approx(abs(end(braked, PLAY) - end(braked, 0.0)))


def test_its_sensitivity_is_that_of_a_gap_and_not_of_half_of_one(braked):
    (found,) = (one for one in sensitivities(braked, Tolerances(half_widths={"start_gap": 0.01})) if one.share)
    assert found.distance == pytest.approx(9.22, rel=0.01)


def test_what_is_said_of_it_is_what_a_car_does(planned, carbon_free_car):
    built = carbon_free_car
    said = start_sentence(planned, built.car, built.track.length, PLAY).arguments
    exact = abs(stepped(built, PLAY) - stepped(built, 0.0))
    assert said["moved"] == pytest.approx(exact, rel=0.01)


def test_a_gap_needs_a_brake():
    design = load_design("workshop_car")
    forces = variation.MechanicsBand(follower=None)
    assert variation.half_widths(design, forces)[START_GAP] == pytest.approx(np.radians(0.05))
    loose = design.model_copy(
        update={"mechanics": design.mechanics.model_copy(update={"drag_least_Nmm": 0.0, "drag_greatest_Nmm": None})}
    )
    with pytest.raises(DesignError, match="start_gap_deg is of a cam that a brake holds"):
        variation.half_widths(loose, forces)


def test_a_gap_leaves_what_a_seed_draws_of_all_else(braked):
    halves = {"eccentricity": 0.01, "wobble": 0.001, "base_radius": 0.005}
    plain, more = (
        Tolerances(half_widths=each).draw(np.random.default_rng(1), 20, PLAY)
        for each in (halves, {**halves, "start_gap": 0.001})
    )
    assert (more[:, START_GAP.column] >= 0).all()
    more[:, START_GAP.column] = 0.0
    np.testing.assert_array_equal(plain, more)
