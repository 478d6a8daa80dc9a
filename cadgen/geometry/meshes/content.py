"""A mesh measured: whether it is closed, its bodies, volume, and the rim of a disc."""

from dataclasses import dataclass

import numpy as np
import trimesh
from manifold3d import Error

from cadgen.arrays import Array
from cadgen.curves.closed import Outline, cross
from cadgen.curves.polygon import polyline
from cadgen.errors import FileError
from cadgen.geometry.meshes.mesh import Mesh, Triangles

_UPRIGHT = 0.9  # a face whose normal's z is more is horizontal; chamfers have 0.707
_LEVEL = 1e-5  # mm; what the single precision of a file leaves of a height


@dataclass(frozen=True, kw_only=True, slots=True)
class MeshContent:
    """Measurements of a mesh.

    Attributes:
        rim: outline of the disc at its carrying planes, each chord one piece: at z = 0, or where the edges are broken
            at either edge of the land between the chamfers, which are found to be alike.
        watertight: whether trimesh and manifold3d both find it closed, oriented and free of faults.
        bodies: number of connected parts.
        volume: enclosed volume, mm^3.
        wall_area: area of all faces that are not horizontal, mm^2; the volume misses the true one by no more than
            the chord tolerance times this.
    """

    rim: Outline
    watertight: bool
    bodies: int
    volume: float
    wall_area: float


def measured(mesh: Mesh) -> MeshContent:
    """Measure a mesh, as read from a file; its rim is the outline at z = 0.

    Args:
        mesh: mesh with vertices joined.
    """
    return inspect(mesh, np.inf)


def flanks_of(mesh: Mesh, height: float, step: float) -> tuple[Outline, Outline]:
    """Flanks of a groove in the upper face of a disc, the inner one first.

    Args:
        mesh: mesh with vertices joined.
        height: z of the upper face, mm.
        step: largest distance of two points, mm.

    Raises:
        FileError: the face has not the outlines of a disc with a groove.
    """
    flat = (np.abs(mesh.vertices[mesh.triangles][:, :, 2] - height) < _LEVEL).all(axis=1)
    edges = mesh.triangles[flat][:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    count = len(mesh.vertices)
    edges = edges[~np.isin(edges @ [count, 1], edges @ [1, count])]
    loops = []
    while len(edges):
        loops.append(_loop(mesh, edges, height))
        seen = {tuple(corner) for corner in loops[-1].tolist()}
        kept = [tuple(corner) not in seen for corner in mesh.vertices[edges[:, 0]][:, :2].tolist()]
        edges = edges[np.array(kept)]
    if len(loops) < 3:
        raise FileError("the mesh has no groove at z = {height:g}: export it again", height=height)
    return polyline(loops[2], step), polyline(loops[1], step)


def inspect(mesh: Mesh, step: float, land: tuple[float, float] | None = None) -> MeshContent:
    """Measure a mesh, as read from a file.

    Args:
        mesh: mesh with vertices joined.
        step: largest distance of two points of the rim, mm.
        land: heights of the edges of the land between broken edges, mm; None for a rim with sharp edges.

    Raises:
        FileError: the mesh has no closed outline at z = 0, or not the same one at both edges of its land.
    """
    body = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    closed = body.is_watertight and body.is_winding_consistent and mesh.manifold().status() == Error.NoError
    upright = np.abs(body.face_normals[:, 2]) < _UPRIGHT
    return MeshContent(
        rim=polyline(_rim(mesh) if land is None else _land(mesh, land), step),
        watertight=bool(closed),
        bodies=int(body.body_count),
        volume=float(body.volume),
        wall_area=float(body.area_faces[upright].sum()),
    )


def _rim(mesh: Mesh) -> Array:
    """Corners of the outer boundary of the faces at z = 0, counterclockwise, shape (n, 2), mm."""
    flat = (mesh.vertices[mesh.triangles][:, :, 2] == 0).all(axis=1)
    edges = mesh.triangles[flat][:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    count = len(mesh.vertices)
    inner = np.isin(edges @ [count, 1], edges @ [1, count])
    return _loop(mesh, edges[~inner], 0.0)


def _land(mesh: Mesh, heights: tuple[float, float]) -> Array:
    """Corners of the outline at both edges of the land, as `_rim`.

    Raises:
        FileError: an edge of the land has no outline, or the two outlines differ.
    """
    loops = []
    for height, opposite in zip(heights, heights[::-1], strict=True):
        z = mesh.vertices[mesh.triangles][:, :, 2]
        at = np.abs(z - height) < _LEVEL
        # The walls of the land have two corners at one of its edges and the third at the other.
        wall = (at.sum(axis=1) == 2) & (np.abs(z - opposite) < _LEVEL).any(axis=1)
        apex = np.argmin(at[wall], axis=1)
        ends = np.stack([(apex + 1) % 3, (apex + 2) % 3], axis=1)
        loops.append(_loop(mesh, np.take_along_axis(mesh.triangles[wall], ends, axis=1), height))
    low, high = loops
    if low.shape != high.shape or not np.array_equal(low[np.lexsort(low.T)], high[np.lexsort(high.T)]):
        raise FileError("the land between the broken edges of the mesh is not upright: export it again")
    return low


def _loop(mesh: Mesh, edges: Triangles, height: float) -> Array:
    """Corners of the loop of directed edges that holds the point farthest from the axis, counterclockwise."""
    after = dict(edges.tolist())
    if not after:
        raise FileError("the mesh has no face at z = {height:g}: export it again", height=height)
    boundary = np.array(list(after))
    first = int(boundary[np.argmax(np.linalg.norm(mesh.vertices[boundary], axis=1))])
    loop = [first]
    while (following := after.pop(loop[-1], None)) not in (first, None):
        loop.append(following)
    if following is None:
        raise FileError("the outline of the mesh at z = {height:g} is open: export it again", height=height)
    corners = mesh.vertices[loop][:, :2]
    if np.sum(cross(corners, np.roll(corners, -1, axis=0))) < 0:
        corners = corners[::-1]
    return corners
