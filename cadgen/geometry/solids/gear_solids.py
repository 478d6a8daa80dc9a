"""Gears as solids, face by face from the exact outlines; and a train: a product for each part, and their assembly.

No tooth space is ever cut out: each outline becomes one wire of shared vertices, each wall one prism of that
wire, each cap one planar face on the wires of the prisms that meet it. Nothing has to be intersected but the
wall of a hub with its set screw, so a gear of 150 teeth takes milliseconds.
"""

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
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.collections import Array1_gp_Pnt
from OCP.Geom import Geom_BezierCurve, Geom_Circle, Geom_Line, Geom_Plane
from OCP.gp import gp_Ax2, gp_Ax3, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape, TopoDS_Solid
from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from cadgen.errors import FileError
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.geometry.solids.crossing import with_exact_crossings
from cadgen.geometry.solids.helical_wall import helical_wall
from cadgen.geometry.solids.kernel import (
    TOLERANCE,
    CurveEdge,
    SolidPart,
    closed_wire,
    drill,
    faces,
    filled,
    fits,
    is_valid,
    solid_of,
    solids,
    volume,
)
from cadgen.geometry.solids.step import (
    add_part,
    colour_of,
    completed,
    document_bytes,
    encoded,
    new_document,
    read_uses,
)
from cadgen.parts.body import Body, Cap, RadialHole, SweptWall, caps_of, walls_of
from cadgen.parts.loop import Arc, Curve, Involute, Loop, Points, Segment, bezier_poles
from cadgen.processes import in_second_process

if TYPE_CHECKING:
    from build123d import Compound as Compound

# Fit of the tooth curves, in mm: half of the 0.001 µm and 0.01 µm that flank and root are allowed.
FLANK_TOLERANCE = 0.5e-6
ROOT_TOLERANCE = 5e-6
# The relative error of a volume is that of the fit times outline over area, and goes with 1 / module. Helical gears and
# rings are fitted so that it stays below 1e-8 from a module of 0.2 mm on: they take a share of the tolerances, smaller
# below this radius, mm. Spur gears with teeth outside keep the curves that their files have always had.
SMALL_RADIUS = 16.0
HELICAL_SHARE, RING_SHARE = 0.5, 0.1
# Poles are rounded to this many decimals of a mm, 5e-6 µm: far below the fit, and it keeps noise digits out
# of a STEP file. Rounded ends leave gaps at the lands, which are exact arcs; a gap of 5e-9 mm along a radius of 8 mm
# counts in the kernel's volume of a thin rim by 1e-8, so rings have one decimal more.
DECIMALS, RING_DECIMALS = 8, 9
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
    return solid_of([*walls, *drilled, *(_cap(cap, wires) for cap in caps_of(body.slabs))])


def _side(wall: SweptWall, wires: Wires) -> TopoDS_Shape:
    """The faces of a wall as a shell facing out of the material; its two wires go into `wires`."""
    if not wall.outline.run.straight:
        share = _share_of_small(wall) ** 2 * (HELICAL_SHARE if wall.outward else RING_SHARE)
        made = helical_wall(wall, FLANK_TOLERANCE * share, ROOT_TOLERANCE * share, _decimals(wall))
        wires[wall.outline, wall.start], wires[wall.outline, wall.end] = made.low, made.high
        return solid_of(made.faces)
    base = wires.get((wall.outline, wall.start))
    if base is None:
        share = 1.0 if wall.outward else RING_SHARE * _share_of_small(wall)
        copies = [
            _copies(curve, wall.outline.turns, wall.start, share, _decimals(wall)) for curve in wall.outline.curves
        ]
        base = closed_wire([edge for pitch in zip(*copies, strict=True) for edge in pitch])
    height = wall.end - wall.start
    prism = BRepPrimAPI_MakePrism(base, gp_Vec(wall.outline.run.lean * height, 0.0, height))
    wires[wall.outline, wall.start] = base
    wires[wall.outline, wall.end] = prism.LastShape()
    # The kernel turns the faces of a counter-clockwise wire inwards.
    return prism.Shape().Reversed() if wall.outward else prism.Shape()


def _share_of_small(wall: SweptWall) -> float:
    """Share of the tolerances for a wall, smaller for a small one."""
    return min(1.0, wall.outline.radii[1] / SMALL_RADIUS)


def _decimals(wall: SweptWall) -> int:
    return DECIMALS if wall.outward else RING_DECIMALS


def _copies(curve: Curve, turns: Points, height: float, share: float, decimals: int) -> list[CurveEdge]:
    """Edges of a curve turned by each of `turns`, at a height, mm, fitted to a share of the tolerances and rounded."""
    edges = []
    if isinstance(curve, Arc):
        for arc in (curve.rotated(angle) for angle in np.angle(turns)):
            centre = gp_Pnt(arc.centre.real, arc.centre.imag, height)
            start = gp_Dir(np.cos(arc.start), np.sin(arc.start), 0.0)
            about = UP if arc.sweep > 0 else UP.Reversed()
            edges.append(CurveEdge(Geom_Circle(gp_Ax2(centre, about, start), arc.radius), 0.0, abs(arc.sweep)))
        return edges
    if isinstance(curve, Segment):
        poles = curve.point([0.0, 1.0])
    else:
        poles = bezier_poles(curve, share * (FLANK_TOLERANCE if isinstance(curve, Involute) else ROOT_TOLERANCE))
    for row in np.round(turns[:, None] * poles, decimals).tolist():
        points = [gp_Pnt(pole.real, pole.imag, height) for pole in row]
        if isinstance(curve, Segment):
            along = row[1] - row[0]
            edges.append(CurveEdge(Geom_Line(points[0], gp_Dir(along.real, along.imag, 0.0)), 0.0, abs(along)))
        else:
            edges.append(CurveEdge(Geom_BezierCurve(filled(Array1_gp_Pnt, points)), 0.0, 1.0))
    return edges


def _cap(cap: Cap, wires: Wires) -> TopoDS_Shape:
    """The planar face of a cap on the wires of the walls it meets."""
    builder, face = BRep_Builder(), TopoDS_Face()
    builder.MakeFace(face, Geom_Plane(gp_Ax3(gp_Pnt(0.0, 0.0, cap.height), UP)), TOLERANCE)
    builder.Add(face, wires[cap.outer, cap.height])
    for hole in cap.inner:
        builder.Add(face, wires[hole, cap.height].Reversed())
    return face if cap.up else face.Reversed()


def _drilled(sides: list[TopoDS_Shape], ends: list[TopoDS_Shape], hole: RadialHole) -> list[TopoDS_Shape]:
    """The faces of one slab's walls after drilling.

    Only this slab, closed by its two end faces for the time of the cut, meets the drill: cutting the whole gear
    would take ten times longer. The end faces' edges stay as they are, so the result fits its neighbours.
    """
    slab = solid_of([face for side in sides for face in faces(side)] + ends)
    cut = BRepAlgoAPI_Cut(slab, drill(hole))
    if not cut.IsDone():
        raise FileError(
            "the kernel cannot drill the set screw of {diameter:g} mm; change its diameter", diameter=hole.diameter
        )
    return [face for face in faces(with_exact_crossings(cut.Shape())) if not any(face.IsSame(end) for end in ends)]


# Hue of the first part, in turns; the next ones follow by the golden section, so that no two parts are alike.
FIRST_HUE, HUE_STEP = 0.58, (sqrt(5) - 1) / 2
SATURATION, BRIGHTNESS, LIGHTER = 0.35, 0.75, 0.85


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class AssembledPart:
    """A part read from an assembly's file: `transform` leads from its frame to the train's, shape (3, 4), mm."""

    name: str
    colour: tuple[float, float, float] | None
    transform: NDArray[np.float64]
    valid: bool
    bodies: int
    volume: float


def train_parts(layout: TrainLayout, name: str, description: str) -> tuple[SolidPart, ...]:
    """The solids of a train, each in its own frame; the parts' names follow that of the train.

    Raises `DesignError` and `FileError` as `body_solid` does.
    """
    return tuple(
        SolidPart(
            solid=body_solid(part.body),
            name=part_name(name, part),
            description=description,
            colour=colour_of_shaft(part.shaft, upper=bool(part.joined_to) and part.blank.hub is None),
        )
        for part in layout.parts
    )


def part_name(train: str, part: TrainPart) -> str:
    """Name of a part's product and files."""
    return f"{train}_{part.name}"


def colour_of_shaft(shaft: int, *, upper: bool = False) -> tuple[float, float, float]:
    """Red, green and blue of the part on a shaft, counted from 1; lighter for the upper one of two parts on it."""
    return hsv_to_rgb((FIRST_HUE + HUE_STEP * (shaft - 1)) % 1.0, SATURATION, LIGHTER if upper else BRIGHTNESS)


def assembly_bytes(parts: Sequence[SolidPart], layout: TrainLayout, name: str, description: str) -> bytes:
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


def train_compound(parts: Sequence[SolidPart], layout: TrainLayout, name: str) -> Compound:
    """Return the parts at their places as one build123d compound, a labelled and coloured solid for each."""
    import build123d

    placed = []
    for part, at in zip(parts, layout.parts, strict=True):
        move = gp_Trsf()
        move.SetValues(*at.transform.ravel().tolist())
        placed.append(part.build123d().located(build123d.Location(TopLoc_Location(move))))
    return build123d.Compound(label=name, children=placed)


def mesh_compound(parts: Sequence[SolidPart], places: Sequence[tuple[float, float, float]], name: str) -> Compound:
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
    document, uses = read_uses(path)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    placed = []
    for use in uses:
        label = TDF_Label()
        XCAFDoc_ShapeTool.GetReferredShape_s(use, label)
        placed.append((label, XCAFDoc_ShapeTool.GetLocation_s(use).Transformation()))
    shapes = [tool.GetShape_s(label) for label, _ in placed]
    judged = [(False, 0.0)] * len(shapes)
    with in_second_process(partial(_judged, shapes[1::2])) as others:
        judged[::2] = _judged(shapes[::2])
        judged[1::2] = others()
    parts = []
    for (label, move), shape, (valid, size) in zip(placed, shapes, judged, strict=True):
        bodies, name = solids(shape), TDataStd_Name()
        parts.append(
            AssembledPart(
                name=name.Get().ToExtString() if label.FindAttribute(TDataStd_Name.GetID_s(), name) else "",
                colour=colour_of(document, bodies[0]) if bodies else None,
                transform=np.array([[move.Value(row, column) for column in range(1, 5)] for row in range(1, 4)]),
                valid=valid,
                bodies=len(bodies),
                volume=size,
            )
        )
    return tuple(parts)


def _judged(shapes: Sequence[TopoDS_Shape]) -> list[tuple[bool, float]]:
    """Whether the kernel finds neither a gap nor a fault in each shape, and its volume, mm³."""
    whole = [completed(shape) for shape in shapes]
    return [(fits(shape) and is_valid(shape), volume(shape)) for shape in whole]


def _name(label: TDF_Label, name: str) -> None:
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(encoded(name)))
