"""Rests of a measured motion, and the flanks between them, by the slope of a few neighbours."""

from dataclasses import dataclass
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.inference.motions.lift_samples import LiftSamples

_WINDOW = radians(2.5)  # to each side, over which a slope is taken
_BESIDE = 3  # samples to each side at least
_STILL = 5.0  # times its standard deviation, below which a slope is none
_LEAST_RISE = 0.01  # of the travel; a smaller one is no flank
_LEAST_NOISES = 25.0


@dataclass(frozen=True)
class SeenFlank:
    """Flank as it is seen: a stretch in which the motion only found or only falls.

    Attributes:
        start: cam angle at which the slope begins to show, rad.
        stop: cam angle at which it ceases to, rad, greater than the start.
    """

    start: float
    stop: float


def seen_flanks(samples: LiftSamples) -> tuple[SeenFlank, ...]:
    """Flanks of a turn, in order from the first that begins after cam angle 0.

    Args:
        samples: samples of the motion.
    """
    angle, height = samples.cam_angle, samples.q * np.median(samples.push)
    slope, error = _slopes(angle, height, samples.noise)
    sign = np.where(np.abs(slope) < _STILL * error, 0, np.sign(slope)).astype(int)
    least = max(_LEAST_RISE * float(np.ptp(height)), _LEAST_NOISES * samples.noise)
    if not sign.any():
        return ()
    n = len(sign)
    # Begin where a stretch begins.
    starts = [k for k in range(n) if sign[k] != sign[k - 1]]
    if not starts:
        return ()
    found: list[SeenFlank] = []
    for place, begin in enumerate(starts):
        end = starts[(place + 1) % len(starts)]
        length = (end - begin) % n or n
        if not sign[begin]:
            continue
        rows = (begin + np.arange(length)) % n
        if abs(float(height[rows[-1]] - height[rows[0]])) < least:
            continue
        start = float(angle[rows[0]])
        stop = float(angle[rows[-1]])
        found.append(SeenFlank(start, stop if stop > start else stop + TURN))
    return tuple(sorted(found, key=lambda each: each.start))


def _slopes(angle: Array, height: Array, noise: float) -> tuple[Array, Array]:
    """Slope at each sample by a straight line through neighbours, and its standard deviation, shape (n,) each."""
    n = len(angle)
    half = max(_BESIDE, round(_WINDOW * n / TURN))
    number: NDArray[np.intp] = (np.arange(n)[:, None] + np.arange(-half, half + 1)) % n
    near = np.mod(angle[number] - angle[:, None] + TURN / 2, TURN) - TURN / 2
    near -= near.mean(axis=1, keepdims=True)
    power = np.sum(near**2, axis=1)
    return np.sum(near * height[number], axis=1) / power, max(noise, 1e-6) / np.sqrt(power)
