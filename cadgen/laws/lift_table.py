"""A motion of points or of a lift table: order, closure and noise of its rows, and the quintic spline through them.

Fourth differences of equally spaced rows have sqrt(70) times the noise of a row, and hardly anything of a smooth lift;
of white noise, neighbours among them are correlated by -56/70. The smoothing spline is quintic, and
its sum of squared residuals is the count of rows times the noise squared (Dierckx, Curve and Surface Fitting with
Splines, ch. 5). Of tables with 2 um of noise at 1 degree, 95 of 100 so have their greatest accelerations within 2 %,
and all the lift within 1.3 um rms.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import degrees, radians, sqrt
from typing import ClassVar

import numpy as np
from scipy.interpolate import PPoly, make_interp_spline, splev, splrep

from cadgen.arrays import TURN, Array
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.laws.unit import MM, Unit

LEAST_ROWS = 6  # of a quintic spline
_DEGREE = 5
_DIFFERENCES = 4
_WHITE = -0.5  # correlation of neighbouring fourth differences; of white noise it is -0.8, of a smooth lift positive
_OUTLIER = 6.0  # times the median of the fourth differences, at which one belongs to a seam and not to noise
_MEDIAN_OF_SQUARES = 0.4549  # of a standard normal variable
_GAP = 1.5  # steps of the table; a wider gap is a part of the turn without rows
_RADIANS_FROM = 0.9  # of a turn in radians, from which the angles of a table that does not close look like them
_OPEN_NOISE = 5.0  # times the noise by which the ends of a table may differ
_OPEN = {True: 5e-4, False: 1e-5}  # mm, or rad, by which they may differ in any case
_FIRM = 20.0  # weight of the dwell beside a table, against its rows
_STARTS = 16  # rows at which smoothing splines begin, of which the mean is taken
_RAMPS = np.radians(np.linspace(2.0, 90.0, 177))  # angles tried for a ramp
_BRIDGE = radians(20.0)  # what a table of a whole turn gives up to a ramp
_SAME = 1e-9  # rad; nearer knots are one
_DWELL = radians(1.0)  # left between two ramps


@dataclass(frozen=True)
class Smoothing:
    """Change of a table by its smoothing.

    Attributes:
        rms: root mean square of the changes, in the unit of the motion.
        most: greatest change.
        before: least and greatest second derivative of the spline through the rows as they are, by rad².
    """

    rms: float
    most: float
    before: tuple[float, float]


@dataclass(frozen=True)
class TableMotion(Motion):
    """Motion of a periodic quintic spline through points, or through the smoothed rows of a table.

    Attributes:
        noise: standard deviation of the rows by their fourth differences; 0 where these show none.
        smoothing: change by smoothing; None if the rows are taken as they are.
        covered: cam angles from and to which the rows reach, rad; a turn, or a part of it.
        ramps: cam angles from which and to which each ramp leads, shape (n, 2), rad; empty without one.
    """

    noise: float = 0.0
    smoothing: Smoothing | None = None
    covered: tuple[float, float] = (0.0, TURN)
    ramps: tuple[tuple[float, float], ...] = ()

    key: ClassVar[str] = "motion.table"

    @property
    def rough(self) -> bool:
        """Whether the rows have noise that was not smoothed."""
        return self.noise > 0 and self.smoothing is None

    @property
    def mirrored(self) -> "TableMotion":
        """The motion of a cam that turns the other way: q at minus the cam angle."""
        low, high = self.covered
        return replace(
            super().mirrored, covered=(-high, -low), ramps=tuple((-stop, -start) for start, stop in self.ramps[::-1])
        )

    def within(self, order: int) -> tuple[float, float]:
        """Least and greatest value of a derivative where the table has rows, apart from ramps and dwell.

        Args:
            order: order of the derivative.
        """
        low, high = self.covered
        theta = np.linspace(low, high, 20_001)[1:-1]
        value = self.jets(theta)[:, order]
        return float(value.min()), float(value.max())


def points_motion(angle: Array, height: Array, unit: Unit) -> TableMotion:
    """Periodic quintic spline through points.

    Args:
        angle: cam angles that grow, less than a turn in all, rad, shape (n,).
        height: motion at them, in its unit, shape (n,).
        unit: unit of the motion.
    """
    return TableMotion(_periodic(angle, height), np.array([]), unit=unit)


def table_motion(
    angle: Array, height: Array, unit: Unit, *, lobes: int = 1, smooth: bool, ramps: bool, key: str
) -> TableMotion:
    """Motion of a lift table.

    Args:
        angle: cam angles that grow, a turn at most, or an equal part of it for every lobe, rad, shape (n,).
        height: motion at them, in its unit, shape (n,).
        unit: unit of the motion.
        lobes: times that the table is repeated in a turn.
        smooth: whether the rows are smoothed by their noise.
        ramps: whether ends that do not meet are led together by polynomials.
        key: key that asks for ramps, for messages.

    Raises:
        DesignError: the table does not close, and ramps are not asked for.
    """
    noise, period = noise_of(angle, height), TURN / lobes
    missing = period - float(angle[-1] - angle[0])
    step = float(np.median(np.diff(angle)))
    whole = missing < _GAP * float(np.diff(angle).max())
    closes = _closes(angle, height, missing, noise, unit)
    if not whole and _as_radians(angle, height, step, noise, unit, period):
        raise _in_radians(degrees(angle[-1] - angle[0]))
    if not closes and not ramps:
        raise _open(angle, height, unit, noise, key)
    if closes and whole:
        if missing < step / 2:  # the last row is the first one again
            angle, height = angle[:-1], height[:-1].copy()
        exact = _periodic(angle, height, period)
        smoothed = _smoothed(angle, height, np.ones(len(angle)), noise, period) if smooth and noise else None
        return _made(exact, smoothed, angle, height, noise, unit, (0.0, period))
    if closes:
        return _lobe(angle, height, step, noise, unit, smooth, period)
    if whole:
        kept = angle <= angle[0] + period - min(_BRIDGE, period / 8)
        angle, height = angle[kept], height[kept]
    return _ramped(angle, height, noise, unit, smooth, period, bridge=whole)


def noise_of(angle: Array, height: Array) -> float:
    """Standard deviation of the noise of rows by fourth differences, in their unit; 0 where they show none.

    Args:
        angle: angles that grow, rad, shape (n,).
        height: values, in any unit, shape (n,).
    """
    if len(angle) < 4 * _DIFFERENCES:
        return 0.0
    window = np.lib.stride_tricks.sliding_window_view
    x, y = window(angle, _DIFFERENCES + 1), window(height, _DIFFERENCES + 1)
    # Weights of the fourth divided difference, scaled to those of equal steps: 1, -4, 6, -4, 1.
    apart = x[:, :, None] - x[:, None, :]
    weight = 1 / np.where(np.eye(_DIFFERENCES + 1, dtype=bool), 1.0, apart).prod(axis=2)
    weight *= sqrt(70.0) / np.linalg.norm(weight, axis=1, keepdims=True)
    differences = (weight * y).sum(axis=1)
    spread = sqrt(float(np.median(differences**2)) / _MEDIAN_OF_SQUARES)
    kept = np.abs(differences) <= _OUTLIER * spread
    if spread == 0 or kept.sum() < 8:
        return 0.0
    pairs = kept[1:] & kept[:-1]
    product = float((differences[1:] * differences[:-1])[pairs].sum())
    power = float((differences[1:] ** 2 + differences[:-1] ** 2)[pairs].sum()) / 2
    if product / power > _WHITE:
        return 0.0
    return float(np.sqrt(np.mean(differences[kept] ** 2) / 70.0))


def _closes(angle: Array, height: Array, missing: float, noise: float, unit: Unit) -> bool:
    """Whether the ends of a table meet: across the start of a whole turn, or over the dwell beside a part of one."""
    allowed = max(_OPEN[unit == MM], _OPEN_NOISE * noise)
    steps = np.diff(angle)
    if missing < float(np.median(steps)) / 2 or missing >= _GAP * float(steps.max()):
        return bool(abs(height[-1] - height[0]) <= allowed)
    # The step across the start is as smooth as the others: its third differences are no larger than theirs.
    closed = np.concatenate([height[-3:], height[:3]])
    across = np.abs(np.diff(closed, 3)).max()
    return bool(across <= max(3.0 * np.abs(np.diff(height, 3)).max(), 8.0 * allowed))


def _as_radians(angle: Array, height: Array, step: float, noise: float, unit: Unit, period: float) -> bool:
    """Whether the angles, taken for radians, are those of a whole period on which the table closes."""
    share = degrees(1.0)
    missing = period - share * float(angle[-1] - angle[0])
    return abs(missing) < _GAP * share * step and _closes(share * angle, height, missing, noise, unit)


def _in_radians(reach: float) -> DesignError:
    """Refusal of angles in radians.

    Args:
        reach: what they reach over, as degrees.
    """
    return DesignError(
        "the table reaches over {reach:.4g} degrees alone, as angles in radians do, and they are degrees: multiply "
        "each by {share:.10g}",
        reach=reach,
        share=degrees(1.0),
    )


def _open(angle: Array, height: Array, unit: Unit, noise: float, key: str) -> DesignError:
    reach = degrees(angle[-1] - angle[0])
    if _RADIANS_FROM * TURN < reach < 1.01 * TURN:
        return _in_radians(reach)
    scale, name = (1e3, "µm") if unit == MM else (degrees(1.0), "°")
    return DesignError(
        "the table does not close: it begins {first:.4g} {unit} above the base circle, at {begin:.6g} degrees of cam "
        'angle, and ends {last:.4g} {unit} above it, at {end:.6g}: set {key} to "ramps" for polynomials that lead '
        "the ends together, or correct the table",
        first=float(height[0]) * scale,
        last=float(height[-1]) * scale,
        begin=degrees(angle[0]),
        end=degrees(angle[-1]),
        unit=name,
        key=key,
    )


def _periodic(angle: Array, height: Array, period: float = TURN) -> PPoly:
    """Periodic quintic spline through points, as pieces from 0 to a turn."""
    closed = np.append(angle, angle[0] + period)
    spline = make_interp_spline(closed, np.append(height, height[0]), _DEGREE, bc_type="periodic")
    return _pieces(angle, lambda theta, order: spline(theta, nu=order), angle[0], period)


def _smoothed(angle: Array, height: Array, weight: Array, noise: float, period: float) -> PPoly:
    """Periodic quintic smoothing spline whose weighted residuals have the size of the noise.

    Where its knots lie depends on where the period begins, and with them how well a narrow peak is met. So it is the
    mean of splines that begin at different rows.
    """
    fits = []
    for first in np.unique(np.linspace(0, len(angle), _STARTS, endpoint=False).astype(int)):
        closed = np.concatenate([angle[first:], angle[: first + 1] + period])
        values, weights = (np.append(np.roll(each, -first), each[first]) for each in (height, weight))
        fits.append(splrep(closed, values, w=weights / noise, k=_DEGREE, s=float(len(angle)), per=True, quiet=1))

    def mean(theta: Array, order: int) -> Array:
        starts = [fit[0][_DEGREE] for fit in fits]
        inside = [start + np.mod(theta - start, period) for start in starts]
        each = [splev(place, fit, der=order) for place, fit in zip(inside, fits, strict=True)]
        return np.asarray(np.mean(each, axis=0))

    return _pieces(np.concatenate([fit[0] for fit in fits]), mean, angle[0], period)


def _pieces(knots: Array, value: Callable[[Array, int], Array], start: float, period: float) -> PPoly:
    """Quintic pieces from 0 to a turn of a periodic quintic spline with these knots, which they are exactly.

    Args:
        knots: knots, rad.
        value: function of angles from `start` to a period later, and of an order.
        start: beginning of the spline's period, rad.
        period: period of the spline, a turn or an equal part of it, rad.
    """
    theta = np.unique(np.append(np.mod(knots, period), 0.0))
    theta = theta[np.append(True, np.diff(theta) > _SAME)]
    theta = theta[period - theta > _SAME]
    inside = start + np.mod(theta - start, period)
    jets = np.stack([np.asarray(value(inside, order)) for order in range(3)], axis=1)
    lobes = round(TURN / period)
    every = np.concatenate([theta + lobe * period for lobe in range(lobes)])
    return quintic_hermite(np.append(every, TURN), np.vstack([np.tile(jets, (lobes, 1)), jets[:1]]), periodic=True)


def _made(
    exact: PPoly,
    smoothed: PPoly | None,
    angle: Array,
    height: Array,
    noise: float,
    unit: Unit,
    covered: tuple[float, float],
) -> TableMotion:
    """Motion of a table with its smoothed pieces, if it is smoothed, and what they change."""
    made = TableMotion(exact, np.array([]), unit=unit, noise=noise, covered=covered)
    if smoothed is None:
        return made
    change = smoothed(np.mod(angle, TURN)) - height
    smoothing = Smoothing(float(np.sqrt(np.mean(change**2))), float(np.abs(change).max()), made.within(2))
    return replace(made, q=smoothed, smoothing=smoothing)


def _lobe(
    angle: Array, height: Array, step: float, noise: float, unit: Unit, smooth: bool, period: float
) -> TableMotion:
    """Motion of a table that covers a part of the turn and whose ends meet, with a dwell over the rest."""
    level = float(height[0] + height[-1]) / 2
    allowed = max(_OPEN[unit == MM], _OPEN_NOISE * noise)
    level = 0.0 if abs(level) <= allowed else level
    height = height.copy()
    height[[0, -1]] = level
    rest = [(1, 0.0), (2, 0.0)]
    spline = make_interp_spline(angle, height, _DEGREE, bc_type=(rest, rest))  # type: ignore[arg-type]
    jets = np.stack([spline(angle, nu=order) for order in range(3)], axis=1)
    jets[[0, -1]] = [level, 0.0, 0.0]
    exact = _turned(angle, jets, [], period)
    smoothed = None
    if smooth and noise:
        missing = period - float(angle[-1] - angle[0])
        count = max(int(missing / step) - 1, 2)
        beside = angle[-1] + missing * np.arange(1, count + 1) / (count + 1)
        weight = np.append(np.ones(len(angle)), np.full(count, _FIRM))
        rows = np.append(angle, beside), np.append(height, np.full(count, level))
        smoothed = _smoothed(*rows, weight, noise, period)
    return _made(exact, smoothed, angle, height, noise, unit, (float(angle[0]), float(angle[-1])))


def _ramped(
    angle: Array, height: Array, noise: float, unit: Unit, smooth: bool, period: float, *, bridge: bool
) -> TableMotion:
    """Motion of a table whose ends do not meet, with a polynomial over the gap, or one to the base circle at each."""
    exact = make_interp_spline(angle, height, _DEGREE)
    knots = angle
    jets = np.stack([exact(knots, nu=order) for order in range(3)], axis=1)
    smoothing = None
    if smooth and noise:
        fit = splrep(angle, height, w=np.full(len(angle), 1 / noise), k=_DEGREE, s=float(len(angle)), quiet=1)
        knots = np.unique(np.clip(fit[0], angle[0], angle[-1]))
        jets = np.stack([splev(knots, fit, der=order) for order in range(3)], axis=1)
        change = splev(angle, fit) - height
        dense = exact(np.linspace(angle[0], angle[-1], 20_001), nu=2)
        smoothing = Smoothing(
            float(np.sqrt(np.mean(change**2))), float(np.abs(change).max()), (float(dense.min()), float(dense.max()))
        )
    begin, end, gap = float(angle[0]), float(angle[-1]), period - float(angle[-1] - angle[0])
    if bridge:
        ramps, more = [(end, begin + period)], []
    else:
        most = (gap - _DWELL) / 2
        off = end + _ramp(jets[-1], most)
        on = begin + period - _ramp(jets[0] * [1.0, -1.0, 1.0], most)
        ramps, more = [(end, off), (on, begin + period)], [off, on]
    return TableMotion(
        _turned(knots, jets, more, period),
        np.array([]),
        unit=unit,
        noise=noise,
        smoothing=smoothing,
        covered=(begin, end),
        ramps=tuple(ramps),
    )


def _ramp(jet: Array, most: float) -> float:
    """Angle of the ramp to the base circle with the least acceleration that does not lead below it, rad.

    Args:
        jet: height, velocity and acceleration where it begins.
        most: greatest angle that there is room for, rad.
    """
    u = np.linspace(0.0, 1.0, 101)
    found = []
    for angle in [*_RAMPS[most >= _RAMPS], most]:
        curve = quintic_hermite(np.array([0.0, angle]), np.array([jet, np.zeros(3)]))
        below = max(-float(curve(u * angle).min()), 0.0)
        found.append((max(below, 1e-6), float(np.abs(curve(u * angle, nu=2)).max()), float(angle)))
    return min(found)[2]


def _turned(knots: Array, jets: Array, rests: Sequence[float], period: float) -> PPoly:
    """Periodic pieces from 0 to a turn through knots and, beside them, rests at the base circle.

    Args:
        knots: angles over less than a turn, rad, shape (n,).
        jets: value and two derivatives there, shape (n, 3).
        rests: angles behind the knots at which the motion rests at 0, rad.
        period: turn, or equal part of it, that they belong to, rad.
    """
    theta = np.concatenate([knots, rests, [knots[0] + period]])
    every = np.concatenate([jets, np.zeros((len(rests), 3)), jets[:1]])
    curve = quintic_hermite(theta, every)
    start = float(theta[0])
    return _pieces(
        theta[:-1], lambda angles, order: curve(np.clip(angles, start, start + period), nu=order), start, period
    )
