"""How much later a cam with inertia leads, by a time integration, against what is said of a faster car."""

from math import degrees, radians

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.car.running.mechanics import Mechanics
from cadgen.jobs.cam.mechanics import _LATER

INERTIA = 0.26  # N mm s^2
PLAY = radians(0.738)
GRID = np.linspace(0.0, TURN, 14_400, endpoint=False)


def end(built, friction: float, rate: float) -> float:
    """End of the run of a car whose cam turns by a rate, rad/s: mass on a shaft between two stops that move."""
    torque = Mechanics(follower=built.follower, friction=friction).torque(built.lift, GRID)
    table = np.where(np.isfinite(torque), torque, -1e3).tolist()
    step = radians(0.002)  # of the motor
    dt, count, per = step / rate, int(built.lift.blend_start / step), len(GRID) / TURN
    cam, speed, angles = 0.0, rate, np.empty(count)
    for number in range(count):
        motor = number * step
        speed += table[int(cam * per) % len(table)] / INERTIA * dt
        cam += speed * dt
        if cam <= motor:
            cam, speed = motor, rate
        elif cam >= motor + PLAY:
            cam, speed = motor + PLAY, min(speed, rate)
        speed = max(speed, 0.0)
        angles[number] = cam
    return abs(_track(built, angles, step) - _track(built, np.arange(count) * step, step))


def _track(built, angles, step) -> complex:
    tangent = np.interp(angles, GRID, built.lift.q(GRID), period=TURN)
    arc = built.track.length / TURN * step
    bend = -tangent / (built.car.wheelbase + built.car.drive_wheel_offset * tangent) * arc
    return complex(arc * np.exp(1j * (np.cumsum(bend) - bend / 2)).sum())


@pytest.mark.parametrize(("friction", "share"), [(0.0, _LATER[0]), (0.3, _LATER[1])])
def test_a_faster_car_ends_nearer_by_what_is_said(friction, share, carbon_free_car):
    slow, fast = end(carbon_free_car, friction, radians(1.0)), end(carbon_free_car, friction, radians(20.0))
    less = 1 - fast / slow
    print(f"friction {friction}: {slow:.0f} mm slowly, {fast:.0f} mm at {degrees(radians(20.0)):.0f} degrees/s")
    assert 0 < less < 0.07
    assert less == pytest.approx(share * radians(19.0), rel=0.3)
