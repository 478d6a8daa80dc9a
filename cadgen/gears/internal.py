"""Internal pairs: by how much tips and roots of pinion and ring clear each other, and how long the ring's tips may be.

Reserves are positive where nothing fouls. Those of involute and ring root are lengths along the line of action: the
tips of one gear must not reach past the form circle of the other. (Handbooks take the pinion's base circle, which is
weaker.) Those of trochoid and trimming are angles, for teeth without play; with play there is a little more room. A
pair that is trimmed only goes together along its axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import acos, floor, hypot, sin, sqrt

from cadgen.errors import DesignError
from cadgen.gears.pair import Pair, closest
from cadgen.gears.ring import RingForm, TipMesh
from cadgen.gears.tooth import GearForm, tooth_of
from cadgen.messages import Message

# Reserve of the trochoid down to which teeth run free within usual play, rad: found on polygons of pairs with a play of
# 0.06 modules.
LEAST_TROCHOID = -1.4e-3
# Decimals of the addendum to which a ring's tips are shortened.
DECIMALS = 3
# In modules, by which tips are shortened further, for other thicknesses of the teeth within their tolerance.
SPARED = 0.02
# More teeth of a ring than of its pinion that are tried for a pair that does not foul.
MOST_DIFFERENCE = 60
# Lower profile shifts of a ring that are tried, their step, and the addendum that one must leave, in modules.
SHIFTS_TRIED, SHIFT_STEP, LEFT_ADDENDUM = 60, 0.05, 0.3


@dataclass(frozen=True, slots=True, kw_only=True)
class Reserves:
    """Room between pinion and ring beside their flanks; negative where they foul.

    Attributes:
        involute: from the ring's tips to where the pinion's involute begins, along the line of action, mm.
        ring_root: from the pinion's tips to where the ring's involute ends, likewise, mm.
        trochoid: angle by which tips pass each other beside the line of action, rad.
        trimming: angle by which they pass when the pinion moves into the ring radially, rad.
    """

    involute: float
    ring_root: float
    trochoid: float
    trimming: float


def reserves(pair: Pair) -> Reserves:
    """Reserves of an internal pair as cut, at its centre distance."""
    pinion, ring = (gear.form for gear in pair.by_size)
    line = pair.centre_distance * sin(pair.working_pressure_angle)
    tips = tip_mesh(pinion, ring, pair.working_pressure_angle)
    return Reserves(
        involute=_along(ring.tip_diameter, ring) - line - _along(tooth_of(pinion).root_form_diameter, pinion),
        ring_root=_along(tooth_of(ring).root_form_diameter, ring) - line - _along(pinion.tip_diameter, pinion),
        trochoid=tips.trochoid(),
        trimming=tips.trimming(),
    )


def tip_mesh(pinion: GearForm, ring: GearForm, working_angle: float) -> TipMesh:
    """Tips of a pinion and its ring.

    Args:
        pinion: numbers of the pinion.
        ring: numbers of the ring.
        working_angle: working pressure angle, rad.
    """
    return TipMesh(
        pinion.teeth,
        pinion.base_diameter / 2,
        pinion.tip_diameter / 2,
        ring.teeth,
        ring.base_diameter / 2,
        ring.tip_diameter / 2,
        working_angle,
    )


def greatest_addendum(pair: Pair) -> float:
    """Greatest addendum h_a* of the ring whose tips stay on the pinion's involute, in modules."""
    pinion, ring = (gear.form for gear in pair.by_size)
    line = pair.centre_distance * sin(pair.working_pressure_angle)
    reach = line + _along(tooth_of(pinion).root_form_diameter, pinion)
    least = hypot(ring.base_diameter / 2, reach)
    return (ring.reference_diameter / 2 - least) / ring.normal_module - ring.profile_shift


def greatest_pinion_addendum(pair: Pair) -> float:
    """Greatest addendum h_a* of the pinion whose tips stay on the ring's involute, in modules."""
    pinion, ring = (gear.form for gear in pair.by_size)
    line = pair.centre_distance * sin(pair.working_pressure_angle)
    reach = _along(tooth_of(ring).root_form_diameter, ring) - line
    most = hypot(pinion.base_diameter / 2, reach)
    return (most - pinion.reference_diameter / 2) / pinion.normal_module - pinion.profile_shift


def shortened_ring(pair: Pair) -> RingForm:
    """Ring of a pair with tips that stay on the pinion's involute: as cut, and if shortened, for nominal teeth, too.

    Raises:
        DesignError: tips that dig in, of a ring whose addendum is as asked for.
    """
    ring = pair.by_size[1].form
    assert isinstance(ring, RingForm)
    scale = 10**DECIMALS
    most = greatest_addendum(pair)
    if not ring.keeps_addendum:
        most = min(most, greatest_addendum(pair.cut_to(0.0, 0.0))) - SPARED
    most = floor(most * scale) / scale
    if ring.addendum_as_made > most:
        if most <= 0:
            raise DesignError(
                "{pair} has a ring whose tips dig into the roots of the pinion however short they are; {cure}",
                pair=str(pair),
                cure=_other_shift(pair),
            )
        if ring.keeps_addendum:
            raise DesignError(
                "{pair} has a ring whose tips dig into the roots of the pinion: addendum_factor is {addendum:g}; give "
                "the ring at most {most:g}",
                pair=str(pair),
                addendum=ring.addendum_factor,
                most=most,
            )
        return replace(ring, shortened=round(ring.addendum_factor - most, DECIMALS))
    return ring


def _other_shift(pair: Pair) -> Message:
    """Profile shift of a ring that leaves its tips some length, at the distance that suits it, in words."""
    pinion, ring = pair.by_size
    for step in range(1, SHIFTS_TRIED):
        shift = round(ring.form.profile_shift - step * SHIFT_STEP, 2)
        try:
            other = replace(ring, form=replace(ring.form, profile_shift=shift))
            apart = closest(pinion.form.cut_to(0.0), other.form.cut_to(0.0))
            if greatest_addendum(replace(pair, driver=pinion, driven=other, centre_distance=apart)) > LEFT_ADDENDUM:
                return Message(
                    "give the ring profile_shift = {shift:g}, at a centre_distance_mm of {apart:.4f}",
                    shift=shift,
                    apart=floor(apart * 1e4) / 1e4,
                )
        except DesignError:
            continue
    return Message(
        "lower the profile_shift of the ring ({shift:g}), or raise that of the pinion ({other:g})",
        shift=ring.form.profile_shift,
        other=pinion.form.profile_shift,
    )


def require_free(pair: Pair, limits: Sequence[tuple[Pair, float]] = ()) -> None:
    """Refuse an internal pair whose teeth foul beside their flanks, as cut or at the limits of its tolerances.

    Args:
        pair: pair as cut.
        limits: pairs at their limits, each with the distance of its axes, mm.

    Raises:
        DesignError: pinion tips that dig into the ring's roots, or tips that foul beside the line of action.
    """
    pinion, ring = (gear.form for gear in pair.by_size)
    room = reserves(pair)
    if room.ring_root < 0:
        raise DesignError(
            "{pair} has a pinion whose tips dig into the roots of the ring: addendum_factor is {addendum:g}; give the "
            "pinion at most {most:g}",
            pair=str(pair),
            addendum=pinion.addendum_factor,
            most=floor(greatest_pinion_addendum(pair) * 1e3) / 1e3,
        )
    worst, closer = room.trochoid, 0.0
    fouls = worst < LEAST_TROCHOID
    for state, apart in limits:
        least, most = (gear.form for gear in state.by_size)
        try:
            reserve = tip_mesh(least, most, state.pressure_angle(apart)).trochoid()
        except DesignError:  # the base circles overlap at the least distance of the axes
            fouls, closer = True, max(closer, pair.centre_distance - apart)
            continue
        # At the greatest play tips that foul take some of it, so that it is not what the formula says.
        worst, fouls = min(worst, reserve), fouls or reserve < 0
    if fouls:
        raise DesignError(
            "{pair} fouls beside the line of action, as the ring has only {difference} teeth more; {cure}",
            pair=str(pair),
            difference=ring.teeth - pinion.teeth,
            cure=_larger_ring(pinion, ring, room.trochoid - worst, closer),
        )


def _larger_ring(pinion: GearForm, ring: GearForm, spread: float, closer: float) -> Message:
    """Fewest teeth of a ring that clears the pinion, and the distance of their axes then.

    Args:
        pinion: numbers of the pinion.
        ring: numbers of the ring.
        spread: angle by which the tolerances take from the reserve, rad.
        closer: distance by which they bring the axes nearer, mm, where `spread` does not count it.
    """
    for teeth in range(max(ring.teeth, pinion.teeth) + 1, pinion.teeth + MOST_DIFFERENCE):
        try:
            larger = replace(ring, teeth=teeth)
            apart = closest(pinion, larger)
        except DesignError:
            continue
        base = (larger.base_diameter - pinion.base_diameter) / 2
        if apart - closer < base:
            continue
        angle = acos(base / (apart - closer))
        if tip_mesh(pinion, larger, angle).trochoid() > spread:
            return Message(
                "give the ring at least {teeth} teeth, at a centre_distance_mm of {apart:.4f}",
                teeth=teeth,
                apart=floor(apart * 1e4) / 1e4,
            )
    return Message("give it a smaller addendum_factor")


def _along(diameter: float, form: GearForm) -> float:
    """Length of the tangent from the base circle to a circle, mm."""
    return sqrt(max(diameter**2 - form.base_diameter**2, 0.0)) / 2
