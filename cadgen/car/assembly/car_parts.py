"""Parts of a car: shape, place, material and mass of each, and what it moves with.

Lengths are mm, angles rad and masses g. The frame is that of the room. A place is a matrix of shape (3, 4): turning and
shift, from the part's own frame to that of the car at cam angle 0 with the fork straight. What moves is then moved by
its group: a shaft turns about its axis, the fork about the fork axis.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import NamedTuple

import numpy as np

from cadgen.arrays import Array
from cadgen.car.assembly.standard_parts import ParallelKey
from cadgen.curves.closed import ClosedCurve, cross
from cadgen.curves.contour import Contour
from cadgen.curves.polygon import polygon
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.body import Body

_CHORD = 1e-3  # mm, of polygons whose first moments are taken: 1e-4 mm of a centre of mass on parts of 100 mm


class Content(NamedTuple):
    """Volume of a solid, mm³, and its centre of volume (x, y, z), mm, in its own frame."""

    volume: float
    centre: tuple[float, float, float]

    def at(self, place: Array) -> "Content":
        """Content of the solid at a place.

        Args:
            place: turning and shift from its own frame, shape (3, 4), mm.
        """
        x, y, z = (place @ [*self.centre, 1.0]).tolist()
        return Content(self.volume, (x, y, z))


@dataclass(frozen=True, slots=True)
class BodyShape:
    """A body of prisms about its axis, as gears, wheels and shafts are.

    Attributes:
        body: body of prisms.
        volume: volume of the body with its radial hole, mm³; None for that of the prisms less the hole's cylinder
            between bore and outside.
    """

    body: Body
    volume: float | None = None

    def content(self) -> Content:
        """Volume and centre; the radial hole moves the centre, and is taken as a cylinder there."""
        slabs = self.body.slabs
        volume = sum(slab.area * (slab.end - slab.start) for slab in slabs)
        moment = np.zeros(3)
        for slab in slabs:
            height = slab.end - slab.start
            for outline, outward in slab.walls().items():
                corners = outline.polygon(_CHORD)
                x, y = _centroid(np.column_stack([corners.real, corners.imag]))
                size = (outline.area if outward else -outline.area) * height
                moment += size * np.array([x, y, (slab.start + slab.end) / 2])
        hole, number = self.body.radial_hole, self.body.drilled
        if hole is not None and number is not None:
            rings = slabs[number].rings
            inner = rings[1].radii[0] if len(rings) > 1 else 0.0
            outer = min(rings[0].radii[1], hole.reach)
            size = np.pi * hole.diameter**2 / 4 * (outer - inner) if self.volume is None else volume - self.volume
            middle, volume = (inner + outer) / 2, volume - size
            moment -= size * np.array([middle * np.cos(hole.angle), middle * np.sin(hole.angle), hole.height])
        x, y, z = (moment / volume).tolist()
        return Content(volume, (x, y, z))


@dataclass(frozen=True, slots=True, eq=False)
class DiscShape:
    """The disc of a cam between z = 0 and its thickness.

    Attributes:
        curve: profile, mm.
        blank: features of the disc besides its profile.
        thickness: thickness, mm.
        chamfers: volume that the chamfers of both edges take, mm³.
    """

    curve: ClosedCurve
    blank: Blank
    thickness: float
    chamfers: float = 0.0

    def content(self) -> Content:
        """Volume and centre: the chamfers are taken off evenly, and the hub's centre is taken on the axis."""
        rim = polygon(self.curve, _CHORD)
        parts = [(float(np.sum(cross(rim, np.roll(rim, -1, axis=0)))) / 2, _centroid(rim))]
        for contour in self.blank.inner_contours():
            parts.append((-contour.area(), _centroid(contour.polygon(_CHORD))))
        area = sum(size for size, _ in parts)
        x, y = (sum(size * middle[axis] for size, middle in parts) / area for axis in (0, 1))
        disc, boss = area * self.thickness - self.chamfers, self.blank.boss(self.thickness)
        stands = 0.0 if boss is None else self.blank.hub_volume()
        middle = self.thickness / 2
        height = (middle if boss is None else (boss.low + boss.high) / 2) * stands + middle * disc
        whole = disc + stands
        return Content(whole, (float(x * disc / whole), float(y * disc / whole), height / whole))


@dataclass(frozen=True, slots=True, eq=False)
class Prism:
    """Prism along z over an outline with holes.

    Attributes:
        outline: outline, counterclockwise, mm.
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        holes: holes within the outline, counterclockwise, mm.
    """

    outline: Contour
    low: float
    high: float
    holes: tuple[Contour, ...] = ()

    def content(self) -> Content:
        """Volume and centre."""
        parts = [(self.outline.area(), self.outline), *((-hole.area(), hole) for hole in self.holes)]
        area = sum(size for size, _ in parts)
        middles = np.array([_centroid(contour.polygon(_CHORD)) for _, contour in parts])
        x, y = (np.array([size for size, _ in parts]) @ middles / area).tolist()
        return Content(area * (self.high - self.low), (x, y, (self.low + self.high) / 2))


@dataclass(frozen=True, slots=True)
class KeySlot:
    """Seat of a key in a round shaft about z, with the round ends that an end mill leaves (DIN 6885-1).

    Attributes:
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        width: width, mm.
        floor: distance of its floor from the axis, mm.
        radius: radius of the shaft, mm.
        angle: polar angle of its middle, rad.
        rounded: whether its lower and its upper end are round; one at the end of the shaft is open.
        key: key that lies in it; None where it is not known.
    """

    low: float
    high: float
    width: float
    floor: float
    radius: float
    angle: float
    rounded: tuple[bool, bool] = (True, True)
    key: ParallelKey | None = None

    @property
    def tool(self) -> tuple[Prism, Array]:
        """Prism that is taken away, up to beyond the shaft, and its place, shape (3, 4), mm."""
        out = (float(np.cos(self.angle)), float(np.sin(self.angle)), 0.0)
        outline = key_outline(self.low, self.high, self.width, self.rounded)
        return Prism(outline, self.floor, self.radius + self.width), along(out, (0.0, 0.0, 1.0), (0.0, 0.0, 0.0))

    def content(self) -> Content:
        """Volume and centre of what is taken away: across the width, depth by length, by Gauss's rule."""
        half, (below, above) = self.width / 2, self.rounded
        nodes, weights = np.polynomial.legendre.leggauss(48)
        turn = np.pi / 2 * nodes
        aside, round_off = half * np.sin(turn), half * np.cos(turn)  # a half circle has this height there
        weights = weights * np.pi / 2 * round_off
        bottom = self.low + (half - round_off) * below
        top = self.high - (half - round_off) * above
        wall = np.sqrt(self.radius**2 - aside**2)
        areas = weights * (wall - self.floor)
        volume = float(areas @ (top - bottom))
        out = float(weights * (wall**2 - self.floor**2) / 2 @ (top - bottom)) / volume
        height = float(areas @ (top**2 - bottom**2)) / 2 / volume
        return Content(volume, (float(out * np.cos(self.angle)), float(out * np.sin(self.angle)), height))


def key_outline(low: float, high: float, width: float, rounded: tuple[bool, bool]) -> Contour:
    """Outline of a key or its seat, seen from outside of the shaft: x along it, counterclockwise.

    Args:
        low: where it begins, mm.
        high: where it ends, mm.
        width: width, mm.
        rounded: whether its lower and its upper end are half circles.
    """
    half, (below, above) = width / 2, rounded
    left, right = low + half * below, high - half * above
    corners = np.array([[left, -half], [right, -half], [right, half], [left, half]])
    return Contour(corners, np.array([0.0, above, 0.0, below], dtype=float))


class Drilled(NamedTuple):
    """Round hole in a block, across its prisms.

    Attributes:
        start: middle of its flat end or mouth, mm.
        direction: direction in which it is drilled, a unit vector.
        diameter: diameter, mm.
        depth: depth, mm.
        beyond: way by which the tool stands out at either end of a hole through a round part, mm.
    """

    start: tuple[float, float, float]
    direction: tuple[float, float, float]
    diameter: float
    depth: float
    beyond: float = 0.0

    @property
    def tool(self) -> tuple[tuple[float, float, float], float]:
        """Start and length of the tool, mm."""
        x, y, z = (at - self.beyond * way for at, way in zip(self.start, self.direction, strict=True))
        return (x, y, z), self.depth + 2 * self.beyond


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """Prisms put together, less seats of keys and drilled holes, as plates, keyed shafts and forks are.

    Attributes:
        prisms: prisms that touch each other and do not overlap.
        seats: seats of keys; the block is then a round shaft about z.
        drilled: holes that are taken away; each lies in the block with its whole length.
    """

    prisms: tuple[Prism, ...]
    seats: tuple[KeySlot, ...] = ()
    drilled: tuple[Drilled, ...] = ()

    def content(self) -> Content:
        """Volume and centre, the holes taken as whole cylinders."""
        parts = [each.content() for each in self.prisms]
        for each in self.seats:
            taken = each.content()
            parts.append(Content(-taken.volume, taken.centre))
        for hole in self.drilled:
            middle = np.asarray(hole.start) + hole.depth / 2 * np.asarray(hole.direction)
            x, y, z = middle.tolist()
            parts.append(Content(-np.pi * hole.diameter**2 / 4 * hole.depth, (x, y, z)))
        return together(parts)


@dataclass(frozen=True, slots=True, eq=False)
class Joined:
    """Blocks that make up one solid, as a frame in one piece does.

    Attributes:
        blocks: blocks, each with its place in the solid's own frame, shape (3, 4); they touch and do not overlap.
    """

    blocks: tuple[tuple[Block, Array], ...]

    def content(self) -> Content:
        """Volume and centre."""
        return together(block.content().at(place) for block, place in self.blocks)


Shape = BodyShape | DiscShape | Block | Joined


class GroupKind(StrEnum):
    """Kinds of groups of parts that move as one."""

    FRAME = "frame"
    FORK = "fork"
    SHAFT = "shaft"
    BESIDE = "beside"


@dataclass(frozen=True, slots=True)
class MovingGroup:
    """Parts that move as one.

    Attributes:
        kind: frame, fork, a shaft, or a part that turns beside the shafts, as a planet does.
        number: number of the shaft from 1 at the drive, the last being the camshaft; of a part beside them, a number
            after those.
        axis: axis x + iy about which it turns, mm; of the fork x ahead and z, the height along the shafts, as x + iz.
        rate: turns by turn of the cam, with sign about z; 0 of frame and fork.
        carrier: group that its axis goes round with; None where the axis stands.
    """

    kind: GroupKind
    number: int = 0
    axis: complex = 0j
    rate: float = 0.0
    carrier: "MovingGroup | None" = None

    def motion(self, cam_angle: float, fork_angle: float) -> Array:
        """Motion from cam angle 0 with the fork straight, shape (3, 4).

        Args:
            cam_angle: cam angle, rad.
            fork_angle: angle of the fork about y, rad.
        """
        match self.kind:
            case GroupKind.FRAME:
                return still()
            case GroupKind.FORK:
                c, s = np.cos(fork_angle), np.sin(fork_angle)
                turned = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
                middle = np.array([self.axis.real, 0.0, self.axis.imag])
            case _:
                angle = self.rate * cam_angle
                c, s = np.cos(angle), np.sin(angle)
                turned = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
                middle = np.array([self.axis.real, self.axis.imag, 0.0])
        motion = np.column_stack([turned, middle - turned @ middle])
        if self.carrier is not None:
            away = self.carrier.motion(cam_angle, fork_angle) @ [*middle, 1.0] - middle
            motion[:, 3] += away
        return motion


class Supply(StrEnum):
    """Sources of a part."""

    MADE = "made"
    BOUGHT = "bought"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class CarPart:
    """A part of a car, once or several times.

    Attributes:
        code: name in files, ASCII, and the only one of its kind in a car.
        title: what it is, for people.
        shape: shape in its own frame; None of small things that are listed and not drawn, as screws are.
        places: place of each in the car, shape (3, 4).
        group: what it moves with.
        material: material, for people; empty where it is not stated.
        density: density, g/mm³.
        assumed: whether material or density are usual values that the design does not state.
        colour: red, green, blue in sRGB, 0 to 1.
        supply: made by the drawings, or bought.
        standard: standard and size of a bought part, or stem of the files of one that is made.
        mass: mass of each, g, where it is known otherwise; None for volume by density.
        further: number of those that have no place.
        shaft: number of the shaft that it is mounted on, from 1 at the drive; 0 for none.
        order: -1 for a shaft itself, 0 for what is put on one.
        how: how it is mounted: which way it faces, what holds it.
    """

    code: str
    title: Message
    shape: Shape | None
    places: tuple[Array, ...]
    group: MovingGroup
    material: str
    density: float
    assumed: bool = False
    colour: tuple[float, float, float] = (0.7, 0.7, 0.7)
    supply: Supply = Supply.MADE
    standard: str = ""
    mass: float | None = None
    further: int = 0
    shaft: int = 0
    order: int = 0
    how: str = ""

    def __repr__(self) -> str:
        return f"<CarPart {self.code}, {self.quantity} of {self.title}>"

    @property
    def quantity(self) -> int:
        """Number of such parts in a car."""
        return len(self.places) + self.further

    @cached_property
    def content(self) -> Content:
        """Volume and centre of volume of each; nothing without a shape."""
        return Content(0.0, (0.0, 0.0, 0.0)) if self.shape is None else self.shape.content()

    @property
    def each(self) -> float:
        """Mass of each, g."""
        return self.content.volume * self.density if self.mass is None else self.mass

    def heights(self, place: Array) -> tuple[float, float]:
        """Heights between which it stands along the shafts, mm; of a body or disc, whose z axis runs along them.

        Args:
            place: one of its places, shape (3, 4), mm.
        """
        match self.shape:
            case BodyShape(body=body):
                ends = [body.slabs[0].start, body.slabs[-1].end]
            case DiscShape(thickness=thickness, blank=blank):
                boss = blank.boss(thickness)
                ends = [0.0, thickness, *(() if boss is None else (boss.low, boss.high))]
            case Block(prisms=prisms):
                across = [each.outline.polygon(_CHORD) @ place[2, :2] for each in prisms]
                spans = [
                    float(place[2, 3] + reach + place[2, 2] * end)
                    for each, beside in zip(prisms, across, strict=True)
                    for end in (each.low, each.high)
                    for reach in (beside.min(), beside.max())
                ]
                return min(spans), max(spans)
            case _:
                ends = [0.0]
        along_z = [float(place[2, 3] + place[2, 2] * end) for end in ends]
        return min(along_z), max(along_z)

    def placed(self, cam_angle: float = 0.0, fork_angle: float = 0.0) -> list[Array]:
        """Places at a cam angle, shape (3, 4) each.

        Args:
            cam_angle: cam angle, rad.
            fork_angle: angle of the fork about y, rad.
        """
        motion = self.group.motion(cam_angle, fork_angle)
        turn, way = motion[:, :3], motion[:, 3]
        return [np.column_stack([turn @ place[:, :3], turn @ place[:, 3] + way]) for place in self.places]

    def balance(self, cam_angle: float = 0.0, fork_angle: float = 0.0) -> Content:
        """Mass of all that have a place, g, and its centre in the car, mm.

        Args:
            cam_angle: cam angle, rad.
            fork_angle: angle of the fork about y, rad.
        """
        here = [*self.content.centre, 1.0]
        return together(
            Content(self.each, tuple((place @ here).tolist())) for place in self.placed(cam_angle, fork_angle)
        )


def together(parts: Iterable[Content]) -> Content:
    """Sum of volumes or masses, and their common centre.

    Args:
        parts: volumes or masses with their centres; negative ones are taken away.
    """
    every = list(parts)
    size = sum(part.volume for part in every)
    if not size:
        return Content(0.0, (0.0, 0.0, 0.0))
    sizes, centres = np.array([part.volume for part in every]), np.array([part.centre for part in every])
    x, y, z = (sizes @ centres / size).tolist()
    return Content(float(size), (x, y, z))


def still() -> Array:
    """Place of a part that is described in the car's frame already, shape (3, 4)."""
    return np.eye(3, 4)


def at(x: float, y: float, z: float) -> Array:
    """Place that is shifted only, shape (3, 4).

    Args:
        x: shift ahead, mm.
        y: shift downwards, mm.
        z: shift to the left along the shafts, mm.
    """
    place = still()
    place[:, 3] = x, y, z
    return place


def along(axis: Sequence[float], beside: Sequence[float], origin: Sequence[float]) -> Array:
    """Place whose z axis points along a direction, shape (3, 4).

    Args:
        axis: direction of the part's z axis in the car, a unit vector.
        beside: direction of its x axis, a unit vector across it.
        origin: place of its origin, mm.
    """
    return np.column_stack([beside, np.cross(axis, beside), axis, origin]).astype(float)


def turned_round(body: Iterable[tuple[float, float, float, float]]) -> Iterator[Prism]:
    """Round prisms about z.

    Args:
        body: low and high end, outer diameter and diameter of the bore of each, mm; 0 for no bore.
    """
    from cadgen.curves.contour import circle

    for low, high, outside, bore in body:
        yield Prism(circle((0.0, 0.0), outside / 2), low, high, (circle((0.0, 0.0), bore / 2),) if bore else ())


def _centroid(points: Array) -> Array:
    """Centre of the area inside a polygon, shape (2,), mm."""
    following = np.roll(points, -1, axis=0)
    twice = cross(points, following)
    centre: Array = ((points + following) * twice[:, None]).sum(axis=0) / (3 * twice.sum())
    return centre
