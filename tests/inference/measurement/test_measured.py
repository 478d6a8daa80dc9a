"""The files in tests/data/measured.

What is in the blind files is not known here: their verdicts (docs/measurement.md) are pinned as a regression test, and
only what follows from the data themselves (noise, what is left on runs left out) is a check. The tricycle's runs are
real.
"""

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
    """The logged steering of this tractor is 5.6 times too small: no effect of a size that can be explains it."""
    told = calibrate_logged([load(measured / "forklift.csv")], 1400.0)
    assert (told.verdict, told.judgement.claimed, told.judgement.reported) == ("unexplained", (), ())
    assert told.residual.held_out > 300
    assert "path error of 350 mm, on runs of" in told.judgement.sentence
    assert "check scale and sign of the steering" in told.judgement.sentence


@pytest.mark.slow
@pytest.mark.long
def test_tricycle_is_traced_on_runs_left_out(measured):
    some = [load(measured / f"{name}.csv").only(np.arange(4)) for name in ("circles", "squares")]
    told = calibrate_logged(some, 150.0)
    assert told.judgement.claimed == ("steering zero", "wheel radius", "wheelbase")
    values = {v.name: v for f in told.findings for v in f.values}
    assert values["wheelbase_percent"].value == pytest.approx(4.4, abs=3 * values["wheelbase_percent"].sigma)
    assert told.residual.held_out < 50
    # On squares the wheel stands at 90 degrees in the corners: a gain in the wheelbase's place fails there.
    error = {frozenset(c.effects): c.score for c in told.candidates}
    with_base = error[frozenset({"steering zero", "wheelbase"})]
    assert error[frozenset({"steering zero", "steering gain"})] > 1.5 * with_base
    assert np.isfinite(list(error.values())).all()
