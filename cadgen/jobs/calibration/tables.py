"""Measured data from arrays in memory, read as the same data in a file would be."""

import csv
import hashlib
import io
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from cadgen.errors import FileError, brief, escaped
from cadgen.inference.records.load import load_text
from cadgen.jobs.calibration.plan import Source


def source_of(columns: Mapping[str, ArrayLike], remarks: Sequence[str], name: str) -> Source:
    """Measured data from arrays.

    Args:
        columns: name with unit, as in a file's header -> values, all of one shape (n,). Without a column `run` (or
            `zone`) they are one run.
        remarks: comment lines of a file, such as `noise 2 um`.
        name: name of the data, for messages and reports.

    Raises:
        FileError: the columns are not of one length, or as `cadgen.inference.records.load.load`.
    """
    name = escaped(brief(name, 80))
    arrays = {str(column): np.asarray(values) for column, values in columns.items()}
    sizes = {column: values.shape for column, values in arrays.items()}
    if not arrays or any(len(size) != 1 for size in sizes.values()) or len(set(sizes.values())) != 1:
        told = brief(", ".join(f"{column} {size}" for column, size in sizes.items()) or "no column")
        raise FileError(f"{name}: its columns have the shapes {told}; every column must be one row of as many values")
    if not {"run", "zone"} & set(arrays):
        arrays = {"run": np.ones(next(iter(sizes.values())), dtype=int), **arrays}
    text = io.StringIO(newline="")
    for remark in remarks:
        text.write(f"# {escaped(str(remark))}\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(arrays)
    writer.writerows(zip(*(values.tolist() for values in arrays.values()), strict=True))
    content = text.getvalue()
    return Source(Path(name), load_text(content, name), hashlib.sha256(content.encode()).hexdigest())
