"""Frame of a car: its parts by the layout, their checks with cures that were tried, and their files and sheets."""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import ceil, floor, hypot

from cadgen.car.assembly.arrangement import Gap
from cadgen.car.assembly.carried import CarriedBody
from cadgen.car.assembly.fork_sizes import front_radius
from cadgen.car.assembly.frame.built_frame import Frame
from cadgen.car.assembly.frame.frame_gaps import frame_gap, standing_gap
from cadgen.car.assembly.frame.frame_maker import frame_of
from cadgen.car.assembly.frame.frame_sizes import FrameSizes
from cadgen.car.assembly.frame.one_piece import OnePiece
from cadgen.car.assembly.panels import Panel
from cadgen.car.assembly.standard_parts import SCREWS, key_size
from cadgen.check import Bound, Check, CheckCode, failing
from cadgen.design import gear_model
from cadgen.design.frame import Cutting, FrameSection
from cadgen.design.load import with_overrides
from cadgen.design.schema import Design, TrainDesign, whole_design
from cadgen.design.train import PlateSection
from cadgen.errors import DesignError
from cadgen.figures import Facts, JobResult
from cadgen.jobs.car_layout import CarLayout, layout_of, train_in_car
from cadgen.messages import Message
from cadgen.output.drawing.shaft_fit import hole_class
from cadgen.parts.features import Keyway

_SEAT = "H7"  # class of the seats of bearings where train.plate.hole_fit does not say
CLEAR = 0.05  # mm by which the half circles of inner corners are larger than the cutter
OVERHANG = 1.0  # mm by which a layer may stand out over nothing with a free end: two lines of a nozzle of 0.4 mm
BRIDGE = 30.0  # mm that a wall may bridge: melted filament over a gap sags by less than a layer up to some 30 mm
# Values of keys that are tried as a cure, the gentlest first.
_CURES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("frame.base_height_mm", ("",)),
    ("frame.screws", ("M3", "M2.5", "M2")),
    ("frame.micrometer_mm", ("6.5",)),
    ("frame.slot_mm", ("3", "2", "1")),
    ("frame.base_thickness_mm", ("5", "4", "3")),
    ("train.plate.thickness_mm", ("8", "10", "6")),
    ("frame.cutter_diameter_mm", ("3", "2")),
)
_LESS_WALL = "frame.wall_mm", ("2", "1.5", "1")  # lowers a limit: tried last
_SMALLER = (0.8, 0.6, 0.4, 0.3)  # shares of the diameter of a drum
_HIGHER = (5.0, 10.0, 15.0, 20.0, 30.0, 40.0)  # mm by which the camshaft is raised, so that the train folds otherwise
_FARTHER = (1.0, 2.0, 3.0)  # mm that parts of the layout stand farther apart
_WIDER = (5.0, 10.0, 20.0, 30.0, 40.0, 60.0, 80.0)  # mm by which the idle wheel is set farther out


@dataclass(frozen=True, eq=False, repr=False)
class CarFrame(JobResult):
    """The frame of a car, computed and checked. Lengths are mm.

    Attributes:
        design: design of the car.
        layout: layout of its parts.
        frame: plates, base, platform, brackets, block and bought parts at their places.
    """

    design: Design
    layout: CarLayout
    frame: Frame

    def __repr__(self) -> str:
        return f"<CarFrame of {self.design.name}>"

    @property
    def stem(self) -> str:
        """Start of the names of its files."""
        return f"{self.design.name}_frame"

    @cached_property
    def gaps(self) -> tuple[Gap, Gap]:
        """Least gap to what moves, and that among parts that stand on the base."""
        return frame_gap(self.frame, self.layout.shafts, self.layout.bores), standing_gap(self.frame)

    @cached_property
    def plain_checks(self) -> tuple[Check, ...]:
        """The frame's own checks, without cures, which take a search."""
        return tuple(self._checks())

    @property
    def checks(self) -> tuple[Check, ...]:
        """Checks of the layout and of the frame."""
        return (*self.layout.checks, *self.own_checks)

    @cached_property
    def own_checks(self) -> tuple[Check, ...]:
        """The frame's own checks, with their limits and a cure that was tried."""
        wrong = {check.code for check in failing(self.plain_checks) if not check.advice}
        cure = _tried(self.design, self._changes(wrong)) if wrong else None
        advice = cure or Message(
            "none of the values that were tried gives a frame: change [frame], or the layout by layout.clearance_mm"
        )
        return tuple(replace(each, advice=advice) if each.code in wrong else each for each in self.plain_checks)

    @property
    def passed(self) -> bool:
        """Whether every check holds."""
        return not failing(self.checks)

    def _changes(self, wrong: Collection[str]) -> Iterator[tuple[str, Sequence[str]]]:
        """Keys with the values that are tried as a cure, the gentlest first.

        Args:
            wrong: checks that fail.
        """
        height, car, clearance = self.frame.arrangement.height, self.design.car, self.frame.site.clearance
        higher = "layout.camshaft_height_mm", [f"{ceil(height + more)}" for more in _HIGHER]
        meets = bool({CheckCode.FRAME_CLEARANCE, CheckCode.FRAME_APART} & set(wrong))
        if meets:
            yield higher
        if CheckCode.DRIVE_ROOM in wrong:
            drum = self.frame.sizes.carried.drum if self.frame.sizes.carried else 0.0
            yield "car.idle_wheel_offset_mm", [f"{car.idle_wheel_offset_mm + more:g}" for more in _WIDER]
            yield "drive.drum_mm", [f"{round(drum * share):g}" for share in _SMALLER] if drum else []
        yield from _CURES
        yield "layout.clearance_mm", [f"{clearance + more:g}" for more in _FARTHER]
        if not meets:
            yield higher
        yield _LESS_WALL

    def _checks(self) -> Iterator[Check]:
        frame, site = self.frame, self.frame.site
        moving, standing = self.gaps
        wall, where = frame.wall
        yield Check(
            CheckCode.FRAME_CLEARANCE,
            Message("least gap between frame and what moves"),
            moving.size + _rounding(moving.size, site.clearance),
            "mm",
            site.clearance,
            Bound.MIN,
            moving.between,
        )
        yield Check(
            CheckCode.FRAME_APART,
            Message("least gap between parts of the frame"),
            standing.size,
            "mm",
            site.clearance,
            Bound.MIN,
            standing.between,
        )
        yield Check(
            CheckCode.FRAME_WALL,
            Message("least material beside a hole"),
            wall + _rounding(wall, frame.sizes.wall),
            "mm",
            frame.sizes.wall,
            Bound.MIN,
            where,
        )
        if frame.printed is None:
            found, wanted = frame.joints
            yield Check(
                CheckCode.FRAME_JOINTS,
                Message("tabs and screws that find room"),
                float(found),
                "",
                float(wanted),
                Bound.MIN,
            )
        else:
            yield from self._printed_checks(frame.printed)
        yield Check(CheckCode.FRAME_PIECES, Message("pieces of the base"), float(frame.pieces), "", 1.0)
        yield Check(
            CheckCode.FRAME_FLOOR,
            Message("least gap between frame and floor"),
            frame.under,
            "mm",
            site.floor_clearance,
            Bound.MIN,
            Message("the screws under the base"),
        )
        yield Check(
            CheckCode.FRAME_BLOCK,
            Message("height of the fork's block"),
            frame.block.height,
            "mm",
            2 * frame.block.bearing.width + frame.sizes.wall,
            Bound.MIN,
            Message("two bearings with a wall between"),
        )
        if frame.sizes.tapped:
            yield Check(
                CheckCode.FRAME_EDGE,
                Message("plates against the threads in their edges"),
                site.plate,
                "mm",
                2 * frame.sizes.screw.diameter,
                Bound.MIN,
            )
        yield Check(
            CheckCode.FRONT_WHEEL_ROOM,
            Message("room for the front wheel"),
            frame.wheel_room + _rounding(frame.wheel_room, 2 * front_radius(site, frame.arrangement.height)),
            "mm",
            2 * front_radius(site, frame.arrangement.height),
            Bound.MIN,
        )

        yield from self._drive_checks()

    def _printed_checks(self, printed: OnePiece) -> Iterator[Check]:
        """Checks of a frame in one piece: the printer's room, bridges, and shafts that are pushed through its walls."""
        bed = self.frame.sizes.bed
        assert bed is not None  # a printed frame has a bed
        across, wide = sorted(printed.size[:2]), sorted(bed[:2])
        yield Check(
            CheckCode.FRAME_BED,
            Message("room that the printer has besides the frame"),
            min(wide[0] - across[0], wide[1] - across[1], bed[2] - printed.size[2]),
            "mm",
            0.0,
            Bound.MIN,
            Message(
                "{size} mm on a bed of {bed} mm",
                size=" x ".join(f"{each:.1f}" for each in printed.size),
                bed=" x ".join(f"{each:g}" for each in bed),
            ),
            self._without_bed(printed),
        )
        longest = next((bridge for bridge in printed.bridges if bridge.held), None)
        loose = next((bridge for bridge in printed.bridges if not bridge.held), None)
        yield Check(
            CheckCode.FRAME_BRIDGE,
            Message("longest bridge of a wall over an opening"),
            0.0 if longest is None else longest.length,
            "mm",
            BRIDGE,
            place="" if longest is None else longest.wall,
        )
        yield Check(
            CheckCode.FRAME_OVERHANG,
            Message("longest overhang of a wall with a free end"),
            0.0 if loose is None else loose.length,
            "mm",
            OVERHANG,
            place="" if loose is None else loose.wall,
        )
        keyed = list(self._keyed())
        if keyed:
            room, shaft, size = min(keyed)
            yield Check(
                CheckCode.FRAME_KEYS,
                Message("room for the key of a shaft that is pushed through its wall"),
                room,
                "mm",
                0.0,
                Bound.MIN,
                Message("shaft {shaft}", shaft=shaft),
                Message(
                    "take a bearing of {size:.1f} mm or more for shaft {shaft} (train.plate.bearing_bores_mm)",
                    size=size,
                    shaft=shaft,
                ),
            )

    def _without_bed(self, printed: OnePiece) -> Message:
        """Bed on which a printed frame lies, and whether sheets would do."""
        bed = ", ".join(f"{ceil(each - 1e-6)}" for each in printed.size)
        try:
            apart = car_frame(with_overrides(self.design, ["frame.make=", "frame.bed_mm="]))
            sheets = apart.frame.whole and not failing((*apart.plain_checks, *apart.layout.plain_checks))
        except DesignError:
            sheets = False
        if not sheets:
            return Message("print it where there is more room: set frame.bed_mm to [{bed}] or more", bed=bed)
        return Message(
            "print it where there is more room: set frame.bed_mm to [{bed}] or more, or leave frame.make and "
            "frame.bed_mm out, and the frame is made of sheets",
            bed=bed,
        )

    def _keyed(self) -> Iterator[tuple[float, int, float]]:
        """Room for the key of each shaft that has one in the wall through which it is pushed, shaft, and hole, mm."""
        (wall,) = (panel for panel in self.frame.plates if panel is self.pushed_through)
        holes = {hole.shaft: hole.diameter for hole in wall.holes}
        for number, part in enumerate(train_in_car(self.layout).on_shafts, 1):
            key, bore = part.blank.key, part.blank.shaft_diameter
            if isinstance(key, Keyway) and number in holes:
                height, seat = key_size(key.width)
                needed = 2 * hypot(bore / 2 - seat + height, key.width / 2)
                yield (holes[number] - needed) / 2, number, needed

    @property
    def pushed_through(self) -> Panel:
        """Bearing plate on the side away from the idle wheel, through which the shafts of a printed frame are put."""
        site = self.frame.site
        side = 1.0 if site.idle_wheel < site.fork else -1.0
        return max(self.frame.plates, key=lambda panel: side * float(panel.place.shift[2]))

    def _drive_checks(self) -> Iterator[Check]:
        """Checks of room for weight or motor, and of the way that a weight falls."""
        frame, body = self.frame, self.frame.sizes.carried
        if body is None:
            return
        yield Check(
            CheckCode.DRIVE_ROOM,
            Message("places for the {body} on the base", body=body.title),
            float(frame.carried is not None),
            "",
            1.0,
            Bound.MIN,
            self._without_room(body),
        )
        if not body.fall:
            yield self._screw_check(body)
        if frame.carried is None or not body.fall:
            return
        low, start = frame.top - frame.carried.low, frame.arrangement.height - frame.carried.high
        more = frame.site.clearance - low
        yield Check(
            CheckCode.DRIVE_FALL,
            Message("height of the weight over the base at the end of its fall"),
            low + _rounding(low, frame.site.clearance),
            "mm",
            frame.site.clearance,
            Bound.MIN,
            "",
            Message(
                "leave drive.start_height_mm out, raise it to {start:.4g}, or lower drive.fall_mm to {fall:.4g}",
                start=start + more,
                fall=body.fall - more,
            )
            if body.fall > more
            else Message("leave drive.start_height_mm out, or raise it to {start:.4g}", start=start + more),
        )

    def _without_room(self, body: CarriedBody) -> Message:
        """Reason for which weight or motor has no place."""
        room, needed = self.frame.carried_room, body.width(self.frame.sizes.drive)
        if room < needed:
            return Message(
                "{room:.1f} mm across the car are free between train and idle wheel, {needed:.1f} are needed",
                room=room,
                needed=ceil(10 * needed - 1e-6) / 10,
            )
        over = self.frame.top - self.frame.arrangement.axes[0].imag - self.frame.site.clearance
        if body.drum and over < body.reach:
            return Message(
                "the drum of the string has flanges of {size:.1f} mm, and the base lies {over:.1f} mm under the axle",
                size=2 * body.reach,
                over=over + self.frame.site.clearance,
            )
        return Message(
            "{room:.1f} mm across the car are free between train and idle wheel, but nowhere clear of openings, "
            "screws and axle",
            room=room,
        )

    def _screw_check(self, body: CarriedBody) -> Check:
        """Material of a motor beside the screws that hold it."""
        sizes = self.frame.sizes
        apart, edge = sizes.drive, sizes.wall + sizes.screw.diameter / 2
        nearer = [floor(size - 2 * edge + 1e-6) for size in (body.along, body.across)]
        larger = [ceil(hole + 2 * edge - 1e-6) for hole in apart]
        advice = Message(
            "take a motor of {along} mm along the car and {across} across it or more (drive.size_mm)",
            along=max(larger[0], ceil(body.along)),
            across=max(larger[1], ceil(body.across)),
        )
        if min(nearer) > sizes.screw.diameter + sizes.wall:
            along, across = (min(each, by) for each, by in zip(apart, nearer, strict=True))
            advice = Message(
                "set frame.drive_holes_mm to [{along:g}, {across:g}], or {other}",
                along=along,
                across=across,
                other=advice,
            )
        return Check(
            CheckCode.DRIVE_SCREWS,
            Message("material of the motor beside its screws"),
            min(body.along - apart[0], body.across - apart[1]) / 2 - sizes.screw.diameter / 2,
            "mm",
            sizes.wall,
            Bound.MIN,
            Message(
                "a motor of {along:g} x {across:g} mm, holes {one:g} x {other:g} mm apart",
                along=body.along,
                across=body.across,
                one=apart[0],
                other=apart[1],
            ),
            advice,
        )

    @property
    def sentence(self) -> Message:
        """Size of the frame in words."""
        left, low, right, high = self.base_size
        if self.frame.printed is not None:
            return Message(
                "printed in one piece, {size} mm, its lower face {under:.4g} mm over the floor; camshaft to fork axis "
                "{apart:g} mm, which slots in the platform let vary by {way:g} mm to either side",
                size=" x ".join(f"{each:.1f}" for each in self.frame.printed.size),
                under=self.frame.under + self.frame.sizes.screw.head_height,
                apart=self.frame.site.base_radius,
                way=self.frame.sizes.travel / 2,
            )
        return Message(
            "base {long:.4g} by {wide:.4g} mm, its lower face {under:.4g} mm over the floor; camshaft to fork axis "
            "{apart:g} mm, which slots in the platform let vary by {way:g} mm to either side",
            long=right - left,
            wide=high - low,
            under=self.frame.under + self.frame.sizes.screw.head_height,
            apart=self.frame.site.base_radius,
            way=self.frame.sizes.travel / 2,
        )

    @property
    def base_size(self) -> tuple[float, float, float, float]:
        """Least and greatest x and y of the base's outline in its own frame, mm."""
        points = self.frame.base.outline.vertices
        (left, low), (right, high) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        return left, low, right, high

    @property
    def bought(self) -> list[tuple[str, str, int]]:
        """Bought parts: code, name and how many."""
        names = {part.code: part.name for part in self.frame.bought}
        count = Counter(part.code for part in self.frame.bought)
        return [(code, names[code], number) for code, number in count.items()]

    def entry(self) -> Facts:
        """Frame for JSON and manifests."""
        frame = self.frame
        failed = failing(self.checks)
        return Facts(
            design=self.design.name,
            design_sha256=self.design.content_hash,
            passed=not failed,
            checks=[
                Facts(code=str(each.code), value=each.value, unit=each.unit, limit=each.limit, passed=each.passed)
                for each in self.checks
            ],
            base_height_mm=frame.under + frame.sizes.screw.head_height,
            camshaft_to_fork_mm=frame.site.base_radius,
            front_wheel_room_mm=frame.wheel_room,
            parts=[
                *(
                    Facts(
                        code="printed",
                        size_mm=list(each.size),
                        volume_mm3=each.volume,
                        bridges_mm=[bridge.length for bridge in each.bridges],
                    )
                    for each in (frame.printed,)
                    if each is not None
                ),
                *(
                    Facts(code=panel.code, thickness_mm=panel.thickness, volume_mm3=panel.volume)
                    for panel in frame.sheets
                ),
                Facts(
                    code="block",
                    size_mm=[frame.block.length, frame.block.width, frame.block.height],
                    volume_mm3=frame.block.volume,
                ),
            ],
            bought=[Facts(code=code, quantity=number) for code, _, number in self.bought],
        )


def car_frame(design: TrainDesign) -> CarFrame:
    """Frame of a car.

    Args:
        design: loaded design.

    Raises:
        DesignError: there is no [frame] or no [layout], or the train does not join camshaft and rear axle.
    """
    if design.frame is None:
        raise DesignError(
            "{source} has no [frame], which says how plates, base and fork hold the parts: add the line [frame], or "
            "give --set frame={empty}",
            source=design.source,
            empty="{}",
        )
    if design.layout is None:
        raise DesignError(
            "[frame] holds the parts where [layout] puts them, and {source} has no [layout]: add it, which may be "
            "empty",
            source=design.source,
        )
    return frame_in(layout_of(whole_design(design)))


def checks_in_car(layout: CarLayout) -> tuple[Check, ...]:
    """Checks of the parts in a car, and of their frame if the design has one.

    Args:
        layout: train in its car.
    """
    if layout.design.frame is None or layout.arrangement is None:
        return layout.checks
    return frame_in(layout).checks


@lru_cache(maxsize=16)  # cam, gears, page and assembly of one design ask for it
def frame_in(layout: CarLayout) -> CarFrame:
    """Frame of a car by its layout; that of an empty [frame] where the design has none.

    Args:
        layout: train in its car.

    Raises:
        DesignError: the train does not join the camshaft with the rear axle.
    """
    design, keys = layout.design, layout.design.frame or FrameSection()
    if layout.arrangement is None:
        short = failing(layout.checks)[0]
        raise DesignError(
            "the train finds no place in the car, so there is nothing for a frame to hold ({name}): {advice}",
            name=Message(short.name),
            advice=Message(short.advice),
        )
    plates = gear_model.train_keys(design).plate or PlateSection()
    mill = keys.cutting == Cutting.MILL and not keys.printed
    sizes = FrameSizes(
        wall=keys.wall_mm,
        screw=SCREWS[keys.screws],
        tapped=mill,
        corner=keys.cutter_diameter_mm / 2 + CLEAR if mill else 0.0,
        base=keys.base_thickness_mm,
        base_height=keys.base_height_mm,
        travel=keys.slot_mm,
        stem=keys.micrometer_mm,
        drive=keys.drive_holes_mm,
        carried=_carried(design, layout.bores[0]),
        seat=hole_class(plates.hole_fit) or _SEAT,
        bed=keys.bed_mm if keys.printed else None,
    )
    return CarFrame(design, layout, frame_of(sizes, layout.site, layout.arrangement, layout.shafts, layout.bores))


def _carried(design: Design, axle: float) -> CarriedBody | None:
    given = design.drive
    if given is None:
        return None
    along, across, tall = given.size_mm
    return CarriedBody(
        along=along,
        across=across,
        tall=tall,
        mass=given.mass_kg,
        fall=given.fall_mm or 0.0,
        start=given.start_height_mm,
        axle=axle,
        drum=given.drum_mm or 0.0,
        string=given.string_mm,
    )


def _rounding(value: float, limit: float) -> float:
    """Difference of a figure from its limit that is rounding alone."""
    return limit - value if 0 < limit - value < 1e-6 else 0.0


def _tried(design: Design, changes: Iterable[tuple[str, Sequence[str]]]) -> Message | None:
    """First change of one key with which every check of layout and frame holds; None if none helps.

    Args:
        design: design of the car.
        changes: keys with the values that are tried, the gentlest first.
    """
    for key, values in changes:
        for value in values:
            if key == "frame.base_height_mm" and (design.frame is None or design.frame.base_height_mm is None):
                continue
            try:
                changed = with_overrides(design, [f"{key}={value}"])
                frame = frame_in(layout_of(changed))
            except DesignError:
                continue
            if frame.frame.whole and not failing((*frame.plain_checks, *frame.layout.plain_checks)):
                if not value:
                    return Message("leave {key} out", key=key)
                return Message("set {key} to {value}", key=key, value=value)
    return None
