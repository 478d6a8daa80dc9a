"""From a design to what the numeric rooms work on; the one place where degrees become radians and µm mm.

Car, rod, lift and key are those of the car as it was built, if the design has [as_built].
"""

from collections.abc import Callable
from dataclasses import dataclass, fields
from math import ceil, degrees, inf, radians
from typing import Any

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower, Follower, edge_follower
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, CheckLimits
from cadgen.car.course.layout import Side
from cadgen.car.path.spline import PlannedPath
from cadgen.car.path.wheel_track import Track, offset_track
from cadgen.car.path_motion import PathMotion, lap_motion, path_motion
from cadgen.car.steering import Car, by_rim, rim_travel, steering_jets
from cadgen.design import gear_model
from cadgen.design.disc import follower_motion
from cadgen.design.schema import Design, MotionDesign
from cadgen.deviations.as_built import AS_DESIGNED, AsBuilt, Placed
from cadgen.deviations.deviation import Place
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Keyway, Lightening, Mark, SetScrew

LOST_LIFT_UM = 1.0  # greatest lift that a cam without a car may lose, if the design does not say
# A closing blend shorter than the schema's shortest is none.
LEAST_BLEND = radians(0.5)
_ROUNDING = 1e-9  # of the track's length
# mm; a wheel as far off turns the car by less than 0.001 degrees a lap, as far as a path of one loop turns it.
_WHEEL_FITS = 5.1e-5


def planned_path(design: Design) -> PlannedPath:
    """The curve of the design's kind of path.

    Raises:
        DesignError: its points make no path, such as two equal neighbours among the waypoints.
    """
    kind = design.path.registered
    if design.path.closed and kind.build_closed is not None:
        return kind.build_closed(design.path.keys)
    return kind.build(design.path.keys)


def track(design: Design) -> Track:
    """The drive wheel's track.

    Raises:
        DesignError: as `planned_path`, or the track has a cusp.
    """
    turn, laps = turn_of_wheel(design), design.path.turn_laps if design.path.closed else None
    driven = offset_track(planned_path(design), design.path.offset_mm, turn, laps=laps)
    (_refuse_wheel if turn is None or laps is None else _refuse_wheel_of_laps)(design, driven)
    return driven


def refuse_laps(design: Design, job: str, instead: str) -> None:
    """Refuse a closed path for a job that is worked out for runs with an end.

    Args:
        design: loaded design.
        job: name of the job, as it begins a sentence.
        instead: what to do.

    Raises:
        DesignError: the path is closed.
    """
    if design.path.closed:
        raise DesignError(
            "{job} is worked out for a run with an end, but path.closed is true: {instead}", job=job, instead=instead
        )


def turn_of_wheel(design: Design) -> float | None:
    """Travel of a drive wheel of known radius in one turn of the cam, mm (eq. 20); None if the design has no radius.

    Raises:
        DesignError: the radius is known, but not the ratio of the train.
    """
    radius = design.car.drive_wheel_radius_mm
    if radius is None:
        return None
    if design.train is None:
        raise DesignError(
            "car.drive_wheel_radius_mm is {radius:g}, but how far the car goes in a turn of the cam "
            "needs the ratio of [train] too: add [train], or remove car.drive_wheel_radius_mm",
            radius=radius,
        )
    return TURN * radius * float(gear_model.train(design).ratio)


def _refuse_wheel(design: Design, driven: Track) -> None:
    """Refuse a wheel that does not get to the end of the path before the closing blend."""
    radius, most = design.car.drive_wheel_radius_mm, TURN - radians(design.cam.blend_deg)
    if radius is None or driven.length <= driven.turn * most / TURN * (1 + _ROUNDING):
        return
    least = radius * driven.length / (driven.turn * most / TURN)
    raise DesignError(
        "car.drive_wheel_radius_mm is {radius:g}; with it the car goes {reach:.0f} mm before the "
        "closing blend of {blend_deg:g} degrees, but the drive wheel's track is {length:.0f} mm "
        "long: take a wheel of {least:g} mm or more, a train of greater ratio, or a shorter path",
        radius=radius,
        reach=driven.turn * most / TURN,
        blend_deg=design.cam.blend_deg,
        length=driven.length,
        least=ceil(least * 100) / 100,
    )


def _refuse_wheel_of_laps(design: Design, driven: Track) -> None:
    """Refuse a wheel that does not drive a whole number of laps in a turn of the cam."""
    radius = design.car.drive_wheel_radius_mm or 0.0
    fits = driven.turn / (TURN * float(gear_model.train(design).ratio))
    if abs(radius - fits) <= _WHEEL_FITS:
        return
    laps = Message("lap takes") if driven.turn_laps == 1 else Message("{laps} laps take", laps=driven.turn_laps)
    raise DesignError(
        "car.drive_wheel_radius_mm is {radius:g}, but the path is closed and its {laps} one turn of "
        "the cam, so the drive wheel's radius must be {fits:.4f} mm: set that, or leave it out",
        radius=radius,
        laps=laps,
        fits=fits,
    )


def turn_to_finish(design: Design, driven: Track) -> float:
    """Motor position at which a run of the car as designed ends, rad: at the closing blend, or after the last lap."""
    if driven.closed:
        return TURN * design.path.run_laps / driven.turn_laps
    if design.car.drive_wheel_radius_mm is None:
        return TURN - radians(design.cam.blend_deg)
    return TURN * driven.length / driven.turn


def as_built(design: Design) -> AsBuilt:
    """Deviations of the car as it was built; none without [as_built]."""
    if design.as_built is None:
        return AS_DESIGNED
    placed = []
    for effect in design.as_built.effects:
        if effect.place != Place.NOTED:
            known = effect.known()
            values = tuple(effect.numbers[p.name] * p.scale for p in known.parameters)
            sigma = (effect.values[0].sigma or 0.0) * known.parameters[0].scale
            placed.append(Placed(known, values, effect.place, sigma, effect.kind_of_data.rod_on))
    nominal = design.follower.registered.follower(design.follower.keys, design.seat)
    return AsBuilt(tuple(placed), nominal if isinstance(nominal, EdgeFollower) else None)


def car(design: Design) -> Car:
    """The car in plan view."""
    nominal = Car(
        wheelbase=design.car.wheelbase_mm,
        drive_wheel_offset=design.car.drive_wheel_offset_mm,
        idle_wheel_offset=design.car.idle_wheel_offset_mm,
        max_steering_angle=radians(design.car.max_steering_angle_deg),
        steering_gain=-1.0 if design.cam.side == Side.RIGHT else 1.0,
    )
    return as_built(design).car(nominal)


def follower(design: Design) -> Follower:
    """Follower that rides on the disc, of the kind in the design.

    Raises:
        DesignError: as built, nothing would be left of the rod, or what [as_built] says is not of this follower.
    """
    nominal = design.follower.registered.follower(design.follower.keys, design.seat)
    if design.as_built is None:
        return nominal
    return as_built(design).follower(edge_follower(nominal, "what [as_built] says of a car", "remove [as_built]"))


def leaning(design: Design, job: str) -> EdgeFollower:
    """Leaning follower of a design; a job that is worked out for those alone refuses others.

    Args:
        design: loaded design.
        job: name of the job, as it begins a sentence.

    Raises:
        DesignError: the design has another follower, or as `follower`.
    """
    return edge_follower(follower(design), job)


def travel(design: Design, driven: Track) -> float:
    """Travel of the drive wheel's rim for one turn of the cam, mm."""
    return as_built(design).travel(driven.turn)


def cam_angle(design: Design, driven: Track, arc: Array) -> Array:
    """Cam angles at which the car, driven without play, stands at given arc lengths of its track, rad.

    Args:
        design: loaded design.
        driven: drive wheel's track as it is driven.
        arc: arc lengths along it, mm, shape (n,).

    Raises:
        DesignError: as `lift`.
    """
    its_car = car(design)
    rim = rim_travel(driven.arc, steering_jets(driven, its_car), its_car)
    return np.asarray(TURN * np.interp(arc, driven.arc, rim) / travel(design, driven))


def path_end(design: Design, driven: Track) -> float:
    """Arc length of the track at which the closing blend begins, mm: all of it for laps or a known wheel."""
    if driven.closed or design.car.drive_wheel_radius_mm is not None:
        return driven.length
    return driven.length * (TURN - radians(design.cam.blend_deg)) / TURN


def undrivable(design: Design) -> Message | None:
    """Why the path cannot be driven, by which a check of the design would be refused; None if it can.

    Args:
        design: the design.
    """
    try:
        lift(design)
    except DesignError as error:
        return error.message
    return None


def lift(design: Design, driven: Track | None = None) -> PathMotion:
    """The steering that one turn of the cam must give, closed by the blend where the path is not.

    The blend begins at the same place of the path whether the car is built as designed or not.

    Args:
        design: the design.
        driven: its track, if that is at hand already.

    Raises:
        DesignError: as `track`, a turn tighter than the steering can hold, or as built the wheel is so small that
            the cam's turn ends before the blend can begin.
    """
    road, its_car = driven or track(design), car(design)
    if road.closed:
        jets = steering_jets(road, its_car)
        return lap_motion(road.arc, jets, road.turn_laps, stop=turn_to_finish(design, road))
    blend = TURN - turn_to_finish(design, road)
    jets = steering_jets(road, its_car)
    if design.as_built is not None:
        begins = float(cam_angle(design, road, np.array([path_end(design, road)]))[0])
        blend = TURN - begins
        if blend < LEAST_BLEND:
            raise DesignError(
                "as built the car drives its path in {begins:.1f} degrees of cam angle up to where the "
                "closing blend begins, which leaves no room for it: raise cam.blend_deg, which is "
                "{blend_deg:g}, by {more:.1f} or more, or shorten the path",
                begins=degrees(begins),
                blend_deg=design.cam.blend_deg,
                more=degrees(LEAST_BLEND - blend) * 1.05,
            )
    rim = rim_travel(road.arc, jets, its_car)
    return path_motion(rim, by_rim(jets, its_car), travel(design, road), blend=blend)


@dataclass(frozen=True)
class CamMotion:
    """Section of the design file that a motion comes from.

    Attributes:
        design: class of the designs that have it.
        motion: function of a design that returns the motion of its follower.
        shaping_key: function of a design that returns the key that shapes the motion, as messages name it.
    """

    design: type[Design | MotionDesign]
    motion: Callable[[Any], Motion]
    shaping_key: Callable[[Any], str]


# The path of a car, and [motion], whose own sources are the bases of its class.
CAM_MOTIONS = {
    "path": CamMotion(Design, lift, lambda design: f"path.{fields(design.path.keys)[0].name}"),
    "motion": CamMotion(
        MotionDesign,
        lambda design: follower_motion(design.motion, design.follower.registered),
        lambda design: design.motion.shaping_key,
    ),
}


def source_of(design: Design | MotionDesign) -> CamMotion:
    """Source of the motion of a design's follower.

    Args:
        design: loaded design.
    """
    return next(source for source in CAM_MOTIONS.values() if isinstance(design, source.design))


def blank(design: Design | MotionDesign) -> Blank:
    """Features of the disc besides its profile.

    A key, and a set screw beside it, stand where they take out the phase that the cam has on the car as built. The
    edges are broken as they are on that car, since the cam is made for its land.
    """
    given = design.blank
    built = as_built(design) if isinstance(design, Design) else AS_DESIGNED
    back = built.phase if isinstance(design, Design) and has_key(design) else 0.0
    key: Keyway | DFlat | None = None
    if way := given.keyway:
        key = Keyway(width=way.width_mm, depth=way.depth_mm, angle=radians(way.angle_deg) - back)
    elif flat := given.d_flat:
        key = DFlat(depth=given.bore_diameter_mm - flat.across_mm, angle=radians(flat.angle_deg) - back)
    hub, holes, mark = given.hub, given.lightening, given.mark
    screw = None
    if hub and (hole := hub.set_screw):
        angle = radians(hole.angle_deg) - back
        screw = SetScrew(diameter=hole.hole_diameter_mm, height=hole.height_mm, angle=angle)
    return Blank(
        bore_diameter=given.bore_diameter_mm,
        key=key,
        hub=Hub(diameter=hub.diameter_mm, length=hub.length_mm, side=hub.side, set_screw=screw) if hub else None,
        lightening=Lightening(
            count=holes.holes,
            hole_diameter=holes.hole_diameter_mm,
            circle_diameter=holes.circle_diameter_mm,
            start_angle=radians(holes.angle_deg),
        )
        if holes
        else None,
        mark=Mark(diameter=mark.diameter_mm, radius=mark.radius_mm, angle=radians(mark.angle_deg)) if mark else None,
        edge_break=(given.edge_break_mm or 0.0) + built.broken_edges,
    )


def has_key(design: Design) -> bool:
    """Whether the bore holds the disc at an angle on its shaft."""
    return design.blank.keyway is not None or design.blank.d_flat is not None


def check_limits(design: Design | MotionDesign) -> CheckLimits:
    """Limits of the checks, mm and rad."""
    named = design.checks.pressure_angle_limit
    assert named is not None  # a design fills it in by its follower
    lost_lift = design.checks.lost_lift_limit_um
    if lost_lift is None:  # a car shows what an undercut costs
        lost_lift = inf if isinstance(design, Design) else LOST_LIFT_UM
    return CheckLimits(
        pressure_angle=PRESSURE_ANGLE_LIMITS[named],
        lost_lift=lost_lift * 1e-3,
        min_convex_radius=design.checks.min_convex_radius_mm,
        cutter_radius=design.machining.cutter_diameter_mm / 2,
        wall=design.checks.min_wall_mm,
        motion_key=source_of(design).shaping_key(design),
    )
