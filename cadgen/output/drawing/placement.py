"""Room for texts among the lines of a view: of several places for a dimension or a label, the one crossed least."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import TypeVar

import numpy as np
import shapely
from shapely.affinity import rotate, translate

from cadgen.arrays import Array
from cadgen.output.drawing.sheet import (
    FRAME_HEIGHT,
    LEVEL,
    SIGN_HEIGHT,
    TEXT,
    AngularDimension,
    Closed,
    DatumFeature,
    DiameterDimension,
    Dimension,
    EdgeState,
    Label,
    LinearDimension,
    LineKind,
    RadiusDimension,
    Stroke,
    SurfaceTexture,
    Symbol,
    ToleranceFrame,
    length_of,
    rounded,
    width_of,
)

_CHORD = 0.02  # mm, of curves
_LETTER = 0.76  # mean width of a letter in heights
_GAP = 0.6  # mm on paper between a dimension line and its text, as in the DXF
_AIR = 1.2  # mm on paper around a text that is better left free
# How much worse a mm of a line through a text is than a mm farther off: lines of the part, and all others.
_HEAVY, _LIGHT, _FAR = 10.0, 3.0, 0.05
_ACROSS = 8.0  # cost of a dimension line across a line of the part, as much as being 100 degrees turned
_OUTSIDE, _FRAME = 10.0, 12.0  # cost of a mm farther from the part than a view has room on its sheet, and that room, mm
_TURN = 0.08  # cost of a turned dimension line, a degree
_OUT = 9.0  # mm on paper from a circle to the middle of its text, where there is room
_STEP = 3.0  # mm on paper between places along a dimension line
_TURNS = (0, *(side * turn for turn in range(8, 180, 8) for side in (1, -1)))  # degrees


Placed = TypeVar(
    "Placed",
    DiameterDimension,
    RadiusDimension,
    AngularDimension,
    LinearDimension,
    Label,
    ToleranceFrame,
    SurfaceTexture,
    EdgeState,
    DatumFeature,
)
Round = TypeVar("Round", DiameterDimension, RadiusDimension)
Led = TypeVar("Led", ToleranceFrame, SurfaceTexture, EdgeState)
_LEADERS = (8.0, 11.0, 14.0, 18.0, 23.0)  # mm on paper from a feature to a tolerance frame


class Room:
    """Lines and texts that stand in a view already, in mm on paper about the view's place."""

    def __init__(self, curves: Sequence[Closed | Stroke], scale: float) -> None:
        """Begin with the lines of a view.

        Args:
            curves: curves of the part, mm.
            scale: mm on paper for a mm of the part.
        """
        self._scale = scale
        heavy = [_line(curve, scale) for curve in curves if curve.line in (LineKind.VISIBLE, LineKind.THIN)]
        light = [_line(curve, scale) for curve in curves if curve.line not in (LineKind.VISIBLE, LineKind.THIN)]
        self._heavy, self._light = shapely.union_all(heavy), shapely.union_all(light)
        self._texts: shapely.Geometry = shapely.Polygon()
        points = np.concatenate([shapely.get_coordinates(line) for line in heavy])
        self._reach = float(np.linalg.norm(points, axis=1).max())

    def take(self, placed: Dimension | Label | Symbol) -> None:
        """Let a dimension, a label or a symbol stand where it is."""
        box, lines = self._drawn(placed)
        self._texts = shapely.union(self._texts, box)
        self._light = shapely.union_all([self._light, *lines])

    def off_texts(self, curve: Closed) -> Iterator[Closed | Stroke]:
        """Yield a curve without what lies under the texts and frames that stand there already (ISO 128-2).

        Args:
            curve: closed curve, mm.
        """
        whole = _line(curve, self._scale)
        left = whole.difference(self._texts.buffer(_GAP))
        if left.equals(whole):
            yield curve
            return
        # The ends of the ring meet where no text stands.
        joined = left if isinstance(left, shapely.LineString) else shapely.line_merge(left)
        for piece in shapely.get_parts(joined):
            yield Stroke(shapely.get_coordinates(piece) / self._scale, curve.line)

    def dimensions(self, dimensions: Sequence[Dimension], labels: Sequence[Label]) -> tuple[Dimension, ...]:
        """The dimensions of a view, its diameters and the numbers beside short lines written where there is room.

        Args:
            dimensions: dimensions; those whose number stands in the middle of a line stay as they are.
            labels: texts that stay where they are.
        """
        lines = {each.name: each for each in dimensions if isinstance(each, LinearDimension)}
        for label in labels:
            self.take(label)
        for line in lines.values():
            if not line.beside:
                self.take(line)
        moved = {name: self.linear(_number_places(each, self._scale)) for name, each in lines.items() if each.beside}
        return tuple(self._placed(each, moved) for each in dimensions)

    def _placed(self, each: Dimension, moved: Mapping[str, LinearDimension]) -> Dimension:
        """A dimension where there is room, after the lengths with numbers beside their lines."""
        if isinstance(each, DiameterDimension):
            return self.diameter(each)
        if isinstance(each, RadiusDimension):
            return self.diameter(each)
        if isinstance(each, AngularDimension):
            radii = [each.radius + step / self._scale for step in np.arange(-24.0, 25.0, 3.0)]
            every = [(replace(each, radius=radius), _FAR * abs(radius - each.radius)) for radius in radii if radius > 0]
            return self._best(every)
        return moved.get(each.name, each)

    def diameter(self, dimension: Round) -> Round:
        """The dimension with its text where it is crossed least, a little turned or farther out if need be."""
        near = self._scale * _radius(dimension) + _OUT
        centre = float(np.hypot(*dimension.centre)) * self._scale
        far = max(self._reach + centre, near) + 12.0
        ways = np.arange(near - 3.0, far, _STEP)
        every = [
            (
                replace(dimension, angle=dimension.angle + turn, reach=float(way)),
                _FAR * abs(way - near) + _TURN * abs(turn),
            )
            for turn in _TURNS
            for way in ways
        ]
        return self._best(every)

    def linear(self, candidates: Iterable[LinearDimension]) -> LinearDimension:
        """Dimension that is crossed least of several, the first if none is crossed."""
        return self._best([(each, _FAR * number) for number, each in enumerate(candidates)])

    def label(
        self,
        text: str,
        around: tuple[float, float],
        away: float,
        height: float,
        extent: tuple[float, float] = (0.0, 0.0),
    ) -> Label:
        """A label where there is room about a point of the part.

        Args:
            text: text of the label.
            around: the point, mm.
            away: distance of the label from it on paper, mm.
            height: height of the letters on paper, mm.
            extent: half the width and height of what stands there, mm on paper, which the label keeps off.
        """
        return self._best(self._around(text, around, away, height, extent))

    def within(self, text: str, middle: tuple[float, float], away: float, extent: tuple[float, float]) -> Label:
        """A label within a rectangle, in its middle if no line is there; beside it where lines take all of it.

        Args:
            text: text of the label.
            middle: middle of the rectangle, mm.
            away: distance of the label from the rectangle, where it stands beside it, mm on paper.
            extent: half its width and height, mm on paper.
        """
        (x, y), (wide, high) = middle, (each / 2 / self._scale for each in extent)
        places = [(x + across * wide, y + up * high) for across, up in product((0, 1, -1), repeat=2)]
        inside = [(Label(text=text, at=at), _FAR * number) for number, at in enumerate(places)]
        beside = self._around(text, middle, away, TEXT, extent)
        return self._best([*inside, *((label, 1.0 + cost) for label, cost in beside)])

    def _around(
        self, text: str, around: tuple[float, float], away: float, height: float, extent: tuple[float, float]
    ) -> list[tuple[Label, float]]:
        """Places of a label about a point, as of `label`, each with how much it is worse than the first."""
        angles = np.radians([45, 135, -45, -135, 0, 90, 180, -90])
        units = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        reaches = (away,) if extent == (0.0, 0.0) else (away, away + 2.5, away + 5.0)
        sides = np.rint(units) * np.array(extent)
        ways = np.concatenate([sides + reach * units for reach in reaches]) / self._scale
        return [
            (Label(text=text, at=(around[0] + x, around[1] + y), height=height), _FAR * number)
            for number, (x, y) in enumerate(ways.tolist())
        ]

    def frame(self, frame: Led, tips: Sequence[tuple[Array, Array]], leaders: Sequence[float] = _LEADERS) -> Led:
        """A tolerance frame, or the sign of a texture on a leader, where there is room beside its feature.

        Args:
            frame: tolerance or texture, wherever it stands.
            tips: points of the feature, mm on the part, each with the direction that leads away from the material.
            leaders: lengths of the leader, mm on paper.
        """
        every = []
        for point, out in tips:
            for number, way in enumerate(leaders):
                end = point + way / self._scale * out
                placed = replace(frame, tip=(float(point[0]), float(point[1])), bend=(float(end[0]), float(end[1])))
                every.append((placed, _FAR * way * (number + 1) + 2.0 * float(abs(out[1]) > 0.97)))
        return self._best(every)

    def datum(
        self, datum: DatumFeature, reaches: Sequence[float] = (8.0, 10.0, 12.5, 15.0, 18.0, 21.0)
    ) -> DatumFeature:
        """A datum with its letter as near to the feature as there is room.

        Args:
            datum: datum with its foot and direction.
            reaches: distances of the letter from the foot, mm on paper.
        """
        return self._best([(replace(datum, reach=reach), _FAR * reach) for reach in reaches])

    def hung(self, letter: str, frame: ToleranceFrame) -> DatumFeature:
        """A datum that hangs from a tolerance frame, which is the feature of that frame (ISO 5459).

        Args:
            letter: letter of the datum.
            frame: frame, as it is placed.
        """
        x, y = self._scale * np.array(frame.bend)
        every = []
        for number, (share, angle) in enumerate((share, angle) for angle in (270.0, 90.0) for share in (0.5, 0.2, 0.8)):
            along = x + frame.side * (LEVEL + share * sum(frame.cells))
            up = y + (FRAME_HEIGHT / 2 if angle == 90.0 else -FRAME_HEIGHT / 2)
            foot = (along / self._scale, up / self._scale)
            every.append((DatumFeature(letter=letter, foot=foot, angle=angle, reach=6.5), _FAR * number))
        return self._best(every)

    def _best(self, every: Sequence[tuple[Placed, float]]) -> Placed:
        def cost(each: tuple[Placed, float]) -> float:
            box, drawn = self._drawn(each[0])
            lines, air = shapely.union_all(drawn), box.buffer(_AIR)
            # A frame is wide: it may stand in the corners beside a disc.
            order = np.inf if isinstance(each[0], ToleranceFrame | SurfaceTexture | EdgeState) else 2
            farthest = float(np.linalg.norm(shapely.get_coordinates([box, lines]), ord=order, axis=1).max())
            outside = _OUTSIDE * max(farthest - self._reach - _FRAME, 0.0)
            text = _HEAVY * (self._heavy.intersection(air).length + self._texts.intersection(air).area)
            text += _LIGHT * self._light.intersection(air).length
            line = _ACROSS * shapely.get_num_coordinates(self._heavy.intersection(lines))
            line += _LIGHT * self._light.intersection(lines).length + _HEAVY * self._texts.intersection(lines).length
            return float(each[1] + outside + text + line)

        # Without its lines a place costs less: the search ends where that alone is more than the best.
        least, best = np.inf, len(every)
        for number in sorted(range(len(every)), key=lambda each: every[each][1]):
            if every[number][1] > least:
                break
            least, best = min((least, best), (cost(every[number]), number))
        placed, _ = every[best]
        self.take(placed)
        return placed

    def _drawn(self, placed: Dimension | Label | Symbol) -> tuple[shapely.Polygon, list[shapely.Geometry]]:
        """Box of the text, and the lines that are drawn with it."""
        scale = self._scale
        if isinstance(placed, ToleranceFrame):
            tip, bend = scale * np.array(placed.tip), scale * np.array(placed.bend)
            near, y = bend + np.array([placed.side * LEVEL, 0.0])
            ends = sorted((near, near + placed.side * sum(placed.cells)))
            box = shapely.box(ends[0], y - FRAME_HEIGHT / 2, ends[1], y + FRAME_HEIGHT / 2)
            # From off the feature by a hair: its own line is no crossing.
            return box, [shapely.LineString([tip + 0.02 * (bend - tip), bend, (near, y)])]
        if isinstance(placed, SurfaceTexture):
            assert placed.bend is not None
            tip, bend = scale * np.array(placed.tip), scale * np.array(placed.bend)
            side = 1.0 if placed.bend[0] >= placed.tip[0] else -1.0
            near, far = sorted((bend[0] + side * LEVEL, bend[0] + side * (LEVEL + placed.width)))
            box = shapely.box(near, bend[1] + 0.2, far, bend[1] + SIGN_HEIGHT)
            level = bend + np.array([side * (LEVEL + placed.width), 0.0])
            return box, [shapely.LineString([tip + 0.02 * (bend - tip), bend, level])]
        if isinstance(placed, EdgeState):
            tip, bend = scale * np.array(placed.tip), scale * np.array(placed.bend)
            before = TEXT * width_of(placed.before)
            box = shapely.box(bend[0] - before - 1.5, bend[1] - 1.3, bend[0] + placed.width - before, bend[1] + 3.4)
            return box, [shapely.LineString([tip + 0.02 * (bend - tip), bend])]
        if isinstance(placed, DatumFeature):
            foot, half = scale * np.array(placed.foot), FRAME_HEIGHT / 2
            x, y = foot + placed.reach * _unit(placed.angle)
            return shapely.box(x - half, y - half, x + half, y + half), [
                shapely.LineString([foot + 0.3 * _unit(placed.angle), (x, y)])
            ]
        if isinstance(placed, Label):
            return _box(placed.text, scale * np.array(placed.at), 0.0, placed.height, above=False), []
        if isinstance(placed, AngularDimension):
            turns = np.linspace(placed.start, placed.end, 33)
            arc = scale * (np.array(placed.centre) + placed.radius * np.array([_unit(turn) for turn in turns]))
            text, angle = f"{rounded(length_of(placed), 2)}°", turns[16] - 90.0
            return _box(text, arc[16], angle, TEXT, above=True), [shapely.LineString(arc)]
        if isinstance(placed, DiameterDimension | RadiusDimension):
            whole = isinstance(placed, DiameterDimension)
            sign = f"{placed.prefix}{placed.sign}" if isinstance(placed, DiameterDimension) else "R"
            text = f"{sign}{rounded(length_of(placed))}{placed.suffix}"
            along = _unit(placed.angle)
            centre, radius = scale * np.array(placed.centre), scale * _radius(placed)
            middle = centre + (placed.reach or radius + _OUT) * along
            # As long as the text of letters as wide as they are high, which is how the DXF has it.
            begin = centre if whole else centre + (radius + 0.1) * along
            line = shapely.LineString([begin, middle + (TEXT * len(text) / 2 + _AIR) * along])
            return _box(text, middle, placed.angle, TEXT, above=True), [line]
        text = f"{placed.prefix}{rounded(length_of(placed))}{placed.suffix}"
        along = _unit(placed.angle)
        base, start, end = (scale * np.array(point) for point in (placed.at, placed.start, placed.end))
        first, last = (base + along * float((point - base) @ along) for point in (start, end))
        lines = [shapely.LineString(pair) for pair in ((first, last), (start, first), (end, last))]
        middle = (first + last) / 2 + (placed.beside or 0.0) * along
        return _box(text, middle, placed.angle, TEXT, above=True), lines


def _radius(dimension: DiameterDimension | RadiusDimension) -> float:
    """Radius of the circle that is dimensioned, mm."""
    return dimension.radius if isinstance(dimension, RadiusDimension) else dimension.diameter / 2


def _number_places(dimension: LinearDimension, scale: float) -> Iterator[LinearDimension]:
    """A dimension with its number at either end of its line, and with the line farther off, mm on paper."""
    aside = _unit(dimension.angle - 90.0) / scale
    for off in (0.0, 2.5, 5.0, 7.5, 10.0, 12.5, 15.0):
        x, y = np.array(dimension.at) + off * aside
        for side in (1, -1):
            yield replace(dimension, at=(float(x), float(y)), beside=side * dimension.beside)


def _line(curve: Closed | Stroke, scale: float) -> shapely.Geometry:
    if isinstance(curve, Stroke):
        return shapely.LineString(scale * curve.points)
    return shapely.LinearRing(scale * curve.contour.polygon(_CHORD))


def _unit(angle: float) -> Array:
    return np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])


def _box(text: str, at: Array, angle: float, height: float, *, above: bool) -> shapely.Polygon:
    """Box of a text that reads from left to right, its middle at a point on the paper or above it, mm."""
    half, upright = _LETTER * height * len(text) / 2, 90.0 - (90.0 - angle) % 180.0
    low = _GAP if above else -height / 2
    return translate(rotate(shapely.box(-half, low, half, low + height), upright, origin=(0.0, 0.0)), *at.tolist())
