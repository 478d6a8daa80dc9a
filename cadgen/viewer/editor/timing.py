"""Timing diagram of a motion that is edited: its segments, and the handles by which their ends and heights move.

All angles are those of the file: of the machine where the design has `motion.machine_turns`, and of the first lobe
where it has `motion.repeat`.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from cadgen.design.motion import MotionSection
from cadgen.design.schema import Design, MotionDesign
from cadgen.design.sources.segments import MotionSegment
from cadgen.laws.table import POLYNOMIAL, codes
from cadgen.laws.unit import MM
from cadgen.viewer.editor.text_changes import NewItem

_NEW_LAW = "polynomial_3_4_5"  # of a rise that is put in: it fits between rests
_ROUND = 9  # digits after the point of an angle: sums of decimals show no rounding


@dataclass(frozen=True)
class EditedNumber:
    """Number of the file that a handle moves.

    Attributes:
        key: dotted key.
        value: number now.
        sign: 1 where it grows with the move, -1 where it falls.
    """

    key: str
    value: float
    sign: int


@dataclass(frozen=True)
class EditedSegment:
    """Segment of the diagram.

    Attributes:
        number: number, from 1.
        start: angle at which it begins, degrees.
        stop: angle at which it ends.
        after: height at its end, mm or degrees.
        law: code of its law; empty for a dwell.
        law_key: key of its law; empty for a dwell.
        along: numbers that move with its end; none of the last, whose end is that of the turn.
        up: numbers that move with the height at its end; none where that height must close the motion.
    """

    number: int
    start: float
    stop: float
    after: float
    law: str
    law_key: str
    along: tuple[EditedNumber, ...]
    up: tuple[EditedNumber, ...]


@dataclass(frozen=True)
class EditedTiming:
    """Diagram of a motion.

    Attributes:
        segments: segments; none of a motion by points, harmonics or a table.
        turn: degrees of the file in a turn of the cam.
        unit: unit of the heights.
        laws: codes of the laws to choose from.
    """

    segments: tuple[EditedSegment, ...]
    turn: float
    unit: str
    laws: tuple[str, ...]

    @property
    def keys(self) -> frozenset[str]:
        """Keys that can be changed."""
        numbers = (number.key for each in self.segments for number in (*each.along, *each.up))
        return frozenset(numbers) | {each.law_key for each in self.segments if each.law_key}


def timing_of(design: Design | MotionDesign) -> EditedTiming | None:
    """Timing diagram of a design; None of a car's.

    Args:
        design: design as it is now.
    """
    if isinstance(design, Design):
        return None
    motion = design.motion
    return EditedTiming(
        segments=tuple(_segments(motion)),
        turn=360.0 * (motion.machine_turns or 1.0),
        unit="mm" if design.follower.registered.unit == MM else "°",
        laws=(*codes(), POLYNOMIAL),
    )


def _segments(motion: MotionSection) -> Iterator[EditedSegment]:
    at, height = 0.0, 0.0
    heights: list[EditedNumber] | None = (
        None  # numbers of the height that holds now; None where it is that of the start
    )
    movers = [number for number, each in enumerate(motion.segments) if each.dwell_deg is None]
    for number, each in enumerate(motion.segments):
        stop = round(at + _angle(each).value, _ROUND)
        if each.dwell_deg is None:
            # A polynomial without a height ends by a condition: [angle, order, value] at its last angle.
            ends = [value for angle, order, value in each.conditions or () if order == 0 and angle == each.in_deg]
            if each.height is not None:
                key, value = each.height
                height = value if key.startswith("to_") else height + value
            elif ends:
                height = ends[0]
            heights = _heights(motion, number, movers)
        along = (_moved(motion, number, 1), _moved(motion, number + 1, -1)) if number + 1 < len(motion.segments) else ()
        law_key = f"motion.segments.{number + 1}.law"
        yield EditedSegment(
            number=number + 1,
            start=at,
            stop=stop,
            after=height,
            law=each.law or "",
            law_key=law_key if each.law else "",
            along=along,
            up=tuple(heights or ()),
        )
        at = stop


def added(design: MotionDesign, number: int, width: float, height: float) -> tuple[NewItem, list[str]]:
    """New segment behind another one, and what changes with it: the other gives it some of its angle.

    It is a dwell where it ends at the height at which it begins; else a rise or return, of which a later rise takes up
    the height.

    Args:
        design: design as it is now.
        number: number of the segment that it follows, from 1.
        width: angle that it takes, degrees.
        height: height at its end, mm or degrees.
    """
    segments, before = design.motion.segments, [*_segments(design.motion)][number - 1].after
    angle = _angle(segments[number - 1])
    changes = [f"motion.segments.{number}.{angle.key}={round(angle.value - width, _ROUND)}"]
    if height == before:
        return {"dwell_deg": width}, changes
    later = next((place for place, each in enumerate(segments[number:], number + 2) if each.dwell_deg is None), None)
    if later is not None:
        changes += _led_by(segments[later - 2], later, before - height)
    unit = "mm" if design.follower.registered.unit == MM else "deg"
    return {f"to_{unit}": height, "in_deg": width, "law": _NEW_LAW}, changes


def taken_out(design: MotionDesign, number: int) -> list[str]:
    """Changes that come with a segment's removal: a neighbour takes its angle, another rise its height.

    Args:
        design: design as it is now.
        number: number of the segment, from 1.
    """
    segments, shown = design.motion.segments, [*_segments(design.motion)]
    width, changes = _angle(segments[number - 1]).value, []
    taker = number - 1 if number > 1 else 2
    if taker <= len(segments):
        angle, place = _angle(segments[taker - 1]), min(taker, number)
        changes.append(f"motion.segments.{place}.{angle.key}={round(angle.value + width, _ROUND)}")
    if segments[number - 1].dwell_deg is not None:
        return changes
    led = shown[number - 1].after - (shown[number - 2].after if number > 1 else shown[-1].after)
    movers = [place for place, each in enumerate(segments, 1) if each.dwell_deg is None and place != number]
    later = [place for place in movers if place > number]
    if later:
        return changes + _led_by(segments[later[0] - 1], later[0] - 1, led)
    if movers:  # the one before closes the motion then
        last = segments[movers[-1] - 1]
        key, _ = last.height or ("", 0.0)
        changes += (
            [f"motion.segments.{movers[-1]}.{key}={shown[number - 1].after}"]
            if key.startswith("to_")
            else _led_by(last, movers[-1], led)
        )
    return changes


def _led_by(segment: MotionSegment, place: int, more: float) -> list[str]:
    """Change of a segment that states how far it leads, so that it leads farther; none of one that states where to."""
    key, value = segment.height or ("", 0.0)
    return [f"motion.segments.{place}.{key}={round(value + more, _ROUND)}"] if key.startswith("rise_") else []


def _angle(segment: MotionSegment) -> EditedNumber:
    if segment.dwell_deg is not None:
        return EditedNumber("dwell_deg", segment.dwell_deg, 1)
    return EditedNumber("in_deg", segment.in_deg or 0.0, 1)


def _moved(motion: MotionSection, number: int, sign: int) -> EditedNumber:
    angle = _angle(motion.segments[number])
    return EditedNumber(f"motion.segments.{number + 1}.{angle.key}", angle.value, sign)


def _heights(motion: MotionSection, number: int, movers: list[int]) -> list[EditedNumber]:
    """Numbers of the height to which a segment leads; none for the last one, which closes the motion.

    Args:
        motion: section of the design.
        number: index of the segment.
        movers: indices of all segments that are no dwells.
    """
    own = motion.segments[number].height
    if own is None or number == movers[-1]:
        return []
    key, value = own
    made = [EditedNumber(f"motion.segments.{number + 1}.{key}", value, 1)]
    following = movers[movers.index(number) + 1]
    after = motion.segments[following].height
    if after is not None and after[0].startswith("rise_"):
        # What follows ends where it did.
        made.append(EditedNumber(f"motion.segments.{following + 1}.{after[0]}", after[1], -1))
    return made
