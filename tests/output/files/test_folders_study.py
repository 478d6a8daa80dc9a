"""A slice of the study of concurrent and killed runs."""

import os

import pytest

from tests.studies.folders import case, scale

CASES = 6


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.study
@pytest.mark.skipif(os.name != "posix", reason="runs are forked")
def test_the_manifest_is_true_after_concurrent_and_killed_runs():
    size = scale(commands=False)
    assert 25 < size[0] < 100  # operations before each of which a run may be killed
    assert {n: wrong for n in range(CASES) if (wrong := case(1, n, size)[1])} == {}
