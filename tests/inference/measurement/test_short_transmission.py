"""Transmission of a part of a turn, as of a joint: play is found, though no shaft of the camshaft turns round."""

import numpy as np
import pytest

from cadgen.api.design import Design
from cadgen.api.measured import Measured


@pytest.mark.slow
def test_play_shows_in_a_part_of_a_turn():
    rng = np.random.default_rng(1)
    way = np.concatenate([np.arange(0, 140, 3.0), np.arange(140, 0, -3.0)])
    cam = way + 0.2 * (np.arange(len(way)) > 46)
    columns = {
        "run": np.repeat([1, 2, 3], len(way)),
        "motor_angle_deg": np.tile(45 * way, 3),
        "cam_angle_deg": np.concatenate([cam + rng.normal(0, 0.01, len(way)) for _ in range(3)]),
    }
    result = Design.load("carbon_free_car").calibrate(Measured(columns))
    text = " ".join(str(result).split())
    assert float(text.split("return_error_deg ")[1].split()[0]) == pytest.approx(0.2, abs=0.01)
