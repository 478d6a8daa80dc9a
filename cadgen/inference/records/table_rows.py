"""Rows of a table: those that are measured, apart from repeated names, titles of runs, summaries and last lines.

What stands between or behind the rows is passed over where it cannot be a row, and that is said. A block of rows is a
run, where a table has no column of runs: it begins where the names stand again, or under a title such as `Run 2`.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from cadgen.errors import FileError, brief
from cadgen.inference.records.text_table import Head, split_line
from cadgen.inference.records.units import IDLE, MISSING, heading, unit_of
from cadgen.messages import Message, joined

# First cells of rows that sum others up.
_SUMMARIES = frozenset(
    (
        *("mean", "average", "avg", "median", "max", "maximum", "min", "minimum", "std", "stdev", "std dev", "sigma"),
        *("sum", "total", "count", "range", "rms", "standard deviation", "mittelwert", "mittel", "durchschnitt"),
        *("summe", "standardabweichung", "stabw", "anzahl", "spannweite", "mw", "moyenne", "somme", "écart type"),
        *("平均", "平均值", "均值", "最大", "最大值", "最小", "最小值", "标准差", "合计", "总计", "求和"),
    )
)
_TITLE_CELLS = 2  # of the title of a run, such as `Run` and `2`
_MOST_LINES = 12  # behind the rows, which are passed over
MOST_LOST = 0.2  # of the rows: where more lack a number, that says something


@dataclass(frozen=True)
class TableRows:
    """Rows of a table.

    Attributes:
        names: names of the columns that are not empty.
        lines: number of each row's line in the file.
        columns: cells of each column.
        blocks: number of the block of each row, from 0.
        passed: text of titles and other lines that are no rows.
        notes: what was understood besides rows.
    """

    names: tuple[str, ...]
    lines: tuple[int, ...]
    columns: tuple[tuple[str, ...], ...]
    blocks: tuple[int, ...]
    passed: tuple[str, ...] = ()
    notes: tuple[Message, ...] = ()

    def where(self, rows: Sequence[int]) -> "TableRows":
        """Some of the rows, by their places."""
        return replace(
            self,
            lines=tuple(self.lines[k] for k in rows),
            columns=tuple(tuple(column[k] for k in rows) for column in self.columns),
            blocks=tuple(self.blocks[k] for k in rows),
        )

    def noted(self, *notes: Message) -> "TableRows":
        """The table with further notes."""
        return replace(self, notes=(*self.notes, *notes))


def rows_of(head: Head, name: str) -> TableRows:
    """Rows under the names of a table.

    Args:
        head: names and lines of the table.
        name: of the file, for messages.

    Raises:
        FileError: no row, or one of another length than the names.
    """
    width, block = len(head.names), 0
    # Comments behind the rows may lack, and so do the marks before them.
    needed = next((k for k in range(width, 0, -1) if heading(head.names[k - 1]).quantity not in IDLE), width)
    lines: list[int] = []
    rows: list[list[str]] = []
    blocks: list[int] = []
    # Lines that are no rows, which stand behind the last row or under the names.
    odd: list[tuple[int, list[str]]] = []
    above: list[int] = []
    # Rows that sum up those of their block, and the words that they have there.
    summed: list[int] = []
    words: list[str] = []
    passed: list[str] = []
    for number, line in head.body:
        cells = split_line(line, head.mark, number, name)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if needed <= len(cells) < width:
            cells += [""] * (width - len(cells))
        first = next((cell for cell in cells if cell), "")
        if not first:
            continue
        word = first.lower().rstrip(":")
        if tuple(cells) in head.printed or _is_title(cells, first):
            block, words = len(set(blocks)), []
            passed += [line] if tuple(cells) not in head.printed else []
        elif word in _SUMMARIES and word not in words and rows:
            summed.append(number)
            words.append(word)
        elif word in _SUMMARIES:
            raise _no_summary(name, number, first)
        elif len(cells) != width or not any(map(_may_be_number, cells)):
            odd.append((number, cells))
            passed.append(line)
        else:
            if words:
                raise _no_summary(name, summed[-1], words[-1])
            if odd and (rows or not _are_words(odd)):
                raise _other_length(name, *odd[0], width)
            above += [at for at, _ in odd]
            odd = []
            lines.append(number)
            rows.append(cells)
            blocks.append(block)
    for number, cells in odd:
        # Two numbers may be a row, whatever else stands beside them.
        if len(odd) > _MOST_LINES or not any(map(_is_word, cells)) or sum(map(_may_be_number, cells)) > 1:
            raise _other_length(name, number, cells, width)
    if not rows:
        if odd:
            raise _other_length(name, *odd[0], width)
        raise FileError("{name}: no row stands under its header; add what was measured", name=name)
    over = sorted([*above, *summed, *(at for at, _ in odd)])
    said = Message("lines that are no rows are passed over: {lines}", lines=joined(map(str, over), ", "))
    columns = list(zip(*rows, strict=True))
    kept = [k for k, called in enumerate(head.names) if called or any(columns[k])]
    return TableRows(
        tuple(head.names[k] for k in kept),
        tuple(lines),
        tuple(columns[k] for k in kept),
        tuple(blocks),
        tuple(passed),
        (said,) if over else (),
    )


def _is_title(cells: list[str], first: str) -> bool:
    """Whether a line is the title of a run, such as `Run 2`."""
    said = " ".join(cell for cell in cells if cell)
    titled = heading(re.sub(r"[\s#:.\d]+$", "", said)).quantity == "run"
    return titled and sum(map(bool, cells)) <= _TITLE_CELLS and not _may_be_number(first)


def _may_be_number(cell: str) -> bool:
    return cell[:1].isdigit() or (cell[:1] in "+-.,−–" and cell[1:2].isdigit()) or (cell[:2] in ("-.", "-,"))


def _is_word(cell: str) -> bool:
    return any(map(str.isalpha, cell)) and cell.lower() not in MISSING


def _are_words(odd: list[tuple[int, list[str]]]) -> bool:
    """Whether lines under the names hold words alone, of which none is a unit."""
    words = [word for _, row in odd for cell in row for word in (cell, *cell.split())]
    return not any(_may_be_number(word) or unit_of(word.strip("[]()., ")) for word in words)


def _no_summary(name: str, line: int, word: str) -> FileError:
    return FileError(
        "{name}, line {line}: {word} begins a row that sums others up, and stands twice or before rows: take the line "
        "out, or call the run otherwise",
        name=name,
        line=line,
        word=brief(word),
    )


def _other_length(name: str, line: int, cells: list[str], width: int) -> FileError:
    if len(cells) == width:
        return FileError(
            "{name}, line {line}: no number stands in it, and rows follow: take the line out", name=name, line=line
        )
    return FileError(
        "{name}, line {line}: {count} cells under {columns} columns; correct the line, with commas between "
        "cells and decimal points in numbers",
        name=name,
        line=line,
        count=len(cells),
        columns=width,
    )


def with_numbers(table: TableRows, numeric: Sequence[int]) -> TableRows:
    """Rows with a number in each of some columns; of a point that was lost there is none.

    Args:
        table: rows of a table.
        numeric: places of the columns.
    """
    rows = range(len(table.lines))
    kept = [row for row in rows if not any(table.columns[k][row].lower() in MISSING for k in numeric)]
    lost = len(rows) - len(kept)
    # A column that is empty here and there is no column of points that were lost.
    if not lost or lost > MOST_LOST * len(rows):
        return table
    return table.where(kept).noted(Message("{count} rows without a number are left out", count=lost))


def each_once(table: TableRows, used: Sequence[int]) -> TableRows:
    """Rows that do not repeat the one before, as a logger writes that is asked more often than it reads.

    Args:
        table: rows of a table.
        used: places of the columns that count.
    """
    cells = list(zip(*(table.columns[k] for k in used), table.blocks, strict=True))
    kept = [row for row in range(len(cells)) if not row or cells[row] != cells[row - 1]]
    if twice := len(cells) - len(kept):
        return table.where(kept).noted(Message("{count} rows that repeat the one before are left out", count=twice))
    return table


def thinned(table: TableRows, most: int) -> TableRows:
    """Table with every k-th row, so that no more are left than can be judged: logs have a thousand rows a second.

    Args:
        table: rows of a table.
        most: rows that can be judged.
    """
    each = -(-len(table.lines) // most)
    if each <= 1:
        return table
    return table.where(range(0, len(table.lines), each)).noted(Message("one row in {each} is used", each=each))
