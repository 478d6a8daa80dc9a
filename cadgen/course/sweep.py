"""Nearest approach of the car, swept along its run, to what is on the course.

Between two poses a point of the car moves by no more than the car's reach grows (`Poses.reach`). So from the distances
d0 and d1 at two poses a reach m apart, no pose between is nearer than e = (d0 + d1 - m) / 2. Nor is it nearer than the
lesser of the two by more than m^2 f / 8, with f the greatest second derivative of a distance by the reach: 1 / e of
two corners that pass each other, and `_BEND` for the car's own turning. Stretches of the run that cannot hold the
nearest pose are dropped, the others are halved, until what is left cannot be nearer by `_CLOSE`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import hypot

import numpy as np

from cadgen.arrays import Array
from cadgen.course.body import Body, PartName
from cadgen.course.course import Obstacle, Shape
from cadgen.course.poses import Poses
from cadgen.course.shapes import clearances, outlines, room_inside, wheel_areas

_CLOSE = 5e-3  # mm
_CLOSE_INSIDE = 1.0, 0.02  # mm, and as a share: where the car overlaps a thing, its depth need not be known so well
_BEND = 0.02  # 1/mm; points of a car that turns on a radius of 100 mm bend by half of that
_FIRST = 256  # stretches that the run is first cut into
_MOST_HALVINGS = 60


@dataclass(frozen=True, kw_only=True)
class Approach:
    """Nearest approach of the car to a thing on the course.

    Attributes:
        clearance: distance, mm; less than 0 where the car overlaps it, or is outside the edge.
        place: number of the pose, whole or between two.
        travel: travel of the drive wheel up to there, mm.
        part: part of the car that is nearest.
    """

    clearance: float
    place: float
    travel: float
    part: PartName


def approach(poses: Poses, body: Body, obstacle: Obstacle) -> Approach:
    """Nearest approach of the car to an obstacle; what passes under the body is approached by the wheels alone."""
    under = obstacle.height < body.clearance
    return _nearest(poses, body, lambda parts: clearances(parts, obstacle.shape), wheels_only=under)


def approach_to_edge(poses: Poses, body: Body, edge: Shape) -> Approach:
    """Nearest approach of the car to the edge of the field, from inside."""
    return _nearest(poses, body, lambda parts: room_inside(parts, edge), wheels_only=False)


def _nearest(poses: Poses, body: Body, distances: Callable[[object], Array], *, wheels_only: bool) -> Approach:
    parts: list[PartName] = [wheel.name for wheel in body.wheels]
    if body.corners and not wheels_only:
        parts.append("outline")

    def at(places: Array) -> Array:
        """Distances of all parts, shape (parts, n)."""
        there = poses.at(places)
        rows = [distances(wheel_areas(wheel, there)) for wheel in body.wheels]
        if body.corners and not wheels_only:
            rows.append(distances(outlines(body, there)))
        return np.stack(rows)

    front = max((hypot(wheel.radius, wheel.width / 2) for wheel in body.wheels if wheel.steered), default=0.0)
    radius = max(
        [hypot(*corner) for corner in body.corners]
        + [hypot(*wheel.centre) + hypot(wheel.radius, wheel.width / 2) for wheel in body.wheels]
    )
    reach = poses.reach(radius, front)
    numbers = np.arange(len(poses), dtype=float)
    edges = np.interp(np.linspace(0.0, reach[-1], _FIRST + 1), reach, numbers) if reach[-1] > 0 else numbers[[0, -1]]
    values = at(edges)
    best = _best(edges, values)
    start, stop = edges[:-1], edges[1:]
    near = values.min(axis=0)
    d0, d1 = near[:-1], near[1:]
    for _ in range(_MOST_HALVINGS):
        apart = np.interp(stop, numbers, reach) - np.interp(start, numbers, reach)
        open_ = _least_between(d0, d1, apart) < best[0] - _close(best[0])
        if not open_.any():
            break
        start, stop, d0, d1 = start[open_], stop[open_], d0[open_], d1[open_]
        middle = (start + stop) / 2
        values = at(middle)
        best = min(best, _best(middle, values))
        between = values.min(axis=0)
        start, stop = np.concatenate([start, middle]), np.concatenate([middle, stop])
        d0, d1 = np.concatenate([d0, between]), np.concatenate([between, d1])
    clearance, place, part = best
    travel = float(np.interp(place, numbers, poses.travel))
    return Approach(clearance=clearance, place=place, travel=travel, part=parts[part])


def _least_between(d0: Array, d1: Array, apart: Array) -> Array:
    """Lower bound of the distance between poses `apart` mm apart, from the distances at both."""
    straight = (d0 + d1 - apart) / 2
    bend = 1 / np.maximum(straight, 1e-9) + _BEND
    return np.maximum(straight, np.where(straight > 0, np.minimum(d0, d1) - apart**2 / 8 * bend, -np.inf))


def _close(best: float) -> float:
    return _CLOSE if best > 0 else max(_CLOSE_INSIDE[0], _CLOSE_INSIDE[1] * -best)


def _best(places: Array, values: Array) -> tuple[float, float, int]:
    """Least distance, its place and its part; of equals the earliest."""
    part, column = np.unravel_index(int(np.argmin(values)), values.shape)
    return float(values[part, column]), float(places[column]), int(part)
