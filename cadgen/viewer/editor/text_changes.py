"""Change of a design file's text: numbers changed, items put in, taken out or exchanged, all comments kept.

An item is a point of a list in brackets, or a table under a heading such as `[[course.posts]]`.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from math import isfinite
from pathlib import Path
from typing import Any

from cadgen.design.load import complete_of
from cadgen.design.override import override
from cadgen.design.parse import TomlValues, parse
from cadgen.design.schema import Design, MotionDesign
from cadgen.errors import DesignError, brief
from cadgen.messages import Message

# A number, the coordinates of a point, or one of the words that a key takes.
Value = float | int | tuple[float, float] | str

MOST_CHANGES = 100  # in one request
_WORD = re.compile(r"[a-z0-9_-]{1,64}")  # such as the code of a law: it needs no marks in TOML


def read_changes(raw: object) -> dict[str, Value]:
    """Changes as a request has them, checked for their form.

    Raises:
        DesignError: they are no numbers or pairs of numbers by key.
    """
    if not isinstance(raw, dict) or not 0 < len(raw) <= MOST_CHANGES:
        raise DesignError("changes must be 1 to {most} numbers or pairs [x, y] by their keys", most=MOST_CHANGES)
    changes: dict[str, Value] = {}
    for key, value in raw.items():
        if _number(value) or (isinstance(value, str) and _WORD.fullmatch(value)):
            changes[key] = value
            continue
        try:
            changes[key] = read_point(value)
        except DesignError:
            raise DesignError(
                "{key} must be a number, a pair [x, y] of numbers, or a word", key=brief(key, 60)
            ) from None
    return changes


def read_point(raw: object) -> tuple[float, float]:
    """The coordinates of a point as a request has them.

    Raises:
        DesignError: they are no pair of numbers.
    """
    if isinstance(raw, list) and len(raw) == 2 and all(map(_number, raw)):
        return (float(raw[0]), float(raw[1]))
    raise DesignError(Message("a point must be a pair [x, y] of numbers"))


def _number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e15 and isfinite(value)


def changed(text: str, file: Path, changes: Mapping[str, Value]) -> tuple[str, Design | MotionDesign]:
    """Text of a design with some numbers changed, and the design that it is.

    Args:
        text: TOML.
        file: path of the file, for messages.
        changes: new value by dotted key, items of lists counted from 1.

    Raises:
        DesignError: the result is no design, in a sentence; or the text cannot be changed and read back.
    """
    return applied(text, file, [f"{key}={toml(value)}" for key, value in changes.items()])


def applied(text: str, file: Path, overrides: list[str]) -> tuple[str, Design | MotionDesign]:
    """Text of a design with overrides written into it, and the design that it is; as `changed`."""
    values = parse(text)
    for change in overrides:
        override(values, change)
    return checked(_rewritten(text, overrides), file, values)


def checked(results: Iterable[str], file: Path, values: TomlValues) -> tuple[str, Design | MotionDesign]:
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
            return result, complete_of(result, file)
    raise DesignError(
        "{file}: this change cannot be written into the file as it is laid out; make it in a text editor, and open the "
        "design again",
        file=brief(file.name),
    )


def _without_empty(values: TomlValues) -> TomlValues:
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


def values_of(text: str) -> TomlValues | None:
    """Raw values of a text; None if it is not TOML."""
    try:
        return parse(text)
    except ValueError:
        return None


# Values of a new item by key, as TOML has them.
NewItem = dict[str, float | str | list[float] | list[list[float]] | None]
Item = list[float] | NewItem


def inserted(
    text: str, file: Path, key: str, item: Item, overrides: Sequence[str] = ()
) -> tuple[str, Design | MotionDesign]:
    """Text of a design with one item more, and the design that it is.

    Args:
        text: TOML.
        file: path of the file, for messages.
        key: dotted key that it gets: a number in a list, at most one more than the list has items, or a section's name.
        item: x and y of a point, mm; or values of a table by key.
        overrides: changes that come with it, by the keys as they are with the item.

    Raises:
        DesignError: the result is no design; or the text cannot be changed and read back.
    """
    values = parse(text)
    name, index = _split(key)
    if index is None:
        holder, _, last = name.rpartition(".")
        values.setdefault(holder, {})[last] = item
        assert isinstance(item, dict)
        return checked(with_table(text, name, 0, item, several=False), file, values)
    if isinstance(item, dict):
        section, _, kind = name.partition(".")
        values.setdefault(section, {}).setdefault(kind, []).insert(index, item)
    else:
        item_at(values, name).insert(index, item)
    results: Iterable[str] = ()
    if not tables_of(text, name):
        results = with_item(text, name, index, item)
    if isinstance(item, dict):
        results = chain(results, with_table(text, name, index, item, several=True))
    return _checked_with(results, file, values, overrides)


def _checked_with(
    results: Iterable[str], file: Path, values: dict[str, Any], overrides: Sequence[str]
) -> tuple[str, Design | MotionDesign]:
    """Changed text with overrides besides, and its design, as `checked`."""
    for change in overrides:
        override(values, change)
    written = chain.from_iterable(_rewritten(text, list(overrides)) for text in results) if overrides else results
    return checked(written, file, values)


def removed(text: str, file: Path, key: str, overrides: Sequence[str] = ()) -> tuple[str, Design | MotionDesign]:
    """Text of a design without an item, and the design that it is; as `inserted`."""
    values = parse(text)
    name, index = _split(key)
    if index is None:
        if not tables_of(text, name):
            return applied(text, file, [f"{name}="])
        holder, _, last = name.rpartition(".")
        del values[holder][last]
        return checked(without_table(text, name, 0), file, values)
    del item_at(values, name)[index]
    of_text = without_table if tables_of(text, name) else without_item
    return _checked_with(of_text(text, name, index), file, values, overrides)


def exchanged(text: str, file: Path, key: str) -> tuple[str, Design | MotionDesign]:
    """Text of a design with an item and the next one of its list exchanged, and the design; as `inserted`."""
    values = parse(text)
    name, index = _split(key)
    assert index is not None
    items = item_at(values, name)
    items[index], items[index + 1] = items[index + 1], items[index]
    of_text = with_tables_exchanged if tables_of(text, name) else with_exchange
    return checked(of_text(text, name, index), file, values)


def _split(key: str) -> tuple[str, int | None]:
    """Dotted key of the list, and index of the item in it, from 0; None of a section that is alone."""
    name, _, number = key.rpartition(".")
    return (name, int(number) - 1) if number.isdecimal() else (key, None)


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
    return _edited(text, name, lambda written: _list_with(written, index, toml(item)))


def without_item(text: str, name: str, index: int) -> Iterator[str]:
    """Text without one of the items."""
    return _edited(text, name, lambda written: _list_without(written, index))


def with_exchange(text: str, name: str, index: int) -> Iterator[str]:
    """Text with an item and the next one exchanged; comments on their lines go with them where each has its own."""
    yield from _edited(text, name, lambda written: _list_exchanged(written, index, whole_lines=True))
    yield from _edited(text, name, lambda written: _list_exchanged(written, index, whole_lines=False))


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


def _list_with(written: str, index: int, item: str) -> str:
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


def _list_without(written: str, index: int) -> str:
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
        # It begins its line: the line goes, too, unless something follows there.
        rest = _BLANK_TO_END.match(written, end)
        if rest is not None:
            return written[:line] + written[rest.end() :]
        begin = len(written) - len(written[line:].lstrip(" \t"))
        return written[:begin] + written[end:]
    return written[:begin].rstrip(" \t" if written[end] in "]\r\n" else "") + written[end:]


def _list_exchanged(written: str, index: int, *, whole_lines: bool) -> str:
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


_HEADING = re.compile(r"^[ \t]*(\[\[?)([^\[\],#=\r\n]+)\]\]?[ \t]*(?:#[^\r\n]*)?\r?$", re.MULTILINE)
_COMMENT = re.compile(r"""("(?:\\.|[^"\\\n])*"|'[^'\n]*')|(#[^\r\n]*)""")
_BLANK_LINES = re.compile(r"(?:[ \t]*\r?\n)*")


@dataclass(frozen=True)
class Table:
    """Where a table stands in a text.

    Attributes:
        name: dotted name in its heading.
        above: where the comment lines begin that stand directly above the heading.
        begin: where the heading's line begins.
        end: where the last line of the table ends, a comment directly below it included.
    """

    name: str
    above: int
    begin: int
    end: int


def tables_of(text: str, name: str = "") -> list[Table]:
    """All tables of a text, or those of one name, in their order."""
    headings = list(_HEADING.finditer(text))
    ends = [heading.start() for heading in headings[1:]] + [len(text)]
    tables = []
    above = _above(text, headings[0].start()) if headings else 0
    for heading, rest in zip(headings, ends, strict=True):
        following = _above(text, rest) if rest < len(text) else rest
        begin, end = heading.start(), heading.start() + _length(text[heading.start() : following])
        dotted = ".".join(part.strip().strip("\"'") for part in heading[2].split("."))
        tables.append(Table(dotted, above, begin, end))
        above = following
    return [table for table in tables if name in ("", table.name)]


def with_table(text: str, name: str, index: int, item: Mapping[str, object], *, several: bool) -> Iterator[str]:
    """A text with one table more.

    Args:
        text: TOML.
        name: dotted name of the table.
        index: how many tables of the name are to stand before it.
        item: values by key.
        several: whether there may be several tables of the name.
    """
    line = _line_end(text)
    heading = f"[[{name}]]" if several else f"[{name}]"
    table = "".join(f"{row}{line}" for row in (heading, *(f"{key} = {toml(value)}" for key, value in item.items())))
    mine = tables_of(text, name)
    if mine and index == 0:
        yield text[: mine[0].above] + table + line + text[mine[0].above :]
        return
    at = len(text)
    if mine:
        at = mine[index - 1].end
    else:  # behind the others of its section, else behind the path, else at the end
        tables = tables_of(text)
        for section in (name.partition(".")[0], "path"):
            if ends := [table.end for table in tables if table.name.partition(".")[0] == section]:
                at = ends[-1]
                break
    before, after = text[:at], text[at:]
    if before and not before.endswith("\n"):
        before += line
    gap = "" if not before or before.endswith(line * 2) else line
    yield before + gap + table + ("" if not after or after[0] in "\r\n" else line) + after


def without_table(text: str, name: str, index: int) -> Iterator[str]:
    """A text without one of the tables of a name; comments in it stay."""
    mine = tables_of(text, name)
    if index >= len(mine):
        return
    begin, end = mine[index].begin, mine[index].end
    line = _line_end(text)
    kept = "".join(f"{found[2]}{line}" for found in _COMMENT.finditer(text, begin, end) if found[2])
    before, after = text[:begin], text[end:]
    if not kept and (not before or before.endswith(line * 2)):
        after = after[_BLANK_LINES.match(after).end() :]  # type: ignore[union-attr]
        before = before if after else before.rstrip() + line
    yield before + kept + after


def with_tables_exchanged(text: str, name: str, index: int) -> Iterator[str]:
    """A text with a table and the next one of its name exchanged, and the comments above them.

    A comment above the first table alone is one on all of them, and stays.
    """
    mine = tables_of(text, name)
    if index + 1 >= len(mine):
        return
    one, other = mine[index : index + 2]
    first = one.begin if index == 0 and other.above == other.begin else one.above
    tail = text[other.above : other.end]
    tail += "" if tail.endswith("\n") else _line_end(text)
    yield text[:first] + tail + text[one.end : other.above] + text[first : one.end] + text[other.end :]


def _above(text: str, heading: int) -> int:
    """Where the comment lines begin that stand directly above a heading."""
    begin = heading
    while begin:
        start = text.rfind("\n", 0, begin - 1) + 1
        if not text[start:begin].lstrip().startswith("#"):
            break
        begin = start
    return begin


def _length(table: str) -> int:
    """Length of a table's text up to its last key, and of comments directly below it."""
    length, at = 0, 0
    below = True
    for row in table.splitlines(keepends=True):
        at += len(row)
        written = row.strip()
        below = bool(written) and (below or not written.startswith("#"))
        if below:
            length = at
    return length


def _line_end(text: str) -> str:
    return "\r\n" if "\r\n" in text else "\n"
