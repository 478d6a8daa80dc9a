"""Whether a run passes the gates of a course, where, and by what margin."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.course.body import place_of
from cadgen.car.course.course import Gate
from cadgen.car.course.poses import Complex, Poses
from cadgen.car.steering import Car


@dataclass(frozen=True, kw_only=True)
class Passage:
    """Passage of a gate.

    Attributes:
        gate: the gate.
        margin: distance by which the point of the car is inside the gate, mm: what is left of a disc's radius, or the
            distance from a segment's nearer end; less than 0 if it misses the gate by that much.
        off: distance from the middle of the gate, mm.
        place: number of the pose there, whole or between two.
        travel: travel of the drive wheel up to there, mm.
        fault: why the gate does not count although the car gets there: `heading`, `order`; empty if nothing is wrong.
    """

    gate: Gate
    margin: float
    off: float
    place: float
    travel: float
    fault: str = ""

    @property
    def missed(self) -> str:
        """How a gate that is not passed is missed, in words."""
        if self.fault:
            return f"{self.gate.key} in the wrong {self.fault}"
        return f"{self.gate.key} missed by {-self.margin:.1f} mm"


def passages(poses: Poses, car: Car, gates: Sequence[Gate]) -> tuple[Passage, ...]:
    """Passage of each gate. Gates that are not free are passed one after the other, each as early as it can be.

    Of a gate that is passed several times the best passage counts that leaves the order.
    """
    passed, earliest = [], 0.0
    tracks = {point: poses.track(place_of(point, car)) for point in {gate.point for gate in gates}}
    for gate in gates:
        result, first = _passage(poses, tracks[gate.point], gate, 0.0 if gate.free else earliest)
        passed.append(result)
        if not gate.free:
            earliest = max(earliest, first)
    return tuple(passed)


def _passage(poses: Poses, track: Complex, gate: Gate, since: float) -> tuple[Passage, float]:
    """Best passage from a place on, and the earliest place at which the gate is passed; `since` if it is not."""
    place, margin, off = (_through_segment if len(gate.place.points) > 1 else _through_disc)(track, gate)
    headed = _headed(poses, gate, place)
    later = place >= since
    fault = ""
    allowed = headed & later
    if not (margin[allowed] >= 0).any():
        for wider, name in ((headed, "order"), (later, "heading"), (np.ones_like(later), "order and heading")):
            if (margin[wider] >= 0).any():
                allowed, fault = wider, name
                break
    chosen = np.flatnonzero(allowed if allowed.any() else later if later.any() else np.ones_like(later))
    best = chosen[int(np.argmax(margin[chosen]))]
    inside = np.flatnonzero(allowed & (margin >= 0))
    first = float(place[inside[0]]) if inside.size and not fault else since
    where = float(place[best])
    travel = float(np.interp(where, np.arange(len(poses)), poses.travel))
    return Passage(
        gate=gate, margin=float(margin[best]), off=float(off[best]), place=where, travel=travel, fault=fault
    ), first


def _through_disc(track: Complex, gate: Gate) -> tuple[Array, Array, Array]:
    """Nearest place on each piece of the track, the margin and the distance from the middle there, shape (n - 1,)."""
    centre = complex(*gate.place.points[0])
    start, along = track[:-1] - centre, np.diff(track)
    length = np.maximum(np.abs(along) ** 2, 1e-300)
    share = np.clip(-np.real(start * along.conj()) / length, 0.0, 1.0)
    off = np.abs(start + share * along)
    return np.arange(len(along)) + share, gate.place.reach - off, off


def _through_segment(track: Complex, gate: Gate) -> tuple[Array, Array, Array]:
    """Places where the track crosses the segment's line, and between them the nearest place of each piece."""
    a, b = (complex(*point) for point in gate.place.points)
    length = abs(b - a)
    local = (track - a) * (b - a).conjugate() / length  # along the segment from its first end, and to its left
    height = local.imag
    crosses = (height[:-1] <= 0) != (height[1:] <= 0)
    drop = np.where(crosses, height[:-1] - height[1:], 1.0)
    share = np.where(crosses, height[:-1] / drop, 0.0)
    there = local[:-1] + share * np.diff(local)
    along = there.real
    inside = np.minimum(along, length - along)
    # Without a crossing the track misses the segment by the distance from it.
    beyond = np.abs(there - np.clip(along, 0.0, length))
    margin = np.where(crosses, np.where(inside >= 0, inside, -beyond), -np.maximum(beyond, np.finfo(float).tiny))
    return np.asarray(np.arange(len(share)) + share), np.asarray(margin), np.abs(there - length / 2)


def _headed(poses: Poses, gate: Gate, place: Array) -> NDArray[np.bool_]:
    if gate.heading is None:
        return np.ones(len(place), dtype=bool)
    return np.asarray(np.abs(turned_by(poses.at(place).heading, gate.heading)) <= gate.heading_tolerance)


def turned_by(heading: Array, wanted: float) -> Array:
    """Angle from a direction to headings, rad, between minus and plus half a turn.

    Args:
        heading: headings, rad.
        wanted: direction, rad.
    """
    return np.asarray((heading - wanted + TURN / 2) % TURN - TURN / 2)
