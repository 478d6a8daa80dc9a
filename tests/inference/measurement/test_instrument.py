"""Effects of instrument and part: twins in one record, told apart by a part that is turned on the machine."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.kinds import PROFILE
from cadgen.inference.measurement.record import join
from tests.inference.measurement import synthetic as syn


def _profiles(car, shear, seed=60):
    """The part as it lies and turned by a quarter, on a machine that reads x + shear y, mm."""
    rng = np.random.default_rng(seed)
    bench = syn.bench_with(syn.form_error(rng, 2e-3), {})
    records = []
    for clock in (0.2, 90.1):
        record = syn.profile_record(car, bench, rng, noise_um=2.0, runs=2, clock_deg=clock, turn=syn.TURN, scatter=0.0)
        x, y = record["x_mm"], record["y_mm"]
        records.append(replace(record, columns={"x_mm": x + shear * y, "y_mm": y}))
    return records


def test_a_scale_of_the_machine_is_no_likelier_for_shrinking_the_noise(synthetic_car, nominal):
    """A part that is 0.4 % too large, and a machine that reads 0.4 % too much, leave the same."""
    rng = np.random.default_rng(61)
    model = nominal.model(
        syn.profile_record(synthetic_car, syn.Bench(scale=(1.004, 1.004)), rng, noise_um=10.0, runs=1, scatter=0.0)
    )
    left = [
        np.sum(model.residual([(PROFILE.catalogue.named(name), np.array([0.004]))]) ** 2)
        for name in ("uniform scale", "scale of the measuring machine")
    ]
    assert left[0] == pytest.approx(left[1], rel=1e-4)


@pytest.mark.slow
def test_a_part_that_is_clamped_by_eye_is_not_turned(synthetic_car, nominal):
    """A scale of the part is named as that, with its twin, where the part lies a degree off."""
    rng = np.random.default_rng(62)
    bench = syn.bench_with(syn.form_error(rng, 2e-3), {"scale": (1.003, 0.9985)})
    (told,) = calibrate([syn.profile_record(synthetic_car, bench, rng, noise_um=8.0, clock_deg=1.1)], nominal)
    assert told.judgement.claimed == ("anisotropic scale",)
    assert told.findings[0].twins == ("axis scale of the measuring machine",)


@pytest.mark.slow
@pytest.mark.long
def test_a_turned_part_shows_whose_the_shear_is(synthetic_car, nominal):
    shear = 0.04 * syn.DEG
    straight, turned = _profiles(synthetic_car, shear)
    (one,) = calibrate([straight], nominal)
    assert one.judgement.claimed == ("axes out of square",)
    assert one.findings[0].twins == ("squareness of the measuring machine",)
    (both,) = calibrate([join([straight, turned])], nominal)
    assert both.judgement.claimed == ("squareness of the measuring machine",)
    (finding,) = both.findings
    assert finding.twins == ()
    assert finding.values[0].value == pytest.approx(0.04, abs=4 * finding.values[0].sigma)
    # The clocking of each run as the generator set it, a quarter of a turn with it.
    assert [f.values[0].value for f in both.datum] == pytest.approx([0.2, 0.2, 90.1, 90.1], abs=0.05)
