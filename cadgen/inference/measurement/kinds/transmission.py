"""Transmission: angles at both ends of the train, one turn of the cam forward, then back.

The model goes from the motor's angle through the gears and the play to the camshaft.
"""

from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from cadgen.arrays import TURN, Array
from cadgen.deviations import deviation
from cadgen.deviations.catalogue import TRANSMISSION
from cadgen.deviations.effect import READING, Active, Effect, key_of, through
from cadgen.deviations.transmission import (
    DELAY,
    ENCODER_LAG,
    MESH,
    PLAY,
    RATIO,
    SLIDING_FRICTION,
    Play,
    Turned,
    Turns,
    train_orders,
)
from cadgen.errors import DesignError, FileError
from cadgen.inference.measurement.model import (
    Cache,
    Discrepancy,
    Model,
    elapsed,
    fourier,
    highest_order,
    per_run,
    unknown,
)
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Column, Datum, Kind, Record, Span
from cadgen.inference.measurement.shapes import shapes
from cadgen.messages import Message

FORM_ORDERS = 30
SHAPE_ORDERS = 60
# What repeats with the motor: its own turn, its poles and the teeth of its pinion, as far as the readings resolve it.
MOTOR_HARMONICS = 12
COGGING = np.radians(0.005)
# Where in the play a run begins is set by chance: its first degrees of cam angle take it up and are not used.
TAKE_UP_DEG = 5.0
_KEPT = 16  # angles of the camshaft: forms without a name act on the reading alone


class TransmissionModel(Model):
    """Cam angle by motor angle, forward and back, the inclinometer's zero free in each run."""

    unit = "deg"

    def __init__(self, record: Record, nominal: Nominal) -> None:
        """Take a record.

        Raises:
            DesignError: the design has no gear train.
        """
        ratios = nominal.ratios
        if not ratios:
            raise DesignError(
                "{file}: the design has no gear train; add its stages to judge this file", file=record.source
            )
        turned = np.radians(record["motor_angle_deg"]) / float(np.prod(ratios))
        first = np.array([turned[record.run == k][0] for k in range(record.runs)])[record.run]
        self._all, self._forces, self._known = turned, nominal.forces, Cache[bytes, Array](_KEPT)
        self._sampled, self._run_all = sampled(turned, record.run), record.run
        # A run that comes back passes its start again: what matters is whether it has been away.
        away = np.zeros(len(turned), dtype=bool)
        for number in range(record.runs):
            mine = record.run == number
            travel = np.abs(turned[mine] - first[mine])
            away[mine] = np.maximum.accumulate(travel) >= np.radians(TAKE_UP_DEG)
        self._used = away
        self._reading = np.radians(record["cam_angle_deg"])[away]
        run, turned = record.run[away], turned[away]
        back = np.concatenate([[False], (np.diff(turned) < 0) & (run[1:] == run[:-1])])
        key = np.round(np.degrees(turned), 4) + 1e4 * back
        slope = nominal.lift.q
        self._slope, self._steepest = slope, float(np.abs(slope(turned % TURN, nu=1)).max())
        self._ways = Cache[float, tuple[_Between, Turned]](_KEPT)
        at = self._way(0.0)[1]
        self.rows = Turns(
            run=run,
            place=turned,
            elapsed=elapsed(run),
            cell=np.unique(key, return_inverse=True)[1].astype(np.intp),
            turned=at.turned,
            torque=at.torque,
        )
        self.resolved = highest = record.resolved or highest_order(turned[~back], run[~back])
        # Rows that were read when somebody stopped have no time between them, and at one speed a lag is a play.
        lags = self._sampled and speeds_differ(self._all, record.run)
        idle = () if lags else (ENCODER_LAG,)
        rod = _rod(record)
        if len(rod) > 1:
            raise FileError(
                'of the runs in {file} some were taken with the "rod lifted" and some with the "rod on the disc"; give '
                "files of one of the two",
                file=record.source,
            )
        if LIFTED in rod:
            idle = (*idle, SLIDING_FRICTION)
        every = (*TRANSMISSION.effects, *train_orders(ratios, nominal.teeth, highest))
        self.catalogue = tuple(e for e in every if not any(no is e or no in e.parts for no in idle))
        motor = np.arange(1.0, MOTOR_HARMONICS + 1.0) * float(np.prod(ratios))
        motor = np.asarray(motor[(motor > FORM_ORDERS) & (motor <= highest)], dtype=float)
        self._shape_orders = np.union1d(np.arange(1, min(SHAPE_ORDERS, highest) + 1), motor)
        self.offsets = per_run(run)
        self.spread = unknown(self.offsets)
        waves = turned[:, None] * motor
        columns, sigma = np.hstack([np.cos(waves), np.sin(waves)]), np.full(2 * len(motor), COGGING)
        self.discrepancy = Discrepancy("what repeats with the motor's turns", columns, sigma)
        self.form, self.order = fourier(turned, min(FORM_ORDERS, highest))
        self.floor = nominal.train_error
        self.slip = np.empty(0)

    @cached_property
    def shapes(self) -> tuple[Effect, ...]:
        """Harmonics, bumps and steps of the reading."""
        return shapes(self.rows, self.unit, self._shape_orders)

    def residual(self, active: Active) -> Array:
        """Measured less expected cam angle, rad."""
        before = [(effect, values) for effect, values in active if effect.stage is not READING]
        angle = self._known.of(key_of(before), lambda: self._camshaft(before)[self._used])
        return np.asarray(self._reading - through(READING, angle, active, self.rows))

    def _way(self, late: float) -> tuple["_Between", Turned]:
        """Way of the motor so many rows before each reading, and the state of the train along it."""

        def made() -> tuple[_Between, Turned]:
            way = _Between(self._all, self._run_all, np.arange(len(self._all)))
            if self._sampled:
                way = _extremes(self._all, self._run_all, late)
            return way, Turned(turned=way.turned, torque=self._slope(way.turned % TURN, nu=1) / self._steepest)

        return self._ways.of(late, made)

    def _camshaft(self, active: Active) -> Array:
        """Angle of the camshaft behind gears and play, rad."""
        way, at = self._way(through(DELAY, 0.0, active, self.rows))
        asked = through(RATIO, way.turned, active, at)
        asked = through(MESH, asked, active, at)
        play = through(PLAY, Play(), active, at)
        if play.width > 0:
            drawn = None if play.friction is None else self._forces.drawn(play.friction)
            asked = follow(asked, way.run, play.width, drawn)
        return np.asarray(asked[way.rows])


@dataclass(frozen=True)
class _Between:
    """Way of the motor with its turning points between the rows: angle and run of each, and which of them are rows."""

    turned: Array
    run: NDArray[np.intp]
    rows: NDArray[np.intp]


# Steps on either side of a turning point that change by less than this share of a run's largest one: a motion that a
# clock has sampled. Of readings taken where somebody stopped the steps change from +1 to -1, by twice that.
SMOOTH = 1.0


def sampled(turned: Array, run: NDArray[np.intp]) -> bool:
    """Whether rows are samples of a motion by a clock, and not readings at rest.

    Args:
        turned: angle of the motor, shape (n,), any unit.
        run: of each.
    """
    changes: list[float] = []
    for number in np.unique(run):
        steps = np.diff(turned[run == number])
        largest = float(np.abs(steps).max(initial=0.0))
        at = np.flatnonzero(steps[1:] * steps[:-1] < 0)
        changes += (np.abs(steps[at + 1] - steps[at]) / max(largest, 1e-300)).tolist()
        # A drive that stands before it comes back slows down on the way.
        still = np.flatnonzero((steps[1:] == 0) & (steps[:-1] != 0))
        changes += (np.abs(steps[still]) / max(largest, 1e-300)).tolist()
    return bool(changes) and float(np.median(changes)) < SMOOTH


# Scatter of the speeds of a run over their mean, from which on a lag is told from play; that of a sine is 0.48.
SPEEDS = 0.3


def speeds_differ(turned: Array, run: NDArray[np.intp]) -> bool:
    """Whether the motor turns at several speeds, standing still left out; arguments as of `sampled`."""
    steps = np.abs(np.diff(turned))[run[1:] == run[:-1]]
    moving = steps[steps > 0.05 * steps.max(initial=0.0)]
    return len(moving) > 0 and float(moving.std() / moving.mean()) > SPEEDS


def _extremes(turned: Array, run: NDArray[np.intp], late: float) -> _Between:
    """Turning points between rows by a cubic spline over each run: the motor went further than any row shows.

    Args:
        turned, run: of each row, shape (n,).
        late: rows before each row, at which the way is wanted.
    """
    angles, runs, rows, count = [], [], [], 0
    for number in np.unique(run):
        mine = turned[run == number]
        spline = CubicSpline(np.arange(len(mine)), mine)
        roots = spline.derivative().roots(extrapolate=False)
        steps = np.diff(mine)
        # Beside a stretch at rest a spline swings, and the rows themselves are the turning points.
        turns = np.flatnonzero(steps[1:] * steps[:-1] < 0) + 1.0
        roots = roots[np.isfinite(roots) & (np.abs(roots[:, None] - turns).min(axis=1, initial=np.inf) < 1)]
        rows_at = np.clip(np.arange(len(mine)) - late, 0, len(mine) - 1)
        place = np.concatenate([rows_at, roots])
        order = np.argsort(place, kind="stable")
        angles.append((np.concatenate([spline(rows_at) if late else mine, spline(roots)]))[order])
        runs.append(np.full(len(place), number))
        rows.append(count + np.flatnonzero(order < len(mine)))
        count += len(place)
    return _Between(np.concatenate(angles), np.concatenate(runs), np.concatenate(rows))


def follow(asked: Array, run: NDArray[np.intp], width: float, drawn: tuple[Array, Array] | None = None) -> Array:
    """The play operator: the camshaft stays where it is until a flank of the gap takes it along, or the rod draws it.

    y_i = clip(y_(i-1), u_i - width/2, u_i + width/2), from the middle of the gap at the start of each run; then, within
    a stretch where the rod draws, to its end or to the flank.

    Args:
        asked: u, angle that the gears ask for, shape (n,), rad, in the order turned.
        run: of each.
        width: of the play, rad.
        drawn: where the rod draws the cam ahead and back, from `Forces.drawn`, at the cam's angle when it is pushed
            ahead; nowhere if left out.
    """
    out = np.empty(len(asked))
    known: dict[bytes, Array] = {}
    for number in np.unique(run):
        mine = run == number
        way = asked[mine]
        key = way.tobytes()  # runs are mostly turned alike
        if key not in known:
            known[key] = _pushed(way, width / 2) if drawn is None else _drawn(way, width / 2, *drawn)
        out[mine] = known[key]
    return out


def _pushed(asked: Array, half: float) -> Array:
    """The play operator on one run, between reversals at once: there the angle is where it was, or at one flank."""
    out, y = np.empty(len(asked)), asked[0]
    rises = np.diff(asked, prepend=asked[0]) >= 0
    ends = [0, *(np.flatnonzero(rises[1:] != rises[:-1]) + 1).tolist(), len(asked)]
    for begin, end in pairwise(ends):
        way = asked[begin:end]
        out[begin:end] = np.maximum(y, way - half) if rises[begin] else np.minimum(y, way + half)
        y = out[end - 1]
    return out


def _drawn(asked: Array, half: float, ahead: Array, back: Array) -> Array:
    """The play operator on one run with a rod that draws."""
    out, y = [float(asked[0])], float(asked[0])
    forward, backward = (([begin for begin, _ in some], some) for some in (ahead.tolist(), back.tolist()))
    for low, high in zip((asked[1:] - half).tolist(), (asked[1:] + half).tolist(), strict=True):
        y = low if y < low else high if y > high else y
        at = (y + half) % TURN
        if (inside := _inside(*forward, at)) is not None:
            y = min(y + inside[1] - at, high)
        elif (inside := _inside(*backward, at)) is not None:
            y = max(y + inside[0] - at, low)
        out.append(y)
    return np.array(out)


def _inside(begins: list[float], stretches: list[list[float]], at: float) -> tuple[float, float] | None:
    """Begin and end of the stretch that an angle of [0, 2 pi) lies in, on the angle's own turn; None if in none."""
    if not stretches:
        return None
    number = bisect_right(begins, at) - 1
    begin, end = stretches[number]
    if number < 0:
        begin, end = begin - TURN, end - TURN
    return (begin, end) if at < end else None


MOST_TURN_DEG = 400.0  # of a camshaft that is to turn once and come back


def _check(record: Record) -> None:
    turned = record["cam_angle_deg"]
    for run, mine in enumerate(record.parts):
        turn = float(np.ptp(turned[mine]))
        if turn > MOST_TURN_DEG:
            raise FileError(
                "{file}: the cam of run {run} turns by {turn:.0f} degrees, so the angle goes round more than once; "
                "number each turn, forward and back, as its own run",
                file=record.source,
                run=run + 1,
                turn=turn,
            )


# Comment lines that say where the rod was. Where it is lifted, no friction between rod and disc holds the cam.
LIFTED, ON_DISC = "rod lifted", "rod on the disc"


def _rod(record: Record) -> tuple[str, ...]:
    """States of the rod that the comment lines of a record name."""
    return tuple(words for words in (LIFTED, ON_DISC) if any(words in remark.lower() for remark in record.remarks))


def _settled(record: Record, shown: Callable[[], Collection[str]]) -> Record:
    """The record with a remark on the rod: it was on the disc if friction shows, or else holds nothing."""
    if _rod(record):
        return record
    state = ON_DISC if SLIDING_FRICTION.name in shown() else LIFTED
    return replace(record, remarks=(*record.remarks, state))


def _spans(record: Record, nominal: Nominal) -> Iterable[Span]:
    if nominal.ratios:
        expected = float(np.prod(nominal.ratios)) * float(np.ptp(record["cam_angle_deg"]))
        yield Span("motor_angle_deg", float(np.ptp(record["motor_angle_deg"])), expected, "deg")


KIND = Kind(
    code="transmission",
    title=Message("Transmission"),
    columns=(
        Column(name="motor_angle_deg", lower=-1e6, upper=1e6, least_span=90.0),
        Column(name="cam_angle_deg", lower=-800.0, upper=800.0, least_span=10.0),
    ),
    readings=("cam_angle_deg",),
    catalogue=TRANSMISSION,
    datum=Datum(
        words="the zero of the inclinometer in each run",
        name="zero of the inclinometer",
        numbers=(("zero_deg", "deg"),),
    ),
    model=TransmissionModel,
    check=_check,
    settled=_settled,
    counts=8192,  # an encoder of 13 bits
    wanders=True,
    spans=_spans,
    absences=(deviation.RETURN_ERROR,),
    noise=float(np.radians(0.03)),
    nearness=3,
)
