"""Worst end of the run over the band of play, of the profile that is cut, by the exact chain."""

from math import degrees

from cadgen.jobs.cam.plan import comparison_of
from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure


def _distance(evaluated: Evaluated) -> float:
    return comparison_of(evaluated.plan).chosen.band.worst_distance


def _heading(evaluated: Evaluated) -> float:
    return degrees(comparison_of(evaluated.plan).chosen.band.worst_heading)


WORST_END = Figure(
    code="worst_end_mm",
    meaning="worst position error at the end over the band of play",
    of=_distance,
    resolution=0.1,
)
WORST_HEADING = Figure(
    code="worst_end_heading_deg",
    meaning="worst heading error at the end over the band of play",
    of=_heading,
    resolution=1e-3,
)
