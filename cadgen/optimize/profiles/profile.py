"""A profile: its code, its purpose, the lift that it is cut for, and the curve that gives this lift."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import Follower
    from cadgen.cam.lift import LiftCurve
    from cadgen.optimize.task import TrainTask


@dataclass(frozen=True)
class CutLift:
    """A lift that a profile is cut for.

    Attributes:
        lift: lift by cam angle.
        made_for: width of the window by which the lift is dilated, rad: the play that it is cut for, or with friction
            the closest to it. For a lift that is not dilated, the width for `compensated`.
    """

    lift: LiftCurve
    made_for: float


def wanted_lift(work: TrainTask) -> CutLift:
    """The planned lift as it is."""
    return CutLift(work.task.lift, work.window)


def envelope(lift: LiftCurve, follower: Follower) -> ActualProfile:
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
        code: its name on the command line, in design files and in the names of exported files.
        meaning: what it is, in a clause for the help.
        for_play: whether it does something about the play of the gears, and so needs to know of it.
        best_of: whether it is the best of all the profiles that `table.compared` lists; `lift` and `curve` are theirs.
        lift: the lift that it is cut for.
        curve: the curve that gives the follower a lift.
        dilated: whether its lift is dilated by the play.
        by_axis: whether its curve is for the rod's axis, or another follower's reference point, and not for itself.
        gives_lift: whether what rolls on it gets the lift that it is cut for.
        note: what the workshop must be told in the program of its machine; empty if nothing.
    """

    code: str
    meaning: str
    for_play: bool = False
    best_of: bool = False
    lift: Callable[[TrainTask], CutLift] = wanted_lift
    curve: Callable[[LiftCurve, Follower], ActualProfile] = envelope
    dilated: bool = False
    by_axis: bool = False
    gives_lift: bool = True
    note: str = ""

    def __str__(self) -> str:
        return self.code
