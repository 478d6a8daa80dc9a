"""One effect in several kinds of data."""

import numpy as np
import pytest

from cadgen.measurement.nominal import calibrate
from cadgen.measurement.together import narrowed, shared
from tests.measurement import synthetic as syn


@pytest.fixture(scope="module")
def both(synthetic_car, nominal):
    """Lift and profile of one disc whose bore is off centre."""
    rng = np.random.default_rng(41)
    bench = syn.bench_with(syn.form_error(rng, 2e-3), {"shift": (0.03, 0.02)})
    records = [
        syn.lift_record(synthetic_car, bench, rng, noise_um=4.0),
        syn.profile_record(synthetic_car, bench, rng, noise_um=3.0),
    ]
    return calibrate(records, nominal)


def test_an_eccentric_bore_is_one_in_lift_and_profile(both):
    (bore,) = shared(both)
    assert bore.effect == "eccentric bore"
    assert bore.agrees
    alone = [v.sigma for d in both for v in d.findings[0].values]
    for value, truth in zip(bore.values, (30.0, 20.0), strict=True):
        assert value.value == pytest.approx(truth, abs=4 * value.sigma)
        assert value.sigma < min(alone)


def test_a_name_is_settled_by_another_record(both):
    lift, profile = both
    assert narrowed(lift, [profile]) == ("eccentric bore",)
    assert narrowed(lift, []) == ()
    assert shared([lift]) == ()
