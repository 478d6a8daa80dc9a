"""Task of the planner (a car, its limits, a course) and the margins kept after the exact chain has failed a check.

Lengths are in mm, angles in rad.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from math import inf, radians, tan

from cadgen.arrays import Array
from cadgen.car.course.body import CarBody
from cadgen.car.course.layout import Course, Draw
from cadgen.car.steering import Car
from cadgen.check import Check, CheckCode


@dataclass(frozen=True, kw_only=True)
class Vehicle:
    """The car as far as a plan depends on it.

    Attributes:
        car: dimensions in plan view.
        body: outline and wheels.
        path_offset: how far the planned path runs to the right of the drive wheel, mm.
        base_radius: distance of the camshaft from the fork axis, mm.
        faces: distances of the carrying planes of the disc from the fork axis, the nearer one first, mm.
        spread: by how much the return error of a car may differ from the one its cam is cut for, rad.
        travel: travel of the drive wheel for one turn of the cam, mm; None where it follows from the path's length.
        most_length: greatest length of the drive wheel's track, mm.
        path_turn: share of a turn of the cam that the whole path takes, where the travel follows from its length.
        end: share of the path at which the run ends.
        closed: whether the path is a lap that ends as it starts; then its course has the start as its finish, too.
    """

    car: Car
    body: CarBody
    path_offset: float
    base_radius: float
    faces: tuple[float, float]
    spread: float
    travel: float | None = None
    most_length: float = inf
    path_turn: float = 1.0
    end: float = 1.0
    closed: bool = False


@dataclass(frozen=True, kw_only=True)
class SteeringLimits:
    """Limits of the steering and the cam.

    Attributes:
        left: greatest curvature of the drive wheel's track to the left, 1/mm.
        right: the same to the right, 1/mm.
        rise: greatest pressure angle while the lift rises, rad.
        fall: greatest pressure angle while it falls, rad.
        convex_radius: least convex radius of the rod axis's path about the camshaft, mm.
        step: greatest difference of the rod axis's distance from the camshaft between the end of the run and its start,
            mm: the closing blend must come over it.
        slope: greatest slope of the curvature by arc length, 1/mm^2.
        bend: greatest second derivative of the curvature by arc length, 1/mm^3.
        valley: greatest second derivative of the lift by cam angle where it curves upwards, mm: in a valley the lift
            that no profile gives back with play grows with it.
    """

    left: float
    right: float
    rise: float
    fall: float
    convex_radius: float
    step: float = inf
    slope: float = inf
    bend: float = inf
    valley: float = inf


@dataclass(frozen=True, kw_only=True)
class PathTask:
    """A path to be planned.

    Attributes:
        vehicle: the car.
        limits: what its steering and its cam hold.
        course: what it must pass and must not touch. Its start is where the path starts.
        corridor: track of the drive wheel to stay near to, points shape (k, 2), mm, close together; None for a plan
            from scratch.
        within: how far the drive wheel's track may be from `corridor`, mm.
        gate_margin: distance to keep from the edges of the gates, mm.
        spare: distance to keep besides from gates' edges and from obstacles where it costs little, by their keys, mm.
        draw: spacings at which obstacles are kept clear of, too; None where the course has one spacing.
    """

    vehicle: Vehicle
    limits: SteeringLimits
    course: Course
    corridor: Array | None = None
    within: float = inf
    gate_margin: float = 0.0
    spare: Mapping[str, float] = field(default_factory=dict)
    draw: Draw | None = None


_MORE_PRESSURE, _MORE_RADIUS, _MORE_MARGIN = radians(0.5), 0.5, 0.1  # beyond what a check asks for; rad, mm, mm
_FLATTER = radians(2.0)  # rad
_LESS_TURN = 0.99  # beyond what a check asks for
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
class Margins:
    """Margins kept from the limits besides the usual, after the exact chain has failed a check.

    Attributes:
        pressure: rad.
        radius: mm.
        valley: factor on the greatest lift error.
        margin: from obstacles, mm.
        gate: from the edges of the gates, mm.
        blend: how often the step that the closing blend must come over is made smaller.
        turn: factor on the greatest curvature.
    """

    pressure: float = 0.0
    radius: float = 0.0
    valley: float = 1.0
    margin: float = 0.0
    gate: float = 0.0
    blend: int = 0
    turn: float = 1.0

    def after(self, failed: Iterable[Check]) -> "Margins":
        """Margins with which the failed checks pass, as far as the planner has influence on them."""
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
                    # What a larger radius along the run has not cured stands in the closing blend.
                    blend = max(tightening.blend, self.blend + (self.radius > 0))
                    tightening = replace(tightening, radius=tightening.radius + _MORE_RADIUS, blend=blend)
                case CheckCode.BLEND_PRESSURE_ANGLE_RISE | CheckCode.BLEND_PRESSURE_ANGLE_RETURN:
                    tightening = replace(tightening, blend=tightening.blend + 1)
                case CheckCode.STEERING_ANGLE:
                    turn = tightening.turn * _LESS_TURN * tan(radians(check.limit)) / tan(radians(check.value))
                    tightening = replace(tightening, turn=turn)
                case CheckCode.LIFT_ERROR_WITH_PLAY:
                    tightening = replace(tightening, valley=tightening.valley * 0.8 * check.limit / check.value)
                case code if code in _CLEARANCES:
                    tightening = replace(tightening, margin=tightening.margin + beyond + _MORE_MARGIN)
                case code if code in _PASSED:
                    tightening = replace(tightening, gate=tightening.gate + beyond + _MORE_MARGIN)
        return tightening

    def larger(self, other: "Margins") -> "Margins":
        """Larger of this and another, quantity by quantity."""
        return Margins(
            pressure=max(self.pressure, other.pressure),
            radius=max(self.radius, other.radius),
            valley=min(self.valley, other.valley),
            margin=max(self.margin, other.margin),
            gate=max(self.gate, other.gate),
            blend=max(self.blend, other.blend),
            turn=min(self.turn, other.turn),
        )
