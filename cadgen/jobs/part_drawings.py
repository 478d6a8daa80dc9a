"""Sheets of the plain parts of a car that is put together: wheels, shafts, rod and fork, with fits and datum."""

from collections.abc import Iterator
from dataclasses import replace
from math import atan2, degrees

import numpy as np

from cadgen.car.assembly.car_parts import Block, BodyShape, CarPart, Prism, Supply
from cadgen.gears.fits import deviations
from cadgen.jobs.car_assembly import CarAssembly
from cadgen.jobs.drawings import Folder, title_of
from cadgen.messages import Message
from cadgen.output.drawing.part_sheets import PartTexts, TurnedStep, block_drawing, turned_drawing
from cadgen.output.drawing.shaft_fit import limits
from cadgen.output.drawing.sheet import DrawingSheet, rounded

# Classes of diameters by the code of the part: of its bores or holes, and of its outside.
_FITS: dict[str, tuple[str, str]] = {
    "drive-wheel": ("H7", ""),
    "idle-wheel": ("F8", ""),
    "front-wheel": ("F8", ""),
    "fork-spindle": ("H7", "h6"),
    "fork-bridge": ("H7", ""),
    "fork-cheek": ("H7", ""),
    "rod": ("", "h6"),
}
# Further notes by the code of the part.
_NOTES = {
    "rod": Message("Rides on the disc: ground and polished along its length, Ra 0.4."),
    "fork-spindle": Message("The lower end is bonded into the bridge; the upper end runs in the bearings."),
}
_FREE = 3.1  # mm; holes of a plate from this size on that are no fits are clearance holes of screws


def drawn_here(part: CarPart) -> bool:
    """Whether a part is made, and neither disc, gear nor drawn elsewhere."""
    return part.supply == Supply.MADE and not part.standard and part.shape is not None


def part_stem(assembly: CarAssembly, part: CarPart) -> str:
    """Stem of the names of a part's files, which is the number of its sheet."""
    return f"{assembly.origin.name}_{part.code}"


def part_sheets(assembly: CarAssembly, folder: Folder) -> Iterator[tuple[str, DrawingSheet]]:
    """Stem and sheet of every plain part.

    Args:
        assembly: car put together.
        folder: folder for the files.
    """
    text = assembly.train.title
    for part in filter(drawn_here, assembly.parts):
        stem = part_stem(assembly, part)
        title = title_of(assembly.origin, text, part.title, part.material, stem, folder)
        title = replace(title, quantity=part.quantity * title.quantity)
        shape = part.shape
        if isinstance(shape, BodyShape):
            steps = [
                TurnedStep(
                    slab.start, slab.end, 2 * slab.rings[0].radii[1], sum(2 * ring.radii[1] for ring in slab.rings[1:2])
                )
                for slab in shape.body.slabs
            ]
            drill = shape.body.radial_hole
            hole = None if drill is None else (drill.diameter, drill.height)
            yield stem, turned_drawing(steps, hole, (), _texts(part, steps, hole), title)
        elif isinstance(shape, Block) and shape.prisms[0].outline.is_circle:
            steps = [TurnedStep(each.low, each.high, 2 * float(each.outline.radii[0]), 0.0) for each in shape.prisms]
            seats = [(seat.low, seat.high, _seat_size(seat)[0]) for seat in shape.cuts]
            yield stem, turned_drawing(steps, None, seats, _texts(part, steps, None), title)
        elif isinstance(shape, Block):
            yield stem, block_drawing(shape, _block_texts(part, shape), title)


def _texts(part: CarPart, steps: list[TurnedStep], hole: tuple[float, float] | None) -> PartTexts:
    """Notes and fits of a turned part."""
    inside, outside = _FITS.get(part.code, ("", "h6" if part.code.startswith("shaft") else ""))
    notes = [Message("Datum: the axis; lengths count from the left end face.")]
    fits: dict[float, str] = {}
    for step in steps:
        if inside and step.bore:
            fits[step.bore] = f" {inside}"
        if outside and not (step.bore or (hole is not None and step.low < hole[1] < step.high)):
            fits[step.diameter] = f" {outside}"
    notes += [_zone(size, named.strip()) for size, named in fits.items()]
    if part.code == "fork-spindle" and hole is not None:
        notes.append(
            Message(
                "Hole for the rod, at the middle of the head: Ø{size:g} {fit} to the axis, square to it.",
                size=hole[0],
                fit=inside,
            )
        )
        notes.append(_zone(hole[0], inside))
    elif hole is not None:
        notes.append(Message("Radial hole Ø{size:g} in the hub: to be tapped M3 through to the bore.", size=hole[0]))
    if part.code in _NOTES:
        notes.append(_NOTES[part.code])
    shape = part.shape
    for seat in shape.cuts if isinstance(shape, Block) else ():
        notes.append(_seat(seat, shape.cuts[0] if isinstance(shape, Block) else seat, steps))
    return PartTexts(notes=tuple(notes), fits=tuple(fits.items()))


def _seat(seat: Prism, first: Prism, steps: list[TurnedStep]) -> Message:
    """Seat of a key in a shaft, in words, with its angle from the first one."""
    across, floor = _seat_size(seat)
    return Message(
        "Seat of a key {width:g} P9 wide, {depth} +0.1 deep, from {low} to {high} mm, turned {angle:.1f}° from the "
        "first one, counterclockwise seen from the right end.",
        width=round(across, 4),
        depth=rounded(steps[0].diameter / 2 - floor, 2),
        low=rounded(seat.low - steps[0].low, 2),
        high=rounded(seat.high - steps[0].low, 2),
        angle=round(degrees(_polar(seat) - _polar(first)), 3) % 360,
    )


def _seat_size(seat: Prism) -> tuple[float, float]:
    """Width of a seat, and distance of its floor from the axis, mm."""
    one, other = seat.outline.vertices[[0, 3]]  # the corners of its floor
    return float(np.hypot(*(one - other))), float(np.hypot(*(one + other))) / 2


def _polar(seat: Prism) -> float:
    """Polar angle of a seat, rad."""
    x, y = seat.outline.vertices.mean(axis=0).tolist()
    return atan2(y, x)


def _block_texts(part: CarPart, block: Block) -> PartTexts:
    """Notes and fits of a plate or block."""
    inside, _ = _FITS.get(part.code, ("", ""))
    sizes = sorted({round(2 * float(hole.radii[0]), 6) for hole in block.prisms[0].holes})
    single = [size for size in sizes if inside and not _FREE < size < _FREE + 0.2]
    notes = [Message("Datum: the largest fitted hole and the lower edge.")]
    notes += [_zone(size, inside) for size in single]
    if block.drilled:
        notes.append(
            Message(
                "{count} holes Ø{size:g} across, through: to be tapped M3 from both ends.",
                count=len(block.drilled),
                size=block.drilled[0].diameter,
            )
        )
    return PartTexts(notes=tuple(notes), fits=tuple((size, f" {inside}") for size in single))


def _zone(size: float, named: str) -> Message:
    """Limit deviations of a class at a size."""
    hole, shaft = deviations(f"{named}/h6" if named[0].isupper() else f"H7/{named}", size)
    return Message(
        "Ø{size:g} {name}: {limits} mm.", size=size, name=named, limits=limits(*(hole if named[0].isupper() else shaft))
    )
