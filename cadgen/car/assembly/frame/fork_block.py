"""Bearing block of the fork's spindle, and the platform that carries it."""

from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np

from cadgen.car.assembly.car_parts import Block, Drilled, Prism
from cadgen.car.assembly.fork_sizes import SPINDLE
from cadgen.car.assembly.frame.frame_ground import FrameGround
from cadgen.car.assembly.frame.frame_sizes import STEP
from cadgen.car.assembly.panels import (
    LYING,
    THREAD_END,
    ConvexPrism,
    Feature,
    Panel,
    PartPlace,
    SheetHole,
    rectangle,
    slot,
)
from cadgen.car.assembly.standard_parts import Bearing
from cadgen.curves.contour import Contour, circle
from cadgen.messages import Message

SPACERS_APART = 16.0  # mm across the car
_ROUND = 1.0  # mm by which an opening for the spindle is wider


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

    def beside(self, thread: float) -> float:
        """Least material beside a thread in its lower face, mm.

        Args:
            thread: diameter of the thread, mm.
        """
        reach = max(self.threads) + thread / 2
        inwards = min(self.threads, key=abs)
        return min(
            self.length / 2 - reach,
            abs(inwards) - (thread + self.bearing.diameter) / 2,
            (self.width - thread) / 2,
        )

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


def fork_block(ground: FrameGround) -> ForkBlock:
    """Block of the fork between platform and rod."""
    sizes, bearing, screw = ground.sizes, ground.fork_bearing, ground.sizes.screw.diameter
    apart = max(
        (SPINDLE + _ROUND) / 2 + sizes.screw.hole / 2 + sizes.wall,
        bearing.diameter / 2 + screw / 2 + sizes.wall,
    )
    apart = ceil(apart / STEP) * STEP
    upper = ground.top - ground.spacer - sizes.base
    return ForkBlock(
        length=2 * (apart + ceil(max(1.2 * screw, screw / 2 + sizes.wall) / STEP) * STEP),
        width=bearing.diameter + 2 * ground.rim,
        height=upper - ground.ceiling,
        bore=(bearing.diameter + SPINDLE) / 2,
        bearing=bearing,
        fit=sizes.seat,
        threads=(-apart, apart),
        tap=sizes.screw.tap_drill,
        depth=sizes.screw.least_length + THREAD_END,
        place=PartPlace(LYING, np.array([ground.site.base_radius, upper, ground.site.fork])),
    )


def fork_platform(ground: FrameGround, block: ForkBlock) -> tuple[Panel, tuple[tuple[float, float], ...]]:
    """Platform, and places x and z of its spacers."""
    site, sizes = ground.site, ground.sizes
    along, across = ground.swept[0] + sizes.screw.hole / 2 + sizes.wall, SPACERS_APART / 2
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
        place=PartPlace(LYING, np.array([0.0, ground.top - ground.spacer, 0.0])),
    )
    return panel, tuple((-u - du, -v - dv) for du, dv in corners)
