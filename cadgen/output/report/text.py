"""A report in words: paragraphs and aligned tables, on a terminal or in a text file."""

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cadgen.output.report.table import FittedConsole


@dataclass(frozen=True)
class Heading:
    """A line that stands out."""

    text: str


@dataclass(frozen=True)
class Table:
    """Aligned columns: words to the left and folded if need be; numbers to the right and never folded."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    words: int = 1


Block = Heading | Table | str


def write(blocks: Sequence[Block], console: "FittedConsole") -> None:
    """Print blocks, folded to the console's width.

    Args:
        blocks: headings, tables and paragraphs; the first `words` columns of a table are words.
        console: console that they are printed on.
    """
    from cadgen.output.report.table import FittedTable

    for block in blocks:
        if isinstance(block, Heading):
            console.print(f"\n{block.text}", style="bold")
        elif isinstance(block, Table):
            table = FittedTable(box=None, pad_edge=False, header_style="dim")
            for k, head in enumerate(block.head):
                if k < block.words:
                    table.add_column(head, overflow="fold")
                else:
                    table.add_column(head, justify="right")
            for row in block.rows:
                table.add_row(*row)
            console.print(table)
        else:
            console.print(block)


def plain(blocks: Sequence[Block], width: int) -> str:
    """Blocks as plain text, folded to `width` characters."""
    from cadgen.output.report.table import FittedConsole

    file = io.StringIO()
    write(blocks, FittedConsole(file=file, width=width, color_system=None))
    return "\n".join(line.rstrip() for line in file.getvalue().splitlines()).strip("\n") + "\n"
