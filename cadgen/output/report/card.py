"""A card of settings as a page to print on A4: plain HTML that loads nothing."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

_STYLE = """
@page { size: A4; margin: 12mm; }
body { font: 10pt/1.35 sans-serif; margin: 0; color: #000; background: #fff; }
@media screen { body { margin: 1.5em auto; max-width: 60em; padding: 0 1.5em; } }
h1 { font-size: 14pt; margin: 0 0 2mm; }
p { margin: 0 0 1mm; }
table { border-collapse: collapse; width: 100%; margin: 3mm 0; font-variant-numeric: tabular-nums; }
thead { display: table-header-group; }
tr { break-inside: avoid; }
th, td { border-bottom: 0.2mm solid #999; padding: 0.4mm 2mm; text-align: right; }
th { border-bottom: 0.5mm solid #000; vertical-align: bottom; }
td:first-child { font-weight: bold; }
tr:nth-child(5n) td { border-bottom-color: #000; }
tr.not td { text-decoration: line-through; }
tr.not td:last-child { text-decoration: none; font-weight: bold; text-align: left; }
"""


@dataclass(frozen=True)
class Column:
    """A column of a card.

    Attributes:
        key: key of its values in a row.
        name: heading.
        unit: unit; empty if there is none.
        form: format of a number.
    """

    key: str
    name: str
    unit: str
    form: str

    def cell(self, row: Mapping[str, Any]) -> str:
        """Value of a row as text."""
        value = row[self.key]
        return "" if value is None else format(value, self.form)

    @property
    def heading(self) -> str:
        """Name and unit."""
        return f"{self.name}, {self.unit}" if self.unit else self.name


def printed_card(
    title: str,
    lines: Sequence[str],
    columns: Sequence[Column],
    rows: Sequence[Mapping[str, Any]],
    legend: Sequence[str],
) -> str:
    """Text of the page.

    Args:
        title: heading of the page.
        lines: sentences above the table.
        columns: columns of the table.
        rows: a row for each spacing; `kept` says whether it may be used, and `fault` why not.
        legend: sentences below the table.
    """
    wrong = any(not row["kept"] for row in rows)
    heads = "".join(f"<th>{escape(column.heading)}</th>" for column in columns) + ("<th></th>" if wrong else "")
    body = "\n".join(_row(columns, row, wrong=wrong) for row in rows)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f"<title>{escape(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n<h1>{escape(title)}</h1>\n"
        f"{_paragraphs(lines)}<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>\n"
        f"{_paragraphs(legend)}</body>\n</html>\n"
    )


def _row(columns: Sequence[Column], row: Mapping[str, Any], *, wrong: bool) -> str:
    cells = "".join(f"<td>{escape(column.cell(row))}</td>" for column in columns)
    if not wrong:
        return f"<tr>{cells}</tr>"
    if row["kept"]:
        return f"<tr>{cells}<td></td></tr>"
    return f'<tr class="not">{cells}<td>not kept: {escape(row["fault"])}</td></tr>'


def _paragraphs(lines: Sequence[str]) -> str:
    return "".join(f"<p>{escape(line[:1].upper() + line[1:])}.</p>\n" for line in lines)
