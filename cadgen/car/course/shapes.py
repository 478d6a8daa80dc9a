"""Distances between parts of the car and what is on the course, with shapely, which is imported when it is needed."""

from math import cos, hypot, pi
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.course.body import Body, PartName, Wheel
from cadgen.car.course.course import Point, Shape
from cadgen.car.course.poses import Complex, Poses


def geometry(shape: Shape) -> Any:
    """Points, line or area of a shape without its reach."""
    import shapely

    if shape.filled:
        return shapely.Polygon(shape.points)
    return shapely.LineString(shape.points) if len(shape.points) > 1 else shapely.Point(shape.points[0])


def outlines(body: Body, poses: Poses) -> Any:
    """Outline of the car's body at poses, an array of n polygons."""
    return _placed(body.corners, poses)


def wheel_areas(wheel: Wheel, poses: Poses) -> Any:
    """Wheel as seen from above at poses, an array of n polygons; of lines or points where it has no width or length."""
    if wheel.radius == 0 and wheel.width == 0:
        return _placed((wheel.centre,), poses)
    length, width = wheel.radius, wheel.width / 2
    corners = np.array([[length, width], [-length, width], [-length, -width], [length, -width]]) @ [1, 1j]
    turned = np.exp(1j * poses.steering)[:, None] if wheel.steered else np.ones((len(poses), 1))
    if length == 0 or width == 0:
        corners = corners[:2] if width == 0 else corners[1:3]
    return _shaped(complex(*wheel.centre) + turned * corners, poses)


def points(places: Complex) -> Any:
    """Points x + iy on the floor, an array of n."""
    import shapely

    return shapely.points(np.stack([places.real, places.imag], axis=-1))


def hidden_wheels(body: Body) -> tuple[PartName, ...]:
    """Wheels that the outline covers, the front wheel however it is turned: they are never nearer than it."""
    import shapely

    outline = shapely.Polygon(body.corners)

    def area(wheel: Wheel) -> Any:
        if wheel.steered:
            return shapely.Point(wheel.centre).buffer(hypot(wheel.radius, wheel.width / 2) / cos(pi / 64))
        x, y = wheel.centre
        return shapely.box(x - wheel.radius, y - wheel.width / 2, x + wheel.radius, y + wheel.width / 2)

    return tuple(wheel.name for wheel in body.wheels if outline.covers(area(wheel)))


def _placed(corners: tuple[Point, ...], poses: Poses) -> Any:
    there = np.array([complex(*corner) for corner in corners])
    return _shaped(np.broadcast_to(there, (len(poses), len(there))), poses)


def _shaped(corners: Any, poses: Poses) -> Any:
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
