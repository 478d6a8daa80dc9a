"""From a design to what the planner is asked; degrees become radians here."""

from dataclasses import replace
from math import inf, radians, tan

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import edge_follower
from cadgen.car.course.layout import CarPoint, Course, Gate, Shape
from cadgen.car.path.wheel_track import Track
from cadgen.car.planner.constraints import curvature_limits
from cadgen.car.planner.path_task import Margins, PathTask, SteeringLimits, Vehicle
from cadgen.car.planner.route import in_order
from cadgen.design import cam_model, variation
from cadgen.design.course import body_of, layout_of, spacings_of
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.messages import Message

# Where nothing is known of the play, or it was measured, a car may still be off by this share of a degree.
_UNKNOWN_SPREAD = radians(0.1)
# Kept from the limits of the pressure angle, rad: play is taken out by flanks a little steeper than those wanted.
_USUAL_PRESSURE = radians(3.0)
_USUAL_ROUND = 1.5  # times the least convex radius: where play is taken out the outline is sharper
_USUAL_LIFT = 0.7  # of the greatest lift error with play
# Between the places at which the planner holds a limit the path may be a little beyond it.
_CALM_SHARE = 0.98
_BLEND_ANGLE, _FLATTER = radians(60.0), 0.7  # of the closing blend, and how much less each time it was too steep
_TRACK_STEP = 1.0  # mm between the points of a track to stay near to


def _free_wheel(design: Design, drawn: bool) -> bool:
    """Whether the plan chooses the radius of the drive wheel.

    It does where the course says where the run ends: then the whole path must be driven before the closing blend.

    Args:
        design: loaded design.
        drawn: whether the design has a path.
    """
    if design.path.closed:
        return False
    finish = design.course is not None and design.course.finish is not None
    return design.car.drive_wheel_radius_mm is None and design.train is not None and (finish or not drawn)


def task_of(
    design: Design,
    *,
    drawn: Track | None,
    near: Track | None,
    within: float,
    calm: Track | None,
    tightening: Margins,
    drawn_share: float = 1.0,
) -> PathTask:
    """Task of the planner.

    Args:
        design: loaded design.
        drawn: drive wheel's track of the design's own path; None if it has none.
        near: track to stay near to; None for a plan from scratch.
        within: how far from it the drive wheel may be, mm.
        calm: track whose curvature's slopes are not to be exceeded; None without.
        tightening: kept from the limits.
        drawn_share: share of the range of spacings about the stated one that is planned for.

    Raises:
        DesignError: the design has no course, no start, or another follower than the rod.
    """
    if near is not None and near.closed != bool(design.path.closed):
        raise DesignError(
            "the path to stay near to is closed and the one to be planned is not, or the other way round: set "
            "path.closed alike in both"
        )
    vehicle = _vehicle(design, near is None and _free_wheel(design, drawn is not None))
    course = _course(design, drawn) if near is None else in_order(layout_of(design.course) or Course())
    draw = spacings_of(design.course)
    if draw is not None:
        stated = draw.stated
        draw = replace(draw, spacings=tuple(stated + drawn_share * (each - stated) for each in draw.spacings))
    return PathTask(
        vehicle=vehicle,
        limits=_limits(design, vehicle, calm, tightening, 1.0 if draw is None else draw.spacings[0] / draw.stated),
        course=replace(draw.tightest(course) if draw else course, margin=course.margin + tightening.margin),
        corridor=None if near is None else track_points(near),
        within=within,
        gate_margin=tightening.gate,
        draw=draw,
    )


def track_points(track: Track) -> Array:
    """Points of a track, close together, shape (k, 2), mm."""
    return np.asarray(track.position(np.linspace(0.0, track.length, int(track.length / _TRACK_STEP) + 2)))


def _course(design: Design, drawn: Track | None) -> Course:
    """The course; start and finish that it leaves out are those of the design's path."""
    course = layout_of(design.course)
    if course is None:
        raise DesignError(
            "the design has no course to plan a path for: add [course] with [course.start], [[course.gates]] and "
            "[course.finish]"
        )
    if design.path.closed and course.finish is not None:
        raise DesignError(
            "course.finish is given, but path.closed is true and each lap ends where it starts: remove course.finish"
        )
    if course.start is None and drawn is None:
        raise DesignError(
            "course.start is missing: add [course.start] with at_mm and heading_deg; radius_mm, or from_mm and to_mm "
            "in its place, leave open where the run starts, and without heading_deg its direction is open"
        )
    start, finish = course.start, course.finish
    if start is None and drawn is not None:
        start = _stand("path", drawn, 0.0)
    if finish is None and drawn is not None:
        finish = _stand("path", drawn, drawn.length)
    if design.path.closed:
        return in_order(replace(course, start=start, finish=start))
    course = in_order(replace(course, start=start, finish=finish))
    if finish is None and course.gates:
        *gates, last = course.gates
        return replace(course, finish=last, gates=tuple(gates))
    return course


def _stand(key: str, track: Track, arc: float) -> Gate:
    x, y = track.position(arc).tolist()
    heading = float(track.heading(np.array([arc]))[0])
    return Gate(
        key=key, place=Shape.disc((x, y), 0.0), point=CarPoint.DRIVE_WHEEL, heading=heading, heading_tolerance=0.0
    )


def _vehicle(design: Design, free: bool) -> Vehicle:
    band = variation.play_bands(design).get(design.optimize.order)
    spread = _UNKNOWN_SPREAD
    if band is not None and band.measured is None:
        low, high = band.ends
        spread = max((high - low) / 2, radians(0.01))
    rod = edge_follower(cam_model.follower(design), Message("planning a path"), Message("plan with the rod"))
    share = 1.0 - design.cam.blend_deg / 360
    laps, travel = bool(design.path.closed), _given_travel(design)
    return Vehicle(
        car=cam_model.car(design),
        body=body_of(design.car.outline, cam_model.car(design)),
        path_offset=design.path.offset_mm,
        base_radius=rod.base_radius,
        faces=(rod.inner, rod.outer),
        spread=spread * (design.path.run_laps if laps else 1),
        travel=travel,
        most_length=inf if travel is None else travel * share,
        path_turn=1 / design.path.turn_laps if laps else share if free else 1.0,
        end=1.0 if laps or free or travel is not None else share,
        closed=laps,
    )


def _given_travel(design: Design) -> float | None:
    """Travel for one turn of the cam, mm, where the design gives the drive wheel's radius; None where it does not.

    Raises:
        DesignError: the radius is given without a train, or for a closed path, whose length decides it.
    """
    radius = design.car.drive_wheel_radius_mm
    if radius is None:
        return None
    if design.path.closed:
        raise DesignError(
            "car.drive_wheel_radius_mm is {radius:g}, but the length of a planned lap decides the drive "
            "wheel: remove the key, and the plan names the radius",
            radius=radius,
        )
    return cam_model.turn_of_wheel(design)


def _limits(
    design: Design, vehicle: Vehicle, calm: Track | None, tightening: Margins, smallest: float
) -> SteeringLimits:
    """Limits of steering and cam; the path is driven at its `smallest` too, a share of what is planned."""
    checks = cam_model.check_limits(design)
    left, right = curvature_limits(vehicle, smallest * tightening.turn)
    rod = edge_follower(cam_model.follower(design), Message("planning a path"))
    least_radius = max(checks.min_convex_radius, design.blank.edge_break_mm or 0.0)
    valley, band = inf, variation.play_bands(design).get(design.optimize.order)
    if design.optimize.max_lift_error_um is not None and band is not None and band.ends[1] > 0:
        # In a valley the play takes the height that the lift gains in half of it to either side (play.md).
        height = _USUAL_LIFT * tightening.valley * design.optimize.max_lift_error_um * 1e-3
        valley = 8 * height / band.ends[1] ** 2
    kept = _USUAL_PRESSURE + tightening.pressure
    slope, bend = (inf, inf) if calm is None else np.abs(calm.curvature_jets[:, 1:]).max(axis=0).tolist()
    # A blend without slopes at its ends is 15/8 as steep in its middle as on average.
    blend = (
        8 / 15 * radians(design.cam.blend_deg) * vehicle.base_radius * tan(_BLEND_ANGLE) * _FLATTER**tightening.blend
    )
    return SteeringLimits(
        left=left,
        right=right,
        rise=max(checks.pressure_angle.rise - kept, radians(5.0)),
        fall=max(checks.pressure_angle.fall - kept, radians(5.0)),
        convex_radius=_USUAL_ROUND * (rod.radius + least_radius) + tightening.radius,
        step=blend if tightening.blend and not vehicle.closed else inf,
        slope=slope * _CALM_SHARE,
        bend=bend * _CALM_SHARE,
        valley=valley,
    )
