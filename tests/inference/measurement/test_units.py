"""Numbers of another unit than the header says are found out by what the design lets expect."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.errors import FileError
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.record import refuse_wrong_units
from cadgen.inference.records.load import load

LOGGED = LoggedCar(150.0)


def _scaled(record, columns, factor):
    changed = {name: record[name] * factor for name in columns}
    return replace(record, columns={**record.columns, **changed})


@pytest.mark.parametrize(
    ("file", "columns", "factor", "unit"),
    [
        ("lift_c", ["lift_mm"], 1e-3, "m"),
        ("lift_c", ["lift_mm"], 1 / 25.4, "inches"),
        ("profile_a", ["x_mm", "y_mm"], 1e-3, "m"),
        ("profile_a", ["x_mm", "y_mm"], 0.1, "cm"),
        ("track_c", ["x_mm", "y_mm"], 1e-3, "m"),
        ("transmission_a", ["motor_angle_deg"], np.pi / 180, "rad"),
        ("transmission_a", ["motor_angle_deg"], 1 / 360, "turns"),
    ],
)
def test_a_slip_of_unit_is_named(nominal, measured, file, columns, factor, unit):
    record = load(measured / f"{file}.csv")
    refuse_wrong_units(record, nominal)
    with pytest.raises(FileError, match=f"so it seems to be in {unit}: give"):
        refuse_wrong_units(_scaled(record, columns, factor), nominal)


@pytest.mark.parametrize("file", ["circles", "squares"])
@pytest.mark.parametrize(
    ("columns", "factor", "unit"), [(["steering_deg"], np.pi / 180, "rad"), (["x_mm", "y_mm"], 1e-3, "m")]
)
@pytest.mark.usefixtures("tricycle")
def test_a_log_contradicts_itself(measured, file, columns, factor, unit):
    record = load(measured / f"{file}.csv").only(np.arange(2))
    refuse_wrong_units(record, LOGGED)
    with pytest.raises(FileError, match=f"so it seems to be in {unit}: give"):
        refuse_wrong_units(_scaled(record, columns, factor), LOGGED)
