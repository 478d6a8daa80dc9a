"""Faults of a study's file, as sentences: the key, its value, and what is allowed."""

from collections.abc import Sequence
from typing import Any

from pydantic import BaseModel, ValidationError

from cadgen.design.section import HERE, listed
from cadgen.errors import brief

_KINDS = {
    "string_type": "a text",
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "tuple_type": "a list",
    "model_type": "a section",
    "model_attributes_type": "a section",
    "finite_number": "a finite number",
}
_BOUNDS = {
    "greater_than": ("more than", "gt"),
    "greater_than_equal": ("at least", "ge"),
    "less_than": ("less than", "lt"),
    "less_than_equal": ("at most", "le"),
}


def sentence(error: ValidationError, schema: type[BaseModel]) -> str:
    """The first fault, and how many more there are."""
    every = error.errors(include_url=False)
    # A list with a faulty item also counts as one that is too short.
    errors = [each for each in every if each["type"] != "too_short" or not any(_holds(each, other) for other in every)]
    first = min(errors, key=lambda item: item["type"] != "extra_forbidden")
    rest = len(errors) - 1
    more = f" (and {rest} more fault{'s' if rest > 1 else ''})" if rest else ""
    return f"{_one(first, schema)}{more}"


def _holds(outer: Any, inner: Any) -> bool:
    """Whether the place of a fault holds that of another."""
    depth = len(outer["loc"])
    return len(inner["loc"]) > depth and inner["loc"][:depth] == outer["loc"]


def _one(item: Any, schema: type[BaseModel]) -> str:
    kind, place, value, context = item["type"], item["loc"], item["input"], item.get("ctx", {})
    name = ".".join(str(part + 1 if isinstance(part, int) else part) for part in place)
    if kind == "extra_forbidden":
        names, heading = _names(schema, place[:-1])
        return f"{brief(name)} is not a key of a study: {heading} takes {listed(names, 'and')}"
    if kind == "missing":
        return f"{name} is missing: add it"
    if kind == "value_error":
        return str(context["error"]).replace(HERE, name)
    if kind in _BOUNDS:
        words, bound = _BOUNDS[kind]
        return f"{name} is {_shown(value)}; it must be {words} {context[bound]:g}"
    if kind == "tuple_type" and isinstance(value, dict):
        return f"{name} is one section; it must be a list of them: write [[{name}]]"
    if kind in ("too_short", "string_too_short"):
        return f"{name} is empty: add at least one"
    if kind == "string_pattern_mismatch":
        return f"{name} is {_shown(value)}; it must be letters, digits, _, - and points, the first a letter or digit"
    return f"{name} is {_shown(value)}; it must be {_KINDS.get(kind, 'something else')}"


def _names(schema: Any, place: Sequence[str | int]) -> tuple[list[str], str]:
    """Keys that a section takes, and its heading."""
    heading, many = "", False
    for part in place:
        if isinstance(part, int):
            many = True
            continue
        heading = part
        annotation = schema.model_fields[part].annotation
        schema = next(kind for kind in _inside(annotation) if isinstance(kind, type) and issubclass(kind, BaseModel))
    names = [field.alias or name for name, field in schema.model_fields.items()]
    return names, f"[[{heading}]]" if many else f"[{heading}]" if heading else "its top"


def _inside(annotation: Any) -> list[Any]:
    parts = getattr(annotation, "__args__", ())
    return [annotation, *(inner for part in parts for inner in _inside(part))]


def _shown(value: object) -> str:
    return brief(repr(value), 60)
