"""Section [frame] of a design: bearing plates of a car, base plate, and block of the fork."""

from enum import StrEnum
from typing import Annotated

from annotated_types import Le
from pydantic import Field, Strict, model_validator

from cadgen.design.section import WORD, CellText, DesignSection, Feature, FeatureOrNone, listed
from cadgen.messages import Message

_Apart = Annotated[Feature, Le(500)]
_Side = Annotated[Feature, Le(2000)]
_OF_SHEETS = ("cutting", "cutter_diameter_mm")


class Cutting(StrEnum):
    """How the sheets of a frame are cut."""

    MILL = "mill"
    LASER = "laser"


class FrameMake(StrEnum):
    """Ways in which a frame is made."""

    SHEETS = "sheets"
    PRINTED = "printed"


class ScrewThread(StrEnum):
    """Threads of the screws of a frame."""

    M2 = "M2"
    M2_5 = "M2.5"
    M3 = "M3"
    M4 = "M4"
    M5 = "M5"


class FrameSection(DesignSection):
    """The frame that holds the parts of a car: two bearing plates, a base, the fork's platform and block, and brackets.

    All of them follow from the layout. Thickness, material, bearings and the fit of their seats are those of
    [train.plate]; bearings that it leaves out are the smallest of the table.
    """

    make: Annotated[FrameMake, WORD] = Field(
        default=FrameMake.SHEETS,
        description="`sheets` that a laser or a mill cuts, or `printed`: base, bearing plates and brackets are one "
        "part, whose lower face lies on the printer's bed",
    )
    cutting: Annotated[Cutting, WORD] = Field(
        default=Cutting.MILL,
        description="`mill` opens inner corners for a cutter, taps edges for the screws, and writes programs; `laser` "
        "keeps corners sharp, and nuts in slots take the screws",
    )
    cutter_diameter_mm: Feature = Field(default=2.0, le=20, description="of the end mill for the sheets")
    wall_mm: Feature = Field(
        default=2.0,
        le=50,
        description="least material between two holes or threads, and between a hole or thread and an edge",
    )
    screws: Annotated[ScrewThread, WORD] = Field(
        default=ScrewThread.M3, description="threads of the screws between plates, base and block, ISO 4762"
    )
    base_thickness_mm: Feature = Field(default=6.0, le=50, description="of base plate and platform")
    base_height_mm: float | None = Field(
        default=None,
        gt=0,
        le=2000,
        description="of the base plate's lower face over the floor; left out, the highest that the bearings allow",
    )
    slot_mm: FeatureOrNone = Field(
        default=4.0, le=100, description="way along the car by which the micrometer can shift the fork's platform"
    )
    micrometer_mm: FeatureOrNone = Field(
        default=9.5, le=50, description="diameter of the micrometer head's stem; 0 for a car without one"
    )
    drive_holes_mm: Annotated[tuple[_Apart, _Apart], Strict(False)] = Field(
        default=(30.0, 20.0), description="distances of the four holes for motor or weight along and across the car"
    )
    material: CellText | None = Field(
        default=None,
        description="of base, platform, block and brackets; left out, the plates', and PLA for a printed frame",
    )
    bed_mm: Annotated[tuple[_Side, _Side, _Side], Strict(False)] = Field(
        default=(256.0, 256.0, 256.0),
        description="room of the printer for a frame that is `printed`: length and width of its bed, and height",
    )

    @property
    def printed(self) -> bool:
        """Whether the frame is printed in one piece."""
        return self.make == FrameMake.PRINTED

    def _differs(self, key: str) -> bool:
        """Whether a key has another value than where it is left out."""
        return bool(getattr(self, key) != type(self).model_fields[key].default)

    @model_validator(mode="after")
    def _keys_of_one_make(self) -> "FrameSection":
        if self.printed:
            given = [f"frame.{key}" for key in _OF_SHEETS if self._differs(key)]
            if given:
                raise ValueError(
                    Message(
                        '{keys} is of sheets, and frame.make is printed: remove it, or set frame.make to "sheets"',
                        keys=listed(given, "and"),
                    )
                    if len(given) == 1
                    else Message(
                        '{keys} are of sheets, and frame.make is printed: remove them, or set frame.make to "sheets"',
                        keys=listed(given, "and"),
                    )
                )
        elif self._differs("bed_mm"):
            raise ValueError(
                Message(
                    "frame.bed_mm is of a printed frame, and this one is made of sheets: remove it, or set frame.make "
                    'to "printed"'
                )
            )
        return self
