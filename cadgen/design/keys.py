"""The schema as a list of keys: for messages that name what is allowed, and for the reference page."""

import json
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from enum import StrEnum
from functools import cache
from typing import Annotated, Any, Literal, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt, MinLen
from pydantic.fields import FieldInfo

from cadgen.design.follower import FollowerSection, section_of
from cadgen.design.kinds import USUAL, Kinds
from cadgen.design.path import PathSection, path_section
from cadgen.design.schema import OF_A_CAR, DesignFile, MotionFile
from cadgen.design.section import DesignSection, OneOf, ZeroOrFeature, listed
from cadgen.design.train import StageSection, stage_section
from cadgen.errors import escaped
from cadgen.messages import Message, joined

# How the ends of key names read in a sentence.
_UNITS = {
    "_mm_per_min": "mm/min",
    "_N_per_mm": "N/mm",
    "_N_s_per_m": "N·s/m",
    "_Nmm_per_rad": "N·mm/rad",
    "_Nmm_s_per_rad": "N·mm·s/rad",
    "_kgmm2": "kg·mm²",
    "_kg": "kg",
    "_MPa": "MPa",
    "_mm": "mm",
    "_um": "µm",
    "_deg": "degrees",
    "_rpm": "rev/min",
    "_percent": "%",
    "_Nmm": "N·mm",
    "_N": "N",
    "_J": "J",
    "_K": "K",
}
# What users may write at the end of a key instead.
_UNIT_ENDING = re.compile(
    r"_(?:mm|cm|dm|m|km|um|nm|in|inch|inches|thou|mil|deg|degree|degrees|rad|radians|rpm|hz|percent)"
    r"(?:_per_(?:min|minute|s|sec|second|rev))?$",
    re.IGNORECASE,
)
_KINDS = {
    bool: Message("true or false"),
    float: Message("a number"),
    int: Message("a whole number"),
    str: Message("text"),
}
_PAIR = Message("a pair [x, y]")
_LONGEST_SHOWN = 60
_LISTS: dict[str, Message] = {
    _KINDS[float]: Message("a list of numbers"),
    _KINDS[int]: Message("a list of whole numbers"),
    _KINDS[str]: Message("a list of texts"),
    _PAIR: Message("a list of pairs [x, y]"),
}
_LISTS[_LISTS[_KINDS[float]]] = Message("a list of lists of numbers")


@dataclass(frozen=True)
class Key:
    """Key of a design file.

    Attributes:
        name: dotted name, from the top.
        unit: unit of its numbers; empty if it has none.
        kinds: kind of its value, of an item of that, and so on: `a pair [x, y]`, `a number`.
        info: the key in the schema.
    """

    name: str
    unit: str
    kinds: tuple[str, ...]
    info: FieldInfo

    @property
    def required(self) -> bool:
        """Whether a section must have the key."""
        return self.info.is_required()

    @property
    def default(self) -> object:
        """Default value; None if it has none."""
        return None if self.required else self.info.default

    @property
    def meaning(self) -> str:
        """A phrase."""
        return self.info.description or ""

    @property
    def demand(self) -> Message:
        """Demand on its value, as one phrase: what it must be, its unit and its default."""
        parts = [Message("must be {allowed}", allowed=self.allowed or self.allowed_inside or self.kinds[0])]
        if self.unit:
            parts.append(Message("unit {unit}", unit=Message(self.unit)))
        if self.default is not None:
            parts.append(Message("default {value}", value=shown(self.default)))
        return joined(parts, "; ")

    # Sentences are made when they are asked for: some choices are registered in rooms that take long to load.
    @property
    def allowed(self) -> str:
        """Range or choices, as they read after "must be"; empty if anything of its kind will do."""
        return _choices(self.info.annotation) or _phrases(self.info.metadata)

    @property
    def allowed_inside(self) -> str:
        """Range or choices of the numbers in a list or pair."""
        return _choices_inside(self.info.annotation) or _phrases(self._inside)

    @property
    def least(self) -> float | None:
        """Least value of a number; None without a limit."""
        return _bound([*self.info.metadata, *self._inside], ("ge", "gt"))

    @property
    def most(self) -> float | None:
        """Greatest value of a number; None without a limit."""
        return _bound([*self.info.metadata, *self._inside], ("le", "lt"))

    @property
    def _inside(self) -> list[Any]:
        return _kinds(self.info.annotation)[1]


@dataclass(frozen=True)
class SectionKeys:
    """A section with its keys and the names of the sections in it; `name` is dotted and empty at the top.

    Where `many` holds it is a list of such sections.
    """

    name: str
    meaning: str
    required: bool
    many: bool
    keys: tuple[Key, ...]
    subtables: tuple[str, ...]

    @property
    def names(self) -> list[str]:
        """Everything that may stand in this section."""
        return [last(key.name) for key in self.keys] + list(self.subtables)

    @property
    def heading(self) -> str:
        """As it stands in a file."""
        return f"[[{self.name}]]" if self.many else f"[{self.name}]"


@cache
def tables(kinds: Kinds = USUAL) -> dict[str, SectionKeys]:
    """Every section of a design with some kinds of path, follower and stage by its dotted name, from the top down."""
    file = MotionFile if kinds.motion else DesignFile
    return {table.name: table for table in _walk("", file, kinds, required=True, many=False)}


@cache
def keys(kinds: Kinds = USUAL) -> dict[str, Key]:
    """Every key of a design with some kinds of path, follower and stage by its dotted name."""
    return {key.name: key for table in tables(kinds).values() for key in table.keys}


def nearest(parent: str, wrong: str, kinds: Kinds = USUAL) -> str | None:
    """Dotted name of the key or section, in the same section, that an unknown one was most likely meant for."""
    names = tables(kinds)[parent].names
    stem = _stem(wrong)
    near = [name for name in names if _stem(name) == stem] or get_close_matches(wrong.lower(), names, 1)
    return dotted(parent, near[0]) if near else None


def elsewhere(parent: str, wrong: str, kinds: Kinds = USUAL) -> list[str]:
    """Dotted names of keys and sections of exactly this name in other sections, where they can be meant.

    With its section left out, a key may be that of any section of the first rank. In a wrong section it is meant for
    another only if no third has it: the width of a car is not that of a keyway.
    """
    holders = [table.name for table in tables(kinds).values() if table.name and wrong in table.names]
    first = [dotted(holder, wrong) for holder in holders if "." not in holder]
    if not parent:
        return first
    sole = len(first) == 1 and (len(holders) == 1 or first[0] in tables(kinds))
    return first if sole else []


def is_unit_slip(wrong: str, right: str) -> bool:
    """True if a name lacks the unit at the end of the right one, or has another."""
    return _stem(wrong) == _stem(last(right)) and unit_of(right) != ""


def dotted(*parts: str | int) -> str:
    """Join the parts of a key; the empty name of the top level falls away."""
    return ".".join(str(part) for part in parts if part != "")


def last(name: str) -> str:
    """The last part of a dotted name."""
    return name.rpartition(".")[2]


def shown(value: object) -> str:
    """A value as TOML writes it, cut short if it is long."""
    text = repr(value) if isinstance(value, float) else json.dumps(value, ensure_ascii=False, default=str)
    text = escaped(text[:_LONGEST_SHOWN]) + text[_LONGEST_SHOWN:]
    return text if len(text) <= _LONGEST_SHOWN else text[: _LONGEST_SHOWN - 3] + "..."


def without_unit(name: str) -> str:
    """The last part of a key without the unit at its end."""
    return next((name.removesuffix(ending) for ending in _UNITS if name.endswith(ending)), name)


def unit_of(name: str) -> str:
    """Unit at the end of a key's name; empty where it has none."""
    return next((unit for ending, unit in _UNITS.items() if name.endswith(ending)), "")


def _stem(name: str) -> str:
    return _UNIT_ENDING.sub("", name).lower()


def _walk(
    name: str, section: type[DesignSection], kinds: Kinds, *, required: bool, many: bool
) -> Iterator[SectionKeys]:
    own, below = [], []
    for part, info in section.model_fields.items():
        if not name and kinds.motion and part in OF_A_CAR:
            continue
        annotation = info.annotation
        if type(None) in (arms := get_args(annotation)) and get_origin(arms[0]) is Annotated:
            annotation = get_args(arms[0])[0]  # of a list of sections that may be left out
        arms = (annotation, *get_args(annotation))
        arms += tuple(below for arm in arms if get_origin(arm) is Annotated for below in get_args(arm))
        inner = next((arm for arm in arms if isinstance(arm, type) and issubclass(arm, DesignSection)), None)
        if inner is FollowerSection:
            inner = section_of(kinds.follower)
        elif inner is PathSection:
            inner = path_section(kinds.path)
        elif inner is StageSection:
            inner = stage_section(kinds.stage)
        if inner:
            below.append((part, inner, info.is_required(), get_origin(annotation) is tuple))
        else:
            key = dotted(name, part)
            own.append(Key(key, unit_of(key), _kinds(info.annotation)[0], info))
    meaning = " ".join((section.__doc__ or "").split())
    yield SectionKeys(name, meaning, required, many, tuple(own), tuple(part for part, *_ in below))
    for part, inner, needed, repeated in below:
        yield from _walk(dotted(name, part), inner, kinds, required=needed, many=repeated)


def _bound(limits: Sequence[Any], names: tuple[str, str]) -> float | None:
    """Limit of a number on one side; None without one."""
    bounds = [getattr(limit, name) for limit in limits for name in names if hasattr(limit, name)]
    if not bounds and "ge" in names and any(isinstance(limit, ZeroOrFeature) for limit in limits):
        return 0.0
    return float(bounds[0]) if bounds else None


def _kinds(annotation: Any) -> tuple[tuple[str, ...], list[Any]]:
    """Names of a type and of its items for a sentence, and the limits inside the type."""
    arguments = get_args(annotation)
    if get_origin(annotation) is Annotated:
        kinds, limits = _kinds(arguments[0])
        return kinds, [*limits, *arguments[1:]]
    arms = [arm for arm in arguments if arm is not type(None)]
    if type(None) in arguments and len(arms) == 1:  # a key that may be left out
        return _kinds(arms[0])
    if get_origin(annotation) is tuple:
        kinds, limits = _kinds(arguments[0])
        return (_LISTS[kinds[0]] if arguments[1] is ... else _PAIR, *kinds), limits
    return (next((_KINDS[arm] for arm in (annotation, *arguments) if arm in _KINDS), _KINDS[str]),), []


def _choices(annotation: Any) -> str:
    """The words of an enumeration, as they read after "must be"; empty if the annotation holds none.

    Args:
        annotation: an enumeration, alone, with limits, or one that may be left out.
    """
    if isinstance(annotation, type) and issubclass(annotation, StrEnum):
        return listed([shown(member.value) for member in annotation], "or")
    if get_origin(annotation) is tuple:
        return ""
    if get_origin(annotation) is Literal:  # of a kind that is registered from outside
        return listed([shown(word) for word in get_args(annotation)], "or")
    return next((choices for arm in get_args(annotation) if (choices := _choices(arm))), "")


def _choices_inside(annotation: Any) -> str:
    """Words of an enumeration that the items of a list must be."""
    if get_origin(annotation) is tuple:
        return _choices(get_args(annotation)[0])
    return next((choices for arm in get_args(annotation) if (choices := _choices_inside(arm))), "")


def _phrases(limits: Iterable[Any]) -> str:
    from_below = sorted(limits, key=lambda limit: isinstance(limit, Lt | Le))
    return listed([phrase for limit in from_below if (phrase := _phrase(limit))], "and")


def _phrase(limit: Any) -> str:
    match limit:
        case OneOf() | ZeroOrFeature():
            return limit.allowed
        case MinLen(least):
            return Message("{least} or more", least=least)
        case Gt(bound):
            return Message("greater than {bound:.12g}", bound=bound)
        case Ge(bound):
            return Message("at least {bound:.12g}", bound=bound)
        case Lt(bound):
            return Message("less than {bound:.12g}", bound=bound)
        case Le(bound):
            return Message("at most {bound:.12g}", bound=bound)
        case _:
            return ""
