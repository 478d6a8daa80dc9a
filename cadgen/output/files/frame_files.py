"""Files of a frame's parts: outlines as DXF, solids as STEP, programs for a mill, each read back."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cadgen.car.assembly.car_parts import Block
from cadgen.car.assembly.frame.fork_block import ForkBlock
from cadgen.car.assembly.panels import BASE_COLOUR, PLATE_COLOUR, Panel
from cadgen.design.machining import Machining
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.dxf import alike, read_dxf, write_dxf
from cadgen.output.files.publisher import Artifact, require
from cadgen.output.files.step import one_solid

_STEP = 0.05  # mm between the points of an outline that is read back
_PLACE_MM = 1e-6


@dataclass(frozen=True, slots=True)
class FrameText:
    """Words of a design in the files of its frame.

    Attributes:
        design: name of the design.
        described: design with its hash, for STEP.
    """

    design: str
    described: str


def panel_files(
    panel: Panel, folder: Path, stem: str, text: FrameText, machining: Machining | None, seat: str
) -> Iterator[Artifact]:
    """Outline as DXF, solid as STEP, and for a mill the program.

    Args:
        panel: sheet part.
        folder: folder for the files.
        stem: start of their names.
        text: words of the design.
        machining: cutter, speeds and heights; None for a laser.
        seat: class of the seats of bearings.

    Raises:
        DesignError: the cutter is too large for it.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    name = f"{stem}_outline.dxf"
    openings = panel.openings
    write_dxf(folder / name, panel.outline, None, openings)
    drawing = read_dxf(folder / name, _STEP)
    drawn = panel.outline.outline(_STEP).points
    same = len(drawing.holes) == len(openings) and all(map(alike, drawing.holes, openings))
    same = same and drawing.profile.points.shape == drawn.shape
    same = same and np.allclose(drawing.profile.points, drawn, rtol=0, atol=_PLACE_MM)
    require(same, name, Message("has another outline or other holes"))
    yield Artifact(
        name,
        Facts(
            thickness_mm=panel.thickness,
            holes_mm=[[hole.u, hole.v, hole.diameter] for hole in panel.holes],
            openings=len(panel.cuts),
        ),
        (Message("outline and {count} openings", count=len(openings)),),
    )
    colour = BASE_COLOUR if panel.code in ("base", "platform") else PLATE_COLOUR
    yield _solid(panel.shape, panel.volume, folder / f"{stem}.step", text, colour)
    if machining is not None:
        from cadgen.output.files.sheet_nc import sheet_program

        yield sheet_program(panel, folder, stem, machining, text.design, seat)


def block_files(block: ForkBlock, folder: Path, stem: str, text: FrameText) -> Iterator[Artifact]:
    """Solid of the fork's block as STEP.

    Raises:
        FileError: the file cannot be written, or holds something else when it is read back.
    """
    yield _solid(block.shape, block.volume, folder / f"{stem}.step", text, PLATE_COLOUR)


def _solid(shape: Block, exact: float, file: Path, text: FrameText, colour: tuple[float, float, float]) -> Artifact:
    """Solid of a part as STEP; its exact volume is reckoned without the shape's own."""
    from cadgen.geometry.solids.car_solids import shape_solid
    from cadgen.geometry.solids.kernel import SolidPart

    solid = shape_solid(shape, file.stem)
    part = SolidPart(solid=solid, name=file.stem, description=text.described, colour=colour)
    return Artifact(file.name, one_solid(file, part, exact), (Message("one valid solid of the exact volume"),))
