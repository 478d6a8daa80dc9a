"""Courses that no car can drive: what stands on the start, gates that nothing can reach, a field that is too small."""

from cadgen.car.course.body import Body
from cadgen.car.course.course import Course, Gate, Obstacle
from cadgen.car.course.poses import Poses
from cadgen.car.course.shapes import geometry
from cadgen.car.course.sweep import approach, approach_to_edge
from cadgen.errors import DesignError


def refuse_course(course: Course, body: Body, start: Poses) -> None:
    """Refuse a course on which the car cannot even stand at its start, or with a gate that no car can pass.

    Args:
        course: the course.
        body: outline and wheels of the car.
        start: pose at the start, twice.

    Raises:
        DesignError: the key, what is wrong, and what to change.
    """
    if course.obstacles and not body.corners:
        kinds = " and ".join(dict.fromkeys(f"{obstacle.kind}s" for obstacle in course.obstacles))
        raise DesignError(
            f"car.outline is missing, and {kinds} of [course] are checked against it: add [car.outline] with "
            "length_mm, width_mm and front_overhang_mm, or with corners_mm"
        )
    for gate in (*course.gates, *(stand for stand in (course.start, course.finish) if stand)):
        _refuse_gate(gate, course)
    x, y = start.fork[0].real, start.fork[0].imag
    where = f"at its start, with the fork axis at ({x:.0f}, {y:.0f}) mm"
    for obstacle in course.obstacles:
        there = approach(start, body, obstacle).clearance
        if there < 0:
            raise DesignError(
                f"{obstacle.key} stands on the car {where}, by {-there:.1f} mm: move the {obstacle.kind}, or the start"
            )
    if course.edge is not None and (there := approach_to_edge(start, body, course.edge).clearance) < 0:
        raise DesignError(
            f"course.field does not hold the car {where}: it is {-there:.1f} mm outside; enlarge the field, or move "
            "the start"
        )


def _refuse_gate(gate: Gate, course: Course) -> None:
    import shapely

    place = geometry(gate.place).buffer(gate.place.reach) if gate.place.reach else geometry(gate.place)
    for obstacle in course.obstacles:
        if not _keeps_off(obstacle):
            continue
        if shapely.distance(geometry(obstacle.shape), geometry(gate.place)) > obstacle.shape.reach:
            continue
        if shapely.covers(geometry(obstacle.shape).buffer(obstacle.shape.reach), place):
            raise DesignError(
                f"{gate.key} lies in {obstacle.key}, where no car can pass: move the {_name(gate)}, or the "
                f"{obstacle.kind}"
            )
    if course.edge is not None and shapely.disjoint(geometry(course.edge), place):
        raise DesignError(f"{gate.key} lies outside course.field: move the {_name(gate)}, or enlarge the field")


def _name(gate: Gate) -> str:
    """Word for a gate, start or finish."""
    return "gate" if gate.key.startswith("course.gates") else gate.key.rpartition(".")[2]


def _keeps_off(obstacle: Obstacle) -> bool:
    """Whether it keeps even a wheel away."""
    return obstacle.shape.reach > 0 or obstacle.shape.filled
