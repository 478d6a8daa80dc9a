"""Section of the layout: how the parts of a car stand beside each other."""

from typing import Annotated

from pydantic import Field

from cadgen.design.section import WORD, DesignSection
from cadgen.parts.face import Face


class LayoutSection(DesignSection):
    """How the train stands in the car. With it the parts are laid out, and checked against each other.

    Stages without direction_deg get the directions that bring the drive onto the rear axle, clear of all parts.
    """

    clearance_mm: float = Field(
        default=1.0, ge=0.05, le=50, description="least gap between disc, rod, wheels, bearings and parts of the train"
    )
    floor_clearance_mm: float = Field(
        default=5.0, ge=0.1, le=500, description="least gap between the floor and all parts but the wheels"
    )
    camshaft_height_mm: float | None = Field(
        default=None, gt=0, le=2000, description="over the floor; left out, the lowest that clears is found"
    )
    train_face: Annotated[Face, WORD] | None = Field(
        default=None,
        description="face of the disc before which the train stands; left out, the inner one, or the other if only "
        "that has room",
    )
    turned_over: bool = Field(
        default=False,
        description="whether the disc sits turned over on its shaft, for a train that turns it the other way round",
    )
