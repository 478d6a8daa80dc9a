"""`--set key=value`: change, add or remove one value of a design before it is checked."""

from itertools import pairwise
from typing import Any

from cadgen.design.explain import depth_in_key, section, spoken, unknown_key
from cadgen.design.keys import Key, keys, shown, tables
from cadgen.design.kinds import NamedKinds, Place
from cadgen.design.parse import TomlValues, parse
from cadgen.errors import DesignError, brief, escaped
from cadgen.messages import Message

_MOST_DIGITS = 6  # of an item's number
_LONGEST_QUOTED = 80


class KeyChange(str):
    """A change `key=value` that a program gives: messages name it without the option of the command line."""

    __slots__ = ()


def override(values: TomlValues, text: str) -> Place:
    """Apply one override to a design's raw values, in place, and return where it went.

    `cam.thickness_mm=3.2` sets a key to a TOML value; a bare word is text. `cam.mid_plane_mm=` removes a key
    or a whole section. Items of lists are counted from 1: `path.waypoints_mm.3=[1, 2]`.

    Raises:
        DesignError: not of the form key=value, an unknown key (with the nearest known one), an item that the
            list does not have, or a value that is not TOML.
    """
    name, equals, written = (part.strip() for part in text.partition("="))
    if not equals or not all(name.split(".")):
        if isinstance(text, KeyChange):
            raise DesignError(
                "{quoted}: write the key as in the design file, such as cam.thickness_mm", quoted=quoted(text)
            )
        raise DesignError("{quoted}: write it as key=value, such as --set cam.thickness_mm=3.2", quoted=quoted(text))
    try:
        place = _place(name, NamedKinds.of(values))
        _apply(values, place, written)
    except DesignError as error:
        raise DesignError("{quoted}: {error}", quoted=quoted(text), error=error.message) from None
    return place


def key_at(values: object, name: str) -> Key | None:
    """The key that a dotted name means, with its kind and range; None for a whole section.

    Args:
        values: raw values of the design, whose kinds of path, follower and stages decide what keys there are.
        name: dotted name, where items of lists are counted from 1.

    Raises:
        DesignError: an unknown key, with the nearest known one.
    """
    named = NamedKinds.of(values)
    place = _place(name, named)
    return keys(named.at(place)).get(section(place))


def quoted(text: str) -> str:
    """An override as it stands at the head of an error: on one line, cut short if it is long."""
    option = "" if isinstance(text, KeyChange) else "--set "
    line = escaped(" ".join(f"{option}{text[:_LONGEST_QUOTED]}".split()))
    return line if len(line) <= _LONGEST_QUOTED else line[: _LONGEST_QUOTED - 3] + "..."


def _place(name: str, named: NamedKinds) -> Place:
    """Find a dotted name in the schema; after a key of lists its numbers count items."""
    place: Place = ()
    for part in name.split("."):
        key, table = keys(named.at(place)).get(section(place)), tables(named.at(place)).get(section(place))
        if table and table.many and isinstance(place[-1], str):
            if not (part.isdecimal() and len(part) <= _MOST_DIGITS):
                raise DesignError(
                    "{spoken} is a list: write the number of one of its items before {part}",
                    spoken=spoken(place),
                    part=brief(part),
                )
            place = (*place, int(part) - 1)
        elif key is None:
            place = (*place, part)
            if section(place) not in keys(named.at(place)) and section(place) not in tables(named.at(place)):
                raise DesignError(unknown_key(place, named.at(place)))
        elif part.isdecimal() and len(part) <= _MOST_DIGITS and depth_in_key(place) < len(key.kinds) - 1:
            place = (*place, int(part) - 1)
        else:
            items = Message(", or the number of one of its items") if len(key.kinds) > 1 else ""
            raise DesignError(
                "{name} is not a key: {spoken} has no {part}; set {name2} itself{items}",
                name=brief(name),
                spoken=spoken(place),
                part=brief(part),
                name2=key.name,
                items=items,
            )
    return place


def _apply(values: TomlValues, place: Place, written: str) -> None:
    holder: Any = values
    for step, below in pairwise(place):
        if isinstance(step, str) and isinstance(holder, dict) and step not in holder:
            if not written:
                return
            holder[step] = [] if isinstance(below, int) else {}
        _refuse_absent(holder, step)
        holder = holder[step]
    last = place[-1]
    if isinstance(last, int) or not isinstance(holder, dict):
        _refuse_absent(holder, last)
    if written:
        holder[last] = _value(written)
    elif isinstance(last, int) or last in holder:
        del holder[last]


def _refuse_absent(holder: object, step: str | int) -> None:
    if isinstance(step, str):
        if not isinstance(holder, dict):
            raise DesignError(
                "the design has {shown} where the section of {step} should be: correct it first",
                shown=shown(holder),
                step=step,
            )
    elif not isinstance(holder, list) or not 0 <= step < len(holder):
        count = len(holder) if isinstance(holder, list) else 0
        raise DesignError("there is no item {step}: the list has {count}, counted from 1", step=step + 1, count=count)


def _value(written: str) -> object:
    """Read a TOML value; what is none but could be a bare word is text."""
    try:
        read = parse(f"value = {written}")
    except ValueError:
        read = {}
    if set(read) == {"value"}:
        return read["value"]
    if written[:1] in {"[", "{", '"', "'"} or "\n" in written:
        raise DesignError("the value is not TOML: check its brackets, quotes and commas")
    return written
