"""A sheet as data: views with curves and dimensions, tables, notes, a title. Paper and part are in mm."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from textwrap import wrap

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.curves.contour import Contour, circle
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Keyway

SIZES = {"A4": (297.0, 210.0), "A3": (420.0, 297.0)}  # landscape, ISO 5457
SCALES = (10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1)  # ISO 5455
LEFT, EDGE = 20.0, 10.0  # between paper and frame: where it is filed, and elsewhere
TITLE_SIZE = (170.0, 48.0)
ROW = 4.2  # height of a row of a table or of a note
TEXT = 2.5  # height of letters
HEIGHTS = (5.0, 3.5, 2.5, 1.8)  # of letters and figures (ISO 3098)
FRAME_HEIGHT = 2 * TEXT  # of a tolerance frame and of the box of a datum (ISO 1101, ISO 5459)
SIGN, SIGN_HEIGHT = 4.0, 5.0  # room of the sign of a texture: its width up to its value, and its height
LEVEL = 3.0  # of the level piece of a leader before its frame
SHORT = 5.6  # least length of a dimension line that has room for both its arrows, mm on paper
TAIL = 5.0  # of an arrow that stands outside the width that it dimensions, with its line, mm on paper
TRIANGLE = (2.2, 1.9)  # side and height of the triangle of a datum, mm on paper
SHOWN = 12  # letters of a file's hash
_INDENT = "   "  # of the further lines of a note
BEYOND = 6.0  # mm on paper from the end of a short dimension line to the middle of its number beside it
DIAMETER = "Ø"  # as ezdxf writes it
_LETTER = 0.79  # greatest mean width of the letters of a line in heights: of one with many figures and wide letters
WIDEST = 0.86  # the same of names with digits and underscores
WIDE = 1.4  # the same of Chinese, Japanese and Korean letters
_FIRST_WIDE = 0x2E80  # the first of these


class LineKind(StrEnum):
    """Kinds of line (ISO 128), which are the layers of the DXF."""

    VISIBLE = "VISIBLE"
    THIN = "THIN"
    CENTRE = "CENTRE"
    HIDDEN = "HIDDEN"
    PHANTOM = "PHANTOM"
    HATCH = "HATCH"
    DIMENSION = "DIMENSION"
    TEXT = "TEXT"
    FRAME = "FRAME"


@dataclass(frozen=True, slots=True, eq=False)
class Closed:
    """Closed curve of lines and arcs, mm on the part."""

    contour: Contour
    line: LineKind = LineKind.VISIBLE


@dataclass(frozen=True, slots=True, eq=False)
class Stroke:
    """Open polyline.

    Attributes:
        points: corners, shape (n, 2), mm on the part.
        line: kind of line.
    """

    points: Array
    line: LineKind = LineKind.VISIBLE


@dataclass(frozen=True, slots=True, eq=False)
class Hatch:
    """Area of material that is cut.

    Attributes:
        outside: corners of its outline, shape (n, 2), mm on the part.
        holes: corners of each hole in it.
    """

    outside: Array
    holes: tuple[Array, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class LinearDimension:
    """Dimension between two points.

    Attributes:
        name: what is dimensioned, by which a test finds it again.
        start: first point, mm on the part.
        end: second point.
        at: a point of the dimension line.
        angle: direction that is measured, degrees.
        prefix: text before the number.
        suffix: text after it.
        beside: way from the middle of the dimension line to the number along it, mm on paper.
        exact: whether it is theoretically exact, which a box around the number says (ISO 1101).
    """

    name: str
    start: tuple[float, float]
    end: tuple[float, float]
    at: tuple[float, float]
    angle: float = 0.0
    prefix: str = ""
    suffix: str = ""
    beside: float = 0.0
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class DiameterDimension:
    """Diameter of a circle, written outside at the end of its dimension line.

    Attributes:
        name: what is dimensioned.
        centre: centre of the circle, mm on the part.
        diameter: diameter, mm.
        angle: direction of the dimension line, degrees.
        prefix: text before the sign and the number, such as `6 x `.
        suffix: text after it, such as a fit.
        reach: distance of its text from the centre, mm on paper; 0 for 9 mm outside the circle.
        sign: letter before the number: `M` of a thread.
        exact: whether it is theoretically exact, as of a length.
    """

    name: str
    centre: tuple[float, float]
    diameter: float
    angle: float = 45.0
    prefix: str = ""
    suffix: str = ""
    reach: float = 0.0
    sign: str = DIAMETER
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class RadiusDimension:
    """Radius about a centre, its arrow on the curve from outside, and its number at the end of that line.

    Attributes:
        name: what is dimensioned.
        centre: centre, mm on the part.
        radius: radius, mm.
        angle: direction of the dimension line, degrees.
        suffix: text after the number.
        reach: distance of its text from the centre, mm on paper; 0 for 9 mm outside the curve.
        exact: whether it is theoretically exact, as of a length.
    """

    name: str
    centre: tuple[float, float]
    radius: float
    angle: float = 45.0
    suffix: str = ""
    reach: float = 0.0
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class AngularDimension:
    """Angle between two directions about a centre, counterclockwise, its number at the middle of its arc.

    Attributes:
        name: what is dimensioned.
        centre: centre, mm on the part.
        start: first direction, degrees.
        end: second direction, degrees, greater than the first by less than 360.
        radius: radius of the dimension line, mm on the part.
        exact: whether it is theoretically exact, as of a length.
    """

    name: str
    centre: tuple[float, float]
    start: float
    end: float
    radius: float
    exact: bool = False


Dimension = LinearDimension | DiameterDimension | RadiusDimension | AngularDimension


@dataclass(frozen=True, slots=True, kw_only=True)
class Label:
    """Text beside a place of the part.

    Attributes:
        text: what stands there.
        at: place of its middle, mm on the part.
        height: height of the letters, mm on paper.
    """

    text: str
    at: tuple[float, float]
    height: float = TEXT


class Characteristic(StrEnum):
    """Characteristics of geometrical tolerances (ISO 1101)."""

    LINE_PROFILE = "profile of a line"
    POSITION = "position"
    PARALLELISM = "parallelism"
    PERPENDICULARITY = "perpendicularity"
    COAXIALITY = "coaxiality"
    SYMMETRY = "symmetry"
    RUN_OUT = "circular run-out"


@dataclass(frozen=True, slots=True, kw_only=True)
class ToleranceFrame:
    """Geometrical tolerance (ISO 1101): a frame, and a leader whose arrow stands on the feature.

    Attributes:
        name: feature, by which a test finds it again.
        characteristic: what is tolerated.
        zone: width of the tolerance zone, mm.
        datums: letters of the datums, the first one first.
        tip: point of the feature at which the arrow ends, mm on the part.
        bend: where the leader bends to run on level into the frame, mm on the part.
        all_around: whether it counts all around the outline, which a circle on the leader says.
        diametral: whether the zone is a cylinder, whose width follows the sign of a diameter.
        combined: whether the zones of a pattern's features are held to each other (CZ, ISO 5458).
    """

    name: str
    characteristic: Characteristic
    zone: float
    datums: tuple[str, ...]
    tip: tuple[float, float]
    bend: tuple[float, float]
    all_around: bool = False
    diametral: bool = False
    combined: bool = False

    @property
    def zone_text(self) -> str:
        """Width of the zone, after the sign of a diameter where it is a cylinder."""
        return f"{DIAMETER if self.diametral else ''}{rounded(self.zone)}{' CZ' if self.combined else ''}"

    @property
    def cells(self) -> tuple[float, ...]:
        """Widths of the cells of the frame: symbol, zone, and each datum; mm on paper."""
        return (
            FRAME_HEIGHT,
            TEXT * width_of(self.zone_text) + 2.0,
            *(FRAME_HEIGHT for _ in self.datums),
        )

    @property
    def side(self) -> int:
        """1 where the frame stands to the right of its leader, else -1."""
        return 1 if self.bend[0] >= self.tip[0] else -1


@dataclass(frozen=True, slots=True, kw_only=True)
class DatumFeature:
    """Datum (ISO 5459): a filled triangle on a feature, or in line with its dimension, and its letter in a box.

    Attributes:
        letter: letter of the datum.
        foot: middle of the side of the triangle that stands on the feature, mm on the part.
        angle: direction from there to the box, degrees.
        reach: distance from there to the middle of the box, mm on paper.
    """

    letter: str
    foot: tuple[float, float]
    angle: float
    reach: float = 8.0


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceTexture:
    """Texture of a surface (ISO 21920-1): the sign on its outline, or on a leader to it, and a value.

    Attributes:
        value: parameter with its limit, and the lay, such as `Ra 0.4 =` along the view.
        tip: point of the outline, mm on the part, at which the leader ends or the sign stands.
        bend: where the leader bends to run on level under the sign, mm on the part; None without a leader.
        all_around: whether it counts all around the outline, which a circle on the leader says.
    """

    value: str
    tip: tuple[float, float]
    bend: tuple[float, float] | None = None
    all_around: bool = False

    @property
    def width(self) -> float:
        """Width of sign and value, mm on paper."""
        return SIGN + TEXT * width_of(self.value)


@dataclass(frozen=True, slots=True, kw_only=True)
class EdgeState:
    """State of the edges of an outline (ISO 13715): the sign on a leader, and how far an edge may be off.

    Attributes:
        count: number of edges alike, one on either face.
        size: greatest that may be taken off, mm.
        tip: point of the outline, mm on the part, at which the leader ends.
        bend: where the leader ends in the corner of the sign, mm on the part.
    """

    count: int
    size: float
    tip: tuple[float, float]
    bend: tuple[float, float]

    @property
    def value(self) -> str:
        """Size with its sign: material off the edge, and no burr."""
        return f"-{rounded(self.size)}"

    @property
    def before(self) -> str:
        """Number of edges, before the sign."""
        return f"{self.count} × " if self.count > 1 else ""

    @property
    def width(self) -> float:
        """Width of number, sign and value, mm on paper."""
        return TEXT * (width_of(self.before) + width_of(self.value)) + 4.0


Symbol = ToleranceFrame | DatumFeature | SurfaceTexture | EdgeState


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class View:
    """A view of the part.

    Attributes:
        place: where the origin of the part's coordinates lies on the paper, mm.
        curves: closed curves and strokes.
        hatches: cut material.
        dimensions: dimensions.
        labels: texts.
        symbols: geometrical tolerances, datums, textures of surfaces and states of edges.
    """

    place: tuple[float, float]
    curves: tuple[Closed | Stroke, ...]
    hatches: tuple[Hatch, ...] = ()
    dimensions: tuple[Dimension, ...] = ()
    labels: tuple[Label, ...] = ()
    symbols: tuple[Symbol, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class SheetTable:
    """Table with a heading.

    Attributes:
        title: heading.
        at: upper left corner on the paper, mm.
        widths: widths of the columns, mm.
        rows: cells of each row; the first row names the columns where `headed` is true.
        headed: whether the first row names the columns.
        exact: rows and columns of the cells that are theoretically exact, which boxes around them say (ISO 1101).
    """

    title: str
    at: tuple[float, float]
    widths: tuple[float, ...]
    rows: tuple[tuple[str, ...], ...]
    headed: bool = True
    exact: frozenset[tuple[int, int]] = frozenset()

    @property
    def height(self) -> float:
        """Height with the heading, mm."""
        return (len(self.rows) + 1) * ROW


@dataclass(frozen=True, slots=True, kw_only=True)
class Title:
    """Title block (ISO 7200).

    Attributes:
        part: name of the part.
        title: title of the machine, from `drawing.title` or the design's name.
        material: material; empty if the design has none.
        finish: finish; empty if the design has none.
        quantity: how many are made.
        date: date of the manifest, or of the drawing, ISO 8601.
        design: name and hash of the design.
        number: number of the drawing: the stem of its files.
        document: kind of document.
        owner: legal owner; empty where the design does not say.
        drawn_by: who made the drawing, likewise.
        approved_by: who approved it, likewise.
        verdict: verdict on the part in a line over the block; empty for a part that is ready, or is not judged.
        edge: how much may be taken off outer edges that have no size of their own, or stand in inner ones (ISO 13715),
            mm.
        inner: how much may stand in inner ones, mm; None for as much as may be off outer ones.
        printed: whether the part is as a printer leaves it: standards of machined parts then say nothing of it.
    """

    part: str
    title: str
    material: str
    finish: str
    quantity: int
    date: str
    design: str
    number: str
    document: str = Message("part drawing")
    owner: str = ""
    drawn_by: str = ""
    approved_by: str = ""
    verdict: str = ""
    edge: float = 0.3
    inner: float | None = None
    printed: bool = False

    @property
    def height(self) -> float:
        """Height of the block with the verdict over it, mm."""
        return TITLE_SIZE[1] + (7.0 if self.verdict else 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class NoteColumn:
    """Room for notes.

    Attributes:
        at: upper left corner on the paper, mm.
        width: width, mm.
        height: height, mm.
    """

    at: tuple[float, float]
    width: float
    height: float

    @property
    def lines(self) -> int:
        """Number of lines that it holds."""
        return max(int(self.height / ROW), 0)


def beside_title(size: str) -> NoteColumn:
    """Column of notes to the left of the title block.

    Args:
        size: size of the sheet.
    """
    width, _ = SIZES[size]
    left, top = LEFT + 3.0, EDGE + TITLE_SIZE[1]
    return NoteColumn(at=(left, top), width=width - EDGE - TITLE_SIZE[0] - left - 3.0, height=TITLE_SIZE[1] - 1.0)


def over_title(tables: Sequence[SheetTable], width: float, title: Title) -> NoteColumn:
    """Column of notes under tables and over the title block.

    Args:
        tables: tables, the first one farthest to the left.
        width: width of the column, mm.
        title: title block.
    """
    low = min(table.at[1] - table.height for table in tables) - 3.0
    return NoteColumn(at=(tables[0].at[0], low), width=width, height=low - EDGE - title.height - 2.0)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class DrawingSheet:
    """Everything on a sheet.

    Attributes:
        size: `A4` or `A3`.
        scale: mm on paper for a mm of the part.
        title: title block.
        views: views of the part.
        tables: tables.
        notes: sentences for the shop, broken into lines where they are drawn.
        columns: columns that the notes fill one after the other.
    """

    size: str
    scale: float
    title: Title
    views: tuple[View, ...]
    tables: tuple[SheetTable, ...]
    notes: tuple[str, ...]
    columns: tuple[NoteColumn, ...]

    def __post_init__(self) -> None:
        names = [dimension.name for view in self.views for dimension in view.dimensions]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise ValueError(f"two dimensions of a sheet are named {twice[0]}: give each a name of its own")
        symbols = [symbol for view in self.views for symbol in view.symbols]
        letters = [symbol.letter for symbol in symbols if isinstance(symbol, DatumFeature)]
        wanted = [letter for symbol in symbols if isinstance(symbol, ToleranceFrame) for letter in symbol.datums]
        if wrong := sorted({letter for letter in {*letters, *wanted} if letters.count(letter) != 1}):
            raise ValueError(f"datum {wrong[0]} of a sheet is marked {letters.count(wrong[0])} times: mark it once")

    @property
    def dimensions(self) -> dict[str, float]:
        """Length of every dimension by its name, mm on the part; angles in degrees."""
        every = [dimension for view in self.views for dimension in view.dimensions]
        return {dimension.name: length_of(dimension) for dimension in every}


def length_of(dimension: Dimension) -> float:
    """Length that a dimension states, mm on the part; an angle in degrees."""
    if isinstance(dimension, DiameterDimension):
        return dimension.diameter
    if isinstance(dimension, RadiusDimension):
        return dimension.radius
    if isinstance(dimension, AngularDimension):
        return dimension.end - dimension.start
    along = np.array([np.cos(np.radians(dimension.angle)), np.sin(np.radians(dimension.angle))])
    return abs(float((np.array(dimension.end) - np.array(dimension.start)) @ along))


def along_axis(name: str, ends: tuple[float, float], r: float, at: float) -> LinearDimension:
    """Dimension of a section along the axis, from one height to another.

    Args:
        name: what is dimensioned.
        ends: heights of both ends, mm.
        r: distance of the ends from the axis, mm.
        at: distance of the dimension line from the axis, mm.
    """
    return LinearDimension(name=name, start=(ends[0], r), end=(ends[1], r), at=(ends[0], at))


def across_axis(name: str, z: float, ends: tuple[float, float], at: float, prefix: str = "") -> LinearDimension:
    """Dimension of a section across the axis, from one distance to another.

    Args:
        name: what is dimensioned.
        z: height of the ends, mm.
        ends: distances of both ends from the axis, negative below it, mm.
        at: height of the dimension line, mm.
        prefix: text before the number.
    """
    return LinearDimension(name=name, start=(z, ends[0]), end=(z, ends[1]), at=(at, 0.0), angle=90.0, prefix=prefix)


def upright(
    name: str, x: float, ends: tuple[float, float], at: float, scale: float, prefix: str = "", suffix: str = ""
) -> LinearDimension:
    """Dimension of a height, its number over the arrows where there is no room between them.

    Args:
        name: what is dimensioned.
        x: place of both ends, mm.
        ends: lower and upper end, mm.
        at: place of the dimension line, mm.
        scale: mm on paper for a mm of the part.
        prefix: before the number.
        suffix: after it.
    """
    low, high = ends
    long, room = TEXT * WIDEST * len(f"{prefix}{rounded(high - low)}{suffix}") + 4.0, scale * (high - low)
    return LinearDimension(
        name=name,
        start=(x, low),
        end=(x, high),
        at=(at, low),
        angle=90.0,
        beside=0.0 if room > long else (room + long) / 2 + 1.0,
        prefix=prefix,
        suffix=suffix,
    )


def axial_diameter(name: str, z: float, radius: float, at: float) -> LinearDimension:
    """Diameter about the axis in a section.

    Args:
        name: what is dimensioned.
        z: height of its ends, mm.
        radius: half of the diameter, mm.
        at: height of the dimension line, mm.
    """
    return across_axis(name, z, (-radius, radius), at, DIAMETER)


def axis_datum(letter: str, dimension: DiameterDimension) -> DatumFeature:
    """Datum that is the axis of a bore: its triangle in line with the dimension, on the far side of the circle.

    Args:
        letter: letter of the datum.
        dimension: diameter of the bore, as it is placed.
    """
    opposite = dimension.angle + 180.0
    away = np.array([np.cos(np.radians(opposite)), np.sin(np.radians(opposite))])
    x, y = (np.array(dimension.centre) + dimension.diameter / 2 * away).tolist()
    return DatumFeature(letter=letter, foot=(x, y), angle=opposite)


def line_datum(letter: str, held: LinearDimension, scale: float, reach: float = 8.0) -> DatumFeature:
    """Datum that is the axis of an upright diameter in a section: its triangle in line with it, at its lower end.

    Args:
        letter: letter of the datum.
        held: dimension of the diameter.
        scale: mm on paper for a mm of the part.
        reach: distance of the letter from the triangle, mm on paper.
    """
    low = min(held.start[1], held.end[1])
    short = scale * abs(held.end[1] - held.start[1]) < SHORT  # an arrow that points inwards has its tail outside
    return DatumFeature(
        letter=letter, foot=(held.at[0], low - (TAIL / scale if short else 0.0)), angle=270.0, reach=reach
    )


def free_end(held: LinearDimension) -> tuple[Array, Array]:
    """End of a dimension at which its number does not stand, and the unit vector that leads outwards there.

    Symbols of what is in the middle stand in line with the dimension there (ISO 1101, ISO 5459).

    Args:
        held: dimension of a width.
    """
    turn = np.radians(held.angle)
    out = (-1.0 if held.beside > 0 else 1.0) * np.array([np.cos(turn), np.sin(turn)])
    base = np.array(held.at)
    return base + max(float((np.array(end) - base) @ out) for end in (held.start, held.end)) * out, out


def symmetry(name: str, zone: float) -> ToleranceFrame:
    """Symmetry of a width to datum A, wherever the frame stands.

    Args:
        name: feature, by which a test finds it again.
        zone: width of the tolerance zone, mm.
    """
    return ToleranceFrame(
        name=name,
        characteristic=Characteristic.SYMMETRY,
        zone=zone,
        datums=("A",),
        tip=(0.0, 0.0),
        bend=(1.0, 0.0),
    )


def run_out(
    name: str, zone: float, tip: tuple[float, float], bend: tuple[float, float], letter: str = "A"
) -> ToleranceFrame:
    """Circular run-out to one datum.

    Args:
        name: feature, by which a test finds it again.
        zone: run-out, mm.
        tip: point at which the arrow ends, mm on the part.
        bend: where the leader bends into the frame, mm on the part.
        letter: letter of the datum.
    """
    return ToleranceFrame(
        name=name, characteristic=Characteristic.RUN_OUT, zone=zone, datums=(letter,), tip=tip, bend=bend
    )


def ring(diameter: float, line: LineKind = LineKind.VISIBLE, centre: tuple[float, float] = (0.0, 0.0)) -> Closed:
    """Circle of a diameter, mm.

    Args:
        diameter: diameter, mm.
        line: kind of line.
        centre: centre, mm.
    """
    return Closed(circle(centre, diameter / 2), line)


def centre_cross(reach: float, centre: tuple[float, float] = (0.0, 0.0), angle: float = 0.0) -> tuple[Stroke, Stroke]:
    """Two centre lines through a point, `reach` mm to either side, the first in the direction `angle` (rad).

    Args:
        reach: half the length of the lines, mm.
        centre: point, mm.
        angle: direction of the first, rad.
    """
    along = np.array([np.cos(angle), np.sin(angle)])
    across = np.array([-along[1], along[0]])
    first, second = (np.array([centre - reach * way, centre + reach * way]) for way in (along, across))
    return Stroke(first, LineKind.CENTRE), Stroke(second, LineKind.CENTRE)


def arrow(start: Array, end: Array, head: tuple[float, float], line: LineKind = LineKind.VISIBLE) -> list[Stroke]:
    """Arrow between two points, its head open.

    Args:
        start: point at which it begins, mm on the part.
        end: its tip, mm on the part.
        head: length and half the width of its head, mm.
        line: kind of line.
    """
    along = (end - start) / np.linalg.norm(end - start)
    across = np.array([-along[1], along[0]])
    barbs = [end - head[0] * along + side * head[1] * across for side in (-1, 1)]
    return [Stroke(np.array([start, end]), line), Stroke(np.array([barbs[0], end, barbs[1]]), line)]


def keyway_width(key: Keyway, bore_diameter: float, gap: float, scale: float, suffix: str = "") -> LinearDimension:
    """Dimension of the width of a keyway in the view along the axis.

    Args:
        key: keyway.
        bore_diameter: diameter of the bore, mm.
        gap: distance of the dimension line from the floor of the keyway, mm.
        scale: mm on paper for a mm of the part.
        suffix: class of the width, with a blank before it.
    """
    out, c, s = bore_diameter / 2 + key.depth, np.cos(key.angle), np.sin(key.angle)

    def point(radius: float, aside: float) -> tuple[float, float]:
        return float(radius * c - aside * s), float(radius * s + aside * c)

    return LinearDimension(
        name="keyway width",
        start=point(out, -key.width / 2),
        end=point(out, key.width / 2),
        at=point(out + gap, 0.0),
        angle=np.degrees(key.angle) + 90.0,
        beside=scale * key.width / 2 + BEYOND + WIDEST * TEXT * len(suffix) / 2,
        suffix=suffix,
    )


def bore_and_keyway(blank: Blank, suffix: str, z: float, at: float, scale: float) -> LinearDimension:
    """Dimension of bore and keyway, or of a bore across its flats, with limits; over the hub where there is no room.

    Args:
        blank: part with a keyway or flats.
        suffix: limits, with a blank before them.
        z: height of its ends, mm.
        at: height of the dimension line, mm.
        scale: mm on paper for a mm of the part.
    """
    low, high, name = -blank.bore_diameter / 2, blank.bore_diameter / 2, "across flats"
    if isinstance(blank.key, Keyway):
        high, name = high + blank.key.depth, "bore and keyway"
    elif isinstance(blank.key, DFlat):
        high, name = high - blank.key.depth, "across the flat"
    long = TEXT * WIDEST * len(rounded(high - low) + suffix)
    plain = replace(across_axis(name, z, (low, high), at), suffix=suffix)
    if scale * (high - low) >= long:
        return plain
    # Over the hub's extension line, which its number would lie on.
    over = max(high, blank.hub.diameter / 2 if blank.hub else 0.0)
    return replace(plain, beside=scale * (over - (low + high) / 2) + long / 2 + 1.0)


def cutting_plane(angle: float, reach: float, scale: float) -> tuple[tuple[Stroke, ...], tuple[Label, Label]]:
    """The ends of the plane of section A-A in a view along the axis, with arrows the way it is looked at, and letters.

    Args:
        angle: direction of the plane through the axis, rad; the section shows it upwards.
        reach: distance of the inner ends of its thick strokes from the axis, mm.
        scale: mm on paper for a mm of the part.
    """
    along = np.array([np.cos(angle), np.sin(angle)])
    look = np.array([along[1], -along[0]])
    strokes, labels = [], []
    for way in (along, -along):
        corner = (reach + 5.0 / scale) * way
        strokes.append(Stroke(np.array([reach * way, corner])))
        strokes += arrow(corner, corner + 6.0 / scale * look, (2.5 / scale, 0.8 / scale), LineKind.THIN)
        x, y = (corner - 2.5 / scale * look).tolist()
        labels.append(Label(text="A", at=(x, y), height=3.5))
    if abs(np.sin(2 * angle)) > 1e-6:  # else a centre line is there already
        strokes.append(Stroke(np.array([-reach * along, reach * along]), LineKind.CENTRE))
    return tuple(strokes), (labels[0], labels[1])


def section_title(angle: float, at: tuple[float, float], scale: float) -> tuple[tuple[Stroke, ...], tuple[Label, ...]]:
    """Name of the section in that plane; behind an arrow on an arc its turn from the first angle's place (ISO 128-3).

    Args:
        angle: polar angle of the plane, rad.
        at: middle of the name, mm on the part.
        scale: mm on paper for a mm of the part.
    """
    turned = (90.0 - float(np.degrees(angle)) + 180.0) % 360.0 - 180.0
    name, size, height = Message("A–A"), f"{rounded(abs(turned), 1)}°", HEIGHTS[1]
    if abs(turned) < 0.05:
        return (), (Label(text=name, at=at, height=height),)
    long, longer = (WIDEST * len(text) * height for text in (name, size))
    room = 1.5 * height  # half of the arc's
    left = -(long + longer) / 2 - room
    arc = np.exp(1j * np.linspace(0.0, np.pi, 25)) - 0.5j
    if turned < 0:
        arc = -arc.conj()
    # The arrow ends the arc, pointing down: counterclockwise at its left end, clockwise at its right one.
    head = arc[-1] + 0.7 * np.exp(1j * np.radians([65.0, 115.0]))
    lines = (arc, np.array([head[0], arc[-1], head[1]]))
    middle = complex(left + long + room, 0.0)

    def placed(points: NDArray[np.complex128]) -> Stroke:
        paper = middle + 0.8 * height * points
        return Stroke(np.stack([paper.real, paper.imag], axis=1) / scale + at, LineKind.THIN)

    labels = tuple(
        Label(text=text, at=(at[0] + x / scale, at[1]), height=height)
        for text, x in ((name, left + long / 2), (size, left + long + 2 * room + longer / 2))
    )
    return tuple(map(placed, lines)), labels


def is_wide(letter: str) -> bool:
    """Whether a letter is Chinese, Japanese or Korean."""
    return ord(letter) >= _FIRST_WIDE


def width_of(text: str) -> float:
    """Width of a text with room to spare, in heights of its letters."""
    return sum(WIDE if is_wide(letter) else WIDEST for letter in text)


def height_within(lengths: Sequence[float], widths: Sequence[float], most: float) -> float:
    """Greatest height of letters of the series, up to `most`, at which every text has room in its width.

    A text that is too long for the least one takes less than that.

    Args:
        lengths: length of each text, in heights of its letters.
        widths: width of the room of each, mm.
        most: greatest height, mm.
    """
    room = min((width / length for length, width in zip(lengths, widths, strict=True) if length), default=most)
    return next((height for height in HEIGHTS if height <= min(most, room)), min(room, HEIGHTS[-1]))


def chosen_scale(part: tuple[float, float], room: tuple[float, float], greatest: float = 5.0) -> float | None:
    """Greatest scale of `SCALES`, up to `greatest`, at which a part of some width and height (mm) has room on paper.

    Args:
        part: width and height of the part, mm.
        room: width and height on paper, mm.
        greatest: greatest scale allowed.
    """
    fitting = (
        scale
        for scale in SCALES
        if scale <= greatest and all(scale * length <= space for length, space in zip(part, room, strict=True))
    )
    return next(fitting, None)


def rounded(number: float, digits: int = 3) -> str:
    """A number as on a drawing: without zeros at its end.

    Args:
        number: number to show.
        digits: digits after the point.
    """
    text = f"{number:.{digits}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def scale_text(scale: float) -> str:
    """A scale as it is written: `2:1`, `1:1`, `1:2`.

    Args:
        scale: scale, a ratio of paper to part.
    """
    return f"{scale:g}:1" if scale >= 1 else f"1:{1 / scale:g}"


# A word of Latin letters or one letter; no line begins with a mark that closes, or ends with one that opens.
_PIECES = re.compile(r"[（“]*(?:(?:± )?[!-~°µ×Ø]+|.)[，。；：、）”]*")


def wrapped(note: str, width: float) -> list[str]:
    """Lines of a note that a column of a width (mm) holds; what follows the first line is indented.

    Args:
        note: note, in the language in which it is drawn.
        width: width of the column, mm.
    """
    if not any(map(is_wide, note)):
        return wrap(note, int(width / (_LETTER * TEXT)), subsequent_indent=_INDENT)
    lines = [""]
    for piece in re.findall(_PIECES, note):
        if TEXT * width_of(lines[-1] + piece) > width and lines[-1].strip():
            lines.append(_INDENT)
        lines[-1] += piece
    return lines


def placed_notes(notes: Sequence[str], columns: Sequence[NoteColumn]) -> Iterator[tuple[str, tuple[float, float]]]:
    """Lines of notes with the places where they begin on the paper, mm; what has no room runs out of the last column.

    Args:
        notes: notes, in the language in which they are drawn.
        columns: columns, of which each is filled with whole notes.
    """
    number, used = 0, 0
    for note in notes:
        lines = wrapped(note, columns[number].width)
        if used + len(lines) > columns[number].lines and number + 1 < len(columns):
            number, used = number + 1, 0
            lines = wrapped(note, columns[number].width)
        left, top = columns[number].at
        for line in lines:
            yield line, (left, top - (used + 0.7) * ROW)
            used += 1


def have_room(notes: Sequence[str], columns: Sequence[NoteColumn]) -> bool:
    """Whether notes stay within their columns."""
    last = columns[-1]
    lowest = last.at[1] - last.height
    return all(at[1] >= lowest for _, at in placed_notes(notes, columns) if at[0] == last.at[0])


def chosen_sheet(
    part: tuple[float, float],
    beside: tuple[float, float],
    good: float,
    greatest: float,
    holds: Callable[[str], bool] = lambda size: True,
) -> tuple[str, float]:
    """Size and scale of the sheet for a part: A4 where it is shown there as large as is `good`, else the larger scale.

    Args:
        part: width and height of the views at 1:1, without what is between them, mm.
        beside: width and height on paper for everything else within the frame, mm.
        good: scale that A4 suffices for.
        greatest: greatest scale.
        holds: function that says of a size whether tables and notes have room on it; A3 is taken in any case.
    """
    scales = {}
    for size, (width, height) in SIZES.items():
        room = (width - LEFT - EDGE - beside[0], height - 2 * EDGE - beside[1])
        scales[size] = chosen_scale(part, room, greatest) or SCALES[-1]
    size = "A4" if scales["A4"] >= min(good, scales["A3"]) and holds("A4") else "A3"
    return size, scales[size]
