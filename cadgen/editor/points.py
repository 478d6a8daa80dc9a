"""Points on the floor that can be moved on the page: of path, gates, start, finish, posts, walls, zones and field."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from cadgen.design.schema import Design
from cadgen.editor.words import point_words
from cadgen.page.document import Words

_PLACES = ("at_mm", "from_mm", "to_mm", "corner_mm")
_LISTS = ("line_mm", "outline_mm")
# Lists and sections of [course] by the group that is moved together.
_ON_COURSE = {
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
    """

    key: str
    layer: str
    label: Words
    x: float
    y: float
    listed: str = ""
    closed: bool = False


def points_of(design: Design) -> tuple[MovablePoint, ...]:
    """All points of a design that can be moved."""
    return tuple(_points(design.values()))


def _points(values: dict[str, Any]) -> Iterator[MovablePoint]:
    path = values["path"]
    for name in ("waypoints_mm", "control_points_mm"):
        for number, (x, y) in enumerate(path.get(name, ()), 1):
            closed = bool(path.get("closed", False))
            yield _point(f"path.{name}", number, "path", point_words(name, number, ""), (x, y), closed)
    course = values.get("course", {})
    for layer, names in _ON_COURSE.items():
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
            yield MovablePoint(f"{key}.{name}", layer, point_words(kind, number, name), float(x), float(y))
    for name in _LISTS:
        for place, at in enumerate(item.get(name, ()), 1):
            label = point_words(kind, number, str(place))
            yield _point(f"{key}.{name}", place, layer, label, at, name == "outline_mm")


def _point(listed: str, number: int, layer: str, label: Words, at: Sequence[float], closed: bool) -> MovablePoint:
    """A point of a list of points, by its number in it from 1."""
    return MovablePoint(f"{listed}.{number}", layer, label, float(at[0]), float(at[1]), listed, closed)
