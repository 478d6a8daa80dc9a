"""A lift turned ahead where the cam leads, for cars whose rod rubs.

With friction the gears drive the cam on the gentler parts of each fall, and it leads by the play B on the steeper ones.
So a cam is wrong on those only: there it must come B later. The lift is turned ahead by a window w from where a lead
begins to where it ends,

    s_c(theta + w(theta)) = s(theta),  w going from 0 to w before the lead and back after it,

each lead with a window of its own. Everywhere else the lift is the wanted one, and the car gets it.

The window goes from 0 to w over a ramp on which the fall is stretched, so that friction holds the cam there until the
gears have come up. It goes back over a second ramp, on which the fall is steeper; where the valley is near, the fall
meets the rise after it as in a dilation. With w below 0 the two ramps change their parts. A ramp is so long that the
profile, which is convex where the fall steepens, keeps a radius.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf, radians

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.against_play.compensation import VALLEY_SHARE, closed_lift, nodes_between, valley_crossing
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import Mechanics
from cadgen.car.running.play import falls
from cadgen.errors import DesignError

_BEFORE = radians(0.05)  # a ramp begins so much before its lead, which rounding may move
_CONVEX = 0.7  # mm; radius left to the profile on a ramp
_AS_BEFORE = 1.02  # times the curvature that the wanted lift has there: a ramp on a sharper place adds no more
_STEEPEST = 0.5  # of the angle that a fall takes: a ramp makes it no steeper than twice
_RISING, _FALLING = 1.0, 3.0  # lengths of the two ramps over the window, where the profile bears that
_SHORTEST = radians(0.15)
_LONGEST = radians(40.0)
_LONGER = 1.15  # times a ramp that is too sharp
_GAP = 3.0  # windows; leads of one fall that are closer together are one
_SHORT = 1.5  # windows; a shorter lead is left alone, for its ramps would do more than it
_STATIONS = 41  # of a ramp at which its radius is looked at
_PARTS = 8  # quintics of a ramp


@dataclass(frozen=True, kw_only=True)
class _Lead:
    """Lead of the wanted lift, with its ramps.

    Attributes:
        start: cam angle at which the first ramp begins, rad.
        rising: length of that ramp, rad.
        stop: cam angle at which the second ramp begins, rad; the valley's where there is none.
        falling: length of that ramp, rad; 0 where the fall meets the rise instead.
        fall: number of its fall.
        earliest: least cam angle at which the first ramp may begin, rad.
    """

    start: float
    rising: float
    stop: float
    falling: float
    fall: int
    earliest: float


@dataclass(frozen=True)
class TurnedLeads:
    """Family of lifts that are turned ahead on the leads of a wanted lift.

    Attributes:
        lift: lift wanted by motor position.
        follower: follower of the car.
        forces: forces on the cam that say where it leads.
        widest: widest window that the ramps have room for, rad.
        least: least window, rad; below 0 where leads may come earlier.
    """

    lift: PathMotion
    follower: EdgeFollower
    forces: Mechanics
    widest: float
    least: float = 0.0

    @property
    def count(self) -> int:
        """Number of leads that can be turned."""
        return len(self._leads)

    @property
    def middles(self) -> Array:
        """Cam angles in the middle of each lead, rad."""
        return np.array([(lead.start + lead.stop) / 2 for lead in self._leads])

    @property
    def valleys(self) -> Array:
        """Cam angles of the valley after each lead, rad."""
        return np.array([self._pairs[lead.fall, 1] for lead in self._leads])

    @property
    def earlier(self) -> Array:
        """Angle by which the first ramp of each lead may begin earlier, rad."""
        return np.array([max(lead.start - lead.earliest, 0.0) for lead in self._leads])

    @property
    def later(self) -> Array:
        """Angle by which the first ramp of each lead may begin later, rad."""
        return np.array([max(0.6 * (lead.stop - lead.start) - lead.rising, 0.0) for lead in self._leads])

    def turned(self, windows: Sequence[float] | Array, moved: Sequence[float] | Array | None = None) -> PathMotion:
        """Lift by cam angle that comes later by a window on each lead.

        Args:
            windows: windows of the leads, shape (k,), rad; below 0 the lift comes earlier.
            moved: angles by which the first ramps begin earlier, shape (k,), rad.

        Raises:
            DesignError: a window is wider than its ramps have room for.
        """
        moved = np.zeros(len(self._leads)) if moved is None else moved
        row = _Row(self.lift)
        for lead, window, by in zip(self._leads, windows, moved, strict=True):
            if abs(window) < 1e-9:
                continue
            start = (lead.start - float(by) + TURN) - TURN  # rounded, so that a turn later it is the same place
            row.level(start, 0.0)
            row.ramp(start, lead.rising, 0.0, float(window))
            if lead.falling:
                row.level(lead.stop, float(window))
                row.ramp(lead.stop, lead.falling, float(window), 0.0)
            elif window > 0:  # the fall goes on until it meets the rise after it
                crossing = valley_crossing(self.lift, float(window), self._pairs, lead.fall)
                blend = VALLEY_SHARE * float(window)
                if crossing is None:
                    raise _no_room(lead.stop)
                row.level(crossing - blend - float(window), float(window))
                row.skip(crossing + blend)
            else:
                back = _FALLING * abs(float(window))
                row.level(lead.stop - back, float(window))
                row.ramp(lead.stop - back, back, float(window), 0.0)
        return row.closed(self.lift.blend_start) if row.begun else self.lift

    @cached_property
    def _pairs(self) -> Array:
        return falls(self.lift)

    @cached_property
    def _leads(self) -> tuple[_Lead, ...]:
        found: list[_Lead] = []
        stop = self.lift.blend_start if self.lift.blended else inf
        intervals = self.forces.leads(self.lift).intervals
        if not len(intervals):
            return ()
        turned = np.concatenate([intervals, intervals + TURN])
        for number, (peak, valley) in enumerate(self._pairs.tolist()):
            inside = turned[(turned[:, 0] >= peak - 1e-9) & (turned[:, 0] < min(valley, stop))].tolist()
            spans: list[tuple[float, float]] = []
            for begin, end in sorted((max(begin - _BEFORE, peak), min(end, valley)) for begin, end in inside):
                if spans and begin - spans[-1][1] < _GAP * self.widest:
                    spans[-1] = spans[-1][0], end
                else:
                    spans.append((begin, end))
            earliest = peak
            for place, (begin, end) in enumerate(spans):
                room = spans[place + 1][0] if place + 1 < len(spans) else valley
                lead = self._lead(begin, end, room, number, earliest)
                if lead is not None:
                    found.append(lead)
                    earliest = lead.stop + lead.falling
        return tuple(found)

    def _lead(self, begin: float, end: float, room: float, fall: int, earliest: float) -> _Lead | None:
        """Lead with its ramps; None where it is too short or has no room for them."""
        valley = float(self._pairs[fall, 1])
        if end - begin < _SHORT * self.widest:
            return None
        rising = self._ramp(begin, _RISING, 1)
        if rising is None or begin + rising >= room:
            return None
        stop = max(end, begin + rising)
        falling = self._ramp(stop, _FALLING, -1)
        if falling is None or stop + falling > valley:
            stop, falling = valley, 0.0
        if stop + falling > room:
            return None
        return _Lead(start=begin, rising=rising, stop=stop, falling=falling, fall=fall, earliest=earliest)

    def _ramp(self, start: float, share: float, sense: int) -> float | None:
        """Least length of a ramp on which the profile stays smooth for the widest and the least window, rad.

        Args:
            start: cam angle at which it begins, rad.
            share: length over the window at which the search begins.
            sense: 1 where the window grows from 0, -1 where it goes back.
        """
        length = max(share * self.widest, _SHORTEST)
        while length < _LONGEST:
            if all(self._smooth(start, length, sense * window) for window in {self.widest, self.least} - {0.0}):
                return length
            length *= _LONGER
        return None

    def _smooth(self, start: float, length: float, growth: float) -> bool:
        theta = np.linspace(start, start + length, _STATIONS)[1:-1]
        jets = np.stack([self.lift.q(theta, nu=order) for order in range(3)], axis=1)
        _, rate, bend = _smooth_step((theta - start) / length)
        stretch = 1 + growth * rate / length
        if stretch.min() < _STEEPEST:
            return False
        ramped = _stretched(jets, stretch, growth * bend / length**2)
        most = max(1 / (self.follower.radius + _CONVEX), _AS_BEFORE * float(self._curvature(jets).max()))
        return bool(self._curvature(ramped).max() <= most)

    def _curvature(self, jets: Array) -> Array:
        """Curvature of the track of the follower's axis about the disc, 1/mm, positive where it is convex."""
        face = self.follower.contact_face(jets[:, 0])
        d, first, second = self.follower.base_radius + face * jets[:, 0], face * jets[:, 1], face * jets[:, 2]
        return np.asarray((d**2 + 2 * first**2 - d * second) / (d**2 + first**2) ** 1.5)


class _Row:
    """Nodes of a lift that is turned ahead by a window that changes, in order."""

    def __init__(self, lift: PathMotion) -> None:
        self._lift = lift
        self._parts: list[tuple[Array, Array]] = []
        self._begin = self._at = 0.0
        self.begun = False

    def level(self, stop: float, window: float) -> None:
        """Nodes up to a cam angle, turned ahead by one window; the first call says where the row begins."""
        if not self.begun:
            self._begin = self._at = stop
            self.begun = True
        elif stop < self._at - 1e-12:
            raise _no_room(stop)
        elif stop > self._at + 1e-12:
            self._parts.append(nodes_between(self._lift, self._at, stop, ahead=window))
            self._at = stop

    def ramp(self, start: float, length: float, before: float, after: float) -> None:
        """Nodes of a ramp from one window to another."""
        x, jets = nodes_between(self._lift, start, start + length, widest=length / _PARTS)
        share, rate, bend = _smooth_step((x - start) / length)
        stretch = 1 + (after - before) * rate / length
        if stretch.min() < _STEEPEST / 2:
            raise _no_room(start)
        bent = (after - before) * bend / length**2
        # In brackets, so that nodes of neighbouring stretches are equal to the last bit.
        self._parts.append((x + (before + (after - before) * share), _stretched(jets, stretch, bent)))
        self._at = start + length

    def skip(self, stop: float) -> None:
        """A quintic up to a cam angle, from which on the lift is the wanted one."""
        self._at = stop

    def closed(self, blend_start: float) -> PathMotion:
        """Lift through the nodes, once round."""
        self.level(self._begin + TURN, 0.0)
        x, jets = (np.concatenate(part) for part in zip(*self._parts, strict=True))
        return closed_lift(x - TURN * (self._begin // TURN), jets, blend_start)


def _smooth_step(u: Array) -> tuple[Array, Array, Array]:
    """Quintic from 0 to 1 without slope and curvature at its ends, and two derivatives."""
    u = np.clip(u, 0.0, 1.0)
    return u**3 * (10 - 15 * u + 6 * u**2), 30 * u**2 * (1 - u) ** 2, 60 * u * (1 - u) * (1 - 2 * u)


def _stretched(jets: Array, stretch: Array, bend: Array) -> Array:
    """Jets by x of a function of theta, for x with the derivatives `stretch` and `bend` by theta."""
    slope = jets[:, 1] / stretch
    return np.stack([jets[:, 0], slope, (jets[:, 2] - slope * bend) / stretch**2], axis=1)


def _no_room(cam_angle: float) -> DesignError:
    return DesignError(
        "the lead at cam angle {cam_angle:.1f} degrees has no room for a window as wide as that",
        cam_angle=np.degrees(cam_angle),
    )
