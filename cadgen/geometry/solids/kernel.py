"""Thin helpers on the CAD kernel: edges, wires, prisms, validity and volume.

The kernel is OCCT through OCP, the binding that build123d stands on. OCP loads in a quarter of the time that
build123d takes, so build123d itself is loaded only when a part is asked for in its terms (`SolidPart.build123d`).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import numpy as np
from OCP.BOPAlgo import BOPAlgo_ArgumentAnalyzer
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_BooleanOperation
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakePrism
from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int, List_TopoDS_Shape
from OCP.Geom import Geom_BSplineCurve, Geom_Circle, Geom_Curve, Geom_Line
from OCP.gp import gp_Ax2, gp_Dir, gp_Pln, gp_Pnt, gp_Vec
from OCP.GProp import GProp_GProps
from OCP.ShapeAnalysis import ShapeAnalysis_ShapeTolerance
from OCP.TopAbs import TopAbs_FACE, TopAbs_FORWARD, TopAbs_REVERSED, TopAbs_ShapeEnum, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Shape, TopoDS_Shell, TopoDS_Solid, TopoDS_Vertex, TopoDS_Wire

from cadgen.arrays import Array
from cadgen.curves.contour import Contour
from cadgen.curves.spline import SplineArc
from cadgen.errors import FileError
from cadgen.parts.body import RadialHole

if TYPE_CHECKING:
    from build123d import Solid as Solid

A = TypeVar("A", bound=Any)

# The kernel's own smallest distance between two points (Precision::Confusion), mm.
TOLERANCE = 1e-7
# Relative, for the kernel's adaptive Gauss-Kronrod rule, which agrees with Green's theorem to 1e-10. The
# other rules are up to 2e-3 off on a face whose edges are splines of many spans.
_VOLUME_TOLERANCE = 1e-9


@dataclass(frozen=True, kw_only=True, slots=True)
class SolidPart:
    """A solid with its name, description and colour in a file.

    Attributes:
        solid: the kernel's solid, mm.
        name: name of the product.
        description: description of the product, one line.
        colour: red, green, blue in sRGB, 0 to 1.
    """

    solid: TopoDS_Solid
    name: str
    description: str
    colour: tuple[float, float, float]

    def build123d(self) -> "Solid":
        """Return the part as a build123d solid with its label and colour."""
        import build123d

        return build123d.Solid(self.solid, label=self.name, color=build123d.Color(*self.colour))


class CurveEdge(NamedTuple):
    """A curve of the kernel, with its first and last parameter."""

    curve: Geom_Curve
    first: float
    last: float


def spline_edges(arcs: Iterable[SplineArc], z: float) -> list[CurveEdge]:
    """Return B-spline edges in the plane at height z, mm.

    Args:
        arcs: splines, mm.
        z: height of the plane, mm.
    """
    edges = []
    for arc in arcs:
        poles = filled(Array1_gp_Pnt, [gp_Pnt(x, y, z) for x, y in arc.control_points.tolist()])
        curve = Geom_BSplineCurve(poles, *knots_of(arc.knots), arc.degree)
        edges.append(CurveEdge(curve, float(arc.knots[0]), float(arc.knots[-1])))
    return edges


def filled(kind: type[A], values: Sequence[object]) -> A:
    """Array of the kernel that holds values, counted from 1.

    Args:
        kind: type of the array.
        values: its values.
    """
    array: A = kind(1, len(values))
    for number, value in enumerate(values, 1):
        array.SetValue(number, value)
    return array


def knots_of(knots: Array) -> tuple[Array1_double, Array1_int]:
    """Different knots of a spline and how often each stands, as arrays of the kernel.

    Args:
        knots: knots of the spline, not decreasing: parameters, shape (n,).
    """
    values, counts = np.unique(knots, return_counts=True)
    return filled(Array1_double, values.tolist()), filled(Array1_int, counts.tolist())


def contour_edges(contour: Contour, z: float) -> list[CurveEdge]:
    """Return the lines and arcs of a contour in the plane at height z, mm; a circle is one edge.

    Args:
        contour: contour, mm.
        z: height of the plane, mm.
    """
    up = gp_Dir(0.0, 0.0, 1.0)
    if contour.is_circle:
        x, y = contour.centers[0].tolist()
        return [CurveEdge(Geom_Circle(gp_Ax2(gp_Pnt(x, y, z), up), float(contour.radii[0])), 0.0, 2 * np.pi)]
    edges = []
    for (x, y), (dx, dy), length, center, radius, sweep in zip(
        contour.vertices,
        contour.chords,
        contour.lengths,
        contour.centers,
        contour.radii,
        contour.sweeps,
        strict=True,
    ):
        if sweep == 0:
            edges.append(CurveEdge(Geom_Line(gp_Pnt(x, y, z), gp_Dir(dx, dy, 0.0)), 0.0, float(length)))
            continue
        axis, start = up if sweep > 0 else up.Reversed(), gp_Dir(x - center[0], y - center[1], 0.0)
        circle = Geom_Circle(gp_Ax2(gp_Pnt(*center, z), axis, start), float(radius))
        edges.append(CurveEdge(circle, 0.0, float(abs(sweep))))
    return edges


def closed_wire(edges: Sequence[CurveEdge]) -> TopoDS_Wire:
    """Join edges end to end into a loop; neighbours share one vertex, so nothing has to be sewn.

    Raises:
        FileError: an edge does not begin where the one before it ends.
    """
    builder, vertices = BRep_Builder(), []
    for before, edge in zip([edges[-1], *edges], edges, strict=False):
        start = edge.curve.Value(edge.first)
        gap = before.curve.Value(before.last).Distance(start)
        if gap > TOLERANCE:
            raise FileError(
                "an outline is open by {gap:.2g} mm at ({x:.3f}, {y:.3f}) mm, more than the CAD kernel's "
                "{tolerance:g} mm: close the curve before making a solid of it",
                gap=gap,
                x=start.X(),
                y=start.Y(),
                tolerance=TOLERANCE,
            )
        vertex = TopoDS_Vertex()
        builder.MakeVertex(vertex, start, TOLERANCE)
        vertices.append(vertex)
    return wire_of(map(edge_between, edges, vertices, vertices[1:] + vertices[:1]))


def edge_between(edge: CurveEdge, start: TopoDS_Vertex, end: TopoDS_Vertex) -> TopoDS_Edge:
    """Edge of the kernel on a curve, between two vertices."""
    builder, shape = BRep_Builder(), TopoDS_Edge()
    builder.MakeEdge(shape, edge.curve, TOLERANCE)
    builder.Add(shape, start.Oriented(TopAbs_FORWARD))
    builder.Add(shape, end.Oriented(TopAbs_REVERSED))
    builder.Range(shape, edge.first, edge.last)
    return shape


def wire_of(edges: Iterable[TopoDS_Edge]) -> TopoDS_Wire:
    """Closed wire of edges that follow each other."""
    builder, wire = BRep_Builder(), TopoDS_Wire()
    builder.MakeWire(wire)
    for edge in edges:
        builder.Add(wire, edge)
    wire.Closed(True)
    return wire


def solid_of(faces: Iterable[TopoDS_Shape]) -> TopoDS_Solid:
    """Solid within faces that enclose it and share their edges."""
    builder, shell, solid = BRep_Builder(), TopoDS_Shell(), TopoDS_Solid()
    builder.MakeShell(shell)
    for face in faces:
        builder.Add(shell, face)
    shell.Closed(True)
    builder.MakeSolid(solid)
    builder.Add(solid, shell)
    return solid


def prism(outer: Sequence[CurveEdge], inner: Iterable[Sequence[CurveEdge]], height: float) -> TopoDS_Shape:
    """Extrude one planar face along z by `height`, mm: no boolean, one face per edge.

    Args:
        outer: closed chain of edges in one horizontal plane, counterclockwise.
        inner: closed chains inside it, counterclockwise too.
        height: height of the prism, positive, mm.
    """
    z = outer[0].curve.Value(outer[0].first).Z()
    plane = gp_Pln(gp_Pnt(0.0, 0.0, z), gp_Dir(0.0, 0.0, 1.0))
    face = BRepBuilderAPI_MakeFace(plane, closed_wire(outer), True)
    for edges in inner:
        face.Add(TopoDS.Wire(closed_wire(edges).Reversed()))
    return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0.0, 0.0, height)).Shape()


def drill(hole: RadialHole) -> TopoDS_Shape:
    """Cylinder that a radial hole takes away, from the z axis outwards."""
    axis = gp_Ax2(gp_Pnt(0.0, 0.0, hole.height), gp_Dir(np.cos(hole.angle), np.sin(hole.angle), 0.0))
    return BRepPrimAPI_MakeCylinder(axis, hole.diameter / 2, hole.reach).Shape()


def boolean(
    operation: BRepAlgoAPI_BooleanOperation, shape: TopoDS_Shape, tools: Sequence[TopoDS_Shape], refusal: str
) -> TopoDS_Shape:
    """Join tools to a shape, or cut them out of it.

    Args:
        operation: operation of the kernel, not yet built.
        shape: shape.
        tools: further shapes.
        refusal: sentence where the kernel cannot do it.

    Raises:
        FileError: the kernel cannot do it.
    """
    arguments, others = List_TopoDS_Shape(), List_TopoDS_Shape()
    arguments.Append(shape)
    for tool in tools:
        others.Append(tool)
    operation.SetArguments(arguments)
    operation.SetTools(others)
    operation.Build()
    if not operation.IsDone():
        raise FileError(refusal)
    return operation.Shape()


def solids(shape: TopoDS_Shape) -> list[TopoDS_Solid]:
    """Return the solids in a shape."""
    return [TopoDS.Solid(part) for part in parts_of(shape, TopAbs_SOLID)]


def faces(shape: TopoDS_Shape) -> list[TopoDS_Shape]:
    """Return the faces of a shape."""
    return parts_of(shape, TopAbs_FACE)


def parts_of(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> list[TopoDS_Shape]:
    """Return the parts of a kind in a shape, such as its edges."""
    parts = []
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        parts.append(explorer.Current())
        explorer.Next()
    return parts


def is_valid(shape: TopoDS_Shape) -> bool:
    """Whether BRepCheck finds no fault in the shape."""
    return bool(BRepCheck_Analyzer(shape).IsValid())


def fits(shape: TopoDS_Shape) -> bool:
    """Whether edges and vertices meet within the kernel's own tolerance, to which no others need be raised."""
    greatest = ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1)
    return bool(greatest <= TOLERANCE)


def edges_on_surfaces(shape: TopoDS_Shape) -> bool:
    """Whether every edge lies within its tolerance on the surfaces that it bounds, which BRepCheck does not look at."""
    analyzer = BOPAlgo_ArgumentAnalyzer()
    analyzer.SetShape1(shape)
    for mode in ("ArgumentTypeMode", "SelfInterMode", "SmallEdgeMode", "RebuildFaceMode", "ContinuityMode"):
        setattr(analyzer, mode, False)
    analyzer.CurveOnSurfaceMode = True
    analyzer.Perform()
    return not analyzer.HasFaulty()


def volume(shape: TopoDS_Shape) -> float:
    """Return the volume, mm^3, by the kernel's adaptive Gauss-Kronrod rule."""
    properties = GProp_GProps()
    BRepGProp.VolumePropertiesGK_s(shape, properties, _VOLUME_TOLERANCE)
    return float(properties.Mass())
