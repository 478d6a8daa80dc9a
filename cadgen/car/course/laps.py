"""A run of several laps held against a course: all of it is asked of every lap."""

from collections.abc import Sequence
from dataclasses import replace

from cadgen.car.course.body import Body
from cadgen.car.course.course import Course, Gate
from cadgen.car.course.gates import Passage, passages
from cadgen.car.course.judge import Driven, judge
from cadgen.car.course.names import Side
from cadgen.car.course.poses import Poses
from cadgen.car.course.sweep import Approach
from cadgen.car.steering import Car

# Share of a lap before its start and behind its end in which its gates may be passed: with play a car is early or late.
_BESIDE = 0.05
_DIGITS = 4  # of a clearance in mm to which laps are alike; of those the last counts, for there a car has drifted most


def judge_laps(poses: Poses, car: Car, body: Body, course: Course, ends: Sequence[int]) -> Driven:
    """Hold a run against a course, lap by lap: the worst lap counts, and the gates are passed on each.

    Args:
        poses: run of the car.
        car: dimensions of the car.
        body: its outline and wheels.
        course: course, of which the start is asked of the first lap and the finish of the last.
        ends: numbers of the poses at which the laps end, in order.
    """
    starts = [0, *ends[:-1]]
    laps: list[Driven] = []
    for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
        asked = replace(
            course,
            gates=(),
            start=course.start if number == 0 else None,
            finish=course.finish if end == ends[-1] else None,
        )
        lap = judge(poses.part(start, end + 1), car, body, asked)
        beside = int(_BESIDE * (end - start))
        gates = course.gates if len(ends) == 1 else tuple(_on_lap(course, number + 1))
        first = max(start - beside, 0)
        passed = passages(poses.part(first, end + 1 + beside), car, gates)
        laps.append(
            replace(
                lap,
                approaches=tuple((thing, _moved(there, start)) for thing, there in lap.approaches),
                edge=None if lap.edge is None else _moved(lap.edge, start),
                passages=tuple(replace(passage, place=passage.place + first) for passage in passed),
            )
        )
    return _together(laps, course)


def _on_lap(course: Course, number: int) -> list[Gate]:
    return [replace(gate, key=f"{gate.key}, lap {number}") for gate in course.gates]


def _moved(there: Approach, places: int) -> Approach:
    return replace(there, place=there.place + places)


def _together(laps: Sequence[Driven], course: Course) -> Driven:
    things = range(len(course.obstacles))
    edges = [lap.edge for lap in laps if lap.edge is not None]
    every: tuple[Passage, ...] = tuple(passage for lap in laps for passage in lap.passages)
    return Driven(
        approaches=tuple(
            (course.obstacles[thing], _nearest([lap.approaches[thing][1] for lap in laps])) for thing in things
        ),
        sides=tuple(_side(course.obstacles[thing].side, [lap.sides[thing] for lap in laps]) for thing in things),
        edge=_nearest(edges) if edges else None,
        passages=every,
        start=laps[0].start,
        finish=laps[-1].finish,
    )


def _nearest(found: Sequence[Approach]) -> Approach:
    return min(reversed(found), key=lambda there: round(there.clearance, _DIGITS))


def _side(wanted: Side | None, passed: Sequence[Side]) -> Side:
    """Side on which a thing is passed: the wrong one, if it is on any lap."""
    return next((side for side in passed if wanted not in (None, side)), passed[0])
