"""Many cars at once, each with its own dimensions: from deviations to poses along the run.

A car's steering at each cam angle is the nominal one plus first-order terms (`steering_derivatives`). Its run then
needs only one integration without play: play makes the car skip parts of that track and stand on a circle for
others, so its own track is a chain of rigid copies of pieces, and B may be any number. Peaks and valleys stay at
their nominal cam angles; that they move a little changes a run in the second order only, for the lift is level
there. With friction and drag each car leads where its own let it (`stretches`).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Contact
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.motion.drive import Run
from cadgen.car.motion.mechanics import Mechanics
from cadgen.car.motion.play import LEAST_SWING, falls
from cadgen.car.path_motion import PathMotion
from cadgen.car.steering import Car
from cadgen.deviations.deviation import (
    CAM_PHASE,
    DRIVE_WHEEL_OFFSET,
    EDGE_BREAK,
    EDGE_WEAR,
    INNER_FACE,
    OUTER_FACE,
    RETURN_ERROR,
    START_HEADING,
    START_X,
    START_Y,
    STEERING_LOST_MOTION,
    STEERING_ZERO,
    TEMPERATURE,
    WHEEL_RADIUS,
    WHEELBASE,
)
from cadgen.deviations.first_order import Expansion, OtherEdge, steering_derivatives
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.stretches import Forces, Stretches, behind_a_brake, stretches
from cadgen.inference.monte_carlo.tracks import Steered, Tracks
from cadgen.inference.monte_carlo.watch import Watch

Complex = NDArray[np.complex128]

_AT_ONCE = 100  # cars whose arrays stay in a processor's own memory


@dataclass(frozen=True)
class Poses:
    """Poses of m cars at g stations; heading in rad and position of the drive wheel in mm, shape (m, g).

    Both are counted from the nominal start: x along the planned heading there, y to its left.
    """

    heading: Array
    position: Complex


@dataclass(frozen=True, kw_only=True)
class Fleet(Steered):
    """The nominal car, ready to be varied.

    Attributes:
        falls: cam angles between which the nominal lift falls, shape (k, 2), rad.
        play: nominal return error B, rad.
        stations: motor positions at which poses are computed, increasing, shape (g,), rad.
        planned: poses of the planned run there, for one car.
        expansion: thermal expansion of disc and frame.
        forces: torques that turn the cam ahead or hold it; None if it leads on every fall.
        end: number of the station at the end of the run.
        watches: what the cars must keep of a course.
    """

    falls: Array
    play: float
    stations: Array
    planned: Poses
    expansion: Expansion
    forces: Forces | None
    end: int = -1
    watches: tuple[Watch, ...] = ()


def make_fleet(
    contact: Contact,
    follower: LeaningRod,
    car: Car,
    length: float,
    lift: PathMotion,
    planned: Run,
    *,
    wheel_radius: float,
    play: float,
    stations: Sequence[int] = (-1,),
    least_swing: float = LEAST_SWING,
    mechanics: Mechanics | None = None,
    expansion: Expansion | None = None,
) -> Fleet:
    """Prepare a nominal car.

    Args:
        contact: contact of the nominal rod with the disc that is cut, on an even grid of one turn from cam angle 0.
        follower: nominal rod and faces.
        car: nominal dimensions.
        length: travel of the drive wheel in one turn of the cam, mm.
        lift: lift that the disc was cut for; its peaks and valleys are the events.
        planned: planned run.
        wheel_radius: radius of the drive wheel, mm; only the effect of its deviation depends on it.
        play: nominal return error B, rad.
        stations: indices of motor positions of the planned run, in order; the last is the end of the run.
        least_swing: rises and falls of tan(beta) smaller than this are noise, not events.
        mechanics: friction and drag of the nominal car; the rod slides freely if left out.
        expansion: thermal expansion of disc and frame; none if left out.

    Raises:
        DesignError: the cam angles are not an even grid of a turn, or the stations are none or not in order.
    """
    even = np.linspace(0.0, TURN, len(contact.cam_angle), endpoint=False)
    if not np.allclose(contact.cam_angle, even, atol=1e-9):
        raise DesignError("the rod must be rolled on an even grid of cam angles from 0: take np.linspace(0, 2 pi, n)")
    chosen = list(stations)
    motor = planned.motor[chosen]
    if not motor.size or not (np.diff(motor) > 0).all():
        raise DesignError("a run needs at least one station, and each further along than the last: sort them")
    origin, heading = planned.drive_wheel[0], planned.heading[0]
    x, y = (planned.drive_wheel[chosen] - origin).T
    return Fleet(
        tan_beta=contact.q,
        derivatives=steering_derivatives(contact, follower, car.steering_gain, expansion),
        other=OtherEdge.of(contact, follower),
        falls=falls(lift, least_swing),
        car=car,
        length=length,
        wheel_radius=wheel_radius,
        play=play,
        stations=motor,
        planned=Poses(planned.heading[chosen][None] - heading, (x + 1j * y)[None] * np.exp(-1j * heading)),
        expansion=expansion or Expansion(),
        forces=None if mechanics is None else Forces.of(mechanics, lift, least_swing),
    )


def run_fleet(fleet: Fleet, deviations: Array, stations: Array | None = None) -> Poses:
    """Run m cars at once.

    The grid carries the trapezoidal rule for the heading, arcs for the position, and cubic interpolation between its
    points, so the poses err with the square of its step.

    Args:
        fleet: nominal car.
        deviations: deviations of m cars, shape (m, 29), columns and units as `deviation.COLUMNS`.
        stations: motor positions of each car, shape (m, g), rad; those of the fleet for all if left out.
    """
    own = None if stations is None else np.broadcast_to(stations, (len(deviations), np.shape(stations)[-1]))
    blocks = [slice(first, first + _AT_ONCE) for first in range(0, len(deviations), _AT_ONCE)]
    poses = [_run(fleet, deviations[block], None if own is None else own[block]) for block in blocks]
    return Poses(*(np.concatenate([getattr(each, name) for each in poses]) for name in ("heading", "position")))


def _run(fleet: Fleet, deviations: Array, stations: Array | None) -> Poses:
    deviations = _combined(fleet, deviations)
    play = np.maximum(fleet.play + deviations[:, RETURN_ERROR.column], 0.0)
    rate = fleet.length / TURN * (1 + deviations[:, WHEEL_RADIUS.column] / fleet.wheel_radius)
    phase = deviations[:, CAM_PHASE.column]
    first, last = float(phase.min()), float(fleet.stations[-1] + phase.max() + play.max())
    track = Tracks.of(fleet, deviations, rate, first, last)

    stretch = _stretches(fleet, deviations, play, phase, last)
    turned, moved = track.between(stretch.cam, stretch.motor[:, 1:] - stretch.motor[:, :-1], stretch.waits)
    zero = np.zeros((len(play), 1))
    heading = deviations[:, START_HEADING.columns] + np.concatenate([zero, np.cumsum(turned, axis=1)], axis=1)
    position = np.concatenate([zero, np.cumsum(np.exp(1j * heading[:, :-1]) * moved, axis=1)], axis=1)

    motor = (fleet.stations if stations is None else stations) + phase[:, None]
    # Car by car: of thousands of stations and stretches, a table of all with all would take gigabytes.
    begins = zip(stretch.motor[:, :-1], motor, strict=True)
    at = np.stack([np.searchsorted(starts, positions, side="right") for starts, positions in begins]) - 1
    rows = np.arange(len(play))[:, None]
    turned, moved = track.between(stretch.cam[rows, at], motor - stretch.motor[rows, at], stretch.waits[rows, at])
    position = position[rows, at] + np.exp(1j * heading[rows, at]) * moved
    start = deviations[:, START_X.columns] + 1j * deviations[:, START_Y.columns]
    return Poses(heading[rows, at] + turned, start + rate[:, None] * position)


def _combined(fleet: Fleet, deviations: Array) -> Array:
    """Deviations with broken and worn edges, play in the steering and a frame grown by heat among what they change."""
    out = deviations.copy()
    edges = deviations[:, EDGE_BREAK.column] + deviations[:, EDGE_WEAR.column]
    growth = fleet.expansion.frame * deviations[:, TEMPERATURE.column]
    out[:, INNER_FACE.column] += edges
    out[:, OUTER_FACE.column] -= edges
    out[:, STEERING_ZERO.column] += deviations[:, STEERING_LOST_MOTION.column]
    out[:, WHEELBASE.column] += fleet.car.wheelbase * growth
    out[:, DRIVE_WHEEL_OFFSET.column] += fleet.car.drive_wheel_offset * growth
    return out


def _stretches(fleet: Fleet, deviations: Array, play: Array, phase: Array, last: float) -> Stretches:
    forces = fleet.forces
    if forces is None:
        return stretches(fleet.falls[None, :, 0], fleet.falls[None, :, 1], play, phase, last)
    if forces.mechanics.behind > 0:
        return behind_a_brake(forces, deviations, play, phase, last)
    return stretches(*forces.leads(deviations), play, phase, last)
