"""Cars whose rod rubs, driven along the points of a cam's file: what `tests.studies.falls` is judged by.

No line of cadgen is used. The rod is rolled over the points of the file (`tests.studies.draws_truth`), the cam is
stepped through its play cell by cell (`tests.car.running.friction_truth`), and the car goes by short arcs.
"""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from tests.car.running.friction_truth import TURN, Cells, Rod, fitting_cells, steering
from tests.studies import draws_truth

DENSE = 14_400  # points of the spline through those of a file
ROLLED = 7200  # cam angles of a turn at which the rod is rolled
TRIM_PROBE = 1e-4
TRIM_STEPS = 4


@dataclass(frozen=True)
class Driver:
    """A car and its course, as numbers; mm and rad.

    Attributes:
        rod: rod and faces.
        wheelbase, offset: of the drive wheel from the fork.
        travel: of the drive wheel's rim in a turn of the cam.
        stop: motor position at which the run ends.
        wanted: tan(beta) wanted at even cam angles of a turn.
    """

    rod: Rod
    wheelbase: float
    offset: float
    travel: float
    stop: float
    wanted: np.ndarray

    def rolled(self, file: Path) -> CubicSpline:
        """tan(beta) of the rod on the spline through the points of a file, by cam angle, periodic."""
        cloud = np.loadtxt(file)[:, :2]
        along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(cloud, axis=0).T))])
        spline = CubicSpline(along, cloud, bc_type="periodic")
        points = spline(along[-1] / DENSE * np.arange(DENSE))
        turns = np.arange(ROLLED) * TURN / ROLLED
        planes = self.rod.inner, self.rod.outer
        return _periodic(draws_truth.steering(points, self.rod.base, self.rod.radius, planes, turns))

    def off(self, cam: CubicSpline, play: float, friction: float, trim: float = 0.0) -> np.ndarray:
        """Place of the drive wheel less that planned, after each even step of the motor, as x + iy."""
        n, room = fitting_cells(play)
        stands, tangent = self._stands(cam, n, room, friction)
        count = round(n * self.stop / TURN)
        driven = np.tile(steering(tangent, stands) + trim, int(np.ceil(count / n)))[:count]
        planned = np.tile(self._planned(np.pi / n + TURN / n * np.arange(n)), int(np.ceil(count / n)))[:count]
        return self._places(driven, n) - self._places(planned, n)

    def ends(self, off: np.ndarray) -> np.ndarray:
        """Position errors by which a run is judged: at its end, or round the last turn of laps."""
        turns = self.stop / TURN
        return off[-1:] if turns < 1 else off[-round(len(off) / turns) :]

    def trimmed(self, cam: CubicSpline, play: float, friction: float) -> float:
        """Greatest error at the end, mm, after a constant turn of the steering that brings the end nearest."""
        trim, now = 0.0, self.ends(self.off(cam, play, friction))
        for _ in range(TRIM_STEPS):
            rate = (self.ends(self.off(cam, play, friction, trim + TRIM_PROBE)) - now) / TRIM_PROBE
            trim -= np.vdot(rate, now).real / np.vdot(rate, rate).real
            now = self.ends(self.off(cam, play, friction, trim))
        return float(np.abs(now).max())

    @cached_property
    def _planned(self) -> CubicSpline:
        return _periodic(self.wanted)

    def _stands(self, cam: CubicSpline, n: int, room: int, friction: float) -> tuple[np.ndarray, np.ndarray]:
        tangent = cam(TURN / n * np.arange(n))
        return Cells(self.rod, tangent).stands(friction, 0.0, room, nudge=1e-9), tangent

    def _places(self, tangent: np.ndarray, n: int) -> np.ndarray:
        ds = self.travel / n
        turning = -tangent / (self.wheelbase + self.offset * tangent) * ds
        heading = np.cumsum(turning) - turning / 2
        return np.cumsum(np.exp(1j * heading) * np.sinc(turning / TURN)) * ds


def _periodic(values: np.ndarray) -> CubicSpline:
    angle = TURN / len(values) * np.arange(len(values) + 1)
    return CubicSpline(angle, np.append(values, values[0]), bc_type="periodic")
