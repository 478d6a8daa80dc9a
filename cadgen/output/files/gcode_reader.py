"""The outline, the tabs and the holes that programs leave, from their moves alone."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, pi, radians, tan
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.closed import Outline
from cadgen.curves.contour import Contour
from cadgen.design.machining import Drilling, Machining
from cadgen.errors import FileError
from cadgen.messages import Message
from cadgen.output.files.gcode_machine import HALF_DIGIT_MM, Move, Program, RefusedError, Work, run_program
from cadgen.parts.face import Face
from cadgen.parts.features import Hub

_SCALLOP_MM = 3e-5  # ridge between the places of the cutter that stand for its path, which parabolas then take off
_FINE_RAYS = 65  # within a gap between two of them that hides a corner
_CORNER = 0.02  # rad; a hollow of 3 mm turns by as much between two rays on a cam of 70 mm
_BLOCK = 512  # rays looked at together, so that the table of candidates stays in the processor's cache
_TAB_MM = 2e-3  # of the width and height of a tab
_STEP_MM = 0.1  # of the distance between tabs
_LEAD_MM = 1e-2  # of the way to a tab and away from it: rounded ends
_TAB_STEP = 0.05  # mm between the cutter's places beside a tab
_FIT_MM = 1e-9  # of a drill's diameter and a hole's
_LAST_PECK = 1.01  # of a peck, at most, is the last one


@dataclass(frozen=True, eq=False)
class Tab:
    """A bridge of material in the slot, as the program leaves it before it stops.

    Attributes:
        place: its middle, shape (2,), mm.
        along: length of the round up to there, mm.
        width: width where it is narrowest, mm.
        height: height above the disc's lower face, mm.
    """

    place: Array
    along: float
    width: float
    height: float


@dataclass(frozen=True, eq=False)
class Milled:
    """Outline and tabs that a program leaves.

    Attributes:
        outline: outline of the part, one piece.
        tabs: tabs that hold it until the stop; empty without any.
    """

    outline: Outline
    tabs: tuple[Tab, ...]


def read_gcode(
    path: Path,
    machining: Machining,
    thickness: float,
    step: float = 0.06,
    *,
    material: DiscMaterial | None = None,
    hub_height: float = 0.0,
) -> Milled:
    """Run a milling program and return the outline of the part that it leaves, and its tabs.

    At every polar angle the outline is where the ray from the origin first meets a place of the cutter, leads
    and plunges included, so whatever cuts into the part shows.

    Args:
        path: program to read.
        machining: cutter, with its greatest feeds and depth, and the tabs that there must be.
        thickness: thickness of the disc, mm.
        step: distance between the points of the outline, mm.
        material: material of the disc, by which the feed goes; None if none is given.
        hub_height: height of a hub on the outer face, mm.

    Raises:
        FileError: a word that is not understood, an arc whose ends disagree on its radius, a rapid move
            through the stock, a pass too deep, rounds that differ, a part not cut through or not all round, tabs other
            than those of the design, a pass through air where a tab is taken off.
    """
    program = run_program(path, Work(safe=machining.safe_height_mm + hub_height))
    _refuse_tool(path, program, machining)
    try:
        _refuse_feeds(program, machining, material)
        rounds = _MilledRounds.of(program)
        tabs = rounds.tabs(machining, thickness)
        _refuse_tabs(tabs, machining, rounds.length)
        outline = _left_over(rounds.cuts(machining, thickness), machining.cutter_diameter_mm / 2, step)
    except RefusedError as refused:
        raise FileError("{file} {fault}: do not run this program", file=path.name, fault=refused.args[0]) from refused
    return Milled(outline, tabs)


def _refuse_tool(path: Path, program: Program, machining: Machining) -> None:
    number = machining.tool_number
    if program.tool != ("" if number is None else f"T{number}"):
        raise FileError(
            "{file} takes the tool {tool}: write it again",
            file=path.name,
            tool=program.tool or Message("in the spindle"),
        )


def _refuse_feeds(program: Program, machining: Machining, material: DiscMaterial | None) -> None:
    for move in program.moves:
        allowed = machining.plunge_feed_mm_per_min if move.plunges else machining.feed(material)
        if move.motion != "G0" and move.feed > allowed:
            raise RefusedError(
                "cuts at {feed:g} mm/min in line {line}; {allowed:g} is allowed there",
                feed=move.feed,
                line=move.line,
                allowed=allowed,
            )


@dataclass(frozen=True)
class _MilledRounds:
    """Cuts of a program from one rapid move to the next, plunges apart.

    Attributes:
        rounds: cuts sideways of every round.
        plunges: every cut up or down, with the number of its round.
        before_stop: how many rounds there are before the program stops; all of them if it does not.
    """

    rounds: tuple[tuple[Move, ...], ...]
    plunges: tuple[tuple[int, Move], ...]
    before_stop: int

    @classmethod
    def of(cls, program: Program) -> "_MilledRounds":
        rounds: list[list[Move]] = []
        plunges, before_stop, cutting = [], None, False
        for number, move in enumerate(program.moves):
            if before_stop is None and program.stops and number >= program.stops[0]:
                before_stop = len(rounds)
            if move.motion == "G0":
                cutting = False
                continue
            if not cutting:
                rounds.append([])
                cutting = True
            if move.plunges:
                plunges.append((len(rounds) - 1, move))
            else:
                rounds[-1].append(move)
        if len(program.stops) > 1:
            raise RefusedError("stops more than once")
        last = len(rounds) if before_stop is None else before_stop
        return cls(tuple(map(tuple, rounds)), tuple(plunges), last)

    def floors(self, machining: Machining) -> tuple[Array, Array]:
        """Depth of every cut of a round when the program stops, and at its end, Z in mm, shape (n,) each.

        Raises:
            RefusedError: rounds that differ, one that cuts too deep, a pass after the stop that takes nothing off.
        """
        plans = [
            np.array([[*move.start[:2], *move.end[:2], *move.centre, move.sweep] for move in cuts])
            for cuts in self.rounds
        ]
        if not plans:
            raise RefusedError("cuts nothing")
        before = floor = np.zeros(len(plans[0]))
        for number, (plan, cuts) in enumerate(zip(plans, self.rounds, strict=True)):
            after = number >= self.before_stop
            first = int(np.argmax((plans[0] == plan[0]).all(axis=1))) if after else 0  # where the pass begins
            run = slice(first, first + len(plan))
            if not np.array_equal(plans[0][run], plan):
                raise RefusedError("has passes that differ, so the disc's faces would too")
            levels = np.array([move.end[2] for move in cuts])
            deepest = float((floor[run] - levels).max())
            if deepest > machining.step_down_mm + 2 * HALF_DIGIT_MM:
                raise RefusedError(
                    "has a pass {deepest:.4f} mm deep; {allowed:g} mm is allowed",
                    deepest=deepest,
                    allowed=machining.step_down_mm,
                )
            if after:
                _refuse_air(cuts, floor[run] <= levels, machining.lead_radius_mm)
            floor = floor.copy()
            floor[run] = np.minimum(floor[run], levels)
            before = before if after else floor
        return before, floor

    def cuts(self, machining: Machining, thickness: float) -> list[Move]:
        """The cuts of one round and every plunge, after checking that all rounds together reach through."""
        _, floor = self.floors(machining)
        if floor.max() > -thickness:
            raise RefusedError(
                "ends at Z {height:g}, which does not cut through {thickness:g} mm",
                height=floor.max(),
                thickness=thickness,
            )
        return [*self.rounds[0], *(move for _, move in self.plunges)]

    def tabs(self, machining: Machining, thickness: float) -> tuple[Tab, ...]:
        """Tabs that are left when the program stops: runs of cuts that do not reach through by then."""
        if self.before_stop == len(self.rounds):
            return ()
        floor, _ = self.floors(machining)
        high = np.flatnonzero(floor > -thickness)
        if not len(high):
            return ()
        runs = np.split(high, np.flatnonzero(np.diff(high) > 1) + 1)
        cuts, radius = self.rounds[0], machining.cutter_diameter_mm / 2
        # Everything that goes deeper than a tab by the stop: the other cuts of a round, and the plunges.
        deep = [move.places(_TAB_STEP) for move, z in zip(cuts, floor, strict=True) if z <= -thickness]
        deep += [move.end[None, :2] for number, move in self.plunges if number < self.before_stop]
        places = np.concatenate(deep)
        ends = np.append(0.0, np.cumsum([move.length for move in cuts]))
        tabs = []
        for run in runs:
            place = (cuts[run[0]].start[:2] + cuts[run[-1]].end[:2]) / 2
            width = 2 * (np.linalg.norm(places - place, axis=1).min() - radius)
            along = (ends[run[0]] + ends[run[-1] + 1]) / 2
            tabs.append(Tab(place, along, float(width), float(floor[run].max() + thickness)))
        return tuple(tabs)

    @property
    def length(self) -> float:
        """Length of a round between its leads, mm."""
        return sum(move.length for move in self.rounds[0][1:-1])


def _refuse_air(cuts: Sequence[Move], air: NDArray[np.bool_], lead: float) -> None:
    """Refuse a pass after the stop that begins or ends in a tab, or goes farther through air than its leads, mm."""
    if not (air[0] and air[-1]):
        raise RefusedError("goes down or up in a tab, not in the slot beside it")
    way = sum(move.length for move, empty in zip(cuts, air, strict=True) if empty)
    if way > 2 * lead + _LEAD_MM:
        raise RefusedError(
            "cuts {way:.1f} mm of air to take a tab off; {lead:g} mm lead to it and away", way=way, lead=2 * lead
        )


def _refuse_tabs(tabs: tuple[Tab, ...], machining: Machining, length: float) -> None:
    """Refuse tabs other than those of the design: by their number, their steps along the slot (mm), and their sizes."""
    asked = machining.tabs
    if len(tabs) != (asked.count if asked else 0):
        raise RefusedError(
            "leaves {tabs} tabs where the design has {count}", tabs=len(tabs), count=asked.count if asked else 0
        )
    if asked is None:
        return
    steps = np.diff([tab.along for tab in tabs])
    if np.abs(steps - length / asked.count).max() > _STEP_MM:
        raise RefusedError(
            "leaves tabs {least:.2f} to {most:.2f} mm apart, not in equal steps",
            least=steps.min(),
            most=steps.max(),
        )
    for tab in tabs:
        for what, size, right in (("width", tab.width, asked.width_mm), ("height", tab.height, asked.height_mm)):
            if abs(size - right) > _TAB_MM:
                x, y = tab.place
                raise RefusedError(
                    "leaves a tab at X {x:.1f} Y {y:.1f} with a {what} of {size:.3f} mm, not {right:g} mm",
                    x=x,
                    y=y,
                    what=Message(what),
                    size=size,
                    right=right,
                )


@dataclass(frozen=True)
class _CutterSweep:
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
    def of(cls, moves: list[Array], radius: float) -> "_CutterSweep":
        places = np.concatenate(moves)
        distance = np.linalg.norm(places, axis=1)
        if distance.min() <= radius:
            raise RefusedError("cuts away the centre of the part")
        angle = np.arctan2(places[:, 1], places[:, 0])
        # The turn is whole but for what the leads overlap; plunges come back to the begin of a lead.
        if not np.unwrap(angle).min() - angle[0] < -0.9 * TURN:
            raise RefusedError("does not run clockwise round the part, as climb milling does")
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
        angle = np.concatenate([self.angle - TURN, self.angle, self.angle + TURN])
        ray = (ray + pi) % TURN - pi
        first, last = np.searchsorted(angle, ray - reach), np.searchsorted(angle, ray + reach)
        if (first == last).any():
            raise RefusedError("does not cut the part free all round")
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
            raise RefusedError("does not cut the part free all round")
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
    def _centres(self) -> Array:
        """The places, mm, shape (2, n)."""
        return np.asarray(self.distance * np.stack([np.cos(self.angle), np.sin(self.angle)]))


def _left_over(cuts: list[Move], radius: float, step: float) -> Outline:
    """Outline of the stock that is left inside the cutter's sweep, by rays from the origin."""
    swept = _CutterSweep.of([move.places(np.sqrt(8 * _SCALLOP_MM * radius)) for move in cuts], radius)
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
        raise FileError("{file} {fault}: do not run this program", file=path.name, fault=refused.args[0]) from refused


def _floors(moves: Sequence[Move], expected: Sequence[tuple[Array, float, float]], peck: float) -> dict[bytes, Move]:
    """The deepest cut at every place, by its X and Y; refuses cuts sideways and pecks too deep."""
    deepest: dict[bytes, Move] = {}
    for move in moves:
        if move.motion == "G0":
            continue
        if move.sweep or not np.array_equal(move.start[:2], move.end[:2]):
            raise RefusedError("cuts sideways in line {line}", line=move.line)
        key = move.end[:2].tobytes()
        top = min(expected, key=lambda hole: float(np.hypot(*(hole[0] - move.end[:2]))), default=(None, 0.0, 0.0))[1]
        at = deepest[key].end[2] if key in deepest else top
        if at - move.end[2] > _LAST_PECK * peck + 2 * HALF_DIGIT_MM:
            raise RefusedError(
                "drills {depth:.3f} mm at once in line {line}; {peck:g} mm is allowed",
                depth=at - move.end[2],
                line=move.line,
                peck=peck,
            )
        if key not in deepest or move.end[2] < deepest[key].end[2]:
            deepest[key] = move
    return deepest


def _compared(floors: dict[bytes, Move], expected: Sequence[tuple[Array, float, float]], point: float) -> float:
    """Greatest distance between a hole and its place; refuses holes too many, too few, or not through."""
    if len(floors) != len(expected):
        raise RefusedError(
            "drills {count} holes where the disc has {expected} of that diameter",
            count=len(floors),
            expected=len(expected),
        )
    worst = 0.0
    for place, _, bottom in expected:
        ends = [move.end for move in floors.values()]
        off = [float(np.hypot(*(end[:2] - place))) for end in ends]
        nearest = int(np.argmin(off))
        if off[nearest] > 2 * HALF_DIGIT_MM:
            raise RefusedError("has no hole at X {x:.3f} Y {y:.3f}", x=place[0], y=place[1])
        if ends[nearest][2] + point > bottom + HALF_DIGIT_MM:
            raise RefusedError("does not drill through at X {x:.3f} Y {y:.3f}", x=place[0], y=place[1])
        worst = max(worst, off[nearest])
    return worst


@dataclass(frozen=True)
class RoundHole:
    """A round hole that a program must leave.

    Attributes:
        place: its centre, mm.
        diameter: its diameter, mm.
        top: height of the work there, mm.
        bottom: height of the work's lower face there, mm.
    """

    place: tuple[float, float]
    diameter: float
    top: float
    bottom: float


def read_hole_milling(
    path: Path, machining: Machining, holes: Sequence[RoundHole], *, material: DiscMaterial | None, hub: Hub | None
) -> tuple[float, float]:
    """Run a program that mills holes and return the greatest error of their places and of their diameters, mm.

    Args:
        path: program to read.
        machining: cutter, with its greatest feeds and depth, and heights.
        holes: holes that it must leave.
        material: material of the disc, by which the feed goes; None if none is given.
        hub: hub of the disc; None without one.

    Raises:
        FileError: a word that is not understood, a rapid move through the work, a plunge, a cut too deep or too fast, a
            cut beyond a hole, a core that is left, a hole of a wrong size, at a wrong place, or not through.
    """
    above = hub.length if hub and hub.side == Face.OUTER else 0.0
    cutter = machining.cutter_diameter_mm
    work = Work(
        safe=machining.safe_height_mm + max((hole.top for hole in holes), default=0.0),
        hub_radius=(hub.diameter + cutter) / 2 if hub and above else 0.0,
        hub_height=above,
        helices=True,
    )
    program = run_program(path, work)
    _refuse_tool(path, program, machining)
    cuts = [move for move in program.moves if move.motion != "G0"]
    try:
        if program.stops:
            raise RefusedError("stops before its end")
        owners = [_hole_of(move, holes, cutter / 2) for move in cuts]
        errors = []
        for number, hole in enumerate(holes):
            own = [move for move, owner in zip(cuts, owners, strict=True) if owner == number]
            _refuse_depths(own, hole, machining, material)
            errors.append(_milled_errors(own, hole, cutter / 2))
    except RefusedError as refused:
        raise FileError("{file} {fault}: do not run this program", file=path.name, fault=refused.args[0]) from refused
    places, diameters = np.array(errors).T
    return float(places.max()), float(diameters.max())


def _hole_of(move: Move, holes: Sequence[RoundHole], radius: float) -> int:
    """Number of the hole that a cut lies in; refuses one that reaches beyond it."""
    places = move.places(_TAB_STEP)
    beyond = [float(np.linalg.norm(places - hole.place, axis=1).max()) + radius - hole.diameter / 2 for hole in holes]
    nearest = int(np.argmin(beyond))
    if beyond[nearest] > 4 * HALF_DIGIT_MM:
        raise RefusedError("cuts {off:.3f} mm beyond a hole in line {line}", off=beyond[nearest], line=move.line)
    return nearest


def _refuse_depths(cuts: Sequence[Move], hole: RoundHole, machining: Machining, material: DiscMaterial | None) -> None:
    """Refuse plunges, steps down that are too deep, and feeds too fast along a turn or down."""
    floor = hole.top
    for move in cuts:
        down, sideways = float(move.start[2] - move.end[2]), move.length
        if down and not sideways:
            if move.end[2] < hole.top - HALF_DIGIT_MM:
                raise RefusedError("plunges in line {line}", line=move.line)
            allowed = machining.plunge_feed_mm_per_min
        else:
            allowed = machining.feed(material)
            if down:
                allowed = min(allowed, machining.plunge_feed_mm_per_min * float(np.hypot(down, sideways)) / down)
        if move.feed > allowed * (1 + 1e-6):
            raise RefusedError(
                "cuts at {feed:g} mm/min in line {line}; {allowed:g} is allowed there",
                feed=move.feed,
                line=move.line,
                allowed=allowed,
            )
        if floor - move.end[2] > machining.step_down_mm + 2 * HALF_DIGIT_MM:
            raise RefusedError(
                "cuts {depth:.3f} mm deep at once in line {line}; {allowed:g} mm is allowed",
                depth=floor - move.end[2],
                line=move.line,
                allowed=machining.step_down_mm,
            )
        if move.sweep and not down:
            floor = float(move.end[2])


def _milled_errors(cuts: Sequence[Move], hole: RoundHole, radius: float) -> tuple[float, float]:
    """Errors of place and diameter of a hole by the whole turns on its lowest level, mm.

    On every level the widest turn must be the same, so that the wall is straight, and from the middle outwards the
    cutter must leave nothing between two turns.
    """
    x, y = hole.place
    levels: dict[float, list[Move]] = {}
    for move in cuts:
        if abs(move.sweep) > TURN - 1e-9 and move.start[2] == move.end[2]:
            levels.setdefault(float(move.end[2]), []).append(move)
    if not levels or min(levels) > hole.bottom + HALF_DIGIT_MM:
        raise RefusedError("does not mill through at X {x:.3f} Y {y:.3f}", x=x, y=y)
    worst, off = 0.0, 0.0
    for turns in levels.values():
        rings = sorted((float(np.hypot(*(turn.start[:2] - turn.centre))), turn) for turn in turns)
        reaches = [-radius, *(ring for ring, _ in rings)]
        if max(np.diff(reaches), default=0.0) > 2 * radius:
            raise RefusedError("leaves a core at X {x:.3f} Y {y:.3f}", x=x, y=y)
        reach, widest = rings[-1]
        place = float(np.hypot(*(widest.centre - hole.place)))
        found = 2 * (reach + radius)
        if place > 4 * HALF_DIGIT_MM:
            raise RefusedError("has no hole at X {x:.3f} Y {y:.3f}", x=x, y=y)
        if abs(found - hole.diameter) > 4 * HALF_DIGIT_MM:
            raise RefusedError(
                "leaves a hole of {found:.3f} mm at X {x:.3f} Y {y:.3f} instead of {diameter:g}",
                found=found,
                x=x,
                y=y,
                diameter=hole.diameter,
            )
        worst, off = max(worst, abs(found - hole.diameter)), max(off, place)
    return off, worst
