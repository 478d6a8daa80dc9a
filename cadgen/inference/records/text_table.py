"""Tables as people export them: text of any encoding, columns set apart by any mark, numbers with point or comma.

A table is a line of column names, at most a line of units, and rows of cells. Lines that begin with #, % or // are
remarks, and so are those above the names. What had to be understood for that is said in notes.
"""

import csv
import re
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from io import BytesIO, StringIO
from typing import Any

from cadgen.errors import FileError, brief
from cadgen.inference.records.units import BARE, heading, unit_of
from cadgen.messages import Message, joined

# Of a file's comment lines, and of the characters of any line: they are searched for words on the instrument.
MOST_REMARKS, LONGEST_LINE = 200, 1000
# Sheets are packed: a small file may hold a large table.
MOST_UNPACKED = 200_000_000
_LEAST_NAMES = 2  # of a line that names columns, if it is a remark
HEAD_LINES = 60  # lines in which the names of the columns are looked for
_MARKS = {
    ";": Message("semicolons"),
    "\t": Message("tabs"),
    ",": Message("commas"),
    "|": Message("bars"),
    "；": Message("semicolons"),
    "，": Message("commas"),
}
_REMARK = ("#", "%", "//")
_RULE = re.compile(r"[|\s:+=-]*[|:+=-]{2}[|\s:+=-]*")  # of a table that is drawn with marks


@dataclass(frozen=True)
class Head:
    """Names of the columns of a table, and the lines under them.

    Attributes:
        names: names of the columns, with their units where the file has those.
        printed: cells of the lines that hold the names and the units, as they stand in the file.
        body: number and text of each line of a row.
        mark: mark between the cells of a line; empty for spaces.
        remarks: comment lines, without their mark.
        notes: what was understood besides commas and a first line of names.
    """

    names: tuple[str, ...]
    printed: tuple[tuple[str, ...], ...]
    body: tuple[tuple[int, str], ...]
    mark: str
    remarks: tuple[str, ...]
    notes: tuple[Message, ...] = ()


def text_of(content: bytes, name: str, known: Callable[[str], int]) -> tuple[str, tuple[Message, ...]]:
    """Text of a file, and its encoding if it is none of UTF-8.

    Args:
        content: bytes of the file.
        name: of the file, for messages.
        known: number of column names of a text that are known; it decides between encodings that cannot be told apart.

    Raises:
        FileError: it is no text, or a sheet that cannot be read.
    """
    if content.startswith(b"PK\x03\x04"):
        return _sheet_text(content, name, known)
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        tried = ["utf-16"]
    elif b"\0" in (start := content[:200]):
        tried = ["utf-16-le" if start[1::2].count(0) > start[::2].count(0) else "utf-16-be"]
    else:
        tried = ["utf-8-sig", "gb18030", "cp1252"]
    texts = []
    for encoding in tried:
        try:
            text = content.decode(encoding)
        except UnicodeDecodeError:
            continue
        if re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]", text):
            continue
        if encoding == "utf-8-sig":
            return text, ()
        texts.append((known(text), text, encoding.upper().removesuffix("-LE").removesuffix("-BE")))
    if not texts:
        raise FileError("{name} is not text: give a CSV file", name=name)
    _, text, encoding = max(texts, key=lambda each: each[0])
    return text, (Message("its letters are {encoding}", encoding=encoding),)


def _sheet_text(content: bytes, name: str, known: Callable[[str], int]) -> tuple[str, tuple[Message, ...]]:
    """Sheet of a workbook with most of the columns that are known, the first of several, as text with tabs."""
    try:
        import openpyxl
    except ImportError:
        raise FileError(
            "{name} is a workbook, for which openpyxl is lacking: install it from the clone with "
            'pip install ".[xlsx]", or save the sheet as CSV',
            name=name,
        ) from None
    try:
        with zipfile.ZipFile(BytesIO(content)) as parts:
            size = sum(part.file_size for part in parts.infolist())
        if size > MOST_UNPACKED:
            raise FileError(
                "{name} holds {size:.0f} MB, more than the {most:.0f} that can be read: save the sheet as CSV",
                name=name,
                size=size / 1e6,
                most=MOST_UNPACKED / 1e6,
            )
        book = openpyxl.load_workbook(BytesIO(content), read_only=True, data_only=True)
        texts = {brief(sheet.title): text for sheet in book.worksheets if (text := _rows_text(sheet))}
        if not texts:
            raise FileError("{name}: no sheet of it has a row; add what was measured", name=name)
    except FileError:
        raise
    except Exception:  # the library fails on damaged files with any error
        raise FileError("{name} is no workbook that can be read: save the sheet as CSV", name=name) from None
    counts = {title: known(text) for title, text in texts.items()}
    read = max(counts, key=counts.__getitem__)
    # Sheets with as many of them may be further runs.
    others = [title for title, count in counts.items() if title != read and count and count == counts[read]]
    if others:
        note = Message(
            "sheet {title} alone is read, and not {others}: save each sheet as a file of its own",
            title=read,
            others=joined(others, ", "),
        )
        return texts[read], (note,)
    return texts[read], (Message("sheet {title}", title=read),)


def _rows_text(sheet: Any) -> str:
    """Rows of a sheet as text with tabs; empty without one."""
    cells = [
        ["" if cell is None else repr(cell) if isinstance(cell, float) else str(cell) for cell in row]
        for row in sheet.iter_rows(values_only=True)
    ]
    rows = [row for row in cells if any(row)]
    if not rows:
        return ""
    width = max(len(row) - next((n for n, cell in enumerate(reversed(row)) if cell), len(row)) for row in rows)
    out = StringIO()
    csv.writer(out, delimiter="\t", lineterminator="\n").writerows(row[:width] for row in rows)
    return out.getvalue()


def head_of(text: str, name: str, known: Callable[[Sequence[str]], int]) -> Head:
    """Names of the columns of a text.

    Args:
        text: of the file.
        name: of the file, for messages.
        known: number of names among some cells that are known as names of columns.

    Raises:
        FileError: no table, or lines or remarks that are too long.
    """
    lines = text.splitlines()
    _refuse_long(lines, name)
    remarks = [line.lstrip("#%/ ").strip() for line in lines if is_remark(line)]
    body = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and not is_remark(line)]
    body = [(n, line) for n, line in body if not _RULE.fullmatch(line)]
    notes: list[Message] = []
    mark = ""
    if body and (stated := re.fullmatch(r"sep=(.)", body[0][1].strip())):
        mark, body = stated[1], body[1:]
    if not body:
        raise FileError(
            "{name}: no table in it; the first line must name the columns, such as run,cam_angle_deg", name=name
        )
    # The line with most names, the first of these; what stands above it says something of the file.
    heads = [split_line(line, mark or _mark(line), number, name) for number, line in body[:HEAD_LINES]]
    counts = [known(cells) for cells in heads]
    top = counts.index(max(counts))
    of_remark = _named_in_remark(remarks, body[0][1], mark, name, known) if max(counts) < _LEAST_NAMES else None
    if of_remark:
        names, mark = of_remark, mark or _mark(body[0][1])
        notes.append(Message("a remark names its columns"))
    else:
        if top:
            remarks = [*remarks, *(line.strip() for _, line in body[:top])]
            notes.append(Message("the names of its columns stand in line {line}", line=body[top][0]))
        mark, names = mark or _mark(body[top][1]), heads[top]
        if not mark:
            names = _names_apart(body[top][1], len(split_line(body[-1][1], mark, body[-1][0], name)))
        body = body[top + 1 :]
    if mark != ",":
        notes.append(Message("its columns are set apart by {marks}", marks=_MARKS.get(mark, Message("spaces"))))
    printed = tuple(names)
    under = tuple(split_line(body[0][1], mark, body[0][0], name)) if body else ()
    units = _units_in(under, names) if body else None
    if units:
        names = [_with_unit(column, unit, name) for column, unit in zip(names, units, strict=True)]
        notes.append(Message("its second line has the units"))
    above = (printed, under) if units else (printed,)
    return Head(tuple(names), above, tuple(body[1:] if units else body), mark, tuple(remarks), tuple(notes))


def is_remark(line: str) -> bool:
    """Whether a line is a remark by its mark."""
    return line.startswith(_REMARK)


def _named_in_remark(
    remarks: Sequence[str], row: str, mark: str, name: str, known: Callable[[Sequence[str]], int]
) -> list[str] | None:
    """Names of columns in the last remark that has as many as a row has cells; None if none has."""
    mark = mark or _mark(row)
    width = len(split_line(row, mark, 1, name))
    for remark in reversed(remarks):
        try:
            cells = _names_apart(remark, width) if not mark else split_line(remark, mark, 1, name)
        except FileError:
            continue
        if len(cells) == width and known(cells) >= _LEAST_NAMES:
            return cells
    return None


def _names_apart(line: str, width: int) -> list[str]:
    """Names that spaces set apart: two of them, where names hold one, else one before any but a bracket."""
    wide = re.split(r"\s{2,}", line.strip())
    return wide if len(wide) == width else re.sub(r"\s+(?=[\[(])", "", line).split()


def _units_in(cells: Sequence[str], names: Sequence[str]) -> list[str] | None:
    """Unit of each column by the line under the names, empty where it has none; None if it is no line of units."""
    units = [cell.strip("[]()（） ") for cell in cells]
    while len(units) > len(names) and not units[-1]:
        units.pop()
    if len(units) < len(names) and all(heading(called).quantity in BARE for called in names[: -len(units)]):
        units = [*[""] * (len(names) - len(units)), *units]  # columns in front have none
    units = ["" if unit in ("-", "–", "1") else unit for unit in units]
    some = [unit for unit in units if unit]
    if len(units) != len(names) or any(unit[0].isdigit() for unit in some):
        return None
    # Of columns that are not needed a unit may be unknown.
    return units if sum(map(bool, map(unit_of, some))) > len(some) / 2 else None


def _with_unit(column: str, unit: str, name: str) -> str:
    """Name of a column with the unit under it, if it has none itself."""
    own = heading(column).unit
    if not unit or not unit_of(own):
        return f"{column} [{unit}]" if unit else column
    if unit_of(unit) not in (None, unit_of(own)):
        raise FileError(
            "{name}: the column {column} has another unit in the line under its name, {unit}: keep one of them",
            name=name,
            column=brief(column),
            unit=brief(unit),
        )
    return column


def _mark(line: str) -> str:
    """Mark between the cells of a line; empty for spaces."""
    return next((mark for mark in _MARKS if mark in line), "")


def split_line(line: str, mark: str, number: int, name: str) -> list[str]:
    """Cells of a line.

    Args:
        line: of a table.
        mark: mark between them; empty for spaces.
        number: of the line, for messages.
        name: of the file, for messages.

    Raises:
        FileError: a quote that is not closed.
    """
    if not mark:
        return line.split()
    if mark == "|" and line.lstrip().startswith("|"):
        line = line.strip().removeprefix("|").removesuffix("|")
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=mark, strict=True))]
    except csv.Error as error:
        raise FileError("{name}, line {line}: {error}; correct the line", name=name, line=number, error=error) from None


def _refuse_long(lines: list[str], name: str) -> None:
    if long := next((n for n, line in enumerate(lines, 1) if len(line) > LONGEST_LINE), None):
        raise FileError(
            "{name}, line {long}: {count} characters, more than the {most} of the longest line that there can "
            "be; correct the line",
            name=name,
            long=long,
            count=len(lines[long - 1]),
            most=LONGEST_LINE,
        )
    if (remarks := sum(is_remark(line) for line in lines)) > MOST_REMARKS:
        raise FileError(
            "{name}: {remarks} comment lines, more than {most}; keep those that tell design and instrument",
            name=name,
            remarks=remarks,
            most=MOST_REMARKS,
        )
