"""Figures and sheets of them: one model of results for terminal, page, printed sheets, files and JSON.

What is shown is put together once, as figures, cells and sheets. A renderer only lays it out: `cadgen.output.report`
on a terminal and as text, `cadgen.viewer.page` as HTML, `as_json` as JSON. The module is light to import.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from enum import StrEnum
from math import isfinite
from typing import TYPE_CHECKING, Any

from cadgen.errors import DesignError, brief

if TYPE_CHECKING:
    from pandas import DataFrame

# End of a figure's key by its unit.
_SUFFIX = {"°": "deg", "µm": "um", "%": "percent", "N·mm": "Nmm"}


class Emphasis(StrEnum):
    """Emphasis of a cell."""

    PLAIN = ""
    GOOD = "good"
    BAD = "bad"
    STRONG = "strong"
    MUTED = "muted"


@dataclass(frozen=True)
class Figure:
    """Number with its unit.

    Attributes:
        code: name of the figure for programs, without unit.
        name: name for people.
        value: number in `unit`; None where there is none.
        unit: unit, such as `mm` or `°`; empty for a ratio.
    """

    code: str
    name: str
    value: float | None
    unit: str = ""

    @property
    def key(self) -> str:
        """Key in JSON and manifests: the code with the unit at its end, such as `end_heading_deg`."""
        unit = _SUFFIX.get(self.unit, self.unit)
        return f"{self.code}_{unit}" if unit and unit not in self.code.split("_") else self.code

    def text(self, form: str = "") -> str:
        """Number with its unit as text; empty without a number.

        Args:
            form: format of the number, as of `format`; rounded by its size if left out.
        """
        if self.value is None:
            return ""
        return with_unit(format(self.value, form) if form else rounded(self.value), self.unit)

    def cell(self, state: Emphasis = Emphasis.PLAIN, digits: int | None = None) -> "Cell":
        """Cell of the figure.

        Args:
            state: emphasis.
            digits: decimals; by the size of the number if left out.
        """
        return number(self.value, self.unit, state, digits)


class Figures(dict[str, Figure]):
    """Figures of one thing by their codes, in the order in which JSON has them."""

    def __init__(self, *figures: Figure) -> None:
        super().__init__((figure.code, figure) for figure in figures)

    def value(self, code: str) -> float | None:
        """Value of a figure; None without such a figure."""
        return self[code].value if code in self else None

    def facts(self) -> dict[str, float | None]:
        """Figures as plain values by their keys, for JSON and manifests."""
        return {figure.key: figure.value for figure in self.values()}


class Facts:
    """Named values of a result on their way to JSON, in its order. They are not read by key: ask the result itself.

    A value is a number, a text, a dataclass, figures, further facts, or a list or mapping of these; see `as_json`.

    Example:
        >>> (Facts(design="car", ends_mm=(1.0, 2.0)) | Facts(passed=True)).json()
        {'design': 'car', 'ends_mm': [1.0, 2.0], 'passed': True}
    """

    __slots__ = ("_values",)

    def __init__(self, /, **values: object) -> None:
        self._values = values

    def __or__(self, more: "Facts | Figures") -> "Facts":
        """Facts followed by others; of one key the latter counts, in the place of the former."""
        return Facts(**{**self._values, **(more._values if isinstance(more, Facts) else more.facts())})

    def json(self) -> dict[str, Any]:
        """Plain values by their keys."""
        return {key: as_json(value) for key, value in self._values.items()}


class JobResult(ABC):
    """Base of a result of a job, whose figures all go into JSON and manifests."""

    @abstractmethod
    def entry(self) -> Facts:
        """Facts of the result, as in its entry of the manifest; keys end in the unit."""

    def facts(self) -> dict[str, Any]:
        """The result as plain values, as in the manifest and with `--json`; keys end in the unit."""
        return self.entry().json()

    @property
    def tables(self) -> tuple[str, ...]:
        """Names of the tables among the facts, as `to_pandas` takes them."""
        return tuple(_tables(self.facts()))

    def to_pandas(self, table: str = "") -> "DataFrame":
        """Facts as a pandas frame; keys inside keys become columns such as `play.mean_deg`.

        Args:
            table: one of `tables`, with a row for each of its items; left out, one row of all that is no table.

        Raises:
            DesignError: pandas is not installed, or there is no such table.
        """
        facts = self.facts()
        found = _tables(facts)
        if table and table not in found:
            raise DesignError(
                "there is no table {table}; there are: {tables}",
                table=brief(repr(table), 60),
                tables=", ".join(found) or "–",
            )
        return frame_of(found[table] if table else [{key: facts[key] for key in facts if key not in found}])


def frame_of(rows: Sequence[Mapping[str, Any]]) -> "DataFrame":
    """Pandas frame of rows of plain values; keys inside keys become columns such as `play.mean_deg`.

    Args:
        rows: rows by their keys.

    Raises:
        DesignError: pandas is not installed.
    """
    try:
        from pandas import json_normalize
    except ModuleNotFoundError as error:
        if error.name != "pandas":
            raise
        raise DesignError(
            "a frame needs pandas, which is not installed: pip install '.[notebook]' in cadgen's folder installs it"
        ) from None
    return json_normalize(list(rows))


def html_table(rows: Iterable[Iterable[str]]) -> str:
    """Table for a notebook.

    Args:
        rows: cells of each row, as plain text.
    """
    from html import escape

    cells = ("".join(f"<td>{escape(cell)}</td>" for cell in row) for row in rows)
    return f"<table>{''.join(f'<tr>{row}</tr>' for row in cells)}</table>"


def _tables(facts: Mapping[str, Any]) -> dict[str, list[Mapping[str, Any]]]:
    """Lists of mappings among plain values."""
    lists = {key: value for key, value in facts.items() if isinstance(value, list) and value}
    return {key: value for key, value in lists.items() if all(isinstance(row, Mapping) for row in value)}


def as_json(value: object) -> Any:
    """Plain value for JSON: facts, figures and dataclasses become mappings, sequences and arrays lists.

    A number that is not finite becomes None, for JSON has no such numbers. Texts stay what they are, so that a message
    can still be said in another language.

    Raises:
        TypeError: the value is of another kind.
    """
    if value is None or isinstance(value, str | int):
        return value
    if isinstance(value, float):
        return float(value) if isfinite(value) else None
    if isinstance(value, Facts):
        return value.json()
    if isinstance(value, Figures):
        return value.facts()
    if isinstance(value, Mapping):
        return {key: as_json(inside) for key, inside in value.items()}
    if isinstance(value, list | tuple):
        return [as_json(inside) for inside in value]
    if is_dataclass(value):
        return {field.name: as_json(getattr(value, field.name)) for field in fields(value)}
    if hasattr(value, "tolist"):  # an array, or a number of numpy
        return as_json(value.tolist())
    raise TypeError(f"{type(value).__name__} is no plain value")


def with_unit(text: str, unit: str) -> str:
    """Number as text with its unit behind it: `3.2 mm`, `3.2°`."""
    return f"{text}{'' if unit == '°' else ' '}{unit}".rstrip()


_THOUSANDTH, _MILLIONTH = 1e-3, 1e-6


def rounded(value: float, digits: int | None = None) -> str:
    """Number as text: to three decimals, a small one to the millionth, and one smaller than that by its power of ten.

    Args:
        value: number to show.
        digits: digits after the point; chosen by its size if left out.
    """
    if not isfinite(value):
        return "–"
    if digits is not None:
        return f"{value:.{digits}f}"
    if 0 < abs(value) < _MILLIONTH:
        return f"{value:.3g}"
    return f"{value:.{3 if abs(value) >= _THOUSANDTH else 6}f}".rstrip("0").rstrip(".")


@dataclass(frozen=True)
class Cell:
    """Cell of a sheet.

    Attributes:
        text: shown text; for a number, the number as it is rounded, without unit.
        value: number of the cell in full, None for words.
        unit: unit of the number.
        state: emphasis.
    """

    text: str
    value: float | None = None
    unit: str = ""
    state: Emphasis = Emphasis.PLAIN


def number(value: float | None, unit: str = "", state: Emphasis = Emphasis.PLAIN, digits: int | None = None) -> Cell:
    """Cell of a number, rounded as the commands round it; of a dash for None.

    Args:
        value: number, in its unit.
        unit: unit.
        state: emphasis.
        digits: decimals; by the size of the number if left out.
    """
    if value is None:
        return Cell("–", None, "", state or Emphasis.MUTED)
    return Cell(rounded(value, digits), float(value), unit, state)


@dataclass(frozen=True)
class Sheet:
    """Table of figures and texts.

    Attributes:
        code: name of the sheet for programs.
        title: title for people; empty if it has none.
        heads: heads of the columns.
        rows: cells by row; a text stands for a cell of words.
        words: number of columns from the left that hold words; the others hold numbers.
        tail: number of columns from the right that hold words again.
    """

    code: str
    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[Cell | str, ...], ...]
    words: int = 1
    tail: int = 0

    def numeric(self, place: int) -> bool:
        """Whether a column holds numbers, by its place from the left, from 0."""
        return self.words <= place < len(self.heads) - self.tail

    @property
    def cells(self) -> tuple[tuple[Cell, ...], ...]:
        """Rows with texts as cells of words."""
        return tuple(tuple(Cell(cell) if isinstance(cell, str) else cell for cell in row) for row in self.rows)
