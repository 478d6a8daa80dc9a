"""Made logs of vehicles of other sizes and scales: what they differ by, and runs that are not theirs."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.deviations.catalogue import TRACK
from cadgen.inference.measurement.diagnosis import calibrate_logged
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.odd_logs import odd_logs
from cadgen.inference.measurement.runs_left_out import LeftOut, LeftOutFit, among_rivals
from cadgen.inference.records.load import load
from tests.inference.measurement.synthetic_vehicle import Vehicle, drive

pytestmark = [pytest.mark.usefixtures("tricycle"), pytest.mark.slow, pytest.mark.long]

LORRY = Vehicle(wheelbase=1200.0, zero=1.0, longer=1.05, gain=4.0, marker=0.3 + 0j)


def found(record, wheelbase):
    told = calibrate_logged([record], wheelbase)
    return told, {v.name: v.value for f in told.findings for v in f.values}


def test_six_effects_of_a_vehicle_are_found_together():
    """The wheel turns a tenth of what was logged, and five effects beside it."""
    vehicle = Vehicle(zero=1.5, gain=0.1, radius=1.05, longer=1.06, lag=0.4, marker=0.4 + 0.1j)
    told, values = found(drive([vehicle] * 6, 1), 1200.0)
    assert len(told.judgement.claimed) == 6
    assert values["gain_percent"] == pytest.approx(-90.0, abs=0.1)
    assert values["steering_zero_deg"] == pytest.approx(1.5, abs=0.05)
    assert values["wheel_radius_percent"] == pytest.approx(5.0, abs=0.1)
    assert values["wheelbase_percent"] == pytest.approx(6.0, abs=1.0)
    assert values["lag_s"] == pytest.approx(0.4, abs=0.03)
    assert values["marker_ahead_mm"] == pytest.approx(480.0, abs=15.0)
    assert values["marker_left_mm"] == pytest.approx(120.0, abs=5.0)


@pytest.mark.parametrize(("gain", "seed"), [(0.1, 10), (10.0, 11), (-3.0, 12)])
def test_a_steering_off_by_a_factor_is_found_whatever_the_factor(gain, seed):
    told, values = found(drive([Vehicle(wheelbase=150.0, gain=gain, zero=1.0)] * 5, seed), 150.0)
    assert {"steering gain", "steering zero"} <= set(told.judgement.reported)
    assert values["gain_percent"] == pytest.approx(100 * (gain - 1), abs=max(abs(gain), 1.0))
    assert values["steering_zero_deg"] == pytest.approx(1.0, abs=0.1)


def spoilt(record, run, **factors):
    columns = {name: column.copy() for name, column in record.columns.items()}
    for name, factor in factors.items():
        columns[name][record.run == run] *= factor
    return replace(record, columns=columns)


@pytest.mark.parametrize(
    ("odd", "why", "seed"),
    [
        ({"x_mm": 0.1, "y_mm": 0.1}, "in cm and not in mm", 2),
        ({"steering_deg": np.pi / 180}, "in rad and not in deg", 3),
        ({}, "of another car", 5),
    ],
)
def test_one_bad_run_is_named_and_the_others_are_not(odd, why, seed):
    vehicles = [LORRY] * 6
    if not odd:
        vehicles[2] = replace(LORRY, zero=-4.0)
    record = spoilt(drive(vehicles, seed), 2, **odd)
    (number,) = told = odd_logs(record, LoggedCar(1200.0))
    assert number == 2
    assert why in told[number]


def test_no_good_run_is_left_out(measured):
    """Made runs on paths of their own, and the real ones, whole and few of them."""
    for seed in range(6):
        assert odd_logs(drive([LORRY] * (4 + seed % 3), 20 + seed, wander_deg=0.3), LoggedCar(1200.0)) == {}
    rng = np.random.default_rng(1)
    assert odd_logs(load(measured / "forklift.csv"), LoggedCar(1400.0)) == {}
    for name in ("circles", "squares"):
        record = load(measured / f"{name}.csv")
        assert odd_logs(record, LoggedCar(150.0)) == {}
        for _ in range(2):
            some = np.sort(rng.choice(record.runs, 4, replace=False))
            assert odd_logs(record.only(some), LoggedCar(150.0)) == {}


def test_what_rivals_say_of_a_number_widens_it():
    """Zero 1.0 and 1.4 in two rivals about 1.2: 0.2; what none of them has is as sure as before."""
    zero, other = TRACK.named("steering zero"), TRACK.named("wheel radius")

    def fit(effects, values):
        few = np.ones(4)
        return LeftOutFit(effects, np.array(values), np.full(len(values), 0.01), 3.0, (), few, few)

    rivals = (fit((zero,), [1.0]), fit((zero,), [1.4]))
    chosen = fit((zero, other), [1.2, 0.02])
    left_out = LeftOut(np.ones(4), 100.0, chosen, rivals, (chosen, *rivals))
    np.testing.assert_allclose(among_rivals(left_out), [0.2, 0.0], atol=1e-12)
