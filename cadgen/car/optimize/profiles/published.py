"""The profile by the formula that the paper's appendix gives, for comparison."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.car.optimize.profiles.profile import Profile

if TYPE_CHECKING:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import Follower
    from cadgen.car.path_motion import PathMotion


def _curve(lift: PathMotion, follower: Follower) -> ActualProfile:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.followers.rod import rod_of
    from cadgen.cam.followers.rod_profiles import published_profile

    return ActualProfile(
        published_profile(lift, rod_of(follower, "the formula of the paper", "take --profile actual")), ()
    )


PUBLISHED = Profile(
    code="published",
    meaning="the paper's formula",
    curve=_curve,
    gives_lift=False,
    note="NOT THE OUTLINE OF A PART TO USE: this is the paper's formula, for comparison",
)
