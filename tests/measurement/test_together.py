"""One thing in several kinds of data: known to the others, compared, and deciding between rivals."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.deviations.quantities import RETURN_ERROR
from cadgen.measurement.calibrate import calibrate
from cadgen.measurement.diagnose import diagnose
from cadgen.measurement.findings import Candidate, Finding, Value
from cadgen.measurement.kinds import TRACK, TRANSMISSION, ZONES
from cadgen.measurement.together import Claim, at_work, claims, no_play, settled, shared
from tests.measurement import synthetic as syn
from tests.measurement.synthetic_drive import Train, transmission_record


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
def together(records, nominal):
    """Both judged, the profile first and by itself."""
    return calibrate(records, nominal)


@pytest.fixture(scope="module")
def apart(records, nominal, together):
    """Each judged as if the other were not there."""
    return diagnose(records[0], nominal.model), together[1]


@pytest.mark.slow
def test_what_a_profile_explains_is_not_blamed_on_the_lift_again(together, apart):
    lift, profile = together
    assert profile.judgement.claimed == ("eccentric bore",)
    assert lift.known == ("eccentric bore",)
    assert (lift.verdict, lift.judgement.claimed) == ("none", ())
    # The lift alone says the same by its own data: 36 um of run-out move the rod by some 20 um rms.
    assert apart[0].judgement.claimed == ("eccentric bore",)
    assert apart[0].residual.before > 4 * lift.residual.before
    assert lift.residual.before < 1.3 * apart[0].residual.after


@pytest.mark.slow
def test_an_eccentric_bore_is_one_in_lift_and_profile(apart):
    found = [claim for told in apart for claim in claims(told)]
    (bore,) = shared(found)
    assert bore.quantity.name == "eccentric bore"
    assert bore.agrees
    alone = [v.sigma for claim in found for v in claim.finding.values]
    for value, truth in zip(bore.values, (30.0, 20.0), strict=True):
        assert value.value == pytest.approx(truth, abs=4 * value.sigma)
        assert value.sigma < min(alone)


def _play(effect, value, sigma=0.01):
    return Finding(effect, (Value("return_error_deg", value, sigma, "deg"),), (), ())


def test_play_is_one_thing_under_its_names():
    found = [Claim("a", TRACK, _play("backlash", 0.80)), Claim("b", TRANSMISSION, _play("return error", 0.82))]
    (play,) = shared(found)
    assert (play.quantity.name, play.agrees) == ("return error", True)
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
        Candidate(("lost motion by friction",), 0.0, (friction,)),
        Candidate(("backlash",), 1.0, (backlash,)),
        Candidate((), 90.0),
    )
    return replace(apart[0], judgement=judgement, findings=(friction,), candidates=candidates)


@pytest.mark.slow
def test_the_claim_of_another_record_decides_between_rivals(rivals):
    train = Claim("train", TRANSMISSION, _play("return error", 0.30))
    decided = settled(rivals, [train])
    assert decided is not None
    assert decided.by == (train,)
    assert [claim.finding.effect for claim in decided.claims] == ["backlash"]
    assert decided.claims[0].finding.values[0].value == 0.31
    assert decided.left == (("backlash",),)


@pytest.mark.slow
def test_a_value_that_does_not_agree_decides_nothing(rivals, apart):
    assert settled(rivals, [Claim("train", TRANSMISSION, _play("return error", 1.2))]) is None
    assert settled(rivals, []) is None
    assert settled(apart[1], [Claim("train", TRANSMISSION, _play("return error", 0.3))]) is None


@pytest.mark.slow
def test_what_a_lift_shows_beside_a_known_profile_is_the_shafts(synthetic_car, nominal):
    """The disc's bore is off by (30, -15) um, and the shaft under the dial by (40, 20) more."""
    rng = np.random.default_rng(43)
    form = syn.form_error(rng, 2e-3)
    disc, both = (syn.bench_with(form, {"shift": shift}) for shift in ((0.03, -0.015), (0.07, 0.005)))
    found = [
        claim
        for told in calibrate(
            [
                syn.lift_record(synthetic_car, both, rng, noise_um=4.0),
                syn.profile_record(synthetic_car, disc, rng, noise_um=3.0),
            ],
            nominal,
        )
        for claim in claims(told)
    ]
    assert [claim.quantity.name for claim in found] == ["run-out of the shaft", "eccentric bore"]
    assert shared(found) == ()
    for value, truth in zip(found[0].finding.values, (40.0, 20.0), strict=True):
        assert value.value == pytest.approx(truth, abs=4 * value.sigma)


def test_kinds_that_agree_have_their_mean_and_those_that_do_not_the_tracks_value():
    train, zones = (
        Claim("a", TRANSMISSION, _play("return error", 0.80)),
        Claim("b", ZONES, _play("return error", 0.9, 0.1)),
    )
    best, taken = at_work([zones, train])
    assert best is train
    assert taken.finding.values[0].value == pytest.approx((0.80 / 0.01**2 + 0.9 / 0.1**2) / (1 / 0.01**2 + 1 / 0.1**2))
    track = Claim("c", TRACK, _play("backlash", 1.2, 0.02))
    assert at_work([train, zones, track]) == (track, track)


@pytest.mark.slow
def test_a_train_without_play_is_known_to_have_none_only_if_it_was_turned_both_ways(synthetic_car, nominal):
    rng = np.random.default_rng(44)
    record = transmission_record(synthetic_car, Train(), rng, noise_deg=0.03)
    forward = np.tile(np.arange(721) < 361, record.runs)
    both, one_way = (diagnose(part, nominal.model) for part in (record, record.where(forward)))
    assert (both.verdict, one_way.verdict) == ("none", "none")
    claim = no_play(both.source, both.kind, both.unnamed[RETURN_ERROR], 0.96)
    assert claim.absent
    assert (claim.quantity.name, claim.finding.values[0].value) == ("return error", 0.0)
    assert 0 < claim.finding.values[0].sigma < 0.02
    assert no_play(one_way.source, one_way.kind, one_way.unnamed[RETURN_ERROR], 0.96) is None
    # Against a return error that the scatter hides nothing can be said.
    assert no_play(both.source, both.kind, both.unnamed[RETURN_ERROR], 0.02) is None
    # Where play is named, or a single run names nothing, there is no such claim.
    assert diagnose(record.only(np.array([0])), nominal.model).unnamed == {}
