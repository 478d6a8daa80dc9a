"""Time that the cutter is in the cut along the outline, at the feed of [machining]; rapid and plunging moves apart."""

from math import ceil

from cadgen.arrays import TURN
from cadgen.exploration.figures.evaluated import Evaluated
from cadgen.exploration.figures.figure import Figure

_ROUNDING = 1e-9


def _minutes(evaluated: Evaluated) -> float:
    """Passes times the length of the cutter's path: an offset by r of a closed curve is longer by 2 pi r (Steiner)."""
    plan = evaluated.plan
    machining, (inner, outer) = plan.design.machining, plan.design.cam.faces_mm
    feed = machining.feed(plan.design.blank.material)
    passes = ceil((outer - inner + machining.break_through_mm) / machining.step_down_mm - _ROUNDING)
    length = plan.curve.length() + TURN * machining.cutter_diameter_mm / 2
    return passes * length / feed


CUTTING_TIME = Figure(
    code="cutting_time_min",
    meaning="time in the cut along the outline, milled",
    of=_minutes,
    resolution=0.01,
)
