"""The drive wheel's track kept near to a given one."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import KDTree

from cadgen.arrays import Array
from cadgen.car.planner.basis import Basis
from cadgen.car.planner.motion import Motion
from cadgen.car.planner.rows import Limit, LimitKind, Rows

_EACH = 8  # places of a span that are held
_PER_MM = 3.0
_INSIDE = 0.2  # mm that is kept from what is allowed, for what happens between the places


@dataclass(frozen=True, eq=False)
class Near:
    """A track to stay near to.

    Attributes:
        basis: B-splines of the path.
        offset: how far the path runs to the right of the drive wheel, mm.
        track: points of the track, close together, shape (k, 2), mm.
        within: how far the drive wheel may be from it, mm.
    """

    basis: Basis
    offset: float
    track: Array
    within: float

    @cached_property
    def _tree(self) -> KDTree:
        return KDTree(self.track)

    @cached_property
    def _normals(self) -> Array:
        along = np.gradient(self.track, axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        return np.stack([-along[:, 1], along[:, 0]], axis=1)

    def rows(self, points: Array) -> list[Rows]:
        """Constraints of nearness on a path by its control points, shape (n, 2), mm.

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        motion = Motion(self.basis.even(_EACH), points, self.offset)
        _, number = self._tree.query(motion.track)
        normal = self._normals[number]
        off = np.sum(normal * (motion.track - self.track[number]), axis=1)
        by = motion.moved(normal, 0.0, self.offset)
        most, both, u = self.within - min(_INSIDE, self.within / 2), motion.places.both, motion.places.u
        return [Rows(Limit(LimitKind.NEAR), sign * off - most, _PER_MM, both, sign * by, u) for sign in (1.0, -1.0)]
