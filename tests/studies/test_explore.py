"""Slices of the studies of `cadgen explore`."""

import pytest

from tests.studies.explore_kills import run
from tests.studies.explore_workers import Costs, drawn, efficiency, recorded


def test_the_simulation_in_cases_that_are_known():
    even = [1.0] * 4000
    assert efficiency(even, 10, Costs(0.0, 0.0)) == pytest.approx(1.0, abs=0.01)
    # One long design at the end, which all others wait for: 400 s of ten workers and then 100 s of one.
    assert efficiency([*even, 100.0], 10, Costs(0.0, 0.0)) == pytest.approx(4100 / (10 * 500), rel=0.02)
    # A main process that takes 0.5 s for each batch of 2 s serves four workers, and no more.
    slow = efficiency([2.0] * 400, 40, Costs(0.0, 0.5))
    assert slow == pytest.approx(4 / 40, rel=0.1)


def test_a_thousand_workers_are_kept_at_work_at_a_millisecond_a_batch():
    times = drawn(recorded(None), 50_000, 1)
    assert efficiency(times, 1000, Costs(1e-3, 1e-3)) > 0.9


@pytest.mark.slow
@pytest.mark.long
def test_killed_at_random_instants():
    assert [outcome.faults for outcome in run(1, 1)] == [[]]
