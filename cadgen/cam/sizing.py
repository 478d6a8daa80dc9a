"""Sizes of a cam from its motion: least base circles and the best offset for a pressure angle that is allowed.

A follower on a slide, with its line beside the camshaft by e, has tan(alpha) = (s' - e) / (y0 + s). So |alpha| keeps
its limits, one while the follower rises and one while it returns, exactly where y0 is at least the greatest of
|s' - e| / tan(limit) - s over the turn. The prime radius is then sqrt(y0^2 + e^2).
"""

from dataclasses import dataclass
from math import ceil

import numpy as np
from scipy.optimize import minimize_scalar

from cadgen.arrays import TURN
from cadgen.laws.motion import Motion

_STATIONS = 7200  # of a turn, from which the greatest value is closed in on
_ZOOM, _ZOOMS = 33, 4
_OFFSET_WITHIN = 1e-6  # mm


@dataclass(frozen=True)
class SlideSizes:
    """Sizes of a round follower's slide for a motion and limits of the pressure angle.

    Attributes:
        motion: lift by cam angle, mm.
        rise: limit while the follower rises or stands, rad.
        fall: limit while it returns, rad.
    """

    motion: Motion
    rise: float
    fall: float

    def least_ahead(self, offset: float) -> float:
        """Least distance y0 of the centre ahead of the camshaft at lift 0, mm.

        Args:
            offset: offset e of the slide's line, mm.
        """
        theta = np.unique(np.concatenate([np.linspace(0.0, TURN, _STATIONS + 1), self.motion.q.x]))
        greatest = -np.inf
        for _ in range(_ZOOMS):
            lift, slope = self.motion.q(theta % TURN), self.motion.q(theta % TURN, nu=1)
            needed = np.abs(slope - offset) / np.tan(np.where(slope >= 0, self.rise, self.fall)) - lift
            worst = int(np.argmax(needed))
            greatest = max(greatest, float(needed[worst]))
            theta = np.linspace(theta[max(worst - 1, 0)], theta[min(worst + 1, len(theta) - 1)], _ZOOM)
        return greatest

    def least_prime_radius(self, offset: float) -> float:
        """Least distance of the centre from the camshaft at lift 0, mm.

        Args:
            offset: offset e of the slide's line, mm.
        """
        return float(np.hypot(max(self.least_ahead(offset), 0.0), offset))

    def best_offset(self) -> float:
        """Offset with the least prime radius of all, mm; the prime radius is convex in it."""
        slope = self.motion.q(np.linspace(0.0, TURN, _STATIONS) % TURN, nu=1)
        ends = (float(slope.min()), float(slope.max()))
        if ends[0] == ends[1]:
            return 0.0
        found = minimize_scalar(
            self.least_prime_radius, bounds=ends, method="bounded", options={"xatol": _OFFSET_WITHIN}
        )
        return float(found.x)


def rounded_up(length: float) -> float:
    """A length rounded up to 0.01 mm.

    Args:
        length: length, mm.
    """
    return ceil(length * 100) / 100


def least_base_of_face(motion: Motion, tilt: float, convex: float = 0.0) -> float:
    """Least base circle of a flat face on a slide, mm: R_b + (s + s'') cos(tau) is the radius of curvature.

    Args:
        motion: lift by cam angle, mm.
        tilt: angle tau of the face's normal from the slide's axis, rad.
        convex: least radius of curvature allowed, mm.
    """
    pieces = motion.q.x
    # On both sides of each node: the acceleration may jump there.
    inner = np.concatenate([pieces[:-1] + 1e-9, pieces[1:] - 1e-9])
    theta = np.unique(np.concatenate([np.linspace(0.0, TURN, 20 * _STATIONS) % TURN, inner]))
    return float(convex - np.cos(tilt) * (motion.q(theta) + motion.q(theta, nu=2)).min())
