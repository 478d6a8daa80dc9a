"""Lift: a dial on the lever at the disc's inner face, read by cam angle, forward and back."""

from functools import cached_property

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.catalogue import LIFT
from cadgen.deviations.disc import NOSE_WIDTHS_DEG, worn_nose
from cadgen.deviations.effect import READING, Active, Effect, through
from cadgen.deviations.instrument import LAST_INDEX, index_error
from cadgen.deviations.lift import ANGLE, Readings
from cadgen.inference.measurement.model import CHANGE, Discrepancy, Model, Rolled, elapsed, fourier, per_run, unknown
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Column, Datum, Direction, Kind, Record, Span, refuse_twice
from cadgen.inference.measurement.shapes import shapes
from cadgen.messages import Message

FORM_ORDERS = 90
SHAPE_ORDERS = range(1, 61)


class LiftModel(Model):
    """Lift by cam angle, run and direction: reading = w_in tan(beta), the dial at the inner face's nominal place."""

    unit = "um"
    behind = Rolled.stages
    rolled: Rolled

    def __init__(self, record: Record, nominal: Nominal) -> None:
        self._lift, self._follower = lift, follower = nominal.lift, nominal.follower
        self._reading = record["lift_mm"]
        angle = np.radians(record["cam_angle_deg"])
        forward = record.columns["direction"] == Direction.FORWARD
        key = np.round(record["cam_angle_deg"], 6) + 1000.0 * forward
        slope = np.asarray(lift.q(angle, nu=1))
        self.rows = Readings(
            run=record.run,
            place=angle,
            elapsed=elapsed(record.run),
            cell=np.unique(key, return_inverse=True)[1].astype(np.intp),
            direction=np.where(forward, 1.0, -1.0),
            slope=np.sign(slope),
            steering=np.asarray(lift.q(angle)),
        )
        self.catalogue = (
            *LIFT.effects,
            *(worn_nose(k, width) for k in range(len(nominal.disc.noses)) for width in NOSE_WIDTHS_DEG),
            *(index_error(order) for order in range(2, LAST_INDEX + 1)),
        )
        self.offsets = per_run(record.run)
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(angle))
        self.form, self.order = fourier(angle, FORM_ORDERS)
        self.floor = nominal.form_error
        self.slip = follower.inner * slope
        self.rolled = nominal.rolled

    @cached_property
    def shapes(self) -> tuple[Effect, ...]:
        """Harmonics, bumps and steps of the reading."""
        return shapes(self.rows, self.unit, SHAPE_ORDERS, CHANGE)

    def residual(self, active: Active) -> Array:
        """Measured less expected reading, mm."""
        angle = through(ANGLE, self.rows.place, active, self.rows)
        steering = self._lift.q(angle)
        if (change := self.rolled.change(active, self.rows)) is not None:
            steering = steering + change(angle)
        reading = through(READING, self._follower.inner * steering, active, self.rows)
        return self._reading - reading


def _check(record: Record) -> None:
    angle = record["cam_angle_deg"] % 360.0
    key = np.stack([record.run, record.columns["direction"] == Direction.FORWARD, angle])
    refuse_twice(record, key[:, angle != 0], "cam_angle_deg")  # 0 and 360 may both be there


KIND = Kind(
    code="lift",
    title=Message("Lift"),
    columns=(
        Column(name="direction", words=tuple(Direction)),
        Column(name="cam_angle_deg", lower=-1.0, upper=361.0, least_span=10.0),
        Column(name="lift_mm", lower=-100.0, upper=100.0),
    ),
    readings=("lift_mm",),
    catalogue=LIFT,
    datum=Datum(words="the zero of the dial in each run", name="zero of the dial", numbers=(("zero_um", "um"),)),
    model=LiftModel,
    check=_check,
    spans=lambda record, nominal: [
        Span(
            "lift_mm",
            float(np.ptp(record["lift_mm"])),
            float(np.ptp(nominal.follower.inner * nominal.lift.q(np.radians(record["cam_angle_deg"])))),
            "mm",
        )
    ],
    around=True,
    noise=4e-3,
    nearness=4,
)
