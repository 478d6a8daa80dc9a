"""Lift held against the path that it was computed from, and what a cam loses of it against the car's run.

The lift of a cam is computed from the curvature of the path. Here the way back is gone: the car is driven by the lift
from the start of the path, and where it gets to is compared with the path's own points. What the cut cam gives of that
lift is a second check: how far lost lift moves the car.
"""

from dataclasses import dataclass
from math import degrees

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run, drive, start_pose
from cadgen.check import Check, CheckCode
from cadgen.design import cam_model
from cadgen.design.schema import Design
from cadgen.messages import Message

# mm; integration and rounding together stay below 1e-6 mm on every packaged design.
MOST_OFF_PATH = 0.1
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
    error = path_deviation(design, track, lift, lift)
    worst = int(np.argmax(error.waypoint)) if error.waypoint.size else None
    return (
        Check(
            CheckCode.PATH_WAYPOINT,
            Message("driven past the waypoints"),
            0.0 if worst is None else float(error.waypoint[worst]),
            "mm",
            MOST_OFF_PATH,
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
            CheckCode.PATH_END,
            Message("driven to the path's end"),
            error.end,
            "mm",
            MOST_OFF_PATH,
            place=Message("heading {turned:.4f}° off", turned=degrees(error.end_heading)),
            advice=Message("look at the end of the path: {points_key}", points_key=track.points_key),
        ),
    )
