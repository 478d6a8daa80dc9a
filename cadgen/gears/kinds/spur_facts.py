"""A pair of spur gears as plain values for the manifest and the table of parts: µm, mm and degrees."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict
from math import degrees
from typing import Any

from cadgen.errors import DesignError
from cadgen.gears.backlash import GearPlay, stage_play
from cadgen.gears.contact import contact_ratio
from cadgen.gears.distribution import quantiles
from cadgen.gears.inspection import Inspection, Limits
from cadgen.gears.kinds.spur_checks import limit_states
from cadgen.gears.pair import Gear, Pair
from cadgen.gears.tolerances import (
    span_pitch_deviation,
    tooth_radial_composite_deviation,
    total_pitch_deviation,
    total_profile_deviation,
)
from cadgen.gears.tooth import GearForm
from cadgen.gears.undercut import missing_shift

# F_pk is for two pitches up to an eighth of the teeth, by the standard's advice.
SPAN_OF_TEETH = 8
_NO_LENGTHS = ("driver", "driven", "B_max", "B_min")


def pair_facts(pair: Pair) -> dict[str, Any]:
    """Every value of eq. 1-13, the exact plays beside them, and how the play is distributed."""
    play = stage_play(pair)
    loose, tight = limit_states(pair)
    arc = pair.driven_pitch_radius * 1e3
    spread = play.distribution()
    return {
        "teeth": f"{pair.driver.form.teeth}/{pair.driven.form.teeth}",
        "centre_distance_mm": pair.centre_distance,
        "bearing_span_mm": pair.bearing_span,
        "ratio": str(pair.ratio),
        "contact_ratio": contact_ratio(pair),
        **_in_um({name: value for name, value in asdict(play).items() if name not in _NO_LENGTHS}),
        "play_um": {"mean": spread.mean * 1e3, "std": spread.std * 1e3, **quantiles(spread, 1e3)},
        "play_as_cut_um": pair.exact_play() * arc,
        "exact_greatest_um": loose.play() * arc,
        "exact_least_um": tight.play() * arc,
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


def gear_facts(form: GearForm, play: GearPlay[float], sizes: Inspection) -> dict[str, Any]:
    """Dimensions of one gear for the workshop."""
    return {
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
