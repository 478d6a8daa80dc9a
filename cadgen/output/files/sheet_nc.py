"""Milling program (G-code) of a sheet part: openings first, then the outline over tabs that hold the part.

The cutter's path runs a radius beside every side: arcs round the outer corners, and inside the half circles that open
the inner ones. Outside it runs clockwise and inside counterclockwise, which is climb milling.
"""

from collections.abc import Iterator, Sequence
from math import atan2, ceil, tan
from pathlib import Path

import numpy as np
import shapely
from scipy.spatial import cKDTree

from cadgen.arrays import Array
from cadgen.car.assembly.panels import Panel
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.contour import Contour
from cadgen.design.machining import Machining, Tabs
from cadgen.errors import DesignError
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.drilling import Hole
from cadgen.output.files.gcode import (
    DECIMALS,
    comments,
    height_notes,
    levels_of,
    opening,
    slot_with_tabs,
    tabs_note,
    words,
)
from cadgen.output.files.gcode_machine import Work, run_program
from cadgen.output.files.hole_milling import LEAST_PATH, hole_lines, turns_of
from cadgen.output.files.nc import assumed_in
from cadgen.output.files.publisher import Artifact, require

_MATERIAL = "train.plate.material or frame.material"  # keys that state it
_SAME_WAY = 1e-9  # rad between two sides that meet without a corner
_FINE = 2e-4  # mm, chords of the polygon that is compared
_OFF_MM = 1e-3  # of the cutter's flank from the part: rounding, chords and steps
_EVERY = 0.02  # mm between the places of the cutter that are compared


def path_beside(contour: Contour, radius: float) -> Contour:
    """Path of a cutter's centre to the right of a contour, which has the material on its left, the other way round.

    Args:
        contour: outline counterclockwise, or opening clockwise, mm.
        radius: radius of the cutter, mm.

    Raises:
        DesignError: an inner corner or hollow is too narrow for the cutter.
    """
    vertices: list[Array] = []
    bulges: list[float] = []
    tangents = [_tangents(contour, number) for number in range(len(contour.bulges))]
    for number, bulge in enumerate(contour.bulges.tolist()):
        start, end = contour.vertices[number], contour.vertices[(number + 1) % len(contour.bulges)]
        first, last = tangents[number]
        follows = tangents[(number + 1) % len(tangents)][0]
        hollow = bulge < 0 and contour.radii[number] < radius
        turn = atan2(last[0] * follows[1] - last[1] * follows[0], float(last @ follows))
        if hollow or turn < -_SAME_WAY:
            raise DesignError(
                "frame.cutter_diameter_mm is {diameter:g}, and a hollow at ({x:.1f}, {y:.1f}) mm is narrower: choose a "
                "smaller cutter",
                diameter=2 * radius,
                x=float(end[0]),
                y=float(end[1]),
            )
        vertices += [start + radius * _right(first)]
        bulges += [bulge]
        if turn > _SAME_WAY:
            vertices.append(end + radius * _right(last))
            bulges.append(tan(turn / 4))
    return Contour(np.array(vertices), np.array(bulges)).reversed()


def _tangents(contour: Contour, number: int) -> tuple[Array, Array]:
    chord, half = contour.chords[number], contour.sweeps[number] / 2
    along = atan2(chord[1], chord[0])
    start, end = along - half, along + half
    return np.array([np.cos(start), np.sin(start)]), np.array([np.cos(end), np.sin(end)])


def _right(way: Array) -> Array:
    return np.array([way[1], -way[0]])


def sheet_program(
    panel: Panel,
    folder: Path,
    stem: str,
    machining: Machining,
    name: str,
    seat: str,
    material: DiscMaterial | None = None,
) -> Artifact:
    """Write the program of a sheet and run it: it must cut the part out and spare it.

    Args:
        panel: sheet.
        folder: folder for the file.
        stem: name of the file without its ending.
        machining: cutter, speeds, heights and tabs.
        name: name of the design, for the first comment.
        seat: class of the seats, which the last pass is to reach.
        material: material of the sheet, for the feed; None if it is not known.

    Raises:
        DesignError: a hollow is too narrow for the cutter, or the tabs have no room.
        FileError: the file cannot be written, or cuts something else when it is run.
    """
    file = folder / f"{stem}.nc"
    lines = _lines(panel, machining, name, seat, material)
    file.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
    return Artifact(file.name, _cut(panel, file, machining) | assumed_in(machining.assumptions(material, _MATERIAL)))


def _lines(panel: Panel, machining: Machining, name: str, seat: str, material: DiscMaterial | None) -> Iterator[str]:
    assumed = machining.assumption(material, _MATERIAL)
    tabs = machining.tabs or Tabs()
    height, levels = machining.safe_height_mm, levels_of(machining, panel.thickness)
    yield from comments(
        [
            *([assumed] if assumed else []),
            f"{name}: {panel.code}, sheet {panel.thickness:g} mm thick",
            f"cutter diameter {machining.cutter_diameter_mm:g} mm, cutting at its centre, no radius compensation",
            "zero: datum of the drawing, upper face of the sheet",
            "fix the sheet on its bed over its whole area: cores of openings come loose",
            f"{tabs_note(tabs)} hold the part at the end; cut and file them off",
            *(
                [f"seats {seat}: measure, and bore or ream the last hundredths"]
                if seat and any(hole.fit for hole in panel.holes)
                else []
            ),
            *([f"{len(panel.edge_holes)} holes in the foot are not in this program"] if panel.edge_holes else []),
            f"the cutter goes {machining.break_through_mm:g} mm below the sheet",
            *height_notes(machining, height),
        ]
    )
    yield from opening(machining, height)
    for hole in panel.holes:
        yield f"(hole {hole.diameter:g} mm)"
        yield from _hole_lines(
            Hole((hole.u, hole.v), 0.0, -panel.thickness), hole.diameter, machining, height, material
        )
    radius = machining.cutter_diameter_mm / 2
    for number, cut in enumerate(panel.cuts, 1):
        yield f"(opening {number})"
        path = path_beside(cut.reversed(), radius)
        yield from _rounds(path, [False] * len(path.bulges), levels, 0.0, machining, material)
    yield "(outline)"
    whole = machining.model_copy(update={"tabs": tabs, "lead_radius_mm": radius})
    slotted = slot_with_tabs(_begun_on_a_line(path_beside(panel.outline, radius)), whole)
    top = tabs.height_mm - panel.thickness
    yield from _rounds(slotted.centre, slotted.lifted.tolist(), levels, top, machining, material)
    yield "M5"
    yield "M30"


def _hole_lines(
    hole: Hole, diameter: float, machining: Machining, height: float, material: DiscMaterial | None
) -> Iterator[str]:
    """Turns of the cutter in a hole, which must be wider than the cutter."""
    cutter = machining.cutter_diameter_mm
    if diameter < cutter + 2 * LEAST_PATH:
        raise DesignError(
            "frame.cutter_diameter_mm is {cutter:g}, too large for a hole of {hole:g} mm: give at most {most:g}",
            cutter=cutter,
            hole=diameter,
            most=diameter - 2 * LEAST_PATH,
        )
    yield from hole_lines(hole, turns_of(hole, diameter, machining, material), machining, height)


def _begun_on_a_line(path: Contour) -> Contour:
    """Path that begins in the middle of its longest straight side."""
    longest = int(np.argmax(np.where(path.bulges == 0, path.lengths, 0.0)))
    vertices, bulges = np.roll(path.vertices, -longest, axis=0), np.roll(path.bulges, -longest)
    middle = (vertices[0] + vertices[1]) / 2
    return Contour(np.vstack([middle, vertices[1:], vertices[:1]]), np.append(bulges, 0.0))


def _rounds(
    path: Contour,
    lifted: Sequence[bool],
    levels: Sequence[float],
    top: float,
    machining: Machining,
    material: DiscMaterial | None,
) -> Iterator[str]:
    """Rounds along a path, one for each level; over the tabs no deeper than their top."""
    vertices = path.vertices.round(DECIMALS)
    rounded = Contour(vertices, path.bulges)
    to_centre, length = rounded.centers - vertices, np.linalg.norm(rounded.chords, axis=1)
    straight = np.abs(rounded.bulges) * length / 2 < 10.0**-DECIMALS / 2
    following = np.roll(vertices, -1, axis=0)
    plunge, feed = f"F{machining.plunge_feed_mm_per_min:g}", f"F{machining.feed(material):g}"
    x, y = vertices[0].tolist()
    yield f"G0 {words(X=x, Y=y)}"
    floor = 0.0
    for level in levels:
        yield f"G0 {words(Z=floor + machining.approach_mm if floor == 0.0 else floor + 0.1)}"
        yield f"G1 {words(Z=level)} {plunge}"
        at = level
        for number in range(len(vertices)):
            over = max(level, top) if lifted[number] else level
            if over != at:
                yield f"G1 {words(Z=over)} {plunge}"
                at = over
            if length[number] == 0:
                continue
            end = words(X=following[number, 0], Y=following[number, 1])
            if straight[number]:
                yield f"G1 {end} {feed}"
            else:
                turn = "G3" if rounded.bulges[number] > 0 else "G2"
                yield f"{turn} {end} {words(I=to_centre[number, 0], J=to_centre[number, 1])} {feed}"
        if at != level:
            yield f"G1 {words(Z=level)} {plunge}"
        floor = level
    yield f"G0 {words(Z=machining.safe_height_mm)}"


def _cut(panel: Panel, file: Path, machining: Machining) -> Facts:
    """Facts on a program that was run: nearest that the cutter's flank comes to the part, and what it leaves uncut."""
    radius = machining.cutter_diameter_mm / 2
    program = run_program(file, Work(safe=machining.safe_height_mm, helices=True))
    cutting = [move for move in program.moves if move.motion != "G0" and min(move.start[2], move.end[2]) < 0]
    # Rounds at other depths take the same way.
    ways = {(*move.start[:2], *move.end[:2], *move.centre, move.sweep): move for move in cutting}
    places = np.concatenate([move.places(_EVERY) for move in ways.values()])
    face = panel.face(chord=_FINE)
    gouge = radius - float(shapely.distance(shapely.points(places), face).min())
    deepest = min(float(move.end[2]) for move in cutting)
    below = -panel.thickness + 1e-9
    through = np.concatenate([move.places(_EVERY) for move in cutting if max(move.start[2], move.end[2]) < below])
    edges = [panel.outline, *panel.openings]
    points = [edge.outline(0.2).points for edge in edges]
    cutter = cKDTree(through)
    away = [np.asarray(cutter.query(each)[0], dtype=float) - radius for each in points]
    tabs = machining.tabs or Tabs()
    held = ceil(tabs.count * (tabs.width_mm + 2 * machining.cutter_diameter_mm) / 0.1)
    left = sum(int(np.count_nonzero(each > 2 * _OFF_MM)) for each in away[1:])
    outside = int(np.count_nonzero(away[0] > 2 * _OFF_MM))
    whole = gouge <= _OFF_MM and left == 0 and outside <= held and deepest < -panel.thickness
    require(whole, file.name, Message("cuts into the part or leaves some of it uncut"))
    return Facts(gouge_mm=gouge, cutter_diameter_mm=machining.cutter_diameter_mm, moves=len(program.moves))
