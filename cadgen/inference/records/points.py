"""Points of a path from a file: rows of numbers in CSV or TXT, or the corners of a polyline in DXF."""

import logging
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from math import dist, isfinite
from pathlib import Path
from typing import Any, NamedTuple

from cadgen.errors import FileError, brief, escaped
from cadgen.inference.records.text_table import text_of
from cadgen.inference.records.units import IDLE, TIMES, heading
from cadgen.messages import Message
from cadgen.reading import read_regular

MOST_BYTES = 32_000_000
_MOST_DXF_BYTES = 8_000_000  # a drawing is read at some 1 MB/s
_MOST_POINTS = 10_000  # of a file: as many as a design file has room for
_FARTHEST = 1e6  # mm from the origin, a kilometre: as far as the keys of a design reach
_SAME_MM = 1e-6  # below this two points are one
_WEIGHTS = ("weight", "weights", "w", "gewicht", "权重")
_SAG = 1.0  # mm, by which a chord may leave an arc of a polyline
# Millimetres of a unit by $INSUNITS of a DXF; a drawing without a unit is taken to be in mm.
_UNITS = {0: 1.0, 1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 14: 100.0}

# Of each damaged entity the library logs a line, which would stand before the sentence of `read_points`.
logging.getLogger("ezdxf").addHandler(logging.NullHandler())


@dataclass(frozen=True)
class Points:
    """Points of a path, in the order driven.

    Attributes:
        places: x and y of each, mm.
        weights: weight of each: 1 usually, more for a point that must be met closely, 0 for one that need not be.
    """

    places: tuple[tuple[float, float], ...]
    weights: tuple[float, ...]


def read_points(path: Path, layer: str | None = None, *, closed: bool = False) -> Points:
    """Read the points of a path.

    Args:
        path: file of rows `X Y [weight]` in mm, with spaces, tabs, commas or semicolons between; or a DXF with one
            polyline. A first line of words may say columns and units, such as `Y [m], X [m]` or `no;x;y`.
        layer: layer of the polyline, if the DXF has several.
        closed: whether the path is closed, and so the polyline.

    Raises:
        FileError: no such file, a row that is no point, a column or unit that is not understood, a drawing that is
            damaged, not exactly one polyline, or more points than a design has room for.
    """
    name = escaped(path.name)
    is_dxf = path.suffix.lower() == ".dxf"
    try:
        content = read_regular(path, _MOST_DXF_BYTES if is_dxf else MOST_BYTES)
    except FileNotFoundError:
        raise FileError("there is no file {name}: correct the path", name=name) from None
    except IsADirectoryError:
        raise FileError("{name} is a folder: give a file of points in it", name=brief(str(path))) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise FileError(
            "{name} cannot be read ({reason}): give a file of points, or a DXF", name=name, reason=reason
        ) from None
    if is_dxf:
        from io import BytesIO

        from ezdxf import recover

        with _damage_named(name):
            drawing, _ = recover.read(BytesIO(content))
            return _only_polyline(drawing, name, layer, closed)
    if layer is not None:
        raise FileError("{name} has no layers, which only a DXF has: remove --layer", name=name)
    text, _ = text_of(content, name, lambda text: 0)
    return _rows(text, name)


def _rows(text: str, name: str) -> Points:
    places: list[tuple[float, float]] = []
    weights: list[float] = []
    order: _Order | None = None
    for number, line in enumerate(text.replace("，", ",").replace("；", ";").splitlines(), 1):
        content = line.partition("#")[0].strip()
        if not content:
            order = order or (_of_remark(line.strip("# "), name) if line.startswith("#") and not places else None)
            continue
        if not places and not _numbers(content) and (order is None or order.of_remark):
            order = _order(content, name)
            continue
        values = _values(content, order or _Order())
        if len(values) not in (2, 3) or not all(map(isfinite, values)) or (len(values) == 3 and values[2] < 0):
            raise FileError(
                "{name}, line {line}: `{text}` is no point: write x and y in mm, and a weight of 0 or more if you "
                "want one",
                name=name,
                line=number,
                text=escaped(line.strip()[:60]),
            )
        if (far := max(map(abs, values[:2]))) > _FARTHEST:
            raise FileError(
                "{name}, line {line}: the point lies {far:.3g} mm from the origin, and {most:.3g} mm are the most: "
                "write x and y in mm, or their unit above them, such as x [um], y [um]",
                name=name,
                line=number,
                far=far,
                most=_FARTHEST,
            )
        if len(places) == _MOST_POINTS:
            raise _too_many(name)
        places.append((values[0], values[1]))
        weights.append(values[2] if len(values) == 3 else 1.0)
    return _distinct(_enough(Points(tuple(places), tuple(weights)), name), name)


def _numbers(content: str) -> list[float]:
    """Numbers of a row; none if it has other cells. Where commas do not set columns apart, decimals may have them."""
    marks = [mark for mark in (";", "\t", "|", ",") if mark in content][:1]
    for mark in (*marks, None):
        cells = [cell.strip() for cell in content.split(mark)]
        while len(cells) > 1 and not cells[-1]:
            cells.pop()
        try:
            return [float(cell if mark == "," else cell.replace(",", ".")) for cell in cells]
        except ValueError:
            continue
    return []


class _Order(NamedTuple):
    """Columns of x, y and the weight, and what numbers of x and y are to be multiplied by to be in mm.

    The weight is None where there is none; `columns` is their number, None where it is not known.
    """

    x: int = 0
    y: int = 1
    x_factor: float = 1.0
    y_factor: float = 1.0
    weight: int | None = 2
    columns: int | None = None
    of_remark: bool = False


def _values(content: str, order: _Order) -> list[float]:
    """Values x and y in mm, and a weight if there is one; none where the cells do not fit the columns."""
    cells = _numbers(content)
    if not max(order.x, order.y) < len(cells) <= (order.columns or 3):
        return []
    values = [cells[order.x] * order.x_factor, cells[order.y] * order.y_factor]
    return [*values, cells[order.weight]] if order.weight is not None and order.weight < len(cells) else values


def _order(header: str, name: str) -> _Order:
    """Columns and units by a header such as `Y [m], X [m]` or `no;x;y;weight`; x before y where it does not say.

    Raises:
        FileError: a unit that is none of length or stands at one column alone, or a column beside x and y that may
            not be passed over.
    """
    columns = _columns(header)
    names = [heading(column) for column in columns]
    quantities = [column.quantity for column in names]
    named = quantities.count("x") == quantities.count("y") == 1
    x, y = (quantities.index("x"), quantities.index("y")) if named else (0, 1)
    if max(x, y) >= len(names):
        return _Order()
    factors = [names[place].factor("mm") for place in (x, y)]
    for place, factor in zip((x, y), factors, strict=True):
        if factor is None:
            raise FileError(
                "{name}: `{unit}` is no unit of length that is known: write mm, cm, m or in there, and points in it",
                name=name,
                unit=escaped(names[place].unit[:60]),
            )
    if factors[0] != factors[1] and not (names[x].unit and names[y].unit):
        raise FileError(
            "{name}: the unit {unit} stands at one of the two columns alone: write one at both, such as x [m], y [m]",
            name=name,
            unit=escaped((names[x].unit or names[y].unit)[:60]),
        )
    weight = next((n for n, quantity in enumerate(quantities) if quantity in _WEIGHTS), None)
    if not named:
        return _Order(x_factor=factors[0] or 1.0, y_factor=factors[1] or 1.0)
    for place, quantity in enumerate(quantities):
        if place not in (x, y, weight) and quantity not in (*IDLE, *TIMES):
            raise FileError(
                "{name}: the column {column} beside x and y is not understood: take it out, or call it weight",
                name=name,
                column=escaped(columns[place].strip()[:60]),
            )
    return _Order(x, y, factors[0] or 1.0, factors[1] or 1.0, weight, len(names))


def _columns(header: str) -> list[str]:
    """Names of columns in a line."""
    text = re.sub(r"[\[(](weight|Gewicht|权重)[\])]", r"\1", header, flags=re.IGNORECASE)
    if re.search(r"[,;\t|]", text):
        return re.split(r"[,;\t|]", text)
    return re.sub(r"\s+(?=[\[(])", "", text).split()


def _of_remark(remark: str, name: str) -> _Order | None:
    """Columns and units by a remark that names x and y, as programs write them; None by any other.

    Raises:
        FileError: it says another order or unit than x before y in mm, and has what is not understood.
    """
    try:
        order = _order(remark, name)
    except FileError:
        columns = [heading(column) for column in _columns(remark)]
        quantities = [column.quantity for column in columns]
        units = {column.factor("mm") for column in columns if column.quantity in ("x", "y")} - {None, 1.0}
        if quantities.count("x") == quantities.count("y") == 1 and (units or quantities[:2] != ["x", "y"]):
            raise
        return None
    names = {heading(column).quantity for column in re.split(r"[,;\t|\s]+", remark)}
    return order._replace(of_remark=True) if {"x", "y"} <= names else None


def _enough(points: Points, name: str) -> Points:
    count = len(points.places)
    if count == 1:
        raise FileError("{name} has one point; a path needs at least 4: add more", name=name)
    if count < 4:
        raise FileError("{name} has {count} points; a path needs at least 4: add more", name=name, count=count)
    return points


def _distinct(points: Points, name: str) -> Points:
    """The points, of which no two neighbours are the same: a path through both would stand still."""
    for number, (one, other) in enumerate(pairwise(points.places), start=1):
        if dist(one, other) < _SAME_MM:
            raise FileError(
                "{name}: points {first} and {second} are both ({x:g}, {y:g}): remove one of them",
                name=name,
                first=number,
                second=number + 1,
                x=one[0],
                y=one[1],
            )
    return points


def _too_many(name: str) -> FileError:
    return FileError(
        "{name} has more than {most} points, which no design has room for: give fewer", name=name, most=_MOST_POINTS
    )


@contextmanager
def _damage_named(name: str) -> Iterator[None]:
    """Refuse a drawing that the library fails on, with whatever error: a damaged file makes it raise any."""
    try:
        yield
    except FileError:
        raise
    except Exception as error:
        raise FileError(
            "{name} is no DXF that can be read ({error}): save it again", name=name, error=escaped(str(error)[:80])
        ) from None


def _only_polyline(drawing: Any, name: str, layer: str | None, closed: bool) -> Points:
    unit = drawing.header.get("$INSUNITS", 0)
    if unit not in _UNITS:
        raise FileError(
            "{name} is in a unit that is not known ($INSUNITS {unit}): draw it in mm, cm, m or inches",
            name=name,
            unit=unit,
        )
    every = [
        line
        for line in drawing.modelspace().query("LWPOLYLINE POLYLINE")
        if line.dxftype() == "LWPOLYLINE" or line.is_2d_polyline or line.is_3d_polyline  # a mesh is no path
    ]
    lines = [line for line in every if closed == line.is_closed]
    layers = sorted({line.dxf.layer for line in lines})
    if layer is not None:
        lines = [line for line in lines if line.dxf.layer == layer]
    if len(lines) != 1:
        where = "" if layer is None else Message(" on layer {layer}", layer=escaped(layer))
        names, kind = (
            ", ".join(map(escaped, layers)) or Message("none"),
            Message("closed") if closed else Message("open"),
        )
        if not lines and layer is None and every:
            cure = (
                Message("close it, or leave --closed out") if closed else Message("open it, or give --closed for a lap")
            )
            other = Message("open") if closed else Message("closed")
            raise FileError(
                "{name} has no {kind} polyline, but one that is {other}: {cure}",
                name=name,
                kind=kind,
                other=other,
                cure=cure,
            )
        raise FileError(
            "{name} has {count} {kind} polylines{where} (layers with one: {names}); the path must be one: join its "
            "parts, or name its layer with --layer",
            name=name,
            count=len(lines),
            kind=kind,
            where=where,
            names=names,
        )
    return _distinct(_enough(_corners(lines[0], _UNITS[unit], name), name), name)


def _corners(line: Any, unit: float, name: str) -> Points:
    """Corners of a polyline and points on its arcs; repeated points once.

    Args:
        line: polyline of a drawing.
        unit: unit of the drawing, mm.
        name: name of its file.

    Raises:
        FileError: a corner or an arc lies farther away than any path, or there are too many points.
    """
    from ezdxf.path import make_path

    path = make_path(line)
    # Checked before arcs are followed: a bulge without bound would make points without end.
    reaches = (point.magnitude * unit for point in path.control_vertices())
    if (far := next((reach for reach in reaches if not reach <= _FARTHEST), None)) is not None:
        raise FileError(
            "{name}: its polyline reaches {reach:.3g} mm from the origin, farther than any path: correct its corners "
            "and the bulges of its arcs",
            name=name,
            reach=far,
        )
    places: list[tuple[float, float]] = []
    for point in path.flattening(_SAG / unit):
        place = point.x * unit, point.y * unit
        if places and place == places[-1]:
            continue
        if len(places) == _MOST_POINTS:
            raise _too_many(name)
        places.append(place)
    return Points(tuple(places), (1.0,) * len(places))
