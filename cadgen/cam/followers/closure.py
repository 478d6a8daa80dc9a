"""Closures that hold a roller on its cam: spring, groove, or second disc with its own roller. Light to import."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated, Any

from annotated_types import Ge, Gt, Le

from cadgen.messages import Message


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


@dataclass(frozen=True, kw_only=True)
class SecondOnArm:
    """Second roller of a conjugate pair, on a second arm of the same lever."""

    radius_mm: Annotated[float, Ge(0.05), Le(500), "of the second roller"]
    arm_mm: Annotated[float, Gt(0), Le(2000), "from the pivot to the second roller's centre"]
    angle_deg: Annotated[float, Gt(0), Le(360), "between both arms, which have the camshaft between them"]


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
