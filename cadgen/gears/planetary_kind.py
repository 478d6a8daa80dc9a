"""The kind of planetary stages: their keys of the design file. Numerics come when a stage is built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Gt, Le

from cadgen.errors import DesignError
from cadgen.gears.choices import HeldMember, HelixHand, Spacing, ToothCutting
from cadgen.gears.fits import runs, zones_of
from cadgen.gears.stage_kind import StageKind, ToothedTrain
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.gears.planetary_stage import PlanetaryStage


@dataclass(frozen=True, kw_only=True)
class SunKeys:
    """Sun of a planetary stage."""

    teeth: Annotated[int, Ge(4), Le(1000), "z_s, teeth of the sun"]
    profile_shift: Annotated[float, Ge(-2), Le(2), "x, profile shift in modules"] = 0.0
    width_mm: Annotated[float | None, Gt(0), Le(500), "b; left out, that of the train"] = None
    E_sn_um: Annotated[
        float | None, Ge(-1e4), Le(1e4), "thickness deviation, with those of planet and ring; left out, by the backlash"
    ] = None
    bore_diameter_mm: Annotated[
        float, Ge(0), Le(500), "of a sun that is held; of another one, that of its shaft counts"
    ] = 0.0


@dataclass(frozen=True, kw_only=True)
class PlanetKeys:
    """Planets of a planetary stage."""

    teeth: Annotated[int, Ge(4), Le(1000), "z_p, teeth of a planet"]
    count: Annotated[int, Ge(1), Le(12), "N, how many there are"] = 3
    profile_shift: Annotated[float, Ge(-2), Le(2), "x, profile shift in modules"] = 0.0
    width_mm: Annotated[float | None, Gt(0), Le(500), "b; left out, that of the train"] = None
    E_sn_um: Annotated[
        float | None, Ge(-1e4), Le(1e4), "thickness deviation, with those of sun and ring; left out, by the backlash"
    ] = None
    bore_diameter_mm: Annotated[float, Ge(0), Le(500), "of the planets, and of the carrier's holes for their pins"] = (
        0.0
    )
    bore_fit: Annotated[
        str | None, "of the planets' bores on the pins by ISO 286, such as `F8/h6`; for the drawing"
    ] = None


@dataclass(frozen=True, kw_only=True)
class PlanetaryRingKeys:
    """Ring of a planetary stage."""

    teeth: Annotated[int | None, Ge(5), Le(1000), "z_r, teeth of the ring; left out, z_s + 2 z_p"] = None
    profile_shift: Annotated[
        float | None, Ge(-2), Le(2), "x, in modules, by ISO 21771; left out, it follows from the centre distance"
    ] = None
    width_mm: Annotated[float | None, Gt(0), Le(500), "b; left out, that of the train"] = None
    E_sn_um: Annotated[
        float | None, Ge(-1e4), Le(1e4), "thickness deviation, with those of sun and planet; left out, by the backlash"
    ] = None
    addendum_factor: Annotated[float | None, Gt(0), Le(3), "h_aP*; left out, no more than the planets allow"] = None
    rim_mm: Annotated[float | None, Gt(0), Le(500), "outside its root; left out, 2.5 modules"] = None
    cutter_teeth: Annotated[
        int | None, Ge(0), Le(500), "z_0 of its pinion cutter; 0 for roots that are arcs; left out, 25 or what suits it"
    ] = None
    cutting: Annotated[
        ToothCutting | None,
        "how its teeth are cut; left out, as those of the train, or `shaped` where a hob or a disc cutter cuts these",
    ] = None


@dataclass(frozen=True, kw_only=True)
class PlanetaryKeys:
    """Keys of a planetary stage, as in a design file."""

    held: Annotated[
        HeldMember,
        "which member does not turn: with the `ring` held the sun drives the carrier, with the `carrier` held the sun "
        "drives the ring, with the `sun` held the ring drives the carrier",
    ] = HeldMember.RING
    spacing: Annotated[
        Spacing,
        "of the planets: at `equal` angles, which not every count allows, or at the `nearest` ones at which they fit",
    ] = Spacing.EQUAL
    centre_distance_mm: Annotated[
        float | None, Gt(0), Le(2000), "of the planets' axes from the sun's; left out, that without play"
    ] = None
    backlash_um: Annotated[
        float | None,
        Ge(0),
        Le(1e4),
        "j_wt of both meshes; left out, so much that none jams within the tolerances of its grade",
    ] = None
    helix_angle_deg: Annotated[float | None, Ge(0), Le(45), "beta; left out, that of the train"] = None
    hand: Annotated[HelixHand, "of a helical sun; planets and ring have the other one"] = HelixHand.RIGHT
    double: Annotated[bool, "whether the helix turns back at half the width"] = False
    carrier_thickness_mm: Annotated[
        float | None, Gt(0), Le(500), "of the carrier's plate; left out, half the width of the planets"
    ] = None
    pin_place_um: Annotated[
        float, Ge(0), Le(1e4), "by which a pin may stand off its place round the axis, to either side"
    ] = 0.0
    pin_fit: Annotated[
        str | None, "of the carrier's holes and the pins in them by ISO 286, such as `P7/h6`; for the drawing"
    ] = None
    sun: Annotated[SunKeys, "sun"]
    planet: Annotated[PlanetKeys, "planets"]
    ring: Annotated[PlanetaryRingKeys | None, "ring; left out, one that suits sun and planets"] = None

    def __post_init__(self) -> None:
        ring = self.ring or PlanetaryRingKeys()
        given = [each.E_sn_um is not None for each in (self.sun, self.planet, ring)]
        if any(given) and not all(given):
            raise ValueError(
                Message(
                    "{here}.sun, planet and ring have E_sn_um all three, or none of them: give it to all, or "
                    "backlash_um in its place",
                    here="{here}",
                )
            )
        if any(given) and self.backlash_um is not None:
            raise ValueError(
                Message("{here}.backlash_um and E_sn_um of its gears are both given: remove one of them", here="{here}")
            )
        pins, size = {}, self.planet.bore_diameter_mm
        for key, fit in (("pin_fit", self.pin_fit), ("planet.bore_fit", self.planet.bore_fit)):
            if fit is None:
                continue
            if not size:
                raise ValueError(
                    Message(
                        "{here}.{key} needs the pins that it is of: give {here}.planet.bore_diameter_mm",
                        here="{here}",
                        key=key,
                    )
                )
            try:
                *_, letter, grade = zones_of(fit, size)
            except DesignError as error:
                raise ValueError(
                    Message("{here}.{key}: {error}", here="{here}", key=key, error=error.message)
                ) from None
            pins[key] = f"{letter}{grade}"
        if len(set(pins.values())) > 1:
            raise ValueError(
                Message(
                    "{here}.pin_fit has pins of {one} and planet.bore_fit of {other}: give both the same class, as "
                    "the pins are the same",
                    here="{here}",
                    one=pins["pin_fit"],
                    other=pins["planet.bore_fit"],
                )
            )
        if self.pin_fit and self.planet.bore_fit and not (runs(self.pin_fit, size) or runs(self.planet.bore_fit, size)):
            raise ValueError(
                Message(
                    '{here}.pin_fit = "{one}" and planet.bore_fit = "{other}" may both be tight, and the planets '
                    'then do not turn: give one of them a running fit, such as planet.bore_fit = "{usual}"',
                    here="{here}",
                    one=self.pin_fit,
                    other=self.planet.bore_fit,
                    usual=next((fit for each in _RUNNING if runs(fit := f"{each}/{pins['pin_fit']}", size)), "F8/h6"),
                )
            )


_RUNNING = ("F8", "E8")  # holes that run on pins, the closer one first


def _build(keys: PlanetaryKeys, train: ToothedTrain) -> PlanetaryStage:
    """Planetary stage from its keys.

    Args:
        keys: keys of the stage.
        train: numbers of gears that do not give theirs.

    Raises:
        DesignError: planets that do not fit or touch, or teeth that do not mesh.
    """
    from math import radians

    from cadgen.gears.pair import GradedGear, closest
    from cadgen.gears.planetary import PlanetarySet, fitted_ring
    from cadgen.gears.planetary_stage import PlanetaryStage
    from cadgen.gears.ring import ring_of
    from cadgen.gears.tolerances import ToleranceOverrides
    from cadgen.gears.tooth import GearForm

    degree = train.helix_angle if keys.helix_angle_deg is None else radians(keys.helix_angle_deg)
    helix = degree if keys.hand == HelixHand.RIGHT else -degree

    def form(teeth: int, shift: float, width: float | None, angle: float, addendum: float | None) -> GearForm:
        return GearForm(
            teeth=teeth,
            normal_module=train.module,
            width=width or train.width,
            normal_pressure_angle=train.pressure_angle,
            profile_shift=shift,
            addendum_factor=addendum or train.addendum_factor,
            dedendum_factor=train.dedendum_factor,
            rack_tip_radius_factor=train.rack_tip_radius_factor,
            tip_chamfer=train.tip_chamfer,
            helix_angle=angle,
            double=keys.double,
        )

    ring_keys = keys.ring or PlanetaryRingKeys()
    sun = form(keys.sun.teeth, keys.sun.profile_shift, keys.sun.width_mm, helix, None)
    planet = form(keys.planet.teeth, keys.planet.profile_shift, keys.planet.width_mm, -helix, None)
    teeth = ring_keys.teeth or sun.teeth + 2 * planet.teeth
    given = ring_keys.profile_shift
    ring = ring_of(
        form(teeth, given or 0.0, ring_keys.width_mm, -helix, ring_keys.addendum_factor),
        rim_width=ring_keys.rim_mm,
        cutter_teeth=ring_keys.cutter_teeth,
        keeps_addendum=ring_keys.addendum_factor is not None,
    )
    apart = closest(sun, planet) if keys.centre_distance_mm is None else keys.centre_distance_mm
    if given is None:
        ring = fitted_ring(sun, planet, ring, apart)
    overrides = ToleranceOverrides()
    if train.without_standard:
        overrides = ToleranceOverrides(f_pt=0.0, F_beta=0.0, F_r=0.0, b_r=0.0, F_i_radial=0.0)

    def graded(gear: GearForm) -> GradedGear:
        return GradedGear(form=gear, grade=train.grade, overrides=overrides, pin_diameter=train.pin_diameter)

    nominal = PlanetarySet(
        sun=graded(sun),
        planet=graded(planet),
        ring=graded(ring),
        centre_distance=apart,
        planets=keys.planet.count,
        held=keys.held,
        equal=keys.spacing == Spacing.EQUAL,
        clearance=train.clearance,
        bearing_span=train.bearing_span,
        centre_distance_deviation=0.0 if train.without_standard else None,
    )
    own = (keys.sun.E_sn_um, keys.planet.E_sn_um, ring_keys.E_sn_um)
    return PlanetaryStage(
        nominal=nominal,
        backlash=None if keys.backlash_um is None else keys.backlash_um * 1e-3,
        deviations=None if None in own else tuple(float(each or 0.0) * 1e-3 for each in own),  # type: ignore[arg-type]
        carrier_thickness=keys.carrier_thickness_mm or planet.width / 2,
        planet_bore=keys.planet.bore_diameter_mm,
        sun_bore=keys.sun.bore_diameter_mm,
        pin_place=keys.pin_place_um * 1e-3,
        bearing_span=train.bearing_span,
    )


PLANETARY = StageKind(
    code="planetary",
    meaning="A planetary stage: sun, planets on a carrier and a ring round them, all on one axis but the planets.",
    keys=PlanetaryKeys,
    build=_build,
    toothed=True,
)
