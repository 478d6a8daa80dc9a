"""The profile that takes play out: the dilation of the wanted lift by a window as wide as the return error.

With play B the cam leads by B wherever the lift falls (see `cadgen.car.motion.play`). So a cam whose rises are those of
the wanted lift and whose falls are the wanted ones turned ahead by B,
    s_c(theta) = max of s over [theta - B, theta],
gives the wanted lift back, but for a sliver of height about s'' B^2 / 8 in each valley, where the cam must stand
still for B whatever its shape (the morphological closing of s). The dilation has two places that a spring and a
cutter cannot take as they are:

- At each peak p it is level from p to p + B, and nothing would pull the cam across: the rod would stay on the
  gears' side and drop B late. Here this plateau falls, by a little more than cutting errs, and joins both flanks
  with continuous curvature.
- In each valley its two flanks cross in a hollow kink. Here a quintic joins them over a stated angle; with an angle
  of 0 the kink stays and the rod's own section rounds the profile there.
"""

from dataclasses import dataclass
from math import degrees

import numpy as np
from scipy.optimize import brentq

from cadgen.arrays import TURN, Array
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.motion.play import falls
from cadgen.car.optimize.dilation import rounded_dilation
from cadgen.car.optimize.nodes import KINK, SIDE, closed_lift, nodes_between
from cadgen.car.path_motion import PathMotion
from cadgen.errors import DesignError

# Fall of the plateau in lift, mm: above what a good mill errs over a degree of cam angle. What it costs in heading
# has the opposite sign to what the valleys cost.
PLATEAU_FALL = 0.005
# Half the angle of the valley's quintic over the play. It costs about as much heading as the sliver itself.
VALLEY_SHARE = 0.25
_ROOT = 1e-15  # rad; roots are found to rounding
# No plateau takes more than this share of the fall that follows it.
_GREATEST_SHARE = 1 / 16
# A plateau after a peak that is nearly level itself falls less steeply; below this slope of tan(beta) it would be level
# (`PathMotion.level`) and hold the cam.
_LEAST_TILT = 1e-4
# A rise of tan(beta) of less than this, 0.2 um of lift, must be level for so wide an angle to end a fall.
_LEAST_RISE = 1e-5
_LEAST_LEVEL = np.radians(0.6)


@dataclass(frozen=True)
class _Valley:
    """Course of the profile from a peak over its plateau, down the shifted fall and up again.

    Attributes:
        plateau: nodes and jets of the plateau.
        joined: cam angle from which on the profile is the shifted fall, rad.
        crossing: cam angle at which the shifted fall meets the rise, rad.
        next_peak: cam angle of the next peak, rad.
    """

    plateau: tuple[Array, Array]
    joined: float
    crossing: float
    next_peak: float


def compensated_lift(
    lift: PathMotion,
    follower: LeaningRod,
    play: float,
    *,
    plateau_fall: float = PLATEAU_FALL,
    valley_blend: float | None = None,
) -> PathMotion:
    """Lift of the cam that gives `lift` back when its train has the return error `play`.

    Where events are too close together for a plateau and a blend each, the whole lift is dilated on samples
    (`rounded_dilation`); dips narrower than the play are lost there, since no cam gives them back (`lost_dips`). The
    closing blend is treated like the rest of the turn, so the result closes as smoothly as `lift` does.

    Args:
        lift: lift wanted by motor position.
        follower: follower, for the plateau's fall in lift.
        play: return error B that the cam is made for, rad; 0 gives `lift` itself, and so does a lift that never falls.
        plateau_fall: fall of the lift over each plateau, mm.
        valley_blend: half the angle over which a quintic rounds each valley, rad; a quarter of the play if left
            out, and 0 leaves a hollow kink where there is room for one.

    Returns:
        A lift by cam angle. Its blend_start is that of `lift`: the motor position up to which it serves the path.

    Raises:
        DesignError: the play is negative or no number, or plateau or blend are out of range.
    """
    if not play >= 0:
        raise DesignError(f"the return error is {degrees(play):g} degrees; it must be 0 or more")
    blend = VALLEY_SHARE * play if valley_blend is None else valley_blend
    if not (plateau_fall > 0 and blend >= 0):
        raise DesignError(
            f"a plateau's fall of {plateau_fall:g} mm with a valley blend of {degrees(blend):g} degrees makes no "
            f"profile: the fall must be above 0 and the blend 0 or more"
        )
    pairs = falls(lift)
    if play == 0 or not len(pairs):
        return lift
    cycles = []
    for number in range(len(pairs)):
        valley = _valley(lift, follower, play, pairs, number, plateau_fall, blend)
        if valley is None:
            return rounded_dilation(lift, play, fall=plateau_fall / follower.outer, half_width=VALLEY_SHARE * play)
        cycles += [
            valley.plateau,
            nodes_between(lift, valley.joined - play, valley.crossing - blend - play, ahead=play),
            nodes_between(lift, valley.crossing + blend, valley.next_peak),
        ]
    x, jets = (np.concatenate(part) for part in zip(*cycles, strict=True))
    return closed_lift(x, jets, lift.blend_start)


def _valley(
    lift: PathMotion, follower: LeaningRod, play: float, pairs: Array, number: int, fall: float, blend: float
) -> _Valley | None:
    """The profile around a valley, from the peak before it to the one after it; None if there is no room."""
    peak, valley = (float(angle) for angle in pairs[number])
    wrapped = number + 1 == len(pairs)
    next_peak = float(pairs[0, 0]) + TURN if wrapped else float(pairs[number + 1, 0])
    crossing = _crossing(lift, play, peak, valley, next_peak)
    if crossing is None:
        return None
    joined, plateau, tilted = _plateau(lift, follower, play, peak, valley, fall)
    risen = float(lift.q(next_peak) - lift.q(crossing + blend))
    ends_fall = risen >= _LEAST_RISE or next_peak - crossing - blend >= _LEAST_LEVEL
    if tilted and joined < crossing - blend and crossing + blend < next_peak and ends_fall:
        return _Valley(plateau, joined, crossing, next_peak)
    return None


def _crossing(lift: PathMotion, play: float, peak: float, valley: float, next_peak: float) -> float | None:
    """Cam angle at which the fall turned ahead by the play meets the rise; None if it meets none before a peak."""
    first, last = max(valley, peak + play), min(valley + play, next_peak)

    def above(angle: float) -> float:
        return float(lift.q(angle) - lift.q(angle - play))

    if first >= last or above(first) >= 0 or above(last) < 0:
        return None
    return float(brentq(above, first, last, xtol=_ROOT))


def _plateau(
    lift: PathMotion, follower: LeaningRod, play: float, peak: float, valley: float, fall: float
) -> tuple[float, tuple[Array, Array], bool]:
    """Cam angle at which the shifted fall takes over, nodes of the plateau, and whether it falls enough.

    From a smooth peak with second derivative -k the slope eases to -m as a parabola over 2 m / k, so it never
    turns up. The line then runs to p + B. With tau where the wanted fall has come down as far, a quintic over
    2 tau joins the shifted fall; there too the slope keeps its sign, and the curvature exceeds k by two thirds or so.
    """
    top, bottom = float(lift.q(peak)), float(lift.q(valley))
    slope, bend = (float(lift.q(peak + SIDE, nu=order)) for order in (1, 2))
    drop = min(fall / float(follower.contact_face(np.array(top))), _GREATEST_SHARE * (top - bottom))
    steepness = drop / play
    ease = 0.0
    if slope > -KINK and bend < 0:
        steepness = min(steepness, -bend * play / 4)
        ease = -2 * steepness / bend
    edge = top - steepness * (play - ease / 3)
    tau = float(brentq(lambda t: float(lift.q(peak + t)) - edge, 0.0, valley - peak, xtol=_ROOT))
    x = np.array([peak, peak + ease, peak + play])
    jets = np.array(
        [
            [top, 0.0 if ease else -steepness, bend if ease else 0.0],
            [top - 2 / 3 * steepness * ease, -steepness, 0.0],
            [edge, -steepness, 0.0],
        ]
    )
    return peak + play + 2 * tau, (x, jets), steepness > _LEAST_TILT
