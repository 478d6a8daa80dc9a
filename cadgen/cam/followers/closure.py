"""Closures that hold a roller on its cam: spring, groove, or second disc with its own roller. Light to import."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated, Any

from annotated_types import Ge, Gt, Le

from cadgen.cam.followers.kind import FollowerSeat
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.cam.followers.groove import GrooveRollers
    from cadgen.cam.followers.roller import Roller
    from cadgen.cam.followers.swinging_roller import SwingingRoller


class Closure(StrEnum):
    """Closure that holds a follower on its cam."""

    SPRING = "spring"
    GROOVE = "groove"
    CONJUGATE = "conjugate"


CLOSURE = (
    "what holds the roller on the cam: a `spring`, a `groove` in which it runs, or with `conjugate` a second disc with "
    "a roller of its own, [follower.second]; left out, a spring"
)


@dataclass(frozen=True, kw_only=True)
class SecondOnSlide:
    """Second roller of a conjugate pair, on the same slide on the other side of the camshaft."""

    radius_mm: Annotated[float, Ge(0.05), Le(500), "of the second roller"]
    span_mm: Annotated[float, Gt(0), Le(2000), "between the centres of both rollers, along the slide"]
    offset_mm: Annotated[float, Ge(-500), Le(500), "of its line, to the same side as the first one's"] = 0.0
    gap_mm: Annotated[float | None, Gt(0), Le(500), "between the facing sides of both discs, for the sheets"] = None


@dataclass(frozen=True, kw_only=True)
class SecondOnArm:
    """Second roller of a conjugate pair, on a second arm of the same lever."""

    radius_mm: Annotated[float, Ge(0.05), Le(500), "of the second roller"]
    arm_mm: Annotated[float, Gt(0), Le(2000), "from the pivot to the second roller's centre"]
    angle_deg: Annotated[float, Gt(0), Le(360), "between both arms, which have the camshaft between them"]
    gap_mm: Annotated[float | None, Gt(0), Le(500), "between the facing sides of both discs, for the sheets"] = None


def refuse_groove(clearance: float, radius: float, depth: float, faces: tuple[float, float]) -> None:
    """Refuse a groove without a floor, or with a clearance as large as its roller.

    Args:
        clearance: width of the groove less the diameter of the roller, mm.
        radius: radius of the roller, mm.
        depth: depth of the groove, mm.
        faces: heights of the disc's faces, mm.

    Raises:
        ValueError: it is so.
    """
    thickness = faces[1] - faces[0]
    if depth >= thickness:
        raise ValueError(
            Message(
                "follower.depth_mm is {depth:g}; on a disc {thickness:g} mm thick the groove has no floor: lower it "
                "below {thickness:g}, or raise cam.thickness_mm",
                depth=depth,
                thickness=thickness,
            )
        )
    if clearance >= radius:
        raise ValueError(
            Message(
                "follower.clearance_mm is {clearance:g}; it must be less than follower.radius_mm, {radius:g}: lower it",
                clearance=clearance,
                radius=radius,
            )
        )


CLEARANCE = "of a groove, its width less the diameter of the roller; half on either side"
DEPTH = "of a groove, from the face that files show"


def refuse_parts_of_closures(closure: Closure | None, second: Any, groove: dict[str, float | None]) -> None:
    """Refuse keys of a closure that the design does not have, and a closure without its keys.

    Args:
        closure: closure of the design; None for a spring.
        second: section of the second roller; None where the design has none.
        groove: values of the keys of a groove by their names.

    Raises:
        ValueError: it is so.
    """
    if closure == Closure.CONJUGATE and second is None:
        raise ValueError(
            Message(
                'follower.closure is "conjugate", which needs a second roller: add [follower.second] with its keys, or '
                "remove follower.closure"
            )
        )
    if closure != Closure.CONJUGATE and second is not None:
        raise ValueError(
            Message(
                'follower.second is the second roller of a conjugate pair: set follower.closure = "conjugate", or '
                "remove it"
            )
        )
    given = [name for name, value in groove.items() if value is not None]
    missing = [name for name in groove if name not in given]
    if closure == Closure.GROOVE and missing:
        raise ValueError(
            Message(
                'follower.closure is "groove", which needs follower.{key}: add it, a length in mm, or remove '
                "follower.closure",
                key=missing[0],
            )
        )
    if closure != Closure.GROOVE and given:
        raise ValueError(
            Message('follower.{key} is of a groove: set follower.closure = "groove", or remove it', key=given[0])
        )


def groove_with(
    roller: Callable[[Any, FollowerSeat], Roller | SwingingRoller],
) -> Callable[[Any, FollowerSeat], GrooveRollers | None]:
    """Function of keys and seat that returns the rollers of a groove; None where the keys have no groove.

    Args:
        roller: function of keys and seat that returns the roller.
    """

    def groove(keys: Any, seat: FollowerSeat) -> GrooveRollers | None:
        from cadgen.cam.followers.groove import GrooveRollers

        if keys.clearance_mm is None or keys.depth_mm is None:
            return None
        return GrooveRollers.of(roller(keys, seat), keys.clearance_mm, keys.depth_mm)

    return groove
