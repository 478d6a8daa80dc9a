"""The Pareto front of a study, and the effect of each varied key on each figure.

The front has the designs within all limits of which no other is better in one objective and as good in the rest. The
effect of a key on a figure is the share of the figure's variance that the key explains alone.
"""

from collections.abc import Iterable, Sequence
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.studies.design_row import DesignState, Row
from cadgen.studies.study import Study
from cadgen.studies.study_figures import StudyFigure

_BLOCK = 5000  # rows


def objectives_of(row: Row, objectives: Sequence[StudyFigure]) -> list[float]:
    """Objectives of a row, less of which is better; NaN for one that was not computed."""
    return [
        float("nan") if value is None else figure.aim(value)
        for figure, value in zip(objectives, row.figures, strict=False)
    ]


def front(rows: Iterable[Row], objectives: Sequence[StudyFigure]) -> list[Row]:
    """Rows of the front, by number; of rows with equal objectives the first.

    Args:
        rows: all rows, by number; only the front so far and a block of rows are held.
        objectives: figures that are aimed at, first in a row's figures.
    """
    kept = (row for row in rows if row.state == DesignState.KEPT)
    best: list[Row] = []
    while block := list(islice(kept, _BLOCK)):
        both = [*best, *block]
        points = np.array([objectives_of(row, objectives) for row in both]).reshape(len(both), -1)
        best = [row for row, stays in zip(both, _unbeaten(points).tolist(), strict=True) if stays]
    return best


def _unbeaten(points: Array) -> NDArray[np.bool_]:
    """Points that no other beats, and no earlier one equals, shape (n, k) -> (n,).

    Sorted by all coordinates, a point can be beaten by those before it alone, and is by one of their front if by any.
    """
    order = np.lexsort((np.arange(len(points)), *points.T[::-1]))
    stays = np.zeros(len(points), dtype=bool)
    found = np.empty_like(points)
    count = 0
    for number in order.tolist():
        point = points[number]
        # Of those before it all first coordinates are as good: with two, the last of their front is the one to beat.
        near = found[max(count - 1, 0) : count] if points.shape[1] == 2 else found[:count]
        if not (near <= point).all(axis=1).any():
            found[count], stays[number] = point, True
            count += 1
    return stays


def ranked(best: Sequence[Row], objectives: Sequence[StudyFigure]) -> list[Row]:
    """Rows of a front: the best in each objective, then those nearest to the best of all objectives together.

    Distances are shares of the front's extent in each objective.
    """
    if not best:
        return []
    points = np.array([objectives_of(row, objectives) for row in best])
    least, extent = points.min(axis=0), np.ptp(points, axis=0)
    away = np.linalg.norm((points - least) / np.where(extent > 0, extent, 1.0), axis=1)
    first = [int(np.lexsort((away, points[:, column]))[0]) for column in range(len(objectives))]
    order = dict.fromkeys([*first, *np.argsort(away, kind="stable").tolist()])
    return [best[number] for number in order]


_BINS = 10  # of a key with more values than that


def effects(study: Study, rows: Sequence[Row]) -> dict[str, dict[str, float]]:
    """Share of variance by figure and key, 0 to 1: the correlation ratio, for which keys need no order.

    The variance of a figure's means over the values of a key, or over ten groups of a range with as many designs each,
    is held against its whole variance; of n designs in k groups chance alone gives (k - 1) / (n - 1), which is taken
    off (the ratio's epsilon squared, Kelley 1935). Figures with fewer than two values, or whose values differ by no
    more than their resolution, are left out: what explains rounding explains nothing.

    Args:
        study: the study.
        rows: some rows of it.
    """
    result: dict[str, dict[str, float]] = {}
    for column, figure in enumerate(study.figures):
        known = [row for row in rows if row.figures[column] is not None]
        figures = np.array([row.figures[column] for row in known], dtype=float)
        if len(known) < 2 or np.ptp(figures) <= figure.resolution:
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
