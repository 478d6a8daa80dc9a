"""The run of the car: the planned path without play, order of convergence, and the frame of the wheels."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import PPoly

from cadgen.arrays import TURN
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import MIDPOINT, TWO_STAGE, Pose, drive, driven, start_pose, wheel_radius
from cadgen.car.running.play import follow
from cadgen.errors import DesignError


def steady(tan_beta: float) -> PathMotion:
    return PathMotion(PPoly(np.array([[tan_beta]]), np.array([0.0, TURN]), extrapolate="periodic"), np.array([]), TURN)


@pytest.mark.parametrize(("name", "allowed"), [("carbon_free_car", 1e-6), ("appendix_car", 1e-5)])
def test_without_play_the_car_drives_the_planned_path(name, allowed, request, record_property):
    """The track comes from the spline itself; the run integrates the steering of the closed lift."""
    built = request.getfixturevalue(name)
    run = drive(built.lift, built.car, built.track.length, start=start_pose(built.track))
    arc = run.motor * built.track.length / TURN
    off = float(np.linalg.norm(run.drive_wheel - built.track.position(arc), axis=1).max())
    turned = float(np.abs(run.heading - built.track.heading(arc)).max())
    record_property("position_error_mm", off)
    print(f"{name}: zero play is {off:.2e} mm and {turned:.2e} rad from the planned path")
    assert off < allowed
    assert turned < allowed * 1e-2


@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
@pytest.mark.parametrize("play_deg", [0.0, 0.962])
def test_order_of_convergence(name, play_deg, request):
    """Fourth order, also across jumps, waits and kinks; the coarse runs are chosen above the lift's own error."""
    built = request.getfixturevalue(name)
    play = np.radians(play_deg)
    ends = {
        steps: drive(built.lift, built.car, built.track.length, play=play, steps=steps).drive_wheel[-1]
        for steps in (50, 100, 200, 7200)
    }
    errors = np.array([np.linalg.norm(ends[steps] - ends[7200]) for steps in (50, 100, 200)])
    order = np.log2(errors[0] / errors[2]) / 2
    print(f"{name}, play {play_deg} degrees: errors {errors} mm at 50, 100, 200 steps, order {order:.2f}")
    assert order > 3.0


@pytest.mark.parametrize(("rule", "least", "most"), [(MIDPOINT, 1.8, 2.3), (TWO_STAGE, 3.0, 5.5)])
def test_each_rule_has_its_order_across_jumps_and_waits(carbon_free_car, rule, least, most):
    built = carbon_free_car
    following = follow(built.lift, np.radians(0.962))
    joints, stop = following.joints(0.0, built.lift.blend_start), built.lift.blend_start

    def end(steps, rule):
        nodes = np.union1d(np.linspace(0.0, stop, steps + 1), joints)
        return driven(nodes, following.tan_beta, built.car, built.track.length, Pose(), rule)[1][-1]

    exact = end(7200, TWO_STAGE)
    errors = [abs(end(steps, rule) - exact) for steps in (100, 400)]
    order = np.log2(errors[0] / errors[1]) / 2
    print(f"errors {errors} mm at 100 and 400 steps, order {order:.2f}")
    assert least < order < most


@pytest.mark.parametrize("tan_beta", [0.3, -0.3, 0.0])
def test_steady_steering_drives_circles(carbon_free_car, tan_beta):
    """All wheels turn about one centre on the rear axle's line, at L / tan(beta) from the fork axis's foot."""
    car, length, start = carbon_free_car.car, 3000.0, Pose(x=100.0, y=-50.0, heading=0.7)
    run = drive(steady(tan_beta), car, length, start=start, steps=100)
    if tan_beta == 0:
        along = run.motor[:, None] * length / TURN * [np.cos(0.7), np.sin(0.7)]
        np.testing.assert_allclose(run.drive_wheel, np.array([100.0, -50.0]) + along, atol=1e-9)
        return
    right = np.array([np.sin(0.7), -np.cos(0.7)])
    foot = np.array([100.0, -50.0]) + car.drive_wheel_offset * right
    centre = foot + car.wheelbase / tan_beta * right
    for wheel, radius in (
        (run.drive_wheel, abs(car.wheelbase / tan_beta + car.drive_wheel_offset)),
        (run.front_wheel, np.hypot(car.wheelbase, car.wheelbase / tan_beta)),
        (run.idle_wheel, abs(car.wheelbase / tan_beta - car.idle_wheel_offset)),
    ):
        # The collocation rule errs by (turn per step)^4; 3000 mm in 100 steps turn by 0.05 rad each.
        np.testing.assert_allclose(np.linalg.norm(wheel - centre, axis=1), radius, rtol=1e-6)


def test_wheels_roll_where_they_point(carbon_free_car):
    """No wheel slips sideways: the rear ones move along the heading, the front one beta to the right of it."""
    built = carbon_free_car
    run = drive(built.lift, built.car, built.track.length, play=np.radians(0.5), steps=36000)
    heading = run.heading[1:-1]
    steering = np.arctan(run.tan_beta[1:-1])
    smooth = np.abs(np.diff(run.tan_beta, 2)) < 1e-6  # leave out the steps in which the cam jumps
    for wheel, turned in ((run.drive_wheel, 0.0), (run.idle_wheel, 0.0), (run.front_wheel, -steering)):
        moved = wheel[2:] - wheel[:-2]
        rolling = np.arctan2(moved[:, 1], moved[:, 0])
        slip = (rolling - heading - turned + np.pi) % TURN - np.pi
        assert np.abs(slip[smooth]).max() < 1e-5


def test_the_frame_stays_rigid(appendix_car):
    built = appendix_car
    run = drive(built.lift, built.car, built.track.length, play=0.01)
    axle = run.idle_wheel - run.drive_wheel
    fork = run.front_wheel - run.drive_wheel
    car = built.car
    np.testing.assert_allclose(np.linalg.norm(axle, axis=1), car.drive_wheel_offset + car.idle_wheel_offset)
    np.testing.assert_allclose(np.linalg.norm(fork, axis=1), np.hypot(car.wheelbase, car.drive_wheel_offset))
    # A right turn has beta > 0 and turns the heading clockwise; the axle lies to the right of the heading.
    right = np.stack([np.sin(run.heading), -np.cos(run.heading)], axis=1)
    np.testing.assert_allclose(axle, right * np.linalg.norm(axle, axis=1)[:, None], atol=1e-9)


def test_the_run_starts_at_its_pose_and_turns_with_it(carbon_free_car):
    built = carbon_free_car
    plain = drive(built.lift, built.car, built.track.length)
    moved = drive(built.lift, built.car, built.track.length, start=Pose(x=5.0, y=6.0, heading=np.pi / 2))
    np.testing.assert_allclose(moved.heading, plain.heading + np.pi / 2, atol=1e-12)
    turned = np.stack([5.0 - plain.drive_wheel[:, 1], 6.0 + plain.drive_wheel[:, 0]], axis=1)
    np.testing.assert_allclose(moved.drive_wheel, turned, atol=1e-8)


def test_travel_is_eq_20(carbon_free_car):
    """dx = 2 pi R_h i dtheta / 360 with i = 45 turns of the wheel per turn of the cam."""
    length = carbon_free_car.track.length
    assert wheel_radius(length, 45.0) * 2 * np.pi * 45 == pytest.approx(length, rel=1e-14)
    run = drive(steady(0.0), carbon_free_car.car, length, stop=TURN, steps=10)
    assert run.drive_wheel[-1, 0] == pytest.approx(length)


def test_stop_beyond_the_blend_and_no_steps(carbon_free_car):
    built = carbon_free_car
    run = drive(built.lift, built.car, built.track.length, stop=2 * TURN, steps=8)
    assert run.motor[-1] == 2 * TURN
    with pytest.raises(DesignError, match="0 steps"):
        drive(built.lift, built.car, built.track.length, steps=0)


def test_kinks_are_met_by_a_step(appendix_car):
    """Leaving them out of the lift's list costs accuracy, so the list is used."""
    built = appendix_car
    blind = replace(built.lift, kinks=np.array([]))
    exact = drive(built.lift, built.car, built.track.length, steps=7200).drive_wheel[-1]
    ends = [drive(lift, built.car, built.track.length, steps=200).drive_wheel[-1] for lift in (built.lift, blind)]
    off = [np.linalg.norm(end - exact) for end in ends]
    assert off[0] < 0.5 * off[1]
