"""Contact ratio and undercut: by the formulas, for one pair or for many at once, and found on the tooth curves.

**Found.** Overlaps cannot tell where contact ends at the corner of an undercut: near the base circle the corner leaves
the other flank with the third power of the way, and may stay within 0.2 µm of it until that gear's tip is past. But at
the end of contact, and nowhere else near, an end of a flank touches the other flank from within: the room between both,
which is positive before and after, is least there. So the ends of both flanks are carried along at the ratio of the
teeth, each past the other gear's flank, and the place of the least room is looked up. This knows no involute.

**Many at once**, in modules and rad. A rack undercuts a gear whose flank it does not reach down to the base circle:
where the generating profile shift x_E is less than h_fP* − ρ_fP* (1 − sin α_n) − z sin² α_t / (2 cos β). What is
missing of it is the measure of an undercut here. The root then begins where its trochoid crosses the involute, which
has no closed form: it is bisected for all gears together. `tooth.tooth_of` does the same for one gear, on its curves.
"""

from __future__ import annotations

from math import asinh, cos, pi, sin, sqrt, tan

import numpy as np
from numpy.typing import ArrayLike

from cadgen.arrays import Array
from cadgen.gears.pair import Pair
from cadgen.gears.tooth import TANGENT_ROLL, GearForm, Tooth, involute, rack_tip, tooth_of
from cadgen.parts.loop import Points

# Halvings of the root curve in the search for its crossing with the involute: to rounding.
BISECTIONS = 52


def missing_shift(form: GearForm) -> float:
    """Profile shift that a gear, as cut, lacks to be free of undercut, in modules; 0 without undercut."""
    return float(missing_shifts(form, form.teeth, form.generating_profile_shift))


def missing_shifts(rack: GearForm, teeth: ArrayLike, x_E: ArrayLike) -> Array:
    """Profile shifts that gears of `teeth` teeth, cut with `x_E`, lack to be free of undercut, arrays of one shape.

    `rack` is any gear with their pressure angle and basic rack.

    Args:
        rack: gear with the pressure angle and the basic rack of all.
        teeth: numbers of teeth, shape (n,).
        x_E: generating profile shifts, as factors of the module, shape (n,).
    """
    roll, radius = _tangent_roll(rack, teeth, x_E), np.asarray(teeth) / 2 / cos(rack.helix_angle)
    angle = rack.transverse_pressure_angle
    return np.where(roll < -TANGENT_ROLL, -roll * radius * sin(angle) * cos(angle), 0.0)


def contact_ratios(rack: GearForm, teeth: tuple[Array, Array], x_E: tuple[Array, Array], chamfer: Array) -> Array:
    """ε_α of unshifted pairs at the centre distance m Σz / 2.

    Args:
        rack: gear with the pressure angle and the basic rack of all.
        teeth: numbers of teeth of drivers and driven gears, shape (n,) each.
        x_E: their generating profile shifts, as factors of the module, shape (n,) each.
        chamfer: chamfers of the tips, as factors of the module, shape (n,).
    """
    start, end = paths_of_contact(rack, teeth, x_E, chamfer)
    return np.asarray(np.maximum(end - start, 0.0) / (pi * cos(rack.transverse_pressure_angle)))


def paths_of_contact(
    rack: GearForm, teeth: tuple[Array, Array], x_E: tuple[Array, Array], chamfer: Array
) -> tuple[Array, Array]:
    """Start and end of contact of unshifted pairs at m Σz / 2, along the line of action, as factors of the module.

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
        # Roll angle at which the involute begins: at the root's tangent, or, undercut, where the trochoid crosses it.
        roll = _tangent_roll(rack, z, x)
        under = np.flatnonzero(roll < -TANGENT_ROLL)
        roll = np.abs(roll)
        roll[under] = _crossing_roll(rack, z[under], x[under])
        roots.append(base * roll)
    return np.maximum(line - tips[1], roots[0]), np.minimum(tips[0], line - roots[1])


def _tip_of(rack: GearForm) -> tuple[float, float]:
    """Half the flat at the rack's tip and its radius, in modules."""
    flat, radius = rack_tip(rack)
    return flat / rack.normal_module, radius / rack.normal_module


def _tangent_roll(rack: GearForm, teeth: ArrayLike, x_E: ArrayLike) -> Array:
    """Roll angle at which the root is tangent to the involute; negative where there is undercut."""
    angle, (_, rounding) = rack.transverse_pressure_angle, _tip_of(rack)
    depth = rack.dedendum_factor - np.asarray(x_E) - rounding * (1 - sin(rack.normal_pressure_angle))
    radius = np.asarray(teeth) / 2 / cos(rack.helix_angle)
    return np.asarray(tan(angle) - depth / (radius * sin(angle) * cos(angle)))


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


# Least contact ratio: with less than one pair in mesh the motion is passed on in jerks; the rest is for errors.
LEAST_CONTACT_RATIO = 1.1
# Least gap between tips and roots, in modules: half of what ISO 53 profile A leaves with the least thinning.
LEAST_ROOT_CLEARANCE = 0.12
# Nodes of a flank, between which its polar angle is taken as straight: within 1e-8 rad.
NODES = 4001
# Positions of a gear, over `PITCHES` to either side of the line of centres, at which its flank's ends are looked at.
POSITIONS, PITCHES = 16001, 4
# Pitches between the ends of both flanks if these meet: some steps between positions.
TOGETHER = 2e-3


def contact_ratio(pair: Pair, centre_distance: float | None = None) -> float:
    """ε_α of the formula: the part of the line of action on both gears' usable flanks, in base pitches; 0 if none.

    At the pair's own centre distance or at another one, in mm.

    Args:
        pair: pair of gears.
        centre_distance: distance of the axes, mm; the pair's own if left out.
    """
    start, end = path_of_contact(pair, centre_distance)
    form = pair.driver.form
    return max(end - start, 0.0) / (pi * form.transverse_module * cos(form.transverse_pressure_angle))


def path_of_contact(pair: Pair, centre_distance: float | None = None) -> tuple[float, float]:
    """Begin and end of contact on the line of action, mm from where it touches the base circle of the first gear.

    The first gear is the driver, or the pinion of a ring.

    Args:
        pair: pair of gears.
        centre_distance: distance of the axes, mm; the pair's own if left out.
    """
    apart = pair.centre_distance if centre_distance is None else centre_distance
    line = apart * sin(pair.pressure_angle(apart))
    driver, driven = (tooth_of(gear.form) for gear in pair.by_size)

    def along(diameter: float, form: GearForm) -> float:
        return sqrt(max(diameter**2 - form.base_diameter**2, 0.0)) / 2

    ends = [
        line - along(diameter, driven.form) if driven.form.side > 0 else along(diameter, driven.form) - line
        for diameter in (driven.form.tip_form_diameter, driven.root_form_diameter)
    ]
    start = max(ends[0], along(driver.root_form_diameter, driver.form))
    return start, min(along(driver.form.tip_form_diameter, driver.form), ends[1])


def found_contact_ratio(pair: Pair) -> float:
    """Pitches over which one flank of the driver carries, as cut; 0 if the flanks do not meet.

    Contact begins when the driver's flank is met near its root, at its own end or at that of the driven gear's
    tip, whichever is later; it ends the other way round.
    """
    driver, driven = (tooth_of(gear.form) for gear in pair.by_size)
    of_driver = [_passage(driver, end, driven, pair.centre_distance) for end in (0, -1)]
    # A flank runs outwards: to the tip, or, of a ring, to the root.
    of_driven = [_passage(driven, end, driver, pair.centre_distance) for end in ((0, -1) if pair.internal else (-1, 0))]
    pitch = 2 * pi / driver.form.teeth
    ends = []
    for own, other in zip(of_driver, of_driven, strict=True):
        passages = [(own[0], own[2])] if own else []
        passages += [(other[1], other[2])] if other else []
        angles = [angle for angle, touches in passages if touches]
        if not angles:
            # Either both flanks end there together, or they never meet.
            angles = [angle for angle, _ in passages]
            if not angles or max(angles) - min(angles) > TOGETHER * pitch:
                return 0.0
        ends.append(angles)
    return max(min(ends[1]) - max(ends[0]), 0.0) / pitch


def _passage(gear: Tooth, end: int, other: Tooth, apart: float) -> tuple[float, float, bool] | None:
    """Where the end of `gear`'s flank (0: at the root, −1: at the tip) has the least room to the flank of `other`.

    `gear` stands at the origin with tooth 0 on the x axis, `other` on that axis at the distance `apart`, with a
    tooth towards it; the flank on the side of growing angle presses that of the other gear. `other` could turn on
    until its flank meets the point: that angle, less the one that the ratio gives, is the room. Returns both
    gears' angles in rad, and whether the flanks touch there and do not only end; None if they do not come by.
    """
    radius, polar = np.abs(_flank(other)), np.angle(_flank(other))
    span = 2 * pi * PITCHES / gear.form.teeth
    own = np.linspace(-span, span, POSITIONS)
    moved = _flank(gear)[end] * np.exp(1j * own)
    inside = gear.form.side * other.form.side < 0
    # A ring's axis is beside its pinion's, on the other side from the contact.
    seen = moved + gear.form.side * apart if inside else apart - moved
    passing = (np.abs(seen) >= radius[0]) & (np.abs(seen) <= radius[-1])
    if not passing.any():
        return None
    turned = np.angle(seen) - np.interp(np.abs(seen), radius, polar)
    ratio = gear.form.teeth / other.form.teeth
    room = gear.form.side * (own * ratio - turned) if inside else turned + own * ratio
    least = int(np.argmin(np.where(passing, room, np.inf)))
    return float(own[least]), float(turned[least]), bool(passing[max(least - 1, 0) : least + 2].all())


def _flank(tooth: Tooth) -> Points:
    return tooth.upper_flank.point(np.linspace(0.0, 1.0, NODES))
