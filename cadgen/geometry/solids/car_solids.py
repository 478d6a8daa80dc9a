"""Parts of a car as solids, and the car as one assembly: a product for each part, a use of it for each place."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TCollection import TCollection_AsciiString, TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label, TDF_Tool
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Shape, TopoDS_Solid
from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from cadgen.arrays import Array
from cadgen.car.assembly.car_parts import Block, BodyShape, CarPart, DiscShape, Joined, Prism, Shape
from cadgen.errors import FileError
from cadgen.geometry.solids.crossing import with_exact_crossings
from cadgen.geometry.solids.disc_solid import cam_part
from cadgen.geometry.solids.gear_solids import body_solid
from cadgen.geometry.solids.kernel import SolidPart, boolean, contour_edges, faces, is_valid, prism, solids, volume
from cadgen.geometry.solids.step import add_part, completed, document_bytes, new_document, read_uses
from cadgen.messages import Message

_FEW_FACES = 100  # of parts whose volume is measured again: that of a gear takes a second
_UNJOINED = Message("the CAD kernel cannot put the prisms of a part together: report this design")


def shape_solid(shape: Shape, name: str) -> TopoDS_Solid:
    """Solid of a shape in its own frame.

    Args:
        shape: shape of a part.
        name: name of the part, for messages.

    Raises:
        DesignError: features of a disc cut into each other.
        FileError: the kernel did not make one valid solid.
    """
    match shape:
        case BodyShape(body=body):
            return body_solid(body)
        case DiscShape(curve=curve, blank=blank, thickness=thickness):
            return cam_part(curve, blank, thickness, name=name, description="").solid
        case Joined(blocks=blocks):
            first, *others = (_placed(_block(block, name), place) for block, place in blocks)
            return _whole(boolean(BRepAlgoAPI_Fuse(), first, others, _UNJOINED), name)
    return _block(shape, name)


def _placed(solid: TopoDS_Shape, place: Array) -> TopoDS_Shape:
    """Solid at a place, shape (3, 4)."""
    move = gp_Trsf()
    move.SetValues(*place.ravel().tolist())
    return BRepBuilderAPI_Transform(solid, move, True).Shape()


def _block(block: Block, name: str) -> TopoDS_Solid:
    first, *others = (_prism(each) for each in block.prisms)
    made = boolean(BRepAlgoAPI_Fuse(), first, others, _UNJOINED) if others else first
    away = [_placed(_prism(tool), place) for tool, place in (seat.tool for seat in block.seats)]
    for hole in block.drilled:
        start, length = hole.tool
        axis = gp_Ax2(gp_Pnt(*start), gp_Dir(*hole.direction))
        away.append(BRepPrimAPI_MakeCylinder(axis, hole.diameter / 2, length).Shape())
    if away:
        made = boolean(BRepAlgoAPI_Cut(), made, away, _UNJOINED)
    if block.seats or any(hole.beyond for hole in block.drilled):
        made = with_exact_crossings(made)
    return _whole(made, name)


def _whole(made: TopoDS_Shape, name: str) -> TopoDS_Solid:
    """The only solid of a shape, which must be valid."""
    bodies = solids(made)
    if len(bodies) != 1 or not is_valid(bodies[0]):
        raise FileError(
            "the CAD kernel made {bodies} solids of {name}, or an invalid one: report this design",
            bodies=len(bodies),
            name=name,
        )
    return bodies[0]


def _prism(each: Prism) -> TopoDS_Shape:
    holes = [contour_edges(hole, each.low) for hole in each.holes]
    return prism(contour_edges(each.outline, each.low), holes, each.high - each.low)


def car_solids(parts: Iterable[CarPart], description: str) -> dict[str, SolidPart]:
    """Solids of the parts that have a shape, each in its own frame, by their codes.

    Args:
        parts: parts of a car.
        description: description of the products, one line.

    Raises:
        DesignError: features of a disc cut into each other.
        FileError: the kernel did not make one valid solid of a part.
    """
    return {
        part.code: SolidPart(
            solid=shape_solid(part.shape, part.code), name=part.code, description=description, colour=part.colour
        )
        for part in parts
        if part.shape is not None and part.places
    }


def car_bytes(
    solids_of: Mapping[str, SolidPart], places: Mapping[str, Sequence[Array]], name: str, description: str
) -> bytes:
    """STEP file of a car: equal parts at equal places, equal bytes. Uses of a part that stands twice are numbered.

    Args:
        solids_of: solids by their codes.
        places: places of each, shape (3, 4), by their codes.
        name: name of the assembly.
        description: description of the products, one line.

    Raises:
        FileError: the kernel refused, or a name is not ASCII.
    """
    document = new_document()
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    assembly = tool.NewShape()
    _name(assembly, name)
    for code, part in solids_of.items():
        label = add_part(document, part)
        for number, place in enumerate(places[code], 1):
            move = gp_Trsf()
            move.SetValues(*place.ravel().tolist())
            use = code if len(places[code]) == 1 else f"{code}-{number}"
            _name(tool.AddComponent(assembly, label, TopLoc_Location(move)), use)
    tool.UpdateAssemblies()
    return document_bytes(document, name, description)


def _name(label: TDF_Label, name: str) -> None:
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(name))


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class UsedPart:
    """Use of a part in an assembly that was read.

    Attributes:
        name: name of the use.
        transform: turning and shift from the part's frame to the car's, shape (3, 4), mm.
        bodies: number of its solids.
        faces: number of its faces.
        volume: volume, mm³; None of parts of many faces, as gears are, whose own files are measured.
    """

    name: str
    transform: Array
    bodies: int
    faces: int
    volume: float | None


def read_car(path: Path) -> tuple[UsedPart, ...]:
    """Read the uses of an assembly, in the order written, through the kernel's reader.

    Raises:
        FileError: the file cannot be read or is not one assembly.
    """
    document, uses = read_uses(path)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    found: list[UsedPart] = []
    measured: dict[str, tuple[int, int, float | None]] = {}
    for use in uses:
        label, name, entry = TDF_Label(), TDataStd_Name(), TCollection_AsciiString()
        XCAFDoc_ShapeTool.GetReferredShape_s(use, label)
        TDF_Tool.Entry_s(label, entry)
        key = entry.ToCString()
        if key not in measured:
            shape = tool.GetShape_s(label)
            count = len(faces(shape))
            measured[key] = len(solids(shape)), count, volume(completed(shape)) if count <= _FEW_FACES else None
        bodies, count, size = measured[key]
        move = XCAFDoc_ShapeTool.GetLocation_s(use).Transformation()
        found.append(
            UsedPart(
                name=name.Get().ToExtString() if use.FindAttribute(TDataStd_Name.GetID_s(), name) else "",
                transform=np.array([[move.Value(row, column) for column in range(1, 5)] for row in range(1, 4)]),
                bodies=bodies,
                faces=count,
                volume=size,
            )
        )
    return tuple(found)
