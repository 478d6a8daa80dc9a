"""Every effect's place in the forward models against the independent generator, without noise and form error."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from cadgen.car.running.drive import drive as drive_car
from cadgen.car.running.drive import start_pose
from cadgen.deviations.effect import Effect
from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.model import Model, slopes
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive
from tests.inference.measurement.study import PRINTED, _wave, same

# What the generator's own steps leave: rod on points 0.025 mm apart, readings rounded to 1 um, and friction that turns
# one reading sooner or later at a peak.
LIFT_UM = 1.0
PROFILE_UM = 0.25
TRAIN_DEG = 0.006  # readings rounded to 0.01 degrees
TRACK_MM = 0.6  # the car's arcs and the gap's walk go in steps of 0.05 degrees


def _effect(model: Model, name: str, values: np.ndarray) -> tuple[Effect, np.ndarray]:
    """The entry of a name that fits best (which nose), with values in its printed units."""
    entries = [e for e in model.catalogue if same(name, e.name)]
    tried = [(e, np.array([p.scale for p in e.parameters]) * values) for e in entries]
    return min(tried, key=lambda t: float(np.std(model.residual([(t[0], t[1])]))))


def _left(model: Model, active: list[tuple[Effect, np.ndarray]]) -> float:
    """RMS once the datum, linear and not, is fitted."""
    residual = model.residual([*((e, e.start) for e in model.datum), *active])
    columns = model.offsets
    if model.datum:
        columns = np.hstack([columns, slopes(model, model.datum, [*((e, e.start) for e in model.datum), *active])])
    if columns.shape[1]:
        residual = residual - columns @ np.linalg.lstsq(columns, residual, rcond=None)[0]
    return float(np.sqrt(np.mean(residual**2)))


@pytest.mark.parametrize("name", sorted(syn.LIFT_TRUTHS))
def test_lift(name, synthetic_car, nominal):
    rng = np.random.default_rng(7)
    make, low, high = syn.LIFT_TRUTHS[name]
    change = make(synthetic_car, rng)(np.sqrt(low * high))
    bench = syn.bench_with(np.zeros(1), change)
    model = nominal.model(syn.lift_record(synthetic_car, bench, rng, noise_um=0.0, index_deg=0.0, runs=1))
    active = [_effect(model, name, np.array(PRINTED[name](change)))]
    assert _left(model, []) * 1e3 > 2 * LIFT_UM
    assert _left(model, active) * 1e3 < LIFT_UM


@pytest.mark.parametrize("name", sorted(syn.PROFILE_TRUTHS))
def test_profile(name, synthetic_car, nominal):
    rng = np.random.default_rng(11)
    make, low, high = syn.PROFILE_TRUTHS[name]
    change = make(synthetic_car, rng)(np.sqrt(low * high))
    bench = syn.bench_with(np.zeros(1), change)
    record = syn.profile_record(synthetic_car, bench, rng, noise_um=0.0, runs=1, clock_deg=0.0)
    model = nominal.model(record)
    active = [_effect(model, name, np.array(PRINTED[name](change)))]
    assert _left(model, []) * 1e3 > 2 * PROFILE_UM
    assert _left(model, active) * 1e3 < PROFILE_UM


@pytest.mark.parametrize("shift", [(0.0, 0.0), (0.06, -0.08)])
def test_each_run_of_a_profile_has_its_own_clocking(shift, synthetic_car, nominal):
    bench = syn.bench_with(np.zeros(1), {"shift": shift})
    record = syn.profile_record(
        synthetic_car,
        bench,
        np.random.default_rng(12),
        noise_um=0.0,
        clock_deg=0.4,
        turn=syn.TURN,
        scatter=0.4 * syn.DEG,
    )
    model = nominal.model(record)
    effect = _effect(model, "eccentric bore", np.array(shift) * 1e3)
    # What the bore shifts the clocking by is common to all runs: tenths of a degree, so found exactly.
    (datum,) = model.datum
    common = least_squares(lambda p: model.residual([(datum, p), effect]), [0.0], x_scale=1e-3).x
    left = model.residual([(datum, common), effect])
    columns = np.hstack([model.offsets, slopes(model, model.datum, [(datum, common), effect])])
    left = left - columns @ np.linalg.lstsq(columns, left, rcond=None)[0]
    assert np.sqrt(np.mean(left**2)) * 1e3 < PROFILE_UM
    clocked = np.degrees(model.own + common[0])
    # The generator's own draws: 0.4 degrees, and three times a scatter of 0.4.
    assert np.ptp(clocked) > 0.1
    assert abs(clocked.mean() - 0.4) < 1.0


@pytest.mark.parametrize("name", sorted(drive.TRAINS))
def test_transmission(name, synthetic_car, nominal):
    rng = np.random.default_rng(13)
    change = drive.TRAINS[name](rng)
    record = drive.transmission_record(synthetic_car, drive.changed(drive.Train(), change), rng, noise_deg=0.0, runs=1)
    model = nominal.model(record)
    values = _wave(change["waves"][0], 1 / syn.DEG) if "waves" in change else PRINTED[name](change)
    active = [_effect(model, name, np.array(values))]
    assert np.degrees(_left(model, [])) > 3 * TRAIN_DEG
    assert np.degrees(_left(model, active)) < TRAIN_DEG


@pytest.mark.parametrize("name", sorted(drive.CARS))
def test_track(name, synthetic_car, nominal):
    rng = np.random.default_rng(17)
    change = drive.CARS[name](rng)
    record = drive.track_record(synthetic_car, drive.changed(drive.Wheels(), change), rng, noise_mm=0.0, runs=1)
    model = nominal.model(record)
    active = [_effect(model, name, np.array(PRINTED[name](change)))]
    assert _left(model, []) > 3 * TRACK_MM
    assert _left(model, active) < TRACK_MM


def test_a_track_is_the_run_that_simulate_drives(synthetic_car, nominal):
    """One physics: the forward model's place with five effects is that of `drive` on a car with their numbers."""
    record = drive.track_record(synthetic_car, drive.Wheels(), np.random.default_rng(1), noise_mm=0.0, runs=1)
    model = nominal.model(record)
    values = {
        "backlash": 0.015,
        "steering zero": 0.01,
        "lever gain": 0.03,
        "slip with curvature": 0.02,
        "wheel radius": 0.01,
    }
    active = [(TRACK.named(name), np.array([value])) for name, value in values.items()]
    car = replace(nominal.car, steering_zero=0.01, steering_gain=1.03, slip=0.02)
    run = drive_car(
        nominal.lift, car, 1.01 * nominal.track.length, play=0.015, start=start_pose(nominal.track), steps=20_000
    )
    predicted = model.place(active)[: len(model.rows.place) // 2]
    for axis, shown in enumerate((predicted.real, predicted.imag)):
        motor = model.rows.place[: len(shown)]
        off = np.abs(shown - np.interp(motor, run.motor, run.drive_wheel[:, axis])).max()
        print(f"off by {off:.4f} mm")
        assert off < 0.05  # of the midpoint rule, as its steps are chosen


def test_every_effect_tells_how_to_separate_it(synthetic_car, nominal):
    rng = np.random.default_rng(1)
    records = [
        syn.lift_record(synthetic_car, syn.Bench(), rng, noise_um=1.0),
        syn.profile_record(synthetic_car, syn.Bench(), rng, noise_um=1.0),
        drive.transmission_record(synthetic_car, drive.Train(), rng, noise_deg=0.01),
        drive.track_record(synthetic_car, drive.Wheels(), rng, noise_mm=1.0),
    ]
    for record in records:
        catalogue = nominal.model(record).catalogue
        assert len({e.key for e in catalogue}) == len(catalogue)
        for effect in catalogue:
            lower, upper = effect.bounds
            assert effect.separated_by
            assert np.all(lower <= effect.start), effect.key
            assert np.all(effect.start <= upper), effect.key


def test_tangents_of_a_profile_are_its_differences(synthetic_car, nominal):
    """About a disc that is eccentric, too large and turned on the machine."""
    record = syn.profile_record(synthetic_car, syn.Bench(), np.random.default_rng(8), noise_um=1.0, runs=2)
    model = nominal.model(record)
    of = {effect.key: effect for effect in model.catalogue}
    state = {"eccentric bore": (0.06, -0.03), "uniform scale": (0.002,)}
    active = [(model.datum[0], np.array([0.01])), *((of[key], np.array(v)) for key, v in state.items())]
    for key in (*state, "machine-axis reversal", "axes out of square", "lobing, order 8", "waviness, order 30"):
        others = [(e, v) for e, v in active if e.key != key]
        middle = np.array(state.get(key, of[key].start))
        for number, step in enumerate(of[key].steps):
            ends = [
                model.residual([*others, (of[key], middle + by)])
                for by in np.eye(len(middle))[number] * [[-step], [step]]
            ]
            difference = (ends[0] - ends[1]) / (2 * step)
            off = model.tangent(of[key], number, active) - difference
            assert np.linalg.norm(off) < 5e-3 * np.linalg.norm(difference), key
    assert model.tangent(model.datum[0], 0, active) is None


def test_a_value_beyond_its_bound_has_slopes_of_numbers(synthetic_car, nominal):
    """A search began with a phase beyond its bound, where a mirrored track left it; the slope was 0/0 there."""
    rng = np.random.default_rng(1)
    model = nominal.model(drive.track_record(synthetic_car, drive.Wheels(), rng, noise_mm=0.0, runs=1))
    phase = next(effect for effect in model.catalogue if effect.name == "cam phase")
    low, high = (float(bound[0]) for bound in phase.bounds)
    beyond, on = (slopes(model, (phase,), [(phase, np.array([value]))]) for value in (high + 0.1 * (high - low), high))
    assert np.isfinite(beyond).all()
    assert beyond == pytest.approx(on)
