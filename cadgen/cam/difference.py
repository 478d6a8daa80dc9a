"""How far two outlines lift the rod apart: the greatest difference over the turn, not only at some stations."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cadgen.cam.contact import Contact, roll
from cadgen.cam.follower import Follower
from cadgen.curves.closed import Outline

Array = NDArray[np.float64]

# The contact runs along a hollow that is hardly wider than the rod within little angle. Stations are put in so that it
# moves by no more than this from one to the next, mm, but not more than so many between two: a corner takes no travel.
_TRAVEL = 0.06
_MOST_BETWEEN = 16
# The greatest differences at stations are closed in on: this many of them, by so many stations each, in as many rounds.
# A hump that three stations see is then met within 1e-3 of its height. One of them sees at least eight ninths of it, so
# that a hump that shows less than this share of the greatest is not the highest.
_LEAST_SHARE = 0.85
_PLACES = 48
_WITHIN = 9
_ROUNDS = 3


def dense_stations(follower: Follower, contact: Contact) -> Array:
    """Cam angles of a contact and more where it travels far between two of them, rad, shape (n,)."""
    theta = contact.cam_angle
    ahead = follower.base_radius + contact.face * contact.tan_beta
    place = theta + np.arcsin(np.clip(contact.across / ahead, -1.0, 1.0))
    travel = np.abs(np.diff(place)) * ahead[:-1]
    count = np.clip(np.ceil(travel / _TRAVEL), 1, _MOST_BETWEEN).astype(int)
    share = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    between = np.repeat(theta[:-1], count) + share * np.repeat(np.diff(theta) / count, count)
    return np.append(between, theta[-1])


@dataclass(frozen=True)
class Exact:
    """The lift that files are held against.

    Attributes:
        outline: of the exact curve.
        follower: the rod.
        stations: increasing cam angles, close enough together that every hump of a difference shows, rad, shape (n,).
    """

    outline: Outline
    follower: Follower
    stations: Array

    @cached_property
    def lift(self) -> Array:
        """At the stations, mm, shape (n,)."""
        return roll(self.outline, self.follower, self.stations).lift

    def greatest_difference(self, outline: Outline) -> float:
        """The greatest difference of lift of another outline, in size, mm: within a hundredth and what rolling errs.

        Raises:
            DesignError: the outline does not enclose the camshaft or is not star-shaped about it.
        """
        size = np.abs(roll(outline, self.follower, self.stations).lift - self.lift)
        greatest = float(size.max())
        # The turn closes: behind the last station comes the first one.
        stations = self.stations
        around = np.concatenate([stations[-1:] - 2 * np.pi, stations, stations[:1] + 2 * np.pi])
        humps = np.flatnonzero(
            (size >= np.roll(size, 1)) & (size >= np.roll(size, -1)) & (size >= _LEAST_SHARE * greatest)
        )
        humps = humps[np.argsort(-size[humps])[:_PLACES]]
        centre = stations[humps]
        reach = np.maximum(around[humps + 2] - centre, centre - around[humps])
        for _ in range(_ROUNDS):
            theta = centre[:, None] + reach[:, None] * np.linspace(-1.0, 1.0, _WITHIN)
            lifts = [roll(of, self.follower, theta.ravel()).lift for of in (outline, self.outline)]
            size = np.abs(lifts[0] - lifts[1]).reshape(theta.shape)
            greatest = max(greatest, float(size.max()))
            centre = theta[np.arange(len(theta)), np.argmax(size, axis=1)]
            reach = reach * 2 / (_WITHIN - 1)
        return greatest
