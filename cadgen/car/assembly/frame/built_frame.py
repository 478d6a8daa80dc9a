"""Frame of a car: its parts at their places, and what they come to."""

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from math import inf

import shapely

from cadgen.car.assembly.arrangement import Arrangement
from cadgen.car.assembly.carried import Carried
from cadgen.car.assembly.fork_sizes import BRIDGE_HEIGHT, GAP
from cadgen.car.assembly.frame.bought_parts import Bought
from cadgen.car.assembly.frame.fork_block import ForkBlock
from cadgen.car.assembly.frame.frame_sizes import ROUNDING, FrameSizes
from cadgen.car.assembly.frame.one_piece import OnePiece, one_piece
from cadgen.car.assembly.panels import Panel
from cadgen.car.assembly.site import CarSite
from cadgen.messages import Message


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
        """Every sheet, and every wall of a printed frame."""
        guide = () if self.carried is None or self.carried.top is None else (self.carried.top,)
        return (*self.plates, self.base, self.platform, *self.brackets, *guide)

    @property
    def standing(self) -> tuple[Panel, ...]:
        """Plates and brackets, which are walls of a printed frame."""
        return (*self.plates, *self.brackets)

    @cached_property
    def printed(self) -> OnePiece | None:
        """Base, plates and brackets as one part; None for a frame of sheets."""
        return None if self.sizes.bed is None else one_piece(self.base, self.standing, self.top)

    @property
    def sheets(self) -> tuple[Panel, ...]:
        """Sheets that are parts of their own."""
        if self.sizes.bed is None:
            return self.panels
        return tuple(panel for panel in self.panels if panel is not self.base and panel not in self.standing)

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
        complete = complete and self.block.height >= 2 * self.block.bearing.width + self.sizes.wall - ROUNDING
        return complete and self.wall[0] >= self.sizes.wall - ROUNDING

    @cached_property
    def wall(self) -> tuple[float, str]:
        """Least material between openings or threads of a part, or between one and the edge, mm; and the part."""
        least = (inf, "")
        for panel in self.panels:
            face = shapely.Polygon(panel.outline.polygon(0.002))
            open_ones = [shapely.Polygon(each.polygon(0.002)) for each in panel.openings]
            sizes = [one.distance(other) for one, other in combinations([*panel.rooms, *open_ones], 2)]
            sizes += [one.distance(face.exterior) for one in open_ones]
            sizes += [panel.beside(room) for room in panel.rooms]
            if not all(each.is_valid for each in (face, *open_ones)):  # as of half circles that meet each other
                sizes.append(0.0)
            if sizes and min(sizes) < least[0]:
                least = (float(min(sizes)), panel.name)
        beside = self.block.beside(self.sizes.screw.diameter)
        return (beside, Message("the fork's block")) if beside < least[0] else least
