"""The section on what turns the cam ahead of its gears and what holds it."""

from enum import StrEnum
from typing import Annotated

from pydantic import Field, model_validator

from cadgen.design.section import WORD, Section


class Braked(StrEnum):
    """Part on which a brake acts."""

    DISC = "disc"
    SHAFT = "shaft"


class Mechanics(Section):
    """The rod's force, friction and drag.

    Left out, the rod is reckoned to slide without friction, unless `follower.material` or `blank.material` says what
    slides on what.
    """

    rod_force_N: float = Field(
        default=1.0,
        gt=0,
        le=1000,
        description="of the spring on the rod at zero lift, along the lift, less what fork and wheel hold back on a "
        "fall; the greatest that it may be",
    )
    rod_rate_N_per_mm: float = Field(
        default=0.0, ge=-100, le=100, description="by which that force grows with the lift"
    )
    friction_least: float | None = Field(
        default=None, ge=0, le=1.5, description="sliding friction between rod and disc; left out, by the two materials"
    )
    friction_greatest: float | None = Field(default=None, ge=0, le=1.5, description="the most that it may be")
    greased: bool = Field(default=True, description="whether rod and disc are; for the friction of their materials")
    drag_least_Nmm: float = Field(
        default=0.0, ge=0, le=100_000, description="torque of a brake or felt against the cam's motion, at its weakest"
    )
    drag_greatest_Nmm: float | None = Field(
        default=None, ge=0, le=100_000, description="at its strongest; left out, the least"
    )
    drag_on: Annotated[Braked, WORD] = Field(
        default=Braked.DISC,
        description="what it acts on: the disc itself, or its shaft, on which the disc may have play that is not held",
    )
    drive_torque_Nmm: float | None = Field(
        default=None, gt=0, le=1e7, description="what the drive can give at the camshaft"
    )
    drive_energy_J: float | None = Field(
        default=None, gt=0, le=1e6, description="what the drive has for a run, such as 3.9 of 1 kg that falls 400 mm"
    )

    @model_validator(mode="after")
    def _bands_run_upwards(self) -> "Mechanics":
        least, greatest = self.friction_least, self.friction_greatest
        if (least is None) != (greatest is None):
            raise ValueError("mechanics has only one of friction_least and friction_greatest: give both or neither")
        if least is not None and greatest is not None and least > greatest:
            raise ValueError(
                f"mechanics.friction_least is {least:g}, more than friction_greatest, {greatest:g}: exchange them"
            )
        if self.drag_greatest_Nmm is not None and self.drag_greatest_Nmm < self.drag_least_Nmm:
            raise ValueError(
                f"mechanics.drag_least_Nmm is {self.drag_least_Nmm:g}, more than drag_greatest_Nmm, "
                f"{self.drag_greatest_Nmm:g}: exchange them"
            )
        strongest = self.drag_Nmm[1]
        if self.drive_torque_Nmm is not None and strongest >= self.drive_torque_Nmm:
            raise ValueError(
                f"mechanics.drag_greatest_Nmm is {strongest:g}, and the drive gives {self.drive_torque_Nmm:g} N mm at "
                f"the camshaft (mechanics.drive_torque_Nmm): it cannot turn that; lower the drag, or gear down"
            )
        return self

    @property
    def drag_Nmm(self) -> tuple[float, float]:
        """Least and greatest drag."""
        least = self.drag_least_Nmm
        return least, least if self.drag_greatest_Nmm is None else self.drag_greatest_Nmm
