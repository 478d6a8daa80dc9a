"""A point put into a list of points in a design file's text, or taken out of it, every comment kept."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from cadgen.design.parse import parse
from cadgen.design.schema import Design
from cadgen.editor.text import checked, values_of

_COMMENT_OR_BRACKET = re.compile(r"#[^\n]*|[\[\]]")
_COMMENT_OR_COMMA = re.compile(r"#[^\n]*|[,\]]")
_BLANK_TO_END = re.compile(r"[ \t]*\r?\n")


def inserted(text: str, file: Path, key: str, at: tuple[float, float]) -> tuple[str, Design]:
    """Text of a design with one point more in a list, and the design that it is.

    Args:
        text: TOML.
        file: path of the file, for messages.
        key: dotted key of the new point, whose number is at most one more than the list has points.
        at: x and y of the point, mm.

    Raises:
        DesignError: the result is no design; or the text cannot be changed and read back.
    """
    name, index = _split(key)
    values = parse(text)
    points = _item(values, name)
    points.insert(index, list(at))
    return checked(_edited(text, name, values, lambda written: _with(written, index, at)), file, values)


def removed(text: str, file: Path, key: str) -> tuple[str, Design]:
    """Text of a design without a point of a list, and the design that it is; as `inserted`."""
    name, index = _split(key)
    values = parse(text)
    del _item(values, name)[index]
    return checked(_edited(text, name, values, lambda written: _without(written, index)), file, values)


def _split(key: str) -> tuple[str, int]:
    """Dotted key of the list, and index of the item in it, from 0."""
    name, _, number = key.rpartition(".")
    return name, int(number) - 1


def _item(values: Any, name: str) -> Any:
    """Value or item at a dotted key, items of lists counted from 1."""
    for part in name.split("."):
        values = values[int(part) - 1 if isinstance(values, list) else part]
    return values


def _edited(text: str, name: str, values: dict[str, Any], edit: Callable[[str], str]) -> str | None:
    """Text with one list written anew, so that it has some values; None if no place in it does.

    The library says how the list is written; the same may stand at several places, of which one is the list's own.
    """
    import tomlkit  # only here: opening a design writes none
    from tomlkit.exceptions import TOMLKitError

    try:
        written = _item(tomlkit.parse(text), name).as_string()
        edited = edit(written)
    except (AttributeError, LookupError, TOMLKitError, TypeError, ValueError):
        return None
    start = text.find(written)
    while start >= 0:
        result = text[:start] + edited + text[start + len(written) :]
        if values_of(result) == values:
            return result
        start = text.find(written, start + 1)
    return None


def _spans(written: str) -> list[tuple[int, int]]:
    """Begin and end of each pair in a list of pairs of numbers, as it is written."""
    spans, begin, depth = [], 0, 0
    for mark in _COMMENT_OR_BRACKET.finditer(written):
        if mark[0] == "[":
            depth += 1
            begin = mark.start()
        elif mark[0] == "]":
            if depth == 2:
                spans.append((begin, mark.end()))
            depth -= 1
    return spans


def _line_start(written: str, at: int) -> int | None:
    """Where the line begins of which a pair is the first; None if something else stands before it."""
    start = written.rfind("\n", 0, at) + 1
    return start if start and not written[start:at].strip() else None


def _with(written: str, index: int, at: tuple[float, float]) -> str:
    """A list of pairs with one more, on a line of its own where its neighbour begins one."""
    spans, pair = _spans(written), f"[{at[0]!r}, {at[1]!r}]"
    last = index == len(spans)
    begin, end = spans[index - 1 if last else index]
    line = _line_start(written, begin)
    between = " " if line is None else ("\r\n" if "\r\n" in written else "\n") + written[line:begin]
    if last:
        return f"{written[:end]},{between}{pair}{written[end:]}"
    return f"{written[:begin]}{pair},{between}{written[begin:]}"


def _without(written: str, index: int) -> str:
    """A list of pairs without one of them and its comma; a line that is empty then goes, too."""
    begin, end = _spans(written)[index]
    # The last pair may have no comma; that before it may then stay, as TOML has it.
    comma = next(mark for mark in _COMMENT_OR_COMMA.finditer(written, end) if mark[0][0] != "#")
    if comma[0] == ",":
        beside = not written[end : comma.start()].strip(" \t")
        written = written[: end if beside else comma.start()] + written[comma.end() :]
    while written[end] in " \t":
        end += 1
    line = _line_start(written, begin)
    if line is not None:
        return _closed_up(written, line, end)
    return written[:begin].rstrip(" \t" if written[end] in "]\r\n" else "") + written[end:]


def _closed_up(written: str, line: int, end: int) -> str:
    """A text without the piece that begins a line; without the line, unless something follows there."""
    rest = _BLANK_TO_END.match(written, end)
    if rest is not None:
        return written[:line] + written[rest.end() :]
    begin = len(written) - len(written[line:].lstrip(" \t"))
    return written[:begin] + written[end:]
