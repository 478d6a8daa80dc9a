"""From a design's [train] to what the gear rooms work on: mm and rad."""

from collections.abc import Sequence
from math import radians
from typing import TypeVar

from cadgen.design.schema import TrainDesign
from cadgen.design.section import listed
from cadgen.design.train import Blank, GearKeys, Stage
from cadgen.design.train import Train as TrainKeys
from cadgen.errors import DesignError
from cadgen.gears.blank import GearBlank, Hub, Keyway, Lightening, Web
from cadgen.gears.layout import Blanks
from cadgen.gears.limits import SearchLimits
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Gear, GearPair, Train

T = TypeVar("T", int, float)

_UM = 1e-3
# Chord error of a gear's mesh where the design gives none, per mm of module: the teeth of all sizes then have as many
# facets, and the volume errs by less than 2e-4. No coarser than the cam's own default, in mm.
CHORD_PER_MODULE = 2e-3
COARSEST_CHORD = 5e-3
_OVERRIDES = ("f_pt", "F_beta", "F_r", "b_r", "F_i_radial")


def train_keys(design: TrainDesign) -> TrainKeys:
    """The section [train].

    Raises:
        DesignError: the design has none.
    """
    if design.train is None:
        raise DesignError(
            f"{design.source} has no gear train: add a section [train] with module_mm, width_mm and bearing_span_mm, "
            "a [[train.stages]] for each stage, and in it a driver and a driven gear with their teeth"
        )
    return design.train


def train(design: TrainDesign) -> Train:
    """The stages of the design, from the drive to the camshaft, as nominal gears with their tolerances.

    Raises:
        DesignError: the design has no [train], or a gear or a stage cannot be; it names the stage.
    """
    keys = train_keys(design)
    stages = []
    for number, stage in enumerate(keys.stages, 1):
        try:
            stages.append(_pair(stage, keys))
        except DesignError as error:
            raise DesignError(f"in stage {number}, {error}") from error
    return Train(tuple(stages))


def blanks(design: TrainDesign) -> Blanks:
    """What the gears have besides their teeth, by their place in the train."""
    keys = train_keys(design)
    return Blanks(drive=_blank(keys.drive), intermediate=_blank(keys.intermediate), output=_blank(keys.output))


def directions(design: TrainDesign) -> tuple[float | None, ...]:
    """Direction of every stage's line of centres in rad; None where any will do."""
    given = (stage.direction_deg for stage in train_keys(design).stages)
    return tuple(None if angle is None else radians(angle) for angle in given)


def search_limits(design: TrainDesign, given: Train) -> SearchLimits:
    """Limits of the search: those of [train.search], and where it says nothing the sizes of the `given` train.

    Raises:
        DesignError: limits that are empty or out of range.
    """
    keys = train_keys(design).search
    spans = SearchLimits.like(given)
    return SearchLimits(
        ratio=given.ratio,
        stages=keys.stages or spans.stages,
        teeth=_range(spans.teeth, keys.teeth_min, keys.teeth_max),
        modules=keys.modules_mm or spans.modules,
        widths=keys.widths_mm or spans.widths,
        centre_distance=_range(spans.centre_distance, keys.centre_distance_min_mm, keys.centre_distance_max_mm),
        bearing_span=spans.bearing_span,
        pattern=spans.pattern,
        stage_ratio=_range(spans.stage_ratio, keys.stage_ratio_min, keys.stage_ratio_max),
        contact_ratio=spans.contact_ratio if keys.contact_ratio_min is None else keys.contact_ratio_min,
        undercut=spans.undercut if keys.undercut_max is None else keys.undercut_max,
        ratio_tolerance=keys.ratio_tolerance,
        keep=keys.keep,
    )


def limits_left_out(design: TrainDesign) -> str:
    """The limits of [train.search] that are not in the design, listed."""
    keys = train_keys(design).search
    return listed([name for name, value in keys.model_dump().items() if value is None], "and")


def mesh_chord(design: TrainDesign, gears: Sequence[GearForm]) -> float:
    """Greatest chord error of a part's mesh in mm: the design's, or in proportion to the least module of its gears."""
    given = design.export.mesh_chord_um
    if given is not None:
        return given * _UM
    return min(CHORD_PER_MODULE * min(gear.normal_module for gear in gears), COARSEST_CHORD)


def _range(spans: tuple[T, T], low: T | None, high: T | None) -> tuple[T, T]:
    return spans[0] if low is None else low, spans[1] if high is None else high


def _pair(stage: Stage, train: TrainKeys) -> GearPair:
    return GearPair(
        driver=_gear(stage.driver, train),
        driven=_gear(stage.driven, train),
        centre_distance=stage.centre_distance_mm,
        bearing_span=stage.bearing_span_mm or train.bearing_span_mm,
        centre_distance_deviation=None if stage.f_a_um is None else stage.f_a_um * _UM,
    )


def _gear(gear: GearKeys, train: TrainKeys) -> Gear:
    angle = train.pressure_angle_deg if gear.pressure_angle_deg is None else gear.pressure_angle_deg
    form = GearForm(
        teeth=gear.teeth,
        normal_module=gear.module_mm or train.module_mm,
        width=gear.width_mm or train.width_mm,
        normal_pressure_angle=radians(angle),
        profile_shift=gear.profile_shift,
        addendum_factor=train.addendum_factor,
        dedendum_factor=train.dedendum_factor,
        rack_tip_radius_factor=train.rack_tip_radius_factor,
        tip_chamfer=train.tip_chamfer_mm,
    )
    given = {name: getattr(gear, f"{name}_um") for name in _OVERRIDES}
    overrides = {name: value * _UM for name, value in given.items() if value is not None}
    return Gear(
        form=form,
        grade=gear.grade or train.grade,
        overrides=ToleranceOverrides(**overrides),
        thinning=train.thinning if train.E_sn_um is None else train.E_sn_um * _UM,
    )


def _blank(keys: Blank) -> GearBlank:
    key, hub, web, holes = keys.keyway, keys.hub, keys.web, keys.lightening
    return GearBlank(
        bore_diameter=keys.bore_diameter_mm,
        keyway=Keyway(width=key.width_mm, depth=key.depth_mm) if key else None,
        hub=Hub(diameter=hub.diameter_mm, length=hub.length_mm, set_screw_diameter=hub.set_screw_mm) if hub else None,
        web=Web(thickness=web.thickness_mm, rim_thickness=web.rim_mm) if web else None,
        lightening=Lightening(count=holes.holes, hole_diameter=holes.hole_diameter_mm) if holes else None,
    )
