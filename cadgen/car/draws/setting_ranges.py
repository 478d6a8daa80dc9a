"""Quantities that can be set on a car, with ranges and divisions. Lengths in mm, angles in rad."""

from dataclasses import dataclass
from math import ceil, floor

import numpy as np

from cadgen.arrays import TURN, Array

DISC, HEAD, TRAVEL, X, Y, HEADING = range(6)  # of a vector of settings
COUNT = 6
_ROUND = 1e-9  # of a division
_ABOUT = 4  # divisions
_APART = 1e-6  # of a division: less is the same value
_LEAST_SHARE = 1e-3  # of a travel, by which the next one is taken to differ where it is not known


@dataclass(frozen=True)
class SettingRange:
    """A quantity that can be set.

    Attributes:
        low: least value.
        high: greatest value.
        step: division to which it is set; 0 for any value.
        origin: what is shown where the value is 0; the division is of what is shown.
    """

    low: float = 0.0
    high: float = 0.0
    step: float = 0.0
    origin: float = 0.0

    @property
    def turns(self) -> bool:
        """Whether there is a choice."""
        return self.high > self.low

    def adjacent(self, value: float) -> tuple[float, ...]:
        """Values that can be set, on either side of a value, mm or rad.

        Args:
            value: value wanted, mm or rad.
        """
        if self.step == 0:
            return (value,)
        parts = (self.origin + value) / self.step
        sides = (floor(parts + _ROUND), ceil(parts - _ROUND))
        values = (number * self.step - self.origin for number in sides)
        return tuple(dict.fromkeys(min(max(each, self.low), self.high) for each in values))


@dataclass(frozen=True)
class Wheels:
    """Drive wheels and ratios that can be had.

    Attributes:
        radii: radii at hand, mm; the ends of the range, of those that can be made.
        ratios: ratios of the train, turns of the drive wheel for one of the cam.
        made: whether every radius between the ends can be made.
        step: between radii that can be made, mm; 0 for any.
    """

    radii: tuple[float, ...]
    ratios: tuple[float, ...]
    made: bool = False
    step: float = 0.0

    @property
    def travels(self) -> tuple[float, float]:
        """Least and greatest travel in a turn of the cam, mm."""
        return TURN * min(self.radii) * min(self.ratios), TURN * max(self.radii) * max(self.ratios)

    @property
    def free(self) -> bool:
        """Whether every travel between the ends can be had."""
        return self.made and self.step == 0 and len(self.ratios) == 1

    def adjacent(self, travel: float) -> tuple[tuple[float, float], ...]:
        """Radius and ratio of the travels that can be had on either side of a travel, mm.

        Args:
            travel: travel wanted for one turn of the cam, mm.
        """
        radii = SettingRange(min(self.radii), max(self.radii), self.step)
        choices = {
            (radius, ratio)
            for ratio in self.ratios
            for radius in (
                radii.adjacent(min(max(travel / (TURN * ratio), radii.low), radii.high)) if self.made else self.radii
            )
        }
        below = [each for each in choices if TURN * each[0] * each[1] <= travel]
        above = [each for each in choices if TURN * each[0] * each[1] > travel]
        best = [max(below, key=_product)] if below else []
        return (*best, *([min(above, key=_product)] if above else []))


def _product(choice: tuple[float, float]) -> float:
    return choice[0] * choice[1]


@dataclass(frozen=True, kw_only=True)
class SettingRanges:
    """Ranges within which the settings of a card are sought.

    Disc and head are changes from the design, and the start is one from that of the scaled path.

    Attributes:
        disc: place of the disc on its shaft, positive away from the fork axis, mm.
        head: change of the base radius, mm.
        wheels: drive wheels and ratios.
        x, y: place of the start, mm.
        heading: heading at the start, rad.
    """

    disc: SettingRange
    head: SettingRange
    wheels: Wheels
    x: SettingRange
    y: SettingRange
    heading: SettingRange

    @property
    def bounds(self) -> Array:
        """Least and greatest value of each, shape (6, 2)."""
        ranges = [(each.low, each.high) for each in map(self._plain, range(COUNT))]
        ranges[TRAVEL] = self.wheels.travels
        return np.array(ranges)

    def adjacent(self, number: int, value: float) -> tuple[float, ...]:
        """Values of a setting that can be made, on either side of a value, mm or rad.

        Args:
            number: number of the setting, counted from 0.
            value: value wanted, mm or rad.
        """
        if number == TRAVEL:
            return tuple(TURN * radius * ratio for radius, ratio in self.wheels.adjacent(value))
        return self._plain(number).adjacent(value)

    def about(self, number: int, value: float) -> tuple[float, ...]:
        """Values of a setting that can be made, the five nearest on either side of a value.

        Args:
            number: number of the setting.
            value: the value, mm or rad.
        """
        (low, high), division = self.bounds[number], self.division(number, value)
        apart: list[float] = []
        for shift in division * np.arange(-_ABOUT, _ABOUT + 1):
            for each in self.adjacent(number, value + shift):
                if low <= each <= high and all(abs(each - other) > _APART * division for other in apart):
                    apart.append(each)
        return tuple(apart)

    def division(self, number: int, value: float) -> float:
        """Distance of settings about a value, mm or rad; 0 where any can be made, or where there is no choice.

        Args:
            number: number of the setting, counted from 0.
            value: value about which it is asked, mm or rad.
        """
        low, high = self.bounds[number]
        if high <= low or (number == TRAVEL and self.wheels.free):
            return 0.0
        if number == TRAVEL:
            travels = self.adjacent(TRAVEL, value)
            return max(travels) - min(travels) or value * _LEAST_SHARE
        return self._plain(number).step

    def _plain(self, number: int) -> SettingRange:
        return (self.disc, self.head, SettingRange(), self.x, self.y, self.heading)[number]


@dataclass(frozen=True, kw_only=True)
class CarSetting:
    """A setting of the car.

    Attributes:
        disc: disc moved away from the fork axis, mm.
        head: growth of the base radius, mm.
        radius: of the drive wheel, mm.
        ratio: of the train, turns of the drive wheel for one of the cam.
        x, y: start moved against that of the scaled path, mm.
        heading: start turned to the left, rad.
    """

    disc: float
    head: float
    radius: float
    ratio: float
    x: float
    y: float
    heading: float

    @property
    def travel(self) -> float:
        """Travel of the drive wheel in a turn of the cam, mm."""
        return TURN * self.radius * self.ratio

    @property
    def values(self) -> Array:
        """Vector of the settings, shape (6,)."""
        return np.array([self.disc, self.head, self.travel, self.x, self.y, self.heading])


def setting_of(values: Array, wheels: Wheels) -> CarSetting:
    """Setting of a vector of shape (6,), mm and rad, with the wheel whose travel can be had.

    Args:
        values: settings, shape (6,), mm and rad.
        wheels: wheels and ratios that can be had.
    """
    travel = float(values[TRAVEL])
    radius, ratio = (travel / (TURN * wheels.ratios[0]), wheels.ratios[0])
    if not wheels.free:
        radius, ratio = min(wheels.adjacent(travel), key=lambda choice: abs(TURN * _product(choice) - travel))
    disc, head, _, x, y, heading = values.tolist()
    return CarSetting(disc=disc, head=head, radius=radius, ratio=ratio, x=x, y=y, heading=heading)
