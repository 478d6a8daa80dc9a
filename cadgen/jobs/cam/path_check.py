"""Lift held against the path that it was computed from, and what a cam loses of it against the car's run.

The lift of a cam is computed from the curvature of the path. Here the way back is gone: the car is driven by the lift
from the start of the path, and where it gets to is compared with the path's own points. It is driven by the lift
wanted, and by the lift of the follower rolled on the curve that is cut. How far lost lift moves the car is a check too.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import degrees

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.checks import CONTACT_LIMIT_UM, LOST_LIFT
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run, drive, start_pose
from cadgen.check import Check, CheckCode
from cadgen.design import cam_model
from cadgen.design.schema import Design
from cadgen.figures import Figure
from cadgen.messages import Message
from cadgen.verdict import Reservation

# mm; integration and rounding together stay below 1e-6 mm on every packaged design.
MOST_OFF_PATH = 0.1
_WORTH_SAYING = 0.5  # mm that lost lift moves the car; less is not worth a sentence
_END_ONLY = 1e-9  # rad; a waypoint this close to the end of the run is its end


@dataclass(frozen=True)
class PathDeviation:
    """Distances of a driven car from the path that was planned for it.

    Attributes:
        waypoint: distance of the planned path's point of the car from each waypoint that it passes, mm, shape (n,).
        numbers: number of each of these waypoints, from 1, shape (n,).
        end: distance from the point where the run is to end, mm.
        end_heading: heading there against that of the path, rad, positive to the left.
    """

    waypoint: Array
    numbers: NDArray[np.intp]
    end: float
    end_heading: float


def path_deviation(design: Design, track: Track, lift: PathMotion, driven: PathMotion) -> PathDeviation:
    """Drive the car by a lift, without play, and hold it against the points of its path.

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift wanted, which says where the run ends.
        driven: lift that it is driven by.
    """
    stop, laps = lift.blend_start, design.path.run_laps if track.closed else 1
    knots = track.waypoint_arc[1:] if track.closed else track.waypoint_arc
    per_lap = cam_model.cam_angle(design, track, knots)
    lap = TURN / track.turn_laps
    motor = (lap * np.arange(laps)[:, None] + per_lap).ravel()
    numbers = np.tile(np.arange(len(knots)) + 1 + (1 if track.closed else 0), laps)
    wanted = np.tile(track.planned(knots), (laps, 1)) @ [1, 1j]
    passed = motor < stop - _END_ONLY
    motor, numbers, wanted = motor[passed], numbers[passed], wanted[passed]
    at = np.append(motor, stop)
    run = drive(
        driven,
        cam_model.car(design),
        cam_model.travel(design, track),
        start=start_pose(track),
        stop=stop,
        at=at,
    )
    point = run.drive_wheel @ [1, 1j] - 1j * design.path.offset_mm * np.exp(1j * run.heading)
    end = cam_model.path_end(design, track)
    turned = run.heading[-1] - track.heading(np.array([0.0, end]))[-1]
    return PathDeviation(
        waypoint=np.abs(point[:-1] - wanted),
        numbers=numbers,
        end=float(abs(point[-1] - track.planned(end) @ [1, 1j])),
        end_heading=float((turned + TURN / 2) % TURN - TURN / 2),
    )


def lost_lift_check(design: Design, wanted: Run, got: Run) -> Check:
    """Check of what lost lift costs a run of the car: how far it moves it, mm.

    Args:
        design: loaded design.
        wanted: run on the lift that the profile is cut for.
        got: run on the lift that its outline gives, at the same motor positions.
    """
    off = np.hypot(*(got.drive_wheel - wanted.drive_wheel).T)
    worst = int(np.argmax(off))
    x, y = got.drive_wheel[worst]
    return Check(
        CheckCode.LOST_LIFT_EFFECT,
        Message("lost lift moves the car"),
        float(off[worst]),
        "mm",
        design.checks.lost_lift_effect_mm,
        place=Message("drive wheel at ({x:.0f}, {y:.0f}) mm", x=x, y=y),
        advice=Message("make the disc thinner (cam.thickness_mm), or lead the path through milder turns"),
    )


def path_checks(design: Design, track: Track, lift: PathMotion) -> tuple[Check, ...]:
    """Checks that the lift wanted drives the car along its path: past every waypoint, and to the end.

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift wanted.
    """
    codes = (CheckCode.PATH_WAYPOINT, CheckCode.PATH_END)
    names = (Message("distance from the waypoints"), Message("distance from the path's end"))
    return _checks(codes, names, track, path_deviation(design, track, lift, lift), MOST_OFF_PATH)


def cut_checks(
    design: Design, track: Track, lift: PathMotion, rolled: PathMotion, of_cam: Iterable[Check]
) -> tuple[Check, ...]:
    """Checks that the cam that is cut drives the car without play along its path, if it is cut for the lift wanted.

    A cam against play is cut for another lift: on that one the car needs its play to keep the path.

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift wanted.
        rolled: lift of the follower rolled on the curve that is cut.
        of_cam: checks of the cam. Where they say that lift is lost, or where the car as built reshapes discs, the car
            may be as much farther off as `checks.lost_lift_effect_mm` allows.
    """
    lost = any(check.code in LOST_LIFT and check.value > CONTACT_LIMIT_UM for check in of_cam if check.unit == "µm")
    given_up = design.checks.lost_lift_effect_mm if lost or cam_model.as_built(design).shapes_discs else 0.0
    codes = (CheckCode.CUT_WAYPOINT, CheckCode.CUT_END)
    names = (
        Message("distance from the waypoints, cut cam"),
        Message("distance from the path's end, cut cam"),
    )
    return _checks(codes, names, track, path_deviation(design, track, lift, rolled), MOST_OFF_PATH + given_up)


def _checks(
    codes: tuple[CheckCode, CheckCode], names: tuple[Message, Message], track: Track, error: PathDeviation, most: float
) -> tuple[Check, ...]:
    """Checks of the waypoints and of the end of a path, both to be passed within `most` mm."""
    worst = int(np.argmax(error.waypoint)) if error.waypoint.size else None
    return (
        Check(
            codes[0],
            names[0],
            0.0 if worst is None else float(error.waypoint[worst]),
            "mm",
            most,
            place=""
            if worst is None
            else Message(
                "{knot_name} {number} of {points_key}",
                knot_name=track.knot_name,
                number=int(error.numbers[worst]),
                points_key=track.points_key,
            ),
            advice=Message("look at the path there: {points_key}", points_key=track.points_key),
        ),
        Check(
            codes[1],
            names[1],
            error.end,
            "mm",
            most,
            place=Message("heading {turned:.4f}° off", turned=round(degrees(error.end_heading), 4) + 0.0),
            advice=Message("look at the end of the path: {points_key}", points_key=track.points_key),
        ),
    )


def lost_lift_reservation(checks: Iterable[Check]) -> Iterator[Reservation]:
    """Reservation where lost lift moves the car by more than `_WORTH_SAYING`, though by no more than is allowed.

    Args:
        checks: checks of the cam in its car.
    """
    for check in checks:
        if check.code == CheckCode.LOST_LIFT_EFFECT and check.passed and check.value > _WORTH_SAYING:
            yield Reservation(
                "lift-lost",
                Message("lost lift moves the car by up to {off:.1f} mm", off=check.value),
                check.advice,
                Figure("lift_lost", Message("moved by lost lift"), check.value, "mm"),
            )
