"""Which branch is the lowest: real crossings where they are, rounding nowhere."""

import numpy as np
import pytest

from cadgen.cam import lower_hull
from cadgen.cam.lower_hull import SAME, LowestRun, Radii, Reach

NOISE = np.random.default_rng(5).normal(size=(2, 600)) * 1e-14


def lowest_branches(table, continuation):
    """The same for a table of radii, one row for each branch, infinite where it does not reach."""
    rows = [Reach.of(np.flatnonzero(np.isfinite(row)), row[np.isfinite(row)]) for row in table]
    return lower_hull.lowest_branches(Radii(rows, table.shape[1]), continuation)


def test_real_crossings_stay_where_the_least_changes():
    x = np.linspace(0, 2 * np.pi, 600, endpoint=False)
    radii = np.stack([60 + np.sin(3 * x), np.full(600, 60.2)]) + NOISE
    owner = np.argmin(radii, axis=0)
    changes = np.flatnonzero(owner != np.roll(owner, 1))
    assert lowest_branches(radii, {}) == [LowestRun(int(cell), int(owner[cell])) for cell in changes]


def test_branches_that_coincide_are_one():
    assert len(lowest_branches(60 + NOISE, {})) == 1


def test_a_dwell_has_one_hand_over_beside_it():
    """Both coincide over a third, then the second one is lower, then the first."""
    x = np.arange(600)
    lower = np.where((x > 200) & (x < 350), 1e-3, np.where(x >= 350, -1e-3, 0.0))
    runs = lowest_branches(np.stack([np.full(600, 60.0), 60 - lower]) + NOISE, {})
    assert [run.branch for run in runs] == [1, 0]
    assert runs[0].cell <= 201
    assert runs[1].cell == 350


def test_a_branch_that_ends_is_followed_by_its_own_face():
    """The first face comes in two parts; where it ends the second face is lower by rounding only."""
    radii = np.full((3, 600), np.inf)
    radii[0, :300], radii[1, 300:], radii[2] = 60.0, 60.0, 60.0 - SAME / 2
    runs = lowest_branches(radii, {0: 1, 1: 0})
    assert runs == [LowestRun(0, 0), LowestRun(300, 1)] or len(runs) == 1


@pytest.mark.parametrize("depth", [SAME / 2, SAME * 2])
def test_only_what_is_deeper_than_the_tolerance_counts(depth):
    radii = np.full((2, 600), 60.0)
    radii[1] += 1e-3
    radii[1, 100:120] = 60.0 - depth
    assert len(lowest_branches(radii, {})) == (1 if depth < SAME else 2)


@pytest.mark.slow
def test_thousands_of_short_branches_take_little_memory():
    """One branch in every two cells, the first of them over the seam, and one that lies above them all."""
    count = 40_000
    reaches = [Reach.of(np.sort(np.array([2 * k - 1, 2 * k]) % count), np.full(2, 60.0)) for k in range(count // 2)]
    radii = Radii([*reaches, Reach(0, np.full(count, 61.0))], count)
    assert (radii.least == 60.0).all()
    assert (radii.second == 61.0).all()
    np.testing.assert_array_equal(radii.owner[:5], [0, 1, 1, 2, 2])
    assert radii.at(0, -1) == radii.at(0, count) == 60.0
    assert radii.at(0, 1) == np.inf
    np.testing.assert_array_equal(np.flatnonzero(np.isfinite(radii.of(0))), [0, count - 1])
