"""How a wheel is held on its shaft: keys that the cam's and the gears' sections have in common."""

from enum import StrEnum
from typing import Annotated, TypeVar

from pydantic import Field, model_validator

from cadgen.design.section import HERE, WORD, Section
from cadgen.errors import DesignError
from cadgen.gears.fits import zones_of


class Joint(StrEnum):
    """Joint of a wheel and its shaft."""

    CLAMPED = "clamped"
    PINNED = "pinned"
    GLUED = "glued"
    KEYED = "keyed"
    D_FLAT = "d_flat"


TIGHT = (Joint.CLAMPED, Joint.PINNED, Joint.GLUED)

S = TypeVar("S", bound="Held")


class Held(Section):
    """A wheel on its shaft."""

    joint: Annotated[Joint, WORD] | None = Field(
        default=None,
        description="what holds it on its shaft: `clamped`, `pinned` or `glued`, without play; `keyed` or `d_flat`, "
        "whose clearance adds to the return error; left out, none is counted",
    )
    joint_clearance_least_um: float | None = Field(
        default=None,
        ge=0,
        le=1000,
        description="of the key in its groove, or of a D-shaft across its flat; left out, 0 or that of the fit",
    )
    joint_clearance_greatest_um: float | None = Field(
        default=None, ge=0, le=1000, description="the same at most; left out, that of the fit"
    )
    joint_fit: str | None = Field(
        default=None,
        max_length=20,
        description="instead of the clearances, the fit by ISO 286, such as `JS9/h9` of a groove and its key, or "
        "`H9/h9` of a D-shaft; of the keyway's width or of the bore",
    )
    joint_across_mm: float | None = Field(
        default=None, gt=0, le=500, description="of a D-shaft, from its flat to its far side"
    )

    @model_validator(mode="after")
    def _joint_is_whole(self: S) -> S:
        loose = self.joint is not None and self.joint not in TIGHT
        names = ("joint_clearance_least_um", "joint_clearance_greatest_um", "joint_fit", "joint_across_mm")
        clearances = [name for name in names if getattr(self, name) is not None]
        if clearances and not loose:
            raise ValueError(
                f'{HERE}.{clearances[0]} is for a wheel with joint = "keyed" or "d_flat", and this one has '
                f"{self.joint or 'none'}: set joint, or remove {clearances[0]}"
            )
        least, greatest = self.joint_clearance_least_um, self.joint_clearance_greatest_um
        if loose and greatest is None and self.joint_fit is None:
            raise ValueError(
                f'{HERE}.joint = "{self.joint}" needs its clearance: give joint_clearance_greatest_um, or joint_fit '
                f'such as "JS9/h9"; or choose clamped, pinned or glued, which has none'
            )
        if loose and self.joint_fit is not None and (least is not None or greatest is not None):
            raise ValueError(f"{HERE}.joint_fit and joint_clearance_..._um say the same twice: remove one of them")
        if self.joint_fit is not None:
            try:
                zones_of(self.joint_fit)
            except DesignError as error:
                raise ValueError(f"{HERE}.joint_fit: {error}; or give the clearance itself") from None
        if least is not None and greatest is not None and least > greatest:
            raise ValueError(
                f"{HERE}.joint_clearance_least_um is {least:g}, more than joint_clearance_greatest_um, {greatest:g}: "
                "exchange them"
            )
        return self
