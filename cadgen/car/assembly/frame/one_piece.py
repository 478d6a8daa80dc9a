"""Frame in one piece: base with bearing plates and brackets as walls on it, for a printer.

The part's own frame is that of the base, its w = 0 in the base's upper face, so that walls begin at 0 exactly.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from cadgen.car.assembly.car_parts import Joined
from cadgen.car.assembly.panels import LYING, STANDING, Panel, PartPlace


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Bridge:
    """Length of a wall under which the base is open: a printer bridges it.

    Attributes:
        wall: name of the wall.
        length: length along the wall's foot, mm.
        held: whether the wall stands on the base at both ends of it.
    """

    wall: str
    length: float
    held: bool


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class OnePiece:
    """Base, bearing plates and brackets as one part.

    Attributes:
        shape: part in its own frame.
        place: place of the part in the car.
        volume: exact volume, mm³.
        size: length, width and height, mm.
        bridges: bridges of its walls over openings of the base, the longest first.
    """

    shape: Joined
    place: PartPlace
    volume: float
    size: tuple[float, float, float]
    bridges: tuple[Bridge, ...]


def one_piece(base: Panel, walls: Sequence[Panel], top: float) -> OnePiece:
    """Frame in one piece.

    Args:
        base: base plate.
        walls: sheets that stand on it; none may meet another.
        top: height y of the base's upper face, mm.
    """
    place = PartPlace(LYING, np.array([0.0, top, 0.0]))
    below = np.column_stack([np.eye(3), [0.0, 0.0, -base.thickness]])
    blocks = [(base.shape, below)]
    for wall in walls:
        turn, shift = LYING.T @ wall.place.turn, place.within(wall.place.shift[None, :])[0]
        blocks.append((wall.shape, np.column_stack([turn, shift])))
    corners = [base.outline.vertices, *(np.asarray(foot_of(wall).exterior.coords) for wall in walls)]
    span = np.ptp(np.concatenate(corners), axis=0)
    high = max(float(wall.outline.vertices[:, 1].max()) for wall in walls) + top
    return OnePiece(
        shape=Joined(tuple(blocks)),
        place=place,
        volume=base.volume + sum(wall.volume for wall in walls),
        size=(float(span[0]), float(span[1]), high + base.thickness),
        bridges=tuple(sorted(_bridges(base, walls), key=lambda each: -each.length)),
    )


def foot_of(wall: Panel) -> shapely.Polygon:
    """Area of the base under a wall, in the base's own frame.

    Args:
        wall: sheet that stands on the base.
    """
    foot = wall.outline.vertices
    start, end = float(foot[:, 0].min()), float(foot[:, 0].max())
    if wall.place.turn is STANDING:
        low = float(wall.place.shift[2])
        return shapely.box(start, -low - wall.thickness, end, -low)
    ahead = float(wall.place.shift[0])
    return shapely.box(-ahead - wall.thickness, -end, -ahead, -start)


def _bridges(base: Panel, walls: Sequence[Panel]) -> list[Bridge]:
    """Bridges of all walls over openings of the base."""
    face, found = base.face(), []
    for wall in walls:
        area, along = foot_of(wall), 0 if wall.place.turn is STANDING else 1
        for part in shapely.get_parts(area.difference(face)):
            if part.area < _NOTHING:
                continue
            start, end = (part.bounds[side] for side in (along, along + 2))
            held = start > area.bounds[along] + _NOTHING and end < area.bounds[along + 2] - _NOTHING
            found.append(Bridge(wall=wall.name, length=float(end - start), held=held))
    return found


_NOTHING = 1e-6  # mm and mm², of what rounding leaves
