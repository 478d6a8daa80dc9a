"""A kind of follower: its code, its keys of the design file, and the follower that they make."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

from cadgen.cam.limits import PressureAngleLimitName
from cadgen.laws.unit import MM, Unit

if TYPE_CHECKING:
    from cadgen.cam.follower import Follower
    from cadgen.cam.followers.groove import GrooveRollers
    from cadgen.laws.motion import Motion


class RunningSurface(StrEnum):
    """Surface of a follower where the disc touches it."""

    STEEL = "steel"
    BALL_BEARING = "ball_bearing"


class FollowerGuide(StrEnum):
    """Way in which a follower is guided: on a slide, or on an arm with a pivot."""

    TRANSLATING = "translating"
    OSCILLATING = "oscillating"


@dataclass(frozen=True, kw_only=True)
class FollowerSeat:
    """Disc and place that a follower is built on, mm.

    Attributes:
        base_radius: radius of the base circle, where the motion is 0; of a follower on a car's fork the distance of
            the camshaft from the fork axis.
        faces: heights of the disc's faces; of a follower on a car's fork their distances from the fork axis, the
            nearer one first.
        carrying: the same of the edges of the land between broken edges; the faces, if those are sharp.
    """

    base_radius: float
    faces: tuple[float, float]
    carrying: tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class FollowerKind:
    """A kind of follower.

    Attributes:
        code: value of `follower.kind` in the design file.
        meaning: sentence for the reference.
        keys: frozen dataclass of its keys, named as in the file, each `Annotated` with its limits and with a phrase
            for the reference; its `__post_init__` may refuse what contradicts itself by a `ValueError`, one sentence
            for the user.
        build: function of keys and seat that returns the follower as designed; `follower` calls it.
        unit: unit of its motion: lift in mm, swing in rad, or tangent of a car's steering angle.
        runs: whether it may run on the disc with a ball bearing: its keys then have `material`, a `RunningSurface`, and
            `width_mm` of the bearing, either None where the file does not say.
        guide: how it is guided; left out, on a slide if its motion is in mm, else on a pivoted arm.
        least_base: function of keys, motion and pressure angle, rad, that returns the least base circle that keeps
            that angle, mm; None for a kind without one.
        second: function of keys and seat that returns the second follower of a conjugate pair, whose motion is the
            opposite one; None where the keys have none.
        groove: function of keys and seat that returns the rollers of a groove; None where the keys have none.
        refuse: function that refuses keys that do not suit their seat, by a `ValueError` of one sentence.
        explains: codes of checks of its own, each with a sentence for `cadgen explain`.
    """

    code: str
    meaning: str
    keys: type[Any]
    build: Callable[[Any, FollowerSeat], Follower]
    unit: Unit = MM
    runs: bool = False
    guide: FollowerGuide | None = None
    least_base: Callable[[Any, Motion, float], float] | None = None
    second: Callable[[Any, FollowerSeat], Follower | None] = lambda keys, seat: None
    groove: Callable[[Any, FollowerSeat], GrooveRollers | None] = lambda keys, seat: None
    refuse: Callable[[Any, FollowerSeat], None] = lambda keys, seat: None
    explains: tuple[tuple[str, str], ...] = ()

    def follower(self, keys: Any, seat: FollowerSeat) -> Follower:
        """Follower as designed, of which no member is missing.

        Args:
            keys: keys of the design file.
            seat: disc and place that it is built on.

        Raises:
            DesignError: it cannot be built, or lacks a member of `cadgen.cam.follower.Follower`.
        """
        from cadgen.cam.followers.probe import probed

        return probed(lambda: self.build(keys, seat), self.code, self.unit)

    @property
    def pressure_angle_limit(self) -> PressureAngleLimitName:
        """Limits of the pressure angle that a design has by default: Norton's for a slide, or for a pivoted arm."""
        straight = self.unit == MM if self.guide is None else self.guide == FollowerGuide.TRANSLATING
        name = PressureAngleLimitName
        return name.NORTON_TRANSLATING if straight else name.NORTON_OSCILLATING
