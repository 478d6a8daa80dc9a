"""Points where an outline turns, for the sheet of a cam: a table of radii in equal steps may miss them.

They are its highs and lows, its sharpest bends, and the ends of arcs about the axis, on which a follower rests.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

import numpy as np
from scipy.ndimage import maximum_filter1d

from cadgen.arrays import Array
from cadgen.messages import Message

_MOST = 16  # points on a sheet
_SHARP = 2.0  # times as curved as a circle about the axis is a bend
_NEAR, _LEAST = 5.0, 3.0  # degrees within which one point of a kind stands, and the least arc about the axis
_ONE = 1.0  # degrees within which points of two kinds are one
_ARC = 1e-6  # of the curvature of a circle, within which an outline is an arc about the axis
_ENDS = 1e-11  # mm, within which a point beside an arc is its end, where the next law begins with another curvature
_FLAT = 1e-3  # mm, within which radii are equal on a sheet


@dataclass(frozen=True, slots=True, kw_only=True)
class OutlineTurn:
    """A point where an outline turns.

    Attributes:
        word: what it is.
        angle: polar angle, rad.
        radius: distance from the axis, mm.
        bend: radius of curvature, mm; infinite where it is straight.
    """

    word: str
    angle: float
    radius: float
    bend: float


def outline_turns(radii: Array, curvature: Array, points: int = _MOST) -> tuple[OutlineTurn, ...]:
    """Points where an outline turns, by their polar angles; of many, those that bend most and its extremes.

    Args:
        radii: distances of the outline from the axis in equal steps of the polar angle from 0, shape (n,), mm.
        curvature: its curvature there, positive where it is convex, shape (n,), mm^-1.
        points: how many are kept.
    """
    step, count = 360.0 / len(radii), len(radii)
    most, least = int(radii.argmax()), int(radii.argmin())
    inside, found, bends = np.zeros(count, dtype=bool), dict[int, Message](), np.abs(curvature)
    for first, last in _arcs(radii, curvature, round(_LEAST / step)):
        places = np.arange(first, last + 1) % count
        inside[places], bends[places] = True, 1.0 / radii[places]
        words = Message("arc from"), Message("arc to")
        if most in places:
            words = Message("greatest, from"), Message("greatest, to")
        elif least in places:
            words = Message("least, from"), Message("least, to")
        found |= dict(zip((first, last % count), words, strict=True))
    extremes = {least: Message("least"), most: Message("greatest")}
    found |= {place: word for place, word in extremes.items() if not inside[place]}
    for values, lift, word, counts in (
        (radii, _FLAT, Message("high"), ~inside),
        (-radii, _FLAT, Message("low"), ~inside),
        (bends, 0.0, Message("bend"), ~inside & (bends * radii > _SHARP)),
    ):
        for place in _peaks(values, lift, round(_NEAR / step)):
            aside = [abs((place - other + count / 2) % count - count / 2) * step for other in found]
            if counts[place] and min(aside, default=_ONE) >= _ONE:
                found[place] = word
    kept = sorted(found, key=lambda place: (place not in extremes, -bends[place]))[:points]
    return tuple(
        OutlineTurn(
            word=Message("{point}, hollow", point=found[place]) if curvature[place] < 0.0 else found[place],
            angle=float(np.radians(place * step)),
            radius=float(radii[place]),
            bend=1.0 / float(bends[place]) if bends[place] else inf,
        )
        for place in sorted(kept)
    )


def _peaks(values: Array, lift: float, near: int) -> Iterator[int]:
    """Places of the greatest value within `near` steps, which is greater than at the ends of these by `lift`."""
    greatest = maximum_filter1d(values, 2 * near + 1, mode="wrap")
    ends = np.maximum(np.roll(values, near), np.roll(values, -near))
    yield from np.flatnonzero((values == greatest) & (values > ends + lift)).tolist()


def _arcs(radii: Array, curvature: Array, least: int) -> Iterator[tuple[int, int]]:
    """First and last place of each arc about the axis; the last counts on beyond the turn."""
    count = len(radii)
    even = np.abs(curvature * radii - 1.0) < _ARC
    level = np.abs(radii - np.roll(radii, 1)) < _ENDS
    even |= (np.roll(even, 1) & level) | (np.roll(even, -1) & np.roll(level, -1))
    if even.all():
        return
    start = int(np.flatnonzero(~even)[0])
    turned = np.roll(even, -start).astype(int)
    begins, ends = np.flatnonzero(np.diff(turned) == 1) + 1, np.flatnonzero(np.diff([*turned, 0]) == -1)
    for begin, end in zip(begins.tolist(), ends.tolist(), strict=True):
        first, last = (start + begin) % count, (start + begin) % count + end - begin
        if end - begin >= least and np.ptp(radii[np.arange(first, last + 1) % count]) < _FLAT:
            yield first, last
