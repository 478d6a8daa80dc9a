"""First-order terms of the steering, against a rod let down on a disc that is displaced, tilted or cut otherwise."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.car.running.sampled import sampled_lift
from cadgen.deviations.deviation import COLUMNS, Deviation, ToleranceZone
from cadgen.deviations.first_order import ROWS, Expansion, OtherEdge, steering_derivatives
from cadgen.inference.monte_carlo.cars import nominal_cars, run_cars
from tests.deviations.displaced import Disc, rest

COLUMN = {name: number for number, name in enumerate(COLUMNS)}
HEAT = Expansion(disc=70e-6, frame=23e-6, rod=12e-6)
STATIONS = 1800
GRID = np.linspace(0.0, TURN, STATIONS, endpoint=False)
# What is displaced, and by how much: in words of the oracle, and in columns of the fleet.
TILT, SHIFT = np.radians(0.05), 0.02
CASES = {
    "eccentricity_0": ({"shift": (SHIFT, 0.0)}, SHIFT),
    "eccentricity_90": ({"shift": (0.0, SHIFT)}, SHIFT),
    "wobble_0": ({"tilt": (TILT, 0.0)}, TILT),
    "wobble_90": ({"tilt": (0.0, TILT)}, TILT),
    "rod_height": ({"height": 0.02}, 0.02),
    "taper": ({"taper": 0.01}, 0.01),
    "temperature": ({"scale": 1 + 10 * HEAT.disc}, 10.0),
}


@pytest.fixture(scope="module")
def disc(carbon_free_car):
    return Disc.of(carbon_free_car.actual.curve)


@pytest.fixture(scope="module")
def contact(carbon_free_car):
    return roll(carbon_free_car.actual.curve.outline(0.06), carbon_free_car.follower, GRID)


@pytest.fixture(scope="module")
def at_rest(disc, carbon_free_car):
    return rest(disc, carbon_free_car.follower, GRID)


def grown(rod, kelvin):
    """The rod and the frame when it is warmer: the disc's middle and the camshaft go with the frame."""
    middle, half = (rod.inner + rod.outer) / 2 * (1 + kelvin * HEAT.frame), (rod.outer - rod.inner) / 2
    return replace(
        rod,
        base_radius=rod.base_radius * (1 + kelvin * HEAT.frame),
        inner=middle - half,
        outer=middle + half,
        radius=rod.radius * (1 + kelvin * HEAT.rod),
    )


@pytest.fixture(scope="module")
def displaced(disc, carbon_free_car):
    rod = carbon_free_car.follower
    return {
        name: rest(disc, grown(rod, 10.0) if name == "temperature" else rod, GRID, **words)
        for name, (words, _) in CASES.items()
    }


def test_the_oracle_rolls_as_the_contact_does(at_rest, contact):
    np.testing.assert_allclose(at_rest, contact.q, atol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_steering_changes_as_on_the_displaced_disc(name, displaced, at_rest, contact, carbon_free_car):
    names = [list(COLUMNS)[column] for column in ROWS]
    rows = dict(zip(names, steering_derivatives(contact, carbon_free_car.follower, expansion=HEAT), strict=True))
    size = CASES[name][1]
    apart = np.abs(displaced[name] - at_rest - size * rows[name])
    largest = np.abs(size * rows[name]).max()
    print(f"{name}: turns the rod by up to {largest:.2e} rad; linear misses {np.quantile(apart, 0.99) / largest:.2%}")
    # Where the other edge may come to carry the rod, the fleet looks at it, too: see below.
    both = name.startswith(("wobble", "taper"))
    clear = contact.margin / contact.face > (2 * largest if both else 1e-5)
    assert clear.mean() > 0.7
    print(f"and where one edge carries it whatever is off, {np.quantile(apart[clear], 0.99) / largest:.2%}")
    assert np.quantile(apart[clear], 0.99) < 0.01 * largest
    assert apart[clear].max() < 0.1 * largest


@pytest.fixture(scope="module")
def ends(carbon_free_car, contact):
    """Ends of runs of the fleet with one thing off."""
    built = carbon_free_car
    planned = drive(built.lift, built.car, built.track.length, steps=360)
    fleet = nominal_cars(
        contact,
        built.follower,
        built.car,
        built.track.length,
        built.lift,
        planned,
        wheel_radius=63.7,
        play=0.0,
        expansion=HEAT,
    )

    def end(**off: float) -> complex:
        deviations = np.zeros((1, len(COLUMNS)))
        for name, value in off.items():
            deviations[0, COLUMN[name]] = value
        return complex(run_cars(fleet, deviations).position[0, -1])

    return lambda **off: end(**off) - end()


def driven(built, tan_beta, **car) -> complex:
    lift = sampled_lift(GRID, tan_beta, blend_start=built.lift.blend_start)
    run = drive(lift, replace(built.car, **car), built.track.length, steps=360)
    return complex(*(run.drive_wheel[-1] - run.drive_wheel[0]))


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_the_end_of_the_run_moves_as_with_the_displaced_disc(name, displaced, at_rest, ends, carbon_free_car):
    """Within 2 %, with nothing linear on the other side."""
    built, (_, size) = carbon_free_car, CASES[name]
    warm = 1 + size * HEAT.frame if name == "temperature" else 1.0
    dimensions = {one: getattr(built.car, one) * warm for one in ("wheelbase", "drive_wheel_offset")}
    exact = driven(built, displaced[name], **dimensions) - driven(built, at_rest)
    mine = ends(**{name: size})
    print(f"{name} {size:g}: {abs(exact):.1f} mm displaced, {abs(mine):.1f} mm to first order")
    assert abs(mine - exact) < 0.02 * abs(exact) + 0.06


def test_an_eccentricity_of_20_um_in_the_worst_direction_costs_163_mm(ends, disc, at_rest, carbon_free_car):
    along, across = ends(eccentricity_0=SHIFT), ends(eccentricity_90=SHIFT)
    angle = np.linspace(0, np.pi, 361)
    size = np.abs(np.cos(angle) * along + np.sin(angle) * across)
    worst = angle[np.argmax(size)]
    moved = rest(disc, carbon_free_car.follower, GRID, shift=(SHIFT * np.cos(worst), SHIFT * np.sin(worst)))
    exact = abs(driven(carbon_free_car, moved) - driven(carbon_free_car, at_rest))
    print(f"{size.max():.1f} mm at {np.degrees(worst):.0f} degrees to first order, {exact:.1f} mm rolled")
    assert size.max() == pytest.approx(163, rel=0.02)
    assert exact == pytest.approx(163, rel=0.02)


def test_what_the_issue_says_of_other_things_that_are_off(ends):
    assert abs(ends(edge_break=0.1)) == pytest.approx(149, rel=0.02)
    assert abs(ends(edge_wear=0.1)) == abs(ends(edge_break=0.1))
    assert abs(ends(steering_lost_motion=np.radians(0.05))) == pytest.approx(257, rel=0.03)
    assert 550 < abs(ends(temperature=10.0)) < 700
    assert max(abs(ends(wobble_0=2 * TILT)), abs(ends(wobble_90=2 * TILT))) == pytest.approx(40, rel=0.05)


def test_the_other_edge_is_as_far_below_as_rolling_finds_it(contact, carbon_free_car):
    other = OtherEdge.of(contact, carbon_free_car.follower)
    np.testing.assert_allclose(other.below, contact.margin / contact.face, rtol=0.05, atol=2e-6)


def test_an_eccentric_wheel_moves_the_car_as_far_as_it_rolls(carbon_free_car, ends):
    """Against sums of small steps along the planned steering, the wheel's radius changing as it turns."""
    built, off = carbon_free_car, 0.5
    motor = np.linspace(0.0, built.lift.blend_start, 200_001)
    middle = (motor[1:] + motor[:-1]) / 2
    wheel = built.lift.q(middle)
    curvature = -wheel / (built.car.wheelbase + built.car.drive_wheel_offset * wheel)
    turns = built.track.length / (TURN * 63.7)
    for number, name in enumerate(("wheel_runout_0", "wheel_runout_90")):
        places = []
        for size in (0.0, off):
            rolled = 1 + size / 63.7 * (np.cos(turns * middle) if number == 0 else np.sin(turns * middle))
            arc = built.track.length / TURN * np.diff(motor) * rolled
            heading = np.concatenate([[0.0], np.cumsum(curvature * arc)])
            places.append(np.sum(arc * np.exp(0.5j * (heading[1:] + heading[:-1]))))
        exact = places[1] - places[0]
        assert abs(ends(**{name: off}) - exact) < 0.02 * abs(exact) + 0.01


@pytest.mark.parametrize(("unit", "key"), [("mm", "drag_mm"), ("rad", "drag_deg"), ("Nmm", "drag_Nmm"), ("1", "drag")])
def test_the_key_of_a_tolerance_has_the_unit_at_its_end(unit, key):
    assert Deviation("drag of mine", "drag", unit, zone=ToleranceZone(10, "drag")).tolerance_key == key
