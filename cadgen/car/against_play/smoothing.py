"""The paper's smoothed profile: peak and valley values brought down around the events (sec. 4.1.2, fig. 14).

The paper shows the lift before and after but gives no rule. Here every peak of a right turn and every valley of a
left turn is compressed. Let u be the way from a knee to the extreme value T_e, as a share. Then

    T -> knee + (T_e - knee) g(u),  g'(u) = 1 - (1 - nu) (3 u^2 - 2 u^3).

So the lift below the knee stays, the joint has a continuous second derivative, the map is monotone, and the events
stay where they are. The knee lies at (1 - depth) T_e, or at the neighbouring event where that is higher; one depth
serves all events. A valley within a right turn, or a peak within a left one, is left alone.

The deflection at an event falls because the car steers less around it; so it leaves the planned path even without
play. That is the method's cost: `Evaluation.deviation` of `cadgen.car.against_play.evaluate`.
"""

from functools import cache
from math import radians

import numpy as np
from scipy.optimize import brentq

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.against_play.compensation import closed_lift, nodes_between
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import falls
from cadgen.car.running.run_errors import deflection_sum, deflections
from cadgen.car.steering import Car
from cadgen.errors import DesignError

PAPER_AIM = 0.2715  # share of the sum of deflection errors that the paper's smoothing takes off
_END_SLOPE = 0.1  # nu, what is left of a slope near the extreme; at 0 it would be level there to fourth order
_STEP = np.pi / 360  # half a degree: the compressed lift is no polynomial, and a quintic this wide errs by 1e-9
_DEPTH_TOLERANCE = 1e-7  # of the depth; the sum then errs by no more
_LEAST_PLAY = radians(0.01)  # without play there is no sum to take a share off
_DEEPEST = 0.999  # at 1 the knee would reach straight ahead, where the contact changes face


def smoothed_lift(lift: PathMotion, depth: float) -> PathMotion:
    """Compress the lift towards its peaks and valleys.

    Args:
        lift: any closed lift.
        depth: share of each extreme value over which it is compressed, in [0, 1); the value itself falls by
            0.45 of that.

    Raises:
        DesignError: the depth is out of range.
    """
    if not 0 <= depth <= _DEEPEST:
        raise DesignError(
            "a smoothing depth of {depth:g} is not between 0 and {deepest:g}: choose one that is",
            depth=depth,
            deepest=_DEEPEST,
        )
    events = falls(lift).ravel()
    if not len(events):
        return lift
    x, jets = nodes_between(lift, events[0], events[0] + TURN, widest=_STEP)
    height = lift.q(events)
    for number, top in enumerate(height):
        sign = 1.0 if number % 2 == 0 else -1.0
        before, after = events[number - 1], events[(number + 1) % len(events)]
        beside = max(sign * height[number - 1], sign * height[(number + 1) % len(height)])
        knee = max((1 - depth) * sign * top, beside)
        if depth > 0 and sign * top > max(knee, 0.0):
            around = (x - before) % TURN <= (after - before) % TURN if len(events) > 2 else np.full(len(x), True)
            jets[around] = sign * _compressed(sign * jets[around], knee, sign * top)
    return closed_lift(x, jets, lift.blend_start)


def smooth_to(
    lift: PathMotion, follower: EdgeFollower, car: Car, length: float, play: float, *, aim: float = PAPER_AIM
) -> PathMotion:
    """Smooth the lift until its sum of deflection errors has fallen by a share `aim`.

    Args:
        lift: lift wanted by motor position.
        follower: follower of the car.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        play: return error B, rad; it hardly matters, since the sum is nearly proportional to it. Below 0.01 degrees
            the depth for that is taken.
        aim: share of the sum to take off, such as the paper's 0.2715.

    Raises:
        DesignError: no depth reaches the aim.
    """
    play = max(play, _LEAST_PLAY)
    plain = deflection_sum(deflections(lift, follower, car, length, play))
    if plain == 0:
        return lift

    @cache
    def short_of_aim(depth: float) -> float:
        smoothed = deflection_sum(deflections(smoothed_lift(lift, depth), follower, car, length, play))
        return 1 - smoothed / plain - aim

    if short_of_aim(_DEEPEST) < 0:
        raise DesignError(
            "smoothing takes at most {most:.1f} % off the deflection errors of this lift, not "
            "{aim:.2f} %: aim lower, or compensate",
            most=100 * (short_of_aim(_DEEPEST) + aim),
            aim=100 * aim,
        )
    return smoothed_lift(lift, float(brentq(short_of_aim, 0.0, _DEEPEST, xtol=_DEPTH_TOLERANCE)))


def _compressed(jets: Array, knee: float, top: float) -> Array:
    """Jets of g(T) for a lift whose extreme value is `top`, upwards."""
    span = top - knee
    u = np.clip((jets[:, 0] - knee) / span, 0.0, None)
    taken = 1 - _END_SLOPE
    g = u - taken * (u**3 - u**4 / 2)
    g1 = 1 - taken * (3 * u**2 - 2 * u**3)
    g2 = -taken * (6 * u - 6 * u**2) / span
    above = u > 0
    value = np.where(above, knee + span * g, jets[:, 0])
    return np.stack([value, g1 * jets[:, 1], g1 * jets[:, 2] + g2 * jets[:, 1] ** 2], axis=1)
