"""Meshes for a printer: holes larger, the foot tapered, all of it larger by the shrinkage; and the way back.

A hole's wall moves along its own normals, so that its chords stay parallel. The taper of the foot moves the outlines of
the lower face into the material, and a row of corners at its height keeps the walls above as they are. The way back
finds the outlines of the lower face and the walls of the holes in the mesh that was read; what a file does not have
where it should be stays wrong, and shows in its volume and in its outline.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from manifold3d import triangulate
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import DesignError, FileError
from cadgen.geometry.meshes.mesh import Mesh, Triangles
from cadgen.parts.blank import Blank
from cadgen.parts.body import Body
from cadgen.parts.loop import Arc
from cadgen.parts.print_compensation import PrintCompensation

# Distance of a wall's corner from its outline, mm: single precision leaves 4e-6 of 100 mm.
_ON_WALL = 2e-4
# Share of an edge at whose ends a corner is that of the outline.
_AT_END = 1e-3
# Share of the greatest taper that a message names.
_NAMED = 0.95


class HoleOutline(NamedTuple):
    """Hole as the mesh has it: corners counterclockwise, shape (n, 2), centre and radius of its round part, mm."""

    corners: Array
    centre: tuple[float, float]
    radius: float

    @property
    def sagitta(self) -> float:
        """Greatest distance of its chords from its circle, mm."""
        off = self.corners - self.centre
        round_part = np.abs(np.linalg.norm(off, axis=1) - self.radius) < _ON_WALL
        chords = round_part & np.roll(round_part, -1)
        middles = np.linalg.norm((off + np.roll(off, -1, axis=0)) / 2, axis=1)[chords]
        return float(self.radius - middles.min()) if middles.size else 0.0


def holes_of_body(body: Body, bore: float, chord: float) -> tuple[HoleOutline, ...]:
    """Bore and lightening holes of a gear's body.

    Args:
        body: body of the gear.
        bore: diameter of its bore, mm; 0 for none.
        chord: chord error of its mesh, mm.
    """
    lowest = body.slabs[0]
    loops = {hole: None for slab in body.slabs for hole in slab.holes}
    if bore:
        loops[lowest.rings[-1]] = None
    found = []
    for loop in loops:
        round_part = next((curve for curve in loop.curves if isinstance(curve, Arc)), None)
        centre, radius = (0j, 0.0) if round_part is None else (round_part.centre, round_part.radius)
        corners = loop.polygon(chord)
        found.append(HoleOutline(np.stack([corners.real, corners.imag], axis=1), (centre.real, centre.imag), radius))
    return tuple(found)


def holes_of_disc(blank: Blank, chord: float) -> tuple[HoleOutline, ...]:
    """Bore and holes of a disc.

    Args:
        blank: blank of the disc.
        chord: chord error of its mesh, mm.
    """
    found = []
    for contour in blank.inner_contours():
        x, y = (0.0, 0.0) if not contour.is_circle else contour.centers[0].tolist()
        radius = float(contour.radii[0]) if contour.is_circle else blank.bore_diameter / 2
        found.append(HoleOutline(contour.polygon(chord), (x, y), radius))
    return tuple(found)


def compensated(mesh: Mesh, holes: Sequence[HoleOutline], printing: PrintCompensation) -> Mesh:
    """Mesh that a printer turns into the part.

    Args:
        mesh: mesh of the part, its lower face at the least z.
        holes: bores and holes in it.
        printing: what the printer does.

    Raises:
        DesignError: the taper of the foot is wider than an edge of the lower face.
    """
    vertices = np.array(mesh.vertices)
    for hole in holes:
        _move_wall(vertices, hole.corners, _growth(hole, printing))
    mesh = Mesh(vertices, mesh.triangles)
    if printing.foot:
        low = float(vertices[:, 2].min())
        mesh = _moved_foot(_cut(mesh, low + printing.foot_height), low, -printing.foot)
    return Mesh(mesh.vertices * printing.scales, mesh.triangles)


def restored(mesh: Mesh, holes: Sequence[HoleOutline], printing: PrintCompensation) -> Mesh:
    """Mesh of the part from a mesh for the printer, as read from a file.

    Args:
        mesh: mesh as read.
        holes: bores and holes as the part's own mesh has them.
        printing: what the printer does.

    Raises:
        FileError: a hole has not the size that it is printed with.
    """
    mesh = Mesh(mesh.vertices / printing.scales, mesh.triangles)
    if printing.foot:
        mesh = _moved_foot(mesh, float(mesh.vertices[:, 2].min()), printing.foot)
    vertices = np.array(mesh.vertices)
    for hole in holes:
        by = _growth(hole, printing)
        if _move_wall(vertices, hole.corners + _shift(hole.corners, by), -by) < len(hole.corners):
            raise FileError("a mesh for printing has a hole of another size than the design's: write it again")
    return Mesh(vertices, mesh.triangles)


def lower_face(mesh: Mesh) -> tuple[float, float]:
    """Area of the lower face, mm², and the length of its outlines, mm."""
    vertices, triangles = mesh
    flat = triangles[(np.abs(vertices[triangles][:, :, 2] - vertices[:, 2].min()) < _ON_WALL).all(axis=1)]
    area = length = 0.0
    for loop in _boundary(flat, len(vertices)):
        corners = vertices[loop, :2]
        after = np.roll(corners, -1, axis=0)
        area += float(np.sum(corners[:, 0] * after[:, 1] - after[:, 0] * corners[:, 1])) / 2
        length += float(np.linalg.norm(after - corners, axis=1).sum())
    return area, length


def _growth(hole: HoleOutline, printing: PrintCompensation) -> float:
    """By how much a hole's wall moves outwards, mm."""
    return printing.hole / 2 + (hole.sagitta if printing.chords else 0.0)


def _normals(corners: Array) -> Array:
    """Outward normal of each side of a counterclockwise polygon, from its corner to the next, shape (n, 2)."""
    sides = np.roll(corners, -1, axis=0) - corners
    return np.asarray(np.stack([sides[:, 1], -sides[:, 0]], axis=1) / np.linalg.norm(sides, axis=1)[:, None])


def _shift(corners: Array, by: float) -> Array:
    """Shift of each corner of a polygon that moves all sides outwards by a distance, mm, shape (n, 2)."""
    after = _normals(corners)
    before = np.roll(after, 1, axis=0)
    return np.asarray(by * (before + after) / (1 + np.sum(before * after, axis=1))[:, None])


def _move_wall(vertices: Array, corners: Array, by: float) -> int:
    """Move the vertices on the upright wall over a polygon outwards by a distance, mm, in place; how many there are."""
    low, high = corners.min(axis=0) - _ON_WALL, corners.max(axis=0) + _ON_WALL
    near = np.flatnonzero(((vertices[:, :2] >= low) & (vertices[:, :2] <= high)).all(axis=1))
    sides = np.roll(corners, -1, axis=0) - corners
    normals, shift = _normals(corners), _shift(corners, by)
    moves = np.zeros((len(near), 2))
    found = np.full(len(near), np.inf)
    for number, (start, side, normal) in enumerate(zip(corners, sides, normals, strict=True)):
        off = vertices[near, :2] - start
        share = np.clip(off @ side / (side @ side), 0.0, 1.0)
        distance = np.linalg.norm(off - share[:, None] * side, axis=1)
        closer = (distance < found) & (distance < _ON_WALL)
        move = np.where(
            (share < _AT_END)[:, None],
            shift[number],
            np.where((share > 1 - _AT_END)[:, None], shift[(number + 1) % len(corners)], by * normal),
        )
        moves[closer], found[closer] = move[closer], distance[closer]
    vertices[near, :2] += moves
    return int(np.isfinite(found).sum())


def _cut(mesh: Mesh, height: float) -> Mesh:
    """Mesh with corners where its walls pass a height, mm: every triangle across it becomes three."""
    vertices, triangles = mesh
    above = vertices[:, 2] > height
    crossing = np.flatnonzero(above[triangles].any(axis=1) & (vertices[:, 2] < height)[triangles].any(axis=1))
    made: dict[tuple[int, int], int] = {}
    points: list[Array] = []
    pieces: list[tuple[int, int, int]] = []

    def between(one: int, other: int) -> int:
        key = (min(one, other), max(one, other))
        if key not in made:
            first, last = vertices[key[0]], vertices[key[1]]
            share = (height - first[2]) / (last[2] - first[2])
            made[key] = len(vertices) + len(points)
            points.append(np.append((first + share * (last - first))[:2], height))
        return made[key]

    for corners in triangles[crossing].tolist():
        side = np.sign(vertices[corners, 2] - height)
        if 0 in side:  # one corner is on the height: two triangles
            turn = int(np.flatnonzero(side == 0)[0])
            a, b, c = corners[turn:] + corners[:turn]
            middle = between(b, c)
            pieces += [(a, b, middle), (a, middle, c)]
            continue
        turn = int(np.flatnonzero(side == -np.sign(side.sum()))[0])  # the one that is alone
        a, b, c = corners[turn:] + corners[:turn]
        left, right = between(a, b), between(c, a)
        pieces += [(a, left, right), (left, b, c), (left, c, right)]
    kept = np.delete(triangles, crossing, axis=0)
    if not pieces:
        return mesh
    return Mesh(np.vstack([vertices, points]), np.vstack([kept, np.array(pieces)]))


def _moved_foot(mesh: Mesh, low: float, by: float) -> Mesh:
    """Mesh whose lower face has its outlines moved out of the material by a distance, mm; below 0 into it."""
    vertices, triangles = np.array(mesh.vertices), mesh.triangles
    flat = (np.abs(vertices[triangles][:, :, 2] - low) < _ON_WALL).all(axis=1)
    loops = _boundary(triangles[flat], len(vertices))
    moved = []
    for loop in loops:
        corners = vertices[loop, :2]
        shift = _shift(corners, by)
        sides = np.roll(corners, -1, axis=0) - corners
        change = np.roll(shift, -1, axis=0) - shift
        along = np.sum(sides * change, axis=1) / np.sum(sides**2, axis=1)
        if not along.min() > -1:
            raise DesignError(
                "the foot's taper of {foot:g} mm is wider than an edge of the lower face bears; give foot_um = {most}",
                foot=abs(by),
                most=int(_NAMED * 1e3 * abs(by) / -along.min()),
            )
        moved.append(corners + shift)
    for loop, corners in zip(loops, moved, strict=True):
        vertices[loop, :2] = corners
    order = np.concatenate(loops)
    cap = order[np.asarray(triangulate(moved), dtype=np.int64)][:, ::-1]
    return Mesh(vertices, np.vstack([triangles[~flat], cap]))


def _boundary(faces: Triangles, count: int) -> list[NDArray[np.int64]]:
    """Loops of vertices round faces that look down, with the material on the left as seen from above."""
    edges = faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    outer = edges[~np.isin(edges @ [count, 1], edges @ [1, count])]
    after = {end: start for start, end in outer.tolist()}  # turned round, as seen from above
    loops = []
    while after:
        first, following = after.popitem()
        loop = [first]
        while following != first:
            loop.append(following)
            following = after.pop(following)
        loops.append(np.array(loop))
    return loops
