"""A found motion as a design states it: segments from cam angle 0 on, in degrees, with rises, dwells and laws."""

from dataclasses import dataclass
from math import degrees, exp

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.inference.motions.candidates import RATIO_CODE
from cadgen.inference.motions.found_motion import FoundMotion
from cadgen.inference.motions.whole_degrees import GridMotion, on_grid

_SAME = 4.0  # standard deviations within which two levels, or two ends, are one
_ROUND = 3.0  # standard deviations within which a number is a round one, if that is no accident
_MOST_CHANCE = 0.15
_DIGITS = 4  # of angles, degrees
_POINTS = 240  # of a motion that has no law, in a turn


@dataclass(frozen=True, kw_only=True)
class StatedSegment:
    """Segment of a stated motion.

    Attributes:
        width: cam angle that it takes, degrees.
        after: height at its end, in the unit of the design file, mm or degrees.
        law: code of its law; empty for a dwell.
        ratio: ratio of its accelerations; None of any other law than the unequal parabola.
    """

    width: float
    after: float
    law: str = ""
    ratio: float | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class StatedMotion:
    """Found motion as a design states it.

    Attributes:
        motion: motion with the values that are stated.
        grid: step of the grid on which all ends of segments lie, degrees; None where they show none.
        zero: cam angle in the frame of the samples that becomes cam angle 0, rad.
        segments: segments from cam angle 0 on; empty where a flank has no law of the table.
        points: cam angle, degrees, and height of points of the motion where a flank has no law.
        rounded: step to which heights were rounded, in the unit of the file; None where they show none.
    """

    motion: FoundMotion
    grid: GridMotion | None
    zero: float
    segments: tuple[StatedSegment, ...]
    points: tuple[tuple[float, float], ...]
    rounded: float | None


def stated_motion(
    found: FoundMotion, scale: float, steps: tuple[float, ...], ends_at: float | None = None
) -> StatedMotion:
    """Motion with its numbers as a design states them.

    Args:
        found: motion.
        scale: unit of the design file by that of the motion: 1 for mm, degrees by rad of a swing.
        steps: round steps of heights, in the unit of the file, the widest first.
        ends_at: step of the grid at which the drawing has its ends, degrees; None where that is not known.
    """
    grid = on_grid(found, ends_at)
    # Where it is not sure which flank is turned, ends stay as they were measured.
    motion = grid.motion if grid is not None and grid.sure else found
    first = _first(motion)
    order = [(first + number) % len(motion.flanks) for number in range(len(motion.flanks))]
    zero = motion.flanks[first].start
    levels, step = _levels(motion, order, scale, steps)
    if not all(flank.in_table for flank in motion.flanks):
        # Where a flank begins is not known without its law: angles stay those of the samples.
        theta = np.arange(_POINTS) * TURN / _POINTS
        heights = motion.lift(theta) * scale
        points = tuple(
            (round(360.0 * number / _POINTS, _DIGITS), round(float(height), 5)) for number, height in enumerate(heights)
        )
        return StatedMotion(motion=motion, grid=grid, zero=0.0, segments=(), points=points, rounded=None)
    segments: list[StatedSegment] = []
    at = 0.0
    for place, number in enumerate(order):
        flank, after = motion.flanks[number], order[(place + 1) % len(order)]
        stop = round(degrees((flank.stop - zero) % TURN) if flank.stop - zero < TURN else 360.0, _DIGITS)
        start = (
            360.0 if place == len(order) - 1 else round(degrees((motion.flanks[after].start - zero) % TURN), _DIGITS)
        )
        gap, sigma = start - stop, degrees(motion.dwell_sigma(after))
        if gap <= (0.0 if motion is not found else _SAME * sigma):
            # No dwell: both ends are one.
            stop = start if place == len(order) - 1 or motion is not found else round((start + stop) / 2, _DIGITS)
            gap = 0.0
        best, level = flank.best, levels[(place + 1) % len(order)]
        ratio = float(f"{exp(best.values[4]):.4g}") if best.candidate.code == RATIO_CODE else None
        segments.append(
            StatedSegment(width=round(stop - at, _DIGITS), after=level, law=best.candidate.code, ratio=ratio)
        )
        at = stop
        if gap:
            segments.append(StatedSegment(width=round(start - stop, _DIGITS), after=level))
            at = start
    return StatedMotion(motion=motion, grid=grid, zero=zero, segments=tuple(segments), points=(), rounded=step)


def _first(motion: FoundMotion) -> int:
    """Number of the flank that begins at cam angle 0: behind the longest of the lowest rests."""
    flanks = motion.flanks
    low, travel = motion.base, max(flank.before for flank in flanks) - motion.base
    lengths = [
        ((flank.start - flanks[number - 1].stop) % TURN) if flank.before < low + travel * 1e-3 else -1.0
        for number, flank in enumerate(flanks)
    ]
    return int(np.argmax(lengths))


def _levels(
    motion: FoundMotion, order: list[int], scale: float, steps: tuple[float, ...]
) -> tuple[list[float], float | None]:
    """Heights of the rests before each flank of an order, in the unit of the file, and the step of round ones."""
    heights = np.array([motion.flanks[number].before for number in order])
    sigma = np.array([motion.flanks[number].rise_sigma for number in order])
    groups: list[list[int]] = []
    for place in np.argsort(heights, kind="stable"):
        if groups and heights[place] - heights[groups[-1][0]] < _SAME * float(
            np.hypot(sigma[place], sigma[groups[-1][0]])
        ):
            groups[-1].append(int(place))
        else:
            groups.append([int(place)])
    means: Array = np.array([heights[group].mean() for group in groups])
    means = (means - means[0]) * scale
    spread = np.array([sigma[group].max() for group in groups]) * scale
    rounded = None
    for step in steps:
        off = np.abs(means - np.round(means / step) * step)[1:]
        near = _ROUND * spread[1:]
        if (off <= near).all() and float(np.prod(np.minimum(2 * near / step, 1.0))) < _MOST_CHANCE:
            means, rounded = np.round(means / step) * step, step
            break
    levels = [0.0] * len(order)
    for group, mean in zip(groups, means, strict=True):
        for place in group:
            levels[place] = round(float(mean), 5)
    return levels, rounded
