"""Every method judged on the profile that it cuts: rolled on its outline, with play.

A method's lift is one thing; its profile, rolled by code that does not know the lift, is what the car gets.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.cam.contact import roll
from cadgen.cam.envelope import ActualProfile, actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.motion.drive import Pose, Run, drive
from cadgen.motion.errors import Event, RunError, deflection_sum, deflections, run_error
from cadgen.motion.play import LEAST_SWING, TURN
from cadgen.motion.sampled import rolled_lift
from cadgen.optimize.band import BAND_PLAYS, BandResult, Bound, PlayBand, best_for_band, fixed_profile_bound, over_band
from cadgen.optimize.compensation import compensated_lift
from cadgen.optimize.methods import PROFILES
from cadgen.optimize.smoothing import smooth_to
from cadgen.steering.car import Car

Array = NDArray[np.float64]

STATIONS = 3600  # at which the rod is rolled; the run then errs by 0.02 mm
_OUTLINE_STEP = 0.12  # mm; the run then ends within 0.1 mm of where finer steps take it


@dataclass(frozen=True, kw_only=True)
class Task:
    """What is wanted, and of what.

    Attributes:
        lift: the lift wanted by motor position.
        follower: the rod and the faces.
        car: its dimensions.
        length: travel of the drive wheel in one turn of the cam, mm.
        aim: share of its own sum of deflection errors that smoothing takes off.
        start: where runs begin.
    """

    lift: LiftCurve
    follower: Follower
    car: Car
    length: float
    aim: float
    start: Pose

    def planned(self) -> Run:
        """The run that is wanted."""
        return self.run(self.lift, 0.0)

    def run(self, lift: LiftCurve, play: float, *, least: float = LEAST_SWING) -> Run:
        """The run that a cam gives with play; `least` as in `drive`."""
        stop = self.lift.blend_start
        return drive(lift, self.car, self.length, play=play, start=self.start, stop=stop, least=least)


@dataclass(frozen=True, kw_only=True)
class Judged:
    """A method on a train, and what its profile does.

    Attributes:
        profile: one of `PROFILES`.
        train: its name.
        play: return error that the profile is cut for, rad.
        lift: that it was cut from.
        cut: the profile.
        rolled: lift that the rod gets on it, without play.
        events: of the lift, with their deflection errors at the band's greatest play, as the paper reckons them.
        run: with that play, on the rolled profile.
        error: of that run.
        band: ends of such runs over the train's band.
        lift_error: lift with play beyond the lift wanted along the run, shape (n,), mm.
    """

    profile: str
    train: str
    play: float
    lift: LiftCurve
    cut: ActualProfile
    rolled: LiftCurve
    events: tuple[Event, ...]
    run: Run
    error: RunError
    band: BandResult
    lift_error: Array

    @property
    def name(self) -> str:
        """Profile and train."""
        return f"{self.profile}, {self.train}"

    @property
    def worst_lift_error(self) -> float:
        """Greatest difference of the lift with play from the lift wanted, mm."""
        return float(np.abs(self.lift_error).max())

    @property
    def deflection_sum(self) -> float:
        """Cumulative deflection error of the events, rad."""
        return deflection_sum(self.events)


def play_to_cut_for(task: Task, band: PlayBand) -> float:
    """The measured play, or else the one that makes the worst end of the run over the band least, rad.

    Raises:
        DesignError: the lift has no events, or a play of the band does not fit them.
    """
    if band.measured is not None:
        return band.measured
    return best_for_band(task.lift, task.follower, task.car, task.length, band.ends).made_for


def judge(
    task: Task, train: str, band: PlayBand, profiles: Sequence[str] = PROFILES, *, play: float | None = None
) -> tuple[Judged, ...]:
    """Make profiles for a train and let the car run on them.

    Args:
        task: what is wanted.
        train: its name.
        band: its return error.
        profiles: some of `PROFILES`.
        play: to cut them for, rad; `play_to_cut_for` if left out.

    Raises:
        DesignError: the lift has no events, a play of the band does not fit them, or a method cannot be used.
    """
    cut_for = play_to_cut_for(task, band) if play is None else play
    planned = task.planned()
    return tuple(
        _judged(task, profile, train, cut_for, band, planned, lift)
        for profile, lift in _lifts(task, cut_for, band.ends[1], profiles).items()
    )


def bound(task: Task, band: PlayBand) -> Bound:
    """What the worst end of the run over the band is at least, whatever the profile; see `fixed_profile_bound`."""
    return fixed_profile_bound(task.lift, task.car, task.length, band.ends)


def _lifts(task: Task, play: float, greatest: float, profiles: Sequence[str]) -> dict[str, LiftCurve]:
    lifts = {"actual": task.lift}
    if any(name.startswith("smoothed") for name in profiles):
        lifts["smoothed"] = smooth_to(task.lift, task.follower, task.car, task.length, greatest, aim=task.aim)
    for name, base in (("compensated", "actual"), ("smoothed+compensated", "smoothed")):
        if name in profiles:
            lifts[name] = compensated_lift(lifts[base], task.follower, play)
    return {name: lifts[name] for name in profiles}


def _judged(task: Task, profile: str, train: str, play: float, band: PlayBand, planned: Run, lift: LiftCurve) -> Judged:
    cut = actual_profile(lift, task.follower)
    stations = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    contact = roll(cut.curve.outline(_OUTLINE_STEP), task.follower, stations)
    rolled = rolled_lift(contact, blend_start=task.lift.blend_start)
    run = task.run(rolled, play)
    wanted, got = (task.follower.lift(tangents) for tangents in (planned.tan_beta, run.tan_beta))
    plays = np.linspace(*band.ends, BAND_PLAYS)
    return Judged(
        profile=profile,
        train=train,
        play=play,
        lift=lift,
        cut=cut,
        rolled=rolled,
        events=deflections(lift, task.follower, task.car, task.length, band.ends[1]),
        run=run,
        error=run_error(run, planned),
        band=over_band(rolled, task.lift, task.car, task.length, plays, play),
        lift_error=got - wanted,
    )
