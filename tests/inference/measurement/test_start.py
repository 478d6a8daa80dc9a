"""Start pose and floor in a track's model, against paths that are turned, shifted and stepped apart from it."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement.kinds.track import (
    BY_HAND_MM,
    CREEPS,
    Starts,
    StartSpread,
    floor,
    held,
    scattered,
    settings,
    start_reservations,
)
from cadgen.inference.measurement.model import slopes
from cadgen.inference.measurement.record import join
from cadgen.inference.records.load import load
from tests.inference.measurement import synthetic_drive as drive

DEG = np.pi / 180


@pytest.fixture(scope="module")
def track(synthetic_car):
    """A car with a steering zero, four runs, hardly any noise."""
    rng = np.random.default_rng(50)
    return drive.track_record(synthetic_car, drive.Wheels(zero=0.3 * DEG), rng, noise_mm=0.01)


def _left(model, residual):
    fit = np.linalg.lstsq(model.offsets, residual, rcond=None)[0]
    return float(np.sqrt(np.mean((residual - model.offsets @ fit) ** 2))), fit.reshape(-1, 3)


@pytest.mark.parametrize("turned", [0.0, 3.0, -25.0])
def test_a_start_enters_exactly_however_far_it_is_turned(turned, track, nominal):
    place = track["x_mm"] + 1j * track["y_mm"]
    first = place[0]
    moved = first + 7.0 - 4.0j + (place - first) * np.exp(1j * turned * DEG)
    columns = {**track.columns, "x_mm": moved.real, "y_mm": moved.imag}
    model, plain = nominal.model(replace(track, columns=columns)), nominal.model(track)
    zero = next(e for e in model.catalogue if e.name == "steering zero")
    left, poses = _left(model, model.residual([(zero, np.array([0.3 * DEG]))]))
    _, before = _left(plain, plain.residual([(zero, np.array([0.3 * DEG]))]))
    assert left < 0.6  # the generator's arcs
    assert poses[:, 2] - before[:, 2] == pytest.approx(turned * DEG, abs=1e-5)
    assert np.hypot(*(poses - before)[0, :2] - (7.0, -4.0)) < 0.1
    # Slopes of an effect are those of the turned path, so that its numbers come out the same.
    steep, flat = (slopes(m, (zero,), [(zero, np.array([0.3 * DEG]))]) for m in (model, plain))
    sizes = [_left(m, s[:, 0])[0] for m, s in ((model, steep), (plain, flat))]
    assert sizes[0] == pytest.approx(sizes[1], rel=2e-3)


def test_a_remark_says_how_the_start_was_set(track):
    by_hand = settings(track)
    assert {one.place for one in by_hand} == {BY_HAND_MM}
    assert not any(one.stated for one in by_hand)
    stated = settings(replace(track, remarks=("start set to 3 mm and 0.15 deg",)))
    assert {(one.place, one.stated) for one in stated} == {(3.0, True)}
    assert stated[0].heading == pytest.approx(0.15 * DEG)
    assert settings(replace(track, remarks=("start pose set by hand",))) == by_hand


def test_a_remark_holds_for_the_runs_of_its_own_file(track, nominal):
    """Two runs at a stop and four by hand: neither takes the other's setting, nor do some of them by themselves."""
    stop = replace(track.only(np.arange(2)), remarks=("start set to 0.5 mm and 0.05 deg",))
    both = join([track, stop])
    assert [one.place for one in settings(both)] == [5.0] * 4 + [0.5] * 2
    assert [one.place for one in settings(both.only(np.array([3, 4])))] == [5.0, 0.5]
    assert [one.place for one in settings(join([both, stop]))] == [5.0] * 4 + [0.5] * 4
    model = nominal.model(both)
    # The generator sets its starts by hand, so the two scatter by more than was said, and only theirs is widened.
    assert model.stated == settings(both)
    assert model.spread.reshape(6, 3)[:4, 0] == pytest.approx([5.0] * 4)
    assert (model.spread.reshape(6, 3)[4:, 0] > 0.5).all()
    assert held(settings(both)) == (
        "held to 5 mm and 0.5°, no file says how it was set (runs 1 to 4); "
        "0.5 mm and 0.05°, as the file says (runs 5 to 6)"
    )


def test_starts_that_scatter_more_are_judged_by_their_scatter():
    rng, stated = np.random.default_rng(51), StartSpread(3.0, 0.15 * DEG, True)
    poses = rng.normal(0, [3.0, 3.0, 0.15 * DEG], (6, 3)) + np.array([50.0, 0.0, 2 * DEG])
    assert scattered(poses, (stated,) * 6) == (stated,) * 6  # what all share is an effect's
    wide = scattered(poses * (1, 1, 12), (stated,) * 6)[0]
    assert wide.place == stated.place
    assert wide.heading == pytest.approx(np.std(12 * poses[:, 2], ddof=1))
    # Runs of another file that were set loosely do not widen those at a stop.
    loose = replace(stated, place=100.0)
    mixed = scattered(np.vstack([poses, [[400.0, 0, 0]]]), (stated,) * 6 + (loose,))
    assert mixed == (stated,) * 6 + (loose,)


def test_missing_and_doubled_points_do_not_scatter_the_starts(measured, nominal):
    """A steering zero of 0.55° bends the track by metres: rows of its own in each run made 25 mm of scatter of that."""
    whole = load(measured / "track_a.csv")
    rng, rows = np.random.default_rng(5), np.arange(len(whole.run))
    stated, shown = settings(whole), nominal.model(whole).used
    assert shown == stated == (StartSpread(3.0, pytest.approx(0.15 * DEG), True),) * whole.runs
    gone, late = rng.random(len(rows)) >= 0.1, (whole.run != 1) | (whole["cam_angle_deg"] > 30.0)
    for kept in (rows[gone], rows[late], np.repeat(rows, 1 + (rng.random(len(rows)) < 0.1))):
        columns = {name: values[kept] for name, values in whole.columns.items()}
        model = nominal.model(replace(whole, columns=columns, run=whole.run[kept]))
        assert model.used == stated


def test_runs_without_a_common_stretch_have_poses_of_their_own():
    path = np.arange(24) * 50.0 + 0j
    run, motor = np.repeat([0, 1], 24), np.tile(np.arange(12.0), 4)
    motor[24:] += 12.0
    axis = np.tile(np.repeat([0, 1], 12), 2)
    place = path[motor.astype(int)]
    seen = (place - place[0]) * np.exp(0.01j) + place[0] + 3.0
    poses = Starts(run, axis, np.where(axis == 0, seen.real, seen.imag)).poses(place, motor)
    assert poses[:, 2] == pytest.approx([0.01, 0.01])
    assert poses[0, :2] == pytest.approx([3.0, 0.0], abs=1e-9)


def test_a_start_off_in_all_runs_is_said():
    stated, sigmas = StartSpread(3.0, 0.15 * DEG, True), np.full((4, 3), 1e-9)
    near = np.array([[3.0, 0, 0], [-2.0, 1, 0], [1.0, -4, 0], [0.0, 2, 0]])
    alike = (stated,) * 4
    assert start_reservations(alike, alike, near, sigmas) == ()
    (together,) = start_reservations(alike, alike, near + np.array([0, 20.0, 0]), sigmas)
    assert together.startswith("all runs start off together, by (0.5, 19.8) mm and 0.00°")
    (scatter,) = start_reservations((replace(stated, heading=0.1),) * 4, alike, near, sigmas)
    assert "not by 3 mm and 0.15°, as the file says" in scatter
    tight = replace(stated, place=0.5)
    two = (tight, *alike[1:3], tight)
    off = near.copy()
    off[[0, 3]] = (0.0, 20.0, 0.0)
    (some,) = start_reservations(two, two, off, sigmas)
    assert some.startswith("runs 1, 4 start off together, by (0.0, 20.0) mm")


def test_floor_columns_are_the_creep_of_a_car_stepped_by_hand():
    """A car on a circle of 1 m creeps by 3 mm/m along and 1 mm/m across, on a slope towards (0.6, -0.8)."""
    angle = np.linspace(0, 1.5 * np.pi, 4001)
    place = 1000 * np.exp(1j * angle)
    slope, crept = 0.6 - 0.8j, np.zeros(len(place), dtype=complex)
    for k in range(1, len(place)):
        step = place[k] - place[k - 1]
        way = step / abs(step)
        falls = (slope * way.conjugate()).real, (slope * (1j * way).conjugate()).real
        crept[k] = crept[k - 1] + abs(step) * (3e-3 * falls[0] * way + 1e-3 * falls[1] * 1j * way)
    at, axis = np.tile(np.arange(len(place)), 2), np.repeat([0, 1], len(place))
    found = floor(place, at, axis)
    amplitudes = np.array([0.6 * 3e-3, -0.8 * 3e-3, 0.6e-3, -0.8e-3])
    assert found.columns[:, :4] @ amplitudes == pytest.approx(np.append(crept.real, crept.imag), abs=1e-6)


def test_the_heading_walks_at_random():
    """The waves have the covariance of a random walk, min(s, t), and turn what follows."""
    place = np.linspace(0, 2000.0, 801) + 0j
    found = floor(place, np.arange(801), np.ones(801, dtype=int))
    sideways = (found.columns[:, len(CREEPS) :] * found.sigma[len(CREEPS) :]) / found.sigma[-1]
    # On a straight line y is the integral of the heading: its variance at s is s^3 / 3.
    assert np.sum(sideways**2, axis=1)[[200, 400, 800]] == pytest.approx(place.real[[200, 400, 800]] ** 3 / 3, rel=0.03)


def test_starts_by_hand_are_known_as_well_as_they_scatter(track, nominal):
    """Where no file says how they were set; what is usual counts as one run."""
    poses = np.column_stack([np.zeros((4, 2)), [0.5 * DEG, 0.6 * DEG, 0.4 * DEG, 0.5 * DEG]])
    shown = nominal.model(track).shown_spread(poses).reshape(4, 3)
    assert shown[:, 2] == pytest.approx(np.sqrt((0.5**2 + 0.02) / 4) * DEG)
    stated = nominal.model(replace(track, remarks=("start set to 3 mm and 0.15 deg",)))
    assert stated.shown_spread(poses) == pytest.approx(stated.spread)
