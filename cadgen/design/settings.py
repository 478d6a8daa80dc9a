"""The section of what a team can set on its car when the spacing of a course is drawn."""

from math import radians
from typing import Annotated

from annotated_types import Ge, Gt, Le
from pydantic import Field, Strict, model_validator

from cadgen.design.section import DesignSection
from cadgen.deviations.deviation import Deviation
from cadgen.messages import Message

MOST_AT_HAND = 50
Radii = Annotated[tuple[Annotated[float, Gt(0), Le(1000)], ...], Strict(False)]
Ratios = Annotated[tuple[Annotated[float, Ge(0.01), Le(10_000)], ...], Strict(False)]


class SettingsSection(DesignSection):
    """Ranges of what a team can set on the car when the spacing of the course is drawn. What is left out stays."""

    disc_from_mm: float = Field(
        default=0.0, ge=-500, le=0, description="how far the disc can be moved on its shaft towards the fork axis"
    )
    disc_to_mm: float = Field(default=0.0, ge=0, le=500, description="how far it can be moved away from the fork axis")
    disc_step_mm: float = Field(default=0.0, ge=0, le=10, description="division of the disc's place; 0 for any")
    head_from_mm: float = Field(
        default=0.0,
        ge=-50,
        le=0,
        description="how far the micrometer head can take the fork axis towards the camshaft, which lessens "
        "`base_radius_mm`",
    )
    head_to_mm: float = Field(
        default=0.0, ge=0, le=50, description="how far it can take the fork away from the camshaft"
    )
    head_step_mm: float = Field(default=0.0, ge=0, le=1, description="division of the head that is set; 0 for any")
    wheel_radii_mm: Radii = Field(
        default=(), max_length=MOST_AT_HAND, description="radii of the drive wheels at hand; or give a range"
    )
    wheel_from_mm: float | None = Field(default=None, gt=0, le=1000, description="least radius that can be made")
    wheel_to_mm: float | None = Field(default=None, gt=0, le=1000, description="greatest radius that can be made")
    wheel_step_mm: float = Field(default=0.0, ge=0, le=10, description="between radii that can be made; 0 for any")
    ratios: Ratios = Field(
        default=(),
        max_length=MOST_AT_HAND,
        description="ratios of the train that can be put in, turns of the drive wheel for one of the cam; left out, "
        "that of [train]",
    )
    start_within_mm: float = Field(
        default=0.0, ge=0, le=10_000, description="how far the start may be moved along x and along y"
    )
    start_step_mm: float = Field(
        default=0.0, ge=0, le=100, description="to which x and y of the start are set; 0 for any"
    )
    start_heading_within_deg: float = Field(
        default=0.0, ge=0, le=180, description="how far the heading at the start may be turned to either side"
    )
    start_heading_step_deg: float = Field(default=0.0, ge=0, le=10, description="to which it is set; 0 for any")

    def range_of(self, deviation: Deviation) -> tuple[float, float, float]:
        """Least and greatest change of a deviation by hand, and its division, mm or rad.

        Args:
            deviation: one whose keys the catalogue says (`Hand.keys`).
        """
        assert deviation.hand is not None
        stem, unit, internal = deviation.hand.keys, *(("deg", radians) if deviation.unit == "rad" else ("mm", float))

        def value(end: str) -> float:
            return internal(getattr(self, f"{stem}_{end}_{unit}"))

        if hasattr(self, f"{stem}_within_{unit}"):
            return -value("within"), value("within"), value("step")
        return value("from"), value("to"), value("step")

    @model_validator(mode="after")
    def _wheels_are_listed_or_made(self) -> "SettingsSection":
        low, high = self.wheel_from_mm, self.wheel_to_mm
        if (low is None) != (high is None):
            raise ValueError(Message("settings has only one of wheel_from_mm and wheel_to_mm: give both or neither"))
        if low is not None and high is not None and low > high:
            raise ValueError(
                Message(
                    "settings.wheel_from_mm is {low:g}, more than wheel_to_mm, {high:g}: exchange them",
                    low=low,
                    high=high,
                )
            )
        if low is not None and self.wheel_radii_mm:
            raise ValueError(
                Message(
                    "settings has wheel_radii_mm, and wheel_from_mm with wheel_to_mm as well: give the wheels at "
                    "hand or the range of those that can be made, not both"
                )
            )
        return self
