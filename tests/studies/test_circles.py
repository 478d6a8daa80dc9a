"""A slice of the study of circles: a car with three effects, by its track and its train; figures by a fixed seed."""

import pytest

from tests.studies.circles import go_round, page

SEED, NUMBER = 11, 5


@pytest.mark.slow
@pytest.mark.long
def test_a_car_comes_home_on_the_cam_made_for_two_records():
    outcome = go_round(SEED, NUMBER)
    print(f"{outcome.before:.0f} mm before, {outcome.after:.1f} mm after, {outcome.expected:.1f} mm expected")
    assert outcome.claimed == "backlash, steering zero, wheel radius"
    assert outcome.before > 1000
    assert outcome.gone > 0.99
    assert not outcome.refused
    assert "| error gone, median | 99.8" in page([outcome], "a command")
