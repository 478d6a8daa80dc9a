"""Direct mesh of a body of prisms, such as a gear's: no CAD kernel, every corner on the exact outline.

The walls are strips between equal polygons and the caps share their corners, so the mesh is closed by
construction.
"""

from __future__ import annotations

import manifold3d
import numpy as np
from numpy.typing import NDArray

from cadgen.geometry.meshes.mesh import Mesh, drill, mesh_of
from cadgen.parts.body import Body, Cap, RadialHole, caps_of, walls_of
from cadgen.parts.loop import Loop, Points, circle

Corners = dict[tuple[Loop, float], int]


def body_mesh(body: Body, chord_tolerance: float) -> Mesh:
    """Mesh of `body` whose chords stay within `chord_tolerance` (mm) of the exact outlines.

    Args:
        body: body of prisms.
        chord_tolerance: greatest distance of a chord from an outline, mm.
    """
    polygons: dict[Loop, Points] = {}
    corners: Corners = {}
    vertices: list[NDArray[np.float64]] = []
    triangles: list[NDArray[np.int64]] = []
    count = 0

    def row(outline: Loop, height: float) -> int:
        """Index of the first corner of `outline` at `height`."""
        nonlocal count
        if (outline, height) not in corners:
            points = polygons.setdefault(outline, outline.polygon(chord_tolerance))
            vertices.append(np.column_stack([points.real, points.imag, np.full(len(points), height)]))
            corners[outline, height] = count
            count += len(points)
        return corners[outline, height]

    for wall in walls_of(body):
        low, high = row(wall.outline, wall.start), row(wall.outline, wall.end)
        strip = _strip(low, high, len(polygons[wall.outline]))
        triangles.append(strip if wall.outward else strip[:, ::-1])
    for cap in caps_of(body.slabs):
        flat = _cap_triangles(cap, polygons, corners)
        triangles.append(flat if cap.up else flat[:, ::-1])
    mesh = Mesh(np.concatenate(vertices), np.concatenate(triangles))
    if body.radial_hole:
        return _drilled(mesh, body.radial_hole, chord_tolerance)
    return mesh


def _strip(low: int, high: int, count: int) -> NDArray[np.int64]:
    """Triangles of the wall between two equal counter-clockwise rings of corners, seen from outside them."""
    corner = np.arange(count)
    following = np.roll(corner, -1)
    return np.concatenate(
        [
            np.column_stack([low + corner, low + following, high + following]),
            np.column_stack([low + corner, high + following, high + corner]),
        ]
    )


def _cap_triangles(cap: Cap, polygons: dict[Loop, Points], corners: Corners) -> NDArray[np.int64]:
    """Triangles of a cap, counter-clockwise from above.

    Triangulating thousands of corners at once is slow. One pitch of the outer outline is cut off by the chord
    between its ends and triangulated; its copies only need other indices. What remains has one corner per
    pitch.
    """
    first, outer = corners[cap.outer, cap.height], polygons[cap.outer]
    index = first + np.arange(len(outer))
    parts = []
    step = len(outer) // cap.outer.repeats
    if cap.outer.repeats > 1:
        pitch = _triangulate([outer[: step + 1]])
        offsets = step * np.arange(cap.outer.repeats)[:, None, None]
        parts.append(first + (pitch + offsets).reshape(-1, 3) % len(outer))
        index, outer = index[::step], outer[::step]
    rings, indices = [outer], [index]
    for hole in cap.inner:
        rings.append(polygons[hole][::-1])
        indices.append((corners[hole, cap.height] + np.arange(len(polygons[hole])))[::-1])
    parts.append(np.concatenate(indices)[_triangulate(rings)])
    return np.concatenate(parts)


def _triangulate(rings: list[Points]) -> NDArray[np.int64]:
    flat = [np.column_stack([ring.real, ring.imag]) for ring in rings]
    return np.asarray(manifold3d.triangulate(flat), dtype=np.int64)


def _drilled(mesh: Mesh, hole: RadialHole, chord_tolerance: float) -> Mesh:
    """The mesh less the radial hole, as a prism between axis and reach."""
    section = circle(hole.diameter).polygon(chord_tolerance)
    # Made before the solid: the order in which both are made is that of their triangles in the result.
    tool = drill(hole, np.column_stack([section.real, section.imag]))
    return mesh_of(mesh.solid() - tool)
