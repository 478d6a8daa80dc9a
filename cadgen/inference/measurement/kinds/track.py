"""Track: where the drive wheel is, by the cam angle that the motor has turned since the start."""

from collections.abc import Iterable
from math import pi

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations import catalogue, deviation
from cadgen.inference.measurement.admission import refuse_twice
from cadgen.inference.measurement.models.start import NUMBERS, doubts, held
from cadgen.inference.measurement.models.track import TrackModel
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Abscissa, Column, Datum, Kind, Record, Span

PLANNED_ROWS = 36


def _check(record: Record) -> None:
    refuse_twice(record, np.stack([record.run, record["cam_angle_deg"]]), "cam_angle_deg")


def _extent(x: Array, y: Array) -> float:
    return float(np.hypot(np.ptp(x), np.ptp(y)))


def _spans(record: Record, nominal: Nominal) -> Iterable[Span]:
    share = np.radians(record["cam_angle_deg"]) / (2 * pi)
    path = nominal.track.position(np.clip(share * nominal.track.turn, 0.0, nominal.track.length))
    yield Span("x_mm, y_mm", _extent(record["x_mm"], record["y_mm"]), _extent(*path.T), "mm")


def _model(record: Record, nominal: Nominal) -> TrackModel:
    n = nominal
    return TrackModel(record, n.rolled, n.lift, n.car, n.track, n.forces, floor=n.form_error)


def _starts(model: TrackModel, values: Array, sigmas: Array) -> tuple[str, tuple[str, ...]]:
    return held(model.used), doubts(model.used, model.stated, values, sigmas)


KIND = Kind(
    code="track",
    title="Track",
    columns=(
        Column(name="cam_angle_deg", lower=-1.0, upper=361.0, least_span=10.0),
        Column(name="x_mm", lower=-1e6, upper=1e6),
        Column(name="y_mm", lower=-1e6, upper=1e6),
    ),
    readings=("x_mm", "y_mm"),
    catalogue=catalogue.TRACK,
    datum=Datum(
        words="the start pose of each run",
        name="start pose",
        numbers=NUMBERS,
        notes=_starts,
    ),
    model=_model,
    check=_check,
    spans=_spans,
    absences=(deviation.RETURN_ERROR, deviation.SLIDING_FRICTION),
    nearness=1,
    rod_on=True,
    abscissa=Abscissa.TRAVEL,
    plan_view=True,
)


def run_of(nominal: Nominal) -> TrackModel:
    """The model of a car that runs as designed: for what effects do to its run, where no track was measured."""
    motor = np.arange(0.0, 360.0, 360.0 / PLANNED_ROWS)
    x, y = nominal.track.position(np.minimum(motor / 360.0 * nominal.track.turn, nominal.track.length)).T
    columns = {"cam_angle_deg": motor, "x_mm": x, "y_mm": y}
    run = np.zeros(len(motor), dtype=np.intp)
    return _model(Record(kind=KIND, columns=columns, run=run, remarks=(), source="the planned track"), nominal)
