"""B-splines of degree 5 over the knots of a planned path, and their derivatives, at parameters."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from cadgen.arrays import Array
from cadgen.car.path.spline import DEGREE, lap_columns, lap_knots, path_knots

ORDERS = 5  # a value and four derivatives
LOCAL = DEGREE + 1  # B-splines that do not vanish at a parameter


@dataclass(frozen=True, eq=False)
class Places:
    """Parameters of a path with the B-splines that do not vanish there.

    Attributes:
        u: parameters, shape (m,).
        columns: numbers of the six control points that each place depends on, shape (m, 6).
        values: their B-splines and four derivatives by u, shape (5, m, 6).
        count: number of control points.
    """

    u: Array
    columns: NDArray[np.intp]
    values: Array
    count: int

    def jets(self, points: Array) -> Array:
        """Position and four derivatives by u of a path by its control points in mm, shape (5, m, 2).

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        return np.asarray(np.einsum("oml,mlc->omc", self.values, points[self.columns]))

    def __getitem__(self, which: NDArray[np.intp] | NDArray[np.bool_]) -> "Places":
        """Some of the places."""
        return Places(self.u[which], self.columns[which], self.values[:, which], self.count)

    @cached_property
    def both(self) -> NDArray[np.intp]:
        """Columns of x and of y in a row of variables that lists all x and then all y, shape (m, 12)."""
        return np.concatenate([self.columns, self.columns + self.count], axis=1)


@dataclass(frozen=True, eq=False)
class Basis:
    """All B-splines of a path with `count` control points; a closed one goes on from the last to the first."""

    count: int
    closed: bool = False

    @property
    def spans(self) -> int:
        """Number of spans between knots."""
        return self.count if self.closed else self.count - DEGREE

    @property
    def stop(self) -> float:
        """Last parameter."""
        return float(self.spans)

    @cached_property
    def _orders(self) -> tuple[BSpline, ...]:
        knots = lap_knots(self.count) if self.closed else path_knots(self.count)
        spline = BSpline(knots, np.eye(self.spans + DEGREE), DEGREE)
        return tuple(spline.derivative(order) if order else spline for order in range(ORDERS))

    def at(self, u: Array) -> Places:
        """B-splines at parameters, shape (m,).

        Args:
            u: parameters, shape (m,).
        """
        first = np.clip(np.floor(u).astype(np.intp), 0, self.spans - 1)
        number = first[:, None] + np.arange(LOCAL)
        values = np.stack([np.take_along_axis(order(u), number, axis=1) for order in self._orders])
        columns = lap_columns(number, self.count) if self.closed else number
        return Places(u, columns, values, self.count)

    @cached_property
    def first(self) -> Places:
        """The start of the path."""
        return self.at(np.zeros(1))

    def even(self, each: int) -> Places:
        """Places at even parameters, `each` of them to a span and the last one."""
        return self.at(np.linspace(0.0, self.stop, each * self.spans + 1))
