"""Checks of a gear train: its teeth in mesh, as cut and at the limits of the tolerances, and its parts at rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum
from functools import cache
from math import pi
from typing import NamedTuple

from cadgen.check import Check, CheckCode
from cadgen.gears.backlash import StagePlay
from cadgen.gears.contact import LEAST_CONTACT_RATIO, LEAST_ROOT_CLEARANCE, contact_ratio, found_contact_ratio
from cadgen.gears.layout import TrainLayout
from cadgen.gears.thinning import with_deviations
from cadgen.gears.train import GearPair, Train
from cadgen.meshes.prisms import body_mesh
from cadgen.meshes.teeth import LEAST_OVERLAP, MeasuredPair, measured_pair, return_error

# Greatest difference of a measured play from the computed play, µm of arc on the driven gear's pitch circle.
PLAY_LIMIT_UM = 0.5
# Greatest difference of the contact ratio measured on the curves from that of the formula.
CONTACT_RATIO_ERROR = 0.01
# Positions of the driver over one pitch at which the teeth are set against each other.
POSITIONS = 8
# Parts of which a volume in mm³ below this is common only touch: the rounding of the meshes.
OVERLAP_LIMIT = 1e-6

# Advice for a figure that only an error of the program can spoil.
CONTRADICTION = "the teeth contradict the formulas: report this design"


_PLAY = {
    "as cut": CheckCode.PLAY_AS_CUT,
    "greatest": CheckCode.PLAY_GREATEST,
    "least": CheckCode.PLAY_LEAST,
}


class State(NamedTuple):
    """A pair at a centre distance in mm."""

    pair: GearPair
    apart: float


def gear_checks(layout: TrainLayout, plays: Sequence[StagePlay[float]], chords: Sequence[float]) -> tuple[Check, ...]:
    """Every check of a train that is laid out.

    Args:
        layout: train with its parts at their places.
        plays: play of each stage.
        chords: chord tolerance of each part's mesh, mm.
    """
    cut = layout.train.stages
    checks = [*_bodies(layout, chords), *_worst([_of_stage(pair, play) for pair, play in zip(cut, plays, strict=True)])]
    if meshes(cut):
        error = return_error_um(cut, [_built(pair, pair.centre_distance) for pair in cut])
        code, name = CheckCode.RETURN_ERROR, "return error - computed"
        checks.append(Check(code, name, abs(error), "µm", PLAY_LIMIT_UM, "max", "whole train", CONTRADICTION))
    return tuple(checks)


def failing_stages(layout: TrainLayout, plays: Sequence[StagePlay[float]]) -> list[int]:
    """Stages, from 0, whose teeth fail a check of their own."""
    cut = enumerate(zip(layout.train.stages, plays, strict=True))
    return [number for number, (pair, play) in cut if not all(check.passed for check in _of_stage(pair, play))]


def meshes(cut: Sequence[GearPair]) -> bool:
    """Whether the teeth of all stages, as cut, have a play: they neither jam nor pass each other.

    Nor is there one play where at times no tooth is in mesh: a contact ratio below 1.
    """
    return all(_engages(State(pair, pair.centre_distance)) and contact_ratio(pair) >= 1 for pair in cut)


def exact_play(pair: GearPair, centre_distance: float | None = None) -> float:
    """Free angle of the driven gear in rad by the exact geometry of involutes, as cut."""
    apart = pair.centre_distance if centre_distance is None else centre_distance
    deviation = sum(gear.form.tooth_thickness_deviation for gear in (pair.driver, pair.driven))
    return pair.normal_backlash(apart, deviation) / (pair.driven.form.base_diameter / 2)


def play_error_um(pair: GearPair, measured: MeasuredPair) -> float:
    """Measured less computed play as cut, µm of arc on the driven gear's pitch circle.

    `measured` may come from the exact curves or from a file.
    """
    return (measured.play(0.0) - exact_play(pair)) * pair.driven_pitch_radius * 1e3


def return_error_um(cut: Sequence[GearPair], measured: Sequence[MeasuredPair]) -> float:
    """Measured less computed return error as cut, µm of arc on the output wheel's pitch circle."""
    ratios = Train(tuple(cut)).output_ratios
    computed = sum(exact_play(pair) / float(ratio) for pair, ratio in zip(cut, ratios, strict=True))
    return (return_error(measured) - computed) * cut[-1].driven_pitch_radius * 1e3


def cycle(pair: GearPair, built: MeasuredPair) -> tuple[float, float]:
    """Greatest overlap just within the computed play and least just past it, mm², over a whole pitch.

    Just is `PLAY_LIMIT_UM`. `built` may come from the exact curves or from a file.
    """
    half, margin = exact_play(pair) / 2, PLAY_LIMIT_UM * 1e-3 / pair.driven_pitch_radius
    within, past = [], []
    for number in range(POSITIONS):
        angle = 2 * pi / pair.driver.form.teeth * number / POSITIONS
        middle = built.middle(angle)
        within += [built.overlap(angle, middle + side * max(half - margin, 0.0)) for side in (-1, 1)]
        past += [built.overlap(angle, middle + side * (half + margin)) for side in (-1, 1)]
    return max(within), min(past)


def limit_states(pair: GearPair, play: StagePlay[float]) -> tuple[State, State]:
    """States of a pair with the greatest and with the least play.

    Greatest: teeth at E_sni, axes opened by f_a and by both composite errors F_i''. Least: teeth at E_sns, axes
    closer by f_a. This is what eq. 1-11 add up.
    """
    opened = play.f_a + play.driver.tolerances.F_i_radial + play.driven.tolerances.F_i_radial
    return (
        State(with_deviations(pair, play.driver.E_sni, play.driven.E_sni), pair.centre_distance + opened),
        State(with_deviations(pair, play.driver.E_sns, play.driven.E_sns), pair.centre_distance - play.f_a),
    )


@cache  # equal pairs of a train have equal sections
def _built(pair: GearPair, apart: float) -> MeasuredPair:
    return measured_pair(pair, apart)


def _engages(state: State) -> bool:
    built = _built(*state)
    return built.overlap_midway(0.0) <= LEAST_OVERLAP < built.overlap_tooth_on_tooth(0.0)


@cache  # equal stages of a train have equal figures
def _of_stage(pair: GearPair, play: StagePlay[float]) -> tuple[Check, ...]:
    """The teeth of one stage in mesh: as cut over a whole pitch, and at the limits of the tolerances."""
    built = _built(pair, pair.centre_distance)
    module = pair.driver.form.normal_module
    ratio = found_contact_ratio(pair)
    wider = "lower addendum_factor or the profile shifts"
    greatest, least = limit_states(pair, play)
    states = {"as cut": State(pair, pair.centre_distance), "greatest": greatest, "least": least}
    jam, jammed = max((_built(*state).overlap_midway(0.0), name) for name, state in states.items())
    hold, loose = min((_built(*state).overlap_tooth_on_tooth(0.0), name) for name, state in states.items())
    closest = exact_play(*least) * pair.driven_pitch_radius * 1e3
    checks = [
        Check(
            CheckCode.ROOT_CLEARANCE,
            "root clearance",
            min(built.clearances()) / module,
            "modules",
            LEAST_ROOT_CLEARANCE,
            "min",
            advice=wider,
        ),
        Check(
            CheckCode.CONTACT_RATIO, "contact ratio", ratio, "", LEAST_CONTACT_RATIO, "min", advice="give more teeth"
        ),
        Check(
            CheckCode.CONTACT_RATIO_FORMULA,
            "contact ratio - formula",
            abs(ratio - contact_ratio(pair)),
            "",
            CONTACT_RATIO_ERROR,
            "max",
        ),
        Check(CheckCode.TEETH_JAM, "teeth jam", jam, "mm2", LEAST_OVERLAP, "max", jammed, _thinner(closest)),
        Check(CheckCode.TEETH_HOLD, "teeth hold each other", hold, "mm2", LEAST_OVERLAP, "min", loose, _closer(loose)),
    ]
    if _engages(states["as cut"]):
        over, past = cycle(pair, built)
        checks.append(
            Check(
                CheckCode.OVERLAP_WITHIN_PLAY,
                "overlap within the play",
                over,
                "mm2",
                LEAST_OVERLAP,
                "max",
                advice="tips meet roots: " + wider,
            )
        )
        if ratio >= 1:
            code = CheckCode.OVERLAP_PAST_PLAY
            checks.append(Check(code, "overlap past the play", past, "mm2", LEAST_OVERLAP, "min"))
    for name, state in states.items():
        # With a contact ratio below 1 there are places where no tooth is in mesh, and the play is greater.
        if _engages(state) and contact_ratio(state.pair, state.apart) >= 1:
            off = (_built(*state).play(0.0) - exact_play(*state)) * pair.driven_pitch_radius * 1e3
            checks.append(Check(_PLAY[name], f"play - computed, {name}", abs(off), "µm", PLAY_LIMIT_UM, "max"))
    return tuple(check if check.advice else replace(check, advice=CONTRADICTION) for check in checks)


def _thinner(least_play: float) -> str:
    at = f" (the least play by the tolerances is {least_play:.1f} µm)" if least_play <= 0 else ""
    return f"thin the teeth, or set the axes apart{at}"


def _closer(state: str) -> str:
    if state == "greatest":
        return "they pass each other freely where the tolerances open the axes most; lower F_i_radial, f_a or b_r"
    return "they pass each other freely; set the axes closer, or thin the teeth less"


def _bodies(layout: TrainLayout, chords: Sequence[float]) -> list[Check]:
    """The parts at their places as meshes: no two of them may have any volume in common."""
    solids = [
        body_mesh(part.body, chord).solid().transform(part.transform)
        for part, chord in zip(layout.parts, chords, strict=True)
    ]
    shared = [
        ((first ^ second).volume(), f"{layout.parts[i].name}, {layout.parts[j].name}")
        for i, first in enumerate(solids)
        for j, second in enumerate(solids)
        if i < j
    ]
    worst, place = max(shared)
    advice = "give a longer collar, smaller hubs, or more thinning"
    met = place if worst > 0 else ""
    return [Check(CheckCode.BODIES_OVERLAP, "bodies overlap", worst, "mm3", OVERLAP_LIMIT, "max", met, advice)]


def _worst(stages: Sequence[Sequence[Check]]) -> list[Check]:
    """Each check at the stage that comes nearest to its limit, or oversteps it most.

    A stage that does not mesh has fewer checks than others.
    """
    worst: dict[StrEnum, Check] = {}
    for number, checks in enumerate(stages, 1):
        for check in checks:
            placed = replace(check, place=", ".join(filter(None, (f"stage {number}", check.place))))
            nearest = worst.setdefault(check.code, placed)
            if (check.value > nearest.value) if check.bound == "max" else (check.value < nearest.value):
                worst[check.code] = placed
    return list(worst.values())
