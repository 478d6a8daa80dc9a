"""Sheets of a frame: its sheet parts with every hole from one datum, and the fork's block."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
import shapely

from cadgen.car.assembly.frame.foot_joints import SHARE
from cadgen.car.assembly.frame.fork_block import ForkBlock
from cadgen.car.assembly.panels import THREAD_END, Feature, Panel, SheetHole, rectangle
from cadgen.curves.contour import Contour
from cadgen.gears.fits import deviations
from cadgen.messages import Message
from cadgen.output.drawing.hole_frames import edge_view, hole_frames
from cadgen.output.drawing.placement import Room
from cadgen.output.drawing.section import outlines_and_hatches
from cadgen.output.drawing.shaft_fit import limited
from cadgen.output.drawing.sheet import (
    DIAMETER,
    EDGE,
    LEFT,
    SIZES,
    TEXT,
    TITLE_SIZE,
    WIDEST,
    Characteristic,
    Closed,
    DatumFeature,
    DiameterDimension,
    Dimension,
    DrawingSheet,
    Label,
    LinearDimension,
    LineKind,
    NoteColumn,
    SheetTable,
    Stroke,
    Symbol,
    Title,
    ToleranceFrame,
    View,
    beside_title,
    centre_cross,
    chosen_sheet,
    cutting_plane,
    have_room,
    length_of,
    over_title,
    ring,
    rounded,
    section_title,
    upright,
)

_GAP = 9.0  # mm on paper from the part to a dimension line, and from line to line
_WIDTHS = (11.0, 18.0, 18.0, 37.0, 58.0)  # of the columns of a sheet part's table, mm
_WITHIN_CHORD = 0.05  # mm, of outlines between which a text has room
_WITHIN = 8.0  # mm on paper, least width and height with room for a number
_LEANS = 0.1  # mm by which both ends of a leaning side are apart either way
_CAPTION = 2.6  # gaps from a section to its caption
_NUMBER = 3.0  # mm on paper from a hole to its number


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class PanelText:
    """Words on the sheet of a sheet part, besides its geometry.

    Attributes:
        notes: sentences for the shop.
        between: auxiliary dimensions: name, first and second point on the part, mm.
        zones: zones of the seats of shafts by their numbers, mm; none where no distance has a tolerance.
        thread: name of the threads in the foot.
        walls: feet of the walls that stand on the part, mm.
        thickness_share: greatest deviation of the thickness, mm; 0 where the general tolerance holds.
    """

    notes: tuple[str, ...]
    between: tuple[tuple[str, tuple[float, float], tuple[float, float]], ...] = ()
    zones: Mapping[int, float] = field(default_factory=dict)
    thread: str = ""
    walls: tuple[Contour, ...] = ()
    thickness_share: float = 0.0

    @property
    def thickness_limits(self) -> str:
        """Limits of the thickness as they follow it; empty where the general tolerance holds."""
        return f" ±{self.thickness_share:g}" if self.thickness_share else ""


def panel_drawing(panel: Panel, text: PanelText, title: Title) -> DrawingSheet:
    """Sheet of a sheet part, A4 or A3: one view, and a table of all holes, slots and tabs from the datum.

    Args:
        panel: sheet part.
        text: what it says besides.
        title: title block.
    """
    points = panel.outline.polygon(0.01)
    (left, low), (right, high) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    rows = tuple(_rows(panel, text))
    exact = frozenset(
        (row, column) for row, each in enumerate(panel.holes, 1) if _framed(each, text) for column in (1, 2)
    )
    table_width = sum(_WIDTHS)

    def table_of(size: str) -> SheetTable:
        at = (SIZES[size][0] - EDGE - table_width, SIZES[size][1] - EDGE - 2.0)
        return SheetTable(title=Message("places from 0"), at=at, widths=_WIDTHS, rows=rows, exact=exact)

    def columns_of(size: str) -> tuple[NoteColumn, ...]:
        return over_title([table_of(size)], table_width, title), beside_title(size)

    extent = (right - left, high - low)
    beside = (table_width + (90.0 if text.zones else 42.0), TITLE_SIZE[1] + 34.0)
    size, scale = chosen_sheet(extent, beside, 1.0, 2.0, lambda size: have_room(text.notes, columns_of(size)))
    gap = _GAP / scale
    room_high = SIZES[size][1] - 2 * EDGE - TITLE_SIZE[1]
    place = (
        LEFT + 26.0 - scale * left,
        EDGE + TITLE_SIZE[1] + 4.0 + (room_high - scale * extent[1]) / 2 - scale * low,
    )
    curves: list[Closed | Stroke] = [Closed(each) for each in (panel.outline, *panel.cuts, *text.walls)]
    for hole in panel.holes:
        at = (hole.u, hole.v)
        curves += [ring(hole.diameter, centre=at), *centre_cross(hole.diameter / 2 + 2.0 / scale, at)]
    for edge in panel.edge_holes:
        half = edge.diameter / 2
        corners = rectangle(edge.u - half, edge.v, edge.u + half, edge.v + edge.depth)
        curves.append(Stroke(np.vstack([corners, corners[:1]]), LineKind.HIDDEN))
    for point in ((0.0, 0.0), *(end for _, *ends in text.between for end in ends)):
        curves += centre_cross(5.0 / scale, point)
    room = Room(curves, scale)
    dimensions: list[Dimension] = [
        LinearDimension(name="length", start=(left, low), end=(right, low), at=(left, low - 2 * gap)),
        upright("height", left, (low, high), left - 1.6 * gap, scale),
    ]
    if round(left, 6):  # else the datum is the corner
        dimensions.append(_to_datum("datum along", (left, low), (left, low - gap), 0.0, scale))
    if round(low, 6):
        # On the side that is nearer; from the foot of a sheet with tabs, whose seats are at that height in all of them.
        feet, seated = [each.v + each.across / 2 for each in _tabs(panel)], _first_seat(panel) is not None
        side, out = (right, right + 0.8 * gap) if right < -left else (left, left - 0.8 * gap)
        across = _to_datum("datum across", (side, feet[0] if feet else low), (out, low), 90.0, scale)
        dimensions.append(_held(across, scale) if feet and seated else across)
    for number, (name, start, end) in enumerate(text.between):
        over = high + (0.9 + 0.9 * number) * gap
        made = LinearDimension(name=name, start=start, end=end, at=(start[0], over), prefix="(", suffix=")")
        dimensions.append(made)  # auxiliary: not of the part, but of how it is set
    for dimension in dimensions:
        room.take(dimension)
    seats = [hole for hole in panel.holes if _framed(hole, text)]
    seats.sort(key=lambda hole: hole.shaft)
    framed = [
        (f"seat of shaft {each.shaft}", (each.u, each.v), each.diameter, text.zones[each.shaft]) for each in seats
    ]
    symbols = tuple(hole_frames(framed, room))  # numbers of holes then stand where no leader is
    at_zero = max((hole.diameter / 2 for hole in panel.holes if (hole.u, hole.v) == (0.0, 0.0)), default=0.0)
    labels = [room.label("0", (0.0, 0.0), max(scale * at_zero + _NUMBER + 0.5, 5.0), 3.5)]
    labels += [
        room.label(str(number), (hole.u, hole.v), scale * hole.diameter / 2 + _NUMBER, 2.5)
        for number, hole in enumerate(panel.holes, 1)
    ]
    labels += [
        _number(room, str(number), feature, scale)
        for number, feature in enumerate(panel.features, len(panel.holes) + 1)
    ]
    before = len(panel.holes) + len(panel.features)
    labels += [
        room.label(str(number), (edge.u, edge.v), _NUMBER, TEXT, (scale * edge.diameter / 2, 0.0))
        for number, edge in enumerate(panel.edge_holes, before + 1)
    ]
    labels += [
        room.label(str(number), corner, _NUMBER, TEXT)
        for number, corner in enumerate(slanted_corners(panel), before + len(panel.edge_holes) + 1)
    ]
    if not text.zones and not text.walls:  # else a view from the side has it, or walls stand on it
        sign = f"t = {rounded(panel.thickness)}{text.thickness_limits}"
        inside = next(_thickness_places(panel, sign, scale), None)
        if inside:
            room.take(inside)
        outside = (scale * extent[0] / 2 + TEXT * WIDEST * len(sign) / 2, scale * extent[1] / 2)
        middle = ((left + right) / 2, (low + high) / 2)
        labels.append(inside or room.label(sign, middle, 2.0 * _NUMBER, TEXT, outside))
    views = [
        View(place=place, curves=tuple(curves), dimensions=tuple(dimensions), labels=tuple(labels), symbols=symbols)
    ]
    if framed:
        aside = (place[0] + scale * right + 22.0, place[1])
        seen = [(hole.v, hole.diameter) for hole in panel.holes]
        views.append(edge_view(panel.thickness, (low, high), seen, aside, scale, text.thickness_limits))
    table, columns = table_of(size), columns_of(size)
    return DrawingSheet(
        size=size, scale=scale, title=title, views=tuple(views), tables=(table,), notes=text.notes, columns=columns
    )


def _to_datum(
    name: str, corner: tuple[float, float], at: tuple[float, float], angle: float, scale: float
) -> LinearDimension:
    """Dimension from a corner of the part to the datum, its number beside the line where that is short."""
    made = LinearDimension(name=name, start=corner, end=(0.0, 0.0), at=at, angle=angle)
    return replace(made, beside=upright(name, 0.0, (0.0, length_of(made)), 0.0, scale).beside)


def _held(dimension: LinearDimension, scale: float) -> LinearDimension:
    """The upright dimension with the limits by which sheets of one frame agree, its number where there is room."""
    suffix = f" ±{SHARE:g}"
    made = upright(dimension.name, 0.0, (0.0, length_of(dimension)), 0.0, scale, suffix=suffix)
    return replace(dimension, suffix=suffix, beside=made.beside)


def _tabs(panel: Panel) -> list[Feature]:
    """Tabs of a standing sheet."""
    return [each for each in panel.features if each.pattern == panel.code]


def _first_seat(panel: Panel) -> int | None:
    """Number of the seat of a shaft at the zero of a sheet; None without one."""
    return next(
        (
            number
            for number, each in enumerate(panel.holes, 1)
            if each.fit and each.shaft and (each.u, each.v) == (0, 0)
        ),
        None,
    )


def _framed(hole: SheetHole, text: PanelText) -> bool:
    """Whether a frame holds the place of a hole."""
    return bool(hole.fit) and hole.shaft in text.zones


def _number(room: Room, number: str, feature: Feature, scale: float) -> Label:
    """Number of a slot, tab or opening: within it where it has room, else beside its outline.

    Args:
        room: room in the view.
        number: number.
        feature: what it stands for.
        scale: mm on paper for a mm of the part.
    """
    along, across = scale * feature.along, scale * feature.across
    if along > _WITHIN and across > _WITHIN:
        return room.within(number, (feature.u, feature.v), _NUMBER, (along / 2, across / 2))
    return room.label(number, (feature.u, feature.v), _NUMBER, TEXT, (along / 2, across / 2))


def _thickness_places(panel: Panel, sign: str, scale: float) -> Iterator[Label]:
    """Thickness of a sheet as `t = 6` (ISO 129-1) where material has room for it, the roomiest place first.

    Args:
        panel: sheet part.
        sign: thickness as it is written.
        scale: mm on paper for a mm of the part.
    """
    across = TEXT * WIDEST * len(sign) / scale
    solid = shapely.Polygon(panel.outline.polygon(_WITHIN_CHORD))
    open_areas = [shapely.Polygon(cut.polygon(_WITHIN_CHORD)) for cut in panel.cuts]
    open_areas += [shapely.Point(hole.u, hole.v).buffer(hole.diameter / 2 + 5.0 / scale) for hole in panel.holes]
    open_areas += [
        shapely.box(edge.u - edge.diameter, edge.v, edge.u + edge.diameter, edge.v + edge.depth)
        for edge in panel.edge_holes
    ]
    area = solid.difference(shapely.union_all(open_areas)).buffer(-TEXT / scale)
    left, low, right, high = area.bounds
    grid = [(x, y) for y in np.linspace(low, high, 25).tolist() for x in np.linspace(left, right, 25).tolist()]
    texts = [shapely.LineString([(x - across / 2, y), (x + across / 2, y)]) for x, y in grid]
    clear = [
        (area.boundary.distance(line), place) for line, place in zip(texts, grid, strict=True) if area.contains(line)
    ]
    for _, place in sorted(clear, reverse=True)[:1]:
        yield Label(text=sign, at=place)


def _rows(panel: Panel, text: PanelText) -> Iterator[tuple[str, ...]]:
    yield ("", "x, mm", "y, mm", Message("size, mm"), Message("what"))
    number = 0
    for hole in panel.holes:
        number += 1
        size = f"{DIAMETER}{rounded(hole.diameter)}{limited(hole.diameter, hole.fit)}"
        yield str(number), _at(hole.u), _at(hole.v), size, hole.name
    for feature in panel.features:
        number += 1
        sizes = (
            f"{rounded(size, 2)}{f'±{SHARE:g}' if fitted else ''}"
            for size, fitted in zip((feature.along, feature.across), feature.fitted, strict=True)
        )
        size = " × ".join(sizes) if feature.along else Message("see DXF")
        yield str(number), _at(feature.u), _at(feature.v), size, feature.name
    for edge in panel.edge_holes:
        number += 1
        thread, drilled = rounded(edge.depth - THREAD_END, 2), rounded(edge.depth, 2)
        size = f"{text.thread} × {thread} / {DIAMETER}{rounded(edge.diameter, 2)} × {drilled}"
        yield str(number), _at(edge.u), _at(edge.v), size, Message("thread in the foot, mid-thickness")
    for x, y in slanted_corners(panel):
        number += 1
        yield str(number), _at(x), _at(y), "", Message("corner of the outline")
    yield from _distances(panel)


def _distances(panel: Panel) -> Iterator[tuple[str, ...]]:
    """Rows of the distances of the tabs of a sheet, and of the slots of each: those along that have a fit there.

    Last come the first slots of sheets whose seats are in line, and the first tab from the first seat: they hold what
    goes through several sheets.
    """
    numbered = list(enumerate(panel.features, len(panel.holes) + 1))
    patterns = dict.fromkeys(each.pattern for each in panel.features if each.pattern)
    groups = [[(number, each) for number, each in numbered if each.pattern == pattern] for pattern in patterns]
    for tabs in groups:
        for (first, one), (second, other) in pairwise(tabs):
            apart = (abs(other.u - one.u), abs(other.v - one.v))
            fitted = (a and b for a, b in zip(one.fitted, other.fitted, strict=True))
            sizes = [f"{rounded(size, 2)}±{SHARE:g}" for size, fits in zip(apart, fitted, strict=True) if fits]
            if sizes:
                yield f"{first}–{second}", "", "", " × ".join(sizes), Message("distance, middle to middle")
    along = Message("along, middle to middle")
    in_line = [tabs[0] for tabs in groups if tabs[0][1].pattern != panel.code and tabs[0][1].fitted[0]]
    for second, other in in_line[1:]:
        first, one = in_line[0]
        yield f"{first}–{second}", "", "", f"{rounded(abs(other.u - one.u), 3)}±{SHARE:g}", along
    if seat := _first_seat(panel):
        for second, tab in [each for each in numbered if each[1].pattern == panel.code][:1]:
            yield f"{seat}–{second}", "", "", f"{rounded(abs(tab.u), 3)}±{SHARE:g}", along


def slanted_corners(panel: Panel) -> list[tuple[float, float]]:
    """Ends of the straight sides that lean, from which alone such a side can be sawn or milled by hand, mm.

    Args:
        panel: sheet part.
    """
    points, bulges = panel.outline.vertices, panel.outline.bulges
    found: list[tuple[float, float]] = []
    for start, end, bulge in zip(points.tolist(), np.roll(points, -1, axis=0).tolist(), bulges.tolist(), strict=True):
        along, across = abs(end[0] - start[0]), abs(end[1] - start[1])
        if not bulge and min(along, across) > _LEANS:
            found += [(x, y) for x, y in (start, end) if (x, y) not in found]
    return found


def _at(place: float) -> str:
    return f"{round(place, 3) + 0.0:.3f}"  # no -0


def block_drawing(block: ForkBlock, notes: tuple[str, ...], thread: str, title: Title) -> DrawingSheet:
    """Sheet of the fork's block: from above, and section A-A through its threads.

    The upper seat stands square to the lower face, the lower one in line with the upper, each within the width of the
    seats' class: by so much a bearing may stand aside in its seat.

    Args:
        block: block.
        notes: sentences for the shop.
        thread: name of the threads.
        title: title block.
    """
    half, across, tall, seat = block.length / 2, block.width / 2, block.height, block.bearing
    scale = 2.0 if max(block.length, block.height) <= 48.0 else 1.0
    gap = _GAP / scale
    size = "A4"
    height = SIZES[size][1]
    middle = EDGE + TITLE_SIZE[1] + (height - 2 * EDGE - TITLE_SIZE[1]) / 2
    above = (LEFT + 45.0 + scale * half, middle)
    lowest = EDGE + TITLE_SIZE[1] + _CAPTION * _GAP + 4.0  # the caption keeps off the title block
    section = (above[0] + 2 * scale * half + 48.0, max(middle - scale * tall / 2, lowest))
    top: list[Closed | Stroke] = [
        Closed(_box(-half, -across, half, across)),
        ring(seat.diameter),
        ring(block.bore),
        *(ring(size, LineKind.HIDDEN, (at, 0.0)) for at in block.threads for size in (block.tap, float(thread[1:]))),
        *(line for at in (0.0, *block.threads) for line in centre_cross(3.0 + seat.diameter / 4, (at, 0.0))),
    ]
    plane, letters = cutting_plane(np.pi, half + 1.7 * gap, scale)
    top += plane
    thick = float(thread[1:]) / 2
    cut: list[Closed | Stroke] = [Closed(_box(-half, 0.0, half, tall))]
    open_areas = []
    for low, high, radius in (
        (0.0, seat.width, seat.diameter / 2),
        (seat.width, tall - seat.width, block.bore / 2),
        (tall - seat.width, tall, seat.diameter / 2),
    ):
        cut.append(Closed(_box(-radius, low, radius, high)))
        open_areas.append(shapely.box(-radius, low, radius, high))
    for at in block.threads:
        cut.append(Closed(_box(at - block.tap / 2, 0.0, at + block.tap / 2, block.depth)))
        open_areas.append(shapely.box(at - block.tap / 2, 0.0, at + block.tap / 2, block.depth))
        cut += [
            Stroke(np.array([[at + side, 0.0], [at + side, block.depth - THREAD_END]]), LineKind.THIN)
            for side in (-thick, thick)
        ]
        cut.append(Stroke(np.array([[at, -2.0], [at, block.depth + 2.0]]), LineKind.CENTRE))
    cut.append(Stroke(np.array([[0.0, -3.0], [0.0, tall + 3.0]]), LineKind.CENTRE))
    low, high = deviations(f"{block.fit}/h6", seat.diameter)[0]
    fit = limited(seat.diameter, block.fit)
    beside = scale * seat.diameter / 2 + TEXT * WIDEST * (len(rounded(seat.diameter) + fit) + 1) / 2 + 2.0
    seats = [
        LinearDimension(
            name=name,
            start=(-seat.diameter / 2, z),
            end=(seat.diameter / 2, z),
            at=(0.0, line),
            prefix=DIAMETER,
            suffix=fit,
            beside=beside,
        )
        for name, z, line in (("seat", tall, tall + gap), ("lower seat", 0.0, -1.8 * gap))
    ]
    room = Room(cut, scale)
    for each in seats:
        room.take(each)
    symbols: list[Symbol] = [DatumFeature(letter="A", foot=(-half + 3.0 / scale, 0.0), angle=270.0)]
    for characteristic, datums, each in (
        (Characteristic.PERPENDICULARITY, ("A",), seats[0]),
        (Characteristic.COAXIALITY, ("B",), seats[1]),
    ):
        # In line with the dimension, which says that the axis is meant.
        tip = (-seat.diameter / 2, each.at[1])
        frame = ToleranceFrame(
            name=each.name,
            characteristic=characteristic,
            zone=high - low,
            datums=datums,
            tip=tip,
            bend=(tip[0] - 6.0 / scale, tip[1]),
            diametral=True,
        )
        symbols.append(frame)
        if each is seats[0]:
            symbols.append(room.hung("B", frame))
    solid = shapely.difference(shapely.box(-half, 0.0, half, tall), shapely.union_all(open_areas))
    _, hatches = outlines_and_hatches(list(shapely.get_parts(solid)))
    _, title_of_section = section_title(np.pi / 2, (0.0, -_CAPTION * gap), scale)
    words = (Label(text=Message("from above"), at=(0.0, -across - 1.2 * gap), height=3.5), *letters)
    sizes = Room(top, scale).dimensions(
        [
            LinearDimension(name="length", start=(-half, across), end=(half, across), at=(0.0, across + 2 * gap)),
            LinearDimension(
                name="threads apart",
                start=(block.threads[0], 0.0),
                end=(block.threads[-1], 0.0),
                at=(0.0, across + gap),
            ),
            upright("width", -half, (-across, across), -half - gap, scale),
            DiameterDimension(name="hole between the seats", centre=(0.0, 0.0), diameter=block.bore, angle=60.0),
            DiameterDimension(
                name="threads",
                centre=(block.threads[-1], 0.0),
                diameter=2 * thick,
                prefix=f"{len(block.threads)} × ",
                suffix=f" × {rounded(block.depth - THREAD_END, 2)}",
                sign="M",
                angle=-25.0,
            ),
        ],
        words,
    )
    views = (
        View(
            place=above,
            curves=tuple(top),
            dimensions=sizes,
            labels=words,
        ),
        View(
            place=section,
            curves=tuple(cut),
            symbols=tuple(symbols),
            dimensions=(
                *seats,
                upright("height", half, (0.0, tall), half + 2 * gap, scale),
                upright("depth of the upper seat", half, (tall - seat.width, tall), half + gap, scale),
                upright("depth of the lower seat", half, (0.0, seat.width), half + gap, scale),
                upright("depth of the threads' holes", -half, (0.0, block.depth), -half - gap, scale),
            ),
            labels=title_of_section,
            hatches=tuple(hatches),
        ),
    )
    return DrawingSheet(
        size=size,
        scale=scale,
        title=title,
        views=views,
        tables=(),
        notes=notes,
        columns=(beside_title(size),),
    )


def _box(left: float, low: float, right: float, high: float) -> Contour:
    return Contour(rectangle(left, low, right, high), np.zeros(4))
