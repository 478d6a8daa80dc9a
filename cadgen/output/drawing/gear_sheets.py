"""Sheets of a gear train: of each part, with a table of data for each of its gears, and of the plate for the axes."""

from cmath import phase
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import atan2, degrees, radians, sin

import numpy as np
import shapely

from cadgen.arrays import Array
from cadgen.curves.contour import Contour, circle
from cadgen.figures import Figures
from cadgen.gears.inspection import gauge_in
from cadgen.gears.layout import TrainPart
from cadgen.gears.planetary_stage import PLANET
from cadgen.gears.rack import RackForm
from cadgen.gears.stage import Stage, Wheel, holes_of, is_ring, rim_diameter
from cadgen.gears.tolerances import tip_tolerance
from cadgen.messages import Message
from cadgen.output.drawing.hole_frames import edge_view, hole_frames, outline_tips, rim
from cadgen.output.drawing.placement import Room
from cadgen.output.drawing.section import Layer, ScrewHole, edges_behind_cut, material, outlines_and_hatches
from cadgen.output.drawing.shaft_fit import ShaftFit, deeper, limited, limits, off_middle
from cadgen.output.drawing.sheet import (
    EDGE,
    FRAME_HEIGHT,
    LEFT,
    SHORT,
    SHOWN,
    SIZES,
    TAIL,
    TEXT,
    TITLE_SIZE,
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
    NoteColumn,
    SheetTable,
    Stroke,
    SurfaceTexture,
    Symbol,
    Title,
    ToleranceFrame,
    View,
    along_axis,
    axial_diameter,
    axis_datum,
    beside_title,
    bore_and_keyway,
    centre_cross,
    chosen_sheet,
    cutting_plane,
    free_end,
    have_room,
    keyway_width,
    length_of,
    line_datum,
    over_title,
    ring,
    rounded,
    run_out,
    section_title,
    symmetry,
    upright,
    width_of,
)
from cadgen.output.files.plate import Axis, Plate
from cadgen.parts.body import Body
from cadgen.parts.features import Flats, Keyway
from cadgen.parts.loop import Arc, Loop


def gear_rows(
    gear: Figures, mates: Sequence[str], stage: Stage, *, drives: bool, double: bool = False
) -> tuple[tuple[str, str], ...]:
    """Gear data as pairs of name and value, in the order of ISO 1340; rows that a wheel lacks are left out.

    Args:
        gear: figures of the gear; of a carrier, which has no teeth, distance and name of its planets are left.
        mates: what it meshes with.
        stage: its stage.
        drives: whether it is the driver of the stage.
        double: whether its helix turns back at half the width.
    """
    if gear.value("teeth") is None:
        # Auxiliary, in brackets (ISO 129-1): the circle of the pins and their frame hold it.
        return (Message("centre distance, mm"), f"({rounded(stage.centre_distance, 4)})"), (
            Message("carries"),
            mates[0],
        )
    grade = stage.grades[0 if drives else 1]
    ring = gear.value("rim_diameter") is not None

    def mm(code: str, digits: int = 3) -> str:
        value = gear.value(code)
        return "" if value is None else f"{rounded(value, digits)} mm"

    def plain(code: str) -> str:
        value = gear.value(code)
        return "" if value is None else f"{round(value, 9) + 0.0:.6g}"  # no -0

    def zone(code: str) -> str:
        value = gear.value(code)
        sign = "± " if code == "f_pt" else ""
        return "" if value is None else f"{sign}{value:g} µm"

    def limits(name: str) -> str:
        most, least = gear.value(f"{name}_max"), gear.value(f"{name}_min")
        if most is None or least is None:
            return ""
        return Message("{least:.3f} to {most:.3f}", least=least, most=most) if most > least else f"{most:.3f}"

    upper, lower = gear.value("E_sns"), gear.value("E_sni")
    exact = upper is not None and upper == lower  # nothing is tolerated: sizes alone are stated, and no grade
    angle, helix, width, cutter = map(gear.value, ("pressure_angle", "helix_angle", "width", "cutter_teeth"))
    length, teeth = gear.value("length"), gear.value("teeth")
    pitch = f"{rounded(length / teeth, 4)} mm" if length and teeth else ""  # of a rack
    steep = abs(helix or 0.0)
    lean = [Message("{angle:g}° right", angle=steep), Message("{angle:g}° left", angle=steep)]
    lean = lean[:: 1 if (helix or 0.0) > 0 else -1]
    helices = [] if helix is None else [(Message("helix angle, hand"), lean[0])]
    if double:
        helices = [(Message("helix of the lower half"), lean[0]), (Message("helix of the upper half"), lean[1])]
    rack = [plain(code) for code in ("addendum_factor", "dedendum_factor", "rack_tip_radius_factor")]
    factors = ", ".join(filter(None, rack))
    apart, deviation = rounded(stage.centre_distance, 4), stage.distance_deviation
    pins, gauge = Message("over balls, mm") if helix else Message("over pins, mm"), gauge_in(gear)
    as_gear = Message("{grade}, as of a gear of z = {teeth}", grade=grade, teeth=plain("teeth"))
    rows: list[tuple[str, str]] = [
        (Message("module m_n"), mm("module", 4)),
        (Message("teeth z"), Message("{teeth}, inside", teeth=plain("teeth")) if ring else plain("teeth")),
        (Message("pressure angle"), "" if angle is None else f"{angle:g}°"),
        (Message("h_aP, h_fP") if ring else Message("h_aP, h_fP, rho_fP"), f"{factors} × m" if factors else ""),
        (Message("transverse pitch") if helix else Message("pitch"), pitch),
        *helices,
        (Message("lead"), mm("lead")),
        (Message("reference diameter d"), mm("reference_diameter")),
        (Message("profile shift x"), plain("profile_shift")),
        (Message("tooth depth h"), mm("tooth_depth")),
        (Message("tip diameter"), mm("tip_diameter")),
        (Message("root form diameter"), mm("form_diameter")),
        (Message("root diameter, as cut"), mm("root_diameter")),
        (Message("outer diameter"), mm("rim_diameter")),
        (
            Message("root"),
            ""
            if cutter is None
            else Message("pinion cutter, z0 {teeth:g}", teeth=cutter)
            if cutter
            else Message("arc"),
        ),
        (Message("face width"), f"2 × {rounded(width / 2)} mm" if double and width else mm("width")),
        (Message("grade, ISO 1328-1:1995"), "" if grade is None or exact else as_gear if length else str(grade)),
        *((name, zone(code)) for name, code in _FLANKS),
        (
            Message("axis to reference line, mm") if length else Message("centre distance, mm"),
            f"{apart} ± {deviation:.4f}" if deviation else apart,
        ),
        (Message("meshes with"), mates[0]),
        *((Message("and with"), mate) for mate in mates[1:]),
        (
            Message("thickness E_sns / E_sni"),
            "" if upper is None or lower is None else f"{upper:.1f} µm" if exact else f"{upper:.1f} / {lower:.1f} µm",
        ),
        (Message("spaces spanned k") if ring else Message("teeth spanned k"), plain("teeth_spanned")),
        (Message("span W_k, mm"), limits("span")),
        (Message("span needs a face of"), mm("span_width_needed") if gear.value("span_max") is None else ""),
        (Message("ball diameter D_M") if helix or ring else Message("pin diameter D_M"), mm(gauge.diameter)),
        (Message("between balls, mm") if ring else pins, limits(gauge.size)),
        (
            Message("over a ball from back, mm") if helix else Message("over a pin from back, mm"),
            limits("over_pin"),
        ),
        (
            Message("contact + overlap ratio") if helix else Message("contact ratio"),
            " + ".join(
                f"{value:.2f}" for code in ("contact_ratio", "overlap_ratio") if (value := gear.value(code)) is not None
            ),
        ),
    ]
    return tuple(row for row in rows if row[1])


# Deviations of a rack's flanks that its sheet states: no standard of racks goes by a grade alone.
_FLANKS = (
    (Message("single pitch f_pt"), "f_pt"),
    (Message("total pitch F_p"), "F_p"),
    (Message("profile F_alpha"), "F_alpha"),
    (Message("helix F_beta"), "F_beta"),
)
_GRID = 1e-6  # mm, to which outlines are joined
_CHORD = 1e-4  # of outlines on the sheet, as a share of their radius
_BEYOND = 2.0  # mm on paper by which a pitch line stands out
_ON_LINE, _LEADER = 3.6, 7.0  # mm on paper along an extension line to a leader, and length of the leader
_SAME = 0.01  # mm, within which an outline has the tip circle of a gear
_UNDER = 46.0  # mm on paper from the back of a rack to the view on its teeth
_GAP = 8.0  # mm on paper from the part to a dimension line, and from line to line
_TABLE = {1: (42.0, 42.0), 2: (37.0, 30.0, 30.0)}  # widths of the columns by the number of gears, mm


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class GearPart:
    """A part on a shaft, for its sheet.

    Attributes:
        part: the part with its gears, blank and body.
        data: names and values of the table of each gear, from below.
        pitch_diameters: diameters of the pitch circles that are drawn, mm.
        files: name and hash of each file that holds the part.
        fit: fits and joint of the bore on its shaft.
        notes: further sentences.
        simplified: whether teeth are drawn by ISO 2203, as tip circle and thin root circle.
        tip_limits: limits of each gear's tip diameter as they follow it; empty where it has none.
        run_outs: circular run-out of each gear's tip circle and of the face, mm; None where none is stated.
        pins: zone of the places of a carrier's pin holes, mm; 0 where none is stated.
        pin_class: class of a carrier's pin holes; empty where none is stated.
        parallel: parallelism of a rack's tips to its back, mm; 0 where the distance of its pinion has no tolerance.
        flank_texture: texture of the flanks of teeth; empty where it is that of the title block.
        bore_texture: texture of the bore, likewise.
    """

    part: TrainPart
    data: tuple[tuple[tuple[str, str], ...], ...]
    pitch_diameters: tuple[float, ...]
    files: tuple[tuple[str, str], ...]
    fit: ShaftFit
    notes: tuple[str, ...]
    simplified: bool = False
    tip_limits: tuple[str, ...]
    run_outs: tuple[tuple[float, float] | None, ...] = ()
    pins: float = 0.0
    pin_class: str = ""
    parallel: float = 0.0
    flank_texture: str = ""
    bore_texture: str = ""

    @property
    def tip_run_outs(self) -> tuple[float | None, ...]:
        """Run-out of the tip circle of each gear, mm; None where none is stated."""
        return tuple(None if each is None else each[0] for each in self.run_outs)

    @property
    def face_run_out(self) -> float | None:
        """Run-out of the lower face, the least that any gear of the part asks for, mm."""
        return min((each[1] for each in self.run_outs if each is not None), default=None)

    @property
    def pins_in_carrier(self) -> tuple[float, str]:
        """Diameter of a carrier's holes for pins, mm, and their class; zero and empty where none is stated."""
        return (_hole_sizes(_drilled(self.part))[0], self.pin_class) if self.pin_class else (0.0, "")

    @property
    def has_datum(self) -> bool:
        """Whether run-outs or places are stated, and there is a bore or an outer circle to count them from."""
        blank = self.part.blank
        held = bool(blank.bore_diameter) or is_ring(self.part.gears[0])
        stated = bool(self.pins) or isinstance(blank.key, Keyway) or any(each is not None for each in self.run_outs)
        return held and stated


def gear_drawing(gear: GearPart, title: Title) -> DrawingSheet:
    """Sheet A4, or A3 where the part is larger than A4 shows at 1:1."""
    rack = getattr(gear.part.gears[0], "bar", None)
    if rack is not None:
        return _rack_drawing(gear, rack, title)
    body = gear.part.body
    across, axial = 2 * _reach(body), body.slabs[-1].end - body.slabs[0].start
    widths, names, notes = _TABLE[len(gear.data)], _names(gear.part), tuple(_notes(gear))
    table_width = sum(widths)
    rows: tuple[tuple[str, ...], ...] = gear.data[0]
    if len(gear.data) > 1:
        columns = [dict(data) for data in gear.data]
        every = dict.fromkeys(name for column in columns for name in column)
        rows = (("", *names), *((name, *(column.get(name, "-") for column in columns)) for name in every))
    title_of_table = names[0] if len(names) == 1 else Message("gears")
    if len(names) == 1 and holes_of(gear.part.gears[0]):
        title_of_table = Message("carrier")

    def tables_of(size: str) -> tuple[SheetTable, ...]:
        width, height = SIZES[size]
        at = (width - EDGE - table_width, height - EDGE - 2.0)
        data = SheetTable(title=title_of_table, at=at, widths=widths, rows=rows, headed=False)
        fits = gear.fit.table(gear.part.blank, (at[0], at[1] - data.height - 2.0), gear.pins_in_carrier)
        return (data, fits) if fits else (data,)

    def columns_of(size: str) -> tuple[NoteColumn, ...]:
        return beside_title(size), over_title(tables_of(size), table_width, title)

    def holds(size: str) -> bool:
        _, under = columns_of(size)
        return under.height >= 0.0 and have_room(notes, columns_of(size))

    # The leader of a keyway's symmetry passes the frames on the left of the section.
    between = 30.0 + (12.0 if isinstance(gear.part.blank.key, Keyway) else 0.0)
    beside = table_width + 44.0 + between
    size, scale = chosen_sheet((across + axial, across), (beside, TITLE_SIZE[1] + 30.0), 1.0, 5.0, holds)
    width, height = SIZES[size]
    spare = width - LEFT - EDGE - beside - scale * (across + axial)
    middle = EDGE + TITLE_SIZE[1] + (height - 2 * EDGE - TITLE_SIZE[1]) / 2 + 2.0
    face_at = (LEFT + 14.0 + max(spare, 0.0) / 2 + scale * across / 2, middle)
    section_at = (face_at[0] + scale * across / 2 + between, middle)
    return DrawingSheet(
        size=size,
        scale=scale,
        title=title,
        views=(_face(gear, face_at, scale), _section(gear, section_at, scale)),
        tables=tables_of(size),
        notes=notes,
        columns=columns_of(size),
    )


def _rack_drawing(gear: GearPart, rack: RackForm, title: Title) -> DrawingSheet:
    """Sheet of a rack: its transverse section, and its end from the side."""
    root, tip = -rack.dedendum_factor * rack.normal_module, rack.addendum_factor * rack.normal_module
    back, length, width = -rack.back_height, rack.length, rack.width
    # Ends lean with the teeth: the face that lies behind begins this much farther to the left, mm.
    shift = width * rack.outline.run.lean
    first, last = min(0.0, -shift), length + max(0.0, -shift)
    notes, table_width = tuple(_rack_notes(gear, rack)), sum(_TABLE[1])

    def table_of(size: str) -> SheetTable:
        at = (SIZES[size][0] - EDGE - table_width, SIZES[size][1] - EDGE - 2.0)
        return SheetTable(title=Message("rack"), at=at, widths=_TABLE[1], rows=gear.data[0], headed=False)

    def columns_of(size: str) -> tuple[NoteColumn, ...]:
        return beside_title(size), over_title((table_of(size),), table_width, title)

    def holds(size: str) -> bool:
        return columns_of(size)[1].height >= 0.0 and have_room(notes, columns_of(size))

    # Teeth that lean are seen from over them, too, below the face.
    leans, below = bool(rack.helix_angle), (width, _UNDER) if rack.helix_angle else (0.0, 0.0)
    beside = (table_width + 74.0, TITLE_SIZE[1] + 40.0 + below[1])
    size, scale = chosen_sheet((last - first + width, tip - back + below[0]), beside, 1.0, 5.0, holds)
    gap, middle = _GAP / scale, EDGE + TITLE_SIZE[1] + (SIZES[size][1] - 2 * EDGE - TITLE_SIZE[1]) / 2
    under = 3.1 if leans else 2.2  # gaps from the back to the words under it
    middle += (scale * below[0] + below[1]) / 2
    face_at = (LEFT + 20.0 - scale * first, middle)
    side_at = (face_at[0] + 30.0 + scale * last, middle)
    line = np.array([[first - 0.5 * gap, 0.0], [last + 0.5 * gap, 0.0]])
    teeth: tuple[Closed | Stroke, ...] = (_outline(rack.outline), *_behind(rack.outline, shift))
    if gear.simplified:
        box = np.array([[first, back], [last, back], [last, tip], [first, tip], [first, back]])
        teeth = Stroke(box), Stroke(np.array([[first, root], [last, root]]), LineKind.THIN)
        if leans:
            x = 0.0 if shift > 0 else length
            teeth = (*teeth, Stroke(np.array([[x, back], [x, tip]])))
    half = rack.pitch / 2
    middle_of_first = np.array([[half, root], [half, tip + gap]])
    long = TEXT * WIDEST * len(rounded(half)) / 2
    first_tooth = LinearDimension(
        name="middle of the first tooth",
        start=(0.0, tip),
        end=(half, tip + gap),
        at=(0.0, tip + gap),
        beside=scale * half / 2 + TAIL + long + 1.0,
    )
    # In brackets: length, width and angle say how long it is (ISO 129-1).
    whole = LinearDimension(
        name="total length",
        start=(first, back),
        end=(last, back),
        at=(first, back - 1.9 * gap),
        prefix="(",
        suffix=")",
    )
    face = View(
        place=face_at,
        curves=(*teeth, Stroke(line, LineKind.CENTRE), Stroke(middle_of_first, LineKind.CENTRE)),
        dimensions=(
            LinearDimension(name="length", start=(0.0, back), end=(length, back), at=(0.0, back - gap)),
            *([whole] if leans else []),
            replace(upright("height to the reference line", first, (back, 0.0), first - gap, scale), exact=True),
            first_tooth,
        ),
        labels=(Label(text=Message("from the front"), at=(length / 2, back - under * gap), height=3.5),),
        symbols=(SurfaceTexture(value=gear.flank_texture, tip=(last + 0.3 * gap, 0.0)),) if gear.flank_texture else (),
    )
    corners = np.array([[0.0, back], [width, back], [width, tip], [0.0, tip], [0.0, back]])
    tips_off = f" {limits(-tip_tolerance(tip - back, rack.normal_module), 0.0)}"
    side = View(
        place=side_at,
        curves=(Stroke(corners), Stroke(np.array([[0.0, root], [width, root]]))),
        dimensions=(
            LinearDimension(name="width", start=(0.0, back), end=(width, back), at=(0.0, back - gap)),
            upright("height", width, (back, tip), width + gap, scale, suffix=tips_off),
            # In brackets: the pin says how deep it is cut.
            upright("height of the roots", width, (back, root), width + 2 * gap, scale, "(", ")"),
        ),
        labels=(Label(text=Message("from the side"), at=(width / 2, back - under * gap), height=3.5),),
    )
    if gear.parallel:
        # Over the end of the rack, towards its side; the datum on the extension line of the height.
        x, out = width / 2, _LEADER / scale
        tips = ToleranceFrame(
            name="tips",
            characteristic=Characteristic.PARALLELISM,
            zone=gear.parallel,
            datums=("A",),
            tip=(x, tip),
            bend=(x - 1e-6, tip + out),
        )
        side = replace(side, symbols=(tips,))
        face = replace(
            face,
            symbols=(
                *face.symbols,
                DatumFeature(letter="A", foot=(first - 0.45 * gap, back), angle=270.0),
            ),
        )
    over = (_over_teeth(rack, (face_at[0], middle + scale * back - below[1]), scale),) if leans else ()
    return DrawingSheet(
        size=size,
        scale=scale,
        title=title,
        views=(face, side, *over),
        tables=(table_of(size),),
        notes=notes,
        columns=columns_of(size),
    )


def _behind(outline: Loop, shift: float) -> Iterator[Stroke]:
    """Edges of a bar whose ends lean that stand out behind its face: the rim of all its sections over each other.

    Args:
        outline: section at the face that is seen.
        shift: way by which the sections behind it come to stand farther to the left, mm.
    """
    if not shift:
        return
    corners = _points(outline)
    following, away = np.roll(corners, -1, axis=0), np.array([-shift, 0.0])
    swept = [
        shapely.Polygon(each).buffer(0.0)
        for each in np.stack([corners, following, following + away, corners + away], axis=1)
    ]
    near = shapely.Polygon(corners)
    far = shapely.Polygon(corners + away)
    whole = shapely.union_all([near, far, *swept], grid_size=_GRID)
    edges = shapely.difference(whole.exterior, shapely.union_all(near.exterior, grid_size=_GRID).buffer(2 * _GRID))
    for part in shapely.get_parts(shapely.line_merge(edges)):
        yield Stroke(shapely.get_coordinates(part))


def _rack_notes(gear: GearPart, rack: RackForm) -> Iterator[str]:
    if rack.helix_angle:
        yield Message("Ends parallel to the teeth, as drawn.")
    yield Message("No holes: the design states no fastening.")
    yield from gear.notes


def _over_teeth(rack: RackForm, place: tuple[float, float], scale: float) -> View:
    """A helical rack seen on its teeth: tips, slanted ends and their angle.

    Its upper face is that of the view from the front, and lies farthest from it in the first angle of projection.

    Args:
        rack: helical rack.
        place: place of the view on the paper, mm.
        scale: mm on paper for a mm of the part.
    """
    slope = rack.width * rack.outline.run.lean  # shift of the upper face along the bar against the lower one
    near, far = -rack.width, 0.0
    ends = [(x, x - slope) for x in (0.0, rack.length)]
    for _, _, left, right, _, _ in rack.corners():
        ends += [(tip.real, tip.real - slope) for tip in (left, right)]
    curves = [Stroke(np.array([[x, near], [leaning, far]])) for x, leaning in ends]
    curves += [Stroke(np.array([[x, y], [x + rack.length, y]])) for x, y in ((0.0, near), (-slope, far))]
    radius, turned = rack.width + _LEADER / scale, 90.0 + degrees(atan2(slope, rack.width))
    curves.append(Stroke(np.array([[0.0, near], [0.0, near + radius + 2.0 / scale]]), LineKind.CENTRE))
    start, end = sorted((90.0, turned))
    lean = AngularDimension(name="helix angle", centre=(0.0, near), start=start, end=end, radius=radius)
    words = Label(text=Message("on the teeth"), at=(rack.length / 2, near - _GAP / scale), height=3.5)
    return View(place=place, curves=tuple(curves), dimensions=(lean,), labels=(words,))


def _names(part: TrainPart) -> tuple[Message, ...]:
    """Names of a part's gears."""
    return (Message("gear"),) if len(part.gears) == 1 else (Message("lower gear"), Message("upper gear"))


def _reach(body: Body) -> float:
    return max(loop.radii[1] for slab in body.slabs for loop in slab.rings)


def _points(loop: Loop) -> Array:
    corners = loop.polygon(_CHORD * loop.radii[1])
    return np.stack([corners.real, corners.imag], axis=1)


def _outline(loop: Loop, line: LineKind = LineKind.VISIBLE) -> Closed:
    points = _points(loop)
    return Closed(Contour(points, np.zeros(len(points))), line)


def _face(gear: GearPart, place: tuple[float, float], scale: float) -> View:
    """The part on its upper end, where its hub or its upper gear stands; what lies below is left out."""
    part, gap = gear.part, _GAP / scale
    blank = part.blank
    reach = _reach(part.body)
    curves: list[Closed | Stroke] = []
    inner = [part.body.slabs[0].rings[-1]] if is_ring(part.gears[0]) else []
    outlines: list[Loop] = []
    for loop in dict.fromkeys([*_rims(part.body), *inner]):
        if gear.simplified and (wheel := _toothed(loop, part)):
            curves += [ring(wheel.tip_diameter), ring(wheel.root_diameter, LineKind.THIN)]
            continue
        # The section at the upper end of the wall that begins with this one.
        slabs = [slab for slab in part.body.slabs if loop in slab.rings]
        turn = 0.0 if loop in inner else loop.run.angle(slabs[-1].end - slabs[0].start)
        outlines.append(loop.rotated(turn))
    curves += map(_outline, outlines)
    # Under a wider gear they are not seen.
    holes = () if part.gears[-1].tip_diameter > part.gears[0].tip_diameter else _drilled(part)
    curves += [_outline(hole) for hole in holes]
    if blank.bore_diameter:
        curves.append(Closed(blank.bore()))
    curves += [ring(diameter, LineKind.CENTRE) for diameter in gear.pitch_diameters]
    curves += centre_cross(reach + 0.4 * gap)
    dimensions: list[Dimension] = []
    if blank.bore_diameter and not isinstance(blank.key, Flats):
        size, fit = blank.bore_diameter, gear.fit.bore_class
        dimensions.append(DiameterDimension(name="bore", centre=(0.0, 0.0), diameter=size, angle=125.0, suffix=fit))
    if isinstance(blank.key, Keyway):
        dimensions.append(
            keyway_width(blank.key, blank.bore_diameter, 0.7 * gap, scale, gear.fit.key_class(blank.key.width))
        )
    if holes:
        centres = [complex(_points(hole).mean(axis=0) @ np.array([1.0, 1.0j])) for hole in holes]
        first = centres[len(centres) // 3]
        size, circle = _hole_sizes(holes)
        many = f"{len(holes)} × " if len(holes) > 1 else ""
        angle = degrees(atan2(first.imag, first.real))
        at = (first.real, first.imag)
        between = angle + 180 / len(holes)
        if abs(sin(radians(between))) < 0.3:  # along the plane of the section
            between += 90 / len(holes)
        dimensions += [
            DiameterDimension(
                name="hole",
                centre=at,
                diameter=size,
                angle=angle,
                prefix=many,
                suffix=f" {gear.pin_class}" if gear.pin_class else "",
            ),
            DiameterDimension(
                name="circle of holes",
                centre=(0.0, 0.0),
                diameter=circle,
                angle=between,
                exact=bool(gear.pins),
            ),
        ]
        curves.append(ring(circle, LineKind.CENTRE))
        dimensions += _apart(centres, 0.36 * circle, exact=bool(gear.pins))
    screw = ScrewHole.of(blank, part.body.radial_hole, gear.fit.thread)
    plane, letters = cutting_plane(0.0, reach + 0.3 * gap, scale)
    curves += [*(screw.face() if screw else ()), *plane]
    words = Message("upper end")
    aside = 0.0
    if isinstance(blank.key, Keyway):  # clear of the leader that comes down from the keyway
        leader = blank.bore_diameter / 2 + blank.key.depth + 0.7 * gap
        aside = min(0.0, leader - (2.0 + 3.5 * width_of(words) / 2) / scale)
    labels = (Label(text=words, at=(aside, -reach - gap), height=3.5), *letters)
    room = Room(curves, scale)
    placed = room.dimensions(dimensions, labels)
    for each in placed:
        if isinstance(each, AngularDimension):  # its extension lines
            for angle in np.radians([each.start, each.end]):
                along = (each.radius + 1.5 / scale) * np.array([np.cos(angle), np.sin(angle)])
                curves.append(Stroke(np.array([[0.0, 0.0], along]), LineKind.CENTRE))
    bores = [each for each in placed if isinstance(each, DiameterDimension) and each.name == "bore"]
    symbols: list[Symbol] = []
    wide = next((each for each in placed if isinstance(each, LinearDimension) and each.name == "keyway width"), None)
    if wide and isinstance(blank.key, Keyway):
        # To the left: frames of the section stand on the right.
        end, out = free_end(wide)
        symbols.append(
            room.frame(symmetry("keyway", off_middle(blank.key.width)), [(end, out - [1e-6, 0.0])], range(8, 60, 3))
        )
    # After the leader from the keyway, which stands in line with it and cannot give way.
    symbols += [room.datum(axis_datum("A", bore)) for bore in bores if gear.has_datum]
    if holes and gear.pins:
        # Without a bore no axis is given, and the holes are held to each other.
        pins = ToleranceFrame(
            name="pins",
            characteristic=Characteristic.POSITION,
            zone=gear.pins,
            datums=("A",) if gear.has_datum else (),
            tip=(0.0, 0.0),
            bend=(1.0, 0.0),
            diametral=True,
            combined=not gear.has_datum,
        )
        symbols.append(room.frame(pins, list(rim((centres[-1].real, centres[-1].imag), size / 2))))
    if gear.flank_texture:
        flanks = SurfaceTexture(value=gear.flank_texture, tip=(0.0, 0.0), bend=(1.0, 0.0))
        symbols += [room.frame(flanks, _leftward(_flanks(outlines, each))) for each in gear.pitch_diameters]
    if gear.bore_texture and blank.bore_diameter:
        sign = SurfaceTexture(value=gear.bore_texture, tip=(0.0, 0.0), bend=(1.0, 0.0))
        symbols.append(room.frame(sign, _leftward(outline_tips(blank.bore(), 0.0 if blank.key else None))))
    return View(
        place=place,
        curves=tuple(curves),
        dimensions=placed,
        labels=labels,
        symbols=tuple(symbols),
    )


def _apart(centres: Sequence[complex], radius: float, *, exact: bool) -> Iterator[AngularDimension]:
    """Angles from each pin's hole of a carrier to the next, but from the last, where they are not equal.

    Args:
        centres: centres of the holes, mm.
        radius: radius of the first dimension line, mm.
        exact: whether they are theoretically exact.
    """
    angles = sorted(round(degrees(phase(centre)), 9) % 360.0 for centre in centres)  # 0 is not just under 360
    if len(centres) < 2 or all(abs(end - start - 360.0 / len(angles)) < 1e-6 for start, end in pairwise(angles)):
        return
    for number, (start, end) in enumerate(pairwise(angles), 1):
        yield AngularDimension(
            name=f"pins {number} and {number + 1}", centre=(0.0, 0.0), start=start, end=end, radius=radius, exact=exact
        )


def _leftward(tips: Sequence[tuple[Array, Array]]) -> list[tuple[Array, Array]]:
    """Tips of leaders that lead to the left, since frames of the section stand on the right."""
    return [(point, out) for point, out in tips if point[0] < 0.0 and out[0] < 0.0]


def _flanks(outlines: Sequence[Loop], diameter: float) -> list[tuple[Array, Array]]:
    """Points of flanks on a pitch circle, which stand for all of its gear's (ISO 2203), each with the way outwards.

    Args:
        outlines: outlines as they are drawn; of a gear whose teeth are not, any points of its pitch circle are given.
        diameter: diameter of the pitch circle, mm.
    """
    tips = outline_tips(circle((0.0, 0.0), diameter / 2))
    crossings = [np.zeros(0, complex)]
    for corners in (_points(outline) @ np.array([1.0, 1.0j]) for outline in outlines):
        ends = np.roll(corners, -1)
        here, there = abs(corners) - diameter / 2, abs(ends) - diameter / 2
        cut = here * there < 0.0
        share = here[cut] / (here - there)[cut]
        crossings.append(corners[cut] + share * (ends - corners)[cut])
    flanks = np.concatenate(crossings)
    if not len(flanks):
        return tips
    found = []
    for point, _ in tips:
        nearest = complex(flanks[int(np.abs(flanks - complex(*point.tolist())).argmin())])
        found.append((np.array([nearest.real, nearest.imag]), np.array([nearest.real, nearest.imag]) / abs(nearest)))
    return found


def _toothed(loop: Loop, part: TrainPart) -> Wheel | None:
    """Gear of a part whose teeth an outline is; None for a plain circle."""
    for wheel in part.gears:
        tip = loop.radii[0] if is_ring(wheel) else loop.radii[1]
        if (
            wheel.outline.repeats > 1
            and abs(tip - wheel.tip_diameter / 2) < _SAME
            and loop.radii[1] - loop.radii[0] > _SAME
        ):
            return wheel
    return None


def _rims(body: Body) -> Iterator[Loop]:
    """Outlines seen from above but bores: of the highest slab, and of those below that reach further out."""
    reach = 0.0
    for slab in reversed(body.slabs):
        rings = slab.rings[:-1] if len(slab.rings) % 2 == 0 else slab.rings
        yield from (loop for loop in rings if loop.radii[1] > reach)
        reach = max(reach, slab.rings[0].radii[0])


def _drilled(part: TrainPart) -> tuple[Loop, ...]:
    """Lightening holes of a part, which are in its lower gear."""
    return next((slab.holes for slab in part.body.slabs if slab.holes), ())


def _section(gear: GearPart, place: tuple[float, float], scale: float) -> View:
    """Section through the axis along the key, which points upwards; the upper end is on the right."""
    part, gap = gear.part, _GAP / scale
    blank = part.blank
    layers = [
        Layer(slab.start, slab.end, tuple(map(_points, slab.rings)), tuple(map(_points, slab.holes)))
        for slab in part.body.slabs
    ]
    layers = [_without_teeth(layer, part) for layer in layers]
    whole = material(layers, 0.0)
    screw = ScrewHole.of(blank, part.body.radial_hole, gear.fit.thread)
    areas = screw.cut(whole, 0.0) if screw else whole
    strokes, hatches = outlines_and_hatches(areas)
    strokes += edges_behind_cut(layers, whole)
    low, high = part.body.slabs[0].start, part.body.slabs[-1].end
    strokes.append(Stroke(np.array([[low - 0.5 * gap, 0.0], [high + 0.5 * gap, 0.0]]), LineKind.CENTRE))
    dimensions: list[Dimension] = []
    keyed = blank.key is not None
    for number, (wheel, start, name) in enumerate(zip(part.gears, part.starts, _names(part), strict=True)):
        tip, end = wheel.tip_diameter / 2, start + wheel.width
        root = wheel.root_diameter / 2 if wheel.outline.repeats > 1 else tip
        corners = np.array([(start, root), (start, tip), (end, tip), (end, root)])
        strokes += [Stroke(corners * [1.0, side]) for side in (1.0, -1.0)]
        if pitch := getattr(wheel, "reference_diameter", 0.0) / 2:  # of the pitch cylinder (ISO 2203)
            line = np.array([(start - _BEYOND / scale, pitch), (end + _BEYOND / scale, pitch)])
            strokes += [Stroke(line * [1.0, side], LineKind.CENTRE) for side in (1.0, -1.0)]
        out = start - 0.9 * gap if number == 0 else end + (1.95 if keyed else 0.9) * gap
        tips = axial_diameter(f"tip diameter, {name}", start if number == 0 else end, tip, out)
        dimensions += [
            _limited(tips, gear.tip_limits[number], scale),
            along_axis(f"width, {name}", (start, end), tip, _reach(part.body) + 0.8 * gap),
        ]
    if is_ring(part.gears[0]):
        outer = rim_diameter(part.gears[0]) / 2
        dimensions.append(axial_diameter("outer diameter", high, outer, high + 1.4 * gap))
    dimensions += _lengths(part, low, high, scale, screw)
    if screw and (tapped := screw.size_in_section(0.0, _reach(part.body) + 1.7 * gap, scale)):
        dimensions.append(tapped)
    if blank.key:
        more = gear.fit.bore_class if isinstance(blank.key, Flats) else gear.fit.flat_class
        if isinstance(blank.key, Keyway):
            more = f" +{deeper(blank.key.width):g}/0"
        dimensions.append(bore_and_keyway(blank, more, high, high + 0.9 * gap, scale))
    rows_below = [
        each.at[1] for each in dimensions if isinstance(each, LinearDimension) and not each.angle and each.at[1] < 0.0
    ]
    lowest = min(rows_below, default=-_reach(part.body))
    named = {each.name: each for each in dimensions if isinstance(each, LinearDimension)}
    symbols: list[Symbol] = list(_run_outs(gear, named, scale)) if gear.has_datum else []
    if gear.has_datum and is_ring(part.gears[0]):
        symbols.append(line_datum("A", named["outer diameter"], scale))
    elif gear.has_datum and isinstance(blank.key, Flats):
        symbols.append(line_datum("A", named["across flats"], scale))
    for symbol in symbols:  # the words under the section stand below its symbols, too
        end = symbol.bend[1] if isinstance(symbol, ToleranceFrame) else lowest
        if isinstance(symbol, DatumFeature):
            end = symbol.foot[1] - symbol.reach / scale
        lowest = min(lowest, end - (FRAME_HEIGHT / 2 + 3.0) / scale + 0.9 * gap)
    turn, labels = section_title(0.0, ((low + high) / 2, lowest - 0.9 * gap), scale)
    return View(
        place=place,
        curves=(*strokes, *(screw.section(0.0) if screw else ()), *turn),
        hatches=tuple(hatches),
        dimensions=tuple(dimensions),
        labels=labels,
        symbols=tuple(symbols),
    )


def _limited(diameter: LinearDimension, limits: str, scale: float) -> LinearDimension:
    """Diameter with its limits: over its upper end where they are too long to stand between its extension lines.

    Args:
        diameter: upright diameter.
        limits: limits, with a blank before them; empty for none.
        scale: mm on paper for a mm of the part.
    """
    room = scale * length_of(diameter)
    long = TEXT * WIDEST * len(f"{diameter.prefix}{rounded(length_of(diameter))}{limits}")
    return replace(diameter, suffix=limits, beside=0.0 if room >= long else (room + long) / 2 + 1.0)


def _run_outs(gear: GearPart, named: Mapping[str, LinearDimension], scale: float) -> Iterator[ToleranceFrame]:
    """Run-outs of tip circles, on the lower extension line of each diameter, and of the lower face, on that of a width.

    Args:
        gear: part with a datum.
        named: dimensions of the section by their names.
        scale: mm on paper for a mm of the part.
    """
    names = _names(gear.part)
    for name, zone in zip(names, gear.tip_run_outs, strict=True):
        if zone is not None:
            held = named[f"tip diameter, {name}"]
            face, low = held.start[0], min(held.start[1], held.end[1])
            side = 1.0 if held.at[0] > face else -1.0
            x = face + side * _ON_LINE / scale
            yield run_out(f"tip circle, {name}", zone, (x, low), (x + side * 1e-6, low - _LEADER / scale))
    if gear.face_run_out is not None:
        width = named[f"width, {names[0]}"]
        x, y = width.start[0], width.start[1] + 0.55 * (width.at[1] - width.start[1])
        yield run_out("lower face", gear.face_run_out, (x, y), (x - 0.6 * _LEADER / scale, y))


def _without_teeth(layer: Layer, part: TrainPart) -> Layer:
    """The layer with a rim of teeth cut back to its root circle: teeth are not cut in a section (ISO 2203)."""
    reach = float(np.linalg.norm(layer.rings[0], axis=1).max())
    for wheel in part.gears:
        if is_ring(wheel):
            return Layer(layer.low, layer.high, (layer.rings[0], _circle_points(wheel.root_diameter)), layer.holes)
        toothed = wheel.outline.repeats > 1 and wheel.root_diameter < wheel.tip_diameter - 0.01
        if toothed and abs(reach - wheel.tip_diameter / 2) < 0.01:
            return Layer(layer.low, layer.high, (_circle_points(wheel.root_diameter), *layer.rings[1:]), layer.holes)
    return layer


def _circle_points(diameter: float) -> Array:
    turn = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    return np.asarray(diameter / 2 * np.stack([np.cos(turn), np.sin(turn)], axis=1))


def _lengths(part: TrainPart, low: float, high: float, scale: float, screw: ScrewHole | None) -> Iterator[Dimension]:
    """Dimensions of screw, hub and web in the section: lengths in rows below it, the shorter ones nearer."""
    blank, body, gap = part.blank, part.body, _GAP / scale
    reach, first = _reach(body), part.gears[0].width
    row = 0.8
    if screw:
        yield screw.height(first, (first, -reach - row * gap), scale, beside=-1.0)
        row += 0.9
    if blank.web and blank.hub and scale * blank.hub.length < SHORT:  # its number stands beside it, as the web's does
        row += 0.9
    if high - low > first:
        yield along_axis("length", (low, high), -reach, -reach - (row + 0.9) * gap)
    if blank.hub and blank.hub.length:
        alone, half = len(part.gears) == 1, blank.hub.diameter / 2
        end = high if alone else part.gears[0].width + blank.hub.length
        out = high + (3.0 if blank.key else 2.0) * gap
        yield axial_diameter("hub diameter" if alone else "collar diameter", end, half, out)
        if alone:
            start, at = (first, -half), (high, -reach - row * gap)
            # In brackets: width and length say how long it is (ISO 129-1).
            held = LinearDimension(name="hub length", start=start, end=(high, -half), at=at)
            yield replace(held, prefix="(", suffix=")") if high - low > first else held
    if blank.web:
        web = body.slabs[1]  # between the two recesses
        radius = (blank.hub.diameter / 2 if blank.hub else 0.0) + 0.3 * part.gears[0].root_diameter / 2
        yield axial_diameter("recess diameter", low, body.slabs[0].rings[1].radii[1], low - 1.9 * gap)
        yield along_axis("web thickness", (web.start, web.end), -radius, -reach - 0.8 * gap)
        deep = along_axis("depth of the lower recess", (low, web.start), -radius, reach + 1.7 * gap)
        long, wide = TEXT * WIDEST * len(rounded(web.start - low)), scale * (web.start - low)
        away = wide / 2 + (TAIL if wide < SHORT else 0.0) + long / 2 + 1.0
        yield replace(deep, start=(low, reach), end=(web.start, radius), beside=0.0 if wide > long + 4.0 else -away)


def _notes(gear: GearPart) -> Iterator[str]:
    for name, digest in gear.files:
        what = Message("Outline") if name.endswith(".dxf") else Message("Solid")
        yield Message("{what}: {name}  sha256 {digest}", what=what, name=name, digest=digest[:SHOWN])
    blank = gear.part.blank
    if screw := ScrewHole.of(blank, gear.part.body.radial_hole, gear.fit.thread):
        yield from gear.fit.thread_note(drawn=bool(screw.thread))
    carriers = list(map(holes_of, gear.part.gears))
    if isinstance(blank.key, Flats):
        shape = Message("hexagon") if blank.key.count == 6 else Message("square")
        yield Message("Bore: {shape}, {across:g} across flats.", shape=shape, across=blank.bore_diameter)
    # Shafts turn by themselves until their teeth mesh: no mesh asks how teeth stand to what else is on the part.
    if blank.key and not all(carriers):
        held = Message("the keyway") if isinstance(blank.key, Keyway) else Message("the flat")
        yield Message("Angle of the teeth to {feature}: free.", feature=held)
    if len(carriers) > 1 and not any(carriers):
        yield Message("Angle between the teeth of both gears: free.")
    drilled = _drilled(gear.part)
    if drilled and gear.part.gears[-1].tip_diameter > gear.part.gears[0].tip_diameter:
        diameter, circle = _hole_sizes(drilled)
        yield Message(
            "The holes, {count} × Ø{size} on Ø{circle}, are in the lower gear.",
            count=len(drilled),
            size=f"{rounded(diameter)}{limited(diameter, gear.pin_class)}",
            circle=rounded(circle),
        )
    if any(map(holes_of, gear.part.gears)) and not gear.pin_class:
        yield Message("Fit of the pins: not stated; choose it with the pins.")
    if blank.bore_diameter and gear.part.beside and not gear.fit.bore:
        pin = Message("Fit of the bore: not stated; choose it with the pin.")
        yield (
            pin
            if gear.part.figures == PLANET
            else Message("Fit of the bore: not stated; choose it with what holds the gear.")
        )
    elif blank.bore_diameter:
        yield from gear.fit.notes(blank)
    elif is_ring(gear.part.gears[0]):
        yield Message("The design states neither a fit of the outside nor what holds the ring.")
    else:
        yield Message("No bore: the design states none.")
    yield from gear.notes


def _hole_sizes(holes: tuple[Loop, ...]) -> tuple[float, float]:
    """Diameter of lightening holes and of the circle of their centres, mm."""
    (arc, *_) = (curve for curve in holes[0].curves if isinstance(curve, Arc))
    return 2 * arc.radius, 2 * abs(arc.centre)


_PLATE_GAP = 10.0  # mm on paper, likewise on the sheet of the plate
_NUMBER = 4.0  # mm on paper from a hole to the middle of its shaft's number
_OFF_CROSS = 6.0  # mm on paper from an axis without a hole to that, off the lines of its cross
_WIDTHS = (14.0, 22.0, 22.0, 36.0)


def _distances(first: Axis, second: Axis, gap: float, scale: float, suffix: str) -> Iterator[LinearDimension]:
    """Dimensions of the distance of two axes, at several distances from them on either side, mm on the part."""
    way = complex(second.x - first.x, second.y - first.y)
    for aside in (1.4, -1.4, 0.9, -0.9, 2.0, -2.0, 2.6, -2.6, 3.4, -3.4):
        middle = complex(first.x + second.x, first.y + second.y) / 2 + aside * gap * 1j * way / abs(way)
        long, room = TEXT * WIDEST * len(f"{rounded(abs(way))}{suffix}"), scale * abs(way)
        out = (room + long) / 2 + 1.0
        for beside in (0.0, 5.0, -5.0, 10.0, -10.0) if room > long else (out, -out):
            yield LinearDimension(
                name=f"axes {first.shaft} and {second.shaft}",
                start=(first.x, first.y),
                end=(second.x, second.y),
                at=(middle.real, middle.imag),
                angle=degrees(atan2(way.imag, way.real)),
                beside=beside,
                suffix=suffix,
            )


def _places(plate: Plate) -> Iterator[tuple[list[Axis], Axis]]:
    """Axes at each place of a plate, by their shafts, and the one whose hole is made there."""
    found: dict[tuple[float, float], list[Axis]] = {}
    for axis in plate.axes:
        found.setdefault((round(axis.x, 6), round(axis.y, 6)), []).append(axis)
    for alike in found.values():
        yield alike, next((axis for axis in alike if axis in plate.holed), alike[0])


def plate_drawing(
    plate: Plate,
    thickness: float,
    holes: str,
    notes: tuple[str, ...],
    title: Title,
    zones: Mapping[int, float],
    deviations: Mapping[int, float],
) -> DrawingSheet:
    """Sheet A4, or A3 where the plate is larger than A4 shows at 1:1.

    Args:
        plate: plate with its axes.
        thickness: its thickness, mm.
        holes: what the diameters of its holes are, over their column.
        notes: sentences for the shop.
        title: title block.
        zones: zones of the holes by their shafts, mm; none where the distances have no tolerance.
        deviations: deviation of the distance from each shaft to the next, mm, where it has one.
    """
    axes, (left, low, right, high) = plate.axes, plate.sides
    table_width = sum(_WIDTHS)
    beside = (table_width + (90.0 if zones else 40.0), TITLE_SIZE[1] + 30.0)
    rows: list[tuple[str, ...]] = [(Message("shaft"), "x, mm", "y, mm", holes)]
    named = [(", ".join(str(each.shaft) for each in alike), axis) for alike, axis in _places(plate)]
    for name, axis in named:
        hole = f"{axis.bore:g}{limited(axis.bore, axis.hole)}" if axis.bore else Message("none")
        rows.append((name, f"{axis.x:.3f}", f"{axis.y:.3f}", hole))
    exact = frozenset(
        (row, column) for row, (_, axis) in enumerate(named, 1) if axis.shaft in zones for column in (1, 2)
    )

    def table_of(size: str) -> SheetTable:
        at = (SIZES[size][0] - EDGE - table_width, SIZES[size][1] - EDGE - 2.0)
        words = Message("axes, from that of the drive")
        return SheetTable(title=words, at=at, widths=_WIDTHS, rows=tuple(rows), exact=exact)

    def columns_of(size: str) -> tuple[NoteColumn, ...]:
        return over_title([table_of(size)], table_width, title), beside_title(size)

    size, scale = chosen_sheet(
        (right - left, high - low), beside, 1.0, 2.0, lambda size: have_room(notes, columns_of(size))
    )
    _, height = SIZES[size]
    place = (
        LEFT + 24.0 - scale * left,
        EDGE + TITLE_SIZE[1] + 2.0 + (height - 2 * EDGE - TITLE_SIZE[1] - scale * (high - low)) / 2 - scale * low,
    )
    curves: list[Closed | Stroke] = [Closed(plate.outline)]
    tips = [ring(2 * axis.reach, LineKind.PHANTOM, (axis.x, axis.y)) for axis in axes]
    for axis in axes:
        at = (axis.x, axis.y)
        curves += centre_cross(6.0 / scale, at)
        if axis.bore:
            curves.append(ring(axis.bore, centre=at))
    gap = _PLATE_GAP / scale
    room = Room([*curves, *tips], scale)
    dimensions: list[Dimension] = [
        LinearDimension(name="plate width", start=(left, low), end=(right, low), at=(left, low - gap)),
        LinearDimension(name="plate height", start=(left, low), end=(left, high), at=(left - gap, low), angle=90.0),
        LinearDimension(
            name="axis 1 from the left", start=(left, high), end=(axes[0].x, axes[0].y), at=(left, high + 0.8 * gap)
        ),
        LinearDimension(
            name="axis 1 from below",
            start=(right, low),
            end=(axes[0].x, axes[0].y),
            at=(right + 0.8 * gap, low),
            angle=90.0,
        ),
    ]
    for dimension in dimensions:
        room.take(dimension)
    labels = []
    for name, axis in named:
        off, wider = max(scale * axis.bore / 2 + _NUMBER, _OFF_CROSS), 3.5 * (width_of(name) - WIDEST) / 2
        labels.append(room.label(name, (axis.x, axis.y), off, 3.5, (wider, 0.0)))
    for first, second in pairwise(axes):
        if (first.x, first.y) != (second.x, second.y):
            exact_one, off = second.shaft in zones, deviations.get(first.shaft, 0.0)
            suffix = f" {limits(-off, off)}" if off and not exact_one else ""
            placed = room.linear(_distances(first, second, gap, scale, suffix))
            dimensions.append(replace(placed, exact=exact_one))
    if not zones:  # else a view from the side has it
        middle, half = ((left + right) / 2, (low + high) / 2), (scale * (right - left) / 2, scale * (high - low) / 2)
        labels.append(room.within(f"t = {rounded(thickness)}", middle, _NUMBER, half))
    located = [axis for axis in plate.holed if axis.shaft in zones]
    seats = [(f"hole of shaft {each.shaft}", (each.x, each.y), each.bore, zones[each.shaft]) for each in located]
    symbols = tuple(hole_frames(seats, room))
    for tip in tips:
        curves += room.off_texts(tip)
    views = [
        View(
            place=place,
            curves=tuple(curves),
            dimensions=tuple(dimensions),
            labels=tuple(labels),
            symbols=symbols,
        )
    ]
    if seats:
        aside = (place[0] + scale * right + _PLATE_GAP + 18.0, place[1])
        views.append(edge_view(thickness, (low, high), [(each.y, each.bore) for each in plate.holed], aside, scale))
    return DrawingSheet(
        size=size,
        scale=scale,
        title=title,
        views=tuple(views),
        tables=(table_of(size),),
        notes=notes,
        columns=columns_of(size),
    )
