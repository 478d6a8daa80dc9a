"""Wear of a disc's flanks beside deviations: smooth random processes that only take material away.

Deviations are smooth over the whole turn, wear lies on a flank. Each flank that moves the follower may be worn, or all
of them; the lengths and sizes tried are those of `cadgen.inference.motions.flank_fit`, and so is the cost of wear that
would add material.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import log

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.inference.motions.flank_fit import FlankData, WearProcess, sign_cost
from cadgen.laws.motion import Motion

_BESIDE = np.radians(3.0)  # beside a flank, over which wear fades
_STILL = 1e-6  # of the greatest slope, below which a motion dwells
_STATIONS = 1440
_FEWEST = 20  # readings of a flank that can show wear


@dataclass(frozen=True)
class FlankWear:
    """Wear of a flank.

    Attributes:
        start: cam angle at which the flank begins, rad.
        stop: cam angle at which it ends, rad.
        depth: greatest depth along the normal, mm.
        cam_angle: cam angle of that, rad.
    """

    start: float
    stop: float
    depth: float
    cam_angle: float


@dataclass(frozen=True, eq=False)
class WornFlank:
    """Readings of a flank that may be worn.

    Attributes:
        rows: numbers of its readings, shape (n,).
        data: the readings.
    """

    rows: NDArray[np.intp]
    data: FlankData


@dataclass(frozen=True, eq=False)
class DiscWear:
    """Flanks that are worn alike, each by a process of one length and size; without a flank a disc that is not worn.

    Attributes:
        flanks: flanks.
        number: number of the process among those of a flank.
        noise: standard deviation of a reading along the normal, mm.
    """

    flanks: tuple[WornFlank, ...]
    number: int
    noise: float

    @cached_property
    def processes(self) -> tuple[WearProcess, ...]:
        """Wear of each flank."""
        return tuple(flank.data.processes[self.number] for flank in self.flanks)

    @property
    def log_determinant(self) -> float:
        """Logarithm of the determinant of the readings' covariance, beyond that of their noise."""
        plain = sum(2 * len(flank.rows) * log(self.noise) for flank in self.flanks)
        return sum(process.log_determinant for process in self.processes) - plain

    def whitened(self, values: Array) -> Array:
        """Values of all readings in standard deviations, without correlation.

        Args:
            values: values along the normal, mm, or by a parameter, shape (n, k).
        """
        white = values / self.noise
        for flank, process in zip(self.flanks, self.processes, strict=True):
            white[flank.rows] = process.whitened(values[flank.rows])
        return np.asarray(white)

    def sign_cost(self, residual: Array, columns: Array, covariance: Array) -> float:
        """Misfit of wear that would add material.

        Args:
            residual: readings less what explains them beside the wear, mm, shape (n,).
            columns: derivatives of that by its values, mm by unit, shape (n, k).
            covariance: covariance of the values, mm² or rad², shape (k, k).
        """
        return sum(
            sign_cost(process, residual[flank.rows], columns[flank.rows], covariance)
            for flank, process in zip(self.flanks, self.processes, strict=True)
        )

    def expected(self, residual: Array) -> Array:
        """Wear that is to be expected at the readings, mm, shape (n,).

        Args:
            residual: readings less what explains them beside the wear, mm, shape (n,).
        """
        worn = np.zeros(len(residual))
        for flank, process in zip(self.flanks, self.processes, strict=True):
            worn[flank.rows] = process.expected(residual[flank.rows], flank.data.theta)
        return worn

    def depths(self, residual: Array) -> tuple[FlankWear, ...]:
        """Greatest wear of each flank on which it stands out of the noise.

        Args:
            residual: readings less what explains them beside the wear, mm, shape (n,).
        """
        worn, found = self.expected(residual), []
        for flank in self.flanks:
            deepest = int(np.argmax(worn[flank.rows]))
            data = flank.data
            if worn[flank.rows][deepest] < self.noise:
                continue
            found.append(
                FlankWear(
                    data.start % TURN,
                    data.stop % TURN,
                    float(worn[flank.rows][deepest]),
                    float(data.theta[deepest] % TURN),
                )
            )
        return tuple(found)


def wears(motion: Motion, theta: Array, noise: float, keep: NDArray[np.bool_]) -> tuple[DiscWear, ...]:
    """Wear that a disc may have: none, of each flank, or of all, by each process.

    Args:
        motion: motion wanted.
        theta: cam angles of the readings, rad, shape (n,).
        noise: standard deviation of a reading along the normal, mm.
        keep: readings that count, shape (n,).
    """
    none = DiscWear((), 0, noise)
    flanks: list[WornFlank] = []
    for start, stop in _moving(motion):
        within = np.mod(theta - (start - _BESIDE), TURN)
        rows = np.flatnonzero(keep & (within < stop - start + 2 * _BESIDE))
        taken = np.concatenate([flank.rows for flank in flanks]) if flanks else np.zeros(0, dtype=np.intp)
        rows = np.setdiff1d(rows, taken)
        if len(rows) < _FEWEST:
            continue
        at = within[rows] + start - _BESIDE
        empty = np.zeros(len(rows))
        flanks.append(WornFlank(rows, FlankData(at, empty, empty + 1, noise, start, stop, 0.0, 1.0)))
    sets = [(flank,) for flank in flanks] + ([tuple(flanks)] if len(flanks) > 1 else [])
    counts = [range(1, len(each[0].data.processes)) for each in sets]
    return (
        none,
        *(DiscWear(each, number, noise) for each, numbers in zip(sets, counts, strict=True) for number in numbers),
    )


def _moving(motion: Motion) -> Sequence[tuple[float, float]]:
    """Cam angles between which the follower rises or returns, rad; the second is the greater."""
    theta = np.arange(_STATIONS) * TURN / _STATIONS
    slope = motion.jets(theta)[:, 1]
    way = np.where(np.abs(slope) > _STILL * np.abs(slope).max(), np.sign(slope), 0.0)
    changes = np.flatnonzero(way != np.roll(way, 1))
    found = []
    for number, first in enumerate(changes):
        last = changes[(number + 1) % len(changes)]
        if way[first]:
            found.append((float(theta[first]), float(theta[first] + (theta[last] - theta[first]) % TURN)))
    return found
