"""Doubts about names: those that are of several sizes over the turn, and records that no effect explains."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement.diagnosis import calibrate, weigh
from cadgen.inference.measurement.doubts import with_doubts
from cadgen.inference.measurement.hypothesis import Search, fit
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive

WAVES = ((3.3, 2 * syn.DEG, 0.3), (5.7, 2 * syn.DEG, 1.0))  # turns per turn of the cam, amplitude, phase


@pytest.mark.slow
def test_the_name_that_is_uneven_is_said_and_none_beside_it(synthetic_car, nominal):
    """A lever's gain that is there in the last third of the turn alone, beside a bore that is off centre all round."""
    rng = np.random.default_rng(51)
    bench = syn.bench_with(syn.form_error(rng, 2e-3), {"shift": (0.03, 0.02)})
    record = syn.lift_record(synthetic_car, bench, rng, noise_um=4.0)
    late = np.asarray(record["cam_angle_deg"], dtype=float) > 230
    lift = np.asarray(record["lift_mm"], dtype=float)
    changed = replace(record, columns={**record.columns, "lift_mm": lift * (1 + 0.02 * late)})
    for one, uneven in ((record, False), (changed, True)):
        joint = weigh([one], nominal.model).joint
        named = {e.name: e for e in joint.core}
        best = fit(joint, (named["eccentric bore"], named["lever gain"]), [], Search(joint.rows))
        first = weigh([one], nominal.model).judgement
        claimed = replace(first, claimed=("eccentric bore", "lever gain"), limits=())
        doubted = with_doubts(claimed, joint, best)
        assert bool(doubted.claimed) is not uneven
        why = "of another size in each part of the turn: lever gain"
        assert any(why in str(limit) for limit in doubted.limits) is uneven


@pytest.mark.slow
@pytest.mark.long
def test_a_record_that_nothing_explains_takes_no_name_from_another(synthetic_car, nominal):
    """A train of two waves of no whole order: nothing was claimed of the track beside it."""
    rng = np.random.default_rng(52)
    odd = drive.transmission_record(synthetic_car, drive.Train(waves=WAVES), rng, noise_deg=0.03)
    track = drive.track_record(synthetic_car, drive.Wheels(zero=0.7 * syn.DEG, radius=1.01), rng, noise_mm=3.0)
    alone = weigh([track], nominal.model).judgement
    assert set(alone.claimed) == {"steering zero", "wheel radius"}
    of_train, of_track = calibrate([odd, track], nominal)
    assert (of_train.verdict, of_train.apart, of_train.judgement.claimed) == ("unexplained", True, ())
    assert (of_track.verdict, of_track.apart, of_track.judgement.claimed) == (alone.verdict, False, alone.claimed)
    why = "synthetic train by itself is explained by no effect"
    assert any(why in str(limit) for limit in of_track.judgement.limits)
