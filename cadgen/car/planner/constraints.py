"""Constraints of a path: values at many places that must not be above 0, and their derivatives.

Those of steering, pressure angle and outline, of the length of the path, and of a corridor along a given track.
"""

from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from math import inf, tan
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.spatial import KDTree

from cadgen.arrays import Array
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_task import SteeringLimits, Vehicle
from cadgen.car.planner.sensitivity import TrackLength
from cadgen.car.steering import tan_steering

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
    CORRIDOR = "near"
    FAST = "fast"
    SLOW = "slow"
    GATE = "gate"
    HEADING = "heading"
    CLEARANCE = "clearance"
    FIELD = "field"


@dataclass(frozen=True)
class PathLimit:
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
class Constraint:
    """Constraint of one limit at many places; values above 0 violate it.

    Attributes:
        limit: limit that they are of.
        values: by how much each place is beyond the limit, in units of `size`, shape (m,).
        weight: cost of a violation by one, mm of the end of the run.
        columns: variables that each value depends on, shape (m, k).
        slopes: derivatives by these, shape (m, k).
        u: parameters of the places, shape (m,).
    """

    limit: PathLimit
    values: Array
    weight: float
    columns: NDArray[np.intp]
    slopes: Array
    u: Array

    @property
    def violation(self) -> float:
        """Sum of what is beyond the limit; of a distance that is kept besides, the most that is missing."""
        if self.limit.spare:
            return max(self.worst, 0.0)
        return float(np.maximum(self.values, 0.0).sum())

    @property
    def worst(self) -> float:
        """Most that is beyond the limit; below 0 if nothing is."""
        return float(self.values.max(initial=-np.inf))

    def tightened(self, spare: float) -> "Constraint":
        """Constraint tightened by a safety margin, where the margin costs little.

        Args:
            spare: the margin, mm.
        """
        limit = replace(self.limit, spare=True)
        return replace(self, limit=limit, values=self.values + spare, weight=self.weight * _SPARE_SHARE)

    def reachable(self, step: float) -> "Constraint":
        """Selection of the places at which a step of the control points of at most `step` (mm) can come to the limit.

        Args:
            step: greatest step of a control point, mm.
        """
        near = self.values + np.abs(self.slopes).sum(axis=1) * step > 0
        return Constraint(
            self.limit, self.values[near], self.weight, self.columns[near], self.slopes[near], self.u[near]
        )

    def matrix(self, variables: int) -> csr_array:
        """The derivatives as a sparse matrix, shape (m, variables)."""
        count, width = self.slopes.shape
        starts = np.arange(0, count * width + 1, width)
        return csr_array((self.slopes.ravel(), self.columns.ravel(), starts), shape=(count, variables))


# Cost of each place that is beyond a limit by its whole size, mm of the end of the run; the search raises it.
_WEIGHT = 3.0
# A path whose points are spaced unevenly wastes them; within these shares of the mean speed they serve all of it.
_SLOWEST, _FASTEST, _EVENNESS = 0.75, 1.3, 30.0
_STEP = 1e-30
_STEERING_SHARE = 0.98  # of the tangent of the greatest steering angle
_SHORTER = 1 - 1e-6  # of the greatest length, for rounding


def driving_constraints(
    motion: Kinematics, line: TrackLength, vehicle: Vehicle, limits: SteeringLimits
) -> list[Constraint]:
    """Limits of steering and cam on the curvature and on its two derivatives."""
    K, K1, K2 = motion.quantities[:3]
    rate = line.rate

    def outline(K: Array, K1: Array, K2: Array) -> tuple[Array, Array, Array]:
        """Shares that pressure angle, convex radius of the rod axis's path, and valley take of their limits."""
        R, R1, R2 = _axis(K, K1, K2, vehicle, rate)
        allowed = np.where(R1.real > 0, tan(limits.rise), tan(limits.fall))
        pressure = np.where(R1.real > 0, R1, -R1) / (R * allowed)
        round_ = limits.convex_radius * (R**2 + 2 * R1**2 - R * R2) / (R**2 + R1**2) ** 1.5
        return pressure, round_, R2 / limits.valley

    pressure, convex, valley = outline(K, K1, K2)
    by = [outline(*moved) for moved in _moved(K, K1, K2)]
    turn = np.where(K > 0, K / limits.left, -K / limits.right)
    by_turn = np.where(K > 0, 1 / limits.left, -1 / limits.right)
    zero = np.zeros_like(K)
    ends = _step(motion, line, vehicle, limits)
    rows = [
        *ends,
        _constraint(LimitKind.TURN, turn, (by_turn, zero, zero), motion),
        _constraint(LimitKind.PRESSURE_ANGLE, pressure, tuple(each[0].imag / _STEP for each in by), motion),
        _constraint(LimitKind.CONVEX_RADIUS, convex, tuple(each[1].imag / _STEP for each in by), motion),
    ]
    if limits.valley < inf:
        rows.append(_constraint(LimitKind.VALLEY, valley, tuple(each[2].imag / _STEP for each in by), motion))
    for kind, value, limit, order in ((LimitKind.SLOPE, K1, limits.slope, 1), (LimitKind.BEND, K2, limits.bend, 2)):
        if limit < inf:
            sign = np.sign(value) / limit
            rows.append(
                _constraint(kind, np.abs(value) / limit, tuple(sign if i == order else zero for i in range(3)), motion)
            )
    return rows


def _step(motion: Kinematics, line: TrackLength, vehicle: Vehicle, limits: SteeringLimits) -> list[Constraint]:
    """Limit of the step that the closing blend must come over."""
    if limits.step == inf:
        return []
    first, last = 0, line.end[0] + round(line.end[1])
    K = motion.quantities[0][[first, last]]
    none = np.zeros(2)
    R = _axis(K, none, none, vehicle, line.rate)[0]
    by = _axis(*_moved(K, none, none)[0], vehicle, line.rate)[0].imag / _STEP
    sign = float(np.sign(R[1] - R[0])) / limits.step
    columns = motion.places.both[[first, last]].reshape(1, -1)
    slopes = (sign * np.array([-1.0, 1.0]) * by)[:, None] * motion.slopes[0][[first, last]]
    value = np.array([abs(float(R[1] - R[0])) / limits.step - 1.0])
    return [
        Constraint(PathLimit(LimitKind.BLEND), value, _WEIGHT, columns, slopes.reshape(1, -1), motion.places.u[[last]])
    ]


def evenness_constraints(motion: Kinematics) -> list[Constraint]:
    """Evenness of the parameter, which keeps the control points spread along the path."""
    speed, slopes = motion.quantities[4], motion.slopes[4]
    mean, places = float(speed.mean()), motion.places
    return [
        Constraint(PathLimit(LimitKind.FAST), speed / mean - _FASTEST, _EVENNESS, places.both, slopes / mean, places.u),
        Constraint(
            PathLimit(LimitKind.SLOW), _SLOWEST - speed / mean, _EVENNESS, places.both, -slopes / mean, places.u
        ),
    ]


def length_constraints(line: TrackLength, vehicle: Vehicle, variables: int) -> list[Constraint]:
    """Constraint on the length of the path, where wheel and train bound it."""
    if vehicle.most_length == inf:
        return []
    over, columns = np.array([line.length - vehicle.most_length * _SHORTER]), np.arange(variables)[None, :]
    return [Constraint(PathLimit(LimitKind.LENGTH), over, _WEIGHT, columns, line.by_points[None, :], np.array([0.0]))]


def _moved(K: Array, K1: Array, K2: Array) -> list[tuple[Any, Any, Any]]:
    """Curvature and its two derivatives with a complex step of each in turn."""
    h = 1j * _STEP
    return [(K + h, K1 + 0j, K2 + 0j), (K + 0j, K1 + h, K2 + 0j), (K + 0j, K1 + 0j, K2 + h)]


def _axis(K: Array, K1: Array, K2: Array, vehicle: Vehicle, rate: float) -> tuple[Array, Array, Array]:
    """Distance of the rod's axis from the camshaft with two derivatives by the cam angle, mm."""
    car = vehicle.car
    T = tan_steering(K, car)
    shrink = 1.0 + car.drive_wheel_offset * K
    slope = -car.wheelbase / shrink**2 / car.steering_gain
    bend = 2 * car.wheelbase * car.drive_wheel_offset / shrink**3 / car.steering_gain
    inner, outer = vehicle.faces
    w = np.where(T.real > 0, inner, outer)
    return (
        vehicle.base_radius + w * T,
        w * slope * K1 * rate,
        w * (slope * K2 + bend * K1**2) * rate**2,
    )


def _constraint(kind: LimitKind, share: Array, by: tuple[Array, ...], motion: Kinematics) -> Constraint:
    slopes = sum(part[:, None] * motion.slopes[order] for order, part in enumerate(by))
    return Constraint(PathLimit(kind), share - 1.0, _WEIGHT, motion.places.both, np.asarray(slopes), motion.places.u)


def curvature_limits(vehicle: Vehicle, smallest: float = 1.0) -> tuple[float, float]:
    """Greatest curvature of the drive wheel's track to the left and to the right that the steering holds, 1/mm.

    Args:
        vehicle: the car.
        smallest: size at which the path is driven, as a share of that which is planned.
    """
    car, share = vehicle.car, _STEERING_SHARE * smallest
    tangent = share * tan(car.max_steering_angle)
    reach = car.wheelbase - car.drive_wheel_offset * tangent
    left = tangent / reach if reach > 0 else inf
    right = tangent / (car.wheelbase + car.drive_wheel_offset * tangent)
    # The planned path must not turn about the drive wheel itself, nor the track about a point of the path.
    offset = vehicle.path_offset
    if offset > 0:
        right = min(right, share / offset)
    elif offset < 0:
        left = min(left, share / -offset)
    return left, right


_CORRIDOR_EACH = 8  # places of a span that are held
_CORRIDOR_PER_MM = 3.0
_CORRIDOR_INSIDE = 0.2  # mm that is kept from what is allowed, for what happens between the places


@dataclass(frozen=True, eq=False)
class Corridor:
    """Corridor along a track in which the drive wheel must stay.

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

    def constraints(self, points: Array) -> list[Constraint]:
        """Constraints of the corridor on a path by its control points, shape (n, 2), mm.

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        motion = Kinematics(self.basis.even(_CORRIDOR_EACH), points, self.offset)
        _, number = self._tree.query(motion.track)
        normal = self._normals[number]
        off = np.sum(normal * (motion.track - self.track[number]), axis=1)
        by = motion.moved(normal, 0.0, self.offset)
        most, both, u = self.within - min(_CORRIDOR_INSIDE, self.within / 2), motion.places.both, motion.places.u
        return [
            Constraint(PathLimit(LimitKind.CORRIDOR), sign * off - most, _CORRIDOR_PER_MM, both, sign * by, u)
            for sign in (1.0, -1.0)
        ]
