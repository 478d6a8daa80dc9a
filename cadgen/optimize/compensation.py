"""The profile that takes play out: the dilation of the wanted lift by a window as wide as the return error.

With play B the cam leads by B wherever the lift falls (see `cadgen.motion.play`). So a cam whose rises are those of
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

from math import degrees

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.errors import DesignError
from cadgen.motion.play import TURN, falls, follow, refuse_wide_play
from cadgen.optimize.nodes import KINK, SIDE, closed_lift, nodes_between

Array = NDArray[np.float64]

# Fall of the plateau in lift, mm: above what a good mill errs over a degree of cam angle. What it costs in heading
# has the opposite sign to what the valleys cost.
PLATEAU_FALL = 0.005
# Half the angle of the valley's quintic over the play. It costs about as much heading as the sliver itself.
VALLEY_SHARE = 0.25
_ROOT = 1e-15  # rad; roots are found to rounding
# No plateau takes more than this share of the fall that follows it.
_GREATEST_SHARE = 1 / 16


def compensated_lift(
    lift: LiftCurve,
    follower: Follower,
    play: float,
    *,
    plateau_fall: float = PLATEAU_FALL,
    valley_blend: float | None = None,
) -> LiftCurve:
    """Lift of the cam that gives `lift` back when its train has the return error `play`.

    The closing blend is treated like the rest of the turn, so the result closes as smoothly as `lift` does.

    Args:
        lift: the lift wanted, by motor position.
        follower: for the plateau's fall in lift.
        play: B that the cam is made for, rad; 0 gives `lift` itself.
        plateau_fall: how far the lift falls over each plateau, mm.
        valley_blend: half the angle over which a quintic rounds each valley, rad; a quarter of the play if left
            out, and 0 leaves a hollow kink.

    Returns:
        A lift by cam angle. Its blend_start is that of `lift`: the motor position up to which it serves the path.

    Raises:
        DesignError: the lift has no events, the play is not less than the distance between two of them, a fall or
            rise is too short to hold its plateau or blend, or these are out of range.
    """
    following = follow(lift, play)  # refuses a play that does not fit
    if not len(following.falls):
        raise DesignError(
            "the lift has no peak and no valley, so there is no play to compensate: use the actual profile"
        )
    if play == 0:
        return lift
    blend = VALLEY_SHARE * play if valley_blend is None else valley_blend
    if not (plateau_fall > 0 and blend >= 0):
        raise DesignError(
            f"a plateau's fall of {plateau_fall:g} mm with a valley blend of {degrees(blend):g} degrees makes no "
            f"profile: the fall must be above 0 and the blend 0 or more"
        )
    refuse_wide_play(lift, play, following.falls, whole_turn=True)
    cycles = []
    for number, (peak, valley) in enumerate(following.falls):
        crossing = _crossing(lift, play, valley)
        wrapped = number + 1 == len(following.falls)
        next_peak = following.falls[0, 0] + TURN if wrapped else following.falls[number + 1, 0]
        joined, plateau = _plateau(lift, follower, play, peak, valley, plateau_fall)
        if joined >= crossing - blend or crossing + blend >= next_peak:
            raise DesignError(
                f"around the valley at {degrees(valley) % 360:.1f} degrees of cam angle there is no room for a "
                f"return error of {degrees(play):.3f} degrees with a blend of {degrees(2 * blend):.3f} degrees: "
                f"take a train with less backlash or a smaller blend"
            )
        cycles += [
            plateau,
            nodes_between(lift, joined - play, crossing - blend - play, ahead=play),
            nodes_between(lift, crossing + blend, next_peak),
        ]
    x, jets = (np.concatenate(part) for part in zip(*cycles, strict=True))
    result = closed_lift(x, jets, lift.blend_start)
    if len(falls(result)) != len(following.falls):
        raise DesignError(
            f"compensating a return error of {degrees(play):.3f} degrees gives the lift {len(falls(result))} falls "
            f"where the path has {len(following.falls)}: lower the plateau's fall or the valley's blend"
        )
    return result


def _crossing(lift: LiftCurve, play: float, valley: float) -> float:
    """Cam angle at which the fall turned ahead by the play meets the rise."""

    def above(angle: float) -> float:
        return float(lift.tan_beta(angle) - lift.tan_beta(angle - play))

    return float(brentq(above, valley, valley + play, xtol=_ROOT))


def _plateau(
    lift: LiftCurve, follower: Follower, play: float, peak: float, valley: float, fall: float
) -> tuple[float, tuple[Array, Array]]:
    """Nodes from the peak over the plateau, and the cam angle at which the shifted fall takes over.

    From a smooth peak with second derivative -k the slope eases to -m as a parabola over 2 m / k, so it never
    turns up. The line then runs to p + B. With tau where the wanted fall has come down as far, a quintic over
    2 tau joins the shifted fall; there too the slope keeps its sign, and the curvature exceeds k by two thirds or so.
    """
    top, bottom = float(lift.tan_beta(peak)), float(lift.tan_beta(valley))
    slope, bend = (float(lift.tan_beta(peak + SIDE, nu=order)) for order in (1, 2))
    drop = min(fall / float(follower.contact_face(np.array(top))), _GREATEST_SHARE * (top - bottom))
    steepness = drop / play
    ease = 0.0
    if slope > -KINK and bend < 0:
        steepness = min(steepness, -bend * play / 4)
        ease = -2 * steepness / bend
    edge = top - steepness * (play - ease / 3)
    tau = float(brentq(lambda t: float(lift.tan_beta(peak + t)) - edge, 0.0, valley - peak, xtol=_ROOT))
    x = np.array([peak, peak + ease, peak + play])
    jets = np.array(
        [
            [top, 0.0 if ease else -steepness, bend if ease else 0.0],
            [top - 2 / 3 * steepness * ease, -steepness, 0.0],
            [edge, -steepness, 0.0],
        ]
    )
    return peak + play + 2 * tau, (x, jets)
