"""Gears as solids, face by face from the exact outlines.

No tooth space is ever cut out: each outline becomes one wire of shared vertices, each wall one prism of that
wire, each cap one planar face on the wires of the prisms that meet it. Nothing has to be intersected but the
wall of a hub with its set screw, so a gear of 150 teeth takes milliseconds.
"""

from __future__ import annotations

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.collections import Array1_gp_Pnt
from OCP.Geom import Geom_BezierCurve, Geom_Circle, Geom_Line, Geom_Plane
from OCP.gp import gp_Ax2, gp_Ax3, gp_Dir, gp_Pnt, gp_Vec
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape, TopoDS_Shell, TopoDS_Solid

from cadgen.errors import FileError
from cadgen.gears.bezier import bezier_poles
from cadgen.geometry.solids.crossing import with_exact_crossings
from cadgen.geometry.solids.kernel import TOLERANCE, Edge, closed_wire, drill, faces
from cadgen.parts.body import Body, Cap, RadialHole, Wall, caps_of, walls_of
from cadgen.parts.loop import Arc, Curve, Involute, Line, Loop, Points

# Fit of the tooth curves, in mm: half of the 0.001 µm and 0.01 µm that flank and root are allowed.
FLANK_TOLERANCE = 0.5e-6
ROOT_TOLERANCE = 5e-6
# Poles are rounded to this many decimals of a mm, 5e-6 µm: far below the fit, and it keeps noise digits out
# of a STEP file.
DECIMALS = 8
UP = gp_Dir(0.0, 0.0, 1.0)

Wires = dict[tuple[Loop, float], TopoDS_Shape]


def body_solid(body: Body) -> TopoDS_Solid:
    """Solid of `body`, its axis on z.

    Flanks and roots are Bézier curves within `FLANK_TOLERANCE` and `ROOT_TOLERANCE` of the exact ones;
    everything else is exact. Raises `DesignError` where outlines cross (`caps_of`) and `FileError` if the
    kernel cannot drill the set screw.
    """
    wires: Wires = {}
    sides = [(wall, _side(wall, wires)) for wall in walls_of(body)]
    hole, number = body.radial_hole, body.drilled
    drilled = []
    if hole and number is not None:
        slab = body.slabs[number]
        ends = [_cap(cap, wires) for cap in caps_of((slab,))]
        drilled = _drilled([side for wall, side in sides if wall.within(slab)], ends, hole)
        sides = [(wall, side) for wall, side in sides if not wall.within(slab)]
    walls = [face for _, side in sides for face in faces(side)]
    return _closed([*walls, *drilled, *(_cap(cap, wires) for cap in caps_of(body.slabs))])


def _side(wall: Wall, wires: Wires) -> TopoDS_Shape:
    """The faces of a wall as a shell facing out of the material; its two wires go into `wires`."""
    base = wires.get((wall.outline, wall.start)) or closed_wire(_edges(wall.outline, wall.start))
    prism = BRepPrimAPI_MakePrism(base, gp_Vec(0.0, 0.0, wall.end - wall.start))
    wires[wall.outline, wall.start] = base
    wires[wall.outline, wall.end] = prism.LastShape()
    # The kernel turns the faces of a counter-clockwise wire inwards.
    return prism.Shape().Reversed() if wall.outward else prism.Shape()


def _edges(outline: Loop, height: float) -> list[Edge]:
    copies = [_copies(curve, outline.turns, height) for curve in outline.curves]
    return [edge for pitch in zip(*copies, strict=True) for edge in pitch]


def _copies(curve: Curve, turns: Points, height: float) -> list[Edge]:
    """The edges of `curve` turned by each of `turns`."""
    if isinstance(curve, Arc):
        return [_arc(curve.rotated(angle), height) for angle in np.angle(turns)]
    if isinstance(curve, Line):
        return [_line(start, end, height) for start, end in _turned(curve.point([0.0, 1.0]), turns)]
    tolerance = FLANK_TOLERANCE if isinstance(curve, Involute) else ROOT_TOLERANCE
    return [_bezier(poles, height) for poles in _turned(bezier_poles(curve, tolerance), turns)]


def _turned(points: Points, turns: Points) -> list[list[complex]]:
    return [list(row) for row in np.round(turns[:, None] * points, DECIMALS).tolist()]


def _bezier(poles: list[complex], height: float) -> Edge:
    array = Array1_gp_Pnt(1, len(poles))
    for number, pole in enumerate(poles, 1):
        array.SetValue(number, gp_Pnt(pole.real, pole.imag, height))
    return Edge(Geom_BezierCurve(array), 0.0, 1.0)


def _arc(arc: Arc, height: float) -> Edge:
    centre = gp_Pnt(arc.centre.real, arc.centre.imag, height)
    start = gp_Dir(np.cos(arc.start), np.sin(arc.start), 0.0)
    return Edge(Geom_Circle(gp_Ax2(centre, UP, start), arc.radius), 0.0, arc.sweep)


def _line(start: complex, end: complex, height: float) -> Edge:
    along = end - start
    line = Geom_Line(gp_Pnt(start.real, start.imag, height), gp_Dir(along.real, along.imag, 0.0))
    return Edge(line, 0.0, abs(along))


def _cap(cap: Cap, wires: Wires) -> TopoDS_Shape:
    """The planar face of a cap on the wires of the walls it meets."""
    builder, face = BRep_Builder(), TopoDS_Face()
    builder.MakeFace(face, Geom_Plane(gp_Ax3(gp_Pnt(0.0, 0.0, cap.height), UP)), TOLERANCE)
    builder.Add(face, wires[cap.outer, cap.height])
    for hole in cap.inner:
        builder.Add(face, wires[hole, cap.height].Reversed())
    return face if cap.up else face.Reversed()


def _closed(faces: list[TopoDS_Shape]) -> TopoDS_Solid:
    builder, shell, solid = BRep_Builder(), TopoDS_Shell(), TopoDS_Solid()
    builder.MakeShell(shell)
    for face in faces:
        builder.Add(shell, face)
    shell.Closed(True)
    builder.MakeSolid(solid)
    builder.Add(solid, shell)
    return solid


def _drilled(sides: list[TopoDS_Shape], ends: list[TopoDS_Shape], hole: RadialHole) -> list[TopoDS_Shape]:
    """The faces of one slab's walls after drilling.

    Only this slab, closed by its two end faces for the time of the cut, meets the drill: cutting the whole gear
    would take ten times longer. The end faces' edges stay as they are, so the result fits its neighbours.
    """
    slab = _closed([face for side in sides for face in faces(side)] + ends)
    cut = BRepAlgoAPI_Cut(slab, drill(hole))
    if not cut.IsDone():
        raise FileError(f"the kernel cannot drill the set screw of {hole.diameter:g} mm; change its diameter")
    return [face for face in faces(with_exact_crossings(cut.Shape())) if not any(face.IsSame(end) for end in ends)]
