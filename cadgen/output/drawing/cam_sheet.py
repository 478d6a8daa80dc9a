"""Sheet of a cam: face, section, radii by the angle, and what a shop has to know of it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import atan2, ceil, cos, degrees, sin

import numpy as np
import shapely

from cadgen.arrays import TURN, Array
from cadgen.curves.contour import Contour, circle
from cadgen.messages import Message
from cadgen.output.drawing.cam_turns import OutlineTurn
from cadgen.output.drawing.hole_frames import outline_tips
from cadgen.output.drawing.placement import Room
from cadgen.output.drawing.section import Layer, ScrewHole, edges_behind_cut, material, outlines_and_hatches
from cadgen.output.drawing.shaft_fit import ShaftFit, deeper, off_middle
from cadgen.output.drawing.sheet import (
    BEYOND,
    EDGE,
    FRAME_HEIGHT,
    LEFT,
    SHORT,
    SHOWN,
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
    EdgeState,
    Label,
    LinearDimension,
    LineKind,
    NoteColumn,
    RadiusDimension,
    SheetTable,
    Stroke,
    SurfaceTexture,
    Symbol,
    Title,
    ToleranceFrame,
    View,
    along_axis,
    arrow,
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
    over_title,
    ring,
    rounded,
    section_title,
    symmetry,
)
from cadgen.output.drawing.timing import TimingDiagram
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face
from cadgen.parts.features import DFlat, Keyway

EVERY = 10  # degrees between the rows of the table of radii
_CHORD = 0.01  # mm, of outlines in a section
_GAP = 9.0  # mm on paper from the part to a dimension line, and from line to line
_BEFORE = 17.0  # mm on paper between frame and face
_COLUMN = 31.0  # width of each of the tables of radii, and what is between them, mm
_TABLES = 3 * _COLUMN
_ARROW = 14.0  # mm on paper of the arrow at the zero mark
_SHARP, _LEANING = 0.05, 0.02  # mm off sharp edges (ISO 13715), and off those on which a follower leans
_TURNED = 1e-6  # rad, within which two directions are one
_FRAMED = 2 * FRAME_HEIGHT  # mm on paper under a section, of a frame and its leader
_STRAIGHT = 1000.0  # mm, of radii of curvature beyond which an outline is straight
_STEEP = 0.35  # of the sine of the angle between that arrow and the plane of the section


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class SheetGroove:
    """Groove of a cam, for its sheet.

    Attributes:
        outer: outer flank as lines and arcs, mm.
        radii: distance of the exact outer flank from the axis at the angles of the table, mm.
        turns: points where the outer flank turns.
        path: path of the roller's centre, shape (n, 2), mm.
        across: points of the inner and the outer flank that are nearest to each other, mm, shape (2, 2).
        outside_radius: radius of the disc, mm.
        depth: depth, mm.
    """

    outer: Contour
    radii: Array
    turns: tuple[OutlineTurn, ...]
    path: Array
    across: Array
    outside_radius: float
    depth: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Neighbour:
    """Other disc of a conjugate pair, beside this one on the shaft.

    Attributes:
        word: what it is, for people.
        radius: its greatest radius, mm.
        gap: distance of its nearer face, mm.
        thickness: its thickness, mm.
        side: 1 on the side of the face that is seen, -1 on the other.
    """

    word: str
    radius: float
    gap: float
    thickness: float
    side: int

    @property
    def room(self) -> float:
        """Length of the shaft from this disc to its far face, mm."""
        return self.gap + self.thickness


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class CamPart:
    """A cam, for its sheet.

    Attributes:
        profile: outline as lines and arcs, mm.
        angles: polar angles of the table, rad, shape (n,).
        radii: distance of the exact outline from the axis there, mm.
        greatest: greatest radius of the outline, and its polar angle: mm, rad.
        least: least radius, likewise.
        turns: points where the outline turns, or the inner flank of a groove.
        blank: bore, keyway, hub, holes, broken edges.
        thickness: between the faces, mm.
        fit: fits and joint of the bore on its shaft.
        profile_tolerance: half width of the zone of the outline, mm; None if none is given.
        follower: name of the follower.
        on_ray: name of what stands on the ray of the cam angle.
        sizes: follower and its sizes, in a sentence.
        leans: whether it leans on an edge of the rim, so that a broken edge moves it.
        face: words for the face that is seen.
        files: name and hash of each file that holds the outline.
        notes: further sentences.
        thickness_limits: limits of the thickness as they follow it; empty where it has the general tolerance.
        edge_limits: limits of the leg of broken edges, likewise.
        taper: perpendicularity of the rim to a face, mm; 0 where nothing is said of it.
        base_radius: radius of the base circle, mm; None of a cam that has none.
        timing: timing diagram; None of a cam whose motion is a car's.
        groove: groove of which the outline is the inner flank; None for a disc whose rim is the outline.
        rim_texture: texture of the rim, or of the flanks of the groove; empty where it is that of the title block.
        bore_texture: texture of the bore, likewise.
        neighbour: other disc of a conjugate pair; None where it is not at a stated distance.
    """

    profile: Contour
    angles: Array
    radii: Array
    greatest: tuple[float, float]
    least: tuple[float, float]
    turns: tuple[OutlineTurn, ...]
    blank: Blank
    thickness: float
    fit: ShaftFit
    profile_tolerance: float | None
    follower: str
    on_ray: str
    sizes: str
    leans: bool
    face: str
    files: tuple[tuple[str, str], ...]
    notes: tuple[str, ...]
    thickness_limits: str = ""
    edge_limits: str = ""
    taper: float = 0.0
    base_radius: float | None = None
    timing: TimingDiagram | None = None
    groove: SheetGroove | None = None
    rim_texture: str = ""
    bore_texture: str = ""
    neighbour: Neighbour | None = None

    @property
    def reach(self) -> float:
        """Greatest distance of the disc from its axis, mm."""
        return self.greatest[0] if self.groove is None else self.groove.outside_radius


def cam_drawing(cam: CamPart, title: Title) -> DrawingSheet:
    """Sheet A4, or A3 where the cam is larger than A4 shows at 1:1."""
    across, hub, timing = 2 * cam.reach, cam.blank.hub, cam.timing
    axial = cam.thickness + (hub.length if hub else 0.0) + (cam.neighbour.room if cam.neighbour else 0.0)
    notes = tuple(_notes(cam))

    def tables_of(size: str) -> tuple[SheetTable, ...]:
        width, height = SIZES[size]
        radii = _radii(cam, (width - EDGE - _TABLES, height - EDGE - 2.0))
        tables = [*radii, _turns(cam, (radii[0].at[0], radii[0].at[1] - radii[0].height - 2.0))]

        def below() -> tuple[float, float]:
            return tables[-1].at[0], tables[-1].at[1] - tables[-1].height - 2.0

        if segments := timing.table(below()) if timing else None:
            tables.append(segments)
        if fits := cam.fit.table(cam.blank, below()):
            tables.append(fits)
        return tuple(tables)

    def columns_of(size: str) -> tuple[NoteColumn, ...]:
        over, beside = over_title(tables_of(size), _TABLES, title), beside_title(size)
        if timing is None:
            return over, beside
        # The timing diagram stands beside the title block, and leaves notes a column there that have no other room.
        if size == "A4" or have_room(notes, (over,)):
            return (over,)
        x, y = beside.at
        return over, replace(beside, at=(x + beside.width - _TABLES, y), width=_TABLES)

    # Beside the views: arrows of the section, dimensions of the hub; under them: their names.
    between, after = (40.0 if hub and hub.side == Face.INNER else 27.0), 24.0
    # And the dimension of the depth of a groove, and the frame of the rim.
    letters = max(_letters_below(cam), _GAP if cam.groove else 0.0, _FRAMED if cam.taper else 0.0)
    # The arrow at the zero mark may stand at the greatest radius, and the plane of the section ends beyond it.
    before = _BEFORE + (9.0 if timing else 0.0)
    beside, under = before + between + after + _TABLES, title.height + 29.0 + letters
    size, scale = chosen_sheet(
        (across + axial, across), (beside, under), 1.0, 2.0, lambda size: have_room(notes, columns_of(size))
    )
    _, height = SIZES[size]
    least = EDGE + title.height + 18.0 + letters + scale * across / 2
    face_at = (LEFT + before + scale * across / 2, max(least, height / 2 + 5.0))
    below = hub.length if hub and hub.side == Face.INNER else 0.0
    if cam.neighbour and cam.neighbour.side < 0:
        below = cam.neighbour.room
    section_at = (face_at[0] + scale * (across / 2 + below) + between, face_at[1])
    return DrawingSheet(
        size=size,
        scale=scale,
        title=title,
        views=(
            _face(cam, face_at, scale),
            _section(cam, section_at, scale),
            *([timing.view(beside_title(size).width - _TABLES * (len(columns_of(size)) - 1), scale)] if timing else []),
        ),
        tables=tables_of(size),
        notes=notes,
        columns=columns_of(size),
    )


def _face(cam: CamPart, place: tuple[float, float], scale: float) -> View:
    blank, reach, holes = cam.blank, cam.reach, cam.blank.lightening
    zero = reach if cam.groove else float(np.interp(0.0, cam.angles, cam.radii, period=TURN))
    gap = _GAP / scale
    curves: list[Closed | Stroke] = [
        Closed(cam.profile),
        Closed(blank.bore()),
        *([ring(holes.circle_diameter, LineKind.CENTRE)] if holes and holes.circle_diameter else []),
        *(Closed(hole) for hole in blank.holes()),
        *centre_cross(reach + 0.4 * gap),
        *_polar_lines(cam),
    ]
    if cam.base_radius:
        curves.append(ring(2 * cam.base_radius, LineKind.PHANTOM))
    if cam.groove:
        groove = cam.groove
        curves += [Closed(groove.outer), ring(2 * reach), Stroke(groove.path, LineKind.CENTRE)]
    labels = [
        Label(text="0°", at=(zero + 0.6 * _ARROW / scale, 2.2 / scale)),
        Label(
            text=Message("{face}: this face up", face=cam.face),
            at=(0.0, -reach - 1.1 * gap - _letters_below(cam) / scale),
            height=3.5,
        ),
    ]
    start, tip = (np.array([zero + out / scale, 0.0]) for out in (_ARROW, 0.8))
    curves += arrow(start, tip, (2.5 / scale, 2.5 / scale / 3))
    strokes, word = _counted(cam, zero, scale)
    curves += strokes
    labels.append(word)
    if blank.hub:
        seen = LineKind.VISIBLE if blank.hub.side == Face.OUTER else LineKind.HIDDEN
        curves.append(ring(blank.hub.diameter, seen))
    screw = _screw(cam)
    curves += screw.face() if screw else ()
    angle = _cut_angle(cam)
    # Beside the arrow at the zero mark there is no room for the end of the plane.
    end = reach + 0.4 * gap if abs(sin(angle)) > _STEEP else max(reach, zero + _ARROW / scale) + 1.0 / scale
    plane, letters = cutting_plane(angle, end, scale)
    curves += plane
    labels += letters
    if cam.timing:
        strokes, word = _sense(cam, scale)
        curves += strokes
        labels.append(word)
    room = Room(curves, scale)
    every = _face_dimensions(cam, scale)
    if screw and not screw.size_in_section(angle, 0.0, scale):
        every.append(screw.size_on_face(0.7 * gap, scale))
    dimensions = room.dimensions(every, labels)
    return View(
        place=place,
        curves=tuple(curves),
        dimensions=dimensions,
        labels=tuple(labels),
        symbols=tuple(_symbols(cam, room, dimensions, scale)),
    )


def _symbols(cam: CamPart, room: Room, dimensions: Sequence[Dimension], scale: float) -> Iterator[Symbol]:
    """Tolerance of the outline, to the axis of the bore and the middle of its keyway or flat; sharp edges; textures.

    Args:
        cam: cam.
        room: room in the view of its face.
        dimensions: dimensions of that view, as they are placed.
        scale: mm on paper for a mm of the part.
    """
    yield from _frames(cam, room, dimensions, scale)
    if not cam.blank.edge_break:
        flanks = (cam.profile,) if cam.groove is None else (cam.profile, cam.groove.outer)
        count, size = 3 - len(flanks), _LEANING if cam.leans else _SHARP
        for flank in flanks:
            yield room.frame(EdgeState(count=count, size=size, tip=(0.0, 0.0), bend=(1.0, 0.0)), outline_tips(flank))
    if cam.rim_texture:
        outline = cam.profile if cam.groove is None else cam.groove.outer
        sign = SurfaceTexture(value=cam.rim_texture, tip=(0.0, 0.0), bend=(1.0, 0.0), all_around=True)
        yield room.frame(sign, outline_tips(outline))
        if cam.groove is not None:
            yield room.frame(sign, outline_tips(cam.profile))
    if cam.bore_texture:
        sign = SurfaceTexture(value=cam.bore_texture, tip=(0.0, 0.0), bend=(1.0, 0.0))
        yield room.frame(sign, outline_tips(cam.blank.bore(), cam.blank.key.angle if cam.blank.key else None))


def _frames(
    cam: CamPart, room: Room, dimensions: Sequence[Dimension], scale: float
) -> Iterator[ToleranceFrame | DatumFeature]:
    """Datums, the symmetry of a keyway, and the tolerance of the outline, or of both flanks of a groove.

    Args:
        cam: cam.
        room: room in the view of its face.
        dimensions: dimensions of that view, as they are placed.
        scale: mm on paper for a mm of the part.
    """
    named, letters = {dimension.name: dimension for dimension in dimensions}, _datums(cam)
    if not letters:
        return
    bore = named["bore"]
    assert isinstance(bore, DiameterDimension)
    yield room.datum(axis_datum("A", bore))
    if isinstance(cam.blank.key, Keyway):
        width = named["keyway width"]
        assert isinstance(width, LinearDimension)
        end, out = free_end(width)
        # To either side where the leader is upright.
        ways = [(end, out + side * np.array([1e-6, 0.0])) for side in (-1.0, 1.0)]
        keyway = room.frame(symmetry("keyway", off_middle(cam.blank.key.width)), ways, range(8, 60, 3))
        yield keyway
        if "B" in letters:  # the middle of the keyway, as the frame is of it
            yield room.hung("B", keyway)
    elif "B" in letters:
        across = named["across the flat"]
        assert isinstance(across, LinearDimension)
        yield room.datum(_middle_datum("B", across, scale))
    if cam.profile_tolerance is None:
        return
    flanks = (
        {"outline": cam.profile}
        if cam.groove is None
        else {"inner flank": cam.profile, "outer flank": cam.groove.outer}
    )
    for name, contour in flanks.items():
        frame = ToleranceFrame(
            name=name,
            characteristic=Characteristic.LINE_PROFILE,
            zone=2 * cam.profile_tolerance,
            datums=letters,
            tip=(0.0, 0.0),
            bend=(1.0, 0.0),
            all_around=True,
        )
        yield room.frame(frame, outline_tips(contour))


def _middle_datum(letter: str, held: LinearDimension, scale: float) -> DatumFeature:
    """Datum that is the middle of a width: its triangle in line with the dimension, at the end without the number.

    Args:
        letter: letter of the datum.
        held: dimension of the width.
        scale: mm on paper for a mm of the part.
    """
    end, out = free_end(held)
    # An arrow that points inwards for want of room has its tail outside.
    x, y = (end + (TAIL / scale if scale * length_of(held) < SHORT else 0.0) * out).tolist()
    return DatumFeature(letter=letter, foot=(x, y), angle=held.angle + (180.0 if held.beside > 0 else 0.0))


def _sense(cam: CamPart, scale: float) -> tuple[list[Stroke], Label]:
    """Arrow of the sense in which the disc turns, clockwise on the face that is seen, and its word."""
    radius = cam.reach + 0.62 * _GAP / scale
    # Away from the zero mark, from both ends of the plane of the section, and from the words under the face.
    cut = _cut_angle(cam)
    middle = max(
        np.radians([45.0, 70.0, 110.0, 135.0]),
        key=lambda angle: min(abs(sin(angle - cut)), abs(sin(angle))),
    )
    half = 9.0 / scale / radius
    angles = np.linspace(middle + half, middle - half, 25)
    points = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    tip, back = points[-1], points[-2]
    ahead = tip + (tip - back) * 1e-3
    strokes = [Stroke(points, LineKind.THIN), arrow(tip, ahead, (2.5 / scale, 0.8 / scale), LineKind.THIN)[1]]
    x, y = ((radius + 3.2 / scale) * np.array([cos(middle), sin(middle)])).tolist()
    return strokes, Label(text=Message("turns"), at=(x, y))


def _counted(cam: CamPart, zero: float, scale: float) -> tuple[list[Stroke], Label]:
    """Arrow of the sense in which polar angles count, from the ray of the zero mark, and its letter.

    Args:
        cam: cam.
        zero: radius at the zero mark, mm.
        scale: mm on paper for a mm of the part.
    """
    near = np.interp(np.linspace(0.0, 0.3, 16), cam.angles, cam.radii, period=TURN)
    radius = zero + _ARROW / scale if cam.groove else max(zero + _ARROW / scale, float(near.max()) + 4.0 / scale)
    angles = np.linspace(1.5, 9.5, 17) / scale / radius
    points = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    ahead = points[-1] + (points[-1] - points[-2]) * 1e-3
    strokes = [Stroke(points, LineKind.THIN), arrow(points[-1], ahead, (2.5 / scale, 0.8 / scale), LineKind.THIN)[1]]
    x, y = points[-1].tolist()
    return strokes, Label(text="θ", at=(x + 1.5 / scale, y + 1.5 / scale))


def _angles(cam: CamPart) -> Iterator[tuple[str, float, float]]:
    """Name, polar angle (rad) and distance from the axis (mm) of features that are not on the ray of the zero mark."""
    blank, held = cam.blank, cam.blank.key
    if held:
        name = "keyway angle" if isinstance(held, Keyway) else "flat angle"
        yield from _turned(name, held.angle, 0.5 * (cam.least[0] + blank.bore_diameter / 2))
    holes = blank.lightening
    if holes and holes.circle_diameter and not _one_way(holes.count * holes.start_angle):
        yield from _turned("hole angle", holes.start_angle, holes.circle_diameter / 2)
    if blank.mark:
        yield from _turned("mark angle", blank.mark.angle, blank.mark.radius)
    if (screw := _screw(cam)) and not (held and _one_way(screw.hole.angle - held.angle)):
        yield from _turned("set screw angle", screw.hole.angle, screw.outer + 3.0)


def _turned(name: str, angle: float, radius: float) -> Iterator[tuple[str, float, float]]:
    if not _one_way(angle):
        yield name, angle, radius


def _one_way(angle: float) -> bool:
    return cos(angle) > 1 - _TURNED**2 / 2


def _polar_lines(cam: CamPart) -> Iterator[Stroke | Closed]:
    """Centre lines to features at an angle, and the circle of the mark."""
    for _, angle, radius in _angles(cam):
        along = np.array([cos(angle), sin(angle)])
        yield Stroke(np.array([np.zeros(2), 1.15 * radius * along]), LineKind.CENTRE)
    if cam.blank.mark:
        yield ring(2 * cam.blank.mark.radius, LineKind.CENTRE)


def _face_dimensions(cam: CamPart, scale: float) -> list[Dimension]:
    blank, gap = cam.blank, _GAP / scale
    exact = cam.profile_tolerance is not None  # the frame of the outline then holds it
    aside = degrees(blank.key.angle if blank.key else 0.0) + 125.0
    dimensions: list[Dimension] = [
        DiameterDimension(
            name="bore", centre=(0.0, 0.0), diameter=blank.bore_diameter, angle=aside, suffix=cam.fit.bore_class
        )
    ]
    match blank.key:
        case Keyway():
            dimensions.append(
                keyway_width(blank.key, blank.bore_diameter, 0.7 * gap, scale, cam.fit.key_class(blank.key.width))
            )
        case DFlat(depth=depth, angle=angle):
            radius, c, s = blank.bore_diameter / 2, cos(angle), sin(angle)
            off = radius + 1.5 * gap  # under the letter of the bore's axis
            dimensions.append(
                LinearDimension(
                    name="across the flat",
                    start=(-radius * c, -radius * s),
                    end=((radius - depth) * c, (radius - depth) * s),
                    at=(off * s, -off * c),
                    angle=degrees(angle),
                    suffix=cam.fit.flat_class,
                )
            )
    if blank.mark:
        dimensions.append(
            DiameterDimension(
                name="mark",
                centre=blank.mark.centre,
                diameter=blank.mark.diameter,
                angle=degrees(blank.mark.angle),
                suffix=Message(" mark"),
            )
        )
        dimensions.append(
            RadiusDimension(name="circle of the mark", centre=(0.0, 0.0), radius=blank.mark.radius, angle=aside + 100.0)
        )
    if cam.base_radius:
        circle_of_base = RadiusDimension(
            name="base circle",
            centre=(0.0, 0.0),
            radius=cam.base_radius,
            angle=degrees(cam.least[1]),
            exact=exact,
        )
        dimensions.append(circle_of_base)
    if cam.groove:
        inner, outer = cam.groove.across
        way = outer - inner
        dimensions += [
            DiameterDimension(
                name="outside", centre=(0.0, 0.0), diameter=2 * cam.groove.outside_radius, angle=aside + 115.0
            ),
            LinearDimension(
                name="groove width",
                start=(float(inner[0]), float(inner[1])),
                end=(float(outer[0]), float(outer[1])),
                at=(float(inner[0]), float(inner[1])),
                angle=degrees(atan2(way[1], way[0])),
                beside=scale * float(np.hypot(*way)) / 2 + BEYOND,
                exact=exact,
            ),
        ]
    ring_of_holes = blank.lightening
    if ring_of_holes and ring_of_holes.circle_diameter:
        x, y = ring_of_holes.centers()[ring_of_holes.count // 3].tolist()
        many = f"{ring_of_holes.count} × " if ring_of_holes.count > 1 else ""
        dimensions += [
            DiameterDimension(
                name="hole",
                centre=(x, y),
                diameter=ring_of_holes.hole_diameter,
                angle=degrees(atan2(y, x)),
                prefix=many,
            ),
            DiameterDimension(
                name="circle of holes",
                centre=(0.0, 0.0),
                diameter=ring_of_holes.circle_diameter,
                angle=degrees(ring_of_holes.start_angle) + 180.0 + 180 / ring_of_holes.count,
            ),
        ]
    for name, angle, radius in _angles(cam):
        turn = degrees(angle) % 360
        start, end = (0.0, turn) if turn <= 180.0 else (turn, 360.0)
        dimensions.append(AngularDimension(name=name, centre=(0.0, 0.0), start=start, end=end, radius=radius))
    return dimensions


def _section(cam: CamPart, place: tuple[float, float], scale: float) -> View:
    """Section through the axis along the key, which points upwards; the face that is seen is on the right."""
    blank, thickness, gap = cam.blank, cam.thickness, _GAP / scale
    angle = _cut_angle(cam)
    boss, bore = blank.boss(thickness), blank.bore().polygon(_CHORD)
    profile, holes = cam.profile.polygon(_CHORD), tuple(hole.polygon(_CHORD) for hole in blank.holes())
    if cam.groove is None:
        layers = [Layer(0.0, thickness, (profile, bore), holes)]
    else:
        floor, flank = thickness - cam.groove.depth, cam.groove.outer.polygon(_CHORD)
        rim = circle((0.0, 0.0), cam.groove.outside_radius).polygon(_CHORD)
        layers = [
            Layer(0.0, floor, (rim, bore), holes),
            Layer(floor, thickness, (rim, flank, profile, bore), holes),
        ]
    if boss:
        layers.append(Layer(boss.low, boss.high, (circle((0.0, 0.0), boss.diameter / 2).polygon(_CHORD), bore)))
    areas = [_chamfered(area, cam) for area in material(layers, angle)]
    screw = _screw(cam)
    whole, areas = areas, screw.cut(areas, angle) if screw else areas
    strokes, hatches = outlines_and_hatches(areas)
    strokes += edges_behind_cut(layers, whole)
    top = max(area.bounds[3] for area in areas)
    low = min(area.bounds[0] for area in areas)
    high = max(area.bounds[2] for area in areas)
    over, beside = top, tuple[Label, ...]()
    if other := cam.neighbour:
        face = thickness if other.side > 0 else 0.0
        near, far = face + other.side * other.gap, face + other.side * other.room
        low, high, over = min(low, far), max(high, far), max(top, other.radius)
        strokes.append(_phantom(near, far, other.radius))
        beside = (Label(text=other.word, at=((near + far) / 2, -other.radius - 3.5 / scale)),)
    axis = Stroke(np.array([[low - 0.5 * gap, 0.0], [high + 0.5 * gap, 0.0]]), LineKind.CENTRE)
    thick = replace(along_axis("thickness", (0.0, thickness), top, over + 0.8 * gap), suffix=cam.thickness_limits)
    long = TEXT * WIDEST * len(rounded(thickness) + thick.suffix)
    if cam.thickness_limits and scale * thickness < long + 2.0:
        thick = replace(thick, beside=scale * thickness / 2 + max(TAIL, 1.0) + long / 2 + 1.0)
    dimensions: list[Dimension] = [thick]
    if other:
        apart = along_axis("gap between the discs", (min(near, face), max(near, face)), top, over + 1.7 * gap)
        apart = replace(apart, prefix="(", suffix=")")  # auxiliary: not of this part, but of how it is set
        room = TEXT * WIDEST * len(f"({rounded(other.gap)})")
        narrow = scale * other.gap < room + 6.0
        dimensions.append(replace(apart, beside=scale * other.gap / 2 + TAIL + room / 2 + 1.0 if narrow else 0.0))
    if leg := blank.edge_break:
        said = f" × 45°{cam.edge_limits}"
        dimensions.append(
            LinearDimension(
                name="edge break",
                start=(thickness - leg, top),
                end=(thickness, top),
                at=(thickness, over + 2.5 * gap),
                prefix="2 × ",
                suffix=said,
                beside=TAIL + TEXT * WIDEST * len(f"2 × {rounded(leg)}{said}") / 2 + 1.0,
            )
        )
    if cam.groove:
        bottom = min(area.bounds[1] for area in areas)
        dimensions.append(along_axis("groove depth", (floor, thickness), bottom, bottom - 0.8 * gap))
    if isinstance(blank.key, Keyway):
        side = boss.high if boss else thickness
        at = max(side, high if other else thickness) + gap
        dimensions.append(bore_and_keyway(blank, f" +{deeper(blank.key.width):g}/0", side, at, scale))
    if boss:
        outer, half = boss.high > thickness, boss.diameter / 2
        end = boss.high if outer else boss.low
        dimensions += [
            along_axis("hub length", (boss.low, boss.high), -half, -half - 1.6 * gap),
            axial_diameter("hub diameter", end, half, end + (2.0 if outer else -1.0) * gap),
        ]
    if screw and (tapped := screw.size_in_section(angle, top + 1.7 * gap, scale)):
        dimensions.append(tapped)
    if boss and screw:
        face, side = (thickness, 1.0) if boss.high > thickness else (0.0, -1.0)
        dimensions.append(screw.height(face, (face + side, -boss.diameter / 2 - 0.8 * gap), scale, beside=side))
    deepest = max(cam.reach, other.radius + 6.0 / scale) if other else cam.reach
    middle, under = (low + high) / 2, -deepest - (2.0 if cam.groove else 1.1) * gap
    symbols = _taper_symbols(cam, areas, scale) if cam.taper else ()
    if symbols:
        under -= _FRAMED / scale
    turn, title = section_title(angle, (middle, under), scale)
    labels = (
        *title,
        Label(text=Message("{face} on the right", face=cam.face), at=(middle, under - 5.0 / scale)),
        *beside,
    )
    return View(
        place=place,
        curves=(*strokes, *(screw.section(angle) if screw else ()), axis, *turn),
        hatches=tuple(hatches),
        dimensions=tuple(dimensions),
        labels=labels,
        symbols=symbols,
    )


def _phantom(near: float, far: float, radius: float) -> Stroke:
    """Outline of an adjacent part in a section (ISO 128).

    Args:
        near: height of its nearer face, mm.
        far: height of its other face, mm.
        radius: its radius, mm.
    """
    corners = [[near, -radius], [far, -radius], [far, radius], [near, radius], [near, -radius]]
    return Stroke(np.array(corners), LineKind.PHANTOM)


def _taper_symbols(cam: CamPart, areas: Sequence[shapely.Polygon], scale: float) -> tuple[DatumFeature, ToleranceFrame]:
    """Perpendicularity of the rim to the face on the left, whose letter follows those of the outline's frame.

    Args:
        cam: cam.
        areas: cut areas of the section, mm.
        scale: mm on paper for a mm of the part.
    """
    lowest = min(areas, key=lambda area: area.bounds[1])
    _, rim, _, top = lowest.bounds
    letter = "ABC"[len(_datums(cam))]
    x = cam.thickness / 2
    frame = ToleranceFrame(
        name="rim",
        characteristic=Characteristic.PERPENDICULARITY,
        zone=cam.taper,
        datums=(letter,),
        tip=(x, rim),
        bend=(x + 1e-6, rim - 0.8 * _FRAMED / scale),
    )
    return DatumFeature(letter=letter, foot=(0.0, rim + 0.4 * (top - rim)), angle=180.0), frame


def _datums(cam: CamPart) -> tuple[str, ...]:
    """Letters of the datums on the face: axis of the bore, and middle of its keyway or flat for the outline's frame."""
    if cam.profile_tolerance is None:
        return ("A",) if isinstance(cam.blank.key, Keyway) else ()
    return ("A", "B") if isinstance(cam.blank.key, Keyway | DFlat) else ("A",)


def _cut_angle(cam: CamPart) -> float:
    """Direction of the plane of the section, rad: along the key, or the zero mark."""
    return cam.blank.key.angle if cam.blank.key else 0.0


def _letters_below(cam: CamPart) -> float:
    """Room under the face for the end of the plane of the section, mm on paper."""
    return 7.0 if abs(sin(_cut_angle(cam))) > _STEEP else 0.0


def _screw(cam: CamPart) -> ScrewHole | None:
    boss = cam.blank.boss(cam.thickness)
    return ScrewHole.of(cam.blank, boss.drill if boss else None, cam.fit.thread)


def _chamfered(area: shapely.Polygon, cam: CamPart) -> shapely.Polygon:
    """Area of the section with the broken edges of the outline taken off."""
    leg, thickness = cam.blank.edge_break, cam.thickness
    if not leg:
        return area
    _, low, _, high = area.bounds
    for r, inwards in ((high, -1.0), (low, 1.0)):
        if abs(r) < cam.least[0] - leg:
            continue  # the bore's side
        for z, along in ((0.0, 1.0), (thickness, -1.0)):
            corner = shapely.Polygon([(z, r), (z + along * leg, r), (z, r + inwards * leg)])
            area = shapely.difference(area, corner)
    return area


def _radii(cam: CamPart, at: tuple[float, float]) -> tuple[SheetTable, ...]:
    """Radius of the outline by the polar angle, in three tables beside each other; of both flanks, in two."""
    if cam.groove is not None:
        return _flank_radii(cam, cam.groove, at)
    head = ("θ, °", "R, mm")
    cells = [
        (rounded(degrees(angle), 1), f"{radius:.3f}")
        for angle, radius in zip(cam.angles.tolist(), cam.radii.tolist(), strict=True)
    ]
    third = ceil(len(cells) / 3)
    return tuple(
        SheetTable(
            title=Message("outline about the axis") if number == 0 else "",
            at=(at[0] + number * _COLUMN, at[1]),
            widths=(13.0, 17.0),
            rows=(head, *cells[number * third : (number + 1) * third]),
            exact=_exact(cam, len(cells[number * third : (number + 1) * third]), (0, 1)),
        )
        for number in range(3)
    )


def _exact(cam: CamPart, rows: int, columns: Sequence[int]) -> frozenset[tuple[int, int]]:
    """Cells of a table under its head that the frame of the outline makes theoretically exact; none without it."""
    if cam.profile_tolerance is None:
        return frozenset()
    return frozenset((row, column) for row in range(1, rows + 1) for column in columns)


def _turns(cam: CamPart, at: tuple[float, float]) -> SheetTable:
    """Points where the outline turns, between the rows of the table of radii too."""
    named = [(turn.word, turn) for turn in cam.turns]
    if cam.groove is not None:
        named = [(Message("inner: {point}", point=word), turn) for word, turn in named]
        named += [(Message("outer: {point}", point=turn.word), turn) for turn in cam.groove.turns]
    rows = [
        (
            word,
            rounded(degrees(turn.angle), 1),
            f"{turn.radius:.3f}",
            rounded(turn.bend, 1) if turn.bend < _STRAIGHT else "∞",
        )
        for word, turn in named
    ]
    return SheetTable(
        title=Message("turning points; ρ: radius of curvature"),
        at=at,
        widths=(38.0, 13.0, 17.0, 15.0),
        rows=(("", "θ, °", "R, mm", "ρ, mm"), *rows),
        exact=_exact(cam, len(rows), (1, 2)),
    )


def _flank_radii(cam: CamPart, groove: SheetGroove, at: tuple[float, float]) -> tuple[SheetTable, ...]:
    """Radii of both flanks by the polar angle, in two tables beside each other."""
    head = ("θ, °", Message("inner, mm"), Message("outer, mm"))
    columns = (cam.angles.tolist(), cam.radii.tolist(), groove.radii.tolist())
    cells = [
        (rounded(degrees(angle), 1), f"{one:.3f}", f"{other:.3f}") for angle, one, other in zip(*columns, strict=True)
    ]
    half = ceil(len(cells) / 2)
    return tuple(
        SheetTable(
            title=Message("flanks of the groove") if number == 0 else "",
            at=(at[0] + number * _TABLES / 2, at[1]),
            widths=(11.0, 17.0, 17.0),
            rows=(head, *cells[number * half : (number + 1) * half]),
            exact=_exact(cam, len(cells[number * half : (number + 1) * half]), (0, 1, 2)),
        )
        for number in range(2)
    )


def _notes(cam: CamPart) -> Iterator[str]:
    blank = cam.blank
    if cam.groove:
        yield Message("The chain line is the path of the roller's centre.")
    yield Message("At the arrow of 0° stands the {follower} at cam angle 0.", follower=cam.on_ray)
    yield cam.sizes
    yield Message("Outline by a file (sha256); tables are for inspection:")
    yield from (f"   {name}  {digest[:SHOWN]}" for name, digest in cam.files)
    if not cam.files:
        yield Message("   not stated; ask for it.")
    if not (blank.key or blank.mark):
        yield Message("Plain bore: scribe the arrow at θ = 0 before the part leaves the machine.")
    yield from cam.fit.notes(blank)
    if cam.profile_tolerance is None:
        yield Message("Tolerance of the outline: not stated; ask for it.")
    if blank.mark:
        mark, held = blank.mark, blank.key
        left = sin(mark.angle - (held.angle if held else 0.0)) > 0
        if isinstance(held, Keyway):
            of = Message("the keyway")
        else:
            of = Message("the flat") if held else Message("the arrow")
        yield Message(
            "Mark {side} of {of}, seen from the axis outwards on this face: on the other side the disc is turned over.",
            side=Message("left") if left else Message("right"),
            of=of,
        )
    if screw := _screw(cam):
        yield from cam.fit.thread_note(drawn=bool(screw.thread))
    yield from cam.notes
