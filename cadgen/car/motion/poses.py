"""A run of the car as the poses that a course is held against."""

import numpy as np

from cadgen.car.course.body import Poses
from cadgen.car.motion.drive import Run
from cadgen.car.steering import Car, wheel_tangent


def poses_of(run: Run, car: Car) -> Poses:
    """Poses of a run.

    Args:
        run: run of the car, with what happens between its steps.
        car: the car that ran.
    """
    drive_wheel, fork = (wheel[:, 0] + 1j * wheel[:, 1] for wheel in (run.drive_wheel, run.front_wheel))
    return Poses(
        fork=fork,
        heading=run.heading,
        steering=-np.arctan(wheel_tangent(run.tan_beta, car)),
        travel=np.concatenate([[0.0], np.cumsum(np.abs(np.diff(drive_wheel)))]),
    )
