"""Posts, walls, zones and the field's edge against the car's outline, as limits of a path.

A part of the car is a polygon in the car's frame. Its distance from an obstacle is the least of that of the obstacle's
points from the polygon and that of the polygon's corners from the obstacle; points stand close together along walls
and around zones, so that a wall which crosses the car is seen as well. Distances are negative inside, and grow along
the direction in which the car gets out soonest.
"""

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.course.body import CarBody
from cadgen.car.course.layout import Course, Draw, Shape, Side
from cadgen.car.planner.constraints import Constraint, LimitKind, PathLimit
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_task import Vehicle

_EACH = 20  # places of a span at which clearances are held
_SPACING = 25.0  # mm, of the points along walls and around zones
_PER_MM = 1.0  # weight
_INSIDE = 0.05  # mm that is kept besides the margin, for what happens between the places
_FAR = 400.0  # mm; what is farther off than this is no matter for a step


@dataclass(frozen=True, eq=False)
class Barrier:
    """An obstacle or the edge of the field, with what the car must keep from it.

    Attributes:
        key: place in the design file.
        points: its points, close together, shape (k, 2), mm.
        line: its corners in order, the two ends of a wall or the place of a post, shape (c, 2), mm.
        filled: whether `line` is the outline of an area.
        inside: whether the car must stay within the area.
        reach: radius of a post, half the thickness of a wall, mm.
        margin: distance to keep, mm.
        side: side on which it must be passed; None if either will do.
        under: whether it passes under the body, and keeps only the wheels away.
        grown: size of the car against the path. Where a spacing is drawn the path grows and the car does not: seen at
            the stated spacing the car is so many times as large, as are `reach` and `margin`.
    """

    key: str
    points: Array
    line: Array
    filled: bool
    inside: bool
    reach: float
    margin: float
    side: Side | None = None
    under: bool = False
    grown: float = 1.0

    @property
    def corners(self) -> Array:
        """Corners of an area, shape (c, 2), mm; empty if it is none."""
        return self.line if self.filled else self.line[:0]


def barriers_of(course: Course, body: CarBody, draw: Draw | None = None) -> tuple[Barrier, ...]:
    """Barriers of a course for a car, at the ends of its spacings as well if they are drawn."""
    if draw is None:
        return _barriers(course, body, 1.0)
    least, greatest = (spacing / draw.stated for spacing in (draw.spacings[0], draw.spacings[-1]))
    # What moves with the path is nearest to the car where the path is smallest.
    standing = draw.without_moving(course)
    return (
        *_barriers(draw.seen(course, least), body, 1 / least),
        *(each for factor in (1.0, greatest) for each in _barriers(draw.seen(standing, factor), body, 1 / factor)),
    )


def _barriers(course: Course, body: CarBody, grown: float) -> tuple[Barrier, ...]:
    barriers = [
        Barrier(
            obstacle.key,
            _points(obstacle.shape),
            np.array(obstacle.shape.points),
            filled=obstacle.shape.filled,
            inside=False,
            reach=obstacle.shape.reach * grown,
            margin=course.margin * grown,
            side=obstacle.side,
            under=obstacle.height < body.clearance,
            grown=grown,
        )
        for obstacle in course.obstacles
    ]
    if course.edge is not None:
        corners = np.array(course.edge.points)
        # Inside a convex field the corners of the car are all that can be outside.
        points = np.zeros((0, 2)) if _convex(corners) else _points(course.edge)
        barriers.append(
            Barrier(
                "course.field", points, corners, filled=True, inside=True, reach=0.0, margin=course.margin * grown,
                grown=grown,
            )
        )  # fmt: skip
    return tuple(barriers)


def _points(shape: Shape) -> Array:
    """Points along a shape, close together, shape (k, 2)."""
    given = np.array(shape.points)
    if shape.filled:
        given = np.vstack([given, given[:1]])
    if len(given) == 1:
        return given
    pieces = []
    for a, b in itertools.pairwise(given):
        count = max(int(np.ceil(np.linalg.norm(b - a) / _SPACING)), 1)
        pieces.append(a + np.linspace(0, 1, count, endpoint=False)[:, None] * (b - a))
    return np.vstack([*pieces, given[-1:]])


def parts_of(vehicle: Vehicle) -> tuple[tuple[Array, bool], ...]:
    """Parts of the car in the frame of the planned point, x ahead and y to the left, and whether each is a wheel.

    A steered wheel counts as the disc in which it turns, as a polygon about it.
    """
    shift = np.array([vehicle.car.wheelbase, vehicle.path_offset - vehicle.car.drive_wheel_offset])
    parts = []
    if vehicle.body.corners:
        parts.append((np.array(vehicle.body.corners) + shift, False))
    for wheel in vehicle.body.wheels:
        centre = np.array(wheel.centre) + shift
        half = np.array([wheel.radius, wheel.width / 2])
        if wheel.steered:
            angle = np.linspace(0, 2 * np.pi, 16, endpoint=False)
            shape = np.hypot(*half) / np.cos(np.pi / 16) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        else:
            shape = half * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
        corners = np.unique(centre + shape, axis=0) if np.hypot(*half) == 0 else centre + shape
        parts.append((corners, True))
    return tuple(parts)


@dataclass(frozen=True, eq=False)
class Clearances:
    """The barriers of a task.

    Attributes:
        basis: B-splines of the path.
        vehicle: the car.
        barriers: what it must keep clear of.
        spare: distance to keep besides where it costs little, by the keys of the barriers, mm.
    """

    basis: Basis
    vehicle: Vehicle
    barriers: tuple[Barrier, ...]
    spare: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def _parts(self) -> tuple[tuple[Array, bool], ...]:
        return parts_of(self.vehicle)

    @cached_property
    def _outer(self) -> tuple[Array, ...]:
        """Parts that make up the outline of the car: none lies within another, convex one."""
        every = [corners for corners, _ in self._parts]
        return tuple(
            part
            for number, part in enumerate(every)
            if not any(_convex(whole) and polygon_holds(part, whole).all() for whole in every[:number])
        )

    def constraints(self, points: Array) -> list[Constraint]:
        """Constraints of the barriers on a path by its control points, shape (n, 2), mm.

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        if not self.barriers:
            return []
        motion = Kinematics(self.basis.even(_EACH), points, self.vehicle.path_offset)
        radius = max(float(np.linalg.norm(corners, axis=1).max()) for corners, _ in self._parts)
        kept = [each for barrier in self.barriers if (each := self._constraint(barrier, motion, radius)) is not None]
        return kept + [each.tightened(spare) for each in kept if (spare := self.spare.get(each.limit.key, 0.0)) > 0]

    def _constraint(self, barrier: Barrier, motion: Kinematics, radius: float) -> Constraint | None:
        far = radius * barrier.grown + barrier.reach + barrier.margin + _FAR
        away = (
            _signed(motion.jets[0], barrier.line)[0] if barrier.filled else _from_line(motion.jets[0], barrier.line)[0]
        )
        near = away > -far if barrier.inside else away < far
        car = self.vehicle.car
        middle = self.vehicle.path_offset - (car.drive_wheel_offset + car.idle_wheel_offset) / 2
        if barrier.side is not None:  # it counts where the middle of the axle is nearest, however far that is
            passing = motion.jets[0] + middle * motion.left - barrier.points.mean(axis=0)
            near[np.linalg.norm(passing, axis=1).argmin()] = True
        if not near.any():
            return None
        close = Kinematics(motion.places[np.flatnonzero(near)], motion.points, motion.offset)
        parts = [corners for corners, wheel in self._parts if wheel] if barrier.under else self._outer
        parts = [corners * barrier.grown for corners in parts]
        distance, by = _nearest(barrier, close, parts)
        if barrier.side is not None:
            distance, by = _on_side(barrier, close, parts, middle, distance, by)
        value = barrier.margin + barrier.reach + _INSIDE - distance
        kind = LimitKind.FIELD if barrier.inside else LimitKind.CLEARANCE
        return Constraint(PathLimit(kind, barrier.key), value, _PER_MM, close.places.both, -by, close.places.u)


def _nearest(barrier: Barrier, motion: Kinematics, parts: list[Array]) -> tuple[Array, Array]:
    """Least distance at each place, shape (m,), and its derivative, shape (m, 12)."""
    m = len(motion.places.u)
    best, every = np.full(m, np.inf), np.arange(m)
    x, y, direction = np.zeros(m), np.zeros(m), np.zeros((m, 2))
    frame = np.stack([motion.ahead, motion.left], axis=1)  # rows: ahead, left
    # Outside of a part its corners are what counts; of the other points those that may be within.
    ends = len(barrier.line)
    points = barrier.line if ends == 1 else np.vstack([barrier.line, barrier.points])
    dx, dy = points.T[:, None] - motion.jets[0].T[:, :, None]
    apart = dx**2 + dy**2
    for corners in parts:
        if len(corners) > 2 and len(barrier.points):
            reach = float(np.linalg.norm(corners, axis=1).max())
            row, column = np.nonzero((apart <= reach**2) | (np.arange(len(points)) < ends))
            off = np.stack([dx[row, column], dy[row, column]], axis=1)
            seen = np.einsum("pab,pb->pa", frame[row], off)
            away, normal = _signed(seen, corners)
            first = np.lexsort((away, row))[np.searchsorted(row, every)]
            value = away[first]
            better = value < best
            at = seen[first]
            # The point of the car that is nearest moves towards the barrier as the normal in the car's frame says.
            turned = np.einsum("mab,ma->mb", frame, normal[first])
            best[better], x[better], y[better] = value[better], at[better, 0], at[better, 1]
            direction[better] = -turned[better]
        value, corner, out = _corner_distance(barrier, motion, corners)
        better = value < best
        best[better] = value[better]
        x[better], y[better], direction[better] = corners[corner[better], 0], corners[corner[better], 1], out[better]
    return best, motion.moved(direction, x, y)


def _corner_distance(barrier: Barrier, motion: Kinematics, corners: Array) -> tuple[Array, NDArray[np.intp], Array]:
    """Distance of the corner that is nearest to a barrier, its number, and the direction in which it gets away."""
    m = len(motion.places.u)
    placed = (
        motion.jets[0][:, None]
        + corners[None, :, :1] * motion.ahead[:, None]
        + corners[None, :, 1:] * motion.left[:, None]
    )
    flat = placed.reshape(-1, 2)
    if barrier.filled:
        away, out = _signed(flat, barrier.line)
        if barrier.inside:
            away, out = -away, -out
    else:
        away, out = _from_line(flat, barrier.line)
    away = away.reshape(m, -1)
    number = away.argmin(axis=1)
    every = np.arange(m)
    return away[every, number], number, out.reshape(m, -1, 2)[every, number]


def _on_side(
    barrier: Barrier, motion: Kinematics, parts: list[Array], middle: float, distance: Array, by: Array
) -> tuple[Array, Array]:
    """Distance to the side on which a barrier must be passed, where the car passes it on the other one.

    The side is that where the car is nearest to the barrier; farther off a winding path may have it on the other side.
    A path that never comes beside the barrier has it on the side where it begins or ends.

    Args:
        barrier: what is passed.
        motion: places of the path, the nearest one among them.
        parts: parts of the car, in the frame of the planned point.
        middle: y of the middle of the axle in that frame, mm.
        distance: distance at each place, mm.
        by: its derivative.
    """
    frame = np.stack([motion.ahead, motion.left], axis=1)
    seen = np.einsum("mab,mb->ma", frame, barrier.points.mean(axis=0) - motion.jets[0])
    every = np.vstack(parts)
    beside = (seen[:, 0] >= every[:, 0].min()) & (seen[:, 0] <= every[:, 0].max())
    # A car that passes to the left of a barrier has it on its right: beyond its right side.
    sign, edge = (1.0, every[:, 1].min()) if barrier.side == Side.LEFT else (-1.0, every[:, 1].max())
    lateral = sign * (edge - seen[:, 1])
    wrong = beside & (sign * (seen[:, 1] - every[:, 1].mean()) > 0)
    nearest = int(np.hypot(seen[:, 0], seen[:, 1] - middle).argmin())
    # The places in a row on the wrong side, that where the middle of the axle is nearest among them.
    row = np.cumsum(np.append(0, (np.diff(wrong.astype(int)) != 0) | (np.diff(motion.places.u) > 1.5 / _EACH)))
    wrong &= row == row[nearest]
    wrong[nearest] |= sign * (seen[nearest, 1] - middle) > 0
    if wrong.any():
        # The barrier's place in the car's frame moves against the car.
        out = motion.moved(sign * motion.left, seen[:, 0], seen[:, 1])
        distance, by = np.where(wrong, lateral, distance), np.where(wrong[:, None], out, by)
    return distance, by


def _signed(points: Array, corners: Array) -> tuple[Array, Array]:
    """Distance of points from a polygon, negative inside, and the unit vectors along which it grows."""
    closed = np.vstack([corners, corners[:1]])
    away, out = _from_line(points, closed)
    inside = polygon_holds(points, corners)
    return np.where(inside, -away, away), np.where(inside[:, None], -out, out)


def _from_line(points: Array, line: Array) -> tuple[Array, Array]:
    """Distance of points from a line of points, and the unit vectors away from it, shapes (n,) and (n, 2)."""
    if len(line) == 1:
        off = points - line[0]
        away = np.hypot(off[:, 0], off[:, 1])
        return away, off / np.maximum(away, 1e-12)[:, None]
    (x, y), (ax, ay), (dx, dy) = points.T, line[:-1].T[:, :, None], np.diff(line, axis=0).T[:, :, None]
    # From each piece, a row, to each point, a column.
    px, py = x - ax, y - ay
    share = np.clip((px * dx + py * dy) / np.maximum(dx**2 + dy**2, 1e-12), 0.0, 1.0)
    px, py = px - share * dx, py - share * dy
    every = np.arange(len(points))
    nearest = (px**2 + py**2).argmin(axis=0)
    off = np.stack([px[nearest, every], py[nearest, every]], axis=1)
    away = np.hypot(off[:, 0], off[:, 1])
    out = off / np.maximum(away, 1e-12)[:, None]
    on = away <= 1e-9  # on the line itself, the side to its left
    if on.any():
        along = np.concatenate([dx, dy], axis=1)[nearest[on]]
        left = np.stack([-along[:, 1], along[:, 0]], axis=1)
        out[on] = left / np.maximum(np.hypot(left[:, 0], left[:, 1]), 1e-12)[:, None]
    return away, out


def _convex(corners: Array) -> bool:
    """Whether a polygon is convex."""
    along = np.roll(corners, -1, axis=0) - corners
    after = np.roll(along, -1, axis=0)
    turns = along[:, 0] * after[:, 1] - along[:, 1] * after[:, 0]
    return bool((turns >= 0).all() or (turns <= 0).all())


def polygon_holds(points: Array, corners: Array) -> NDArray[np.bool_]:
    """Whether points, shape (m, 2), mm, are inside a polygon of corners in mm, by the crossings of a ray.

    Args:
        points: points, shape (m, 2), mm.
        corners: corners of the polygon in order, shape (c, 2), mm.
    """
    x, y = points[..., 0], points[..., 1]
    inside = np.zeros(len(points), dtype=bool)
    for (x0, y0), (x1, y1) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if y0 == y1:
            continue
        crosses = (y0 > y) != (y1 > y)
        inside ^= crosses & (x < x0 + (y - y0) / (y1 - y0) * (x1 - x0))
    return inside
