"""Nearest approach of the car, swept along its run, to what is on the course.

Between two poses a point of the car moves by no more than the car's reach grows (`Poses.reach`). So from the distances
d0 and d1 at two poses a reach m apart, no pose between is nearer than e = (d0 + d1 - m) / 2. Nor is it nearer than the
lesser of the two by more than m^2 f / 8, with f the greatest second derivative of a distance by the reach: 1 / e of
two corners that pass each other, and `_BEND` for the car's own turning. Stretches of the run that cannot hold the
nearest pose are dropped, the others are halved, until what is left cannot be nearer by `_CLOSE`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.course.body import Body, PartName
from cadgen.car.course.course import Obstacle, Shape
from cadgen.car.course.poses import Poses
from cadgen.car.course.shapes import clearances, geometry, hidden_wheels, outlines, points, room_inside, wheel_areas

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
    parts = _parts(body, wheels_only=obstacle.height < body.clearance)
    return _nearest(poses, body, parts, lambda areas: clearances(areas, obstacle.shape))


def approach_to_edge(poses: Poses, body: Body, edge: Shape) -> Approach:
    """Nearest approach of the car to the edge of the field, from inside."""
    return _nearest(poses, body, _parts(body), lambda areas: room_inside(areas, edge))


def nearest_point(
    poses: Poses, body: Body, thing: Shape, there: Approach, *, edge: bool = False
) -> tuple[complex, complex]:
    """Point of a thing that the car comes nearest to, x + iy, and the direction from the car to it, of length 1.

    Args:
        poses: run of the car.
        body: outline and wheels of the car.
        thing: shape of the obstacle, or of the field.
        there: nearest approach to it.
        edge: whether the thing is the field, of which the edge counts.
    """
    import shapely

    at = poses.at(np.array([there.place]))
    area = _parts(body, wheels_only=there.part != PartName.OUTLINE)[there.part](at)[0]
    rim = geometry(thing).boundary if edge else geometry(thing)
    (qx, qy), (ox, oy) = shapely.get_coordinates(shapely.shortest_line(area, rim))
    away = complex(ox - qx, oy - qy)
    return complex(ox, oy), away / abs(away) if away else 0j


def _parts(body: Body, *, wheels_only: bool = False) -> dict[PartName, Callable[[Poses], Any]]:
    """Parts of the car that can be nearest, each as areas by poses: a wheel that the outline covers cannot."""
    bodied = bool(body.corners) and not wheels_only
    hidden = hidden_wheels(body) if bodied else ()
    parts: dict[PartName, Callable[[Poses], Any]] = {
        wheel.name: partial(wheel_areas, wheel) for wheel in body.wheels if wheel.name not in hidden
    }
    if bodied:
        parts[PartName.OUTLINE] = partial(outlines, body)
    return parts


def _nearest(
    poses: Poses, body: Body, parts: dict[PartName, Callable[[Poses], Any]], distances: Callable[[Any], Array]
) -> Approach:
    def at(places: Array) -> Array:
        """Distances of all parts, shape (parts, n)."""
        there = poses.at(places)
        return np.stack([distances(areas(there)) for areas in parts.values()])

    numbers = np.arange(len(poses), dtype=float)
    radius = body.radius
    reach = poses.reach(radius, body.steered_radius)
    edges = np.interp(np.linspace(0.0, reach[-1], _FIRST + 1), reach, numbers) if reach[-1] > 0 else numbers[[0, -1]]
    # The fork axis is a point of the car: no part is nearer than it by more than the radius, and the least not farther.
    there = poses.at(edges).fork
    fork = distances(points(there))
    kept = (fork[:-1] + fork[1:] - reach[-1] / (len(edges) - 1)) / 2 - radius <= fork.min()
    start, stop = edges[:-1][kept], edges[1:][kept]
    asked = np.unique(np.concatenate([start, stop]))
    values = at(asked)
    best = _best(asked, values)
    near = values.min(axis=0)
    d0, d1 = near[np.searchsorted(asked, start)], near[np.searchsorted(asked, stop)]
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
    return Approach(clearance=clearance, place=place, travel=travel, part=list(parts)[part])


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
