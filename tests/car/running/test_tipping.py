"""Tipping: the loads of three wheels by the equilibrium of a body whose motion is differentiated numerically."""

import numpy as np
import pytest

from cadgen.car.running.tipping import GRAVITY, tipping

WHEELS = np.array([[0.0, 0.0], [0.0, -238.0], [167.0, -37.0]])


def loads(speed, centre, curvature, slope):
    """Shares of the weight on the wheels at a place of a clothoid, from positions of the centre of gravity by time."""
    step = 1e-3
    times = np.arange(-2, 3) * step
    s = np.linspace(speed * times[0], speed * times[-1], 40001)
    heading = curvature * s + slope * s**2 / 2
    steps = np.exp(1j * heading)
    place = np.concatenate([[0.0], np.cumsum((steps[1:] + steps[:-1]) / 2)]) * (s[1] - s[0])
    body = place + np.exp(1j * heading) * complex(*centre[:2])
    at = np.interp(times * speed, s, body.real) + 1j * np.interp(times * speed, s, body.imag)
    acceleration = (-at[0] + 16 * at[1] - 30 * at[2] + 16 * at[3] - at[4]) / (12 * step**2)
    acceleration *= np.exp(-1j * np.interp(0.0, s, heading))
    # Weight and forces at the floor: moments about the centre of gravity vanish.
    arms = WHEELS - centre[:2]
    ahead, left = acceleration.real / GRAVITY, acceleration.imag / GRAVITY
    return np.linalg.solve(
        np.array([[1.0, 1.0, 1.0], arms[:, 0], arms[:, 1]]),
        np.array([1.0, -centre[2] * ahead, -centre[2] * left]),
    )


@pytest.mark.parametrize(
    ("curvature", "slope", "centre"),
    [
        (1 / 600, 0.0, (65.0, -56.0, 67.0)),
        (-1 / 600, 0.0, (65.0, -56.0, 67.0)),
        (1 / 800, 8e-6, (40.0, -100.0, 90.0)),
        (-1 / 900, 9e-6, (90.0, -60.0, 40.0)),
    ],
)
def test_a_wheel_loses_its_load_at_the_speed_of_tipping(curvature, slope, centre):
    found = tipping(np.array([0.0]), np.array([curvature]), np.array([slope]), WHEELS, centre)
    lost = loads(found.speed, centre, curvature, slope)
    print(f"{found.speed:.1f} mm/s over edge {found.edge}: loads {lost}")
    # The wheel across the edge is that which is neither of its ends.
    assert int(np.argmin(lost)) == (found.edge + 2) % 3
    assert lost.min() == pytest.approx(0.0, abs=2e-4)
    assert loads(0.99 * found.speed, centre, curvature, slope).min() > 0


def test_on_a_circle_about_the_middle_of_a_tall_car():
    """v² κ h = g d on a circle so large that the car's own size plays no part."""
    wide = np.array([[0.0, 100.0], [0.0, -100.0], [1e6, 0.0]])
    found = tipping(np.array([7.0]), np.array([1e-6]), np.array([0.0]), wide, (20.0, 0.0, 50.0))
    assert found.speed == pytest.approx(np.sqrt(GRAVITY * 100.0 / 50.0 / 1e-6), rel=1e-3)
    assert found.arc == 7.0


def test_a_straight_path_tips_no_car_and_a_centre_outside_the_wheels_tips_at_once():
    arc, straight = np.linspace(0, 10, 5), np.zeros(5)
    assert tipping(arc, straight, straight, WHEELS, (60.0, -60.0, 50.0)).speed == np.inf
    outside = tipping(arc, straight, straight, WHEELS, (60.0, 10.0, 50.0))
    assert outside.speed == 0.0
    assert outside.room < 0
    assert outside.edge == 2
