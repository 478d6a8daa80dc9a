"""Spur gears as numbers: gears made to a grade, and pairs of them at a centre distance."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import acos, cos, degrees, inf, tan
from typing import Self

from scipy.optimize import brentq

from cadgen.errors import DesignError
from cadgen.gears.choices import Thinning
from cadgen.gears.tolerances import GRADES, ToleranceOverrides
from cadgen.gears.tooth import GearForm, involute
from cadgen.messages import Message

# Centre distances are stated to the micrometre: one this much short, in mm, is rounded and not too small.
CENTRE_DISTANCE_ROUNDING = 0.5e-3
# Greatest working pressure angle that profile shifts may ask for, in rad (80°).
STEEPEST_MESH = 1.4


@dataclass(frozen=True, slots=True, kw_only=True)
class GradedGear:
    """A spur gear and the tolerance grade it is made to; `overrides` stand in for the standards' values.

    `thinning` is the thickness that the teeth are cut to: a place in the zone of the grade, or E_sn in mm.
    `pin_diameter` is that of the pins it is measured with, in mm; None for one to suit it. Raises `DesignError` for a
    grade outside 3 to 12.
    """

    form: GearForm
    grade: int = 7
    overrides: ToleranceOverrides = field(default_factory=ToleranceOverrides)
    thinning: Thinning | float = Thinning.MIDDLE
    pin_diameter: float | None = None

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
class Pair:
    """Two gears in mesh: `driver` turns `driven`. As a stage of a train it is a `spur.SpurPair`.

    The axes are `centre_distance` (a) apart, their bearings `bearing_span` (l), in mm.
    `centre_distance_deviation` stands in for the standard's f_a. Raises `DesignError` if modules or pressure
    angles differ, if the teeth jam or do not meet at a, or if a length is out of range.
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

    def __str__(self) -> str:
        return _pair(self.driver.form, self.driven.form)

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
        driver_teeth, driven_teeth = self.driver.form.teeth, self.driven.form.teeth
        return self.centre_distance * driven_teeth / (driver_teeth + driven_teeth)

    @property
    def working_pressure_angle(self) -> float:
        """α_w in rad at the stated centre distance."""
        return self.pressure_angle(self.centre_distance)

    @property
    def zero_backlash_centre_distance(self) -> float:
        """Centre distance in mm at which teeth of nominal thickness mesh without play; see `closest`."""
        return closest(self.driver.form, self.driven.form)

    def normal_backlash(self, centre_distance: float, thickness_deviation: float = 0.0) -> float:
        """Play along the line of action in mm, by the exact geometry of involutes, without tolerances.

        `thickness_deviation` is ΣE_sn, the sum of both gears' deviations on their reference circles, negative
        for thinned teeth: j_bn = cos α [m Σz (inv α_w − inv α) − 2 m Σx tan α − ΣE_sn]. It turns the driven
        gear by j_bn / r_b. Raises `DesignError` if the base circles overlap.

        Args:
            centre_distance: distance of the axes, mm.
            thickness_deviation: sum of both gears' deviations E_sn, mm, negative for thinned teeth.
        """
        form, other = self.driver.form, self.driven.form
        alpha = form.transverse_pressure_angle
        opened = involute(self.pressure_angle(centre_distance)) - involute(alpha)
        shift = 2 * (form.profile_shift + other.profile_shift) * tan(alpha)
        nominal = form.transverse_module * ((form.teeth + other.teeth) * opened - shift)
        return cos(alpha) * (nominal - thickness_deviation)

    def exact_play(self, centre_distance: float | None = None) -> float:
        """Free angle of the driven gear in rad by the exact geometry of involutes, as cut.

        At the pair's own centre distance or at another one, in mm.

        Args:
            centre_distance: distance of the axes, mm; the pair's own if left out.
        """
        apart = self.centre_distance if centre_distance is None else centre_distance
        deviation = sum(gear.form.tooth_thickness_deviation for gear in (self.driver, self.driven))
        return self.normal_backlash(apart, deviation) / (self.driven.form.base_diameter / 2)

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
        base = (self.driver.form.base_diameter + self.driven.form.base_diameter) / 2
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

    inv α_w = inv α + 2 tan α (x_1 + x_2)/(z_1 + z_2). Raises `DesignError` if the profile shifts allow none.
    """
    teeth = driver.teeth + driven.teeth
    reference = driver.transverse_module * teeth / 2
    shift = driver.profile_shift + driven.profile_shift
    if shift == 0:
        return reference
    alpha = driver.transverse_pressure_angle
    wanted = involute(alpha) + 2 * tan(alpha) * shift / teeth
    if not 0 < wanted < involute(STEEPEST_MESH):
        raise DesignError(
            "{pair} has profile shifts of {shift:g} together; bring their sum nearer to 0",
            pair=_pair(driver, driven),
            shift=shift,
        )
    mesh: float = brentq(lambda angle: involute(angle) - wanted, 0.0, STEEPEST_MESH, xtol=1e-15)
    return reference * cos(alpha) / cos(mesh)


def _pair(driver: GearForm, driven: GearForm) -> str:
    return Message("the pair of {driver} and {driven} teeth", driver=driver.teeth, driven=driven.teeth)
