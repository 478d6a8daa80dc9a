"""Monte Carlo over the tolerances: reproducible, lawful, and in line with the sensitivities."""

import re
import tracemalloc
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.car.running.run_errors import run_error
from cadgen.car.running.sampled import sampled_lift
from cadgen.deviations.deviation import COLUMNS
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.cars import nominal_cars
from cadgen.inference.monte_carlo.random_cars import (
    CHUNK,
    MOST_STEERING,
    Tolerances,
    errors_of_cars,
    sensitivities,
    tolerance_run,
)
from cadgen.processes import in_processes

NAMES = list(COLUMNS)
PLAY = np.radians(0.8)
HALF_WIDTHS = {"base_radius": 0.004, "wheelbase": 0.05, "start_y": 1.0, "start_heading": np.radians(0.1)}


@pytest.fixture(scope="module")
def fleet(carbon_free_car):
    built = carbon_free_car
    contact = roll(built.actual.curve.outline(0.2), built.follower, np.linspace(0.0, TURN, 900, endpoint=False))
    planned = drive(built.lift, built.car, built.track.length, steps=360)
    return nominal_cars(
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
    shared = tolerance_run(fleet, tolerances, 3 * CHUNK + 17, seed=11, map_with=partial(in_processes, 3))
    mapped = tolerance_run(fleet, tolerances, 3 * CHUNK + 17, seed=11, map_with=map)
    for name in ("heading", "along", "across", "widest"):
        np.testing.assert_array_equal(getattr(alone, name), getattr(shared, name))
        np.testing.assert_array_equal(getattr(alone, name), getattr(mapped, name))
    other = tolerance_run(fleet, tolerances, CHUNK, seed=12)
    assert not np.isclose(other.distance, alone.distance[:CHUNK]).any()


def test_a_longer_run_begins_with_the_cars_of_a_shorter(fleet):
    tolerances = Tolerances(half_widths=HALF_WIDTHS, play=(0.012, 0.015))
    short, long = (tolerance_run(fleet, tolerances, count, seed=5) for count in (2 * CHUNK, 5 * CHUNK))
    np.testing.assert_array_equal(short.distance, long.distance[: 2 * CHUNK])
    np.testing.assert_array_equal(short.widest, long.widest[: 2 * CHUNK])


def test_random_cars_are_those_drawn_from_the_children_of_the_seed(fleet):
    """Extremes kept car by car equal those of all stations run at once; not all are widest at the end."""
    tolerances = Tolerances(half_widths={**HALF_WIDTHS, "start_y": 3000.0}, play=(0.012, 0.015))
    kept = tolerance_run(fleet, tolerances, CHUNK + 7, seed=5)
    children = np.random.SeedSequence(5).spawn(2)
    drawn = [
        tolerances.draw(np.random.default_rng(child), n, PLAY) for child, n in zip(children, (CHUNK, 7), strict=True)
    ]
    errors = errors_of_cars(fleet, np.concatenate(drawn))
    for name in ("heading", "along", "across"):
        np.testing.assert_allclose(getattr(kept, name), getattr(errors, name)[:, -1], atol=1e-8)
    np.testing.assert_allclose(kept.widest, np.abs(errors.across).max(axis=1), atol=1e-8)
    assert 0.1 < np.mean(np.abs(errors.across).argmax(axis=1) < 2) < 0.9


@pytest.mark.slow
def test_memory_is_for_what_is_kept_and_not_for_what_is_drawn(fleet):
    """Four numbers of 8 bytes for each car beside one chunk's work; the draw alone would have 14."""
    tolerances = Tolerances(half_widths=HALF_WIDTHS, play=(0.012, 0.015))
    peaks = []
    for samples in (CHUNK, 61 * CHUNK):
        tracemalloc.start()
        tolerance_run(fleet, tolerances, samples, seed=5)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    print(f"{(peaks[1] - peaks[0]) / (60 * CHUNK):.1f} bytes for each car more")
    assert peaks[1] - peaks[0] < 40 * 60 * CHUNK


@pytest.mark.parametrize("name", ["base_radius", "inner_face", "outer_face", "rod_radius", "steering_zero"])
@pytest.mark.parametrize("sign", [-1, 1])
def test_first_order_misses_two_percent_at_the_widest_tolerance(carbon_free_car, fleet, name, sign):
    """Against the rod rolled anew with the changed dimension: what its tolerance does, at the end of the run."""
    built = carbon_free_car
    half = MOST_STEERING / np.abs(fleet.derivatives[NAMES.index(name)]).max()
    assert tolerance_run(fleet, Tolerances(half_widths={name: 0.999 * half}), 1, seed=0)
    deviations = np.zeros((2, len(NAMES)))
    deviations[1, NAMES.index(name)] = sign * half
    linear = errors_of_cars(fleet, deviations)
    ends = linear.along[:, -1] + 1j * linear.across[:, -1]

    fields = {"base_radius": "base_radius", "inner_face": "inner", "outer_face": "outer", "rod_radius": "radius"}
    follower, zero = built.follower, 0.0
    if name == "steering_zero":
        zero = sign * half
    else:
        changed = getattr(follower, fields[name]) + sign * half
        follower = replace(follower, **{fields[name]: changed})
    theta = np.linspace(0.0, TURN, 3600, endpoint=False)
    tan_beta = roll(built.actual.curve.outline(0.1), follower, theta).q
    cam = sampled_lift(theta, np.tan(np.arctan(tan_beta) + zero), blend_start=built.lift.blend_start)
    planned = drive(built.lift, built.car, built.track.length)
    error = run_error(drive(cam, built.car, built.track.length, play=PLAY, stop=built.lift.blend_start), planned)
    bare = run_error(drive(built.lift, built.car, built.track.length, play=PLAY), planned)
    exact = error.along[-1] - bare.along[-1] + 1j * (error.across[-1] - bare.across[-1])
    missed = abs(ends[1] - ends[0] - exact)
    print(f"{name} {sign * half:.4f}: {abs(exact):.1f} mm, first order misses {missed:.1f} mm")
    assert missed < 0.02 * abs(exact)


@pytest.mark.parametrize(
    ("half_widths", "words"),
    [
        (
            {"rod_radius": 10.0},
            r"tolerances\.rod_radius_mm is 10 mm, which turns the front wheel by up to 26 degrees.*0\.0\d+ mm or less",
        ),
        (
            {"steering_zero": np.radians(1.0)},
            r"tolerances\.steering_zero_deg is 1 degrees.*0\.2\d degrees or less",
        ),
        ({"wheelbase": 20.0}, "wheelbase is 20 mm, more than a tenth of the 167 mm itself: make it 16 mm or less"),
        ({"wheel_radius": 10.0}, "wheel_radius is 10 mm, more than a tenth of the 63.7 mm itself"),
    ],
)
def test_refuses_tolerances_beyond_first_order(fleet, half_widths, words):
    with pytest.raises(DesignError, match=words) as caught:
        tolerance_run(fleet, Tolerances(half_widths=half_widths), 10, seed=0)
    # What is advised is accepted.
    advised = float(re.search(r"make it (\S+) ", str(caught.value))[1])
    (name,) = half_widths
    half = np.radians(advised) if COLUMNS[name] == "rad" else advised
    assert tolerance_run(fleet, Tolerances(half_widths={name: half}), 1, seed=0).distance.shape == (1,)


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


@pytest.mark.slow
def test_sensitivities_explain_the_spread(fleet):
    """For small tolerances the variance of the end is the sum of the parts, and the shares are their parts of it."""
    tolerances = Tolerances(half_widths=HALF_WIDTHS)
    found = sensitivities(fleet, tolerances)
    assert [one.name for one in found] == [one.name for one in sorted(found, key=lambda one: -one.share)]
    assert sum(one.share for one in found) == pytest.approx(1.0)
    run = tolerance_run(fleet, tolerances, 4000, seed=2)
    spread = run.along.var() + run.across.var()
    predicted = sum((one.distance / one.step * 0.3288 * HALF_WIDTHS[one.name]) ** 2 for one in found)
    assert spread == pytest.approx(predicted, rel=0.05)
    alone = {one.name: one.share for one in found}
    for name in HALF_WIDTHS:
        only = tolerance_run(fleet, Tolerances(half_widths={name: HALF_WIDTHS[name]}), 4000, seed=2)
        share = (only.along.var() + only.across.var()) / spread
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


def test_without_tolerances_every_car_is_the_nominal_one(fleet):
    run = tolerance_run(fleet, Tolerances(half_widths={}), 3, seed=0)
    nominal = errors_of_cars(fleet, np.zeros((1, len(NAMES))))
    np.testing.assert_array_equal(run.across, np.repeat(nominal.across[:, -1], 3))
    assert sensitivities(fleet, Tolerances(half_widths={})) == ()


def test_what_moves_nothing_has_no_share(fleet):
    """Play without a fall does that: the shares of all were divided by nothing."""
    straight = replace(fleet, falls=np.empty((0, 2)))
    (only,) = sensitivities(straight, Tolerances(half_widths={}, play=(0.012, 0.015)))
    assert (only.name, only.share) == ("play", 0)


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
