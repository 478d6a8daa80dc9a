"""Runs as files: tracks and pictures, published together with their figures."""

from collections.abc import Iterator
from math import degrees
from pathlib import Path

import numpy as np

from cadgen.arrays import Array
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.course.layout import Shape
from cadgen.car.running.errors import EventKind, RunError, deflected, run_error
from cadgen.design import cam_model
from cadgen.design.course import body_of, layout_of
from cadgen.design.schema import Design
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cam_plan import CamPlan, comparison_of
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.cures import Cures, find_cures
from cadgen.jobs.runs.manifest import simulation_facts, tolerance_facts
from cadgen.jobs.runs.simulation import Simulation
from cadgen.jobs.runs.tolerance import ToleranceRun
from cadgen.output.files.publisher import Artifact, Written, publish
from cadgen.output.files.tables import write_tracks
from cadgen.output.report.cars import FleetPicture, draw_budget, draw_fleet
from cadgen.output.report.errors import draw_events
from cadgen.output.report.lift import LiftPicture, draw_lift
from cadgen.output.report.tracks import ErrorLine, Field, TrackPanel, draw_run_errors, draw_tracks
from cadgen.progress import Progress, silent


def write_simulation(simulation: Simulation, out: Path, progress: Progress = silent) -> Written:
    """Write tracks and pictures, and publish them together.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    comparison, design = simulation.comparison, simulation.plan.car.design
    stem = f"{design.name}_{simulation.plan.kind}_simulation"
    runs = {"planned": simulation.planned, "before": simulation.before, "after": simulation.after}
    named = design.name if design.as_built is None else f"{design.name}, as built"
    title = f"{named}, return error {degrees(simulation.play):.3f}°"
    both = (("before", comparison.before), ("after", comparison.chosen))
    panels = [
        TrackPanel(title="planned", run=simulation.planned),
        *(
            TrackPanel(
                title=f"{when}: {evaluation.title}, with play", run=runs[when], ends=_ends(comparison, evaluation)
            )
            for when, evaluation in both
        ),
    ]

    def files(folder: Path) -> Iterator[Artifact]:
        progress("writing and reading back the tracks")
        write_tracks(folder / f"{stem}_tracks.csv", runs)
        yield Artifact(f"{stem}_tracks.csv")
        progress("drawing")
        yield from map(Artifact, draw_lift(lift_picture(simulation), folder, f"{stem}_lift"))
        field = _field(design)
        yield from map(Artifact, draw_tracks(panels, simulation.planned, field, folder, f"{stem}_tracks"))
        lines = [
            ErrorLine(label=f"{when}: {evaluation.title}", at_play=error, at_ends=_at_ends(simulation, evaluation))
            for (when, evaluation), error in zip(both, (simulation.before_error, simulation.after_error), strict=True)
        ]
        yield from map(Artifact, draw_run_errors(title, lines, comparison.task.length, folder, f"{stem}_errors"))

    return publish(stem, out, files, simulation_facts(simulation))


def write_comparison(plan: CamPlan, out: Path, progress: Progress = silent, *, cures: Cures | None = None) -> Written:
    """Draw the events and tracks of the methods compared, and publish the pictures together.

    Args:
        plan: plan of an optimized profile.
        out: folder for the pictures; nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.
        cures: cures of lost lift, if they were sought already.

    Raises:
        FileError: a file cannot be written.
    """
    comparison = comparison_of(plan)
    stem = f"{plan.origin.name}_methods"
    bars = {
        f"{_name(evaluation)}, {evaluation.train}": evaluation.events
        for evaluation in comparison.evaluations
        if not evaluation.profile.dilated and evaluation.events
    }
    panels = [
        TrackPanel(
            title=f"{_name(evaluation)}, {evaluation.train}",
            run=evaluation.run,
            ends=_ends(comparison, evaluation),
        )
        for evaluation in comparison.evaluations
    ]

    def files(folder: Path) -> Iterator[Artifact]:
        progress("drawing")
        title = f"{plan.origin.name}: deflection error by event"
        yield from map(Artifact, draw_events(title, bars, folder, f"{stem}_events"))
        planned, field = comparison.task.planned(), _field(plan.car.design)
        yield from map(Artifact, draw_tracks(panels, planned, field, folder, f"{stem}_tracks"))
        yield from map(Artifact, draw_tracks(_alone(comparison), planned, field, folder, f"{stem}_tracks_by_event"))

    return publish(stem, out, files, cam_facts(plan, find_cures(plan, progress) if cures is None else cures))


def _alone(comparison: PlayComparison) -> list[TrackPanel]:
    """Tracks of the paper's methods at the greatest play with jumps alone, and with reverses alone."""
    return [
        TrackPanel(
            title=f"{_name(evaluation)}, {evaluation.train}: {kind}s alone, {degrees(evaluation.band.plays[-1]):.3f}°",
            run=deflected(
                comparison.run(evaluation, 0.0), [event for event in evaluation.events if event.kind == kind]
            ),
        )
        for kind in EventKind
        for evaluation in comparison.evaluations
        if not evaluation.profile.dilated and evaluation.events
    ]


def lift_picture(simulation: Simulation) -> LiftPicture:
    """The lift before and after, close by the highest peak and the deepest valley."""
    jumps = [event for event in simulation.events if event.kind == EventKind.JUMP]
    waits = [event for event in simulation.events if event.kind == EventKind.REVERSE]
    comparison = simulation.comparison
    return LiftPicture(
        title=simulation.plan.origin.name + ("" if simulation.plan.car.design.as_built is None else ", as built"),
        follower=comparison.task.follower,
        wanted=comparison.task.lift,
        before=comparison.following(comparison.before, simulation.play),
        before_name=f"before: {comparison.before.title}",
        after=comparison.following(comparison.chosen, simulation.play),
        after_name=f"after: {comparison.chosen.title}",
        play=simulation.play,
        peak=max(jumps, key=lambda event: event.lift).cam_angle if jumps else None,
        valley=min(waits, key=lambda event: event.lift).cam_angle if waits else None,
    )


def _name(evaluation: Evaluation) -> str:
    return evaluation.title if evaluation.measured else evaluation.profile.code


def _at_ends(simulation: Simulation, evaluation: Evaluation) -> tuple[RunError, RunError]:
    comparison = simulation.comparison
    low, high = (run_error(comparison.run(evaluation, play), simulation.planned) for play in comparison.band.ends)
    return low, high


def _ends(comparison: PlayComparison, evaluation: Evaluation) -> Array:
    return np.array([comparison.run(evaluation, play).drive_wheel[-1] for play in evaluation.band.plays])


def _field(design: Design) -> Field:
    course, field = layout_of(design.course), design.field
    body = body_of(design.car.outline, cam_model.car(design))
    car = np.array(body.corners or [wheel.centre for wheel in body.wheels])
    if course is not None:
        return Field(
            edge=None if course.edge is None else np.array(course.edge.points),
            obstacles=[obstacle.shape for obstacle in course.obstacles],
            gates=[gate.place for gate in course.gates],
            car=car,
        )
    if field is None:
        return Field(car=car)
    (x, y), (width, height) = field.corner_mm, field.size_mm
    return Field(
        edge=np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]]),
        obstacles=[Shape.disc(centre, field.obstacle_radius_mm) for centre in field.obstacles_mm],
        car=car,
    )


def write_tolerance(run: ToleranceRun, out: Path, progress: Progress = silent) -> Written:
    """Draw the distribution and the sensitivities, and publish the pictures together.

    Raises:
        FileError: a file cannot be written.
    """
    design = run.plan.car.design
    stem = f"{design.name}_{run.plan.kind}_tolerance"
    progress("drawing")
    picture = FleetPicture(
        title=f"{design.name}, {run.plan.kind} profile, {run.samples} cars",
        along=run.ends.along,
        across=run.ends.across,
        gate_width=run.gate_width,
        passed=run.passed,
        shares={sensitivity.name: sensitivity.share for sensitivity in run.sensitivities},
    )

    def files(folder: Path) -> Iterator[Artifact]:
        yield from map(Artifact, draw_fleet(picture, folder, stem))
        if run.budget is not None:
            bars = {cost.name.replace("_", " "): (cost.before, cost.after) for cost in run.budget.budget.costs}
            title = f"{design.name}, {run.plan.kind} profile"
            yield from map(Artifact, draw_budget(title, bars, folder, f"{stem}_budget"))

    return publish(stem, out, files, tolerance_facts(run))
