"""A track beside a transmission tells a gear off centre from an encoder off centre: the encoder moves no car.

Cars and records are those of the study of circles, whose generator shares nothing with the package's models.
"""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement.diagnosis import calibrate
from tests.studies.circles_truth import CELLS, DEG, TURN, Car, World, drawn_form

pytestmark = [pytest.mark.slow, pytest.mark.long]

STRAIGHT = Car(zero=0.3 * DEG, play=round(0.84 * DEG / TURN * CELLS))
RUNS_OUT = replace(STRAIGHT, runs_out=(0.2 * DEG, -0.2 * DEG))


@pytest.fixture(scope="module")
def world(synthetic_car):
    return World(synthetic_car.built, synthetic_car, drawn_form(np.random.default_rng(5)))


def numbers(told):
    return {v.name: v.value for f in told.findings for v in f.values}


def test_a_train_alone_cannot_tell_them(world, nominal):
    (told,) = calibrate([world.train(RUNS_OUT, np.random.default_rng(1))], nominal)
    assert "runout of shaft 2" in told.judgement.claimed
    assert "runout of shaft 2 from eccentric encoder on shaft 2" in told.judgement.sentence


@pytest.mark.parametrize(
    ("driven", "name", "number"),
    [
        (STRAIGHT, "eccentric encoder on shaft 2", "encoder"),
        (RUNS_OUT, "runout of shaft 2", "runout"),
    ],
)
def test_a_track_beside_it_does(world, nominal, driven, name, number):
    rng = np.random.default_rng(2)
    track, train = calibrate([world.track(driven, rng), world.train(RUNS_OUT, rng)], nominal)
    assert {"return error", name} == set(train.judgement.claimed)
    assert ("runout of shaft 2" in track.judgement.claimed) == (driven is RUNS_OUT)
    assert "encoder on shaft 2" not in train.judgement.sentence.replace(name, "")
    values = numbers(train)
    assert values[f"{number}_cos_deg"] == pytest.approx(0.2, abs=0.01)
    assert values[f"{number}_sin_deg"] == pytest.approx(-0.2, abs=0.01)
    assert numbers(track)["steering_zero_deg"] == pytest.approx(0.3, abs=0.005)
