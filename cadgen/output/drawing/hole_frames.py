"""Frames of the seats in a plate: the first hole square to its face, the others in their places to it (ISO 1101, 5459).

Holes in zones of t and u, mm, leave their distance by (t + u) / 2 at most, one of them and the datum by t / 2.
"""

from collections.abc import Collection, Iterator, Sequence
from math import floor, inf

import numpy as np

from cadgen.arrays import Array
from cadgen.curves.contour import Contour
from cadgen.gears.train import Train
from cadgen.output.drawing.placement import Room
from cadgen.output.drawing.sheet import (
    TAIL,
    TEXT,
    WIDEST,
    Characteristic,
    Closed,
    DatumFeature,
    LinearDimension,
    LineKind,
    Stroke,
    Symbol,
    ToleranceFrame,
    View,
    rounded,
)

_AROUND = range(0, 360, 15)  # degrees
_DIAGONALS = sorted(range(5, 360, 10), key=lambda angle: (abs(angle % 90 - 45), angle))  # degrees
_CHORD = 0.01  # mm, of an outline to which a leader leads
_CLEAR = 0.6  # of the cosine of the angle between such a leader and a keyway
_LETTERS = "BC"  # of the first two holes; A is the face
_STEPS = 1000  # in a mm, to which a zone is rounded down
_OVER = 8.0  # mm on paper, from the plate to its dimension


def seat_zones(shafts: Collection[int], train: Train) -> dict[int, float]:
    """Width of the zone of each seat by its shaft, mm, so that the distances of the axes keep their deviations.

    A hole has the least deviation of the distances of its axis, and twice that of one to the first hole, the datum.
    The first hole itself, which stands square, has the least deviation of its own distances. Nothing where none of
    these is tolerated.

    Args:
        shafts: numbers of the shafts that have a hole each, the datum first.
        train: train with its distances.
    """
    zones: dict[int, float] = {}
    first = next(iter(shafts), 0)
    for number, stage in enumerate(train.stages, 1):
        ends, deviation = (number, number + 1), stage.distance_deviation
        if not deviation or not all(end in shafts for end in ends):
            continue
        for one, other in (ends, ends[::-1]):
            widest = 2 * deviation if other == first else deviation
            zones[one] = min(zones.get(one, inf), floor(widest * _STEPS + 1e-9) / _STEPS)
    return zones if first in zones else {}


def rim(centre: tuple[float, float], radius: float) -> Iterator[tuple[Array, Array]]:
    """Points of a round hole, each with the direction outwards.

    Args:
        centre: centre of the hole, mm.
        radius: its radius, mm.
    """
    for turn in np.radians(_AROUND):
        out = np.array([np.cos(turn), np.sin(turn)])
        yield np.array(centre) + radius * out, out


def outline_tips(contour: Contour, clear_of: float | None = None) -> list[tuple[Array, Array]]:
    """Points of an outline at which a leader may end, each with the direction outwards, those on diagonals first.

    Args:
        contour: closed outline about the axis.
        clear_of: polar angle of a keyway or flat, from which they keep off, rad; None without one.
    """
    points = contour.polygon(_CHORD)
    angles = np.arctan2(points[:, 1], points[:, 0])
    found = []
    for wanted in np.radians(_DIAGONALS):
        if clear_of is not None and np.cos(wanted - clear_of) > _CLEAR:
            continue
        place = int(np.abs(np.angle(np.exp(1j * (angles - wanted)))).argmin())
        x, y = points[(place + 1) % len(points)] - points[place - 1]
        out = np.array([y, -x]) / float(np.hypot(x, y))
        found.append((points[place], out if float(out @ points[place]) > 0 else -out))
    return found


def hole_frames(holes: Sequence[tuple[str, tuple[float, float], float, float]], room: Room) -> Iterator[Symbol]:
    """Frames of holes, and the datums that hang from the first two.

    Args:
        holes: name, centre, diameter and width of the zone of each hole, mm, the datum first.
        room: room in the view.
    """
    datums: tuple[str, ...] = ("A",)
    for number, (name, centre, diameter, zone) in enumerate(holes):
        frame = ToleranceFrame(
            name=name,
            characteristic=Characteristic.POSITION if number else Characteristic.PERPENDICULARITY,
            zone=zone,
            datums=datums,
            tip=(0.0, 0.0),
            bend=(1.0, 0.0),
            diametral=True,
        )
        placed = room.frame(frame, list(rim(centre, diameter / 2)))
        yield placed
        if number < min(len(_LETTERS), len(holes) - 1):
            yield room.hung(_LETTERS[number], placed)
            datums = (*datums, _LETTERS[number])


def edge_view(
    thickness: float,
    ends: tuple[float, float],
    holes: Sequence[tuple[float, float]],
    place: tuple[float, float],
    scale: float,
    suffix: str = "",
) -> View:
    """View of a plate from the right, on whose face datum A stands: holes hidden.

    Args:
        thickness: thickness, mm.
        ends: lower and upper end, mm.
        holes: height and diameter of each hole, mm.
        place: where its left face at height 0 lies on the paper, mm.
        scale: mm on paper for a mm of the part.
        suffix: limits of the thickness, in words.
    """
    low, high = ends
    corners = np.array([[0.0, low], [thickness, low], [thickness, high], [0.0, high], [0.0, low]])
    curves: list[Closed | Stroke] = [Stroke(corners)]
    for at, diameter in holes:
        for side in (-0.5, 0.5):
            line = np.array([[0.0, at + side * diameter], [thickness, at + side * diameter]])
            curves.append(Stroke(line, LineKind.HIDDEN))
        curves.append(Stroke(np.array([[-2.0 / scale, at], [thickness + 2.0 / scale, at]]), LineKind.CENTRE))
    long = TEXT * WIDEST * len(f"{rounded(thickness)}{suffix}")
    across = LinearDimension(
        name="thickness",
        start=(0.0, high),
        end=(thickness, high),
        at=(0.0, high + _OVER / scale),
        suffix=suffix,
        beside=0.0 if scale * thickness > long + 4.0 else scale * thickness / 2 + TAIL + long / 2 + 1.0,
    )
    heights = np.linspace(low, high, 41)[4:-4]
    clear = [min((abs(at - y) - size / 2 for at, size in holes), default=inf) for y in heights]
    foot = (thickness, float(heights[int(np.argmax(clear))]))
    return View(
        place=place,
        curves=tuple(curves),
        dimensions=(across,),
        symbols=(DatumFeature(letter="A", foot=foot, angle=0.0),),
    )
