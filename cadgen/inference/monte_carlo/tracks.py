"""Tracks of many cars without play, each a small change of the nominal one.

At the cam angle phi a car's heading is the nominal one, which is integrated on a fine grid, plus a small change d that
bends little. Over a cell of several steps of that grid, with m its middle and z_0 the nominal track:

    z(phi) - z(phi_k) = r exp(i d_m) (z_0(phi) - z_0(phi_k) + i d' M),   d = d_m + d' (phi - phi_m)

Here r is the car's pace by the nominal one and M the first moment of dz_0 about the middle. A cell costs a car no more
than a step would.
"""

from dataclasses import dataclass
from math import radians
from typing import Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.steering import Car, wheel_tangent, wheel_travel_ratio
from cadgen.deviations.deviation import DRIVE_WHEEL_OFFSET, WHEEL_RUNOUT, WHEELBASE
from cadgen.deviations.first_order import ROWS, OtherEdge

Complex = NDArray[np.complex128]
_Values = TypeVar("_Values", Array, Complex)

_ALWAYS = 6  # rows of the derivatives that every car has
_MARGIN = 2  # steps of the grid beyond the cam angles of the run
# Of a turn of a wheel that runs out, at most, in a cell: a run errs by 0.01 mm where 0.1 mm of run-out moves it by 1.
_SHARE = 0.1
_CELL = radians(0.8)  # by it the end of a run errs no more than by the grid: 0.02 mm, 0.1 mm where all varies widely


@dataclass(frozen=True, kw_only=True)
class NominalSteering:
    """Steering and travel of the nominal car, by its cam angle.

    Attributes:
        tan_beta: nominal steering on an even grid of one turn from cam angle 0, shape (n,).
        derivatives: derivatives of tan_beta, shape (r, n); see `first_order.steering_derivatives`.
        other: edge of the disc that does not carry the nominal rod.
        car: nominal dimensions.
        length: travel of the drive wheel in one turn of the cam, mm.
        wheel_radius: radius of the drive wheel, mm.
    """

    tan_beta: Array
    derivatives: Array
    other: OtherEdge
    car: Car
    length: float
    wheel_radius: float


@dataclass(frozen=True)
class _Nominal:
    """The nominal track over the cam angles of a run; lengths in travel of the rim for a rad of the cam.

    Attributes:
        first, step: cam angle of the first point and between points, rad.
        width: steps of a cell.
        index: place of each point in the grid of one turn, shape (j,).
        turning: heading gained for a rad of the cam, shape (j,).
        pace: travel of the drive wheel by that of its rim, shape (j,).
        heading: shape (j,), rad.
        position: x + iy, shape (j,).
    """

    first: float
    step: float
    width: int
    index: NDArray[np.intp]
    turning: Array
    pace: Array
    heading: Array
    position: Complex

    @classmethod
    def of(cls, steered: NominalSteering, first: float, last: float, cell: float) -> Self:
        """The nominal track from a first cam angle to a last one, in cells of some width, rad; a step at least."""
        count = len(steered.tan_beta)
        step = TURN / count
        width = max(1, round(cell / step))
        # Cells begin at multiples of their width, whatever the other cars: so a car's run does not depend on them.
        low = (int(np.floor(first / step)) - _MARGIN) // width * width
        cells = -(-(int(np.ceil(last / step)) + _MARGIN + 1 - low) // width)
        index = np.arange(low, low + cells * width + 1) % count
        car = steered.car
        turning, pace = _turning(
            steered.tan_beta[index], car, steered.length / TURN, car.wheelbase, car.drive_wheel_offset
        )
        heading = np.append(0.0, np.cumsum((turning[1:] + turning[:-1]) / 2)) * step
        # Chords of arcs: between two points the track is a circle.
        bend = np.diff(heading)
        chord = (pace[1:] + pace[:-1]) / 2 * np.sinc(bend / TURN) * np.exp(1j * (heading[:-1] + bend / 2)) * step
        position = np.append(0.0, np.cumsum(chord))
        return cls(low * step, step, width, index.astype(np.intp), turning, pace, heading, position)

    def means(self, values: Array) -> Array:
        """Means over each cell of values at the points, by the trapezoidal rule, shape (..., j) to (..., k)."""
        inner = values[..., :-1].reshape(*values.shape[:-1], -1, self.width).mean(axis=-1)
        ends = values[..., :: self.width]
        return np.asarray(inner + (ends[..., 1:] - ends[..., :-1]) / (2 * self.width))

    @property
    def moments(self) -> tuple[Complex, Complex]:
        """Way over each cell, and its first moment about the middle of the cell, shape (k,)."""
        way = np.diff(self.position).reshape(-1, self.width)
        off = (np.arange(self.width) - (self.width - 1) / 2) * self.step
        return way.sum(axis=1), way @ off

    def at(self, cam: Array) -> "_Nominal.At":
        """The nominal track at cam angles, by cubic Hermite interpolation."""
        # LeadIntervals before the start or after the end have no length or no station; they may lie off the grid.
        place = np.clip((cam - self.first) / self.step, 0.0, len(self.heading) - 1.5)
        left = place.astype(np.intp)
        u, right = place - left, left + 1
        h00, h01 = (1 + 2 * u) * (1 - u) ** 2, u**2 * (3 - 2 * u)
        h10, h11 = self.step * u * (1 - u) ** 2, self.step * u**2 * (u - 1)
        k0, k1, q0, q1 = self.heading[left], self.heading[right], self.turning[left], self.turning[right]
        p0, p1 = self.pace[left], self.pace[right]
        position = h00 * self.position[left] + h01 * self.position[right]
        position += h10 * p0 * np.exp(1j * k0) + h11 * p1 * np.exp(1j * k1)
        cell = left // self.width
        begins = cell * self.width
        return _Nominal.At(
            cell=cell,
            beyond=(place - begins) * self.step,
            heading=h00 * k0 + h01 * k1 + h10 * q0 + h11 * q1,
            way=position - self.position[begins],
            turning=(1 - u) * q0 + u * q1,
            pace=(1 - u) * p0 + u * p1,
        )

    @dataclass(frozen=True)
    class At:
        """The nominal track at cam angles, all of one shape.

        Attributes:
            cell: number of the cell.
            beyond: cam angle beyond the beginning of the cell, rad.
            heading: rad.
            way: from the beginning of the cell, x + iy.
            turning, pace: as of the track.
        """

        cell: NDArray[np.intp]
        beyond: Array
        heading: Array
        way: Complex
        turning: Array
        pace: Array


@dataclass(frozen=True)
class Tracks:
    """Each car's track without play, by cam angle; lengths in travel of its rim for a rad of the cam.

    Attributes:
        nominal: the nominal track.
        turning: change of the heading gained for a rad of the cam, in each cell, shape (m, k).
        change: change of the heading at the ends of the cells, shape (m, k + 1), rad.
        position: at the ends of the cells, x + iy, shape (m, k + 1).
        pace: each car's pace by the nominal one in each cell, shape (m, k); (1, 1) if it is 1.
    """

    nominal: _Nominal
    turning: Array
    change: Array
    position: Complex
    pace: Array

    @classmethod
    def of(cls, steered: NominalSteering, deviations: Array, rate: Array, first: float, last: float) -> Self:
        """Tracks of cars.

        Args:
            steered: nominal car.
            deviations: deviations of m cars, columns as `COLUMNS` of the catalogue, shape (m, c).
            rate: travel of each car's rim for a rad of the cam, mm, shape (m,).
            first, last: between what cam angles, rad.
        """
        # A wheel that runs out turns many times with the cam: no cell is to be a large part of its turn.
        runs_out = bool(deviations[:, WHEEL_RUNOUT.columns].any())
        cell = min(_CELL, _SHARE * TURN / _wheel_turns(steered)) if runs_out else _CELL
        nominal = _Nominal.of(steered, first, last, cell)
        car, width = steered.car, nominal.width * nominal.step
        mean = nominal.means(steered.tan_beta[nominal.index])
        used = [row for row, column in enumerate(ROWS) if row < _ALWAYS or deviations[:, column].any()]
        turned = deviations[:, [ROWS[row] for row in used]]
        # Not `@`: a library's threads would compete with other processes for so small a product.
        tangent = np.einsum("ci,ij->cj", turned, nominal.means(steered.derivatives[used][:, nominal.index]))
        tangent += mean
        parts = deviations[:, OtherEdge.COLUMNS]
        if parts.any():
            _raise(tangent, *steered.other.raised(parts, nominal.index), nominal.width)
        plain, usual = _turning(mean, car, steered.length / TURN, car.wheelbase, car.drive_wheel_offset)
        turning, pace = _turning(
            tangent,
            car,
            rate[:, None],
            car.wheelbase + deviations[:, WHEELBASE.columns],
            car.drive_wheel_offset + deviations[:, DRIVE_WHEEL_OFFSET.columns],
        )
        relative = pace / usual if car.slip != 0 else np.ones((1, 1))
        if runs_out:
            rolling = _rolling(steered, deviations[:, WHEEL_RUNOUT.columns], nominal, len(mean))
            relative = relative * rolling
            turning *= rolling
        turning -= plain
        change = _summed(turning) * width
        way, moment = nominal.moments
        gained = np.exp(1j * (change[:, :-1] + turning * (width / 2)))
        gained *= way + 1j * turning * moment
        gained *= relative
        return cls(nominal, turning, change, _summed(gained), relative)

    def between(self, cam: Array, travel: Array, waits: NDArray[np.bool_]) -> tuple[Array, Complex]:
        """Heading and displacement gained from cam angles over a motor travel, in the car's own frame at the start.

        Where `waits` is set the cam stands, and the car runs on a circle.

        Args:
            cam: cam angles, shape (m, q), rad.
            travel: motor travel from each, shape (m, q), rad.
            waits: whether the cam stands, shape (m, q).
        """
        heading, position, turning, going = self._at(cam)
        later, end, _, _ = self._at(cam + np.where(waits, 0.0, travel))
        arc = turning * travel
        circle = going * travel * np.sinc(arc / TURN) * np.exp(0.5j * arc)
        chord = (end - position) * np.exp(-1j * heading)
        return np.where(waits, arc, later - heading), np.where(waits, circle, chord)

    def _at(self, cam: Array) -> tuple[Array, Complex, Array, Array]:
        """Heading, position, turning and pace at cam angles, shape (m, q)."""
        at, rows = self.nominal.at(cam), np.arange(len(cam))[:, None]
        turning, before = self.turning[rows, at.cell], self.change[rows, at.cell]
        pace = self.pace if self.pace.size == 1 else self.pace[rows, at.cell]
        there = turning, pace
        if self.pace.size > 1:
            # The mean from the beginning of the cell, and what is at the cam angle itself, where a car may go on for
            # long: they are not those of the whole cell.
            width = self.nominal.width * self.nominal.step
            slopes = self._slopes(self.turning, at), self._slopes(self.pace, at)
            there = turning + (at.beyond - width / 2) * slopes[0], pace + (at.beyond - width / 2) * slopes[1]
            turning, pace = turning + (at.beyond - width) / 2 * slopes[0], pace + (at.beyond - width) / 2 * slopes[1]
        half = turning * at.beyond / 2
        position = self.position[rows, at.cell] + pace * np.exp(1j * (before + half)) * at.way
        return at.heading + before + 2 * half, position, at.turning + there[0], at.pace * there[1]

    def _slopes(self, values: Array, at: _Nominal.At) -> Array:
        """Growth by the cam angle of means over cells, shape (m, k), in the cells of places, shape (m, q)."""
        left, right = np.maximum(at.cell - 1, 0), np.minimum(at.cell + 1, values.shape[1] - 1)
        rows, apart = np.arange(len(values))[:, None], (right - left) * self.nominal.width * self.nominal.step
        return np.asarray((values[rows, right] - values[rows, left]) / apart)


def _turning(
    tan_beta: Array, car: Car, rate: Array | float, wheelbase: Array | float, offset: Array | float
) -> tuple[Array, Array]:
    """Heading gained for a rad of the cam, and travel of the drive wheel by that of its rim."""
    wheel = wheel_tangent(tan_beta, car)
    turning = -rate * wheel / (wheelbase + offset * wheel)
    if car.slip == 0:
        return turning, np.ones_like(wheel)
    pace = wheel_travel_ratio(wheel, car)
    return turning * pace, pace


def _raise(tangent: Array, near: NDArray[np.intp], more: Array, width: int) -> None:
    """Add to the means over cells what is more at some points; a point between two cells counts in each by half."""
    between = near % width == 0
    at = np.concatenate([near // width, near[between] // width - 1])
    which = np.concatenate([np.arange(len(near)), np.flatnonzero(between)])
    share = np.where(between, 0.5, 1.0)[which] / width
    kept = (at >= 0) & (at < tangent.shape[1])
    order = np.argsort(at[kept], kind="stable")
    at, which, share = at[kept][order], which[kept][order], share[kept][order]
    if len(at):
        cells, begins = np.unique(at, return_index=True)
        tangent[:, cells] += np.add.reduceat(more[:, which] * share, begins, axis=1)


def _rolling(steered: NominalSteering, runout: Array, nominal: _Nominal, cells: int) -> Array:
    """Travel of an eccentric drive wheel for that of a round one, mean over each cell, shape (m, k).

    It goes by the cam's angle. While the cam leads, that is ahead of the motor's, which makes more of the wheel's
    effect than there is: some 0.4 mm for 0.05 mm on the paper's car, where there is 0.1.
    """
    width = nominal.width * nominal.step
    turns = _wheel_turns(steered)
    turned = turns * (nominal.first + width * (np.arange(cells) + 0.5))
    parts = (part[:, None] / steered.wheel_radius for part in runout.T)
    low, quarter = (part * np.sinc(turns * width / TURN) for part in parts)
    return np.asarray(1 + low * np.cos(turned) + quarter * np.sin(turned))


def _wheel_turns(steered: NominalSteering) -> float:
    """Turns of the drive wheel in one turn of the cam."""
    return steered.length / (TURN * steered.wheel_radius)


def _summed(values: _Values) -> _Values:
    """Sums along the last axis up to each place, from 0 on."""
    out = np.zeros((len(values), values.shape[1] + 1), dtype=values.dtype)
    np.cumsum(values, axis=1, out=out[:, 1:])
    return out
