"""Parts of a car as closed meshes: gears where they stand along their shafts, and every other part in its own frame."""

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from manifold3d import CrossSection, FillRule, Manifold

from cadgen.arrays import Array
from cadgen.car.assembly.car_parts import Block, BodyShape, CarPart, DiscShape, Drilled, Joined, Prism, Shape
from cadgen.car.assembly.turning_train import Stand
from cadgen.curves.contour import circle
from cadgen.curves.polygon import polygon
from cadgen.geometry.meshes.mesh import Mesh, body_mesh, cam_mesh, mesh_of

# mm by which faces that are flush may differ: outlines are kept on a grid of some 1e-8 mm before they are made prisms.
_FLUSH = 1e-6


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
        case Joined(blocks=blocks):
            solid = Manifold()
            for block, place in blocks:
                solid += _block(block, chord).transform(place)
            return mesh_of(solid.set_tolerance(_FLUSH))
    return mesh_of(_block(shape, chord))


def _block(shape: Block, chord: float) -> Manifold:
    solid = Manifold()
    for each in shape.prisms:
        solid += _prism(each, chord)
    for seat in shape.seats:
        tool, place = seat.tool
        solid -= _prism(tool, chord).transform(place)
    for hole in shape.drilled:
        solid -= _drilled(hole, chord)
    return solid


def _prism(each: Prism, chord: float) -> Manifold:
    return _extruded([contour.polygon(chord) for contour in (each.outline, *each.holes)], each.low, each.high)


def _drilled(hole: Drilled, chord: float) -> Manifold:
    axis = np.asarray(hole.direction)
    beside = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    beside /= np.linalg.norm(beside)
    start, length = hole.tool
    place = np.column_stack([beside, np.cross(axis, beside), axis, start])
    section = CrossSection([circle((0.0, 0.0), hole.diameter / 2).polygon(chord)])
    return Manifold.extrude(section, length).transform(place)


class Seen(NamedTuple):
    """Silhouette of a piece of a part in a view.

    Attributes:
        code: code of the part.
        rings: outlines, counterclockwise, and holes, clockwise, shape (n, 2) each, mm.
        near: distance by which its nearest point lies towards the viewer, mm.
    """

    code: str
    rings: tuple[Array, ...]
    near: float


def seen(parts: Iterable[CarPart], view: Array, cam_angle: float, fork_angle: float, chord: float) -> tuple[Seen, ...]:
    """Silhouettes of the pieces of all parts, gears by the circles of their tips and rims.

    Args:
        parts: parts of a car.
        view: directions in the car that are to the right, up, and towards the viewer, unit vectors, shape (3, 3).
        cam_angle: cam angle, rad.
        fork_angle: angle of the fork about y, rad.
        chord: greatest distance of a chord from a curve, mm.
    """
    found = []
    for part in parts:
        pieces = [] if part.shape is None else list(_pieces(part.shape, chord))
        for place in part.placed(cam_angle, fork_angle):
            for piece in pieces:
                turned = piece.transform(view @ place)
                rings = tuple(np.asarray(ring) for ring in turned.project().to_polygons())
                found.append(Seen(part.code, rings, turned.bounding_box()[5]))
    return tuple(found)


def _pieces(shape: Shape, chord: float) -> Iterator[Manifold]:
    """Solids of the pieces of a shape: slabs, or prisms."""
    match shape:
        case BodyShape(body=body):
            for slab in body.slabs:
                rings = [circle((0.0, 0.0), ring.radii[1]).polygon(chord) for ring in slab.rings]
                rings += [
                    np.column_stack([points.real, points.imag]) for points in (h.polygon(chord) for h in slab.holes)
                ]
                yield _extruded(rings, slab.start, slab.end)
        case DiscShape(curve=curve, blank=blank, thickness=thickness):
            rings = [polygon(curve, chord), *(contour.polygon(chord) for contour in blank.inner_contours())]
            yield _extruded(rings, 0.0, thickness)
            boss = blank.boss(thickness)
            if boss is not None:
                around = circle((0.0, 0.0), boss.diameter / 2).polygon(chord)
                yield _extruded([around, blank.bore().polygon(chord)], boss.low, boss.high)
        case Joined(blocks=blocks):
            for block, place in blocks:
                for each in block.prisms:
                    yield _prism(each, chord).transform(place)
        case _:
            for each in shape.prisms:
                yield _prism(each, chord)


def _extruded(rings: Sequence[Array], low: float, high: float) -> Manifold:
    return Manifold.extrude(CrossSection(list(rings), FillRule.EvenOdd), high - low).translate((0.0, 0.0, low))
