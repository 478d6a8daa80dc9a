"""A lift curve through samples, so that a rolled or measured outline can be driven like a planned one."""

import numpy as np
from scipy.interpolate import PchipInterpolator, PPoly

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Contact
from cadgen.car.path_motion import PathMotion
from cadgen.errors import DesignError

MIN_SAMPLES = 16  # fewer cannot show the events of a path
_INSIDE = 1e-12  # rad; keeps rounding from picking the piece before
_OVERLAP = 4  # samples repeated at either end, so that slopes at the seam see both sides


def sampled_lift(cam_angle: Array, tan_beta: Array, *, blend_start: float, level: Array | None = None) -> PathMotion:
    """Interpolate steering known at cam angles round the turn.

    The interpolant is monotone between samples (Fritsch & Carlson 1980), so it has no event that the samples do
    not have; peaks and valleys stand on samples, and its error there falls with the square of the step.

    Args:
        cam_angle: cam angles, increasing, within less than one turn, shape (n,), rad.
        tan_beta: tangent of the steering angle there, shape (n,).
        blend_start: cam angle from which the path no longer steers, rad.
        level: cam angles between which the lift is known to be level, shape (m, 2), rad; from the samples if left out.

    Raises:
        DesignError: too few samples, not increasing, over more than a turn, or not finite.
    """
    cam_angle, tan_beta = np.asarray(cam_angle, dtype=float), np.asarray(tan_beta, dtype=float)
    if cam_angle.size < MIN_SAMPLES or cam_angle.shape != tan_beta.shape:
        raise DesignError(
            "{angles} cam angles with {values} steering values make no lift: give at least {least} of each",
            angles=cam_angle.size,
            values=tan_beta.size,
            least=MIN_SAMPLES,
        )
    if not (np.isfinite(tan_beta).all() and np.isfinite(cam_angle).all()):
        raise DesignError("the sampled steering holds a value that is not a number: remove or measure it again")
    if not (np.diff(cam_angle) > 0).all() or cam_angle[-1] - cam_angle[0] >= TURN:
        raise DesignError("the sampled cam angles must increase and stay within one turn: sort them, drop repeats")
    head, tail = slice(None, _OVERLAP), slice(-_OVERLAP, None)
    angle = np.concatenate([cam_angle[tail] - TURN, cam_angle, cam_angle[head] + TURN])
    value = np.concatenate([tan_beta[tail], tan_beta, tan_beta[head]])
    curve = PchipInterpolator(angle, value)
    # Cut to one turn from 0; a cubic is fixed by its Taylor expansion at the left end of each piece.
    start = cam_angle[0]
    breaks = np.unique(np.concatenate([[0.0], (angle[_OVERLAP:-_OVERLAP]) % TURN, [TURN]]))
    if start == 0:
        taylor = curve.c[:, _OVERLAP : _OVERLAP + len(breaks) - 1]
    else:
        at = start + (breaks[:-1] - start) % TURN + _INSIDE
        factorials = np.array([6.0, 2.0, 1.0, 1.0])
        taylor = np.stack([curve(at, nu=order) for order in (3, 2, 1, 0)]) / factorials[:, None]
    return PathMotion(
        q=PPoly(taylor, breaks, extrapolate="periodic"),
        kinks=np.array([]),
        blend_start=blend_start,
        known_level=level,
    )


def rolled_lift(contact: Contact, wanted: PathMotion, *, blend_start: float) -> PathMotion:
    """Lift that a disc really gives, from the follower rolled on its outline.

    Args:
        contact: contact of the follower with the outline, at increasing cam angles of one turn.
        wanted: lift that the outline was made for; where it is level, what rolling or facets leave is noise.
        blend_start: cam angle from which the path no longer steers, rad.

    Raises:
        DesignError: as `sampled_lift`.
    """
    return sampled_lift(contact.cam_angle, contact.q, blend_start=blend_start, level=wanted.level)
