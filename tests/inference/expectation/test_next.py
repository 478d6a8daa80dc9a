"""Advice on the next measurement: its linear algebra, and cars of which it is plain what they lack."""

from pathlib import Path

import numpy as np
import pytest

from cadgen.design import variation
from cadgen.design.load import load_design
from cadgen.deviations import catalogue
from cadgen.inference.expectation.linear import WhitenedRows
from cadgen.inference.measurement.kinds import LIFT, PROFILE, TRACK, TRANSMISSION
from cadgen.jobs.calibration import advice
from cadgen.jobs.calibration.advice import Advice
from cadgen.jobs.calibration.calibration import calibrate
from cadgen.jobs.calibration.cam_on_car import nominal_of
from cadgen.jobs.calibration.sources import Source
from tests.inference.measurement.synthetic import Car as Bed
from tests.studies.circles_truth import Car, World, drawn_form


@pytest.mark.parametrize("kind", ["LIFT", "PROFILE", "TRACK", "TRANSMISSION"])
def test_every_number_of_the_catalogue_has_a_usual_size(kind):
    orders = ("lobing", "waviness", "worn")  # members of families enter by what was found of them
    numbers = [p for effect in getattr(catalogue, kind).entries for p in effect.parameters]
    assert all(p.usual is not None for p in numbers if not p.name.startswith(orders))


def test_information_is_that_of_the_rows_with_datum_and_noise_in_their_covariance():
    rng = np.random.default_rng(3)
    columns, nuisance = rng.normal(size=(40, 5)), rng.normal(size=(40, 4))
    precision = np.array([0.3, 2.0, 50.0, 1e4])
    left, some = rng.normal(size=40), rng.random(40) < 0.5
    rows = WhitenedRows(lambda read: read, columns, nuisance, precision, np.linspace(0, 6, 40))
    whole = np.eye(40) + nuisance @ np.diag(1 / precision) @ nuisance.T
    np.testing.assert_allclose(rows.information(), columns.T @ np.linalg.inv(whole) @ columns, rtol=1e-4)
    np.testing.assert_allclose(rows.pull(left), columns.T @ np.linalg.inv(whole) @ left, rtol=1e-3, atol=1e-3)
    part = whole[np.ix_(some, some)]
    np.testing.assert_allclose(rows.information(some), columns[some].T @ np.linalg.inv(part) @ columns[some], rtol=1e-4)


@pytest.fixture(scope="module")
def design():
    return load_design()


@pytest.mark.slow
def test_of_a_car_of_which_nothing_is_known_the_run_itself_says_most(design):
    told = Advice.first(design, "actual").computed
    first, by = told.ranked[0], {entry.words: entry for entry in told.ranked}
    print(told.now, *(f"{e.end.mean:.0f} {e.words}" for e in told.ranked), sep="\n")
    assert first.kind is TRACK
    assert told.shrinks(first) > 0.8
    # The play is the largest of what [train] leaves open, and a lift says nothing of it.
    train = next(e for e in told.ranked if e.kind is TRANSMISSION)
    lift = next(e for e in told.ranked if e.kind is LIFT)
    assert told.shrinks(train) > 2 * abs(told.shrinks(lift))
    # A start against a stop says more than one by hand.
    stop = next(e for words, e in by.items() if "against a stop" in words)
    assert stop.end.mean < by["4 runs of the track before a camera"].end.mean
    assert told.rivals == ()


@pytest.mark.slow
@pytest.mark.long
def test_what_has_no_name_is_asked_of_the_kind_of_data_that_shows_it(design, carbon_free_car):
    """A track of a car whose disc has a dent of 0.3 mm."""
    world = World(carbon_free_car, Bed(carbon_free_car), drawn_form(np.random.default_rng(1)))
    record = world.track(Car(dent=(0.3, np.radians(130.0))), np.random.default_rng(2))
    sources = [Source(Path("track.csv"), record, "0")]
    told = calibrate(design, "actual", sources)
    assert told.diagnoses[0].verdict in ("partial", "untraced shape", "unexplained")
    found = Advice.after(told, design)
    ranking = found.computed
    print(ranking.now, *(f"{e.end.mean:.0f} {e.words}" for e in ranking.ranked), sep="\n")
    assert ranking.ranked[0].kind in (LIFT, PROFILE)
    assert ranking.shrinks(ranking.ranked[0]) > 0.5
    more = next(e for e in ranking.ranked if e.kind is TRACK)
    assert ranking.shrinks(more) < 0.1
    words = " ".join(map(str, found.report))
    assert "cam angles from" in words
    assert found.facts()["ranked"][0]["kind"] == ranking.ranked[0].kind.code


def test_tolerances_of_the_design_come_before_what_is_usual(design):
    nominal = nominal_of(design, "actual")
    prior = advice.prior_of(design, nominal, None)
    assert prior.spread["steering zero", "steering_zero_deg"] == pytest.approx(np.radians(0.02))
    least, most = variation.play_bands(design)["as-given"].ends
    assert prior.play == pytest.approx((least + most) / 2)
    assert prior.assumed == most
