"""Loss by trimming the envelope: lift that no disc can give, where the motion counts and where it does not."""

from math import inf

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.cam.follower import Follower, Loss, Trim
from cadgen.curves.closed import Outline
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
