"""Frame of a car: two bearing plates, a base, the fork's platform and block, and brackets, by the layout.

The base lies under the seats of all bearings, as high as these allow; gears that reach lower, and the front wheel, pass
through openings in it. The sheets that stand on it have tabs in slots of the base, and screws from below. A platform on
spacers carries the block that bears the fork. Its slots along the car let a micrometer head in a bracket before it set
the distance between fork axis and camshaft.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from itertools import combinations, pairwise
from math import ceil, inf, sqrt
from typing import NamedTuple

import numpy as np
import shapely

from cadgen.arrays import Array
from cadgen.car.assembly.arrangement import Arrangement
from cadgen.car.assembly.car_parts import Block, Drilled, Prism
from cadgen.car.assembly.carried import (
    TUBE,
    TUBE_BORE,
    Carried,
    CarriedBody,
    carried_at,
    places,
    room_across,
    taken_by,
)
from cadgen.car.assembly.fork_sizes import (
    BRIDGE_HEIGHT,
    BRIDGE_LENGTH,
    CHEEK,
    CLAMP,
    FRONT_WIDTH,
    GAP,
    HEAD_HALF,
    SPINDLE,
    front_radius,
    hub_width,
)
from cadgen.car.assembly.panels import (
    ACROSS,
    LYING,
    STANDING,
    ConvexPrism,
    EdgeHole,
    Feature,
    Panel,
    PartPlace,
    SheetHole,
    rectangle,
    rounded_corners,
    slot,
)
from cadgen.car.assembly.site import STEERING_STEPS, CarSite, OnShaft
from cadgen.car.assembly.standard_parts import LENGTHS, Bearing, Screw, bearing_of, screw_length, smallest_bearing
from cadgen.curves.contour import Contour, circle
from cadgen.messages import Message

_RIM = 1.5  # walls of material round a seat, where nothing else decides
_STEP = 0.5  # mm, between places that are tried along a foot, and to which heights are rounded up
_FIT = 0.1  # mm by which a slot is longer and wider than the tab in it
_TAB, _SHORT_TAB = 10.0, 7.0  # mm, lengths of tabs
_LONG = 45.0  # mm, from which a foot has four joints in place of three
_BEFORE = 6.0  # mm between platform and micrometer bracket
_ROUND = 1.0  # mm by which an opening for the spindle is wider
_SPACER_HALF = 3.2  # mm, half across the corners of a hexagonal spacer for M3; larger ones in proportion
_SPACERS = (5, 6, 8, 10, 12, 15, 16, 18, 20, 25, 30, 35, 40, 45, 50, 60, 70, 80)  # mm, lengths that are sold
_SPACERS_APART = 16.0  # mm across the car
_NUT_PLAY = 0.2  # mm of a nut in its slot
_ROUNDING = 1e-6  # mm
_LEAST_OPENING = 8.0  # mm, of an opening of the base along the car: cutters pass
# mm by which the base is set lower, one after the other, until all that stands on it has room.
_LOWER = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.5, 8.0, 10.0, 12.0, 15.0, 18.0, 22.0, 27.0, 33.0, 40.0)
_HALF_FOOT = 18.0  # mm, half of the foot of a bracket
_BEYOND = 12.0  # mm of a bearing plate's foot beyond the outermost axes


@dataclass(frozen=True, slots=True, kw_only=True)
class FrameSizes:
    """Sizes of a frame that a design states.

    Attributes:
        wall: least material between two holes, and between a hole and an edge, mm.
        screw: screws between plates, base and block.
        tapped: whether the screws go into threads in the edges of the sheets; else into nuts in slots.
        corner: radius of the half circles in inner corners, mm; 0 for sharp ones.
        base: thickness of the base, mm.
        base_height: height of the base's lower face over the floor, mm; None for the highest that the bearings allow.
        travel: way by which the platform can be shifted, mm.
        stem: diameter of the micrometer head's stem, mm; 0 for none.
        drive: distances of the holes for motor or weight along and across the car, mm.
        carried: weight or motor; None for a car whose drive is not stated.
        seat: class of the seats of bearings.
    """

    wall: float
    screw: Screw
    tapped: bool
    corner: float
    base: float
    base_height: float | None
    travel: float
    stem: float
    drive: tuple[float, float]
    carried: CarriedBody | None
    seat: str


class BoughtKind(StrEnum):
    """Kinds of bought parts."""

    BEARING = "bearing"
    SCREW = "screw"
    NUT = "nut"
    TUBE = "tube"
    SPACER = "spacer"


class Bought(NamedTuple):
    """Bought part at its place.

    Attributes:
        kind: kind of part.
        code: what it is, such as `ISO 4762 M3 x 12`.
        name: name for people.
        start: middle of its first end, mm.
        way: direction of its axis.
        rounds: diameter, bore and ends along the axis of each round body that makes it up, mm.
    """

    kind: BoughtKind
    code: str
    name: str
    start: tuple[float, float, float]
    way: tuple[float, float, float]
    rounds: tuple[tuple[float, float, float, float], ...]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ForkBlock:
    """Bearing block of the fork's spindle, on the platform.

    Attributes:
        length: length along the car, mm.
        width: width across it, mm.
        height: height, mm.
        bore: diameter of the hole between the seats, mm.
        bearing: bearing in each end.
        fit: class of the seats.
        threads: places of the tapped holes in its lower face along the car, from its middle, mm.
        tap: diameter of the drill for the threads, mm.
        depth: depth of the tapped holes, mm.
        place: place: u back, v to the right, w up, from the middle of its lower face.
    """

    length: float
    width: float
    height: float
    bore: float
    bearing: Bearing
    fit: str
    threads: tuple[float, ...]
    tap: float
    depth: float
    place: PartPlace

    @property
    def volume(self) -> float:
        """Exact volume, mm³."""
        seats = 2 * self.bearing.width * (self.bearing.diameter**2 - self.bore**2)
        drilled = self.bore**2 * self.height + seats + len(self.threads) * self.tap**2 * self.depth
        return self.length * self.width * self.height - float(np.pi) / 4 * drilled

    @property
    def shape(self) -> Block:
        """Block as prisms one over the other, with the holes of its threads."""
        half, across, seat = self.length / 2, self.width / 2, self.bearing
        outline = Contour(rectangle(-half, -across, half, across), np.zeros(4))
        levels = (0.0, seat.width, self.height - seat.width, self.height)
        prisms = tuple(
            Prism(outline, low, high, (circle((0.0, 0.0), diameter / 2),))
            for (low, high), diameter in zip(pairwise(levels), (seat.diameter, self.bore, seat.diameter), strict=True)
        )
        threads = tuple(Drilled((at, 0.0, 0.0), (0.0, 0.0, 1.0), self.tap, self.depth) for at in self.threads)
        return Block(prisms, drilled=threads)

    @property
    def piece(self) -> ConvexPrism:
        """Box that holds it."""
        half, across = self.length / 2, self.width / 2
        return ConvexPrism.of(rectangle(-half, -across, half, across), self.height, self.place)


class FootJoint(NamedTuple):
    """Joint of a standing sheet with the base.

    Attributes:
        at: place along the foot in the sheet's own frame, mm.
        width: length of the tab, mm; 0 for a screw.
    """

    at: float
    width: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Frame:
    """Parts of a frame at their places.

    Attributes:
        sizes: what the design states.
        site: what stands in the car.
        arrangement: train at its place.
        plates: bearing plates, that beside the disc first.
        base: base plate.
        platform: sheet on spacers that carries the block.
        brackets: bracket beside the idle wheel, and that of the micrometer if there is one.
        block: block of the fork.
        spacers: places x and z of the spacers between base and platform, mm.
        bought: bearings, screws, nuts and spacers.
        pieces: pieces into which openings cut the base.
        joints: joints that found room, and how many there should be.
        top: height y of the base's upper face, mm.
        carried: weight or motor at its place; None without one, or where it finds no place.
        carried_room: width across the car that it may have, mm.
    """

    sizes: FrameSizes
    site: CarSite
    arrangement: Arrangement
    plates: tuple[Panel, Panel]
    base: Panel
    platform: Panel
    brackets: tuple[Panel, ...]
    block: ForkBlock
    spacers: tuple[tuple[float, float], ...]
    bought: tuple[Bought, ...]
    pieces: int
    joints: tuple[int, int]
    top: float
    carried: Carried | None
    carried_room: float

    @property
    def panels(self) -> tuple[Panel, ...]:
        """Every sheet."""
        guide = () if self.carried is None or self.carried.top is None else (self.carried.top,)
        return (*self.plates, self.base, self.platform, *self.brackets, *guide)

    @property
    def under(self) -> float:
        """Height of the lowest screw head under the base over the floor, mm."""
        return self.arrangement.height - self.top - self.sizes.base - self.sizes.screw.head_height

    @property
    def wheel_room(self) -> float:
        """Diameter of the largest front wheel for which the fork has room under the rod, mm."""
        block = self.arrangement.height - self.top + self.spacer + self.sizes.base
        below = 2 * self.block.bearing.width + self.sizes.wall - self.block.height
        over = self.sizes.base + self.sizes.screw.head_height + self.site.clearance + BRIDGE_HEIGHT + GAP
        return block - max(below, 0.0) - over

    @property
    def spacer(self) -> float:
        """Length of the spacers, mm."""
        return float(self.top - self.platform.place.shift[1])

    @property
    def whole(self) -> bool:
        """Whether the base is in one piece, all that it carries has room, and every wall is thick enough."""
        complete = self.pieces == 1 and self.joints[0] == self.joints[1]
        complete = complete and (self.sizes.carried is None or self.carried is not None)
        complete = complete and self.block.height >= 2 * self.block.bearing.width + self.sizes.wall - _ROUNDING
        return complete and self.wall[0] >= self.sizes.wall - _ROUNDING

    @cached_property
    def wall(self) -> tuple[float, str]:
        """Least material between two openings of a sheet, or between one and the edge, mm; and the sheet."""
        least = (inf, "")
        for panel in self.panels:
            edge = shapely.LinearRing(panel.outline.polygon(0.002))
            open_ones = [shapely.Polygon(each.polygon(0.002)) for each in panel.openings]
            drilled = [
                shapely.box(each.u - each.diameter / 2, each.v, each.u + each.diameter / 2, each.v + each.depth)
                for each in panel.edge_holes
            ]
            sizes = [one.distance(other) for one, other in combinations(open_ones, 2)]
            sizes += [one.distance(other) for one in drilled for other in open_ones]
            sizes += [one.distance(edge) for one in open_ones]
            if sizes and min(sizes) < least[0]:
                least = (float(min(sizes)), panel.name)
        return least


def frame_of(
    sizes: FrameSizes,
    site: CarSite,
    found: Arrangement,
    shafts: Sequence[Sequence[OnShaft]],
    bores: Sequence[float],
) -> Frame:
    """Frame of a car.

    Args:
        sizes: what the design states.
        site: what stands in the car.
        found: train at its place.
        shafts: round bodies on every shaft, from `shaft_bodies`.
        bores: diameter of every shaft, mm.
    """
    made = _Maker(sizes, site, found, shafts, bores).frame()
    if sizes.base_height is not None:
        return made
    best = made
    # Lower down the base has smaller openings, and more room for what stands on it.
    highest, room = made.top, made.under - site.floor_clearance
    for lower in (highest + way for way in _LOWER if way < room):
        if best.whole:
            break
        made = _Maker(sizes, site, found, shafts, bores, lower).frame()
        if made.whole or (made.joints[0], made.block.height) > (best.joints[0], best.block.height):
            best = made
    return best


class _Maker:
    """Frame while its parts are made one after the other."""

    def __init__(
        self,
        sizes: FrameSizes,
        site: CarSite,
        found: Arrangement,
        shafts: Sequence[Sequence[OnShaft]],
        bores: Sequence[float],
        top: float | None = None,
    ) -> None:
        self.sizes, self.site, self.found, self.shafts, self.bores = sizes, site, found, shafts, bores
        self.rim = _RIM * sizes.wall
        self.low = sorted(z - site.plate / 2 for z in (found.place.near, found.place.far))
        self.axle = found.axes[0]
        self.fork_bearing = smallest_bearing(SPINDLE, inf) or Bearing("", SPINDLE, 2 * SPINDLE, SPINDLE)
        self.ceiling = HEAD_HALF + site.clearance  # y of the block's upper face
        self.wheel = front_radius(site, found.height)
        bridge = found.height - 2 * self.wheel - GAP - BRIDGE_HEIGHT
        lowest = bridge - site.clearance - sizes.screw.head_height  # y of the platform's lower face
        self.top = self._base_top(lowest) if top is None else top
        self.spacer = float(next((each for each in _SPACERS if each >= self.top - lowest - 1e-9), _SPACERS[-1]))
        # Half of the opening for fork and front wheel along and across the car.
        self.swept = self._swept()
        self.openings: list[shapely.Polygon] = []
        self.slots: list[shapely.Polygon] = []
        self.holes: list[SheetHole] = []
        self.screws: list[tuple[float, float]] = []  # x and z of those from below
        self.joints, self.wanted = 0, 0
        self.carried: Carried | None = None

    def frame(self) -> Frame:
        """Make every part."""
        site, sizes = self.site, self.sizes
        u, v, (along, across) = -site.base_radius, -site.fork, self.swept
        self.openings = [*self._dips(), shapely.box(u - along, v - across, u + along, v + across)]
        block = self._block()
        platform, spacers = self._platform(block)
        near_first = sorted(self.low, key=lambda low: abs(low + site.plate / 2 - self.found.place.near))
        plates = [
            self._bearing_plate("plate_near", Message("bearing plate beside the disc"), near_first[0], platform),
            self._bearing_plate("plate_far", Message("bearing plate away from the disc"), near_first[1], platform),
        ]
        brackets = [self._idle_bracket()]
        if sizes.stem:
            brackets.append(self._micrometer_bracket(platform))
        base, count = self._base(platform, spacers, [*plates, *brackets])
        return Frame(
            sizes=sizes,
            site=site,
            arrangement=self.found,
            plates=(plates[0], plates[1]),
            base=base,
            platform=platform,
            brackets=tuple(brackets),
            block=block,
            spacers=spacers,
            bought=tuple(self._bought(block, spacers)),
            pieces=count,
            joints=(self.joints, self.wanted),
            top=self.top,
            carried=self.carried,
            carried_room=room_across(self._beside(), site.clearance),
        )

    def _base_top(self, platform: float) -> float:
        """Height y of the base's upper face: as high as seats and spacers allow, or as stated.

        Args:
            platform: height y of the platform's lower face at the lowest, mm.
        """
        if self.sizes.base_height is not None:
            return self.found.height - self.sizes.base_height - self.sizes.base
        seats = [axis.imag + diameter / 2 + self.rim for axis, diameter in self._seats()]
        stem = platform - self.sizes.base / 2 + self.sizes.stem / 2 + self.rim
        return ceil(max(*seats, platform - _SPACERS[0], stem if self.sizes.stem else 0.0) / _STEP - 1e-9) * _STEP

    def _swept(self) -> tuple[float, float]:
        """Half of the lengths along and across the car that fork and front wheel need in the base."""
        site, hub = self.site, hub_width(self.site) / 2 + CHEEK
        angles = np.linspace(*site.wheel_angles, STEERING_STEPS + 1)
        c, s = np.cos(angles), np.abs(np.sin(angles))
        # Of the wheel as much as the base meets.
        over = max(self.found.height - self.wheel - self.top - self.sizes.base, 0.0)
        chord = sqrt(max(self.wheel**2 - over**2, 0.0))
        boxes = ((BRIDGE_LENGTH / 2, hub), (chord, (site.front_width or FRONT_WIDTH) / 2))
        margin = site.clearance + self.sizes.travel / 2
        along = max(float((long * c + wide * s).max()) for long, wide in boxes) + margin
        across = max(float((long * s + wide * c).max()) for long, wide in boxes) + site.clearance
        return ceil(along / _STEP) * _STEP, ceil(across / _STEP) * _STEP

    def _seats(self) -> list[tuple[complex, float]]:
        """Axis and diameter of the seat of each shaft that has one in both plates."""
        every = zip(self.found.axes, self.site.bearings, self.site.ending, strict=True)
        return [(axis, diameter) for axis, diameter, ends in every if diameter and not ends]

    def _dips(self) -> Iterator[shapely.Polygon]:
        """Openings of the base for bodies that reach down to it, in the base's own frame."""
        keep, train = self.site.clearance, []
        for axis, bodies in zip(self.found.axes, self.shafts, strict=True):
            for body, of_train in bodies:
                reach, deep = body.radius + keep, self.top - axis.imag
                if reach <= deep:
                    continue
                half = max(sqrt(reach**2 - max(deep, 0.0) ** 2), _LEAST_OPENING / 2)
                box = shapely.box(-axis.real - half, -body.high - keep, -axis.real + half, -body.low + keep)
                if of_train:
                    train.append(box)
                else:
                    yield box
        if train:  # one opening for all gears, which a saw or a laser cuts at once
            yield shapely.box(*shapely.union_all(train).bounds)

    def _block(self) -> ForkBlock:
        sizes, bearing = self.sizes, self.fork_bearing
        apart = max(
            (SPINDLE + _ROUND) / 2 + sizes.screw.hole / 2 + sizes.wall,
            bearing.diameter / 2 + sizes.screw.tap_drill / 2 + sizes.wall,
        )
        apart = ceil(apart / _STEP) * _STEP
        upper = self.top - self.spacer - sizes.base
        return ForkBlock(
            length=2 * (apart + ceil(1.2 * sizes.screw.diameter / _STEP) * _STEP),
            width=bearing.diameter + 2 * self.rim,
            height=upper - self.ceiling,
            bore=(bearing.diameter + SPINDLE) / 2,
            bearing=bearing,
            fit=sizes.seat,
            threads=(-apart, apart),
            tap=sizes.screw.tap_drill,
            depth=sizes.screw.least_length + 2.0,
            place=PartPlace(LYING, np.array([self.site.base_radius, upper, self.site.fork])),
        )

    def _platform(self, block: ForkBlock) -> tuple[Panel, tuple[tuple[float, float], ...]]:
        """Platform, and places x and z of its spacers."""
        site, sizes = self.site, self.sizes
        along, across = self.swept[0] + sizes.screw.hole / 2 + sizes.wall, _SPACERS_APART / 2
        margin = max(sizes.screw.head_diameter / 2, sizes.travel / 2 + sizes.screw.hole / 2) + sizes.wall
        left, right = -along - margin, along + margin
        u, v = -site.base_radius, -site.fork
        holes = [SheetHole(Message("spindle of the fork"), u, v, SPINDLE + _ROUND)]
        holes += [SheetHole(Message("screw of the block"), u + at, v, sizes.screw.hole) for at in block.threads]
        corners = [(s * along, t * across) for s in (-1, 1) for t in (-1, 1)]
        cuts, features = [], []
        for du, dv in corners:
            if sizes.travel:
                cuts.append(slot((u + du, v + dv), sizes.travel, sizes.screw.hole))
                features.append(
                    Feature(
                        Message("slot, round ends"),
                        u + du,
                        v + dv,
                        sizes.travel + sizes.screw.hole,
                        sizes.screw.hole,
                    )
                )
            else:
                holes.append(SheetHole(Message("screw of a spacer"), u + du, v + dv, sizes.screw.hole))
        side = across + margin
        outline = Contour(rectangle(u + left, v - side, u + right, v + side), np.zeros(4))
        panel = Panel(
            code="platform",
            name=Message("platform of the fork"),
            outline=outline,
            cuts=tuple(cuts),
            holes=tuple(holes),
            edge_holes=(),
            features=tuple(features),
            thickness=sizes.base,
            place=PartPlace(LYING, np.array([0.0, self.top - self.spacer, 0.0])),
        )
        return panel, tuple((-u - du, -v - dv) for du, dv in corners)

    @property
    def _open(self) -> float:
        """Height of the middle of the plate that the rear axle passes without a bearing, mm.

        A third bearing beside that of the other plate and that of the idle bracket would bend the axle wherever the
        three are not in line.
        """
        return min(self.found.place.near, self.found.place.far, key=lambda z: abs(z - self.site.idle_wheel))

    def _bearing_plate(self, code: str, name: str, low: float, platform: Panel) -> Panel:
        site, thick = self.site, self.site.plate
        holes = []
        for number, (axis, diameter, ends_here) in enumerate(
            zip(self.found.axes, site.bearings, site.ending, strict=True), 1
        ):
            if not diameter or ends_here:
                continue
            hole = SheetHole(
                Message("seat of shaft {shaft}", shaft=number),
                -axis.real,
                -axis.imag,
                diameter,
                self.sizes.seat,
                number,
            )
            if number == 1 and abs(low + thick / 2 - self._open) < _ROUNDING:
                free = Message("passage of the rear axle")
                hole = hole._replace(name=free, diameter=self.bores[0] + 2 * site.clearance, fit="")
            holes.append(hole)
        ends = [-axis.real for axis in self.found.axes]
        span = (min(ends) - _BEYOND, max(ends) + _BEYOND)
        # Ahead, which is to the left, the foot may be as long as the platform leaves room.
        ahead = float(platform.outline.vertices[:, 0].max()) + self.sizes.travel / 2 + site.clearance
        outer = max(self.low) == low if self.found.place.towards < 0 else min(self.low) == low
        flush = (low + thick if self.found.place.towards < 0 else low) if outer else None
        joints: list[FootJoint] = []
        while True:
            joints = self._joints(span, holes, self._strip_along(low, flush))
            if len(joints) == 4 or (span[0] <= ahead and span[1] >= max(ends) + 40):
                break
            span = (max(span[0] - 5.0, min(ahead, span[0])), span[1] if span[0] > ahead else span[1] + 5.0)
        self._join(joints, 4, lambda at: (-at, low + thick / 2), self._slots_along(low))
        return self._standing(code, name, holes, span, joints, PartPlace(STANDING, np.array([0.0, 0.0, low])))

    def _idle_bracket(self) -> Panel:
        site, thick = self.site, self.site.plate
        inwards = 1.0 if site.idle_wheel < site.fork else -1.0
        face = site.idle_wheel + inwards * (site.wheel_width / 2 + 2 * site.clearance)
        low = face if inwards > 0 else face - thick
        middle = -self.axle.real
        seat = self.site.bearings[0] if not self.site.ending[0] else 0.0
        name, size = Message("seat of shaft {shaft}", shaft=1), seat or self.bores[0]
        holes = [SheetHole(name, middle, -self.axle.imag, size, self.sizes.seat, 1)]
        span = (middle - _HALF_FOOT, middle + _HALF_FOOT)
        joints = self._joints(span, holes, self._strip_along(low, face))
        self._join(joints, 3, lambda at: (-at, low + thick / 2), self._slots_along(low))
        name = Message("bracket beside the idle wheel")
        return self._standing("bracket_idle", name, holes, span, joints, PartPlace(STANDING, np.array([0.0, 0.0, low])))

    def _micrometer_bracket(self, platform: Panel) -> Panel:
        site, sizes, thick = self.site, self.sizes, self.site.plate
        low = -float(platform.outline.vertices[:, 0].min()) + sizes.travel / 2 + _BEFORE
        height = -(self.top - self.spacer - sizes.base / 2)
        holes = [SheetHole(Message("hole for the micrometer head"), site.fork, height, sizes.stem, sizes.seat)]
        span = (site.fork - _HALF_FOOT, site.fork + _HALF_FOOT)

        def strip(start: float, end: float, along: float) -> shapely.Polygon:
            return shapely.box(-low - thick, -end - along, -low + sizes.wall, -start + along)

        joints = self._joints(span, holes, strip)
        half = _FIT / 2

        def cut(joint: FootJoint) -> shapely.Polygon:
            reach = joint.width / 2 + half
            return shapely.box(-low - thick - half, -joint.at - reach, -low + half, -joint.at + reach)

        self._join(joints, 3, lambda at: (low + thick / 2, at), cut)
        return self._standing(
            "bracket_micrometer",
            Message("bracket of the micrometer head"),
            holes,
            span,
            joints,
            PartPlace(ACROSS, np.array([low, 0.0, 0.0])),
        )

    def _strip_along(self, low: float, flush: float | None) -> Callable[[float, float, float], shapely.Polygon]:
        """Function of two places along a foot across the car's axes: the strip of the base that they need."""
        thick, wall = self.site.plate, self.sizes.wall

        def strip(start: float, end: float, along: float) -> shapely.Polygon:
            below = low if flush == low else low - wall
            above = low + thick if flush == low + thick else low + thick + wall
            if along > wall:  # a screw's head, which the sheet itself is wide enough for
                below, above = low, low + thick
            return shapely.box(start - along, -above, end + along, -below)

        return strip

    def _slots_along(self, low: float) -> Callable[[FootJoint], shapely.Polygon]:
        half = _FIT / 2

        def cut(joint: FootJoint) -> shapely.Polygon:
            reach = joint.width / 2 + half
            return shapely.box(joint.at - reach, -low - self.site.plate - half, joint.at + reach, -low + half)

        return cut

    def _joints(
        self,
        span: tuple[float, float],
        holes: Sequence[SheetHole],
        strip: Callable[[float, float, float], shapely.Polygon],
    ) -> list[FootJoint]:
        """Joints along a foot, as far apart as may be: two tabs between screws, on a short foot one screw between tabs.

        Args:
            span: ends of the foot, mm.
            holes: holes of the sheet.
            strip: function that gives the strip of the base under a length of the foot, with a margin along it.
        """
        sizes, wall = self.sizes, self.sizes.wall
        foot, deep, reach = -self.top, self._deep, max(sizes.screw.head_diameter / 2, sizes.screw.hole / 2 + wall)
        long = span[1] - span[0] >= _LONG
        tab = _TAB if long else _SHORT_TAB
        free = shapely.union_all(self.openings)
        seats = shapely.union_all(
            [shapely.Point(hole.u, hole.v).buffer(hole.diameter / 2 + wall, 64) for hole in holes]
        )
        wide = self._nut_half + wall

        def takes(at: float, width: float) -> bool:
            half, own = width / 2, width / 2 + wall if width else wide
            if at - own < span[0] or at + own > span[1]:
                return False
            if strip(at - half, at + half, wall + _FIT if width else reach).intersects(free):
                return False
            return bool(width or not shapely.box(at - wide, foot, at + wide, foot + deep).intersects(seats))

        places = np.arange(span[0], span[1] + 1e-9, _STEP).tolist()
        screws, tabs = ([at for at in places if takes(at, width)] for width in (0.0, tab))
        between = tab / 2 + max(wide, reach) + 0.5 * wall
        made: list[FootJoint] = []
        if not screws or not tabs:
            return made
        if long:
            first, last = screws[0], screws[-1]
            inside = [at for at in tabs if first + between <= at <= last - between]
            if inside and inside[-1] - inside[0] >= tab + wall:
                made = [
                    FootJoint(first, 0.0),
                    FootJoint(inside[0], tab),
                    FootJoint(inside[-1], tab),
                    FootJoint(last, 0.0),
                ]
            return made
        first, last = tabs[0], tabs[-1]
        inside = [at for at in screws if first + between <= at <= last - between]
        if inside:
            middle = min(inside, key=lambda at: abs(at - (first + last) / 2))
            made = [FootJoint(first, tab), FootJoint(middle, 0.0), FootJoint(last, tab)]
        return made

    @property
    def _length(self) -> float:
        """Length of the screws from below into the sheets, mm."""
        sizes = self.sizes
        inside = sizes.screw.least_length if sizes.tapped else sizes.wall + sizes.screw.nut_height + 1.0
        return screw_length(sizes.base + inside)

    @property
    def _deep(self) -> float:
        """Depth of what a screw needs in a sheet, with the wall behind it, mm."""
        return self._length - self.sizes.base + 2.0 + self.sizes.wall

    @property
    def _nut_half(self) -> float:
        """Half of the width of what a screw needs in a sheet, mm."""
        screw = self.sizes.screw
        return screw.tap_drill / 2 if self.sizes.tapped else (screw.nut_width + _NUT_PLAY) / 2

    def _join(
        self,
        joints: Sequence[FootJoint],
        wanted: int,
        below: Callable[[float], tuple[float, float]],
        cut: Callable[[FootJoint], shapely.Polygon],
    ) -> None:
        """Cut the base for the joints of a sheet."""
        self.joints, self.wanted = self.joints + len(joints), self.wanted + wanted
        for joint in joints:
            if joint.width:
                self.slots.append(cut(joint))
            else:
                self.screws.append(below(joint.at))

    def _standing(
        self,
        code: str,
        name: str,
        holes: Sequence[SheetHole],
        span: tuple[float, float],
        joints: Sequence[FootJoint],
        place: PartPlace,
    ) -> Panel:
        """Sheet that stands on the base: the hull of its seats' rims and its foot."""
        sizes, foot = self.sizes, -self.top
        points = [(span[0], foot), (span[1], foot)]
        for hole in holes:
            reach = hole.diameter / 2 + self.rim
            nick = reach * (sqrt(2.0) - 1.0)
            points += [
                (hole.u + s * a, hole.v + t * b)
                for a, b in ((reach, nick), (nick, reach))
                for s in (-1, 1)
                for t in (-1, 1)
            ]
        hull = np.asarray(shapely.MultiPoint(np.round(points, 2)).convex_hull.exterior.coords)[:-1]
        if not shapely.LinearRing(hull).is_ccw:
            hull = hull[::-1]
        start = int(np.argmin(np.abs(hull - np.round([span[1], foot], 2)).sum(axis=1)))
        upper = np.roll(hull, -start, axis=0)
        # Seats below the foot, as of a base that is set too high, are in the hull, and the check of walls says so.
        upper = upper[[0, *(number for number in range(1, len(upper)) if upper[number][1] > foot + 1e-6), -1]]
        upper[0], upper[-1] = (span[1], foot), (span[0], foot)
        lower: list[tuple[float, float]] = []
        for joint in sorted(joints):
            lower += self._tab(joint) if joint.width else [] if sizes.tapped else self._nut_slot(joint.at)
        corners = np.array([*upper, *lower])
        drilled = [joint.at for joint in joints if not joint.width] if sizes.tapped else []
        return Panel(
            code=code,
            name=name,
            outline=rounded_corners(corners, sizes.corner, inside=False),
            cuts=(),
            holes=tuple(holes),
            edge_holes=tuple(
                EdgeHole(at, foot, sizes.screw.tap_drill, self._length - sizes.base + 2.0) for at in drilled
            ),
            features=tuple(
                Feature(Message("tab"), joint.at, foot - sizes.base / 2, joint.width, sizes.base)
                if joint.width
                else Feature(
                    Message("slot for screw and nut"), joint.at, foot + (self._length - sizes.base + 2.0) / 2, 0.0, 0.0
                )
                for joint in joints
                if joint.width or not sizes.tapped
            ),
            thickness=self.site.plate,
            place=place,
        )

    def _tab(self, joint: FootJoint) -> list[tuple[float, float]]:
        half, foot, low = joint.width / 2, -self.top, -self.top - self.sizes.base
        left, right = joint.at - half, joint.at + half
        return [(left, foot), (left, low), (right, low), (right, foot)]

    def _nut_slot(self, at: float) -> list[tuple[float, float]]:
        """Slot for a screw and a nut across it, open at the foot."""
        screw, foot = self.sizes.screw, -self.top
        half, wide = screw.hole / 2, self._nut_half
        start = foot + self.sizes.wall
        end, deep = start + screw.nut_height + _NUT_PLAY, foot + self._length - self.sizes.base + 2.0
        left = [(at - half, foot), (at - half, start), (at - wide, start), (at - wide, end), (at - half, end)]
        left.append((at - half, deep))
        return left + [(2 * at - u, v) for u, v in reversed(left)]

    def _base(
        self, platform: Panel, spacers: Sequence[tuple[float, float]], standing: Sequence[Panel]
    ) -> tuple[Panel, int]:
        """Base, and the number of pieces into which its openings cut it."""
        site, sizes, thick = self.site, self.sizes, self.site.plate
        back = max(float(panel.outline.vertices[:, 0].max()) for panel in standing if panel.place.turn is STANDING)
        front = float(platform.outline.vertices[:, 0].min())
        across = [
            -z
            for panel in standing
            if panel.place.turn is STANDING
            for z in (float(panel.place.shift[2]), float(panel.place.shift[2]) + thick)
        ]
        reach = _SPACERS_APART / 2 + sizes.screw.hole / 2 + sizes.wall
        across += [-site.fork - reach, -site.fork + reach]
        if sizes.stem:
            (bracket,) = (panel for panel in standing if panel.place.turn is ACROSS)
            front = -float(bracket.place.shift[0]) - thick
        whole = shapely.box(front, min(across), back + sizes.wall, max(across))
        left = whole.difference(shapely.union_all([*self.openings, *self.slots]))
        parts = sorted(shapely.get_parts(left), key=lambda part: -part.area)
        outer = parts[0].simplify(0.0)
        holes = [SheetHole(Message("screw from below"), -x, -z, sizes.screw.hole) for x, z in self.screws]
        holes += [SheetHole(Message("screw of a spacer"), -x, -z, sizes.screw.hole) for x, z in spacers]
        holes += self._drive_holes(outer) if sizes.carried is None else self._carry(outer)
        cuts = [rounded_corners(_corners(ring), sizes.corner, inside=True) for ring in outer.interiors]
        outline = rounded_corners(_corners(outer.exterior), sizes.corner, inside=False)
        base = Panel(
            code="base",
            name=Message("base plate"),
            outline=outline,
            cuts=tuple(cuts),
            holes=tuple(holes),
            edge_holes=(),
            features=tuple(self._features(whole)),
            thickness=sizes.base,
            place=PartPlace(LYING, np.array([0.0, self.top + sizes.base, 0.0])),
        )
        return base, len(parts)

    def _features(self, whole: shapely.Polygon) -> Iterator[Feature]:
        """Slots and openings of the base."""
        named = [(Message("slot for a tab"), area) for area in self.slots]
        named += [(Message("opening"), area) for area in self.openings if area.intersects(whole)]
        for name, area in named:
            left, low, right, high = area.intersection(whole).bounds
            yield Feature(name, (left + right) / 2, (low + high) / 2, right - left, high - low)

    def _beside(self) -> tuple[float, float]:
        """Heights of the faces between which weight or motor stands: of train or fork, and of the idle bracket."""
        site, half = self.site, self.site.plate / 2
        inwards = 1.0 if site.idle_wheel < site.fork else -1.0
        bracket = site.idle_wheel + inwards * (site.wheel_width / 2 + 2 * site.clearance + site.plate)
        fork = max(self.swept[1], _SPACERS_APART / 2 + self.sizes.screw.head_diameter)
        faces = [z + s * half for z in (self.found.place.near, self.found.place.far) for s in (-1, 1)]
        faces += [z for part in site.disc for z in (part.low - CLAMP, part.high + CLAMP)]
        faces += [site.fork - fork, site.fork + fork]
        nearest = min(faces, key=lambda z: z * inwards)
        return (bracket, nearest) if inwards > 0 else (nearest, bracket)

    def _carry(self, base: shapely.Polygon) -> list[SheetHole]:
        """Holes for the weight's rods or the motor's screws, with the weight or motor set over them."""
        site, sizes, body = self.site, self.sizes, self.sizes.carried
        assert body is not None  # `_base` asks only where there is one
        found = next(
            places(
                body,
                base,
                taken_by(self.screws, sizes.screw.head_diameter),
                self._beside(),
                self.axle.real,
                body.reach if body.fall else self.bores[0] / 2,
                body.holes(sizes.drive),
                sizes.screw.hole / 2 + sizes.wall,
                site.clearance,
            ),
            None,
        )
        if found is None or (body.drum and self.top - self.axle.imag < body.reach + site.clearance):
            return []
        self.carried = carried_at(
            body,
            found,
            axle=self.axle,
            floor=self.found.height,
            base_top=self.top,
            clearance=site.clearance,
            screw=sizes.screw,
            thickness=sizes.base,
            wall=sizes.wall,
        )
        name = Message("rod of the guide") if body.fall else Message("motor")
        return [SheetHole(name, -x, -z, sizes.screw.hole) for x, z in self.carried.corners(sizes.drive)]

    def _of_the_drive(self) -> Iterator[Bought]:
        """Tubes, threaded rods and nuts of a weight's guide, or screws of a motor."""
        sizes, carried, up = self.sizes, self.carried, (0.0, -1.0, 0.0)
        if carried is None:
            return
        screw, under = sizes.screw, self.top + sizes.base
        for x, z in carried.corners(sizes.drive):
            if carried.top is None:
                long = screw_length(sizes.base + screw.least_length)
                code = f"ISO 4762 {screw.thread} x {long:g}"
                rounds = ((screw.head_diameter, 0.0, -screw.head_height, 0.0), (screw.diameter, 0.0, 0.0, long))
                name = Message("socket head screw {code}", code=code)
                yield Bought(BoughtKind.SCREW, code, name, (x, under, z), up, rounds)
                continue
            code = f"{TUBE:g} x {(TUBE - TUBE_BORE) / 2:g} x {carried.tubes:g}"
            tube = ((TUBE, TUBE_BORE, 0.0, carried.tubes),)
            yield Bought(BoughtKind.TUBE, code, Message("tube {code}", code=code), (x, self.top, z), up, tube)
            long = carried.tubes + 2 * sizes.base + 2 * screw.head_height
            code = f"DIN 976 {screw.thread} x {long:g}"
            rod = ((screw.diameter, 0.0, -screw.head_height, long - screw.head_height),)
            yield Bought(BoughtKind.SCREW, code, Message("threaded rod {code}", code=code), (x, under, z), up, rod)
            code = f"ISO 4032 {screw.thread}"
            nut = ((screw.nut_width, screw.diameter, 0.0, screw.nut_height),)
            for y, way in ((under, (0.0, 1.0, 0.0)), (self.top - carried.tubes - sizes.base, up)):
                yield Bought(BoughtKind.NUT, code, Message("nut {code}", code=code), (x, y, z), way, nut)

    def _drive_holes(self, base: shapely.Polygon) -> list[SheetHole]:
        """Four holes for motor or weight between the train and the idle wheel, as near to the axle as there is room."""
        site, sizes = self.site, self.sizes
        beside = sorted((self.found.place.far, site.idle_wheel))
        middle = -sum(beside) / 2
        reach = sizes.screw.hole / 2 + sizes.wall
        room = beside[1] - beside[0] - 2 * site.plate - 2 * site.wheel_width
        taken = shapely.union_all([shapely.Point(-x, -z).buffer(sizes.screw.head_diameter) for x, z in self.screws])
        for along, wide in (sizes.drive, sizes.drive[::-1]):
            if wide + 2 * reach > room:
                continue
            for step in np.arange(0.0, site.behind + site.base_radius, 1.0).tolist():
                at = -self.axle.real - step
                area = shapely.box(
                    at - along / 2 - reach, middle - wide / 2 - reach, at + along / 2 + reach, middle + wide / 2 + reach
                )
                if base.covers(area) and not area.intersects(taken):
                    name = Message("motor or weight")
                    corners = rectangle(at - along / 2, middle - wide / 2, at + along / 2, middle + wide / 2)
                    return [SheetHole(name, u, v, sizes.screw.hole) for u, v in corners.tolist()]
        return []

    def _borne(self, plate: float, width: float) -> tuple[float, float]:
        """Ends of a bearing in the plate whose middle is at a height: flush with the face that looks to the train."""
        half, low_one = self.site.plate / 2, plate < (self.found.place.near + self.found.place.far) / 2
        return (plate + half - width, plate + half) if low_one else (plate - half, plate - half + width)

    def _bought(self, block: ForkBlock, spacers: Sequence[tuple[float, float]]) -> Iterator[Bought]:
        site, sizes = self.site, self.sizes
        up = (0.0, -1.0, 0.0)
        every = zip(self.found.axes, site.bearings, self.bores, site.ending, strict=True)
        for number, (axis, diameter, bore, ends) in enumerate(every, 1):
            if not diameter or ends:
                continue
            known = bearing_of(bore, diameter)
            width, code = (
                (site.plate, f"{bore:g} x {diameter:g}") if known is None else (known.width, known.designation)
            )
            for z in (self.found.place.near, self.found.place.far):
                if number == 1 and z == self._open:
                    continue
                yield Bought(
                    BoughtKind.BEARING,
                    code,
                    Message("ball bearing {code}", code=code),
                    (axis.real, axis.imag, self._borne(z, width)[0]),
                    (0.0, 0.0, 1.0),
                    ((diameter, bore, 0.0, width),),
                )
        inwards = 1.0 if site.idle_wheel < site.fork else -1.0
        if site.bearings[0] and not site.ending[0]:
            known = bearing_of(self.bores[0], site.bearings[0])
            width, code = (site.plate, f"{self.bores[0]:g} x {site.bearings[0]:g}")
            if known is not None:
                width, code = known.width, known.designation
            face = site.idle_wheel + inwards * (site.wheel_width / 2 + 2 * site.clearance)
            yield Bought(
                BoughtKind.BEARING,
                code,
                Message("ball bearing {code}", code=code),
                (self.axle.real, self.axle.imag, face if inwards > 0 else face - width),
                (0.0, 0.0, 1.0),
                ((site.bearings[0], self.bores[0], 0.0, width),),
            )
        bearing, screw = block.bearing, sizes.screw
        under = self.top - self.spacer - sizes.base  # y of the platform's upper face
        for y in (under, under - block.height + bearing.width):
            yield Bought(
                BoughtKind.BEARING,
                bearing.designation,
                Message("ball bearing {code}", code=bearing.designation),
                (site.base_radius, y, site.fork),
                up,
                ((bearing.diameter, bearing.bore, 0.0, bearing.width),),
            )
        middle, base = site.base_radius, self.top + sizes.base
        through = screw_length(sizes.base + min(screw.least_length, self.spacer / 2))
        if through - sizes.base > self.spacer / 2:
            through = max((each for each in LENGTHS if each - sizes.base <= self.spacer / 2), default=LENGTHS[0])
        places = [(x, base, z, self._length, up) for x, z in self.screws]
        places += [(x, base, z, float(through), up) for x, z in spacers]
        places += [(x, under, z, float(through), (0.0, 1.0, 0.0)) for x, z in spacers]
        own = screw_length(sizes.base + screw.least_length)
        places += [(middle + at, under + sizes.base, site.fork, own, up) for at in block.threads]
        for x, y, z, long, way in places:
            code = f"ISO 4762 {screw.thread} x {long:g}"
            rounds = ((screw.head_diameter, 0.0, -screw.head_height, 0.0), (screw.diameter, 0.0, 0.0, long))
            yield Bought(BoughtKind.SCREW, code, Message("socket head screw {code}", code=code), (x, y, z), way, rounds)
        for x, z in spacers:
            code = f"{screw.thread} x {self.spacer:g}"
            spacer = ((2 * _SPACER_HALF * screw.diameter / 3.0, screw.diameter, 0.0, self.spacer),)
            yield Bought(
                BoughtKind.SPACER,
                code,
                Message("hexagonal spacer {code}, threads at both ends", code=code),
                (x, self.top, z),
                up,
                spacer,
            )
        yield from self._of_the_drive()
        if not sizes.tapped:
            for x, z in self.screws:
                code = f"ISO 4032 {screw.thread}"
                nut = ((screw.nut_width, screw.diameter, 0.0, screw.nut_height),)
                yield Bought(
                    BoughtKind.NUT, code, Message("nut {code}", code=code), (x, self.top - sizes.wall, z), up, nut
                )


def _corners(ring: shapely.LinearRing) -> Array:
    """Corners of a ring, counterclockwise."""
    points = np.asarray(ring.coords)[:-1]
    return points if shapely.LinearRing(points).is_ccw else points[::-1]
