"""From points of a path and changes of keys to a commented design file."""

from collections.abc import Sequence
from os import PathLike
from pathlib import Path

import tomlkit

from cadgen.design.course import MOST_OF_A_KIND
from cadgen.design.load import design_of
from cadgen.design.names import name_fault
from cadgen.design.override import override
from cadgen.design.template import EXAMPLE, GATE_RADIUS, LAP, text_of
from cadgen.errors import DesignError, FileError, brief
from cadgen.inference.records.points import Points, read_points

_CAR = ("car.drive_wheel_offset_mm=", "car.idle_wheel_offset_mm=")
_EXAMPLE_FIELD = (7000.0, 3000.0)


def begin(
    name: str,
    points: Points | None = None,
    changes: Sequence[str] = (),
    gate_radius: float = GATE_RADIUS,
    field: tuple[float, float] | None = None,
    closed: bool = False,
) -> str:
    """Text of a new design, which loads.

    Args:
        name: name of the design and of its file.
        points: points of its path, mm; an example if left out.
        changes: `key=value` each, as with `--set`.
        gate_radius: radius of the gates at the points, mm.
        field: width and height of the field, mm.
        closed: whether the path is a lap that ends as it starts.

    Raises:
        DesignError: a name that files cannot have, or values that cannot be.
    """
    if fault := name_fault(name):
        raise DesignError(f'the name is "{brief(name[:80])}"; it must {fault}')
    if points is None:
        example = LAP if closed else EXAMPLE
        points, field = Points(example, (1.0,) * len(example)), field or _EXAMPLE_FIELD
    elif closed and points.places[0] == points.places[-1]:  # once is enough, and one gate
        points = Points(points.places[:-1], points.weights[:-1])
    count = sum(weight > 0 for weight in points.weights)
    if count > MOST_OF_A_KIND:
        raise DesignError(
            f"{count} points would each be a gate, and a course has at most {MOST_OF_A_KIND}: give fewer points, or a "
            "weight of 0 to those that only lead the path"
        )
    # The middle of the car is to drive the path, unless the changes say where it runs.
    document = tomlkit.parse(text_of(name, points.places, points.weights, 0.0, gate_radius, field, closed=closed))
    for change in changes:
        override(document, change)
    car = document["car"]
    if not any(change.replace(" ", "").startswith("path.offset_mm=") for change in changes):
        offsets = [car.get(key) for key in ("drive_wheel_offset_mm", "idle_wheel_offset_mm")]
        if all(isinstance(offset, int | float) for offset in offsets):
            document["path"]["offset_mm"] = round(sum(map(float, offsets)) / 2, 4)
    text = tomlkit.dumps(document)
    design_of(text, Path(f"{name}.toml"))
    return text


def points_of(file: str | PathLike[str] | None, layer: str | None, *, closed: bool) -> Points | None:
    """Points of a path from a file; None without one.

    Args:
        file: CSV, TXT or DXF.
        layer: layer of the polyline in a DXF with several.
        closed: whether the path is a lap.

    Raises:
        DesignError: a layer of no file.
        FileError: points that cannot be read.
    """
    if file is not None:
        return read_points(Path(file), layer, closed=closed)
    if layer is not None:
        raise DesignError("a layer is named, but no DXF with points: give the DXF too, or leave the layer out")
    return None


def write_new(text: str, file: Path) -> None:
    """Write a new design's file, and nothing over one that is there.

    Raises:
        FileError: the file is there already, or cannot be written.
    """
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with open(file, "x", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
    except FileExistsError:
        raise FileError(f"{brief(str(file))} is there already: choose another name, or remove it") from None
    except OSError as error:
        raise FileError(f"{brief(str(file))} cannot be written ({error.strerror}): choose another place") from None
