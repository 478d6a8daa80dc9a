"""Limit of the lift error: what the old cam misses by more does not refuse a new one."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.car.against_play.evaluate import FigureLimit
from cadgen.check import CheckCode
from cadgen.jobs.cam.comparison import LIFT_ERROR, ProfileChecks, _lift_check, _lifted

LIMITS = (
    FigureLimit(figure="on the run", most=5.0, unit="mm", code=CheckCode.RUN_POSITION_WITH_PLAY, key="a"),
    FigureLimit(figure=LIFT_ERROR, most=50.0, unit="µm", code=CheckCode.LIFT_ERROR_WITH_PLAY, key="b"),
)


def cam(micrometres):
    return SimpleNamespace(worst_lift_error=micrometres / 1e3)


@pytest.mark.parametrize(
    ("old", "profiles", "most"),
    [
        (300.0, (114.0, 263.0), 300.0),  # no profile keeps it, and the old cam misses more
        (300.0, (49.0, 263.0), 50.0),  # one keeps it
        (100.0, (114.0, 263.0), 50.0),  # the old cam is better
    ],
)
def test_limit_of_the_lift_error_on_a_car_that_was_measured(old, profiles, most):
    limits, words = _lifted(LIMITS, cam(old), [cam(each) for each in profiles])
    assert limits == (LIMITS[0], replace(LIMITS[1], most=most))
    assert bool(words) == (most > 50.0)
    assert all("114 µm at least" in sentence and "300 µm on this car" in sentence for sentence in words)


def test_checks_go_by_the_raised_limit_too():
    """A limit that the choice raises and the check does not would refuse the cam all the same."""
    evaluation = SimpleNamespace(
        run=SimpleNamespace(motor=np.array([0.0, 1.0])),
        lift_error=np.array([0.0, 0.114]),
        worst_lift_error=0.114,
        play=0.01,
    )
    assert not _lift_check(evaluation, 50.0).passed
    assert _lift_check(evaluation, 300.0).passed
    checks = ProfileChecks(SimpleNamespace(optimize=SimpleNamespace(max_lift_error_um=50.0)), None)
    checks._computed["a"] = ()
    checks.allow_lift_error(300.0)
    assert checks._allowed == [300.0]
    assert not checks._computed
