"""Curvature <-> steering: the paper's two cases, the inverse, and turns that cannot be held."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.car.path.spline import plan_path
from cadgen.car.path.wheel_track import offset_track
from cadgen.car.steering import Car, steering_jets, tan_steering, track_curvature, wheel_tangent
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError

CAR = Car(wheelbase=167.0, drive_wheel_offset=37.0, idle_wheel_offset=201.0, max_steering_angle=np.radians(35))


def test_equals_the_papers_two_cases():
    """Eq. 17-18 with unsigned radii: tan(beta) = L / (R1 - A1) to the right, L / (R1 + A1) to the left."""
    radius = np.array([300.0, 700.0, 5000.0])
    np.testing.assert_allclose(tan_steering(-1 / radius, CAR), 167.0 / (radius - 37.0))
    np.testing.assert_allclose(tan_steering(1 / radius, CAR), -167.0 / (radius + 37.0))


def test_the_turn_centre_lies_on_the_front_wheels_axle():
    """Plan-view geometry: the front wheel's axle, the rear axle and the drive wheel's radius meet in one point."""
    curvature = np.array([-1 / 400, 1 / 650])
    centre = 1 / curvature  # left of the drive wheel, along the rear axle
    fork = np.array([167.0, -37.0])  # ahead of the axle, right of the drive wheel
    for k, y in zip(curvature, centre, strict=True):
        beta = np.arctan(tan_steering(np.array([k]), CAR))[0]
        rolling = np.array([np.cos(beta), -np.sin(beta)])  # right turns have beta > 0
        assert abs(rolling @ (np.array([0.0, y]) - fork)) < 1e-9


def test_inverse():
    k = np.linspace(-1 / 250, 1 / 250, 101)
    np.testing.assert_allclose(track_curvature(tan_steering(k, CAR), CAR), k, atol=1e-15)


@pytest.mark.parametrize(("zero", "gain"), [(0.1, 1.0), (-0.2, 1.0), (0.0, 1.3), (0.15, 0.8), (0.3, -1.0)])
def test_the_front_wheel_turns_by_zero_and_gain_of_its_lever(zero, gain):
    """Angles are added as angles: beta_w = atan(g tan(beta)) + beta_0."""
    car = replace(CAR, steering_zero=zero, steering_gain=gain)
    tangent = np.tan(np.radians(np.linspace(-35.0, 35.0, 29)))
    np.testing.assert_allclose(np.arctan(wheel_tangent(tangent, car)), np.arctan(gain * tangent) + zero, atol=1e-14)


def test_jets_follow_the_chain_rule(carbon_free_car):
    track, car = carbon_free_car.track, carbon_free_car.car
    s = np.linspace(10.0, track.length - 10.0, 400)
    steering = quintic_hermite(track.arc, steering_jets(track, car))
    curvature = quintic_hermite(track.arc, track.curvature_jets)
    np.testing.assert_allclose(steering(s), tan_steering(curvature(s), car), atol=1e-9)


@pytest.mark.parametrize(("side", "sign"), [("right", -1), ("left", 1)])
def test_a_turn_too_tight_says_where(side, sign):
    bend = np.array([[0, 0], [600, 0], [900, sign * 120], [1000, sign * 500], [1000, sign * 1200]])
    track = offset_track(plan_path(bend.astype(float), "quintic"), 20.0)
    with pytest.raises(DesignError, match=rf"turns {side} .*between waypoints [23] and") as caught:
        steering_jets(track, Car(**{**_fields(CAR), "max_steering_angle": np.radians(15)}))
    limit = 167 / np.tan(np.radians(15)) - sign * 37
    assert f"no less than {limit:.0f} mm" in str(caught.value)


def _fields(car):
    return {name: getattr(car, name) for name in car.__dataclass_fields__}
