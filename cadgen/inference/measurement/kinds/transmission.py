"""Transmission: angles at both ends of the train, one turn of the cam forward, then back."""

from collections.abc import Iterable

import numpy as np

from cadgen.deviations import catalogue, deviation
from cadgen.errors import DesignError, FileError
from cadgen.inference.measurement.models.transmission import TransmissionModel
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Column, Datum, Kind, Record, Span

MOST_TURN_DEG = 400.0  # of a camshaft that is to turn once and come back


def _check(record: Record) -> None:
    turned = record["cam_angle_deg"]
    for run, mine in enumerate(record.parts):
        turn = float(np.ptp(turned[mine]))
        if turn > MOST_TURN_DEG:
            raise FileError(
                f"{record.source}: the cam of run {run + 1} turns by {turn:.0f} degrees, so the angle goes round "
                "more than once; number each turn, forward and back, as its own run"
            )


def _spans(record: Record, nominal: Nominal) -> Iterable[Span]:
    if nominal.ratios:
        expected = float(np.prod(nominal.ratios)) * float(np.ptp(record["cam_angle_deg"]))
        yield Span("motor_angle_deg", float(np.ptp(record["motor_angle_deg"])), expected, "deg")


def _model(record: Record, nominal: Nominal) -> TransmissionModel:
    if not nominal.ratios:
        raise DesignError(f"{record.source}: the design has no gear train; add its stages to judge this file")
    return TransmissionModel(
        record, nominal.lift, nominal.ratios, nominal.forces, teeth=nominal.teeth, floor=nominal.train_error
    )


KIND = Kind(
    code="transmission",
    title="Transmission",
    columns=(
        Column(name="motor_angle_deg", lower=-1e6, upper=1e6, least_span=90.0),
        Column(name="cam_angle_deg", lower=-800.0, upper=800.0, least_span=10.0),
    ),
    readings=("cam_angle_deg",),
    catalogue=catalogue.TRANSMISSION,
    datum=Datum(
        words="the zero of the inclinometer in each run",
        name="zero of the inclinometer",
        numbers=(("zero_deg", "deg"),),
    ),
    model=_model,
    check=_check,
    counts=8192,  # an encoder of 13 bits
    spans=_spans,
    absences=(deviation.RETURN_ERROR,),
    nearness=3,
)
