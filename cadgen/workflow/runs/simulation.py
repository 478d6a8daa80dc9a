"""The car runs with play, on the actual profile and on another: tracks, events, errors, pictures."""

from dataclasses import dataclass
from functools import cached_property
from math import degrees, radians
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.design.schema import Design
from cadgen.export.folder import publishing
from cadgen.export.manifest import Written, file_facts, versions, write_manifest
from cadgen.export.tracks import write_tracks
from cadgen.motion.drive import Run
from cadgen.motion.errors import Event, RunError, deflected, deflection_sum, deflections, run_error
from cadgen.optimize.judge import Judged
from cadgen.report.errors import draw_events
from cadgen.report.lift import LiftPicture, draw_lift
from cadgen.report.tracks import ErrorLine, Field, TrackPanel, draw_run_errors, draw_tracks
from cadgen.workflow.cam.as_built import as_built_facts
from cadgen.workflow.cam.mechanics import mechanics_facts
from cadgen.workflow.cam.plan import CamPlan, Step, against_of, plan_cam
from cadgen.workflow.cam.play import Against


@dataclass(frozen=True)
class Simulation:
    """A design's runs with play.

    Attributes:
        plan: of the profile that is compared with the actual one.
        against: the plan's.
        play: return error of the runs, rad.
        planned: the run wanted.
        before: with play on the actual profile; of a car as built, on the cam that it was measured with.
        after: with play on the plan's profile.
        events: of that profile, with their deflection errors at that play.
    """

    plan: CamPlan
    against: Against
    play: float
    planned: Run
    before: Run
    after: Run
    events: tuple[Event, ...]

    @cached_property
    def before_error(self) -> RunError:
        """Of the run before."""
        return run_error(self.before, self.planned)

    @cached_property
    def after_error(self) -> RunError:
        """Of the other profile's run."""
        return run_error(self.after, self.planned)

    def facts(self) -> dict[str, Any]:
        """Figures for the manifest and for machines."""
        return {
            "design": self.plan.design.name,
            "source": self.plan.design.source,
            "overrides": list(self.plan.design.overrides),
            "design_sha256": self.plan.design.content_hash,
            "profile": self.plan.profile,
            "passed": self.plan.passed,
            "failed_checks": [check.name for check in self.plan.failed],
            "method": self.against.chosen.profile,
            "return_error_deg": degrees(self.play),
            "cut_for_deg": degrees(self.against.chosen.made_for),
            "mechanics": mechanics_facts(self.against.task.mechanics, self.against.chosen.lift),
            "friction_note": self.against.rubbing,
            "as_built": as_built_facts(self.plan.design, float(self.planned.motor[-1])),
            "events": [
                {
                    "kind": event.kind,
                    "cam_angle_deg": degrees(event.cam_angle),
                    "lift_mm": event.lift,
                    "deflection_deg": degrees(event.deflection),
                }
                for event in self.events
            ],
            "deflection_sum_deg": degrees(deflection_sum(self.events)),
            "before": _end(self.before_error),
            "after": _end(self.after_error),
            "after_without_play": _end(self.against.chosen.deviation),
        }


def simulate(
    design: Design, profile: str = "optimized", play_deg: float | None = None, step: Step = lambda text: None
) -> Simulation:
    """Run the car on the actual profile and on another one.

    Args:
        design: a loaded design.
        profile: one of `PLAY_PROFILES`.
        play_deg: return error of the runs; that which the profile is cut for if left out.
        step: told what is being done.

    Raises:
        DesignError: as `plan_cam`, or the play is negative.
        CheckError: no profile keeps the limits of [optimize].
    """
    plan = plan_cam(design, profile, step)
    against = against_of(plan)
    play = against.chosen.play if play_deg is None else radians(play_deg)
    task = against.task
    step("running the car")
    before, after = (against.run(one, play) for one in (against.before, against.chosen))
    leads = against.following(against.before, play).leads if task.mechanics else None
    events = deflections(against.before.lift, task.follower, task.car, task.length, play, leads=leads)
    return Simulation(plan, against, play, task.planned(), before, after, events)


def write_simulation(simulation: Simulation, out: Path, step: Step = lambda text: None) -> Written:
    """Write tracks and pictures, and publish them together.

    Raises:
        FileError: a file cannot be written, or what was read back is not what was meant.
    """
    against, design = simulation.against, simulation.plan.design
    stem = f"{design.name}_{simulation.plan.profile}_simulation"
    runs = {"planned": simulation.planned, "before": simulation.before, "after": simulation.after}
    named = design.name if design.as_built is None else f"{design.name}, as built"
    title = f"{named}, return error {degrees(simulation.play):.3f}°"
    with publishing(out) as staging:
        names = [f"{stem}_tracks.csv"]
        step("writing and reading back the tracks")
        write_tracks(staging / names[0], runs)
        step("drawing")
        names += draw_lift(lift_picture(simulation), staging, f"{stem}_lift")
        names += draw_tracks(
            [
                TrackPanel(title="planned", run=simulation.planned),
                *(
                    TrackPanel(title=f"{one.title}, with play", run=run, ends=_ends(against, one))
                    for one, run in ((against.before, simulation.before), (against.chosen, simulation.after))
                ),
            ],
            simulation.planned,
            _field(design),
            staging,
            f"{stem}_tracks",
        )
        lines = [
            ErrorLine(label=one.title, at_play=error, at_ends=_at_ends(simulation, one))
            for one, error in ((against.before, simulation.before_error), (against.chosen, simulation.after_error))
        ]
        names += draw_run_errors(title, lines, against.task.length, staging, f"{stem}_errors")
        entry = {
            **simulation.facts(),
            "versions": versions(),
            "files": {name: file_facts(staging / name) for name in names},
        }
        write_manifest(staging, stem, entry)
    return Written(stem, entry)


def write_comparison(plan: CamPlan, out: Path, step: Step = lambda text: None) -> Written:
    """Draw what the methods do, and publish the pictures together.

    Args:
        plan: of an optimized profile.
        out: the folder; nothing appears in it unless everything succeeded.
        step: told what is being done.

    Raises:
        FileError: a file cannot be written.
    """
    against = against_of(plan)
    stem = f"{plan.design.name}_methods"
    with publishing(out) as staging:
        step("drawing")
        bars = {
            f"{_name(one)}, {one.train}": one.events
            for one in against.judged
            if one.profile in ("actual", "smoothed") and one.events
        }
        names = draw_events(f"{plan.design.name}: deflection error by event", bars, staging, f"{stem}_events")
        planned = against.task.planned()
        panels = [
            TrackPanel(title=f"{_name(one)}, {one.train}", run=one.run, ends=_ends(against, one))
            for one in against.judged
        ]
        names += draw_tracks(panels, planned, _field(plan.design), staging, f"{stem}_tracks")
        names += draw_tracks(_alone(against), planned, _field(plan.design), staging, f"{stem}_tracks_by_event")
        entry = {**plan.facts(), "versions": versions(), "files": {name: file_facts(staging / name) for name in names}}
        write_manifest(staging, stem, entry)
    return Written(stem, entry)


def _alone(against: Against) -> list[TrackPanel]:
    """What jumps alone do to the paths of the paper's methods at the greatest play, and what reverses alone do."""
    return [
        TrackPanel(
            title=f"{_name(one)}, {one.train}: {kind}s alone, {degrees(one.band.plays[-1]):.3f}°",
            run=deflected(against.run(one, 0.0), [event for event in one.events if event.kind == kind]),
        )
        for kind in ("jump", "reverse")
        for one in against.judged
        if one.profile in ("actual", "smoothed") and one.events
    ]


def lift_picture(simulation: Simulation) -> LiftPicture:
    """The lift before and after, close by the highest peak and the deepest valley."""
    jumps = [event for event in simulation.events if event.kind == "jump"]
    waits = [event for event in simulation.events if event.kind == "reverse"]
    against = simulation.against
    return LiftPicture(
        title=simulation.plan.design.name + ("" if simulation.plan.design.as_built is None else ", as built"),
        follower=against.task.follower,
        wanted=against.task.lift,
        before=against.following(against.before, simulation.play),
        before_name=against.before.title,
        after=against.following(against.chosen, simulation.play),
        after_name=against.chosen.profile,
        play=simulation.play,
        peak=max(jumps, key=lambda event: event.lift).cam_angle if jumps else None,
        valley=min(waits, key=lambda event: event.lift).cam_angle if waits else None,
    )


def _name(one: Judged) -> str:
    return one.title if one.measured else one.profile


def _at_ends(simulation: Simulation, one: Judged) -> tuple[RunError, RunError]:
    low, high = (
        run_error(simulation.against.run(one, play), simulation.planned) for play in simulation.against.band.ends
    )
    return low, high


def _ends(against: Against, one: Judged) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([against.run(one, play).drive_wheel[-1] for play in one.band.plays])


def _field(design: Design) -> Field:
    given = design.field
    if given is None:
        return Field(obstacles=np.empty((0, 2)))
    return Field(
        corner=given.corner_mm,
        size=given.size_mm,
        obstacles=np.array(given.obstacles_mm).reshape(-1, 2),
        obstacle_radius=given.obstacle_radius_mm,
    )


def _end(error: RunError) -> dict[str, float]:
    return {
        "end_heading_deg": degrees(error.end_heading),
        "end_position_mm": error.end_distance,
        "greatest_position_mm": float(error.distance.max()),
    }
