"""Undercut and contact ratio of many pairs at once, by the formulas; in modules and rad.

A rack undercuts a gear whose flank it does not reach down to the base circle: where the generating profile shift x_E is
less than h_fP* − ρ_fP* (1 − sin α) − z sin² α / 2. What is missing of it is the measure of an undercut here. The root
then begins where its trochoid crosses the involute, which has no closed form: it is bisected for all gears together.
`tooth.tooth_of` and `contact.contact_ratio` do the same for one gear and one pair, on its curves.
"""

from __future__ import annotations

from math import asinh, cos, pi, sin, tan

import numpy as np
from numpy.typing import ArrayLike

from cadgen.arrays import Array
from cadgen.gears.tooth import TANGENT_ROLL, GearForm, involute, rack_tip

# Halvings of the root curve in the search for its crossing with the involute: to rounding.
BISECTIONS = 52


def missing_shift(form: GearForm) -> float:
    """Profile shift that a gear, as cut, lacks to be free of undercut, in modules; 0 without undercut."""
    return float(missing_shifts(form, form.teeth, form.generating_profile_shift))


def missing_shifts(rack: GearForm, teeth: ArrayLike, x_E: ArrayLike) -> Array:
    """The same for gears of `teeth` teeth and generating profile shift `x_E`, arrays of one shape.

    `rack` is any gear with their pressure angle and basic rack.

    Args:
        rack: gear with the pressure angle and the basic rack of all.
        teeth: numbers of teeth, shape (n,).
        x_E: generating profile shifts, as factors of the module, shape (n,).
    """
    roll, radius = _tangent_roll(rack, teeth, x_E), np.asarray(teeth) / 2
    angle = rack.transverse_pressure_angle
    return np.where(roll < -TANGENT_ROLL, -roll * radius * sin(angle) * cos(angle), 0.0)


def contact_ratios(rack: GearForm, teeth: tuple[Array, Array], x_E: tuple[Array, Array], chamfer: Array) -> Array:
    """ε_α of unshifted pairs at the centre distance m Σz / 2.

    `teeth`, `x_E` (driver, driven) and `chamfer` (of the tips, in modules) are arrays of one shape; `rack` as above.

    Args:
        rack: gear with the pressure angle and the basic rack of all.
        teeth: numbers of teeth of drivers and driven gears, shape (n,) each.
        x_E: their generating profile shifts, as factors of the module, shape (n,) each.
        chamfer: chamfers of the tips, as factors of the module, shape (n,).
    """
    angle = rack.transverse_pressure_angle
    line = (teeth[0] + teeth[1]) / 2 * sin(angle)
    tips, roots = [], []
    for z, x in zip(teeth, x_E, strict=True):
        base = z / 2 * cos(angle)
        tips.append(np.sqrt(np.maximum((z / 2 + rack.addendum_factor - chamfer) ** 2 - base**2, 0.0)))
        roots.append(base * _root_form_roll(rack, z, x))
    start, end = np.maximum(line - tips[1], roots[0]), np.minimum(tips[0], line - roots[1])
    return np.asarray(np.maximum(end - start, 0.0) / (pi * cos(angle)))


def _tip_of(rack: GearForm) -> tuple[float, float]:
    """Half the flat at the rack's tip and its radius, in modules."""
    flat, radius = rack_tip(rack)
    return flat / rack.normal_module, radius / rack.normal_module


def _tangent_roll(rack: GearForm, teeth: ArrayLike, x_E: ArrayLike) -> Array:
    """Roll angle at which the root is tangent to the involute; negative where there is undercut."""
    angle, (_, rounding) = rack.transverse_pressure_angle, _tip_of(rack)
    depth = rack.dedendum_factor - np.asarray(x_E) - rounding * (1 - sin(angle))
    return np.asarray(tan(angle) - depth / (np.asarray(teeth) / 2 * sin(angle) * cos(angle)))


def _root_form_roll(rack: GearForm, teeth: Array, x_E: Array) -> Array:
    """Roll angle at which the involute begins."""
    roll = _tangent_roll(rack, teeth, x_E)
    under = np.flatnonzero(roll < -TANGENT_ROLL)
    roll = np.abs(roll)
    roll[under] = _crossing_roll(rack, teeth[under], x_E[under])
    return roll


def _crossing_roll(rack: GearForm, teeth: Array, x_E: Array) -> Array:
    """Roll angle at which the trochoid of the root crosses the involute, for gears with undercut."""
    angle, (flat, rounding) = rack.transverse_pressure_angle, _tip_of(rack)
    radius, centre = teeth / 2, rack.dedendum_factor - x_E - rounding
    base, base_half = radius * cos(angle), (pi / 2 + 2 * x_E * tan(angle)) / teeth + involute(angle)
    low, high = np.zeros_like(radius), np.full_like(radius, asinh(1 / tan(angle)))
    roll = np.zeros_like(radius)
    for _ in range(BISECTIONS):
        q = (low + high) / 2
        sinh, cosh = np.sinh(q), np.cosh(q)
        along, outward = centre * sinh + rounding * sinh / cosh, radius - centre - rounding / cosh
        roll = np.sqrt(np.maximum((along**2 + outward**2) / base**2 - 1, 0.0))
        polar = pi / teeth - flat / radius + centre * sinh / radius - np.arctan2(along, outward)
        # Inside the tooth, on its way out, or not yet as far out as the base circle.
        before = (roll == 0) | (polar < base_half - (roll - np.arctan(roll)))
        low, high = np.where(before, q, low), np.where(before, high, q)
    return roll
