"""Many cars, each with its own friction, drag and rod force, against cars driven one by one."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.against_play.compensation import compensated_lift
from cadgen.car.running.drive import drive
from cadgen.car.running.mechanics import Mechanics
from cadgen.car.running.run_errors import run_error
from cadgen.deviations.deviation import COLUMNS
from cadgen.inference.monte_carlo.cars import nominal_cars
from cadgen.inference.monte_carlo.random_cars import Tolerances, errors_of_cars, sensitivities

COLUMN = {name: number for number, name in enumerate(COLUMNS)}
PLAY = np.radians(0.8)
BANDS = {"friction": 0.2, "drag": 3.0, "rod_force": 0.3}


def cars_of(built, lift, mechanics, count=3600):
    """A fleet on the lift itself, so that nothing but forces and play differs from `drive`."""
    grid = np.linspace(0.0, TURN, count, endpoint=False)
    base = roll(built.actual.curve.outline(0.2), built.follower, grid[:8])
    T, zero = lift.q(grid), np.zeros(count)
    contact = replace(base, cam_angle=grid, q=T, lift=zero, face=built.follower.contact_face(T), across=zero)
    planned = drive(built.lift, built.car, built.track.length, steps=360)
    return nominal_cars(
        contact,
        built.follower,
        built.car,
        built.track.length,
        lift,
        planned,
        wheel_radius=63.7,
        play=PLAY,
        stations=(90, 180, 360),
        mechanics=mechanics,
    )


def nominal(built, **more) -> Mechanics:
    return Mechanics(follower=built.follower, rod_force=1.2, rod_rate=-0.05, friction=0.2, drag=3.0, **more)


@pytest.mark.parametrize("profile", ["actual", "compensated"])
@pytest.mark.parametrize("behind", [0.0, np.radians(0.3)], ids=["disc braked", "shaft braked"])
def test_agrees_with_cars_driven_one_by_one(carbon_free_car, profile, behind):
    built = carbon_free_car
    lift = built.lift if profile == "actual" else compensated_lift(built.lift, built.follower, PLAY)
    mechanics = nominal(built, behind=behind)
    fleet = cars_of(built, lift, mechanics)
    tolerances = Tolerances(half_widths=BANDS, law="uniform", play=(np.radians(0.4), np.radians(1.0)))
    cars = tolerances.draw(np.random.default_rng(4), 12, PLAY)
    # Some at the ends of the bands: without friction and drag, and held all the way by drag.
    cars[0, [COLUMN["friction"], COLUMN["drag"]]] = -0.2, -3.0
    cars[1, COLUMN["drag"]] = 200.0
    cars[2, COLUMN["friction"]] = 0.6
    errors = errors_of_cars(fleet, cars)
    planned = drive(built.lift, built.car, built.track.length, steps=360)
    worst = 0.0
    for number, car in enumerate(cars):
        own = replace(
            mechanics,
            friction=mechanics.friction + car[COLUMN["friction"]],
            drag=mechanics.drag + car[COLUMN["drag"]],
            rod_force=mechanics.rod_force + car[COLUMN["rod_force"]],
        )
        following = own.leads(lift).follow(lift, PLAY + car[COLUMN["play"]])
        exact = run_error(drive(lift, built.car, built.track.length, steps=360, following=following), planned)
        at = [90, 180, 360]
        off = np.hypot(errors.along[number] - exact.along[at], errors.across[number] - exact.across[at])
        worst = max(worst, float(off.max()))
    ends = np.hypot(errors.along[:, -1], errors.across[:, -1])
    print(f"{profile}: ends {ends.min():.0f} to {ends.max():.0f} mm, none further from its own run than {worst:.3f} mm")
    assert worst < 0.3
    assert np.ptp(ends) > 300


def test_without_friction_and_drag_it_is_the_fleet_without_forces(carbon_free_car):
    built = carbon_free_car
    cars = Tolerances(half_widths={"base_radius": 0.005}, play=(0.008, 0.016)).draw(np.random.default_rng(2), 5, PLAY)
    free = errors_of_cars(cars_of(built, built.lift, None, 900), cars)
    smooth = errors_of_cars(cars_of(built, built.lift, Mechanics(follower=built.follower), 900), cars)
    np.testing.assert_allclose(smooth.across, free.across, atol=1e-6)


def test_cars_do_not_depend_on_their_neighbours(carbon_free_car):
    """The number of stretches is that of the car that has most."""
    fleet = cars_of(carbon_free_car, carbon_free_car.lift, nominal(carbon_free_car), 900)
    cars = Tolerances(half_widths=BANDS, law="uniform").draw(np.random.default_rng(3), 9, PLAY)
    together = errors_of_cars(fleet, cars)
    for number in range(9):
        alone = errors_of_cars(fleet, cars[number : number + 1])
        np.testing.assert_allclose(alone.across[0], together.across[number], atol=1e-7)


def test_sensitivity_to_friction_is_that_of_two_runs(carbon_free_car):
    built = carbon_free_car
    mechanics = nominal(built)
    fleet = cars_of(built, built.lift, mechanics)
    found = {one.name: one for one in sensitivities(fleet, Tolerances(half_widths=BANDS))}
    places = []
    for friction in (0.195, 0.205):
        following = replace(mechanics, friction=friction).leads(built.lift).follow(built.lift, PLAY)
        places.append(drive(built.lift, built.car, built.track.length, following=following).drive_wheel[-1])
    assert found["friction"].distance == pytest.approx(np.linalg.norm(places[1] - places[0]), abs=0.3)
    assert set(found) == {"friction", "drag", "rod_force"}
