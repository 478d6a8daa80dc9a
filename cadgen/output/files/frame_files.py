"""Files of a frame's parts: outlines as DXF, solids as STEP, programs for a mill, each read back."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cadgen.car.assembly.frame import ForkBlock
from cadgen.car.assembly.panels import Panel
from cadgen.design.machining import Machining
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.dxf import alike, read_dxf, write_dxf
from cadgen.output.files.publisher import Artifact, require
from cadgen.output.files.step import one_solid

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import SolidPart

PLATE_COLOUR, BASE_COLOUR = (0.62, 0.66, 0.70), (0.50, 0.54, 0.58)
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
    from cadgen.geometry.solids.frame_solids import panel_part

    colour = BASE_COLOUR if panel.code in ("base", "platform") else PLATE_COLOUR
    yield _solid(folder, panel_part(panel, stem, text.described, colour), panel.volume)
    if machining is not None:
        from cadgen.output.files.sheet_nc import sheet_program

        yield sheet_program(panel, folder, stem, machining, text.design, seat)


def block_files(block: ForkBlock, folder: Path, stem: str, text: FrameText) -> Iterator[Artifact]:
    """Solid of the fork's block as STEP.

    Raises:
        FileError: the file cannot be written, or holds something else when it is read back.
    """
    from cadgen.geometry.solids.frame_solids import block_part

    yield _solid(folder, block_part(block, stem, text.described, PLATE_COLOUR), block.volume)


def _solid(folder: Path, part: "SolidPart", exact: float) -> Artifact:
    file = folder / f"{part.name}.step"
    return Artifact(file.name, one_solid(file, part, exact), (Message("one valid solid of the exact volume"),))
