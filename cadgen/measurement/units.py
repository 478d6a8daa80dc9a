"""Refuse a file whose numbers are those of another unit than its header says, by what the design lets expect."""

from math import pi
from typing import Protocol

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.deviations.disc import Disc
from cadgen.errors import FileError
from cadgen.measurement.record import Record
from cadgen.path.track import Track

# Size of a number in a mistaken unit, over its size in the one that the header names.
SLIPS = {
    "mm": {"m": 1e-3, "cm": 0.1, "inches": 1 / 25.4, "um": 1e3},
    "deg": {"rad": pi / 180, "turns": 1 / 360},
}
# A part that was made to the design does not differ from it by so much; a slip of unit is that near to its factor.
NEAR = 1.6


class Expected(Protocol):
    """What of a design says how far measured readings span; as in `Nominal`."""

    @property
    def lift(self) -> LiftCurve:
        """The lift that the cam gives."""

    @property
    def follower(self) -> Follower:
        """What rolls on it."""

    @property
    def disc(self) -> Disc:
        """The outline that was made."""

    @property
    def track(self) -> Track:
        """The track of the drive wheel."""

    @property
    def ratios(self) -> tuple[float, ...]:
        """Of the train's stages; empty if there is none."""


def refuse_wrong_units(record: Record, nominal: Expected) -> None:
    """Compare how far the readings span with what the design would give.

    Raises:
        FileError: they are those of another unit.
    """
    if record.kind == "lift":
        expected = nominal.follower.inner * nominal.lift.tan_beta(np.radians(record["cam_angle_deg"]))
        _refuse(record, "lift_mm", float(np.ptp(record["lift_mm"])), float(np.ptp(expected)))
    elif record.kind == "profile":
        radius = float(np.hypot(record["x_mm"], record["y_mm"]).max())
        _refuse(record, "x_mm, y_mm", radius, float(np.linalg.norm(nominal.disc.points, axis=1).max()))
    elif record.kind == "track":
        share = np.radians(record["cam_angle_deg"]) / (2 * pi)
        path = nominal.track.position(np.clip(share, 0.0, 1.0) * nominal.track.length)
        _refuse(record, "x_mm, y_mm", _extent(record["x_mm"], record["y_mm"]), _extent(*path.T))
    elif record.kind == "transmission" and nominal.ratios:
        ratio = float(np.prod(nominal.ratios))
        _refuse(
            record, "motor_angle_deg", float(np.ptp(record["motor_angle_deg"])), ratio * np.ptp(record["cam_angle_deg"])
        )


def refuse_wrong_log(record: Record, wheelbase: float) -> None:
    """Compare a log of steering with itself: travel with path, steering with turning.

    Raises:
        FileError: its columns contradict each other by a factor of units.
    """
    run = record.run
    inside = run[1:] == run[:-1]
    travel, angle = np.diff(record["distance_mm"])[inside], np.radians(record["steering_deg"][1:])[inside]
    x, y = (np.diff(record[name])[inside] for name in ("x_mm", "y_mm"))
    # The rear axle goes cos(steering) as far as the wheel in front.
    _refuse(record, "x_mm, y_mm", float(np.abs(x + 1j * y).sum()), float(np.abs(np.cos(angle) * travel).sum()))
    turned = np.abs(np.diff(np.unwrap(np.radians(record["heading_deg"])))[inside])
    _refuse(
        record, "steering_deg", float(np.abs(np.sin(angle) * travel).sum()) / wheelbase, float(turned.sum()), unit="deg"
    )


def _refuse(record: Record, column: str, found: float, expected: float, unit: str = "") -> None:
    unit = unit or column.rsplit("_", 1)[1]
    for other, factor in SLIPS[unit].items():
        if expected > 0 and factor / NEAR < found / expected < factor * NEAR:
            raise FileError(
                f"{record.source}: {column} is {'greater' if factor > 1 else 'smaller'} than the design lets expect by "
                f"a factor of {round(max(factor, 1 / factor), 1):g}, so it seems to be in {other}: give {unit}"
            )


def _extent(x: Array, y: Array) -> float:
    return float(np.hypot(np.ptp(x), np.ptp(y)))
