"""The cam as a solid: the disc in one prism, or with chamfers on its rim, and its hub."""

from OCP.BRepAlgoAPI import BRepAlgoAPI_BooleanOperation, BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.collections import List_TopoDS_Shape
from OCP.TopoDS import TopoDS_Shape

from cadgen.curves.closed import ClosedCurve
from cadgen.curves.contour import Contour, circle
from cadgen.curves.inset import chamfer_strips
from cadgen.curves.spline import Degree, splines
from cadgen.errors import FileError
from cadgen.geometry.solids.chamfered import chamfered_disc
from cadgen.geometry.solids.crossing import with_exact_crossings
from cadgen.geometry.solids.kernel import Edge, Part, contour_edges, drill, is_valid, prism, solids, spline_edges
from cadgen.parts.blank import PROFILE_STEP, Blank, Boss

# Greatest distance of the splines from the profile, mm: a fiftieth of the error allowed to the lift in a STEP file.
# On a disc of 65 mm radius it moves the volume by 3e-7 of itself at most.
SPLINE_TOLERANCE = 1e-5
_DEGREE: Degree = 5  # fewer control points than degree 3 at this tolerance, and continuous third derivatives
_COLOUR = (0.55, 0.62, 0.70)  # of milled aluminium


def cam_part(profile: ClosedCurve, blank: Blank, thickness: float, *, name: str, description: str) -> Part:
    """Return the disc with its bore, holes and hub; z = 0 is the inner face, z = thickness the outer one.

    Args:
        profile: profile of the rim, mm.
        blank: features of the disc besides its profile.
        thickness: thickness of the disc, mm.
        name: name of the product.
        description: description of the product, one line.

    Raises:
        DesignError: a hole cuts into another one, into the hub or through the profile.
        CheckError: the chamfers of broken edges meet, or run out at a ridge.
        FileError: the kernel did not make one valid solid.
    """
    blank.require_walls(profile.outline(PROFILE_STEP))
    holes = [contour_edges(contour, 0.0) for contour in blank.holes()]
    bore, boss = blank.bore(), blank.boss(thickness)
    if boss is None:
        shape = _disc(profile, [contour_edges(bore, 0.0), *holes], thickness, blank.edge_break)
    else:
        shape = _with_hub(_disc(profile, holes, thickness, blank.edge_break), boss, bore)
    bodies = solids(shape)
    if len(bodies) != 1 or not is_valid(bodies[0]):
        raise FileError(
            f"the CAD kernel made {len(bodies)} solids of the cam, or an invalid one, where one valid solid "
            "was wanted: check the profile and the design's [blank]"
        )
    return Part(solid=bodies[0], name=name, description=description, colour=_COLOUR)


def _disc(profile: ClosedCurve, holes: list[list[Edge]], thickness: float, edge_break: float) -> TopoDS_Shape:
    if edge_break:
        return chamfered_disc(
            chamfer_strips(profile, edge_break), holes, thickness, edge_break, tolerance=SPLINE_TOLERANCE
        )
    return prism(spline_edges(splines(profile, SPLINE_TOLERANCE, _DEGREE), 0.0), holes, thickness)


def _with_hub(disc: TopoDS_Shape, boss: Boss, bore: Contour) -> TopoDS_Shape:
    """Set the hub on a disc without bore, then cut bore and set screw through both."""
    hub = prism(contour_edges(circle((0.0, 0.0), boss.diameter / 2), boss.low), (), boss.high - boss.low)
    tools = [prism(contour_edges(bore, boss.bottom), (), boss.top - boss.bottom)]
    if boss.drill:
        tools.append(drill(boss.drill))
    return with_exact_crossings(_boolean(BRepAlgoAPI_Cut(), _boolean(BRepAlgoAPI_Fuse(), disc, [hub]), tools))


def _boolean(operation: BRepAlgoAPI_BooleanOperation, shape: TopoDS_Shape, tools: list[TopoDS_Shape]) -> TopoDS_Shape:
    arguments, others = List_TopoDS_Shape(), List_TopoDS_Shape()
    arguments.Append(shape)
    for tool in tools:
        others.Append(tool)
    operation.SetArguments(arguments)
    operation.SetTools(others)
    operation.Build()
    if not operation.IsDone():
        raise FileError("the CAD kernel cannot join the hub to the disc: change the design's [blank.hub]")
    return operation.Shape()
