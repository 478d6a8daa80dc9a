"""A slice of the study of tight courses: the witness passes every check, and the planner finds a path, too."""

import pytest

from tests.studies.tight_courses import outcome


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.study
@pytest.mark.parametrize("number", [1, 38, 42])
def test_a_tight_course_is_planned(number):
    """Course 38 leads below a gap that is just too narrow; 42 leads in a loop round posts far from its gates."""
    _, state, words, seconds = outcome(1, number)
    print(f"{words}; {seconds:.0f} s")
    assert state == "planned", words
