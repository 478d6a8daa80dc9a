"""Steered track: a front-driven tricycle whose steering and travel are logged."""

from collections.abc import Iterable

import numpy as np

from cadgen.deviations import catalogue
from cadgen.inference.measurement.models.tricycle import TricycleModel
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.record import Abscissa, Column, Datum, Kind, Method, Record, Span


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


KIND = Kind(
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
    catalogue=catalogue.STEERED_TRACK,
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
