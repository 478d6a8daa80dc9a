"""Tables on narrow terminals: every number of them stays whole."""

import io

import pytest
from rich.console import Console
from rich.text import Text

from cadgen.output.report.terminal import FittedConsole, FittedTable

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


@pytest.mark.parametrize("width", [24, 31, 37, 60])
def test_no_line_ends_between_a_number_and_its_unit(width):
    sentence = (
        "with play the run ends 306 mm off, 50 % 14.3 mm, 90 % -11.5°, and 0.4000 ± 0.0016 of 41 kB [1 m] or 5 mm3"
    )
    table = FittedTable(box=None)
    table.add_column("where")
    table.add_row(sentence)
    table.add_row(Text(sentence, "dim"))
    for printed_as in (sentence, Text(sentence, "red"), table):
        file = io.StringIO()
        FittedConsole(file=file, width=width).print(printed_as)
        lines = file.getvalue().splitlines()
        assert max(map(len, lines)) <= width
        for whole in ("306 mm", "50 % 14.3 mm", "90 % -11.5°", "0.4000 ± 0.0016", "41 kB", "[1 m]", "5 mm3"):
            assert any(whole in line for line in lines), (whole, lines)
        assert " ".join(file.getvalue().split()) in (sentence, f"where {sentence} {sentence}")


def test_heads_of_two_lines_are_one_line_of_a_list():
    table = FittedTable(box=None)
    table.add_column("profile")
    for head in ("heading", "worst\nheading"):
        table.add_column(head, justify="right")
    table.add_row("smoothed", "0.123456789 mm", "9.123456789 mm")
    file = io.StringIO()
    Console(file=file, width=32).print(table)
    assert [line.split() for line in file.getvalue().splitlines()[1:]] == [
        ["heading", "0.123456789", "mm"],
        ["worst", "heading", "9.123456789", "mm"],
    ]
