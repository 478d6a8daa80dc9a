"""A camshaft ahead of or behind its gears by the same at each turn, as a disc that a follower cannot tell from it.

Where the gears ask for theta, the shaft stands at psi = theta + delta(theta), by run-out of the gears and wind-up. The
follower then rests on the points that a true shaft brings under it at psi. A disc whose points are turned back by
delta, each where the follower rests on it, gives the same lift at theta, to first order in the slope of delta.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.followers.rod import LeaningRod
from cadgen.deviations.disc import Disc
from cadgen.deviations.effect import Effect
from cadgen.deviations.transmission import Turned
from cadgen.errors import DesignError

# Radians of lead per radian of the cam beyond which first order is not good enough: what is left is this share of it.
STEEPEST = 0.1
_GRID = np.linspace(0.0, TURN, 3600, endpoint=False)
_STEPS = 4  # to the angle that the gears ask for; each leaves a tenth of the error at most


def led(
    disc: Disc, effects: Sequence[tuple[Effect, tuple[float, ...]]], ahead: float, rod: LeaningRod, asking: Disc
) -> Disc:
    """The disc that gives on a true shaft the lift that a disc gives on a shaft that leads.

    Args:
        disc: as finished, on the shaft that leads.
        effects: of the train on the camshaft's angle, with their values, rad.
        ahead: angle by which the disc stands ahead on its shaft, rad.
        rod: that follows, as designed.
        asking: disc whose lift on a true shaft sets the torque that winds the train up.

    Raises:
        DesignError: the lead changes too fast for this.
    """
    contact = _contact(disc, rod)[0] - ahead
    slope = _slope(asking, ahead, rod)

    def lead(angle: Array) -> Array:
        turned = np.append(angle, 0.0)
        leading, at = turned, Turned(turned=turned, torque=np.interp(turned, _GRID, slope, period=TURN))
        for effect, values in effects:
            leading = effect.act(leading, np.array(values), at)
        off = leading - turned
        return np.asarray(off[:-1] - off[-1], dtype=float)

    off = lead(contact)
    steepest = np.abs(np.diff(lead(_GRID))).sum() / TURN
    if steepest > STEEPEST:
        raise DesignError(
            f"as built the camshaft gains and loses {np.degrees(steepest * TURN):.1f} degrees on its gears in a turn, "
            f"and a cam takes out {np.degrees(STEEPEST * TURN):.0f} at most: mend the train, or set place to noted"
        )
    for _ in range(_STEPS):
        off = lead(contact - off)
    c, s = np.cos(off), np.sin(off)
    x, y = disc.points.T
    return replace(disc, points=np.stack([c * x + s * y, c * y - s * x], axis=1))


def _contact(disc: Disc, rod: LeaningRod) -> tuple[Array, Array]:
    """Cam angles at which the rod rests on a disc's points, rad, and distances of its middle there, mm."""
    x, y = (disc.points + rod.radius * disc.normal).T
    return np.arctan2(y, x), np.hypot(x, y)


def _slope(disc: Disc, ahead: float, rod: LeaningRod) -> Array:
    """Slope of tan(beta) on the grid, over its greatest: the torque of the shaft as `transmission.Turned` has it."""
    contact, reach = _contact(disc, rod)
    place = (contact - ahead) % TURN
    order = np.argsort(place)
    lift = np.interp(_GRID, place[order], reach[order], period=TURN) - rod.base_radius
    tangent = lift / rod.contact_face(lift)
    slope = np.roll(tangent, -1) - np.roll(tangent, 1)
    return np.asarray(slope / np.abs(slope).max(), dtype=float)
