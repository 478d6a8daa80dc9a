"""The car runs with play, on the actual profile and on another: runs, events and errors."""

from dataclasses import dataclass
from functools import cached_property
from math import radians

from cadgen.car.running.drive import Run
from cadgen.car.running.errors import Event, RunError, deflections, run_error
from cadgen.design.schema import Design
from cadgen.jobs.cam.cam_plan import CamPlan, comparison_of, plan_cam
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.course import CourseRun
from cadgen.progress import Progress, silent


@dataclass(frozen=True)
class Simulation:
    """A design's runs with play.

    Attributes:
        plan: plan of the profile that is compared with the actual one.
        comparison: comparison of the two profiles.
        play: return error of the runs, rad.
        planned: planned run.
        before: run with play on the actual profile; of a car as built, on the cam that it was measured with.
        after: run with play on the plan's profile.
        events: events of the run before, with their deflection errors at that play.
    """

    plan: CamPlan
    comparison: PlayComparison
    play: float
    planned: Run
    before: Run
    after: Run
    events: tuple[Event, ...]

    @cached_property
    def on_course(self) -> tuple[CourseRun, CourseRun] | None:
        """The planned run and the run with play, held against the course; None without [course].

        Raises:
            DesignError: no car can keep the course.
        """
        course = self.plan.course
        return None if course is None else (course.planned, course.played(self.comparison, self.play))

    @cached_property
    def before_error(self) -> RunError:
        """Errors of the run before."""
        return run_error(self.before, self.planned)

    @cached_property
    def after_error(self) -> RunError:
        """Errors of the run after."""
        return run_error(self.after, self.planned)


def simulate(
    design: Design, profile: str = "optimized", play_deg: float | None = None, progress: Progress = silent
) -> Simulation:
    """Run the car on the actual profile and on another one.

    Args:
        design: loaded design.
        profile: code of a profile for play.
        play_deg: return error of the runs, degrees; the play that the profile is cut for if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: as `plan_cam`, or the play is negative.
        CheckError: no profile keeps the limits of [optimize].
    """
    return simulated(plan_cam(design, profile, progress), play_deg, progress)


def simulated(plan: CamPlan, play_deg: float | None = None, progress: Progress = silent) -> Simulation:
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
    return Simulation(plan, comparison, play, task.planned(), before, after, events)
