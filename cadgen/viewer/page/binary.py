"""Arrays as one compressed block inside the page, and what the page needs to find them again.

Every array stands at a multiple of four bytes, little-endian. A curve is stored as 32-bit floats. The vertices of a
mesh are stored as 16-bit steps across its box, so a place errs by at most half of a 65535th of the box: 1 µm on 130 mm.
"""

import base64
import gzip
from typing import Any, Literal

import numpy as np

from cadgen.arrays import Array
from cadgen.viewer.page.shading import Shaded

_STEPS = 65535

Kind = Literal["f4", "u2", "u4", "i1"]


class Block:
    """Arrays in the order in which they were added."""

    def __init__(self) -> None:
        self._pieces: list[bytes] = []
        self._size = 0

    def add(self, values: "Array | np.ndarray[Any, Any]", kind: Kind = "f4") -> dict[str, Any]:
        """Add an array, and return where it stands: offset in bytes, number of values, kind.

        Args:
            values: numbers of any shape, stored row by row.
            kind: how they are stored.
        """
        piece = np.ascontiguousarray(values, dtype=f"<{kind}").tobytes()
        place = {"at": self._size, "n": int(np.size(values)), "kind": kind}
        piece += bytes(-len(piece) % 4)
        self._pieces.append(piece)
        self._size += len(piece)
        return place

    def mesh(self, mesh: Shaded) -> dict[str, Any]:
        """Add a mesh with its normals and edges."""
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        step = np.where(high > low, (high - low) / _STEPS, 1.0)
        index: Kind = "u2" if len(mesh.vertices) <= _STEPS else "u4"
        return {
            "low": low.tolist(),
            "step": step.tolist(),
            "vertices": self.add(np.rint((mesh.vertices - low) / step), "u2"),
            "normals": self.add(np.rint(mesh.normals * 127), "i1"),
            "triangles": self.add(mesh.triangles, index),
            "edges": self.add(mesh.edges, index),
        }

    def text(self, level: int) -> str:
        """The whole block, compressed by gzip to a level of 1 to 9, in base 64."""
        return base64.b64encode(gzip.compress(b"".join(self._pieces), level, mtime=0)).decode("ascii")
