"""Which branch of the envelope is the lowest at each polar angle, with rounding kept out of the answer.

Branches that coincide over a stretch, as those of both faces do where the steering is straight, take turns at being
the lowest by rounding. A branch is therefore left only where another one is lower by more than `SAME`, and then at
the last place before that where the two cross.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from cadgen.arrays import Array

# mm; branches whose radii differ by no more than this are one. It is a tenth of what the splines of a STEP file may
# stray, and ten million times the rounding of a radius.
SAME = 1e-6


class Run(NamedTuple):
    """Neighbouring cells in which one branch is the lowest: the first cell and the branch, by number."""

    cell: int
    branch: int


def lowest_branches(radii: Array, continuation: Mapping[int, int]) -> list[Run]:
    """Walk once round the cells and return the runs of the lowest branches, by cell.

    Args:
        radii: radius of each branch in each cell, shape (branches, cells), mm; infinite where a branch does not reach.
        continuation: for a branch, the branch that begins where it ends; it is preferred to others that coincide
            with it.

    Returns:
        Runs in the order of their first cells, each from there to the next one's; a single one goes all round.
    """
    count = radii.shape[1]
    # From the cell whose lowest branch is the most beyond doubt, once round, and to that cell again.
    two = np.sort(radii, axis=0)[:2]
    start = 0
    if len(two) > 1:
        reached = np.isfinite(two[0])
        start = int(np.argmax(np.where(reached, two[1] - np.where(reached, two[0], 0.0), -np.inf)))
    around = (np.arange(count + 1) + start) % count
    radii = radii[:, around]
    owner = np.argmin(radii, axis=0)
    kept = radii <= radii.min(axis=0) + SAME
    runs = [Run(0, int(owner[0]))]
    while True:
        begin, branch = runs[-1]
        failing = np.flatnonzero(~kept[branch, begin:])
        if not failing.size:
            break
        cell = begin + int(failing[0])
        after = continuation.get(branch, branch)
        _take_over(runs, radii, Run(cell, after if kept[after, cell] else int(owner[cell])))
    if runs[-1].branch != runs[0].branch:
        _take_over(runs, radii, Run(count, runs[0].branch))
    # The first run is the end of the last one.
    changes = [Run(int(around[run.cell]), run.branch) for run in runs[1:]]
    return sorted(changes) or runs


def _take_over(runs: list[Run], radii: Array, run: Run) -> None:
    """Let a branch take over at a cell, or before it as far back as it is lower than what was there."""
    cell = run.cell
    while True:
        begin, before = runs[-1]
        while cell > max(begin, 1) and radii[run.branch, cell - 1] < radii[before, cell - 1]:
            cell -= 1
        if cell > begin or len(runs) == 1:
            break
        runs.pop()
    if runs[-1].branch != run.branch:
        runs.append(Run(cell, run.branch))
