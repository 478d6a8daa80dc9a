"""The kinds of roller and knife edge on a slide: their keys and what they must keep. Numerics come when it is built."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, copysign, floor, sqrt
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Gt, Le

from cadgen.cam.followers.closure import (
    CLEARANCE,
    CLOSURE,
    DEPTH,
    Closure,
    SecondOnSlide,
    groove_with,
    refuse_groove,
    refuse_parts_of_closures,
)
from cadgen.cam.followers.kind import FollowerKind, FollowerSeat
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.cam.followers.roller import Knife, Roller, SecondRoller
    from cadgen.laws.motion import Motion

_OFFSET = (
    "distance of the slide's line from the camshaft; positive lessens the pressure angle of the rise, and raises that "
    "of the return"
)


@dataclass(frozen=True, kw_only=True)
class RollerKeys:
    """Keys of a design's roller on a slide, as in its file."""

    radius_mm: Annotated[float, Ge(0.05), Le(500), "of the roller"]
    offset_mm: Annotated[float, Ge(-500), Le(500), _OFFSET] = 0.0
    closure: Annotated[Closure | None, CLOSURE] = None
    clearance_mm: Annotated[float | None, Ge(0), Le(50), CLEARANCE] = None
    depth_mm: Annotated[float | None, Gt(0), Le(500), DEPTH] = None
    second: Annotated[SecondOnSlide | None, "second roller of a conjugate pair"] = None

    def __post_init__(self) -> None:
        refuse_parts_of_closures(
            self.closure, self.second, {"clearance_mm": self.clearance_mm, "depth_mm": self.depth_mm}
        )


@dataclass(frozen=True, kw_only=True)
class KnifeKeys:
    """Keys of a design's knife edge on a slide, as in its file."""

    offset_mm: Annotated[float, Ge(-500), Le(500), _OFFSET] = 0.0


def refuse_offset(offset: float, prime_radius: float) -> None:
    """Refuse a slide whose line passes the camshaft farther off than the follower's centre stands from it.

    Args:
        offset: distance of the line from the camshaft, mm.
        prime_radius: distance of the centre from the camshaft at lift 0, mm.

    Raises:
        ValueError: it is so.
    """
    if abs(offset) >= prime_radius:
        raise ValueError(
            Message(
                "follower.offset_mm is {offset:g}; its size must be less than the prime radius of {prime:g} mm, at "
                "which the follower's centre stands at lift 0: set it to {half:g} or less, or raise "
                "cam.base_circle_radius_mm",
                offset=offset,
                prime=prime_radius,
                half=copysign(floor(prime_radius * 5) / 10, offset),
            )
        )


def _roller(keys: RollerKeys, seat: FollowerSeat) -> Roller:
    from cadgen.cam.followers.roller import Roller

    return Roller(base=seat.base_radius, radius=keys.radius_mm, offset=keys.offset_mm)


def _second(keys: RollerKeys, seat: FollowerSeat) -> SecondRoller | None:
    from cadgen.cam.followers.roller import SecondRoller

    if keys.second is None:
        return None
    return SecondRoller.across(_roller(keys, seat), keys.second.radius_mm, keys.second.span_mm, keys.second.offset_mm)


def _refuse_roller(keys: RollerKeys, seat: FollowerSeat) -> None:
    refuse_offset(keys.offset_mm, seat.base_radius + keys.radius_mm)
    if keys.clearance_mm is not None and keys.depth_mm is not None:
        refuse_groove(keys.clearance_mm, keys.radius_mm, keys.depth_mm, seat.faces)
    if keys.second is not None:
        ahead = sqrt((seat.base_radius + keys.radius_mm) ** 2 - keys.offset_mm**2)
        least = ahead + sqrt(max(keys.second.radius_mm**2 - keys.second.offset_mm**2, 0.0))
        if keys.second.span_mm <= least:
            raise ValueError(
                Message(
                    "follower.second.span_mm is {span:g}; the second roller would cover the camshaft at lift 0, so "
                    "nothing is left of its disc: set it to {wide:g} or more",
                    span=keys.second.span_mm,
                    wide=ceil(max(2 * ahead, least + ahead) * 10) / 10,
                )
            )


def _knife(keys: KnifeKeys, seat: FollowerSeat) -> Knife:
    from cadgen.cam.followers.roller import Knife

    return Knife(base=seat.base_radius, offset=keys.offset_mm)


def _least_base(offset: float, radius: float, motion: Motion, angle: float) -> float:
    from cadgen.cam.sizing import SlideSizes

    return SlideSizes(motion, angle, angle).least_prime_radius(offset) - radius


ROLLER = FollowerKind(
    code="roller",
    meaning="A roller on a slide that moves straight out from the camshaft, in line with it or beside it.",
    keys=RollerKeys,
    build=_roller,
    least_base=lambda keys, motion, angle: _least_base(keys.offset_mm, keys.radius_mm, motion, angle),
    second=_second,
    groove=groove_with(_roller),
    refuse=_refuse_roller,
)
KNIFE = FollowerKind(
    code="knife",
    meaning="A knife edge on such a slide: it wears, and is for toys and for teaching.",
    keys=KnifeKeys,
    build=_knife,
    least_base=lambda keys, motion, angle: _least_base(keys.offset_mm, 0.0, motion, angle),
    refuse=lambda keys, seat: refuse_offset(keys.offset_mm, seat.base_radius),
)
