"""The play operator against a cam that a brute-force simulator turns step by step."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import PPoly

from cadgen.arrays import TURN
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import Following, _without_small_swings, falls, follow
from cadgen.errors import DesignError


def step_by_step(lift: PathMotion, play: float, steps: int, turns: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Motor and cam angles of a cam on a grid: pushed by the gears, else rolling downhill as far as the play lets it.

    Knows nothing of events: at each step of the motor the cam moves cell by cell while the next one is lower.
    """
    step = TURN / steps
    height = lift.q(step * np.arange(steps))
    room = round(play / step)
    cam, seen = 0, []
    for motor in range(turns * steps):
        cam = max(cam, motor)
        while cam < motor + room and height[(cam + 1) % steps] < height[cam % steps]:
            cam += 1
        while cam > motor and height[(cam - 1) % steps] < height[cam % steps]:
            cam -= 1
        seen.append(cam)
    return step * np.arange(turns * steps), step * np.array(seen)


def stepped(values: list[float]) -> PathMotion:
    """A closed lift of straight pieces, level where neighbours are equal."""
    x = np.linspace(0.0, TURN, len(values) + 1)
    closed = np.append(values, values[0])
    return PathMotion(
        PPoly(np.stack([np.diff(closed) / np.diff(x), closed[:-1]]), x, extrapolate="periodic"), x[1:-1], TURN
    )


@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
@pytest.mark.parametrize("play_deg", [0.0, 0.724, 0.962, 3.0])
def test_follows_as_the_simulator_does(name, play_deg, request):
    lift = request.getfixturevalue(name).lift
    steps = 36000
    motor, cam = step_by_step(lift, np.radians(play_deg), steps)
    mine = follow(lift, np.radians(play_deg)).cam_angle(motor)
    # The grid finds an event one cell late at most, and only there may a whole jump differ.
    apart = np.abs(mine - cam) > 1.5 * TURN / steps
    assert apart.sum() <= len(falls(lift))
    assert not apart[~np.isclose(np.min(np.abs(motor[:, None] - falls(lift)[:, 0]), axis=1), 0, atol=2e-4)].any()


@settings(max_examples=60, deadline=None)
@given(
    values=st.lists(st.integers(-8, 8), min_size=4, max_size=9),
    play=st.floats(0.0, 3.0),
)
def test_any_lift_and_any_play(values, play):
    """Also where the play is wider than events are apart, and on level stretches at peaks and in valleys."""
    level = [2.0 * v for v in values]
    lift = stepped(level)
    steps = 360 * len(values)
    motor, cam = step_by_step(lift, play, steps, turns=2)
    play = round(play / (TURN / steps)) * TURN / steps
    found = falls(lift, least_swing=0.0)
    mine = Following(lift, play, found).cam_angle(motor)
    tail = motor > TURN  # the simulator's first turn starts from rest at 0
    assert np.mean(np.abs(mine - cam)[tail] > 1.5 * TURN / steps) < 2 * len(values) / steps


def test_without_play_the_cam_stands_where_the_motor_does(carbon_free_car):
    motor = np.linspace(-1.0, 15.0, 1001)
    np.testing.assert_array_equal(follow(carbon_free_car.lift, 0.0).cam_angle(motor), motor)


def test_erosion_differs_only_before_the_peaks(carbon_free_car):
    """The least lift in the window is the realised one, but for half a window before each peak."""
    lift, play = carbon_free_car.lift, np.radians(0.962)
    motor = np.linspace(0.0, lift.blend_start, 20001)
    window = np.linspace(0.0, play, 201)
    eroded = np.min(lift.q(motor[:, None] + window), axis=1)
    realised = follow(lift, play).tan_beta(motor)
    # The window's own grid is 8e-5 rad wide, and at a valley the lift rises by half its square.
    before = (falls(lift)[:, 0] - motor[:, None] >= 0) & (falls(lift)[:, 0] - motor[:, None] < 0.55 * play)
    apart = np.abs(realised - eroded) > 1e-7
    assert apart.any()
    assert not apart[~before.any(axis=1)].any()
    assert (realised - eroded).min() > -1e-7


def test_falls_are_those_of_the_lift(carbon_free_car, appendix_car):
    for car in (carbon_free_car, appendix_car):
        peaks, valleys = car.lift.extrema()
        np.testing.assert_allclose(falls(car.lift)[:, 0], peaks, atol=1e-8)
        np.testing.assert_allclose(np.sort(falls(car.lift)[:, 1] % TURN), valleys, atol=1e-8)


@settings(max_examples=50, deadline=None)
@given(noise_at=st.lists(st.integers(0, 399), min_size=1, max_size=30, unique=True), sign=st.sampled_from([-1, 1]))
def test_noise_makes_no_events(noise_at, sign):
    """Ripples below the least swing, also on the peak, in the valley and across 0, leave one fall."""
    x = np.linspace(0.0, TURN, 401)[:-1]
    height = 0.2 * np.cos(x - 0.02)
    clean = falls(stepped(list(height)), least_swing=1e-3)
    height[noise_at] += sign * 4e-4
    noisy = falls(stepped(list(height)), least_swing=1e-3)
    assert noisy.shape == clean.shape == (1, 2)
    # A ripple of 4e-4 can carry the peak no further than where the cosine has dropped by as much.
    moved = (noisy - clean + np.pi) % TURN - np.pi
    assert np.abs(moved).max() < 0.1


def test_a_level_lift_has_no_falls():
    assert falls(stepped([0.3] * 8)).shape == (0, 2)
    motor = np.linspace(0.0, 1.0, 5)
    np.testing.assert_array_equal(follow(stepped([0.3] * 8), 0.1).cam_angle(motor), motor)


def test_a_dwell_at_a_peak_belongs_to_the_rise():
    lift = stepped([0.0, 1.0, 1.0, 0.0])
    np.testing.assert_allclose(falls(lift), [[TURN / 2, TURN * 3 / 4]], atol=1e-12)


@pytest.mark.parametrize("play", [-0.01, float("nan")])
def test_refuses_a_play_that_is_none(carbon_free_car, play):
    with pytest.raises(DesignError, match="must be 0 or more"):
        follow(carbon_free_car.lift, play)


def test_a_level_stretch_ends_a_fall():
    """A straight run between two turns: nothing pulls the cam across it, so the gears take it up and it jumps after."""
    lift = stepped([1.0, 0.5, 0.5, 0.0, 0.5])
    fifth = TURN / 5
    np.testing.assert_allclose(falls(lift), [[0.0, fifth], [2 * fifth, 3 * fifth]], atol=1e-12)
    stands = follow(lift, 0.1).cam_angle(np.array([0.5 * fifth, fifth - 0.01, 1.5 * fifth, 2 * fifth + 1e-9]))
    np.testing.assert_allclose(stands, [0.5 * fifth + 0.1, fifth, 1.5 * fifth, 2 * fifth + 0.1], atol=1e-8)


def test_a_level_stretch_across_the_start_is_met_once():
    lift = stepped([0.5, 0.0, 1.0, 0.5])
    np.testing.assert_allclose(lift.level, [[TURN * 3 / 4, TURN]], atol=1e-12)
    np.testing.assert_allclose(falls(lift), [[0.0, TURN / 4], [TURN / 2, TURN * 3 / 4]], atol=1e-12)


def test_a_play_wider_than_events_are_apart(carbon_free_car):
    """The valley at 240.6 and the peak at 266.5 degrees are the closest: 26 degrees of play reach over both."""
    lift, play, steps = carbon_free_car.lift, np.radians(30.0), 36000
    motor, cam = step_by_step(lift, play, steps, turns=2)
    mine = follow(lift, play).cam_angle(motor)
    apart = np.abs(mine - cam)[steps:] > 1.5 * TURN / steps
    assert apart.sum() <= len(falls(lift))


def passed_over_one_by_one(height: np.ndarray, least: float) -> list[int]:
    """Turning points that stay, by searching the whole row for its smallest swing each time."""
    row = list(range(len(height)))
    while row:
        swings = [abs(height[row[(k + 1) % len(row)]] - height[at]) for k, at in enumerate(row)]
        smallest = swings.index(min(swings))
        if swings[smallest] >= least:
            break
        # Where the last valley and the first peak go, the last peak comes first.
        last = smallest + 1 == len(row)
        row = row[-2:-1] + row[1:-2] if last else row[:smallest] + row[smallest + 2 :]
    return row


@pytest.mark.slow
@settings(max_examples=400, deadline=None)
@given(
    pairs=st.lists(st.tuples(st.integers(0, 8), st.integers(0, 8)), max_size=12),
    least=st.sampled_from([0.0, 0.5, 1.5, 3.0, 20.0]),
)
def test_small_swings_are_passed_over_as_one_by_one(pairs, least):
    height = np.array([value for high, low in pairs for value in (max(high, low), min(high, low))], dtype=float)
    assert _without_small_swings(height, least).tolist() == passed_over_one_by_one(height, least)
