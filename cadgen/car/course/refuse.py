"""Courses that no car can drive, and the room that it takes to turn round."""

from math import hypot, tan

import numpy as np

from cadgen.car.course.approach import approach, approach_to_edge, geometry
from cadgen.car.course.body import CarBody, RunPoses
from cadgen.car.course.layout import Course, Gate, Shape
from cadgen.car.steering import Car
from cadgen.errors import DesignError
from cadgen.messages import Message, joined


def refuse_course(course: Course, body: CarBody, start: RunPoses) -> None:
    """Refuse a course on which the car cannot even stand at its start, or with a gate that no car can pass.

    Args:
        course: the course.
        body: outline and wheels of the car.
        start: pose at the start, twice.

    Raises:
        DesignError: the key, what is wrong, and what to change.
    """
    if course.obstacles and not body.corners:
        kinds = joined([Message(f"{kind}s") for kind in dict.fromkeys(each.kind for each in course.obstacles)], " and ")
        raise DesignError(
            "car.outline is missing, and {kinds} of [course] are checked against it: add [car.outline] "
            "with length_mm, width_mm and front_overhang_mm, or with corners_mm",
            kinds=kinds,
        )
    for gate in (*course.gates, *(stand for stand in (course.start, course.finish) if stand)):
        _refuse_gate(gate, course)
    x, y = start.fork[0].real, start.fork[0].imag
    where = Message("at its start, with the fork axis at ({x:.0f}, {y:.0f}) mm", x=x, y=y)
    for obstacle in course.obstacles:
        there = approach(start, body, obstacle).clearance
        if there < 0:
            raise DesignError(
                "{key} stands on the car {where}, by {depth:.1f} mm: move the {kind}, or the start",
                key=obstacle.key,
                where=where,
                depth=-there,
                kind=Message(obstacle.kind),
            )
    if course.edge is not None and (there := approach_to_edge(start, body, course.edge).clearance) < 0:
        raise DesignError(
            "course.field does not hold the car {where}: it is {depth:.1f} mm outside; enlarge the "
            "field, or move the start",
            where=where,
            depth=-there,
        )


def _refuse_gate(gate: Gate, course: Course) -> None:
    import shapely

    place = geometry(gate.place).buffer(gate.place.reach) if gate.place.reach else geometry(gate.place)
    for obstacle in course.obstacles:
        if obstacle.shape.reach == 0 and not obstacle.shape.filled:  # a wall without thickness leaves room beside it
            continue
        if shapely.distance(geometry(obstacle.shape), geometry(gate.place)) > obstacle.shape.reach:
            continue
        if shapely.covers(geometry(obstacle.shape).buffer(obstacle.shape.reach), place):
            raise DesignError(
                "{key} lies in {obstacle}, where no car can pass: move the {name}, or the {kind}",
                key=gate.key,
                obstacle=obstacle.key,
                name=Message(_name(gate)),
                kind=Message(obstacle.kind),
            )
    if course.edge is not None and shapely.disjoint(geometry(course.edge), place):
        raise DesignError(
            "{key} lies outside course.field: move the {name}, or enlarge the field",
            key=gate.key,
            name=Message(_name(gate)),
        )


def _name(gate: Gate) -> str:
    """Word for a gate, start or finish."""
    return "gate" if gate.key.startswith("course.gates") else gate.key.rpartition(".")[2]


_NEARLY = 0.5  # mm


def turning_circle(body: CarBody, car: Car, steering: float) -> float:
    """Least radius of a circle in which a car can turn round, mm: to the side on which that is less.

    Args:
        body: outline and wheels of the car.
        car: its dimensions.
        steering: greatest angle of the front wheel, rad.
    """
    offset = car.wheelbase / tan(steering)  # of the centre of the turn from the fork axis, on the line of the rear axle
    points = [*body.corners, *(wheel.centre for wheel in body.wheels)]
    return min(max(hypot(x + car.wheelbase, y - side * offset) for x, y in points) for side in (1.0, -1.0))


def largest_circle(field: Shape) -> float:
    """Radius of the largest circle within a field, mm."""
    from shapely.ops import polylabel

    area = geometry(field)
    return float(polylabel(area, tolerance=_NEARLY).distance(area.boundary))


def least_steering(body: CarBody, car: Car, radius: float, greatest: float) -> float | None:
    """Least angle of the front wheel with which a car can turn round in a circle; None if no angle will do.

    Args:
        body: outline and wheels of the car.
        car: its dimensions.
        radius: radius of the circle, mm.
        greatest: greatest angle that is tried, rad.
    """
    angles = np.linspace(car.max_steering_angle, greatest, 200)
    return next((angle for angle in angles.tolist() if turning_circle(body, car, angle) <= radius), None)
