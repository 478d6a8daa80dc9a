"""Contact ratio: by the formula, and found on the tooth curves as they pass each other.

Overlaps cannot tell where contact ends at the corner of an undercut: near the base circle the corner leaves the
other flank with the third power of the way, and may stay within 0.2 µm of it until that gear's tip is past. But at
the end of contact, and nowhere else near, an end of a flank touches the other flank from within: the room between
both, which is positive before and after, is least there. So the ends of both flanks are carried along at the ratio
of the teeth, each past the other gear's flank, and the place of the least room is looked up. Nothing here but the
formula knows an involute.
"""

from __future__ import annotations

from math import cos, pi, sin, sqrt

import numpy as np

from cadgen.gears.pair import Pair
from cadgen.gears.tooth import GearForm, Tooth, tooth_of
from cadgen.parts.loop import Points

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
    apart = pair.centre_distance if centre_distance is None else centre_distance
    line = apart * sin(pair.pressure_angle(apart))
    driver, driven = tooth_of(pair.driver.form), tooth_of(pair.driven.form)

    def along(diameter: float, form: GearForm) -> float:
        return sqrt(max(diameter**2 - form.base_diameter**2, 0.0)) / 2

    start = max(line - along(driven.form.tip_form_diameter, driven.form), along(driver.root_form_diameter, driver.form))
    end = min(along(driver.form.tip_form_diameter, driver.form), line - along(driven.root_form_diameter, driven.form))
    return max(end - start, 0.0) / (pi * driver.form.transverse_module * cos(driver.form.transverse_pressure_angle))


def found_contact_ratio(pair: Pair) -> float:
    """Pitches over which one flank of the driver carries, as cut; 0 if the flanks do not meet.

    Contact begins when the driver's flank is met near its root, at its own end or at that of the driven gear's
    tip, whichever is later; it ends the other way round.
    """
    driver, driven = tooth_of(pair.driver.form), tooth_of(pair.driven.form)
    of_driver = [_passage(driver, end, driven, pair.centre_distance) for end in (0, -1)]
    of_driven = [_passage(driven, end, driver, pair.centre_distance) for end in (-1, 0)]
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
    seen = apart - _flank(gear)[end] * np.exp(1j * own)
    passing = (np.abs(seen) >= radius[0]) & (np.abs(seen) <= radius[-1])
    if not passing.any():
        return None
    turned = np.angle(seen) - np.interp(np.abs(seen), radius, polar)
    room = turned + own * gear.form.teeth / other.form.teeth
    least = int(np.argmin(np.where(passing, room, np.inf)))
    return float(own[least]), float(turned[least]), bool(passing[max(least - 1, 0) : least + 2].all())


def _flank(tooth: Tooth) -> Points:
    return tooth.upper_flank.point(np.linspace(0.0, 1.0, NODES))
