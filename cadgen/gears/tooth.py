"""Form of a gear's tooth, as a rack with a rounded tip generates it (ISO 21771-1, basic rack ISO 53).

The gear is given by numbers (`GearForm`); `tooth_of` resolves them into the exact curves of one tooth of its transverse
section: involute flanks, trochoid roots, undercut where the rack undercuts. Rack and module are those of the normal
section. There the rack's tip is round, so in the transverse section of a helical gear it is an ellipse, stretched along
the pitch line by 1/cos β. A circle of its radius there would err by 3 µm at 15° of helix and by 12 µm at 30° (module
1).

Choice of cutting: the tooth-thickness deviation E_sn is made by feeding the rack, so the root follows the flanks
(generating profile shift x_E = x + E_sn / (2 m_n tan α_n), ISO 21771-1). The tip circle is turned to the nominal x
before cutting.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache
from math import acos, asin, asinh, atan, cos, degrees, isfinite, pi, radians, sin, sqrt, tan
from numbers import Integral
from typing import Self

import numpy as np
from scipy.optimize import brentq

from cadgen.errors import DesignError
from cadgen.messages import Message
from cadgen.parts.loop import Arc, Curve, CutterTrochoid, Involute, Loop, Segment, Trochoid
from cadgen.parts.run import HelixRun, helix

MINIMUM_TEETH = 4
# Steeper teeth push along the axis more than round it.
STEEPEST_HELIX = radians(45.0)
# Greatest turn of a section over the width, rad: what faces are held to 5e-8 mm with polynomials of few degrees.
MOST_TWIST = 2.0
# Least rim under the root in tooth heights: ISO 6336-3 gives no rim factor for a thinner one.
LEAST_RIM = 0.5
# Chord error of a gear's mesh where the design gives none, per mm of module: the teeth of all sizes then have as many
# facets, and the volume errs by less than 2e-4.
CHORD_PER_MODULE = 2e-3
# Outside these the basic rack has either no straight flank of use or no width at its tip.
PRESSURE_ANGLE_RANGE = (radians(10.0), radians(35.0))
# In modules: least tip land, neck above an undercut and height of flank; with less, teeth are pointed or break.
LEAST_THICKNESS = 0.05
# In modules: a sharper rack tip is no tool, and its root curve may shrink to a point.
LEAST_RACK_TIP_RADIUS = 0.01
# In modules: a flat at the rack's tip of no more than this is a full radius typed with few digits, and taken as one
# (0.003 µm per mm of module away at most), so that no edge is shorter than kernels bear.
LEAST_FLAT = 2e-6
# In mm: a smaller chamfer is no chamfer.
LEAST_CHAMFER = 1e-3
# Roll angle (rad) up to which root and involute still meet at the base circle: the gap there is 2/3 of its
# cube times the base radius, 0.002 nm at 100 mm.
TANGENT_ROLL = 3e-4
# Points at which a root curve is searched for its narrowest place.
NECK_SAMPLES = 65
# Shifts and addenda that are tried for a tooth that cannot be cut, in modules: greatest, and step; and teeth.
MOST_SHIFT, TRIED_STEP, MOST_TEETH_MORE = 2.0, 0.05, 60


@dataclass(frozen=True, slots=True, kw_only=True)
class GearForm:
    """Numbers of one external gear: lengths in mm, angles in rad, factors in modules.

    `helix_angle` is β, positive for a right-hand helix (a point of a tooth turns counter-clockwise as z grows), 0 for a
    spur gear. A `double` helical gear has this hand up to half its width and the other one above.
    `dedendum_factor` (h_fP*) and `rack_tip_radius_factor` (ρ_fP*) are those of the basic rack, by default ISO
    53 profile A. `tooth_thickness_deviation` is E_sn, signed: negative thins the tooth. `tip_chamfer` is the
    leg of the chamfer along the tip circle and along the radius. Raises `DesignError` for a number outside
    its range.
    """

    teeth: int
    normal_module: float
    width: float
    normal_pressure_angle: float = radians(20.0)
    profile_shift: float = 0.0
    addendum_factor: float = 1.0
    dedendum_factor: float = 1.25
    rack_tip_radius_factor: float = 0.38
    tooth_thickness_deviation: float = 0.0
    tip_chamfer: float = 0.0
    helix_angle: float = 0.0
    double: bool = False

    def __post_init__(self) -> None:
        if not isinstance(self.teeth, Integral) or self.teeth < MINIMUM_TEETH:
            raise DesignError(
                "a gear has {teeth} teeth; give a whole number of at least {least}",
                teeth=self.teeth,
                least=MINIMUM_TEETH,
            )
        for name in ("normal_module", "width", "addendum_factor", "dedendum_factor"):
            self._require(name, getattr(self, name) > 0, Message("a number above 0"))
        radius, chamfer = self.rack_tip_radius_factor, self.tip_chamfer
        sharp = Message("{least} or more", least=LEAST_RACK_TIP_RADIUS)
        small = Message("0, or {least} mm or more", least=LEAST_CHAMFER)
        self._require("rack_tip_radius_factor", radius >= LEAST_RACK_TIP_RADIUS, sharp)
        self._require("tip_chamfer", chamfer == 0 or chamfer >= LEAST_CHAMFER, small)
        for name in ("profile_shift", "tooth_thickness_deviation"):
            self._require(name, True, Message("a finite number"))
        low, high = PRESSURE_ANGLE_RANGE
        if not low <= self.normal_pressure_angle <= high:
            raise DesignError(
                "{gear} has a pressure angle of {angle:g}°; give {low:g}° to {high:g}°",
                gear=str(self),
                angle=degrees(self.normal_pressure_angle),
                low=degrees(low),
                high=degrees(high),
            )
        self._require_helix()

    def _require_helix(self) -> None:
        if not abs(self.helix_angle) <= STEEPEST_HELIX:
            raise DesignError(
                "{gear} has a helix angle of {angle:g}°; give at most {most:g}°",
                gear=str(self),
                angle=degrees(self.helix_angle),
                most=degrees(STEEPEST_HELIX),
            )
        if self.double and not self.helix_angle:
            raise DesignError(
                "{gear} is double helical without a helix; give helix_angle_deg, such as 25, or leave double out",
                gear=str(self),
            )
        length = self.width / 2 if self.double else self.width
        if not abs(self.run.rate) * length <= MOST_TWIST:
            raise DesignError(
                "{gear} turns by {twist:.3g} rad over its width of {width:g} mm, and {most:g} rad is the most; give a "
                "width_mm of at most {widest:.4g}, or a smaller helix_angle_deg",
                gear=str(self),
                twist=abs(self.run.rate) * length,
                width=self.width,
                most=MOST_TWIST,
                widest=self.width * MOST_TWIST / abs(self.run.rate) / length * 0.999,
            )

    def _require(self, name: str, holds: bool, allowed: Message) -> None:
        value = getattr(self, name)
        if not (holds and isfinite(value)):
            raise DesignError(
                "{gear} has {name} = {value:g}; give {allowed}", gear=str(self), name=name, value=value, allowed=allowed
            )

    def __str__(self) -> str:
        return Message("the gear with {teeth} teeth of module {module:g}", teeth=self.teeth, module=self.normal_module)

    @property
    def noun(self) -> str:
        """Name of the gear's body in messages."""
        return Message("the gear of {teeth} teeth", teeth=self.teeth)

    @property
    def run(self) -> HelixRun:
        """Way of the transverse section along the axis."""
        return helix(self.helix_angle, self.reference_diameter, self.width / 2 if self.double else None)

    @property
    def outline(self) -> Loop:
        """Transverse section of the whole gear midway along its width, as cut.

        Raises:
            ToothError: the tooth cannot be cut (`tooth_of`).
        """
        return tooth_of(self).outline

    @property
    def tooth(self) -> Tooth:
        """Exact curves of one tooth.

        Raises:
            ToothError: the tooth cannot be cut.
        """
        return rack_tooth(self)

    @property
    def side(self) -> int:
        """+1 for an external gear, -1 for an internal one: the sign of its teeth in ISO 21771-1."""
        return 1

    @property
    def rim_diameter(self) -> float:
        """Diameter of the circle that holds the whole rim, mm."""
        return self.tip_diameter

    @property
    def least_rim(self) -> float:
        """Least wall under the root, mm."""
        return LEAST_RIM * (self.tip_diameter - self.root_diameter) / 2

    @property
    def usual_chord(self) -> float:
        """Greatest chord error of its mesh where none is given, mm."""
        return CHORD_PER_MODULE * self.normal_module

    @property
    def transverse_module(self) -> float:
        """m_t = m_n / cos β in mm."""
        return self.normal_module / cos(self.helix_angle)

    @property
    def transverse_pressure_angle(self) -> float:
        """α_t in rad: tan α_t = tan α_n / cos β."""
        if self.helix_angle == 0:
            return self.normal_pressure_angle
        return atan(tan(self.normal_pressure_angle) / cos(self.helix_angle))

    @property
    def base_helix_angle(self) -> float:
        """β_b in rad, with the sign of β: sin β_b = sin β cos α_n."""
        return asin(sin(self.helix_angle) * cos(self.normal_pressure_angle))

    @property
    def generating_profile_shift(self) -> float:
        """x_E = x + E_sn / (2 m_n tan α_n)."""
        feed = self.tooth_thickness_deviation / (2 * tan(self.normal_pressure_angle))
        return self.profile_shift + feed / self.normal_module

    @property
    def reference_diameter(self) -> float:
        """d = z m_t in mm."""
        return self.teeth * self.transverse_module

    @property
    def base_diameter(self) -> float:
        """d_b = d cos α_t in mm."""
        return self.reference_diameter * cos(self.transverse_pressure_angle)

    @property
    def tip_diameter(self) -> float:
        """d_a = d + 2 m_n (h_aP* + x) in mm, from the nominal profile shift."""
        return self.reference_diameter + 2 * self.normal_module * (self.addendum_factor + self.profile_shift)

    @property
    def addendum_as_made(self) -> float:
        """Addendum in modules, of a ring as shortened for its pinion."""
        return self.addendum_factor

    @property
    def tip_form_diameter(self) -> float:
        """d_Fa = d_a less the chamfer on both sides, in mm: where the flanks end."""
        return self.tip_diameter - 2 * self.tip_chamfer

    @property
    def root_diameter(self) -> float:
        """d_fE = d − 2 m_n (h_fP* − x_E) in mm, as cut."""
        depth = self.dedendum_factor - self.generating_profile_shift
        return self.reference_diameter - 2 * self.normal_module * depth

    @property
    def tooth_thickness(self) -> float:
        """Transverse arc thickness on the reference circle in mm, as cut: m_t (π/2 + 2 x_E tan α_n)."""
        shift = 2 * self.generating_profile_shift * tan(self.normal_pressure_angle)
        return self.transverse_module * (pi / 2 + shift)

    @property
    def base_half_angle(self) -> float:
        """ψ_b in rad: half the angle of a tooth between the origins of its two involutes."""
        return self.tooth_thickness / self.reference_diameter + involute(self.transverse_pressure_angle)

    def cut_to(self, deviation: float) -> Self:
        """The gear cut with the tooth-thickness deviation E_sn.

        Args:
            deviation: deviation E_sn of the tooth thickness, mm.
        """
        return replace(self, tooth_thickness_deviation=deviation)

    def half_angle(self, diameter: float) -> float:
        """Half the angle of a tooth's thickness on the circle `diameter` ≥ d_b, in rad (ψ_b − inv α).

        Args:
            diameter: diameter of the circle, d_b or more, mm.
        """
        return self.base_half_angle - involute(acos(self.base_diameter / diameter))

    def roll_angle(self, diameter: float) -> float:
        """Roll angle tan α of the involute on the circle `diameter` ≥ d_b, in rad.

        Args:
            diameter: diameter of the circle, d_b or more, mm.
        """
        return sqrt((diameter / self.base_diameter) ** 2 - 1)


@dataclass(frozen=True, slots=True, kw_only=True)
class Tooth:
    """Resolved tooth of `form`, centred on the x axis.

    `root_form_diameter` is where the usable flank starts, `undercut` whether the root cuts into the involute
    there. `upper_flank` and `upper_root` run outwards on the side of growing angle; `root_flat_angle` is half
    the angle of the root circle's arc between two roots, `tip_half_angle` that of the land on the tip circle.
    """

    form: GearForm
    undercut: bool
    root_form_diameter: float
    upper_flank: Involute
    upper_root: Trochoid | CutterTrochoid | Arc
    root_flat_angle: float
    tip_half_angle: float

    @property
    def tip_land(self) -> float:
        """Arc of the tip circle that is left, chamfers taken off, in mm."""
        return self.tip_half_angle * self.form.tip_diameter

    @property
    def outline(self) -> Loop:
        """Transverse section of the whole gear: root, flank, tip, flank, root and root circle per tooth."""
        form = self.form
        tip = Arc(form.tip_diameter / 2, -self.tip_half_angle, 2 * self.tip_half_angle)
        root = self.upper_root
        assert isinstance(root, Trochoid)
        curves: list[Curve] = [root.mirrored(), self.upper_flank.mirrored()]
        if form.tip_chamfer > 0:
            flank_end, tip_end = complex(self.upper_flank.point(1.0)), complex(tip.point(1.0))
            curves.append(Segment(flank_end.conjugate(), tip_end.conjugate()))
            curves.append(tip)
            curves.append(Segment(tip_end, flank_end))
        else:
            curves.append(tip)
        curves += [self.upper_flank.reversed(), root.reversed()]
        if self.root_flat_angle > 0:
            gap = pi / form.teeth - self.root_flat_angle
            curves.append(Arc(form.root_diameter / 2, gap, 2 * self.root_flat_angle))
        return Loop(tuple(curves), form.teeth, form.run)


class ToothError(DesignError):
    """Error for a tooth that cannot be cut: what is wrong, and what to change.

    Args:
        fault: what is wrong.
        cure: what to change.
        valued: whether the cure says to what.
    """

    def __init__(self, fault: Message, cure: Message, valued: bool = True) -> None:
        super().__init__("{fault}; {cure}", fault=fault, cure=cure)
        self.fault, self.cure, self.valued = fault, cure, valued

    def __reduce__(self) -> tuple[type[ToothError], tuple[Message, Message, bool]]:
        return type(self), (self.fault, self.cure, self.valued)

    def tried(self, form: GearForm, deviations: tuple[float, ...]) -> Message:
        """Cure with a value that was tried, where one was found.

        Args:
            form: gear whose tooth cannot be cut.
            deviations: deviations of the tooth thickness with which it must be possible, mm.
        """
        return self.cure if self.valued else what_works(form, deviations) or self.cure


def tooth_of(form: GearForm) -> Tooth:
    """Exact curves of one tooth of a gear of any form.

    Raises:
        ToothError: the tooth cannot be cut.
    """
    try:
        return form.tooth
    except ToothError as error:
        raise ToothError(error.fault, error.tried(form, (form.tooth_thickness_deviation,))) from error


@lru_cache(maxsize=256)  # a search meets a gear in many trains
def what_works(form: GearForm, deviations: tuple[float, ...]) -> Message | None:
    """Nearest profile shift and addendum, or else number of teeth, with which a tooth can be cut; None without any.

    Args:
        form: gear whose tooth cannot be cut.
        deviations: deviations of the tooth thickness with which it must be possible, mm.
    """

    def nearest(key: str, values: Iterable[float]) -> float | None:
        given = getattr(form, key)
        for value in sorted(values, key=lambda value: abs(value - given)):
            try:
                for deviation in deviations:
                    tried: GearForm = replace(form.cut_to(deviation), **{key: value})  # type: ignore[arg-type]
                    tried.tooth  # noqa: B018
            except DesignError:
                continue
            return value
        return None

    steps = np.arange(-MOST_SHIFT, MOST_SHIFT + TRIED_STEP / 2, TRIED_STEP).round(2).tolist()
    shift = nearest("profile_shift", steps)
    addendum = nearest("addendum_factor", [step for step in steps if step > 0])
    if shift is not None and addendum is not None:
        return Message(
            "give profile_shift = {shift:g} or addendum_factor = {addendum:g}", shift=shift, addendum=addendum
        )
    if shift is not None:
        return Message("give profile_shift = {shift:g}", shift=shift)
    if addendum is not None:
        return Message("give addendum_factor = {addendum:g}", addendum=addendum)
    teeth = nearest("teeth", range(form.teeth + 1, form.teeth + MOST_TEETH_MORE))
    return None if teeth is None else Message("give teeth = {teeth}", teeth=teeth)


def rack_tooth(form: GearForm) -> Tooth:
    """Exact curves of one tooth of an external gear.

    The flank of the rack makes the involute down to the depth h_Ff = d_c + ρ sin α_n below the pitch line. Its roll
    angle there is ξ_Ff = tan α_t − h_Ff / (r sin α_t cos α_t). The rack's rounded tip makes the root, tangent to the
    flank. A negative ξ_Ff is undercut: the root then cuts the involute off where both have the same radius and angle
    (ISO 21771-1).

    Raises `DesignError` if the rack has no such tip radius, if the teeth are pointed or severed, if undercut
    or chamfer leave no flank, or if nothing is left inside the root.
    """
    module, angle = form.normal_module, form.transverse_pressure_angle
    normal_angle, cos_helix = form.normal_pressure_angle, cos(form.helix_angle)
    radius = form.reference_diameter / 2
    flat, tip_radius = rack_tip(form)
    flat /= cos_helix
    centre_depth = module * (form.dedendum_factor - form.generating_profile_shift) - tip_radius
    if form.root_diameter <= 0:
        raise ToothError(
            Message(
                "{gear} has a root diameter of {root_diameter:.4g} mm", gear=str(form), root_diameter=form.root_diameter
            ),
            Message("raise profile_shift or the teeth"),
            valued=False,
        )
    root = Trochoid(
        reference_radius=radius,
        centre_depth=centre_depth,
        tip_radius=tip_radius,
        origin=pi / form.teeth - flat / radius,
        hand=1,
        q_start=0.0,
        q_end=asinh(1 / tan(normal_angle)),
        cos_helix=cos_helix,
    )
    depth = centre_depth + tip_radius * sin(normal_angle)
    roll = tan(angle) - depth / (radius * sin(angle) * cos(angle))
    undercut = roll < -TANGENT_ROLL
    if undercut:
        root, roll = _undercut(form, root)
    roll = abs(roll)
    root_form_diameter = form.base_diameter * sqrt(1 + roll**2)
    tip_half_angle = _tip_half_angle(form, root_form_diameter)
    flank = Involute(
        base_radius=form.base_diameter / 2,
        origin=form.base_half_angle,
        hand=-1,
        roll_start=roll,
        roll_end=form.roll_angle(form.tip_form_diameter),
    )
    neck = 2 * float(np.min(root.point(np.linspace(0.0, 1.0, NECK_SAMPLES)).imag))
    if neck < LEAST_THICKNESS * module:
        raise ToothError(
            Message("{gear} is undercut to a neck of {neck:.4g} mm", gear=str(form), neck=neck),
            Message("raise profile_shift above {profile_shift:g}", profile_shift=form.profile_shift),
            valued=False,
        )
    return Tooth(
        form=form,
        undercut=undercut,
        root_form_diameter=root_form_diameter,
        upper_flank=flank,
        upper_root=root,
        root_flat_angle=flat / radius,
        tip_half_angle=tip_half_angle,
    )


def involute(angle: float) -> float:
    """inv α = tan α − α.

    Args:
        angle: angle α, rad.
    """
    return tan(angle) - angle


def rack_tip(form: GearForm) -> tuple[float, float]:
    """Half the flat at the rack's tip and the tip radius in its normal section, in mm."""
    angle, module = form.normal_pressure_angle, form.normal_module
    half_width = pi / 4 - form.dedendum_factor * tan(angle)
    largest = half_width * cos(angle) / (1 - sin(angle))
    if largest < LEAST_RACK_TIP_RADIUS:
        raise ToothError(
            Message(
                "{gear} has dedendum_factor = {dedendum_factor:g}, at which the rack comes to a point",
                gear=str(form),
                dedendum_factor=form.dedendum_factor,
            ),
            Message("give less than {most:.4g}", most=pi / 4 / tan(angle)),
        )
    flat = half_width - form.rack_tip_radius_factor * (1 - sin(angle)) / cos(angle)
    if flat < -LEAST_FLAT:
        raise ToothError(
            Message(
                "{gear} has rack_tip_radius_factor = {rack_tip_radius_factor:g}, too large for the rack's tip",
                gear=str(form),
                rack_tip_radius_factor=form.rack_tip_radius_factor,
            ),
            Message("give at most {largest:.6f}", largest=largest),
        )
    if flat <= LEAST_FLAT:
        return 0.0, module * largest
    return module * flat, module * form.rack_tip_radius_factor


def _undercut(form: GearForm, root: Trochoid) -> tuple[Trochoid, float]:
    """The root up to its crossing with the involute, and the involute's roll angle there."""

    def beyond_base(q: float) -> float:
        return abs(complex(root.point(q / root.q_end))) - form.base_diameter / 2

    def off_involute(q: float) -> float:
        point = complex(root.point(q / root.q_end))
        return phase(point) - form.half_angle(max(2 * abs(point), form.base_diameter))

    crossing = brentq(off_involute, brentq(beyond_base, 0.0, root.q_end), root.q_end, xtol=1e-15)
    root = replace(root, q_end=crossing)
    return root, form.roll_angle(2 * abs(complex(root.point(1.0))))


def pointed(form: GearForm, land: float, least: float) -> Message:
    """Fault of teeth whose tip land, mm, is less than the least.

    Args:
        form: numbers of the gear.
        land: tip land, mm.
        least: least tip land, mm.
    """
    return Message(
        "{gear} has pointed teeth: its tip land is {land:.4g} mm, and {least:.4g} mm is the least",
        gear=str(form),
        land=land,
        least=least,
    )


def _tip_half_angle(form: GearForm, root_form_diameter: float) -> float:
    """Half the angle of the tip land, after the checks that land and flank are there."""
    least = LEAST_THICKNESS * form.normal_module
    flank = (form.tip_diameter - root_form_diameter) / 2
    if flank < least:
        raise ToothError(
            Message(
                "{gear} has no flank left: its root reaches to {root:.4g} mm, its tip to {tip_diameter:.4g} mm",
                gear=str(form),
                root=root_form_diameter,
                tip_diameter=form.tip_diameter,
            ),
            Message("raise profile_shift from {profile_shift:g} or addendum_factor", profile_shift=form.profile_shift),
            valued=False,
        )
    land = form.half_angle(form.tip_diameter) * form.tip_diameter
    if land < least:
        raise ToothError(
            pointed(form, land, least),
            Message(
                "lower profile_shift ({profile_shift:g}), addendum_factor ({addendum_factor:g}) or the thinning (E_sn ="
                " {deviation:g} µm)",
                profile_shift=form.profile_shift,
                addendum_factor=form.addendum_factor,
                deviation=form.tooth_thickness_deviation * 1e3,
            ),
            valued=False,
        )
    largest = min((land - least) / 2, flank - least)
    if form.tip_chamfer > largest:
        raise ToothError(
            Message("{gear} has tip_chamfer = {tip_chamfer:g}", gear=str(form), tip_chamfer=form.tip_chamfer),
            Message("give at most {largest:.4g} mm", largest=largest),
        )
    return (land - 2 * form.tip_chamfer) / form.tip_diameter
