"""The methods against play by name, alone and combined, and what each does to the run.

A method is a profile and a train. The profile is `actual` (the planned lift as it is), `smoothed` (the paper's),
`compensated`, or `smoothed+compensated`. The train enters as its return error alone: the paper's `reordered` train is
a smaller one.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.errors import DesignError
from cadgen.motion.drive import Run, drive
from cadgen.motion.errors import Event, RunError, deflection_sum, deflections, run_error
from cadgen.optimize.compensation import compensated_lift
from cadgen.optimize.smoothing import PAPER_AIM, smooth_to
from cadgen.steering.car import Car

PROFILES = ("actual", "smoothed", "compensated", "smoothed+compensated")


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """What a profile does with a train.

    Attributes:
        profile: one of `PROFILES`.
        train: the train's name.
        play: its return error B, rad.
        lift: of the cam.
        events: of the lift, with the deflection errors of eq. 28 and 30. On a compensated cam the skipped and
            repeated parts are meant to be, and only the run tells the error.
        run: with play.
        error: of that run against the planned one.
        deviation: of the run without play against the planned one: the path that the profile gives away.
    """

    profile: str
    train: str
    play: float
    lift: LiftCurve
    events: tuple[Event, ...]
    run: Run
    error: RunError
    deviation: RunError

    @property
    def deflection_sum(self) -> float:
        """Cumulative deflection error of the events, rad."""
        return deflection_sum(self.events)


@dataclass(frozen=True, kw_only=True)
class Gain:
    """Shares that a method takes off another's errors: 1 is all, 0 nothing, below 0 a loss."""

    deflection: float
    heading: float
    distance: float


def profile_lift(
    profile: str, lift: LiftCurve, follower: Follower, car: Car, length: float, play: float, *, aim: float = PAPER_AIM
) -> LiftCurve:
    """Lift of the cam that a method asks for.

    Args:
        profile: one of `PROFILES`.
        lift: the lift wanted.
        follower: the rod and the faces.
        car: its dimensions.
        length: travel of the drive wheel in one turn of the cam, mm.
        play: return error B that the method reckons with, rad.
        aim: share of its own sum of deflection errors that smoothing takes off.

    Raises:
        DesignError: no profile of that name, or the method does not work for this lift and play.
    """
    if profile not in PROFILES:
        raise DesignError(f"there is no profile named {profile}; use one of {', '.join(PROFILES)}")
    if profile.startswith("smoothed"):
        lift = smooth_to(lift, follower, car, length, play, aim=aim)
    return compensated_lift(lift, follower, play) if profile.endswith("compensated") else lift


def compare(
    lift: LiftCurve, follower: Follower, car: Car, length: float, trains: Mapping[str, float], *, aim: float = PAPER_AIM
) -> tuple[Outcome, ...]:
    """Every profile with every train.

    Args:
        lift: the lift wanted.
        follower: the rod and the faces.
        car: its dimensions.
        length: travel of the drive wheel in one turn of the cam, mm.
        trains: name -> return error B, rad.
        aim: share of its own sum of deflection errors that smoothing takes off.

    Raises:
        DesignError: the lift has no events, or a play does not fit them.
    """
    planned = drive(lift, car, length)
    outcomes = []
    for train, play in trains.items():
        for profile in PROFILES:
            cam = profile_lift(profile, lift, follower, car, length, play, aim=aim)
            run = drive(cam, car, length, play=play, stop=lift.blend_start)
            outcomes.append(
                Outcome(
                    profile=profile,
                    train=train,
                    play=play,
                    lift=cam,
                    events=deflections(cam, follower, car, length, play),
                    run=run,
                    error=run_error(run, planned),
                    deviation=run_error(drive(cam, car, length, stop=lift.blend_start), planned),
                )
            )
    return tuple(outcomes)


def gain(outcome: Outcome, reference: Outcome) -> Gain:
    """What a method takes off the errors of another, such as the actual profile with the train as designed."""
    return Gain(
        deflection=1 - outcome.deflection_sum / reference.deflection_sum,
        heading=1 - abs(outcome.error.end_heading / reference.error.end_heading),
        distance=1 - outcome.error.end_distance / reference.error.end_distance,
    )
