"""A car that is not as designed: its steering against bicycle kinematics integrated step by step, and its jets."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.car.path_motion import path_motion
from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.run_errors import turning
from cadgen.car.steering import by_rim, rim_travel, steering_jets, tan_steering, track_curvature
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError

ZERO, GAIN, SLIP = np.radians(0.55), 1.04, 0.08


@pytest.fixture(scope="module")
def crooked(carbon_free_car):
    return replace(carbon_free_car.car, steering_zero=ZERO, steering_gain=GAIN, slip=SLIP)


def bicycle(steering, car, rim, steps):
    """Drive wheel of a car whose rod is steered by `steering` (a function of the rim's travel), by the midpoint rule.

    The front wheel stands at A1 to the right of the drive wheel, L ahead of the axle. It rolls along its own direction,
    so the axle's line meets its axle in the centre of the turn.
    """
    place, heading = np.empty(steps + 1, dtype=complex), 0.0
    place[0] = 0.0
    step = rim / steps
    for i in range(steps):
        angle = np.arctan(car.steering_gain * steering((i + 0.5) * step)) + car.steering_zero
        forward = step * (1 - car.slip * abs(np.tan(angle)))
        # Right of the fork by L / tan(angle), and so right of the drive wheel by A1 more.
        swing = -forward * np.sin(angle) / (car.wheelbase * np.cos(angle) + car.drive_wheel_offset * np.sin(angle))
        place[i + 1] = place[i] + forward * np.exp(1j * (heading + swing / 2)) * np.sinc(swing / TURN)
        heading += swing
    return place, heading


@pytest.mark.slow
def test_steers_as_the_bicycle_does(carbon_free_car, crooked):
    """On the lift of the design, with an error of the midpoint rule of 1e-3 mm."""
    lift, length = carbon_free_car.lift, carbon_free_car.track.length
    rim = length * lift.blend_start / TURN
    place, heading = bicycle(lambda r: float(lift.q(r / length * TURN)), crooked, rim, 40_000)
    run = drive(lift, crooked, length)
    assert run.heading[-1] == pytest.approx(heading, abs=1e-6)
    np.testing.assert_allclose(run.drive_wheel[-1], [place[-1].real, place[-1].imag], atol=5e-3)
    assert turning(lift, crooked, length, 0.0, lift.blend_start) == pytest.approx(heading, abs=1e-6)
    straight = drive(lift, carbon_free_car.car, length)
    assert np.linalg.norm(straight.drive_wheel[-1] - run.drive_wheel[-1]) > 100  # it matters


def test_the_rods_tangent_is_the_inverse(crooked):
    k = np.linspace(-1 / 350, 1 / 350, 101)
    np.testing.assert_allclose(track_curvature(tan_steering(k, crooked), crooked), k, atol=1e-15)


def test_jets_agree_with_differences(carbon_free_car, crooked):
    """By arc length against the curvature's interpolant, and by the rim against the composed function."""
    track = carbon_free_car.track
    jets = steering_jets(track, crooked)
    steering, curvature = quintic_hermite(track.arc, jets), quintic_hermite(track.arc, track.curvature_jets)
    s, h = np.linspace(20.0, track.length - 20.0, 301), 0.5
    np.testing.assert_allclose(steering(s), tan_steering(curvature(s), crooked), atol=1e-9)
    rim = rim_travel(track.arc, jets, crooked)
    by_travel = quintic_hermite(rim, by_rim(jets, crooked))

    def at(r):
        return steering(np.interp(r, rim, track.arc))

    r = rim[50:-50:7]
    np.testing.assert_allclose(by_travel(r, nu=1), (at(r + h) - at(r - h)) / (2 * h), atol=2e-7)
    np.testing.assert_allclose(by_travel(r), at(r), atol=1e-9)


def test_the_lift_by_the_rim_drives_the_planned_path(carbon_free_car, crooked):
    """Its own cam takes the crooked car to the end of the path; without slip as well as with it."""
    track = carbon_free_car.track
    for car in (crooked, replace(crooked, slip=0.0), replace(crooked, slip=-0.05, steering_gain=0.9)):
        jets = steering_jets(track, car)
        rim = rim_travel(track.arc, jets, car)
        length = 1.02 * rim[-1]
        lift = path_motion(rim, by_rim(jets, car), length, blend=np.radians(15))
        run = drive(lift, car, length, start=start_pose(track))
        end = np.interp(lift.blend_start * length / TURN, rim, track.arc)
        np.testing.assert_allclose(run.drive_wheel[-1], track.position(end), atol=1e-3)


def test_a_wheel_that_never_gets_ahead_is_refused(carbon_free_car, crooked):
    track = carbon_free_car.track
    stuck = replace(crooked, slip=8.0)
    with pytest.raises(DesignError, match=r"slip of 800 %.*lower slip_percent"):
        rim_travel(track.arc, steering_jets(track, stuck), stuck)
