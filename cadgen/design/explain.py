"""Faults of a design's values, as sentences: the key, its value, and what is allowed."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from cadgen.design.keys import dotted, elsewhere, is_unit_slip, keys, last, nearest, shown, tables
from cadgen.design.kinds import USUAL, Kinds, NamedKinds, Place
from cadgen.design.section import HERE, listed
from cadgen.errors import brief

_WRONG_TYPE = {"float_type", "int_type", "int_from_float", "string_type", "tuple_type", "missing", "too_long"}
_MOST_COMPARED = 100  # unknown keys with the known ones: nobody mistypes more


def explain(error: ValidationError, most: int, named: NamedKinds) -> tuple[list[tuple[Place, str]], int]:
    """Return the places of the first errors, with one sentence about each, and how many more there are.

    Unknown keys come first. What only follows from another error is left out: a required key that stands there under
    a wrong name, and a list that counts as too short because its items are wrong. Several missing sections make one
    sentence.
    """
    errors = error.errors(include_url=False)
    unknown = [item["loc"] for item in errors if item["type"] == "extra_forbidden"]
    holders = {item["loc"][:-1] for item in errors}
    inside = {place[:depth] for place in holders for depth in range(len(place) + 1)}
    meant = {nearest(section(place[:-1]), str(place[-1]), named.at(place)) for place in unknown[:_MOST_COMPARED]}
    missing = [item["loc"] for item in errors if item["type"] == "missing" and len(item["loc"]) == 1]
    absent = [place for place in missing if section(place) in tables(named.at(place)) and section(place) not in meant]
    if len(absent) < 2:
        absent = []
    rest = [
        item
        for item in errors
        if item["type"] != "extra_forbidden"
        and item["loc"] not in absent
        and not (item["type"] == "missing" and dotted(*item["loc"]) in meant)
        and not (item["type"] == "too_short" and item["loc"] in inside)
    ]
    sentences = [(place, unknown_key(place, named.at(place))) for place in unknown[:most]]
    if absent:
        headings = listed([tables(named.at(place))[section(place)].heading for place in absent], "and")
        text = f"the sections {headings} are missing: add them (`cadgen gears` needs [train] alone)"
        sentences.append((absent[0], text))
    sentences += [
        (item["loc"], _sentence(item["type"], item["loc"], item["input"], item.get("ctx", {}), named.at(item["loc"])))
        for item in rest[: max(most - len(sentences), 0)]
    ]
    return sentences[:most], len(unknown) + bool(absent) + len(rest) - len(sentences[:most])


def section(place: Place) -> str:
    """Dotted name of a place in the schema, where items of lists have no number."""
    return dotted(*(part for part in place if isinstance(part, str)))


def unknown_key(place: Place, kinds: Kinds = USUAL) -> str:
    """Say that there is no such key, which one was most likely meant, and what its section takes."""
    parent, wrong = section(place[:-1]), str(place[-1])
    right = nearest(parent, wrong, kinds)
    name = dotted(spoken(place[:-1]), brief(wrong) or '""')
    if right and is_unit_slip(wrong, right):
        return f"{name} is not a key: write {right}, in {keys(kinds)[right].unit}"
    meant = [right] if right else elsewhere(parent, wrong, kinds)
    hint = f"did you mean {listed(meant, 'or')}? " if meant else ""
    where = f"[{parent}]" if parent else "a design"
    return f"{name} is not a key: {hint}{where} takes {listed(tables(kinds)[parent].names, 'and')}"


def spoken(place: Place) -> str:
    """A place as users count: `path.waypoints_mm.3` is the third waypoint."""
    return dotted(*(part + 1 if isinstance(part, int) else part for part in place))


def depth_in_key(place: Place) -> int:
    """How many lists deep a place lies within its key: `path.waypoints_mm.3.1` lies two deep."""
    depth = 0
    while depth < len(place) and isinstance(place[-1 - depth], int):
        depth += 1
    return depth


def _of_item(place: Place) -> str:
    numbers = [i for i, part in enumerate(place) if isinstance(part, int)]
    return f" in {spoken(place[: numbers[-1] + 1])}" if numbers else ""


def _sentence(kind: str, place: Place, value: Any, context: Mapping[str, Any], kinds: Kinds) -> str:
    if kind == "value_error":
        return str(context["error"]).replace(HERE, spoken(place))
    if kind == "missing" and isinstance(place[-1], int):  # of a pair, whose value pydantic gives
        place = place[:-1]
    name, path = spoken(place), section(place)
    if kind == "too_long" and context["max_length"] > 2:  # a list, and not a pair
        return f"{name} has {len(value)} items; it can have at most {context['max_length']}: remove some"
    if path in tables(kinds):
        table = tables(kinds)[path]
        heading = table.heading
        needs = listed([last(key.name) for key in table.keys if key.required], "and")
        if kind == "missing":
            return f"the section {heading} is missing{_of_item(place)}: add it, with at least {needs}"
        if table.many and not isinstance(place[-1], int):
            return f"{name} is {shown(value)}; it must be sections: write {heading} before the keys of each"
        return f"{name} is {shown(value)}; it must be a section: write {heading} and its keys below it"
    key = keys(kinds)[path]
    depth = depth_in_key(place)
    wanted = f"{key.kinds[depth]} in {key.unit}" if key.unit else key.kinds[depth]
    if kind == "missing" and depth == 0:
        return f"{name} is missing: add it, {wanted} ({key.meaning})"
    if kind == "string_type" and key.allowed:
        return f"{name} is {shown(value)}; it must be {key.allowed}"
    if kind in _WRONG_TYPE:
        bare = ", without quotes or unit" if isinstance(value, str) and "number" in wanted else ""
        return f"{name} is {shown(value)}; it must be {wanted}{bare}"
    if kind == "finite_number":
        return f"{name} is {shown(value)}; it must be a finite number"
    if kind == "too_short":
        return f"{name} has {len(value)} items; it needs at least {context['min_length']}: add more"
    unit = f" ({key.unit})" if key.unit else ""
    return f"{name} is {shown(value)}; it must be {key.allowed_inside if depth else key.allowed}{unit}"
