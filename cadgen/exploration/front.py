"""The Pareto front: designs within all limits, of which no other is better in one objective and as good in the rest."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.exploration.evaluate import Row
from cadgen.exploration.figures.figure import Figure


def objectives_of(row: Row, objectives: Sequence[Figure]) -> list[float]:
    """Objectives of a row, less of which is better; NaN for one that was not computed."""
    return [
        float("nan") if value is None else figure.aim(value)
        for figure, value in zip(objectives, row.figures, strict=False)
    ]


def front(rows: Iterable[Row], objectives: Sequence[Figure]) -> list[Row]:
    """Rows of the front, by number; of rows with equal objectives the first.

    Args:
        rows: all rows; only the front so far is held.
        objectives: figures that are aimed at, first in a row's figures.
    """
    best: list[Row] = []
    points: Array = np.empty((0, len(objectives)))
    for row in rows:
        if row.state != "kept":
            continue
        point = np.array(objectives_of(row, objectives))
        if (points <= point).all(axis=1).any():
            continue
        stays: NDArray[np.bool_] = np.asarray(~(points >= point).all(axis=1))
        best = [each for each, stay in zip(best, stays.tolist(), strict=True) if stay]
        best.append(row)
        points = np.concatenate([points[stays], point[None]])
    return best


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
