"""A slice of the study `motions`: nothing is wrong with its first cases."""

import pytest

from tests.studies.motions import judged


@pytest.mark.study
def test_the_first_motions_of_the_study():
    rows = [judged(1, number) for number in range(12)]
    assert [row["wrong"] for row in rows if row["wrong"]] == []
