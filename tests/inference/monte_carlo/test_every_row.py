"""Every row of the budget against a car that is rolled or stepped with the deviation, by code that shares nothing."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.car.running.mechanics import Mechanics
from cadgen.deviations.deviation import COLUMNS, TOLERANCES, VARIED
from cadgen.deviations.first_order import ROWS, Expansion
from cadgen.inference.monte_carlo.cars import nominal_cars, run_cars
from tests.deviations.displaced import Disc, rest

GRID = np.linspace(0.0, TURN, 1800, endpoint=False)
HEAT = Expansion(disc=70e-6, frame=23e-6, rod=12e-6)
RADIUS, ORDERS = 63.7, (1.0, 3.0, 9.0, 45.0, 90.0)
PLAY, MU, DRAG = np.radians(0.738), 0.1, 5.0
NAMES = list(COLUMNS)
# Size of each deviation by its column: it moves the end by a centimetre or more, where it can.
SIZES = {
    "base_radius": 0.01,
    "inner_face": 0.05,
    "outer_face": 0.1,
    "rod_radius": 0.01,
    "profile_offset": 0.01,
    "steering_zero": 2e-4,
    "wheelbase": 0.2,
    "drive_wheel_offset": 1.0,
    "wheel_radius": 0.1,
    "cam_phase": 0.003,
    "start_x": 5.0,
    "start_y": 5.0,
    "start_heading": 0.002,
    "edge_break": 0.05,
    "edge_wear": 0.05,
    "taper": 0.01,
    "rod_height": 0.02,
    "eccentricity_0": 0.01,
    "eccentricity_90": 0.01,
    "wobble_0": 8e-4,
    "wobble_90": 8e-4,
    "steering_lost_motion": 4e-4,
    "wheel_runout_0": 5.0,
    "wheel_runout_90": 5.0,
    "temperature": 5.0,
    "rod_bending": 0.002,
    "wind_up": 0.002,
    "bearing_seats_0": 8e-4,
    "bearing_seats_90": 8e-4,
    **{f"gears_of_shaft_{k}_{part}": 0.002 for k in range(5) for part in (0, 90)},
    "play": 0.001,
    "friction": 0.005,
    "drag": 0.5,
    "rod_force": 0.05,
    "start_gap": 0.005,
    "side_slip": 2e-4,
}
# Rows of a car whose rod rubs and whose gears have play.
RUBBING = ("play", "friction", "drag", "rod_force")


@pytest.fixture(scope="module")
def built(carbon_free_car):
    return carbon_free_car


@pytest.fixture(scope="module")
def disc(built):
    return Disc.of(built.actual.curve)


@pytest.fixture(scope="module")
def fleets(built):
    contact = roll(built.actual.curve.outline(0.06), built.follower, GRID)
    planned = drive(built.lift, built.car, built.track.length, steps=360)

    def fleet(play, mechanics):
        given = (contact, built.follower, built.car, built.track.length, built.lift, planned)
        return nominal_cars(*given, wheel_radius=RADIUS, play=play, mechanics=mechanics, expansion=HEAT, orders=ORDERS)

    held = Mechanics(follower=built.follower, drag=100.0)
    return fleet(0.0, None), fleet(PLAY, Mechanics(follower=built.follower, friction=MU, drag=DRAG)), fleet(PLAY, held)


def stepped(built, tan_beta, *, cam=lambda motor: motor, wheelbase=0.0, offset=0.0, rolled=1.0, wheel=None) -> complex:
    """End of a car that goes from midpoint to midpoint; `cam` is where its cam stands, `wheel` turns what the rod does.

    `rolled` is the travel of its wheel by the nominal one, a number or a function of the motor's position.
    """
    count = 40_000
    step = built.lift.blend_start / count
    motor = (np.arange(count) + 0.5) * step
    tangent = np.interp(cam(motor), GRID, tan_beta, period=TURN)
    tangent = tangent if wheel is None else wheel(tangent)
    arc = built.track.length / TURN * step * (rolled(motor) if callable(rolled) else rolled)
    bend = -tangent / (built.car.wheelbase + wheelbase + (built.car.drive_wheel_offset + offset) * tangent) * arc
    middle = np.cumsum(bend) - bend / 2
    return complex(np.sum(arc * np.sinc(bend / TURN) * np.exp(1j * middle)))


def bent(built, tan_beta, deflection):
    """Tangent of the rod's root where its contact lies on a line of another, for a cantilever that the cam pushes."""
    lever = (built.follower.inner + built.follower.outer) / 2
    w = np.where(tan_beta > 0, built.follower.inner, built.follower.outer)
    contact = np.arctan(tan_beta)
    length = w / np.cos(contact)
    push = w / np.cos(contact) ** 2 / length  # square to the rod, for a force of 1 along the lift: equal work
    away = deflection / lever**3 * push * length**3
    return np.tan(contact - np.arctan(away / length))


def turning(built, disc, towards, size):
    """Steering on a shaft that leans towards a direction of the frame: the disc leans anew at each cam angle."""
    angles = GRID[::6]
    x, y = np.array(towards) * size
    values = [
        rest(disc, built.follower, np.array([a]), tilt=(x * np.cos(a) - y * np.sin(a), x * np.sin(a) + y * np.cos(a)))
        for a in angles
    ]
    return np.concatenate(values)


def exact(name, size, built, disc, base) -> complex:
    """End of the car with one deviation less that of the nominal one, mm."""
    rod, plain = built.follower, stepped(built, base)

    def rolled(follower=rod, of=disc, **words):
        return rest(of, follower, GRID, **words)

    def off(tan_beta=base, **words):
        return stepped(built, tan_beta, **words) - plain

    def sine(part):
        order = ORDERS[int(name.split("_")[3])]
        return lambda motor: motor + size * (np.cos(order * motor) if part == "0" else np.sin(order * motor))

    last = name.rpartition("_")[2]
    direction = (size, 0.0) if last == "0" else (0.0, size)
    if name in ("base_radius", "rod_radius"):
        field = {"base_radius": "base_radius", "rod_radius": "radius"}[name]
        return off(rolled(replace(rod, **{field: getattr(rod, field) + size})))
    if name in ("inner_face", "outer_face"):
        field = name.partition("_")[0]
        return off(rolled(replace(rod, **{field: getattr(rod, field) + size})))
    if name in ("edge_break", "edge_wear"):
        return off(rolled(replace(rod, inner=rod.inner + size, outer=rod.outer - size)))
    if name == "profile_offset":
        return off(rolled(of=Disc(disc.points + size * disc.normals, disc.normals)))
    if name == "taper":
        return off(rolled(taper=size))
    if name == "rod_height":
        return off(rolled(height=size))
    if name.startswith("eccentricity"):
        return off(rolled(shift=direction))
    if name.startswith("wobble"):
        return off(rolled(tilt=direction))
    if name.startswith("bearing_seats"):
        at = turning(built, disc, (1.0, 0.0) if last == "0" else (0.0, 1.0), size)
        change = np.interp(GRID, GRID[::6], at - base[::6], period=TURN)
        return off(base + change)
    if name == "temperature":
        middle, half = (rod.inner + rod.outer) / 2 * (1 + size * HEAT.frame), (rod.outer - rod.inner) / 2
        warm = replace(
            rod,
            base_radius=rod.base_radius * (1 + size * HEAT.frame),
            inner=middle - half,
            outer=middle + half,
            radius=rod.radius * (1 + size * HEAT.rod),
        )
        grown = size * HEAT.frame
        return off(
            rolled(warm, scale=1 + size * HEAT.disc),
            wheelbase=built.car.wheelbase * grown,
            offset=built.car.drive_wheel_offset * grown,
        )
    if name in ("steering_zero", "side_slip"):
        return off(wheel=lambda tangent: np.tan(np.arctan(tangent) + size))
    if name == "steering_lost_motion":
        return off(wheel=lambda tangent: np.tan(np.arctan(tangent) - size * np.sign(tangent)))
    if name == "rod_bending":
        return off(bent(built, base, size))
    if name == "wind_up":
        slope = np.gradient(base, GRID[1])
        lag = size * slope / np.abs(slope).max()
        return off(cam=lambda motor: motor - np.interp(motor, GRID, lag, period=TURN))
    if name.startswith("gears"):
        return off(cam=sine(last))
    if name == "wheelbase":
        return off(wheelbase=size)
    if name == "drive_wheel_offset":
        return off(offset=size)
    if name == "wheel_radius":
        return off(rolled=1 + size / RADIUS)
    if name.startswith("wheel_runout"):
        turns = built.track.length / (TURN * RADIUS)
        wave = np.cos if last == "0" else np.sin
        return off(rolled=lambda motor: 1 + size / RADIUS * wave(turns * motor))
    if name == "cam_phase":
        return off(cam=lambda motor: motor + size)
    if name == "start_gap":
        return off(cam=lambda motor: np.maximum(motor - size, 0.0))
    if name in ("start_x", "start_y"):
        return size if last == "x" else 1j * size
    assert name == "start_heading", f"no perturbation of {name}: add it"
    return (np.exp(1j * size) - 1) * plain


def driven(name, size, built) -> complex:
    """The same of a car whose rod rubs: driven by the operator of one car, with the forces changed themselves."""

    def end(more):
        forces = Mechanics(
            follower=built.follower,
            friction=MU + more.get("friction", 0.0),
            drag=DRAG + more.get("drag", 0.0),
            rod_force=1.0 + more.get("rod_force", 0.0),
        )
        following = forces.leads(built.lift).follow(built.lift, PLAY + more.get("play", 0.0))
        return complex(*drive(built.lift, built.car, built.track.length, following=following).drive_wheel[-1])

    return end({name: size}) - end({})


@pytest.fixture(scope="module")
def base(built, disc):
    return rest(disc, built.follower, GRID)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_row_is_what_a_car_with_that_deviation_does(name, built, disc, base, fleets):
    size = SIZES[name]
    free, rubbing, held = fleets
    fleet = rubbing if name in RUBBING else held if name == "start_gap" else free
    cars = np.zeros((2, len(COLUMNS)))
    cars[1, NAMES.index(name)] = size
    ends = run_cars(fleet, cars).position[:, -1]
    mine = complex(ends[1] - ends[0])
    truth = driven(name, size, built) if name in RUBBING else exact(name, size, built, disc, base)
    print(f"{name} {size:g}: {abs(truth):.2f} mm rolled or driven, {abs(mine):.2f} mm of the row")
    assert abs(mine - truth) < 0.02 * abs(truth) + 0.06


def test_no_row_moves_nothing(fleets):
    """A deviation of the catalogue that neither the rows nor the cars know would be silently left out."""
    assert set(SIZES) == set(NAMES)
    free, rubbing, held = fleets
    for each in VARIED:
        cars = np.zeros((len(each.columns) + 1, len(COLUMNS)))
        for row, column in enumerate(each.columns, 1):
            cars[row, column] = SIZES[NAMES[column]]
        fleet = rubbing if each.key in RUBBING else held if each.key == "start_gap" else free
        ends = run_cars(fleet, cars).position[:, -1]
        assert (np.abs(ends[1:] - ends[0]) > 1e-5).all(), each.key
    assert len(ROWS) == len(set(ROWS)) == len(free.derivatives)
    assert set(TOLERANCES) < set(VARIED)
