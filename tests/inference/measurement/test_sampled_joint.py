"""Joint of a robot with encoders on both sides, read by a clock: its play is found however far the rows are thinned.

Steel gives before friction does, by 2 f / k in all, and no such record tells that from play: 0.4153 degrees in place of
0.4 here.
"""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.deviations.transmission import Turned, runout
from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.kinds.transmission import sampled, speeds_differ
from tests.inference.measurement.synthetic_joint import DEG, Arm, joint_record

PLAY = 0.4
ARMS = {
    "there and back": Arm(period=30.0),
    "sines": Arm(sines=True, period=30.0),
    "sines, late by 4 ms": Arm(sines=True, period=30.0, lag=0.004),
    "there and back, encoder wanders": Arm(period=30.0, wander=0.03),
    "sines, encoder wanders": Arm(sines=True, period=30.0, wander=0.03),
}
CASES = [
    pytest.param(name, rate, marks=[pytest.mark.slow, pytest.mark.long] if rate > 10 or "wanders" in name else [])
    for name in ARMS
    for rate in (50.0, 10.0, 10 / 3)
]


@pytest.mark.parametrize(("name", "rate"), CASES)
def test_play_is_found_at_every_rate(name, rate, nominal):
    arm = ARMS[name]
    (told,) = calibrate([joint_record(arm, np.random.default_rng(2), rate=rate)], nominal)
    values = {value.name: value.value for finding in told.findings for value in finding.values}
    print(f"{name}, {rate:.3g} Hz: {told.verdict}, {told.judgement.claimed}, {values}, {told.correlation:.2f}")
    assert told.verdict in ("traced", "combination")
    assert values["return_error_deg"] == pytest.approx(PLAY, abs=0.03)
    if not arm.wander:
        assert values["return_error_deg"] == pytest.approx(PLAY + 2 * arm.friction / arm.stiffness / DEG, abs=0.002)
        # In rows that are 1 / rate apart.
        assert values.get("lag_rows", 0.0) == pytest.approx(arm.lag * rate, abs=0.002)
    assert set(told.judgement.claimed) == {"return error"} | ({"lag of the encoder"} if arm.lag else set())


def test_soft_shafts_add_what_friction_winds_up(nominal):
    arm = replace(ARMS["sines"], stiffness=15_000.0, friction=10.0)
    (told,) = calibrate([joint_record(arm, np.random.default_rng(3), rate=10.0)], nominal)
    (value,) = told.findings[0].values
    assert value.value == pytest.approx(PLAY + 2 * 10.0 / 15_000.0 / DEG, abs=0.01)
    assert "wind-up under friction" in told.findings[0].twins


def test_a_weight_on_a_train_that_gives_is_a_runout_to_every_reading():
    """Torques k (asked - a) = w sin(a), solved by Newton's method; w / k is 0.02, so the rest is of order (w / k)^2."""
    asked, give = np.linspace(0, 2 * np.pi, 73), 0.02
    angle = asked.copy()
    for _ in range(5):
        angle -= (angle + give * np.sin(angle) - asked) / (1 + give * np.cos(angle))
    effect, at = runout("the camshaft", 1.0), Turned(turned=asked, torque=0 * asked)
    assert effect.act(asked, np.array([0.0, -give]), at) == pytest.approx(angle, abs=give**2)
    assert "twist under a weight that turns with the camshaft" in effect.twins
    assert len(runout("shaft 2", 3.0).twins) == 1


def test_readings_at_rest_are_no_samples():
    """One reading each degree, there and back, has no time; a sine has, and its speeds differ."""
    steps = np.concatenate([np.arange(0, 361, 1.0), np.arange(360, -1, -1.0)])
    run = np.zeros(len(steps), dtype=np.intp)
    assert not sampled(steps, run)
    assert not sampled(np.arange(0, 361, 1.0), run[:361])
    wave = np.sin(np.arange(200) * 2 * np.pi / 12)
    assert sampled(wave, run[:200])
    assert speeds_differ(wave, run[:200])
    assert not speeds_differ(steps, run)
