"""A list in brackets in a design file's text, with an item put in, taken out or exchanged; every comment kept."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

_MARK = re.compile(r"""#[^\n]*|"(?:\\.|[^"\\\n])*"|'[^'\n]*'|[\[\]{}]""")
_COMMENT_OR_COMMA = re.compile(r"#[^\n]*|[,\]]")
_BLANK_TO_END = re.compile(r"[ \t]*\r?\n")


def with_item(text: str, name: str, index: int, item: object) -> Iterator[str]:
    """Texts of a design with one item more in a list that is written in brackets; none if it is not.

    Args:
        text: TOML.
        name: dotted key of the list, items of lists counted from 1.
        index: index of the new item, at most the count of those that are there.
        item: pair of numbers, or values by key.
    """
    return _edited(text, name, lambda written: _with(written, index, toml(item)))


def without_item(text: str, name: str, index: int) -> Iterator[str]:
    """Text without one of the items."""
    return _edited(text, name, lambda written: _without(written, index))


def with_exchange(text: str, name: str, index: int) -> Iterator[str]:
    """Text with an item and the next one exchanged; comments on their lines go with them where each has its own."""
    yield from _edited(text, name, lambda written: _exchanged(written, index, whole_lines=True))
    yield from _edited(text, name, lambda written: _exchanged(written, index, whole_lines=False))


def item_at(values: Any, name: str) -> Any:
    """Value or item at a dotted key, items of lists counted from 1."""
    for part in name.split("."):
        values = values[int(part) - 1 if isinstance(values, list) else part]
    return values


def toml(value: object) -> str:
    """A value as TOML on one line."""
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {toml(inner)}" for key, inner in value.items()) + " }"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return "[" + ", ".join(map(toml, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


def _edited(text: str, name: str, edit: Callable[[str], str]) -> Iterator[str]:
    """Texts with one list written anew.

    The library says how the list is written; the same may stand at several places, of which one is the list's own.
    """
    import tomlkit  # only here: opening a design writes none
    from tomlkit.exceptions import TOMLKitError

    try:
        written = item_at(tomlkit.parse(text), name).as_string()
        edited = edit(written)
    except (AttributeError, LookupError, StopIteration, TOMLKitError, TypeError, ValueError):
        return
    start = text.find(written)
    while start >= 0:
        yield text[:start] + edited + text[start + len(written) :]
        start = text.find(written, start + 1)


def _spans(written: str) -> list[tuple[int, int]]:
    """Begin and end of each item in a list of pairs of numbers or of tables in braces, as it is written."""
    spans, begin, depth = [], 0, 0
    for mark in _MARK.finditer(written):
        if mark[0] in "[{":
            depth += 1
            begin = mark.start() if depth == 2 else begin
        elif mark[0] in "]}":
            if depth == 2:
                spans.append((begin, mark.end()))
            depth -= 1
    return spans


def _line_start(written: str, at: int) -> int | None:
    """Where the line begins of which an item is the first; None if something else stands before it."""
    start = written.rfind("\n", 0, at) + 1
    return start if start and not written[start:at].strip() else None


def _with(written: str, index: int, item: str) -> str:
    """A list with one item more, on a line of its own where its neighbour begins one."""
    spans = _spans(written)
    if not spans:
        return f"{written[:-1]}{item}{written[-1]}"
    last = index == len(spans)
    begin, end = spans[index - 1 if last else index]
    line = _line_start(written, begin)
    between = " " if line is None else ("\r\n" if "\r\n" in written else "\n") + written[line:begin]
    if last:
        return f"{written[:end]},{between}{item}{written[end:]}"
    return f"{written[:begin]}{item},{between}{written[begin:]}"


def _without(written: str, index: int) -> str:
    """A list without one of its items and its comma; a line that is empty then goes, too."""
    begin, end = _spans(written)[index]
    # The last item may have no comma; that before it may then stay, as TOML has it.
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


def _exchanged(written: str, index: int, *, whole_lines: bool) -> str:
    """A list with an item and the next one exchanged, or else the lines that they stand on."""
    spans = _spans(written)
    (first, end), (second, last) = spans[index], spans[index + 1]
    if whole_lines:
        lines = [_line_start(written, begin) for begin, _ in spans[index : index + 3]]
        last = written.index("\n", last) + 1
        if None in lines or (len(lines) == 3 and lines[2] != last):
            raise ValueError("they are not alone on their lines")
        first, end, second = lines[0], lines[1], lines[1]  # type: ignore[assignment]
    return written[:first] + written[second:last] + written[end:second] + written[first:end] + written[last:]
