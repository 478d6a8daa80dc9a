"""A spacing that was drawn, with its setting."""

from dataclasses import dataclass
from math import atan, degrees

import numpy as np

from cadgen.arrays import Array
from cadgen.car.draws.setting_ranges import CarSetting
from cadgen.car.path_motion import PathMotion
from cadgen.car.steering import Car, wheel_tangent
from cadgen.check import Bound, Check, CheckCode, failing
from cadgen.messages import Message

_ROOM = (
    CheckCode.COURSE_POST,
    CheckCode.COURSE_WALL,
    CheckCode.COURSE_ZONE,
    CheckCode.COURSE_EDGE,
    CheckCode.COURSE_GATE_MARGIN,
)


@dataclass(frozen=True, kw_only=True)
class DrawnSpacing:
    """A spacing with its setting.

    Attributes:
        spacing: spacing that is drawn, mm.
        setting: what to set.
        start: planned point at the start, x and y, mm, and heading, rad, as set.
        error: greatest distance of the planned point of the car from the scaled path, mm.
        error_at: travel of the drive wheel up to there, mm.
        end: the same distance at the end of the run, mm.
        end_with_play: greatest distance of the end of the run over the band of play, mm; None where it is not known.
        checks: every figure of cam and course at this spacing.
    """

    spacing: float
    setting: CarSetting
    start: tuple[float, float, float]
    error: float
    error_at: float
    end: float
    end_with_play: float | None
    checks: tuple[Check, ...]

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return failing(self.checks)

    @property
    def room(self) -> float | None:
        """Least room to posts, walls, zones, edge and in gates beyond what must be kept, mm; None without any."""
        return min((each.value - each.limit for each in self.checks if each.code in _ROOM), default=None)

    @property
    def merit(self) -> tuple[float, float]:
        """Sum of what is missing of the limits, and the error: less is better."""
        return sum(abs(each.value - each.limit) for each in self.failed), self.error


def steering_check(lift: PathMotion, cam_angle: Array, car: Car) -> Check:
    """Greatest steering angle at cam angles, rad, against the angle that the fork can turn.

    Args:
        lift: lift of the cam.
        cam_angle: cam angles, rad, shape (n,).
        car: dimensions of the car.
    """
    tangent = np.abs(wheel_tangent(lift.q(cam_angle), car))
    worst = int(np.argmax(tangent))
    return Check(
        CheckCode.STEERING_ANGLE,
        Message("steering angle"),
        degrees(atan(tangent[worst])),
        "°",
        degrees(car.max_steering_angle),
        Bound.MAX,
        Message("cam angle {cam_angle:.1f}°", cam_angle=degrees(cam_angle[worst])),
        Message("raise course.spacing.from_mm, widen the turn there, or raise car.max_steering_angle_deg"),
    )
