"""The holes that a drilling program leaves, from its moves alone, against those of the disc."""

from collections.abc import Sequence
from math import radians, tan
from pathlib import Path

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.contour import Contour
from cadgen.design.machining import Drilling, Machining
from cadgen.errors import FileError
from cadgen.output.files.gcode_machine import HALF_DIGIT_MM, Move, RefusedError, Work, run_program
from cadgen.parts.face import Face
from cadgen.parts.features import Hub

_FIT_MM = 1e-9  # of a drill's diameter and a hole's
_LAST_PECK = 1.01  # of a peck, at most, is the last one


def read_drilling(
    path: Path,
    machining: Machining,
    drilling: Drilling,
    *,
    diameter: float,
    bore: float,
    holes: Sequence[Contour],
    thickness: float,
    hub: Hub | None = None,
) -> float:
    """Run a drilling program and return the greatest distance of a hole from its place, mm.

    Args:
        path: program to read.
        machining: heights.
        drilling: points and pecks of the drills.
        diameter: diameter of the drill, mm.
        bore: diameter of the drill for the bore, mm.
        holes: outlines of the disc's other holes, of which those of the drill's diameter must be there.
        thickness: thickness of the disc, mm.
        hub: hub of the disc; None without one.

    Raises:
        FileError: a word that is not understood, a rapid move through the work, a cut sideways, a peck too deep, a hole
            that is missing, at a wrong place, or not through.
    """
    above = hub.length if hub and hub.side == Face.OUTER else 0.0
    below = hub.length if hub and hub.side == Face.INNER else 0.0
    in_bore = abs(diameter - bore) < _FIT_MM
    highest = above if in_bore else 0.0
    work = Work(
        safe=machining.safe_height_mm + highest,
        hub_radius=(hub.diameter + diameter) / 2 if hub and above else 0.0,
        hub_height=above,
    )
    program = run_program(path, work)
    expected = [(np.zeros(2), above, -thickness - below)] if in_bore else []
    for hole in holes:
        if abs(2 * float(hole.radii[0]) - diameter) < _FIT_MM:
            expected.append((hole.centers[0], 0.0, -thickness))
    try:
        if program.stops:
            raise RefusedError("stops before its end")
        floors = _floors(program.moves, expected, drilling.peck_mm or diameter)
        return _compared(floors, expected, diameter / 2 / tan(radians(drilling.point_angle_deg) / 2))
    except RefusedError as refused:
        raise FileError(f"{path.name} {refused}: do not run this program") from refused


def _floors(moves: Sequence[Move], expected: Sequence[tuple[Array, float, float]], peck: float) -> dict[bytes, Move]:
    """The deepest cut at every place, by its X and Y; refuses cuts sideways and pecks too deep."""
    deepest: dict[bytes, Move] = {}
    for move in moves:
        if move.motion == "G0":
            continue
        if move.sweep or not np.array_equal(move.start[:2], move.end[:2]):
            raise RefusedError(f"cuts sideways in line {move.line}")
        key = move.end[:2].tobytes()
        top = min(expected, key=lambda hole: float(np.hypot(*(hole[0] - move.end[:2]))), default=(None, 0.0, 0.0))[1]
        at = deepest[key].end[2] if key in deepest else top
        if at - move.end[2] > _LAST_PECK * peck + 2 * HALF_DIGIT_MM:
            raise RefusedError(f"drills {at - move.end[2]:.3f} mm at once in line {move.line}; {peck:g} mm is allowed")
        if key not in deepest or move.end[2] < deepest[key].end[2]:
            deepest[key] = move
    return deepest


def _compared(floors: dict[bytes, Move], expected: Sequence[tuple[Array, float, float]], point: float) -> float:
    """Greatest distance between a hole and its place; refuses holes too many, too few, or not through."""
    if len(floors) != len(expected):
        raise RefusedError(f"drills {len(floors)} holes where the disc has {len(expected)} of that diameter")
    worst = 0.0
    for place, _, bottom in expected:
        ends = [move.end for move in floors.values()]
        off = [float(np.hypot(*(end[:2] - place))) for end in ends]
        nearest = int(np.argmin(off))
        if off[nearest] > 2 * HALF_DIGIT_MM:
            raise RefusedError(f"has no hole at X {place[0]:.3f} Y {place[1]:.3f}")
        if ends[nearest][2] + point > bottom + HALF_DIGIT_MM:
            raise RefusedError(f"does not drill through at X {place[0]:.3f} Y {place[1]:.3f}")
        worst = max(worst, off[nearest])
    return worst
