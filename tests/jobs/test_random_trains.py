"""A slice of the study of random trains and searches; the whole is recorded in studies/trains.md."""

import pytest

from tests.studies.trains import run


@pytest.mark.slow
@pytest.mark.long
def test_random_trains_and_searches_are_as_the_study_has_them():
    found = run(seed=20, cases=8, workers=1)
    print(*found, sep="\n")
    assert [(number, fault) for number, _, fault in found if fault] == []
    assert sum(kind == "passed" for _, kind, _ in found) >= 3
