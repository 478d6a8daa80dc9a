"""Sheets of a frame: exact outlines of lines and arcs, and how far a sheet at its place is from round bodies.

A sheet's own frame has its outline in the plane w = 0, and its thickness along w. An inner corner that a mill rounds is
opened by a half circle through the corner, as deep as the cutter is wide.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import hypot, sqrt
from typing import NamedTuple

import numpy as np
import shapely

from cadgen.arrays import Array
from cadgen.car.assembly.bodies import Convex, SolidCylinder, convex_gap
from cadgen.car.assembly.car_parts import Block, Drilled, Prism
from cadgen.curves.contour import Contour, circle

PLATE_COLOUR, BASE_COLOUR = (0.62, 0.66, 0.70), (0.50, 0.54, 0.58)
_CHORD = 0.005  # mm, of arcs in the pieces against which gaps are measured
_STRAIGHT = 1e-12
_OWN = 1e-6  # mm, of what rounding leaves between a slot in a foot and its sides
# Places of parts: directions of u, v and w in the car, as columns. Plates are seen from the left of the car, the base
# from above, both with the front to the left; the micrometer bracket is seen from before.
STANDING = np.array([[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
LYING = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]])
ACROSS = np.array([[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]])


@dataclass(frozen=True, slots=True, eq=False)
class PartPlace:
    """Place of a part's frame in the car: x = turn u + shift, mm.

    Attributes:
        turn: rotation, shape (3, 3); its columns are the directions of u, v and w.
        shift: place of the part's origin, shape (3,), mm.
    """

    turn: Array
    shift: Array

    def out(self, points: Array) -> Array:
        """Points of the part in the car, mm, shape (n, 3).

        Args:
            points: points in the part's own frame, mm, shape (n, 3).
        """
        placed: Array = points @ self.turn.T + self.shift
        return placed

    def within(self, points: Array) -> Array:
        """Points of the car in the part's own frame, mm, shape (n, 3).

        Args:
            points: points in the car, mm, shape (n, 3).
        """
        found: Array = (points - self.shift) @ self.turn
        return found


class SheetHole(NamedTuple):
    """Round hole through a sheet.

    Attributes:
        name: what it is for, for people.
        u: place, mm.
        v: likewise.
        diameter: diameter, mm.
        fit: class of the hole, such as `H7`; empty for one without.
        shaft: number of the shaft whose bearing sits in it; 0 for another hole.
    """

    name: str
    u: float
    v: float
    diameter: float
    fit: str = ""
    shaft: int = 0


THREAD_END = 2.0  # mm by which a blind hole is deeper than the thread in it


class EdgeHole(NamedTuple):
    """Blind hole in the foot of a standing sheet, for a thread: from the foot inwards, along v.

    Attributes:
        u: place along the foot, mm.
        v: height of the foot, mm.
        diameter: diameter of the drill, mm.
        depth: depth, mm.
    """

    u: float
    v: float
    diameter: float
    depth: float


class Feature(NamedTuple):
    """Tab, slot or opening of a sheet, by the rectangle that holds it.

    Attributes:
        name: what it is, for people.
        u: place of its middle, mm.
        v: likewise.
        along: size along u, mm.
        across: size along v, mm.
        pattern: code of the sheet whose tabs these are, or go in here; empty for others.
        fitted: whether size along u and size along v are of a fit.
    """

    name: str
    u: float
    v: float
    along: float
    across: float
    pattern: str = ""
    fitted: tuple[bool, bool] = (False, False)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Panel:
    """Sheet part of a frame.

    Attributes:
        code: name of the part in names of files.
        name: name for people.
        outline: outside, counterclockwise, mm.
        cuts: cut-outs that are not round, counterclockwise, mm.
        holes: round holes.
        edge_holes: blind holes in its foot.
        features: tabs, slots and openings, for its drawing.
        thickness: thickness, mm.
        place: place in the car.
        rooms: areas that threads, or screws and nuts in slots, take in its foot.
    """

    code: str
    name: str
    outline: Contour
    cuts: tuple[Contour, ...]
    holes: tuple[SheetHole, ...]
    edge_holes: tuple[EdgeHole, ...]
    features: tuple[Feature, ...]
    thickness: float
    place: PartPlace
    rooms: tuple[shapely.Polygon, ...] = ()

    @property
    def openings(self) -> tuple[Contour, ...]:
        """Cut-outs and holes."""
        return (*self.cuts, *(circle((hole.u, hole.v), hole.diameter / 2) for hole in self.holes))

    @property
    def shape(self) -> Block:
        """Sheet as a prism with holes."""
        drilled = tuple(
            Drilled((each.u, each.v, self.thickness / 2), (0.0, 1.0, 0.0), each.diameter, each.depth)
            for each in self.edge_holes
        )
        return Block((Prism(self.outline, 0.0, self.thickness, self.openings),), drilled=drilled)

    @property
    def volume(self) -> float:
        """Exact volume, mm³."""
        area = self.outline.area() - sum(opening.area() for opening in self.openings)
        return self.thickness * area - sum(np.pi * each.diameter**2 / 4 * each.depth for each in self.edge_holes)

    def counted_from(self, u: float, v: float) -> "Panel":
        """Sheet at its place in the car whose own frame has its zero at one of its points.

        Args:
            u: place of the point along the first axis of the frame as it is, mm.
            v: its place along the second axis, mm.
        """
        by = np.array([u, v])

        def contour(each: Contour) -> Contour:
            return replace(each, vertices=each.vertices - by)

        return replace(
            self,
            outline=contour(self.outline),
            cuts=tuple(map(contour, self.cuts)),
            holes=tuple(each._replace(u=each.u - u, v=each.v - v) for each in self.holes),
            edge_holes=tuple(each._replace(u=each.u - u, v=each.v - v) for each in self.edge_holes),
            features=tuple(each._replace(u=each.u - u, v=each.v - v) for each in self.features),
            place=replace(self.place, shift=self.place.out(np.array([[u, v, 0.0]]))[0]),
            rooms=tuple(shapely.transform(each, lambda points: points - by) for each in self.rooms),
        )

    def beside(self, room: shapely.Polygon) -> float:
        """Least material between what a screw takes in its foot and its sides, mm.

        Args:
            room: area that thread, or screw and nut, take.
        """
        corners = self.outline.polygon(0.002)
        # The foot itself, and the tabs under it, are no sides; nor are those of a slot for screw and nut.
        ends = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
        sides = shapely.linestrings(ends[ends[:, :, 1].max(axis=1) > room.bounds[1] + _OWN])
        return float(shapely.distance(sides[~shapely.covers(room.buffer(_OWN), sides)], room).min())

    def face(self, *, seats: bool = True, chord: float = _CHORD) -> shapely.Polygon:
        """Face of the sheet as a polygon with chords of its arcs.

        Args:
            seats: whether the seats of bearings are open.
            chord: greatest distance of a chord from its arc, mm.
        """
        open_ones = [*self.cuts]
        open_ones += [
            circle((hole.u, hole.v), hole.diameter / 2) for hole in self.holes if seats or not (hole.shaft or hole.fit)
        ]
        return shapely.Polygon(self.outline.polygon(chord), [each.polygon(chord) for each in open_ones])


@dataclass(frozen=True, slots=True, eq=False)
class ConvexPrism:
    """Convex prism: a piece of a sheet.

    Attributes:
        corners: corners of its face, counterclockwise, shape (n, 2), mm.
        thickness: thickness, mm.
        place: place of the sheet.
        box: least and greatest coordinates in the car, shape (2, 3), mm.
    """

    corners: Array
    thickness: float
    place: PartPlace
    box: Array

    @classmethod
    def of(cls, corners: Array, thickness: float, place: PartPlace) -> "ConvexPrism":
        """Prism over a face.

        Args:
            corners: corners of the face, counterclockwise, shape (n, 2), mm.
            thickness: thickness, mm.
            place: place of its frame.
        """
        flat = [np.column_stack([corners, np.full(len(corners), w)]) for w in (0.0, thickness)]
        placed = place.out(np.concatenate(flat))
        return cls(corners, thickness, place, np.array([placed.min(axis=0), placed.max(axis=0)]))

    @property
    def centre(self) -> tuple[float, float, float]:
        """Middle of its corners, mm."""
        u, v = self.corners.mean(axis=0).tolist()
        x, y, z = self.place.out(np.array([[u, v, self.thickness / 2]]))[0].tolist()
        return x, y, z

    def nearest(self, point: Array) -> Array:
        """Point of the piece that is nearest to a point, mm, shape (3,).

        Args:
            point: point, mm, shape (3,).
        """
        u, v, w = self.place.within(point[None, :])[0].tolist()
        start, end = self.corners, np.roll(self.corners, -1, axis=0)
        side = end - start
        off = np.array([u, v]) - start
        if np.any(side[:, 0] * off[:, 1] - side[:, 1] * off[:, 0] < 0):
            share = np.clip((off * side).sum(axis=1) / (side * side).sum(axis=1), 0.0, 1.0)
            feet = start + share[:, None] * side
            u, v = feet[np.argmin(((feet - np.array([u, v])) ** 2).sum(axis=1))].tolist()
        found: Array = self.place.out(np.array([[u, v, min(max(w, 0.0), self.thickness)]]))[0]
        return found


def pieces(panel: Panel) -> Iterator[ConvexPrism]:
    """Convex pieces that make up a sheet, its seats filled by the bearings in them."""
    face = panel.face(seats=False)
    if not face.is_valid:  # as of a seat that is cut by the foot
        face = face.buffer(0.0)
    triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(face))
    corners = shapely.get_coordinates(triangles).reshape(-1, 4, 2)[:, :3]
    along, across = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]
    corners = np.where(area[:, None, None] > 0, corners, corners[:, ::-1])[np.abs(area) > _STRAIGHT]
    flat = np.concatenate([np.dstack([corners, np.full(corners.shape[:2], w)]) for w in (0.0, panel.thickness)], axis=1)
    placed = panel.place.out(flat.reshape(-1, 3)).reshape(flat.shape)
    boxes = np.stack([placed.min(axis=1), placed.max(axis=1)], axis=1)
    for each, box in zip(corners, boxes, strict=True):
        yield ConvexPrism(each, panel.thickness, panel.place, box)


def cylinder_box(body: SolidCylinder) -> Array:
    """Least and greatest coordinates of a cylinder, shape (2, 3), mm."""
    axis = np.abs(np.asarray(body.axis))
    half = body.half * axis + body.radius * np.sqrt(np.maximum(1 - axis**2, 0.0))
    return np.array([np.asarray(body.centre) - half, np.asarray(body.centre) + half])


class Nearest(NamedTuple):
    """Least gap of several pairs of bodies.

    Attributes:
        size: gap, mm; 0 for bodies that overlap.
        one: number of the first body.
        other: number of the second.
    """

    size: float
    one: int
    other: int


def least_gap(
    ones: Sequence[tuple[int, Convex, Array]],
    others: Sequence[tuple[int, Convex, Array]],
    skipped: Iterable[tuple[int, int]],
) -> Nearest | None:
    """Least gap between bodies of two kinds; None without a pair.

    Pairs are measured in the order of the gaps of their boxes, until a box is farther away than the least gap.

    Args:
        ones: number, body and box of the first; several may have one number, as pieces of a sheet.
        others: likewise.
        skipped: pairs of numbers that touch as they are meant to.
    """
    if not ones or not others:
        return None
    left, right = np.array([box for *_, box in ones]), np.array([box for *_, box in others])
    apart = np.maximum(left[:, None, 0] - right[None, :, 1], right[None, :, 0] - left[:, None, 1])
    bounds = np.sqrt((np.maximum(apart, 0.0) ** 2).sum(axis=2))
    first, second = (np.array([number for number, *_ in bodies]) for bodies in (ones, others))
    for one, other in skipped:
        bounds[np.ix_(first == one, second == other)] = np.inf
    best: Nearest | None = None
    while True:
        i, j = divmod(int(bounds.argmin()), len(others))
        if bounds[i, j] >= (np.inf if best is None else best.size):
            return best
        size = convex_gap(ones[i][1], others[j][1])
        if best is None or size < best.size:
            best = Nearest(size, ones[i][0], others[j][0])
        bounds[i, j] = np.inf


def rounded_corners(corners: Array, radius: float, *, inside: bool) -> Contour:
    """Polygon whose inner corners are opened by half circles that pass through them.

    Args:
        corners: corners, counterclockwise, shape (n, 2), mm.
        radius: radius of the half circles, mm; 0 for sharp corners.
        inside: whether material lies outside of it, as of a cut-out.
    """
    before, after = np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0)
    vertices: list[Array] = []
    bulges: list[float] = []
    for corner, last, following in zip(corners, before, after, strict=True):
        come, go = corner - last, following - corner
        come, go = come / np.linalg.norm(come), go / np.linalg.norm(go)
        turn = float(come[0] * go[1] - come[1] * go[0])
        if radius and (turn > _STRAIGHT) == inside and abs(turn) > _STRAIGHT:
            # The half circle's ends lie on both sides of the corner, at equal distances from it.
            vertices += [corner - sqrt(2) * radius * come, corner + sqrt(2) * radius * go]
            bulges += [1.0 if inside else -1.0, 0.0]
        else:
            vertices.append(corner)
            bulges.append(0.0)
    return Contour(np.array(vertices), np.array(bulges))


def rectangle(left: float, low: float, right: float, high: float) -> Array:
    """Corners of a rectangle, counterclockwise, shape (4, 2), mm.

    Args:
        left: least u, mm.
        low: least v, mm.
        right: greatest u, mm.
        high: greatest v, mm.
    """
    return np.array([[left, low], [right, low], [right, high], [left, high]])


def slot(centre: tuple[float, float], length: float, width: float) -> Contour:
    """Slot along u with round ends, counterclockwise; a circle without a length.

    Args:
        centre: its middle, mm.
        length: way between the middles of its ends, mm.
        width: width, mm.
    """
    if not length:
        return circle(centre, width / 2)
    u, v, half, radius = *centre, length / 2, width / 2
    corners = rectangle(u - half, v - radius, u + half, v + radius)
    return Contour(corners, np.array([0.0, 1.0, 0.0, 1.0]))


def parallel_gap(panel: Panel, body: SolidCylinder) -> float:
    """Gap between a sheet and a cylinder whose axis is normal to it, mm; negative by the depth of an overlap.

    Args:
        panel: sheet.
        body: cylinder, its axis along the sheet's w.
    """
    u, v, w = panel.place.within(np.asarray(body.centre, dtype=float)[None, :])[0].tolist()
    face, middle = panel.face(seats=False), shapely.Point(u, v)
    beside = float(face.distance(middle)) - body.radius
    along = max(w - body.half - panel.thickness, -w - body.half)
    return hypot(beside, along) if beside > 0 and along > 0 else max(beside, along)
