"""Refuse records that no instrument reads: copied runs, too few rows, a mistaken unit, angles that go round twice."""

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import FileError
from cadgen.inference.measurement.record import Method, Record

_ROUNDING = 1e-9  # smaller steps are those of decimal numbers


def refuse_impossible(record: Record) -> None:
    """Check a record of whatever kind, and by its kind's own rule.

    Raises:
        FileError: runs that are copies, too few rows or too short a span in a run, or what the kind refuses.
    """
    if record.kind.method is Method.ZONE_MEANS:
        return
    # One column after the other, rows in the order of runs: a run is a slice, and its digits are its name.
    readings = np.stack([values.astype(float) for values in record.columns.values() if values.dtype.kind == "f"])
    runs, seen, counted = record.parts, dict[bytes, int](), _counted(record)
    for later, mine in enumerate(runs):
        earlier = seen.setdefault(readings[:, mine].tobytes(), later)
        if earlier != later and not counted:
            raise FileError(
                f"{record.source}: runs {earlier + 1} and {later + 1} are the same to the last digit; a copy is no "
                "repetition: give runs that were measured anew"
            )
    wide = [(column, record[column.name]) for column in record.kind.columns if column.least_span]
    for run, mine in enumerate(runs):
        if (rows := mine.stop - mine.start) < (least := record.kind.least_rows):
            raise FileError(f"{record.source}: run {run + 1} has {rows} rows; give at least {least} in each run")
        for column, values in wide:
            if (span := float(np.ptp(values[mine]))) < column.least_span:
                raise FileError(
                    f"{record.source}: {column.name} of run {run + 1} spans only {span:g}; check its unit, or measure "
                    f"at least {column.least_span:g}"
                )
    record.kind.check(record)


def _counted(record: Record) -> bool:
    """Whether an instrument whose steps are coarse may read the same twice, as an encoder of few counts does."""
    for column in record.kind.readings:
        values = np.unique(record[column])
        steps = np.diff(values)
        least = float(np.min(steps[steps > _ROUNDING], initial=np.inf))
        if np.ptp(values) > record.kind.counts * least:
            return False
    return True


def refuse_twice(record: Record, key: NDArray[np.generic], column: str) -> None:
    """Refuse rows of one run that were taken under one condition.

    Args:
        record: for the message.
        key: condition of each row, shape (k, n), the angle last.
        column: of the angle.

    Raises:
        FileError: a condition stands twice.
    """
    unique, count = np.unique(key, axis=1, return_counts=True)
    if (count > 1).any():
        where = unique[-1, int(np.argmax(count))]
        raise FileError(
            f"{record.source}: {column} {float(where):g} stands twice in one run, so the angle goes round more than "
            "once; number each turn as its own run"
        )
