"""Margins of cars to the items of a course, from their poses at a few places of the run.

Near a place a car's track is the planned one, moved as the car's pose there is off: what bends it otherwise counts with
the square of the way. So what stands on the course is moved back by the same, and held against the planned run.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array

Complex = NDArray[np.complex128]
_SQUARE = 0.2  # sine of the least angle between track and segment that is reckoned with
_FAILED = -1e-6  # mm; at most, of a gate that is passed in the wrong direction or order


class CourseItem(Protocol):
    """Item of a course at a station of the cars' runs; all places in the frame of the nominal start, x + iy."""

    @property
    def key(self) -> str:
        """Key of the item in the design file."""

    @property
    def station(self) -> int:
        """Number of its station among those of the cars."""

    @property
    def places(self) -> Complex:
        """Points of the item, shape (p,), mm."""

    def margin(self, places: Complex, turned: Array) -> Array:
        """Margins of cars, shape (m,), mm; less than 0 where they fail.

        Args:
            places: its points as they lie to each car's planned run, shape (m, p), mm.
            turned: heading error of each car there, shape (m,), rad.
        """

    def distance(self, places: Complex) -> Array:
        """Signed distance of cars from the item, along the line on which its margin is measured, shape (m,), mm.

        Args:
            places: its points as they lie to each car's planned run, shape (m, p), mm.
        """


@dataclass(frozen=True)
class GateItem:
    """A gate, disc or segment.

    Attributes:
        station: number of the station nearest to it.
        places: its middle, or the two ends of the segment, mm.
        reach: radius of a disc, mm.
        track: planned track of the point of the car that must pass it, about there, shape (w,), mm.
        heading: angle from the heading wanted to the planned one, and the greatest allowed, rad; None if any will do.
        passed: whether the planned run passes it in its order.
        key: its key in the design file.
    """

    station: int
    places: Complex
    reach: float
    track: Complex
    heading: tuple[float, float] | None = None
    passed: bool = True
    key: str = ""

    def margin(self, places: Complex, turned: Array) -> Array:
        """Radius less the distance of the track, or distance of the crossing from the nearer end.

        Args:
            places: places of the cars, x + iy, shape (m, k), mm.
            turned: headings of the cars against the planned one, shape (m, k), rad.
        """
        margin = self._disc(places[:, 0]) if places.shape[1] == 1 else self._segment(places)
        return _headed(margin if self.passed else np.minimum(margin, _FAILED), self.heading, turned)

    def distance(self, places: Complex) -> Array:
        """Signed distance across the track, or along a segment to where it is crossed; see `CourseItem.distance`."""
        moved, middle = places.mean(axis=1) - self.places.mean(), self.places.mean()
        along = np.diff(self.track)[np.abs(self.track[1:] - middle).argmin()]
        along /= abs(along)
        across = 1j * along if len(self.places) == 1 else self.places[1] - self.places[0]
        square = float((across * along.conjugate()).imag / abs(across))
        return np.asarray((moved * along.conjugate()).imag / np.copysign(max(abs(square), _SQUARE), square))

    def _disc(self, centre: Complex) -> Array:
        along = np.diff(self.track)
        length = np.abs(along)
        local = (centre[:, None] - self.track[:-1]) * (along.conj() / length)
        beside = local.real - np.clip(local.real, 0.0, length)
        return np.asarray(self.reach - np.sqrt((beside**2 + local.imag**2).min(axis=1)))

    def _segment(self, places: Complex) -> Array:
        a, across = places[:, :1], places[:, 1:] - places[:, :1]
        length = np.abs(across)
        local = (self.track - a) * across.conj() / length
        height = local.imag
        crosses = (height[:, :-1] <= 0) != (height[:, 1:] <= 0)
        share = height[:, :-1] / np.where(crosses, height[:, :-1] - height[:, 1:], 1.0)
        along = local.real[:, :-1] + share * np.diff(local.real)
        beyond = np.abs(local - np.clip(local.real, 0.0, length)).min(axis=1)
        inside = np.where(crosses, np.minimum(along, length - along), -np.inf).max(axis=1)
        return np.asarray(np.where(inside >= 0, inside, -np.maximum(beyond, -_FAILED)))


@dataclass(frozen=True)
class ClearanceItem:
    """An obstacle or the edge, at the planned run's nearest approach to it.

    Attributes:
        station: number of the station nearest to that.
        places: its nearest point, one, mm.
        away: direction from the car to it, x + iy of length 1; for the edge and where they overlap, inwards.
        clearance: clearance there less the margin that is wanted, mm.
        key: its key in the design file.
    """

    station: int
    places: Complex
    away: complex
    clearance: float
    key: str = ""

    def margin(self, places: Complex, turned: Array) -> Array:
        """Clearance to first order: it grows as its nearest point moves away from the car.

        Args:
            places: places of the cars, x + iy, shape (m, k), mm.
            turned: headings of the cars against the planned one, shape (m, k), rad.
        """
        return np.asarray(self.clearance + self.distance(places))

    def distance(self, places: Complex) -> Array:
        """Signed distance away from the car; see `CourseItem.distance`."""
        return np.asarray(np.real((places[:, 0] - self.places[0]) * np.conj(self.away)))


@dataclass(frozen=True)
class FinishItem:
    """The disc in which a run must end.

    Attributes:
        station: number of the end of the run.
        places: its middle, one, mm.
        reach: its radius, mm.
        stop: place of the planned end of the point of the car that must come there, mm.
        heading: angle from the heading wanted to the planned one, and the greatest allowed, rad; None if any will do.
        key: its key in the design file.
    """

    station: int
    places: Complex
    reach: float
    stop: complex
    heading: tuple[float, float] | None = None
    key: str = ""

    def margin(self, places: Complex, turned: Array) -> Array:
        """Radius less the distance of the car's point from the middle where its run ends.

        Args:
            places: places of the middle, x + iy, shape (m, 1), mm.
            turned: headings of the cars against the planned one, shape (m,), rad.
        """
        return np.asarray(_headed(self.reach - np.abs(places[:, 0] - self.stop), self.heading, turned))

    def distance(self, places: Complex) -> Array:
        """Distance of the ends of cars from the planned end in any direction, as a disc has edges, shape (m,)."""
        return np.asarray(np.abs(places[:, 0] - self.places[0]))


def _headed(margin: Array, heading: tuple[float, float] | None, turned: Array) -> Array:
    """Margins of cars, less than 0 where they head in a wrong direction."""
    if heading is None:
        return margin
    off, most = heading
    wrong = np.abs((off + turned + TURN / 2) % TURN - TURN / 2) > most
    return np.asarray(np.where(wrong, np.minimum(margin, _FAILED), margin))


@dataclass(frozen=True)
class CourseMargins:
    """Items of a course as m cars meet them.

    Attributes:
        items: the items.
        places: points of each as they lie to each car's planned run, shape (m, p) each, mm.
        turned: heading error of each car at each, shape (w, m), rad.
    """

    items: tuple[CourseItem, ...]
    places: tuple[Complex, ...]
    turned: Array

    @property
    def margins(self) -> Array:
        """Margin of each car to each item, shape (w, m), mm."""
        met = zip(self.items, self.places, self.turned, strict=True)
        return np.stack([item.margin(places, turned) for item, places, turned in met])

    @property
    def distance(self) -> Array:
        """Signed distance of each car from each course item, along the item's margin line, shape (w, m), mm."""
        return np.stack([item.distance(places) for item, places in zip(self.items, self.places, strict=True)])


def margins_at(
    items: tuple[CourseItem, ...], heading: Array, position: Complex, planned: tuple[Array, Complex]
) -> CourseMargins:
    """Items of a course as cars meet them.

    Args:
        items: what the cars must keep, one item at least.
        heading: headings of m cars at g stations, shape (m, g), rad.
        position: positions of their drive wheels, shape (m, g), mm.
        planned: the planned run's, shape (1, g).
    """
    turned = np.stack([heading[:, item.station] - planned[0][0, item.station] for item in items])
    back = np.exp(-1j * turned)
    places = tuple(
        (item.places - position[:, item.station, None]) * ways[:, None] + planned[1][0, item.station]
        for item, ways in zip(items, back, strict=True)
    )
    return CourseMargins(items, places, turned)
