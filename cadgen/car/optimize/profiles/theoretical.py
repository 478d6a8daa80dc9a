"""The theoretical profile: the curve of the rod's axis, or of another follower's reference point."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.car.optimize.profiles.profile import Profile

if TYPE_CHECKING:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.cam.follower import Follower
    from cadgen.car.path_motion import PathMotion


def _curve(lift: PathMotion, follower: Follower) -> ActualProfile:
    from cadgen.cam.envelope import ActualProfile
    from cadgen.errors import DesignError

    pitch = follower.pitch_curve(lift)
    if pitch is None:
        raise DesignError(
            f"follower.kind names a {follower.noun}, which has no axis: its theoretical profile does not exist, take "
            "--profile actual"
        )
    return ActualProfile(pitch, ())


THEORETICAL = Profile(
    code="theoretical",
    meaning="the rod's axis",
    curve=_curve,
    by_axis=True,
    note="NOT THE OUTLINE OF A PART TO USE: this is the curve of the rod's axis",
)
