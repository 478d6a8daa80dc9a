"""Closed meshes of triangles: the disc of a cam by manifold3d, and a body of prisms, such as a gear's, directly.

No CAD kernel makes them. A body's walls are strips between equal polygons on the exact outlines and its caps share
their corners, so the mesh is closed by construction.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import manifold3d
import numpy as np
from manifold3d import CrossSection, Error, FillRule, Manifold, Mesh64, triangulate
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.curves.chamfer import chamfer_strips
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.contour import Contour, circle
from cadgen.curves.polygon import polygon, strip_polygons
from cadgen.errors import FileError
from cadgen.parts.blank import OVERSHOOT, PROFILE_STEP, Blank, Boss
from cadgen.parts.body import Body, Cap, RadialHole, caps_of, walls_of
from cadgen.parts.loop import Loop, Points
from cadgen.parts.loop import circle as circle_loop

Triangles = NDArray[np.int64]


class Mesh(NamedTuple):
    """Vertices, shape (n, 3), mm, and triangles, shape (m, 3), counterclockwise seen from outside."""

    vertices: Array
    triangles: Triangles

    def manifold(self) -> Manifold:
        """The mesh as a solid; its `status` shows whether it is closed, oriented and free of faults."""
        # Copies: manifold3d takes no array that is read-only or out of order.
        return Manifold(Mesh64(np.array(self.vertices, order="C"), self.triangles.astype(np.uint64, order="C")))

    def solid(self) -> Manifold:
        """The mesh as a closed solid.

        Raises:
            FileError: the mesh is not closed.
        """
        solid = self.manifold()
        if solid.status() != Error.NoError:
            raise FileError(
                "the mesh of a gear is not closed ({name}); choose another chord tolerance", name=solid.status().name
            )
        return solid


def mesh_of(solid: Manifold) -> Mesh:
    """The mesh of a solid."""
    mesh = solid.to_mesh64()
    return Mesh(np.array(mesh.vert_properties[:, :3], dtype=np.float64), np.array(mesh.tri_verts, dtype=np.int64))


def drill(hole: RadialHole, section: Array) -> Manifold:
    """Prism that a radial hole takes away, from the z axis outwards.

    Args:
        hole: radial hole, in mm and rad.
        section: corners of the hole's section about its own axis, counterclockwise, shape (n, 2), mm.
    """
    c, s = np.cos(hole.angle), np.sin(hole.angle)
    # Lays the prism's axis, which is z, along the ray of the hole.
    laid = np.array([[0.0, -s, c, 0.0], [0.0, c, s, 0.0], [-1.0, 0.0, 0.0, hole.height]])
    return Manifold.extrude(CrossSection([section]), hole.reach).transform(laid)


# Shares of the chord tolerance that a chord across a helical wall, and one along it, may take: the diagonals of its
# quadrangles then keep to all of it.
CHORD_SHARE = 0.25


class CornerRing(NamedTuple):
    """Corners of an outline at one height: number of the first, and places, shape (n,), mm."""

    first: int
    points: Points


def turning_heights(outline: Loop, length: float, chord_tolerance: float) -> list[float]:
    """Heights above the start of a wall at which it has corners, mm: its end, and those that its turning asks for.

    Args:
        outline: outline with its run.
        length: length of the wall, mm.
        chord_tolerance: greatest distance of a chord from the wall, mm.
    """
    if outline.run.straight:
        return [length]
    step = np.sqrt(8 * CHORD_SHARE * chord_tolerance / outline.radii[1])
    heights: list[float] = []
    for low, high in outline.run.pieces(length):
        rows = int(np.ceil(abs(outline.run.rate) * (high - low) / step))
        heights += np.linspace(low, high, rows + 1)[1:].tolist()
    return heights


def body_mesh(body: Body, chord_tolerance: float) -> Mesh:
    """Mesh of `body` whose chords stay within `chord_tolerance` (mm) of the exact outlines.

    Args:
        body: body of prisms.
        chord_tolerance: greatest distance of a chord from an outline, mm.
    """
    rings: dict[tuple[Loop, float], CornerRing] = {}
    vertices: list[NDArray[np.float64]] = []
    triangles: list[NDArray[np.int64]] = []
    count = 0

    def put(points: Points, height: float) -> CornerRing:
        """Corners at a height."""
        nonlocal count
        vertices.append(np.column_stack([points.real, points.imag, np.full(len(points), height)]))
        ring = CornerRing(count, points)
        count += len(points)
        return ring

    for wall in walls_of(body):
        outline, length = wall.outline, wall.end - wall.start
        low = rings.get((outline, wall.start))
        if low is None:
            chord = chord_tolerance if outline.run.straight else chord_tolerance * CHORD_SHARE
            low = rings[outline, wall.start] = put(outline.polygon(chord), wall.start)
        section = low.points
        for height in turning_heights(outline, length, chord_tolerance):
            turned = section * np.exp(1j * outline.run.angle(height)) if outline.run.rate else section
            if outline.run.lean:
                turned = section + outline.run.lean * height
            high = put(turned, wall.end if height == length else wall.start + height)
            strip = _strip(low.first, high.first, len(section))
            triangles.append(strip if wall.outward else strip[:, ::-1])
            low = high
        rings[outline, wall.end] = low
    for cap in caps_of(body.slabs):
        flat = _cap_triangles(cap, rings)
        triangles.append(flat if cap.up else flat[:, ::-1])
    mesh = Mesh(np.concatenate(vertices), np.concatenate(triangles))
    if body.radial_hole is None:
        return mesh
    section = circle_loop(body.radial_hole.diameter).polygon(chord_tolerance)
    # Made before the solid: the order in which both are made is that of their triangles in the result.
    tool = drill(body.radial_hole, np.column_stack([section.real, section.imag]))
    return mesh_of(mesh.solid() - tool)


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


def _cap_triangles(cap: Cap, rings: dict[tuple[Loop, float], CornerRing]) -> NDArray[np.int64]:
    """Triangles of a cap, counter-clockwise from above.

    Triangulating thousands of corners at once is slow. One pitch of the outer outline is cut off by the chord
    between its ends and triangulated; its copies only need other indices. What remains has one corner per
    pitch.
    """
    first, outer = rings[cap.outer, cap.height]
    index = first + np.arange(len(outer))
    parts = []
    step = len(outer) // cap.outer.repeats
    if cap.outer.repeats > 1:
        pitch = _triangulate([outer[: step + 1]])
        offsets = step * np.arange(cap.outer.repeats)[:, None, None]
        parts.append(first + (pitch + offsets).reshape(-1, 3) % len(outer))
        index, outer = index[::step], outer[::step]
    holes, indices = [outer], [index]
    for hole in cap.inner:
        number, corners = rings[hole, cap.height]
        holes.append(corners[::-1])
        indices.append((number + np.arange(len(corners)))[::-1])
    parts.append(np.concatenate(indices)[_triangulate(holes)])
    return np.concatenate(parts)


def _triangulate(rings: list[Points]) -> NDArray[np.int64]:
    flat = [np.column_stack([ring.real, ring.imag]) for ring in rings]
    return np.asarray(manifold3d.triangulate(flat), dtype=np.int64)


def cam_mesh(
    profile: ClosedCurve, blank: Blank, thickness: float, chord_tolerance: float, rim_share: float = 0.5
) -> Mesh:
    """Return the disc with its bore, holes and hub; z = 0 is the inner face, z = thickness the outer one.

    Args:
        profile: profile of the rim, mm.
        blank: features of the disc besides its profile.
        thickness: thickness of the disc, mm.
        chord_tolerance: greatest distance of bore, holes and hub from the true shape, mm.
        rim_share: share of chord_tolerance allowed to the rim along its normal; the error of the lift is that over the
            cosine of the pressure angle.

    Raises:
        DesignError: a hole cuts into another one, into the hub or through the profile.
        CheckError: the chamfers of broken edges meet, or run out at a ridge.
    """
    blank.require_walls(profile.outline(PROFILE_STEP))
    holes = [contour.polygon(chord_tolerance) for contour in blank.holes()]
    bore, rim_chord = blank.bore(), rim_share * chord_tolerance
    boss = blank.boss(thickness)
    if boss is None:
        solid = _disc(profile, [bore.polygon(chord_tolerance), *holes], thickness, blank.edge_break, rim_chord)
    else:
        disc = _disc(profile, holes, thickness, blank.edge_break, rim_chord)
        solid = _with_hub(disc, boss, bore, thickness, chord_tolerance)
    return mesh_of(solid)


def grooved_mesh(
    flanks: tuple[ClosedCurve, ClosedCurve],
    blank: Blank,
    thickness: float,
    depth: float,
    outside_radius: float,
    chord_tolerance: float,
    rim_share: float = 0.5,
) -> Mesh:
    """Return a round disc with a groove in the face at z = thickness, with its bore, holes and hub.

    Args:
        flanks: inner and outer flank of the groove, mm.
        blank: features of the disc besides the groove.
        thickness: thickness of the disc, mm.
        depth: depth of the groove, mm.
        outside_radius: radius of the disc, mm.
        chord_tolerance: greatest distance of rim, bore, holes and hub from the true shape, mm.
        rim_share: share of chord_tolerance allowed to the flanks along their normals.

    Raises:
        DesignError: a hole cuts into another one, into the hub or into the groove.
    """
    inner, outer = flanks
    blank.require_walls(inner.outline(PROFILE_STEP))
    holes = [contour.polygon(chord_tolerance) for contour in blank.holes()]
    bore, boss = blank.bore(), blank.boss(thickness)
    rim = circle((0.0, 0.0), outside_radius).polygon(chord_tolerance)
    solid = _prism([rim, *holes, *([] if boss else [bore.polygon(chord_tolerance)])], 0.0, thickness)
    ring = [polygon(flank, rim_share * chord_tolerance) for flank in (outer, inner)]
    solid -= _prism(ring, thickness - depth, depth + OVERSHOOT)
    return mesh_of(solid if boss is None else _with_hub(solid, boss, bore, thickness, chord_tolerance))


def _prism(polygons: list[Array], bottom: float, height: float) -> Manifold:
    section = CrossSection(polygons, FillRule.EvenOdd)
    return Manifold.extrude(section, height).translate((0.0, 0.0, bottom))


def _disc(profile: ClosedCurve, holes: list[Array], thickness: float, edge_break: float, chord: float) -> Manifold:
    """The disc with holes, the edges of its rim broken."""
    if edge_break == 0:
        return _prism([polygon(profile, chord), *holes], 0.0, thickness)
    outer, inner = strip_polygons(chamfer_strips(profile, edge_break), chord)
    rings, vertices = [], np.empty((0, 3))
    heights = 0.0, edge_break, thickness - edge_break, thickness
    for points, z in zip((inner, outer, outer, inner), heights, strict=True):
        # Where a side of the chamfer is a point it stands there once.
        new = np.any(points != np.roll(points, 1, axis=0), axis=1)
        rings.append(len(vertices) + (np.cumsum(new) - 1) % new.sum())
        vertices = np.vstack([vertices, np.column_stack([points[new], np.full(new.sum(), z)])])
    triangles = [
        np.concatenate([np.stack(corners, axis=1) for corners in ((a, a1, b1), (a, b1, b))])
        for a, b in pairwise(rings)
        for a1, b1 in [(np.roll(a, -1), np.roll(b, -1))]
    ]
    cap = triangulate([vertices[np.unique(rings[0]), :2]])
    triangles += [cap[:, ::-1] + rings[0].min(), cap + rings[-1].min()]
    faces = np.concatenate(triangles)
    whole = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    solid = Manifold(Mesh64(vertices, faces[whole].astype(np.uint64)))
    if solid.status() != Error.NoError:
        raise FileError("the mesh of the disc with broken edges does not close: report this design")
    if holes:
        solid -= _prism(holes, -OVERSHOOT, thickness + 2 * OVERSHOOT)
    return solid


def _with_hub(disc: Manifold, boss: Boss, bore: Contour, thickness: float, chord_tolerance: float) -> Manifold:
    """Set the hub on a disc without bore, then cut bore and set screw through both."""
    # From the disc's middle on, so that the two bodies do not merely touch.
    low, high = min(boss.low, thickness / 2), max(boss.high, thickness / 2)
    hub = _prism([circle((0.0, 0.0), boss.diameter / 2).polygon(chord_tolerance)], low, high - low)
    solid = disc + hub - _prism([bore.polygon(chord_tolerance)], boss.bottom, boss.top - boss.bottom)
    if boss.drill is None:
        return solid
    return solid - drill(boss.drill, circle((0.0, 0.0), boss.drill.diameter / 2).polygon(chord_tolerance))
