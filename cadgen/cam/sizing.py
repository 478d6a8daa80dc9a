"""Sizes of a cam from its motion: least base circles and the best offset for a pressure angle that is allowed.

A follower on a slide, with its line beside the camshaft by e, has tan(alpha) = (s' - e) / (y0 + s). So |alpha| keeps
its limits, one while the follower rises and one while it returns, exactly where y0 is at least the greatest of
|s' - e| / tan(limit) - s over the turn. The prime radius is then sqrt(y0^2 + e^2).

A follower on an arm has the angle delta = delta_0 + q at its pivot. A limit A of the pressure angle holds over a range
of delta at each cam angle. So delta_0, which the base circle sets, has the range that is common to all of them:

- a roller with l (1 + g q') cos(A) / c = cos(K): delta from |K - A| to the least of A + K and 2 pi - A - K;
- a flat face with p = 1 + g q': cos(delta) of |f| p / (c tan(A)) or more. Its radius of curvature is
  c M sin(delta + phi) - f with M cos(phi) = 1 - (q'/p)^2 and M sin(phi) = q''/p^3. So it is at least rho for delta
  from B - phi to pi - B - phi, with sin(B) = (f + rho) / (c M).
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil

import numpy as np
from scipy.optimize import minimize_scalar

from cadgen.arrays import TURN, Array
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


@dataclass(frozen=True)
class ArmSizes:
    """Angles at rest of a follower on an arm for a motion and limits of the pressure angle.

    Attributes:
        motion: swing by cam angle, rad.
        distance: distance c of the pivot from the camshaft, mm.
        side: 1 for an arm that lifts against the sense of the cam, -1 for one that lifts with it.
        rise: limit while the follower rises or stands, rad.
        fall: limit while it returns, rad.
    """

    motion: Motion
    distance: float
    side: int
    rise: float
    fall: float

    def of_roller(self, arm: float) -> tuple[float, float]:
        """Least and greatest angle at rest with which a roller keeps the limits, rad; the first is more if none does.

        Args:
            arm: length l of the arm, mm.
        """

        def ends(jets: Array) -> tuple[Array, Array]:
            limit = self._limit(jets)
            cosine = arm * (1 + self.side * jets[:, 1]) * np.cos(limit) / self.distance
            opening = np.arccos(np.clip(cosine, -1.0, 1.0))
            low = np.where(cosine > 1, np.inf, np.abs(opening - limit))
            return low, np.minimum(limit + opening, TURN - limit - opening)

        return self._common(ends)

    def of_face(self, face_offset: float, convex: float) -> tuple[float, float]:
        """Least and greatest angle at rest with which a face keeps the limits and is nowhere sharper than allowed, rad.

        Args:
            face_offset: distance f of the face from the pivot, mm.
            convex: least radius of curvature allowed, mm.
        """

        def ends(jets: Array) -> tuple[Array, Array]:
            pace = 1 + self.side * jets[:, 1]
            cosine = abs(face_offset) * pace / (self.distance * np.tan(self._limit(jets)))
            lever = (1 - (jets[:, 1] / pace) ** 2) + 1j * jets[:, 2] / pace**3
            with np.errstate(divide="ignore"):
                sine = (face_offset + convex) / (self.distance * np.abs(lever))
            bend = np.arcsin(np.clip(sine, -1.0, 1.0))
            # Below -1 no angle is too sharp, beyond 1 every one is; the contact must stay short of the square position.
            low = np.where(sine > 1, np.inf, np.where(sine < -1, 0.0, bend - np.angle(lever)))
            high = np.where(sine < -1, np.pi / 2, np.pi - bend - np.angle(lever))
            return np.maximum(low, 0.0), np.minimum(high, np.arccos(np.clip(cosine, 0.0, 1.0)))

        return self._common(ends)

    def _limit(self, jets: Array) -> Array:
        return np.where(jets[:, 1] >= 0, self.rise, self.fall)

    def _common(self, ends: Callable[[Array], tuple[Array, Array]]) -> tuple[float, float]:
        """Range of the angle at rest that is common to all cam angles, rad."""
        low = self.motion.extremes_of(lambda jets, theta: np.minimum(ends(jets)[0], TURN) - jets[:, 0])[0]
        high = self.motion.extremes_of(lambda jets, theta: ends(jets)[1] - jets[:, 0])[1]
        return low.value, high.value


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
