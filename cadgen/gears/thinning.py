"""Teeth as they are cut: thinned within their limits or as told, and what to do about teeth that this destroys."""

from __future__ import annotations

from dataclasses import replace
from math import cos, tan
from typing import Literal

from cadgen.errors import DesignError
from cadgen.gears.backlash import GearPlay, StagePlay, TrainPlay
from cadgen.gears.tooth import GearForm, tooth_of
from cadgen.gears.train import Gear, GearPair, Train

Thinning = Literal["least", "middle", "greatest"]
# Share of the way from E_sns to E_sni.
THINNING_SHARES: dict[Thinning, float] = {"least": 0.0, "middle": 0.5, "greatest": 1.0}


def thinned(play: TrainPlay, thinning: Thinning | float) -> Train:
    """The train with every tooth thinned: within its limits E_sns to E_sni, or by a given E_sn in mm.

    Raises `DesignError`, with the stage and what thins most, for a tooth that cannot be cut so or at its limits.
    """
    stages = []
    for number, (pair, found) in enumerate(zip(play.train.stages, play.stages, strict=True), 1):
        deviations = []
        for gear, limits in ((pair.driver, found.driver), (pair.driven, found.driven)):
            try:
                deviations.append(_deviation(gear, limits, pair, found, thinning))
            except DesignError as error:
                raise DesignError(f"in stage {number}, {error}") from error
        stages.append(with_deviations(pair, *deviations))
    return Train(tuple(stages))


def thickness_zone(form: GearForm, limits: GearPlay[float]) -> tuple[float, float]:
    """Limits of E_sn for the tooth as it is cut, mm: E_sns and E_sni, or a zone as wide about a thinning outside."""
    given = form.tooth_thickness_deviation
    if limits.E_sni <= given <= limits.E_sns:
        return limits.E_sns, limits.E_sni
    return given + limits.T_sn / 2, given - limits.T_sn / 2


def with_deviations(pair: GearPair, driver: float, driven: float) -> GearPair:
    """The pair with teeth cut to E_sn = `driver` and `driven`, in mm."""
    one, two = (
        replace(gear, form=with_deviation(gear.form, deviation))
        for gear, deviation in ((pair.driver, driver), (pair.driven, driven))
    )
    return replace(pair, driver=one, driven=two)


def with_deviation(form: GearForm, deviation: float) -> GearForm:
    """`form` cut with the tooth-thickness deviation E_sn = `deviation` (mm)."""
    return replace(form, tooth_thickness_deviation=deviation)


def _deviation(
    gear: Gear, limits: GearPlay[float], pair: GearPair, found: StagePlay[float], thinning: Thinning | float
) -> float:
    """E_sn of one gear in mm, after its tooth has been tried at full thickness, as cut and at both limits."""
    tooth_of(with_deviation(gear.form, 0.0))
    asked = limits.E_sns - THINNING_SHARES[thinning] * limits.T_sn if isinstance(thinning, str) else thinning
    for deviation, what in (
        (asked, "cut"),
        (limits.E_sns, "at the upper limit of its thickness"),
        (limits.E_sni, "at the lower limit of its thickness"),
    ):
        try:
            tooth_of(with_deviation(gear.form, deviation))
        except DesignError as error:
            fault, _, cure = str(error).partition("; ")
            given = deviation == asked and not isinstance(thinning, str)
            source = "which is given; give one nearer to 0" if given else _source(gear, limits, pair, found)
            shifted = f", or {cure}" if gear.form.profile_shift else ""
            raise DesignError(f"{fault}, {what} with E_sn = {deviation * 1e3:.5g} µm, {source}{shifted}") from error
    return asked


def _source(gear: Gear, limits: GearPlay[float], pair: GearPair, found: StagePlay[float]) -> str:
    """What thins most by eq. 7-9, with its values, and what would lessen it."""
    alpha_n, alpha_w = pair.driver.form.normal_pressure_angle, pair.working_pressure_angle
    own = limits.tolerances
    parts = {
        f"f_a = {found.f_a * 1e3:.5g} µm of the centre distance; give a smaller f_a": found.f_a * tan(alpha_w),
        "j_bnmin of eq. 6; give a smaller module or centre distance": found.j_bnmin_required / (2 * cos(alpha_n)),
        f"j_n = {found.j_n * 1e3:.5g} µm, of F_beta, f_pt and the axes' parallelism over the bearing span of"
        f" {pair.bearing_span:g} mm; give a shorter span, wider gears or a finer grade": found.j_n / (2 * cos(alpha_n)),
        f"T_sn = {limits.T_sn * 1e3:.5g} µm, from F_r = {own.F_r * 1e3:.5g} and b_r = {own.b_r * 1e3:.5g} µm"
        f" (grade {gear.grade}); give a finer grade, smaller values or a larger module": limits.T_sn,
    }
    return "most of it for " + max(parts, key=lambda text: parts[text])
