"""The follower: a straight round rod that leans with the steering, on a disc with two faces."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Follower:
    """The rod and where the disc's faces cross it.

    The rod's axis lies in the horizontal plane of the camshaft and turns about the fork axis A. In the plane at
    lateral distance w from A its section is an ellipse centred base_radius + w tan(beta) from the camshaft, with
    semi-axis radius / cos(beta) along that distance and radius across it.

    Attributes:
        base_radius: a, distance of the camshaft from the fork axis, mm.
        inner: lateral distance of the disc's inner face from A, mm.
        outer: lateral distance of the outer face, mm.
        radius: r_t, of the rod, mm; zero stands for the rod's axis (a knife edge).
    """

    base_radius: float
    inner: float
    outer: float
    radius: float

    @property
    def thickness(self) -> float:
        """Thickness of the disc, mm."""
        return self.outer - self.inner

    def contact_face(self, tan_beta: Array) -> Array:
        """Lateral distance of the face the rod rests on, mm: inner for beta >= 0, outer below (eq. 15)."""
        return np.where(np.asarray(tan_beta) >= 0, self.inner, self.outer)

    def lift(self, tan_beta: Array) -> Array:
        """Lift s = w_contact tan(beta), mm (eq. 16)."""
        return self.contact_face(tan_beta) * tan_beta
