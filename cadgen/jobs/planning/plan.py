"""A path planned, run through the exact chain with all its checks, and planned again with what they ask for.

Of several such paths, with more and more room at gates and obstacles, the one is kept that most cars drive (`cars`).
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from math import ceil, pi
from pathlib import Path

import numpy as np

from cadgen.arrays import Array
from cadgen.car.course.body import RunPoses, place_of
from cadgen.car.course.layout import Judged
from cadgen.car.course.refuse import refuse_course
from cadgen.car.draws.drawn_spacing import DrawnSpacing
from cadgen.car.path.wheel_track import Track
from cadgen.car.planner.path_plan import PathPlan, reasons
from cadgen.car.planner.path_plan import best_plan as planned
from cadgen.car.planner.path_task import Margins, PathTask
from cadgen.check import failing
from cadgen.design import cam_model, draw_model, gear_model
from cadgen.design.course import body_of, layout_of, spacings_of
from cadgen.design.load import design_of
from cadgen.design.planned import planned_text, rounded
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import CarUse, plan_cam
from cadgen.jobs.card import card_of
from cadgen.jobs.planning.cars import ALL, REFINED, Tried, best, cars_on, saturated, tried
from cadgen.jobs.planning.path_planning import PathPlanning
from cadgen.jobs.planning.task import task_of
from cadgen.messages import Message
from cadgen.progress import Progress, silent

# Of plan and exact chain; most plans need one. More where other runs than the planned one must keep the course.
_ROUNDS, _MORE_ROUNDS = 5, 7
_SPACINGS = 5  # of a draw, at which a plan is driven
_NARROW = 0.2  # share of the range of spacings that a draw's path is begun from where need be
_WHEEL_STEP = 100  # parts of a millimetre in which a drive wheel's radius is chosen


@dataclass(frozen=True)
class PlanRequest:
    """Options of a plan besides its course.

    Attributes:
        near: track to stay near to; None for a plan from scratch.
        within: how far from it the drive wheel may be, mm.
        calm: track whose curvature's slopes are not to be exceeded; None without.
        seeds: number of searches; the best one counts.
        map_with: function like the built-in `map` that runs several searches.
        replaced: design with the path that the plan takes the place of; None without.
        reserve: room at gates and obstacles besides their margins, as a factor on the scatter of cars; None to choose
            it by the share of the cars that keep the course.
    """

    near: Track | None = None
    within: float = 0.0
    calm: Track | None = None
    seeds: int = 1
    map_with: Callable[..., Iterable[PathPlan]] | None = None
    replaced: Design | None = None
    reserve: float | None = None


@dataclass(frozen=True)
class _Asked:
    """Everything that a path is planned for; arguments of `plan_design`."""

    design: Design
    text: str
    drawn: Track | None
    wanted: PlanRequest
    progress: Progress


def plan_design(
    design: Design, text: str, drawn: Track | None, wanted: PlanRequest, progress: Progress = silent
) -> PathPlanning:
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
    asked = _Asked(design, text, drawn, wanted, progress)
    path = _planned(asked, Margins())
    if not path.sound or path.cam is None:
        return _explained(asked, path)
    try:
        first = tried(path.cam, 0.0)
    except DesignError as error:
        return replace(path, no_cars=error.message)
    if first is None:
        return path
    return _chosen(asked, path, path.cam, first)


def _chosen(asked: _Asked, path: PathPlanning, cam: CamPlan, cars: Tried) -> PathPlanning:
    """The path that most cars keep the course on, of one without room for their scatter and others with more and more.

    Args:
        asked: what a path is planned for.
        path: the first, without such room.
        cam: its cam.
        cars: cars on it.
    """
    wanted, found = asked.wanted, [(path, cam, cars)]
    factors = REFINED if cars.kept < ALL else ()
    if wanted.reserve is not None:
        factors = (wanted.reserve,) if wanted.reserve > 0 else ()
    for factor in factors:
        asked.progress(Message("planning with room for {factor:g} times the scatter of the cars", factor=factor))
        last, _, known = found[-1]
        path = _planned(asked, last.kept, known.spare(factor), rounded(last.plan.path.points))
        more = None if path.cam is None or not path.sound else tried(path.cam, factor)
        if path.cam is not None and more is not None:
            found.append((path, path.cam, more))
        elif wanted.reserve is not None:
            return _explained(asked, path)
        else:  # more room than this there is not
            break
        if wanted.reserve is None and saturated([each for _, _, each in found]):
            break
    every = [cars for _, _, cars in found]
    number = best(every) if wanted.reserve is None else len(found) - 1
    path, cam, _ = found[number]
    return replace(path, cars=cars_on(cam, wanted.replaced, every, number, asked.progress))


def _planned(
    asked: _Asked, tightening: Margins, spare: Mapping[str, float] | None = None, begin: Array | None = None
) -> PathPlanning:
    """Plan a path, with what its checks ask for.

    Where a course is drawn and the path from scratch cannot be set for all its spacings, the search is begun from the
    path of a narrow range about the stated spacing.

    Args:
        asked: what it is planned for.
        tightening: kept from the limits from the beginning.
        spare: distance to keep besides where it costs little, by the keys of gates and obstacles, mm.
        begin: control points to go on from, shape (n, 2), mm; None to plan from scratch.
    """
    path = _kept_by_checks(asked, tightening, spare, begin)
    if not path.sound and path.task.draw is not None and begin is None:
        asked.progress("planning from a narrower range of spacings")
        wanted = asked.wanted
        narrow = task_of(
            asked.design, drawn=asked.drawn, near=wanted.near, within=wanted.within, calm=wanted.calm,
            tightening=tightening, drawn_share=_NARROW,
        )  # fmt: skip
        middle = planned(replace(narrow, spare=spare or {}), seeds=wanted.seeds, map_with=wanted.map_with)
        if not middle.missed:
            other = _kept_by_checks(asked, tightening, spare, rounded(middle.path.points))
            path = other if other.sound else path
    return path


def _explained(asked: _Asked, path: PathPlanning) -> PathPlanning:
    """A path with the reasons why it keeps not all limits."""
    if not path.plan.missed:
        return path
    asked.progress("looking for the reason")
    return replace(path, reasons=reasons(path.plan))


def _kept_by_checks(
    asked: _Asked, tightening: Margins, spare: Mapping[str, float] | None, begin: Array | None
) -> PathPlanning:
    """Plan a path, as often as its checks ask for more; arguments as of `_planned`.

    What a path misses that its course alone does not ask for is no reason against the course: where such a search
    fails, the last path stays, with the checks that it fails.
    """
    design, wanted, progress = asked.design, asked.wanted, asked.progress
    rounds = _MORE_ROUNDS if design.course is not None and design.course.judged == Judged.PLAY else _ROUNDS
    if (draw := spacings_of(design.course)) is not None:
        draw_model.refuse_range(design, draw, None, cam_model.leaning(design, "a card of settings"))
        rounds = _MORE_ROUNDS
    path: PathPlanning | None = None
    good: PathPlanning | None = None  # the last one that passes
    for number in range(rounds):
        progress("planning the path" if number == 0 else "planning on with what the checks ask for")
        task = task_of(
            design, drawn=asked.drawn, near=wanted.near, within=wanted.within, calm=wanted.calm, tightening=tightening
        )
        task = replace(task, spare=spare or {})
        result = planned(
            task,
            seeds=wanted.seeds,
            begin=begin,
            report=lambda words: progress(Message("planning the path: {words}", words=words)),
            map_with=wanted.map_with,
        )
        if result.missed:
            return good or path or PathPlanning(asked=design, task=task, plan=result, text="", cam=None)
        radius = None
        if not task.vehicle.closed and task.vehicle.path_turn != 1.0:
            turn = result.path.cost.line.length / task.vehicle.path_turn
            least = turn / (2 * pi * float(gear_model.train(design).ratio))
            radius = ceil(least * _WHEEL_STEP + 1e-3) / _WHEEL_STEP
        written = planned_text(design, asked.text, result.path.points, radius)
        progress("checking the planned cam")
        try:
            made = design_of(written, Path(f"{design.name}.toml"))
            cam = plan_cam(made, None, progress)
        except DesignError:
            # The closing blend is too steep for the rod to follow it: the other limits are those of the plan.
            if good is not None:
                return good
            if number == rounds - 1 or task.vehicle.closed:
                raise
            tightening, begin = replace(tightening, blend=tightening.blend + 1), rounded(result.path.points)
            continue
        settings = _settings(made, task, cam, progress)
        path = PathPlanning(
            asked=design,
            task=task,
            plan=result,
            text=written,
            cam=cam,
            drawn=settings,
            kept=tightening,
            wheel_radius=radius,
        )
        comparison = CarUse.of(cam).comparison
        # With friction, limits that no profile keeps are the rod's: a path has no influence on them.
        rubs = comparison is not None and comparison.task.mechanics is not None
        beyond = comparison.beyond if comparison is not None and rubs else ()
        failed = [check for check in failing(cam.checks) if check not in beyond]
        if comparison is not None and comparison.nearer is not None:  # the path is for the profile that ends nearest
            failed += comparison.nearer.failed
        more = tightening.after(failed)
        for each in settings:
            more = more.larger(tightening.after(each.failed))
        if path.sound:
            good = path
        if more == tightening:
            break
        tightening, begin = more, rounded(result.path.points)
    assert path is not None  # the last round gives one or raises
    return path if path.sound else good or path


def _settings(design: Design, task: PathTask, cam: CamPlan, progress: Progress) -> tuple[DrawnSpacing, ...]:
    """Settings at the ends of what is drawn and between, if a spacing is drawn."""
    if task.draw is None:
        return ()
    rod = cam_model.leaning(design, "a card of settings")
    draw_model.refuse_range(design, task.draw, CarUse.of(cam).track, rod)
    low, high = task.draw.spacings[0], task.draw.spacings[-1]
    few = replace(task.draw, spacings=tuple(np.linspace(low, high, _SPACINGS).tolist()))
    return card_of(design, cam, few, progress, tries=1).drawn


def _refuse_course(design: Design) -> None:
    """Refuse a course on which the car cannot stand at its start, where the course says how it stands there."""
    course, car = layout_of(design.course), cam_model.car(design)
    start = None if course is None else course.start
    if course is None or start is None or start.heading is None or not start.is_exact:
        return
    ahead = np.exp(1j * start.heading)
    fork = complex(*start.place.points[0]) - complex(*place_of(start.point, car)) * ahead
    still = np.zeros(2)
    pose = RunPoses(fork=np.full(2, fork), heading=still + start.heading, steering=still, travel=still)
    refuse_course(course, body_of(design.car.outline, cam_model.car(design)), pose)
