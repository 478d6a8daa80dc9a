"""The sections of the course: field, posts, walls, zones, gates, start and finish."""

from typing import Annotated

from pydantic import Field, Strict, model_validator

from cadgen.car.course.layout import CarPoint, Judged, Scaled, Side
from cadgen.design.polygon import crossing
from cadgen.design.section import HERE, WORD, Point, Points, Section, Size, listed

MOST_OF_A_KIND = 200  # posts, walls, zones, gates: more than any field has room for
MOST_CORNERS = 200
MOST_SPACINGS = 200  # on a settings card: four pages
_LEAST_SEGMENT_MM = 1e-3


class Place(Section):
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
    def _disc_or_segment(self) -> "Place":
        given = [name for name in ("at_mm", "from_mm", "to_mm") if getattr(self, name) is not None]
        if given not in (["at_mm"], ["from_mm", "to_mm"]):
            have = listed(given, "and") or "none of them"
            raise ValueError(f"{HERE} takes at_mm alone, or from_mm and to_mm, but has {have}: give one or the other")
        if self.from_mm and self.to_mm and _apart(self.from_mm, self.to_mm) < _LEAST_SEGMENT_MM:
            raise ValueError(f"{HERE}.from_mm and to_mm are one point: move one of them, or give at_mm")
        if self.from_mm and self.radius_mm is not None:
            raise ValueError(f"{HERE}.radius_mm is given for a segment, which has none: remove it, or give at_mm")
        return self


class Gate(Place):
    """A place that a point of the car must pass, in the order of the gates. One table [[course.gates]] for each."""

    heading_tolerance_deg: float = Field(
        default=90.0, gt=0, le=180, description="greatest angle between the direction of travel and heading_deg"
    )
    free: bool = Field(default=False, description="whether it may be passed at any time, not in its order")


class Stand(Place):
    """Where the run starts. Left out, the path says it."""

    heading_tolerance_deg: float = Field(
        default=1.0, gt=0, le=180, description="greatest angle between the direction of travel and heading_deg"
    )


class Finish(Stand):
    """Where the run ends. Left out, the path says it."""


class Edge(Section):
    """The field, which no part of the car may leave: a rectangle or a polygon."""

    corner_mm: Point | None = Field(default=None, description="[x, y] of a rectangle's lower left corner; or [0, 0]")
    size_mm: Size | None = Field(default=None, description="[width, height] of a rectangle")
    outline_mm: Points | None = Field(
        default=None, min_length=3, max_length=MOST_CORNERS, description="[x, y] of each corner of a polygon, in order"
    )

    @model_validator(mode="after")
    def _rectangle_or_polygon(self) -> "Edge":
        if (self.size_mm is None) == (self.outline_mm is None) or (self.corner_mm and self.outline_mm):
            raise ValueError(f"{HERE} takes size_mm, and corner_mm beside it, or else outline_mm: give one of the two")
        refuse_crossing(self.outline_mm, "outline_mm")
        return self


class Post(Section):
    """A round post. One table [[course.posts]] for each."""

    at_mm: Point = Field(description="[x, y] of its middle")
    radius_mm: float = Field(gt=0, le=10_000, description="of the post")
    height_mm: float | None = Field(
        default=None, ge=0, le=10_000, description="left out, too high for the car to pass over"
    )
    side: Annotated[Side, WORD] | None = Field(
        default=None,
        description="on which the car passes it, seen in the direction of travel: `left` has it on the car's right; "
        "left out, either",
    )


class Wall(Section):
    """A wall along a line. One table [[course.walls]] for each."""

    line_mm: Points = Field(min_length=2, max_length=MOST_CORNERS, description="[x, y] of each point of its middle")
    thickness_mm: float = Field(default=0.0, ge=0, le=10_000, description="half of it to either side, and at its ends")
    height_mm: float | None = Field(
        default=None, ge=0, le=10_000, description="left out, too high for the car to pass over"
    )

    @model_validator(mode="after")
    def _line_has_a_length(self) -> "Wall":
        if max(_apart(self.line_mm[0], point) for point in self.line_mm) < _LEAST_SEGMENT_MM:
            raise ValueError(f"{HERE}.line_mm is one point: give the two ends of the wall, or use [[course.posts]]")
        return self


class Zone(Section):
    """An area that no part of the car may enter: a disc, a rectangle or a polygon. One table for each."""

    at_mm: Point | None = Field(default=None, description="[x, y] of a disc's centre")
    radius_mm: float | None = Field(default=None, gt=0, le=100_000, description="of a disc")
    corner_mm: Point | None = Field(default=None, description="[x, y] of a rectangle's lower left corner")
    size_mm: Size | None = Field(default=None, description="[width, height] of a rectangle")
    outline_mm: Points | None = Field(
        default=None, min_length=3, max_length=MOST_CORNERS, description="[x, y] of each corner of a polygon, in order"
    )
    height_mm: float | None = Field(
        default=None, ge=0, le=10_000, description="left out, no part of the car may be above it; 0 for paint"
    )

    @model_validator(mode="after")
    def _one_form(self) -> "Zone":
        names = ("at_mm", "radius_mm", "corner_mm", "size_mm", "outline_mm")
        given = [name for name in names if getattr(self, name) is not None]
        if given not in (["at_mm", "radius_mm"], ["corner_mm", "size_mm"], ["outline_mm"]):
            have = listed(given, "and") or "none of them"
            raise ValueError(
                f"{HERE} takes at_mm and radius_mm, or corner_mm and size_mm, or outline_mm, but has {have}: give one "
                "of the three"
            )
        refuse_crossing(self.outline_mm, "outline_mm")
        return self


class Spacing(Section):
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
    def _upwards(self) -> "Spacing":
        low, high = self.from_mm, self.to_mm
        if low > high:
            raise ValueError(f"{HERE}.from_mm is {low:g}, more than {HERE}.to_mm, {high:g}: exchange them")
        if low == high:
            raise ValueError(
                f"{HERE}.from_mm and to_mm are both {low:g}, so nothing is drawn: set them apart, or remove [{HERE}]"
            )
        if not low <= self.stated_mm <= high:
            raise ValueError(
                f"{HERE}.nominal_mm is {self.stated_mm:g}, outside of what is drawn, {low:g} to {high:g}: state the "
                "course at a spacing between them"
            )
        if (high - low) / self.step_mm > MOST_SPACINGS:
            raise ValueError(
                f"{HERE}.step_mm is {self.step_mm:g}, which makes more than {MOST_SPACINGS} spacings: raise it to "
                f"{(high - low) / MOST_SPACINGS:.3g} or more"
            )
        return self


class Course(Section):
    """The course: what the car must pass and what it must not touch. The cam does not depend on it; its checks do."""

    margin_mm: float = Field(
        default=0.0, ge=0, le=10_000, description="that the car keeps from posts, walls, zones and the field's edge"
    )
    judged: Annotated[Judged, WORD] = Field(
        default=Judged.PLANNED,
        description="runs that must keep the course: `planned`, which is without play, or with `play` those over the "
        "band of play as well, which are else only shown",
    )
    field: Edge | None = None
    start: Stand | None = None
    finish: Finish | None = None
    spacing: Spacing | None = None
    posts: Annotated[tuple[Post, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)
    walls: Annotated[tuple[Wall, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)
    zones: Annotated[tuple[Zone, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)
    gates: Annotated[tuple[Gate, ...], Strict(False)] = Field(default=(), max_length=MOST_OF_A_KIND)


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
            f"{HERE}.{key} crosses itself: the side from corner {a + 1} meets that from corner {b + 1}: list the "
            "corners in order around it"
        )


def _apart(a: Point, b: Point) -> float:
    return max(abs(a[0] - b[0]), abs(a[1] - b[1]))
