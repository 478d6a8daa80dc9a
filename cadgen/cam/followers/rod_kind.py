"""The kind of the leaning rod: its keys of the design file and what they must keep. Numerics come when it is built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Gt, Le

from cadgen.cam.followers.kind import FollowerKind, FollowerSeat, RunningSurface
from cadgen.laws.unit import TAN
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.cam.followers.rod import LeaningRod

# A rod this many times as long as the outer face is far reaches past it up to some 55 degrees of steering.
_DEFAULT_REACH = 2.0


@dataclass(frozen=True, kw_only=True)
class RodKeys:
    """Keys of a design's rod, as in its file."""

    radius_mm: Annotated[
        float,
        Ge(0.05),
        Le(100),
        "r_t, of the rod: half its diameter; a thinner one would bend, and is not followed",
    ]
    length_mm: Annotated[
        float | None, Gt(0), Le(2000), "fork axis to the rod's end; left out, twice the distance of the outer face"
    ] = None
    material: Annotated[
        RunningSurface | None,
        "of the rod; or a ball bearing on it, whose outer radius is then `radius_mm`: it rolls, with friction below "
        "0.02",
    ] = None
    width_mm: Annotated[
        float | None, Gt(0), Le(500), "of a ball bearing, which must span all places at which it touches"
    ] = None

    def __post_init__(self) -> None:
        if self.width_mm is not None and self.material != RunningSurface.BALL_BEARING:
            raise ValueError(
                Message(
                    'follower.width_mm is the width of a ball bearing: set follower.material = "ball_bearing", or '
                    "remove it"
                )
            )


def _build(keys: RodKeys, seat: FollowerSeat) -> LeaningRod:
    from cadgen.cam.followers.rod import LeaningRod

    inner, outer = seat.carrying
    length = _DEFAULT_REACH * seat.faces[1] if keys.length_mm is None else keys.length_mm
    return LeaningRod(base_radius=seat.base_radius, inner=inner, outer=outer, radius=keys.radius_mm, length=length)


def _refuse(keys: RodKeys, seat: FollowerSeat) -> None:
    inner, outer = seat.faces
    # A face nearer than this the rod cannot swing clear of (the divisor w^2 - h^2 in `cadgen.cam.followers.rod`).
    if keys.radius_mm >= inner:
        raise ValueError(
            Message(
                "follower.radius_mm is {radius:g}; it must be less than the distance of the disc's inner face from the "
                "fork axis, {inner:g} mm: lower it, or move the disc outwards",
                radius=keys.radius_mm,
                inner=inner,
            )
        )
    if keys.radius_mm >= seat.base_radius:
        raise ValueError(
            Message(
                "follower.radius_mm is {radius:g}; it must be less than cam.base_radius_mm, which is "
                "{base_radius:g}: lower it, or raise cam.base_radius_mm",
                radius=keys.radius_mm,
                base_radius=seat.base_radius,
            )
        )
    if keys.length_mm is not None and keys.length_mm <= outer:
        raise ValueError(
            Message(
                "follower.length_mm is {length:g}; it must be greater than the distance of the disc's outer face from "
                "the fork axis, {outer:g} mm",
                length=keys.length_mm,
                outer=outer,
            )
        )


ROD = FollowerKind(
    code="rod",
    meaning="The straight round rod on the fork that rides on the disc.",
    keys=RodKeys,
    build=_build,
    unit=TAN,
    refuse=_refuse,
    runs=True,
)
