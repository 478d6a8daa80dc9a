"""Errors that repeat over logged runs of one path are said with their size; those that differ by chance are not."""

import numpy as np
import pytest

from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.diagnosis import calibrate_logged
from cadgen.inference.measurement.record import Record
from cadgen.inference.measurement.repeats import STATIONS, one_path, repeats
from cadgen.inference.records.load import load

WHEELBASE = 150.0
SQUARE = 1000 * np.interp(np.linspace(0, 4, STATIONS), range(5), np.arange(5) % 2 * 1.0) + 1000j * np.interp(
    np.linspace(0, 4, STATIONS), range(5), [0, 0, 1, 1, 0]
)


def walks(rng: np.random.Generator, runs: int) -> list[np.ndarray]:
    """Random walks of both coordinates with their straight line taken out, as errors of runs are, some 30 mm."""
    along = np.linspace(0, 1, STATIONS)
    out = np.cumsum(rng.normal(0, 10, (runs, STATIONS)) + 1j * rng.normal(0, 10, (runs, STATIONS)), axis=1)
    return [z - z[0] - along * (z[-1] - z[0]) for z in out]


@pytest.mark.parametrize("runs", [3, 4, 7])
def test_errors_that_differ_by_chance_do_not_repeat(runs):
    rng = np.random.default_rng(runs)
    false = sum(bool(repeats([SQUARE] * runs, walks(rng, runs))) for _ in range(100))
    print(f"{runs} runs: {false} of 100 by chance")
    assert false <= 3


def test_a_common_error_is_found_with_its_size_and_place_however_runs_are_turned():
    rng = np.random.default_rng(5)
    bump = 80 * np.exp(-(((np.linspace(0, 1, STATIONS) - 0.4) / 0.1) ** 2))
    turns = np.exp(1j * rng.uniform(-3, 3, 5))
    left = [t * (bump + noise / 3) for t, noise in zip(turns, walks(rng, 5), strict=True)]
    paths = [t * SQUARE for t in turns] + [np.conj(SQUARE)]
    assert one_path(paths) == [[0, 1, 2, 3, 4], [5]]
    (found,) = repeats(paths, [*left, bump + 0j])
    assert found.rms == pytest.approx(float(np.sqrt(np.mean(bump**2))), rel=0.15)
    assert found.size == pytest.approx(80, rel=0.15)
    assert found.place == pytest.approx(0.4, abs=0.05)
    assert found.runs == (0, 1, 2, 3, 4)
    assert found.most


def log(*, kick_deg: float, paths: int) -> Record:
    """Runs along waves whose heading jumps at 40 % of the way where nothing was logged; noise 1 mm."""
    rng, runs, rows = np.random.default_rng(2), 4, 300
    columns: dict[str, list[np.ndarray]] = {}
    for run in range(runs):
        travel = 8.0 * np.arange(rows)
        logged = np.radians(25.0) * np.sin(travel / (150.0 + 60.0 * (run % paths)))
        turn = np.sin((logged[1:] + logged[:-1]) / 2) * 8.0 / WHEELBASE
        turn[int(0.4 * rows)] += np.radians(kick_deg)
        heading = np.append(0.0, np.cumsum(turn))
        steps = np.cos((logged[1:] + logged[:-1]) / 2) * 8.0 * np.exp(1j * (heading[1:] - turn / 2))
        place = np.append(0.0, np.cumsum(steps)) + rng.normal(0, 1, rows) + 1j * rng.normal(0, 1, rows)
        values = {
            "t_s": 0.05 * np.arange(rows),
            "distance_mm": travel,
            "steering_deg": np.degrees(logged),
            "x_mm": place.real,
            "y_mm": place.imag,
            "heading_deg": np.degrees(heading),
        }
        for name, value in values.items():
            columns.setdefault(name, []).append(value)
    return Record(
        kind=kinds.kind_of("steered track"),
        columns={name: np.concatenate(values) for name, values in columns.items()},
        run=np.repeat(np.arange(runs), rows),
        remarks=(),
        source="made log",
    )


@pytest.mark.slow
@pytest.mark.usefixtures("tricycle")
def test_an_error_that_repeats_is_not_said_to_be_nothing():
    """A ridge on the floor turns the car by 15 degrees in each run: no effect has that, and noise has it not either.

    A steering zero of 1.7 degrees takes most of it, and each run left out says so, for the others have the ridge, too.
    """
    told = calibrate_logged([log(kick_deg=15.0, paths=1)], WHEELBASE)
    assert told.judgement.claimed == ()
    assert any("something that no effect of the catalogue makes" in limit for limit in told.judgement.limits)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.usefixtures("tricycle")
def test_nothing_is_none_only_where_a_path_was_driven_several_times():
    clean = log(kick_deg=0.0, paths=1)
    assert calibrate_logged([clean], WHEELBASE).verdict == "none"
    told = calibrate_logged([log(kick_deg=0.0, paths=4)], WHEELBASE)
    assert told.verdict == "ambiguous"
    assert "what repeats cannot be told from noise" in told.judgement.limits[-1]


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.usefixtures("tricycle")
def test_what_repeats_widens_what_is_said_of_real_runs(measured):
    """On circles of one direction 30 of 31 mm repeat over four runs; the numbers of all directions hold less well."""
    told = calibrate_logged([load(measured / "circles.csv")], WHEELBASE)
    assert any("on runs 2, 4, 6, 8" in limit for limit in told.judgement.limits)
    sigma = {value.name: value.sigma for finding in told.findings for value in finding.values}
    assert 0.03 < sigma["steering_zero_deg"] < 0.1
