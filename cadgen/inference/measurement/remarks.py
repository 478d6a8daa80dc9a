"""Comment lines of measured files: the design, instrument and part that they name."""

import re
from collections.abc import Iterable
from dataclasses import dataclass

from cadgen.inference.measurement.record import Record


@dataclass(frozen=True)
class Instrument:
    """Noise that a file states of the instrument, in the file's unit."""

    noise: float
    unit: str


def instrument(record: Record) -> Instrument | None:
    """Noise that the comment lines state; None if they do not."""
    if stated := said(record, r"noise\s+([0-9.]+)\s*(um|mm|deg)\b"):
        return Instrument(float(stated[0]), stated[1])
    return None


def printed(record: Record) -> bool:
    """True if a comment line says that the part was printed, not machined."""
    return any(re.search(r"\bprinted\b", remark) for remark in record.remarks)


def said(record: Record, pattern: str) -> tuple[str, ...]:
    """Groups of a pattern's first match in the comment lines; empty without a match."""
    return _first(record.remarks, pattern)


def said_of_runs(record: Record, pattern: str) -> list[tuple[str, ...]]:
    """The same in the comment lines of each run's own file."""
    return [_first(remarks, pattern) for remarks in record.of_runs or (record.remarks,) * record.runs]


def _first(remarks: Iterable[str], pattern: str) -> tuple[str, ...]:
    for remark in remarks:
        if match := re.search(pattern, remark):
            return match.groups()
    return ()
