"""Motion of rises and dwells: the segments of a turn, each with an angle and a law."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import radians
from typing import TYPE_CHECKING, Annotated, ClassVar

from annotated_types import Ge, Le
from pydantic import Field, Strict, model_validator

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.section import HERE, DesignSection, OneOf, listed
from cadgen.design.sources.source import (
    MOST_TURNS,
    SAME,
    MotionKeys,
    Numbers,
    in_file,
    in_unit,
    spoken,
    unit_in_file,
)
from cadgen.errors import DesignError
from cadgen.laws.law import MotionLaw
from cadgen.laws.table import POLYNOMIAL, codes, has, law_of
from cadgen.laws.unit import MM
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.laws.conditions import Condition
    from cadgen.laws.segments import MotionSpan, SegmentMotion

_HEIGHTS = ("to_mm", "rise_mm", "to_deg", "rise_deg")
_MOVING = ("in_deg", "law", "conditions", "powers", "acceleration_ratio", "reversed")
_MOST_DEGREES = 360.0 * MOST_TURNS
_MOST_ORDER = 8  # of a derivative that a condition is for

Power = Annotated[int, Ge(3), Le(60)]


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
    in_deg: float | None = Field(
        default=None, gt=0, le=_MOST_DEGREES, description="cam angle that a rise or return takes"
    )
    law: Annotated[str | None, OneOf(lambda: (*codes(), POLYNOMIAL), lambda code: code == POLYNOMIAL or has(code))] = (
        Field(
            default=None,
            description="law of a rise or return; see how-to/motion.md. A polynomial meets its conditions and its "
            "neighbours",
        )
    )
    conditions: Annotated[tuple[Numbers, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=1,
        max_length=20,
        description="of a polynomial, [angle from its beginning in degrees, order, value] each: order 0 is the lift in "
        "mm or degrees, 1 the velocity by rad of cam angle, 2 the acceleration, up to 8. At an end without "
        "derivatives it has the velocity and acceleration of its neighbour",
    )
    powers: Annotated[tuple[Power, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=4,
        max_length=4,
        description="of a valve_lobe, [p, q, r, s], four whole numbers that grow, 3 to 60",
    )
    acceleration_ratio: float | None = Field(
        default=None, ge=0.02, le=50, description="of an unequal_parabola, first acceleration by the second"
    )
    reversed: bool | None = Field(
        default=None, description="whether its law is run backwards, from its end to its beginning"
    )
    dwell_deg: float | None = Field(
        default=None, gt=0, le=_MOST_DEGREES, description="cam angle of a dwell, which has no other key"
    )

    @model_validator(mode="after")
    def _rise_or_dwell(self) -> MotionSegment:
        heights = [name for name in _HEIGHTS if getattr(self, name) is not None]
        if self.dwell_deg is not None:
            if others := [*heights, *(name for name in _MOVING if getattr(self, name) is not None)]:
                raise ValueError(
                    Message(
                        "{here} has dwell_deg and {listed}: a dwell has no other key",
                        here=HERE,
                        listed=listed(others, "and"),
                    )
                )
            return self
        free = self.law == POLYNOMIAL and self.conditions is not None and not heights
        if (len(heights) != 1 and not free) or self.in_deg is None or self.law is None:
            given = [name for name in (*_HEIGHTS, "in_deg", "law") if getattr(self, name) is not None]
            raise ValueError(
                Message(
                    "{here} has {listed}; it needs dwell_deg alone, or in_deg, law and one of {listed2}",
                    here=HERE,
                    listed=listed(given, "and") or Message("none of its keys"),
                    listed2=listed(_HEIGHTS, "or"),
                )
            )
        self._refuse_keys_of_other_laws(self.law)
        return self

    def _refuse_keys_of_other_laws(self, law: str) -> None:
        own = {"conditions"} if law == POLYNOMIAL else {"reversed", law_of(law).key}
        for key in ("conditions", "powers", "acceleration_ratio", "reversed"):
            if getattr(self, key) is not None and key not in own:
                raise ValueError(
                    Message(
                        '{here}.{key} is not of the law "{law}": remove it (on the command line with --set '
                        "{here}.{key}=)",
                        here=HERE,
                        key=key,
                        law=law,
                    )
                )
        if law != POLYNOMIAL:
            try:
                self.shaped()
            except ValueError as error:
                raise ValueError(Message("{here}.{error}", here=HERE, error=error.args[0])) from None

    @property
    def height(self) -> tuple[str, float] | None:
        """Key of the height and its value, in the unit of the key; None for a polynomial that ends by a condition."""
        return next(((name, value) for name in _HEIGHTS if (value := getattr(self, name)) is not None), None)

    def shaped(self) -> MotionLaw:
        """Law of the segment, in the shape that its keys give it.

        Raises:
            ValueError: the law has no such shape.
        """
        law = law_of(self.law or "")
        value = getattr(self, law.key) if law.key else None
        return law if value is None or law.shaped is None else law.shaped(value)


class SegmentKeys(MotionKeys):
    """Keys of a motion of rises and dwells."""

    code: ClassVar[str] = "segments"

    allow_velocity_jump: bool | None = Field(
        default=None, description="whether the velocity may jump, which makes a corner; left out, that is refused"
    )
    segments: Annotated[tuple[MotionSegment, ...], Field(strict=False, max_length=360)] = Field(
        default=(), description="rises, returns and dwells from cam angle 0 on, which take 360 degrees together"
    )

    @model_validator(mode="before")
    @classmethod
    def _nothing_in_no_angle(cls, values: object) -> object:
        segments = values.get("segments") if isinstance(values, dict) else None
        if not isinstance(segments, list) or not all(isinstance(each, dict) for each in segments):
            return values
        for number, each in enumerate(segments, 1):
            if each.get("dwell_deg") == 0 and len(segments) > 1:
                raise ValueError(
                    Message(
                        "motion.segments.{number} is a dwell of 0 degrees, which is none: remove it (on the command "
                        "line with --set motion.segments.{number}=)",
                        number=number,
                    )
                )
            if each.get("in_deg") == 0:
                given = values if isinstance(values, dict) else {}
                repeat, turns = given.get("repeat") or 1, given.get("machine_turns") or 1.0
                whole = 360 * turns / repeat if isinstance(repeat, int) and isinstance(turns, int | float) else 360.0
                raise ValueError(_in_no_angle(number, segments, whole))
        return values

    def motion(self, kind: FollowerKind, *, corners: bool) -> SegmentMotion:
        """Motion of rises and dwells.

        Args:
            kind: kind of the follower, whose unit the heights must have.
            corners: whether the follower may have a corner of its path, so that a refusal may name it.
        """
        from cadgen.laws.segments import MotionSpan, SegmentMotion

        items, turns = self.segments, self.machine_turns or 1.0
        # At cam angle 0 the lift is 0, or what the first segment's polynomial asks for there.
        begins = (value for angle, order, value in items[0].conditions or () if angle == 0 and order == 0)
        at, first = 0.0, in_unit(next(begins, 0.0), kind)
        height, spans = first, []
        for number, item in enumerate(items, 1):
            width = item.dwell_deg if item.dwell_deg is not None else item.in_deg or 0.0
            start, stop = radians(at / turns), radians((at + width) / turns)
            if item.dwell_deg is not None:
                spans.append(MotionSpan(start, stop, height, height, None))
            else:
                after = _height_after(number, item, height, first, number == len(items), kind)
                span = MotionSpan(start, stop, height, after, None)
                if item.law == POLYNOMIAL:
                    span = replace(span, conditions=_conditions(number, item, span, kind))
                else:
                    law = item.shaped()
                    back = (law.to_top and after < height) != bool(item.reversed)
                    span = replace(span, law=law.backwards if back else law)
                spans.append(span)
                height = after
            at += width
        _refuse_open(items, spans, kind)
        return SegmentMotion.of(
            spans,
            kind.unit,
            repeat=self.repeat or 1,
            machine_turns=turns,
            allow_velocity_jump=bool(self.allow_velocity_jump),
            corners=corners,
        )


def _in_no_angle(number: int, segments: Sequence[Mapping[str, object]], whole: float) -> Message:
    """Refusal of a rise in 0 degrees, with what the others leave of the turn for it, or half of the widest of them.

    Args:
        number: number of the segment, from 1.
        segments: keys of all segments, as in the file.
        whole: degrees that all of them take.
    """
    angles = [each.get("in_deg", each.get("dwell_deg")) for each in segments]
    widths = [angle if isinstance(angle, int | float) else 0.0 for angle in angles]
    widest, left = widths.index(max(widths)), whole - sum(widths)
    if left > SAME * whole:
        return Message(
            "motion.segments.{number} rises in 0 degrees, which no follower can do: set "
            "motion.segments.{number}.in_deg to {left:.10g}, which the others leave of the turn",
            number=number,
            left=left,
        )
    if not widths[widest] > 0:
        return Message("motion.segments.{number} rises in 0 degrees: give it some of the turn", number=number)
    return Message(
        "motion.segments.{number} rises in 0 degrees, which no follower can do: give it some of the turn, such as "
        "motion.segments.{number}.in_deg = {half:g} with motion.segments.{widest}.{key} = {half:g}",
        number=number,
        half=widths[widest] / 2,
        widest=widest + 1,
        key="in_deg" if "in_deg" in segments[widest] else "dwell_deg",
    )


def _conditions(number: int, item: MotionSegment, span: MotionSpan, kind: FollowerKind) -> tuple[Condition, ...]:
    """Conditions of a polynomial by the share of its segment, with what its height at the end asks for."""
    from cadgen.laws.conditions import Condition

    width, found = item.in_deg or 1.0, []
    first: dict[tuple[float, int], int] = {}
    for place, (angle, order, value) in enumerate(item.conditions or (), 1):
        name = f"motion.segments.{number}.conditions.{place}"
        if not 0 <= angle <= width:
            raise DesignError(
                "{name} is at {angle:g} degrees; it must be within the segment, from 0 to {width:g}: correct it",
                name=name,
                angle=angle,
                width=width,
            )
        if order not in range(_MOST_ORDER + 1):
            raise DesignError(
                "{name} is for order {order:g}; it must be a whole number from 0, the lift, to {most}: correct it",
                name=name,
                order=order,
                most=_MOST_ORDER,
            )
        twice = first.setdefault((angle, int(order)), place)
        if twice != place:
            raise DesignError(
                "motion.segments.{number}.conditions {one} and {two} are both for order {order:g} at {angle:g} "
                "degrees: "
                "remove one (on the command line with --set {name}=)",
                number=number,
                one=twice,
                two=place,
                order=order,
                angle=angle,
                name=name,
            )
        found.append(Condition(angle / width, int(order), in_unit(value, kind) * span.width**order))
    ends = {0.0: span.before, 1.0: span.after}
    for condition in found:
        if condition.order == 0 and condition.share in ends:
            meant = ends[condition.share]
            if abs(condition.value - meant) > SAME * max(abs(meant), abs(condition.value)):
                raise DesignError(
                    "motion.segments.{number}.conditions give {given:.10g} {unit} at {angle:g} degrees, where the "
                    "motion "
                    "has {meant:.10g}: set that or leave the condition out",
                    number=number,
                    given=in_file(condition.value, kind),
                    meant=in_file(meant, kind),
                    unit=unit_in_file(kind),
                    angle=condition.share * width,
                )
    return tuple(found)


def _height_after(
    number: int, item: MotionSegment, before: float, first: float, last: bool, kind: FollowerKind
) -> float:
    """Height at the end of a segment, in the motion's unit."""
    given = [value for angle, order, value in item.conditions or () if angle == item.in_deg and order == 0]
    if item.height is not None:
        key, value = item.height
        _refuse_unit(number, key, kind)
        if given:
            raise DesignError(
                "motion.segments.{number} has {key} and a condition for the lift at its end, two for one value: remove "
                "{key} (on the command line with --set motion.segments.{number}.{key}=)",
                number=number,
                key=key,
            )
        return in_unit(value, kind) + (before if key.startswith("rise") else 0.0)
    if given:
        return in_unit(given[0], kind)
    if last:
        return first
    raise DesignError(
        "motion.segments.{number} ends at no height: add to_{unit} to it, or a condition [{angle:g}, 0, lift]",
        number=number,
        unit="mm" if kind.unit == MM else "deg",
        angle=item.in_deg or 0.0,
    )


def _refuse_open(items: tuple[MotionSegment, ...], spans: list[MotionSpan], kind: FollowerKind) -> None:
    """Refuse segments that end at another height than they begin at."""
    begin, end = spans[0].before, spans[-1].after
    size = max(abs(height) for span in spans for height in (span.before, span.after))
    if abs(end - begin) <= SAME * size:
        return
    last = next(number for number in range(len(items) - 1, -1, -1) if items[number].dwell_deg is None)
    key = items[last].height
    if key is None:
        cure = Message(
            "give motion.segments.{number} the lift {value:.10g} at its end",
            number=last + 1,
            value=in_file(begin, kind),
        )
    else:
        base = spans[last].before if key[0].startswith("rise") else 0.0
        cure = Message(
            "set motion.segments.{number}.{key} to {value:.10g}",
            number=last + 1,
            key=key[0],
            value=in_file(begin - base, kind),
        )
    raise DesignError(
        "the motion begins at {begin:.10g} {unit} and ends at {end:.10g}, which is a jump at cam angle 0: {cure}",
        begin=in_file(begin, kind),
        end=in_file(end, kind),
        unit=unit_in_file(kind),
        cure=cure,
    )


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
                spoken=spoken(kind.unit),
                right=right,
            )
        )
