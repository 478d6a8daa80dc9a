"""The kind of rack stages: their keys of the design file. Numerics come when a stage is built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Gt, Le

from cadgen.gears.choices import HelixHand
from cadgen.gears.stage_kind import StageKind, ToothedTrain

if TYPE_CHECKING:
    from cadgen.gears.rack_stage import RackStage


@dataclass(frozen=True, kw_only=True)
class RackPinionKeys:
    """Pinion on a rack."""

    teeth: Annotated[int, Ge(4), Le(1000), "z, number of teeth"]
    profile_shift: Annotated[float, Ge(-2), Le(2), "x, profile shift in modules"] = 0.0
    width_mm: Annotated[float | None, Gt(0), Le(500), "b; left out, that of the train"] = None
    E_sn_um: Annotated[float | None, Ge(-1e4), Le(1e4), "thickness deviation; left out, half of what the play asks"] = (
        None
    )


@dataclass(frozen=True, kw_only=True)
class BarKeys:
    """Rack of a stage."""

    teeth: Annotated[int, Ge(2), Le(1000), "number of whole teeth"]
    height_mm: Annotated[
        float | None, Gt(0), Le(1000), "from the back to the reference line; left out, 2 modules behind the roots"
    ] = None
    width_mm: Annotated[float | None, Gt(0), Le(500), "across the travel; left out, that of the train"] = None
    E_sn_um: Annotated[float | None, Ge(-1e4), Le(1e4), "thickness deviation; left out, half of what the play asks"] = (
        None
    )
    T_sn_um: Annotated[float, Ge(0), Le(1e4), "width of the zone of its thickness"] = 50.0
    grade: Annotated[
        int | None,
        Ge(3),
        Le(12),
        "tolerance grade of ISO 1328-1, as of a gear of as many teeth; left out, that of the train",
    ] = None


@dataclass(frozen=True, kw_only=True)
class RackKeys:
    """Keys of a rack stage, as in a design file."""

    distance_mm: Annotated[
        float | None,
        Gt(0),
        Le(2000),
        "of the pinion's axis from the rack's reference line; left out, that without play of nominal teeth",
    ] = None
    f_a_um: Annotated[float | None, Ge(0), Le(1e4), "deviation of that distance; left out, the standard's"] = None
    backlash_um: Annotated[
        float | None,
        Ge(0),
        Le(1e4),
        "play along the rack that the teeth are thinned to; left out, so much that none jams within the tolerances",
    ] = None
    travel_mm: Annotated[
        float | None, Gt(0), Le(1e5), "that the rack must allow; left out, as far as its teeth reach"
    ] = None
    helix_angle_deg: Annotated[float | None, Ge(0), Le(45), "beta; left out, that of the train"] = None
    hand: Annotated[HelixHand, "of a helical pinion; the rack has the other one"] = HelixHand.RIGHT
    driver: Annotated[RackPinionKeys, "pinion"]
    rack: Annotated[BarKeys, "rack"]


def _build(keys: RackKeys, train: ToothedTrain) -> RackStage:
    """Rack stage from its keys.

    Args:
        keys: keys of the stage.
        train: numbers of gears that do not give theirs.

    Raises:
        DesignError: teeth that do not mesh, or a rack that is shorter than its travel.
    """
    from math import radians

    from cadgen.gears.pair import GradedGear
    from cadgen.gears.rack import RackForm
    from cadgen.gears.rack_stage import rack_stage
    from cadgen.gears.tolerances import ToleranceOverrides
    from cadgen.gears.tooth import GearForm

    degree = train.helix_angle if keys.helix_angle_deg is None else radians(keys.helix_angle_deg)
    helix = degree if keys.hand == HelixHand.RIGHT else -degree
    pinion = GearForm(
        teeth=keys.driver.teeth,
        normal_module=train.module,
        width=keys.driver.width_mm or train.width,
        normal_pressure_angle=train.pressure_angle,
        profile_shift=keys.driver.profile_shift,
        addendum_factor=train.addendum_factor,
        dedendum_factor=train.dedendum_factor,
        rack_tip_radius_factor=train.rack_tip_radius_factor,
        tip_chamfer=train.tip_chamfer,
        helix_angle=helix,
    )
    rack = RackForm(
        teeth=keys.rack.teeth,
        normal_module=train.module,
        width=keys.rack.width_mm or train.width,
        height=keys.rack.height_mm,
        normal_pressure_angle=train.pressure_angle,
        helix_angle=-helix,
        addendum_factor=train.addendum_factor,
        dedendum_factor=train.dedendum_factor,
        fillet_factor=train.rack_tip_radius_factor,
    )
    overrides = ToleranceOverrides()
    if train.without_standard:
        overrides = ToleranceOverrides(f_pt=0.0, F_beta=0.0, F_r=0.0, b_r=0.0, F_i_radial=0.0)
    touching = pinion.reference_diameter / 2 + pinion.profile_shift * pinion.normal_module
    given = (keys.driver.E_sn_um, keys.rack.E_sn_um)
    deviation = keys.f_a_um
    if deviation is None and train.without_standard:
        deviation = 0.0
    stage: RackStage = rack_stage(
        GradedGear(form=pinion, grade=train.grade, overrides=overrides, pin_diameter=train.pin_diameter),
        rack,
        distance=touching if keys.distance_mm is None else keys.distance_mm,
        bearing_span=train.bearing_span,
        rack_zone=keys.rack.T_sn_um * 1e-3,
        rack_grade=keys.rack.grade or (None if train.without_standard else train.grade),
        distance_deviation=None if deviation is None else deviation * 1e-3,
        backlash=None if keys.backlash_um is None else keys.backlash_um * 1e-3,
        deviations=tuple(None if each is None else each * 1e-3 for each in given),
        travel=keys.travel_mm,
    )
    return stage


RACK = StageKind(
    code="rack",
    meaning="A pinion that moves a rack, as the last stage. Its ratio is 1: the output is the pinion's turn, and the "
    "travel of the rack for one of it is said.",
    keys=RackKeys,
    build=_build,
    toothed=True,
)
