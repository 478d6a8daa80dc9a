"""Checks of a design's course: of the planned run, and of the worst with play."""

import numpy as np

from cadgen.car.running.mechanics import Mechanics
from cadgen.check import Bound, Check
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.course import OnCourse


def course_checks(on: OnCourse | None, comparison: PlayComparison | None = None) -> tuple[Check, ...]:
    """Checks of the planned run, and of the worst over the band of play if the profile was compared under play.

    Args:
        on: course with the car that is to keep it; None without a course.
        comparison: comparison of the profiles under play, if there was one.

    Raises:
        DesignError: no car can keep the course.
    """
    if on is None:
        return ()
    checks = on.planned.checks()
    return checks if comparison is None else (*checks, *play_checks(on, comparison))


def play_checks(on: OnCourse, comparison: PlayComparison) -> tuple[Check, ...]:
    """Checks of the worst run over the band of play, or with the measured play, and over friction and drag.

    Args:
        on: course with the car that is to keep it.
        comparison: comparison of the profiles under play.
    """
    task, measured = comparison.task, comparison.band.measured
    plays = comparison.chosen.band.plays if measured is None else np.array([measured])
    ends: tuple[Mechanics | None, ...] = task.mechanics.corners if task.mechanics else (None,)
    cases = [(play, end) for play in plays.tolist() for end in ends]
    worst: dict[str, Check] = {}
    for check in (check for play, end in cases for check in on.played(comparison, play, end).checks()):
        known = worst.get(check.code)
        if known is None or _worse(check, known):
            worst[check.code] = check
    return tuple(worst.values())


def _worse(check: Check, other: Check) -> bool:
    return check.value > other.value if check.bound == Bound.MAX else check.value < other.value
