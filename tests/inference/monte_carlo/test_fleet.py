"""Many cars at once, against cars built and driven one by one."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.car.against_play.compensation import compensated_lift
from cadgen.car.running.drive import Pose, Run, drive
from cadgen.car.running.run_errors import run_error
from cadgen.car.running.sampled import sampled_lift
from cadgen.deviations.deviation import COLUMNS
from cadgen.deviations.first_order import steering_derivatives
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.cars import nominal_cars, run_cars
from cadgen.inference.monte_carlo.random_cars import Tolerances, errors_of_cars

NAMES = list(COLUMNS)
PLAY = np.radians(0.8)
WHEEL = 63.7
STATIONS = (900, 1800, 3600)
HALF_WIDTHS = {
    "base_radius": 0.05,
    "inner_face": 0.05,
    "outer_face": 0.05,
    "rod_radius": 0.01,
    "steering_zero": np.radians(0.1),
    "wheelbase": 0.1,
    "drive_wheel_offset": 0.1,
    "wheel_radius": 0.02,
    "cam_phase": np.radians(0.3),
    "start_x": 1.0,
    "start_y": 1.0,
    "start_heading": np.radians(0.2),
}


def grid(count: int) -> np.ndarray:
    return np.linspace(0.0, TURN, count, endpoint=False)


@pytest.fixture(scope="module")
def planned(carbon_free_car):
    return drive(carbon_free_car.lift, carbon_free_car.car, carbon_free_car.track.length)


@pytest.fixture(scope="module")
def outline(carbon_free_car):
    return carbon_free_car.actual.curve.outline(0.06)


def cars_of(built, outline, planned, lift=None, count=3600, stations=STATIONS):
    contact = roll(outline, built.follower, grid(count))
    return nominal_cars(
        contact,
        built.follower,
        built.car,
        built.track.length,
        lift or built.lift,
        planned,
        wheel_radius=WHEEL,
        play=PLAY,
        stations=stations,
    )


def one_by_one(built, outline, deviation) -> Run:
    """Roll a changed rod on the nominal disc, drive a changed car: nothing is linear, nothing shared."""
    d = dict(zip(NAMES, deviation, strict=True))
    follower = replace(
        built.follower,
        base_radius=built.follower.base_radius + d["base_radius"],
        inner=built.follower.inner + d["inner_face"],
        outer=built.follower.outer + d["outer_face"],
        radius=built.follower.radius + d["rod_radius"],
    )
    car = replace(
        built.car,
        wheelbase=built.car.wheelbase + d["wheelbase"],
        drive_wheel_offset=built.car.drive_wheel_offset + d["drive_wheel_offset"],
        steering_zero=0.0,
        steering_gain=1.0,
    )
    motor = grid(3600)
    contact = roll(outline, follower, motor + d["cam_phase"])
    # The front wheel's angle itself; the car that is driven then has neither zero nor gain.
    angle = np.arctan(built.car.steering_gain * contact.q) + built.car.steering_zero
    return drive(
        sampled_lift(motor, np.tan(angle + d["steering_zero"]), blend_start=built.lift.blend_start),
        car,
        built.track.length * (1 + d["wheel_radius"] / WHEEL),
        play=PLAY + d["play"],
        start=Pose(x=d["start_x"], y=d["start_y"], heading=d["start_heading"]),
    )


AS_BUILT = {"steering_zero": np.radians(0.55), "steering_gain": 1.04, "slip": 0.08}


@pytest.mark.parametrize("as_built", [{}, AS_BUILT], ids=["as designed", "as built"])
@pytest.mark.parametrize("profile", ["actual", "compensated"])
def test_agrees_with_cars_driven_one_by_one(carbon_free_car, profile, as_built):
    """All deviations at once: the end moves by hundreds of mm, and what linear terms miss is under 2 mm of it."""
    built = replace(carbon_free_car, car=replace(carbon_free_car.car, **as_built))
    planned = drive(built.lift, built.car, built.track.length)
    lift = built.lift if profile == "actual" else compensated_lift(built.lift, built.follower, PLAY)
    outline = actual_profile(lift, built.follower).curve.outline(0.06)
    fleet = cars_of(built, outline, planned, lift)
    tolerances = Tolerances(half_widths=HALF_WIDTHS, law="uniform", play=(np.radians(0.5), np.radians(1.0)))
    deviations = tolerances.draw(np.random.default_rng(7), 8, PLAY)
    errors = errors_of_cars(fleet, deviations)
    for number, deviation in enumerate(deviations):
        exact = run_error(one_by_one(built, outline, deviation), planned)
        at = list(STATIONS)
        off = np.hypot(errors.along[number] - exact.along[at], errors.across[number] - exact.across[at])
        assert off.max() < 2.0
        np.testing.assert_allclose(errors.heading[number], exact.heading[at], atol=3e-4)
    assert np.median(np.hypot(errors.along[:, -1], errors.across[:, -1])) > 200


@pytest.mark.parametrize("name", ["cam_phase", "play", "wheel_radius", "start_heading", "wheelbase", "base_radius"])
@pytest.mark.parametrize("sign", [-1, 1])
def test_one_parameter_at_a_time(carbon_free_car, outline, planned, name, sign):
    fleet = cars_of(carbon_free_car, outline, planned)
    deviation = np.zeros(len(NAMES))
    deviation[NAMES.index(name)] = sign * {"mm": 0.05, "rad": np.radians(0.4)}[COLUMNS[name]]
    mine = errors_of_cars(fleet, deviation[None])
    exact = run_error(one_by_one(carbon_free_car, outline, deviation), planned)
    at = list(STATIONS)
    size = np.hypot(exact.along[at], exact.across[at])
    np.testing.assert_array_less(
        np.hypot(mine.along[0] - exact.along[at], mine.across[0] - exact.across[at]), 0.005 * size + 0.3
    )


def test_error_falls_with_the_square_of_the_step(carbon_free_car, planned):
    """Against the exact run on the same lift; the contact here is the lift's own, so that only the grid errs."""
    built = carbon_free_car
    wanted = run_error(drive(built.lift, built.car, built.track.length, play=PLAY), planned)
    base = roll(built.actual.curve.outline(0.2), built.follower, grid(8))
    ends = []
    for count in (900, 1800, 3600):
        zero = np.zeros(count)
        T = built.lift.q(grid(count))
        contact = replace(base, cam_angle=grid(count), q=T, lift=zero, face=built.follower.contact_face(T), across=zero)
        fleet = nominal_cars(
            contact, built.follower, built.car, built.track.length, built.lift, planned, wheel_radius=WHEEL, play=PLAY
        )
        error = errors_of_cars(fleet, np.zeros((1, len(NAMES))))
        ends.append(abs(complex(error.along[0, 0] - wanted.along[-1], error.across[0, 0] - wanted.across[-1])))
    order = np.log2(ends[0] / ends[2]) / 2
    print(f"errors {ends} mm at 900, 1800, 3600 steps, order {order:.2f}")
    assert order > 1.8


def test_steering_derivatives_are_those_of_rolling(carbon_free_car, outline):
    """Central differences of the whole contact search, with a rod or faces a little different."""
    follower = carbon_free_car.follower
    theta = grid(720)
    contact = roll(outline, follower, theta)
    derivatives = dict(zip(NAMES, steering_derivatives(contact, follower), strict=False))
    step = 2e-3
    for name, field in (
        ("base_radius",) * 2,
        ("inner_face", "inner"),
        ("outer_face", "outer"),
        ("rod_radius", "radius"),
    ):
        low, high = (
            roll(outline, replace(follower, **{field: getattr(follower, field) + side * step / 2}), theta).q
            for side in (-1, 1)
        )
        # Next to a change of face the two rolls may rest on different ones.
        apart = np.abs((high - low) / step - derivatives[name])
        assert np.quantile(apart, 0.99) < 2e-4
        assert apart.max() < 0.01


def test_a_disc_cut_too_large_is_a_thicker_rod(carbon_free_car, outline):
    contact = roll(outline, carbon_free_car.follower, grid(16))
    derivatives = dict(zip(NAMES, steering_derivatives(contact, carbon_free_car.follower), strict=False))
    np.testing.assert_array_equal(derivatives["profile_offset"], derivatives["rod_radius"])
    larger = replace(outline, points=outline.points * (1 + 0.01 / np.linalg.norm(outline.points, axis=1))[:, None])
    risen = roll(larger, carbon_free_car.follower, grid(16)).q - contact.q
    # Moved out along the radius, not the normal: the two differ by the cosine of the outline's slope.
    np.testing.assert_allclose(risen, 0.01 * derivatives["profile_offset"], rtol=0.15)


def test_cars_do_not_depend_on_their_neighbours(carbon_free_car, outline, planned):
    fleet = cars_of(carbon_free_car, outline, planned, count=900, stations=(-1,))
    tolerances = Tolerances(half_widths=HALF_WIDTHS)
    deviations = tolerances.draw(np.random.default_rng(3), 5, PLAY)
    together = run_cars(fleet, deviations)
    for number in range(5):
        alone = run_cars(fleet, deviations[number : number + 1])
        np.testing.assert_allclose(alone.position[0], together.position[number], rtol=1e-9)


def test_a_wheel_that_runs_out(carbon_free_car, outline, planned):
    """Without play, against the run at 57 600 steps, each by the wheel's radius there: right within 0.5 %."""
    built, size = carbon_free_car, np.array([0.5, -0.3])
    fleet = cars_of(built, outline, planned)
    deviations = np.zeros((2, len(NAMES)))
    deviations[0, [NAMES.index("wheel_runout_0"), NAMES.index("wheel_runout_90")]] = size
    deviations[:, NAMES.index("play")] = -PLAY
    heading, position = (each[0] - each[1] for each in vars(run_cars(fleet, deviations)).values())
    run = drive(built.lift, built.car, built.track.length, steps=57600)
    place = run.drive_wheel @ [1, 1j] * np.exp(-1j * run.heading[0])
    middle = (run.motor[1:] + run.motor[:-1]) / 2 * built.track.length / (TURN * WHEEL)
    longer = 1 + (size[0] * np.cos(middle) + size[1] * np.sin(middle)) / WHEEL
    turned = np.append(0.0, np.cumsum(np.diff(run.heading) * longer))
    chord = np.diff(place) * np.exp(-1j * (run.heading[:-1] - run.heading[0] - turned[:-1])) * longer
    moved = np.append(0.0, np.cumsum(chord)) - (place - place[0])
    at = np.searchsorted(run.motor, fleet.stations)
    sizes, bent = np.abs(moved[at]), turned[at] - (run.heading[at] - run.heading[0])
    off, turned_off = np.abs(position - moved[at]).max(), np.abs(heading - bent).max()
    print(
        f"moved by {sizes.max():.3f} mm, off by {off:.5f} mm; turned by {np.abs(bent).max():.1e}, off {turned_off:.1e}"
    )
    assert sizes.max() > 0.5
    assert off <= 0.005 * sizes.max()
    assert turned_off <= 0.005 * np.abs(bent).max()


def test_refuses_an_uneven_grid_and_stations_out_of_order(carbon_free_car, outline, planned):
    built = carbon_free_car
    contact = roll(outline, built.follower, grid(90) + 0.1)
    settings = {"wheel_radius": WHEEL, "play": PLAY}
    with pytest.raises(DesignError, match="even grid"):
        nominal_cars(contact, built.follower, built.car, built.track.length, built.lift, planned, **settings)
    with pytest.raises(DesignError, match="at least one station"):
        cars_of(built, outline, planned, count=90, stations=(1800, 900))
    with pytest.raises(DesignError, match="at least one station"):
        cars_of(built, outline, planned, count=90, stations=())
