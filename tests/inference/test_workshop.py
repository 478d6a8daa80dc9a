"""Workshop's prior, on cars whose spreads are known because the test made them."""

import numpy as np
import pytest

from cadgen.inference.workshop import Shown, learn


def made(rng, cars, spread, mean, noise, rows=12):
    """Cars with known deviations; each reading mixes several of them, and some cars lack half of the readings."""
    shown = []
    for number in range(cars):
        theta = mean + spread * rng.standard_normal(len(spread))
        mixed = rng.standard_normal((rows if number % 2 else rows // 2, len(spread))) / noise
        read = mixed @ theta + rng.standard_normal(len(mixed))
        shown.append(Shown(mixed.T @ mixed, mixed.T @ read))
    return shown


TRUE = np.array([0.05, 0.2, 0.5, 1.0, 0.3, 0.3])
GROUPS = [0, 1, 2, 3, 4, 4]


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("cars", [3, 12])
def test_the_ranges_of_spreads_hold_as_often_as_they_say(cars):
    """And a further car lies in the stated 90 % range about nine times of ten, also after three cars."""
    rng = np.random.default_rng(cars)
    held, inside = [], []
    for _ in range(25):
        mean = 0.3 * rng.standard_normal(len(TRUE))
        found = learn(made(rng, cars, TRUE, mean, 0.2), GROUPS)
        held.append((found.least <= TRUE) & (found.most >= TRUE))
        further = mean + TRUE * rng.standard_normal((200, len(TRUE)))
        inside.append(np.abs(further - found.mean) <= 1.645 * found.spread)
    assert 0.82 <= np.mean(held) <= 1.0
    assert 0.85 <= np.mean(inside) <= 0.99
    # No more than the range of a t distribution of so few cars asks for.
    assert np.median(found.spread[2:] / TRUE[2:]) < (4.5 if cars == 3 else 1.6)


def test_many_cars_give_their_own_spread():
    rng = np.random.default_rng(1)
    found = learn(made(rng, 60, TRUE, np.full(6, 0.4), 0.1), GROUPS)
    assert found.spread[1:] == pytest.approx(TRUE[1:], rel=0.3)
    assert found.mean[:2] == pytest.approx(0.4, abs=0.12)
    assert np.all(found.cars > 55)


def test_what_no_record_shows_counts_for_no_car():
    rng = np.random.default_rng(2)
    blind = [Shown(np.diag([25.0, 0.0]), np.array([25 * theta, 0.0])) for theta in 0.2 * rng.standard_normal(10)]
    found = learn(blind, [0, 1])
    assert found.cars == pytest.approx([9.6, 0.0], abs=0.1)
    assert found.spread[1] > 1


def test_two_directions_that_records_hardly_tell_apart_are_known_as_well_as_the_records_say():
    """Alike cars of which the sum is seen and, with a noise of 1, 0.3 times the difference: 1 / (0.6 sqrt(30)) each."""
    rng = np.random.default_rng(0)
    rows = np.array([[300.0, 300.0], [0.3, -0.3]])
    cars = []
    for _ in range(30):
        read = rows @ (2.0 + 0.01 * rng.standard_normal(2)) + rng.standard_normal(2)
        cars.append(Shown(rows.T @ rows, rows.T @ read))
    found = learn(cars, [0, 1])
    assert found.spread == pytest.approx(1 / (0.6 * np.sqrt(30)), rel=0.1)
    assert np.all(np.abs(found.mean - 2.0) < 2 * found.spread)
