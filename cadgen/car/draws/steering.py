"""Steering that one disc gives at any place on its shaft and with any base radius.

The rod is rolled on the disc at Chebyshev places of both; between them the lift, which hardly changes, is interpolated
by polynomials (Trefethen, Approximation Theory and Approximation Practice, ch. 5).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.draws.knobs import Knob

_DISC_PLACES, _HEAD_PLACES = 6, 3

# Follower -> tan(beta) at the stations, shape (n,).
Rolling = Callable[[LeaningRod], Array]


def moved_rod(rod: LeaningRod, disc: float, head: float) -> LeaningRod:
    """The rod on a disc that was moved on its shaft, with another base radius.

    Args:
        rod: rod as designed.
        disc: disc moved away from the fork axis, mm.
        head: growth of the base radius, mm.
    """
    return replace(rod, inner=rod.inner + disc, outer=rod.outer + disc, base_radius=rod.base_radius + head)


@dataclass(frozen=True, eq=False)
class Steering:
    """Steering of a disc by its place and by the head.

    Attributes:
        rod: rod as designed.
        discs: places of the disc at which the rod was rolled, shape (k,), mm.
        heads: settings of the head at which it was, shape (l,), mm.
        lifts: tan(beta) times the distance of the inner plane, shape (k, l, n), mm.
    """

    rod: LeaningRod
    discs: Array
    heads: Array
    lifts: Array

    @classmethod
    def of(cls, rod: LeaningRod, disc: Knob, head: Knob, rolling: Rolling) -> "Steering":
        """Roll the rod at the places between which it is interpolated.

        Args:
            rod: rod as designed.
            disc, head: ranges.
            rolling: function that rolls a rod on the disc.

        Raises:
            DesignError: the rod cannot be rolled on the disc at some place.
        """
        discs, heads = _places(disc, _DISC_PLACES), _places(head, _HEAD_PLACES)
        lifts = [[rolling(moved_rod(rod, d, h)) * (rod.inner + d) for h in heads.tolist()] for d in discs.tolist()]
        return cls(rod, discs, heads, np.array(lifts))

    def tan_beta(self, disc: float, head: float) -> Array:
        """Tangent of the steering angle at the stations, shape (n,).

        Args:
            disc: disc moved away from the fork axis, mm.
            head: displacement of the rod by the micrometer head, mm.
        """
        weights = np.outer(_weights(self.discs, disc), _weights(self.heads, head))
        return np.asarray(np.tensordot(weights, self.lifts, axes=2) / (self.rod.inner + disc))


def _places(knob: Knob, count: int) -> Array:
    if not knob.turns:
        return np.array([knob.low])
    middle, half = (knob.low + knob.high) / 2, (knob.high - knob.low) / 2
    return np.asarray(middle + half * np.cos(np.pi * (np.arange(count) + 0.5) / count))


def _weights(places: Array, at: float) -> Array:
    """Lagrange weights of the places for a value in their range, shape (k,)."""
    off = at - places
    apart = places[:, None] - places[None, :]
    np.fill_diagonal(apart, 1.0)
    others = np.where(np.eye(len(places), dtype=bool), 1.0, off[None, :])
    return np.asarray((others / apart).prod(axis=1))
