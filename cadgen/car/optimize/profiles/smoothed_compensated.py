"""The smoothed profile, compensated for the play that is best for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.car.optimize.profiles.profile import CutLift, Profile

if TYPE_CHECKING:
    from cadgen.car.optimize.task import TrainTask


def _lift(work: TrainTask) -> CutLift:
    from cadgen.car.optimize.compensation import compensated_lift

    window = work.window_of(work.smoothed)
    return CutLift(compensated_lift(work.smoothed, work.task.follower, window), window)


SMOOTHED_COMPENSATED = Profile(code="smoothed+compensated", meaning="both", for_play=True, lift=_lift, dilated=True)
