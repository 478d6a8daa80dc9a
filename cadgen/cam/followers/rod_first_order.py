"""Change of the steering, to first order, as disc, faces and rod change.

The rod, at T = tan(beta), rests on a point of the disc at
    x = a + w T - h sqrt(1 + T^2),  h^2 = r^2 - y^2,
x along the ray from the camshaft to the rod, y across it in the sense of growing polar angle, w the lateral distance of
the edge that carries it. No point asks for more, so to first order the point stays the same one, and with
D = w - h T / sqrt(1 + T^2)
    dT = (dx - sqrt(1 + T^2) (y / h) dy - da - T dw + sqrt(1 + T^2) (r / h) dr) / D,
where dx, dy and dw are how far the point itself is displaced.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import Contact
from cadgen.cam.followers.rod_geometry import RodGeometry


@dataclass(frozen=True)
class FirstOrder:
    """Derivatives of T = tan(beta) at n cam angles.

    Attributes:
        height: h, half the rod's height at the contact, shape (n,), mm.
        root: sqrt(1 + T^2), shape (n,).
        lean: sqrt(1 + T^2) y / h, shape (n,).
        divisor: D, shape (n,), mm.
        face: dT/dw, shape (n,), 1/mm.
        thicker: dT/dr, shape (n,), 1/mm.
    """

    height: Array
    root: Array
    lean: Array
    divisor: Array
    face: Array
    thicker: Array

    @classmethod
    def of(cls, contact: Contact, follower: RodGeometry) -> "FirstOrder":
        """At the contacts of a rod, or of a point at its axis, with a disc."""
        T, w, y = contact.q, contact.face, contact.across
        root, height = np.sqrt(1 + T**2), np.sqrt(follower.radius**2 - y**2)
        thick = follower.radius > 0
        stretch = follower.radius / height if thick else np.ones_like(T)
        lean = root * y / height if thick else np.zeros_like(T)
        divisor = w - height * T / root
        return cls(height, root, lean, divisor, -T / divisor, root * stretch / divisor)

    def displaced(self, along: Array, across: Array) -> Array:
        """Change of T with a displacement of the point along the ray and across it, both in mm, shape (n,).

        Args:
            along: displacements outwards along the ray, mm, shape (n,).
            across: displacements across it, mm, shape (n,).
        """
        return np.asarray((along - self.lean * across) / self.divisor)
