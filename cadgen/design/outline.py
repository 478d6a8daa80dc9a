"""The section of the car's outline and wheels in plan view."""

from pydantic import Field, model_validator

from cadgen.design.course import MOST_CORNERS, refuse_crossing
from cadgen.design.section import HERE, Points, Section, listed


class Outline(Section):
    """Area of the car in plan view, about its fork axis: a rectangle or a polygon, and its wheels.

    Posts, walls and zones must keep clear of all that. Wheels that stick out are seen from above as rectangles as long
    as their diameter.
    """

    length_mm: float | None = Field(default=None, gt=0, le=5000, description="of the body, from its front to its rear")
    width_mm: float | None = Field(default=None, gt=0, le=5000, description="of the body")
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
    def _rectangle_or_polygon(self) -> "Outline":
        names = ("length_mm", "width_mm", "front_overhang_mm", "left_overhang_mm")
        given = [name for name in names if getattr(self, name) is not None]
        if self.corners_mm and given:
            raise ValueError(f"{HERE} has corners_mm and {listed(given, 'and')}: remove one or the other")
        missing = [name for name in names[:3] if name not in given]
        if not self.corners_mm and missing:
            raise ValueError(f"{HERE} needs {listed(missing, 'and')}: add what is missing, or give corners_mm")
        refuse_crossing(self.corners_mm, "corners_mm")
        return self
