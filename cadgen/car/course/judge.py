"""A run held against a course: what the car comes near to, what it passes, where it starts and ends."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.car.course.body import Body, place_of
from cadgen.car.course.course import Course, Gate, Obstacle
from cadgen.car.course.gates import Passage, passages, turned_by
from cadgen.car.course.names import CarPoint, Side
from cadgen.car.course.poses import Poses
from cadgen.car.course.sweep import Approach, approach, approach_to_edge
from cadgen.car.steering import Car


@dataclass(frozen=True, kw_only=True)
class Stand:
    """Start or finish of a run against where it is wanted.

    Attributes:
        wanted: the place wanted.
        off: distance from its middle, or from the line, mm.
        turned: angle from the heading wanted to that of the run, rad; None if any heading will do.
    """

    wanted: Gate
    off: float
    turned: float | None


@dataclass(frozen=True, kw_only=True)
class Driven:
    """A run on a course.

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
    start: Stand | None
    finish: Stand | None

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
        found = {
            obstacle.key: (f"{there.part}, passing {side} of it", there.clearance)
            for (obstacle, there), side in zip(self.approaches, self.sides, strict=True)
        }
        if self.edge is not None:
            found["course.field"] = (self.edge.part, self.edge.clearance)
        for passage in self.passages:
            wrong = f", wrong {passage.fault}" if passage.fault else ""
            found[passage.gate.key] = (f"{passage.off:.1f} mm off its middle{wrong}", passage.margin)
        for stand in (self.start, self.finish):
            if stand is not None:
                # Rounded first, so that it is never -0.00.
                off = "" if stand.turned is None else f", {round(degrees(stand.turned), 2) or 0.0:.2f}° off"
                found[stand.wanted.key] = (f"{stand.off:.1f} mm off{off}", stand.wanted.place.reach - stand.off)
        return found


def judge(poses: Poses, car: Car, body: Body, course: Course) -> Driven:
    """Hold a run against a course."""
    return Driven(
        approaches=tuple((obstacle, approach(poses, body, obstacle)) for obstacle in course.obstacles),
        sides=_sides(poses, car, course.obstacles),
        edge=approach_to_edge(poses, body, course.edge) if course.edge else None,
        passages=passages(poses, car, course.gates),
        start=_stand(poses, car, course.start, 0) if course.start else None,
        finish=_stand(poses, car, course.finish, -1) if course.finish else None,
    )


def _stand(poses: Poses, car: Car, wanted: Gate, number: int) -> Stand:
    at = complex(poses.track(place_of(wanted.point, car))[number])
    points = [complex(*point) for point in wanted.place.points]
    along = points[-1] - points[0]
    share = float(np.clip(((at - points[0]) * along.conjugate()).real / abs(along) ** 2, 0, 1)) if along else 0.0
    turned = None if wanted.heading is None else float(turned_by(poses.heading[number], wanted.heading))
    return Stand(wanted=wanted, off=abs(at - points[0] - share * along), turned=turned)


def _sides(poses: Poses, car: Car, obstacles: Sequence[Obstacle]) -> tuple[Side, ...]:
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
