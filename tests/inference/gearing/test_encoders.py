"""A joint with encoders at both ends, sampled at 1 kHz and thinned: play, a lag of a reading, part of a turn."""

import numpy as np
import pytest

from cadgen.inference.gearing.record_kinds import KINDS
from cadgen.inference.records.load import load
from tests.inference.gearing.test_train_errors import judged

RATIO = 61 / 20 * 64 / 21
PLAY = 0.4


def joint(motion, lag=0.0, wind=0.006, times=True, rate=50.0):
    """Record of a joint that friction holds within its play, beside a spring that it winds up by `wind` deg."""
    rng = np.random.default_rng(7)
    t = np.arange(0.0, 44.0, 1e-3)
    turned = motion(t)
    pushed = turned + 0.05 * np.sin(np.radians(turned) + 1.1) + 0.01 * np.sin(np.radians(turned * RATIO))
    out, sense = np.empty_like(pushed), np.empty_like(pushed)
    at, way = pushed[0], 0.0
    for k, here in enumerate(pushed):
        held = min(max(at, here - PLAY / 2), here + PLAY / 2)
        way = way if held == at else np.sign(held - at)
        out[k], sense[k] = held, way
        at = held
    out = np.interp(t - lag, t, out - wind * sense)
    rows = np.arange(0, len(t), round(1000 / rate))
    read = {
        "input_angle_deg": np.round((turned * RATIO)[rows], 3),
        "output_angle_deg": np.round(out[rows] + rng.normal(0, 0.001, len(rows)), 4),
    }
    return ({"t_s": t[rows]} if times else {}) | read


def swings(t):
    return 50 * np.sin(2 * np.pi * t / 13) + 18 * np.sin(2 * np.pi * t / 4.1 + 1) + 7 * np.sin(2 * np.pi * t / 1.9)


@pytest.mark.slow
@pytest.mark.parametrize("rate", [50.0, 10.0, 1000 / 300])
@pytest.mark.parametrize("lag", [0.0, 0.003])
def test_play_is_told_from_a_lag_at_every_rate_and_part_of_a_turn_names_no_order(rate, lag):
    result = judged(joint(swings, lag, rate=rate))
    errors = result.errors
    assert np.degrees(errors.play.value) == pytest.approx(PLAY + 0.012, abs=0.02 if lag else 0.005)
    assert not result.faults
    assert all(line.named for line in errors.lines)
    if lag:
        assert errors.lag.value == pytest.approx(lag, rel=0.2)
        assert "lag of the output's reading" in str(result)


def test_without_times_a_lag_may_be_play():
    result = judged(joint(swings, 0.003, times=False))
    assert result.errors.lag is None
    assert result.errors.play.value > np.radians(PLAY + 0.1)


def test_a_log_of_more_rows_than_can_be_judged_is_thinned(tmp_path):
    path = tmp_path / "log.csv"
    rows = "".join(f"{k},{k / 100},{k / 900}\n" for k in range(44_000))
    path.write_text("t_s,input_angle_deg,output_angle_deg\n" + rows)
    record = load(path, KINDS)
    np.testing.assert_allclose(record["t_s"], np.arange(0, 44_000, 3))
    assert "one row in 3 is used" in record.notes
