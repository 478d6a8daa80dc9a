"""How the teeth of a train's parts are made: what tools cannot reach, the room that they need, and notes on both."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from cadgen.check import Bound, Check, CheckCode
from cadgen.gears.choices import ToothCutting
from cadgen.gears.layout import TrainPart
from cadgen.gears.stage import is_ring
from cadgen.gears.tools import SMALL_HOB, Tool, beside_larger, proposed_length, usual_hob
from cadgen.gears.tooth import GearForm
from cadgen.messages import Message

CUT = {
    ToothCutting.HOBBED: Message("hobbed"),
    ToothCutting.SHAPED: Message("shaped"),
    ToothCutting.MILLED: Message("milled with a disc cutter"),
    ToothCutting.WIRE: Message("cut by wire, laser or jet"),
    ToothCutting.PRINTED: Message("printed or moulded"),
}

# Coarsest grade that no laser, jet or printer is taken to keep: by judgement, since no standard was at hand.
_FINE = 9


@dataclass(frozen=True, slots=True)
class Made:
    """How the teeth of a part are made.

    Attributes:
        place: place of its shaft in the section [train] of a design; empty for a part beside the shafts.
        key: key of the design that states how its teeth are cut.
        cutting: how its teeth are cut; None where it is not stated.
        apart: whether its gears are cut as two parts and joined.
        cutter: diameter of the hob or the disc cutter, mm; None for the usual one.
        joined: what joins gears that are cut apart, in words.
        instead: what the teeth of the train are cut by, where it does not reach those of this part; None elsewhere.
    """

    place: str
    key: str = "train.cutting"
    cutting: ToothCutting | None = None
    apart: bool = False
    cutter: float | None = None
    joined: str = ""
    instead: ToothCutting | None = None

    @property
    def tool(self) -> Tool | None:
        """Tool of its teeth; None where it is not stated."""
        return None if self.cutting is None else Tool(self.cutting, self.cutter)


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


def blocked(part: TrainPart) -> Iterator[Blocked]:
    """Gears of a part that stand beside a larger one; none of a part with one gear.

    Args:
        part: part of a train.
    """
    if len(part.gears) < 2:
        return
    lower, upper = part.gears
    room = round(part.starts[1] - lower.width, 9)
    for gear, other in beside_larger(lower, upper):
        yield Blocked(int(gear is upper), gear, other.tip_diameter, room)


def cutting_checks(parts: Sequence[TrainPart], makings: Sequence[Made]) -> tuple[Check, ...]:
    """Teeth out of reach of their tools, and the room beyond the teeth that lacks most, where tools are stated.

    Args:
        parts: parts of the train.
        makings: how each is made.
    """
    checks: list[Check] = []
    reached: list[Check] = []

    def beyond(teeth: Message, gear: GearForm, part: TrainPart, advice: Message) -> Check:
        where = Message("{gear} on shaft {shaft}", gear=gear.noun, shaft=part.shaft)
        if part.beside:
            where = Message("{gear} of stage {number}", gear=gear.noun, number=part.stages[0])
        return Check(CheckCode.TEETH_REACHED, teeth, 1.0, "", 0.0, Bound.MAX, where, advice)

    for part, made in zip(parts, makings, strict=True):
        tool = made.tool
        if tool is None:
            continue
        for gear in part.gears:
            if isinstance(gear, GearForm) and (sort := tool.cannot_reach(gear)):
                name = Message("{teeth}, {how}", teeth=sort, how=CUT[tool.cutting])
                reached.append(beyond(name, gear, part, _other_ways(gear, made)))
        for each in blocked(part):
            if tool.cutting == ToothCutting.WIRE:
                reached.append(beyond(Message("teeth that a wire cannot reach"), each.gear, part, _apart(made)))
            elif tool.cutting != ToothCutting.PRINTED:
                needed = tool.run_out(each.gear, each.beside)
                where = Message("{gear} on shaft {shaft}", gear=each.gear.noun, shaft=part.shaft)
                name = Message("room beyond the teeth, {how}", how=CUT[tool.cutting])
                advice = Message("give {collar}, or {apart}", collar=_collar(part, made, needed), apart=_apart(made))
                if Tool(tool.cutting, SMALL_HOB).run_out(each.gear, each.beside) <= each.room < needed:
                    advice = Message("{cures}, or the train.cutter_diameter_mm of a smaller tool", cures=advice)
                checks.append(Check(CheckCode.TOOL_ROOM, name, each.room, "mm", needed, Bound.MIN, where, advice))
    least = min(checks, key=lambda check: check.room, default=None)
    return (*reached[:1], *([] if least is None else [least]))


def _other_ways(gear: GearForm, made: Made) -> Message:
    """Ways in which teeth can be cut that a tool does not reach, as the key that states them.

    Args:
        gear: gear with such teeth.
        made: how it is made.
    """
    shaped = is_ring(gear) or gear.double
    usual = ToothCutting.SHAPED if shaped else ToothCutting.HOBBED
    return Message('give {key} = "{usual}" or "{other}"', key=made.key, usual=usual, other=ToothCutting.PRINTED)


def cutting_notes(parts: Sequence[TrainPart], makings: Sequence[Made], grade: int | None) -> tuple[Message, ...]:
    """Sentences on teeth too fine for a printer, on inside teeth cut otherwise, and on the gear that lacks most room.

    The room is that of any usual tool, of gears of which it is not stated how they are cut.

    Args:
        parts: parts of the train.
        makings: how each is made.
        grade: finest tolerance grade of the train; None where none is stated.
    """
    said: list[Message] = []
    if grade is not None and grade <= _FINE and any(made.cutting == ToothCutting.PRINTED for made in makings):
        said.append(
            Message(
                "play and limits go by grade {grade}, which no printer keeps: state the grade that yours keeps by test "
                "pieces, or a backlash with room for it",
                grade=grade,
            )
        )
    lacking: list[tuple[float, Message]] = []
    for part, made in zip(parts, makings, strict=True):
        if made.instead is not None and made.cutting is not None:
            said.append(
                Message(
                    "the teeth of {gear} are taken as {how}, since inside teeth cannot be {instead}: {key} states "
                    "another way",
                    gear=part.gears[0].noun,
                    how=CUT[made.cutting],
                    instead=CUT[made.instead],
                    key=made.key,
                )
            )
        if made.cutting is not None:
            continue
        for each in blocked(part):
            shaped, hobbed = (tool.run_out(each.gear, each.beside) for tool in _usual_tools(made))
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
    return (*said, *(text for _, text in sorted(lacking, key=lambda each: each[0])[-1:]))


def _usual_tools(made: Made) -> tuple[Tool, Tool]:
    """Shaper's cutter, and the hob of a part of which it is not stated how it is made."""
    return Tool(ToothCutting.SHAPED), Tool(ToothCutting.HOBBED, made.cutter)


def sheet_notes(part: TrainPart, made: Made, grade: int | None = None) -> Iterator[Message]:
    """Sentences for the sheet of a part: how its teeth are cut, and the room beyond those beside a larger gear.

    Args:
        part: part of a train.
        made: how it is made.
        grade: finest tolerance grade of its teeth; None where none is stated.
    """
    how = made.cutting
    if how is not None and any(isinstance(gear, GearForm) for gear in part.gears):
        fine = grade is not None and grade <= _FINE
        if how == ToothCutting.WIRE and fine:
            yield Message("Teeth: cut by wire; a laser or a jet does not keep grade {grade}.", grade=grade)
        elif how == ToothCutting.PRINTED and fine:
            yield Message("Teeth: printed or moulded; a printer does not keep grade {grade}.", grade=grade)
        else:
            yield Message("Teeth: {how}.", how=CUT[how])
    if part.joined_to:
        stands = Message("Stands on the collar of {other}", other=part.joined_to)
        if part.blank.hub:
            stands = Message("On its collar stands {other}", other=part.joined_to)
        yield Message(
            "{stands}, on the same shaft, {joined}. Angle between the teeth of both: free.",
            stands=stands,
            joined=made.joined,
        )
    for each in () if how == ToothCutting.PRINTED else blocked(part):
        gear = Message("upper gear") if each.number else Message("lower gear")
        room, beside = f"{each.room:.4g}", f"{each.beside:.4g}"
        if made.tool is None:
            shaped, hobbed = (tool.run_out(each.gear, each.beside) for tool in _usual_tools(made))
            yield Message(
                "Room beyond the teeth of the {gear}: {room} mm, before Ø{beside}. A shaper's cutter needs "
                "{shaped:.3g} mm, a hob of Ø{hob:g} {hobbed:.3g} mm.",
                gear=gear,
                room=room,
                beside=beside,
                shaped=shaped,
                hob=made.cutter or usual_hob(each.gear.normal_module),
                hobbed=hobbed,
            )
        elif how != ToothCutting.WIRE:
            yield Message(
                "Room beyond the teeth of the {gear}: {room} mm, before Ø{beside}; the tool needs {needed:.3g} mm.",
                gear=gear,
                room=room,
                beside=beside,
                needed=made.tool.run_out(each.gear, each.beside),
            )


def _collar(part: TrainPart, made: Made, needed: float) -> Message:
    """Keys of a collar that leaves as much room, mm."""
    hub = part.blank.hub
    diameter = hub.diameter if hub else 0.0
    return Message(
        "train.{place}.hub.diameter_mm = {diameter:g} with length_mm = {length:g}",
        place=made.place,
        diameter=diameter,
        length=proposed_length(needed),
    )


def _apart(made: Made) -> Message:
    return Message("train.{place}.cut_apart = true with train.{place}.joint", place=made.place)
