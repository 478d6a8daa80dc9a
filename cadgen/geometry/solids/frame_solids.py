"""Parts of a frame as solids: sheets with their openings and edge holes, and the fork's block."""

from collections.abc import Iterable

from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape, TopoDS_Solid

from cadgen.car.assembly.frame import ForkBlock
from cadgen.car.assembly.panels import Panel
from cadgen.errors import FileError
from cadgen.geometry.solids.kernel import SolidPart, contour_edges, prism, solids

Point = tuple[float, float, float]
Colour = tuple[float, float, float]


def panel_part(panel: Panel, name: str, description: str, colour: Colour) -> SolidPart:
    """Sheet in its own frame, its lower face at z = 0.

    Args:
        panel: sheet.
        name: name of the product.
        description: description of the product.
        colour: red, green, blue in sRGB, 0 to 1.

    Raises:
        FileError: the kernel cannot drill it.
    """
    edges = [contour_edges(opening, 0.0) for opening in panel.openings]
    body = prism(contour_edges(panel.outline, 0.0), edges, panel.thickness)
    half = panel.thickness / 2
    tools = [_cylinder((e.u, e.v, half), (0.0, 1.0, 0.0), e.diameter, e.depth) for e in panel.edge_holes]
    return SolidPart(solid=_drilled(body, tools, name), name=name, description=description, colour=colour)


def block_part(block: ForkBlock, name: str, description: str, colour: Colour) -> SolidPart:
    """Fork's block in its own frame, the middle of its lower face at the origin.

    Args:
        block: block.
        name: name of the product.
        description: description of the product.
        colour: red, green, blue in sRGB, 0 to 1.

    Raises:
        FileError: the kernel cannot drill it.
    """
    low = gp_Pnt(-block.length / 2, -block.width / 2, 0.0)
    body = BRepPrimAPI_MakeBox(low, block.length, block.width, block.height).Shape()
    up, seat = (0.0, 0.0, 1.0), block.bearing
    tools = [_cylinder((0.0, 0.0, 0.0), up, block.bore, block.height)]
    tools += [_cylinder((0.0, 0.0, z), up, seat.diameter, seat.width) for z in (0.0, block.height - seat.width)]
    tools += [_cylinder((at, 0.0, 0.0), up, block.tap, block.depth) for at in block.threads]
    return SolidPart(solid=_drilled(body, tools, name), name=name, description=description, colour=colour)


def _cylinder(start: Point, way: Point, diameter: float, length: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(*start), gp_Dir(*way)), diameter / 2, length).Shape()


def _drilled(body: TopoDS_Shape, tools: Iterable[TopoDS_Shape], name: str) -> TopoDS_Solid:
    for tool in tools:
        body = BRepAlgoAPI_Cut(body, tool).Shape()
    found = solids(body)
    if len(found) != 1:
        raise FileError("the CAD kernel cannot drill {name}: report this design", name=name)
    return found[0]
