"""Sheets of a car put together: two views with balloons and the list of parts, and the steps of its mounting."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from cadgen.arrays import Array
from cadgen.geometry.meshes.car_meshes import Seen
from cadgen.messages import Message, joined
from cadgen.output.drawing.sheet import (
    EDGE,
    HEIGHTS,
    LEFT,
    ROW,
    SCALES,
    SIZES,
    Closed,
    Dimension,
    DrawingSheet,
    Label,
    LineKind,
    NoteColumn,
    SheetTable,
    Stroke,
    Title,
    View,
    beside_title,
    ring,
)
from cadgen.output.drawing.sheet_files import text_length

_SIZE = "A3"
_BESIDE = 3.0  # mm on paper beside the text of a cell, with room to spare
_BALLOON, _APART = 7.0, 9.0  # mm on paper: diameter of a balloon, and distance of two in a column
_ASIDE = 21.0  # mm on paper between a view and its balloons, which dimensions need
_BETWEEN = 20.0  # mm on paper between the views
_LINES = 7  # of notes beside the title block, under the balloons
_WITHIN = 1e-3  # mm by which a covered area is made smaller, so that common edges are drawn
_SHORT = 0.05  # mm; what is left of edges and shorter is not drawn
_LIST_WIDTHS = (8.0, 8.0, 66.0, 20.0, 58.0, 14.0)


class ListedPart(NamedTuple):
    """Row of the list of parts.

    Attributes:
        number: number of its balloon.
        code: code of the part.
        title: what it is.
        quantity: how many there are.
        material: material.
        source: standard and size, or the stem of its files.
        mass: mass of all of them, g.
        drawn: whether it has a place in the car.
    """

    number: int
    code: str
    title: str
    quantity: int
    material: str
    source: str
    mass: float
    drawn: bool


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class CarView:
    """View of a car.

    Attributes:
        name: its name over it.
        seen: silhouettes of its pieces, x to the right and y up, mm.
        dimensions: dimensions in it.
        lines: further strokes, as centre lines.
    """

    name: str
    seen: tuple[Seen, ...]
    dimensions: tuple[Dimension, ...] = ()
    lines: tuple[Stroke, ...] = ()

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, lower, right and upper end, mm."""
        corners = np.concatenate([outline for each in self.seen for outline in each.rings])
        (left, low), (right, high) = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
        return left, low, right, high


class _Drawn(NamedTuple):
    """Visible lines of a view, and of each part the largest area that is seen of it, or that is hidden."""

    strokes: tuple[Stroke, ...]
    areas: dict[str, Polygon]
    hidden: dict[str, Polygon]

    def size(self, code: str) -> float:
        """Area by which a view is chosen for a part, mm²; below 0 where all of it is hidden.

        Args:
            code: code of the part.
        """
        if code in self.areas:
            return float(self.areas[code].area)
        return -1.0 / float(self.hidden[code].area) if code in self.hidden else -np.inf


def assembly_drawing(
    side: CarView, top: CarView, parts: Sequence[ListedPart], notes: Sequence[str], title: Title
) -> DrawingSheet:
    """Sheet of a car: seen from its left, and under that from above, with a balloon to every part that has a place.

    Args:
        side: view from the left, the front to the left.
        top: view from above, the front to the left.
        parts: list of parts.
        notes: sentences for the shop.
        title: title block.
    """
    width, height = SIZES[_SIZE]
    listed = sum(_LIST_WIDTHS)
    room = (width - LEFT - EDGE - listed - 6.0, height - 2 * EDGE - 8.0)
    views = (side, top)
    wide = max(view.bounds[2] - view.bounds[0] for view in views)
    tall = sum(view.bounds[3] - view.bounds[1] for view in views)
    scale = next(
        (
            each
            for each in SCALES
            if each * wide <= room[0] - 2 * _ASIDE - 2 * _BALLOON and each * tall <= room[1] - 2 * _BETWEEN - 12.0
        ),
        SCALES[-1],
    )
    left = min(view.bounds[0] for view in views)
    x = LEFT + (room[0] - scale * wide) / 2 - scale * left
    over = height - EDGE - 14.0
    drawn, drawings = {}, [_visible(view.seen) for view in views]
    for part in parts:
        sizes = [found.size(part.code) for found in drawings]
        if part.drawn:
            drawn[part.code] = sizes.index(max(sizes))
    made: list[View] = []
    under = (inf, inf)  # greatest heights of the balloons to the left and right, below those of the view above
    for number, (view, found) in enumerate(zip(views, drawings, strict=True)):
        y = over - scale * view.bounds[3]
        over = y + scale * view.bounds[1] - _BETWEEN
        numbers = {part.code: part.number for part in parts if drawn.get(part.code) == number}
        ceilings = (under[0] - y) / scale, (under[1] - y) / scale
        balloons, labels, lowest = _balloons(view, found, numbers, scale, ceilings)
        under = y + scale * lowest[0] - _APART, y + scale * lowest[1] - _APART
        heading = Label(
            text=view.name, at=((view.bounds[0] + view.bounds[2]) / 2, view.bounds[3] + 5.0 / scale), height=3.5
        )
        made.append(
            View(
                place=(x, y),
                curves=(*found.strokes, *view.lines, *balloons),
                dimensions=view.dimensions,
                labels=(heading, *labels),
            )
        )
    heads = Message("no."), Message("qty"), Message("part"), Message("material"), Message("standard or files")
    rows: list[tuple[str, ...]] = [(*heads, Message("mass, g"))]
    rows += [
        (
            str(part.number),
            str(part.quantity),
            part.title,
            part.material,
            part.source,
            f"{part.mass:.1f}" if part.mass else "",
        )
        for part in parts
    ]
    at = (width - EDGE - listed, height - EDGE - 2.0)
    table = SheetTable(title=Message("list of parts"), at=at, widths=_LIST_WIDTHS, rows=tuple(rows))
    low = at[1] - table.height - 3.0
    column = NoteColumn(at=(at[0], low), width=listed, height=low - EDGE - title.height - 2.0)
    # Under a long list there is no room: notes then stand beside the title block.
    beside = replace(beside_title(_SIZE), at=(LEFT + 3.0, EDGE + _LINES * ROW), height=_LINES * ROW)
    return DrawingSheet(
        size=_SIZE,
        scale=scale,
        title=title,
        views=tuple(made),
        tables=(table,),
        notes=tuple(notes),
        columns=(column, beside),
    )


def _visible(pieces: Sequence[Seen]) -> _Drawn:
    """Lines that nothing nearer covers, and the largest area that is seen of each part."""
    covered: BaseGeometry = Polygon()
    strokes: list[Stroke] = []
    areas: dict[str, Polygon] = {}
    hidden: dict[str, Polygon] = {}
    for piece in sorted(pieces, key=lambda each: -each.near):
        region = _region(piece.rings)
        edges = region.boundary.difference(covered.buffer(-_WITHIN))
        for line in shapely.get_parts(shapely.line_merge(edges)) if not edges.is_empty else ():
            if line.length > _SHORT:
                strokes.append(Stroke(np.asarray(line.coords)))
        for area in shapely.get_parts(region.difference(covered)):
            if area.geom_type == "Polygon" and area.area > (areas[piece.code].area if piece.code in areas else 0.0):
                areas[piece.code] = area
        for area in shapely.get_parts(region):
            if area.area > (hidden[piece.code].area if piece.code in hidden else 0.0):
                hidden[piece.code] = area
        covered = covered.union(region)
    return _Drawn(tuple(strokes), areas, hidden)


def _region(rings: Sequence[Array]) -> BaseGeometry:
    region: BaseGeometry = Polygon()
    for outline in rings:
        region = region.symmetric_difference(Polygon(outline).buffer(0))
    return region if isinstance(region, MultiPolygon | Polygon) else Polygon()


def _balloons(
    view: CarView, found: _Drawn, numbers: Mapping[str, int], scale: float, ceilings: tuple[float, float]
) -> tuple[list[Closed | Stroke], list[Label], tuple[float, float]]:
    """Balloons in a column on either side of a view, with leaders that end on their parts, broken to hidden ones.

    Args:
        view: view.
        found: what is seen in it.
        numbers: number of each part that has its balloon here.
        scale: mm on paper for a mm of the car.
        ceilings: greatest heights of the left and right column, mm.

    Returns: curves and labels, and the least heights of both columns.
    """
    left, low, right, high = view.bounds
    places = {code: (found.hidden | found.areas)[code].representative_point() for code in numbers}
    middle = float(np.median([place.x for place in places.values()])) if places else 0.0
    curves: list[Closed | Stroke] = []
    labels: list[Label] = []
    lowest = []
    for column, side, ceiling in zip((left - _ASIDE / scale, right + _ASIDE / scale), (-1, 1), ceilings, strict=True):
        own = [code for code, place in places.items() if (place.x < middle) == (side < 0)]
        own.sort(key=lambda code: places[code].y)
        step, wanted = _APART / scale, np.array([places[code].y for code in own])
        heights = _spread(wanted, step, (low, high))
        heights = heights - max(heights.max(initial=-inf) - ceiling, 0.0)
        lowest.append(float(heights.min(initial=inf)))
        for code, y in zip(own, heights.tolist(), strict=True):
            start, end = np.array([places[code].x, places[code].y]), np.array([column, y])
            way = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
            line = LineKind.THIN if code in found.areas else LineKind.HIDDEN
            curves.append(Stroke(np.array([start, end - _BALLOON / 2 / scale * way]), line))
            curves.append(ring(0.8 / scale, LineKind.THIN, (float(start[0]), float(start[1]))))
            curves.append(ring(_BALLOON / scale, LineKind.THIN, (column, y)))
            labels.append(Label(text=str(numbers[code]), at=(column, y)))
    return curves, labels, (lowest[0], lowest[1])


def _spread(wanted: Array, step: float, ends: tuple[float, float]) -> Array:
    """Heights in the order of those wanted, a step apart at least, and about the middle between the ends if crowded."""
    if not len(wanted):
        return wanted
    number = np.arange(len(wanted))
    lowest = np.maximum.accumulate(wanted - step * number) + step * number
    highest = np.minimum.accumulate((wanted - step * number)[::-1])[::-1] + step * number
    found: Array = (lowest + highest) / 2
    found = np.maximum.accumulate(found - step * number) + step * number
    room, needed = ends[1] - ends[0], step * (len(wanted) - 1)
    if found[-1] - found[0] < room or needed < room:
        found = found - max(found[-1] - ends[1], 0.0)
        found = found + max(ends[0] - found[0], 0.0)
    return found


class MountingStep(NamedTuple):
    """Step of mounting a part on a shaft.

    Attributes:
        part: what is mounted.
        way: from which side it is put on.
        place: where it stands.
        remark: key, face, and what holds it.
    """

    part: str
    way: str
    place: str
    remark: str


class ShaftMounting(NamedTuple):
    """Steps of mounting of a shaft.

    Attributes:
        title: name of the shaft.
        steps: steps in their order.
    """

    title: str
    steps: tuple[MountingStep, ...]


_STEP_WIDTHS = (7.0, 52.0, 26.0, 40.0, 82.0)
_LOOSE_WIDTHS = (7.0, 66.0, 10.0, 124.0)


def mounting_sheet(
    shafts: Sequence[ShaftMounting], loose: Sequence[tuple[str, ...]], notes: Sequence[str], title: Title
) -> DrawingSheet:
    """Sheet of the steps of mounting: a table for each shaft, one of small parts, and sentences on the whole.

    Args:
        shafts: steps of each shaft, in the order in which they are mounted.
        loose: number in the list, name, quantity and place of parts that no view shows.
        notes: further steps, as sentences.
        title: title block.
    """
    width, height = SIZES[_SIZE]
    wide, top = sum(_STEP_WIDTHS), height - EDGE - 3.0
    tables, y, number = [], top, 0
    for shaft in shafts:
        rows: list[tuple[str, ...]] = [("", Message("part"), Message("put on"), Message("place"), Message("how"))]
        for step in shaft.steps:
            number += 1
            rows += _folded((str(number), step.part, step.way, step.place, step.remark), _STEP_WIDTHS[-1])
        tables.append(SheetTable(title=shaft.title, at=(LEFT + 3.0, y), widths=_STEP_WIDTHS, rows=tuple(rows)))
        y -= tables[-1].height + 0.8 * ROW
    heads = Message("no."), Message("part"), Message("qty"), Message("where it belongs")
    belong = Message("parts that no view shows, by their numbers in the list")
    small = [line for row in loose for line in _folded(row, _LOOSE_WIDTHS[-1])]
    tables.append(SheetTable(title=belong, at=(LEFT + 3.0, y), widths=_LOOSE_WIDTHS, rows=(heads, *small)))
    left = LEFT + 3.0 + wide + 6.0
    column = NoteColumn(at=(left, top), width=width - EDGE - left - 2.0, height=top - EDGE - title.height - 4.0)
    return DrawingSheet(
        size=_SIZE, scale=1.0, title=title, views=(), tables=tuple(tables), notes=tuple(notes), columns=(column,)
    )


def _folded(row: tuple[str, ...], width: float) -> Iterator[tuple[str, ...]]:
    """Row of a table, and further ones for what the last cell lists beyond its width (mm) in the least letters."""
    *cells, last = row
    lines: list[list[str]] = [[]]
    for part in getattr(last, "parts", (last,)):
        # With what stands beside a text in its cell.
        if lines[-1] and HEIGHTS[-1] * text_length(joined([*lines[-1], part])) > width - _BESIDE:
            lines.append([])
        lines[-1].append(part)
    for number, line in enumerate(lines):
        yield *(cells if not number else [""] * len(cells)), line[0] if len(line) == 1 else joined(line)
