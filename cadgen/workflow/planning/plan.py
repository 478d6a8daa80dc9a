"""A path planned, run through the exact chain with all its checks, and planned again with what they ask for."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from math import ceil, pi
from pathlib import Path

import numpy as np

from cadgen.build import cam_model, course_model, draw_model, gear_model
from cadgen.course.body import place_of
from cadgen.course.poses import Poses
from cadgen.course.refuse import refuse_course
from cadgen.design.load import design_of
from cadgen.design.planned import planned_text, rounded
from cadgen.design.schema import Design
from cadgen.draws.drawn import Drawn
from cadgen.errors import CheckError
from cadgen.path.track import Track
from cadgen.planner.gates import is_exact
from cadgen.planner.plan import Plan
from cadgen.planner.plan import plan as planned
from cadgen.planner.reasons import Reason, reasons
from cadgen.planner.reserve import Reserve
from cadgen.planner.task import Task
from cadgen.progress import Progress, silent
from cadgen.workflow.cam.plan import CamPlan, plan_cam
from cadgen.workflow.card.plan import card_of
from cadgen.workflow.planning.task import task_of

# Of plan and exact chain; most plans need one. More where other runs than the planned one must keep the course.
_ROUNDS, _MORE_ROUNDS = 5, 7
_SPACINGS = 5  # of a draw, at which a plan is driven
_WHEEL_STEP = 100  # parts of a millimetre in which a drive wheel's radius is chosen


@dataclass(frozen=True)
class Wanted:
    """Options of a plan besides its course.

    Attributes:
        near: track to stay near to; None for a plan from scratch.
        within: how far from it the drive wheel may be, mm.
        calm: track whose curvature's slopes are not to be exceeded; None without.
        seeds: number of searches; the best one counts.
        map_with: function like the built-in `map` that runs several searches.
    """

    near: Track | None = None
    within: float = 0.0
    calm: Track | None = None
    seeds: int = 1
    map_with: Callable[..., Iterable[Plan]] | None = None


@dataclass(frozen=True)
class PlannedPath:
    """A planned path, or the reasons why there is none.

    Attributes:
        design: design that was planned.
        task: what the planner was asked.
        plan: the planner's result.
        text: text of the design file with the path; empty if the course cannot be driven.
        cam: plan of the cam for the path with all checks; None if the course cannot be driven.
        reasons: why the course cannot be driven; empty if it can.
        failed: sentence on a limit of [optimize] that no profile keeps; empty if there is one.
        drawn: settings with which the path was driven at some of the spacings that can be drawn; empty without them.
    """

    design: Design
    task: Task
    plan: Plan
    text: str
    cam: CamPlan | None
    reasons: tuple[Reason, ...] = ()
    failed: str = ""
    drawn: tuple[Drawn, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether there is a path and all checks pass, at every spacing that was driven."""
        return self.cam is not None and self.cam.passed and not any(each.failed for each in self.drawn)

    @property
    def wheel_radius(self) -> float | None:
        """Radius of the drive wheel that the plan chose, mm; None if it was given or follows from the path."""
        return None if self.cam is None else _chosen_radius(self.design, self.task, self.plan)


def plan_design(
    design: Design, text: str, drawn: Track | None, wanted: Wanted, progress: Progress = silent
) -> PlannedPath:
    """Plan a path for a design.

    Args:
        design: loaded design; its own path counts only for what the course leaves out.
        text: text of its file.
        drawn: drive wheel's track of its own path; None if it has none.
        wanted: what the plan is asked for.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the design has no course or no start, or its values cannot be.
    """
    _refuse_course(design)
    rounds = _MORE_ROUNDS if design.course is not None and design.course.judged == "play" else _ROUNDS
    if course_model.draw(design) is not None:
        draw_model.settings(design)
        rounds = _MORE_ROUNDS
    reserve, begin = Reserve(), None
    for number in range(rounds):
        progress("planning the path" if number == 0 else "planning on with what the checks ask for")
        task = task_of(design, drawn=drawn, near=wanted.near, within=wanted.within, calm=wanted.calm, reserve=reserve)
        result = planned(
            task,
            seeds=wanted.seeds,
            begin=begin,
            report=lambda words: progress(f"planning the path: {words}"),
            map_with=wanted.map_with,
        )
        if result.missed:
            progress("looking for the reason")
            return PlannedPath(design, task, result, "", None, reasons(result))
        radius = _chosen_radius(design, task, result)
        written = planned_text(design, text, result.path.points, radius)
        progress("checking the planned cam")
        try:
            cam = plan_cam(design_of(written, Path(f"{design.name}.toml")), None, progress)
        except CheckError as error:
            return PlannedPath(design, task, result, "", None, (), str(error))
        settings = _settings(task, cam, progress)
        path = PlannedPath(design, task, result, written, cam, drawn=settings)
        more = reserve.after(cam.failed)
        for each in settings:
            more = more.larger(reserve.after(each.failed))
        if more == reserve:
            break
        reserve, begin = more, rounded(result.path.points)
    return path


def _settings(task: Task, cam: CamPlan, progress: Progress) -> tuple[Drawn, ...]:
    """Settings at the ends of what is drawn and between, if a spacing is drawn."""
    if task.draw is None:
        return ()
    draw_model.refuse_range(cam.design, task.draw, cam.track, cam_model.rod(cam.design, "a card of settings"))
    low, high = task.draw.spacings[0], task.draw.spacings[-1]
    few = replace(task.draw, spacings=tuple(np.linspace(low, high, _SPACINGS).tolist()))
    return card_of(cam, few, progress, tries=1).drawn


def _refuse_course(design: Design) -> None:
    """Refuse a course on which the car cannot stand at its start, where the course says how it stands there."""
    course, car = course_model.course(design), cam_model.car(design)
    start = None if course is None else course.start
    if course is None or start is None or start.heading is None or not is_exact(start):
        return
    ahead = np.exp(1j * start.heading)
    fork = complex(*start.place.points[0]) - complex(*place_of(start.point, car)) * ahead
    still = np.zeros(2)
    pose = Poses(fork=np.full(2, fork), heading=still + start.heading, steering=still, travel=still)
    refuse_course(course, course_model.body(design), pose)


def _chosen_radius(design: Design, task: Task, result: Plan) -> float | None:
    if task.vehicle.closed or task.vehicle.path_turn == 1.0:
        return None
    turn = result.path.cost.line.length / task.vehicle.path_turn
    least = turn / (2 * pi * float(gear_model.train(design).ratio))
    return ceil(least * _WHEEL_STEP + 1e-3) / _WHEEL_STEP
