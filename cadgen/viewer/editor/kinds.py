"""Kinds of items on the course that can be added and removed: posts, walls, zones, gates, start, finish, field."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor
from typing import Any

from cadgen.design.schema import Design
from cadgen.viewer.editor.points import ON_COURSE, points_of
from cadgen.viewer.editor.words import kind_words
from cadgen.viewer.page.document import Words

_ALONE = ("start", "finish", "field")
# Sizes that a new item takes from that before it, and what it has without one.
_SIZES: dict[str, dict[str, Any]] = {
    "posts": {"radius_mm": 10.0, "height_mm": None},
    "walls": {"thickness_mm": 10.0, "height_mm": None},
    "zones": {"size_mm": [200.0, 200.0], "height_mm": None},
    "gates": {"radius_mm": 50.0, "point": None},
    "start": {"radius_mm": 50.0},
    "finish": {"radius_mm": 50.0},
}
_HALF_WALL_MM = 150.0
_ROOM_MM, _ROUND_MM = 300.0, 100.0  # of a new field about all points, and what its sides are rounded to


@dataclass(frozen=True)
class Kind:
    """A kind of item on the course.

    Attributes:
        key: dotted key of the list or section.
        layer: group of points that it is moved with.
        label: name.
        count: how many there are.
        alone: whether there is one at most, in a section without a number.
    """

    key: str
    layer: str
    label: Words
    count: int
    alone: bool


def kinds_of(design: Design) -> tuple[Kind, ...]:
    """All kinds of items, those among them of which there is none."""
    course = design.values().get("course", {})
    assert isinstance(course, dict)
    return tuple(
        Kind(
            f"course.{name}",
            layer,
            kind_words(name),
            int(name in course) if name in _ALONE else len(course.get(name, ())),
            name in _ALONE,
        )
        for layer, names in ON_COURSE.items()
        for name in names
    )


def places_of(design: Design) -> frozenset[str]:
    """Keys that a new item can get."""
    return frozenset(
        key
        for kind in kinds_of(design)
        for key in ([kind.key] * (1 - kind.count) if kind.alone else _numbered(kind, kind.count + 1))
    )


def items_of(design: Design) -> frozenset[str]:
    """Keys of all items on the course."""
    return frozenset(
        key
        for kind in kinds_of(design)
        for key in ([kind.key] * kind.count if kind.alone else _numbered(kind, kind.count))
    )


def _numbered(kind: Kind, count: int) -> list[str]:
    return [f"{kind.key}.{number}" for number in range(1, count + 1)]


def new_item(design: Design, raw: dict[str, Any], key: str, at: tuple[float, float]) -> dict[str, Any]:
    """Values of a new item.

    Args:
        design: design that gets it.
        raw: values as the design's text has them.
        key: key that the item gets.
        at: place of its middle, mm; a field goes about all points of the design.
    """
    _, name, *number = key.split(".")
    if name == "field":
        return _field_about([(point.x, point.y) for point in points_of(design)])
    sizes = {**_SIZES[name], **_sizes_beside(raw.get("course", {}).get(name), number, _SIZES[name])}
    sizes = {size: value for size, value in sizes.items() if value is not None}
    x, y = at
    if name == "walls":
        return {"line_mm": [[x - _HALF_WALL_MM, y], [x + _HALF_WALL_MM, y]], **sizes}
    if name == "zones":
        width, height = sizes["size_mm"]
        return {"corner_mm": [x - width / 2, y - height / 2], **sizes}
    return {"at_mm": [x, y], **sizes}


def _sizes_beside(items: object, number: Sequence[str], names: dict[str, Any]) -> dict[str, Any]:
    """Sizes of the item before a new one, or of that after it."""
    if not isinstance(items, list) or not items or not number:
        return {}
    beside = items[max(int(number[0]) - 2, 0)]
    return {name: beside[name] for name in names if name in beside}


def _field_about(points: list[tuple[float, float]]) -> dict[str, Any]:
    low = [_ROUND_MM * floor((min(axis) - _ROOM_MM) / _ROUND_MM) for axis in zip(*points, strict=True)]
    high = [_ROUND_MM * ceil((max(axis) + _ROOM_MM) / _ROUND_MM) for axis in zip(*points, strict=True)]
    return {"corner_mm": low, "size_mm": [top - bottom for bottom, top in zip(low, high, strict=True)]}
