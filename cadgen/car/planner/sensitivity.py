"""Error by the play of the gears at the end of the run, to first order.

A cam that is cut for a return error B gives back the lift wanted at B. With another, B + d, the car meets on each fall
the turning rate of d further on: over a fall it turns by d times the fall of its turning rate, whatever the profile is
(`cadgen.car.against_play.band.fixed_profile_bound`). The lift falls where the curvature of the drive wheel's track
rises:

    heading of the end = d R int max(dK/ds, 0) ds,    place of the end = d R int max(dK/ds, 0) J (E - Q) ds,

with K the curvature, R the travel for a radian of the cam, Q the drive wheel, E its place at the end of the run, and J
a quarter turn. On the paper's car this gives 306.7 mm where the exact chain gives 306.1.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.planner.kinematics import Kinematics
from cadgen.car.planner.path_task import Vehicle

# What a fall costs besides what it does at the end of the run, as a share of the path's length taken as its lever. It
# keeps the heading of the end small and the last stretch calm, where the lever is short.
_CALM = 0.01
# On a closed path all of it turns, and goes on turning: there the lever is the radius of a circle of that length.
_CALM_LAP = 1 / TURN
_DIRECTIONS = 9  # in which the length of the error is bounded from below, about the present one
_WIDEST = 0.7  # rad to either side


@dataclass(frozen=True, eq=False)
class TrackLength:
    """Length of the drive wheel's track and the end of the run on it.

    Attributes:
        motion: the car at even parameters, an even number to each span.
        vehicle: the car.
    """

    motion: Kinematics
    vehicle: Vehicle

    @cached_property
    def _weights(self) -> Array:
        """Weights of Simpson's rule, shape (m,)."""
        u = self.motion.places.u
        weights = np.full(len(u), (u[1] - u[0]) * 2 / 3)
        weights[1::2] *= 2
        weights[[0, -1]] /= 2
        return weights

    @cached_property
    def length(self) -> float:
        """Length of the track, mm."""
        return float(self._weights @ self.motion.quantities[3])

    @cached_property
    def by_points(self) -> Array:
        """Derivative of the length by all x and then all y, shape (2 n,)."""
        total = np.zeros(2 * self.motion.places.count)
        np.add.at(total, self.motion.places.both, self._weights[:, None] * self.motion.slopes[3])
        return total

    @cached_property
    def arc(self) -> Array:
        """Arc length at the places, shape (m,), mm."""
        speed, u = self.motion.quantities[3], self.motion.places.u
        arc = np.append(0.0, np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(u)))
        return np.asarray(arc * self.length / arc[-1])

    @property
    def rate(self) -> float:
        """Travel for each radian of the cam, mm."""
        travel = self.vehicle.travel
        return (self.length / self.vehicle.path_turn if travel is None else travel) / TURN

    @cached_property
    def end(self) -> tuple[int, float]:
        """Interval between places in which the run ends, and the share of it that is driven."""
        m = len(self.arc)
        place = float(np.interp(self.vehicle.end * self.length, self.arc, np.arange(m)))
        interval = min(int(place), m - 2)
        return interval, place - interval

    @cached_property
    def end_by_points(self) -> Array:
        """Derivative of the length up to the end of the run, its parameter held, by all x, then all y, shape (2 n,)."""
        u, motion = self.motion.places.u, self.motion
        # By the trapezoid rule; with it the whole length errs by some 1e-4.
        driven = self.driven * np.diff(u)
        weights = np.zeros(len(u))
        weights[:-1] += driven / 2
        weights[1:] += driven / 2
        total = np.zeros(2 * motion.places.count)
        np.add.at(total, motion.places.both, weights[:, None] * motion.slopes[3])
        return total

    @cached_property
    def driven(self) -> Array:
        """Share of each interval that lies within the run, shape (m - 1,)."""
        interval, share = self.end
        driven = np.zeros(len(self.arc) - 1)
        driven[:interval], driven[interval] = 1.0, share
        return driven


@dataclass(frozen=True, eq=False)
class PlayCost:
    """Cost of play, with what a linear model of it is made of.

    Attributes:
        line: length and end of the run.
        spread: by how much the return error is off, rad.
    """

    line: TrackLength
    spread: float

    @cached_property
    def rises(self) -> Array:
        """Change of the curvature over each interval, above 0 where the lift falls, shape (m - 1,), 1/mm."""
        return np.asarray(self._sign * np.diff(self.line.motion.quantities[0]))

    @property
    def _sign(self) -> float:
        """Whether the lift falls where the curvature rises, or, with the cam on the other side, where it falls."""
        return 1.0 if self.line.vehicle.car.steering_gain > 0 else -1.0

    @cached_property
    def levers(self) -> Array:
        """Place of the end of the run from the middle of each interval, shape (m - 1, 2), mm."""
        track = self.line.motion.track
        interval, share = self.line.end
        end = track[interval] * (1 - share) + track[interval + 1] * share
        return np.asarray(end - (track[1:] + track[:-1]) / 2)

    @property
    def factor(self) -> float:
        """From a sum of changes of the curvature times levers to the error, mm."""
        return self.spread * self.line.rate

    @cached_property
    def falls(self) -> Array:
        """Change of the curvature where the lift falls, as far as it is driven, shape (m - 1,)."""
        return np.asarray(np.maximum(self.rises, 0.0) * self.line.driven)

    @cached_property
    def error(self) -> Array:
        """Place of the end of the run, turned by a quarter, shape (2,), mm."""
        return np.asarray(self.factor * (self.falls @ self.levers))

    @property
    def distance(self) -> float:
        """Position error of the end of the run, mm."""
        return float(np.hypot(*self.error))

    @property
    def heading(self) -> float:
        """Heading error of the end of the run, rad."""
        return float(self.factor * self.falls.sum())

    @property
    def cost(self) -> float:
        """Objective of the search: the position error, and a little for each fall of the whole path, mm."""
        return self.distance + self.calm * float(np.maximum(self.rises, 0.0).sum())

    @property
    def calm(self) -> float:
        """Cost of a unit of curvature that the path gains, mm."""
        return self.factor * (_CALM_LAP if self.line.vehicle.closed else _CALM) * self.line.length

    def by_rises(self) -> tuple[NDArray[np.intp], Array]:
        """Derivatives of `rises`: columns and values, shape (m - 1, 24)."""
        columns, slopes = self.line.motion.places.both, self._sign * self.line.motion.slopes[0]
        return np.concatenate([columns[1:], columns[:-1]], axis=1), np.concatenate([slopes[1:], -slopes[:-1]], axis=1)

    def directions(self) -> Array:
        """Unit vectors about the direction of the error, shape (k, 2)."""
        middle = np.arctan2(self.error[1], self.error[0])
        angle = middle + np.linspace(-_WIDEST, _WIDEST, _DIRECTIONS)
        return np.stack([np.cos(angle), np.sin(angle)], axis=1)

    def by_levers(self, direction: Array) -> Array:
        """Derivative of the error along a direction by the control points, the changes of curvature held, shape (2 n,).

        The length counts in the factor where the turn of the cam is as long as the path.

        Args:
            direction: unit vector of the direction, shape (2,).
        """
        motion, (interval, share) = self.line.motion, self.line.end
        m = len(self.line.arc)
        # Each place carries the weights of the two intervals beside it; the end of the run carries all of them.
        carried = np.zeros(m)
        carried[:-1] -= self.falls / 2
        carried[1:] -= self.falls / 2
        carried[interval] += (1 - share) * self.falls.sum()
        carried[interval + 1] += share * self.falls.sum()
        by_place = motion.moved(np.broadcast_to(direction, (m, 2)), 0.0, motion.offset)
        total = np.zeros(2 * motion.places.count)
        np.add.at(total, motion.places.both, self.factor * carried[:, None] * by_place)
        # The run ends at a share of the length: the end slides along the track as the way up to it changes.
        along = motion.track[interval + 1] - motion.track[interval]
        slide = self.factor * self.falls.sum() * float(direction @ along) / float(np.hypot(*along))
        total += slide * (self.line.vehicle.end * self.line.by_points - self.line.end_by_points)
        if self.line.vehicle.travel is None:
            total += float(direction @ self.error) / self.line.length * self.line.by_points
        return total
