"""Loss by trimming the envelope: lift that no disc can give, where the path steers and in the closing blend."""

from dataclasses import dataclass
from math import inf

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.cam.envelope import Trim
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import Outline


@dataclass(frozen=True)
class Loss:
    """Lift that the profile cannot give near a trim.

    Attributes:
        trim: place where the envelope was trimmed.
        lift: lift lost at the worst cam angle, mm.
        cam_angle: worst cam angle, rad.
        driven: whether the path steers there, and not the closing blend.
    """

    trim: Trim
    lift: float
    cam_angle: float
    driven: bool


def lost_lift(lift: LiftCurve, follower: Follower, trims: tuple[Trim, ...], outline: Outline) -> list[Loss]:
    """The greatest lift missing between the two cam angles of each trim, by rolling the follower there.

    A trim that reaches from the path into the closing blend counts in each of the two.

    Args:
        lift: lift wanted, as tan(beta) by cam angle.
        follower: follower of any kind.
        trims: places where the envelope was trimmed.
        outline: trimmed envelope in points, mm; a corner is one of them, so the follower rests on it exactly.
    """
    if not trims:
        return []
    stations = []
    for trim in trims:
        width = (trim.after - trim.before) % TURN
        inside = lift.kinks[(lift.kinks - trim.before) % TURN < width]
        stations.append(np.concatenate([trim.before + np.linspace(0.0, 1.0, 65) * width, inside]))
    theta = np.concatenate(stations)
    missing = follower.lift(lift.tan_beta(theta)) - roll(outline, follower, theta).lift
    blended = lift.in_blend(theta)
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
