"""Windows of a dilation, one for each fall, for cars whose rod rubs.

With friction the gears still drive the cam on the first part of a fall, and it leads by the play B on the rest. Turned
ahead by a window w, the part that is driven comes w late and the part that leads comes B - w early. On each fall
another window makes the two turn the car by as much as the wanted fall does. So the headings between the falls are met,
and with them the end of the run.

The windows are found by Gauss-Newton steps through the exact chain: dilation, leads, run. What a window does to the
heading is seen on all falls at once, since each acts where it is; what a heading does to the end is its lever to the
end.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.optimize import lsq_linear

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.against_play.compensation import compensated_lift
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run, drive, turns_of
from cadgen.car.running.mechanics import Mechanics
from cadgen.car.running.play import falls
from cadgen.car.running.run_errors import run_error
from cadgen.car.steering import Car
from cadgen.errors import DesignError

_STEPS = 720  # of a turn; the end errs by 1e-5 mm
_HEADING = 300.0  # mm by rad: what a heading between two falls counts beside the end
_PROBE = 1e-4  # rad, of all windows at once
_WIDEST = 1.6  # times the greatest play
_KEPT = 20.0  # mm by rad: what a window off the one for all counts; it decides on falls that do next to nothing
_STEPS_MOST = 8  # of a search; each runs every car of the band twice, and once more where a step is halved
_LITTLE = 0.02  # of the sum of squares; a step that gains less is the last
_SEARCHES = 3  # each counts the cars that ended farthest off in the one before for more
_MOST = 40  # falls; a rougher lift has one window


@dataclass
class WindowSearch:
    """Search for the windows with the least worst end of run over the cars that may be built.

    Attributes:
        lift: lift that is dilated.
        wanted: lift that the run is compared with.
        follower: follower of the car.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        cars: return error, rad, and forces of each car.
        best: windows with the least worst end so far, shape (k,), rad.
        worst: that end, mm; infinite before the search.
    """

    lift: PathMotion
    wanted: PathMotion
    follower: EdgeFollower
    car: Car
    length: float
    cars: Sequence[tuple[float, Mechanics]]
    best: Array = field(default_factory=lambda: np.empty(0))
    worst: float = np.inf

    def run(self, start: float) -> None:
        """Search from one window for all falls; nothing is found where one is all that there can be.

        Args:
            start: that window, rad.
        """
        count = len(self._pairs)
        if not 2 <= count <= _MOST or not any(len(car.leads(self.lift).intervals) for _, car in self.cars):
            return
        most = _WIDEST * max(play for play, _ in self.cars)
        windows, weight = np.full(count, min(start, most)), np.ones(len(self.cars))
        for _ in range(_SEARCHES if len(self.cars) > 1 else 1):
            try:
                windows = self._search(windows, weight, most)
            except DesignError:
                return
            ends = np.hypot(*self._vectors(self.best)[:, :2].T)
            weight = weight * np.sqrt(np.maximum(ends, 0.02 * ends.max()) / ends.max())
            weight /= weight.max()

    def _search(self, windows: Array, weight: Array, most: float) -> Array:
        """Windows with the least sum of squares: Gauss-Newton steps within bounds, halved where they do not help.

        Args:
            windows: windows to begin with, shape (k,), rad.
            weight: weight of each car.
            most: widest window allowed, rad.
        """
        start = windows

        def residual(at: Array, found: Array) -> Array:
            return np.concatenate([(found * self._scale * weight[:, None]).ravel(), _KEPT * (at - start)])

        found = self._vectors(windows)
        now = residual(windows, found)
        for _ in range(_STEPS_MOST):
            slope = np.vstack([self._jacobian(windows, found, weight), _KEPT * np.eye(len(windows))])
            step = lsq_linear(slope, -now, bounds=(-windows - 1e-15, most - windows + 1e-15)).x
            for share in (1.0, 0.5, 0.25):
                tried = np.clip(windows + share * step, 0.0, most)
                after = self._vectors(tried)
                then = residual(tried, after)
                if then @ then < now @ now:
                    break
            else:
                break
            gained = 1 - (then @ then) / (now @ now)
            windows, found, now = tried, after, then
            if gained < _LITTLE:
                break
        return windows

    @cached_property
    def _pairs(self) -> Array:
        return falls(self.lift)

    @property
    def _steps(self) -> int:
        return _STEPS * turns_of(self.wanted.blend_start)

    @cached_property
    def _planned(self) -> Run:
        return drive(self.wanted, self.car, self.length, steps=self._steps)

    @cached_property
    def _marks(self) -> Array:
        """Cam angles between two falls, on the rise, rad; the last may be cut short by the end of the run."""
        next_peak = np.append(self._pairs[1:, 0], self._pairs[0, 0] + TURN)
        return np.asarray(np.minimum((self._pairs[:, 1] + next_peak) / 2, self.wanted.blend_start))

    @cached_property
    def _levers(self) -> Array:
        """Move of the end, along and across its heading, by a turn at each fall, mm by rad, shape (k, 2)."""
        run = self._planned
        place = run.drive_wheel @ [1, 1j]
        stop = self.wanted.blend_start
        at = np.interp(np.minimum(self._pairs.mean(axis=1), stop), run.motor, np.arange(len(run.motor)))
        end = np.interp(stop, run.motor, place.real) + 1j * np.interp(stop, run.motor, place.imag)
        heading = float(np.interp(stop, run.motor, run.heading))
        turned = 1j * (end - place[at.astype(int)]) * np.exp(-1j * heading)
        return np.stack([turned.real, turned.imag], axis=1)

    def _vectors(self, windows: Array) -> Array:
        """End along and across, mm, and headings between the falls, rad, of each car, shape (cars, 2 + k)."""
        cam = compensated_lift(self.lift, self.follower, windows.tolist())
        rows = []
        for play, forces in self.cars:
            following = forces.leads(cam).follow(cam, play)
            run = drive(
                cam, self.car, self.length, steps=self._steps, stop=self.wanted.blend_start, following=following
            )
            error = run_error(run, self._planned)
            heading = np.interp(self._marks, error.motor, error.heading)
            rows.append([error.along[-1], error.across[-1], *heading])
        found = np.array(rows)
        worst = float(np.hypot(*found[:, :2].T).max())
        if worst < self.worst:
            self.best, self.worst = windows.copy(), worst
        return found

    def _jacobian(self, windows: Array, found: Array, weight: Array) -> Array:
        """Derivatives of the weighted vectors by the windows, of which `found` are those at hand."""
        probed = self._vectors(windows + _PROBE)
        turned = np.diff((probed - found)[:, 2:], axis=1, prepend=0.0) / _PROBE  # of the car, by each window
        count = len(windows)
        rows = np.empty((len(found), 2 + count, count))
        rows[:, :2] = turned[:, None, :] * self._levers.T
        rows[:, 2:] = np.tril(np.ones((count, count))) * turned[:, None, :]
        return np.asarray((rows * self._scale[:, None] * weight[:, None, None]).reshape(-1, count))

    @property
    def _scale(self) -> Array:
        return np.concatenate([[1.0, 1.0], np.full(len(self._marks), _HEADING)])
