"""The section [motion]: what a follower does in a turn of the cam, instead of [path] and [car].

Its sources are rises and dwells, points of a spline, harmonics, or a lift table. A new one is a key of `MotionSection`
and a line in `SOURCES`.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import pairwise
from math import degrees, radians
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Le, Len
from pydantic import Field, Strict, model_validator

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.lift_rows import MOST_ROWS
from cadgen.design.section import HERE, WORD, DesignSection, OneOf, listed
from cadgen.errors import DesignError
from cadgen.laws.law import MotionLaw
from cadgen.laws.table import POLYNOMIAL, codes, has, law_of
from cadgen.laws.unit import MM, Unit
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.arrays import Array
    from cadgen.laws.conditions import Condition
    from cadgen.laws.motion import Motion
    from cadgen.laws.segments import MotionSpan

_HEIGHTS = ("to_mm", "rise_mm", "to_deg", "rise_deg")
_MOVING = ("in_deg", "law", "conditions", "powers", "acceleration_ratio", "reversed")
_MOST_TURNS = 100  # of a machine in a turn of its cam
_MOST_DEGREES = 360.0 * _MOST_TURNS
_MOST_ORDER = 8  # of a derivative that a condition is for
_MOST_HARMONIC = 60
_LEAST_POINTS = 6  # of a periodic quintic spline
_INCH_MM = 25.4
_SAME = 1e-9  # of the greatest height; a smaller difference of two heights is rounding


class DiscSense(StrEnum):
    """Sense in which a disc turns, seen on its outer face."""

    CLOCKWISE = "clockwise"
    COUNTERCLOCKWISE = "counterclockwise"


class TableUnit(StrEnum):
    """Unit of the lift in a table."""

    MM = "mm"
    INCH = "inch"
    DEG = "deg"


class TableAngle(StrEnum):
    """Angle that a table counts: of the cam, or of the machine."""

    CAM = "cam"
    MACHINE = "machine"


class TableClosing(StrEnum):
    """Remedy for a table whose ends do not meet."""

    RAMPS = "ramps"


Number = Annotated[float, Ge(-1e6), Le(1e6)]
Numbers = Annotated[tuple[Number, ...], Strict(False), Len(3, 3)]
Power = Annotated[int, Ge(3), Le(60)]
Row = Annotated[tuple[Number, Number], Strict(False)]


_LAW = OneOf(lambda: (*codes(), POLYNOMIAL), lambda code: code == POLYNOMIAL or has(code))


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
    def _rise_or_dwell(self) -> "MotionSegment":
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


class MotionSection(DesignSection):
    """Motion of the follower in one turn of the cam. A design has it, or [path] and [car].

    One of segments, points, harmonics and table says what the motion is.
    """

    turns: Annotated[DiscSense, WORD] = Field(
        description="sense of the disc seen on its outer face; files show the face on which it turns clockwise, with "
        "+z towards you: the outer one, or with counterclockwise the inner one"
    )
    speed_rpm: float | None = Field(
        default=None, gt=0, le=1e6, description="speed of the camshaft; with it velocities and accelerations are shown"
    )
    repeat: int | None = Field(
        default=None,
        ge=1,
        le=360,
        description="lobes: how often the motion is repeated in a turn, of which it then takes that part",
    )
    machine_turns: float | None = Field(
        default=None,
        gt=0,
        le=_MOST_TURNS,
        description="turns of the machine in a turn of the cam, 2 for the valves of an engine: all angles of the "
        "section "
        "are then those of the machine",
    )
    allow_velocity_jump: bool | None = Field(
        default=None, description="whether the velocity may jump, which makes a corner; left out, that is refused"
    )
    points: Annotated[tuple[Row, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=_LEAST_POINTS,
        max_length=3600,
        description="[angle in degrees, lift in mm or swing in degrees] each: a periodic quintic spline goes through "
        "them",
    )
    harmonics: Annotated[tuple[Numbers, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=1,
        max_length=_MOST_HARMONIC + 1,
        description="[k, a, b] each: a cos(k theta) + b sin(k theta), mm or degrees; k = 0 is the mean",
    )
    table: str | None = Field(
        default=None,
        min_length=1,
        max_length=1000,
        description="CSV of two columns, angle in degrees and lift, by its path from the folder of the design file",
    )
    table_unit: Annotated[TableUnit | None, WORD] = Field(
        default=None, description="unit of the lift in the table; left out, mm, or of a swinging follower deg"
    )
    table_angle: Annotated[TableAngle | None, WORD] = Field(
        default=None, description="whose angle the table has; left out, that of the machine if machine_turns is given"
    )
    smooth: bool | None = Field(
        default=None, description="whether the rows of the table are smoothed by the noise that their differences show"
    )
    close: Annotated[TableClosing | None, WORD] = Field(
        default=None, description="what leads the ends of a table together that do not meet; left out, it is refused"
    )
    rows: Annotated[tuple[Row, ...] | None, Strict(False)] = Field(
        default=None,
        max_length=MOST_ROWS,
        description="rows of the table, [angle, lift], instead of a file; what is read from a file is kept here",
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

    @model_validator(mode="after")
    def _has_one_source(self) -> "MotionSection":
        given = [name for name in SOURCES if getattr(self, name)]
        if given == ["table", "rows"] or (len(given) == 1 and given != ["table"]):
            self._refuse_keys_of_a_table(given[-1])
            return self
        if given == ["table"]:
            raise ValueError(
                Message("motion.table names a file whose rows were not read: load the design from its file")
            )
        names = listed([f"motion.{name}" for name in SOURCES if name != "rows"], "or")
        if not given:
            raise ValueError(Message("motion says nothing of the lift: add one of {names}", names=names))
        keep, *drop = given
        raise ValueError(
            Message(
                "motion has {given}, and takes one of {names}: keep {keep} and remove the others (on the command line "
                "with {drop})",
                given=listed(given, "and"),
                names=names,
                keep=keep,
                drop=" ".join(f"--set motion.{name}=" for name in drop),
            )
        )

    def _refuse_keys_of_a_table(self, source: str) -> None:
        if source != "rows":
            for key in ("table_unit", "table_angle", "smooth", "close"):
                if getattr(self, key) is not None:
                    raise ValueError(
                        Message(
                            "motion.{key} is for a table, and the motion has {source}: remove it (on the command line "
                            "with --set motion.{key}=)",
                            key=key,
                            source=source,
                        )
                    )

    @property
    def source(self) -> str:
        """Key that says what the motion is."""
        return next(name for name in ("segments", "points", "harmonics", "rows") if getattr(self, name))

    @property
    def shaping_key(self) -> str:
        """Key that shapes the motion, as messages name it."""
        return f"motion.{'table' if self.table else self.source}"


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
    if left > _SAME * whole:
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


def motion_of(section: MotionSection, kind: FollowerKind, *, corners: bool = True) -> "Motion":
    """Motion of a design.

    Args:
        section: section [motion].
        kind: kind of the follower, whose unit the heights must have.
        corners: whether the follower may have a corner of its path, so that a refusal may name it.

    Raises:
        ValueError: a height is in another unit than the follower moves in.
        DesignError: the motion does not fill the turn or does not close, its velocity jumps, or its table cannot be.
    """
    return SOURCES[section.source](section, kind, corners)


def _segments(section: MotionSection, kind: FollowerKind, corners: bool) -> "Motion":
    """Motion of rises and dwells."""
    from cadgen.laws.segments import MotionSpan, SegmentMotion

    items, turns = section.segments, section.machine_turns or 1.0
    # At cam angle 0 the lift is 0, or what the first segment's polynomial asks for there.
    begins = (value for angle, order, value in items[0].conditions or () if angle == 0 and order == 0)
    at, first = 0.0, _value(next(begins, 0.0), kind)
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
        repeat=section.repeat or 1,
        machine_turns=turns,
        allow_velocity_jump=bool(section.allow_velocity_jump),
        corners=corners,
    )


def _conditions(number: int, item: MotionSegment, span: "MotionSpan", kind: FollowerKind) -> tuple["Condition", ...]:
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
        found.append(Condition(angle / width, int(order), _value(value, kind) * span.width**order))
    ends = {0.0: span.before, 1.0: span.after}
    for condition in found:
        if condition.order == 0 and condition.share in ends:
            meant = ends[condition.share]
            if abs(condition.value - meant) > _SAME * max(abs(meant), abs(condition.value)):
                raise DesignError(
                    "motion.segments.{number}.conditions give {given:.10g} {unit} at {angle:g} degrees, where the "
                    "motion "
                    "has {meant:.10g}: set that or leave the condition out",
                    number=number,
                    given=_shown(condition.value, kind),
                    meant=_shown(meant, kind),
                    unit=_unit_shown(kind),
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
        return _value(value, kind) + (before if key.startswith("rise") else 0.0)
    if given:
        return _value(given[0], kind)
    if last:
        return first
    raise DesignError(
        "motion.segments.{number} ends at no height: add to_{unit} to it, or a condition [{angle:g}, 0, lift]",
        number=number,
        unit="mm" if kind.unit == MM else "deg",
        angle=item.in_deg or 0.0,
    )


def _refuse_open(items: tuple[MotionSegment, ...], spans: list["MotionSpan"], kind: FollowerKind) -> None:
    """Refuse segments that end at another height than they begin at."""
    begin, end = spans[0].before, spans[-1].after
    size = max(abs(height) for span in spans for height in (span.before, span.after))
    if abs(end - begin) <= _SAME * size:
        return
    last = next(number for number in range(len(items) - 1, -1, -1) if items[number].dwell_deg is None)
    key = items[last].height
    if key is None:
        cure = Message(
            "give motion.segments.{number} the lift {value:.10g} at its end",
            number=last + 1,
            value=_shown(begin, kind),
        )
    else:
        base = spans[last].before if key[0].startswith("rise") else 0.0
        cure = Message(
            "set motion.segments.{number}.{key} to {value:.10g}",
            number=last + 1,
            key=key[0],
            value=_shown(begin - base, kind),
        )
    raise DesignError(
        "the motion begins at {begin:.10g} {unit} and ends at {end:.10g}, which is a jump at cam angle 0: {cure}",
        begin=_shown(begin, kind),
        end=_shown(end, kind),
        unit=_unit_shown(kind),
        cure=cure,
    )


def _points(section: MotionSection, kind: FollowerKind, corners: bool) -> "Motion":
    """Periodic quintic spline through points."""
    from cadgen.laws.lift_table import points_motion

    points = section.points or ()
    _refuse_order("motion.points", points)
    whole = 360 * (section.machine_turns or 1.0) / (section.repeat or 1)
    reach = points[-1][0] - points[0][0]
    if reach > whole * (1 - _SAME):
        cure = (
            Message(
                "remove the last one, which is the first one again (--set motion.points.{number}=)", number=len(points)
            )
            if abs(reach - whole) <= _SAME * whole and points[0][1] == points[-1][1]
            else Message("remove those beyond it")
        )
        raise DesignError(
            "the points of motion.points reach over {reach:g} degrees; they must reach over less than {whole:g}: "
            "{cure}",
            reach=reach,
            whole=whole,
            cure=cure,
        )
    angle, height = _columns(points, section.machine_turns or 1.0, section.repeat or 1)
    return points_motion(angle, height * _value(1.0, kind), kind.unit)


def _harmonics(section: MotionSection, kind: FollowerKind, corners: bool) -> "Motion":
    """Motion of harmonics."""
    from cadgen.laws.series import HarmonicMotion

    lobes, found = section.repeat or 1, {}
    for place, (number, cosine, sine) in enumerate(section.harmonics or (), 1):
        if number not in range(_MOST_HARMONIC + 1) or number in found:
            raise DesignError(
                "motion.harmonics.{place} is for k = {number:g}; k must be a whole number from 0 to {most}, each once: "
                "correct it",
                place=place,
                number=number,
                most=_MOST_HARMONIC,
            )
        found[number] = (int(number) * lobes, _value(cosine, kind), _value(sine, kind))
    return HarmonicMotion.of(list(found.values()), kind.unit)


def _table(section: MotionSection, kind: FollowerKind, corners: bool) -> "Motion":
    """Motion of a lift table."""
    from cadgen.laws.lift_table import LEAST_ROWS, table_motion

    rows, name = section.rows or (), section.shaping_key
    if len(rows) < LEAST_ROWS:
        raise DesignError(
            "{name} has {count} rows; it needs at least {least}: add more", name=name, count=len(rows), least=LEAST_ROWS
        )
    _refuse_order(name, rows)
    machine = section.machine_turns is not None and section.table_angle != TableAngle.CAM
    turns, lobes = (section.machine_turns or 1.0) if machine else 1.0, section.repeat or 1
    reach, whole = rows[-1][0] - rows[0][0], 360 * turns / lobes
    if reach > whole * (1 + _SAME):
        raise DesignError(
            "the rows of {name} reach over {reach:g} degrees; they must reach over {whole:g} at most: remove those "
            "beyond it",
            name=name,
            reach=reach,
            whole=whole,
        )
    unit = section.table_unit or (TableUnit.MM if kind.unit == MM else TableUnit.DEG)
    if (unit == TableUnit.DEG) != (kind.unit != MM):
        raise DesignError(
            'motion.table_unit is "{unit}", and a follower of kind "{code}" moves in {spoken}: set '
            'motion.table_unit to "{right}"',
            unit=unit.value,
            code=kind.code,
            spoken=_spoken(kind.unit),
            right="mm" if kind.unit == MM else "deg",
        )
    scale = {TableUnit.MM: 1.0, TableUnit.INCH: _INCH_MM, TableUnit.DEG: radians(1.0)}[unit]
    angle, height = _columns(rows, turns, 1)
    smooth, ramps = bool(section.smooth), section.close is not None
    return table_motion(angle, height * scale, kind.unit, lobes=lobes, smooth=smooth, ramps=ramps, key="motion.close")


SOURCES: Mapping[str, Callable[[MotionSection, FollowerKind, bool], "Motion"]] = {
    "segments": _segments,
    "points": _points,
    "harmonics": _harmonics,
    "table": _table,
    "rows": _table,
}


def _columns(rows: tuple[tuple[float, float], ...], turns: float, lobes: int) -> tuple["Array", "Array"]:
    """Cam angles, rad, and heights of rows, repeated for every lobe."""
    import numpy as np

    angle, height = np.array(rows, dtype=float).T
    angle = np.radians(angle / turns)
    return np.concatenate([angle + lobe * 2 * np.pi / lobes for lobe in range(lobes)]), np.tile(height, lobes)


def _refuse_order(name: str, rows: tuple[tuple[float, float], ...]) -> None:
    """Refuse rows whose angles do not grow."""
    for number, ((before, _), (angle, _)) in enumerate(pairwise(rows), 2):
        if angle == before:
            raise DesignError(
                "row {number} of {name} repeats the angle of the row before it, {angle:g} degrees: remove one of the "
                "two",
                number=number,
                name=name,
                angle=angle,
            )
        if angle < before:
            raise DesignError(
                "row {number} of {name} is at {angle:g} degrees, after one at {before:g}, but angles must grow: sort "
                "the "
                "rows by their angles",
                number=number,
                name=name,
                angle=angle,
                before=before,
            )


def _value(value: float, kind: FollowerKind) -> float:
    """A height of the file in the motion's unit."""
    return value if kind.unit == MM else radians(value)


def _shown(value: float, kind: FollowerKind) -> float:
    """A height in the unit of the file."""
    return value if kind.unit == MM else degrees(value)


def _unit_shown(kind: FollowerKind) -> str:
    return "mm" if kind.unit == MM else "°"


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
