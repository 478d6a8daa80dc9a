"""Trial run: errors of a car's run against the planned one, and the trim of the steering that brings its end nearest.

A trim is a constant turn of the steering against the rod, set after a trial run. On an open path it is set by the end
of the run; on laps, by places all round the last turn of the cam, for a car that turns about its start is far off
elsewhere.
"""

from dataclasses import dataclass
from functools import cached_property
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Pose, Run, Steered, drive, turns_of
from cadgen.car.running.mechanics import Leads
from cadgen.car.running.run_errors import RunError
from cadgen.car.steering import Car

_STEPS = 720  # of a turn; the end errs by 1e-5 mm
_STATIONS = 8  # of the last turn, of laps
_TRIM_STEPS = 6  # of Newton's method: the end moves nearly in proportion to the trim
_PROBE = radians(0.01)
_SETTLED = 1e-7  # of tan(beta); the end moves by 0.002 mm


@dataclass(frozen=True, kw_only=True)
class SteeringTrim:
    """A constant turn of the steering against the rod, set after a trial run.

    Attributes:
        tan_beta: constant added to the tangent of the steering angle.
        error: errors of the run with the trim.
        rate: change of the ends by the trim where it was last looked at, along + i across, mm.
    """

    tan_beta: float
    error: RunError
    rate: NDArray[np.complex128]


@dataclass(frozen=True, kw_only=True)
class TrialRun:
    """Runs of cars that are to give one lift, against its planned run.

    Attributes:
        wanted: lift wanted by motor position.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
    """

    wanted: PathMotion
    car: Car
    length: float

    @cached_property
    def planned(self) -> Run:
        """Run by the lift wanted, without play."""
        stop = self.wanted.blend_start
        following = Leads(np.empty((0, 2))).follow(self.wanted, 0.0)
        return drive(self.wanted, self.car, self.length, steps=_STEPS * turns_of(stop), stop=stop, following=following)

    @cached_property
    def _against_plan(self) -> NDArray[np.complex128]:
        """Planned heading as e^(-i heading), by which a position error is split along and across it."""
        return np.asarray(np.exp(-1j * self.planned.heading))

    def error(self, cam: PathMotion, leads: Leads, play: float, trim: float = 0.0) -> RunError:
        """Errors of a run.

        Args:
            cam: lift that the follower gets.
            leads: stretches on which the cam leads.
            play: return error, rad.
            trim: constant added to the tangent of the steering angle.
        """
        return self._error(self._steered(cam, leads, play), trim)

    def _steered(self, cam: PathMotion, leads: Leads, play: float) -> Steered:
        stop = self.wanted.blend_start
        return Steered.by(leads.follow(cam, play), steps=_STEPS * turns_of(stop), stop=stop)

    def _error(self, steered: Steered, trim: float) -> RunError:
        heading, position = steered.driven(self.car, self.length, Pose(), trim)
        x, y = self.planned.drive_wheel.T
        off = (position - (x + 1j * y)) * self._against_plan
        return RunError(motor=steered.motor, heading=heading - self.planned.heading, along=off.real, across=off.imag)

    def ends(self, error: RunError) -> NDArray[np.complex128]:
        """Position errors by which a run is judged, along + i across, mm: at its end, or round the last turn of laps.

        Args:
            error: errors of the run.
        """
        stop = float(error.motor[-1])
        at = np.array([stop]) if stop < TURN else np.linspace(stop - TURN, stop, _STATIONS + 1)[1:]
        return np.asarray(np.interp(at, error.motor, error.along) + 1j * np.interp(at, error.motor, error.across))

    def trimmed(
        self,
        cam: PathMotion,
        leads: Leads,
        play: float,
        *,
        near: SteeringTrim | None = None,
        settled: float = _SETTLED,
    ) -> SteeringTrim:
        """Trim that brings the end of the run nearest to its planned place.

        Args:
            cam: lift that the follower gets.
            leads: stretches on which the cam leads.
            play: return error of the trial run, rad.
            near: trim of a similar car, to begin with.
            settled: last change of the trim by which it is found, in tan(beta).
        """
        trim = 0.0 if near is None else near.tan_beta
        rate = None if near is None else near.rate
        steered = self._steered(cam, leads, play)
        now = self._error(steered, trim)
        for _ in range(_TRIM_STEPS):
            ends = self.ends(now)
            if rate is None:
                rate = (self.ends(self._error(steered, trim + _PROBE)) - ends) / _PROBE
            step = -float(np.vdot(rate, ends).real / np.vdot(rate, rate).real)
            trim += step
            now = self._error(steered, trim)
            found = SteeringTrim(tan_beta=trim, error=now, rate=rate)
            if abs(step) < settled:
                break
            rate = None
        return found
