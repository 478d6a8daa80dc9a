"""A slice of the study of random courses: planned, checked, and clear by a sweep that shares no code with it."""

import pytest

from tests.studies.courses import case, planned


@pytest.mark.slow
@pytest.mark.parametrize("number", [3, 34])
def test_a_random_course_is_planned(number):
    # On number 34 the simplex turned in circles without end.
    _, right, words, seconds = planned(case(1, number))
    print(f"{words}; {seconds:.0f} s")
    assert right, words
