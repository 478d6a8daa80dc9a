"""Teeth as they are cut, in the middle of their thickness limits, and what to do about teeth that this destroys."""

from __future__ import annotations

from dataclasses import replace
from math import cos, tan
from typing import TypeVar

from cadgen.errors import DesignError
from cadgen.gears.backlash import GearPlay, StagePlay
from cadgen.gears.pair import Gear, Pair
from cadgen.gears.tooth import GearForm, tooth_of

P = TypeVar("P", bound=Pair)


def as_cut(pair: P, play: StagePlay[float]) -> P:
    """The pair with every tooth thinned to the middle of its limits E_sns and E_sni.

    Raises `DesignError`, with what thins most, for a tooth that cannot be cut so or at its limits.
    """
    gears = ((pair.driver, play.driver), (pair.driven, play.driven))
    return with_deviations(pair, *(_deviation(gear, limits, pair, play) for gear, limits in gears))


def with_deviations(pair: P, driver: float, driven: float) -> P:
    """The pair with teeth cut to E_sn = `driver` and `driven`, in mm.

    Args:
        pair: pair of gears.
        driver: deviation E_sn of the driver, mm.
        driven: deviation E_sn of the driven gear, mm.
    """
    driver_cut, driven_cut = (
        replace(gear, form=with_deviation(gear.form, deviation))
        for gear, deviation in ((pair.driver, driver), (pair.driven, driven))
    )
    return replace(pair, driver=driver_cut, driven=driven_cut)


def with_deviation(form: GearForm, deviation: float) -> GearForm:
    """`form` cut with the tooth-thickness deviation E_sn = `deviation` (mm).

    Args:
        form: numbers of the teeth.
        deviation: deviation E_sn of the tooth thickness, mm.
    """
    return replace(form, tooth_thickness_deviation=deviation)


def _deviation(gear: Gear, limits: GearPlay[float], pair: Pair, play: StagePlay[float]) -> float:
    """E_sn of one gear in mm, after its tooth has been tried at full thickness, as cut and at both limits."""
    tooth_of(with_deviation(gear.form, 0.0))
    prescribed = None if isinstance(gear.thinning, str) else gear.thinning
    asked = limits.E_sns - 0.5 * limits.T_sn if prescribed is None else prescribed
    for deviation, what in (
        (asked, "cut"),
        (limits.E_sns, "at the upper limit of its thickness"),
        (limits.E_sni, "at the lower limit of its thickness"),
    ):
        try:
            tooth_of(with_deviation(gear.form, deviation))
        except DesignError as error:
            fault, _, cure = str(error).partition("; ")
            source = (
                _source(gear, limits, pair, play)
                if prescribed is None
                else f"for E_sn = {prescribed * 1e3:.5g} µm, which is given; give one nearer to 0"
                if deviation != asked
                else "which is given; give one nearer to 0"
            )
            shifted = f", or {cure}" if gear.form.profile_shift else ""
            raise DesignError(f"{fault}, {what} with E_sn = {deviation * 1e3:.5g} µm, {source}{shifted}") from error
    return asked


def _source(gear: Gear, limits: GearPlay[float], pair: Pair, play: StagePlay[float]) -> str:
    """The term of eq. 7-9 that thins most, with its values, and how to lessen it, in words."""
    alpha_n, alpha_w = pair.driver.form.normal_pressure_angle, pair.working_pressure_angle
    own = limits.tolerances
    parts = {
        f"f_a = {play.f_a * 1e3:.5g} µm of the centre distance; give a smaller f_a": play.f_a * tan(alpha_w),
        "j_bnmin of eq. 6; give a smaller module or centre distance": play.j_bnmin_required / (2 * cos(alpha_n)),
        f"j_n = {play.j_n * 1e3:.5g} µm, of F_beta, f_pt and the axes' parallelism over the bearing span of"
        f" {pair.bearing_span:g} mm; give a shorter span, wider gears or a finer grade": play.j_n / (2 * cos(alpha_n)),
        f"T_sn = {limits.T_sn * 1e3:.5g} µm, from F_r = {own.F_r * 1e3:.5g} and b_r = {own.b_r * 1e3:.5g} µm"
        f" (grade {gear.grade}); give a finer grade, smaller values or a larger module": limits.T_sn,
    }
    return "most of it for " + max(parts, key=lambda text: parts[text])
