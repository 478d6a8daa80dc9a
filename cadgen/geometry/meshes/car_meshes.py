"""Parts of a car as closed meshes: gears where they stand along their shafts, and every other part in its own frame."""

from functools import lru_cache

import numpy as np
from manifold3d import CrossSection, FillRule, Manifold

from cadgen.car.assembly.car_parts import BodyShape, DiscShape, Drilled, Prism, Shape
from cadgen.car.assembly.turning_train import Stand
from cadgen.curves.contour import circle
from cadgen.geometry.meshes.mesh import Mesh, body_mesh, cam_mesh, mesh_of


@lru_cache(maxsize=128)  # chord by chord until the triangles are few enough; and again while a design is edited
def stood(stand: Stand, chord: float) -> Mesh:
    """Mesh of a part of a train about its own axis, at the height where it stands, mm.

    Args:
        stand: body with its height and side.
        chord: greatest distance of a chord from a curve, mm.
    """
    mesh = body_mesh(stand.body, chord)
    return Mesh(mesh.vertices * [1.0, stand.side, stand.side] + [0.0, 0.0, stand.height], mesh.triangles)


def shape_mesh(shape: Shape, chord: float) -> Mesh:
    """Mesh of a shape in its own frame, mm.

    Args:
        shape: shape of a part of a car.
        chord: greatest distance of a chord from a curve, mm.

    Raises:
        DesignError: features of a disc cut into each other.
    """
    match shape:
        case BodyShape(body=body):
            return body_mesh(body, chord)
        case DiscShape(curve=curve, blank=blank, thickness=thickness):
            return cam_mesh(curve, blank, thickness, chord)
    solid = Manifold()
    for each in shape.prisms:
        solid += _prism(each, chord)
    for each in shape.cuts:
        solid -= _prism(each, chord)
    for hole in shape.drilled:
        solid -= _drilled(hole, chord)
    return mesh_of(solid)


def _prism(each: Prism, chord: float) -> Manifold:
    rings = [contour.polygon(chord) for contour in (each.outline, *each.holes)]
    section = CrossSection(rings, FillRule.EvenOdd)
    return Manifold.extrude(section, each.high - each.low).translate((0.0, 0.0, each.low))


def _drilled(hole: Drilled, chord: float) -> Manifold:
    axis = np.asarray(hole.direction)
    beside = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    beside /= np.linalg.norm(beside)
    place = np.column_stack([beside, np.cross(axis, beside), axis, hole.start])
    section = CrossSection([circle((0.0, 0.0), hole.diameter / 2).polygon(chord)])
    return Manifold.extrude(section, hole.depth).transform(place)
