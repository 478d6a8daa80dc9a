"""Sheet of a plate with a hole for every shaft of a train."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, ceil, degrees, floor

import numpy as np

from cadgen.curves.contour import Contour
from cadgen.output.drawing.room import Room
from cadgen.output.drawing.sheet import (
    DIAMETER,
    EDGE,
    LEFT,
    SIZES,
    TITLE_SIZE,
    Closed,
    Dimension,
    Drawing,
    Line,
    Linear,
    Stroke,
    Table,
    Title,
    View,
    centre_cross,
    chosen_sheet,
    ring,
    wrapped,
)

MARGIN = 10.0  # mm of plate beyond the gears
_ROUND = 5.0  # mm, to which its sides are rounded up
_GAP = 10.0  # mm on paper
_NUMBER = 4.0  # mm on paper from a hole to the middle of its shaft's number
_WIDTHS = (14.0, 24.0, 24.0, 22.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """A shaft of the train where it passes the plate.

    Attributes:
        shaft: its number, from the drive.
        x: place of its axis, mm.
        y: likewise.
        bore: diameter of the part's bore, mm; 0 for none.
        reach: radius of the largest gear on it, mm.
    """

    shaft: int
    x: float
    y: float
    bore: float
    reach: float


def _distances(first: Axis, second: Axis, gap: float) -> Iterator[Linear]:
    """Dimensions of the distance of two axes, at several distances from them on either side, mm on the part."""
    way = complex(second.x - first.x, second.y - first.y)
    for aside in (1.4, -1.4, 0.9, -0.9, 2.0, -2.0, 2.6, -2.6, 3.4, -3.4):
        middle = complex(first.x + second.x, first.y + second.y) / 2 + aside * gap * 1j * way / abs(way)
        for beside in (0.0, 5.0, -5.0, 10.0, -10.0):
            yield Linear(
                name=f"axes {first.shaft} and {second.shaft}",
                start=(first.x, first.y),
                end=(second.x, second.y),
                at=(middle.real, middle.imag),
                angle=degrees(atan2(way.imag, way.real)),
                beside=beside,
            )


def plate_drawing(axes: tuple[Axis, ...], notes: tuple[str, ...], title: Title) -> Drawing:
    """Sheet A4, or A3 where the plate is larger than A4 shows at 1:1."""
    places = np.array([[axis.x, axis.y] for axis in axes])
    reach = np.array([[axis.reach] for axis in axes])
    least, most = (places - reach).min(axis=0) - MARGIN, (places + reach).max(axis=0) + MARGIN
    left, low = (_ROUND * floor(value / _ROUND) for value in least.tolist())
    right, high = (_ROUND * ceil(value / _ROUND) for value in most.tolist())
    table_width = sum(_WIDTHS)
    beside = (table_width + 40.0, TITLE_SIZE[1] + 30.0)
    size, scale = chosen_sheet((right - left, high - low), beside, 1.0, 2.0)
    width, height = SIZES[size]
    place = (
        LEFT + 24.0 - scale * left,
        EDGE + TITLE_SIZE[1] + 6.0 + (height - 2 * EDGE - TITLE_SIZE[1] - scale * (high - low)) / 2 - scale * low,
    )
    corners = np.array([[left, low], [right, low], [right, high], [left, high]])
    curves: list[Closed | Stroke] = [Closed(Contour(corners, np.zeros(4)))]
    for axis in axes:
        at = (axis.x, axis.y)
        curves += [ring(2 * axis.reach, Line.PHANTOM, at), *centre_cross(6.0 / scale, at)]
        if axis.bore:
            curves.append(ring(axis.bore, centre=at))
    gap = _GAP / scale
    room = Room(curves, scale)
    dimensions: list[Dimension] = [
        Linear(name="plate width", start=(left, low), end=(right, low), at=(left, low - gap)),
        Linear(name="plate height", start=(left, low), end=(left, high), at=(left - gap, low), angle=90.0),
        Linear(
            name="axis 1 from the left", start=(left, high), end=(axes[0].x, axes[0].y), at=(left, high + 0.8 * gap)
        ),
        Linear(
            name="axis 1 from below",
            start=(right, low),
            end=(axes[0].x, axes[0].y),
            at=(right + 0.8 * gap, low),
            angle=90.0,
        ),
    ]
    for dimension in dimensions:
        room.take(dimension)
    labels = [room.label(str(axis.shaft), (axis.x, axis.y), scale * axis.bore / 2 + _NUMBER, 3.5) for axis in axes]
    dimensions += [
        room.linear(_distances(first, second, gap))
        for first, second in pairwise(axes)
        if (first.x, first.y) != (second.x, second.y)
    ]
    rows = [("shaft", "x, mm", "y, mm", f"shaft {DIAMETER}, mm")]
    for axis in axes:
        rows.append((str(axis.shaft), f"{axis.x:.3f}", f"{axis.y:.3f}", f"{axis.bore:g}" if axis.bore else ""))
    table_at = (width - EDGE - table_width, height - EDGE - 2.0)
    table = Table(title="axes, from that of the drive", at=table_at, widths=_WIDTHS, rows=tuple(rows))
    return Drawing(
        size=size,
        scale=scale,
        title=title,
        views=(View(place=place, curves=tuple(curves), dimensions=tuple(dimensions), labels=tuple(labels)),),
        tables=(table,),
        notes=wrapped(notes, table_width),
        notes_at=(table_at[0], table_at[1] - table.height - 3.0),
    )
