"""A slice of the study of tight courses: the witness passes every check, and the planner finds a path, too."""

import pytest

from tests.studies.tight_courses import outcome


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.study
def test_a_tight_course_is_planned():
    _, state, words, seconds = outcome(1, 1)
    print(f"{words}; {seconds:.0f} s")
    assert state == "planned", words
