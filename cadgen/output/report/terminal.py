"""Sheets and sentences on a terminal or as plain text: lines that never cut a number.

Where a table is too wide, its words are folded; where that is not enough, each row becomes a list.
"""

import io
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderableType, RenderResult
from rich.padding import Padding
from rich.segment import Segment
from rich.table import Column, Table
from rich.text import Text

from cadgen.figures import Emphasis, Sheet, with_unit
from cadgen.messages import ENGLISH, shown

_GAP = 2  # columns of the terminal between two columns of the table
_FOLDED = 24  # a word longer than that may be folded inside
# Between a number and its unit, a share and its value, a value and its spread: no line ends there.
_TOGETHER = re.compile(r"(?<=\d) (?=(?:mm[23]?|µm|m|kB|MB|s|min|N)\b|[%±])|(?<=\d %) (?=-?\d)|(?<=±) (?=\d)")
_BOND = "\ue000"  # stands there while lines are folded: a letter to rich, which folds at every kind of space


class FittedConsole(Console):
    """A console that keeps number and unit on one line, and where brackets in names and sentences are only brackets.

    Args:
        language: language in which messages are printed; the one chosen for the program if left out.
        options: options of the library's console.
    """

    def __init__(self, *, language: str | None = None, **options: Any) -> None:
        super().__init__(markup=False, emoji=False, highlight=False, **options)
        self.language = language

    def render_str(self, text: str, **options: Any) -> Text:
        """Text of a sentence or a cell."""
        return _bound(super().render_str(shown(text, self.language), **options))

    def render(self, renderable: RenderableType, options: ConsoleOptions | None = None) -> Iterable[Segment]:
        """Pieces of a text, a table or a cell, folded."""
        for segment in super().render(_bound(renderable) if isinstance(renderable, Text) else renderable, options):
            yield segment._replace(text=segment.text.replace(_BOND, " "))


def _bound(text: Text) -> Text:
    """Text held together where no line may end."""
    text = text.copy()
    text.plain = _TOGETHER.sub(_BOND, text.plain)
    return text


class FittedTable(Table):
    """A table whose columns to the left are words, and those to the right numbers.

    Where it is too wide for the terminal the words are folded; where that is not enough, every row becomes a list of
    its numbers under its first cell, each after the head of its column.
    """

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Render for rich: the table as it is, with folded words, or row by row."""
        room = options.max_width - _GAP * (len(self.columns) - (not self.pad_edge))
        if sum(map(_natural, self.columns)) > room:
            widths = _widths(self.columns, room)
            if widths is None:
                yield from self._row_by_row()
                return
            for column, width in zip(self.columns, widths, strict=True):
                column.width, column.no_wrap, column.overflow = width, False, "fold"
        yield from super().__rich_console__(console, options)

    def _row_by_row(self) -> RenderResult:
        if self.title:
            yield _text(self.title, self.title_style)
        first, *others = ([_text(cell) for cell in column.cells] for column in self.columns)
        heads = [_text(str(column.header).replace("\n", " "), self.header_style) for column in self.columns[1:]]
        for number, row in enumerate(self.rows):
            yield Text.assemble(first[number], style=row.style or "")
            below = Table.grid(padding=(0, _GAP))
            below.add_column(overflow="fold")
            below.add_column(overflow="fold")
            for head, cells in zip(heads, others, strict=True):
                if cells[number].plain:
                    below.add_row(head, cells[number], style=row.style)
            yield Padding(below, (0, 0, 0, _GAP))


def _widths(columns: list[Column], room: int) -> list[int] | None:
    """Widths of columns that fit into a room, numbers whole and words folded; None if no widths fit."""
    numbers = [column.justify == "right" for column in columns]
    widths = []
    for column, number in zip(columns, numbers, strict=True):
        cells = [column.header] if number else [column.header, *column.cells]
        words = (word for cell in cells for word in _bound(_text(cell)).plain.split())
        longest = max((min(cell_len(word), _FOLDED) for word in words), default=0)
        widths.append(max(longest, _natural_cell(column) if number else 0))
    left = room - sum(widths)
    if left < 0:
        return None
    # What is left goes to the columns of words, evenly, but to none more than it can use.
    while left > 0:
        folded = [k for k, column in enumerate(columns) if widths[k] < _natural(column)]
        folded = [k for k in folded if not numbers[k]] or folded
        if not folded:
            break
        for k in folded[:left]:
            widths[k] += 1
        left -= len(folded[:left])
    return widths


def _natural(column: Column) -> int:
    """Width in which nothing is folded."""
    return max(_natural_cell(column), *(cell_len(line) for line in _text(column.header).plain.split("\n")))


def _natural_cell(column: Column) -> int:
    return max((cell_len(line) for cell in column.cells for line in _text(cell).plain.split("\n")), default=0)


def _text(cell: object, style: object = "") -> Text:
    """A cell or a head as text; the tables here hold nothing else."""
    return cell if isinstance(cell, Text) else Text(str(cell), style=str(style or ""))


_STYLES = {
    Emphasis.PLAIN: "",
    Emphasis.GOOD: "green",
    Emphasis.BAD: "red",
    Emphasis.STRONG: "bold",
    Emphasis.MUTED: "dim",
}


def table(sheet: Sheet, *, gap: bool = False, language: str | None = None) -> FittedTable:
    """A sheet as a table without rules, its title above it: words to the left, numbers to the right and never folded.

    A row whose first cell is emphasized is so as a whole.

    Args:
        sheet: sheet.
        gap: whether an empty line stands above the title.
        language: language of its texts; the one chosen for the program if left out.
    """
    title = f"{chr(10) if gap else ''}{shown(sheet.title, language)}" or None
    made = FittedTable(
        title=title, title_justify="left", title_style="bold", box=None, pad_edge=False, header_style="dim"
    )
    for place, head in enumerate(sheet.heads):
        numeric = sheet.numeric(place)
        made.add_column(
            shown(head, language), justify="right" if numeric else "left", overflow="ellipsis" if numeric else "fold"
        )
    for row in sheet.cells:
        whole = row[0].state
        texts = (with_unit(shown(cell.text, language), shown(cell.unit, language)) for cell in row)
        styles = ("" if cell.state == whole else _STYLES[cell.state] for cell in row)
        made.add_row(*map(Text, texts, styles), style=_STYLES[whole] or None)  # Text(text, style)
    return made


@dataclass(frozen=True)
class Heading:
    """Line that stands out."""

    text: str


Block = Heading | Sheet | str


def write(blocks: Sequence[Block], console: FittedConsole) -> None:
    """Print blocks, folded to the console's width.

    Args:
        blocks: headings, sheets and paragraphs.
        console: console that they are printed on.
    """
    for block in blocks:
        if isinstance(block, Heading):
            console.print(f"\n{shown(block.text, console.language)}", style="bold")
        else:
            console.print(table(block, language=console.language) if isinstance(block, Sheet) else block)


def plain(blocks: Sequence[Block], width: int) -> str:
    """Blocks as plain English text, folded to `width` characters."""
    file = io.StringIO()
    write(blocks, FittedConsole(file=file, width=width, color_system=None, language=ENGLISH))
    return "\n".join(line.rstrip() for line in file.getvalue().splitlines()).strip("\n") + "\n"
