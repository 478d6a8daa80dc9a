"""Sheets of the plain parts of a car: turned parts in section, and blocks and plates by their outline and holes.

Holes of screws have a tolerance of position: half of what a clearance hole is wider than its screw. A screw then goes
through two parts with this tolerance. The frames are those of ISO 5458, the rule that of ASME Y14.5, appendix B.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from shapely.affinity import rotate

from cadgen.car.assembly.car_parts import Block, key_outline
from cadgen.curves.contour import Contour
from cadgen.messages import Message
from cadgen.output.drawing.hole_frames import rim
from cadgen.output.drawing.placement import Room
from cadgen.output.drawing.section import outlines_and_hatches
from cadgen.output.drawing.shaft_fit import deeper, limits, longer, off_middle
from cadgen.output.drawing.sheet import (
    DIAMETER,
    EDGE,
    FRAME_HEIGHT,
    LEFT,
    SHORT,
    SIZES,
    TAIL,
    TEXT,
    WIDEST,
    AngularDimension,
    Characteristic,
    Closed,
    DatumFeature,
    DiameterDimension,
    Dimension,
    DrawingSheet,
    Label,
    LinearDimension,
    LineKind,
    SheetTable,
    Stroke,
    SurfaceTexture,
    Symbol,
    Title,
    ToleranceFrame,
    View,
    across_axis,
    along_axis,
    axis_datum,
    beside_title,
    centre_cross,
    chosen_scale,
    free_end,
    length_of,
    ring,
    rounded,
    symmetry,
)

_SIZE, _LARGER = "A4", "A3"
_ROOM = 34.0  # mm on paper to either side of a view, for its dimensions
_FIRST, _STEP = 9.0, 8.0  # mm on paper from a view to its first dimension line, and from one to the next
_RAISED, _UNDER, _ASIDE = 4.0, 12.0, 18.0  # mm on paper, of a shaft with sections under it, and beside these
_SECTION = 32.0  # mm on paper, for the dimensions of sections under a shaft
_FRAME = 14.0  # mm on paper, for the frames of their symmetry beside it
_KEYS = (42.0, 36.0)  # widths of the columns of a table of keys, mm
_BETWEEN = 40.0  # mm on paper between two views
_LETTER = 0.65  # mean width of the letters of a dimension, in heights
_CHORD = 1e-5  # mm, of outlines whose extent is dimensioned
_SCREW, _CLEARANCE, _TAP = 3.0, 3.2, 2.5  # mm: M3, its clearance hole (ISO 273, fine) and its tap drill
_ZONE = (_CLEARANCE - _SCREW) / 2  # mm, of the position of a screw's hole in each of the two parts


class TurnedStep(NamedTuple):
    """Round step of a turned part.

    Attributes:
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        diameter: outer diameter, mm.
        bore: diameter of its bore, mm; 0 for none.
        beside: distance of a hole beside the bore from the axis, and its diameter, mm; zeros for none.
    """

    low: float
    high: float
    diameter: float
    bore: float
    beside: tuple[float, float] = (0.0, 0.0)


class KeySeat(NamedTuple):
    """Seat of a key in a shaft.

    Attributes:
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        width: width, mm.
        floor: distance of its floor from the axis, mm.
        angle: its angle from the first seat, counterclockwise seen from the right end, rad.
        rounded: whether its left and its right end are round, as an end mill leaves them.
        key: form and size of its key by DIN 6885-1; empty where it is not known.
    """

    low: float
    high: float
    width: float
    floor: float
    angle: float
    rounded: tuple[bool, bool] = (True, True)
    key: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class PartTexts:
    """Texts of a sheet besides its title.

    Attributes:
        notes: sentences for the shop.
        fits: class of a diameter with its limits, with a blank before it, by the diameter in mm; for the others none.
        run_out: circular run-out of the widest step about the bore, mm; None where the design states none.
        seat: class of the width of a key's seat with its limits, with a blank before it.
        texture: texture of the outer surface; empty where it is that of the title block.
        length: limits of the whole length, with a blank before them; empty for the general tolerance.
    """

    notes: tuple[str, ...]
    fits: tuple[tuple[float, str], ...] = ()
    run_out: float | None = None
    seat: str = ""
    texture: str = ""
    length: str = ""

    def fit(self, diameter: float) -> str:
        """Class of a diameter, with a blank before it; empty without one.

        Args:
            diameter: diameter, mm.
        """
        return dict(self.fits).get(diameter, "")


def turned_drawing(
    steps: Sequence[TurnedStep],
    hole: tuple[float, float] | None,
    seats: Sequence[KeySeat],
    texts: PartTexts,
    title: Title,
    *,
    through: tuple[float, float] | None = None,
) -> DrawingSheet:
    """Sheet of a turned part, in section through its axis, which lies level; lengths count from its left end.

    Args:
        steps: steps from the left to the right.
        hole: diameter and height of a radial hole, mm; None without one.
        seats: seats of keys, each seen from above it, with sections across the shaft below them.
        texts: notes, and classes of diameters.
        title: title block.
        through: diameter and height of a plain hole across the whole part, mm; None without one.
    """
    low, high = steps[0].low, steps[-1].high
    reach = max(step.diameter for step in steps) / 2
    # Sections across the seats stand below, as high as the shaft.
    tall, below, beside = (4 * reach, _SECTION, _FRAME) if seats else (2 * reach, 0.0, 0.0)
    size, scale, place = _placed((high - low, tall), ((low + high) / 2, reach - tall / 2), title, below, beside)
    if seats:
        place = (place[0], place[1] + _RAISED)
    gap, step_out = _FIRST / scale, _STEP / scale
    curves: list[Closed | Stroke] = []
    areas: list[shapely.Geometry] = []
    for step in steps:
        outer = step.diameter / 2
        if not step.bore:
            corners = np.array([[step.low, -outer], [step.high, -outer], [step.high, outer], [step.low, outer]])
            curves.append(Closed(Contour(corners, np.zeros(4))))
            continue
        areas += [shapely.box(step.low, inner, step.high, outer) for inner, outer in _cut_of(step)]
        if step.beside[1]:
            away, half = step.beside[0], step.beside[1] / 2
            for height in (away - half, away + half):
                curves.append(Stroke(np.array([[step.low, height], [step.high, height]])))
            line = np.array([[step.low - 0.3 * gap, away], [step.high + 0.3 * gap, away]])
            curves.append(Stroke(line, LineKind.CENTRE))
    whole = shapely.union_all(areas)
    cut = [each for each in shapely.get_parts(whole) if isinstance(each, shapely.Polygon)]
    outlines, hatches = outlines_and_hatches(cut)
    curves += outlines
    bores = [0.0, *(step.bore for step in steps), 0.0]
    for z, before, after in zip([low, *(step.high for step in steps)], bores, bores[1:], strict=False):
        if before != after:  # an edge of the bore, seen beyond the cut
            across = max(before, after) / 2
            curves.append(Stroke(np.array([[z, -across], [z, across]])))
    axis = np.array([[low - 0.6 * gap, 0.0], [high + 0.6 * gap, 0.0]])
    curves.append(Stroke(axis, LineKind.CENTRE))
    dimensions: list[Dimension] = []
    ends = [step.high for step in steps]
    for number, end in enumerate(ends, 1):
        name = "length" if number == len(ends) else f"step {number} from the left end"
        extent_along = along_axis(name, (low, end), -reach, -reach - gap - (number - 1) * step_out)
        if number == len(ends) and texts.length:
            words = TEXT * _LETTER * len(f"{rounded(end - low)}{texts.length}")
            room = scale * (end - low)
            off = 0.0 if words < room - 4.0 else room / 2 + _tail(room) + words / 2 + 1.5
            extent_along = replace(extent_along, suffix=texts.length, beside=off)
        dimensions.append(extent_along)
    ends_of = {f"bore {step.bore:g}": (low, step.bore, 0) for step in steps if step.bore}
    # Of a bored part at its last place, away from the bore's number, which the extension lines would cross.
    for step in sorted(steps[:: -1 if ends_of else 1], key=lambda each: each.diameter):
        right = int((step.low + step.high) / 2 > (low + high) / 2)
        ends_of.setdefault(f"diameter {step.diameter:g}", (step.high if right else step.low, step.diameter, right))
    sides = [0, 0]

    def extent(each: tuple[str, tuple[float, float, int]]) -> float:
        across = each[1][1]
        return max(scale * across, TEXT * _LETTER * len(f"{DIAMETER}{rounded(across)}{texts.fit(across)}"))

    # Those of little extent nearest, so that no extension line crosses a number.
    for name, (z, diameter, right) in sorted(ends_of.items(), key=extent):
        at = (high if right else low) + (1 if right else -1) * (gap + sides[right] * step_out)
        sides[right] += 1
        alike = _alike(steps, diameter) if name.startswith("diameter") else 1
        dimensions.append(_diameter(name, z, diameter, at, texts, f"{alike} × {DIAMETER}" if alike > 1 else DIAMETER))
    dimensions += _holes_beside(steps, reach, low - gap - sides[0] * step_out, scale)
    if hole is not None:
        across, at_z = hole
        middle = next(step for step in steps if step.low < at_z < step.high)
        inner, outer = middle.bore / 2, middle.diameter / 2
        above = reach if outer < 0.6 * reach else outer
        curves.append(Stroke(np.array([[at_z, inner], [at_z, outer + 0.5 * gap]]), LineKind.CENTRE))
        for off in (-across / 2, across / 2):
            curves.append(Stroke(np.array([[at_z + off, inner], [at_z + off, outer]])))
        tapped = across == _TAP
        if tapped:
            curves += [
                Stroke(np.array([[at_z + off, inner], [at_z + off, outer]]), LineKind.THIN)
                for off in (-_SCREW / 2, _SCREW / 2)
            ]
        width = _SCREW if tapped else across
        deep = "" if middle.bore else f" x {rounded(outer - inner)}"
        suffix = f"{texts.fit(across)}{deep}"
        long = TEXT * _LETTER * (len(suffix) + 2)
        dimensions += [
            along_axis("radial hole from the left end", (low, at_z), outer, above + gap + step_out),
            replace(
                along_axis("radial hole", (at_z - width / 2, at_z + width / 2), outer, above + gap),
                prefix="M" if tapped else DIAMETER,
                suffix=suffix,
                beside=scale * width / 2 + _tail(scale * width) + long / 2 + 2.5,
            ),
        ]
    if through is not None:
        across, at_z = through
        outer = next(step.diameter / 2 for step in steps if step.low < at_z < step.high)
        over = np.array([[at_z, -outer - 0.5 * gap], [at_z, outer + 0.5 * gap]])
        curves.append(Stroke(over, LineKind.CENTRE))
        for off in (-across / 2, across / 2):
            curves.append(Stroke(np.array([[at_z + off, -outer], [at_z + off, outer]])))
        above = reach + gap + 2 * len(seats) * step_out
        long = TEXT * _LETTER * (len(rounded(across)) + 1)
        dimensions += [
            along_axis("hole for the string from the left end", (low, at_z), outer, above + step_out),
            replace(
                along_axis("hole for the string", (at_z - across / 2, at_z + across / 2), outer, above),
                prefix=DIAMETER,
                beside=scale * across / 2 + _tail(scale * across) + long / 2 + 2.5,
            ),
        ]
    for number, (start, end, width, *_, ends_round, _) in enumerate(seats, 1):
        curves.append(Closed(key_outline(start, end, width, ends_round)))
        at = reach + gap + 2 * (len(seats) - number) * step_out
        dimensions.append(along_axis(f"seat {number} from the left end", (low, start), reach, at + step_out))
        extent_along = along_axis(f"length of seat {number}", (start, end), reach, at)
        suffix = f" {limits(0.0, longer(end - start))}"
        words, room = TEXT * _LETTER * len(f"{rounded(end - start)}{suffix}"), scale * (end - start)
        off = 0.0 if words < room - 4.0 else room / 2 + _tail(room) + words / 2 + 1.5
        dimensions.append(replace(extent_along, suffix=suffix, beside=off))
    for number, (width, end) in enumerate({round(seat.width, 6): seat.high for seat in seats}.items()):
        count = sum(abs(seat.width - width) < _CHORD for seat in seats)
        prefix = f"{count} × " if count > 1 else ""
        wide = across_axis(
            f"width of seats {number + 1}", end, (-width / 2, width / 2), high + gap + number * step_out, prefix
        )
        long = TEXT * _LETTER * len(f"{prefix}{rounded(width)}{texts.seat}") / 2
        off = scale * width / 2 + _tail(scale * width) + long + 1.5
        dimensions.append(replace(wide, suffix=texts.seat, beside=-off))  # downwards: lengths of seats stand above
    sections = tuple(_seat_sections(steps, seats, scale, place))
    for section in sections:
        # In line with the seat: the section stands on the trace of its plane, which joins it to the view (ISO 128-3).
        x = (section.place[0] - place[0]) / scale
        end = (section.place[1] - place[1] + 3.0) / scale + reach
        curves.append(Stroke(np.array([[x, reach], [x, end]]), LineKind.CENTRE))
    view = View(
        place=place,
        curves=tuple(curves),
        hatches=tuple(hatches),
        dimensions=tuple(dimensions),
        symbols=(*_turned_symbols(steps, dimensions, scale, texts), *_middles(steps, seats, dimensions, scale)),
    )
    keys = tuple((rounded(seat.low - low), seat.key) for seat in seats if seat.key)
    return _sheet(size, scale, (view, *sections), texts, title, keys)


def _cut_of(step: TurnedStep) -> Iterator[tuple[float, float]]:
    """Distances from the axis between which a bored step is cut, over the axis and under it, less a hole beside it."""
    inner, outer = step.bore / 2, step.diameter / 2
    yield -outer, -inner
    away, half = step.beside[0], step.beside[1] / 2
    yield from ((inner, away - half), (away + half, outer)) if half else ((inner, outer),)


def _holes_beside(steps: Sequence[TurnedStep], reach: float, at: float, scale: float) -> Iterator[LinearDimension]:
    """Place and diameter of the hole for the string beside the axis.

    Args:
        steps: steps of the part.
        reach: greatest radius of the part, mm.
        at: place of the first dimension line, mm.
        scale: mm on paper for a mm of the part.
    """
    for step in steps:
        away, across = step.beside
        if across:
            yield across_axis("string's hole from the axis", step.low, (0.0, away), at)
            over = (reach - away) * scale + TEXT * _LETTER * (len(rounded(across)) + 1) / 2 + 3.0
            ends = (away - across / 2, away + across / 2)
            yield replace(across_axis("string's hole", step.low, ends, at - _STEP / scale, DIAMETER), beside=over)


def _alike(steps: Sequence[TurnedStep], diameter: float) -> int:
    """Number of places at which a part has a diameter: steps that follow each other are one."""
    has = [False, *(abs(step.diameter - diameter) < _CHORD for step in steps)]
    return sum(there and not before for before, there in pairwise(has))


def _seat_sections(
    steps: Sequence[TurnedStep], seats: Sequence[KeySeat], scale: float, place: tuple[float, float]
) -> Iterator[View]:
    """Section across a shaft through each seat, of like ones through the last, seen from the right end.

    Args:
        steps: steps of the shaft.
        seats: seats of keys.
        scale: mm on paper for a mm of the part.
        place: place of the view of the shaft on the paper, mm.
    """
    reach, gap = max(step.diameter for step in steps) / 2, _FIRST / scale
    alike: dict[tuple[float, ...], list[KeySeat]] = {}
    for seat in seats:
        across = next(step.diameter for step in steps if step.low <= (seat.low + seat.high) / 2 <= step.high)
        key = tuple(round(each, 5) for each in (across, seat.width, seat.floor, seat.angle % (2 * np.pi)))
        alike.setdefault(key, []).append(seat)
    below = place[1] - scale * reach - _FIRST - (len(steps) - 1) * _STEP - _UNDER
    right = np.inf  # left end of the section before, mm on paper
    for number, ((across, width, floor, angle), group) in reversed(list(enumerate(alike.items(), 1))):
        radius, seat = across / 2, group[-1]
        middle = min(place[0] + scale * (seat.low + seat.high) / 2, right - scale * radius - _ASIDE)
        right = middle - scale * radius - 4.0
        turn = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)
        disc = shapely.Polygon(radius * np.stack([np.cos(turn), np.sin(turn)], axis=1))
        notch = rotate(shapely.box(-width / 2, floor, width / 2, across), angle, origin=(0.0, 0.0), use_radians=True)
        strokes, hatches = outlines_and_hatches([shapely.difference(disc, notch)])
        along = np.array([-np.sin(angle), np.cos(angle)])
        # The depth stands on the side away from the angle.
        side = np.array([along[1], -along[0]]) * (-1.0 if 0.0 < angle % (2 * np.pi) <= np.pi else 1.0)
        (x, y), (left, low), (far, high) = (
            ((radius + 0.6 * gap) * side).tolist(),
            (-radius * along).tolist(),
            (floor * along).tolist(),
        )
        suffix = f" ({limits(-deeper(width), 0.0)})"
        prefix = f"{len(group)} × " if len(group) > 1 else ""
        long = TEXT * _LETTER * len(f"{prefix}{rounded(radius + floor)}{suffix}")
        depth = LinearDimension(
            name=f"shaft less seat {number}",
            start=(left, low),
            end=(far, high),
            at=(x, y),
            angle=90.0 + float(np.degrees(angle)),
            prefix=prefix,
            suffix=suffix,
            beside=(-1 if along[1] >= 0.0 else 1)  # downwards, where no view stands
            * (scale * (radius + floor) / 2 + _tail(scale * (radius + floor)) + long / 2 + 1.5),
        )
        dimensions: list[Dimension] = [depth]
        if angle:
            turned = float(np.degrees(angle if angle <= np.pi else angle - 2 * np.pi))
            start, end = sorted((90.0, 90.0 + turned))
            from_first = AngularDimension(
                name=f"angle of seat {number}", centre=(0.0, 0.0), start=start, end=end, radius=radius + 4.0 / scale
            )
            dimensions.append(from_first)
        yield View(
            place=(middle, below - scale * radius),
            curves=(*strokes, *centre_cross(radius + 2.0 / scale)),
            hatches=tuple(hatches),
            dimensions=tuple(dimensions),
            labels=(Label(text=Message("seen from the right end"), at=(0.0, -radius - 17.0 / scale)),) if angle else (),
        )


def _turned_symbols(
    steps: Sequence[TurnedStep], dimensions: Sequence[Dimension], scale: float, texts: PartTexts
) -> Iterator[Symbol]:
    """Run-out of the rim about datum A, the axis of the bore, and texture, where they are stated."""
    named = {each.name: each for each in dimensions if isinstance(each, LinearDimension)}
    bores = sorted({step.bore for step in steps if step.bore})
    if texts.run_out and bores:
        yield _axis(named[f"bore {bores[0]:g}"], scale)
        widest = max(steps, key=lambda step: step.diameter)
        # On the lower extension line of its diameter, where no length stands.
        rim = named[f"diameter {widest.diameter:g}"]
        side = 1.0 if rim.at[0] > rim.start[0] else -1.0
        tip = (rim.start[0] + side * 4.0 / scale, -widest.diameter / 2)
        bend = (tip[0] + side * 1e-6, tip[1] - 10.0 / scale)
        yield ToleranceFrame(
            name="rim",
            characteristic=Characteristic.RUN_OUT,
            zone=texts.run_out,
            datums=("A",),
            tip=tip,
            bend=bend,
        )
    if texts.texture:
        first = steps[0]
        yield SurfaceTexture(value=texts.texture, tip=(0.7 * first.low + 0.3 * first.high, first.diameter / 2))


def _axis(held: LinearDimension, scale: float) -> DatumFeature:
    """Datum A in line with an upright diameter, below its number, which stands over the middle of its line.

    Args:
        held: dimension of the diameter.
        scale: mm on paper for a mm of the part.
    """
    half = scale * length_of(held) / 2
    half += _tail(2 * half)
    long = TEXT * WIDEST * (len(rounded(length_of(held)) + held.suffix) + 1) / 2
    foot = (held.at[0], -half / scale)
    return DatumFeature(letter="A", foot=foot, angle=270.0, reach=max(8.0, long - half + 5.0))


def _middles(
    steps: Sequence[TurnedStep], seats: Sequence[KeySeat], dimensions: Sequence[Dimension], scale: float
) -> Iterator[Symbol]:
    """Symmetry of each width of seats to the axis of the shaft, in line with its dimension, over its upper end.

    Args:
        steps: steps of the shaft.
        seats: seats of keys.
        dimensions: dimensions of the view.
        scale: mm on paper for a mm of the part.
    """
    if not seats:
        return
    held = {each.name: each for each in dimensions if isinstance(each, LinearDimension)}
    middle = (seats[0].low + seats[0].high) / 2
    across = next(step.diameter for step in steps if step.low <= middle <= step.high)
    yield _axis(held[f"diameter {across:g}"], scale)
    widths = [each for name, each in held.items() if name.startswith("width of seats")]
    for number, each in enumerate(widths):
        end, out = free_end(each)
        leader = 8.0 + (FRAME_HEIGHT + 1.0) * (len(widths) - 1 - number)
        tip, bend = end.tolist(), (end + leader / scale * out).tolist()
        frame = symmetry(each.name.replace("width", "middle"), off_middle(length_of(each)))
        yield replace(frame, tip=(tip[0], tip[1]), bend=(bend[0] + 1e-6, bend[1]))


def block_drawing(block: Block, texts: PartTexts, title: Title) -> DrawingSheet:
    """Sheet of a plate or block: its outline with holes, and beside it the view from the right.

    Args:
        block: one prism, and holes across it.
        texts: notes, and classes of diameters.
        title: title block.
    """
    (prism,) = block.prisms
    points = prism.outline.polygon(_CHORD)
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
            prefix = f"{count[size]} × " if count[size] > 1 else ""
            dimensions.append(
                DiameterDimension(
                    name=f"hole {size:g}", centre=(x, y), diameter=size, prefix=prefix, suffix=texts.fit(size)
                )
            )
        exact = size == _CLEARANCE
        if count[size] == 1 or x > 0:
            across = f"hole {size:g} from the left" if count[size] == 1 else f"holes {size:g} apart"
            start = (left, y) if count[size] == 1 else (-x, y)
            at = (left, top + gap + step_out * len(levels))
            dimensions.append(LinearDimension(name=across, start=start, end=(x, y), at=at, exact=exact))
            levels.add(y)
            at = (right + gap + step_out * (len(levels) - 1), low)
            below = LinearDimension(
                name=f"hole {size:g} from below", start=(right, low), end=(x, y), at=at, angle=90.0, exact=exact
            )
            dimensions.append(below)
    room = Room(curves, scale)
    placed = room.dimensions(dimensions, ())
    symbols: list[Symbol] = []
    fitted = [each for each in placed if isinstance(each, DiameterDimension) and texts.fit(each.diameter)]
    clearance = [hole for hole in prism.holes if round(2 * float(hole.radii[0]), 6) == _CLEARANCE]
    if fitted and (clearance or block.drilled):
        if clearance:
            edge = DatumFeature(letter="A", foot=(0.6 * left + 0.4 * right, low), angle=270.0)
            symbols.append(room.datum(edge, (15.0, 17.0, 20.0)))
        symbols.append(room.datum(axis_datum("B", fitted[0])))
        if clearance:
            symbols.append(
                room.frame(
                    _position("clearance holes"),
                    list(rim(tuple(clearance[-1].centers[0].tolist()), float(clearance[-1].radii[0]))),
                )
            )
    first = View(place=place, curves=tuple(curves), dimensions=placed, symbols=tuple(symbols))
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
    turn = np.radians(np.linspace(0.0, 270.0, 55))
    for at in places:
        size = block.drilled[0].diameter
        thread = np.array(at) + _SCREW / 2 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        curves += [ring(size, centre=at), Stroke(thread, LineKind.THIN), *centre_cross(size / 2 + 2.0 / scale, at)]
    symbols: list[Symbol] = []
    placed: tuple[Dimension, ...] = tuple(dimensions)
    if places:
        (z, first), (_, last) = places[0], places[-1]
        apart = LinearDimension(
            name="threads apart", start=(z, first), end=(z, last), at=(thick + gap, first), angle=90.0, exact=True
        )
        from_face = LinearDimension(
            name="threads from the face", start=(0.0, last), end=(z, last), at=(0.0, across[1] + gap), exact=True
        )
        threads = DiameterDimension(
            name="threads", centre=places[-1], diameter=_SCREW, prefix=f"{len(places)} × ", sign="M"
        )
        room = Room(curves, scale)
        placed = room.dimensions([*dimensions, apart, from_face, threads], ())
        symbols += [
            room.datum(DatumFeature(letter="A", foot=(0.0, 0.6 * across[0] + 0.4 * across[1]), angle=180.0)),
            room.frame(_position("threads"), list(rim(places[0], _SCREW / 2))),
        ]
    labels = (Label(text=Message("from below"), at=(thick / 2, across[0] - 2.2 * gap)),) if places else ()
    beside = (place[0] + scale * right + _ROOM + _BETWEEN / 2, place[1] + scale * ((low + top) / 2 - sum(across) / 2))
    return View(place=beside, curves=tuple(curves), dimensions=placed, labels=labels, symbols=tuple(symbols))


def _tail(width: float) -> float:
    """Length of what stands outside a width with its arrow, mm on paper; 0 where the arrows have room inside."""
    return 0.0 if width >= SHORT else TAIL


def _position(name: str) -> ToleranceFrame:
    """Position of holes of screws to datums A and B, wherever it stands."""
    return ToleranceFrame(
        name=name,
        characteristic=Characteristic.POSITION,
        zone=_ZONE,
        datums=("A", "B"),
        tip=(0.0, 0.0),
        bend=(1.0, 0.0),
        diametral=True,
    )


def _diameter(name: str, z: float, diameter: float, at: float, texts: PartTexts, prefix: str) -> LinearDimension:
    made = across_axis(name, z, (-diameter / 2, diameter / 2), at, prefix)
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
    part: tuple[float, float], middle: tuple[float, float], title: Title, below: float = 0.0, beside: float = 0.0
) -> tuple[str, float, tuple[float, float]]:
    """Size of the sheet, scale of a view, and its place over the title block: A3 where A4 shows it smaller than 1:1.

    Args:
        part: width and height of what is drawn, mm.
        middle: its middle in the view, mm.
        title: title block.
        below: further room for dimensions between a view and one below it, mm on paper.
        beside: further room on either side of a view, mm on paper.
    """
    chosen = []
    for size in (_SIZE, _LARGER):
        room = (SIZES[size][0] - LEFT - EDGE - 2 * (_ROOM + beside), _height(title, size) - 2 * _ROOM + 16.0 - below)
        scale = chosen_scale(part, room, 5.0) or 0.1
        x = LEFT + (SIZES[size][0] - LEFT - EDGE) / 2 - scale * middle[0]
        chosen.append((size, scale, (x, EDGE + title.height + 8.0 + _height(title, size) / 2 - scale * middle[1])))
        if scale >= 1:
            break
    return max(chosen, key=lambda each: each[1])


def _sheet(
    size: str,
    scale: float,
    views: tuple[View, ...],
    texts: PartTexts,
    title: Title,
    keys: tuple[tuple[str, str], ...] = (),
) -> DrawingSheet:
    """Sheet with its notes, and under these a table of the keys of its seats.

    Args:
        size: size of the sheet.
        scale: mm on paper for a mm of the part.
        views: views of the part.
        texts: notes.
        title: title block.
        keys: distance of each seat from the left end, and its key.
    """
    column = beside_title(size)
    tables: tuple[SheetTable, ...] = ()
    if keys:
        rows = ((Message("seat from the left end"), Message("key, DIN 6885-1")), *keys)
        made = SheetTable(title=Message("keys"), at=column.at, widths=_KEYS, rows=rows)
        made = replace(made, at=(column.at[0], column.at[1] - column.height + made.height + 1.0))
        column, tables = replace(column, height=column.height - made.height - 2.0), (made,)
    return DrawingSheet(
        title=title, views=views, tables=tables, notes=texts.notes, columns=(column,), size=size, scale=scale
    )
