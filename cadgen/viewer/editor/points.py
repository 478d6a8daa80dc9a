"""Points on the floor that can be moved on the page: of path, gates, start, finish, posts, walls, zones and field."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from cadgen.design.schema import Design
from cadgen.viewer.editor.words import point_words
from cadgen.viewer.page.document import Words

_PLACES = ("at_mm", "from_mm", "to_mm", "corner_mm")
_LISTS = {"line_mm": 2, "outline_mm": 3}  # and how many points each needs
# Lists and sections of [course] by the group that is moved together.
ON_COURSE = {
    "gates": ("gates", "start", "finish"),
    "posts": ("posts", "walls", "zones", "field"),
}


@dataclass(frozen=True)
class MovablePoint:
    """A point that can be moved.

    Attributes:
        key: dotted key of its pair, items of lists counted from 1.
        layer: group that is moved together: `path`, `gates` or `posts`.
        label: name.
        x: place, mm.
        y: place, mm.
        listed: dotted key of the list of points that it stands in, which others can be put into; else empty.
        closed: whether the last point of that list is followed by its first.
        spare: whether that list can do without a point.
        item: dotted key of the post, gate, wall or the like that it is of; empty for the path.
    """

    key: str
    layer: str
    label: Words
    x: float
    y: float
    listed: str = ""
    closed: bool = False
    spare: bool = False
    item: str = ""


def points_of(design: Design) -> tuple[MovablePoint, ...]:
    """All points of a design that can be moved."""
    return tuple(_points(design.values()))


def _points(values: dict[str, Any]) -> Iterator[MovablePoint]:
    path = values["path"]
    for name in ("waypoints_mm", "control_points_mm"):
        for number, (x, y) in enumerate(path.get(name, ()), 1):
            closed = bool(path.get("closed", False))
            label = point_words(name, number, "")
            yield MovablePoint(f"path.{name}.{number}", "path", label, x, y, f"path.{name}", closed, spare=True)
    course = values.get("course", {})
    for layer, names in ON_COURSE.items():
        for name in names:
            several = course.get(name)
            if isinstance(several, dict):
                yield from _of_item(several, f"course.{name}", layer, name, 0)
            else:
                for number, item in enumerate(several or (), 1):
                    yield from _of_item(item, f"course.{name}.{number}", layer, name, number)


def _of_item(item: dict[str, Any], key: str, layer: str, kind: str, number: int) -> Iterator[MovablePoint]:
    for name in _PLACES:
        if name in item:
            x, y = item[name]
            yield MovablePoint(f"{key}.{name}", layer, point_words(kind, number, name), float(x), float(y), item=key)
    for name, least in _LISTS.items():
        points, closed = item.get(name, ()), name == "outline_mm"
        for place, (x, y) in enumerate(points, 1):
            label, listed, spare = point_words(kind, number, str(place)), f"{key}.{name}", len(points) > least
            yield MovablePoint(f"{listed}.{place}", layer, label, float(x), float(y), listed, closed, spare, key)
