"""Drop weight or motor on the base of a frame: its place, and rods, tubes and top plate that guide a weight."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import ceil, hypot, pi, sqrt

import numpy as np
import shapely

from cadgen.car.assembly.car_parts import Block, Prism
from cadgen.car.assembly.panels import LYING, ConvexPrism, Panel, PartPlace, SheetHole, rectangle
from cadgen.car.assembly.standard_parts import Screw
from cadgen.curves.contour import Contour, circle
from cadgen.messages import Message

TUBE, TUBE_BORE = 6.0, 4.0  # mm, of the tubes along which a weight runs
_PLAY = 0.5  # mm between weight and tubes
_OVER = 20.0  # mm over the weight at its start, for the knot of its string
_STEP = 5.0  # mm, to which tubes are cut
_STRING = 3.0  # mm, least holes for the string in the top plate
FLANGE = 3.0  # mm, thickness of the flanges of a drum
_KNOT = 0.5  # mm by which the string's hole in drum or axle is wider than the string
_BESIDE = 0.5  # mm between a drum and that hole in its flange
_SPARE = 2.0  # mm of a drum beside the turns of its string
_EDGE = 4.0  # mm of the top plate beside its holes
DRUM_EDGE = 1.0  # mm of a flange outside the string's hole


@dataclass(frozen=True, slots=True, kw_only=True)
class CarriedBody:
    """Weight or motor that a frame carries.

    Attributes:
        along: length along the car, mm; diameter of a weight.
        across: width, mm.
        tall: height, mm.
        mass: mass, kg.
        fall: way by which a weight falls, mm; 0 for a motor.
        start: height of a weight's lower face over the floor before the run, mm; None for the lowest that will do.
        axle: diameter of the rear axle, mm.
        drum: diameter of the drum on it on which the string is wound, mm; 0 for a string on the axle itself.
        string: thickness of the string, mm.
    """

    along: float
    across: float
    tall: float
    mass: float
    fall: float
    start: float | None
    axle: float = 0.0
    drum: float = 0.0
    string: float = 1.0

    @property
    def knot(self) -> float:
        """Diameter of the hole in drum or axle through which the string is knotted, mm."""
        return self.string + _KNOT

    @property
    def wound(self) -> float:
        """Diameter of the middle of the wound string, mm."""
        return (self.drum or self.axle) + self.string

    @property
    def turns(self) -> float:
        """Turns of the string that its fall takes off drum or axle."""
        return self.fall / (pi * self.wound)

    @property
    def winding(self) -> float:
        """Length along the axle that the turns of the string take in one layer, with the drum's flanges, mm."""
        return (ceil(self.turns) + 1) * self.string + _SPARE + 2 * FLANGE * (self.drum > 0) if self.fall else 0.0

    @property
    def reach(self) -> float:
        """Greatest radius of axle, drum and string, mm."""
        if self.drum:
            return self.drum / 2 + 2 * _BESIDE + self.knot + DRUM_EDGE
        return self.wound / 2 + self.string / 2

    @property
    def title(self) -> Message:
        """Name for people."""
        return Message("drop weight") if self.fall else Message("motor with its battery")

    def holes(self, apart: tuple[float, float]) -> tuple[float, float]:
        """Distances of the four holes in the base along and across the car, mm.

        Args:
            apart: distances that the design states for a motor, mm.
        """
        if not self.fall:
            return apart
        side = sqrt(2) * (self.along / 2 + _PLAY + TUBE / 2)
        return side, side

    def width(self, apart: tuple[float, float]) -> float:
        """Width across the car that it needs, with the tubes of a weight, mm.

        Args:
            apart: distances of the holes that the design states for a motor, mm.
        """
        return max(self.across, self.holes(apart)[1] + TUBE, self.winding) if self.fall else self.across


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Carried:
    """Weight or motor at its place.

    Attributes:
        body: weight or motor.
        x: place of its middle ahead of the camshaft, mm.
        z: height of its middle along the shafts, mm.
        low: height y of its lower face at its lowest place, mm.
        high: height y of its lower face before the run, mm.
        tubes: length of the tubes that guide a weight, mm; 0 without.
        top: plate on the tubes; None without.
        axle: place of the rear axle's middle, x and y, mm.
    """

    body: CarriedBody
    x: float
    z: float
    low: float
    high: float
    tubes: float
    top: Panel | None
    axle: complex

    @property
    def line(self) -> float:
        """Place x of the string over the axle, mm: behind it, where the axle of a car that drives ahead moves up."""
        return self.axle.real - self.body.wound / 2

    @property
    def pulley(self) -> float:
        """Diameter of the pulley over which the string leads, mm."""
        return abs(self.x - self.line)

    @property
    def turning(self) -> tuple[float, float, float] | None:
        """Radius of the drum with its flanges, and the heights along the axle at its ends, mm; None without one."""
        half = self.body.winding / 2
        return (self.body.reach, self.z - half, self.z + half) if self.body.drum else None

    @property
    def bracket_holes(self) -> tuple[SheetHole, ...]:
        """Holes of the pulley's bracket in the top plate, the last two that are drilled; none of a motor."""
        return () if self.top is None else self.top.holes[-2:]

    @property
    def drum(self) -> Block:
        """Drum in its own frame, whose z runs along the axle from the face of its right flange."""
        body, long = self.body, self.body.winding
        bore = circle((0.0, 0.0), body.axle / 2)
        hole = circle((body.drum / 2 + _BESIDE + body.knot / 2, 0.0), body.knot / 2)
        flange, barrel = circle((0.0, 0.0), body.reach), circle((0.0, 0.0), body.drum / 2)
        return Block(
            (
                Prism(flange, 0.0, FLANGE, (bore, hole)),
                Prism(barrel, FLANGE, long - FLANGE, (bore,)),
                Prism(flange, long - FLANGE, long, (bore,)),
            )
        )

    @property
    def piece(self) -> ConvexPrism:
        """Box of all places that it takes."""
        half, wide = self.body.along / 2, self.body.across / 2
        place = PartPlace(LYING, np.array([self.x, self.low, self.z]))
        return ConvexPrism.of(rectangle(-half, -wide, half, wide), self.low - self.high + self.body.tall, place)

    @property
    def shape(self) -> Block:
        """Solid in its own frame, whose z points up from its lower face."""
        half, wide = self.body.along / 2, self.body.across / 2
        outline = circle((0.0, 0.0), half)
        if not self.body.fall:
            outline = Contour(rectangle(-half, -wide, half, wide), np.zeros(4))
        return Block((Prism(outline, 0.0, self.body.tall),))

    @property
    def place(self) -> PartPlace:
        """Place before the run."""
        return PartPlace(LYING, np.array([self.x, self.high, self.z]))

    def corners(self, apart: tuple[float, float]) -> list[tuple[float, float]]:
        """Places x and z of the four holes in the base, mm.

        Args:
            apart: distances that the design states for a motor, mm.
        """
        along, across = self.body.holes(apart)
        return [(self.x + s * along / 2, self.z + t * across / 2) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def room_across(edges: tuple[float, float], clearance: float) -> float:
    """Width that a body may have between two faces, mm.

    Args:
        edges: heights of the faces, mm, the lower one first.
        clearance: gap to be kept from each, mm.
    """
    return edges[1] - edges[0] - 2 * clearance


def places(
    body: CarriedBody,
    base: shapely.Polygon,
    taken: shapely.Geometry,
    edges: tuple[float, float],
    axle: float,
    radius: float,
    holes: tuple[float, float],
    margin: float,
    clearance: float,
) -> Iterator[tuple[float, float]]:
    """Places x and z of the middle of a body on a base, the nearest to the rear axle first, mm.

    Args:
        body: weight or motor.
        base: material of the base, in its own frame.
        taken: areas that screws from below take there.
        edges: heights of the faces between which it stands, mm.
        axle: place x of the rear axle, which passes between them, mm.
        radius: its radius, or that of the drum on it, mm.
        holes: distances of its holes along and across the car, mm.
        margin: material round a hole from its middle, mm.
        clearance: least gap, mm.
    """
    half, wide = body.along / 2, body.across / 2
    reach = (max(half, holes[0] / 2 + margin), max(wide, holes[1] / 2 + margin))
    outer = max(half, (holes[0] + TUBE) / 2) if body.fall else half
    slack = room_across(edges, clearance) - body.width(holes)
    if slack < 0:
        return
    middle = sum(edges) / 2
    left, _, right, _ = base.bounds
    along = np.arange(-right + reach[0], -left - reach[0] + 1e-9, 0.5)
    for x in sorted(along.tolist(), key=lambda x: abs(x - axle)):
        if abs(x - axle) < outer + radius + clearance:
            continue
        for z in (middle, middle - slack / 2, middle + slack / 2):
            area = shapely.box(-x - reach[0], -z - reach[1], -x + reach[0], -z + reach[1])
            around = [
                shapely.box(u - margin, v - margin, u + margin, v + margin)
                for u, v in rectangle(-x - holes[0] / 2, -z - holes[1] / 2, -x + holes[0] / 2, -z + holes[1] / 2)
            ]
            if base.covers(area) and not any(each.intersects(taken) for each in around):
                yield x, z


def carried_at(
    body: CarriedBody,
    place: tuple[float, float],
    *,
    axle: complex,
    floor: float,
    base_top: float,
    clearance: float,
    screw: Screw,
    thickness: float,
    wall: float,
) -> Carried:
    """Weight with its guide, or motor, at a place.

    Args:
        body: weight or motor.
        place: place x and z of its middle, mm.
        axle: place of the rear axle's middle, x and y, mm.
        floor: height y of the floor, mm.
        base_top: height y of the base's upper face, mm.
        clearance: gap between a weight at its lowest place and the base, mm.
        screw: thread of the rods in the tubes.
        thickness: thickness of the top plate, mm.
        wall: least material between two of its holes, mm.
    """
    x, z = place
    if not body.fall:
        return Carried(body=body, x=x, z=z, low=base_top, high=base_top, tubes=0.0, top=None, axle=axle)
    start = floor - base_top + clearance + body.fall if body.start is None else body.start
    high = floor - start
    tubes = ceil((base_top - high + body.tall + _OVER) / _STEP - 1e-9) * _STEP
    made = Carried(body=body, x=x, z=z, low=high + body.fall, high=high, tubes=tubes, top=None, axle=axle)
    margin = screw.hole / 2 + _EDGE
    side = body.holes((0.0, 0.0))[0] / 2 + margin
    ends = sorted((x, made.line))
    reach = (margin, side) if made.line < x else (side, margin)
    middle = (x + made.line) / 2  # of the pulley, over which the string leads from the weight to the axle
    passed = max(_STRING, 2 * body.string + 1.0)
    holes = [SheetHole(Message("rod of the guide"), -u, -v, screw.hole) for u, v in made.corners((0.0, 0.0))]
    holes += [SheetHole(Message("string"), -at, -z, passed) for at in (x, made.line)]
    across = body.along / 4

    def crowded() -> bool:
        """Whether less than a wall is left beside the screws of the pulley's bracket."""
        if 2 * across - screw.hole < wall:
            return True
        return any(
            hypot(hole.u + middle, abs(hole.v + z) - across) < (hole.diameter + screw.hole) / 2 + wall for hole in holes
        )

    while crowded():  # beside a small weight they stand outside its tubes
        across += 0.5
    holes += [SheetHole(Message("bracket of the pulley"), -middle, -z + t * across, screw.hole) for t in (-1, 1)]
    wide = max(side, across + margin)
    outline = rectangle(-ends[1] - reach[1], -z - wide, -ends[0] + reach[0], -z + wide)
    top = Panel(
        code="guide_top",
        name=Message("top plate of the guide"),
        outline=Contour(outline, np.zeros(4)),
        cuts=(),
        holes=tuple(holes),
        edge_holes=(),
        features=(),
        thickness=thickness,
        place=PartPlace(LYING, np.array([0.0, base_top - tubes, 0.0])),
    )
    return replace(made, top=top)


def taken_by(screws: list[tuple[float, float]], head: float) -> shapely.Geometry:
    """Areas of a base that heads of screws from below take, in its own frame.

    Args:
        screws: places x and z, mm.
        head: distance that is kept from the middle of each, mm.
    """
    return shapely.union_all([shapely.Point(-x, -z).buffer(head) for x, z in screws])
