"""Table of a gear's data on its sheet."""

from collections.abc import Mapping
from typing import Any

from cadgen.gears.stage import Stage
from cadgen.output.drawing.sheet import rows_of, shown


def gear_rows(gear: Mapping[str, Any], mate: str, stage: Stage, *, drives: bool) -> tuple[tuple[str, str], ...]:
    """Rows of a gear's data table: names and values of the field, those that a kind of wheel has not left out."""
    side = stage.facts().get("driver" if drives else "driven", {})
    grade = side.get("grade") if isinstance(side, Mapping) else None

    def mm(key: str, digits: int = 3) -> str:
        return f"{shown(gear[key], digits)} mm" if gear.get(key) is not None else ""

    def limits(name: str) -> str:
        most, least = gear.get(f"{name}_max_mm"), gear.get(f"{name}_min_mm")
        return "" if most is None or least is None else f"{least:.3f} to {most:.3f} mm"

    thinned = [gear.get(key) for key in ("E_sns_um", "E_sni_um")]
    module = gear.get("module_mm")
    return rows_of(
        [
            ("teeth z", str(gear.get("teeth", ""))),
            ("module m_n", mm("module_mm", 4)),
            ("pressure angle", f"{gear['pressure_angle_deg']:g}°" if "pressure_angle_deg" in gear else ""),
            ("profile shift x", f"{gear['profile_shift']:g}" if "profile_shift" in gear else ""),
            ("pitch diameter d", f"{module * gear['teeth']:g} mm" if module else ""),
            ("tip diameter", mm("tip_diameter_mm")),
            ("root diameter, as cut", mm("root_diameter_mm")),
            ("face width", mm("width_mm")),
            ("grade, ISO 1328-1", "" if grade is None else str(grade)),
            (
                "thickness E_sns / E_sni",
                "" if None in thinned else f"{thinned[0]:.1f} / {thinned[1]:.1f} µm",
            ),
            (f"span over {gear.get('teeth_spanned')} teeth", limits("span")),
            (f"over pins of {gear.get('pin_diameter_mm') or 0:g} mm", limits("over_pins")),
            ("meshes with", mate),
            ("centre distance", f"{stage.centre_distance:g} mm"),
        ]
    )
