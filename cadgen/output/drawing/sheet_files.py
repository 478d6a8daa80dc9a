"""A sheet as DXF (R2010, mm on paper) and as a page of PDF, which is its DXF, drawn; and the dimensions read again.

The true dimensions of the DXF count mm of the part. The pages have one font for Latin, Greek and Cyrillic, which comes
with matplotlib, and one of the system's for Chinese, Japanese and Korean.
"""

import io
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import pairwise, zip_longest
from pathlib import Path

import ezdxf
import matplotlib
import numpy as np
import shapely
from ezdxf.addons.drawing import Frontend, RenderContext
from ezdxf.addons.drawing.config import BackgroundPolicy, ColorPolicy, Configuration, LineweightPolicy
from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
from ezdxf.addons.drawing.properties import BackendProperties
from ezdxf.document import Drawing as Document
from ezdxf.enums import TextEntityAlignment
from ezdxf.fonts import fonts
from ezdxf.layouts import Modelspace
from ezdxf.math import Vec2, Vec3
from ezdxf.npshapes import NumpyPath2d as BkPath2d
from ezdxf.npshapes import to_matplotlib_path
from fontTools.ttLib import TTCollection, TTFont, TTLibError
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties, findSystemFonts
from matplotlib.patches import PathPatch

from cadgen.errors import FileError
from cadgen.messages import ENGLISH, Message, translate
from cadgen.output.drawing.sheet import (
    DIAMETER,
    EDGE,
    FRAME_HEIGHT,
    HEIGHTS,
    LEFT,
    LEVEL,
    ROW,
    SIGN,
    SIZES,
    TEXT,
    TITLE_SIZE,
    TRIANGLE,
    WIDE,
    AngularDimension,
    Characteristic,
    Closed,
    DatumFeature,
    DiameterDimension,
    Dimension,
    DrawingSheet,
    EdgeState,
    Hatch,
    LinearDimension,
    LineKind,
    RadiusDimension,
    SheetTable,
    Stroke,
    SurfaceTexture,
    ToleranceFrame,
    View,
    height_within,
    is_wide,
    length_of,
    placed_notes,
    rounded,
    scale_text,
)
from cadgen.output.files.dxf import fixed_dates

APP = "CADGEN"  # of the names of dimensions in the file
FONT = "DejaVuSans.ttf"  # free, and at hand wherever matplotlib is
FAR_EASTERN_STYLE = "CADGEN_CJK"
_FAR_EASTERN_FONT = "simsun.ttc"  # that of Windows, for which every CAD has one in its place
_STYLE = "CADGEN"
_MM = 4  # $INSUNITS
# Width of each kind of line, hundredths of a mm (ISO 128), and its pattern on paper.
_WIDTHS = {LineKind.VISIBLE: 50, LineKind.FRAME: 50}
_PATTERNS = {
    LineKind.HIDDEN: [4.0, 3.0, -1.0],
    LineKind.CENTRE: [13.0, 9.0, -1.5, 1.0, -1.5],
    LineKind.PHANTOM: [15.5, 9.0, -1.5, 1.0, -1.5, 1.0, -1.5],
}
_THIN = 18
# Letters that LibreCAD's fonts lack, and what stands for them in a DXF. The page has them.
_SIGN = "%%c"  # of a diameter, as every reader knows it
_PLAIN = str.maketrans({"θ": "theta", "ρ": "rho", "–": "-", "—": "-", "−": "-"})
_HATCH_STEP = 2.0  # mm on paper
_ROUGHNESS = re.compile(r"R[a-z]\d* ?\d")  # such as Ra 1.6
_HALF_TURN = np.linspace(0.0, np.pi, 33)
# Strokes of the symbols of ISO 1101 about the middle of their cell, in heights of letters.
_SYMBOLS = {
    Characteristic.LINE_PROFILE: (np.column_stack([0.65 * np.cos(_HALF_TURN), 0.65 * np.sin(_HALF_TURN) - 0.3]),),
    Characteristic.POSITION: (
        np.column_stack([0.4 * np.cos(2 * _HALF_TURN), 0.4 * np.sin(2 * _HALF_TURN)]),
        np.array([[-0.7, 0.0], [0.7, 0.0]]),
        np.array([[0.0, -0.7], [0.0, 0.7]]),
    ),
    Characteristic.COAXIALITY: tuple(
        np.column_stack([radius * np.cos(2 * _HALF_TURN), radius * np.sin(2 * _HALF_TURN)]) for radius in (0.3, 0.6)
    ),
    Characteristic.SYMMETRY: tuple(
        np.array([[-half, up], [half, up]]) for half, up in ((0.35, 0.35), (0.7, 0.0), (0.35, -0.35))
    ),
    Characteristic.PARALLELISM: tuple(np.array([[start - 0.3, -0.6], [start + 0.3, 0.6]]) for start in (-0.2, 0.2)),
    Characteristic.PERPENDICULARITY: (
        np.array([[-0.6, -0.5], [0.6, -0.5]]),
        np.array([[0.0, -0.5], [0.0, 0.6]]),
    ),
    Characteristic.RUN_OUT: (
        np.array([[-0.5, -0.6], [0.5, 0.6]]),
        np.array([[0.26, 0.02], [0.5, 0.6], [-0.04, 0.27], [0.26, 0.02]]),
    ),
}
_ANGULAR = (2, 5)  # types of dimensions that are angles
_DIMGAP = 0.6  # mm on paper between a dimension line and its number


@dataclass(frozen=True)
class SheetDocument:
    """Sheet as a document of ezdxf, made once for its DXF and its page.

    Attributes:
        drawing: sheet.
        language: language of its texts.
    """

    drawing: DrawingSheet
    language: str = ENGLISH

    @cached_property
    def _document(self) -> Document:
        with fixed_dates():
            return document_of(self.drawing, self.language)

    def dxf(self) -> bytes:
        """The DXF: the same bytes for the same sheet and language."""
        document = self._document
        texts = document.modelspace().query("TEXT")
        with fixed_dates():
            if any(letter in text.dxf.text for text in texts for letter in map(chr, _PLAIN)):
                document = document_of(self.drawing, self.language, _PLAIN)
                texts = document.modelspace().query("TEXT")
            read = [text.dxf.text for text in texts]
            for text in texts:
                text.dxf.text = text.dxf.text.replace(DIAMETER, _SIGN)
            # Of the classes that every file has, ezdxf keeps a set, whose order is by chance.
            document.classes.add_required_classes(document.dxfversion)
            document.classes.classes = dict(sorted(document.classes.classes.items()))
            written = io.StringIO()
            document.write(written)
        for text, before in zip(texts, read, strict=True):
            text.dxf.text = before
        return written.getvalue().encode(document.output_encoding, errors="dxfreplace")

    def page(self) -> bytes:
        """The page, in its true size: the same bytes for the same sheet, language, fonts and libraries.

        Raises:
            NoFontError: the system has no font for Chinese, Japanese or Korean letters of the sheet.
        """
        know_font()
        width, height = SIZES[self.drawing.size]
        figure = Figure(figsize=(width / _INCH, height / _INCH))
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        document = self._document
        texts = [(text.dxf.style, text.dxf.text) for text in document.modelspace().query("TEXT")]
        for dimension in document.modelspace().query("DIMENSION"):
            numbers = dimension.get_geometry_block().query("MTEXT")
            texts += [(number.dxf.style, "".join(filter(is_wide, number.plain_text()))) for number in numbers]
        if letters := frozenset("".join(text for style, text in texts if style == FAR_EASTERN_STYLE)):
            document.styles.get(FAR_EASTERN_STYLE).dxf.font = know_far_eastern(letters)
        backend = _Backend(axes, adjust_figure=False)
        look = Configuration(
            background_policy=BackgroundPolicy.WHITE,
            color_policy=ColorPolicy.BLACK,
            lineweight_policy=LineweightPolicy.ABSOLUTE,
            lineweight_scaling=_POINT,  # matplotlib counts points where the drawing counts mm
            min_lineweight=_THINNEST * _POINT,
        )
        Frontend(RenderContext(document), backend, config=look).draw_layout(document.modelspace(), finalize=True)
        _searchable(axes, document)
        if letters:
            document.styles.get(FAR_EASTERN_STYLE).dxf.font = _FAR_EASTERN_FONT
        axes.set_aspect("equal", adjustable="box")
        axes.axis((0.0, width, 0.0, height))
        page = io.BytesIO()
        figure.savefig(page, format="pdf", metadata={"CreationDate": None, "Title": self.drawing.title.number})
        return page.getvalue()


def document_of(drawing: DrawingSheet, language: str = ENGLISH, plain: Mapping[int, str] | None = None) -> Document:
    """The sheet as a document of ezdxf, with its texts in a language; names of dimensions stay English.

    Args:
        drawing: sheet.
        language: language of the texts.
        plain: texts that stand for letters which readers of the document may lack.
    """

    def say(text: str) -> str:
        return str(translate(text, language)).translate(plain or {})

    document = ezdxf.new("R2010", units=_MM)
    document.styles.add(_STYLE, font=FONT)
    for name, pattern in _PATTERNS.items():
        document.linetypes.add(name, pattern)
    for line in LineKind:
        document.layers.add(
            line, lineweight=_WIDTHS.get(line, _THIN), linetype=line if line in _PATTERNS else "CONTINUOUS"
        )
    document.appids.add(APP)
    _dimension_style(document, drawing.scale)
    document.header["$DIMLFAC"] = 1.0 / drawing.scale  # LibreCAD reads this one, and not that of the style
    space = document.modelspace()
    for view in drawing.views:
        _Place(space, view, drawing.scale, say).draw()
    for table in drawing.tables:
        _table(space, table, say)
    for written, at in placed_notes([say(note) for note in drawing.notes], drawing.columns):
        _text(space, written, at, TEXT)
    _frame(space, drawing, say)
    width, height = SIZES[drawing.size]
    space.reset_extents((0.0, 0.0, 0.0), (width, height, 0.0))
    return document


def _dimension_style(document: Document, scale: float) -> None:
    document.dimstyles.new(
        _STYLE,
        dxfattribs={
            "dimtxsty": _STYLE,
            "dimtxt": TEXT,
            "dimasz": 2.5,
            "dimexe": 1.0,
            "dimexo": 0.5,
            "dimgap": _DIMGAP,
            "dimtad": 1,
            "dimdec": 3,
            "dimzin": 8,
            "dimdsep": ord("."),
            "dimtih": 0,
            "dimtoh": 0,  # 8: no last zeros
            "dimlfac": 1.0 / scale,
        },
    )


@dataclass(frozen=True)
class _Place:
    """A view at its place on the paper."""

    space: Modelspace
    view: View
    scale: float
    say: Callable[[str], str]

    def draw(self) -> None:
        for hatch in self.view.hatches:
            self._hatch(hatch)
        for curve in self.view.curves:
            self._curve(curve)
        for dimension in self.view.dimensions:
            self._dimension(dimension)
        for symbol in self.view.symbols:
            if isinstance(symbol, DatumFeature):
                self._datum(symbol)
            elif isinstance(symbol, ToleranceFrame):
                self._tolerance(symbol)
            elif isinstance(symbol, EdgeState):
                self._edge(symbol)
            else:
                self._texture(symbol)
        for label in self.view.labels:
            text, at = self.say(label.text), self._on_paper(label.at)
            _text(self.space, text, at, label.height, TextEntityAlignment.MIDDLE_CENTER)

    def _texture(self, texture: SurfaceTexture) -> None:
        x, y = self._on_paper(texture.tip)
        if texture.bend is not None:
            bend = Vec2(self._on_paper(texture.bend))
            side = 1.0 if texture.bend[0] >= texture.tip[0] else -1.0
            end = bend + Vec2(side * (LEVEL + texture.width), 0.0)
            self._leader(Vec2(x, y), bend, end, circled=texture.all_around)
            x, y = min(end.x, bend.x + side * LEVEL), bend.y
        _surface_symbol(self.space, x, y)
        _text(self.space, texture.value, (x + SIGN, y + 1.6), TEXT)

    def _edge(self, edge: EdgeState) -> None:
        layer = {"layer": LineKind.DIMENSION.value}
        tip, bend = Vec2(self._on_paper(edge.tip)), Vec2(self._on_paper(edge.bend))
        way = (tip - bend).normalize()
        across, back = way.orthogonal() * (2.5 / 6), tip - way * 2.5
        self.space.add_line(tip, bend, dxfattribs=layer)
        self.space.add_solid([back + across, back - across, tip, tip], dxfattribs=layer)
        _edge_sign(self.space, bend, edge.value, LineKind.DIMENSION, circled=True)
        if before := edge.before.rstrip():
            _text(self.space, before, (bend.x - 2.0 - TEXT * text_length(before), bend.y + 0.5), TEXT)

    def _leader(self, tip: Vec2, bend: Vec2, end: Vec2, *, circled: bool) -> None:
        """Leader with its arrow at a point, and the circle that says all around."""
        layer = {"layer": LineKind.DIMENSION.value}
        way = (tip - bend).normalize()
        across = way.orthogonal() * (2.5 / 6)
        self.space.add_lwpolyline([tip, bend, end], dxfattribs=layer)
        back = tip - way * 2.5
        self.space.add_solid([back + across, back - across, tip, tip], dxfattribs=layer)
        if circled:
            self.space.add_circle(bend, 1.25, dxfattribs=layer)

    def _datum(self, datum: DatumFeature) -> None:
        foot, way = Vec2(self._on_paper(datum.foot)), Vec2.from_deg_angle(datum.angle)
        side, height = TRIANGLE
        across, tip, box = way.orthogonal() * (side / 2), foot + way * height, foot + way * datum.reach
        layer = {"layer": LineKind.DIMENSION.value}
        self.space.add_solid([foot + across, foot - across, tip, tip], dxfattribs=layer)
        half = FRAME_HEIGHT / 2
        self.space.add_line(tip, box - way * (half / max(abs(way.x), abs(way.y))), dxfattribs=layer)
        corners = [(box.x + x * half, box.y + y * half) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        self.space.add_lwpolyline(corners, close=True, dxfattribs=layer)
        _text(self.space, datum.letter, (box.x, box.y), TEXT, TextEntityAlignment.MIDDLE_CENTER)

    def _tolerance(self, tolerance: ToleranceFrame) -> None:
        layer = {"layer": LineKind.DIMENSION.value}
        tip, bend = Vec2(self._on_paper(tolerance.tip)), Vec2(self._on_paper(tolerance.bend))
        end = bend + Vec2(tolerance.side * LEVEL, 0.0)
        self._leader(tip, bend, end, circled=tolerance.all_around)
        left = end.x - (0.0 if tolerance.side > 0 else sum(tolerance.cells))
        low, edges = end.y - FRAME_HEIGHT / 2, np.cumsum([left, *tolerance.cells]).tolist()
        corners = [(edges[0], low), (edges[-1], low), (edges[-1], low + FRAME_HEIGHT), (edges[0], low + FRAME_HEIGHT)]
        self.space.add_lwpolyline(corners, close=True, dxfattribs=layer)
        for edge in edges[1:-1]:
            self.space.add_line((edge, low), (edge, low + FRAME_HEIGHT), dxfattribs=layer)
        middles = [((start + stop) / 2, end.y) for start, stop in pairwise(edges)]
        for stroke in _SYMBOLS[tolerance.characteristic]:
            points = np.array(middles[0]) + TEXT * stroke
            self.space.add_lwpolyline(points.tolist(), dxfattribs=layer)
        for text, at in zip((tolerance.zone_text, *tolerance.datums), middles[1:], strict=True):
            _text(self.space, text, at, TEXT, TextEntityAlignment.MIDDLE_CENTER)

    def _on_paper(self, point: tuple[float, float]) -> tuple[float, float]:
        x, y = self.view.place
        return x + self.scale * point[0], y + self.scale * point[1]

    def _curve(self, curve: Closed | Stroke) -> None:
        attributes = {"layer": curve.line.value}
        if isinstance(curve, Stroke):
            points = np.array(self.view.place) + self.scale * curve.points
            # Dashes run on over the corners (128), as they do along a circle.
            self.space.add_lwpolyline(points.tolist(), dxfattribs=attributes | {"flags": 128})
            return
        contour = curve.contour
        if contour.is_circle:
            x, y = contour.centers[0].tolist()
            self.space.add_circle(self._on_paper((x, y)), self.scale * float(contour.radii[0]), dxfattribs=attributes)
            return
        corners = np.array(self.view.place) + self.scale * contour.vertices
        sides = np.column_stack([corners, contour.bulges])
        self.space.add_lwpolyline(sides.tolist(), format="xyb", close=True, dxfattribs=attributes)

    def _hatch(self, hatch: Hatch) -> None:
        """Lines at 45 degrees: a HATCH entity is drawn by its readers in ways of their own, and in no fixed order."""
        outlines = [np.array(self.view.place) + self.scale * outline for outline in (hatch.outside, *hatch.holes)]
        area = shapely.Polygon(outlines[0], outlines[1:])
        left, low, right, high = area.bounds
        step = _HATCH_STEP * np.sqrt(2.0)
        starts = np.arange(np.ceil((left - high) / step), np.floor((right - low) / step) + 1) * step
        lines = shapely.linestrings([[[low + x, low], [high + x, high]] for x in starts.tolist()])
        for piece in shapely.get_parts(shapely.intersection(area, lines)):
            if isinstance(piece, shapely.LineString) and not piece.is_empty:
                self.space.add_line(*np.asarray(piece.coords).tolist(), dxfattribs={"layer": LineKind.HATCH.value})

    def _dimension(self, dimension: Dimension) -> None:
        text = self._number(dimension)
        attributes = {"layer": LineKind.DIMENSION.value}
        letters = {"dimtxsty": _style(self.space, text)} if any(map(is_wide, text)) else {}
        made: ezdxf.entities.DimStyleOverride
        if isinstance(dimension, DiameterDimension | RadiusDimension):
            # The text stands outside the circle, on the dimension line's own side.
            centre, whole = self._on_paper(dimension.centre), isinstance(dimension, DiameterDimension)
            radius = self.scale * length_of(dimension) / (2 if whole else 1)
            made = (self.space.add_diameter_dim if whole else self.space.add_radius_dim)(
                center=Vec2(centre),
                radius=radius,
                angle=dimension.angle,
                text=text,
                dimstyle=_STYLE,
                override={"dimtad": 1, "dimtofl": int(whole), "dimtmove": 0, **letters},
                location=Vec2(centre) + Vec2.from_deg_angle(dimension.angle, dimension.reach or radius + 9.0),
                dxfattribs=attributes,
            )
        elif isinstance(dimension, AngularDimension):
            made = self.space.add_angular_dim_cra(
                center=self._on_paper(dimension.centre),
                radius=self.scale * dimension.radius - 1.0,
                start_angle=dimension.start,
                end_angle=dimension.end,
                distance=1.0,
                text=text,
                dimstyle=_STYLE,
                override={"dimse1": 1, "dimse2": 1},
                dxfattribs=attributes,
            )
        else:
            made = self._linear(dimension, text, letters)
        made.render()
        made.dimension.dxf.text = text.replace(DIAMETER, _SIGN)
        for drawn in made.dimension.get_geometry_block().query("MTEXT"):
            along, middle = Vec2.from_deg_angle(float(drawn.get_rotation())), Vec2(drawn.dxf.insert)
            half = along * (text_length(drawn.plain_text()) * TEXT / 2 + 0.8)
            if dimension.exact:
                across = along.orthogonal() * (TEXT / 2 + 0.5)
                corners = [middle + x * half + y * across for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                self.space.add_lwpolyline(corners, close=True, dxfattribs=attributes)
            if isinstance(dimension, LinearDimension) and dimension.beside:
                self._under(dimension, middle, half)
            drawn.text = drawn.text.replace(DIAMETER, _SIGN)
        made.dimension.set_xdata(APP, [(1000, dimension.name)])

    def _number(self, dimension: Dimension) -> str:
        """Text of a dimension: of "<>" in a diameter some readers make its sign, and some do not."""
        match dimension:
            case DiameterDimension():
                number = f"{dimension.prefix}{dimension.sign}{rounded(dimension.diameter)}"
            case RadiusDimension():
                number = f"R{rounded(dimension.radius)}"
            case AngularDimension():
                return f"{rounded(length_of(dimension), 2)}°"
            case _:
                number = f"{dimension.prefix}<>"
        return f"{number}{self.say(dimension.suffix)}"

    def _linear(
        self, dimension: LinearDimension, text: str, letters: Mapping[str, str]
    ) -> ezdxf.entities.DimStyleOverride:
        upright = 90.0 - (90.0 - dimension.angle) % 180.0  # so that no number stands on its head
        ends = sorted((dimension.start, dimension.end), key=Vec2.from_deg_angle(upright).dot)
        place = None
        if dimension.beside:
            # The number stands beside the middle of its dimension line, above that line.
            along, (first, last) = Vec2.from_deg_angle(dimension.angle), self._line_ends(dimension)
            above = Vec2.from_deg_angle(180.0 - (90.0 - dimension.angle) % 180.0) * (_DIMGAP + TEXT / 2)
            place = (first + last) / 2 + along * dimension.beside + above
        return self.space.add_linear_dim(
            base=self._on_paper(dimension.at),
            p1=self._on_paper(ends[0]),
            p2=self._on_paper(ends[1]),
            location=place,
            angle=upright,
            text=text,
            dimstyle=_STYLE,
            override={**({"dimtmove": 2, "dimtofl": 1} if dimension.beside else {}), **letters},
            dxfattribs={"layer": LineKind.DIMENSION.value},
        )

    def _line_ends(self, dimension: LinearDimension) -> tuple[Vec2, Vec2]:
        """Ends of a dimension line on the paper."""
        along = Vec2.from_deg_angle(dimension.angle)
        base, *marks = (Vec2(self._on_paper(at)) for at in (dimension.at, dimension.start, dimension.end))
        first, last = (base + along * (mark - base).dot(along) for mark in marks)
        return first, last

    def _under(self, dimension: LinearDimension, middle: Vec2, half: Vec2) -> None:
        """The dimension line drawn on, from its nearer end to under a number beside it (ISO 129-1).

        Args:
            dimension: dimension whose number stands beside its line.
            middle: middle of its number on the paper.
            half: half of the number along the line.
        """
        ends = self._line_ends(dimension)
        near = min(ends, key=middle.distance)
        other = ends[1] if near is ends[0] else ends[0]
        out = (near - other).normalize()
        far = near + out * ((middle - near).dot(out) + half.magnitude)
        self.space.add_line(near, far, dxfattribs={"layer": LineKind.DIMENSION.value})


def _text(
    space: Modelspace,
    text: str,
    at: tuple[float, float],
    height: float,
    align: TextEntityAlignment = TextEntityAlignment.LEFT,
) -> None:
    plain = text.replace("^", "^ ").replace("%%", "% %")  # of a TEXT both begin codes
    style = _style(space, plain)
    drawn = space.add_text(plain, height=height, dxfattribs={"layer": LineKind.TEXT.value, "style": style})
    drawn.set_placement(at, align=align)


def _style(space: Modelspace, text: str) -> str:
    """Style that has the letters of a text; that for Chinese ones is added to the sheet where it is first used."""
    style = FAR_EASTERN_STYLE if any(map(is_wide, text)) else _STYLE
    if style not in space.doc.styles:
        space.doc.styles.add(style, font=_FAR_EASTERN_FONT)
    return style


@cache
def text_length(text: str) -> float:
    """Length of a text in heights of its letters; with room to spare for Chinese ones, whose font the system gives."""
    know_font()
    latin = "".join(letter for letter in text if not is_wide(letter))
    return WIDE * (len(text) - len(latin)) + float(fonts.make_font(FONT, 1.0).text_width(latin))


def table_widths(table: SheetTable, say: Callable[[str], str]) -> list[float]:
    """Widths of a table's columns, mm; they are chosen for Latin letters.

    In a language of wide letters a column that is too narrow takes what the others can spare.
    """
    columns = [[say(cell) for cell in column] for column in zip_longest(*table.rows, fillvalue="")]
    needed = [TEXT * max(map(text_length, column)) + _BESIDE for column in columns]
    lacking = [max(need - width, 0.0) for need, width in zip(needed, table.widths, strict=True)]
    spare = [max(width - need, 0.0) for need, width in zip(needed, table.widths, strict=True)]
    wide = any(is_wide(letter) for column in columns for cell in column for letter in cell)
    if not wide or sum(lacking) > sum(spare):
        return list(table.widths)  # letters of the next smaller height have room
    share = sum(lacking) / (sum(spare) or 1.0)
    return [width + lack - share * rest for width, lack, rest in zip(table.widths, lacking, spare, strict=True)]


def _table(space: Modelspace, table: SheetTable, say: Callable[[str], str]) -> None:
    x, y = table.at
    if table.title:
        _text(space, say(table.title), (x, y - 0.7 * ROW), TEXT)
    top = y - ROW
    bottom = top - len(table.rows) * ROW
    widths = table_widths(table, say)
    edges = [x + sum(widths[:n]) for n in range(len(widths) + 1)]
    thin = {"layer": LineKind.THIN.value}
    cells = [(say(cell), width - _BESIDE) for row in table.rows for cell, width in zip(row, widths, strict=False)]
    height = height_within([text_length(cell) for cell, _ in cells], [room for _, room in cells], TEXT)
    for number in range(len(table.rows) + 1):
        if number < 2 or number == len(table.rows) or not table.headed:
            space.add_line((x, top - number * ROW), (edges[-1], top - number * ROW), dxfattribs=thin)
    for edge in edges:
        space.add_line((edge, top), (edge, bottom), dxfattribs=thin)
    for number, row in enumerate(table.rows):
        for column, (left, cell) in enumerate(zip(edges, row, strict=False)):
            middle = top - (number + 0.5) * ROW
            _text(space, say(cell), (left + 1.0, middle - height / 2), height)
            if (number, column) in table.exact:
                near, far = left + 0.5, left + 1.4 + height * text_length(say(cell))
                low, high = middle - height / 2 - _AROUND, middle + height / 2 + _AROUND
                corners = [(near, low), (far, low), (far, high), (near, high)]
                space.add_lwpolyline(corners, close=True, dxfattribs=thin)


def _frame(space: Modelspace, drawing: DrawingSheet, say: Callable[[str], str]) -> None:
    width, height = SIZES[drawing.size]
    frame = {"layer": LineKind.FRAME.value}
    corners = [(LEFT, EDGE), (width - EDGE, EDGE), (width - EDGE, height - EDGE), (LEFT, height - EDGE)]
    space.add_lwpolyline(corners, close=True, dxfattribs=frame)
    across, up = TITLE_SIZE
    x, y = width - EDGE - across, EDGE
    space.add_lwpolyline([(x, y), (x, y + up), (x + across, y + up)], dxfattribs=frame)
    title = drawing.title
    as_printed = Message("as printed") if title.printed else ""
    cells = [  # column, row from below, width of the cell in columns, name, text
        (0, 5, 2, Message("part"), title.part),
        (2, 5, 1, Message("kind of document"), title.document),
        (0, 4, 2, Message("title"), title.title),
        (2, 4, 1, Message("scale"), f"{scale_text(drawing.scale)}  ({drawing.size})"),
        (0, 3, 1, Message("material"), title.material or Message("not stated")),
        (1, 3, 1, Message("surface finish"), title.finish or as_printed or Message("not stated")),
        (2, 3, 0.5, Message("general tolerances"), as_printed or "ISO 2768-mK"),
        (2.5, 3, 0.5, Message("edges, ISO 13715"), as_printed),
        (0, 2, 1, Message("legal owner"), title.owner),
        (1, 2, 1, Message("drawn by"), title.drawn_by),
        (2, 2, 1, Message("approved by"), title.approved_by),
        (0, 1, 2, Message("design"), title.design),
        (2, 1, 1, Message("date"), title.date),
        (0, 0, 2, Message("number of the drawing"), title.number),
        (2, 0, 0.5, Message("quantity"), str(title.quantity)),
        (2.5, 0, 0.5, Message("sheet "), "1/1"),
    ]
    column, row = across / 3, up / 6
    deviates = any(isinstance(symbol, SurfaceTexture) for view in drawing.views for symbol in view.symbols)
    thin = {"layer": LineKind.THIN.value}
    for at, level, span, name, text in cells:
        left, low = x + at * column, y + level * row
        space.add_lwpolyline(
            [(left, low), (left + span * column, low), (left + span * column, low + row), (left, low + row)],
            close=True,
            dxfattribs=thin,
        )
        _text(space, say(name).rstrip(), (left + 1.0, low + row - 2.4), HEIGHTS[-1])
        text, start = say(text), left + 1.0
        rough = bool(_ROUGHNESS.match(text))
        if rough:
            _surface_symbol(space, start, low + 1.0)
            start += SIGN
        most = 3.5 if level > 3 and span > 1 else TEXT
        aside = SIGN + 3.5 if rough and deviates else 0.0
        room = left + span * column - 1.0 - start - aside
        letters = height_within([text_length(text)], [room], most)
        # Chinese letters are higher than Latin capitals: large ones would touch the name of the cell.
        above = 1.0 if letters > TEXT and any(map(is_wide, text)) else 1.4
        _text(space, text, (start, low + above), letters)
        if aside:  # a sign in brackets: some surfaces on the sheet have signs of their own (ISO 21920-1)
            after = start + letters * text_length(text) + 1.0
            _text(space, "(", (after, low + 1.4), TEXT)
            _surface_symbol(space, after + 1.2, low + 1.0)
            _text(space, ")", (after + SIGN + 1.0, low + 1.4), TEXT)
    if not title.printed:
        inner = title.edge if title.inner is None else title.inner
        _edge_signs(space, x + 2.5 * column + 0.6, y + 3 * row, title.edge, inner)
    _first_angle(space, x + across - 9.0, y + 4.5 * row)
    if title.verdict:
        verdict = say(title.verdict)
        _text(space, verdict, (x + 1.0, y + up + 2.0), height_within([text_length(verdict)], [across - 2.0], 3.5))


def _surface_symbol(space: Modelspace, x: float, y: float) -> None:
    """The sign of a surface texture (ISO 21920-1), by whatever process; its left end over a point, mm."""
    slope = 1 / np.sqrt(3.0)
    points = [(x, y + 1.8), (x + 1.8 * slope, y), (x + (1.8 + 3.6) * slope, y + 3.6)]
    space.add_lwpolyline(points, dxfattribs={"layer": LineKind.THIN.value})


def _edge_sign(space: Modelspace, corner: Vec2, value: str, line: LineKind, *, circled: bool = False) -> None:
    """The sign of an edge (ISO 13715) with a size, its corner at a point on the paper, mm.

    Args:
        space: sheet.
        corner: corner of the sign.
        value: size: below 0 off an outer edge or into an inner one, above 0 in excess.
        line: layer of its lines.
        circled: whether a circle at the corner says all around.
    """
    start = 1.7 if circled else 0.8
    corners = [corner + Vec2(0.0, 3.2), corner, corner + Vec2(start + TEXT * text_length(value) + 0.8, 0.0)]
    space.add_lwpolyline(corners, dxfattribs={"layer": line.value})
    if circled:
        space.add_circle(corner, 1.25, dxfattribs={"layer": line.value})
    _text(space, value, (corner.x + start, corner.y + 0.6), TEXT)


def _edge_signs(space: Modelspace, x: float, y: float, outer: float, inner: float) -> None:
    """Signs for all edges (ISO 13715): an outer one with how much may be off, an inner one with how much may stand.

    Args:
        space: sheet.
        x: left end, mm on the paper.
        y: lower end, mm on the paper.
        outer: size of outer edges, mm.
        inner: size of inner ones, mm.
    """
    for left, value, sides in (
        (x, f"-{rounded(outer)}", (Vec2(-1.8, 0.0), Vec2(0.0, -0.7))),
        (x + 11.2, f"+{rounded(inner)}", (Vec2(0.0, 1.5), Vec2(1.5, 0.0))),
    ):
        corner, apex = Vec2(left + 3.6, y + 1.6), Vec2(left + 2.2, y + 1.0)
        space.add_line(apex, corner, dxfattribs={"layer": LineKind.THIN.value})
        edge = [apex + sides[0], apex, apex + sides[1]]
        space.add_lwpolyline(edge, dxfattribs={"layer": LineKind.VISIBLE.value})
        _edge_sign(space, corner, value, LineKind.THIN)


def _first_angle(space: Modelspace, x: float, y: float) -> None:
    """The sign of projection in the first angle (ISO 5456-2), its middle at a point on the paper, mm."""
    small, length = 1.3, 5.2
    left, right, ring = x - 6.5, x - 6.5 + length, x + 3.9
    cone = [(left, y - small), (right, y - 2 * small), (right, y + 2 * small), (left, y + small)]
    space.add_lwpolyline(cone, close=True, dxfattribs={"layer": LineKind.FRAME.value})
    for radius in (small, 2 * small):
        space.add_circle((ring, y), radius, dxfattribs={"layer": LineKind.FRAME.value})
    thin = {"layer": LineKind.THIN.value}
    for start, end in (
        ((left - 1.0, y), (right + 1.0, y)),
        ((ring - 3.6, y), (ring + 3.6, y)),
        ((ring, y - 3.6), (ring, y + 3.6)),
    ):
        space.add_line(start, end, dxfattribs=thin)


def read_dimensions(path: Path) -> dict[str, float]:
    """Length of every dimension in a file by its name, mm of the part, or degrees: measured on points, not on text.

    Raises:
        FileError: the file is damaged, or has a dimension without a name.
    """
    try:
        document = ezdxf.readfile(path)
        faults = document.audit().errors
        if faults:
            raise FileError(
                "{name} has {faults} faults, the first: {message}: write it again",
                name=path.name,
                faults=len(faults),
                message=faults[0].message,
            )
        lengths = {}
        for entity in document.modelspace().query("DIMENSION"):
            name = next(value for code, value in entity.get_xdata(APP) if code == 1000)
            if name in lengths:
                raise FileError(
                    "{name} has two dimensions named {dimension}: write it again", name=path.name, dimension=name
                )
            factor = document.dimstyles.get(entity.dxf.dimstyle).dxf.dimlfac
            angle = entity.dxf.dimtype & 7 in _ANGULAR
            lengths[name] = float(entity.get_measurement()) * (1.0 if angle else factor)
    except (OSError, ezdxf.DXFError, StopIteration) as error:
        raise FileError(
            "{name} is no whole DXF of a drawing ({error}): write it again", name=path.name, error=str(error)
        ) from error
    return lengths


# Beginnings of the names of their files in Windows, macOS and Linux, the plain ones first.
_FAR_EASTERN = (
    "msyh.",
    "simhei",
    "notosanssc",
    "notosanscjk-regular",
    "notosanscjksc-regular",
    "sourcehansans",
    "pingfang",
    "hiragino sans gb",
    "stheiti",
    "wqy",
    "droidsansfallback",
    "simsun",
    "notoserifcjk-regular",
    "arialuni",
    "arial unicode",
    "malgun.",
    "msgothic",
)


class NoFontError(FileError):
    """No font of the system has the letters of a page."""


def know_font() -> None:
    """Let ezdxf find the font that comes with matplotlib, also where the system has none."""
    if not fonts.font_manager.has_font(FONT):
        fonts.font_manager.build([str(_LATIN.parent)])


def know_far_eastern(letters: frozenset[str]) -> str:
    """Let ezdxf find a font of the system that has these letters, and return its name.

    Raises:
        NoFontError: there is none.
    """
    for file in _far_eastern_files():
        number = _face_with(file, letters)
        if number is not None:
            if not fonts.font_manager.has_font(file.name):
                fonts.font_manager.build([str(file.parent)], support_dirs=False)
            fonts.font_manager.get_ttf_font(file.name, font_number=number)
            return file.name
    lacking = " ".join(sorted(letters, reverse=True)[:3])
    raise NoFontError(
        "no font of this system has {lacking}: install one with Chinese letters, such as Noto Sans CJK, or "
        "write drawing.title and drawing.finish in Latin letters",
        lacking=lacking,
    )


@cache
def _far_eastern_files() -> tuple[Path, ...]:
    """Fonts of the system that may have Chinese letters, the plain ones first."""
    files = sorted(map(Path, findSystemFonts()))
    return tuple(file for begin in _FAR_EASTERN for file in files if file.name.lower().startswith(begin))


def _face_with(file: Path, letters: frozenset[str]) -> int | None:
    """Number of a face of a file that has all letters, the simplified Chinese one if there is one; None without."""
    try:
        faces = TTCollection(file, lazy=True).fonts if file.suffix.lower() == ".ttc" else [TTFont(file, lazy=True)]
        families = [str(face["name"].getBestFamilyName()) for face in faces]
        plain = [number for number, family in enumerate(families) if family.endswith((" SC", " CN"))]
        order: dict[int, None] = dict.fromkeys([*plain, *range(len(faces))])
        for number in order:
            known = faces[number].getBestCmap() or ()
            if all(ord(letter) in known for letter in letters):
                return number
    except (OSError, TTLibError):
        pass
    return None


_AROUND = 0.5  # mm from a text in a table to the box that says it is theoretically exact
_BESIDE = 1.5  # mm of a table's column that are beside its text
_INCH = 25.4
_POINT = 72 / _INCH  # points in a mm
_CAPITAL = 0.73  # height of a capital letter in sizes of its font
_LATIN = Path(matplotlib.get_data_path()) / "fonts" / "ttf" / FONT
_THINNEST = 0.13  # mm


def _searchable(axes: Axes, document: Document) -> None:
    """Write the texts of a page once more, unseen, for readers that search and copy them: they are drawn as outlines.

    Args:
        axes: axes of the page, in mm.
        document: sheet that is drawn on it.
    """
    plain = {_STYLE: FontProperties(fname=str(_LATIN))}
    if FAR_EASTERN_STYLE in document.styles:
        name = document.styles.get(FAR_EASTERN_STYLE).dxf.font
        plain[FAR_EASTERN_STYLE] = FontProperties(
            fname=str(next(file for file in _far_eastern_files() if file.name == name))
        )

    def write(text: str, at: Vec3, height: float, style: str, align: str, turn: float = 0.0) -> None:
        axes.text(
            at.x,
            at.y,
            text,
            size=height * _POINT / _CAPITAL,
            rotation=turn,
            rotation_mode="anchor",
            ha=align,
            va="center" if align == "center" else "baseline",
            fontproperties=plain[style],
            parse_math=False,
            fontfeatures=("-liga",),  # a ligature is another letter, which no search finds
            alpha=0.0,
        )

    space = document.modelspace()
    for text in space.query("TEXT"):
        align, start, _ = text.get_placement()
        middle = align is TextEntityAlignment.MIDDLE_CENTER
        write(text.dxf.text, start, text.dxf.height, text.dxf.style, "center" if middle else "left")
    for dimension in space.query("DIMENSION"):
        for number in dimension.get_geometry_block().query("MTEXT"):
            turn = float(number.get_rotation())
            write(
                number.plain_text().replace(_SIGN, DIAMETER), number.dxf.insert, TEXT, number.dxf.style, "center", turn
            )


class _Backend(MatplotlibBackend):  # type: ignore[misc]
    """Letters filled by the winding of their outlines; by nested boxes, as ezdxf has it, a turned Ø is filled half."""

    def draw_filled_paths(self, paths: Iterable[BkPath2d], properties: BackendProperties) -> None:
        """Draw filled outlines."""
        path = to_matplotlib_path(paths, detect_holes=False)
        # As an artist, and not as a patch, whose limits would be reckoned, which takes three quarters of the time.
        self.ax.add_artist(PathPatch(path, color=properties.color, linewidth=0, fill=True, zorder=self._get_z()))
