"""Timing diagram of a cam by its motion: lift over cam angle, its segments with their laws, and the datum.

Lengths of its view are mm on paper: they are divided by the scale of the sheet, by which all views are drawn.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.laws.motion import Motion
from cadgen.laws.segments import SegmentMotion
from cadgen.laws.unit import MM, TAN
from cadgen.messages import Message
from cadgen.output.drawing.sheet import (
    EDGE,
    HEIGHTS,
    LEFT,
    TEXT,
    TITLE_SIZE,
    Label,
    LineKind,
    SheetTable,
    Stroke,
    View,
    arrow,
    rounded,
    width_of,
)

_STATIONS = 720  # of the curve, and at each end of a segment
_ROWS = 12  # most segments in the table
_WIDTHS = (7.0, 27.0, 17.0, 40.0)  # of the columns of the table, mm
_LEFT, _RIGHT, _BELOW, _ABOVE = 13.0, 6.0, 9.0, 9.0  # mm from the frame of the diagram to its axes
_SAME = 1e-6  # of the range; levels nearer to each other are one
_BESIDE_ARROW = 1.4  # mm on paper from the datum to the number of a short segment
_APART = 3.2  # mm on paper between the numbers of two levels, at least


@dataclass(frozen=True, slots=True, kw_only=True)
class TimedSegment:
    """Segment of a timing diagram.

    Attributes:
        start: cam angle at which it begins, degrees.
        stop: cam angle at which it ends, degrees.
        after: lift or swing at its end, mm or degrees.
        law: name of its law in words, or the word for a dwell.
    """

    start: float
    stop: float
    after: float
    law: str


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class TimingDiagram:
    """Lift of a follower over the turn, for a sheet.

    Attributes:
        angles: cam angles, degrees, shape (n,).
        lift: lift in mm, or swing in degrees, shape (n,).
        unit: unit of the lift.
        noun: word for the lift.
        segments: segments of the turn; none of a motion that has none.
        repeat: lobes, whose first the table has.
    """

    angles: Array
    lift: Array
    unit: str
    noun: str
    segments: tuple[TimedSegment, ...] = ()
    repeat: int = 1

    @classmethod
    def of(cls, motion: Motion) -> "TimingDiagram":
        """Timing diagram of a motion.

        Args:
            motion: motion of the follower.
        """

        def shown(q: Array) -> Array:
            if motion.unit == MM:
                return q
            return np.degrees(np.arctan(q) if motion.unit == TAN else q)

        segments: tuple[TimedSegment, ...] = ()
        if isinstance(motion, SegmentMotion):
            heights = shown(np.array([span.after for span in motion.segments]))
            segments = tuple(
                TimedSegment(
                    start=degrees(span.start),
                    stop=degrees(span.stop),
                    after=height,
                    law=Message(span.law.name if span.law else "dwell"),
                )
                for span, height in zip(motion.segments, heights.tolist(), strict=True)
            )
        ends = [np.radians(each.start) for each in segments]
        theta = np.unique(np.concatenate([np.linspace(0.0, TURN, _STATIONS + 1), ends]))
        return cls(
            angles=np.degrees(theta),
            lift=shown(np.asarray(motion.jets(theta)[:, 0])),
            unit="mm" if motion.unit == MM else "°",
            noun=Message("lift") if motion.unit == MM else Message("swing"),
            segments=segments,
            repeat=motion.repeat if isinstance(motion, SegmentMotion) else 1,
        )

    @property
    def range(self) -> tuple[float, float]:
        """Least and greatest lift, with 0 between them."""
        return min(float(self.lift.min()), 0.0), max(float(self.lift.max()), 0.0)

    def levels(self) -> Iterator[float]:
        """Lifts that are written at the axis: 0, the greatest, the least, and the ends of segments."""
        low, high = self.range
        seen: list[float] = []
        for level in (0.0, high, low, *(each.after for each in self.segments)):
            if all(abs(level - other) > _SAME * (high - low) for other in seen):
                seen.append(level)
                yield level

    def view(self, room: float, scale: float) -> View:
        """View of the diagram in the lower left corner of the sheet.

        Args:
            room: width that it may take, mm on paper.
            scale: mm on paper for a mm of the part.
        """
        wide = room - _LEFT - _RIGHT
        high = TITLE_SIZE[1] - _BELOW - _ABOVE
        low, top = self.range

        def x(angle: float) -> float:
            return wide * angle / 360.0

        def y(lift: float) -> float:
            return high * (lift - low) / ((top - low) or 1.0)

        def line(points: Array, kind: LineKind) -> Stroke:
            return Stroke(np.asarray(points, dtype=float) / scale, kind)

        def label(text: str, at: tuple[float, float], height: float = HEIGHTS[-1]) -> Label:
            return Label(text=text, at=(at[0] / scale, at[1] / scale), height=height)

        curves = [
            line(np.column_stack([x(1.0) * self.angles, [y(lift) for lift in self.lift]]), LineKind.VISIBLE),
            line(np.array([[0.0, y(0.0)], [wide, y(0.0)]]), LineKind.THIN),
            line(np.array([[0.0, 0.0], [0.0, high]]), LineKind.THIN),
        ]
        labels = [
            label(
                Message("{lift}, {unit}, over cam angle, °", lift=self.noun, unit=self.unit),
                (wide / 2, high + 6.6),
                TEXT,
            ),
            label("0°", (-4.5, high + 3.0)),
        ]
        # The datum, as the arrow at the zero mark of the face.
        curves += [
            Stroke(each.points / scale, each.line)
            for each in arrow(np.array([0.0, high + 6.0]), np.array([0.0, high + 0.5]), (2.0, 0.7))
        ]
        step = 30 if wide > 120.0 else 60
        for angle in range(0, 361, 30):
            curves.append(line(np.array([[x(angle), -1.2], [x(angle), 0.0]]), LineKind.THIN))
            if angle % step == 0:
                labels.append(label(f"{angle}", (x(angle), -3.4)))
        taken: list[float] = []
        for level in self.levels():
            curves.append(line(np.array([[-1.2, y(level)], [0.0, y(level)]]), LineKind.THIN))
            if all(abs(y(level) - other) >= _APART for other in taken):
                taken.append(y(level))
                text = rounded(level, 3 if abs(level) < 10 else 2)
                labels.append(label(text, (-1.8 - width_of(text) * HEIGHTS[-1] / 2, y(level))))
        for number, each in enumerate(self.segments, 1):
            if each.stop < 360.0 - 1e-9:
                curves.append(line(np.array([[x(each.stop), 0.0], [x(each.stop), high]]), LineKind.HIDDEN))
            room, text = x(each.stop - each.start), Message("{number} {law}", number=number, law=each.law)
            if width_of(text) * HEIGHTS[-1] > room:
                text = Message("{number}", number=number)
            if width_of(text) * HEIGHTS[-1] <= room:
                # Beside the arrow of the datum.
                least = _BESIDE_ARROW + width_of(text) * HEIGHTS[-1] / 2
                labels.append(label(text, (max(x(each.start) + room / 2, least), high + 2.4)))
        return View(place=(LEFT + _LEFT, EDGE + _BELOW), curves=tuple(curves), labels=tuple(labels))

    def table(self, at: tuple[float, float]) -> SheetTable | None:
        """Table of the segments; None for a motion without segments.

        Args:
            at: upper left corner on the paper, mm.
        """
        if not self.segments:
            return None
        first = self.segments[: len(self.segments) // self.repeat]
        rows = [
            (
                f"{number}",
                f"{rounded(each.start, 3)} – {rounded(each.stop, 3)}",
                rounded(each.after, 4),
                each.law,
            )
            for number, each in enumerate(first[:_ROWS], 1)
        ]
        if len(first) > _ROWS:
            rows[-1] = ("…", "…", "…", Message("{count} segments in all", count=len(first)))
        title = Message("segments")
        if self.repeat > 1:
            title = Message("segments of the first of {lobes} lobes", lobes=self.repeat)
        lift = Message("{lift}, {unit}", lift=self.noun, unit=self.unit)
        head = ("", Message("cam angle, °"), lift, Message("law"))
        return SheetTable(title=title, at=at, widths=_WIDTHS, rows=(head, *rows))
