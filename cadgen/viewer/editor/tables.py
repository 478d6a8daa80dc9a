"""Tables under headings in a design file's text, such as `[[course.posts]]`: put in, taken out or exchanged."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from cadgen.viewer.editor.lists import toml

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
        tables.append(Table(_dotted(heading[2]), above, begin, end))
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
    at = mine[index - 1].end if mine else _place(text, name)
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


def _place(text: str, name: str) -> int:
    """Where the first table of a name goes: behind the others of its section, else behind the path, else at the end."""
    tables = tables_of(text)
    for section in (name.partition(".")[0], "path"):
        of_section = [table.end for table in tables if table.name.partition(".")[0] == section]
        if of_section:
            return of_section[-1]
    return len(text)


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


def _dotted(written: str) -> str:
    return ".".join(part.strip().strip("\"'") for part in written.split("."))


def _line_end(text: str) -> str:
    return "\r\n" if "\r\n" in text else "\n"
