"""Energy of a run against a time integration of a car that a falling weight drives."""

import numpy as np
import pytest

from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.energy import run_energy
from cadgen.car.running.mechanics import Mechanics
from cadgen.check import CheckCode
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.cam.steering_cam import plan_cam
from tests.car.running.friction_truth import Rod, contact

MASS, ROLLING, EFFICIENCY, FALL = 1.6, 0.02, 0.9, 0.4  # kg, -, -, m
STEP = 2e-3  # s


def reached(weight, lift, design, turn, stop, friction, drag):
    """Travel of a car that a falling weight drives, m, up to where it stands or its path ends.

    The weight hangs on a string about the rear axle, and lands after 70 % of the path; its speed is lost then. Forces
    on the cam are those of virtual work in space, step by step; wheels are points of a rigid body that turns.
    """
    car, rod = cam_model.car(design), Rod(design.cam.base_radius_mm, *design.cam.faces_mm, 2.5)
    theta = np.linspace(0, stop, 20_000)
    T, slope = lift.q(theta % (2 * np.pi)), lift.q(theta % (2 * np.pi), nu=1)
    ahead = contact(rod, T, slope).torque(friction)
    per_metre = 2 * np.pi / (turn * 1e-3)  # of cam angle by travel
    cam = np.maximum(drag - ahead, 0) * 1e-3 * per_metre / EFFICIENCY
    yaw = -T / (car.wheelbase + car.drive_wheel_offset * T)  # of the car, by travel of the drive wheel in mm
    front = np.hypot(1 + yaw * car.drive_wheel_offset, yaw * car.wheelbase)
    idle = np.abs(1 + yaw * (car.drive_wheel_offset + car.idle_wheel_offset))
    rolling = ROLLING * MASS * 9.81 * (1 + front + idle) / 3
    loss, end = cam + rolling, stop / per_metre
    landing = 0.7 * end
    lever = FALL / landing  # of the string by the wheel
    place, speed, falling = 0.0, 0.0, True
    while place < end:
        against = np.interp(place * per_metre, theta, loss)
        pull, inertia = (weight * 9.81 * lever, MASS + weight * lever**2) if falling else (0.0, MASS)
        if falling and place >= landing:
            falling = False
            continue
        speed += (pull - against) / inertia * STEP
        if speed <= 0:
            return place
        place += speed * STEP
    return end


def needed_by_integration(*of_car):
    """Energy of the lightest weight with which the car reaches its end, J."""
    low, high = 0.02, 6.0
    end = of_car[3] / (2 * np.pi) * of_car[2] * 1e-3
    while high - low > 0.004 * low:
        middle = (low + high) / 2
        if reached(middle, *of_car) >= end - 1e-9:
            high = middle
        else:
            low = middle
    return high * 9.81 * FALL


@pytest.mark.parametrize(("friction", "drag"), [(0.0, 60.0), (0.2, 60.0), (0.15, 0.0)])
def test_the_energy_is_that_of_a_weight_that_just_brings_the_car_home(friction, drag):
    design = load_design(
        "workshop_car", [f"mechanics={{rod_force_N=1,friction_least={friction},friction_greatest={friction}}}"]
    )
    cam = plan_cam(design, "actual", judged=False)
    use = cam.application
    lift, turn, stop = use.steering, use.travel, use.drive_wheel.finish
    rod = cam_model.leaning(design, "a test")
    run = drive(lift, use.car, turn, start=start_pose(use.track), stop=stop, steps=2000)
    forces = Mechanics(follower=rod, friction=friction, drag=drag)
    spent = run_energy(lift, forces, run, mass=MASS, rolling=ROLLING, efficiency=EFFICIENCY)
    truth = needed_by_integration(lift, design, turn, stop, friction, drag)
    print(f"friction {friction}, drag {drag}: {spent.needed:.3f} J, by integration {truth:.3f} J")
    assert spent.needed == pytest.approx(truth, rel=0.03)


def test_a_drive_without_the_energy_is_not_ready():
    heavy = ["mechanics.car_mass_kg=1.5", "mechanics.rolling_resistance=0.02"]
    cam = plan_cam(load_design("workshop_car", heavy))
    (check,) = (check for check in cam.verdict.failed)
    assert check.code == CheckCode.ENERGY_LEFT
    # Rolling alone takes 0.02 x 1.5 kg x 9.81 m/s2 x 17.4 m or more.
    assert check.value < 3.9 - 0.02 * 1.5 * 9.81 * 17.4
    put_in = check.advice.split("drive_energy_J to ")[1].split(",")[0]
    assert plan_cam(load_design("workshop_car", [*heavy, f"mechanics.drive_energy_J={put_in}"])).verdict.passed
    with pytest.raises(DesignError, match=r"mechanics\.car_mass_kg"):
        load_design("workshop_car", ["mechanics.car_mass_kg=0"])
