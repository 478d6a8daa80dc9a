"""From a design's [train] to what the gear rooms work on: mm and rad."""

from collections.abc import Sequence
from dataclasses import fields, replace
from math import radians
from typing import TypeVar

from cadgen.design.blank import TIGHT, Held, ShaftJoint
from cadgen.design.schema import TrainDesign
from cadgen.design.section import listed
from cadgen.design.train import GearBlankSection, GearKeys, SpurStage, TrainSection
from cadgen.errors import DesignError
from cadgen.gears.choices import HelixHand, ToleranceStandard, ToothCutting
from cadgen.gears.cutting import Made
from cadgen.gears.fits import clearance, flat_play, key_play
from cadgen.gears.layout import Blanks, TrainPart
from cadgen.gears.pair import GradedGear
from cadgen.gears.pair import closest as nominal_distance
from cadgen.gears.planetary_kind import PlanetaryKeys
from cadgen.gears.ring import ring_of
from cadgen.gears.spur import SpurPair
from cadgen.gears.stage import Stage, Wheel, is_bar, is_ring
from cadgen.gears.stage_kind import ToothedTrain
from cadgen.gears.synthesis import SearchLimits
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tools import ROTATING, CutBlank
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Loose, Train, bearings
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Flats, Hub, Keyway, Lightening, SetScrew, Web
from cadgen.verdict import Reservation

T = TypeVar("T", int, float)

_UM = 1e-3
# Chord error of a gear's mesh where the design gives none is no coarser than the cam's own default, in mm.
COARSEST_CHORD = 5e-3
_OVERRIDES = ("f_pt", "F_beta", "F_r", "b_r", "F_i_radial")


def train_keys(design: TrainDesign) -> TrainSection:
    """The section [train].

    Raises:
        DesignError: the design has none.
    """
    if design.train is None:
        raise DesignError(
            "{source} has no gear train: add a section [train] with module_mm, width_mm and "
            "bearing_span_mm, a [[train.stages]] for each stage, and in it a driver and a driven gear "
            "with their teeth",
            source=design.source,
        )
    return design.train


def train(design: TrainDesign) -> Train:
    """Stages of the design, from the drive to the camshaft; spur gears are nominal, with their tolerances.

    Raises:
        DesignError: the design has no [train], or a gear or a stage cannot be; it names the stage.
    """
    keys = train_keys(design)
    stages: list[Stage] = []
    for number, stage in enumerate(keys.stages, 1):
        try:
            if isinstance(stage, SpurStage):
                stages.append(_pair(stage, keys))
            else:
                kind, span = stage.registered, stage.bearing_span_mm or keys.bearing_span_mm
                stages.append(kind.build(stage.keys, _toothed(keys, span) if kind.toothed else span))
        except DesignError as error:
            raise DesignError("in stage {number}, {error}", number=number, error=error.message) from error
        if design.cam is not None and is_bar(stages[-1].wheels[1]):
            raise DesignError(
                "train.stages.{number} is a rack, which turns no camshaft: end the train with gears, or leave the cam "
                "out",
                number=number,
            )
    return Train(tuple(stages))


def blanks(design: TrainDesign) -> Blanks:
    """Features of the gears besides their teeth, by their place in the train."""
    keys = train_keys(design)

    def blank(place: str, section: GearBlankSection) -> Blank:
        made, plain = _made(design, place, section), _blank(section)
        if made.tool is None and not made.apart:
            return plain
        given = {each.name: getattr(plain, each.name) for each in fields(plain)}
        return CutBlank(**given, tool=made.tool, apart=made.apart)

    places = (keys.drive, keys.intermediate, keys.output)
    drive, intermediate, output = (bool(place.shaft_ends) for place in places)
    return Blanks(
        drive=_blank(keys.drive),
        intermediate=blank("intermediate", keys.intermediate),
        output=_blank(keys.output),
        ending=(drive, intermediate, output),
        own=tuple(
            (each.shaft, blank(f"shafts.{place}", each), bool(each.shaft_ends))
            for place, each in enumerate(keys.shafts or (), 1)
        ),
    )


_JOINED = TIGHT | {
    ShaftJoint.KEYED: Message("held by the key"),
    ShaftJoint.D_FLAT: Message("held by the flat"),
}


def makings(design: TrainDesign, parts: Sequence[TrainPart]) -> tuple[Made, ...]:
    """How the teeth of each part of a train are made: printed if files take back a printer's, unless stated.

    Inside teeth of a train that is hobbed or milled are shaped, for these tools do not reach inside.

    Args:
        design: loaded design.
        parts: parts of its train.
    """
    keys = train_keys(design)
    on_shafts = keys.on_shafts(max(part.shaft for part in parts if not part.beside))
    made = []
    for part in parts:
        place, blank = ("", GearBlankSection()) if part.beside else on_shafts[part.shaft - 1]
        each = _made(design, place, blank)
        if is_ring(part.gears[0]):
            own, stage = blank.cutting, keys.stages[part.stages[0] - 1]
            if not isinstance(stage, SpurStage) and isinstance(stage.keys, PlanetaryKeys):
                own = (stage.keys.ring.cutting if stage.keys.ring else None) or own
                each = replace(each, key=f"train.stages.{part.stages[0]}.ring.cutting", cutting=own or each.cutting)
            if own is None and each.cutting in ROTATING:
                each = replace(each, cutting=ToothCutting.SHAPED, instead=each.cutting)
        made.append(each)
    return tuple(made)


def _made(design: TrainDesign, place: str, blank: GearBlankSection) -> Made:
    """How the teeth of a part with outside teeth are made.

    Args:
        design: loaded design.
        place: place of the part in the section of the train; empty for one beside the shafts.
        blank: section of the part.
    """
    keys = train_keys(design)
    return Made(
        place,
        key=f"train.{place}.cutting" if place else "train.cutting",
        cutting=blank.cutting or keys.cutting or (ToothCutting.PRINTED if design.export.printing else None),
        apart=bool(blank.cut_apart),
        cutter=keys.cutter_diameter_mm,
        joined=_JOINED[blank.joint] if blank.joint else "",
    )


def loose(design: TrainDesign, of: Train | None) -> tuple[Loose, ...]:
    """Joints and bearings that have play, as it counts at the camshaft; from the drive on, the cam last.

    Args:
        design: a loaded design.
        of: its train, its stages in the order in which they are built in; None if it has none.

    Raises:
        DesignError: a joint whose bore, key or flat is not known, or a fit that is none.
    """
    loose: list[Loose] = []
    if design.train is not None and of is not None:
        keys, shafts = design.train, len(of.stages) + 1
        between = (Message("wheel and pinion of shaft {number}", number=number) for number in range(2, shafts))
        names = (Message("the pinion on the drive"), *between, Message("the wheel on the camshaft"))
        turning = (of.ratio, *of.output_ratios[:-1], 1)
        for name, (place, blank), turns in zip(names, keys.on_shafts(shafts), turning, strict=True):
            width = blank.keyway.width_mm if blank.keyway else None
            across = blank.d_flat.across_mm if blank.d_flat else None
            zone = _free_angle(blank, f"train.{place}", blank.bore_diameter_mm, width, across)
            loose.append(_joint(name, blank, zone).at(float(turns)))
        loose += bearings(of, (keys.bearing_clearance_um or 0.0) * _UM)
    loose.append(_joint(Message("the cam"), design.blank, cam_joint(design)))
    return tuple(joint for joint in loose if joint.greatest > 0)


def cam_joint(design: TrainDesign) -> tuple[float, float]:
    """Least and greatest play of the cam on its shaft, rad.

    Raises:
        DesignError: a joint whose bore, key or flat is not known, or a fit that is none.
    """
    given = design.blank
    key, flat = given.keyway, given.d_flat
    return _free_angle(
        given, "blank", given.bore_diameter_mm, key.width_mm if key else None, flat.across_mm if flat else None
    )


def _free_angle(
    held: Held, where: str, bore_mm: float, key_mm: float | None, across_mm: float | None
) -> tuple[float, float]:
    """Least and greatest play of a wheel on its shaft, rad.

    Args:
        held: the wheel.
        where: section's name, for messages.
        bore_mm: diameter of the bore.
        key_mm: width of the keyway, if there is one.
        across_mm: of the D-flat, if there is one.

    Raises:
        DesignError: bore or D-flat are not known, or there is no such fit.
    """
    if held.joint is None or held.joint in TIGHT:
        return 0.0, 0.0
    if bore_mm <= 0:
        raise DesignError(
            '{where}.joint is "{joint}" and there is no bore: set {where}.bore_diameter_mm',
            where=where,
            joint=held.joint,
        )
    across = held.joint_across_mm or across_mm
    if held.joint == ShaftJoint.D_FLAT and (across is None or not bore_mm / 2 < across < bore_mm):
        raise DesignError(
            "{where}.joint is a D-flat: set {where}.joint_across_mm between half of the bore's "
            "{bore_mm:g} mm and all of it",
            where=where,
            bore_mm=bore_mm,
        )
    if held.joint_fit is not None:
        size = key_mm if held.joint == ShaftJoint.KEYED else bore_mm
        if size is None:
            raise DesignError(
                "{where}.joint_fit is that of a key, whose width is not known: add [{where}.keyway], or give "
                "{where}.joint_clearance_greatest_um",
                where=where,
            )
        try:
            zone = clearance(held.joint_fit, size)
        except DesignError as error:
            raise DesignError("{where}.joint_fit: {error}", where=where, error=error.message) from error
    else:
        zone = (held.joint_clearance_least_um or 0.0) / 1e3, (held.joint_clearance_greatest_um or 0.0) / 1e3
    if held.joint == ShaftJoint.KEYED:
        return key_play(zone[0], bore_mm), key_play(zone[1], bore_mm)
    assert across is not None
    return flat_play(zone[0], bore_mm, across), flat_play(zone[1], bore_mm, across)


def _joint(name: str, held: Held, zone: tuple[float, float]) -> Loose:
    what = Message("key") if held.joint == ShaftJoint.KEYED else Message("D-flat")
    return Loose(
        name=Message("{part} of {name}", part=what, name=name),
        least=zone[0],
        greatest=zone[1],
        cure=Message("clamp, pin or glue {name}: its {part} has", name=name, part=what),
    )


def directions(design: TrainDesign) -> tuple[float | None, ...]:
    """Direction of every stage's line of centres in rad; None where any will do."""
    given = (stage.direction_deg for stage in train_keys(design).stages)
    return tuple(None if angle is None else radians(angle) for angle in given)


def search_limits(design: TrainDesign, given: Train) -> SearchLimits:
    """Limits of the search: those of [train.search], and for keys left out the sizes of the `given` train.

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
        fewer=True,
    )


def limits_left_out(design: TrainDesign) -> str:
    """The limits of [train.search] that are not in the design, listed."""
    keys = train_keys(design).search
    chosen = ("objective", "front", "losses")  # which are no limits
    return listed([name for name, value in keys.model_dump(exclude=set(chosen)).items() if value is None], "and")


def mesh_chord(design: TrainDesign, gears: Sequence[Wheel]) -> float:
    """Greatest chord error of a part's mesh in mm: the design's, or that which suits all of its gears."""
    given = design.export.mesh_chord_um
    return given * _UM if given is not None else usual_chord(gears)


def usual_chord(gears: Sequence[Wheel]) -> float:
    """Greatest chord error of a part's mesh in mm where none is given."""
    return min((*(gear.usual_chord for gear in gears), COARSEST_CHORD))


def _range(spans: tuple[T, T], low: T | None, high: T | None) -> tuple[T, T]:
    return spans[0] if low is None else low, spans[1] if high is None else high


def _toothed(train: TrainSection, span: float) -> ToothedTrain:
    """Numbers that the train gives all its gears.

    Args:
        train: section of the train.
        span: distance of the bearings of the stage, mm.
    """
    return ToothedTrain(
        bearing_span=span,
        module=train.module_mm,
        width=train.width_mm,
        pressure_angle=radians(train.pressure_angle_deg),
        helix_angle=radians(train.helix_angle_deg or 0.0),
        addendum_factor=train.addendum_factor,
        dedendum_factor=train.dedendum_factor,
        rack_tip_radius_factor=train.rack_tip_radius_factor,
        tip_chamfer=train.tip_chamfer_mm,
        grade=train.grade,
        without_standard=train.standard == ToleranceStandard.FREE,
        thinning=train.thinning if train.E_sn_um is None else train.E_sn_um * _UM,
        pin_diameter=train.pin_diameter_mm,
        clearance=train.clearance_mm,
    )


def _pair(stage: SpurStage, train: TrainSection) -> SpurPair:
    degree = train.helix_angle_deg if stage.helix_angle_deg is None else stage.helix_angle_deg
    helix, double = radians(degree or 0.0), bool(stage.double)
    driver_hand = stage.driver.hand or HelixHand.RIGHT
    inside = bool(stage.driver.internal) or bool(stage.driven.internal)
    other_hand = HelixHand.LEFT if (driver_hand == HelixHand.RIGHT) != inside else HelixHand.RIGHT
    driver = _gear(stage.driver, train, _signed(helix, driver_hand), double)
    driven = _gear(stage.driven, train, _signed(helix, stage.driven.hand or other_hand), double)
    apart = stage.centre_distance_mm
    free = 0.0 if train.standard == ToleranceStandard.FREE else None
    pair = SpurPair(
        driver=driver,
        driven=driven,
        centre_distance=nominal_distance(driver.form, driven.form) if apart is None else apart,
        bearing_span=stage.bearing_span_mm or train.bearing_span_mm,
        centre_distance_deviation=free if stage.f_a_um is None else stage.f_a_um * _UM,
    )
    return _with_backlash(pair, stage)


def _with_backlash(pair: SpurPair, stage: SpurStage) -> SpurPair:
    """The pair thinned for the backlash that its stage asks for."""
    backlash = stage.backlash_um
    if backlash is None and stage.backlash_deg is None:
        return pair
    arc = radians(stage.backlash_deg or 0.0) * pair.driven_pitch_radius if backlash is None else backlash * _UM
    both, share = pair.thinning_for(arc), 0.5 if stage.backlash_share is None else stage.backlash_share
    driver, driven = _own_thickness(stage.driver), _own_thickness(stage.driven)
    if driver is None and driven is None:
        driver = share * both
    if driver is None:
        driver = both - (driven or 0.0)
    return pair.thinned_to(driver, both - driver)


def _own_thickness(gear: GearKeys) -> float | None:
    """Thickness deviation E_sn that a gear's own keys ask for, mm; None where the train decides."""
    if gear.E_sns_um is not None:
        return (gear.E_sns_um - (gear.T_sn_um or 0.0) / 2) * _UM
    return None if gear.E_sn_um is None else gear.E_sn_um * _UM


def _signed(helix: float, hand: HelixHand) -> float:
    return helix if hand == HelixHand.RIGHT else -helix


def _gear(gear: GearKeys, train: TrainSection, helix: float, double: bool) -> GradedGear:
    angle = train.pressure_angle_deg if gear.pressure_angle_deg is None else gear.pressure_angle_deg
    form = GearForm(
        teeth=gear.teeth,
        normal_module=gear.module_mm or train.module_mm,
        width=gear.width_mm or train.width_mm,
        normal_pressure_angle=radians(angle),
        profile_shift=gear.profile_shift,
        addendum_factor=gear.addendum_factor or train.addendum_factor,
        dedendum_factor=train.dedendum_factor,
        rack_tip_radius_factor=train.rack_tip_radius_factor,
        tip_chamfer=train.tip_chamfer_mm,
        helix_angle=helix,
        double=double,
    )
    if gear.internal:
        form = ring_of(
            form,
            rim_width=gear.rim_mm,
            cutter_teeth=gear.cutter_teeth,
            root_rounding=gear.root_radius_factor,
            keeps_addendum=gear.addendum_factor is not None,
        )
    usual = train.thinning if train.E_sn_um is None else train.E_sn_um * _UM
    own = _own_thickness(gear)
    given = {name: getattr(gear, f"{name}_um") for name in _OVERRIDES}
    overrides = {name: value * _UM for name, value in given.items() if value is not None}
    if train.standard == ToleranceStandard.FREE:
        overrides = dict.fromkeys(_OVERRIDES, 0.0) | overrides
    return GradedGear(
        form=form,
        grade=gear.grade or train.grade,
        overrides=ToleranceOverrides(**overrides),
        thinning=usual if own is None else own,
        pin_diameter=train.pin_diameter_mm,
        thickness_tolerance=None if gear.T_sn_um is None else gear.T_sn_um * _UM,
    )


def _blank(keys: GearBlankSection) -> Blank:
    """Features of a gear besides its teeth, with the set screw at half the hub's length."""
    hub, web, holes = keys.hub, keys.web, keys.lightening
    key: Keyway | DFlat | Flats | None = None
    if keys.keyway:
        key = Keyway(width=keys.keyway.width_mm, depth=keys.keyway.depth_mm)
    elif keys.d_flat:
        key = DFlat(depth=keys.bore_diameter_mm - keys.d_flat.across_mm)
    elif keys.bore_flats:
        key = Flats(count=keys.bore_flats)
    screw = SetScrew(diameter=hub.set_screw_mm, height=hub.length_mm / 2) if hub and hub.set_screw_mm else None
    return Blank(
        bore_diameter=keys.bore_diameter_mm,
        key=key,
        hub=Hub(diameter=hub.diameter_mm, length=hub.length_mm, set_screw=screw) if hub else None,
        web=Web(thickness=web.thickness_mm, rim_thickness=web.rim_mm) if web else None,
        lightening=Lightening(count=holes.holes, hole_diameter=holes.hole_diameter_mm) if holes else None,
    )


def sense_reservation(design: TrainDesign, stages: int, sense: int | None = None) -> Reservation | None:
    """Reservation on a train that turns the cam the other way round; None if it does not, or has no cam to turn.

    The cam turns against the drive wheel of a car that drives forwards. Each stage of gears side by side turns the
    sense round, and a ring with its pinion keeps it.

    Args:
        design: loaded design.
        stages: number of stages.
        sense: -1 where the camshaft turns against the drive, else +1; left out, that of stages which all turn it round.
    """
    turns = sense or (-1) ** stages
    if design.cam is None or turns < 0:
        return None
    return Reservation(
        "sense-of-train",
        Message(
            "with {stages} stages the camshaft turns the same way as the drive wheel, but the cam is made to turn "
            "against it",
            stages=stages,
        ),
        Message("put the disc on its shaft turned over, a hub with it, or add a stage"),
    )
