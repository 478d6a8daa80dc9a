"""The three wheels' tracks as a table: one row per motor position, columns for each run."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from cadgen.arrays import Array
from cadgen.car.running.drive import Run
from cadgen.errors import FileError

_WHEELS = ("drive", "front", "idle")
_DECIMALS = 4  # 0.1 um of place and 1e-4 degrees
# Half of the last decimal, and the rounding of a sum.
_READ_TOLERANCE = 0.51 * 10.0**-_DECIMALS


def track_table(runs: Mapping[str, Run]) -> dict[str, Array]:
    """Columns by name, in degrees and mm: `motor_deg`, then for each run cam angle, steering, heading and wheels.

    Args:
        runs: runs by name, all at the same motor positions.
    """
    table = {"motor_deg": np.degrees(next(iter(runs.values())).motor)}
    for name, run in runs.items():
        table[f"{name}_cam_angle_deg"] = np.degrees(run.cam_angle)
        table[f"{name}_steering_deg"] = np.degrees(np.arctan(run.tan_beta))
        table[f"{name}_heading_deg"] = np.degrees(run.heading)
        for wheel in _WHEELS:
            for axis, values in zip("xy", getattr(run, f"{wheel}_wheel").T, strict=True):
                table[f"{name}_{wheel}_{axis}_mm"] = values
    return table


def write_tracks(file: Path, runs: Mapping[str, Run]) -> None:
    """Write the table as CSV, and read it back.

    Raises:
        FileError: the file, read back, holds other values.
    """
    table = track_table(runs)
    rows = np.column_stack(list(table.values()))
    np.savetxt(file, rows, fmt=f"%.{_DECIMALS}f", delimiter=",", header=",".join(table), comments="", encoding="utf-8")
    again = read_tracks(file)
    if list(again) != list(table) or not all(
        np.allclose(again[name], values, rtol=0, atol=_READ_TOLERANCE) for name, values in table.items()
    ):
        raise FileError(f"{file.name}, read back, is not the tracks that were meant: report this design")


def read_tracks(file: Path) -> dict[str, Array]:
    """Columns of a table of tracks by name, degrees and mm."""
    with file.open(encoding="utf-8") as text:
        names = text.readline().strip().split(",")
        return dict(zip(names, np.loadtxt(text, delimiter=",", ndmin=2).T, strict=True))
