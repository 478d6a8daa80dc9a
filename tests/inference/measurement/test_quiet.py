"""A train by encoders of few counts, and one that lacks a tooth."""

import numpy as np
import pytest

from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.kinds import TRANSMISSION
from cadgen.inference.measurement.record import Record, refuse_impossible

PLAY_DEG = 0.8
MOTOR = np.concatenate([np.arange(361), np.arange(359, -1, -1)]) * 45.0


def _record(asked_deg, step_deg, noise_deg=0.0, runs=3):
    cam, out = asked_deg[0], []
    for angle in asked_deg:
        cam = min(max(cam, angle - PLAY_DEG / 2), angle + PLAY_DEG / 2)
        out.append(cam)
    rng = np.random.default_rng(4)
    readings = [np.round((out + rng.normal(0, noise_deg, len(out))) / step_deg) * step_deg for _ in range(runs)]
    columns = {"motor_angle_deg": np.tile(MOTOR, runs), "cam_angle_deg": np.concatenate(readings)}
    run = np.repeat(np.arange(runs), len(MOTOR))
    return Record(kind=TRANSMISSION, columns=columns, run=run, remarks=(), source="train.csv")


@pytest.mark.slow
def test_an_encoder_of_few_counts_may_read_the_same_in_every_run(nominal):
    record = _record(MOTOR / 45, 360 / 4096)
    first, second = (record["cam_angle_deg"][part] for part in record.parts[:2])
    np.testing.assert_array_equal(first, second)
    refuse_impossible(record)
    (told,) = calibrate([record], nominal)
    ((play,),) = (f.values for f in told.findings)
    print(told.verdict, play)
    assert (told.verdict, told.judgement.claimed) == ("traced", ("return error",))
    assert play.value == pytest.approx(PLAY_DEG, abs=3 * play.sigma)


@pytest.mark.slow
@pytest.mark.long
def test_a_missing_tooth_is_no_mistake_of_the_unit(nominal):
    """Of the wheel on the camshaft, 120 teeth: for the pitch of one the camshaft stays behind."""
    angle = MOTOR / 45
    behind = 1.5 * np.clip(1 - np.abs((angle - 100 + 180) % 360 - 180) / 3, 0, 1)
    (told,) = calibrate([_record(angle - behind, 0.01, 0.03)], nominal)
    print(told.verdict, told.judgement.sentence)
    assert told.verdict == "partial"
    assert "local bump near 100 deg" in told.judgement.sentence
    assert told.judgement.claimed == ("return error",)
    assert "unit" not in told.judgement.sentence
