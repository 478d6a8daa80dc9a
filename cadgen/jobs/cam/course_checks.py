"""Checks of a design's course: of the planned run, and of the worst with play."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from cadgen.aside import Aside
from cadgen.car.running.mechanics import Mechanics
from cadgen.check import Bound, Check
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.course import OnCourse

_Case = tuple[float, Mechanics | None]  # return error, rad, and friction and drag


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
    half = (len(cases) + 1) // 2
    with Aside(partial(_of_runs, on, comparison, cases[half:])) as beside:
        checks = [*_of_runs(on, comparison, cases[:half]), *beside.result()]
    worst: dict[str, Check] = {}
    for check in checks:
        known = worst.get(check.code)
        if known is None or _worse(check, known):
            worst[check.code] = check
    return tuple(worst.values())


def _of_runs(on: OnCourse, comparison: PlayComparison, cases: Sequence[_Case]) -> list[Check]:
    """Checks of the runs of the chosen profile in some cases, one run after the other."""
    return [check for play, mechanics in cases for check in on.played(comparison, play, mechanics).checks()]


def _worse(check: Check, other: Check) -> bool:
    return check.value > other.value if check.bound == Bound.MAX else check.value < other.value
