"""Many cars at once, each with its own dimensions: from deviations to poses along the run.

A car's steering at each cam angle is the nominal one plus first-order terms (`first_order.steering_derivatives`). Its
run then needs only one integration without play: play makes the car skip parts of that track and stand on a circle for
others. So its own track is a chain of rigid copies of pieces, and the return error may be any number. Peaks and valleys
stay at their nominal cam angles; that they move a little changes a run in the second order only, for the lift is level
there.

With friction and drag each car's cam leads its gears where its own let it. The torque that turns a cam ahead of its
gears is linear in the rod's force, in friction and in drag, with the same lever arms for all cars. So the places where
it is above 0 are found for many cars at once, on stations over the falls of the lift, and between two stations by a
straight line.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Contact, EdgeFollower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run
from cadgen.car.running.mechanics import Mechanics, levers
from cadgen.car.running.play import LEAST_SWING, falls
from cadgen.car.steering import Car
from cadgen.deviations.deviation import (
    CAM_PHASE,
    DRAG,
    DRIVE_WHEEL_OFFSET,
    EDGE_BREAK,
    EDGE_WEAR,
    INNER_FACE,
    OUTER_FACE,
    RETURN_ERROR,
    ROD_FORCE,
    SIDE_SLIP,
    SLIDING_FRICTION,
    START_GAP,
    START_HEADING,
    START_X,
    START_Y,
    STEERING_ZERO,
    TEMPERATURE,
    WHEEL_RADIUS,
    WHEELBASE,
)
from cadgen.deviations.first_order import Expansion, OtherEdge, steering_derivatives
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.course_margins import CourseItem
from cadgen.inference.monte_carlo.tracks import NominalSteering, Tracks

_STEP = radians(0.1)  # between stations: the end of the run errs by less than 0.1 mm
_HALVINGS = 30  # of a step, in the search for a change of face


@dataclass(frozen=True)
class LeadIntervals:
    """A run cut where the cam jumps, stops or goes on, for m cars and s stretches.

    Attributes:
        motor: motor positions at the ends of the stretches, shape (m, s + 1), rad.
        cam: cam angle at the start of each stretch, shape (m, s), rad.
        waits: whether the cam stands still on the stretch, shape (m, s).
    """

    motor: Array
    cam: Array
    waits: NDArray[np.bool_]


@dataclass(frozen=True, kw_only=True)
class CamTorques:
    """Torque that turns the nominal cam ahead, in parts that vary from car to car.

    Attributes:
        mechanics: friction and drag of the nominal car.
        cut: lift that the cam was cut for.
        angle: stations over its falls, shape (n,), rad.
        ends: indices of the stations that are ends of falls, shape (e,).
        parts: parts of the torque at each station, shape (6, n): of the force at zero lift, that times friction, of its
            growth with the lift, that times friction, of drag, and that times friction.
    """

    mechanics: Mechanics
    cut: PathMotion
    angle: Array
    ends: NDArray[np.intp]
    parts: Array

    @classmethod
    def of(cls, mechanics: Mechanics, cut: PathMotion, least_swing: float) -> "CamTorques":
        """Lever arms over the falls of a lift; swings of tan(beta) smaller than `least_swing` are passed over.

        Args:
            mechanics: forces and friction on the cam.
            cut: lift that is cut.
            least_swing: least rise or fall of tan(beta) that counts.
        """
        pieces = [np.linspace(p, v, int((v - p) / _STEP) + 9) for p, v in falls(cut, least_swing).tolist()]
        pieces = [np.union1d(piece, _sides(cut, piece)) for piece in pieces]
        last = np.cumsum([len(piece) for piece in pieces], dtype=int)
        angle = np.concatenate(pieces) if pieces else np.empty(0)
        at = levers(cut, mechanics.follower, angle)
        parts = [at.driving, at.holding, at.lift * at.driving, at.lift * at.holding, at.along, at.across]
        ends = np.concatenate([np.append(0, last[:-1]), last - 1]) if pieces else np.empty(0, dtype=int)
        return cls(mechanics=mechanics, cut=cut, angle=angle, ends=ends.astype(np.intp), parts=np.stack(parts))

    def of_cars(self, deviations: Array) -> tuple[Array, Array, Array]:
        """Friction, drag and rod force of cars, each of shape (m,).

        Args:
            deviations: deviations of m cars, columns and units as `deviation.COLUMNS`, shape (m, c).
        """
        nominal = self.mechanics
        friction = np.maximum(nominal.friction + deviations[:, SLIDING_FRICTION.column], 0.0)
        drag = np.maximum(nominal.drag + deviations[:, DRAG.column], 0.0)
        return friction, drag, nominal.rod_force + deviations[:, ROD_FORCE.column]

    def leads(self, deviations: Array) -> tuple[Array, Array]:
        """Cam angles between which each of m cars' cams lead, both of shape (m, k), rad, in order.

        A car with fewer stretches than another has some of no length at the end.

        Args:
            deviations: deviations of m cars, columns and units as `deviation.COLUMNS`, shape (m, c).
        """
        friction, drag, force = self.of_cars(deviations)
        rate = self.mechanics.rod_rate * np.ones_like(force)
        factors = np.stack([force, -force * friction, rate, -rate * friction, -drag, -drag * friction], axis=1)
        # Not `@`: a library's threads would compete with other processes for so small a product.
        value = np.einsum("ci,ij->cj", factors, self.parts)
        ahead = value > 0
        ahead[:, self.ends] = False
        flips = ahead[:, 1:] != ahead[:, :-1]
        rows, left = np.divmod(np.flatnonzero(flips), flips.shape[1])  # np.nonzero takes ten times as long
        low, high = value[rows, left], value[rows, left + 1]
        crosses = (low > 0) != (high > 0)  # if not, it leads up to the end of the fall
        share = np.where(crosses, low / np.where(crosses, low - high, 1.0), ahead[rows, left])
        place = self.angle[left] + (self.angle[left + 1] - self.angle[left]) * share
        # In turn a start and an end, row by row.
        count = np.bincount(rows[::2], minlength=len(force))
        most = int(count.max(initial=0))
        number = np.arange(len(rows) // 2) - np.repeat(np.cumsum(count) - count, count)
        leads = np.full((2, len(force), most), self.angle[-1] if self.angle.size else 0.0)
        for side in (0, 1):
            leads[side, rows[side::2], number] = place[side::2]
        return leads[0], leads[1]


def _sides(lift: PathMotion, angle: Array) -> Array:
    """Cam angles on both sides of each change of face, where the torque leaps, rad."""
    left = np.flatnonzero((lift.q(angle[1:]) >= 0) != (lift.q(angle[:-1]) >= 0))
    low, high = angle[left], angle[left + 1]
    above = lift.q(low) >= 0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        same = (lift.q(middle) >= 0) == above
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return np.concatenate([low, high])


def lead_intervals(peak: Array, valley: Array, play: Array, phase: Array, last: float) -> LeadIntervals:
    """Runs of cams that lead from peaks to valleys.

    Args:
        peak, valley: cam angles of one turn, shape (m, k), or (1, k) for all cars, rad.
        play: return error of each car, shape (m,), rad.
        phase: motor position of each car at its start, shape (m,), rad.
        last: greatest motor position of a station, rad.
    """
    turns = TURN * np.arange(-1, np.ceil(last / TURN) + 1)
    peak, valley = (np.reshape(side[:, None, :] + turns[:, None], (len(side), -1)) for side in (peak, valley))
    play = play[:, None]
    arrive = np.maximum(peak, valley - play)
    # In turn: ahead by B from the peak, waiting from the arrival, pushed from the valley.
    motor = np.stack(np.broadcast_arrays(peak, arrive, valley), axis=2).reshape(len(play), -1)
    motor = np.maximum(motor, phase[:, None])
    # LeadIntervals before the start shrink to nothing; the last, after the last valley, begins beyond every station.
    motor = np.concatenate([phase[:, None], motor], axis=1)
    motor = np.concatenate([motor, motor[:, -1:]], axis=1)
    cam = motor[:, :-1].copy()
    cam[:, 1::3] += play
    cam[:, 2::3] = valley
    waits = np.zeros(cam.shape[1], dtype=bool)
    waits[2::3] = True
    return LeadIntervals(motor, cam, np.broadcast_to(waits, cam.shape))


def standing(stretches: LeadIntervals, gap: Array) -> LeadIntervals:
    """Runs whose gears first turn through a gap between the teeth, while the cam stands.

    Args:
        stretches: runs without a gap.
        gap: of each car, at the camshaft, shape (m,), rad.
    """
    begins = stretches.motor[:, :1] - gap[:, None]
    return LeadIntervals(
        np.concatenate([begins, stretches.motor], axis=1),
        np.concatenate([stretches.motor[:, :1], stretches.cam], axis=1),
        np.concatenate([np.ones(begins.shape, dtype=bool), stretches.waits], axis=1),
    )


def behind_a_brake(forces: CamTorques, deviations: Array, play: Array, phase: Array, last: float) -> LeadIntervals:
    """Runs of cams with play on a shaft that is braked: car by car, for there shaft and cam lead in turn.

    Args:
        forces: torques on the cam.
        deviations: deviations of m cars, shape (m, c), columns and units as `deviation.COLUMNS`.
        play: return error of each car, rad, shape (m,).
        phase: angle by which each cam stands ahead on its shaft, rad, shape (m,).
        last: motor position at which the runs end, rad.
    """
    friction, drag, force = forces.of_cars(deviations)
    cars = []
    for car, (car_play, start) in enumerate(zip(play, phase, strict=True)):
        mechanics = replace(forces.mechanics, friction=friction[car], drag=drag[car], rod_force=force[car])
        following = mechanics.leads(forces.cut).follow(forces.cut, float(car_play))
        motor = np.concatenate([[start], following.joints(float(start), last), [last]])
        middle, width = (motor[1:] + motor[:-1]) / 2, np.diff(motor)
        cam = following.cam_angle(middle)
        waits = following.cam_angle(middle + width / 4) - cam < width / 8
        cars.append((motor, np.where(waits, cam, cam - width / 2), waits))
    most = max(len(motor) for motor, _, _ in cars)
    # What a run has less than the longest are stretches of no length at its end.
    return LeadIntervals(
        np.stack([np.pad(motor, (0, most - len(motor)), mode="edge") for motor, _, _ in cars]),
        np.stack([np.pad(cam, (0, most - 1 - len(cam)), mode="edge") for _, cam, _ in cars]),
        np.stack([np.pad(waits, (0, most - 1 - len(waits)), mode="edge") for _, _, waits in cars]),
    )


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
class Cars(NominalSteering):
    """The nominal car, ready to be varied.

    Attributes:
        falls: cam angles between which the nominal lift falls, shape (k, 2), rad.
        play: nominal return error B, rad.
        stations: motor positions at which poses are computed, increasing, shape (g,), rad.
        planned: poses of the planned run there, for one car.
        expansion: thermal expansion of disc and frame.
        forces: torques that turn the cam ahead or hold it; None if it leads on every fall.
        end: number of the station at the end of the run.
        items: what the cars must keep of a course.
    """

    falls: Array
    play: float
    stations: Array
    planned: Poses
    expansion: Expansion
    forces: CamTorques | None
    end: int = -1
    items: tuple[CourseItem, ...] = ()


def nominal_cars(
    contact: Contact,
    follower: EdgeFollower,
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
    orders: Sequence[float] = (),
) -> Cars:
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
        orders: turns of each shaft of the train for one of the camshaft, from the camshaft on.

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
    return Cars(
        tan_beta=contact.q,
        derivatives=steering_derivatives(
            contact,
            follower,
            car.steering_gain,
            expansion,
            orders=orders,
            stiffening=0.0 if mechanics is None else mechanics.rod_rate / mechanics.rod_force,
        ),
        other=OtherEdge.of(contact, follower),
        falls=falls(lift, least_swing),
        car=car,
        length=length,
        wheel_radius=wheel_radius,
        play=play,
        stations=motor,
        planned=Poses(planned.heading[chosen][None] - heading, (x + 1j * y)[None] * np.exp(-1j * heading)),
        expansion=expansion or Expansion(),
        forces=None if mechanics is None else CamTorques.of(mechanics, lift, least_swing),
    )


def run_cars(cars: Cars, deviations: Array, stations: Array | None = None) -> Poses:
    """Run m cars at once.

    The grid carries the trapezoidal rule for the heading, arcs for the position, and cubic interpolation between its
    points, so the poses err with the square of its step.

    Args:
        cars: nominal car.
        deviations: deviations of m cars, shape (m, c), columns and units as `deviation.COLUMNS`.
        stations: motor positions of each car, shape (m, g), rad; the same for all if left out.
    """
    own = None if stations is None else np.broadcast_to(stations, (len(deviations), np.shape(stations)[-1]))
    blocks = [slice(first, first + _AT_ONCE) for first in range(0, len(deviations), _AT_ONCE)]
    poses = [_run(cars, deviations[block], None if own is None else own[block]) for block in blocks]
    return Poses(*(np.concatenate([getattr(each, name) for each in poses]) for name in ("heading", "position")))


def _run(cars: Cars, deviations: Array, stations: Array | None) -> Poses:
    deviations = _combined(cars, deviations)
    play = np.maximum(cars.play + deviations[:, RETURN_ERROR.column], 0.0)
    rate = cars.length / TURN * (1 + deviations[:, WHEEL_RADIUS.column] / cars.wheel_radius)
    phase = deviations[:, CAM_PHASE.column]
    first, last = float(phase.min()), float(cars.stations[-1] + phase.max() + play.max())
    track = Tracks.of(cars, deviations, rate, first, last)
    if cars.forces is None:
        stretch = lead_intervals(cars.falls[None, :, 0], cars.falls[None, :, 1], play, phase, last)
    elif cars.forces.mechanics.behind > 0:
        stretch = behind_a_brake(cars.forces, deviations, play, phase, last)
    else:
        stretch = lead_intervals(*cars.forces.leads(deviations), play, phase, last)
    gap = np.clip(deviations[:, START_GAP.column], 0.0, play)
    if gap.any():
        stretch = standing(stretch, gap)
    turned, moved = track.between(stretch.cam, stretch.motor[:, 1:] - stretch.motor[:, :-1], stretch.waits)
    zero = np.zeros((len(play), 1))
    heading = deviations[:, START_HEADING.columns] + np.concatenate([zero, np.cumsum(turned, axis=1)], axis=1)
    position = np.concatenate([zero, np.cumsum(np.exp(1j * heading[:, :-1]) * moved, axis=1)], axis=1)

    motor = (cars.stations if stations is None else stations) + (phase - gap)[:, None]
    # Car by car: of thousands of stations and stretches, a table of all with all would take gigabytes.
    begins = zip(stretch.motor[:, :-1], motor, strict=True)
    at = np.stack([np.searchsorted(starts, positions, side="right") for starts, positions in begins]) - 1
    rows = np.arange(len(play))[:, None]
    turned, moved = track.between(stretch.cam[rows, at], motor - stretch.motor[rows, at], stretch.waits[rows, at])
    position = position[rows, at] + np.exp(1j * heading[rows, at]) * moved
    start = deviations[:, START_X.columns] + 1j * deviations[:, START_Y.columns]
    return Poses(heading[rows, at] + turned, start + rate[:, None] * position)


def _combined(cars: Cars, deviations: Array) -> Array:
    """Deviations with broken and worn edges, side slip and a frame grown by heat among what they change."""
    out = deviations.copy()
    edges = deviations[:, EDGE_BREAK.column] + deviations[:, EDGE_WEAR.column]
    growth = cars.expansion.frame * deviations[:, TEMPERATURE.column]
    out[:, INNER_FACE.column] += edges
    out[:, OUTER_FACE.column] -= edges
    out[:, STEERING_ZERO.column] += deviations[:, SIDE_SLIP.column]
    out[:, WHEELBASE.column] += cars.car.wheelbase * growth
    out[:, DRIVE_WHEEL_OFFSET.column] += cars.car.drive_wheel_offset * growth
    return out
