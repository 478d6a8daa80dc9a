"""Points of the path and items on the course: what of them can be moved, added and removed."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, floor

from cadgen.design.parse import parse
from cadgen.design.schema import Design, MotionDesign
from cadgen.messages import Message
from cadgen.viewer.editor.text_changes import NewItem, read_point

NAMED_KEYS = {
    "waypoints_mm": Message("waypoint"),
    "control_points_mm": Message("control point"),
    "gates": Message("gate"),
    "posts": Message("post"),
    "walls": Message("wall"),
    "zones": Message("zone"),
    "start": Message("start"),
    "finish": Message("finish"),
    "field": Message("field"),
}
_PLACES = ("at_mm", "from_mm", "to_mm", "corner_mm")
_LISTS = {"line_mm": 2, "outline_mm": 3}  # and how many points each needs
# Lists and sections of [course] by the group that is moved together.
ON_COURSE = {
    "gates": ("gates", "start", "finish"),
    "posts": ("posts", "walls", "zones", "field"),
}
_ALONE = ("start", "finish", "field")
# Sizes that a new item takes from that before it, and what it has without one.
_SIZES: dict[str, NewItem] = {
    "posts": {"radius_mm": 10.0, "height_mm": None},
    "walls": {"thickness_mm": 10.0, "height_mm": None},
    "zones": {"size_mm": [200.0, 200.0], "height_mm": None},
    "gates": {"radius_mm": 50.0, "point": None},
    "start": {"radius_mm": 50.0},
    "finish": {"radius_mm": 50.0},
}
_HALF_WALL_MM = 150.0
_ROOM_MM, _ROUND_MM = 300.0, 100.0  # of a new field about all points, and what its sides are rounded to


def point_name(kind: str, number: int, part: str = "") -> Message:
    """Name of a point or an item.

    Args:
        kind: key or section that it stands in.
        number: number of the item, from 1; 0 for one that is alone.
        part: key of its place in the item, or the number of the point in it.
    """
    name = Message("{name} {number}", name=NAMED_KEYS[kind], number=number) if number else NAMED_KEYS[kind]
    if part == "from_mm":
        return Message("{name}, begin", name=name)
    if part == "to_mm":
        return Message("{name}, end", name=name)
    if part == "corner_mm":
        return Message("{name}, corner", name=name)
    return Message("{name}, point {number}", name=name, number=part) if part.isdecimal() else name


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
    label: str
    x: float
    y: float
    listed: str = ""
    closed: bool = False
    spare: bool = False
    item: str = ""


def points_of(design: Design | MotionDesign) -> tuple[MovablePoint, ...]:
    """All points of a design that can be moved."""
    return tuple(_points(design))


def _points(design: Design | MotionDesign) -> Iterator[MovablePoint]:
    if isinstance(design, MotionDesign):
        return
    closed = bool(getattr(design.path, "closed", False))
    for name in ("waypoints_mm", "control_points_mm"):
        for number, (x, y) in enumerate(getattr(design.path, name, None) or (), 1):
            label = point_name(name, number, "")
            yield MovablePoint(f"path.{name}.{number}", "path", label, x, y, f"path.{name}", closed, spare=True)
    for layer, names in ON_COURSE.items():
        for name in names:
            several = getattr(design.course, name, None)
            if name in _ALONE:
                if several is not None:
                    yield from _of_item(several, f"course.{name}", layer, name, 0)
            else:
                for number, item in enumerate(several or (), 1):
                    yield from _of_item(item, f"course.{name}.{number}", layer, name, number)


def _of_item(item: object, key: str, layer: str, kind: str, number: int) -> Iterator[MovablePoint]:
    for name in _PLACES:
        if (place := getattr(item, name, None)) is not None:
            x, y = place
            yield MovablePoint(f"{key}.{name}", layer, point_name(kind, number, name), float(x), float(y), item=key)
    for name, least in _LISTS.items():
        points, closed = getattr(item, name, None) or (), name == "outline_mm"
        for place, (x, y) in enumerate(points, 1):
            label, listed, spare = point_name(kind, number, str(place)), f"{key}.{name}", len(points) > least
            yield MovablePoint(f"{listed}.{place}", layer, label, float(x), float(y), listed, closed, spare, key)


@dataclass(frozen=True)
class ItemKind:
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
    label: str
    count: int
    alone: bool


def kinds_of(design: Design | MotionDesign) -> tuple[ItemKind, ...]:
    """All kinds of items, those among them of which there is none; a cam by its motion has no course."""
    if isinstance(design, MotionDesign):
        return ()

    def count(name: str) -> int:
        several = getattr(design.course, name, None)
        return int(several is not None) if name in _ALONE else len(several or ())

    return tuple(
        ItemKind(f"course.{name}", layer, NAMED_KEYS[name], count(name), name in _ALONE)
        for layer, names in ON_COURSE.items()
        for name in names
    )


def places_of(design: Design | MotionDesign) -> frozenset[str]:
    """Keys that a new item can get."""
    return _keys_of(design, 1)


def items_of(design: Design | MotionDesign) -> frozenset[str]:
    """Keys of all items on the course."""
    return _keys_of(design, 0)


def _keys_of(design: Design | MotionDesign, more: int) -> frozenset[str]:
    """Keys of all items on the course and of so many `more` in each list; of what is alone, either it or its place."""
    keys: set[str] = set()
    for kind in kinds_of(design):
        if not kind.alone:
            keys.update(f"{kind.key}.{number}" for number in range(1, kind.count + more + 1))
        elif kind.count + more == 1:
            keys.add(kind.key)
    return frozenset(keys)


def new_item(design: Design | MotionDesign, text: str, key: str, at: tuple[float, float]) -> NewItem:
    """Values of a new item.

    Args:
        design: design that gets it.
        text: text of the design, TOML.
        key: key that the item gets.
        at: place of its middle, mm; a field goes about all points of the design.
    """
    _, name, *number = key.split(".")
    if name == "field":
        axes = list(zip(*((point.x, point.y) for point in points_of(design)), strict=True))
        low = [_ROUND_MM * floor((min(axis) - _ROOM_MM) / _ROUND_MM) for axis in axes]
        high = [_ROUND_MM * ceil((max(axis) + _ROOM_MM) / _ROUND_MM) for axis in axes]
        return {"corner_mm": low, "size_mm": [top - bottom for bottom, top in zip(low, high, strict=True)]}
    sizes, items = _SIZES[name], parse(text).get("course", {}).get(name)
    if isinstance(items, list) and items and number:  # those of the item before the new one, or of that after it
        neighbour = items[max(int(number[0]) - 2, 0)]
        sizes = {size: neighbour.get(size, value) for size, value in sizes.items()}
    sizes = {size: value for size, value in sizes.items() if value is not None}
    x, y = at
    if name == "walls":
        return {"line_mm": [[x - _HALF_WALL_MM, y], [x + _HALF_WALL_MM, y]], **sizes}
    if name == "zones":
        width, height = read_point(sizes["size_mm"])
        return {"corner_mm": [x - width / 2, y - height / 2], **sizes}
    return {"at_mm": [x, y], **sizes}
