"""The compensated profile: the lift dilated by the play, so that the play takes itself out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.car.optimize.profiles.profile import CutLift, Profile

if TYPE_CHECKING:
    from cadgen.car.optimize.task import TrainTask


def _lift(work: TrainTask) -> CutLift:
    from cadgen.car.optimize.compensation import compensated_lift

    return CutLift(compensated_lift(work.task.lift, work.task.follower, work.window), work.window)


COMPENSATED = Profile(
    code="compensated",
    meaning="cut so that the play takes itself out",
    for_play=True,
    lift=_lift,
    dilated=True,
)
