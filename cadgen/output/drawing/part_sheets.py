"""Sheets of the plain parts of a car: turned parts in section, and blocks and plates by their outline and holes."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cadgen.car.assembly.car_parts import Block
from cadgen.curves.contour import Contour
from cadgen.messages import Message
from cadgen.output.drawing.sheet import (
    EDGE,
    LEFT,
    SIZES,
    Closed,
    DiameterDimension,
    Dimension,
    DrawingSheet,
    Hatch,
    Label,
    LinearDimension,
    LineKind,
    Stroke,
    Title,
    View,
    across_axis,
    along_axis,
    beside_title,
    centre_cross,
    chosen_scale,
    ring,
)

_SIZE, _LARGER = "A4", "A3"
_ROOM = 34.0  # mm on paper to either side of a view, for its dimensions
_FIRST, _STEP = 9.0, 8.0  # mm on paper from a view to its first dimension line, and from one to the next
_BETWEEN = 40.0  # mm on paper between two views


class TurnedStep(NamedTuple):
    """Round step of a turned part.

    Attributes:
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        diameter: outer diameter, mm.
        bore: diameter of its bore, mm; 0 for none.
    """

    low: float
    high: float
    diameter: float
    bore: float


@dataclass(frozen=True, slots=True, kw_only=True)
class PartTexts:
    """Texts of a sheet besides its title.

    Attributes:
        notes: sentences for the shop.
        fits: class of a diameter, with a blank before it, by the diameter in mm; for the others none.
    """

    notes: tuple[str, ...]
    fits: tuple[tuple[float, str], ...] = ()

    def fit(self, diameter: float) -> str:
        """Class of a diameter, with a blank before it; empty without one.

        Args:
            diameter: diameter, mm.
        """
        return dict(self.fits).get(diameter, "")


def turned_drawing(
    steps: Sequence[TurnedStep],
    hole: tuple[float, float] | None,
    seats: Sequence[tuple[float, float, float]],
    texts: PartTexts,
    title: Title,
) -> DrawingSheet:
    """Sheet of a turned part, in section through its axis, which lies level; lengths count from its left end.

    Args:
        steps: steps from the left to the right.
        hole: diameter and height of a radial hole, mm; None without one.
        seats: low and high end and width of each seat of a key, seen from above it, mm.
        texts: notes, and classes of diameters.
        title: title block.
    """
    low, high = steps[0].low, steps[-1].high
    reach = max(step.diameter for step in steps) / 2
    size, scale, place = _placed((high - low, 2 * reach), ((low + high) / 2, 0.0), title)
    gap, step_out = _FIRST / scale, _STEP / scale
    curves: list[Closed | Stroke] = []
    hatches: list[Hatch] = []
    for step in steps:
        for side in (-1, 1):
            inner, outer = side * step.bore / 2, side * step.diameter / 2
            corners = np.array([[step.low, inner], [step.high, inner], [step.high, outer], [step.low, outer]])
            curves.append(Closed(Contour(corners[::side], np.zeros(4))))
            if step.bore:
                hatches.append(Hatch(corners))
    axis = np.array([[low - 0.6 * gap, 0.0], [high + 0.6 * gap, 0.0]])
    curves.append(Stroke(axis, LineKind.CENTRE))
    dimensions: list[Dimension] = []
    ends = [step.high for step in steps]
    for number, end in enumerate(ends, 1):
        name = "length" if number == len(ends) else f"step {number} from the left end"
        dimensions.append(along_axis(name, (low, end), -reach, -reach - gap - (number - 1) * step_out))
    shown: set[float] = set()
    sides = [0, 0]
    for step in sorted(steps, key=lambda each: each.diameter):
        if step.diameter in shown:
            continue
        shown.add(step.diameter)
        right = int((step.low + step.high) / 2 > (low + high) / 2)
        z = step.high if right else step.low
        at = (high if right else low) + (1 if right else -1) * (gap + sides[right] * step_out)
        sides[right] += 1
        dimensions.append(_diameter(f"diameter {step.diameter:g}", z, step.diameter, at, texts))
    for bore in sorted({step.bore for step in steps if step.bore}):
        sides[0] += 1
        at = low - gap - (sides[0] - 1) * step_out
        dimensions.append(_diameter(f"bore {bore:g}", low, bore, at, texts))
    if hole is not None:
        across, at_z = hole
        curves.append(Stroke(np.array([[at_z, -0.0], [at_z, reach + 0.5 * gap]]), LineKind.CENTRE))
        middle = next(step for step in steps if step.low < at_z < step.high)
        for off in (-across / 2, across / 2):
            curves.append(Stroke(np.array([[at_z + off, middle.bore / 2], [at_z + off, middle.diameter / 2]])))
        dimensions.append(along_axis("radial hole from the left end", (low, at_z), reach, reach + gap))
    for number, (start, end, width) in enumerate(seats, 1):
        corners = np.array([[start, -width / 2], [end, -width / 2], [end, width / 2], [start, width / 2]])
        curves.append(Closed(Contour(corners, np.zeros(4))))
        at = reach + gap + 2 * (len(seats) - number) * step_out
        dimensions.append(along_axis(f"seat {number} from the left end", (low, start), reach, at + step_out))
        dimensions.append(along_axis(f"length of seat {number}", (start, end), reach, at))
    view = View(place=place, curves=tuple(curves), hatches=tuple(hatches), dimensions=tuple(dimensions))
    return _sheet(size, scale, (view,), texts, title)


def block_drawing(block: Block, texts: PartTexts, title: Title) -> DrawingSheet:
    """Sheet of a plate or block: its outline with holes, and beside it the view from the right.

    Args:
        block: one prism, and holes across it.
        texts: notes, and classes of diameters.
        title: title block.
    """
    (prism,) = block.prisms
    points = prism.outline.polygon(0.05)
    (left, low), (right, top) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    thick = prism.high - prism.low
    scale = (
        chosen_scale(
            (right - left + thick, top - low),
            (SIZES[_SIZE][0] - LEFT - EDGE - 3 * _ROOM - _BETWEEN / 2, _height(title) - 2 * _ROOM + 20.0),
            5.0,
        )
        or 0.1
    )
    gap, step_out = _FIRST / scale, _STEP / scale
    middle = EDGE + title.height + 4.0 + _height(title) / 2
    place = (LEFT + _ROOM + 10.0 - scale * left, middle - scale * (low + top) / 2)
    curves: list[Closed | Stroke] = [Closed(prism.outline)]
    dimensions: list[Dimension] = [
        LinearDimension(name="width", start=(left, low), end=(right, low), at=(left, low - gap)),
        LinearDimension(name="height", start=(left, low), end=(left, top), at=(left - gap - step_out, low), angle=90.0),
    ]
    count = Counter(round(float(hole.radii[0]) * 2, 6) for hole in prism.holes)
    shown: set[float] = set()
    levels: set[float] = set()
    for hole in prism.holes:
        (x, y), size = hole.centers[0].tolist(), round(float(hole.radii[0]) * 2, 6)
        curves += [Closed(hole), *centre_cross(size / 2 + 2.0 / scale, (x, y))]
        if size not in shown:
            shown.add(size)
            prefix = f"{count[size]} x " if count[size] > 1 else ""
            dimensions.append(
                DiameterDimension(
                    name=f"hole {size:g}", centre=(x, y), diameter=size, prefix=prefix, suffix=texts.fit(size)
                )
            )
        if count[size] == 1 or x > 0:
            across = f"hole {size:g} from the left" if count[size] == 1 else f"holes {size:g} apart"
            start = (left, y) if count[size] == 1 else (-x, y)
            at = (left, top + gap + step_out * len(levels))
            dimensions.append(LinearDimension(name=across, start=start, end=(x, y), at=at))
            levels.add(y)
            at = (right + gap + step_out * (len(levels) - 1), low)
            dimensions.append(
                LinearDimension(name=f"hole {size:g} from below", start=(right, low), end=(x, y), at=at, angle=90.0)
            )
    first = View(place=place, curves=tuple(curves), dimensions=tuple(dimensions))
    views = [first, _side_view(block, (left, low, right, top), scale, place)]
    return _sheet(_SIZE, scale, tuple(views), texts, title)


def _side_view(
    block: Block, bounds: tuple[float, float, float, float], scale: float, place: tuple[float, float]
) -> View:
    """View of a block from the right, of one with holes across it from below: these are seen there."""
    (prism,), (left, low, right, top) = block.prisms, bounds
    thick, gap = prism.high - prism.low, _FIRST / scale
    across = (low, top) if not block.drilled else (left, right)
    corners = np.array([[0.0, across[0]], [thick, across[0]], [thick, across[1]], [0.0, across[1]]])
    curves: list[Closed | Stroke] = [Closed(Contour(corners, np.zeros(4)))]
    dimensions = [
        LinearDimension(
            name="thickness", start=(0.0, across[0]), end=(thick, across[0]), at=(0.0, across[0] - gap), beside=8.0
        )
    ]
    places = sorted({(hole.start[2] - prism.low, hole.start[0]) for hole in block.drilled})
    for at in places:
        size = block.drilled[0].diameter
        curves += [ring(size, centre=at), *centre_cross(size / 2 + 2.0 / scale, at)]
    if places:
        (z, first), (_, last) = places[0], places[-1]
        dimensions += [
            LinearDimension(name="threads apart", start=(z, first), end=(z, last), at=(thick + gap, first), angle=90.0),
            LinearDimension(name="threads from the face", start=(0.0, last), end=(z, last), at=(0.0, across[1] + gap)),
        ]
    labels = (Label(text=Message("from below"), at=(thick / 2, across[0] - 2.2 * gap)),) if places else ()
    beside = (place[0] + scale * right + _ROOM + _BETWEEN / 2, place[1] + scale * ((low + top) / 2 - sum(across) / 2))
    return View(place=beside, curves=tuple(curves), dimensions=tuple(dimensions), labels=labels)


def _diameter(name: str, z: float, diameter: float, at: float, texts: PartTexts) -> LinearDimension:
    made = across_axis(name, z, (-diameter / 2, diameter / 2), at, "Ø")
    return LinearDimension(
        name=made.name,
        start=made.start,
        end=made.end,
        at=made.at,
        angle=made.angle,
        prefix=made.prefix,
        suffix=texts.fit(diameter),
    )


def _height(title: Title, size: str = _SIZE) -> float:
    """Height of the room over the title block, mm."""
    return SIZES[size][1] - 2 * EDGE - title.height - 4.0


def _placed(
    part: tuple[float, float], middle: tuple[float, float], title: Title
) -> tuple[str, float, tuple[float, float]]:
    """Size of the sheet, scale of a view, and its place over the title block: A3 where A4 shows it smaller than 1:1."""
    chosen = []
    for size in (_SIZE, _LARGER):
        room = (SIZES[size][0] - LEFT - EDGE - 2 * _ROOM, _height(title, size) - 2 * _ROOM + 16.0)
        scale = chosen_scale(part, room, 5.0) or 0.1
        x = LEFT + (SIZES[size][0] - LEFT - EDGE) / 2 - scale * middle[0]
        chosen.append((size, scale, (x, EDGE + title.height + 8.0 + _height(title, size) / 2 - scale * middle[1])))
        if scale >= 1:
            break
    return max(chosen, key=lambda each: each[1])


def _sheet(size: str, scale: float, views: tuple[View, ...], texts: PartTexts, title: Title) -> DrawingSheet:
    column = beside_title(size)
    return DrawingSheet(
        title=title, views=views, tables=(), notes=texts.notes, columns=(column,), size=size, scale=scale
    )
