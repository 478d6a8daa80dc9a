"""The files in tests/data/measured.

What is in the blind files is not known here: their verdicts (docs/measurement.md) are pinned as a regression test, and
only what follows from the data themselves (noise, what is left on runs left out) is a check. The tricycle's runs are
real.
"""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement.diagnosis import calibrate_logged
from cadgen.inference.records.load import load

pytestmark = pytest.mark.usefixtures("tricycle")
PINNED = {
    "lift_a": ("traced", ("eccentric bore",)),
    "lift_b": ("combination", ("lost motion by friction", "phase")),
    "lift_c": ("none", ()),
    "lift_d": ("untraced shape", ()),
    "lift_e": ("traced", ("lever gain",)),
    "profile_a": ("traced", ("cutter compensation",)),
    "profile_b": ("traced", ("anisotropic scale",)),
    "profile_c": ("traced", ("waviness, order 33",)),
    "profile_d": ("traced", ("eccentric bore",)),
    "track_a": ("traced", ("steering zero",)),
    "track_b": ("combination", ("backlash", "wheel radius")),
    "track_c": ("traced", ("backlash",)),
    "transmission_a": ("combination", ("return error", "runout of shaft 2")),
    "transmission_b": ("combination", ("rate", "return error")),
    "transmission_c": ("traced", ("return error",)),
}
# Stated by the files' own comment lines.
NOISE = {"lift": 4.0, "profile": 2.0, "track": 3.0, "transmission": 0.03}


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(PINNED))
def test_blind_files(name, blind):
    told = blind(name)
    assert (told.verdict, told.judgement.claimed) == PINNED[name]
    noise = NOISE[name.split("_")[0]]
    assert told.residual.noise == pytest.approx(noise, rel=0.06)
    assert told.residual.left_out.repeating < 1.06 * noise


@pytest.mark.slow
@pytest.mark.long
def test_few_logged_runs_name_nothing(measured):
    circles = load(measured / "circles.csv")
    for runs, words in ((1, "one run only"), (2, "2 runs only")):
        told = calibrate_logged([circles.only(np.arange(runs))], 150.0)
        assert (told.verdict, told.judgement.claimed) == ("ambiguous", ())
        assert told.judgement.limits[0].startswith(words)
        assert told.residual.held_out >= told.residual.after


@pytest.mark.slow
def test_a_path_error_that_no_effect_lowers_is_unexplained(measured):
    """Where the steering is that of other runs, no effect of a size that can be explains it."""
    record = load(measured / "forklift.csv")
    turned = replace(record, columns=record.columns | {"steering_deg": record["steering_deg"][::-1]})
    told = calibrate_logged([turned], 1400.0)
    assert (told.verdict, told.judgement.claimed, told.judgement.reported) == ("unexplained", (), ())
    assert told.residual.held_out > 300
    assert " mm, on runs of" in told.judgement.sentence
    assert "check scale and sign of the steering" in told.judgement.sentence


@pytest.mark.slow
@pytest.mark.long
def test_a_steering_logged_in_another_scale_and_a_marker_far_off_are_found(measured):
    """The log of this tractor has a fifth of the steering; a fit of six numbers by other code leaves 83 mm."""
    record = load(measured / "forklift.csv")
    turned = replace(record, columns=record.columns | {"steering_deg": -record["steering_deg"]})
    (gain,) = (v.value for f in calibrate_logged([turned], 1400.0).findings for v in f.values if "gain" in v.name)
    assert gain == pytest.approx(-660.0, abs=40.0)  # with the other sign
    told = calibrate_logged([record], 1400.0)
    values = {v.name: v.value for f in told.findings for v in f.values}
    assert values["gain_percent"] == pytest.approx(460.0, abs=40.0)
    assert values["marker_ahead_mm"] == pytest.approx(260.0, abs=50.0)
    assert told.residual.before > 340
    assert told.residual.held_out < 60
    assert "steering gain" in told.judgement.claimed
    assert "offset of the markers" in told.judgement.reported
    few = "within 6.8 standard deviations of nothing, which 4 runs cannot tell from chance, and so not claimed: "
    assert any(few in limit for limit in told.judgement.limits)


@pytest.mark.slow
@pytest.mark.long
def test_tricycle_is_traced_on_runs_left_out(measured):
    some = [load(measured / f"{name}.csv").only(np.arange(4)) for name in ("circles", "squares")]
    told = calibrate_logged(some, 150.0)
    assert told.judgement.claimed == ("steering zero", "wheelbase")
    values = {v.name: v for f in told.findings for v in f.values}
    assert values["wheelbase_percent"].value == pytest.approx(4.4, abs=3 * values["wheelbase_percent"].sigma)
    assert told.residual.held_out < 30  # 40 with camera and log each by its own clock
    assert any("camera and log differ in 8 of 8 runs" in limit for limit in told.judgement.limits)
    # On squares the wheel stands at 90 degrees in the corners: a gain in the wheelbase's place fails there.
    error = {frozenset(c.effects): c.score for c in told.candidates}
    with_base = error[frozenset({"steering zero", "wheelbase"})]
    assert error[frozenset({"steering zero", "steering gain"})] > 1.5 * with_base
    assert np.isfinite(list(error.values())).all()
