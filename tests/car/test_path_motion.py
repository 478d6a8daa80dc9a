"""The lift curve: kinks where the path has them, and a blend that closes the turn smoothly."""

import numpy as np
import pytest

from cadgen.car.path_motion import path_motion
from cadgen.car.steering import steering_jets
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError

TURN = 2 * np.pi


def test_follows_the_path_up_to_the_blend(carbon_free_car):
    car = carbon_free_car
    by_arc = quintic_hermite(car.track.arc, steering_jets(car.track, car.car))
    theta = np.linspace(0, car.lift.blend_start, 1000)
    np.testing.assert_allclose(car.lift.q(theta), by_arc(theta / TURN * car.track.length), atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, "blend"])
def test_closes_with_continuous_curvature(carbon_free_car, angle):
    lift = carbon_free_car.lift
    at = lift.blend_start if angle == "blend" else 0.0
    step = 1e-9
    for order, allowed in ((0, 1e-8), (1, 1e-7), (2, 1e-5)):
        jump = lift.q(at + step, nu=order) - lift.q(at - step, nu=order)
        assert abs(jump) < allowed


def test_kinks_of_the_cubic_are_its_waypoints(appendix_car, carbon_free_car):
    assert carbon_free_car.lift.kinks.size == 0
    waypoints = appendix_car.track.waypoint_arc[1:-1] / appendix_car.track.length * TURN
    np.testing.assert_allclose(appendix_car.lift.kinks, waypoints, atol=1e-12)


def test_extrema_agree_with_a_dense_search(appendix_car):
    """The second valley sits on a kink, where the slope jumps through zero."""
    lift = appendix_car.lift
    theta = np.arange(0, TURN, 1e-5)
    value = lift.q(theta)
    peaks = theta[1:-1][(value[1:-1] > value[:-2]) & (value[1:-1] > value[2:])]
    valleys = theta[1:-1][(value[1:-1] < value[:-2]) & (value[1:-1] < value[2:])]
    found = lift.extrema()
    np.testing.assert_allclose(found[0], peaks, atol=2e-5)
    np.testing.assert_allclose(found[1], valleys, atol=2e-5)


@pytest.mark.parametrize("blend", [0.0, TURN, -0.1])
def test_refuses_a_blend_that_is_none(carbon_free_car, blend):
    track = carbon_free_car.track
    with pytest.raises(DesignError, match="blend_deg"):
        path_motion(track.arc, steering_jets(track, carbon_free_car.car), track.length, blend=blend)


@pytest.mark.parametrize("hair", [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 3e-5, 9e-5, -1e-12, -1e-6])
@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
def test_a_blend_that_begins_a_hair_beside_a_node(name, hair, request):
    """The piece between them is as exact as its neighbours, and a kink on the spot is left to the path."""
    car = request.getfixturevalue(name)
    jets, arc, length = steering_jets(car.track, car.car), car.track.arc, car.track.length
    node = car.track.waypoint_arc[-2] / length * TURN
    lift = path_motion(arc, jets, length, blend=TURN - node - hair)
    begin = lift.blend_start
    for order in range(3):
        before, after = lift.q(np.array([begin - 1e-9 * abs(hair), begin]), nu=order)
        scale = np.abs(lift.q(np.linspace(0, TURN, 999), nu=order)).max()
        assert abs(after - before) < 1e-6 * scale
    by_arc = quintic_hermite(arc, jets)
    theta = np.linspace(begin - 0.05, begin - 1e-9, 200)
    np.testing.assert_allclose(lift.q(theta), by_arc(theta / TURN * length), atol=1e-11)
