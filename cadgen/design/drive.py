"""Section [drive] of a design: drop weight or motor of a car, as a body that the frame carries."""

from enum import StrEnum
from math import inf
from typing import Annotated

from annotated_types import Le
from pydantic import Field, Strict, model_validator

from cadgen.design.section import WORD, DesignSection, Feature
from cadgen.messages import Message

_GRAVITY = 9.81  # m/s², as in `cadgen.car.running.energy`, which loads numpy
_Side = Annotated[Feature, Le(500)]


MOST_FALL = 2000.0  # mm


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
        description="of a weight, by which it may fall in a run: no farther than the string that comes off the axle",
    )
    start_height_mm: float | None = Field(
        default=None,
        gt=0,
        le=3000,
        description="of the weight's lower face over the floor before the run; left out, the lowest from which it "
        "does not meet the base",
    )

    @model_validator(mode="after")
    def _a_weight_falls(self) -> "DriveSection":
        if self.kind == DriveKind.MOTOR:
            if (self.fall_mm, self.start_height_mm) != (None, None):
                raise ValueError(
                    Message(
                        "drive.fall_mm and drive.start_height_mm are of a weight, and drive.kind is motor: remove "
                        'them, or set drive.kind to "weight"'
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

    def energy_of(self, most: float = inf) -> float | None:
        """Energy of a weight that falls, J; None of a motor.

        Args:
            most: length of string that is let off, mm: it falls no farther.
        """
        return None if self.fall_mm is None else self.mass_kg * _GRAVITY * min(self.fall_mm, most) * 1e-3
