"""Remedies against play on a car whose rod rubs, and the error that each remedy leaves.

A remedy is judged by the worst end of the run over the plays, frictions and drags of the cars that may be built:

- a profile alone: plain, or compensated by the windows that serve the whole band best;
- a ball bearing as follower, which hardly rubs, with a compensated profile of its own;
- drag that holds: a brake on the disc whose torque is above all that turns the cam ahead. Then gears and cam never
  part, play does nothing, and the plain profile is right;
- a trim: a constant turn of the steering against the rod, set after a trial run so that the end of the run is met as
  closely as it goes. It holds as long as the next run repeats the first. What is left depends on the profile, too.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.follower import EdgeFollower
from cadgen.car.against_play.play_task import PlayTask
from cadgen.car.against_play.trial_run import SteeringTrim, TrialRun
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import Mechanics, MechanicsBand

MARGIN = 1.25  # of a drag that is to hold, over the torque that it must hold
_STATIONS = 7200  # of the turn at which torques are looked at
_FRICTION_STEP = 0.005  # at which the friction is looked for that undoes a trim
_MOST_FRICTION = 1.0
_MOST_BEARINGS = 2  # side by side on one rod


@dataclass(frozen=True, kw_only=True)
class Holding:
    """The drag that keeps a cam on its gears.

    Attributes:
        torque: greatest torque that turns the cam ahead without any friction, N mm; the drag must be above it.
        cam_angle: cam angle of that torque, rad.
        with_friction: greatest torque at the least friction of the band, N mm; not to be relied on, for vibration
            undoes friction.
        energy: energy that a drag of `MARGIN` times the torque takes in a turn of the cam, J.
    """

    torque: float
    cam_angle: float
    with_friction: float
    energy: float

    @property
    def drag(self) -> float:
        """Drag to build, N mm: the torque with its margin."""
        return MARGIN * self.torque


def holding(lift: PathMotion, band: MechanicsBand) -> Holding:
    """Drag that a cam needs to stay on its gears wherever it falls while the car drives.

    The closing blend behind the finish often falls most steeply, and nobody minds where the cam is there.

    Args:
        lift: lift of the cam.
        band: range of the forces on the cam.
    """
    theta = np.linspace(0.0, TURN, _STATIONS, endpoint=False)
    theta = theta[theta <= lift.blend_start]
    free = band.at(0.0, 0.0).torque(lift, theta)
    held = band.at(band.friction[0], 0.0).torque(lift, theta)
    worst = int(np.argmax(free))
    torque = max(float(free[worst]), 0.0) + 0.0  # no -0
    return Holding(
        torque=torque,
        cam_angle=float(theta[worst]),
        with_friction=max(float(held.max()), 0.0) + 0.0,
        energy=MARGIN * torque * TURN * 1e-3,
    )


def _trial(task: PlayTask) -> TrialRun:
    return TrialRun(wanted=task.lift, car=task.car, length=task.length)


def trim(task: PlayTask, lift: PathMotion, cut: PathMotion, play: float, mechanics: Mechanics) -> SteeringTrim:
    """Trim that brings the end of the run nearest to its planned place.

    Args:
        task: lift wanted, car and follower.
        lift: lift that the follower gets without play.
        cut: lift that the cam was cut for.
        play: return error of the trial run, rad.
        mechanics: friction and drag of the trial run.
    """
    return _trial(task).trimmed(lift, mechanics.leads(cut), play)


def trimmed_end(
    task: PlayTask, lift: PathMotion, cut: PathMotion, play: float, mechanics: Mechanics, turn: float
) -> float:
    """Position error at the end of a run whose steering was trimmed on another run, mm.

    Args:
        task, lift, cut: same as in `trim`.
        play: return error of this run, rad.
        mechanics: friction and drag of this run.
        turn: the trim, in tan(beta).
    """
    return _trial(task).error(lift, mechanics.leads(cut), play, turn).end_distance


def friction_to_fail(
    task: PlayTask, lift: PathMotion, cut: PathMotion, play: float, mechanics: Mechanics, most: float
) -> tuple[float, float]:
    """Least and greatest coefficient of friction with which a trimmed car still ends within the error allowed.

    Args:
        task, lift, cut, play, mechanics: same as in `trim`.
        most: greatest position error allowed at the end, mm; what the trim itself leaves is added to it.
    """
    set_by = trim(task, lift, cut, play, mechanics)
    allowed = most + set_by.error.end_distance
    limits = []
    for way in (-1, 1):
        friction = mechanics.friction
        while 0 <= (further := friction + way * _FRICTION_STEP) <= _MOST_FRICTION:
            changed = replace(mechanics, friction=further)
            if trimmed_end(task, lift, cut, play, changed, set_by.tan_beta) > allowed:
                break
            friction = further
        limits.append(friction)
    return limits[0], limits[1]


def trims(
    task: PlayTask, lift: PathMotion, cut: PathMotion, plays: Sequence[float], cases: Sequence[Mechanics]
) -> tuple[SteeringTrim, ...]:
    """Trims of cars of all these plays (rad) and frictions, each set after a run of its own."""
    trial = _trial(task)
    found: list[SteeringTrim] = []
    for leads in (case.leads(cut) for case in cases):
        for play in plays:
            found.append(trial.trimmed(lift, leads, play, near=found[-1] if found else None))
    return tuple(found)


def worst_run(
    task: PlayTask, lift: PathMotion, cut: PathMotion, plays: Sequence[float], cases: Sequence[Mechanics]
) -> tuple[float, float]:
    """Greatest position error at the end of the run of any car, and anywhere on it, mm."""
    trial = _trial(task)
    errors = [trial.error(lift, leads, play) for leads in (case.leads(cut) for case in cases) for play in plays]
    return max(error.end_distance for error in errors), max(float(error.distance.max()) for error in errors)


def touched_width(lift: PathMotion, follower: EdgeFollower) -> float:
    """Length of the follower, along its axis, that touches the disc somewhere in a turn, mm.

    The contact lies (w - r sin(beta)) / cos(beta) along the axis from the fork axis, on the face that carries.
    """
    T = lift.q(np.linspace(0.0, TURN, _STATIONS, endpoint=False))
    root = np.sqrt(1 + T**2)
    place = follower.contact_face(T) * root - follower.radius * T
    return float(np.ptp(np.append(place, [follower.inner, follower.outer])))


@dataclass(frozen=True, kw_only=True)
class RodBearing:
    """A shielded ball bearing of the ISO 15 dimension series: bore, outside diameter and width, mm."""

    bore: float
    outside: float
    width: float


BEARINGS = tuple(
    RodBearing(bore=bore, outside=outside, width=width)
    for bore, outside, width in (
        *((2, 5, 2.3), (2, 6, 3), (3, 7, 3), (3, 8, 4), (3, 10, 4), (4, 9, 4), (4, 11, 4), (4, 13, 5), (5, 11, 5)),
        *((5, 13, 4), (5, 16, 5), (6, 13, 5), (6, 15, 5), (6, 19, 6), (7, 14, 5), (7, 19, 6), (8, 16, 5), (8, 19, 6)),
        *((8, 22, 7), (10, 19, 7), (10, 22, 6), (10, 26, 8), (12, 21, 7), (12, 28, 8)),
    )
)


def bearing_for(lift: PathMotion, follower: EdgeFollower) -> tuple[RodBearing, int] | None:
    """The smallest bearing that fits on the rod, and the number needed side by side; None if no bearing fits."""
    for bearing in sorted(BEARINGS, key=lambda b: b.outside):
        needed = touched_width(lift, replace(follower, radius=bearing.outside / 2))
        count = int(np.ceil(needed / bearing.width))
        if bearing.bore >= 2 * follower.radius and count <= _MOST_BEARINGS:
            return bearing, count
    return None
