"""Effect of each varied key on each figure: the share of the figure's variance that the key explains alone."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.studies.evaluate import Row
from cadgen.studies.study import Study

_BINS = 10  # of a key with more values than that


def effects(study: Study, rows: Sequence[Row]) -> dict[str, dict[str, float]]:
    """Share of variance by figure and key, 0 to 1: the correlation ratio, for which keys need no order.

    The variance of a figure's means over the values of a key, or over ten groups of a range with as many designs each,
    is held against its whole variance; of n designs in k groups chance alone gives (k - 1) / (n - 1), which is taken
    off (the ratio's epsilon squared, Kelley 1935). Figures with fewer than two values are left out.

    Args:
        study: the study.
        rows: some rows of it.
    """
    result: dict[str, dict[str, float]] = {}
    for column, figure in enumerate(study.figures):
        known = [row for row in rows if row.figures[column] is not None]
        figures = np.array([row.figures[column] for row in known], dtype=float)
        if len(known) < 2 or np.ptp(figures) == 0:
            continue
        result[figure.code] = {
            key: _share(_groups([row.values[place] for row in known]), figures) for place, key in enumerate(study.keys)
        }
    return result


def _groups(values: Sequence[object]) -> NDArray[np.int64]:
    """Number of the group of each value."""
    distinct = sorted(set(map(_hashable, values)), key=lambda value: (isinstance(value, str), value))
    numbers = {value: number for number, value in enumerate(distinct)}
    places = np.array([numbers[_hashable(value)] for value in values], dtype=np.int64)
    if len(distinct) <= _BINS:
        return places
    rank = np.argsort(np.argsort(places, kind="stable"), kind="stable")
    return np.asarray(rank * _BINS // len(rank))


def _hashable(value: object) -> float | str:
    return float(value) if isinstance(value, int | float) else str(value)


def _share(groups: NDArray[np.int64], figures: Array) -> float:
    count = np.bincount(groups)
    used = count > 0
    means = np.bincount(groups, figures)[used] / count[used]
    between = float((count[used] * (means - figures.mean()) ** 2).sum())
    whole = float(((figures - figures.mean()) ** 2).sum())
    size, kinds = len(figures), int(used.sum())
    if size <= kinds:
        return between / whole
    return max(1 - (whole - between) / (size - kinds) * (size - 1) / whole, 0.0)
