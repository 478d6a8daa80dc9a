"""Program that mills the holes of a disc with the outline's cutter, in turns down and outwards from their middles.

The cutter goes down in a helix, so that it need not cut at its centre; at each level it then widens the hole ring by
ring, so that no core comes loose, and at last it leaves the wall through the middle. Turns are counterclockwise, which
inside a hole is climb milling. On a ring of radius r a cutter of radius c is faster at its wall than in its middle, by
(r + c) / r; the feed is less by as much.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, floor, hypot, pi, radians, tan
from pathlib import Path

from cadgen.car.running.friction import DiscMaterial
from cadgen.design.machining import Machining
from cadgen.output.files.drilling import Drill, Hole
from cadgen.output.files.gcode import comments, height_notes, opening, words, zero_note
from cadgen.parts.face import Face

LEAST_PATH = 0.25  # mm, radius of the smallest ring that a cutter is taken round
_OVERLAP = 0.45  # of the cutter's diameter, from ring to ring: no core is left within the first
_SLOPE = tan(radians(4.0))  # of the helix, at most: end mills take 3 to 5 degrees in most materials


@dataclass(frozen=True, slots=True)
class Turn:
    """A turn of the cutter round the middle of a hole.

    Attributes:
        radius: radius of the path of its middle, mm.
        top: height at which it begins, mm.
        bottom: height at which it ends, mm.
        feed: feed along its path, mm/min.
    """

    radius: float
    top: float
    bottom: float
    feed: float

    @property
    def length(self) -> float:
        """Length of its path, mm."""
        return hypot(2 * pi * self.radius, self.top - self.bottom)


def is_milled(drill: Drill, machining: Machining) -> bool:
    """Whether holes are milled: they are wider than the cutter, and the design names no drill of their size.

    Args:
        drill: holes of a size.
        machining: cutter, and the drill that the design names.
    """
    named = machining.drilling.bore_diameter_mm if machining.drilling else None
    return drill.diameter != named and drill.diameter >= machining.cutter_diameter_mm + 2 * LEAST_PATH


def turns_of(hole: Hole, diameter: float, machining: Machining, material: DiscMaterial | None) -> list[Turn]:
    """Turns that mill a hole, in their order.

    Args:
        hole: place and heights of the hole.
        diameter: diameter of the hole, mm.
        machining: cutter, feeds and depth of a pass.
        material: material of the disc, for the feed; None if it is not known.
    """
    cutter, bottom = machining.cutter_diameter_mm, hole.bottom - machining.break_through_mm
    last = (diameter - cutter) / 2
    first = min(last, _OVERLAP * cutter)
    widened = ceil((last - first) / (_OVERLAP * cutter) - 1e-9)
    rings = [first + (last - first) * number / widened for number in range(widened + 1)] if widened else [first]
    passes = ceil((hole.top - bottom) / machining.step_down_mm - 1e-9)
    levels = [hole.top + (bottom - hole.top) * number / passes for number in range(passes + 1)]
    turns: list[Turn] = []
    for upper, lower in pairwise(levels):
        down = ceil((upper - lower) / (2 * pi * first * _SLOPE) - 1e-9)
        heights = [upper + (lower - upper) * number / down for number in range(down + 1)]
        turns += [
            Turn(first, start, end, _feed(first, start - end, machining, material)) for start, end in pairwise(heights)
        ]
        turns += [Turn(ring, lower, lower, _feed(ring, 0.0, machining, material)) for ring in rings]
    return turns


def _feed(radius: float, down: float, machining: Machining, material: DiscMaterial | None) -> float:
    """Feed on a turn, mm/min, by that at the wall and by that downwards."""
    at_wall = machining.feed(material) * radius / (radius + machining.cutter_diameter_mm / 2)
    falls = hypot(2 * pi * radius, down) / down * machining.plunge_feed_mm_per_min if down else at_wall
    feed = min(at_wall, falls)
    return floor(100 * feed) / 100 or feed


def hole_minutes(hole: Hole, diameter: float, machining: Machining, material: DiscMaterial | None) -> float:
    """Time at the feeds of the turns that mill a hole, min.

    Args:
        hole: place and heights of the hole.
        diameter: diameter of the hole, mm.
        machining: cutter, feeds and depth of a pass.
        material: material of the disc, for the feed; None if it is not known.
    """
    turns = turns_of(hole, diameter, machining, material)
    minutes = machining.approach_mm / machining.plunge_feed_mm_per_min + turns[-1].radius / turns[-1].feed
    minutes += sum(turn.length / turn.feed for turn in turns)
    return minutes + sum(abs(after.radius - before.radius) / before.feed for before, after in pairwise(turns))


def write_hole_milling(
    path: Path,
    holes: Sequence[Drill],
    machining: Machining,
    *,
    name: str,
    material: DiscMaterial | None = None,
    face: Face = Face.OUTER,
) -> None:
    """Write the program that mills holes with the outline's cutter.

    Args:
        path: file to write.
        holes: holes of each size.
        machining: cutter, speeds, heights and depth of a pass.
        name: name of the design, for the first comment.
        material: material of the disc, for the feed; None if none is given.
        face: face of the disc that lies up.
    """
    height = machining.safe_height_mm + max(hole.top for size in holes for hole in size.holes)
    count = sum(len(size.holes) for size in holes)
    assumed = machining.assumption(material)
    lines = [
        *comments(
            [
                *([assumed] if assumed else []),
                f"{name}: {count} {'hole' if count == 1 else 'holes'}, milled from their middles outwards",
                *(f"{size.purpose}: {len(size.holes)} of {size.diameter:g} mm" for size in holes),
                f"cutter diameter {machining.cutter_diameter_mm:g} mm, no radius compensation at the machine",
                "it goes down in a helix and need not cut at its centre; climb milling",
                zero_note(face),
                f"the cutter goes {machining.break_through_mm:g} mm below the work: leave room under it",
                *height_notes(machining, height),
            ]
        ),
        *opening(machining, height),
    ]
    for size in holes:
        for hole in size.holes:
            lines += hole_lines(hole, turns_of(hole, size.diameter, machining, material), machining, height)
    path.write_text("\n".join([*lines, "M5", "M30"]) + "\n", encoding="ascii", newline="\n")


def hole_lines(hole: Hole, turns: Sequence[Turn], machining: Machining, height: float) -> Iterator[str]:
    """Lines of a program that mill a hole.

    Args:
        hole: place and heights of the hole.
        turns: turns of the cutter in it, in their order.
        machining: feeds and heights.
        height: height to which the cutter is lifted, mm.
    """
    x, y = hole.place
    radius = turns[0].radius
    yield f"G0 {words(X=x + radius, Y=y)}"
    yield f"G0 {words(Z=hole.top + machining.approach_mm)}"
    yield f"G1 {words(Z=hole.top)} F{machining.plunge_feed_mm_per_min:g}"
    feed = turns[0].feed
    for turn in turns:
        if turn.radius != radius:
            radius = turn.radius
            yield f"G1 {words(X=x + radius, Y=y)} F{feed:g}"
        feed = turn.feed
        down = {"Z": turn.bottom} if turn.bottom != turn.top else {}
        yield f"G3 {words(X=x + radius, Y=y, **down, I=-radius, J=0.0)} F{feed:g}"
    yield f"G1 {words(X=x, Y=y)} F{feed:g}"
    yield f"G0 {words(Z=height)}"
