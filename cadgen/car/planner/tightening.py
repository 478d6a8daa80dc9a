"""Distances that a plan keeps from its limits besides the usual, for what the exact chain finds beyond first order."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import radians

from cadgen.check import Check, CheckCode

_MORE_PRESSURE, _MORE_RADIUS, _MORE_MARGIN = radians(0.5), 0.5, 0.1  # beyond what a check asks for; rad, mm, mm
_FLATTER = radians(2.0)  # rad
_CLEARANCES = (
    CheckCode.COURSE_POST,
    CheckCode.COURSE_WALL,
    CheckCode.COURSE_ZONE,
    CheckCode.COURSE_EDGE,
    CheckCode.COURSE_POST_PLAY,
    CheckCode.COURSE_WALL_PLAY,
    CheckCode.COURSE_ZONE_PLAY,
    CheckCode.COURSE_EDGE_PLAY,
)
_PASSED = (
    CheckCode.COURSE_GATE_MARGIN,
    CheckCode.COURSE_FINISH,
    CheckCode.COURSE_GATE_MARGIN_PLAY,
    CheckCode.COURSE_FINISH_PLAY,
)


@dataclass(frozen=True)
class Tightening:
    """Distance kept from the limits besides the usual, after the exact chain has failed a check.

    Attributes:
        pressure: rad.
        radius: mm.
        valley: factor on the greatest lift error.
        margin: from obstacles, mm.
        gate: from the edges of the gates, mm.
        blend: how often the step that the closing blend must come over is made smaller.
    """

    pressure: float = 0.0
    radius: float = 0.0
    valley: float = 1.0
    margin: float = 0.0
    gate: float = 0.0
    blend: int = 0

    def after(self, failed: Iterable[Check]) -> "Tightening":
        """Distances to keep besides, so that checks pass on which the planner has influence."""
        tightening = self
        for check in failed:
            beyond = abs(check.value - check.limit)
            match check.code:
                case CheckCode.PRESSURE_ANGLE_RISE | CheckCode.PRESSURE_ANGLE_RETURN:
                    pressure = tightening.pressure + radians(beyond) + _MORE_PRESSURE
                    tightening = replace(tightening, pressure=pressure)
                case CheckCode.LOST_LIFT_FACE_CHANGE:  # it grows with the square of the slope
                    tightening = replace(tightening, pressure=tightening.pressure + _FLATTER)
                case CheckCode.CONVEX_RADIUS_THEORY | CheckCode.CONVEX_RADIUS_PROFILE | CheckCode.LOST_LIFT_UNDERCUT:
                    tightening = replace(tightening, radius=tightening.radius + _MORE_RADIUS)
                case CheckCode.BLEND_PRESSURE_ANGLE_RISE | CheckCode.BLEND_PRESSURE_ANGLE_RETURN:
                    tightening = replace(tightening, blend=tightening.blend + 1)
                case CheckCode.LIFT_ERROR_WITH_PLAY:
                    tightening = replace(tightening, valley=tightening.valley * 0.8 * check.limit / check.value)
                case code if code in _CLEARANCES:
                    tightening = replace(tightening, margin=tightening.margin + beyond + _MORE_MARGIN)
                case code if code in _PASSED:
                    tightening = replace(tightening, gate=tightening.gate + beyond + _MORE_MARGIN)
        return tightening

    def larger(self, other: "Tightening") -> "Tightening":
        """The larger of this and another, in each quantity."""
        return Tightening(
            pressure=max(self.pressure, other.pressure),
            radius=max(self.radius, other.radius),
            valley=min(self.valley, other.valley),
            margin=max(self.margin, other.margin),
            gate=max(self.gate, other.gate),
            blend=max(self.blend, other.blend),
        )
