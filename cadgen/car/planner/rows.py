"""One limit at many places of a path: values that must not be above 0, and their derivatives."""

from dataclasses import dataclass, replace
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from cadgen.arrays import Array

_SPARE_SHARE = 0.1  # of the weight of a limit, for a distance that is kept besides


class LimitKind(StrEnum):
    """Kind of a limit of a path."""

    TURN = "turn"
    BLEND = "blend"
    PRESSURE_ANGLE = "pressure angle"
    CONVEX_RADIUS = "convex radius"
    VALLEY = "valley"
    SLOPE = "slope"
    BEND = "bend"
    LENGTH = "length"
    NEAR = "near"
    FAST = "fast"
    SLOW = "slow"
    GATE = "gate"
    HEADING = "heading"
    CLEARANCE = "clearance"
    FIELD = "field"


@dataclass(frozen=True)
class Limit:
    """A limit of a path.

    Attributes:
        kind: kind of limit.
        key: gate, start, finish, obstacle or field that it belongs to, as in the design file; empty if to none.
        spare: whether it is a distance that is kept besides a limit, and gives way before the limit does.
    """

    kind: LimitKind
    key: str = ""
    spare: bool = False

    def __str__(self) -> str:
        """Name of the limit for people."""
        if self.kind == LimitKind.HEADING:
            return f"{self.key} heading"
        return self.key or self.kind


@dataclass(frozen=True, eq=False)
class Rows:
    """A limit of one kind; values above 0 violate it.

    Attributes:
        limit: limit that they are of.
        values: by how much each place is beyond the limit, in units of `size`, shape (m,).
        weight: cost of a violation by one, mm of the end of the run.
        columns: variables that each value depends on, shape (m, k).
        slopes: derivatives by these, shape (m, k).
        u: parameters of the places, shape (m,).
    """

    limit: Limit
    values: Array
    weight: float
    columns: NDArray[np.intp]
    slopes: Array
    u: Array

    @property
    def violation(self) -> float:
        """Sum of what is beyond the limit."""
        return float(np.maximum(self.values, 0.0).sum())

    @property
    def worst(self) -> float:
        """Most that is beyond the limit; below 0 if nothing is."""
        return float(self.values.max(initial=-np.inf))

    def spared(self, spare: float) -> "Rows":
        """The same limit nearer by a distance that is kept where it costs little.

        Args:
            spare: the distance, mm.
        """
        limit = replace(self.limit, spare=True)
        return replace(self, limit=limit, values=self.values + spare, weight=self.weight * _SPARE_SHARE)

    def reachable(self, step: float) -> "Rows":
        """Places at which a step of the control points of at most `step` (mm) can come to the limit.

        Args:
            step: greatest step of a control point, mm.
        """
        near = self.values + np.abs(self.slopes).sum(axis=1) * step > 0
        return Rows(self.limit, self.values[near], self.weight, self.columns[near], self.slopes[near], self.u[near])

    def matrix(self, variables: int) -> csr_array:
        """The derivatives as a sparse matrix, shape (m, variables)."""
        count, width = self.slopes.shape
        starts = np.arange(0, count * width + 1, width)
        return csr_array((self.slopes.ravel(), self.columns.ravel(), starts), shape=(count, variables))
