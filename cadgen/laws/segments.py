"""A motion of rises and dwells: each segment takes an angle, and a law leads from one height to the next."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from math import degrees, radians
from typing import ClassVar

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError
from cadgen.laws.conditions import Condition, polynomial_law
from cadgen.laws.form import ORDERS
from cadgen.laws.law import MotionLaw
from cadgen.laws.motion import Motion, side_of
from cadgen.laws.table import POLYNOMIAL, law_of
from cadgen.laws.unit import Unit
from cadgen.messages import Message, joined

_WHOLE = 1e-9  # of a turn; the angles of the segments add up to it but for the rounding of decimals
# Share of the greatest value over the turn, of the same derivative or of the motion itself: a smaller jump is rounding.
# A law from outside may have its jerk by differences.
_JUMP = np.array([1e-9, 1e-9, 1e-9, 1e-6])
_NAMES = (Message("motion"), Message("velocity"), Message("acceleration"), Message("jerk"))
_LIKE_RADIANS = 0.01  # of a turn, within which angles add up to it as radians do
_SAME = 1e-9  # rad; nearer to a seam than that an angle is at it
_SNAP = 1e-12  # of the share; nearer to a seam of the law than that a share is taken as the seam itself
_MOST_TRIED = 3  # segments that become polynomials together, where one is not enough
_MOST_CANDIDATES = 12
_LEAST_LEFT = radians(1.0)  # of a segment that gives some of its angle to another
_HALF_CYCLOID = 2.0  # velocity of half a cycloid at its fast end, in rises by shares


@dataclass(frozen=True)
class MotionSpan:
    """Part of a turn with one law, or without motion.

    Attributes:
        start: cam angle at which it begins, rad.
        stop: cam angle at which it ends, rad.
        before: height at which it begins, in the motion's unit.
        after: height at which it ends, in the motion's unit.
        law: law that leads from one to the other; None for a dwell, or for a polynomial that is yet to be made.
        conditions: conditions of a polynomial, by the share, apart from what it takes from its neighbours; None for
            any other law.
        absolute: whether the values of the law are heights, and not shares of the rise.
    """

    start: float
    stop: float
    before: float
    after: float
    law: MotionLaw | None
    conditions: tuple[Condition, ...] | None = None
    absolute: bool = False

    @property
    def width(self) -> float:
        """Cam angle that it takes, rad."""
        return self.stop - self.start

    @property
    def moves(self) -> bool:
        """Whether it is no dwell."""
        return self.law is not None or self.conditions is not None

    def knots(self) -> tuple[Array, Array]:
        """Cam angles, rad, shape (n,), and height with two derivatives at them, shape (n, 3), of its own side."""
        if self.law is None:
            return np.array([self.start, self.stop]), np.array([[self.before, 0.0, 0.0], [self.after, 0.0, 0.0]])
        share, jets = self.law.knots()
        theta = self.start + share * self.width
        theta[-1] = self.stop
        return theta, self._scaled(jets)

    def jets(self, cam_angle: Array, *, before: bool = False) -> Array:
        """Height with three derivatives by the cam angle, from the law itself, shape (n, 4).

        Args:
            cam_angle: cam angles within the span, rad, shape (n,).
            before: whether values at a seam of the law are those of the side before it.
        """
        if self.law is None:
            value = np.zeros((len(cam_angle), ORDERS))
            value[:, 0] = self.before
            return value
        share = np.clip((cam_angle - self.start) / self.width, 0.0, 1.0)
        for seam in self.law.seams:
            share[np.abs(share - seam) < _SNAP] = seam
        return self._scaled(self.law.derivatives(share, before=before))

    @cached_property
    def ends(self) -> Array:
        """Height with three derivatives at its beginning and at its end, each of its own side, shape (2, 4)."""
        return np.vstack([self.jets(np.array([self.start])), self.jets(np.array([self.stop]), before=True)])

    @property
    def seams(self) -> Array:
        """Cam angles inside at which a derivative jumps, rad."""
        return self.start + np.array(self.law.seams if self.law else ()) * self.width

    @property
    def mirrored(self) -> "MotionSpan":
        """Span of the cam that turns the other way."""
        law = self.law and (self.law.turned if self.absolute else self.law.backwards)
        return MotionSpan(TURN - self.stop, TURN - self.start, self.after, self.before, law, None, self.absolute)

    def _scaled(self, jets: Array) -> Array:
        rise, base = (1.0, 0.0) if self.absolute else (self.after - self.before, self.before)
        value = jets * rise / self.width ** np.arange(jets.shape[1])
        value[:, 0] += base
        return value


@dataclass(frozen=True)
class Seam:
    """Place where two segments, or two parts of a law, meet.

    Attributes:
        cam_angle: where, rad.
        order: lowest derivative that jumps there, 0 for the motion itself; None where none jumps up to the third.
        before: value of it on the side before, in the motion's unit by rad^order.
        after: value on the side behind.
        states: letters of VDI 2143 for the motion on either side: R rest, G constant velocity, U turning point, B in
            motion.
        segment: number of the segment that begins there, or in which the seam lies, from 1.
        inside: whether it lies in a segment, where two parts of its law meet.
    """

    cam_angle: float
    order: int | None
    before: float
    after: float
    states: tuple[str, str]
    segment: int
    inside: bool


@dataclass(frozen=True)
class JumpCure:
    """Change of a design that ends jumps of its motion.

    Attributes:
        changes: new value by key of a design; items of lists count from 1.
        text: the change in words.
    """

    changes: Mapping[str, object]
    text: str


class VelocityJumpError(DesignError):
    """Jumps of the velocity, with the changes that end them."""

    places = unit = ""
    cures: tuple[JumpCure, ...] = ()

    @classmethod
    def of(cls, places: str, unit: str, cures: Sequence[JumpCure]) -> "VelocityJumpError":
        """Refusal of jumps.

        Args:
            places: cam angles of the jumps and what jumps there, in words.
            unit: symbol of the motion's unit.
            cures: changes that end the jumps.
        """
        made = cls(
            "the velocity jumps {places} {unit}/rad, which no follower can do: {ways}",
            places=places,
            unit=unit,
            ways=joined((cure.text for cure in cures), Message(", or "))
            if cures
            else Message("take laws that meet each other there"),
        )
        made.places, made.unit, made.cures = places, unit, tuple(cures)
        return made

    def tried(self, refusal_of: Callable[[Mapping[str, object]], Message | None]) -> "VelocityJumpError":
        """Refusal of the jump with the changes that leave a whole cam; with the first one and its refusal if none does.

        Args:
            refusal_of: function that gives the refusal of the design with changed keys, None if it is accepted.
        """
        refusals = [refusal_of(cure.changes) for cure in self.cures]
        kept = [cure for cure, refusal in zip(self.cures, refusals, strict=True) if refusal is None]
        if not kept and refusals:
            text = Message("{change}, and then: {refusal}", change=self.cures[0].text, refusal=refusals[0])
            kept = [JumpCure(self.cures[0].changes, text)]
        return self.of(self.places, self.unit, kept)


@dataclass(frozen=True)
class SegmentMotion(Motion):
    """Motion of rises and dwells.

    Attributes:
        segments: segments in order, which fill the turn.
        repeat: times that the first of them are repeated in the turn.
    """

    segments: tuple[MotionSpan, ...] = ()
    repeat: int = 1

    key: ClassVar[str] = "motion.segments"

    @classmethod
    def of(
        cls,
        segments: Sequence[MotionSpan],
        unit: Unit,
        *,
        repeat: int = 1,
        machine_turns: float = 1.0,
        allow_velocity_jump: bool = False,
        corners: bool = True,
    ) -> "SegmentMotion":
        """Motion of segments that fill the turn, or an equal part of it, and close it.

        Args:
            segments: segments in order, each beginning where the one before ends.
            unit: unit of their heights.
            repeat: times that they are repeated in a turn.
            machine_turns: degrees of the design file in a degree of cam angle.
            allow_velocity_jump: whether the velocity may jump, which makes a corner of the path of the follower.
            corners: whether the follower may have such a corner, so that a refusal may name it.

        Raises:
            DesignError: they do not fill the turn, do not close, conditions make no polynomial, or the motion or its
                velocity jumps at a seam.
        """
        whole = TURN / repeat
        if abs(segments[-1].stop - whole) > _WHOLE * TURN:
            raise _does_not_fill(segments, whole, machine_turns)
        segments = [*segments[:-1], replace(segments[-1], stop=whole)]
        first = _completed(segments)
        spans = tuple(
            replace(span, start=span.start + number * whole, stop=span.stop + number * whole)
            for number in range(repeat)
            for span in first
        )
        spans = (*spans[:-1], replace(spans[-1], stop=TURN))
        angles, jets = zip(*(span.knots() for span in spans), strict=True)
        theta = np.concatenate(angles)
        theta[-1] = TURN
        curve = quintic_hermite(theta, np.concatenate(jets), periodic=True)
        made = cls(curve, np.array([]), unit=unit, segments=spans, repeat=repeat)
        jumps = [seam for seam in made.seams if seam.order is not None and seam.order < 2]
        if not jumps:
            return made
        broken = next((seam for seam in jumps if seam.order == 0), None)
        if broken is not None:
            raise DesignError(
                "the motion jumps at {angle:.4g} degrees of cam angle from {before:.6g} to {after:.6g}, which no "
                "follower can do: let the rises and returns of motion.segments add up to 0, or end at to_mm = 0",
                angle=degrees(broken.cam_angle),
                before=broken.before,
                after=broken.after,
            )
        if not allow_velocity_jump:
            raise _velocity_jumps(segments, jumps, unit, machine_turns, corners=corners)
        kinks = [seam.cam_angle + number * whole for number in range(repeat) for seam in jumps]
        return replace(made, kinks=np.array(kinks))

    @property
    def count(self) -> int:
        """Number of segments in the design, before they are repeated."""
        return len(self.segments) // self.repeat

    def continuous(self, cam_angle: float) -> int:
        """Number of values that are continuous at a cam angle: the motion and its first derivatives, 3 at most.

        Args:
            cam_angle: cam angle, rad.
        """
        whole = TURN / self.repeat
        apart = [((cam_angle - seam.cam_angle + whole / 2) % whole - whole / 2, seam.order) for seam in self.seams]
        here = [order for angle, order in apart if abs(angle) < _SAME]
        return min((order for order in here if order is not None), default=ORDERS - 1)

    def jets(self, cam_angle: Array, *, before: bool = False) -> Array:
        """Motion with its first three derivatives by the cam angle, from the laws, shape (n, 4).

        Args:
            cam_angle: cam angles, rad, shape (n,).
            before: whether values at a seam are those of the side before it.
        """
        ends = np.array([*(span.start for span in self.segments), TURN])
        number, angle = side_of(ends, cam_angle, before)
        value = np.empty((len(angle), ORDERS))
        for index in np.unique(number):
            here = number == index
            value[here] = self.segments[index].jets(angle[here], before=before)
        return value

    @property
    def breaks(self) -> Array:
        """Cam angles of all seams, from 0 to a turn, rad."""
        inside = [angle for span in self.segments for angle in span.seams]
        return np.unique([*(span.start for span in self.segments), TURN, *inside])

    @property
    def bends(self) -> Array:
        """Cam angles within the turn at which the acceleration jumps, rad, shape (n,)."""
        first = [seam.cam_angle for seam in self.seams if seam.order == ORDERS - 2]
        return np.sort((np.array(first)[:, None] + TURN / self.repeat * np.arange(self.repeat)).ravel() % TURN)

    @cached_property
    def joints(self) -> tuple[Seam, ...]:
        """Every place where segments or parts of a law meet, with the lowest derivative up to the third that jumps.

        Of a motion that is repeated, those of its first part.
        """
        sizes = [np.abs(span.jets(np.linspace(span.start, span.stop, 65))).max(axis=0) for span in self.segments]
        scale = np.max(sizes, axis=0)
        least = _JUMP * np.maximum(scale, scale[0])
        found = []
        for number, span in enumerate(self.segments[: self.count]):
            sides = [(span.start, self.segments[number - 1].ends[1], span.ends[0])]
            for angle in span.seams:
                before, behind = (span.jets(np.array([angle]), before=side)[0] for side in (True, False))
                sides.append((float(angle), before, behind))
            for place, (angle, before, behind) in enumerate(sides):
                both = np.where(np.abs([before, behind]) > least, [before, behind], 0.0)
                jumps = np.flatnonzero(np.abs(behind - before) > least)
                order = int(jumps[0]) if jumps.size else None
                one, two = both[:, order].tolist() if order is not None else (0.0, 0.0)
                states = (state_of(*both[0, 1:3]), state_of(*both[1, 1:3]))
                found.append(Seam(angle, order, one, two, states, number + 1, inside=bool(place)))
        return tuple(found)

    @property
    def seams(self) -> tuple[Seam, ...]:
        """Seams at which a derivative up to the second jumps, each with the lowest that does."""
        return tuple(seam for seam in self.joints if seam.order is not None and seam.order < ORDERS - 1)

    @property
    def milder(self) -> tuple[int, ...]:
        """Numbers of the segments that become polynomials so that no acceleration jumps; empty if none were found."""
        return polynomials(self.segments[: self.count], 2)

    @property
    def vdi(self) -> tuple[str, ...]:
        """Letters of VDI 2143 that its neighbours ask of each segment of the design, such as RR or RG."""
        between = [seam for seam in self.joints if not seam.inside]
        return tuple(
            between[number].states[0] + between[(number + 1) % len(between)].states[1] for number in range(self.count)
        )

    @cached_property
    def mirrored(self) -> "SegmentMotion":
        """The motion of a cam that turns the other way: q at minus the cam angle."""
        return replace(super().mirrored, segments=tuple(span.mirrored for span in self.segments[::-1]))

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
        """Number of the segment that leads to the height at a cam angle, from 1: at a dwell the one before it."""
        at = next((n for n, s in enumerate(self.segments) if cam_angle % TURN <= s.stop), len(self.segments) - 1)
        return next((n for n in range(at, -1, -1) if self.segments[n].moves), at) % self.count + 1

    def extrema(self) -> tuple[Array, Array]:
        """Cam angles of the peaks and of the valleys, rad, in order: of a dwell its beginning."""
        if any(span.absolute for span in self.segments):
            return super().extrema()  # a polynomial may turn inside its segment
        moves = [segment for segment in self.segments if segment.after != segment.before]
        turns = [(one, two) for one, two in zip(moves, moves[1:] + moves[:1], strict=True)]
        rises = [(one.stop % TURN, one.after > one.before, two.after > two.before) for one, two in turns]
        peaks = sorted(angle for angle, up, again in rises if up and not again)
        return np.array(peaks), np.array(sorted(angle for angle, up, again in rises if again and not up))


def state_of(velocity: float, acceleration: float) -> str:
    """Letter of VDI 2143 for a motion at an end: R rest, G constant velocity, U turning point, B in motion.

    Args:
        velocity, acceleration: first two derivatives, in the unit of the motion by rad, 0 where they are but rounding.
    """
    return {(False, False): "R", (True, False): "G", (False, True): "U", (True, True): "B"}[
        velocity != 0, acceleration != 0
    ]


def _completed(segments: Sequence[MotionSpan]) -> list[MotionSpan]:
    """The segments with every polynomial made, by its conditions and its neighbours."""
    made = []
    for number, span in enumerate(segments):
        if span.conditions is None:
            made.append(span)
            continue
        behind = segments[(number + 1) % len(segments)]
        conditions = [
            *_at_end(span, 0.0, span.before, _state(segments[number - 1], 1)),
            *_at_end(span, 1.0, span.after, _state(behind, 0)),
            *(each for each in span.conditions if each.share not in (0.0, 1.0)),
        ]
        law = polynomial_law(conditions)
        if law is None:
            raise DesignError(
                "motion.segments.{number}.conditions make no polynomial of degree {degree}, for some of them say the "
                "same and leave another thing open: move one a little, or give the lift (order 0) at its place, too",
                number=number + 1,
                degree=len(conditions) - 1,
            )
        made.append(replace(span, law=law, absolute=True))
    return made


def _at_end(span: MotionSpan, share: float, height: float, neighbour: tuple[float, float]) -> list[Condition]:
    """Conditions at an end of a polynomial: its height, and derivatives, those given or the first two of its neighbour.

    Args:
        span: polynomial.
        share: 0 at its beginning, 1 at its end.
        height: height there, in the motion's unit.
        neighbour: velocity and acceleration of the neighbour, by rad.
    """
    given = [each for each in span.conditions or () if each.share == share and each.order]
    beside = [Condition(share, order, value * span.width**order) for order, value in enumerate(neighbour, 1)]
    return [Condition(share, 0, height), *(given or beside)]


def _state(span: MotionSpan, end: int) -> tuple[float, float]:
    """Velocity and acceleration at an end of a span, by rad; of a polynomial those given there, else rest."""
    if span.conditions is None:
        velocity, acceleration = span.ends[end, 1:3].tolist()
        return velocity, acceleration
    given = {each.order: each.value for each in span.conditions if each.share == float(end)}
    return given.get(1, 0.0) / span.width, given.get(2, 0.0) / span.width**2


def _does_not_fill(segments: Sequence[MotionSpan], whole: float, machine_turns: float) -> DesignError:
    """Refusal of segments that take more or less than the turn, with the segment whose angle makes it whole."""
    total, missing = (degrees(angle) * machine_turns for angle in (segments[-1].stop, whole - segments[-1].stop))
    turn = radians(total + missing)
    if abs(total - turn) < _LIKE_RADIANS * turn:
        return DesignError(
            "the angles of motion.segments make {total:.5g} together, as angles in radians do, and they are degrees: "
            "multiply each in_deg and dwell_deg by {share:.10g}",
            total=total,
            share=(total + missing) / total,
        )
    # A dwell changes nothing else; then a law; a polynomial's conditions stand at angles.
    order = sorted(
        (span.conditions is not None, span.moves, -span.width, number) for number, span in enumerate(segments)
    )
    for _, moves, width, number in order:
        angle = -degrees(width) * machine_turns + missing
        if angle > 1:
            cure: str = Message(
                "set motion.segments.{number}.{key} to {angle:.10g}",
                number=number + 1,
                key="in_deg" if moves else "dwell_deg",
                angle=angle,
            )
            break
    else:
        cure = Message("multiply each in_deg and dwell_deg by {share:.10g}", share=(total + missing) / total)
    return DesignError(
        "the segments of motion.segments take {total:.10g} degrees; they must take {whole:.10g}: {cure}",
        total=total,
        whole=total + missing,
        cure=cure,
    )


def _velocity_jumps(
    segments: Sequence[MotionSpan], jumps: Sequence[Seam], unit: Unit, machine_turns: float, *, corners: bool
) -> VelocityJumpError:
    """Refusal of jumps of the velocity, with the laws that meet their neighbours, which were tried."""
    places = joined(
        Message(
            "at {angle:.4g} degrees from {before:.4g} to {after:.4g}",
            angle=degrees(seam.cam_angle),
            before=seam.before,
            after=seam.after,
        )
        for seam in jumps
    )
    numbers = polynomials(segments, 1)
    cures = []
    if numbers:
        text = Message("set {changes}, which meets its neighbours", changes=polynomial_changes(numbers))
        cures.append(JumpCure({f"motion.segments.{number}.law": POLYNOMIAL for number in numbers}, text))
    if corners:
        text = Message("set motion.allow_velocity_jump to true for a corner there")
        cures.append(JumpCure({"motion.allow_velocity_jump": True}, text))
    cures += _half_laws(segments, jumps, machine_turns)
    return VelocityJumpError.of(places, unit.symbol, cures)


def polynomial_changes(numbers: Sequence[int]) -> str:
    """Changes in words that make segments polynomials.

    Args:
        numbers: numbers of the segments, from 1.
    """
    return joined(
        (Message('motion.segments.{number}.law to "{law}"', number=number, law=POLYNOMIAL) for number in numbers),
        Message(" and "),
    )


def polynomial_overrides(numbers: Sequence[int]) -> tuple[str, ...]:
    """Changed keys that make segments polynomials.

    Args:
        numbers: numbers of the segments, from 1.
    """
    return tuple(f"motion.segments.{number}.law={POLYNOMIAL}" for number in numbers)


def polynomials(segments: Sequence[MotionSpan], order: int) -> tuple[int, ...]:
    """Numbers of the fewest segments that as polynomials meet their neighbours, from 1; empty if none do.

    They are tried one by one, then together.

    Args:
        segments: segments of the design.
        order: highest derivative that is to be without a jump, 1 for the velocity, 2 for the acceleration.
    """
    count, jumping = len(segments), _jumping(segments, order)
    moving = [
        number
        for number in range(count)
        if segments[number].moves and {number, number + 0.5, (number + 1) % count} & jumping
    ][:_MOST_CANDIDATES]
    # Constant velocity is what the neighbours have to meet, and is given up last.
    for candidates in ([number for number in moving if not _straight(segments[number])], moving):
        sizes = range(1, min(_MOST_TRIED, len(candidates)) + 1)
        for chosen in (each for size in sizes for each in combinations(candidates, size)):
            made = [
                replace(span, law=None, conditions=(), absolute=False) if number in chosen else span
                for number, span in enumerate(segments)
            ]
            if not _jumping(_completed(made), order):
                return tuple(number + 1 for number in sorted(chosen))
    return ()


def _jumping(spans: Sequence[MotionSpan], order: int) -> set[float]:
    """Numbers of spans at whose beginning a derivative from the first to an order jumps; n + 0.5 if inside span n."""
    ends = np.array([span.ends for span in spans])
    sides: list[tuple[float, Array, Array]] = [
        (number, ends[number - 1, 1], ends[number, 0]) for number in range(len(spans))
    ]
    for number, span in enumerate(spans):
        before, behind = (span.jets(span.seams, before=side) for side in (True, False))
        sides += [(number + 0.5, one, two) for one, two in zip(before, behind, strict=True)]
    scale = np.max([np.abs(side) for _, *pair in sides for side in pair], axis=0)
    least = _JUMP * np.maximum(scale, scale[0])
    return {place for place, one, two in sides if (np.abs(one - two) > least)[1 : order + 1].any()}


def _straight(span: MotionSpan) -> bool:
    return span.law is not None and span.law.code == "constant_velocity"


def _half_laws(segments: Sequence[MotionSpan], jumps: Sequence[Seam], machine_turns: float) -> list[JumpCure]:
    """Half laws that lead from rest to a neighbour that moves, or from it to rest, which end every jump.

    Each takes the angle that its speed asks for, and another segment what is left of the turn.
    """
    said: dict[str, JumpCure] = {}
    for seam in jumps:
        number = seam.segment - 1
        for mover, fixed, before in ((number - 1, number, True), (number, number - 1, False)):
            span, velocity = segments[mover], segments[fixed].ends[0 if before else 1, 1]
            rise = span.after - span.before
            if span.law is None or _straight(span) or rise * velocity <= 0:
                continue
            code, width = "half_cycloid_1" if before else "half_cycloid_2", _HALF_CYCLOID * rise / velocity
            law = replace(span, law=law_of(code), stop=span.start + width, absolute=False)
            other = _gives(segments, mover % len(segments), fixed % len(segments), law)
            if other is None:
                continue
            left = segments[other].width + span.width - width
            this, that = (f"motion.segments.{each % len(segments) + 1}" for each in (mover, other))
            key = "in_deg" if segments[other].moves else "dwell_deg"
            angle, remaining = (f"{degrees(each) * machine_turns:.12g}" for each in (width, left))
            text = Message(
                'set {this}.law to "{code}" with {this}.in_deg = {angle} and {that}.{key} = {left}',
                this=this,
                code=code,
                angle=angle,
                that=that,
                key=key,
                left=remaining,
            )
            changed = {f"{this}.law": code, f"{this}.in_deg": float(angle), f"{that}.{key}": float(remaining)}
            said[text] = JumpCure(changed, text)
    return list(said.values())


def _gives(segments: Sequence[MotionSpan], mover: int, fixed: int, law: MotionSpan) -> int | None:
    """Segment that makes up for the angle of a new law, so that no velocity jumps; dwells first, the widest of them."""
    order = sorted(range(len(segments)), key=lambda number: (segments[number].moves, -segments[number].width))
    for number in order:
        span = segments[number]
        left = span.width + segments[mover].width - law.width
        if number in (mover, fixed) or span.conditions is not None or left < _LEAST_LEFT:
            continue
        made = [*segments]
        made[mover], made[number] = law, replace(span, stop=span.start + left)
        if not _jumping(_completed(made), 1):
            return number
    return None
