"""Where the parts of a train go: parts on shafts, shafts that keep clear of each other, teeth in phase.

All axes are parallel to z. The wheel of a stage and the pinion of the next one are one part on one shaft. A collar
between them keeps the wheels of neighbouring stages from rubbing, and leaves a stated tool its room. Planets, and the
member of a planetary set that is held, are parts beside the shafts. The stages are stacked along z, and every pair
meshes in a plane of its own. The drive's pinion lies with its hub below the stack, the output's wheel with its hub
above.

Seen along z a stage's line of centres has a direction. Given ones are kept; for the others the train is folded
as tightly as it goes without one body coming closer than the clearance to another on a neighbouring or any
other shaft. Shafts run through the whole stack, from bearing to bearing, with the stack in the middle. Shafts that are
said to end, and those on one axis, as of reverted trains and planetary sets, end at their parts. Given directions may
put two shafts on one axis; directions that are found do not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain, pairwise, product, takewhile
from math import asin, ceil, degrees, floor, pi, radians
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import gauss_nodes
from cadgen.errors import DesignError
from cadgen.gears.stage import Standing, Wheel, holes_of, is_bar, is_ring, rim_diameter
from cadgen.gears.tools import CutBlank
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train
from cadgen.gears.wheel_body import cluster_body, gear_body, with_collar
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.body import Body
from cadgen.parts.features import DFlat, Flats, Keyway

M = TypeVar("M", Body, Blank)

# Gauss-Legendre nodes of a set screw's hole, to either side of the keyway's edge: its integrand is analytic there.
_SCREW_NODES = 40
# Directions tried are this far apart, in rad: finer ones move a shaft by less than 5 % of the centre distance.
DIRECTION_STEP = radians(5.0)
# Least length in mm of the collar between two gears on a shaft that are given none.
COLLAR = 1.0
# Axes nearer than this, in mm, are one.
ONE_AXIS = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Blanks:
    """Features of the gears besides their teeth, on the drive's shaft, the shafts between, and the output's.

    `ending` says for the same three whether the shaft ends at its part, to one side of it or, between, to both.
    `own` are the shafts between that have features of their own: number from 1 at the drive, blank, whether it ends.
    """

    drive: Blank
    intermediate: Blank
    output: Blank
    ending: tuple[bool, bool, bool] = (False, False, False)
    own: tuple[tuple[int, Blank, bool], ...] = ()

    def by_shaft(self, shafts: int) -> tuple[Blank, ...]:
        """Blanks of all shafts, from the drive to the output."""
        own = {number: blank for number, blank, _ in self.own}
        between = (own.get(number, self.intermediate) for number in range(2, shafts))
        return (self.drive, *between, self.output)

    def ends(self, shafts: int) -> tuple[bool, ...]:
        """Whether each of so many shafts ends at its part, from the drive to the output."""
        first, between, last = self.ending
        own = {number: ends for number, _, ends in self.own}
        return (first, *(own.get(number, between) for number in range(2, shafts)), last)

    def places(self, shafts: int) -> tuple[str, ...]:
        """Places of all shafts in the section [train] of a design, from the drive to the output."""
        own = {number: f"shafts.{place}" for place, (number, *_) in enumerate(self.own, 1)}
        return ("drive", *(own.get(number, "intermediate") for number in range(2, shafts)), "output")


@dataclass(frozen=True, slots=True, kw_only=True)
class TrainPart:
    """Part of a train at its place: its own frame turned by `angle` about z (rad) and set at `axis`, `height` (mm).

    `gears` are none, one or two wheels by rising height in the part's own frame, each with a tooth on the x axis if it
    has any. `stages` are the numbers of the stages they belong to, from 1. A `flipped` part is first turned over about
    x. `figures` is the number of its figures among those of its stage's wheels, for a part that stands beside the
    shafts; `shaft` then only counts on, and `turns` and `orbits` are those of `Standing`. `joined_to` names the
    part that a gear cut apart is joined to; empty for any other.
    """

    name: str
    shaft: int
    gears: tuple[Wheel, ...]
    stages: tuple[int, ...]
    blank: Blank
    body: Body
    axis: complex
    angle: float
    height: float
    flipped: bool
    figures: int | None = None
    turns: tuple[float, float] = (0.0, 0.0)
    orbits: bool = False
    joined_to: str = ""

    @property
    def pieces(self) -> tuple[TrainPart, ...]:
        """Part as a shop makes it: both gears by themselves where they are cut apart; the lower one has the collar.

        Each gear has its own frame, with its lower face at 0.
        """
        blank = self.blank
        if not (isinstance(blank, CutBlank) and blank.apart and len(self.gears) == 2):
            return (self,)
        plain = CutBlank(bore_diameter=blank.bore_diameter, key=blank.key, apart=True)
        names = (f"{self.shaft}_wheel", f"{self.shaft}_pinion")
        of_both = zip(names, names[::-1], self.gears, self.stages, (blank, plain), self.starts, strict=True)
        return tuple(
            replace(
                self,
                name=name,
                joined_to=other,
                gears=(gear,),
                stages=(stage,),
                blank=own,
                body=gear_body(gear, own),
                height=self.height + start,
            )
            for name, other, gear, stage, own, start in of_both
        )

    @property
    def beside(self) -> bool:
        """Whether it stands beside the shafts, as a planet does."""
        return self.figures is not None

    def wheel_of(self, stage: int) -> int:
        """Number of its gear among the wheels of a stage, as of `Mating`.

        Args:
            stage: number of the stage, from 1.
        """
        return int(self.shaft > stage) if self.figures is None else self.figures

    @property
    def starts(self) -> tuple[float, ...]:
        """Heights in the part's own frame at which its gears begin, in mm; none without gears."""
        if not self.gears:
            return ()
        return (0.0, self.body.slabs[-1].end - self.gears[-1].width)[: len(self.gears)]

    @property
    def volume(self) -> float:
        """Exact volume, mm³: the prisms' volume less the set screw's hole through the hub's wall.

        Across the hole, at the distance y from its axis, its chord is 2 √(ρ² − y²) long. The wall reaches from the
        bore or the keyway's floor to the hub's circle.
        """
        hub, bore = self.blank.hub, self.blank.bore_diameter / 2
        if hub is None or hub.set_screw is None:
            return self.body.prismatic_volume
        if isinstance(self.blank.key, DFlat | Flats):
            return self.body.prismatic_volume - self.blank.screw_volume()
        key = self.blank.key if isinstance(self.blank.key, Keyway) else None
        outside, hole = hub.diameter / 2, hub.set_screw.diameter / 2

        # y = ρ sin t makes the integrand smooth on either side of the keyway's edge.
        edge = asin(min(key.width / 2 / hole, 1.0)) if key else 0.0
        nodes, weights = gauss_nodes(_SCREW_NODES)
        removed = 0.0
        for start, end in ((0.0, edge), (edge, pi / 2)):
            t = start + (end - start) * (nodes + 1) / 2
            y = hole * np.sin(t)
            inside = bore + key.depth if key and end == edge else np.sqrt(np.maximum(bore**2 - y**2, 0.0))
            chords = 4 * (hole * np.cos(t)) ** 2 * (np.sqrt(outside**2 - y**2) - inside)
            removed += (end - start) / 2 * float(weights @ chords)
        return self.body.prismatic_volume - removed

    @property
    def transform(self) -> NDArray[np.float64]:
        """From the part's frame to the train's, shape (3, 4): turning and shift."""
        c, s, f = np.cos(self.angle), np.sin(self.angle), -1.0 if self.flipped else 1.0
        return np.array([[c, -s * f, 0.0, self.axis.real], [s, c * f, 0.0, self.axis.imag], [0.0, 0.0, f, self.height]])


@dataclass(frozen=True, kw_only=True)
class TrainLayout:
    """A train whose teeth are thinned as they will be cut, and its parts, one per shaft from drive to output.

    Parts that stand beside the shafts follow them. `directions` are those of the stages' lines of centres, in rad.
    """

    train: Train
    parts: tuple[TrainPart, ...]
    directions: tuple[float, ...]

    @cached_property
    def pieces(self) -> TrainLayout:
        """Layout of the parts as a shop makes them: gears that are cut apart are parts by themselves."""
        return replace(self, parts=tuple(piece for part in self.parts for piece in part.pieces))

    @property
    def on_shafts(self) -> tuple[TrainPart, ...]:
        """Parts on the shafts, from the drive to the output."""
        return tuple(part for part in self.parts if not part.beside)

    def places(self, stage: int) -> dict[int, int]:
        """Numbers of the parts that hold the wheels of a stage, by those of the wheels; of equal ones, the first.

        Args:
            stage: number of the stage, from 1.
        """
        found: dict[int, int] = {}
        for number, part in enumerate(self.parts):
            if stage in part.stages:
                found.setdefault(part.wheel_of(stage), number)
        return found

    def wheel_in(self, part: int, stage: int) -> int:
        """Number of the gear of a part that belongs to a stage, from below.

        Args:
            part: number of the part.
            stage: number of the stage, from 1.
        """
        return self.parts[part].stages.index(stage)


@dataclass(frozen=True, slots=True)
class RoundBody:
    """Body of revolution about its shaft that must keep clear of others.

    Attributes:
        name: what it is, for people.
        stage: number of its stage, from 1, of a gear; None of another body.
        radius: radius, mm.
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        inner: radius inside which a ring has room for others, mm; 0 of a solid body.
        ended: heights between which a shaft runs that may end, mm; None of another body.
        place: place in the train of such a shaft.
        bore: diameter of the bores on it, mm.
    """

    name: str
    stage: int | None
    radius: float
    low: float
    high: float
    inner: float = 0.0
    ended: tuple[float, float] | None = None
    place: str = ""
    bore: float = 0.0

    def apart_from(self, other: RoundBody, apart: float) -> float:
        """Gap to a body on another axis, mm; negative where they overlap.

        Args:
            other: the other body.
            apart: distance of the axes, mm.
        """
        beside = apart - self.radius - other.radius
        if self.place and other.place and apart >= ONE_AXIS:
            return beside  # shafts beside each other, whose holes must not meet in a plate
        gap = max(beside, max(self.low, other.low) - min(self.high, other.high))
        for outer, inner in ((self, other), (other, self)):
            if outer.inner:  # a ring, with room within
                gap = max(gap, outer.inner - apart - inner.radius)
        return gap

    def raised(self, by: float) -> RoundBody:
        """The body at another height.

        Args:
            by: height by which it is raised, mm.
        """
        return replace(self, low=self.low + by, high=self.high + by)

    def ending(self) -> RoundBody:
        """Shaft that ends at its part; any other body as it is."""
        return self if self.ended is None else replace(self, low=self.ended[0], high=self.ended[1], ended=None)


def gears_and_hubs(train: Train, blanks: Sequence[Blank], clearance: float) -> list[list[RoundBody]]:
    """Gears and hubs of every shaft, from the drive to the output, at their heights in the train.

    Args:
        train: train of gears.
        blanks: blanks, one for each shaft.
        clearance: least gap between bodies on different shafts, mm.

    Raises:
        DesignError: a gear or blank cannot be made.
    """
    return _gears_and_hubs(*_stacked(train, blanks, clearance), train)


def lay_out(
    train: Train,
    blanks: Blanks | Sequence[Blank],
    directions: Sequence[float | None] | None = None,
    clearance: float = 0.3,
) -> TrainLayout:
    """Parts of a train at their places, the drive's axis at the origin.

    `blanks` are those of the places, or one for each shaft from the drive to the output. `directions` in rad hold
    one entry per stage, None for any; `clearance` in mm. Raises `DesignError` for a gear or blank that cannot be
    made, for bearings nearer together than the stack is high, and where bodies on different shafts collide however
    they are laid out.

    Args:
        train: train of gears.
        blanks: blanks of the places, or one for each shaft from the drive to the output.
        directions: direction of each stage's line of centres, rad, None for any; None for any of all.
        clearance: least gap between bodies on different shafts, mm.
    """
    wanted = tuple(directions or (None,) * len(train.stages))
    shafts = len(train.stages) + 1
    on_shafts = blanks.by_shaft(shafts) if isinstance(blanks, Blanks) else tuple(blanks)
    parts, planes = _stacked(train, on_shafts, clearance)
    stated = blanks if isinstance(blanks, Blanks) else Blanks(drive=Blank(), intermediate=Blank(), output=Blank())
    discs = _discs(parts, planes, train, stated.ends(shafts), stated.places(shafts))
    for number, pair in enumerate(train.stages):
        # Neighbours are as far apart in every direction: what collides there needs no search.
        bodies, others = _turning(discs[number : number + 2], (0j, complex(pair.centre_distance)))
        if collision := _between(bodies, others, pair.centre_distance, clearance):
            raise DesignError(collision)
    past: Message | None = None
    chosen = None
    for way in _clear_ways(train, wanted, discs, clearance):
        past = _past_bar(train, parts[-1], _turning(discs, _axes(train, way)), way, clearance)
        if past is None:
            chosen = way
            break
    if past is not None:
        raise DesignError(past)
    if chosen is None:
        # For the sake of the message: by the directions given, and then in a row, where shafts are furthest apart.
        row = [0.0 if direction is None else direction for direction in wanted]
        fixed = takewhile(lambda direction: direction is not None, (row[0], *wanted[1:]))
        said = (_collision(_axes(train, list(way)), discs, clearance) for way in (row[: len(list(fixed))], row))
        if collision := next(filter(None, said), None):
            raise DesignError(collision)
        raise DesignError(
            "the shafts cannot be laid out with {clearance:g} mm between them in steps of {step:g}°; "
            "give the stages' directions, or a smaller clearance",
            clearance=clearance,
            step=degrees(DIRECTION_STEP),
        )
    placed, beside = [], []
    angle = 0.0
    for number, (part, axis) in enumerate(zip(parts, _axes(train, chosen), strict=True)):
        if number:
            stage, direction = train.stages[number - 1], chosen[number - 1]
            axis += stage.driven_shift(angle, direction)
            angle = stage.driven_angle(angle, direction)
        placed.append(replace(part, axis=axis, angle=angle))
        if number < len(train.stages):
            standing = train.stages[number].standing(angle, chosen[number])
            beside += [(number + 1, each, axis, planes[number]) for each in standing]
    placed += [
        _beside(each, stage, axis, plane, shafts + count) for count, (stage, each, axis, plane) in enumerate(beside, 1)
    ]
    return TrainLayout(train=train, parts=tuple(placed), directions=chosen)


def _beside(each: Standing, stage: int, axis: complex, plane: float, shaft: int) -> TrainPart:
    """Part of a body that stands beside the shafts of a stage, whose driver has its middle at `plane`, mm."""
    try:
        body = gear_body(each.wheel, each.blank)
    except DesignError as error:
        raise DesignError("in stage {number}, {error}", number=stage, error=error.message) from error
    return TrainPart(
        name=f"stage{stage}_{each.name}",
        shaft=shaft,
        gears=(each.wheel,),
        stages=(stage,),
        blank=each.blank,
        body=body,
        axis=axis + each.axis,
        angle=each.angle % (2 * pi),
        height=plane + each.rise - each.wheel.width / 2,
        flipped=False,
        figures=each.figures,
        turns=each.turns,
        orbits=each.orbits,
    )


def collar_length(clearance: float) -> float:
    """Length of a collar where none is stated, mm, between gears as wide as their mates.

    Args:
        clearance: least gap between bodies, mm.
    """
    return max(COLLAR, 2 * clearance)


def _stacked(train: Train, blanks: Sequence[Blank], clearance: float) -> tuple[list[TrainPart], list[float]]:
    """The parts on shafts, all on one axis, at their heights; and the heights of the drivers' middles, mm."""
    stages = train.stages
    first, last = stages[0].wheels[0], stages[-1].wheels[1]
    plane = stages[0].begins
    planes = [plane]

    def part(name: str, shaft: int, gears: tuple[Wheel, ...], blank: Blank, body: Body, height: float) -> TrainPart:
        numbers = (shaft - 1, shaft) if len(gears) == 2 else (max(shaft - 1, 1),)
        return TrainPart(
            name=name,
            shaft=shaft,
            gears=gears,
            stages=numbers,
            blank=blank,
            body=body,
            axis=0j,
            angle=0.0,
            height=height,
            flipped=shaft == 1,
        )

    if isinstance(first, GearForm) and first.double:
        # It is turned over about x, which turns the arrow of a double helix round.
        first = replace(first, helix_angle=-first.helix_angle)
    drive = _made(1, Message("drive"), gear_body, first, blanks[0])
    parts = [part("1_ring" if is_ring(first) else "1_pinion", 1, (first,), blanks[0], drive, plane + first.width / 2)]
    for shaft, (before, after) in enumerate(pairwise(stages), 2):
        lower, upper = before.wheels[1], after.wheels[0]
        if is_bar(lower):
            raise DesignError(
                "stage {number} has {rack}, behind which no stage can follow; make it the last one",
                number=shaft - 1,
                rack=lower.noun,
            )
        if is_ring(lower) or is_ring(upper):
            raise DesignError(
                "{gear} is on shaft {shaft} between two stages, where it cannot be one part with another gear; make "
                "the stage of a ring the last one, or the first one with the ring as its driver, or give a planetary "
                'stage held = "ring"',
                gear=str(lower if is_ring(lower) else upper),
                shaft=shaft,
            )
        # What the gears in mesh with both stand out towards each other comes on top of the collar.
        above, below = before.stands_out[1], after.stands_out[0]
        length = collar_length(clearance) + max(above, 0.0) + max(below, 0.0)
        given = blanks[shaft - 1]
        if isinstance(given, CutBlank) and given.tool and not given.apart:
            length = max(length, given.tool.between(lower, upper))
        blank = _made(shaft, Message("intermediate"), with_collar, given, lower, upper, length, clearance)
        body = _made(shaft, Message("intermediate"), cluster_body, lower, upper, blank)
        start = plane + before.rise - lower.width / 2
        parts.append(part(f"{shaft}_cluster", shaft, (lower, upper), blank, body, start))
        plane = start + body.slabs[-1].end - upper.width / 2
        planes.append(plane)
    shaft = len(stages) + 1
    output = _made(shaft, Message("output"), gear_body, last, blanks[-1])
    height = plane + stages[-1].rise - last.width / 2
    kind = "rack" if is_bar(last) else "carrier" if holes_of(last) else "wheel"
    parts.append(part(f"{shaft}_{kind}", shaft, (last,), blanks[-1], output, height))
    return parts, planes


def _made(shaft: int, place: Message, make: Callable[..., M], *arguments: Wheel | Blank | float) -> M:
    try:
        return make(*arguments)
    except DesignError as error:
        raise DesignError(
            "on shaft {shaft} ({place}), {error}", shaft=shaft, place=place, error=error.message
        ) from error


def _gears_and_hubs(parts: Sequence[TrainPart], planes: Sequence[float], train: Train) -> list[list[RoundBody]]:
    """Gears and hubs on every shaft, and the bodies that stand beside it."""
    on_shafts = [_gears_and_hub(part) for part in parts]
    for number, (stage, plane) in enumerate(zip(train.stages, planes, strict=True), 1):
        on_shafts[number - 1] += [
            RoundBody(
                Message("{body} of stage {number}", body=each.wheel.noun, number=number),
                number,
                abs(each.axis) + rim_diameter(each.wheel) / 2,
                plane + each.rise - each.wheel.width / 2,
                plane + each.rise + each.wheel.width / 2,
            )
            for each in stage.standing(0.0, 0.0)
        ]
    return on_shafts


def _discs(
    parts: Sequence[TrainPart],
    planes: Sequence[float],
    train: Train,
    ending: Sequence[bool],
    places: Sequence[str],
) -> list[list[RoundBody]]:
    """The bodies of revolution on every shaft, at the train's heights: gears, hub and the shaft itself."""
    on_shafts = _gears_and_hubs(parts, planes, train)
    low, high = (
        pick(getattr(disc, end) for on in on_shafts for disc in on) for pick, end in ((min, "low"), (max, "high"))
    )
    for number, pair in enumerate(train.stages, 1):
        if pair.bearing_span < high - low:
            raise DesignError(
                "in stage {number}, the bearing span of {span:g} mm is shorter than the stack of gears, "
                "collars and hubs between the bearings; give at least {least:g} mm",
                number=number,
                span=pair.bearing_span,
                least=ceil((high - low) * 1e3 - 1e-6) / 1e3,
            )
    for part, on, ends, place in zip(parts, on_shafts, ending, places, strict=True):
        if part.blank.bore_diameter:
            stages = {max(part.shaft - 2, 0), min(part.shaft, len(train.stages)) - 1}
            half = max(train.stages[j].bearing_span for j in stages) / 2
            middle = (low + high) / 2
            own = sorted(part.height + (-z if part.flipped else z) for z in (0.0, part.body.slabs[-1].end))
            first, last = part.shaft == 1, part.shaft == len(parts)
            shaft = RoundBody(
                Message("shaft {shaft} itself", shaft=part.shaft),
                None,
                part.blank.shaft_diameter / 2,
                middle - half,
                middle + half,
                ended=(middle - half if first else own[0], middle + half if last else own[1]),
                place=place,
                bore=part.blank.bore_diameter,
            )
            on.append(shaft.ending() if ends else shaft)
    return on_shafts


def _turning(discs: Sequence[Sequence[RoundBody]], axes: Sequence[complex]) -> list[list[RoundBody]]:
    """Bodies on the first shafts: those of two shafts on one axis end at their parts."""
    shared = [
        any(abs(axis - other) < ONE_AXIS for place, other in enumerate(axes) if place != number)
        for number, axis in enumerate(axes)
    ]
    return [[each.ending() if ends else each for each in on] for on, ends in zip(discs, shared, strict=False)]


def _past_bar(
    train: Train, part: TrainPart, discs: Sequence[Sequence[RoundBody]], chosen: Sequence[float], clearance: float
) -> Message | None:
    """First body on another shaft than the pinion's that a rack at the end of the train collides with, in words."""
    wheel, axes = part.gears[0], _axes(train, chosen)
    rack = getattr(wheel, "bar", None)
    if rack is None:
        return None
    stage, pinion, way = train.stages[-1], axes[-2], np.exp(1j * chosen[-1])
    low, high = part.height, part.height + wheel.width
    # The nearest that the teeth come to the pinion's axis.
    front = stage.centre_distance - rack.addendum_factor * rack.normal_module
    for shaft, axis in enumerate(axes[:-2]):
        for body in discs[shaft]:
            place = (axis - pinion) * np.conj(way)
            gap = max(front - place.real - body.radius, abs(place.imag) - body.radius - rack.length / 2)
            gap = max(gap, max(body.low, low) - min(body.high, high))
            if gap < clearance:
                return Message(
                    "{body} and {rack} collide: the gap between them is {gap:.4g} mm, less than the clearance of "
                    "{clearance:g} mm; give the last stage another direction_deg",
                    body=body.name,
                    rack=wheel.noun,
                    gap=float(gap),
                    clearance=clearance,
                )
    return None


def _gears_and_hub(part: TrainPart) -> list[RoundBody]:
    def placed(name: str, stage: int | None, diameter: float, low: float, high: float) -> RoundBody:
        ends = sorted(part.height + (-z if part.flipped else z) for z in (low, high))
        low, high = ends
        return RoundBody(
            Message("{body} on shaft {shaft}", body=name, shaft=part.shaft), stage, diameter / 2, low, high
        )

    bottom, top = part.gears[0], part.gears[-1]
    if is_bar(bottom):  # which `_past_bar` looks at
        return []
    bodies = [placed(bottom.noun, part.stages[0], rim_diameter(bottom), 0.0, bottom.width)]
    if is_ring(bottom):
        bodies = [replace(each, inner=bottom.tip_diameter / 2) for each in bodies]
    end = part.body.slabs[-1].end
    if len(part.gears) == 2:
        bodies.append(placed(top.noun, part.stages[1], top.tip_diameter, end - top.width, end))
    if hub := part.blank.hub:
        bodies.append(placed(Message("the hub"), None, hub.diameter, bottom.width, bottom.width + hub.length))
    return bodies


def _axes(train: Train, directions: Sequence[float]) -> list[complex]:
    steps = [pair.centre_distance * np.exp(1j * angle) for pair, angle in zip(train.stages, directions, strict=False)]
    return [complex(axis) for axis in np.cumsum([0j, *steps])]


def _clear_ways(
    train: Train,
    wanted: tuple[float | None, ...],
    discs: Sequence[Sequence[RoundBody]],
    clearance: float,
    chosen: tuple[float, ...] = (),
) -> Iterator[tuple[float, ...]]:
    """Directions without collision that begin with `chosen`, the tightest fold of each stage first."""
    if _collision(_axes(train, chosen), discs, clearance):
        return
    if len(chosen) == len(wanted):
        yield chosen
        return
    stated = wanted[len(chosen)]
    if stated is not None:
        tried: Sequence[float] = [stated]
    elif not chosen or not train.stages[len(chosen)].centre_distance:
        tried = [0.0]
    else:
        tried = [chosen[-1] + turn for turn in _TURNS]
    for direction in tried:
        if stated is None and train.stages[len(chosen)].centre_distance:
            *others, newest = _axes(train, (*chosen, direction))
            if any(abs(newest - other) < ONE_AXIS for other in others):
                continue
        yield from _clear_ways(train, wanted, discs, clearance, (*chosen, direction))


# From all the way back to straight on, to either side.
_TURNS = list(chain.from_iterable((turn, -turn) for turn in np.arange(pi, -1e-9, -DIRECTION_STEP).tolist()))


def _collision(axes: Sequence[complex], discs: Sequence[Sequence[RoundBody]], clearance: float) -> Message | None:
    """The first collision of the newest shaft that has one, in words; None if there is none."""
    bodies = _turning(discs, axes)
    pairs = ((a, b) for b in range(len(axes) - 1, 0, -1) for a in range(b - 1, -1, -1))
    said = (_between(bodies[a], bodies[b], abs(axes[b] - axes[a]), clearance) for a, b in pairs)
    return next(filter(None, said), None)


def _between(first: Sequence[RoundBody], second: Sequence[RoundBody], apart: float, clearance: float) -> Message | None:
    """The first collision of the bodies on two shafts whose axes are `apart`, in words; None if there is none."""
    for body, other in product(first, second):
        in_mesh = body.stage is not None and body.stage == other.stage
        gap = body.apart_from(other, apart)
        if in_mesh or gap >= clearance:
            continue
        cure = Message("a longer collar") if body.stage and other.stage else Message("smaller bores or hubs")
        for shaft in (body, other):
            thinner = floor(shaft.bore * (1 - (clearance - gap) / shaft.radius) * 10) / 10 if shaft.place else 0.0
            if thinner > 0:
                cure = Message("train.{place}.bore_diameter_mm = {bore:g}", place=shaft.place, bore=thinner)
        for shaft, beside in ((body, other), (other, body)):
            if shaft.ended and shaft.ending().apart_from(beside, apart) >= clearance:
                cure = Message("train.{place}.shaft_ends = true, smaller bores or hubs", place=shaft.place)
        return Message(
            "{body} and {other} collide: at axes {apart:.4g} mm apart the gap between them is {gap:.4g} mm, less than"
            " the clearance of {clearance:g} mm; give {cure}, another order of the stages, or other directions",
            body=body.name,
            other=other.name,
            apart=apart,
            gap=gap,
            clearance=clearance,
            cure=cure,
        )
    return None
