"""A body as a stack of prisms, and the walls and caps that bound it.

Both the B-rep and the mesh are made from this one description, so a feature is described once.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise, zip_longest

from cadgen.errors import DesignError
from cadgen.parts.loop import Loop


@dataclass(frozen=True, slots=True)
class Slab:
    """Prism between the heights `start` and `end` (mm along the axis).

    `rings` are nested outlines, outermost first, with material inside every first and outside every second;
    `holes` are further outlines in the material.
    """

    start: float
    end: float
    rings: tuple[Loop, ...]
    holes: tuple[Loop, ...] = ()

    @property
    def area(self) -> float:
        """Area of the section in mm²."""
        areas = (outline.area if outward else -outline.area for outline, outward in self.walls().items())
        return sum(areas)

    def walls(self) -> dict[Loop, bool]:
        """Every outline of the section, with True if the material is inside it."""
        return {ring: i % 2 == 0 for i, ring in enumerate(self.rings)} | dict.fromkeys(self.holes, False)


@dataclass(frozen=True, slots=True)
class RadialHole:
    """A round hole drilled from the axis outwards.

    Attributes:
        diameter: diameter of the hole, mm.
        height: height of its axis along z, mm.
        reach: distance of its end from the z axis, mm.
        angle: polar angle of its axis, rad.
    """

    diameter: float
    height: float
    reach: float
    angle: float = 0.0


@dataclass(frozen=True, slots=True)
class Body:
    """A stack of slabs, each on top of the one before, less an optional radial hole."""

    slabs: tuple[Slab, ...]
    radial_hole: RadialHole | None = None

    @property
    def drilled(self) -> int | None:
        """Number of the slab that the radial hole goes through; None without a hole."""
        hole = self.radial_hole
        if hole is None:
            return None
        return next(number for number, slab in enumerate(self.slabs) if slab.start < hole.height < slab.end)

    @property
    def prismatic_volume(self) -> float:
        """Volume in mm³ from the exact areas, the radial hole not taken off."""
        return sum(slab.area * (slab.end - slab.start) for slab in self.slabs)


@dataclass(frozen=True, slots=True)
class SweptWall:
    """Outline swept from the height `start` to `end`; `outward` where the material is inside it."""

    outline: Loop
    start: float
    end: float
    outward: bool

    def within(self, slab: Slab) -> bool:
        """Whether the wall lies between the heights of `slab`.

        Args:
            slab: slab with its heights, mm.
        """
        return slab.start <= self.start and self.end <= slab.end


@dataclass(frozen=True, slots=True)
class Cap:
    """Flat face at `height` between the outline `outer` and those in `inner`; `up` where it faces upwards."""

    height: float
    up: bool
    outer: Loop
    inner: tuple[Loop, ...]


def walls_of(body: Body) -> Iterator[SweptWall]:
    """The walls of `body` by rising height, one per outline and unbroken run of slabs.

    A slab with a radial hole keeps its walls apart from those of its neighbours.

    Args:
        body: body of prisms.
    """
    drilled = body.drilled
    open_walls: dict[tuple[Loop, bool], float] = {}
    for i, slab in enumerate(body.slabs):
        current = slab.walls()
        above = body.slabs[i + 1].walls() if i + 1 < len(body.slabs) else {}
        for outline, outward in current.items():
            start = open_walls.pop((outline, outward), slab.start)
            if above.get(outline) is outward and drilled not in (i, i + 1):
                open_walls[outline, outward] = start
            else:
                yield SweptWall(outline, start, slab.end, outward)


def caps_of(slabs: tuple[Slab, ...]) -> Iterator[Cap]:
    """The flat faces of the stack by rising height: where the section below differs from the one above.

    Raises `DesignError` if outlines that meet at one height cross.

    Args:
        slabs: slabs by rising height.
    """
    void = Slab(0.0, 0.0, ())
    heights = [slabs[0].start, *(slab.end for slab in slabs)]
    for height, below, above in zip(heights, (void, *slabs), (*slabs, void), strict=True):
        ended, begun = below.walls(), above.walls()
        exposed = ended.keys() ^ begun.keys()
        rings = sorted(exposed.intersection(below.rings + above.rings), key=lambda ring: -ring.radii[1])
        holes = [hole for hole in below.holes + above.holes if hole in exposed]
        _require_nested(height, rings)
        for outer, inner in zip_longest(rings[::2], rings[1::2]):
            inside = [] if inner is None else [inner]
            low, high = inner.radii[1] if inner else 0.0, outer.radii[0]
            inside += [hole for hole in holes if low < hole.radii[0] and hole.radii[1] < high]
            up = ended[outer] if outer in ended else not begun[outer]
            yield Cap(height, up, outer, tuple(inside))


def _require_nested(height: float, rings: list[Loop]) -> None:
    for outer, inner in pairwise(rings):
        if inner.radii[1] >= outer.radii[0]:
            raise DesignError(
                "the outlines of {outer:.4g} mm and {inner:.4g} mm diameter cross at {height:g} mm along the axis; "
                "make the inner one smaller or the outer one larger",
                outer=2 * outer.radii[0],
                inner=2 * inner.radii[1],
                height=height,
            )
