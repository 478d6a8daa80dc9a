"""Schema of a design file: its sections, keys, ranges and defaults.

A unit stands at the end of a key's name; numbers here are as the file has them (mm, degrees, micrometres). A
new section is a class and one line in `DesignFile`. Checks that compare keys stand in the section that holds
them all; their messages are sentences for the user.
"""

import hashlib
import json
from collections.abc import Mapping
from difflib import get_close_matches
from typing import Annotated, Any

from pydantic import (
    Field,
    SerializeAsAny,
    ValidationError,
    ValidationInfo,
    ValidatorFunctionWrapHandler,
    field_validator,
    model_validator,
)

from cadgen.cam.followers.closure import Closure
from cadgen.cam.followers.kind import FollowerSeat
from cadgen.cam.followers.rod_kind import ROD
from cadgen.cam.limits import PressureAngleLimitName
from cadgen.car.course.layout import Side
from cadgen.design.as_built import AsBuiltSection
from cadgen.design.blank import BlankSection
from cadgen.design.course import CourseSection, OutlineSection
from cadgen.design.disc import MotionCam, base_circle_radius, follower_motion
from cadgen.design.drive import DRUM_WALL, DriveSection
from cadgen.design.dynamics import DynamicsSection
from cadgen.design.file_names import name_fault
from cadgen.design.follower import FOLLOWER, FollowerSection, fitting_kinds, lifted_kinds
from cadgen.design.frame import FrameSection
from cadgen.design.layout import LayoutSection
from cadgen.design.lift_tolerances import LiftTolerances
from cadgen.design.machining import DrawingText, Machining
from cadgen.design.motion import MotionSection
from cadgen.design.path import PATH, PathSection
from cadgen.design.play import MechanicsSection, Optimize, PlaySection, TolerancesSection
from cadgen.design.section import WORD, DesignSection, Point, Points, Size, listed
from cadgen.design.settings import SettingsSection
from cadgen.design.train import TrainSection, train_by_stages
from cadgen.errors import DesignError
from cadgen.laws.unit import TAN
from cadgen.messages import Message
from cadgen.parts.face import Face
from cadgen.parts.print_compensation import PrintCompensation

THINNEST_DISC_MM = 0.1
LEAST_LAND_MM = 0.1  # between two broken edges; less is worn to a ridge by the rod, and no shop can hold it
# Chord error of the cam's mesh where the design gives none.
CAM_CHORD_UM = 5.0


class Arena(DesignSection):
    """The field the car drives on. The figures show it; the cam does not depend on it."""

    corner_mm: Point = Field(default=(0.0, 0.0), description="[x, y] of the field's lower left corner")
    size_mm: Size = Field(description="[width, height] of the field")
    obstacle_radius_mm: float = Field(default=50.0, gt=0, le=1000, description="radius of every obstacle")
    obstacles_mm: Points = Field(default=(), description="[x, y] of each obstacle's centre")


class CarSection(DesignSection):
    """The three-wheeled car in plan view. One of its rear wheels is driven: the left one, or with signs the right.

    A1 counts to the left of the fork axis and A2 to its right. A car whose right wheel is driven has both negative; one
    that is driven at the middle of its axle has A1 = 0 for a fork axis above that.
    """

    wheelbase_mm: float = Field(ge=1, le=2000, description="L, front fork axis to rear axle")
    drive_wheel_offset_mm: float = Field(
        ge=-1000, le=1000, description="A1, fork axis to the driven wheel, along the axle, positive to the left"
    )
    idle_wheel_offset_mm: float = Field(
        ge=-1000, le=1000, description="A2, fork axis to the other rear wheel, along the axle, positive to the right"
    )
    max_steering_angle_deg: float = Field(
        default=35.0, ge=1, le=80, description="what the fork can turn to either side"
    )
    drive_wheel_radius_mm: float | None = Field(
        default=None,
        gt=0,
        le=1000,
        description="R_h; needs [train]. With it the whole path is driven before the closing blend; left out, a turn "
        "of the cam takes the whole path, which gives the radius, and the blend steers the last of it",
    )
    outline: OutlineSection | None = None


class CamSection(DesignSection):
    """The disc and its place. Two of the four keys from `inner_face_mm` to `thickness_mm` fix its faces."""

    base_radius_mm: float = Field(gt=0, le=500, description="a, camshaft to fork axis")
    inner_face_mm: float | None = Field(default=None, gt=0, le=500, description="fork axis to the disc's nearer face")
    outer_face_mm: float | None = Field(default=None, gt=0, le=500, description="fork axis to the disc's farther face")
    mid_plane_mm: float | None = Field(default=None, gt=0, le=500, description="e, fork axis to the disc's middle")
    thickness_mm: float | None = Field(
        default=None, ge=THINNEST_DISC_MM, le=100, description="C, between the disc's faces"
    )
    side: Annotated[Side, WORD] | None = Field(
        default=None,
        description="of the fork axis on which the disc is; left out, left: the rod is lifted in right turns. On the "
        "right it is lifted in left turns, and files show the disc from its inner face",
    )
    blend_deg: float = Field(
        default=12.0,
        ge=0.5,
        le=180,
        description="last part of the turn, which leads the lift back to its start; in less no rod can follow it, "
        "and more would leave less than half a turn to the path. A closed path has none",
    )

    @property
    def faces_mm(self) -> tuple[float, float]:
        """Distances of the inner and of the outer face from the fork axis."""
        match self._given_faces():
            case {"mid_plane_mm": middle, "thickness_mm": thickness}:
                return middle - thickness / 2, middle + thickness / 2
            case {"mid_plane_mm": middle, "inner_face_mm": inner}:
                return inner, 2 * middle - inner
            case {"mid_plane_mm": middle, "outer_face_mm": outer}:
                return 2 * middle - outer, outer
            case {"inner_face_mm": inner, "thickness_mm": thickness}:
                return inner, inner + thickness
            case {"outer_face_mm": outer, "thickness_mm": thickness}:
                return outer - thickness, outer
            case {"inner_face_mm": inner, "outer_face_mm": outer}:
                return inner, outer
            case given:
                raise AssertionError(f"no cam with {given} passes the schema")

    def _given_faces(self) -> dict[str, float]:
        names = ("inner_face_mm", "outer_face_mm", "mid_plane_mm", "thickness_mm")
        return {name: value for name in names if (value := getattr(self, name)) is not None}

    @model_validator(mode="after")
    def _two_keys_fix_the_faces(self) -> "CamSection":
        given = self._given_faces()
        have = listed([f"{name} = {value:g}" for name, value in given.items()], "and") or Message("none of them")
        if len(given) < 2:
            raise ValueError(
                Message(
                    "cam needs exactly two of inner_face_mm, outer_face_mm, mid_plane_mm and thickness_mm, but "
                    "has {have}: add {count} more",
                    have=have,
                    count=2 - len(given),
                )
            )
        if len(given) > 2:
            drop = listed([f"--set cam.{name}=" for name in given], "or")
            raise ValueError(
                Message(
                    "cam has {have}, but exactly two fix the faces: remove the others (on the command line with "
                    "{drop})",
                    have=have,
                    drop=drop,
                )
            )
        inner, outer = self.faces_mm
        if inner > outer:
            raise ValueError(
                Message(
                    "cam has {have}, which puts the faces in the wrong order, the inner one at {inner:g} mm and "
                    "the outer one at {outer:g} mm: the inner face must be the one nearer to the fork axis",
                    have=have,
                    inner=inner,
                    outer=outer,
                )
            )
        if inner <= 0 or outer - inner < THINNEST_DISC_MM:
            raise ValueError(
                Message(
                    "cam has {have}, which puts the faces at {inner:g} and {outer:g} mm from the fork axis: both "
                    "must lie beyond it, at least {thinnest_disc_mm:g} mm apart",
                    have=have,
                    inner=inner,
                    outer=outer,
                    thinnest_disc_mm=THINNEST_DISC_MM,
                )
            )
        return self


class Checks(DesignSection):
    """Limits that a cam must keep to be exported."""

    pressure_angle_limit: Annotated[PressureAngleLimitName, WORD] | None = Field(
        default=None,
        description="whose limits of the pressure angle hold; see the table below. Left out, Norton's for the "
        "follower: norton_translating on a slide, norton_oscillating on a pivoted arm or a car's fork",
    )
    lost_lift_limit_um: float | None = Field(
        default=None,
        gt=0,
        le=10_000,
        description="greatest lift that an undercut may cost; left out, 1 for a cam by its [motion], and any for a "
        "car, of which `lost_lift_effect_mm` judges what it costs",
    )
    lost_lift_effect_mm: float = Field(
        default=1.0,
        gt=0,
        le=1000,
        description="of a car, greatest distance by which lost lift may move it anywhere on its run",
    )
    min_yield_percent: float = Field(
        default=25.0,
        ge=0,
        le=100,
        description="of a car with [course], least share of random cars within the tolerances that keep it",
    )
    min_convex_radius_mm: float = Field(
        default=0.5,
        ge=0,
        le=100,
        description="least radius of convex parts, so that no ridge wears; corners apart",
    )
    min_wall_mm: float = Field(default=2.0, ge=0, le=100, description="least wall between the outline and any hole")


class PrintSection(DesignSection):
    """Compensation of the files for printing, STL and 3MF: they take back what a printer does to the part.

    They are compared with the part after that is taken out again.
    """

    hole_um: float = Field(
        default=0.0, ge=0, le=2000, description="by which bores and holes print too small, in diameter"
    )
    chords: bool = Field(
        default=False,
        description="whether the corners of round holes stand outside, so that the chords touch the circle",
    )
    foot_um: float = Field(
        default=0.0, ge=0, le=1000, description="by which the first layers bulge on each side (elephant's foot)"
    )
    foot_height_um: float = Field(default=200.0, gt=0, le=5000, description="height over which the bulge dies away")
    shrinkage_percent: float = Field(default=0.0, ge=-5, le=10, description="by which the part shrinks")
    shrinkage_z_percent: float | None = Field(
        default=None, ge=-5, le=10, description="by which it shrinks in height; left out, as much as across"
    )

    @property
    def compensation(self) -> PrintCompensation:
        """Compensation for printing, in mm and shares."""
        up = self.shrinkage_percent if self.shrinkage_z_percent is None else self.shrinkage_z_percent
        return PrintCompensation(
            hole=self.hole_um * 1e-3,
            chords=self.chords,
            foot=self.foot_um * 1e-3,
            foot_height=self.foot_height_um * 1e-3,
            shrinkage=self.shrinkage_percent / 100,
            shrinkage_z=up / 100,
        )


class Export(DesignSection):
    """How finely the files follow the exact outline."""

    mesh_chord_um: float | None = Field(
        default=None,
        ge=0.1,
        le=1000,
        description="greatest chord error of STL and 3MF; left out, 5 for the cam, and for gears 2 per mm of module, "
        "at most 5",
    )
    arc_tolerance_um: float = Field(
        default=0.2,
        ge=0.01,
        le=0.5,
        description="greatest error of the arcs in DXF and G-code, which may move the rod by no more than 1 µm",
    )
    point_count: int = Field(default=3600, ge=360, le=36_000, description="points of the xyz and CSV clouds")
    print: PrintSection | None = None

    @property
    def printing(self) -> PrintCompensation | None:
        """Compensation of the files for printing; None where the design does not say."""
        return None if self.print is None else self.print.compensation

    @property
    def cam_chord_um(self) -> float:
        """Greatest chord error of the cam's mesh."""
        return CAM_CHORD_UM if self.mesh_chord_um is None else self.mesh_chord_um


_MOST_OF_A_FALL = 1.01  # of a weight's energy that mechanics.drive_energy_J may be, for it is rounded


class TrainFile(DesignSection):
    """A design file of which only the gear train is wanted: the sections of the cam may be left out."""

    name: str = Field(
        default="",
        description="what the exported files are named after; left out, the design file's own name",
    )
    path: SerializeAsAny[PathSection] | None = None
    field: Arena | None = None
    course: CourseSection | None = None
    car: CarSection | None = None
    motion: MotionSection | None = None
    dynamics: DynamicsSection | None = None
    lift_tolerances: LiftTolerances | None = None
    cam: CamSection | MotionCam | None = None
    follower: SerializeAsAny[FollowerSection] | None = None
    blank: BlankSection = BlankSection()
    machining: Machining = Machining()
    checks: Checks = Field(default=Checks(), validate_default=True)
    export: Export = Export()
    train: SerializeAsAny[TrainSection] | None = None
    layout: LayoutSection | None = None
    frame: FrameSection | None = None
    drive: DriveSection | None = None
    play: PlaySection | None = None
    mechanics: MechanicsSection | None = None
    tolerances: TolerancesSection = TolerancesSection()
    optimize: Optimize = Optimize()
    drawing: DrawingText | None = None
    settings: SettingsSection | None = None
    as_built: AsBuiltSection | None = None

    @field_validator("path", mode="wrap")
    @classmethod
    def _path_by_its_kind(cls, value: object, usual: ValidatorFunctionWrapHandler) -> PathSection | None:
        return PATH.check(value, usual)

    @field_validator("follower", mode="wrap")
    @classmethod
    def _follower_by_its_kind(cls, value: object, usual: ValidatorFunctionWrapHandler) -> FollowerSection | None:
        return FOLLOWER.check(value, usual)

    @field_validator("cam", mode="wrap")
    @classmethod
    def _cam_by_what_it_is_for(
        cls, value: object, usual: ValidatorFunctionWrapHandler, info: ValidationInfo
    ) -> CamSection | MotionCam | None:
        """Check one of the two kinds of [cam] alone, so that an error names its key and not the kind."""
        if not isinstance(value, dict):
            checked: CamSection | MotionCam | None = usual(value)
            return checked
        of_a_car = info.data.get("motion", value) is None
        return CamSection.model_validate(value) if of_a_car else MotionCam.model_validate(value)

    @field_validator("checks")
    @classmethod
    def _limit_by_the_follower(cls, checks: Checks, info: ValidationInfo) -> Checks:
        if checks.pressure_angle_limit is not None:
            return checks
        follower = info.data.get("follower")
        kind = ROD if follower is None else follower.registered
        return checks.model_copy(update={"pressure_angle_limit": kind.pressure_angle_limit})

    @field_validator("train", mode="wrap")
    @classmethod
    def _train_by_its_stages(cls, value: object, usual: ValidatorFunctionWrapHandler) -> TrainSection | None:
        return train_by_stages(value, usual)

    @model_validator(mode="after")
    def _the_frame_carries_the_drive(self) -> "TrainFile":
        keys = self.mechanics
        if keys is not None and keys.car_mass_kg is not None and keys.drive_energy_J is None and self.drive is None:
            raise ValueError(
                Message(
                    "mechanics.car_mass_kg is given for the energy of the run, and what the drive has is not: give "
                    "mechanics.drive_energy_J, or remove car_mass_kg"
                )
            )
        if self.drive is None:
            return self
        if self.frame is None or self.layout is None:
            raise ValueError(
                Message(
                    "[drive] stands on the base of [frame], which holds the parts where [layout] puts them: add "
                    "[layout] and [frame], which may be empty, or remove [drive]"
                )
            )
        axle, drum = 0.0 if self.train is None else self.train.drive.bore_diameter_mm, self.drive.drum_mm
        if drum is not None and drum < axle + 2 * DRUM_WALL:
            raise ValueError(
                Message(
                    "drive.drum_mm is {drum:g}, and the rear axle in it is train.drive.bore_diameter_mm = {axle:g}: "
                    "raise drum_mm to {least:g} or more, or leave it out, and the string is wound on the axle",
                    drum=drum,
                    axle=axle,
                    least=axle + 2 * DRUM_WALL,
                )
            )
        has, given = self.drive.energy_of(), None if keys is None else keys.drive_energy_J
        if has is not None and given is not None and given > _MOST_OF_A_FALL * has:
            raise ValueError(
                Message(
                    "mechanics.drive_energy_J is {given:g}, and a weight of drive.mass_kg = {mass:g} kg that falls "
                    "drive.fall_mm = {fall:g} mm has {has:.3g} J: lower it to that, or leave it out",
                    given=given,
                    mass=self.drive.mass_kg,
                    fall=self.drive.fall_mm,
                    has=has,
                )
            )
        return self

    @model_validator(mode="after")
    def _course_says_it_once(self) -> "TrainFile":
        if self.course is None:
            return self
        if self.course.gates and self.tolerances.gate_width_mm is not None:
            raise ValueError(
                Message(
                    "tolerances.gate_width_mm is {gate_width_mm:g}, but the gates are those of [[course.gates]]: "
                    "remove tolerances.gate_width_mm (on the command line with --set tolerances.gate_width_mm=)",
                    gate_width_mm=self.tolerances.gate_width_mm,
                )
            )
        if self.field is not None:
            raise ValueError(
                Message(
                    "field and course both say what stands on the field: move its size to [course.field] and its "
                    "obstacles to [[course.posts]] or [[course.gates]], and remove [field] (on the command line "
                    "with --set field=)"
                )
            )
        return self

    @field_validator("name")
    @classmethod
    def _name_suits_files(cls, name: str) -> str:
        if fault := name_fault(name):
            raise ValueError(Message('name is "{name}"; it must {fault}', name=name[:80], fault=fault))
        return name


class DiscFile(TrainFile):
    """A design file with a cam."""

    cam: CamSection | MotionCam
    follower: SerializeAsAny[FollowerSection]

    @property
    def seat(self) -> FollowerSeat:
        """Disc and place that the follower is built on."""
        (inner, outer), leg = self.cam.faces_mm, self.blank.edge_break_mm or 0.0
        if isinstance(self.cam, CamSection):
            radius = self.cam.base_radius_mm
        else:
            assert self.motion is not None  # a disc of this kind has one
            radius = base_circle_radius(self.cam, self.motion, self.follower)
        return FollowerSeat(base_radius=radius, faces=(inner, outer), carrying=(inner + leg, outer - leg))

    @model_validator(mode="after")
    def _follower_fits_the_disc(self) -> "DiscFile":
        kind, moved = self.follower.registered, self.motion is not None
        on_fork = isinstance(self.cam, CamSection) or self.cam.base_radius_mm is not None
        if moved and on_fork != (kind.unit == TAN):
            raise ValueError(
                Message(
                    'follower.kind is "{code}", which leans with a fork: give cam.base_radius_mm and cam.inner_face_mm '
                    "instead of cam.base_circle_radius_mm, or set follower.kind to {fitting}",
                    code=kind.code,
                    fitting=lifted_kinds(),
                )
                if kind.unit == TAN
                else Message(
                    'cam.base_radius_mm is of a rod, and follower.kind is "{code}": give cam.base_circle_radius_mm, '
                    "and remove cam.inner_face_mm",
                    code=kind.code,
                )
            )
        if not moved and kind.unit != TAN:
            raise ValueError(
                Message(
                    'follower.kind is "{code}", which {does}: set follower.kind to {fitting}, or give {give}',
                    code=kind.code,
                    does=Message("moves by its lift"),
                    fitting=fitting_kinds(moved=False),
                    give=Message("[motion] instead of [path] and [car]"),
                )
            )
        if not self.measured_base:
            kind.refuse(self.follower.keys, self.seat)
        return self

    @property
    def measured_base(self) -> bool:
        """Whether the base circle is to be found with the motion."""
        return bool(
            self.motion is not None
            and self.motion.measured
            and isinstance(self.cam, MotionCam)
            and self.cam.base_circle_radius_mm is None
        )

    @model_validator(mode="after")
    def _broken_edges_leave_a_land(self) -> "DiscFile":
        (inner, outer), leg = self.cam.faces_mm, self.blank.edge_break_mm
        # A thinner disc with sharp edges is not broken at all; rounding must not refuse the value that is named.
        if leg and outer - inner - 2 * leg < LEAST_LAND_MM - 1e-9:
            most = (outer - inner - LEAST_LAND_MM) / 2
            cure = Message("lower it to {most:.4g} or less", most=most) if most > 1e-6 else Message("leave it out")
            raise ValueError(
                Message(
                    "blank.edge_break_mm is {leg:g}; two edges broken by that leave no land of at least "
                    "{least_land_mm:g} mm for the follower on a disc {thickness:g} mm thick: {cure}, or make the disc "
                    "thicker",
                    leg=leg,
                    least_land_mm=LEAST_LAND_MM,
                    thickness=outer - inner,
                    cure=cure,
                )
            )
        return self

    @model_validator(mode="after")
    def _tabs_end_below_the_outer_face(self) -> "DiscFile":
        (inner, outer), tabs = self.cam.faces_mm, self.machining.tabs
        if tabs and tabs.height_mm >= outer - inner:
            raise ValueError(
                Message(
                    "machining.tabs.height_mm is {height_mm:g}; it must be less than the disc's thickness of "
                    "{thickness:g} mm: lower it",
                    height_mm=tabs.height_mm,
                    thickness=outer - inner,
                )
            )
        return self

    @model_validator(mode="after")
    def _drill_leaves_the_bore(self) -> "DiscFile":
        drilling, blank = self.machining.drilling, self.blank
        drill = drilling.bore_diameter_mm if drilling else None
        most = 2 * blank.d_flat.across_mm - blank.bore_diameter_mm if blank.d_flat else blank.bore_diameter_mm
        if drill is not None and drill > most + 1e-9:
            cause = Message("the circle inside the bore's flat") if blank.d_flat else "blank.bore_diameter_mm"
            raise ValueError(
                Message(
                    "machining.drilling.bore_diameter_mm is {drill:g}; it must be at most {most:g}, {cause}: lower it",
                    drill=drill,
                    most=most,
                    cause=cause,
                )
            )
        return self


class DesignFile(DiscFile):
    """A design as its file gives it, checked, with the defaults filled in."""

    path: SerializeAsAny[PathSection]
    car: CarSection
    cam: CamSection

    @model_validator(mode="after")
    def _forces_are_those_of_the_rod(self) -> "DesignFile":
        if self.dynamics is not None:
            raise ValueError(
                Message(
                    "[dynamics] is for a design with [motion], and the force on the rod of a car stands in "
                    "[mechanics]: "
                    "remove [dynamics] (on the command line with --set dynamics=)"
                )
            )
        return self

    @model_validator(mode="after")
    def _tolerances_are_those_of_the_car(self) -> "DesignFile":
        if self.lift_tolerances is not None:
            raise ValueError(
                Message(
                    "[lift_tolerances] is for a design with [motion], and a car's tolerances stand in [tolerances]: "
                    "remove [lift_tolerances] (on the command line with --set lift_tolerances=)"
                )
            )
        return self

    @model_validator(mode="after")
    def _layout_has_a_train(self) -> "DesignFile":
        if self.layout is not None and self.train is None:
            raise ValueError(
                Message(
                    "[layout] says how the gear train stands in the car, and the design has none: add [train], or "
                    "remove [layout] (on the command line with --set layout=)"
                )
            )
        if self.layout is None or self.train is None:
            return self
        shafts = self.train.on_shafts(len(self.train.stages) + 1)
        if unbored := [place for place, blank in shafts if not blank.bore_diameter_mm]:
            raise ValueError(
                Message(
                    "train.{place}.bore_diameter_mm is missing, and [layout] sets shafts against other parts: give the "
                    "diameter of the shaft, or remove [layout] (on the command line with --set layout=)",
                    place=unbored[0],
                )
            )
        stated = [stage.direction_deg is not None for stage in self.train.stages]
        if any(stated) and not all(stated):
            raise ValueError(
                Message(
                    "train.stages.{number}.direction_deg is not given, and those of other stages are: with [layout] "
                    "give all of them, or leave all out to have them found",
                    number=stated.index(False) + 1,
                )
            )
        return self

    @model_validator(mode="after")
    def _laps_need_no_blend(self) -> "DesignFile":
        if not self.path.closed:
            return self
        if "blend_deg" in self.cam.model_fields_set:
            raise ValueError(
                Message(
                    "cam.blend_deg is {blend_deg:g}, but the path is closed, so the cam leads back to its start "
                    "by itself and nothing is blended: remove cam.blend_deg (on the command line with --set "
                    "cam.blend_deg=), or remove path.closed",
                    blend_deg=self.cam.blend_deg,
                )
            )
        if self.as_built is not None:
            raise ValueError(
                Message(
                    "[as_built] describes a car on a path with an end; on a closed path a wheel or steering that "
                    "is not as designed takes the car off its lap, whatever the cam: remove [as_built], or "
                    "remove path.closed"
                )
            )
        return self

    @model_validator(mode="after")
    def _hub_ends_before_the_fork(self) -> "DesignFile":
        (inner, _), hub = self.cam.faces_mm, self.blank.hub
        if hub and hub.side == Face.INNER and hub.length_mm >= inner:
            raise ValueError(
                Message(
                    "blank.hub.length_mm is {length_mm:g}; on the inner side it must be less than the distance "
                    "of the disc's inner face from the fork axis, {inner:g} mm: lower it, or put the hub on the "
                    "outer side",
                    length_mm=hub.length_mm,
                    inner=inner,
                )
            )
        return self


# Sections of a design with [path] and [car] that one with [motion] has not.
OF_A_CAR = (
    *(
        "path",
        "field",
        "course",
        "car",
        "layout",
        "frame",
        "drive",
        "play",
        "mechanics",
        "tolerances",
        "optimize",
        "settings",
        "as_built",
    ),
)


class MotionFile(DiscFile):
    """A design file of a cam by its motion."""

    motion: MotionSection
    cam: MotionCam

    @model_validator(mode="before")
    @classmethod
    def _no_section_of_a_car(cls, values: object) -> object:
        if isinstance(values, dict) and (both := [name for name in OF_A_CAR if name in values]):
            named = listed([f"[{name}]" for name in both], "and")
            removed = " ".join(f"--set {name}=" for name in both)
            raise ValueError(
                Message(
                    "the design has [motion], which says what the follower does, and {named}, which only a "
                    "design with [path] and [car] has: remove the one (on the command line with {removed}) or "
                    "the other (--set motion=)",
                    named=named,
                    removed=removed,
                )
            )
        return values

    @model_validator(mode="before")
    @classmethod
    def _follower_is_named(cls, values: object) -> object:
        follower = values.get("follower") if isinstance(values, dict) else None
        if follower is None and isinstance(values, dict):
            unknown = [name for name in values if name not in cls.model_fields]
            if misspelt := get_close_matches("follower", unknown, 1):
                raise ValueError(
                    Message("[{wrong}] is not a section: write {heading}", wrong=misspelt[0], heading="[follower]")
                )
        if follower is None or (isinstance(follower, dict) and follower.get("kind") is None):
            raise ValueError(
                Message(
                    "follower.kind is missing, and the design has [motion]: add it to the section [follower]; it must "
                    "be {fitting}",
                    fitting=fitting_kinds(moved=True),
                )
            )
        return values

    @model_validator(mode="after")
    def _motion_fits_the_follower(self) -> "MotionFile":
        try:
            grooved = getattr(self.follower.keys, "closure", None) == Closure.GROOVE
            if not self.motion.measured:
                follower_motion(self.motion, self.follower.registered, corners=not grooved)
            if self.dynamics is not None:
                self.dynamics.refuse(self.follower.registered, self.follower.keys, self.cam.thickness_mm)
            if self.lift_tolerances is not None:
                self.lift_tolerances.refuse(self.follower.registered)
        except DesignError as error:
            from cadgen.laws.segments import VelocityJumpError  # with numpy, for which sound designs need not wait

            refused = error.tried(self._refusal_with) if isinstance(error, VelocityJumpError) else error
            raise ValueError(refused.message) from None
        return self

    @model_validator(mode="after")
    def _programs_are_made(self) -> "MotionFile":
        given = [key for key in ("tabs", "drilling") if getattr(self.machining, key) is not None]
        if given and getattr(self.follower.keys, "closure", None) == Closure.GROOVE:
            raise ValueError(
                Message(
                    "machining.{key} is of the programs of an outline, and a groove has one that mills the groove "
                    "alone: remove it (on the command line with --set machining.{key}=)",
                    key=given[0],
                )
            )
        return self

    def _refusal_with(self, changes: Mapping[str, object]) -> Message | None:
        """Refusal of the design with changed keys, by its motion and by its follower; None if neither refuses it.

        Args:
            changes: new value by key; items of lists count from 1.
        """
        values = self.model_dump(mode="json", include=set(MotionFile.model_fields) - set(OF_A_CAR), exclude_none=True)
        try:
            for key, value in changes.items():
                *sections, last = key.split(".")
                section: Any = values
                for part in sections:
                    section = section[int(part) - 1 if part.isdigit() else part]
                section[last] = value
            changed = MotionFile.model_validate(values)
            kind = changed.follower.registered
            follower = kind.follower(changed.follower.keys, changed.seat)
            follower.refuse(follower_motion(changed.motion, kind))
        except DesignError as error:
            return error.message
        except ValidationError as error:
            first = error.errors()[0]
            return Message(str(first.get("ctx", {}).get("error", first["msg"])))
        return None


class TrainDesign(TrainFile):
    """A design with where it comes from, as far as its gear train needs it.

    Attributes:
        source: name of the file it was read from, without its folder.
        overrides: the `--set` arguments applied, in order.
    """

    source: str
    overrides: tuple[str, ...] = ()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the values: sections of registered kinds have classes that are made when a design is read."""
        return _read_again, (type(self), self.values(), self.source, self.overrides)

    def values(self) -> dict[str, object]:
        """Values of all keys, defaults included, as plain TOML or JSON values; no blend where the path is closed."""
        unused: dict[str, Any] | None = {"cam": {"blend_deg"}} if self.path and self.path.closed else None
        if self.motion is not None:
            unused = dict.fromkeys(OF_A_CAR, True)
        return self.model_dump(mode="json", include=set(DesignFile.model_fields), exclude=unused, exclude_none=True)

    @property
    def content_hash(self) -> str:
        """SHA-256 of the canonical JSON of `values()`: it depends on the values, not on the way they are written.

        The texts of title blocks are left out: with others the same part is cut.
        """
        canonical = json.dumps(
            {key: value for key, value in self.values().items() if key != "drawing"},
            sort_keys=True,
            separators=(",", ":"),
            allow_nan=False,
        )
        return hashlib.sha256(canonical.encode()).hexdigest()


class Design(DesignFile, TrainDesign):
    """A whole design: path, car, cam and follower are there."""

    def as_designed(self) -> "Design":
        """Design without what is known of the car as it was built."""
        return self.model_copy(update={"as_built": None})

    def as_cut(self) -> "Design":
        """Design that the measured cam was made from: this one with the deviations known by then."""
        known = self.as_built.cut_for if self.as_built else ()
        return self.model_copy(update={"as_built": AsBuiltSection(effects=known) if known else None})


class MotionDesign(MotionFile, TrainDesign):
    """A whole design of a cam by its motion."""


def whole_design(design: TrainDesign) -> Design:
    """The whole design of one that was read for its train.

    Raises:
        DesignError: it has no car, with what is missing.
    """
    if isinstance(design, Design):
        return design
    lacking = [f"[{name}]" for name in ("path", "car", "cam", "follower") if getattr(design, name) is None]
    if lacking:
        raise DesignError(
            "{source} has [layout], which says how the train stands in a car, and lacks {lacking}: add it, or remove "
            "[layout] (on the command line with --set layout=)",
            source=design.source,
            lacking=listed(lacking, "and"),
        )
    made = _read_again(Design, design.values(), design.source, design.overrides)
    assert isinstance(made, Design)
    return made


def _read_again(made: type[TrainDesign], values: dict[str, object], source: str, overrides: tuple[str, ...]) -> object:
    """The design of values that were pickled."""
    schema: type[TrainFile] = next(
        each
        for design, each in ((MotionDesign, MotionFile), (Design, DesignFile), (TrainDesign, TrainFile))
        if issubclass(made, design)
    )
    unused = OF_A_CAR if schema is MotionFile else ()
    checked = {name: value for name, value in schema.model_validate(values) if name not in unused}
    return made(**checked, source=source, overrides=overrides)
