"""What it costs at the finish that the edges of the rim are broken more than the design says, or worn."""

from dataclasses import replace
from math import degrees, inf

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.contact import rolling_step
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.lift import LiftCurve
from cadgen.check import Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.deviations.as_built import AsBuilt
from cadgen.motion.drive import drive
from cadgen.motion.sampled import rolled_lift
from cadgen.steering.car import Car

MORE = 0.1  # mm: a hand with a file or a deburring tool takes that much without being asked
_STATIONS = 1200  # the difference of two runs then errs by 1e-3 mm
_STEPS = 1200  # of a run; what is wanted is the difference of two
_TRIM_STEP = 1e-4  # rad, of the steering, by which the end of a run is differentiated
_TRIM_ROUNDS = 4  # of Gauss and Newton, from an end that is off by centimetres


def edges_check(
    lift: LiftCurve, follower: LeaningRod, made: ClosedCurve, as_built: AsBuilt, car: Car, travel: float
) -> Check:
    """How far off the run ends with both edges broken by `MORE` beyond the design, and what a trim leaves of it.

    Both runs are without play: its jumps are the same in both. A trim is one constant added to the steering.

    Args:
        lift: that the profile is made for.
        follower: that rolls on it.
        made: the curve that is cut.
        as_built: what becomes of it in its making and on the car.
        car: in plan view.
        travel: of the drive wheel's rim for one turn of the cam, mm.

    Returns:
        A figure without a limit.
    """
    more = min(MORE, follower.land / 2)
    worn = replace(follower, inner=follower.inner + more, outer=follower.outer - more)
    theta, step = np.linspace(0.0, TURN, _STATIONS, endpoint=False), rolling_step(made, follower)
    wanted, got = (
        rolled_lift(as_built.roll_new(made, rod, theta, step), lift, blend_start=lift.blend_start)
        for rod in (follower, worn)
    )
    end = _end(wanted, car, travel)

    def off(trim: float) -> complex:
        return _end(got, replace(car, steering_zero=car.steering_zero + trim), travel) - end

    trim = 0.0
    for _ in range(_TRIM_ROUNDS):
        here, slope = off(trim), (off(trim + _TRIM_STEP) - off(trim - _TRIM_STEP)) / (2 * _TRIM_STEP)
        trim -= (here * slope.conjugate()).real / abs(slope) ** 2
    return Check(
        CheckCode.EDGES_BROKEN_MORE,
        f"edges broken {more:g} mm more",
        abs(off(0.0)),
        "mm",
        inf,
        "max",
        f"at the finish; {abs(off(trim)):.1f} mm with the steering trimmed by {degrees(trim):.3f}°",
    )


def _end(lift: LiftCurve, car: Car, travel: float) -> complex:
    """Where a run without play ends, in the plane of complex numbers, mm."""
    x, y = drive(lift, car, travel, steps=_STEPS).drive_wheel[-1].tolist()
    return complex(x, y)
