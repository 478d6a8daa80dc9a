"""Nothing is claimed beyond the evidence of the data, and their limits are stated."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.errors import FileError
from cadgen.inference.measurement.diagnosis import calibrate, weigh
from cadgen.inference.measurement.evidence import Noise
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.reservations import refuse_too_few, resolved, with_reservations
from cadgen.inference.measurement.verdict import Judgement, runs_disagree
from cadgen.inference.records.load import load

CLEAR = Judgement(verdict="traced", sentence="", claimed=("x",), reported=("x",), rivals=(), separate=())


@pytest.fixture(scope="module")
def lift(measured):
    """A cam without an effect: three runs of 341 readings forward and back."""
    return load(measured / "lift_c.csv")


class _Best:
    """A subset without effects."""

    effects = ()
    at_bound = ()

    def values(self):
        return []


def _limits(record, nominal):
    model = nominal.model(record)
    noise = Noise(np.full(len(model.rows.run), 4e-3), 0.0, 0.0, record.runs)
    return with_reservations(CLEAR, record, model, noise, _Best(), np.full(len(model.rows.run), 4e-3)).limits


def test_a_whole_turn_both_ways_has_no_limits(lift, nominal):
    assert _limits(lift, nominal) == ()


def test_what_is_missing_is_said(lift, nominal):
    coarse = lift.where((lift["cam_angle_deg"] % 10 == 0) & (lift.columns["direction"] == "forward"))
    one_way, few = _limits(coarse, nominal)
    assert "one direction only" in one_way
    assert "resolves up to 14 waves round the cam" in few
    (part,) = _limits(lift.where(lift["cam_angle_deg"] <= 200), nominal)
    assert part.startswith("only 200 degrees of the turn")


def test_a_rest_that_dwarfs_noise_and_form_error_names_nothing(lift, nominal):
    model = nominal.model(lift)
    rows = len(model.rows.run)
    noise = Noise(np.full(rows, 4e-3), 0.0, 0.0, 3)
    # Noise of 4 um and form error of 2 um make 4.5 um together.
    for left, verdict, claimed in ((0.012, "traced", ("x",)), (0.025, "ambiguous", ()), (0.050, "unexplained", ())):
        told = with_reservations(CLEAR, lift, model, noise, _Best(), np.full(rows, left))
        assert told.verdict == verdict
        assert told.claimed == claimed
        assert any("and so not claimed" in limit for limit in told.limits) == (left == 0.025)


def test_a_value_on_its_physical_bound_is_not_claimed(lift, nominal):
    model = nominal.model(lift)
    gain = next(e for e in model.catalogue if e.name == "lever gain")

    class AtBound(_Best):
        effects = (gain,)
        at_bound = ("gain_percent",)

    noise = Noise(np.full(len(model.rows.run), 4e-3), 0.0, 0.0, 3)
    judged = replace(CLEAR, claimed=("lever gain", "phase"))
    told = with_reservations(judged, lift, model, noise, AtBound(), np.zeros(len(model.rows.run)))
    assert told.claimed == ("phase",)
    assert "gain_percent of lever gain" in told.limits[-1]


def _judged(record, nominal, noise, best=None, chance=1.0):
    rows = len(noise.sigma)
    return with_reservations(CLEAR, record, nominal.model(record), noise, best or _Best(), np.zeros(rows), chance)


def test_noise_far_beyond_what_the_file_says_is_said_and_goes_by_the_runs(lift, nominal):
    # The file says 4 um: such figures are often wrong, and what the runs differ by is known.
    for sigma, said in ((0.0115, False), (0.0125, True)):
        told = _judged(lift, nominal, Noise(np.full(len(lift.run), sigma), 0.0, 0.0, 3))
        assert (told.verdict, told.claimed) == ("traced", ("x",))
        words = "differ by 12.5 um, but the file says that the instrument's noise is 4 um"
        assert any(words in limit for limit in told.limits) == said
    silent = replace(lift, remarks=())
    assert _judged(silent, nominal, Noise(np.full(len(lift.run), 0.0125), 0.0, 0.0, 3)).limits == ()


@pytest.mark.slow
@pytest.mark.long
def test_rows_out_of_order_claim_nothing(measured, nominal, blind):
    assert blind("transmission_a").verdict == "combination"
    record = load(measured / "transmission_a.csv")
    order = np.lexsort((record["motor_angle_deg"], record.run))
    shuffled = replace(record, columns={name: values[order] for name, values in record.columns.items()})
    (told,) = weigh([replace(shuffled, remarks=())], nominal.model).diagnoses()
    assert (told.verdict, told.judgement.claimed) == ("unexplained", ())
    assert "in the order in which they were measured" in told.judgement.sentence


def test_a_value_within_its_error_is_not_claimed(lift, nominal):
    bore = next(e for e in nominal.model(lift).catalogue if e.name == "eccentric bore")

    class Small(_Best):
        effects = (bore,)
        x = 0.0

        def values(self):
            return [(bore, np.array([self.x, -1e-3]), np.array([1e-3, 1e-3]))]

    noise, small = Noise(np.full(len(lift.run), 4e-3), 0.0, 0.0, 3), Small()
    judged = replace(CLEAR, claimed=("eccentric bore", "phase"))
    model = nominal.model(lift)
    for small.x, claimed in ((1.9e-3, ("phase",)), (2.1e-3, ("eccentric bore", "phase"))):
        assert with_reservations(judged, lift, model, noise, small, np.zeros(len(lift.run))).claimed == claimed


def test_six_effects_that_leave_more_than_noise_are_not_sure(lift, nominal):
    class Six(_Best):
        effects = nominal.model(lift).catalogue[:6]

    noise = Noise(np.full(len(lift.run), 4e-3), 0.0, 0.0, 3)
    for chance, claimed in ((0.02, ("x",)), (0.005, ())):
        told = _judged(lift, nominal, noise, Six(), chance)
        assert told.claimed == claimed
    assert told.verdict == "ambiguous"
    assert "more than 6 effects, so sizes are not sure" in told.sentence
    assert _judged(lift, nominal, noise, _Best(), 0.005).claimed == ("x",)


@pytest.mark.slow
def test_runs_at_angles_of_their_own_still_tell_their_noise(lift, nominal):
    # Every third reading, another third in each run: no two runs have an angle in common.
    own = lift.where(lift["cam_angle_deg"] % 3 == lift.run)
    (told,) = weigh([own], nominal.model).diagnoses()
    assert told.verdict == "none"
    assert told.residual.noise == pytest.approx(4.0, rel=0.15)


def test_readings_that_repeat_to_the_last_digit_have_the_noise_of_that_digit(lift, nominal):
    model = nominal.model(lift)
    still = Noise(np.zeros(len(model.rows.run)), 0.0, 0.0, 3)
    assert resolved(lift, still).rms == pytest.approx(1e-3 / np.sqrt(12))


def test_a_short_single_run_is_refused(lift, nominal):
    one = lift.only(np.array([0]))
    refuse_too_few(one, nominal.model(one))
    short = one.where(one["cam_angle_deg"] % 5 == 0)
    with pytest.raises(FileError, match="one run of 138 rows cannot tell noise from 90 orders"):
        refuse_too_few(short, nominal.model(short))


@pytest.mark.slow
def test_another_designs_lift_is_unexplained(lift, appendix_car):
    car = appendix_car
    other = Nominal(lift=car.lift, follower=car.follower, profile=car.actual.curve, car=car.car, track=car.track)
    (told,) = calibrate([lift.where(lift["cam_angle_deg"] % 4 == 0)], other)
    assert (told.verdict, told.judgement.claimed) == ("unexplained", ())
    assert "dwarfs every effect" in told.judgement.sentence
    assert told.residual.before > 400


@pytest.mark.slow
@pytest.mark.long
def test_a_run_left_out_has_the_harmonics_of_the_whole(measured, nominal):
    """Every tenth point: alone some runs resolve another order than all, and what the others repeat is taken off."""
    whole = load(measured / "profile_a.csv")
    thin = whole.where(np.arange(len(whole.run)) % 10 == 0)
    some = [np.array(runs) for runs in ([0], [1], [2], [0, 1], [0, 2], [1, 2], [0, 1, 2])]
    assert len({nominal.model(thin.only(runs)).resolved for runs in some}) > 1
    (told,) = calibrate([thin], nominal)
    assert told.residual.left_out.repeating > 0


def test_so_few_rows_that_nothing_is_left_tell_of_no_difference():
    rows = SimpleNamespace(runs=2, run=np.array([0, 0, 1, 1]), place=np.array([0.0, 1.0, 0.0, 1.0]))
    none = np.empty((4, 0))
    model = SimpleNamespace(
        rows=rows,
        offsets=np.eye(4),
        slip=np.empty(0),
        form=none,
        discrepancy=SimpleNamespace(columns=none),
    )
    part = SimpleNamespace(
        model=model,
        noise=SimpleNamespace(sigma=np.ones(4), correlation=0.0),
        residual=lambda active: np.array([1.0, -1.0, 2.0, 0.5]),
    )
    assert not runs_disagree(part, SimpleNamespace(active=[]))
