"""Linearised responses of effects, as columns of one matrix."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import Effect
from cadgen.inference.measurement.hypothesis import Hypothesis
from cadgen.inference.measurement.joint import Joint


@dataclass(frozen=True)
class Columns:
    """Linearised responses of candidate effects: `spans[i]` are the columns of `effects[i]`."""

    effects: tuple[Effect, ...]
    spans: tuple[slice, ...]
    values: Array


def tangents(joint: Joint, effects: tuple[Effect, ...], best: Hypothesis) -> Columns:
    """Responses of effects about the best subset, in their order; those that do nothing there are left out."""
    values = joint.slopes(effects, best.active)
    ends = np.cumsum([0, *(len(e.parameters) for e in effects)])
    # A second parameter that does nothing yet (a width at no depth) has no column of its own.
    alive = np.linalg.norm(values, axis=0) > 0
    kept = np.concatenate([[0], np.cumsum(alive)])
    spans = tuple(slice(int(kept[a]), int(kept[b])) for a, b in pairwise(ends))
    useful = [i for i, s in enumerate(spans) if s.stop > s.start]
    return Columns(tuple(effects[i] for i in useful), tuple(spans[i] for i in useful), values[:, alive])


def of_shapes(joint: Joint) -> Columns:
    """Shapes act on the reading alone and in proportion to their size, so their columns are read off."""
    columns: list[Array] = []
    spans = []
    for shape in joint.shapes:
        first = len(columns)
        for k, step in enumerate(shape.steps):
            values = shape.start.copy()
            values[k] += step
            column = joint.shape_column(shape, values) / step
            if np.any(column):
                columns.append(column)
        spans.append(slice(first, len(columns)))
    return Columns(joint.shapes, tuple(spans), np.stack(columns, axis=1) if columns else np.empty((joint.rows, 0)))


def side_by_side(one: Columns, two: Columns) -> Columns:
    """The columns of both, side by side."""
    shift = one.values.shape[1]
    moved = tuple(slice(s.start + shift, s.stop + shift) for s in two.spans)
    return Columns(one.effects + two.effects, one.spans + moved, np.hstack([one.values, two.values]))
