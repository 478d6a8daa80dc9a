"""A course: what the car must pass and what it must not touch. Lengths in mm, angles in rad, all in the floor's frame.

Angles are counterclockwise from the x axis; a heading is a direction of travel.
"""

from dataclasses import dataclass
from math import inf, pi

from cadgen.car.course.names import CarPoint, Judged, ObstacleKind, Side

Point = tuple[float, float]


@dataclass(frozen=True)
class Shape:
    """Every place within `reach` of a point, a line or a polygon: a disc, a segment, a wall, an area.

    Attributes:
        points: one point; two or more of a line; three or more corners where `filled`. mm.
        filled: whether the points are the corners of an area, the last joined to the first.
        reach: distance from these points, mm: radius of a disc, half the thickness of a wall.
    """

    points: tuple[Point, ...]
    filled: bool = False
    reach: float = 0.0

    @classmethod
    def disc(cls, centre: Point, radius: float) -> "Shape":
        """A disc about a centre, with a radius in mm.

        Args:
            centre: centre, mm.
            radius: radius, mm.
        """
        return cls((centre,), reach=radius)


@dataclass(frozen=True, kw_only=True)
class Obstacle:
    """A post, a wall or a zone: what no part of the car may touch.

    Attributes:
        kind: what it is.
        key: place in the design file, such as `course.posts.2`.
        shape: its place and size.
        height: how high it stands, mm; infinite if that does not matter. What is lower than the body's clearance
            passes under the body, and keeps only the wheels away.
        side: side of it on which the car must pass, seen in the direction of travel: `left` leaves it on the car's
            right; None if either will do.
    """

    kind: ObstacleKind
    key: str
    shape: Shape
    height: float = inf
    side: Side | None = None


@dataclass(frozen=True, kw_only=True)
class Gate:
    """A place that a named point of the car must pass; also where a run must start and end.

    Attributes:
        key: place in the design file, such as `course.gates.3`.
        place: a disc, within which the point must come, or a segment of two points, which it must cross.
        point: point of the car.
        heading: direction of travel that it must be passed in, rad; None if any will do.
        heading_tolerance: greatest angle to that direction, rad.
        free: whether it may be passed at any time; the others are passed in their order.
    """

    key: str
    place: Shape
    point: CarPoint = CarPoint.MIDDLE
    heading: float | None = None
    heading_tolerance: float = pi / 2
    free: bool = False


@dataclass(frozen=True, kw_only=True)
class Course:
    """Course with all that is on it.

    Attributes:
        edge: area that no part of the car may leave; None without an edge.
        obstacles: posts, walls and zones.
        gates: gates, those that are not free in their order.
        start: where the run starts, and its heading; None if that is free.
        finish: where the run ends; None if that is free.
        margin: distance that the car must keep from obstacles and from the edge, mm.
        judged: runs that must keep the course.
    """

    edge: Shape | None = None
    obstacles: tuple[Obstacle, ...] = ()
    gates: tuple[Gate, ...] = ()
    start: Gate | None = None
    finish: Gate | None = None
    margin: float = 0.0
    judged: Judged = Judged.PLANNED
