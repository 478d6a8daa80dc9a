"""The milling program (G-code) of a profile: G2 and G3 arcs along the cutter's centre, over tabs that hold the disc."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, degrees
from pathlib import Path
from zlib import crc32

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from cadgen.arrays import Array
from cadgen.cam.cutter import CutterLimit
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.biarc import arcs
from cadgen.curves.closed import ClosedCurve, left_normal, polar_angle
from cadgen.curves.contour import Contour
from cadgen.curves.derived import parallel
from cadgen.design.machining import Machining, Tabs
from cadgen.errors import CheckError, DesignError
from cadgen.parts.face import Face

DECIMALS = 4  # of a coordinate: hobby controllers read as many, and rounding is 0.05 um at most
SETTINGS = "G21 G90 G17 G40 G94 G91.1"  # mm, absolute, plane XY, no compensation, mm/min, centres relative
# An arc that bulges less than the rounding is a line; so none is left whose rounded ends coincide, which a
# controller would take for a full circle.
_STRAIGHT = 10.0**-DECIMALS / 2
_MICRO = "µμ"  # of units, and of no name
# The search for the farthest point: samples of a piece, then of two spans, in rounds down to about 1e-5 mm.
_COARSE, _FINE, _ROUNDS = 1025, 33, 4


def words(**values: float) -> str:
    """Address words with the coordinate's decimals; + 0.0 turns a negative zero positive.

    Args:
        values: coordinates by their letters, mm.
    """
    return " ".join(f"{letter}{round(float(value), DECIMALS) + 0.0:.{DECIMALS}f}" for letter, value in values.items())


def plain(text: str) -> str:
    """Text as it may stand in a comment; a word that loses letters ends with a short number of what it was."""
    text = re.sub(r"[\w-]+", lambda word: _spelled(word[0]), text)
    return re.sub(r"[^ -~]|[()]", "_", text)


def _spelled(word: str) -> str:
    if not any(letter.isalpha() and not letter.isascii() and letter not in _MICRO for letter in word):
        return word
    left = re.sub(r"[^a-zA-Z0-9-]+", "_", word).strip("_")
    return "_".join(filter(None, (left, f"{crc32(word.encode()) & 0xFFFF:04x}")))


def comments(sentences: list[str]) -> list[str]:
    """Each sentence as a comment."""
    return [f"({plain(sentence)})" for sentence in sentences]


def height_notes(machining: Machining, height: float) -> list[str]:
    """Sentences for the shop on the heights of rapid moves.

    Args:
        machining: heights of the mill.
        height: height to which the cutter is lifted, mm.
    """
    return [
        f"the first move lifts the cutter where it stands, to {height:g} mm: be above every clamp there",
        f"rapid moves go down to {machining.approach_mm:g} mm above the work",
    ]


def opening(machining: Machining, height: float) -> list[str]:
    """Lines with which a program begins: settings, tool and spindle, and the cutter lifted.

    Args:
        machining: tool and speed of the mill.
        height: height to which the cutter is lifted, mm.
    """
    return [
        SETTINGS,
        *([] if machining.tool_number is None else [f"T{machining.tool_number} M6"]),
        f"S{machining.spindle_rpm:g} M3",
        f"G0 {words(Z=height)}",
    ]


@dataclass(frozen=True)
class RaisedHub:
    """A hub that stands on the face that is worked on, about the origin.

    Attributes:
        radius: radius of the hub, mm.
        height: height above the face, mm.
    """

    radius: float
    height: float


@dataclass(frozen=True, eq=False)
class Slot:
    """The cutter's path round a disc, cut into sides at the ends of its tabs.

    Attributes:
        centre: path of the cutter's centre, clockwise, mm.
        lifted: whether the cutter passes over a tab on a side, shape (n,).
        tabs: sides along which each tab is taken off, with as much of the slot before and after it as the cutter is led
            in and out elsewhere.
    """

    centre: Contour
    lifted: NDArray[np.bool_]
    tabs: tuple[range, ...] = ()


def cutter_path(curve: ClosedCurve, cutter_radius: float, limit: CutterLimit, tolerance: float) -> Contour:
    """Return the path of a cutter's centre round a profile as arcs, run clockwise.

    It begins at its point farthest from the camshaft. The whole path lies inside the circle through that
    point, so an arc that leaves it outwards along the tangent cannot take the cutter into the disc.

    Args:
        curve: profile, counterclockwise, mm.
        cutter_radius: radius of the cutter, mm.
        limit: largest cutter for the profile, from `cadgen.cam.cutter.largest_cutter`.
        tolerance: greatest distance of the arcs from the exact path, mm.

    Raises:
        CheckError: the cutter is too large for a hollow of the profile, or a corner of it is hollow.
    """
    if limit.point is not None and limit.radius and cutter_radius > limit.radius:
        raise CheckError(
            "machining.cutter_diameter_mm is {diameter:g}, but no cutter of more than "
            "{most:.3f} mm reaches the hollow at polar angle "
            "{angle:.1f} degrees: choose a smaller cutter",
            diameter=2 * cutter_radius,
            most=2 * limit.radius,
            angle=degrees(float(polar_angle(limit.point))) % 360,
        )
    path = parallel(curve, cutter_radius)
    return arcs(path.begun_at(*_farthest(path)), tolerance).reversed()


def write_gcode(
    path: Path,
    centre: Contour,
    machining: Machining,
    thickness: float,
    *,
    name: str,
    material: DiscMaterial | None = None,
    hub: RaisedHub | None = None,
    drilled: Sequence[str] = (),
    notes: Sequence[str] = (),
    face: Face = Face.OUTER,
) -> None:
    """Write the program that mills a disc's outline from outside, in equal passes, by climb milling.

    With a spindle that turns clockwise, the path runs clockwise round the part and so keeps it on its right:
    the teeth enter at full chip and leave at the finished wall. With tabs the program stops once all else is cut.
    What follows takes them off one after the other, so that nothing of them is left on the rim. Each is cut in passes
    along the same path, from a lead before it to a lead after it.

    Args:
        path: file to write.
        centre: path of the cutter's centre, clockwise, from `cutter_path`, mm.
        machining: cutter, speeds and heights, units in the names.
        thickness: thickness of the disc, mm.
        name: name of the design, for the first comment.
        material: material of the disc, for the feed; None if none is given.
        hub: hub on the disc's outer face; rapid moves pass above it.
        drilled: names of the programs that drill its holes.
        notes: further comments for the shop on this outline.
        face: face of the disc that lies up.

    Raises:
        DesignError: the tabs have no room.
    """
    levels = levels_of(machining, thickness)
    passes = len(levels)
    slot = slot_with_tabs(centre, machining)
    height = machining.safe_height_mm + (hub.height if hub else 0.0)
    program = _RoundLines(slot, machining, machining.feed(material), height)
    spindle = f"S{machining.spindle_rpm:g} M3"
    tabs = machining.tabs
    lines = [
        *comments(_head(machining, thickness, height, passes, name, material, hub, drilled, notes, face)),
        SETTINGS,
        *([] if machining.tool_number is None else [f"T{machining.tool_number} M6"]),
        spindle,
        f"G0 {words(Z=height)}",
    ]
    top = 0.0 if tabs is None else tabs.height_mm - thickness
    floor = 0.0
    for number, level in enumerate(levels, 1):
        lines += [f"(pass {number} of {passes})", *program.full_round(floor, level, top)]
        floor = level
    below = [level for level in levels if tabs and level < top]
    if below:
        lines += ["M5", "(clamp the part through its bore, then start again: the tabs are taken off)", "M0", spindle]
    for tab, sides in enumerate(slot.tabs, 1):
        for number, level in enumerate(below, 1):
            lines += [
                f"(tab {tab} of {len(slot.tabs)}, pass {number} of {len(below)})",
                *program.tab_pass(sides, level),
            ]
    lines += ["M5", "M30"]
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")


def zero_note(face: Face) -> str:
    """Sentence on the zero of a disc's programs.

    Args:
        face: face of the disc that lies up.
    """
    return f"zero: centre of the bore, {face} face of the disc; cam angle 0 along +X, {face} face up"


def levels_of(machining: Machining, thickness: float) -> list[float]:
    """Z of each pass through a disc of some thickness, equal steps down, mm.

    Args:
        machining: keys of the mill.
        thickness: thickness of the disc, mm.
    """
    depth = thickness + machining.break_through_mm
    passes = ceil(depth / machining.step_down_mm - 1e-9)
    return [-depth * number / passes for number in range(1, passes + 1)]


def _head(
    machining: Machining,
    thickness: float,
    height: float,
    passes: int,
    name: str,
    material: DiscMaterial | None,
    hub: RaisedHub | None,
    drilled: Sequence[str],
    notes: Sequence[str],
    face: Face,
) -> list[str]:
    """Sentences that the shop reads before it runs the program."""
    tabs = machining.tabs
    above = f", its hub stands {hub.height:g} mm above that face" if hub else ""
    held = f"hold the part by its bore, the last pass of {passes} cuts it free"
    if tabs:
        held = f"clamp the plate outside the outline, {tabs_note(tabs)} hold the part until M0"
    assumed = machining.assumption(material)
    lines = [
        *([assumed] if assumed else []),
        f"{name}: outline of the cam, milled from outside",
        *notes,
        *(f"{word}: {text}" for word, text in (("stock", machining.stock), ("fixture", machining.fixture)) if text),
        f"cutter diameter {machining.cutter_diameter_mm:g} mm, no radius compensation at the machine",
        "climb milling: spindle clockwise, clockwise round the part",
        zero_note(face),
        f"disc {thickness:g} mm thick{above}; {held}",
    ]
    if tabs:
        lines.append(f"at M0 clamp the part through its bore, with nothing above {height:g} mm; then the tabs are cut")
        lines.append("the cutter goes down to a tab in the slot before it, and between tabs above the work")
    if drilled:
        lines.append(f"first, from the same zero: {', '.join(drilled)}; a keyway or flat is in none of the programs")
    else:
        lines.append("bore, keyway and holes are not in this program")
    if machining.feed_mm_per_min is None and material is not None:
        lines.append(
            f"feed for {material}: {machining.feed_per_tooth(material):g} mm a tooth, "
            f"{machining.cutter_teeth or 2} teeth, {machining.spindle_rpm:g} turns a minute"
        )
    return [
        *lines,
        f"the first move lifts the cutter where it stands, to {height:g} mm: be above every clamp at that height",
        f"rapid moves go down to {machining.approach_mm:g} mm above the work: nothing beside the disc above its face",
    ]


class _RoundLines:
    """Lines of the program for rounds of the cutter, and for its passes over a tab."""

    def __init__(self, slot: Slot, machining: Machining, feed: float, height: float) -> None:
        self.machining, self.feed, self.height = machining, feed, height
        self.corners, self.sides = _sides(slot.centre, machining.lead_radius_mm)
        self.lifted = [False, *slot.lifted.tolist(), False]

    def full_round(self, floor: float, level: float, top: float) -> Iterator[str]:
        """A round at a level, over the tabs at their top if that is higher.

        Args:
            floor: depth of the round before, Z in mm; 0 before the first.
            level: Z of the round, mm.
            top: Z of the top of the tabs, mm.
        """
        plunge, approach = f"F{self.machining.plunge_feed_mm_per_min:g}", self.machining.approach_mm
        yield self.corners[0]
        yield f"G0 {words(Z=max(floor, level) + approach)}"
        yield f"G1 {words(Z=level)} {plunge}"
        at, feed = level, f" F{self.feed:g}"
        for line, lifted in zip(self.sides, self.lifted, strict=True):
            over = max(level, top) if lifted else level
            if over != at:
                yield f"G1 {words(Z=over)} {plunge}"
                at, feed = over, f" F{self.feed:g}"
            if line:
                yield line + feed
                feed = ""
        yield f"G0 {words(Z=self.height)}"

    def tab_pass(self, tab: range, level: float) -> Iterator[str]:
        """A pass that takes a tab off at a level: down in the slot before it, and up in the slot after it.

        Args:
            tab: sides of the path along it.
            level: Z of the pass, mm.
        """
        yield self.corners[tab.start + 1]  # the lead-in is the first side of a round
        yield f"G0 {words(Z=self.machining.approach_mm)}"
        # The slot is as wide as the cutter: no rapid move beside the finished flank.
        yield f"G1 {words(Z=level)} F{self.machining.plunge_feed_mm_per_min:g}"
        first, *others = (line for line in self.sides[tab.start + 1 : tab.stop + 1] if line)
        yield f"{first} F{self.feed:g}"
        yield from others
        yield f"G0 {words(Z=self.height)}"


def _sides(centre: Contour, lead: float) -> tuple[list[str], list[str]]:
    """The rapid move to the begin of each side of a round, and its cut; empty if it is shorter than the rounding."""
    start = centre.vertices[:1]
    ahead = centre.curve().pieces[0].jet(np.zeros(1)).velocity
    ahead = lead * ahead / np.linalg.norm(ahead)
    out = lead * left_normal(ahead)
    quarter = np.tan(np.pi / 8)
    # The arcs' centres come from the rounded ends, so that both radii of an arc agree. The last side, from
    # lead-out to lead-in, closes the chain and is not cut.
    vertices = np.vstack([start + out - ahead, centre.vertices, start, start + out + ahead]).round(DECIMALS)
    chain = Contour(vertices, np.concatenate([[quarter], centre.bulges, [quarter, 0.0]]))
    length = np.linalg.norm(chain.chords, axis=1)
    straight = np.abs(chain.bulges) * length / 2 < _STRAIGHT
    to_centre = chain.centers - vertices
    sides = []
    for i in range(len(vertices) - 1):
        end = words(X=vertices[i + 1, 0], Y=vertices[i + 1, 1])
        if not straight[i]:
            turn = "G3" if chain.bulges[i] > 0 else "G2"
            sides.append(f"{turn} {end} {words(I=to_centre[i, 0], J=to_centre[i, 1])}")
        else:
            sides.append(f"G1 {end}" if length[i] > 0 else "")
    return [f"G0 {words(X=x, Y=y)}" for x, y in vertices], sides


def _farthest(curve: ClosedCurve) -> tuple[int, float]:
    """Piece and parameter of the point farthest from the origin."""
    reach = [
        np.linalg.norm(piece.jet(np.linspace(piece.start, piece.stop, _COARSE)).point, axis=1).max()
        for piece in curve.pieces
    ]
    number = int(np.argmax(reach))
    piece = curve.pieces[number]
    t = np.linspace(piece.start, piece.stop, _COARSE)
    for _ in range(_ROUNDS):
        top = int(np.argmax(np.linalg.norm(piece.jet(t).point, axis=1)))
        t = np.linspace(t[max(top - 1, 0)], t[min(top + 1, len(t) - 1)], _FINE)
    return number, float(t[_FINE // 2])


def slot_with_tabs(centre: Contour, machining: Machining) -> Slot:
    """The path with its tabs in equal steps, the first half a step from where the cutter is led in.

    A tab is narrowest in the middle of the slot, where the cutter's places before and after it are its width and a
    diameter apart.

    Raises:
        DesignError: the tabs have no room between each other or beside the leads.
    """
    tabs = machining.tabs
    if tabs is None:
        return Slot(centre, np.zeros(len(centre.bulges), dtype=bool))
    ends = np.append(0.0, np.cumsum(centre.lengths))
    step, apart = ends[-1] / tabs.count, tabs.width_mm + machining.cutter_diameter_mm
    room = 2 * apart + 4 * machining.lead_radius_mm
    if step < room:
        raise DesignError(
            "machining.tabs.count is {count}; tabs {width:g} mm wide, with the cutter and its leads, "
            "need {room:.1f} mm each of the {length:.0f} mm round the disc: lower machining.tabs.count or width_mm",
            count=tabs.count,
            width=tabs.width_mm,
            room=room,
            length=ends[-1],
        )
    spans = [_span(centre, ends, (number + 0.5) * step, apart) for number in range(tabs.count)]
    return _split(centre, ends, np.array(spans), machining.lead_radius_mm)


def tabs_note(tabs: Tabs) -> str:
    """Tabs in words."""
    return f"{tabs.count} tabs {tabs.width_mm:g} mm wide and {tabs.height_mm:g} mm high"


def _span(centre: Contour, ends: Array, middle: float, apart: float) -> tuple[float, float]:
    """Lengths along the path, evenly to either side of `middle`, at which it is `apart` from itself, mm."""

    def point(at: float) -> Array:
        side = int(np.clip(np.searchsorted(ends, at, "right") - 1, 0, len(centre.bulges) - 1))
        place: Array = centre.side(side, np.array([(at - ends[side]) / (ends[side + 1] - ends[side])]))[0]
        return place

    def between(half: float) -> float:
        return float(np.linalg.norm(point(middle + half) - point(middle - half))) - apart

    half = float(brentq(between, apart / 4, min(apart, 0.49 * ends[-1]), xtol=1e-9))
    return middle - half, middle + half


def _split(centre: Contour, ends: Array, spans: Array, lead: float) -> Slot:
    """The path with corners added at both ends of every span, and a lead (mm) before and after it."""
    led = spans + np.array([-lead, lead])
    corners = np.sort(np.concatenate([spans, led], axis=None))
    vertices, bulges, middles = [], [], []
    for number, (start, stop) in enumerate(pairwise(ends)):
        within = corners[(corners > start) & (corners < stop)]
        shares = (np.concatenate([[start], within, [stop]]) - start) / (stop - start)
        vertices.append(centre.side(number, shares[:-1]))
        bulges.append(np.tan(centre.sweeps[number] * np.diff(shares) / 4))
        middles.append(start + (shares[:-1] + shares[1:]) / 2 * (stop - start))
    middle = np.concatenate(middles)
    lifted = np.any((middle[:, None] > spans[:, 0]) & (middle[:, None] < spans[:, 1]), axis=1)
    tabs = tuple(range(*np.searchsorted(middle, ends_of_tab)) for ends_of_tab in led)
    return Slot(Contour(np.concatenate(vertices), np.concatenate(bulges)), lifted, tabs)
