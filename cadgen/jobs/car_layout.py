"""Layout of a car: the train between rear axle and camshaft, clear of disc, rod, wheels and floor; and its checks.

The layout is that of the car as designed. A design with [layout] is held to it; of one without it the layout is tried
with the values that [layout] has where they are left out, and what stands in the way is a reservation.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import chain
from math import atan, ceil, degrees, nan

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.assembly.arrangement import Arrangement, arrange, arranged_as, shortfall
from cadgen.car.assembly.site import CarSite, OnCamshaft, OnShaft, shaft_bodies
from cadgen.car.assembly.standard_parts import BEARINGS, bearing_of, smallest_bearing
from cadgen.car.course.body import PartName
from cadgen.car.course.layout import Side
from cadgen.car.steering import wheel_tangent
from cadgen.check import Bound, Check, CheckCode, failing
from cadgen.design import cam_model, gear_model
from cadgen.design.course import body_of
from cadgen.design.layout import LayoutSection
from cadgen.design.load import with_overrides
from cadgen.design.schema import Design, TrainDesign, whole_design
from cadgen.design.train import PlateSection
from cadgen.errors import DesignError
from cadgen.figures import Facts
from cadgen.gears.layout import RoundBody, TrainLayout, gears_and_hubs, lay_out
from cadgen.gears.stage import is_bar
from cadgen.gears.train import Train, thinned
from cadgen.messages import Message
from cadgen.parts.face import Face
from cadgen.verdict import Reservation

_SAMPLES = 2881  # of the motion over a turn: its greatest lift lies within 0.01 mm of the greatest of them
_WHEEL_WIDTH = 4.0  # mm, where [car.outline] does not say
_PLATE = 8.0  # mm, thickness of the plates where train.plate.thickness_mm does not say
_LONGEST_ROD = 4.0  # of a rod whose length is not given: so many times the distance of the disc's outer face
_NO_CURE = Message(
    "of the lengths that were tried none gives room: change car.wheelbase_mm, cam.base_radius_mm, teeth or module"
)
# Checks that depend on where the parts stand.
_OF_PLACES = {CheckCode.CAR_CLEARANCE, CheckCode.FLOOR_CLEARANCE, CheckCode.AXLE_REACHED, CheckCode.PLATE_ROOM}
# Changes of a length that are tried as a cure, mm.
_CHANGES = (2, 4, 6, 8, 10, 13, 16, 20, 25, 30, 40)


@dataclass(frozen=True)
class CarLayout:
    """A train in its car.

    Attributes:
        design: design of the car.
        site: what stands in the car besides the train.
        arrangement: train at its place; None where it does not reach from the rear axle to the camshaft.
        short: length by which it does not reach, mm.
        widest_bearing: width of the widest bearing in the plates, mm; 0 where none is known.
        sense: -1 where the camshaft turns against the drive wheel, else +1.
        gears: gears and hubs of every shaft, in the train's own frame.
        bores: diameter of every shaft, mm.
    """

    design: Design
    site: CarSite
    arrangement: Arrangement | None
    short: float
    widest_bearing: float
    sense: int
    gears: tuple[tuple[RoundBody, ...], ...]
    bores: tuple[float, ...]

    @cached_property
    def shafts(self) -> list[list[OnShaft]]:
        """Round bodies on every shaft, from the drive to the camshaft; none without an arrangement."""
        if self.arrangement is None:
            return []
        return shaft_bodies(self.site, self.gears, self.bores, self.arrangement.place)

    @cached_property
    def checks(self) -> tuple[Check, ...]:
        """Whether the parts fit together, with their limits and a cure that was tried."""
        wrong = {check.code for check in failing(self.plain_checks)} & (_OF_PLACES - {CheckCode.PLATE_ROOM})
        cure = _cure(self) if wrong else None
        if cure is None:
            return self.plain_checks
        return tuple(replace(each, advice=cure) if each.code in wrong else each for each in self.plain_checks)

    @cached_property
    def plain_checks(self) -> tuple[Check, ...]:
        """The checks without the cure, which takes a search."""
        return tuple(self._checks())

    def _checks(self) -> Iterator[Check]:
        site, found = self.site, self.arrangement
        yield Check(
            CheckCode.AXLE_REACHED,
            Message("train short of the rear axle"),
            self.short,
            "mm",
            0.0,
            place=Message("the axle lies {behind:g} mm behind the camshaft", behind=site.behind),
            advice=Message(
                "give the stages {short:.3g} mm more of centre distance in all, add a stage, or raise "
                "cam.base_radius_mm",
                short=self.short,
            ),
        )
        if found is None and self.short <= 0:
            yield Check(
                CheckCode.CAR_CLEARANCE,
                Message("least gap between parts of the car"),
                nan,
                "mm",
                site.clearance,
                Bound.MIN,
                Message("at no height of the camshaft does the train join it with the rear axle")
                if _keys(self.design).camshaft_height_mm is None
                else Message("at this height of the camshaft the train does not join it with the rear axle"),
                _NO_CURE,
            )
        if found is not None:
            yield Check(
                CheckCode.CAR_CLEARANCE,
                Message("least gap between parts of the car"),
                found.least.size,
                "mm",
                site.clearance,
                Bound.MIN,
                found.least.between,
                _NO_CURE,
            )
            yield Check(
                CheckCode.FLOOR_CLEARANCE,
                Message("least gap to the floor"),
                found.floor.size,
                "mm",
                site.floor_clearance,
                Bound.MIN,
                found.floor.one,
                _NO_CURE,
            )
            yield Check(
                CheckCode.PLATE_ROOM,
                Message("room for the train between its walls")
                if self.printed
                else Message("room for the train between its plates"),
                found.place.room,
                "mm",
                0.0,
                Bound.MIN,
                "",
                Message("raise {key} to {span:g}", key=self.span_key, span=ceil(site.span - found.place.room)),
            )
        if self.widest_bearing:
            yield Check(
                CheckCode.PLATE_THICKNESS,
                Message("walls against their bearings") if self.printed else Message("plates against their bearings"),
                site.plate,
                "mm",
                self.widest_bearing,
                Bound.MIN,
                "",
                Message("raise train.plate.thickness_mm to {width:g}", width=self.widest_bearing),
            )
        yield Check(
            CheckCode.CAM_SENSE,
            Message("cam turns the wrong way"),
            float(self.sense > 0) if not self.turned_over else float(self.sense < 0),
            "",
            0.0,
            place=Message("turned over") if self.turned_over else "",
            advice=Message(
                "set layout.turned_over to {value} and put the disc on its shaft so, or add a stage",
                value=str(not self.turned_over).lower(),
            ),
        )

    @property
    def printed(self) -> bool:
        """Whether the frame is printed in one piece, with walls in the place of plates."""
        return self.design.frame is not None and self.design.frame.printed

    @property
    def span_key(self) -> str:
        """Key of the bearing span that decides: that of a stage, or of the train."""
        stages = gear_model.train_keys(self.design).stages
        own = [number for number, stage in enumerate(stages, 1) if stage.bearing_span_mm == self.site.span]
        return f"train.stages.{own[0]}.bearing_span_mm" if own else "train.bearing_span_mm"

    @property
    def turned_over(self) -> bool:
        """Whether the disc sits turned over on its shaft."""
        return _keys(self.design).turned_over

    @property
    def directions(self) -> tuple[float, ...] | None:
        """Directions of the stages' lines of centres in the frame of the car, rad; None where the parts collide."""
        found = self.arrangement
        return None if found is None or found.least.size < 0 else found.directions

    @property
    def sentence(self) -> Message | None:
        """Where the train stands, in words; None without an arrangement."""
        found = self.arrangement
        if found is None:
            return None
        return Message(
            "in the car the camshaft stands {height:.4g} mm over the floor and {behind:g} mm before the rear axle; the "
            "stages point to {directions} degrees, ahead being 0 and down 90; the least gap is {gap:.3g} mm, between "
            "{between}",
            height=found.height,
            behind=self.site.behind,
            directions=", ".join(f"{degrees(each) % 360:.1f}" for each in found.directions),
            gap=found.least.size,
            between=found.least.between,
        )

    def entry(self) -> Facts:
        """Layout for JSON and manifests."""
        found = self.arrangement
        said = Facts(short_of_axle_mm=self.short, behind_mm=self.site.behind)
        if found is None:
            return said
        return said | Facts(
            train_face=(Face.INNER if found.place.towards == -self.site.rod_side else Face.OUTER).value,
            train_raised_mm=found.place.raised,
            disc_radius_mm=self.site.disc[0].radius,
            drive_wheel_radius_mm=self.site.wheel_radius,
            drive_wheel_z_mm=self.site.drive_wheel,
            idle_wheel_z_mm=self.site.idle_wheel,
            fork_z_mm=self.site.fork,
            camshaft_height_mm=found.height,
            directions_deg=[degrees(each) % 360 for each in found.directions],
            axes_mm=[[axis.real, axis.imag] for axis in found.axes],
            least_gap_mm=found.least.size,
            floor_gap_mm=found.floor.size,
            plates_mm=sorted((found.place.near, found.place.far)),
        )


def laid_out(design: TrainDesign, train: Train | None = None) -> CarLayout | None:
    """Layout of a car; None without [layout].

    Args:
        design: loaded design.
        train: train as planned, its stages with their own directions if they are the design's; None for the design's.

    Raises:
        DesignError: [layout] without a path, a car, a cam or a follower; or a path that cannot be driven.
    """
    if design.layout is None:
        return None
    return layout_of(whole_design(design), train)


def layout_of(design: Design, train: Train | None = None) -> CarLayout:
    """Layout of a car, also without [layout].

    Args:
        design: design of the car, with a train.
        train: train; None for the design's.

    Raises:
        DesignError: a path that cannot be driven, or a gear that cannot be made.
    """
    given = gear_model.train(design) if train is None else train
    return _layout(_Hashed(design), given)


def train_in_car(layout: CarLayout) -> TrainLayout:
    """Train of a design with thinned teeth, its stages turned as the car has them; it is not measured in mesh.

    Args:
        layout: layout of the car.

    Raises:
        DesignError: a gear or its blank is impossible.
    """
    design = layout.design
    clearance = gear_model.train_keys(design).clearance_mm
    return lay_out(thinned(gear_model.train(design)), gear_model.blanks(design), layout.directions, clearance)


def turned_to(design: TrainDesign, train: Train) -> tuple[float | None, ...]:
    """Direction that the design gives each stage of a train, rad; None for a stage that it leaves open, or has not.

    Args:
        design: loaded design.
        train: train, maybe in another order.
    """
    left = list(zip(gear_model.train(design).stages, gear_model.directions(design), strict=True))
    directions: list[float | None] = []
    for pair in train.stages:
        place = next((number for number, (known, _) in enumerate(left) if known == pair), None)
        directions.append(None if place is None else left.pop(place)[1])
    return tuple(directions)


def layout_reservation(design: Design) -> Reservation | None:
    """Reservation on a design without [layout] whose train is known not to fit its car; None if it may fit.

    Args:
        design: design of the car.
    """
    if design.train is None or design.layout is not None:
        return None
    reach = sum(stage.centre_distance for stage in gear_model.train(design).stages)
    behind = design.car.wheelbase_mm - design.cam.base_radius_mm
    if reach >= behind:
        return None
    return Reservation(
        "train-short-of-axle",
        Message(
            "the train reaches {reach:.4g} mm from the camshaft at most, and the rear axle lies {behind:.4g} mm behind "
            "it",
            reach=reach,
            behind=behind,
        ),
        Message("give the stages more teeth, or add one; with [layout] the parts are checked against each other"),
    )


def _cure(layout: CarLayout) -> Message | None:
    """Change of one key with which the parts fit, tried; None if none of those that are tried helps."""
    for override, said in _changes(layout):
        try:
            changed = layout_of(with_overrides(layout.design, [override]))
        except DesignError:
            continue
        if not _OF_PLACES & {check.code for check in failing(changed.plain_checks)}:
            return said
    return None


def _changes(layout: CarLayout) -> Iterator[tuple[str, Message]]:
    design, keys = layout.design, _keys(layout.design)
    for name in ("camshaft_height_mm", "train_face"):
        if getattr(keys, name) is not None:
            yield f"layout.{name}=", Message("leave layout.{name} out", name=name)
    if layout.arrangement is not None and layout.arrangement.place.room < 0:
        span, key = ceil(layout.site.span - layout.arrangement.place.room), layout.span_key
        yield f"{key}={span}", Message("raise {key} to {span:g}", key=key, span=span)
    sizes = (("cam.base_radius_mm", design.cam.base_radius_mm), ("car.wheelbase_mm", design.car.wheelbase_mm))
    for by in chain.from_iterable((-each, each) for each in _CHANGES):
        for key, now in sizes:
            yield f"{key}={now + by:g}", Message("set {key} to {value:g}", key=key, value=now + by)


class _Hashed:
    """A design as a key of a cache: equal values are equal."""

    def __init__(self, design: Design) -> None:
        self.design, self._hash = design, design.content_hash

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Hashed) and self._hash == other._hash

    def __hash__(self) -> int:
        return hash(self._hash)


@lru_cache(maxsize=64)  # gears, cam, drawing and page of one design ask for it, and each train that a search tries
def _layout(hashed: _Hashed, train: Train) -> CarLayout:
    design = hashed.design
    keys, shafts, of_train = _keys(design), len(train.stages) + 1, gear_model.blanks(design)
    blanks = of_train.by_shaft(shafts)
    bores = [blank.shaft_diameter for blank in blanks]
    if is_bar(train.stages[-1].wheels[1]):
        raise DesignError(
            "[layout] sets a train between a wheel and a cam, and the last stage is a rack, which turns none: remove "
            "[layout] (on the command line with --set layout=), or the rack"
        )
    bodies = gears_and_hubs(thinned(train), blanks, gear_model.train_keys(design).clearance_mm)
    distances = [stage.centre_distance for stage in train.stages]
    # Of two shafts on one axis each ends at its gears.
    shared = [stage.centre_distance == 0 for stage in train.stages]
    ending = tuple(
        ends or before or after
        for ends, before, after in zip(of_train.ends(shafts), (False, *shared), (*shared, False), strict=True)
    )
    site = replace(_site(design, train, keys, bores), ending=ending)
    towards = None if keys.train_face is None else site.rod_side * (-1 if keys.train_face == Face.INNER else 1)
    given = turned_to(design, train)
    stated = [each for each in given if each is not None]
    height = keys.camshaft_height_mm
    if len(stated) == len(given):
        found = arranged_as(site, bodies, distances, bores, stated, towards=towards, height=height)
        short = max(site.behind - abs(np.sum(distances * np.exp(1j * np.array(stated)))), 0.0)
    else:
        found = arrange(site, bodies, distances, bores, towards=towards, height=height)
        short = shortfall(site, distances)
    borne = [bearing_of(bore, outside) for bore, outside in zip(bores, site.bearings, strict=True)]
    widest = max((bearing.width for bearing in borne if bearing), default=0.0)
    of_shafts = tuple(tuple(on) for on in bodies)
    return CarLayout(design, site, found, short, widest, train.sense, of_shafts, tuple(bores))


def _keys(design: Design) -> LayoutSection:
    return design.layout or LayoutSection()


def _site(design: Design, train: Train, keys: LayoutSection, bores: Sequence[float]) -> CarSite:
    """Bodies of the car as designed besides its train.

    Raises:
        DesignError: a path that cannot be driven.
    """
    design = design.as_designed()
    track, car = cam_model.track(design), cam_model.car(design)
    motion, follower = cam_model.lift(design, track), cam_model.leaning(design, "the layout of the car")
    plates = gear_model.train_keys(design).plate or PlateSection()
    inner, outer = design.cam.faces_mm
    tangents = np.asarray(motion.q(np.linspace(0.0, TURN, _SAMPLES)))
    greatest = float(np.max(follower.lift(tangents)))
    side = -1 if (design.cam.side or Side.LEFT) == Side.RIGHT else 1
    fork = -inner if side > 0 else outer
    wheels = {wheel.name: wheel for wheel in body_of(design.car.outline, car).wheels}
    front, rear = wheels[PartName.FRONT_WHEEL], wheels[PartName.DRIVE_WHEEL]
    angles = np.array([tangents.min(), tangents.max()])
    steered = np.arctan(np.sort(wheel_tangent(angles, car) * side))
    return CarSite(
        base_radius=design.cam.base_radius_mm,
        behind=car.wheelbase - design.cam.base_radius_mm,
        fork=fork,
        drive_wheel=fork + car.drive_wheel_offset,
        idle_wheel=fork - car.idle_wheel_offset,
        wheel_radius=cam_model.travel(design, track) / (TURN * float(train.ratio)),
        wheel_width=rear.width or _WHEEL_WIDTH,
        front_radius=front.radius,
        front_width=front.width,
        disc=tuple(_disc(design, follower.base_radius + greatest - follower.radius, outer - inner, side)),
        rod_radius=follower.radius,
        rod_length=min(follower.length, _LONGEST_ROD * outer),
        rod_side=side,
        rod_angles=(atan(tangents.min()), atan(tangents.max())),
        wheel_angles=(float(steered[0]), float(steered[1])),
        clearance=keys.clearance_mm,
        gear_clearance=gear_model.train_keys(design).clearance_mm,
        floor_clearance=keys.floor_clearance_mm,
        plate=plates.thickness_mm or _PLATE,
        bearings=_bearings(design, plates, bores),
        ending=(),
        span=min(stage.bearing_span for stage in train.stages),
    )


def _bearings(design: Design, plates: PlateSection, bores: Sequence[float]) -> tuple[float, ...]:
    """Outer diameter of each shaft's bearings, mm; 0 for none, as without [frame] and sizes of its own."""
    if plates.bearing_bores_mm is not None:
        from cadgen.output.files.plate import bearing_bores  # only here: a check of any cam need not read CAD formats

        return tuple(bearing_bores(plates.bearing_bores_mm, bores))
    if design.frame is None:
        return tuple([0.0] * len(bores))
    chosen = [smallest_bearing(bore, plates.thickness_mm or _PLATE) for bore in bores]
    if None in chosen:
        number = chosen.index(None)
        raise DesignError(
            "train.plate.bearing_bores_mm is not given, and no bearing of the table suits shaft {shaft} of {bore:g} "
            "mm: give the outer diameters, or shafts of {known} mm",
            shaft=number + 1,
            bore=bores[number],
            known=", ".join(f"{each:g}" for each in sorted({bearing.bore for bearing in BEARINGS})),
        )
    return tuple(bearing.diameter for bearing in chosen if bearing)


def _disc(design: Design, radius: float, thickness: float, side: int) -> Iterator[OnCamshaft]:
    yield OnCamshaft(Message("the disc"), radius, 0.0, thickness)
    hub = cam_model.blank(design).hub
    if hub is not None:
        # Turned over about the camshaft's normal, the disc takes its hub to the other side.
        below = ((hub.side == Face.INNER) == (side > 0)) != _keys(design).turned_over
        low, high = (-hub.length, 0.0) if below else (thickness, thickness + hub.length)
        yield OnCamshaft(Message("the hub of the disc"), hub.diameter / 2, low, high)
