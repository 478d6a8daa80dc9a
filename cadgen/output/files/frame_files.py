"""Files of a frame's parts: outlines as DXF, solids as STEP, programs for a mill, meshes for a printer; read back."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from cadgen.car.assembly.car_parts import Block, Joined
from cadgen.car.assembly.frame.fork_block import ForkBlock
from cadgen.car.assembly.frame.one_piece import OnePiece
from cadgen.car.assembly.panels import BASE_COLOUR, PLATE_COLOUR, Panel
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.contour import Contour, circle
from cadgen.design.machining import Machining
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.dxf import alike, read_dxf, write_dxf
from cadgen.output.files.publisher import Artifact, require
from cadgen.output.files.step import one_solid
from cadgen.output.files.stl import MeshedPart, for_printing, judged_body, read_stl, stl_bytes
from cadgen.output.files.threemf import read_3mf, threemf_bytes
from cadgen.parts.print_compensation import PrintCompensation

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
    panel: Panel,
    folder: Path,
    stem: str,
    text: FrameText,
    machining: Machining | None,
    seat: str,
    material: DiscMaterial | None = None,
) -> Iterator[Artifact]:
    """Outline as DXF, solid as STEP, and for a mill the program.

    Args:
        panel: sheet part.
        folder: folder for the files.
        stem: start of their names.
        text: words of the design.
        machining: cutter, speeds and heights; None for a laser.
        seat: class of the seats of bearings.
        material: material of the sheet, for the feed of the mill; None if it is not known.

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

        yield sheet_program(panel, folder, stem, machining, text.design, seat, material)


def block_files(block: ForkBlock, folder: Path, stem: str, text: FrameText) -> Iterator[Artifact]:
    """Solid of the fork's block as STEP.

    Raises:
        FileError: the file cannot be written, or holds something else when it is read back.
    """
    yield _solid(block.shape, block.volume, folder / f"{stem}.step", text, PLATE_COLOUR)


def one_piece_files(printed: OnePiece, folder: Path, stem: str, text: FrameText) -> Iterator[Artifact]:
    """Solid of a frame in one piece as STEP.

    Raises:
        FileError: the file cannot be written, or holds something else when it is read back.
    """
    yield _solid(printed.shape, printed.volume, folder / f"{stem}.step", text, BASE_COLOUR)


def mesh_files(
    shape: Block | Joined, folder: Path, stem: str, text: FrameText, printing: PrintCompensation | None, chord: float
) -> Iterator[Artifact]:
    """STL and 3MF of a part for a printer, which must be one watertight body of the exact volume.

    Args:
        shape: shape of the part, its lower face at the least z.
        folder: folder for the files.
        stem: start of their names.
        text: words of the design.
        printing: what the files take back for a printer; None for nothing.
        chord: greatest chord error, mm.

    Raises:
        DesignError: the taper of the foot is wider than an edge of the lower face.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    from cadgen.geometry.meshes.car_meshes import shape_mesh

    if printing is not None and (printing.hole or printing.chords):
        shape = _with_larger_holes(shape, printing, chord)
    lowest = shape.prisms[0] if isinstance(shape, Block) else shape.blocks[0][0].prisms[0]
    base = lowest.outline.area() - sum(hole.area() for hole in lowest.holes)
    meshed = MeshedPart(shape_mesh(shape, chord), chord, (), printing, base)
    mesh, exact = for_printing(meshed.mesh, (), printing), shape.content().volume
    name = f"{stem}.stl"
    (folder / name).write_bytes(stl_bytes(mesh, stem))
    yield judged_body(name, read_stl(folder / name), exact, meshed)
    name = f"{stem}.3mf"
    (folder / name).write_bytes(threemf_bytes(mesh, stem, text.described))
    again, title = read_3mf(folder / name)
    require(title == stem, name, Message("has lost its name"))
    yield judged_body(name, again, exact, meshed)


def _with_larger_holes(shape: Block | Joined, printing: PrintCompensation, chord: float) -> Block | Joined:
    """Shape whose round holes are larger by as much as they print too small."""
    if isinstance(shape, Joined):
        grown = [(_with_larger_holes(block, printing, chord), place) for block, place in shape.blocks]
        return Joined(tuple((block, place) for block, place in grown if isinstance(block, Block)))

    def larger(hole: Contour) -> Contour:
        if not hole.is_circle:
            return hole
        x, y = hole.centers[0].tolist()
        radius = float(hole.radii[0]) + printing.hole / 2
        if printing.chords:
            points = circle((0.0, 0.0), radius).polygon(chord)
            radius *= radius / float(np.linalg.norm((points[0] + points[1]) / 2))
        return circle((x, y), radius)

    prisms = tuple(replace(each, holes=tuple(map(larger, each.holes))) for each in shape.prisms)
    drilled = tuple(hole._replace(diameter=hole.diameter + printing.hole) for hole in shape.drilled)
    return replace(shape, prisms=prisms, drilled=drilled)


def _solid(
    shape: Block | Joined, exact: float, file: Path, text: FrameText, colour: tuple[float, float, float]
) -> Artifact:
    """Solid of a part as STEP; its exact volume is reckoned without the shape's own."""
    from cadgen.geometry.solids.car_solids import shape_solid
    from cadgen.geometry.solids.kernel import SolidPart

    solid = shape_solid(shape, file.stem)
    part = SolidPart(solid=solid, name=file.stem, description=text.described, colour=colour)
    return Artifact(file.name, one_solid(file, part, exact), (Message("one valid solid of the exact volume"),))
