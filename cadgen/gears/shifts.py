"""Profile shifts proposed for a pair: free of undercut, or sliding alike in both roots, at the distance asked for.

The sum of the shifts follows from the centre distance where that is given: Σx = (inv α_wt − inv α_t)(z_2 ± z_1)/(2 tan
α_n), for a ring with the minus in both places. Else it is as near to 0 as undercut allows. Candidates whose teeth are
undercut, pointed, do not mesh or have too little contact ratio are no proposals.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import pairwise
from math import acos, ceil, isfinite, tan

import numpy as np

from cadgen.errors import DesignError
from cadgen.gears.contact import LEAST_CONTACT_RATIO, contact_ratio, missing_shift
from cadgen.gears.pair import Pair, closest
from cadgen.gears.sliding import specific_sliding
from cadgen.gears.tooth import involute, tooth_of

# Least tip land, in modules: usual for soft gears; hardened ones need 0.4.
USUAL_LAND = 0.2
# Shifts tried for the first gear, and their step, in modules.
LOWEST, HIGHEST, STEP = -1.0, 1.5, 0.02
# Decimals of proposed shifts.
DECIMALS = 4


class ShiftAim(StrEnum):
    """Aims of proposed profile shifts."""

    NO_UNDERCUT = "no undercut"
    BALANCED = "balanced sliding"


@dataclass(frozen=True, slots=True, kw_only=True)
class Shifts:
    """Profile shifts of a pair, and what comes of them.

    Attributes:
        aim: what they are for.
        driver, driven: shifts of both gears, in modules.
        centre_distance: distance of the axes, mm.
        sliding: specific sliding of both gears in their roots.
        lands: tip lands of both gears, in modules.
        contact_ratio: transverse contact ratio.
    """

    aim: ShiftAim
    driver: float
    driven: float
    centre_distance: float
    sliding: tuple[float, float]
    lands: tuple[float, float]
    contact_ratio: float


def sum_of_shifts(pair: Pair, centre_distance: float) -> float:
    """Sum of the shifts with which nominal teeth of a pair have no play at a centre distance, in modules.

    Args:
        pair: pair of gears.
        centre_distance: distance of the axes, mm.

    Raises:
        DesignError: the base circles do not allow so small a distance.
    """
    first, second = (gear.form for gear in pair.by_size)
    base = (second.base_diameter + second.side * first.base_diameter) / 2
    if not base < centre_distance:
        raise DesignError(
            "centre_distance is {apart:g} mm, which is within the base circles; give more than {least:.4g} mm",
            apart=centre_distance,
            least=base,
        )
    angle, own = acos(base / centre_distance), first.transverse_pressure_angle
    teeth = second.side * second.teeth + first.teeth
    return (involute(angle) - involute(own)) * teeth / (2 * tan(first.normal_pressure_angle))


def proposed_shifts(pair: Pair, centre_distance: float | None, least_land: float = USUAL_LAND) -> tuple[Shifts, ...]:
    """Shifts for each aim that some reach; the teeth keep their thickness deviations.

    Args:
        pair: pair of gears, as cut.
        centre_distance: distance of the axes that they must have, mm; None for the usual one or what undercut asks for.
        least_land: least tip land, as a factor of the module.

    Raises:
        DesignError: the distance is within the base circles.
    """
    grid = np.round(np.arange(LOWEST, HIGHEST + STEP / 2, STEP), DECIMALS).tolist()
    if centre_distance is not None:
        sums = [sum_of_shifts(pair, centre_distance)]
    else:
        forms = (gear.form for gear in (pair.driver, pair.driven))
        lacking = sum(missing_shift(replace(form, profile_shift=0.0)) for form in forms if form.side > 0)
        # One step of room for each gear, then more for teeth that thinner rims or tips would spoil.
        sums = [0.0, *(ceil(lacking / STEP) * STEP + more for more in (2 * STEP, 0.2, 0.4) if lacking > 0)]
    for total in sums:

        def made(first: float, aim: ShiftAim, total: float = total) -> Shifts | None:
            return _candidate(pair, (first, total - first), centre_distance, least_land, aim)

        found = [each for first in grid if (each := made(first, ShiftAim.BALANCED))]
        if found:
            return _chosen(found, made)
    return ()


def _chosen(found: list[Shifts], made: Callable[[float, ShiftAim], Shifts | None]) -> tuple[Shifts, ...]:
    """Candidate on the grid with the least shifts, and that with balanced sliding, perhaps between two of the grid."""
    least = min(found, key=lambda each: (abs(each.driver) + abs(each.driven), abs(each.driver)))
    proposals = [replace(least, aim=ShiftAim.NO_UNDERCUT)]

    def apart(each: Shifts) -> float:
        return each.sliding[0] - each.sliding[1]

    best = min(found, key=lambda each: abs(apart(each)))
    for low, high in pairwise(found):
        if apart(low) * apart(high) <= 0 and high.driver - low.driver < 1.5 * STEP:
            one, other, sign = low.driver, high.driver, apart(low)
            while other - one > 0.1 * 10.0**-DECIMALS:
                middle = (one + other) / 2
                between = made(middle, ShiftAim.BALANCED)
                if between is None:
                    break
                one, other = (middle, other) if apart(between) * sign > 0 else (one, middle)
            best = made(round(one, DECIMALS), ShiftAim.BALANCED) or best
            break
    return (*proposals, best)


def _candidate(
    pair: Pair, shifts: tuple[float, float], centre_distance: float | None, least_land: float, aim: ShiftAim
) -> Shifts | None:
    """Pair with other shifts and what comes of them; None where its teeth are none or do not mesh."""
    try:
        gears = [
            replace(gear, form=replace(gear.form, profile_shift=shift))
            for gear, shift in zip((pair.driver, pair.driven), shifts, strict=True)
        ]
        nominal = [gear.form.cut_to(0.0) for gear in gears]
        for form in (*nominal, *(gear.form for gear in gears)):
            form.tooth  # noqa: B018 - it raises where there is none
        apart = closest(*nominal) if centre_distance is None else centre_distance
        shifted = replace(pair, driver=gears[0], driven=gears[1], centre_distance=apart)
        free = getattr(shifted, "with_free_tips", lambda: shifted)()
        forms = free.driver.form, free.driven.form
        lands = tuple(tooth_of(form).tip_land / form.normal_module for form in forms)
        ratio, sliding = contact_ratio(free), specific_sliding(free)
    except DesignError:
        return None
    whole = all(form.side < 0 or missing_shift(form) == 0 for form in forms)
    if not (whole and min(lands) >= least_land and ratio >= LEAST_CONTACT_RATIO and all(map(isfinite, sliding))):
        return None
    return Shifts(
        aim=aim,
        driver=shifts[0],
        driven=shifts[1],
        centre_distance=apart,
        sliding=sliding,
        lands=(lands[0], lands[1]),
        contact_ratio=ratio,
    )
