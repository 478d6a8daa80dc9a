"""Side slip against the balance of forces on three wheels, and what it costs the paper's car."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.car.running.drive import drive
from cadgen.car.running.side_slip import CHANGE, RESISTANCE, side_slip


def balanced(car, stiffness: float, load: float) -> float:
    """Sum of the slip angles by solving for drive force, front and rear side force of a car that runs straight."""
    drag = RESISTANCE * load
    # Along, across, and moments about the driven wheel; the fork is L ahead and A1 to its right.
    equations = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 1.0], [0.0, car.wheelbase, 0.0]])
    turning = drag * car.drive_wheel_offset + drag * (car.drive_wheel_offset + car.idle_wheel_offset)
    _, front, rear = np.linalg.solve(equations, [2 * drag, 0.0, turning])
    return front / (stiffness * load) - rear / (stiffness * 2 * load)


@pytest.mark.parametrize("load", [3.0, 8.0])
def test_it_is_the_angle_at_which_the_forces_are_in_balance(load, carbon_free_car):
    assert side_slip(carbon_free_car.car) == pytest.approx(balanced(carbon_free_car.car, 20.0, load), rel=1e-12)
    assert np.degrees(side_slip(carbon_free_car.car)) == pytest.approx(0.07, abs=0.005)


@pytest.mark.parametrize(("stiffness", "moved"), [(50.0, 51.0), (20.0, 127.0), (10.0, 253.0)])
def test_a_fifth_of_it_moves_the_end_as_is_said(stiffness, moved, carbon_free_car):
    built = carbon_free_car
    planned, other = (
        drive(built.lift, car, built.track.length, steps=360).drive_wheel[-1]
        for car in (built.car, replace(built.car, steering_zero=CHANGE * side_slip(built.car, stiffness)))
    )
    found = np.hypot(*(planned - other))
    print(f"{stiffness:g} for a rad: {found:.0f} mm")
    assert found == pytest.approx(moved, rel=0.06)
