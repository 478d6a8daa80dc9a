"""A motion: what a follower has to do in one turn of the cam, q(theta) in the follower's own coordinate."""

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import factorial
from typing import ClassVar, Self

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PPoly

from cadgen.arrays import TURN, Array
from cadgen.curves.piecewise import zeros
from cadgen.laws.form import ORDERS
from cadgen.laws.unit import Unit
from cadgen.messages import Message

# A stretch of at least this angle over which q stays within the second figure is level: the second is 0.01 um
# of lift, what rolling an outline errs by, and a smooth peak stays within it over so wide an angle only if its second
# derivative is below 0.042, a tenth of what a gentle turn has.
_LEVEL_ANGLE = np.radians(0.5)
_SNAP = 1e-12  # rad; nearer to a break than that an angle is taken as the break itself
_SAMPLES = 2048  # at which a peak of a derivative is first sought over the turn, and at least 8 on each part
_EQUAL = 1e-11  # of a peak, within which others are as great
_CLOSER, _ROUNDS = 33, 4  # samples of each further search between the neighbours of the last


@dataclass(frozen=True)
class Peak:
    """Greatest or least value of a derivative over a turn.

    Attributes:
        value: value, in the motion's unit by rad to the order.
        cam_angle: where it is, rad.
    """

    value: float
    cam_angle: float


@dataclass(frozen=True)
class Motion:
    """Motion q of a follower as a function of the cam angle, closed over one turn.

    Attributes:
        q: periodic piecewise polynomial, cam angle (rad) -> coordinate of the follower, in `unit`.
        kinks: cam angles at which the slope jumps, shape (k,), rad.
        unit: unit of q; mm, rad, or the tangent of an angle.
        known_level: level stretches, shape (m, 2), rad, of a motion whose samples are too rough to show them; None
            where the motion itself shows them.
    """

    q: PPoly
    kinks: Array
    unit: Unit = field(kw_only=True)
    known_level: Array | None = field(default=None, kw_only=True)

    noun: ClassVar[str] = Message("motion")

    def idle(self, cam_angle: Array) -> NDArray[np.bool_]:
        """Whether nothing depends on the motion at cam angles, as while a cam is only led back to its start.

        Args:
            cam_angle: cam angles, rad, shape (n,).
        """
        return np.zeros(np.shape(cam_angle), dtype=bool)

    def softer(self, cam_angle: float, key: str = "") -> str:
        """Advice that makes the motion milder at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
            key: key of the design file that shapes the motion; left out of the advice if empty.
        """
        return (
            Message("make the motion milder there ({key})", key=key) if key else Message("make the motion milder there")
        )

    def higher(self, cam_angle: float) -> str:
        """Advice that keeps the follower farther from the camshaft at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
        """
        return Message("raise the motion there")

    def fewer(self, count: int) -> str:
        """Advice for a motion with too many ripples, as part of a sentence.

        Args:
            count: how many times as many ripples as are followed.
        """
        return Message("keep one in {count} of the points of the motion", count=count)

    def jets(self, cam_angle: Array, *, before: bool = False) -> Array:
        """Motion with its first three derivatives by the cam angle, in the motion's unit by rad^k, shape (n, 4).

        They come from what the motion is made of, such as a law, and not from the pieces of `q` that follow it.

        Args:
            cam_angle: cam angles, rad, shape (n,).
            before: whether values where a derivative jumps are those of the side before; else those behind.
        """
        start, coefficients = self.q.x, self.q.c
        number, angle = side_of(start, cam_angle, before)
        t, value = angle - start[number], np.empty((len(angle), ORDERS))
        for order in range(ORDERS):
            value[:, order] = 0.0
            for row in coefficients[:, number]:
                value[:, order] = value[:, order] * t + row
            coefficients = coefficients[:-1] * np.arange(len(coefficients) - 1, 0, -1)[:, None]
        return value

    def value(self, cam_angle: float) -> float:
        """Motion at one cam angle, rad, as `q` has it to the last bit, in a tenth of the time: for searches of roots.

        Args:
            cam_angle: cam angle, rad, of any turn.
        """
        starts, parts = self._parts
        first = starts[0]
        angle = first + (cam_angle - first) % (starts[-1] - first)
        number = min(bisect_right(starts, angle), len(parts)) - 1
        step, power, found = angle - starts[number], 1.0, 0.0
        for coefficient in parts[number]:
            found += coefficient * power
            power *= step
        return found

    @cached_property
    def _parts(self) -> tuple[list[float], list[list[float]]]:
        """Starts of the parts of `q` and the end of the last, and each part's coefficients, the constant first."""
        return self.q.x.tolist(), self.q.c[::-1].T.tolist()

    @property
    def breaks(self) -> Array:
        """Cam angles at which some derivative may jump, from 0 to a turn, shape (m,), rad."""
        return np.asarray(self.q.x)

    @property
    def bends(self) -> Array:
        """Cam angles within the turn at which the acceleration is meant to jump, rad, shape (n,)."""
        return np.empty(0)

    def continuous(self, cam_angle: float) -> int:
        """Number of values meant to be continuous at a cam angle: the motion and its first derivatives, 3 at most.

        Args:
            cam_angle: cam angle, rad.
        """
        return ORDERS - 1

    def extremes(self, order: int) -> tuple[Peak, Peak]:
        """Greatest and least value of a derivative over the turn, either side of every seam, with their places.

        Args:
            order: 0 for the motion itself, 1 for its velocity, 2 for its acceleration, 3 for its jerk.
        """
        return self.extremes_of(lambda jets, theta: jets[:, order])

    def extremes_of(self, figure: Callable[[Array, Array], Array]) -> tuple[Peak, Peak]:
        """Greatest and least value over the turn of a figure of the motion, either side of every seam, with places.

        Args:
            figure: function of jets as in `jets`, shape (n, 4), and of their cam angles, rad, shape (n,).
        """
        start, stop = self.breaks[:-1], self.breaks[1:]
        count = max(9, _SAMPLES // len(start) + 1)
        theta = start[:, None] + (stop - start)[:, None] * np.linspace(0.0, 1.0, count)
        theta[:, -1] = stop
        value = self._closed(theta, figure)
        found = []
        for sign in (1.0, -1.0):
            top = float((sign * value).max())
            # Of equal peaks the first, whatever their last digits.
            part, at = divmod(int(np.argmax(sign * value >= top - _EQUAL * abs(top))), count)
            angles, values = theta[part], value[part]
            for _ in range(_ROUNDS):
                angles = np.linspace(angles[max(at - 1, 0)], angles[min(at + 1, len(angles) - 1)], _CLOSER)
                values = self._closed(angles[None], figure)[0]
                at = int(np.argmax(sign * values))
            found.append(Peak(float(values[at]), float(angles[at]) % TURN))
        return found[0], found[1]

    def greatest(self, order: int) -> Peak:
        """Value of a derivative that is the greatest in size over the turn, with its sign."""
        return max(self.extremes(order), key=lambda peak: abs(peak.value))

    def _closed(self, theta: Array, figure: Callable[[Array, Array], Array]) -> Array:
        """A figure on rows of angles, the last of each row as it is before that angle."""
        rows = np.array(figure(self.jets(theta.ravel()), theta.ravel())).reshape(theta.shape)
        rows[:, -1] = figure(self.jets(theta[:, -1], before=True), theta[:, -1])
        return rows

    @cached_property
    def stations(self) -> tuple[Array, Array]:
        """Cam angles from 0 to a turn between which q only rises or only falls, and q there.

        Found once for each motion: a car that runs with many plays asks again and again.
        """
        slope = self.q.derivative()
        roots = zeros(slope, jumps=False)
        nodes = np.unique(np.concatenate([self.q.x, roots[np.isfinite(roots)]]))
        return nodes, np.append(self.q(nodes[:-1]), self.q(nodes[0]))

    @cached_property
    def derived(self) -> dict[tuple[object, float], Array]:
        """Results of other rooms for this motion, kept for use again, by function and parameter."""
        return {}

    @cached_property
    def level(self) -> Array:
        """Stretches of at least 0.5 degrees over which the motion is level to rounding: straight runs and dwells.

        Returns:
            Cam angles at which each begins, in [0, 2 pi), and ends, perhaps beyond 2 pi; shape (m, 2), rad.
        """
        if self.known_level is not None:
            return self.known_level
        nodes, value = self.stations
        # Twice round, so that a stretch across the start is met whole.
        angle, height = np.concatenate([nodes[:-1], nodes + TURN]), np.concatenate([value[:-1], value])
        across = np.searchsorted(angle, angle[: len(nodes) - 1] + _LEVEL_ANGLE)
        close = np.flatnonzero(np.abs(height[across] - height[: len(across)]) <= self.unit.level)
        stretches: list[list[float]] = []
        for first in close:
            last = across[first]
            if stretches and angle[last] <= stretches[-1][1]:
                continue
            if np.ptp(height[first : last + 1]) > self.unit.level:
                continue
            # The stretch goes on as long as all of it stays within the range.
            last = first + _level_from(height[first : first + len(nodes)], last - first, self.unit.level) - 1
            if stretches and angle[first] <= stretches[-1][1]:
                stretches[-1][1] = float(angle[last])
            else:
                stretches.append([float(angle[first]), float(angle[last])])
        # A stretch across the start is found once from 0 and once from where it really begins.
        if len(stretches) > 1 and stretches[-1][1] >= stretches[0][0] + TURN:
            stretches = stretches[1:]
        return np.array([[a, min(b, a + TURN)] for a, b in stretches]).reshape(-1, 2)

    @cached_property
    def mirrored(self) -> Self:
        """The motion of a cam that turns the other way: q at minus the cam angle."""
        x, degree = self.q.x, self.q.c.shape[0] - 1
        taylor, derivative = [], self.q.c
        for order in range(degree + 1):
            value = np.zeros(len(x) - 1)
            for row in derivative:
                value = value * np.diff(x) + row
            taylor.append((-1) ** order * value / factorial(order))
            derivative = derivative[:-1] * np.arange(len(derivative) - 1, 0, -1)[:, None]
        curve = PPoly(np.stack(taylor[::-1])[:, ::-1], TURN - x[::-1], extrapolate="periodic")
        level = None if self.known_level is None else mirrored(self.known_level)
        return replace(self, q=curve, kinks=(-self.kinks) % TURN, known_level=level)

    def extrema(self) -> tuple[Array, Array]:
        """Cam angles of the peaks and of the valleys of the motion, rad, in order."""
        slope = self.q.derivative()
        roots = zeros(slope, jumps=True)
        roots = np.unique(roots[(roots >= 0) & (roots < TURN) & np.isfinite(roots)])
        # Both sides are probed: at a kink the slope changes sign without being zero.
        probe = 1e-7
        before, after = slope(roots - probe), slope(roots + probe)
        return roots[(before > 0) & (after < 0)], roots[(before < 0) & (after > 0)]


def side_of(breaks: Array, cam_angle: Array, before: bool) -> tuple[NDArray[np.intp], Array]:
    """Part in which each cam angle lies, and the angle within the turn, on a break exactly where it is near to one.

    Args:
        breaks: beginnings of the parts, and the end of the last, a turn later, rad.
        cam_angle: cam angles, rad, shape (n,).
        before: whether an angle on a break belongs to the part that ends there.
    """
    angle = np.mod(np.asarray(cam_angle, dtype=float), TURN)
    near = np.clip(np.searchsorted(breaks, angle), 1, len(breaks) - 1)
    for candidate in (near - 1, near):
        angle = np.where(np.abs(angle - breaks[candidate]) < _SNAP, breaks[candidate], angle)
    angle = np.where(before & (angle == breaks[0]), breaks[-1], angle)
    angle = np.where((not before) & (angle == breaks[-1]), breaks[0], angle)
    number = np.searchsorted(breaks, angle, side="left" if before else "right") - 1
    return np.clip(number, 0, len(breaks) - 2), angle


def _level_from(height: Array, sure: int, within: float) -> int:
    """Number of values, from the first on, that lie within the level range; `sure` of them are known to."""
    while True:
        sure *= 2
        part = height[:sure]
        outside = np.maximum.accumulate(part) - np.minimum.accumulate(part) > within
        if outside.any() or len(part) == len(height):
            return int(np.argmax(outside)) if outside.any() else len(part)


def mirrored(stretches: Array) -> Array:
    """Stretches of a turn at minus their cam angles, rad, shape (m, 2), each beginning in [0, 2 pi).

    Args:
        stretches: begin and end of each, rad, shape (m, 2).
    """
    begin = (-stretches[:, 1]) % TURN
    return np.stack([begin, begin + stretches[:, 1] - stretches[:, 0]], axis=1)
