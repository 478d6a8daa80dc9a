"""One thing in several kinds of data: known to the others, compared, and deciding between rivals."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.measurement.diagnose import Candidate, Finding, Value, diagnose
from cadgen.measurement.nominal import calibrate
from cadgen.measurement.together import Claim, claims, settled, shared
from tests.measurement import synthetic as syn


@pytest.fixture(scope="module")
def records(synthetic_car):
    """Lift and profile of one disc whose bore is off centre."""
    rng = np.random.default_rng(41)
    bench = syn.bench_with(syn.form_error(rng, 2e-3), {"shift": (0.03, 0.02)})
    return [
        syn.lift_record(synthetic_car, bench, rng, noise_um=4.0),
        syn.profile_record(synthetic_car, bench, rng, noise_um=3.0),
    ]


@pytest.fixture(scope="module")
def apart(records, nominal):
    """Each judged as if the other were not there."""
    return tuple(diagnose(record, nominal.model) for record in records)


def test_what_a_profile_explains_is_not_blamed_on_the_lift_again(records, nominal, apart):
    lift, profile = calibrate(records, nominal)
    assert profile.judgement.claimed == ("eccentric bore",)
    assert lift.known == ("eccentric bore",)
    assert (lift.verdict, lift.judgement.claimed) == ("none", ())
    # The lift alone says the same by its own data: 36 um of run-out move the rod by some 20 um rms.
    assert apart[0].judgement.claimed == ("eccentric bore",)
    assert apart[0].residual.before > 4 * lift.residual.before
    assert lift.residual.before < 1.3 * apart[0].residual.after


def test_an_eccentric_bore_is_one_in_lift_and_profile(apart):
    found = [claim for told in apart for claim in claims(told)]
    (bore,) = shared(found)
    assert bore.thing == "eccentric bore"
    assert bore.agrees
    alone = [v.sigma for claim in found for v in claim.finding.values]
    for value, truth in zip(bore.values, (30.0, 20.0), strict=True):
        assert value.value == pytest.approx(truth, abs=4 * value.sigma)
        assert value.sigma < min(alone)


def _play(effect, value, sigma=0.01):
    return Finding(effect, (Value("return_error_deg", value, sigma, "deg"),), (), ())


def test_play_is_one_thing_under_its_names():
    found = [Claim("a", "track", _play("backlash", 0.80)), Claim("b", "transmission", _play("return error", 0.82))]
    (play,) = shared(found)
    assert (play.thing, play.agrees) == ("return error", True)
    assert play.values[0].value == pytest.approx(0.81)
    assert play.values[0].sigma == pytest.approx(0.01 / np.sqrt(2))
    (play,) = shared([found[0], replace(found[1], finding=_play("return error", 0.9))])
    assert not play.agrees
    assert shared(found[:1]) == ()


@pytest.fixture(scope="module")
def rivals(apart):
    """An ambiguous lift: backlash, or friction with a phase; made up, since only names and values matter here."""
    friction = Finding("lost motion by friction", (Value("lost_motion_um", 5.0, 0.2, "um"),), (), ())
    backlash = _play("backlash", 0.31, 0.02)
    judgement = replace(
        apart[0].judgement,
        verdict="ambiguous",
        claimed=(),
        reported=("backlash", "lost motion by friction"),
        rivals=(("backlash",),),
    )
    candidates = (
        Candidate(("lost motion by friction",), 0.0, 0.0, (friction,)),
        Candidate(("backlash",), 1.0, 1.0, (backlash,)),
        Candidate((), 90.0, 90.0),
    )
    return replace(apart[0], judgement=judgement, findings=(friction,), candidates=candidates)


def test_the_claim_of_another_record_decides_between_rivals(rivals):
    train = Claim("train", "transmission", _play("return error", 0.30))
    decided = settled(rivals, [train])
    assert decided is not None
    assert decided.by == (train,)
    assert [claim.finding.effect for claim in decided.claims] == ["backlash"]
    assert decided.claims[0].finding.values[0].value == 0.31
    assert decided.left == (("backlash",),)


def test_a_value_that_does_not_agree_decides_nothing(rivals, apart):
    assert settled(rivals, [Claim("train", "transmission", _play("return error", 1.2))]) is None
    assert settled(rivals, []) is None
    assert settled(apart[1], [Claim("train", "transmission", _play("return error", 0.3))]) is None
