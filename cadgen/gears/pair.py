"""Gears as numbers: gears made to a grade, and pairs of them at a centre distance.

Teeth are counted as ISO 21771-1 counts them: those of an internal gear are negative in all sums. One set of formulas
then serves external and internal pairs, spur or helical; lengths along the line of action are those of the transverse
section.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import acos, cos, degrees, floor, inf, pi, sin, tan
from typing import Self

from scipy.optimize import brentq

from cadgen.errors import DesignError
from cadgen.gears.choices import HelixHand, Thinning
from cadgen.gears.tolerances import GRADES, ToleranceOverrides
from cadgen.gears.tooth import GearForm, involute
from cadgen.messages import Message

# Teeth that a ring of standard teeth has more than its pinion at least, so that tips clear each other (SDP/SI D785).
USUAL_DIFFERENCE = 9
# Centre distances are stated to the micrometre: one this much short, in mm, is rounded and not too small.
CENTRE_DISTANCE_ROUNDING = 0.5e-3
# Helix angles nearer than this, in rad, are one: far below any machine's setting.
SAME_HELIX = 1e-9
# Greatest working pressure angle that profile shifts may ask for, in rad (80°).
STEEPEST_MESH = 1.4


@dataclass(frozen=True, slots=True, kw_only=True)
class GradedGear:
    """A gear and the tolerance grade it is made to; `overrides` stand in for the standards' values.

    `thinning` is the thickness that the teeth are cut to: a place in the zone of the grade, or E_sn in mm.
    `thickness_tolerance` is the width T_sn of that zone in mm, None for that of the grade.
    `pin_diameter` is that of the pins it is measured with, in mm; None for one to suit it. Raises `DesignError` for a
    grade outside 3 to 12.
    """

    form: GearForm
    grade: int = 7
    overrides: ToleranceOverrides = field(default_factory=ToleranceOverrides)
    thinning: Thinning | float = Thinning.MIDDLE
    pin_diameter: float | None = None
    thickness_tolerance: float | None = None

    def __post_init__(self) -> None:
        if self.grade not in GRADES:
            raise DesignError(
                "{gear} has the tolerance grade {grade}; give a whole number from {finest} to {coarsest}",
                gear=str(self.form),
                grade=self.grade,
                finest=GRADES[0],
                coarsest=GRADES[-1],
            )


@dataclass(frozen=True, slots=True, kw_only=True)
class Backlash:
    """Play of a pair under its four names.

    Attributes:
        base: j_bt, along the line of action in the transverse section, mm.
        normal: j_bn = j_bt cos β_b, the gap between flanks across them in space, mm.
        pitch: j_wt = j_bt / cos α_wt, arc of the working pitch circles, mm: backlash without another word.
        driver_angle: free angle of the driver while the driven gear rests, rad.
        driven_angle: free angle of the driven gear while the driver rests, rad.
    """

    base: float
    normal: float
    pitch: float
    driver_angle: float
    driven_angle: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Pair:
    """Two gears in mesh: `driver` turns `driven`. As a stage of a train it is a `spur.SpurPair`.

    The axes are `centre_distance` (a) apart, their bearings `bearing_span` (l), in mm. At most one of the gears is
    internal, and the other turns inside it. `centre_distance_deviation` stands in for the standard's f_a. Raises
    `DesignError` if modules, pressure angles or helices do not match, if the teeth jam or do not meet at a, or if a
    length is out of range.
    """

    driver: GradedGear
    driven: GradedGear
    centre_distance: float
    bearing_span: float
    centre_distance_deviation: float | None = None

    def __post_init__(self) -> None:
        driver, driven = self.driver.form, self.driven.form
        if driver.normal_module != driven.normal_module:
            raise DesignError(
                "{pair} joins the modules {one:g} and {other:g} mm; give both gears one module",
                pair=str(self),
                one=driver.normal_module,
                other=driven.normal_module,
            )
        if driver.normal_pressure_angle != driven.normal_pressure_angle:
            raise DesignError(
                "{pair} joins the pressure angles {one:g}° and {other:g}°; give both gears one pressure angle",
                pair=str(self),
                one=degrees(driver.normal_pressure_angle),
                other=degrees(driven.normal_pressure_angle),
            )
        self._require_helices()
        if not 0 < self.bearing_span < inf:
            raise DesignError(
                "{pair} has the bearing span {bearing_span:g} mm; give one above 0",
                pair=str(self),
                bearing_span=self.bearing_span,
            )
        deviation = self.centre_distance_deviation
        if deviation is not None and not 0 <= deviation < inf:
            raise DesignError(
                "{pair} has the centre distance deviation {deviation:g} mm; give 0 or more",
                pair=str(self),
                deviation=deviation,
            )
        if self.internal:
            self._require_inside()
        else:
            self._require_outside()

    def _require_helices(self) -> None:
        """External gears have opposite hands, a ring and its pinion the same one."""
        driver, driven = self.driver.form, self.driven.form
        wanted = -driver.helix_angle if not self.internal else driver.helix_angle
        if abs(driven.helix_angle - wanted) > SAME_HELIX and abs(driven.helix_angle + wanted) <= SAME_HELIX:
            if self.internal:
                raise DesignError(
                    '{pair} has opposite hands, and a ring has that of its pinion; give both hand = "{hand}"',
                    pair=str(self),
                    hand=hand_of(driver.helix_angle),
                )
            raise DesignError(
                '{pair} has the hand "{hand}" twice, and gears side by side have opposite ones; give the driven gear '
                'hand = "{other}"',
                pair=str(self),
                hand=hand_of(driver.helix_angle),
                other=hand_of(wanted),
            )
        if abs(driven.helix_angle - wanted) > SAME_HELIX:
            raise DesignError(
                "{pair} joins the helix angles {one:g}° and {other:g}°; give both gears one helix angle",
                pair=str(self),
                one=degrees(abs(driver.helix_angle)),
                other=degrees(abs(driven.helix_angle)),
            )
        if driver.double != driven.double:
            raise DesignError(
                "{pair} joins a double helical gear and one that is not; make both double, or neither", pair=str(self)
            )

    def _require_outside(self) -> None:
        """Axes of an external pair are so far apart that teeth do not jam, and so near that they meet."""
        driver, driven = self.driver.form, self.driven.form
        least, reach = self.zero_backlash_centre_distance, (driver.tip_diameter + driven.tip_diameter) / 2
        if not self.centre_distance >= least - CENTRE_DISTANCE_ROUNDING:
            raise DesignError(
                "{pair} jams at the centre distance {centre_distance:g} mm; give at least {least:.7g} mm, or smaller "
                "profile shifts or modules",
                pair=str(self),
                centre_distance=self.centre_distance,
                least=least,
            )
        if not self.centre_distance < reach:
            raise DesignError(
                "{pair} of module {module:g} does not meet at the centre distance {centre_distance:g} mm; "
                "give less than {reach:.6g} mm, or a larger module",
                pair=str(self),
                module=driver.normal_module,
                centre_distance=self.centre_distance,
                reach=reach,
            )

    def _require_inside(self) -> None:
        """A pinion fits into its ring, and its axis is so near to the ring's that teeth do not jam, yet meet."""
        if self.driver.form.side + self.driven.form.side < 0:
            raise DesignError("{pair} has two internal gears; take internal from one of them", pair=str(self))
        pinion, ring = (each.form for each in self.by_size)
        _require_larger(pinion, ring)
        most, least = self.zero_backlash_centre_distance, (ring.tip_diameter - pinion.tip_diameter) / 2
        if not self.centre_distance <= most + CENTRE_DISTANCE_ROUNDING:
            raise DesignError(
                "{pair} jams at the centre distance {centre_distance:g} mm; give at most {most:.7g} mm, or smaller "
                "profile shifts",
                pair=str(self),
                centre_distance=self.centre_distance,
                most=floor(most * 1e4) / 1e4,
            )
        if not self.centre_distance > least:
            raise DesignError(
                "{pair} of module {module:g} does not meet at the centre distance {centre_distance:g} mm; give more "
                "than {least:.6g} mm, such as {most:.7g}",
                pair=str(self),
                module=pinion.normal_module,
                centre_distance=self.centre_distance,
                least=least,
                most=floor(most * 1e4) / 1e4,
            )

    def __str__(self) -> str:
        return _pair(self.driver.form, self.driven.form)

    @property
    def internal(self) -> bool:
        """Whether one of the gears is a ring round the other."""
        return self.driver.form.side != self.driven.form.side or self.driver.form.side < 0

    @property
    def by_size(self) -> tuple[GradedGear, GradedGear]:
        """Pinion and ring of an internal pair; driver and driven gear of an external one."""
        return (self.driven, self.driver) if self.driver.form.side < 0 else (self.driver, self.driven)

    @property
    def teeth_together(self) -> int:
        """Sum of the teeth, those of a ring negative."""
        driver, driven = self.driver.form, self.driven.form
        return driver.side * driver.teeth + driven.side * driven.teeth

    @property
    def ratio(self) -> Fraction:
        """i: turns of the driver per turn of the driven gear."""
        return Fraction(self.driven.form.teeth, self.driver.form.teeth)

    @property
    def grade(self) -> int:
        """Coarser of both tolerance grades."""
        return max(self.driver.grade, self.driven.grade)

    @property
    def driven_pitch_radius(self) -> float:
        """Radius of the driven gear's working pitch circle, in mm."""
        return self.centre_distance * self.driven.form.teeth / abs(self.teeth_together)

    @property
    def working_pressure_angle(self) -> float:
        """α_w in rad at the stated centre distance."""
        return self.pressure_angle(self.centre_distance)

    @property
    def zero_backlash_centre_distance(self) -> float:
        """Centre distance in mm at which teeth of nominal thickness mesh without play; see `closest`."""
        return closest(self.driver.form, self.driven.form)

    @property
    def overlap_ratio(self) -> float:
        """ε_β = b sin |β| / (π m_n) of the width that both gears share; of a double gear, that of one half."""
        form = self.driver.form
        width = min(form.width, self.driven.form.width) / (2 if form.double else 1)
        return width * sin(abs(form.helix_angle)) / (pi * form.normal_module)

    @property
    def axial_force(self) -> float:
        """Axial force as a share of the tangential one at the reference circle, tan |β|; none of a double gear."""
        form = self.driver.form
        return 0.0 if form.double else tan(abs(form.helix_angle))

    def base_backlash(self, centre_distance: float, thickness_deviation: float = 0.0) -> float:
        """Play j_bt along the transverse line of action, mm, by the exact geometry of involutes, without tolerances.

        `thickness_deviation` is ΣE_sn, the sum of both gears' deviations on their reference circles, negative
        for thinned teeth: j_bt = cos α_t [m_t Σz (inv α_wt − inv α_t) − 2 m_t Σx tan α_n − ΣE_sn / cos β]. It turns
        the driven gear by j_bt / r_b. With the teeth of a ring negative, play grows as the axes of an internal pair
        come nearer, and as either gear is thinned. Raises `DesignError` if the base circles overlap.

        Args:
            centre_distance: distance of the axes, mm.
            thickness_deviation: sum of both gears' deviations E_sn, mm, negative for thinned teeth.
        """
        form, other = self.driver.form, self.driven.form
        alpha = form.transverse_pressure_angle
        opened = involute(self.pressure_angle(centre_distance)) - involute(alpha)
        shift = 2 * (form.profile_shift + other.profile_shift) * tan(form.normal_pressure_angle)
        nominal = form.transverse_module * (self.teeth_together * opened - shift)
        return cos(alpha) * (nominal - thickness_deviation / cos(form.helix_angle))

    def thinning_for(self, backlash: float) -> float:
        """Sum of both gears' E_sn, mm, with which they have a backlash on the working pitch circles.

        ΣE_sn = cos β (j_bt of nominal teeth − j_wt cos α_wt) / cos α_t.

        Args:
            backlash: j_wt, mm.
        """
        form = self.driver.form
        short = self.base_backlash(self.centre_distance) - backlash * cos(self.working_pressure_angle)
        return short / cos(form.transverse_pressure_angle) * cos(form.helix_angle)

    def backlash(self, centre_distance: float | None = None) -> Backlash:
        """Play under its four names by the exact geometry of involutes, as cut.

        Args:
            centre_distance: distance of the axes, mm; the pair's own if left out.
        """
        apart = self.centre_distance if centre_distance is None else centre_distance
        driver, driven = self.driver.form, self.driven.form
        base = self.base_backlash(apart, driver.tooth_thickness_deviation + driven.tooth_thickness_deviation)
        return Backlash(
            base=base,
            normal=base * cos(driver.base_helix_angle),
            pitch=base / cos(self.pressure_angle(apart)),
            driver_angle=base / (driver.base_diameter / 2),
            driven_angle=base / (driven.base_diameter / 2),
        )

    def exact_play(self, centre_distance: float | None = None) -> float:
        """Free angle of the driven gear in rad by the exact geometry of involutes, as cut.

        At the pair's own centre distance or at another one, in mm.

        Args:
            centre_distance: distance of the axes, mm; the pair's own if left out.
        """
        apart = self.centre_distance if centre_distance is None else centre_distance
        deviation = sum(gear.form.tooth_thickness_deviation for gear in (self.driver, self.driven))
        return self.base_backlash(apart, deviation) / (self.driven.form.base_diameter / 2)

    def thinned_to(self, driver: Thinning | float, driven: Thinning | float) -> Self:
        """Pair with other thicknesses that its teeth are to be cut to; see `GradedGear.thinning`."""
        driver_gear, driven_gear = replace(self.driver, thinning=driver), replace(self.driven, thinning=driven)
        return replace(self, driver=driver_gear, driven=driven_gear)

    def cut_to(self, driver: float, driven: float) -> Self:
        """The pair with teeth cut to the deviations E_sn of both gears.

        Args:
            driver: deviation E_sn of the driver, mm.
            driven: deviation E_sn of the driven gear, mm.
        """
        one, two = self.driver, self.driven
        return replace(
            self,
            driver=replace(one, form=one.form.cut_to(driver)),
            driven=replace(two, form=two.form.cut_to(driven)),
        )

    def by_the_standard(self) -> Self:
        """Pair without overrides."""
        bare = ToleranceOverrides()
        return replace(
            self,
            driver=replace(self.driver, overrides=bare),
            driven=replace(self.driven, overrides=bare),
            centre_distance_deviation=None,
        )

    def pressure_angle(self, centre_distance: float) -> float:
        """α_w in rad at a centre distance in mm; `DesignError` if the base circles overlap there.

        Args:
            centre_distance: distance of the axes, mm.
        """
        driver, driven = self.driver.form, self.driven.form
        base = abs(driver.side * driver.base_diameter + driven.side * driven.base_diameter) / 2
        if not centre_distance >= base:
            raise DesignError(
                "{pair} has overlapping base circles at the centre distance {centre_distance:g} mm; give at least "
                "{base:.4f} mm",
                pair=str(self),
                centre_distance=centre_distance,
                base=base,
            )
        return acos(base / centre_distance)


def closest(driver: GearForm, driven: GearForm) -> float:
    """Centre distance in mm at which teeth of nominal thickness mesh without play.

    inv α_wt = inv α_t + 2 tan α_n (x_1 + x_2)/(z_1 + z_2). Raises `DesignError` if the profile shifts allow none.
    """
    teeth = driver.side * driver.teeth + driven.side * driven.teeth
    if driver.side != driven.side:
        _require_larger(*((driver, driven) if driven.side < 0 else (driven, driver)))
    reference = driver.transverse_module * abs(teeth) / 2
    shift = driver.profile_shift + driven.profile_shift
    if shift == 0:
        return reference
    alpha = driver.transverse_pressure_angle
    wanted = involute(alpha) + 2 * tan(driver.normal_pressure_angle) * shift / teeth
    if not 0 < wanted < involute(STEEPEST_MESH):
        bound = involute(STEEPEST_MESH) if wanted > 0 else 0.0
        most = (bound - involute(alpha)) * teeth / (2 * tan(driver.normal_pressure_angle))
        raise DesignError(
            "{pair} has profile shifts of {shift:g} together; give the profile shifts {one:g} and {other:g}",
            pair=_pair(driver, driven),
            shift=shift,
            one=round(driver.profile_shift * most / shift / 2, 2),
            other=round(driven.profile_shift * most / shift / 2, 2),
        )
    mesh: float = brentq(lambda angle: involute(angle) - wanted, 0.0, STEEPEST_MESH, xtol=1e-15)
    return reference * cos(alpha) / cos(mesh)


def _require_larger(pinion: GearForm, ring: GearForm) -> None:
    """Refuse a ring that is not larger than its pinion."""
    if not ring.teeth > pinion.teeth:
        raise DesignError(
            "{pair} has a ring of {ring} teeth, which must be larger than its pinion; give the ring at least "
            "{least} teeth",
            pair=_pair(pinion, ring),
            ring=ring.teeth,
            least=pinion.teeth + USUAL_DIFFERENCE,
        )


def hand_of(helix_angle: float) -> str:
    """Word for the hand of a helix.

    Args:
        helix_angle: helix angle β, rad.
    """
    return HelixHand.RIGHT if helix_angle > 0 else HelixHand.LEFT


def _pair(driver: GearForm, driven: GearForm) -> str:
    return Message("the pair of {driver} and {driven} teeth", driver=driver.teeth, driven=driven.teeth)
