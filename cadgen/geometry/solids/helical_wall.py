"""Walls of helical teeth: faces laid directly on the kernel, without sweep, loft or boolean.

A helicoid is no rational surface, but it is nearly a polynomial along z. S(u, v) = P(u)·exp(iφv), where P is a Bézier
curve of the transverse section and φ the turning over the height. exp(iφv) is interpolated at Chebyshev-Lobatto nodes,
so that its ends are exact, and the product is a Bézier patch. Lands on tip and root circles are exact cylinders. Their
edges in space are those of the patches beside them, which must keep to the kernel's own 1e-7 mm: that sets the degree
along z, and not the far greater error that flanks may have. A double helix is two such walls that share their edges at
the apex.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.collections import Array1_gp_Pnt, Array1_gp_Pnt2d, Array2_gp_Pnt
from OCP.Geom import (
    Geom_BezierCurve,
    Geom_BezierSurface,
    Geom_Circle,
    Geom_Curve,
    Geom_CylindricalSurface,
    Geom_Surface,
)
from OCP.Geom2d import Geom2d_BezierCurve, Geom2d_Curve, Geom2d_Line
from OCP.gp import gp_Ax2, gp_Ax3, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d
from OCP.TopAbs import TopAbs_FORWARD, TopAbs_REVERSED
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shape, TopoDS_Vertex, TopoDS_Wire

from cadgen.arrays import Array
from cadgen.geometry.solids.kernel import TOLERANCE, CurveEdge, edge_between, filled, wire_of
from cadgen.parts.body import SweptWall
from cadgen.parts.loop import Arc, Curve, Involute, Points, Segment, bernstein, bezier_poles

# Greatest distance of a helix from its polynomial, mm: half of the kernel's smallest distance.
HELIX_TOLERANCE = 5e-8
# Share of what roots may err that an arc may.
ARC_SHARE = 0.02
LOWEST_DEGREE, HIGHEST_DEGREE = 3, 20
SAMPLES = np.linspace(0.0, 1.0, 101)
_BUILDER = BRep_Builder()
_UP = gp_Dir(0.0, 0.0, 1.0)
_ALONG_U = gp_Dir2d(1.0, 0.0)
_ALONG_V = gp_Dir2d(0.0, 1.0)


class Helicoid(NamedTuple):
    """Faces of a wall, and its wires at the lower and at the upper end, which run counterclockwise."""

    faces: list[TopoDS_Shape]
    low: TopoDS_Wire
    high: TopoDS_Wire


def turning_poles(angle: float, radius: float) -> Points:
    """Poles along z of exp(i·angle·v) within `HELIX_TOLERANCE` at a radius, shape (degree + 1,).

    Args:
        angle: turning over the height, rad.
        radius: greatest distance from the axis, mm.
    """
    exact = np.exp(1j * angle * SAMPLES)
    for degree in range(LOWEST_DEGREE, HIGHEST_DEGREE + 1):
        nodes = (1 - np.cos(np.pi * np.arange(degree + 1) / degree)) / 2
        poles = np.linalg.solve(bernstein(degree, nodes), np.exp(1j * angle * nodes))
        if float(np.abs(bernstein(degree, SAMPLES) @ poles - exact).max()) * radius <= HELIX_TOLERANCE:
            break
    return np.asarray(poles)


def section_poles(curve: Curve, flank: float, root: float) -> Points | None:
    """Poles of a curve of the section; None for an arc about the axis, which makes an exact cylinder.

    Args:
        curve: curve of the section, mm.
        flank: greatest distance from an involute, mm.
        root: greatest distance from any other curve, mm.
    """
    if isinstance(curve, Arc) and curve.centre == 0:
        return None
    if isinstance(curve, Segment):
        return curve.point([0.0, 1.0])
    if isinstance(curve, Arc):  # errs to one side all along, so that the volume would be off
        return bezier_poles(curve, root * ARC_SHARE)
    return bezier_poles(curve, flank if isinstance(curve, Involute) else root)


def helical_wall(wall: SweptWall, flank: float, root: float, decimals: int) -> Helicoid:
    """Faces of a wall whose section turns, facing out of the material.

    Args:
        wall: wall, its outline as it is at its lower end.
        flank: greatest distance of flanks from the exact ones, mm.
        root: greatest distance of other curves from the exact ones, mm.
        decimals: decimals of a mm to which poles are rounded.
    """
    outline = wall.outline
    sections = [section_poles(curve, flank, root) for curve in outline.curves]
    ends = [complex(curve.point(1.0)) for curve in outline.curves]
    reach = max(outline.radii[1], max(map(abs, ends)))
    faces: list[TopoDS_Shape] = []
    rings: list[list[TopoDS_Edge]] = []
    below: _Ring | None = None
    for low, high in outline.run.pieces(wall.end - wall.start):
        first, last = outline.run.angle(low), outline.run.angle(high)
        along = np.exp(1j * first) * turning_poles(last - first, reach)
        piece = _Piece(
            turns=outline.turns,
            along=along,
            heights=np.round(wall.start + np.linspace(low, high, len(along)), decimals),
            turning=last - first,
            decimals=decimals,
        )
        below = piece.ring(outline.curves, sections, ends, 0) if below is None else below
        above = piece.ring(outline.curves, sections, ends, -1)
        faces += piece.faces(outline.curves, sections, ends, below, above)
        rings = rings or [below.in_order]
        below = above
    assert below is not None
    wires = wire_of(rings[0]), wire_of(below.in_order)
    turned = faces if wall.outward else [face.Reversed() for face in faces]
    return Helicoid(turned, *wires)


class _Ring(NamedTuple):
    """Vertices and edges of the outline at one height, by curve and tooth."""

    vertices: list[list[TopoDS_Vertex]]
    edges: list[list[TopoDS_Edge]]
    poles: list[Points | None]
    joints: list[Points]

    @property
    def in_order(self) -> list[TopoDS_Edge]:
        """Edges, counterclockwise."""
        return [edge for pitch in zip(*self.edges, strict=True) for edge in pitch]


class _Piece(NamedTuple):
    """A stretch of a wall that turns evenly.

    Attributes:
        turns: turnings of the teeth, exp(i·angle), shape (teeth,).
        along: poles along z of the turning, shape (degree + 1,).
        heights: their heights, mm.
        turning: turning over the stretch, rad.
        decimals: decimals of a mm to which poles are rounded.
    """

    turns: Points
    along: Points
    heights: Array
    turning: float
    decimals: int

    def _placed(self, points: Points, along: Points) -> Points:
        """Points of the section on all teeth at poles along z, shape (teeth, points, poles), rounded."""
        return np.asarray(np.round(self.turns[:, None, None] * points[:, None] * along, self.decimals))

    def ring(
        self, curves: Sequence[Curve], sections: Sequence[Points | None], ends: Sequence[complex], end: int
    ) -> _Ring:
        """Vertices and edges at the lower end, 0, or at the upper one, -1."""
        turn, height = self.along[[end]], float(self.heights[end])
        joints = [self._placed(np.array([point]), turn)[:, 0, 0] for point in ends]
        vertices: list[list[TopoDS_Vertex]] = []
        for each in joints:
            vertices.append([TopoDS_Vertex() for _ in each])
            for vertex, point in zip(vertices[-1], each.tolist(), strict=True):
                _BUILDER.MakeVertex(vertex, gp_Pnt(point.real, point.imag, height), TOLERANCE)
        edges, poles = [], list[Points | None]()
        for number, (curve, section) in enumerate(zip(curves, sections, strict=True)):
            before = vertices[number - 1] if number else vertices[-1][-1:] + vertices[-1][:-1]
            start = joints[number - 1] if number else np.roll(joints[-1], 1)
            if section is None:
                assert isinstance(curve, Arc)
                poles.append(None)
                circles = [
                    Geom_Circle(gp_Ax2(gp_Pnt(0.0, 0.0, height), _UP, gp_Dir(at.real, at.imag, 0.0)), curve.radius)
                    for at in start.tolist()
                ]
                made = [CurveEdge(circle, 0.0, curve.sweep) for circle in circles]
            else:
                rows = self._placed(section, turn)[:, :, 0]
                rows[:, 0], rows[:, -1] = start, joints[number]
                poles.append(rows)
                made = [_bezier(row, [height] * len(row)) for row in rows.tolist()]
            edges.append(list(map(edge_between, made, before, vertices[number])))
        return _Ring(vertices, edges, poles, joints)

    def faces(
        self,
        curves: Sequence[Curve],
        sections: Sequence[Points | None],
        ends: Sequence[complex],
        low: _Ring,
        high: _Ring,
    ) -> list[TopoDS_Shape]:
        """Faces between two rings, facing outwards."""
        joints = []
        for number, point in enumerate(ends):
            rows = self._placed(np.array([point]), self.along)[:, 0]
            rows[:, 0], rows[:, -1] = low.joints[number], high.joints[number]
            joints.append(rows)
        heights = self.heights.tolist()
        helices = [
            [
                edge_between(_bezier(row, heights), start, end)
                for row, start, end in zip(rows.tolist(), low.vertices[number], high.vertices[number], strict=True)
            ]
            for number, rows in enumerate(joints)
        ]
        made: list[TopoDS_Shape] = []
        for number, (curve, section) in enumerate(zip(curves, sections, strict=True)):
            before = helices[number - 1] if number else helices[-1][-1:] + helices[-1][:-1]
            around = list(zip(low.edges[number], helices[number], high.edges[number], before, strict=True))
            if section is None:
                assert isinstance(curve, Arc)
                starts = joints[number - 1] if number else np.roll(joints[-1], 1, axis=0)
                made += [
                    self._cylinder(curve, complex(start), edges)
                    for start, edges in zip(starts[:, 0], around, strict=True)
                ]
                continue
            grid = self._placed(section, self.along)
            grid[:, 0] = joints[number - 1] if number else np.roll(joints[-1], 1, axis=0)
            grid[:, -1] = joints[number]
            grid[:, :, 0], grid[:, :, -1] = low.poles[number], high.poles[number]
            made += [self._patch(poles, edges) for poles, edges in zip(grid.tolist(), around, strict=True)]
        return made

    def _patch(self, poles: list[list[complex]], edges: tuple[TopoDS_Edge, ...]) -> TopoDS_Shape:
        array, heights = Array2_gp_Pnt(1, len(poles), 1, len(self.heights)), self.heights.tolist()
        for i, row in enumerate(poles, 1):
            for k, (pole, height) in enumerate(zip(row, heights, strict=True), 1):
                array.SetValue(i, k, gp_Pnt(pole.real, pole.imag, height))
        sides = (
            Geom2d_Line(gp_Pnt2d(0.0, 0.0), _ALONG_U),
            Geom2d_Line(gp_Pnt2d(1.0, 0.0), _ALONG_V),
            Geom2d_Line(gp_Pnt2d(0.0, 1.0), _ALONG_U),
            Geom2d_Line(gp_Pnt2d(0.0, 0.0), _ALONG_V),
        )
        return _face(Geom_BezierSurface(array), edges, sides)

    def _cylinder(self, arc: Arc, start: complex, edges: tuple[TopoDS_Edge, ...]) -> TopoDS_Shape:
        low, high = float(self.heights[0]), float(self.heights[-1])
        axes = gp_Ax3(gp_Pnt(0.0, 0.0, 0.0), _UP, gp_Dir(start.real, start.imag, 0.0))
        sides = (
            Geom2d_Line(gp_Pnt2d(0.0, low), _ALONG_U),
            _line((arc.sweep, low), (arc.sweep + self.turning, high)),
            Geom2d_Line(gp_Pnt2d(self.turning, high), _ALONG_U),
            _line((0.0, low), (self.turning, high)),
        )
        return _face(Geom_CylindricalSurface(axes, arc.radius), edges, sides)


def _face(surface: Geom_Surface, edges: tuple[TopoDS_Edge, ...], sides: tuple[Geom2d_Curve, ...]) -> TopoDS_Shape:
    """Face within four edges: below, at the end, above and at the start, with their curves in its parameters."""
    face, wire = TopoDS_Face(), TopoDS_Wire()
    _BUILDER.MakeFace(face, surface, TOLERANCE)
    nowhere = TopLoc_Location()
    for edge, side in zip(edges, sides, strict=True):
        _BUILDER.UpdateEdge(edge, side, surface, nowhere, TOLERANCE)
    _BUILDER.MakeWire(wire)
    for edge, way in zip(edges, (TopAbs_FORWARD, TopAbs_FORWARD, TopAbs_REVERSED, TopAbs_REVERSED), strict=True):
        _BUILDER.Add(wire, edge.Oriented(way))
    wire.Closed(True)
    _BUILDER.Add(face, wire)
    return face


def _bezier(row: Sequence[complex], heights: Sequence[float]) -> CurveEdge:
    points = [gp_Pnt(pole.real, pole.imag, height) for pole, height in zip(row, heights, strict=True)]
    curve: Geom_Curve = Geom_BezierCurve(filled(Array1_gp_Pnt, points))
    return CurveEdge(curve, 0.0, 1.0)


def _line(start: tuple[float, float], end: tuple[float, float]) -> Geom2d_BezierCurve:
    return Geom2d_BezierCurve(filled(Array1_gp_Pnt2d, [gp_Pnt2d(*start), gp_Pnt2d(*end)]))
