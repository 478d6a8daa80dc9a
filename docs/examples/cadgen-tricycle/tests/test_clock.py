"""Clocks of camera and log: found where speeds change, left alone where they agree or nothing shows them."""

import numpy as np
import pytest
from cadgen_tricycle.clock import Clock, clock

DURATION, ROWS = 120.0, 2400


def travelled(time: np.ndarray, stops: float) -> np.ndarray:
    """Distance by time, mm, of a vehicle that starts and stops every 30 s; of constant speed at `stops` 0.

    Its speed is 100 mm/s times (1 + stops sign sin)/(1 + stops), integrated in closed form over half periods.
    """
    half, high, low = 15.0, 100.0, 100.0 * (1 - stops)
    whole, rest = np.divmod(time, half)
    full = half * (np.ceil(whole / 2) * high + np.floor(whole / 2) * low)
    return np.where(time < 0, high * time, full + rest * np.where(whole % 2 == 0, high, low))


def run(lag: float, rate: float, *, stops: float, scale: float, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, places seen on a circle of 2 m with 1 mm of noise, and distances logged in whole steps of 0.5 mm."""
    rng, time = np.random.default_rng(seed), np.arange(ROWS) * DURATION / ROWS
    seen = travelled(time * (1 + rate) + lag, stops)
    noise = rng.normal(0, 1, (2, ROWS))
    place = 2000 * np.exp(1j * seen / 2000) + noise[0] + 1j * noise[1]
    return time, place, np.round(2 * travelled(time, stops) / scale) / 2


@pytest.mark.parametrize(("lag", "rate"), [(1.5, -0.018), (-0.8, 0.006), (0.6, 0.0)])
@pytest.mark.parametrize("stops", [1.0, 0.2])
def test_lag_and_rate_are_found_whatever_the_scale_of_the_odometer(lag: float, rate: float, stops: float) -> None:
    """Also where the speed changes by a fifth only, and the odometer is 3 % off."""
    found = clock(*run(lag, rate, stops=stops, scale=1.03, seed=1))
    assert found.lag == pytest.approx(lag, abs=0.05)
    assert found.rate == pytest.approx(rate, abs=0.001)


@pytest.mark.parametrize(("lag", "rate", "stops"), [(0.0, 0.0, 1.0), (0.0, 0.0, 0.2), (1.0, 0.01, 0.0)])
def test_clocks_that_agree_or_that_no_speed_shows_are_left_alone(lag: float, rate: float, stops: float) -> None:
    """At constant speed no lag shows."""
    assert not any(clock(*run(lag, rate, stops=stops, scale=1.03, seed=seed)) for seed in range(10))


def test_time_of_the_log_at_times_of_the_camera() -> None:
    """By hand: a second ahead at the start, and as much behind 200 s later."""
    assert Clock(1.0, -0.01).log_time(np.array([0.0, 200.0])).tolist() == [1.0, 199.0]
