"""The leaning rod: a straight round rod that leans with the steering, on the two edges of a disc's rim."""

from dataclasses import dataclass
from math import inf

import numpy as np

from cadgen.arrays import Array


@dataclass(frozen=True, kw_only=True)
class RodGeometry:
    """The rod and the two planes in which the disc carries it.

    The rod leans, so it rides on an edge of the rim: on that of a face or, where the edges are broken by chamfers, on
    that of the land between them (`cadgen.parts.blank.Blank.carrying`).

    The rod's axis lies in the horizontal plane of the camshaft and turns about the fork axis A. In the plane at
    lateral distance w from A its section is an ellipse centred base_radius + w tan(beta) from the camshaft, with
    semi-axis radius / cos(beta) along that distance and radius across it.

    Attributes:
        base_radius: a, distance of the camshaft from the fork axis, mm.
        inner: lateral distance from A of the carrying plane nearer to it, mm.
        outer: lateral distance of the farther carrying plane, mm.
        radius: r_t, of the rod, mm; zero stands for the rod's axis (a knife edge).
        length: from the fork axis to the rod's end, mm.
    """

    base_radius: float
    inner: float
    outer: float
    radius: float
    length: float = inf

    @property
    def land(self) -> float:
        """Width of the rim between the carrying planes, mm."""
        return self.outer - self.inner

    def contact_face(self, q: Array) -> Array:
        """Lateral distance of the plane the rod rests in, mm: inner for beta >= 0, outer below (eq. 15).

        Args:
            q: tangents of the rod's steering angle, shape (n,).
        """
        return np.where(np.asarray(q) >= 0, self.inner, self.outer)

    def lift(self, q: Array) -> Array:
        """Lift s = w_contact tan(beta), mm (eq. 16).

        Args:
            q: tangents of the rod's steering angle, shape (n,).
        """
        return self.contact_face(q) * q


def rod_half_width(radius: float, T: Array, T1: Array, T2: Array) -> tuple[Array, Array, Array]:
    """The section's semi-axis r / cos(beta) = r sqrt(1 + T^2), mm, with two derivatives.

    Args:
        radius: radius r of the rod, mm.
        T: tan(beta), shape (n,).
        T1: its first derivative by the cam angle, 1/rad.
        T2: its second derivative, 1/rad².
    """
    root = np.sqrt(1.0 + T**2)
    return radius * root, radius * T * T1 / root, radius * (T1**2 / root**3 + T * T2 / root)
