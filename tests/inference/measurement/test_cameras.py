"""Errors of the camera are said, and not claimed as those of the car; those of the car stay the car's."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.inference.measurement.diagnosis import calibrate
from tests.inference.measurement import synthetic_drive as drive
from tests.inference.measurement.synthetic import DEG

CAMERAS = {
    "scale of the camera": lambda z: z * 1.003,
    "scale of one axis of the camera": lambda z: z + 0.003 * z.real,
    "scale of the camera's other axis": lambda z: z + 0.01j * z.imag,
    "lens of the camera": lambda z: z * (1 + 0.004 * np.abs(z) ** 2),
    "perspective of the camera": lambda z: z / (1 + 0.003 * z.real),
}


def seen(car, wheels, by, seed=3):
    """Track through a camera that errs about the middle of the field; its frame is laid at the start."""
    record = drive.track_record(car, wheels, np.random.default_rng(seed), noise_mm=3.0)
    place = record["x_mm"] + 1j * record["y_mm"]
    middle = complex(place.real.min() + place.real.max(), place.imag.min() + place.imag.max()) / 2
    extent = np.abs(place - middle).max()
    shown = middle + extent * by((place - middle) / extent)
    shown += place[0] - shown[0]
    return replace(record, columns=record.columns | {"x_mm": shown.real, "y_mm": shown.imag})


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", [n if n == "scale of the camera" else pytest.param(n, marks=[pytest.mark.long]) for n in CAMERAS]
)
def test_an_error_of_the_camera_is_named_and_nothing_of_the_car(name, synthetic_car, nominal):
    (told,) = calibrate([seen(synthetic_car, drive.Wheels(), CAMERAS[name])], nominal)
    assert (told.verdict, told.judgement.claimed) == ("ambiguous", ())
    assert any(name in words for words in (told.judgement.sentence, *told.judgement.limits))
    assert any("lay a rule on the floor" in how for how in told.judgement.separate)


@pytest.mark.slow
@pytest.mark.long
def test_beside_an_error_of_the_camera_the_steering_zero_is_claimed(synthetic_car, nominal):
    record = seen(synthetic_car, drive.Wheels(zero=0.3 * DEG), lambda z: z * 1.01)
    (told,) = calibrate([record], nominal)
    assert told.judgement.claimed == ("steering zero",)
    assert "scale of the camera (camera_scale_percent 0.99" in told.judgement.sentence


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(
    ("wheels", "names"),
    [
        (drive.Wheels(radius=1.01, gain=1.02), ("lever gain", "wheel radius")),
        (drive.Wheels(radius=1.006), ("wheel radius",)),
        (drive.Wheels(gain=1.02), ("lever gain",)),
    ],
)
def test_errors_of_the_car_stay_the_cars(wheels, names, synthetic_car, nominal):
    (told,) = calibrate([seen(synthetic_car, wheels, lambda z: z)], nominal)
    assert told.judgement.claimed == names


@pytest.mark.slow
@pytest.mark.long
def test_beside_a_train_the_cameras_error_is_an_effect_and_the_car_stays_explained(synthetic_car, nominal):
    rng = np.random.default_rng(5)
    train = drive.transmission_record(synthetic_car, drive.Train(play=0.6 * DEG), rng, noise_deg=0.03)
    wheels = drive.Wheels(zero=0.3 * DEG, gain=1.02, play=0.6 * DEG)
    track, _ = told = calibrate([seen(synthetic_car, wheels, lambda z: z / (1 + 0.015 * z.imag)), train], nominal)
    assert not any(one.apart for one in told)
    assert {"backlash", "perspective of the camera", "steering zero"} <= set(track.judgement.claimed)
    numbers = {v.name: v for finding in track.findings for v in finding.values}
    assert numbers["perspective_y_percent"].value == pytest.approx(1.5, abs=0.15)
    assert numbers["steering_zero_deg"].value == pytest.approx(0.3, abs=0.03)
    assert numbers["return_error_deg"].value == pytest.approx(0.6, abs=0.02)


def test_errors_of_the_camera_do_not_move_the_car(synthetic_car, nominal):
    model = nominal.model(drive.track_record(synthetic_car, drive.Wheels(), np.random.default_rng(1), noise_mm=3.0))
    for effect in model.cameras:
        active = [(effect, effect.steps)]
        assert abs(model.place(active) - model.place([])).max() > 0.01, effect.name
        assert model.finish(active) == model.finish([])
        assert effect.instrument
