"""Steered track: a front-driven tricycle by its own log, from steering and travel to the place of the rear axle.

With front wheel travel d and steering angle delta, d(heading) = sin(delta) / L d(travel) and
d(place) = cos(delta) (cos heading, sin heading) d(travel); a right turn has delta < 0 here, as it was logged.
"""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations.catalogue import Catalogue
from cadgen.deviations.effect import Active, Effect, through
from cadgen.inference.measurement.model import Discrepancy, Model, elapsed, unknown
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.record import Abscissa, Column, Datum, Kind, Method, Record, Span
from cadgen_tricycle.effects import DELAY, EFFECTS, MARKER, STEERING, TRAVEL, WHEELBASE, Log, scaled

CATALOGUE = Catalogue(*EFFECTS)
# Every so many rows enter the fit: 20 rows a second say no more than two of a path that bends over seconds.
THINNED = 10


class TricycleModel(Model):
    """Place of the rear axle's centre along each run; the start pose of each run is a datum.

    Rows hold first the x and then the y of a run.
    """

    unit = "mm"
    measured: Array

    def __init__(self, record: Record, wheelbase: float) -> None:
        self._wheelbase = wheelbase
        self._distance = record["distance_mm"]
        self._run = record.run
        time, steering = record["t_s"], np.radians(record["steering_deg"])
        self._log = Log(
            run=record.run,
            place=np.zeros(len(time)),
            elapsed=elapsed(record.run),
            cell=np.full(len(time), -1, dtype=np.intp),
            time=time,
            steering=steering,
        )
        self._first = np.flatnonzero(np.diff(record.run, prepend=-1))
        self._spans = [slice(a, b) for a, b in zip(self._first, [*self._first[1:], len(time)], strict=True)]
        measured = record["x_mm"] + 1j * record["y_mm"]
        heading = np.radians(record["heading_deg"])
        # Rows, thinned, first x then y of each run.
        rows = [np.arange(s.start, s.stop)[::THINNED] for s in self._spans]
        self._rows = np.concatenate([np.tile(r, 2) for r in rows])
        self._axis = np.concatenate([np.repeat([0, 1], len(r)) for r in rows])
        self._start = (measured[self._first], heading[self._first])
        self.measured = np.where(self._axis == 0, measured[self._rows].real, measured[self._rows].imag)
        run = record.run[self._rows]
        self.rows = Log(
            run=run,
            place=TURN * (elapsed(record.run)[self._rows] + 0.5),
            elapsed=elapsed(run),
            cell=np.full(len(run), -1, dtype=np.intp),
            time=time[self._rows],
            steering=steering[self._rows],
        )
        self.catalogue: tuple[Effect, ...] = scaled(CATALOGUE.effects, wheelbase)
        self.floor = 0.0
        self.slip = np.empty(0)
        self.form, self.order = np.empty((len(run), 0)), np.empty(0)
        self.offsets = self._pose(measured)
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(run))

    def residual(self, active: Active) -> Array:
        """Measured less expected coordinates, mm."""
        place = self.path(active)[self._rows]
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
        travel = np.append(0.0, np.diff(self._distance))
        travel[self._first] = 0.0
        travel = through(TRAVEL, travel, active, log)
        middle = (angle + np.append(angle[0], angle[:-1])) / 2
        turn = np.sin(middle) * travel / through(WHEELBASE, self._wheelbase, active, log)
        heading = self._summed(turn, self._start[1])
        place = self._summed(np.cos(middle) * travel * _towards(heading - turn / 2), self._start[0])
        marker = through(MARKER, 0j, active, log)
        if marker == 0:
            return place
        towards = _towards(heading)
        return np.asarray(place + marker * (towards - towards[self._first][self._run]))

    def _summed(self, steps: Array, start: Array) -> Array:
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


def _model(record: Record, logged: LoggedCar) -> TricycleModel:
    return TricycleModel(record, logged.wheelbase)


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
    datum=Datum(words="the start pose of each run"),
    model=_model,
    spans=_spans,
    most_rows=200_000,  # logs are thinned
    nearness=5,
    of_design=False,
    abscissa=Abscissa.SHARE,
    plan_view=True,
)
