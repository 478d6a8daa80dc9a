"""Sections of the course and of the car's outline, with the course and the body that they describe.

The numeric rooms' types are made by `layout_of`, `spacings_of` and `body_of`.
"""

from collections.abc import Sequence
from math import floor, inf, radians
from typing import TYPE_CHECKING, Annotated

from pydantic import Field, Strict, model_validator

from cadgen.car.course.layout import (
    CarPoint,
    Course,
    Draw,
    Gate,
    Judged,
    Obstacle,
    ObstacleKind,
    Scaled,
    Shape,
    Side,
)
from cadgen.design.section import HERE, WORD, DesignSection, Point, Points, Size, listed
from cadgen.messages import Message


def crossing(corners: Sequence[Point]) -> tuple[int, int] | None:
    """Numbers of the first two sides that meet where they should not, counted from 0; None of a simple polygon.

    Side i leads from corner i to the next. Neighbours share a corner and no more; a side without length meets its
    neighbour.

    Args:
        corners: corners in order, three or more; the last is joined to the first.
    """
    count = len(corners)
    sides = [(corners[i], corners[(i + 1) % count]) for i in range(count)]
    for i in range(count):
        for j in range(i + 1, count):
            if j == i + 1 or (i == 0 and j == count - 1):
                (a, b), (_, c) = (sides[i], sides[j]) if j == i + 1 else (sides[j], sides[i])
                # One runs back over the other, or has no length.
                if _turn(a, b, c) == 0 and (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) <= 0:
                    return i, j
            elif _meet(sides[i], sides[j]):
                return i, j
    return None


def _meet(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    (a, b), (c, d) = one, other
    turns = _turn(a, b, c), _turn(a, b, d), _turn(c, d, a), _turn(c, d, b)
    if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
        return True
    # An end of one on the line through the other lies between the other's ends.
    return any(
        turn == 0 and all(min(p[i], q[i]) <= r[i] <= max(p[i], q[i]) for i in (0, 1))
        for turn, (p, q, r) in zip(turns, ((a, b, c), (a, b, d), (c, d, a), (c, d, b)), strict=True)
    )


def _turn(a: Point, b: Point, c: Point) -> int:
    """Sign of the turn from a to b to c: 1 to the left, -1 to the right, 0 straight on or back."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (area > 0) - (area < 0)


if TYPE_CHECKING:
    from cadgen.car.course.body import CarBody
    from cadgen.car.steering import Car

MOST_OF_A_KIND = 200  # posts, walls, zones, gates: more than any field has room for
MOST_CORNERS = 200
MOST_SPACINGS = 200  # on a settings card: four pages
_LEAST_SEGMENT_MM = 1e-3


class PlaceSection(DesignSection):
    """A disc about a point, or the segment between two."""

    at_mm: Point | None = Field(default=None, description="[x, y] of a disc's centre; or give from_mm and to_mm")
    from_mm: Point | None = Field(default=None, description="[x, y] where a segment begins")
    to_mm: Point | None = Field(default=None, description="[x, y] where it ends")
    radius_mm: float | None = Field(
        default=None,
        gt=0,
        le=100_000,
        description="of the disc, within which the point must come; left out, 50 of a gate, 1 of start and finish",
    )
    point: Annotated[CarPoint, WORD] = Field(
        default=CarPoint.MIDDLE,
        description="of the car: the fork axis, the middle between the rear wheels, or where a rear wheel stands",
    )
    heading_deg: float | None = Field(
        default=None,
        ge=-360,
        le=360,
        description="direction of travel there, counterclockwise from the x axis; left out, any",
    )

    @model_validator(mode="after")
    def _disc_or_segment(self) -> "PlaceSection":
        given = [name for name in ("at_mm", "from_mm", "to_mm") if getattr(self, name) is not None]
        if given not in (["at_mm"], ["from_mm", "to_mm"]):
            have = listed(given, "and") or Message("none of them")
            raise ValueError(
                Message(
                    "{here} takes at_mm alone, or from_mm and to_mm, but has {have}: give one or the other",
                    here=HERE,
                    have=have,
                )
            )
        if self.from_mm and self.to_mm and _apart(self.from_mm, self.to_mm) < _LEAST_SEGMENT_MM:
            raise ValueError(
                Message("{here}.from_mm and to_mm are one point: move one of them, or give at_mm", here=HERE)
            )
        if self.from_mm and self.radius_mm is not None:
            raise ValueError(
                Message("{here}.radius_mm is given for a segment, which has none: remove it, or give at_mm", here=HERE)
            )
        return self


class GateSection(PlaceSection):
    """A place that a point of the car must pass, in the order of the gates. One table [[course.gates]] for each."""

    heading_tolerance_deg: float = Field(
        default=90.0, gt=0, le=180, description="greatest angle between the direction of travel and heading_deg"
    )
    free: bool = Field(default=False, description="whether it may be passed at any time, not in its order")


class StartSection(PlaceSection):
    """Where the run starts. Left out, the path says it."""

    heading_tolerance_deg: float = Field(
        default=1.0, gt=0, le=180, description="greatest angle between the direction of travel and heading_deg"
    )


class FinishSection(StartSection):
    """Where the run ends. Left out, the path says it."""


class FieldSection(DesignSection):
    """The field, which no part of the car may leave: a rectangle or a polygon."""

    corner_mm: Point | None = Field(default=None, description="[x, y] of a rectangle's lower left corner; or [0, 0]")
    size_mm: Size | None = Field(default=None, description="[width, height] of a rectangle")
    outline_mm: Points | None = Field(
        default=None, min_length=3, max_length=MOST_CORNERS, description="[x, y] of each corner of a polygon, in order"
    )

    @model_validator(mode="after")
    def _rectangle_or_polygon(self) -> "FieldSection":
        if (self.size_mm is None) == (self.outline_mm is None) or (self.corner_mm and self.outline_mm):
            raise ValueError(
                Message(
                    "{here} takes size_mm, and corner_mm beside it, or else outline_mm: give one of the two", here=HERE
                )
            )
        refuse_crossing(self.outline_mm, "outline_mm")
        return self


class PostSection(DesignSection):
    """A round post. One table [[course.posts]] for each."""

    at_mm: Point = Field(description="[x, y] of its middle")
    radius_mm: float = Field(gt=0, le=10_000, description="radius of the post")
    height_mm: float | None = Field(
        default=None, ge=0, le=10_000, description="left out, too high for the car to pass over"
    )
    side: Annotated[Side, WORD] | None = Field(
        default=None,
        description="on which the car passes it, seen in the direction of travel: `left` has it on the car's right; "
        "left out, either",
    )


class WallSection(DesignSection):
    """A wall along a line. One table [[course.walls]] for each."""

    line_mm: Points = Field(min_length=2, max_length=MOST_CORNERS, description="[x, y] of each point of its middle")
    thickness_mm: float = Field(default=0.0, ge=0, le=10_000, description="half of it to either side, and at its ends")
    height_mm: float | None = Field(
        default=None, ge=0, le=10_000, description="left out, too high for the car to pass over"
    )

    @model_validator(mode="after")
    def _line_has_a_length(self) -> "WallSection":
        if max(_apart(self.line_mm[0], point) for point in self.line_mm) < _LEAST_SEGMENT_MM:
            raise ValueError(
                Message(
                    "{here}.line_mm is one point: give the two ends of the wall, or use [[course.posts]]", here=HERE
                )
            )
        return self


class ZoneSection(DesignSection):
    """An area that no part of the car may enter: a disc, a rectangle or a polygon. One table for each."""

    at_mm: Point | None = Field(default=None, description="[x, y] of a disc's centre")
    radius_mm: float | None = Field(default=None, gt=0, le=100_000, description="radius of a disc")
    corner_mm: Point | None = Field(default=None, description="[x, y] of a rectangle's lower left corner")
    size_mm: Size | None = Field(default=None, description="[width, height] of a rectangle")
    outline_mm: Points | None = Field(
        default=None, min_length=3, max_length=MOST_CORNERS, description="[x, y] of each corner of a polygon, in order"
    )
    height_mm: float | None = Field(
        default=None, ge=0, le=10_000, description="left out, no part of the car may be above it; 0 for paint"
    )

    @model_validator(mode="after")
    def _one_form(self) -> "ZoneSection":
        names = ("at_mm", "radius_mm", "corner_mm", "size_mm", "outline_mm")
        given = [name for name in names if getattr(self, name) is not None]
        if given not in (["at_mm", "radius_mm"], ["corner_mm", "size_mm"], ["outline_mm"]):
            have = listed(given, "and") or Message("none of them")
            raise ValueError(
                Message(
                    "{here} takes at_mm and radius_mm, or corner_mm and size_mm, or outline_mm, but has {have}: "
                    "give one of the three",
                    here=HERE,
                    have=have,
                )
            )
        refuse_crossing(self.outline_mm, "outline_mm")
        return self


class SpacingSection(DesignSection):
    """The spacing of the posts where it is drawn on site. The cam is made for the course as it is stated.

    At another spacing what `scaled` names stands so many times as far from `about_mm`. Sizes stay: those of posts and
    gates, thicknesses and the margin.
    """

    from_mm: float = Field(gt=0, le=100_000, description="least spacing that is drawn")
    to_mm: float = Field(gt=0, le=100_000, description="greatest spacing that is drawn")
    nominal_mm: float | None = Field(
        default=None,
        gt=0,
        le=100_000,
        description="spacing of the course as it is stated here; left out, the middle of the two",
    )
    step_mm: float = Field(default=10.0, gt=0, le=10_000, description="between the spacings on the settings card")
    about_mm: Point = Field(default=(0.0, 0.0), description="[x, y] of the point that stays where it is")
    scaled: Annotated[tuple[Annotated[Scaled, WORD], ...], Strict(False)] = Field(
        default=(Scaled.POSTS, Scaled.GATES, Scaled.START, Scaled.FINISH),
        min_length=1,
        max_length=7,
        description="kinds that move with the spacing",
    )

    @property
    def stated_mm(self) -> float:
        """Spacing of the course as it is stated."""
        return (self.from_mm + self.to_mm) / 2 if self.nominal_mm is None else self.nominal_mm

    @model_validator(mode="after")
    def _upwards(self) -> "SpacingSection":
        low, high = self.from_mm, self.to_mm
        if low > high:
            raise ValueError(
                Message(
                    "{here}.from_mm is {low:g}, more than {here}.to_mm, {high:g}: exchange them",
                    here=HERE,
                    low=low,
                    high=high,
                )
            )
        if low == high:
            raise ValueError(
                Message(
                    "{here}.from_mm and to_mm are both {low:g}, so nothing is drawn: set them apart, or remove "
                    "[{here}]",
                    here=HERE,
                    low=low,
                )
            )
        if not low <= self.stated_mm <= high:
            raise ValueError(
                Message(
                    "{here}.nominal_mm is {stated_mm:g}, outside of what is drawn, {low:g} to {high:g}: state "
                    "the course at a spacing between them",
                    here=HERE,
                    stated_mm=self.stated_mm,
                    low=low,
                    high=high,
                )
            )
        if (high - low) / self.step_mm > MOST_SPACINGS:
            raise ValueError(
                Message(
                    "{here}.step_mm is {step_mm:g}, which makes more than {most_spacings} spacings: raise it to "
                    "{least:.3g} or more",
                    here=HERE,
                    step_mm=self.step_mm,
                    most_spacings=MOST_SPACINGS,
                    least=(high - low) / MOST_SPACINGS,
                )
            )
        return self


class CourseSection(DesignSection):
    """The course: what the car must pass and what it must not touch. The cam does not depend on it; its checks do."""

    margin_mm: float = Field(
        default=0.0, ge=0, le=10_000, description="that the car keeps from posts, walls, zones and the field's edge"
    )
    judged: Annotated[Judged, WORD] = Field(
        default=Judged.PLANNED,
        description="runs that must keep the course: `planned`, which is without play, or with `play` those over the "
        "band of play as well, which are else only shown",
    )
    field: FieldSection | None = None
    start: StartSection | None = None
    finish: FinishSection | None = None
    spacing: SpacingSection | None = None
    posts: Annotated[tuple[PostSection, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)
    walls: Annotated[tuple[WallSection, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)
    zones: Annotated[tuple[ZoneSection, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)
    gates: Annotated[tuple[GateSection, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)


def refuse_crossing(corners: Points | None, key: str) -> None:
    """Refuse a polygon whose sides cross or that has no area.

    Raises:
        ValueError: with the key and the sides, for the user.
    """
    if corners is None:
        return
    sides = crossing(corners)
    if sides is not None:
        a, b = sides
        raise ValueError(
            Message(
                "{here}.{key} crosses itself: the side from corner {a} meets that from corner {b}: list the "
                "corners in order around it",
                here=HERE,
                key=key,
                a=a + 1,
                b=b + 1,
            )
        )


def _apart(a: Point, b: Point) -> float:
    return max(abs(a[0] - b[0]), abs(a[1] - b[1]))


class OutlineSection(DesignSection):
    """Area of the car in plan view, about its fork axis: a rectangle or a polygon, and its wheels.

    Posts, walls and zones must keep clear of all that. Wheels that stick out are seen from above as rectangles as long
    as their diameter.
    """

    length_mm: float | None = Field(default=None, gt=0, le=5000, description="of the body, from its front to its rear")
    width_mm: float | None = Field(default=None, gt=0, le=5000, description="width of the body")
    front_overhang_mm: float | None = Field(
        default=None, ge=-5000, le=5000, description="fork axis to the body's front; needed with length_mm"
    )
    left_overhang_mm: float | None = Field(
        default=None,
        ge=-5000,
        le=5000,
        description="fork axis to the body's left side; left out, the body is as wide to either side of the middle "
        "between the rear wheels",
    )
    corners_mm: Points | None = Field(
        default=None,
        min_length=3,
        max_length=MOST_CORNERS,
        description="[x, y] of each corner of a polygon in order, x ahead of the fork axis and y to its left; instead "
        "of length_mm and width_mm",
    )
    ground_clearance_mm: float = Field(
        default=0.0, ge=0, le=10_000, description="height under the body, under which lower posts can pass"
    )
    wheel_diameter_mm: float | None = Field(
        default=None, gt=0, le=5000, description="of the rear wheels; left out, only where they touch the floor counts"
    )
    wheel_width_mm: float = Field(default=0.0, ge=0, le=1000, description="of the rear wheels")
    front_wheel_diameter_mm: float | None = Field(
        default=None, gt=0, le=5000, description="of the front wheel, which turns with the fork"
    )
    front_wheel_width_mm: float = Field(default=0.0, ge=0, le=1000, description="of the front wheel")

    @model_validator(mode="after")
    def _rectangle_or_polygon(self) -> "OutlineSection":
        names = ("length_mm", "width_mm", "front_overhang_mm", "left_overhang_mm")
        given = [name for name in names if getattr(self, name) is not None]
        if self.corners_mm and given:
            raise ValueError(
                Message(
                    "{here} has corners_mm and {listed}: remove one or the other",
                    here=HERE,
                    listed=listed(given, "and"),
                )
            )
        missing = [name for name in names[:3] if name not in given]
        if not self.corners_mm and missing:
            raise ValueError(
                Message(
                    "{here} needs {listed}: add what is missing, or give corners_mm",
                    here=HERE,
                    listed=listed(missing, "and"),
                )
            )
        refuse_crossing(self.corners_mm, "corners_mm")
        return self


GATE_RADIUS = 50.0
STAND_RADIUS = 1.0


def layout_of(given: CourseSection | None) -> Course | None:
    """Course of a design; None without [course]."""
    if given is None:
        return None
    return Course(
        edge=_area(given.field) if given.field else None,
        obstacles=(
            *(
                Obstacle(
                    kind=ObstacleKind.POST,
                    key=f"course.posts.{i}",
                    shape=Shape.disc(post.at_mm, post.radius_mm),
                    height=_height(post.height_mm),
                    side=post.side,
                )
                for i, post in enumerate(given.posts, 1)
            ),
            *(
                Obstacle(
                    kind=ObstacleKind.WALL,
                    key=f"course.walls.{i}",
                    shape=Shape(wall.line_mm, reach=wall.thickness_mm / 2),
                    height=_height(wall.height_mm),
                )
                for i, wall in enumerate(given.walls, 1)
            ),
            *(
                Obstacle(
                    kind=ObstacleKind.ZONE,
                    key=f"course.zones.{i}",
                    shape=_area(zone),
                    height=_height(zone.height_mm),
                )
                for i, zone in enumerate(given.zones, 1)
            ),
        ),
        gates=tuple(_gate(gate, f"course.gates.{i}", GATE_RADIUS) for i, gate in enumerate(given.gates, 1)),
        start=_gate(given.start, "course.start", STAND_RADIUS) if given.start else None,
        finish=_gate(given.finish, "course.finish", STAND_RADIUS) if given.finish else None,
        margin=given.margin_mm,
        judged=given.judged,
    )


def spacings_of(course: CourseSection | None) -> Draw | None:
    """Spacings of the course that can be drawn; None where the course has one spacing alone."""
    given = None if course is None else course.spacing
    if given is None:
        return None
    steps = floor((given.to_mm - given.from_mm) / given.step_mm + 1e-9)
    spacings = {given.from_mm + step * given.step_mm for step in range(steps + 1)} | {given.to_mm}
    return Draw(
        spacings=tuple(sorted(spacings)), stated=given.stated_mm, about=given.about_mm, kinds=frozenset(given.scaled)
    )


def body_of(given: OutlineSection | None, car: "Car") -> "CarBody":
    """Outline and wheels of the car; without [car.outline] the points where its wheels touch the floor."""
    from cadgen.car.course.body import CarBody, CarWheel, PartName  # only here: a design is read without numpy

    rear_radius, rear_width, front_radius, front_width, clearance = 0.0, 0.0, 0.0, 0.0, 0.0
    drive, idle = (-car.wheelbase, car.drive_wheel_offset), (-car.wheelbase, -car.idle_wheel_offset)
    corners: tuple[Point, ...] = ()
    if given:
        rear_radius, rear_width = (given.wheel_diameter_mm or 0.0) / 2, given.wheel_width_mm
        front_radius, front_width = (given.front_wheel_diameter_mm or 0.0) / 2, given.front_wheel_width_mm
        clearance = given.ground_clearance_mm
        length, width, front = given.length_mm or 0.0, given.width_mm or 0.0, given.front_overhang_mm or 0.0
        left = (drive[1] + idle[1]) / 2 + width / 2 if given.left_overhang_mm is None else given.left_overhang_mm
        rectangle = (front, left), (front - length, left), (front - length, left - width), (front, left - width)
        corners = rectangle if given.corners_mm is None else given.corners_mm
    return CarBody(
        corners=corners,
        clearance=clearance,
        wheels=(
            CarWheel(
                name=PartName.FRONT_WHEEL, centre=(0.0, 0.0), radius=front_radius, width=front_width, steered=True
            ),
            CarWheel(name=PartName.DRIVE_WHEEL, centre=drive, radius=rear_radius, width=rear_width),
            CarWheel(name=PartName.IDLE_WHEEL, centre=idle, radius=rear_radius, width=rear_width),
        ),
    )


def _area(given: FieldSection | ZoneSection) -> Shape:
    if given.outline_mm is not None:
        return Shape(given.outline_mm, filled=True)
    if isinstance(given, FieldSection) or given.size_mm is not None:
        (x, y), (width, height) = given.corner_mm or (0.0, 0.0), given.size_mm or (0.0, 0.0)
        return Shape(((x, y), (x + width, y), (x + width, y + height), (x, y + height)), filled=True)
    return Shape.disc(given.at_mm or (0.0, 0.0), given.radius_mm or 0.0)


def _height(given: float | None) -> float:
    return inf if given is None else given


def _gate(given: GateSection | StartSection, key: str, radius: float) -> Gate:
    if given.from_mm is not None and given.to_mm is not None:
        place = Shape((given.from_mm, given.to_mm))
    else:
        place = Shape.disc(given.at_mm or (0.0, 0.0), radius if given.radius_mm is None else given.radius_mm)
    return Gate(
        key=key,
        place=place,
        point=given.point,
        heading=None if given.heading_deg is None else radians(given.heading_deg),
        heading_tolerance=radians(given.heading_tolerance_deg),
        free=isinstance(given, GateSection) and given.free,
        asked=given.radius_mm is not None,
    )
