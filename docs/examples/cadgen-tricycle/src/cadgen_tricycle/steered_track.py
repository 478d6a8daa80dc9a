"""Steered track: a front-driven tricycle by its own log, from steering and travel to the place of the rear axle.

With front wheel travel d and steering angle delta, d(heading) = sin(delta) / L d(travel) and
d(place) = cos(delta) (cos heading, sin heading) d(travel); a right turn has delta < 0 here, as it was logged.
The camera's clock in each run is a datum, as its start pose is.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations.catalogue import Catalogue
from cadgen.deviations.effect import Active, Effect, Rows, through
from cadgen.inference.measurement.model import Discrepancy, Model, elapsed, unknown
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.record import Abscissa, Column, Datum, Kind, Method, Record, Span, said
from cadgen.messages import Message
from cadgen_tricycle.clock import Clock, clock
from cadgen_tricycle.effects import DELAY, EFFECTS, MARKER, STEERING, TRAVEL, WHEELBASE, Log, scaled
from cadgen_tricycle.formulas import CREEP, FORMULAS, TURNING

CATALOGUE = Catalogue(*EFFECTS, formulas=FORMULAS)
# Every so many rows enter the fit: 20 rows a second say no more than two of a path that bends over seconds.
THINNED = 10
# Over which a speed is taken; and the least step of the steering that has a sense.
SPEED_SPAN_S, LEAST_TURN = 0.5, np.radians(1.0)
_NO_CREEP = np.zeros(1)


class TricycleModel(Model):
    """Place of the rear axle's centre along each run; start pose and camera's clock of each run are a datum.

    Rows hold first the x and then the y of a run. Those before the log began or after it ended are left out.
    """

    unit = "mm"
    measured: Array

    def __init__(self, record: Record, logged: LoggedCar) -> None:
        self._wheelbase = logged.wheelbase
        self._distance = record["distance_mm"]
        self._run = record.run
        self._first = np.flatnonzero(np.diff(record.run, prepend=-1))
        self._spans = [slice(a, b) for a, b in zip(self._first, [*self._first[1:], len(record.run)], strict=True)]
        self._log = _log_of(record, self._spans, logged.wheelbase)
        time, steering = self._log.time, self._log.steering
        measured = record["x_mm"] + 1j * record["y_mm"]
        heading = np.radians(record["heading_deg"])
        driven = np.cumsum(np.cos(_middle(steering)) * np.diff(self._distance, prepend=self._distance[0]))
        self.clocks = [clock(time[s], measured[s], driven[s]) for s in self._spans]
        # Rows, thinned, first x then y of each run; and where in the log they are, as numbers of rows.
        rows, at = [], []
        for s, each in zip(self._spans, self.clocks, strict=True):
            thinned = np.arange(s.start, s.stop)[::THINNED]
            when = each.log_time(time[thinned])
            inside = (when >= time[s.start]) & (when <= time[s.stop - 1])
            rows.append(thinned[inside])
            at.append(np.interp(when[inside], time[s], np.arange(s.start, s.stop)) if each else thinned)
        where = np.concatenate([np.tile(each, 2) for each in at])
        self._before = where.astype(np.intp)
        self._after, self._share = np.minimum(self._before + 1, len(time) - 1), where - self._before
        self._rows = np.concatenate([np.tile(r, 2) for r in rows])
        self._axis = np.concatenate([np.repeat([0, 1], len(r)) for r in rows])
        self._start = (measured[self._first], heading[self._first])
        self.measured = np.where(self._axis == 0, measured[self._rows].real, measured[self._rows].imag)
        run = record.run[self._rows]
        self.rows = Rows(
            run=run,
            place=TURN * (elapsed(record.run)[self._rows] + 0.5),
            elapsed=elapsed(run),
            cell=np.full(len(run), -1, dtype=np.intp),
        )
        accepted = tuple(formula for formula in FORMULAS if formula.name in logged.accepted)
        self.catalogue: tuple[Effect, ...] = (*scaled(CATALOGUE.effects, logged.wheelbase), *accepted)
        self.formulas = tuple(formula for formula in FORMULAS if formula not in accepted)
        self.floor = 0.0
        self.slip = np.empty(0)
        self.form, self.order = np.empty((len(run), 0)), np.empty(0)
        self.offsets = self._pose(measured)
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(run))
        self.notes = _said_of(self.clocks)

    def residual(self, active: Active) -> Array:
        """Measured less expected coordinates, mm."""
        path = self.path(active)
        place = path[self._before] + self._share * (path[self._after] - path[self._before])
        return np.asarray(self.measured - np.where(self._axis == 0, place.real, place.imag))

    def path(self, active: Active) -> Array:
        """Expected place at every logged row as x + iy, mm."""
        log = self._log
        delay = through(DELAY, 0.0, active, log)
        angle = log.steering
        if delay != 0:
            parts = [np.interp(log.time[s] - delay, log.time[s], angle[s]) for s in self._spans]
            angle = np.concatenate(parts)
        angle = through(STEERING, angle, active, log)
        travel = through(TRAVEL, log.travel, active, log)
        middle = _middle(angle)
        turn = np.sin(middle) * travel / through(WHEELBASE, self._wheelbase, active, log)
        turn = through(TURNING, turn, active, log)
        heading = self._summed(turn, self._start[1])
        forward: NDArray[Any] = np.cos(middle) * travel
        creep = through(CREEP, _NO_CREEP, active, log)
        if creep is not _NO_CREEP:
            forward = forward + 1j * creep
        place = self._summed(forward * _towards(heading - turn / 2), self._start[0])
        marker = through(MARKER, 0j, active, log)
        if marker == 0:
            return place
        towards = _towards(heading)
        return np.asarray(place + marker * (towards - towards[self._first][self._run]))

    def _summed(self, steps: NDArray[Any], start: NDArray[Any]) -> NDArray[Any]:
        total = np.cumsum(steps)
        return np.asarray(total - (total[self._first] - start)[self._run])

    def _pose(self, measured: Array) -> Array:
        """Columns for each run's start: x, y and heading about its first point, along the measured path."""
        columns = []
        for k, first in enumerate(self._first):
            mine = self.rows.run == k
            across = (measured[self._rows] - measured[first]) * 1j
            columns.append((mine & (self._axis == 0)).astype(float))
            columns.append((mine & (self._axis == 1)).astype(float))
            columns.append(np.where(mine, np.where(self._axis == 0, across.real, across.imag), 0.0))
        return np.stack(columns, axis=1)


def _log_of(record: Record, spans: Sequence[slice], wheelbase: float) -> Log:
    """Log of all runs, with what its formulas go by."""
    time, steering, distance = record["t_s"], np.radians(record["steering_deg"]), record["distance_mm"]
    first = [span.start for span in spans]
    travel, turned = np.diff(distance, prepend=distance[0]), np.diff(steering, prepend=steering[0])
    travel[first], turned[first] = 0.0, 0.0
    heading, speed, since = np.empty(len(time)), np.empty(len(time)), np.empty(len(time))
    sense = np.zeros(len(time))
    turn = np.sin(_middle(steering)) * travel / wheelbase
    for span in spans:
        heading[span] = np.cumsum(turn[span])
        since[span] = distance[span] - distance[span.start]
        mine = time[span]
        # Between rows half a second apart: an odometer counts in steps.
        ahead, behind = (np.clip(mine + by, mine[0], mine[-1]) for by in (SPEED_SPAN_S / 2, -SPEED_SPAN_S / 2))
        went = np.interp(ahead, mine, since[span]) - np.interp(behind, mine, since[span])
        speed[span] = went / np.maximum(ahead - behind, 1e-9)
        # The sense of the last step of a degree or more: an encoder may tremble.
        last, way = steering[span.start], 0.0
        for row in range(span.start, span.stop):
            step = steering[row] - last
            if abs(step) >= LEAST_TURN:
                way = 1.0 if step > 0 else -1.0
            if abs(step) >= LEAST_TURN or step * way > 0:
                last = steering[row]
            sense[row] = way
    diameter = said(record, r"diameter ([0-9.]*[0-9]) mm")
    return Log(
        run=record.run,
        place=np.zeros(len(time)),
        elapsed=elapsed(record.run),
        cell=np.full(len(time), -1, dtype=np.intp),
        time=time,
        steering=steering,
        travel=travel,
        turned=turned,
        distance=since,
        speed=speed,
        heading=heading,
        wheel=since / (float(diameter[0]) / 2) if diameter else np.zeros(len(time)),
        sense=sense,
    )


def _middle(angle: Array) -> Array:
    """Mean of the angle at each row and at the one before, rad."""
    return np.asarray((angle + np.append(angle[0], angle[:-1])) / 2)


def _said_of(clocks: Sequence[Clock]) -> tuple[Message, ...]:
    """Sentence on clocks of the camera that are not the log's."""
    off = [each for each in clocks if each]
    if not off:
        return ()
    lags, rates = [each.lag for each in off], [100 * each.rate for each in off]
    return (
        Message(
            "the clocks of camera and log differ in {off} of {runs} runs, as starts, stops and changes of speed show: "
            "the log is {least:.2f} to {most:.2f} s ahead at the start, and gains {slow:.1f} to {fast:.1f} %; "
            "the paths are compared at the same moments",
            off=len(off),
            runs=len(clocks),
            least=min(lags),
            most=max(lags),
            slow=min(rates),
            fast=max(rates),
        ),
    )


def _towards(heading: Array) -> NDArray[np.complex128]:
    """Unit vectors x + iy in directions, rad; the exponential of a complex number takes several times as long."""
    unit = np.empty(heading.shape, dtype=complex)
    unit.real, unit.imag = np.cos(heading), np.sin(heading)
    return unit


def _spans(record: Record, logged: LoggedCar) -> Iterable[Span]:
    """A log against itself: travel with path, steering with turning."""
    run = record.run
    inside = run[1:] == run[:-1]
    travel, angle = np.diff(record["distance_mm"])[inside], np.radians(record["steering_deg"][1:])[inside]
    x, y = (np.diff(record[name])[inside] for name in ("x_mm", "y_mm"))
    # The rear axle goes cos(steering) as far as the wheel in front.
    yield Span("x_mm, y_mm", float(np.abs(x + 1j * y).sum()), float(np.abs(np.cos(angle) * travel).sum()), "mm")
    turned = np.abs(np.diff(np.unwrap(np.radians(record["heading_deg"])))[inside])
    steered = float(np.abs(np.sin(angle) * travel).sum()) / logged.wheelbase
    yield Span("steering_deg", steered, float(turned.sum()), "deg")


STEERED_TRACK = Kind(
    code="steered track",
    title="Steered track",
    columns=(
        Column(name="t_s", lower=0.0, upper=1e6),
        Column(name="distance_mm", lower=-1e7, upper=1e7, least_span=50.0),
        Column(name="steering_deg", lower=-180.0, upper=180.0),
        Column(name="x_mm", lower=-1e6, upper=1e6),
        Column(name="y_mm", lower=-1e6, upper=1e6),
        Column(name="heading_deg", lower=-1e5, upper=1e5),
    ),
    readings=("x_mm", "y_mm"),
    catalogue=CATALOGUE,
    method=Method.RUNS_LEFT_OUT,
    datum=Datum(words="start pose and camera's clock of each run"),
    model=TricycleModel,
    spans=_spans,
    most_rows=200_000,  # logs are thinned
    nearness=5,
    of_design=False,
    abscissa=Abscissa.SHARE,
    plan_view=True,
)
