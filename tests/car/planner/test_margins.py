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


def test_a_ridge_that_a_larger_radius_does_not_cure_asks_for_a_lower_step_of_the_blend():
    """It stands in the closing blend, on which the path acts by the step between its ends alone."""
    failed = Check(CheckCode.CONVEX_RADIUS_PROFILE, "convex radius, profile", 0.3, "mm", 0.5, Bound.MIN)
    once = Margins().after([failed])
    assert once.radius > 0
    assert once.blend == 0
    twice = once.after([failed])
    assert twice.radius > once.radius
    assert twice.blend == 1
    steep = Check(CheckCode.BLEND_PRESSURE_ANGLE_RISE, "pressure angle, blend rise", 80.0, "°", 75.0)
    assert Margins().after([steep, failed]).blend == Margins().after([failed, steep]).blend == 1
