"""Meshes and arrays as the page gets them: normals and edges of a mesh, and one compressed block of all arrays.

Normals are smooth within a face of the part. Every array stands at a multiple of four bytes, little-endian. A curve
is stored as 32-bit floats. The vertices of a mesh are stored as 16-bit steps across its box, so a place errs by at most
half of a 65535th of the box: 1 µm on 130 mm.
"""

import base64
import gzip
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.figures import Facts
from cadgen.geometry.meshes.mesh import Mesh

# Triangles that meet at a smaller angle belong to one face of the part. Facets of a tooth's tip circle meet at less.
_CREASE = np.cos(np.radians(28.0))
_CLUSTER = 24  # steps of a normal's coordinate by which the corners at a vertex are told apart


@dataclass(frozen=True)
class Shaded:
    """A mesh to be drawn.

    Attributes:
        vertices: places, shape (n, 3), mm; a place on an edge stands there once for each face.
        normals: unit normals, shape (n, 3).
        triangles: indices of vertices, shape (m, 3).
        edges: indices of vertices, shape (k, 2).
    """

    vertices: Array
    normals: Array
    triangles: NDArray[np.int64]
    edges: NDArray[np.int64]


def shaded(mesh: Mesh) -> Shaded:
    """Normals and edges of a mesh.

    The normal at a corner of a triangle is the mean, weighted by area, of those triangles around the vertex that are
    inclined to it by less than the crease angle.
    """
    points, corners = mesh.vertices, mesh.triangles
    areas = np.cross(points[corners[:, 1]] - points[corners[:, 0]], points[corners[:, 2]] - points[corners[:, 0]])
    size = np.linalg.norm(areas, axis=1)
    flat = areas / np.where(size > 0, size, 1.0)[:, None]
    vertex, face = corners.ravel(), np.repeat(np.arange(len(corners)), 3)
    normals = _smoothed(vertex, face, flat, areas)
    # Corners with one place and nearly one normal become one vertex.
    key = np.column_stack([vertex, np.rint(normals * _CLUSTER).astype(np.int64)])
    _, first, inverse = np.unique(key, axis=0, return_index=True, return_inverse=True)
    return Shaded(points[vertex[first]], normals[first], inverse.reshape(-1, 3), _edges(corners, flat, inverse))


def _smoothed(vertex: NDArray[np.int64], face: NDArray[np.int64], flat: Array, areas: Array) -> Array:
    """Normal of each corner, shape (3 m, 3)."""
    order = np.argsort(vertex, kind="stable")
    counts = np.bincount(vertex)
    start = np.concatenate([[0], np.cumsum(counts)[:-1]])
    # A fan's middle has hundreds of triangles: those within one plane are the rule, and are taken together.
    pairs = counts[vertex]
    left = np.repeat(np.arange(len(vertex)), pairs)
    offset = np.arange(len(left)) - np.repeat(np.cumsum(pairs) - pairs, pairs)
    right = face[order[start[vertex[left]] + offset]]
    near = np.einsum("ij,ij->i", flat[face[left]], flat[right]) > _CREASE
    summed = np.stack(
        [np.bincount(left[near], areas[right[near], axis], len(vertex)) for axis in range(3)],
        axis=1,
    )
    size = np.linalg.norm(summed, axis=1)
    return np.asarray(np.where(size[:, None] > 0, summed / np.where(size > 0, size, 1.0)[:, None], flat[face]))


def _edges(corners: NDArray[np.int64], flat: Array, inverse: NDArray[np.int64]) -> NDArray[np.int64]:
    """Edges at which two triangles meet at more than the crease angle."""
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    at = np.stack([inverse.reshape(-1, 3), np.roll(inverse.reshape(-1, 3), -1, axis=1)], axis=-1).reshape(-1, 2)
    face = np.repeat(np.arange(len(corners)), 3)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    first, second = order[:-1], order[1:]
    same = (ends[first] == ends[second]).all(axis=1)
    sharp = np.einsum("ij,ij->i", flat[face[first]], flat[face[second]]) <= _CREASE
    return np.asarray(at[first[same & sharp]])


_STEPS = 65535

Kind = Literal["f4", "u2", "u4", "i1"]


@dataclass(frozen=True)
class ArrayPlace:
    """Place of an array in a block.

    Attributes:
        at: offset, bytes.
        n: number of values.
        kind: how they are stored.
    """

    at: int
    n: int
    kind: Kind


class ArrayBlock:
    """Arrays in the order in which they were added."""

    def __init__(self) -> None:
        self._pieces: list[bytes] = []
        self._size = 0

    def add(self, values: "Array | np.ndarray[Any, Any]", kind: Kind = "f4") -> ArrayPlace:
        """Add an array, and return where it stands.

        Args:
            values: numbers of any shape, stored row by row.
            kind: how they are stored.
        """
        piece = np.ascontiguousarray(values, dtype=f"<{kind}").tobytes()
        place = ArrayPlace(self._size, int(np.size(values)), kind)
        piece += bytes(-len(piece) % 4)
        self._pieces.append(piece)
        self._size += len(piece)
        return place

    def mesh(self, mesh: Shaded) -> Facts:
        """Add a mesh with its normals and edges, and say where they stand and in which steps."""
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        step = np.where(high > low, (high - low) / _STEPS, 1.0)
        index: Kind = "u2" if len(mesh.vertices) <= _STEPS else "u4"
        return Facts(
            low=low,
            step=step,
            vertices=self.add(np.rint((mesh.vertices - low) / step), "u2"),
            normals=self.add(np.rint(mesh.normals * 127), "i1"),
            triangles=self.add(mesh.triangles, index),
            edges=self.add(mesh.edges, index),
        )

    def text(self, level: int) -> str:
        """The whole block, compressed by gzip to a level of 1 to 9, in base 64."""
        return base64.b64encode(gzip.compress(b"".join(self._pieces), level, mtime=0)).decode("ascii")
