"""The design file with the planned path: comments kept, overrides applied."""

from typing import Any

from cadgen.arrays import Array
from cadgen.design.override import override
from cadgen.design.path import OF_ANY_PATH
from cadgen.design.schema import Design

DIGITS = 4  # of a control point, in mm: a tenth of a micrometre
_A_ROW = 6  # points in a line of the file


def planned_text(design: Design, text: str, points: Array, radius_mm: float | None) -> str:
    """The design's own text with the overrides, the planned path, and the wheel that it is for.

    Args:
        design: the design that was planned.
        text: text of its file.
        points: control points, shape (n, 2), mm.
        radius_mm: radius of the drive wheel, mm, if the plan chose it.
    """
    import tomlkit  # only here: most commands write no design

    values: Any = tomlkit.parse(text)
    for change in design.overrides:
        override(values, change)
    if "path" not in values:
        values.add("path", tomlkit.table())
    path = values["path"]
    for key in [key for key in path if key not in OF_ANY_PATH]:
        path.remove(key)
    path["spline"] = "b_spline"
    path["spline"].comment("by cadgen plan: a curve of degree 5 by its control points")
    path["offset_mm"] = design.path.offset_mm
    path["control_points_mm"] = _points(points)
    if radius_mm is not None:
        values["car"]["drive_wheel_radius_mm"] = radius_mm
        values["car"]["drive_wheel_radius_mm"].comment("by cadgen plan: the whole path before the closing blend")
    if "name" not in values:
        named = tomlkit.document()
        named.add("name", design.name)
        return f"{named.as_string()}{values.as_string()}".rstrip() + "\n"
    return str(values.as_string()).rstrip() + "\n"


def rounded(points: Array) -> Array:
    """Control points as the file has them, mm."""
    return points.round(DIGITS)


def _points(points: Array) -> Any:
    import tomlkit

    rows = rounded(points).tolist()
    lines = [", ".join(f"[{x!r}, {y!r}]" for x, y in rows[at : at + _A_ROW]) for at in range(0, len(rows), _A_ROW)]
    return tomlkit.value("[\n    " + ",\n    ".join(lines) + ",\n]")
