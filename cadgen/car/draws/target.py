"""Error of the car against the scaled path with some setting, by the steering of one disc at any place on its shaft.

The rod is rolled on the disc at Chebyshev places of disc and head; between them the lift, which hardly changes, is
interpolated by polynomials (Trefethen, Approximation Theory and Approximation Practice, ch. 5).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.draws.setting_ranges import COUNT, DISC, HEAD, HEADING, TRAVEL, SettingRange, SettingRanges, X, Y
from cadgen.car.running.drive import MIDPOINT, Pose, driven
from cadgen.car.steering import Car, wheel_tangent

_DISC_PLACES, _HEAD_PLACES = 6, 3

# Follower -> tan(beta) at the stations, shape (n,).
Rolling = Callable[[EdgeFollower], Array]


def moved_rod(rod: EdgeFollower, disc: float, head: float) -> EdgeFollower:
    """The rod on a disc that was moved on its shaft, with another base radius.

    Args:
        rod: rod as designed.
        disc: disc moved away from the fork axis, mm.
        head: growth of the base radius, mm.
    """
    return replace(rod, inner=rod.inner + disc, outer=rod.outer + disc, base_radius=rod.base_radius + head)


@dataclass(frozen=True, eq=False)
class Steering:
    """Steering of a disc by its place and by the head.

    Attributes:
        rod: rod as designed.
        discs: places of the disc at which the rod was rolled, shape (k,), mm.
        heads: settings of the head at which it was, shape (l,), mm.
        lifts: tan(beta) times the distance of the inner plane, shape (k, l, n), mm.
    """

    rod: EdgeFollower
    discs: Array
    heads: Array
    lifts: Array

    @classmethod
    def of(cls, rod: EdgeFollower, disc: SettingRange, head: SettingRange, rolling: Rolling) -> "Steering":
        """Roll the rod at the places between which it is interpolated.

        Args:
            rod: rod as designed.
            disc, head: ranges.
            rolling: function that rolls a rod on the disc.

        Raises:
            DesignError: the rod cannot be rolled on the disc at some place.
        """
        discs, heads = _chebyshev(disc, _DISC_PLACES), _chebyshev(head, _HEAD_PLACES)
        lifts = [[rolling(moved_rod(rod, d, h)) * (rod.inner + d) for h in heads.tolist()] for d in discs.tolist()]
        return cls(rod, discs, heads, np.array(lifts))

    def tan_beta(self, disc: float, head: float) -> Array:
        """Tangent of the steering angle at the stations, shape (n,).

        Args:
            disc: disc moved away from the fork axis, mm.
            head: displacement of the rod by the micrometer head, mm.
        """
        weights = np.outer(_weights(self.discs, disc), _weights(self.heads, head))
        return np.asarray(np.tensordot(weights, self.lifts, axes=2) / (self.rod.inner + disc))


def _chebyshev(span: SettingRange, count: int) -> Array:
    if not span.turns:
        return np.array([span.low])
    middle, half = (span.low + span.high) / 2, (span.high - span.low) / 2
    return np.asarray(middle + half * np.cos(np.pi * (np.arange(count) + 0.5) / count))


def _weights(places: Array, at: float) -> Array:
    """Lagrange weights of the places for a value in their range, shape (k,)."""
    off = at - places
    apart = places[:, None] - places[None, :]
    np.fill_diagonal(apart, 1.0)
    others = np.where(np.eye(len(places), dtype=bool), 1.0, off[None, :])
    return np.asarray((others / apart).prod(axis=1))


Complex = NDArray[np.complex128]
_ROUNDING = 1e-9  # rad
# Steps of the settings for derivatives: mm, mm, share of the travel, mm, mm, rad.
_STEPS = np.array([1e-4, 1e-5, 1e-6, 1e-3, 1e-3, 1e-6])


@dataclass(frozen=True, eq=False)
class Target:
    """The path of one spacing, and the car that is to drive it.

    Attributes:
        nodes: cam angles between which the car is driven, shape (n + 1,), rad; the stations of `steering` are these
            and the middles between them in turn. A turn that is driven again and again ends with its start.
        motor: motor positions at which the car is held against the path, shape (m,), rad; at nodes, of any turn.
        places: planned point of the scaled path there, x + iy, shape (m,), mm.
        heading: heading of the path at its start, rad.
        offset: how far the planned point is to the right of the drive wheel, mm.
        car: the car in plan view.
        steering: what the disc gives.
        rim: travel of the drive wheel as built, by that as designed.
    """

    nodes: Array
    motor: Array
    places: Complex
    heading: float
    offset: float
    car: Car
    steering: Steering
    rim: float = 1.0

    def start(self, values: Array) -> Pose:
        """Pose of the drive wheel at the start, mm and rad, with settings of shape (6,).

        Args:
            values: settings, shape (6,), mm and rad.
        """
        heading = self.heading + float(values[HEADING])
        place = complex(self.places[0]) + complex(values[X], values[Y]) + 1j * self.offset * np.exp(1j * heading)
        return Pose(x=place.real, y=place.imag, heading=heading)

    def errors(self, values: Array) -> Complex:
        """Distance of the planned point from its place on the path at the same motor position, x + iy, shape (m,), mm.

        Args:
            values: settings, shape (6,), mm and rad.
        """
        tangent = wheel_tangent(self.steering.tan_beta(float(values[DISC]), float(values[HEAD])), self.car)
        middles = tangent[1 : 2 * len(self.nodes) - 2 : 2, None]
        heading, place = driven(
            self.nodes, lambda _: middles, self.car, self.rim * float(values[TRAVEL]), self.start(values), MIDPOINT
        )
        first = planned_point(place, heading, self.offset)
        turns, number = self._reached
        # Each turn moves the car by one and the same rigid motion.
        turned = np.exp(1j * (heading[-1] - heading[0]) * np.arange(turns[-1] + 1))
        begins = first[0] + (first[-1] - first[0]) * np.append(0.0, np.cumsum(turned[:-1]))
        return np.asarray(begins[turns] + turned[turns] * (first[number] - first[0]) - self.places)

    @cached_property
    def _reached(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Whole turns behind the car at the motor positions, and numbers of the nodes at which it is."""
        turns = np.maximum(np.ceil(self.motor / TURN - _ROUNDING) - 1, 0).astype(int)
        return turns, np.searchsorted(self.nodes, self.motor - TURN * turns - _ROUNDING)

    def derivatives(self, values: Array, errors: Complex, ranges: SettingRanges) -> Complex:
        """Derivatives of the errors (mm) by the settings, shape (m, 6); 0 for what cannot be set.

        Args:
            values: settings, shape (6,), mm and rad.
            errors: errors with these settings, x + iy, shape (m,), mm.
            ranges: what can be set.
        """
        bounds, by = ranges.bounds, np.zeros((len(errors), COUNT), dtype=complex)
        for number in range(COUNT):
            low, high = bounds[number]
            if high <= low:
                continue
            step = _STEPS[number] * (values[TRAVEL] if number == TRAVEL else 1.0)
            step = -step if values[number] + step > high else step
            moved = values.copy()
            moved[number] += step
            by[:, number] = (self.errors(moved) - errors) / step
        return by


def planned_point(wheel: Complex, heading: Array, offset: float) -> Complex:
    """Places of the planned point, x + iy, mm, by those of the drive wheel.

    Args:
        wheel: places of the drive wheel, x + iy, mm.
        heading: headings, rad.
        offset: how far the planned point is to the right of the drive wheel, mm.
    """
    return np.asarray(wheel - 1j * offset * np.exp(1j * heading))
