"""An interpreter of programs for a mill: it reads the words of RS274/NGC that a disc needs.

It refuses what a machine would refuse, and rapid moves through the work; it shares nothing with the writer.
"""

import re
from dataclasses import dataclass, field
from math import atan2, hypot, nan
from pathlib import Path

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.errors import FileError
from cadgen.messages import Message

# Controllers compare an arc's radius at both ends; RS274/NGC allows 2 um, and most that came after it more.
RADIUS_MISMATCH_MM = 5e-4
HALF_DIGIT_MM = 5e-5  # rounding of a coordinate with four decimals
_COMMENT = re.compile(r"\([^()]*\)|;.*")
_WORD = re.compile(r"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))")
# Plane XY, mm, absolute, no radius compensation, mm/min, centres relative to the arc's start.
_SETTINGS = {"G17", "G21", "G90", "G40", "G94", "G91.1"}
_MOTIONS = {"G0", "G1", "G2", "G3"}
_VALUES = set("XYZIJFS")


class RefusedError(Exception):
    """Fault of a line or of a program, in words.

    Args:
        text: words after the name of the file or the number of the line, or their template.
        arguments: values of the template's fields.
    """

    def __init__(self, text: str, /, **arguments: object) -> None:
        super().__init__(Message(text, **arguments))


@dataclass(frozen=True)
class Work:
    """Obstacles to rapid moves, above the face at Z = 0.

    Attributes:
        safe: least height of rapid moves sideways, mm; a hub and every clamp end below it.
        hub_radius: radius of a hub about the origin with the tool's own radius, mm; 0 without a hub.
        hub_height: height of the hub above the face, mm.
        helices: whether arcs may go down, as they do in holes; of an outline they would tell nothing.
    """

    safe: float
    hub_radius: float = 0.0
    hub_height: float = 0.0
    helices: bool = False

    def top(self, place: Array) -> float:
        """Height of the work under the tool, mm.

        Args:
            place: place of the tool, shape (2,), mm.
        """
        return self.hub_height if hypot(*place) < self.hub_radius else 0.0


@dataclass(frozen=True)
class Move:
    """A straight or circular move with its feed, in mm and mm/min; `sweep` is counterclockwise, rad."""

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

    @property
    def length(self) -> float:
        """Length in plan, mm."""
        if self.sweep:
            return abs(self.sweep) * hypot(*(self.start[:2] - self.centre))
        return hypot(*(self.end - self.start)[:2])

    def places(self, step: float) -> Array:
        """The cutter's places along the move in plan, no two further apart than `step` mm, shape (n, 2).

        Args:
            step: greatest distance of two places, mm.
        """
        share = np.linspace(0, 1, int(np.ceil(self.length / step)) + 1)
        if not self.sweep:
            return np.asarray(self.start[:2] + share[:, None] * (self.end - self.start)[:2])
        x, y = self.start[:2] - self.centre
        c, s = np.cos(share * self.sweep), np.sin(share * self.sweep)
        return np.asarray(self.centre + np.stack([x * c - y * s, x * s + y * c], axis=1))


@dataclass
class _Machine:
    """A controller's state while a program runs.

    `holes` has the depth of every place that a tool was fed down at, by its X and Y; `stops` the number of moves before
    each stop.
    """

    work: Work
    settings: set[str] = field(default_factory=set)
    motion: str = ""
    spindle: bool = False
    feed: float = 0.0
    at: Array = field(default_factory=lambda: np.full(3, nan))
    moves: list[Move] = field(default_factory=list)
    holes: dict[tuple[float, float], float] = field(default_factory=dict)
    stops: list[int] = field(default_factory=list)
    ended: bool = False
    chosen: str = ""
    tool: str = ""

    def run(self, number: int, words: list[tuple[str, str]]) -> None:
        """Run one line."""
        if self.ended:
            raise RefusedError("stands after the program's end")
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
        elif code == "M0":
            if self.spindle or not self.at[2] > 0:
                raise RefusedError("stops for a clamp with the spindle on or the cutter in the stock")
            self.stops.append(len(self.moves))
        elif code in ("M5", "M30"):
            if not self.at[2] > 0:
                raise RefusedError("stops with the cutter in the stock")
            self.spindle, self.ended = False, code == "M30"
        elif code.startswith("T"):
            self.chosen = code
        elif code == "M6" and self.chosen:
            if self.spindle or self.moves:
                raise RefusedError("changes the tool after the work has begun")
            self.tool = self.chosen
        else:
            raise RefusedError("has {code}, which is not understood here", code=code)

    def _move(self, number: int, values: dict[str, float]) -> None:
        start = self.at
        end = np.array([values.get(letter, old) for letter, old in zip("XYZ", start, strict=True)])
        centre, sweep = start[:2], 0.0
        sideways = bool({"X", "Y"} & values.keys())
        if self.motion == "G0":
            self._rapid(start, end, sideways=sideways)
        elif not (self.motion and self.settings == _SETTINGS and self.spindle and self.feed > 0):
            raise RefusedError(
                "cuts before {settings}, M3 with a speed, G1-G3 and F are all given",
                settings=" ".join(sorted(_SETTINGS)),
            )
        elif np.isnan(start).any():
            raise RefusedError("cuts before X, Y and Z are known")
        elif sideways and start[2] != end[2] and not (self.work.helices and self.motion in ("G2", "G3")):
            raise RefusedError("cuts sideways and down at once, so no outline can be told from it")
        if self.motion in ("G2", "G3"):
            centre = start[:2] + np.array([values.get("I", 0.0), values.get("J", 0.0)])
            sweep = _sweep(self.motion, start[:2] - centre, end[:2] - centre)
        if self.motion == "G1" and not sideways:
            self.holes[end[0], end[1]] = min(end[2], self.holes.get((end[0], end[1]), np.inf))
        self.at = end
        self.moves.append(Move(number, self.motion, start, end, centre, sweep, self.feed))

    def _rapid(self, start: Array, end: Array, *, sideways: bool) -> None:
        """Refuse a rapid move through the work: sideways below the safe height, or down to more than was cut there."""
        lowest = end[2] if not sideways else min(start[2], end[2])
        if sideways and not lowest > 0:
            raise RefusedError("moves at rapid speed through the stock, at Z {height:g}", height=lowest)
        if sideways and lowest < self.work.safe - HALF_DIGIT_MM:
            raise RefusedError(
                "moves sideways at rapid speed at Z {height:g}, below the safe height of {safe:g} mm",
                height=lowest,
                safe=self.work.safe,
            )
        down = not end[2] >= start[2]
        if down and not np.isnan(end[:2]).any():
            # A rapid move may end above the work, or above the floor of a hole that was cut there before.
            floor = min(self.work.top(end[:2]), self.holes.get((end[0], end[1]), np.inf))
            if not end[2] > floor:
                raise RefusedError("moves at rapid speed through the stock, at Z {height:g}", height=end[2])
        elif down and not end[2] > 0:
            raise RefusedError("moves at rapid speed through the stock, at Z {height:g}", height=end[2])


@dataclass(frozen=True)
class Program:
    """Moves of a whole program.

    Attributes:
        moves: every move in order.
        stops: number of moves before each stop (M0).
        tool: tool that it takes, such as `T3`; empty for the one in the spindle.
    """

    moves: tuple[Move, ...]
    stops: tuple[int, ...]
    tool: str


def run_program(path: Path, work: Work) -> Program:
    """Run a program to its end.

    Args:
        path: program to read.
        work: what stands in the way of rapid moves.

    Raises:
        FileError: a word that is not understood, an arc whose ends disagree on its radius, a rapid move through the
            work, a program without an end.
    """
    machine = _Machine(work)
    for number, line in enumerate(path.read_text(encoding="ascii", errors="replace").splitlines(), start=1):
        text = _COMMENT.sub("", line).replace(" ", "").upper()
        words = _WORD.findall(text)
        try:
            if "".join(letter + value for letter, value in words) != text:
                raise RefusedError('is not made of words: "{line}"', line=line[:60])
            machine.run(number, words)
        except RefusedError as refused:
            raise FileError(
                "{file}, line {number}, {fault}: do not run this program",
                file=path.name,
                number=number,
                fault=refused.args[0],
            ) from refused
    if not machine.ended:
        raise FileError("{file} has no M30 at its end: the file is cut short, write it again", file=path.name)
    return Program(tuple(machine.moves), tuple(machine.stops), machine.tool)


def _sweep(motion: str, start: Array, end: Array) -> float:
    """Angle of an arc about its centre; equal ends make a full circle."""
    first, last = hypot(*start), hypot(*end)
    if not abs(first - last) <= RADIUS_MISMATCH_MM:
        raise RefusedError(
            "has an arc whose radius is {first:.4f} mm at its start and {last:.4f} mm at its end",
            first=first,
            last=last,
        )
    turned = atan2(end[1], end[0]) - atan2(start[1], start[0])
    return (turned % TURN or TURN) if motion == "G3" else -(-turned % TURN or TURN)
