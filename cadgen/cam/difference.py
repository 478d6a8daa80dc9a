"""How far two outlines lift a follower apart: the greatest difference over the turn, not only at some stations."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.contact import Ring
from cadgen.cam.follower import Contact, Follower
from cadgen.curves.closed import Outline

# The contact runs along a hollow that is hardly wider than the follower within little angle. Stations are put in so
# that it moves by no more than this from one to the next, mm, but not more than so many between two: a corner takes no
# travel.
_TRAVEL = 0.06
_MOST_BETWEEN = 16
# The greatest differences at stations are closed in on: this many of them, by so many stations each, in as many rounds.
# A hump that three stations see is then met within 1e-3 of its height. One of them sees at least eight ninths of it, so
# that a hump that shows less than this share of the greatest is not the highest. The next round's stations are four
# times as close together and miss a sixteenth of that ninth, and so on.
_LEAST_SHARES = (0.85, 0.99, 0.999)
_PLACES = 48
_WITHIN = 9


def dense_stations(follower: Follower, contact: Contact) -> Array:
    """Cam angles of a contact and more where it travels far between two of them, rad, shape (n,)."""
    theta = contact.cam_angle
    ahead = follower.distance(contact.q, contact.face)
    place = theta + np.arcsin(np.clip(contact.across / ahead, -1.0, 1.0))
    travel = np.abs(np.diff(place)) * ahead[:-1]
    count = np.clip(np.ceil(travel / _TRAVEL), 1, _MOST_BETWEEN).astype(int)
    share = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    between = np.repeat(theta[:-1], count) + share * np.repeat(np.diff(theta) / count, count)
    return np.append(between, theta[-1])


@dataclass(frozen=True)
class Exact:
    """Exact lift, for comparison with the lift of files.

    Attributes:
        outline: outline of the exact curve, mm.
        follower: follower that rolls on it.
        stations: increasing cam angles, close enough together that every hump of a difference shows, rad, shape (n,).
    """

    outline: Outline
    follower: Follower
    stations: Array

    @cached_property
    def _ring(self) -> Ring:
        return Ring.of(self.outline, self.follower)

    @cached_property
    def _lift(self) -> Array:
        """At the stations, mm, shape (n,)."""
        return self._ring.contact(self.stations).lift

    def compare(self, outline: Outline) -> tuple[float, Contact]:
        """The greatest difference of lift of another outline, in size, mm: within a hundredth and what rolling errs.

        Returns:
            The difference, and how the follower rests on the other outline at the stations.

        Raises:
            DesignError: the outline does not enclose the camshaft or is not star-shaped about it.
        """
        ring = Ring.of(outline, self.follower)
        contact = ring.contact(self.stations)
        return self._greatest(ring, np.abs(contact.lift - self._lift)), contact

    def _greatest(self, ring: Ring, size: Array) -> float:
        """Close in on the highest humps of a difference that is known at the stations."""
        greatest = float(size.max())
        # The turn closes: behind the last station comes the first one.
        stations = self.stations
        around = np.concatenate([stations[-1:] - 2 * np.pi, stations, stations[:1] + 2 * np.pi])
        humps = np.flatnonzero((size >= np.roll(size, 1)) & (size >= np.roll(size, -1)))
        humps = humps[np.argsort(-size[humps])[:_PLACES]]
        centre, height = stations[humps], size[humps]
        reach = np.maximum(around[humps + 2] - centre, centre - around[humps])
        for share in _LEAST_SHARES:
            high = height >= share * greatest
            theta = centre[high, None] + reach[high, None] * np.linspace(-1.0, 1.0, _WITHIN)
            lifts = [of.contact(theta.ravel()).lift for of in (ring, self._ring)]
            sizes = np.abs(lifts[0] - lifts[1]).reshape(theta.shape)
            best = np.argmax(sizes, axis=1)
            rows = np.arange(len(theta))
            centre, height, reach = theta[rows, best], sizes[rows, best], reach[high] * 2 / (_WITHIN - 1)
            greatest = max(greatest, float(height.max()))
        return greatest
