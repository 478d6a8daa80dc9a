"""Backlash: from tolerances to play by eq. 1-13 of the paper for a pair of gears, with least values too.

The symbols are the paper's. Its lengths called "normal backlash" (j_bn1, j_bn2, j_bn3) are arcs of the pitch
circle: widening the axes by Δa opens 2 Δa tan α there, and thinning a tooth by E opens E. Only along the
line of action are they shorter, by cos α. With the paper's α_t = 0, eq. 12 leaves them as they are, and
eq. 13 is right; with α_t = α it would count cos α twice. `Pair.base_backlash` is the true one.

For profile-shifted pairs the arcs on the reference circles are carried over to the working pitch circles by the factor
cos α / cos α_w. Of helical gears the equations are taken in the transverse section. There the thickness deviation E_sn,
which is normal to the tooth, and the allowances across the flanks are arcs of 1 / cos β times their size. Axes further
apart than the teeth need add the nominal play j_bn0. For unshifted pairs at a = m Σz / 2 the factor is 1, j_bn0 is 0,
and every line is the paper's.

The least play is that of the closest axes (a − f_a), the thickest teeth (E_sns on both gears) and gears
without composite error: j_bnmin = j_bn0 − j_bn1 − ΣE_sns. By eq. 7 that is (j_bnmin_required + j_n)/cos α
for unshifted pairs: what eq. 6 asks for, and the room j_n for the errors that eq. 3 reckons with.

The thickness to which a gear is cut is the middle of its zone, which is T_sn wide: by default the zone from E_sni to
E_sns. A gear that is to be cut to another thickness (`GradedGear.thinning`) has the same zone about that thickness.
Where its upper limit leaves less than the axes may close, the least play is negative: the teeth may jam.

Teeth that this thinning destroys are refused by `cut_to_middle`, with what thins most.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, tan
from typing import Any, Generic, TypeVar

import numpy as np

from cadgen.errors import DesignError
from cadgen.gears.choices import Law, Thinning
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.pair import GradedGear, Pair
from cadgen.gears.stage import Departure
from cadgen.gears.tolerances import (
    GearTolerances,
    T,
    centre_distance_deviation,
    gear_tolerance,
    gear_tolerances,
)
from cadgen.gears.tooth import GearForm, ToothError
from cadgen.messages import Message, joined

# The paper's "end face angle" of eq. 3 and 12, and the base helix angle of spur gears (see above).
ALPHA_T = 0.0
BETA_B = 0.0
CONTRIBUTIONS = (
    Message("centre distance"),
    Message("driver's tooth thickness"),
    Message("driven gear's tooth thickness"),
    Message("driver's composite error"),
    Message("driven gear's composite error"),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class GearPlay(Generic[T]):
    """Part of a stage's play that one gear has, mm.

    E_sns (eq. 7), E_sni (eq. 9) and T_sn (eq. 8) are on the reference circle, E_sns and E_sni as the gear is made:
    about the thickness that it is cut to. `thickness_min` and `thickness_max` are what E_sns and E_sni open,
    `composite_max` what F_i'' opens, on the pitch circle.
    """

    tolerances: GearTolerances[T]
    f_sigma_beta: T
    T_sn: T
    E_sns: T
    E_sni: T
    thickness_min: T
    thickness_max: T
    composite_max: T


@dataclass(frozen=True, slots=True, kw_only=True)
class StagePlay(Generic[T]):
    """Every value of eq. 1-13 for one stage (or, as arrays, for many), lengths in mm and B in rad.

    f_a is the centre distance's deviation; f_sigma_beta (eq. 4, the lesser of both gears') and f_sigma_delta
    (eq. 5) are the axes' parallelism; j_n (eq. 3) is the allowance for manufacture and assembly,
    j_bnmin_required what eq. 6 asks for. j_bn0 is the nominal play; j_bn1 (eq. 1), j_bn2 (eq. 2) and j_bn3
    (eq. 10) are the greatest from axes, teeth and composite error. j_bnmax (eq. 11), j_wt_max (eq. 12) and
    B_max (eq. 13, at the driven gear) are the greatest totals, j_bnmin, j_wt_min and B_min the least.
    """

    driver: GearPlay[T]
    driven: GearPlay[T]
    f_a: T
    f_sigma_beta: T
    f_sigma_delta: T
    j_n: T
    j_bnmin_required: T
    E_sns: T
    j_bn0: T
    j_bn1: T
    j_bn2: T
    j_bn3: T
    j_bnmax: T
    j_bnmin: T
    j_wt_max: T
    j_wt_min: T
    B_max: T
    B_min: T

    def distribution(self: StagePlay[float], law: Law = Law.NORMAL) -> ZoneSum:
        """Distribution of the play on the pitch circle, in mm.

        Five independent contributions: the centre distance within ± f_a about a, each gear's thickness from E_sns
        to E_sni, each gear's composite error from 0 to F_i''.
        """
        gears = (self.driver, self.driven)
        thickness: list[tuple[float, float]] = [(gear.thickness_min, gear.thickness_max) for gear in gears]
        composite: list[tuple[float, float]] = [(0.0, gear.composite_max) for gear in gears]
        axes = (self.j_bn0 - self.j_bn1, self.j_bn0 + self.j_bn1)
        low, high = np.array([axes, *thickness, *composite]).T
        return ZoneSum(names=CONTRIBUTIONS, low=low, high=high, law=law)


def play_equations(
    driver: GearTolerances[T],
    driven: GearTolerances[T],
    *,
    f_a: T,
    j_bn0: T,
    module: T,
    alpha_n: float,
    alpha_w: float,
    centre_distance: T,
    span_to_widths: tuple[T, T],
    driven_pitch_radius: T,
    thinning: tuple[Thinning | float, Thinning | float] = (Thinning.MIDDLE, Thinning.MIDDLE),
    alpha_t: float | None = None,
    beta: float = 0.0,
    zones: tuple[float | None, float | None] = (None, None),
) -> StagePlay[T]:
    """Eq. 1-13 on given tolerances, in mm and rad; the sizes may be arrays of one shape.

    Args:
        driver, driven: tolerances of both gears, mm.
        f_a: deviation of the distance of the axes, mm.
        j_bn0, module: normal backlash of nominal teeth, and normal module, mm.
        alpha_n, alpha_w: normal and working pressure angle, rad.
        centre_distance: distance of the axes, mm.
        span_to_widths: ratio l/b of the bearings' span to the face width, for the driver and for the driven gear.
        driven_pitch_radius: radius of the driven gear's working pitch circle, mm.
        thinning: limit to which the teeth of both are thinned, or their deviation, mm.
        alpha_t: transverse pressure angle, rad; that of spur gears if left out.
        beta: helix angle, rad.
        zones: widths T_sn of the zones of the thickness in place of eq. 8, mm; None for that.
    """
    tan_n, tan_w, cos_n, cos_t = np.tan(alpha_n), np.tan(alpha_w), np.cos(alpha_n), np.cos(ALPHA_T)
    across = np.cos(beta)  # a normal thickness as a share of the arc in the transverse section
    onto_pitch_circle = np.cos(alpha_n if alpha_t is None else alpha_t) / across / np.cos(alpha_w)
    gears = (driver, driven)
    parallelism = [0.5 * ratio * gear.F_beta for ratio, gear in zip(span_to_widths, gears, strict=True)]
    f_sigma_beta = np.minimum(parallelism[0], parallelism[1])
    f_sigma_delta = 2 * f_sigma_beta
    allowance = (f_sigma_delta * np.sin(alpha_n)) ** 2 + (f_sigma_beta * cos_n) ** 2
    for gear in gears:
        allowance = allowance + (gear.f_pt * cos_t) ** 2 + (gear.F_beta * cos_n) ** 2
    j_n = np.sqrt(allowance)
    j_bnmin_required = 2 / 3 * (0.06 + 0.0005 * centre_distance + 0.03 * module)
    E_sns = -(f_a * tan_w + (j_bnmin_required + j_n) / (2 * cos_n) / across) / onto_pitch_circle
    plays = []
    for gear, f_own, aim, zone in zip(gears, parallelism, thinning, zones, strict=True):
        T_sn = 2 * tan_n * np.hypot(gear.F_r, gear.b_r) if zone is None else zone
        upper = E_sns + _zone_shift(aim, E_sns, T_sn)
        plays.append(
            GearPlay(
                tolerances=gear,
                f_sigma_beta=f_own,
                T_sn=T_sn,
                E_sns=upper,
                E_sni=upper - T_sn,
                thickness_min=-onto_pitch_circle * upper,
                thickness_max=-onto_pitch_circle * (upper - T_sn),
                composite_max=2 * gear.F_i_radial * tan_w,
            )
        )
    j_bn1 = 2 * f_a * tan_w
    j_bn2 = plays[0].thickness_max + plays[1].thickness_max
    j_bn3 = plays[0].composite_max + plays[1].composite_max
    j_bnmax = j_bn0 + j_bn1 + j_bn2 + j_bn3
    j_bnmin = j_bn0 - j_bn1 + plays[0].thickness_min + plays[1].thickness_min
    j_wt_max, j_wt_min = (j_bn / (cos_t * np.cos(BETA_B)) for j_bn in (j_bnmax, j_bnmin))
    return StagePlay(
        driver=plays[0],
        driven=plays[1],
        f_a=f_a,
        f_sigma_beta=f_sigma_beta,
        f_sigma_delta=f_sigma_delta,
        j_n=j_n,
        j_bnmin_required=j_bnmin_required,
        E_sns=E_sns,
        j_bn0=j_bn0,
        j_bn1=j_bn1,
        j_bn2=j_bn2,
        j_bn3=j_bn3,
        j_bnmax=j_bnmax,
        j_bnmin=j_bnmin,
        j_wt_max=j_wt_max,
        j_wt_min=j_wt_min,
        B_max=j_wt_max / driven_pitch_radius,
        B_min=j_wt_min / driven_pitch_radius,
    )


def stage_play(pair: Pair) -> StagePlay[float]:
    """Play and return error of one stage, by the standards' tolerances or their overrides.

    f_a follows the coarser of both grades. Raises `DesignError` for a size that the standards do not cover.
    """
    form, mesh, f_a = pair.driver.form, pair.working_pressure_angle, pair.centre_distance_deviation
    return play_equations(
        gear_tolerances_of(pair.driver),
        gear_tolerances_of(pair.driven),
        f_a=float(centre_distance_deviation(pair.centre_distance, pair.grade)) if f_a is None else f_a,
        j_bn0=pair.base_backlash(pair.centre_distance) / float(np.cos(mesh)),
        module=form.normal_module,
        alpha_n=form.normal_pressure_angle,
        alpha_w=mesh,
        centre_distance=pair.centre_distance,
        span_to_widths=(pair.bearing_span / form.width, pair.bearing_span / pair.driven.form.width),
        driven_pitch_radius=pair.driven_pitch_radius,
        thinning=(pair.driver.thinning, pair.driven.thinning),
        alpha_t=form.transverse_pressure_angle,
        beta=form.helix_angle,
        zones=(pair.driver.thickness_tolerance, pair.driven.thickness_tolerance),
    )


def pair_departures(pair: Pair, number: int) -> tuple[Departure, ...]:
    """Every override of a pair, stage `number` of its train, beside the standard's value."""
    departures = []
    for role, gear in ((Message("driver"), pair.driver), (Message("driven gear"), pair.driven)):
        sizes = (gear.form.reference_diameter, gear.form.normal_module, gear.form.width, gear.grade)
        where = Message("stage {number}, {role} of {teeth} teeth", number=number, role=role, teeth=gear.form.teeth)
        for symbol, used in gear.overrides.overridden().items():
            standard = _standard(gear_tolerance, symbol, *sizes)
            departures.append(Departure(where=where, symbol=symbol, used=used, standard=standard))
    if pair.centre_distance_deviation is not None:
        standard = _standard(centre_distance_deviation, pair.centre_distance, pair.grade)
        used = pair.centre_distance_deviation
        departures.append(
            Departure(where=Message("stage {number}", number=number), symbol="f_a", used=used, standard=standard)
        )
    return tuple(departures)


def _zone_shift(aim: Thinning | float, E_sns: T, T_sn: T) -> T | float:
    """Height of the thickness zone over the zone of the grade, mm; the gear is cut to the middle of its zone."""
    if aim == Thinning.MIDDLE:
        return 0.0
    if isinstance(aim, str):
        return T_sn / 2 if aim == Thinning.LEAST else -T_sn / 2
    return aim - (E_sns - T_sn / 2)


def _standard(rule: Callable[..., Any], *arguments: Any) -> float | None:
    try:
        return float(rule(*arguments))
    except DesignError:
        return None


def gear_tolerances_of(gear: GradedGear) -> GearTolerances[float]:
    """Tolerances of a gear by its grade, or overrides in their place, mm."""
    form = gear.form
    return gear_tolerances(form.reference_diameter, form.normal_module, form.width, gear.grade, gear.overrides)


P = TypeVar("P", bound=Pair)


def cut_to_middle(pair: P, play: StagePlay[float]) -> P:
    """The pair with every tooth thinned to the middle of its limits E_sns and E_sni.

    Raises `DesignError`, with what thins most, for a tooth that cannot be cut so or at its limits.
    """
    gears = ((pair.driver, play.driver), (pair.driven, play.driven))
    return pair.cut_to(*(_deviation(gear, limits, pair, play) for gear, limits in gears))


def _deviation(gear: GradedGear, limits: GearPlay[float], pair: Pair, play: StagePlay[float]) -> float:
    """E_sn of one gear in mm, after its tooth has been tried at full thickness, as cut and at both limits."""
    prescribed = None if isinstance(gear.thinning, str) else gear.thinning
    asked = limits.E_sns - 0.5 * limits.T_sn if prescribed is None else prescribed
    every = (0.0, asked, limits.E_sns, limits.E_sni)
    try:
        gear.form.cut_to(0.0).tooth  # noqa: B018
    except ToothError as error:
        raise ToothError(error.fault, error.tried(gear.form.cut_to(0.0), every)) from error
    for deviation, what in (
        (asked, Message("cut")),
        (limits.E_sns, Message("at the upper limit of its thickness")),
        (limits.E_sni, Message("at the lower limit of its thickness")),
    ):
        try:
            gear.form.cut_to(deviation).tooth  # noqa: B018
        except ToothError as error:
            cures: list[str] = [error.tried(gear.form.cut_to(deviation), every)]
            source = Message("for E_sn = {given:.5g} µm, which is given", given=asked * 1e3)
            if prescribed is None:
                cures.insert(0, _source(gear, limits, pair, play))
            elif (nearer := _nearer_to_nominal(gear.form, prescribed, limits.T_sn)) is not None:
                thinned = Message("thin it to no more than E_sn = {value:g} µm", value=nearer * 1e3)
                cures = [thinned] if cures == [error.cure] else [*cures, thinned]
            raise DesignError(
                "{fault}, {what} with E_sn = {deviation:.5g} µm, {cure}",
                fault=error.fault,
                what=what,
                deviation=deviation * 1e3,
                cure=joined(cures, ", or ") if prescribed is None else joined([source, joined(cures, ", or ")], "; "),
            ) from error
    return asked


def _nearer_to_nominal(form: GearForm, given: float, width: float) -> float | None:
    """Thickness deviation in mm nearer to 0 with which a tooth can be cut, also at both limits; None without any.

    Args:
        form: gear whose tooth cannot be cut.
        given: deviation that the design gives, mm.
        width: width of the zone about it, mm.
    """
    for share in (*range(9, 0, -1), 0.5, 0.2, 0.1, 0):  # tenths of the given one, to whole µm
        value: float = round(given * share * 100) / 1e3
        try:
            for deviation in (value - width / 2, value, value + width / 2):
                form.cut_to(deviation).tooth  # noqa: B018
        except DesignError:
            continue
        return value
    return None


def _source(gear: GradedGear, limits: GearPlay[float], pair: Pair, play: StagePlay[float]) -> Message:
    """The term of eq. 7-9 that thins most, with its values, and how to lessen it, in words."""
    alpha_n, alpha_w = pair.driver.form.normal_pressure_angle, pair.working_pressure_angle
    own = limits.tolerances
    parts = (
        (
            play.f_a * tan(alpha_w),
            Message("f_a = {f_a:.5g} µm of the centre distance; give a smaller f_a", f_a=play.f_a * 1e3),
        ),
        (
            play.j_bnmin_required / (2 * cos(alpha_n)),
            Message("j_bnmin of eq. 6; give a smaller module or centre distance"),
        ),
        (
            play.j_n / (2 * cos(alpha_n)),
            Message(
                "j_n = {j_n:.5g} µm, of F_beta, f_pt and the axes' parallelism over the bearing span of {span:g} mm;"
                " give a shorter span, wider gears or a finer grade",
                j_n=play.j_n * 1e3,
                span=pair.bearing_span,
            ),
        ),
        (
            limits.T_sn,
            Message(
                "T_sn = {T_sn:.5g} µm, from F_r = {F_r:.5g} and b_r = {b_r:.5g} µm (grade {grade}); give a finer grade,"
                " smaller values or a larger module",
                T_sn=limits.T_sn * 1e3,
                F_r=own.F_r * 1e3,
                b_r=own.b_r * 1e3,
                grade=gear.grade,
            ),
        ),
    )
    return Message("most of it for {term}", term=max(parts, key=lambda part: part[0])[1])
