"""Room that a tool needs beyond teeth which stand beside a larger gear on one part.

A gear is blocked where its neighbour stands higher than its roots, by h = r_beside − r_root. A hob or a disc cutter of
the diameter D cuts to full depth at the end of the teeth only if its axis comes as far, and then reaches beyond by

    √(h (D − h)), h ≤ D / 2, of a spur gear.

Turned by the helix angle β it reaches √(h (D − h)) cos β + l sin β. A hob generates with the half length
l = h_fP / tan α_n. This is the least: a longer hob and its own lead need more. Usual diameters are those of DIN 8002.

A shaper's cutter needs a groove for its overtravel and the chips, usually 3 mm and 1 mm for each mm of the module: a
value of the trade, since no standard was at hand. A wire, a laser or a jet cuts through the whole width, and can cut no
teeth beside a larger gear. What is printed or moulded needs no room.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil, cos, inf, sin, sqrt, tan

from cadgen.check import Bound, Check, CheckCode
from cadgen.gears.choices import ToothCutting
from cadgen.gears.layout import TrainPart
from cadgen.gears.stage import Wheel
from cadgen.gears.tooth import GearForm
from cadgen.messages import Message

# Greatest module and diameter of a hob, mm (DIN 8002, read from a damaged print; the last by judgement).
_HOBS = (
    (1.4, 50.0), (1.8, 56.0), (2.24, 63.0), (2.8, 70.0), (3.55, 80.0), (4.5, 90.0), (5.6, 100.0), (7.1, 110.0),
    (9.0, 125.0), (inf, 140.0),
)  # fmt: skip
_SMALLEST = 20.0  # mm, of hobs for fine modules
_GROOVE = 3.0  # mm; a shaper's cutter needs this and a module
_STEPS = 10  # in a mm, of lengths that are proposed

CUT = {
    ToothCutting.HOBBED: Message("hobbed"),
    ToothCutting.SHAPED: Message("shaped"),
    ToothCutting.MILLED: Message("milled with a disc cutter"),
    ToothCutting.WIRE: Message("cut by wire, laser or jet"),
    ToothCutting.PRINTED: Message("printed or moulded"),
}


@dataclass(frozen=True, slots=True)
class Made:
    """How the teeth of a part are made.

    Attributes:
        place: place of its shaft in the section [train] of a design.
        cutting: how its teeth are cut; None where it is not stated.
        apart: whether its gears are cut as two parts and joined.
        cutter: diameter of the hob or the disc cutter, mm; None for the usual one.
        joined: what joins gears that are cut apart, in words.
    """

    place: str
    cutting: ToothCutting | None = None
    apart: bool = False
    cutter: float | None = None
    joined: str = ""


@dataclass(frozen=True, slots=True)
class Blocked:
    """Gear before whose teeth a larger one stands on its part.

    Attributes:
        number: 0 for the lower gear of the part, 1 for the upper one.
        gear: the gear.
        beside: diameter that stands before its teeth, mm.
        room: length between its teeth and that diameter, mm.
    """

    number: int
    gear: GearForm
    beside: float
    room: float

    def needs(self, cutting: ToothCutting, cutter: float | None = None) -> float:
        """Least room that its teeth need to be cut, mm; infinite by a wire, 0 if they are printed.

        Args:
            cutting: how they are cut.
            cutter: diameter of the hob or the disc cutter, mm; None for the usual one.
        """
        match cutting:
            case ToothCutting.PRINTED:
                return 0.0
            case ToothCutting.WIRE:
                return inf
            case ToothCutting.SHAPED:
                return _GROOVE + self.gear.normal_module
        diameter = usual_hob(self.gear.normal_module) if cutter is None else cutter
        height = min((self.beside - self.gear.root_diameter) / 2, diameter / 2)
        turned = abs(self.gear.helix_angle)
        reach = self.gear.dedendum_factor * self.gear.normal_module / tan(self.gear.normal_pressure_angle)
        return sqrt(height * (diameter - height)) * cos(turned) + reach * sin(turned)


def usual_hob(module: float) -> float:
    """Diameter of a hob of DIN 8002, mm; of modules below 1 smaller ones are sold, too.

    Args:
        module: normal module, mm.
    """
    return next(diameter for most, diameter in _HOBS if module <= most)


def blocked(part: TrainPart) -> Iterator[Blocked]:
    """Gears of a part that stand beside a larger one; none of a part with one gear.

    Args:
        part: part of a train.
    """
    if len(part.gears) < 2:
        return
    room = part.starts[1] - part.gears[0].width
    pairs: Sequence[tuple[Wheel, Wheel]] = (part.gears[:2], part.gears[1::-1])  # type: ignore[assignment]
    for number, (gear, other) in enumerate(pairs):
        if isinstance(gear, GearForm) and other.tip_diameter > gear.root_diameter:
            yield Blocked(number, gear, other.tip_diameter, room)


def cutting_checks(parts: Sequence[TrainPart], makings: Sequence[Made]) -> tuple[Check, ...]:
    """Room beyond the teeth of all parts that state how they are cut: the gear that lacks most, and those out of reach.

    Args:
        parts: parts on the shafts, from the drive on.
        makings: how each is made.
    """
    checks: list[Check] = []
    reached: list[Check] = []
    for part, made in zip(parts, makings, strict=True):
        if made.cutting is None or made.apart:
            continue
        for each in blocked(part):
            where = Message("{gear} on shaft {shaft}", gear=each.gear.noun, shaft=part.shaft)
            if made.cutting == ToothCutting.WIRE:
                name, advice = Message("teeth that a wire cannot reach"), _apart(made)
                reached.append(Check(CheckCode.TEETH_REACHED, name, 1.0, "", 0.0, Bound.MAX, where, advice))
            elif made.cutting != ToothCutting.PRINTED:
                needed = each.needs(made.cutting, made.cutter)
                name = Message("room beyond the teeth, {how}", how=CUT[made.cutting])
                advice = Message("give {collar}, or {apart}", collar=_collar(part, made, needed), apart=_apart(made))
                if each.needs(made.cutting, _SMALLEST) <= each.room < needed:
                    advice = Message("{cures}, or the train.cutter_diameter_mm of a smaller tool", cures=advice)
                checks.append(Check(CheckCode.TOOL_ROOM, name, each.room, "mm", needed, Bound.MIN, where, advice))
    least = min(checks, key=lambda check: check.room, default=None)
    return (*reached[:1], *([] if least is None else [least]))


def room_notes(parts: Sequence[TrainPart], makings: Sequence[Made]) -> tuple[Message, ...]:
    """Sentence on the gear that lacks most for any usual tool, of those of which it is not stated how they are cut.

    Args:
        parts: parts on the shafts, from the drive on.
        makings: how each is made.
    """
    lacking: list[tuple[float, Message]] = []
    for part, made in zip(parts, makings, strict=True):
        if made.cutting is not None or made.apart:
            continue
        for each in blocked(part):
            shaped, hobbed = each.needs(ToothCutting.SHAPED), each.needs(ToothCutting.HOBBED, made.cutter)
            least = min(shaped, hobbed)
            if each.room < least:
                text = Message(
                    "the teeth of {gear} on shaft {shaft} end {room:.3g} mm before Ø{beside:.4g}, where a shaper's "
                    "cutter needs {shaped:.3g} mm and a hob of Ø{hob:g} {hobbed:.3g} mm: give {collar}, or {apart}, "
                    "or state train.cutting",
                    gear=each.gear.noun,
                    shaft=part.shaft,
                    room=each.room,
                    beside=each.beside,
                    shaped=shaped,
                    hob=made.cutter or usual_hob(each.gear.normal_module),
                    hobbed=hobbed,
                    collar=_collar(part, made, least),
                    apart=_apart(made),
                )
                lacking.append((least - each.room, text))
    return tuple(text for _, text in sorted(lacking, key=lambda each: each[0])[-1:])


def sheet_notes(part: TrainPart, made: Made) -> Iterator[Message]:
    """Sentences for the sheet of a part: how its teeth are cut, and the room beyond those beside a larger gear.

    Args:
        part: part of a train.
        made: how it is made.
    """
    how = made.cutting
    if how is not None and any(isinstance(gear, GearForm) for gear in part.gears):
        yield Message("Teeth: {how}.", how=CUT[how])
    if made.apart and len(part.gears) > 1:
        yield Message("Lower and upper gear: cut apart, then {joined}.", joined=made.joined)
        return
    for each in () if how == ToothCutting.PRINTED else blocked(part):
        gear = Message("upper gear") if each.number else Message("lower gear")
        room, beside = f"{each.room:.4g}", f"{each.beside:.4g}"
        if how is None:
            yield Message(
                "Room beyond the teeth of the {gear}: {room} mm, before Ø{beside}. A shaper's cutter needs "
                "{shaped:.3g} mm, a hob of Ø{hob:g} {hobbed:.3g} mm.",
                gear=gear,
                room=room,
                beside=beside,
                shaped=each.needs(ToothCutting.SHAPED),
                hob=made.cutter or usual_hob(each.gear.normal_module),
                hobbed=each.needs(ToothCutting.HOBBED, made.cutter),
            )
        elif how != ToothCutting.WIRE:
            yield Message(
                "Room beyond the teeth of the {gear}: {room} mm, before Ø{beside}; the tool needs {needed:.3g} mm.",
                gear=gear,
                room=room,
                beside=beside,
                needed=each.needs(how, made.cutter),
            )


def _collar(part: TrainPart, made: Made, needed: float) -> Message:
    """Keys of a collar that leaves as much room, mm."""
    hub = part.blank.hub
    diameter = hub.diameter if hub else 0.0
    return Message(
        "train.{place}.hub.diameter_mm = {diameter:g} with length_mm = {length:g}",
        place=made.place,
        diameter=diameter,
        length=ceil(needed * _STEPS - 1e-9) / _STEPS,
    )


def _apart(made: Made) -> Message:
    return Message("train.{place}.cut_apart = true with train.{place}.joint", place=made.place)
