"""Parts of a car put together: disc, train, shafts, wheels, fork and rod at their places in the layout.

What the design does not say of a part is chosen here and named in its texts: the fork, its wheel, and hubs of wheels.
"""

from collections import Counter
from collections.abc import Iterator
from colorsys import hsv_to_rgb
from dataclasses import dataclass, replace
from functools import cached_property
from math import atan, cos, pi, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import Array
from cadgen.car.assembly.car_parts import (
    Block,
    BodyShape,
    CarPart,
    Content,
    DiscShape,
    Drilled,
    GroupKind,
    KeySlot,
    MovingGroup,
    Prism,
    Supply,
    along,
    at,
    key_outline,
    still,
    together,
)
from cadgen.car.assembly.carried import Carried
from cadgen.car.assembly.fork_sizes import (
    BRIDGE_HEIGHT,
    BRIDGE_LENGTH,
    CHEEK,
    CLAMP,
    FRONT_HUB_DIAMETER,
    FRONT_WIDTH,
    GAP,
    HEAD,
    HEAD_HALF,
    JOURNAL,
    PIN,
    SPINDLE,
    WHEEL_HUB,
    front_radius,
    hub_width,
)
from cadgen.car.assembly.site import CarSite
from cadgen.car.assembly.standard_parts import ParallelKey, bearing_of, key_length, key_size
from cadgen.car.assembly.turning_train import TurningTrain, turning_train
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.chamfer import chamfered_off
from cadgen.curves.contour import Contour, circle
from cadgen.design import gear_model
from cadgen.errors import DesignError
from cadgen.gears.layout import TrainLayout
from cadgen.jobs.cam.cam_plan import DENSITY, CamPlan
from cadgen.jobs.cam.steered_car import SteeredCar
from cadgen.jobs.car_frame import frame_in
from cadgen.jobs.car_layout import CarLayout, train_in_car
from cadgen.jobs.frame_parts import frame_parts, known_material
from cadgen.jobs.gears.train_making import TrainMaking
from cadgen.jobs.mounting_parts import Mounted, collar_room, mounting_parts
from cadgen.messages import Message
from cadgen.output.files.manifest import Origin
from cadgen.parts.body import Body, RadialHole, Slab
from cadgen.parts.features import Keyway
from cadgen.parts.loop import circle as circle_loop

if TYPE_CHECKING:
    from cadgen.jobs.gears.gear_train import GearTrain  # it measures teeth in mesh, which a list of parts does without

_HUB_WALL = 4.0  # mm between a wheel's bore and the outside of its hub
_SCREW_HOLE = 2.5  # mm, to be tapped M3
_SCREWS_APART, _THROUGH = 12.0, 3.2
_METAL, _DARK, _BRASS = (0.66, 0.68, 0.70), (0.22, 0.24, 0.27), (0.78, 0.65, 0.30)
_DISC_COLOUR, _FORK_COLOUR = (0.86, 0.47, 0.21), (0.27, 0.47, 0.70)
_STEEL = Message("steel")
_THREAD = "M3"  # of set screws, where the design states none


@dataclass(frozen=True, eq=False, kw_only=True)
class PlacedParts:
    """Parts of a car at their places.

    Attributes:
        layout: train in its car.
        cam: plan of its cam.
        parts: parts of the car.
    """

    layout: CarLayout
    cam: CamPlan
    parts: tuple[CarPart, ...]

    @cached_property
    def use(self) -> SteeredCar:
        """Car that the cam steers."""
        return SteeredCar.of(self.cam)

    def fork_angle(self, cam_angle: float) -> float:
        """Angle of the fork about y with the rod on the disc, rad.

        Args:
            cam_angle: cam angle, rad.
        """
        tangent = float(np.asarray(self.use.rolled(self.cam).q(np.array([cam_angle % (2 * pi)])))[0])
        return self.layout.site.rod_side * atan(tangent)

    def part(self, code: str) -> CarPart:
        """Part by its code.

        Raises:
            KeyError: there is none.
        """
        return {part.code: part for part in self.parts}[code]

    def balance(self, cam_angle: float = 0.0) -> Content:
        """Mass of the car, g, with all that is listed, and the centre of what has a place, mm.

        Args:
            cam_angle: cam angle, rad.
        """
        fork = self.fork_angle(cam_angle)
        placed = together(part.balance(cam_angle, fork) for part in self.parts)
        return Content(placed.volume + sum(part.each * part.further for part in self.parts), placed.centre)


@dataclass(frozen=True, eq=False, kw_only=True)
class CarAssembly(PlacedParts):
    """A car put together.

    Attributes:
        origin: design of the car.
        train: plan of its train.
    """

    origin: Origin
    train: "GearTrain"


def put_together(cam: CamPlan, train: "GearTrain") -> CarAssembly:
    """Put a car together.

    Args:
        cam: plan of its cam.
        train: plan of its train, with its layout.

    Raises:
        DesignError: the design has no layout, or its train has no place in the car.
    """
    car = train.car
    if car is None:
        raise DesignError(
            "{name} does not say where its train stands in the car: add a section [layout], which may be empty",
            name=train.name,
        )
    if car.arrangement is None or car.directions is None:
        raise DesignError(
            "the parts of {name} have no room in the car: see cadgen gears {name} for what to change", name=train.name
        )
    parts = _parts(cam, train.layout, train.making, train.stem, car)
    return CarAssembly(origin=train.origin, layout=car, cam=cam, train=train, parts=parts)


def parts_in(layout: CarLayout, cam: CamPlan) -> PlacedParts | None:
    """Parts of a car by its layout, with the train of the design; None where they have no room.

    Args:
        layout: train in its car.
        cam: plan of its cam.

    Raises:
        DesignError: a gear, its blank, the frame or the fork is impossible.
    """
    if layout.directions is None:
        return None
    making = TrainMaking.of(gear_model.train_keys(layout.design))
    parts = _parts(cam, train_in_car(layout), making, layout.design.name, layout)
    return PlacedParts(layout=layout, cam=cam, parts=parts)


def _parts(cam: CamPlan, train: TrainLayout, making: TrainMaking, stem: str, car: CarLayout) -> tuple[CarPart, ...]:
    assert car.arrangement is not None  # both callers refuse a car without an arrangement
    turning = turning_train(train, 0.0, car.arrangement.place.raised, 1 if car.turned_over else -1)
    made = _Parts(cam, making, stem, car, turning)
    own = {part.code: part for part in made.every()}
    frame = frame_parts(frame_in(car)) if car.design.frame is not None else ()
    # A part of the frame stands in the place of one with its code.
    given = {part.code: part for part in frame}
    # A colour to each part: readers of STEP tell parts apart by them, and two alike share one entity of the file.
    shades: dict[tuple[float, float, float], int] = {}
    parts = []
    for part in (own | given).values():
        repeated = shades[part.colour] = shades.get(part.colour, -1) + 1
        red, green, blue = (each * 0.985**repeated for each in part.colour)
        parts.append(replace(part, colour=(red, green, blue)))
    return tuple(parts)


@dataclass(frozen=True, eq=False)
class _Parts:
    """Parts of a car as they are made."""

    cam: CamPlan
    making: TrainMaking
    stem: str
    car: CarLayout
    turning: TurningTrain

    @property
    def site(self) -> CarSite:
        return self.car.site

    @cached_property
    def groups(self) -> tuple[MovingGroup, ...]:
        """Groups of the shafts, from the drive to the camshaft."""
        return tuple(
            MovingGroup(GroupKind.SHAFT, number, part.axis, part.rate)
            for number, part in enumerate(self.turning.parts, 1)
        )

    @cached_property
    def fork_group(self) -> MovingGroup:
        return MovingGroup(GroupKind.FORK, axis=complex(self.site.base_radius, self.site.fork))

    @cached_property
    def weight(self) -> Carried | None:
        """Drop weight at its place; None for a car without one."""
        if self.car.design.drive is None or self.car.design.drive.fall_mm is None:
            return None
        return frame_in(self.car).frame.carried

    def every(self) -> Iterator[CarPart]:
        """All parts, in the order of the list."""
        yield self.disc()
        yield from self.gears()
        yield from self.keys()
        yield from self.shafts()
        yield from self.bearings()
        yield from self.wheels()
        yield from self.drum()
        yield from self.fork()
        yield from self.screws()
        yield from mounting_parts(self.mounted)

    @property
    def mounted(self) -> Mounted:
        """Places and sizes that collars, spring and the like go by."""
        site, blank = self.site, self.cam.made_blank
        assert self.car.arrangement is not None  # `put_together` refuses a car without an arrangement
        return Mounted(
            design=self.car.design,
            site=site,
            place=self.car.arrangement.place,
            axle=self.groups[0],
            camshaft=self.groups[-1],
            fork=self.fork_group,
            bores=(self.turning.parts[0].part.blank.shaft_diameter, self.turning.parts[-1].part.blank.shaft_diameter),
            disc=(min(each.low for each in site.disc), max(each.high for each in site.disc)),
            joint=self.cam.making.fit.joint,
            screwed=blank.hub is not None and blank.hub.set_screw is not None,
        )

    def disc(self) -> CarPart:
        """Disc of the cam on the camshaft."""
        plan = self.cam
        thickness, making = plan.thickness, plan.making
        place = still()
        if self.car.turned_over:
            place = np.array([[1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, -1.0, thickness]])
        blank = plan.made_blank
        chamfers = 2 * chamfered_off(plan.curve, blank.edge_break) if blank.edge_break else 0.0
        return CarPart(
            code="cam-disc",
            title=Message("disc of the cam"),
            shape=DiscShape(plan.curve, blank, thickness, chamfers),
            places=(place,),
            group=self.groups[-1],
            material=making.ordered or Message(str(DiscMaterial.ALUMINIUM)),
            density=DENSITY[making.material or DiscMaterial.ALUMINIUM] * 1e-3,
            assumed=making.material is None,
            colour=_DISC_COLOUR,
            standard=plan.stem,
            shaft=len(self.groups),
        )

    def gears(self) -> Iterator[CarPart]:
        """Gears, one part on each shaft, and planets beside them."""
        shafts = len(self.groups)
        turnings = (*self.turning.parts, *self.turning.beside)
        for number, turning in ((number, piece) for number, each in enumerate(turnings, 1) for piece in each.pieces):
            part = turning.part
            stated = self.making.shaft(part.shaft, shafts).material
            material, density, assumed = known_material(stated, DiscMaterial.STEEL)
            # With the gears pushing the cam at cam angle 0.
            standing = replace(part, axis=turning.axis, angle=turning.angle, height=part.height + turning.lift)
            if number <= shafts:
                teeth = " + ".join(str(each.teeth) for each in part.gears if hasattr(each, "teeth"))
                title = Message("gear of {teeth} teeth, shaft {shaft}", teeth=teeth, shaft=part.shaft)
                group = self.groups[number - 1]
            else:
                title = Message("{name} of stage {stage}", name=part.name.partition("_")[2], stage=part.stages[0])
                carrier = None if turning.carrier is None else self.groups[turning.carrier]
                group = MovingGroup(GroupKind.BESIDE, number, turning.axis, turning.rate, carrier)
            yield CarPart(
                code=f"gear-{part.name}".replace("_", "-"),
                title=title,
                shape=BodyShape(part.body, part.volume),
                places=(standing.transform,),
                group=group,
                material=material,
                density=density,
                assumed=assumed,
                colour=hsv_to_rgb((0.58 + number * (sqrt(5) - 1) / 2) % 1.0, 0.35, 0.75),
                standard=f"{self.stem}_{part.name}",
                shaft=part.shaft if number <= shafts else 0,
            )

    def keys(self) -> Iterator[CarPart]:
        """Parallel keys of disc and gears: with round ends where one is sold so short, else cut to the hub's length."""
        for code, title, key, bore, angle, ends, shaft in self._keyed():
            _, seat = key_size(key.width)
            low, made = self._key(key, ends, shaft)
            outline = key_outline(low, low + made.length, key.width, (made.form == "A",) * 2)
            axis, out = self.groups[shaft - 1].axis, (cos(angle), sin(angle), 0.0)
            yield CarPart(
                code=code,
                title=title,
                shape=Block((Prism(outline, bore / 2 - seat, bore / 2 - seat + made.height),)),
                places=(along(out, (0.0, 0.0, 1.0), (axis.real, axis.imag, 0.0)),),
                group=self.groups[shaft - 1],
                material=_STEEL,
                density=DENSITY[DiscMaterial.STEEL] * 1e-3,
                colour=_BRASS,
                supply=Supply.BOUGHT,
                standard=made.designation,
                shaft=shaft,
                how=Message("into its seat") if made.form == "A" else Message("cut to length, into its seat"),
            )

    def _key(self, key: Keyway, ends: tuple[float, float], shaft: int) -> tuple[float, ParallelKey]:
        """Height at which a key begins, mm, and the key: form A where one is sold so short, else form B.

        Args:
            key: keyway of what it holds.
            ends: heights of what it holds, mm.
            shaft: number of the shaft, from 1.
        """
        first, last = self.shaft_ends(shaft)
        low, high = max(ends[0], first + key.width / 2), min(ends[1], last - key.width / 2)
        height, seat = key_size(key.width)
        height = min(height, seat + key.depth)
        length = key_length(key.width, high - low)
        if length is None:
            low, high = self._off_bearings(key.width / 2, (max(ends[0], first), min(ends[1], last)), shaft)
            return low, ParallelKey("B", key.width, height, high - low)
        return (low + high - length) / 2, ParallelKey("A", key.width, height, length)

    def _off_bearings(self, beyond: float, ends: tuple[float, float], shaft: int) -> tuple[float, float]:
        """Ends of a square key whose seat stays off the bearings, mm; unchanged where less than half of it is left.

        Args:
            beyond: length by which the seat runs out beyond the key, mm.
            ends: heights of the key, mm.
            shaft: number of the shaft, from 1.
        """
        low, high = ends
        for start, end in borne(self.car, shaft):
            if end <= (ends[0] + ends[1]) / 2:
                low = max(low, end + beyond)
            else:
                high = min(high, start - beyond)
        return (low, high) if high - low >= (ends[1] - ends[0]) / 2 else ends

    def _seat(self, key: Keyway, angle: float, ends: tuple[float, float], shaft: int) -> KeySlot:
        """Seat of a key, as an end mill leaves it: as long as a round key, beyond a square one by half its width.

        A square key beside a bearing is shorter than its hub, so that its seat ends before the bearing.

        Near the end of the shaft it is open.

        Args:
            key: keyway of what the key holds.
            angle: polar angle of its middle, rad.
            ends: heights of what it holds, mm.
            shaft: number of the shaft, from 1.
        """
        low, made = self._key(key, ends, shaft)
        high = low + made.length
        first, last = self.shaft_ends(shaft)
        radius, half = self.turning.parts[shaft - 1].part.blank.shaft_diameter / 2, key.width / 2
        if made.form == "B":
            low, high = low - half, high + half
        closed = low >= first + half - 1e-9, high <= last - half + 1e-9
        low, high = (low if closed[0] else first), (high if closed[1] else last)
        return KeySlot(low, high, key.width, radius - key_size(key.width)[1], radius, angle, closed, made)

    def _keyed(self) -> Iterator[tuple[str, Message, Keyway, float, float, tuple[float, float], int]]:
        """Code, title, keyway, bore, polar angle in the car, heights and shaft of each key."""
        last = len(self.groups)
        for turning in self.turning.parts:
            blank, part = turning.part.blank, turning.part
            if isinstance(blank.key, Keyway):
                angle = (-blank.key.angle if part.flipped else blank.key.angle) + turning.angle
                yield (
                    f"key-shaft-{part.shaft}",
                    Message("key of the gear on shaft {shaft}", shaft=part.shaft),
                    blank.key,
                    blank.bore_diameter,
                    angle,
                    turning.range,
                    part.shaft,
                )
        blank = self.cam.made_blank
        if isinstance(blank.key, Keyway):
            angle = -blank.key.angle if self.car.turned_over else blank.key.angle
            low, high = min(each.low for each in self.site.disc), max(each.high for each in self.site.disc)
            title = Message("key of the disc")
            yield "key-cam-disc", title, blank.key, blank.bore_diameter, angle, (low, high), last

    def shaft_ends(self, number: int) -> tuple[float, float]:
        """Heights between which a shaft runs, mm.

        Args:
            number: number of the shaft, from 1.
        """
        site, place = self.site, self.car.arrangement.place if self.car.arrangement else None
        assert place is not None  # `put_together` refuses a car without an arrangement
        ends = sorted((place.near, place.far))
        low, high = self.turning.parts[number - 1].range
        if not site.ending[number - 1]:
            low, high = min(low, ends[0] - site.plate / 2), max(high, ends[1] + site.plate / 2)
        half = site.wheel_width / 2
        if number == 1:
            for z, side in self._rear_wheels():
                low, high = min(low, z - half), max(high, z + half)
                end = z + side * (half + WHEEL_HUB)
                if z == site.idle_wheel:
                    end += side * collar_room(self.turning.parts[0].part.blank.shaft_diameter)
                low, high = min(low, end), max(high, end)
        if number == len(self.groups):
            below = place.towards > 0
            disc = (min(each.low for each in site.disc), max(each.high for each in site.disc))
            low, high = min(low, disc[0] - below * CLAMP), max(high, disc[1] + (not below) * CLAMP)
        return low, high

    def _rear_wheels(self) -> tuple[tuple[float, int], tuple[float, int]]:
        """Heights of drive and idle wheel, and the side on which their hubs stand: outwards."""
        drive, idle = self.site.drive_wheel, self.site.idle_wheel
        return (drive, 1 if drive > idle else -1), (idle, -1 if drive > idle else 1)

    def shafts(self) -> Iterator[CarPart]:
        """Shafts with the seats of their keys."""
        keyed = list(self._keyed())
        for number, (turning, group) in enumerate(zip(self.turning.parts, self.groups, strict=True), 1):
            diameter = turning.part.blank.shaft_diameter
            low, high = self.shaft_ends(number)
            seats = tuple(
                self._seat(key, angle, ends, number) for _, _, key, _, angle, ends, shaft in keyed if shaft == number
            )
            title = Message("shaft {shaft}", shaft=number)
            drilled: tuple[Drilled, ...] = ()
            if number == 1 and self.weight is not None and not self.weight.body.drum:
                start = (0.0, -diameter / 2, self.weight.z - self.weight.body.winding / 2)
                drilled = (Drilled(start, (0.0, 1.0, 0.0), self.weight.body.knot, diameter, self.weight.body.knot),)
            if number == 1:
                title = Message("rear axle, shaft 1")
            elif number == len(self.groups):
                title = Message("camshaft, shaft {shaft}", shaft=number)
            yield CarPart(
                code=f"shaft-{number}",
                title=title,
                shape=Block((Prism(circle((0.0, 0.0), diameter / 2), low, high),), seats, drilled),
                places=(at(group.axis.real, group.axis.imag, 0.0),),
                group=group,
                material=_STEEL,
                density=DENSITY[DiscMaterial.STEEL] * 1e-3,
                assumed=True,
                colour=_METAL,
                shaft=number,
                order=-1,
            )

    def drum(self) -> Iterator[CarPart]:
        """Drum of a weight's string on the rear axle."""
        if self.weight is None or self.weight.turning is None:
            return
        axis, (_, low, _) = self.groups[0].axis, self.weight.turning
        yield CarPart(
            code="drum",
            title=Message("drum of the string"),
            shape=self.weight.drum,
            places=(at(axis.real, axis.imag, low),),
            group=self.groups[0],
            material=Message("aluminium"),
            density=DENSITY[DiscMaterial.ALUMINIUM] * 1e-3,
            assumed=True,
            colour=_BRASS,
            shaft=1,
            how=Message("flange with the hole to the right, bonded"),
        )

    def bearings(self) -> Iterator[CarPart]:
        """Bearings in both plates, one part for each size."""
        site, place = self.site, self.car.arrangement.place if self.car.arrangement else None
        assert place is not None  # `put_together` refuses a car without an arrangement
        sizes: dict[tuple[float, float], list[Array]] = {}
        for number, (turning, outside) in enumerate(zip(self.turning.parts, site.bearings, strict=True)):
            if outside and not site.ending[number]:
                axis, size = turning.axis, (turning.part.blank.shaft_diameter, outside)
                sizes.setdefault(size, []).extend(at(axis.real, axis.imag, z) for z in (place.near, place.far))
        for (bore, outside), places in sizes.items():
            known = bearing_of(bore, outside)
            width = site.plate if known is None else known.width
            ring = Prism(circle((0.0, 0.0), outside / 2), -width / 2, width / 2, (circle((0.0, 0.0), bore / 2),))
            yield CarPart(
                code=f"bearing-{bore:g}-{outside:g}".replace(".", "p"),
                title=Message("ball bearing"),
                shape=Block((ring,)),
                places=tuple(places),
                group=MovingGroup(GroupKind.FRAME),
                material=_STEEL,
                density=0.6 * DENSITY[DiscMaterial.STEEL] * 1e-3,  # the room between its rings is empty
                colour=_DARK,
                supply=Supply.BOUGHT,
                standard=f"ISO 15, {bore:g} x {outside:g} x {width:g}",
            )

    def wheels(self) -> Iterator[CarPart]:
        """Drive wheel, fixed on the rear axle, and idle wheel, which runs free on it."""
        bore, group = self.turning.parts[0].part.blank.shaft_diameter, self.groups[0]
        half, outside = self.site.wheel_width / 2, bore + 2 * _HUB_WALL
        rim = 2 * self.site.wheel_radius
        drive, idle = self._rear_wheels()
        for (z, side), code, title, fixed in (
            (drive, "drive-wheel", Message("drive wheel"), True),
            (idle, "idle-wheel", Message("idle wheel"), False),
        ):
            hole = RadialHole(_SCREW_HOLE, half + WHEEL_HUB / 2, outside / 2 + 1.0) if fixed else None
            body = Body(
                (
                    Slab(-half, half, (circle_loop(rim), circle_loop(bore))),
                    Slab(half, half + WHEEL_HUB, (circle_loop(outside), circle_loop(bore))),
                ),
                hole,
            )
            axis = group.axis
            place = at(axis.real, axis.imag, z)
            if side < 0:
                place[1, 1] = place[2, 2] = -1.0
            yield CarPart(
                code=code,
                title=title,
                shape=BodyShape(body),
                places=(place,),
                group=group,
                material=Message("acrylic"),
                density=DENSITY[DiscMaterial.ACRYLIC] * 1e-3,
                assumed=True,
                colour=_DARK if fixed else (0.25, 0.24, 0.28),
                shaft=1,
                how=Message("hub outwards, set screw") if fixed else Message("hub outwards, runs free"),
            )

    def fork(self) -> Iterator[CarPart]:
        """Fork with its wheel and the rod, straight ahead."""
        site, group = self.site, self.fork_group
        height = self.car.arrangement.height if self.car.arrangement else 0.0
        radius = front_radius(site, height)
        width = site.front_width or FRONT_WIDTH
        if radius < FRONT_HUB_DIAMETER:
            raise DesignError(
                "the camshaft stands {height:.4g} mm over the floor, which leaves no room for a front wheel under the "
                "rod: set layout.camshaft_height_mm to {least:g} or more, or cam.base_radius_mm",
                height=height,
                least=np.ceil(2 * HEAD + BRIDGE_HEIGHT + 2 * GAP + 2 * FRONT_HUB_DIAMETER),
            )
        hub = hub_width(site)
        steel, aluminium = (DENSITY[each] * 1e-3 for each in (DiscMaterial.STEEL, DiscMaterial.ALUMINIUM))
        # Heights over the floor, turned into y: the wheel's axle, the bridge over the wheel.
        axle, bridge = height - radius, height - 2 * radius - GAP
        x, z = site.base_radius, site.fork
        upwards = along((0.0, -1.0, 0.0), (0.0, 0.0, site.rod_side), (x, 0.0, z))
        socket = RadialHole(2 * site.rod_radius, 0.0, HEAD / 2 + 1.0)
        spindle = Body(
            tuple(
                Slab(low, high, (circle_loop(across),))
                for low, high, across in (
                    (-bridge, -HEAD_HALF, SPINDLE),
                    (-HEAD_HALF, HEAD_HALF, max(HEAD, 2 * site.rod_radius + _HUB_WALL)),
                    (HEAD_HALF, HEAD_HALF + JOURNAL, SPINDLE),
                )
            ),
            socket,
        )
        yield CarPart(
            code="fork-spindle",
            title=Message("spindle of the fork"),
            shape=BodyShape(spindle),
            places=(upwards,),
            group=group,
            material=_STEEL,
            density=steel,
            assumed=True,
            colour=(0.70, 0.71, 0.74),
        )
        rod = Prism(circle((0.0, 0.0), site.rod_radius), 0.0, site.rod_length)
        stated = getattr(self.car.design.follower.keys, "material", None)
        yield CarPart(
            code="rod",
            title=Message("rod"),
            shape=Block((rod,)),
            places=(along((0.0, 0.0, site.rod_side), (1.0, 0.0, 0.0), (x, 0.0, z)),),
            group=group,
            material=Message(str(stated or "steel")),
            density=steel,
            assumed=stated is None,
            colour=(0.80, 0.81, 0.83),
        )
        half = BRIDGE_LENGTH / 2
        holes = tuple(
            Drilled((side * _SCREWS_APART / 2, hub / 2, 0.0), (0.0, -1.0, 0.0), _SCREW_HOLE, hub) for side in (-1, 1)
        )
        # Its own z points up, and its own y along the shafts.
        block = Prism(
            _box(-half, half, -hub / 2, hub / 2),
            -BRIDGE_HEIGHT / 2,
            BRIDGE_HEIGHT / 2,
            (circle((0.0, 0.0), SPINDLE / 2),),
        )
        yield CarPart(
            code="fork-bridge",
            title=Message("bridge of the fork"),
            shape=Block((block,), drilled=holes),
            places=(along((0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (x, bridge - BRIDGE_HEIGHT / 2, z)),),
            group=group,
            material=Message("aluminium"),
            density=aluminium,
            assumed=True,
            colour=_FORK_COLOUR,
        )
        top = bridge - BRIDGE_HEIGHT - axle
        cheek = Prism(
            Contour(
                np.array([[-half, top], [half, top], [half, 0.0], [-half, 0.0]]),
                np.array([0.0, 0.0, 1.0, 0.0]),
            ),
            0.0,
            CHEEK,
            (
                circle((0.0, 0.0), PIN / 2),
                *(circle((side * _SCREWS_APART / 2, top + BRIDGE_HEIGHT / 2), _THROUGH / 2) for side in (-1, 1)),
            ),
        )
        yield CarPart(
            code="fork-cheek",
            title=Message("cheek of the fork"),
            shape=Block((cheek,)),
            places=(at(x, axle, z + hub / 2), at(x, axle, z - hub / 2 - CHEEK)),
            group=group,
            material=Message("aluminium"),
            density=aluminium,
            assumed=True,
            colour=(0.30, 0.50, 0.72),
        )
        pin = Prism(circle((0.0, 0.0), PIN / 2), -hub / 2 - CHEEK, hub / 2 + CHEEK)
        yield CarPart(
            code="front-pin",
            title=Message("axle of the front wheel"),
            shape=Block((pin,)),
            places=(at(x, axle, z),),
            group=group,
            material=_STEEL,
            density=steel,
            supply=Supply.BOUGHT,
            standard=f"ISO 2338, {PIN:g} m6 x {hub + 2 * CHEEK:g}",
            colour=(0.60, 0.61, 0.64),
        )
        wheel = Body(
            tuple(
                Slab(low, high, (circle_loop(across), circle_loop(PIN)))
                for low, high, across in (
                    (-hub / 2, -width / 2, FRONT_HUB_DIAMETER),
                    (-width / 2, width / 2, 2 * radius),
                    (width / 2, hub / 2, FRONT_HUB_DIAMETER),
                )
            )
        )
        yield CarPart(
            code="front-wheel",
            title=Message("front wheel"),
            shape=BodyShape(wheel),
            places=(at(x, axle, z),),
            group=group,
            material=Message("POM"),
            density=DENSITY[DiscMaterial.POM] * 1e-3,
            assumed=True,
            colour=(0.20, 0.21, 0.24),
        )
        yield CarPart(
            code="fork-screws",
            title=Message("cap screws of the fork's cheeks"),
            shape=None,
            places=(),
            group=group,
            material=_STEEL,
            density=0.0,
            mass=0.7,
            supply=Supply.BOUGHT,
            standard="ISO 4762, M3 x 8",
            further=4,
            how=Message("through the cheeks into the ends of the bridge"),
        )

    def screws(self) -> Iterator[CarPart]:
        """Set screws of hubs by the threads that the design states, and M3 where it states none."""
        shafts = len(self.groups)
        hubs = [
            (turning.part.blank.hub, self.making.shaft(turning.part.shaft, shafts).fit)
            for turning in self.turning.parts
        ]
        hubs.append((self.cam.made_blank.hub, self.cam.making.fit))
        tapped = [(fit.thread or _THREAD).split()[0] for hub, fit in hubs if hub is not None and hub.set_screw]
        for thread, count in Counter([_THREAD, *tapped]).items():
            yield CarPart(
                code="set-screws" if thread == _THREAD else f"set-screws-{thread.lower()}",
                title=Message("set screws of the hubs"),
                shape=None,
                places=(),
                group=self.groups[0],
                material=_STEEL,
                density=0.0,
                mass=0.15,
                supply=Supply.BOUGHT,
                standard=f"ISO 4029, {thread} x 4",
                further=count,
                how=Message("in the hubs that are tapped for them"),
            )


def borne(car: CarLayout, shaft: int) -> tuple[tuple[float, float], ...]:
    """Heights between which a shaft lies in the plates, whose bearings or holes take it, mm; none of one that ends.

    Args:
        car: train in its car.
        shaft: number of the shaft, from 1.
    """
    if car.arrangement is None or car.site.ending[shaft - 1]:
        return ()
    half, place = car.site.plate / 2, car.arrangement.place
    return tuple((z - half, z + half) for z in sorted((place.near, place.far)))


def _box(left: float, right: float, low: float, high: float) -> Contour:
    return Contour(np.array([[left, low], [right, low], [right, high], [left, high]]), np.zeros(4))
