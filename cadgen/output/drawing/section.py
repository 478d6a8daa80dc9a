"""Section of a body through its axis, from outlines alone, and the hole of a set screw in the views of a part."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from math import cos, sin

import numpy as np
import shapely

from cadgen.arrays import Array
from cadgen.output.drawing.sheet import (
    DIAMETER,
    SHORT,
    TAIL,
    TEXT,
    WIDEST,
    Closed,
    Hatch,
    LinearDimension,
    LineKind,
    Stroke,
    along_axis,
    rounded,
)
from cadgen.parts.blank import Blank
from cadgen.parts.body import RadialHole
from cadgen.parts.features import DFlat, Keyway

_FARTHEST = 1e4  # mm, beyond every part
_GRID = 1e-6  # mm, within which corners of neighbouring layers are one


@dataclass(frozen=True, slots=True, eq=False)
class Layer:
    """A prism of the body.

    Attributes:
        low: height at which it begins along the axis, mm.
        high: height at which it ends.
        rings: corners of nested outlines, each shape (n, 2), mm, outermost first: material lies inside every first and
            outside every second.
        holes: corners of further outlines, cut out of the material.
    """

    low: float
    high: float
    rings: tuple[Array, ...]
    holes: tuple[Array, ...] = ()


def material(layers: Sequence[Layer], angle: float) -> list[shapely.Polygon]:
    """Areas of material in the plane through the axis at polar angle `angle` (rad), in coordinates (z, r), mm.

    r counts along the direction `angle`: it is negative on the other side of the axis.

    Args:
        layers: layers of the part.
        angle: polar angle of the plane, rad.
    """
    along = np.array([np.cos(angle), np.sin(angle)])
    ray = shapely.LineString([-_FARTHEST * along, _FARTHEST * along])
    areas = []
    for layer in layers:
        discs = [shapely.Polygon(outline) for outline in layer.rings]
        rims = [
            disc if inside is None else shapely.difference(disc, inside)
            for disc, inside in zip_longest(discs[::2], discs[1::2])
        ]
        face = shapely.difference(shapely.union_all(rims), shapely.union_all([*map(shapely.Polygon, layer.holes)]))
        for piece in shapely.get_parts(shapely.intersection(face, ray)):
            ends = np.sort(np.asarray(piece.coords) @ along)
            areas.append(shapely.box(layer.low, ends[0], layer.high, ends[-1]))
    whole = shapely.union_all(shapely.set_precision(areas, _GRID))
    return [piece for piece in shapely.get_parts(whole) if isinstance(piece, shapely.Polygon)]


def edges_behind_cut(layers: Sequence[Layer], areas: Sequence[shapely.Polygon]) -> list[Stroke]:
    """Edges seen beyond the cut: outlines of what is open between the outermost material of every layer."""
    boxes = []
    for layer in layers:
        reach = float(np.linalg.norm(layer.rings[0], axis=1).max())
        within = shapely.intersection(shapely.union_all(areas), shapely.box(layer.low, -reach, layer.high, reach))
        _, low, _, high = within.bounds
        boxes.append(shapely.box(layer.low, low, layer.high, high))
    voids = shapely.difference(shapely.union_all(shapely.set_precision(boxes, _GRID)), shapely.union_all(areas))
    return [Stroke(np.asarray(void.exterior.coords)) for void in shapely.get_parts(voids)]


def outlines_and_hatches(areas: Sequence[shapely.Polygon]) -> tuple[list[Stroke], list[Hatch]]:
    """Outlines and hatches of areas of material."""
    strokes, hatches = [], []
    for area in areas:
        outside = np.asarray(area.exterior.coords)
        holes = tuple(np.asarray(hole.coords) for hole in area.interiors)
        strokes += [Stroke(points) for points in (outside, *holes)]
        hatches.append(Hatch(outside[:-1], tuple(hole[:-1] for hole in holes)))
    return strokes, hatches


_POINTS = 33  # of half an edge where the hole meets a cylinder
_BESIDE = 1e-6  # of a sine, within which the hole lies in the plane of the section


@dataclass(frozen=True, slots=True)
class ScrewHole:
    """The radial hole through a hub's wall.

    Attributes:
        hole: hole with its height and direction.
        inner: distance from the axis at which it begins, at the bore or the floor of its keyway, mm.
        outer: radius of the hub, mm.
        thread: diameter of the thread that is tapped in it, mm; 0 where the design names no metric one.
        pitch: what the name of the thread says after that, such as `x0.35`.
    """

    hole: RadialHole
    inner: float
    outer: float
    thread: float = 0.0
    pitch: str = ""

    @classmethod
    def of(cls, blank: Blank, hole: RadialHole | None, thread: str | None = None) -> "ScrewHole | None":
        """The hole in a part with this blank; None for a part without one.

        Args:
            blank: bore and hub of the part.
            hole: hole through the wall of the hub.
            thread: name of the thread, such as `M3`.
        """
        if hole is None or blank.hub is None:
            return None
        inner = blank.bore_diameter / 2
        if isinstance(blank.key, Keyway | DFlat) and cos(hole.angle - blank.key.angle) > 1 - _BESIDE:
            inner += blank.key.depth if isinstance(blank.key, Keyway) else -blank.key.depth
        metric = re.match(r"M ?(\d+(?:\.\d+)?)", thread or "")
        size = float(metric[1]) if metric else 0.0
        if not metric or size <= hole.diameter:
            return cls(hole, inner, blank.hub.diameter / 2)
        return cls(hole, inner, blank.hub.diameter / 2, size, metric.string[metric.end() :])

    def face(self) -> Iterator[Stroke]:
        """Edges of the hole and of its thread in the view along the axis, hidden in the hub's wall, and its centre."""
        along, half = np.array([cos(self.hole.angle), sin(self.hole.angle)]), self.hole.diameter / 2
        across = np.array([-along[1], along[0]])
        for width in (self.hole.diameter, *([self.thread] if self.thread else [])):
            for side in (-width / 2, width / 2):
                inner, outer = (np.sqrt(max(radius**2 - side**2, 0.0)) for radius in (self.inner, self.outer))
                yield Stroke(np.array([inner * along + side * across, outer * along + side * across]), LineKind.HIDDEN)
        yield Stroke(np.array([self.inner * along, (self.outer + half) * along]), LineKind.CENTRE)

    def cut(self, areas: Sequence[shapely.Polygon], angle: float) -> list[shapely.Polygon]:
        """Areas of the section in the plane through the axis at `angle` (rad), less the hole if it lies there.

        Args:
            areas: areas of the section, mm.
            angle: polar angle of the plane, rad.
        """
        if not self._in_plane(angle):
            return list(areas)
        half, up = self.hole.diameter / 2, cos(self.hole.angle - angle)
        ends = sorted((0.0, up * (self.outer + half)))
        box = shapely.box(self.hole.height - half, ends[0], self.hole.height + half, ends[1])
        pieces = shapely.get_parts(shapely.difference(np.array(areas), box))
        return [piece for piece in pieces if isinstance(piece, shapely.Polygon) and not piece.is_empty]

    def section(self, angle: float) -> Iterator[Closed | Stroke]:
        """Edges of the hole in the section at `angle`, rad: those beyond the plane, or before it as a phantom.

        Args:
            angle: polar angle of the plane, rad.
        """
        half, height = self.hole.diameter / 2, self.hole.height
        up = cos(self.hole.angle - angle)
        if self._in_plane(angle):
            for radius in (self.inner, self.outer):
                yield Stroke(self._edge(radius, 0.0) * [1.0, np.sign(up)])
            for side in (-1.0, 1.0) if self.thread else ():  # thin lines beside those of the core (ISO 6410-1)
                z, off = height + side * self.thread / 2, self.thread / 2
                deep, top = (np.sqrt(max(radius**2 - off**2, 0.0)) for radius in (self.inner, self.outer))
                yield Stroke(np.array([[z, np.sign(up) * deep], [z, np.sign(up) * top]]), LineKind.THIN)
            ends = up * np.array([self.inner - half, self.outer + half])
            yield Stroke(np.array([[height, ends[0]], [height, ends[1]]]), LineKind.CENTRE)
            return
        # The section is looked at from the side at a quarter turn; a hole on the other side opens into the bore.
        beyond = sin(self.hole.angle - angle) < 0
        edge = self._edge(self.inner if beyond else self.outer, self.hole.angle - angle)
        yield Stroke(edge, LineKind.VISIBLE if beyond else LineKind.PHANTOM)
        middle = (self.inner if beyond else self.outer) * up
        yield Stroke(np.array([[height, middle - 1.5 * half], [height, middle + 1.5 * half]]), LineKind.CENTRE)
        yield Stroke(np.array([[height - 1.5 * half, middle], [height + 1.5 * half, middle]]), LineKind.CENTRE)

    def height(self, face: float, at: tuple[float, float], scale: float, beside: float) -> LinearDimension:
        """Dimension of its height above the face at z = `face` (mm), the dimension line through `at`.

        Args:
            face: height of the face, mm.
            at: point of the dimension line, mm.
            scale: mm on paper for a mm of the part.
            beside: side on which a number without room between its arrows stands, 1 or -1 along the axis.
        """
        up = self.hole.height - face
        long = TEXT * WIDEST * len(rounded(abs(up)))
        narrow = scale * abs(up) < max(SHORT, long + 1.0)
        return LinearDimension(
            name="set screw height",
            start=(face, -self.outer),
            end=(self.hole.height, -self.outer),
            at=at,
            beside=beside * (scale * abs(up) / 2 + long / 2 + 0.8) if narrow else 0.0,
        )

    def size_in_section(self, angle: float, at: float, scale: float) -> LinearDimension | None:
        """Dimension of its thread, or of the hole, in the section at `angle`; None where the hole is not upwards in it.

        Args:
            angle: polar angle of the plane, rad.
            at: distance of the dimension line from the axis, mm.
            scale: mm on paper for a mm of the part.
        """
        if not self._in_plane(angle) or cos(self.hole.angle - angle) < 0.0:
            return None
        ends = self.hole.height + self._size / 2 * np.array([-1.0, 1.0])
        return self._said(along_axis("set screw", (float(ends[0]), float(ends[1])), self.outer, at), scale)

    def size_on_face(self, gap: float, scale: float) -> LinearDimension:
        """Dimension of its thread, or of the hole, in the view along the axis.

        Args:
            gap: distance of the dimension line from the hub, mm.
            scale: mm on paper for a mm of the part.
        """
        along = np.array([cos(self.hole.angle), sin(self.hole.angle)])
        across = self._size / 2 * np.array([-along[1], along[0]])
        (x, y), (left, low), (right, high) = (
            ((self.outer + gap) * along).tolist(),
            (self.outer * along - across).tolist(),
            (self.outer * along + across).tolist(),
        )
        angle = float(np.degrees(self.hole.angle)) + 90.0
        held = LinearDimension(name="set screw", start=(left, low), end=(right, high), at=(x, y), angle=angle)
        return self._said(held, scale)

    @property
    def _size(self) -> float:
        return self.thread or self.hole.diameter

    def _said(self, held: LinearDimension, scale: float) -> LinearDimension:
        """The dimension with the letter of a thread or the sign of a diameter, its number beside the arrows."""
        prefix = "M" if self.thread else DIAMETER
        wide, long = scale * self._size, TEXT * WIDEST * len(f"M{rounded(self._size)}{self.pitch}")
        beside = wide / 2 + (TAIL if wide < SHORT else 0.0) + long / 2 + 1.0
        return replace(held, prefix=prefix, suffix=self.pitch, beside=beside)

    def _in_plane(self, angle: float) -> bool:
        return abs(sin(self.hole.angle - angle)) < _BESIDE

    def _edge(self, radius: float, turn: float) -> Array:
        """Edge where the hole meets a cylinder, `turn` rad from the section's upper side, in (z, r), shape (n, 2), mm.

        In the plane of the section it is half of the edge, beyond the plane.
        """
        half = self.hole.diameter / 2
        whole = abs(sin(turn)) > _BESIDE
        round_about = np.linspace(0.0, 2 * np.pi if whole else np.pi, _POINTS * (2 if whole else 1))
        aside = half * np.sin(round_about)
        r = np.sqrt(np.maximum(radius**2 - aside**2, 0.0)) * np.cos(turn) - aside * np.sin(turn)
        return np.stack([self.hole.height - half * np.cos(round_about), r], axis=1)
