"""The theoretical profile: the curve of the rod's axis."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.optimize.profiles.profile import Profile

if TYPE_CHECKING:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import Follower
    from cadgen.cam.lift import LiftCurve


def _curve(lift: LiftCurve, follower: Follower) -> ActualProfile:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.theoretical import theoretical_profile

    return ActualProfile(theoretical_profile(lift, follower), ())


THEORETICAL = Profile(
    code="theoretical",
    meaning="the rod's axis",
    curve=_curve,
    by_axis=True,
    note="NOT THE OUTLINE OF A PART TO USE: this is the curve of the rod's axis",
)
