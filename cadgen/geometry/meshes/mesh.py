"""A closed mesh of triangles, and its conversion to a solid of manifold3d and back."""

from typing import NamedTuple

import numpy as np
from manifold3d import CrossSection, Error, Manifold, Mesh64
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import FileError
from cadgen.parts.body import RadialHole

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
            raise FileError(f"the mesh of a gear is not closed ({solid.status().name}); choose another chord tolerance")
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
