"""Which branch is the lowest: real crossings where they are, rounding nowhere."""

import numpy as np
import pytest

from cadgen.cam.lowest import SAME, Run, lowest_branches

NOISE = np.random.default_rng(5).normal(size=(2, 600)) * 1e-14


def test_real_crossings_stay_where_the_least_changes():
    x = np.linspace(0, 2 * np.pi, 600, endpoint=False)
    radii = np.stack([60 + np.sin(3 * x), np.full(600, 60.2)]) + NOISE
    owner = np.argmin(radii, axis=0)
    changes = np.flatnonzero(owner != np.roll(owner, 1))
    assert lowest_branches(radii, {}) == [Run(int(cell), int(owner[cell])) for cell in changes]


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
    assert runs == [Run(0, 0), Run(300, 1)] or len(runs) == 1


@pytest.mark.parametrize("depth", [SAME / 2, SAME * 2])
def test_only_what_is_deeper_than_the_tolerance_counts(depth):
    radii = np.full((2, 600), 60.0)
    radii[1] += 1e-3
    radii[1, 100:120] = 60.0 - depth
    assert len(lowest_branches(radii, {})) == (1 if depth < SAME else 2)
