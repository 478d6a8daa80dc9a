"""The table of a study as CSV and as Parquet, written row by row."""

import csv
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from cadgen.studies.evaluate import Row
from cadgen.studies.results import cells, head
from cadgen.studies.study import Study

_GROUP = 10_000  # rows of Parquet that are held at once


def write_csv(file: Path, study: Study, rows: Iterable[Row]) -> None:
    """Write the table as CSV: UTF-8, a head, every float with all its digits, lists as JSON.

    Args:
        file: path of the file.
        study: the study.
        rows: its rows, in order.
    """
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(head(study))
        writer.writerows([_plain(value) for value in cells(row)] for row in rows)


def write_parquet(file: Path, study: Study, rows: Iterable[Row]) -> bool:
    """Write the table as Parquet; False without pyarrow, and then there is no file.

    Args:
        file: path of the file.
        study: the study.
        rows: its rows, in order.
    """
    try:
        import pyarrow as pa
        from pyarrow import parquet
    except ImportError:
        return False
    varied = [_kind(pa, variation.some) for variation in study.variations]
    kinds = [pa.int64(), *varied, pa.string(), *([pa.float64()] * len(study.figures)), pa.string(), pa.string()]
    schema = pa.schema(list(zip(head(study), kinds, strict=True)))
    with parquet.ParquetWriter(file, schema) as writer:
        group: list[Sequence[object]] = []

        def flush() -> None:
            columns = [
                pa.array([_fitting(pa, value, kind) for value in column], kind)
                for column, kind in zip(zip(*group, strict=True), kinds, strict=True)
            ]
            writer.write_table(pa.table(columns, schema=schema))
            group.clear()

        for row in rows:
            group.append(cells(row))
            if len(group) == _GROUP:
                flush()
        if group:
            flush()
    return True


def _plain(value: object) -> object:
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value, ensure_ascii=False) if isinstance(value, list) else value


def _kind(pa: Any, values: Sequence[object]) -> Any:
    """Type of a column that holds these values; of numbers of both kinds, and of a range, floats."""
    types = {type(value) for value in values}
    if types == {bool}:
        return pa.bool_()
    if types == {int}:
        return pa.int64()
    return pa.float64() if types <= {int, float} else pa.string()


def _fitting(pa: Any, value: Any, kind: Any) -> Any:
    return str(_plain(value)) if kind == pa.string() and not isinstance(value, str) else value
