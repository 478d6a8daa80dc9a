"""Cylindrical gears, spur or helical: a pair of them as a stage of a train, with its checks in mesh and its figures.

The checks look at the teeth as cut and at the limits of the tolerances. The figures, for the manifest and the table of
parts, are µm, mm and degrees.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from enum import StrEnum
from functools import cache, lru_cache, partial
from math import ceil, degrees, isclose, pi, sin, sqrt, tan
from typing import Any, NamedTuple, Self

from cadgen.check import Bound, Check, CheckCode
from cadgen.errors import DesignError
from cadgen.figures import Facts, Figure, Figures
from cadgen.gears.backlash import GearPlay, StagePlay, cut_to_middle, pair_departures, stage_play
from cadgen.gears.contact import (
    LEAST_CONTACT_RATIO,
    LEAST_ROOT_CLEARANCE,
    contact_ratio,
    found_contact_ratio,
    missing_shift,
)
from cadgen.gears.distribution import quantiles
from cadgen.gears.inspection import Inspection, SizeLimits, gauge_of, inspection_of
from cadgen.gears.internal import require_free, reserves, shortened_ring
from cadgen.gears.pair import GradedGear, Pair, closest
from cadgen.gears.ring import RingForm, cutter_of
from cadgen.gears.sliding import loss_factor, specific_sliding
from cadgen.gears.stage import CONTRADICTION, LEAST_OVERLAP, PLAY_LIMIT_UM, Departure, Engage, Stage, cycle
from cadgen.gears.tolerances import (
    GRADES,
    flank_tolerance,
    span_pitch_deviation,
)
from cadgen.gears.tooth import MOST_TEETH_MORE, GearForm, tooth_of
from cadgen.gears.train import Train
from cadgen.messages import Message
from cadgen.parts.run import lead

# What the contact ratio found on the curves may differ from that of the formula.
CONTACT_RATIO_ERROR = 0.01
# Steps of 0.05 in which shifts that keep their sum are tried.
MOST_SHIFT_STEPS = 13


class PlayState(StrEnum):
    """Play at which a pair is looked at: as it is cut, or the greatest or the least within the tolerances."""

    AS_CUT = "as cut"
    GREATEST = "greatest"
    LEAST = "least"


_PLAY_CHECKS = {
    PlayState.AS_CUT: CheckCode.PLAY_AS_CUT,
    PlayState.GREATEST: CheckCode.PLAY_GREATEST,
    PlayState.LEAST: CheckCode.PLAY_LEAST,
}


_WORDS = {
    PlayState.AS_CUT: Message("as cut"),
    PlayState.GREATEST: Message("greatest"),
    PlayState.LEAST: Message("least"),
}


class PairState(NamedTuple):
    """A pair as cut, and the distance of its axes in mm."""

    pair: Pair
    apart: float

    def play(self) -> float:
        """Free angle of the driven gear in rad by the exact geometry of involutes."""
        return self.pair.exact_play(self.apart)


def limit_states(pair: Pair) -> tuple[PairState, PairState]:
    """States of a pair with the greatest and with the least play.

    Greatest: teeth at E_sni, axes opened by f_a and by both composite errors F_i''. Least: teeth at E_sns, axes
    closer by f_a. This is what eq. 1-11 add up. The axes of an internal pair open its play as they come nearer.
    """
    play = stage_play(pair)
    apart = -1 if pair.internal else 1
    opened = play.f_a + play.driver.tolerances.F_i_radial + play.driven.tolerances.F_i_radial
    return (
        PairState(pair.cut_to(play.driver.E_sni, play.driven.E_sni), pair.centre_distance + apart * opened),
        PairState(pair.cut_to(play.driver.E_sns, play.driven.E_sns), pair.centre_distance - apart * play.f_a),
    )


def teeth_mesh(pair: Pair, engage: Engage) -> bool:
    """Whether the teeth, as cut, have one play: they neither jam nor pass each other, and one pair is always in mesh.

    With a contact ratio below 1 there are places where no tooth is in mesh.
    """
    return _engages(PairState(pair, pair.centre_distance), engage) and contact_ratio(pair) >= 1


def _engages(state: PairState, engage: Engage) -> bool:
    built = engage(*state)
    return built.overlap_midway(0.0) <= LEAST_OVERLAP < built.overlap_tooth_on_tooth(0.0)


WIDER = Message("lower addendum_factor or the profile shifts")


def room_checks(clearance: float, ratio: float, overlap: float, roomier: Message | None) -> tuple[Check, Check]:
    """Clearance of the roots, and contact ratio.

    Args:
        clearance: least clearance between tips and roots, modules (mm over m_n).
        ratio: transverse contact ratio.
        overlap: overlap ratio, 0 of spur gears.
        roomier: numbers with which both hold, in words; None where none are known.
    """
    name = Message("total contact ratio") if overlap else Message("contact ratio")
    roots, teeth = roomier or WIDER, roomier or Message("give more teeth")
    word = Message("root clearance")
    return (
        Check(CheckCode.ROOT_CLEARANCE, word, clearance, "modules", LEAST_ROOT_CLEARANCE, Bound.MIN, advice=roots),
        Check(CheckCode.CONTACT_RATIO, name, ratio + overlap, "", LEAST_CONTACT_RATIO, Bound.MIN, advice=teeth),
    )


def has_room(pair: Pair) -> bool:
    """Whether the teeth of a pair pass roots and fillets of each other, and hand over from one to the next.

    The tips must not reach past the form circle of the other gear, as they do where they dig into its fillets.
    """
    small, large = (gear.form for gear in pair.by_size)
    line, apart = pair.centre_distance * sin(pair.working_pressure_angle), pair.centre_distance

    def along(diameter: float, form: GearForm) -> float:
        return sqrt(max(diameter**2 - form.base_diameter**2, 0.0)) / 2

    tips = [along(form.tip_form_diameter, form) for form in (small, large)]
    roots = [along(tooth_of(form).root_form_diameter, form) for form in (small, large)]
    if pair.internal:
        clear = roots[1] - line >= tips[0] and tips[1] - line >= roots[0]
    else:
        clear = line - roots[1] >= tips[0] and line - tips[1] >= roots[0]
    return clear and roots_clear(pair, apart)


def roots_clear(pair: Pair, apart: float) -> bool:
    """Whether the tips of a pair keep clear of its roots, and its teeth hand over, at a distance of the axes.

    Args:
        pair: pair of gears.
        apart: distance of the axes, mm.
    """
    small, large = (gear.form for gear in pair.by_size)
    if pair.internal:
        gaps = (
            large.root_diameter / 2 - apart - small.tip_diameter / 2,
            large.tip_diameter / 2 - apart - small.root_diameter / 2,
        )
    else:
        gaps = (
            apart - (small.tip_diameter + large.root_diameter) / 2,
            apart - (large.tip_diameter + small.root_diameter) / 2,
        )
    wide = min(gaps) >= LEAST_ROOT_CLEARANCE * small.normal_module
    return wide and contact_ratio(pair, apart) + pair.overlap_ratio >= LEAST_CONTACT_RATIO


@lru_cache(maxsize=64)
def roomier(pair: Pair, in_set: bool) -> Message | None:
    """Numbers near those of a pair whose teeth have room and hand over, in words; None where none were found.

    Tried are the addendum of both, the distance without play where another is given, and profile shifts nearer to 0.
    Then come shifts that thicken the small gear and thin the large one as much, and more teeth in about the same ratio.
    Each is tried at a distance that suits it, which is named where another is given.

    Args:
        pair: pair of gears, as cut.
        in_set: whether it is one of a planetary set, of which only the addendum is tried.
    """

    def suiting(at_distance: bool, driver: Mapping[str, float], driven: Mapping[str, float]) -> float:
        """Distance at which they have room, mm; 0 where they have none."""
        try:
            forms = [
                replace(gear.form, **values)  # type: ignore[arg-type]
                for gear, values in ((pair.driver, driver), (pair.driven, driven))
            ]
            given = (pair.driver, pair.driven)
            one, other = (replace(gear, form=form) for gear, form in zip(given, forms, strict=True))
            apart = closest(*(form.cut_to(0.0) for form in forms)) if at_distance else pair.centre_distance
            return apart if has_room(replace(pair, driver=one, driven=other, centre_distance=apart)) else 0.0
        except DesignError:
            return 0.0

    def at(apart: float, cure: Message) -> Message:
        if not stated:
            return cure
        return Message("{cure}, at centre_distance_mm = {apart:.4f}", cure=cure, apart=apart)

    def shifted(shifts: Sequence[float]) -> Message | None:
        """Profile shifts as a cure, if the teeth have room with them."""
        apart = suiting(True, *({"profile_shift": shift} for shift in shifts))
        one, other = shifts
        return (
            at(apart, Message("give the profile shifts {one:g} and {other:g}", one=one, other=other)) if apart else None
        )

    forms = (pair.driver.form, pair.driven.form)
    given = min(form.addendum_factor for form in forms)
    steps = (round(0.05 * step, 2) for step in range(6, 31))
    for factor in sorted(steps, key=lambda factor: abs(factor - given)):
        if suiting(False, {"addendum_factor": factor}, {"addendum_factor": factor}):
            return Message("give both gears addendum_factor = {factor:g}", factor=factor)
    if in_set:
        return None
    stated = _stands_apart(pair)
    if stated and (apart := suiting(True, {}, {})):
        return Message("give centre_distance_mm = {apart:.4f}", apart=apart)
    for share in (0.75, 0.5, 0.25, 0.0):
        shifts = [round(share * form.profile_shift, 2) for form in forms]
        if any(form.profile_shift for form in forms) and (cure := shifted(shifts)):
            return cure
    for share in (0.75, 0.5, 0.25, 0.0):
        shifts = [round(share * form.profile_shift, 2) for form in forms]
        if apart := suiting(True, *({"profile_shift": shift, "addendum_factor": 1.0} for shift in shifts)):
            cure = Message(
                "give the profile shifts {one:g} and {other:g} and both gears addendum_factor = 1",
                one=shifts[0],
                other=shifts[1],
            )
            return at(apart, cure)
    small = min(form.teeth for form in forms)
    if not pair.internal:
        for more in range(1, MOST_SHIFT_STEPS):
            signs = (1 if form.teeth == small else -1 for form in forms)
            shifts = [round(form.profile_shift + 0.05 * more * s, 2) for form, s in zip(forms, signs, strict=True)]
            if cure := shifted(shifts):
                return cure
    for more in range(1, MOST_TEETH_MORE):
        teeth = [round(form.teeth * (small + more) / small) for form in forms]
        if apart := suiting(True, *({"teeth": each} for each in teeth)):
            return at(apart, Message("give {one} and {other} teeth", one=teeth[0], other=teeth[1]))
    return None


def _stands_apart(pair: Pair) -> bool:
    """Whether the axes of a pair stand at another distance than that without play."""
    try:
        apart = closest(pair.driver.form.cut_to(0.0), pair.driven.form.cut_to(0.0))
        return not isclose(pair.centre_distance, apart, rel_tol=1e-6)
    except DesignError:
        return True


def freedom_checks(jam: tuple[float, str, str], hold: tuple[float, str, str]) -> tuple[Check, Check]:
    """Teeth that neither jam nor pass each other.

    Args:
        jam: greatest overlap midway, mm², its place, and what to do.
        hold: least overlap tooth on tooth, mm², its place, and what to do.
    """
    tight, loose = Message("teeth jam"), Message("teeth hold each other")
    return (
        Check(CheckCode.TEETH_JAM, tight, jam[0], "mm2", LEAST_OVERLAP, Bound.MAX, *jam[1:]),
        Check(CheckCode.TEETH_HOLD, loose, hold[0], "mm2", LEAST_OVERLAP, Bound.MIN, *hold[1:]),
    )


def cycle_checks(within: float, past: float, roomier: Message | None = None) -> tuple[Check, Check]:
    """Teeth over a whole pitch.

    Args:
        within: greatest overlap just within the play, mm².
        past: least overlap just past it, mm².
        roomier: numbers with which tips pass roots, in words; None where none are known.
    """
    inside, outside = Message("overlap within the play"), Message("overlap past the play")
    cure = Message("tips meet roots: {cure}", cure=roomier or WIDER)
    return (
        Check(CheckCode.OVERLAP_WITHIN_PLAY, inside, within, "mm2", LEAST_OVERLAP, Bound.MAX, advice=cure),
        Check(CheckCode.OVERLAP_PAST_PLAY, outside, past, "mm2", LEAST_OVERLAP, Bound.MIN, advice=CONTRADICTION),
    )


def measured_check(state: PlayState, off: float) -> Check:
    """Play that was measured against the computed one.

    Args:
        state: state of the pair.
        off: difference, µm.
    """
    name = Message("play - computed, {state}", state=_WORDS[state])
    return Check(_PLAY_CHECKS[state], name, abs(off), "µm", PLAY_LIMIT_UM, Bound.MAX, advice=CONTRADICTION)


def _finer_grade(pair: Pair) -> int | None:
    """Coarsest grade finer than that of both gears with which the least play is above 0; None where none is.

    Args:
        pair: pair of gears, as cut, whose teeth jam at the least play.
    """
    for grade in range(min(pair.driver.grade, pair.driven.grade) - 1, GRADES.start - 1, -1):
        driver, driven = (replace(gear, grade=grade) for gear in (pair.driver, pair.driven))
        try:
            _, least = limit_states(replace(pair, driver=driver, driven=driven))
            if least.play() > 0:
                return grade
        except DesignError:  # a size that the standard does not cover in that grade
            return None
    return None


@cache  # equal stages of a train have equal figures
def pair_checks(pair: Pair, engage: Engage, in_set: bool = False) -> tuple[Check, ...]:
    """The teeth of one stage in mesh: as cut over a whole pitch, and at the limits of the tolerances.

    Args:
        pair: pair of gears, as cut.
        engage: sections of a pair at a distance of its axes, set against each other.
        in_set: whether it is one of a planetary set, whose other gears depend on its teeth and distance.
    """
    built = engage(pair, pair.centre_distance)
    module = pair.driver.form.normal_module
    ratio = found_contact_ratio(pair)
    overlap = pair.overlap_ratio
    greatest, least = limit_states(pair)
    states = {
        PlayState.AS_CUT: PairState(pair, pair.centre_distance),
        PlayState.GREATEST: greatest,
        PlayState.LEAST: least,
    }
    jam, jammed = max((engage(*state).overlap_midway(0.0), name) for name, state in states.items())
    hold, loose = min((engage(*state).overlap_tooth_on_tooth(0.0), name) for name, state in states.items())
    closest_play = least.play() * pair.driven_pitch_radius * 1e3
    cure = None if has_room(pair) else roomier(pair, in_set)
    thinner = Message("thin the teeth, or set the axes apart")
    if pair.internal:
        thinner = Message("thin the teeth, or set the axes closer")
    if closest_play > 0 and cure:
        thinner = Message("tips meet roots: {cure}", cure=cure)
    elif closest_play <= 0:
        # To whole tens of µm, with as much left as a stage is left that gives no backlash.
        enough = ceil((pair.backlash().pitch * 1e3 - closest_play) / 10 + 1) * 10
        words = {"cure": thinner, "play": f"{closest_play:.1f}", "enough": str(enough)}
        if finer := _finer_grade(pair):
            thinner = Message(
                "{cure} (the least play by the tolerances is {play} µm; a backlash of {enough} µm leaves some, and so "
                "does grade {grade})",
                **words,
                grade=finer,
            )
        else:
            thinner = Message(
                "{cure} (the least play by the tolerances is {play} µm; a backlash of {enough} µm leaves some)", **words
            )
    closer = Message(
        "they pass each other freely; give centre_distance_mm = {apart:.4f}, or thin the teeth less",
        apart=closest(pair.driver.form.cut_to(0.0), pair.driven.form.cut_to(0.0)),
    )
    if loose == PlayState.GREATEST:
        closer = Message(
            "they pass each other freely where the tolerances open the axes most; lower F_i_radial, f_a or b_r"
        )
    formula = abs(ratio - contact_ratio(pair))
    code, name = CheckCode.CONTACT_RATIO_FORMULA, Message("contact ratio - formula")
    checks = [
        *room_checks(min(built.clearances()) / module, ratio, overlap, cure),
        Check(code, name, formula, "", CONTACT_RATIO_ERROR, Bound.MAX),
        *freedom_checks((jam, _WORDS[jammed], thinner), (hold, _WORDS[loose], closer)),
    ]
    if _engages(states[PlayState.AS_CUT], engage):
        over = cycle(built, pair.exact_play(), pair.driver.form.teeth, pair.driven_pitch_radius)
        checks += cycle_checks(*over, cure)[: 2 if ratio >= 1 else 1]
    for each, state in states.items():
        # With a contact ratio below 1 there are places where no tooth is in mesh, and the play is greater.
        if _engages(state, engage) and contact_ratio(state.pair, state.apart) >= 1:
            off = (engage(*state).play(0.0) - state.play()) * pair.driven_pitch_radius * 1e3
            checks.append(measured_check(each, off))
    return tuple(check if check.advice else replace(check, advice=CONTRADICTION) for check in checks)


# F_pk is for two pitches up to an eighth of the teeth, by the standard's advice.
SPAN_OF_TEETH = 8
_NO_LENGTHS = ("driver", "driven", "B_max", "B_min")


def pair_facts(pair: Pair) -> Facts:
    """Every value of eq. 1-13, the exact plays beside them, and how the play is distributed."""
    play = stage_play(pair)
    loose, tight = limit_states(pair)
    arc = pair.driven_pitch_radius * 1e3
    spread = play.distribution()
    return Facts(
        teeth=f"{pair.driver.form.teeth}/{pair.driven.form.teeth}",
        centre_distance_mm=pair.centre_distance,
        bearing_span_mm=pair.bearing_span,
        ratio=str(pair.ratio),
        contact_ratio=contact_ratio(pair),
        loss_factor=loss_factor(pair),
        specific_sliding=list(specific_sliding(pair)),
        **_beyond_spur(pair),
        **_in_um({name: value for name, value in asdict(play).items() if name not in _NO_LENGTHS}),
        play_um={"mean": spread.mean * 1e3, "std": spread.std * 1e3, **quantiles(spread, 1e3)},
        play_as_cut_um=pair.exact_play() * arc,
        exact_greatest_um=loose.play() * arc,
        exact_least_um=tight.play() * arc,
        return_error_greatest_deg=degrees(play.B_max),
        return_error_least_deg=degrees(play.B_min),
        driver=_tolerance_facts(pair.driver, play.driver),
        driven=_tolerance_facts(pair.driven, play.driven),
    )


def _beyond_spur(pair: Pair) -> dict[str, float]:
    """Overlap, axial force and the play by its four names; nothing of spur gears side by side."""
    form = pair.driver.form
    if form.helix_angle == 0 and not pair.internal:
        return {}
    play = pair.backlash()
    said: dict[str, float] = {}
    if form.helix_angle:
        said = {
            "overlap_ratio": pair.overlap_ratio,
            "total_contact_ratio": contact_ratio(pair) + pair.overlap_ratio,
            "axial_force_per_tangential": pair.axial_force,
        }
    if pair.internal:
        room = reserves(pair)
        said |= {
            "reserve_involute_mm": room.involute,
            "reserve_ring_root_mm": room.ring_root,
            "reserve_trochoid_rad": room.trochoid,
            "reserve_trimming_rad": room.trimming,
        }
    return said | {
        "play_base_um": play.base * 1e3,
        "play_normal_um": play.normal * 1e3,
        "play_pitch_circle_um": play.pitch * 1e3,
        "play_driver_angle_deg": degrees(play.driver_angle),
        "play_driven_angle_deg": degrees(play.driven_angle),
    }


def _tolerance_facts(gear: GradedGear, play: GearPlay[float]) -> Facts:
    """Tolerances of a gear as used, with those of the standard that only its inspection needs, and its limits."""
    form = gear.form
    diameter, module = form.reference_diameter, form.normal_module
    pitches = max(form.teeth // SPAN_OF_TEETH, 2)
    shown: dict[str, float | None] = {**asdict(play.tolerances)}
    rules: dict[str, Callable[[], Any]] = {
        symbol: partial(flank_tolerance, symbol, diameter, module, gear.grade)
        for symbol in ("F_p", "F_pk", "F_alpha", "f_i_radial")
    }
    rules["F_pk"] = partial(span_pitch_deviation, diameter, module, pitches, gear.grade)
    for symbol, rule in rules.items():
        try:
            shown[symbol] = float(rule())
        except DesignError:
            shown[symbol] = None
    limits = {name: value for name, value in asdict(play).items() if name != "tolerances"}
    return Facts(
        teeth=form.teeth,
        undercut_modules=missing_shift(form) if form.side > 0 else 0.0,
        grade=gear.grade,
        **_in_um(shown),
        F_pk_pitches=pitches,
        **_in_um(limits),
    )


def form_figures(form: GearForm) -> Figures:
    """Numbers of a gear's teeth, with the circles on which its flanks begin and end."""
    return Figures(
        Figure("teeth", Message("teeth z"), form.teeth),
        Figure("module", Message("module m_n"), form.normal_module, "mm"),
        Figure("pressure_angle", Message("pressure angle"), degrees(form.normal_pressure_angle), "°"),
        Figure("addendum_factor", Message("addendum h_aP"), form.addendum_as_made),
        Figure("dedendum_factor", Message("dedendum h_fP"), form.dedendum_factor),
        *root_figures(form),
        Figure("profile_shift", Message("profile shift x"), form.profile_shift),
        *helix_figures(form),
        Figure("reference_diameter", Message("reference diameter d"), form.reference_diameter, "mm"),
        Figure("base_diameter", Message("base diameter d_b"), form.base_diameter, "mm"),
        Figure("width", Message("face width"), form.width, "mm"),
        Figure("tip_diameter", Message("tip diameter"), form.tip_diameter, "mm"),
        Figure("tip_form_diameter", Message("tip form diameter d_Fa"), form.tip_form_diameter, "mm"),
        Figure("form_diameter", Message("root form diameter"), tooth_of(form).root_form_diameter, "mm"),
        Figure("root_diameter", Message("root diameter, as cut"), form.root_diameter, "mm"),
        Figure("tooth_depth", Message("tooth depth h"), form.side * (form.tip_diameter - form.root_diameter) / 2, "mm"),
    )


def root_figures(form: GearForm) -> tuple[Figure, ...]:
    """Tool that makes the roots: the rack's tip radius, or cutter and rim of a ring."""
    if not isinstance(form, RingForm):
        radius = form.rack_tip_radius_factor
        return (Figure("rack_tip_radius_factor", Message("rack tip radius rho_fP"), radius),)
    cutter = cutter_of(form)
    return (
        Figure("rim_diameter", Message("outer diameter of the ring"), form.rim_diameter, "mm"),
        Figure("cutter_teeth", Message("teeth of the pinion cutter, 0 for an arc"), cutter.teeth if cutter else 0),
    )


def helix_figures(form: GearForm) -> tuple[Figure, ...]:
    """Helix of a gear; nothing of a spur gear."""
    if form.helix_angle == 0:
        return ()
    return (
        Figure("helix_angle", Message("helix angle, + right hand"), degrees(form.helix_angle), "°"),
        Figure("lead", Message("lead"), lead(form.helix_angle, form.reference_diameter), "mm"),
    )


def gear_figures(form: GearForm, limits: tuple[float, float], sizes: Inspection) -> Figures:
    """Dimensions of one gear for the workshop."""
    span, pins, gauge = sizes.span, sizes.pins, gauge_of(form)
    needed: tuple[Figure, ...] = ()
    if form.helix_angle:
        width = span.width_needed if span else sizes.span_needs
        needed = (Figure("span_width_needed", Message("face width that the span needs"), width, "mm"),)
    return Figures(
        *form_figures(form).values(),
        Figure("E_sn", "E_sn", form.tooth_thickness_deviation * 1e3, "µm"),
        Figure("E_sns", "E_sns", limits[0] * 1e3, "µm"),
        Figure("E_sni", "E_sni", limits[1] * 1e3, "µm"),
        Figure("teeth_spanned", Message("teeth spanned"), span.teeth_spanned if span else None),
        *_limits("span", span.span if span else None),
        *needed,
        Figure(gauge.diameter, gauge.diameter_name, pins.pin_diameter if pins else None, "mm"),
        *_limits(gauge.size, pins.over_pins if pins else None),
    )


def _in_um(values: Mapping[str, float | None]) -> dict[str, float | None]:
    return {f"{name}_um": None if value is None else float(value) * 1e3 for name, value in values.items()}


def _limits(name: str, limits: SizeLimits | None) -> Iterator[Figure]:
    values = (None, None, None) if limits is None else (limits.nominal, *limits.by_size)
    for which, value in zip(("nominal", "max", "min"), values, strict=True):
        yield Figure(f"{name}_{which}", name, value, "mm")


TEETH = Message("leave the kind out and give the stage gears with teeth")


@dataclass(frozen=True, slots=True, kw_only=True)
class SpurPair(Pair, Stage):
    """Pair of cylindrical gears as a stage; its numbers and errors are those of `Pair`."""

    @property
    def noun(self) -> str:
        """Spur or helical gears, perhaps one of them internal."""
        form = self.driver.form
        if form.helix_angle == 0:
            return Message("internal gears") if self.internal else Message("spur gears")
        if self.internal:
            return Message("internal helical gears")
        return Message("double helical gears") if form.double else Message("helical gears")

    @property
    def sense(self) -> int:
        """+1 for an internal pair, whose gears turn the same way, else -1."""
        return 1 if self.internal else -1

    @property
    def wheels(self) -> tuple[GearForm, GearForm]:
        """Forms of both gears."""
        return self.driver.form, self.driven.form

    @property
    def plain(self) -> bool:
        """Whether it is of spur gears side by side."""
        return self.driver.form.helix_angle == 0 and not self.internal

    @property
    def label(self) -> str:
        """Teeth of both gears, such as 20/60."""
        return f"{self.driver.form.teeth}/{self.driven.form.teeth}"

    @property
    def module(self) -> float:
        """m_n, mm."""
        return self.driver.form.normal_module

    @property
    def toothed(self) -> bool:
        """Play is the room between flanks."""
        return True

    def play(self) -> StagePlay[float]:
        """Play and return error by eq. 1-13; a `DesignError` for a size that the standards do not cover."""
        return stage_play(self)

    def free_angle(self) -> float:
        """Play of the driven gear as cut, by the exact geometry of involutes, rad."""
        return self.exact_play()

    def efficiency(self, friction: float) -> float:
        """1 − μ H_v, by the loss factor of the teeth as cut.

        Args:
            friction: friction coefficient μ of the flanks.
        """
        return 1 - friction * loss_factor(self)

    def opened(self, clearance: float) -> float:
        """By eq. 1, axes further apart by `clearance`, mm, open 2 C tan(alpha_w) on the pitch circle; in rad.

        Args:
            clearance: growth of the distance of the axes, mm.
        """
        return 2 * clearance * tan(self.working_pressure_angle) / self.driven_pitch_radius

    def as_cut(self) -> Self:
        """The pair with its teeth thinned; a `DesignError` for a tooth that cannot be cut so, or at its limits."""
        return cut_to_middle(self.with_free_tips(), self.play()).fitted()

    def with_free_tips(self) -> Self:
        """The pair with tips of its ring, if it has one, no longer than the pinion's flanks allow.

        A ring whose addendum is as asked for is left as it is.
        """
        ring = self.by_size[1].form
        return self if not isinstance(ring, RingForm) or ring.keeps_addendum else self._with_ring(shortened_ring(self))

    def fitted(self) -> Self:
        """The pair as cut, its ring's tips no longer than the pinion's flanks allow.

        Raises:
            DesignError: tips or teeth of an internal pair that foul.
        """
        if not self.internal:
            return self
        fitted = self._with_ring(shortened_ring(self))
        require_free(fitted, limit_states(fitted))
        return fitted

    def _with_ring(self, ring: RingForm) -> Self:
        if self.driver.form.side < 0:
            return replace(self, driver=replace(self.driver, form=ring))
        return replace(self, driven=replace(self.driven, form=ring))

    def departures(self, number: int) -> tuple[Departure, ...]:
        """Tolerances of both gears that the design overrides.

        Args:
            number: number of the stage.
        """
        return pair_departures(self, number)

    def driven_angle(self, driver_angle: float, direction: float) -> float:
        """Angle of the driven gear whose teeth stand midway between those of the driver at `driver_angle`, in rad.

        Both angles are those of a tooth's middle, and `direction` that from the driver's axis to the driven gear's.
        The phases of both in pitches, counted from the line of centres, add up to half a pitch.

        Args:
            driver_angle: angle of the driver, rad.
            direction: direction from the driver's axis to the driven gear's, rad.
        """
        driver_teeth, driven_teeth = self.driver.form.teeth, self.driven.form.teeth
        if not self.internal:
            phase = driver_teeth * (driver_angle - direction)
            return (direction + pi + (pi - phase) / driven_teeth) % (2 * pi)
        # A pinion meets its ring on the side that is away from the ring's axis.
        towards = direction if self.driver.form.side < 0 else direction + pi
        return (towards + (driver_teeth * (driver_angle - towards) + pi) / driven_teeth) % (2 * pi)

    def meshes(self, engage: Engage) -> bool:
        """Whether the teeth, as cut, have one play all the time."""
        return teeth_mesh(self, engage)

    def checks(self, engage: Engage) -> tuple[Check, ...]:
        """The teeth in mesh, as cut over a whole pitch, and at the limits of the tolerances."""
        return pair_checks(self, engage)

    def notes(self, number: int) -> tuple[str, ...]:
        """Which gears are undercut as they are cut, and how far; an overlap that no pair of teeth carries alone."""
        overlap = self.overlap_ratio
        said: tuple[str, ...] = ()
        if 0 < overlap < 1:
            said = (
                Message(
                    "stage {number} has the overlap ratio {overlap:.2f}; from 1 on a tooth hands over to the next "
                    "without a step, with a width_mm of {width:.4g}",
                    number=number,
                    overlap=overlap,
                    width=min(wheel.width for wheel in self.wheels) / overlap,
                ),
            )
        said += _notes_on_ring(self, number)
        return said + tuple(
            Message(
                "the {role} of stage {number}, of {teeth} teeth, is undercut: as cut it has the profile shift"
                " {shift:.3f}, {missing:.2g} modules less than would leave its flanks whole",
                role=role,
                number=number,
                teeth=gear.form.teeth,
                shift=gear.form.generating_profile_shift,
                missing=missing,
            )
            for role, gear in ((Message("driver"), self.driver), (Message("driven gear"), self.driven))
            if gear.form.side > 0 and (missing := missing_shift(gear.form)) > 0
        )

    @property
    def grades(self) -> tuple[int | None, int | None]:
        """Grades by ISO 1328 of both gears."""
        return self.driver.grade, self.driven.grade

    @property
    def distance_deviation(self) -> float | None:
        """Deviation f_a of the axes' distance, mm."""
        return self.play().f_a

    def entry(self) -> Facts:
        """Every value of eq. 1-13, the exact plays beside them, and how the play is distributed."""
        return pair_facts(self)

    def wheel_figures(self) -> tuple[Figures, Figures]:
        """Form, thickness limits, span and size over pins of both gears; a `DesignError` for pins that do not rest."""
        play, inspections = self.play(), _inspections(self)
        driver, driven = self.wheels
        ratio = Figure("contact_ratio", Message("contact ratio"), contact_ratio(self))
        overlap = (Figure("overlap_ratio", Message("overlap ratio"), self.overlap_ratio),) if self.overlap_ratio else ()
        of_both = Figures(ratio, *overlap)
        return (
            Figures(
                *gear_figures(driver, (play.driver.E_sns, play.driver.E_sni), inspections[0]).values(),
                *of_both.values(),
            ),
            Figures(
                *gear_figures(driven, (play.driven.E_sns, play.driven.E_sni), inspections[1]).values(),
                *of_both.values(),
            ),
        )


def _notes_on_ring(pair: SpurPair, number: int) -> tuple[str, ...]:
    """How far a ring's tips are shortened, and which way it goes together with its pinion."""
    ring = pair.by_size[1].form
    if not isinstance(ring, RingForm):
        return ()
    said: list[str] = []
    if ring.shortened > 0:
        said.append(
            Message(
                "the tips of the ring of stage {number} are shortened to an addendum_factor of {factor:g}, so that "
                "they stay on the pinion's flanks",
                number=number,
                factor=round(ring.addendum_as_made, 6),
            )
        )
    if reserves(pair).trimming < 0:
        said.append(
            Message(
                "put the pinion of stage {number} into its ring along the axes, for the tips do not pass each other "
                "radially",
                number=number,
            )
        )
    return tuple(said)


@lru_cache(maxsize=64)  # of the stages of a train, which is inspected and then written
def _inspections(pair: SpurPair) -> tuple[Inspection, Inspection]:
    """Sizes of both gears that the shop measures, as cut, between E_sns and E_sni."""
    play = pair.play()
    driver, driven = (
        inspection_of(gear.form, limits.E_sns, limits.E_sni, gear.pin_diameter)
        for gear, limits in ((pair.driver, play.driver), (pair.driven, play.driven))
    )
    return driver, driven


def spur_pairs(train: Train, what: str, cure: str = TEETH) -> tuple[SpurPair, ...]:
    """The stages of a train as spur gears.

    Args:
        train: of any kinds.
        what: what is worked out for spur gears alone, with its verb: `the search is`.
        cure: what to do about another kind.

    Raises:
        DesignError: a stage is of another kind.
    """
    for number, stage in enumerate(train.stages, 1):
        if isinstance(stage, SpurPair) and not stage.plain:
            raise DesignError(
                "train.stages.{number} has {kind}, and {what} worked out for spur gears alone: leave helix_angle_deg "
                "and internal out",
                number=number,
                kind=stage.noun,
                what=what,
            )
        if not isinstance(stage, SpurPair):
            raise DesignError(
                "train.stages.{number}.kind names {kind}, and {what} worked out for spur gears alone: {cure}",
                number=number,
                kind=stage.noun,
                what=what,
                cure=cure,
            )
    return tuple(stage for stage in train.stages if isinstance(stage, SpurPair))
