"""One thing in several kinds of data: one effect where they are judged together, compared where they are not."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.deviations.deviation import RETURN_ERROR, Place
from cadgen.errors import FileError
from cadgen.inference.measurement.claims import Claim, at_work, claims, no_play, shared
from cadgen.inference.measurement.diagnosis import calibrate, weigh
from cadgen.inference.measurement.findings import Finding, Value
from cadgen.inference.measurement.kinds import PROFILE, TRACK, TRANSMISSION, ZONES
from cadgen.jobs.calibration.new_cam import gone_with_the_disc
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement.synthetic_drive import Train, transmission_record


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
    """Both judged as of one car."""
    return calibrate(records, nominal)


@pytest.fixture(scope="module")
def lift_alone(records, nominal):
    """The lift judged as if there were no profile."""
    (told,) = weigh(records[:1], nominal.model).diagnoses()
    return told


@pytest.mark.slow
@pytest.mark.long
def test_what_two_records_show_is_one_effect_and_claimed_once(together, lift_alone):
    _, profile = together
    for told in together:
        assert told.judgement.claimed == ("eccentric bore",)
        assert [f.effect for f in told.findings] == ["eccentric bore"]
        assert told.findings[0].values == profile.findings[0].values
    (claim,) = [claim for told in together for claim in claims(told)]
    assert claim.kind is PROFILE
    for value, truth in zip(claim.finding.values, (30.0, 20.0), strict=True):
        assert value.value == pytest.approx(truth, abs=4 * value.sigma)
    # Alone the lift cannot tell whose it is; with the profile it is the disc's.
    assert lift_alone.findings[0].twins == ("run-out of the shaft",)
    assert claim.finding.twins == ()
    # And both know it better than the lift alone.
    assert all(b.sigma < a.sigma for a, b in zip(lift_alone.findings[0].values, claim.finding.values, strict=True))


def _play(effect, value, sigma=0.01):
    return Finding(effect, (Value("return_error_deg", value, sigma, "deg"),), (), ())


def test_play_is_one_thing_under_its_names():
    found = [Claim("a", TRACK, _play("backlash", 0.80)), Claim("b", TRANSMISSION, _play("return error", 0.82))]
    (play,) = shared(found)
    assert (play.deviation.name, play.agrees) == ("return error", True)
    assert play.values[0].value == pytest.approx(0.81)
    assert play.values[0].sigma == pytest.approx(0.01 / np.sqrt(2))
    (play,) = shared([found[0], replace(found[1], finding=_play("return error", 0.9))])
    assert not play.agrees
    assert shared(found[:1]) == ()


@pytest.mark.slow
@pytest.mark.long
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
    assert [claim.deviation.name for claim in found] == ["run-out of the shaft", "eccentric bore"]
    assert shared(found) == ()
    assert [v.value for v in found[1].finding.values] == pytest.approx([30.0, -15.0], abs=3.0)
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
    both, one_way = (weigh([part], nominal.model).diagnoses()[0] for part in (record, record.where(forward)))
    assert (both.verdict, one_way.verdict) == ("none", "none")
    claim = no_play(both.source, both.kind, both.unnamed[RETURN_ERROR], 0.96)
    assert claim.absent
    assert (claim.deviation.name, claim.finding.values[0].value) == ("return error", 0.0)
    assert 0 < claim.finding.values[0].sigma < 0.02
    assert no_play(one_way.source, one_way.kind, one_way.unnamed[RETURN_ERROR], 0.96) is None
    # Against a return error that the scatter hides nothing can be said.
    assert no_play(both.source, both.kind, both.unnamed[RETURN_ERROR], 0.02) is None
    # Where play is named, or a single run names nothing, there is no such claim.
    assert weigh([record.only(np.array([0]))], nominal.model).diagnoses()[0].unnamed == {}


def test_more_rows_than_one_model_can_hold_are_refused(records, nominal):
    many = [replace(record, source=f"{i}.csv") for i, record in enumerate(records)]
    rows = sum(len(record.run) for record in many)
    copies = -(-12_000 // rows)
    grown = [
        replace(
            record,
            columns={name: np.tile(values, copies) for name, values in record.columns.items()},
            run=np.concatenate([record.run + n * record.runs for n in range(copies)]),
        )
        for record in many
    ]
    with pytest.raises(FileError, match=r"0\.csv, 1\.csv: \d+ rows of 2 kinds, more than the 10000 .* one row in 2"):
        calibrate(grown, nominal)


@pytest.mark.slow
def test_of_many_runs_several_are_left_out_at_a_time(synthetic_car, nominal):
    rng = np.random.default_rng(8)
    few = syn.lift_record(synthetic_car, syn.bench_with(syn.form_error(rng, 2e-3), {}), rng, noise_um=4.0)
    thin = few.where(few["cam_angle_deg"] % 6 == 0)
    rows = len(thin.run)
    record = replace(
        thin,
        columns={name: np.tile(values, 4) for name, values in thin.columns.items()},
        run=np.concatenate([thin.run + n * thin.runs for n in range(4)]),
    )
    # Copies of runs would be runs without noise.
    record.columns["lift_mm"] = record["lift_mm"] + rng.normal(0, 4e-3, 4 * rows)
    steps: list[str] = []
    (told,) = weigh([record], nominal.model).diagnoses(steps.append)
    left_out = [step for step in steps if step.endswith("left out")]
    assert (record.runs, len(left_out)) == (12, 10)
    assert left_out[0].endswith("runs 1 to 2 left out")
    assert left_out[-1].endswith("run 12 left out")
    assert told.per_run.held_out.shape == (12,)
    assert told.residual.left_out.rms == pytest.approx(told.residual.after, rel=0.1)


def test_a_bore_that_track_and_profile_name_apart_goes_with_the_disc_in_both():
    """It stayed in the track's, and cars were expected to end 188-355 mm off that ended at 27-87."""
    numbers = (Value("x_mm", 0.03, 0.001, "mm"), Value("y_mm", 0.0, 0.001, "mm"))
    found = [Claim(kind.code, kind, Finding("eccentric bore", numbers, (), ())) for kind in (TRACK, PROFILE)]
    noted, part = zip(found, (Place.NOTED, Place.PART), strict=True)
    names = {("track", "eccentric bore"), ("profile", "eccentric bore")}
    assert gone_with_the_disc([TRACK, PROFILE], [noted, part]) == names
    assert gone_with_the_disc([TRACK, PROFILE], [noted]) == frozenset()
