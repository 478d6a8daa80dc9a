"""Yield: share of random cars within the tolerances that pass every gate and keep the course."""

from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure


def _passed(evaluated: Evaluated) -> float:
    return 100 * evaluated.tolerance.passed


PASSED = Figure(code="passed_percent", meaning="share of random cars that keep the course", of=_passed, more=True)
