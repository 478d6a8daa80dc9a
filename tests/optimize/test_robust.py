"""Monte Carlo over the tolerances: reproducible, lawful, and in line with the sensitivities."""

import numpy as np
import pytest

from cadgen.cam.contact import roll
from cadgen.errors import DesignError
from cadgen.motion.drive import TURN, drive
from cadgen.optimize.fleet import PARAMETERS, make_fleet
from cadgen.optimize.robust import CHUNK, Tolerances, fleet_errors, sensitivities, tolerance_run

NAMES = list(PARAMETERS)
PLAY = np.radians(0.8)
HALF_WIDTHS = {"base_radius": 0.004, "wheelbase": 0.05, "start_y": 1.0, "start_heading": np.radians(0.1)}


@pytest.fixture(scope="module")
def fleet(carbon_free_car):
    built = carbon_free_car
    contact = roll(built.actual.curve.outline(0.2), built.follower, np.linspace(0.0, TURN, 900, endpoint=False))
    planned = drive(built.lift, built.car, built.track.length, steps=360)
    return make_fleet(
        contact,
        built.follower,
        built.car,
        built.track.length,
        built.lift,
        planned,
        wheel_radius=63.7,
        play=PLAY,
        stations=(90, 180, 360),
    )


def sampler(generator: np.random.Generator, count: int) -> np.ndarray:
    return generator.triangular(0.01, 0.013, 0.016, count)


@pytest.mark.parametrize("play", [None, (0.012, 0.015), sampler])
def test_a_seed_gives_the_same_numbers_on_any_number_of_processes(fleet, play):
    tolerances = Tolerances(half_widths=HALF_WIDTHS, play=play)
    alone = tolerance_run(fleet, tolerances, 3 * CHUNK + 17, seed=11)
    shared = tolerance_run(fleet, tolerances, 3 * CHUNK + 17, seed=11, processes=3)
    for name in ("deviations", "heading", "along", "across"):
        np.testing.assert_array_equal(getattr(alone, name), getattr(shared, name))
    other = tolerance_run(fleet, tolerances, CHUNK, seed=12)
    assert not np.isclose(other.end_distance, alone.end_distance[:CHUNK]).any()


def test_a_longer_run_begins_with_the_cars_of_a_shorter(fleet):
    tolerances = Tolerances(half_widths=HALF_WIDTHS, play=(0.012, 0.015))
    short, long = (tolerance_run(fleet, tolerances, count, seed=5) for count in (2 * CHUNK, 5 * CHUNK))
    np.testing.assert_array_equal(short.deviations, long.deviations[: 2 * CHUNK])
    np.testing.assert_allclose(short.end_distance, long.end_distance[: 2 * CHUNK], rtol=1e-9)


@pytest.mark.parametrize("law", ["normal", "uniform"])
def test_cars_stay_within_their_tolerances(law):
    tolerances = Tolerances(half_widths=HALF_WIDTHS, law=law, play=(0.012, 0.015))
    drawn = dict(zip(NAMES, tolerances.draw(np.random.default_rng(0), 20000, PLAY).T, strict=True))
    for name, half in HALF_WIDTHS.items():
        assert np.abs(drawn[name]).max() <= half
        # +-3 sigma fill a normal zone, clipped: 0.3288 of its half; a uniform one has half / sqrt(3).
        assert drawn[name].std() == pytest.approx(half * (0.3288 if law == "normal" else 3**-0.5), rel=0.02)
    assert drawn["play"].min() >= 0.012 - PLAY
    assert drawn["play"].max() <= 0.015 - PLAY
    for name in set(NAMES) - set(HALF_WIDTHS) - {"play"}:
        assert not drawn[name].any()


def test_sensitivities_explain_the_spread(fleet):
    """For small tolerances the variance of the end is the sum of the parts, and the shares are their parts of it."""
    tolerances = Tolerances(half_widths=HALF_WIDTHS)
    found = sensitivities(fleet, tolerances)
    assert [one.name for one in found] == [one.name for one in sorted(found, key=lambda one: -one.share)]
    assert sum(one.share for one in found) == pytest.approx(1.0)
    run = tolerance_run(fleet, tolerances, 4000, seed=2)
    spread = run.along[:, -1].var() + run.across[:, -1].var()
    predicted = sum((one.distance / one.step * 0.3288 * HALF_WIDTHS[one.name]) ** 2 for one in found)
    assert spread == pytest.approx(predicted, rel=0.05)
    alone = {one.name: one.share for one in found}
    for name in HALF_WIDTHS:
        only = tolerance_run(fleet, Tolerances(half_widths={name: HALF_WIDTHS[name]}), 4000, seed=2)
        share = (only.along[:, -1].var() + only.across[:, -1].var()) / spread
        assert share == pytest.approx(alone[name], abs=0.03)


def test_known_sensitivities(fleet, carbon_free_car):
    """The start moves the end as a rigid body does; play moves it by what the events cost."""
    found = {one.name: one for one in sensitivities(fleet, Tolerances(half_widths=HALF_WIDTHS, play=(0.012, 0.015)))}
    assert found["start_y"].distance == pytest.approx(0.01)
    assert found["start_heading"].heading == pytest.approx(np.radians(0.1))
    planned = drive(carbon_free_car.lift, carbon_free_car.car, carbon_free_car.track.length)
    ends = [
        drive(carbon_free_car.lift, carbon_free_car.car, carbon_free_car.track.length, play=PLAY + side).drive_wheel[-1]
        for side in np.radians([-0.05, 0.05])
    ]
    assert found["play"].distance == pytest.approx(np.linalg.norm(ends[1] - ends[0]), rel=0.01)
    # Turned at the start, the end swings about it: by the straight distance, lengthened or shortened by play.
    swing = np.linalg.norm(ends[0] - planned.drive_wheel[0]) * np.radians(0.1)
    assert found["start_heading"].distance == pytest.approx(swing, rel=0.01)


def test_yield_and_quantiles(fleet):
    run = tolerance_run(fleet, Tolerances(half_widths=HALF_WIDTHS), 500, seed=1)
    assert run.yield_within(1e9) == 1.0
    assert run.yield_within(0.0) == 0.0
    width = 2 * np.quantile(np.abs(run.across).max(axis=1), 0.8)
    assert run.yield_within(width) == pytest.approx(0.8, abs=0.005)
    shares = np.array([0.1, 0.5, 0.9])
    for share, error in zip(shares, run.quantiles(shares), strict=True):
        assert np.mean(run.end_distance <= error) == pytest.approx(share, abs=0.005)


def test_without_tolerances_every_car_is_the_nominal_one(fleet):
    run = tolerance_run(fleet, Tolerances(half_widths={}), 3, seed=0)
    nominal = fleet_errors(fleet, np.zeros((1, len(NAMES))))
    np.testing.assert_array_equal(run.across, np.repeat(nominal.across, 3, axis=0))
    assert sensitivities(fleet, Tolerances(half_widths={})) == ()


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"half_widths": {"wheel_base": 0.1}}, "no tolerance named wheel_base; use one of base_radius"),
        ({"half_widths": {"play": 0.1}}, "no tolerance named play"),
        ({"half_widths": {"wheelbase": -0.1}}, "wheelbase is -0.1"),
        ({"half_widths": {}, "play": (0.02, 0.01)}, "upwards"),
    ],
)
def test_refuses_tolerances_that_are_none(settings, words):
    with pytest.raises(DesignError, match=words):
        Tolerances(**settings)


def test_refuses_no_samples(fleet):
    with pytest.raises(DesignError, match="0 samples"):
        tolerance_run(fleet, Tolerances(half_widths={}), 0, seed=0)
