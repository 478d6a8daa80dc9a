"""Faults of a design's values, as sentences: the key, its value, and what is allowed."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from cadgen.design.follower import fitting_kinds, kinds_with
from cadgen.design.keys import dotted, elsewhere, is_unit_slip, keys, last, nearest, shown, tables
from cadgen.design.kinds import USUAL, Kinds, NamedKinds, Place
from cadgen.design.section import listed
from cadgen.errors import brief
from cadgen.messages import Message

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
        text = Message(
            "the sections {headings} are missing: add them (of [train] alone `cadgen gears`, `draw` and `report` "
            "make files, sheets and a page)",
            headings=headings,
        )
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
        return Message(
            "{name} is not a key: write {right}, in {unit}",
            name=name,
            right=right,
            unit=Message(keys(kinds)[right].unit),
        )
    owners = [] if right or parent != "follower" else kinds_with(wrong)
    if owners:
        return Message(
            '{name} is a key of {owners}, and follower.kind is "{kind}", under which [follower] '
            "takes {listed}: remove it",
            name=name,
            owners=listed([f'"{code}"' for code in owners], "and"),
            kind=kinds.follower.code,
            listed=listed(tables(kinds)[parent].names, "and"),
        )
    meant = [right] if right else elsewhere(parent, wrong, kinds)
    hint = Message("did you mean {listed}? ", listed=listed(meant, "or")) if meant else ""
    where = f"[{parent}]" if parent else Message("a design")
    return Message(
        "{name} is not a key: {hint}{where} takes {listed}",
        name=name,
        hint=hint,
        where=where,
        listed=listed(tables(kinds)[parent].names, "and"),
    )


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
    return Message(" in {item}", item=spoken(place[: numbers[-1] + 1])) if numbers else ""


def _sentence(kind: str, place: Place, value: Any, context: Mapping[str, Any], kinds: Kinds) -> str:
    if kind == "value_error":
        said = Message(*context["error"].args)
        known: dict[str, object] = {**said.arguments, "here": spoken(place)}
        if section(place) == "follower.kind":  # which kinds fit depends on what else the design has
            known["allowed"] = fitting_kinds(moved=kinds.motion)
        return Message(said.template, **known) if said.arguments else said
    if kind == "missing" and isinstance(place[-1], int):  # of a pair, whose value pydantic gives
        place = place[:-1]
    name, path = spoken(place), section(place)
    if kind == "too_long" and context["max_length"] > 2:  # a list, and not a pair
        return Message(
            "{name} has {count} items; it can have at most {most}: remove some",
            name=name,
            count=len(value),
            most=context["max_length"],
        )
    if path in tables(kinds):
        table = tables(kinds)[path]
        heading = table.heading
        needs = listed([last(key.name) for key in table.keys if key.required], "and")
        if kind == "missing" and not needs:
            return Message(
                "the section {heading} is missing{of_item}: add it, with some of {names}",
                heading=heading,
                of_item=_of_item(place),
                names=listed(table.names, "and"),
            )
        if kind == "missing":
            return Message(
                "the section {heading} is missing{of_item}: add it, with at least {needs}",
                heading=heading,
                of_item=_of_item(place),
                needs=needs,
            )
        if kind == "too_short":
            return Message(
                "{name} is empty: write {heading} before the keys of each in its place, with some of {names}",
                name=name,
                heading=heading,
                names=listed(table.names, "and"),
            )
        if table.many and not isinstance(place[-1], int):
            return Message(
                "{name} is {shown}; it must be sections: write {heading} before the keys of each",
                name=name,
                shown=shown(value),
                heading=heading,
            )
        return Message(
            "{name} is {shown}; it must be a section: write {heading} and its keys below it",
            name=name,
            shown=shown(value),
            heading=heading,
        )
    key = keys(kinds)[path]
    depth = depth_in_key(place)
    wanted = (
        Message("{kind} in {unit}", kind=key.kinds[depth], unit=Message(key.unit)) if key.unit else key.kinds[depth]
    )
    if kind == "missing" and depth == 0:
        wanted = key.allowed if '"' in key.allowed else wanted
        return Message(
            "{name} is missing: add it, {wanted} ({meaning})", name=name, wanted=wanted, meaning=Message(key.meaning)
        )
    if kind == "string_type" and key.allowed:
        return Message("{name} is {shown}; it must be {allowed}", name=name, shown=shown(value), allowed=key.allowed)
    if kind in _WRONG_TYPE:
        bare = Message(", without quotes or unit") if isinstance(value, str) and "number" in wanted else ""
        return Message(
            "{name} is {shown}; it must be {wanted}{bare}", name=name, shown=shown(value), wanted=wanted, bare=bare
        )
    if kind == "finite_number":
        return Message("{name} is {shown}; it must be a finite number", name=name, shown=shown(value))
    if kind == "too_short":
        return Message(
            "{name} has {count} items; it needs at least {least}: add more",
            name=name,
            count=len(value),
            least=context["min_length"],
        )
    unit = Message(" ({unit})", unit=Message(key.unit)) if key.unit else ""
    return Message(
        "{name} is {shown}; it must be {allowed}{unit}",
        name=name,
        shown=shown(value),
        allowed=(key.allowed_inside if depth else key.allowed) or key.kinds[depth],
        unit=unit,
    )
