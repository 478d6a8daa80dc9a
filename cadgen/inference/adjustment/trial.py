"""Trial runs: what a hand has set before them, and which place of the track a measured point belongs to."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.inference.monte_carlo.parameters import Parameter

Complex = NDArray[np.complex128]


class Setting(StrEnum):
    """A setting of `Settings`, by the name of its field."""

    HEAD = "head"
    KEY = "key"
    START_X = "start_x"
    START_Y = "start_y"
    START_HEADING = "start_heading"

    @property
    def parameter(self) -> Parameter:
        """Deviation of a fleet that it changes."""
        if self is Setting.HEAD:
            return Parameter.BASE_RADIUS
        return Parameter.CAM_PHASE if self is Setting.KEY else Parameter(self)


# Settings of the start, which are made anew in each run.
STARTS = (Setting.START_X, Setting.START_Y, Setting.START_HEADING)


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Changes of a car that a hand makes without a new part.

    Attributes:
        head: growth of the base radius at the micrometer head, mm.
        key: angle by which the cam is set ahead on its shaft, rad.
        start_x: start moved ahead along the planned heading, mm.
        start_y: start moved to the left of it, mm.
        start_heading: start turned to the left, rad.
    """

    head: float = 0.0
    key: float = 0.0
    start_x: float = 0.0
    start_y: float = 0.0
    start_heading: float = 0.0

    @property
    def deviations(self) -> dict[Parameter, float]:
        """The same as deviations of a fleet (`cadgen.inference.monte_carlo.parameters`)."""
        return {setting.parameter: self.of(setting) for setting in Setting}

    def of(self, setting: Setting) -> float:
        """Change of one setting, mm or rad.

        Args:
            setting: setting that is asked for.
        """
        return float(getattr(self, setting))


@dataclass(frozen=True, kw_only=True)
class Trial:
    """A trial run.

    Attributes:
        points: measured places of a point of the car, x + iy from the planned start, x along the planned heading
            there, shape (n,), mm, in the order of driving.
        motor: motor position at each point, shape (n,), rad; None where the car was not stopped for the measurement:
            then each point lies somewhere on the track, and the last where the run ends.
        settings: what was set for this run.
    """

    points: Complex
    motor: Array | None = None
    settings: Settings = field(default_factory=Settings)


@dataclass(frozen=True, kw_only=True)
class Noise:
    """Standard deviations of what repeats from run to run only so well.

    Attributes:
        point: a measured coordinate, mm.
        start: place of the start in each direction, mm.
        heading: heading of the start, rad.
        head: setting of the micrometer head, mm; its error stays as it is until the head is turned again.
    """

    point: float = 10.0
    start: float = 3.0
    heading: float = float(np.radians(0.15))
    head: float = 0.002

    @property
    def starts(self) -> Mapping[Parameter, float]:
        """Standard deviations of each start, mm and rad, by the names of a fleet's deviations."""
        return {Parameter.START_X: self.start, Parameter.START_Y: self.start, Parameter.START_HEADING: self.heading}


def stations_of(track: Complex, points: Complex) -> NDArray[np.intp]:
    """Which station of a track each point belongs to, so that points in order stay in order.

    The sum of squared distances is least among all assignments in order, by dynamic programming; a track that
    crosses itself is no trouble. The last point is that of the last station.

    Args:
        track: places at g stations, shape (g,), mm.
        points: shape (n,), mm.
    """
    square = np.abs(track[None, :] - points[:, None]) ** 2
    total = square[0]
    steps = []
    for row in square[1:]:
        # The best station so far up to each one.
        least = np.minimum.accumulate(total)
        steps.append(np.maximum.accumulate(np.where(total == least, np.arange(len(total)), 0)))
        total = least + row
    at = np.empty(len(points), dtype=np.intp)
    at[-1] = len(track) - 1
    for number in range(len(points) - 2, -1, -1):
        at[number] = steps[number][at[number + 1]]
    return at
