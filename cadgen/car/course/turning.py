"""Room that a car takes to turn round, and room that a field has for it."""

from math import hypot, tan

import numpy as np

from cadgen.car.course.body import Body
from cadgen.car.course.course import Shape
from cadgen.car.course.shapes import geometry
from cadgen.car.steering import Car

_NEARLY = 0.5  # mm


def turning_circle(body: Body, car: Car, steering: float) -> float:
    """Least radius of a circle in which a car can turn round, mm: to the side on which that is less.

    Args:
        body: outline and wheels of the car.
        car: its dimensions.
        steering: greatest angle of the front wheel, rad.
    """
    aside = car.wheelbase / tan(steering)  # of the centre of the turn from the fork axis, on the line of the rear axle
    points = [*body.corners, *(wheel.centre for wheel in body.wheels)]
    return min(max(hypot(x + car.wheelbase, y - side * aside) for x, y in points) for side in (1.0, -1.0))


def largest_circle(field: Shape) -> float:
    """Radius of the largest circle within a field, mm."""
    from shapely.ops import polylabel

    area = geometry(field)
    return float(polylabel(area, tolerance=_NEARLY).distance(area.boundary))


def least_steering(body: Body, car: Car, radius: float, greatest: float) -> float | None:
    """Least angle of the front wheel with which a car can turn round in a circle; None if no angle will do.

    Args:
        body: outline and wheels of the car.
        car: its dimensions.
        radius: radius of the circle, mm.
        greatest: greatest angle that is tried, rad.
    """
    angles = np.linspace(car.max_steering_angle, greatest, 200)
    return next((angle for angle in angles.tolist() if turning_circle(body, car, angle) <= radius), None)
