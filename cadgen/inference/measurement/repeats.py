"""Errors that repeat over logged runs of one path beside the effects found: no noise, though they have no name.

Errors add up along a run, so that what is left is smooth and large, and looks alike by chance in two runs. Runs of one
path are laid on each other, and the mean of what is left in them is held against its scatter.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array

Complex = NDArray[np.complex128]

# Places along a run at which runs are compared.
STATIONS = 64
# Runs are of one path if they lie within this share of its extent on each other.
ONE_PATH = 0.15
# Fewer runs of one path look alike by chance.
LEAST_ALIKE = 3
# Draws of the test, and the chance below which something repeats.
DRAWS, CHANCE = 2000, 0.01
# Share of what is left that the mean of the other runs must predict of each run.
LEAST_SHARE = 0.2


@dataclass(frozen=True, slots=True)
class Repeats:
    """Error that repeats over runs of one path.

    Attributes:
        rms: root mean square along the run of what repeats, mm, less what chance makes of the mean.
        left: root mean square of all that is left in these runs, mm.
        size, place: greatest value, mm, and where on the run, as a share of it.
        runs: how many are of that path, numbered from 0.
    """

    rms: float
    left: float
    size: float
    place: float
    runs: tuple[int, ...]

    @property
    def most(self) -> bool:
        """Whether more than half of the square of what is left repeats."""
        return bool(2 * self.rms**2 > self.left**2)


def one_path(paths: Sequence[Complex]) -> list[list[int]]:
    """Numbers of the runs of each path, the most driven one first.

    Args:
        paths: places of each run as x + iy, at `STATIONS` places along it, mm.
    """
    groups: list[list[int]] = []
    for number in range(len(paths)):
        for group in groups:
            first, other = (paths[k] - paths[k].mean() for k in (group[0], number))
            off = other * np.exp(-1j * _turn(first, other)) - first
            if np.sum(np.abs(off) ** 2) <= ONE_PATH**2 * np.sum(np.abs(first) ** 2):
                group.append(number)
                break
        else:
            groups.append([number])
    return sorted(groups, key=len, reverse=True)


def repeats(paths: Sequence[Complex], left: Sequence[Complex]) -> list[Repeats]:
    """Errors that repeat on each path driven often enough, largest first; empty where nothing does.

    The mean of n runs has the square |m|^2 = R^2 + s^2 / n, with what repeats R and the scatter s of the runs. By
    chance the runs' errors point anywhere: |sum of r_k exp(i phi_k)|^2 with phi at random is as large as observed in
    less than `CHANCE` of the draws, or nothing is said.

    Args:
        paths: places of each run as x + iy, at `STATIONS` places along it, mm.
        left: what is left there, start registered, mm.
    """
    found = []
    for group in one_path(paths):
        if len(group) < LEAST_ALIKE:
            continue
        first = paths[group[0]]
        turned = np.array([left[k] * np.exp(-1j * _turn(first, paths[k])) for k in group])
        runs, mean = len(group), turned.mean(axis=0)
        scatter = float(np.mean(np.sum(np.abs(turned - mean) ** 2, axis=0))) / (runs - 1)
        square = float(np.mean(np.abs(mean) ** 2)) - scatter / runs
        all_left = float(np.mean(np.abs(turned) ** 2))
        others = (turned.sum(axis=0) - turned) / (runs - 1)
        told = 1 - float(np.mean(np.abs(turned - others) ** 2)) / max(all_left, 1e-300)
        gram = turned @ turned.conj().T
        phases = np.exp(2j * np.pi * np.random.default_rng(0).random((DRAWS, runs)))
        drawn = np.einsum("di,ij,dj->d", phases.conj(), gram, phases).real
        chance = (1 + np.count_nonzero(drawn >= gram.sum().real * (1 - 1e-9))) / (1 + DRAWS)
        if square > 0 and told >= LEAST_SHARE and chance < CHANCE:
            worst = int(np.argmax(np.abs(mean)))
            place = worst / (STATIONS - 1)
            found.append(Repeats(square**0.5, all_left**0.5, float(np.abs(mean[worst])), place, tuple(group)))
    return sorted(found, key=lambda r: r.rms, reverse=True)


def disturbances(path: Complex, knots: int) -> Array:
    """Errors of a path whose heading or travel is disturbed from one of several places on, shape (2n, 2 knots), mm.

    From place u on, the path z is off by i (z - z(u)) for each radian of heading, and by z - z(u) for each unit of
    travel. Rows are first all x, then all y; columns first those of the heading.

    Args:
        path: places of a run, x + iy, shape (n,), mm.
        knots: number of places, evenly over the run.
    """
    starts = np.linspace(0, len(path), knots, endpoint=False).astype(int)
    off = np.where(np.arange(len(path))[:, None] > starts, path[:, None] - path[starts], 0.0)
    return np.block([[-off.imag, off.real], [off.real, off.imag]])


def _turn(one: Complex, other: Complex) -> float:
    """Angle by which a path is turned against another, rad."""
    return float(np.angle(np.vdot(one - one.mean(), other - other.mean())))
