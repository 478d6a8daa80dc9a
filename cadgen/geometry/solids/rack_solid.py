"""A rack as a solid: its transverse section with exact fillets, swept straight along the teeth, its length on x."""

from __future__ import annotations

import itertools
from math import cos, pi, tan

from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.Geom import Geom_Circle, Geom_Ellipse, Geom_Line
from OCP.gp import gp_Ax2, gp_Dir, gp_Pln, gp_Pnt, gp_Vec
from OCP.TopoDS import TopoDS_Solid

from cadgen.gears.rack import RackForm
from cadgen.geometry.solids.kernel import CurveEdge, closed_wire, solids

_UP = gp_Dir(0.0, 0.0, 1.0)


def rack_solid(rack: RackForm) -> TopoDS_Solid:
    """Solid of a rack: its reference line on x at z = 0, its teeth towards y, its width upwards along z."""
    root, back = -rack.dedendum_factor * rack.normal_module, -rack.back_height
    around: list[CurveEdge] = []
    # Clockwise along the teeth, from the end of the bar back to its start, is counterclockwise round the section.
    at = complex(rack.length, root)
    for start, deep, left, right, low, end in rack.corners()[::-1]:  # type: ignore[misc]
        around += [_line(at, end), _fillet(rack, end, right=True), _line(low, right), _line(right, left)]
        around += [_line(left, deep), _fillet(rack, start, right=False)]
        at = start
    corners = [at, complex(0.0, root), complex(0.0, back), complex(rack.length, back), complex(rack.length, root)]
    around += [_line(*ends) for ends in itertools.pairwise(corners)]
    face = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0.0, 0.0, 0.0), _UP), closed_wire(around), True).Face()
    # On the side of a rack that looks away from its pinion, a right-hand helix leans to the left as z grows.
    along = gp_Vec(-rack.width * tan(rack.helix_angle), 0.0, rack.width)
    (solid,) = solids(BRepPrimAPI_MakePrism(face, along).Shape())
    return solid


def _line(start: complex, end: complex) -> CurveEdge:
    way = end - start
    line = Geom_Line(gp_Pnt(start.real, start.imag, 0.0), gp_Dir(way.real, way.imag, 0.0))
    return CurveEdge(line, 0.0, abs(way))


def _fillet(rack: RackForm, foot: complex, *, right: bool) -> CurveEdge:
    """Fillet between root line and flank: from the root up on the right of a tooth, from the flank down on its left."""
    radius, stretch = rack.fillet_factor * rack.normal_module, 1 / cos(rack.helix_angle)
    turn = pi / 2 - rack.normal_pressure_angle
    centre = gp_Pnt(foot.real, foot.imag + radius, 0.0)
    # Half axes ρ / cos β along the bar and ρ across it; the angle of the ellipse is that of the normal section.
    if right:  # seen from behind, so that it runs on from the root line to the left
        axes, first, last = gp_Ax2(centre, _UP.Reversed(), gp_Dir(1.0, 0.0, 0.0)), pi / 2, pi / 2 + turn
    else:
        axes, first, last = gp_Ax2(centre, _UP.Reversed(), gp_Dir(1.0, 0.0, 0.0)), pi / 2 - turn, pi / 2
    if stretch == 1:
        return CurveEdge(Geom_Circle(axes, radius), first, last)
    return CurveEdge(Geom_Ellipse(axes, radius * stretch, radius), first, last)
