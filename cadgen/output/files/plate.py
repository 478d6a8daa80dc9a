"""The plate that holds the axes of a train: its outline and holes as DXF, and with a thickness as a solid in STEP.

The frame is that of the train: the axis of the drive is z at x = y = 0, and the lower face lies at z = 0.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import ceil, floor, hypot, pi
from pathlib import Path

import numpy as np

from cadgen.curves.contour import Contour, circle
from cadgen.errors import DesignError
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.dxf import alike, read_dxf, write_dxf
from cadgen.output.files.publisher import Artifact, require
from cadgen.output.files.step import one_solid

MARGIN = 10.0  # mm of plate beyond the gears
ROUND = 5.0  # mm, to which its sides are rounded up
LEAST_WALL = 0.2  # mm of plate between two holes
GREY = (0.62, 0.62, 0.6)
# A cylinder in the text of a STEP file: the number of its placement, and its radius; then that placement's point.
_CYLINDER = re.compile(r"CYLINDRICAL_SURFACE\('[^']*',#(\d+),([-+.E\d]+)\)")
_PLACEMENT = r"#{number} = AXIS2_PLACEMENT_3D\('[^']*',#(\d+),"
_POINT = r"#{number} = CARTESIAN_POINT\('[^']*',\(([-+.E\d]+),([-+.E\d]+),"
_PLACE_MM = 1e-6  # of holes that are read back


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """A shaft of the train where it passes the plate.

    Attributes:
        shaft: its number, from the drive.
        x: place of its axis, mm.
        y: likewise.
        bore: diameter of its hole in the plate, mm; 0 for none.
        reach: radius of the largest gear on it, mm.
        hole: class of its hole in the plate, such as `H7`; empty where none is given.
    """

    shaft: int
    x: float
    y: float
    bore: float
    reach: float
    hole: str = ""


@dataclass(frozen=True, slots=True)
class Plate:
    """A rectangular plate with a hole for each axis of a train.

    Attributes:
        axes: axes of the train.
        thickness: thickness, mm; None where the design does not say.

    Raises:
        DesignError: two holes meet.
    """

    axes: tuple[Axis, ...]
    thickness: float | None = None

    def __post_init__(self) -> None:
        for one, other in combinations(self.holed, 2):
            apart = hypot(one.x - other.x, one.y - other.y)
            if apart - (one.bore + other.bore) / 2 < LEAST_WALL - _PLACE_MM:
                raise DesignError(
                    "train.plate.bearing_bores_mm has {first:g} and {second:g} for shafts {one} and {other}, whose "
                    "holes meet at {apart:.4g} mm between the axes; give both at most {most:g}",
                    first=one.bore,
                    second=other.bore,
                    one=one.shaft,
                    other=other.shaft,
                    apart=apart,
                    most=floor((apart - LEAST_WALL) * 100) / 100,
                )

    @property
    def holed(self) -> tuple[Axis, ...]:
        """Axes with a hole; of several at one place that with the largest."""
        found: dict[tuple[float, float], Axis] = {}
        for axis in sorted(self.axes, key=lambda axis: axis.bore):
            if axis.bore:
                found[round(axis.x, 6), round(axis.y, 6)] = axis
        return tuple(sorted(found.values(), key=lambda axis: axis.shaft))

    @property
    def sides(self) -> tuple[float, float, float, float]:
        """Left, lower, right and upper side, mm."""
        places = np.array([[axis.x, axis.y] for axis in self.axes])
        reach = np.array([[axis.reach] for axis in self.axes])
        left, low = (ROUND * floor(value / ROUND) for value in ((places - reach).min(axis=0) - MARGIN).tolist())
        right, high = (ROUND * ceil(value / ROUND) for value in ((places + reach).max(axis=0) + MARGIN).tolist())
        return left, low, right, high

    @property
    def outline(self) -> Contour:
        """Four sides of the plate, counterclockwise, mm."""
        left, low, right, high = self.sides
        corners = np.array([[left, low], [right, low], [right, high], [left, high]])
        return Contour(corners, np.zeros(4))

    @property
    def holes(self) -> tuple[Contour, ...]:
        """Holes of the plate, mm."""
        return tuple(circle((axis.x, axis.y), axis.bore / 2) for axis in self.holed)


def bearing_bores(given: Sequence[float] | None, shafts: Sequence[float]) -> tuple[float, ...]:
    """Diameter of the hole of each shaft, mm.

    Args:
        given: one for all shafts, one for each, or None for holes as large as the shafts.
        shafts: diameters of the shafts, mm; 0 for none.

    Raises:
        DesignError: there are neither one nor as many as shafts.
    """
    if given is None:
        return tuple(shafts)
    if len(given) not in (1, len(shafts)):
        raise DesignError(
            "train.plate.bearing_bores_mm has {found} values and the train {shafts} shafts; give one for all, or "
            "{example}",
            found=len(given),
            shafts=len(shafts),
            example=str([given[0] if given else 8.0] * len(shafts)),
        )
    return tuple(given) if len(given) > 1 else (given[0],) * len(shafts)


def plate_files(plate: Plate, folder: Path, stem: str) -> Iterator[Artifact]:
    """Write the plate as DXF, with a thickness as STEP, too, and measure its holes as read back.

    Args:
        plate: plate that is to be written.
        folder: folder for the files.
        stem: start of the files' names.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    name = f"{stem}_outline.dxf"
    write_dxf(folder / name, plate.outline, None, plate.holes)
    drawing = read_dxf(folder / name)
    same = len(drawing.holes) == len(plate.holes) and all(map(alike, drawing.holes, plate.holes))
    corners = drawing.profile.points
    reach = (*corners.min(axis=0).tolist(), *corners.max(axis=0).tolist())
    require(same and np.allclose(reach, plate.sides, atol=_PLACE_MM), name, Message("has other holes or sides"))
    holes = [(axis.shaft, axis.x, axis.y, axis.bore) for axis in plate.holed]
    facts = Facts(
        sides_mm=plate.sides, holes_mm=[dict(zip(("shaft", "x", "y", "bore"), row, strict=True)) for row in holes]
    )
    yield Artifact(name, facts)
    if plate.thickness is None:
        return
    from cadgen.geometry.solids.kernel import SolidPart, contour_edges, prism, solids

    outer, inner = contour_edges(plate.outline, 0.0), [contour_edges(hole, 0.0) for hole in plate.holes]
    (solid,) = solids(prism(outer, inner, plate.thickness))
    file = folder / f"{stem}.step"
    area = plate.outline.area() - sum(pi * axis.bore**2 / 4 for axis in plate.holed)
    part = SolidPart(solid=solid, name=stem, description=f"plate {plate.thickness:g} mm for the axes", colour=GREY)
    whole = one_solid(file, part, area * plate.thickness)
    found = _cylinders(file.read_text(encoding="ascii"))
    wanted = sorted((x, y, bore / 2) for _, x, y, bore in holes)
    same = len(found) == len(wanted) and np.allclose(found, wanted, rtol=0, atol=_PLACE_MM)
    require(same, file.name, Message("has other holes or sides"))
    yield Artifact(file.name, whole)


def _cylinders(text: str) -> list[tuple[float, float, float]]:
    """Place and radius of every cylinder in the text of a STEP file, mm, in order."""
    joined = re.sub(r"\s*\n\s*", "", text)
    found = []
    for placement, radius in _CYLINDER.findall(joined):
        at = re.search(_PLACEMENT.format(number=placement), joined)
        point = at and re.search(_POINT.format(number=at[1]), joined)
        if point:
            found.append((float(point[1]), float(point[2]), float(radius)))
    return sorted(found)
