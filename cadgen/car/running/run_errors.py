"""Errors due to play: deflection errors of the events, and heading and position errors of the run.

The paper's figures for its events (table 4) cannot be had without its trajectory. Its program, besides, steps the
spline's parameter, so that its nine points are not 0.96 degrees of cam angle everywhere as eq. 20 asks; it sums the
reverse zones after the valley, where eq. 29-30 have the part before it, and without their minus sign.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import StrEnum
from math import degrees

import numpy as np

from cadgen.arrays import TURN, Array, gauss_nodes
from cadgen.cam.follower import Follower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run
from cadgen.car.running.play import LEAST_SWING, follow
from cadgen.car.steering import Car, track_curvature, travel_ratio
from cadgen.errors import DesignError
from cadgen.figures import Figure, Figures
from cadgen.messages import Message

GAUSS_POINTS = 8  # on every piece of the lift: exact to rounding, for pieces are half a degree wide


class EventKind(StrEnum):
    """Kind of an event: at a peak the cam jumps, in a valley it waits (the paper's reverse)."""

    JUMP = "jump"
    REVERSE = "reverse"


@dataclass(frozen=True, kw_only=True)
class Event:
    """A peak, where the cam jumps, or a valley, where it waits (the paper's reverse).

    Attributes:
        kind: kind of event.
        cam_angle: cam angle of the peak or valley, rad.
        lift: lift there, mm.
        deflection: change of heading by the event, rad, positive to the left (eq. 28, 30).
    """

    kind: EventKind
    cam_angle: float
    lift: float
    deflection: float

    @property
    def figures(self) -> Figures:
        """Place and effect of the event, as they are shown."""
        return Figures(
            Figure("cam_angle", Message("cam angle"), degrees(self.cam_angle), "°"),
            Figure("lift", Message("lift"), self.lift, "mm"),
            Figure("deflection", Message("deflection"), degrees(self.deflection), "°"),
        )


def turning(lift: PathMotion, car: Car, length: float, start: float, stop: float) -> float:
    """Heading gained while the cam turns from `start` to `stop` without play, rad (integral of eq. 21).

    Args:
        lift: lift of the cam.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        start: cam angle at which it begins, rad.
        stop: cam angle at which it ends, rad.
    """
    breaks = lift.q.x
    turns = TURN * np.arange(np.floor(start / TURN), np.ceil(stop / TURN))
    edges = np.unique(np.concatenate([[start, stop], (breaks + turns[:, None]).ravel()]))
    edges = edges[(edges >= start) & (edges <= stop)]
    nodes, weights = gauss_nodes(GAUSS_POINTS)
    half = np.diff(edges) / 2
    theta = (edges[:-1] + half)[:, None] + half[:, None] * nodes
    tan_beta = lift.q(theta)
    rate = track_curvature(tan_beta, car) * travel_ratio(tan_beta, car)
    return float(length / TURN * np.sum((rate @ weights) * half))


def deflections(
    lift: PathMotion,
    follower: Follower,
    car: Car,
    length: float,
    play: float,
    *,
    least_swing: float = LEAST_SWING,
    leads: Array | None = None,
) -> tuple[Event, ...]:
    """Events of a turn up to the start of its closing blend, in order, each with its deflection error.

    A jump skips the cam from the peak p to p + B (eq. 28); a reverse repeats it from v - B to the valley v (eq.
    29-30). Both integrals run over the whole of B, or over the whole fall if that is shorter. The wait in the valley
    really adds B kappa(v), which differs from eq. 30 in the third power of B; `drive` has it so.

    Args:
        lift: lift of the cam.
        follower: follower, for the lift of the events.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        play: return error B, rad.
        least_swing: rises and falls of tan(beta) smaller than this are noise, not events.
        leads: where the cam leads with friction and drag, shape (k, 2), rad; on every fall if left out.

    Returns:
        No events if the lift does not fall before its closing blend: then play does nothing.

    Raises:
        DesignError: the play is negative or no number.
    """

    def event(kind: EventKind, angle: float, deflection: float) -> Event:
        height = float(follower.lift(lift.q(angle)))
        return Event(kind=kind, cam_angle=angle, lift=height, deflection=deflection)

    events = []
    for peak, valley in follow(lift, play, least_swing=least_swing, leads=leads).leads.tolist():
        skipped = min(play, valley - peak)
        events += [
            event(EventKind.JUMP, peak, -turning(lift, car, length, peak, peak + skipped)),
            event(EventKind.REVERSE, valley % TURN, turning(lift, car, length, valley - skipped, valley)),
        ]
    events = [item for item in events if item.cam_angle < lift.blend_start]
    return tuple(sorted(events, key=lambda item: item.cam_angle))


def deflection_sum(events: tuple[Event, ...]) -> float:
    """Cumulative deflection error, rad: the paper's delta beta_z, each event with its own sign."""
    return sum(event.deflection for event in events)


def deflected(run: Run, events: Iterable[Event]) -> Run:
    """Run that results if events turn the car, each where it happens, and nothing else is off (fig. 10, 18, 19).

    This shows what jumps alone, or reverses alone, do to the path. Neither happens without the other, so `drive` with
    play gives no such run. An event turns the car at the next of the run's motor positions, once in each turn.

    Args:
        run: run without play.
        events: events with their deflections, rad.
    """
    turned = np.zeros_like(run.motor)
    for event in events:
        turned += event.deflection * np.maximum(np.floor((run.motor - event.cam_angle) / TURN) + 1, 0.0)
    drive_wheel, front, idle = (wheel @ [1, 1j] for wheel in (run.drive_wheel, run.front_wheel, run.idle_wheel))
    ahead = np.exp(1j * turned)
    moved = drive_wheel[0] + np.append(0.0, np.cumsum(np.diff(drive_wheel) * ahead[:-1]))
    wheels = (moved + ahead * (wheel - drive_wheel) for wheel in (drive_wheel, front, idle))
    at_drive, at_front, at_idle = (np.stack([wheel.real, wheel.imag], axis=-1) for wheel in wheels)
    heading = run.heading + turned
    return replace(run, heading=heading, drive_wheel=at_drive, front_wheel=at_front, idle_wheel=at_idle)


@dataclass(frozen=True, kw_only=True)
class RunError:
    """Errors of a run against the planned run at the same motor positions; all arrays have shape (n,).

    Attributes:
        motor: position of the motor in cam units, rad.
        heading: heading error, rad, positive to the left.
        along: position error of the drive wheel along the planned heading, mm.
        across: position error of the drive wheel to the left of the planned heading, mm.
    """

    motor: Array
    heading: Array
    along: Array
    across: Array

    @property
    def figures(self) -> Figures:
        """Errors at the end and the greatest on the run, as they are shown."""
        return Figures(
            Figure("end_heading", Message("heading at the end"), degrees(self.end_heading), "°"),
            *self.end_figures.values(),
            Figure("greatest_position", Message("greatest on the run"), float(self.distance.max()), "mm"),
        )

    @property
    def judged_at(self) -> str:
        """Part of a figure's code that says where a run is judged: at its `end`, or on laps on the `last_turn`."""
        return "end" if self.motor[-1] < TURN else "last_turn"

    @property
    def end_figures(self) -> Figures:
        """Position error at the end and, of laps, the greatest on the last turn of the cam."""
        end = Figure("end_position", Message("position at the end"), float(self.distance[-1]), "mm")
        if self.judged_at == "end":
            return Figures(end)
        return Figures(end, Figure("last_turn_position", Message("greatest on the last turn"), self.end_distance, "mm"))

    @property
    def distance(self) -> Array:
        """Position error of the drive wheel, mm."""
        return np.hypot(self.along, self.across)

    @property
    def end_heading(self) -> float:
        """Heading error at the end, rad."""
        return float(self.heading[-1])

    @property
    def end_distance(self) -> float:
        """Position error by which a run is judged, mm: at its end, or of laps the greatest on the last turn of the cam.

        Laps may turn about their start, where the car then seems to keep to its path.
        """
        if self.motor[-1] < TURN:
            return float(self.distance[-1])
        return float(self.distance[self.motor >= self.motor[-1] - TURN].max())


def run_error(run: Run, planned: Run) -> RunError:
    """Compare a run with the planned run.

    Raises:
        DesignError: the two were not taken at the same motor positions.
    """
    if not np.array_equal(run.motor, planned.motor):
        raise DesignError("two runs can only be compared at the same motor positions: use equal steps and stop")
    off = run.drive_wheel - planned.drive_wheel
    c, s = np.cos(planned.heading), np.sin(planned.heading)
    return RunError(
        motor=run.motor,
        heading=run.heading - planned.heading,
        along=off[:, 0] * c + off[:, 1] * s,
        across=off[:, 1] * c - off[:, 0] * s,
    )
