"""Limits of steering, pressure angle and outline, and of the length of the path."""

from math import inf, tan
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.planner.motion import Motion
from cadgen.car.planner.rows import Limit, LimitKind, Rows
from cadgen.car.planner.sensitivity import Line
from cadgen.car.planner.task import Limits, Vehicle
from cadgen.car.steering import tan_steering

# Cost of each place that is beyond a limit by its whole size, mm of the end of the run; the search raises it.
_WEIGHT = 3.0
# A path whose points are spaced unevenly wastes them; within these shares of the mean speed they serve all of it.
_SLOWEST, _FASTEST, _EVENNESS = 0.75, 1.3, 30.0
_STEP = 1e-30
_STEERING_SHARE = 0.98  # of the tangent of the greatest steering angle
_SHORTER = 1 - 1e-6  # of the greatest length, for rounding


def driving_rows(motion: Motion, line: Line, vehicle: Vehicle, limits: Limits) -> list[Rows]:
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
        _rows(LimitKind.TURN, turn, (by_turn, zero, zero), motion),
        _rows(LimitKind.PRESSURE_ANGLE, pressure, tuple(each[0].imag / _STEP for each in by), motion),
        _rows(LimitKind.CONVEX_RADIUS, convex, tuple(each[1].imag / _STEP for each in by), motion),
    ]
    if limits.valley < inf:
        rows.append(_rows(LimitKind.VALLEY, valley, tuple(each[2].imag / _STEP for each in by), motion))
    for kind, value, limit, order in ((LimitKind.SLOPE, K1, limits.slope, 1), (LimitKind.BEND, K2, limits.bend, 2)):
        if limit < inf:
            sign = np.sign(value) / limit
            rows.append(
                _rows(kind, np.abs(value) / limit, tuple(sign if i == order else zero for i in range(3)), motion)
            )
    return rows


def _step(motion: Motion, line: Line, vehicle: Vehicle, limits: Limits) -> list[Rows]:
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
    return [Rows(Limit(LimitKind.BLEND), value, _WEIGHT, columns, slopes.reshape(1, -1), motion.places.u[[last]])]


def even_rows(motion: Motion) -> list[Rows]:
    """Evenness of the parameter, which keeps the control points spread along the path."""
    speed, slopes = motion.quantities[4], motion.slopes[4]
    mean, places = float(speed.mean()), motion.places
    return [
        Rows(Limit(LimitKind.FAST), speed / mean - _FASTEST, _EVENNESS, places.both, slopes / mean, places.u),
        Rows(Limit(LimitKind.SLOW), _SLOWEST - speed / mean, _EVENNESS, places.both, -slopes / mean, places.u),
    ]


def length_rows(line: Line, vehicle: Vehicle, variables: int) -> list[Rows]:
    """The length of the path, where wheel and train bound it."""
    if vehicle.most_length == inf:
        return []
    over, columns = np.array([line.length - vehicle.most_length * _SHORTER]), np.arange(variables)[None, :]
    return [Rows(Limit(LimitKind.LENGTH), over, _WEIGHT, columns, line.by_points[None, :], np.array([0.0]))]


def _moved(K: Array, K1: Array, K2: Array) -> list[tuple[Any, Any, Any]]:
    """The three with a complex step of each in turn."""
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


def _rows(kind: LimitKind, share: Array, by: tuple[Array, ...], motion: Motion) -> Rows:
    slopes = sum(part[:, None] * motion.slopes[order] for order, part in enumerate(by))
    return Rows(Limit(kind), share - 1.0, _WEIGHT, motion.places.both, np.asarray(slopes), motion.places.u)


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
