"""An interpreter of milling programs, and the outline that the cutter leaves.

It reads the words of RS274/NGC that a profile needs, refuses programs that a machine would refuse or that would damage
the part, and shares nothing with the writer.
"""

import re
from dataclasses import dataclass, field
from functools import cached_property
from math import atan2, ceil, hypot, nan, pi
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.curves.closed import Outline
from cadgen.design.schema import Machining
from cadgen.errors import FileError

# Controllers compare an arc's radius at both ends; RS274/NGC allows 2 um, and most that came after it more.
RADIUS_MISMATCH_MM = 5e-4
_HALF_DIGIT_MM = 5e-5  # rounding of a coordinate with four decimals
_SCALLOP_MM = 3e-5  # ridge between the places of the cutter that stand for its path, which parabolas then take off
_FINE_RAYS = 65  # within a gap between two of them that hides a corner
_CORNER = 0.02  # rad; a hollow of 3 mm turns by as much between two rays on a cam of 70 mm
_BLOCK = 512  # rays looked at together, so that the table of candidates stays in the processor's cache
_COMMENT = re.compile(r"\([^()]*\)|;.*")
_WORD = re.compile(r"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))")
# Plane XY, mm, absolute, no radius compensation, mm/min, centres relative to the arc's start.
_SETTINGS = {"G17", "G21", "G90", "G40", "G94", "G91.1"}
_MOTIONS = {"G0", "G1", "G2", "G3"}
_VALUES = set("XYZIJFS")


@dataclass(frozen=True)
class Move:
    """One straight or circular move with its feed, in mm and mm/min; `sweep` is counterclockwise, rad."""

    line: int
    motion: str
    start: Array
    end: Array
    centre: Array
    sweep: float
    feed: float

    @property
    def plunges(self) -> bool:
        """Whether the move changes height."""
        return bool(self.start[2] != self.end[2])

    def places(self, step: float) -> Array:
        """The cutter's places along the move in plan, no two further apart than `step` mm, shape (n, 2)."""
        length = hypot(*(self.end - self.start)[:2])
        if self.sweep:
            length = abs(self.sweep) * hypot(*(self.start[:2] - self.centre))
        share = np.linspace(0, 1, int(np.ceil(length / step)) + 1)
        if not self.sweep:
            return np.asarray(self.start[:2] + share[:, None] * (self.end - self.start)[:2])
        x, y = self.start[:2] - self.centre
        c, s = np.cos(share * self.sweep), np.sin(share * self.sweep)
        return np.asarray(self.centre + np.stack([x * c - y * s, x * s + y * c], axis=1))


@dataclass
class _Machine:
    """A controller's state while a program runs."""

    settings: set[str] = field(default_factory=set)
    motion: str = ""
    spindle: bool = False
    feed: float = 0.0
    at: Array = field(default_factory=lambda: np.full(3, nan))
    moves: list[Move] = field(default_factory=list)
    ended: bool = False
    chosen: str = ""
    tool: str = ""

    def run(self, number: int, words: list[tuple[str, str]]) -> None:
        """Run one line."""
        if self.ended:
            raise _RefusedError("stands after the program's end")
        values = {letter: float(text) for letter, text in words if letter in _VALUES}
        codes = [f"{letter}{float(text):g}" for letter, text in words if letter not in _VALUES]
        self.feed = values.get("F", self.feed)
        for code in codes:
            self._set(code, values)
        if values.keys() & set("XYZIJ"):
            self._move(number, values)

    def _set(self, code: str, values: dict[str, float]) -> None:
        if code in _MOTIONS:
            self.motion = code
        elif code in _SETTINGS:
            self.settings.add(code)
        elif code == "M3" and values.get("S", 0.0) > 0:
            self.spindle = True
        elif code in ("M5", "M30"):
            if not self.at[2] > 0:
                raise _RefusedError("stops with the cutter in the stock")
            self.spindle, self.ended = False, code == "M30"
        elif code.startswith("T"):
            self.chosen = code
        elif code == "M6" and self.chosen:
            if self.spindle or self.moves:
                raise _RefusedError("changes the tool after the work has begun")
            self.tool = self.chosen
        else:
            raise _RefusedError(f"has {code}, which is not understood here")

    def _move(self, number: int, values: dict[str, float]) -> None:
        start = self.at
        end = np.array([values.get(letter, old) for letter, old in zip("XYZ", start, strict=True)])
        centre, sweep = start[:2], 0.0
        sideways = bool({"X", "Y"} & values.keys())
        if self.motion == "G0":
            lowest = end[2] if not sideways else min(start[2], end[2])
            if (sideways or not lowest >= start[2]) and not lowest > 0:
                raise _RefusedError(f"moves at rapid speed through the stock, at Z {lowest:g}")
        elif not (self.motion and self.settings == _SETTINGS and self.spindle and self.feed > 0):
            raise _RefusedError(
                f"cuts before {' '.join(sorted(_SETTINGS))}, M3 with a speed, G1-G3 and F are all given"
            )
        elif np.isnan(start).any():
            raise _RefusedError("cuts before X, Y and Z are known")
        elif sideways and start[2] != end[2]:
            raise _RefusedError("cuts sideways and down at once, so no outline can be told from it")
        if self.motion in ("G2", "G3"):
            centre = start[:2] + np.array([values.get("I", 0.0), values.get("J", 0.0)])
            sweep = _sweep(self.motion, start[:2] - centre, end[:2] - centre)
        self.at = end
        self.moves.append(Move(number, self.motion, start, end, centre, sweep, self.feed))


class _RefusedError(Exception):
    """Fault of a line, in words."""


def read_gcode(path: Path, machining: Machining, thickness: float, step: float = 0.06) -> Outline:
    """Run a milling program and return the outline of the part that it leaves, one piece.

    At every polar angle the outline is where the ray from the origin first meets a place of the cutter, leads
    and plunges included, so whatever cuts into the part shows.

    Args:
        path: program to read.
        machining: cutter, with its greatest feeds and depth.
        thickness: thickness of the disc, mm.
        step: distance between the points of the outline, mm.

    Raises:
        FileError: a word that is not understood, an arc whose ends disagree on its radius, a rapid move
            through the stock, a pass too deep, passes that differ, a part not cut through or not all round.
    """
    machine = _Machine()
    for number, line in enumerate(path.read_text(encoding="ascii", errors="replace").splitlines(), start=1):
        text = _COMMENT.sub("", line).replace(" ", "").upper()
        words = _WORD.findall(text)
        try:
            if "".join(letter + value for letter, value in words) != text:
                raise _RefusedError(f'is not made of words: "{line[:60]}"')
            machine.run(number, words)
        except _RefusedError as refused:
            raise FileError(f"{path.name}, line {number}, {refused}: do not run this program") from refused
    if not machine.ended:
        raise FileError(f"{path.name} has no M30 at its end: the file is cut short, write it again")
    number_of_tool = machining.tool_number
    if machine.tool != ("" if number_of_tool is None else f"T{number_of_tool}"):
        raise FileError(f"{path.name} takes the tool {machine.tool or 'in the spindle'}: write it again")
    try:
        return _left_over(_checked_cuts(machine.moves, machining, thickness), machining.cutter_diameter_mm / 2, step)
    except _RefusedError as refused:
        raise FileError(f"{path.name} {refused}: do not run this program") from refused


def _sweep(motion: str, start: Array, end: Array) -> float:
    """Angle of an arc about its centre; equal ends make a full circle."""
    first, last = hypot(*start), hypot(*end)
    if not abs(first - last) <= RADIUS_MISMATCH_MM:
        raise _RefusedError(f"has an arc whose radius is {first:.4f} mm at its start and {last:.4f} mm at its end")
    turned = atan2(end[1], end[0]) - atan2(start[1], start[0])
    return (turned % TURN or TURN) if motion == "G3" else -(-turned % TURN or TURN)


def _checked_cuts(moves: list[Move], machining: Machining, thickness: float) -> list[Move]:
    """The cuts of one pass and every plunge, after checking that the passes are the same and reach through."""
    cuts = [move for move in moves if move.motion != "G0"]
    for move in cuts:
        allowed = machining.plunge_feed_mm_per_min if move.plunges else machining.feed_mm_per_min
        if move.feed > allowed:
            raise _RefusedError(f"cuts at {move.feed:g} mm/min in line {move.line}; {allowed:g} is allowed there")
    levels: dict[float, list[Move]] = {}
    for move in cuts:
        if not move.plunges:
            levels.setdefault(float(move.end[2]), []).append(move)
    floors = np.minimum.accumulate([0.0, *levels])
    deepest_pass = float(-np.diff(floors, append=floors[-1]).min())
    if deepest_pass > machining.step_down_mm + 2 * _HALF_DIGIT_MM:
        raise _RefusedError(f"has a pass {deepest_pass:.4f} mm deep; {machining.step_down_mm:g} mm is allowed")
    if floors[-1] > -thickness:
        raise _RefusedError(f"ends at Z {floors[-1]:g}, which does not cut through {thickness:g} mm")
    passes = [
        np.array([[*move.start[:2], *move.end[:2], *move.centre, move.sweep] for move in level])
        for level in levels.values()
    ]
    if any(not np.array_equal(passes[0], following) for following in passes[1:]):
        raise _RefusedError("has passes that differ, so the disc's faces would too")
    return next(iter(levels.values())) + [move for move in cuts if move.plunges]


@dataclass(frozen=True)
class _Swept:
    """Places that stand for the cutter's path, by polar angle.

    Attributes:
        angle: polar angle of each place, in order, shape (m,), rad.
        distance: distance from the origin, shape (m,), mm.
        beside: numbers of the places before and after each place along its move, shape (2, m); its own number at the
            ends of the move.
        radius: radius of the cutter, mm.
    """

    angle: Array
    distance: Array
    beside: NDArray[np.intp]
    radius: float

    @classmethod
    def of(cls, moves: list[Array], radius: float) -> "_Swept":
        places = np.concatenate(moves)
        distance = np.linalg.norm(places, axis=1)
        if distance.min() <= radius:
            raise _RefusedError("cuts away the centre of the part")
        angle = np.arctan2(places[:, 1], places[:, 0])
        # The turn is whole but for what the leads overlap; plunges come back to the begin of a lead.
        if not np.unwrap(angle).min() - angle[0] < -0.9 * TURN:
            raise _RefusedError("does not run clockwise round the part, as climb milling does")
        order = np.argsort(angle)
        number = np.empty(len(order), dtype=np.intp)
        number[order] = np.arange(len(order))
        ends = np.cumsum([len(move) for move in moves])
        along = np.arange(len(order))
        before, after = along - 1, along + 1
        before[ends - [len(move) for move in moves]] += 1
        after[ends - 1] -= 1
        beside = np.stack([number[before], number[after]])[:, order]
        return cls(angle[order], distance[order], beside, radius)

    def depths(self, ray: Array) -> tuple[Array, Array]:
        """Distance at which rays first meet the cutter, mm, and direction of the cutter's centre from there, rad.

        Between the places the depth is that of a parabola through the three nearest of one move.

        Args:
            ray: polar angles, shape (n,), rad.
        """
        count = len(self.angle)
        reach = np.arcsin(self.radius / self.distance.min())
        angle = self._thrice
        ray = (ray + pi) % TURN - pi
        first, last = np.searchsorted(angle, ray - reach), np.searchsorted(angle, ray + reach)
        if (first == last).any():
            raise _RefusedError("does not cut the part free all round")
        depth, normal = np.empty(len(ray)), np.empty(len(ray))
        for block in np.split(np.arange(len(ray)), range(_BLOCK, len(ray), _BLOCK)):
            index = first[block, None] + np.arange((last - first)[block].max())
            index = np.minimum(index, last[block, None] - 1) % count
            near, aside = self._met(index, ray[block, None])
            best = np.argmin(near, axis=1)
            rows = np.arange(len(block))
            place, nearest = index[rows, best], near[rows, best]
            before, after = (self._met(neighbour, ray[block])[0] for neighbour in self.beside[:, place])
            with np.errstate(invalid="ignore"):
                bend = before - 2 * nearest + after
                fits = np.isfinite(bend) & (bend > 0) & (self.beside[:, place] != place).all(axis=0)
                lower = (after - before) ** 2 / (8 * np.where(fits, bend, 1.0))
            depth[block] = nearest - np.where(fits, lower, 0.0)
            normal[block] = ray[block] + np.arcsin(np.clip(aside[rows, best] / self.radius, -1.0, 1.0))
        if np.isinf(depth).any():
            raise _RefusedError("does not cut the part free all round")
        return depth, normal

    def _met(self, place: NDArray[np.intp], ray: Array) -> tuple[Array, Array]:
        """Distance along a ray to the cutter at a place, infinite if it is not met, and its distance aside, mm."""
        # By products of a few sines: those of all angles between places and rays would take three times as long.
        x, y = self._centres
        c, s = np.cos(ray), np.sin(ray)
        x, y = x[place], y[place]
        along, aside = x * c + y * s, y * c - x * s
        under = self.radius**2 - aside**2
        near = along - np.sqrt(np.maximum(under, 0.0))
        near[(under <= 0) | (along <= 0)] = np.inf
        return near, aside

    @cached_property
    def _thrice(self) -> Array:
        """Polar angles with those before the first and after the last place, which stand again a turn away."""
        return np.concatenate([self.angle - TURN, self.angle, self.angle + TURN])

    @cached_property
    def _centres(self) -> Array:
        """The places, mm, shape (2, n)."""
        return np.asarray(self.distance * np.stack([np.cos(self.angle), np.sin(self.angle)]))


def _left_over(cuts: list[Move], radius: float, step: float) -> Outline:
    """Outline of the stock that is left inside the cutter's sweep, by rays from the origin."""
    swept = _Swept.of([move.places(np.sqrt(8 * _SCALLOP_MM * radius)) for move in cuts], radius)
    count = ceil(TURN * (swept.distance.max() - radius) / step)
    spacing = TURN / count
    ray: Array = spacing * np.arange(count, dtype=np.float64)
    depth, normal = swept.depths(ray)
    # Where the outline turns between two rays stands a corner that both miss: the gap is looked into.
    turn = (np.roll(normal, -1) - normal + pi) % TURN - pi
    gaps = np.flatnonzero(np.abs(turn) > _CORNER)
    runs = []
    closed = np.append(depth, depth[0])  # once: a gap's share is a view of it
    for first, last in zip(np.append(0, gaps + 1), np.append(gaps, count), strict=True):
        runs.append((spacing * np.arange(first, last + 1), closed[first : last + 1]))
        if last < count:
            fine = spacing * np.linspace(last, last + 1, _FINE_RAYS)
            runs.append((fine, swept.depths(fine)[0]))
    angles, depths = (np.concatenate(parts) for parts in zip(*runs, strict=True))
    owner = np.repeat(np.arange(len(runs)), [len(run[0]) for run in runs])
    return Outline(depths[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1), owner)
