"""Kinds of profile that a cam can have: code, purpose, the lift that each is cut for, and the curve that gives it.

A new kind is an entry below, or is registered from outside. What is computed is imported only when it is: the module is
light, for commands that only name profiles.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from cadgen.errors import DesignError
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import Follower
    from cadgen.car.against_play.compensation import CutLift
    from cadgen.car.against_play.play_task import TrainTask
    from cadgen.laws.motion import Motion


def wanted_lift(work: TrainTask) -> CutLift:
    """Planned lift as it is."""
    return work.cut_as(work.task.lift)


def envelope(lift: Motion, follower: Follower) -> ActualProfile:
    """The exact envelope of the follower.

    Raises:
        DesignError: as `cadgen.cam.envelope.actual_profile`.
    """
    from cadgen.cam.envelope import actual_profile

    return actual_profile(lift, follower)


@dataclass(frozen=True, kw_only=True)
class ProfileKind:
    """Kind of profile that a cam can have.

    Attributes:
        code: name on the command line, in design files and in the names of exported files.
        meaning: meaning of the profile, in a clause for the help.
        for_play: whether the profile acts against the play of the gears, and so depends on it.
        best_of: whether it is the best of the profiles that `compared` lists; `lift` and `curve` are those of the
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
    curve: Callable[[Motion, Follower], ActualProfile] = envelope
    dilated: bool = False
    by_axis: bool = False
    gives_lift: bool = True
    note: str = ""

    def __str__(self) -> str:
        return self.code

    def __reduce__(self) -> tuple[object, ...]:
        # By its code: its functions may have no names, and code that asks whether a kind is this one goes on to work.
        return profile_of, (self.code,)

    def rolling(self, follower: Follower) -> Follower:
        """Follower that rolls on a profile of this kind: the cam's own, or its reference point."""
        return follower.point() if self.by_axis else follower


def _axis_curve(lift: Motion, follower: Follower) -> ActualProfile:
    from cadgen.cam.envelope import ActualProfile

    pitch = follower.pitch_curve(lift)
    if pitch is None:
        raise DesignError(
            "follower.kind names a {noun}, which has no axis: its theoretical profile does not exist, "
            "take --profile actual",
            noun=follower.noun,
        )
    return ActualProfile(pitch, ())


def _published_curve(lift: Motion, follower: Follower) -> ActualProfile:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import edge_follower
    from cadgen.cam.followers.rod import published_profile

    rod = edge_follower(follower, Message("the formula of the paper"), Message("take --profile actual"))
    return ActualProfile(published_profile(lift, rod), ())


ACTUAL = ProfileKind(code="actual", meaning="the exact envelope of the follower")
OPTIMIZED = ProfileKind(
    code="optimized",
    meaning="the best against the gears' play, of actual and all that are cut for it",
    for_play=True,
    best_of=True,
)
COMPENSATED = ProfileKind(
    code="compensated",
    meaning="cut so that the play takes itself out",
    for_play=True,
    lift=lambda work: work.compensated,
    dilated=True,
)
SMOOTHED = ProfileKind(
    code="smoothed",
    meaning="the paper's",
    for_play=True,
    lift=lambda work: work.cut_as(work.smoothed),
)
SMOOTHED_COMPENSATED = ProfileKind(
    code="smoothed+compensated",
    meaning="both",
    for_play=True,
    lift=lambda work: work.compensated_of(work.smoothed),
    dilated=True,
)
THEORETICAL = ProfileKind(
    code="theoretical",
    meaning="the rod's axis",
    curve=_axis_curve,
    by_axis=True,
    note="NOT THE OUTLINE OF A PART TO USE: this is the curve of the rod's axis",
)
PUBLISHED = ProfileKind(
    code="published",
    meaning="the paper's formula",
    curve=_published_curve,
    gives_lift=False,
    note="NOT THE OUTLINE OF A PART TO USE: this is the paper's formula, for comparison",
)

_CODE = re.compile(r"[a-z0-9]+([+_-][a-z0-9]+)*")  # it stands in the names of files
_PROFILES: dict[str, ProfileKind] = {}


def register(profile: ProfileKind) -> None:
    """Add a profile to the table, under its code.

    Raises:
        DesignError: the code is taken, or cannot stand in the name of a file.
    """
    if profile.code in _PROFILES:
        raise DesignError('there is a profile "{code}" already: choose another code', code=profile.code)
    if not _CODE.fullmatch(profile.code):
        raise DesignError(
            '"{code}" cannot be the code of a profile: take small letters, digits and single +, - or _ between',
            code=profile.code,
        )
    _PROFILES[profile.code] = profile


def codes(*, for_play: bool = False) -> tuple[str, ...]:
    """Codes of the profiles that can be chosen."""
    return tuple(profile.code for profile in _PROFILES.values() if profile.for_play or not for_play)


def compared() -> tuple[ProfileKind, ...]:
    """Profiles among which the best is chosen: the actual profile, then all that are cut for play."""
    return (ACTUAL, *(profile for profile in _PROFILES.values() if profile.for_play and not profile.best_of))


def profile_of(code: str) -> ProfileKind:
    """The profile with a code.

    Raises:
        DesignError: no profile has the code.
    """
    if not isinstance(code, str) or code not in _PROFILES:
        raise DesignError(
            'there is no profile "{code}": choose one of {profiles}', code=code, profiles=", ".join(_PROFILES)
        )
    return _PROFILES[code]


def meanings() -> Message:
    """Every profile and its meaning, in one line."""
    return joined(
        (
            Message("{profile}: {meaning}", profile=profile.code, meaning=Message(profile.meaning))
            for profile in _PROFILES.values()
        ),
        "; ",
    )


for _profile in (ACTUAL, OPTIMIZED, COMPENSATED, SMOOTHED, SMOOTHED_COMPENSATED, THEORETICAL, PUBLISHED):
    register(_profile)
