"""Expectation of the run on a new cam: which records speak for the car's run."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.design.as_built import AsBuiltSection
from cadgen.design.load import load_design
from cadgen.inference.expectation.outlook import NextCam, Outlook, Unmeasured, new_form, outlook
from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.evidence import GRID
from cadgen.inference.measurement.findings import Likely, Unnamed
from cadgen.inference.measurement.kinds.track import KIND, run_of
from cadgen.inference.measurement.verdict import Verdict
from cadgen.jobs.calibration.cam_on_car import nominal_of, planned_end
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive

PLAY = 0.95 * syn.DEG


def test_the_form_error_of_the_old_disc_is_not_on_the_new_one(nominal):
    """Of 60 mm beside all effects 10 are the car's."""
    likely = Likely(1.0, (), np.empty((0, 0)), (), (Unnamed(1.0, 60.0, 0.0, 10.0, 0.0, GRID[0]),))
    residual = SimpleNamespace(after=3.0, noise=3.0, left_out=None)
    track = SimpleNamespace(kind=KIND, verdict=Verdict.TRACED, contradicted=False, likely=(likely,), residual=residual)
    same = NextCam(nominal=replace(nominal, form_error=1e-9), gone=frozenset())
    expected = outlook([track], nominal, same, planned_end(load_design(), nominal), Unmeasured())
    assert expected.old - expected.new == pytest.approx(50.0, abs=0.1)


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
        shares.append(sum(each.weight for each in likely.unnamed if abs(each.at) > by / 2))
        print(f"{by:.0f} mm; " + ", ".join(f"{each.weight:.2f} {abs(each.at):.1f}" for each in likely.unnamed))
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
    assert all(diagnosis.contradicted for diagnosis in told)
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
    assert not any(diagnosis.contradicted for diagnosis in told)
    assert set(told[1].judgement.claimed) == {"backlash", "sliding friction", "steering zero"}
