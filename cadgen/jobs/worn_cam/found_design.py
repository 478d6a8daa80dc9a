"""The design file with the motion that was found: comments kept, overrides applied, [motion] stated."""

from collections.abc import Sequence
from typing import Any

from cadgen.design.override import override
from cadgen.inference.motions.stated_motion import StatedMotion, StatedSegment


def found_text(
    text: str, overrides: Sequence[str], name: str, stated: StatedMotion, unit: str, base: float | None
) -> str:
    """Text of a design with the motion that was found in the place of `measured`.

    Args:
        text: text of the design that the cam was measured against.
        overrides: its overrides.
        name: name of the new design.
        stated: motion.
        unit: unit of its heights, `mm` or `deg`.
        base: radius of the base circle that was found, mm; None to leave the design's.
    """
    import tomlkit

    values: Any = tomlkit.parse(text)
    for change in overrides:
        override(values, change)
    if "name" in values:
        values["name"] = name
    motion = values["motion"]
    motion.pop("measured", None)
    if stated.segments:
        made = tomlkit.array()
        for segment in stated.segments:
            made.append(_segment(segment, unit))
        motion["segments"] = made.multiline(multiline=True)
    else:
        points = tomlkit.array()
        for angle, height in stated.points:
            points.append([angle, height])
        motion["points"] = points.multiline(multiline=True)
    if base is not None:
        values["cam"]["base_circle_radius_mm"] = base
    made_text = values.as_string()
    if "name" not in values:
        named = tomlkit.document()
        named.add("name", name)
        made_text = f"{named.as_string()}{made_text}"
    return f"# Written by cadgen calibrate: the motion was found from the measured cam.\n{made_text}"


def _segment(segment: StatedSegment, unit: str) -> Any:
    import tomlkit

    table = tomlkit.inline_table()
    if not segment.law:
        table["dwell_deg"] = segment.width
        return table
    table[f"to_{unit}"] = segment.after
    table["in_deg"] = segment.width
    table["law"] = segment.law
    if segment.ratio is not None:
        table["acceleration_ratio"] = segment.ratio
    return table
