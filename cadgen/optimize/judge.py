"""Every method judged on the profile that it cuts: rolled on its outline, with play.

A method's lift is one thing; its profile, rolled by code that does not know the lift, is what the car gets.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import Contact, rolling_step
from cadgen.cam.envelope import ActualProfile, actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import ClosedCurve
from cadgen.deviations.as_built import AS_DESIGNED, AsBuilt
from cadgen.motion.drive import Pose, Run, drive
from cadgen.motion.errors import Event, RunError, deflection_sum, deflections, run_error
from cadgen.motion.mechanics import Mechanics, MechanicsBand
from cadgen.motion.play import LEAST_SWING, Following, follow
from cadgen.motion.sampled import rolled_lift
from cadgen.optimize.band import BAND_PLAYS, BandResult, Bound, PlayBand, best_for_band, fixed_profile_bound, over_band
from cadgen.optimize.compensation import compensated_lift
from cadgen.optimize.dilation import LostDip, lost_dips
from cadgen.optimize.smoothing import smooth_to
from cadgen.steering.car import Car

# A method is a profile and a train. The train enters as its return error alone: the paper's `reordered` train is a
# smaller one.
PROFILES = ("actual", "smoothed", "compensated", "smoothed+compensated")
STATIONS = 3600  # at which the rod is rolled; the run then errs by 0.02 mm
_OUTLINE_STEP = 0.03  # mm; the run then ends within 0.01 mm of where finer steps take it (0.06: 0.06, 0.12: 0.6)


@dataclass(frozen=True, kw_only=True)
class Task:
    """What is wanted, and of what.

    Attributes:
        lift: the lift wanted by motor position.
        follower: the rod and the faces.
        car: its dimensions.
        length: travel of the drive wheel's rim in one turn of the cam, mm.
        aim: share of its own sum of deflection errors that smoothing takes off.
        start: where runs begin.
        as_built: what else is known of the car: what becomes of a disc that is cut.
        mechanics: what is known of friction and drag; None where they are left out, as if the rod slid freely.
    """

    lift: LiftCurve
    follower: Follower
    car: Car
    length: float
    aim: float
    start: Pose
    as_built: AsBuilt = AS_DESIGNED
    mechanics: MechanicsBand | None = None

    def planned(self) -> Run:
        """The run that is wanted."""
        return self.run(self.lift, 0.0)

    def run(
        self,
        lift: LiftCurve,
        play: float,
        *,
        least: float = LEAST_SWING,
        cut: LiftCurve | None = None,
        mechanics: Mechanics | None = None,
    ) -> Run:
        """The run that a cam gives with play.

        Args:
            lift: that the rod gets.
            play: return error B, rad.
            least: as in `drive`.
            cut: lift that the cam was cut for; `lift` itself if left out.
            mechanics: friction and drag; those of the nominal car if left out.
        """
        following = self.following(lift, play, least=least, cut=cut, mechanics=mechanics)
        stop = self.lift.blend_start
        return drive(lift, self.car, self.length, start=self.start, stop=stop, following=following)

    def following(
        self,
        lift: LiftCurve,
        play: float,
        *,
        least: float = LEAST_SWING,
        cut: LiftCurve | None = None,
        mechanics: Mechanics | None = None,
    ) -> Following:
        """How a cam follows the motor; arguments as in `run`."""
        if mechanics is None and self.mechanics is not None:
            mechanics = self.mechanics.nominal
        if mechanics is None:
            return follow(lift, play, least=least)
        return mechanics.leads(cut or lift).follow(lift, play)


@dataclass(frozen=True, kw_only=True)
class Judged:
    """A method on a train, and what its profile does.

    Attributes:
        profile: one of `PROFILES`.
        train: its name.
        play: return error at which it is run, rad.
        made_for: width of the window by which a compensated profile is dilated, rad: the play that it is cut for, or
            what comes closest with friction. Of other profiles, that of `compensated`.
        lift: that it was cut from.
        cut: the profile wanted of the finished disc.
        made: the curve that is cut; `cut` itself unless the car's [as_built] asks for another.
        rolled: lift that the rod gets on it, without play.
        events: of the lift, with their deflection errors at the band's greatest play, as the paper reckons them.
        run: with that play, on the rolled profile.
        error: of that run.
        deviation: of the run without play: the path that the profile gives away, or needs play to keep.
        band: ends of such runs over the train's band.
        lift_error: lift with play beyond the lift wanted along the run, shape (n,), mm.
        least: rises and falls of tan(beta) on `rolled` that are smaller are no events.
        lost: dips of the lift wanted that are narrower than the play of a compensated profile.
        measured: True for the cam that was on the car when it was measured.
    """

    profile: str
    train: str
    play: float
    made_for: float
    lift: LiftCurve
    cut: ActualProfile
    made: ClosedCurve
    rolled: LiftCurve
    events: tuple[Event, ...]
    run: Run
    error: RunError
    deviation: RunError
    band: BandResult
    lift_error: Array
    least: float = LEAST_SWING
    lost: tuple[LostDip, ...] = ()
    measured: bool = False

    @property
    def name(self) -> str:
        """Profile and train."""
        return f"{self.profile}, {self.train}"

    @property
    def title(self) -> str:
        """As it is called in tables and pictures."""
        return f"cam as measured ({self.profile})" if self.measured else f"{self.profile} profile"

    @property
    def worst_lift_error(self) -> float:
        """Greatest difference of the lift with play from the lift wanted, mm."""
        return float(np.abs(self.lift_error).max())

    @property
    def deflection_sum(self) -> float:
        """Cumulative deflection error of the events, rad."""
        return deflection_sum(self.events)


def play_to_cut_for(task: Task, band: PlayBand, lift: LiftCurve | None = None) -> float:
    """The measured play, or else the one that makes the worst end of the run over the band least, rad.

    With friction it is the window of the dilation that does so over plays and frictions, also for a measured play.

    Args:
        task: what is wanted.
        band: return error of the train.
        lift: that is to be compensated; the one wanted if left out.

    Raises:
        DesignError: the band is not one.
    """
    ends, mechanics = band.ends, task.mechanics.corners if task.mechanics else ()
    if band.measured is not None:
        ends = band.measured, band.measured
        if not mechanics:
            return band.measured
    base = task.lift if lift is None else lift
    best = best_for_band(base, task.follower, task.car, task.length, ends, wanted=task.lift, mechanics=mechanics)
    return best.made_for


def _run_at(task: Task, band: PlayBand, made_for: float) -> float:
    """Return error of the run that a profile is judged by: the one it is cut for, or, with friction, the car's."""
    if task.mechanics is None:
        return made_for
    return sum(band.ends) / 2 if band.measured is None else band.measured


def judge(
    task: Task, train: str, band: PlayBand, profiles: Sequence[str] = PROFILES, *, made_for: float | None = None
) -> tuple[Judged, ...]:
    """Make profiles for a train and let the car run on them.

    Args:
        task: what is wanted.
        train: its name.
        band: its return error.
        profiles: some of `PROFILES`. Each compensated one is cut for the play that is best for it; the others run
            at the play of `compensated`.
        made_for: of `compensated`, if it is known already, rad; `play_to_cut_for` if left out.

    Raises:
        DesignError: the band is not one, or a method cannot be used.
    """
    cut_for = play_to_cut_for(task, band) if made_for is None else made_for
    planned = task.planned()
    return tuple(
        _judged(task, _Method(profile, train, _run_at(task, band, own), own, lift), band, planned)
        for profile, (own, lift) in _lifts(task, cut_for, band, profiles).items()
    )


def bound(task: Task, band: PlayBand) -> Bound:
    """What the worst end of the run over the band is at least with these peaks and valleys: `fixed_profile_bound`."""
    return fixed_profile_bound(task.lift, task.car, task.length, band.ends)


def _lifts(task: Task, play: float, band: PlayBand, profiles: Sequence[str]) -> dict[str, tuple[float, LiftCurve]]:
    """Each profile's play and lift."""
    found = {"actual": (play, task.lift)}
    if any(name.startswith("smoothed") for name in profiles):
        smoothed = smooth_to(task.lift, task.follower, task.car, task.length, band.ends[1], aim=task.aim)
        found["smoothed"] = play, smoothed
        if "smoothed+compensated" in profiles:
            own = play_to_cut_for(task, band, smoothed)
            found["smoothed+compensated"] = own, compensated_lift(smoothed, task.follower, own)
    if "compensated" in profiles:
        found["compensated"] = play, compensated_lift(task.lift, task.follower, play)
    return {name: found[name] for name in profiles}


def judge_measured(task: Task, profile: str, train: str, band: PlayBand, lift: LiftCurve, made: ClosedCurve) -> Judged:
    """Let the car as built run on the cam that it was measured with.

    Args:
        task: what is wanted.
        profile: of that cam.
        train: in the car.
        band: its return error.
        lift: that the cam was made for.
        made: what was cut.

    Raises:
        DesignError: as `judge`.
    """
    contact = task.as_built.roll_measured(made, task.follower, _stations(), _step(made, task))
    own = play_to_cut_for(task, band)
    method = _Method(profile, train, _run_at(task, band, own), own, lift)
    return _judgement(task, _Cam(method, ActualProfile(made, ()), made, contact, measured=True), band, task.planned())


@dataclass(frozen=True)
class _Method:
    """A profile, its train, and the lift that it is cut for; as in `Judged`."""

    profile: str
    train: str
    play: float
    made_for: float
    lift: LiftCurve


@dataclass(frozen=True)
class _Cam:
    """A cam before its run; as in `Judged`, with the rod's contact on the finished disc."""

    method: _Method
    cut: ActualProfile
    made: ClosedCurve
    contact: Contact
    measured: bool = False


def _judged(task: Task, method: _Method, band: PlayBand, planned: Run) -> Judged:
    cut = actual_profile(method.lift, task.follower)
    made = task.as_built.precompensated(cut.curve)
    contact = task.as_built.roll_new(made, task.follower, _stations(), _step(made, task))
    return _judgement(task, _Cam(method, cut, made, contact), band, planned)


def _lost(task: Task, cam: _Cam) -> tuple[LostDip, ...]:
    if not cam.method.profile.endswith("compensated") or cam.measured:
        return ()
    return tuple(dip for dip in lost_dips(task.lift, cam.method.made_for) if dip.whole)


def _step(made: ClosedCurve, task: Task) -> float:
    return rolling_step(made, task.follower, _OUTLINE_STEP)


def _stations() -> Array:
    return np.linspace(0.0, TURN, STATIONS, endpoint=False)


def _judgement(task: Task, cam: _Cam, band: PlayBand, planned: Run) -> Judged:
    method = cam.method
    rolled = rolled_lift(cam.contact, method.lift, blend_start=task.lift.blend_start)
    least = max(LEAST_SWING, task.as_built.unevenness(measured=cam.measured) / task.follower.inner)
    run = task.run(rolled, method.play, least=least, cut=method.lift)
    wanted, got = (task.follower.lift(tangents) for tangents in (planned.tan_beta, run.tan_beta))
    return Judged(
        profile=method.profile,
        train=method.train,
        play=method.play,
        made_for=method.made_for,
        lift=method.lift,
        cut=cam.cut,
        made=cam.made,
        rolled=rolled,
        events=deflections(method.lift, task.follower, task.car, task.length, band.ends[1]),
        run=run,
        error=run_error(run, planned),
        deviation=run_error(task.run(rolled, 0.0, least=least), planned),
        band=over_band(
            rolled,
            task.lift,
            task.car,
            task.length,
            np.linspace(*band.ends, BAND_PLAYS),
            method.made_for,
            least=least,
            mechanics=task.mechanics.cases if task.mechanics else (),
            cut=method.lift,
        ),
        lift_error=got - wanted,
        least=least,
        lost=_lost(task, cam),
        measured=cam.measured,
    )
