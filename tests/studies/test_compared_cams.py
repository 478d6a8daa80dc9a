"""A slice of the study of what differs in measured cams."""

from tests.studies import compared_cams


def test_a_slice_of_the_study_keeps_its_bars() -> None:
    for key in compared_cams.keys(84, 5)[::17]:
        case = compared_cams.judged(*key)
        if case["sort"] == compared_cams.TOLERANCE:
            assert {compared_cams.row_of(row) for row in case["rows"]} <= {"within 2 %", "second order"}
        else:
            assert compared_cams.verdict(case) not in ("wrong", "refused")
            assert compared_cams.sized(case)
