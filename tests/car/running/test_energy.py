"""Energy of a run against a time integration of a car that a falling weight drives."""

import numpy as np
import pytest

from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.energy import run_energy
from cadgen.car.running.mechanics import Mechanics
from cadgen.check import CheckCode
from cadgen.design import cam_model
from cadgen.design.load import load_design, with_overrides
from cadgen.errors import DesignError
from cadgen.jobs.cam.mechanics import energy_verdict
from cadgen.jobs.cam.steering_cam import plan_cam
from tests.car.running.friction_truth import Rod, contact

MASS, ROLLING, EFFICIENCY, FALL = 1.6, 0.02, 0.9, 0.4  # kg, -, -, m
STEP = 2e-3  # s


def reached(weight, lift, design, turn, stop, friction, drag, car_mass=MASS, resistance=ROLLING, lever=None, fall=FALL):
    """Travel of a car that a falling weight drives, m, up to where it stands or its path ends.

    The weight hangs on a string about the rear axle, and lands after 70 % of the path, or by its lever; its speed is
    lost then. Forces
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
    rolling = resistance * car_mass * 9.81 * (1 + front + idle) / 3
    loss, end = cam + rolling, stop / per_metre
    lever = lever or FALL / (0.7 * end)  # of the string by the wheel
    landing = fall / lever
    place, speed, falling = 0.0, 0.0, True
    while place < end:
        against = np.interp(place * per_metre, theta, loss)
        pull, inertia = (weight * 9.81 * lever, car_mass + weight * lever**2) if falling else (0.0, car_mass)
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


def test_a_weight_on_board_is_carried_and_just_brings_the_car_home():
    """Rolling resistance at which the energy of [drive] just suffices, against the integration with its string."""
    weight = '{kind="weight", mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=400}'
    of_car = ["mechanics.drive_energy_J=", "mechanics.car_mass_kg=2.4", "mechanics.train_efficiency=0.9"]
    design = load_design("workshop_car", [f"drive={weight}", *of_car])
    cam = plan_cam(design, "actual", judged=False)
    use = cam.application
    lift, turn, stop = use.steering, use.travel, use.drive_wheel.finish
    left = []
    for resistance in (0.0, 0.01):
        given = with_overrides(design, [f"mechanics.rolling_resistance={resistance}"])
        check, _ = energy_verdict(given, use.track, lift, cam.follower_as_built, use.car, use.drive_wheel).checks
        assert check.name == "energy left at the end of the path"
        left.append(check.value)
    assert left[0] < 3.924
    found = 0.01 * left[0] / (left[0] - left[1])
    axle = design.train.drive.bore_diameter_mm / 2
    lever = (axle + 0.5) / (turn / (2 * np.pi * 45))  # of the string by the wheel: 45 turns to one of the cam
    end = stop / (2 * np.pi) * turn * 1e-3
    low, high = 0.5 * found, 2 * found
    while high - low > 0.002 * low:
        middle = (low + high) / 2
        home = reached(1.0, lift, design, turn, stop, 0.2, 60.0, car_mass=2.4, resistance=middle, lever=lever)
        low, high = (middle, high) if home >= end - 1e-9 else (low, middle)
    print(f"rolling resistance {found:.5f}, by integration {low:.5f}")
    assert found == pytest.approx(low, rel=0.03)


def test_a_weight_moves_its_car_off_as_far_as_the_integration_says():
    """Rolling resistance at which a weight that falls over all the path no longer moves its car off, by both."""
    weight = '{kind="weight", mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=840}'
    of_car = ["mechanics.drive_energy_J=", "mechanics.car_mass_kg=2.4", "mechanics.train_efficiency=0.9"]
    brake = ["mechanics.drag_least_Nmm=60", "mechanics.drag_greatest_Nmm=400"]
    design = load_design("workshop_car", [f"drive={weight}", *of_car, *brake])
    cam = plan_cam(design, "actual", judged=False)
    use = cam.application
    lift, turn, stop = use.steering, use.travel, use.drive_wheel.finish
    lever = 3.0 / (turn / (2 * np.pi * 45))

    def pull(rolling):
        given = with_overrides(design, [f"mechanics.rolling_resistance={rolling}"])
        _, check = energy_verdict(given, use.track, lift, cam.follower_as_built, use.car, use.drive_wheel).checks
        assert check.code == CheckCode.WEIGHT_PULL
        return check

    def way(rolling):
        of_weight = {"car_mass": 2.4, "resistance": rolling, "lever": lever, "fall": 0.84}
        return reached(1.0, lift, design, turn, stop, 0.2, 400.0, **of_weight)

    # By as little as 2 % apart: what the check holds up stays, and what it lets go comes farther than the string.
    low, high = 0.002, 0.02
    while high - low > 0.002 * low:
        middle = (low + high) / 2
        low, high = (middle, high) if pull(middle).passed else (low, middle)
    string = 0.9 * stop / (2 * np.pi) * turn * 1e-3
    print(f"weight pulls up to a rolling resistance of {low:.5f}: {way(0.98 * low):.2f} m, {way(1.02 * low):.2f} m")
    assert way(0.98 * low) > string
    assert way(1.02 * low) < string
    held = pull(0.03)
    assert held.place.endswith("in the first 10 mm") or "on average" in held.place
    assert way(0.03) < 0.01


def test_a_drive_without_the_energy_is_not_ready():
    heavy = ["mechanics.car_mass_kg=1.5", "mechanics.rolling_resistance=0.02", "mechanics.drive_energy_J=3.9"]
    cam = plan_cam(load_design("workshop_car", heavy))
    (check,) = (check for check in cam.verdict.failed)
    assert check.code == CheckCode.ENERGY_LEFT
    # Rolling alone takes 0.02 x 1.5 kg x 9.81 m/s2 x 17.4 m or more.
    assert check.value < 3.9 - 0.02 * 1.5 * 9.81 * 17.4
    put_in = check.advice.split("drive_energy_J to ")[1].split(",")[0]
    assert plan_cam(load_design("workshop_car", [*heavy, f"mechanics.drive_energy_J={put_in}"])).verdict.passed
    with pytest.raises(DesignError, match=r"mechanics\.car_mass_kg"):
        load_design("workshop_car", ["mechanics.car_mass_kg=0"])


def test_a_weight_falls_no_farther_than_its_string_comes_off_the_axle():
    """A turn of the wheel lets off pi d of string: more fall gives nothing, and the cure that is named helps."""
    of_car = ["mechanics.drive_energy_J=", "mechanics.car_mass_kg=2.4", "mechanics.rolling_resistance=0.03"]

    def left(mass: float, fall: float, *more: str):
        weight = f'{{kind="weight", mass_kg={mass}, size_mm=[50, 50, 65], fall_mm={fall}}}'
        design = load_design("workshop_car", [f"drive={weight}", *of_car, *more])
        use = (cam := plan_cam(design, "actual", judged=False)).application
        check, _ = energy_verdict(
            design, use.track, use.steering, cam.follower_as_built, use.car, use.drive_wheel
        ).checks
        return check, use, design

    (check, use, design) = left(1.0, 1000.0)
    turns = use.drive_wheel.turn * use.drive_wheel.finish / (2 * np.pi) / (2 * np.pi * use.drive_wheel.radius)
    string = turns * np.pi * (design.train.drive.bore_diameter_mm + 1.0)  # to the middle of a string of 1 mm
    assert 500 < string < 1000
    assert f"of {9.81e-3 * string:g}"[:7] in check.place
    assert left(1.0, 2000.0)[0].value == pytest.approx(check.value, abs=1e-9)
    assert f"{string:.0f} mm of string" in check.advice
    rough = ["mechanics.car_mass_kg=3.2", "mechanics.rolling_resistance=0.04"]  # no fall of 2 m or less suffices
    heavier = float(left(1.0, 1000.0, *rough)[0].advice.split("drive.mass_kg at ")[1].split(",")[0])
    assert left(heavier, string, *rough, f"mechanics.car_mass_kg={2.2 + heavier}")[0].passed
    # A stated energy is raised as far as the fall has it, and no farther.
    slow = "mechanics.rolling_resistance=0.003"
    few = left(1.0, 400.0, "mechanics.drive_energy_J=1.0", slow)[0]
    enough = few.advice.removeprefix("raise mechanics.drive_energy_J to ").split(",")[0]
    assert left(1.0, 400.0, f"mechanics.drive_energy_J={enough}", slow)[0].passed
    given = ["mechanics.drive_energy_J=3.0", "mechanics.rolling_resistance=0.011"]
    few = left(1.0, 400.0, *given)[0]
    fall = few.advice.removeprefix("leave mechanics.drive_energy_J out; raise drive.fall_mm to ").split(",")[0]
    assert left(1.0, float(fall), given[1])[0].passed


def test_a_weight_without_mechanics_is_judged_by_usual_values_that_are_named():
    weight = '{kind="weight", mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=400}'
    design = load_design("workshop_car", [f"drive={weight}", "mechanics=", "tolerances.start_gap_deg="])
    use = (cam := plan_cam(design, "actual", judged=False)).application
    of_car = (use.track, use.steering, cam.follower_as_built, use.car, use.drive_wheel, 2.4)
    judged = energy_verdict(design, *of_car)
    checks = judged.checks
    said = with_overrides(design, ["mechanics={rod_force_N=1.0, rolling_resistance=0.015}"])
    assert energy_verdict(said, *of_car).checks == checks
    (held,) = judged.reservations
    assert "rod force of 1 N" in held.text
    assert "rolling resistance of 0.015" in held.text
    assert "[mechanics] rod_force_N" in held.cure
    assert not energy_verdict(said, *of_car).reservations
