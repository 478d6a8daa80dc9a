"""Section of a body through its axis, as material to either side: from outlines alone."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from cadgen.arrays import Array
from cadgen.output.drawing.sheet import Hatch, Stroke

_FARTHEST = 1e4  # mm, beyond every part
_GRID = 1e-6  # mm, within which corners of neighbouring layers are one


@dataclass(frozen=True, slots=True, eq=False)
class Layer:
    """A prism of the body.

    Attributes:
        low: height at which it begins along the axis, mm.
        high: height at which it ends.
        rings: corners of nested outlines, each shape (n, 2), mm, outermost first: material lies inside every first and
            outside every second.
        holes: corners of further outlines, cut out of the material.
    """

    low: float
    high: float
    rings: tuple[Array, ...]
    holes: tuple[Array, ...] = ()


def material(layers: Sequence[Layer], angle: float) -> list[shapely.Polygon]:
    """Areas of material in the plane through the axis at polar angle `angle` (rad), in coordinates (z, r), mm.

    r counts along the direction `angle`: it is negative on the other side of the axis.

    Args:
        layers: layers of the part.
        angle: polar angle of the plane, rad.
    """
    along = np.array([np.cos(angle), np.sin(angle)])
    ray = shapely.LineString([-_FARTHEST * along, _FARTHEST * along])
    areas = []
    for layer in layers:
        discs = [shapely.Polygon(outline) for outline in layer.rings]
        rims = [shapely.difference(pair[0], pair[1]) if pair[1:] else pair[0] for pair in _pairs(discs)]
        face = shapely.difference(shapely.union_all(rims), shapely.union_all([*map(shapely.Polygon, layer.holes)]))
        for piece in shapely.get_parts(shapely.intersection(face, ray)):
            ends = np.sort(np.asarray(piece.coords) @ along)
            areas.append(shapely.box(layer.low, ends[0], layer.high, ends[-1]))
    whole = shapely.union_all(shapely.set_precision(areas, _GRID))
    return [piece for piece in shapely.get_parts(whole) if isinstance(piece, shapely.Polygon)]


def beyond(layers: Sequence[Layer], areas: Sequence[shapely.Polygon]) -> list[Stroke]:
    """Edges seen beyond the cut: outlines of what is open between the outermost material of every layer."""
    boxes = []
    for layer in layers:
        reach = float(np.linalg.norm(layer.rings[0], axis=1).max())
        within = shapely.intersection(shapely.union_all(areas), shapely.box(layer.low, -reach, layer.high, reach))
        _, low, _, high = within.bounds
        boxes.append(shapely.box(layer.low, low, layer.high, high))
    voids = shapely.difference(shapely.union_all(shapely.set_precision(boxes, _GRID)), shapely.union_all(areas))
    return [Stroke(np.asarray(void.exterior.coords)) for void in shapely.get_parts(voids)]


def _pairs(discs: list[shapely.Polygon]) -> list[list[shapely.Polygon]]:
    return [discs[i : i + 2] for i in range(0, len(discs), 2)]


def drawn(areas: Sequence[shapely.Polygon]) -> tuple[list[Stroke], list[Hatch]]:
    """Outlines and hatches of areas of material."""
    strokes, hatches = [], []
    for area in areas:
        outside = np.asarray(area.exterior.coords)
        holes = tuple(np.asarray(hole.coords) for hole in area.interiors)
        strokes += [Stroke(points) for points in (outside, *holes)]
        hatches.append(Hatch(outside[:-1], tuple(hole[:-1] for hole in holes)))
    return strokes, hatches
