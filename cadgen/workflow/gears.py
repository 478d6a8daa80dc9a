"""From a design to a checked gear train. No CAD kernel is needed for this."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache
from math import degrees, pi
from typing import Any

from cadgen.cam.check import Check
from cadgen.design import gears as stages
from cadgen.design.schema import Design
from cadgen.gears.backlash import Departure, StagePlay, TrainPlay, departures, train_play
from cadgen.gears.gear_mesh import body_mesh
from cadgen.gears.inspection import Inspection, Limits, inspection_of
from cadgen.gears.layout import TrainLayout, lay_out, thinned, with_deviations
from cadgen.gears.mesh_check import LEAST_OVERLAP, MeasuredPair, contact_ratio, measured_pair, return_error
from cadgen.gears.search import Order, arrange
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import GearPair, Train

Step = Callable[[str], None]

# What a measured play may differ from the computed one, µm of arc on the driven gear's pitch circle.
PLAY_LIMIT_UM = 0.5
# Least contact ratio: with less than one pair in mesh the motion is passed on in jerks; the rest is for errors.
CONTACT_RATIO_LIMIT = 1.1
# What the measured contact ratio may differ from that of the formula.
CONTACT_RATIO_ERROR = 0.01
# Least gap between tips and roots, in modules: half of what ISO 53 profile A leaves with the least thinning.
CLEARANCE_LIMIT = 0.12
# Positions of the driver over one pitch at which the teeth are set against each other.
POSITIONS = 8
# Parts of which a volume in mm³ below this is common only touch: the rounding of the meshes.
OVERLAP_LIMIT = 1e-6


@dataclass(frozen=True)
class GearsPlan:
    """A gear train that has been computed and checked, but not yet made.

    Attributes:
        design: what it was planned from.
        order: `as-given`, `reordered` or `search`.
        given: play of the train as the design has it.
        ranked: the trains that the order calls for, least return error first; the first one is made.
        standard: play of the train that is made, without the design's overrides.
        departures: the overrides beside the standard's values.
        layout: its parts, teeth thinned, at their places.
        inspection: of every part's gears, in the order of the parts.
        checks: every figure with its verdict.
    """

    design: Design
    order: Order
    given: TrainPlay
    ranked: tuple[TrainPlay, ...]
    standard: TrainPlay
    departures: tuple[Departure, ...]
    layout: TrainLayout
    inspection: tuple[tuple[Inspection, ...], ...]
    checks: tuple[Check, ...]

    @property
    def play(self) -> TrainPlay:
        """Play of the train that is made."""
        return self.ranked[0]

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return all(check.passed for check in self.checks)

    def facts(self) -> dict[str, Any]:
        """The plan as plain values for the manifest and for machines."""
        return {
            "design": self.design.name,
            "source": self.design.source,
            "overrides": list(self.design.overrides),
            "design_sha256": self.design.content_hash,
            "order": self.order,
            "passed": self.passed,
            "ratio": str(self.play.train.ratio),
            "return_error_deg": _return_error(self.play),
            "return_error_as_given_deg": _return_error(self.given),
            "return_error_by_the_standard_deg": _return_error(self.standard),
            "stages": [
                _stage_facts(pair, play) for pair, play in zip(self.layout.train.stages, self.play.stages, strict=True)
            ],
            "ranked": [{"teeth": teeth_of(play), **_return_error(play)} for play in self.ranked],
            "overridden_tolerances": [
                {
                    "where": found.where,
                    "symbol": found.symbol,
                    "used_um": found.used * 1e3,
                    "standard_um": None if found.standard is None else found.standard * 1e3,
                }
                for found in self.departures
            ],
            "checks": [{**asdict(check), "passed": check.passed} for check in self.checks],
            "parts": [
                {
                    "name": part.name,
                    "shaft": part.shaft,
                    "axis_mm": [part.axis.real, part.axis.imag],
                    "height_mm": part.height,
                    "angle_deg": degrees(part.angle),
                    "turned_over": part.flipped,
                    "bore_mm": part.blank.bore_diameter,
                    "volume_mm3": part.volume,
                    "gears": [
                        gear_facts(form, stage, found)
                        for form, stage, found in zip(part.gears, part.stages, inspection, strict=True)
                    ],
                }
                for part, inspection in zip(self.layout.parts, self.inspection, strict=True)
            ],
        }


def plan_gears(design: Design, order: Order = "as-given", step: Step = lambda text: None) -> GearsPlan:
    """Compute the train of a design in an order, lay it out, and measure its teeth in mesh.

    Args:
        design: a loaded design.
        order: `as-given`, `reordered` (the best order of the stages) or `search` (the best teeth within the limits).
        step: told what is being done.

    Raises:
        DesignError: the design has no train, or one that cannot be made or laid out.
        CheckError: teeth that jam or do not reach each other.
    """
    keys = stages.train_keys(design)
    given = stages.train(design)
    step("computing play and return error")
    limits = stages.search_limits(design, given) if order == "search" else None
    ranked = arrange(given, order, limits)
    play = ranked[0]
    step("laying out the shafts")
    cut = thinned(play, keys.thinning if keys.E_sn_um is None else keys.E_sn_um * 1e-3)
    directions = stages.directions(design)
    # A searched train of another number of stages finds its own places.
    wanted = directions if len(directions) == len(cut.stages) else None
    layout = lay_out(cut, stages.blanks(design), wanted, keys.clearance_mm)
    step("measuring the teeth in mesh")
    checks = [*_bodies(layout, design.export.mesh_chord_um * 1e-3)]
    checks += _worst([_stage_checks(pair, found) for pair, found in zip(cut.stages, play.stages, strict=True)])
    checks += _train_checks(cut.stages)
    return GearsPlan(
        design=design,
        order=order,
        given=train_play(given),
        ranked=ranked,
        standard=train_play(play.train.by_the_standard()),
        departures=departures(play.train),
        layout=layout,
        inspection=_inspections(layout, play, keys.pin_diameter_mm),
        checks=tuple(checks),
    )


def gear_facts(form: GearForm, stage: int, found: Inspection) -> dict[str, Any]:
    """What the shop is told of one gear: one row of the table of parts."""
    return {
        "stage": stage,
        "teeth": form.teeth,
        "module_mm": form.normal_module,
        "pressure_angle_deg": degrees(form.normal_pressure_angle),
        "profile_shift": form.profile_shift,
        "width_mm": form.width,
        "tip_diameter_mm": form.tip_diameter,
        "root_diameter_mm": form.root_diameter,
        "E_sn_um": form.tooth_thickness_deviation * 1e3,
        "teeth_spanned": found.span.teeth_spanned if found.span else None,
        **_limits("span", found.span.span if found.span else None),
        "pin_diameter_mm": found.pins.pin_diameter if found.pins else None,
        **_limits("over_pins", found.pins.over_pins if found.pins else None),
    }


def teeth_of(play: TrainPlay) -> str:
    """The stages of a train as driver/driven teeth, from the drive on."""
    return " ".join(f"{pair.driver.form.teeth}/{pair.driven.form.teeth}" for pair in play.train.stages)


def play_error_um(pair: GearPair, measured: MeasuredPair) -> float:
    """Measured less computed play as cut, µm of arc on the driven gear's pitch circle.

    `measured` may come from the exact curves or from a file.
    """
    return (measured.play(0.0) - exact_play(pair)) * pair.driven_pitch_radius * 1e3


def return_error_um(cut: Sequence[GearPair], measured: Sequence[MeasuredPair]) -> float:
    """Measured less computed return error as cut, µm of arc on the output wheel's pitch circle."""
    computed = sum(exact_play(pair) / float(ratio) for pair, ratio in zip(cut, _train_ratios(cut), strict=True))
    return (return_error(measured) - computed) * cut[-1].driven_pitch_radius * 1e3


def exact_play(pair: GearPair, centre_distance: float | None = None) -> float:
    """Free angle of the driven gear in rad by the exact geometry of involutes, as cut."""
    apart = pair.centre_distance if centre_distance is None else centre_distance
    deviation = sum(gear.form.tooth_thickness_deviation for gear in (pair.driver, pair.driven))
    return pair.normal_backlash(apart, deviation) / (pair.driven.form.base_diameter / 2)


def measured_stages(cut: Sequence[GearPair]) -> list[MeasuredPair]:
    """Every stage by its exact curves, as cut."""
    return [measured_pair(pair) for pair in cut]


@cache  # equal stages of a train have equal figures
def _stage_checks(pair: GearPair, found: StagePlay[float]) -> list[Check]:
    """The teeth of one stage in mesh: as cut over a whole pitch, and at the limits of the tolerances."""
    built = measured_pair(pair)
    module = pair.driver.form.normal_module
    over, past = _cycle(pair, built)
    ratio, formula = built.contact_ratio(), contact_ratio(pair)
    loose, tight = _at_limits(pair, found)
    wider = "lower addendum_factor or the profile shifts"
    return [
        Check("root clearance", min(built.clearances()) / module, "modules", CLEARANCE_LIMIT, "min", advice=wider),
        Check("contact ratio", ratio, "", CONTACT_RATIO_LIMIT, "min", advice="give more teeth"),
        Check("contact ratio - formula", abs(ratio - formula), "", CONTACT_RATIO_ERROR, "max"),
        Check("overlap within the play", over, "mm2", LEAST_OVERLAP, "max", advice="tips meet roots: " + wider),
        Check("overlap past the play", past, "mm2", LEAST_OVERLAP, "min"),
        Check("play - computed, as cut", abs(play_error_um(pair, built)), "µm", PLAY_LIMIT_UM, "max"),
        Check("play - computed, greatest", abs(loose), "µm", PLAY_LIMIT_UM, "max"),
        Check("play - computed, least", abs(tight), "µm", PLAY_LIMIT_UM, "max"),
    ]


def _cycle(pair: GearPair, built: MeasuredPair) -> tuple[float, float]:
    """Greatest overlap just within the computed play and least just past it, mm², over a whole pitch."""
    half, margin = exact_play(pair) / 2, PLAY_LIMIT_UM * 1e-3 / pair.driven_pitch_radius
    within, past = [], []
    for number in range(POSITIONS):
        angle = 2 * pi / pair.driver.form.teeth * number / POSITIONS
        middle = built.middle(angle)
        within += [built.overlap(angle, middle + side * max(half - margin, 0.0)) for side in (-1, 1)]
        past += [built.overlap(angle, middle + side * (half + margin)) for side in (-1, 1)]
    return max(within), min(past)


def limit_states(pair: GearPair, found: StagePlay[float]) -> tuple[tuple[GearPair, float], tuple[GearPair, float]]:
    """The pair and its centre distance where its play is greatest, and where it is least.

    Greatest: teeth at E_sni, axes opened by f_a and by both composite errors F_i''. Least: teeth at E_sns, axes
    closer by f_a. This is what eq. 1-11 add up.
    """
    opened = found.f_a + found.driver.tolerances.F_i_radial + found.driven.tolerances.F_i_radial
    return (
        (with_deviations(pair, found.driver.E_sni, found.driven.E_sni), pair.centre_distance + opened),
        (with_deviations(pair, found.driver.E_sns, found.driven.E_sns), pair.centre_distance - found.f_a),
    )


def _at_limits(pair: GearPair, found: StagePlay[float]) -> tuple[float, float]:
    """Measured less computed play at its greatest and at its least, µm of arc."""
    to_um = pair.driven_pitch_radius * 1e3
    loose, tight = (
        (measured_pair(cut, apart).play(0.0) - exact_play(cut, apart)) * to_um
        for cut, apart in limit_states(pair, found)
    )
    return loose, tight


def _train_checks(cut: Sequence[GearPair]) -> list[Check]:
    error = return_error_um(cut, measured_stages(cut))
    return [Check("return error - computed", abs(error), "µm", PLAY_LIMIT_UM, "max", "whole train")]


def _bodies(layout: TrainLayout, chord: float) -> list[Check]:
    """The parts at their places as meshes: no two of them may have any volume in common."""
    solids = [body_mesh(part.body, chord).manifold().transform(part.transform) for part in layout.parts]
    shared = [
        ((one ^ two).volume(), f"{layout.parts[i].name}, {layout.parts[j].name}")
        for i, one in enumerate(solids)
        for j, two in enumerate(solids)
        if i < j
    ]
    worst, place = max(shared)
    advice = "give a longer collar, smaller hubs, or more thinning"
    return [Check("bodies overlap", worst, "mm3", OVERLAP_LIMIT, "max", place if worst > 0 else "", advice)]


def _inspections(layout: TrainLayout, play: TrainPlay, pin: float | None) -> tuple[tuple[Inspection, ...], ...]:
    """Of every part's gears between E_sns and E_sni, or about a thinning outside these as wide apart."""
    found = []
    for part in layout.parts:
        of_part = []
        for form, stage in zip(part.gears, part.stages, strict=True):
            role = play.stages[stage - 1].driven if part.shaft > stage else play.stages[stage - 1].driver
            of_part.append(inspection_of(form, *_zone(form, role.E_sns, role.E_sni), pin))
        found.append(tuple(of_part))
    return tuple(found)


def _zone(form: GearForm, upper: float, lower: float) -> tuple[float, float]:
    given = form.tooth_thickness_deviation
    if lower <= given <= upper:
        return upper, lower
    half = (upper - lower) / 2
    return given + half, given - half


def _worst(stages: Sequence[Sequence[Check]]) -> list[Check]:
    """Of every check the stage that comes nearest to its limit, or oversteps it most."""
    found = []
    for same in zip(*stages, strict=True):
        worst = (max if same[0].bound == "max" else min)(same, key=lambda check: check.value)
        found.append(replace(worst, place=f"stage {same.index(worst) + 1}"))
    return found


def _train_ratios(cut: Sequence[GearPair]) -> Sequence[Any]:
    return Train(tuple(cut)).output_ratios


def _return_error(play: TrainPlay) -> dict[str, float]:
    spread = play.return_error_distribution()
    return {
        "least": degrees(play.return_error_min),
        "mean": degrees(spread.mean),
        "greatest": degrees(play.return_error_max),
        "std": degrees(spread.std),
    }


def _stage_facts(pair: GearPair, play: StagePlay[float]) -> dict[str, Any]:
    loose, tight = limit_states(pair, play)
    return {
        "teeth": f"{pair.driver.form.teeth}/{pair.driven.form.teeth}",
        "centre_distance_mm": pair.centre_distance,
        "ratio": str(pair.ratio),
        **{f"{name}_um": getattr(play, name) * 1e3 for name in ("j_bn1", "j_bn2", "j_bn3", "j_bnmax", "j_bnmin")},
        "play_as_cut_um": exact_play(pair) * pair.driven_pitch_radius * 1e3,
        "exact_greatest_um": exact_play(*loose) * pair.driven_pitch_radius * 1e3,
        "exact_least_um": exact_play(*tight) * pair.driven_pitch_radius * 1e3,
        "return_error_greatest_deg": degrees(play.B_max),
        "return_error_least_deg": degrees(play.B_min),
    }


def _limits(name: str, found: Limits | None) -> dict[str, float | None]:
    values = (None, None, None) if found is None else (found.nominal, found.upper, found.lower)
    return {f"{name}_{which}_mm": value for which, value in zip(("nominal", "max", "min"), values, strict=True)}
