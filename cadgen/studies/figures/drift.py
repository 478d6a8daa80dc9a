"""End of the run by play, to first order: closed, and so cheap enough to screen thousands of designs.

A cam that is cut for the middle of the band errs by half of the band's width d at either end. On a fall the car then
meets its turning rate f(theta + d) for f(theta), so a piece of the fall turns it by d df more, about the place Q where
that happens, and moves the end E of the run by d df J (E - Q), J a quarter turn (`cadgen.car.planner.sensitivity`):

    drift = d | sum over all falls of df J (E - Q) |.

The exact chain adds what is of higher order, what smoothing gains, and the jumps. On the paper's car this gives within
1 % of the exact chain's worst end.
"""

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.running.drive import drive, turns_of
from cadgen.car.steering import track_curvature, travel_ratio
from cadgen.design import cam_model
from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure

_STEPS = 720  # of a turn: the drift errs by some 0.01 %


def _drift(evaluated: Evaluated) -> float:
    design, lift = evaluated.design, evaluated.lift
    car, length = cam_model.car(design), cam_model.travel(design, evaluated.track)
    run = drive(lift, car, length, steps=_STEPS * turns_of(lift.blend_start))
    turning = length / TURN * track_curvature(run.tan_beta, car) * travel_ratio(run.tan_beta, car)
    place = run.drive_wheel @ np.array([1.0, 1j])
    lever = place[-1] - (place[1:] + place[:-1]) / 2
    falling = np.diff(run.tan_beta) < 0
    low, high = evaluated.band.ends
    return (high - low) / 2 * float(abs(np.sum(np.diff(turning)[falling] * lever[falling])))


DRIFT = Figure(
    code="drift_mm",
    meaning="end of the run by half of the band of play, to first order",
    of=_drift,
    resolution=0.1,
    cheap=True,
)
