"""Effects of which there are many, as orders of waviness and places of bumps: prepared once, tried one at a time."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.inference.measurement.columns import Columns
from cadgen.inference.measurement.joint import Joint

Index = NDArray[np.intp]
# Share of a column's square that is left of it, less than which is rounding.
_HIDDEN = 1e-12


@dataclass(frozen=True)
class Alike:
    """Some of the numerous effects, k of them, that have the same number of columns.

    Attributes:
        effects: numbers of the effects, shape (k,).
        columns: columns of each, shape (k, width).
        products: products of these columns for every spectrum, shape (g, k, width, width).
        size: sizes of the columns, shape (g, k, width); infinite where nothing is left of one.
    """

    effects: Index
    columns: Index
    products: Array
    size: Array


class Numerous:
    """The many effects that enter one at a time: whitened once, with their products among their own columns."""

    def __init__(self, joint: Joint, columns: Columns) -> None:
        self.effects, self.spans = columns.effects, columns.spans
        self.white = joint.whiten(columns.values)
        self.halves = joint.halves(self.white)
        sorts = [(s.stop - s.start, bool(e.parts)) for e, s in zip(self.effects, self.spans, strict=True)]
        self.groups = [
            self._alike(sort[0], np.array([i for i, s in enumerate(sorts) if s == sort], dtype=np.intp))
            for sort in sorted(set(sorts))
        ]

    def _alike(self, width: int, which: Index) -> Alike:
        """Effects by their numbers, each of which has so many columns."""
        columns = np.array([self.spans[i].start for i in which], dtype=np.intp)[:, None] + np.arange(width)
        own = np.einsum("nki,nkj->kij", self.white[:, columns], self.white[:, columns])
        taken = np.einsum("gqki,gqkj->gkij", self.halves[:, :, columns], self.halves[:, :, columns])
        whole = np.einsum("kii->ki", own)
        left = np.maximum(whole - np.einsum("gkii->gki", taken), 0.0)
        # What the discrepancy hides but for rounding is of no size that anything could be measured against.
        size = np.where(left > _HIDDEN * whole, np.sqrt(left), np.inf)
        return Alike(which, columns, own - taken, size)
