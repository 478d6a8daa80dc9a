"""Refuse a file whose numbers are those of another unit than its header says, by what the design lets expect."""

from math import pi
from typing import Any

from cadgen.errors import FileError
from cadgen.inference.measurement.record import Record, Span

# Size of a number in a mistaken unit, over its size in the one that the header names.
SLIPS = {
    "mm": {"m": 1e-3, "cm": 0.1, "inches": 1 / 25.4, "um": 1e3},
    "deg": {"rad": pi / 180, "turns": 1 / 360},
}
# A part that was made to the design does not differ from it by so much; a slip of unit is that near to its factor.
NEAR = 1.6


def refuse_wrong_units(record: Record, against: Any) -> None:
    """Compare how far the readings span with what the design, or another column of them, lets expect.

    Args:
        record: of any kind.
        against: what data of its kind are measured against (see `Kind.model`).

    Raises:
        FileError: they are those of another unit.
    """
    for span in record.kind.spans(record, against):
        _refuse(record, span)


def _refuse(record: Record, span: Span) -> None:
    for other, factor in SLIPS.get(span.unit, {}).items():
        if span.expected > 0 and factor / NEAR < span.measured / span.expected < factor * NEAR:
            raise FileError(
                f"{record.source}: {span.columns} is {'greater' if factor > 1 else 'smaller'} than the design lets "
                f"expect by a factor of {round(max(factor, 1 / factor), 1):g}, so it seems to be in {other}: give "
                f"{span.unit}"
            )
