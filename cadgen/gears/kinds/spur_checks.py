"""The checks of a pair of spur gears: its teeth in mesh, as cut and at the limits of the tolerances."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from functools import cache
from typing import NamedTuple

from cadgen.check import Bound, Check, CheckCode
from cadgen.gears.backlash import stage_play
from cadgen.gears.contact import LEAST_CONTACT_RATIO, LEAST_ROOT_CLEARANCE, contact_ratio, found_contact_ratio
from cadgen.gears.engaged import CONTRADICTION, LEAST_OVERLAP, PLAY_LIMIT_UM, Engage, cycle
from cadgen.gears.pair import Pair
from cadgen.gears.thinning import with_deviations

# What the contact ratio found on the curves may differ from that of the formula.
CONTACT_RATIO_ERROR = 0.01


class Play(StrEnum):
    """Play at which a pair is looked at: as it is cut, or the greatest or the least within the tolerances."""

    AS_CUT = "as cut"
    GREATEST = "greatest"
    LEAST = "least"


_PLAY = {
    Play.AS_CUT: CheckCode.PLAY_AS_CUT,
    Play.GREATEST: CheckCode.PLAY_GREATEST,
    Play.LEAST: CheckCode.PLAY_LEAST,
}


class State(NamedTuple):
    """A pair as cut, and the distance of its axes in mm."""

    pair: Pair
    apart: float

    def play(self) -> float:
        """Free angle of the driven gear in rad by the exact geometry of involutes."""
        return self.pair.exact_play(self.apart)


def limit_states(pair: Pair) -> tuple[State, State]:
    """States of a pair with the greatest and with the least play.

    Greatest: teeth at E_sni, axes opened by f_a and by both composite errors F_i''. Least: teeth at E_sns, axes
    closer by f_a. This is what eq. 1-11 add up.
    """
    play = stage_play(pair)
    opened = play.f_a + play.driver.tolerances.F_i_radial + play.driven.tolerances.F_i_radial
    return (
        State(with_deviations(pair, play.driver.E_sni, play.driven.E_sni), pair.centre_distance + opened),
        State(with_deviations(pair, play.driver.E_sns, play.driven.E_sns), pair.centre_distance - play.f_a),
    )


def meshes(pair: Pair, engage: Engage) -> bool:
    """Whether the teeth, as cut, have one play: they neither jam nor pass each other, and one pair is always in mesh.

    With a contact ratio below 1 there are places where no tooth is in mesh.
    """
    return _engages(State(pair, pair.centre_distance), engage) and contact_ratio(pair) >= 1


def _engages(state: State, engage: Engage) -> bool:
    built = engage(*state)
    return built.overlap_midway(0.0) <= LEAST_OVERLAP < built.overlap_tooth_on_tooth(0.0)


@cache  # equal stages of a train have equal figures
def pair_checks(pair: Pair, engage: Engage) -> tuple[Check, ...]:
    """The teeth of one stage in mesh: as cut over a whole pitch, and at the limits of the tolerances."""
    built = engage(pair, pair.centre_distance)
    module = pair.driver.form.normal_module
    ratio = found_contact_ratio(pair)
    wider = "lower addendum_factor or the profile shifts"
    greatest, least = limit_states(pair)
    states = {Play.AS_CUT: State(pair, pair.centre_distance), Play.GREATEST: greatest, Play.LEAST: least}
    jam, jammed = max((engage(*state).overlap_midway(0.0), name) for name, state in states.items())
    hold, loose = min((engage(*state).overlap_tooth_on_tooth(0.0), name) for name, state in states.items())
    closest = least.play() * pair.driven_pitch_radius * 1e3
    checks = [
        Check(
            CheckCode.ROOT_CLEARANCE,
            "root clearance",
            min(built.clearances()) / module,
            "modules",
            LEAST_ROOT_CLEARANCE,
            Bound.MIN,
            advice=wider,
        ),
        Check(
            CheckCode.CONTACT_RATIO,
            "contact ratio",
            ratio,
            "",
            LEAST_CONTACT_RATIO,
            Bound.MIN,
            advice="give more teeth",
        ),
        Check(
            CheckCode.CONTACT_RATIO_FORMULA,
            "contact ratio - formula",
            abs(ratio - contact_ratio(pair)),
            "",
            CONTACT_RATIO_ERROR,
            Bound.MAX,
        ),
        Check(CheckCode.TEETH_JAM, "teeth jam", jam, "mm2", LEAST_OVERLAP, Bound.MAX, jammed, _thinner(closest)),
        Check(
            CheckCode.TEETH_HOLD, "teeth hold each other", hold, "mm2", LEAST_OVERLAP, Bound.MIN, loose, _closer(loose)
        ),
    ]
    if _engages(states[Play.AS_CUT], engage):
        over, past = cycle(built, pair.exact_play(), pair.driver.form.teeth, pair.driven_pitch_radius)
        checks.append(
            Check(
                CheckCode.OVERLAP_WITHIN_PLAY,
                "overlap within the play",
                over,
                "mm2",
                LEAST_OVERLAP,
                Bound.MAX,
                advice="tips meet roots: " + wider,
            )
        )
        if ratio >= 1:
            code = CheckCode.OVERLAP_PAST_PLAY
            checks.append(Check(code, "overlap past the play", past, "mm2", LEAST_OVERLAP, Bound.MIN))
    for name, state in states.items():
        # With a contact ratio below 1 there are places where no tooth is in mesh, and the play is greater.
        if _engages(state, engage) and contact_ratio(state.pair, state.apart) >= 1:
            off = (engage(*state).play(0.0) - state.play()) * pair.driven_pitch_radius * 1e3
            checks.append(Check(_PLAY[name], f"play - computed, {name}", abs(off), "µm", PLAY_LIMIT_UM, Bound.MAX))
    return tuple(check if check.advice else replace(check, advice=CONTRADICTION) for check in checks)


def _thinner(least_play: float) -> str:
    at = f" (the least play by the tolerances is {least_play:.1f} µm)" if least_play <= 0 else ""
    return f"thin the teeth, or set the axes apart{at}"


def _closer(state: Play) -> str:
    if state == Play.GREATEST:
        return "they pass each other freely where the tolerances open the axes most; lower F_i_radial, f_a or b_r"
    return "they pass each other freely; set the axes closer, or thin the teeth less"
