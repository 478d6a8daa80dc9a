"""The design file with the planned path: comments kept, overrides applied."""

from collections.abc import Sequence
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

    values = _overridden(text, design.overrides)
    if "path" not in values:
        values.add("path", tomlkit.table())
    path = values["path"]
    for key in [key for key in path if key not in OF_ANY_PATH]:
        path.remove(key)
    path["spline"] = "b_spline"
    path["spline"].comment("by cadgen plan: a curve of degree 5 by its control points")
    path["offset_mm"] = design.path.offset_mm
    pairs = [f"[{x!r}, {y!r}]" for x, y in rounded(points).tolist()]
    lines = [", ".join(pairs[at : at + _A_ROW]) for at in range(0, len(pairs), _A_ROW)]
    path["control_points_mm"] = tomlkit.value("[\n    " + ",\n    ".join(lines) + ",\n]")
    if radius_mm is not None:
        values["car"]["drive_wheel_radius_mm"] = radius_mm
        values["car"]["drive_wheel_radius_mm"].comment("by cadgen plan: the whole path before the closing blend")
    return _written(values, design.name)


def overridden_text(text: str, overrides: Sequence[str], name: str) -> str:
    """A design's own text with overrides, and a name; comments stay.

    Args:
        text: text of its file.
        overrides: as of `--set`.
        name: name of the changed design.
    """
    values = _overridden(text, overrides)
    if "name" in values:
        values["name"] = name
    return _written(values, name)


def _overridden(text: str, overrides: Sequence[str]) -> Any:
    import tomlkit

    values = tomlkit.parse(text)
    for change in overrides:
        override(values, change)
    return values


def _written(values: Any, name: str) -> str:
    """Text of a document, which begins with the name if it has none."""
    if "name" in values:
        return str(values.as_string()).rstrip() + "\n"
    import tomlkit

    named = tomlkit.document()
    named.add("name", name)
    return f"{named.as_string()}{values.as_string()}".rstrip() + "\n"


def rounded(points: Array) -> Array:
    """Control points as the file has them, mm.

    Args:
        points: control points, shape (n, 2), mm.
    """
    return points.round(DIGITS)
