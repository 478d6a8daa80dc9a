"""Kinematics of the car along a path: B-splines by control points, curvature of the track, poses, with derivatives."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from cadgen.arrays import Array
from cadgen.car.path.spline import DEGREE, lap_columns, lap_knots, path_knots
from cadgen.car.path.wheel_track import curvatures

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
        """Selection of these places."""
        return Places(self.u[which], self.columns[which], self.values[:, which], self.count)

    @cached_property
    def both(self) -> NDArray[np.intp]:
        """Columns of x and of y in a row of variables that lists all x and then all y, shape (m, 12)."""
        return np.concatenate([self.columns, self.columns + self.count], axis=1)


@dataclass(frozen=True, eq=False)
class Basis:
    """B-splines of degree 5 of a path with `count` control points; a closed path goes on from the last to the first."""

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
        """Place at the start of the path."""
        return self.at(np.zeros(1))

    def even(self, each: int) -> Places:
        """Places at even parameters, `each` of them to a span and the last one."""
        if each not in self._even:
            self._even[each] = self.at(np.linspace(0.0, self.stop, each * self.spans + 1))
        return self._even[each]

    @cached_property
    def _even(self) -> dict[int, Places]:
        return {}


_STEP = 1e-30  # of a complex step, which has no rounding to trade against


@dataclass(frozen=True, eq=False)
class Kinematics:
    """Kinematics of the car along a path, at m places.

    Attributes:
        places: where.
        points: control points, shape (n, 2), mm.
        offset: how far the path runs to the right of the drive wheel, mm.
    """

    places: Places
    points: Array
    offset: float

    @cached_property
    def jets(self) -> Array:
        """Position of the planned point and four derivatives by the parameter, shape (5, m, 2)."""
        return self.places.jets(self.points)

    @cached_property
    def quantities(self) -> Array:
        """Curvature of the drive wheel's track, its first and second derivative by arc length, and the speeds.

        Shape (5, m): the last two are the lengths of track and of planned path for each unit of the parameter, mm.
        """
        return _quantities(self.jets[1:].transpose(0, 2, 1), self.offset)

    @cached_property
    def slopes(self) -> Array:
        """Derivatives of the quantities by the control points of each place, x and then y, shape (5, m, 12)."""
        jets = self.jets[1:].transpose(0, 2, 1)
        values = self.places.values
        by_point = np.zeros((len(self.quantities), len(self.places.u), 2, values.shape[2]))
        for order in range(4):
            for axis in range(2):
                moved = jets.astype(complex)
                moved[order, axis] += 1j * _STEP
                by_jet = _quantities(moved, self.offset).imag / _STEP
                by_point[:, :, axis] += by_jet[:, :, None] * values[order + 1]
        return by_point.reshape(len(self.quantities), len(self.places.u), -1)

    @cached_property
    def ahead(self) -> Array:
        """Direction of travel as unit vectors, shape (m, 2)."""
        along = self.jets[1]
        return np.asarray(along / np.linalg.norm(along, axis=1, keepdims=True))

    @cached_property
    def left(self) -> Array:
        """Unit vectors to the left of the direction of travel, shape (m, 2)."""
        return np.stack([-self.ahead[:, 1], self.ahead[:, 0]], axis=1)

    @cached_property
    def turning(self) -> Array:
        """Derivative of the heading by the control points of each place, x and then y, shape (m, 12)."""
        speed = np.linalg.norm(self.jets[1], axis=1)
        normal = self.left / speed[:, None]
        return np.asarray((normal[:, :, None] * self.places.values[1][:, None, :]).reshape(len(speed), -1))

    def point(self, x: float | Array, y: float | Array) -> Array:
        """Position of a point of the car, x ahead of the planned point and y to its left, shape (m, 2), mm.

        Args:
            x: distance ahead of the planned point, mm.
            y: distance to its left, mm.
        """
        return np.asarray(self.jets[0] + _column(x) * self.ahead + _column(y) * self.left)

    def moved(self, direction: Array, x: float | Array, y: float | Array) -> Array:
        """Derivative of such a point along directions, by the control points of each place, shape (m, 12).

        Args:
            direction: unit vectors, shape (m, 2).
            x: distance of the point ahead of the planned point, mm.
            y: distance to its left, mm.
        """
        shifts = (direction[:, :, None] * self.places.values[0][:, None, :]).reshape(len(direction), -1)
        # A turn moves the point by x to the left and by y backwards.
        lever = np.sum(direction * (_column(x) * self.left - _column(y) * self.ahead), axis=1)
        return np.asarray(shifts + lever[:, None] * self.turning)

    @cached_property
    def track(self) -> Array:
        """Position of the drive wheel, shape (m, 2), mm."""
        return self.point(0.0, self.offset)


def _column(value: float | Array) -> float | Array:
    return value if isinstance(value, int | float) else np.asarray(value)[:, None]


def _quantities(jets: Array, offset: float) -> Array:
    """Quantities of `Kinematics` from four derivatives of the planned path, shape (4, 2, m).

    They are those of `cadgen.car.path.wheel_track`, for real and complex numbers: a complex step differentiates them.
    """
    r1, r2, r3, r4 = jets
    speed = np.sqrt(_dot(r1, r1))
    rate = _dot(r1, r2) / speed
    bend = (_dot(r2, r2) + _dot(r1, r3) - rate**2) / speed
    cross, cross1, cross2 = _cross(r1, r2), _cross(r1, r3), _cross(r2, r3) + _cross(r1, r4)
    k, k_s, k_ss = curvatures(speed, rate, bend, (cross, cross1, cross2))
    shrink = 1.0 - offset * k
    return np.stack(
        [k / shrink, k_s / shrink**3, k_ss / shrink**4 + 3 * offset * k_s**2 / shrink**5, speed * shrink, speed]
    )


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(a[0] * b[0] + a[1] * b[1])


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[0] * b[1] - a[1] * b[0])
