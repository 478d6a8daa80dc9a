"""Many cars of a design, made ready: the cam that is cut, rolled once, with everything that may be off about it."""

from collections.abc import Sequence

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.running.drive import STEPS
from cadgen.car.running.mechanics import Mechanics
from cadgen.design import variation
from cadgen.inference.monte_carlo.cars import Cars, nominal_cars
from cadgen.jobs.cam.cam_plan import CamPlan, comparison_of

_OUTLINE_STEP = 0.06  # mm; rolling errs by 0.01 um of lift


def fleet_of(
    plan: CamPlan, stations: Sequence[int], mechanics: Mechanics | None, play: float, grid: int = STEPS
) -> Cars:
    """The nominal car of a design, ready to be varied.

    Args:
        plan: of the cam that all cars have, planned with play.
        stations: steps of the run, `STEPS` to a turn that is begun, at which poses are wanted, in order; the last is
            the end of the run.
        mechanics: friction and drag of the nominal car; None if the rod slides freely.
        play: return error of the nominal car, rad.
        grid: cam angles of a turn on which the cars are integrated.
    """
    task = comparison_of(plan).task
    return nominal_cars(
        task.as_built.roll_new(plan.curve, task.follower, np.linspace(0.0, TURN, grid, endpoint=False), _OUTLINE_STEP),
        task.follower,
        task.car,
        task.length,
        plan.steering,
        task.planned(),
        wheel_radius=variation.wheel_radius(plan.car.design, task.length),
        play=play,
        stations=stations,
        mechanics=mechanics,
        expansion=variation.expansion(plan.car.design),
    )
