"""A roller that an arm on a car's fork pushes straight out from the camshaft: s = l tan(beta)."""

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from annotated_types import Gt, Le

from cadgen.cam.follower import LossRemedy
from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.round_follower import RoundFollower
from cadgen.laws.unit import TAN


@dataclass(frozen=True, kw_only=True)
class SlidingRoller(RoundFollower):
    base_radius: float
    radius: float
    arm: float

    noun = "roller"
    milder = "lower follower.radius_mm or raise cam.base_radius_mm"
    unit = TAN

    @property
    def planes(self):
        return (self.arm,)

    @property
    def reach(self):
        return self.radius

    def lift(self, q):
        return self.arm * q

    def of_lift(self, lift):
        return lift / self.arm, np.full_like(lift, self.arm), np.full_like(lift, np.inf)

    def centre(self, q, q1, q2):
        return self.base_radius + self.arm * q + 0j, self.arm * q1 + 0j, self.arm * q2 + 0j

    def point(self):
        return replace(self, radius=0.0)

    def remedies(self):
        return (
            LossRemedy("follower.radius_mm", self.radius, False, lambda value: replace(self, radius=value)),
            LossRemedy("cam.base_radius_mm", self.base_radius, True, lambda value: replace(self, base_radius=value)),
        )

    def least(self, x, y):
        half = np.sqrt(np.maximum(self.radius**2 - y**2, 0.0))
        return (np.where(np.abs(y) < self.radius, (x - self.base_radius + half) / self.arm, -np.inf),)

    def most(self, x, y, off):
        return self.least(x + off, np.maximum(np.abs(y) - off, 0.0))

    def pressure_angle(self, q, across):
        return np.arcsin(np.clip(across / self.radius, -1.0, 1.0))


@dataclass(frozen=True, kw_only=True)
class SlidingRollerKeys:
    radius_mm: Annotated[float, Gt(0), Le(100), "of the roller"]
    arm_mm: Annotated[float, Gt(0), Le(500), "fork axis to the pin that moves the slide"]


def refuse(keys, seat):
    if keys.radius_mm >= seat.base_radius:
        raise ValueError(
            f"follower.radius_mm is {keys.radius_mm:g}; it must be less than cam.base_radius_mm, {seat.base_radius:g}: "
            "lower it"
        )


SLIDING_ROLLER = FollowerKind(
    code="sliding_roller",
    meaning="A roller on a slide that an arm on the fork moves straight out from the camshaft.",
    keys=SlidingRollerKeys,
    build=lambda keys, seat: SlidingRoller(base_radius=seat.base_radius, radius=keys.radius_mm, arm=keys.arm_mm),
    unit=TAN,
    refuse=refuse,
)
