"""A course: what the car must pass and what it must not touch, and the same course at another spacing.

Lengths are in mm and angles in rad, all in the floor's frame. Angles are counterclockwise from the x axis; a heading is
a direction of travel. The module is light to import.
"""

from dataclasses import dataclass, replace
from enum import StrEnum
from math import inf, pi
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from cadgen.arrays import Array

_EXACT = 5.0  # mm; start and finish within less than this are meant to be met


class CarPoint(StrEnum):
    """Point of the car: its fork axis, halfway between the rear wheels, or where a wheel touches the floor."""

    FORK = "fork"
    MIDDLE = "middle"
    DRIVE_WHEEL = "drive_wheel"
    IDLE_WHEEL = "idle_wheel"


class Side(StrEnum):
    """Side of a thing, seen in the direction of driving."""

    LEFT = "left"
    RIGHT = "right"


class ObstacleKind(StrEnum):
    """Kind of a thing that keeps the car away."""

    POST = "post"
    WALL = "wall"
    ZONE = "zone"


class Judged(StrEnum):
    """Runs that must keep the course: the planned one, or those over the band of play as well."""

    PLANNED = "planned"
    PLAY = "play"


class Scaled(StrEnum):
    """Kind of things on a course that move when its spacing is drawn."""

    FIELD = "field"
    START = "start"
    FINISH = "finish"
    POSTS = "posts"
    WALLS = "walls"
    ZONES = "zones"
    GATES = "gates"


Point = tuple[float, float]


@dataclass(frozen=True)
class Shape:
    """Set of all places within `reach` of a point, a line or a polygon: a disc, a segment, a wall, an area.

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
    """Post, wall or zone, which no part of the car may touch.

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
    """Place that a named point of the car must pass, or at which a run must start or end.

    Attributes:
        key: place in the design file, such as `course.gates.3`.
        place: a disc, within which the point must come, or a segment of two points, which it must cross.
        point: point of the car.
        heading: direction of travel that it must be passed in, rad; None if any will do.
        heading_tolerance: greatest angle to that direction, rad.
        free: whether it may be passed at any time; the others are passed in their order.
        asked: whether its size is asked of every car; a finish of which only the place is given is aimed at.
    """

    key: str
    place: Shape
    point: CarPoint = CarPoint.MIDDLE
    heading: float | None = None
    heading_tolerance: float = pi / 2
    free: bool = False
    asked: bool = True

    @property
    def is_exact(self) -> bool:
        """Whether start or finish are meant to be met, and not only come near to."""
        return len(self.place.points) == 1 and self.place.reach <= _EXACT


@dataclass(frozen=True, kw_only=True)
class Course:
    """Course: field, obstacles, gates, start and finish.

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


C = TypeVar("C", float, "Array")


@dataclass(frozen=True, kw_only=True)
class Draw:
    """Spacings of a course, of which one is drawn.

    Attributes:
        spacings: spacings that can be drawn, in order, mm.
        stated: spacing of the course as it is stated, mm.
        about: point that stays where it is, mm.
        kinds: kinds of things that move with the spacing; sizes stay.
    """

    spacings: tuple[float, ...]
    stated: float
    about: Point
    kinds: frozenset[Scaled]

    def course(self, stated: Course, spacing: float) -> Course:
        """The course at a spacing, mm.

        Args:
            stated: course as it is stated.
            spacing: spacing drawn, mm.
        """
        factor, kinds = spacing / self.stated, self.kinds
        obstacles = (
            replace(each, shape=self._shape(each.shape, factor)) if f"{each.kind}s" in kinds else each
            for each in stated.obstacles
        )
        return replace(
            stated,
            edge=self._shape(stated.edge, factor) if stated.edge is not None and Scaled.FIELD in kinds else stated.edge,
            obstacles=tuple(obstacles),
            gates=tuple(self._gate(gate, factor) if Scaled.GATES in kinds else gate for gate in stated.gates),
            start=self._gate(stated.start, factor) if stated.start and Scaled.START in kinds else stated.start,
            finish=self._gate(stated.finish, factor) if stated.finish and Scaled.FINISH in kinds else stated.finish,
        )

    def seen(self, stated: Course, factor: float) -> Course:
        """Course at `factor` times the stated spacing, scaled back to the stated size: what moves is where it was.

        Args:
            stated: course as it is stated.
            factor: ratio of the spacing to the stated one.
        """
        moved = self.course(stated, factor * self.stated)
        whole = replace(self, kinds=frozenset(Scaled))
        return whole.course(moved, self.stated / factor)

    def without_moving(self, stated: Course) -> Course:
        """Obstacles and edge that do not move with the spacing, alone."""
        obstacles = tuple(each for each in stated.obstacles if f"{each.kind}s" not in self.kinds)
        return replace(stated, obstacles=obstacles, edge=None if Scaled.FIELD in self.kinds else stated.edge)

    def tightest(self, stated: Course) -> Course:
        """Course as stated, with the gates as small against the path as they are at the greatest spacing."""
        share = min(self.stated / self.spacings[-1], 1.0)

        def lessened(gate: Gate) -> Gate:
            return replace(gate, place=replace(gate.place, reach=gate.place.reach * share))

        return replace(
            stated,
            gates=tuple(map(lessened, stated.gates)),
            finish=None if stated.finish is None else lessened(stated.finish),
        )

    def point(self, place: tuple[C, C], factor: float) -> tuple[C, C]:
        """Place of a point, or of many, at `factor` times the stated spacing, mm.

        Args:
            place: x and y of the point or points, mm.
            factor: ratio of the spacing to the stated one.
        """
        (x, y), (x0, y0) = place, self.about
        return x0 + factor * (x - x0), y0 + factor * (y - y0)

    def _shape(self, shape: Shape, factor: float) -> Shape:
        return replace(shape, points=tuple(self.point(each, factor) for each in shape.points))

    def _gate(self, gate: Gate, factor: float) -> Gate:
        return replace(gate, place=self._shape(gate.place, factor))
