"""Room to turn round in, against a car turned by hand."""

from math import radians, tan

import numpy as np
import pytest

from cadgen.car.course.body import CarBody, CarWheel
from cadgen.car.course.layout import Shape
from cadgen.car.course.refuse import largest_circle, least_steering, turning_circle
from cadgen.car.steering import Car

CAR = Car(wheelbase=150.0, drive_wheel_offset=30.0, idle_wheel_offset=90.0, max_steering_angle=radians(35))
BODY = CarBody(
    corners=((40.0, 50.0), (-170.0, 50.0), (-170.0, -110.0), (40.0, -110.0)),
    clearance=0.0,
    wheels=(CarWheel(name="front wheel", centre=(0.0, 0.0), radius=0.0, width=0.0, steered=True),),
)


def test_circle_is_that_of_the_farthest_corner_of_a_car_that_turns():
    """The car is turned about its centre in small steps, to the right, where its longer side lies inwards."""
    aside = 150 / tan(radians(35))
    centre = -150 - 1j * aside
    corners = np.array([complex(*corner) for corner in BODY.corners])
    turned = centre + (corners[:, None] - centre) * np.exp(-1j * np.linspace(0, 2 * np.pi, 1000))
    farthest = np.abs(turned - centre).max()
    assert turning_circle(BODY, CAR, radians(35)) == pytest.approx(farthest)
    steering = least_steering(BODY, CAR, 0.9 * farthest, radians(75))
    assert turning_circle(BODY, CAR, steering) == pytest.approx(0.9 * farthest, rel=0.01)
    assert least_steering(BODY, CAR, 100.0, radians(75)) is None


def test_largest_circle_of_a_field():
    assert largest_circle(Shape(((0, 0), (900, 0), (900, 600), (0, 600)), filled=True)) == pytest.approx(300, abs=1)
    # A right triangle of sides 300, 400 and 500.
    assert largest_circle(Shape(((0, 0), (300, 0), (0, 400)), filled=True)) == pytest.approx(100, abs=1)
