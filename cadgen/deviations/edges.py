"""Cost at the finish of rim edges that are broken more than designed, or worn."""

from dataclasses import replace
from math import degrees, inf

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.contact import rolling_step
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.motion.drive import drive, turns_of
from cadgen.car.motion.sampled import rolled_lift
from cadgen.car.path_motion import PathMotion
from cadgen.car.steering import Car
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.deviations.as_built import AsBuilt

MORE = 0.1  # mm: a hand with a file or a deburring tool takes that much without being asked
_STATIONS = 1200  # the difference of two runs then errs by 1e-3 mm
_STEPS = 1200  # of a turn; what is wanted is the difference of two
_TRIM_STEP = 1e-4  # rad, of the steering, by which the end of a run is differentiated
_TRIM_ROUNDS = 4  # of Gauss and Newton, from an end that is off by centimetres


def edges_check(
    lift: PathMotion, follower: LeaningRod, cut: ClosedCurve, as_built: AsBuilt, car: Car, travel: float
) -> Check:
    """Error at the end of the run with both edges broken by `MORE` beyond the design, before and after a trim.

    Both runs are without play: its jumps are the same in both. A trim is one constant added to the steering.

    Args:
        lift: lift that the profile is made for.
        follower: follower that rolls on the profile.
        cut: curve that is cut, mm.
        as_built: deviations of the disc in its making and on the car.
        car: dimensions of the car.
        travel: travel of the drive wheel's rim for one turn of the cam, mm.

    Returns:
        The error, mm, as a figure without a limit; its place has the error after the trim.
    """
    more = min(MORE, follower.land / 2)
    worn = replace(follower, inner=follower.inner + more, outer=follower.outer - more)
    theta, step = np.linspace(0.0, TURN, _STATIONS, endpoint=False), rolling_step(cut, follower)
    wanted, got = (
        rolled_lift(as_built.roll_new(cut, rod, theta, step), lift, blend_start=lift.blend_start)
        for rod in (follower, worn)
    )
    end = _end(wanted, car, travel)

    def off(trim: float) -> complex:
        return _end(got, replace(car, steering_zero=car.steering_zero + trim), travel) - end

    trim = 0.0
    for _ in range(_TRIM_ROUNDS):
        error, slope = off(trim), (off(trim + _TRIM_STEP) - off(trim - _TRIM_STEP)) / (2 * _TRIM_STEP)
        trim -= (error * slope.conjugate()).real / abs(slope) ** 2
    return Check(
        CheckCode.EDGES_BROKEN_MORE,
        f"edges broken {more:g} mm more",
        abs(off(0.0)),
        "mm",
        inf,
        Bound.MAX,
        f"at the finish; {abs(off(trim)):.1f} mm with the steering trimmed by {degrees(trim):.3f}°",
    )


def _end(lift: PathMotion, car: Car, travel: float) -> complex:
    """End of a run without play as x + iy, mm."""
    x, y = drive(lift, car, travel, steps=_STEPS * turns_of(lift.blend_start)).drive_wheel[-1].tolist()
    return complex(x, y)
