"""Gates, start and finish of a course as limits of a path.

At each gate the limit is on the place where the path comes nearest to it, which is looked for anew at every step; so
the path is free to pass it sooner or later. In a disc only the distance across the path counts there.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import cos, pi

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.course.body import place_of
from cadgen.car.course.layout import Gate
from cadgen.car.planner.constraints import Constraint, LimitKind, PathLimit
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_task import PathTask, Vehicle

_EACH = 24  # places of a span among which the nearest is looked for
_PER_MM, _PER_RAD = 3.0, 300.0  # weights
_INSIDE = 0.02  # mm that is kept from the edge of a gate, for rounding and what a step leaves
_SIDES = 8  # pairs of sides of the polygon that stands for the disc of a finish
_SQUARE = 0.2  # sine of the least angle between path and segment at which the crossing is looked at


def planned_place(gate: Gate, vehicle: Vehicle) -> tuple[float, float]:
    """Place of the gate's point of the car: ahead of the planned point, and to its left, mm."""
    x, y = place_of(gate.point, vehicle.car)
    return x + vehicle.car.wheelbase, y - (vehicle.car.drive_wheel_offset - vehicle.path_offset)


def passing_places(motion: Kinematics, gates: tuple[Gate, ...], vehicle: Vehicle) -> Array:
    """Parameters at which a path comes nearest to its gates, one after the other, shape (k,).

    Of all sequences of places in the order of the gates, the one with the least sum of squared distances.

    Args:
        motion: the path at places close together.
        gates: gates in their order.
        vehicle: the car.
    """
    u = motion.places.u
    if not gates:
        return np.zeros(0)
    # Squares of the distances of each gate's point of the car from the gate's middle line or centre, mm².
    rows = []
    for gate in gates:
        track = motion.point(*planned_place(gate, vehicle))
        a, b = np.array(gate.place.points[0]), np.array(gate.place.points[-1])
        along = b - a
        share = np.clip((track - a) @ along / max(float(along @ along), 1e-12), 0.0, 1.0)
        rows.append(np.linalg.norm(track - a - share[:, None] * along, axis=1) ** 2)
    off = np.stack(rows)
    best, chosen = np.zeros(len(u)), []
    for row in off:
        least = row + best
        first = np.where(least <= np.minimum.accumulate(least), np.arange(len(u)), 0)
        chosen.append(np.maximum.accumulate(first))
        best = np.minimum.accumulate(least)
    place, places = len(u) - 1, []
    for number in reversed(range(len(gates))):
        place = int(chosen[number][place])
        at = float(u[place])
        if crossing := _crossing(motion, gates[number], vehicle, place):
            at = crossing
        elif 0 < place < len(u) - 1:  # least of a parabola through the distances there and at its neighbours
            before, here, after = off[number][place - 1 : place + 2]
            bend = before - 2 * here + after
            shift = 0.5 * (before - after) / bend if bend > 0 else 0.0
            at = float(u[place] + np.clip(shift, -1, 1) * (u[1] - u[0]))
        places.append(at)
    return np.array(places[::-1])


def _crossing(motion: Kinematics, gate: Gate, vehicle: Vehicle, place: int) -> float | None:
    """Parameter at which a segment is crossed beside a place; None where it is not."""
    if len(gate.place.points) < 2:
        return None
    u, first, last = motion.places.u, max(place - 1, 0), min(place + 2, len(motion.places.u))
    near = Kinematics(motion.places[np.arange(first, last)], motion.points, motion.offset)
    a, b = (np.array(point) for point in gate.place.points)
    height = (near.point(*planned_place(gate, vehicle)) - a) @ np.array([a[1] - b[1], b[0] - a[0]])
    changes = np.flatnonzero(height[:-1] * height[1:] < 0)
    if not changes.size:
        return None
    k = int(changes[0])
    share = height[k] / (height[k] - height[k + 1])
    return float(u[first + k] + share * (u[first + k + 1] - u[first + k]))


@dataclass(frozen=True, eq=False)
class Passing:
    """The gates of a task, in the order in which they are passed.

    Attributes:
        basis: B-splines of the path.
        gates: gates in their order.
        start: where the run must start, if not at a fixed place; None if that is fixed or free.
        finish: where it must end, likewise.
        vehicle: the car.
        margin: distance to keep from the edges of the gates, mm.
        spare: distance to keep besides where it costs little, by the keys of the gates, mm.
    """

    basis: Basis
    gates: tuple[Gate, ...]
    start: Gate | None
    finish: Gate | None
    vehicle: Vehicle
    margin: float = 0.0
    spare: Mapping[str, float] = field(default_factory=dict)

    def constraints(self, points: Array) -> list[Constraint]:
        """Constraints of the gates on a path by its control points, shape (n, 2), mm.

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        fine = Kinematics(self.basis.even(_EACH), points, self.vehicle.path_offset)
        u = passing_places(fine, self.gates, self.vehicle)
        passed = [(gate, at, False) for gate, at in zip(self.gates, u.tolist(), strict=True)]
        for end, at in ((self.start, 0.0), (self.finish, self.basis.stop)):
            if end is not None:
                passed.append((end, at, True))
        rows = []
        for gate, at, ends in passed:
            motion = Kinematics(self.basis.at(np.array([at])), points, self.vehicle.path_offset)
            kept = self.margin, self.spare.get(gate.key, 0.0)
            rows += _through(gate, motion, self.vehicle, kept, ends=ends)
        return rows


def _through(
    gate: Gate, motion: Kinematics, vehicle: Vehicle, kept: tuple[float, float], *, ends: bool
) -> list[Constraint]:
    """Limits of one gate at the place where it is passed; where a run starts or ends it is held in every direction.

    From its edges a margin is `kept`, and where it costs little a spare distance besides, up to its middle.
    """
    margin, spare = kept
    x, y = planned_place(gate, vehicle)
    track = motion.point(x, y)[0]
    # Unit vector along which the point of the car moves.
    first, second = motion.jets[1][0], motion.jets[2][0]
    turning = (first[0] * second[1] - first[1] * second[0]) / float(first @ first)
    moving = first + turning * (x * motion.left[0] - y * motion.ahead[0])
    along = moving / np.linalg.norm(moving)
    rows = []

    columns, u = np.repeat(motion.places.both, 2, axis=0), np.repeat(motion.places.u, 2)

    def within(kind: LimitKind, off: float, most: float, weight: float, by: Array) -> Constraint:
        values = np.array([off - most, -off - most])
        return Constraint(PathLimit(kind, gate.key), values, weight, columns, np.stack([by, -by]), u)

    def hold(direction: Array, off: float, most: float) -> None:
        rows.append(within(LimitKind.GATE, off, most, _PER_MM, motion.moved(direction[None], x, y)[0]))
        if (more := min(spare, most)) > 0:
            rows.append(rows[-1].tightened(more))

    if len(gate.place.points) == 1:
        off = track - np.array(gate.place.points[0])
        most = _within(gate.place.reach, margin)
        if ends:
            # Within a regular polygon whose corners lie on the disc's edge.
            for angle in np.arange(_SIDES) * pi / _SIDES:
                direction = np.array([np.cos(angle), np.sin(angle)])
                hold(direction, float(direction @ off), most * cos(pi / (2 * _SIDES)))
        else:
            normal = np.array([-along[1], along[0]])
            hold(normal, float(normal @ off), most)
    else:
        a, b = (np.array(point) for point in gate.place.points)
        half = float(np.linalg.norm(b - a)) / 2
        line = (b - a) / (2 * half)
        across = np.array([-line[1], line[0]])
        off = track - (a + b) / 2
        square = float(across @ along)
        crossed = not ends and abs(square) > _SQUARE
        # Where the path crosses the segment, and not where it stands: it may slide along itself.
        direction = line - (line @ along) / square * across if crossed else line
        hold(direction, float(direction @ off), _within(half, margin))
        if not crossed:
            hold(across, float(across @ off), 0.0)
    if gate.heading is not None:
        heading = float(np.arctan2(motion.ahead[0, 1], motion.ahead[0, 0]))
        turned = (heading - gate.heading + pi) % TURN - pi
        most = 0.95 * gate.heading_tolerance
        if most < pi:
            rows.append(within(LimitKind.HEADING, turned, most, _PER_RAD, motion.turning[0]))
    return rows


def _within(reach: float, margin: float) -> float:
    """How far the path may be from the middle of a gate, mm."""
    return reach - min(_INSIDE + margin, reach / 2 if margin == 0 else reach)


def least_length(task: PathTask) -> float:
    """Lower bound of the length of the drive wheel's track, mm: straight from gate to gate, as near as they reach.

    It is 0 where gates may be passed in any order.

    Args:
        task: what is planned.
    """
    course, vehicle = task.course, task.vehicle
    if any(gate.free for gate in course.gates):
        return 0.0
    gates = [gate for gate in (course.start, *course.gates, course.finish) if gate is not None]
    middles = [np.mean(gate.place.points, axis=0) for gate in gates]
    # From the middle of a gate to the drive wheel of a car that passes it.
    off = []
    for gate in gates:
        x, y = planned_place(gate, vehicle)
        half = float(np.linalg.norm(np.subtract(gate.place.points[-1], gate.place.points[0]))) / 2
        off.append(half + gate.place.reach + float(np.hypot(x, y - vehicle.path_offset)))
    legs = np.linalg.norm(np.diff(middles, axis=0), axis=1) - np.array(off[1:]) - np.array(off[:-1])
    return float(np.maximum(legs, 0.0).sum())
