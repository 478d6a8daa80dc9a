"""A planned path, and a card of settings, as sentences and tables."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from cadgen.cli import show
from cadgen.cli.show import Output

if TYPE_CHECKING:
    from cadgen.api.card import Card
    from cadgen.api.planning import Plan


def plan(planned: "Plan[Any]") -> None:
    """Print the result, and the checks of the cam for the path if there is one."""
    _sentences(planned.sentences)
    if planned.cam is not None:
        show.figures(f"\n{planned.cam.design.name}, {planned.cam.profile} profile", planned.cam.checks)


def card(result: "Card") -> None:
    """Print the result, the settings of every spacing, and the checks of a cam that fails."""
    _sentences(result.sentences)
    heads, rows = result.table()
    table = show.plain_table("")
    for head in heads:
        table.add_column(head, justify="right")
    for cells, row in zip(rows, result.settings, strict=True):
        table.add_row(*cells, style=None if row["kept"] else "red")
    Output().print(table)
    for line in result.legend:
        Output().print(f"{line}.", style="dim")
    show.failed(result.cam)


def _sentences(lines: Iterable[str]) -> None:
    console = Output()
    for sentence in lines:
        console.print(f"{sentence[0].upper()}{sentence[1:]}.")
