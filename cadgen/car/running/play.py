"""The play operator: where the cam stands when gears with play turn it and a spring presses the rod on it.

The gears leave the cam free between motor position phi (in cam units) and phi + B, B the return error. The rod
turns it ahead wherever its torque is above friction and drag, as far as that window allows, inertia left aside. Let
it do so for cam angles from p to v, on a fall of the lift:

- before and behind, the gears push: theta = phi;
- at p the cam **jumps** ahead and then leads: theta = phi + B;
- at v it **waits**, theta = v, until the gears have taken up the play at phi = v.

So theta(phi) = min(phi + B, v) for p <= phi < v, and theta = phi elsewhere: exact for any lift and any B, also where
events are closer together than B, for the cam never climbs. Without friction and drag p is a peak, or the end of a
level stretch, and v a valley, or the start of one (`falls`); with them the cam leads on the steeper part of the
fall alone (`cadgen.car.running.mechanics`).

The least lift within the window, its erosion, is not quite this: it would have the cam cross a peak as soon as the
far side is lower, at phi_1 < p where s(phi_1) = s(phi_1 + B). The two agree outside [phi_1, p] as long as every
rise is longer than B, and the erosion's heading error is greater by about |kappa''| B^3 / 8 at each peak.
"""

from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from math import degrees

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.path_motion import PathMotion
from cadgen.errors import DesignError

# Rises and falls of tan(beta) below this are noise, not events: 0.01 um of lift, what rolling an outline errs by.
LEAST_SWING = 4e-7
_ROUNDING = 1e-15  # of tan(beta): a stretch that falls by less is level


def falls(lift: PathMotion, least_swing: float = LEAST_SWING) -> Array:
    """Falls of the lift: cam angles of the peak that begins and of the valley that ends each fall.

    A fall begins where a level stretch at its peak ends, for nothing pulls the cam off that; it ends where one in
    its valley begins; and a level stretch within it ends one fall and begins another. Level is what `lift.level` says
    and, shorter, what is level to rounding beside a rise.

    Args:
        lift: any closed lift.
        least_swing: rises and falls of tan(beta) smaller than this are passed over.

    Returns:
        Shape (k, 2), rad, in order; starts lie in [0, 2 pi), the last stop may lie beyond 2 pi. Empty if the lift
        is level.
    """
    # Found once for each lift: its runs with many plays and frictions ask again and again.
    known = lift.derived
    if (_falls, least_swing) not in known:
        known[_falls, least_swing] = _falls(lift, least_swing)
    return known[_falls, least_swing].copy()


def _falls(lift: PathMotion, least_swing: float) -> Array:
    nodes, value = lift.stations
    falling = np.diff(value) < -_ROUNDING
    begins = np.flatnonzero(falling & ~np.roll(falling, 1))
    ends = np.flatnonzero(falling & ~np.roll(falling, -1)) + 1
    if begins.size and ends[0] <= begins[0]:
        ends = np.roll(ends, -1)
    # Turning points in turn, peak first: even places are peaks, and swing j leads from point j to the next.
    angle = np.stack([nodes[begins], nodes[ends]], axis=1).ravel()
    height = np.stack([value[begins], value[ends]], axis=1).ravel()
    kept = _without_small_swings(height, least_swing)
    angle = angle[kept]
    pairs = angle.reshape(-1, 2) % TURN
    pairs[:, 1] = pairs[:, 0] + (pairs[:, 1] - pairs[:, 0]) % TURN
    pairs = _without_level(pairs, lift.level)
    pairs -= TURN * np.floor(pairs[:, :1] / TURN)
    return pairs[np.argsort(pairs[:, 0])]


def _without_small_swings(height: Array, least_swing: float) -> NDArray[np.intp]:
    """Turning points that stay when the smallest swing is passed over until none is below `least_swing`.

    With a swing both its points go, and their neighbours become one another's; so each round costs the logarithm of
    their number, and not the number, of which a rough path has thousands.

    Args:
        height: tan(beta) at the turning points round the turn, peak first, shape (2 k,).
        least_swing: least swing of tan(beta) that stays.

    Returns:
        Indices of those that stay, from a peak on.
    """
    count = len(height)
    if not count or np.abs(np.roll(height, -1) - height).min() >= least_swing:
        return np.arange(count)
    heights = height.tolist()
    before, after = [place - 1 for place in range(count)], [*range(1, count), 0]
    before[0], first, left = count - 1, 0, count
    place = list(range(count))  # in the row that begins with a peak; among equal swings the first goes
    stays = [True] * count
    swings = [(abs(heights[after[at]] - heights[at]), place[at], at, after[at]) for at in range(count)]
    heapify(swings)
    while left:
        swing, rank, low, high = heappop(swings)
        if not (stays[low] and after[low] == high and rank == place[low]):
            continue  # of before one of its points went
        if swing >= least_swing:
            break
        stays[low] = stays[high] = False
        left -= 2
        if not left:
            break
        outer, further = before[low], after[high]
        after[outer], before[further] = further, outer
        if high == first:  # the last valley and the first peak went together: the last peak now comes first
            place[outer] = place[first] - 1
            first = outer
        elif low == first:
            first = further
        heappush(swings, (abs(heights[further] - heights[outer]), place[outer], outer, further))
    row = [first]
    for _ in range(left - 1):
        row.append(after[row[-1]])
    return np.array(row[:left], dtype=np.intp)


def _without_level(pairs: Array, level: Array) -> Array:
    """Falls less their level stretches; both of shape (n, 2), rad."""
    for begin, end in level:
        # The stretch as it lies from each peak on, perhaps begun before it.
        ahead = (begin - pairs[:, 0]) % TURN
        long = pairs[:, 1] - pairs[:, 0]
        meets = (ahead < long) | (ahead + (end - begin) - TURN > 0)
        left = [pairs[~meets]]
        for peak, valley in pairs[meets].tolist():
            start = peak + (begin - peak) % TURN
            spans = [(start, start + end - begin), (start - TURN, start - TURN + end - begin)]
            parts = [(peak, valley)]
            for a, b in spans:
                parts = [
                    part
                    for p, v in parts
                    for part in ([(p, v)] if b <= p or a >= v else [(p, min(a, v)), (max(b, p), v)])
                    if part[1] > part[0]
                ]
            left.append(np.array(parts).reshape(-1, 2))
        pairs = np.concatenate(left)
    return pairs


@dataclass(frozen=True)
class Following:
    """Motion of a cam that follows the motor with play.

    Attributes:
        lift: lift of the cam.
        play: return error B, rad.
        leads: cam angles between which the cam leads, as `falls` gives them, shape (k, 2), rad.
        shaft: motion of the shaft, if the cam has its play on a shaft that itself follows the motor.
    """

    lift: PathMotion
    play: float
    leads: Array
    shaft: "Following | None" = None

    def cam_angle(self, motor: Array) -> Array:
        """Cam angle theta at motor positions, rad, any shape; at the instant of a jump, the angle after it.

        Args:
            motor: motor positions, rad.
        """
        motor = np.asarray(motor, dtype=float)
        if self.shaft is not None:
            motor = self.shaft.cam_angle(motor)
        if not len(self.leads):
            return motor + 0.0
        base = motor % TURN
        number = np.searchsorted(self.leads[:, 0], base, side="right") - 1
        valley = self.leads[number, 1] - np.where(number < 0, TURN, 0.0)
        ahead = np.minimum(base + self.play, valley) - base
        return motor + np.where(base < valley, ahead, 0.0)

    def tan_beta(self, motor: Array) -> Array:
        """Tangent of the steering angle at motor positions (rad).

        Args:
            motor: motor positions, rad.
        """
        return self.lift.q(self.cam_angle(motor))

    def joints(self, start: float, stop: float) -> Array:
        """Motor positions between `start` and `stop` at which the cam jumps, stops, goes on or meets a kink, rad.

        Args:
            start: motor position, rad.
            stop: a greater one, rad.
        """
        peak, valley = self.leads.reshape(-1, 2).T
        arrive = np.maximum(peak, valley - self.play)
        places = np.concatenate([peak, arrive, valley, self.lift.kinks, self.lift.kinks - self.play])
        if self.shaft is not None:
            places = np.concatenate([places, places - self.shaft.play, self.shaft.joints(0.0, TURN)])
        turns = TURN * np.arange(np.floor(start / TURN) - 1, np.ceil(stop / TURN) + 1)
        places = np.unique(places + turns[:, None])
        return places[(places > start) & (places < stop)]


def follow(
    lift: PathMotion,
    play: float,
    *,
    least_swing: float = LEAST_SWING,
    leads: Array | None = None,
    shaft: Following | None = None,
) -> Following:
    """Let a cam follow gears with a return error.

    At a peak the cam jumps ahead by it (eq. 27), and in a valley it waits until the gears have caught up (eq. 29).

    Args:
        lift: lift of the cam.
        play: return error B, rad.
        least_swing: rises and falls of tan(beta) smaller than this are noise; for a meshed or measured outline, its
            tolerance over the faces' distance.
        leads: where the cam leads, shape (k, 2), rad, starts in [0, 2 pi) and in order; on every fall if left out.
        shaft: motion of the shaft on which the cam has this play; that of the motor if left out.

    Raises:
        DesignError: the play is negative or no number.
    """
    if not play >= 0:
        raise DesignError("the return error is {play:g} degrees; it must be 0 or more", play=degrees(play))
    return Following(lift, play, falls(lift, least_swing) if leads is None else leads, shaft)
