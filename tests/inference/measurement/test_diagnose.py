"""Verdicts on a small slice of synthetic cases; several thousand are a study of their own (tests.studies.rates)."""

import numpy as np
import pytest

from cadgen.errors import DesignError
from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.kinds import LIFT
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Record
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive

FORM = 2e-3


def _lift(
    car: syn.Car, seed: int, *, noise_um: float = 4.0, index_deg: float = 0.01, runs: int = 3, **changes: object
) -> Record:
    rng = np.random.default_rng(seed)
    bench = syn.bench_with(syn.form_error(rng, FORM), changes)
    return syn.lift_record(car, bench, rng, noise_um=noise_um, index_deg=index_deg, runs=runs)


@pytest.mark.slow
def test_nothing_is_found_where_nothing_is(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 21, index_deg=0.0)], nominal)
    assert told.verdict == "none"
    assert told.judgement.claimed == told.judgement.reported == ()
    assert told.residual.before == told.residual.after
    assert told.residual.noise == pytest.approx(4.0, rel=0.06)


@pytest.mark.slow
def test_one_effect_is_traced_with_its_size(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 22, shift=(0.02, -0.03))], nominal)
    assert told.verdict == "traced"
    (finding,) = told.findings
    assert finding.effect == "eccentric bore"
    for value, truth in zip(finding.values, (20.0, -30.0), strict=True):
        assert value.value == pytest.approx(truth, abs=4 * value.sigma)
        assert value.sigma < 1.5
    assert told.residual.before > 4 * told.residual.left_out.rms
    assert told.residual.left_out.repeating < 1.15 * told.residual.noise


@pytest.mark.slow
def test_two_effects_are_both_named(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 23, phase=0.3 * syn.DEG, friction=0.012)], nominal)
    assert told.verdict == "combination"
    assert told.judgement.claimed == ("lost motion by friction", "phase")


@pytest.mark.slow
def test_twins_are_told_as_rivals_with_what_separates_them(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 24, noise_um=10.0, gain=1.004)], nominal)
    assert told.verdict == "ambiguous"
    assert told.judgement.claimed == ()
    assert set(told.judgement.reported) == {"axial offset", "lever gain"}
    assert any("gauge blocks" in way for way in told.judgement.separate)


@pytest.mark.slow
def test_a_dent_is_no_effect_but_a_shape_with_place_and_size(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 25, dent=(205 * syn.DEG, 3 * syn.DEG, 0.04))], nominal)
    assert told.verdict == "untraced shape"
    assert told.judgement.claimed == ()
    values = {v.name: v.value for v in told.findings[0].values}
    assert values["centre_deg"] == pytest.approx(205, abs=2)
    assert values["height_um"] == pytest.approx(-40, rel=0.2)


@pytest.mark.slow
def test_an_effect_beside_a_dent_is_partial(synthetic_car, nominal):
    record = _lift(synthetic_car, 26, shift=(0.06, 0.0), dent=(205 * syn.DEG, 3 * syn.DEG, 0.03))
    (told,) = calibrate([record], nominal)
    assert told.verdict == "partial"
    assert told.judgement.claimed == ("eccentric bore",)


@pytest.mark.slow
def test_one_run_claims_nothing(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 27, runs=1, shift=(0.03, 0.0))], nominal)
    assert told.verdict == "ambiguous"
    assert told.judgement.claimed == ()
    assert "eccentric bore" in told.judgement.reported
    assert "one run only" in told.judgement.limits[0]


@pytest.mark.slow
@pytest.mark.long
def test_runs_that_disagree_claim_nothing(synthetic_car, nominal):
    record = _lift(synthetic_car, 28)
    angle = np.radians(record["cam_angle_deg"])
    odd = record["lift_mm"] + (record.run == 1) * 0.03 * np.sin(2 * angle) * np.cos(angle)
    record = Record(
        kind=LIFT, columns={**record.columns, "lift_mm": odd}, run=record.run, remarks=(), source="one odd run"
    )
    (told,) = calibrate([record], nominal)
    assert told.verdict == "runs disagree"
    assert told.judgement.claimed == ()


@pytest.mark.slow
@pytest.mark.long
def test_profile_and_transmission_and_track(synthetic_car, nominal):
    rng = np.random.default_rng(30)
    bench = syn.bench_with(syn.form_error(rng, FORM), {"lobes": (3, 0.015, 1.0)})
    records = [
        syn.profile_record(synthetic_car, bench, rng, noise_um=3.0),
        drive.transmission_record(synthetic_car, drive.Train(play=0.8 * syn.DEG), rng, noise_deg=0.03),
        drive.track_record(synthetic_car, drive.Wheels(zero=0.2 * syn.DEG, radius=1.01), rng, noise_mm=3.0),
    ]
    profile, train, track = calibrate(records, nominal)
    # No car has them all: the disc of the track is round and its train has no play.
    assert all("contradict each other" in " ".join(d.judgement.limits) for d in (profile, train, track))
    assert profile.judgement.claimed == ("lobing, order 3",)
    assert train.judgement.claimed == ("return error",)
    assert train.findings[0].values[0].value == pytest.approx(0.8, abs=0.01)
    assert track.judgement.claimed == ("steering zero", "wheel radius")
    assert [f.effect for f in profile.datum] == [f"clocking, run {k}" for k in (1, 2, 3)]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "changes", "size"),
    [("cutter compensation", {"offset": -0.03}, -30.0), ("uniform scale", {"scale": (0.997, 0.997)}, -0.3)],
)
def test_an_error_of_size_shows_all_round_however_each_run_was_clamped(name, changes, size, synthetic_car, nominal):
    rng = np.random.default_rng(32)
    bench = syn.bench_with(syn.form_error(rng, FORM), changes)
    record = syn.profile_record(synthetic_car, bench, rng, noise_um=2.0, turn=syn.TURN, scatter=0.3 * syn.DEG)
    (told,) = calibrate([record], nominal)
    assert told.verdict == "traced"
    assert told.judgement.claimed == (name,)
    assert told.findings[0].values[0].value == pytest.approx(size, rel=0.02)
    assert told.residual.noise == pytest.approx(2.0, rel=0.06)
    assert told.residual.left_out.repeating < 1.05 * told.residual.noise
    # Each run is told as it was clamped: noise is taken off, the clocking is the generator's draw.
    assert np.ptp([f.values[0].value for f in told.datum]) > 0.1


@pytest.mark.slow
def test_a_dial_that_lags_by_direction_is_its_hysteresis(synthetic_car, nominal):
    record = _lift(synthetic_car, 33)
    back = record.columns["direction"] == "reverse"
    lagging = np.round(record["lift_mm"] + 0.02 * back, 3)
    record = Record(
        kind=LIFT, columns={**record.columns, "lift_mm": lagging}, run=record.run, remarks=(), source="lagging dial"
    )
    (told,) = calibrate([record], nominal)
    assert told.judgement.claimed == ("hysteresis of the dial",)
    assert told.findings[0].values[0].value == pytest.approx(20.0, abs=1.0)


@pytest.mark.slow
def test_a_dial_with_an_uneven_scale_is_said_beside_its_tilt(synthetic_car, nominal):
    (told,) = calibrate([_lift(synthetic_car, 34, square=0.0015)], nominal)
    assert told.judgement.claimed == ("tilted indicator",)
    assert "cannot tell tilted indicator from a dial whose scale is not even" in told.judgement.sentence


def test_a_transmission_needs_a_train(synthetic_car, nominal):
    rng = np.random.default_rng(31)
    record = drive.transmission_record(synthetic_car, drive.Train(), rng, noise_deg=0.03)
    bare = Nominal(
        lift=nominal.lift,
        follower=nominal.follower,
        profile=nominal.profile,
        car=nominal.car,
        track=nominal.track,
    )
    with pytest.raises(DesignError, match="no gear train"):
        calibrate([record], bare)
