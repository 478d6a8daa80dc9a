"""Profiles evaluated as they are cut: rolled on their outline, and run with play.

The lift that a profile is cut for may differ from the lift of its outline. The outline, rolled by code that does not
use the lift that it is cut for, gives the lift that the car gets.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import degrees, inf, isnan
from typing import TypeVar

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import rolling_step
from cadgen.cam.envelope import ActualProfile
from cadgen.cam.follower import Contact, Follower
from cadgen.car.against_play.band import BAND_PLAYS, BandResult, over_band
from cadgen.car.against_play.compensation import CutLift, LostDip, lost_dips
from cadgen.car.against_play.play_task import PlayTask, TrainTask
from cadgen.car.against_play.profile_kinds import ProfileKind
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run
from cadgen.car.running.play import LEAST_SWING
from cadgen.car.running.run_errors import Event, RunError, deflection_sum, deflections, run_error
from cadgen.car.running.sampled import rolled_lift
from cadgen.check import CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.errors import CheckError
from cadgen.gears.choices import StageOrder
from cadgen.messages import Message, joined

F = TypeVar("F", bound=Follower)
STATIONS = 3600  # at which the rod is rolled; the run then errs by 0.02 mm
_OUTLINE_STEP = 0.03  # mm; the run then ends within 0.01 mm of where finer steps take it (0.06: 0.06, 0.12: 0.6)


@dataclass(frozen=True, kw_only=True, repr=False)
class Evaluation:
    """A profile on a train, with its run and its errors.

    Attributes:
        profile: profile that was evaluated.
        train: order of the stages of the train.
        play: return error of the run, rad.
        windows: widths of the windows by which its lift is turned ahead, rad; see `CutLift`.
        by_lead: whether each lead has one of them, and not all falls one.
        lift: lift that the profile is cut for.
        wanted: outline wanted of the finished disc.
        cut: curve that is cut; that of `wanted` unless the car's [as_built] requires another.
        rolled: lift that the follower gets on it, without play.
        events: events of the lift, with their deflection errors at the band's greatest play, by the paper's equations.
        run: run with that play, on the rolled profile.
        error: errors of that run.
        deviation: errors of the run without play: the path that the profile gives away, or needs play to keep.
        band: errors at the ends of such runs over the train's band.
        lift_error: lift with play beyond the lift wanted along the run, shape (n,), mm.
        least_swing: smallest rise or fall of tan(beta) on `rolled` that counts as an event.
        lost: dips of the lift wanted that are narrower than the play of a dilated lift.
        measured: True for the cam that was on the car when it was measured.
    """

    profile: ProfileKind
    train: StageOrder
    play: float
    windows: tuple[float, ...]
    lift: PathMotion
    wanted: ActualProfile
    cut: ClosedCurve
    rolled: PathMotion
    events: tuple[Event, ...]
    run: Run
    error: RunError
    deviation: RunError
    band: BandResult
    lift_error: Array
    least_swing: float = LEAST_SWING
    lost: tuple[LostDip, ...] = ()
    measured: bool = False
    by_lead: bool = False

    def __repr__(self) -> str:
        return f"<Evaluation of {self.profile.code}, train {self.train}: ends {self.error.end_distance:.4g} mm off>"

    @property
    def made_for(self) -> float:
        """The widest window, rad."""
        return max(self.windows)

    @property
    def cut_for(self) -> str:
        """The window that the profile is cut for, or those of all leads, in degrees."""
        least, most = degrees(min(self.windows)), degrees(self.made_for)
        if len(self.windows) == 1:
            return f"{most:.3f}°"
        return Message("{least:.3f} to {most:.3f}°, by lead", least=least, most=most)

    @property
    def name(self) -> str:
        """Names of profile and train."""
        return f"{self.profile}, {self.train}"

    @property
    def title(self) -> str:
        """Name in tables and pictures."""
        return (
            Message("cam as measured ({profile})", profile=Message(str(self.profile)))
            if self.measured
            else Message("{profile} profile", profile=Message(str(self.profile)))
        )

    def run_without_loss(self, task: PlayTask) -> Run:
        """Run with the same play on the lift that the profile is cut for, of which the envelope may lose some.

        Args:
            task: task of the profile.
        """
        return task.run(self.lift, self.play, least_swing=self.least_swing, cut=self.lift)

    @property
    def worst_lift_error(self) -> float:
        """Greatest difference of the lift with play from the lift wanted, mm."""
        return float(np.abs(self.lift_error).max())

    @property
    def deflection_sum(self) -> float:
        """Cumulative deflection error of the events, rad."""
        return deflection_sum(self.events)


def evaluate(work: TrainTask, profile: ProfileKind) -> Evaluation:
    """Make a profile for a train and let the car run on it.

    Args:
        work: task on a train.
        profile: any profile that is not the best of others.

    Raises:
        DesignError: the band of play does not run upwards from 0 or more, or the profile cannot be made.
    """
    task = work.task
    cut_lift = profile.lift(work)
    wanted = profile.curve(cut_lift.lift, task.follower)
    return _evaluation(work, profile, cut_lift, wanted, task.as_built.precompensated(wanted.curve))


def evaluate_measured(work: TrainTask, profile: ProfileKind, lift: PathMotion, cut: ClosedCurve) -> Evaluation:
    """Let the car as built run on the cam that it was measured with.

    Args:
        work: task on a train.
        profile: profile of that cam.
        lift: lift that the cam was made for.
        cut: curve that was cut, mm.

    Raises:
        DesignError: the band of play does not run upwards from 0 or more.
    """
    return _evaluation(work, profile, CutLift(lift, work.windows), ActualProfile(cut, ()), cut, measured=True)


def rolled_on(
    roll: Callable[[ClosedCurve, F, Array, float], Contact],
    cut: ClosedCurve,
    follower: F,
    lift: PathMotion,
    blend_start: float,
) -> PathMotion:
    """Lift that a follower gets on the disc of a curve that is cut.

    Args:
        roll: function that rolls it, of the curve, the follower, cam angles (rad) and the step of the outline (mm).
        cut: curve that is cut, mm.
        follower: follower as designed.
        lift: lift that the curve was made for.
        blend_start: cam angle from which the path no longer steers, rad.
    """
    stations = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    contact = roll(cut, follower, stations, rolling_step(cut, follower, _OUTLINE_STEP))
    return rolled_lift(contact, lift, blend_start=blend_start)


def _evaluation(
    work: TrainTask,
    profile: ProfileKind,
    cut_lift: CutLift,
    wanted: ActualProfile,
    cut: ClosedCurve,
    *,
    measured: bool = False,
) -> Evaluation:
    task, band, planned, follower = work.task, work.band, work.planned, work.task.follower
    lift, made_for = cut_lift.lift, cut_lift.made_for
    roll = task.as_built.roll_measured if measured else task.as_built.roll_new
    rolled = rolled_on(roll, cut, follower, lift, task.lift.blend_start)
    play = work.run_at(made_for)
    least_swing = max(LEAST_SWING, task.as_built.unevenness(measured=measured) / follower.inner)
    run = task.run(rolled, play, least_swing=least_swing, cut=lift)
    dilated = profile.dilated and not measured and not cut_lift.by_lead
    dips = lost_dips(task.lift, made_for) if dilated else ()
    return Evaluation(
        profile=profile,
        train=work.train,
        play=play,
        windows=cut_lift.windows,
        by_lead=cut_lift.by_lead,
        lift=lift,
        wanted=wanted,
        cut=cut,
        rolled=rolled,
        events=deflections(lift, follower, task.car, task.length, band.ends[1]),
        run=run,
        error=run_error(run, planned),
        deviation=run_error(task.run(rolled, 0.0, least_swing=least_swing), planned),
        band=over_band(
            rolled,
            task.lift,
            task.car,
            task.length,
            np.linspace(*band.ends, BAND_PLAYS),
            made_for,
            least_swing=least_swing,
            mechanics=task.mechanics.cases if task.mechanics else (),
            cut=lift,
        ),
        lift_error=follower.lift(run.tan_beta) - follower.lift(planned.tan_beta),
        least_swing=least_swing,
        lost=tuple(dip for dip in dips if dip.whole),
        measured=measured,
    )


@dataclass(frozen=True, kw_only=True)
class FigureLimit:
    """Greatest value allowed for a figure.

    Attributes:
        figure: name of the figure.
        most: greatest value allowed, in `unit`.
        unit: unit of the figure, for messages.
        code: code of the check that fails where no profile keeps the limit.
        key: key of the limit in the design file.
    """

    figure: str
    most: float
    unit: str
    code: CheckCode
    key: str

    def kept_by(self, candidate: "ProfileCandidate") -> bool:
        """Whether a candidate keeps the limit; a figure that is not a number keeps none."""
        return candidate.figures[self.figure] <= self.most


@dataclass(frozen=True, kw_only=True)
class ProfileCandidate:
    """A profile that may be chosen: its name and its figures, by name, in the limits' units."""

    name: str
    figures: Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class Choice:
    """The profile chosen, and a sentence on each of the candidates."""

    best: ProfileCandidate
    reasons: tuple[str, ...]


def choose(
    candidates: Sequence[ProfileCandidate], limits: Sequence[FigureLimit], *, objective: str, unit: str
) -> Choice:
    """Choose the candidate that keeps every limit and has the least value of a figure.

    Args:
        candidates: at least one candidate, each with a value for every figure named.
        limits: limits to be kept; a figure that is not a number keeps no limit.
        objective: name of the figure that is to be least.
        unit: its unit, for the reasons.

    Raises:
        CheckError: no candidate keeps the limits. The message has the limit that binds on the nearest candidate, and
            by how much it is exceeded.
    """
    broken = [[limit for limit in limits if not limit.kept_by(candidate)] for candidate in candidates]
    kept = [candidate for candidate, breaks in zip(candidates, broken, strict=True) if not breaks]
    if not kept:
        near, binding = nearest(candidates, limits)
        raise CheckError(
            "none of the profiles compared keeps the design's limits: the nearest, {name}, {beyond}: "
            "raise the limit in [optimize], or take a train with less backlash",
            name=Message(near.name),
            beyond=_beyond(near, binding),
        )
    best = min(kept, key=lambda candidate: candidate.figures[objective])
    reasons = []
    for candidate, breaks in zip(candidates, broken, strict=True):
        if candidate is best:
            figure = f"{candidate.figures[objective]:.4g} {unit}"
            verdict = Message(
                "chosen: the least {objective}, {figure}, of {count} that keep every limit",
                objective=Message(objective),
                figure=figure,
                count=len(kept),
            )
        elif breaks:
            verdict = Message(
                "refused: it {beyond}", beyond=joined([_beyond(candidate, each) for each in breaks], ", and ")
            )
        else:
            verdict = Message(
                "not chosen: its {objective} is {value:.4g} {unit}",
                objective=Message(objective),
                value=candidate.figures[objective],
                unit=unit,
            )
        reasons.append(joined((Message(candidate.name), verdict), " "))
    return Choice(best=best, reasons=tuple(reasons))


def nearest(
    candidates: Sequence[ProfileCandidate], limits: Sequence[FigureLimit]
) -> tuple[ProfileCandidate, FigureLimit]:
    """Candidate nearest to keeping every limit, and the limit that it exceeds most, as a share of the limit.

    Args:
        candidates: at least one candidate.
        limits: at least one limit.
    """
    near = min(candidates, key=lambda candidate: max(_excess(candidate, limit) for limit in limits))
    return near, max(limits, key=lambda limit: _excess(near, limit))


def _excess(candidate: ProfileCandidate, limit: FigureLimit) -> float:
    """Excess of a figure over its limit, as a share of the limit; infinite for a figure that is no number."""
    value = candidate.figures[limit.figure]
    if isnan(value):
        return inf
    return (value - limit.most) / max(abs(limit.most), 1e-300)


def _beyond(candidate: ProfileCandidate, limit: FigureLimit) -> str:
    value = candidate.figures[limit.figure]
    return Message(
        "has a {figure} of {value:.4g} {unit}, {excess:.4g} {unit} more than the {most:.4g} allowed",
        figure=Message(limit.figure),
        value=value,
        unit=Message(limit.unit),
        excess=value - limit.most,
        most=limit.most,
    )
