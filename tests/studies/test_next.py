"""How the study of what to measure next counts."""

from dataclasses import replace

from tests.studies.next import Outcome, page

CAR = Outcome(1, "track", "play", "traced", 100.0, {"lift": 20.0, "train": 30.0}, {"lift": 25.0, "train": 22.0})


def test_the_first_is_right_within_a_tenth_of_the_best():
    assert CAR.right
    assert not replace(CAR, found={"lift": 40.0, "train": 22.0}).right


def test_where_nothing_is_worth_making_that_must_be_said():
    idle = replace(CAR, found={"lift": 99.0, "train": 98.0})
    assert idle.right  # the first is as idle as the others
    assert not replace(CAR, found={"lift": 110.0, "train": 98.0}).right
    said = replace(idle, expected={"lift": 99.0, "train": 99.0}, found={"lift": 110.0, "train": 98.0})
    assert said.right
    assert "| cars | 2 |" in page([CAR, idle], "a command")
