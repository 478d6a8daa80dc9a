"""One limit at many places of a path: values that must not be above 0, and their derivatives."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from cadgen.arrays import Array


@dataclass(frozen=True, eq=False)
class Rows:
    """A limit of one kind; values above 0 violate it.

    Attributes:
        name: which limit, such as `turn` or the key of a gate.
        values: by how much each place is beyond the limit, in units of `size`, shape (m,).
        weight: cost of a violation by one, mm of the end of the run.
        columns: variables that each value depends on, shape (m, k).
        slopes: derivatives by these, shape (m, k).
        u: parameters of the places, shape (m,).
    """

    name: str
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

    def reachable(self, step: float) -> "Rows":
        """Places at which a step of the control points of at most `step` (mm) can come to the limit."""
        near = self.values + np.abs(self.slopes).sum(axis=1) * step > 0
        return Rows(self.name, self.values[near], self.weight, self.columns[near], self.slopes[near], self.u[near])

    def matrix(self, variables: int) -> csr_array:
        """The derivatives as a sparse matrix, shape (m, variables)."""
        count, width = self.slopes.shape
        starts = np.arange(0, count * width + 1, width)
        return csr_array((self.slopes.ravel(), self.columns.ravel(), starts), shape=(count, variables))
