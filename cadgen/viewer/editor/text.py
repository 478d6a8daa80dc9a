"""A change of a design file's text: the numbers named change, and everything else stays, comments among it."""

from collections.abc import Iterable, Iterator, Mapping
from math import isfinite
from pathlib import Path
from typing import Any

from cadgen.design.load import design_of
from cadgen.design.override import override
from cadgen.design.parse import parse
from cadgen.design.schema import Design
from cadgen.errors import DesignError, brief
from cadgen.viewer.editor.lists import toml

# A number, or the coordinates of a point.
Value = float | int | tuple[float, float]

MOST_CHANGES = 100  # in one request


def read_changes(raw: object) -> dict[str, Value]:
    """Changes as a request has them, checked for their form.

    Raises:
        DesignError: they are no numbers or pairs of numbers by key.
    """
    if not isinstance(raw, dict) or not 0 < len(raw) <= MOST_CHANGES:
        raise DesignError(f"changes must be 1 to {MOST_CHANGES} numbers or pairs [x, y] by their keys")
    return {key: _value(key, value) for key, value in raw.items()}


def read_point(raw: object) -> tuple[float, float]:
    """The coordinates of a point as a request has them.

    Raises:
        DesignError: they are no pair of numbers.
    """
    if isinstance(raw, list) and len(raw) == 2 and all(map(_number, raw)):
        return (float(raw[0]), float(raw[1]))
    raise DesignError("a point must be a pair [x, y] of numbers")


def _value(key: str, value: object) -> Value:
    if _number(value):
        return value  # type: ignore[return-value]
    try:
        return read_point(value)
    except DesignError:
        raise DesignError(f"{brief(key, 60)} must be a number, or a pair [x, y] of numbers") from None


def _number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e15 and isfinite(value)


def changed(text: str, file: Path, changes: Mapping[str, Value]) -> tuple[str, Design]:
    """Text of a design with some numbers changed, and the design that it is.

    Args:
        text: TOML.
        file: path of the file, for messages.
        changes: new value by dotted key, items of lists counted from 1.

    Raises:
        DesignError: the result is no design, in a sentence; or the text cannot be changed and read back.
    """
    return applied(text, file, [f"{key}={toml(value)}" for key, value in changes.items()])


def applied(text: str, file: Path, overrides: list[str]) -> tuple[str, Design]:
    """Text of a design with overrides written into it, and the design that it is; as `changed`."""
    values = parse(text)
    for change in overrides:
        override(values, change)
    return checked(_rewritten(text, overrides), file, values)


def checked(results: Iterable[str], file: Path, values: dict[str, Any]) -> tuple[str, Design]:
    """A changed text and its design, once the text has been read back.

    Args:
        results: texts to choose from, the best first.
        file: path of the file, for messages.
        values: raw values that the text must have; a list of the course without items is as good as none.

    Raises:
        DesignError: there is no text with these values, or they are no design.
    """
    wanted = _without_empty(values)
    for result in results:
        read = values_of(result)
        if read is not None and _without_empty(read) == wanted:
            return result, design_of(result, file)
    raise DesignError(
        f"{brief(file.name)}: this change cannot be written into the file as it is laid out; make it in a text "
        "editor, and open the design again"
    )


def _without_empty(values: dict[str, Any]) -> dict[str, Any]:
    """Values without empty lists on the course, and without an empty course."""
    course = values.get("course")
    if not isinstance(course, dict):
        return values
    rest = {key: value for key, value in values.items() if key != "course"}
    course = {key: value for key, value in course.items() if value != []}
    return {**rest, "course": course} if course else rest


def _rewritten(text: str, overrides: list[str]) -> Iterator[str]:
    """Text with overrides written into it; none if the library that keeps comments does not manage it."""
    import tomlkit  # only here: opening a design writes none
    from tomlkit.exceptions import TOMLKitError

    try:
        document: Any = tomlkit.parse(text)
        for change in overrides:
            override(document, change)
        yield str(document.as_string())
    except (DesignError, TOMLKitError, LookupError, TypeError, ValueError):
        return  # the same overrides have been applied to plain values: these are the library's own limits


def values_of(text: str) -> dict[str, Any] | None:
    """Raw values of a text; None if it is not TOML."""
    try:
        return parse(text)
    except ValueError:
        return None
