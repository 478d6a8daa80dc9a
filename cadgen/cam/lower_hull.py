"""Which branch of the envelope is the lowest at each polar angle, with rounding kept out of the answer.

Branches that coincide over a stretch, as those of two planes may where the motion is level, take turns at being
the lowest by rounding. A branch is therefore left only where another one is lower by more than `SAME`, and then at
the last place before that where the two cross.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array

# mm; branches whose radii differ by no more than this are one. It is a tenth of what the splines of a STEP file may
# stray, and ten million times the rounding of a radius.
SAME = 1e-6


class LowestRun(NamedTuple):
    """Neighbouring cells in which one branch is the lowest: the first cell and the branch, by number."""

    cell: int
    branch: int


@dataclass(frozen=True, eq=False)
class Reach:
    """Radii of one branch in the neighbouring cells that it reaches, from cell `first` on round the turn, mm."""

    first: int
    radii: Array

    @classmethod
    def of(cls, cells: NDArray[np.intp], radii: Array) -> Self:
        """From the cells in rising order; those of a branch that goes over cell 0 have a gap.

        Args:
            cells: numbers of the cells, rising, shape (n,).
            radii: radius in each, mm, shape (n,).
        """
        gap = np.flatnonzero(np.diff(cells) > 1)
        turned = int(gap[0]) + 1 if gap.size else 0
        return cls(int(cells[turned]) if cells.size else 0, np.roll(radii, -turned))


class Radii:
    """Radii of all branches in all cells. Only those are kept that there are: thousands of branches are all short."""

    def __init__(self, reaches: Sequence[Reach], cells: int) -> None:
        self.cells, self._reaches = cells, reaches
        cell = np.concatenate([(one.first + np.arange(one.radii.size)) % cells for one in reaches])
        branch = np.repeat(np.arange(len(reaches)), [one.radii.size for one in reaches])
        radius = np.concatenate([one.radii for one in reaches])
        # Of equal radii in a cell that of the first branch comes first.
        rows = np.lexsort((branch, radius, cell))
        cell, branch, radius = cell[rows], branch[rows], radius[rows]
        leads = np.flatnonzero(np.diff(cell, prepend=-1))
        self.owner = np.zeros(cells, dtype=np.intp)
        self.least, self.second = np.full((2, cells), np.inf)
        self.owner[cell[leads]], self.least[cell[leads]] = branch[leads], radius[leads]
        later = leads[np.diff(leads, append=cell.size) > 1] + 1
        self.second[cell[later]] = radius[later]

    def at(self, branch: int, cell: int) -> float:
        """Radius of a branch in a cell, counted round the turn; infinite where it does not reach."""
        one = self._reaches[branch]
        along = (cell - one.first) % self.cells
        return float(one.radii[along]) if along < one.radii.size else np.inf

    def of(self, branch: int) -> Array:
        """Radii of a branch in all cells."""
        one, row = self._reaches[branch], np.full(self.cells, np.inf)
        row[(one.first + np.arange(one.radii.size)) % self.cells] = one.radii
        return row


def lowest_branches(radii: Radii, continuation: Mapping[int, int]) -> list[LowestRun]:
    """Walk once round the cells and return the runs of the lowest branches, by cell.

    Args:
        radii: polar radii of the branches in the cells, mm.
        continuation: for a branch, the branch that begins where it ends; it is preferred to others that coincide
            with it.

    Returns:
        Runs in the order of their first cells, each from there to the next one's; a single one goes all round.
    """
    count = radii.cells
    # From the cell whose lowest branch is the most beyond doubt, once round, and to that cell again.
    reached = np.isfinite(radii.least)
    start = int(np.argmax(np.where(reached, radii.second - np.where(reached, radii.least, 0.0), -np.inf)))
    around = (np.arange(count + 1) + start) % count
    owner, most = radii.owner[around], radii.least[around] + SAME
    runs = [LowestRun(0, int(owner[0]))]
    while True:
        begin, branch = runs[-1]
        failing = radii.of(branch)[around[begin:]] > most[begin:]
        if not failing.any():
            break
        cell = begin + int(np.argmax(failing))
        after = continuation.get(branch, branch)
        keeps = radii.at(after, cell + start) <= most[cell]
        _take_over(runs, radii, start, LowestRun(cell, after if keeps else int(owner[cell])))
    if runs[-1].branch != runs[0].branch:
        _take_over(runs, radii, start, LowestRun(count, runs[0].branch))
    # The first run is the end of the last one.
    changes = [LowestRun(int(around[run.cell]), run.branch) for run in runs[1:]]
    return sorted(changes) or runs


def _take_over(runs: list[LowestRun], radii: Radii, start: int, run: LowestRun) -> None:
    """Let a branch take over at a cell, or before it as far back as it is lower than what was there.

    The runs' cells are counted from the cell `start`.
    """
    cell = run.cell
    while True:
        begin, before = runs[-1]
        while cell > max(begin, 1) and radii.at(run.branch, cell - 1 + start) < radii.at(before, cell - 1 + start):
            cell -= 1
        if cell > begin or len(runs) == 1:
            break
        runs.pop()
    if runs[-1].branch != run.branch:
        runs.append(LowestRun(cell, run.branch))
