"""The kinds of followers on an arm: keys of roller and flat face, and what they must keep. Numerics come when built."""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, ceil, cos, degrees, floor, hypot, radians, sqrt
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Gt, Le

from cadgen.cam.followers.closure import (
    CLEARANCE,
    CLOSURE,
    DEPTH,
    Closure,
    SecondOnArm,
    groove_with,
    refuse_groove,
    refuse_parts_of_closures,
)
from cadgen.cam.followers.kind import FollowerKind, FollowerSeat
from cadgen.cam.followers.lifts import Lifts
from cadgen.laws.unit import RAD
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.cam.followers.swinging_flat import SwingingFace
    from cadgen.cam.followers.swinging_roller import SecondSwingingRoller, SwingingRoller


_APART = 1.0  # mm; an arm that is proposed reaches past the roller by as much
_ASIDE = 45.0  # degrees; a second arm that is proposed stands at least so far from the line to the camshaft
_SMALLER = 0.5  # of the arm; a roller that is proposed leaves its pivot free
_CONVEX = 0.5  # mm; least radius of curvature of the disc under a face whose base circle is found for an angle
_ANY_SEAT = FollowerSeat(base_radius=1.0, faces=(0.0, 1.0), carrying=(0.0, 1.0))  # its base circle is yet to be found
_PIVOT = "of the arm's pivot from the camshaft"
_LIFTS = "whether the arm lifts `against` the sense in which the cam turns, or `with` it"


@dataclass(frozen=True, kw_only=True)
class SwingingRollerKeys:
    """Keys of a design's roller on an arm, as in its file."""

    radius_mm: Annotated[float, Ge(0.05), Le(500), "of the roller"]
    arm_mm: Annotated[float, Gt(0), Le(2000), "from the pivot to the roller's centre"]
    centre_distance_mm: Annotated[float, Gt(0), Le(2000), _PIVOT]
    lifts: Annotated[Lifts, _LIFTS]
    closure: Annotated[Closure | None, CLOSURE] = None
    clearance_mm: Annotated[float | None, Ge(0), Le(50), CLEARANCE] = None
    depth_mm: Annotated[float | None, Gt(0), Le(500), DEPTH] = None
    second: Annotated[SecondOnArm | None, "second roller of a conjugate pair"] = None

    def __post_init__(self) -> None:
        refuse_parts_of_closures(
            self.closure, self.second, {"clearance_mm": self.clearance_mm, "depth_mm": self.depth_mm}
        )


@dataclass(frozen=True, kw_only=True)
class SwingingFlatKeys:
    """Keys of a design's flat face on an arm, as in its file."""

    centre_distance_mm: Annotated[float, Gt(0), Le(2000), _PIVOT]
    lifts: Annotated[Lifts, _LIFTS]
    face_offset_mm: Annotated[
        float, Ge(-500), Le(500), "of the face from the pivot; positive with the pivot on the far side of the face"
    ] = 0.0
    length_mm: Annotated[
        float | None, Gt(0), Le(2000), "of the face, from the foot of the pivot's perpendicular; left out, long enough"
    ] = None


def _roller(keys: SwingingRollerKeys, seat: FollowerSeat) -> SwingingRoller:
    from cadgen.cam.followers.swinging_roller import SwingingRoller

    return SwingingRoller(
        base=seat.base_radius,
        radius=keys.radius_mm,
        arm=keys.arm_mm,
        centre_distance=keys.centre_distance_mm,
        lifts=keys.lifts,
    )


def _second(keys: SwingingRollerKeys, seat: FollowerSeat) -> SecondSwingingRoller | None:
    from cadgen.cam.followers.swinging_roller import SecondSwingingRoller

    if keys.second is None:
        return None
    second = keys.second
    return SecondSwingingRoller.beside(_roller(keys, seat), second.radius_mm, second.arm_mm, radians(second.angle_deg))


def _refuse_roller(keys: SwingingRollerKeys, seat: FollowerSeat) -> None:
    prime, c = seat.base_radius + keys.radius_mm, keys.centre_distance_mm
    least, most = abs(c - prime), c + prime
    if not least < keys.arm_mm < most:
        # An arm that is square to the line from camshaft to roller at lift 0 has no pressure angle there.
        cures = [Message("set follower.centre_distance_mm to {c:g}", c=ceil(10 * hypot(keys.arm_mm, prime)) / 10)]
        if c > hypot(prime, keys.radius_mm) + _APART:
            cures.insert(0, Message("set follower.arm_mm to {arm:g}", arm=floor(10 * sqrt(c**2 - prime**2)) / 10))
        raise ValueError(
            Message(
                "follower.arm_mm is {arm:g}; with the pivot {c:g} mm from the camshaft it cannot bring the roller to "
                "the prime radius of {prime:g} mm, where its centre stands at lift 0, for which it must be more than "
                "{least:g} and less than {most:g} mm: {cures}",
                arm=keys.arm_mm,
                c=c,
                prime=prime,
                least=least,
                most=most,
                cures=joined(cures, Message(", or ")),
            )
        )
    if keys.arm_mm <= keys.radius_mm:
        raise ValueError(
            Message(
                "follower.arm_mm is {arm:g}; the roller of {radius:g} mm would cover its own pivot: set "
                "follower.radius_mm to {least:g} or less, or take a longer arm with a pivot farther away",
                arm=keys.arm_mm,
                radius=keys.radius_mm,
                least=floor(keys.arm_mm * 10 * _SMALLER) / 10,
            )
        )
    if keys.clearance_mm is not None and keys.depth_mm is not None:
        refuse_groove(keys.clearance_mm, keys.radius_mm, keys.depth_mm, seat.faces)
    _refuse_second(keys, prime)


def _refuse_second(keys: SwingingRollerKeys, prime: float) -> None:
    """Refuse a second arm that does not stand on the other side of the camshaft, or a roller that covers that."""
    second, c = keys.second, keys.centre_distance_mm
    if second is None:
        return
    rest = degrees(acos((c**2 + keys.arm_mm**2 - prime**2) / (2 * c * keys.arm_mm)))
    if not rest < second.angle_deg < rest + 180:
        # Square to the line from the camshaft to its roller the arm has no pressure angle at rest.
        square = degrees(acos(second.arm_mm / c)) if second.arm_mm < c else 0.0
        raise ValueError(
            Message(
                "follower.second.angle_deg is {angle:g}; the first arm stands at {rest:.4g} degrees to the line from "
                "the pivot to the camshaft, so the second stands on its other side with an angle of more than "
                "{rest:.4g} and less than {most:.4g}: set it to {fits:g}",
                angle=second.angle_deg,
                rest=rest,
                most=rest + 180,
                fits=ceil(10 * (rest + max(square, _ASIDE))) / 10,
            )
        )
    apart = sqrt(c**2 + second.arm_mm**2 - 2 * c * second.arm_mm * cos(radians(second.angle_deg - rest)))
    if apart <= second.radius_mm:
        raise ValueError(
            Message(
                "follower.second.radius_mm is {radius:g}; the second roller, {apart:.4g} mm from the camshaft at swing "
                "0, would cover it, so nothing is left of its disc: set it to {half:g} or less, or change "
                "follower.second.angle_deg or follower.second.arm_mm",
                radius=second.radius_mm,
                half=floor(5 * apart) / 10,
                apart=apart,
            )
        )


def _flat(keys: SwingingFlatKeys, seat: FollowerSeat) -> SwingingFace:
    from cadgen.cam.followers.swinging_flat import SwingingFace

    return SwingingFace(
        base=seat.base_radius,
        face_offset=keys.face_offset_mm,
        centre_distance=keys.centre_distance_mm,
        lifts=keys.lifts,
        length=keys.length_mm,
    )


def _refuse_flat(keys: SwingingFlatKeys, seat: FollowerSeat) -> None:
    touching = seat.base_radius + keys.face_offset_mm
    if touching >= keys.centre_distance_mm:
        raise ValueError(
            Message(
                "follower.centre_distance_mm is {c:g}; the face, {offset:g} mm from its pivot, cannot touch a base "
                "circle of {base:g} mm, for which it must be more than {least:g}: set it to {farther:g}, or lower "
                "follower.face_offset_mm or cam.base_circle_radius_mm",
                farther=ceil(20 * touching) / 10,
                c=keys.centre_distance_mm,
                offset=keys.face_offset_mm,
                base=seat.base_radius,
                least=touching,
            )
        )
    if touching <= 0:
        raise ValueError(
            Message(
                "follower.face_offset_mm is {offset:g}, which puts the pivot within the disc's side of the face by "
                "more than the base circle's radius: set it to {higher:g}, or to 0 or more",
                offset=keys.face_offset_mm,
                higher=-floor(5 * seat.base_radius) / 10,
            )
        )


SWINGING_ROLLER = FollowerKind(
    code="swinging_roller",
    meaning="A roller on an arm that swings about a pivot; its motion is in degrees.",
    keys=SwingingRollerKeys,
    build=_roller,
    unit=RAD,
    least_base=lambda keys, motion, angle: _roller(keys, _ANY_SEAT).least_base(motion, angle, angle),
    second=_second,
    groove=groove_with(_roller),
    refuse=_refuse_roller,
)
SWINGING_FLAT = FollowerKind(
    code="swinging_flat",
    meaning="A flat face on an arm that swings about a pivot; its motion is in degrees.",
    keys=SwingingFlatKeys,
    build=_flat,
    unit=RAD,
    least_base=lambda keys, motion, angle: _flat(keys, _ANY_SEAT).least_base(motion, angle, angle, _CONVEX),
    refuse=_refuse_flat,
)
