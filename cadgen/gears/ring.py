"""Form of an internal gear's teeth: a ring, its root cut by a pinion cutter or laid as an arc (ISO 21771-1).

A space of the ring is the tooth of an external gear of the thickness e_t, so flanks are those of `tooth`. A rack cannot
cut the root. A pinion cutter of z_0 teeth does, whose round tips leave a trochoid (`CutterTrochoid`); for printing and
wire cutting an arc joins flank and root circle. Profile shift and thickness deviation have one sign for both sorts of
gears: positive ones make a tooth thicker. So a ring's tip circle gets smaller with x > 0, and E_sn < 0 widens
its spaces. Tables of KHK, JGMA and SDP/SI count an internal gear's x the other way round.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from math import acos, asin, ceil, cos, floor, hypot, pi, sin, sqrt, tan
from typing import NamedTuple

from scipy.optimize import brentq

from cadgen.gears.tooth import (
    LEAST_CHAMFER,
    LEAST_FLAT,
    LEAST_RACK_TIP_RADIUS,
    LEAST_RIM,
    LEAST_THICKNESS,
    GearForm,
    Tooth,
    ToothError,
    involute,
    pointed,
)
from cadgen.messages import Message
from cadgen.parts.loop import Arc, Curve, CutterTrochoid, Involute, Loop, Segment

# Teeth of the cutter where none are given, and how many more a ring of standard teeth needs so that it is not trimmed
# (SDP/SI D785, table 5-3a).
USUAL_CUTTER, CUTTER_DIFFERENCE = 25, 18
FEWEST_CUTTER_TEETH = 10
# Radius of the cutter's tips, and of an arc in its place, in modules, where none is given; less where there is no room.
USUAL_CUTTER_RADIUS, USUAL_ARC_RADIUS = 0.2, 0.38
# Rim outside the root where none is given, in modules.
USUAL_RIM = 2.5
STEPS = 10  # in a mm, of its outer diameter then
# In modules, by which thinned teeth reach deeper into the rim at most.
DEEPER = 0.25
# Share of the greatest rounding that a message names, since thinned teeth have room for a little less.
NAMED_ROUNDING = 0.95
# In modules, by which the flanks of a ring end outside its base circle at least.
BASE_MARGIN = 1e-3
# Steepest mesh of cutter and ring, rad.
_STEEPEST = 1.4


class Cutter(NamedTuple):
    """Pinion cutter in its ring, at the end of its feed: transverse section, mm and rad."""

    teeth: int
    axes_apart: float
    working_angle: float
    base_radius: float
    tip_radius: float
    rounding: float


@dataclass(frozen=True, slots=True, kw_only=True)
class RingForm(GearForm):
    """Numbers of one internal gear; those of `GearForm`, and lengths in mm.

    `rim_width` is the wall outside the root circle. `cutter_teeth` is z_0 of the pinion cutter, 0 for a root that is an
    arc, None for one to suit the ring; `root_rounding` the radius of the cutter's tips or of that arc, in modules, None
    for the usual one. `shortened` is by how much the tips are shorter than `addendum_factor`, in modules; a ring that
    `keeps_addendum` is not shortened for its pinion.
    """

    rim_width: float | None = None
    cutter_teeth: int | None = None
    root_rounding: float | None = None
    shortened: float = 0.0
    keeps_addendum: bool = False

    def __str__(self) -> str:
        return Message("the ring with {teeth} teeth of module {module:g}", teeth=self.teeth, module=self.normal_module)

    @property
    def noun(self) -> str:
        """Name of the ring's body in messages."""
        return Message("the ring of {teeth} teeth", teeth=self.teeth)

    @property
    def side(self) -> int:
        """-1: the teeth of an internal gear count as negative."""
        return -1

    @property
    def tooth(self) -> Tooth:
        """Exact curves of one space, and the land beside it.

        Raises:
            ToothError: the ring cannot be cut.
        """
        return ring_tooth(self)

    @property
    def addendum_as_made(self) -> float:
        """Addendum in modules, as shortened for the pinion."""
        return self.addendum_factor - self.shortened

    @property
    def tip_diameter(self) -> float:
        """d_a = d − 2 m_n (h_aP* + x) in mm, from the nominal profile shift: the smallest circle of the ring."""
        height = self.addendum_as_made + self.profile_shift
        return self.reference_diameter - 2 * self.normal_module * height

    @property
    def tip_form_diameter(self) -> float:
        """d_Fa = d_a plus the chamfer on both sides, in mm: where the flanks end."""
        return self.tip_diameter + 2 * self.tip_chamfer

    @property
    def root_diameter(self) -> float:
        """d_fE = d + 2 m_n (h_fP* − x_E) in mm, as cut."""
        depth = self.dedendum_factor - self.generating_profile_shift
        return self.reference_diameter + 2 * self.normal_module * depth

    @property
    def rim_diameter(self) -> float:
        """Outer diameter of the ring, mm."""
        nominal = self.reference_diameter + 2 * self.normal_module * (self.dedendum_factor - self.profile_shift)
        if self.rim_width is None:  # rounded up to a size that a shop turns
            return ceil((nominal + 2 * USUAL_RIM * self.normal_module) * STEPS) / STEPS
        return nominal + 2 * self.rim_width

    @property
    def least_rim(self) -> float:
        """Least wall outside the root, mm."""
        return LEAST_RIM * (self.root_diameter - self.tip_diameter) / 2

    @property
    def base_half_angle(self) -> float:
        """Half the angle of a space between the origins of its two involutes, rad."""
        space = pi * self.transverse_module - self.tooth_thickness
        return space / self.reference_diameter + involute(self.transverse_pressure_angle)


def ring_of(
    form: GearForm,
    *,
    rim_width: float | None = None,
    cutter_teeth: int | None = None,
    root_rounding: float | None = None,
    keeps_addendum: bool = False,
) -> RingForm:
    """Ring with the numbers of an external gear; see `RingForm`.

    Its tips stay outside its base circle, and within what the involute of the given cutter reaches.
    """
    ring = RingForm(
        **{each.name: getattr(form, each.name) for each in fields(GearForm)},
        rim_width=rim_width,
        cutter_teeth=cutter_teeth,
        root_rounding=root_rounding,
        keeps_addendum=keeps_addendum,
    )
    most = _addendum_to_base(ring)
    if ring.cutter_teeth and (cutter := placed_cutter(ring, ring.cutter_teeth)):
        reach = hypot(ring.base_diameter / 2, cutter.axes_apart * sin(cutter.working_angle))
        to_cutter = (ring.reference_diameter / 2 - reach) / ring.normal_module - ring.profile_shift
        most = min(most, to_cutter - BASE_MARGIN)
    if keeps_addendum or ring.addendum_factor <= most or most <= 0:
        return ring
    return replace(ring, shortened=round(ring.addendum_factor - floor(most * 1e3) / 1e3, 6))


def _addendum_to_base(ring: RingForm) -> float:
    """Addendum h_a* with which the flanks of a ring reach to its base circle, in modules."""
    height = (ring.reference_diameter - ring.base_diameter) / 2 - ring.tip_chamfer
    return height / ring.normal_module - ring.profile_shift - BASE_MARGIN


@dataclass(frozen=True, slots=True, kw_only=True)
class RingTooth(Tooth):
    """Resolved tooth of a ring.

    `upper_flank` runs outwards from the tip on the side of growing angle of a space about the x axis, `upper_root` on
    to the root circle. `root_flat_angle` is half the angle of the root circle's arc in the space, `tip_half_angle` half
    that of the land between two spaces.
    """

    @property
    def outline(self) -> Loop:
        """Section of the hole in the ring, with a tooth on the x axis: flank, root, root circle, root, flank, land."""
        form, pitch = self.form, 2 * pi / self.form.teeth
        root = self.upper_root
        if isinstance(root, Arc):  # which runs counterclockwise on both sides
            lower: Curve = Arc(root.radius, -(root.start + root.sweep), root.sweep, root.centre.conjugate())
            upper: Curve = root
        else:
            lower, upper = root.mirrored(), root.reversed()
        curves: list[Curve] = [self.upper_flank.mirrored(), lower]
        if self.root_flat_angle > 0:
            curves.append(Arc(form.root_diameter / 2, -self.root_flat_angle, 2 * self.root_flat_angle))
        curves += [upper, self.upper_flank.reversed()]
        land = Arc(form.tip_diameter / 2, pitch / 2 - self.tip_half_angle, 2 * self.tip_half_angle)
        if form.tip_chamfer > 0:
            end, start = complex(self.upper_flank.point(0.0)), complex(land.point(0.0))
            curves.append(Segment(end, start))
            curves.append(land)
            turn = complex(Arc(1.0, pitch, 1.0).point(0.0))
            curves.append(Segment(complex(land.point(1.0)), end.conjugate() * turn))
        else:
            curves.append(land)
        return Loop(tuple(curve.rotated(pitch / 2) for curve in curves), form.teeth, form.run)


@lru_cache(maxsize=256)
def ring_tooth(form: RingForm) -> RingTooth:
    """Exact curves of a ring's teeth.

    Raises:
        ToothError: the tip is inside the base circle, tips or spaces have no width, the rim is too thin, or the cutter
            does not serve.
    """
    least = LEAST_THICKNESS * form.normal_module
    if not form.tip_form_diameter > form.base_diameter:
        most = floor(_addendum_to_base(form) * 1e3) / 1e3
        raise ToothError(
            Message(
                "{gear} has a tip circle of {tip:.5g} mm inside its base circle of {base:.5g} mm",
                gear=str(form),
                tip=form.tip_form_diameter,
                base=form.base_diameter,
            ),
            Message("give an addendum_factor of at most {most:.3f}", most=most)
            if most > 0
            else Message("lower its profile_shift ({profile_shift:g})", profile_shift=form.profile_shift),
            valued=most > 0,
        )
    if form.rim_width is not None and form.rim_width < _needed_rim(form):
        raise ToothError(
            Message("{gear} has a rim of {rim:g} mm", gear=str(form), rim=form.rim_width),
            Message("give a rim_mm of at least {least:.3f}", least=_needed_rim(form)),
        )
    root, flat = _root(form)
    end = complex(root.point(1.0 if isinstance(root, Arc) else 0.0))
    roll_end = sqrt((2 * abs(end) / form.base_diameter) ** 2 - 1)
    form_diameter = form.base_diameter * hypot(1.0, roll_end)
    if not form_diameter - form.tip_diameter >= 2 * least:
        raise ToothError(
            Message(
                "{gear} has no flank left: its root reaches to {root:.4g} mm, its tip to {tip_diameter:.4g} mm",
                gear=str(form),
                root=form_diameter,
                tip_diameter=form.tip_diameter,
            ),
            Message("raise addendum_factor or the teeth"),
            valued=False,
        )
    half_pitch = pi / form.teeth
    land = (half_pitch - form.half_angle(form.tip_diameter)) * form.tip_diameter
    if land < least:
        raise ToothError(
            pointed(form, land, least),
            Message(
                "raise profile_shift ({profile_shift:g}), or lower the thinning (E_sn = {deviation:g} µm)",
                profile_shift=form.profile_shift,
                deviation=form.tooth_thickness_deviation * 1e3,
            ),
            valued=False,
        )
    largest = min((land - least) / 2, (form_diameter - form.tip_diameter) / 2 - least)
    if form.tip_chamfer > largest:
        raise ToothError(
            Message("{gear} has tip_chamfer = {tip_chamfer:g}", gear=str(form), tip_chamfer=form.tip_chamfer),
            Message("give at most {largest:.4g} mm", largest=max(largest, LEAST_CHAMFER)),
        )
    flank = Involute(
        base_radius=form.base_diameter / 2,
        origin=form.base_half_angle,
        hand=-1,
        roll_start=form.roll_angle(form.tip_form_diameter),
        roll_end=roll_end,
    )
    return RingTooth(
        form=form,
        undercut=False,
        root_form_diameter=form_diameter,
        upper_flank=flank,
        upper_root=root,
        root_flat_angle=flat,
        tip_half_angle=(land - 2 * form.tip_chamfer) / form.tip_diameter,
    )


def _needed_rim(form: RingForm) -> float:
    """Least rim outside the nominal root, mm; thinned teeth have deeper roots."""
    height = form.addendum_factor + form.dedendum_factor
    return round((LEAST_RIM * height + DEEPER) * form.normal_module, 3)


def _root(form: RingForm) -> tuple[Arc | CutterTrochoid, float]:
    """Root curve from the end of the flank to the root circle, and half the angle of the root circle's arc."""
    cutter = cutter_of(form)
    if cutter is None:
        return _arc(form)
    centre_radius = cutter.tip_radius - cutter.rounding
    angle = _no_sliver(_centre_angle(cutter, form, cutter.rounding), form)
    end = angle + asin(cutter.base_radius / centre_radius)
    curve = CutterTrochoid(
        axes_apart=cutter.axes_apart,
        pitch_radius=cutter.axes_apart * cutter.teeth / (form.teeth - cutter.teeth),
        teeth_ratio=cutter.teeth / form.teeth,
        centre_radius=centre_radius,
        centre_angle=angle,
        tip_radius=cutter.rounding,
        origin=0.0,
        hand=1,
        start=end,
        end=angle,
    )
    return curve, angle * cutter.teeth / form.teeth


def _arc(form: RingForm) -> tuple[Arc, float]:
    """Arc tangent to flank and root circle: about the point ρ inside the root circle and ρ from the flank."""
    root, base, half = form.root_diameter / 2, form.base_diameter / 2, form.base_half_angle

    def angle_at(radius: float) -> float:
        return half - radius / base - involute(acos(min(base / (root - radius), 1.0)))

    largest = _largest(angle_at, min(root - base, form.normal_module))
    radius = _rounding(form, largest, USUAL_ARC_RADIUS)
    centre = root - radius
    angle = _no_sliver(angle_at(radius), form)
    roll = tan(acos(base / centre)) + radius / base
    # The flank's normal where the arc begins, and the radius where it ends; the arc runs the other way round.
    sweep = half - roll + pi / 2 - angle
    place = centre * complex(cos(angle), sin(angle))
    return Arc(radius, angle, sweep, place), angle


def _no_sliver(angle: float, form: RingForm) -> float:
    """Half angle of a root circle's arc, rad, or 0 where the arc is too short to be an edge."""
    return angle if angle * form.root_diameter > LEAST_FLAT * form.normal_module else 0.0


def _largest(angle_at: Callable[[float], float], most: float) -> float:
    """Greatest rounding for which the angle of its centre is not negative, mm; 0 if there is none."""
    if angle_at(most * (1 - 1e-9)) >= 0:
        return most
    if angle_at(0.0) <= 0:
        return 0.0
    return float(brentq(angle_at, 0.0, most * (1 - 1e-9), xtol=1e-13))


def _rounding(form: RingForm, largest: float, usual: float) -> float:
    """Radius of the root's rounding in mm, refused where there is no room for it."""
    module = form.normal_module
    if largest < LEAST_RACK_TIP_RADIUS * module:
        raise ToothError(
            Message("{gear} has spaces that come to a point before the root circle", gear=str(form)),
            Message("lower dedendum_factor ({dedendum:g})", dedendum=form.dedendum_factor),
            valued=False,
        )
    if form.root_rounding is None:
        return min(usual * module, largest)
    if form.root_rounding * module > largest:
        raise ToothError(
            Message("{gear} has root_radius_factor = {radius:g}", gear=str(form), radius=form.root_rounding),
            Message("give at most {largest:.4f}", largest=floor(NAMED_ROUNDING * largest / module * 1e4) / 1e4),
        )
    return form.root_rounding * module


def _centre_angle(cutter: Cutter, form: RingForm, rounding: float) -> float:
    """Polar angle ψ_C of the centre of the cutter's rounding, rad; negative where it does not fit."""
    half = pi / (2 * cutter.teeth) + involute(form.transverse_pressure_angle)
    reach = max(cutter.tip_radius - rounding, cutter.base_radius)
    return half - rounding / cutter.base_radius - involute(acos(cutter.base_radius / reach))


def placed_cutter(form: RingForm, teeth: int) -> Cutter | None:
    """A cutter of so many teeth without shift at the end of its feed; None where it cannot mesh with the ring."""
    alpha, apart = form.transverse_pressure_angle, form.teeth - teeth
    if apart <= 0:
        return None
    wanted = involute(alpha) - 2 * tan(form.normal_pressure_angle) * form.generating_profile_shift / apart
    if not 0 < wanted < involute(_STEEPEST):
        return None
    angle = float(brentq(lambda each: involute(each) - wanted, 0.0, _STEEPEST, xtol=1e-15))
    base = form.base_diameter / 2 * teeth / form.teeth
    distance = (form.base_diameter / 2 - base) / cos(angle)
    tip = form.root_diameter / 2 - distance
    if not tip > base:
        return None
    return Cutter(teeth, distance, angle, base, tip, 0.0)


def reserve_of_cutter(form: RingForm, cutter: Cutter) -> float:
    """By how much a cutter leaves the ring's tips alone: the lesser of two reserves, 0 or less where it trims them.

    Its involute must reach the tips of the ring, in mm over the module; and fed radially, its tips must pass the ring's
    on their way in, in rad.
    """
    tip, base = form.tip_diameter / 2, form.base_diameter / 2
    reach = sqrt(max(tip**2 - base**2, 0.0)) - cutter.axes_apart * sin(cutter.working_angle)
    own = TipMesh(cutter.teeth, cutter.base_radius, cutter.tip_radius, form.teeth, base, tip, cutter.working_angle)
    return min(reach / form.normal_module, own.trimming())


class TipMesh(NamedTuple):
    """Tips of a pinion and of its ring: teeth, base and tip radii in mm, and the working pressure angle, rad."""

    pinion_teeth: int
    pinion_base: float
    pinion_tip: float
    ring_teeth: int
    ring_base: float
    ring_tip: float
    working_angle: float

    @property
    def _tip_involutes(self) -> tuple[float, float]:
        return (
            involute(acos(self.pinion_base / self.pinion_tip)),
            involute(acos(min(self.ring_base / self.ring_tip, 1.0))),
        )

    def trimming(self) -> float:
        """Reserve against trimming, rad: negative where pinion and ring do not come together radially."""
        ratio = self.pinion_teeth / self.ring_teeth
        first, second = self.pinion_base / self.pinion_tip, min(self.ring_base / self.ring_tip, 1.0)
        inside = (1 - (first / second) ** 2) / (1 - ratio**2)
        if inside > 1:
            return -1.0
        one = asin(sqrt(max(inside, 0.0)))
        other = asin(min(sqrt(max(((second / first) ** 2 - 1) / (1 / ratio**2 - 1), 0.0)), 1.0))
        mesh, (own, rings) = involute(self.working_angle), self._tip_involutes
        return one + own - mesh - (other + rings - mesh) / ratio

    def trochoid(self) -> float:
        """Reserve against tips that foul each other beside the line of action, rad; negative where they do."""
        apart = (self.ring_base - self.pinion_base) / cos(self.working_angle)
        share = (self.ring_tip**2 - self.pinion_tip**2 - apart**2) / (2 * apart * self.pinion_tip)
        other = (apart**2 + self.ring_tip**2 - self.pinion_tip**2) / (2 * apart * self.ring_tip)
        mesh, (own, rings) = involute(self.working_angle), self._tip_involutes
        if share < -1 or other < -1:
            return -1.0
        if share > 1 or other > 1:  # tips do not reach each other at all
            return 1.0
        ratio = self.pinion_teeth / self.ring_teeth
        return ratio * (acos(share) + own - mesh) + mesh - rings - acos(other)


def _fitting(form: RingForm, teeth: int) -> Cutter | None:
    """A cutter with its rounding, or None where it trims the ring or has no room for a rounding."""
    cutter = placed_cutter(form, teeth)
    if cutter is None or reserve_of_cutter(form, cutter) <= 0:
        return None
    return _rounded(form, cutter)


def _rounded(form: RingForm, cutter: Cutter) -> Cutter:
    most = min(cutter.tip_radius - cutter.base_radius, form.normal_module)
    largest = _largest(lambda radius: _centre_angle(cutter, form, radius), most)
    return cutter._replace(rounding=_rounding(form, largest, USUAL_CUTTER_RADIUS))


@lru_cache(maxsize=256)
def cutter_of(form: RingForm) -> Cutter | None:
    """Pinion cutter of a ring; None for a root that is an arc.

    Where the ring names none it is that of 25 teeth, or 18 fewer than the ring has, or the nearest that does not trim
    the ring's tips; an arc where no cutter serves.

    Raises:
        ToothError: the cutter that the ring names trims its tips, or cannot cut it.
    """
    if form.cutter_teeth == 0:
        return None
    if form.cutter_teeth is not None:
        cutter = placed_cutter(form, form.cutter_teeth)
        if cutter is None or reserve_of_cutter(form, cutter) <= 0:
            served = _served(form)
            raise ToothError(
                Message(
                    "{gear} has cutter_teeth = {teeth}, and such a cutter trims its tips",
                    gear=str(form),
                    teeth=form.cutter_teeth,
                ),
                Message("give {teeth}, or 0 for a root that is an arc", teeth=served) if served else Message("give 0"),
            )
        return _rounded(form, cutter)
    served = _served(form)
    return _fitting(form, served) if served else None


def _served(form: RingForm) -> int:
    """Teeth of the cutter that serves, the usual one or the nearest to it; 0 if none does."""
    usual = min(USUAL_CUTTER, form.teeth - CUTTER_DIFFERENCE)
    tried = sorted(range(FEWEST_CUTTER_TEETH, form.teeth - 5), key=lambda teeth: (abs(teeth - usual), teeth))
    for teeth in tried:
        try:
            if _fitting(form, teeth) is not None:
                return teeth
        except ToothError:
            continue
    return 0
