"""A run held against a course: what the car comes near to, which gates it passes, where it starts and ends."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import degrees

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.course.approach import Approach, approach, approach_to_edge
from cadgen.car.course.body import CarBody, Complex, RunPoses, place_of
from cadgen.car.course.layout import CarPoint, Course, Gate, Obstacle, Side
from cadgen.car.steering import Car
from cadgen.messages import Message, clauses


@dataclass(frozen=True, kw_only=True)
class Passage:
    """Passage of a gate.

    Attributes:
        gate: the gate.
        margin: distance by which the point of the car is inside the gate, mm: what is left of a disc's radius, or the
            distance from a segment's nearer end; less than 0 if it misses the gate by that much.
        off: distance from the middle of the gate, mm.
        place: number of the pose there, whole or between two.
        travel: travel of the drive wheel up to there, mm.
        fault: why the gate does not count although the car gets there: `heading`, `order`; empty if nothing is wrong.
    """

    gate: Gate
    margin: float
    off: float
    place: float
    travel: float
    fault: str = ""

    @property
    def missed(self) -> str:
        """Words on how a gate that is not passed is missed."""
        if self.fault:
            return Message("{key} in the wrong {fault}", key=self.gate.key, fault=Message(self.fault))
        return Message("{key} missed by {margin:.1f} mm", key=self.gate.key, margin=-self.margin)


def passages(poses: RunPoses, car: Car, gates: Sequence[Gate]) -> tuple[Passage, ...]:
    """Passage of each gate. Gates that are not free are passed one after the other, each as early as it can be.

    Of a gate that is passed several times the best passage counts that leaves the order.
    """
    passed, earliest = [], 0.0
    tracks = {point: poses.track(place_of(point, car)) for point in {gate.point for gate in gates}}
    for gate in gates:
        result, first = _passage(poses, tracks[gate.point], gate, 0.0 if gate.free else earliest)
        passed.append(result)
        if not gate.free:
            earliest = max(earliest, first)
    return tuple(passed)


def _passage(poses: RunPoses, track: Complex, gate: Gate, since: float) -> tuple[Passage, float]:
    """Best passage from a place on, and the earliest place at which the gate is passed; `since` if it is not."""
    place, margin, off = (_through_segment if len(gate.place.points) > 1 else _through_disc)(track, gate)
    headed = np.ones(len(place), dtype=bool)
    if gate.heading is not None:
        headed = np.abs(turned_by(poses.at(place).heading, gate.heading)) <= gate.heading_tolerance
    later = place >= since
    fault = ""
    allowed = headed & later
    if not (margin[allowed] >= 0).any():
        for wider, name in ((headed, "order"), (later, "heading"), (np.ones_like(later), "order and heading")):
            if (margin[wider] >= 0).any():
                allowed, fault = wider, name
                break
    chosen = np.flatnonzero(allowed if allowed.any() else later if later.any() else np.ones_like(later))
    best = chosen[int(np.argmax(margin[chosen]))]
    inside = np.flatnonzero(allowed & (margin >= 0))
    first = float(place[inside[0]]) if inside.size and not fault else since
    where = float(place[best])
    travel = float(np.interp(where, np.arange(len(poses)), poses.travel))
    return Passage(
        gate=gate, margin=float(margin[best]), off=float(off[best]), place=where, travel=travel, fault=fault
    ), first


def _through_disc(track: Complex, gate: Gate) -> tuple[Array, Array, Array]:
    """Nearest place on each piece of the track, the margin and the distance from the middle there, shape (n - 1,)."""
    centre = complex(*gate.place.points[0])
    start, along = track[:-1] - centre, np.diff(track)
    length = np.maximum(np.abs(along) ** 2, 1e-300)
    share = np.clip(-np.real(start * along.conj()) / length, 0.0, 1.0)
    off = np.abs(start + share * along)
    return np.arange(len(along)) + share, gate.place.reach - off, off


def _through_segment(track: Complex, gate: Gate) -> tuple[Array, Array, Array]:
    """Places where the track crosses the segment's line, and between them the nearest place of each piece."""
    a, b = (complex(*point) for point in gate.place.points)
    length = abs(b - a)
    local = (track - a) * (b - a).conjugate() / length  # along the segment from its first end, and to its left
    height = local.imag
    crosses = (height[:-1] <= 0) != (height[1:] <= 0)
    drop = np.where(crosses, height[:-1] - height[1:], 1.0)
    share = np.where(crosses, height[:-1] / drop, 0.0)
    there = local[:-1] + share * np.diff(local)
    along = there.real
    inside = np.minimum(along, length - along)
    # Without a crossing the track misses the segment by the distance from it.
    beyond = np.abs(there - np.clip(along, 0.0, length))
    margin = np.where(crosses, np.where(inside >= 0, inside, -beyond), -np.maximum(beyond, np.finfo(float).tiny))
    return np.asarray(np.arange(len(share)) + share), np.asarray(margin), np.abs(there - length / 2)


def turned_by(heading: Array, wanted: float) -> Array:
    """Angle from a direction to headings, rad, between minus and plus half a turn.

    Args:
        heading: headings, rad.
        wanted: direction, rad.
    """
    return np.asarray((heading - wanted + TURN / 2) % TURN - TURN / 2)


@dataclass(frozen=True, kw_only=True)
class EndDeviation:
    """Deviation of a run's start or finish from where it is wanted.

    Attributes:
        wanted: the place wanted.
        off: distance from its middle, or from the line, mm.
        turned: angle from the heading wanted to that of the run, rad; None if any heading will do.
    """

    wanted: Gate
    off: float
    turned: float | None


@dataclass(frozen=True, kw_only=True)
class CourseVerdict:
    """Verdict on a run: what it comes near to, passes and misses on a course.

    Attributes:
        approaches: nearest approach to each obstacle, in the order of the course.
        sides: side of each obstacle on which the car passes it.
        edge: nearest approach to the edge; None without an edge.
        passages: passage of each gate, in their order.
        start: start of the run; None if it is free.
        finish: end of the run; None if it is free.
    """

    approaches: tuple[tuple[Obstacle, Approach], ...]
    sides: tuple[Side, ...]
    edge: Approach | None
    passages: tuple[Passage, ...]
    start: EndDeviation | None
    finish: EndDeviation | None

    @property
    def wrong_sides(self) -> tuple[Obstacle, ...]:
        """Obstacles that are passed on the wrong side."""
        passed = zip(self.approaches, self.sides, strict=True)
        return tuple(obstacle for (obstacle, _), side in passed if obstacle.side not in (None, side))

    @property
    def faults(self) -> tuple[Passage, ...]:
        """Gates that are passed in the wrong order or direction."""
        return tuple(passage for passage in self.passages if passage.fault)

    @property
    def worst_gate(self) -> Passage | None:
        """Gate that is passed with the least margin; None if there are no gates."""
        return min(self.passages, key=lambda passage: passage.margin, default=None)

    def figures(self) -> dict[str, tuple[str, float]]:
        """Clearance to each thing and margin of each gate by its key, mm, with the part of the car or what is wrong."""
        found: dict[str, tuple[str, float]] = {
            obstacle.key: (
                Message("{part}, passing {side} of it", part=Message(there.part), side=Message(side)),
                there.clearance,
            )
            for (obstacle, there), side in zip(self.approaches, self.sides, strict=True)
        }
        if self.edge is not None:
            found["course.field"] = (Message(self.edge.part), self.edge.clearance)
        for passage in self.passages:
            wrong = Message(", wrong {fault}", fault=Message(passage.fault)) if passage.fault else ""
            found[passage.gate.key] = (
                Message("{off:.1f} mm off its middle{wrong}", off=passage.off, wrong=wrong),
                passage.margin,
            )
        for stand in (self.start, self.finish):
            if stand is not None:
                # Rounded first, so that it is never -0.00.
                off = (
                    ""
                    if stand.turned is None
                    else Message(", {turned:.2f}° off", turned=round(degrees(stand.turned), 2) or 0.0)
                )
                found[stand.wanted.key] = (
                    Message("{off:.1f} mm off{turned}", off=stand.off, turned=off),
                    stand.wanted.place.reach - stand.off,
                )
        return found


def judge(poses: RunPoses, car: Car, body: CarBody, course: Course) -> CourseVerdict:
    """Hold a run against a course."""
    return CourseVerdict(
        approaches=tuple((obstacle, approach(poses, body, obstacle)) for obstacle in course.obstacles),
        sides=_sides(poses, car, course.obstacles),
        edge=approach_to_edge(poses, body, course.edge) if course.edge else None,
        passages=passages(poses, car, course.gates),
        start=_end_deviation(poses, car, course.start, 0) if course.start else None,
        finish=_end_deviation(poses, car, course.finish, -1) if course.finish else None,
    )


def _end_deviation(poses: RunPoses, car: Car, wanted: Gate, number: int) -> EndDeviation:
    at = complex(poses.track(place_of(wanted.point, car))[number])
    points = [complex(*point) for point in wanted.place.points]
    along = points[-1] - points[0]
    share = float(np.clip(((at - points[0]) * along.conjugate()).real / abs(along) ** 2, 0, 1)) if along else 0.0
    turned = None if wanted.heading is None else float(turned_by(poses.heading[number], wanted.heading))
    return EndDeviation(wanted=wanted, off=abs(at - points[0] - share * along), turned=turned)


def _sides(poses: RunPoses, car: Car, obstacles: Sequence[Obstacle]) -> tuple[Side, ...]:
    """Side of each obstacle on which the middle of the car passes where it is nearest to the obstacle's middle."""
    track = poses.track(place_of(CarPoint.MIDDLE, car))
    start, along = track[:-1], np.diff(track)
    length = np.maximum(np.abs(along) ** 2, 1e-300)
    sides: list[Side] = []
    for obstacle in obstacles:
        away = np.mean([complex(*point) for point in obstacle.shape.points]) - start
        share = np.clip(np.real(away * along.conj()) / length, 0.0, 1.0)
        nearest = int(np.argmin(np.abs(away - share * along)))
        sides.append(Side.RIGHT if (away[nearest] * along[nearest].conj()).imag > 0 else Side.LEFT)
    return tuple(sides)


# Share of a lap before its start and behind its end in which its gates may be passed: with play a car is early or late.
_BESIDE = 0.05
_DIGITS = 4  # of a clearance in mm to which laps are alike; of those the last counts, for there a car has drifted most


def judge_laps(poses: RunPoses, car: Car, body: CarBody, course: Course, ends: Sequence[int]) -> CourseVerdict:
    """Hold a run against a course, lap by lap: the worst lap counts, and the gates are passed on each.

    Args:
        poses: run of the car.
        car: dimensions of the car.
        body: its outline and wheels.
        course: course, of which the start is asked of the first lap and the finish of the last.
        ends: numbers of the poses at which the laps end, in order.
    """
    starts = [0, *ends[:-1]]
    laps: list[CourseVerdict] = []
    for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
        asked = replace(
            course,
            gates=(),
            start=course.start if number == 0 else None,
            finish=course.finish if end == ends[-1] else None,
        )
        lap = judge(poses.part(start, end + 1), car, body, asked)
        beside = int(_BESIDE * (end - start))
        gates = course.gates
        if len(ends) > 1:
            gates = tuple(
                replace(gate, key=clauses(gate.key, Message("lap {number}", number=number + 1))) for gate in gates
            )
        first = max(start - beside, 0)
        passed = passages(poses.part(first, end + 1 + beside), car, gates)
        laps.append(
            replace(
                lap,
                approaches=tuple((thing, replace(near, place=near.place + start)) for thing, near in lap.approaches),
                edge=None if lap.edge is None else replace(lap.edge, place=lap.edge.place + start),
                passages=tuple(replace(passage, place=passage.place + first) for passage in passed),
            )
        )
    return _worst_lap(laps, course)


def _worst_lap(laps: Sequence[CourseVerdict], course: Course) -> CourseVerdict:
    things = range(len(course.obstacles))
    edges = [lap.edge for lap in laps if lap.edge is not None]
    every: tuple[Passage, ...] = tuple(passage for lap in laps for passage in lap.passages)
    return CourseVerdict(
        approaches=tuple(
            (course.obstacles[thing], _nearest([lap.approaches[thing][1] for lap in laps])) for thing in things
        ),
        sides=tuple(  # the wrong one, if it is on any lap
            next(
                (lap.sides[thing] for lap in laps if course.obstacles[thing].side not in (None, lap.sides[thing])), None
            )
            or laps[0].sides[thing]
            for thing in things
        ),
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
