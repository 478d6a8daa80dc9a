"""Tables as people export them: text of any encoding, columns set apart by any mark, numbers with point or comma.

A table is a line of column names, at most a line of units, and rows of cells. Lines that begin with # are remarks, and
so are those above the names. What had to be understood for that is said in notes.
"""

import csv
import re
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from io import BytesIO, StringIO
from typing import Any

from cadgen.errors import FileError, brief
from cadgen.inference.records.units import unit_of
from cadgen.messages import Message, joined

# Of a file's comment lines, and of the characters of any line: they are searched for words on the instrument.
MOST_REMARKS, LONGEST_LINE = 200, 1000
# Sheets are packed: a small file may hold a large table.
MOST_UNPACKED = 200_000_000
_HEAD_LINES = 20  # lines in which the names of the columns are looked for
_MARKS = {";": Message("semicolons"), "\t": Message("tabs"), ",": Message("commas"), "|": Message("bars")}
_POINT = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*")
_COMMA = re.compile(r"\s*[+-]?(\d+,\d*|,\d+)([eE][+-]?\d+)?\s*")
_GROUPS = re.compile(r"\s*[+-]?\d{1,3}(,\d{3})+\s*")


@dataclass(frozen=True)
class Head:
    """Names of the columns of a table, and the lines under them.

    Attributes:
        names: names of the columns, with their units where the file has those.
        body: number and text of each line of a row.
        mark: mark between the cells of a line; empty for spaces.
        remarks: comment lines, without their mark.
        notes: what was understood besides commas and a first line of names.
    """

    names: tuple[str, ...]
    body: tuple[tuple[int, str], ...]
    mark: str
    remarks: tuple[str, ...]
    notes: tuple[Message, ...] = ()


@dataclass(frozen=True)
class TableRows:
    """TableRows of a table.

    Attributes:
        lines: number of each row's line in the file.
        cells: cells of each row, numbers with decimal points.
        notes: what was understood besides points.
    """

    lines: tuple[int, ...]
    cells: tuple[tuple[str, ...], ...]
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
    remarks = [line.lstrip("# ").strip() for line in lines if line.startswith("#")]
    body = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and not line.startswith("#")]
    notes: list[Message] = []
    mark = ""
    if body and (stated := re.fullmatch(r"sep=(.)", body[0][1].strip())):
        mark, body = stated[1], body[1:]
    if not body:
        raise FileError(
            "{name}: no table in it; the first line must name the columns, such as run,cam_angle_deg", name=name
        )
    # The line with most names, the first of these; what stands above it says something of the file.
    heads = [_split(line, mark or _mark(line), number, name) for number, line in body[:_HEAD_LINES]]
    counts = [known(cells) for cells in heads]
    top = counts.index(max(counts))
    if top:
        remarks = [*remarks, *(line.strip() for _, line in body[:top])]
        notes.append(Message("the names of its columns stand in line {line}", line=body[top][0]))
    mark, names, body = mark or _mark(body[top][1]), heads[top], body[top + 1 :]
    if mark != ",":
        notes.append(Message("its columns are set apart by {marks}", marks=_MARKS.get(mark, Message("spaces"))))
    units = [cell.strip("[]() ") for cell in _split(body[0][1], mark, body[0][0], name)] if body else []
    if len(units) == len(names) and any(units) and all(not unit or unit_of(unit) for unit in units):
        names = [f"{column} [{unit}]" if unit else column for column, unit in zip(names, units, strict=True)]
        notes.append(Message("its second line has the units"))
        body = body[1:]
    return Head(tuple(names), tuple(body), mark, tuple(remarks), tuple(notes))


def rows_of(head: Head, name: str) -> TableRows:
    """TableRows under the names of a table.

    Raises:
        FileError: no row, one of another length than the names, or commas that may stand for points or for thousands.
    """
    rows = [(number, _split(line, head.mark, number, name)) for number, line in head.body]
    if not rows:
        raise FileError("{name}: no row stands under its header; add what was measured", name=name)
    for number, cells in rows:
        if len(cells) != len(head.names):
            raise FileError(
                "{name}, line {line}: {count} cells under {columns} columns; correct the line, with commas between "
                "cells and decimal points in numbers",
                name=name,
                line=number,
                count=len(cells),
                columns=len(head.names),
            )
    lines, table = tuple(n for n, _ in rows), tuple(tuple(row) for _, row in rows)
    columns = list(zip(*table, strict=True))
    if not any(_COMMA.fullmatch(cell) for column in columns for cell in column):
        return TableRows(lines, table)
    for column in columns:
        # A comma may set thousands apart, as 1,250 beside 980 or 0.5 does.
        commas = [cell for cell in column if _COMMA.fullmatch(cell)]
        others = [cell for cell in column if _POINT.fullmatch(cell)]
        grouped = all(_GROUPS.fullmatch(cell) and not re.match(r"\s*[+-]?0", cell) for cell in commas)
        if commas and others and (grouped or any("." in cell for cell in others)):
            raise FileError(
                "{name}: its commas may stand for decimal points or for thousands, as in {cell}; save it with decimal "
                "points",
                name=name,
                cell=brief(commas[0].strip()),
            )
    points = tuple(tuple(c.replace(",", ".") if _COMMA.fullmatch(c) else c for c in row) for row in table)
    return TableRows(lines, points, (Message("it has decimal commas"),))


def _mark(line: str) -> str:
    """Mark between the cells of a line; empty for spaces."""
    return next((mark for mark in ";\t,|" if mark in line), "")


def _split(line: str, mark: str, number: int, name: str) -> list[str]:
    if not mark:
        return line.split()
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
    if (remarks := sum(line.startswith("#") for line in lines)) > MOST_REMARKS:
        raise FileError(
            "{name}: {remarks} comment lines, more than {most}; keep those that tell design and instrument",
            name=name,
            remarks=remarks,
            most=MOST_REMARKS,
        )
