"""The three-wheeled car: curvature of its track by the steering angle, and the inverse.

The steering angle of this and all later rooms is beta, the angle of the rod, which the cam sets. On a car as designed
the front wheel has the same angle; on a car as built its angle beta_w may differ,
    tan(beta_w) = tan(atan(g tan(beta)) + beta_0),
and where the car turns its drive wheel may slip: with r the travel of the rim and s that of the wheel,
    ds/dr = p = 1 - slip |tan(beta_w)|    (`travel_ratio`).
The cam turns in proportion to r, so steering known by s is converted to steering by r (`rim_travel`, `by_rim`).
"""

from dataclasses import dataclass
from math import degrees, tan

import numpy as np

from cadgen.arrays import Array, gauss_nodes
from cadgen.car.path.wheel_track import Track
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError
from cadgen.messages import Message


@dataclass(frozen=True, kw_only=True)
class Car:
    """The car in plan view (paper, figure 4 and table 1).

    Attributes:
        wheelbase: distance L from the front fork axis to the rear axle, mm.
        drive_wheel_offset: distance A1 from the fork axis to the driven wheel, to the left, mm.
        idle_wheel_offset: distance A2 from the fork axis to the idle wheel, to the right, mm.
        max_steering_angle: greatest angle of the front wheel to either side, rad.
        steering_zero: angle beta_0 of the front wheel where the rod is straight, rad.
        steering_gain: gain g of the lever between rod and front wheel; negative where the cam is right of the fork
            axis, and lifts the rod in a left turn.
        slip: share of the rim's travel that is lost for each unit of |tan(beta_w)|.
    """

    wheelbase: float
    drive_wheel_offset: float
    idle_wheel_offset: float
    max_steering_angle: float
    steering_zero: float = 0.0
    steering_gain: float = 1.0
    slip: float = 0.0


def wheel_tangent(tan_beta: Array, car: Car) -> Array:
    """Tangent of the front wheel's angle, tan(atan(g T) + beta_0), from the rod's T by the addition theorem.

    Args:
        tan_beta: tangents of the rod's steering angle, shape (n,).
        car: dimensions of the car.
    """
    if car.steering_gain == 1 and car.steering_zero == 0:
        return tan_beta
    geared, zero = car.steering_gain * tan_beta, tan(car.steering_zero)
    return (geared + zero) / (1.0 - geared * zero)


def travel_ratio(tan_beta: Array, car: Car) -> Array:
    """Travel of the drive wheel for each mm that its rim turns, 1 - slip |tan(beta_w)|, from the rod's tan(beta).

    Args:
        tan_beta: tangents of the rod's steering angle, shape (n,).
        car: dimensions of the car.
    """
    return wheel_travel_ratio(wheel_tangent(tan_beta, car), car)


def wheel_travel_ratio(wheel: Array, car: Car) -> Array:
    """Travel of the drive wheel for each mm that its rim turns, from the front wheel's tan(beta_w).

    Args:
        wheel: tangents of the front wheel's angle.
        car: dimensions of the car.
    """
    return 1.0 - car.slip * np.abs(wheel)


def tan_steering(curvature: Array, car: Car) -> Array:
    """Tangent of the rod's steering angle from the signed curvature of the drive wheel's track, mm^-1.

    tan(beta_w) = L k_r / (1 - A1 k_r) with k_r = -curvature (eq. 17-19 with signs; right turns have beta > 0).

    Args:
        curvature: signed curvatures of the drive wheel's track, mm^-1.
        car: dimensions of the car.
    """
    wheel = -car.wheelbase * curvature / (1.0 + car.drive_wheel_offset * curvature)
    zero = tan(car.steering_zero)
    return (wheel - zero) / (1.0 + wheel * zero) / car.steering_gain


def track_curvature(tan_beta: Array, car: Car) -> Array:
    """Signed curvature of the drive wheel's track, mm^-1, from the rod's tan(beta): the inverse of `tan_steering`.

    Args:
        tan_beta: tangents of the rod's steering angle, shape (n,).
        car: dimensions of the car.
    """
    return wheel_curvature(wheel_tangent(tan_beta, car), car)


def wheel_curvature(wheel: Array, car: Car) -> Array:
    """Signed curvature of the drive wheel's track, mm^-1, from the front wheel's tan(beta_w) (eq. 21 with signs).

    Args:
        wheel: tangents of the front wheel's angle.
        car: dimensions of the car.
    """
    return -wheel / (car.wheelbase + car.drive_wheel_offset * wheel)


def steering_jets(track: Track, car: Car) -> Array:
    """Jets of the rod's tan(beta) and two derivatives by the track's arc length at the track's nodes, shape (n, 3).

    Raises:
        DesignError: the path turns tighter than the steering can hold, with the place.
    """
    k, k1, k2 = track.curvature_jets.T
    divisor = 1.0 + car.drive_wheel_offset * k
    # Where the divisor is not positive, the turn's centre lies at or left of the fork: more than 90 degrees.
    holds = (divisor > 0) & (
        car.wheelbase * np.abs(k) <= np.tan(car.max_steering_angle) * np.where(divisor > 0, divisor, 1.0)
    )
    if not holds.all():
        strain = np.where(divisor > 0, np.abs(k) / np.maximum(divisor, 1e-300), np.inf)
        worst = int(np.argmax(np.where(holds, 0.0, strain)))
        left = bool(k[worst] > 0)
        tightest = car.wheelbase / tan(car.max_steering_angle)
        tightest += -car.drive_wheel_offset if left else car.drive_wheel_offset
        raise DesignError(
            "the drive wheel turns {side} with a radius of {radius:.0f} mm {where}; steering of "
            "{most:.0f} degrees holds no less than {tightest:.0f} mm there: lead the path "
            "through a wider turn ({points_key}), or raise car.max_steering_angle_deg",
            side=Message("left") if left else Message("right"),
            radius=1 / abs(k[worst]),
            where=track.where(track.arc[worst]),
            most=degrees(car.max_steering_angle),
            tightest=tightest,
            points_key=track.points_key,
        )
    slope = -car.wheelbase / divisor**2
    bend = 2 * car.wheelbase * car.drive_wheel_offset / divisor**3
    wheel1, wheel2 = slope * k1, slope * k2 + bend * k1**2
    # From the wheel to the rod: first and second derivative of `tan_steering`'s last line.
    zero = tan(car.steering_zero)
    away = 1.0 + zero * -car.wheelbase * k / divisor
    rod1 = (1.0 + zero**2) / away**2 / car.steering_gain
    rod2 = -2 * zero * rod1 / away
    return np.stack([tan_steering(k, car), rod1 * wheel1, rod1 * wheel2 + rod2 * wheel1**2], axis=1)


GAUSS_POINTS = 8  # between two nodes of the track, some 12 mm: exact to rounding but where the steering changes sign


def rim_travel(arc: Array, jets: Array, car: Car) -> Array:
    """Travel of the rim at the nodes of a track, shape (n,), mm.

    Args:
        arc: arc length of the track at the nodes, not decreasing, shape (n,), mm.
        jets: tan(beta) of the rod with two derivatives by arc, shape (n, 3).
        car: dimensions, lever and slip of the car.

    Raises:
        DesignError: somewhere the wheel slips so much that it does not get ahead.
    """
    if car.slip == 0:
        return arc
    nodes, weights = gauss_nodes(GAUSS_POINTS)
    half = np.diff(arc)[:, None] / 2
    left = travel_ratio(quintic_hermite(arc, jets)(arc[:-1, None] + half * (nodes + 1)), car)
    if not left.min() > 0:
        raise DesignError(
            "with a slip of {slip:g} % for each unit of tan(beta) the drive wheel would not get ahead in "
            "the tightest turn: lower slip_percent in [as_built], or widen the turn",
            slip=100 * car.slip,
        )
    return np.append(0.0, np.cumsum((1 / left @ weights)[:, None] * half))


def by_rim(jets: Array, car: Car) -> Array:
    """Jets of the rod's tan(beta) by the travel of the rim, from those by the travel of the wheel, shape (n, 3).

    Args:
        jets: tan(beta) with its first two derivatives by the travel of the wheel, in mm, shape (n, 3).
        car: dimensions of the car.
    """
    T, T1, T2 = jets.T
    p = travel_ratio(T, car)
    wheel, zero = wheel_tangent(T, car), np.tan(car.steering_zero)
    # d tan(beta_w) / dT of the addition theorem.
    turned = car.steering_gain * (1 + zero**2) / (1 - car.steering_gain * T * zero) ** 2
    p1 = -car.slip * np.sign(wheel) * turned * T1
    return np.stack([T, T1 * p, T2 * p**2 + T1 * p * p1], axis=1)
