"""From a design's text to what the page shows, as the bytes that it gets."""

import json
from dataclasses import replace
from pathlib import Path

from cadgen.design.load import complete_of
from cadgen.design.schema import Design, MotionDesign, TrainDesign
from cadgen.errors import CadgenError
from cadgen.gears.choices import Order
from cadgen.jobs.gears.gear_train import GearTrain, plan_gears
from cadgen.messages import Message
from cadgen.output.files.manifest import Origin
from cadgen.progress import Progress
from cadgen.viewer.editor.course_items import points_of
from cadgen.viewer.editor.job import AnswerState, Job, JobStage, Result, refusal
from cadgen.viewer.page.car_page import plan_edited, plan_preview
from cadgen.viewer.page.data import data_of
from cadgen.viewer.page.html import floor_html, pieces_of
from cadgen.viewer.page.page_plan import PagePlan, plan_edited_motion
from cadgen.viewer.page.report import page_of
from cadgen.viewer.page.scene import floor_of

# Of a preview: the tables and the figures at the top wait for the whole.
_PREVIEWED = ("cam-box", "cam-legend", "course-box", "legend", "charts")
_LEVEL = 1  # of the compression: it goes no further than to this machine's own browser
# Sections of a design that its gears do not depend on.
_NOT_GEARS = {
    "path",
    "course",
    "field",
    "car",
    "cam",
    "follower",
    "machining",
    "checks",
    "drawing",
    "settings",
    "motion",
    "dynamics",
}


def compute(job: Job, progress: Progress) -> Result:
    """Compute a version, and lay it out as HTML and data.

    Args:
        job: version and stage.
        progress: function that is called before each step; an exception of its own ends the computation.
    """
    design: Design | MotionDesign | None = None
    try:
        design = complete_of(job.text, Path(job.file))
        plan: PagePlan
        if isinstance(design, MotionDesign):
            plan = plan_edited_motion(design, gears_of, progress, preview=job.stage == JobStage.PREVIEW)
        elif job.stage == JobStage.PREVIEW:
            plan = plan_preview(design, progress)
        else:
            plan = plan_edited(design, gears_of, progress)
        progress(Message("laying the page out"))
        return Result(AnswerState.DONE, _laid_out(job, plan, progress))
    except CadgenError as error:
        # A design that cannot be driven is shown by its course alone, so that its points can be moved.
        floor = None
        if isinstance(design, Design):
            floor = floor_html(floor_of(design), [(point.x, point.y) for point in points_of(design)])
        return refusal(AnswerState.REFUSED, error.message, floor=floor)
    except MemoryError:
        return refusal(AnswerState.FAULT, Message("out of memory: close other programs, or take the last change back"))


def _laid_out(job: Job, plan: PagePlan, progress: Progress) -> bytes:
    page = page_of(plan)
    progress(Message("writing the page"))
    document, block = data_of(page, _LEVEL)
    pieces = pieces_of(page)
    if job.stage == JobStage.PREVIEW:
        pieces = {code: pieces[code] for code in _PREVIEWED if code in pieces}
    head = json.dumps(
        {"revision": job.revision, "stage": job.stage, "pieces": pieces, "block": block}, ensure_ascii=False
    )
    return f'{head[:-1]}, "document": {document}}}'.encode()


_MOST_TRAINS = 8
_trains: dict[str, GearTrain] = {}  # by the values that they depend on


def gears_of(design: TrainDesign, order: Order, progress: Progress) -> GearTrain:
    """The train of a design; that of the version before, if nothing of it has changed."""
    values = {key: value for key, value in design.values().items() if key not in _NOT_GEARS}
    key = json.dumps([values, order], sort_keys=True)
    train = _trains.pop(key, None) or plan_gears(design, order, progress)
    _trains[key] = train
    if len(_trains) > _MOST_TRAINS:
        del _trains[next(iter(_trains))]  # the one that was asked for longest ago
    return replace(train, origin=Origin.of(design), title=design.drawing)
