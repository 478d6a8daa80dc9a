"""The section [motion]: rises and dwells that fill a turn of the cam, instead of [path] and [car]."""

from enum import StrEnum
from math import radians
from typing import TYPE_CHECKING, Annotated

from pydantic import Field, model_validator

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.section import HERE, WORD, DesignSection, OneOf, listed
from cadgen.laws.table import codes, has, law_of
from cadgen.laws.unit import MM, Unit
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.laws.segments import SegmentMotion

_HEIGHTS = ("to_mm", "rise_mm", "to_deg", "rise_deg")


class DiscSense(StrEnum):
    """Sense in which a disc turns, seen on its outer face."""

    CLOCKWISE = "clockwise"
    COUNTERCLOCKWISE = "counterclockwise"


class MotionSegment(DesignSection):
    """Part of the turn, from where the one before ends: a rise or return by a law, or a dwell."""

    to_mm: float | None = Field(default=None, ge=-1000, le=1000, description="lift at its end")
    rise_mm: float | None = Field(
        default=None, ge=-1000, le=1000, description="how far it leads from the lift before; negative for a return"
    )
    to_deg: float | None = Field(default=None, ge=-90, le=90, description="of a swinging follower, swing at its end")
    rise_deg: float | None = Field(
        default=None, ge=-180, le=180, description="of a swinging follower, how far it leads from the swing before"
    )
    in_deg: float | None = Field(default=None, gt=0, le=360, description="cam angle that a rise or return takes")
    law: Annotated[str | None, OneOf(codes, has)] = Field(default=None, description="law of a rise or return")
    dwell_deg: float | None = Field(
        default=None, gt=0, le=360, description="cam angle of a dwell, which has no other key"
    )

    @model_validator(mode="after")
    def _rise_or_dwell(self) -> "MotionSegment":
        heights = [name for name in _HEIGHTS if getattr(self, name) is not None]
        if self.dwell_deg is not None:
            if others := [*heights, *(name for name in ("in_deg", "law") if getattr(self, name) is not None)]:
                raise ValueError(
                    Message(
                        "{here} has dwell_deg and {listed}: a dwell has no other key",
                        here=HERE,
                        listed=listed(others, "and"),
                    )
                )
            return self
        if len(heights) != 1 or self.in_deg is None or self.law is None:
            given = [name for name in (*_HEIGHTS, "in_deg", "law") if getattr(self, name) is not None]
            raise ValueError(
                Message(
                    "{here} has {listed}; it needs dwell_deg alone, or in_deg, law and one of {listed2}",
                    here=HERE,
                    listed=listed(given, "and") or Message("none of its keys"),
                    listed2=listed(_HEIGHTS, "or"),
                )
            )
        return self

    @property
    def height(self) -> tuple[str, float]:
        """Key of the height and its value, in the unit of the key."""
        return next((name, value) for name in _HEIGHTS if (value := getattr(self, name)) is not None)


class MotionSection(DesignSection):
    """Motion of the follower in one turn of the cam. A design has it, or [path] and [car]."""

    turns: Annotated[DiscSense, WORD] = Field(
        description="sense of the disc seen on its outer face; files show the face on which it turns clockwise, with "
        "+z towards you: the outer one, or with counterclockwise the inner one"
    )
    speed_rpm: float | None = Field(
        default=None, gt=0, le=1e6, description="speed of the camshaft; with it velocities and accelerations are shown"
    )
    segments: Annotated[tuple[MotionSegment, ...], Field(strict=False, min_length=1, max_length=360)] = Field(
        description="rises, returns and dwells from cam angle 0 on, which take 360 degrees together"
    )


class MotionCam(DesignSection):
    """The disc of a design with [motion]."""

    base_circle_radius_mm: float = Field(gt=0, le=1000, description="least radius of the disc, at lift 0")
    thickness_mm: float = Field(ge=0.1, le=100, description="between the disc's faces")

    @property
    def faces_mm(self) -> tuple[float, float]:
        """Heights of the disc's faces."""
        return 0.0, self.thickness_mm


def motion_of(section: MotionSection, kind: FollowerKind) -> "SegmentMotion":
    """Motion of a design's segments.

    Args:
        section: section [motion].
        kind: kind of the follower, whose unit the heights must have.

    Raises:
        ValueError: a height is in another unit than the follower moves in.
        DesignError: the segments do not fill the turn or do not close, or a velocity jumps.
    """
    from cadgen.laws.segments import MotionSpan, SegmentMotion

    at, height, segments = 0.0, 0.0, []
    for number, item in enumerate(section.segments, 1):
        if item.dwell_deg is not None:
            stop = at + item.dwell_deg
            segments.append(MotionSpan(_angle(at), _angle(stop), height, height, None))
        else:
            key, value = item.height
            _refuse_unit(number, key, kind)
            after = (value if key.endswith("mm") else radians(value)) + (height if key.startswith("rise") else 0.0)
            stop = at + (item.in_deg or 0.0)
            segments.append(MotionSpan(_angle(at), _angle(stop), height, after, law_of(item.law or "")))
            height = after
        at = stop
    return SegmentMotion.of(segments, kind.unit)


def _angle(degrees: float) -> float:
    return radians(degrees)


def _refuse_unit(number: int, key: str, kind: FollowerKind) -> None:
    wanted = "mm" if kind.unit == MM else "deg"
    if not key.endswith(wanted):
        right = f"{key.partition('_')[0]}_{wanted}"
        raise ValueError(
            Message(
                'motion.segments.{number}.{key} is not of a follower of kind "{code}", which moves in '
                "{spoken}: give {right} instead",
                number=number,
                key=key,
                code=kind.code,
                spoken=_spoken(kind.unit),
                right=right,
            )
        )


def _spoken(unit: Unit) -> str:
    return "mm" if unit == MM else "degrees"
