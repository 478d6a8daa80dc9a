"""Nearest approach of the car, swept along its run, to what is on the course.

Distances are those of shapely, which is imported when it is needed.

Between two poses a point of the car moves by no more than the car's reach grows (`RunPoses.reach`). So from the
distances d0 and d1 at two poses a reach m apart, no pose between is nearer than e = (d0 + d1 - m) / 2. Nor is it
nearer than the lesser of the two by more than m^2 f / 8, with f the greatest second derivative of a distance by the
reach: 1 / e of two corners that pass each other, and `_BEND` for the car's own turning. Stretches of the run that
cannot hold the nearest pose are dropped, the others are halved, until what is left cannot be nearer by `_CLOSE`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import cos, hypot, pi
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.course.body import CarBody, CarWheel, PartName, RunPoses
from cadgen.car.course.layout import Obstacle, Point, Shape


def geometry(shape: Shape) -> Any:
    """Geometry of a shape without its reach: points, line or area."""
    import shapely

    if shape.filled:
        return shapely.Polygon(shape.points)
    return shapely.LineString(shape.points) if len(shape.points) > 1 else shapely.Point(shape.points[0])


def wheel_areas(wheel: CarWheel, poses: RunPoses) -> Any:
    """Areas of a wheel seen from above at n poses; lines or points where it has no width or length."""
    if wheel.radius == 0 and wheel.width == 0:
        return _placed((wheel.centre,), poses)
    length, width = wheel.radius, wheel.width / 2
    corners = np.array([[length, width], [-length, width], [-length, -width], [length, -width]]) @ [1, 1j]
    turned = np.exp(1j * poses.steering)[:, None] if wheel.steered else np.ones((len(poses), 1))
    if length == 0 or width == 0:
        corners = corners[:2] if width == 0 else corners[1:3]
    return _shaped(complex(*wheel.centre) + turned * corners, poses)


def hidden_wheels(body: CarBody) -> tuple[PartName, ...]:
    """Wheels that the outline covers, the front wheel however it is turned: they are never nearer than it."""
    import shapely

    outline = shapely.Polygon(body.corners)

    def area(wheel: CarWheel) -> Any:
        if wheel.steered:
            return shapely.Point(wheel.centre).buffer(hypot(wheel.radius, wheel.width / 2) / cos(pi / 64))
        x, y = wheel.centre
        return shapely.box(x - wheel.radius, y - wheel.width / 2, x + wheel.radius, y + wheel.width / 2)

    return tuple(wheel.name for wheel in body.wheels if outline.covers(area(wheel)))


def _placed(corners: tuple[Point, ...], poses: RunPoses) -> Any:
    there = np.array([complex(*corner) for corner in corners])
    return _shaped(np.broadcast_to(there, (len(poses), len(there))), poses)


def _shaped(corners: Any, poses: RunPoses) -> Any:
    """Points in the car's frame, x + iy, shape (n, k), as areas, lines or points on the floor."""
    import shapely

    placed = poses.fork[:, None] + corners * poses.ahead[:, None]
    xy = np.stack([placed.real, placed.imag], axis=-1)
    if xy.shape[1] == 1:
        return shapely.points(xy[:, 0])
    return shapely.linestrings(xy) if xy.shape[1] == 2 else shapely.polygons(xy)


def clearances(parts: Any, shape: Shape) -> Array:
    """Distance of each part from a shape, shape (n,), mm; where they overlap, less than 0, by how far.

    Args:
        parts: geometries of a part of the car at n poses.
        shape: what it must not touch.
    """
    import shapely

    there = geometry(shape)
    apart = np.asarray(shapely.distance(parts, there), dtype=float)
    for number in np.flatnonzero(apart == 0):
        apart[number] = -_depth(parts[number], there)
    return apart - shape.reach


def room_inside(parts: Any, edge: Shape) -> Array:
    """Distance of each part from the edge of an area that it must not leave, shape (n,), mm; outside less than 0."""
    import shapely

    area = geometry(edge)
    room = np.asarray(shapely.distance(parts, area.boundary), dtype=float)
    outside = ~shapely.covers(area, parts)
    if outside.any():
        room[outside] = -_depth_outside(parts[outside], area)
    return room


def _depth(part: Any, there: Any) -> float:
    """How far a part and what it overlaps reach into each other, mm."""
    import shapely

    common = shapely.intersection(part, there)
    if common.is_empty:
        return 0.0
    # Ends of what they share lie on a rim; a point within does not.
    pieces = shapely.get_parts(common)
    lines = shapely.get_dimensions(pieces) == 1
    within = [
        shapely.line_interpolate_point(pieces[lines], 0.5, normalized=True),
        shapely.point_on_surface(pieces[~lines]),
    ]
    inner = shapely.get_coordinates(np.concatenate(within))
    corners = shapely.points(np.vstack([shapely.get_coordinates(common), inner]))
    rims = [each.boundary for each in (part, there) if each.geom_type == "Polygon"]
    return max((float(shapely.distance(corners, rim).max()) for rim in rims), default=0.0)


def _depth_outside(parts: Any, area: Any) -> Array:
    """How far parts reach out of an area, shape (n,), mm: a corner of each, or a point within what is outside."""
    import shapely

    corners, owner = shapely.get_coordinates(parts, return_index=True)
    depth = np.zeros(len(parts))
    np.maximum.at(depth, owner, shapely.distance(shapely.points(corners), area))
    within = shapely.point_on_surface(shapely.difference(parts, area))
    # A part that only touches the edge leaves nothing outside, and so no distance.
    return np.asarray(np.fmax(depth, shapely.distance(within, area)))


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


def approach(poses: RunPoses, body: CarBody, obstacle: Obstacle) -> Approach:
    """Nearest approach of the car to an obstacle; what passes under the body is approached by the wheels alone."""
    parts = _parts(body, wheels_only=obstacle.height < body.clearance)
    return _swept(poses, body, parts, lambda areas: clearances(areas, obstacle.shape))


def approach_to_edge(poses: RunPoses, body: CarBody, edge: Shape) -> Approach:
    """Nearest approach of the car to the edge of the field, from inside."""
    return _swept(poses, body, _parts(body), lambda areas: room_inside(areas, edge))


def nearest_point(
    poses: RunPoses, body: CarBody, thing: Shape, there: Approach, *, edge: bool = False
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


def _parts(body: CarBody, *, wheels_only: bool = False) -> dict[PartName, Callable[[RunPoses], Any]]:
    """Parts of the car that can be nearest, each as areas by poses: a wheel that the outline covers cannot."""
    bodied = bool(body.corners) and not wheels_only
    hidden = hidden_wheels(body) if bodied else ()
    parts: dict[PartName, Callable[[RunPoses], Any]] = {
        wheel.name: partial(wheel_areas, wheel) for wheel in body.wheels if wheel.name not in hidden
    }
    if bodied:
        parts[PartName.OUTLINE] = partial(_placed, body.corners)
    return parts


def _swept(
    poses: RunPoses, body: CarBody, parts: dict[PartName, Callable[[RunPoses], Any]], distances: Callable[[Any], Array]
) -> Approach:
    import shapely

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
    fork = distances(shapely.points(np.stack([there.real, there.imag], axis=-1)))
    kept = (fork[:-1] + fork[1:] - reach[-1] / (len(edges) - 1)) / 2 - radius <= fork.min()
    start, stop = edges[:-1][kept], edges[1:][kept]
    asked = np.unique(np.concatenate([start, stop]))
    values = at(asked)
    best = _least(asked, values)
    near = values.min(axis=0)
    d0, d1 = near[np.searchsorted(asked, start)], near[np.searchsorted(asked, stop)]
    for _ in range(_MOST_HALVINGS):
        apart = np.interp(stop, numbers, reach) - np.interp(start, numbers, reach)
        close = _CLOSE if best[0] > 0 else max(_CLOSE_INSIDE[0], _CLOSE_INSIDE[1] * -best[0])
        # Lower bound of the distance between poses, from the distances at both.
        straight = (d0 + d1 - apart) / 2
        bend = 1 / np.maximum(straight, 1e-9) + _BEND
        least = np.minimum(d0, d1) - apart**2 / 8 * bend
        open_ = np.maximum(straight, np.where(straight > 0, least, -np.inf)) < best[0] - close
        if not open_.any():
            break
        start, stop, d0, d1 = start[open_], stop[open_], d0[open_], d1[open_]
        middle = (start + stop) / 2
        values = at(middle)
        best = min(best, _least(middle, values))
        between = values.min(axis=0)
        start, stop = np.concatenate([start, middle]), np.concatenate([middle, stop])
        d0, d1 = np.concatenate([d0, between]), np.concatenate([between, d1])
    clearance, place, part = best
    travel = float(np.interp(place, numbers, poses.travel))
    return Approach(clearance=clearance, place=place, travel=travel, part=list(parts)[part])


def _least(places: Array, values: Array) -> tuple[float, float, int]:
    """Least distance, its place and its part; of equal ones the earliest."""
    part, column = np.unravel_index(int(np.argmin(values)), values.shape)
    return float(values[part, column]), float(places[column]), int(part)
