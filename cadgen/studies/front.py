"""The Pareto front: designs within all limits, of which no other is better in one objective and as good in the rest."""

from collections.abc import Iterable, Sequence
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.studies.evaluate import Row, State
from cadgen.studies.figures.figure import Figure

_BLOCK = 5000  # rows


def objectives_of(row: Row, objectives: Sequence[Figure]) -> list[float]:
    """Objectives of a row, less of which is better; NaN for one that was not computed."""
    return [
        float("nan") if value is None else figure.aim(value)
        for figure, value in zip(objectives, row.figures, strict=False)
    ]


def front(rows: Iterable[Row], objectives: Sequence[Figure]) -> list[Row]:
    """Rows of the front, by number; of rows with equal objectives the first.

    Args:
        rows: all rows, by number; only the front so far and a block of rows are held.
        objectives: figures that are aimed at, first in a row's figures.
    """
    kept = (row for row in rows if row.state == State.KEPT)
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


def ranked(best: Sequence[Row], objectives: Sequence[Figure]) -> list[Row]:
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
