"""A profile: its code, its purpose, the lift that it is cut for, and the curve that gives this lift."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import Follower
    from cadgen.car.optimize.task import TrainTask
    from cadgen.car.path_motion import PathMotion


@dataclass(frozen=True)
class CutLift:
    """A lift that a profile is cut for.

    Attributes:
        lift: lift by cam angle.
        made_for: width of the window by which the lift is dilated, rad: the play that it is cut for, or with friction
            the closest to it. For a lift that is not dilated, the width for `compensated`.
    """

    lift: PathMotion
    made_for: float


def wanted_lift(work: TrainTask) -> CutLift:
    """The planned lift as it is."""
    return CutLift(work.task.lift, work.window)


def envelope(lift: PathMotion, follower: Follower) -> ActualProfile:
    """The exact envelope of the follower.

    Raises:
        DesignError: as `cadgen.cam.envelope.actual_profile`.
    """
    from cadgen.cam.envelope import actual_profile

    return actual_profile(lift, follower)


@dataclass(frozen=True, kw_only=True)
class Profile:
    """A profile that a cam can have.

    Attributes:
        code: name on the command line, in design files and in the names of exported files.
        meaning: meaning of the profile, in a clause for the help.
        for_play: whether the profile acts against the play of the gears, and so depends on it.
        best_of: whether it is the best of the profiles that `table.compared` lists; `lift` and `curve` are those of the
            best.
        lift: function that gives the lift that the profile is cut for.
        curve: function that gives the curve for a lift and a follower.
        dilated: whether its lift is dilated by the play.
        by_axis: whether the curve is for the reference point of the follower, such as the rod's axis, and not for the
            follower itself.
        gives_lift: whether a follower that rolls on the curve gets the lift that it is cut for.
        note: warning for the workshop in the program of its machine; empty if there is none.
    """

    code: str
    meaning: str
    for_play: bool = False
    best_of: bool = False
    lift: Callable[[TrainTask], CutLift] = wanted_lift
    curve: Callable[[PathMotion, Follower], ActualProfile] = envelope
    dilated: bool = False
    by_axis: bool = False
    gives_lift: bool = True
    note: str = ""

    def __str__(self) -> str:
        return self.code
