"""Ends of segments at whole or half degrees, where the sound flanks of a measured cam show that they were drawn so.

Wear that is spread as the velocity of its flank looks like a flank that is turned: the data alone cannot tell them
apart. Drawings do. The ends of flanks that are not worn may lie on a grid, by far too well for chance, and the others
beside it as wear would put them: later on a rise and earlier on a return. Then all are taken to lie on it.
"""

from dataclasses import dataclass, replace
from math import degrees, radians

import numpy as np

from cadgen.arrays import Array
from cadgen.inference.motions.found_motion import DECIDED, FoundMotion

_GRIDS_DEG = (1.0, 0.5)
_SIGMAS, _ALWAYS_DEG = 3.0, 0.005  # within which an end is on the grid
_ALIKE_DEG = 0.02  # within which two ways to lie on the grid are one
_MOST_SHIFT = 0.45  # of the grid
_MOST_WEAR = 0.06  # mm, that a shift may stand for where the flank is steepest
_STEEPEST = 1.8  # velocity of a usual law at its greatest, by its mean
_MOST_CHANCE = 0.03  # of ends that lie on a grid by accident
_LATER = 0.25  # chance that both ends of a flank lie on the side on which wear puts them


@dataclass(frozen=True, eq=False)
class GridMotion:
    """Motion with all ends of segments on a grid.

    Attributes:
        motion: motion with its ends there.
        step: step of the grid, degrees.
        shifts: displacement of each flank's ends as measured alone from there, degrees, shape (flanks, 2).
        sure: whether the data tell which flanks are turned by wear; else others may be, by as much.
    """

    motion: FoundMotion
    step: float
    shifts: Array
    sure: bool


def on_grid(found: FoundMotion, known: float | None = None) -> GridMotion | None:
    """Motion with its ends on a grid; None where the flanks show none.

    Args:
        found: motion whose flanks are all of the table.
        known: step of the grid where the drawing is known to have one, degrees; then no flank need show it.
    """
    if not all(flank.in_table for flank in found.flanks):
        return None
    ends = np.degrees([[flank.start, flank.stop] for flank in found.flanks])
    sigma = np.degrees([[flank.start_sigma, flank.stop_sigma] for flank in found.flanks])
    within = _SIGMAS * sigma + _ALWAYS_DEG
    for step in _GRIDS_DEG if known is None else (known,):
        tried: list[tuple[tuple[int, int, float], GridMotion]] = []
        for anchor in range(len(ends)):
            weight = 1 / within[anchor] ** 2
            off = np.mod(ends[anchor] + step / 2 - ends[anchor, 0], step) - step / 2
            phase = ends[anchor, 0] + float(weight @ off / weight.sum())
            shifts = np.mod(ends - phase + step / 2, step) - step / 2
            chance = _chance(found, shifts, within, step)
            if chance is None or (known is None and chance * len(ends) > _MOST_CHANCE):
                continue
            placed = []
            for flank, (start, stop) in zip(found.flanks, shifts, strict=True):
                a, b = flank.start - radians(start), flank.stop - radians(stop)
                values = np.array([a, b, *flank.best.values[2:]])
                fits = (flank.best.pinned(values), *flank.fits[1:])
                placed.append(replace(flank, start=a, stop=b, fits=fits))
            flanks = tuple(placed)
            # Flanks whose ends lie on the grid as measured. Ends that were moved are those of flanks that show wear,
            # and the wear that is left explains them.
            stay = np.all(np.abs(shifts) <= within, axis=1).tolist()
            stayed = [flank for flank, on in zip(found.flanks, stay, strict=True) if on]
            sound = sum(not flank.best.process.size for flank in stayed)
            moved = [flank for flank in found.flanks if flank not in stayed]
            if known is None and sound < len(stayed) and any(not flank.best.process.size for flank in moved):
                continue
            misfit = sum(flank.best.score for flank in flanks)
            # Lifts are read from a mark of the dividing head on, which the drawing has, too.
            marked = found.samples.normal is None and abs((phase + step / 2) % step - step / 2) <= within[anchor].max()
            rank = (-int(marked), -sound, misfit)
            # One flank alone shows no grid against another that looks as sound.
            backed = (
                known is not None or bool(marked) or len(stayed) > 1 or all(flank.best.process.size for flank in moved)
            )
            tried.append((rank, GridMotion(replace(found, flanks=flanks), step, shifts, sure=backed)))
        if tried:
            (rank, best), *others = sorted(tried, key=lambda each: each[0])
            rivals = [grid for other, grid in others if other[:2] == rank[:2] and other[2] < rank[2] + DECIDED]
            return replace(
                best, sure=best.sure and all(np.abs(grid.shifts - best.shifts).max() < _ALIKE_DEG for grid in rivals)
            )
    return None


def _chance(found: FoundMotion, shifts: Array, within: Array, step: float) -> float | None:
    """Chance that ends lie so by accident; None where a flank is off the grid as wear would not put it."""
    chance = 1.0
    for flank, shift, near in zip(found.flanks, shifts, within, strict=True):
        if (np.abs(shift) <= near).all():
            chance *= float(np.prod(np.minimum(2 * near / step, 1.0)))
            continue
        rises = 1.0 if flank.after > flank.before else -1.0
        speed = abs(flank.after - flank.before) * float(np.median(flank.best.data.push))
        speed /= degrees(flank.stop - flank.start)
        if (rises * shift < -near).any() or (np.abs(shift) > _MOST_SHIFT * step).any():
            return None
        if float(np.abs(shift).max()) * _STEEPEST * speed > _MOST_WEAR:
            return None
        chance *= _LATER
    # One end sets the phase.
    widest = float(np.minimum(2 * within / step, 1.0).min())
    return chance / max(widest, 1e-9)
