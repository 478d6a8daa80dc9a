"""Logs of a steered car that say little: what they cannot tell is not claimed."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.diagnosis import calibrate_logged
from cadgen.inference.measurement.record import Record
from cadgen.inference.measurement.runs_left_out import LEAST_RUNS
from cadgen.inference.measurement.verdict import SIGMAS, Judgement, sigmas_of, unclaimed, within_error
from cadgen.inference.records.load import load

WHEELBASE = 150.0
pytestmark = pytest.mark.usefixtures("tricycle")


def log(*, logged: float, true: float, seed: int, runs: int = 4, rows: int = 40, noise: float = 3.0) -> Record:
    """Runs with the wheel held, logged at one angle and standing at another, degrees; 20 mm a row."""
    rng = np.random.default_rng(seed)
    angle, travel = np.radians(true), 20.0
    heading = np.sin(angle) / WHEELBASE * travel * np.arange(rows)
    place = np.concatenate([[0.0], np.cumsum(travel * np.cos(angle) * np.exp(1j * heading))[:-1]])
    several = np.tile(place, runs) + rng.normal(0, noise, runs * rows) + 1j * rng.normal(0, noise, runs * rows)
    return Record(
        kind=kinds.kind_of("steered track"),
        columns={
            "t_s": np.tile(0.05 * np.arange(rows), runs),
            "distance_mm": np.tile(travel * np.arange(rows), runs),
            "steering_deg": np.full(runs * rows, logged),
            "x_mm": several.real,
            "y_mm": several.imag,
            "heading_deg": np.degrees(np.tile(heading, runs)) + rng.normal(0, 0.3, runs * rows),
        },
        run=np.repeat(np.arange(runs), rows),
        remarks=(),
        source="thin log",
    )


@pytest.mark.slow
def test_a_log_without_any_error_is_traced_to_nothing():
    told = calibrate_logged([log(logged=0.0, true=0.0, seed=1, rows=24, noise=0.0)], WHEELBASE)
    assert (told.verdict, told.judgement.claimed) == ("none", ())


# Of runs on a circle with the wheel logged straight ahead, what a fit says of the wheel is little more than its error.
@pytest.mark.slow
@pytest.mark.long
def test_constant_steering_claims_no_number_within_its_error(measured):
    circles = load(measured / "circles.csv").only(np.arange(LEAST_RUNS))
    some = {name: values[::10] for name, values in circles.columns.items()}
    held = replace(circles, columns={**some, "steering_deg": np.ones(len(circles.run[::10]))}, run=circles.run[::10])
    told = calibrate_logged([held], WHEELBASE)
    assert all(finding.within_error or finding.at_bound for finding in told.findings)
    assert told.judgement.claimed == ()
    assert told.verdict == "unexplained"


def test_of_few_runs_more_standard_deviations_are_asked_for():
    """Numbers that are nothing, with the deviation told from n runs, the largest of several looked at: vectorised."""
    rng = np.random.default_rng(16)
    for runs in (3, 4, 6, 10):
        drawn = rng.normal(size=(40_000, 7, runs))
        off = np.abs(drawn.mean(axis=2)) / (drawn.std(axis=2, ddof=1) / np.sqrt(runs))
        rates = [
            np.mean(off[:, 0] > sigmas_of(runs - 1)),
            np.mean(off.max(axis=1) > sigmas_of(runs - 1, 7)),
            np.mean(off[:, 0] > SIGMAS),
            np.mean(off.max(axis=1) > SIGMAS),
        ]
        print(f"{runs} runs: one {100 * rates[0]:.2f} %, of seven {100 * rates[1]:.2f} %; at two sigma {rates[2:]}")
        assert 0.042 < rates[0] < 0.049
        assert rates[1] < 0.049
        assert rates[2] > 0.07
    assert sigmas_of(1e9) == pytest.approx(SIGMAS, abs=1e-6)
    assert sigmas_of(0) == float("inf")


# A wheel that rolls farther than any that there can be: the values of runs left out agree, since all are held there.
@pytest.mark.slow
def test_numbers_on_their_bounds_are_not_claimed():
    made = log(logged=0.0, true=0.0, seed=2)
    told = calibrate_logged(
        [replace(made, columns=made.columns | {"distance_mm": 0.09 * made["distance_mm"]})], WHEELBASE
    )
    assert "wheel radius" not in told.judgement.claimed
    assert "wheel_radius_percent of wheel radius is on the bound of what can be" in " ".join(told.judgement.limits)


@pytest.mark.parametrize(
    ("values", "sigma", "unsure"),
    [
        ([9.0], [26.0], True),
        ([9.0], [4.4], False),
        ([9.0], [float("nan")], True),
        ([0.0], [0.0], True),
        ([20.0, 0.1], [0.5, 0.5], False),  # an eccentricity along x
        ([9.0, -3.0], [26.0, 0.5], True),
    ],
)
def test_components_of_one_thing_have_one_size(values, sigma, unsure):
    assert within_error(["mm"] * len(values), values, sigma) is unsure


def test_a_verdict_that_rests_on_an_unsure_number_is_ambiguous():
    sure = Judgement(
        verdict="combination",
        sentence="Traced to both.",
        claimed=("steering zero", "wheelbase"),
        reported=("steering zero", "wheelbase"),
        rivals=(),
        separate=(),
    )
    told = unclaimed(sure, ["wheelbase"], "within 2 standard deviations of nothing")
    assert (told.verdict, told.claimed) == ("ambiguous", ("steering zero",))
    assert "not sure of wheelbase" in told.sentence
    assert unclaimed(sure, ["lag of the steering"], "") is sure
