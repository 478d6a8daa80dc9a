"""The three-wheeled car: which steering angle drives which curvature."""

from dataclasses import dataclass
from math import degrees, tan

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import DesignError
from cadgen.path.track import Track

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Car:
    """The car in plan view (paper, figure 4 and table 1).

    Attributes:
        wheelbase: L, front fork axis to rear axle, mm.
        drive_wheel_offset: A1, fork axis to the left (driven) wheel, mm.
        idle_wheel_offset: A2, fork axis to the right (idle) wheel, mm.
        max_steering_angle: what the fork can turn to either side, rad.
    """

    wheelbase: float
    drive_wheel_offset: float
    idle_wheel_offset: float
    max_steering_angle: float


def tan_steering(curvature: Array, car: Car) -> Array:
    """Tangent of the steering angle for a signed curvature of the drive wheel's track.

    tan(beta) = L k_r / (1 - A1 k_r) with k_r = -curvature (eq. 17-19 with signs; right turns have beta > 0).
    """
    return -car.wheelbase * curvature / (1.0 + car.drive_wheel_offset * curvature)


def track_curvature(tan_beta: Array, car: Car) -> Array:
    """Signed curvature of the drive wheel's track for a steering angle, the inverse of `tan_steering`."""
    return -tan_beta / (car.wheelbase + car.drive_wheel_offset * tan_beta)


def steering_jets(track: Track, car: Car) -> Array:
    """tan(beta) with two derivatives by the track's arc length at the track's nodes, shape (n, 3).

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
        side = "left" if k[worst] > 0 else "right"
        tightest = car.wheelbase / tan(car.max_steering_angle)
        tightest += -car.drive_wheel_offset if side == "left" else car.drive_wheel_offset
        raise DesignError(
            f"the drive wheel turns {side} with a radius of {1 / abs(k[worst]):.0f} mm "
            f"{track.where(track.arc[worst])}; steering of {degrees(car.max_steering_angle):.0f} degrees holds "
            f"no less than {tightest:.0f} mm there: move the waypoints to a wider turn, or raise "
            f"car.max_steering_angle_deg"
        )
    slope = -car.wheelbase / divisor**2
    bend = 2 * car.wheelbase * car.drive_wheel_offset / divisor**3
    return np.stack([tan_steering(k, car), slope * k1, slope * k2 + bend * k1**2], axis=1)
