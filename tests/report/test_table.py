"""Tables on narrow terminals: every number of them stays whole."""

import io

import pytest
from rich.console import Console
from rich.text import Text

from cadgen.report.table import FittedTable

ROWS = (
    ("smoothed, compensated for the measured play", "0.962°", "1234.5 mm", "99.99 %", "at cam angle 12.3 degrees"),
    ("actual", "-0.7°", "0.123456 mm", "", "nowhere"),
)


def printed(width: int, rows=ROWS) -> str:
    table = FittedTable(title="a title that is longer than sixty columns of a terminal, as some are", box=None)
    table.add_column("profile")
    for head in ("heading at the end", "position", "of the variance"):
        table.add_column(head, justify="right", no_wrap=head == "position")
    table.add_column("where")
    for row in rows:
        table.add_row(*row[:-1], Text(row[-1], "red"))
    file = io.StringIO()
    Console(file=file, width=width, markup=False, highlight=False).print(table)
    return file.getvalue()


@pytest.mark.parametrize("width", [200, 100, 80, 72, 60, 50, 40, 30, 24])
def test_numbers_are_whole_and_nothing_is_lost(width):
    text = printed(width)
    for number in ("0.962°", "1234.5 mm", "99.99 %", "-0.7°", "0.123456 mm"):
        assert number in text, text
    assert "…" not in text
    assert max(map(len, text.splitlines())) <= width
    for word in ("smoothed,", "compensated", "measured", "heading", "variance", "degrees", "nowhere"):
        assert word in text, text


def test_a_wide_terminal_has_one_line_for_each_row():
    assert len(printed(200).splitlines()) == 4
    assert len(printed(60).splitlines()) > 4


def test_lists_have_no_line_for_an_empty_cell():
    assert printed(30).count("variance") == 1
