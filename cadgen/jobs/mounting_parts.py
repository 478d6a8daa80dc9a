"""Parts that mounting needs besides those with sheets: collars, sleeves, spring, brake, adhesive, grease, and a drive.

A disc that is neither glued nor pinned is held between a sleeve on the bearing beside it and a set collar. The idle
wheel runs between a sleeve on its bearing and a set collar at the end of the axle. The rod's spring is a leg spring on
the journal over the head of the fork; its sizes follow from its torque (EN 13906-3).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi

from cadgen.car.assembly.car_parts import Block, CarPart, GroupKind, MovingGroup, Supply, along, at, turned_round
from cadgen.car.assembly.fork_sizes import HEAD_HALF, JOURNAL, SPINDLE, WHEEL_HUB
from cadgen.car.assembly.site import CarSite, StackPlace
from cadgen.car.assembly.standard_parts import bearing_of, set_collar
from cadgen.car.running.friction import DiscMaterial
from cadgen.design.blank import ShaftJoint
from cadgen.design.play import Braked
from cadgen.design.schema import Design
from cadgen.jobs.cam.cam_plan import DENSITY
from cadgen.messages import Message

_STEEL = DENSITY[DiscMaterial.STEEL] * 1e-3  # g/mm³
_SLEEVE = 1.5  # mm by which a sleeve is wider than its shaft: it meets the inner ring of a bearing and not its shield
_SLACK = 0.1  # mm of play of the idle wheel along the axle
_WIRES = (0.3, 0.4, 0.5, 0.63, 0.8, 1.0, 1.25, 1.6, 2.0, 2.5, 3.2)  # mm, of springs
_STRESS = 1000.0  # N/mm² in bending, which spring wire of these sizes bears
_ROUND_JOURNAL = 1.0  # mm by which a spring is wider than its journal
_FELT = 10.0  # mm, sides of a piece of felt
_DARK, _BRASS = (0.30, 0.31, 0.34), (0.80, 0.68, 0.34)


@dataclass(frozen=True, kw_only=True, eq=False)
class Mounted:
    """Places and sizes that mounting parts go by.

    Attributes:
        design: design of the car.
        site: what stands in the car.
        place: place of the train along its shafts.
        axle: group of the rear axle.
        camshaft: group of the camshaft.
        fork: group of the fork.
        bores: diameters of rear axle and camshaft, mm.
        disc: heights of the disc with its hub, mm.
        joint: joint of the disc and its shaft; None where the design states none.
        screwed: whether the disc's hub has a set screw.
    """

    design: Design
    site: CarSite
    place: StackPlace
    axle: MovingGroup
    camshaft: MovingGroup
    fork: MovingGroup
    bores: tuple[float, float]
    disc: tuple[float, float]
    joint: ShaftJoint | None
    screwed: bool

    @property
    def clamped(self) -> bool:
        """Whether the disc is held between a sleeve and a set collar."""
        return not self.screwed and self.joint not in (ShaftJoint.GLUED, ShaftJoint.PINNED)

    @property
    def idle_side(self) -> int:
        """Side on which the idle wheel stands: -1 to the right, 1 to the left."""
        return -1 if self.site.idle_wheel < self.site.drive_wheel else 1


def collar_room(bore: float) -> float:
    """Length of the rear axle that the idle wheel's set collar takes beyond the hub, mm.

    Args:
        bore: diameter of the axle, mm.
    """
    return _SLACK + set_collar(bore).width


def mounting_parts(car: Mounted) -> Iterator[CarPart]:
    """Parts that mounting needs besides those with sheets.

    Args:
        car: places and sizes that they go by.
    """
    yield from _disc_holders(car)
    yield from _idle_holders(car)
    yield _spring(car)
    yield from _supplies(car)


def _disc_holders(car: Mounted) -> Iterator[CarPart]:
    """Sleeve and set collar that hold the disc along the camshaft."""
    if not car.clamped:
        return
    site, towards, bore = car.site, car.place.towards, car.bores[1]
    (low, high), known = car.disc, bearing_of(bore, site.bearings[-1])
    if known is not None and not site.ending[-1]:
        # The bearing is flush with the plate's inner face in a frame, and in the middle of the plate without one.
        inner = site.plate / 2 if car.design.frame is not None else known.width / 2
        face = car.place.near + towards * (inner - known.width)
        ends = (face, low) if towards < 0 else (high, face)
        yield _ring(
            "sleeve-disc",
            Message("sleeve between bearing and disc"),
            (bore, bore + _SLEEVE),
            ends,
            car.camshaft,
            shaft=car.camshaft.number,
            how=Message("against the inner ring of the bearing"),
        )
    yield _collar(
        "collar-disc",
        Message("set collar, clamp of the disc"),
        bore,
        (high, 1) if towards < 0 else (low, -1),
        car.camshaft,
        shaft=car.camshaft.number,
        how=Message("pressed on the disc while its screw is tightened"),
    )


def _idle_holders(car: Mounted) -> Iterator[CarPart]:
    """Sleeve and set collars between which the idle wheel runs."""
    site, side, bore = car.site, car.idle_side, car.bores[0]
    half = site.wheel_width / 2
    inner, outer = site.idle_wheel - side * half, site.idle_wheel + side * (half + WHEEL_HUB + _SLACK)
    if car.design.frame is not None:
        ends = sorted((inner, inner - side * 2 * site.clearance))
        yield _ring(
            "sleeve-idle",
            Message("sleeve between bearing and idle wheel"),
            (bore, bore + _SLEEVE),
            (ends[0], ends[1]),
            car.axle,
            shaft=1,
            how=Message("against the inner ring of the bearing"),
        )
    else:
        yield _collar(
            "collar-idle-inside",
            Message("set collar inside the idle wheel"),
            bore,
            (inner, -side),
            car.axle,
            shaft=1,
            how=Message("screw tightened"),
        )
    yield _collar(
        "collar-idle",
        Message("set collar of the idle wheel"),
        bore,
        (outer, side),
        car.axle,
        shaft=1,
        how=Message("leaves the wheel {slack:g} mm of play", slack=_SLACK),
    )


def _collar(
    code: str,
    title: Message,
    bore: float,
    face: tuple[float, float],
    group: MovingGroup,
    *,
    shaft: int,
    how: Message,
) -> CarPart:
    """Set collar on a shaft from a face on, whose place along the shaft and sense away from it are `face`."""
    collar, (at, sense) = set_collar(bore), face
    low, high = sorted((at, at + sense * collar.width))
    sizes = bore, collar.diameter
    return _ring(code, title, sizes, (low, high), group, shaft=shaft, standard=collar.designation, how=how)


def _ring(
    code: str,
    title: Message,
    sizes: tuple[float, float],
    ends: tuple[float, float],
    group: MovingGroup,
    *,
    shaft: int,
    how: Message,
    standard: str = "",
) -> CarPart:
    """Round ring on a shaft, a sleeve by its sizes where it has no standard."""
    bore, outside = sizes
    low, high = ends
    return CarPart(
        code=code,
        title=title,
        shape=Block(tuple(turned_round([(low, high, outside, bore)]))),
        places=(at(group.axis.real, group.axis.imag, 0.0),),
        group=group,
        material=Message("steel") if standard else Message("brass"),
        density=_STEEL if standard else 8.5e-3,
        colour=_DARK if standard else _BRASS,
        supply=Supply.BOUGHT,
        standard=standard or f"Ø{outside:g} x {(outside - bore) / 2:g} x {high - low:.4g}",
        shaft=shaft,
        how=how,
    )


def spring_sizes(torque: float) -> tuple[float, int]:
    """Wire, mm, and number of coils of a leg spring that fills the journal of the fork.

    The stress of bending is 32 M / (π d³).

    Args:
        torque: torque with the rod straight, N·mm.
    """
    wire = next((each for each in _WIRES if 32 * torque / (pi * each**3) <= _STRESS), _WIRES[-1])
    return wire, max(2, int(JOURNAL / wire) - 1)


def _spring(car: Mounted) -> CarPart:
    """Leg spring on the journal of the fork, which presses the rod on the disc."""
    site, keys = car.site, car.design.mechanics
    arm = abs(sum(car.disc) / 2 - site.fork)
    force = 1.0 if keys is None else keys.rod_force_N
    torque = force * arm
    wire, coils = spring_sizes(torque)
    inside = SPINDLE + _ROUND_JOURNAL
    x, z = site.base_radius, site.fork
    long = min(coils * wire, JOURNAL)
    ring = Block(tuple(turned_round([(HEAD_HALF, HEAD_HALF + long, inside + 2 * wire, inside)])))
    wound = pi * (inside + wire) * coils + 2 * arm  # mm of wire, with its legs
    return CarPart(
        code="fork-spring",
        title=Message("leg spring of the rod"),
        shape=ring,
        places=(along((0.0, -1.0, 0.0), (0.0, 0.0, site.rod_side), (x, 0.0, z)),),
        group=car.fork,
        material=Message("spring steel"),
        density=_STEEL,
        mass=pi / 4 * wire**2 * wound * _STEEL,
        assumed=keys is None,
        colour=_BRASS,
        supply=Supply.BOUGHT,
        standard=f"EN 13906-3, Ø{wire:g} x {inside:g} x {coils}, {torque:.3g} N·mm",
        how=Message("on the journal over the head of the fork"),
    )


def _supplies(car: Mounted) -> Iterator[CarPart]:
    """Brake, adhesive, grease, and the drive of a car that states none."""
    design, keys = car.design, car.design.mechanics
    if keys is not None and keys.drag_least_Nmm:
        gap = abs(
            car.place.near
            - car.place.towards * car.site.plate / 2
            - min(car.disc, key=lambda z: abs(z - car.place.near))
        )
        where = Message("on the face beside the disc that looks to it, clear of its holes")
        size = f"{_FELT:g} x {_FELT:g} x {gap + 1:.3g}"
        if keys.drag_on == Braked.SHAFT:
            where, size = (
                Message("round the camshaft, in a clip on the frame"),
                f"{_FELT:g} x {2 * pi * car.bores[1]:.0f} x 3",
            )
        yield _supply("brake-felt", Message("felt of the brake"), size, 0.1, where, count=4, material=Message("felt"))
    yield _supply(
        "adhesive",
        Message("adhesive of bonded joints"),
        Message("retaining compound on metal, epoxy on plastics"),
        1.0,
        Message("bearings in their seats, shafts in one bearing each, all that is glued"),
        material=Message("adhesive"),
    )
    if keys is None or keys.greased:
        yield _supply(
            "grease",
            Message("grease"),
            "NLGI 2",
            0.5,
            Message("on the rim of the disc and the rod"),
            material=Message("grease"),
        )
    if design.drive is None:
        energy = None if keys is None else keys.drive_energy_J
        yield _supply(
            "drive",
            Message("motor with battery, or weight"),
            f"{energy:g} J" if energy else Message("[drive] states none"),
            0.0,
            Message("on the holes for it in the base, drives the rear axle")
            if design.frame is not None
            else Message("drives the rear axle"),
        )


def _supply(
    code: str, title: Message, standard: str, mass: float, how: Message, *, count: int = 1, material: str = ""
) -> CarPart:
    """Bought part without a place of its own in the car."""
    return CarPart(
        code=code,
        title=title,
        shape=None,
        places=(),
        group=MovingGroup(GroupKind.FRAME),
        material=material,
        density=0.0,
        mass=mass,
        supply=Supply.BOUGHT,
        standard=standard,
        further=count,
        how=how,
    )
