"""From a design to what the numeric rooms work on; the one place where degrees become radians and µm mm."""

from math import radians

import numpy as np

from cadgen.cam import blank as cut
from cadgen.cam.checks import CheckLimits
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve, lift_curve
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS
from cadgen.design.blank import Blank, Hub, Lightening
from cadgen.design.schema import Design
from cadgen.path.spline import PlannedPath, plan_path
from cadgen.path.track import Track, offset_track
from cadgen.steering.car import Car, steering_jets

# A rod this many times as long as the outer face is far reaches past it up to some 55 degrees of steering.
_DEFAULT_REACH = 2.0


def planned_path(design: Design) -> PlannedPath:
    """The spline through the waypoints.

    Raises:
        DesignError: two equal neighbours among the waypoints.
    """
    return plan_path(np.array(design.path.waypoints_mm), design.path.spline)


def track(design: Design) -> Track:
    """The drive wheel's track.

    Raises:
        DesignError: as `planned_path`, or the track has a cusp.
    """
    return offset_track(planned_path(design), design.path.offset_mm)


def car(design: Design) -> Car:
    """The car in plan view."""
    return Car(
        wheelbase=design.car.wheelbase_mm,
        drive_wheel_offset=design.car.drive_wheel_offset_mm,
        idle_wheel_offset=design.car.idle_wheel_offset_mm,
        max_steering_angle=radians(design.car.max_steering_angle_deg),
    )


def follower(design: Design) -> Follower:
    """The rod and the disc's faces."""
    inner, outer = design.cam.faces_mm
    return Follower(base_radius=design.cam.base_radius_mm, inner=inner, outer=outer, radius=design.follower.radius_mm)


def lift(design: Design, driven: Track | None = None) -> LiftCurve:
    """The steering that one turn of the cam must give, closed by the blend.

    Args:
        design: the design.
        driven: its track, if that is at hand already.

    Raises:
        DesignError: as `track`, or a turn tighter than the steering can hold.
    """
    road = driven or track(design)
    return lift_curve(road.arc, steering_jets(road, car(design)), road.length, blend=radians(design.cam.blend_deg))


def blank(design: Design) -> cut.CamBlank:
    """What the disc has besides its profile."""
    given = design.blank
    return cut.CamBlank(
        bore_diameter=given.bore_diameter_mm,
        key=_key(given),
        hub=_hub(given.hub) if given.hub else None,
        lightening=_lightening(given.lightening) if given.lightening else None,
    )


def check_limits(design: Design) -> CheckLimits:
    """What the checks allow."""
    return CheckLimits(
        pressure_angle=PRESSURE_ANGLE_LIMITS[design.checks.pressure_angle_limit],
        lost_lift=design.checks.lost_lift_limit_um * 1e-3,
        min_convex_radius=design.checks.min_convex_radius_mm,
        cutter_radius=design.machining.cutter_diameter_mm / 2,
        rod_length=_rod_length(design),
        wall=design.checks.min_wall_mm,
    )


def _rod_length(design: Design) -> float:
    given = design.follower.length_mm
    return _DEFAULT_REACH * design.cam.faces_mm[1] if given is None else given


def _key(given: Blank) -> cut.Keyway | cut.DFlat | None:
    if given.keyway:
        key = given.keyway
        return cut.Keyway(width=key.width_mm, depth=key.depth_mm, angle=radians(key.angle_deg))
    if given.d_flat:
        flat = given.d_flat
        return cut.DFlat(depth=given.bore_diameter_mm - flat.across_mm, angle=radians(flat.angle_deg))
    return None


def _hub(given: Hub) -> cut.Hub:
    screw = None
    if given.set_screw:
        hole = given.set_screw
        screw = cut.SetScrew(diameter=hole.hole_diameter_mm, height=hole.height_mm, angle=radians(hole.angle_deg))
    return cut.Hub(diameter=given.diameter_mm, length=given.length_mm, side=given.side, set_screw=screw)


def _lightening(given: Lightening) -> cut.Lightening:
    return cut.Lightening(
        count=given.holes,
        hole_diameter=given.hole_diameter_mm,
        circle_diameter=given.circle_diameter_mm,
        start_angle=radians(given.angle_deg),
    )
