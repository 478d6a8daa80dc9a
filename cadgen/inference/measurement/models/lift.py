"""The lift that a dial reads: the rod rolled on the changed disc."""

from functools import cached_property

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.path_motion import PathMotion
from cadgen.deviations.catalogue import LIFT
from cadgen.deviations.disc import NOSE_WIDTHS_DEG, worn_nose
from cadgen.deviations.effect import READING, Active, Effect, through
from cadgen.deviations.lift import ANGLE, Readings
from cadgen.inference.measurement.models.base import Discrepancy, elapsed, fourier, per_run, unknown
from cadgen.inference.measurement.models.rolled import CHANGE, Rolled
from cadgen.inference.measurement.record import Direction, Record
from cadgen.inference.measurement.shapes import shapes

FORM_ORDERS = 90
SHAPE_ORDERS = range(1, 61)


class LiftModel:
    """Lift by cam angle, run and direction: reading = w_in tan(beta), the dial at the inner face's nominal place."""

    unit = "um"
    measured = tangent = resolved = None
    behind = Rolled.stages

    def __init__(
        self, record: Record, rolled: Rolled, lift: PathMotion, follower: LeaningRod, *, noses: int, floor: float
    ) -> None:
        self._lift, self._follower = lift, follower
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
        self.catalogue = (*LIFT.effects, *(worn_nose(k, width) for k in range(noses) for width in NOSE_WIDTHS_DEG))
        self.datum: tuple[Effect, ...] = ()
        self.offsets = per_run(record.run)
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(angle))
        self.form, self.order = fourier(angle, FORM_ORDERS)
        self.floor = floor
        self.slip = follower.inner * slope
        self.rolled = rolled

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
