"""Laps of a closed path: where the car stands at the end of each, against where it started.

The cam turns for ever, and where it stands depends on the motor's position alone (`cadgen.car.motion.play`). So the car
begins its first lap as it begins every other one, the cam ahead of its gears if the lap begins on a fall of the lift,
and each turn of the cam moves the car by one and the same rigid motion.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.motion.drive import Run


@dataclass(frozen=True, kw_only=True)
class Drift:
    """Drift of a car on a closed path, after each of its laps.

    Attributes:
        position: distance of the drive wheel from where it started, shape (n,), mm.
        heading: heading less that of the start, shape (n,), rad, positive to the left.
        furthest: greatest distance of the drive wheel on the last lap from where it is planned, mm: a lap that turns
            about its start is far off elsewhere.
    """

    position: Array
    heading: Array
    furthest: float

    @property
    def lap(self) -> tuple[float, float]:
        """Position (mm) and heading (rad) after the first lap."""
        return float(self.position[0]), float(self.heading[0])

    @property
    def end(self) -> tuple[float, float]:
        """Position (mm) and heading (rad) after the last lap."""
        return float(self.position[-1]), float(self.heading[-1])


def drift(run: Run, planned: Run, laps_per_turn: int, round_: float) -> Drift:
    """Drift at the end of each lap of a run.

    Args:
        run: run over whole laps, with motor positions at or close to the end of each.
        planned: the planned run, at the same motor positions.
        laps_per_turn: laps in one turn of the cam.
        round_: angle by which the car turns on its lap, rad: a whole number of turns.
    """
    lap = TURN / laps_per_turn
    number = np.arange(1, round(run.motor[-1] / lap) + 1)

    def at(values: Array) -> Array:
        return np.interp(number * lap, run.motor, values)

    x, y = run.drive_wheel.T
    last = run.motor >= run.motor[-1] - lap
    return Drift(
        position=np.hypot(at(x) - x[0], at(y) - y[0]),
        heading=at(run.heading) - run.heading[0] - number * round_,
        furthest=float(np.linalg.norm(run.drive_wheel[last] - planned.drive_wheel[last], axis=1).max()),
    )
