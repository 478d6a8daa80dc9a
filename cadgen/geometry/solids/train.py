"""The gear train as solids: a product for each part, and an assembly of them at their places."""

from __future__ import annotations

from collections.abc import Sequence
from colorsys import hsv_to_rgb
from dataclasses import dataclass
from functools import partial
from math import degrees, sqrt
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from OCP.collections import Sequence_TDF_Label
from OCP.gp import gp_Trsf
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Shape
from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from cadgen.aside import Aside
from cadgen.errors import FileError
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.geometry.solids.gear import body_solid
from cadgen.geometry.solids.kernel import Part, faces, fits, is_valid, solids, volume
from cadgen.geometry.solids.step import add_part, colour_of, completed, document_bytes, new_document, read_document

if TYPE_CHECKING:
    from build123d import Compound as Compound

# Hue of the first part, in turns; the next ones follow by the golden section, so that no two parts are alike.
FIRST_HUE, HUE_STEP = 0.58, (sqrt(5) - 1) / 2
SATURATION, BRIGHTNESS = 0.35, 0.75


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class AssembledPart:
    """A part read from an assembly's file: `transform` leads from its frame to the train's, shape (3, 4), mm."""

    name: str
    colour: tuple[float, float, float] | None
    transform: NDArray[np.float64]
    valid: bool
    bodies: int
    volume: float


def train_parts(layout: TrainLayout, name: str, description: str) -> tuple[Part, ...]:
    """The solids of a train, each in its own frame; the parts' names follow that of the train.

    Raises `DesignError` and `FileError` as `body_solid` does.
    """
    return tuple(_part(part, name, description) for part in layout.parts)


def part_name(train: str, part: TrainPart) -> str:
    """Name of a part's product and files."""
    return f"{train}_{part.name}"


def colour_of_shaft(shaft: int) -> tuple[float, float, float]:
    """Red, green and blue of the part on a shaft, counted from 1."""
    return hsv_to_rgb((FIRST_HUE + HUE_STEP * (shaft - 1)) % 1.0, SATURATION, BRIGHTNESS)


def assembly_bytes(parts: Sequence[Part], layout: TrainLayout, name: str, description: str) -> bytes:
    """STEP file of the parts at their places, one product and one use for each: equal parts, equal bytes.

    Raises `FileError` as `step_bytes` does.
    """
    document = new_document()
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    assembly = tool.NewShape()
    _name(assembly, name)
    for part, placed in zip(parts, layout.parts, strict=True):
        move = gp_Trsf()
        move.SetValues(*placed.transform.ravel().tolist())
        _name(tool.AddComponent(assembly, add_part(document, part), TopLoc_Location(move)), part.name)
    tool.UpdateAssemblies()
    return document_bytes(document, name, description)


def train_compound(parts: Sequence[Part], layout: TrainLayout, name: str) -> Compound:
    """Return the parts at their places as one build123d compound, a labelled and coloured solid for each."""
    import build123d

    placed = []
    for part, at in zip(parts, layout.parts, strict=True):
        move = gp_Trsf()
        move.SetValues(*at.transform.ravel().tolist())
        placed.append(part.build123d().located(build123d.Location(TopLoc_Location(move))))
    return build123d.Compound(label=name, children=placed)


def mesh_compound(parts: Sequence[Part], places: Sequence[tuple[float, float, float]], name: str) -> Compound:
    """Return gears as one build123d compound.

    Args:
        parts: gears, each with its axis on z.
        places: place of each gear: x of its axis and height of its lower face, mm, and angle about the axis, rad.
        name: name of the compound.
    """
    import build123d

    placed = [
        part.build123d().located(build123d.Location((x, 0.0, height), (0.0, 0.0, degrees(angle))))
        for part, (x, height, angle) in zip(parts, places, strict=True)
    ]
    return build123d.Compound(label=name, children=placed)


def read_assembly(path: Path) -> tuple[AssembledPart, ...]:
    """Read the parts of an assembly, in the order written, through the kernel's reader.

    Raises `FileError` if the file cannot be read or is not one assembly of parts.
    """
    document, _ = read_document(path)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    roots, uses = Sequence_TDF_Label(), Sequence_TDF_Label()
    tool.GetFreeShapes(roots)
    if roots.Length() != 1 or not XCAFDoc_ShapeTool.GetComponents_s(roots.First(), uses):
        raise FileError(f"{path.name} is not one assembly: export it again")
    placed = []
    for use in (uses.Value(number) for number in range(1, uses.Length() + 1)):
        label = TDF_Label()
        XCAFDoc_ShapeTool.GetReferredShape_s(use, label)
        placed.append((label, XCAFDoc_ShapeTool.GetLocation_s(use).Transformation()))
    shapes = [tool.GetShape_s(label) for label, _ in placed]
    first, second = _halves(shapes)
    with Aside(partial(_judged, [shapes[number] for number in second])) as beside:
        here = _judged([shapes[number] for number in first])
        judged = dict(zip([*first, *second], [*here, *beside.result()], strict=True))
    parts = []
    for number, ((label, move), shape) in enumerate(zip(placed, shapes, strict=True)):
        bodies = solids(shape)
        valid, size = judged[number]
        parts.append(
            AssembledPart(
                name=_named(label),
                colour=colour_of(document, bodies[0]) if bodies else None,
                transform=np.array([[move.Value(row, column) for column in range(1, 5)] for row in range(1, 4)]),
                valid=valid,
                bodies=len(bodies),
                volume=size,
            )
        )
    return tuple(parts)


def _halves(shapes: Sequence[TopoDS_Shape]) -> tuple[list[int], list[int]]:
    """Numbers of the shapes in two groups of about as many faces."""
    counts = [len(faces(shape)) for shape in shapes]
    first: list[int] = []
    second: list[int] = []
    for number in sorted(range(len(shapes)), key=counts.__getitem__, reverse=True):
        lesser = min(first, second, key=lambda group: sum(counts[other] for other in group))
        lesser.append(number)
    return first, second


def _judged(shapes: Sequence[TopoDS_Shape]) -> list[tuple[bool, float]]:
    """Whether the kernel finds neither a gap nor a fault in each shape, and its volume, mm³."""
    whole = [completed(shape) for shape in shapes]
    return [(fits(shape) and is_valid(shape), volume(shape)) for shape in whole]


def _part(part: TrainPart, name: str, description: str) -> Part:
    return Part(
        solid=body_solid(part.body),
        name=part_name(name, part),
        description=description,
        colour=colour_of_shaft(part.shaft),
    )


def _name(label: TDF_Label, name: str) -> None:
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(name))


def _named(label: TDF_Label) -> str:
    attribute = TDataStd_Name()
    return attribute.Get().ToExtString() if label.FindAttribute(TDataStd_Name.GetID_s(), attribute) else ""
