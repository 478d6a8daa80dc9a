"""Runs of many cars cut where their cams jump, stop or go on; each car with its own friction, drag and rod force.

The torque that turns a cam ahead of its gears is linear in the rod's force, in friction and in drag, with the same
lever arms for all cars. So the places where it is above 0 are found for many cars at once, on stations over the falls
of the lift, and between two stations by a straight line.
"""

from dataclasses import dataclass, replace
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.motion.mechanics import Mechanics, levers
from cadgen.car.motion.play import falls
from cadgen.car.path_motion import PathMotion
from cadgen.deviations.deviation import DRAG, ROD_FORCE, SLIDING_FRICTION

_STEP = radians(0.1)  # between stations: the end of the run errs by less than 0.1 mm
_HALVINGS = 30  # of a step, in the search for a change of face


@dataclass(frozen=True)
class Stretches:
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
class Forces:
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
    def of(cls, mechanics: Mechanics, cut: PathMotion, least_swing: float) -> "Forces":
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
            deviations: deviations of m cars, columns and units as `deviation.COLUMNS`, shape (m, 29).
        """
        nominal = self.mechanics
        friction = np.maximum(nominal.friction + deviations[:, SLIDING_FRICTION.column], 0.0)
        drag = np.maximum(nominal.drag + deviations[:, DRAG.column], 0.0)
        return friction, drag, nominal.rod_force + deviations[:, ROD_FORCE.column]

    def leads(self, deviations: Array) -> tuple[Array, Array]:
        """Cam angles between which each of m cars' cams lead, both of shape (m, k), rad, in order.

        A car with fewer stretches than another has some of no length at the end.

        Args:
            deviations: deviations of m cars, columns and units as `deviation.COLUMNS`, shape (m, 29).
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
    """Both sides of the places at which the rod goes over to the other face, where the torque leaps; rad."""
    left = np.flatnonzero((lift.q(angle[1:]) >= 0) != (lift.q(angle[:-1]) >= 0))
    low, high = angle[left], angle[left + 1]
    above = lift.q(low) >= 0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        same = (lift.q(middle) >= 0) == above
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return np.concatenate([low, high])


def stretches(peak: Array, valley: Array, play: Array, phase: Array, last: float) -> Stretches:
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
    # Stretches before the start shrink to nothing; the last, after the last valley, begins beyond every station.
    motor = np.concatenate([phase[:, None], motor], axis=1)
    motor = np.concatenate([motor, motor[:, -1:]], axis=1)
    cam = motor[:, :-1].copy()
    cam[:, 1::3] += play
    cam[:, 2::3] = valley
    waits = np.zeros(cam.shape[1], dtype=bool)
    waits[2::3] = True
    return Stretches(motor, cam, np.broadcast_to(waits, cam.shape))


def behind_a_brake(forces: Forces, deviations: Array, play: Array, phase: Array, last: float) -> Stretches:
    """Runs of cams with play on a shaft that is braked: car by car, for there shaft and cam lead in turn.

    Args:
        forces: torques on the cam.
        deviations: deviations of m cars, shape (m, 29), columns and units as `deviation.COLUMNS`.
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
    return Stretches(
        np.stack([np.pad(motor, (0, most - len(motor)), mode="edge") for motor, _, _ in cars]),
        np.stack([np.pad(cam, (0, most - 1 - len(cam)), mode="edge") for _, cam, _ in cars]),
        np.stack([np.pad(waits, (0, most - 1 - len(waits)), mode="edge") for _, _, waits in cars]),
    )
