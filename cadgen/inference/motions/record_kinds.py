"""Kinds of records of a cam whose motion is sought: points or radii of its outline, or lifts by cam angle."""

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.catalogue import Catalogue
from cadgen.errors import FileError
from cadgen.inference.measurement.record import Column, Datum, Kind, Record
from cadgen.laws.unit import MM, Unit

_FARTHEST_MM = 5000.0
_TURNS_DEG = 3600.0
_WHOLE_DEG = 300.0
_LEAST_ROWS = 90
_MOST_ROWS = 200_000


def _kind(code: str, title: str, columns: tuple[Column, ...], reading: str) -> Kind:
    """Kind of which one record shows the whole cam, without effects to choose from."""
    return Kind(
        code=code,
        title=title,
        columns=columns,
        readings=(reading,),
        catalogue=Catalogue(),
        datum=Datum(words=""),
        least_rows=_LEAST_ROWS,
        most_rows=_MOST_ROWS,
        nearness=0,
    )


_CAM_ANGLE = Column(name="cam_angle_deg", lower=-_TURNS_DEG, upper=_TURNS_DEG, least_span=_WHOLE_DEG)
OUTLINE = _kind(
    "cam outline",
    "Outline of a cam",
    tuple(Column(name=name, lower=-_FARTHEST_MM, upper=_FARTHEST_MM) for name in ("x_mm", "y_mm")),
    "x_mm",
)
RADII = _kind(
    "cam radii",
    "Radii of a cam",
    (
        Column(name="polar_angle_deg", lower=-_TURNS_DEG, upper=_TURNS_DEG, least_span=_WHOLE_DEG),
        Column(name="radius_mm", lower=0.0, upper=_FARTHEST_MM),
    ),
    "radius_mm",
)
LIFTS = _kind("cam lift", "Lift of a cam", (_CAM_ANGLE, Column(name="lift_mm", lower=-1000.0, upper=1000.0)), "lift_mm")
SWINGS = _kind(
    "cam swing",
    "Swing of a cam's follower",
    (_CAM_ANGLE, Column(name="lift_deg", lower=-180.0, upper=180.0)),
    "lift_deg",
)


def kinds_for(unit: Unit) -> tuple[Kind, ...]:
    """Kinds of records that show the motion of a follower.

    Args:
        unit: unit of its motion.
    """
    return (OUTLINE, RADII, LIFTS if unit == MM else SWINGS)


def points_of(record: Record) -> Array | None:
    """Points of an outline, mm, shape (n, 2); None for lifts.

    Args:
        record: record of one of the kinds.
    """
    if record.kind.code == OUTLINE.code:
        return np.stack([record["x_mm"], record["y_mm"]], axis=1)
    if record.kind.code == RADII.code:
        angle, radius = np.radians(record["polar_angle_deg"]), record["radius_mm"]
        return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    return None


def lifts_of(record: Record, unit: Unit) -> tuple[Array, Array]:
    """Cam angles, rad, and motion of a record of lifts, in the motion's unit, shape (n,) each.

    Args:
        record: record of lifts or swings.
        unit: unit of the motion.
    """
    angle = np.radians(record["cam_angle_deg"])
    return angle, record["lift_mm"] if unit == MM else np.radians(record["lift_deg"])


def refuse_several(records: tuple[Record, ...]) -> Record:
    """The one record that a motion is found from.

    Args:
        records: records that were given.

    Raises:
        FileError: there are several, or one has several runs, each clamped or set to zero anew.
    """
    if len(records) != 1:
        raise FileError(
            "{count} files were given, and a motion is found from one record of the whole cam: give one of them",
            count=len(records),
        )
    (record,) = records
    if record.runs > 1:
        raise FileError(
            "{file} has {runs} runs, and a motion is found from one: keep one run of the whole cam in a file",
            file=record.source,
            runs=record.runs,
        )
    return record
