"""A train read with the rod on the cam: stepped by the forces of `tests.studies.friction_truth`."""

import numpy as np

from cadgen.inference.measurement.kinds import TRANSMISSION
from cadgen.inference.measurement.record import Record
from tests.inference.measurement.synthetic_drive import RATIOS
from tests.studies.friction_truth import CELLS, STEP_DEG, World


def rod_record(
    world: World, *, play: int, friction: float, rng: np.random.Generator, noise_deg: float = 0.03, runs: int = 3
) -> Record:
    """One turn forward in steps of a degree of the cam, and back, with the rod pressed on.

    Args:
        world: cam and rod.
        play, friction: in cells of a turn, and between rod and disc.
        rng: of the noise.
        noise_deg: of the inclinometer.
        runs: how often.
    """
    per = round(1 / STEP_DEG)
    ahead, back = (world.holds > friction).tolist(), (world.holds_back > friction).tolist()
    lower = np.concatenate([np.arange(361), np.arange(359, -1, -1)]) * per  # of the gap, in cells
    cam, seen = 0, []
    for start, stop in zip(np.append(lower[0], lower[:-1]), lower, strict=True):
        for low in range(start, stop + 1) if stop >= start else range(start, stop - 1, -1):
            cam = min(max(cam, low), low + play)
            while cam < low + play and ahead[cam % CELLS]:
                cam += 1
            while cam > low and back[(cam - 1) % CELLS]:
                cam -= 1
        seen.append(cam * STEP_DEG)
    motor = np.concatenate([np.arange(361), np.arange(359, -1, -1)]) * float(np.prod(RATIOS))
    readings = [
        np.round(np.array(seen) + rng.normal(0, 0.05) + rng.normal(0, noise_deg, len(seen)), 2) for _ in range(runs)
    ]
    return Record(
        kind=TRANSMISSION,
        columns={"motor_angle_deg": np.tile(motor, runs), "cam_angle_deg": np.concatenate(readings)},
        run=np.repeat(np.arange(runs), len(motor)),
        remarks=(),
        source="train with the rod on",
    )
