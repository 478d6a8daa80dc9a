"""Section [drive] of a design: drop weight or motor of a car, as a body that the frame carries."""

from enum import StrEnum
from math import inf
from typing import Annotated

from annotated_types import Le
from pydantic import Field, Strict, model_validator

from cadgen.design.section import WORD, DesignSection, Feature, listed
from cadgen.messages import Message

_GRAVITY = 9.81  # m/s², as in `cadgen.car.running.energy`, which loads numpy
_Side = Annotated[Feature, Le(500)]


MOST_FALL = 2000.0  # mm
DRUM_WALL = 2.0  # mm, least wall of a drum on its axle
_OF_A_WEIGHT = ("fall_mm", "start_height_mm", "drum_mm", "string_mm")


class DriveKind(StrEnum):
    """Kinds of drives that a car carries."""

    WEIGHT = "weight"
    MOTOR = "motor"


class DriveSection(DesignSection):
    """Drop weight or motor, which stands on the base of [frame] between the train and the idle wheel.

    A weight is round. It runs between four rods in tubes, on a string that leads over a pulley to the rear axle. The
    mass counts in that of the car, its centre of gravity, tipping and, with [mechanics], the energy of the run.
    """

    kind: Annotated[DriveKind, WORD] = Field(description="`weight` that falls, or `motor` with its battery")
    mass_kg: float = Field(gt=0, le=100, description="of the weight, or of the motor with its battery")
    size_mm: Annotated[tuple[_Side, _Side, _Side], Strict(False)] = Field(
        description="along the car, across it and upwards; a weight is round, so its first two are equal"
    )
    fall_mm: float | None = Field(
        default=None,
        gt=0,
        le=MOST_FALL,
        description="of a weight, by which it may fall in a run: no farther than its string comes off drum or axle",
    )
    start_height_mm: float | None = Field(
        default=None,
        gt=0,
        le=3000,
        description="of the weight's lower face over the floor before the run; left out, the lowest from which it "
        "does not meet the base",
    )
    drum_mm: Feature | None = Field(
        default=None,
        le=500,
        description="of a weight, diameter of a drum on the rear axle on which its string is wound; left out, the "
        "axle itself, which then has a hole for the string",
    )
    string_mm: Feature = Field(default=1.0, le=5, description="of a weight, thickness of its string")

    @model_validator(mode="after")
    def _a_weight_falls(self) -> "DriveSection":
        if self.kind == DriveKind.MOTOR:
            given = [f"drive.{key}" for key in _OF_A_WEIGHT if key in self.model_fields_set]
            if given:
                raise ValueError(
                    Message(
                        '{keys} is of a weight, and drive.kind is motor: remove it, or set drive.kind to "weight"',
                        keys=listed(given, "and"),
                    )
                    if len(given) == 1
                    else Message(
                        '{keys} are of a weight, and drive.kind is motor: remove them, or set drive.kind to "weight"',
                        keys=listed(given, "and"),
                    )
                )
            return self
        if self.fall_mm is None:
            raise ValueError(
                Message("a weight needs the height that it falls: give drive.fall_mm, such as 400 for 3.9 J of 1 kg")
            )
        long, wide, _ = self.size_mm
        if long != wide:
            raise ValueError(
                Message(
                    "a weight is round, and drive.size_mm is {long:g} mm along the car and {wide:g} across it: give "
                    "both its diameter",
                    long=long,
                    wide=wide,
                )
            )
        if self.start_height_mm is not None and self.start_height_mm < self.fall_mm:
            raise ValueError(
                Message(
                    "the weight hits the floor: it starts drive.start_height_mm = {start:g} mm over it and falls "
                    "drive.fall_mm = {fall:g} mm: leave start_height_mm out, or lower fall_mm",
                    start=self.start_height_mm,
                    fall=self.fall_mm,
                )
            )
        return self

    def wound(self, axle: float) -> float:
        """Diameter of the middle of the wound string, mm: pi times that is let off in a turn of the wheel.

        Args:
            axle: diameter of the rear axle, mm.
        """
        return (self.drum_mm or axle) + self.string_mm

    def energy_of(self, most: float = inf) -> float | None:
        """Energy of a weight that falls, J; None of a motor.

        Args:
            most: length of string that is let off, mm: it falls no farther.
        """
        return None if self.fall_mm is None else self.mass_kg * _GRAVITY * min(self.fall_mm, most) * 1e-3
