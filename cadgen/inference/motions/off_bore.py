"""Origin of a measured outline beside the bore: how far, by laying the points onto the design's outline.

The middles of the areas of both outlines lie on each other, whatever the angle between them. About its middle each
outline is a radius by the polar angle, and the angle is that at which both radii go together best:
    c = m - R(phi) d,
with m and d the middles of the measured outline and of the design's about its bore.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.curves.closed import ClosedCurve
from cadgen.inference.motions.lift_samples import ordered

_STATIONS = 1440
_STEP = 0.1  # mm, between points of the design's outline
_BESIDE = 1.0  # mm; less is an eccentric bore, which is measured
_BETTER = 0.2  # of the misfit about the origin, below which the bore lies elsewhere


@dataclass(frozen=True)
class OffBore:
    """Bore of an outline that was measured about another point.

    Attributes:
        x: place of the bore in the frame of the points, mm.
        y: place of the bore in the frame of the points, mm.
        before: rms of the radii about the origin, mm.
        after: rms of the radii with the shift taken out, mm.
    """

    x: float
    y: float
    before: float
    after: float


def off_bore(points: Array, disc: ClosedCurve) -> OffBore | None:
    """Place of the bore where points were measured about another point; None where they lie about their origin.

    Args:
        points: points of the outline, mm, shape (n, 2).
        disc: outline as designed, about its bore, mm.
    """
    found = []
    for across in (1.0, -1.0):  # as meant, and wrong side up
        face = np.array([1.0, across])
        seen, plan = ordered(points * face), ordered(disc.outline(_STEP).points)
        middle, meant = _middle(seen), _middle(plan)
        turn, after = _laid(_radii(seen - middle), _radii(plan - meant))
        bore = middle - _turned(meant, turn)
        found.append((after, bore * face, _laid(_radii(seen), _radii(plan))[1]))
    after, (x, y), _ = min(found, key=lambda each: each[0])
    before = min(each[2] for each in found)
    if np.hypot(x, y) < _BESIDE or after > _BETTER * before:
        return None
    return OffBore(float(x), float(y), before, after)


def _middle(points: Array) -> Array:
    """Middle of the area within points counter-clockwise, mm, shape (2,)."""
    after = np.roll(points, -1, axis=0)
    area = points[:, 0] * after[:, 1] - after[:, 0] * points[:, 1]
    return np.asarray((points + after).T @ area / (3 * area.sum()))


def _radii(points: Array) -> Array:
    """Radii at even polar angles, mm, shape (_STATIONS,)."""
    angle = np.arctan2(points[:, 1], points[:, 0])
    order = np.argsort(angle)
    even = np.arange(_STATIONS) * (TURN / _STATIONS)
    return np.asarray(np.interp(even, angle[order], np.hypot(*points[order].T), period=TURN))


def _laid(seen: Array, meant: Array) -> tuple[float, float]:
    """Angle by which radii are turned against those meant, rad, and the rms that is left, mm."""
    together = np.fft.irfft(np.fft.rfft(seen) * np.conj(np.fft.rfft(meant)), _STATIONS)
    number = int(np.argmax(together))
    return number * TURN / _STATIONS, float(np.sqrt(np.mean((seen - np.roll(meant, number)) ** 2)))


def _turned(vector: Array, angle: float) -> Array:
    turned = complex(*vector) * np.exp(1j * angle)
    return np.array([turned.real, turned.imag])
