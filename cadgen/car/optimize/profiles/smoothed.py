"""The paper's smoothed profile: peaks and valleys brought nearer to each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.car.optimize.profiles.profile import CutLift, Profile

if TYPE_CHECKING:
    from cadgen.car.optimize.task import TrainTask


def _lift(work: TrainTask) -> CutLift:
    return CutLift(work.smoothed, work.window)


SMOOTHED = Profile(code="smoothed", meaning="the paper's", for_play=True, lift=_lift)
