"""A motion of rises and dwells: each segment takes an angle, and a law leads from one height to the next."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees
from typing import ClassVar

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError
from cadgen.laws.law import MotionLaw
from cadgen.laws.motion import Motion
from cadgen.laws.unit import Unit
from cadgen.messages import Message

_WHOLE = 1e-9  # of a turn; the angles of the segments add up to it but for the rounding of decimals
# Share of the greatest value over the turn, of the same derivative or of the motion itself: a smaller jump is rounding.
_JUMP = 1e-9
_NAMES = (Message("motion"), Message("velocity"), Message("acceleration"))


@dataclass(frozen=True)
class MotionSpan:
    """Part of a turn with one law, or without motion.

    Attributes:
        start: cam angle at which it begins, rad.
        stop: cam angle at which it ends, rad.
        before: height at which it begins, in the motion's unit.
        after: height at which it ends, in the motion's unit.
        law: law that leads from one to the other; None for a dwell.
    """

    start: float
    stop: float
    before: float
    after: float
    law: MotionLaw | None

    def knots(self) -> tuple[Array, Array]:
        """Cam angles, rad, shape (n,), and height with two derivatives at them, shape (n, 3), of its own side."""
        if self.law is None:
            return np.array([self.start, self.stop]), np.array([[self.before, 0.0, 0.0], [self.after, 0.0, 0.0]])
        share = np.linspace(0.0, 1.0, self.law.pieces + 1)
        theta = self.start + share * (self.stop - self.start)
        theta[-1] = self.stop
        jets = self.law.jet(share) * (self.after - self.before) / (self.stop - self.start) ** np.arange(3)
        jets[:, 0] += self.before
        return theta, jets


@dataclass(frozen=True)
class Seam:
    """Place where two segments meet, and the lowest derivative that jumps there.

    Attributes:
        cam_angle: where, rad.
        order: 0 for the motion itself, 1 for its velocity, 2 for its acceleration.
        before: value on the side before, in the motion's unit by rad^order.
        after: value on the side behind.
    """

    cam_angle: float
    order: int
    before: float
    after: float


@dataclass(frozen=True)
class SegmentMotion(Motion):
    """Motion of rises and dwells.

    Attributes:
        segments: segments in order, which fill the turn.
    """

    segments: tuple[MotionSpan, ...] = ()

    key: ClassVar[str] = "motion.segments"

    @classmethod
    def of(cls, segments: Sequence[MotionSpan], unit: Unit) -> "SegmentMotion":
        """Motion of segments that fill the turn and close it.

        Args:
            segments: segments in order, each beginning where the one before ends.
            unit: unit of their heights.

        Raises:
            DesignError: they do not fill the turn, do not close, or the motion or its velocity jumps at a seam.
        """
        total = degrees(segments[-1].stop)
        if abs(segments[-1].stop - TURN) > _WHOLE * TURN:
            raise DesignError(
                "the segments of motion.segments take {total:.10g} degrees; they must take 360: "
                "change in_deg or dwell_deg of one by {missing:+.10g}",
                total=total,
                missing=360 - total,
            )
        angles, jets = zip(*(segment.knots() for segment in segments), strict=True)
        theta = np.concatenate(angles)
        theta[-1] = TURN
        made = cls(
            quintic_hermite(theta, np.concatenate(jets), periodic=True),
            np.array([]),
            unit=unit,
            segments=tuple(segments),
        )
        for seam in made.seams:
            if seam.order < 2:
                raise DesignError(
                    "the {what} jumps at {angle:.4g} degrees of cam angle from {before:.6g} to {after:.6g}, which no "
                    "follower can do: {cure}",
                    what=_NAMES[seam.order],
                    angle=degrees(seam.cam_angle),
                    before=seam.before,
                    after=seam.after,
                    cure=Message("let the rises and returns of motion.segments add up to 0, or end at to_mm = 0")
                    if seam.order == 0
                    else Message("take laws that fit each other there, such as polynomial_3_4_5"),
                )
        return made

    @property
    def seams(self) -> tuple[Seam, ...]:
        """Seams at which a derivative up to the second jumps, each with the lowest that does."""
        knots = [segment.knots()[1] for segment in self.segments]
        scale = np.max([np.abs(jets).max(axis=0) for jets in knots], axis=0)
        found = []
        for number, segment in enumerate(self.segments):
            before, after = knots[number - 1][-1], knots[number][0]
            jumps = np.flatnonzero(np.abs(after - before) > _JUMP * np.maximum(scale, scale[0]))
            if jumps.size:
                order = int(jumps[0])
                sides = np.where(
                    np.abs([before, after])[:, order] > _JUMP * scale[order], [before[order], after[order]], 0.0
                )
                found.append(Seam(segment.start, order, *sides.tolist()))
        return tuple(found)

    def softer(self, cam_angle: float, key: str = "") -> str:
        """Advice that makes the motion milder at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
            key: key that shapes the motion; the segment is named in its place.
        """
        number = self._moving(cam_angle)
        if self.q(cam_angle) < 0:
            return Message(
                "give the segment there more of the turn (motion.segments.{number}.in_deg), or lead it less far below "
                "the base circle",
                number=number,
            )
        return Message("give the segment there more of the turn (motion.segments.{number}.in_deg)", number=number)

    def higher(self, cam_angle: float) -> str:
        """Advice that keeps the follower farther from the camshaft at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
        """
        return Message("lead the follower less far in (motion.segments.{number})", number=self._moving(cam_angle))

    def _moving(self, cam_angle: float) -> int:
        """Number of the segment at a cam angle, from 1; of a dwell that of the segment before it, which leads there."""
        at = next((n for n, s in enumerate(self.segments) if cam_angle % TURN <= s.stop), len(self.segments) - 1)
        return next((n for n in range(at, -1, -1) if self.segments[n].law is not None), at) + 1

    def extrema(self) -> tuple[Array, Array]:
        """Cam angles of the peaks and of the valleys, rad, in order: of a dwell its beginning."""
        moves = [segment for segment in self.segments if segment.after != segment.before]
        turns = [(one, two) for one, two in zip(moves, moves[1:] + moves[:1], strict=True)]
        rises = [(one.stop % TURN, one.after > one.before, two.after > two.before) for one, two in turns]
        peaks = sorted(angle for angle, up, again in rises if up and not again)
        return np.array(peaks), np.array(sorted(angle for angle, up, again in rises if again and not up))
