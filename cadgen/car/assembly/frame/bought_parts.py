"""Bought parts of a frame at their places: bearings, screws, spacers, micrometer head, and what guides a weight."""

from collections.abc import Iterator, Sequence
from enum import StrEnum
from typing import NamedTuple

from cadgen.car.assembly.carried import TUBE, TUBE_BORE, Carried
from cadgen.car.assembly.frame.base_plate import BasePlate
from cadgen.car.assembly.frame.fork_block import ForkBlock
from cadgen.car.assembly.frame.frame_ground import FrameGround
from cadgen.car.assembly.frame.standing_sheets import BEFORE
from cadgen.car.assembly.panels import Panel
from cadgen.car.assembly.standard_parts import LENGTHS, bearing_of, screw_length
from cadgen.messages import Message

_THIMBLE, _THIMBLE_LONG = 1.4, 25.0  # diameter of a micrometer's thimble in stems, and its length, mm
_ANVIL = 0.5  # diameter of a micrometer's spindle in stems
_SPACER_HALF = 3.2  # mm, half across the corners of a hexagonal spacer for M3; larger ones in proportion


class BoughtKind(StrEnum):
    """Kinds of bought parts."""

    BEARING = "bearing"
    SCREW = "screw"
    NUT = "nut"
    TUBE = "tube"
    SPACER = "spacer"
    MICROMETER = "micrometer"


class Bought(NamedTuple):
    """Bought part at its place.

    Attributes:
        kind: kind of part.
        code: what it is, such as `ISO 4762 M3 x 12`.
        name: name for people.
        start: middle of its first end, mm.
        way: direction of its axis.
        rounds: diameter, bore and ends along the axis of each round body that makes it up, mm.
        where: where it belongs, for people; empty where its place is drawn.
    """

    kind: BoughtKind
    code: str
    name: str
    start: tuple[float, float, float]
    way: tuple[float, float, float]
    rounds: tuple[tuple[float, float, float, float], ...]
    where: str = ""


def bought_parts(
    ground: FrameGround,
    block: ForkBlock,
    spacers: Sequence[tuple[float, float]],
    base: BasePlate,
    micrometer: Panel | None,
) -> Iterator[Bought]:
    """Bought parts of a frame, one after the other.

    Args:
        ground: places that the frame goes by.
        block: block of the fork.
        spacers: places x and z of the platform's spacers, mm.
        base: base plate with its screws and what it carries.
        micrometer: bracket of the micrometer head; None without one.
    """
    site, sizes = ground.site, ground.sizes
    up = (0.0, -1.0, 0.0)
    every = zip(ground.found.axes, site.bearings, ground.bores, site.ending, strict=True)
    for number, (axis, diameter, bore, ends) in enumerate(every, 1):
        if not diameter or ends:
            continue
        known = bearing_of(bore, diameter)
        width, code = (site.plate, f"{bore:g} x {diameter:g}") if known is None else (known.width, known.designation)
        for z in (ground.found.place.near, ground.found.place.far):
            if number == 1 and z == ground.open_plate:
                continue
            yield Bought(
                BoughtKind.BEARING,
                code,
                Message("ball bearing {code}", code=code),
                (axis.real, axis.imag, _borne(ground, z, width)[0]),
                (0.0, 0.0, 1.0),
                ((diameter, bore, 0.0, width),),
            )
    inwards = 1.0 if site.idle_wheel < site.fork else -1.0
    if site.bearings[0] and not site.ending[0]:
        known = bearing_of(ground.bores[0], site.bearings[0])
        width, code = (site.plate, f"{ground.bores[0]:g} x {site.bearings[0]:g}")
        if known is not None:
            width, code = known.width, known.designation
        face = site.idle_wheel + inwards * (site.wheel_width / 2 + 2 * site.clearance)
        yield Bought(
            BoughtKind.BEARING,
            code,
            Message("ball bearing {code}", code=code),
            (ground.axle.real, ground.axle.imag, face if inwards > 0 else face - width),
            (0.0, 0.0, 1.0),
            ((site.bearings[0], ground.bores[0], 0.0, width),),
        )
    bearing, screw = block.bearing, sizes.screw
    under = ground.top - ground.spacer - sizes.base  # y of the platform's upper face
    for y in (under, under - block.height + bearing.width):
        yield Bought(
            BoughtKind.BEARING,
            bearing.designation,
            Message("ball bearing {code}", code=bearing.designation),
            (site.base_radius, y, site.fork),
            up,
            ((bearing.diameter, bearing.bore, 0.0, bearing.width),),
        )
    middle, below = site.base_radius, ground.top + sizes.base
    through = screw_length(sizes.base + min(screw.least_length, ground.spacer / 2))
    if through - sizes.base > ground.spacer / 2:
        through = max((each for each in LENGTHS if each - sizes.base <= ground.spacer / 2), default=LENGTHS[0])
    foot, standing = (
        Message("from below into the feet of plates and brackets"),
        Message("into both ends of the spacers"),
    )
    places = [(x, below, z, ground.screw_length, up, foot) for x, z in base.screws]
    places += [(x, below, z, float(through), up, standing) for x, z in spacers]
    places += [(x, under, z, float(through), (0.0, 1.0, 0.0), standing) for x, z in spacers]
    own, of_block = screw_length(sizes.base + screw.least_length), Message("from below into the block of the fork")
    places += [(middle + at, under + sizes.base, site.fork, own, up, of_block) for at in block.threads]
    for x, y, z, long, way, where in places:
        code = f"ISO 4762 {screw.thread} x {long:g}"
        rounds = ((screw.head_diameter, 0.0, -screw.head_height, 0.0), (screw.diameter, 0.0, 0.0, long))
        name = Message("socket head screw {code}", code=code)
        yield Bought(BoughtKind.SCREW, code, name, (x, y, z), way, rounds, where)
    for x, z in spacers:
        code = f"{screw.thread} x {ground.spacer:g}"
        spacer = ((2 * _SPACER_HALF * screw.diameter / 3.0, screw.diameter, 0.0, ground.spacer),)
        yield Bought(
            BoughtKind.SPACER,
            code,
            Message("hexagonal spacer {code}, threads at both ends", code=code),
            (x, ground.top, z),
            up,
            spacer,
        )
    yield from _of_the_drive(ground, base.carried)
    if micrometer is not None:
        yield _micrometer_head(ground, micrometer)
    if not sizes.tapped:
        for x, z in base.screws:
            code = f"ISO 4032 {screw.thread}"
            nut = ((screw.nut_width, screw.diameter, 0.0, screw.nut_height),)
            yield Bought(
                BoughtKind.NUT,
                code,
                Message("nut {code}", code=code),
                (x, ground.top - sizes.wall, z),
                up,
                nut,
                Message("in the slots of plates and brackets"),
            )


def _micrometer_head(ground: FrameGround, bracket: Panel) -> Bought:
    """Micrometer head in its bracket, whose spindle meets the platform in the middle of its way."""
    stem, reach = ground.sizes.stem, ground.sizes.travel / 2 + BEFORE
    thick = bracket.thickness
    start = (float(bracket.place.shift[0]) + thick, -bracket.holes[0].v, ground.site.fork)
    code = f"Ø{stem:g} x 13"
    rounds = (
        (_THIMBLE * stem, 0.0, -_THIMBLE_LONG, 0.0),
        (stem, 0.0, 0.0, thick),
        (_ANVIL * stem, 0.0, thick, thick + reach),
    )
    name = Message("micrometer head, {code}", code=code)
    return Bought(BoughtKind.MICROMETER, code, name, start, (-1.0, 0.0, 0.0), rounds)


def _of_the_drive(ground: FrameGround, carried: Carried | None) -> Iterator[Bought]:
    """Tubes, threaded rods and nuts of a weight's guide, or screws of a motor."""
    sizes, up = ground.sizes, (0.0, -1.0, 0.0)
    if carried is None:
        return
    screw, under = sizes.screw, ground.top + sizes.base
    for x, z in carried.corners(sizes.drive):
        if carried.top is None:
            long = screw_length(sizes.base + screw.least_length)
            code = f"ISO 4762 {screw.thread} x {long:g}"
            rounds = ((screw.head_diameter, 0.0, -screw.head_height, 0.0), (screw.diameter, 0.0, 0.0, long))
            name = Message("socket head screw {code}", code=code)
            where = Message("from below through the base into the motor")
            yield Bought(BoughtKind.SCREW, code, name, (x, under, z), up, rounds, where)
            continue
        code = f"{TUBE:g} x {(TUBE - TUBE_BORE) / 2:g} x {carried.tubes:g}"
        tube = ((TUBE, TUBE_BORE, 0.0, carried.tubes),)
        yield Bought(BoughtKind.TUBE, code, Message("tube {code}", code=code), (x, ground.top, z), up, tube)
        long = carried.tubes + 2 * sizes.base + 2 * screw.head_height
        code = f"DIN 976 {screw.thread} x {long:g}"
        rod = ((screw.diameter, 0.0, -screw.head_height, long - screw.head_height),)
        where = Message("through the tubes, from under the base to over the top plate")
        yield Bought(BoughtKind.SCREW, code, Message("threaded rod {code}", code=code), (x, under, z), up, rod, where)
        code = f"ISO 4032 {screw.thread}"
        nut = ((screw.nut_width, screw.diameter, 0.0, screw.nut_height),)
        where = Message("on the threaded rods, under the base and over the top plate")
        for y, way in ((under, (0.0, 1.0, 0.0)), (ground.top - carried.tubes - sizes.base, up)):
            yield Bought(BoughtKind.NUT, code, Message("nut {code}", code=code), (x, y, z), way, nut, where)
    if carried.top is None:
        return
    # The pulley's bracket stands on the top plate, its screws from below.
    under_top = ground.top - carried.tubes
    for hole in carried.bracket_holes:
        long = screw_length(2 * sizes.base + screw.nut_height)
        at = (-hole.u, under_top, -hole.v)
        code, where = (
            f"ISO 4762 {screw.thread} x {long:g}",
            Message("from below through the top plate into the pulley's bracket"),
        )
        rounds = ((screw.head_diameter, 0.0, -screw.head_height, 0.0), (screw.diameter, 0.0, 0.0, long))
        yield Bought(BoughtKind.SCREW, code, Message("socket head screw {code}", code=code), at, up, rounds, where)
        code, where = f"ISO 4032 {screw.thread}", Message("on the pulley's bracket")
        nut = ((screw.nut_width, screw.diameter, 0.0, screw.nut_height),)
        place = (at[0], under_top - 2 * sizes.base, at[2])
        yield Bought(BoughtKind.NUT, code, Message("nut {code}", code=code), place, up, nut, where)


def _borne(ground: FrameGround, plate: float, width: float) -> tuple[float, float]:
    """Ends of a bearing in the plate whose middle is at a height: flush with the face that looks to the train."""
    half, low_one = ground.site.plate / 2, plate < (ground.found.place.near + ground.found.place.far) / 2
    return (plate + half - width, plate + half) if low_one else (plate - half, plate - half + width)
