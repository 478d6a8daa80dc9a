"""Program that mills a groove: one round with a cutter of its width, or rounds from flank to flank with a smaller one.

At each depth the cutter goes down along the first round as along a ramp, so it need not cut at its centre. The flanks
are read back as the parallels of the outermost and the innermost round, and no other cut may come nearer to them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import ceil
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import cKDTree

from cadgen.arrays import Array
from cadgen.curves.biarc import arcs
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.curves.contour import Contour
from cadgen.curves.derived import parallel
from cadgen.errors import CheckError, FileError
from cadgen.output.files.gcode import DECIMALS, comments, height_notes, opening, words
from cadgen.output.files.gcode_machine import Move, Work, run_program

if TYPE_CHECKING:
    from cadgen.car.running.friction import DiscMaterial
    from cadgen.design.machining import Machining

# Distance of neighbouring rounds, by the cutter's diameter: they overlap by a fifth.
_STEP_OVER = 0.8
_SAME_WIDTH = 5e-4  # mm; a cutter this close to the groove's width is one of its width
_STRAIGHT = 1e-4  # mm of sagitta; a flatter arc is written as a line
_CLOSED = 1e-3  # mm; where a round ends within this of its begin it is closed
_LEVEL = 1e-6  # mm
_GOUGE = 5e-4  # mm by which no other cut may come nearer to a flank


def rounds_of(inner: ClosedCurve, width: float, cutter_radius: float, tolerance: float) -> tuple[Contour, ...]:
    """Paths of the cutter's centre, from the middle of the groove to its flanks; the last two leave those.

    Climb milling: clockwise round the island, counterclockwise along the outer flank.

    Args:
        inner: inner flank of the groove, mm.
        width: width of the groove, mm.
        cutter_radius: radius of the cutter, mm.
        tolerance: greatest distance of the arcs from the exact paths, mm.

    Raises:
        CheckError: the cutter is wider than the groove.
    """
    spare = width - 2 * cutter_radius
    if spare < -_SAME_WIDTH:
        raise CheckError(
            "machining.cutter_diameter_mm is {diameter:g}, and the groove is {width:g} mm wide: choose a cutter of at "
            "most that",
            diameter=2 * cutter_radius,
            width=width,
        )
    if spare <= _SAME_WIDTH:
        return (arcs(parallel(inner, width / 2), tolerance),)
    count = ceil(spare / (2 * cutter_radius * _STEP_OVER)) + 1
    first, *between, last = cutter_radius + np.linspace(0.0, spare, count)
    middle = [arcs(parallel(inner, float(way)), tolerance).reversed() for way in between]
    return (*middle, arcs(parallel(inner, first), tolerance).reversed(), arcs(parallel(inner, last), tolerance))


def write_groove(
    path: Path,
    rounds: Sequence[Contour],
    depth: float,
    machining: Machining,
    *,
    name: str,
    material: DiscMaterial | None = None,
    above: float = 0.0,
    notes: Sequence[str] = (),
) -> None:
    """Write the program of a groove.

    Args:
        path: file to write.
        rounds: paths of the cutter's centre, from `rounds_of`, mm.
        depth: depth of the groove, mm.
        machining: cutter, speeds and heights.
        name: name of the cam, for the first comment.
        material: material of the disc, for the feed; None if none is given.
        above: height of a hub above the face, mm.
        notes: further comments for the shop.
    """
    count = ceil(depth / machining.step_down_mm - 1e-9)
    levels = [-depth * number / count for number in range(1, count + 1)]
    height = machining.safe_height_mm + above
    feed, assumed = machining.feed(material), machining.assumption(material)
    said = "one round of the groove's width" if len(rounds) == 1 else f"{len(rounds)} rounds from flank to flank"
    lines = [
        *comments(
            [
                *([assumed] if assumed else []),
                f"{name}: groove of the cam, {depth:g} mm deep, {said} at each of {count} depths",
                *notes,
                f"cutter diameter {machining.cutter_diameter_mm:g} mm, no radius compensation at the machine",
                "it goes down along the first round and need not cut at its centre; climb milling at both flanks",
                "zero: centre of the bore, face of the disc with the groove; cam angle 0 along +X, that face up",
                "outside, bore, keyway and holes are not in this program",
                *height_notes(machining, height),
            ]
        ),
        *opening(machining, height),
    ]
    plunge, top = machining.plunge_feed_mm_per_min, 0.0
    for number, level in enumerate(levels, 1):
        start = rounds[0].vertices[0].round(DECIMALS)
        lines += [
            f"(depth {number} of {count})",
            f"G0 {words(X=start[0], Y=start[1])}",
            f"G0 {words(Z=machining.approach_mm)}",
            f"G1 {words(Z=top)} F{plunge:g}",
            *_round(rounds[0], plunge, (top, level)),
        ]
        for one in rounds:
            begin = one.vertices[0].round(DECIMALS)
            if one is not rounds[0]:
                lines.append(f"G1 {words(X=begin[0], Y=begin[1])} F{feed:g}")
            lines += _round(one, feed)
        lines.append(f"G0 {words(Z=height)}")
        top = level
    path.write_text("\n".join([*lines, "M5", "M30"]) + "\n", encoding="ascii", newline="\n")


def _round(centre: Contour, feed: float, down: tuple[float, float] | None = None) -> Iterator[str]:
    """Lines of a whole round, level or as a ramp between two heights."""
    vertices = np.vstack([centre.vertices, centre.vertices[:1]]).round(DECIMALS)
    # The arcs' centres come from the rounded ends, so that both radii of an arc agree.
    chain = Contour(vertices, np.append(centre.bulges, 0.0))
    length = np.linalg.norm(chain.chords, axis=1)[:-1]
    straight = np.abs(centre.bulges) * length / 2 < _STRAIGHT
    to_centre = chain.centers - vertices
    # Only arcs go down, as in a hole that is milled.
    sloped = np.where(straight, 0.0, length)
    reached = np.cumsum(sloped) / sloped.sum()
    speed = f" F{feed:g}"
    for number in range(len(centre.vertices)):
        if length[number] == 0:
            continue
        x, y = vertices[number + 1]
        if straight[number]:
            yield f"G1 {words(X=x, Y=y)}{speed}"
        else:
            z = {} if down is None else {"Z": down[0] + (down[1] - down[0]) * reached[number]}
            turn = "G3" if centre.bulges[number] > 0 else "G2"
            yield f"{turn} {words(X=x, Y=y, **z, I=to_centre[number, 0], J=to_centre[number, 1])}{speed}"
        speed = ""


def read_groove(path: Path, machining: Machining, depth: float, feed: float, step: float) -> tuple[Outline, Outline]:
    """Run the program of a groove and return the flanks that it leaves, the inner one first.

    Args:
        path: program to read.
        machining: cutter, with its greatest feeds and depth.
        depth: depth of the groove, mm.
        feed: greatest feed along the path, mm/min.
        step: distance between the points of the flanks, mm.

    Raises:
        FileError: the program is damaged, cuts too fast or too deep, leaves an open round, or gouges a flank.
    """
    program, wrong = (
        run_program(path, Work(safe=machining.safe_height_mm, helices=True)),
        "{file} {fault}: do not run this program",
    )
    cuts = [move for move in program.moves if move.motion != "G0"]
    lowest = min(float(move.end[2]) for move in cuts)
    if abs(lowest + depth) > 10.0**-DECIMALS:
        raise FileError(wrong, file=path.name, fault=f"cuts to z = {lowest:g} mm, not to {-depth:g}")
    for move in cuts:
        if move.feed > (machining.plunge_feed_mm_per_min if move.plunges else feed) + _LEVEL:
            raise FileError(wrong, file=path.name, fault=f"cuts at {move.feed:g} mm/min in line {move.line}")
    floor = [move for move in cuts if not move.plunges and abs(move.end[2] - lowest) < _LEVEL]
    loops = _loops(floor)
    if not loops:
        raise FileError(wrong, file=path.name, fault="has no closed round at its floor")
    radius = machining.cutter_diameter_mm / 2
    loops.sort(key=lambda loop: max(float(np.hypot(*move.end[:2])) for move in loop))
    flanks = _parallel(loops[0], -radius, step), _parallel(loops[-1], radius, step)
    places = np.concatenate([move.places(step) for move in cuts])
    for flank in flanks:
        nearest = float(np.min(cKDTree(flank.points).query(places)[0]))
        if nearest < radius - _GOUGE:
            raise FileError(wrong, file=path.name, fault=f"cuts {radius - nearest:.4f} mm into a flank")
    return flanks


def _loops(moves: Sequence[Move]) -> list[list[Move]]:
    """Closed rounds among moves at one height; after each but the last a move leads to the next."""
    loops: list[list[Move]] = []
    loop: list[Move] = []
    leads = False
    for move in moves:
        if leads:
            leads = False
            if not move.sweep:
                continue
        loop.append(move)
        if len(loop) > 1 and np.hypot(*(move.end - loop[0].start)[:2]) < _CLOSED:
            loops.append(loop)
            loop, leads = [], True
    return loops


def _parallel(loop: Sequence[Move], distance: float, step: float) -> Outline:
    """Parallel of a round, outside by a distance or inside by a negative one, run counterclockwise."""
    corners: Array = np.array([move.start[:2] for move in loop])
    following = np.roll(corners, -1, axis=0)
    side = float(np.sign(np.sum(corners[:, 0] * following[:, 1] - corners[:, 1] * following[:, 0])))
    points, owner = [], []
    for number, move in enumerate(loop):
        at = move.places(step)
        if len(at) < 5:
            at = move.places(move.length / 5)
        if move.sweep:
            out = (at - move.centre) * np.sign(move.sweep)
        else:
            way = (move.end - move.start)[:2]
            out = np.tile([way[1], -way[0]], (len(at), 1))
        points.append(at + distance * side * out / np.linalg.norm(out, axis=1)[:, None])
        owner.append(np.full(len(at), number))
    every, owners = np.concatenate(points), np.concatenate(owner)
    # Where two moves meet at an angle of rounding, their parallels overlap by nanometres: points go by their angle.
    order = np.argsort(np.arctan2(every[:, 1], every[:, 0]), kind="stable")
    order = np.append(order, order[0])
    return Outline(every[order], owners[order])
