"""The car runs with play, on the actual profile and on another: runs, events and errors."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import degrees, radians
from os import PathLike
from pathlib import Path
from typing import Generic, Self, TypeVar

import numpy as np

from cadgen.arrays import Array
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.running.drive import Run
from cadgen.car.running.run_errors import Event, EventKind, RunError, deflected, deflection_sum, deflections, run_error
from cadgen.design.schema import Design
from cadgen.figures import Facts
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.car_facts import mechanics_facts
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.course import CourseRun
from cadgen.jobs.cam.cures import Cures
from cadgen.jobs.cam.steering_cam import CarUse, comparison_of, plan_cam
from cadgen.output.files.publisher import Artifact, Written, folder_of, publish
from cadgen.output.files.tables import write_tracks
from cadgen.output.report.cam_pictures import LiftPicture, events_picture, lift_of_cams
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing, save
from cadgen.output.report.tracks import ErrorLine, TrackPanel, run_errors_picture, tracks_picture
from cadgen.progress import Progress, silent

# Cam of a result: its plan, or the plan with its verbs.
C = TypeVar("C", bound=CamPlan)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Simulation(Pictured, Generic[C]):
    """Runs of the car with play in its gears: what `Design.simulate` gives. Lengths are mm and angles rad.

    Attributes:
        cam: cam of the run after.
        comparison: comparison of the two profiles.
        play: return error of the runs at the camshaft, rad.
        planned: planned run, without play.
        before: run with play on the actual profile; of a car as built, on the cam that it was measured with.
        after: run with play on the cam's profile.
        events: jumps and reverses of the run before, with the heading that each adds, rad.
    """

    cam: C
    comparison: PlayComparison
    play: float
    planned: Run
    before: Run
    after: Run
    events: tuple[Event, ...]

    def __repr__(self) -> str:
        return f"<Simulation of {self.cam.origin.name}, {self.cam.kind} profile>"

    @property
    def computed(self) -> Self:
        """The whole result, for figures that are not named here: this object itself."""
        return self

    @property
    def use(self) -> CarUse:
        """Car that the cam steers."""
        return CarUse.of(self.cam)

    @cached_property
    def on_course(self) -> tuple[CourseRun, CourseRun] | None:
        """The planned run and the run with play, held against the course; None without [course].

        Raises:
            DesignError: no car can keep the course.
        """
        course = self.use.course
        return None if course is None else (course.planned, course.played(self.comparison, self.play))

    @cached_property
    def before_error(self) -> RunError:
        """Errors of the run before against the planned run, mm and rad."""
        return run_error(self.before, self.planned)

    @cached_property
    def after_error(self) -> RunError:
        """Errors of the run after against the planned run, mm and rad."""
        return run_error(self.after, self.planned)

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on what was assumed of the car, and what was measured."""
        return self.use.run_notes(float(self.planned.motor[-1]))

    @property
    def _both(self) -> tuple[tuple[str, Evaluation, Run], ...]:
        """Name, method and run of the cam before and of that after."""
        return (
            ("before", self.comparison.before, self.before),
            ("after", self.comparison.chosen, self.after),
        )

    @property
    def picture(self) -> Drawing:
        """Tracks of the planned run, and of the runs with play."""
        panels = [
            TrackPanel(title=f"{when}: {method.title}, with play", run=run, ends=_ends(self.comparison, method))
            for when, method, run in self._both
        ]
        planned = TrackPanel(title="planned", run=self.planned)
        return tracks_picture([planned, *panels], self.planned, self.use.floor)

    def entry(self) -> Facts:
        """The runs, as in the manifest."""
        plan, use, comparison, laps = self.cam, self.use, self.comparison, self.use.laps
        facts = Facts(
            drive_wheel=use.drive_wheel.entry(),
            profile=plan.kind.code,
            passed=plan.passed,
            failed_checks=[check.name for check in plan.failed],
            verdict=plan.verdict.entry(),
            method=comparison.chosen.profile.code,
            return_error_deg=degrees(self.play),
            cut_for_deg=degrees(comparison.chosen.made_for),
            mechanics=mechanics_facts(comparison.task.mechanics, comparison.chosen.lift),
            friction_note=comparison.rubbing,
            as_built=use.as_built_facts(float(self.planned.motor[-1])),
            events=[Facts(kind=event.kind) | event.figures for event in self.events],
            deflection_sum_deg=degrees(deflection_sum(self.events)),
            before=self.before_error.figures,
            after=self.after_error.figures,
            after_without_play=comparison.chosen.deviation.figures,
        )
        if laps is not None:
            facts |= Facts(laps=laps.in_runs(planned=self.planned, before=self.before, after=self.after))
        course = self.on_course and {
            name: {key: Facts(room_mm=room, where=where) for key, (where, room) in run.figures().items()}
            for name, run in zip(("planned", "after"), self.on_course, strict=True)
        }
        return plan.origin.entry() | facts | Facts(course=course)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write tracks as CSV and pictures as PNG and SVG, all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        comparison, use = self.comparison, self.use
        name = self.cam.origin.name if use.record is None else f"{self.cam.origin.name}, as built"
        stem = f"{self.cam.origin.name}_{self.cam.kind}_simulation"
        title = f"{name}, return error {degrees(self.play):.3f}°"

        def files(staging: Path) -> Iterator[Artifact]:
            progress("writing and reading back the tracks")
            runs = {"planned": self.planned, "before": self.before, "after": self.after}
            write_tracks(staging / f"{stem}_tracks.csv", runs)
            yield Artifact(f"{stem}_tracks.csv")
            progress("drawing")
            yield from map(Artifact, save(lift_of_cams(lift_picture(self)), staging, f"{stem}_lift"))
            yield from map(Artifact, save(self.picture, staging, f"{stem}_tracks"))
            lines = []
            for (when, evaluation, _), error in zip(self._both, (self.before_error, self.after_error), strict=True):
                low, high = (run_error(comparison.run(evaluation, play), self.planned) for play in comparison.band.ends)
                lines.append(ErrorLine(label=f"{when}: {evaluation.title}", at_play=error, at_ends=(low, high)))
            yield from map(
                Artifact, save(run_errors_picture(title, lines, comparison.task.length), staging, f"{stem}_errors")
            )

        return publish(stem, folder_of(folder), files, self.entry())


def simulate(
    design: Design, profile: str = "optimized", play_deg: float | None = None, progress: Progress = silent
) -> Simulation[CamPlan]:
    """Run the car on the actual profile and on another one.

    Args:
        design: loaded design.
        profile: code of a profile for play.
        play_deg: return error of the runs, degrees; the play that the profile is cut for if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: as `plan_cam`, or the play is negative.
    """
    return simulated(plan_cam(design, profile, progress), play_deg, progress)


def simulated(plan: C, play_deg: float | None = None, progress: Progress = silent) -> Simulation[C]:
    """Run the car on the actual profile and on that of a plan.

    Args:
        plan: plan of a profile that was compared under play.
        play_deg: return error of the runs, degrees; the play that the profile is cut for if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the profile was not compared under play, or the play is negative.
    """
    comparison = comparison_of(plan)
    play = comparison.chosen.play if play_deg is None else radians(play_deg)
    task = comparison.task
    progress("running the car")
    before, after = (comparison.run(evaluation, play) for evaluation in (comparison.before, comparison.chosen))
    leads = comparison.following(comparison.before, play).leads if task.mechanics else None
    events = deflections(comparison.before.lift, task.follower, task.car, task.length, play, leads=leads)
    return Simulation(
        cam=plan,
        comparison=comparison,
        play=play,
        planned=task.planned(),
        before=before,
        after=after,
        events=events,
    )


def methods_picture(plan: CamPlan) -> Drawing:
    """Tracks of every method at its play, with the ends over the band of play.

    Args:
        plan: plan of an optimized profile.
    """
    comparison = comparison_of(plan)
    panels = [
        TrackPanel(
            title=f"{_name(evaluation)}, {evaluation.train}", run=evaluation.run, ends=_ends(comparison, evaluation)
        )
        for evaluation in comparison.evaluations
    ]
    return tracks_picture(panels, comparison.task.planned(), CarUse.of(plan).floor)


def write_comparison(plan: CamPlan, out: Path, cures: Cures, progress: Progress = silent) -> Written:
    """Draw the events and tracks of the methods compared, and publish the pictures together.

    Args:
        plan: plan of an optimized profile.
        out: folder for the pictures; nothing appears in it unless everything succeeded.
        cures: cures of lost lift, for the manifest.
        progress: function that is called with a few words on each step.

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

    def files(folder: Path) -> Iterator[Artifact]:
        progress("drawing")
        title = f"{plan.origin.name}: deflection error by event"
        yield from map(Artifact, save(events_picture(title, bars), folder, f"{stem}_events"))
        planned, field = comparison.task.planned(), CarUse.of(plan).floor
        yield from map(Artifact, save(methods_picture(plan), folder, f"{stem}_tracks"))
        yield from map(
            Artifact, save(tracks_picture(_alone(comparison), planned, field), folder, f"{stem}_tracks_by_event")
        )

    return publish(stem, out, files, cam_facts(plan, cures))


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


def lift_picture(simulation: Simulation[C]) -> LiftPicture:
    """The lift before and after, close by the highest peak and the deepest valley."""
    jumps = [event for event in simulation.events if event.kind == EventKind.JUMP]
    waits = [event for event in simulation.events if event.kind == EventKind.REVERSE]
    comparison = simulation.comparison
    return LiftPicture(
        title=simulation.cam.origin.name + ("" if simulation.use.record is None else ", as built"),
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


def _ends(comparison: PlayComparison, evaluation: Evaluation) -> Array:
    return np.array([comparison.run(evaluation, play).drive_wheel[-1] for play in evaluation.band.plays])
