"""Loss by trimming the envelope: lift that no disc can give, and the smallest single change that cures it."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import exp, inf, log

import numpy as np
from scipy.optimize import brentq

from cadgen.arrays import TURN
from cadgen.cam.contact import roll, rolling_step
from cadgen.cam.envelope import actual_profile
from cadgen.cam.follower import Follower, Loss, LossRemedy, Trim
from cadgen.curves.closed import Outline
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion


def lost_lift(motion: Motion, follower: Follower, trims: tuple[Trim, ...], outline: Outline) -> list[Loss]:
    """The greatest lift missing between the two cam angles of each trim, by rolling the follower there.

    A trim that reaches into an idle part of the turn counts in each of the two.

    Args:
        motion: motion wanted.
        follower: follower of any kind.
        trims: places where the envelope was trimmed.
        outline: trimmed envelope in points, mm; a corner is one of them, so the follower rests on it exactly.
    """
    if not trims:
        return []
    stations = []
    for trim in trims:
        width = (trim.after - trim.before) % TURN
        inside = motion.kinks[(motion.kinks - trim.before) % TURN < width]
        stations.append(np.concatenate([trim.before + np.linspace(0.0, 1.0, 65) * width, inside]))
    theta = np.concatenate(stations)
    missing = follower.lift(motion.q(theta)) - roll(outline, follower, theta).lift
    blended = motion.idle(theta)
    losses: list[Loss] = []
    last = 0
    for trim, angles in zip(trims, stations, strict=True):
        first, last = last, last + len(angles)
        own, at, off = blended[first:last], theta[first:last], missing[first:last]
        for driven, mine in ((True, ~own), (False, own)):
            if mine.any():
                worst = int(np.argmax(np.where(mine, off, -inf)))
                losses.append(Loss(trim, float(off[worst]), float(at[worst] % TURN), driven))
    return losses


# The change is found to this share of itself; a shop rounds further than that.
_PRECISION = 0.01
_LARGEST_FACTOR = 64.0  # a change beyond this is no cure
# Share of the limit below which a loss counts as this share: so the logarithm stays finite where nothing is lost.
_NOTHING = 0.01
_ROUNDING = 1e-12  # mm; a limit below it asks for more than arithmetic holds


@dataclass(frozen=True)
class Change:
    """Change of one dimension that makes the loss acceptable.

    Attributes:
        parameter: key of the design file.
        now: value in the design, mm.
        value: value that cures, mm.
    """

    parameter: str
    now: float
    value: float

    @property
    def factor(self) -> float:
        """How many times the parameter changes, >= 1."""
        return max(self.value / self.now, self.now / self.value)


def worst_loss(motion: Motion, follower: Follower) -> float:
    """Greatest lift that the exact envelope for a follower cannot give where its motion counts, mm."""
    try:
        profile = actual_profile(motion, follower)
        if not profile.trims:
            return 0.0
        # The corners that the follower rests on are exact at any step.
        outline = profile.curve.outline(rolling_step(profile.curve, follower))
        losses = lost_lift(motion, follower, profile.trims, outline)
    except DesignError:
        return float("inf")
    return max((loss.lift for loss in losses if loss.driven), default=0.0)


def undercut_cures(
    motion: Motion, follower: Follower, limit: float, without: frozenset[str] = frozenset()
) -> tuple[Change, ...]:
    """Try each remedy of the follower alone, and return what cures, smallest change first.

    The loss falls with the follower's radius and with the base circle: it is r / cos(delta / 2) - r at a corner of
    angle delta, which falls as the base grows. So a root search on the factor finds the smallest change. Every answer
    has been computed, not estimated.

    Args:
        motion: motion wanted.
        follower: follower of any kind.
        limit: lift that may be lost, mm.
        without: keys that are not tried.
    """
    limit = max(limit, _ROUNDING)
    now = worst_loss(motion, follower)
    if now <= limit:  # the envelope loses less: what is lost is the doing of another curve, which no follower mends
        return ()
    cures = []
    for remedy in (each for each in follower.remedies() if each.key not in without):

        def loss(factor: float, remedy: LossRemedy = remedy) -> float:
            return worst_loss(motion, remedy.follower(remedy.value(factor)))

        factor = _smallest_factor(loss, now, limit)
        if factor is not None:
            cures.append(Change(remedy.key, remedy.now, remedy.value(factor)))
    return tuple(sorted(cures, key=lambda cure: cure.factor))


def _smallest_factor(loss: Callable[[float], float], now: float, limit: float) -> float | None:
    """The factor at which the loss meets its limit, rounded to the safe side; None if no factor in reach does.

    Args:
        loss: function of the factor that returns the loss, mm.
        now: loss at the factor 1, mm; more than the limit.
        limit: mm.
    """
    most = log(_LARGEST_FACTOR)

    @cache
    def excess(log_factor: float) -> float:
        # Losses fall as a power of the factor, so this is close to a straight line.
        return log(max(loss(exp(log_factor)) if log_factor else now, _NOTHING * limit) / limit)

    # As if the loss fell with the square of the factor, and further until it is within its limit.
    low, high = 0.0, min(max(excess(0.0) / 2, _PRECISION), most)
    while excess(high) > 0:
        if high == most:
            return None
        low, high = high, min(2 * high, most)
    root = brentq(excess, low, high, xtol=_PRECISION / 2)
    return float(exp(root + _PRECISION / 2))
