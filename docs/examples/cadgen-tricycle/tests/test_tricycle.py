"""A made-up log whose wheel stood elsewhere than was logged: the error of its zero is found again."""

import numpy as np
from cadgen_tricycle import STEERED_TRACK

from cadgen.inference.measurement.diagnosis import calibrate_logged
from cadgen.inference.measurement.record import Record

WHEELBASE, ROWS, RUNS = 150.0, 600, 4


def log(zero_deg: float) -> Record:
    """Runs along waves, mm and degrees, with noise of 1 mm."""
    rng = np.random.default_rng(1)
    columns: dict[str, list[np.ndarray]] = {column.name: [] for column in STEERED_TRACK.columns}
    for run in range(RUNS):
        travel = 5.0 * np.arange(ROWS)
        logged = 25.0 * np.sin(travel / (150.0 + 40.0 * run))
        angle = np.radians(logged + zero_deg)
        middle, step = (angle[1:] + angle[:-1]) / 2, np.diff(travel)
        turn = np.sin(middle) * step / WHEELBASE
        heading = np.append(0.0, np.cumsum(turn))
        place = np.append(0.0, np.cumsum(np.cos(middle) * step * np.exp(1j * (heading[1:] - turn / 2))))
        noise = rng.normal(0, 1, (2, ROWS))
        values = (0.05 * np.arange(ROWS), travel, logged, place.real + noise[0], place.imag + noise[1])
        for name, value in zip(columns, (*values, np.degrees(heading)), strict=True):
            columns[name].append(value)
    return Record(
        kind=STEERED_TRACK,
        columns={name: np.concatenate(values) for name, values in columns.items()},
        run=np.repeat(np.arange(RUNS), ROWS),
        remarks=(),
        source="made-up log",
    )


def test_an_error_of_the_zero_is_traced() -> None:
    """Of 2 degrees, within a tenth."""
    told = calibrate_logged([log(zero_deg=2.0)], WHEELBASE)
    assert told.judgement.claimed == ("steering zero",)
    (value,) = told.findings[0].values
    assert abs(value.value - 2.0) < 0.1
