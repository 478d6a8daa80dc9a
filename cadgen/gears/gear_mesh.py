"""Direct triangle mesh of a gear's body: no CAD kernel, every corner on the exact outline.

The walls are strips between equal polygons and the caps share their corners, so the mesh is closed by
construction.
"""

from __future__ import annotations

from dataclasses import dataclass

import manifold3d
import numpy as np
from numpy.typing import NDArray

from cadgen.errors import FileError
from cadgen.gears.body import Body, Cap, RadialHole, caps_of, walls_of
from cadgen.gears.outline import GearOutline, Points, circle

Corners = dict[tuple[GearOutline, float], int]


@dataclass(frozen=True, slots=True, eq=False)
class TriangleMesh:
    """Closed triangle mesh, corners counter-clockwise from outside.

    `vertices` has the shape (n, 3), in mm; `triangles` has the shape (m, 3) and holds vertex indices.
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int64]

    def manifold(self) -> manifold3d.Manifold:
        """The mesh as a manifold3d solid; `FileError` if it is not closed."""
        mesh = manifold3d.Mesh64(self.vertices, self.triangles.astype(np.uint64, order="C"))
        solid = manifold3d.Manifold(mesh)
        if solid.status() != manifold3d.Error.NoError:
            raise FileError(f"the mesh of a gear is not closed ({solid.status().name}); choose another chord tolerance")
        return solid


def body_mesh(body: Body, chord_tolerance: float) -> TriangleMesh:
    """Mesh of `body` whose chords stay within `chord_tolerance` (mm) of the exact outlines."""
    polygons: dict[GearOutline, Points] = {}
    corners: Corners = {}
    vertices: list[NDArray[np.float64]] = []
    triangles: list[NDArray[np.int64]] = []
    count = 0

    def row(outline: GearOutline, height: float) -> int:
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
    mesh = TriangleMesh(np.concatenate(vertices), np.concatenate(triangles))
    if body.radial_hole:
        return _drilled(mesh, body.radial_hole, chord_tolerance)
    return mesh


def _strip(low: int, high: int, count: int) -> NDArray[np.int64]:
    """Triangles of the wall between two equal counter-clockwise rings of corners, seen from outside them."""
    here = np.arange(count)
    there = np.roll(here, -1)
    return np.concatenate(
        [
            np.column_stack([low + here, low + there, high + there]),
            np.column_stack([low + here, high + there, high + here]),
        ]
    )


def _cap_triangles(cap: Cap, polygons: dict[GearOutline, Points], corners: Corners) -> NDArray[np.int64]:
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


def _drilled(mesh: TriangleMesh, hole: RadialHole, chord_tolerance: float) -> TriangleMesh:
    """The mesh less the radial hole, as a prism between axis and reach."""
    section = circle(hole.diameter).polygon(chord_tolerance)
    drill = manifold3d.Manifold.extrude(
        manifold3d.CrossSection([np.column_stack([section.real, section.imag])]), hole.reach
    )
    drill = drill.rotate([0.0, 90.0, 0.0]).translate([0.0, 0.0, hole.height])
    cut = (mesh.manifold() - drill).to_mesh64()
    # Copies: the arrays handed out by manifold3d are read-only, and it takes no such array back.
    return TriangleMesh(np.array(cut.vert_properties[:, :3], dtype=np.float64), np.array(cut.tri_verts, dtype=np.int64))
