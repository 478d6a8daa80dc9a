"""Sheets of the plain parts of a car that is put together: wheels, shafts, rod and fork, with fits and datum."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import remainder

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.assembly.car_parts import Block, BodyShape, CarPart, KeySlot, Prism, Supply
from cadgen.jobs.car_assembly import CarAssembly
from cadgen.jobs.drawings import Folder, title_of
from cadgen.messages import Message, joined
from cadgen.output.drawing.part_sheets import KeySeat, PartTexts, TurnedStep, block_drawing, turned_drawing
from cadgen.output.drawing.shaft_fit import fillet, limited, shaft_class
from cadgen.output.drawing.sheet import DrawingSheet

# Classes of diameters by the code of the part: of its bores or holes, and of its outside.
_FITS: dict[str, tuple[str, str]] = {
    "drive-wheel": ("H7", ""),
    "idle-wheel": ("F8", ""),
    "front-wheel": ("F8", ""),
    "fork-spindle": ("H7", "h6"),
    "fork-bridge": ("H7", ""),
    "fork-cheek": ("H7", ""),
    "rod": ("", "h6"),
    "drum": ("H7", ""),
}
# Further notes by the code of the part.
_NOTES = {
    "fork-spindle": Message(
        "The lower end, on the left, runs in the bearings and is bonded into the bridge; the upper one bears the leg "
        "spring."
    ),
}
_LENGTHS = {"front-wheel": " (-0.1/-0.2)"}  # limits of whole lengths: the hub turns between the cheeks
# Notes on diameters whose tolerance the design does not state.
_UNTOLD = {
    "drive-wheel": Message(
        "The diameter decides the length of the path. Its tolerance is not stated (tolerances.wheel_radius_mm)."
    )
}
# Textures of outer surfaces by the code of the part: of the rod, which rides on the disc, with the lay along it.
_TEXTURES = {"rod": "Ra 0.4 ="}
_USUAL_SHAFT = "h6"  # where no fit is stated: bores of wheels and rings of bearings are H7 or closer
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
    tolerances = assembly.use.design.tolerances
    runout, radius = tolerances.wheel_runout_mm, tolerances.wheel_radius_mm
    run_outs = {"drive-wheel": 2 * runout} if runout else {}  # twice the eccentricity
    diameters = {"drive-wheel": 2 * radius} if radius else {}
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
            texts = _texts(part, steps, hole, run_outs.get(part.code))
            if within := diameters.get(part.code):
                widest = max(step.diameter for step in steps)
                texts = replace(texts, fits=(*texts.fits, (widest, f" ±{within:g}")))
            elif untold := _UNTOLD.get(part.code):
                texts = replace(texts, notes=(*texts.notes, untold))
            yield stem, turned_drawing(steps, hole, (), texts, title)
        elif isinstance(shape, Block) and shape.prisms[0].outline.is_circle:
            steps = [
                TurnedStep(each.low, each.high, 2 * float(each.outline.radii[0]), _bore(each), _beside(each))
                for each in shape.prisms
            ]
            seats = [
                KeySeat(
                    seat.low,
                    seat.high,
                    seat.width,
                    seat.floor,
                    _turned(seat, shape.seats[0]),
                    seat.rounded,
                    seat.key.size if seat.key else "",
                )
                for seat in shape.seats
            ]
            through = next(((each.diameter, each.start[2]) for each in shape.drilled), None)
            if seats:
                title = replace(title, inner=min(title.edge, *(fillet(seat.width) for seat in seats)))
            classes = shaft_classes(assembly, part.shaft) if part.code.startswith("shaft") else {}
            texts = _texts(part, steps, None, None, classes)
            yield stem, turned_drawing(steps, None, seats, texts, title, through=through)
        elif isinstance(shape, Block):
            inside, _ = _FITS.get(part.code, ("", ""))
            sizes = sorted({round(2 * float(hole.radii[0]), 6) for hole in shape.prisms[0].holes})
            single = [size for size in sizes if inside and not _FREE < size < _FREE + 0.2]
            texts = PartTexts(notes=(), fits=tuple((size, limited(size, inside)) for size in single))
            yield stem, block_drawing(shape, texts, title)


def shaft_classes(assembly: CarAssembly, number: int) -> dict[str, list[Message]]:
    """Classes of a shaft by the fits that the design states, each with what sits there; h6 where it states none.

    Args:
        assembly: car put together.
        number: number of the shaft, from 1.
    """
    making, shafts = assembly.train.making, len(assembly.train.layout.on_shafts)
    fits = {Message("in the gear"): making.shaft(number, shafts).fit.bore}
    if number == shafts:
        fits[Message("in the disc")] = assembly.cam.making.fit.bore
    if assembly.use.design.frame is None and making.bearing_bores is None:
        fits[Message("in the plates")] = making.holes
    classes: dict[str, list[Message]] = {}
    for where, fit in fits.items():
        if fit:
            classes.setdefault(shaft_class(fit), []).append(where)
    return classes or {_USUAL_SHAFT: []}


def _texts(
    part: CarPart,
    steps: list[TurnedStep],
    hole: tuple[float, float] | None,
    run_out: float | None,
    classes: Mapping[str, Sequence[Message]] | None = None,
) -> PartTexts:
    """Notes, fits, run-out and texture of a turned part.

    Args:
        part: part of the car.
        steps: its steps.
        hole: diameter and height of its radial hole, mm; None without one.
        run_out: its circular run-out, mm; None where the design states none.
        classes: classes of a shaft, each with what sits there; None for another part.
    """
    inside, outside = _FITS.get(part.code, ("", ""))
    notes: list[Message] = []
    fits: dict[float, str] = {}
    if classes and len(classes) == 1:
        (outside,) = classes
    elif classes:
        notes += [
            Message(
                "{diameter}: {places}.",
                diameter=f"Ø{steps[0].diameter:g}{limited(steps[0].diameter, named)}",
                places=joined(where),
            )
            for named, where in classes.items()
        ]
    for step in steps:
        if inside and step.bore:
            fits[step.bore] = limited(step.bore, inside)
        if outside and not (step.bore or (hole is not None and step.low < hole[1] < step.high)):
            fits[step.diameter] = limited(step.diameter, outside)
    if part.code == "fork-spindle" and hole is not None:
        fits[hole[0]] = limited(hole[0], inside)
    if part.code in _NOTES:
        notes.append(_NOTES[part.code])
    shape, width = part.shape, ""
    for seat in shape.seats if isinstance(shape, Block) else ():
        width = limited(seat.width, "P9")
    return PartTexts(
        notes=tuple(notes),
        fits=tuple(fits.items()),
        run_out=run_out,
        seat=width,
        texture=_TEXTURES.get(part.code, ""),
        length=_LENGTHS.get(part.code, ""),
    )


def _bore(prism: Prism) -> float:
    """Diameter of the hole on the axis of a round prism, mm; 0 without one."""
    return next((2 * float(hole.radii[0]) for hole in prism.holes if not np.any(hole.centers[0])), 0.0)


def _beside(prism: Prism) -> tuple[float, float]:
    """Distance of a hole beside the bore of a round prism from the axis, and its diameter, mm; zeros without one."""
    holes = (hole for hole in prism.holes if np.any(hole.centers[0]))
    return next(((float(np.hypot(*hole.centers[0])), 2 * float(hole.radii[0])) for hole in holes), (0.0, 0.0))


def _turned(seat: KeySlot, first: KeySlot) -> float:
    """Angle of a seat from the first one, rad, within half a turn; 0 where they differ by rounding alone."""
    return round(remainder(seat.angle - first.angle, TURN), 9)
