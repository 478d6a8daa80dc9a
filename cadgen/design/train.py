"""Sections of the gear train; a stage's keys are those of the kind that it names, by default a pair of spur gears."""

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any

from annotated_types import Gt, Le
from pydantic import Field, SerializeAsAny, Strict, WrapValidator, create_model, model_validator

from cadgen.design.blank import Held
from cadgen.design.section import (
    HERE,
    WORD,
    ByKind,
    CellText,
    DesignSection,
    Feature,
    FeatureOrNone,
    FitName,
    OneOf,
    keys_in,
    listed,
    section_with,
)
from cadgen.errors import DesignError
from cadgen.gears.choices import HelixHand, SearchObjective, Thinning, ToleranceStandard, ToothCutting
from cadgen.gears.stage_kind import StageKind
from cadgen.gears.stage_kinds import SPUR, codes, has, kind_of
from cadgen.messages import Message


class GearKeys(DesignSection):
    """Gear of a stage. Tolerances given here stand in for those of the standards."""

    teeth: int = Field(ge=4, le=1000, description="z, number of teeth")
    profile_shift: float = Field(
        default=0.0,
        ge=-2,
        le=2,
        description="x, in modules; above 0 it makes the tooth thicker, of a ring too (ISO 21771; KHK and JGMA count a "
        "ring's the other way round)",
    )
    module_mm: float | None = Field(default=None, gt=0, le=10, description="m_n; left out, that of the train")
    pressure_angle_deg: float | None = Field(
        default=None, ge=10, le=35, description="alpha_n; left out, that of the train"
    )
    E_sn_um: float | None = Field(
        default=None,
        ge=-1e4,
        le=1e4,
        description="thickness deviation that it is cut to, negative for thinner teeth; left out, that of the train",
    )
    E_sns_um: float | None = Field(
        default=None, ge=-1e4, le=1e4, description="upper limit of that deviation, with T_sn_um in place of E_sn_um"
    )
    T_sn_um: float | None = Field(
        default=None, gt=0, le=1e4, description="width of the zone of the thickness; left out, that of the grade"
    )
    hand: Annotated[HelixHand | None, WORD] = Field(
        default=None,
        description="of a helical gear: `right` turns clockwise as it goes away; left out, `right` for the "
        "driver and what meshes with it for the driven gear",
    )
    width_mm: float | None = Field(default=None, gt=0, le=500, description="b; left out, that of the train")
    grade: int | None = Field(default=None, ge=3, le=12, description="tolerance grade; left out, that of the train")
    addendum_factor: float | None = Field(
        default=None,
        gt=0,
        le=3,
        description="h_aP*, in modules; left out, that of the train, and of a ring no more than its pinion allows",
    )
    internal: bool | None = Field(
        default=None, description="whether it is a ring with teeth inside; left out, it is none"
    )
    rim_mm: float | None = Field(
        default=None, gt=0, le=500, description="of a ring, outside its root; left out, 2.5 modules"
    )
    cutter_teeth: int | None = Field(
        default=None,
        ge=0,
        le=500,
        description="of a ring, z_0 of its pinion cutter; 0 for roots that are arcs; left out, 25 or what suits it",
    )
    root_radius_factor: float | None = Field(
        default=None,
        gt=0,
        le=1,
        description="of a ring, tip radius of the cutter or radius of the arc, in modules; left out, 0.2 or 0.38, or "
        "what has room",
    )
    f_pt_um: float | None = Field(default=None, ge=0, le=1e4, description="single pitch deviation")
    F_beta_um: float | None = Field(default=None, ge=0, le=1e4, description="total helix deviation")
    F_r_um: float | None = Field(default=None, ge=0, le=1e4, description="radial runout")
    b_r_um: float | None = Field(default=None, ge=0, le=1e4, description="radial feed when cutting the teeth")
    F_i_radial_um: float | None = Field(
        default=None, ge=0, le=1e4, description="F_i'', total radial composite deviation"
    )

    @model_validator(mode="after")
    def _one_thickness(self) -> "GearKeys":
        if self.E_sns_um is not None and self.E_sn_um is not None:
            raise ValueError(Message("{here}.E_sn_um and E_sns_um are both given: remove one of them", here=HERE))
        if self.E_sns_um is not None and self.T_sn_um is None:
            raise ValueError(Message("{here}.E_sns_um needs the width of its zone: give T_sn_um", here=HERE))
        return self

    @model_validator(mode="after")
    def _keys_of_a_ring(self) -> "GearKeys":
        if self.internal:
            return self
        for key in ("rim_mm", "cutter_teeth", "root_radius_factor"):
            if getattr(self, key) is not None:
                raise ValueError(
                    Message("{here}.{key} is a key of a ring: add internal = true, or remove it", here=HERE, key=key)
                )
        return self


class StageSection(DesignSection):
    """Stage of the train, the first one next to the drive. One table [[train.stages]] for each."""

    kind: Annotated[str | None, OneOf(lambda: (SPUR, *codes()), lambda code: code == SPUR or has(code))] = Field(
        default=None, description="which kind of stage; left out, a pair of spur gears"
    )
    bearing_span_mm: float | None = Field(default=None, gt=0, le=5000, description="l; left out, that of the train")
    direction_deg: float | None = Field(
        default=None,
        ge=-360,
        le=360,
        description="of the line from the driver's axis to the driven gear's; left out, one is found that clears",
    )

    @property
    def registered(self) -> StageKind:
        """Kind that it names, which is not that of spur gears."""
        return kind_of(str(self.kind))

    @property
    def keys(self) -> Any:
        """Values as the dataclass of that kind."""
        return keys_in(self, self.registered.keys)


class SpurStage(StageSection):
    """Stage of the train, the first one next to the drive. One table [[train.stages]] for each."""

    centre_distance_mm: float | None = Field(
        default=None,
        gt=0,
        le=2000,
        description="a; left out, that at which teeth of nominal thickness have no play",
    )
    f_a_um: float | None = Field(
        default=None, ge=0, le=1e4, description="deviation of the centre distance; left out, the standard's"
    )
    backlash_um: float | None = Field(
        default=None,
        ge=0,
        le=1e4,
        description="j_wt that the teeth are thinned to, on the working pitch circles; left out, that of their grade",
    )
    backlash_deg: float | None = Field(
        default=None, ge=0, le=45, description="free angle of the driven gear, in place of backlash_um"
    )
    backlash_share: float | None = Field(
        default=None, ge=0, le=1, description="share of the thinning that the driver takes; left out, a half"
    )
    helix_angle_deg: float | None = Field(
        default=None, ge=0, le=45, description="beta at the reference circle; left out, that of the train"
    )
    double: bool | None = Field(
        default=None, description="whether the helix turns back at half the width; left out, it does not"
    )
    driver: GearKeys
    driven: GearKeys

    @model_validator(mode="after")
    def _one_backlash(self) -> "SpurStage":
        thick = [gear.E_sn_um is not None or gear.E_sns_um is not None for gear in (self.driver, self.driven)]
        if self.backlash_um is not None and self.backlash_deg is not None:
            raise ValueError(
                Message("{here}.backlash_um and backlash_deg are both given: remove one of them", here=HERE)
            )
        if self.backlash_um is None and self.backlash_deg is None:
            if self.backlash_share is not None:
                raise ValueError(
                    Message("{here}.backlash_share needs a backlash that is shared: give backlash_um", here=HERE)
                )
            return self
        if all(thick):
            raise ValueError(
                Message(
                    "{here} has a backlash and the thickness of both gears, of which two decide the third: remove "
                    "driven.E_sn_um",
                    here=HERE,
                )
            )
        return self


@cache
def stage_section(kind: StageKind | None) -> type[StageSection]:
    """Section with the keys of a kind; None for spur gears."""
    return SpurStage if kind is None else section_with(StageSection, kind.meaning, kind.keys)


STAGE = ByKind[StageKind | None, StageSection](
    "kind",
    SPUR,
    lambda code: code == SPUR or has(code),
    lambda code: None if code == SPUR else kind_of(code),
    stage_section,
)


def stage_kinds(values: object) -> tuple[StageKind | None, ...]:
    """Kinds that the raw values of a design name for its stages, in their order."""
    train = values.get("train") if isinstance(values, dict) else None
    stages = train.get("stages") if isinstance(train, dict) else getattr(train, "stages", None)
    return tuple(STAGE.kind(stage) for stage in stages) if isinstance(stages, list | tuple) else ()


def _checked(value: object, otherwise: Callable[[object], StageSection]) -> StageSection:
    """Check one stage by the keys of its kind."""
    if isinstance(value, dict):
        return STAGE.check(value, otherwise)
    return value if isinstance(value, StageSection) else SpurStage.model_validate(value)


StageItem = Annotated[SerializeAsAny[StageSection], WrapValidator(_checked)]


# All orders of so many stages, 5040, are compared within a second; ten would take an hour.
MOST_STAGES = 7
MOST_SIZES = 100  # modules or widths to choose from

Lengths = Annotated[tuple[Annotated[float, Gt(0), Le(500)], ...], Strict(False)]


class GearKeyway(DesignSection):
    """A keyway in the bore, under a tooth of the larger gear."""

    width_mm: Feature = Field(le=100, description="b, width of the keyway")
    depth_mm: Feature = Field(le=50, description="t2: bore and keyway span the bore's diameter and this")


class GearFlat(DesignSection):
    """A flat in the bore, under a tooth of the larger gear, for a D-shaft."""

    across_mm: Feature = Field(
        le=200, description="from the flat to the bore's far side; more than half the bore's diameter"
    )


class GearHub(DesignSection):
    """A round hub on the outer face of a gear. Between the two gears of an intermediate shaft it is their collar.

    Without one there, they get a collar as thick as their roots allow, so that the wheels of neighbouring stages do
    not rub: 1 mm long, or twice clearance_mm if that is more, and longer where gears stand out over those in mesh with
    them, or where a stated tool needs more room.
    """

    diameter_mm: Feature = Field(le=1000, description="outer diameter of the hub")
    length_mm: FeatureOrNone = Field(default=0.0, le=200, description="how far it stands out of the face")
    set_screw_mm: FeatureOrNone = Field(
        default=0.0, le=50, description="diameter of a radial hole through it; 0 for none"
    )
    set_screw_thread: CellText | None = Field(
        default=None, description="to be tapped in that hole, such as `M3`; for the drawing"
    )

    @model_validator(mode="after")
    def _thread_has_its_hole(self) -> "GearHub":
        if self.set_screw_thread is not None and not self.set_screw_mm:
            raise ValueError(
                Message("{here}.set_screw_thread needs the hole that it is tapped in: give set_screw_mm", here=HERE)
            )
        return self


class GearWeb(DesignSection):
    """A thinner disc between hub and rim."""

    thickness_mm: Feature = Field(le=500, description="thickness of the web")
    rim_mm: Feature = Field(le=500, description="thickness of the rim under the teeth's root")


class GearLightening(DesignSection):
    """A ring of equal round holes midway between rim and hub."""

    holes: int = Field(ge=1, le=360, description="number of holes")
    hole_diameter_mm: Feature = Field(le=500, description="of each hole")


class GearBlankSection(Held):
    """Features of a shaft's gear besides its teeth; on an intermediate shaft, the driven gear of its two.

    A joint on an intermediate shaft is that between its wheel and its pinion, which are one piece without it.
    """

    bore_diameter_mm: FeatureOrNone = Field(default=0.0, le=500, description="of the hole for the shaft; 0 for none")
    bore_fit: FitName | None = Field(
        default=None, max_length=20, description="of the bore on its shaft by ISO 286, such as `H7/h6`; for the drawing"
    )
    material: CellText | None = Field(default=None, description="for the drawing; left out, that of the train")
    cutting: Annotated[ToothCutting | None, WORD] = Field(
        default=None, description="how its teeth are cut; left out, as those of the train"
    )
    cut_apart: bool | None = Field(
        default=None,
        description="whether the two gears of the shaft are cut as two parts, each with files and a sheet, "
        "and joined by `joint`; left out, they are one piece",
    )
    shaft_ends: bool | None = Field(
        default=None,
        description="whether the shaft ends at its gears, in bearings of its own, and leaves room beyond; left out, "
        "only where another one stands on its axis",
    )
    bore_flats: int | None = Field(
        default=None,
        ge=4,
        le=6,
        description="4 for a square bore, 6 for a hexagonal one, with a flat under a tooth; bore_diameter_mm is then "
        "its size across flats",
    )
    keyway: GearKeyway | None = None
    d_flat: GearFlat | None = None
    hub: GearHub | None = None
    web: GearWeb | None = None
    lightening: GearLightening | None = None

    @model_validator(mode="after")
    def _one_shape_of_bore(self) -> "GearBlankSection":
        bore, shapes = self.bore_diameter_mm, ("keyway", "d_flat", "bore_flats")
        given = [name for name in shapes if getattr(self, name) is not None]
        if len(given) > 1:
            raise ValueError(
                Message(
                    "{here} has {one} and {other}, which exclude each other: remove {here}.{one}",
                    here=HERE,
                    one=given[0],
                    other=given[1],
                )
            )
        if self.bore_flats == 5:
            raise ValueError(
                Message("{here}.bore_flats is 5; it must be 4 for a square, or 6 for a hexagon", here=HERE)
            )
        if given and given[0] != "keyway" and not bore:
            raise ValueError(
                Message("{here}.{key} needs a bore: give {here}.bore_diameter_mm", here=HERE, key=given[0])
            )
        if self.d_flat and not bore / 2 < self.d_flat.across_mm < bore:
            raise ValueError(
                Message(
                    "{here}.d_flat.across_mm is {across:g}; it must lie between {half:g} and {bore:g}, half of the "
                    "bore and all of it",
                    here=HERE,
                    across=self.d_flat.across_mm,
                    half=bore / 2,
                    bore=bore,
                )
            )
        return self

    @model_validator(mode="after")
    def _parts_are_joined(self) -> "GearBlankSection":
        if self.cut_apart and self.joint is None:
            raise ValueError(
                Message('{here}.cut_apart needs what joins the gears: give {here}.joint, such as "glued"', here=HERE)
            )
        return self

    @model_validator(mode="after")
    def _bore_fit_is_of_the_bore(self) -> "GearBlankSection":
        if self.bore_fit is not None and not self.bore_diameter_mm:
            raise ValueError(Message("{here}.bore_fit needs the bore that it is of: give bore_diameter_mm", here=HERE))
        return self


class ShaftSection(GearBlankSection):
    """Features of one shaft between drive and output, instead of those of [train.intermediate].

    One table [[train.shafts]] for each such shaft.
    """

    shaft: int = Field(
        ge=2, le=MOST_STAGES, description="its number: 1 is the drive's shaft, 2 that behind the first stage"
    )


class PlateSection(DesignSection):
    """The plates that hold the axes of the train, for their drawing."""

    material: CellText | None = Field(default=None, description="of the plates, such as `plywood 5 mm`")
    hole_fit: FitName | None = Field(
        default=None, max_length=20, description="of the holes and the shafts in them by ISO 286, such as `H7/h6`"
    )
    thickness_mm: Feature | None = Field(
        default=None,
        le=200,
        description="of the plates, which are then made as STEP, too; left out, their sheet has the "
        "width of their widest bearing, or the diameter of the thickest shaft where shafts run in the holes",
    )
    bearing_bores_mm: Annotated[tuple[Annotated[FeatureOrNone, Le(500)], ...], Strict(False)] | None = Field(
        default=None,
        min_length=1,
        max_length=8,
        description="diameters of the holes for bearings, one for all shafts or one each from the drive on, 0 for "
        "none; left out, as large as the shafts",
    )


class SearchSection(DesignSection):
    """Within what limits `--order search` looks for trains. Sizes left out span those of the given stages."""

    stages: int | None = Field(
        default=None, ge=1, le=6, description="how many stages at most; left out, as many as given"
    )
    teeth_min: int | None = Field(default=None, ge=4, le=1000, description="fewest teeth of a gear")
    teeth_max: int | None = Field(default=None, ge=4, le=1000, description="most teeth of a gear")
    modules_mm: Lengths | None = Field(
        default=None, min_length=1, max_length=MOST_SIZES, description=f"modules to choose from, at most {MOST_SIZES}"
    )
    widths_mm: Lengths | None = Field(
        default=None,
        min_length=1,
        max_length=MOST_SIZES,
        description=f"face widths to choose from, at most {MOST_SIZES}",
    )
    centre_distance_min_mm: float | None = Field(default=None, gt=0, le=2000, description="least centre distance")
    centre_distance_max_mm: float | None = Field(default=None, gt=0, le=2000, description="greatest centre distance")
    stage_ratio_min: float | None = Field(
        default=None,
        gt=0,
        le=1000,
        description="least ratio of a stage; left out, 1, so that none speeds up, or that of a given stage that does",
    )
    stage_ratio_max: float | None = Field(
        default=None,
        gt=0,
        le=1000,
        description="greatest ratio of a stage; left out, 10, or that of a given stage if it has more",
    )
    contact_ratio_min: float | None = Field(
        default=None,
        ge=1.1,
        le=3,
        description="least contact ratio of a stage, as cut; left out, 1.2, or that of a given stage if it has less",
    )
    undercut_max: float | None = Field(
        default=None,
        ge=0,
        le=2,
        description="greatest undercut of a gear, as cut: the profile shift, in modules, that it lacks to be free of "
        "it; 0 for none; left out, 0.5, or that of a given gear if it has more",
    )
    ratio_tolerance: float = Field(default=0.0, ge=0, lt=1, description="relative error allowed for the total ratio")
    keep: int = Field(default=10, ge=1, le=1000, description="how many trains are reported")
    objective: Annotated[SearchObjective | None, WORD] = Field(
        default=None,
        description="what the best train has least of: `return_error`, or of those on the front `size`, the sum of the "
        "centre distances, or `losses`, the sum of the loss factors of the teeth; left out, `return_error`",
    )
    front: bool | None = Field(
        default=None,
        description="whether the Pareto front of return error and size is told: the trains that no other beats in "
        "both; left out, only for `size` and `losses`",
    )
    losses: bool | None = Field(
        default=None,
        description="whether the losses of the teeth count in the front, too; left out, only for `losses`",
    )


class TrainSection(DesignSection):
    """The gear train that drives the camshaft, of spur or helical gears. `cadgen gears` needs it."""

    module_mm: float = Field(gt=0, le=10, description="m_n, normal module")
    pressure_angle_deg: float = Field(default=20.0, ge=10, le=35, description="alpha_n, normal pressure angle")
    helix_angle_deg: float | None = Field(
        default=None,
        ge=0,
        le=45,
        description="beta at the reference circle of every gear; 0 or left out, spur gears",
    )
    width_mm: Feature = Field(le=500, description="b, face width")
    bearing_span_mm: float = Field(gt=0, le=5000, description="l, between the bearings of a shaft")
    bearing_clearance_um: float | None = Field(
        default=None,
        ge=0,
        le=1000,
        description="by which a shaft can move across its bearings; it opens every mesh; left out, none",
    )
    friction_coefficient: float | None = Field(
        default=None,
        ge=0,
        le=1,
        description="mu of the flanks, for the losses of the teeth; left out, these are not told",
    )
    friction_source: CellText | None = Field(
        default=None, description="where friction_coefficient is from, such as `measured, POM dry`"
    )
    grade: int = Field(default=7, ge=3, le=12, description="tolerance grade of ISO 1328")
    standard: Annotated[ToleranceStandard | None, WORD] = Field(
        default=None,
        description="of tolerances that are left out: `iso`, or `free` for none, as for sizes that ISO 1328 does not "
        "cover; left out, `iso`",
    )
    thinning: Annotated[Thinning, WORD] = Field(
        default=Thinning.MIDDLE,
        description="what the teeth are cut to: E_sns, the middle between both limits, or E_sni; their zone, T_sn "
        "wide, lies about it",
    )
    E_sn_um: float | None = Field(
        default=None,
        ge=-1e4,
        le=1e4,
        description="tooth thickness deviation that all gears are cut to instead, negative for thinner teeth",
    )
    addendum_factor: float = Field(default=1.0, gt=0, le=3, description="h_aP*, addendum in modules")
    dedendum_factor: float = Field(default=1.25, gt=0, le=3, description="h_fP*, of the basic rack, in modules")
    rack_tip_radius_factor: float = Field(
        default=0.38, gt=0, le=1, description="rho_fP*, of the basic rack, in modules"
    )
    tip_chamfer_mm: FeatureOrNone = Field(default=0.0, le=10, description="leg of the chamfer at the tips; 0 for none")
    pin_diameter_mm: float | None = Field(
        default=None, gt=0, le=50, description="D_M, of the pins for inspection; left out, one to suit each gear"
    )
    clearance_mm: float = Field(
        default=0.3, gt=0, le=100, description="least gap between bodies on different shafts, teeth in mesh apart"
    )
    material: CellText | None = Field(default=None, description="of the gears, such as `POM`; for their drawings")
    cutting: Annotated[ToothCutting | None, WORD] = Field(
        default=None,
        description="how the teeth are cut: `hobbed`, `shaped`, `milled` with a disc cutter, by a `wire`, a laser or a "
        "jet through the whole width, or `printed` or moulded; gears beside larger ones on a shaft then need room "
        "for it; left out, not stated",
    )
    cutter_diameter_mm: float | None = Field(
        default=None,
        gt=0,
        le=500,
        description="of the hob or the disc cutter; left out, that of DIN 8002 for the module",
    )
    stages: Annotated[tuple[StageItem, ...], Strict(False)] = Field(
        min_length=1, max_length=MOST_STAGES, description=f"at least one, and at most {MOST_STAGES}"
    )
    drive: GearBlankSection = GearBlankSection()
    intermediate: GearBlankSection = GearBlankSection()
    output: GearBlankSection = GearBlankSection()
    shafts: Annotated[tuple[ShaftSection, ...], Strict(False)] | None = Field(
        default=None, min_length=1, max_length=MOST_STAGES - 1
    )
    plate: PlateSection | None = None
    search: SearchSection = SearchSection()

    def on_shafts(self, shafts: int) -> tuple[tuple[str, GearBlankSection], ...]:
        """Features of each shaft and their place in the section, from the drive to the output.

        Args:
            shafts: number of shafts.
        """
        own = {each.shaft: (f"shafts.{place}", each) for place, each in enumerate(self.shafts or (), 1)}
        usual = ("intermediate", self.intermediate)
        between = (own.get(number, usual) for number in range(2, shafts))
        return (("drive", self.drive), *between, ("output", self.output))

    @model_validator(mode="after")
    def _shafts_are_those_between(self) -> "TrainSection":
        most, seen = max(len(self.stages), self.search.stages or 1), dict[int, int]()
        for place, each in enumerate(self.shafts or (), 1):
            if most < 2:
                raise ValueError(
                    Message(
                        "train.shafts is for the shafts between drive and output, and a train of one stage has none: "
                        "remove it"
                    )
                )
            if each.shaft > most:
                raise ValueError(
                    Message(
                        "train.shafts.{place}.shaft is {shaft}, which is not between drive and output; it must be "
                        "{least} to {most}",
                        place=place,
                        shaft=each.shaft,
                        least=2,
                        most=most,
                    )
                )
            if each.shaft in seen:
                raise ValueError(
                    Message(
                        "train.shafts.{place}.shaft and train.shafts.{other}.shaft are both {shaft}: remove one of "
                        "the two",
                        place=place,
                        other=seen[each.shaft],
                        shaft=each.shaft,
                    )
                )
            seen[each.shaft] = place
        return self

    @model_validator(mode="after")
    def _two_gears_are_cut_apart(self) -> "TrainSection":
        for place, blank in (("drive", self.drive), ("output", self.output)):
            if blank.cut_apart:
                raise ValueError(
                    Message("train.{place}.cut_apart is of a shaft with two gears: remove it", place=place)
                )
        return self

    @model_validator(mode="after")
    def _cutter_is_a_tool(self) -> "TrainSection":
        diameter = self.cutter_diameter_mm
        if diameter is None:
            return self
        from cadgen.gears.tools import LEAST_CUTTER, ROTATING, usual_hob

        stated = [each.cutting or self.cutting for _, each in self.on_shafts(len(self.stages) + 1)]
        if not any(each is None or each in ROTATING for each in stated):
            raise ValueError(
                Message(
                    "train.cutter_diameter_mm is of a hob or a disc cutter, and no teeth are hobbed or milled: "
                    "remove it"
                )
            )
        pairs = [(stage.driver, stage.driven) for stage in self.stages if isinstance(stage, SpurStage)]
        module = max((gear.module_mm or self.module_mm for pair in pairs for gear in pair), default=self.module_mm)
        if diameter < LEAST_CUTTER * module:
            raise ValueError(
                Message(
                    "train.cutter_diameter_mm is {diameter:g}, and teeth of the module {module:g} would take more than "
                    "half of such a tool: give at least {least:g}, or leave it out for the usual {usual:g}",
                    diameter=diameter,
                    module=module,
                    least=LEAST_CUTTER * module,
                    usual=usual_hob(module),
                )
            )
        return self

    @model_validator(mode="after")
    def _friction_has_its_source(self) -> "TrainSection":
        if (self.friction_coefficient is None) != (self.friction_source is None):
            raise ValueError(
                Message(
                    "train.friction_coefficient and train.friction_source go together: give both, such as 0.1 and "
                    '"estimated"'
                )
            )
        return self

    @model_validator(mode="after")
    def _fits_are_of_sizes_in_the_table(self) -> "TrainSection":
        from cadgen.gears.fits import zones_of

        own = [(f"shafts.{place}", each) for place, each in enumerate(self.shafts or (), 1)]
        for place, blank in (
            *(("drive", self.drive), ("intermediate", self.intermediate), ("output", self.output)),
            *own,
        ):
            holes = self.plate.hole_fit if self.plate else None
            for key, fit in ((f"train.{place}.bore_fit", blank.bore_fit), ("train.plate.hole_fit", holes)):
                try:
                    if fit is not None:
                        zones_of(fit, blank.bore_diameter_mm)
                except DesignError as error:
                    raise ValueError(Message("{key}: {error}", key=key, error=error.message)) from None
        return self


# A train without spur gears needs neither module nor width.
_TOOTHLESS: type[TrainSection] = create_model(
    "TrainSection",
    __base__=TrainSection,
    __doc__=TrainSection.__doc__,
    module_mm=(float | None, Field(default=None, gt=0, le=10)),
    width_mm=(float | None, Field(default=None, gt=0, le=500)),
)


# Keys of teeth: in a train without any they would do nothing.
_TEETH = (
    *(
        "module_mm",
        "helix_angle_deg",
        "width_mm",
        "pressure_angle_deg",
        "grade",
        "standard",
        "thinning",
        "E_sn_um",
        "addendum_factor",
        "dedendum_factor",
    ),
    *("rack_tip_radius_factor", "tip_chamfer_mm", "pin_diameter_mm", "cutting", "cutter_diameter_mm"),
)


def train_by_stages(value: object, usual: Callable[[object], TrainSection | None]) -> TrainSection | None:
    """Check a section by the kinds of its stages.

    Args:
        value: values as the file has them.
        usual: check of a train with spur gears.

    Raises:
        ValueError: keys of teeth in a train without spur gears.
    """
    kinds = stage_kinds({"train": value})
    if not kinds or any(kind is None or kind.toothed for kind in kinds):
        return usual(value)
    train = _TOOTHLESS.model_validate(value)
    usually = _TOOTHLESS.model_fields
    if idle := [f"train.{key}" for key in _TEETH if getattr(train, key) != usually[key].default]:
        raise ValueError(
            Message(
                "{listed} {word} of spur gears, and no stage of this train has any: remove {them}",
                listed=listed(idle, "and"),
                word=Message("are") if len(idle) > 1 else Message("is"),
                them=Message("them") if len(idle) > 1 else Message("it"),
            )
        )
    return train
