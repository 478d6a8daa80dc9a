"""Lift: a dial on the lever at the disc's inner face, read by cam angle, forward and back."""

from collections.abc import Iterable

import numpy as np

from cadgen.deviations import catalogue
from cadgen.inference.measurement.admission import refuse_twice
from cadgen.inference.measurement.models.lift import LiftModel
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Column, Datum, Direction, Kind, Record, Span


def _check(record: Record) -> None:
    angle = record["cam_angle_deg"] % 360.0
    key = np.stack([record.run, record.columns["direction"] == Direction.FORWARD, angle])
    refuse_twice(record, key[:, angle != 0], "cam_angle_deg")  # 0 and 360 may both be there


def _spans(record: Record, nominal: Nominal) -> Iterable[Span]:
    expected = nominal.follower.inner * nominal.lift.q(np.radians(record["cam_angle_deg"]))
    yield Span("lift_mm", float(np.ptp(record["lift_mm"])), float(np.ptp(expected)), "mm")


def _model(record: Record, nominal: Nominal) -> LiftModel:
    n = nominal
    return LiftModel(record, n.rolled, n.lift, n.follower, noses=len(n.disc.noses), floor=n.form_error)


KIND = Kind(
    code="lift",
    title="Lift",
    columns=(
        Column(name="direction", words=tuple(Direction)),
        Column(name="cam_angle_deg", lower=-1.0, upper=361.0, least_span=10.0),
        Column(name="lift_mm", lower=-100.0, upper=100.0),
    ),
    readings=("lift_mm",),
    catalogue=catalogue.LIFT,
    datum=Datum(words="the zero of the dial in each run", name="zero of the dial", numbers=(("zero_um", "um"),)),
    model=_model,
    check=_check,
    spans=_spans,
    around=True,
    nearness=4,
)
