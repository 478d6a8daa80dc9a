"""The disc of a cam as a solid: in one prism, or with both edges of its rim broken, and with its hub.

A rim with broken edges is laid face to face, without boolean and sewing: a chamfer consists of ruled faces between the
outline and the curve inside it, on common knots. Why not the kernel's own chamfer: docs/decisions/0007-broken-edges.md.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.collections import Array1_gp_Pnt, Array2_gp_Pnt
from OCP.Geom import (
    Geom_BSplineCurve,
    Geom_BSplineSurface,
    Geom_Curve,
    Geom_Line,
    Geom_Surface,
    Geom_SurfaceOfLinearExtrusion,
)
from OCP.Geom2d import Geom2d_Line
from OCP.gp import gp_Dir, gp_Dir2d, gp_Pln, gp_Pnt, gp_Pnt2d, gp_Vec
from OCP.TopAbs import TopAbs_FORWARD, TopAbs_REVERSED
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import (
    TopoDS,
    TopoDS_Edge,
    TopoDS_Face,
    TopoDS_Shape,
    TopoDS_Solid,
    TopoDS_Vertex,
    TopoDS_Wire,
)

from cadgen.curves.chamfer import Strip, chamfer_strips
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.contour import Contour, circle
from cadgen.curves.spline import Degree, SplineArc, ruled_splines, splines
from cadgen.errors import FileError
from cadgen.geometry.solids.crossing import with_exact_crossings
from cadgen.geometry.solids.kernel import (
    TOLERANCE,
    CurveEdge,
    SolidPart,
    boolean,
    closed_wire,
    contour_edges,
    drill,
    edge_between,
    faces,
    filled,
    is_valid,
    knots_of,
    prism,
    solid_of,
    solids,
    spline_edges,
    wire_of,
)
from cadgen.messages import Message
from cadgen.parts.blank import PROFILE_STEP, Blank, Boss

_UP = gp_Dir(0.0, 0.0, 1.0)
_BUILDER = BRep_Builder()


class _Level(NamedTuple):
    """The arcs of one height with the vertex where each begins, and its edge; none where the arc is a point."""

    z: float
    arcs: list[SplineArc]
    vertices: list[TopoDS_Vertex]
    edges: list[TopoDS_Edge | None]

    @classmethod
    def of(cls, arcs: Sequence[SplineArc], z: float) -> "_Level":
        """Build vertices and edges; the last arc must not be a point."""
        vertices: list[TopoDS_Vertex] = []
        for before, arc in zip([arcs[-1], *arcs], arcs, strict=False):
            if vertices and _is_point(before):
                vertices.append(vertices[-1])
                continue
            vertex = TopoDS_Vertex()
            _BUILDER.MakeVertex(vertex, _start_point(arc, z), TOLERANCE)
            vertices.append(vertex)
        edges = [
            None if _is_point(arc) else edge_between(curve, start, end)
            for arc, curve, start, end in zip(
                arcs, spline_edges(arcs, z), vertices, vertices[1:] + vertices[:1], strict=True
            )
        ]
        return cls(z, list(arcs), vertices, edges)

    def cap(self) -> BRepBuilderAPI_MakeFace:
        """The plane face within the edges, which run counterclockwise."""
        wire = wire_of(edge for edge in self.edges if edge is not None)
        return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0.0, 0.0, self.z), _UP), wire, True)


def chamfered_disc(
    strips: Sequence[Strip],
    holes: Iterable[Sequence[CurveEdge]],
    thickness: float,
    leg: float,
    *,
    tolerance: float,
) -> TopoDS_Solid:
    """Return a disc from z = 0 to z = thickness with both edges of its rim broken at 45 degrees.

    Args:
        strips: strips of the chamfer, from `cadgen.curves.chamfer.chamfer_strips`.
        holes: closed chains at z = 0 inside what the chamfers leave of the faces, counterclockwise.
        thickness: thickness of the disc, mm; more than two legs.
        leg: leg of the chamfers, mm.
        tolerance: greatest distance of the splines from the outline and from the curve inside it, mm.
    """
    pairs = ruled_splines(strips, tolerance, 5)
    # The last arc is an edge at every height, so that vertices may be passed on from the first one.
    last = max(k for k, pair in enumerate(pairs) if not any(_is_point(arc) for arc in pair))
    pairs = pairs[last + 1 :] + pairs[: last + 1]
    outer, inner = ([pair[side] for pair in pairs] for side in (0, 1))
    levels = [
        _Level.of(arcs, z) for arcs, z in ((inner, 0.0), (outer, leg), (outer, thickness - leg), (inner, thickness))
    ]
    bottom, top = levels[0].cap(), levels[-1].cap()
    around: list[TopoDS_Shape] = [face for low, high in pairwise(levels) for face in _wall(low, high)]
    for edges in holes:
        wire = closed_wire(edges)
        prism = BRepPrimAPI_MakePrism(wire, gp_Vec(0.0, 0.0, thickness))
        around += faces(prism.Shape())
        bottom.Add(TopoDS.Wire(wire.Reversed()))
        top.Add(TopoDS.Wire(prism.LastShape().Reversed()))
    return solid_of([*around, bottom.Face().Reversed(), top.Face()])


def _wall(low: _Level, high: _Level) -> list[TopoDS_Face]:
    """The faces between two heights: vertical where both have the same arcs, ruled elsewhere."""
    same = all(a is b for a, b in zip(low.arcs, high.arcs, strict=True))
    height = high.z - low.z if same else 1.0
    count = len(low.arcs)
    sides: list[TopoDS_Edge] = []
    for k in range(count):
        if k and low.vertices[k].IsSame(low.vertices[k - 1]) and high.vertices[k].IsSame(high.vertices[k - 1]):
            sides.append(sides[-1])
            continue
        start, end = _start_point(low.arcs[k], low.z), _start_point(high.arcs[k], high.z)
        line: Geom_Curve = Geom_Line(start, _UP)
        if not same:
            line = Geom_BSplineCurve(filled(Array1_gp_Pnt, [start, end]), *knots_of(np.array([0.0, 0.0, 1.0, 1.0])), 1)
        sides.append(edge_between(CurveEdge(line, 0.0, height), low.vertices[k], high.vertices[k]))
    walls = []
    for k in range(count):
        edges = low.edges[k], high.edges[k]
        if edges == (None, None):
            continue
        if same:
            (curve,) = spline_edges([low.arcs[k]], low.z)
            surface: Geom_Surface = Geom_SurfaceOfLinearExtrusion(curve.curve, _UP)
        else:
            surface = _ruled(low.arcs[k], low.z, high.arcs[k], high.z)
        u = float(low.arcs[k].knots[0]), float(low.arcs[k].knots[-1])
        face = TopoDS_Face()
        _BUILDER.MakeFace(face, surface, TOLERANCE)
        wire = TopoDS_Wire()
        _BUILDER.MakeWire(wire)
        after = (k + 1) % count
        for edge, begin, way, backwards in (
            (edges[0] or _pole(low.vertices[k], u), (0.0, 0.0), (1.0, 0.0), False),
            (sides[after], (u[1], 0.0), (0.0, 1.0), False),
            (edges[1] or _pole(high.vertices[k], u), (0.0, height), (1.0, 0.0), True),
            (sides[k], (u[0], 0.0), (0.0, 1.0), True),
        ):
            line2d = Geom2d_Line(gp_Pnt2d(*begin), gp_Dir2d(*way))
            _BUILDER.UpdateEdge(edge, line2d, surface, TopLoc_Location(), TOLERANCE)
            _BUILDER.Add(wire, edge.Oriented(TopAbs_REVERSED if backwards else TopAbs_FORWARD))
        wire.Closed(True)
        _BUILDER.Add(face, wire)
        walls.append(face)
    return walls


def _pole(vertex: TopoDS_Vertex, ends: tuple[float, float]) -> TopoDS_Edge:
    """The edge without length by which a face that comes to a point is closed in its parameters."""
    edge = TopoDS_Edge()
    _BUILDER.MakeEdge(edge)
    _BUILDER.Add(edge, vertex.Oriented(TopAbs_FORWARD))
    _BUILDER.Add(edge, vertex.Oriented(TopAbs_REVERSED))
    _BUILDER.Degenerated(edge, True)
    _BUILDER.Range(edge, *ends)
    return edge


def _ruled(low: SplineArc, low_z: float, high: SplineArc, high_z: float) -> Geom_BSplineSurface:
    """Straight lines between two splines on the same knots, 0 to 1 across."""
    poles = Array2_gp_Pnt(1, len(low.control_points), 1, 2)
    for column, (arc, z) in enumerate(((low, low_z), (high, high_z)), 1):
        for number, (x, y) in enumerate(arc.control_points.tolist(), 1):
            poles.SetValue(number, column, gp_Pnt(x, y, z))
    across = knots_of(np.array([0.0, 0.0, 1.0, 1.0]))
    knots, counts = knots_of(low.knots)
    return Geom_BSplineSurface(poles, knots, across[0], counts, across[1], low.degree, 1)


def _is_point(arc: SplineArc) -> bool:
    return bool((arc.control_points == arc.control_points[0]).all())


def _start_point(arc: SplineArc, z: float) -> gp_Pnt:
    x, y = arc.control_points[0].tolist()
    return gp_Pnt(x, y, z)


# Greatest distance of the splines from the profile, mm: a fiftieth of the error allowed to the lift in a STEP file.
# On a disc of 65 mm radius it moves the volume by 3e-7 of itself at most.
SPLINE_TOLERANCE = 1e-5
_DEGREE: Degree = 5  # fewer control points than degree 3 at this tolerance, and continuous third derivatives
_COLOUR = (0.55, 0.62, 0.70)  # of milled aluminium
_UNJOINED = Message("the CAD kernel cannot join the hub to the disc: change the design's [blank.hub]")


def cam_part(profile: ClosedCurve, blank: Blank, thickness: float, *, name: str, description: str) -> SolidPart:
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
    return _one_part(shape, name, description)


def grooved_part(
    flanks: tuple[ClosedCurve, ClosedCurve],
    blank: Blank,
    thickness: float,
    depth: float,
    outside_radius: float,
    *,
    name: str,
    description: str,
) -> SolidPart:
    """Return a round disc with a groove in the face at z = thickness, with its bore, holes and hub.

    Args:
        flanks: inner and outer flank of the groove, mm.
        blank: features of the disc besides the groove.
        thickness: thickness of the disc, mm.
        depth: depth of the groove, mm.
        outside_radius: radius of the disc, mm.
        name: name of the product.
        description: description of the product, one line.

    Raises:
        DesignError: a hole cuts into another one, into the hub or into the groove.
        FileError: the kernel did not make one valid solid.
    """
    inner, outer = flanks
    blank.require_walls(inner.outline(PROFILE_STEP))
    holes = [contour_edges(contour, 0.0) for contour in blank.holes()]
    bore, boss = blank.bore(), blank.boss(thickness)
    around = holes if boss else [contour_edges(bore, 0.0), *holes]
    disc = prism(contour_edges(circle((0.0, 0.0), outside_radius), 0.0), around, thickness)
    floor = thickness - depth
    # The ring ends in the plane of the face, so that its own edges become those of the groove.
    edges = [spline_edges(splines(flank, SPLINE_TOLERANCE, _DEGREE), floor) for flank in (outer, inner)]
    shape = boolean(BRepAlgoAPI_Cut(), disc, [prism(edges[0], [edges[1]], depth)], _UNJOINED)
    if boss is not None:
        shape = _with_hub(shape, boss, bore)
    return _one_part(shape, name, description)


def _one_part(shape: TopoDS_Shape, name: str, description: str) -> SolidPart:
    """Part of a shape that must be one valid solid."""
    bodies = solids(shape)
    if len(bodies) != 1 or not is_valid(bodies[0]):
        raise FileError(
            "the CAD kernel made {bodies} solids of the cam, or an invalid one, where one valid solid was "
            "wanted: check the profile and the design's [blank]",
            bodies=len(bodies),
        )
    return SolidPart(solid=bodies[0], name=name, description=description, colour=_COLOUR)


def _disc(profile: ClosedCurve, holes: list[list[CurveEdge]], thickness: float, edge_break: float) -> TopoDS_Shape:
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
    return with_exact_crossings(
        boolean(BRepAlgoAPI_Cut(), boolean(BRepAlgoAPI_Fuse(), disc, [hub], _UNJOINED), tools, _UNJOINED)
    )
