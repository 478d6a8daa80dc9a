"""Numbers of cells as people write them: other decimal marks, thousands set apart, units behind, degrees and minutes.

A column is read by one rule, and the decimal mark is that of the whole table. Where a mark may stand for two things,
the table is refused.
"""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from cadgen.errors import FileError, brief
from cadgen.inference.records.table_rows import TableRows
from cadgen.inference.records.units import MISSING, heading, unit_of
from cadgen.messages import Message

Column = tuple[str, ...]
_SIGN = r"[+-]?"
_POINT = re.compile(rf"{_SIGN}(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_COMMA = re.compile(rf"{_SIGN}(\d+,\d*|,\d+)([eE][+-]?\d+)?")
_GROUPS = re.compile(rf"{_SIGN}\d{{1,3}}(,\d{{3}})+")
_APART = re.compile(rf"{_SIGN}\d{{1,3}}([ \u00a0\u202f\u2009'’]\d{{3}})+([.,]\d*)?")
# Both marks in one cell: the last is the decimal mark.
_DECIMAL_COMMA = re.compile(rf"{_SIGN}\d{{1,3}}(\.\d{{3}})+,\d*")
_DECIMAL_POINT = re.compile(rf"{_SIGN}\d{{1,3}}(,\d{{3}})+\.\d*")
_POINT_GROUPS = re.compile(rf"{_SIGN}[1-9]\d{{0,2}}(\.\d{{3}})+(,\d*)?")
_COMMA_GROUPS = re.compile(rf"{_SIGN}\d{{1,3}}(,\d{{3}})+(\.\d*)?")
_ANGLE = re.compile(rf"({_SIGN})(\d+)\s*°\s*(?:(\d+(?:[.,]\d*)?)\s*['′’]\s*(?:(\d+(?:[.,]\d*)?)\s*(?:\"|″|''|”)?)?)?")
_COLONS = re.compile(rf"({_SIGN})(\d+):([0-5]?\d):([0-5]?\d(?:[.,]\d*)?)")
_SIXTY = 60.0  # minutes of a degree; rounding writes 59'60"
_BY_COLONS = ("dms", "d:m:s", "d m s", "°'\"", "° ' \"")
_WITH_UNIT = re.compile(r"([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*([^\d\s.,+-].*)")


def plain_numbers(table: TableRows, name: str) -> TableRows:
    """Table whose numbers have decimal points and no unit, which its names have.

    Args:
        table: rows of a table.
        name: of the file, for messages.

    Raises:
        FileError: commas or points that may set thousands apart or be decimal marks.
    """
    called, plain, notes = list(table.names), list(table.columns), list[Message]()
    for column in plain:
        _refuse_thousands_by_points(column, name)
    odd = [k for k, column in enumerate(plain) if not all(map(_POINT.fullmatch, column))]
    if not odd:
        return table
    for k in odd:
        plain[k] = tuple(_tidy(cell) for cell in plain[k])
        if of_angle := _angles(called[k], plain[k]):
            called[k], plain[k] = of_angle
            notes.append(Message("{column} is read in degrees, minutes and seconds", column=brief(table.names[k])))
        elif with_unit := _without_unit(called[k], plain[k], name):
            called[k], plain[k] = with_unit
    decimal, marked = _decimal_marks(plain, name)
    if marked:
        plain = [tuple(map(decimal, column)) for column in plain]
    return replace(table, names=tuple(called), columns=tuple(plain)).noted(*notes, *marked)


def _tidy(cell: str) -> str:
    """Cell with a plain minus, and without blanks or apostrophes that set thousands apart."""
    cell = cell.strip("\u00a0\u202f ")
    if cell[:1] in "−–" and len(cell) > 1:
        cell = "-" + cell[1:].lstrip()
    return re.sub(r"[ \u00a0\u202f\u2009'’]", "", cell) if _APART.fullmatch(cell) else cell


def _angles(name: str, column: Column) -> tuple[str, Column] | None:
    """Column of angles such as 12°30'15" in degrees; None if it is none."""
    has = heading(name)
    colons = has.unit.lower() in _BY_COLONS or ("angle" in has.quantity and not has.unit)
    pattern = _COLONS if colons and any(map(_COLONS.fullmatch, column)) else _ANGLE
    found = [None if cell.lower() in MISSING else pattern.fullmatch(cell) or cell for cell in column]
    matches = [match for match in found if match is not None]
    if any(isinstance(match, str) for match in matches) or not any(match[3] for match in matches):
        return None
    if has.unit and has.unit.lower() not in _BY_COLONS and has.factor("deg") != 1.0:
        return None

    def parts(match: re.Match[str]) -> list[float]:
        return [float((part or "0").replace(",", ".")) for part in match.groups()[1:]]

    def degrees(match: re.Match[str] | str | None) -> str:
        if match is None or isinstance(match, str):
            return ""
        whole, minutes, seconds = parts(match)
        return repr((-1.0 if match[1] == "-" else 1.0) * (whole + minutes / 60 + seconds / 3600))

    if any(part > _SIXTY for match in matches if isinstance(match, re.Match) for part in parts(match)[1:]):
        return None
    if not has.unit or has.factor("deg") is None:
        name = re.sub(r"\s*[\[(][^\[\]()]*[\])]\s*$", "", name) + " [deg]"
    return name, tuple(degrees(match) for match in found)


def _without_unit(name: str, column: Column, file: str) -> tuple[str, Column] | None:
    """Column without the unit that stands in every cell, and its name with it; None if there is none.

    Raises:
        FileError: the name has another unit than the cells.
    """
    present = [cell for cell in column if cell.lower() not in MISSING]
    matches = [_WITH_UNIT.fullmatch(cell) for cell in present]
    units = {match[2] for match in matches if match}
    if not present or not all(matches) or len(units) != 1 or not (meant := unit_of(unit := units.pop())):
        return None
    has = heading(name)
    if has.unit and unit_of(has.unit) != meant:
        raise FileError(
            "{file}: the column {column} is named in another unit than its cells, {unit}: keep one of them",
            file=file,
            column=brief(name),
            unit=brief(unit),
        )
    numbers = ("" if cell.lower() in MISSING else re.sub(_WITH_UNIT, r"\1", cell) for cell in column)
    return (name if has.unit else f"{name} [{unit}]"), tuple(numbers)


def _decimal_marks(columns: Sequence[Column], name: str) -> tuple[Callable[[str], str], list[Message]]:
    """Rule that brings a cell to a decimal point, and what was understood.

    Raises:
        FileError: marks that may set thousands apart or be decimal marks.
    """
    cells = [cell for column in columns for cell in column]
    comma = next((cell for cell in cells if _DECIMAL_COMMA.fullmatch(cell)), None)
    point = next((cell for cell in cells if _DECIMAL_POINT.fullmatch(cell)), None)
    if comma and point:
        raise _unclear(name, comma)
    if comma:
        for cell in cells:
            if "." in cell and _POINT.fullmatch(cell) and not _POINT_GROUPS.fullmatch(cell):
                raise _unclear(name, cell)
        return _grouped_by_points, [Message("it has decimal commas, and points that set thousands apart")]
    if point:
        for cell in cells:
            if _COMMA.fullmatch(cell) and not _COMMA_GROUPS.fullmatch(cell):
                raise _unclear(name, cell)
        return (
            lambda cell: cell.replace(",", "") if _COMMA_GROUPS.fullmatch(cell) else cell,
            [Message("its commas set thousands apart")],
        )
    if not any(_COMMA.fullmatch(cell) for cell in cells):
        return (lambda cell: cell), []
    pointed = any("." in cell and _POINT.fullmatch(cell) for cell in cells)
    for column in columns:
        # A comma may set thousands apart, as 1,250 beside 980 or 0.5 does.
        commas = [cell for cell in column if _COMMA.fullmatch(cell)]
        others = [cell for cell in column if _POINT.fullmatch(cell)]
        grouped = all(_GROUPS.fullmatch(cell) and not re.match(r"[+-]?0", cell) for cell in commas)
        if commas and (others or pointed) and (grouped or any("." in cell for cell in others)):
            raise _unclear(name, commas[0])
        # A column with other decimals, or with 0.500, has decimal points for certain.
        points = [cell for cell in others if "." in cell]
        if points and all(map(_POINT_GROUPS.fullmatch, points)):
            raise _unclear(name, points[0])
    return _of_comma, [Message("it has decimal commas")]


def _refuse_thousands_by_points(column: Column, name: str) -> None:
    """Refuse points that may set thousands apart: 990 and 1.080 in a column, where decimals would read 990.000."""
    numbers = [cell for cell in column if _POINT.fullmatch(cell)]
    points = [cell for cell in numbers if "." in cell]
    grouped = len(points) < len(numbers) and points and all(map(_POINT_GROUPS.fullmatch, points))
    if grouped and any(cell.endswith("0") for cell in points):
        raise _unclear(name, points[0])


def _of_comma(cell: str) -> str:
    return cell.replace(",", ".") if _COMMA.fullmatch(cell) else cell


def _grouped_by_points(cell: str) -> str:
    return _of_comma(cell.replace(".", "") if _POINT_GROUPS.fullmatch(cell) else cell)


def _unclear(name: str, cell: str) -> FileError:
    return FileError(
        "{name}: its commas or points may be decimal marks or set thousands apart, as in {cell}; save it with decimal "
        "points",
        name=name,
        cell=brief(cell.strip()),
    )
