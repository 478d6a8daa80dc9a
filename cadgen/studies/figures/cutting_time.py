"""Time that the programs for the mill move at a feed: cuts, leads, plunges, tabs and drills, by their own moves."""

from cadgen.output.files.nc import drilling_minutes, milling_minutes
from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure


def _minutes(evaluated: Evaluated) -> float:
    plan = evaluated.plan
    machining, (inner, outer), material = plan.design.machining, plan.design.cam.faces_mm, plan.design.blank.material
    milled = milling_minutes(plan.curve.length(), machining, outer - inner, material)
    return milled + drilling_minutes(plan.made_blank, machining, outer - inner, material)


CUTTING_TIME = Figure(
    code="cutting_time_min",
    meaning="time that the programs for the mill move at a feed",
    of=_minutes,
    resolution=0.01,
)
