"""Margins that the planner keeps after the exact chain has failed a check."""

from math import radians, tan

import pytest

from cadgen.car.planner.path_task import Margins
from cadgen.check import Bound, Check, CheckCode


def test_a_steering_angle_that_fails_asks_for_wider_turns():
    """A drawn course is driven at its least spacing too, where a turn of the same track is tighter."""
    failed = Check(CheckCode.STEERING_ANGLE, "steering angle", 36.0, "°", 35.0, Bound.MAX)
    turn = Margins().after([failed]).turn
    assert 0.95 * tan(radians(35.0)) < turn * tan(radians(36.0)) < tan(radians(35.0))
    assert Margins(turn=0.9).larger(Margins(turn=turn)).turn == 0.9
    assert Margins(turn=0.9).after([failed]).turn == pytest.approx(0.9 * turn)
