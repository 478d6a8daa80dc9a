"""Gears, pairs and trains by their numbers, without a design file.

Lengths are mm and angles rad. The teeth are those of `cadgen gears`: exact involutes and trochoids, which every file
is compared with when it is read back.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, fields, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import floor, pi, radians
from typing import TYPE_CHECKING

from cadgen.api.values import Stated, feature, optional, real, stage_angles, whole, word
from cadgen.arrays import TURN
from cadgen.check import CheckList
from cadgen.design.file_names import name_fault
from cadgen.design.gear_model import usual_chord
from cadgen.design.train import MOST_STAGES
from cadgen.errors import DesignError, brief
from cadgen.figures import Facts, Figure, Figures
from cadgen.gears import pair as numbers
from cadgen.gears import spur
from cadgen.gears import train as numeric
from cadgen.gears.choices import HelixHand, Thinning
from cadgen.gears.contact import contact_ratio
from cadgen.gears.inspection import gauge_of, inspection_of
from cadgen.gears.layout import TrainPart
from cadgen.gears.ring import ring_of
from cadgen.gears.shifts import USUAL_LAND, Shifts, proposed_shifts
from cadgen.gears.sliding import loss_factor, specific_sliding
from cadgen.gears.spur import form_figures
from cadgen.gears.stage import Wheel
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import STEEPEST_HELIX, GearForm, tooth_of
from cadgen.gears.train import train_play
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.made_train import MadeTrain, make_train
from cadgen.jobs.gears.assembly import (
    Assembly,
    OnePart,
    checks_facts,
    flats_of,
    parts_facts,
    return_error,
    stages_facts,
)
from cadgen.jobs.gears.gear_train import NotMadeError as NotMadeError
from cadgen.messages import Message
from cadgen.output.files.exports import GearExport
from cadgen.output.files.publisher import Frozen
from cadgen.output.report.gear_pictures import gears_picture
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Flats, Hub, Keyway, Lightening, Web

if TYPE_CHECKING:
    from cadgen.geometry.solids.gear_solids import Compound

# mm; of shafts whose bearings nobody has placed. Where the backlash is given no figure depends on it.
_ANY_SPAN = 1000.0


class _ByNumbers(Assembly):
    """A pair or a train given by numbers."""

    name: str

    @property
    def checks(self) -> CheckList:
        """The teeth in mesh, measured on their sections, and the parts: every figure with its verdict."""
        return CheckList(self.computed.checks)

    @property
    def stem(self) -> str:
        """Start of the names of its files."""
        return self.name

    @property
    def description(self) -> str:
        """Description for STEP files, one line."""
        return f"gear train {self.name}"

    def chord(self, gears: Sequence[Wheel]) -> float:
        """Greatest chord error of a part's mesh, mm.

        Args:
            gears: gears of the part.
        """
        return usual_chord(gears)

    def entry(self) -> Facts:
        """Every tolerance, play, part and inspection size, as in the manifest."""
        made = self.computed
        return Facts(
            train=self.name,
            passed=self.passed,
            ratio=str(made.play.train.ratio),
            return_error_deg=return_error(made.play),
            stages=stages_facts(made.layout),
            checks=checks_facts(made.checks),
            parts=parts_facts(made.layout),
        )


@dataclass(frozen=True, kw_only=True, repr=False)
class Gear(Stated, OnePart, Pictured):
    """A spur or helical gear, its axis on z and a tooth on x, midway along the width of a helical one.

    Attributes:
        teeth: number of teeth, 4 to 1000.
        module: normal module, mm.
        width: width of the face, mm.
        pressure_angle: normal pressure angle, rad.
        profile_shift: profile shift x, in modules.
        bore: diameter of the bore, mm; 0 for none.
        keyway: keyway of the bore; or a `DFlat`; or `Flats`, of which the bore is the size across.
        hub, web, lightening: features besides the teeth, mm; see their classes.
        grade: tolerance grade of ISO 1328, 3 to 12.
        tolerances: tolerances in place of the standard's, mm, by symbol (f_pt, F_beta, F_r, b_r, F_i_radial).
        thickness_deviation: deviation E_sn of the tooth thickness as cut, mm, negative for thinner teeth; None leaves
            it to the pair, with nominal teeth for the gear alone.
        addendum: addendum h_aP*, in modules; None for 1, and of a ring for no more than its pinion allows.
        dedendum, rack_tip_radius: sizes of the basic rack, in modules.
        tip_chamfer: leg of the chamfer at the tips, mm.
        helix_angle: helix angle β at the reference circle, rad, 0 to 45°; 0 for a spur gear.
        hand: hand of the helix: `right`, whose teeth turn clockwise as they go away, as a screw does, or `left`.
        double: whether the helix turns back at half the width.
        internal: whether it is a ring with teeth inside; it has no bore and no hub.
        rim: wall of a ring outside its root, mm; None for 2.5 modules.
        cutter_teeth: teeth of the pinion cutter that cuts a ring, 0 for roots that are arcs; None for one to suit it.
        root_radius: tip radius of that cutter, or radius of the arc, in modules; None for the usual one.
        name: name of the gear and its files.

    Raises:
        DesignError: a number out of its range, a tooth that cannot be cut, or features that leave too thin a wall;
            without a thickness deviation, which moves the root, the last only where the gear, its pair or set is used.

    Example:
        >>> from cadgen import Gear
        >>> gear = Gear(teeth=24, module=1.5, width=8, bore=6)
        >>> gear.tip_diameter
        39.0
        >>> gear.write("exports")  # doctest: +SKIP
    """

    teeth: int
    module: float
    width: float
    pressure_angle: float = radians(20.0)
    profile_shift: float = 0.0
    bore: float = 0.0
    keyway: Keyway | DFlat | Flats | None = None
    hub: Hub | None = None
    web: Web | None = None
    lightening: Lightening | None = None
    grade: int = 7
    tolerances: Mapping[str, float] | None = None
    thickness_deviation: float | None = None
    addendum: float | None = None
    dedendum: float = 1.25
    rack_tip_radius: float = 0.38
    tip_chamfer: float = 0.0
    helix_angle: float = 0.0
    hand: str = HelixHand.RIGHT
    double: bool = False
    internal: bool = False
    rim: float | None = None
    cutter_teeth: int | None = None
    root_radius: float | None = None
    name: str = "gear"

    def __post_init__(self) -> None:
        whole("teeth", self.teeth, 4, 1000)
        whole("grade", self.grade, 3, 12)
        real("module", self.module, 0, 10, "mm", above=True)
        feature("width", self.width, 500)
        real("pressure_angle", self.pressure_angle, radians(10), radians(35), "rad")
        real("profile_shift", self.profile_shift, -2, 2, "modules")
        real("helix_angle", self.helix_angle, 0, STEEPEST_HELIX, "rad")
        word("hand", self.hand, [hand.value for hand in HelixHand])
        for name in ("double", "internal"):
            if not isinstance(value := getattr(self, name), bool):
                raise DesignError(
                    "{name} is {value}; it must be True or False", name=name, value=brief(repr(value), 60)
                )
        optional("rim", self.rim, 0, 500, "mm", above=True)
        optional("root_radius", self.root_radius, 0, 1, "modules", above=True)
        if self.cutter_teeth is not None:
            whole("cutter_teeth", self.cutter_teeth, 0, 500)
        if not self.internal:
            for name in ("rim", "cutter_teeth", "root_radius"):
                if getattr(self, name) is not None:
                    raise DesignError(
                        "{name} is given, which a ring has; give internal=True, or leave it out", name=name
                    )
        optional("addendum", self.addendum, 0, 3, "modules", above=True)
        feature("bore", self.bore, 500, or_none=True)
        feature("tip_chamfer", self.tip_chamfer, 10, or_none=True)
        for name, most in (("dedendum", 3), ("rack_tip_radius", 1)):
            real(name, getattr(self, name), 0, most, "modules", above=True)
        if self.thickness_deviation is not None:
            real("thickness_deviation", self.thickness_deviation, -10, 10, "mm")
        for name, kind in (("keyway", Keyway | DFlat | Flats), ("hub", Hub), ("web", Web), ("lightening", Lightening)):
            if not isinstance(value := getattr(self, name), kind | None):
                raise DesignError(
                    "{name} is {value}; it must be a {kind}",
                    name=name,
                    value=brief(repr(value), 60),
                    kind=getattr(kind, "__name__", "Keyway, a DFlat or Flats"),
                )
        _require_features(self.keyway, self.hub, self.web, self.lightening)
        require_name(self.name)
        self.overrides  # noqa: B018
        if self.tolerances is not None:  # a copy, so that no change of the caller's changes a gear that is made
            object.__setattr__(self, "tolerances", Frozen(self.tolerances))
        if self.thickness_deviation is None:
            self.form.outline  # noqa: B018
        else:
            self.part  # noqa: B018

    @cached_property
    def form(self) -> GearForm:
        """Numbers of its teeth as they are cut."""
        form = GearForm(
            teeth=int(self.teeth),
            normal_module=float(self.module),
            width=float(self.width),
            normal_pressure_angle=float(self.pressure_angle),
            profile_shift=float(self.profile_shift),
            addendum_factor=1.0 if self.addendum is None else float(self.addendum),
            dedendum_factor=float(self.dedendum),
            rack_tip_radius_factor=float(self.rack_tip_radius),
            tip_chamfer=float(self.tip_chamfer),
            tooth_thickness_deviation=self.thickness_deviation or 0.0,
            helix_angle=float(self.helix_angle) * (1 if self.hand == HelixHand.RIGHT else -1),
            double=self.double,
        )
        if not self.internal:
            return form
        return ring_of(
            form,
            rim_width=self.rim,
            cutter_teeth=self.cutter_teeth,
            root_rounding=self.root_radius,
            keeps_addendum=self.addendum is not None,
        )

    @cached_property
    def blank(self) -> Blank:
        """Features besides its teeth."""
        return Blank(bore_diameter=self.bore, key=self.keyway, hub=self.hub, web=self.web, lightening=self.lightening)

    @cached_property
    def part(self) -> TrainPart:
        """The gear as a part by itself, with its exact body."""
        return _part(self.form, self.blank)

    @property
    def picture(self) -> Drawing:
        """Section of the teeth."""
        return gears_picture(f"{self.name}, {self.teeth} teeth", [self.part])

    @cached_property
    def overrides(self) -> ToleranceOverrides:
        """The `tolerances` in place of the standard's, checked."""
        known = [field.name for field in fields(ToleranceOverrides)]
        if not isinstance(self.tolerances, Mapping | None):
            raise DesignError(
                "tolerances is {given}; it must map symbols to mm", given=brief(repr(self.tolerances), 60)
            )
        tolerances = dict(self.tolerances or {})
        for symbol, value in tolerances.items():
            word("a symbol of tolerances", symbol, known)
            real(f"tolerances[{symbol!r}]", value, 0, 10, "mm")
        return ToleranceOverrides(**{symbol: float(value) for symbol, value in tolerances.items()})

    @property
    def reference_diameter(self) -> float:
        """Reference diameter d, mm."""
        return self.form.reference_diameter

    @property
    def base_diameter(self) -> float:
        """Base diameter d_b, mm."""
        return self.form.base_diameter

    @property
    def tip_diameter(self) -> float:
        """Tip diameter d_a, mm."""
        return self.form.tip_diameter

    @property
    def root_diameter(self) -> float:
        """Root diameter d_f as cut, mm."""
        return self.form.root_diameter

    @property
    def volume(self) -> float:
        """Exact volume, mm³."""
        return float(self.part.volume)

    @property
    def undercut(self) -> bool:
        """Whether the root cuts into the flanks."""
        return tooth_of(self.form).undercut

    @property
    def figures(self) -> Figures:
        """Figures of the gear with names and units: its teeth, the sizes to measure it by, bore and volume."""
        deviation = self.form.tooth_thickness_deviation
        sizes = inspection_of(self.form, deviation, deviation)
        span, pins = sizes.span, sizes.pins
        gauge, width = gauge_of(self.form), Message("face width that the span needs")
        return Figures(
            *form_figures(self.form).values(),
            Figure("bore", Message("bore diameter"), self.part.blank.bore_diameter, "mm"),
            Figure("E_sn", "E_sn", deviation * 1e3, "µm"),
            Figure("teeth_spanned", Message("teeth spanned"), span.teeth_spanned if span else None),
            Figure("span", Message("base tangent length"), span.span.upper if span else None, "mm"),
            Figure("span_width_needed", width, span.width_needed if span else sizes.span_needs, "mm"),
            Figure(gauge.diameter, gauge.diameter_name, pins.pin_diameter if pins else None, "mm"),
            Figure(gauge.size, gauge.size_name, pins.over_pins.upper if pins else None, "mm"),
            Figure("volume", Message("volume"), self.part.volume, "mm3"),
        )

    def entry(self) -> Facts:
        """The gear, with span over teeth and size over pins, or over balls where it is helical or internal."""
        return Facts(gear=self.name) | self.figures | Facts(**flats_of(self.part.blank))

    def _export(self) -> GearExport:
        return _export(self.name, self.form, self.part)


def _part(form: GearForm, blank: Blank) -> TrainPart:
    """Gear as a part by itself, its axis on z and its lower face at z = 0."""
    return TrainPart(
        name="gear",
        shaft=1,
        gears=(form,),
        stages=(1,),
        blank=blank,
        body=gear_body(form, blank),
        axis=0j,
        angle=0.0,
        height=0.0,
        flipped=False,
    )


def _export(name: str, form: GearForm, part: TrainPart, shaft: int = 1) -> GearExport:
    return GearExport(name=name, form=form, part=part, chord=usual_chord(part.gears), shaft=shaft)


def _require_features(
    keyway: Keyway | DFlat | Flats | None, hub: Hub | None, web: Web | None, lightening: Lightening | None
) -> None:
    """Refuse sizes that the design file refuses."""
    if keyway:
        if isinstance(keyway, Keyway):
            feature("keyway.width", keyway.width, 100)
        if isinstance(keyway, Flats):
            word("keyway.count", str(keyway.count), ("4", "6"))
        else:
            feature("keyway.depth", keyway.depth, 50)
        real("keyway.angle", keyway.angle, -TURN, TURN, "rad")
    if hub:
        feature("hub.diameter", hub.diameter, 1000)
        feature("hub.length", hub.length, 200, or_none=True)
        word("hub.side", hub.side, ("outer", "inner"))
        if hub.set_screw:
            feature("hub.set_screw.diameter", hub.set_screw.diameter, 50)
            real("hub.set_screw.height", hub.set_screw.height, 0, 200, "mm")
            real("hub.set_screw.angle", hub.set_screw.angle, -TURN, TURN, "rad")
    if web:
        feature("web.thickness", web.thickness, 500)
        feature("web.rim_thickness", web.rim_thickness, 500)
    if lightening:
        whole("lightening.count", lightening.count, 1, 360)
        feature("lightening.hole_diameter", lightening.hole_diameter, 500)
        optional("lightening.circle_diameter", lightening.circle_diameter, 0, 1000, "mm", above=True)
        real("lightening.start_angle", lightening.start_angle, -TURN, TURN, "rad")


def require_name(name: object) -> None:
    """Refuse a name that files cannot have on every system.

    Args:
        name: name as the caller has it.

    Raises:
        DesignError: the name is not allowed.
    """
    if fault := name_fault(name if isinstance(name, str) else ""):
        raise DesignError("name is {given}; it must {fault}", given=brief(repr(name), 60), fault=fault)


@dataclass(frozen=True, repr=False)
class GearPair(Stated, _ByNumbers):
    """Two gears in mesh, by default at the centre distance at which nominal teeth have no play.

    One of them may be internal; the other then turns inside it.

    The teeth are thinned, each gear's by the same amount, until the pair has the backlash asked for. Without one they
    are thinned for their tolerance grade, as `cadgen gears` does, for which the bearings must be placed.

    Attributes:
        pinion, wheel: the gears; a thickness deviation of their own is kept.
        backlash: circumferential backlash, mm: travel of the wheel's working pitch circle while the pinion rests.
        centre_distance: distance of the axes, mm; None for that of nominal teeth without play.
        bearing_span: distance between the bearings of a shaft, mm; needed without a backlash.
        thinning: without a backlash, place of the tooth thickness in the zone of its grade: `least`, `middle` or
            `greatest`.
        centre_distance_deviation: ± deviation of the distance of the axes, mm; None for the standard's.
        name: name of the pair and its files.

    Raises:
        DesignError: gears that do not mesh, a number out of its range, or a tooth that cannot be cut so thin.

    Example:
        >>> from cadgen import Gear, GearPair
        >>> pair = GearPair(Gear(teeth=18, module=1, width=8), Gear(teeth=45, module=1, width=8), backlash=0.1)
        >>> pair.axes_apart
        31.5
        >>> assembly = pair.build123d()  # doctest: +SKIP
    """

    pinion: Gear
    wheel: Gear
    _: KW_ONLY
    backlash: float | None = None
    centre_distance: float | None = None
    bearing_span: float | None = None
    thinning: str = Thinning.MIDDLE
    centre_distance_deviation: float | None = None
    name: str = "pair"

    def __post_init__(self) -> None:
        for name in ("pinion", "wheel"):
            if not isinstance(value := getattr(self, name), Gear):
                raise DesignError("{name} is {value}; it must be a Gear", name=name, value=brief(repr(value), 60))
        optional("backlash", self.backlash, 0, 100, "mm")
        optional("centre_distance", self.centre_distance, 0, 2000, "mm", above=True)
        optional("bearing_span", self.bearing_span, 0, 5000, "mm", above=True)
        optional("centre_distance_deviation", self.centre_distance_deviation, 0, 10, "mm")
        word("thinning", self.thinning, [place.value for place in Thinning])
        require_name(self.name)
        fixed = [gear.thickness_deviation is not None for gear in (self.pinion, self.wheel)]
        if self.backlash is not None and all(fixed):
            raise DesignError(
                "backlash is {backlash:g} mm and both gears have a thickness_deviation; leave one of the three "
                "out, for two of them decide the third",
                backlash=self.backlash,
            )
        if self.backlash is None and self.bearing_span is None and not all(fixed):
            raise DesignError(
                "backlash is not given; give it in mm, or bearing_span in mm, for which the teeth are then thinned by "
                "their tolerance grade"
            )
        for gear, form in zip((self.pinion, self.wheel), self.cut.wheels, strict=True):
            gear_body(form, gear.blank)

    @cached_property
    def nominal(self) -> spur.SpurPair:
        """The pair with the thickness that its teeth are to be cut to."""
        gears = [
            numbers.GradedGear(form=gear.form.cut_to(0.0), grade=gear.grade, overrides=gear.overrides)
            for gear in (self.pinion, self.wheel)
        ]
        apart = self.centre_distance
        pair = spur.SpurPair(
            driver=gears[0],
            driven=gears[1],
            centre_distance=numbers.closest(gears[0].form, gears[1].form) if apart is None else float(apart),
            bearing_span=_ANY_SPAN if self.bearing_span is None else float(self.bearing_span),
            centre_distance_deviation=self.centre_distance_deviation,
        )
        return pair.thinned_to(*self._thinning(pair))

    def _thinning(self, pair: spur.SpurPair) -> tuple[float | Thinning, float | Thinning]:
        """Thickness of the pinion's and of the wheel's teeth: E_sn, mm, or a place in the zone of their grade."""
        fixed = self.pinion.thickness_deviation, self.wheel.thickness_deviation
        if self.backlash is None:
            pinion, wheel = (Thinning(self.thinning) if deviation is None else deviation for deviation in fixed)
            return pinion, wheel
        both = pair.thinning_for(self.backlash)
        known = [deviation for deviation in fixed if deviation is not None]
        share = (both - sum(known)) / (2 - len(known))
        pinion, wheel = (share if deviation is None else deviation for deviation in fixed)
        return pinion, wheel

    @cached_property
    def cut(self) -> spur.SpurPair:
        """The pair with its teeth as they are cut."""
        pair = self.nominal
        driver, driven = pair.driver.thinning, pair.driven.thinning
        if isinstance(driver, str) or isinstance(driven, str):
            (made,) = numeric.thinned(numeric.Train((pair,))).stages
            assert isinstance(made, spur.SpurPair)
            return made
        return pair.with_free_tips().cut_to(driver, driven).fitted()

    @property
    def axes_apart(self) -> float:
        """Centre distance, mm."""
        return self.nominal.centre_distance

    @property
    def play(self) -> float:
        """Circumferential backlash of the teeth as they are cut, mm of arc of the wheel's working pitch circle."""
        return self.cut.free_angle() * self.cut.driven_pitch_radius

    @property
    def plays(self) -> numbers.Backlash:
        """The play of the teeth as they are cut under its four names: base, normal, pitch circle and angles."""
        return self.cut.backlash()

    @property
    def ratio(self) -> Fraction:
        """Turns of the pinion per turn of the wheel, above 0; the wheel of an external pair turns the other way."""
        return self.nominal.ratio

    @property
    def contact_ratio(self) -> float:
        """Transverse contact ratio ε_α, as cut: pairs of teeth in mesh on average in one section."""
        return contact_ratio(self.cut)

    @property
    def overlap_ratio(self) -> float:
        """Overlap ratio ε_β of helical teeth; 0 for spur gears."""
        return self.cut.overlap_ratio

    @property
    def specific_sliding(self) -> tuple[float, float]:
        """Specific sliding of pinion and wheel where contact begins in their roots, as cut: the least of each."""
        return specific_sliding(self.cut)

    @property
    def loss_factor(self) -> float:
        """Loss factor H_v of the teeth as cut (Niemann/Ohlendorf): of the power P they lose P μ H_v."""
        return loss_factor(self.cut)

    @property
    def axial_force(self) -> float:
        """Axial force as a share of the tangential one, tan β; 0 for spur and double helical gears."""
        return self.cut.axial_force

    @property
    def working_pressure_angle(self) -> float:
        """Working pressure angle α_w, rad."""
        return self.nominal.working_pressure_angle

    @property
    def wheel_angle(self) -> float:
        """Angle of a tooth of the wheel, its teeth midway between those of a pinion with a tooth on x, rad."""
        return self.cut.driven_angle(0.0, 0.0)

    def shifted(self, shifts: Shifts) -> GearPair:
        """The pair with other profile shifts, at the centre distance that goes with them.

        Args:
            shifts: proposal of `propose_shifts`.
        """
        pinion = replace(self.pinion, profile_shift=shifts.driver)
        wheel = replace(self.wheel, profile_shift=shifts.driven)
        return replace(self, pinion=pinion, wheel=wheel, centre_distance=shifts.centre_distance)

    def propose_shifts(
        self, centre_distance: float | None = None, least_land: float = USUAL_LAND
    ) -> tuple[Shifts, ...]:
        """Profile shifts without undercut, and with balanced sliding, that pass every check of the pair.

        Args:
            centre_distance: distance of the axes that they must have, mm; None for that of teeth without shifts, or
                for what undercut asks for.
            least_land: least tip land, as a factor of the module.

        Raises:
            DesignError: no shifts keep the limits, or the distance is within the base circles.
        """
        real("least_land", least_land, 0, 2, "modules")
        optional("centre_distance", centre_distance, 0, 2000, "mm", above=True)
        pinion, wheel = (replace(gear, profile_shift=0.0) for gear in (self.pinion, self.wheel))
        bare = replace(self, pinion=pinion, wheel=wheel, centre_distance=None)
        apart = None if centre_distance is None else float(centre_distance)
        found = proposed_shifts(bare.cut, apart, float(least_land))
        failing = [self.shifted(each).failed for each in found]
        tried = tuple(each for each, failed in zip(found, failing, strict=True) if not failed)
        if found and not tried:
            raise DesignError(
                "with the profile shifts {driver:g} and {driven:g} a check of the pair fails, {name}: {advice}",
                driver=found[0].driver,
                driven=found[0].driven,
                name=Message(failing[0][0].name),
                advice=Message(failing[0][0].advice or "report this pair"),
            )
        if not tried:
            pointed = proposed_shifts(bare.cut, apart, 0.0)
            if pointed:
                raise DesignError(
                    "no profile shifts free this pair of undercut with tip lands of {land:g} modules; give a least "
                    "land (least_land, --least-land) of {most:g}",
                    land=least_land,
                    most=floor(max(min(each.lands) for each in pointed) * 1e3) / 1e3,
                )
            raise DesignError(
                "no profile shifts free this pair of undercut and pointed tips; give more teeth, or another "
                "centre_distance"
            )
        return tried

    @cached_property
    def computed(self) -> MadeTrain:
        """The pair as a train of one stage, laid out and measured in mesh."""
        return Train([self], name=self.name).computed

    def build123d(self) -> Compound:
        """Gears in mesh as one build123d compound, mm: the pinion's axis on z, the wheel's axis beside it along x.

        The teeth of the pinion begin at z = 0, and those of the wheel lie midway along them; hubs stand upwards.

        Raises:
            FileError: the CAD kernel cannot drill the set screw.
        """
        from cadgen.geometry.solids.gear_solids import mesh_compound

        gears = zip(("pinion", "wheel"), (self.pinion, self.wheel), self.cut.wheels, strict=True)
        pinion, wheel = (
            _export(f"{self.name}_{role}", form, _part(form, gear.blank), shaft).solid()
            for shaft, (role, gear, form) in enumerate(gears, 1)
        )
        height = (self.pinion.width - self.wheel.width) / 2
        return mesh_compound((pinion, wheel), ((0.0, 0.0, 0.0), (self.axes_apart, height, self.wheel_angle)), self.name)


@dataclass(frozen=True, repr=False)
class Train(Stated, _ByNumbers):
    """A gear train: pairs in a row, the wheel of each and the pinion of the next one part on one shaft.

    Attributes:
        stages: pairs from the drive to the output. The features of a part between two stages, besides its teeth, are
            those of the wheel; its hub is the collar.
        directions: direction of every stage's line of centres, rad, None for any; the train is folded tightly if left
            out.
        clearance: least gap between bodies on different shafts, mm.
        name: name of the train and its files.

    Raises:
        DesignError: no stage, or a pinion on a shaft with a wheel that has a bore of its own.

    Example:
        >>> from cadgen import Gear, GearPair, Train
        >>> stage = GearPair(Gear(teeth=20, module=1, width=6), Gear(teeth=60, module=1, width=6), backlash=0.05)
        >>> Train([stage, stage]).ratio
        Fraction(9, 1)
    """

    stages: Sequence[GearPair]
    _: KW_ONLY
    directions: Sequence[float | None] | None = None
    clearance: float = 0.3
    name: str = "train"

    def __post_init__(self) -> None:
        stages = self.stages
        if not isinstance(stages, Sequence) or not all(isinstance(pair, GearPair) for pair in stages) or not stages:
            raise DesignError("stages is {given}; it must hold at least one GearPair", given=brief(repr(stages), 60))
        if len(stages) > MOST_STAGES:
            raise DesignError(
                "stages has {count} pairs; it must have at most {most}",
                count=len(stages),
                most=MOST_STAGES,
            )
        for number, (before, after) in enumerate(pairwise(stages), 2):
            if after.pinion.blank not in (Blank(), before.wheel.blank):
                raise DesignError(
                    "the pinion of stage {number} is one part with the wheel of stage {before}; give bore, "
                    "keyway, hub, web and lightening to that wheel alone",
                    number=number,
                    before=number - 1,
                )
        directions = None if self.directions is None else stage_angles("directions", self.directions, len(stages))
        for angle in directions or ():
            if angle is not None:
                real("directions", angle, -2 * pi, 2 * pi, "rad")
        real("clearance", self.clearance, 0, 100, "mm", above=True)
        require_name(self.name)

    @property
    def ratio(self) -> Fraction:
        """Turns of the drive per turn of the output."""
        return self._train.ratio

    @cached_property
    def _train(self) -> numeric.Train:
        return numeric.Train(tuple(pair.nominal for pair in self.stages))

    @cached_property
    def computed(self) -> MadeTrain:
        """The train laid out and measured in mesh; it takes a second or so when it is first asked for."""
        blanks = [self.stages[0].pinion.blank, *(pair.wheel.blank for pair in self.stages)]
        return make_train(train_play(self._train), blanks, self.directions, self.clearance, usual_chord)
