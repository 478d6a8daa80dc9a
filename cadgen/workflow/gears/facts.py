"""A planned gear train as plain values for the manifest, the table of parts and machines: µm, mm and degrees."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict
from math import degrees
from typing import Any

from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.gears.backlash import GearPlay, StagePlay, TrainPlay, play_distribution, teeth_of
from cadgen.gears.contact import contact_ratio
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.inspection import Inspection, Limits
from cadgen.gears.joints import WholePlay
from cadgen.gears.layout import TrainLayout
from cadgen.gears.tolerances import (
    span_pitch_deviation,
    tooth_radial_composite_deviation,
    total_pitch_deviation,
    total_profile_deviation,
)
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Gear, GearPair
from cadgen.gears.undercut import missing_shift
from cadgen.meshes.train_checks import exact_play, limit_states
from cadgen.workflow.gears.made import role_of
from cadgen.workflow.gears.plan import GearsPlan

# Shares of the trains made with every contribution free in its zone: so many have less play.
QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
# F_pk is for two pitches up to an eighth of the teeth, by the standard's advice.
SPAN_OF_TEETH = 8
_NO_LENGTHS = ("driver", "driven", "B_max", "B_min")


def plan_facts(plan: GearsPlan) -> dict[str, Any]:
    """Facts on a train before its files."""
    return {
        "design": plan.design.name,
        "source": plan.design.source,
        "overrides": list(plan.design.overrides),
        "design_sha256": plan.design.content_hash,
        "order": plan.order,
        "passed": plan.passed,
        "ratio": str(plan.play.train.ratio),
        "return_error_deg": {
            **return_error(plan.play),
            **_quantiles(plan.play.return_error_distribution(), degrees(1)),
        },
        **_joint_facts(plan),
        "return_error_as_given_deg": return_error(plan.given),
        "return_error_as_given_by_the_standard_deg": _maybe(plan.given_standard),
        "return_error_by_the_standard_deg": _maybe(plan.standard),
        "notes": list(plan.notes),
        "stages": stages_facts(plan.layout, plan.play),
        "ranked": [
            {
                "teeth": teeth_of(play),
                "modules_mm": [pair.driver.form.normal_module for pair in play.train.stages],
                "widths_mm": [[gear.form.width for gear in (pair.driver, pair.driven)] for pair in play.train.stages],
                **return_error(play),
            }
            for play in plan.ranked
        ],
        "skipped": [
            {
                "teeth": teeth_of(skipped.play),
                "greatest": degrees(skipped.play.return_error_max),
                "reason": skipped.reason,
            }
            for skipped in plan.skipped
        ],
        "overridden_tolerances": [
            {
                "where": departure.where,
                "symbol": departure.symbol,
                "used_um": departure.used * 1e3,
                "standard_um": None if departure.standard is None else departure.standard * 1e3,
            }
            for departure in plan.departures
        ],
        "checks": checks_facts(plan.checks),
        "parts": parts_facts(plan.layout, plan.play, plan.inspection),
    }


def stages_facts(layout: TrainLayout, play: TrainPlay) -> list[dict[str, Any]]:
    """Every stage as it is cut, with its play."""
    return [_stage_facts(pair, stage) for pair, stage in zip(layout.train.stages, play.stages, strict=True)]


def checks_facts(checks: Iterable[Check]) -> list[dict[str, Any]]:
    """Every check with its verdict."""
    return [{**asdict(check), "passed": check.passed} for check in checks]


def parts_facts(
    layout: TrainLayout, play: TrainPlay, inspection: Sequence[Sequence[Inspection]]
) -> list[dict[str, Any]]:
    """Facts on every part at its place, with the sizes of its gears for the shop."""
    return [
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
                _gear_facts(form, stage, role_of(play, part.shaft, stage), sizes)
                for form, stage, sizes in zip(part.gears, part.stages, of_part, strict=True)
            ],
        }
        for part, of_part in zip(layout.parts, inspection, strict=True)
    ]


def _joint_facts(plan: GearsPlan) -> dict[str, Any]:
    """Facts on joints and bearings, and the return error with them; empty if the design has none."""
    whole = plan.whole
    if not whole.loose:
        return {}
    return {
        "return_error_with_joints_deg": return_error(whole),
        "joints_deg": [
            {"name": joint.name, "least": degrees(joint.least), "greatest": degrees(joint.greatest)}
            for joint in whole.loose
        ],
    }


def return_error(play: TrainPlay | WholePlay) -> dict[str, float]:
    """Least, mean and greatest return error of a train and its standard deviation, in degrees."""
    spread = play.return_error_distribution()
    return {
        "least": degrees(play.return_error_min),
        "mean": degrees(spread.mean),
        "greatest": degrees(play.return_error_max),
        "std": degrees(spread.std),
    }


def _maybe(play: TrainPlay | None) -> dict[str, float] | None:
    return None if play is None else return_error(play)


def _quantiles(spread: ZoneSum, scale: float) -> dict[str, dict[str, float]]:
    values = scale * spread.quantile(QUANTILES)
    return {"quantiles": dict(zip(map(str, QUANTILES), values.tolist(), strict=True))}


def _stage_facts(pair: GearPair, play: StagePlay[float]) -> dict[str, Any]:
    """Every value of eq. 1-13, the exact plays beside them, and how the play is distributed."""
    loose, tight = limit_states(pair, play)
    arc = pair.driven_pitch_radius * 1e3
    spread = play_distribution(play)
    return {
        "teeth": f"{pair.driver.form.teeth}/{pair.driven.form.teeth}",
        "centre_distance_mm": pair.centre_distance,
        "bearing_span_mm": pair.bearing_span,
        "ratio": str(pair.ratio),
        "contact_ratio": contact_ratio(pair),
        **_in_um({name: value for name, value in asdict(play).items() if name not in _NO_LENGTHS}),
        "play_um": {"mean": spread.mean * 1e3, "std": spread.std * 1e3, **_quantiles(spread, 1e3)},
        "play_as_cut_um": exact_play(pair) * arc,
        "exact_greatest_um": exact_play(*loose) * arc,
        "exact_least_um": exact_play(*tight) * arc,
        "return_error_greatest_deg": degrees(play.B_max),
        "return_error_least_deg": degrees(play.B_min),
        "driver": _tolerance_facts(pair.driver, play.driver),
        "driven": _tolerance_facts(pair.driven, play.driven),
    }


def _tolerance_facts(gear: Gear, play: GearPlay[float]) -> dict[str, Any]:
    """One gear's tolerances, as used, with those of the standard that only its inspection needs, and its limits."""
    form = gear.form
    diameter, module = form.reference_diameter, form.normal_module
    pitches = max(form.teeth // SPAN_OF_TEETH, 2)
    shown: dict[str, float | None] = {**asdict(play.tolerances)}
    rules: dict[str, Callable[[], Any]] = {
        "F_p": lambda: total_pitch_deviation(diameter, module, gear.grade),
        "F_pk": lambda: span_pitch_deviation(diameter, module, pitches, gear.grade),
        "F_alpha": lambda: total_profile_deviation(diameter, module, gear.grade),
        "f_i_radial": lambda: tooth_radial_composite_deviation(diameter, module, gear.grade),
    }
    for symbol, rule in rules.items():
        try:
            shown[symbol] = float(rule())
        except DesignError:
            shown[symbol] = None
    limits = {name: value for name, value in asdict(play).items() if name != "tolerances"}
    return {
        "teeth": form.teeth,
        "undercut_modules": missing_shift(form),
        "grade": gear.grade,
        **_in_um(shown),
        "F_pk_pitches": pitches,
        **_in_um(limits),
    }


def form_facts(form: GearForm) -> dict[str, Any]:
    """Numbers of a gear's teeth: mm and degrees."""
    return {
        "teeth": form.teeth,
        "module_mm": form.normal_module,
        "pressure_angle_deg": degrees(form.normal_pressure_angle),
        "profile_shift": form.profile_shift,
        "width_mm": form.width,
        "tip_diameter_mm": form.tip_diameter,
        "root_diameter_mm": form.root_diameter,
    }


def _gear_facts(form: GearForm, stage: int, play: GearPlay[float], sizes: Inspection) -> dict[str, Any]:
    """Facts on one gear for the shop: one row of the table of parts."""
    return {
        "stage": stage,
        **form_facts(form),
        "E_sn_um": form.tooth_thickness_deviation * 1e3,
        "E_sns_um": play.E_sns * 1e3,
        "E_sni_um": play.E_sni * 1e3,
        "teeth_spanned": sizes.span.teeth_spanned if sizes.span else None,
        **_limits("span", sizes.span.span if sizes.span else None),
        "pin_diameter_mm": sizes.pins.pin_diameter if sizes.pins else None,
        **_limits("over_pins", sizes.pins.over_pins if sizes.pins else None),
    }


def _in_um(values: Mapping[str, float | None]) -> dict[str, float | None]:
    return {f"{name}_um": None if value is None else float(value) * 1e3 for name, value in values.items()}


def _limits(name: str, limits: Limits | None) -> dict[str, float | None]:
    values = (None, None, None) if limits is None else (limits.nominal, limits.upper, limits.lower)
    return {f"{name}_{which}_mm": value for which, value in zip(("nominal", "max", "min"), values, strict=True)}
