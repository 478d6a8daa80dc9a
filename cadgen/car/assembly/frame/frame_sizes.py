"""Sizes of a frame that a design states."""

from dataclasses import dataclass

from cadgen.car.assembly.carried import CarriedBody
from cadgen.car.assembly.standard_parts import Screw

STEP = 0.5  # mm, between places that are tried along a foot, and to which heights are rounded up
ROUNDING = 1e-6  # mm


@dataclass(frozen=True, slots=True, kw_only=True)
class FrameSizes:
    """Sizes of a frame that a design states.

    Attributes:
        wall: least material between two holes, and between a hole and an edge, mm.
        screw: screws between plates, base and block.
        tapped: whether the screws go into threads in the edges of the sheets; else into nuts in slots.
        corner: radius of the half circles in inner corners, mm; 0 for sharp ones.
        base: thickness of the base, mm.
        base_height: height of the base's lower face over the floor, mm; None for the highest that the bearings allow.
        travel: way by which the platform can be shifted, mm.
        stem: diameter of the micrometer head's stem, mm; 0 for none.
        drive: distances of the holes for motor or weight along and across the car, mm.
        carried: weight or motor; None for a car whose drive is not stated.
        seat: class of the seats of bearings.
        bed: length, width and height of the printer that prints base, plates and brackets as one part, mm; None for a
            frame of sheets.
    """

    wall: float
    screw: Screw
    tapped: bool
    corner: float
    base: float
    base_height: float | None
    travel: float
    stem: float
    drive: tuple[float, float]
    carried: CarriedBody | None
    seat: str
    bed: tuple[float, float, float] | None = None
