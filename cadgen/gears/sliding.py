"""Sliding of flanks on each other along the path of contact: specific sliding, and the losses that it makes.

**Specific sliding** of a gear is the share of its rolling speed that the flanks slide by: ζ_1 = 1 − ξ_2 / (u ξ_1) and
ζ_2 = 1 − u ξ_1 / ξ_2, u = z_2/z_1. The ξ are distances of the point of contact from where the line of action touches
both base circles. It is greatest in magnitude, and negative, where contact begins in a gear's roots; there flanks
pit and wear.

**Losses** of the teeth by Niemann and Ohlendorf: of the power P they take P μ H_v, with a constant friction coefficient
μ and the load shared equally by the teeth in contact. For 1 ≤ ε_α ≤ 2
H_v = π (1/z_1 ± 1/z_2) / cos β_b · (1 − ε_α + ε_1² + ε_2²), minus for a ring; ε_1 and ε_2 are the parts of ε_α after
and before the pitch point. Below 1, where the overlap of a helix carries on, the formula is kept: it is above the mean
of the sliding there, by 1.4 % at ε_α = 0.99. Beyond 2, and where contact keeps to one side of the pitch point, the mean
of the sliding over a pitch is taken itself.
"""

from __future__ import annotations

from math import cos, inf, pi, sin, tan

import numpy as np

from cadgen.arrays import Array
from cadgen.gears.contact import path_of_contact, paths_of_contact
from cadgen.gears.pair import Pair
from cadgen.gears.tooth import GearForm

# Positions within a pitch at which the sliding is averaged where the formula does not hold.
POSITIONS = 20000


def specific_sliding(pair: Pair) -> tuple[float, float]:
    """Specific sliding of driver and driven gear where contact begins in their roots, as cut: the least of each."""
    start, end = path_of_contact(pair)
    first, second = (gear.form for gear in pair.by_size)
    ratio = second.teeth / first.teeth
    # Distance along the line of action between both base circles, a sin α_wt, mm.
    bases = first.base_diameter + second.side * second.base_diameter
    line = tan(pair.working_pressure_angle) * bases / 2 * second.side

    def other(along: float) -> float:
        return line - along if second.side > 0 else line + along

    found = (
        1 - other(start) / (ratio * start) if start > 0 else -inf,
        1 - ratio * end / other(end) if other(end) > 0 else -inf,
    )
    return found if first is pair.driver.form else (found[1], found[0])


def loss_factor(pair: Pair) -> float:
    """Loss factor H_v of the teeth, as cut: losses are P μ H_v."""
    start, end = path_of_contact(pair)
    first, second = (gear.form for gear in pair.by_size)
    pitch = pi * first.transverse_module * cos(first.transverse_pressure_angle)
    middle = first.base_diameter / 2 * tan(pair.working_pressure_angle)
    mean = _mean_sliding((end - middle) / pitch, (middle - start) / pitch)
    sliding = 1 / first.teeth + second.side / second.teeth
    return pi * sliding / cos(first.base_helix_angle) * mean


def loss_factors(rack: GearForm, teeth: tuple[Array, Array], x_E: tuple[Array, Array], chamfer: Array) -> Array:
    """H_v of unshifted spur pairs at m Σz / 2, as cut.

    Args:
        rack: gear with the pressure angle and the basic rack of all.
        teeth: numbers of teeth of drivers and driven gears, shape (n,) each.
        x_E: their generating profile shifts, as factors of the module, shape (n,) each.
        chamfer: chamfers of the tips, as factors of the module, shape (n,).
    """
    start, end = paths_of_contact(rack, teeth, x_E, chamfer)
    angle = rack.transverse_pressure_angle
    pitch, middle = pi * cos(angle), teeth[0] / 2 * sin(angle)
    after, before = (end - middle) / pitch, (middle - start) / pitch
    mean = np.array([_mean_sliding(*ends) for ends in zip(after.tolist(), before.tolist(), strict=True)])
    return np.asarray(pi * (1 / teeth[0] + 1 / teeth[1]) * mean)


def _mean_sliding(after: float, before: float) -> float:
    """Mean of the sliding over a pitch, the load shared equally, by the parts of ε_α beside the pitch point."""
    both = after + before
    if both <= 2 and min(after, before) >= 0:
        return 1 - both + after**2 + before**2
    places = (np.arange(POSITIONS) + 0.5) / POSITIONS + np.arange(-1, int(both) + 2)[:, None] - before
    inside = (places >= -before) & (places <= after)
    return 2 * float(np.mean(np.sum(np.abs(places) * inside, axis=0) / np.maximum(inside.sum(axis=0), 1)))
