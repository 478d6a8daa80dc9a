"""A slice of the study of play on lifts with plateaus, ripples and short rises."""

import pytest

from tests.studies.play import CLOSING_LIMIT, MOTION_LIMIT, judge


@pytest.mark.parametrize("number", range(10))
def test_motion_and_compensation_agree_with_brute_force(number):
    found = judge(9, number)
    print(f"motion {found.motion:.1e}, closing {found.closing:.1e} rad, {found.plain:.1e} without compensation")
    assert not found.fault
    assert found.motion < MOTION_LIMIT
    assert found.closing < CLOSING_LIMIT
