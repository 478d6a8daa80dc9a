"""Expectation of the run on a new cam: which records speak for the car's run."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.design.as_built import AsBuiltSection
from cadgen.design.load import load_design
from cadgen.deviations.catalogue import TRACK
from cadgen.inference.expectation.outlook import NextCam, Outlook, Unmeasured, new_form, outlook
from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.evidence import GRID
from cadgen.inference.measurement.findings import Likely, Unnamed
from cadgen.inference.measurement.kinds.track import KIND, run_of
from cadgen.inference.measurement.model import repeating
from cadgen.inference.measurement.verdict import Verdict
from cadgen.jobs.calibration.cam_on_car import nominal_of, planned_end
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive

PLAY = 0.95 * syn.DEG


def looked_ahead(nominal, likely, form_error=1e-9) -> Outlook:
    """Outlook on a cam like the one that is on the car, by what a track shows."""
    residual = SimpleNamespace(after=3.0, noise=3.0, left_out=None)
    track = SimpleNamespace(kind=KIND, verdict=Verdict.TRACED, apart=False, likely=(likely,), residual=residual)
    same = NextCam(nominal=replace(nominal, form_error=form_error), gone=frozenset())
    return outlook([track], nominal, same, planned_end(load_design(), nominal), Unmeasured())


def at_end(model) -> np.ndarray:
    """Last point of the planned run by each coefficient of what repeats, x + iy, mm."""
    x, y = repeating(model)[[len(model.form) // 2 - 1, -1]]
    return x + 1j * y


def moves(end: np.ndarray, by: complex) -> np.ndarray:
    """Least coefficients that move the end so far."""
    return np.linalg.lstsq(np.stack([end.real, end.imag]), [by.real, by.imag], rcond=None)[0]


def rest_of(model, values: np.ndarray, *, answer: np.ndarray | None = None, turned: complex = 1.0, grid=GRID[0]):
    """Rest without a name, known exactly, on a track that is turned and stretched against the planned one."""
    count = len(values)
    answer = np.empty((count, 0)) if answer is None else answer
    orders = model.form.shape[1]
    return Unnamed(1.0, values, np.zeros((count, count)), answer, turned * at_end(model), orders, grid)


def test_the_form_error_of_the_old_disc_is_not_on_the_new_one(nominal):
    """Of 60 mm beside all effects 10 are the car's."""
    model = run_of(nominal)
    end, orders = at_end(model), model.form.shape[1]
    values = np.concatenate([moves(end[:orders], 50.0), moves(end[orders:], 10.0)])
    expected = looked_ahead(nominal, Likely(1.0, (), np.empty((0, 0)), (), (rest_of(model, values),)))
    assert expected.old - expected.new == pytest.approx(50.0, abs=0.1)


def test_a_car_creeps_across_its_heading_on_the_new_cam_too(nominal):
    """And heads elsewhere there: the end of a track that is three times as long moved by 30 mm, and will by 10."""
    model = run_of(nominal)
    end, orders = at_end(model), model.form.shape[1]
    values = np.concatenate([np.zeros(orders), moves(end[orders:], 10.0j)])
    expected = looked_ahead(nominal, Likely(1.0, (), np.empty((0, 0)), (), (rest_of(model, values, turned=3.0j),)))
    assert expected.old == pytest.approx(30.0, abs=0.5)
    assert expected.new == pytest.approx(10.0, abs=0.5)


def test_what_an_effect_makes_more_of_the_rest_makes_less_of(nominal):
    """A wheel's radius that is not known beside a floor that creeps, both of which the measured end holds together."""
    model, sigma = run_of(nominal), 1e-3
    radius = next(e for e in TRACK.effects if e.name == "wheel radius")
    found = np.array(radius.start, dtype=float)
    end, orders = at_end(model), model.form.shape[1]
    by = (model.finish([(radius, found + sigma)]) - model.finish([(radius, found)])) / sigma
    answer = -np.concatenate([np.zeros(orders), moves(end[orders:], by)])[:, None]
    effects = ((("track", radius.name), radius, found),)
    ranges = []
    for some in (0.0 * answer, answer):
        one = rest_of(model, np.zeros(len(end)), answer=some)
        likely = Likely(1.0, effects, np.array([[sigma**2]]), (frozenset({"track"}),), (one,))
        expected = looked_ahead(nominal, likely)
        ranges.append(expected.most - expected.least)
    assert ranges[0] > sigma * abs(by)
    assert ranges[1] < 0.02 * ranges[0]


def test_the_next_disc_has_the_spectrum_of_this_one_or_any(nominal):
    """One that hardly moves the end, as seen, is no promise: every second disc is cut in another way."""
    model = run_of(nominal)
    by = np.abs(at_end(model)[: len(model.order)]) ** 2
    sizes = {s: np.sqrt(s.variance(model.order, model.floor) @ by) for s in GRID if s.within}
    least = min(sizes, key=lambda s: sizes[s])
    one = rest_of(model, np.zeros(len(at_end(model))), grid=least)
    likely = Likely(1.0, (), np.empty((0, 0)), (), (one,))
    expected = looked_ahead(nominal, likely, form_error=nominal.form_error)
    # 95 % of ends on a line lie within 1.96 of their deviation.
    assert 1.2 * 1.96 * sizes[least] < expected.most < 1.96 * max(sizes.values())
    assert expected.new < max(sizes.values()) / 2


def end_of(nominal, **numbers):
    """Distance of the end of a car's run from the planned one, mm, by the generator."""
    stop = np.array([345.0]) * syn.DEG
    off = drive.Wheels(**numbers).track(nominal, stop) - drive.Wheels().track(nominal, stop)
    return float(np.abs(off[-1]))


def driven(told, nominal, **found) -> Outlook:
    """Outlook with a cam for effects of a track, by the names of their numbers: steering zero and return error."""
    names = {"steering_zero_deg": "steering zero", "return_error_deg": "backlash"}
    effects = [
        {"effect": names[name], "kind": "track", "place": "car", "values": [{"name": name, "value": value}]}
        for name, value in found.items()
    ]
    design = load_design().model_copy(update={"as_built": AsBuiltSection.model_validate({"effects": effects})})
    new = NextCam(nominal=nominal_of(design, "optimized"), gone=frozenset())
    return outlook(told, nominal, new, planned_end(load_design(), nominal), Unmeasured())


@pytest.mark.long
@pytest.mark.slow
def test_the_play_of_a_dial_s_stand_is_not_the_train_s(synthetic_car, nominal):
    """It was, and the old cam was expected to end 208 mm off, the new one 1187; 1102 and 13 were driven."""
    rng = np.random.default_rng(3)
    bench = syn.bench_with(np.zeros(1), {"play": 0.075 * syn.DEG})
    told = calibrate(
        [
            drive.track_record(synthetic_car, drive.Wheels(play=PLAY), rng, noise_mm=3.0),
            syn.lift_record(synthetic_car, bench, rng, noise_um=4.0),
        ],
        nominal,
    )
    expected = driven(told, nominal, return_error_deg=0.95)
    assert expected.old == pytest.approx(end_of(synthetic_car.built, play=PLAY), rel=0.1)
    assert expected.new < 30.0
    assert expected.worse == 0.0
    assert expected.sound


@pytest.mark.slow
@pytest.mark.long
def test_runs_that_all_start_turned_are_a_car_that_goes_crabwise(synthetic_car, nominal):
    """By 0.5 degrees, where the starts scatter by 0.05: the end moves along, but where it is the camera's frame."""
    rng = np.random.default_rng(8)
    record = drive.track_record(synthetic_car, drive.Wheels(zero=0.2 * syn.DEG), rng, noise_mm=1.0, start_deg=0.05)
    place = record["x_mm"] + 1j * record["y_mm"]
    first = place[0]
    moved = first + (place - first) * np.exp(0.5j * syn.DEG)
    turned = replace(record, columns={**record.columns, "x_mm": moved.real, "y_mm": moved.imag})
    stop = nominal.track.length * nominal.lift.blend_start / (2 * np.pi)
    by = 0.5 * syn.DEG * abs(complex(*nominal.track.position(stop)) - complex(*nominal.track.position(0.0)))
    shares = []
    for one in (record, turned):
        likely = calibrate([one], nominal)[0].likely[0]
        ways = [(each.weight, abs(each.end @ each.values)) for each in likely.unnamed]
        shares.append(sum(weight for weight, at in ways if at > by / 2))
        print(f"{by:.0f} mm; " + ", ".join(f"{weight:.2f} {at:.1f}" for weight, at in ways))
    assert shares[0] < 0.05
    assert 0.6 < shares[1] < 0.8


def test_a_new_disc_may_have_any_spectrum(nominal):
    """A form error of a wave a turn moves the end more than one of many waves; both keep what was stated."""
    model = run_of(nominal)
    ends = np.abs(new_form(model, 4000, np.random.default_rng(1)))
    x, y = model.form[[len(model.form) // 2 - 1, -1]]
    known = [np.sqrt(s.variance(model.order, model.floor) @ (x**2 + y**2)) for s in GRID if s.within]
    assert min(known) < np.sqrt(np.mean(ends**2)) / 1.5
    assert np.sqrt(np.mean(ends**2)) == pytest.approx(np.sqrt(np.mean(np.square(known))), rel=0.05)


@pytest.mark.slow
@pytest.mark.long
def test_records_that_contradict_each_other(synthetic_car, nominal):
    """A train with less play than the track shows: the track says how the car runs, also on a cam for the train's."""
    rng = np.random.default_rng(30)
    train = drive.transmission_record(synthetic_car, drive.Train(play=0.3 * syn.DEG), rng, noise_deg=0.03)
    car = {"zero": 0.2 * syn.DEG, "play": 0.8 * syn.DEG}
    track = drive.track_record(synthetic_car, drive.Wheels(**car), rng, noise_mm=3.0)
    told = calibrate([train, track], nominal)
    assert all(diagnosis.apart for diagnosis in told)
    of_track = driven(told, nominal, steering_zero_deg=0.2, return_error_deg=0.8)
    assert of_track.contradicted
    assert of_track.sound
    assert of_track.old == pytest.approx(end_of(synthetic_car.built, **car), rel=0.1)
    assert of_track.new < 30.0
    of_both = driven(told, nominal, steering_zero_deg=0.2, return_error_deg=0.3)
    assert of_both.new > 300.0
    assert of_both.new > of_track.new
    assert not driven(told[:1], nominal, return_error_deg=0.3).sound


@pytest.mark.slow
@pytest.mark.long
def test_play_that_shows_in_a_train_alone_is_held_by_friction(synthetic_car, nominal):
    """They contradicted, when friction was thought to hold the cam while the rod was lifted, too."""
    rng = np.random.default_rng(30)
    train = drive.transmission_record(synthetic_car, drive.Train(play=0.8 * syn.DEG), rng, noise_deg=0.03)
    track = drive.track_record(synthetic_car, drive.Wheels(zero=0.2 * syn.DEG), rng, noise_mm=3.0)
    told = calibrate([train, track], nominal)
    assert not any(diagnosis.apart for diagnosis in told)
    assert set(told[1].judgement.claimed) == {"backlash", "sliding friction", "steering zero"}
