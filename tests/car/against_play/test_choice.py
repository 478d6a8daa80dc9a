"""The choice among profiles under limits."""

import numpy as np
import pytest

from cadgen.car.against_play.evaluate import FigureLimit, ProfileCandidate, choose
from cadgen.check import CheckCode
from cadgen.errors import CheckError

LIMITS = (
    FigureLimit(figure="position error", most=50.0, unit="mm", code=CheckCode.END_POSITION_WITH_PLAY, key="a"),
    FigureLimit(figure="path deviation", most=20.0, unit="mm", code=CheckCode.RUN_POSITION_WITH_PLAY, key="b"),
)


def candidate(name, position, deviation):
    return ProfileCandidate(name=name, figures={"position error": position, "path deviation": deviation})


def test_the_least_of_those_that_keep_the_limits_is_chosen():
    choice = choose(
        [candidate("actual", 40.0, 0.0), candidate("smoothed", 5.0, 30.0), candidate("compensated", 8.0, 1.0)],
        LIMITS,
        objective="position error",
        unit="mm",
    )
    assert choice.best.name == "compensated"
    assert choice.reasons == (
        "actual not chosen: its position error is 40 mm",
        "smoothed refused: it has a path deviation of 30 mm, 10 mm more than the 20 allowed",
        "compensated chosen: the least position error, 8 mm, of 2 that keep every limit",
    )


def test_names_the_limit_that_binds_and_by_how_much():
    with pytest.raises(
        CheckError, match="the nearest, compensated, has a position error of 60 mm, 10 mm more than the 50"
    ):
        choose(
            [candidate("smoothed", 10.0, 200.0), candidate("compensated", 60.0, 1.0), candidate("bad", np.nan, 0.0)],
            LIMITS,
            objective="position error",
            unit="mm",
        )


def test_a_figure_that_is_no_number_keeps_no_limit():
    with pytest.raises(CheckError, match="the nearest, bad"):
        choose([candidate("bad", float("nan"), 0.0)], LIMITS, objective="position error", unit="mm")
